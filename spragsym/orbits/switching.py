"""Where branches of cycles meet: from one to another, and the end of a branch of doubled cycles, whose halves become one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..models.parameters import POSITIVE, FloatArray, as_number
from ..motion.multipliers import unsure
from ..motion.shooting import CLOSED, Guess, Loop, across, extent, rate, recut, solved
from .arclength import SURE, Point, Setting, at_zero, corrected, fixed, point_of
from .events import MERGES
from .orbit import Cycle, cycle_of

if TYPE_CHECKING:
    from .branch import CycleBranch, CycleEvent

#: First steps off a branch, in states.
STEPS = (0.02, 0.005, 0.05, 0.0015, 0.12, 4e-4, 1e-4, 2e-5)

#: The halves of a step's orbits come together if they pass each other within this share of how far they move.
NEAR = 0.5

#: Halves farther apart than this share of the orbit's extent are two.
SMALL = 0.3

#: Halves that come closer than this share are one, and those that are this close from the beginning: an orbit twice round.
NEAREST, ONE = 1e-3, 1e-9


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


def in_halves(loop: Loop, setting: Setting) -> Loop:
    """The loop in an even number of stretches."""
    pieces = len(loop.states)
    if pieces % 2 == 0:
        return loop
    return setting.looped(recut(loop, 2 * pieces))


def parted(point: Point) -> FloatArray:
    """How far apart the two halves of a round are: states less those half a round before, across the flow, over √their number."""
    states, half = point.loop.states, len(point.loop.states) // 2
    apart = states[half:] - states[:half]
    flows = np.array([rate(point.loop.field, state, point.loop.constants) for state in states[:half]])
    along = (flows * apart).sum(axis=1) / (flows * flows).sum(axis=1)
    return np.asarray((apart - along[:, None] * flows).ravel() / np.sqrt(half), dtype=float)


def meets(one: Point, other: Point) -> float | None:
    """The share of the step from one point to the next at which their halves come together; None if they do not."""
    if len(one.loop.states) != len(other.loop.states):
        return None
    before, after = parted(one), parted(other)
    way = after - before
    length = float(np.linalg.norm(way))
    now, was, size = float(np.linalg.norm(after)), float(np.linalg.norm(before)), extent(other.loop)
    if now > SMALL * size or not length > 0 or not was > ONE:
        return None
    if now < min(was, NEAREST * size):
        return 1.0
    share = -float(before @ way) / length**2
    return share if 0 < share < 1 and float(np.linalg.norm(before + share * way)) < NEAR * length else None


def between_halves(one: Point, other: Point, share: float) -> tuple[Guess, float]:
    """The cycle of half the period at a share of a step, near which to look for its doubling, and how far off that may be."""
    a, b = one.loop.guess, other.loop.guess
    states, half = (1 - share) * a.states + share * b.states, len(a.states) // 2
    guess = Guess((states[:half] + states[half:]) / 2, ((1 - share) * a.period + share * b.period) / 2, a.values)
    reach = (float(np.linalg.norm(states[:half] - states[half:])) + float(np.linalg.norm(b.states - a.states))) / np.sqrt(half)
    return guess.at(one.setting.free[0], one.value + share * (other.value - one.value)), reach


def halved(setting: Setting, begun: Guess, reach: float) -> tuple[Loop, float] | None:
    """The doubling of the cycle of half the period near a guess, and the error of its parameter.

    None if there is none whose states are within ``reach``: then the halves have only come near each other.
    """
    kind = "period_doubling"
    try:
        near = fixed(setting, setting.looped(begun))
        doubling = at_zero(kind, setting, near, near.guess.coordinates(setting.free))
        loop = solved(setting.flow, near.guess, doubling, setting.free)
    except (ConvergenceError, np.linalg.LinAlgError):
        return None
    if not float(np.linalg.norm(loop.states - begun.states)) / np.sqrt(len(begun.states)) < reach:
        return None
    there = point_of(setting, loop)
    steepness = float(doubling(loop)[1][-1] @ there.tangent) * max(1.0, SURE * unsure(near, kind) / CLOSED)
    return loop, unsure(loop, kind) * abs(float(there.tangent[-1]) / steepness) + 1e-15 * (1 + abs(there.value))
