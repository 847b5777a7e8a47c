"""Results as tables, for notebooks and for ``print``: angles in degrees, under names that end in
``_deg``.

A result says by ``table_model``, ``table_angles`` and ``table_codes`` what its columns are, by
``table_values`` which they are, and by ``as_table`` what to show in their place.
"""

from __future__ import annotations

import enum
import html
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from .numerics.interval_arrays import IntArray

#: Columns of the parameter that varies; the first two have its name.
VARIED = ("value", "values", "to", "others")
#: Most rows that a table shows; of a longer table it shows the first and the last ones.
ROWS = 20


@dataclass(frozen=True)
class Table:
    """Rows of text under names, and a line above them."""

    title: str
    header: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


class Shown:
    """Gives a dataclass a table in a notebook."""

    #: The column of codes, and the enumeration that says what they mean.
    table_codes: ClassVar[tuple[str | None, type[enum.IntEnum]]] = (None, enum.IntEnum)
    #: Angles that are no parameters, coordinates or directions of springs.
    table_angles: ClassVar[frozenset[str]] = frozenset()

    @property
    def table_model(self) -> Any:
        """The model that says which columns are angles, its own or that of a part; None where a
        result does not know it.
        """
        parts = (getattr(self, name, None) for name in ("parameters", "sweep"))
        return next(
            (
                known
                for each in (self, *parts)
                if (known := getattr(each, "model", None)) is not None
            ),
            None,
        )

    def table_values(self) -> dict[str, Any]:
        """What stands in the table, by name."""
        return named_fields(self)

    def _repr_html_(self) -> str:
        return "\n".join(map(_html, tables(self)))


@dataclass(frozen=True)
class Words:
    """What a table calls its columns, and how it writes what is in them."""

    known: Callable[[str], bool]  #: whether a parameter, a coordinate, a direction is an angle
    kind: type[Shown] = Shown  #: the class of the result
    vary: str = "value"  #: what ``value`` and ``values`` are of

    def is_angle(self, name: str) -> bool:
        """Whether a column's numbers are radians."""
        return name in self.kind.table_angles or self.known(self.vary if name in VARIED else name)

    def heading(self, key: str) -> str:
        """A column's name, of an angle with its unit."""
        name, blank, rest = key.partition(" ")
        called = self.vary if name in ("value", "values") else name
        return f"{called}{'_deg' if self.is_angle(name) else ''}{blank}{rest}"

    def cell(self, key: str, value: Any) -> str:
        """A number to ten digits, a code as its word."""
        if isinstance(value, np.ndarray | np.generic):
            value = value.item() if value.ndim == 0 else self.listed(key, value)
        if isinstance(value, tuple):
            return ", ".join(self.cell(key, part) for part in value)
        column, code = self.kind.table_codes
        if key == column:
            value = code(value) if value in set(code) else "other"
        if isinstance(value, enum.Enum):
            return value.name.lower()
        if isinstance(value, str):
            return value
        if not isinstance(value, float):
            text = str(value)
            return (
                type(value).__name__ if "\n" in text else text
            )  # the tables of a result stand in no cell
        if key == "error":
            from .numerics.decimals import upward

            return upward(value)
        return f"{math.degrees(value) if self.is_angle(key.partition(' ')[0]) else value:.10g}"

    def listed(self, key: str, values: Any) -> str:
        """The first few numbers of an array."""
        flat = values.ravel()
        text = ", ".join(self.cell(key, value) for value in flat[:8])
        return f"[{text}{', …' if flat.size > 8 else ''}]"


def _by_name(name: str) -> bool:
    """Whether the article's nomenclature calls an angle so."""
    return name.partition("_")[0] in ("theta", "theta0") and not name.endswith("_deg")


#: Table words of a result that is part of no other.
_ALONE = Words(_by_name)


def words(thing: Any, above: Words = _ALONE) -> Words:
    """Table words of a result; a part that does not know its model or its parameter takes those of
    the result ``above``.
    """
    kind = type(thing) if isinstance(thing, Shown) else Shown
    model, vary = (getattr(thing, name, None) for name in ("table_model", "vary"))
    return Words(
        getattr(model, "is_angle", above.known), kind, vary if isinstance(vary, str) else above.vary
    )


