"""What only the article's model has, loaded as it is used."""

from .flutter import FlutterBoundary as FlutterBoundary
from .flutter import flutter_boundary as flutter_boundary
from .quartic.solver import get_backend as get_backend
from .quartic.solver import set_backend as set_backend
from .steady_sliding import LinearSprag as LinearSprag
from .steady_sliding import Surface as Surface
from .steady_sliding import linear_critical_friction as linear_critical_friction
from .steady_sliding import linear_sprag as linear_sprag
from .steady_sliding import sliding_friction as sliding_friction
from .steady_sliding import surface as surface
