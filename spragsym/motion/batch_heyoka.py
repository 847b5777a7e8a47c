"""Batch integration by heyoka's Taylor method: many motions at a time, one in each lane of vector instructions.

A lane takes its own steps, meets its own borders, and does the same arithmetic whatever runs beside it, so that the bits of a
motion depend on the motion alone. One that has ended makes room for the next. One that breaks off stops the others: these are
begun again without it, since nothing says what its last step has done to them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..models.field import Field, Mode
from ..models.heyoka_library import library
from ..models.parameters import FloatArray
from .measures import Course, Turns
from .problem import Event, Problem, StiffError, check_stiffness, event_at, out_of_range, too_many_steps
from .with_heyoka import CHUNK, Carrier, Equations, compiled, missed

#: Motions in flight. Another number compiles other code, and may give other last bits.
LANES = 8

#: Steps after which lanes that have ended are filled anew; also between two looks at signals, for Python hears Ctrl-C only then.
BURST = 128

#: A motion that passes a border again this near to where it passed it, as a share of its state, may rest there.
NEAR = 1e-3

#: Kinds of event.
EVENTS = len(Event)


@dataclass
class Stage:
    """Motions on their way: what is carried of each (rows), its mode, its steps so far, and why those stopped that did."""

    problems: Sequence[Problem]
    constants: FloatArray
    carried: FloatArray
    modes: list[Mode]
    steps: list[int]
    turns: list[Turns | None] = field(default_factory=list)
    counts: list[list[int]] = field(default_factory=list)
    errors: dict[int, Exception] = field(default_factory=dict)
    #: Those that may rest on a border, where events are told from chatter by samples only.
    resting: set[int] = field(default_factory=set)

    @classmethod
    def of(cls, problems: Sequence[Problem]) -> Stage:
        """All of them at their starts."""
        constants, starts = (np.array([getattr(each, name) for each in problems], dtype=float) for name in ("constants", "start"))
        modes = problems[0].field.initial_modes(starts, constants)
        return cls(problems, constants, starts, modes, [0] * len(modes))


@dataclass
class _Run:
    """A stage on its way to the next: what all begin with (columns), who waits, and who is in which lane."""

    stage: Stage
    after: Stage
    state: FloatArray
    pars: FloatArray
    waiting: list[int]
    running: dict[int, int] = field(default_factory=dict)


class Lanes(Carrier):
    """A compiled integrator of :data:`LANES` motions, used again and again.

    With ``watch`` it also carries the integrals of a :class:`~spragsym.motion.measures.Course`, and notes where x' = 0.
    """

    def __init__(self, field: Field, rtol: float, watch: bool) -> None:
        equations = Equations.of(field, watch=watch)
        turns = [(equations.seen[0][field.size // 2], self._turn)] if watch else []
        super().__init__(field, rtol, equations, turns, lanes=LANES)
        self.watch = watch
        self.turns: list[Turns | None] = [None] * LANES
        self.counts = [[0] * EVENTS for _ in range(LANES)]
        #: Where borders were last crossed, and lanes in which that was where they had been crossed before.
        self.crossed: list[dict[int, list[float]]] = [{} for _ in range(LANES)]
        self.resting: set[int] = set()
        #: Time and steps of each lane when it was last looked at whether steps have collapsed.
        self.looked: list[tuple[float, int]] = [(0.0, 0)] * LANES
        self.dense, self.look = self.solver.d_output, self.solver.update_d_output

    def _crossed(self, row: int, lane: int, _: FloatArray) -> None:
        border = self.field.borders[row]
        kind = event_at(border, upward=int(border.sign(self.modes[lane])) > 0)
        if kind is not None:
            self.counts[lane][kind] += 1
            if self.watch:
                self._rest(lane, row)

    def _rest(self, lane: int, row: int) -> None:
        """Note where a border is crossed, or the motion ends after that, and whether it had been crossed near there."""
        state = self.state[: self.m, lane].tolist()
        before, self.crossed[lane][row] = self.crossed[lane].get(row), state
        if before and max(abs(a - b) for a, b in zip(state, before, strict=True)) <= NEAR * max(map(abs, state)):
            self.resting.add(lane)

    def _turn(self, _: Any, t: float, direction: int, lane: int) -> None:
        self.look(t)
        seen = self.turns[lane]
        if seen is None:
            self.turns[lane] = seen = Turns()
        seen.add(t, direction, self.dense[:, lane].tolist())

    def carry(self, stage: Stage, begin: float, end: float) -> Stage:
        """Where the motions of a stage are that are carried from ``begin`` to ``end`` and do not stop on the way."""
        run = self._run(stage, end - begin)
        while run.waiting or run.running:
            if len(run.running) < LANES:
                self._fill(run, begin, end)
            self.solver.propagate_until(end, max_steps=BURST)
            self._sort_out(run, end)
        states, modes = run.after.carried[:, : self.m].T, np.array(run.after.modes).T
        for row in np.flatnonzero(~self.field.are_inside(states, stage.constants.T, modes)).tolist():
            stage.errors.setdefault(row, missed(end) if np.isfinite(states[:, row]).all() else out_of_range())
        return run.after

    def _run(self, stage: Stage, duration: float) -> _Run:
        count = len(stage.modes)
        state = np.zeros((len(self.state), count))
        state[: self.m] = stage.carried[:, : self.m].T
        watching = [stage.carried[:, 0], np.full(count, _scale(duration))] if self.watch else []
        pars = np.vstack([stage.constants.T, np.array(stage.modes, dtype=float).T.reshape(-1, count), *watching])
        pars = pars[: len(self.pars)]
        waiting = [row for row in reversed(range(count)) if row not in stage.errors]
        after = replace(
            stage, carried=np.full((count, len(self.state)), np.nan), modes=stage.modes.copy(), steps=stage.steps.copy(),
            turns=[None] * count, counts=[[0] * EVENTS] * count,
        )  # fmt: skip
        return _Run(stage, after, state, pars, waiting)

    def _fill(self, run: _Run, begin: float, end: float) -> None:
        """Put waiting motions into lanes that are free; what else is free stands still at the end, where another lane is."""
        solver, running = self.solver, run.running
        free = [lane for lane in range(LANES) if lane not in running]
        lanes = free[: len(run.waiting)]
        rows = [run.waiting.pop() for _ in lanes]
        late, early = (part.copy() for part in solver.dtime)
        late[free], early[free], late[lanes] = end, 0.0, begin
        self.state[:, lanes], self.pars[:, lanes] = run.state[:, rows], run.pars[:, rows]
        source, still = lanes[0] if lanes else next(iter(running)), free[len(lanes) :]
        self.state[:, still], self.pars[:, still] = self.state[:, [source]], self.pars[:, [source]]
        solver.set_dtime(late, early)
        for lane in free if self.eventful else ():
            solver.reset_cooldowns(lane)
        for lane, row in zip(lanes, rows, strict=True):
            running[lane] = row
            self.modes[lane], self.turns[lane], self.counts[lane] = run.stage.modes[row], None, [0] * EVENTS
            self.crossed[lane], self.looked[lane] = {}, (begin, run.after.steps[row])
            self.resting.discard(lane)

    def _arrive(self, after: Stage, lane: int, row: int) -> None:
        after.carried[row], after.modes[row] = self.state[:, lane], self.modes[lane]
        if self.watch:
            after.turns[row], after.counts[row] = self.turns[lane], self.counts[lane]
            for border in list(self.crossed[lane]):
                self._rest(lane, border)
            if lane in self.resting:
                after.resting.add(row)

    def _count(self, run: _Run, lane: int, row: int, results: Any) -> bool:
        """Count the steps of a motion; whether they are too many, or have collapsed."""
        run.after.steps[row] += results[lane][3]
        steps, problem, t = run.after.steps[row], run.stage.problems[row], float(self.solver.time[lane])
        before, counted = self.looked[lane]
        if steps > problem.max_steps:
            run.stage.errors[row] = too_many_steps(problem.max_steps, t, problem.t_end, problem.rtol)
        elif steps - counted >= CHUNK:
            self.looked[lane] = t, steps
            state, step = self.state[: self.m, lane], (t - before) / (steps - counted)
            try:
                check_stiffness(self.field, state, problem.constants, step, problem.t_end - t)
            except StiffError as error:
                run.stage.errors[row] = error
        return row in run.stage.errors

    def _sort_out(self, run: _Run, end: float) -> None:
        """Free the lanes of motions that have ended; where one broke off, the others under way begin the stage again."""
        hy = library()
        overflow, running = hy.taylor_outcome.err_nf_state, run.running
        results, times = self.solver.propagate_res, self.solver.time.tolist()
        bad = [lane for lane in running if lane in self.strays or results[lane][0] == overflow]
        if bad:
            for lane in bad:
                stray = self.strays.get(lane)
                run.stage.errors[running.pop(lane)] = out_of_range() if stray is None else missed(stray)
            for row in running.values():
                run.after.steps[row] = run.stage.steps[row]
            run.waiting += running.values()
            running.clear()
            self.strays.clear()
            return
        for lane, row in list(running.items()):
            stopped = self._count(run, lane, row, results)
            if times[lane] == end:
                self._arrive(run.after, lane, row)
            if stopped or times[lane] == end:
                del running[lane]


def _scale(duration: float) -> float:
    """What the integrals are multiplied by."""
    return 1e-3 / duration


def ends(problems: Sequence[Problem]) -> FloatArray:
    """States at ``t_end``; an error where one of them stops."""
    one = problems[0]
    stage = compiled(Lanes, one.field, one.rtol, watch=False).carry(Stage.of(problems), 0.0, one.t_end)
    for error in stage.errors.values():
        raise error
    return stage.carried


def watch(problems: Sequence[Problem]) -> tuple[list[Course | Exception], list[int]]:
    """What follows ``t_record``, measured on the way: no continuous output, which would have to be kept; or why there is none.

    And the rows of those that are to be measured from samples.
    """
    stage, one = Stage.of(problems), problems[0]
    if one.t_record > 0:
        stage = compiled(Lanes, one.field, one.rtol, watch=False).carry(stage, 0.0, one.t_record)
    first, begin, end = stage.carried, one.t_record, one.t_end
    stage = compiled(Lanes, one.field, one.rtol, watch=True).carry(stage, begin, end)
    size, scale = first.shape[1], _scale(end - begin)

    def course(row: int) -> Course:
        last, seen = stage.carried[row], stage.turns[row] or Turns()
        tops = np.array([[t, *carried] for t, carried in seen.tops]).reshape(-1, 1 + len(last))
        lows = np.array([carried[:size] for _, carried in seen.lows]).reshape(-1, size)
        integrals = np.vstack([tops[:, 1 + size :], last[size:]]) / scale
        low, high = (float(pick(first[row, 0], last[0], most)) for pick, most in ((min, seen.low), (max, seen.high)))
        return Course(
            begin, end, first[row], last[:size], tops[:, 0], tops[:, 1 : 1 + size], integrals, lows,
            np.array(stage.counts[row]), (low, high),
        )  # fmt: skip

    found = [stage.errors.get(row) or course(row) for row in range(len(problems))]
    stiff = {row for row, error in stage.errors.items() if isinstance(error, StiffError)}
    return found, sorted(stiff | (stage.resting - stage.errors.keys()))
