"""Direction and length of a spring, from the vector between its ends, for each kind of number that the search uses."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from ..exact.interval_arrays import Intervals, stacked
from ..exact.interval_functions import length, unit_vector
from ..exact.jets import Jet, binomial_series, constant


def direction(dx: Any, dy: Any, shape: tuple[int, ...]) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy): arrays of intervals of that shape, or jets of them.

    Notes
    -----
    With the turned and scaled change u + i v of the vector, (c + i s) (1 + u + i v) l is the vector. So all derivatives come
    from the sharp enclosures of c, s and l, not from quotients of intervals.
    """
    along, across = (_as_intervals(constant(part), shape) for part in (dx, dy))
    c, s = unit_vector(along, across)
    L = length(along, across)
    order = max((part.order for part in (dx, dy) if isinstance(part, Jet)), default=0)
    if not order:
        return c, s, L
    hx, hy = (_change(part, order) for part in (dx, dy))
    u, v = (hx * c + hy * s) / L, (hy * c - hx * s) / L
    w = u * 2 + u**2 + v**2
    root, inverse = (Jet(w.terms, order).composed(binomial_series(Fraction(way, 2), order)) for way in (1, -1))
    cosine, sine = (u + 1) * inverse, v * inverse
    return cosine * c - sine * s, cosine * s + sine * c, root * L


def _change(part: Any, order: int) -> Jet:
    """The part of it that is not constant."""
    terms = part.terms if isinstance(part, Jet) else {}
    return Jet({term: coefficient for term, coefficient in terms.items() if term}, order)


def _as_intervals(value: Any, shape: tuple[int, ...]) -> Intervals:
    return stacked([value], shape)[0]
