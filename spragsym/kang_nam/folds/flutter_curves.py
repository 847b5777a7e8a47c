"""Curves of flutter onsets in the plane of θ₀ and μ₀: all onsets at each of many θ, and neighbours joined.

At a given direction θ friction is eliminated, and the onsets are the positive roots of a sextic in u = tan(θ₀/2) (derived:
``flutter_cubic``), for α = 0 as well. Between two neighbouring θ with the same number of roots the k-th belongs to the k-th.
Where their number changes, or one enters at θ₀ = 0 or π, more θ are put in between until the place is known to rounding.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ...generated import stability as _stability
from ...models.parameters import FloatArray
from ...numerics.chains import link, walked
from ...numerics.companion_roots import by_power, eigenvalues, polished
from ...numerics.polynomials import evaluate
from .fixed_parameters import Fixed

#: Flutter needs π/2 < θ < π. How close to both ends the sampled θ come.
_NEAREST = 1e-9
#: A step in θ₀, radians, over which neighbours are not joined unseen.
_STEP = 0.05
#: Width of a cell of θ that is not halved any more.
_FINEST = 1e-13
#: Largest residual of a root that rounding alone can leave, over the sextic with every term made positive.
_RESIDUAL = 1e-13


@dataclass(frozen=True)
class _Column:
    """All onsets at one θ: θ₀ ascending, and the signs of what vanishes where one enters at θ₀ = 0 or π."""

    theta: float
    theta0: FloatArray
    ends: tuple[float, float]


def curves(fixed: Fixed, n: int) -> list[FloatArray]:
    """Curves of onsets, those out of contact included, each of shape (2, points): θ and θ₀ in order along it."""
    with np.errstate(all="ignore"):
        columns = _columns(_spread(n), fixed)
        pairs = list(itertools.pairwise(columns))
        while pairs:
            middles = [0.5 * (one.theta + other.theta) for one, other in pairs if not _settled(one, other)]
            fresh = _columns(np.array(middles), fixed) if middles else []
            halves = {column.theta: column for column in fresh}
            columns += fresh
            pairs = [
                half
                for one, other in pairs
                if (middle := halves.get(0.5 * (one.theta + other.theta))) is not None
                for half in ((one, middle), (middle, other))
            ]
    return _joined(sorted(columns, key=lambda column: column.theta))


def _spread(n: int) -> FloatArray:
    """Half of the θ evenly, a quarter of them towards each end in ever smaller steps."""
    width = 0.5 * np.pi
    inner = np.linspace(0, width, n // 2 + 2)[1:-1]
    towards = np.geomspace(_NEAREST, 0.5 * width, max(n // 4, 2))
    return np.unique(np.concatenate([width + inner, width + towards, np.pi - towards]))


def sextics(theta: FloatArray, fixed: Fixed) -> FloatArray:
    """Coefficients in u = tan(θ₀/2) at each θ, lowest power first, the largest of size 1."""
    g0, g1, k0, k1, k2, k3 = _stability.flutter_cubic(np.cos(theta), np.sin(theta), *fixed)
    coefficients = np.stack([
        g0 - k0, 2 * (g1 - k1), g0 - 3 * k0 - 4 * k2, -4 * k1 - 8 * k3, -g0 - 3 * k0 - 4 * k2, -2 * (g1 + k1), -g0 - k0,
    ], axis=-1)  # fmt: skip
    return coefficients / np.abs(coefficients).max(axis=-1, keepdims=True)  # type: ignore[no-any-return]  # NumPy gives Any


def _columns(theta: FloatArray, fixed: Fixed) -> list[_Column]:
    coefficients = sextics(theta, fixed)
    angles = [np.sort(2 * np.arctan(row[np.isfinite(row)])) for row in positive_roots(coefficients)]
    return [
        _Column(float(at), row, (float(np.sign(ends[0])), float(np.sign(ends[-1]))))
        for at, row, ends in zip(theta, angles, coefficients, strict=True)
    ]


def positive_roots(coefficients: FloatArray) -> FloatArray:
    """Positive roots of each polynomial, lowest power first, to rounding; NaN for the others."""
    roots = eigenvalues(coefficients)
    # LAPACK gives the complex ones in pairs, and those that are real with the imaginary part 0.
    real = polished(coefficients, np.sort(np.where((roots.imag == 0) & (roots.real > 0), roots.real, np.nan), axis=-1))
    residual = np.abs(evaluate(by_power(coefficients), real)) / evaluate(by_power(np.abs(coefficients)), real)
    return np.where(residual < _RESIDUAL, real, np.nan)


def _settled(one: _Column, other: _Column) -> bool:
    """Whether the k-th root of one continues as the k-th of the other, or the two are too close to tell."""
    if other.theta - one.theta < _FINEST:
        return True
    return _same_kind(one, other) and bool((np.abs(one.theta0 - other.theta0) < _STEP).all())


def _joined(columns: list[_Column]) -> list[FloatArray]:
    """Join the roots of neighbouring θ, and two that vanish or are born together."""
    points = np.array([(column.theta, angle) for column in columns for angle in column.theta0]).reshape(-1, 2).T
    links: list[set[int]] = [set() for _ in points.T]
    begin = 0
    for before, column in itertools.pairwise(columns):
        here = begin + before.theta0.size
        found = _links(before, column)
        link(links, ((here + one, begin + other) for one, other in found.items()))
        link(links, ((begin + one, begin + other) for one, other in _couples(before.theta0, set(found.values()))))
        link(links, ((here + one, here + other) for one, other in _couples(column.theta0, set(found))))
        begin = here
    return [points[:, chain] for chain in walked(links)]


def _links(before: _Column, column: _Column) -> dict[int, int]:
    """Which root in one column continues which root in the next."""
    from scipy.optimize import linear_sum_assignment

    far = np.abs(column.theta0[:, None] - before.theta0)
    rows, places = np.diag_indices(len(far)) if _same_kind(before, column) else linear_sum_assignment(far)
    return {int(row): int(place) for row, place in zip(rows, places, strict=True) if far[row, place] < _STEP}


def _same_kind(before: _Column, column: _Column) -> bool:
    return before.ends == column.ends and before.theta0.size == column.theta0.size


def _couples(theta0: FloatArray, linked: set[int]) -> list[tuple[int, int]]:
    """Neighbours without a link that meet between two columns, and not at θ₀ = 0 or π."""
    free = [place for place in range(theta0.size) if place not in linked]
    found = []
    while len(free) > 1:
        gaps = np.diff(theta0[free])
        nearest = int(np.argmin(gaps))
        if gaps[nearest] > _STEP:
            break
        found.append((free.pop(nearest), free.pop(nearest)))
    return found
