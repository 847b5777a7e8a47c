"""Results of an integrator, and the transition of a motion from one mode to the next at a border.

:class:`Solution` is a motion: samples and border crossings. :class:`FlowResult` is the flow map
over a given time: final state, its derivatives by the initial state and the parameters, crossings
and extrema. :class:`CarriedState` moves a state and its derivatives across a border; where the
field jumps, by the saltation matrix. :class:`Events` are the crossings as users see them.
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

#: A border that was passed less than this time ago is located to first order: the square of this
#: time, in the motion's unit, is below rounding.
AT_ONCE = 1e-8

#: A border is not passed longer ago than this, in the motion's unit of time. What a belt of speed V
#: holds passes its limit by OVERSHOOT/V.
LATEST = 2.0


class Crossing(NamedTuple):
    """A border crossing: time, index of the border, sign of its level after the crossing, state,
    and sign before. Sign 0 is sticking.
    """

    t: float
    border: int
    sign: int
    state: FloatArray
    came: int


@dataclass(frozen=True, eq=False)
class CarriedState:
    """A state (m,) during an integration, with the solution of the variational equations.

    ``columns``, (m, m + k), are the derivatives of the state by the initial state and along the k
    ``directions``, (k, P), in the space of parameters; both are None if derivatives are not
    integrated. Methods change ``state`` and ``columns`` in place.
    """

    problem: Problem
    state: FloatArray
    directions: FloatArray | None = None
    columns: FloatArray | None = None

    def initial_mode(self) -> Mode:
        """Mode in which a motion begins at the state. If that sticks, the state is first projected
        onto the border, as by :meth:`project`.
        """
        mode = self.problem.field.initial_mode(self.state.tolist(), self.problem.constants)
        self.project(mode)
        return mode

    def project(self, mode: Mode) -> None:
        """Project the state onto each border on which it stays in a mode, and the derivatives onto
        the border's tangent space.
        """
        field = self.problem.field
        for border in field.stays(mode):
            slot, values = border.place, self.state.tolist()
            sliding = [(*mode[:slot], sign, *mode[slot + 1 :]) for sign in (1, -1)]
            rates = [
                field.level_rate(border, values, self.problem.constants, each) for each in sliding
            ]
            fastest = sliding[int(np.argmax(np.abs(rates)))]
            self.saltation(border, (fastest, mode))

    def passed(self, row: int, mode: Mode, t: float) -> tuple[Mode, tuple[Crossing, ...]]:
        """Continue a motion across the border number ``row``: the next mode, and the crossings.

        Borders without a kink give no crossing. Further borders that are crossed at the same
        instant are crossed too; their crossings follow.

        Where the field jumps, state and derivatives are moved as if the modes had been switched on
        the border itself, not where the integrator noticed it. A state that leaves sticking is
        first projected onto its border, from which integration errors may have moved it.

        Raises ConvergenceError where the field jumps and the border brings no derivatives, but
        derivatives are integrated.
        """
        done, crossings = set[int](), list[Crossing]()
        border: int | None = row
        while border is not None:
            done.add(border)
            mode, found = self._through(border, mode, t)
            crossings += found
            border = self._next_border(mode, done)
        return mode, tuple(crossings)

    def _next_border(self, mode: Mode, done: set[int]) -> int | None:
        """Index of another border that the motion leaves at the same instant, up to rounding, or
        None.
        """
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
        """:meth:`passed` across one border, including frictions that begin or cease to stick at
        that crossing.

        All of them change at one instant, that of the border: where accelerations jump there, the
        force that another friction has to hold jumps too, possibly beyond its limit. The level of
        that limit is not late but jumps, so that it locates nothing, and there is one saltation.
        """
        field, constants = self.problem.field, self.problem.constants
        if field.sticking_borders:
            CarriedState(self.problem, self.state).project(mode)
        border = field.borders[row]
        at = self.state.tolist(), constants
        after = border.beyond(mode, *at)
        # Another friction that begins or ceases to stick at the same instant crosses a border of
        # its own, unless it ceases to stick because its contact opens.
        changed = (slot for slot, (a, b) in enumerate(zip(mode, after, strict=True)) if a != b)
        others = [slot for slot in changed if slot != border.place and border.jumps]
        delay, on_border = 0.0, self.state.copy()
        if border.jumps is not None and border.jumps(*at):
            if border.slopes is not None:
                delay, on_border = self.saltation(border, (mode, after))
                if not delay < LATEST:
                    raise ConvergenceError(
                        "a border is passed so slowly that rounding hides where, at "
                        f"{field.place(self.state, '.3g')}; give larger speeds, or 0"
                    )
                if any(not after[slot] for slot in others):
                    self.project(after)
            elif self.directions is not None:
                raise ConvergenceError(JUMPED)
        rows = [row, *(field.entered(slot, mode, after) for slot in others)]
        crossings = (
            Crossing(
                max(t - delay, 0.0),
                number,
                int(field.borders[number].sign(after)),
                on_border,
                int(field.borders[number].sign(mode)),
            )
            for number in rows
            if field.borders[number].kink
        )
        return after, tuple(crossings)

    def saltation(self, border: Border, modes: tuple[Mode, Mode]) -> tuple[float, FloatArray]:
        """Switch from one mode to another on the border h = 0: apply the saltation matrix
        1 + (f⁺ − f⁻) ∇h/ḣ⁻ to the derivatives, and correct the state.

        Returns the delay, the time for which the motion has been beyond the border, and the state
        on the border. A delay below :data:`AT_ONCE` is corrected to first order. For a longer one
        the motion is integrated back to the border in the first mode, and forward again in the
        second.
        """
        located = self._located(border, modes[0])
        if located is None:
            return 0.0, self.state.copy()
        delay, on_border, columns, rate = located
        directions, m = self.directions, len(self.state)
        field, constants, values = self.problem.field, self.problem.constants, on_border.tolist()
        before, after = (field.rates(values, constants, mode) for mode in modes)
        jump = (after - before) / rate
        if self.columns is not None and border.slopes is not None and directions is not None:
            gradient = np.array(border.slopes(values, constants, modes[0]), dtype=float)
            level_change = gradient[:m] @ columns
            level_change[m:] += gradient[m:] @ directions.T if directions.size else 0.0
            columns = columns + np.outer(jump, level_change)
        if abs(delay) > AT_ONCE and on_border is not self.state:
            switched = replace(self, state=on_border, columns=columns)
            self.state[:], columns = switched.later(modes[1], delay)
        else:
            on_border = self.state - delay * before
            self.state[:] += jump * border.level(values, constants, modes[0])
        if self.columns is not None:
            self.columns[:] = columns
        return delay, on_border

    def _located(
        self, border: Border, mode: Mode
    ) -> tuple[float, FloatArray, FloatArray, float] | None:
        """The delay since a border was passed; state, derivatives and rate of the level there.

        Newton's method in the delay, if that converges to a short one; else the present state, with
        the delay to first order. None if the level has rate 0.
        """
        field, constants = self.problem.field, self.problem.constants

        def newton_step(state: FloatArray) -> tuple[float, float]:
            values = state.tolist()
            rate = field.level_rate(border, values, constants, mode)
            return (float(border.level(values, constants, mode)) / rate if rate else math.inf), rate

        first, rate = newton_step(self.state)
        if not rate:
            return None
        delay, change = first, first
        if AT_ONCE < abs(delay) < LATEST:
            for _ in range(5):
                on_border, columns = self.later(mode, -delay)
                before = change
                change, rate_there = newton_step(on_border)
                # Steps that no longer shrink are rounding of the level.
                rounding = abs(before) / 2 < abs(change) < 1e-3 * abs(first)
                if abs(change) <= AT_ONCE or rounding:
                    return delay, on_border, columns, rate_there
                delay += change
                if not abs(delay) < LATEST:
                    break
        columns = np.empty((len(self.state), 0)) if self.columns is None else self.columns
        return first, self.state, columns, rate

    def later(self, mode: Mode, duration: float) -> tuple[FloatArray, FloatArray]:
        """The state and its derivatives after a short time of either sign in a mode, by the
        classical Runge–Kutta method of fourth order.
        """
        columns, m = self.columns, len(self.state)
        whole = self.state if columns is None else np.append(self.state, columns)
        rates = rates_of(self.problem, mode, None if columns is None else self.directions)
        # In the motion's unit of time, steps of this have an error below that of the integrators.
        steps = math.ceil(abs(duration) / 0.003)
        step, moved = duration / steps, np.zeros_like(whole)  # apart, for its digits
        for _ in range(steps):
            at = whole + moved
            first = rates(0.0, at)
            second = rates(0.0, at + step / 2 * first)
            third = rates(0.0, at + step / 2 * second)
            last = rates(0.0, at + step * third)
            moved = moved + step / 6 * (first + 2 * second + 2 * third + last)
        whole = whole + moved
        return whole[:m], whole[m:].reshape(m, -1)


def rates_of(
    problem: Problem, mode: Mode, directions: FloatArray | None, xp: object = FLOATS
) -> Callable[[float, FloatArray], FloatArray]:
    """Right-hand side ``rates(t, whole)`` of the equations of motion in a mode.

    ``whole`` is the state; unless ``directions`` is None it is followed by the derivatives of the
    state, row by row, and the right-hand side by that of the variational equations.
    """
    field, constants = problem.field, problem.constants
    m, n = field.size, len(field.coordinates)

    def rates(_: float, whole: FloatArray) -> FloatArray:
        state = whole[:m].tolist()
        state_rates = field.rates(state, constants, mode, xp)
        if directions is None:
            return state_rates
        column_rates = field.matrix(state, constants, mode, xp) @ whole[m:].reshape(m, -1)
        if directions.size:
            by_parameters = np.array(field.by_parameters(state, constants, mode, xp), dtype=float)
            column_rates[n:, m:] += by_parameters @ directions.T
        return np.append(state_rates, column_rates)

    return rates


class Extremum(NamedTuple):
    """A local extremum of the level of a border or, with ``border`` −1, of the leading coordinate.

    ``direction`` is the sign of the second derivative in time: −1 at a maximum. ``by_state``
    (m, m) and ``by_parameters`` (m, k) are the derivatives of ``state``, (m,), at fixed time.
    """

    t: float
    border: int
    direction: int
    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray


@dataclass(frozen=True)
class FlowResult:
    """Flow map over a given time: final ``state``, (m,), and its derivatives.

    ``by_state``, (m, m), by the initial state, includes the saltation matrices at jumps of the
    field. ``by_parameters``, (m, k), is along k directions. ``integrals`` over time, of the first
    coordinate and of its square, are NaN unless the integrator provides them.
    """

    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray
    crossings: tuple[Crossing, ...]
    extrema: tuple[Extremum, ...]
    integrals: tuple[float, ...] = (np.nan, np.nan)


#: ``flow_map(state, constants, duration, directions)``, with directions of shape (k, P).
FlowMap: TypeAlias = Callable[[FloatArray, Values, float, FloatArray], FlowResult]


def parted(
    state: FloatArray, columns: FloatArray | None
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Split into state, derivatives by the initial state, and derivatives by the parameters; the
    last two are empty without ``columns``.
    """
    whole = np.empty((0, 0)) if columns is None else columns.copy()
    return state.copy(), whole[:, : len(state)], whole[:, len(state) :]


