"""Storage of results: columns with the first equilibrium of every point, and further ones, of few points, apart.

Memory that is touched for the first time costs as much as the solving: what most points don't have is not written. Padded
arrays, of one more axis than the parameters, are made when they are asked for.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.interval_arrays import BoolArray, Int8Array, IntArray

#: What is known of an equilibrium.
COLUMNS = ("theta", "L", "x", "y", "error", "stability")
_TYPES: dict[str, Any] = dict.fromkeys(COLUMNS, np.float64) | {"stability": np.int8}
#: What stands in an empty slot.
_NOTHING: dict[str, float] = dict.fromkeys(COLUMNS, np.nan) | {"stability": 0}

#: Columns by name; of one point each row, or of one point and slot.
Columns = Mapping[str, NDArray[Any]]


@dataclass
class Slots:
    """Equilibria of ``size`` points, up to ``slots`` of each; ``count`` says how many each point has.

    ``first`` is the first equilibrium of every point; after :meth:`clear`, NaN and 0 for points without one. ``further`` are rows
    and columns: of some points the equilibria in slots 1 and up, of shape (further slots, len(rows)), NaN and 0 beyond the count;
    slots behind these are empty. A later entry replaces an earlier one.
    """

    size: int
    slots: int
    count: Int8Array = field(init=False)
    first: dict[str, NDArray[Any]] = field(init=False)
    further: list[tuple[IntArray, Columns]] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        self.count = np.zeros(self.size, dtype=np.int8)
        self.first = {name: np.empty(self.size, dtype=kind) for name, kind in _TYPES.items()}

    def put(self, rows: IntArray, count: NDArray[Any], columns: Columns) -> None:
        """Store all equilibria of the points in ``rows``, columns of shape (some slots, len(rows))."""
        self.count[rows] = count
        for name, values in columns.items():
            self.first[name][rows] = values[0]
        self.further.append((rows, {name: values[1:] for name, values in columns.items()}))

    def padded(self, name: str) -> NDArray[Any]:
        """A column as an array of shape (size, slots), in memory slot by slot; NaN, or 0 for the stability, beyond the count."""
        kind = _TYPES[name]
        nothing = _NOTHING[name]
        table: NDArray[Any] = np.empty((self.slots, self.size), dtype=kind)
        table[0] = self.first[name]
        table[1:] = nothing
        for rows, columns in self.further:
            filled = 1 + len(columns[name])
            table[1:filled, rows] = columns[name]
            table[filled:, rows] = nothing
        return table.T

    def clear(self) -> None:
        """Empty the first slot of points that have no equilibrium: memory holds anything before it is written."""
        rows = np.flatnonzero(self.count == 0)
        for name, values in self.first.items():
            values[rows] = _NOTHING[name]


def empty(slots: int, points: int) -> dict[str, NDArray[Any]]:
    """Columns of shape (slots, points) with nothing in them."""
    return {name: np.full((slots, points), nothing, dtype=_TYPES[name]) for name, nothing in _NOTHING.items()}


def gathered(members: BoolArray, candidates: Columns) -> tuple[IntArray, dict[str, NDArray[Any]]]:
    """Move the members among the candidates of each point, shape (candidates, points), to the front; and count them."""
    size, points = members.shape
    pattern = np.zeros(points, dtype=np.uint8)
    for place, row in enumerate(members):
        pattern |= row.view(np.uint8) << place
    order, number = _orders(size)
    count = number[pattern]
    packed = {name: np.array(candidates[name], dtype=kind) for name, kind in _TYPES.items()}
    partial = np.flatnonzero(count < size)
    if partial.size:
        free = np.arange(size)[:, None] >= count[partial]
        # Where they are and where they go in a table that is read as one row.
        target, chosen = points * np.arange(size)[:, None] + partial, points * order[pattern[partial]].T + partial
        for name, table in packed.items():
            table.put(target, np.where(free, _NOTHING[name], table.take(chosen)))
    return count, packed


@cache
def _orders(candidates: int) -> tuple[IntArray, IntArray]:
    """For every set of members, as bits, the order that puts them first, and how many they are."""
    flags = np.arange(1 << candidates)[:, None] >> np.arange(candidates) & 1
    return np.argsort(1 - flags, axis=1, kind="stable"), flags.sum(axis=1)
