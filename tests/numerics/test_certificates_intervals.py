"""Interval arithmetic, the heart of every proof, against exact rationals and mpmath with many more
digits.
"""

import contextlib
import itertools
import math
import operator
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from spragsym.numerics import balls
from spragsym.numerics.balls import Ball, UndecidedSign
from tests.support import as_mpf


def _small_balls(bits: int) -> Iterator[Ball]:
    """Every ball of a few bits, about: middles and radii where rounding down loses nothing, one
    unit, and nearly the next.
    """
    for mid, rad, exp in itertools.product(
        (-9, -7, 0, 1, 4, 7), (0, 1, 3), (-3, 0, 2)[:: 1 if bits < 9 else 2]
    ):
        yield Ball(mid, rad, exp, bits)


def _holds(ball: Ball, value: Fraction) -> bool:
    low, high = balls.ends(ball)
    return low <= value <= high


OPERATIONS = [operator.add, operator.sub, operator.mul, operator.truediv]


@pytest.mark.parametrize("operation", OPERATIONS, ids="+-*/")
@pytest.mark.parametrize("bits", [2, 3, 60])
def test_operations_enclose_every_corner(operation: Callable[[Any, Any], Any], bits: int) -> None:
    """Of three bits nearly every result is rounded; the extremes of a monotonic operation lie at
    the ends.
    """
    for one, other in itertools.product(_small_balls(bits), repeat=2):
        try:
            result = operation(one, other)
        except UndecidedSign:
            low, high = balls.ends(other)
            assert low <= 0 <= high
            continue
        for a, b in itertools.product(balls.ends(one), balls.ends(other)):
            assert _holds(result, operation(a, b)), (one, other, result)
        assert abs(result.mid) <= 1 << bits
        assert result.rad.bit_length() <= balls.RADIUS_BITS + 1


def test_far_apart_terms_go_into_the_radius() -> None:
    for bits, gap, sign in itertools.product((8, 53), (20, 60, 200, 5000), (1, -1)):
        for exp in (0, -7, 6):
            large, small = Ball(5, 0, gap + exp, bits), Ball(sign * 3, 1, exp, bits)
            for result, turn in ((large + small, 1), (small - large, -1)):
                for end in balls.ends(small):
                    assert _holds(result, turn * Fraction(5) * Fraction(2) ** (gap + exp) + end)
                assert result.mid.bit_length() + result.rad.bit_length() < 200
    huge = Ball(1, 0, 1 << 62, 53) - Ball(1, 0, 0, 53)
    assert huge.mid.bit_length() + huge.exp >= 1 << 62
    for bits, gap in itertools.product((8, 53), range(1, 140)):
        assert (Ball(1, 0, gap, bits) + Ball(1, 0, 0, bits)).rad <= (
            0 if gap < bits else 1 if gap <= bits + 32 else 2
        )
    for bits, far in itertools.product((5, 53, 300), (0, 1, 20, 31)):
        one, other = (
            Ball(1, 0, bits + far, bits),
            Ball((1 << bits) - 1, 0, far, bits),
        )  # all but one bit cancels
        assert balls.ends(one - other) == balls.ends(Ball(1, 0, far, bits)) == (2**far, 2**far)
        assert balls.ends(other - one) == (-(2**far), -(2**far))
    tiny = Ball(3, 0, -5000, 53)
    assert (
        balls.ends(tiny + Ball(0, 0, 0, 53))
        == balls.ends(Ball(0, 0, 9, 53) + tiny)
        == balls.ends(tiny)
    )


@pytest.mark.parametrize("bits", [5, 53, 300])
def test_rationals_and_unions_are_enclosed(bits: int) -> None:
    values = [
        Fraction(n, d)
        for n in (-(10**30), -7, -1, 0, 1, 2, 10**30 + 1)
        for d in (1, 3, 8, 10**9 + 7, 2**400)
    ]
    with balls.precision(bits):
        for one, other in itertools.combinations(values, 2):
            assert _holds(balls.exact(one), one)
            both = balls.between(min(one, other), max(one, other))
            assert _holds(both, one)
            assert _holds(both, other)
        assert balls.ends(balls.exact(Fraction(3, 8))) == (Fraction(3, 8),) * 2


