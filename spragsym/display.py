"""Columns of results, and results as tables, for notebooks and for ``print``: angles in degrees,
under names that end in ``_deg``.

A class of results declares its columns once, as ``schema``; a model brings those of its own
quantities. Headings, units, words of codes and axes follow from them.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, ClassVar, cast

import numpy as np
from numpy.typing import NDArray

from .core.options import Options
from .core.shown import html_text
from .numerics.interval_arrays import IntArray

if TYPE_CHECKING:
    from .models.model import Model


@dataclass(frozen=True)
class Column:
    """A column of a result.

    Attributes
    ----------
    name : str
        Of a class of results ``{x}`` in it, in dimension and meaning stands for the model's first
        coordinate; one column each is declared by ``{q}`` for all coordinates, ``{y}`` for all but
        the first, ``{v}`` for coordinates and rates, ``{p}`` for what says where a state is,
        ``{a}`` for all parameters.
    dimension : str
        Its unit in SI, ``"1"`` for a number and ``"rad"`` for an angle; or ``{x}`` and the like:
        that of the coordinate.
    meaning : str
    codes : type of enum.IntEnum, optional
        What its numbers mean.
    rate_of : str, optional
        The coordinate whose rate it is.
    of : callable, optional
        The column of a result that does not hold it.
    row : {"", "before", "behind", "beside"}
        Where it stands in a row of states: before or behind the columns that say where the state
        is, or behind all others and in no table.

    Examples
    --------
    >>> Column("rest_{q}", "{q}", "{q} of the equilibrium that a motion comes to").name
    'rest_{q}'
    """

    name: str
    dimension: str = "1"
    meaning: str = ""
    codes: type[enum.IntEnum] | None = None
    rate_of: str = ""
    of: Callable[[Any], Any] | None = field(default=None, compare=False)
    row: str = ""

    def value(self, result: object) -> object:
        """The column of a result: as it follows from others, or the attribute of its name.

        Parameters
        ----------
        result : Result
            A result that has the column.

        Returns
        -------
        array or number

        Examples
        --------
        >>> from types import SimpleNamespace
        >>> Column("x", "m").value(SimpleNamespace(x=2.0))
        2.0
        >>> Column("width", "m", of=lambda result: result.high - result.low).value(
        ...     SimpleNamespace(low=1.0, high=4.0)
        ... )
        3.0
        """
        return getattr(result, self.name) if self.of is None else self.of(result)

    @property
    def is_angle(self) -> bool:
        """Whether its numbers are radians."""
        return self.dimension == "rad"

    @property
    def size(self) -> float:
        """Size of the unit in which its numbers are shown: angles are degrees."""
        return math.degrees(1.0) if self.is_angle else 1.0

    @property
    def heading(self) -> str:
        """Heading of a column: its name, of an angle with its unit."""
        return f"{self.name}{'_deg' if self.is_angle else ''}"


def own_name(model: Model, name: str) -> str:
    """A name of ours among items and columns of a model: with an underscore behind it where the
    page has that name.
    """
    taken = (*model.parameters, *model.components)
    while name in taken:
        name += "_"
    return name


@lru_cache(maxsize=256)
def columns_of_class(kind: type, model: Model) -> dict[str, Column]:
    """Columns that a class of results may have for a model, by name, the model's own among them."""
    own, first = model.columns, next(iter(model.coordinates), "")
    over = {
        "{q}": model.coordinates,
        "{y}": model.coordinates[1:],
        "{v}": model.components,
        "{p}": model.places,
        "{a}": model.parameters,
    }
    found = dict(own)
    for each in getattr(kind, "schema", ()):
        for name in next((over[mark] for mark in over if mark in each.name), ("",)):
            said, dimension, meaning = (
                text.format(x=first, q=name, y=name, v=name, p=name, a=name)
                for text in (each.name, each.dimension, each.meaning)
            )
            if dimension != each.dimension:
                dimension = own[dimension].dimension
            said = said if name else own_name(model, said)
            found[said] = replace(each, name=said, dimension=dimension, meaning=meaning)
    return found


@dataclass(frozen=True)
class Table:
    """Rows of text under names, and a line above them."""

    title: str
    header: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


