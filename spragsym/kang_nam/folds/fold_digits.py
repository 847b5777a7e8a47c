"""More digits of one fold that is already known to within a proved interval, in interval arithmetic of more bits.

Where f changes little with the parameter, float64 leaves the value on the fold a wider bound than is wanted. Nothing has to be
found or decided again: one evaluation on each side of the fold gives the digits.
"""

from collections.abc import Mapping
from fractions import Fraction

from ...models.parameters import NAMES
from ...numerics import balls
from ...numerics.balls import Interval
from ...numerics.polynomials import on_circle
from ..quartic import kernel

#: Bits of the evaluation: enough for a value that loses half of the digits of float64, twice over.
_BITS = 160
#: The error is squared each time.
_STEPS = 3


def sharpened(vary: str, given: Mapping[str, float], t: tuple[float, float], value: tuple[float, float]) -> tuple[float, float]:
    """The value on one fold of a parameter in which f is linear, any but θ₀, and a bound on its error.

    ``t`` and ``value``: tan(θ/2) on the fold and the value there, each with a proved bound on its error. Undecided where f_v
    or f″ may be 0 within the bounds. Source: on the surface f = 0 the value v changes by dv/dθ = −f′/f_v, which is 0 on the
    fold. So v at the middle of the given directions is off by at most their width times the largest \\|f′/f_v\\| over all of
    them; where that is too much, one step of Newton's rule for f′ = 0, in intervals, narrows the directions first.
    """
    with balls.precision(_BITS):
        directions, values = (_around(*one) for one in (t, value))
        cos0, sin0 = balls.cos_sin(balls.exact(Fraction(given["theta0"])))
        others = [balls.exact(Fraction(given[name] if name != vary else 0)) for name in NAMES[1:]]
        without, change = kernel.f_along(vary, cos0, sin0, *others)
        for _ in range(_STEPS):
            middle = balls.middle(directions)
            trig = [one + values * other for one, other in zip(without, change, strict=True)]
            c, s, scale = on_circle(directions)
            drift = kernel.f_slope(c, s, *trig) / kernel.f(c, s, *change) * (2 * (directions - middle))  # dθ ≤ 2 dt
            here = on_circle(middle)[:2]
            values = _narrower(values, drift - kernel.f(*here, *without) / kernel.f(*here, *change))
            found, error = _as_float(*balls.ends(values))
            if error <= 2.0**-52 * abs(found):
                break
            trig = [one + values * other for one, other in zip(without, change, strict=True)]
            step = kernel.f_slope(*here, *trig) / kernel.f_curvature(c, s, *trig) * scale / 2
            directions = _narrower(directions, middle - step)
    return found, error


def _around(value: float, error: float) -> Interval:
    return balls.between(Fraction(value) - Fraction(error), Fraction(value) + Fraction(error))


def _narrower(one: Interval, other: Interval) -> Interval:
    """The intersection of two enclosures of one number."""
    (low, high), (begin, end) = balls.ends(one), balls.ends(other)
    return one if high - low <= end - begin else other


def _as_float(low: Fraction, high: Fraction) -> tuple[float, float]:
    """The middle of two ends, and a bound on how far either is from it."""
    found = float((low + high) / 2)
    return found, float(max(high - Fraction(found), Fraction(found) - low)) * (1 + 2.0**-50) + 1e-320
