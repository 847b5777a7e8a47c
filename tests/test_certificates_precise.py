"""Equilibria, folds and cusps with proofs: counts and errors against Newton's method on the forces, with many more digits."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from benchmarks import reference
from benchmarks.families import FAMILIES
from spragsym import intervals, ladder, proofs
from spragsym.intervals import Arithmetic
from spragsym.parameters import NAMES

ARITHMETICS = ["mpmath", *(["python-flint"] if importlib.util.find_spec("flint") else [])]
NUMBERS = ("theta", "L", "x", "y")
BASE = (math.radians(30), 0.5, 0.007, 0.007, 0.1, 0.0)


@pytest.fixture(params=ARITHMETICS)
def arith(request: pytest.FixtureRequest) -> Arithmetic:
    """Both interval arithmetics."""
    return intervals.arithmetic(request.param)


def _points(number: int) -> Iterator[tuple[float, ...]]:
    """Points of every family: next to folds and cusps, at right angles, without friction or stiffness."""
    for index, family in enumerate(FAMILIES.values()):
        p = family(np.random.default_rng([31, index]), number)
        yield from (tuple(map(float, row)) for row in zip(*p.broadcast(*NAMES), strict=True))


def _truth(state: ladder.State, point: tuple[float, ...], contact: bool, digits: int) -> tuple[mpmath.mpf, ...]:
    return reference.refine(state.x, state.y, *point, contact=contact, digits=digits)


def _holds(states: tuple[ladder.State, ...], point: tuple[float, ...], contact: bool, digits: int) -> float:
    """Largest share of its bound that an error takes; numbers as a float has them where 17 digits are asked for."""
    share = 0.0
    for state in states:
        with mpmath.workdps(2 * digits + 80):
            for name, true in zip(NUMBERS, _truth(state, point, contact, 2 * digits + 80), strict=True):
                value = getattr(state, name)
                for given in (value, mpmath.mpf(float(value)))[: 2 if digits <= 17 else 1]:
                    share = max(share, float(abs(given - true) / max(1, abs(true)) / state.error))
    return share


def _code(state: ladder.State, point: tuple[float, ...], contact: bool) -> int:
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
    shares = []
    for point in _points(3):
        found = ladder.equilibria(*point, contact=contact, arith=arith)
        assert not found.fold
        if contact:
            assert len(found.states) == reference.count_contact(*point)
        assert [state.theta for state in found.states] == sorted(state.theta for state in found.states)
        shares.append(_holds(found.states, point, contact, 17))
        assert shares[-1] <= 1
        for state in found.states:
            assert state.error < 2e-16
            assert state.stability == _code(state, point, contact)
            assert (state.y < 0) == contact
            assert state.L > 0
    assert max(shares) > 0.55  # half a unit in the last place of a float, and not much more


@pytest.mark.parametrize("digits", [1, 18, 40, 120])
def test_errors_hold_at_any_number_of_digits(digits: int, arith: Arithmetic) -> None:
    for point in [BASE, *list(_points(1))[::2]]:
        found = ladder.equilibria(*point, digits=digits, arith=arith)
        assert _holds(found.states, point, True, digits) <= 1
        assert all(state.error < mpmath.mpf(10) ** -min(digits, 17 if digits <= 17 else digits) for state in found.states)


def test_no_more_bits_than_a_point_needs(arith: Arithmetic) -> None:
    """A wrong start or a loose enclosure shows in the bits that it takes."""
    for degrees in (20, 49, 90, 120, 160):
        point = (math.radians(degrees), *BASE[1:])
        assert ladder.equilibria(*point, arith=arith).bits == 128
    assert ladder.equilibria(*BASE, digits=60, arith=arith).bits == int(3.4 * 60) + 64
    assert ladder.equilibria(1.0, 0.0, 0.4, 0.0, 1.0, 0.0, arith=arith).bits == 128
    near = [point for point in _points(3) if ladder.equilibria(*point, arith=arith).bits > 256]
    assert len(near) <= 3


def test_widely_spread_parameters_are_settled(arith: Arithmetic) -> None:
    for point in ((1.0, 1e150, 1.0, 1e150, 1e150, 1e150), (1.0, 0.0, 1e-300, 0.0, 1e-3, 0.0), (1e-9, 0.5, 1e-9, 1e-9, 1e9, 1e-9)):
        found = ladder.equilibria(*point, arith=arith)
        assert len(found.states) == reference.count_contact(*point)
        assert _holds(found.states, point, True, 17) <= 1


@pytest.fixture
def few_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bits end at 128, so that what is a fold to 40 digits is one to the last."""
    for name, value in (("FIRST_BITS", 128), ("MAXIMUM_BITS", 128), ("BITS_A_SPREAD", 0)):
        monkeypatch.setattr(ladder, name, value)


