"""What an integrator gives: a motion by its samples and the borders passed, or the flow over a
time: its end and derivatives.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..core.errors import ConvergenceError, ParameterError, one_of
from ..display import Column
from ..models.field import FLOATS, JUMPED, OVERSHOOT, Border, Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray, IndexArray
from ..numerics.vectors import magnitude
from ..results.result import Rows
from .lobatto import PiecewisePolynomial, sample_times
from .problem import Event, Problem, kinds_of

#: A border that was passed no longer ago is met to first order: the square of that, in the
#: motion's unit of time, is below rounding.
AT_ONCE = 1e-8


class Crossing(NamedTuple):
    """A border passed: when, which, to which sign of its level, the state there, and from which
    sign.
    """

    t: float
    border: int
    sign: int
    state: FloatArray
    came: int


@dataclass(frozen=True, eq=False)
class CarriedState:
    """A state of a motion, with its derivatives by the start and by ``directions`` of the
    parameters: ``columns``, None where none are carried. Both are moved in place where the field
    jumps.
    """

    problem: Problem
    state: FloatArray
    directions: FloatArray | None = None
    columns: FloatArray | None = None

    def initial_mode(self) -> Mode:
        """The mode in which a motion begins; a state that sticks, and its derivatives, are
        projected onto the border.
        """
        mode = self.problem.field.initial_mode(self.state.tolist(), self.problem.constants)
        self.project(mode)
        return mode

    def project(self, mode: Mode) -> None:
        """Project the state onto the border on which it stays in a mode, and its derivatives onto
        the tangent of that.
        """
        field = self.problem.field
        for border in field.stays(mode):
            at, values = border.place, self.state.tolist()
            ways = [(*mode[:at], side, *mode[at + 1 :]) for side in (1, -1)]
            rates = [field.level_rate(border, values, self.problem.constants, way) for way in ways]
            fastest = ways[int(np.argmax(np.abs(rates)))]
            self.saltation(border, (fastest, mode))

    def passed(self, row: int, mode: Mode, t: float) -> tuple[Mode, tuple[Crossing, ...]]:
        """Continuation of a motion behind a border: its next mode, and the crossings, none where
        there is no kink; of several at one instant the border's own is the first. What is left at
        the same instant is left with it.

        Where the field jumps, the state and its derivatives are moved: they go on from the border
        itself, not from where it was noticed; so does one that leaves a border on which it stayed,
        from which errors of steps may have taken it. An error where the border does not say how.
        """
        done, crossings = set[int](), list[Crossing]()
        following: int | None = row
        while following is not None:
            done.add(following)
            mode, found = self._through(following, mode, t)
            crossings += found
            following = self._met(mode, done)
        return mode, tuple(crossings)

    def _met(self, mode: Mode, done: set[int]) -> int | None:
        """A border that is left at the same instant, but for rounding; None where there is none."""
        field, constants = self.problem.field, self.problem.constants
        values = self.state.tolist()
        for row, border in enumerate(field.borders):
            sign = border.sign(mode)
            if not sign or row in done:
                continue
            inside = sign * border.level(values, constants, mode) + OVERSHOOT * border.kink
            if (
                inside <= OVERSHOOT / 8
                and sign * field.level_rate(border, values, constants, mode) < 0
            ):
                return row
        return None

    def _through(self, row: int, mode: Mode, t: float) -> tuple[Mode, tuple[Crossing, ...]]:
        """:meth:`passed` through one border, and what begins or ends to stick with it."""
        field, constants = self.problem.field, self.problem.constants
        if field.sticking_borders:
            CarriedState(self.problem, self.state).project(mode)
        border = field.borders[row]
        last = border.beyond(mode, self.state.tolist(), constants)
        crossings = list[Crossing]()
        # What else begins or ends to stick at the same instant does so through a border of its own;
        # not where the contact opens on which it sticks.
        changed = (index for index, (a, b) in enumerate(zip(mode, last, strict=True)) if a != b)
        others = [index for index in changed if index != border.place and border.slopes]
        for index in (border.place, *others):
            at = self.state.tolist(), constants
            if index != border.place:
                row, border = min(
                    (
                        (number, that)
                        for number, that in enumerate(field.borders)
                        if that.place == index and that.sign(mode)
                    ),
                    key=lambda each: each[1].sign(mode) * each[1].level(*at, mode),
                )
            after = (*mode[:index], last[index], *mode[index + 1 :]) if others else last
            sign, came = int(border.sign(after)), int(border.sign(mode))
            crossing = Crossing(t, row, sign, self.state.copy(), came)
            if border.jumps is not None and border.jumps(*at):
                if border.slopes is not None:
                    late, there = self.saltation(border, (mode, after))
                    crossing = crossing._replace(t=max(t - late, 0.0), state=there)
                elif self.directions is not None:
                    raise ConvergenceError(JUMPED)
            crossings += [crossing] * border.kink
            mode = after
        return mode, tuple(crossings)

    def saltation(self, border: Border, modes: tuple[Mode, Mode]) -> tuple[float, FloatArray]:
        """Move the state and its derivatives by the saltation matrix 1 + (f⁺ − f⁻) ∇h/ḣ⁻ of a
        border h = 0 between two modes; by how long ago it was passed, and the state there.

        Where that is so long ago that its square counts, they are carried back to the border in one
        mode, and on from there in the other.
        """
        border_at = self._back(border, modes[0])
        if border_at is None:
            return 0.0, self.state.copy()
        late, there, own, rate = border_at
        directions, m = self.directions, len(self.state)
        field, constants, values = self.problem.field, self.problem.constants, there.tolist()
        before, behind = (field.rates(values, constants, mode) for mode in modes)
        jump = (behind - before) / rate
        if self.columns is not None and border.slopes is not None and directions is not None:
            slopes = np.array(border.slopes(values, constants, modes[0]), dtype=float)
            turned = slopes[:m] @ own
            turned[m:] += slopes[m:] @ directions.T if directions.size else 0.0
            own = own + np.outer(jump, turned)
        if abs(late) > AT_ONCE and there is not self.state:
            self.state[:], own = replace(self, state=there, columns=own).later(modes[1], late)
        else:
            there = self.state - late * before
            self.state[:] += jump * border.level(values, constants, modes[0])
        if self.columns is not None:
            self.columns[:] = own
        return late, there

    def _back(
        self, border: Border, mode: Mode
    ) -> tuple[float, FloatArray, FloatArray, float] | None:
        """Time since a border was passed, with state, derivatives and the level's rate there: by
        Newton's method, if that leads back a short time, else to first order; None where nothing
        brings a motion across.
        """
        field, constants = self.problem.field, self.problem.constants
        own = np.empty((len(self.state), 0)) if self.columns is None else self.columns

        def ago(at: FloatArray) -> tuple[float, float]:
            values = at.tolist()
            rate = field.level_rate(border, values, constants, mode)
            return (float(border.level(values, constants, mode)) / rate if rate else math.inf), rate

        first, rate = ago(self.state)
        if not rate:
            return None
        late = first
        # Newton's method leads back to a border that was passed no longer ago than this.
        latest = 1.0
        if AT_ONCE < abs(late) < latest:
            # Steps of Newton's method, at most.
            for _ in range(5):
                there, along = self.later(mode, -late)
                more, rate_there = ago(there)
                if abs(more) <= AT_ONCE:
                    return late, there, along, rate_there
                late += more
                if not abs(late) < latest:
                    break
        return first, self.state, own, rate

    def later(self, mode: Mode, duration: float) -> tuple[FloatArray, FloatArray]:
        """The state and its derivatives a short time on in a mode, by the classical Runge–Kutta
        method of fourth order.
        """
        columns, m = self.columns, len(self.state)
        begun = self.state if columns is None else np.append(self.state, columns)
        rates = rates_of(self.problem, mode, None if columns is None else self.directions)
        # Steps of the Runge-Kutta method back to the border are no longer than this.
        parts = math.ceil(abs(duration) / 0.01)
        step = duration / parts
        for _ in range(parts):
            first = rates(0.0, begun)
            second = rates(0.0, begun + step / 2 * first)
            third = rates(0.0, begun + step / 2 * second)
            last = rates(0.0, begun + step * third)
            begun = begun + step / 6 * (first + 2 * second + 2 * third + last)
        return begun[:m], begun[m:].reshape(m, -1)


def rates_of(
    problem: Problem, mode: Mode, directions: FloatArray | None, xp: object = FLOATS
) -> Callable[[float, FloatArray], FloatArray]:
    """The right-hand side in a mode: of a state, and unless ``directions`` is None of its
    derivatives behind it, row by row.
    """
    field, constants = problem.field, problem.constants
    m, n = field.size, len(field.coordinates)

    def rates(_: float, whole: FloatArray) -> FloatArray:
        state = whole[:m].tolist()
        own = field.rates(state, constants, mode, xp)
        if directions is None:
            return own
        change = field.matrix(state, constants, mode, xp) @ whole[m:].reshape(m, -1)
        if directions.size:
            slopes = np.array(field.by_parameters(state, constants, mode, xp), dtype=float)
            change[n:, m:] += slopes @ directions.T
        return np.append(own, change)

    return rates


class Extremum(NamedTuple):
    """A zero of a rate: of a border's level, which is extremal there, or (border −1) of the leading
    coordinate.

    ``direction`` is the sign of the rate's own rate: −1 at a largest value.
    """

    t: float
    border: int
    direction: int
    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray


@dataclass(frozen=True)
class FlowResult:
    """Flow over a time: where it ends, (m,), and derivatives of that.

    Those by the state at the start, (m, m), are the product over the smooth pieces, with saltation
    matrices where the field jumps between them; those by the parameters, (m, k), are along k
    directions. The ``integrals`` of the first coordinate and of its square over time are NaN where
    the integrator does not carry them along.
    """

    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray
    crossings: tuple[Crossing, ...]
    extrema: tuple[Extremum, ...]
    integrals: tuple[float, ...] = (np.nan, np.nan)


#: Carries a state on: ``flow_map(state, constants, duration, directions)``, directions of shape (k,
#: P).
FlowMap: TypeAlias = Callable[[FloatArray, Values, float, FloatArray], FlowResult]


def parted(
    state: FloatArray, columns: FloatArray | None
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """A state and its derivatives by the start and by the parameters; empty where there are
    none.
    """
    whole = np.empty((0, 0)) if columns is None else columns.copy()
    return state.copy(), whole[:, : len(state)], whole[:, len(state) :]


#: Times and states of some steps at their Lobatto points, shapes (steps, DEGREE + 1) and (steps, 2
#: n, DEGREE + 1).
Samples: TypeAlias = tuple[FloatArray, FloatArray]


@dataclass(frozen=True)
class Solution:
    """A motion as polynomials, its crossings of kinks, and how it was carried.

    An implicit method carried it where explicit steps collapsed; ``rtol`` is the tolerance used, 0
    until it is known.
    """

    samples: PiecewisePolynomial
    crossings: tuple[Crossing, ...]
    implicit: bool = False
    rtol: float = 0.0


def assembled(
    pieces: Sequence[Samples], crossings: Sequence[Crossing], t_record: float
) -> Solution:
    """From samples by steps to samples in a row."""
    # A piece by itself, which may be large, is not copied.
    t, states = (
        pieces[0]
        if len(pieces) == 1
        else (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    )
    for crossing in crossings:
        t, states = _met_in_time(t, states, crossing)
    samples = PiecewisePolynomial(
        np.append(t[:, :-1].ravel(), t[-1, -1]),
        np.append(
            states[:, :, :-1].swapaxes(0, 1).reshape(states.shape[1], -1),
            states[-1, :, -1:],
            axis=1,
        ),
    )
    if t_record > t[0, 0]:
        samples = samples.after(t_record)
    return Solution(samples, tuple(crossing for crossing in crossings if crossing.t >= t_record))


def _met_in_time(t: FloatArray, states: FloatArray, crossing: Crossing) -> Samples:
    """Steps of which one ends and the next begins where a border was met, each by its own
    polynomial, if they do not meet where that was noticed; so shortly behind it that the mode is
    told by the sample.
    """
    row = int(np.searchsorted(t[:, -1], crossing.t))
    if row + 1 >= len(t):
        return t, states
    apart, late = magnitude(states[row + 1, :, 0] - states[row, :, -1]), t[row, -1] - crossing.t
    # Steps that are farther apart than this where a border was noticed meet so far behind
    # it.
    behind = 4 * OVERSHOOT
    if apart <= behind or not late < min(t[row, -1] - t[row, 0], t[row + 1, -1] - t[row, -1]):
        return t, states
    t, states, met = t.copy(), states.copy(), crossing.t + behind / apart * late
    for which, ends in ((row, (t[row, 0], met)), (row + 1, (met, t[row + 1, -1]))):
        own, t[which] = PiecewisePolynomial(t[which].copy(), states[which]), sample_times(*ends)
        states[which] = own(t[which])
    return t, states


def without_chatter(solution: Solution, problem: Problem) -> Solution:
    """Without crossings of a border after which the motion does not leave it by more than the error
    of a step.

    A motion that comes to rest on a border is on either side of it by that error, and passes it no
    further.
    """
    t, states, chatter = solution.samples.t, solution.samples.states, set[int]()
    least = max(10 * problem.rtol * float(max(states.max(), -states.min())), 2 * OVERSHOOT)
    for row, border in enumerate(problem.field.borders):
        own = [crossing for crossing in solution.crossings if crossing.border == row]
        if not own or not border.crossings[0] or border.stays:
            continue
        level = np.abs(border.level(states, problem.constants, problem.field.modes[0]))
        farthest = np.maximum.reduceat(
            level, np.searchsorted(t, [crossing.t for crossing in own])
        ).tolist()
        before = -own[0].sign
        for crossing, far in zip(own, farthest, strict=True):
            after = crossing.sign * (far > least)
            if after in (0, before):
                chatter.add(id(crossing))
            before = after or before
    return replace(
        solution, crossings=tuple(each for each in solution.crossings if id(each) not in chatter)
    )


@dataclass(frozen=True, eq=False)
class Events(Rows):
    """Passages of kinks of the field, in order of time.

    Attributes
    ----------
    t : ndarray, shape (k,)
        Time. Contact is told to open or close 1e-12 of the gap's scale beyond its border, and so
        late by that over the speed of the gap, which the error of a trajectory does not hold: that
        is of its states.
    state : ndarray, shape (k, 2 n)
        Coordinates and rates there: y = 0 or x' = V to 1e-12 of the motion's scales.
    which : ndarray of int, shape (k,)
        Codes of :class:`Event`.
    components : tuple of str
        Names of the coordinates and rates.
    contact : tuple of str, length k
        The contact that opened or closed, or whose friction began or ended to stick or turned
        around, by its name; nothing where there is one contact.
    """

    schema = (
        Column("t", "s", "time of the event"),
        Column("which", "1", "what happened", Event),
        Column("contact", "1", "of which contact, where there are several"),
    )

    t: FloatArray
    state: FloatArray
    which: IndexArray
    components: tuple[str, ...] = field(repr=False)
    contact: tuple[str, ...] = field(default=(), repr=False)

    def __len__(self) -> int:
        return len(self.t)

    def of(self, *kinds: Event | str) -> Events:
        """The events of some kinds only, by members of :class:`Event` or their names, as
        "stick".

        Parameters
        ----------
        *kinds : Event or str
            Members or their names.

        Returns
        -------
        Events

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(V=0.1), t_end=50.0)
        >>> len(tr.events.of("stick")) == len(tr.events.of(ss.Event.STICK))
        True
        """
        words = {kind.name.lower(): kind for kind in Event}
        chosen = [
            kind if kind in [*Event] else words[one_of("kinds", str(kind).lower(), words)]
            for kind in kinds
        ]
        return self.select(np.isin(self.which, chosen))

    def select(self, chosen: BoolArray) -> Events:
        """The events that are marked.

        Parameters
        ----------
        chosen : ndarray of bool, shape (n,)

        Returns
        -------
        Events

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(V=0.1), t_end=50.0)
        >>> late = tr.events.select(tr.events.t > 25.0)
        >>> bool((late.t > 25.0).all())
        True
        """
        return replace(
            self,
            t=self.t[chosen],
            state=self.state[chosen],
            which=self.which[chosen],
            contact=tuple(itertools.compress(self.contact, chosen)),
        )

    def on(self, contact: str) -> Events:
        """The events of one of several contacts, by its name.

        Parameters
        ----------
        contact : str
            Its name.

        Returns
        -------
        Events

        Raises
        ------
        ParameterError
            If there are events, and none of a contact of that name.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(V=0.1), t_end=50.0)
        >>> tr.events.on("front")
        Traceback (most recent call last):
            ...
        spragsym.core.errors.ParameterError: contact = 'front': the events are those of one ...
        """
        if not self.t.size:
            return self
        if not self.contact:
            raise ParameterError(
                f"contact = {contact!r}: the events are those of one contact, which has no name; "
                "leave it out"
            )
        one_of("contact", contact, sorted({*self.contact}))
        return self.select(np.array(self.contact) == contact)

    def _shown(self) -> dict[str, Any]:
        """Time, what happened, of several contacts to which, and the state by its names."""
        return {
            "t": self.t,
            "which": self.which,
            **({"contact": np.array(self.contact)} if self.contact else {}),
            **dict(zip(self.components, self.state.T, strict=True)),
        }


def events_of(field: Field, crossings: Sequence[Crossing]) -> Events:
    """The crossings that have a name for users."""
    kinds = kinds_of(field)
    counted = [each for each in crossings if (each.border, each.sign) in kinds]
    return Events(
        np.array([each.t for each in counted]),
        np.array([each.state for each in counted]).reshape(-1, field.size),
        np.array([kinds[each.border, each.sign] for each in counted], dtype=np.intp),
        field.components,
        tuple(filter(None, (field.borders[each.border].contact for each in counted))),
    )
