"""Classes of answers: of this room, and those beside their question in a later one, which are
loaded as they are used.
"""

from ..bifurcation.flutter import Onsets as Onsets
from ..design.certificates import Certificate as Certificate
from ..design.jumps import JumpGradient as JumpGradient
from ..design.margins import JumpMargin as JumpMargin
from ..design.margins import Redesign as Redesign
from ..design.probability import JumpProbability as JumpProbability
from ..display import Column as Column
from ..matrices.answers import MatrixOnsets as MatrixOnsets
from ..matrices.answers import Modes as Modes
from ..motion import Events as Events
from ..motion import Outcome as Outcome
from ..motion import Trajectory as Trajectory
from ..motion.sweeps import Basin as Basin
from ..motion.sweeps import Sensitivity as Sensitivity
from ..motion.sweeps import Sweep as Sweep
from ..orbits import BasinBoundary as BasinBoundary
from ..orbits import Cycle as Cycle
from ..orbits import CycleBranch as CycleBranch
from ..orbits import CycleEvent as CycleEvent
from ..orbits import EventCurve as EventCurve
from ..orbits import Fate as Fate
from ..orbits import FateBoundary as FateBoundary
from ..orbits import FateMap as FateMap
from ..orbits import Lyapunov as Lyapunov
from ..orbits.diagram import Diagram as Diagram
from ..papers import PaperCheck as PaperCheck
from ..report.reports import Report as Report
from .equilibria import Equilibria as Equilibria
from .equilibria import EquilibriumType as EquilibriumType
from .equilibria import Undecided as Undecided
from .points import BifurcationSet as BifurcationSet
from .points import CriticalLoad as CriticalLoad
from .points import Curve as Curve
from .points import Jump as Jump
from .points import Path as Path
from .points import Points as Points
from .points import StickingStates as StickingStates
from .result import InUnits as InUnits
from .result import Named as Named
from .result import Result as Result
from .result import Rows as Rows
