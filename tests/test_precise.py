"""Intervals, bounds of ``precise`` at any precision, global precisions left alone, threads, and points without an answer."""

from __future__ import annotations

import dataclasses
import itertools
import json
import math
import sys
import threading
import time
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from benchmarks.families import cusp_wedge
from benchmarks.validate_precise import points, worst_shares
from spragsym import precise
from spragsym.catastrophe import cusp_proofs
from spragsym.cli import cli as command_line
from spragsym.exact import escalation, intervals
from spragsym.exact.intervals import Ball, Balls
from spragsym.exact.polynomials import Undecided
from spragsym.statics import compiled, ladder

ARITH = Balls()


# --------------------------------------------------------------------------------------------------- intervals


def _small_balls(bits: int) -> Iterator[Ball]:
    """Every ball of a few bits, about: middles and radii where rounding down loses nothing, one unit, and nearly the next."""
    for mid, rad, exp in itertools.product((-9, -8, -7, -1, 0, 1, 3, 4, 7), (0, 1, 3), (-3, 0, 2)):
        yield Ball(mid, rad, exp, bits)


def _holds(ball: Ball, value: Fraction) -> bool:
    low, high = ARITH.ends(ball)
    return low <= value <= high


OPERATIONS: list[Callable[[Any, Any], Any]] = [
    lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b, lambda a, b: a / b,
]  # fmt: skip


@pytest.mark.parametrize("operation", OPERATIONS, ids="+-*/")
@pytest.mark.parametrize("bits", [2, 3, 60])
def test_operations_enclose_every_corner(operation: Callable[[Any, Any], Any], bits: int) -> None:
    """Of three bits nearly every result is rounded; the extremes of a monotonic operation lie at the ends."""
    for one, other in itertools.product(_small_balls(bits), repeat=2):
        try:
            result = operation(one, other)
        except Undecided:
            low, high = ARITH.ends(other)
            assert low <= 0 <= high
            continue
        for a, b in itertools.product(ARITH.ends(one), ARITH.ends(other)):
            assert _holds(result, operation(a, b)), (one, other, result)
        assert abs(result.mid) <= 1 << bits
        assert result.rad.bit_length() <= intervals.RADIUS_BITS + 1


@pytest.mark.parametrize("bits", [4, 20, 53])
def test_rounding_takes_the_worst_middle_and_radius(bits: int) -> None:
    """All ones beyond the last bit: the middle loses nearly a unit and the radius, which has its own, nearly another."""
    for lost in (1, 5, 40):
        mid, rad = (1 << bits + lost) - 1, (1 << lost) - 1
        for sign in (1, -1):
            for value in (mid - rad, mid + rad):
                assert _holds(Ball(sign * mid, rad, 0, bits), Fraction(sign * value))
    wide = (1 << intervals.RADIUS_BITS + 7) - 1
    for end in (5 - wide, 5 + wide):
        assert _holds(Ball(5, wide, 0, bits), Fraction(end))


def test_far_apart_terms_go_into_the_radius() -> None:
    for bits, gap, sign in itertools.product((8, 53), (20, 60, 200, 5000), (1, -1)):
        large, small = Ball(5, 0, gap, bits), Ball(sign * 3, 1, 0, bits)
        for result, turn in ((large + small, 1), (small - large, -1)):
            for end in ARITH.ends(small):
                assert _holds(result, turn * Fraction(5) * 2**gap + end)
            assert result.mid.bit_length() + result.rad.bit_length() < 200
    tiny = Ball(3, 0, -5000, 53)
    assert ARITH.ends(tiny + Ball(0, 0, 0, 53)) == ARITH.ends(Ball(0, 0, 9, 53) + tiny) == ARITH.ends(tiny)


