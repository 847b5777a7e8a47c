"""Equilibria with proofs: counts, codes and errors against Newton's method on the forces, with many more digits."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.exact import intervals
from spragsym.exact.intervals import Arithmetic
from spragsym.exact.polynomials import Undecided
from spragsym.kang_nam.catastrophe import fold_proofs
from spragsym.kang_nam.statics import adaptive_precision, kernel
from spragsym.parameters import NAMES
from tests.oracles import reference
from tests.oracles.families import FAMILIES
from tests.support import as_fraction

NUMBERS = ("theta", "L", "x", "y")
BASE = (math.radians(30), 0.5, 0.007, 0.007, 0.1, 0.0)


def _points(number: int) -> Iterator[tuple[float, ...]]:
    """Points of every family: next to folds and cusps, at right angles, without friction or stiffness."""
    for index, family in enumerate(FAMILIES.values()):
        p = family(np.random.default_rng([31, index]), number)
        yield from (tuple(map(float, row)) for row in zip(*p.broadcast(*NAMES), strict=True))


def _truth(state: adaptive_precision.State, point: tuple[float, ...], contact: bool, digits: int) -> tuple[mpmath.mpf, ...]:
    return reference.refine(state.x, state.y, *point, contact=contact, digits=digits)


def _holds(states: tuple[adaptive_precision.State, ...], point: tuple[float, ...], contact: bool, digits: int) -> float:
    """Largest share of its bound that an error takes, of the numbers as they stand."""
    share = 0.0
    for state in states:
        with mpmath.workdps(2 * digits + 80):
            for name, true in zip(NUMBERS, _truth(state, point, contact, 2 * digits + 80), strict=True):
                share = max(share, float(abs(getattr(state, name) - true) / max(1, abs(true)) / state.error))
    return share


def _code(state: adaptive_precision.State, point: tuple[float, ...], contact: bool) -> int:
    """Stability by the roots of the characteristic polynomial of the stiffnesses, written out."""
    _, mu0, _, alpha, sigma, beta = map(mpmath.mpf, point)
    push = int(contact)
    with mpmath.workdps(60):
        s, c, L = mpmath.sin(state.theta), mpmath.cos(state.theta), state.L
        a, b = sigma * (1 - s * s / L) + alpha, sigma / L * s * c + mu0 * push
        d, e = sigma / L * s * c, sigma * (1 - c * c / L) + beta + push
        half, determinant = (a + e) / 2, a * e - b * d
        if half * half < determinant:
            return 3
        return 2 if min(half - mpmath.sqrt(half * half - determinant), half) < 0 else 1


@pytest.mark.parametrize("contact", [True, False])
def test_counts_codes_and_errors_of_the_ladder(contact: bool, arith: Arithmetic) -> None:
    for point in _points(3):
        found = adaptive_precision.equilibria(*point, contact=contact, arith=arith)
        assert not found.fold
        if contact:
            assert len(found.states) == reference.count_contact(*point)
        assert [state.theta for state in found.states] == sorted(state.theta for state in found.states)
        assert _holds(found.states, point, contact, 17) <= 1
        for state in found.states:
            assert state.error <= 1e-17
            assert state.stability == _code(state, point, contact)
            assert (state.y < 0) == contact
            assert state.L > 0


def test_no_more_bits_than_a_point_needs(arith: Arithmetic) -> None:
    """A wrong start or a loose enclosure shows in the bits that it takes."""
    for degrees in (20, 49, 90, 120, 160):
        point = (math.radians(degrees), *BASE[1:])
        assert adaptive_precision.equilibria(*point, arith=arith).bits == 128
    assert adaptive_precision.equilibria(*BASE, digits=60, arith=arith).bits == int(3.4 * 60) + 64
    assert adaptive_precision.equilibria(1.0, 0.0, 0.4, 0.0, 1.0, 0.0, arith=arith).bits == 128
    near = [point for point in _points(3) if adaptive_precision.equilibria(*point, arith=arith).bits > 256]
    assert len(near) <= 3


def test_widely_spread_parameters_are_settled(arith: Arithmetic) -> None:
    for point in ((1.0, 1e150, 1.0, 1e150, 1e150, 1e150), (1.0, 0.0, 1e-300, 0.0, 1e-3, 0.0), (1e-9, 0.5, 1e-9, 1e-9, 1e9, 1e-9)):
        found = adaptive_precision.equilibria(*point, arith=arith)
        assert len(found.states) == reference.count_contact(*point)
        assert _holds(found.states, point, True, 300) <= 1  # the bits that such a spread takes give as many digits


@pytest.fixture
def few_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bits end at 128, so that what is a fold to 40 digits is one to the last."""
    for name, value in (("FIRST_BITS", 128), ("MAXIMUM_BITS", 128), ("BITS_A_SPREAD", 0)):
        monkeypatch.setattr(adaptive_precision, name, value)


