"""Events on a branch of closed orbits, between two neighbouring points of it.

There are two kinds. At bifurcations (fold, period doubling, torus, crossing of another branch) a
test function of the Floquet multipliers changes sign; the zero is located along the arc. At
grazings and sliding bifurcations the orbit touches a border between modes: the level of the border
at one of its extrema along the orbit passes 0, or the orbit arrives at the edge of the states that
stick. Extrema and arrivals of the two points are matched with each other; where they do not match,
or the number of border crossings changes without a known reason, the step is halved
(:func:`detected_events`).
"""

import math
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..core.errors import ConvergenceError
from ..models.parameters import FloatArray
from ..motion.multipliers import CRITERIA, criterion_of, is_complex_pair, unsure
from ..motion.shooting import Conditions, Orbit, closed_orbit, extent, remeshed
from ..numerics.vectors import magnitude
from .arclength import (
    BranchPoint,
    Setting,
    Touch,
    between,
    corrected,
    differences,
    directions,
    level_and_rate,
    placed,
    turning,
    uncertainty,
    zero_of,
)

#: Sliding bifurcations of cycles: M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk 2008.
SLIDING = ("grazing-sliding", "crossing-sliding", "switching-sliding", "adding-sliding")


#: Kind of an event at which another branch of cycles crosses, as where a symmetry is broken.
BRANCH_POINT = "branch_point"

#: Text for the end of a branch of doubled cycles.
MERGES = "it meets the cycle of half its period, which doubles there"


def criterion(kind: str, point: BranchPoint) -> float:
    """Test function of a kind of event at a point: it changes sign at the event.

    "fold": component of the tangent along the parameter. "crossing" of another branch: product of
    1 − λ over all multipliers λ, times the sign of that component, so that it does not change sign
    at a fold. Others: see :func:`criterion_of`.
    """
    if kind == "fold":
        return turning(point)
    if kind == "crossing":
        return criterion_of("fold", point.orbit) * float(np.sign(turning(point)))
    return criterion_of(kind, point.orbit)


def significant_value(kind: str, point: BranchPoint) -> float:
    """The test function, or 0 if it is smaller than its error, so that its sign is not known."""
    value = criterion(kind, point)
    known = not _stationary(point) if kind == "fold" else abs(value) > unsure(point.orbit, kind)
    return value if known else 0.0


@dataclass(frozen=True)
class DetectedEvent:
    """An event on a branch: its kind, the orbit there, and the error of the parameter.

    ``border`` is the index of the border that is touched, −1 for none. ``crossed`` is the tangent
    of this branch, if another branch crosses it. ``how`` names the border, or the reason for which
    the branch ends. ``value`` is that of the parameter, NaN for the orbit's own.
    """

    kind: str
    orbit: Orbit
    error: float
    border: int = -1
    crossed: FloatArray | None = None
    how: str = ""
    value: float = math.nan


