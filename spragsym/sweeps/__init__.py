"""Many motions: over parameters and initial states, on all cores, resumable, and the files that hold them."""

from .many import Basin, Regime, Sensitivity, Sweep, basin, rms_sweep, sensitivity

__all__ = ["Basin", "Regime", "Sensitivity", "Sweep", "basin", "rms_sweep", "sensitivity"]
