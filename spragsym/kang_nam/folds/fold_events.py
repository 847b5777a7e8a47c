"""Directions θ at which the number of folds changes or the friction of one is 0, isolated by proof in 0 < θ < π/2.

Both happen at roots of polynomials in sin θ (derived: ``fold_events``), hence in t = tan(θ/2), which Descartes' rule isolates
exactly. Between two of them the number of folds is that at one rational t, where it is counted exactly.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache, partial
from typing import Any, NamedTuple

from ...generated import catastrophe as _catastrophe
from ...numerics import balls, polynomials
from ...numerics.descartes import Root, real_roots
from ...numerics.half_angle import of_sine_in_t, on_circle
from ...numerics.polynomials import Polynomial
from .fixed_parameters import Fixed

#: Degrees in sin θ of what is 0 at an event.
_DEGREES, _DEGREES_WITHOUT_ALPHA = (15, 6, 6), (6, 3, 3)
#: Bits of the first try to tell events apart.
_BITS = 64


class Stretch(NamedTuple):
    """Directions θ between two events, with ``inside`` one of them; the first begins at 0 and the last ends at π/2.

    ``number`` is how many folds there are with 0 < θ₀ < π; one passes 0 where the sign ``at_zero`` changes, and π where
    ``at_end`` does. For α = 0, where θ₀ and π − θ₀ are folds together, it is those with θ₀ < π/2, and the other end is π/2.
    """

    low: float
    high: float
    inside: float
    number: int
    at_zero: int
    at_end: int


def fold_polynomial(theta: tuple[Any, Any], fixed: Any) -> tuple[Any, ...]:
    """The condition for a fold at (cos θ, sin θ): a quartic in tan(θ₀/2) > 0, but for α = 0 a quadratic in sin θ₀ < 1."""
    e0, e1, e2, ec = _catastrophe.fold_conic(*theta, *fixed)
    return (e0, e1, e2) if fixed.alpha == 0 else (e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec)


def stretches(fixed: Fixed) -> list[Stretch]:
    """All of 0 < θ < π/2, in order."""
    exact = Fixed(*map(Fraction, fixed))  # type: ignore[arg-type]  # floats taken as the rationals that they are
    ends = [Fraction(0), *itertools.chain(*_events(exact)), Fraction(1)]
    return [_stretch(low, high, exact) for low, high in zip(ends[::2], ends[1::2], strict=True)]


def _stretch(low: Fraction, high: Fraction, exact: Fixed) -> Stretch:
    """Between the values of t at which two neighbouring events are isolated."""
    inside = (low + high) / 2
    c, s, _ = on_circle(inside)
    condition = polynomials.primitive(fold_polynomial((c, s), exact))
    limit = 1 + max(map(abs, condition)) / Fraction(abs(condition[-1])) if exact.alpha else Fraction(1)  # the former is Cauchy's
    number = len(real_roots(condition, Fraction(0), limit, 0))
    at_zero, at_end = condition[0], condition[-1] if exact.alpha else sum(condition)
    begin, middle, end = (2 * math.atan(t) for t in (low, inside, high))
    return Stretch(begin, end, middle, number, balls.sign(at_zero), balls.sign(at_end))


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


def _values(exact: Fixed, s: Fraction) -> tuple[Fraction, ...]:
    """What is 0 at events of each of the three kinds, in sin θ."""
    if exact.alpha:
        return tuple(_catastrophe.fold_events(s, *exact))
    return tuple(_catastrophe.fold_events_without_alpha(s, exact.kappa, exact.sigma, exact.beta))


def _without_common_roots(conditions: Iterator[Polynomial]) -> Iterator[Polynomial]:
    """The roots, each once, and each of one polynomial only."""
    before: list[Polynomial] = []
    for condition in conditions:
        rest = polynomials.squarefree(condition)
        for other in before:
            rest = polynomials.without(rest, polynomials.common_divisor(rest, other))
        before.append(rest)
        yield rest
