"""Any model: what was generated from its model page, loaded, with its parameters."""

from .load import load
from .model import Model

__all__ = ["Model", "load"]
