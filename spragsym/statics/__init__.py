"""Equilibria: what is known of them, and how they are found for one point and for millions."""

from .backends import get_backend, set_backend
from .solver import Equilibria, Stability, count, equilibria

__all__ = ["Equilibria", "Stability", "count", "equilibria", "get_backend", "set_backend"]
