"""Curves in the plane of θ₀ and μ₀: all their points at each of many directions θ of the spring, and neighbours joined.

At a given θ friction is eliminated from the conditions of a fold, or of an onset of flutter, and what is left is a polynomial in
tan(θ₀/2), whose positive roots are all points of the curves there. Between two neighbouring θ with the same number of roots the
k-th belongs to the k-th. Where their number changes, or one enters at θ₀ = 0 or π, more θ are put in between until the place is
known to rounding. Directions are t = tan(θ/2), which is precise at both ends.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...bifurcation.tubes import ByColumn
from ...models.parameters import FloatArray
from ...numerics.chains import link, walked
from ...numerics.interval_arrays import BoolArray, IntArray
from ...numerics.polynomials import by_power, eigenvalues, evaluate, on_circle, polished
from .fixed_parameters import Fixed

#: A step in θ₀, radians, over which neighbours are not joined where their number changes.
_STEP = 0.05
#: Relative width of a cell of t that is not halved any more.
_FINEST = 1e-10
#: Largest residual of a root that rounding alone can leave, over the polynomial with every term made positive.
_RESIDUAL = 1e-13
#: Friction that is taken for 0, and tan(θ₀/2) that is.
_NONE, _NEAR = 1e-11, 1e-12


class Condition(NamedTuple):
    """What holds on a curve: coefficients in tan(θ₀/2), lowest power first, at cos θ, sin θ, and friction at θ₀ there.

    ``number`` is how many positive roots there are at tan(θ/2), where that is known; else those count that are real to rounding.
    """

    polynomial: Callable[[FloatArray, FloatArray, Fixed], tuple[FloatArray, ...]]
    friction: Callable[[FloatArray, FloatArray, FloatArray, Fixed], FloatArray]
    number: Callable[[FloatArray], IntArray] | None = None


@dataclass(frozen=True)
class _Columns(ByColumn):
    """All points at each t: θ₀ ascending, NaN where there are no more, and friction."""

    t: FloatArray
    theta0: FloatArray
    mu0: FloatArray

    @classmethod
    def at(cls, t: FloatArray, condition: Condition, fixed: Fixed) -> _Columns:
        c, s, _ = on_circle(t)
        coefficients = np.stack(np.broadcast_arrays(*condition.polynomial(c, s, fixed)), axis=-1)
        coefficients /= np.abs(coefficients).max(axis=-1, keepdims=True)
        theta0 = 2 * np.arctan(_positive_roots(coefficients, condition.number and condition.number(t))).T
        return cls(t, theta0, condition.friction(c, s, theta0, fixed))

    def goes_on(self, other: _Columns, step: float) -> BoolArray:
        """Whether there are as many points, and with μ₀ ≥ 0 none is farther than a step in θ₀/π or μ₀/(1 + μ₀)."""
        one, two = (np.stack([it.theta0 / np.pi, 1 / (1 + np.abs(it.mu0))]) for it in (self, other))
        far = (np.abs(one - two) > step).any(axis=0) & ((self.mu0 >= 0) | (other.mu0 >= 0))
        as_many: BoolArray = (np.isnan(self.theta0) == np.isnan(other.theta0)).all(axis=0)
        return as_many & ~far.any(axis=0)


def _positive_roots(coefficients: FloatArray, number: IntArray | None) -> FloatArray:
    """Positive roots of each polynomial, ascending, to rounding, as many as there are; NaN behind them."""
    roots = eigenvalues(coefficients)
    if number is None:
        # LAPACK gives the complex ones in pairs, and those that are real with the imaginary part 0.
        inside = (roots.imag == 0) & (roots.real > _NEAR) & (roots.real < 1 / _NEAR)
    else:
        # Rounding moves roots off the real axis, and below 0: those that lie closest to where they must are the ones. It also
        # moves two that are all but one onto it: of those that lie there the ones that are farthest from others are.
        off = np.hypot(roots.imag, np.minimum(roots.real, 0.0)) / (1e-300 + np.abs(roots))
        gap = np.partition(np.abs(roots[..., None] - roots[:, None]), 1, axis=-1)[..., 1]
        inside = np.lexsort((-gap, off)).argsort(axis=-1) < number[:, None]
    real = polished(coefficients, np.sort(np.where(inside, roots.real, np.nan), axis=-1))
    if number is not None:
        return np.maximum(real, 0.0)
    residual = np.abs(evaluate(by_power(coefficients), real)) / evaluate(by_power(np.abs(coefficients)), real)
    return np.sort(np.where(residual < _RESIDUAL, real, np.nan), axis=-1)


def curves(condition: Condition, fixed: Fixed, t: FloatArray, step: float) -> Iterator[FloatArray]:
    """Curves with μ₀ ≥ 0, each of shape (3, points): t, θ₀ and μ₀ in order along it; no step is longer than ``step``.

    Those out of contact are included, and what is sought at ``t`` first.
    """
    with np.errstate(all="ignore"):
        columns = _Columns.at(np.unique(t), condition, fixed)
        while True:
            before, after = columns[:-1], columns[1:]
            open_ = ~before.goes_on(after, step) & (after.t > before.t * (1 + _FINEST))
            if not open_.any():
                break
            columns = columns.then(_Columns.at(np.sqrt(before.t * after.t)[open_], condition, fixed))
            columns = columns[np.argsort(columns.t)]
        there = np.isfinite(columns.mu0) & (columns.mu0 >= -_NONE)
    number = np.where(there, np.cumsum(there).reshape(there.shape) - 1, -1)
    points = np.stack([np.broadcast_to(columns.t, there.shape), columns.theta0, np.maximum(columns.mu0, 0.0)])[:, there]
    for chain in walked(_links(columns, number, step)):
        if chain.size > 1:
            yield points[:, chain]


def _links(columns: _Columns, number: IntArray, step: float) -> list[set[int]]:
    """Neighbours of each point: in the next θ, and two that vanish or are born together."""
    links: list[set[int]] = [set() for _ in range(number.max(initial=-1) + 1)]
    on = columns[:-1].goes_on(columns[1:], step)
    same = (number[:, :-1] >= 0) & (number[:, 1:] >= 0) & on
    link(links, zip(number[:, :-1][same].tolist(), number[:, 1:][same].tolist(), strict=True))
    for place in np.flatnonzero(~on):
        rows = [number[:, k] >= 0 for k in (place, place + 1)]
        (before, first), (after, second) = (
            (columns.theta0[some, place + k], number[some, place + k].tolist()) for k, some in enumerate(rows)
        )
        found = _nearest(before, after)
        link(links, ((first[one], second[other]) for one, other in found.items()))
        link(links, ((first[one], first[other]) for one, other in _couples(before, set(found))))
        link(links, ((second[one], second[other]) for one, other in _couples(after, set(found.values()))))
    return links


def _nearest(before: FloatArray, after: FloatArray) -> dict[int, int]:
    """Which root of a direction continues as which of the next, where their number changes."""
    from scipy.optimize import linear_sum_assignment

    far = np.abs(before[:, None] - after)
    return {int(one): int(other) for one, other in zip(*linear_sum_assignment(far), strict=True) if far[one, other] < _STEP}


def _couples(theta0: FloatArray, linked: set[int]) -> list[tuple[int, int]]:
    """Neighbours without a link that meet between two directions, and not at θ₀ = 0 or π."""
    free = [place for place in range(theta0.size) if place not in linked]
    found = []
    while len(free) > 1:
        gaps = np.diff(theta0[free])
        nearest = int(np.argmin(gaps))
        if gaps[nearest] > _STEP:
            break
        found.append((free.pop(nearest), free.pop(nearest)))
    return found
