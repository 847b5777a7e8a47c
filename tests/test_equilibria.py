"""The solver against an independent reference: counts, digits, error bounds, stability, bad input."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.exact import intervals
from spragsym.generated.equilibrium import f_coefficients
from spragsym.kang_nam.statics import adaptive_precision, compiled, kernel, solver
from spragsym.results.precise_states import PreciseEquilibrium
from tests.oracles import reference
from tests.oracles.families import FAMILIES, random
from tests.support import as_fraction
from validation.equilibria import worst_errors, wrong_counts

FOLD_DEG = 44.5593177025653  # left fold at base values, by three continuation codes (peers)


# ------------------------------------------------------------------------------------------- counts and digits


@pytest.mark.parametrize("name", FAMILIES)
def test_counts_digits_and_bounds(name: str) -> None:
    number = list(FAMILIES).index(name)
    rng = np.random.default_rng([7, number])
    p = FAMILIES[name](rng, 400)
    eq = ss.equilibria(p)
    assert wrong_counts(p, eq) == 0
    assert set(np.unique(eq.count)) <= {1, 3}
    for found in (eq, ss.equilibria(p, contact=False)):
        worst, ratio = worst_errors(p, found, rng, 40)
        assert worst <= 1e-12
        assert ratio <= 1
        assert np.nanmax(found.error, initial=0) <= 1e-12


def test_families_reach_what_they_are_named_for() -> None:
    rng = np.random.default_rng(3)
    folds, wedge = FAMILIES["near folds"](rng, 500), FAMILIES["cusp wedge"](rng, 500)
    assert ss.equilibria(folds).escalated.mean() > 0.2
    assert 0.2 < (ss.equilibria(wedge).count == 3).mean() < 0.9


def test_three_equilibria_need_a_positive_sum() -> None:
    """Three imply a + d > 0; the converse is not so."""
    for number, family in enumerate(("random", "near folds", "cusp wedge")):
        p = FAMILIES[family](np.random.default_rng([41, number]), 500)
        theta0, *values = p.broadcast("theta0", "mu0", "kappa", "alpha", "sigma", "beta")
        a, _, d, _ = f_coefficients(np.cos(theta0), np.sin(theta0), *values, 1)
        count = ss.equilibria(p).count
        assert (a + d > 0)[count == 3].all()
        assert (a + d > 0)[count == 1].any()


def test_roots_that_may_be_one_do_not_count_as_two() -> None:
    """Intervals around θ = 2 atan t that touch."""
    assert kernel.apart(0.5, 0.07, 0.6, 0.07)  # 2 · 0.1 over 1 + 0.36
    assert not kernel.apart(0.5, 0.08, 0.6, 0.07)
    assert not kernel.apart(0.6, 0.01, 0.5, 0.01)


def test_middle_of_three_is_divergent() -> None:
    eq = ss.equilibria(random(np.random.default_rng(4), 20_000))
    three = eq.count == 3
    assert three.sum() > 1000
    assert (eq.stability[three, 1] == ss.Stability.DIVERGENT).all()


def test_slots_ascend_and_are_empty_beyond_count() -> None:
    p = random(np.random.default_rng(5), 5000)
    for contact, slots in ((True, 3), (False, 4)):
        eq = ss.equilibria(p, contact=contact)
        used = np.arange(slots) < eq.count[:, None]
        for name in ("theta", "L", "x", "y", "error"):
            assert (np.isfinite(getattr(eq, name)) == used).all()
        assert ((eq.stability > 0) == used).all()
        steps = np.diff(eq.theta, axis=-1)
        assert (steps[used[:, 1:]] > 0).all()


def test_lift_off_count_is_that_of_direct_search() -> None:
    # Newton's method on the forces from many starts finds no state that the solver lacks.
    rng = np.random.default_rng(6)
    p = random(rng, 25)
    eq = ss.equilibria(p, contact=False)
    for row, point in enumerate(zip(*p.broadcast(*ss.parameters.NAMES), strict=True)):
        numbers = [float(value) for value in point]
        found: list[tuple[float, float]] = []
        anchor = complex(math.cos(numbers[0]), math.sin(numbers[0]))
        for start in range(24):
            direction = complex(math.cos(start * 0.26), math.sin(start * 0.26)) * (-1) ** (start // 12)
            guess = anchor - (0.4 + 0.9 * (start % 2)) * direction
            try:
                theta, L, x, y = reference.refine(guess.real, guess.imag, *numbers, contact=False, digits=30)
            except ZeroDivisionError:
                continue
            theta_residual = abs(L) < 100 and all(map(mpmath.isfinite, (theta, x, y)))
            if theta_residual and y >= 0 and _is_rest(x, y, numbers) and all(abs(x - u) + abs(y - v) > 1e-8 for u, v in found):
                found.append((float(x), float(y)))
        assert len(found) <= eq.count[row]
        for x, y in found:
            assert np.nanmin(np.hypot(eq.x[row] - x, eq.y[row] - y)) < 1e-9


def _is_rest(x: mpmath.mpf, y: mpmath.mpf, numbers: list[float]) -> bool:
    theta0, _, kappa, alpha, sigma, beta = numbers
    spring = mpmath.mpc(mpmath.cos(theta0), mpmath.sin(theta0)) - mpmath.mpc(x, y)
    pull = sigma * (abs(spring) - 1) * spring / abs(spring)
    return bool(abs(alpha * x - pull.real) + abs(beta * y - pull.imag + kappa) < 1e-10)


# --------------------------------------------------------------------------------------------------- stability


def test_eigenvalues_solve_27_and_agree_with_numpy() -> None:
    p = random(np.random.default_rng(8), 300)
    eq = ss.equilibria(p)
    _, mu0, _, alpha, sigma, beta = p.broadcast(*ss.parameters.NAMES)
    for row in range(300):
        for slot in range(eq.count[row]):
            s, c, L = math.sin(eq.theta[row, slot]), math.cos(eq.theta[row, slot]), eq.L[row, slot]
            K = np.array([
                [sigma[row] * (1 - s * s / L) + alpha[row], sigma[row] / L * s * c + mu0[row]],
                [sigma[row] / L * s * c, sigma[row] * (1 - c * c / L) + beta[row] + 1],
            ])  # fmt: skip
            squares = -np.linalg.eigvals(K).astype(complex)
            scale = np.abs(K).max()
            # Coefficients of the quadratic in λ², which a pair close together does not blur.
            found = np.poly(eq.eigenvalues[row, slot, :2] ** 2)
            assert np.abs(np.poly(squares) - found).max() < 1e-11 * max(1, scale) ** 2
            growing = eq.eigenvalues[row, slot].real.max() > 1e-7 * scale
            kind = ss.Stability(int(eq.stability[row, slot]))
            if kind is ss.Stability.STABLE:
                assert not growing
            else:
                assert growing
                oscillating = np.abs(eq.eigenvalues[row, slot].imag[eq.eigenvalues[row, slot].real > 1e-7 * scale]).min() > 0
                assert oscillating == (kind is ss.Stability.FLUTTER)


def test_flutter_at_a_large_stiffness_ratio() -> None:
    eq = ss.equilibria(ss.Parameters.article(theta0=math.radians(150), alpha=0.7))
    assert eq.count == 1
    assert eq.stability[0] == ss.Stability.FLUTTER


# ------------------------------------------------------------------------------------------------------ ladder


@pytest.mark.parametrize("name", ["own", "Arb"])
def test_both_interval_arithmetics_agree(name: str) -> None:
    arith: intervals.Arithmetic = intervals.Balls()
    if name == "Arb":
        pytest.importorskip("flint")
        from tests.oracles.arb import Arb

        arith = Arb()
    for degrees in ("30", "44.5593177025652", "44.5593177025654", "90", "155.05941878978"):
        states = ss.precise.equilibria(theta0_deg=degrees, dps=60, arith=arith)
        for state in states:
            assert _force(state, degrees) < mpmath.mpf(10) ** -57


def _force(state: PreciseEquilibrium, degrees: str) -> mpmath.mpf:
    with mpmath.workdps(80):
        theta0 = mpmath.radians(mpmath.mpf(degrees))
        kappa = alpha = mpmath.mpf(7) / 1000
        sigma, mu0 = mpmath.mpf(1) / 10, mpmath.mpf(1) / 2
        spring = mpmath.expj(theta0) - mpmath.mpc(state.x, state.y)
        pull = sigma * (abs(spring) - 1) * spring / abs(spring)
        along = alpha * state.x - pull.real + mu0 * state.y
        across = state.y - pull.imag + kappa
        return max(abs(along), abs(across), abs(mpmath.arg(spring) - state.theta), abs(abs(spring) - state.L))


def test_the_rungs_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    p = FAMILIES["near folds"](np.random.default_rng(9), 60)
    usual = ss.equilibria(p)
    monkeypatch.setattr(solver, "_solve_widely", lambda given, contact, out, rows: np.arange(rows.size))
    without_wide = ss.equilibria(p)
    assert (usual.count == without_wide.count).all()
    assert (usual.stability == without_wide.stability).all()
    gap = np.abs(usual.theta - without_wide.theta)
    assert (gap[np.isfinite(gap)] <= (usual.error + without_wide.error)[np.isfinite(gap)] * np.pi + 1e-15).all()
    assert without_wide.escalated.any()


def test_a_fold_to_the_last_digit_is_reported_not_guessed(monkeypatch: pytest.MonkeyPatch) -> None:
    # With few bits the discriminant next to a fold holds 0: two slots share the double root.
    monkeypatch.setattr(adaptive_precision, "FIRST_BITS", 128)
    monkeypatch.setattr(adaptive_precision, "MAXIMUM_BITS", 128)
    monkeypatch.setattr(adaptive_precision, "BITS_A_SPREAD", 0)
    fold = Fraction(math.radians(FOLD_DEG))
    exact = ss.precise.cusps(dps=60)[2]
    found = adaptive_precision.equilibria(as_fraction(exact.theta0), as_fraction(exact.mu0), "0.007", "0.007", "0.1", 0)
    assert found.fold
    assert len(found.states) == 3
    low, middle, high = (state.theta for state in found.states)
    assert abs(low - middle) < 1e-15 or abs(middle - high) < 1e-15
    assert not adaptive_precision.equilibria(fold, "0.5", "0.007", "0.007", "0.1", 0).fold


def test_precise_takes_numbers_exactly() -> None:
    kappa = Fraction(7, 1000)
    written = ss.precise.equilibria(theta0="0.8", kappa="0.007", dps=40)
    exact = ss.precise.equilibria(theta0=Fraction(4, 5), kappa=kappa, dps=40)
    rounded = ss.precise.equilibria(theta0="0.8", kappa=0.007, dps=40)
    assert written[0].x == exact[0].x
    assert written[0].x != rounded[0].x
    assert abs(written[0].x - rounded[0].x) < 1e-14


# ------------------------------------------------------------------------------------------------------- shapes


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
@pytest.mark.parametrize("size", [1e160, 1e200])
def test_what_float64_cannot_carry_is_said(backend: str, size: float) -> None:
    """A length of 1e399 is no inf with twelve digits."""
    if backend == "compiled" and not compiled.available():
        pytest.skip("the compiled solver was not built: no C compiler")
    ss.set_backend(backend)
    p = ss.Parameters(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0)
    try:
        with pytest.raises(ss.ConvergenceError, match=r"log10 L = .* of theta0=1\.0, mu0=.* is beyond float64"):
            ss.equilibria(p)
    finally:
        ss.set_backend("auto")
    [state] = ss.precise.equilibria(theta0=1.0, mu0=size, kappa=size, alpha=1.0, sigma=1.0, beta=1.0)
    assert mpmath.isfinite(state.L)


def test_shapes_broadcast() -> None:
    p = ss.Parameters.article(theta0=np.radians([[30.0], [49.0]]), mu0=np.array([0.1, 0.5, 0.7]))
    eq = ss.equilibria(p)
    assert eq.count.shape == (2, 3)
    assert eq.theta.shape == (2, 3, 3)
    assert eq.eigenvalues.shape == (2, 3, 3, 4)
    one = ss.equilibria(ss.Parameters.article(theta0=math.radians(49), mu0=0.7))
    assert one.count.shape == ()
    assert one.theta.shape == (3,)
    np.testing.assert_array_equal(eq.theta[1, 2], one.theta)
    assert ss.equilibria(ss.Parameters.article(theta0=np.empty((0, 4)))).theta.shape == (0, 4, 3)


def test_blocks_do_not_show() -> None:
    p = random(np.random.default_rng(10), 3 * solver.BLOCK + 5)
    whole = ss.equilibria(p)
    rows = np.r_[0, solver.BLOCK - 1, solver.BLOCK, 3 * solver.BLOCK + 4]
    part = ss.equilibria(ss.Parameters(*(value[rows] for value in p.broadcast(*ss.parameters.NAMES))))
    np.testing.assert_array_equal(whole.theta[rows], part.theta)


@pytest.mark.parametrize("dtype", [np.float32, np.int64, np.float64])
def test_number_types_are_taken_as_float64(dtype: type) -> None:
    eq = ss.equilibria(ss.Parameters(np.array([1, 2], dtype=dtype), 1, 1, 1, 1, 1))
    np.testing.assert_array_equal(eq.theta, ss.equilibria(ss.Parameters([1.0, 2.0], 1.0, 1.0, 1.0, 1.0, 1.0)).theta)


# ---------------------------------------------------------------------------------------------------- bad input


@pytest.mark.parametrize(
    ("changes", "error", "words"),
    [
        ({"theta0": math.nan}, ss.ParameterError, ["theta0 = nan", "(0, pi)"]),
        ({"theta0": 0.0}, ss.ParameterError, ["theta0 = 0", "radians"]),
        ({"theta0": 49.0}, ss.ParameterError, ["theta0 = 49", "numpy.radians"]),
        ({"theta0": [1.0, -1.0]}, ss.ParameterError, ["theta0[1] = -1"]),
        ({"theta0": 1.0, "sigma": 0.0}, ss.ParameterError, ["sigma = 0", "(0, inf)"]),
        ({"theta0": 1.0, "kappa": -1e-9}, ss.ParameterError, ["kappa = -", "preload"]),
        ({"theta0": 1.0, "alpha": -0.1}, ss.ParameterError, ["alpha", "[0, inf)"]),
        ({"theta0": 1.0, "beta": math.inf}, ss.ParameterError, ["beta = inf"]),
        ({"theta0": 1.0, "mu0": -0.5}, ss.ParameterError, ["mu0", "mirror"]),
        ({"theta0": "1"}, ss.ParameterTypeError, ["theta0", "text"]),
        ({"theta0": True}, ss.ParameterTypeError, ["booleans"]),
        ({"theta0": 1 + 0j}, ss.ParameterTypeError, ["complex"]),
        ({"theta0": [[1.0], [1.0, 2.0]]}, ss.ParameterTypeError, ["theta0", "regular array"]),
        ({"theta0": np.ma.array([1.0, 2.0], mask=[0, 1])}, ss.ParameterTypeError, ["1 masked", "compressed"]),
        ({"theta0": [1.0, 1.0], "mu0": [1.0, 1.0, 1.0]}, ss.ParameterError, ["theta0 (2,)", "mu0 (3,)"]),
        ({"theta0": 1.0, "gamma": 1.0}, ss.ParameterTypeError, ["gamma", "did you mean sigma"]),
        ({"theta0": 1.0, "kappa": None}, ss.ParameterError, ["kappa is missing"]),
    ],
)
def test_bad_input_is_named(changes: dict[str, object], error: type[Exception], words: list[str]) -> None:
    with pytest.raises(error) as caught:
        ss.equilibria(ss.Parameters.article(**changes))
    assert isinstance(caught.value, ss.SpragsymError)
    for word in words:
        assert word in str(caught.value)


def test_missing_angle_is_named() -> None:
    with pytest.raises(ss.ParameterError, match="theta0 is missing"):
        ss.equilibria(ss.Parameters.article())


@pytest.mark.parametrize(
    "call",
    [
        lambda: ss.precise.equilibria(theta0="one"),
        lambda: ss.precise.equilibria(theta0="1/0"),
        lambda: ss.precise.equilibria(theta0=True),
        lambda: ss.precise.equilibria(theta0="4"),
        lambda: ss.precise.equilibria(theta0="1", dps=0),
        lambda: ss.precise.equilibria(theta0="1", dps="50"),
        lambda: ss.precise.equilibria(),
        lambda: ss.precise.equilibria(theta0="1", sigma="-1"),
        lambda: ss.precise.equilibria(theta0=float("nan")),
    ],
)
def test_bad_input_to_precise(call: object) -> None:
    with pytest.raises((ss.ParameterError, ss.ParameterTypeError)):
        call()  # type: ignore[operator]  # one of several callables


def test_limits_that_make_sense() -> None:
    eq = ss.equilibria(ss.Parameters(1.0, 0.0, 1e-300, 0.0, 1e-3, 0.0))
    assert eq.count in (1, 3)
    huge = ss.equilibria(ss.Parameters(1.0, 1e150, 1.0, 1e150, 1e150, 1e150))
    assert huge.count in (1, 3)
    assert np.isfinite(huge.theta[: int(huge.count)]).all()


# -------------------------------------------------------------------------------------------------- dimensions


def test_physical_parameters_come_back_to_newtons_and_metres() -> None:
    brake = ss.PhysicalParameters(m=0.4, k=1e5, k_x=9e3, k_y=2e4, k_c=1e6, F_L=350, L_0=0.05, theta0=1.0, mu0=0.5, V=20, d=0.1)
    eq = ss.equilibria(brake.dimensionless())
    x, y = eq.x[0] * brake.scales.length, eq.y[0] * brake.scales.length
    # Newton's law with dimensions, (1) and (2), written out.
    dx, dy = 0.05 * math.cos(1.0) - x, 0.05 * math.sin(1.0) - y
    L = math.hypot(dx, dy)
    N = -1e6 * y
    assert abs(0.5 * N - 1e5 * (0.05 - L) * dx / L - 9e3 * x) < 1e-9 * 350
    assert abs(N - 350 - 1e5 * (0.05 - L) * dy / L - 2e4 * y) < 1e-9 * 350
    other = ss.PhysicalParameters(m=0.4e3, k=1e2, k_x=9, k_y=20, k_c=1e3, F_L=350, L_0=50, theta0=1.0, mu0=0.5)  # N/mm, mm
    np.testing.assert_allclose(ss.equilibria(other.dimensionless()).x, eq.x, rtol=1e-13)
    belt = brake.belt()
    assert math.isclose(belt["V"] * brake.scales.length / brake.scales.time, 20, rel_tol=1e-14)
    assert math.isclose(belt["V"] * belt["d"], 20 * 0.1, rel_tol=1e-14)
    with pytest.raises(ss.ParameterError, match="V is missing"):
        other.belt()
    with pytest.raises(ss.ParameterError, match="k_c"):
        ss.PhysicalParameters(m=1, k=1, k_x=1, k_y=1, k_c=0, F_L=1, L_0=1, theta0=1, mu0=0.5)