def _fraction(value: mpmath.mpf) -> Fraction:
    negative, mantissa, exponent, _ = value._mpf_
    return (-1) ** negative * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


@pytest.mark.usefixtures("few_bits")
def test_a_fold_stands_in_two_slots_within_its_error(arith: Arithmetic) -> None:
    """Both folds of the base values, left and right: the double root, the simple one, and what is stable."""
    fixed = {name: Fraction(value) for name, value in zip(NAMES[1:], ("0.5", "0.007", "0.007", "0.1", "0"), strict=True)}
    with arith.precision(600):
        points = [
            tuple((low + high) / 2 for low, high in map(arith.ends, (point.parameters[0], point.theta, point.L, point.x, point.y)))
            for point in proofs.folds(arith, "theta0", fixed, 600)
        ]
    points = [point for point in points if 0 < point[0] < math.pi]
    assert len(points) == 2
    for theta0, *true in points:
        found = ladder.equilibria(_fraction(theta0), *fixed.values(), arith=arith)
        assert found.fold
        assert len(found.states) == 3
        one, two = next(pair for pair in (found.states[:2], found.states[1:]) if pair[0].theta == pair[1].theta)
        for state in (one, two):
            assert state.error < 1.2e-16
            for name, value in zip(NUMBERS, true, strict=True):
                assert abs(getattr(state, name) - value) <= state.error * max(1, abs(value))
            assert state.stability == 1
        [other] = [state for state in found.states if state.theta != one.theta]
        assert other.stability == 1
        assert all(abs(value - state) > 0.1 for value, state in ((other.theta, one.theta), (other.x, one.x)))


@pytest.mark.usefixtures("few_bits")
def test_a_boundary_that_no_bits_settle_is_an_error(arith: Arithmetic) -> None:
    """The mass at the anchor of the spring: with α = β = 0 and κ = σ the balance holds at θ = −π/2 with L = 0 exactly."""
    with pytest.raises(ss.ConvergenceError, match=r"128 bits do not settle theta0=.*move the point off"):
        ladder.equilibria(1, 0, Fraction(1, 2), 0, Fraction(1, 2), 0, contact=False, arith=arith)


def test_most_bits_grow_with_the_spread() -> None:
    def most(*values: Any) -> int:
        return ladder._most_bits(lambda a: a.pi(), [Fraction(value) for value in values])

    assert most(1, 1, 1, 1, 1) == ladder.MAXIMUM_BITS
    assert most(0, 1, 0, 1, 0) == ladder.MAXIMUM_BITS
    assert most(2**10, 1, 1, 1, 1) == most(1, Fraction(1, 2**10), 1, 1, 1) == ladder.MAXIMUM_BITS + 10 * ladder.BITS_A_SPREAD
    assert most(2**10, 1, 1, 1, Fraction(1, 2**30)) == ladder.MAXIMUM_BITS + 40 * ladder.BITS_A_SPREAD
    assert ladder._most_bits(2.0**-20, [Fraction(1)] * 5) == ladder.MAXIMUM_BITS + 20 * ladder.BITS_A_SPREAD
    assert ladder.BITS_A_SPREAD >= 6  # a discriminant of the sixth degree


# ------------------------------------------------------------------------------------------- proofs: the means


