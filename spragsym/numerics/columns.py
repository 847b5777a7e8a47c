"""Arrays whose columns belong together, as those of boxes: some of them, and more of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray

#: Some of many boxes, or of rows of them.
Selection: TypeAlias = slice | tuple[Any, ...] | NDArray[np.integer] | NDArray[np.bool_]


def selected_rows(columns: Mapping[str, Any], rows: Selection | int) -> dict[str, Any]:
    """Some rows of each of several columns by name."""
    return {name: column[rows] for name, column in columns.items()}


def reuse_memory() -> None:
    """Let freed arrays of up to 16 MB be used again.

    glibc returns freed memory to the system, which must then map it again, beyond twice the largest
    piece freed before: that has to be more than all arrays in between take.
    """
    np.empty(1 << 21)


@dataclass(frozen=True)
class ByColumn:
    """Arrays of which each column, along the last axis, is of one box; what is no array is of
    all.
    """

    def __getitem__(self, rows: Selection) -> Self:
        if isinstance(rows, np.ndarray) and rows.ndim == 1:
            # NumPy takes by numbers in a third of the time.
            number = np.flatnonzero(rows) if rows.dtype == np.bool_ else rows
            return self._made(
                lambda part: (
                    part[number] if isinstance(part, ByColumn) else part.take(number, axis=-1)
                )
            )
        return self._made(
            lambda part: part[rows] if isinstance(part, ByColumn) else part[..., rows]
        )

    def scatter(self, rows: Selection, other: Self) -> None:
        """Overwrite some columns by those of another."""
        for field in fields(self):
            getattr(self, field.name)[..., rows] = getattr(other, field.name)

    def concatenated(self, *others: Self) -> Self:
        """These, and others."""

        def joined(one: object, *more: Any) -> object:
            if isinstance(one, ByColumn):
                return one.concatenated(*more)
            return np.concatenate([one, *more], axis=-1)

        return self._made(joined, *others)

    def _made(self, of: Callable[..., Any], *others: Self) -> Self:
        parts = {
            name: of(part, *(getattr(each, name) for each in others))
            for name, part in vars(self).items()
            if isinstance(part, (np.ndarray, ByColumn))
        }
        return type(self)(**vars(self) | parts)
