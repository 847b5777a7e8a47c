"""Numbers that carry the bound of their error: every number that they stand for, exactly, against
the bound of each operation.
"""

import itertools
import operator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from spragsym.numerics import affine
from spragsym.numerics.affine import AFFINE, Affine, Rounded
from tests.support import as_fraction, as_mpf, fractions

OPERATIONS = [operator.add, operator.sub, operator.mul, operator.truediv]
NUMBERS = [3, -7, 0.1, 1e-8]
#: Errors, as shares of the value, from none at all to what lets a divisor vanish.
ERRORS = [0.0, 1e-17, 1e-15, 1e-6, 0.3, 1.5]
#: The ε of numbers without terms.
NOWHERE = np.empty((0, 0))


pytestmark = pytest.mark.usefixtures("silent")


def linear(x: Rounded, at: np.ndarray) -> list[Fraction]:
    """value + Σ terms ε, exactly; of a number without terms its value."""
    if not isinstance(x, Affine):
        return fractions(x.value)
    return [
        Fraction(float(value))
        + sum(Fraction(float(term)) * int(sign) for term, sign in zip(terms, signs, strict=True))
        for value, terms, signs in zip(x.value, x.terms.T, at.T, strict=True)
    ]


def members(x: Rounded, at: np.ndarray, side: int) -> list[Fraction]:
    """One that it stands for."""
    return [
        one + side * error for one, error in zip(linear(x, at), fractions(x.error), strict=True)
    ]


def check(found: Rounded, at: np.ndarray, exact: list[Fraction | None]) -> None:
    """At the same ε all that it stands for is within the error of its linear part."""
    for here, error, number in zip(linear(found, at), found.error, exact, strict=True):
        assert (
            number is None or not np.isfinite(error) or abs(here - number) <= Fraction(float(error))
        )


def rounded_ones(seed: int, count: int = 160, size: float = 1.0) -> Rounded:
    """Values with errors of many sizes; the first ones are powers of two and their neighbours,
    whose results are halfway.
    """
    rng = np.random.default_rng(seed)
    values = (
        rng.choice([-1, 1], count)
        * rng.uniform(1, 2, count)
        * 2.0 ** rng.integers(-2, 3, count)
        * size
    )
    values[:60] = (
        rng.choice([1.0, 2.0, np.nextafter(1, 0), np.nextafter(1, 2), -1.0, 1 + 2.0**-30], 60)
        * size
    )
    return Rounded(values, np.abs(values) * rng.choice(ERRORS, count))


def affine_ones(seed: int, count: int = 90, size: float = 1.0) -> Affine:
    """Values, terms and errors, each of them 0 in some places."""
    rng = np.random.default_rng(seed)
    x = rounded_ones(seed, count, size)
    terms = (
        x.value
        * rng.uniform(-1, 1, (3, count))
        * rng.choice([0.0, 1e-16, 1e-3, 0.2, 0.6], (3, count))
    )
    return Affine(x.value, terms, np.where(rng.integers(0, 2, count), x.error, 0.0))


@pytest.mark.parametrize("operation", OPERATIONS)
@pytest.mark.parametrize(
    ("ones", "size"),
    [
        (rounded_ones, 1.0),
        (affine_ones, 2.0**-537),
        *(
            pytest.param(*one, marks=pytest.mark.thorough)
            for one in (
                (rounded_ones, 2.0**-537),
                (rounded_ones, 2.0**-1060),
                (affine_ones, 1.0),
            )
        ),
    ],
)
def test_every_number_that_a_result_stands_for_is_within_its_error(
    operation: Any, ones: Any, size: float
) -> None:
    divides, rng = operation is operator.truediv, np.random.default_rng(5)
    x, y = ones(1, size=size), ones(2, size=1.0 if divides else size)
    found = operation(x, y)
    for one, other in itertools.product((-1, 0, 1), repeat=2):
        at = rng.choice([-1, 1, 0], (3, x.value.size))
        mine = members(x, at, one)
        pairs = zip(mine, members(y, at, other), strict=True)
        check(found, at, [operation(a, b) if b or not divides else None for a, b in pairs])
        for number, exact in zip(NUMBERS, fractions(NUMBERS), strict=True) if not other else ():
            check(operation(x, number), at, [operation(a, exact) for a in mine])
            if not divides or size == 1:
                check(
                    operation(number, x),
                    at,
                    [operation(exact, a) if a or not divides else None for a in mine],
                )


# ------------------------------------------------------------------------------------------------
# rounded


def test_roots_of_rounded_numbers() -> None:
    for size in (1.0, 2.0**-600):
        x = rounded_ones(3, size=size)
        x = Rounded(np.abs(x.value), x.error)
        with mpmath.workprec(200):
            for side in (-1, 0, 1):
                some = members(x, NOWHERE, side)
                check(
                    x.sqrt(),
                    NOWHERE,
                    [as_fraction(mpmath.sqrt(as_mpf(a))) if a > 0 else None for a in some],
                )


def test_signs_and_rows_of_rounded_numbers() -> None:
    x = Rounded(
        np.array([1.0, -1.0, 1.0, -1.0, 0.0, np.nan, 1.0]),
        np.array([0.5, 0.5, 1.0, 1.0, 0.0, 0.0, np.nan]),
    )
    assert x.sign().tolist() == [1, -1, 0, 0, 0, 0, 0]
    assert (-x).sign().tolist() == [-1, 1, 0, 0, 0, 0, 0]
    y = rounded_ones(4)
    assert y.rows([3, 1]).value.tolist() == [y.value[3], y.value[1]]
    assert y.rows([3, 1]).error.tolist() == [y.error[3], y.error[1]]
    assert Rounded(np.arange(3.0), 0.5).rows([2]).error.tolist() == [0.5]
    number = Rounded(2.0, 0.1)
    assert number.rows([0, 1]) is number


