"""Interval arithmetic on arrays of float64 intervals, with outward rounding. :class:`Intervals` is
a number type for generated functions, and takes a few nanoseconds per operation.

An array of intervals is one NumPy array whose first axis holds (−low, high). So both ends are
rounded in the same direction, upward, and one call serves both.

Rounding. NumPy's + − × ÷ and √ round to nearest: if the result is r, the exact value is below the
float after r. For normal r that float is at most r + 2⁻⁵² |r|, since the distance to it is at most
2⁻⁵² |r|. The computed sum is not below it either, since rounding to nearest is monotonic.
:data:`TINY` is added for r that is 0 or subnormal, where 2⁻⁵² |r| may be 0. Only negation, absolute
value, sign and union are exact.

An end that is NaN or infinite bounds nothing. Every comparison with NaN is false: code must draw
conclusions only from comparisons that are true. NaN arises from ∞ − ∞, 0 · ∞, and division by an
interval that contains 0. The caller silences NumPy's warnings about these, with :data:`quiet`
around a whole computation.
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

#: Context in which NumPy gives infinities and NaN without a warning.
quiet = partial(np.errstate, all="ignore")

#: Twice the unit roundoff, as an array, which NumPy accepts in a third of the time for a float.
EPS = np.array(2.0**-52)
#: More than half the distance between subnormal numbers, and so large that products with it are
#: normal, hence fast.
TINY = np.array(2.0**-1000)
#: Bound of the relative error of NumPy's exp, log, tanh and arctan, in EPS; NumPy's own tests allow
#: 4.
FUNCTION_ULPS = 8


def rounded_outward(ends: FloatArray, ulps: float = 1.0) -> FloatArray:
    """Upper bounds of numbers that were computed as ``ends`` with a relative error of at most
    ``ulps`` × 2⁻⁵²; the default covers one rounding to nearest.
    """
    out = np.abs(ends)
    out *= EPS if ulps == 1.0 else ulps * EPS
    out += TINY
    out += ends
    return out


def pair(low: FloatArray, high: FloatArray) -> FloatArray:
    """Two arrays of equal shape stacked along a new first axis; faster than np.stack."""
    out = np.empty((2, *low.shape))
    out[0], out[1] = low, high
    return out


def ends_around(middle: FloatArray, radius: FloatArray) -> FloatArray:
    """−low and high of boxes with given midpoints and radii, rounded to nearest; radii of shape
    (2, …) differ between the two sides.
    """
    return pair(-middle, middle) + radius


def width_of(ends: FloatArray) -> FloatArray:
    """high − low from ``ends`` (−low, high), rounded to nearest; negative for empty boxes."""
    return ends[0] + ends[1]


def spans_of(ends: FloatArray) -> FloatArray:
    """Lower and upper ends along a last axis, from ``ends`` (−low, high)."""
    return np.stack([-ends[0], ends[1]], axis=-1)


def hulls_of(ends: FloatArray, number: IntArray, count: int) -> FloatArray:
    """Hulls, (2, n, count), of the boxes (2, n, N) that have the same ``number`` (N,); ends −∞ for
    a number without boxes.
    """
    out = np.full((*ends.shape[:2], count), -np.inf)
    np.maximum.at(np.moveaxis(out, 2, 0), number, np.moveaxis(ends, 2, 0))
    return out


def joined(spans: FloatArray) -> FloatArray:
    """Unions of ranges that meet, in ascending order."""
    out = list[list[float]]()
    for low, high in sorted(spans.tolist()):
        if out and low <= out[-1][1]:
            out[-1][1] = max(out[-1][1], high)
        else:
            out.append([low, high])
    return np.array(out).reshape(-1, 2)


def scale_of(values: ArrayLike) -> FloatArray:
    """max(1, |value|), the unit of errors and widths: relative for large numbers, absolute for
    small ones.
    """
    return np.maximum(1.0, np.abs(values))


def is_in_another_unit(sizes: FloatArray) -> BoolArray:
    """Mask of sizes so far from 1 that steps and widths should be taken relative to them."""
    return np.isfinite(sizes) & (sizes > 0) & ((sizes > 2.0**9) | (sizes < 2.0**-9))


class Intervals(Arithmetic):
    """An array of closed intervals.

    Parameters
    ----------
    ends : ndarray, shape (2, …)
        −low and high.

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
        """Intervals [low, high], elementwise."""
        one, other = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
        if one.shape != other.shape:
            one, other = np.broadcast_arrays(one, other)
        return cls(pair(-one, other))

    @classmethod
    def point(cls, value: ArrayLike) -> Intervals:
        """Intervals of width 0."""
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
        """Largest |x| in each interval."""
        return np.maximum(self.ends[0], self.ends[1])

    @property
    def mignitude(self) -> FloatArray:
        """Smallest |x| in each interval."""
        return np.maximum(-np.minimum(self.ends[0], self.ends[1]), 0.0)

    @property
    def width(self) -> FloatArray:
        """Upper bound of high − low."""
        return rounded_outward(self.ends[0] + self.ends[1])

    @property
    def middle(self) -> FloatArray:
        """A float in each interval, at its midpoint up to rounding."""
        halved = 0.5 * self.ends
        return np.clip(halved[1] - halved[0], -self.ends[0], self.ends[1])

    @property
    def nearest_to_zero(self) -> FloatArray:
        """The number in each interval that is nearest to 0."""
        return np.clip(0.0, self.low, self.high)

    @property
    def signs(self) -> Int8Array:
        """1 or −1 for intervals of known sign, else 0."""
        return (self.ends[0] < 0).astype(np.int8) - (self.ends[1] < 0)

    def holds_zero(self) -> BoolArray:
        """True for intervals that contain 0, or bound nothing."""
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
        """Product with a number."""
        ends = self.ends if factor >= 0 else self.ends[::-1]
        if factor == 0:  # exactly 0, or NaN
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
        # Monotonic. The relative error of a product of n numbers is below n EPS, or the absolute
        # one below TINY if it underflows.
        return Intervals(rounded_outward(reduce(np.multiply, [self.ends] * power), power))

    def sqrt(self) -> Intervals:
        """Square root; the upper end is NaN if the interval contains negative numbers."""
        root = np.sqrt(pair(-self.ends[0], self.ends[1]))
        root[1] = np.where(self.ends[0] > 0, np.nan, root[1])
        root[0] *= -1
        return Intervals(_not_negative(rounded_outward(root)))

    def exp(self) -> Intervals:
        """Exponential."""
        values = self._at_ends(np.exp)
        # A lower end that overflows is at least the largest float: then the number is known to be
        # large, and not unbounded.
        values[0] = np.maximum(values[0], -np.finfo(np.float64).max)
        rounded = _not_negative(rounded_outward(values, FUNCTION_ULPS))
        # exp(0) = 1 exactly: friction laws 1 − exp(…) vanish there.
        return Intervals(np.where(self.ends == 0, values, rounded))

    def log(self) -> Intervals:
        """Natural logarithm; NaN for intervals with negative numbers, −∞ for a lower end 0."""
        values = self._at_ends(np.log)
        rounded = rounded_outward(values, FUNCTION_ULPS)
        # An upper end log(0) = −∞ is replaced by a finite bound.
        return Intervals(np.where(self.ends == 0, np.maximum(values, -1e300), rounded))

    def tanh(self) -> Intervals:
        """Hyperbolic tangent, within [−1, 1]."""
        rounded = rounded_outward(self._at_ends(np.tanh), FUNCTION_ULPS)
        return Intervals(np.where(self.ends == 0, 0.0, np.minimum(rounded, 1.0)))

    def atan(self) -> Intervals:
        """Arc tangent."""
        rounded = rounded_outward(self._at_ends(np.atan), FUNCTION_ULPS)
        return Intervals(np.where(self.ends == 0, 0.0, rounded))

    def cos(self) -> Intervals:
        """Cosine."""
        return _wave(self, np.cos, 0.0)

    def sin(self) -> Intervals:
        """Sine."""
        return _wave(self, np.sin, 0.25)

    def not_negative(self) -> Intervals:
        """Intersection with [0, ∞), for numbers that are not negative but for outward rounding."""
        return Intervals(pair(np.minimum(self.ends[0], 0.0), self.ends[1]))

    def component(self, across: Intervals) -> Intervals:
        """x/√(x² + y²) for x = self and y = ``across``, see :func:`unit_vector`."""
        ends = self.ends
        other = np.where(ends > 0, across.mignitude, across.magnitude)
        # The error of five roundings is below 4 EPS, without underflow and overflow.
        values = rounded_outward(ends / np.sqrt(ends * ends + other * other), 4)
        size = np.maximum(np.abs(ends), other)
        accurate = (size > 1e-140) & (size < 1e150) & (values <= 1)
        return Intervals(np.where(accurate, values, 1.0))

    def angle(self, cosine: Intervals, side: int | None) -> Intervals:
        """Angle of the vector (cosine, self), see :func:`atan2`."""
        x, y = (np.stack([part.low, part.high]) for part in (cosine, self))
        meets_cut = ~((x[0] > 0) | (y[0] > 0) | (y[1] < 0))
        corners = np.stack([np.arctan2(y[j], x[i]) for i in (0, 1) for j in (0, 1)])
        ends = _bounded_by_pi(np.stack([-corners.min(axis=0), corners.max(axis=0)]))
        if meets_cut.any():
            ends = np.where(meets_cut, _across(x, y, side), ends)
        return Intervals(ends)

    def is_nothing(self) -> bool:
        """True if all intervals are exactly 0."""
        return self.ends.size > 0 and not self.ends.any()

    def _at_ends(self, function: np.ufunc) -> FloatArray:
        """−low and high of an increasing function, without outward rounding."""
        values: FloatArray = function(pair(-self.ends[0], self.ends[1]))
        values[0] *= -1
        return values

    def sign(self) -> Intervals:
        """Sign function: −1, 0, 1, or an interval with these ends."""
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
    """A number or an array of floats as intervals of width 0; None for other types."""
    if isinstance(value, int | float):
        number = exactly(value)
        return Intervals(np.array([-number, number]))
    return Intervals.point(value) if isinstance(value, np.ndarray) else None


