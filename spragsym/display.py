"""Results as tables, for notebooks and for ``print``: angles in degrees, under names that end in ``_deg``."""

from __future__ import annotations

import enum
import html
import importlib
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np

from .exact.decimals import upward

#: Longer arrays and tuples stand in ``repr`` by their shapes.
WHOLE = 6
#: Most rows that a table shows; of a longer table it shows the first and the last ones.
ROWS = 20

#: Angles among the names that do not begin with ``theta``.
_ANGLES = {"poles", "width"}

#: Column of codes → module and enumeration that says what they mean.
_CODES = {
    "undamped": ("results", "Stability"),
    "stability": ("results", "Stability"),
    "regime": ("sweeps", "Regime"),
    "which": ("dynamics", "Event"),
}


@dataclass(frozen=True)
class Table:
    """Rows of text under names, and a line above them."""

    title: str
    header: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


class Shown:
    """Gives a dataclass a table in a notebook."""

    def _repr_html_(self) -> str:
        return "\n".join(_html(table) for table in tables(self))


class Result(Shown):
    """A result: ``print`` gives its table as well; ``repr`` is that of the dataclass, long arrays by their shapes."""

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "__repr__" not in cls.__dict__:
            # In the class itself, so that the dataclass of it makes no other.
            cls.__repr__ = _short  # type: ignore[method-assign]

    def __str__(self) -> str:
        return "\n\n".join(_text(table) for table in tables(self))


def _short(result: Any) -> str:
    """The dataclass's own text, but for what would fill pages."""
    given = ((field.name, getattr(result, field.name)) for field in fields(result) if field.repr)
    return f"{type(result).__name__}({', '.join(f'{name}={_named(value)}' for name, value in given)})"


def _named(value: Any) -> str:
    if isinstance(value, np.ndarray) and value.size > WHOLE:
        return f"array{value.shape}"
    if isinstance(value, tuple | list) and len(value) > WHOLE:
        return f"({len(value)} of {type(value[0]).__name__})"
    return " ".join(repr(value).split())


def tables(thing: Any) -> Iterator[Table]:
    """The tables of a dataclass: one of its columns, and one of each part that has columns itself."""
    if hasattr(thing, "as_table"):  # one whose columns are no quantities
        yield thing.as_table()
        return
    name = type(thing).__name__
    if name in _KINDS:
        yield _KINDS[name](thing)
        return
    values = _fields(thing)
    if isinstance(values.get("undecided"), np.ndarray):
        values["undecided"] = _counted(len(values["undecided"]), "box", "boxes")
    if name == "Events":
        states = values.pop("state").T
        numbered = tuple(f"state_{i + 1}" for i in range(len(states)))
        values |= zip({2: ("x", "vx"), 4: ("x", "y", "vx", "vy")}.get(len(states), numbered), states, strict=True)
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
    arrays = {key: value for key, value in values.items() if isinstance(value, np.ndarray) and value.ndim}
    shape = max((value.shape for key, value in arrays.items() if key not in _ANGLES), key=math.prod, default=())
    columns = {key: value for key, value in arrays.items() if value.shape == shape}
    single |= {key: _listed(key, value) for key, value in arrays.items() if value.shape != shape}
    if columns:
        yield _columns(_title(name, single, _size(shape)), columns, shape)
    elif single:
        yield Table(name, *_pairs(single))
    for key, value in values.items():
        if is_dataclass(value) and not _is_single(value):
            yield from _parts(key, tables(value))
        elif isinstance(value, Sequence) and not isinstance(value, str):
            yield from _sequence(key, value, values.get("vary", "value"))


# ----------------------------------------------------------------------------------------------- kinds of results


def _equilibria(eq: Any) -> Table:
    """A row for each equilibrium, with the parameters that vary over the points."""
    p, shape = eq.parameters, eq.count.shape
    every = eq.states
    shown, cut = _shown(every[0].size)
    states = tuple(part[shown] for part in every)
    vary = [key for key, value in _fields(p).items() if value is not None and value.size > 1]
    kinds, growth = eq.told(states)
    columns = {"stability": kinds, "undamped": eq.stability[states]}
    columns |= {name: getattr(eq, name)[states] for name in eq.columns} | {"growth": growth, "error": eq.error[states]}
    rows = []
    for row, slot in enumerate(zip(*states, strict=True)):
        place = tuple(int(i) for i in slot[:-1])
        given = [_cell(key, np.broadcast_to(getattr(p, key), p.shape)[place]) for key in vary]
        rows.append((
            *([_index(place)] if shape else []), *given,
            *(f"{values[row]:.1e}" if key == "growth" else _cell(key, values[row]) for key, values in columns.items()),
        ))  # fmt: skip
    where = {"sliding": "of sliding", "rest": "at rest"}.get(eq.regime, f"in {eq.regime}")
    number = _counted(every[0].size, "equilibrium", "equilibria")
    title = f"{number} {where}" + (f" of {math.prod(shape)} points" if shape else "")
    header = (*(["point"] if shape else []), *map(_heading, (*vary, *columns)))
    return _with_cut(title + _not_all(eq), header, rows, cut)


