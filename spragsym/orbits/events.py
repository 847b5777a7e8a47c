"""Events of a branch between two of its points: test functions that change sign, and borders that
the orbit only touches.
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
from ..motion.shooting import Conditions, Orbit, closed_orbit, remeshed
from ..numerics.vectors import magnitude
from .arclength import (
    BranchPoint,
    Setting,
    Touch,
    between,
    corrected,
    differences,
    level_and_rate,
    placed,
    turning,
    uncertainty,
    zero_of,
)

#: Sliding bifurcations of cycles: M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk 2008.
SLIDING = ("grazing-sliding", "crossing-sliding", "switching-sliding", "adding-sliding")


#: Said of the end of a branch of doubled cycles.
MERGES = "it meets the cycle of half its period, which doubles there"


def criterion(kind: str, point: BranchPoint) -> float:
    """A test function along a branch: at a fold the parameter itself turns back; where another
    branch crosses, it does not.
    """
    if kind == "fold":
        return turning(point)
    if kind == "crossing":
        return criterion_of("fold", point.orbit) * float(np.sign(turning(point)))
    return criterion_of(kind, point.orbit)


def significant_value(kind: str, point: BranchPoint) -> float:
    """A test function of which the sign is known, or 0: one that is within its error tells
    nothing.
    """
    value = criterion(kind, point)
    return value if kind == "fold" or abs(value) > unsure(point.orbit, kind) else 0.0


@dataclass(frozen=True)
class DetectedEvent:
    """Something that happens on a branch: what, the orbit there, and how well its place is known.

    ``border`` is the one that it touches; ``crossed`` how the branch goes on where another one
    crosses it; ``how`` what is touched or else to be said, of an end why it is one; ``value`` that
    of the parameter, where it is not the orbit's.
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
    """All that happens between two points of a branch, in its order; halves the step where
    something may be hidden in it.

    A test function changes its sign since the point ``before`` where that at the first of the two
    is not known.
    """
    # Test functions that tell something there.
    apart_from_ones = CRITERIA[1:]
    # What test functions tell, a grazing apart.
    kinds = apart_from_ones if vertical(one, other, length) else (*CRITERIA, "crossing")
    since = {kind: one if significant_value(kind, one) else before or one for kind in kinds}
    changed = [
        kind
        for kind in kinds
        if significant_value(kind, since[kind]) * significant_value(kind, other) < 0
    ]
    pairs = matched_events(one.touches, other.touches)
    came = matched_events(sliding_entries(one), sliding_entries(other))
    left = [*lost(one, pairs, length), *lost(other, pairs, -length)]
    ended = [
        [(near, touch)]
        for near, touch in left
        if crossing_difference(other if near is one else one, near)[touch.way[0]]
    ]
    through, switched = (
        [pair for pair in each if (pair[0].level < 0) != (pair[1].level < 0)]
        for each in (pairs, came)
    )
    touched = [*([(one, touch), (other, after)] for touch, after in through), *ended]
    hidden = (
        crossing_mismatch(one, other) != 2 * len(touched) + len(switched)
        or any(may_touch(*pair, length) for pair in pairs if pair not in through)
        or len(left) > len(ended)
        or (
            before is not None
            and any(_bends_to_zero(kind, before, one, other) for kind in CRITERIA if kind in kinds)
        )
        or len(changed) + len(touched) + len(switched) > 1
    )
    # Halvings of a step that looks as if something were hidden in it.
    if hidden and depth < 9:
        try:
            middle = corrected(one, length / 2)
        except ConvergenceError:
            pass  # the step is looked at as a whole
        else:
            yield from detected_events(one, middle, length / 2, before, depth + 1)
            yield from detected_events(middle, other, between(middle, other), one, depth + 1)
            return
    for turns in touched:
        yield from _grazing(one, other, turns, length)
    for arrival, _ in switched:
        yield from _switching(one, other, arrival, length)
    for kind in changed:
        first = since[kind]
        yield from _located(
            kind,
            partial(criterion, kind),
            first,
            other,
            length if first is one else between(first, other),
        )


