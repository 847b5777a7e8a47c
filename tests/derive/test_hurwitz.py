"""What decides the stability of a page: exact polynomials of the derivation, which are those that
are computed in floats, intervals and balls, and which Hurwitz's theorem asks for.
"""

from fractions import Fraction
from itertools import chain
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from sympy.polys.rings import ring

import spragsym as ss
from spragsym.derive import hurwitz, pages
from spragsym.numerics import arithmetic
from spragsym.numerics.interval_arrays import Intervals
from spragsym.statics import stability
from spragsym.statics.balance import Balance

#: Pages whose determinants have few terms; reading one takes seconds.
PAGES = [
    pytest.param(path, marks=[] if path.stem == "mode_coupling" else pytest.mark.validate)
    for path in pages.shipped()
    if not ss.load(path.stem).clock and len(ss.load(path.stem).coordinates) <= 3
]


@pytest.mark.parametrize("n", [1, 2, 3])
def test_computed_coefficients_are_those_of_any_three_matrices(n: int) -> None:
    names = [[[f"{letter}_{i}{j}" for j in range(n)] for i in range(n)] for letter in "MCK"]
    _, *generators = ring(np.ravel(names).tolist(), sp.QQ)
    M, C, K = np.reshape(generators, (3, n, n)).tolist()
    computed = [one.as_expr() for one in arithmetic.characteristic(K, C, M)]
    derived = hurwitz.characteristic(
        *(sp.Matrix(n, n, sp.symbols(np.ravel(x).tolist())) for x in names)
    )
    assert [sp.expand(a - b) for a, b in zip(computed[::-1], derived, strict=True)] == [0] * (
        2 * n + 1
    )


@pytest.mark.parametrize("degree", [2, 4, 6])
def test_computed_determinants_are_those_of_any_coefficients(degree: int) -> None:
    names = [f"a_{k}" for k in range(degree + 1)]
    _, *generators = ring(names, sp.QQ)
    derived = hurwitz.determinants(sp.symbols(names))
    for size in range(1, degree + 1):
        computed = arithmetic.hurwitz(generators[::-1], size)
        assert sp.expand(computed.as_expr() - derived[size - 1]) == 0


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_what_is_computed_of_a_page_is_what_is_derived(path: Path) -> None:
    """At rational entries, exactly; an entry that the page has not is 0 where it is computed."""
    rng = np.random.default_rng(1)
    found, model = hurwitz.conditions(pages.read(path).mechanics), ss.load(path.stem)
    balance = Balance(model)
    given = np.array([[model.base.get(name, 0.7)] for name in balance.parameters])
    below = Intervals.point(-rng.uniform(0.01, 0.1, (balance.n, 1)))
    at = balance.state(below, balance.prepared_at(given))
    for own, matrix in zip((at.mass(), at.by_rates(), at.stiffness()), found.matrices, strict=True):
        for entry, symbol in zip(chain.from_iterable(own), matrix, strict=True):
            assert symbol != 0 or not np.any(getattr(entry, "magnitude", entry))
    drawn = {name: sp.Rational(int(rng.integers(-9, 9)), 7) for name in found.entries}
    M, C, K = (
        [[Fraction(int(one.p), int(one.q)) for one in row] for row in matrix.subs(drawn).tolist()]
        for matrix in found.matrices
    )
    a = {symbol: value.subs(drawn) for symbol, value in found.coefficients.items()}
    derived = [*[*a.values()][::-1], *(one.subs(a) for one in found.determinants[1:-1])]
    assert [Fraction(one) for one in stability._routh(M, C, K)] == [
        Fraction(int(one.p), int(one.q)) for one in derived
    ]


@pytest.mark.parametrize("n", [1, 2, 3])
def test_all_decay_exactly_where_all_are_positive(n: int) -> None:
    symbols = sp.symbols(f"a_:{2 * n + 1}")
    minors = sp.lambdify(symbols, hurwitz.determinants(symbols))
    rng, told = np.random.default_rng(n), set[bool]()
    for shift in np.linspace(0.0, 3.0, 100):
        M, C, K = rng.normal(size=(3, n, n))
        M, C, K = M @ M.T + np.eye(n), C + 2 * shift * np.eye(n), K + 3 * shift * np.eye(n)
        a = arithmetic.characteristic(K.tolist(), C.tolist(), M.tolist())[::-1]
        told.add(decays := min(minors(*a)) > 0)
        assert decays == (stability.roots(M[None], C[None], K[None]).real.max() < 0)
    assert told == {True, False}