def _counted(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"


def _not_all(found: Any) -> str:
    """Why a result is not complete."""
    return "" if found.complete else f"; not complete: {'; '.join(found.remarks)}"


def _points(found: Any) -> Table:
    """A row for each point: the parameters that vary, the state, what ends there or begins, and what else is known of it."""
    columns = {name: getattr(found, name) for name in (*found.vary, *found.columns)}
    if hasattr(found, "criticality"):
        more = ("omega", "branch", "count", "side")
        columns |= {name: getattr(found, name) for name in more if hasattr(found, name)}
        columns |= {"kind": found.kind, "criticality": found.criticality}
    else:
        columns["kind"] = found.kind
    if "fold" in found.kind:
        columns |= {"ends": found.ends, "when": found.when} | {f"{name}_after": column for name, column in found.after.items()}
    columns["error"] = found.error
    rows = [tuple(_cell(name, column[row]) for name, column in columns.items()) for row in range(len(found))]
    shown, cut = _shown(len(rows))
    ends = found.region[-len(found.vary) :].tolist()
    spans = (
        f"{_heading(name)} from {_cell(name, low)} to {_cell(name, high)}"
        for name, (low, high) in zip(found.vary, ends, strict=True)
    )
    title = f"{_counted(len(found), 'point', 'points')} along {', '.join(spans)}{_not_all(found)}"
    return _with_cut(title, tuple(map(_heading, columns)), [rows[i] for i in shown], cut)


def _trajectory(tr: Any) -> Table:
    """First, smallest, largest and last value of each coordinate, in place of all samples."""
    rows = [
        (key, *(_cell(key, value) for value in (values[0], values.min(), values.max(), values[-1])))
        for key, values in ((key, getattr(tr, key)) for key in tr.components)
    ]
    known = {key: value for key, value in _fields(tr).items() if _is_single(value)}
    events = {} if tr.events is None else {"events": len(tr.events)}
    title = _title(f"Trajectory, t = {_cell('t', tr.t[0])} to {_cell('t', tr.t[-1])}", known | events, f"{len(tr.t)} samples")
    return Table(title, ("", "first", "smallest", "largest", "last"), tuple(rows))


#: Results with a table of their own.
_KINDS = {
    "Equilibria": _equilibria,
    "Points": _points,
    "Onsets": _points,
    "Trajectory": _trajectory,
}


def _columns(title: str, columns: Mapping[str, Any], shape: tuple[int, ...]) -> Table:
    shown, cut = _shown(math.prod(shape))
    used = {key: value for key, value in columns.items() if value.dtype.kind != "U" or (value != "").any()}
    header = (*(["point"] if len(shape) > 1 else []), *map(_heading, used))
    rows = []
    for row in shown:
        place = tuple(int(i) for i in np.unravel_index(row, shape))
        rows.append((*([_index(place)] if len(shape) > 1 else []), *(_cell(key, value[place]) for key, value in used.items())))
    return _with_cut(title, header, rows, cut)


def _sequence(key: str, things: Sequence[Any], vary: str) -> Iterator[Table]:
    """A row for each of several parts of one kind, arrays by their extremes; the field ``value`` is headed ``vary``."""
    if not things:
        yield Table(f"{key}: none")
        return
    rows = [_renamed(_extents(_fields(thing)), vary) if is_dataclass(thing) else {"": thing} for thing in things]
    shown, cut = _shown(len(rows))
    header = ("", *map(_heading, rows[0]))
    body = [(str(i), *(_cell(name, value) for name, value in rows[i].items())) for i in shown]
    yield _with_cut(key, header, body, cut)


def _extents(values: Mapping[str, Any]) -> dict[str, Any]:
    """The fields, each array by its smallest and its largest value."""
    out: dict[str, Any] = {}
    for key, value in values.items():
        if isinstance(value, np.ndarray) and value.ndim:
            out |= {f"{key} from": value.min() if value.size else np.inf, f"{key} to": value.max() if value.size else -np.inf}
        else:
            out[key] = value
    return out


def _renamed(values: Mapping[str, Any], vary: str) -> dict[str, Any]:
    return {vary if key == "value" else key: value for key, value in values.items()}


def _parts(key: str, found: Iterator[Table]) -> Iterator[Table]:
    for table in found:
        yield Table(f"{key}: {table.title}", table.header, table.rows)


# -------------------------------------------------------------------------------------------------- words of them


def _fields(thing: Any) -> dict[str, Any]:
    """Fields by name; in place of a mapping of arrays its items, broadcast to one shape."""
    out: dict[str, Any] = {}
    for field in fields(thing):
        value = getattr(thing, field.name)
        # Private attributes are not shown, columns that are held in a mapping are.
        if not field.repr and field.name != getattr(type(thing), "held_in", None):
            continue
        if isinstance(value, Mapping):
            shape = np.broadcast_shapes(*(np.shape(part) for part in value.values()))
            end = f"_{field.name}" if field.name in ("before", "after") else ""
            out |= {f"{key}{end}": np.broadcast_to(part, shape) if np.size(part) > 1 else part for key, part in value.items()}
        elif value is not None:
            out[field.name] = value
    return out


def _is_single(value: Any) -> bool:
    """Whether something fits on the line above a table."""
    if type(value).__name__ in ("Parameters", "PhysicalParameters"):
        return True
    if isinstance(value, np.ndarray):
        return value.ndim == 0
    return not is_dataclass(value) and (isinstance(value, str) or not isinstance(value, Sequence))


def _title(name: str, single: Mapping[str, Any], size: str) -> str:
    return ", ".join([name, *(f"{_heading(key)} = {_cell(key, value)}" for key, value in single.items()), size])


def _size(shape: tuple[int, ...]) -> str:
    return f"{shape[0]} rows" if len(shape) == 1 else f"{' × '.join(map(str, shape))} points"


def _listed(key: str, values: Any) -> str:
    flat = values.ravel()
    text = ", ".join(_cell(key, value) for value in flat[:8])
    return f"[{text}{', …' if flat.size > 8 else ''}]"


def _pairs(single: Mapping[str, Any]) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
    return ("", "value"), tuple((_heading(key), _cell(key, value)) for key, value in single.items())


def _shown(count: int) -> tuple[list[int], int | None]:
    """Rows to show, and the place of the gap if rows are left out."""
    if count <= ROWS:
        return list(range(count)), None
    half = ROWS // 2
    return [*range(half), *range(count - half, count)], half


def _with_cut(title: str, header: tuple[str, ...], rows: list[tuple[str, ...]], cut: int | None) -> Table:
    if cut is not None:
        rows = [*rows[:cut], ("…",) * len(header), *rows[cut:]]
    return Table(title, header, tuple(rows))


def _is_angle(key: str) -> bool:
    name = key.partition(" ")[0]
    return name in _ANGLES or (name.startswith("theta") and not name.endswith("_deg"))


def _heading(key: str) -> str:
    name, blank, rest = key.partition(" ")
    return f"{name}_deg{blank}{rest}" if _is_angle(key) else key


def _index(place: tuple[int, ...]) -> str:
    return ", ".join(map(str, place))


def _cell(key: str, value: Any) -> str:
    """A number to ten digits, a code as its word."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.item() if value.ndim == 0 else _listed(key, value)
    if isinstance(value, tuple):
        return ", ".join(_cell("", part) for part in value)
    if isinstance(value, str):
        return value
    if isinstance(value, enum.Enum):
        return value.name.lower()
    if key in _CODES:
        module, enumeration = _CODES[key]
        return str(getattr(importlib.import_module(f".{module}", __package__), enumeration)(value).name.lower())
    if not isinstance(value, float):
        return str(value)
    if key == "error":
        return upward(value)
    return f"{math.degrees(value) if _is_angle(key) else value:.10g}"


# ------------------------------------------------------------------------------------------------- as HTML, as text


def _html(table: Table) -> str:
    if not table.header:
        return f"<p>{html.escape(table.title)}</p>"
    head = "".join(f"<th>{html.escape(name)}</th>" for name in table.header)
    body = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in table.rows)
    caption = f"<caption>{html.escape(table.title)}</caption>"
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _text(table: Table) -> str:
    lines = [table.header, *table.rows] if table.header else []
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    body = ("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines)
    return "\n".join([table.title, *body])
