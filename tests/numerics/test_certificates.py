"""What proofs stand on, against exact arithmetic and many digits: root counts, enclosures of
roots.
"""

import itertools
import random
from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np
import pytest

from spragsym.numerics import balls, polynomials
from spragsym.numerics.balls import UndecidedSign
from tests.support import with_roots

# -----------------------------------------------------------------------------------------------
# polynomials


def _product(*factors: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    return tuple(reduce(np.convolve, [np.array(factor, dtype=object) for factor in factors]))


def _cases(
    rng: random.Random, number: int
) -> Iterator[tuple[list[Fraction], tuple[Fraction, ...]]]:
    """Different roots, and a polynomial that has them, some many times, and complex ones."""
    for trial in range(number):
        roots = sorted(
            {
                Fraction(rng.randint(-12, 12), rng.choice([1, 3, 7, 8]))
                for _ in range(rng.randint(0, 5))
            }
        )
        some = [1, 2] if not roots else [0, 0, 1, 2]
        factors = [
            (-root, Fraction(1))
            for root in roots
            for _ in range(rng.choice([1, 1, 2, 3]) if trial % 2 else 1)
        ]
        factors += [(Fraction(rng.randint(1, 5)), Fraction(0), Fraction(1))] * rng.choice(some)
        yield roots, _product((Fraction(rng.choice([-7, -1, 2, 9]), 5),), *factors)


@pytest.mark.thorough
def test_a_squarefree_part_has_the_same_roots_once() -> None:
    for roots, polynomial in _cases(random.Random(2), 60):
        simple = polynomials.squarefree(polynomial)
        assert [root for root in roots if polynomials.evaluate(simple, root)] == []
        assert len(polynomials.common_divisor(simple, polynomials.derivative(simple))) == 1
        assert len(polynomials.real_roots(simple, Fraction(-99), Fraction(99), 30)) == len(roots)
        assert (len(simple) - 1 - len(roots)) % 2 == 0
    part = polynomials.squarefree(
        _product(*[(Fraction(-1), Fraction(2))] * 3, *[(Fraction(1), Fraction(0), Fraction(1))] * 2)
    )
    assert len(part) == 4
    assert _product((Fraction(-1), Fraction(2)), (Fraction(1), Fraction(0), Fraction(1))) == tuple(
        value * Fraction(2) / part[-1] for value in part
    )


def test_roots_are_enclosed_to_the_bits_asked_for() -> None:
    rng = random.Random(3)
    for roots, polynomial in _cases(rng, 60):
        simple = polynomials.squarefree(polynomial)
        inside = [root for root in roots if -1 < root <= 1]
        bits = rng.choice([5, 20, 60])
        found = polynomials.real_roots(simple, Fraction(-1), Fraction(1), bits)
        assert len(found) == len(inside)
        for (low, high), root in zip(found, inside, strict=True):
            assert low <= root <= high
            assert high - low <= Fraction(1, 2**bits)
            distance = min(abs(low), abs(high), Fraction(1)) if low * high > 0 else Fraction(1)
            assert low == high or high - low > distance / 2 ** (
                bits + 2
            )  # no work beyond what was asked
            for end in (low, high):  # dyadic, so that a float of enough bits holds them
                assert end == root or end.denominator & (end.denominator - 1) == 0


def test_interpolation_gives_the_polynomial_back() -> None:
    rng = random.Random(4)
    for degree in range(13):
        given = tuple(Fraction(rng.randint(-9, 9), rng.randint(1, 9)) for _ in range(degree + 1))

        def value(t: Fraction, given: tuple[Fraction, ...] = given) -> Any:
            return polynomials.evaluate(given, t)

        assert polynomials.interpolate(value, degree) == polynomials.primitive(given)


def _blurred(polynomial: tuple[Fraction, ...], share: Fraction) -> tuple[Any, ...]:
    return tuple(
        balls.between(value - abs(value) * share, value + abs(value) * share)
        for value in polynomial
    )


def test_interval_coefficients_decide_or_say_that_they_cannot() -> None:
    """Whatever polynomial the intervals hold has the roots that are found; where they hold too
    many, nothing is.
    """

    decided, rng = 0, random.Random(5)
    with balls.precision(200):
        for roots, polynomial in _cases(rng, 24):
            for bits in (12, 60, 150):
                try:
                    blurred = _blurred(polynomial, Fraction(1, 2**bits))
                    found = polynomials.real_roots(blurred, Fraction(-21, 8), Fraction(25, 8), 10)
                except (UndecidedSign, ZeroDivisionError):
                    continue
                decided += 1
                known = [root for root in roots if Fraction(-21, 8) < root <= Fraction(25, 8)]
                assert len(found) == len(known)
                assert all(
                    low <= root <= high and high - low <= Fraction(1, 1024)
                    for (low, high), root in zip(found, known, strict=True)
                )
    assert decided >= 20


# ------------------------------------------------------------------------------------------------
# descartes


def _with_roots(*roots: Fraction) -> tuple[int, ...]:
    return polynomials.primitive(with_roots(*roots))


#: A cluster, roots at the ends of cells and of the range, outside, and next to 0 and 1; (low, high]
#: beside them.
_CLOSE = Fraction(1, 2) + Fraction(1, 2**70)
CLUSTERS = [
    [Fraction(1, 2)],
    [Fraction(1, 2), _CLOSE, Fraction(3, 4)],
    [Fraction(0), Fraction(1), Fraction(1, 3)],
    [
        Fraction(1, 7),
        Fraction(2, 7),
        Fraction(1, 4),
        Fraction(3, 8),
        Fraction(-1, 2),
        Fraction(3, 2),
    ],
    [Fraction(1), Fraction(2)],
    [Fraction(1, 10**40), Fraction(2, 10**40), 1 - Fraction(1, 10**30)],
    [_CLOSE, Fraction(0)],
    [Fraction(-1, 3), Fraction(-1, 4)],
    [Fraction(k, 8) for k in range(-8, 9)],
    [Fraction(1, 2), Fraction(1, 4) - Fraction(1, 2**50), Fraction(1, 4)],
]


@pytest.mark.parametrize("roots", CLUSTERS)
def test_descartes_finds_every_root_in_the_range(roots: list[Fraction]) -> None:
    for (low, high), bits, extra in itertools.product(
        ((0, 1), (-1, 1), (Fraction(-1, 7), Fraction(13, 11))),
        (1, 200),
        (
            (1,),
            (1, 0, 1),
            (-7,),
            (Fraction(101, 400), -1, 1),
        ),  # the last with complex roots beside 1/2
    ):
        polynomial = polynomials.primitive(
            _product(_with_roots(*roots), tuple(map(Fraction, extra)))
        )
        inside = sorted(root for root in roots if low < root <= high)
        found = polynomials.real_roots(polynomial, Fraction(low), Fraction(high), bits)
        assert len(found) == len(inside)
        for root, true in zip(found, inside, strict=True):
            assert root.low <= true <= root.high
            assert root.low == root.high or root.low < true < root.high
            assert not [
                other for other in roots if other != true and root.low <= other <= root.high
            ]
            distance = min(map(abs, root)) if root.low > 0 or root.high < 0 else Fraction(1)
            assert root.high - root.low <= Fraction(1, 2**bits) * min(distance, Fraction(1))
            if len(roots) < 9:
                assert polynomials.has_root(polynomial, *root)
                others = _with_roots(*(other for other in roots if other != true))
                assert not polynomials.has_root(others, *root)


def test_residues_prove_what_has_no_common_factor() -> None:
    """Integer roots, so that a common factor is a root in common; degrees as different as they
    come.
    """
    rng = random.Random(9)
    for _ in range(300):
        roots = [[Fraction(rng.randint(-9, 9)) for _ in range(rng.randint(0, 6))] for _ in range(2)]
        one, other = (_with_roots(*some) for some in roots)
        apart = set(roots[0]).isdisjoint(roots[1])
        assert polynomials._coprime(one, other) == apart
        assert (len(polynomials.common_divisor(one, other)) == 1) == apart
    prime = polynomials._PRIME
    assert not polynomials._coprime((1, 1), (1, prime))  # of the residue 1 there is nothing to tell
    assert polynomials._coprime((1, prime), (1, 1))
    assert not polynomials._coprime((1, 1), ())
    assert polynomials.squarefree(()) == ()


def test_a_root_counts_at_the_upper_end_only_and_once() -> None:
    double, line = _with_roots(Fraction(1), Fraction(1)), _with_roots(Fraction(1))
    for polynomial in (double, line, tuple(-value for value in line)):
        assert polynomials.has_root(polynomial, Fraction(0), Fraction(2))
        assert polynomials.has_root(polynomial, Fraction(0), Fraction(1))
        assert polynomials.has_root(polynomial, Fraction(1), Fraction(1))
        assert not polynomials.has_root(polynomial, Fraction(1), Fraction(2))
        assert not polynomials.has_root(polynomial, Fraction(2), Fraction(2))
        assert not polynomials.has_root(polynomial, Fraction(3), Fraction(4))
    assert not polynomials.has_root((5,), Fraction(0), Fraction(1))
