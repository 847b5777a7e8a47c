"""Type of an equilibrium by the roots λ of its linearization, with and without damping."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..exact.interval_arrays import FloatArray
from ..statics.solver import Stability
from . import spectrum
from .balance import Balance
from .forces import undecorated


@dataclass(frozen=True)
class Types:
    """Of N states: codes, whether each is proved, and the 2 n roots without damping."""

    stability: NDArray[np.int8]
    proved: NDArray[np.bool_]
    eigenvalues: NDArray[np.complex128]


@dataclass(frozen=True)
class Damped:
    """The full linearization of N states, with dampers and the slope of the friction law, when it is asked for.

    ``states`` of shape (n, N), ``given`` of shape (P, N), ``ends`` and ``alone`` of shape (2, n, N): boxes around the states, and
    around each alone; ``types`` without it.
    """

    balance: Balance
    states: FloatArray
    given: FloatArray
    ends: FloatArray
    alone: FloatArray
    types: Types

    def fastest(self) -> NDArray[np.complex128]:
        """The λ with the largest real part, with an imaginary part that is not negative."""
        if not self.states.shape[1]:
            return np.zeros(0, dtype=complex)
        M, C, K = (np.moveaxis(part, -1, 0) for part in linearization(self.balance, self.states, self.given))
        every = roots(M, C, K)
        first = np.take_along_axis(every, every.real.argmax(axis=1)[:, None], axis=1)[:, 0]
        out: NDArray[np.complex128] = first.real + 1j * np.abs(first.imag)
        return out

    def decay(self) -> NDArray[np.int8]:
        """1 where it is proved that nothing grows, −1 that something does, 0 where it is not known."""
        undamped = self.types.proved & (self.types.stability == Stability.STABLE)
        return spectrum.decay(self.balance, self.given, self.ends, self.alone, undamped)


def classified(balance: Balance, states: FloatArray, given: FloatArray, ends: FloatArray, alone: FloatArray) -> Types:
    """States of shape (n, N), parameters of shape (P, N), and boxes of shape (2, n, N): around the states, and around each alone.

    Codes are by signs that are proved, see :mod:`spragsym.models.spectrum`; roots are floats.
    """
    n, count = states.shape
    if not count:
        return Types(np.zeros(0, dtype=np.int8), np.zeros(0, dtype=np.bool_), np.zeros((0, 2 * n), dtype=complex))
    M, _, K = (np.moveaxis(part, -1, 0) for part in linearization(balance, states, given))
    squares = -np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)
    squares = np.take_along_axis(squares, np.argsort(-np.abs(squares), axis=1), axis=1)
    roots = np.sqrt(squares)
    code, proved = spectrum.classified(balance, given, ends, alone)
    return Types(code, proved, np.concatenate([roots, -roots], axis=1))


def roots(M: FloatArray, C: FloatArray, K: FloatArray) -> NDArray[np.complex128]:
    """The roots of det(λ² M + λ C + K), of matrices of shape (…, n, n)."""
    n = M.shape[-1]
    zero, unit = np.zeros_like(M), np.broadcast_to(np.eye(n), M.shape)
    companion = np.block([[zero, unit], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    out: NDArray[np.complex128] = np.linalg.eigvals(companion).astype(complex)
    return out


def linearization(balance: Balance, states: FloatArray, given: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Mass, damping and stiffness matrices at float states, each of shape (n, n, N)."""
    shape = states.shape[1:]
    values: dict[str, Any] = {}
    for name, value in zip(balance.parameters, given, strict=True):
        if name in balance.angles:
            cosine, sine = balance.angles[name]
            values |= {cosine: np.cos(value), sine: np.sin(value)}
        values[name] = value
    q = list(states)
    model = balance.model
    motion = [values[name] for name in model.about["arguments"]["motion"]]
    directions = balance.plain_directions(q, values, np)
    mass = undecorated(model.linearization.mass_matrix)(*q, *motion, xp=np)
    damping = undecorated(model.linearization.damping)(*q, *directions[: 3 * balance.springs], *motion, balance.pushing, xp=np)
    return (
        _filled(mass, shape),
        _filled(damping, shape),
        _filled(balance.by_coordinate("forces_jacobian", q, directions, values, np), shape),
    )


def _filled(rows: Sequence[Sequence[Any]], shape: tuple[int, ...]) -> FloatArray:
    return np.array([[np.broadcast_to(np.asarray(entry, dtype=float), shape) for entry in row] for row in rows])
