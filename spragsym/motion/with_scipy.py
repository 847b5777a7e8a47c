"""SciPy's DOP853, or Radau where motions are stiff, with the variational equations or without,
restarted at every border.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import FLOATS, OVERSHOOT, Mode
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

# The continuation of a mode grows without bound far outside it. Trial steps that go there are
# rejected in any case: the number must only be finite.
TRIAL_FLOATS = SimpleNamespace(**{**vars(FLOATS), "exp": lambda z: math.exp(min(z, 100.0))})
TRIAL_ARRAYS = SimpleNamespace(**{**vars(np), "exp": lambda z: np.exp(np.minimum(z, 100.0))})

#: As tight as DOP853 goes.
RTOL = 2.3e-14

#: Steps after which a flow is abandoned.
MAX_STEPS = 200_000


@dataclass(frozen=True)
class _ModeStep:
    """One step within a mode, in time from ``clock`` on, and what is crossed at its end: ``met`` is
    the state in this mode there, ``last`` that from which the next one goes on.
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
        """All that is carried at Lobatto points, between which crossings and turns are looked
        for.
        """
        samples = self.dense(self.t)
        samples[:, -1] = self.met
        return samples


@dataclass(frozen=True)
class Flight:
    """The motion of a problem, with derivatives by its start and along ``directions`` of the
    parameters unless these are None.

    By DOP853, or where it is ``stiff`` by Radau. ``interpolated`` is that states at borders are
    DOP853's dense output, and that the absolute tolerance is a thousandth of the relative one, as
    in the compiled integrator; else a step of its own leads there, as the interpolant is of lower
    order than the method.
    """

    problem: Problem
    directions: FloatArray | None = None
    stiff: bool = False
    interpolated: bool = False

    def flow_map(self) -> FlowResult:
        """Carry the state on to the end."""
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
        """The motion by its samples, from ``t_record`` on, without derivatives."""
        pieces, crossings, begin = list[Samples](), list[Crossing](), self.problem.t_record
        with np.errstate(
            all="ignore"
        ):  # trial steps may go as far as numbers do not, and are rejected
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
        # Absolute tolerance of flows, as a share of the relative one.
        options = {
            "rtol": rtol,
            "atol": rtol * (1e-3 if self.interpolated else (1e-15 / 2.3e-14)),
            "first_step": first,
        }
        rates = rates_of(self.problem, mode, self.directions, TRIAL_FLOATS)
        return (Radau if self.stiff else DOP853)(rates, begin, whole, bound, **options)

    def _pieces(self, whole: FloatArray) -> Iterator[_ModeStep]:
        """Steps, none of which leaves its mode; a step that would is cut at the border. An error
        after too many.
        """
        field, duration, clock = self.problem.field, self.problem.t_end, 0.0
        m, most = field.size, self.problem.max_steps or MAX_STEPS
        first = None
        mode = self._carried(whole).initial_mode()
        looked = 0.0
        steps = 0
        # Steps between two looks at whether they have collapsed.
        look = 2000
        while clock < duration:
            # Time runs from 0 in every mode: the closer to the crossing, the more digits it has.
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
                # Coordinates and rates that are larger where steps have become
                # as small as floats grow beyond all bounds in a finite time.
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
                if steps % look == 0 and not self.stiff:
                    step, looked, left = (clock + end - looked) / look, clock + end, bound - end
                    check_stiffness(self.problem, solver.y[:m], step, left, 1e5)
            if found is None:
                return
            at, row = found
            first = solver.step_size
            whole = dense(at) if self.interpolated else self._stepped(mode, before, begin, at)
            for _ in range(
                4 * self.stiff
            ):  # Radau's interpolant is of low order: Newton's method on steps of its own
                clear, rate = self._levels(mode, whole[:m], inside=True)[row].tolist()
                if abs(clear) > OVERSHOOT / 10 and rate:
                    at = max(at - clear / rate, begin)
                    whole = self._stepped(mode, before, begin, at)
            met = whole.copy()
            after, crossings = self._carried(whole).passed(row, mode, clock + at)
            yield _ModeStep(clock, begin, at, met, whole, dense, mode, crossings)
            clock, mode = clock + at, after

    def _stepped(self, mode: Mode, state: FloatArray, begin: float, end: float) -> FloatArray:
        """A state carried on to the end of a part of a step."""
        if end <= begin:
            return state
        solver = self.solver(mode, state, end, begin, end - begin)
        while solver.status == "running":
            solver.step()
        return np.asarray(solver.y)

    def _levels(self, mode: Mode, states: FloatArray, *, inside: bool = False) -> FloatArray:
        """Levels of all borders, and the leading coordinate as the last one, with their rates:
        (borders + 1, 2, …).

        Or how far ``inside`` those of a mode, negative beyond.
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
        """A level (part 0) or its rate (part 1) at a time within a step."""
        states = piece.dense(np.asarray(t))[: self.problem.field.size]
        return float(self._levels(piece.mode, states, inside=inside)[row, part])

    def _first_crossing(self, piece: _ModeStep) -> tuple[float, int] | None:
        """When the motion first leaves its mode, and through which border."""
        found = []
        levels = self._levels(piece.mode, piece.samples[: self.problem.field.size], inside=True)
        least, fastest = levels[:-1, 0].min(axis=1), np.abs(levels[:-1, 1]).max(axis=1)
        for row in np.flatnonzero(~(least > fastest * np.diff(piece.t).max())).tolist():
            (distance, rate), border = levels[row], partial(self._at, piece, True, row)
            for i in np.flatnonzero(
                (distance[1:] < 0) | ((rate[:-1] < 0) & (rate[1:] > 0))
            ).tolist():
                begin, end = piece.t[i : i + 2].tolist()
                if not distance[i + 1] < 0:  # it may dip below 0 between two points
                    end = _root(partial(border, 1), begin, end)
                if distance[i + 1] < 0 or border(0, end) < 0:
                    found.append((_root(partial(border, 0), begin, end), row))
                    break
        return min(found, default=None)

    def _extrema(self, piece: _ModeStep) -> list[Extremum]:
        """Zeros of the rates within a step: of the leading coordinate, numbered −1, and of levels
        where there is a kink.

        Signs at a step's end are those of the state behind it: rounding decides those at a border.
        """
        field, found = self.problem.field, list[Extremum]()
        watched = [-1, *(row for row, border in enumerate(field.borders) if border.kink)]
        states = np.column_stack([piece.samples[:, :-1], piece.last])[: field.size]
        values = self._levels(piece.mode, states)[watched, 1]
        for row, i in np.argwhere((values[:, :-1] < 0) != (values[:, 1:] < 0)).tolist():
            (begin, end), rate = piece.t[i : i + 2].tolist(), values[row, i]
            level = partial(self._at, piece, False, watched[row], 1)
            behind = rate * level(end) > 0  # the step's own rate keeps its sign up to its end
            t = end if behind else _root(level, begin, end)
            state = piece.last if behind else piece.dense(t)
            way = 1 if rate < 0 else -1
            found.append(Extremum(piece.clock + t, watched[row], way, *self._split(state)))
        return sorted(found, key=lambda turn: turn.t)


def tolerance(problem: Problem, stiff: bool = False) -> float:
    """Relative tolerance of a step of DOP853, or of Radau where the motion is stiff."""
    if problem.field.nonlinear_levels and problem.field.sticking_borders and not stiff:
        return RTOL  # what stays on a curved border is kept there by the equations of motion alone
    # As tight as Radau goes, whose order is five.
    return max(problem.rtol, 1e-12 * stiff)


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    return Flight(problem, interpolated=True).motion()


def _root(function: Callable[[float], float], begin: float, end: float) -> float:
    """Place of a change of sign of a function."""
    from scipy.optimize import brentq

    if function(begin) * function(end) > 0:
        return begin  # the motion begins beyond the border, by rounding: it is left at once
    return float(brentq(function, begin, end, xtol=1e-15, rtol=8.9e-16))
