"""Branches of cycles: :func:`cycle_branch` follows a cycle in one parameter, by pseudo-arclength
continuation, and locates the bifurcations, grazings and ends of the branch. :func:`cycle_events`
follows one of these events in two parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import islice

import numpy as np

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, one_of, require_kind
from ..core.progress import doing
from ..core.remarks import Remark
from ..display import Column
from ..models.model import Model
from ..models.parameters import (
    ANGLE,
    FINITE,
    FloatArray,
    Ranges,
    Span,
    as_count,
    as_ranges,
    varied_range,
)
from ..motion.multipliers import CRITERIA, is_complex_pair
from ..motion.shooting import Orbit, extent, in_scales, natural, remeshed
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import norm
from ..results.result import Result
from .arclength import (
    BranchPoint,
    Setting,
    at_zero,
    between,
    corrected,
    point_of,
    remeshed_point,
    started,
    steps,
    within,
)
from .events import (
    BRANCH_POINT,
    MERGES,
    SLIDING,
    DetectedEvent,
    approaches,
    detected_events,
    sliding_entries,
    touching,
    vertical,
)
from .homoclinic import limit_of_periods
from .options import BranchOptions
from .orbit import Cycle, Cycles, cycle_of, is_stable, range_of
from .retracing import CLOSED, returned
from .switching import halved, meets, switched

FAMILIES = "there is a whole family of cycles at every value of the parameter from there on"


@dataclass(frozen=True, eq=False)
class CycleEvent(Result):
    """A bifurcation, a grazing or an end on a branch of cycles.

    Attributes
    ----------
    kind : str
        "fold", "branch_point" where another branch of cycles crosses, as where a symmetry is
        broken, "period_doubling", "torus", "grazing", "homoclinic", "end", or "closed" where the
        branch comes back to its first cycle, as an isola does. With dry friction also the sliding
        bifurcations, at each of which a phase of the cycle shrinks to nothing:

        - "grazing-sliding": a phase of sticking; the orbit touches x′ = V in contact. (If it
          touches x′ = V in lift-off, the kind is "grazing".)
        - "crossing-sliding": a phase of sticking; the orbit crosses x′ = V at the edge of the
          states that stick.
        - "switching-sliding": a phase of slip between that edge and sticking.
        - "adding-sliding": a phase of slip between two of sticking; the holding force touches its
          limit.

        The branch ends in a "catastrophic-sliding" where the arrival at x′ = V, or that of the
        holding force at its limit, becomes tangent.
    value : float
        Value of the parameter.
    cycle : Cycle
        The cycle at the event, or the last one before it.
    error : float
        Error of the value.
    how : str
        The border that is touched, the reason for which the branch ends, or a note that a
        multiplier jumps past its value.
    vary : str
        The parameter.
    """

    kind: str
    value: float
    cycle: Cycle
    error: float
    how: str
    vary: str = field(repr=False)
    found: DetectedEvent = field(repr=False)

    @property
    def brief(self) -> str:
        """The event as text of a table's cell."""
        return f"{self.kind} at {self.value:.6g}"

    @property
    def _of_model(self) -> Model | None:
        return self.cycle.field.model


