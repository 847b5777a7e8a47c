"""Arrays of float64 intervals, rounded outward, and their functions: a number type for generated
functions, a few nanoseconds an operation.

An array of intervals is one NumPy array, whose first axis holds (−low, high). So both ends are
rounded the same way, upward, and one call serves both.

Rounding. NumPy's + − × ÷ and √ round to nearest: for a result r the exact value lies below the
float after r. That is at most r + 2⁻⁵² |r| for normal r, since the distance to the next float is at
most 2⁻⁵² |r|; the sum is rounded to nearest, and rounding keeps the order of numbers, so that it
does not fall below that float. :data:`TINY` is added for r that is 0 or subnormal, where 2⁻⁵² |r|
may be 0. Only negation, absolute value, sign and union are exact.

An end that is NaN bounds nothing, nor does an infinite one: every comparison with NaN is false, so
that code which concludes from comparisons that hold concludes nothing from it. NaN comes from ∞ −
∞, 0 · ∞, and division by an interval that holds 0. NumPy's warnings on such numbers are for the
caller to silence, with :data:`quiet` around a whole computation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial, reduce
from operator import methodcaller
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .arithmetic import Arithmetic, Matrix, Number

FloatArray: TypeAlias = NDArray[np.float64]
BoolArray: TypeAlias = NDArray[np.bool_]
IntArray: TypeAlias = NDArray[np.int64]
IndexArray: TypeAlias = NDArray[np.intp]
Int8Array: TypeAlias = NDArray[np.int8]
ComplexArray: TypeAlias = NDArray[np.complex128]
Shape: TypeAlias = tuple[int, ...]

#: Context in which what has no bounds, or no value, is infinite or NaN without a warning.
quiet = partial(np.errstate, all="ignore")

#: Twice the unit of rounding.
EPS = 2.0**-52
#: More than half the distance between subnormal numbers, and far enough from them that products
#: with it stay fast.
TINY = 2.0**-1000
#: As an array: NumPy takes one in a third of the time that it takes to make one of a float.
_UNIT = np.array(EPS)
#: As an array, too.
_TINY = np.array(TINY)
#: Bound, in units of EPS relative, on the error of NumPy's exp, log, tanh and arctan; what NumPy's
#: own tests allow is 4.
FUNCTION_ULPS = 8


def rounded_outward(ends: FloatArray, ulps: float = 1.0) -> FloatArray:
    """Upper bounds of the numbers from which ``ends`` differ by at most ``ulps`` units of 2⁻⁵²
    relative, or by one rounding.
    """
    out = np.abs(ends)
    out *= _UNIT if ulps == 1.0 else ulps * EPS
    out += _TINY
    out += ends
    return out


def pair(low: FloatArray, high: FloatArray) -> FloatArray:
    """Two arrays of one shape as one, as −low and high are: np.stack takes longer to begin."""
    out = np.empty((2, *low.shape))
    out[0], out[1] = low, high
    return out


def ends_around(middle: FloatArray, radius: FloatArray) -> FloatArray:
    """−low and high of boxes around their middles, each end rounded to nearest; radii may differ to
    both sides.
    """
    return pair(-middle, middle) + radius


def width_of(ends: FloatArray) -> FloatArray:
    """high − low of boxes, of which ``ends`` has −low and high first, rounded to nearest; below 0
    where nothing is left.
    """
    return ends[0] + ends[1]


def spans_of(ends: FloatArray) -> FloatArray:
    """Lower and upper ends of boxes, on a last axis, of which ``ends`` has −low and high first."""
    return np.stack([-ends[0], ends[1]], axis=-1)


def hulls_of(ends: FloatArray, number: IntArray, count: int) -> FloatArray:
    """Hulls of boxes, shape (2, n, N), of the same number, shape (2, n, count); where there are
    none their ends are −∞.
    """
    out = np.full((*ends.shape[:2], count), -np.inf)
    np.maximum.at(np.moveaxis(out, 2, 0), number, np.moveaxis(ends, 2, 0))
    return out


def scale_of(values: ArrayLike) -> FloatArray:
    """max(1, |value|), over which errors and widths are told: relative where numbers are large,
    absolute where they are small.
    """
    return np.maximum(1.0, np.abs(values))


def is_in_another_unit(sizes: FloatArray) -> BoolArray:
    """Mask of sizes so far from 1 that steps and widths are taken in proportion to these."""
    return np.isfinite(sizes) & (sizes > 0) & ((sizes > 2.0**9) | (sizes < 2.0**-9))


class Intervals(Arithmetic):
    """An array of closed intervals.

    Parameters
    ----------
    ends : ndarray
        Shape (2, …): −low and high.

    Examples
    --------
    >>> x = Intervals.between([1.0, -2.0], [2.0, 3.0])
    >>> (x * x).low.round(6) + 0.0, (x * x).high.round(6)
    (array([1., 0.]), array([4., 9.]))
    """

    __slots__ = ("ends",)
    __array_ufunc__ = None

    def __init__(self, ends: FloatArray) -> None:
        self.ends = ends

    @classmethod
    def between(cls, low: ArrayLike, high: ArrayLike) -> Intervals:
        """[low, high], element by element."""
        one, other = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
        if one.shape != other.shape:
            one, other = np.broadcast_arrays(one, other)
        return cls(pair(-one, other))

    @classmethod
    def point(cls, value: ArrayLike) -> Intervals:
        """Intervals without width."""
        return cls.between(value, value)

    @property
    def low(self) -> FloatArray:
        """Lower ends."""
        return -self.ends[0]

    @property
    def high(self) -> FloatArray:
        """Upper ends."""
        return self.ends[1]

    @property
    def shape(self) -> Shape:
        """Shape of the array."""
        return self.ends.shape[1:]

    @property
    def magnitude(self) -> FloatArray:
        """Largest |x| of each."""
        return np.maximum(self.ends[0], self.ends[1])

    @property
    def mignitude(self) -> FloatArray:
        """Smallest |x| of each."""
        return np.maximum(-np.minimum(self.ends[0], self.ends[1]), 0.0)

    @property
    def width(self) -> FloatArray:
        """Not less than high − low."""
        return rounded_outward(self.ends[0] + self.ends[1])

    @property
    def middle(self) -> FloatArray:
        """A float inside of each, the nearest to its middle or next to it."""
        halved = 0.5 * self.ends
        return np.clip(halved[1] - halved[0], -self.ends[0], self.ends[1])

    @property
    def nearest_to_zero(self) -> FloatArray:
        """The float in each that is nearest to 0."""
        return np.clip(0.0, self.low, self.high)

    @property
    def signs(self) -> Int8Array:
        """1 or −1 where the sign of each is known, else 0."""
        return (self.ends[0] < 0).astype(np.int8) - (self.ends[1] < 0)

    def holds_zero(self) -> BoolArray:
        """Whether each holds 0, or bounds nothing."""
        return ~((self.ends[0] < 0) | (self.ends[1] < 0))

    def __getitem__(self, index: object) -> Intervals:
        index = index if isinstance(index, tuple) else (index,)
        return Intervals(self.ends[(slice(None), *index)])

    def __iter__(self) -> Iterator[Intervals]:
        return (Intervals(self.ends[:, index]) for index in range(self.ends.shape[1]))

    def __neg__(self) -> Intervals:
        return Intervals(self.ends[::-1])

    def __abs__(self) -> Intervals:
        return Intervals(pair(-self.mignitude, self.magnitude))

    def __add__(self, other: Any) -> Intervals:
        if not isinstance(other, Intervals):
            if isinstance(other, int | float) and other == 0:
                return self
            if (other := _point(other)) is None:
                return NotImplemented
        one, two = _aligned(self.ends, other.ends)
        return Intervals(rounded_outward(one + two))

    def __mul__(self, other: Number) -> Intervals:
        if isinstance(other, Intervals):
            if other is self:
                return self.squared()
            return Intervals(rounded_outward(_extremes(np.multiply, self.ends, other.ends)))
        if isinstance(other, int | float):
            return self._times(exactly(other))
        if isinstance(other, np.ndarray):
            return Intervals(rounded_outward(scaled(self.ends, other)))
        return NotImplemented

    def _times(self, factor: float) -> Intervals:
        ends = self.ends if factor >= 0 else self.ends[::-1]
        if factor == 0:  # exactly, unless an end bounds nothing
            return Intervals(ends * 0.0)
        return Intervals(ends if abs(factor) == 1 else rounded_outward(ends * abs(factor)))

    def __truediv__(self, other: Number) -> Intervals:
        if not isinstance(other, Intervals):
            return NotImplemented if (point := _point(other)) is None else self / point
        one, two = _aligned(self.ends, other.ends)
        quotient, zero = _extremes(np.divide, one, two), Intervals(two).holds_zero()
        if zero.any():
            quotient = np.where(zero, _beside_zero(one, two), quotient)
        return Intervals(rounded_outward(quotient))

    def __rtruediv__(self, other: Number) -> Intervals:
        return NotImplemented if (point := _point(other)) is None else point / self

    def squared(self) -> Intervals:
        """x²."""
        low, high = self.mignitude, self.magnitude
        return Intervals(_not_negative(rounded_outward(pair(-(low * low), high * high))))

    def __pow__(self, power: Number) -> Intervals:
        if not isinstance(power, int):
            return NotImplemented
        if power < 0:
            return 1 / self**-power
        if power == 0:
            return Intervals.point(np.ones(self.shape))
        if power == 1:
            return self
        if power % 2 == 0:
            return self.squared() ** (power // 2)
        # Monotone. A product of n numbers in any order is off by less than n units, and by less
        # than TINY where one underflows.
        return Intervals(rounded_outward(reduce(np.multiply, [self.ends] * power), power))

    def sqrt(self) -> Intervals:
        """Square root; NaN where the interval holds negative numbers."""
        root = np.sqrt(pair(-self.ends[0], self.ends[1]))
        root[1] = np.where(self.ends[0] > 0, np.nan, root[1])
        root[0] *= -1
        return Intervals(_not_negative(rounded_outward(root)))

    def exp(self) -> Intervals:
        """Exponential, off by no more than :data:`FUNCTION_ULPS`."""
        values = self._at_ends(np.exp)
        # A lower end beyond the largest number is at least that: so that an infinite force is told
        # from an unknown one.
        values[0] = np.maximum(values[0], -np.finfo(np.float64).max)
        # Of 0 it is 1, exactly: laws of friction vanish there.
        return Intervals(
            np.where(self.ends == 0, values, _not_negative(rounded_outward(values, FUNCTION_ULPS)))
        )

    def log(self) -> Intervals:
        """Natural logarithm; NaN where the interval holds negative numbers, −∞ for an end that is
        0.
        """
        values = self._at_ends(np.log)
        # What an upper end −∞ is given as, a bound like it with which one can go on.
        return Intervals(
            np.where(
                self.ends == 0, np.maximum(values, -1e300), rounded_outward(values, FUNCTION_ULPS)
            )
        )

    def tanh(self) -> Intervals:
        """Hyperbolic tangent, between −1 and 1."""
        values = self._at_ends(np.tanh)
        return Intervals(
            np.where(self.ends == 0, 0.0, np.minimum(rounded_outward(values, FUNCTION_ULPS), 1.0))
        )

    def atan(self) -> Intervals:
        """Arc tangent."""
        return Intervals(
            np.where(self.ends == 0, 0.0, rounded_outward(self._at_ends(np.atan), FUNCTION_ULPS))
        )

    def cos(self) -> Intervals:
        """Cosine."""
        return _wave(self, np.cos, 0.0)

    def sin(self) -> Intervals:
        """Sine."""
        return _wave(self, np.sin, 0.25)

    def not_negative(self) -> Intervals:
        """Intervals of what is known not to be negative, where rounding has pushed the lower end
        below 0.
        """
        return Intervals(pair(np.minimum(self.ends[0], 0.0), self.ends[1]))

    def component(self, across: Intervals) -> Intervals:
        """x/√(x² + y²), see :func:`unit_vector`."""
        ends = self.ends
        other = np.where(ends > 0, across.mignitude, across.magnitude)
        # Three roundings, of a sum of squares, and two more: less than 4 units, where nothing
        # underflows or overflows.
        values = rounded_outward(ends / np.sqrt(ends * ends + other * other), 4)
        size = np.maximum(np.abs(ends), other)
        accurate = (size > 1e-140) & (size < 1e150) & (values <= 1)
        return Intervals(np.where(accurate, values, 1.0))

    def angle(self, cosine: Intervals, side: int | None) -> Intervals:
        """Of the vector of which this is the sine, see :func:`atan2`."""
        x, y = (np.stack([part.low, part.high]) for part in (cosine, self))
        cut = ~((x[0] > 0) | (y[0] > 0) | (y[1] < 0))
        corners = np.stack([np.arctan2(y[j], x[i]) for i in (0, 1) for j in (0, 1)])
        ends = _bounded_by_pi(np.stack([-corners.min(axis=0), corners.max(axis=0)]))
        if cut.any():
            ends = np.where(cut, _across(x, y, side), ends)
        return Intervals(ends)

    def is_nothing(self) -> bool:
        """Whether all are 0."""
        return self.ends.size > 0 and not self.ends.any()

    def _at_ends(self, function: np.ufunc) -> FloatArray:
        """A function that grows with its argument: −least and greatest, as NumPy rounds them."""
        values: FloatArray = function(pair(-self.ends[0], self.ends[1]))
        values[0] *= -1
        return values

    def sign(self) -> Intervals:
        """−1, 0 or 1, or an interval of these."""
        return Intervals(np.sign(self.ends))

    def __repr__(self) -> str:
        return f"Intervals.between({self.low!r}, {self.high!r})"


def exactly(number: float) -> float:
    """An integer or float as a float; ValueError for an integer that no float equals."""
    value = float(number)
    if value != number:
        raise ValueError(f"{number!r} is no float; give an interval around it")
    return value


def _point(value: Number) -> Intervals | None:
    """A number or an array of floats as intervals without width."""
    if isinstance(value, int | float):
        number = exactly(value)
        return Intervals(np.array([-number, number]))
    return Intervals.point(value) if isinstance(value, np.ndarray) else None


def stacked(parts: Sequence[Any], shape: Shape) -> Intervals:
    """Several arrays of one shape, or numbers, as one array of intervals with one more axis, the
    first.
    """
    out = np.empty((2, len(parts), *shape))
    for index, part in enumerate(parts):
        if isinstance(part, Intervals):
            out[:, index] = part.ends
        else:
            out[0, index], out[1, index] = -exactly(part), exactly(part)
    return Intervals(out)


def matrix(rows: Matrix, shape: Shape) -> Intervals:
    """Rows of entries as one array of intervals, shape (rows, columns, …)."""
    entries = stacked([entry for row in rows for entry in row], shape)
    return Intervals(entries.ends.reshape(2, len(rows), len(rows[0]), *shape))


def scaled(ends: FloatArray, factor: FloatArray) -> FloatArray:
    """Ends of the product with numbers of either sign, rounded to nearest."""
    return np.maximum(ends * factor, -(ends[::-1] * factor))


def _aligned(one: FloatArray, other: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Both with as many axes as the one that has more, new ones behind the first."""
    if one.ndim < other.ndim:
        one = one.reshape(2, *(1,) * (other.ndim - one.ndim), *one.shape[1:])
    elif other.ndim < one.ndim:
        other = other.reshape(2, *(1,) * (one.ndim - other.ndim), *other.shape[1:])
    return one, other