class Tabular:
    """Base of dataclasses that show themselves as a table in a notebook."""

    #: Columns of the class that are not the model's own.
    schema: ClassVar[tuple[Column, ...]] = ()
    #: It stands on the line above the table of what it is part of.
    in_a_line: ClassVar[bool] = False

    @property
    def _of_model(self) -> Model | None:
        """The model whose quantities its columns are, its own or that of a part; None where a
        result does not know it.
        """
        own = self.__dict__
        parts = (own.get("parameters"), own.get("sweep"))
        models = (own.get("model"), *(getattr(each, "model", None) for each in parts))
        return next((model for model in models if hasattr(model, "columns")), None)

    def _shown(self) -> dict[str, Any]:
        """Fields of the table, by name."""
        return named_fields(self)

    @property
    def _schema(self) -> Schema:
        return schema_of(self)

    def _repr_html_(self) -> str:
        return "\n".join(map(as_html, tables(self, self._schema)))


@dataclass(frozen=True)
class Schema:
    """Columns of a table by name, and how it writes what is in them."""

    columns: Mapping[str, Column]
    model: Any = None
    vary: str = "value"  #: what ``value`` and ``values`` are of

    def column(self, key: str) -> Column:
        """The column of a name, with what a table adds to it behind a blank."""
        name = key.partition(" ")[0]
        # Columns of the parameter that varies; the first two have its name.
        name = (
            self.vary
            if name in ("value", "values", "to", "others") and self.vary in self.columns
            else name
        )
        return self.columns.get(name, Column(name))

    def heading(self, key: str) -> str:
        """A column's name, of an angle with its unit."""
        name, blank, rest = key.partition(" ")
        called = self.vary if name in ("value", "values") else name
        return f"{replace(self.column(key), name=called).heading}{blank}{rest}"

    def word(self, key: str, value: object) -> object:
        """A code as its word, and all else as it is."""
        codes = self.column(key).codes
        if codes is not None and isinstance(value, int):
            value = codes(value) if value in set(codes) else "other"
        return value.name.lower() if isinstance(value, enum.Enum) else value

    def cell(self, key: str, value: object) -> str:
        """A number to ten digits, a code as its word."""
        if isinstance(value, np.ndarray | np.generic):
            value = value.item() if value.ndim == 0 else self.listed(key, value)
        if isinstance(value, tuple):
            return ", ".join(self.cell(key, part) for part in value)
        value = self.word(key, value)
        if isinstance(value, str):
            return value
        if not isinstance(value, float):
            text = getattr(value, "brief", None) or str(value)
            # The tables of a result stand in no cell.
            return type(value).__name__ if "\n" in text else text
        if key == ("error" if self.model is None else own_name(self.model, "error")):
            from .numerics.decimals import upward

            return upward(value)
        return f"{self.column(key).size * value:.10g}"

    def listed(self, key: str, values: NDArray[Any] | np.generic) -> str:
        """The first few numbers of an array."""
        flat = values.ravel()
        text = ", ".join(self.cell(key, value) for value in flat[:8])
        return f"[{text}{', …' if flat.size > 8 else ''}]"


def schema_of(thing: object, above: Schema | None = None) -> Schema:
    """The schema of a result; a part that does not know its model or its parameter takes those of
    the result ``above``.
    """
    above, kind = above or Schema({}), cast(Hashable, type(thing))
    model = getattr(thing, "_of_model", None) or above.model
    vary = getattr(thing, "__dict__", {}).get("vary")
    return Schema(
        {} if model is None else columns_of_class(kind, model),
        model,
        vary if isinstance(vary, str) else above.vary,
    )


def tables(thing: object, above: Schema | None = None) -> Iterator[Table]:
    """The tables of a dataclass: one of its columns, and one of each part that has columns
    itself.
    """
    if hasattr(thing, "as_table"):  # one whose rows are not its fields
        yield thing.as_table()
        return
    name, said = type(thing).__name__, schema_of(thing, above)
    columns, single, values = sorted_out(thing, said)
    if columns:
        shape = next(iter(columns.values())).shape
        yield _columns(caption(said, name, single, _size(shape)), columns, shape, said)
    elif single:
        yield Table(
            name,
            ("", "value"),
            tuple((said.heading(key), said.cell(key, value)) for key, value in single.items()),
        )
    for key, value in values.items():
        if _is_single(value):
            continue
        if is_dataclass(value):
            yield from (
                replace(table, title=f"{key}: {table.title}") for table in tables(value, said)
            )
        elif isinstance(value, Sequence):
            yield from _sequence(key, value, said)


