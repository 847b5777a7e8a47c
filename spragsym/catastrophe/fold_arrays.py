"""All folds along one parameter for many points at once, in float64 with proof; points that float64 can't decide are marked.

The same folds as of :mod:`spragsym.catastrophe.fold_proofs`, by the same polynomials in t = tan(θ/2): their positive roots are
isolated by :mod:`spragsym.exact.bernstein`, and every sign that says what a fold is carries a bound on its error.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..exact import bernstein
from ..exact.half_angle import on_circle
from ..exact.rounded import Rounded, cosine_and_sine
from ..generated import catastrophe as _catastrophe
from ..parameters import NAMES, FloatArray
from ..statics import kernel

_sextic = inspect.unwrap(_catastrophe.fold_sextic)
_changes = inspect.unwrap(_catastrophe.f_changes)
_cubics = inspect.unwrap(_catastrophe.fold_cubics)
_sine = inspect.unwrap(_catastrophe.fold_sine)
_angles = inspect.unwrap(_catastrophe.fold_angles)


@dataclass(frozen=True)
class FoldArrays:
    """Folds in contact of many points, in no order: the point of each, and what :class:`~.fold_points.Turn` says of it.

    ``value`` and ``t`` = tan(θ/2) carry proved bounds; ``best`` is the same as ``value`` with less uncertainty. Of points in
    ``undecided`` nothing is listed.
    """

    row: NDArray[np.intp]
    value: Rounded
    best: Rounded
    t: Rounded
    side: NDArray[np.int8]
    upper: NDArray[np.bool_]
    undecided: NDArray[np.bool_]


def folds(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """All folds along ``vary`` of ``size`` points, with the varying parameter in its range.

    Parameters
    ----------
    vary : str
        One of the six.
    given : mapping
        The other parameters, each an array of ``size`` or one number.
    """
    with np.errstate(all="ignore"):
        return _in_theta0(given, size) if vary == "theta0" else _along(vary, given, size)


def _along(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    cos0, sin0 = cosine_and_sine(given["theta0"])
    values = [Rounded(given[name]) if name != vary else Rounded(np.float64(0.0)) for name in NAMES[1:]]
    without = kernel.f_coefficients(cos0, sin0, *values, 1)
    change = [_as_rounded(part) for part in _changes(cos0, sin0, *values)[NAMES.index(vary)]]
    roots = bernstein.positive_roots([_as_rounded(part) for part in _sextic(*without, *change)], size)
    c, s, _ = on_circle(roots.t)
    at_zero = kernel.f(c, s, *(_rows(part, roots.row) for part in without))
    slope = kernel.f(c, s, *(_rows(part, roots.row) for part in change))
    value = -at_zero / slope
    here = {name: one.rows(roots.row) for name, one in zip(NAMES[1:], values, strict=True)} | {vary: value}
    upper = roots.rising * slope.sign()
    best = _settled(roots.t, value, [_rows(part, roots.row) for part in (*without, *change)])
    return _kept(roots, value, best, (c, s, cos0.rows(roots.row), sin0.rows(roots.row)), here, -roots.rising, upper)


def _settled(t: Rounded, value: Rounded, parts: list[Any]) -> Rounded:
    """The value at the middle of t, and how far it can move over the interval: not far, since dv/dθ = −(f′ f_v − f f_v′)/f_v²."""
    c, s, _ = on_circle(Rounded(t.value))
    middle = -(kernel.f(c, s, *parts[:4]) / kernel.f(c, s, *parts[4:]))
    c, s, _ = on_circle(t)
    before, slope = kernel.f(c, s, *parts[:4]), kernel.f(c, s, *parts[4:])
    change = kernel.f_slope(c, s, *parts[:4]) * slope - before * kernel.f_slope(c, s, *parts[4:])
    return Rounded(middle.value, middle.error + _turn(t) * _size(change / (slope * slope)))


def _turn(t: Rounded) -> FloatArray:
    """How far θ = 2 atan t is from its middle."""
    return np.asarray(2.01 * t.error)


def _size(number: Rounded) -> FloatArray:
    """The largest size that it may have."""
    return np.asarray(1.01 * (np.abs(number.value) + number.error))


def _in_theta0(given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    values = [Rounded(given[name]) for name in NAMES[1:]]
    mu0, kappa, alpha, sigma, beta = values
    roots = bernstein.positive_roots(_squares(values), size)
    here = {name: one.rows(roots.row) for name, one in zip(NAMES[1:], values, strict=True)}
    c, s, _ = on_circle(roots.t)
    sin0 = _sine(c, s, *here.values())
    cos0 = _angles(c, s, *here.values())[1]
    trig = kernel.f_coefficients(cos0, sin0, *here.values(), 1)
    change = kernel.f(c, s, *(_as_rounded(part) for part in _changes(cos0, sin0, *here.values())[0]))
    curvature = kernel.f_curvature(c, s, *trig).sign()
    angle = np.arctan2(sin0.value, cos0.value)
    # The true point lies on the unit circle, at most this far from the computed one.
    distance = np.hypot(sin0.error, cos0.error)
    theta0 = Rounded(angle, np.where(distance < 0.1, 1.01 * distance, 4.0) + 1e-15)
    best = _turned_back(roots.t, theta0, here, change, kernel.f_slope(c, s, *trig))
    return _kept(roots, theta0, best, (c, s, cos0, sin0), here, -curvature * change.sign(), curvature)


def _turned_back(t: Rounded, theta0: Rounded, here: Mapping[str, Rounded], change: Rounded, slope: Rounded) -> Rounded:
    """θ₀ from f = 0 at the middle of t by Newton's rule, and how far it moves: dθ₀/dθ = −f′/f_θ₀, and f′ = 0 on a fold."""
    c, s, _ = on_circle(Rounded(t.value))
    cos0, sin0 = cosine_and_sine(theta0.value)
    step = kernel.f(c, s, *kernel.f_coefficients(cos0, sin0, *here.values(), 1)) / change
    # |∂²f/∂θ₀²| is at most the size of what sin θ₀ and cos θ₀ stand with in f.
    mu0, _, alpha, sigma, beta = here.values()
    bend = _size((alpha + sigma) * (beta + 1) + alpha * (beta + 1 + sigma) + mu0 * sigma)
    least = np.abs(change.value) - change.error
    drift = (bend * theta0.error**2 + _turn(t) * _size(slope)) / np.where(least > 0, least, 0.0)
    return Rounded(theta0.value - step.value, step.error + drift + 1e-15)


