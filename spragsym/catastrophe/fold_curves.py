"""Every fold curve in the plane of θ₀ and μ₀, by solving for all folds at each θ and joining what belongs together.

At a given direction θ of the spring the two fold relations are lines in μ₀. Eliminating it leaves a conic in (cos θ₀, sin θ₀),
hence a quartic in v = tan(θ₀/2): all folds in 0 < θ₀ < π are its positive roots. As θ moves they never cross, since two meet
only where they vanish together, so that the k-th root of one θ belongs to the k-th of the next. Where their number changes the
place is found by bisection and the two that end there are joined. No starting point, no step size.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from ..generated import catastrophe as _catastrophe
from ..parameters import FloatArray
from .companion import eigenvalues, polished
from .fixed import Fixed

#: Values of θ on which curves are looked for before their shape says where more are needed.
_COARSE = 512
#: How close to 0 and π the first and last θ are; equilibria in contact have 0 < θ < π.
_ENDS = 1e-7


@dataclass(frozen=True)
class Strand:
    """One curve of folds, points in order."""

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray


# ------------------------------------------------------------------------------------------- folds at a given θ


def _conic(theta: FloatArray, fixed: Fixed) -> tuple[FloatArray, ...]:
    return _catastrophe.fold_conic(np.cos(theta), np.sin(theta), *fixed)


def quartics(theta: FloatArray, fixed: Fixed) -> FloatArray:
    """Coefficients of the quartic in v = tan(θ₀/2) at each θ, lowest power first, the largest of size 1."""
    e0, e1, e2, ec = _conic(theta, fixed)
    coefficients = np.stack([e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec], axis=-1)
    return coefficients / np.abs(coefficients).max(axis=-1, keepdims=True)  # type: ignore[no-any-return]  # NumPy gives Any


def _ends(theta: FloatArray, fixed: Fixed) -> tuple[FloatArray, FloatArray, float]:
    """Two values, of which one vanishes where a root passes v = 0 and one where it passes the other end; and this end.

    The other end is v = ∞ (θ₀ = π); for α = 0, where θ₀ and π − θ₀ are folds together, only θ₀ ≤ π/2 is followed, up to v = 1.
    """
    if fixed.alpha == 0:
        e0, e1, e2, _ = _conic(theta, fixed)
        return e0, e0 + e1 + e2, 1.0
    coefficients = quartics(theta, fixed)
    return coefficients[..., 0], coefficients[..., 4], np.inf


def indicator(theta: FloatArray, fixed: Fixed) -> FloatArray:
    """A number that changes sign where two roots meet."""
    if fixed.alpha == 0:
        e0, e1, e2, _ = _conic(theta, fixed)
        return -_discriminant_in_sine(e0, e1, e2) / (4 * np.abs(e0 * e2) + e1 * e1)
    return discriminant(quartics(theta, fixed))[0]


def _discriminant_in_sine(e0: FloatArray, e1: FloatArray, e2: FloatArray) -> FloatArray:
    """The same for e0 + e1 sin θ₀ + e2 sin² θ₀, which is the conic for α = 0."""
    return e1 * e1 - 4 * e0 * e2


def discriminant(coefficients: FloatArray) -> tuple[FloatArray, NDArray[np.int64]]:
    """Discriminant of each quartic over its own terms, and the number of real roots."""
    e0, e1, e2, e3, e4 = np.moveaxis(coefficients, -1, 0)
    P = 12 * e4 * e0 - 3 * e3 * e1 + e2 * e2
    Q = 72 * e4 * e2 * e0 + 9 * e3 * e2 * e1 - 27 * (e4 * e1 * e1 + e0 * e3 * e3) - 2 * e2**3
    value = (4 * P**3 - Q * Q) / (4 * np.abs(P) ** 3 + Q * Q)
    all_real = (8 * e4 * e2 < 3 * e3 * e3) & (
        64 * e4**3 * e0 - 16 * (e4 * e2) ** 2 + 16 * e4 * e3 * e3 * e2 - 16 * e4 * e4 * e3 * e1 - 3 * e3**4 < 0
    )
    return value, np.where(value < 0, 2, np.where(all_real, 4, 0))


def positive_roots(theta: FloatArray, fixed: Fixed) -> tuple[FloatArray, NDArray[np.int64]]:
    """Roots 0 < v < ∞ (v < 1 for α = 0) at each θ, ascending, NaN beyond their number; and that number."""
    if fixed.alpha == 0:
        e0, e1, e2, _ = _conic(theta, fixed)
        large = -0.5 * (e1 + np.copysign(np.sqrt(_discriminant_in_sine(e0, e1, e2)), e1))
        sines = np.stack([large / e2, e0 / large], axis=-1)
        values = np.sort(np.where((sines > 0) & (sines < 1), np.tan(0.5 * np.arcsin(sines)), np.nan), axis=-1)
        return values, np.count_nonzero(values > 0, axis=-1)
    coefficients = quartics(theta, fixed)
    _, real = discriminant(coefficients)
    roots = eigenvalues(coefficients)
    # The discriminant says how many roots are real: keep this number of them, those closest to the real axis.
    order = np.argsort(np.abs(roots.imag) / (1e-300 + np.abs(roots)), axis=-1)
    values = np.take_along_axis(roots.real, order, axis=-1)
    values[(np.arange(4) >= real[..., None]) | ~(values > 0)] = np.nan
    values = polished(coefficients, np.sort(values, axis=-1))
    return values, np.count_nonzero(values > 0, axis=-1)


def friction(theta: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    """μ₀ of the fold at (θ, θ₀), from the relation that does not lose it: the first has the factor cos θ."""
    c = np.cos(theta)
    u1, w1, u2, w2 = _catastrophe.fold_lines_mu0(c, np.sin(theta), np.cos(theta0), np.sin(theta0), *fixed)
    return np.where(np.abs(c) > 0.3, -u1 / w1, -u2 / w2)  # type: ignore[no-any-return]  # NumPy gives Any


# ----------------------------------------------------------------------------------------------------- strands


def strands(fixed: Fixed, n: int) -> list[Strand]:
    """All curves of folds with 0 < θ, θ₀ < π and μ₀ ≥ 0, over about ``n`` values of θ.

    Folds with 0 < θ ≤ π/2 and friction of either sign are all there are: (θ, θ₀, μ) → (π − θ, π − θ₀, −μ) gives the rest.
    """
    with np.errstate(all="ignore"):
        coarse = _with_hidden(np.linspace(_ENDS, 0.5 * np.pi, _COARSE), fixed)
        found = _trace(_refined(coarse, fixed, n), fixed)
        parts = [part for strand in found for part in _one_sign(strand, fixed, 1.0)]
        mirrored = [_mirrored(part) for strand in found for part in _one_sign(strand, fixed, -1.0)]
        if fixed.alpha == 0:  # where sin θ f + cos θ f′ = 0 and f = 0 leave no negative friction at cos θ > 0
            parts += [Strand(part.theta, np.pi - part.theta0, part.mu0) for part in parts]
        return _joined(parts, mirrored)


def _with_hidden(theta: FloatArray, fixed: Fixed) -> FloatArray:
    """Add θ where roots exist between two neighbours that don't show them: zoom in on where the indicator nears zero."""
    added = []
    value = indicator(theta, fixed)
    near = np.abs(value)
    dips = (near[1:-1] <= near[:-2]) & (near[1:-1] <= near[2:]) & (np.sign(value[:-2]) == np.sign(value[1:-1]))
    dips &= np.sign(value[1:-1]) == np.sign(value[2:])
    spans = np.stack([theta[:-2], theta[2:]], axis=-1)[dips]
    for _ in range(6):
        if not spans.size:
            break
        fine = np.linspace(spans[:, 0], spans[:, 1], 33, axis=-1)
        value = indicator(fine, fixed)
        crossed = np.sign(value) != np.sign(value[:, :1])
        hidden = crossed.any(axis=-1)
        added += [row[flags] for row, flags in zip(fine[hidden], crossed[hidden], strict=True)]
        rows, before = np.flatnonzero(~hidden), np.argmin(np.abs(value[~hidden, 1:-1]), axis=-1)
        spans = np.stack([fine[rows, before], fine[rows, before + 2]], axis=-1)
    return np.unique(np.concatenate([theta, *added]))


