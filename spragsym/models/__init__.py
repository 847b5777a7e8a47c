"""Any model on one page: what was generated from it, loaded, with its parameters."""

from .load import load
from .model import Model

__all__ = ["Model", "load"]
