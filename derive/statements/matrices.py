"""Algebra of printed matrices, as NumPy arrays of syntax trees; nothing is evaluated."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from .tree import ONE, ZERO, Equation, Node, Unread, joined, leaf, minus

#: Entries of a printed matrix, or of a vector with one column.
Matrix: TypeAlias = npt.NDArray[np.object_]
Value: TypeAlias = Node | Matrix
Shape: TypeAlias = tuple[int, ...]


def entry_name(name: str, shape: Shape, i: int, j: int) -> str:
    """The name of an entry: D_12 of a matrix, b_1 of a vector."""
    return f"{name}_{i + 1}" if shape[1] == 1 else f"{name}_{i + 1}{j + 1}"


def named(node: Node, shape: Shape) -> Matrix:
    """The matrix of the names of its entries, for the name of a matrix."""
    found = np.empty(shape, object)
    for i, j in np.ndindex(shape):
        found[i, j] = leaf(entry_name(node.value, shape, i, j), node.at)
    return found


def matrix_of(entries: Sequence[str]) -> tuple[str, tuple[int, int]] | None:
    """Name and shape of the matrix whose entries, row by row, have these names; else None."""
    base, count = entries[0].rpartition("_")[0], len(entries)
    for rows in range(1, count + 1) if base and count > 1 else ():
        shape = (rows, count // rows)
        if count % rows == 0 and [*entries] == [
            entry_name(base, shape, i, j) for i, j in np.ndindex(shape)
        ]:
            return base, shape
    return None


def of_blocks(cells: Sequence[Sequence[Value]], place: int) -> Matrix:
    """A matrix from cells that are numbers or blocks; a 0 fills its block."""
    heights = [max((*shape_of(it), 1)[0] for it in row) for row in cells]
    widths = [max((*shape_of(it), 1, 1)[1] for it in column) for column in zip(*cells, strict=True)]

    def filled(it: Value, shape: Shape) -> Matrix:
        if not isinstance(it, Node) and it.shape == shape:
            return it
        if isinstance(it, Node) and (shape == (1, 1) or it.value == "0"):
            return np.full(shape, it)
        raise Unread("blocks whose sizes do not fit", place)

    blocks = []
    for high, row in zip(heights, cells, strict=True):
        blocks.append([filled(it, (high, wide)) for wide, it in zip(widths, row, strict=True)])
    whole: Matrix = np.block(blocks)
    return whole


def identity(size: int) -> Matrix:
    """The identity matrix."""
    return np.array([ZERO, ONE])[np.eye(size, dtype=int)]


def shape_of(value: Value) -> Shape:
    """Rows and columns of a matrix; an empty tuple for a number."""
    return () if isinstance(value, Node) else value.shape


def node_of(value: Value, place: int = 0) -> Node:
    """The tree of a number, or of the entry of a matrix with one entry.

    Raises
    ------
    Unread
        For a larger matrix.
    """
    if isinstance(value, Node):
        return value
    if value.size > 1:
        raise Unread("a matrix where a number has to stand", place)
    entry: Node = value.item(0)
    return entry


def each(do: Callable[..., Value], *values: Value) -> Value:
    """An operation on numbers, or entry by entry on matrices."""
    if all(isinstance(it, Node) for it in values):
        return do(*values)
    found: Matrix = np.frompyfunc(do, len(values), 1)(*values)
    return found


def quotient(above: Value, below: Node) -> Value:
    """A number or a matrix divided by a number."""
    return each(lambda it: Node("div", (it, below), at=it.at), above)


def negative(value: Value) -> Value:
    """A value with a minus before it."""
    return each(lambda it: it if it is ZERO else minus(it), value)


def total(terms: Sequence[Value], place: int) -> Value:
    """A sum of numbers, or of matrices of one shape.

    A matrix of one entry counts as a number beside a number.
    """
    if any(isinstance(it, Node) for it in terms):
        terms = [node_of(it) if shape_of(it) == (1, 1) else it for it in terms]
    shape, *others = set(map(shape_of, terms))
    if others:
        raise Unread("terms of different shapes", place)
    if shape:
        return each(lambda *cells: total(cells, place), *terms)
    return _whole("add", [it for it in terms if it is not ZERO] or [ZERO])


def product(values: Sequence[Value]) -> Value:
    """A product of numbers and matrices, multiplied from the left."""
    *before, last = values
    if all(isinstance(it, Node) for it in values):
        rest = [it for it in values if it is not ONE] or [ONE]
        return ZERO if any(it is ZERO for it in values) else _whole("mul", rest)
    if not before:
        return last
    one = product(before)
    if isinstance(one, Node) or isinstance(last, Node):
        return each(lambda *pair: product(pair), one, last)
    if one.shape[1] != len(last):
        raise Unread("matrices whose sizes do not fit", one[0, 0].at[0])
    pairs = (zip(row, column, strict=True) for row in one for column in last.T)
    cells = [total([*map(product, it)], 0) for it in pairs]
    return np.array(cells).reshape(len(one), -1)


def _whole(kind: str, parts: Sequence[Value]) -> Value:
    return joined(kind, [*map(node_of, parts)])


def determinant(matrix: Matrix) -> Node:
    """The determinant of a square matrix, expanded by its first row."""
    rows, columns = matrix.shape
    if rows != columns:
        raise Unread("the determinant of a matrix that is not square", matrix[0, 0].at[0])
    if rows == 1:
        return node_of(matrix)
    minors = (product((it, _minor(matrix, 0, j))) for j, it in enumerate(matrix[0]))
    return node_of(total([_signed(it, j) for j, it in enumerate(minors)], 0))


def inverse(matrix: Matrix) -> Matrix:
    """The inverse of a square matrix, by cofactors."""
    whole, found = determinant(matrix), np.empty(matrix.shape, object)
    for i, j in np.ndindex(matrix.shape):
        found[i, j] = Node("div", (node_of(_signed(_minor(matrix, j, i), i + j)), whole))
    return found


def _minor(matrix: Matrix, i: int, j: int) -> Node:
    less = np.delete(np.delete(matrix, i, 0), j, 1)
    return determinant(less) if less.size else ONE


def _signed(value: Value, place: int) -> Value:
    return negative(value) if place % 2 and value is not ZERO else value


def paired(left: Value, right: Value, place: int) -> list[Equation]:
    """Equations between the entries of two sides.

    A name or a 0 on one side has the shape of the other side.
    """
    if isinstance(left, Node) and isinstance(right, Node):
        return [Equation(left, right)]
    shape = max(shape_of(left), shape_of(right))
    sides = (_shaped(side, shape, place) for side in (left, right))
    return [Equation(*pair) for pair in zip(*(it.flat for it in sides), strict=True)]


def _shaped(side: Value, shape: tuple[int, ...], place: int) -> Matrix:
    if not isinstance(side, Node):
        if side.shape != shape:
            raise Unread("sides of different shapes", place)
        return side
    if side.kind == "symbol":
        return named(side, shape)
    if side == replace(ZERO, at=side.at):
        return np.full(shape, side)
    raise Unread("a matrix and a number are not equal", place)