def vertical(one: BranchPoint, other: BranchPoint, length: float) -> bool:
    """Whether the parameter stays what it is from one point to another, far apart: a whole family
    of cycles at one value.

    There a second multiplier is 1 all along, other than next to a homoclinic orbit, and what a sign
    of the tangent says is rounding.
    """
    # Slope of a branch, in shares of the range over the arc, below which it is upright.
    ends, still = (one, other), 1e-8 * one.setting.spans[0]
    # How near 1 a double multiplier of an upright branch is found.
    return (
        length > one.setting.options.event_step
        and abs(one.value - other.value) < still * length
        and all(
            abs(turning(end)) < still and np.abs(end.orbit.multipliers.others - 1).min() < 1e-4
            for end in ends
        )
    )


def _bends_to_zero(kind: str, before: BranchPoint, one: BranchPoint, other: BranchPoint) -> bool:
    """Whether the parabola through three values of one sign, equally far apart, comes to 0 between
    the last two.
    """
    a, b, c = (significant_value(kind, each) for each in (before, one, other))
    slope, bend = (c - a) / 2, (a + c) / 2 - b
    if not (a > 0) == (b > 0) == (c > 0) or bend * b <= 0 or not 0 < -slope / (2 * bend) < 1:
        return False
    return (b - slope**2 / (4 * bend)) * b < 0.05 * b * b


def _grazing(
    one: BranchPoint, other: BranchPoint, turns: list[tuple[BranchPoint, Touch]], length: float
) -> Iterator[DetectedEvent]:
    """Points where an orbit touches a border, by its turns there: of both points, or of the one
    that does not slide on the border.
    """
    turns = sorted(turns, key=lambda pair: abs(pair[1].level))
    nearest, first = turns[0]
    kind, border = _kind(nearest.orbit, first), first.way[0]
    # Level at which an orbit is found that would slide if it touched the border.
    sliding_level = 1e-11
    name = nearest.orbit.field.borders[border].name
    beside = 0.0 if kind == "grazing" else sliding_level
    for near, touch in turns:
        try:
            orbit = grazing(near, touch, beside)
        except ConvergenceError:
            continue
        off = 10 * orbit.largest_gap + 1e-12 + beside * abs(turning(near) / touch.slope)
        if _lies_between(one, other, orbit.guess.varied[0], length, off):
            yield DetectedEvent(kind, orbit, off, border, how=name)
            return
    if length > one.setting.options.event_step:
        raise ConvergenceError(f"a {kind} was not located")
    if not crossing_mismatch(one, other):
        return  # two different turns were taken for one: the orbit crosses as often as before
    yield DetectedEvent(kind, nearest.orbit, abs(other.value - one.value), border, how=name)


def _kind(orbit: Orbit, touch: Touch) -> str:
    """Name of the event that an orbit touches a border, by what is beyond: it slides there in
    contact, or slides no longer.
    """
    that = orbit.field.borders[touch.way[0]]
    if that.stays:
        return "grazing-sliding" if orbit.mode(touch.state)[0] else "grazing"
    return "adding-sliding" if that.crossings[2:] else "grazing"


def sliding_entries(point: BranchPoint) -> list[Touch]:
    """All places of one round where the orbit comes to a border on which it may stay."""
    found, orbit = list[Touch](), point.orbit
    for crossing in orbit.crossings():
        if stays := orbit.field.borders[crossing.border].stays:
            level = stays(crossing.state.tolist(), orbit.constants, orbit.mode(crossing.state))
            found.append(
                Touch(
                    (crossing.border, crossing.came),
                    crossing.t / orbit.period,
                    crossing.state,
                    level,
                )
            )
    return found


def approaches(point: BranchPoint) -> list[tuple[float, str]]:
    """Rates at which levels come to 0 where the field jumps, and names of the borders: one that
    comes to 0 is of a tangent arrival, behind which the orbit does not come there.
    """
    found, orbit = list[tuple[float, str]](), point.orbit
    for crossing in orbit.crossings():
        border, own = orbit.field.borders[crossing.border], orbit.mode(crossing.state)
        if border.jumps is None:
            continue
        beside = (
            mode
            for mode in orbit.field.modes
            if sum(a != b for a, b in zip(own, mode, strict=True)) == 1
        )
        before = next(m for m in (own, *beside) if border.sign(m) == crossing.came)
        state = crossing.state.tolist()
        rate = orbit.field.level_rate(border, state, orbit.constants, before)
        found.append((abs(rate), border.name))
    return found