def _refined(theta: FloatArray, fixed: Fixed, n: int) -> FloatArray:
    """More values of θ, ``n`` in all, where the curves are long in the plane of θ₀ and μ₀/(1 + |μ₀|)."""
    roots, _ = positive_roots(theta, fixed)
    theta0 = 2 * np.arctan(roots)
    mu0 = friction(theta[:, None], theta0, fixed)
    length = np.hypot(np.diff(theta0, axis=0) / np.pi, np.diff(mu0 / (1 + np.abs(mu0)), axis=0))
    length = np.where(length < 0.5, length, 0.0).max(axis=-1)  # NaN, and steps from one curve to another, have no length
    weight = length / max(float(length.sum()), 1e-300) + 0.5 * np.diff(theta) / (theta[-1] - theta[0])
    cumulative = np.concatenate([[0.0], np.cumsum(weight)])
    fresh = np.interp(np.linspace(0, cumulative[-1], max(n - theta.size, 0)), cumulative, theta)
    return np.unique(np.concatenate([theta, fresh]))


#: Chunks of points (θ, v), each of shape (2, k), in order; a curve grows at both ends.
_Curve: TypeAlias = "deque[FloatArray]"
#: A curve, and whether it is its last end that is open.
_End: TypeAlias = tuple[_Curve, bool]


