"""Directions θ at which the number of folds changes or the friction of one is 0, isolated by proof in 0 < θ < π/2.

Both happen at roots of polynomials in sin θ (derived: ``fold_events``), hence in t = tan(θ/2), which Descartes' rule isolates
exactly. Between two of them the number of folds is that in any direction.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial

import numpy as np

from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray
from ...numerics import polynomials
from ...numerics.descartes import real_roots
from ...numerics.half_angle import of_sine_in_t
from .fixed_parameters import Fixed

#: Degrees in sin θ of what is 0 at an event.
_DEGREES, _DEGREES_WITHOUT_ALPHA = (15, 6, 6), (6, 3, 3)
#: Bits of t at an event, and how far beside it directions are taken, over t.
_BITS, _BESIDE = 64, 4e-14


def directions(fixed: Fixed) -> FloatArray:
    """t = tan(θ/2) in 0 < θ < π on both sides of each event, of θ = π/2, and between two neighbours.

    (θ, θ₀, μ) → (π − θ, π − θ₀, −μ) gives the events beyond π/2.
    """
    exact = Fixed(*map(Fraction, fixed))  # type: ignore[arg-type]  # floats taken as the rationals that they are
    values = cache(partial(_values, exact))  # the three have nodes in common

    def of_kind(place: int) -> Callable[[Fraction], Fraction]:
        return lambda s: values(s)[place]

    events = {Fraction(1)}
    for place, degree in enumerate(_DEGREES if exact.alpha else _DEGREES_WITHOUT_ALPHA):
        in_sine = polynomials.interpolate(of_kind(place), degree, Fraction)
        if any(in_sine):  # else it is the same at every θ
            condition = polynomials.squarefree(of_sine_in_t(polynomials.primitive(in_sine)))
            events |= {(root.low + root.high) / 2 for root in real_roots(condition, Fraction(0), Fraction(1), _BITS)}
    at = np.array(sorted(map(float, events)))
    low = np.concatenate([at * (1 - _BESIDE), at * (1 + _BESIDE), 0.5 * (at + np.append(0.0, at[:-1]))])
    return np.concatenate([low, 1 / low])


def _values(exact: Fixed, s: Fraction) -> tuple[Fraction, ...]:
    """What is 0 at events of each of the three kinds, in sin θ."""
    if exact.alpha:
        return tuple(_catastrophe.fold_events(s, *exact))
    return tuple(_catastrophe.fold_events_without_alpha(s, exact.kappa, exact.sigma, exact.beta))
