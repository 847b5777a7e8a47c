"""Matrices as Abaqus, Ansys, Nastran and MATLAB write them, read from their text or bytes."""

from __future__ import annotations

import re
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array, diags_array

from ..numerics.interval_arrays import FloatArray

#: A node and the number of a degree of freedom there.
Label: TypeAlias = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Labelled:
    """A matrix whose rows and columns are degrees of freedom of nodes, in this order."""

    matrix: csr_array
    dofs: tuple[Label, ...]

    def over(self, places: Mapping[Any, int]) -> csr_array:
        """The same in the rows that ``places`` gives each degree of freedom."""
        own = self.matrix.tocoo()
        at = np.array([places[one] for one in self.dofs])
        return csr_array((own.data, (at[own.row], at[own.col])), shape=(len(places),) * 2)

    def __mul__(self, factor: float) -> Labelled:
        return Labelled(self.matrix * factor, self.dofs)


def abaqus(text: str) -> Labelled:
    """``*MATRIX OUTPUT, FORMAT=MATRIX INPUT``: lines of node, dof, node, dof, value.

    If no element has a twin on the other side of the diagonal, it stands for both, as
    ``*MATRIX INPUT`` has it, unless a line says ``TYPE=UNSYMMETRIC``.
    """
    entries, symmetric = dict[tuple[Label, Label], float](), True
    for line in text.splitlines():
        if line.startswith("*"):
            symmetric &= "UNSYMM" not in line.upper()
        elif line.strip():
            a, b, c, d, value = line.rstrip(" ,").split(",")
            pair = (int(a), int(b)), (int(c), int(d))
            if pair in entries:
                raise ValueError(f"{line.strip()!r} is there twice")
            entries[pair] = _float(value)
    twins = any(row != column and (column, row) in entries for row, column in entries)
    return _labelled(entries, symmetric and not twins)


def _labelled(entries: dict[tuple[Label, Label], float], symmetric: bool) -> Labelled:
    if symmetric:
        for (row, column), value in list(entries.items()):
            other = entries.setdefault((column, row), value)
            if other != value:
                raise ValueError(f"it is symmetric, but not in {row}, {column}")
    dofs = tuple(sorted({one for pair in entries for one in pair}))
    places = {one: index for index, one in enumerate(dofs)}
    at = np.array([(places[row], places[column]) for row, column in entries]).reshape(-1, 2)
    values = np.array([*entries.values()], dtype=float)
    return Labelled(csr_array((values, (at[:, 0], at[:, 1])), shape=(len(dofs),) * 2), dofs)


def _float(text: str) -> float:
    """A number as Fortran and Nastran write it: 1.5D+3, 1.5+3."""
    plain = re.sub(r"(?<=[\d.])([+-])(?=\d)", r"E\1", text.strip().upper().replace("D", "E"))
    value = float(plain)
    if not np.isfinite(value):
        raise ValueError(f"{text.strip()!r} is not finite")
    return value


def bulk(text: str) -> dict[str, Labelled]:
    """All matrices of ``DMIG`` entries of bulk data or of a punch file, by name."""
    heads, entries = dict[str, int](), dict[str, dict[tuple[Label, Label], float]]()
    for fields in _entries(text):
        name = fields[0]
        if fields[1] == "0":
            form, kind = int(fields[2]), int(fields[3])
            if kind not in (1, 2) or form not in (1, 6):
                raise ValueError(
                    f"DMIG {name} has the form {form} and the type {kind}; real square ones have "
                    "1 or 6, and 1 or 2"
                )
            heads[name], entries[name] = form, {}
            continue
        if name not in heads:
            raise ValueError(f"DMIG {name} has columns before its header, whose next field is 0")
        column = (int(fields[1]), int(fields[2] or 0))
        for row, number, value in zip(fields[4::4], fields[5::4], fields[6::4], strict=False):
            if row:
                pair = (int(row), int(number or 0)), column
                if pair in entries[name]:
                    raise ValueError(f"DMIG {name} has the element {pair} twice")
                entries[name][pair] = _float(value)
    return {name: _labelled(held, heads[name] == 6) for name, held in entries.items()}


def _entries(text: str) -> Iterator[list[str]]:
    """The fields of each DMIG entry behind its name, those of its continuations included."""
    fields: list[str] = []
    within = False
    for line in text.splitlines():
        line = line.partition("$")[0].expandtabs(8).rstrip()
        if not line:
            continue
        head = line.partition(",")[0] if "," in line else line[:8]
        word = head.strip().upper()
        if word.startswith(("+", "*")) or not word:
            if within:
                fields += _fields(line)
            continue
        if within:
            yield fields
        within = word.rstrip("*") == "DMIG"
        fields = _fields(line) if within else []
    if within:
        yield fields


