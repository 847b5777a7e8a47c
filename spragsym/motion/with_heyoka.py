"""Integration by heyoka's adaptive Taylor method, with or without the variational equations.

:func:`equations` writes a field as heyoka expressions. :class:`BatchIntegrator` compiles them,
once per field and tolerance. Each border between modes of the field is a terminal event, at which
the motion continues in the next mode. Three kinds of result: the samples of a motion
(:func:`integrate`), the flow map with derivatives (:func:`flow_integrator`), and statistics of many
motions at once, accumulated while they are integrated (:func:`measured`).
"""

from __future__ import annotations

import importlib.util
import itertools
import math
import threading
import warnings
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
from ..numerics.arithmetic import Number, dot
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

#: Derivatives are scaled by this, so that they stay smaller than the state: heyoka's error is
#: relative to the largest variable.
DEVIATION_UNIT = 1e-4


@cache
def library() -> ModuleType:
    """The module ``heyoka``, imported when first used.

    Its logger is set to errors only: its warnings are about a cache that can't be written, as in a
    read-only home, and about its event detection near a tangency.
    ``heyoka.set_logger_level_warning()`` brings them back.
    """
    with held():
        import heyoka as hy
    hy.set_logger_level_error()
    # Generated functions call abs of parameters; a field takes its functions from ``namespace``.
    hy.expression.__abs__ = lambda value: value * XP.sign(value)
    hy.expression.namespace = XP
    return hy


@cache
def available() -> bool:
    """Whether heyoka is installed and can be imported; warns if it is installed and can't be."""
    if importlib.util.find_spec("heyoka") is None:
        return False
    try:
        library()
    except (ImportError, OSError, AttributeError) as error:
        warnings.warn(
            f"heyoka is installed and can't be used: {error}; motions are integrated by compiled "
            "code or SciPy, slower: install it anew, python -m pip install 'heyoka>=7.13'",
            stacklevel=2,
        )
        return False
    return True


class HeyokaFunctions:
    """The namespace ``xp`` for heyoka expressions: sqrt, exp, ... of expressions or numbers. It
    records all calls.
    """

    def __init__(self) -> None:
        #: Name and argument of each function call.
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
        """tanh by exponentials. Where heyoka's own tanh rounds to 1, all its Taylor coefficients
        are zero, and a step would not see it fall again.
        """
        hy = library()
        self.called.append(("tanh", value))
        up, down = hy.exp(2.0 * value), hy.exp(-2.0 * value)
        return hy.select(
            hy.gte(value, 0.0), 1.0 - 2.0 * down / (1.0 + down), 2.0 * up / (1.0 + up) - 1.0
        )


#: The namespace for uses that do not read the record of calls.
XP = HeyokaFunctions()


