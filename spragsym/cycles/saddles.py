"""Equilibria of a field that repel in one direction: where they are, and on which side of its stable manifold a motion passes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..dynamics.field import Field
from ..dynamics.passage import Fly
from ..errors import ConvergenceError
from ..parameters import FloatArray

#: A real part beyond this, against the largest rate, is growth that decides a motion's fate.
GROWS = 1e-2


@dataclass(frozen=True)
class Saddle:
    """An equilibrium with one real direction of growth.

    Attributes
    ----------
    state : ndarray, shape (m,)
    growth : float
        Its one large eigenvalue.
    direction, measure : ndarray, shape (m,)
        Right and left eigenvectors of that, the product of which is 1: ``measure @ (state − saddle)`` grows as exp(growth τ).
    """

    state: FloatArray
    growth: float
    direction: FloatArray
    measure: FloatArray


def equilibrium_near(field: Field, values: Sequence[float], state: FloatArray) -> FloatArray:
    """The equilibrium that Newton's method finds from a state."""
    constants, n, q = field.constants(values), len(field.coordinates), np.array(state[: len(field.coordinates)], dtype=float)
    for _ in range(40):
        whole = [*q.tolist(), *[0.0] * n]
        mode = field.initial_mode(whole, constants)
        force = np.array(field.acceleration(whole, constants, mode, math))
        stiffness = np.array(field.jacobian(whole, constants, mode, math), dtype=float)[:, :n]
        try:
            step = np.linalg.solve(stiffness, -force)
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("there is no equilibrium near") from error
        q = q + step
        if not np.abs(q).max() < 1e6:
            break
        if np.abs(step).max() < 1e-15 * (1 + np.abs(q).max()):
            return np.concatenate([q, np.zeros(n)])
    if np.abs(step).max() < 1e-12:
        return np.concatenate([q, np.zeros(n)])
    raise ConvergenceError("there is no equilibrium near")


def linearization(field: Field, values: Sequence[float], state: FloatArray) -> FloatArray:
    """The matrix of the motion about an equilibrium, shape (m, m)."""
    constants, n = field.constants(values), len(field.coordinates)
    numbers = state.tolist()
    lower = np.array(field.jacobian(numbers, constants, field.initial_mode(numbers, constants), math), dtype=float)
    return np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), lower])


def saddle_near(field: Field, values: Sequence[float], state: FloatArray) -> Saddle | None:
    """The saddle near a state; None where the equilibrium there has no such direction, or several."""
    place = equilibrium_near(field, values, state)
    matrix = linearization(field, values, place)
    eigenvalues, vectors = np.linalg.eig(matrix)
    growing = np.flatnonzero(eigenvalues.real > GROWS * np.abs(eigenvalues).max())
    if len(growing) != 1 or abs(eigenvalues[growing[0]].imag) > 0:
        return None
    which = int(growing[0])
    left = np.linalg.inv(vectors)[which].real
    right = vectors[:, which].real
    size = float(np.linalg.norm(right))
    return Saddle(place, float(eigenvalues[which].real), right / size, left * size)


def side(
    field: Field, fly: Fly, values: tuple[float, ...], start: FloatArray, duration: float, saddle: Saddle
) -> tuple[float, FloatArray]:  # fmt: skip
    """How far a motion has come along the direction of growth after a while, and the derivative of that by its start."""
    none = np.zeros((2, len(field.parameters)))
    passage = fly(start, field.constants(values), duration, none)
    return float(saddle.measure @ (passage.state - saddle.state)), saddle.measure @ passage.by_state