@pytest.mark.usefixtures("few_bits")
def test_a_fold_stands_in_two_slots_within_its_error(arith: Arithmetic) -> None:
    """Both folds of the base values, left and right: the double root, the simple one, and what is stable."""
    fixed = {name: Fraction(value) for name, value in zip(NAMES[1:], ("0.5", "0.007", "0.007", "0.1", "0"), strict=True)}
    with arith.precision(600):
        points = [
            [_middle(arith, value) for value in (point.parameters[0], point.theta, point.L, point.x, point.y)]
            for point in (fold.point for fold in fold_proofs.folds(arith, "theta0", fixed, 600))
        ]
    assert len(points) == 2
    for theta0, *true in points:
        found = adaptive_precision.equilibria(theta0, *fixed.values(), arith=arith)
        assert found.fold
        assert len(found.states) == 3
        one, two = next(pair for pair in (found.states[:2], found.states[1:]) if pair[0].theta == pair[1].theta)
        for state in (one, two):
            assert state.error < 1e-17
            for name, value in zip(NUMBERS, true, strict=True):
                assert abs(as_fraction(getattr(state, name)) - value) <= as_fraction(state.error) * max(1, abs(value))
            assert state.stability == 1
        [other] = [state for state in found.states if state.theta != one.theta]
        assert other.stability == 1
        assert all(abs(value - state) > 0.1 for value, state in ((other.theta, one.theta), (other.x, one.x)))


@pytest.mark.usefixtures("few_bits")
def test_a_boundary_that_no_bits_settle_is_an_error(arith: Arithmetic) -> None:
    """The mass at the anchor of the spring: with α = β = 0 and κ = σ the balance holds at θ = −π/2 with L = 0 exactly."""
    with pytest.raises(ss.ConvergenceError, match=r"128 bits do not settle theta0=.*: L or y holds 0; move the point off"):
        adaptive_precision.equilibria(1, 0, Fraction(1, 2), 0, Fraction(1, 2), 0, contact=False, arith=arith)


@pytest.mark.parametrize(("values", "powers"), [
    ([1] * 6, 0), ([1, 0, 1, 0, 1, 0], 0), ([1, 2**10, 1, 1, 1, 1], 10), ([1, 1, Fraction(1, 2**10), 1, 1, 1], 10),
    ([1, 2**10, 1, 1, 1, Fraction(1, 2**30)], 40), ([2.0**-20, 1, 1, 1, 1, 1], 20),
    ([1, *[2**10] * 5], 10),  # equations have coefficients of 1 as well
])  # fmt: skip
def test_most_bits_grow_with_the_spread(values: list[Any], powers: int) -> None:
    theta0, *others = map(Fraction, values)
    most = adaptive_precision.MAXIMUM_BITS + powers * adaptive_precision.BITS_A_SPREAD
    for given in (theta0, lambda arith: arith.pi()) if theta0 == 1 else (theta0,):
        assert adaptive_precision._most_bits(given, others) == most
    assert adaptive_precision.BITS_A_SPREAD >= 6  # a discriminant of the sixth degree


