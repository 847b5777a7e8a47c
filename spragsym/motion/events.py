"""Events of a motion: crossings of kinks of its field."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar

import numpy as np

from ..models.field import Field
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray, IndexArray
from ..results.result import Result
from .problem import Event, kinds_of
from .segment import Crossing


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
    components : tuple of str
        Names of the coordinates and rates.
    """

    table_codes: ClassVar[Mapping[str, type[Event]]] = {"which": Event}

    t: FloatArray
    state: FloatArray
    which: IndexArray
    components: tuple[str, ...] = field(repr=False)

    def __len__(self) -> int:
        return len(self.t)

    def of(self, *kinds: Event) -> Events:
        """The events of some kinds only."""
        return self.select(np.isin(self.which, kinds))

    def select(self, chosen: BoolArray) -> Events:
        """The events that are marked."""
        return replace(self, t=self.t[chosen], state=self.state[chosen], which=self.which[chosen])

    def table_values(self) -> dict[str, Any]:
        """Time, what happened, and the state by its names."""
        return {"t": self.t, "which": self.which, **dict(zip(self.components, self.state.T, strict=True))}


def events_of(field: Field, crossings: Sequence[Crossing]) -> Events:
    """The crossings that have a name for users."""
    kinds = kinds_of(field)
    told = [each for each in crossings if (each.border, each.sign) in kinds]
    return Events(
        np.array([each.t for each in told]), np.array([each.state for each in told]).reshape(-1, field.size),
        np.array([kinds[each.border, each.sign] for each in told], dtype=np.intp), field.components,
    )  # fmt: skip
