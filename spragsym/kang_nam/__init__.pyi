"""What only the article's model has, loaded as it is used."""

from .folds.equilibrium_surface import Surface as Surface
from .folds.equilibrium_surface import surface as surface
from .folds.flutter_points import FlutterBoundary as FlutterBoundary
from .folds.flutter_points import flutter_boundary as flutter_boundary
from .folds.linear import LinearSprag as LinearSprag
from .folds.linear import linear_critical_friction as linear_critical_friction
from .folds.linear import linear_sprag as linear_sprag
from .folds.sliding import sliding_friction as sliding_friction
