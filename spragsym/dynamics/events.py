"""Where a motion passed a kink of its field."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..parameters import FloatArray
from .problem import Event


@dataclass(frozen=True, eq=False)
class Events(Result):
    """Where the motion passed a kink of the field, in order of time.

    Attributes
    ----------
    t : ndarray, shape (k,)
        Time.
    state : ndarray, shape (k, 2 n)
        Coordinates and rates there: y = 0 or x' = V to 1e-12.
    which : ndarray of int, shape (k,)
        Codes of :class:`Event`.
    """

    t: FloatArray
    state: FloatArray
    which: NDArray[np.intp]

    def __len__(self) -> int:
        return len(self.t)

    def of(self, *kinds: Event) -> Events:
        """The events of some kinds only."""
        chosen = np.isin(self.which, kinds)
        return Events(self.t[chosen], self.state[chosen], self.which[chosen])