def test_bits_are_doubled_until_every_sign_is_decided(arith: Arithmetic) -> None:
    tried: list[int] = []

    def attempt(bits: int) -> Fraction:
        tried.append(bits)
        low, high = arith.ends(arith.exact(Fraction(1, 3)))
        assert mpmath.ldexp(1, -bits - 8) < high - low < mpmath.ldexp(1, 3 - bits)  # the precision is that of the attempt
        if bits < 1000:
            raise (proofs.Undecided if bits < 400 else ZeroDivisionError)("not yet")
        return Fraction(bits)

    assert proofs.with_enough_bits(arith, 10, attempt, "this") == 1536
    assert tried == [192, 384, 768, 1536]
    tried.clear()
    assert proofs.with_enough_bits(arith, 300, attempt, "this") == 1116
    assert tried == [int(3.4 * 300) + 96]


def test_bits_end_with_a_reason(arith: Arithmetic) -> None:
    tried: list[int] = []

    def attempt(bits: int) -> None:
        tried.append(bits)
        raise proofs.Undecided("a wall")

    with pytest.raises(ss.ConvergenceError, match=r"^folds: 6144 bits do not decide it \(a wall\)"):
        proofs.with_enough_bits(arith, 10, attempt, "folds")
    assert tried == [192 * 2**k for k in range(6)]


def test_a_sign_that_must_be_there(arith: Arithmetic) -> None:
    with arith.precision(60):
        assert proofs.decided(arith, arith.exact(Fraction(1, 9)), "x") == 1
        assert proofs.decided(arith, arith.exact(Fraction(-1, 9)), "x") == -1
        with pytest.raises(proofs.Undecided, match="what it is"):
            proofs.decided(arith, arith.between(mpmath.mpf(0), mpmath.mpf(1)), "what it is")


def test_angles_in_every_quadrant(arith: Arithmetic) -> None:
    with arith.precision(80), mpmath.workprec(200):
        for k in range(-23, 25):
            true = mpmath.pi * k / 24
            cosine, sine = (arith.between(value - mpmath.ldexp(1, -60), value + mpmath.ldexp(1, -60))
                            for value in (mpmath.cos(true), mpmath.sin(true)))  # fmt: skip
            if k == 24:
                with pytest.raises(proofs.Undecided, match="0 or π"):
                    proofs.angle(arith, cosine, sine)
                continue
            low, high = arith.ends(proofs.angle(arith, cosine, sine))
            assert low <= true <= high
            assert high - low < 1e-15


def test_rationals_become_numbers() -> None:
    for value in (Fraction(1, 3), Fraction(-7, 2**900), Fraction(3**200, 2**5), Fraction(0), Fraction(2**500 + 1, 3**10)):
        found = _fraction(proofs._number(value))
        if value.denominator & (value.denominator - 1) == 0:
            assert found == value
        else:
            assert abs(found - value) < abs(value) * Fraction(1, 2**63)


# ---------------------------------------------------------------------------------------------- folds and cusps


def _f(theta: mpmath.mpf, values: list[mpmath.mpf]) -> mpmath.mpf:
    """q sin θ F_x along F_y = 0, from the balance of forces."""
    theta0, mu0, kappa, alpha, sigma, beta = values
    s, c, s0, c0 = mpmath.sin(theta), mpmath.cos(theta), mpmath.sin(theta0), mpmath.cos(theta0)
    L = (sigma * s + (beta + 1) * s0 + kappa) / ((beta + 1 + sigma) * s)
    return s * (sigma * (1 - L) * c + alpha * (c0 - L * c) + mu0 * (s0 - L * s))


def _middle(arith: Arithmetic, value: Any) -> mpmath.mpf:
    low, high = arith.ends(value)
    return (low + high) / 2