#: Times and states of some steps at their Lobatto points: shapes (steps, DEGREE + 1) and
#: (steps, 2 n, DEGREE + 1).
Samples: TypeAlias = tuple[FloatArray, FloatArray]


@dataclass(frozen=True)
class Solution:
    """A motion as a piecewise polynomial, with its border crossings.

    ``implicit`` is True if an implicit method integrated it. ``rtol`` is the relative tolerance
    used, 0 until it is known.
    """

    samples: PiecewisePolynomial
    crossings: tuple[Crossing, ...]
    implicit: bool = False
    rtol: float = 0.0


def assembled(
    pieces: Sequence[Samples], crossings: Sequence[Crossing], t_record: float
) -> Solution:
    """Join the samples of consecutive steps into one motion, which begins at ``t_record``."""
    t, states = pieces[0]
    if len(pieces) > 1 or crossings:  # one piece, which may be large, is else not copied
        t = np.concatenate([each[0] for each in pieces])
        states = np.concatenate([each[1] for each in pieces])
    for crossing in crossings:
        _join_at(t, states, crossing)
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


def _join_at(t: FloatArray, states: FloatArray, crossing: Crossing) -> None:
    """Move the common time of two steps, where the state jumps, back to the border crossing:
    the arrays are changed.

    The integrator noticed the crossing late, at the end of a step, and corrected the state there.
    Both steps are resampled by their own polynomials, so that the first ends and the second begins
    just behind the border: by so little that the gap between them is 4 OVERSHOOT, and by so much
    that the sample is in the new mode.
    """
    row = int(np.searchsorted(t[:, -1], crossing.t))
    if row + 1 >= len(t):
        return
    gap, delay = magnitude(states[row + 1, :, 0] - states[row, :, -1]), t[row, -1] - crossing.t
    remaining = 4 * OVERSHOOT
    if gap <= remaining or not delay < min(t[row, -1] - t[row, 0], t[row + 1, -1] - t[row, -1]):
        return
    joint = crossing.t + remaining / gap * delay
    for step, ends in ((row, (t[row, 0], joint)), (row + 1, (joint, t[row + 1, -1]))):
        polynomial = PiecewisePolynomial(t[step].copy(), states[step])
        t[step] = sample_times(*ends)
        states[step] = polynomial(t[step])