def _extremes(operation: np.ufunc, one: FloatArray, other: FloatArray) -> FloatArray:
    """(−least, greatest) of the operation on the four pairs of ends, rounded to nearest."""
    one, other = _aligned(one, other)
    same, cross = operation(one, other), operation(one, other[::-1])
    out: FloatArray = np.empty_like(same)
    # (−a₀, a₁) with (−b₀, b₁) gives a₀ b₀ and a₁ b₁; with (b₁, −b₀) it gives a₀ b₁ and a₁ b₀ with
    # the other sign.
    np.maximum(np.maximum(same[0], same[1]), -np.minimum(cross[0], cross[1]), out=out[1])
    np.maximum(np.maximum(cross[0], cross[1]), -np.minimum(same[0], same[1]), out=out[0])
    return out


def _beside_zero(one: FloatArray, other: FloatArray) -> FloatArray:
    """Ends of the quotient by intervals that end at 0, for divisors other than 0; NaN where 0 is
    inside of them.
    """
    positive = (other[0] == 0) & (other[1] > 0)
    negative = (other[1] == 0) & (other[0] > 0)
    # −least and greatest dividend, its sign turned for negative divisors.
    least, most = np.where(negative, one[::-1], one)
    far = np.where(negative, other[0], other[1])
    ends = np.stack(
        [np.where(least > 0, np.inf, least / far), np.where(most > 0, np.inf, most / far)]
    )
    return np.where(positive | negative, ends, np.nan)


