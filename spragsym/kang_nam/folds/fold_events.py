"""Directions θ at which the number of folds changes or the friction of one is 0, isolated by proof in 0 < θ < π/2.

Both happen at roots of polynomials in sin θ (derived: ``fold_events``), hence in t = tan(θ/2), which Descartes' rule isolates
exactly. Between two of them the number of folds is that at one rational t, where it is counted exactly.
"""

import itertools
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np

from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray
from ...numerics import polynomials
from ...numerics.interval_arrays import IntArray
from ...numerics.polynomials import Polynomial, Root, of_sine_in_t, on_circle, real_roots
from .fixed_parameters import Fixed

#: Degrees in sin θ of what is 0 at an event.
_DEGREES, _DEGREES_WITHOUT_ALPHA = (15, 6, 6), (6, 3, 3)
#: Bits of t at an event, at first, and how far beside it directions are taken, over t.
_BITS, _BESIDE = 64, 4e-14


class Directions(NamedTuple):
    """t = tan(θ/2) in 0 < θ < π on both sides of each event, of θ = π/2, and between two neighbours.

    ``number`` is how many folds there are with 0 < θ₀ < π, of either sign of μ₀, before, between and after the ``events``.
    """

    t: FloatArray
    events: FloatArray
    number: IntArray

    def folds_at(self, t: FloatArray) -> IntArray:
        """How many folds there are in directions between the events."""
        return self.number[np.searchsorted(self.events, t)]


def fold_polynomial(c: Any, s: Any, fixed: Any) -> tuple[Any, ...]:
    """The condition for a fold at (cos θ, sin θ), a quartic in tan(θ₀/2) > 0, lowest power first."""
    e0, e1, e2, ec = _catastrophe.fold_conic(c, s, *fixed)
    return e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec


def directions(fixed: Fixed) -> Directions:
    """Those in which folds are looked for first. (θ, θ₀, μ) → (π − θ, π − θ₀, −μ) gives the events beyond π/2."""
    exact = Fixed(*map(Fraction, fixed))  # type: ignore[arg-type]  # floats taken as the rationals that they are
    found = _events(exact)
    ends = [Fraction(0), *itertools.chain(*found), Fraction(1)]
    inside = [(low + high) / 2 for low, high in zip(ends[::2], ends[1::2], strict=True)]
    number = [_number(t, exact) for t in inside]
    at = np.array([float((root.low + root.high) / 2) for root in found])
    beside = np.append(at, 1.0)
    low = np.concatenate([beside * (1 - _BESIDE), beside * (1 + _BESIDE), list(map(float, inside))])
    return Directions(np.append(low, 1 / low), np.append(at, 1 / at[::-1]), np.array(number + number[-2::-1]))


def _number(t: Fraction, exact: Fixed) -> int:
    condition = polynomials.primitive(fold_polynomial(*on_circle(t)[:2], exact))
    cauchy = 1 + max(map(abs, condition)) / Fraction(abs(condition[-1]))
    return len(real_roots(condition, Fraction(0), cauchy, 0))


def _events(exact: Fixed) -> list[Root]:
    """All events by t = tan(θ/2) in 0 < t < 1, ascending, in intervals without a common point."""
    conditions, bits = list(_without_common_roots(_conditions(exact))), _BITS
    while True:
        found = sorted(root for condition in conditions for root in real_roots(condition, Fraction(0), Fraction(1), bits))
        after = [*(root.low for root in found[1:]), Fraction(1)]
        if all(root.high < low for root, low in zip(found, after, strict=False)):
            return found
        bits *= 2


def _conditions(exact: Fixed) -> Iterator[Polynomial]:
    """Polynomials in t that are 0 at the events, and not at t = 0 and 1; multiple roots included."""
    values = cache(partial(_values, exact))  # the three have nodes in common

    def of_kind(place: int) -> Callable[[Fraction], Fraction]:
        return lambda s: values(s)[place]

    for place, degree in enumerate(_DEGREES if exact.alpha else _DEGREES_WITHOUT_ALPHA):
        in_sine = polynomials.interpolate(of_kind(place), degree, Fraction)
        if not any(in_sine):  # the same at every θ
            continue
        condition = of_sine_in_t(polynomials.primitive(in_sine))
        while sum(condition) == 0:
            condition = polynomials.without(condition, (-1, 1))
        yield condition


def _without_common_roots(conditions: Iterator[Polynomial]) -> Iterator[Polynomial]:
    """The roots, each once, and each of one polynomial only."""
    before: list[Polynomial] = []
    for condition in conditions:
        rest = polynomials.squarefree(condition)
        for other in before:
            rest = polynomials.without(rest, polynomials.common_divisor(rest, other))
        before.append(rest)
        yield rest


def _values(exact: Fixed, s: Fraction) -> tuple[Fraction, ...]:
    """What is 0 at events of each of the three kinds, in sin θ."""
    if exact.alpha:
        return tuple(_catastrophe.fold_events(s, *exact))
    return tuple(_catastrophe.fold_events_without_alpha(s, exact.kappa, exact.sigma, exact.beta))