@dataclass(frozen=True)
class Approach:
    """An event that ends a step where the Taylor series would fail to predict the field.

    ``watched`` crosses 0 upward there. Two cases:

    - The ``argument`` of a square root has a small minimum: a spring passes close to its anchor,
      where its length is nearly 0.
    - An exponential or hyperbolic tangent of the coordinates, which was below rounding, is about
      to matter. (Exponentials of a sliding speed are borders of the field instead.)
    """

    watched: Any
    argument: Any = None
    names: Sequence[Any] = ()

    @cached_property
    def value(self) -> Any:
        """Compiled function of the argument. Compiled only if needed: it takes as long as the
        field, and few motions come near an anchor.
        """
        return library().cfunc([self.argument], self.names)

    @classmethod
    def of(
        cls, called: list[tuple[str, Any]], system: list[Any], roots: Sequence[float]
    ) -> list[Approach]:
        """The approaches of a field: of each function call in ``called``, with the equations
        ``system`` and the units ``roots`` of the square roots, in order.
        """
        hy = library()
        names, found = [name for name, _ in system], list[Approach]()
        rates = {str(name) for name in names[len(names) // 2 :]}
        units = itertools.chain(roots, itertools.repeat(1.0))
        # exp(−37) is the rounding of a number of order 1.
        negligible = 37.0
        for name, argument in called:
            z = argument * next(units) ** -2 if name == "sqrt" else argument
            variables = set(hy.get_variables(z))
            if name == "sqrt" and variables:
                rate = sum((hy.diff(z, name) * each for name, each in system), hy.expression(0.0))
                # A step ends where a length grows after a minimum below a fifth of its rate. If
                # the minimum is below the square root of the tolerance, the Taylor series does not
                # see it, and continues with negative lengths.
                found.append(cls(1e-3 * (rate - 10.0 * z), z, names))
            elif name in ("exp", "tanh") and variables and not variables & rates:
                distance = (
                    z + negligible if name == "exp" else (negligible**2 - 4.0 * z * z) / negligible
                )
                found.append(cls(1e-3 * negligible * distance / (negligible**2 + z * z)))
        return found


def equations(
    field: Field, *, measured: bool = False, directions: int | None = None
) -> tuple[list[Any], tuple[Any, Any, Any], list[Any], list[Approach]]:
    """A field as heyoka expressions: the system as pairs (variable, time derivative); the tuple
    (state, constants, mode); the accelerations; the approaches.

    The variables are, in this order:

    - the state;
    - with a number of ``directions``: the derivatives of the state by the initial state and along
      these directions in the space of parameters, column by column, scaled by
      :data:`DEVIATION_UNIT`; then the integrals of the first coordinate and of its square;
    - with ``measured``: the integrals of a :class:`~spragsym.motion.measures.MotionStatistics`.

    heyoka's parameters ``par[]`` are the constants, the mode, and the components of the directions;
    or with ``measured`` the leading coordinate at the beginning, and the factor by which the
    integrals are scaled. They must stay smaller than the states, as heyoka's error is relative to
    the largest variable.
    """
    hy = library()
    names, n, m = field.coordinates, len(field.coordinates), field.size
    parameters = len(field.parameters)
    constants = len(field.constants([1.0] * parameters))
    end = constants + len(field.modes[0])
    state = hy.make_vars(*names, *(f"v{name}" for name in names))
    given = [hy.par[i] for i in range(constants)]
    mode = [hy.par[i] for i in range(constants, end)]
    accelerations = list(field.acceleration(state, given, mode, xp := HeyokaFunctions()))
    system = list(zip(state, [*state[n:], *accelerations], strict=True))
    if directions is not None:
        jacobian, slopes = (
            make(state, given, mode, XP) for make in (field.jacobian, field.by_parameters)
        )
        for column in range(m + directions):
            # Names with a dot are no coordinate's.
            part = hy.make_vars(*(f"by.{i}.{column}" for i in range(m)))
            rates = [dot(row, part) for row in jacobian]
            if column >= m:
                begin = end + (column - m) * parameters
                weights = [hy.par[begin + i] for i in range(parameters)]
                rates = [
                    rate + DEVIATION_UNIT * dot(row, weights)
                    for rate, row in zip(rates, slopes, strict=True)
                ]
            system += zip(part, [*part[n:], *rates], strict=True)
    if measured or directions is not None:
        shift, scale, others = state[0], DEVIATION_UNIT, []
        if measured:
            shift, scale = state[field.lead] - hy.par[end], hy.par[end + 1]
            others = [*state[: field.lead], *state[field.lead + 1 : n]]
        integrands = [scale * shift, scale * shift * shift, *(scale * other for other in others)]
        integrals = hy.make_vars(*(f"sum.{i}" for i in range(len(integrands))))
        system += zip(integrals, integrands, strict=True)
    roots = field.scales.roots if field.scales else ()
    return system, (state, given, mode), accelerations, Approach.of(xp.called, system[:m], roots)


#: Number of the event "the field's marker passes a whole turn", in place of a border's.
PASSAGE = -2

#: Motions that are integrated in parallel (SIMD) for statistics. Another number compiles other
#: code, and may change the last bits of results.
LANES = 8


@dataclass
class MotionState:
    """A motion during its integration.

    ``carried`` are all variables of the integrator, ``further`` its parameters behind the mode: see
    :func:`equations`. ``error`` is why the motion stopped, None while it runs.

    A motion integrated alone keeps all ``crossings`` and ``extrema``. In a batch it keeps
    statistics only: ``counts`` of events of each kind; in ``crossed`` the state at the last
    crossing of each border; the ``latest`` extrema of the leading coordinate, by the sign of its
    second derivative, and passages of a whole turn; in ``reach`` its least minimum and largest
    maximum, by the same sign. A motion that is ``resting`` may rest on a border: then only samples
    can tell its events from chatter. ``turned`` is what was taken off the phase of a clock.
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
    turned: float = 0.0

    def __post_init__(self) -> None:
        self.carried = np.array(self.problem.start, dtype=float)
        self.mode = CarriedState(self.problem, self.carried).initial_mode()

    @property
    def most(self) -> int:
        """Maximum number of steps."""
        return self.problem.max_steps or 2_000_000


@dataclass(frozen=True)
class Propagation:
    """What a :class:`BatchIntegrator` integrates: number of lanes, and variables as in
    :func:`equations`.

    ``turning``: extrema of the leading coordinate and of the levels of borders are detected;
    ``measured``: those of the leading coordinate.
    """

    lanes: int = 1
    measured: bool = False
    directions: int | None = None
    turning: bool = False


class BatchIntegrator:
    """A compiled integrator of a field for several motions in parallel, one in each lane."""

    def __init__(self, field: Field, tol: float, carried: Propagation) -> None:
        hy = library()
        self.field, self.m, self.lanes = field, field.size, carried.lanes
        self.derivatives = carried.directions is not None
        measured, turning = carried.measured, carried.turning
        self.kinds = kinds_of(field) if measured else {}
        #: The motions in the first lanes.
        self.some: Sequence[MotionState] = ()
        system, seen, accelerations, approaches = equations(
            field, measured=measured, directions=carried.directions
        )
        self.constants = len(seen[1])
        lead = field.lead
        rates = [(-1, seen[0][len(field.coordinates) + lead])] if turning or measured else []
        if measured and field.marker is not None:
            rates.append((PASSAGE, hy.sin(seen[0][field.marker] / 2.0)))
        if turning:
            rates += [
                (i, b.rate(seen[0], accelerations, *seen[1:]))
                for i, b in enumerate(field.borders)
                if b.kink
            ]
        # heyoka accepts no constant event function, such as the rate of the sliding speed of a
        # block on a ramp, or the force that would hold it there.
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
        # Views of the integrator's arrays: each access to an attribute would create a new one.
        self.state, self.pars, self.times, self.dense = (
            getattr(self.solver, name) for name in ("state", "pars", "time", "d_output")
        )
        #: How many numbers of a mode are parameters: heyoka drops those behind the last one used.
        self.told = max(0, min(len(field.modes[0]), len(self.pars) - self.constants))

    def _border(self, row: int, border: Border, seen: tuple[Any, Any, Any]) -> object:
        """Terminal event of a border: its level, with the sign that is positive inside the mode;
        None for a constant level.

        No cooldown is needed: OVERSHOOT keeps one crossing from being found twice. Where the field
        jumps, only downward crossings count: there the level is 0 in both modes, and after a
        crossing the error of a step may make it negative, so that its way up would be an event.
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
        """Callback of a border: switch to the next mode. False, which stops, if a crossing was
        missed, or if derivatives cannot be continued across a jump.
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
                if one.turned:
                    whole = self._with_turns(one, crossing.state)
                    crossing = crossing._replace(state=whole)
                one.crossings.append(crossing)
            elif (kind := self.kinds.get((row, crossing.sign))) is not None:
                one.counts[kind] += 1
                self._rest(one, row, state)
        return True

    def _rest(self, one: MotionState, row: int, state: FloatArray) -> None:
        """Record the state at a crossing of a border, or at the end of the motion. If the last
        crossing was within 0.1 % of the state, the motion may rest on the border.
        """
        here = state.tolist()
        before, one.crossed[row] = one.crossed.get(row), here
        moved = max(abs(a - b) for a, b in zip(here, before, strict=True)) if before else math.inf
        if moved <= 1e-3 * max(map(abs, here)):
            one.resting = True

    def _note_extremum(self, border: int, _: object, t: float, direction: int, lane: int) -> None:
        """Callback of an extremum: record that of a border's level, or (−1) of the leading
        coordinate, or (PASSAGE) the marker's passage of a whole turn.
        """
        self.solver.update_d_output(t)
        one = self.some[lane]
        if self.lanes == 1:
            values = self._with_turns(one, self.dense[:, lane])
            one.extrema.append(Extremum(t, border, direction, *self._split(values)))
            return
        state = self._with_turns(one, self.dense[: self.m, lane]).tolist()
        # The direction is 0 if the second derivative is 0, too.
        kind, bound = (-1, max) if direction < 0 else (1, min)
        one.latest[PASSAGE if border == PASSAGE else kind].append([t, *state])
        if border != PASSAGE:
            one.reach[kind] = bound(one.reach[kind], state[self.field.lead])

    def _pass(self, each: Approach, _: object, __: int, lane: int) -> bool:
        """Callback of an approach. If a spring's end is within OVERSHOOT of its anchor, where its
        direction is undefined, the state is moved on by OVERSHOOT.
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
        """Derivatives of the state among the variables of a lane, (m, m + directions)."""
        if not self.derivatives:
            return None
        with np.errstate(over="ignore"):  # long chaotic motions: infinite, as orbits refuse
            return values[self.m : -2].reshape(-1, self.m).T / DEVIATION_UNIT

    def _directions(self, one: MotionState) -> FloatArray | None:
        if not self.derivatives:
            return None
        return np.reshape(one.further, (-1, len(self.field.parameters)))

    def begin(self, some: Sequence[MotionState], t: float) -> None:
        """Load motions into the first lanes, at time ``t``."""
        self.some = some
        pars = [(*one.problem.constants, *one.mode, *one.further) for one in some]
        self.solver.set_time(t)
        self.state[:] = 0.0
        self.state[: self.m, : len(some)] = np.array(
            [one.carried[: self.m] for one in some], dtype=float
        ).T
        self.pars[:, : len(some)] = np.array(pars, dtype=float).T[: len(self.pars)]
        for lane, one in enumerate(some):
            one.turned = 0.0
            self._unwind(lane)
        if self.derivatives:
            columns = np.eye(self.m, (len(self.state) - 2) // self.m - 1)
            one, state = some[0], self.state[: self.m, 0]
            CarriedState(one.problem, state, self._directions(one), columns).project(one.mode)
            self.state[self.m : -2, 0] = columns.T.ravel() * DEVIATION_UNIT
        if self.solver.with_events:  # heyoka has no cooldowns where there are none
            self.solver.reset_cooldowns()

    @property
    def burst(self) -> int:
        """Number of steps between checks; of a clock in so few that its phase stays small."""
        return BURST // 100 if self.field.clock else BURST

    def _unwind(self, lane: int) -> None:
        """Take whole turns off the phase of a clock once it is large: errors of a Taylor method are
        relative to the largest component, and would come to those of a level that has to be met.
        """
        clock, turn, large = self.m // 2 - 1, 2 * math.pi, 100.0
        phase = float(self.state[clock, lane])
        if self.field.clock and abs(phase) > large:
            self.state[clock, lane] = phase % turn
            self.some[lane].turned += phase - phase % turn

    def _with_turns(self, one: MotionState, values: FloatArray) -> FloatArray:
        """Variables of the integrator with the whole phase of a clock; themselves without one."""
        if not one.turned:
            return values
        whole = values.copy()
        whole[self.m // 2 - 1] += one.turned
        return whole

    def propagate(
        self, motions: Sequence[MotionState], begin: float, end: float, *, record: bool = False
    ) -> list[Samples]:
        """Integrate motions from ``begin`` to ``end``, except those that have an error; with
        ``record`` return the samples.

        An error of a motion is kept in it; with a single lane it is raised.
        """
        running, pieces = [one for one in motions if one.error is None], list[Samples]()
        for first in range(0, len(running), self.lanes):
            self.begin(running[first : first + self.lanes], begin)
            pieces += self._to_end(end, record)
        return pieces

    def _to_end(self, end: float, record: bool) -> list[Samples]:
        """Integrate the motions in the lanes to the time ``end``, in bursts.

        A lane whose motion has ended gets a copy of a running one, at time ``end``: so it takes no
        further steps.
        """
        running, pieces = [*range(len(self.some))], list[Samples]()
        while running:
            if free := [lane for lane in range(self.lanes) if lane not in running]:
                late, early = (part.copy() for part in self.solver.dtime)
                late[free], early[free] = end, 0.0
                self.solver.set_dtime(late, early)
                for values in (self.state, self.pars):
                    values[:, free] = values[:, running[:1]]
            begun = self.times.copy()
            remaining = min(self.some[lane].most - self.some[lane].steps for lane in running)
            output, _ = self.solver.propagate_until(
                end, c_output=record, max_steps=min(self.burst, remaining + 1)
            )
            if output is not None:  # Taylor series of each step, evaluated at its Lobatto points
                ends, series = output.times[:, 0], output.tcs[..., 0]
                step, order = np.diff(ends)[:, None, None], np.arange(series.shape[2])
                states = (series * step**order) @ unit_points() ** order[:, None]
                if turned := self.some[0].turned:
                    states[:, self.m // 2 - 1] += turned
                pieces.append((sample_times(ends[:-1], ends[1:]), states))
            for lane in running.copy():
                one = self.some[lane]
                try:
                    self._check(one, lane, float(begun[lane]), end)
                except ConvergenceError as error:
                    if self.lanes == 1:
                        raise
                    one.error = error
                if one.error or not self.times[lane] < end:
                    running.remove(lane)
                    for border in [*one.crossed]:
                        self._rest(one, border, self.state[: self.m, lane])
                    one.carried = self._with_turns(one, self.state[:, lane].copy())
                else:
                    self._unwind(lane)
        return pieces

    def _check(self, one: MotionState, lane: int, begun: float, end: float) -> None:
        """After a burst from time ``begun``: count the steps of a lane; raise ConvergenceError if
        the motion cannot continue, or has passed a border undetected.
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
        if made == self.burst:
            check_stiffness(problem, state, (t - begun) / made, problem.t_end - t)
        elif len(self.some) == 1 and outcome not in (
            outcomes.time_limit,
            outcomes.step_limit,
        ):  # with several lanes, another lane may stop this one
            raise ConvergenceError(
                f"heyoka stopped at t = {problem.time(t):.6g} with {outcome}; use backend='scipy'"
            )
        levels = (
            border.sign(one.mode) * border.level(state, problem.constants, one.mode)
            for border in self.field.borders
        )
        if not t < end and not all(level >= -2 * OVERSHOOT for level in levels):
            raise missed_event(problem.time(t))

    def begun(self, problem: Problem, directions: FloatArray | tuple[()] = ()) -> BatchIntegrator:
        """This integrator, prepared for one motion, for :meth:`motion` or :meth:`flow_map`."""
        self.some = [MotionState(problem, np.ravel(directions))]
        return self

    def motion(self) -> Solution:
        """Integrate to ``t_end``: the motion from ``t_record`` on."""
        (one,) = self.some
        begin = one.problem.t_record
        if begin > 0:
            self.propagate(self.some, 0.0, begin)
        return assembled(
            self.propagate(self.some, begin, one.problem.t_end, record=True), one.crossings, begin
        )

    def flow_map(self) -> FlowResult:
        """Integrate to ``t_end``: the final state, with derivatives."""
        (one,) = self.some
        self.propagate(self.some, 0.0, one.problem.t_end)
        found = FlowResult(*self._split(one.carried), tuple(one.crossings), tuple(one.extrema))
        if self.derivatives:
            return replace(found, integrals=tuple((one.carried[-2:] / DEVIATION_UNIT).tolist()))
        return found


def missed_event(t: float) -> ConvergenceError:
    """The error of a motion that has passed a border without an event, at time ``t``."""
    return ConvergenceError(f"heyoka missed a kink before t = {t:.6g}; use backend='scipy'")


_CACHE = threading.local()


def compiled(field: Field, tol: float, carried: Propagation = Propagation()) -> BatchIntegrator:
    """The integrator of a field with a tolerance, compiled once per thread."""
    integrators: dict[Any, BatchIntegrator] = _CACHE.__dict__.setdefault("compiled", {})
    key = field.name, field.lead, tol, carried
    if key not in integrators:
        integrators[key] = BatchIntegrator(field, tol, carried)
    return integrators[key]


def flow_integrator(problem: Problem, directions: FloatArray | None) -> BatchIntegrator:
    """Integrator of the flow map with extrema; unless ``directions`` is None with derivatives by
    the initial state and along them.
    """
    # Without derivatives another tolerance is used: other steps give independent evidence.
    tol, count = (1e-16, None) if directions is None else (TOLERANCE, len(directions))
    return compiled(problem.field, tol, Propagation(directions=count, turning=True)).begun(
        problem, () if directions is None else directions
    )


def tolerance(problem: Problem) -> float:
    """Relative tolerance of a step."""
    return _tightened(problem.field, problem.rtol)


def _tightened(field: Field, tol: float) -> float:
    """The tolerance, limited to 1e-3 OVERSHOOT where a field does not take it."""
    return tol if takes_rtol(field) else min(tol, 1e-3 * OVERSHOOT)


def takes_rtol(field: Field) -> bool:
    """Whether steps may be as coarse as is asked: not with a nonlinear level.

    The Taylor series of such a level agrees with that of the state up to the tolerance only. If
    that is not far below OVERSHOOT, the border just crossed would be found again.
    """
    return not field.nonlinear_levels


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end``: the motion from ``t_record`` on."""
    return compiled(problem.field, problem.rtol).begun(problem).motion()


def measured(problems: Sequence[Problem]) -> tuple[list[MotionStatistics | Exception], list[int]]:
    """Statistics of motions after ``t_record``, accumulated during the integration, or the error of
    each.

    Also returns the indices of motions whose statistics need samples: stiff ones, which heyoka
    cannot integrate, and those that may rest on a border. No samples are kept here. All problems
    have the same field, times and tolerance.
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
        maxima, minima, passages = (
            np.array(motion.latest[kind]).reshape(-1, 1 + size) for kind in (-1, 1, PASSAGE)
        )
        low = float(min(first[lead], last[lead], reach[1]))
        high = float(max(first[lead], last[lead], reach[-1]))
        return MotionStatistics(
            begin,
            end,
            first,
            last[:size],
            maxima[:, 0],
            maxima[:, 1:],
            last[size:] / scale,
            minima[:, 1:],
            np.array(motion.counts),
            (low, high),
            passages[:, 0],
            passages[:, 1:],
            lead,
        )

    found = [
        each.error or statistics(each, start) for each, start in zip(motions, first, strict=True)
    ]
    need_samples = [
        isinstance(each.error, StiffError) or (each.error is None and each.resting)
        for each in motions
    ]
    return found, np.flatnonzero(need_samples).tolist()
