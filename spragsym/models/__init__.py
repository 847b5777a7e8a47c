"""Any model on one page: what was generated from it, loaded, with its parameters."""

from .diagram import Diagram, diagram
from .load import load
from .model import Model
from .planes import onset_curves

__all__ = ["Diagram", "Model", "diagram", "load", "onset_curves"]