@dataclass(frozen=True, eq=False)
class CycleBranch(Result):
    """A branch of cycles, from one of its ends to the other.

    Attributes
    ----------
    vary : str
        The parameter.
    values, periods, rms, lowest, highest : ndarray, shape (n,)
        Values of the parameter; periods of the cycles; root mean square, minimum and maximum of the
        first coordinate.
    stable : ndarray of bool, shape (n,)
    cycles : sequence of Cycle
        Each starts where its first coordinate that moves is largest; computed on access.
    events : tuple of CycleEvent
        In the order of the branch.
    places : tuple of int
        Number of points of the branch before each event.
    """

    schema = (
        Column("periods", "s", "period of the cycle"),
        Column("rms", "{x}", "root mean square of {x} about zero"),
        Column("lowest", "{x}", "least {x} of the cycle"),
        Column("highest", "{x}", "largest {x} of the cycle"),
        Column("stable", "1", "whether the cycle attracts"),
    )

    vary: str
    values: FloatArray
    periods: FloatArray
    rms: FloatArray
    lowest: FloatArray
    highest: FloatArray
    stable: BoolArray
    cycles: Cycles = field(repr=False)
    events: tuple[CycleEvent, ...]
    to: Span = field(repr=False)
    places: tuple[int, ...] = field(repr=False)

    @property
    def _of_model(self) -> Model | None:
        return self.cycles[0].field.model

    def switch(self, event: CycleEvent, *, step: float = 0.02) -> Cycle:
        """A cycle on the other branch at an event, from which :func:`cycle_branch` can start.

        At a period doubling this is a doubled cycle; at the end of a branch of doubled cycles the
        cycle that doubles there; at a branch point a cycle on the branch that crosses; at a fold a
        cycle on the other side of it.

        Parameters
        ----------
        event : CycleEvent
            One of the events of this branch.
        step : float
            Distance of the cycle's state from that at the event.

        Returns
        -------
        Cycle

        Examples
        --------
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters(V=0.2)
        >>> options = ss.BranchOptions(longest_step=0.3)
        >>> branch = ss.cycle_branch(ss.cycle(p), "V", between={"V": (0.15, 4.0)}, options=options)
        >>> branch.switch(branch.of("fold")[0]).stable
        False
        """
        return switched(self, event, step)

    @property
    def amplitude(self) -> FloatArray:
        """Half the range of the first coordinate, shape (n,)."""
        return (self.highest - self.lowest) / 2

    def changes(self) -> Iterator[tuple[int, CycleEvent]]:
        """Events at which the stability changes, each with the number of points before it.

        Returns
        -------
        iterator of (int, CycleEvent)

        Examples
        --------
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters(V=0.2)
        >>> options = ss.BranchOptions(longest_step=0.3)
        >>> branch = ss.cycle_branch(ss.cycle(p), "V", between={"V": (0.15, 4.0)}, options=options)
        >>> [event.kind for _, event in branch.changes()]
        ['fold']
        """
        for index in (np.flatnonzero(np.diff(self.stable)) + 1).tolist():
            between = [
                event
                for event, before in zip(self.events, self.places, strict=True)
                if before == index and event.kind in (*CRITERIA, BRANCH_POINT)
            ]
            if between:
                yield index, between[0 if self.stable[index - 1] else -1]

    def of(self, *kinds: str) -> tuple[CycleEvent, ...]:
        """The events of given kinds.

        Parameters
        ----------
        *kinds : str
            Kinds as in :attr:`CycleEvent.kind`.

        Returns
        -------
        tuple of CycleEvent

        Examples
        --------
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters(V=0.2)
        >>> options = ss.BranchOptions(longest_step=0.3)
        >>> branch = ss.cycle_branch(ss.cycle(p), "V", between={"V": (0.15, 4.0)}, options=options)
        >>> len(branch.of("end"))
        2
        """
        others = ("grazing", *SLIDING, "homoclinic", "catastrophic-sliding", "end", CLOSED)
        offered = (*CRITERIA, BRANCH_POINT, *others)
        chosen = [one_of("kinds", kind, offered) for kind in kinds]
        return tuple(event for event in self.events if event.kind in chosen)


