"""What decides whether every small deviation decays, M q″ + (C + G) q′ + K q = 0 with a K that need
not be symmetric: the coefficients of det(λ² M + λ (C + G) + K) and Hurwitz's determinants, exact
polynomials in the entries of these matrices.

All λ have negative real parts exactly if a_0 > 0 and all determinants are positive (Hurwitz).
"""

from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Matrix

from . import linearization, statics
from .algebra import Names, Row, Symbols
from .mechanics import Mechanics

LAMBDA = sp.Symbol("lambda")


def characteristic(M: Matrix, C: Matrix, K: Matrix) -> Row:
    """Coefficients of det(λ² M + λ C + K), the highest first."""
    whole = LAMBDA**2 * M + LAMBDA * C + K
    found = sp.Poly(whole.det(method="laplace"), LAMBDA).all_coeffs()
    return (*[sp.S.Zero] * (2 * M.rows + 1 - len(found)), *found)


def determinants(a: Row) -> Row:
    """Hurwitz's determinants of all sizes, of a polynomial with these coefficients, the highest
    first.
    """
    size = len(a) - 1

    def entry(i: int, j: int) -> Expr:
        return a[2 * j - i + 1] if 0 <= 2 * j - i + 1 <= size else sp.S.Zero

    table = Matrix(size, size, entry)
    return tuple(sp.expand(table[:k, :k].det(method="berkowitz")) for k in range(1, size + 1))


@dataclass(frozen=True)
class Conditions:
    """Coefficients of the characteristic polynomial in the ``entries`` of M, C + G and K, and
    Hurwitz's determinants in these ``coefficients``.

    ``entries`` are those that are no numbers, by name, with what they are at a state of the page;
    ``matrices`` M, C + G and K in these names.
    """

    matrices: tuple[Matrix, Matrix, Matrix]
    entries: Names
    coefficients: dict[sp.Symbol, Expr]
    determinants: Row


def conditions(model: Mechanics) -> Conditions:
    """The conditions of a page about steady sliding, or without contact."""
    rates = linearization.damping(model) + model.gyroscopic
    entries: Names = {}
    found = [
        _named(letter, Matrix(matrix), entries)
        for letter, matrix in (("M", model.mass), ("C", rates), ("K", statics.jacobian(model)))
    ]
    M, C, K = found
    a: Symbols = sp.symbols(f"a_:{2 * M.rows + 1}")
    named = dict(zip(a, characteristic(M, C, K), strict=True))
    known = {symbol: value for symbol, value in named.items() if value == 0}
    return Conditions((M, C, K), entries, named, determinants(tuple(known.get(s, s) for s in a)))


def _named(letter: str, matrix: Matrix, entries: Names) -> Matrix:
    """A matrix with a name for each entry that is no number, added to ``entries``."""

    def entry(i: int, j: int) -> Expr:
        value = matrix[i, j]
        if value.is_number:
            return value
        symbol = sp.Symbol(f"{letter}_{i + 1}{j + 1}")
        entries[symbol] = value
        return symbol

    return Matrix(matrix.rows, matrix.cols, entry)