def _trace(theta: FloatArray, fixed: Fixed) -> list[Strand]:
    """Join the roots of neighbouring θ, and two open ends where they are born or vanish together."""
    roots, number = positive_roots(theta, fixed)
    finished: list[_Curve] = []
    open_ends: list[_End] = [(deque(), True) for _ in range(number[0])]
    # Where their number stays and something happens, a root passes one end and another root the other end: either tells.
    passes = np.diff(np.sign(_ends(theta, fixed)[0])) != 0
    starts = [0, *(np.flatnonzero((np.diff(number) != 0) | passes) + 1)]
    for begin, end in zip(starts, [*starts[1:], theta.size], strict=True):
        if begin:
            cell = float(theta[begin - 1]), float(theta[begin]), int(number[begin - 1]), int(number[begin])
            open_ends = _change(*cell, fixed, open_ends, finished)
        for (curve, last), values in zip(open_ends, roots[begin:end].T, strict=False):
            _grow(curve, last, np.stack([theta[begin:end], values]))
    finished += {id(curve): curve for curve, _ in open_ends}.values()
    return [_strand(curve, fixed) for curve in finished if curve]


def _strand(curve: _Curve, fixed: Fixed) -> Strand:
    theta, v = np.concatenate(list(curve), axis=-1)
    theta0 = 2 * np.arctan(v)
    return Strand(theta, theta0, friction(theta, theta0, fixed))


def _grow(curve: _Curve, last: bool, points: FloatArray) -> None:
    """Add points at the open end; they are given by growing θ."""
    if last:
        curve.append(points)
    else:
        curve.appendleft(points[:, ::-1])


def _reversed(curve: _Curve) -> _Curve:
    return deque(chunk[:, ::-1] for chunk in reversed(curve))


