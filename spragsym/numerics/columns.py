"""Selection, replacement and concatenation of columns that belong together, as those of boxes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

#: Index of boxes along the last axis, or of rows.
Selection: TypeAlias = slice | tuple[Any, ...] | NDArray[np.integer] | NDArray[np.bool_]


def selected_rows(columns: Mapping[str, Any], rows: Selection | int) -> dict[str, Any]:
    """Selected rows of each column, by name."""
    return {name: column[rows] for name, column in columns.items()}


def reuse_memory() -> None:
    """Let the allocator reuse freed arrays of up to 16 MB.

    glibc returns free memory to the system beyond a limit, twice the largest block freed so far.
    Freeing one block of 16 MB raises this limit above what the arrays need.
    """
    np.empty(1 << 21)


@dataclass(frozen=True)
class ByColumn:
    """Base of dataclasses of arrays with one box in each column, along the last axis.

    Fields that are no arrays hold for all boxes.
    """

    def __getitem__(self, rows: Selection) -> Self:
        if isinstance(rows, np.ndarray) and rows.ndim == 1:
            # ``take`` needs a third of the time of an index.
            indices = np.flatnonzero(rows) if rows.dtype == np.bool_ else rows
            return self._made(
                lambda part: (
                    part[indices] if isinstance(part, ByColumn) else part.take(indices, axis=-1)
                )
            )
        return self._made(
            lambda part: part[rows] if isinstance(part, ByColumn) else part[..., rows]
        )

    def scatter(self, rows: Selection, other: Self) -> None:
        """Overwrite the selected columns, in place, by those of another."""
        for field in fields(self):
            getattr(self, field.name)[..., rows] = getattr(other, field.name)

    def concatenated(self, *others: Self) -> Self:
        """These columns, followed by those of others."""

        def joined(one: object, *more: Any) -> object:
            if isinstance(one, ByColumn):
                return one.concatenated(*more)
            return np.concatenate([one, *more], axis=-1)

        return self._made(joined, *others)

    def _made(self, function: Callable[..., Any], *others: Self) -> Self:
        """The result of a function of each array, and of the same array of others."""
        parts = {
            name: function(part, *(getattr(each, name) for each in others))
            for name, part in vars(self).items()
            if isinstance(part, (np.ndarray, ByColumn))
        }
        return type(self)(**vars(self) | parts)