@in_usual_state
def cycle_branch(
    cycle: Cycle,
    vary: str,
    *,
    between: Ranges,
    points: int = 400,
    options: BranchOptions | None = None,
) -> CycleBranch:
    """Follow a cycle as a parameter varies, through folds, in both directions, to the ends of a
    range or of the branch.

    Parameters
    ----------
    cycle : Cycle
        The first cycle.
    vary : str
        Name of the parameter; for the article's model theta0 (radians), V, d, mu0, kappa, alpha,
        sigma or beta.
    between : mapping
        Range of the parameter, by its name.
    points : int
        Maximum number of points in each direction.
    options : BranchOptions, optional
        Step lengths and other limits, by default :class:`spragsym.BranchOptions`.

    Returns
    -------
    CycleBranch

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, a range that excludes the cycle's own value or
        exceeds the allowed values, or a number of points that is not positive.

    Notes
    -----
    A doubling, a torus or a crossing is reported if its test function changes sign by more than the
    error of the multipliers. So none is reported without damping, where multipliers stay on the
    unit circle.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(42)), V=0.5, d=10.0)
    >>> branch = ss.cycle_branch(found, "theta0", between={"theta0": np.radians([41.5, 42.5])})
    >>> [event.kind for event in branch.events]
    ['end', 'end']
    """
    require_kind("cycle", cycle, Cycle, "one of ss.cycle(...)")
    model = cycle.field
    index = model.parameters.index(one_of("vary", vary, model.parameters))
    low, high = varied_range(vary, between, ANGLE if model.column(vary).is_angle else FINITE)
    for bound in (low, high):
        model.check(vary, bound)
    points = as_count("points", points)
    options = options or BranchOptions()
    value = cycle.values[index]
    if not low <= value <= high:
        raise ParameterError(
            f"between = ({low:g}, {high:g}) is no range around {vary} = {value:.10g} of the cycle; "
            "give one"
        )
    own = in_scales(cycle.orbit)
    setting = Setting(own.flow, (index,), own.period, ((high - low) / 2,), options=options)
    pieces = len(own.states)  # made even: then the halves of a doubled cycle can be compared
    guess = remeshed(own, 2 * pieces) if pieces % 2 else own.guess
    start = remeshed_point(started(setting, guess))
    backward = list(_followed([start.oriented(-1.0)], (low, high), points, options))
    behind = [item.oriented(-1.0) for item in backward if isinstance(item, BranchPoint)]
    last = backward[-1] if backward else None
    closed = isinstance(last, DetectedEvent) and last.kind == CLOSED
    ahead = iter(()) if closed else _followed([*behind[:1], start], (low, high), points, options)
    items = [*reversed(backward), start, *ahead]
    orbits, events, places = [], [], []
    for item in items:
        if isinstance(item, BranchPoint):
            orbits.append(item.orbit)
        else:
            orbit = item.orbit
            value = orbit.values[index] if np.isnan(item.value) else item.value
            events.append(
                CycleEvent(item.kind, value, cycle_of(orbit), item.error, item.how, vary, item)
            )
            places.append(len(orbits))
    columns = [
        (orbit.values[index], orbit.period, orbit.moments()[1], *range_of(orbit))
        for orbit in map(natural, orbits)
    ]
    values, periods, rms, lowest, highest = np.array(columns).T.copy()
    return CycleBranch(
        vary,
        values,
        periods,
        rms,
        lowest,
        highest,
        np.array([is_stable(orbit) for orbit in orbits]),
        Cycles(tuple(orbits)),
        tuple(events),
        (low, high),
        tuple(places),
    )


def all_followed(points: int) -> str:
    """Why a branch or a curve ends that has its maximum number of points."""
    return f"{points} points were followed"


def _followed(
    followed: list[BranchPoint], to: Span, points: int, options: BranchOptions
) -> Iterator[BranchPoint | DetectedEvent]:
    """Continue a branch in one direction from the last point of ``followed``: its points and
    events in order, an end last.

    ``followed`` are the known points, to which the new ones are added.
    """
    start = followed[-1]
    first_extent = extent(start.orbit)

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        with doing("the branch of cycles beside {:.6g}", point.value):
            return within(point, length, to, min(options.move, options.share * extent(point.orbit)))

    def in_family(point: BranchPoint) -> bool:
        """Whether the cycles are one of many at one value, which those at the start are not."""
        return not point.alone or len(point.orbit.held) > len(start.orbit.held)

    def look(
        point: BranchPoint, found: BranchPoint, length: float
    ) -> list[BranchPoint | DetectedEvent]:
        """Events of a step, the point found, an end; ConvergenceError to shorten the step."""
        arc = between(point, found) if found.value in to else length
        if (met := meets(point, found)) is not None:
            if arc > options.meeting * extent(found.orbit):
                raise ConvergenceError("the halves of the orbit meet on the way")
            if merged := halved(point, found, met):
                return [DetectedEvent("end", *merged, how=MERGES)]
        if in_family(found):
            if length > options.event_step and not in_family(point):
                raise ConvergenceError("the orbit is one of a whole family")
            return [*_joins(followed, found)]
        comes_back = None if point is start else returned(start, point, found, arc)
        if comes_back:
            found, end = comes_back
            arc = between(point, found)
        items = list[BranchPoint | DetectedEvent]()
        before = followed[-2] if len(followed) > 1 else None
        if before and followed[-1] is not point:  # it has a new mesh, and needs one before it alike
            before = corrected(point, -arc)
        for event in detected_events(point, found, arc, before):
            if event.kind == "fold" and extent(event.orbit) < options.shrunk * first_extent:
                return [*items, _shrunk(followed)]
            items.append(event)
        if extent(found.orbit) < options.vanished * min(1.0, first_extent):
            return [*items, _shrunk(followed)]
        followed.append(found)
        if comes_back:
            return [*items, found, end]
        return [*items, found, *_ends(point, followed, arc, to, options)]

    try:
        for items in islice(steps(start, ahead, options, look), points):
            yield from items
            if isinstance(items[-1], DetectedEvent):
                return
    except ConvergenceError as error:
        yield _lost(followed, error, options)
        return
    before, last = [start, *followed][-2:]
    yield DetectedEvent("end", last.orbit, abs(last.value - before.value), how=all_followed(points))