def sorted_out(
    thing: object, said: Schema
) -> tuple[dict[str, NDArray[Any]], dict[str, Any], dict[str, Any]]:
    """The columns of a dataclass, arrays of its largest shape; what fits on the line above them;
    and all values.
    """
    values = (
        thing._shown() | following(thing) if isinstance(thing, Tabular) else named_fields(thing)
    )
    if isinstance(values.get("undecided"), np.ndarray):
        values["undecided"] = counted(len(values["undecided"]), "box", "boxes")
    if "vary" in values and "values" in values:
        vary, column = values["vary"], values.pop("values")
        if isinstance(vary, str):
            values = {vary: column, **values}
        else:  # several at once: a column each, whose headings say what is varied
            del values["vary"]
            values = {**dict(zip(vary, column.T, strict=True)), **values}
    if isinstance(values.get("vary"), tuple):
        values["vary"] = ", ".join(values["vary"])
    single = {key: value for key, value in values.items() if _is_single(value)}
    arrays = {
        key: value for key, value in values.items() if isinstance(value, np.ndarray) and value.ndim
    }
    shape = max(
        (value.shape for value in arrays.values()),
        key=math.prod,
        default=(),
    )
    columns = {key: value for key, value in arrays.items() if value.shape == shape}
    single |= {
        key: said.listed(key, value) for key, value in arrays.items() if value.shape != shape
    }
    return columns, single, values


def facts(values: Mapping[str, Any], said: Schema) -> dict[str, Any]:
    """Numbers and words that hold for all rows of a dataclass, as files have them: several numbers
    by their positions, a set of parameters by their names, codes as words, remarks in one line.
    """
    found: dict[str, Any] = {}
    for key, value in values.items():
        match value:
            case bool() | int() | float() | str():
                found[key] = said.word(key, value)
            case np.generic() | np.ndarray() if not value.ndim:
                found[key] = said.word(key, value.item())
            case tuple() if value and all(isinstance(part, str) for part in value):
                found[key] = "; ".join(value)
            case tuple() if value and all(isinstance(part, int | float) for part in value):
                found |= {f"{key}_{number}": part for number, part in enumerate(value, 1)}
            case Tabular(in_a_line=True):
                found |= {
                    f"{key}_{name}" if name in values else name: one
                    for name, one in value._shown().items()
                    if not np.ndim(one)
                }
    return found


def parts(values: Mapping[str, Any], said: Schema) -> dict[str, dict[str, NDArray[Any]]]:
    """Columns of the tables of several parts of one kind, a row for each, by what they are of."""
    found = {}
    for key, value in values.items():
        if not (isinstance(value, tuple | list) and value and is_dataclass(value[0])):
            continue
        schema = schema_of(value[0], said)
        rows = [facts(_extents(named_fields(one)), schema) for one in value]
        names = [name for name in rows[0] if all(name in row for row in rows)]
        found[key] = {
            name.replace(" ", "_"): np.array([row[name] for row in rows]) for name in names
        }
    return found


#: Results whose columns are being made from others of them, by identity.
_MAKING: ContextVar[frozenset[int]] = ContextVar("_MAKING", default=frozenset())


def following(thing: Tabular) -> dict[str, Any]:
    """Columns of a result that follow from what it holds; none while one of them is made."""
    model, making = thing._of_model, _MAKING.get()
    ours = [each for each in thing.schema if each.of is not None]
    if not ours or id(thing) in making:
        return {}
    token = _MAKING.set(making | {id(thing)})
    try:
        return {
            each.name if model is None else own_name(model, each.name): each.value(thing)
            for each in ours
        }
    finally:
        _MAKING.reset(token)


# ------------------------------------------------------------------------------------------------
# the parts of tables


def counted(number: int, one: str, many: str) -> str:
    """Number with its noun."""
    return f"{number} {one if number == 1 else many}"


def not_all(found: Any) -> str:
    """Why a result is not complete."""
    return "" if found.complete else f"; not complete: {'; '.join(found.remarks)}"


def caption(said: Schema, name: str, single: Mapping[str, Any], size: str) -> str:
    """Caption of a result: its name, the numbers in it, and how many rows there are."""
    return ", ".join(
        [
            name,
            *(f"{said.heading(key)} = {said.cell(key, value)}" for key, value in single.items()),
            size,
        ]
    )


def in_rows(
    title: str, said: Schema, count: int, columns: Callable[[IntArray], Mapping[str, Any]]
) -> Table:
    """A row for each of so many things, the first and the last ones of many; ``columns`` are those
    of some rows, by name.
    """
    # Most rows that a table shows; of a longer table it shows the first and the last ones.
    most_rows = 20
    some, half = np.arange(count), most_rows // 2
    taken = columns(some if count <= most_rows else np.delete(some, slice(half, -half)))
    rows = [tuple(map(said.cell, taken, row)) for row in zip(*taken.values(), strict=True)]
    if count > most_rows:
        rows.insert(half, ("…",) * len(taken))
    return Table(title, tuple(map(said.heading, taken)), tuple(rows))


