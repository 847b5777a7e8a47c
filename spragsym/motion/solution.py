"""The result of an integrator: a motion by its samples, and its events."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..models.parameters import FloatArray
from .lobatto import PiecewisePolynomial
from .problem import Event, Problem, event_at


class Crossing(NamedTuple):
    """One event: when, the state there, and what it is."""

    t: float
    state: tuple[float, ...]
    kind: Event


@dataclass(frozen=True)
class Solution:
    """A motion as polynomials, and its k events: times, states of shape (k, 2 n), codes of :class:`Event`."""

    samples: PiecewisePolynomial
    event_t: FloatArray
    event_states: FloatArray
    event_kinds: NDArray[np.intp]
    #: Whether an implicit method carried it, as explicit steps collapsed.
    implicit: bool = False


def without_chatter(solution: Solution, problem: Problem) -> Solution:
    """Without crossings of a border after which the motion does not leave it by more than the error of a step.

    A motion that comes to rest on a border is on either side of it by that error, and passes it no further.
    """
    states, kept = solution.samples.states, np.ones(len(solution.event_t), dtype=bool)
    least = 10 * problem.rtol * float(np.abs(states).max())
    for border in problem.field.borders:
        kinds = [event_at(border, upward=upward) for upward in (False, True)]
        own = np.flatnonzero(np.isin(solution.event_kinds, [kind for kind in kinds if kind is not None]))
        if not len(own):
            continue
        level = np.asarray(border.level(states, problem.constants, problem.field.modes[0]))
        sure = np.flatnonzero(np.abs(level) > least)
        stretch = np.searchsorted(solution.event_t[own], solution.samples.t[sure])
        side = np.zeros(len(own) + 1)
        side[stretch] = np.sign(level[sure])
        before = side[0] or (-1.0 if solution.event_kinds[own[0]] == kinds[1] else 1.0)
        for place, after in zip(own, side[1:], strict=True):
            kept[place] = after != 0 and after != before
            before = after or before
    return replace(
        solution, event_t=solution.event_t[kept], event_states=solution.event_states[kept], event_kinds=solution.event_kinds[kept]
    )


def assembled(t: FloatArray, states: FloatArray, crossings: list[Crossing], t_record: float) -> Solution:
    """From samples by steps, shapes (steps, DEGREE + 1) and (steps, 2 n, DEGREE + 1), to samples in a row."""
    size = states.shape[1]
    kept = [crossing for crossing in crossings if crossing.t >= t_record]
    return Solution(
        PiecewisePolynomial(
            np.append(t[:, :-1].ravel(), t[-1, -1]),
            np.append(states[:, :, :-1].swapaxes(0, 1).reshape(size, -1), states[-1, :, -1:], axis=1),
        ),
        np.array([crossing.t for crossing in kept]),
        np.array([crossing.state for crossing in kept]).reshape(-1, size),
        np.array([crossing.kind for crossing in kept], dtype=np.intp),
    )
