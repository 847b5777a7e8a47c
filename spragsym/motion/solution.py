"""The result of an integrator: a motion by its samples, and the borders that it passed."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..models.field import GAP
from ..models.parameters import FloatArray
from .lobatto import PiecewisePolynomial
from .problem import Problem
from .segment import Crossing


@dataclass(frozen=True)
class Solution:
    """A motion as polynomials, and its crossings of kinks; whether an implicit method carried it, as explicit steps collapsed."""

    samples: PiecewisePolynomial
    crossings: tuple[Crossing, ...]
    implicit: bool = False


def without_chatter(solution: Solution, problem: Problem) -> Solution:
    """Without crossings of a border after which the motion does not leave it by more than the error of a step.

    A motion that comes to rest on a border is on either side of it by that error, and passes it no further.
    """
    t, states, chatter = solution.samples.t, solution.samples.states, set[int]()
    least = max(10 * problem.rtol * float(max(states.max(), -states.min())), 2 * GAP)
    for row, border in enumerate(problem.field.borders):
        own = [crossing for crossing in solution.crossings if crossing.border == row]
        if not own or not border.crossings[0]:
            continue
        level = np.asarray(border.level(states, problem.constants, problem.field.modes[0]))
        stretches = [0, *np.searchsorted(t, [crossing.t for crossing in own])]
        highest, lowest = (part.reduceat(level, stretches) for part in (np.maximum, np.minimum))
        side = np.where(highest > least, 1, np.where(lowest < -least, -1, 0)).tolist()
        before = side[0] or -own[0].sign
        for crossing, after in zip(own, side[1:], strict=True):
            if after in (0, before):
                chatter.add(id(crossing))
            before = after or before
    return replace(solution, crossings=tuple(each for each in solution.crossings if id(each) not in chatter))


def assembled(t: FloatArray, states: FloatArray, crossings: Sequence[Crossing], t_record: float = 0.0) -> Solution:
    """From samples by steps, shapes (steps, DEGREE + 1) and (steps, 2 n, DEGREE + 1), to samples in a row."""
    samples = PiecewisePolynomial(
        np.append(t[:, :-1].ravel(), t[-1, -1]),
        np.append(states[:, :, :-1].swapaxes(0, 1).reshape(states.shape[1], -1), states[-1, :, -1:], axis=1),
    )
    if t_record > t[0, 0]:
        samples = samples.after(t_record)
    return Solution(samples, tuple(crossing for crossing in crossings if crossing.t >= t_record))
