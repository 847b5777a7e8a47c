"""Folds, cusps, flutter onsets and paths against counts, residuals, other codes and the article."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import spragsym as ss
from benchmarks.validate_folds import count_map_mismatches, random_fixed
from spragsym import fold_curves, intervals, polynomials
from spragsym.parameters import NAMES

BASE = ss.Parameters.article()
#: Left fold and cusp as AUTO-07p prints them, right fold by Newton's method at 40 digits (stated by peers, degrees).
AUTO_FOLD, AUTO_CUSP, NEWTON_RIGHT_FOLD = "44.559317703", "68.020958508", "155.059418789789"


def _counts(p: ss.Parameters) -> np.ndarray:
    return ss.equilibria(p).count


# ----------------------------------------------------------------------------------------------- residuals


def _f(theta: mpmath.mpf, theta0: mpmath.mpf, values: list[mpmath.mpf]) -> mpmath.mpf:
    """q sin θ F_x along F_y = 0, from the balance of forces: written out, not generated."""
    mu0, kappa, alpha, sigma, beta = values
    s, c, s0, c0 = mpmath.sin(theta), mpmath.cos(theta), mpmath.sin(theta0), mpmath.cos(theta0)
    L = (sigma * s + (beta + 1) * s0 + kappa) / ((beta + 1 + sigma) * s)
    return s * (sigma * (1 - L) * c + alpha * (c0 - L * c) + mu0 * (s0 - L * s))


def test_cusps_satisfy_f_and_its_derivatives_to_30_digits() -> None:
    found = ss.precise.cusps(kappa="0.007", alpha="0.007", sigma="0.1", beta="0", dps=60)
    assert len(found) == 4
    with mpmath.workdps(90):
        for cusp in found:
            values = [cusp.mu0, mpmath.mpf(7) / 1000, mpmath.mpf(7) / 1000, mpmath.mpf(1) / 10, mpmath.mpf(0)]
            for order in range(3):
                slope = mpmath.diff(lambda t, v=values, a=cusp.theta0: _f(t, a, v), cusp.theta, order)
                assert abs(slope) < mpmath.mpf(10) ** -30
            third = mpmath.diff(lambda t, v=values, a=cusp.theta0: _f(t, a, v), cusp.theta, 3)
            assert abs(third) > 1e-4
            assert cusp.radius < mpmath.mpf(10) ** -60
            assert cusp.versal


@pytest.mark.parametrize("vary", NAMES)
def test_folds_satisfy_f_and_its_slope(vary: str) -> None:
    p = ss.Parameters.article(theta0=0.8)
    found = ss.folds(p, vary=vary)
    assert found.theta0.size
    with mpmath.workdps(60):
        for i in range(found.theta0.size):
            values = [mpmath.mpf(float(getattr(found, name)[i])) for name in NAMES[1:]]
            theta, theta0 = mpmath.mpf(float(found.theta[i])), mpmath.mpf(float(found.theta0[i]))
            assert abs(_f(theta, theta0, values)) < 1e-15
            assert abs(mpmath.diff(lambda t, v=values, a=theta0: _f(t, a, v), theta)) < 1e-14
            assert found.error[i] < 1e-12


@pytest.mark.parametrize("vary", NAMES)
def test_folds_are_where_counts_change_and_only_there(vary: str) -> None:
    rng = np.random.default_rng(NAMES.index(vary))
    grids = {"theta0": np.linspace(1e-3, math.pi - 1e-3, 4001), "mu0": np.linspace(0, 3, 4001)}
    values = grids.get(vary, np.geomspace(1e-4, 10, 4001))
    for _ in range(6):
        p = random_fixed(rng).replace(theta0=rng.uniform(0.1, 3.0), mu0=rng.uniform(0, 1.5))
        found = getattr(ss.folds(p, vary=vary), vary)
        found = found[(found > values[0]) & (found < values[-1])]
        changes = np.flatnonzero(np.diff(_counts(p.replace(**{vary: values}))))
        cells = np.searchsorted(values, found) - 1
        odd, number = np.unique(cells, return_counts=True)
        assert odd[number % 2 == 1].tolist() == changes.tolist()


# ---------------------------------------------------------------------------------------------- other codes


def test_agreement_with_continuation_codes() -> None:
    left, right = np.degrees(ss.folds(BASE).theta0)
    assert f"{left:.9f}" == AUTO_FOLD
    assert f"{right:.12f}" == NEWTON_RIGHT_FOLD
    cusp = ss.cusps(BASE)
    assert f"{np.degrees(cusp.theta0[2]):.9f}" == AUTO_CUSP
    assert abs(cusp.mu0[2] - 0.200931781805090) < 5e-16


# ------------------------------------------------------------------------------------------- completeness


def test_cusp_count_is_sturms_and_numpys() -> None:
    rng = np.random.default_rng(11)
    for _ in range(20):
        p = random_fixed(rng)
        values = [float(value) for value in p.scalars("kappa", "alpha", "sigma", "beta")]
        proof = ss.precise.cusps(*values, dps=20)
        roots = np.roots([float(value) for value in proof.polynomial[::-1]])
        real = roots[(abs(roots.imag) < 1e-7) & (abs(roots.real) < 1)].real
        assert proof.count == len(proof.sines) == real.size
        np.testing.assert_allclose(sorted(float(low) for low, _ in proof.sines), sorted(real), atol=1e-6)


def test_bifurcation_set_agrees_with_the_count_map() -> None:
    rng = np.random.default_rng(12)
    for trial in range(5):
        assert count_map_mismatches(random_fixed(rng) if trial else BASE, 200) == 0


def test_bifurcation_set_ends_where_it_must_and_is_smooth() -> None:
    for p in (BASE, ss.Parameters.article(sigma=1.0), ss.Parameters.article(alpha=0.0), ss.Parameters.article(alpha=1.0)):
        found = ss.bifurcation_set(p, n=2000)
        assert len(found)
        for curve in found.curves:
            for end in (0, -1):
                at_edge = min(curve.theta0[end], math.pi - curve.theta0[end]) < 1e-6 or curve.mu0[end] < 1e-6
                assert at_edge or curve.theta0[0] == pytest.approx(curve.theta0[-1])
            shown = curve.mu0 < 2
            steps = np.hypot(np.diff(curve.theta0[shown]) / math.pi, np.diff(curve.mu0[shown]))
            assert steps.size == 0 or steps.max() < 0.02
        cusps = found.cusps
        for i in range(len(cusps)):  # each cusp lies on a curve
            gaps = [np.hypot(curve.theta0 - cusps.theta0[i], curve.mu0 - cusps.mu0[i]).min() for curve in found.curves]
            assert min(gaps) < 1e-2


def test_bifurcation_points_are_folds() -> None:
    for p in (BASE, ss.Parameters.article(alpha=0.0), random_fixed(np.random.default_rng(13))):
        values = list(map(float, p.scalars("kappa", "alpha", "sigma", "beta")))
        for curve in ss.bifurcation_set(p, n=1000).curves:
            for i in range(1, curve.theta.size - 1, 97):
                numbers = [mpmath.mpf(float(v)) for v in (curve.mu0[i], *values)]
                theta, theta0 = mpmath.mpf(float(curve.theta[i])), mpmath.mpf(float(curve.theta0[i]))
                size = 1 + abs(curve.mu0[i])
                assert abs(_f(theta, theta0, numbers)) < 1e-11 * size
                assert abs(mpmath.diff(lambda t, v=numbers, a=theta0: _f(t, a, v), theta)) < 1e-9 * size


def test_false_double_roots_of_the_published_quartic_are_no_folds() -> None:
    from spragsym.generated.equilibrium import contact_quartic

    # The L-quartic's discriminant vanishes between 30 and 40 degrees in the article's Figure 4; no equilibria meet there.
    angles = np.radians(np.linspace(30, 40, 2001))
    quartic = np.stack(contact_quartic(np.cos(angles), np.sin(angles), 0.5, 0.007, 0.007, 0.1, 0.0), axis=-1)
    gaps = [np.abs(np.subtract.outer(r, r))[np.triu_indices(4, 1)].min() for r in (np.roots(row[::-1]) for row in quartic)]
    assert min(gaps) < 1e-2
    found = np.degrees(ss.folds(BASE).theta0)
    assert not ((found > 30) & (found < 40)).any()


def test_isolas_are_closed_and_births_and_deaths_joined(monkeypatch: pytest.MonkeyPatch) -> None:
    # Roots of a made-up family: a circle about (1, 2), and a line that passes v = 0 on its way.
    def roots(theta: np.ndarray, fixed: object) -> tuple[np.ndarray, np.ndarray]:
        half = np.sqrt(0.25 - (theta - 1) ** 2)
        values = np.stack([2 - half, 2 + half, np.where(theta > 0.7, 0.5 * (theta - 0.7), np.nan)], axis=-1)
        values = np.sort(values, axis=-1)
        return values, np.count_nonzero(values > 0, axis=-1)

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, fixed: (theta - 0.7, 1.0 + 0 * theta, np.inf))
    with np.errstate(all="ignore"):
        strands = fold_curves._trace(np.linspace(0.1, 1.3, 40), (1.0, 1.0, 1.0, 1.0))
        whole = fold_curves._trace(np.linspace(0.1, 1.3, 40)[:20], (1.0, 1.0, 1.0, 1.0))
        closed = fold_curves._trace(np.linspace(0.1, 1.9, 50), (1.0, 1.0, 1.0, 1.0))
    assert [strand.theta.size > 5 for strand in strands] == [True, True]
    assert len(whole) == 1  # before the line enters, the circle's two open ends are one curve
    loops = [s for s in closed if s.theta[0] == s.theta[-1] and s.theta0[0] == s.theta0[-1]]
    assert len(loops) == 1
    v = np.tan(loops[0].theta0 / 2)
    on_circle = np.abs((loops[0].theta - 1) ** 2 + (v - 2) ** 2 - 0.25)
    assert on_circle.max() < 1e-6


# ----------------------------------------------------------------------------------------------- real roots


def test_sturm_against_known_roots() -> None:
    roots = [Fraction(-3, 4), Fraction(1, 7), Fraction(1, 7) + Fraction(1, 10**12), Fraction(5, 6)]
    polynomial: tuple[Fraction, ...] = (Fraction(1),)
    for root in roots:
        polynomial = tuple(
            (polynomial[i - 1] if i else 0) - root * (polynomial[i] if i < len(polynomial) else 0)
            for i in range(len(polynomial) + 1)
        )
    polynomial = tuple(
        (polynomial[i] if i < len(polynomial) else 0) + (polynomial[i - 2] if i >= 2 else 0) for i in range(len(polynomial) + 2)
    )  # times t² + 1
    found = polynomials.real_roots(polynomial, Fraction(-1), Fraction(1), polynomials.exact_sign, Fraction, 100)
    assert len(found) == 4
    for (low, high), root in zip(found, roots, strict=True):
        assert low <= root <= high
        assert high - low < Fraction(1, 2**99)
    squared = polynomials.squarefree(_times(polynomial, polynomial))
    assert len(polynomials.real_roots(squared, Fraction(-1), Fraction(1), polynomials.exact_sign, Fraction, 60)) == 4


def _times(one: tuple[Fraction, ...], other: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    product = [Fraction(0)] * (len(one) + len(other) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            product[i + j] += a * b
    return tuple(product)


@pytest.mark.parametrize("name", ["mpmath", "python-flint"])
def test_both_interval_arithmetics_give_the_same_folds(name: str) -> None:
    if name == "python-flint":
        pytest.importorskip("flint")
    arith = intervals.arithmetic(name)
    for vary in ("theta0", "beta"):
        np.testing.assert_array_equal(
            getattr(ss.folds(ss.Parameters.article(theta0=0.8), vary, arith=arith), vary),
            getattr(ss.folds(ss.Parameters.article(theta0=0.8), vary), vary),
        )


# -------------------------------------------------------------------------------------------------- criteria


def test_the_articles_yes_and_no_follow_from_the_cusp() -> None:
    for vary, samples in {"beta": {0.0: True, 1.0: True, 2.0: False}, "alpha": {0.007: True, 0.07: False, 0.7: False},
                          "sigma": {0.01: False, 0.1: True, 1.0: True}}.items():  # fmt: skip
        for value, jumps in samples.items():
            p = ss.Parameters.article(**{vary: value})
            assert (ss.critical_friction(p) < 0.5) == jumps
            path = ss.quasi_static_path(p, "theta0", np.radians(np.arange(1.0, 90.5, 1.0)))
            assert bool(path.jumps) == jumps


@pytest.mark.parametrize(("vary", "bracket"), [("beta", (1, 2)), ("alpha", (0.007, 0.07)), ("sigma", (0.01, 0.1))])
def test_critical_values_put_the_cusp_at_the_friction(vary: str, bracket: tuple[float, float]) -> None:
    value = ss.critical_value(BASE, vary, bracket)
    given = {"kappa": "0.007", "alpha": "0.007", "sigma": "0.1", "beta": "0", vary: value}
    lowest = min(one.mu0 for one in ss.precise.cusps(**given, dps=30) if one.mu0 > 0 and 0 < one.theta0 < mpmath.pi)
    assert abs(lowest - mpmath.mpf("0.5")) < 1e-12
    for side, sign in ((1 - 1e-9, -1), (1 + 1e-9, 1)):
        friction = ss.critical_friction(BASE.replace(**{vary: value * side}))
        assert math.copysign(1, (friction - 0.5) * sign) == (-1 if vary == "sigma" else 1)


def test_below_the_critical_friction_the_small_state_does_not_jump() -> None:
    rng = np.random.default_rng(15)
    tried = 0
    while tried < 12:
        p = random_fixed(rng)
        friction = float(ss.critical_friction(p))
        if not 0 < friction < 5:
            continue
        tried += 1
        angles = np.linspace(1e-4, math.pi - 1e-4, 60)
        below = ss.quasi_static_path(p.replace(mu0=0.97 * friction), "theta0", angles)
        above = ss.quasi_static_path(p.replace(mu0=1.03 * friction), "theta0", angles)
        assert len(above.jumps) > len(below.jumps)


def test_no_cusp_is_an_empty_result() -> None:
    p = ss.Parameters(kappa=0.5499, alpha=0.8771, sigma=0.022509, beta=4.455)
    assert math.isinf(ss.critical_friction(p))
    assert len(ss.bifurcation_set(p)) == 0
    assert ss.folds(p.replace(mu0=0.5)).theta0.size == 0


# ----------------------------------------------------------------------------------------- surface and flutter


def test_surface_puts_equilibria_back() -> None:
    theta, theta0 = np.radians(np.linspace(2, 178, 60))[:, None], np.radians(np.linspace(2, 178, 50))[None, :]
    s = ss.surface(BASE, theta, theta0)
    good = np.isfinite(s.mu0) & (s.mu0 >= 0) & (s.mu0 < 50)
    assert good.sum() > 300
    eq = ss.equilibria(BASE.replace(theta0=s.theta0[good], mu0=s.mu0[good]))
    gaps = np.abs(eq.theta - s.theta[good][:, None])
    slot = np.nanargmin(gaps, axis=-1)
    rows = np.arange(slot.size)
    assert gaps[rows, slot].max() < 1e-6
    clear = np.abs(np.nan_to_num(np.diff(eq.theta, axis=-1), nan=1.0)).min(axis=-1) > 1e-3
    assert (eq.stability[rows, slot][clear] == s.stability[good][clear]).mean() > 0.999
    np.testing.assert_allclose(eq.x[rows, slot][clear], s.x[good][clear], atol=1e-6)


def test_flutter_boundary_is_where_the_code_changes() -> None:
    for changes in ({"alpha": 0.7}, {"sigma": 1.0}, {"alpha": 0.0, "beta": 0.3}):
        p = ss.Parameters.article(**changes)
        found = ss.flutter_boundary(p, n=300)
        assert found.theta0.size
        low = found.mu0 < 3
        for i in np.flatnonzero(low)[::23]:
            K = _stiffness(p, found, i)
            discriminant = (K[0, 0] - K[1, 1]) ** 2 + 4 * K[0, 1] * K[1, 0]
            assert abs(discriminant) < 1e-9 * np.abs(K).max() ** 2
            eq = ss.equilibria(p.replace(theta0=found.theta0[i], mu0=found.mu0[i]))
            assert eq.count == found.count[i]
            assert abs(eq.theta[found.branch[i]] - found.theta[i]) < 1e-5


def _stiffness(p: ss.Parameters, found: ss.FlutterBoundary, i: int) -> np.ndarray:
    alpha, sigma, beta = p.scalars("alpha", "sigma", "beta")
    s, c, L = math.sin(found.theta[i]), math.cos(found.theta[i]), found.L[i]
    return np.array([
        [sigma * (1 - s * s / L) + alpha, sigma / L * s * c + found.mu0[i]],
        [sigma / L * s * c, sigma * (1 - c * c / L) + beta + 1],
    ])  # fmt: skip


def test_flutter_onsets_bound_the_fluttering_angles() -> None:
    p = ss.Parameters.article(alpha=0.7)
    onsets = ss.flutter_onsets(p)
    angles = np.radians(np.linspace(100, 179, 4000))
    flutters = (ss.equilibria(p.replace(theta0=angles)).stability == ss.Stability.FLUTTER).any(axis=-1)
    inside = (angles > onsets.theta0[0]) & (angles < onsets.theta0[1])
    assert onsets.theta0.size == 2
    assert (flutters == inside).all()


# ------------------------------------------------------------------------------------------------------ paths


def test_two_jumps_with_hysteresis_at_60_degrees_and_one_without_return_at_40() -> None:
    friction = np.linspace(0, 1, 301)
    at60, at40 = (ss.Parameters.article(theta0=math.radians(angle)) for angle in (60, 40))
    up, down = (ss.quasi_static_path(at60, "mu0", values) for values in (friction, friction[::-1]))
    assert len(up.jumps) == len(down.jumps) == 1
    assert up.jumps[0].value > down.jumps[0].value
    assert len(ss.quasi_static_path(at40, "mu0", friction).jumps) == 1
    assert len(ss.quasi_static_path(at40, "mu0", friction[::-1]).jumps) == 0


def test_paths_are_continuous_between_jumps() -> None:
    rng = np.random.default_rng(16)
    for _ in range(10):
        p = random_fixed(rng).replace(mu0=rng.uniform(0.2, 2))
        angles = np.linspace(0.01, math.pi - 0.01, 3001)
        for values in (angles, angles[::-1]):
            path = ss.quasi_static_path(p, "theta0", values)
            big = np.flatnonzero(np.abs(np.diff(path.theta)) > 0.15)
            places = sorted(float(jump.value) for jump in path.jumps)
            for step in big:
                assert any(min(values[step : step + 2]) <= place <= max(values[step : step + 2]) for place in places)
            for jump in path.jumps:
                below, above = _counts(p.replace(theta0=np.array([jump.value - 1e-7, jump.value + 1e-7])))
                assert {int(below), int(above)} == {1, 3}


def test_a_choice_after_the_jump_is_taken() -> None:
    seen: list[float] = []

    def choose(eq: ss.Equilibria, x_before: float) -> int:
        seen.append(x_before)
        return int(eq.count) - 1

    path = ss.quasi_static_path(BASE, "theta0", np.radians([20.0, 60.0]), after_jump=choose)
    assert len(path.jumps) == len(seen) == 1


# ------------------------------------------------------------------------------------------------ linear model


def test_linear_model_is_a_linear_solve_and_its_poles_are_singular() -> None:
    rng = np.random.default_rng(17)
    for _ in range(20):
        p = random_fixed(rng).replace(theta0=rng.uniform(0.1, 3.0), mu0=rng.uniform(0, 2))
        theta0, mu0, kappa, alpha, sigma, beta = p.scalars(*NAMES)
        c, s = math.cos(theta0), math.sin(theta0)
        K = np.array([[sigma * c * c + alpha, sigma * s * c + mu0], [sigma * s * c, sigma * s * s + beta + 1]])
        model = ss.linear_sprag(p)
        np.testing.assert_allclose([model.x, model.y], np.linalg.solve(K, [0, -kappa]), rtol=1e-9)
        critical = ss.linear_critical_friction(p)
        above = ss.linear_sprag(p.replace(mu0=1.001 * critical)).poles
        assert np.isfinite(above).all()
        assert np.isnan(ss.linear_sprag(p.replace(mu0=0.999 * critical)).poles).all()
        for pole in above:
            c, s = math.cos(pole), math.sin(pole)
            K = np.array([[sigma * c * c + alpha, sigma * s * c + 1.001 * critical], [sigma * s * c, sigma * s * s + beta + 1]])
            assert abs(np.linalg.det(K)) < 1e-9 * np.abs(K).max() ** 2


@pytest.mark.parametrize("alpha", [0.0, 1e-320, 1e-12, 0.3])
@pytest.mark.parametrize("mu0", [0.0, 1e-200, 1e-9, 0.4, 1e9])
@pytest.mark.parametrize("sigma", [1e-200, 0.1, 1e3])
def test_poles_lie_between_0_and_pi(alpha: float, mu0: float, sigma: float) -> None:
    """Compared with the tangents at 60 digits; with α = 0 one pole is at 90°, and for μ₀ = 0 as well both are."""
    p = BASE.replace(theta0=1.0, mu0=mu0, alpha=alpha, sigma=sigma, beta=0.5)
    with mpmath.workdps(60), np.errstate(all="ignore"):
        mu, k_x, k, k_n = (mpmath.mpf(value) for value in (mu0, alpha, sigma, 1.5))
        # det of ((α + σ c², σ s c + μ), (σ s c, 1 + β + σ s²)) over c², T = tan θ₀.
        square = (k * mu) ** 2 - 4 * k_x * (k_n + k) * k_n * (k_x + k)
        large = (k * mu + mpmath.sqrt(square)) / 2 if square >= 0 else None
        found = ss.linear_sprag(p).poles
        if large is None:
            assert np.isnan(found).all()
            return
        expected = [mpmath.atan2(k_n * (k_x + k), large), mpmath.atan2(large, k_x * (k_n + k)) if large else mpmath.pi / 2]
        assert ((found > 0) & (found < np.pi)).all()
        np.testing.assert_allclose(found, [float(value) for value in expected], rtol=1e-12)


def test_sliding_friction_is_the_law_at_rest() -> None:
    assert ss.sliding_friction(0.5, V=0.3, d=7.0) == pytest.approx(0.5 * (1 - math.exp(-2.1)), rel=1e-15)
    assert ss.sliding_friction(0.5, V=-0.3, d=7.0) == ss.sliding_friction(0.5, V=0.3, d=7.0)
    assert ss.sliding_friction(np.array([0.1, 0.2]), 1.0, 1.0).shape == (2,)


# --------------------------------------------------------------------------------------------------- bad input


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ss.folds(BASE, vary="gamma"), "gamma"),
        (lambda: ss.folds(BASE, vary="mu0"), "theta0 is missing"),
        (lambda: ss.folds(ss.Parameters.article(mu0=[0.1, 0.2])), "shape"),
        (lambda: ss.bifurcation_set(BASE, n=1), "n = 1"),
        (lambda: ss.bifurcation_set(ss.Parameters.article(beta=[0.0, 1.0])), "beta"),
        (lambda: ss.critical_value(BASE, "theta0", (1, 2)), "theta0"),
        (lambda: ss.critical_value(BASE, "beta", (2, 1)), "empty"),
        (lambda: ss.critical_value(BASE, "beta", (2, 3)), "widen"),
        (lambda: ss.critical_value(BASE, "sigma", (0, 1)), "sigma|bracket"),
        (lambda: ss.flutter_boundary(BASE, n=0), "n = 0"),
        (lambda: ss.surface(BASE, 4.0, 1.0), "theta = 4"),
        (lambda: ss.surface(BASE, [1.0, 2.0], [1.0, 2.0, 3.0]), "broadcast"),
        (lambda: ss.quasi_static_path(BASE, "theta0", [1.0, 2.0, 1.5]), "both ways"),
        (lambda: ss.quasi_static_path(BASE, "theta0", []), "one axis"),
        (lambda: ss.quasi_static_path(BASE, "d", [1.0]), "vary = 'd'"),
        (lambda: ss.quasi_static_path(BASE, "theta0", [1.0], start=5), "start = 5"),
        (lambda: ss.quasi_static_path(BASE, "theta0", [1.0], start="left"), "'left'"),
        (lambda: ss.sliding_friction(0.5, 1.0, 0.0), "d = 0"),
        (lambda: ss.linear_sprag(BASE), "theta0 is missing"),
        (lambda: ss.precise.cusps(kappa="0"), "kappa"),
    ],
)
def test_bad_input(call: object, words: str) -> None:
    with pytest.raises(ss.SpragsymError, match=words):
        call()  # type: ignore[operator]