def _not_negative(ends: FloatArray) -> FloatArray:
    """Lower ends of what is not negative, which rounding may have pushed below 0."""
    np.minimum(ends[0], 0.0, out=ends[0])
    return ends


#: Beyond it cosine and sine are [−1, 1].
LARGEST_ANGLE = 1e5
#: Upper bound of π, and an interval around it.
HALF_TURN = float(np.nextafter(np.pi, 4.0))
PI = Intervals.between([np.pi], [HALF_TURN])

#: As functions.
sqrt, exp, log, tanh, atan, cos, sin = map(
    methodcaller, ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")
)


def _wave(angle: Intervals, function: np.ufunc, peak: float) -> Intervals:
    """A cosine that has its maxima at 2π (peak + n)."""
    low, high = angle.low, angle.high
    one, other = function(low), function(high)
    # Bound on the absolute error of NumPy's sine and cosine, for arguments up to
    # :data:`LARGEST_ANGLE`.
    error = 2.0**-50
    ends = pair(-np.minimum(one, other), np.maximum(one, other)) + error
    turns_low, turns_high = low / (2 * np.pi) - peak, high / (2 * np.pi) - peak
    unknown = ~((angle.magnitude <= LARGEST_ANGLE) & np.isfinite(one) & np.isfinite(other))
    # More than the error of an angle over 2π: an extremum so near to an end counts as
    # inside, where it hardly widens anything.
    turn_error = 1e-10
    for end, shift in ((1, 0.0), (0, 0.5)):
        inside = np.floor(turns_high + (shift + turn_error)) >= np.ceil(
            turns_low + (shift - turn_error)
        )
        ends[end] = np.where(inside | unknown, 1.0, np.minimum(ends[end], 1.0))
    return Intervals(ends)