@pytest.mark.parametrize("power", [20, 34, 50])
def test_next_to_a_fold_bits_are_added_until_all_is_decided(power: int, arith: Arithmetic) -> None:
    """10^−power beside both folds: counts on either side, no fold, and the digits asked for."""
    fixed = {name: Fraction(value) for name, value in zip(NAMES[1:], (0.5, 2**-7, 2**-7, 0.125, 0.0), strict=True)}
    with arith.precision(600):
        folds = sorted(_middle(arith, fold.point.parameters[0]) for fold in fold_proofs.folds(arith, "theta0", fixed, 600))
    assert len(folds) == 2
    for fold, side in zip(folds, (1, -1), strict=True):
        outside, inside = fold + side * Fraction(1, 10**power), fold - side * Fraction(1, 10**power)
        counts = []
        for theta0 in (outside, inside):
            for digits in (17, 60):
                found = adaptive_precision.equilibria(theta0, *fixed.values(), digits=digits, arith=arith)
                assert not found.fold
                with mpmath.workprec(700):
                    point = (mpmath.mpf(theta0.numerator) / theta0.denominator, *map(float, fixed.values()))
                assert _holds(found.states, point, True, digits + power) <= 1
                allowed = mpmath.mpf(10) ** -digits
                assert all(state.error <= allowed for state in found.states)
                codes = [state.stability for state in found.states]
                assert codes == ([1, 2, 1] if len(codes) == 3 else [1])
            counts.append(len(found.states))
        assert sorted(counts) == [1, 3]


def _middle(arith: Arithmetic, value: Any) -> Fraction:
    low, high = arith.ends(value)
    return (low + high) / 2


# ------------------------------------------------------------------------------------------------------ its parts


@pytest.fixture
def held(arith: Arithmetic) -> Iterator[Arithmetic]:
    """An arithmetic at 128 bits."""
    with arith.precision(128):
        yield arith


def _float(arith: Arithmetic, value: Any) -> float:
    return float(_middle(arith, value))


def test_seventeen_digits_and_our_own_arithmetic_unless_told_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    assert adaptive_precision.equilibria(*BASE) == adaptive_precision.equilibria(*BASE, arith=intervals.arithmetic())
    monkeypatch.setattr(adaptive_precision, "_settle", lambda arith, theta0, rational, contact, digits, *_: digits)
    assert adaptive_precision.equilibria(*BASE) == 17


#: P and Q of z³ + 3 P z = 2 Q: around powers of two of any remainder by 2 and 3, either one 0, P of either sign.
_ABOUT = [Fraction(share) * Fraction(2) ** power for power in (*range(-7, 8), -100, 100) for share in ("0.5", "0.75", "0.999999")]
_NEAR = [value for value in _ABOUT if 2**-7 < value < 2**7]
CUBICS = [
    *((Fraction(0), Q) for Q in _ABOUT), *((-P, Fraction(0)) for P in _ABOUT), *((-P, Q) for P in _NEAR for Q in _NEAR),
    *((P, Q) for P in _NEAR for Q in _NEAR), *((sign * P, Q) for sign in (1, -1) for P in _ABOUT[-6:] for Q in _ABOUT[-6:]),
]  # fmt: skip


def _largest_root(P: Fraction, Q: Fraction) -> mpmath.mpf:
    """By Cardano's formulas, the trigonometric one where all roots are real."""
    P, Q = (mpmath.mpf(value.numerator) / value.denominator for value in (P, Q))
    inside = P**3 + Q**2
    if inside < 0:
        return 2 * mpmath.sqrt(-P) * mpmath.cos(mpmath.acos(min(mpmath.mpf(1), Q / mpmath.sqrt(-P) ** 3)) / 3)
    w = mpmath.cbrt(Q + mpmath.sqrt(inside))
    return w - P / w


