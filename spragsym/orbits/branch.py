"""Branches of cycles in one parameter, with all that happens on them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..models.field import Field
from ..models.parameters import FINITE, POSITIVE, FloatArray, as_count, as_number
from ..motion.shooting import Loop, extent, rate
from ..numerics.interval_arrays import BoolArray
from ..progress import doing
from ..remarks import At, Remark
from ..results.result import Result
from .arclength import STRAIGHT, Point, Setting, aligned, angle, between, cut_finer, placed, started, within
from .events import MERGES, Finding, NotLocated, Seen, findings, vertical
from .orbit import Cycle, Cycles, cycle_of, is_stable, moments, range_of, sampled
from .switching import NEAREST, between_halves, halved, in_halves, meets, switched

#: Lengths of a step along the arc: the first, the longest, and the one below which a branch is given up.
FIRST, LONGEST, SHORTEST = 0.004, 0.08, 1e-9

#: Periods of the first cycle beyond which a branch ends, if its cycle comes to rest somewhere.
LONG = 6.0

#: States move by no more than this in one step, nor by more than this share of the orbit's extent, however small that is in the
#: model's units: an equilibrium is a closed orbit of every period, and Newton's method may not fall onto it.
FAR, SHARE = 0.5, 0.3

#: An orbit of a smaller extent, or of a smaller share of the first one's, has shrunk onto an equilibrium.
LEAST = 1e-3

#: Share of the first cycle's extent below which a branch has shrunk onto an equilibrium where the parameter turns back.
SHRUNK = 0.1

#: Slowest part of an orbit that is said to come to rest.
STILL = 2e-3


#: Cycles at one value of the parameter whose periods, ranges and averages differ by less than this, relatively, are one.
ALIKE = 1e-7

#: Kinds of event at which stability may change.
CHANGING = ("fold", "period_doubling", "torus")

VERTICAL = "the parameter stays what it is along the branch: there is a whole family of cycles at this one value"


@dataclass(frozen=True, eq=False)
class CycleEvent(Result):
    """A bifurcation, a grazing or an end on a branch of cycles.

    Attributes
    ----------
    kind : {"fold", "period_doubling", "torus", "grazing", "homoclinic", "end"}
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
    how: str = ""
    border: int = field(default=-1, repr=False)
    loop: Loop | None = field(default=None, repr=False)
    crossed: FloatArray | None = field(default=None, repr=False)
    vary: str = field(default="value", repr=False)

    @property
    def table_model(self) -> Field:
        """It knows whether the parameter is an angle."""
        return self.cycle.field


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
        Each begun anew where its first coordinate is largest when it is asked for.
    events : tuple of CycleEvent
        In the order of the branch.
    places : tuple of int
        How many points of the branch come before each event.
    """

    vary: str
    values: FloatArray
    periods: FloatArray
    rms: FloatArray
    lowest: FloatArray
    highest: FloatArray
    stable: BoolArray
    cycles: Cycles = field(repr=False)
    events: tuple[CycleEvent, ...]
    to: tuple[float, float] = field(repr=False)
    places: tuple[int, ...] = field(repr=False)

    @property
    def table_model(self) -> Field | None:
        """It knows whether the parameter is an angle."""
        return self.cycles.field

    def switch(self, event: CycleEvent, *, step: float = 0.02) -> Cycle:
        """A cycle on the other branch at an event, where :func:`cycle_branch` can begin.

        That is the doubled cycle at a period doubling, or, at the end of a branch of doubled cycles, the cycle that doubles
        there; where another branch crosses (a fold whose ``how`` says so) a cycle on that one; at another fold a cycle on the
        far side of it. ``step`` is how far off, in states.
        """
        return switched(self, event, step)

    @property
    def amplitude(self) -> FloatArray:
        """Half of the range of the first coordinate, shape (n,)."""
        return (self.highest - self.lowest) / 2

    def changes(self) -> Iterator[tuple[int, CycleEvent]]:
        """Events at which the stability changes, each with the number of points before it."""
        for place in (np.flatnonzero(np.diff(self.stable)) + 1).tolist():
            between = [
                event for event, before in zip(self.events, self.places, strict=True)
                if before == place and event.kind in CHANGING
            ]  # fmt: skip
            if between:
                yield place, between[0 if self.stable[place - 1] else -1]

    def of(self, *kinds: str) -> tuple[CycleEvent, ...]:
        """The events of some kinds only."""
        return tuple(event for event in self.events if event.kind in kinds)


def cycle_branch(
    cycle: Cycle, vary: str, to: tuple[float, float], *, points: int = 400, longest: float = LONGEST
) -> CycleBranch:  # fmt: skip
    """Follow a cycle as a parameter varies, through folds, to both ends of a range or to where the branch ends.

    Parameters
    ----------
    cycle : Cycle
        Where to begin.
    vary : str
        One of the parameters: theta0 (radians), V, d, mu0, kappa, alpha, sigma, beta; of other models their own.
    to : tuple of float
        The range; the branch is followed both ways from the cycle.
    points : int
        Most points each way.
    longest : float
        Longest step, as a length in states, shares of the period and halves of the range.

    Returns
    -------
    CycleBranch

    Raises
    ------
    ParameterError
        For a parameter that the model does not have, a range without the cycle's own value, or beyond what it may be, no points,
        or a step that is not positive.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(42)), V=0.5, d=10.0)
    >>> branch = ss.cycle_branch(found, "theta0", np.radians([41.5, 42.5]))
    >>> [event.kind for event in branch.events]
    ['end', 'end']
    """
    model = cycle.field
    if vary not in model.parameters:
        raise ParameterError(f"vary = {vary!r} is not one of {', '.join(model.parameters)}")
    index = model.parameters.index(vary)
    low, high = (as_number("to", value, FINITE) for value in to)
    for bound in (low, high):
        model.check(vary, bound)
    points, longest = as_count("points", points), as_number("longest", longest, POSITIVE)
    value = cycle.values[index]
    if not low <= value <= high or low == high:
        raise ParameterError(f"to = ({low:g}, {high:g}) is no range around {vary} = {value:.10g} of the cycle; give one")
    setting = Setting(cycle.loop.flow, (index,), cycle.period, ((high - low) / 2,))
    trace = _Trace(started(setting, in_halves(cycle.loop, setting).guess), (low, high), points, longest)
    back, forth = (list(trace.follow(sign)) for sign in (-1.0, 1.0))
    closed = back and isinstance(back[-1], Finding) and back[-1].kind == "closed"
    items = [*reversed(back), trace.start, *([] if closed else forth)]
    loops, events, places = [], [], []
    for item in items:
        if isinstance(item, Point):
            loops.append(item.loop)
        elif item.kind != "closed":
            events.append(trace.event(item))
            places.append(len(loops))
    lowest, highest = np.array([range_of(loop) for loop in loops]).T
    return CycleBranch(
        vary, np.array([loop.values[index] for loop in loops]), np.array([loop.period for loop in loops]),
        np.array([moments(loop)[1] for loop in loops]), lowest, highest,
        np.array([is_stable(loop) for loop in loops]), Cycles(tuple(loops)), tuple(events), (low, high),
        tuple(places),
    )  # fmt: skip


@dataclass(frozen=True)
class _Trace:
    """One walk along a branch."""

    start: Point
    to: tuple[float, float]
    points: int
    longest: float

    def event(self, found: Finding) -> CycleEvent:
        """An event as users see it."""
        (index,) = self.start.setting.free
        value = found.loop.values[index] if found.value is None else found.value
        return CycleEvent(
            found.kind, value, cycle_of(found.loop), found.error, found.how, found.border, found.loop, found.crossed,
            found.loop.field.parameters[index],
        )  # fmt: skip

    def follow(self, direction: float) -> Iterator[Point | Finding]:
        """Points and findings in one direction, an end the last of them."""
        start = point = self.start.turned(direction)
        length, before, count = FIRST, None, 0
        seen = Seen(point)
        while count < self.points:
            try:
                with doing("cycle {} in one direction of the branch, beside {:.6g}", count + 1, point.value):
                    ahead = within(point, length, self.to, _reach(point))
            except ConvergenceError as error:
                length /= 3
                if length < SHORTEST:
                    yield self._lost(point, error)
                    return
                continue
            straight = angle(point, ahead)
            if straight < STRAIGHT and length > 1e-6:
                length /= 2.5
                continue
            stops = ahead.value in self.to
            if stops and aligned(point, ahead) < STRAIGHT and length > 1e-6:
                length /= 2.5  # at the end of the range there may be other sheets: it must be reached along this one
                continue
            arc = between(point, ahead) if stops else length
            met = meets(point, ahead)
            if met is not None and arc > NEAREST * extent(ahead.loop):
                length = arc / 2  # what happens on the way is to be seen
                continue
            merged = None if met is None else halved(point.setting, *between_halves(point, ahead, met))
            if merged is not None:
                yield Finding("end", *merged, how=MERGES)
                return
            after = Seen(ahead)
            try:
                happened = list(findings(seen, after, arc, before))
            except NotLocated:
                length = arc / 3
                continue
            for found in happened:
                if found.kind == "fold" and extent(found.loop) < SHRUNK * extent(start.loop):
                    yield self._shrunk(before, seen.point)
                    return
                yield found
            yield ahead
            count += 1
            if vertical(seen, after, arc):
                yield Finding("end", ahead.loop, abs(ahead.value - point.value), how=VERTICAL)
                return
            if stops:
                yield Finding("end", ahead.loop, 0.0, how="the range ends")
                return
            end = self._ends(start, point, ahead, count)
            if end is not None:
                yield end
                return
            finer = cut_finer(ahead)
            before = seen if finer is ahead else None
            point, seen = finer, after if finer is ahead else Seen(finer)
            length = min(self.longest, length * (1.6 if straight > 0.995 else 1.1))
        yield Finding("end", point.loop, abs(float(point.tangent[-1]) * length), how=f"{self.points} points were followed")

    def _shrunk(self, before: Seen | None, last: Point) -> Finding:
        """The end at an equilibrium: by Hopf's theorem the square of the extent is linear in the parameter near it."""
        how = "it shrinks onto an equilibrium"
        if before is None:
            return Finding("end", last.loop, abs(last.value), how=how)
        first, square = (extent(each.loop) ** 2 for each in (before.point, last))
        off = square * (last.value - before.point.value) / (square - first)
        return Finding("end", last.loop, abs(off) * square / first, how=how, value=last.value - off)

    def _ends(self, start: Point, point: Point, ahead: Point, count: int) -> Finding | None:
        loop, moved = ahead.loop, abs(ahead.value - point.value)
        if extent(loop) < LEAST * min(1.0, extent(start.loop)):
            return Finding("end", loop, moved, how="it shrinks onto an equilibrium")
        if loop.period > LONG * start.setting.period and stillest(loop)[0] < STILL:
            return Finding("homoclinic", loop, moved + 1e-15 * (1 + abs(ahead.value)), how=_rests(loop))
        return Finding("closed", loop, 0.0) if count > 10 and self._passes(start, point, ahead) else None

    def _passes(self, start: Point, point: Point, ahead: Point) -> bool:
        """Whether the start's cycle lies on the step from one point to the next, passed the same way: a branch that closes.

        Its states need not be those of the start: on the way round they may have gone on along the orbit.
        """
        loop, way = start.loop, ahead.value - point.value
        share = (start.value - point.value) / way if way else -1.0
        if not 0 <= share <= 1 or way * float(start.tangent[-1]) <= 0:
            return False
        expected = (1 - share) * point.loop.period + share * ahead.loop.period
        if abs(expected - loop.period) > 1e-3 * loop.period:
            return False
        try:
            met = placed(point, start.value).loop
        except ConvergenceError:
            return False
        return bool(
            abs(met.period / loop.period - 1) < ALIKE
            and np.abs(np.subtract(self._shape(met), self._shape(loop))).max() < ALIKE * extent(loop)
        )

    def _shape(self, loop: Loop) -> tuple[float, ...]:
        """What does not depend on where a round begins: range and averages."""
        return (*range_of(loop), *moments(loop))

    def _lost(self, point: Point, error: ConvergenceError) -> Finding:
        loop = point.loop
        if loop.period > 2 * point.setting.period and stillest(loop)[0] < STILL:
            return Finding("homoclinic", loop, 1e-6, how=_rests(loop))
        return Finding("end", loop, SHORTEST, how=f"it could not be followed farther: {error}")


def _reach(point: Point) -> float:
    """How far the states of the next point may lie."""
    return min(FAR, SHARE * extent(point.loop))


def stillest(loop: Loop) -> tuple[float, FloatArray]:
    """Least size of the field at the turns of an orbit, or all along one that only turns around, and where that is."""
    states = [turn.state for turn in loop.turns()] or list(sampled(loop).states.T)
    sizes = [float(np.linalg.norm(rate(loop.field, state, loop.constants))) for state in states]
    return min(sizes), states[int(np.argmin(sizes))]


def _rests(loop: Loop) -> str:
    """Where an orbit of a very long period hardly moves, without the sign of a zero."""
    names, place = loop.field.coordinates, np.round(stillest(loop)[1], 6) + 0.0
    told = [At(name, (float(value),), "g", " rad" * loop.field.is_angle(name)) for name, value in zip(names, place, strict=False)]
    return Remark(f"it comes to rest near {', '.join(['{}'] * len(told))}", *told)
