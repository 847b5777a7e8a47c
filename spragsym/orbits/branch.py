"""Branches of cycles in one parameter, with all that happens on them, and curves of these events in
two parameters.
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
    placed,
    point_of,
    remeshed_point,
    started,
    steps,
    turning,
    within,
)
from .events import (
    MERGES,
    SLIDING,
    DetectedEvent,
    approaches,
    detected_events,
    sliding_entries,
    touching,
    vertical,
)
from .options import BranchOptions
from .orbit import Cycle, Cycles, cycle_of, is_stable, range_of, same_cycle
from .switching import halved, meets, switched

FAMILIES = "there is a whole family of cycles at every value of the parameter from there on"


@dataclass(frozen=True, eq=False)
class CycleEvent(Result):
    """A bifurcation, a grazing or an end on a branch of cycles.

    Attributes
    ----------
    kind : str
        "fold", "period_doubling", "torus", "grazing", "homoclinic" or "end".
        Under dry friction also the sliding bifurcations, at each of which a phase of one side of
        the branch shrinks to nothing: "grazing-sliding", one of sticking, where the orbit touches
        x′ = V in contact; "crossing-sliding", one of sticking, where it comes to x′ = V at the edge
        of what sticks and passes; "switching-sliding", one of slip between such an edge and
        sticking; "adding-sliding", one of slip between two of sticking, where the force that holds
        touches its limit. A touch of x′ = V in lift-off is a "grazing". The branch ends in a
        "catastrophic-sliding" where the arrival at x′ = V, or that of the force at its limit,
        becomes tangent.
    value : float
        Of the parameter.
    cycle : Cycle
        The cycle there, or the last one before it.
    error : float
        How well the value is known.
    how : str
        What is touched, why the branch ends, or that a multiplier jumps past its value.
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
        """The event in a cell of a table."""
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
        Of the parameter and of the cycles; the last three of the first coordinate.
    stable : ndarray of bool, shape (n,)
    cycles : sequence of Cycle
        Each begun anew where its first coordinate that moves is largest when it is asked for.
    events : tuple of CycleEvent
        In the order of the branch.
    places : tuple of int
        How many points of the branch come before each event.
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
        """A cycle on the other branch at an event, where :func:`cycle_branch` can begin.

        That is the doubled cycle at a period doubling, or, at the end of a branch of doubled
        cycles, the cycle that doubles there; where another branch crosses (a fold whose ``how``
        says so) a cycle on that one; at another fold a cycle on the far side of it. ``step`` is how
        far off, in states.

        Parameters
        ----------
        event : CycleEvent
            One of those of the branch.
        step : float
            How far off, in states.

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
        """Half of the range of the first coordinate, shape (n,)."""
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
                if before == index and event.kind in CRITERIA
            ]
            if between:
                yield index, between[0 if self.stable[index - 1] else -1]

    def of(self, *kinds: str) -> tuple[CycleEvent, ...]:
        """The events of some kinds only.

        Parameters
        ----------
        *kinds : str
            As in :attr:`CycleEvent.kind`.

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
        # Kinds of event, those first at which stability may change.
        offered = (*CRITERIA, "grazing", *SLIDING, "homoclinic", "catastrophic-sliding", "end")
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
    """Follow a cycle as a parameter varies, through folds, to both ends of a range or to where the
    branch ends.

    Parameters
    ----------
    cycle : Cycle
        Where to begin.
    vary : str
        One of the parameters: theta0 (radians), V, d, mu0, kappa, alpha, sigma, beta; of other
        models their own.
    between : mapping
        Its range, by its name; the branch is followed both ways from the cycle.
    points : int
        Most points each way.
    options : BranchOptions, optional
        Lengths of steps and other limits, by default :class:`spragsym.BranchOptions`.

    Returns
    -------
    CycleBranch

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, a range without the cycle's own value, or
        beyond what it may be, or no points.

    Notes
    -----
    A doubling, a torus or a crossing is told where its test function changes its sign by more than
    the error of the multipliers: none is told where nothing damps, and multipliers stay on the unit
    circle.

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
    pieces = len(own.states)  # an even number, so that halves of a doubled cycle are seen
    begun = remeshed(own, 2 * pieces) if pieces % 2 else own.guess
    start = remeshed_point(started(setting, begun))
    back = list(_followed([start.oriented(-1.0)], (low, high), points, options))
    behind = [item.oriented(-1.0) for item in back if isinstance(item, BranchPoint)]
    forth = list(_followed([*behind[:1], start], (low, high), points, options))
    closed = back and isinstance(back[-1], DetectedEvent) and back[-1].kind == "closed"
    items = [*reversed(back), start, *([] if closed else forth)]
    orbits, events, places = [], [], []
    for item in items:
        if isinstance(item, BranchPoint):
            orbits.append(item.orbit)
        elif item.kind != "closed":
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
    stable = np.array([is_stable(orbit) for orbit in orbits])
    return CycleBranch(
        vary,
        values,
        periods,
        rms,
        lowest,
        highest,
        stable,
        Cycles(tuple(orbits)),
        tuple(events),
        (low, high),
        tuple(places),
    )


def _followed(
    followed: list[BranchPoint], to: Span, points: int, options: BranchOptions
) -> Iterator[BranchPoint | DetectedEvent]:
    """Points and findings in one direction behind the last of some points, an end the last of
    them.
    """
    start = followed[-1]
    first_extent = extent(start.orbit)

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        with doing("the branch of cycles beside {:.6g}", point.value):
            return within(point, length, to, min(options.move, options.share * extent(point.orbit)))

    def look(
        point: BranchPoint, found: BranchPoint, length: float
    ) -> list[BranchPoint | DetectedEvent]:
        arc = between(point, found) if found.value in to else length
        if (met := meets(point, found)) is not None:
            if arc > options.meeting * extent(found.orbit):
                raise ConvergenceError("the halves of the orbit meet on the way")
            if merged := halved(point, found, met):
                return [DetectedEvent("end", *merged, how=MERGES)]
        if not found.alone:
            if length > options.event_step and point.alone:
                raise ConvergenceError("the orbit is one of a whole family")
            return [*_joins(followed, found)]
        items = list[BranchPoint | DetectedEvent]()
        before = followed[-2] if len(followed) > 1 else None
        if (
            before and followed[-1] is not point
        ):  # it was cut anew, and is compared with what is cut like it
            before = corrected(point, -arc)
        for happened in detected_events(point, found, arc, before):
            if happened.kind == "fold" and extent(happened.orbit) < options.shrunk * extent(
                start.orbit
            ):
                return [*items, _shrunk(followed)]
            items.append(happened)
        if extent(found.orbit) < options.vanished * min(1.0, first_extent):
            return [*items, _shrunk(followed)]
        followed.append(found)
        return [*items, found, *_ends(start, point, found, arc, to, options)]

    try:
        for items in islice(steps(start, ahead, options, look), points):
            yield from items
            if isinstance(items[-1], DetectedEvent):
                return
    except ConvergenceError as error:
        yield _lost(followed, error, options)
        return
    before, last = [start, *followed][-2:]
    yield DetectedEvent(
        "end", last.orbit, abs(last.value - before.value), how=f"{points} points were followed"
    )


def _vanishing(
    points: Sequence[BranchPoint], size: Callable[[BranchPoint], float], how: str, kind: str = "end"
) -> DetectedEvent:
    """The end behind some points of a branch at which a size shrinks to 0.

    The parameter is a smooth function of the size, by parabolas through three points; three that
    differ least are taken, since next to the end rounding decides.
    """
    from scipy.interpolate import KroghInterpolator

    sizes = [(np.inf, np.nan)]
    for point in points:
        # Sizes of points by which it is told where a size vanishes are so far apart, as
        # a factor.
        if (now := size(point)) < 0.7 * sizes[-1][0]:
            sizes.append((now, point.value))
    ends = [
        float(KroghInterpolator(*zip(*sizes[i - 2 : i + 1], strict=True))(0.0))
        for i in range(3, len(sizes))
    ]
    each = ((float(np.ptp(ends[i - 2 : i + 1])), ends[i]) for i in range(2, len(ends)))
    off, value = min(each, default=(abs(points[-1].value), points[-1].value))
    # Error of an end by rounding, where a size vanishes, in ranges of the parameter.
    setting = points[-1].setting
    error = setting.options.scatter * off + 1e-12 * setting.spans[0]
    return DetectedEvent(kind, points[-1].orbit, error, how=how, value=value)


def _shrunk(followed: Sequence[BranchPoint]) -> DetectedEvent:
    """The end at an equilibrium: by Hopf's theorem the square of the extent is linear in the
    parameter near it.
    """
    return _vanishing(
        followed, lambda point: extent(point.orbit) ** 2, "it shrinks onto an equilibrium"
    )


def _at_border(followed: Sequence[BranchPoint]) -> DetectedEvent | None:
    """The end where an orbit comes to touch a border, or sticks at the limit of the force from the
    first, or where it comes to a border at a tangent; None elsewhere.
    """

    def off(point: BranchPoint) -> float:
        sticking = (touch.level for touch in sliding_entries(point) if touch.level > 0)
        return min((*sticking, *(abs(touch.level) for touch in point.touches)), default=np.inf)

    def slowest(point: BranchPoint) -> float:
        return min((rate for rate, _ in approaches(point)), default=np.inf)

    last = followed[-1]
    _, name = min(approaches(last), default=(np.inf, ""))
    ends = (
        _vanishing(
            followed,
            off,
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
    # A branch has come to an end that lies so near to its last point, in shares of the
    # range.
    near = [
        end
        for end in ends
        if max(end.error, abs(end.value - last.value)) <= 1e-4 * last.setting.spans[0]
    ]
    return min(near, key=lambda end: end.error, default=None)


def _ends(
    start: BranchPoint,
    point: BranchPoint,
    ahead: BranchPoint,
    length: float,
    to: Span,
    options: BranchOptions,
) -> Iterator[DetectedEvent]:
    """The end of the branch at a point, if it is one."""
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
        rounding = 1e-15 * (point.setting.spans[0] + abs(ahead.value))
        yield DetectedEvent("homoclinic", orbit, moved + rounding, how=rest)
    elif point is not start and _passes(start, point, ahead):
        yield DetectedEvent("closed", orbit, 0.0)


def _joins(followed: Sequence[BranchPoint], found: BranchPoint) -> Iterator[DetectedEvent]:
    """The end of a branch at the edge of a family of cycles, one of which is found, and what
    happens there.

    Where that is no event, a second multiplier comes to 1 with some power of the way, as a rule the
    second.
    """
    came, edge = sliding_entries(followed[-1]), _at_border(followed)
    how = FAMILIES if edge else f"a second multiplier comes to 1: {FAMILIES}, or hardly attracts"
    if edge:
        kind = "crossing-sliding" if len(sliding_entries(found)) == len(came) else "grazing-sliding"
        yield replace(edge, kind=kind, how=found.orbit.field.borders[came[0].way[0]].name)
    else:
        edge = _vanishing(
            followed,
            lambda point: float(np.sqrt(np.abs(point.orbit.multipliers.others - 1).min())),
            how,
        )
    yield replace(edge, how=how)


def _lost(
    followed: Sequence[BranchPoint], error: ConvergenceError, options: BranchOptions
) -> DetectedEvent:
    point = followed[-1]
    orbit = point.orbit
    if orbit.period > 2 * point.setting.period and (rest := _rests(orbit, options.still)):
        # Error of an end at an orbit that rests for long, in ranges of the parameter.
        return DetectedEvent("homoclinic", orbit, 1e-6 * point.setting.spans[0], how=rest)
    before = followed[-2] if len(followed) > 1 else point
    lost = DetectedEvent(
        "end",
        orbit,
        options.scatter * abs(point.value - before.value)
        + options.shortest_step * point.setting.spans[0],
        how=f"it could not be followed farther: {error}" if point.alone else FAMILIES,
    )
    return _at_border(followed) or lost


def _passes(start: BranchPoint, point: BranchPoint, ahead: BranchPoint) -> bool:
    """Whether the start's cycle lies on the step from one point to the next, passed the same way: a
    branch that closes.

    Its states need not be those of the start: on the way round they may have gone on along the
    orbit.
    """
    way = ahead.value - point.value
    if not (start.value - point.value) * (start.value - ahead.value) <= 0 < way * turning(start):
        return False
    try:
        return same_cycle(cycle_of(placed(point, start.value).orbit), cycle_of(start.orbit))
    except ConvergenceError:
        return False


def _rests(orbit: Orbit, still: float) -> str:
    """Place where an orbit of a very long period hardly moves, without the sign of a zero; nothing
    where it moves everywhere.

    By the size of the field at its turns, or all along one that only turns around.
    """
    states = [extremum.state for extremum in orbit.extrema()] or list(orbit.samples().states.T)
    sizes = [norm(orbit.rate(state)) for state in states]
    if min(sizes) >= still:
        return ""
    slowest = np.round(states[int(np.argmin(sizes))], 6) + 0.0
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
        Why the curve ends, at its first and at its last point.
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
        Of a branch.
    vary : tuple of str
        Two parameters.
    between : mapping, optional
        Parameter → range; the curve ends where it leaves it.
    points : int
        Most points each way.

    Returns
    -------
    EventCurve

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and events of another kind.

    Notes
    -----
    Newton's method on the closed orbit, with the event's test function as one more equation: for a
    fold det(1 − R) = 0 and for a doubling det(1 + R) = 0, R the monodromy matrix across the flow;
    for a grazing level and rate of the border at the start.

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
    if event.kind not in (*CRITERIA, "grazing"):
        raise ParameterError(
            f"event = {event.kind} is not followed in two parameters; give a fold, "
            "period_doubling, torus or grazing"
        )
    model = event.cycle.field
    free = tuple(model.parameters.index(one_of("vary", name, model.parameters)) for name in vary)
    if len(vary) != 2 or vary[0] == vary[1]:
        raise ParameterError(f"vary = {vary!r} is not two parameters")
    orbit = event.found.orbit
    allowed = {name: ANGLE if model.column(name).is_angle else FINITE for name in vary}
    given = as_ranges("between", between, allowed)
    bounds = [given.get(name, (-np.inf, np.inf)) for name in vary]
    # Span of a parameter whose range is not given, over its value, and at least.
    share_of_value, least_span = 0.25, 0.02
    spans = [
        (high - low) / 2
        if 0 < high - low < np.inf
        else max(share_of_value * abs(orbit.values[index]), least_span)
        for index, (low, high) in zip(free, bounds, strict=True)
    ]
    holds = (
        partial(touching, event.found.border)
        if event.kind == "grazing"
        else partial(at_zero, event.kind)
    )
    setting = Setting(orbit.flow, free, event.cycle.period / orbit.field.time, tuple(spans), holds)
    first = point_of(setting, setting.integrated(orbit.guess))

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        with doing("the curve of events beside {:.6g}", point.value):
            return corrected(point, length, reach=0.5, iterations=9)

    def followed(direction: float) -> tuple[list[Orbit], str]:
        found: list[Orbit] = []
        try:
            # Options of curves of events.
            of_events = BranchOptions(
                first_step=0.01, longest_step=0.1, shortest_step=1e-6, kink=1e-4
            )
            for point in islice(steps(first.oriented(direction), ahead, of_events), points):
                if not all(
                    low <= value <= high
                    for value, (low, high) in zip(point.orbit.guess.varied, bounds, strict=True)
                ):
                    return found, "the range ends"
                if event.kind == "torus" and not is_complex_pair(point.orbit):
                    return found, "its multipliers become real"
                found.append(point.orbit)
        except (ConvergenceError, np.linalg.LinAlgError) as error:
            return found, f"it could not be followed farther: {error}"
        return found, f"{points} points were followed"

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
