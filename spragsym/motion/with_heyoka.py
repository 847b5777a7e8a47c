"""heyoka's Taylor method, with variational equations or without; borders between modes of the field
are terminal events.
"""

from __future__ import annotations

import itertools
import math
import threading
from collections import defaultdict, deque
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from types import ModuleType
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..core.interrupts import held
from ..models.field import JUMPED, OVERSHOOT, Border, Field, Mode
from ..models.parameters import FloatArray
from ..numerics.arithmetic import Number
from ..numerics.vectors import makes_turns
from .lobatto import sample_times, unit_points
from .measures import KEPT_EXTREMA, MotionStatistics
from .problem import (
    BURST,
    Event,
    Problem,
    StiffError,
    check_stiffness,
    kinds_of,
    out_of_range,
    too_many_steps,
)
from .solution import (
    CarriedState,
    Crossing,
    Extremum,
    FlowResult,
    Samples,
    Solution,
    assembled,
    parted,
)

#: Tolerance of flows with derivatives.
TOLERANCE = 1e-17

#: Derivatives are carried in this unit, so that they stay below the state: heyoka's error is
#: relative to the largest of all.
DEVIATION_UNIT = 1e-4


@cache
def library() -> ModuleType:
    """The module, which from now on reports errors only: its warnings are of a cache that can't be
    written, as in a read-only home, and of its search for crossings near a tangency.
    ``heyoka.set_logger_level_warning()`` brings them back.
    """
    with held():
        import heyoka as hy
    hy.set_logger_level_error()
    # Generated functions take abs of parameters, and a field the functions of its numbers.
    hy.expression.__abs__ = lambda value: value * XP.sign(value)
    hy.expression.namespace = XP
    return hy


class HeyokaFunctions:
    """The namespace ``xp`` of heyoka's expressions, whose functions take numbers too, as the 2 of
    sqrt(2).
    """

    def __init__(self) -> None:
        #: Names and arguments of all that was called.
        self.called: list[tuple[str, Any]] = []

    def __getattr__(self, name: str) -> object:
        hy = library()
        found = getattr(hy, name)
        if isinstance(found, hy.expression):
            return found

        def call(*values: Number) -> Number:
            taken = [
                hy.expression(float(it)) if isinstance(it, int | float) else it for it in values
            ]
            self.called.append((name, taken[0]))
            return found(*taken)

        return call

    def sign(self, value: Number) -> Number:
        """The sign of an expression: −1, 0 or 1."""
        hy = library()
        return hy.select(hy.gt(value, 0.0), 1.0, hy.select(hy.lt(value, 0.0), -1.0, 0.0))

    def tanh(self, value: Number) -> Number:
        """By exponentials: where heyoka's rounds to 1, all its Taylor coefficients are zero, and a
        step misses what follows.
        """
        hy = library()
        self.called.append(("tanh", value))
        up, down = hy.exp(2.0 * value), hy.exp(-2.0 * value)
        return hy.select(
            hy.gte(value, 0.0), 1.0 - 2.0 * down / (1.0 + down), 2.0 * up / (1.0 + up) - 1.0
        )


#: One that serves where nobody asks what was called.
XP = HeyokaFunctions()