@pytest.mark.parametrize("bits", [5, 53, 300])
def test_rationals_and_unions_are_enclosed(bits: int) -> None:
    values = [Fraction(n, d) for n in (-10**30, -7, -1, 0, 1, 2, 10**30 + 1) for d in (1, 3, 8, 10**9 + 7, 2**400)]
    with ARITH.precision(bits):
        for one, other in itertools.combinations(values, 2):
            assert _holds(ARITH.exact(one), one)
            both = ARITH.between(min(one, other), max(one, other))
            assert _holds(both, one)
            assert _holds(both, other)
        assert ARITH.ends(ARITH.exact(Fraction(3, 8))) == (Fraction(3, 8),) * 2


def test_numbers_of_other_types_are_exact() -> None:
    ball = Ball(3, 0, -2, 53)
    for result, value in [
        (1 - ball, 0.25), (ball - 1, -0.25), (2 * ball, 1.5), (ball * 0.5, 0.375), (3 / ball, 4), (ball / 3.0, 0.25),
        (ball**3, 0.421875), (ball**0, 1), (0.5 + ball, 1.25), (-ball, -0.75), (ball**-1 * 3, 4),
    ]:  # fmt: skip
        assert _holds(result, Fraction(value))
    for operation in OPERATIONS:
        for pair in ((ball, "1"), ("1", ball)):
            with pytest.raises(TypeError):
                operation(*pair)
    with pytest.raises(TypeError):
        ball**0.5
    assert repr(ball) == "Ball((3 ± 0) * 2**-2)"


FUNCTIONS: dict[str, Callable[[Ball], Ball]] = {
    "cos": lambda ball: ARITH.cos_sin(ball)[0],
    "sin": lambda ball: ARITH.cos_sin(ball)[1],
    "atan": ARITH.atan,
    "sqrt": ARITH.sqrt,
}


@pytest.mark.parametrize("bits", [3, 24, 53, 128, 700])
@pytest.mark.parametrize("name", ["cos", "sin", "atan", "sqrt"])
def test_functions_enclose_and_are_sharp(name: str, bits: int) -> None:
    """Against mpmath with far more digits; a wide ball at both ends, a point with hardly more than its last bits lost."""
    rng = np.random.default_rng(bits)
    context = mpmath.mp.clone()
    context.prec = 4000 + 2 * bits
    half_pi = Fraction(math.pi) / 2
    near_pi = Fraction(math.nextafter(math.pi, 0))
    values = [Fraction(1), Fraction(1, 3), half_pi, 2 * half_pi, near_pi, Fraction(5, 2), Fraction(1, 2**1000)]
    values += [Fraction(float(value)) for value in np.concatenate([rng.uniform(0, 4, 30), 10.0 ** rng.uniform(-40, 5, 20)])]
    for value, sign, width in itertools.product(values, (1, -1), (0, Fraction(1, 2**9), Fraction(1, 2**70))):
        if sign < 0 and name == "sqrt":
            continue
        with ARITH.precision(bits):
            ball = ARITH.between(sign * value * (1 - width), sign * value * (1 + width))
        found = FUNCTIONS[name](ball)
        low, high = (context.mpf(end.numerator) / end.denominator for end in ARITH.ends(found))
        for end in ARITH.ends(ball):
            exact = getattr(context, name)(context.mpf(end.numerator) / end.denominator)
            assert low <= exact <= high, (value, sign, width)
        if not ball.rad:
            assert high - low <= abs(exact) * context.mpf(2) ** (5 - bits), (value, sign)


def test_functions_at_zero_and_pi() -> None:
    for exp in (-4, 0, 3):
        cosine, sine = ARITH.cos_sin(Ball(0, 1, exp, 53))
        assert _holds(cosine, Fraction(1))
        assert _holds(sine, Fraction(0))
        assert ARITH.ends(cosine)[0] <= Fraction(math.cos(min(2.0**exp, math.pi)) + 1e-9)
    assert ARITH.ends(ARITH.atan(Ball(0, 1, 0, 53))) == (-1, 1)
    assert ARITH.ends(ARITH.sqrt(Ball(0, 0, 0, 53))) == (0, 0)
    for bits in (4, 53, 5000):
        with ARITH.precision(bits):
            low, high = (_exact_mpf(end, 6000) for end in ARITH.ends(ARITH.pi()))
        assert low < _pi(6000) < high
        assert high - low < mpmath.ldexp(1, 5 - bits)
    for bad in (Ball(3, 4, 0, 53), Ball(-4, 0, 0, 53)):
        with pytest.raises(Undecided, match="negative"):
            ARITH.sqrt(bad)
    assert _holds(ARITH.sqrt(Ball(4, 4, 0, 53)), Fraction(0))


