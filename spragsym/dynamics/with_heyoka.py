"""heyoka's Taylor method, with the borders between the modes of the field as terminal events."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import Any, TypeAlias

import numpy as np

from ..errors import ConvergenceError
from ..parameters import FloatArray
from .course import Course
from .lobatto import unit_points
from .problem import GAP, WIDTH, Event, Mode, Problem, acceleration, initial_mode, is_inside, out_of_range, too_many_steps
from .solution import Crossing, Solution, assembled

#: Steps between two looks at signals: Python hears Ctrl-C only when compiled code returns. At most a second or so.
CHUNK = 20_000

#: Times and states by steps, shapes (steps, DEGREE + 1) and (steps, 4, DEGREE + 1).
Samples: TypeAlias = tuple[FloatArray, FloatArray]


class Compiled:
    """A compiled Taylor integrator, used again and again: parameters and mode are its ``par[]``.

    With ``watch`` it also carries the integrals of a :class:`Course` and notes where x' = 0. The integrals are scaled so
    that they stay below the states: heyoka's error is relative to the largest of all.
    """

    def __init__(self, rtol: float, watch: bool) -> None:
        import heyoka as hy

        x, y, vx, vy = hy.make_vars("x", "y", "vx", "vy")
        constants = [hy.par[i] for i in range(9)]
        V, d = constants[7:]
        nbar, side, near, reach = (hy.par[i] for i in range(9, 13))
        xp = SimpleNamespace(sqrt=hy.sqrt, exp=lambda z: near * hy.exp(z))
        ax, ay = acceleration(x, y, vx, vy, *constants, nbar, side, xp=xp)
        borders = {
            self._contact: y + GAP * (1 - 2 * nbar),
            # heyoka's error is relative to the largest of the states and these functions, which are scaled down to be smaller.
            self._slip: 1e-3 * (V - vx + GAP * side),
            self._layer: 1e-3 * ((d * side * (V - vx) - WIDTH * near) / reach - 1),
        }
        self.log: list[Crossing] = []
        self.stray: float | None = None
        self.turns: list[tuple[float, ...]] = []
        system, turns = [(x, vx), (y, vy), (vx, ax), (vy, ay)], []
        if watch:
            shift, scale = x - hy.par[13], hy.par[14]
            system += zip(hy.make_vars("s", "ss", "sy"), (scale * shift, scale * shift * shift, scale * y), strict=True)
            turns = [hy.nt_event(1e-3 * vx, self._turn)]
        # The gap prevents one crossing from being found twice, so that no cooldown is needed.
        self.solver = hy.taylor_adaptive(
            system, [0.0] * len(system), pars=[0.0] * (15 if watch else 13), tol=rtol, nt_events=turns,
            t_events=[hy.t_event(border, callback=call, cooldown=0.0) for call, border in borders.items()],
        )  # fmt: skip

    def __deepcopy__(self, _: object) -> Compiled:
        """heyoka deep-copies its callbacks; the copies must still write to this object."""
        return self

    def _turn(self, solver: Any, t: float, direction: int) -> None:
        solver.update_d_output(t)
        self.turns.append((direction, t, *solver.d_output))

    def _contact(self, solver: Any, direction: int) -> bool:
        if direction > 0:
            return self._switch(solver, 9, 1, 0, Event.CONTACT_LOST)
        return self._switch(solver, 9, 0, 1, Event.CONTACT_REGAINED)

    def _slip(self, solver: Any, direction: int) -> bool:
        if direction > 0:
            return self._switch(solver, 10, -1, 1, Event.BELT_OVERTAKES)
        return self._switch(solver, 10, 1, -1, Event.MASS_OVERTAKES)

    def _layer(self, solver: Any, direction: int) -> bool:
        return self._switch(solver, 11, int(direction > 0), int(direction < 0), None)

    def _switch(self, solver: Any, par: int, before: int, after: int, kind: Event | None) -> bool:
        """Change to the next mode; stop if the motion is not on the side it should come from: a crossing was missed."""
        if solver.pars[par] != before:
            self.stray = solver.time
            return False
        solver.pars[par] = after
        if kind is not None:
            self.log.append(Crossing(solver.time, tuple(solver.state[:4]), kind))
        return True

    def begin(self, problem: Problem) -> None:
        """Go to the start of a motion."""
        self.place(0.0, problem.start, (*problem.constants, *initial_mode(problem), problem.reach))

    def place(self, t: float, state: Any, pars: Any) -> None:
        """Start from any time and state, with no events recorded."""
        solver = self.solver
        self.log, self.turns, self.stray = [], [], None
        solver.time = t
        solver.state[:] = (*state, *[0.0] * (len(solver.state) - 4))
        solver.pars[:13] = pars
        solver.reset_cooldowns()

    def go(self, problem: Problem, t: float, steps: int = 0, *, record: bool = False) -> tuple[int, list[Samples]]:
        """Go on to ``t`` from step number ``steps``; the number reached, and the samples of every chunk if asked for."""
        import heyoka as hy

        solver = self.solver
        pieces: list[Samples] = []
        outcome = hy.taylor_outcome.step_limit
        while outcome == hy.taylor_outcome.step_limit:
            if steps >= problem.max_steps:
                raise too_many_steps(problem, solver.time)
            result = solver.propagate_until(t, c_output=record, max_steps=min(CHUNK, problem.max_steps - steps))
            outcome, steps = result[0], steps + result[3]
            if result[4] is not None:
                pieces.append(_sampled(result[4]))
            if self.stray is not None:
                raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        if outcome == hy.taylor_outcome.err_nf_state:
            raise out_of_range()
        if outcome != hy.taylor_outcome.time_limit:
            raise ConvergenceError(f"heyoka stopped at t = {solver.time:.6g} with {outcome}; use backend='scipy'")
        if not is_inside(problem, Mode(*(int(value) for value in solver.pars[9:12])), solver.state):
            raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        return steps, pieces


def _sampled(output: Any) -> Samples:
    """Times and values of a heyoka continuous output at the Lobatto points of its steps."""
    coefficients, begin, step = output.tcs, output.times[:-1, None], np.diff(output.times)[:, None]
    unit = unit_points()
    order = np.arange(coefficients.shape[2])
    states = (coefficients * step[:, :, None] ** order) @ unit ** order[:, None]
    t = begin + step * unit
    t[:, -1] = output.times[1:]
    return t, states


_CACHE = threading.local()


def compiled_for(rtol: float, watch: bool) -> Compiled:
    """Compiled once per tolerance and thread."""
    known: dict[tuple[float, bool], Compiled] = _CACHE.__dict__.setdefault("compiled", {})
    if (rtol, watch) not in known:
        known[rtol, watch] = Compiled(rtol, watch)
    return known[rtol, watch]


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    compiled = compiled_for(problem.rtol, watch=False)
    compiled.begin(problem)
    steps = compiled.go(problem, problem.t_record)[0] if problem.t_record > 0 else 0
    _, pieces = compiled.go(problem, problem.t_end, steps, record=True)
    times, states = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    return assembled(times, states, compiled.log, problem.t_record)


def watch(problem: Problem) -> Course:
    """What follows ``t_record``, measured by heyoka on the way: no continuous output, which costs a compilation a motion."""
    watching, steps = compiled_for(problem.rtol, watch=True), 0
    if problem.t_record > 0:
        plain = compiled_for(problem.rtol, watch=False)
        plain.begin(problem)
        steps, _ = plain.go(problem, problem.t_record)
        watching.place(problem.t_record, plain.solver.state, plain.solver.pars)
    else:
        watching.begin(problem)
    solver = watching.solver
    first = solver.state[:4].copy()
    scale = 1e-3 / (problem.t_end - problem.t_record)
    solver.pars[13:] = first[0], scale
    watching.go(problem, problem.t_end, steps)
    turns = np.array(watching.turns).reshape(-1, 9)
    maxima, minima = turns[turns[:, 0] < 0], turns[turns[:, 0] > 0]
    last = solver.state.copy()
    events = np.bincount([crossing.kind for crossing in watching.log], minlength=len(Event))
    return Course(
        problem.t_record, problem.t_end, first, last[:4], maxima[:, 1], maxima[:, 2:6],
        np.vstack([maxima[:, 6:], last[4:]]) / scale, minima[:, 2:6], events,
    )  # fmt: skip