def length(dx: Intervals, dy: Intervals) -> Intervals:
    """√(dx² + dy²)."""
    return (dx.squared() + dy.squared()).not_negative().sqrt()


def unit_vector(dx: Intervals, dy: Intervals) -> tuple[Intervals, Intervals]:
    """Direction (dx, dy)/√(dx² + dy²), each component as narrow as it is; [−1, 1] where the vector
    may be 0.

    dx/√(dx² + dy²) grows with dx, and with |dy| it goes to 0: so it is largest at the largest dx,
    and there at the least |dy| if that dx is positive, at the largest if not.
    """
    return dx.component(dy), dy.component(dx)


def atan2(sine: Intervals, cosine: Intervals, side: int | None = None) -> Intervals:
    """The angle of the vector (cosine, sine), from −π to π; NaN where the vectors meet the ray on
    which it jumps, or 0.

    With a ``side`` of 1 or −1 there the angles of vectors with a sine not negative or not positive,
    with 0 all. Over a rectangle that does not meet the ray the angle is least and greatest at
    corners: on each side it is monotone.
    """
    return sine.angle(cosine, side)


def _across(x: FloatArray, y: FloatArray, side: int | None) -> FloatArray:
    """Ends of angles of rectangles that meet the ray of negative cosines: x and y are lower and
    upper ends.
    """
    if side is None:
        return np.full(x.shape, np.nan)
    most = np.full(x.shape[1:], rounded_outward(np.array(np.pi)))
    if side == 0:
        return np.stack([most, most])
    # Of vectors with a sine of this sign the angle is least in size at the greatest cosine. A sine
    # of −0 would stand for the other side.
    far = np.maximum(y[1] if side > 0 else -y[0], 0.0) + 0.0
    least = -_bounded_by_pi(-np.minimum(np.arctan2(far, x[1]), np.arctan2(0.0, x[1])))
    return np.stack([-least, most] if side > 0 else [most, -least])


def _bounded_by_pi(ends: FloatArray) -> FloatArray:
    """Upper bounds of angles that NumPy gives, none of which is larger than π."""
    return np.minimum(rounded_outward(ends, FUNCTION_ULPS), rounded_outward(np.array(np.pi)))