def detected_events(
    one: BranchPoint,
    other: BranchPoint,
    length: float,
    before: BranchPoint | None = None,
    depth: int = 0,
) -> Iterator[DetectedEvent]:
    """All events between two points of a branch at an arclength ``length``, in order.

    The step is halved, up to nine times, if it may hide more than one event, or one that leaves no
    sign change. If the sign of a test function at ``one`` is not known, that at the point
    ``before`` is taken.
    """
    kinds = CRITERIA[1:] if vertical(one, other, length) else (*CRITERIA, "crossing")
    since = {kind: one if significant_value(kind, one) else before or one for kind in kinds}
    changed = [
        kind
        for kind in kinds
        if significant_value(kind, since[kind]) * significant_value(kind, other) < 0
    ]
    # At a fold only the first of these changes: both do where a branch turns at a branch point.
    turns = {"fold", "crossing"} <= {*changed}
    if turns:
        changed.remove("crossing")
    extrema = matched_events(one.touches, other.touches)
    arrivals = matched_events(sliding_entries(one), sliding_entries(other))
    unmatched = [*lost(one, extrema, length), *lost(other, extrema, -length)]
    # Unmatched extrema of an orbit that crosses the border more often than the other one.
    vanished = [
        [(near, touch)]
        for near, touch in unmatched
        if crossing_difference(other if near is one else one, near)[touch.way[0]]
    ]
    passed, switched = (
        [pair for pair in pairs if (pair[0].level < 0) != (pair[1].level < 0)]
        for pairs in (extrema, arrivals)
    )
    touched = [*([(one, touch), (other, after)] for touch, after in passed), *vanished]
    hidden = (
        crossing_mismatch(one, other) != 2 * len(touched) + len(switched)
        or any(may_touch(*pair, length) for pair in extrema if pair not in passed)
        or len(unmatched) > len(vanished)
        or (
            before is not None
            and any(_bends_to_zero(kind, before, one, other) for kind in CRITERIA if kind in kinds)
        )
        or len(changed) + len(touched) + len(switched) > 1
    )
    if hidden and depth < 9:
        try:
            middle = corrected(one, length / 2)
        except ConvergenceError:
            pass  # take the step as a whole
        else:
            yield from detected_events(one, middle, length / 2, before, depth + 1)
            yield from detected_events(middle, other, between(middle, other), one, depth + 1)
            return
    for candidates in touched:
        yield from _grazing(one, other, candidates, length)
    for arrival, _ in switched:
        yield from _switching(one, other, arrival, length)
    for kind in changed:
        first = since[kind]
        arc = length if first is one else between(first, other)
        for event in _located(kind, partial(criterion, kind), first, other, arc):
            yield event
            if turns and event.kind == "fold":
                test = partial(criterion, "crossing")
                yield from _located("crossing", test, since["crossing"], other, arc)


def vertical(one: BranchPoint, other: BranchPoint, length: float) -> bool:
    """True if the parameter is constant between two points far apart: a whole family of cycles at
    one value.
    """
    return (
        length > one.setting.options.event_step
        and abs(one.value - other.value) < _constant(one) * length
        and _stationary(one)
        and _stationary(other)
    )


def _constant(point: BranchPoint) -> float:
    """Change of the parameter per arclength that counts as 0: less in smaller orbits, as it shrinks
    with them next to a Hopf point.
    """
    return 1e-8 * point.setting.spans[0] * min(1.0, extent(point.orbit))


def _stationary(point: BranchPoint) -> bool:
    """True if the tangent's component along the parameter, whose sign is then rounding, is 0, as in
    a whole family of cycles at one value.

    There a second multiplier is 1 all along; otherwise the point may be next to a homoclinic orbit.
    """
    return (
        abs(turning(point)) < _constant(point)
        and np.abs(point.orbit.multipliers.others - 1).min() < 1e-4
    )


def _bends_to_zero(kind: str, before: BranchPoint, one: BranchPoint, other: BranchPoint) -> bool:
    """True if a test function may have a double zero between the last two of three points: its
    values a, b, c have one sign, and the parabola through them, at equal distances, has a minimum
    below 0.05 b between b and c.
    """
    a, b, c = (significant_value(kind, each) for each in (before, one, other))
    slope, bend = (c - a) / 2, (a + c) / 2 - b
    if not (a > 0) == (b > 0) == (c > 0) or bend * b <= 0 or not 0 < -slope / (2 * bend) < 1:
        return False
    return (b - slope**2 / (4 * bend)) * b < 0.05 * b * b


