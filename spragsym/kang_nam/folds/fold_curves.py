"""Every fold curve in the plane of θ₀ and μ₀, by solving for all folds at each θ and joining what belongs together.

At a given direction θ of the spring the two fold relations are lines in μ₀. Eliminating it leaves a conic in (cos θ₀, sin θ₀),
hence a quartic in v = tan(θ₀/2): all folds in 0 < θ₀ < π are its positive roots. As θ moves they never cross, since two meet
only where they vanish together, so that the k-th root of one θ belongs to the k-th of the next. Where their number changes, and
what it is, is proved (``fold_events``); float64 only draws what is there.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray
from ...numerics.chains import link, walked
from ...numerics.companion_roots import eigenvalues, polished
from .fixed_parameters import Fixed
from .fold_events import Stretch, fold_polynomial, stretches

#: Values of θ on which curves are looked at before their shape says where more are needed.
_COARSE = 512
#: How close to 0 the first θ is, if no event is closer; equilibria in contact have 0 < θ < π.
_FIRST = 1e-7


class Strand(NamedTuple):
    """One curve of folds, points in order."""

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray

    def part(self, which: slice) -> Strand:
        """Some of the points."""
        return Strand(*(column[which] for column in self))


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


class _Graph:
    """Points (θ, v) of curves, each of shape (2, k) by growing θ, and which of them go on as which others at an end."""

    def __init__(self) -> None:
        self.points: list[FloatArray] = []
        self.links: list[set[int]] = []

    def add(self, points: FloatArray, *neighbours: int) -> int:
        """Further points, and their number."""
        self.points.append(points)
        self.links.append(set())
        number = len(self.links) - 1
        link(self.links, ((number, other) for other in neighbours))
        return number

    def curves(self) -> Iterator[FloatArray]:
        """Whole curves, points in order."""
        for chain in walked(self.links):
            parts = [self.points[number] for number in chain if self.points[number].size]  # some stretches hold no float
            if not parts:
                continue
            rises = [bool(one[0, 0] < other[0, 0]) for one, other in itertools.pairwise(parts)]
            ahead = [*rises, rises[-1] if rises else True]
            parts = [part if way else part[:, ::-1] for part, way in zip(parts, ahead, strict=True)]
            if rises and chain[0] == chain[-1]:
                parts[-1] = parts[0][:, :1]
            yield np.concatenate(parts, axis=1)


def _trace(parts: list[Stretch], theta: list[FloatArray], fixed: Fixed) -> list[Strand]:
    """Join the roots of neighbouring θ, and two that are born or vanish together."""
    graph, ends = _Graph(), list[int]()
    for place, (part, inside) in enumerate(zip(parts, theta, strict=True)):
        if place:
            ends = _through_event(parts[place - 1], part, fixed, graph, ends)
        roots = positive_roots(inside, part.number, fixed).T
        # The first have nothing before them.
        ends = [graph.add(np.stack([inside, values]), *ends[k : k + 1]) for k, values in enumerate(roots)]
    return [_strand(curve, fixed) for curve in graph.curves()]


def _strand(curve: FloatArray, fixed: Fixed) -> Strand:
    theta, v = curve
    theta0 = 2 * np.arctan(v)
    return Strand(theta, theta0, friction(theta, theta0, fixed))


def _through_event(before: Stretch, after: Stretch, fixed: Fixed, graph: _Graph, ends: list[int]) -> list[int]:
    """Carry curves over an event: what enters at an end, then pairs, then what leaves, so that all are there for pairs."""
    passing = _passing(before, after)
    pairs = (after.number - before.number - sum(passing)) // 2
    for at_zero, way in zip((True, False), passing, strict=True):
        if way > 0:
            end = graph.add(_border(after.low, at_zero, fixed))
            ends = [end, *ends] if at_zero else [*ends, end]
    for _ in range(abs(pairs)):
        [roots] = positive_roots(np.array([after.low]), len(ends) + 2 * (pairs > 0), fixed)
        place = int(np.argmin(np.diff(roots) / roots[1:]))
        # Both, but for the root of a rounding error.
        point = np.array([[after.low], [0.5 * (roots[place] + roots[place + 1])]])
        if pairs > 0:
            ends[place:place] = [graph.add(point)] * 2
        else:
            graph.add(point, *ends[place : place + 2])
            del ends[place : place + 2]
    for at_zero, way in zip((True, False), passing, strict=True):
        if way < 0:
            graph.add(_border(after.low, at_zero, fixed), ends.pop(0 if at_zero else -1))
    return ends


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


# ------------------------------------------------------------------------------------------------------ pieces


def _one_sign(strand: Strand, events: list[float], fixed: Fixed, *, positive: bool) -> list[Strand]:
    """The parts of a strand with μ₀ ≥ 0, or with μ₀ ≤ 0, each cut where μ₀ = 0."""
    good = strand.mu0 >= 0 if positive else strand.mu0 <= 0
    changes = np.flatnonzero(good[1:] != good[:-1]) + 1
    parts = []
    for begin, end in zip([0, *changes], [*changes, good.size], strict=True):
        if not good[begin]:
            continue
        part = strand.part(slice(begin, end))
        before = _zero_friction(strand, begin - 1, events, fixed) if begin else None
        after = _zero_friction(strand, end - 1, events, fixed) if end < good.size else None
        chunks = [chunk for chunk in (before, part, after) if chunk is not None]
        if sum(chunk.theta.size for chunk in chunks) > 1:
            parts.append(_concatenated(chunks))
    return parts


def _concatenated(chunks: list[Strand]) -> Strand:
    return Strand(*map(np.concatenate, zip(*chunks, strict=True)))


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
    for first, second in itertools.product(*((strand, strand.part(slice(None, None, -1))) for strand in (one, two))):
        if first.mu0[-1] > 0:
            a = np.array([first.theta[-1], first.theta0[-1], first.mu0[-1] / (1 + first.mu0[-1])])
            b = np.array([second.theta[0], second.theta0[0], second.mu0[0] / (1 + second.mu0[0])])
            if np.abs(a - b).max() < 1e-6:
                return _concatenated([first, second])
    return None