def _pi(bits: int) -> mpmath.mpf:
    with mpmath.workprec(bits):
        return +mpmath.pi


def _exact_mpf(value: Fraction, bits: int) -> mpmath.mpf:
    with mpmath.workprec(bits):
        return mpmath.mpf(value.numerator) / value.denominator


@pytest.mark.parametrize("divisor", [Ball(0, 0, 0, 53), Ball(3, 3, 0, 53), Ball(-3, 3, 0, 53), Ball(-1, 7, 5, 53)])
def test_what_holds_0_has_no_sign_and_divides_nothing(divisor: Ball) -> None:
    """An end on 0 is no sign."""
    assert intervals.sign(ARITH, divisor) == 0
    with pytest.raises(Undecided, match="holds 0"):
        1 / divisor


def test_signs_next_to_0() -> None:
    assert [intervals.sign(ARITH, Ball(mid, 3, -9, 53)) for mid in (-4, -3, 3, 4)] == [-1, 0, 0, 1]
    assert intervals.sign(ARITH, Ball(1, 0, -9999, 53)) == 1


def test_numbers_for_mpmath_and_their_bounds() -> None:
    many = Fraction((1 << 700) + 1, 1 << 900)
    with mpmath.workdps(3):
        number = intervals.as_mpf(many)
    assert _fraction(number) == many
    with pytest.raises(ValueError, match="1/3"):
        intervals.as_mpf(Fraction(1, 3))
    for bound in (many, Fraction(1, 3), Fraction(10**400, 7), Fraction(0), Fraction(2**31 + 1, 2**31)):
        above = intervals.rounded_up(bound)
        assert bound <= above <= bound * (1 + Fraction(1, 2**28))
        assert above.numerator.bit_length() <= 32 or above.denominator == 1


def _fraction(value: mpmath.mpf) -> Fraction:
    negative, mantissa, exponent, _ = value._mpf_
    return (-1) ** negative * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


# ------------------------------------------------------------------------------------------------------ bounds


def test_bounds_hold_at_any_precision() -> None:
    """True errors, by Newton's method on the forces with a hundred digits more, whatever precision the caller has set."""
    for point in [(0.5, 0.5, 0.007, 0.007, 0.1, 0.0), *points(20, seed=3)]:
        shares = worst_shares(point, (1, 2, 15, 16, 17, 40, 50, 333))
        assert max(shares.values()) <= 1, (point, shares)
    shares = worst_shares((0.5, 0.5, 0.007, 0.007, 0.1, 0.0), (1, 1000))
    assert max(shares.values()) <= 1


@pytest.mark.parametrize("given", [{}, {"alpha": "0"}, {"alpha": "1"}, {"kappa": "1/3", "sigma": "2/7", "beta": "1.1"}])
def test_cusps_lie_within_their_radii(given: dict[str, Any]) -> None:
    truth = precise.cusps(**given, dps=120)
    with mpmath.workdps(400):
        for one in truth:
            assert max(map(abs, _cusp_equations(one, given))) < mpmath.mpf(10) ** -110
    for dps, caller in itertools.product((1, 15, 40, 77), (1, 15, 300)):
        with mpmath.workdps(caller):
            found = precise.cusps(**given, dps=dps)
        assert len(found) == len(truth)
        with mpmath.workdps(200):
            for one, exact in zip(found, truth, strict=True):
                names = ("theta0", "mu0", "theta", "L", "x", "y")
                assert all(abs(getattr(one, name) - getattr(exact, name)) <= one.radius + exact.radius for name in names)
                assert one.radius <= mpmath.mpf(10) ** -dps * max(1, *(abs(getattr(one, name)) for name in names))


