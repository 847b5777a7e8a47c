"""A segment of motion as an integrator gives it: its end, the derivatives of that, and the events on the way."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from ..models.field import Field, Mode
from ..models.parameters import FloatArray


class Crossing(NamedTuple):
    """A border passed: when, which, to which sign of its level, and the state there."""

    t: float
    border: int
    sign: int
    state: FloatArray


def crossed(field: Field, border: int, mode: Mode, t: float, state: FloatArray) -> tuple[Crossing, ...]:
    """The crossing of a border into a mode; none where there is no kink."""
    passed = field.borders[border]
    return (Crossing(t, border, int(passed.sign(mode)), state.copy()),) if passed.kink else ()


class Turn(NamedTuple):
    """A zero of a rate: of a border's level, which is extremal there, or (border −1) of the first coordinate.

    ``direction`` is the sign of the rate's own rate: −1 at a largest value.
    """

    t: float
    border: int
    direction: int
    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray


def parted(state: FloatArray, columns: FloatArray | None) -> tuple[FloatArray, FloatArray, FloatArray]:
    """A state and its derivatives by the start and by the parameters, 0 where there are no columns for these; empty for none."""
    if columns is None:
        return state.copy(), np.empty((0, 0)), np.empty((0, 0))
    m = len(state)
    whole = np.zeros((m, m + 2))
    whole[:, : columns.shape[1]] = columns
    return state.copy(), whole[:, :m], whole[:, m:]


@dataclass(frozen=True)
class Passage:
    """A stretch of motion: where it ends, (m,), and derivatives of that.

    Those by the state at the start, (m, m), are the product over the smooth pieces, as the field is continuous; those by the
    parameters, (m, 2), are along two directions. The ``integrals`` of the first coordinate and of its square over time are there
    where the integrator carries them along.
    """

    state: FloatArray
    by_state: FloatArray
    by_parameters: FloatArray
    crossings: tuple[Crossing, ...]
    turns: tuple[Turn, ...]
    integrals: tuple[float, float] | None = None


#: Carries a state on: ``fly(state, constants, duration, directions)``, directions of shape (2, P).
Fly: TypeAlias = Callable[[FloatArray, tuple[float, ...], float, FloatArray], Passage]
