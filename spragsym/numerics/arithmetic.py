"""Algebra over any number type: operators from sum, product and negation, polynomials, complex
numbers, determinants, resultants, Hurwitz determinants and small linear systems.

An integer 0 is an entry that is 0 by structure; products with it are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Self, TypeAlias


class Number(Protocol):
    """A number of any type that generated algebra takes: a float, an array, a rational, an
    interval, a ball, an affine form, or a jet of these.
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
    """A positive integer power by repeated products, for types with small powers only."""
    result = self
    for _ in range(power - 1):
        result = result * self
    return result


class Arithmetic:
    """Base of number types: differences and reflected operators, from negation, sum and product.

    It is no abstract base class because ``isinstance`` of one takes three times as long, and every
    operation calls it.
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
    """Determinant by expansion along the first row."""
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
    """A polynomial with coefficients of any number type, the lowest first."""

    def __init__(self, coefficients: Sequence[Any]) -> None:
        self.coefficients = list(coefficients)

    def padded(self, size: int) -> list[Any]:
        """The coefficients, followed by zeros up to the given number."""
        return self.coefficients + [0] * (size - len(self.coefficients))

    def __add__(self, other: Number | Polynomial) -> Polynomial:
        if not isinstance(other, Polynomial):
            other = Polynomial([other])
        size = max(len(self.coefficients), len(other.coefficients))
        pairs = zip(self.padded(size), other.padded(size), strict=True)
        return Polynomial([a + b for a, b in pairs])

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
    """Matrix of polynomials A + λ B + λ² C + …."""
    return [
        [Polynomial(entries) for entries in zip(*rows, strict=True)]
        for rows in zip(*matrices, strict=True)
    ]


def characteristic(*matrices: Matrix) -> list[Any]:
    """Coefficients of det(A + λ B + λ² C + …), the lowest first."""
    degree = (len(matrices) - 1) * len(matrices[0])
    return determinant(pencil(*matrices)).padded(degree + 1)


def odd_coefficients(K: Matrix, G: Matrix, M: Matrix, N: Matrix) -> list[Any]:
    """Coefficients of λ, λ³, …, λ²ⁿ⁻³ of det(2 (K + λ G + λ² M)), where N = K − Kᵀ, G is
    skew-symmetric and M symmetric.

    Transposition turns λ into −λ and N into −N, so that only products with an odd number of entries
    of N remain. The others are left out, and with them that of λ²ⁿ⁻¹, which is 0.
    """

    def by_skewness(*entries: Any) -> Any:
        return 0 if all(map(is_zero, entries)) else Polynomial(entries)

    def of(A: Matrix) -> Matrix:
        return [[by_skewness(0 if is_zero(entry) else 2 * entry) for entry in row] for row in A]

    parts = [
        [
            by_skewness(0 if is_zero(k) and is_zero(s) else 2 * k - s, s)
            for k, s in zip(*rows, strict=True)
        ]
        for rows in zip(K, N, strict=True)
    ]
    every = characteristic(parts, of(G), of(M))[1:-2:2]
    return [0 if is_zero(one) else sum(one.coefficients[1::2]) for one in every]


def hurwitz(coefficients: Sequence[Any], size: int | None = None) -> Number:
    """Hurwitz determinant of a polynomial, the lowest coefficient first.

    The default size is the degree − 1: that determinant is 0 if two roots have the sum 0.
    """
    a = coefficients[::-1]
    size = len(a) - 2 if size is None else size
    # The entry in row i and column j, counted from 1, is a_(2j − i).
    indices = [[2 * (j + 1) - (i + 1) for j in range(size)] for i in range(size)]
    return determinant([[a[k] if 0 <= k < len(a) else 0 for k in row] for row in indices])


def trimmed(polynomial: Polynomial) -> list[Any]:
    """The coefficients without the highest ones, if these are 0 by structure."""
    coefficients = polynomial.coefficients
    while len(coefficients) > 1 and is_zero(coefficients[-1]):
        coefficients = coefficients[:-1]
    return coefficients


def resultant(one: Sequence[Any], two: Sequence[Any]) -> Number:
    """Resultant of two polynomials: the determinant of their Sylvester matrix."""
    m, n = len(one) - 1, len(two) - 1
    return determinant(
        [
            [0] * k + [*coefficients[::-1]] + [0] * (count - 1 - k)
            for coefficients, count in ((one, n), (two, m))
            for k in range(count)
        ]
    )


#: Called with the rows before column k is eliminated; may exchange rows to choose the pivot.
Choice = Callable[[list[list[Any]], int], None]


def is_zero(value: Number) -> bool:
    """Whether a number is 0 by structure."""
    return isinstance(value, int) and value == 0


def coupled(*matrices: Matrix) -> list[tuple[int, ...]]:
    """Diagonal blocks (strongly connected components) of matrices of one size, as index tuples.

    Two indices are in one block if each depends on the other, directly or through others, by
    entries that are not 0 by structure. The determinant of a linear combination of the matrices is
    the product of the determinants of its blocks.
    """
    indices = range(len(matrices[0]))
    reached = [
        {i} | {j for A in matrices for j in indices if not is_zero(A[i][j])} for i in indices
    ]
    for k in indices:  # transitive closure
        for each in reached:
            if k in each:
                each |= reached[k]
    return sorted({tuple(j for j in sorted(reached[i]) if i in reached[j]) for i in indices})


def part_of(A: Matrix, indices: Sequence[int]) -> list[list[Any]]:
    """The submatrix of the given rows and columns."""
    return [[A[i][j] for j in indices] for i in indices]


def dot(one: Sequence[Any], other: Sequence[Any]) -> Any:
    """The sum of products of entries, without conjugation."""
    return sum(a * b for a, b in zip(one, other, strict=True))


def linear_solution(
    matrix: Matrix, values: Sequence[Any], choose: Choice | None = None
) -> list[Any]:
    """Solution by Gaussian elimination, without pivoting unless ``choose`` exchanges rows."""
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
    """Complex number re + i im."""

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
        if isinstance(other, Complex):
            return self * other.conjugate() / other.squared()
        return Complex(self.re / other, self.im / other)

    def squared(self) -> Number:
        """|z|²."""
        return self.re**2 + self.im**2

    def conjugate(self) -> Complex:
        """re − i im."""
        return Complex(self.re, -self.im)


def as_complex(value: Number | Complex) -> Complex:
    """A complex number as it is; a real number with the imaginary part 0."""
    return value if isinstance(value, Complex) else Complex(value, 0)
