"""Direction, length and turning of a spring, from the vector between its ends, for each kind of number that the search uses."""

from fractions import Fraction
from typing import Any

import numpy as np

from ...numerics.interval_arrays import Intervals, Shape, atan2, length, stacked, unit_vector
from ...numerics.jets import Jet, argument, binomial_series, change, constant, turned


def quotients(dx: Any, dy: Any, xp: Any) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy), of numbers that are narrow."""
    length = xp.sqrt(dx**2 + dy**2)
    return dx / length, dy / length, length


def direction(dx: Any, dy: Any, shape: Shape, square: Any = None) -> tuple[Any, Any, Any]:
    """Cosine, sine and length of the vector (dx, dy): arrays of intervals of that shape, or jets of them.

    ``square`` is the squared length without its changes, where another form of it is known that may be narrower. With the turned
    and scaled change u + i v of the vector, (c + i s) (1 + u + i v) l is the vector. So all derivatives come from the sharp
    enclosures of c, s and l, not from quotients of intervals.
    """
    c, s, L = _at(dx, dy, shape)
    if square is not None:
        L = Intervals(np.fmin(L.ends, as_intervals(square, shape).sqrt().ends))
    order = max((part.order for part in (dx, dy) if isinstance(part, Jet)), default=0)
    if not order:
        return c, s, L
    u, v = _turn(dx, dy, c, s, L, order)
    w = u * 2 + u**2 + v**2
    root, inverse = (Jet(w.terms, order).composed(binomial_series(Fraction(way, 2), order)) for way in (1, -1))
    cosine, sine = (u + 1) * inverse, v * inverse
    return cosine * c - sine * s, cosine * s + sine * c, root * L


def turning(value: tuple[Any, Any], vector: tuple[Any, Any], rest: tuple[Any, Any], shape: Shape, side: int | None) -> Any:
    """The turning φ of a spring in [−π, π], an array of intervals or a jet of them; NaN where boxes meet the ray φ = ±π.

    ``value`` holds cosine and sine of φ without their changes, ``rest`` those of the inclination at rest; ``side`` says what is
    given on the ray instead, see :func:`spragsym.numerics.interval_arrays.atan2`. Its derivatives are those of the spring's
    angle less those of the angle at rest: algebra in sharp enclosures of direction and length. They hold at every point off the
    ray, and so on either side of it, but no mean value theorem holds across it.
    """
    cosine, sine = (as_intervals(part, shape) for part in value)
    phi = atan2(sine, cosine, side)
    order = max((part.order for part in (*vector, *rest) if isinstance(part, Jet)), default=0)
    if not order:
        return phi
    moved: Any = phi
    if any(isinstance(part, Jet) for part in vector):
        moved = argument(*_turn(*vector, *_at(*vector, shape), order)) + moved
    if any(isinstance(part, Jet) for part in rest):
        moved = -argument(*turned(rest[1], rest[0])) + moved
    return moved


def _at(dx: Any, dy: Any, shape: Shape) -> tuple[Intervals, Intervals, Intervals]:
    """Direction and length without their changes."""
    along, across = (as_intervals(constant(part), shape) for part in (dx, dy))
    return *unit_vector(along, across), length(along, across)


def _turn(dx: Any, dy: Any, c: Intervals, s: Intervals, L: Intervals, order: int) -> tuple[Jet, Jet]:
    """The turned and scaled change of the vector."""
    hx, hy = (change(part, order) for part in (dx, dy))
    return (hx * c + hy * s) / L, (hy * c - hx * s) / L


def as_intervals(value: Any, shape: Shape) -> Intervals:
    return stacked([value], shape)[0]
