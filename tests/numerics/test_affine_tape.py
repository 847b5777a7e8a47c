"""Tapes on affine numbers against those of NumPy, bit by bit, and against exact fractions."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from spragsym.numerics import tape
from spragsym.numerics.affine import AFFINE, Affine, evaluated
from spragsym.numerics.interval_arrays import Intervals, quiet
from spragsym.statics.namespaces import NARROW

pytestmark = pytest.mark.skipif(not tape.available(), reason="no C compiler on installation")

#: Operations of affine numbers a and b, by the functions ``xp`` of their type.
EXACT: dict[str, Callable[[Any, Any, Any], Any]] = {
    "sum": lambda xp, a, b: a + b,
    "difference": lambda xp, a, b: a - b,
    "product": lambda xp, a, b: a * b,
    "quotient": lambda xp, a, b: a / b,
    "square": lambda xp, a, b: a * a,
    "fifth power": lambda xp, a, b: a * a * a * a * a if xp is AFFINE else a**5,
    "times a number": lambda xp, a, b: -2.3 * a,
}
OTHERS: dict[str, Callable[[Any, Any, Any], Any]] = {
    "absolute": lambda xp, a, b: abs(a),
    "sign": lambda xp, a, b: xp.sign(a),
    "numbers": lambda xp, a, b: 3 / (a + 0.7) - 1,
    **{
        name: lambda xp, a, b, name=name: getattr(xp, name)(a)
        for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")
    },
}


def operands(rng: np.random.Generator, count: int) -> Affine:
    """Numbers of every size, with terms and errors from nothing to more than the value; some
    infinite or unknown.
    """
    size = 10.0 ** rng.choice([rng.uniform(-310, 300), 0.0, 0.0, 1.0], count)
    value = rng.choice([-1, 1, 0], count, p=[0.3, 0.6, 0.1]) * size * rng.uniform(1, 2, count)
    value[: count // 9] = rng.choice([1.0, 2.0, np.nextafter(1, 0), np.nextafter(1, 2), -1.0])
    shares = [0.0, 1e-17, 1e-9, 0.1, 0.7]
    terms = value * rng.uniform(-1, 1, (3, count)) * rng.choice(shares, (3, count))
    error = np.abs(value) * rng.choice(shares, count)
    return Affine(
        np.where(rng.random(count) < 0.01, np.nan, value),
        terms,
        np.where(rng.random(count) < 0.02, np.inf, error),
    )


def both(operation: Callable[[Any, Any, Any], Any], a: Affine, b: Affine) -> tuple[Affine, Affine]:
    """By a tape and by NumPy."""
    count = a.value.size
    made = tape.recorded(
        lambda given, _: [operation(NARROW, given[0], given[1])],
        Intervals(np.zeros((2, 2, count))),
        Intervals(np.zeros((2, 1, count))),
    )
    assert made is not None
    given = Affine.stacked([a, b], (count,))
    with quiet():
        found = evaluated(made, given, Intervals(np.zeros((2, 1, count))))
        return found[0], operation(AFFINE, a, b)


@pytest.mark.parametrize("name", EXACT)
@pytest.mark.parametrize("count", [3000, pytest.param(10**6, marks=pytest.mark.thorough)])
def test_an_operation_gives_the_bits_of_numpy(name: str, count: int) -> None:
    rng = np.random.default_rng(80)
    found, expected = both(EXACT[name], operands(rng, count), operands(rng, count))
    np.testing.assert_array_equal(found.value, expected.value)
    np.testing.assert_array_equal(found.terms, expected.terms)
    np.testing.assert_array_equal(found.error, expected.error)


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("count", [3000, pytest.param(10**6, marks=pytest.mark.thorough)])
def test_a_function_gives_what_numpy_gives_but_for_the_last_bits(name: str, count: int) -> None:
    rng = np.random.default_rng(81)
    with np.errstate(over="ignore"):  # NumPy's own functions of what is infinite
        found, expected = both(OTHERS[name], operands(rng, count), operands(rng, count))
    known = np.isfinite(expected.error) & np.isfinite(expected.value)
    np.testing.assert_array_equal(np.isfinite(found.error) & np.isfinite(found.value), known)
    assert 0.2 < known.mean()
    for one, other in (
        (found.value, expected.value),
        (found.terms, expected.terms),
        (found.error, expected.error),
    ):
        near = 1e-14 * (expected.radius() + np.abs(expected.value))[known] + 1e-300
        off = np.abs(one[..., known] - other[..., known])
        assert (off <= 1e-9 * np.abs(other[..., known]) + near).all()


@pytest.mark.parametrize("name", ["sum", "product", "quotient"])
def test_what_is_exact_lies_within_the_error(name: str) -> None:
    """At places of ε at random: no more than the error from the value and the terms."""
    rng, count = np.random.default_rng(82), 1000
    a, b = operands(rng, count), operands(rng, count)
    found, _ = both(EXACT[name], a, b)
    exactly = {
        "sum": Fraction.__add__,
        "product": Fraction.__mul__,
        "quotient": Fraction.__truediv__,
    }
    places = rng.choice([-1, 1, 0], (3, count))

    def member(of: Affine, i: int, side: int) -> Fraction:
        terms = zip(of.terms[:, i].tolist(), places[:, i].tolist(), strict=True)
        middle = Fraction(of.value[i]) + sum(Fraction(term) * at for term, at in terms)
        return middle + side * Fraction(of.error[i])

    checked = 0
    known = [np.isfinite(one.value) & np.isfinite(one.error) for one in (a, b, found)]
    for i in np.flatnonzero(np.logical_and.reduce(known)).tolist():
        one, other = (member(of, i, side) for of, side in ((a, 1), (b, -1)))
        if other or name != "quotient":
            off = exactly[name](one, other) - member(found, i, 0)
            assert abs(off) <= Fraction(found.error[i])
            checked += 1
    assert checked > 0.3 * count


def test_what_is_no_operation_of_affine_numbers_is_refused() -> None:
    given = Intervals(np.ones((2, 2, 5)))
    angle = tape.recorded(lambda rows, _: [rows[0].angle(rows[1], None)], given, given)
    whole = tape.recorded(lambda rows, _: [rows[0] + rows[1]], given, given)
    assert angle is not None
    assert whole is not None
    numbers = np.ones((2, 5)), np.ones((3, 2, 5)), np.ones((2, 5))
    whole.affine(*numbers, given)
    for made, parts in (
        (angle, numbers),
        (whole, (*numbers[:2], np.ones((1, 5)))),
        (whole, (numbers[0][:1], numbers[1][:, :1], numbers[2][:1])),
    ):
        with pytest.raises(ValueError, match="arrays"):
            made.affine(*parts, given)


def test_a_quotient_covers_products_that_underflow() -> None:
    """Of 2^-1060/(2^-40 + 2^-56 ε): the term is 2^-1036, and 2^-1076 is 0 among floats."""
    a = Affine(np.array([2.0**-1060]), np.zeros((1, 1)), np.zeros(1))
    b = Affine(np.array([2.0**-40]), np.array([[2.0**-56]]), np.zeros(1))
    for found in both(EXACT["quotient"], a, b):
        for at in (-1, 1):
            exact = Fraction(2) ** -1060 / (Fraction(2) ** -40 + at * Fraction(2) ** -56)
            middle = Fraction(found.value[0]) + at * Fraction(found.terms[0, 0])
            assert abs(exact - middle) <= Fraction(found.error[0])