def _vanishing(
    points: Sequence[BranchPoint], size: Callable[[BranchPoint], float], how: str, kind: str = "end"
) -> DetectedEvent:
    """The end of a branch at which a size shrinks to 0, by extrapolation from its points.

    The parameter is extrapolated to size 0 by parabolas through three points, whose sizes decrease
    by factors of 0.7 at least. Of all extrapolated values those three in a row with the smallest
    range are taken, which is the error: next to the end rounding dominates.
    """
    from scipy.interpolate import KroghInterpolator

    sizes = [(np.inf, np.nan)]
    for point in points:
        if (now := size(point)) < 0.7 * sizes[-1][0]:
            sizes.append((now, point.value))
    ends = [
        float(KroghInterpolator(*zip(*sizes[i - 2 : i + 1], strict=True))(0.0))
        for i in range(3, len(sizes))
    ]
    ranges = ((float(np.ptp(ends[i - 2 : i + 1])), ends[i]) for i in range(2, len(ends)))
    scatter, value = min(ranges, default=(abs(points[-1].value), points[-1].value))
    setting = points[-1].setting
    error = setting.options.scatter * scatter + 1e-12 * setting.spans[0]
    return DetectedEvent(kind, points[-1].orbit, error, how=how, value=value)


def _shrunk(followed: Sequence[BranchPoint]) -> DetectedEvent:
    """The end at an equilibrium. By Hopf's theorem the squared extent is linear in the parameter
    near it.
    """
    return _vanishing(
        followed, lambda point: extent(point.orbit) ** 2, "it shrinks onto an equilibrium"
    )


def _at_border(followed: Sequence[BranchPoint]) -> DetectedEvent | None:
    """The end at a grazing, where a phase of sticking shrinks to nothing, or at a tangent arrival
    at a border ("catastrophic-sliding"); None if there is no such end near the last point.
    """

    def nearest(point: BranchPoint) -> float:
        sticking = (touch.level for touch in sliding_entries(point) if touch.level > 0)
        return min((*sticking, *(abs(touch.level) for touch in point.touches)), default=np.inf)

    def slowest(point: BranchPoint) -> float:
        return min((rate for rate, _ in approaches(point)), default=np.inf)

    last = followed[-1]
    _, name = min(approaches(last), default=(np.inf, ""))
    ends = (
        _vanishing(
            followed,
            nearest,
            "it touches a border there, or a phase of sticking shrinks to nothing, and no "
            "cycle was found beyond",
        ),
        _vanishing(
            followed,
            slowest,
            f"its arrival at {name} becomes tangent: beyond, the orbit does not come there, "
            "and no cycle was found",
            "catastrophic-sliding",
        ),
    )
    near = [
        end
        for end in ends
        if max(end.error, abs(end.value - last.value)) <= 1e-4 * last.setting.spans[0]
    ]
    return min(near, key=lambda end: end.error, default=None)


