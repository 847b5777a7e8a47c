"""Equilibria with proofs: counts, codes and errors against Newton's method on the forces, with many
more digits.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam import folds, kernel
from spragsym.kang_nam.quartic import adaptive_precision
from spragsym.numerics import balls
from spragsym.numerics.balls import UndecidedSign
from spragsym.results.precise_states import PreciseEquilibrium
from tests.oracles import reference
from tests.oracles.families import FAMILIES
from tests.support import as_fraction

NUMBERS = ("theta", "L", "x", "y")
BASE = (math.radians(30), 0.5, 0.007, 0.007, 0.1, 0.0)


def _points(number: int) -> Iterator[tuple[float, ...]]:
    """Points of every family: next to folds and cusps, at right angles, without friction or
    stiffness.
    """
    for index, family in enumerate(FAMILIES.values()):
        p = family(np.random.default_rng([31, index]), number)
        yield from (tuple(map(float, row)) for row in zip(*p.broadcast(*PARAMETERS), strict=True))


def _truth(
    state: PreciseEquilibrium, point: tuple[float, ...], contact: bool, digits: int
) -> tuple[mpmath.mpf, ...]:
    return reference.refine(state.x, state.y, *point, contact=contact, digits=digits)


def _holds(
    states: tuple[PreciseEquilibrium, ...], point: tuple[float, ...], contact: bool, digits: int
) -> float:
    """Largest share of its bound that an error takes, of the numbers as they stand."""
    share = 0.0
    for state in states:
        with mpmath.workdps(2 * digits + 80):
            for name, true in zip(
                NUMBERS, _truth(state, point, contact, 2 * digits + 80), strict=True
            ):
                share = max(
                    share, float(abs(getattr(state, name) - true) / max(1, abs(true)) / state.error)
                )
    return share


def _code(state: PreciseEquilibrium, point: tuple[float, ...], contact: bool) -> int:
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
def test_counts_codes_and_errors_of_the_ladder(contact: bool) -> None:
    count = reference.count_contact if contact else reference.count_liftoff
    for point in _points(3):
        found = adaptive_precision.equilibria(*point, contact=contact)
        assert not any(state.fold for state in found)
        assert len(found.states) == count(*point)
        assert [state.theta for state in found.states] == sorted(
            state.theta for state in found.states
        )
        assert _holds(found.states, point, contact, 17) <= 1
        for state in found.states:
            assert state.error <= 1e-17
            assert state.undamped == _code(state, point, contact)
            assert (state.y < 0) == contact
            assert state.L > 0


@pytest.fixture
def few_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bits end where they begin, so that what is a fold to 40 digits is one to the last."""
    monkeypatch.setattr(adaptive_precision, "MAXIMUM_BITS", 0)


@pytest.mark.usefixtures("few_bits")
def test_a_fold_stands_in_two_slots_within_its_error() -> None:
    """Both folds of the base values, left and right: the double root, the simple one, and what is
    stable.
    """
    fixed = {
        name: Fraction(value)
        for name, value in zip(PARAMETERS[1:], ("0.5", "0.007", "0.007", "0.1", "0"), strict=True)
    }
    with balls.precision(600):
        points = [
            [
                _middle(value)
                for value in (point.parameters[0], point.theta, point.L, point.x, point.y)
            ]
            for point in (fold.point for fold in folds.proved_folds("theta0", fixed, 600))
        ]
    assert len(points) == 2
    for theta0, *true in points:
        found = adaptive_precision.equilibria(theta0, *fixed.values())
        assert all(state.fold for state in found)
        assert len(found.states) == 3
        one, two = next(
            pair for pair in (found.states[:2], found.states[1:]) if pair[0].theta == pair[1].theta
        )
        for state in (one, two):
            assert state.error < 1e-17
            for name, value in zip(NUMBERS, true, strict=True):
                assert abs(as_fraction(getattr(state, name)) - value) <= as_fraction(
                    state.error
                ) * max(1, abs(value))
            assert state.undamped == 1
        [other] = [state for state in found.states if state.theta != one.theta]
        assert other.undamped == 1
        assert all(
            abs(value - state) > 0.1
            for value, state in ((other.theta, one.theta), (other.x, one.x))
        )