def _cusp_equations(one: precise.PreciseCusp, given: dict[str, Any]) -> list[mpmath.mpf]:
    """The balance along x, with L from the balance across, and its first two derivatives in θ, by differences in 400 digits."""
    values = {"kappa": "0.007", "alpha": "0.007", "sigma": "0.1", "beta": "0", **given}
    rational = [Fraction(values[name]) for name in ("kappa", "alpha", "sigma", "beta")]
    kappa, alpha, sigma, beta = (mpmath.mpf(value.numerator) / value.denominator for value in rational)
    c0, s0 = mpmath.cos(one.theta0), mpmath.sin(one.theta0)

    def along(theta: mpmath.mpf) -> mpmath.mpf:
        c, s = mpmath.cos(theta), mpmath.sin(theta)
        L = (sigma * s + (beta + 1) * s0 + kappa) / ((beta + 1 + sigma) * s)
        return sigma * (1 - L) * c + alpha * (c0 - L * c) + one.mu0 * (s0 - L * s)

    return [along(one.theta), *(mpmath.diff(along, one.theta, n, h=mpmath.mpf(10) ** -125) for n in (1, 2))]


def test_error_bounds_of_folds_hold_whatever_the_callers_precision() -> None:
    """The same floats at 3 digits and at 300."""
    p = ss.Parameters.article(theta0=0.8)
    with mpmath.workdps(300):
        usual = [ss.folds(p, vary) for vary in ("theta0", "mu0", "beta")], ss.cusps(p)
    with mpmath.workdps(3):
        coarse = [ss.folds(p, vary) for vary in ("theta0", "mu0", "beta")], ss.cusps(p)
    for one, other in zip([*usual[0], usual[1]], [*coarse[0], coarse[1]], strict=True):
        for name in ("theta0", "mu0", "theta", "x", "error"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


@pytest.mark.parametrize("dps", [1, 15, 50, 300])
def test_the_first_try_has_enough_bits(dps: int) -> None:
    """Away from borders: 3.33 bits a digit, and what an enclosure loses."""
    settled = ladder.equilibria(0.5, 0.5, "0.007", "0.007", "0.1", 0, digits=dps)
    assert settled.bits == max(ladder.FIRST_BITS, int(3.4 * dps) + 64)
    tries: list[int] = []
    exact = tuple(map(Fraction, ("0.007", "0.007", "0.1", "0")))

    def attempt(bits: int) -> list[precise.PreciseCusp]:
        tries.append(bits)
        return [precise._cusp(ARITH, point, dps) for point in cusp_proofs.cusps(ARITH, exact, bits)]

    assert len(escalation.with_enough_bits(ARITH, dps, attempt, "cusps")) == 4
    assert tries == [max(escalation.FIRST_BITS, int(3.4 * dps) + 96)]


@pytest.mark.parametrize("degrees", ["0", 0.0, "-1", "180", 180, Fraction(180), "181", "360"])
def test_degrees_out_of_range(degrees: Any) -> None:
    with pytest.raises(ss.ParameterError, match=r"theta0_deg = .* is not in \(0, 180\)"):
        precise.equilibria(theta0_deg=degrees)


@pytest.mark.parametrize("degrees", ["1e-9", "90", "179.999999999", Fraction(180) - Fraction(1, 10**12)])
def test_degrees_in_range_are_those_in_radians(degrees: Any) -> None:
    with mpmath.workdps(60):
        radians = mpmath.pi * mpmath.mpf(Fraction(degrees).numerator) / Fraction(degrees).denominator / 180
    found = precise.equilibria(theta0_deg=degrees, dps=30)
    same = precise.equilibria(radians, dps=30)
    with mpmath.workdps(60):
        for one, other in zip(found, same, strict=True):
            assert max(abs(getattr(one, name) - getattr(other, name)) for name in ("theta", "L", "x", "y")) < 1e-40


def test_the_message_names_degrees() -> None:
    with pytest.raises(ss.ConvergenceError, match=r"theta0=90 degrees, .*L or y holds 0"):
        precise.equilibria(theta0_deg=90, kappa="0.1", alpha=0, sigma="0.1", beta=0, contact=False)


# ----------------------------------------------------------------------------------------------- global precisions


def _everything() -> dict[str, Any]:
    """A call of each kind that needs more digits than float64 has; every bit of its results."""
    p = ss.Parameters.article(theta0=0.8)
    wedge = cusp_wedge(np.random.default_rng(5), 12)
    found = {
        "escalated": [ss.equilibria(wedge)], "sums": [ss.equilibria(wedge, contact=False)], "cusps": [ss.cusps(p)],
        "folds": [ss.folds(p, "theta0"), ss.folds(p, "mu0")],
        **{f"precise {dps}": precise.equilibria(theta0_deg=30, dps=dps) for dps in (5, 50, 200)},
        "precise cusps": precise.cusps(dps=33).cusps,
    }  # fmt: skip
    return {name: repr([_bits(one) for one in many]) for name, many in found.items()}


def _bits(value: Any) -> Any:
    if isinstance(value, mpmath.mpf):
        return value._mpf_
    if isinstance(value, ss.Equilibria):
        return [_bits(getattr(value, name)) for name in ("count", "theta", "L", "x", "y", "error", "stability")]
    if dataclasses.is_dataclass(value):
        return [_bits(part) for part in vars(value).values()]
    return value.tobytes() if isinstance(value, np.ndarray) else str(value)


def test_no_precision_is_touched(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not even for a moment: setting one is an error here, and Arb can't be imported."""

    def refuse(*_: Any) -> None:
        raise AssertionError("a global precision is set")

    expected = _everything()
    monkeypatch.setitem(sys.modules, "flint", None)
    for context in (mpmath.mp, mpmath.iv, mpmath.fp):
        for name in ("prec", "dps"):
            owner = next(one for one in type(context).__mro__ if name in vars(one))
            getter = vars(owner)[name]
            monkeypatch.setattr(owner, name, property(getattr(getter, "fget", None) or (lambda _, value=getter: value), refuse))
    with pytest.raises(AssertionError, match="is set"):
        mpmath.mp.prec = 70
    assert _everything() == expected


def test_results_do_not_depend_on_the_callers_precisions() -> None:
    flint = pytest.importorskip("flint")
    expected = _everything()
    before = flint.ctx.prec, mpmath.iv.prec
    try:
        with mpmath.workdps(7):
            flint.ctx.prec = mpmath.iv.prec = 11
            assert _everything() == expected
            assert (flint.ctx.prec, mpmath.iv.prec, mpmath.mp.dps) == (11, 11, 7)
    finally:
        flint.ctx.prec, mpmath.iv.prec = before


def _run_threads(number: int, seconds: float) -> None:
    """Threads that compute everything again and again, while this one uses mpmath at its own precision."""
    expected = _everything()
    faults: list[str] = []
    until = time.monotonic() + seconds

    def work() -> None:
        while time.monotonic() < until and not faults:
            try:
                found = _everything()
                faults.extend(name for name in expected if found[name] != expected[name])
            except BaseException as error:  # whatever it is, the test must say so
                faults.append(repr(error))

    switch = sys.getswitchinterval()
    threads = [threading.Thread(target=work) for _ in range(number)]
    sys.setswitchinterval(1e-5)
    try:
        with mpmath.workdps(41):
            third = mpmath.mpf(1) / 3
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                if mpmath.mp.dps != 41 or mpmath.mpf(1) / 3 != third or mpmath.iv.prec != 53:
                    faults.append("a precision changed")
                time.sleep(0.001)
    finally:
        for thread in threads:
            thread.join()
        sys.setswitchinterval(switch)
    assert not faults, faults[:5]


def test_threads_give_the_bits_of_one() -> None:
    _run_threads(3, 2.0)


@pytest.mark.slow
def test_eight_threads_for_five_minutes() -> None:
    _run_threads(8, 300.0)


def test_precisions_nest_and_come_back_after_an_error() -> None:
    def fail() -> None:
        with ARITH.precision(33):
            assert ARITH.exact(Fraction(1, 3)).bits == 33
            raise RuntimeError

    with ARITH.precision(99):
        with pytest.raises(RuntimeError):
            fail()
        assert ARITH.pi().bits == 99
    assert ARITH.pi().bits == 53


# -------------------------------------------------------------------------------------- points without an answer


#: κ = σ and α = β = 0: in lift-off L = 0 at θ = −90° exactly, whatever θ₀ and μ₀.
AT_ANCHOR = {"theta0": 1.0, "mu0": 0.5, "kappa": 0.1, "alpha": 0.0, "sigma": 0.1, "beta": 0.0}


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
@pytest.mark.parametrize("wide", [True, False])
def test_one_hopeless_point_leaves_the_others(backend: str, wide: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    if backend == "compiled" and not compiled.available():
        pytest.skip("the compiled solver was not built: no C compiler")
    if not wide:
        monkeypatch.setattr("spragsym.statics.solver._extended_precision", lambda: False)
    kappa = np.array([[0.1, 0.2], [0.05, 0.1]])
    ss.set_backend(backend)
    try:
        eq = ss.equilibria(ss.Parameters(**{**AT_ANCHOR, "kappa": kappa}), contact=False)
        others = ss.equilibria(ss.Parameters(**{**AT_ANCHOR, "kappa": np.array([0.2, 0.05])}), contact=False)
        with pytest.raises(ss.ConvergenceError, match="L or y holds 0"):
            ss.equilibria(ss.Parameters(**AT_ANCHOR), contact=False)
    finally:
        ss.set_backend("auto")
    assert eq.undecided.tolist() == [[True, False], [False, True]]
    assert eq.count[eq.undecided].tolist() == [0, 0]
    assert np.isnan(eq.theta[eq.undecided]).all()
    assert np.isnan(eq.error[eq.undecided]).all()
    assert not eq.stability[eq.undecided].any()
    assert "L or y holds 0" in eq.reason(0, 0)
    assert "kappa=0.1," in eq.reason(1, 1) == eq.reason(-1, -1)
    assert eq.reason(0, 1) == ""
    assert set(eq.reasons) == {0, 3}
    np.testing.assert_array_equal(eq.theta[~eq.undecided], others.theta)
    assert np.isnan(eq.eigenvalues[0, 0]).all()
    assert others.decided() is others
    with pytest.raises(ss.ConvergenceError, match="L or y holds 0"):
        eq.decided()


def test_what_float64_cannot_carry_is_marked_in_an_array() -> None:
    size = np.array([1.0, 1e200])
    eq = ss.equilibria(ss.Parameters(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0))
    assert eq.undecided.tolist() == [False, True]
    assert eq.count.tolist() == [1, 0]
    assert "beyond float64" in eq.reason(1)
    assert np.isnan(eq.x[1]).all()
    assert ss.equilibria(ss.Parameters.article(theta0=[])).undecided.shape == (0,)


def test_the_command_prints_the_reason_and_the_rest(capsys: pytest.CaptureFixture[str]) -> None:
    args = ["equilibria", "--theta0", "50", "--kappa", "0.1", "--alpha", "0", "--sigma", "0.1", "--beta", "0"]
    command_line(args, standalone_mode=False)
    shown = capsys.readouterr().out
    assert "contact" in shown
    assert "lift-off, undecided: " in shown
    assert "L or y holds 0" in shown
    command_line([*args, "--json"], standalone_mode=False)
    found = json.loads(capsys.readouterr().out)
    assert {row["state"] for row in found["equilibria"]} == {"contact"}
    assert list(found["undecided"]) == ["lift-off"]