def stacked(parts: Sequence[Any], shape: Shape) -> Intervals:
    """Stack intervals of one shape, or numbers, along a new first axis."""
    out = np.empty((2, len(parts), *shape))
    for index, part in enumerate(parts):
        if isinstance(part, Intervals):
            out[:, index] = part.ends
        else:
            out[0, index], out[1, index] = -exactly(part), exactly(part)
    return Intervals(out)


def matrix(rows: Matrix, shape: Shape) -> Intervals:
    """Rows of entries, intervals or numbers, as intervals of shape (rows, columns, …)."""
    entries = stacked([entry for row in rows for entry in row], shape)
    return Intervals(entries.ends.reshape(2, len(rows), len(rows[0]), *shape))


def scaled(ends: FloatArray, factor: FloatArray) -> FloatArray:
    """Ends of the product of intervals and numbers of any sign, rounded to nearest."""
    return np.maximum(ends * factor, -(ends[::-1] * factor))


def _aligned(one: FloatArray, other: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Both arrays with the same number of axes: missing ones are inserted after the first."""
    if one.ndim < other.ndim:
        one = one.reshape(2, *(1,) * (other.ndim - one.ndim), *one.shape[1:])
    elif other.ndim < one.ndim:
        other = other.reshape(2, *(1,) * (one.ndim - other.ndim), *other.shape[1:])
    return one, other


def _extremes(operation: np.ufunc, one: FloatArray, other: FloatArray) -> FloatArray:
    """−low and high of a product or quotient of intervals: the extremes over the four pairs of
    ends, rounded to nearest.
    """
    one, other = _aligned(one, other)
    same, cross = operation(one, other), operation(one, other[::-1])
    out: FloatArray = np.empty_like(same)
    # (−a₀, a₁) with (−b₀, b₁) gives a₀ b₀ and a₁ b₁; with (b₁, −b₀) it gives −a₀ b₁ and −a₁ b₀.
    np.maximum(np.maximum(same[0], same[1]), -np.minimum(cross[0], cross[1]), out=out[1])
    np.maximum(np.maximum(cross[0], cross[1]), -np.minimum(same[0], same[1]), out=out[0])
    return out


def _beside_zero(one: FloatArray, other: FloatArray) -> FloatArray:
    """Ends of quotients by intervals of which one end is 0, for the divisors other than 0; NaN if 0
    is in the interior of the divisor.
    """
    positive = (other[0] == 0) & (other[1] > 0)
    negative = (other[1] == 0) & (other[0] > 0)
    # −low and high of the dividend, times −1 for negative divisors.
    dividends = np.where(negative, one[::-1], one)
    far = np.where(negative, other[0], other[1])
    ends = np.where(dividends > 0, np.inf, dividends / far)
    return np.where(positive | negative, ends, np.nan)


def _not_negative(ends: FloatArray) -> FloatArray:
    """Ends of non-negative numbers, with lower ends below 0 replaced by 0, in place."""
    np.minimum(ends[0], 0.0, out=ends[0])
    return ends


#: Angles beyond this have the cosine and sine [−1, 1].
LARGEST_ANGLE = 1e5
#: Upper bound of π, and an interval around it.
HALF_TURN = float(np.nextafter(np.pi, 4.0))
PI = Intervals.between([np.pi], [HALF_TURN])

#: The methods as functions.
sqrt, exp, log, tanh, atan, cos, sin = map(
    methodcaller, ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")
)


def _wave(angle: Intervals, function: np.ufunc, peak: float) -> Intervals:
    """Sine or cosine, ``function``, which has its maxima at 2π (peak + n)."""
    low, high = angle.low, angle.high
    one, other = function(low), function(high)
    # Absolute error of NumPy's sine and cosine for angles up to LARGEST_ANGLE.
    error = 2.0**-50
    ends = pair(-np.minimum(one, other), np.maximum(one, other)) + error
    turns_low, turns_high = low / (2 * np.pi) - peak, high / (2 * np.pi) - peak
    unknown = ~((angle.magnitude <= LARGEST_ANGLE) & np.isfinite(one) & np.isfinite(other))
    # More than the error of an angle over 2π: an extremum this close to an end counts as inside,
    # which hardly widens the result.
    turn_error = 1e-10
    for end, shift in ((1, 0.0), (0, 0.5)):  # maxima, minima
        first = np.ceil(turns_low + (shift - turn_error))
        inside = np.floor(turns_high + (shift + turn_error)) >= first
        ends[end] = np.where(inside | unknown, 1.0, np.minimum(ends[end], 1.0))
    return Intervals(ends)


def length(dx: Intervals, dy: Intervals) -> Intervals:
    """√(dx² + dy²)."""
    return (dx.squared() + dy.squared()).not_negative().sqrt()


def unit_vector(dx: Intervals, dy: Intervals) -> tuple[Intervals, Intervals]:
    """Tight enclosure of (dx, dy)/√(dx² + dy²); [−1, 1] if the vector may be 0.

    dx/√(dx² + dy²) increases with dx, and tends to 0 as |dy| grows. So its maximum is at the
    largest dx, with the smallest |dy| if that dx is positive, else with the largest |dy|.
    """
    return dx.component(dy), dy.component(dx)


def atan2(sine: Intervals, cosine: Intervals, side: int | None = None) -> Intervals:
    """The angle of the vector (cosine, sine), in [−π, π].

    Vectors may meet the branch cut, the ray of negative cosines and sine 0. Then the result is NaN
    if ``side`` is None; the angles of the vectors with a sine ≥ 0 if it is 1, ≤ 0 if it is −1; and
    [−π, π] if it is 0. Over a rectangle that does not meet the cut the extremes are at corners,
    because the angle is monotonic along each side.
    """
    return sine.angle(cosine, side)


def _across(x: FloatArray, y: FloatArray, side: int | None) -> FloatArray:
    """Ends of angles of rectangles that meet the branch cut, for :func:`atan2`; x and y are lower
    and upper ends, (2, …).
    """
    if side is None:
        return np.full(x.shape, np.nan)
    largest = np.full(x.shape[1:], rounded_outward(np.array(np.pi)))
    if side == 0:
        return np.stack([largest, largest])
    # On this side the smallest |angle| is at the largest cosine. + 0.0 turns −0, which would be on
    # the other side, into 0.
    far = np.maximum(y[1] if side > 0 else -y[0], 0.0) + 0.0
    smallest = -_bounded_by_pi(-np.minimum(np.arctan2(far, x[1]), np.arctan2(0.0, x[1])))
    return np.stack([-smallest, largest] if side > 0 else [largest, -smallest])


def _bounded_by_pi(ends: FloatArray) -> FloatArray:
    """Upper bounds of angles computed by NumPy, at most that of π."""
    return np.minimum(rounded_outward(ends, FUNCTION_ULPS), rounded_outward(np.array(np.pi)))
