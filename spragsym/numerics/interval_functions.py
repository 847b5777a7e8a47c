"""Functions of arrays of intervals beside those that are methods of theirs."""

import numpy as np

from .interval_arrays import FUNCTION_ULPS, FloatArray, Intervals, raised

#: Bound on the absolute error of NumPy's sine and cosine, for arguments up to :data:`LARGEST_ANGLE`.
TRIGONOMETRIC_ERROR = 2.0**-50
#: Beyond it cosine and sine are [−1, 1].
LARGEST_ANGLE = 1e5
#: Around π.
PI = Intervals.between([np.pi], [np.nextafter(np.pi, 4.0)])
#: More than the error of an angle over 2π: an extremum so near to an end counts as inside, where it hardly widens anything.
TURN_ERROR = 1e-10

sqrt, exp, log, tanh, atan = Intervals.sqrt, Intervals.exp, Intervals.log, Intervals.tanh, Intervals.atan


def cos(angle: Intervals) -> Intervals:
    """Cosine."""
    return _wave(angle, np.cos, 0.0)


def sin(angle: Intervals) -> Intervals:
    """Sine."""
    return _wave(angle, np.sin, 0.25)


def _wave(angle: Intervals, function: np.ufunc, peak: float) -> Intervals:
    """A cosine that has its maxima at 2π (peak + n)."""
    low, high = angle.low, angle.high
    one, other = function(low), function(high)
    ends = np.stack([-np.minimum(one, other), np.maximum(one, other)]) + TRIGONOMETRIC_ERROR
    turns_low, turns_high = low / (2 * np.pi) - peak, high / (2 * np.pi) - peak
    unknown = ~((angle.magnitude <= LARGEST_ANGLE) & np.isfinite(one) & np.isfinite(other))
    for place, shift in ((1, 0.0), (0, 0.5)):
        inside = np.floor(turns_high + (shift + TURN_ERROR)) >= np.ceil(turns_low + (shift - TURN_ERROR))
        ends[place] = np.where(inside | unknown, 1.0, np.minimum(ends[place], 1.0))
    return Intervals(ends)


def length(dx: Intervals, dy: Intervals) -> Intervals:
    """√(dx² + dy²)."""
    square = (dx.squared() + dy.squared()).ends
    return Intervals(np.stack([np.minimum(square[0], 0.0), square[1]])).sqrt()


def unit_vector(dx: Intervals, dy: Intervals) -> tuple[Intervals, Intervals]:
    """Direction (dx, dy)/√(dx² + dy²), each component as narrow as it is; [−1, 1] where the vector may be 0.

    dx/√(dx² + dy²) grows with dx, and with |dy| it goes to 0: so it is largest at the largest dx, and there at the least |dy| if
    that dx is positive, at the largest if not.
    """
    return _component(dx, dy), _component(dy, dx)


def _component(along: Intervals, across: Intervals) -> Intervals:
    near, far = across.mignitude, across.magnitude
    ends = along.ends
    other = np.where(ends > 0, near, far)
    # Three roundings, of a sum of squares, and two more: less than 4 units, where nothing underflows or overflows.
    values = raised(ends / np.sqrt(ends * ends + other * other), 4)
    size = np.maximum(np.abs(ends), other)
    known = (size > 1e-140) & (size < 1e150) & (values <= 1)
    return Intervals(np.where(known, values, 1.0))


def atan2(sine: Intervals, cosine: Intervals, side: int | None = None) -> Intervals:
    """The angle of the vector (cosine, sine), from −π to π; NaN where the vectors meet the ray on which it jumps, or 0.

    With a ``side`` of 1 or −1 there the angles of vectors with a sine not negative or not positive, with 0 all. Over a rectangle
    that does not meet the ray the angle is least and greatest at corners: on each side it is monotone.
    """
    x, y = (np.stack([part.low, part.high]) for part in (cosine, sine))
    cut = ~((x[0] > 0) | (y[0] > 0) | (y[1] < 0))
    corners = np.stack([np.arctan2(y[j], x[i]) for i in (0, 1) for j in (0, 1)])
    ends = _bounded_by_pi(np.stack([-corners.min(axis=0), corners.max(axis=0)]))
    if cut.any():
        ends = np.where(cut, _across(x, y, side), ends)
    return Intervals(ends)


def _across(x: FloatArray, y: FloatArray, side: int | None) -> FloatArray:
    """Ends of angles of rectangles that meet the ray of negative cosines: x and y are lower and upper ends."""
    if side is None:
        return np.full(x.shape, np.nan)
    most = np.full(x.shape[1:], raised(np.array(np.pi)))
    if side == 0:
        return np.stack([most, most])
    # Of vectors with a sine of this sign the angle is least in size at the greatest cosine.
    far = np.maximum(y[1] if side > 0 else -y[0], 0.0)
    least = -_bounded_by_pi(-np.minimum(np.arctan2(far, x[1]), np.arctan2(0.0, x[1])))
    return np.stack([-least, most] if side > 0 else [most, -least])


def _bounded_by_pi(ends: FloatArray) -> FloatArray:
    """Upper bounds of angles that NumPy gives, none of which is larger than π."""
    return np.minimum(raised(ends, FUNCTION_ULPS), raised(np.array(np.pi)))