def _check(arith: Arithmetic, point: proofs.Point, orders: int, digits: int) -> None:
    """f and its derivatives vanish there to so many digits, the state is that of the geometry, and it is in contact."""
    values = [_middle(arith, value) for value in point.parameters]
    theta, L, x, y = (_middle(arith, value) for value in (point.theta, point.L, point.x, point.y))
    for value in (*point.parameters, point.theta, point.L, point.x, point.y):
        low, high = arith.ends(value)
        assert high - low <= mpmath.mpf(10) ** -digits * max(1, abs(low))
    with mpmath.workdps(digits + 20):
        for order in range(orders):
            size = 1 + sum(map(abs, values[1:]))
            assert abs(mpmath.diff(lambda t: _f(t, values), theta, order)) < mpmath.mpf(10) ** -(digits - 8) * size
        assert abs(mpmath.cos(values[0]) - L * mpmath.cos(theta) - x) < mpmath.mpf(10) ** -(digits - 4) * (1 + L)
        assert abs(mpmath.sin(values[0]) - L * mpmath.sin(theta) - y) < mpmath.mpf(10) ** -(digits - 4) * (1 + L)
    assert L > 0
    assert y < 0


def _rationals(seed: int, number: int) -> Iterator[list[Fraction]]:
    """κ, α, σ, β where folds are common, α = 0 and β = 0 among them."""
    rng = np.random.default_rng(seed)
    for trial in range(number):
        decades = ((0, 1.3), (0, 1.5), (1.3, 2.6), (0, 2.5))
        kappa, alpha, sigma, beta = (Fraction(int(10 ** rng.uniform(*ends)), 500) for ends in decades)
        yield [kappa, alpha * (trial % 3 != 1), sigma, beta * (trial % 2)]


def _scanned(vary: str, fixed: dict[str, float], values: np.ndarray) -> np.ndarray:
    """Cells of a grid between whose ends the number of equilibria changes."""
    return np.flatnonzero(np.diff(ss.equilibria(ss.Parameters(**fixed | {vary: values})).count))


@pytest.mark.parametrize("vary", NAMES)
def test_folds_are_enclosed_and_none_is_missed(vary: str, arith: Arithmetic) -> None:
    """Against the counts over a grid, whose cells hold an odd number of folds where the count changes, otherwise an even one."""
    rng = np.random.default_rng(NAMES.index(vary))
    grids = {"theta0": np.linspace(1e-3, math.pi - 1e-3, 1500), "mu0": np.linspace(1e-5, 3, 1500)}
    grid = grids.get(vary, np.geomspace(1e-4, 10, 1500))
    total = 0
    for values in _rationals(NAMES.index(vary), 5):
        angle_and_friction = [Fraction(int(rng.integers(40, 130)), 100), Fraction(int(rng.integers(2, 15)), 10)]
        exact = dict(zip(NAMES, [*angle_and_friction, *values], strict=True))
        with arith.precision(300):
            points = list(proofs.folds(arith, vary, exact, 300))
            for point in points:
                _check(arith, point, 2, 30)
                for name, value in zip(NAMES, point.parameters, strict=True):
                    if name != vary:
                        low, high = arith.ends(value)
                        assert abs(_middle(arith, value) - mpmath.mpf(exact[name].numerator) / exact[name].denominator) < 1e-60
            where = np.array([float(_middle(arith, point.parameters[NAMES.index(vary)])) for point in points])
        where = where[(where > grid[0]) & (where < grid[-1])]
        cells, number = np.unique(np.searchsorted(grid, where) - 1, return_counts=True)
        fixed = {name: float(value) for name, value in exact.items()}
        assert cells[number % 2 == 1].tolist() == _scanned(vary, fixed, grid).tolist()
        total += where.size
    assert total >= 2


