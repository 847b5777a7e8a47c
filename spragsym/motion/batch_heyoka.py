"""Batch integration by heyoka's Taylor method: many motions at a time, one in each lane of vector instructions.

A lane takes its own steps, meets its own borders, and does the same arithmetic whatever runs beside it, so that the bits of a
motion depend on the motion alone. One that breaks off stops the others: these are begun again without it, since nothing says what
its last step has done to them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import Field, Mode
from ..models.parameters import FloatArray
from .measures import Course, Turns
from .problem import Event, Problem, StiffError, kinds_of, out_of_range
from .with_heyoka import Carrier, compiled, missed

#: Motions in flight. Another number compiles other code, and may give other last bits.
LANES = 8

#: Steps between two looks at signals, for Python hears Ctrl-C only then, and at whether steps have collapsed.
BURST = 20_000

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


class Lanes(Carrier):
    """A compiled integrator of :data:`LANES` motions, used again and again.

    With ``watch`` it also carries the integrals of a :class:`~spragsym.motion.measures.Course`, and notes where x' = 0.
    """

    def __init__(self, field: Field, rtol: float, watch: bool) -> None:
        super().__init__(field, rtol, lanes=LANES, watch=watch)
        self.watch, self.kinds = watch, kinds_of(field)
        self.turns: list[Turns | None] = [None] * LANES
        self.counts = [[0] * EVENTS for _ in range(LANES)]
        #: Where borders were last crossed, and lanes in which that was where they had been crossed before.
        self.crossed: list[dict[int, list[float]]] = [{} for _ in range(LANES)]
        self.resting: set[int] = set()
        self.dense, self.look = self.solver.d_output, self.solver.update_d_output

    def _crossed(self, row: int, lane: int, _: FloatArray) -> None:
        kind = self.kinds.get((row, self.field.borders[row].sign(self.modes[lane])))
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

    def _turn(self, border: int, _: Any, t: float, direction: int, lane: int) -> None:
        self.look(t)
        seen = self.turns[lane]
        if seen is None:
            self.turns[lane] = seen = Turns()
        seen.add(t, direction, self.dense[:, lane].tolist())

    def carry(self, stage: Stage, begin: float, end: float) -> Stage:
        """Where the motions of a stage are that are carried from ``begin`` to ``end`` and do not stop on the way."""
        count = len(stage.modes)
        watching = [stage.carried[:, :1], np.full((count, 1), _scale(end - begin))] if self.watch else []
        pars = np.hstack([stage.constants, np.array(stage.modes, dtype=float).reshape(count, -1), *watching])
        after = replace(
            stage, carried=np.full((count, len(self.state)), np.nan), modes=stage.modes.copy(), steps=stage.steps.copy(),
            turns=[None] * count, counts=[[0] * EVENTS] * count,
        )  # fmt: skip
        left = [row for row in range(count) if row not in stage.errors]
        while left:
            rows, left = left[:LANES], left[LANES:]
            self._begin(stage, pars, rows, begin, end)
            if not self._arrived(after, rows, end):
                left = [row for row in rows if row not in stage.errors] + left
        states, modes = after.carried[:, : self.m].T, np.array(after.modes).T
        for row in np.flatnonzero(~self.field.are_inside(states, stage.constants.T, modes)).tolist():
            stage.errors.setdefault(row, missed(end) if np.isfinite(states[:, row]).all() else out_of_range())
        return after

    def _begin(self, stage: Stage, pars: FloatArray, rows: list[int], begin: float, end: float) -> None:
        """Put motions into lanes; what else is free stands still at the end, where the first lane is."""
        filled = [*rows, *rows[:1] * (LANES - len(rows))]
        self.state[:], self.pars[:] = 0.0, pars[filled, : len(self.pars)].T
        self.state[: self.m] = stage.carried[filled, : self.m].T
        self.solver.set_dtime(np.where(np.arange(LANES) < len(rows), begin, end), np.zeros(LANES))
        if self.eventful:
            self.solver.reset_cooldowns()
        self.modes, self.turns = [stage.modes[row] for row in filled], [None] * LANES
        self.counts, self.crossed = [[0] * EVENTS for _ in filled], [{} for _ in filled]
        self.resting.clear()
        self.strays.clear()

    def _arrived(self, after: Stage, rows: list[int], end: float) -> bool:
        """Go on to the end; whether all are there: where one breaks off the others begin again."""
        steps = [after.steps[row] for row in rows]
        while self.times.min() < end:
            begun, (late, early) = self.times.tolist(), self.solver.dtime
            self.solver.set_dtime(late.copy(), np.where(late == end, 0.0, early))  # who has ended does not move by rounding
            self.solver.propagate_until(end, max_steps=BURST)
            for lane, row in enumerate(rows):
                one = after.problems[row]
                try:
                    steps[lane] = self._counted(lane, begun[lane], steps[lane], one.max_steps, one.t_end, one.constants)
                except ConvergenceError as error:
                    after.errors[row] = error
            if not after.errors.keys().isdisjoint(rows):
                return False
        for lane, row in enumerate(rows):
            after.carried[row], after.modes[row], after.steps[row] = self.state[:, lane], self.modes[lane], steps[lane]
            if self.watch:
                after.turns[row], after.counts[row] = self.turns[lane], self.counts[lane]
                for border in list(self.crossed[lane]):
                    self._rest(lane, border)
                if lane in self.resting:
                    after.resting.add(row)
        return True


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