def _switching(
    one: BranchPoint, other: BranchPoint, arrival: Touch, length: float
) -> Iterator[DetectedEvent]:
    """Points where an orbit comes to the edge of the states that stay on a border: it leaves at
    once, or goes on into them.
    """

    def stays(point: BranchPoint) -> float:
        for _, become in matched_events([arrival], sliding_entries(point)):
            return become.level
        raise ConvergenceError("the orbit does not come to the border")

    passing, staying = sorted((one, other), key=stays)
    returns = len(sliding_entries(passing)) > len(sliding_entries(staying))
    kind = "switching-sliding" if returns else "crossing-sliding"
    name = one.orbit.field.borders[arrival.way[0]].name
    yield from _located(kind, stays, one, other, length, name)


def _lies_between(
    one: BranchPoint, other: BranchPoint, value: float, length: float, off: float
) -> bool:
    """Whether the parameter passes a value between two points: a turn of a doubled cycle has
    another one half a period away.

    Where the branch turns back between them it passes more than what lies between their own.
    """
    low, high = sorted((one.value, other.value))
    ends = turning(one), turning(other)
    beyond = length * max(map(abs, ends)) if (ends[0] < 0) != (ends[1] < 0) else 0.0
    return low - beyond - off <= value <= high + beyond + off


def _located(
    kind: str,
    test: Callable[[BranchPoint], float],
    one: BranchPoint,
    other: BranchPoint,
    length: float,
    how: str = "",
) -> Iterator[DetectedEvent]:
    """Zero of a test function, by bracketing along the arc."""
    width = abs(one.value - other.value)
    try:
        point = zero_of(test, one, other, length, singular=kind == "crossing")
    except (ConvergenceError, ValueError) as error:
        if (
            length > one.setting.options.event_step
        ):  # the two points may lie on different branches: shorter steps tell
            raise ConvergenceError(f"a {kind} was not located") from error
        if kind == "crossing":
            return
        yield DetectedEvent(kind, other.orbit, width, how=how)
        return
    if kind == "torus" and not is_complex_pair(point.orbit):
        return
    # Where the parameter changes less than this along the arc, a multiplier that passes 1
    # belongs to a fold.
    if kind == "crossing" and abs(turning(point)) * point.setting.spans[0] < 1e-6:
        return  # the fold itself, by rounding
    off = _error(kind, one, other, length, point)
    # Where a sign changes, a test function is a zero if it is smaller than this share of
    # what it is at the ends of the step.
    if abs(test(point)) > 1e-2 * max(abs(test(one)), abs(test(other))):
        # Multipliers jump at a grazing, and another arrival may become the nearest one: the sign
        # changes with no zero.
        if length > one.setting.options.event_step:
            raise ConvergenceError(f"a {kind} was not located")
        if kind in SLIDING:
            return
        off = max(off, width)
        how = "a multiplier jumps past its value there, as it does at a grazing"
    if kind == "crossing":
        yield DetectedEvent(
            "fold",
            point.orbit,
            off,
            crossed=point.tangent,
            how="another branch of cycles crosses this one",
        )
    else:
        yield DetectedEvent(kind, point.orbit, off, how=how)


def _error(
    kind: str, one: BranchPoint, other: BranchPoint, length: float, point: BranchPoint
) -> float:
    """Error of the parameter at the zero of a test function: that of the orbit, and what the place
    on the arc adds.
    """
    own = uncertainty(point)
    if kind == "fold":
        return own  # the parameter is extremal there
    own += abs(turning(point)) * point.setting.options.located
    if kind in SLIDING:
        return own  # the orbit itself tells
    change = abs(criterion(kind, one) - criterion(kind, other))
    spread = unsure(point.orbit, kind) * length / change
    # What it is at the point, and by how much it scatters where orbits at one parameter are found
    # from either side, times the step in that: near a grazing multipliers change so fast with the
    # orbit that its rounding, and not theirs, limits what is known.
    scatter = [abs(criterion(kind, point))]
    for base in (one, other):
        with suppress(ConvergenceError, ZeroDivisionError):
            scatter.append(abs(criterion(kind, placed(base, point.value)) - criterion(kind, point)))
    width = abs(other.value - one.value)
    off = point.setting.options.scatter * width * max(scatter) / change
    return own + abs(turning(point)) * spread + off


