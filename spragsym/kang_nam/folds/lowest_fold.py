"""The lowest fold: the friction below which the state of small deformation jumps at no inclination."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from ...models.parameters import Parameters
from ...numerics import balls
from ...numerics.adaptive_bits import as_floats, decided, with_enough_bits
from ...numerics.balls import Interval
from ...questions import NotInClosedForm
from ...results.lowest_ends import LowestEnd
from . import cusp_proofs, turning_proofs
from .fixed_parameters import FIXED
from .fold_enclosures import Point


def critical_friction(p: Parameters, vary: str | None = None, over: str | None = None) -> LowestEnd:
    """The closed form of :func:`spragsym.critical_friction` as friction rises at any 0 < θ₀ < π; of arrays too.

    Notes
    -----
    Source: the ledger, "The lowest fold". Candidates are the cusps, the points f = f′ = f_θ₀ = 0 with f″ < 0, whose sin θ is a
    root of a polynomial of degree 9, and the folds at θ₀ = 0; all are isolated exactly, and the least is the answer. A cusp
    counts also where it is degenerate in (θ₀, μ₀). Of several that agree to 25 digits, a cusp is named first.

    Examples
    --------
    >>> critical_friction(Parameters(kappa=0.02, alpha=0.5, sigma=2.0, beta=0.0)).kind
    'turn'
    """
    if vary not in (None, "mu0") or over not in (None, "theta0") or p.followed is not None:
        raise NotInClosedForm
    columns = np.broadcast_arrays(*(getattr(p, name) for name in FIXED))
    found = [_lowest(*map(float, point)) for point in zip(*(column.flat for column in columns), strict=True)]
    shape = columns[0].shape
    if not shape:
        return LowestEnd("mu0", "theta0", *found[0])
    parts = list(zip(*found, strict=True)) or [()] * 4
    mu0, theta0, error = (np.array(parts[place], dtype=float).reshape(shape) for place in (0, 1, 3))
    return LowestEnd("mu0", "theta0", mu0, theta0, np.array(parts[2], dtype=np.str_).reshape(shape), error)


def _lowest(*values: float) -> tuple[float, float, str, float]:
    """Friction, angle, kind and error of one point."""
    exact = tuple(map(Fraction, values))

    def attempt(bits: int) -> tuple[float, float, str, float]:
        least: tuple[Fraction, Point, str] | None = None
        for point, kind in _candidates(exact, bits):
            above = balls.ends(point.parameters[1])[1]
            if least is None or above < least[0] - abs(least[0]) / 10**25:
                least = above, point, kind
        if least is None:
            return math.inf, math.nan, "", 0.0
        (mu0, theta0), error = as_floats((least[1].parameters[1], least[1].parameters[0]))
        return mu0, theta0, least[2], error

    return with_enough_bits(40, attempt, "the lowest fold")


def _candidates(exact: tuple[Fraction, ...], bits: int) -> Iterator[tuple[Point, str]]:
    for point in cusp_proofs.cusps(exact, bits):
        if _leans_forward(point.parameters[0]) and not _negative(point.parameters[1]):
            yield point, "cusp"
    yield from ((point, "turn") for point in turning_proofs.turning_points(exact, bits))
    yield from ((point, "end") for point in turning_proofs.level_folds(exact, bits))


def _leans_forward(theta0: Interval) -> bool:
    """Whether 0 < θ₀ < π/2, of an angle in (−π, π]; exactly 0 and π are known as such."""
    if not any(balls.ends(theta0)) or decided(theta0, "θ₀ = 0 on a cusp") < 0:
        return False
    return decided(balls.pi() - 2 * theta0, "θ₀ = π/2 on a cusp") > 0


def _negative(mu0: Interval) -> bool:
    """Whether the friction of a cusp is negative; 0, that of an upright one with α = 0, is known exactly."""
    return any(balls.ends(mu0)) and decided(mu0, "μ₀ = 0 on a cusp") < 0