def _change(
    low: float, high: float, before: int, after: int, fixed: Fixed, open_ends: list[_End], finished: list[_Curve]
) -> list[_End]:
    """Carry the open ends over a cell of θ in which the number of roots goes from ``before`` to ``after``.

    By what changes sign there: one of the two end values, or the indicator, is one event; a cell with more of them is halved.
    """
    passes = sum(bool(end[0] * end[1] <= 0) for end in _ends(np.array([low, high]), fixed)[:2])
    if before == after and not passes:
        return open_ends
    meets = _meeting(low, high, fixed) is not None
    middle = 0.5 * (low + high)
    if not low < middle < high or (passes + meets == 1 and abs(after - before) == 1 + meets):
        if before == after:
            return open_ends
        if abs(after - before) == 1:
            return _through_an_end(low, high, fixed, open_ends, finished, enters=after > before)
        return _pair(low, high, max(before, after), fixed, open_ends, finished, born=after > before)
    between = _number(middle, fixed)
    open_ends = _change(low, middle, before, between, fixed, open_ends, finished)
    return _change(middle, high, between, after, fixed, open_ends, finished)


def _number(theta: float, fixed: Fixed) -> int:
    return int(positive_roots(np.array([theta]), fixed)[1][0])


def _meeting(low: float, high: float, fixed: Fixed) -> float | None:
    """A θ between two others at which two roots meet, where the indicator says that an odd number of pairs do."""

    def value(theta: float) -> float:
        return float(indicator(np.array([theta]), fixed)[0])

    if value(low) * value(high) > 0:
        return None
    return float(brentq(value, low, high, xtol=1e-15, rtol=1e-15))


def _through_an_end(
    low: float, high: float, fixed: Fixed, open_ends: list[_End], finished: list[_Curve], enters: bool
) -> list[_End]:
    """A root enters or leaves at θ₀ = 0 or at the other end, where one of the two end values changes sign."""
    at_zero, _, other = _ends(np.array([low, high]), fixed)
    first = bool(at_zero[0] * at_zero[1] <= 0)

    def value(theta: float) -> float:
        at_start, at_end, _ = _ends(np.array([theta]), fixed)
        return float((at_start if first else at_end)[0])

    theta = float(brentq(value, low, high, xtol=1e-15, rtol=1e-15)) if value(low) * value(high) <= 0 else low
    point = np.array([[theta], [0.0 if first else other]])
    if enters:
        end: _End = (deque([point]), True)
        return [end, *open_ends] if first else [*open_ends, end]
    if not open_ends:
        return open_ends
    (curve, last), rest = (open_ends[0], open_ends[1:]) if first else (open_ends[-1], open_ends[:-1])
    _grow(curve, last, point)
    if not any(other_curve is curve for other_curve, _ in rest):
        finished.append(curve)
    return rest


def _pair(
    low: float, high: float, number: int, fixed: Fixed, open_ends: list[_End], finished: list[_Curve], born: bool
) -> list[_End]:
    """Two roots are born or vanish together; ``number`` is how many there are with them."""
    meeting = _meeting(low, high, fixed)
    far = high if born else low
    many = far if meeting is None else meeting
    for power in range(-52, -20):  # a little on the side where there are more
        if _number(many, fixed) == number:
            break
        many = meeting + (far - meeting) * 2.0**power if meeting is not None else far
    roots, _ = positive_roots(np.array([many]), fixed)
    gaps = np.diff(roots[0]) / roots[0, 1:]
    if np.isnan(gaps).all():
        return open_ends
    place = int(np.nanargmin(gaps))
    point = np.array([[many], [roots[0, place]]])  # both, but for the root of a rounding error
    if born:
        fresh: _Curve = deque([point])
        return [*open_ends[:place], (fresh, False), (fresh, True), *open_ends[place:]]
    if place + 1 >= len(open_ends):
        return open_ends
    (one, one_last), (two, two_last) = open_ends[place : place + 2]
    rest = open_ends[:place] + open_ends[place + 2 :]
    _grow(one, one_last, point)
    if one is two:  # an isola: its two ends meet
        one.append(one[0][:, :1])
        finished.append(one)
        return rest
    whole = deque([*(one if one_last else _reversed(one)), *(_reversed(two) if two_last else two)])
    rest = [(whole, curve is two) if curve is one or curve is two else (curve, last) for curve, last in rest]
    if not any(curve is whole for curve, _ in rest):
        finished.append(whole)
    return rest


