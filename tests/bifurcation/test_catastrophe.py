"""Folds, cusps, flutter onsets and paths against counts, residuals, other codes and the article."""

import math

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles import reference
from tests.oracles.count_map import count_map_mismatches
from tests.oracles.creeping_states import check, random_path
from tests.oracles.families import random_fixed
from tests.support import few

BASE = ss.Parameters.article()
#: Left fold and cusp as AUTO-07p prints them, right fold by Newton's method at 40 digits (stated by
#: peers, degrees).
AUTO_FOLD, AUTO_CUSP, NEWTON_RIGHT_FOLD = "44.559317703", "68.020958508", "155.059418789789"


def _counts(p: ss.Parameters) -> np.ndarray:
    return ss.equilibria(p).count


def _derivatives(orders: int, *values: float) -> list[float]:
    """Sizes of f and its derivatives by θ, from the balance of forces, at θ and the six
    parameters.
    """
    with mpmath.workdps(60):
        theta, *given = (mpmath.mpf(float(value)) for value in values)
        return [
            abs(float(mpmath.diff(lambda t: reference.along(t, *given), theta, order)))
            for order in range(orders)
        ]


# ------------------------------------------------------------------------------------------------
# residuals and other codes


@pytest.mark.parametrize("vary", PARAMETERS)
def test_folds_satisfy_f_and_its_slope(vary: str) -> None:
    found = ss.folds(ss.Parameters.article(theta0=0.8), vary=vary)
    assert found.theta0.size
    assert found.error.max() < 1e-12
    for row in zip(*(getattr(found, name) for name in ("theta", *PARAMETERS)), strict=True):
        f, slope = _derivatives(2, *row)
        assert f < 1e-15
        assert slope < 1e-14


def test_agreement_with_continuation_codes() -> None:
    left, right = np.degrees(ss.folds(BASE).theta0)
    assert f"{left:.9f}" == AUTO_FOLD
    assert f"{right:.12f}" == NEWTON_RIGHT_FOLD
    cusp = ss.cusps(BASE)
    assert f"{np.degrees(cusp.theta0[2]):.9f}" == AUTO_CUSP
    assert abs(cusp.mu0[2] - 0.200931781805090) < 5e-16


# -------------------------------------------------------------------------------------------
# completeness


@pytest.mark.thorough
def test_bifurcation_set_agrees_with_the_count_map() -> None:
    rng = np.random.default_rng(12)
    for trial in range(5):
        assert count_map_mismatches(random_fixed(rng) if trial else BASE, 200) == 0


@pytest.mark.parametrize("kappa", [1e-5, 1e-6, 1e-7])
def test_curves_with_hardly_any_preload_cross_a_friction_as_often_as_folds_are_proved(
    kappa: float,
) -> None:
    p = ss.Parameters.article(kappa=kappa)
    every = ss.bifurcation_set(p)
    whole, columns = every.curves, every.data()
    for name in ("theta0", "mu0"):
        parts = [columns[name][columns["curve"] == number] for number in range(len(whole))]
        assert all(np.array_equal(a, getattr(b, name)) for a, b in zip(parts, whole, strict=True))
    for mu0 in (0.2, 0.9, 3.3, 12.0):
        part = ss.bifurcation_set(p, between={"mu0": (0.9999 * mu0, 1.0001 * mu0)}).curves
        crossings = [
            sum(np.count_nonzero(np.diff(curve.mu0 > mu0)) for curve in curves)
            for curves in (whole, part)
        ]
        assert crossings == [ss.folds(p.replace(mu0=mu0)).theta0.size] * 2


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("vary", "bracket"), [("beta", (1, 2)), ("alpha", (0.007, 0.07)), ("sigma", (0.01, 0.1))]
)
def test_critical_values_put_the_cusp_at_the_friction(
    vary: str, bracket: tuple[float, float]
) -> None:
    value = ss.critical_value(BASE, vary, between={vary: bracket})
    given = {"kappa": "0.007", "alpha": "0.007", "sigma": "0.1", "beta": "0", vary: value}
    lowest = min(
        one.mu0
        for one in ss.precise.cusps(**given, dps=30)
        if one.mu0 > 0 and 0 < one.theta0 < mpmath.pi
    )
    assert abs(lowest - mpmath.mpf("0.5")) < 1e-12
    for side, sign in ((1 - 1e-9, -1), (1 + 1e-9, 1)):
        friction = ss.critical_friction(BASE.replace(**{vary: value * side}))
        assert math.copysign(1, (friction - 0.5) * sign) == (-1 if vary == "sigma" else 1)


