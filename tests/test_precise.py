"""Intervals, bounds of ``precise`` at any precision, global precisions left alone, threads, and points without an answer."""

from __future__ import annotations

import dataclasses
import itertools
import json
import os
import sys
import threading
import time
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.cli import cli as command_line
from spragsym.exact import adaptive_bits
from spragsym.exact.intervals import Balls
from spragsym.kang_nam import digits
from spragsym.kang_nam.catastrophe import cusp_proofs
from spragsym.kang_nam.statics import adaptive_precision, compiled
from spragsym.results.precise_states import PreciseCusp
from tests.oracles.families import cusp_wedge
from validation.precise import points, worst_shares

ARITH = Balls()


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


def _cusp_equations(one: PreciseCusp, given: dict[str, Any]) -> list[mpmath.mpf]:
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
    settled = adaptive_precision.equilibria(0.5, 0.5, "0.007", "0.007", "0.1", 0, digits=dps)
    assert settled.bits == max(adaptive_precision.FIRST_BITS, int(3.4 * dps) + 64)
    tries: list[int] = []
    exact = tuple(map(Fraction, ("0.007", "0.007", "0.1", "0")))

    def attempt(bits: int) -> list[PreciseCusp]:
        tries.append(bits)
        return [digits._cusp(ARITH, point, dps) for point in cusp_proofs.cusps(ARITH, exact, bits)]

    assert len(adaptive_bits.with_enough_bits(ARITH, dps, attempt, "cusps")) == 4
    assert tries == [max(adaptive_bits.FIRST_BITS, int(3.4 * dps) + 96)]


@pytest.mark.parametrize("degrees", ["0", 0.0, "-1", "180", 180, Fraction(180), "181", "360"])
def test_degrees_out_of_range(degrees: Any) -> None:
    with pytest.raises(ss.ParameterError, match=r"theta0_deg = .* is not in \(0, 180\)"):
        precise.equilibria(theta0_deg=degrees)


@pytest.mark.parametrize("degrees", ["1e-9", "90", "179.999999999", Fraction(180) - Fraction(1, 10**12)])
def test_degrees_in_range_are_those_in_radians(degrees: Any) -> None:
    with mpmath.workdps(60):
        radians = mpmath.pi * mpmath.mpf(Fraction(degrees).numerator) / Fraction(degrees).denominator / 180
    found = precise.equilibria(theta0_deg=degrees, dps=30)
    same = precise.equilibria(theta0=radians, dps=30)
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
    if isinstance(value, dict):
        return {name: _bits(part) for name, part in value.items()}
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


@pytest.mark.thorough
def test_threads_give_the_bits_of_one() -> None:
    _run_threads(3, 0.7)


@pytest.mark.thorough
def test_eight_threads() -> None:
    """``SPRAGSYM_SECONDS=300`` for five minutes of them."""
    _run_threads(8, float(os.environ.get("SPRAGSYM_SECONDS", "5")))


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
        monkeypatch.setattr(
            "spragsym.kang_nam.statics.solver._solve_widely", lambda given, contact, out, rows: np.arange(rows.size)
        )
    kappa = np.array([[0.1, 0.2], [0.05, 0.1]])
    ss.set_backend(backend)
    try:
        eq = ss.equilibria(ss.Parameters(**{**AT_ANCHOR, "kappa": kappa}), contact=False)
        others = ss.equilibria(ss.Parameters(**{**AT_ANCHOR, "kappa": np.array([0.2, 0.05])}), contact=False)
        with pytest.raises(ss.ConvergenceError, match="L or y holds 0"):
            ss.equilibria(ss.Parameters(**AT_ANCHOR), contact=False)
    finally:
        ss.set_backend("auto")
    assert eq.decided.tolist() == [[False, True], [True, False]]
    assert eq.count[~eq.decided].tolist() == [0, 0]
    assert np.isnan(eq.theta[~eq.decided]).all()
    assert np.isnan(eq.error[~eq.decided]).all()
    assert not eq.stability[~eq.decided].any()
    assert "L or y holds 0" in eq.reason(0, 0)
    assert "kappa=0.1," in eq.reason(1, 1) == eq.reason(-1, -1)
    assert eq.reason(0, 1) == ""
    assert [box.index for box in eq.undecided] == [(0, 0), (1, 1)]
    assert not eq.complete
    assert eq.remarks[0].startswith("2 of 4 points have no answer; the first: ")
    np.testing.assert_array_equal(eq.theta[eq.decided], others.theta)
    assert np.isnan(eq.eigenvalues[0, 0]).all()
    assert others.require_decided() is others
    with pytest.raises(ss.ConvergenceError, match="L or y holds 0"):
        eq.require_decided()


def test_what_float64_cannot_carry_is_marked_in_an_array() -> None:
    size = np.array([1.0, 1e200])
    eq = ss.equilibria(ss.Parameters(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0))
    assert eq.decided.tolist() == [True, False]
    assert eq.count.tolist() == [1, 0]
    assert "beyond float64" in eq.reason(1)
    assert np.isnan(eq.x[1]).all()
    assert ss.equilibria(ss.Parameters.article(theta0=[])).decided.shape == (0,)


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
    assert [one["state"] for one in found["undecided"]] == ["lift-off"]
    assert found["complete"] is False