def _squares(values: list[Rounded]) -> list[Rounded]:
    """(1 + t²)⁶ (p B q α)² (sin² θ₀ + cos² θ₀ − 1), by powers of t."""
    _, _, alpha, sigma, beta = values
    width = alpha * (beta + 1 + sigma)
    scale = (alpha + sigma) * (beta + 1) * width
    sines, cosines = ([_as_rounded(part) for part in row] for row in _cubics(*values))
    powers = _product(sines, sines)
    others = _product(cosines, cosines)
    result = [width * width * one + other for one, other in zip(powers, others, strict=True)]
    for half, binomial in enumerate((1, 6, 15, 20, 15, 6, 1)):
        result[2 * half] = result[2 * half] - scale * scale * binomial
    return result


def _product(one: list[Rounded], other: list[Rounded]) -> list[Rounded]:
    result: list[Any] = [0] * (len(one) + len(other) - 1)
    for i, left in enumerate(one):
        for j, right in enumerate(other):
            result[i + j] = left * right + result[i + j]
    return result


def _kept(
    roots: bernstein.Roots,
    value: Rounded,
    best: Rounded,
    angles: tuple[Rounded, Rounded, Rounded, Rounded],
    here: Mapping[str, Rounded],
    side: NDArray[np.int8],
    upper: NDArray[np.int8],
) -> FoldArrays:
    """Those in contact with the value in its range; a sign that is needed and open makes the point undecided."""
    L, _, y = kernel.state(*angles, here["kappa"], here["sigma"], here["beta"], 1)
    tests = [value.sign(), L.sign(), -y.sign(), angles[3].sign()]
    out = np.logical_or.reduce([test < 0 for test in tests])
    vague = np.logical_or.reduce([test == 0 for test in (*tests, side, upper)]) & ~out
    undecided = roots.undecided.copy()
    undecided[roots.row[vague]] = True
    keep = np.flatnonzero(~out & ~undecided[roots.row])
    return FoldArrays(
        roots.row[keep], value.rows(keep), best.rows(keep), roots.t.rows(keep), side[keep], upper[keep] > 0, undecided
    )


def _as_rounded(part: Any) -> Rounded:
    return part if isinstance(part, Rounded) else Rounded(np.float64(part))


def _rows(part: Any, index: NDArray[np.intp]) -> Any:
    return part.rows(index) if isinstance(part, Rounded) else part
