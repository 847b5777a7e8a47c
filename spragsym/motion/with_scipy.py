"""Integration by SciPy's DOP853, or by Radau for stiff motions, with or without the variational
equations.

Each step stays within one mode of the field: if the motion leaves the mode during a step, the
crossing of the border is located by root finding, the step is cut there, and the method restarts in
the next mode.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import FLOATS, OVERSHOOT, Field, Mode
from ..models.parameters import FloatArray
from ..numerics.vectors import magnitude
from .lobatto import sample_times
from .problem import Problem, check_stiffness, out_of_range, too_many_steps
from .solution import (
    CarriedState,
    Crossing,
    Extremum,
    FlowResult,
    Samples,
    Solution,
    assembled,
    parted,
    rates_of,
)

# The analytic continuation of a mode grows without bound far outside it. Trial steps that go there
# are rejected in any case, but their values must be finite.
TRIAL_FLOATS = SimpleNamespace(**{**vars(FLOATS), "exp": lambda z: math.exp(min(z, 100.0))})
TRIAL_ARRAYS = SimpleNamespace(**{**vars(np), "exp": lambda z: np.exp(np.minimum(z, 100.0))})

#: Smallest relative tolerance of DOP853.
RTOL = 2.3e-14

#: Default maximum number of steps of a flow.
MAX_STEPS = 200_000


@dataclass(frozen=True)
class _ModeStep:
    """One step within a mode, from ``begin`` to ``end`` in time counted from ``clock``.

    At a border ``met`` is the state at the end of the step, ``last`` the one at which the next step
    begins, after the jump of the field; both are equal elsewhere.
    """

    clock: float
    begin: float
    end: float
    met: FloatArray
    last: FloatArray
    dense: Callable[[Any], FloatArray]
    mode: Mode
    crossings: tuple[Crossing, ...] = ()

    @cached_property
    def t(self) -> FloatArray:
        """Times of the samples."""
        return sample_times(self.begin, self.end)

    @cached_property
    def samples(self) -> FloatArray:
        """State, and derivatives if integrated, at the Lobatto points of the step."""
        samples = self.dense(self.t)
        samples[:, -1] = self.met
        return samples


@dataclass(frozen=True)
class Flight:
    """Integration of a problem, by DOP853, or by Radau if ``stiff``.

    Unless ``directions`` is None, with derivatives by the initial state and along these directions
    of the parameters. With ``interpolated`` states at borders are taken from the dense output, and
    the absolute tolerance is a thousandth of the relative one, as in the compiled integrator.
    Otherwise a separate step leads to the border, because the dense output has a lower order than
    the method.
    """

    problem: Problem
    directions: FloatArray | None = None
    stiff: bool = False
    interpolated: bool = False

    def flow_map(self) -> FlowResult:
        """Integrate to ``t_end``: the final state, with derivatives."""
        m = self.problem.field.size
        crossings, extrema = list[Crossing](), list[Extremum]()
        whole = np.array(self.problem.start, dtype=float)
        if self.directions is not None:
            whole = np.concatenate([whole, np.eye(m, m + len(self.directions)).ravel()])
        for piece in self._pieces(whole):
            extrema += self._extrema(piece)
            crossings += piece.crossings
            whole = piece.last
        return FlowResult(*self._split(whole), tuple(crossings), tuple(extrema))

    def motion(self) -> Solution:
        """Integrate to ``t_end``, without derivatives: the motion from ``t_record`` on."""
        pieces, crossings, begin = list[Samples](), list[Crossing](), self.problem.t_record
        with np.errstate(all="ignore"):  # trial steps may overflow, and are then rejected
            for piece in self._pieces(np.array(self.problem.start, dtype=float)):
                crossings += piece.crossings
                if piece.end > max(piece.begin, begin - piece.clock):
                    pieces.append(((piece.clock + piece.t)[None], piece.samples[None]))
        return replace(assembled(pieces, crossings, begin), implicit=self.stiff)

    def _carried(self, whole: FloatArray) -> CarriedState:
        m = self.problem.field.size
        return CarriedState(self.problem, whole[:m], self.directions, whole[m:].reshape(m, -1))

    def _split(self, values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        m = self.problem.field.size
        return parted(values[:m], None if self.directions is None else values[m:].reshape(m, -1))

    def solver(
        self,
        mode: Mode,
        whole: FloatArray,
        bound: float,
        begin: float = 0.0,
        first: float | None = None,
    ) -> Any:
        """SciPy's solver for one mode, from ``begin`` to ``bound``."""
        from scipy.integrate import DOP853, Radau

        rtol = tolerance(self.problem, self.stiff)
        atol = rtol * (1e-3 if self.interpolated else (1e-15 / 2.3e-14))
        options = {"rtol": rtol, "atol": atol, "first_step": first}
        rates = rates_of(self.problem, mode, self.directions, TRIAL_FLOATS)
        return (Radau if self.stiff else DOP853)(rates, begin, whole, bound, **options)

    def _pieces(self, whole: FloatArray) -> Iterator[_ModeStep]:
        """All steps, from the initial state ``whole``; a step that would leave its mode is cut at
        the border.

        Raises ConvergenceError if the method fails or takes too many steps, and StiffError if
        stability limits its steps.
        """
        field, duration, clock = self.problem.field, self.problem.t_end, 0.0
        m, most = field.size, self.problem.max_steps or MAX_STEPS
        first = None
        mode = self._carried(whole).initial_mode()
        checked_t = 0.0
        steps = 0
        # Stiffness is checked after each so many steps.
        check_interval = 2000
        while clock < duration:
            # Time starts from 0 in every mode, which resolves short times after a crossing.
            bound = duration - clock
            begun = rates_of(self.problem, mode, self.directions, TRIAL_FLOATS)(0.0, whole)
            if not np.isfinite(begun).all():
                raise out_of_range()
            solver = self.solver(
                mode, whole, bound, first=None if first is None else min(first, bound)
            )
            found = None
            while solver.status == "running" and found is None:
                before, message = solver.y.copy(), solver.step()
                failed = solver.status == "failed"
                # If steps have become too small for floats while the state is this large, the
                # solution blows up in finite time.
                if not np.isfinite(solver.y).all() or (failed and magnitude(solver.y[:m]) > 1e12):
                    raise out_of_range()
                if failed:
                    name, t = type(solver).__name__, self.problem.time(clock + solver.t)
                    raise ConvergenceError(
                        f"SciPy's {name} stopped at t = {t:.6g}: {message}; use a larger rtol"
                    )
                dense, begin, end, steps = solver.dense_output(), solver.t_old, solver.t, steps + 1
                if steps > most:
                    problem = replace(self.problem, rtol=solver.rtol)
                    raise too_many_steps(problem, most, clock + end, solver.y[:m])
                last = solver.y.copy()
                piece = _ModeStep(clock, begin, end, last, last, dense, mode)
                found = self._first_crossing(piece)
                if found is None:
                    yield piece
                if steps % check_interval == 0 and not self.stiff:
                    step = (clock + end - checked_t) / check_interval
                    checked_t, left = clock + end, bound - end
                    check_stiffness(self.problem, solver.y[:m], step, left, 1e5)
            if found is None:
                return
            at, row = found
            first = solver.step_size
            whole = dense(at) if self.interpolated else self._stepped(mode, before, begin, at)
            # Radau's dense output has a low order: locate the border by Newton's method instead.
            for _ in range(4 * self.stiff):
                clear, rate = self._levels(mode, whole[:m], inside=True)[row].tolist()
                if abs(clear) > OVERSHOOT / 10 and rate:
                    at = max(at - clear / rate, begin)
                    whole = self._stepped(mode, before, begin, at)
            met = whole.copy()
            after, crossings = self._carried(whole).passed(row, mode, clock + at)
            yield _ModeStep(clock, begin, at, met, whole, dense, mode, crossings)
            clock, mode = clock + at, after

    def _stepped(self, mode: Mode, state: FloatArray, begin: float, end: float) -> FloatArray:
        """The state at ``end``, integrated from the state at ``begin`` within the same step."""
        if end <= begin:
            return state
        solver = self.solver(mode, state, end, begin, end - begin)
        while solver.status == "running":
            solver.step()
        return np.asarray(solver.y)

    def _levels(self, mode: Mode, states: FloatArray, *, inside: bool = False) -> FloatArray:
        """Levels of all borders with their rates, and those of the leading coordinate last:
        (borders + 1, 2, …).

        With ``inside`` the levels are signed distances from the end of the mode, negative beyond.
        """
        field, constants = self.problem.field, self.problem.constants
        accelerations = field.acceleration(states, constants, mode, TRIAL_ARRAYS)
        found = np.empty((len(field.borders) + 1, 2, *states.shape[1:]))
        for row, border in zip(found, field.borders, strict=False):
            sign = border.sign(mode) if inside else 1
            row[0] = sign * border.level(states, constants, mode) + OVERSHOOT * (
                inside and border.kink
            )
            row[1] = sign * border.rate(states, accelerations, constants, mode)
        found[-1] = states[field.lead], states[len(field.coordinates) + field.lead]
        return found

    def _at(self, piece: _ModeStep, inside: bool, row: int, part: int, t: float) -> float:
        """Entry [row, part] of :meth:`_levels` at a time within a step: a level (part 0) or its
        rate (part 1).
        """
        states = piece.dense(np.asarray(t))[: self.problem.field.size]
        return float(self._levels(piece.mode, states, inside=inside)[row, part])

    def _first_crossing(self, piece: _ModeStep) -> tuple[float, int] | None:
        """Time at which the motion first leaves its mode within a step, and the index of the
        border; None if it does not.
        """
        found = []
        levels = self._levels(piece.mode, piece.samples[: self.problem.field.size], inside=True)
        least, fastest = levels[:-1, 0].min(axis=1), np.abs(levels[:-1, 1]).max(axis=1)
        # Other borders are too far away to be reached between two samples.
        for row in np.flatnonzero(~(least > fastest * np.diff(piece.t).max())).tolist():
            (distance, rate), border = levels[row], partial(self._at, piece, True, row)
            has_minimum = (rate[:-1] < 0) & (rate[1:] > 0)
            for i in np.flatnonzero((distance[1:] < 0) | has_minimum).tolist():
                begin, end = piece.t[i : i + 2].tolist()
                if not distance[i + 1] < 0:  # the minimum between two samples may be below 0
                    end = _root(partial(border, 1), begin, end)
                if distance[i + 1] < 0 or border(0, end) < 0:
                    found.append((_root(partial(border, 0), begin, end), row))
                    break
        return min(found, default=None)

    def _extrema(self, piece: _ModeStep) -> list[Extremum]:
        """Extrema within a step, in time: of the leading coordinate, number −1, and of the levels
        of borders with a kink.

        The signs of the rates at the end of a step are those at which the next step begins: on the
        border itself rounding would decide them.
        """
        field, found = self.problem.field, list[Extremum]()
        watched = [-1, *(row for row, border in enumerate(field.borders) if border.kink)]
        states = np.column_stack([piece.samples[:, :-1], piece.last])[: field.size]
        values = self._levels(piece.mode, states)[watched, 1]
        for row, i in np.argwhere((values[:, :-1] < 0) != (values[:, 1:] < 0)).tolist():
            (begin, end), rate = piece.t[i : i + 2].tolist(), values[row, i]
            level = partial(self._at, piece, False, watched[row], 1)
            if rate * level(end) > 0:  # the rate changes its sign by the jump at the end
                t, state = end, piece.last
            else:
                t = _root(level, begin, end)
                state = piece.dense(t)
            direction = 1 if rate < 0 else -1
            found.append(Extremum(piece.clock + t, watched[row], direction, *self._split(state)))
        return sorted(found, key=lambda extremum: extremum.t)


def tolerance(problem: Problem, stiff: bool = False) -> float:
    """Relative tolerance of a step of DOP853, or of Radau if ``stiff``."""
    if stiff:
        return max(problem.rtol, 1e-12)  # the smallest at which Radau, of order five, is usable
    return problem.rtol if takes_rtol(problem.field) else RTOL


def takes_rtol(field: Field) -> bool:
    """Whether steps may be as coarse as is asked: only their accuracy keeps a sticking state on a
    curved border.
    """
    return not (field.nonlinear_levels and field.sticking_borders)


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end``: the motion from ``t_record`` on."""
    return Flight(problem, interpolated=True).motion()


def _root(function: Callable[[float], float], begin: float, end: float) -> float:
    """Root of a function in a bracket, by Brent's method."""
    from scipy.optimize import brentq

    if function(begin) * function(end) > 0:
        return begin  # by rounding the motion begins beyond the border
    return float(brentq(function, begin, end, xtol=1e-15, rtol=8.9e-16))
