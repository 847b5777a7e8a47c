"""Printed matrices, entry by entry: their algebra makes trees, and evaluates nothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeAlias

from .tree import ONE, ZERO, Equation, Node, Unread


@dataclass(frozen=True)
class Matrix:
    """Entries of a printed matrix or vector, row by row."""

    rows: tuple[tuple[Node, ...], ...]


Value: TypeAlias = Node | Matrix


def entry_name(name: str, shape: tuple[int, int], i: int, j: int) -> str:
    """The name of an entry: D_12 of a matrix, b_1 of a vector."""
    return f"{name}_{i + 1}" if shape[1] == 1 else f"{name}_{i + 1}{j + 1}"


def named(node: Node, shape: tuple[int, int]) -> Matrix:
    """The matrix that a name stands for, by the names of its entries."""
    rows, columns = shape
    return Matrix(
        tuple(
            tuple(replace(node, value=entry_name(node.value, shape, i, j)) for j in range(columns))
            for i in range(rows)
        )
    )


def identity(size: int) -> Matrix:
    """The identity matrix."""
    return Matrix(tuple(tuple(ONE if i == j else ZERO for j in range(size)) for i in range(size)))


def node_of(value: Value) -> Node:
    """A number, or the one entry of a matrix."""
    if isinstance(value, Matrix):
        if len(value.rows) == 1 == len(value.rows[0]):
            return value.rows[0][0]
        raise Unread("a matrix where a number has to stand", value.rows[0][0].at[0])
    return value


def each(matrix: Matrix, do: Callable[[Node], Node]) -> Matrix:
    """A matrix with every entry replaced."""
    return Matrix(tuple(tuple(map(do, row)) for row in matrix.rows))


def quotient(above: Value, below: Node) -> Value:
    """A number or a matrix over a number."""
    if isinstance(above, Matrix):
        return each(above, lambda it: Node("div", (it, below), at=it.at))
    return Node("div", (above, below), at=(above.at[0], below.at[1]))


def negative(value: Value, start: int) -> Value:
    """A value with a minus before it."""
    if isinstance(value, Matrix):
        return each(value, lambda it: it if it is ZERO else Node("neg", (it,), at=it.at))
    return Node("neg", (value,), at=(start, value.at[1]))


def total(terms: list[Value], place: int) -> Value:
    """A sum of numbers, or of matrices of one shape."""
    nodes = [it for it in terms if isinstance(it, Node)]
    if len(nodes) == len(terms):
        nodes = [it for it in nodes if it is not ZERO] or [ZERO]
        if len(nodes) == 1:
            return nodes[0]
        return Node("add", tuple(nodes), at=(nodes[0].at[0], nodes[-1].at[1]))
    matrices = [it for it in terms if isinstance(it, Matrix)]
    if nodes or len({(len(it.rows), len(it.rows[0])) for it in matrices}) > 1:
        raise Unread("terms of different shapes", place)
    rows = zip(*(it.rows for it in matrices), strict=True)
    return Matrix(
        tuple(
            tuple(node_of(total([*cells], place)) for cells in zip(*row, strict=True))
            for row in rows
        )
    )


def product(values: list[Value]) -> Value:
    """A product, from the left."""
    nodes = [it for it in values if isinstance(it, Node)]
    if len(nodes) == len(values):
        if any(it is ZERO for it in nodes):
            return ZERO
        nodes = [it for it in nodes if it is not ONE] or [ONE]
        if len(nodes) == 1:
            return nodes[0]
        return Node("mul", tuple(nodes), at=(nodes[0].at[0], nodes[-1].at[1]))
    if len(values) == 1:
        return values[0]
    *before, last = values
    one = product(before)
    if isinstance(one, Matrix) and isinstance(last, Matrix):
        if len(one.rows[0]) != len(last.rows):
            raise Unread("matrices whose sizes do not fit", one.rows[0][0].at[0])
        columns = list(zip(*last.rows, strict=True))
        return Matrix(tuple(tuple(_dot(row, column) for column in columns) for row in one.rows))
    if isinstance(one, Matrix):
        return each(one, lambda it: node_of(product([it, last])))
    assert isinstance(last, Matrix)
    return each(last, lambda it: node_of(product([one, it])))


def _dot(row: tuple[Node, ...], column: tuple[Node, ...]) -> Node:
    return node_of(total([product([a, b]) for a, b in zip(row, column, strict=True)], 0))


def determinant(matrix: Matrix) -> Node:
    """The determinant of a square matrix, expanded by its first row."""
    if len(matrix.rows) != len(matrix.rows[0]):
        raise Unread("the determinant of a matrix that is not square", matrix.rows[0][0].at[0])
    if len(matrix.rows) == 1:
        return matrix.rows[0][0]
    terms = [
        _signed(product([entry, _minor(matrix, 0, j)]), j) for j, entry in enumerate(matrix.rows[0])
    ]
    return node_of(total(terms, 0))


def inverse(matrix: Matrix) -> Matrix:
    """The inverse of a square matrix, by cofactors."""
    size, whole = range(len(matrix.rows)), determinant(matrix)
    return Matrix(
        tuple(
            tuple(Node("div", (node_of(_signed(_minor(matrix, j, i), i + j)), whole)) for j in size)
            for i in size
        )
    )


def _minor(matrix: Matrix, i: int, j: int) -> Node:
    rows = (row for place, row in enumerate(matrix.rows) if place != i)
    less = tuple(row[:j] + row[j + 1 :] for row in rows)
    return determinant(Matrix(less)) if less else ONE


def _signed(value: Value, place: int) -> Value:
    return negative(value, 0) if place % 2 and value is not ZERO else value


def paired(left: Value, right: Value, place: int) -> list[Equation]:
    """Equations of two sides, entry by entry; a name stands for the matrix on the other side."""
    if isinstance(left, Node) and isinstance(right, Node):
        return [Equation(left, right)]
    shape = right if isinstance(right, Matrix) else left
    assert isinstance(shape, Matrix)
    size = len(shape.rows), len(shape.rows[0])
    sides = [_shaped(side, size, place) for side in (left, right)]
    cells = (zip(*rows, strict=True) for rows in zip(*(it.rows for it in sides), strict=True))
    return [Equation(*pair) for row in cells for pair in row]


def _shaped(side: Value, size: tuple[int, int], place: int) -> Matrix:
    if isinstance(side, Matrix):
        if (len(side.rows), len(side.rows[0])) != size:
            raise Unread("sides of different shapes", place)
        return side
    if side.kind == "symbol":
        return named(side, size)
    if side.kind == "number" and side.value == "0":
        return Matrix(((side,) * size[1],) * size[0])
    raise Unread("a matrix and a number are not equal", place)
