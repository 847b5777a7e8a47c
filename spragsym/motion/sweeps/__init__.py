"""Many motions over parameters and initial states: sweeps, basins, sensitivity of the jump."""

from ..regimes import Regime
from .basins import Basin, basin
from .jumps import Sensitivity, sensitivity
from .many import Sweep, rms_sweep
from .workers import Workers

__all__ = [
    "Basin",
    "Regime",
    "Sensitivity",
    "Sweep",
    "Workers",
    "basin",
    "rms_sweep",
    "sensitivity",
]
