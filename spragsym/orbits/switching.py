"""From one branch of cycles to another, where they meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..models.parameters import POSITIVE, FloatArray, as_number
from ..motion.shooting import Guess, Loop, across, rate
from .arclength import Point, Setting, corrected
from .inspection import MERGES
from .orbit import Cycle, cycle_of

if TYPE_CHECKING:
    from .branch import CycleBranch, CycleEvent

#: First steps off a branch, in states.
STEPS = (0.02, 0.005, 0.05, 0.0015, 0.12, 4e-4, 1e-4, 2e-5)


def switched(branch: CycleBranch, event: CycleEvent, step: float) -> Cycle:
    """The cycle of :meth:`CycleBranch.switch`."""
    cycle = event.cycle
    if not any(event is each for each in branch.events):
        raise ParameterError(f"event = a {event.kind} at {event.value:.10g} is none of this branch's; give one of branch.events")
    step = as_number("step", step, POSITIVE)
    if event.loop is None or not (event.kind in ("period_doubling", "fold") or event.how == MERGES):
        raise ParameterError(
            f"no other branch of cycles begins at a {event.kind}{f' where {event.how}' if event.how else ''}; give a period "
            "doubling, a fold, or an end where two branches meet"
        )
    if event.how == MERGES:
        return cycle  # the event holds the cycle of half the period
    index = cycle.field.parameters.index(branch.vary)
    setting = Setting(event.loop.flow, (index,), cycle.period, ((branch.to[1] - branch.to[0]) / 2,))
    if event.kind == "fold" and event.crossed is None:
        return _beyond(branch, event, step)
    twice = event.kind == "period_doubling"
    guess, direction = _doubled(setting, cycle.loop) if twice else _across(setting, event)
    point = Point(setting, setting.looped(guess), direction)
    for size in (step, *STEPS):
        for sign in (1.0, -1.0):
            try:
                loop = corrected(point, sign * size, reach=20 * size, iterations=12).loop
            except ConvergenceError:
                continue
            found = cycle_of(loop)
            if not twice or 1.5 < found.period / cycle.period < 2.5:
                return found
    raise ConvergenceError(
        f"no cycle of the other branch was found near {branch.vary} = {event.value:.10g}, by steps from {max(step, *STEPS):g} "
        f"down to {min(step, *STEPS):g}"
    )


def _across(setting: Setting, event: CycleEvent) -> tuple[Guess, FloatArray]:
    """Where two branches cross there are two directions: the one across that of the branch, of unit size in the first state."""
    assert event.loop is not None
    loop = setting.looped(event.loop.guess)
    weights = setting.weights(len(loop.states))
    _, phase = across(loop, parameters=1)(loop)
    matrix = np.vstack([loop.slopes(1), phase]) / weights
    _, _, vectors = np.linalg.svd(matrix)
    along = np.asarray(event.crossed) * weights
    along = along / np.linalg.norm(along)
    plane = vectors[-2:] - np.outer(vectors[-2:] @ along, along)
    direction = max(plane, key=lambda vector: float(np.linalg.norm(vector))) / weights
    return loop.guess, direction / np.linalg.norm(direction[: setting.field.size])


def _beyond(branch: CycleBranch, event: CycleEvent, step: float) -> Cycle:
    """The first cycle of the branch behind a fold that is a step off, or the last one."""
    (place,) = (place for each, place in zip(branch.events, branch.places, strict=True) if each is event)
    for i in range(place, len(branch.cycles)):
        found: Cycle = branch.cycles[i]
        if np.abs(found.state - event.cycle.state).max() >= step:
            break
    return found


def _doubled(setting: Setting, loop: Loop) -> tuple[Guess, FloatArray]:
    """Twice round, and the direction that turns over in one round: of unit size in the first state."""
    guess = Guess(np.vstack([loop.states] * 2), 2 * loop.period, loop.values)
    values, vectors = np.linalg.eig(loop.monodromy)
    turning = vectors[:, int(np.argmin(np.abs(values + 1)))].real
    flow = rate(setting.field, guess.states[0], loop.constants)
    turning = turning - flow * (flow @ turning) / (flow @ flow)
    turning = turning / np.linalg.norm(turning)
    twice = setting.looped(guess)
    parts = [turning]
    for passage in twice.passages[:-1]:
        parts.append(passage.by_state @ parts[-1])
    return guess, np.concatenate([*parts, np.zeros(2)])
