"""Functions of arrays of intervals beside those that are methods of theirs."""

from __future__ import annotations

import numpy as np

from .interval_arrays import Intervals, raised

#: Bound on the absolute error of NumPy's sine and cosine, for arguments up to :data:`LARGEST_ANGLE`.
TRIGONOMETRIC_ERROR = 2.0**-50
#: Beyond it cosine and sine are [−1, 1].
LARGEST_ANGLE = 1e5
#: More than the error of an angle over 2π: an extremum so near to an end counts as inside, where it hardly widens anything.
TURN_ERROR = 1e-10


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
    # Three roundings, of a sum of squares, and two more: less than 4 units, where nothing underflows.
    values = raised(ends / np.sqrt(ends * ends + other * other), 4)
    known = (np.maximum(np.abs(ends), other) > 1e-140) & (values <= 1)
    return Intervals(np.where(known, values, 1.0))