def points(places: Sequence[IntArray]) -> dict[str, list[str]]:
    """A column that says where in an array rows are of; none for an array of no axis."""
    if places:
        return {"point": [", ".join(map(str, index)) for index in zip(*places, strict=True)]}
    return {}


def named_fields(thing: Any) -> dict[str, Any]:
    """Fields by name; in place of a mapping of arrays its items, broadcast to one shape."""
    out: dict[str, Any] = {}
    ours = {each.name for each in fields(thing)}
    for each in fields(thing):
        value = getattr(thing, each.name)
        # Private attributes are not shown, columns that are held in a mapping are; how a result was
        # computed stands in its fields, what was found in its table.
        if (not each.repr and each.name != getattr(thing, "_held", "")) or isinstance(
            value, Options
        ):
            continue
        if isinstance(value, Mapping):
            shape = np.broadcast_shapes(*(np.shape(part) for part in value.values()))
            ends = ("before", "after", "change", "jump")
            end = f"_{each.name}" if each.name in ends else ""
            items = {
                f"{key}{end}": np.broadcast_to(part, shape) if np.size(part) > 1 else part
                for key, part in value.items()
            }
            for name in ours & items.keys() & out.keys():
                out[f"{name}_"] = out.pop(name)
            out |= items
        elif value is not None:
            out[each.name] = value
    return out


def _columns(title: str, columns: Mapping[str, Any], shape: tuple[int, ...], said: Schema) -> Table:
    used = {
        key: value
        for key, value in columns.items()
        if value.dtype.kind != "U" or (value != "").any()
    }

    def taken(some: IntArray) -> dict[str, Any]:
        places = np.unravel_index(some, shape)
        return {
            **points(places if len(shape) > 1 else ()),
            **{key: value[places] for key, value in used.items()},
        }

    return in_rows(title, said, math.prod(shape), taken)


def _sequence(key: str, things: Sequence[Any], above: Schema) -> Iterator[Table]:
    """A row for each of several parts of one kind, arrays by their extremes."""
    if not things:
        yield Table(f"{key}: none")
        return
    rows = [
        _extents(named_fields(thing)) if is_dataclass(thing) else {" ": thing} for thing in things
    ]
    yield in_rows(
        key,
        schema_of(things[0], above),
        len(rows),
        lambda some: {
            "": map(str, some),
            **{name: [rows[i].get(name, "") for i in some] for name in rows[0]},
        },
    )


def _extents(values: Mapping[str, Any]) -> dict[str, Any]:
    """The fields, each array by its smallest and its largest value."""
    out: dict[str, Any] = {}
    for key, value in values.items():
        if not isinstance(value, np.ndarray) or not value.ndim:
            out[key] = value
        elif value.dtype.kind in "USO":
            out[key] = ", ".join(dict.fromkeys(map(str, value.ravel())))
        else:
            out |= {
                f"{key} from": value.min() if value.size else np.inf,
                f"{key} to": value.max() if value.size else -np.inf,
            }
    return out


def _is_single(value: object) -> bool:
    """Whether something fits on the line above a table."""
    match value:
        case np.ndarray():
            return value.ndim == 0
        case tuple() if value and all(isinstance(part, float) for part in value):
            return True
        case str() | Tabular(in_a_line=True):
            return True
    return not is_dataclass(value) and not isinstance(value, Sequence)


def _size(shape: tuple[int, ...]) -> str:
    if len(shape) == 1:
        return counted(shape[0], "row", "rows")
    return f"{' × '.join(map(str, shape))} points"


# ------------------------------------------------------------------------------------------------
# as HTML, as text


def as_html(table: Table) -> str:
    """A table as a notebook shows it."""
    if not table.header:
        return f"<p>{html_text(table.title)}</p>"
    head = "".join(f"<th>{html_text(name)}</th>" for name in table.header)
    body = "".join(
        f"<tr>{''.join(f'<td>{html_text(cell)}</td>' for cell in row)}</tr>" for row in table.rows
    )
    caption = f"<caption>{html_text(table.title)}</caption>"
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def text(table: Table) -> str:
    """A table in columns, as it is printed."""
    return "\n".join([table.title, *aligned([table.header, *table.rows])])


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows as lines, each column as wide as its longest cell; a row without cells gives no line."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows if row]