@pytest.mark.parametrize("alpha", ["0.007", "0", "1"])
def test_cusps_are_enclosed_and_paired(alpha: str, arith: Arithmetic) -> None:
    """The mirror image (π − θ, π − θ₀, −μ₀) of a cusp is one; their number is that of the real roots of the polynomial."""
    exact = (Fraction(7, 1000), Fraction(alpha), Fraction(1, 10), Fraction(0))
    with arith.precision(300):
        points = list(proofs.cusps(arith, exact, 300))
        assert len(points) == {"0.007": 4, "0": 2, "1": len(points)}[alpha]
        assert len(points) > 0
        seen = []
        for point in points:
            _check(arith, point, 3, 30)
            angles = [arith.cos_sin(value) for value in (point.theta, point.parameters[0])]
            seen.append([float(_middle(arith, v)) for v in (*angles[0], *angles[1], point.parameters[1])])
        for c, s, c0, s0, mu0 in seen:
            gaps = [max(map(abs, np.subtract(other, (-c, s, -c0, s0, -mu0)))) for other in seen]
            assert sum(gap < 1e-14 for gap in gaps) == 1
        if alpha != "0":
            assert all(proofs.is_versal(arith, point) for point in points)


def test_sines_of_cusps_are_all_real_roots_inside() -> None:
    """One at sin θ = 1 does not count: with α = 0 and κ = 1 + β that is one."""
    for kappa, alpha, sigma, beta in [*_rationals(7, 8), [Fraction(3, 2), Fraction(0), Fraction(2), Fraction(1, 2)]]:
        polynomial, roots, count = proofs.cusp_sines(kappa, alpha, sigma, beta, bits=50)
        assert len(roots) == count
        found = np.roots([float(value) for value in polynomial[::-1]])
        real = np.sort(found[(abs(found.imag) < 1e-9) & (abs(found.real) < 1 - 1e-9)].real)
        assert count == real.size
        for (low, high), value in zip(roots, real, strict=True):
            assert high - low <= Fraction(1, 2**50)
            assert abs(float(low) - value) < 1e-5


def test_what_may_be_degenerate_is_not_versal(arith: Arithmetic) -> None:
    exact = (Fraction(7, 1000), Fraction(7, 1000), Fraction(1, 10), Fraction(0))
    with arith.precision(200):
        point = next(proofs.cusps(arith, exact, 200))
        assert proofs.is_versal(arith, point)
        theta0, mu0, *rest = point.parameters
        wide = arith.between(mpmath.mpf(-2), mpmath.mpf(2))
        blurred = proofs.Point((theta0, mu0, *rest), point.theta + wide, point.L, point.x, point.y)
        assert not proofs.is_versal(arith, blurred)
        assert not proofs.is_versal(arith, proofs.Point((theta0 + wide, mu0, *rest), point.theta, point.L, point.x, point.y))


# ----------------------------------------------------------------------------------------------------- precise


@pytest.mark.parametrize(
    ("given", "exact"),
    [
        (1, Fraction(1)), (0.5, Fraction(1, 2)), ("0.007", Fraction(7, 1000)), (" +7/1000 ", Fraction(7, 1000)), (".5e-1", Fraction(1, 20)),
        ("1.", Fraction(1)), (Fraction(2, 3), Fraction(2, 3)), (mpmath.mpf("0.75"), Fraction(3, 4)), (mpmath.mpf(6), Fraction(6)),
        ("7/1000", Fraction(7, 1000)), ("10/10", Fraction(1)),
    ],
)  # fmt: skip
def test_a_number_is_what_it_writes(given: Any, exact: Fraction) -> None:
    assert ss.precise.as_exact("kappa", given, ss.parameters.RANGES["kappa"]) == exact


@pytest.mark.parametrize(
    ("name", "given", "error"),
    [
        ("kappa", True, ss.ParameterTypeError), ("kappa", None, ss.ParameterTypeError), ("kappa", "seven", ss.ParameterTypeError),
        ("kappa", "1/0", ss.ParameterError), ("kappa", "1/00 ", ss.ParameterError), ("kappa", math.nan, ss.ParameterError),
        ("kappa", mpmath.inf, ss.ParameterError), ("kappa", 0, ss.ParameterError), ("kappa", mpmath.mpf(-1), ss.ParameterError),
        ("alpha", "-1/9", ss.ParameterError), ("theta0", math.pi, ss.ParameterError), ("theta0", 4, ss.ParameterError),
        ("theta0", 0, ss.ParameterError),
    ],
)  # fmt: skip
def test_what_is_no_number_in_range_is_named(name: str, given: Any, error: type[Exception]) -> None:
    with pytest.raises(error, match=f"^{name} = "):
        ss.precise.as_exact(name, given, ss.parameters.RANGES[name])


