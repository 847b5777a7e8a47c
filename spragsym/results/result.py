"""Base classes of results: columns with a schema, printed as a table, saved, converted and
drawn.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..core.errors import MissingExtraError
from ..core.type_variables import T
from ..display import (
    Column,
    Schema,
    Tabular,
    facts,
    own_name,
    parts,
    schema_of,
    sorted_out,
    tables,
    text,
)
from ..files import storage
from ..models.load import USUAL, load
from ..models.parameters import FloatArray, degrees

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame  # type: ignore[import-untyped]  # it brings no types
    from xarray import Dataset

    from ..models.model import Model


#: Largest length of arrays and tuples that ``repr`` shows; longer ones are shown by their shapes.
WHOLE = 6


class Units(Protocol):
    """The units of data: a study, with the units of its file, or scales."""

    @property
    def scales(self) -> Any:
        """Scales in SI."""

    def unit_of(self, si: str, name: str = "") -> tuple[str, float]:
        """The unit that is used for one in SI, and the factor from the model's unit to it."""


@dataclass(frozen=True, eq=False)
class Items(Mapping[str, Any]):
    """A mapping of columns by name, each computed when it is asked for."""

    names: tuple[str, ...]
    make: Callable[[str], Any]

    def __getitem__(self, name: str) -> Any:
        if name not in self.names:
            raise KeyError(name)
        return self.make(name)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)