@pytest.mark.thorough
def test_newtons_start_is_above_the_root_and_not_far(held: Arithmetic) -> None:
    with mpmath.workdps(120):
        for P, Q in CUBICS:
            start = mpmath.mpf(2) ** adaptive_precision._power_above(held, held.exact(P), held.exact(Q))
            root = _largest_root(P, Q)
            assert start >= root
            if P > 0:  # next to the smaller of two bounds on the root
                cube, line = mpmath.cbrt(2 * mpmath.mpf(Q.numerator) / Q.denominator), 2 * Q / (3 * P)
                assert start <= min(2 * cube, 6 * mpmath.mpf(line.numerator) / line.denominator)
            else:
                assert start <= root * (2 if P == 0 else 2.32 if Q == 0 else 3.18)
    for P in (0, 1, 7):  # there is none to begin with
        assert _float(held, adaptive_precision._farthest_root(held, held.exact(Fraction(P)), held.exact(Fraction(0)), 128)) == 0


@pytest.mark.parametrize("trig", [
    ("0", "-1", "0", "1e6"), ("0", "2", "1", "1e6"), ("-1/2", "-1e-12", "0", "0"), ("-1/2", "1e-12", "0", "1/3"),
    ("3", "1e-12", "0", "0"), ("3", "-1", "1", "1/3"), ("-1/2", "2", "1", "1/3"), ("3", "2", "0", "0"),
])  # fmt: skip
def test_the_quartic_is_split_to_its_last_digits(arith: Arithmetic, trig: tuple[str, ...]) -> None:
    """By seven times as many bits, which multiply to the quartic; −q₁ and q₂ may be a million times each other's size."""

    def split(bits: int) -> list[Fraction]:
        with arith.precision(bits):
            return [
                _middle(arith, value)
                for value in adaptive_precision._split(arith, tuple(arith.exact(Fraction(v)) for v in trig), bits)
            ]

    p1, q1, p2, q2 = split(900)
    quartic = kernel.t_quartic(*map(Fraction, trig))
    for product, wanted in ((p1 * q2 + p2 * q1, quartic[1]), (q1 + q2 + p1 * p2, quartic[2]), (p1 + p2, quartic[3])):
        assert abs(product - wanted / quartic[4]) <= (abs(p1 * q2) + abs(p2 * q1) + abs(q1) + q2 + 1) / 2**700
    assert abs(q1 * q2 + 1) < Fraction(1, 2**700)
    for found, wanted in zip(split(128), (p1, q1, p2, q2), strict=True):
        assert abs(found - wanted) <= abs(wanted) / 2**110


def test_an_enclosure_is_in_order_and_a_root_without_a_change_of_sign_is_none(held: Arithmetic) -> None:
    for root in (Fraction(3, 7), Fraction(-3, 7), Fraction(0)):
        around = held.exact(root + Fraction(1, 10**9) * (root != 0))
        quartic = tuple(held.exact(value) for value in (-root, Fraction(1), Fraction(0), Fraction(0), Fraction(0)))
        if not root:
            with pytest.raises(Undecided, match="no change of sign"):
                adaptive_precision._enclose(held, quartic, around, 128)
            continue
        low, high = (_middle(held, value) for value in adaptive_precision._enclose(held, quartic, around, 128))
        assert low < root < high
        assert high - low < 1e-3
    positive = tuple(held.exact(Fraction(value)) for value in (1, 0, 0, 0, 1))
    with pytest.raises(Undecided, match="no change of sign"):
        adaptive_precision._enclose(held, positive, held.exact(Fraction(1)), 128)


