"""All folds along one parameter for many points at once, in float64 with proof; points that float64 can't decide are marked.

The same folds as of :mod:`.folds`, by the same polynomials in t = tan(θ/2): their positive roots are isolated by
:mod:`spragsym.numerics.bernstein`, and every sign that says what a fold is carries a bound on its error.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ..models.parameters import NAMES, FloatArray
from ..numerics import balls, bernstein
from ..numerics.affine import Rounded, cosine_and_sine
from ..numerics.balls import Interval
from ..numerics.interval_arrays import BoolArray, IndexArray, Int8Array
from ..numerics.polynomials import on_circle
from . import kernel


@dataclass(frozen=True)
class FoldArrays:
    """Folds in contact of many points, in no order: the point of each, and what :class:`~.folds.Fold` says of it.

    ``value`` and ``t`` = tan(θ/2) carry proved bounds; ``best`` is the same as ``value`` with less uncertainty. Of points in
    ``undecided`` nothing is listed.
    """

    row: IndexArray
    value: Rounded
    best: Rounded
    t: Rounded
    side: Int8Array
    upper: BoolArray
    undecided: BoolArray

    def rows(self, index: IndexArray) -> FoldArrays:
        """Some of them."""
        value, best, t = (number.rows(index) for number in (self.value, self.best, self.t))
        return FoldArrays(self.row[index], value, best, t, self.side[index], self.upper[index], self.undecided)


def folds(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """All folds along one of the six of ``size`` points, in its range; the others are arrays of ``size`` or one number each."""
    with np.errstate(all="ignore"):
        return _in_theta0(given, size) if vary == "theta0" else _along(vary, given, size)


def _along(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    cos0, sin0 = cosine_and_sine(given["theta0"])
    values = [Rounded(given[name]) if name != vary else Rounded(np.float64(0.0)) for name in NAMES[1:]]
    without, change = kernel.f_along(vary, cos0, sin0, *values)
    change = _rounded(change)
    roots = bernstein.positive_roots(_rounded(kernel.fold_sextic(*without, *change)), size)
    c, s, _ = on_circle(roots.t)
    at_zero = kernel.f(c, s, *(_rows(part, roots.row) for part in without))
    slope = kernel.f(c, s, *(_rows(part, roots.row) for part in change))
    value = -at_zero / slope
    here = {name: one.rows(roots.row) for name, one in zip(NAMES[1:], values, strict=True)} | {vary: value}
    upper = roots.rising * slope.sign()
    old, new = ([_rows(part, roots.row) for part in parts] for parts in (without, change))

    def parts_at(v: Rounded) -> tuple[list[Any], list[Any]]:
        return [one + v * other for one, other in zip(old, new, strict=True)], new

    best = _sharpened(roots.t, value, parts_at)
    return _kept(roots, value, best, (c, s, cos0.rows(roots.row), sin0.rows(roots.row)), here, -roots.rising, upper)


def friction_sextic(given: Mapping[str, FloatArray]) -> list[Rounded]:
    """f′ f_μ₀ − f f_μ₀′ times (1 + t²)³ by powers of t = tan(θ/2): negative where μ₀ on the surface f = 0 rises with θ."""
    cos0, sin0 = cosine_and_sine(given["theta0"])
    values = [Rounded(given[name]) if name != "mu0" else Rounded(np.float64(0.0)) for name in NAMES[1:]]
    without, change = kernel.f_along("mu0", cos0, sin0, *values)
    return _rounded(kernel.fold_sextic(*without, *_rounded(change)))


def _in_theta0(given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """With α = 0 cos θ₀ drops out of f: θ₀ and π − θ₀ are folds together, where the second relation holds."""
    free = np.broadcast_to(given["alpha"] == 0, size)
    found = []
    for rows in (np.flatnonzero(~free), np.flatnonzero(free)):
        if rows.size:
            values = [Rounded(np.broadcast_to(given[name], size)[rows]) for name in NAMES[1:]]
            part = _with_alpha(values, rows.size) if not free[rows[0]] else _without_alpha(values, rows.size)
            found.append((rows, part))
    return _merged(found, size)


def _with_alpha(values: list[Rounded], size: int) -> FoldArrays:
    roots = bernstein.positive_roots(_squares(values), size)
    here = {name: one.rows(roots.row) for name, one in zip(NAMES[1:], values, strict=True)}
    c, s, _ = on_circle(roots.t)
    return _at_angles(roots, here, kernel.fold_angles(c, s, *here.values())[1], kernel.fold_sine(c, s, *here.values()))


def _without_alpha(values: list[Rounded], size: int) -> FoldArrays:
    _, cosines = kernel.fold_cubics(*values)
    roots = bernstein.positive_roots(_rounded(cosines), size)
    here = {name: one.rows(roots.row) for name, one in zip(NAMES[1:], values, strict=True)}
    c, s, _ = on_circle(roots.t)
    square = 1 - kernel.fold_sine(c, s, *here.values()) ** 2
    undecided = roots.undecided.copy()
    undecided[roots.row[square.sign() == 0]] = True
    keep = np.flatnonzero(square.sign() > 0)
    roots = bernstein.Roots(roots.row[keep], roots.t.rows(keep), roots.rising[keep], undecided)
    here = {name: one.rows(keep) for name, one in here.items()}
    cos0, sin0 = square.rows(keep).sqrt(), kernel.fold_sine(*on_circle(roots.t)[:2], *here.values())
    both = [(np.arange(size), _at_angles(roots, here, one, sin0)) for one in (cos0, -cos0)]
    return _merged(both, size)


def _merged(parts: list[tuple[IndexArray, FoldArrays]], size: int) -> FoldArrays:
    """Folds of several sets of points, each with the places of its points among ``size``."""
    undecided = np.zeros(size, dtype=np.bool_)
    for rows, part in parts:
        undecided[rows[part.undecided]] = True

    def joined(name: str) -> Any:
        every = [getattr(part, name) for _, part in parts]
        if isinstance(every[0], Rounded):
            return Rounded(*(np.concatenate([getattr(one, end) for one in every]) for end in ("value", "error")))
        return np.concatenate(every)

    row = np.concatenate([rows[part.row] for rows, part in parts])
    value, best, t, side, upper = map(joined, ("value", "best", "t", "side", "upper"))
    every = FoldArrays(row, value, best, t, side, upper, undecided)
    return every.rows(np.flatnonzero(~undecided[row]))


def _at_angles(roots: bernstein.Roots, here: Mapping[str, Rounded], cos0: Rounded, sin0: Rounded) -> FoldArrays:
    c, s, _ = on_circle(roots.t)
    trig = kernel.f_coefficients(cos0, sin0, *here.values(), 1)
    change = kernel.f(c, s, *_rounded(kernel.f_changes(cos0, sin0, *here.values())[0]))
    curvature = kernel.f_curvature(c, s, *trig).sign()
    angle = np.arctan2(sin0.value, cos0.value)
    # The true point lies on the unit circle, at most this far from the computed one.
    distance = np.hypot(sin0.error, cos0.error)
    theta0 = Rounded(angle, np.where(distance < 0.1, 1.01 * distance, 4.0) + 1e-15)

    def parts_at(v: Rounded) -> tuple[list[Any], list[Any]]:
        cos_v, sin_v = cosine_and_sine(v.value)
        at = [Rounded(one.value, one.error + v.error) for one in (cos_v, sin_v)]
        return [*kernel.f_coefficients(*at, *here.values(), 1)], _rounded(kernel.f_changes(*at, *here.values())[0])

    # Twice as wide, so that the surface beside the fold is in it too.
    best = _sharpened(roots.t, Rounded(theta0.value, 2 * theta0.error), parts_at)
    return _kept(roots, theta0, best, (c, s, cos0, sin0), here, -curvature * change.sign(), curvature)


def _sharpened(t: Rounded, value: Rounded, parts_at: Callable[[Rounded], tuple[list[Any], list[Any]]]) -> Rounded:
    """The value v on a fold from f = f′ = 0, by Newton's rule, with a bound on its error.

    ``parts_at`` gives the coefficients of f and of f_v. On the surface f = 0 is dv/dθ = −f′/f_v, which is 0 on the fold: from a
    direction that is off by ρ ≤ |f′|/|f″| v is off by ρ (|f′| + |f″| ρ)/|f_v| at most. Where that can't be told, infinite.
    """
    low, high = t.value - t.error, t.value + t.error
    at, v = t.value, value.value
    for _ in range(3):
        c, s, scale = on_circle(at)
        trig, change = ([_plain(part) for part in parts] for parts in parts_at(Rounded(v)))
        v = v - kernel.f(c, s, *trig) / kernel.f(c, s, *change)
        at = np.clip(at - 0.5 * scale * kernel.f_slope(c, s, *trig) / kernel.f_curvature(c, s, *trig), low, high)
    c, s, _ = on_circle(Rounded(at))
    trig, change = parts_at(value)
    cross = kernel.f_slope(*on_circle(t)[:2], *change)
    curvature = kernel.f_curvature(*on_circle(t)[:2], *trig)
    along = kernel.f(c, s, *change)
    on_surface = Rounded(v) - kernel.f(c, s, *parts_at(Rounded(v))[0]) / along
    slope = _size(kernel.f_slope(c, s, *parts_at(on_surface)[0]))
    least = np.abs(along.value) - along.error
    bend = np.abs(curvature.value) - curvature.error - _size(cross) * slope / least
    off = slope / bend
    drift = off * (slope + _size(curvature) * off) / least
    inside = (np.abs(on_surface.value - value.value) + on_surface.error <= value.error) & (least > 0) & (bend > 0)
    return Rounded(on_surface.value, np.where(inside, on_surface.error + 1.01 * drift, np.inf))


def _plain(part: Any) -> Any:
    return part.value if isinstance(part, Rounded) else part


def _size(number: Rounded) -> FloatArray:
    """The largest size that it may have."""
    return np.asarray(1.01 * (np.abs(number.value) + number.error))


def _squares(values: list[Rounded]) -> list[Rounded]:
    """(1 + t²)⁶ (p B q α)² (sin² θ₀ + cos² θ₀ − 1), by powers of t."""
    _, _, alpha, sigma, beta = values
    width = alpha * (beta + 1 + sigma)
    scale = (alpha + sigma) * (beta + 1) * width
    sines, cosines = map(_rounded, kernel.fold_cubics(*values))
    powers, others = _square(sines), _square(cosines)
    result = [width * width * one + other for one, other in zip(powers, others, strict=True)]
    for half, binomial in enumerate((1, 6, 15, 20, 15, 6, 1)):
        result[2 * half] = result[2 * half] - scale * scale * binomial
    return result


def _square(one: list[Rounded]) -> list[Rounded]:
    """The square of a polynomial, each pair of different powers multiplied once."""
    result: list[Any] = [0] * (2 * len(one) - 1)
    for i, left in enumerate(one):
        result[2 * i] = left * left + result[2 * i]
        double = left + left
        for j in range(i + 1, len(one)):
            result[i + j] = double * one[j] + result[i + j]
    return result


def _kept(
    roots: bernstein.Roots,
    value: Rounded,
    best: Rounded,
    angles: tuple[Rounded, Rounded, Rounded, Rounded],
    here: Mapping[str, Rounded],
    side: Int8Array,
    upper: Int8Array,
) -> FoldArrays:
    """Candidates in contact with the value in its range; a sign that is needed and open makes the point undecided."""
    L, _, y = kernel.state(*angles, here["kappa"], here["sigma"], here["beta"], 1)
    tests = [value.sign(), L.sign(), -y.sign(), angles[3].sign()]
    out = functools.reduce(np.logical_or, [test < 0 for test in tests])
    vague = functools.reduce(np.logical_or, [test == 0 for test in (*tests, side, upper)]) & ~out
    undecided = roots.undecided.copy()
    undecided[roots.row[vague]] = True
    every = FoldArrays(roots.row, value, best, roots.t, side, upper > 0, undecided)
    return every.rows(np.flatnonzero(~out & ~undecided[roots.row]))


def _rounded(parts: Iterable[Any]) -> list[Rounded]:
    return [part if isinstance(part, Rounded) else Rounded(np.float64(part)) for part in parts]


def _rows(part: Any, index: IndexArray) -> Any:
    return part.rows(index) if isinstance(part, Rounded) else part


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
