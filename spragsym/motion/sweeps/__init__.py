"""Many motions: over parameters and initial states, on all cores, resumable, and the files that hold them."""

from ..regimes import Regime
from .basins import Basin, basin
from .jumps import Sensitivity, sensitivity
from .many import rms_sweep
from .result import Sweep
from .workers import Workers

__all__ = ["Basin", "Regime", "Sensitivity", "Sweep", "Workers", "basin", "rms_sweep", "sensitivity"]