def test_roots_that_share_an_interval_are_undecided(monkeypatch: pytest.MonkeyPatch, held: Arithmetic) -> None:
    ends = {-3: (-4, -2), 2: (1, 3), 5: (4, 6), 7: (6.5, 8)}
    roots = {1: (-3, 2, 0), 2: (5, 7, 0)}

    def exact(value):
        return held.exact(Fraction(value))

    monkeypatch.setattr(adaptive_precision, "_split", lambda *_: (1, 1, 2, 2))
    monkeypatch.setattr(adaptive_precision, "_real_parts", lambda _, p, q: roots[p])
    monkeypatch.setattr(adaptive_precision, "_enclose", lambda _, quartic, root, bits: tuple(map(exact, ends[root])))
    trig = tuple(map(exact, (1, 1, 1, 1)))
    for all_real, number in ((True, 4), (False, 2)):
        found = adaptive_precision._enclosed_roots(held, trig, 128, all_real=all_real)
        for value, wanted in zip(found, list(ends.values())[:number], strict=True):
            assert [float(end) for end in held.ends(value)] == pytest.approx(wanted, rel=1e-6)
    for one, other in itertools.permutations(ends, 2):
        for shared in ((ends[one][0] - 1, ends[one][0] + 0.25), ends[one], (ends[one][1] - 0.25, ends[one][1] + 1)):
            with monkeypatch.context() as patch:
                patch.setitem(ends, other, shared)
                with pytest.raises(Undecided, match="share an interval"):
                    adaptive_precision._enclosed_roots(held, trig, 128, all_real=True)


@pytest.mark.parametrize("middle", [3, -3])
@pytest.mark.parametrize("square", [Fraction(1, 2**100), -Fraction(1, 2**100), Fraction(1, 2**120), Fraction(0)])
def test_a_double_root_lies_within_twice_its_parts_and_half_its_digits(
    monkeypatch: pytest.MonkeyPatch, held: Arithmetic, middle: int, square: Fraction
) -> None:
    """The second factor is (t − middle)² − square, the first one (t − 7)(t − 8)."""
    parts = (Fraction(-15), Fraction(56), Fraction(-2 * middle), middle**2 - square)
    monkeypatch.setattr(adaptive_precision, "_split", lambda *_: tuple(map(held.exact, parts)))
    monkeypatch.setattr(adaptive_precision, "_enclose", lambda _, quartic, root, bits: (root, root))
    one, two, *simple = adaptive_precision._fold_roots(held, tuple(held.exact(Fraction(1)) for _ in range(4)), 128)
    assert sorted(_float(held, value) for value in simple) == [7, 8]
    assert held.ends(one) == held.ends(two)
    low, high = held.ends(one)
    width = 2 * math.sqrt(abs(square)) + 3 * 2.0**-64
    for off in (middle - low, high - middle):
        assert float(off) == pytest.approx(width, rel=1e-6, abs=0.0)


def test_contact_has_an_odd_number_of_equilibria(monkeypatch: pytest.MonkeyPatch, held: Arithmetic) -> None:
    plain = adaptive_precision._state
    monkeypatch.setattr(adaptive_precision, "_state", lambda *given: 2 * plain(*given))
    rational = list(map(Fraction, BASE[1:]))
    assert len(adaptive_precision._settle(held, BASE[0], rational, False, 17, 128, False).states) % 2 == 0
    with pytest.raises(Undecided, match="even number"):
        adaptive_precision._settle(held, BASE[0], rational, True, 17, 128, False)


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize(
    ("ends", "error"),
    [((7, 9), Fraction(1, 7)), ((-9, -7), Fraction(1, 7)), ((Fraction(1, 8), Fraction(3, 8)), Fraction(1, 8)),
     ((Fraction(3, 4), Fraction(7, 4)), Fraction(1, 2)), ((Fraction(-1, 16), Fraction(1, 16)), Fraction(1, 16))],
)  # fmt: skip
def test_an_error_is_over_the_smallest_value_that_it_may_be_of(
    monkeypatch: pytest.MonkeyPatch, held: Arithmetic, place: int, ends: tuple[Fraction, Fraction], error: Fraction
) -> None:
    """Half the width over max(1, |value|)."""
    if (place == 0 and ends[0] < 0) or (place == 2 and ends[1] > 0):  # L > 0 and y < 0
        return
    given = [held.exact(Fraction(value)) for value in (1, 1, -1)]
    given[place] = held.between(*map(Fraction, ends))
    [state] = _states(monkeypatch, held, given, digits=0)
    assert error <= as_fraction(state.error) <= error * (1 + Fraction(1, 10**6))


