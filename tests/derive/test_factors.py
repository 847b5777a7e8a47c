"""Factors of expressions: those of SymPy, without its draws where a gcd decides."""

import random

import pytest

pytest.importorskip("sympy")

import sympy as sp
from sympy.core import random as draws
from sympy.polys import factortools

from derive.factors import factor_list, factored

x, y, z, k = sp.symbols("x y z k")


def _polynomial(rng: random.Random) -> sp.Expr:
    """A product of small polynomials in x, y, z, k, some of them powers, some of degree 1."""
    factors = []
    for _ in range(rng.randint(1, 3)):
        powers = [(rng.randint(0, 2), rng.randint(0, 1), rng.randint(0, 2)) for _ in range(3)]
        terms = (rng.randint(-3, 3) * x**a * y**b * z**c for a, b, c in powers)
        factors.append((sum(terms, k * rng.randint(0, 1)) + rng.randint(1, 3)) ** rng.randint(1, 2))
    return sp.expand(sp.Mul(*factors))


@pytest.mark.thorough
def test_factors_are_those_of_sympy_whatever_their_order() -> None:
    rng = random.Random(5)
    for _ in range(60):
        whole = _polynomial(rng) * sp.Rational(rng.randint(1, 5), rng.randint(1, 5))
        number, powers = factor_list(whole)
        expected_number, expected = sp.factor_list(whole)
        assert sorted(powers, key=str) == sorted(expected, key=str)
        assert number == expected_number


@pytest.mark.parametrize(
    "expression",
    [
        sp.Integer(6),
        sp.S.Zero,
        1 - x,
        x * (1 - x) / 2,
        (x**2 - y**2) / (x * y - y**2),
        k * x**2 - k * y**2 + sp.sin(x) * (x + y),
        (sp.exp(x) ** 2 - 1) / (sp.exp(x) + 1),
        sp.sqrt(2) * x**2 - sp.sqrt(2),
        (x**2 - 1) * y / (3 * x + 3),
        x**4 + 4 * y**4,
        (x - x**2 - y**2) / 4,
    ],
)
def test_a_product_of_factors_is_that_of_sympy(expression: sp.Expr) -> None:
    assert factored(expression) == sp.factor(expression)


def test_an_equation_that_is_linear_in_a_parameter_is_factored_without_a_draw(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """For one draw of two hundred SymPy took minutes here: at seed 28 it does not end."""

    def refuse(*_: object) -> None:
        raise AssertionError("a random point was drawn")

    monkeypatch.setattr(factortools, "dmp_zz_wang", refuse)
    assert factor_list(k * x**2 * z - k * y * z + x * y**2 + z**2)[1] == [
        (k * x**2 * z - k * y * z + x * y**2 + z**2, 1)
    ]


def test_the_draws_of_others_go_on() -> None:
    whole = sp.expand((x**2 + y**2 + z**3) * (x**3 + y**2 - 2 * z**2))
    draws.seed(3)
    expected = draws.random()
    draws.seed(3)
    assert len(factor_list(whole)[1]) == 2
    assert draws.random() == expected