def crossing_difference(one: BranchPoint, other: BranchPoint) -> Counter[int]:
    """Difference in how often two orbits cross each border."""
    one_way, other_way = (
        Counter(crossing.border for crossing in each.orbit.crossings()) for each in (one, other)
    )
    return one_way - other_way


def crossing_mismatch(one: BranchPoint, other: BranchPoint) -> int:
    """In how many crossings two orbits differ: the differences in how often each border is crossed,
    added up.
    """
    return crossing_difference(one, other).total() + crossing_difference(other, one).total()


def matched_events(one: list[Touch], other: list[Touch]) -> list[tuple[Touch, Touch]]:
    """Events of an orbit at borders, each with what it becomes on another: the nearest first, each
    once.
    """
    found, off = dict[int, int](), list[tuple[float, int, int]]()
    for i, touch in enumerate(one):
        for k, each in enumerate(other):
            if touch.way == each.way:
                apart = abs((touch.share - each.share + 0.5) % 1 - 0.5) + magnitude(
                    touch.state - each.state
                )
                off.append((apart, i, k))
    for apart, i, k in sorted(off):
        # Turns of two neighbouring points are one where they are as close as this, in
        # shares of a period and in states.
        if apart < 0.6 and i not in found and k not in found.values():
            found[i] = k
    return [(one[i], other[k]) for i, k in sorted(found.items())]


def may_touch(one: Touch, other: Touch, length: float) -> bool:
    """Whether the cubic through levels and slopes of a pair comes to 0 between its ends, which have
    one sign.
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
    """Turns of a point that are no turns of the other and may have come to the border between: by
    level and slope.
    """
    kept = {id(touch) for pair in pairs for touch in pair}
    return [
        (near, touch)
        for touch in near.touches
        if id(touch) not in kept
        and np.sign(touch.level) * (touch.level + away * touch.slope) < 0.5 * abs(touch.level)
    ]


def grazing(near: BranchPoint, touch: Touch, beside: float = 0.0) -> Orbit:
    """The closed orbit that touches a border, begun where it does: near a point with a turn near
    that border.

    An orbit that slides on the border does so at every parameter beyond: so that one is found
    ``beside`` it, and neared slowly.
    """
    orbit, level = near.orbit, touch.level
    guess = remeshed(orbit, len(orbit.states), touch.share * orbit.period)
    while True:
        # Share of the level by which it is neared at a time.
        level = math.copysign(max(beside, 0.03 * abs(level)), level) if beside else 0.0
        conditions = touching(touch.way[0], near.setting, near.orbit, touch.state, level)
        orbit = closed_orbit(near.setting.flow, guess, conditions, reach=0.5)
        if abs(orbit.period / near.orbit.period - 1) > 0.2:
            raise ConvergenceError("another orbit touches the border")
        if abs(level) <= beside:
            return orbit
        guess = orbit.guess


def touching(
    border: int, _: Setting, near: Orbit, target: FloatArray, level: float = 0.0
) -> Conditions:
    """A border has a level, of rate zero, at the first state, in the mode of a target near
    there.
    """
    mode = near.mode(target[: near.field.size])

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        both = partial(level_and_rate, orbit, border, mode)
        begin = orbit.states.size + 1
        size = orbit.field.size
        point = np.append(orbit.state, orbit.guess.varied)
        slopes, rows = differences(both, point, 1e-7), np.zeros((2, len(orbit.guess.coordinates)))
        rows[:, :size], rows[:, begin:] = slopes[:, :size], slopes[:, size:]
        return both(point) - (level, 0.0), rows

    return conditions
