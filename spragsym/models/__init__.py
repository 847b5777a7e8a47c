"""Any model on one page: what was generated from it, loaded, with its parameters."""

from .load import load
from .model import Model
from .planes import onset_curves

__all__ = ["Model", "load", "onset_curves"]
