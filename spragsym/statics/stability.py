"""Type of an equilibrium by the roots λ of its linearization, with and without damping."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.arithmetic import Matrix
from ..numerics.interval_arrays import BoolArray, ComplexArray, FloatArray, Int8Array, IntArray, Shape
from ..results.equilibria import Equilibria, Stability
from . import spectrum
from .mechanics.balance import Balance
from .mechanics.state import State

#: Imaginary part of a λ that is real to floats, over its size.
REAL = 1e-9
#: Growth rate over the frequency below which a state is practically neutral.
NEUTRAL = 1e-4
#: States that are looked at together: few enough for arrays of intervals to stay in cache.
TOGETHER = 1 << 14


@dataclass(frozen=True)
class Linearized:
    """N states by the full linearization, with dampers and the slope of the friction law."""

    growth: FloatArray  #: largest real part of the λ
    sign: Int8Array  #: 1 where it is proved that something grows, −1 that nothing does, 0 where neither is
    eigenvalues: ComplexArray  #: all λ, shape (N, 2 n), by falling real part

    @property
    def damped(self) -> NDArray[np.str_]:
        """``"decays"``, ``"grows"``, or ``"neutral"`` where the rate is below :data:`NEUTRAL` of the frequency.

        That is the one of the λ of the largest real part, or the lowest one where that λ does not oscillate. Empty where no float
        holds the rate.
        """
        frequency = np.abs(self.eigenvalues.imag)
        frequency = np.where(frequency > REAL * np.abs(self.eigenvalues), frequency, np.inf)
        own = np.where(np.isfinite(frequency[:, 0]), frequency[:, 0], frequency.min(axis=1))
        neutral = np.abs(self.growth) <= NEUTRAL * np.where(np.isfinite(own), own, 0.0)
        return np.select([neutral, self.growth < 0, self.growth > 0], ["neutral", "decays", "grows"], "")


def linearized(eq: Equilibria, states: tuple[IntArray, ...], around: tuple[FloatArray, FloatArray] | None) -> Linearized:
    """The full linearization at some states, by their indices; ``around`` are boxes around all states, and around each alone.

    Source: det(λ² M + λ C + K) = 0; whether something grows by Hurwitz's determinants, see
    :mod:`spragsym.statics.spectrum`.
    """
    balance = Balance(eq.parameters.model, eq.contact)
    every = (np.broadcast_to(value[..., None], eq.stability.shape) for value in eq.parameters.broadcast(*balance.parameters))
    given = np.array([value[states] for value in every]).reshape(len(balance.parameters), states[-1].size)
    q = np.array([getattr(eq, name)[states] for name in balance.coordinates])
    if around is None:
        off = eq.error[states] * np.maximum(1.0, np.abs(q))
        with np.errstate(all="ignore"):
            ends = alone = np.nextafter(np.stack([off - q, q + off]), np.inf)
    else:
        place = np.full(eq.stability.shape, -1)
        place[eq.states] = np.arange(eq.states[0].size if eq.states else 0)
        ends, alone = (boxes[:, :, place[states]] for boxes in around)
    sign = np.where(eq.stability[states] == Stability.STABLE, 1, -1)
    undamped: NDArray[Any] = np.where(eq.marginal[states], 0, sign).astype(np.int8)
    parts = [
        _linearized(balance, *(part[..., begin : begin + TOGETHER] for part in (q, given, ends, alone, undamped)))
        for begin in range(0, max(1, undamped.size), TOGETHER)
    ]
    return Linearized(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def _linearized(
    balance: Balance, q: FloatArray, given: FloatArray, ends: FloatArray, alone: FloatArray, undamped: Int8Array
) -> tuple[FloatArray, Int8Array, ComplexArray]:
    every = _damped(balance, q, given)
    fastest = every[:, 0].real
    sign = -spectrum.decay(balance, given, ends, alone, undamped, fastest)
    # What rounding leaves is on the side that is proved.
    return np.where(sign < 0, np.minimum(fastest, 0.0), np.where(sign > 0, np.maximum(fastest, 0.0), fastest)), sign, every


def _damped(balance: Balance, states: FloatArray, given: FloatArray) -> ComplexArray:
    """All λ with dampers and the slope of the friction law, by falling real part; NaN where they are no floats."""
    with np.errstate(all="ignore"):
        every = roots(*(np.moveaxis(part, -1, 0) for part in linearization(balance, states, given)))
    return np.take_along_axis(every, np.argsort(-every.real, axis=1, kind="stable"), axis=1)


def classified(
    balance: Balance, states: FloatArray, given: FloatArray, ends: FloatArray, alone: FloatArray
) -> tuple[Int8Array, BoolArray, ComplexArray]:
    """Codes of N states, whether each is proved, see :mod:`spragsym.statics.spectrum`, and the 2 n roots without damping, floats.

    States have the shape (n, N), parameters (P, N), boxes around the states, and around each alone, (2, n, N).
    """
    n, count = states.shape
    if not count:
        return np.zeros(0, dtype=np.int8), np.zeros(0, dtype=np.bool_), np.zeros((0, 2 * n), dtype=complex)
    M, _, K = (np.moveaxis(part, -1, 0) for part in linearization(balance, states, given))
    squares = -np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)
    squares = np.take_along_axis(squares, np.argsort(-np.abs(squares), axis=1), axis=1)
    roots = np.sqrt(squares)
    return *spectrum.classified(balance, given, ends, alone), np.concatenate([roots, -roots], axis=1)


def roots(M: FloatArray, C: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots of det(λ² M + λ C + K), of matrices of shape (…, n, n); NaN where an entry is not finite."""
    n = M.shape[-1]
    zero, unit = np.zeros_like(M), np.broadcast_to(np.eye(n), M.shape)
    companion = np.block([[zero, unit], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    known = np.isfinite(companion).all(axis=(-2, -1), keepdims=True)
    out: ComplexArray = np.linalg.eigvals(np.where(known, companion, 0.0)).astype(complex)
    return np.where(known[..., 0], out, np.nan)


def frequency(roots: ComplexArray) -> float:
    """ω of the two roots λ whose sum is the nearest to 0; 0 if they are real."""
    sums = np.abs(roots[:, None] + roots[None]) + np.where(np.eye(roots.size), np.inf, 0.0)
    one = roots[np.unravel_index(sums.argmin(), sums.shape)[0]]
    return float(abs(one.imag)) if abs(one.imag) > abs(one.real) else 0.0


def linearization(balance: Balance, states: FloatArray, given: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Mass, damping and stiffness matrices at float states, each of shape (n, n, N)."""
    at = State(balance, list(states), balance.floats(given), states.shape[1:], xp=np)
    return filled(at.mass(), at.shape), filled(at.damping(), at.shape), filled(at.stiffness(), at.shape)


def with_a_zero(balance: Balance, states: FloatArray, given: FloatArray) -> int:
    """The code of one state, shape (n, 1), where one λ is 0, as at a fold: the others decide."""
    M, _, K = (part[:, :, 0] for part in linearization(balance, states, given))
    squares = np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)
    others = np.delete(squares, np.abs(squares).argmin())
    if (np.abs(others.imag) > 1e-13 * np.abs(others).max(initial=0.0)).any():
        return int(Stability.FLUTTER)
    return int(Stability.STABLE if (others.real > 0).all() else Stability.DIVERGENT)


def filled(rows: Matrix, shape: Shape) -> FloatArray:
    """A matrix of numbers and arrays as an array, each entry of one shape."""
    return np.array([[np.broadcast_to(np.asarray(entry, dtype=float), shape) for entry in row] for row in rows])