def _ends(
    point: BranchPoint,
    followed: Sequence[BranchPoint],
    length: float,
    to: Span,
    options: BranchOptions,
) -> Iterator[DetectedEvent]:
    """The end of the branch at the last point, reached from ``point``, if there is one."""
    ahead = followed[-1]
    orbit, moved = ahead.orbit, abs(ahead.value - point.value)
    if vertical(point, ahead, length):
        yield DetectedEvent(
            "end",
            orbit,
            moved,
            how=(
                "the parameter stays what it is along the branch: there is a whole family of "
                "cycles at this one value"
            ),
        )
    elif ahead.value in to:
        yield DetectedEvent("end", orbit, 0.0, how="the range ends")
    elif orbit.period > options.long_period * point.setting.period and (
        rest := _rests(orbit, options.still)
    ):
        yield _homoclinic(followed, rest, options)


def _joins(followed: Sequence[BranchPoint], found: BranchPoint) -> Iterator[DetectedEvent]:
    """The end of a branch where a family of cycles at one value begins, of which ``found`` is one;
    before it the sliding bifurcation there, if any.

    Without one, the end is where a second multiplier becomes 1. Its distance from 1 is as a rule
    quadratic in the parameter.
    """
    entries, edge = sliding_entries(followed[-1]), _at_border(followed)
    how = FAMILIES if edge else f"a second multiplier comes to 1: {FAMILIES}, or hardly attracts"
    if edge:
        same = len(sliding_entries(found)) == len(entries)
        kind = "crossing-sliding" if same else "grazing-sliding"
        yield replace(edge, kind=kind, how=found.orbit.field.borders[entries[0].way[0]].name)
    else:
        edge = _vanishing(
            followed,
            lambda point: float(np.sqrt(np.abs(point.orbit.multipliers.others - 1).min())),
            how,
        )
    yield replace(edge, kind="end", how=how)


def _lost(
    followed: Sequence[BranchPoint], error: ConvergenceError, options: BranchOptions
) -> DetectedEvent:
    """The end where even the shortest step failed with ``error``: homoclinic, at a border, or
    unexplained.
    """
    point = followed[-1]
    orbit = point.orbit
    if orbit.period > 2 * point.setting.period and (rest := _rests(orbit, options.still)):
        return _homoclinic(followed, rest, options)
    before = followed[-2] if len(followed) > 1 else point
    lost = DetectedEvent(
        "end",
        orbit,
        options.scatter * abs(point.value - before.value)
        + options.shortest_step * point.setting.spans[0],
        how=f"it could not be followed farther: {error}" if point.alone else FAMILIES,
    )
    return _at_border(followed) or lost


def _homoclinic(
    followed: Sequence[BranchPoint], rest: str, options: BranchOptions
) -> DetectedEvent:
    """The end at which the period grows beyond all bounds."""
    value, error = limit_of_periods(followed, options.still)
    last = followed[-1]
    error += 1e-15 * (last.setting.spans[0] + abs(last.value))
    return DetectedEvent("homoclinic", last.orbit, error, how=rest, value=value)


def _rests(orbit: Orbit, still: float) -> str:
    """Text that names the state at which an orbit of long period comes to rest; empty if its rate
    is nowhere below ``still``.

    The rate is evaluated at the extrema, or along the whole orbit if it only rotates.
    """
    states = [extremum.state for extremum in orbit.extrema()] or list(orbit.samples().states.T)
    sizes = [norm(orbit.rate(state)) for state in states]
    if min(sizes) >= still:
        return ""
    slowest = np.round(states[int(np.argmin(sizes))], 6) + 0.0  # no −0
    return Remark("it comes to rest near {}", orbit.field.place(slowest, "g"))


@dataclass(frozen=True, eq=False)
class EventCurve(Result):
    """A curve of events in the plane of two parameters.

    Attributes
    ----------
    kind : str
    vary : tuple of str
    values : ndarray, shape (n, 2)
    periods : ndarray, shape (n,)
    how : tuple of str
        Reason for which the curve ends, at its first and at its last point.
    cycles : tuple of Cycle
    """

    kind: str
    vary: tuple[str, str]
    values: FloatArray
    periods: FloatArray
    how: tuple[str, str]
    cycles: tuple[Cycle, ...] = field(repr=False)

    @property
    def _of_model(self) -> Model | None:
        return self.cycles[0].field.model


