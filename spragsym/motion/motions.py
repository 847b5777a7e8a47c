"""Many motions of one model: what :class:`Problem` is of one."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..models.field import Field
from ..models.parameters import FloatArray
from .measures import KEPT
from .problem import Problem, reach_of


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