def test_numbers_of_other_types_are_exact() -> None:
    ball = Ball(3, 0, -2, 53)
    for result, value in [
        (1 - ball, 0.25),
        (ball - 1, -0.25),
        (2 * ball, 1.5),
        (ball * 0.5, 0.375),
        (3 / ball, 4),
        (ball / 3.0, 0.25),
        (ball**3, 0.421875),
        (ball**0, 1),
        (0.5 + ball, 1.25),
        (-ball, -0.75),
        (ball**-1 * 3, 4),
        (ball**-2 * 9, 16),
        (ball**2, 0.5625),
        (ball**6, 0.75**6),
        (ball - 0.5, 0.25),
        (+ball, 0.75),
    ]:
        assert _holds(result, Fraction(value))
        if result.rad:
            assert value in (4, 0.25, 16)  # quotients by 3; all else is exact
    for operation in OPERATIONS:
        for pair in ((ball, "1"), ("1", ball)):
            with pytest.raises(TypeError):
                operation(*pair)
    with pytest.raises(TypeError):
        ball**0.5
    assert repr(ball) == "Ball((3 ± 0) * 2**-2)"


FUNCTIONS: dict[str, Callable[[Ball], Ball]] = {
    "cos": lambda ball: balls.cos_sin(ball)[0],
    "sin": lambda ball: balls.cos_sin(ball)[1],
    "atan": balls.atan,
    "sqrt": balls.sqrt,
}


@pytest.mark.parametrize("bits", [3, 53, 700])
@pytest.mark.parametrize("name", ["cos", "sin", "atan", "sqrt"])
def test_functions_enclose_and_are_sharp(name: str, bits: int) -> None:
    """Against mpmath with far more digits; a wide ball at both ends, a point with hardly more than
    its last bits lost.
    """
    rng = np.random.default_rng(bits)
    context = mpmath.mp.clone()
    context.prec = 2200 + 2 * bits  # cos 2^−1000 differs from 1 in bit 2001
    half_pi = Fraction(math.pi) / 2
    near_pi = Fraction(math.nextafter(math.pi, 0))
    values = [
        Fraction(1),
        Fraction(1, 3),
        half_pi,
        2 * half_pi,
        near_pi,
        Fraction(5, 2),
        Fraction(1, 2**1000),
    ]
    values += [
        Fraction(float(value))
        for value in np.concatenate([rng.uniform(0, 4, 8), 10.0 ** rng.uniform(-40, 5, 8)])
    ]
    for value, sign, width in itertools.product(
        values, (1, -1), (0, Fraction(1, 2**9), Fraction(1, 2**70))
    ):
        if sign < 0 and name == "sqrt":
            continue
        with balls.precision(bits):
            ball = balls.between(sign * value * (1 - width), sign * value * (1 + width))
        found = FUNCTIONS[name](ball)
        low, high = (context.mpf(end.numerator) / end.denominator for end in balls.ends(found))
        for end in balls.ends(ball):
            exact = getattr(context, name)(context.mpf(end.numerator) / end.denominator)
            assert low <= exact <= high, (value, sign, width)
        if not ball.rad:
            assert high - low <= abs(exact) * context.mpf(2) ** (5 - bits), (value, sign)


def test_functions_at_zero_and_pi() -> None:
    for exp in (-4, 0, 3):
        cosine, sine = balls.cos_sin(Ball(0, 1, exp, 53))
        assert _holds(cosine, Fraction(1))
        assert _holds(sine, Fraction(0))
        assert balls.ends(cosine)[0] <= Fraction(math.cos(min(2.0**exp, math.pi)) + 1e-9)
    assert balls.ends(balls.atan(Ball(0, 1, 0, 53))) == (-1, 1)
    assert balls.ends(balls.sqrt(Ball(0, 0, 0, 53))) == (0, 0)
    for bits in (4, 53, 5000):
        with balls.precision(bits), mpmath.workprec(6000):
            low, high = map(as_mpf, balls.ends(balls.pi()))
            assert low < mpmath.pi < high
            assert high - low < mpmath.ldexp(1, 5 - bits)
    for bad in (Ball(3, 4, 0, 53), Ball(-4, 0, 0, 53)):
        with pytest.raises(UndecidedSign, match="negative"):
            balls.sqrt(bad)
    assert _holds(balls.sqrt(Ball(4, 4, 0, 53)), Fraction(0))