def test_surface_puts_equilibria_back() -> None:
    theta, theta0 = (
        np.radians(np.linspace(2, 178, 60))[:, None],
        np.radians(np.linspace(2, 178, 50))[None, :],
    )
    s = ss.kang_nam.surface(BASE, theta, theta0)
    good = np.isfinite(s.mu0) & (s.mu0 >= 0) & (s.mu0 < 50)
    assert good.sum() > 300
    eq = ss.equilibria(BASE.replace(theta0=s.theta0[good], mu0=s.mu0[good]))
    gaps = np.abs(eq.theta - s.theta[good][:, None])
    slot = np.nanargmin(gaps, axis=-1)
    rows = np.arange(slot.size)
    assert gaps[rows, slot].max() < 1e-6
    clear = np.abs(np.nan_to_num(np.diff(eq.theta, axis=-1), nan=1.0)).min(axis=-1) > 1e-3
    assert (eq.undamped[rows, slot][clear] == s.undamped[good][clear]).mean() > 0.999
    np.testing.assert_allclose(eq.x[rows, slot][clear], s.x[good][clear], atol=1e-6)


# ------------------------------------------------------------------------------------------------
# paths


@pytest.mark.parametrize("vary", few(PARAMETERS, "theta0"))
def test_paths_through_folds_are_those_of_a_creeping_particle(vary: str) -> None:
    rng = np.random.default_rng(18 + PARAMETERS.index(vary))
    assert sum(check(*random_path(rng, vary))[-1] for _ in range(8)) == 0


def _xs(p: ss.Parameters, values: list[float], **start: object) -> tuple[list[float], int]:
    # starts of several types
    path = ss.quasi_static_path(p, "theta0", values, **start)  # type: ignore[arg-type]
    return path.x.tolist(), len(path.jumps)


@pytest.mark.parametrize("mu0", [0.25, 0.5, 0.7, 1.0])
def test_a_value_on_a_fold_has_the_state_that_arrives(mu0: float) -> None:
    p = ss.Parameters.article(mu0=mu0)
    found = ss.folds(p)
    fold, on_fold = float(found.theta0[0]), float(found.x[0])
    (below,), (above,) = (_xs(p, [fold + step], start=0)[0] for step in (-1e-3, 1e-3))
    (large,) = _xs(p, [fold - 1e-3], start="large")[0]
    up, jumps = _xs(p, [fold - 1e-3, fold, fold + 1e-3])
    assert up == pytest.approx([below, on_fold, above], abs=1e-7)
    assert jumps == 1
    down, jumps = _xs(p, [fold + 1e-3, fold, fold - 1e-3])
    assert down[::2] == pytest.approx([above, large], abs=1e-12)
    assert abs(down[1] - 0.5 * (above + large)) < 0.1 * (above - on_fold)
    assert jumps == 0
    assert _xs(p, [fold, fold + 1e-3]) == (pytest.approx([on_fold, above], abs=1e-7), 1)
    assert _xs(p, [fold, fold - 1e-3]) == (pytest.approx([on_fold, below], abs=1e-7), 0)
    assert _xs(p, [fold - 1e-3, fold]) == (pytest.approx([below, on_fold], abs=1e-7), 0)
    assert _xs(p, [fold]) == (pytest.approx([on_fold], abs=1e-7), 0)


def test_paths_through_a_pitchfork_stay_together() -> None:
    p = ss.Parameters.article(mu0=0.0, alpha=0.0)
    first, last = ss.folds(p).theta0
    for values in (
        [1.0, first, 1.57, last, 2.2],
        [2.2, last, 1.57, first, 1.0],
        [first, 1.0],
        [first, 1.57],
        [1.57, first],
    ):
        path = ss.quasi_static_path(p, "theta0", values)
        assert path.jumps == ()
        for value, theta in zip(values, path.theta, strict=True):
            # f = cos θ (a sin θ + b): θ = 90°, or if that is divergent sin θ = sin θ₀ + κ/B.
            assert math.sin(theta) == pytest.approx(min(math.sin(value) + 0.007, 1.0), abs=1e-13)
    assert (
        ss.quasi_static_path(p, "theta0", [1.57, 1.0]).theta[1] > 0.5 * math.pi
    )  # of two, the one of larger x


