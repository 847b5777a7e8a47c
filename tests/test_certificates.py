"""What proofs stand on, against exact arithmetic and many digits: root counts, enclosures of roots, interval functions."""

from __future__ import annotations

import contextlib
import importlib.util
import itertools
import math
import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from spragsym.exact import intervals, polynomials
from spragsym.exact.intervals import Arithmetic
from spragsym.exact.polynomials import Undecided, exact_sign

ARITHMETICS = ["mpmath", *(["python-flint"] if importlib.util.find_spec("flint") else [])]


@pytest.fixture(params=ARITHMETICS)
def arith(request: pytest.FixtureRequest) -> Arithmetic:
    """Both interval arithmetics."""
    return intervals.arithmetic(request.param)


# ----------------------------------------------------------------------------------------------- polynomials


def _product(*factors: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    result = [Fraction(1)]
    for factor in factors:
        longer = [Fraction(0)] * (len(result) + len(factor) - 1)
        for (i, a), (j, b) in itertools.product(enumerate(result), enumerate(factor)):
            longer[i + j] += a * b
        result = longer
    return tuple(result)


def _cases(rng: random.Random, number: int) -> Iterator[tuple[list[Fraction], tuple[Fraction, ...]]]:
    """Different roots, and a polynomial that has them, some many times, and complex ones."""
    for trial in range(number):
        roots = sorted({Fraction(rng.randint(-12, 12), rng.choice([1, 3, 7, 8])) for _ in range(rng.randint(0, 5))})
        some = [1, 2] if not roots else [0, 0, 1, 2]
        factors = [(-root, Fraction(1)) for root in roots for _ in range(rng.choice([1, 1, 2, 3]) if trial % 2 else 1)]
        factors += [(Fraction(rng.randint(1, 5)), Fraction(0), Fraction(1))] * rng.choice(some)
        yield roots, _product((Fraction(rng.choice([-7, -1, 2, 9]), 5),), *factors)


def test_counts_are_those_of_known_roots() -> None:
    """Roots at the ends, multiple roots and none: a root at the upper end counts, one at the lower does not."""
    rng = random.Random(1)
    for roots, polynomial in _cases(rng, 200):
        chain = polynomials.sturm_chain(polynomial, exact_sign)
        ends = sorted([*(Fraction(rng.randint(-99, 99), 8) for _ in range(3)), *roots, Fraction(-100), Fraction(100)])
        for low, high in itertools.combinations(sorted(set(ends)), 2):
            known = sum(low < root <= high for root in roots)
            if len(chain[-1]) == 1 or all(polynomials.evaluate(polynomial, end) for end in (low, high)):
                # at a multiple root the whole chain is 0
                assert polynomials.count_between(chain, low, high, exact_sign) == known


def test_a_squarefree_part_has_the_same_roots_once() -> None:
    for roots, polynomial in _cases(random.Random(2), 120):
        simple = polynomials.squarefree(polynomial)
        assert [root for root in roots if polynomials.evaluate(simple, root)] == []
        common = polynomials.sturm_chain(simple, exact_sign)[-1]
        assert len(common) == 1
        assert len(polynomials.real_roots(simple, Fraction(-99), Fraction(99), exact_sign, Fraction, 30)) == len(roots)
        assert (len(simple) - 1 - len(roots)) % 2 == 0
    part = polynomials.squarefree(_product(*[(Fraction(-1), Fraction(2))] * 3, *[(Fraction(1), Fraction(0), Fraction(1))] * 2))
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
        found = polynomials.real_roots(simple, Fraction(-1), Fraction(1), exact_sign, Fraction, bits)
        assert len(found) == len(inside)
        for (low, high), root in zip(found, inside, strict=True):
            assert low <= root <= high
            assert high - low <= Fraction(1, 2**bits)
            assert low == high or high - low > Fraction(1, 2 ** (bits + 2))  # no work beyond what was asked
            for end in (low, high):  # dyadic, so that a float of enough bits holds them
                assert end == root or end.denominator & (end.denominator - 1) == 0


def test_remainders_stay_coprime_integers() -> None:
    """Without that the digits of a Sturm chain double at every step."""
    chain = polynomials.sturm_chain(tuple(Fraction(6 * (k + 1), 5) for k in range(9)), exact_sign)
    assert len(chain) > 4
    for part in chain:
        assert all(value.denominator == 1 for value in part)
        assert math.gcd(*(int(value) for value in part)) == 1
    assert chain[0][0] == 1


def test_leading_zeros_go_and_nothing_else() -> None:
    polynomial = (Fraction(0), Fraction(-1), Fraction(0), Fraction(2), Fraction(0), Fraction(0))
    assert polynomials.sturm_chain(polynomial, exact_sign)[0] == (0, -1, 0, 2)
    found = polynomials.real_roots(polynomial, Fraction(-1), Fraction(1), exact_sign, Fraction, 20)
    assert len(found) == 3


def test_interpolation_gives_the_polynomial_back(arith: Arithmetic) -> None:
    rng = random.Random(4)
    for degree in range(13):
        given = tuple(Fraction(rng.randint(-9, 9), rng.randint(1, 9)) for _ in range(degree + 1))

        def value(t: Fraction, given: tuple[Fraction, ...] = given) -> Any:
            return polynomials.evaluate(given, t)

        assert polynomials.interpolate(value, degree, Fraction) == given
        with arith.precision(120):
            blurred = polynomials.interpolate(lambda t: arith.exact(value(t)), degree, arith.exact)  # called here
            for coefficient, exact in zip(blurred, given, strict=True):
                low, high = arith.ends(coefficient)
                assert low <= mpmath.mpf(exact.numerator) / exact.denominator <= high
                assert high - low < 1e-20


def test_interpolation_uses_the_smallest_nodes() -> None:
    """Integers about 0: larger ones cost digits."""
    asked: list[Fraction] = []

    def value(t: Fraction) -> Fraction:
        asked.append(t)
        return t

    for degree, nodes in ((0, [0]), (1, [0, 1]), (6, list(range(-3, 4))), (7, list(range(-3, 5)))):
        asked.clear()
        polynomials.interpolate(value, degree, Fraction)
        assert asked == nodes


def _blurred(arith: Arithmetic, polynomial: tuple[Fraction, ...], share: Fraction) -> tuple[Any, ...]:
    return tuple(
        arith.between(_mpf(value - abs(value) * share), _mpf(value + abs(value) * share)) for value in polynomial
    )


def _mpf(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def test_interval_coefficients_decide_or_say_that_they_cannot(arith: Arithmetic) -> None:
    """Whatever polynomial the intervals hold has the roots that are found; where they hold too many, nothing is."""

    def sign(value: Any) -> int:
        return intervals.sign(arith, value)

    decided, rng = 0, random.Random(5)
    with arith.precision(200):
        for roots, polynomial in _cases(rng, 40):
            for bits in (12, 60, 150):
                try:
                    blurred = _blurred(arith, polynomial, Fraction(1, 2**bits))
                    found = polynomials.real_roots(blurred, Fraction(-21, 8), Fraction(25, 8), sign, arith.exact, 10)
                except (Undecided, ZeroDivisionError):
                    continue
                decided += 1
                known = [root for root in roots if Fraction(-21, 8) < root <= Fraction(25, 8)]
                assert len(found) == len(known)
                assert all(low <= root <= high and high - low <= Fraction(1, 1024)
                           for (low, high), root in zip(found, known, strict=True))  # fmt: skip
    assert decided >= 20


@pytest.mark.parametrize(
    ("polynomial", "low", "high", "words"),
    [
        ([(1, 1), (-1, 1)], -1, 1, "leading coefficient"),
        ([(-1, 1), (1, 1)], -1, 0, "Sturm function holds 0"),  # a root at about the upper end
        ([(-1, 1), (1, 1)], 0, 1, "Sturm function holds 0"),
        ([(Fraction(-1, 2**20), Fraction(1, 2**20)), (1, 1)], -1, 1, "holds 0 near a root"),
    ],
    ids=["degree", "upper end", "lower end", "width"],
)  # fmt: skip
def test_what_intervals_leave_open_is_no_answer(
    polynomial: list[tuple[Any, Any]], low: int, high: int, words: str, arith: Arithmetic
) -> None:
    def sign(value: Any) -> int:
        return intervals.sign(arith, value)

    with arith.precision(100):
        coefficients = tuple(arith.between(_mpf(Fraction(a)), _mpf(Fraction(b))) for a, b in polynomial)
        with pytest.raises(Undecided, match=words):
            polynomials.real_roots(coefficients, Fraction(low), Fraction(high), sign, arith.exact, 60)


def test_an_end_that_is_no_root_must_be_seen_to_be_none(arith: Arithmetic) -> None:
    """Bisection goes by the sign at the upper end: where an interval holds 0 there, it has none to go by."""
    with arith.precision(60):
        line = (arith.between(mpmath.mpf(-1), mpmath.mpf(0)), arith.exact(Fraction(1)))
        with pytest.raises(Undecided, match="holds 0 at an end"):
            polynomials._bisect(line, Fraction(-1), Fraction(1, 2), lambda v: intervals.sign(arith, v), arith.exact, 20)


# ------------------------------------------------------------------------------------------------- intervals


def test_a_sign_needs_room_beside_zero(arith: Arithmetic) -> None:
    with arith.precision(53):
        for low, high, sign in ((0, 1, 0), (-1, 0, 0), (0, 0, 0), (-1, 1, 0), (1, 2, 1), (-2, -1, -1), (1, 1, 1), (-1, -1, -1)):
            assert intervals.sign(arith, arith.between(mpmath.mpf(low), mpmath.mpf(high))) == sign
        assert intervals.sign(arith, arith.exact(Fraction(1, 10**60))) == 1
        assert intervals.sign(arith, -arith.exact(Fraction(1, 10**60))) == -1


def test_what_is_no_number_has_no_sign(arith: Arithmetic) -> None:
    with arith.precision(53):
        one = arith.exact(Fraction(1))
        everything = one / arith.between(mpmath.mpf(-1), mpmath.mpf(1))
        assert arith.ends(everything) == (-mpmath.inf, mpmath.inf)
        assert intervals.sign(arith, everything) == 0


def test_rationals_are_enclosed_as_closely_as_the_bits_allow(arith: Arithmetic) -> None:
    rng = random.Random(6)
    for bits in (24, 53, 300):
        with arith.precision(bits):
            for _ in range(50):
                value = Fraction(rng.randint(-(10**9), 10**9), rng.randint(1, 10**9)) * Fraction(2) ** rng.randint(-90, 90)
                low, high = arith.ends(arith.exact(value))
                assert _exact(low) <= value <= _exact(high)
                assert _exact(high) - _exact(low) <= abs(value) * Fraction(8, 2**bits)
            low, high = arith.ends(arith.exact(Fraction(1, 3)))
            assert _exact(high) - _exact(low) > Fraction(1, 2 ** (bits + 8))


def _exact(value: mpmath.mpf) -> Fraction:
    negative, mantissa, exponent, _ = value._mpf_
    return (-1) ** negative * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def test_intervals_hold_what_they_are_made_of(arith: Arithmetic) -> None:
    rng = random.Random(7)
    with arith.precision(90):
        for _ in range(60):
            ends = sorted(mpmath.ldexp(rng.randint(-(2**60), 2**60), rng.randint(-80, 20)) for _ in range(2))
            low, high = arith.ends(arith.between(*ends))
            assert low <= ends[0] <= ends[1] <= high
            slack = mpmath.ldexp(max(map(abs, ends)), -28)  # a ball's radius carries 30 bits
            assert ends[0] - low <= slack
            assert high - ends[1] <= slack


_REFERENCES = {"cos": mpmath.cos, "sin": mpmath.sin, "sqrt": mpmath.sqrt, "atan": mpmath.atan}


@pytest.mark.parametrize("name", _REFERENCES)
def test_functions_enclose_the_truth_and_little_else(name: str, arith: Arithmetic) -> None:
    """At points, and over intervals a little wider, against 60 digits more."""
    rng = random.Random(8)
    for bits in (20, 53, 200):
        for _ in range(60):
            value = rng.randint(1, 2**18) * Fraction(2) ** rng.randint(-50, -16) * (1 if name == "sqrt" else rng.choice([-1, 1]))
            for width in (Fraction(0), abs(value) / 128):
                with arith.precision(bits):
                    given = arith.between(_mpf(value), _mpf(value + width))
                    low, high = arith.ends(_function(arith, name, given))
                with mpmath.workprec(bits + 200):
                    truths = [_REFERENCES[name](_mpf(value + width * k / 4)) for k in range(5)]
                    assert low <= min(truths)
                    assert max(truths) <= high
                    span = 2 * _mpf(width) if name in ("cos", "sin") else 1.1 * (max(truths) - min(truths))
                    size = max(map(abs, truths)) + (1 if name in ("cos", "sin") else 0)
                    assert high - low <= span + size * mpmath.ldexp(1, 3 - bits)


def _function(arith: Arithmetic, name: str, value: Any) -> Any:
    if name in ("cos", "sin"):
        return arith.cos_sin(value)[name == "sin"]
    return arith.sqrt(value) if name == "sqrt" else arith.atan(value)


def test_pi_is_held_closely(arith: Arithmetic) -> None:
    for bits in (20, 53, 400):
        with arith.precision(bits):
            low, high = arith.ends(+arith.pi() * 1)
        with mpmath.workprec(500):
            assert low < mpmath.pi < high
            assert high - low < mpmath.ldexp(1, 4 - bits)


def test_precision_is_that_asked_for_and_then_as_before(arith: Arithmetic) -> None:
    def width() -> Fraction:
        low, high = arith.ends(arith.exact(Fraction(1, 3)))
        return _exact(high) - _exact(low)

    before, digits = width(), mpmath.mp.prec
    with arith.precision(80):
        eighty = width()
        with contextlib.suppress(KeyError), arith.precision(30):
            thirty = width()
            raise KeyError
        assert width() == eighty
    assert Fraction(1, 2**36) < thirty < Fraction(1, 2**26)
    assert Fraction(1, 2**86) < eighty < Fraction(1, 2**76)
    assert width() == before
    assert mpmath.mp.prec == digits


def test_the_arithmetic_is_the_one_named_or_the_fastest_there(monkeypatch: pytest.MonkeyPatch) -> None:
    assert [intervals.arithmetic(name).name for name in ARITHMETICS] == ARITHMETICS
    assert intervals.arithmetic().name == ARITHMETICS[-1]
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert intervals.arithmetic().name == "mpmath"
    with contextlib.suppress(ImportError):
        assert intervals.arithmetic("python-flint").name == "python-flint"