def _grazing(
    one: BranchPoint, other: BranchPoint, candidates: list[tuple[BranchPoint, Touch]], length: float
) -> Iterator[DetectedEvent]:
    """The event at which an orbit touches a border, from an extremum of its level: at both points,
    or at the one point where there is such an extremum.
    """
    candidates = sorted(candidates, key=lambda pair: abs(pair[1].level))
    nearest, first = candidates[0]
    kind, border = _kind(nearest.orbit, first), first.way[0]
    name = nearest.orbit.field.borders[border].name
    # An orbit that would slide after touching the border is computed at this distance from it.
    offset = 0.0 if kind == "grazing" else 1e-11
    for near, touch in candidates:
        try:
            orbit = grazing(near, touch, offset)
        except ConvergenceError:
            continue
        error = 10 * orbit.largest_gap + 1e-12 + offset * abs(turning(near) / touch.slope)
        if _lies_between(one, other, orbit.guess.varied[0], length, error):
            yield DetectedEvent(kind, orbit, error, border, how=name)
            return
    if length > one.setting.options.event_step:
        raise ConvergenceError(f"a {kind} was not located")
    if not crossing_mismatch(one, other):
        return  # wrongly matched extrema: no crossing appears or vanishes
    yield DetectedEvent(kind, nearest.orbit, abs(other.value - one.value), border, how=name)


def _kind(orbit: Orbit, touch: Touch) -> str:
    """Kind of event at which an orbit touches a border: "grazing-sliding" if it sticks beyond,
    "adding-sliding" if it ceases to stick, else "grazing".
    """
    that = orbit.field.borders[touch.way[0]]
    if that.stays:
        return "grazing-sliding" if orbit.mode(touch.state)[0] else "grazing"
    return "adding-sliding" if that.crossings[2:] else "grazing"


def sliding_entries(point: BranchPoint) -> list[Touch]:
    """All arrivals of an orbit, in one period, at borders on which it may stay (stick)."""
    found, orbit = list[Touch](), point.orbit
    for crossing in orbit.crossings():
        if stays := orbit.field.borders[crossing.border].stays:
            level = stays(crossing.state.tolist(), orbit.constants, orbit.mode(crossing.state))
            way, share = (crossing.border, crossing.came), crossing.t / orbit.period
            found.append(Touch(way, share, crossing.state, level))
    return found


def approaches(point: BranchPoint) -> list[tuple[float, str]]:
    """For each arrival of an orbit at a border where the field jumps: the absolute rate of the
    level, and the name of the border.

    A rate of 0 is a tangent arrival, beyond which the orbit does not reach the border.
    """
    found, orbit = list[tuple[float, str]](), point.orbit
    for crossing in orbit.crossings():
        border, own = orbit.field.borders[crossing.border], orbit.mode(crossing.state)
        if border.jumps is None:
            continue
        neighbours = (
            mode
            for mode in orbit.field.modes
            if sum(a != b for a, b in zip(own, mode, strict=True)) == 1
        )
        before = next(m for m in (own, *neighbours) if border.sign(m) == crossing.came)
        state = crossing.state.tolist()
        rate = orbit.field.level_rate(border, state, orbit.constants, before)
        found.append((abs(rate), border.name))
    return found


def _switching(
    one: BranchPoint, other: BranchPoint, arrival: Touch, length: float
) -> Iterator[DetectedEvent]:
    """The crossing-sliding or switching-sliding event: an arrival at a border comes to the edge of
    the states that stick.
    """

    def stays(point: BranchPoint) -> float:
        for _, matched in matched_events([arrival], sliding_entries(point)):
            return matched.level
        raise ConvergenceError("the orbit does not come to the border")

    passing, staying = sorted((one, other), key=stays)
    returns = len(sliding_entries(passing)) > len(sliding_entries(staying))
    kind = "switching-sliding" if returns else "crossing-sliding"
    name = one.orbit.field.borders[arrival.way[0]].name
    yield from _located(kind, stays, one, other, length, name)


def _lies_between(
    one: BranchPoint, other: BranchPoint, value: float, length: float, error: float
) -> bool:
    """True if the branch between two points passes a value of the parameter, up to an error.

    An event elsewhere is excluded, as at the similar extremum of a doubled cycle half a period
    later. If the branch has a fold between the points, the parameter may exceed their values.
    """
    low, high = sorted((one.value, other.value))
    ends, beyond = (turning(one), turning(other)), 0.0
    if (ends[0] < 0) != (ends[1] < 0):
        beyond = length * max(map(abs, ends))
    return low - beyond - error <= value <= high + beyond + error