def tables(thing: Any, above: Words = _ALONE) -> Iterator[Table]:
    """The tables of a dataclass: one of its columns, and one of each part that has columns
    itself.
    """
    if hasattr(thing, "as_table"):  # one whose rows are not its fields
        yield thing.as_table()
        return
    name, said = type(thing).__name__, words(thing, above)
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
    thing: Any, said: Words
) -> tuple[dict[str, NDArray[Any]], dict[str, Any], dict[str, Any]]:
    """The columns of a dataclass, arrays of its largest shape; what fits on the line above them;
    and all values.
    """
    values = thing.table_values() if isinstance(thing, Shown) else named_fields(thing)
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
        (value.shape for key, value in arrays.items() if key not in said.kind.table_angles),
        key=math.prod,
        default=(),
    )
    columns = {key: value for key, value in arrays.items() if value.shape == shape}
    single |= {
        key: said.listed(key, value) for key, value in arrays.items() if value.shape != shape
    }
    return columns, single, values


# ----------------------------------------------------------------------------------------- what
# tables are made of


def counted(number: int, one: str, many: str) -> str:
    """How many there are."""
    return f"{number} {one if number == 1 else many}"


def not_all(found: Any) -> str:
    """Why a result is not complete."""
    return "" if found.complete else f"; not complete: {'; '.join(found.remarks)}"


def caption(said: Words, name: str, single: Mapping[str, Any], size: str) -> str:
    """What a result is, the numbers in it, and how many rows there are."""
    return ", ".join(
        [
            name,
            *(f"{said.heading(key)} = {said.cell(key, value)}" for key, value in single.items()),
            size,
        ]
    )


def in_rows(
    title: str, said: Words, count: int, columns: Callable[[IntArray], Mapping[str, Any]]
) -> Table:
    """A row for each of so many things, the first and the last ones of many; ``columns`` are those
    of some rows, by name.
    """
    some, half = np.arange(count), ROWS // 2
    taken = columns(some if count <= ROWS else np.delete(some, slice(half, -half)))
    rows = [tuple(map(said.cell, taken, row)) for row in zip(*taken.values(), strict=True)]
    if count > ROWS:
        rows.insert(half, ("…",) * len(taken))
    return Table(title, tuple(map(said.heading, taken)), tuple(rows))


def points(places: Sequence[IntArray]) -> dict[str, list[str]]:
    """A column that says where in an array rows are of; none for an array of no axis."""
    return (
        {"point": [", ".join(map(str, place)) for place in zip(*places, strict=True)]}
        if places
        else {}
    )


def named_fields(thing: Any) -> dict[str, Any]:
    """Fields by name; in place of a mapping of arrays its items, broadcast to one shape."""
    out: dict[str, Any] = {}
    for each in fields(thing):
        value = getattr(thing, each.name)
        # Private attributes are not shown, columns that are held in a mapping are.
        if not each.repr and each.name != getattr(thing, "held_in", ""):
            continue
        if isinstance(value, Mapping):
            shape = np.broadcast_shapes(*(np.shape(part) for part in value.values()))
            end = f"_{each.name}" if each.name in ("before", "after") else ""
            out |= {
                f"{key}{end}": np.broadcast_to(part, shape) if np.size(part) > 1 else part
                for key, part in value.items()
            }
        elif value is not None:
            out[each.name] = value
    return out


def _columns(title: str, columns: Mapping[str, Any], shape: tuple[int, ...], said: Words) -> Table:
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


def _sequence(key: str, things: Sequence[Any], above: Words) -> Iterator[Table]:
    """A row for each of several parts of one kind, arrays by their extremes."""
    if not things:
        yield Table(f"{key}: none")
        return
    rows = [
        _extents(named_fields(thing)) if is_dataclass(thing) else {" ": thing} for thing in things
    ]
    yield in_rows(
        key,
        words(things[0], above),
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


def _is_single(value: Any) -> bool:
    """Whether something fits on the line above a table."""
    if type(value).__name__ in ("Parameters", "PhysicalParameters"):
        return True
    if isinstance(value, np.ndarray):
        return value.ndim == 0
    few = (
        isinstance(value, tuple) and bool(value) and all(isinstance(part, float) for part in value)
    )
    return few or (
        not is_dataclass(value) and (isinstance(value, str) or not isinstance(value, Sequence))
    )


def _size(shape: tuple[int, ...]) -> str:
    return (
        counted(shape[0], "row", "rows")
        if len(shape) == 1
        else f"{' × '.join(map(str, shape))} points"
    )


# ------------------------------------------------------------------------------------------------
# as HTML, as text


def _html(table: Table) -> str:
    if not table.header:
        return f"<p>{html.escape(table.title)}</p>"
    head = "".join(f"<th>{html.escape(name)}</th>" for name in table.header)
    body = "".join(
        f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in table.rows
    )
    caption = f"<caption>{html.escape(table.title)}</caption>"
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def text(table: Table) -> str:
    """A table in columns, as it is printed."""
    return "\n".join([table.title, *aligned([table.header, *table.rows])])


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows as lines, each column as wide as its longest cell; a row without cells gives no line."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows if row]