class Result(Tabular):
    """Base class of results. ``print`` shows the table; ``repr`` shows long arrays by their shapes.

    Columns are items, ``result["x"]``, and ``result.columns`` has the meaning of each. Of most
    classes a column is an attribute too, unless the class has an attribute of that name. If a
    column of the package has the name of a quantity of the page, the package's is the item with an
    underscore behind it.
    """

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "__repr__" not in cls.__dict__:
            # Set in the class itself: the dataclass decorator then makes no other.
            cls.__repr__ = _short  # type: ignore[method-assign]

    @property
    def _schema(self) -> Schema:
        return schema_of(self, Schema({}, load(USUAL)))

    def _own(self, name: str) -> str:
        """The item name of a column of the package."""
        model = self._of_model
        return name if model is None else own_name(model, name)

    @property
    def columns(self) -> dict[str, Column]:
        """Meanings of all columns, by name: dimension, meaning and codes."""
        columns = self._schema.columns
        return {name: columns.get(name, Column(name)) for name in self._items}

    @property
    def _items(self) -> Mapping[str, Any]:
        """Columns by name."""
        return self.data()

    def __getitem__(self, name: str) -> Any:
        made = self.__dict__.setdefault("_made_items", {})
        if name not in made:
            items = self._items
            if name not in items:
                raise KeyError(f"{name!r} is none of the columns {', '.join(items)}")
            made[name] = items[name]
        return made[name]

    def __str__(self) -> str:
        return "\n\n".join(map(text, tables(self, self._schema)))

    def _is_short(self) -> bool:
        """Whether ``repr`` shows the columns."""
        return True

    def data(self) -> dict[str, NDArray[Any]]:
        """The columns by name: arrays of one shape, angles in radians; of a result without rows its
        numbers and words, arrays without axes.

        Returns
        -------
        dict of str to array

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> sorted(found.data())
        ['L', 'error', 'kind', 'theta', 'theta0', 'x', 'y']
        >>> ss.certify(ss.Parameters.article(theta0=0.5)).data()["outcome"].item()
        'proved'
        """
        schema = self._schema
        columns, _, values = sorted_out(self, schema)
        if not columns:
            return {name: np.asarray(value) for name, value in facts(values, schema).items()}
        shape = next(iter(columns.values())).shape
        over = {
            name: np.broadcast_to(values, shape)
            for name, values in self._over.items()
            if values.size > 1
        }
        return over | columns

    @property
    def _over(self) -> Mapping[str, FloatArray]:
        """Arrays that broadcast to the shape of the columns, whose values the result is over, by
        name.
        """
        return {}

    @property
    def _facts(self) -> dict[str, Any]:
        """Numbers and words that hold for all rows, by name; none where they are the one row."""
        columns, _, values = sorted_out(self, self._schema)
        return facts(values, self._schema) if columns else {}

    def _parts(self) -> dict[str, dict[str, NDArray[Any]]]:
        """Columns of the tables below the first one, by what they are of."""
        return parts(sorted_out(self, self._schema)[2], self._schema)

    def to_dataframe(self) -> DataFrame:
        """A ``pandas.DataFrame`` of :meth:`data`, one row a point; pandas must be installed.

        Numbers and words that hold for all rows are its ``attrs``.

        Returns
        -------
        pandas.DataFrame

        Raises
        ------
        MissingExtraError
            Without pandas.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> found.to_dataframe().shape
        (2, 7)
        """
        try:
            from pandas import DataFrame
        except ModuleNotFoundError as error:
            raise MissingExtraError("a data frame", "pandas", "sweep") from error
        frame = DataFrame({name: column.ravel() for name, column in self.data().items()})
        frame.attrs = self._facts
        return frame

    def to_xarray(self) -> Dataset:
        """An ``xarray.Dataset`` of all tables, with unit, meaning and codes (extra ``sweep``).

        An axis along which only one input varies has its name; others are ``row``, or ``axis_0``,
        ``axis_1``, …, with numbers from 0. Angles of inputs are given in radians and, as
        ``theta0_deg``, in degrees. What stands in a table below the first one has its own axis, and
        names that begin with that of the table. What holds for all rows are attributes.

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        MissingExtraError
            Without xarray.

        Examples
        --------
        >>> import spragsym as ss
        >>> path = ss.quasi_static_path(ss.Parameters.article(theta0=1.0), "mu0", [0.0, 0.1, 0.2])
        >>> dict(path.to_xarray().sizes)
        {'mu0': 3}
        """
        columns, over = self.data(), self._over
        shape = next(iter(columns.values())).shape if columns else ()
        axes = axes_of(over, shape) if over or len(shape) != 1 else ("row",)
        coords = along_axes(with_degrees(self._schema.model, over), axes, shape)
        coords |= {
            axis: (axis, np.arange(size))
            for axis, size in zip(axes, shape, strict=True)
            if axis not in coords
        }
        data: dict[str, tuple[Any, NDArray[Any]]] = {
            name: (axes, column) for name, column in columns.items() if name not in coords
        }
        described = dict(self._in_model_units)
        for table, rows in self._parts().items():
            coords[table] = table, np.arange(len(next(iter(rows.values()), ())))
            data |= {f"{table}_{name}": (table, column) for name, column in rows.items()}
            described |= {f"{table}_{name}": described[name] for name in rows if name in described}
        values = sorted_out(self, self._schema)[2]
        for name, value in values.items():
            if isinstance(value, np.ndarray) and value.ndim and name not in (*data, *coords):
                others = [f"{name}_axis_{number}" for number in range(value.ndim)]
                data[name] = others, value
                coords |= {
                    axis: (axis, np.arange(size))
                    for axis, size in zip(others, value.shape, strict=True)
                }
        made = storage.dataset(data, coords, self._attributes() | self._facts, described)
        for table, part in values.items():
            if isinstance(part, Result):
                other = part.to_xarray()
                made = made.merge(
                    other.rename({name: f"{table}_{name}" for name in other.variables})
                )
        return made

    def to_dataset(self) -> Dataset:
        """The same as :meth:`to_xarray`.

        Returns
        -------
        xarray.Dataset

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> list(tr.to_dataset().dims)
        ['t', 'event_t']
        """
        return self.to_xarray()

    def to_units(self, units: Units) -> InUnits:
        """The columns in units of data: of a file, or of any consistent system.

        Parameters
        ----------
        units : Study or Scales
            A study says the units of its file; ``PhysicalParameters.scales`` those of its numbers,
            of which columns bear the names in SI.

        Returns
        -------
        InUnits
            Each column under the name that says its unit, as ``x_mm``; angles in degrees.

        Examples
        --------
        >>> import spragsym as ss
        >>> brake = ss.PhysicalParameters(
        ...     m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05,
        ...     theta0=0.9, mu0=0.3, V=20, d=1,
        ... )
        >>> found = ss.equilibria(brake.dimensionless()).to_units(brake.scales)
        >>> [name for name in found.columns if name[0] in "xL"], found["x_m"].round(5).tolist()
        (['L_m', 'x_m'], [0.00478, 0.02107, 0.05484])
        """
        columns, values, meanings, names = self.columns, {}, {}, {}
        entries = [] if self._of_model is None else self._of_model.about["parameters"]
        quantities = {one["name"]: one.get("quantity", one["name"]) for one in entries}
        for name, column in self._of_points().items():
            quantity, column_of_name = quantities.get(name, name), columns[name]
            unit, size = in_unit(column_of_name.dimension, units, quantity)
            title = titled(quantity, column_of_name.dimension, units, quantity)[0]
            values[title] = size * column if column.dtype.kind == "f" else column
            meanings[title], names[title] = column_of_name.meaning, unit or "1"
        return InUnits(values, meanings, names)

    def _of_points(self) -> Mapping[str, NDArray[Any]]:
        """The columns with a value in every row, angles in radians."""
        return self.data()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all of it to ``*.json``, which :func:`spragsym.open` reads, or its columns to
        ``*.csv`` or ``*.nc``.

        Parameters
        ----------
        path : str or path
            A file that ends in ``.json``, ``.csv`` or ``.nc``; it is written whole, or not at all.

        Raises
        ------
        ParameterError
            For another ending.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> import pathlib, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     found.save(pathlib.Path(folder, "folds.json"))
        ...     ss.open(pathlib.Path(folder, "folds.json")).theta0.round(4)
        array([0.7777, 2.7063])
        """
        from .files import save

        save(self, path)

    def _for_file(self) -> Result:
        """The result with all columns computed, as it is written to a file."""
        return self

    def _save_columns(self, path: Path) -> None:
        """Write a dataset to ``*.nc`` (extra ``sweep``), or columns to ``*.csv``."""
        attributes = self._attributes() | self._facts
        storage.write(path, self.to_xarray, self._columns(), attributes, self._in_model_units)

    def _columns(self) -> Mapping[str, NDArray[Any]]:
        """Columns of a ``*.csv``."""
        return self.data()

    def _attributes(self) -> dict[str, Any]:
        """Attributes of a file of columns."""
        return storage.provenance()

    @property
    def _in_model_units(self) -> dict[str, Column]:
        """The schema's columns with units of the model in place of those in SI."""
        schema = self._schema
        return in_model_units(schema.model, schema.columns)

    def plot(self, ax: Axes | None = None, **options: Any) -> Any:
        """Draw it into ``ax``, by default pyplot's current axes, and return what was drawn (extra
        ``plot``).

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where it is drawn.
        **options
            Those of the function of :mod:`spragsym.figures` that draws it.

        Returns
        -------
        list of artists

        Raises
        ------
        MissingExtraError
            Without matplotlib.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> from matplotlib.figure import Figure
        >>> bool(found.plot(Figure().add_subplot()))
        True
        """
        # A shorthand that asks the package: figures is a later room, which this one can't import.
        import spragsym

        return spragsym.figures.plot(self, ax, **options)


