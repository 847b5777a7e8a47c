"""Arithmetic of any number type: operators from a sum, a product and a change of sign, complex
numbers, small linear systems, determinants, characteristic polynomials and resultants.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Self, TypeAlias


class Number(Protocol):
    """A number of any type that generated algebra takes: a float, an array, a rational, an
    interval, a ball, an affine number, or a jet of them. What an operation with another one gives
    is up to both.
    """

    def __neg__(self) -> Any: ...
    def __add__(self, other: Any, /) -> Any: ...
    def __radd__(self, other: Any, /) -> Any: ...
    def __sub__(self, other: Any, /) -> Any: ...
    def __rsub__(self, other: Any, /) -> Any: ...
    def __mul__(self, other: Any, /) -> Any: ...
    def __rmul__(self, other: Any, /) -> Any: ...
    def __truediv__(self, other: Any, /) -> Any: ...
    def __pow__(self, power: int, /) -> Any: ...


#: Rows of entries of any number type.
Matrix: TypeAlias = Sequence[Sequence[Any]]


def repeated_product(self: Number, power: int) -> Number:
    """A positive power, one product after the other: the ``__pow__`` of types for which only small
    powers occur.
    """
    result = self
    for _ in range(power - 1):
        result = result * self
    return result


class Arithmetic:
    """A base of number types: operations with what stands on the left, and differences.

    Each type says the first three itself. It is no abstract class: ``isinstance`` of one takes
    three times as long, and stands in every operation.
    """

    __slots__ = ()

    def __neg__(self) -> Self:
        raise NotImplementedError

    def __add__(self, other: Number) -> Self:
        raise NotImplementedError

    def __mul__(self, other: Number) -> Self:
        raise NotImplementedError

    def __pos__(self) -> Self:
        return self

    def __radd__(self, other: Number) -> Self:
        return self.__add__(other)

    def __rmul__(self, other: Number) -> Self:
        return self.__mul__(other)

    def __sub__(self, other: Number) -> Self:
        return self.__add__(-other)

    def __rsub__(self, other: Number) -> Self:
        return (-self).__add__(other)


def determinant(rows: Matrix) -> Any:
    """By the first row; entries of any number type, integers 0 among them."""
    if not rows:
        return 1
    total = 0
    for j, entry in enumerate(rows[0]):
        if not is_zero(entry):
            total = total + entry * cofactor(rows, 0, j)
    return total


def cofactor(rows: Matrix, i: int, j: int) -> Any:
    """Cofactor of the entry in row i and column j: entry (j, i) of the adjugate."""
    minor = determinant(
        [[*row[:j], *row[j + 1 :]] for number, row in enumerate(rows) if number != i]
    )
    return -minor if (i + j) % 2 else minor


class Polynomial(Arithmetic):
    """A polynomial in λ or κ with coefficients of any number type, the lowest first."""

    def __init__(self, coefficients: Sequence[Any]) -> None:
        self.coefficients = list(coefficients)

    def padded(self, size: int) -> list[Any]:
        """The coefficients, with zeros up to that number."""
        return self.coefficients + [0] * (size - len(self.coefficients))

    def __add__(self, other: Number | Polynomial) -> Polynomial:
        two = other.coefficients if isinstance(other, Polynomial) else [other]
        size = max(len(self.coefficients), len(two))
        return Polynomial(
            [a + b for a, b in zip(self.padded(size), Polynomial(two).padded(size), strict=True)]
        )

    def __neg__(self) -> Polynomial:
        return Polynomial([-value for value in self.coefficients])

    def __mul__(self, other: Number | Polynomial) -> Polynomial:
        two = other.coefficients if isinstance(other, Polynomial) else [other]
        out = [0] * (len(self.coefficients) + len(two) - 1)
        for i, a in enumerate(self.coefficients):
            for j, b in enumerate(two):
                if not (is_zero(a) or is_zero(b)):
                    out[i + j] = out[i + j] + a * b
        return Polynomial(out)


def pencil(*matrices: Matrix) -> list[list[Polynomial]]:
    """A + λ B + λ² C + …."""
    return [
        [Polynomial(entries) for entries in zip(*rows, strict=True)]
        for rows in zip(*matrices, strict=True)
    ]


def characteristic(*matrices: Matrix) -> list[Any]:
    """Coefficients of det(A + λ B + λ² C + …), the lowest first."""
    return determinant(pencil(*matrices)).padded((len(matrices) - 1) * len(matrices[0]) + 1)


def hurwitz(coefficients: Sequence[Any], size: int | None = None) -> Number:
    """Hurwitz's determinant of that size of a polynomial, the lowest coefficient first.

    Without a size the last but one: 0 if two roots have the sum 0.
    """
    a = coefficients[::-1]
    size = len(a) - 2 if size is None else size
    # Row i, column j: a of index 2 (j + 1) − (i + 1), where there is one.
    places = [[2 * (j + 1) - (i + 1) for j in range(size)] for i in range(size)]
    return determinant([[a[k] if 0 <= k < len(a) else 0 for k in row] for row in places])


def trimmed(polynomial: Polynomial) -> list[Any]:
    """Coefficients without the highest ones that are 0 by structure."""
    coefficients = polynomial.coefficients
    while len(coefficients) > 1 and is_zero(coefficients[-1]):
        coefficients = coefficients[:-1]
    return coefficients


def resultant(one: Sequence[Any], two: Sequence[Any]) -> Number:
    """Sylvester's determinant of two polynomials."""
    m, n = len(one) - 1, len(two) - 1
    times = (one, n), (two, m)
    return determinant(
        [
            [0] * k + [*given[::-1]] + [0] * (count - 1 - k)
            for given, count in times
            for k in range(count)
        ]
    )


