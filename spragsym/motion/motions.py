"""Many motions of one model, and what was measured of each: what :class:`Problem` and :class:`Course` are of one."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..models.field import Field
from ..models.parameters import FloatArray
from .measures import KEPT, Course, moments_of
from .problem import Event, Problem, reach_of


@dataclass(frozen=True)
class Motions:
    """Motions that share all but their constants (N, C) and initial states (N, 2 n)."""

    constants: FloatArray
    starts: FloatArray
    t_end: float
    t_record: float
    rtol: float
    max_steps: int
    field_of: Callable[[float], Field]

    def __len__(self) -> int:
        return len(self.starts)

    @classmethod
    def of(cls, problems: Sequence[Problem]) -> Motions:
        """Common data of problems that share all but constants and starts."""
        one = problems[0]
        return cls(
            np.array([problem.constants for problem in problems], dtype=np.float64),
            np.array([problem.start for problem in problems], dtype=np.float64),
            one.t_end, one.t_record, one.rtol, one.max_steps, one.field_of,
        )  # fmt: skip

    def problem(self, row: int) -> Problem:
        """One of them."""
        return Problem(
            tuple(self.constants[row].tolist()), tuple(self.starts[row].tolist()), self.t_end, self.t_record, self.rtol,
            self.max_steps, self.field_of,
        )  # fmt: skip

    @cached_property
    def field(self) -> Field:
        """The field of all."""
        return self.field_of(reach_of(self.rtol))


class Turns:
    """Where x' = 0 on the way of one motion: the latest, and the range of x over all."""

    def __init__(self) -> None:
        self.low, self.high = np.inf, -np.inf
        #: Time and all that is carried.
        self.tops: deque[tuple[float, list[float]]] = deque(maxlen=KEPT)
        self.lows: deque[tuple[float, list[float]]] = deque(maxlen=KEPT)

    def add(self, t: float, direction: int, carried: list[float]) -> None:
        """Note one; ``direction`` is negative where x is largest."""
        if direction < 0:
            self.tops.append((t, carried))
            self.high = max(self.high, carried[0])
        else:
            self.lows.append((t, carried))
            self.low = min(self.low, carried[0])


@dataclass(frozen=True)
class Measured:
    """Columns of :class:`Course` of many motions, a row each, NaN for those that stopped, of which ``errors`` says why.

    The ``integrals`` are those to the end, ``low`` and ``high`` the reach, ``maxima`` how many are kept.
    """

    begin: float
    end: float
    first: FloatArray
    last: FloatArray
    integrals: FloatArray
    low: FloatArray
    high: FloatArray
    maxima: NDArray[np.intp]
    events: NDArray[np.intp]
    course: Callable[[int], Course]
    errors: dict[int, Exception] = field(default_factory=dict)
    #: Courses that were measured from samples.
    sampled: dict[int, Course] = field(default_factory=dict)

    @classmethod
    def none(cls, motions: Motions) -> Measured:
        """Nothing yet."""
        count, size = motions.starts.shape
        first, last, integrals, reach = (np.full((count, width), np.nan) for width in (size, size, size // 2 + 1, 2))
        events, maxima = np.zeros((count, len(Event)), dtype=np.intp), np.zeros(count, dtype=np.intp)
        sampled: dict[int, Course] = {}
        return cls(
            motions.t_record, motions.t_end, first, last, integrals, reach[:, 0], reach[:, 1], maxima, events,
            sampled.__getitem__, sampled=sampled,
        )  # fmt: skip

    def put(self, row: int, course: Course) -> None:
        """Take one that was measured from its samples."""
        self.errors.pop(row, None)
        self.sampled[row] = course
        self.first[row], self.last[row], self.integrals[row] = course.first, course.last, course.integrals[-1]
        self.low[row], self.high[row] = course.reach
        self.events[row], self.maxima[row] = course.events, len(course.maxima)

    @property
    def averages(self) -> FloatArray:
        """Mean of x, root mean square about it, and means of the other coordinates: shape (n + 1, N)."""
        shift, square, *others = self.integrals.T / (self.end - self.begin)
        return np.array([*moments_of(self.first[:, 0], shift, square), *others])
