"""Results of a model: its coordinates and parameters are attributes under the names that its page gives them."""

from __future__ import annotations

from typing import Any, ClassVar

from ..models.forces import columns_of
from ..models.parameters import FloatArray
from .result import Result


class Named(Result):
    """A result whose columns are attributes under their names, each made when it is first asked for."""

    def _asked(self, name: str) -> Any:
        """A column; None if there is none of this name. Every result says it itself."""
        raise NotImplementedError

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or (column := self._asked(name)) is None:
            known = "" if name.startswith("_") else f"; its columns are {', '.join(self.offered)}"
            raise AttributeError(f"{type(self).__name__!r} has no attribute {name!r}{known}")
        self.__dict__[name] = column
        return column


class OfStates(Named):
    """A result that says where states of a model are."""

    parameters: Any

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns that say where a state is: directions and lengths of springs, and the coordinates."""
        return columns_of(self.parameters.model)

    @property
    def coordinates(self) -> dict[str, FloatArray]:
        """The model's coordinates by their names."""
        return {name: getattr(self, name) for name in self.parameters.model.coordinates}


class Columns(Named):
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
    def offered(self) -> tuple[str, ...]:
        return tuple(self.__dict__.get(self.held_in, ()))

    def _asked(self, name: str) -> Any:
        return self.__dict__.get(self.held_in, {}).get(name)