#: What is done to the rows before column k is eliminated, as a choice of its pivot.
Choice = Callable[[list[list[Any]], int], None]


def is_zero(value: Number) -> bool:
    """0 by structure."""
    return isinstance(value, int) and value == 0


def coupled(*matrices: Matrix) -> list[tuple[int, ...]]:
    """Blocks of places each of which acts on all others of its block, directly or through others,
    by entries that are not 0 by structure: a determinant is the product of those of its blocks.
    """
    places = range(len(matrices[0]))
    acting = [{i} | {j for A in matrices for j in places if not is_zero(A[i][j])} for i in places]
    for k in places:
        for each in acting:
            each |= acting[k] if k in each else set()
    return sorted({tuple(j for j in sorted(acting[i]) if i in acting[j]) for i in places})


def part_of(A: Matrix, places: Sequence[int]) -> list[list[Any]]:
    """The rows and columns of a matrix that belong to these places."""
    return [[A[i][j] for j in places] for i in places]


def linear_solution(
    matrix: Matrix, values: Sequence[Any], choose: Choice | None = None
) -> list[Any]:
    """Solution by elimination, pivots in the order of the rows unless ``choose`` exchanges them."""
    rows = [[*row, value] for row, value in zip(matrix, values, strict=True)]
    n = len(rows)
    for k in range(n):
        if choose is not None:
            choose(rows, k)
        for i in range(k + 1, n):
            if is_zero(rows[i][k]):
                continue
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    solution = [0] * n
    for k in reversed(range(n)):
        rest = rows[k][n]
        for j in range(k + 1, n):
            rest = rest - rows[k][j] * solution[j]
        solution[k] = rest / rows[k][k]
    return solution


@dataclass(frozen=True)
class Complex(Arithmetic):
    """re + i im."""

    re: Any
    im: Any

    def __add__(self, other: Number | Complex) -> Complex:
        other = as_complex(other)
        return Complex(self.re + other.re, self.im + other.im)

    def __neg__(self) -> Complex:
        return Complex(-self.re, -self.im)

    def __mul__(self, other: Number | Complex) -> Complex:
        if not isinstance(other, Complex):
            return Complex(self.re * other, self.im * other)
        return Complex(
            self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re
        )

    def __truediv__(self, other: Number | Complex) -> Complex:
        if not isinstance(other, Complex):
            return Complex(self.re / other, self.im / other)
        square = other.squared()
        return Complex(
            (self.re * other.re + self.im * other.im) / square,
            (self.im * other.re - self.re * other.im) / square,
        )

    def squared(self) -> Number:
        """|z|²."""
        return self.re**2 + self.im**2

    def conjugate(self) -> Complex:
        """re − i im."""
        return Complex(self.re, -self.im)


def as_complex(value: Number | Complex) -> Complex:
    """A real number with the imaginary part 0, and a complex one itself."""
    return value if isinstance(value, Complex) else Complex(value, 0)