@in_usual_state
def cycle_events(
    event: CycleEvent,
    vary: tuple[str, str],
    *,
    between: Ranges | None = None,
    points: int = 60,
) -> EventCurve:
    """Follow a fold, doubling, torus or grazing of cycles in two parameters.

    Parameters
    ----------
    event : CycleEvent
        An event of a branch.
    vary : tuple of str
        Names of two parameters.
    between : mapping, optional
        Ranges by the parameters' names; the curve ends where it leaves one.
    points : int
        Maximum number of points in each direction.

    Returns
    -------
    EventCurve

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, and events of another kind.

    Notes
    -----
    Newton's method for the closed orbit, with the event's test function as a further equation. With
    the monodromy matrix R restricted to directions across the flow it is det(1 − R) = 0 for a fold
    and det(1 + R) = 0 for a doubling. For a grazing the border's level and its rate are 0 at the
    first state.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(43.1))
    >>> found = ss.cycle(p, V=0.5, d=10.0, near=(2.54, 3.36, 0, 0.36))
    >>> branch = ss.cycle_branch(found, "theta0", between={"theta0": np.radians([43.09, 43.13])})
    >>> (doubling,) = branch.of("period_doubling")
    >>> curve = ss.cycle_events(doubling, ("theta0", "mu0"), points=1)
    >>> np.degrees(curve.values[:, 0]).round(2).tolist(), curve.values[1, 1].item()
    ([43.03, 43.12, 43.21], 0.5)
    """
    require_kind(
        "event", event, CycleEvent, "one of the events of a branch, of ss.cycle_branch(...)"
    )
    if event.kind not in (*CRITERIA, BRANCH_POINT, "grazing"):
        raise ParameterError(
            f"event = {event.kind} is not followed in two parameters; give a fold, "
            "branch_point, period_doubling, torus or grazing"
        )
    model = event.cycle.field
    free = tuple(model.parameters.index(one_of("vary", name, model.parameters)) for name in vary)
    if len(vary) != 2 or vary[0] == vary[1]:
        raise ParameterError(f"vary = {vary!r} is not two parameters")
    orbit = event.found.orbit
    allowed = {name: ANGLE if model.column(name).is_angle else FINITE for name in vary}
    given = as_ranges("between", between, allowed)
    bounds = [given.get(name, (-np.inf, np.inf)) for name in vary]
    spans = []
    for index, (low, high) in zip(free, bounds, strict=True):
        span = (high - low) / 2
        if not 0 < span < np.inf:  # no range is given
            span = max(0.25 * abs(orbit.values[index]), 0.02)
        spans.append(span)
    holds = partial(at_zero, "fold" if event.kind == BRANCH_POINT else event.kind)
    if event.kind == "grazing":
        holds = partial(touching, event.found.border)
    setting = Setting(orbit.flow, free, event.cycle.period / orbit.field.time, tuple(spans), holds)
    first = point_of(setting, setting.integrated(orbit.guess))

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        with doing("the curve of events beside {:.6g}", point.value):
            return corrected(point, length, reach=0.5, iterations=9)

    step_options = BranchOptions(first_step=0.01, longest_step=0.1, shortest_step=1e-6, kink=1e-4)

    def followed(direction: float) -> tuple[list[Orbit], str]:
        """Orbits in one direction, and the reason for which they end."""
        found: list[Orbit] = []
        try:
            for point in islice(steps(first.oriented(direction), ahead, step_options), points):
                varied = zip(point.orbit.guess.varied, bounds, strict=True)
                if not all(low <= value <= high for value, (low, high) in varied):
                    return found, "the range ends"
                if event.kind == "torus" and not is_complex_pair(point.orbit):
                    return found, "its multipliers become real"
                found.append(point.orbit)
        except (ConvergenceError, np.linalg.LinAlgError) as error:
            return found, f"it could not be followed farther: {error}"
        return found, all_followed(points)

    (back, why_back), (forth, why_forth) = followed(-1.0), followed(1.0)
    orbits = [*reversed(back), first.orbit, *forth]
    cycles = tuple(cycle_of(each) for each in orbits)
    return EventCurve(
        event.kind,
        vary,
        np.array([each.guess.varied for each in orbits]),
        np.array([each.period for each in orbits]),
        (why_back, why_forth),
        cycles,
    )