def _located(
    kind: str,
    test: Callable[[BranchPoint], float],
    one: BranchPoint,
    other: BranchPoint,
    length: float,
    how: str = "",
) -> Iterator[DetectedEvent]:
    """The event at which a test function changes sign between two points.

    Raises ConvergenceError if it cannot be located and the step may still be shortened.
    """
    width = abs(one.value - other.value)
    may_shorten = length > one.setting.options.event_step
    try:
        point = zero_of(test, one, other, length, singular=kind == "crossing")
    except (ConvergenceError, ValueError) as error:
        if may_shorten:  # the two points may be on different branches
            raise ConvergenceError(f"a {kind} was not located") from error
        if kind != "crossing":
            yield DetectedEvent(kind, other.orbit, width, how=how)
        return
    if kind == "torus" and not is_complex_pair(point.orbit):
        return
    if kind == "crossing" and abs(turning(point)) * point.setting.spans[0] < 1e-6:
        return  # a fold, where the multiplier passes 1, too
    error_of_value = _error(kind, one, other, length, point)
    if abs(test(point)) > 1e-2 * max(abs(test(one)), abs(test(other))):
        # The sign changes by a jump: multipliers jump at a grazing, and of several arrivals another
        # one may become the nearest. Next to a fold they may change as much within rounding.
        if may_shorten:
            raise ConvergenceError(f"a {kind} was not located")
        if kind in SLIDING:
            return
        error_of_value = max(error_of_value, width)
        at = "at a grazing" if point.orbit.field.borders else "within rounding next to a fold"
        how = f"a multiplier jumps past its value there, as it does {at}"
    crossed = None
    if kind == "crossing" or (kind == "fold" and _forks(point)):
        kind, crossed, how = (
            BRANCH_POINT,
            point.tangent,
            "another branch of cycles crosses this one",
        )
    yield DetectedEvent(kind, point.orbit, error_of_value, crossed=crossed, how=how)


def _forks(point: BranchPoint) -> bool:
    """True if a branch turns where another one passes, as that of a mirrored pair does where its
    symmetry is broken: closed orbits have two directions there, at a fold one.
    """
    next_smallest, smallest = directions(point.setting, point.orbit)[0][-2:]
    return bool(smallest < 1e-4 * next_smallest)


def _error(
    kind: str, one: BranchPoint, other: BranchPoint, length: float, point: BranchPoint
) -> float:
    """Error of the parameter at the zero of a test function: from the orbit's error, from the
    accuracy along the arc, and from the error of the test function.
    """
    error = uncertainty(point)
    if kind == "fold":
        return error  # the parameter is extremal: an error along the arc has no effect
    error += abs(turning(point)) * point.setting.options.located
    if kind in SLIDING:
        return error  # the test function is of the orbit, not of its multipliers
    change = abs(criterion(kind, one) - criterion(kind, other))
    spread = unsure(point.orbit, kind) * length / change
    # Scatter: the test function at the zero, and its differences between orbits at the same
    # parameter, computed from either side. Near a grazing multipliers change so fast with the orbit
    # that its rounding dominates their error.
    scatter = [abs(criterion(kind, point))]
    for base in (one, other):
        with suppress(ConvergenceError, ZeroDivisionError):
            scatter.append(abs(criterion(kind, placed(base, point.value)) - criterion(kind, point)))
    width = abs(other.value - one.value)
    by_scatter = point.setting.options.scatter * width * max(scatter) / change
    return error + abs(turning(point)) * spread + by_scatter


def crossing_difference(one: BranchPoint, other: BranchPoint) -> Counter[int]:
    """Number of crossings of each border by ``one`` minus that by ``other``, where positive."""
    counts = [
        Counter(crossing.border for crossing in each.orbit.crossings()) for each in (one, other)
    ]
    return counts[0] - counts[1]


def crossing_mismatch(one: BranchPoint, other: BranchPoint) -> int:
    """Sum over all borders of the difference in the number of crossings."""
    return crossing_difference(one, other).total() + crossing_difference(other, one).total()