def test_cosines_of_angles() -> None:
    angles = np.concatenate([np.linspace(-4, 4, 300), [0.0, np.pi, np.pi / 2, 1e-9, 1e-300]])
    cosine, sine = affine.cosine_and_sine(angles)
    with mpmath.workprec(200):
        check(cosine, NOWHERE, [as_fraction(mpmath.cos(mpmath.mpf(angle))) for angle in angles])
        check(sine, NOWHERE, [as_fraction(mpmath.sin(mpmath.mpf(angle))) for angle in angles])
    assert cosine.error.max() < 4e-15
    assert sine.sign()[-1] == 1
    assert (
        affine.cosine_and_sine(np.array([5e-324]))[1].error[0] >= 8 * 5e-324
    )  # whose unit is no smaller


# ------------------------------------------------------------------------------------------------
# affine


@pytest.mark.thorough
@pytest.mark.parametrize("size", [1.0, 2.0**-1060, 2.0**1015])
def test_numbers_without_width_are_rounded_too(size: float) -> None:
    """An exact number, or terms and no error, times and over an exact number: roundings are all
    that the error is.
    """
    rng = np.random.default_rng(15)
    x, y = rounded_ones(16, 90, size), rounded_ones(17, 90)
    none, terms = np.zeros((3, 90)), x.value * rng.uniform(-1, 1, (3, 90))
    exact, wide, other = (
        Affine(x.value, none),
        Affine(x.value, terms, np.zeros(90)),
        Affine(y.value, none, np.zeros(90)),
    )
    at = rng.choice([-1, 1], (3, 90))
    for one in (exact, wide) if size <= 1 else ():
        for number, operation in itertools.product(
            NUMBERS, (operator.mul, operator.truediv, operator.add)
        ):
            check(
                operation(one, number),
                at,
                [operation(a, Fraction(number)) for a in linear(one, at)],
            )
        for operation, a, b in (
            (operator.mul, one, other),
            (operator.mul, other, one),
            (operator.add, one, other),
        ):
            check(operation(a, b), at, list(map(operation, linear(a, at), linear(b, at))))
    if size >= 1:
        check(1.0 / exact, at, [1 / a for a in linear(exact, at)])


def test_sides_hold_their_boxes() -> None:
    rng = np.random.default_rng(8)
    low = rng.normal(size=(3, 200)) * 10.0 ** rng.integers(-8, 8, (3, 200))
    high = low + 10.0 ** rng.uniform(-20, 1, (3, 200)) * rng.integers(0, 2, (3, 200))
    high[0, 100:] = np.nextafter(low[0, 100:], np.inf)
    made = affine.sides(low, high)
    assert [side.error.shape for side in made] == [(200,)] * 3
    for j, side in enumerate(made):
        assert not side.error.any()
        assert not np.delete(side.terms, j, axis=0).any()
        for value, half, least, most in zip(
            *map(fractions, (side.value, side.terms[j], low[j], high[j])), strict=True
        ):
            assert value - half <= least
            assert value + half >= most
            assert 2 * half <= (most - least) * (1 + Fraction(1, 2**48)) + 4 * Fraction(
                float(np.spacing(float(abs(most))))
            )
            assert half or least == most
            assert least < most or not half


def test_cosines_over_boxes() -> None:
    """At the same ε within the error of the linear part, wide, narrow and without width; of second
    order in the width.
    """
    rng = np.random.default_rng(9)
    angles = Affine(
        rng.uniform(-4, 4, 200),
        rng.uniform(-1, 1, (3, 200)) * rng.choice([0.0, 1e-15, 1e-3, 0.3], (3, 200)),
        rng.choice([0.0, 1e-16, 1e-3], 200),
    )
    angles.value[:3] = 0.0, np.pi / 2, np.pi
    cosine, sine = affine.cosine_and_sine(angles)
    with mpmath.workprec(200):
        for _ in range(5):
            at = rng.choice([-1, 1, 0], (3, 200))
            turns = list(map(as_mpf, members(angles, at, int(rng.choice([-1, 0, 1])))))
            check(cosine, at, [as_fraction(mpmath.cos(turn)) for turn in turns])
            check(sine, at, [as_fraction(mpmath.sin(turn)) for turn in turns])
    reach = angles.radius()
    assert (
        np.maximum(cosine.error, sine.error)
        <= 0.5 * reach**2 * (1 + 1e-9) + angles.error * (1 + 1e-9) + 1e-14
    ).all()


@pytest.mark.parametrize("name", ["sqrt", "exp", "log", "tanh", "atan", "cos", "sin"])
def test_functions_of_affine_numbers(name: str) -> None:
    """At the same ε each value lies within the error of the linear part; where there is none, the
    error has no end.
    """
    rng = np.random.default_rng(8)
    x, function = affine_ones(9), getattr(mpmath, name)
    found = getattr(AFFINE, name)(x)
    for _ in range(3):
        at, ends = rng.choice([-1, 1, 0], (3, 90)), name in ("sqrt", "log")
        with mpmath.workprec(200):
            some = members(x, at, rng.choice([-1, 0, 1]))
            check(
                found,
                at,
                [as_fraction(function(as_mpf(a))) if a > 0 or not ends else None for a in some],
            )
    small = Affine(np.array([0.7]), np.array([[1e-4]]), np.zeros(1))
    assert getattr(AFFINE, name)(small).error[0] < 1e-7
    if name in ("sqrt", "log"):
        assert (
            getattr(AFFINE, name)(Affine(np.array([0.5]), np.array([[1.0]]), np.zeros(1))).error[0]
            == np.inf
        )
