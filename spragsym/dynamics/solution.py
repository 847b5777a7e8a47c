"""The result of an integrator: a motion by its samples, and its events."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..parameters import FloatArray
from .lobatto import PiecewisePolynomial
from .problem import Event


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