def in_model_units(model: Model, columns: Mapping[str, Column]) -> dict[str, Column]:
    """Columns with units of the model, as ``k_c*L_0``, in place of those in SI; every angle has a
    second column in degrees.
    """
    found = {
        f"{name}_deg": Column(f"{name}_deg", "degree", column.meaning)
        for name, column in columns.items()
        if column.is_angle
    }
    return found | {
        name: replace(column, dimension=model.unit(column.dimension))
        for name, column in columns.items()
    }


def titled(name: str, dimension: str, units: Units | None, of: str = "") -> tuple[str, float]:
    """The title of a column, which ends in its unit, and the factor from the model's unit to it.

    ``of`` is the quantity of a file whose unit is used.
    """
    unit, size = in_unit(dimension, units, of)
    return f"{name}_{'per_s' if unit == '1/s' else unit}" if unit else name, size


def in_unit(dimension: str, units: Units | None, of: str = "") -> tuple[str, float]:
    """The unit for a dimension, empty for a number, and the factor from the model's unit to it."""
    if dimension == "rad":
        return "deg", math.degrees(1.0)
    if units is None or dimension in ("1", ""):
        return "", 1.0
    if dimension == "1/s":
        return "1/s", 1.0 / units.scales.time
    return units.unit_of(dimension, of)


def axes_of(inputs: Mapping[str, FloatArray], shape: tuple[int, ...]) -> tuple[str, ...]:
    """A name for every axis: the only input that varies along it, if it varies along no other axis;
    else ``axis_0``, ….
    """
    sizes = {
        name: (*[1] * (len(shape) - values.ndim), *values.shape) for name, values in inputs.items()
    }
    names = []
    for axis, size in enumerate(shape):
        varying = [name for name, own in sizes.items() if own[axis] > 1]
        names.append(
            varying[0] if len(varying) == 1 and inputs[varying[0]].size == size else f"axis_{axis}"
        )
    return tuple(names)


def along_axes(
    inputs: Mapping[str, FloatArray], axes: tuple[str, ...], shape: tuple[int, ...]
) -> dict[str, Any]:
    """Inputs as coordinates of a dataset: a number, the values along an axis, or an array of the
    full shape, each with its axes.
    """
    found: dict[str, Any] = {}
    for name, values in inputs.items():
        axis = name.removesuffix("_deg")
        if values.size == 1:
            found[name] = (), float(values.flat[0])
        elif axis in axes:
            found[name] = axis, values.ravel()
        else:
            found[name] = axes, np.broadcast_to(values, shape).copy()
    return found


