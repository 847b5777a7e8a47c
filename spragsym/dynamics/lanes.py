"""Many motions at a time by heyoka's Taylor method: one in each lane of vector instructions.

A lane takes its own steps, meets its own borders, and does the same arithmetic whatever runs beside it, so that the bits of a
motion depend on the motion alone. One that has ended makes room for the next. One that breaks off stops the others: these are
begun again without it, since nothing says what its last step has done to them.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from ..errors import ConvergenceError
from ..parameters import FloatArray
from .course import Course
from .field import Field, Mode
from .motions import Measured, Motions, Turns
from .problem import Event, event_at, out_of_range, too_many_steps
from .with_heyoka import Equations, watched

#: Motions in flight. Another number compiles other code, and may give other last bits.
LANES = 8

#: Steps after which lanes that have ended are filled anew; also between two looks at signals, for Python hears Ctrl-C only then.
BURST = 128

#: Kinds of event.
EVENTS = len(Event)

#: Of a motion that did not arrive.
_NEVER = [0] * EVENTS

#: Of a motion that did not turn.
_NONE = Turns()

#: What crossing a border does in a mode: in which direction it is crossed, the mode beyond, which parameters become what, and
#: what a user calls it.
_Passed: TypeAlias = tuple[int, Mode, list[tuple[int, float]], Event | None]


@dataclass
class Stage:
    """Motions on their way: what is carried of each (rows), its mode, its steps so far, and why those stopped that did."""

    motions: Motions
    carried: FloatArray
    modes: list[Mode]
    steps: list[int]
    turns: list[Turns | None] = field(default_factory=list)
    counts: list[list[int]] = field(default_factory=list)
    errors: dict[int, Exception] = field(default_factory=dict)

    @classmethod
    def of(cls, motions: Motions) -> Stage:
        """All of them at their starts."""
        initial = motions.field.initial_mode
        modes = [initial(state, known) for state, known in zip(motions.starts.tolist(), motions.constants.tolist(), strict=True)]
        return cls(motions, motions.starts, modes, [0] * len(modes))


class Lanes:
    """A compiled integrator of :data:`LANES` motions, used again and again.

    With ``watch`` it also carries the integrals of a :class:`~spragsym.dynamics.course.Course`, and notes where x' = 0.
    """

    def __init__(self, field: Field, constants: int, rtol: float, watch: bool) -> None:
        import heyoka as hy

        equations = Equations.of(field, constants, watch=watch)
        self.size, self.constants, self.watch = field.size, constants, watch
        self.modes: list[Mode] = [field.modes[0]] * LANES
        self.turns: list[Turns | None] = [None] * LANES
        self.counts = [[0] * EVENTS for _ in range(LANES)]
        #: Lanes in which a crossing was missed, with the time.
        self.strays: dict[int, float] = {}
        # The gap keeps one crossing from being found twice, which is what a cooldown is for.
        self.solver = solver = hy.taylor_adaptive_batch(
            equations.system, np.zeros((len(equations.system), LANES)), pars=np.zeros((equations.numbers, LANES)), tol=rtol,
            t_events=[
                hy.t_event_batch(watched(border, *equations.seen), callback=self._crossing(field, row), cooldown=0.0)
                for row, border in enumerate(field.borders)
            ],
            nt_events=[hy.nt_event_batch(1e-3 * equations.seen[0][self.size // 2], self._turning())] if watch else [],
        )  # fmt: skip
        # Views of what the integrator holds: each look at an attribute makes one anew.
        self.state, self.pars, self.dense, self.look = solver.state, solver.pars, solver.d_output, solver.update_d_output

    def _crossing(self, field: Field, row: int) -> Callable[[Any, int, int], bool]:
        """Go over to the next mode; stop if it is not next, for then a crossing was missed."""
        border, table = field.borders[row], dict[Mode, _Passed]()
        for mode in field.modes:
            inside, after = int(border.sign(mode)), border.beyond(mode)
            places = range(self.constants, self.constants + len(mode))
            changed = [(place, float(new)) for place, old, new in zip(places, mode, after, strict=True) if old != new]
            table[mode] = (-inside, after, changed, event_at(border, upward=inside < 0))

        def cross(solver: Any, direction: int, lane: int) -> bool:
            leaving, after, changed, kind = table[self.modes[lane]]
            if direction != leaving:
                self.strays[lane] = float(solver.time[lane])
                return False
            self.modes[lane] = after
            for place, value in changed:
                self.pars[place, lane] = value
            if kind is not None:
                self.counts[lane][kind] += 1
            return True

        return cross

    def _turning(self) -> Callable[[Any, float, int, int], None]:
        def turn(_: Any, t: float, direction: int, lane: int) -> None:
            self.look(t)
            seen = self.turns[lane]
            if seen is None:
                self.turns[lane] = seen = Turns()
            seen.add(t, direction, self.dense[:, lane].tolist())

        return turn

    def carry(self, stage: Stage, begin: float, end: float) -> None:
        """Carry all motions of a stage on from ``begin`` to ``end`` but those that have stopped, or stop on the way."""
        import heyoka as hy

        ended, going = hy.taylor_outcome.time_limit, (hy.taylor_outcome.step_limit, hy.taylor_outcome.success)
        loads = self._loads(stage, end - begin)
        carried, most, steps = np.full((len(stage.modes), len(self.state)), np.nan), stage.motions.max_steps, stage.steps.copy()
        modes, stage.turns, stage.counts = stage.modes.copy(), [None] * len(steps), [_NEVER] * len(steps)
        waiting, running = [row for row in reversed(range(len(steps))) if row not in stage.errors], dict[int, int]()
        while waiting or running:
            if len(running) < LANES:
                self._fill(stage, loads, waiting, running, begin, end)
            self.solver.propagate_until(end, max_steps=min(BURST, most - max([steps[row] for row in running.values()])))
            results = self.solver.propagate_res
            arrived = [lane for lane in running if results[lane][0] == ended]
            late = [lane for lane in running if lane not in arrived] if len(arrived) < len(running) else []
            bad = [lane for lane in late if lane in self.strays or results[lane][0] not in going]
            if bad or self.strays:
                for lane in bad or late:
                    stage.errors[running.pop(lane)] = self._stopped(lane, results[lane][0])
                for row in running.values():
                    steps[row] = stage.steps[row]
                waiting += running.values()
                running.clear()
                continue
            for lane in late:
                row = running[lane]
                steps[row] += results[lane][3]
                if steps[row] >= most:
                    stage.errors[row] = too_many_steps(stage.motions.problem(row), float(self.solver.time[lane]))
                    del running[lane]
            if arrived:
                carried[[running[lane] for lane in arrived]] = self.state.T[arrived]
            for lane in arrived:
                row = running.pop(lane)
                steps[row] += results[lane][3]
                modes[row], stage.turns[row], stage.counts[row] = self.modes[lane], self.turns[lane], self.counts[lane]
        stage.carried, stage.modes, stage.steps = carried, modes, steps
        self._check(stage, end)

    def _loads(self, stage: Stage, duration: float) -> tuple[FloatArray, FloatArray]:
        """What is carried at first and the parameters of every motion, a column each."""
        count = len(stage.modes)
        state, pars = np.zeros((len(self.state), count)), np.zeros((len(self.pars), count))
        state[: self.size] = stage.carried[:, : self.size].T
        both = np.hstack([stage.motions.constants, np.array(stage.modes, dtype=np.float64)])
        pars[: both.shape[1]] = both.T
        if self.watch:
            pars[-2], pars[-1] = stage.carried[:, 0], _scale(duration)
        return state, pars

    def _fill(
        self,
        stage: Stage,
        loads: tuple[FloatArray, FloatArray],
        waiting: list[int],
        running: dict[int, int],
        begin: float,
        end: float,
    ) -> None:
        """Put waiting motions into lanes that are free; what else is free stands still at the end, where another lane is."""
        self.strays, solver = {}, self.solver
        free = [lane for lane in range(LANES) if lane not in running] if running else list(range(LANES))
        lanes = free[: len(waiting)]
        rows = [waiting.pop() for _ in lanes]
        if len(lanes) == LANES:
            self.state[:], self.pars[:] = loads[0][:, rows], loads[1][:, rows]
            solver.set_time(begin)
            solver.reset_cooldowns()
        else:
            late, early = (part.copy() for part in solver.dtime)
            late[free], early[free], late[lanes] = end, 0.0, begin
            self.state[:, lanes], self.pars[:, lanes] = loads[0][:, rows], loads[1][:, rows]
            source, still = lanes[0] if lanes else next(iter(running)), free[len(lanes) :]
            self.state[:, still], self.pars[:, still] = self.state[:, [source]], self.pars[:, [source]]
            solver.set_dtime(late, early)
            for lane in free:
                solver.reset_cooldowns(lane)
        for lane, row in zip(lanes, rows, strict=True):
            running[lane] = row
            self.modes[lane] = stage.modes[row]
            if self.watch:
                self.turns[lane], self.counts[lane] = None, [0] * EVENTS

    def _stopped(self, lane: int, outcome: Any) -> ConvergenceError:
        import heyoka as hy

        t = self.strays.get(lane)
        if t is not None:
            return _missed(t)
        if outcome == hy.taylor_outcome.err_nf_state:
            return out_of_range()
        return ConvergenceError(f"heyoka stopped at t = {self.solver.time[lane]:.6g} with {outcome}; use backend='scipy'")

    def _check(self, stage: Stage, end: float) -> None:
        """Refuse motions that stand outside their modes."""
        rows = [row for row in range(len(stage.modes)) if row not in stage.errors]
        modes, constants = np.array([stage.modes[row] for row in rows]).T, stage.motions.constants[rows].T
        inside = stage.motions.field.are_inside(stage.carried[rows, : self.size].T, constants, modes) if rows else []
        for row, there in zip(rows, inside, strict=True):
            if not there:
                stage.errors[row] = _missed(end)


def _missed(t: float) -> ConvergenceError:
    return ConvergenceError(f"heyoka missed a kink before t = {t:.6g}; use backend='scipy'")


def _scale(duration: float) -> float:
    """What the integrals are multiplied by."""
    return 1e-3 / duration


_CACHE = threading.local()


def _compiled(motions: Motions, watch: bool) -> Lanes:
    """Compiled once per model, tolerance and thread."""
    known: dict[tuple[str, float, bool], Lanes] = _CACHE.__dict__.setdefault("compiled", {})
    key = motions.field.name, motions.rtol, watch
    if key not in known:
        known[key] = Lanes(motions.field, motions.constants.shape[1], motions.rtol, watch)
    return known[key]


def ends(motions: Motions) -> FloatArray:
    """States at ``t_end``; an error where one of them stops."""
    stage = Stage.of(motions)
    _compiled(motions, watch=False).carry(stage, 0.0, motions.t_end)
    for error in stage.errors.values():
        raise error
    return stage.carried


def watch(motions: Motions) -> Measured:
    """What follows ``t_record``, measured on the way: no continuous output, which would have to be kept."""
    stage = Stage.of(motions)
    if motions.t_record > 0:
        _compiled(motions, watch=False).carry(stage, 0.0, motions.t_record)
    first, begin, end = stage.carried, motions.t_record, motions.t_end
    _compiled(motions, watch=True).carry(stage, begin, end)
    size = first.shape[1]
    last, integrals = stage.carried[:, :size], stage.carried[:, size:] / _scale(end - begin)
    turns = [seen or _NONE for seen in stage.turns]
    reach = np.array([(seen.low, seen.high) for seen in turns]).T
    low, high = np.fmin(reach[0], np.fmin(first[:, 0], last[:, 0])), np.fmax(reach[1], np.fmax(first[:, 0], last[:, 0]))

    def course(row: int) -> Course:
        seen = turns[row]
        tops = np.array([[t, *carried] for t, carried in seen.tops]).reshape(-1, 1 + stage.carried.shape[1])
        lows = np.array([carried[:size] for _, carried in seen.lows]).reshape(-1, size)
        sums = np.vstack([tops[:, 1 + size :] / _scale(end - begin), integrals[row]])
        return Course(
            begin, end, first[row], last[row], tops[:, 0], tops[:, 1 : 1 + size], sums, lows, events[row],
            (float(low[row]), float(high[row])),
        )  # fmt: skip

    events, maxima = np.array(stage.counts), np.array([len(seen.tops) for seen in turns])
    return Measured(begin, end, first, last, integrals, low, high, maxima, events, course, stage.errors)