@pytest.mark.usefixtures("few_bits")
def test_a_boundary_that_no_bits_settle_is_an_error() -> None:
    """The mass at the anchor, θ = −π/2 and L = 0, but for a difference of preload and stiffness
    that 128 bits do not see.
    """
    stiffness = Fraction(1, 2) + Fraction(1, 10**60)
    with pytest.raises(
        ss.errors.ConvergenceError,
        match=r"128 bits do not settle theta0=.*: L or y holds 0; move the point off",
    ):
        adaptive_precision.equilibria(1, 0, Fraction(1, 2), 0, stiffness, 0, contact=False)


@pytest.mark.parametrize("power", [20, 34, 50])
def test_next_to_a_fold_bits_are_added_until_all_is_decided(power: int) -> None:
    """10^−power beside both folds: counts on either side, no fold, and the digits asked for."""
    fixed = {
        name: Fraction(value)
        for name, value in zip(PARAMETERS[1:], (0.5, 2**-7, 2**-7, 0.125, 0.0), strict=True)
    }
    with balls.precision(600):
        places = sorted(
            _middle(fold.point.parameters[0]) for fold in folds.proved_folds("theta0", fixed, 600)
        )
    assert len(places) == 2
    for place, side in zip(places, (1, -1), strict=True):
        outside, inside = (
            place + side * Fraction(1, 10**power),
            place - side * Fraction(1, 10**power),
        )
        counts = []
        for theta0 in (outside, inside):
            for digits in (17, 60):
                found = adaptive_precision.equilibria(theta0, *fixed.values(), digits=digits)
                assert not any(state.fold for state in found)
                with mpmath.workprec(700):
                    point = (
                        mpmath.mpf(theta0.numerator) / theta0.denominator,
                        *map(float, fixed.values()),
                    )
                assert _holds(found.states, point, True, digits + power) <= 1
                allowed = mpmath.mpf(10) ** -digits
                assert all(state.error <= allowed for state in found.states)
                codes = [state.undamped for state in found.states]
                assert codes == ([1, 2, 1] if len(codes) == 3 else [1])
            counts.append(len(found.states))
        assert sorted(counts) == [1, 3]


def _middle(value: Any) -> Fraction:
    low, high = balls.ends(value)
    return (low + high) / 2


# ------------------------------------------------------------------------------------------------
# its parts


def test_contact_has_an_odd_number_of_equilibria(monkeypatch: pytest.MonkeyPatch) -> None:
    plain = adaptive_precision._state
    monkeypatch.setattr(adaptive_precision, "_state", lambda *given: 2 * plain(*given))
    rational = list(map(Fraction, BASE[1:]))
    with balls.precision(128):
        assert (
            len(adaptive_precision._settle(BASE[0], rational, False, 17, 128, False).states) % 2
            == 0
        )
        with pytest.raises(UndecidedSign, match="even number"):
            adaptive_precision._settle(BASE[0], rational, True, 17, 128, False)


def _states(
    monkeypatch: pytest.MonkeyPatch, given: list[Any], digits: int, fold: bool = False
) -> Any:
    monkeypatch.setattr(kernel, "state", lambda *_: tuple(given))
    monkeypatch.setattr(adaptive_precision, "_stability", lambda *_: 1)
    t, values = balls.exact(Fraction(1, 2)), (*[balls.exact(Fraction(1))] * 7, 1)
    return adaptive_precision._state(t, values[:4], values, digits, fold, shrunk=False)


def test_lengths_and_sides_that_hold_0_are_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    one, minus, open_one = (
        balls.exact(Fraction(1)),
        balls.exact(Fraction(-1)),
        balls.between(Fraction(-1), Fraction(1)),
    )
    for L, y, number in (
        (one, minus, 1),
        (minus, minus, 0),
        (one, one, 0),
        (minus, open_one, 0),
        (open_one, one, 0),
    ):
        assert len(_states(monkeypatch, [L, one, y], 0)) == number
    for L, y in ((open_one, minus), (one, open_one)):
        with pytest.raises(UndecidedSign, match="L or y holds 0"):
            _states(monkeypatch, [L, one, y], 0)