def test_the_ends_of_ranges_that_belong_to_them() -> None:
    for name in ("alpha", "beta", "mu0"):
        assert ss.precise.as_exact(name, 0, ss.parameters.RANGES[name]) == 0
    assert ss.precise.as_exact("kappa", "1e300", ss.parameters.RANGES["kappa"]) == 10**300
    with pytest.raises(ss.ParameterError, match="numpy.radians"):
        ss.precise.as_exact("theta0", 49, ss.parameters.RANGES["theta0"])


@pytest.mark.parametrize("dps", [0, -1, 1001, True, 2.0, "9"])
def test_digits_out_of_range(dps: Any) -> None:
    with pytest.raises((ss.ParameterError, ss.ParameterTypeError), match="dps = "):
        ss.precise.as_digits(dps)


def test_digits_in_range() -> None:
    assert [ss.precise.as_digits(dps) for dps in (1, 50, 1000)] == [1, 50, 1000]


@pytest.mark.parametrize("degrees", [0, "180", 180, 180.5, -1])
def test_degrees_end_where_radians_do(degrees: Any) -> None:
    with pytest.raises(ss.ParameterError, match=r"theta0_deg = .* is not in \(0, 180"):
        ss.precise.equilibria(theta0_deg=degrees)


def test_degrees_are_degrees() -> None:
    """Up to the last before 180, the same as the angle in radians to all digits."""
    for degrees in ("179.9999999", "0.0000001", "44.5", "179"):
        with mpmath.workdps(80):
            theta0 = mpmath.radians(mpmath.mpf(degrees))
        one, two = ss.precise.equilibria(theta0_deg=degrees, dps=40), ss.precise.equilibria(theta0, dps=40)
        assert len(one) == len(two)
        for first, second in zip(one, two, strict=True):
            assert abs(first.x - second.x) < 1e-38 * max(1, abs(first.x))
            assert abs(first.theta - second.theta) < 1e-38
    with pytest.raises(ss.ParameterError, match="one of theta0"):
        ss.precise.equilibria(1, theta0_deg=1)
    with pytest.raises(ss.ParameterError, match="one of theta0"):
        ss.precise.equilibria()


def test_the_defaults_are_the_articles() -> None:
    base = ("0.5", "0.007", "0.007", "0.1", 0)
    assert ss.precise.equilibria(1) == ss.precise.equilibria(1, *base, contact=True, dps=50)
    assert ss.precise.cusps() == ss.precise.cusps("0.007", "0.007", "0.1", 0, dps=40)


CUSPS = [("0.007", "0.007", "0.1", 0), ("0.3", 0, "1.7", "0.4"), ("0.2", "1.5", "0.9", "0.5")]


@pytest.mark.parametrize("dps", [3, 25])
def test_the_radius_of_a_cusp_holds_every_number(dps: int, arith: Arithmetic) -> None:
    for values in CUSPS:
        exact, rough = ss.precise.cusps(*values, dps=dps + 40), ss.precise.cusps(*values, dps=dps, arith=arith)
        assert len(exact) == len(rough)
        assert [cusp.mu0 for cusp in rough] == sorted(cusp.mu0 for cusp in rough)
        with mpmath.workdps(dps + 40):
            for one in rough:
                names = ("theta0", "mu0", "theta", "L", "x", "y")
                gaps = [max(abs(getattr(one, name) - getattr(two, name)) for name in names) for two in exact]
                size = max(1, *(abs(getattr(one, name)) for name in names))
                assert min(gaps) <= one.radius <= mpmath.mpf(10) ** -dps * size * 1.01
        assert rough.count == exact.count
        assert bool(rough.polynomial) == (values[1] != "1.5")
    assert rough[0] is rough.cusps[0]