def with_degrees(model: Model, inputs: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """The inputs, with each angle in degrees added after that in radians."""
    columns = {}
    for name, values in inputs.items():
        columns[name] = values
        if name in model.about["angles"]:
            columns[f"{name}_deg"] = np.vectorize(degrees, otypes=[np.float64])(values)
    return columns


def _short(result: Any) -> str:
    """The ``repr`` of a result: its columns, if it is short, and its fields."""
    attributes = {field.name: getattr(result, field.name) for field in fields(result) if field.repr}
    shown = (
        {name: column for name, column in result.data().items() if name not in attributes}
        if isinstance(result, Named) and result._is_short()
        else {}
    )
    attributes.pop("values" if attributes.get("vary") in shown else "", None)
    words = ", ".join(f"{name}={_named(value)}" for name, value in {**shown, **attributes}.items())
    return f"{type(result).__name__}({words})"


def _named(value: object) -> str:
    """A value for ``repr``; long arrays and sequences by their shapes."""
    if isinstance(value, np.ndarray) and value.size > WHOLE:
        return f"array{value.shape}"
    if isinstance(value, tuple | list) and len(value) > WHOLE:
        return f"({len(value)} of {type(value[0]).__name__})"
    return " ".join(repr(value).split())


class Named(Result):
    """A result whose columns are attributes too, each computed when it is first asked for.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True)
    ... class Path(Named):
    ...     _held = "coordinates"
    ...     coordinates: dict
    >>> path = Path({"x": 1.5})
    >>> path["x"], path.x
    (1.5, 1.5)
    """

    #: name of a field that maps names to columns, if there is one
    _held = ""

    @property
    def _items(self) -> Mapping[str, Any]:
        held = self.__dict__.get(self._held, {})
        return {**held, **self.data(), **held}

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._items})

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(f"{type(self).__name__!r} has no attribute {name!r}")
        items, key = self._items, name
        # As an attribute, a name that the page has too is the package's column.
        if any(column.name == name for column in self.schema):
            while f"{key}_" in items:
                key += "_"
        if key not in items:
            raise AttributeError(
                f"{type(self).__name__!r} has no attribute {name!r}; its columns are "
                f"{', '.join(items)}"
            )
        return self[key]


class Rows(Result):
    """A result as a sequence of rows: each row maps the names of columns to numbers or words."""

    def __len__(self) -> int:
        return len(next(iter(self.data().values()), ()))

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, str):
            return super().__getitem__(index)
        return self._row(self.data(), index)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        columns = self.data()
        return (self._row(columns, index) for index in range(len(self)))

    def _row(self, columns: Mapping[str, NDArray[Any]], index: int) -> dict[str, Any]:
        schema = self._schema
        return {name: schema.word(name, column[index].item()) for name, column in columns.items()}


@dataclass(frozen=True, eq=False)
class InUnits(Rows):
    """Columns in units that their names say, as ``x_mm`` and ``theta_deg``."""

    values: Mapping[str, NDArray[Any]]
    meanings: Mapping[str, str]
    units: Mapping[str, str] = field(default_factory=dict)

    @property
    def _said(self) -> dict[str, Column]:
        usual = super()._schema.columns
        return {
            name: replace(
                usual.get(name, Column(name)),
                dimension=self.units.get(name, "1"),
                meaning=meaning,
            )
            for name, meaning in self.meanings.items()
        }

    @property
    def _schema(self) -> Schema:
        usual = super()._schema
        return replace(usual, columns={**usual.columns, **self._said})

    @property
    def _in_model_units(self) -> dict[str, Column]:
        return self._said | _in_hdf5(self._said)

    def to_xarray(self) -> Dataset:
        """An ``xarray.Dataset`` with units; names have ``_per_`` for "/", which HDF5 does not
        allow.

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        MissingExtraError
            Without xarray.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> dict(eq.to_units(ss.Scales(length=0.038, time=5e-4, force=57e3)).to_xarray().sizes)
        {'row': 4}
        """
        meanings, units = _in_hdf5(self.meanings), _in_hdf5(self.units)
        return Result.to_xarray(InUnits(_in_hdf5(self.values), meanings, units))

    def data(self) -> dict[str, NDArray[Any]]:
        """The columns by name.

        Returns
        -------
        dict of str to array
            Each under the name that says its unit.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> found = eq.to_units(ss.Scales(length=0.038, time=5e-4, force=57e3))
        >>> found.data()["x_m"].round(4)
        array([0.0026, 0.023 , 0.0623, 0.0346])
        """
        return dict(self.values)


def _in_hdf5(columns: Mapping[str, T]) -> dict[str, T]:
    """Columns with names that HDF5 allows."""
    return {name.replace("/", "_per_"): column for name, column in columns.items()}


class OfStates(Named):
    """A result with states of a model."""

    parameters: Any

    @property
    def state_columns(self) -> tuple[str, ...]:
        """Names of the columns of a state: directions and lengths of springs, and coordinates."""
        names: tuple[str, ...] = self.parameters.model.places
        return names

    @property
    def coordinates(self) -> dict[str, FloatArray]:
        """The model's coordinates by their names."""
        return {name: self[name] for name in self.parameters.model.coordinates}