def matched_events(one: list[Touch], other: list[Touch]) -> list[tuple[Touch, Touch]]:
    """Match touches of one orbit with those of another, of the same border and kind: pairs with the
    smallest distance first, each touch once.

    The distance is in shares of the period plus states, and at most 0.6.
    """
    matches, distances = dict[int, int](), list[tuple[float, int, int]]()
    for i, touch in enumerate(one):
        for k, each in enumerate(other):
            if touch.way == each.way:
                in_time = abs((touch.share - each.share + 0.5) % 1 - 0.5)
                distances.append((in_time + magnitude(touch.state - each.state), i, k))
    for distance, i, k in sorted(distances):
        if distance < 0.6 and i not in matches and k not in matches.values():
            matches[i] = k
    return [(one[i], other[k]) for i, k in sorted(matches.items())]


def may_touch(one: Touch, other: Touch, length: float) -> bool:
    """True if the level at a matched extremum, of one sign at both points, may pass 0 in between:
    the cubic through levels and slopes comes near 0.
    """
    from scipy.interpolate import CubicHermiteSpline

    cubic = CubicHermiteSpline(
        [0.0, 1.0], [one.level, other.level], [length * one.slope, length * other.slope]
    )
    lowest = float((np.sign(one.level) * cubic(np.linspace(0.0, 1.0, 41))).min())
    return lowest < min(
        0.1 * abs(one.level - other.level), 0.5 * abs(one.level), 0.5 * abs(other.level)
    )


def lost(
    near: BranchPoint, pairs: list[tuple[Touch, Touch]], away: float
) -> list[tuple[BranchPoint, Touch]]:
    """Extrema of a point without a match, whose levels may pass 0 within the step: extrapolated
    over the arclength ``away`` they fall to less than half.
    """
    matched = {id(touch) for pair in pairs for touch in pair}
    return [
        (near, touch)
        for touch in near.touches
        if id(touch) not in matched
        and np.sign(touch.level) * (touch.level + away * touch.slope) < 0.5 * abs(touch.level)
    ]


def grazing(near: BranchPoint, touch: Touch, offset: float = 0.0) -> Orbit:
    """The closed orbit that touches a border, starting at the point of contact, near an orbit with
    an extremum of the level near 0.

    With an ``offset`` the orbit with the extremum at this distance from the border is computed, for
    orbits that slide beyond: there are touching orbits at all parameters beyond, and none isolated.
    The distance is reduced step by step.
    """
    orbit, level = near.orbit, touch.level
    guess = remeshed(orbit, len(orbit.states), touch.share * orbit.period)
    while True:
        level = math.copysign(max(offset, 0.03 * abs(level)), level) if offset else 0.0
        conditions = touching(touch.way[0], near.setting, near.orbit, touch.state, level)
        orbit = closed_orbit(near.setting.flow, guess, conditions, reach=0.5)
        if abs(orbit.period / near.orbit.period - 1) > 0.2:
            raise ConvergenceError("another orbit touches the border")
        if abs(level) <= offset:
            return orbit
        guess = orbit.guess


def touching(
    border: int, _: Setting, near: Orbit, target: FloatArray, level: float = 0.0
) -> Conditions:
    """Conditions of an orbit that touches a border at its first state: the border with index
    ``border`` has the given level there, and its rate is 0.

    Level and rate are those in the mode of ``target``, a state near the first one. The parameters
    are those of :attr:`Setting.holds`.
    """
    mode = near.mode(target[: near.field.size])

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        both = partial(level_and_rate, orbit, border, mode)
        begin, size = orbit.states.size + 1, orbit.field.size
        point = np.append(orbit.state, orbit.guess.varied)
        slopes, rows = differences(both, point, 1e-7), np.zeros((2, len(orbit.guess.coordinates)))
        rows[:, :size], rows[:, begin:] = slopes[:, :size], slopes[:, size:]
        return both(point) - (level, 0.0), rows

    return conditions