def _states(monkeypatch: pytest.MonkeyPatch, arith: Arithmetic, given: list[Any], digits: int, fold: bool = False) -> Any:
    monkeypatch.setattr(kernel, "state", lambda *_: tuple(given))
    monkeypatch.setattr(adaptive_precision, "_stability", lambda *_: 1)
    t, values = arith.exact(Fraction(1, 2)), (*[arith.exact(Fraction(1))] * 7, 1)
    return adaptive_precision._state(arith, t, values[:4], values, digits, fold)


def test_an_error_above_what_is_asked_for_is_undecided_but_on_a_fold(monkeypatch: pytest.MonkeyPatch, held: Arithmetic) -> None:
    one, minus = held.exact(Fraction(1)), held.exact(Fraction(-1))

    def states(half: Fraction, digits: int, fold: bool = False) -> Any:
        return _states(monkeypatch, held, [one, held.between(-half, half), minus], digits, fold)

    if isinstance(held, intervals.Balls):  # whose radius is what is asked for
        assert len(states(Fraction(1), 0)) == 1  # as large as is allowed
    assert len(states(Fraction(95, 1000), 1)) == 1
    assert len(states(Fraction(105, 1000), 1, fold=True)) == 1
    with pytest.raises(Undecided, match="an error of"):
        states(Fraction(105, 1000), 1)


def test_lengths_and_sides_that_hold_0_are_undecided(monkeypatch: pytest.MonkeyPatch, held: Arithmetic) -> None:
    one, minus, open_one = held.exact(Fraction(1)), held.exact(Fraction(-1)), held.between(Fraction(-1), Fraction(1))
    for L, y, number in ((one, minus, 1), (minus, minus, 0), (one, one, 0), (minus, open_one, 0), (open_one, one, 0)):
        assert len(_states(monkeypatch, held, [L, one, y], 0)) == number
    for L, y in ((open_one, minus), (one, open_one)):
        with pytest.raises(Undecided, match="L or y holds 0"):
            _states(monkeypatch, held, [L, one, y], 0)


@pytest.mark.parametrize("fold", [True, False])
def test_kinds_by_the_signs_of_what_decides_them(monkeypatch: pytest.MonkeyPatch, held: Arithmetic, fold: bool) -> None:
    """λ² − trace λ + slope: flutter where they are not real; on a fold one of them is 0, and the trace is the other one."""
    signs = {sign: held.between(Fraction(sign) - Fraction(1, 2), Fraction(sign) + Fraction(1, 2)) for sign in (-1, 0, 1)}
    unit = held.exact(Fraction(1))
    for flutter, slope, trace in itertools.product((-1, 0, 1), repeat=3):
        monkeypatch.setattr(kernel, "invariants", lambda *_, t=trace, f=flutter: (signs[t], unit, signs[f]))
        monkeypatch.setattr(kernel, "f_slope", lambda *_, s=slope: signs[s])
        call = (held, unit, unit, unit, (unit,) * 4, (unit,) * 7 + (1,), fold)
        if flutter < 0:
            wanted = 3
        elif flutter == 0:
            wanted = None
        elif slope < 0:
            wanted = 2
        elif (slope == 0 and not fold) or trace == 0:
            wanted = None
        else:
            wanted = 1 if trace > 0 else 2
        if wanted is None:
            with pytest.raises(Undecided, match="a stability boundary"):
                adaptive_precision._stability(*call)
        else:
            assert adaptive_precision._stability(*call) == wanted


@pytest.mark.parametrize("digits", [1, 18, 40, 120])
def test_errors_hold_at_any_number_of_digits(digits: int, arith: Arithmetic) -> None:
    for point in [BASE, *list(_points(1))[::2]]:
        found = adaptive_precision.equilibria(*point, digits=digits, arith=arith)
        assert _holds(found.states, point, True, digits) <= 1
        assert all(state.error <= mpmath.mpf(10) ** -digits for state in found.states)
