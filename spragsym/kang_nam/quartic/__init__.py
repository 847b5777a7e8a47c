"""Equilibria in closed form: the roots of the quartic, for one point and for millions."""

from .backends import get_backend, set_backend
from .solver import count, equilibria

__all__ = ["count", "equilibria", "get_backend", "set_backend"]
