"""Every fold curve in the plane of θ₀ and μ₀, by solving for all folds at each θ and joining what belongs together.

At a given direction θ of the spring the two fold relations are lines in μ₀. Eliminating it leaves a conic in (cos θ₀, sin θ₀),
hence a quartic in v = tan(θ₀/2): all folds in 0 < θ₀ < π are its positive roots. As θ moves they never cross, since two meet
only where they vanish together, so that the k-th root of one θ belongs to the k-th of the next. Where their number changes, and
what it is, is proved (``fold_events``); float64 only draws what is there.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray
from ...numerics.companion_roots import eigenvalues, polished
from .fixed_parameters import Fixed
from .fold_events import Stretch, fold_polynomial, stretches

#: Values of θ on which curves are looked at before their shape says where more are needed.
_COARSE = 512
#: How close to 0 the first θ is, if no event is closer; equilibria in contact have 0 < θ < π.
_FIRST = 1e-7


@dataclass(frozen=True)
class Strand:
    """One curve of folds, points in order."""

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray


# ------------------------------------------------------------------------------------------- folds at a given θ


def positive_roots(theta: FloatArray, number: int, fixed: Fixed) -> FloatArray:
    """v = tan(θ₀/2) > 0 (≤ 1 for α = 0) of the folds at each θ, of which there are ``number``: a column each, ascending."""
    coefficients = np.stack(np.broadcast_arrays(*fold_polynomial((np.cos(theta), np.sin(theta)), fixed)), axis=-1)
    roots = eigenvalues(coefficients)
    # Rounding moves roots off the real axis, and beyond the ends: those that lie closest to where they must are the ones.
    beyond = roots.real - np.clip(roots.real, 0.0, np.inf if fixed.alpha else 1.0)
    nearest = np.argsort(np.hypot(roots.imag, beyond) / (1e-300 + np.abs(roots)), axis=-1)[..., :number]
    values = polished(coefficients, np.sort(np.take_along_axis(roots.real, nearest, axis=-1), axis=-1))
    return values if fixed.alpha else np.tan(0.5 * np.arcsin(np.clip(values, 0.0, 1.0)))


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
    parts = stretches(fixed)
    events = [part.low for part in parts]
    with np.errstate(all="ignore"):
        found = _trace(parts, _refined(parts, fixed, n), fixed)
        ahead = [piece for strand in found for piece in _one_sign(strand, events, fixed, positive=True)]
        mirrored = [_mirrored(piece) for strand in found for piece in _one_sign(strand, events, fixed, positive=False)]
        if fixed.alpha == 0:  # where sin θ f + cos θ f′ = 0 and f = 0 leave no negative friction at cos θ > 0
            ahead += [Strand(piece.theta, np.pi - piece.theta0, piece.mu0) for piece in ahead]
        return _joined(ahead, mirrored)


def _by_stretch(parts: list[Stretch], theta: FloatArray) -> list[FloatArray]:
    """The values in each stretch, ascending, one inside of it among them: between two neighbours there is one event at most."""
    ends = [*(part.high for part in parts[:-1]), np.inf]  # the last θ may be π/2
    values = np.unique([*theta, *(part.inside for part in parts)])
    return [values[(part.low < values) & (values < end)] for part, end in zip(parts, ends, strict=True)]


def _refined(parts: list[Stretch], fixed: Fixed, n: int) -> list[FloatArray]:
    """θ in each stretch, ``n`` in all, more where the curves are long in the plane of θ₀ and μ₀/(1 + |μ₀|)."""
    coarse = _by_stretch(parts, np.linspace(min(_FIRST, parts[0].inside), 0.5 * np.pi, _COARSE))
    theta = np.concatenate(coarse)
    lengths = [_lengths(values, part.number, fixed) for part, values in zip(parts, coarse, strict=True)]
    length = np.concatenate(lengths)[:-1]
    weight = length / max(float(length.sum()), 1e-300) + 0.5 * np.diff(theta) / theta[-1]
    cumulative = np.concatenate([[0.0], np.cumsum(weight)])
    fresh = np.interp(np.linspace(0, cumulative[-1], max(n - theta.size, 0)), cumulative, theta)
    return _by_stretch(parts, np.concatenate([theta, fresh]))


def _lengths(theta: FloatArray, number: int, fixed: Fixed) -> FloatArray:
    """The length of the longest curve from each θ to the next, 0 from the last one."""
    theta0 = 2 * np.arctan(positive_roots(theta, number, fixed))
    mu0 = friction(theta[:, None], theta0, fixed)
    plane = np.stack([theta0 / np.pi, mu0 / (1 + np.abs(mu0))])
    steps = np.hypot(*np.diff(plane, axis=1, append=plane[:, -1:]))
    return np.nan_to_num(steps).max(axis=1, initial=0.0)  # type: ignore[no-any-return]  # NumPy gives Any


#: Chunks of points (θ, v), each of shape (2, k), in order; a curve grows at both ends.
_Curve: TypeAlias = "deque[FloatArray]"
#: A curve, and whether it is its last end that is open.
_End: TypeAlias = tuple[_Curve, bool]


def _trace(parts: list[Stretch], theta: list[FloatArray], fixed: Fixed) -> list[Strand]:
    """Join the roots of neighbouring θ, and two open ends where they are born or vanish together."""
    finished: list[_Curve] = []
    open_ends: list[_End] = [(deque(), True) for _ in range(parts[0].number)]
    for place, (part, inside) in enumerate(zip(parts, theta, strict=True)):
        if place:
            open_ends = _through_event(parts[place - 1], part, fixed, open_ends, finished)
        for (curve, last), values in zip(open_ends, positive_roots(inside, part.number, fixed).T, strict=True):
            _grow(curve, last, np.stack([inside, values]))
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


def _through_event(before: Stretch, after: Stretch, fixed: Fixed, open_ends: list[_End], finished: list[_Curve]) -> list[_End]:
    """Carry the open ends over an event: what enters at an end, then pairs, then what leaves, so that all are there for pairs."""
    passing = _passing(before, after)
    pairs = (after.number - before.number - sum(passing)) // 2
    for at_zero, way in zip((True, False), passing, strict=True):
        if way > 0:
            end = deque([_border(after.low, at_zero, fixed)]), True
            open_ends = [end, *open_ends] if at_zero else [*open_ends, end]
    for _ in range(abs(pairs)):
        open_ends = _pair(after.low, fixed, open_ends, finished, born=pairs > 0)
    for at_zero, way in zip((True, False), passing, strict=True):
        if way < 0:
            open_ends = _leave(after.low, at_zero, fixed, open_ends, finished)
    return open_ends


def _passing(before: Stretch, after: Stretch) -> tuple[int, int]:
    """1 where a root enters, −1 where it leaves, at θ₀ = 0 and at the other end.

    At both ends at once, and in opposite ways, only the two roots for α = 0 can pass, of a parabola that is open below.
    """
    at_zero, at_end = before.at_zero != after.at_zero, before.at_end != after.at_end
    change = after.number - before.number
    if at_zero and change == 0:
        return -after.at_zero, after.at_zero
    way = 1 if change > 0 else -1
    return way * at_zero, way * at_end


def _border(theta: float, at_zero: bool, fixed: Fixed) -> FloatArray:
    """The point of a fold that passes θ₀ = 0 or the other end."""
    return np.array([[theta], [0.0 if at_zero else np.inf if fixed.alpha else 1.0]])


def _leave(theta: float, at_zero: bool, fixed: Fixed, open_ends: list[_End], finished: list[_Curve]) -> list[_End]:
    """The lowest root leaves at θ₀ = 0, or the uppermost at the other end."""
    (curve, last), rest = (open_ends[0], open_ends[1:]) if at_zero else (open_ends[-1], open_ends[:-1])
    _grow(curve, last, _border(theta, at_zero, fixed))
    if not any(other is curve for other, _ in rest):
        finished.append(curve)
    return rest


def _pair(theta: float, fixed: Fixed, open_ends: list[_End], finished: list[_Curve], born: bool) -> list[_End]:
    """Two roots are born or vanish together."""
    [roots] = positive_roots(np.array([theta]), len(open_ends) + 2 * born, fixed)
    place = int(np.argmin(np.diff(roots) / roots[1:]))
    point = np.array([[theta], [0.5 * (roots[place] + roots[place + 1])]])  # both, but for the root of a rounding error
    if born:
        fresh: _Curve = deque([point])
        return [*open_ends[:place], (fresh, False), (fresh, True), *open_ends[place:]]
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


def _one_sign(strand: Strand, events: list[float], fixed: Fixed, *, positive: bool) -> list[Strand]:
    """The parts of a strand with μ₀ ≥ 0, or with μ₀ ≤ 0, each cut where μ₀ = 0."""
    good = strand.mu0 >= 0 if positive else strand.mu0 <= 0
    changes = np.flatnonzero(good[1:] != good[:-1]) + 1
    parts = []
    for begin, end in zip([0, *changes], [*changes, good.size], strict=True):
        if not good[begin]:
            continue
        part = Strand(strand.theta[begin:end], strand.theta0[begin:end], strand.mu0[begin:end])
        before = _zero_friction(strand, begin - 1, events, fixed) if begin else None
        after = _zero_friction(strand, end - 1, events, fixed) if end < good.size else None
        chunks = [chunk for chunk in (before, part, after) if chunk is not None]
        if sum(chunk.theta.size for chunk in chunks) > 1:
            parts.append(_concatenated(chunks))
    return parts


def _concatenated(chunks: list[Strand]) -> Strand:
    return Strand(*(np.concatenate([getattr(chunk, name) for chunk in chunks]) for name in ("theta", "theta0", "mu0")))


def _zero_friction(strand: Strand, place: int, events: list[float], fixed: Fixed) -> Strand | None:
    """Where a strand crosses μ₀ = 0 between a point and the next: at the one event there; without one it is rounding."""
    low, high = sorted(strand.theta[place : place + 2])
    between = [theta for theta in events if low < theta < high]
    if not between or fixed.alpha == 0:
        return None
    c, s = np.cos(between[0]), np.sin(between[0])
    s0, c0 = _catastrophe.fold_angles(c, s, 0.0, *fixed)
    return Strand(np.array(between[:1]), np.array([np.arctan2(s0, c0)]), np.array([0.0]))


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