@dataclass(frozen=True)
class Approach:
    """End of a step because of what its Taylor series does not see: ``watched`` passes zero upward
    there.

    The ``argument`` of a root is least and small beside its unit, as the squared length of a spring
    that passes its anchor, or an exponential or a hyperbolic tangent of the place is about to be
    felt; those of the sliding speed are borders of the field.
    """

    watched: Any
    argument: Any = None
    names: Sequence[Any] = ()

    @cached_property
    def value(self) -> Any:
        """Function of the argument, which takes as long to compile as the field: few motions come
        near an anchor.
        """
        return library().cfunc([self.argument], self.names)

    @classmethod
    def of(
        cls, called: list[tuple[str, Any]], system: list[Any], roots: Sequence[float]
    ) -> list[Approach]:
        """Subexpressions of all functions that were ``called``; units of the square ``roots``."""
        hy = library()
        names, found = [name for name, _ in system], list[Approach]()
        rates = {str(name) for name in names[len(names) // 2 :]}
        units = itertools.chain(roots, itertools.repeat(1.0))
        # Minus the exponent from which on an exponential of the place is felt: there it
        # is below rounding.
        felt = 37.0
        for name, given in called:
            z = given * next(units) ** -2 if name == "sqrt" else given
            seen = set(hy.get_variables(z))
            if name == "sqrt" and seen:
                rate = sum((hy.diff(z, name) * each for name, each in system), hy.expression(0.0))
                # A step ends where a spring passes its anchor within its speed
                # over this. Closer than the root of the tolerance a Taylor
                # series does not see the least length, and goes on with negative
                # ones.
                found.append(cls(1e-3 * (rate - 10.0 * z), z, names))
            elif name in ("exp", "tanh") and seen and not seen & rates:
                outside = z + felt if name == "exp" else (felt**2 - 4.0 * z * z) / felt
                found.append(cls(1e-3 * felt * outside / (felt**2 + z * z)))
        return found


def equations(
    field: Field, *, measured: bool = False, directions: int | None = None
) -> tuple[list[Any], tuple[Any, Any, Any], list[Any], list[Approach]]:
    """A field for heyoka: variables with their derivatives in time; state, constants and mode;
    accelerations; approaches.

    Constants, mode and directions are its ``par[]``. The variables are the state; with so many
    ``directions`` of the parameters its derivatives by the start and along those, column by column
    in :data:`DEVIATION_UNIT`, and the integrals of the first coordinate and of its square; with
    ``measured`` the integrals of a :class:`~spragsym.motion.measures.MotionStatistics`, scaled by
    the last parameter, so that they stay below the states: heyoka's error is relative to the
    largest of all.
    The parameter before is the leading coordinate at the begin.
    """
    hy = library()
    names, n, m = field.coordinates, len(field.coordinates), field.size
    parameters = len(field.parameters)
    constants = len(field.constants([1.0] * parameters))
    end = constants + len(field.modes[0])
    state = hy.make_vars(*names, *(f"v{name}" for name in names))
    given, mode = ([hy.par[i] for i in range(*ends)] for ends in ((constants,), (constants, end)))
    accelerations = list(field.acceleration(state, given, mode, xp := HeyokaFunctions()))
    system = list(zip(state, [*state[n:], *accelerations], strict=True))
    if directions is not None:
        jacobian, slopes = (
            make(state, given, mode, XP) for make in (field.jacobian, field.by_parameters)
        )
        for column in range(m + directions):
            # No coordinate has a dot in its name.
            part = hy.make_vars(*(f"by.{i}.{column}" for i in range(m)))
            rates = [_dot(row, part) for row in jacobian]
            if column >= m:
                begin = end + (column - m) * parameters
                weights = [hy.par[begin + i] for i in range(parameters)]
                rates = [
                    rate + DEVIATION_UNIT * _dot(row, weights)
                    for rate, row in zip(rates, slopes, strict=True)
                ]
            system += zip(part, [*part[n:], *rates], strict=True)
    if measured or directions is not None:
        lead, others = state[field.lead], [*state[: field.lead], *state[field.lead + 1 : n]]
        shift, scale = (
            (lead - hy.par[end], hy.par[end + 1]) if measured else (state[0], DEVIATION_UNIT)
        )
        sums = [
            scale * shift,
            scale * shift * shift,
            *(scale * other for other in others if measured),
        ]
        system += zip(hy.make_vars(*(f"sum.{i}" for i in range(len(sums)))), sums, strict=True)
    roots = field.scales.roots if field.scales else ()
    return system, (state, given, mode), accelerations, Approach.of(xp.called, system[:m], roots)


def _dot(one: Sequence[Number], other: Sequence[Number]) -> Number:
    return sum(a * b for a, b in zip(one, other, strict=True))


#: What stands for a border where the leading coordinate, that comes around, passes a whole turn.
PASSAGE = -2

#: Motions that one integrator carries at once, where they are measured. Another number compiles
#: other code, and may give other last bits.
LANES = 8


@dataclass
class MotionState:
    """A motion on its way: all that is carried of it, its mode, its steps so far, why it stopped,
    and what is noted of it.

    Of one by itself that is all crossings and turns. Of one among others it is how many events
    there were of each kind, and the states where borders were last crossed; the ``latest`` turns of
    x, by the sign of its second derivative, and where it passes a whole turn; and least and largest
    x at turns. One that may be ``resting`` on a border has events that are told from chatter by
    samples only. Its ``further`` parameters are directions, or what statistics are measured with.
    """

    problem: Problem
    further: Sequence[float] | FloatArray = ()
    carried: FloatArray = field(init=False)
    mode: Mode = field(init=False)
    steps: int = 0
    error: Exception | None = None
    crossings: list[Crossing] = field(default_factory=list)
    counts: list[int] = field(default_factory=lambda: [0] * len(Event))
    crossed: dict[int, list[float]] = field(default_factory=dict)
    extrema: list[Extremum] = field(default_factory=list)
    latest: dict[int, deque[list[float]]] = field(
        default_factory=partial(defaultdict, partial(deque, maxlen=KEPT_EXTREMA))
    )
    reach: dict[int, float] = field(default_factory=lambda: {1: np.inf, -1: -np.inf})
    resting: bool = False

    def __post_init__(self) -> None:
        """At the start."""
        self.carried = np.array(self.problem.start, dtype=float)
        self.mode = CarriedState(self.problem, self.carried).initial_mode()

    @property
    def most(self) -> int:
        """Steps after which it is given up."""
        # Steps after which a flow is abandoned.
        return self.problem.max_steps or 2_000_000


@dataclass(frozen=True)
class Propagation:
    """What is carried in how many lanes.

    ``turning`` is that turns are told, of the leading coordinate and of levels. With ``measured``
    those of the coordinate are, and the integrals of a
    :class:`~spragsym.motion.measures.MotionStatistics` are carried along; with ``directions`` of
    the parameters derivatives are.
    """

    lanes: int = 1
    measured: bool = False
    directions: int | None = None
    turning: bool = False


class BatchIntegrator:
    """A field compiled for motions in lanes, used again and again: each goes over to its next mode
    where it passes a border.
    """

    def __init__(self, field: Field, tol: float, carried: Propagation) -> None:
        hy = library()
        self.field, self.m, self.lanes = field, field.size, carried.lanes
        self.derivatives = carried.directions is not None
        measured, turning = carried.measured, carried.turning
        self.kinds = kinds_of(field) if measured else {}
        #: What is in the first lanes.
        self.some: Sequence[MotionState] = ()
        system, seen, accelerations, approaches = equations(
            field, measured=measured, directions=carried.directions
        )
        self.constants = len(seen[1])
        lead = field.lead
        rates = [(-1, seen[0][len(field.coordinates) + lead])] if turning or measured else []
        if measured and makes_turns(lead, field.periodic):
            rates.append((PASSAGE, hy.sin(seen[0][lead] / 2.0)))
        if turning:
            rates += [
                (i, b.rate(seen[0], accelerations, *seen[1:]))
                for i, b in enumerate(field.borders)
                if b.kink
            ]
        # What is constant in a mode has no zero, and heyoka takes no event of it: the rate of the
        # sliding speed of a block on a ramp, or the force that would hold it there.
        levels = [self._border(row, border, seen) for row, border in enumerate(field.borders)]
        rates = [(row, rate) for row, rate in rates if hy.get_variables(hy.expression(rate))]
        self.solver = hy.taylor_adaptive_batch(
            system,
            np.zeros((len(system), self.lanes)),
            tol=_tightened(field, tol),
            compact_mode=turning,
            t_events=[level for level in levels if level is not None]
            + [
                hy.t_event_batch(
                    each.watched,
                    callback=partial(self._pass, each),
                    direction=hy.event_direction.positive,
                )
                for each in approaches
            ],
            nt_events=[
                hy.nt_event_batch(1e-3 * rate, partial(self._note_extremum, row))
                for row, rate in rates
            ],
        )
        # Views of what the integrator holds: each look at an attribute makes one anew.
        self.state, self.pars, self.times, self.dense = (
            getattr(self.solver, name) for name in ("state", "pars", "time", "d_output")
        )
        #: How many numbers of a mode are parameters: heyoka has none beyond the last that a field
        #: takes.
        self.told = max(0, min(len(field.modes[0]), len(self.pars) - self.constants))

    def _border(self, row: int, border: Border, seen: tuple[Any, Any, Any]) -> object:
        """The terminal event of a border: a level that is positive within its mode; None where it
        is constant.

        The gap keeps one crossing from being found twice, which is what a cooldown is for. Where
        the field jumps, the levels of both modes are 0, and are curved in the state: after a
        crossing the new one may be negative by the error of a step, and its way up is no event.
        """
        hy, sign = library(), border.sign(seen[2])
        level = sign * border.scale * (border.level(*seen) + OVERSHOOT * sign * border.kink)
        if not hy.get_variables(level):
            return None
        return hy.t_event_batch(
            level,
            callback=partial(self._cross, row),
            cooldown=0.0,
            direction=hy.event_direction.negative if border.jumps else hy.event_direction.any,
        )

    def __deepcopy__(self, _: object) -> BatchIntegrator:
        """heyoka deep-copies its callbacks; the copies must still write to this object."""
        return self

    def _cross(self, row: int, _: object, direction: int, lane: int) -> bool:
        """Go over to the next mode; stop if a crossing was missed, or if derivatives would be
        carried across a jump.
        """
        one, t, state = self.some[lane], float(self.times[lane]), self.state[: self.m, lane]
        try:
            if direction > 0:
                raise missed_event(one.problem.time(t))
            columns = self._columns(self.state[:, lane]) if self.field.borders[row].slopes else None
            carried = CarriedState(one.problem, state, self._directions(one), columns)
            one.mode, crossings = carried.passed(row, one.mode, t)
        except ConvergenceError as error:
            one.error = error
            return False
        if columns is not None:
            self.state[self.m : -2, lane] = columns.T.ravel() * DEVIATION_UNIT
        self.pars[self.constants : self.constants + self.told, lane] = one.mode[: self.told]
        for crossing in crossings:
            if self.lanes == 1:
                one.crossings.append(crossing)
            elif (kind := self.kinds.get((row, crossing.sign))) is not None:
                one.counts[kind] += 1
                self._rest(one, row, state)
        return True

    def _rest(self, one: MotionState, row: int, state: FloatArray) -> None:
        """Note where a border is crossed, or the motion ends after that, and whether it had been
        crossed near there.
        """
        here = state.tolist()
        before, one.crossed[row] = one.crossed.get(row), here
        # A motion that passes a border again this near to where it passed it, as a share of its
        # state, may rest there.
        near_share = 1e-3
        moved = max(abs(a - b) for a, b in zip(here, before, strict=True)) if before else math.inf
        if moved <= near_share * max(map(abs, here)):
            one.resting = True

    def _note_extremum(self, border: int, _: object, t: float, direction: int, lane: int) -> None:
        """Note a turn of a border's level, or (−1) of the leading coordinate, or that this one
        passes a whole turn.
        """
        self.solver.update_d_output(t)
        one = self.some[lane]
        if self.lanes == 1:
            one.extrema.append(Extremum(t, border, direction, *self._split(self.dense[:, lane])))
            return
        state = self.dense[: self.m, lane].tolist()
        # The direction is 0 where both derivatives are.
        kind, bound = (-1, max) if direction < 0 else (1, min)
        one.latest[PASSAGE if border == PASSAGE else kind].append([t, *state])
        if border != PASSAGE:
            one.reach[kind] = bound(one.reach[kind], state[self.field.lead])

    def _pass(self, each: Approach, _: object, __: int, lane: int) -> bool:
        """Passage of the zero of a root's argument: where it is zero to OVERSHOOT, the state moves
        on by as much: at its anchor a spring has no direction.
        """
        one = self.some[lane]
        state = self.state[: self.m, lane].copy()
        pars = self.pars[:, lane].copy()
        if (
            each.argument is not None
            and abs(each.value(state, pars=pars[: each.value.nparams])[0]) < OVERSHOOT**2
        ):
            rates = state[self.m // 2 :]
            self.state[: len(rates), lane] += OVERSHOOT / np.abs(rates).max() * rates
            if self.derivatives:
                one.error = ConvergenceError(JUMPED)
        return one.error is None

    def _split(self, values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        return parted(values[: self.m], self._columns(values))

    def _columns(self, values: FloatArray) -> FloatArray | None:
        """The derivatives that are carried, a column for each number of the start and each
        direction.
        """
        return (
            values[self.m : -2].reshape(-1, self.m).T / DEVIATION_UNIT if self.derivatives else None
        )

    def _directions(self, one: MotionState) -> FloatArray | None:
        return (
            np.reshape(one.further, (-1, len(self.field.parameters))) if self.derivatives else None
        )

    def begin(self, some: Sequence[MotionState], t: float) -> None:
        """Motions into the first lanes, where nothing was crossed yet."""
        self.some = some
        pars = [(*one.problem.constants, *one.mode, *one.further) for one in some]
        self.solver.set_time(t)
        self.state[:] = 0.0
        self.state[: self.m, : len(some)] = np.array(
            [one.carried[: self.m] for one in some], dtype=float
        ).T
        self.pars[:, : len(some)] = np.array(pars, dtype=float).T[: len(self.pars)]
        if self.derivatives:
            columns = np.eye(self.m, (len(self.state) - 2) // self.m - 1)
            one, state = some[0], self.state[: self.m, 0]
            CarriedState(one.problem, state, self._directions(one), columns).project(one.mode)
            self.state[self.m : -2, 0] = columns.T.ravel() * DEVIATION_UNIT
        if self.solver.with_events:  # heyoka has no cooldowns where there are none
            self.solver.reset_cooldowns()

    def propagate(
        self, motions: Sequence[MotionState], begin: float, end: float, *, record: bool = False
    ) -> list[Samples]:
        """Carry motions on from ``begin`` to ``end``, but those that have stopped or stop on the
        way; samples if asked for.

        What stops one that has the integrator to itself is raised.
        """
        going, pieces = [one for one in motions if one.error is None], list[Samples]()
        for first in range(0, len(going), self.lanes):
            self.begin(going[first : first + self.lanes], begin)
            pieces += self._through(end, record)
        return pieces

    def _through(self, end: float, record: bool) -> list[Samples]:
        """Carry on what is in the lanes; in a free lane a copy of one that goes on stands still, at
        the end.
        """
        going, pieces = [*range(len(self.some))], list[Samples]()
        while going:
            if free := [lane for lane in range(self.lanes) if lane not in going]:
                late, early = (part.copy() for part in self.solver.dtime)
                late[free], early[free] = end, 0.0
                self.solver.set_dtime(late, early)
                for values in (self.state, self.pars):
                    values[:, free] = values[:, going[:1]]
            begun = self.times.copy()
            left = min(self.some[lane].most - self.some[lane].steps for lane in going)
            output, _ = self.solver.propagate_until(
                end, c_output=record, max_steps=min(BURST, left + 1)
            )
            if output is not None:  # to the Lobatto points of its steps
                ends, series = output.times[:, 0], output.tcs[..., 0]
                step, order = np.diff(ends)[:, None, None], np.arange(series.shape[2])
                states = (series * step**order) @ unit_points() ** order[:, None]
                pieces.append((sample_times(ends[:-1], ends[1:]), states))
            for lane in going.copy():
                one = self.some[lane]
                try:
                    self._count(one, lane, float(begun[lane]), end)
                except ConvergenceError as error:
                    if self.lanes == 1:
                        raise
                    one.error = error
                if one.error or not self.times[lane] < end:
                    going.remove(lane)
                    one.carried = self.state[:, lane].copy()
                    for border in [*one.crossed]:
                        self._rest(one, border, one.carried[: self.m])
        return pieces

    def _count(self, one: MotionState, lane: int, begun: float, end: float) -> None:
        """Count the steps of a lane in a flow that ``begun``; an error where it can't go on, or
        has passed a border unseen.
        """
        outcomes = library().taylor_outcome
        (outcome, _, _, made) = self.solver.propagate_res[lane]
        t = float(self.times[lane])
        problem, state = one.problem, self.state[: self.m, lane]
        one.steps += int(made)
        if one.error:
            raise one.error
        if outcome == outcomes.err_nf_state:
            raise out_of_range()
        if one.steps > one.most:
            raise too_many_steps(problem, one.most, t, state)
        if made == BURST:
            check_stiffness(problem, state, (t - begun) / made, problem.t_end - t)
        elif len(self.some) == 1 and outcome not in (
            outcomes.time_limit,
            outcomes.step_limit,
        ):  # of many, another may stop it
            raise ConvergenceError(
                f"heyoka stopped at t = {problem.time(t):.6g} with {outcome}; use backend='scipy'"
            )
        levels = (
            border.sign(one.mode) * border.level(state, problem.constants, one.mode)
            for border in self.field.borders
        )
        if not t < end and not all(level >= -2 * OVERSHOOT for level in levels):
            raise missed_event(problem.time(t))

    # ------------------------------------------------------------------------------------------ a
    # motion by itself

    def begun(self, problem: Problem, directions: FloatArray | tuple[()] = ()) -> BatchIntegrator:
        """Integrator begun for one motion."""
        self.some = [MotionState(problem, np.ravel(directions))]
        return self

    def motion(self) -> Solution:
        """The motion by its samples, from ``t_record`` on."""
        (one,) = self.some
        begin = one.problem.t_record
        if begin > 0:
            self.propagate(self.some, 0.0, begin)
        return assembled(
            self.propagate(self.some, begin, one.problem.t_end, record=True), one.crossings, begin
        )

    def flow_map(self) -> FlowResult:
        """Carry the state on to the end."""
        (one,) = self.some
        self.propagate(self.some, 0.0, one.problem.t_end)
        found = FlowResult(*self._split(one.carried), tuple(one.crossings), tuple(one.extrema))
        if self.derivatives:
            return replace(found, integrals=tuple((one.carried[-2:] / DEVIATION_UNIT).tolist()))
        return found


def missed_event(t: float) -> ConvergenceError:
    """The error of a motion that has passed a border unseen."""
    return ConvergenceError(f"heyoka missed a kink before t = {t:.6g}; use backend='scipy'")


_CACHE = threading.local()


def compiled(field: Field, tol: float, carried: Propagation = Propagation()) -> BatchIntegrator:
    """An integrator that is compiled once per field, tolerance and thread."""
    integrators: dict[Any, BatchIntegrator] = _CACHE.__dict__.setdefault("compiled", {})
    key = field.name, field.lead, tol, carried
    if key not in integrators:
        integrators[key] = BatchIntegrator(field, tol, carried)
    return integrators[key]


def flow_integrator(problem: Problem, directions: FloatArray | None) -> BatchIntegrator:
    """Integrator of a flow, with turns, and unless they are None its derivatives by the start and
    along ``directions``.
    """
    # Tolerance of plain ones, whose other steps make them a witness of the first.
    tol, count = (1e-16, None) if directions is None else (TOLERANCE, len(directions))
    return compiled(problem.field, tol, Propagation(directions=count, turning=True)).begun(
        problem, () if directions is None else directions
    )


def tolerance(problem: Problem) -> float:
    """Relative tolerance of a step."""
    return _tightened(problem.field, problem.rtol)


def _tightened(field: Field, tol: float) -> float:
    # Largest tolerance of fields with a border that is curved. A level that is no linear function
    # of the state has a Taylor series of its own, which agrees with that of the state to the
    # tolerance only: where that is not far below the gap behind a border, the border just crossed
    # would be met again.
    largest_tolerance = 1e-3 * OVERSHOOT
    return min(tol, largest_tolerance) if field.nonlinear_levels else tol


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    return compiled(problem.field, problem.rtol).begun(problem).motion()


def measured(problems: Sequence[Problem]) -> tuple[list[MotionStatistics | Exception], list[int]]:
    """Measures after ``t_record``, taken on the way: no continuous output, which would have to be
    kept; or why there is none.

    And the rows of those that are to be measured from samples.
    """
    one = problems[0]
    begin, end, size = one.t_record, one.t_end, one.field.size
    scale, motions = 1e-3 / (end - begin), [MotionState(each) for each in problems]
    if begin > 0:
        compiled(one.field, one.rtol, Propagation(LANES)).propagate(motions, 0.0, begin)
    first = [each.carried[:size] for each in motions]
    for each in motions:
        each.further = each.carried[one.field.lead], scale
    compiled(one.field, one.rtol, Propagation(LANES, measured=True)).propagate(motions, begin, end)

    def statistics(motion: MotionState, first: FloatArray) -> MotionStatistics:
        last, reach, lead = motion.carried, motion.reach, motion.problem.field.lead
        tops, lows, passed = (
            np.array(motion.latest[kind]).reshape(-1, 1 + size) for kind in (-1, 1, PASSAGE)
        )
        low, high = (
            float(pick(first[lead], last[lead], most))
            for pick, most in ((min, reach[1]), (max, reach[-1]))
        )
        return MotionStatistics(
            begin,
            end,
            first,
            last[:size],
            tops[:, 0],
            tops[:, 1:],
            last[size:] / scale,
            lows[:, 1:],
            np.array(motion.counts),
            (low, high),
            passed[:, 0],
            passed[:, 1:],
            lead,
        )

    found = [
        each.error or statistics(each, start) for each, start in zip(motions, first, strict=True)
    ]
    again = [
        isinstance(each.error, StiffError) or (each.error is None and each.resting)
        for each in motions
    ]
    return found, np.flatnonzero(again).tolist()
