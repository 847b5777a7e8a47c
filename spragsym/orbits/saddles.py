"""Saddles: equilibria and cycles that repel in exactly one direction."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..models.parameters import FloatArray
from .orbit import Cycle
from .system import System

#: Of a matrix of the motion about an equilibrium: relative error, with a margin.
ROUNDING = 1e-13


@dataclass(frozen=True)
class Saddle:
    """An equilibrium with one real direction of growth, and no other that is proved.

    ``direction`` and ``measure`` are right and left eigenvectors of the eigenvalue ``growth``, the product of which is 1:
    ``measure @ (state − saddle)`` grows as exp(growth τ). ``attracts`` is that all others are proved to have negative real parts.
    """

    state: FloatArray
    growth: float
    direction: FloatArray
    measure: FloatArray
    attracts: bool


def rounding_of(matrix: FloatArray) -> float:
    """What rounding may add to a real part of an eigenvalue of a matrix of well separated eigenvalues."""
    return float(ROUNDING * max(1.0, np.abs(matrix).max()))


def saddle_near(system: System, state: FloatArray) -> Saddle | None:
    """The saddle near a state; None where the equilibrium there has no direction of growth, or several."""
    place = system.equilibrium(state)
    eigenvalues, vectors, error = _spectrum(system.linearization(place))
    growing = np.flatnonzero(eigenvalues.real > error)
    if len(growing) != 1 or abs(eigenvalues[growing[0]].imag) > 0:
        return None
    which = int(growing[0])
    left = np.linalg.inv(vectors)[which].real
    right = vectors[:, which].real
    size = float(np.linalg.norm(right))
    attracts = bool((np.delete(eigenvalues.real + error, which) < 0).all())
    return Saddle(place, float(eigenvalues[which].real), right / size, left * size, attracts)


def decay_at(system: System, state: FloatArray) -> float:
    """−max Re λ of an equilibrium; 0 unless it is proved to attract."""
    eigenvalues, _, error = _spectrum(system.linearization(state))
    return float(-eigenvalues.real.max()) if (eigenvalues.real + error < 0).all() else 0.0


def _spectrum(matrix: FloatArray) -> tuple[Any, Any, FloatArray]:
    """Eigenvalues with their vectors and errors: by how much more than the matrix each moves; infinite for a double one."""
    eigenvalues, vectors = np.linalg.eig(matrix)
    try:
        moves = np.linalg.norm(np.linalg.inv(vectors), axis=1) * np.linalg.norm(vectors, axis=0)
    except np.linalg.LinAlgError:
        moves = np.full(len(vectors), np.inf)
    return eigenvalues, vectors, np.asarray(rounding_of(matrix) * moves)


def growth_of_cycle(cycle: Cycle) -> float | None:
    """ln μ / T of the one multiplier beyond the unit circle; None unless it is proved that there is one, and one only."""
    sizes, error = np.abs(cycle.multipliers[1:]), cycle.multiplier_errors
    which = int(np.argmax(sizes))
    if not sizes[which] - error[which] > 1 or not (np.delete(sizes + error, which) < 1).all():
        return None
    return float(np.log(sizes[which]) / cycle.period)