def _fields(line: str) -> list[str]:
    """The fields of a line but for its first and its last: four of 16, or eight of 8 characters, or
    between commas; four or eight.
    """
    wide = "*" in line[:8]
    count, width = (4, 16) if wide else (8, 8)
    if "," in line:
        found = line.split(",")[1 : count + 1]
    else:
        found = [line[8 + width * i : 8 + width * (i + 1)] for i in range(count)]
    found += [""] * (count - len(found))
    return [one.strip().upper() for one in found]


def output4(text: str) -> dict[str, csr_array]:
    """All matrices of Nastran's OUTPUT4 with ``FORM=FORMATTED``, by name: dense, sparse, and
    ``BIGMAT``.
    """
    lines, found = iter(text.splitlines()), dict[str, csr_array]()
    for head in lines:
        if not head.strip():
            continue
        columns, rows, _, kind = (int(head[8 * i : 8 * (i + 1)]) for i in range(4))
        name = head[32:40].strip()
        layout = re.fullmatch(r"(?:1P,?)?(\d+)[ED](\d+)\.\d+(?:E\d)?", head[40:].strip())
        if kind not in (1, 2) or not layout:
            raise ValueError(f"{name} has the type {kind} and the format {head[40:].strip()!r}")
        a_line, width = int(layout[1]), int(layout[2])
        entries = list[tuple[int, int, list[float]]]()
        while True:
            column, row, words = _integers(next(lines), 3)
            if column > columns:
                next(lines, None)
                break
            if row:
                entries.append((column, row, _values(lines, words, a_line, width)))
                continue
            while words > 0:  # strings of a sparse column
                first = next(lines)
                if rows < 0 or rows >= 65536:
                    length, row = _integers(first, 2)
                    words -= length + 1
                    length -= 1
                else:
                    length, row = divmod(int(first), 65536)
                    length -= 1
                    words -= length + 1
                entries.append((column, row, _values(lines, length // kind, a_line, width)))
        found[name] = _of_columns(entries, (abs(rows), columns))
    return found


def _integers(line: str, count: int) -> list[int]:
    return [int(line[8 * i : 8 * (i + 1)]) for i in range(count)]


def _values(lines: Iterator[str], count: int, a_line: int, width: int) -> list[float]:
    """Numbers of a fixed width, so many a line; or with spaces between, as SciPy writes them."""
    values: list[float] = []
    while len(values) < count:
        line = next(lines)
        here, words = min(a_line, count - len(values)), line.split()
        if len(words) != here:
            words = [line[width * i : width * (i + 1)] for i in range(here)]
        values += map(_float, words)
    return values


def _of_columns(
    entries: Sequence[tuple[int, int, list[float]]], shape: tuple[int, int]
) -> csr_array:
    """A matrix of columns from 1, of values from a row, from 1, on."""
    rows = [row - 1 + i for _, row, values in entries for i in range(len(values))]
    columns = [column - 1 for column, _, values in entries for _ in values]
    data = np.array([one for *_, values in entries for one in values], dtype=float)
    if rows and not (0 <= min(rows) and max(rows) < shape[0] and min(columns) >= 0):
        raise ValueError(f"an element lies beyond the shape {shape}")
    return coo_array((data, (rows, columns)), shape=shape).tocsr()


def harwell_boeing(text: str) -> csr_array:
    """Harwell-Boeing, as Ansys' ``HBMAT`` writes it: real, assembled, square, of any symmetry; its
    right-hand sides are left out.
    """
    lines = iter(text.splitlines())
    next(lines)
    sides = next(lines)[56:70].strip()
    about = next(lines)
    kind, (rows, columns, count) = about[:3].upper(), map(int, about[14:56].split())
    if not re.fullmatch("[RI][SUZ]A", kind) or rows != columns:
        raise ValueError(f"it is of the type {kind} with {rows} rows and {columns} columns")
    layouts = next(lines)
    if sides and int(sides):
        next(lines)
    parts = list[FloatArray]()
    for place, wanted in ((slice(16), columns + 1), (slice(16, 32), count), (slice(32, 52), count)):
        layout = re.fullmatch(r"\((?:1P,?)?(\d*)[IEDFG](\d+).*\)", layouts[place].strip().upper())
        if not layout:
            raise ValueError(f"the format {layouts[place].strip()!r} is not known")
        parts.append(np.array(_values(lines, wanted, int(layout[1] or 1), int(layout[2]))))
    starts, at = (np.array(one, dtype=np.int64) - 1 for one in parts[:2])
    if starts[0] != 0 or starts[-1] != count or (np.diff(starts) < 0).any():
        raise ValueError("the pointers of its columns do not fit its number of elements")
    if count and not (at.min() >= 0 and at.max() < rows):
        raise ValueError(f"a row lies beyond the {rows} rows")
    own = csc_array((parts[2], at, starts), shape=(rows, columns))
    return _mirrored(own, {"U": 0.0, "S": 1.0, "Z": -1.0}[kind[1]])


def _mirrored(own: Any, sign: float) -> csr_array:
    """A sparse matrix with the other side of its diagonal, times a sign; 0 if it has it."""
    mirror = sign * (own - diags_array(own.diagonal())).T
    return csr_array(own + mirror if sign else own)


def matrix_market(text: str) -> csr_array:
    """MatrixMarket: real numbers or integers, of any symmetry. SciPy 1.17 reads beyond the last
    line if that is damaged, and ends the process.
    """
    head, *lines = (line for line in text.splitlines() if line.strip())
    _, _, layout, field, symmetry = head.lower().split()
    sign = {"general": 0.0, "symmetric": 1.0, "skew-symmetric": -1.0}.get(symmetry)
    if layout not in ("coordinate", "array") or field not in ("real", "integer") or sign is None:
        raise ValueError(f"{head!r} is not read")
    sizes, *rest = (line for line in lines if not line.startswith("%"))
    rows, columns, *count = map(int, sizes.split())
    numbers = np.array([*map(_float, " ".join(rest).split())])
    if count:
        at, values = np.split(numbers.reshape(count[0], 3), [2], axis=1)
        own = coo_array((values[:, 0], (at.astype(np.int64) - 1).T), shape=(rows, columns))
        return _mirrored(own, sign)
    dense = np.zeros((columns, rows))  # each column after the other
    dense[np.triu_indices(rows, k=int(sign < 0)) if sign else ...] = (
        numbers if sign else numbers.reshape(columns, rows)
    )
    return _mirrored(csr_array(dense.T), sign)


def mapping(text: str) -> tuple[Label, ...]:
    """The degrees of freedom of the equations in their order, of the file ``.mapping`` that Ansys
    writes beside a matrix: lines of equation, node, and UX, UY, UZ, ROTX, ROTY, ROTZ.
    """
    found = dict[int, Label]()
    names = ("UX", "UY", "UZ", "ROTX", "ROTY", "ROTZ")
    for line in text.splitlines()[1:]:
        if line.strip():
            equation, node, name = line.split()
            found[int(equation)] = int(node), names.index(name.upper()) + 1
    if sorted(found) != [*range(1, len(found) + 1)] or len({*found.values()}) < len(found):
        raise ValueError("the equations are not 1, 2, …, each with a degree of freedom of its own")
    return tuple(found[one] for one in sorted(found))


#: NumPy's codes of MATLAB's types of numbers.
_CODES = {
    1: "i1",
    2: "u1",
    3: "i2",
    4: "u2",
    5: "i4",
    6: "u4",
    7: "f4",
    9: "f8",
    12: "i8",
    13: "u8",
}


def matlab(data: bytes, largest: int) -> dict[str, Any]:
    """All real matrices of a file of MATLAB's level 5, as ``-v6`` and ``-v7`` write it, by name;
    ``largest`` are bytes of one that is unpacked.

    SciPy 1.17 reads beyond its tables, and ends the process, where a tag is damaged.
    """
    order = {b"\x00\x01IM": "<", b"\x01\x00MI": ">"}.get(data[124:128])
    if order is None:
        raise ValueError("it is of another level than 5; save it with -v7")
    found = dict[str, Any]()
    for kind, body in _elements(data[128:], order):
        whole = body
        if kind == 15:
            whole = zlib.decompressobj().decompress(body, largest)
            kind, whole = next(_elements(whole, order))
        if kind == 14:
            found |= _of_matlab(list(_elements(whole, order)), order)
    return found


def _elements(block: bytes, order: str) -> Iterator[tuple[int, bytes]]:
    """Type and bytes of each element of a block."""
    at = 0
    while at < len(block):
        kind, size = struct.unpack_from(f"{order}II", block, at)
        at += 8
        if kind >> 16:
            kind, size = kind & 0xFFFF, kind >> 16
            yield kind, block[at - 4 :][: min(size, 4)]
            continue
        if at + size > len(block):
            raise ValueError("it ends too early")
        yield kind, block[at : at + size]
        at += size if kind == 15 else size + -size % 8


def _of_matlab(parts: Sequence[tuple[int, bytes]], order: str) -> dict[str, Any]:
    """A variable by its name, if it is a real matrix."""
    flags = struct.unpack_from(f"{order}I", parts[0][1])[0]
    if not 5 <= flags & 0xFF <= 15 or flags & 0x800:
        return {}
    name = parts[2][1].decode("ascii")
    rest = [np.frombuffer(one, order + _CODES[kind]) for kind, one in (parts[1], *parts[3:])]
    shape = tuple(map(int, rest[0]))
    if flags & 0xFF > 5:
        return {name: rest[1].reshape(shape, order="F")}
    at, starts, values = rest[1:4]
    count = int(starts[-1])
    own = csc_array((values[:count].astype(float), at[:count], starts), shape=shape)
    own.check_format(full_check=True)
    return {name: own}
