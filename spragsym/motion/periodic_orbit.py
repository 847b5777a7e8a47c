"""The periodic orbit near a motion, with the derivative of its return map: Newton's method on the flow and its derivatives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import ConvergenceError
from ..models.field import Field
from ..models.parameters import FloatArray
from .segment import Fly
from .shooting import Guess, Loop, once_round, rate, solved, through


@dataclass(frozen=True)
class Closed:
    """A closed orbit by its state (2 n,) on a section, all over which the number at the place ``fixed`` has one value.

    The ``slope``, (2 n − 1, 2 n − 1), is the derivative of the return in the other numbers; its eigenvalues are the multipliers.
    """

    state: FloatArray
    period: float
    slope: FloatArray
    fixed: int


def section(states: FloatArray, fixed: int) -> FloatArray:
    """States of a section without the number that is ``fixed`` there: x, y, y' for two coordinates where x' = 0."""
    kept: FloatArray = np.delete(states, fixed, axis=-1)
    return kept


def closed_orbit(field: Field, fly: Fly, state: FloatArray, fixed: int, period: float, reach: float, closed: float) -> Closed:
    """The closed orbit of about a period near a state of a section; ConvergenceError where there is none within ``reach``."""
    try:
        loop = nearly_closed(field, fly, state, fixed, period, reach, closed, iterations=12)
    except (OverflowError, ValueError) as error:
        raise ConvergenceError("Newton's method left the range of numbers") from error
    loop = once_round(loop, fly)
    place = loop.guess.states[0]
    flow = rate(field, place, loop.constants)
    if flow[fixed] == 0:
        raise ConvergenceError("the orbit does not pass through the section")
    back = np.eye(field.size)
    back[:, fixed] -= flow / flow[fixed]  # along the flow to the section again
    slope = section(section(back @ loop.monodromy, fixed).T, fixed).T
    return Closed(place, loop.guess.period, slope, fixed)


def nearly_closed(
    field: Field, fly: Fly, state: FloatArray, fixed: int, period: float, reach: float, precision: float, *, iterations: int = 9
) -> Loop:  # fmt: skip
    """The loop to a precision that begins on the section of a state."""

    on_section = through(state, np.eye(state.size)[fixed], state.size + 1)
    guess = Guess(state[None], period, ())
    return solved(field, fly, guess, on_section, reach=reach, iterations=iterations, precision=precision, closed=precision)
