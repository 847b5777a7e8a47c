"""Branch switching: from a branch of cycles to another one that meets it; and the end of a branch
of doubled cycles, at the period doubling where it was born.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..core.errors import ConvergenceError, ParameterError
from ..models.parameters import POSITIVE, FloatArray, as_number
from ..motion.multipliers import unsure
from ..motion.shooting import Iterate, Orbit, closed_orbit, extent
from ..numerics.vectors import magnitude, norm
from .arclength import (
    BranchPoint,
    Setting,
    at_zero,
    corrected,
    directions,
    fixed,
    point_of,
    resolution,
    turning,
)
from .events import BRANCH_POINT, MERGES
from .orbit import Cycle, cycle_of

if TYPE_CHECKING:
    from .branch import CycleBranch, CycleEvent


def switched(branch: CycleBranch, event: CycleEvent, step: float) -> Cycle:
    """Compute a cycle on the other branch at an event: see :meth:`CycleBranch.switch`."""
    cycle = event.cycle
    if event not in branch.events:
        raise ParameterError(
            f"event = a {event.kind} at {event.value:.10g} is none of this branch's; give one "
            "of branch.events"
        )
    step = as_number("step", step, POSITIVE)
    if not (event.kind in ("period_doubling", "fold", BRANCH_POINT) or event.how == MERGES):
        raise ParameterError(
            "no other branch of cycles begins at a "
            f"{event.kind}{f' where {event.how}' if event.how else ''}; give a period "
            "doubling, a fold, a branch point, or an end where two branches meet"
        )
    if event.how == MERGES:
        return cycle  # the event holds the cycle of half the period
    index = cycle.field.parameters.index(branch.vary)
    orbit, crossed = event.found.orbit, event.found.crossed
    setting = Setting(
        orbit.flow, (index,), cycle.period / orbit.field.time, ((branch.to[1] - branch.to[0]) / 2,)
    )
    if event.kind == "fold":
        return _beyond(branch, event, step)
    rounds = 2 if event.kind == "period_doubling" else 1
    point = _other_direction(point_of(setting, setting.integrated(orbit.guess)), crossed, rounds)
    # Steps to try, in states.
    steps = (0.02, 0.005, 0.05, 0.0015, 0.12, 4e-4, 1e-4, 2e-5)
    for size in (step, *steps):
        for sign in (1.0, -1.0):
            try:
                switched = corrected(point, sign * size, reach=20 * size, iterations=12)
            except ConvergenceError:
                continue
            found = cycle_of(switched.orbit)
            if rounds - 0.5 < found.period / cycle.period < rounds + 0.5:
                return found
    raise ConvergenceError(
        f"no cycle of the other branch was found near {branch.vary} = {event.value:.10g}, by "
        f"steps from {max(step, *steps):g} "
        f"down to {min(step, *steps):g}"
    )


def _other_direction(point: BranchPoint, crossed: FloatArray | None, rounds: int) -> BranchPoint:
    """The branching point, repeated for a number of rounds, with the direction of the other branch.

    There the Jacobian has a two-dimensional null space. The direction is that in the null space
    orthogonal to the known branch, normalized to 1 in the first state; to 10 in arclength, if the
    other branch hardly changes that state. ``crossed`` is the known branch's direction, None for
    the tangent of ``point``.
    """
    setting, guess = point.setting, point.orbit.guess
    orbit = setting.integrated(
        Iterate(np.vstack([guess.states] * rounds), rounds * guess.period, guess.values)
    )
    unknowns = point.tangent if crossed is None else crossed
    size = guess.states.size
    weights = setting.weights(orbit)
    repeated = [*[unknowns[:size]] * rounds, rounds * unknowns[size : size + 1]]
    known = np.concatenate([*repeated, unknowns[size + 1 :]]) * weights
    known = known / norm(known)
    plane = directions(setting, orbit)[1][-2:]
    plane = plane - np.outer(plane @ known, known)
    across = max(plane, key=norm)
    direction = across / weights
    unit = max(norm(direction[: orbit.field.size]), 0.1 * norm(across))
    return BranchPoint(setting, orbit, direction / unit)


def _beyond(branch: CycleBranch, event: CycleEvent, step: float) -> Cycle:
    """The first cycle of the branch behind a fold whose distance is ``step``, else the last one."""
    for i in range(branch.places[branch.events.index(event)], len(branch.cycles)):
        found: Cycle = branch.cycles[i]
        if magnitude(found.state - event.cycle.state) >= step:
            break
    return found


def parted(point: BranchPoint) -> FloatArray:
    """Difference between the two halves of an orbit: states minus those half a period before,
    without the component along the flow, over √(their number).
    """
    states, half = point.orbit.states, len(point.orbit.states) // 2
    difference = states[half:] - states[:half]
    flows = np.array([point.orbit.rate(state) for state in states[:half]])
    along = (flows * difference).sum(axis=1) / (flows * flows).sum(axis=1)
    return (difference - along[:, None] * flows).ravel() / np.sqrt(half)


def meets(one: BranchPoint, other: BranchPoint) -> float | None:
    """The share of the step from one point to the next at which the two halves of the orbit
    coincide; None if they do not.
    """
    if len(one.orbit.states) != len(other.orbit.states):
        return None
    before, after = parted(one), parted(other)
    was, now = norm(before), norm(after)
    if not was > 1e-9:  # the same orbit twice
        return None
    if now < min(was, one.setting.options.meeting * extent(other.orbit)):
        return 1.0
    return was / (was + now) if before @ after < 0 else None


def halved(one: BranchPoint, other: BranchPoint, share: float) -> tuple[Orbit, float] | None:
    """The period doubling of the cycle of half the period, near a share of a step, and the error of
    the parameter.

    None if there is none between the states of the step: then the halves only pass near each other.
    """
    kind, setting, a, b = "period_doubling", one.setting, one.orbit.guess, other.orbit.guess
    states, half = (1 - share) * a.states + share * b.states, len(a.states) // 2
    guess = Iterate(
        (states[:half] + states[half:]) / 2,
        ((1 - share) * a.period + share * b.period) / 2,
        a.values,
    )
    guess = guess.at(setting.free[0], one.value + share * (other.value - one.value))
    try:
        near = fixed(setting, setting.integrated(guess))
        doubling = at_zero(kind, setting, near, near.guess.coordinates)
        orbit = closed_orbit(setting.flow, near.guess, doubling)
    except (ConvergenceError, np.linalg.LinAlgError):
        return None
    reach = norm(states[:half] - states[half:]) + norm(b.states - a.states)
    if not norm(orbit.states - guess.states) < reach:
        return None
    point = point_of(setting, orbit)
    steepness = float(doubling(orbit)[1][-1] @ point.tangent) * resolution(near, kind)
    error = unsure(orbit, kind) * abs(turning(point) / steepness)
    return orbit, error + 1e-15 * (1 + abs(point.value))