def without_chatter(solution: Solution, problem: Problem) -> Solution:
    """The solution without chatter: crossings caused by integration errors of a motion that rests
    on a border.

    A crossing is chatter if until the next crossing of the same border the level stays below the
    error of a step, or if the motion was on that side of the border before.
    """
    t, states, chatter = solution.samples.t, solution.samples.states, set[int]()
    error = max(10 * problem.rtol * float(max(states.max(), -states.min())), 2 * OVERSHOOT)
    for row, border in enumerate(problem.field.borders):
        own = [crossing for crossing in solution.crossings if crossing.border == row]
        if not own or not border.crossings[0] or border.stays:
            continue
        level = np.abs(border.level(states, problem.constants, problem.field.modes[0]))
        begins = np.searchsorted(t, [crossing.t for crossing in own])
        largest = np.maximum.reduceat(level, begins).tolist()
        side = -own[0].sign
        for crossing, distance in zip(own, largest, strict=True):
            if not distance > error or crossing.sign in (0, side):
                chatter.add(id(crossing))
            else:
                side = crossing.sign
    return replace(
        solution, crossings=tuple(each for each in solution.crossings if id(each) not in chatter)
    )


@dataclass(frozen=True, eq=False)
class Events(Rows):
    """Events of a motion: its crossings of kinks of the field, in order of time.

    Attributes
    ----------
    t : ndarray, shape (k,)
        Time. A contact counts as open or closed when the gap is 1e-12 of its scale beyond 0. The
        time is late by that distance over the speed of the gap; the error of a trajectory, which is
        of its states, does not include this.
    state : ndarray, shape (k, 2 n)
        Coordinates and rates at the event: y = 0 or x' = V, up to 1e-12 of the motion's scales.
    which : ndarray of int, shape (k,)
        Codes of :class:`Event`.
    components : tuple of str
        Names of the coordinates and rates.
    contact : tuple of str, length k
        Name of the contact that opened or closed, or whose friction stuck, slipped or changed
        direction; empty if the model has one contact.
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
        """The events of given kinds.

        Parameters
        ----------
        *kinds : Event or str
            Members of :class:`Event` or their names, as "stick".

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
        """The events selected by a mask.

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
        """The events of one of several contacts.

        Parameters
        ----------
        contact : str
            Name of the contact.

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
        """Columns of the table: time, kind, contact if there are several, components."""
        return {
            "t": self.t,
            "which": self.which,
            **({"contact": np.array(self.contact)} if self.contact else {}),
            **dict(zip(self.components, self.state.T, strict=True)),
        }


def events_of(field: Field, crossings: Sequence[Crossing]) -> Events:
    """The crossings that are events for users: those with a kind in :func:`kinds_of`."""
    kinds = kinds_of(field)
    named = [each for each in crossings if (each.border, each.sign) in kinds]
    return Events(
        np.array([each.t for each in named]),
        np.array([each.state for each in named]).reshape(-1, field.size),
        np.array([kinds[each.border, each.sign] for each in named], dtype=np.intp),
        field.components,
        tuple(filter(None, (field.borders[each.border].contact for each in named))),
    )
