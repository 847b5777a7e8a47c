"""Results of a model: its coordinates and parameters are attributes under the names that its page gives them."""

from __future__ import annotations

from typing import Any, ClassVar

from ..models.parameters import FloatArray
from .result import Result


class Columns(Result):
    """A result with a mapping of names to arrays in one of its fields: each array is an attribute under its name too.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True)
    ... class Path(Columns, held_in="coordinates"):
    ...     coordinates: dict
    >>> Path({"x": 1.5}).x
    1.5
    """

    #: The field that holds them.
    held_in: ClassVar[str]

    def __init_subclass__(cls, held_in: str, **options: Any) -> None:
        super().__init_subclass__(**options)
        cls.held_in = held_in

    @property
    def offered(self) -> tuple[str, ...]:  # type: ignore[override]  # of each result its own
        return tuple(self.__dict__.get(self.held_in, ()))

    def __getattr__(self, name: str) -> FloatArray:
        columns = self.__dict__.get(self.held_in, {})
        if name not in columns:
            known = f"its {self.held_in} are {', '.join(columns)}"
            raise AttributeError(f"{type(self).__name__!r} has no attribute {name!r}; {known}")
        column: FloatArray = columns[name]
        return column