def test_what_holds_0_has_no_sign_and_divides_nothing() -> None:
    """An end on 0 is no sign."""
    for divisor in (Ball(0, 0, 0, 53), Ball(3, 3, 0, 53), Ball(-3, 3, 0, 53), Ball(-1, 7, 5, 53)):
        assert balls.sign(divisor) == 0
        with pytest.raises(UndecidedSign, match="holds 0"):
            1 / divisor


def test_signs_next_to_0() -> None:
    assert [balls.sign(Ball(mid, 3, -9, 53)) for mid in (-4, -3, 3, 4)] == [-1, 0, 0, 1]
    assert balls.sign(Ball(1, 0, -9999, 53)) == 1


# ------------------------------------------------------------------------------------------------
# bounds, in units of the last place


#: Angles whose bits run out at once, all ones, next to multiples of π/2, tiny, large: (mid, exp).
ANGLES = [
    (1, 0),
    (-1, 0),
    (3, -1),
    ((1 << 60) - 1, -60),
    ((1 << 200) - 1, -200),
    (int(math.ldexp(math.pi, 50)), -51),
    (1, -9),
    (int(math.ldexp(math.pi, 51)), -51),
    (7, 40),
    (-((1 << 33) - 1), -20),
    (1, -300),
    (5, 1),
    (884279719003555, -48),
]


@pytest.mark.parametrize("places", [0, 1, 53, 1000])
def test_cosine_and_sine_are_as_close_as_they_say(places: int) -> None:
    """And say hardly more than the unit that rounding down takes: an error of the series that shows
    is a fault.
    """
    with mpmath.workprec(2 * places + 500):
        for mid, exp in ANGLES:
            cosine, sine, error = balls._cos_sin(mid, exp, places)
            angle = mpmath.ldexp(mid, exp)
            for value, true in ((cosine, mpmath.cos(angle)), (sine, mpmath.sin(angle))):
                off = true * mpmath.mpf(2) ** places - value
                assert -0.01 < off < 1.01, (mid, exp)  # rounded down, and what the guard bits leave
                assert abs(off) <= error <= 2


def test_radii_are_no_unit_smaller_or_larger_than_they_must_be() -> None:
    """A middle that loses nearly a unit, and a radius that is rounded up by nearly another."""
    for shift, radius in itertools.product((1, 2, 9), (0, 1, 2, 3, 511, 512, 513)):
        needed = math.ceil(Fraction(radius, 1 << shift)) + 1
        assert balls._rounded(radius, shift) == needed
        assert balls._shifted(radius, -shift) == needed - 1
        assert balls._shifted(radius, shift) == radius << shift
        assert balls._shifted_down(-radius, -shift) == -math.ceil(Fraction(radius, 1 << shift))


@pytest.mark.parametrize("name", ["cos", "sin", "atan"])
def test_bounds_hold_without_guard_bits(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Guard bits hide an error that is left out: without them it shows in the last place."""
    monkeypatch.setattr(balls, "GUARD_BITS", 0)
    with mpmath.workprec(400):
        for bits, mid, rad in itertools.product(
            (3, 7, 12, 30), (-125, -77, -3, 1, 2, 9, 99, 127), (0, 1)
        ):
            for exp in (-40, -9, -7, -6):
                ball = Ball(mid, rad, exp, bits)
                low, high = map(as_mpf, balls.ends(FUNCTIONS[name](ball)))
                for end in map(as_mpf, balls.ends(ball)):
                    assert low <= getattr(mpmath, name)(end) <= high


# ------------------------------------------------------------------------------------------------
# both arithmetics


def test_precision_is_that_asked_for_and_then_as_before() -> None:
    def width() -> Fraction:
        low, high = balls.ends(balls.exact(Fraction(1, 3)))
        return high - low

    before, digits = width(), mpmath.mp.prec
    assert balls.exact(Fraction(1, 3)).bits == balls.pi().bits == 53
    with balls.precision(80):
        eighty = width()
        with contextlib.suppress(KeyError), balls.precision(30):
            thirty = width()
            raise KeyError
        assert width() == eighty
    assert Fraction(1, 2**36) < thirty < Fraction(1, 2**26)
    assert Fraction(1, 2**86) < eighty < Fraction(1, 2**76)
    assert width() == before
    assert mpmath.mp.prec == digits
