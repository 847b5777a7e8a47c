"""Base of results: shown as a table, given as columns, written to a file and drawn."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import MissingExtraError
from ..display import Shown, sorted_out, tables, text, words
from ..files import storage
from ..models.forces import columns_of
from ..models.parameters import FloatArray

#: Longer arrays and tuples stand in ``repr`` by their shapes.
WHOLE = 6


class Result(Shown):
    """A result: ``print`` gives its table as well; ``repr`` is that of the dataclass, long arrays
    by their shapes.
    """

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "__repr__" not in cls.__dict__:
            # In the class itself, so that the dataclass of it makes no other.
            cls.__repr__ = _short  # type: ignore[method-assign]

    @property
    def offered(self) -> tuple[str, ...]:
        """Names of further attributes, made when they are asked for."""
        return ()

    def __str__(self) -> str:
        return "\n\n".join(map(text, tables(self)))

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.offered})

    def _is_short(self) -> bool:
        """Whether its columns are worth computing for ``repr``."""
        return True

    def data(self) -> dict[str, NDArray[Any]]:
        """The columns of its table by name, whole: arrays of one shape, angles in radians; none
        where it has no rows.
        """
        return sorted_out(self, words(self))[0]

    def to_dataframe(self) -> Any:
        """A ``pandas.DataFrame`` of :meth:`data`, a row a point, angles in radians; pandas must be
        installed.
        """
        try:
            from pandas import DataFrame  # type: ignore[import-untyped]  # it brings no types
        except ModuleNotFoundError as error:
            raise MissingExtraError("a data frame", "pandas", "sweep") from error
        return DataFrame({name: column.ravel() for name, column in self.data().items()})

    def to_xarray(self) -> Any:
        """An ``xarray.Dataset`` of :meth:`data`, with unit and meaning where the model knows them
        (extra ``sweep``).
        """
        variables = {}
        for name, column in self.data().items():
            dims = (
                ("row",)
                if column.ndim == 1
                else tuple(f"axis_{place}" for place in range(column.ndim))
            )
            variables[name] = (dims, column.astype(object) if column.dtype.kind == "U" else column)
        return storage.dataset(variables, {}, {}, self._explained, {})

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all of it to ``*.json``, which :func:`spragsym.open` reads, or its columns to
        ``*.csv`` or ``*.nc``.
        """
        from .files import save

        save(self, path)

    def _for_file(self) -> Result:
        """The result with all columns made: data alone."""
        return self

    def _save_columns(self, path: Path) -> None:
        """Write a dataset to ``*.nc`` (extra ``sweep``), or columns to ``*.csv``."""
        made = getattr(self, "to_dataset", self.to_xarray)
        storage.write(path, made, self._columns(), self._attributes(), self._explained)

    def _columns(self) -> Mapping[str, NDArray[Any]]:
        """Columns of a ``*.csv``."""
        return self.data()

    def _attributes(self) -> dict[str, Any]:
        """What else a file says."""
        return storage.provenance()

    @property
    def _explained(self) -> storage.Explained:
        """Unit and meaning of columns: as a rule, of those that the page has."""
        model = self.table_model
        return {
            name: told
            for name, told in getattr(model, "quantities", {}).items()
            if name in (*model.parameters, *model.components)
        }

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draw it into ``ax``, by default pyplot's current axes, and return what was drawn (extra
        ``plot``).
        """
        # a shorthand for what a user asks the package: no room imports one behind it
        import spragsym

        return spragsym.figures.plot(self, ax, **options)


def _short(result: Any) -> str:
    """The dataclass's own text with its first columns, but for what would fill pages."""
    given = {field.name: getattr(result, field.name) for field in fields(result) if field.repr}
    shown = (
        {name: column for name, column in result.data().items() if name not in given}
        if result.offered and result._is_short()
        else {}
    )
    given.pop("values" if given.get("vary") in shown else "", None)
    words = ", ".join(f"{name}={_named(value)}" for name, value in {**shown, **given}.items())
    return f"{type(result).__name__}({words})"


def _named(value: Any) -> str:
    if isinstance(value, np.ndarray) and value.size > WHOLE:
        return f"array{value.shape}"
    if isinstance(value, tuple | list) and len(value) > WHOLE:
        return f"({len(value)} of {type(value[0]).__name__})"
    return " ".join(repr(value).split())


class Rows(Result):
    """A result whose rows can be counted, indexed and gone through: each is a mapping of its
    columns to numbers or words.
    """

    def __len__(self) -> int:
        return len(next(iter(self.data().values()), ()))

    def __getitem__(self, index: int) -> dict[str, Any]:
        return {name: column[index].item() for name, column in self.data().items()}

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return map(self.__getitem__, range(len(self)))


class Named(Result):
    """A result whose columns are attributes under their names, each made when it is first asked
    for.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True)
    ... class Path(Named):
    ...     held_in = "coordinates"
    ...     coordinates: dict
    >>> Path({"x": 1.5}).x
    1.5
    """

    #: The field with a mapping of names to columns, of a result that does not make them otherwise.
    held_in = ""

    @property
    def offered(self) -> tuple[str, ...]:
        return tuple(self.__dict__.get(self.held_in, ()))

    def _asked(self, name: str) -> Any:
        """A column; None if there is none of this name."""
        return self.__dict__.get(self.held_in, {}).get(name)

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
        """Names of the columns that say where a state is: directions and lengths of springs, and
        the coordinates.
        """
        return columns_of(self.parameters.model)

    @property
    def coordinates(self) -> dict[str, FloatArray]:
        """The model's coordinates by their names."""
        return {name: getattr(self, name) for name in self.parameters.model.coordinates}