# ------------------------------------------------------------------------------------------------------ pieces


def _one_sign(strand: Strand, fixed: Fixed, side: float) -> list[Strand]:
    """The parts of a strand with ``side`` · μ₀ ≥ 0, each cut where μ₀ = 0."""
    good = side * strand.mu0 >= 0
    changes = np.flatnonzero(good[1:] != good[:-1]) + 1
    parts = []
    for begin, end in zip([0, *changes], [*changes, good.size], strict=True):
        if not good[begin]:
            continue
        part = Strand(strand.theta[begin:end], strand.theta0[begin:end], strand.mu0[begin:end])
        before = _zero_friction(strand, begin - 1, begin, fixed) if begin else None
        after = _zero_friction(strand, end, end - 1, fixed) if end < good.size else None
        chunks = [chunk for chunk in (before, part, after) if chunk is not None]
        if sum(chunk.theta.size for chunk in chunks) > 1:
            parts.append(_concatenated(chunks))
    return parts


def _concatenated(chunks: list[Strand]) -> Strand:
    return Strand(*(np.concatenate([getattr(chunk, name) for chunk in chunks]) for name in ("theta", "theta0", "mu0")))


def _zero_friction(strand: Strand, outer: int, inner: int, fixed: Fixed) -> Strand | None:
    """Where a strand crosses μ₀ = 0 between two of its points; nothing where it passes through infinity instead."""
    if min(abs(strand.mu0[outer]), abs(strand.mu0[inner])) > 1e3:
        return None
    far, near = float(strand.theta[outer]), float(strand.theta[inner])
    ends = float(strand.theta0[outer]), float(strand.theta0[inner])

    def angle(theta: float) -> float:
        expected = ends[1] + (ends[0] - ends[1]) * (theta - near) / (far - near)
        angles = 2 * np.arctan(positive_roots(np.array([theta]), fixed)[0][0])
        return float(angles[np.nanargmin(np.abs(angles - expected))])

    def value(theta: float) -> float:
        return float(friction(np.array([theta]), np.array([angle(theta)]), fixed)[0])

    if value(far) * value(near) >= 0:
        return None
    theta = float(brentq(value, far, near, xtol=1e-15, rtol=1e-15))
    return Strand(np.array([theta]), np.array([angle(theta)]), np.array([0.0]))


def _mirrored(strand: Strand) -> Strand:
    return Strand(np.pi - strand.theta, np.pi - strand.theta0, -strand.mu0 + 0.0)


def _joined(parts: list[Strand], others: list[Strand]) -> list[Strand]:
    """Join pieces whose ends are one point: those of either side of θ = π/2, and for α = 0 those of either side of θ₀ = π/2."""
    pieces = [*parts, *others]
    done: list[Strand] = []
    while pieces:
        piece = pieces.pop(0)
        for index, other in enumerate(pieces):
            whole = _end_to_end(piece, other)
            if whole is not None:
                pieces[index] = whole
                break
        else:
            done.append(piece)
    return done


def _end_to_end(one: Strand, two: Strand) -> Strand | None:
    for first in (one, _backward(one)):
        for second in (two, _backward(two)):
            a = np.array([first.theta[-1], first.theta0[-1], first.mu0[-1] / (1 + first.mu0[-1])])
            b = np.array([second.theta[0], second.theta0[0], second.mu0[0] / (1 + second.mu0[0])])
            if first.mu0[-1] > 0 and np.abs(a - b).max() < 1e-6:
                return _concatenated([first, second])
    return None


def _backward(strand: Strand) -> Strand:
    return Strand(strand.theta[::-1], strand.theta0[::-1], strand.mu0[::-1])
