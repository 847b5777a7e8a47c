"""From one branch of cycles to another, where they meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..parameters import FloatArray
from .arclength import Setting, phase_row
from .flows import carrier
from .orbit import Cycle, cycle_of
from .shooting import Guess, Loop, divided, looped, rate, solved

if TYPE_CHECKING:
    from .branch import CycleBranch, CycleEvent

#: First steps off a branch, in states.
STEPS = (0.02, 0.005, 0.05, 0.0015, 0.12)


def switched(branch: CycleBranch, event: CycleEvent, step: float) -> Cycle:
    """As :meth:`CycleBranch.switch` says."""
    if event.kind not in ("period_doubling", "fold", "torus"):
        raise ParameterError(f"no other branch of cycles begins at a {event.kind}; give a period doubling")
    if event.kind != "period_doubling" or event.loop is None:
        raise ParameterError(f"a {event.kind} starts no branch of cycles that this function follows; give a period doubling")
    cycle = event.cycle
    fly, backend = carrier(cycle.field, cycle.backend)
    index = cycle.field.parameters.index(branch.vary)
    setting = Setting(cycle.field, fly, (index,), cycle.period, ((branch.to[1] - branch.to[0]) / 2,))
    doubled, direction = _doubled(setting, cycle.loop)
    for size in (step, *STEPS):
        for sign in (1.0, -1.0):
            try:
                loop = _off(setting, doubled, sign * size * direction, size)
            except ConvergenceError:
                continue
            found = cycle_of(loop, fly, backend)
            if found.period > 1.5 * cycle.period:
                return found
    raise ConvergenceError(f"no doubled cycle was found near {branch.vary} = {event.value:.10g}")


def _doubled(setting: Setting, loop: Loop) -> tuple[Guess, FloatArray]:
    """Twice round, and the direction that turns over in one round: of unit size in the first state."""
    pieces, size = 2 * len(loop.guess.states), setting.field.size
    guess = divided(setting.field, setting.fly, Guess(loop.guess.states[:1], 2 * loop.guess.period, loop.guess.values), pieces)
    values, vectors = np.linalg.eig(loop.monodromy)
    turning = vectors[:, int(np.argmin(np.abs(values + 1)))].real
    flow = rate(setting.field, guess.states[0], loop.constants)
    turning = turning - flow * (flow @ turning) / (flow @ flow)
    turning = turning / np.linalg.norm(turning)
    twice = looped(setting.field, setting.fly, guess, setting.free)
    parts = [turning]
    for passage in twice.passages[:-1]:
        parts.append(passage.by_state @ parts[-1])
    direction = np.zeros(pieces * size + 2)
    direction[: pieces * size] = np.concatenate(parts)
    return guess, direction


def _off(setting: Setting, guess: Guess, step: FloatArray, size: float) -> Loop:
    """The closed orbit whose first state is off by ``size`` in the direction that turns over, wherever the parameter is."""
    begun = guess.moved(step, setting.free)
    target = begun.coordinates(setting.free)
    middle = looped(setting.field, setting.fly, guess, setting.free)
    across = np.zeros((1, len(step)))
    across[0, : setting.field.size] = step[: setting.field.size] / size
    rows = np.vstack([phase_row(setting, middle), across])

    def conditions(loop: Loop) -> tuple[FloatArray, FloatArray]:
        return rows @ (loop.guess.coordinates(setting.free) - target), rows

    return solved(setting.field, setting.fly, begun, conditions, setting.free, reach=20 * size)