@pytest.mark.parametrize(
    ("vary", "expected"),
    [
        ("kappa", [(1 - math.sin(0.8)) * 1.5]),
        ("beta", []),
        ("sigma", []),
        ("theta0", [math.asin(1 - 0.2 / 1.5), math.pi - math.asin(1 - 0.2 / 1.5)]),
    ],
)
def test_pitchforks_of_the_symmetric_system_are_folds_with_their_kind(
    vary: str, expected: list[float]
) -> None:
    p = ss.Parameters(
        theta0=0.8, mu0=0.0, kappa=0.2, alpha=0.0, sigma=0.3, beta=0.5
    )  # sin θ₀ = 1 − κ/(1 + β)
    found = ss.folds(p, vary)
    np.testing.assert_allclose(getattr(found, vary), expected, rtol=1e-14)
    assert set(found.kind) <= {"pitchfork"}
    np.testing.assert_allclose(found.theta, 0.5 * math.pi, atol=1e-15)
    assert ss.folds(p.replace(alpha=1.5), vary).theta.size == 0  # a = 0: tan θ is a number


def test_a_pitchfork_along_beta_is_where_the_count_changes() -> None:
    p = ss.Parameters(theta0=1.5, mu0=0.0, kappa=0.01, alpha=0.0, sigma=0.3, beta=0.0)
    found = ss.folds(p, "beta")
    assert found.kind.tolist() == ["pitchfork"]
    assert found.beta[0] == pytest.approx(0.01 / (1 - math.sin(1.5)) - 1, rel=1e-13)
    assert _counts(p.replace(beta=found.beta[0] * np.array([1 - 1e-9, 1 + 1e-9]))).tolist() == [
        1,
        3,
    ]
    for vary in ("alpha", "mu0"):
        assert (ss.folds(p, vary).kind == "fold").all()


# cos θ₀ = 0, sin θ₀ = 0, sin θ = 0, cos θ = 0 on a cusp, α = 1 + β, α = σ. A pair that meets its
# mirror image there counts once.
@pytest.mark.parametrize(
    ("values", "number"),
    [
        ((1.0, 0.0, 0.1, 0.0), 6),
        ((2.0, 0.0, 0.1, 0.0), 1),
        ((1.5, 0.0, 0.7, 0.5), 6),
        ((3.0, 0.0, 0.7, 0.5), 1),
        ((3.0, 1.0, 1.25, 4.0), 6),
        ((1.25, 0.5, 0.5, 0.0), 1),
        ((0.007, 1.0, 0.1, 0.0), 4),
        ((0.1, 0.1, 0.1, 0.0), 6),
    ],
)
def test_cusps_at_coincidences(values: tuple[float, ...], number: int) -> None:
    p = ss.Parameters(**dict(zip(PARAMETERS[2:], values, strict=True)))
    found = ss.cusps(p)
    beside = [len(ss.cusps(p.replace(kappa=values[0] * (1 + step)))) for step in (-1e-7, 1e-7)]
    assert len(found) == number == sum(beside) / 2
    assert ss.critical_friction(p) >= 0
    for row in zip(found.theta, found.theta0, found.mu0, strict=True):
        assert max(_derivatives(3, *row, *values)) < 1e-9


# ------------------------------------------------------------------------------------------------
# linear model


def test_linear_model_is_a_linear_solve() -> None:
    rng = np.random.default_rng(17)
    for _ in range(20):
        p = random_fixed(rng).replace(theta0=rng.uniform(0.1, 3.0), mu0=rng.uniform(0, 2))
        theta0, mu0, kappa, alpha, sigma, beta = p.scalars(*PARAMETERS)
        c, s = math.cos(theta0), math.sin(theta0)
        K = np.array(
            [
                [sigma * c * c + alpha, sigma * s * c + mu0],
                [sigma * s * c, sigma * s * s + beta + 1],
            ]
        )
        model = ss.kang_nam.linear_sprag(p)
        np.testing.assert_allclose([model.x, model.y], np.linalg.solve(K, [0, -kappa]), rtol=1e-9)
