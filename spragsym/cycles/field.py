"""What the search for cycles knows of a model: the field of its motion (:mod:`spragsym.dynamics.field`)."""

from ..dynamics.field import GAP, Border, Field, Mode

__all__ = ["GAP", "Border", "Field", "Mode"]
