"""Curves of Hopf points in the plane of two parameters: against closed forms, maps of eigenvalues,
searches along other lines.
"""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy import optimize

import spragsym as ss
from spragsym.bifurcation import bifurcation_sets, hopf_curves
from spragsym.bifurcation.points import search
from spragsym.statics.balance import Balance
from spragsym.statics.stability import linearization
from tests.oracles.hopf_points import accelerations
from tests.oracles.user_pages import model_of, shipped_page
from tests.support import few

#: Damped sets whose curves are looked at; the second has two Bogdanov–Takens points.
SETS = (
    {"zeta_x": 0.001, "zeta_y": 0.1, "zeta_s": 0.001, "alpha": 0.3, "kappa": 0.1, "sigma": 0.5},
    {
        "kappa": 0.0793,
        "alpha": 0.2943,
        "sigma": 0.5302,
        "zeta_x": 0.01459,
        "zeta_y": 0.6958,
        "zeta_s": 0.01327,
    },
)
BETWEEN = {"mu0": (0.0, 2.0)}


def damped(number: int) -> Any:
    return ss.load("damped").Parameters(**SETS[number])


@pytest.fixture(scope="module", params=few([0, 1]))
def found(request: pytest.FixtureRequest) -> tuple[Any, Any]:
    p = damped(request.param)
    return p, ss.onset_curves(p, n=12, between=BETWEEN)


def by_hand(page: str, P: dict[str, float], q: np.ndarray) -> np.ndarray:
    """A of the equations written by hand, by differences of complex steps."""
    n = len(q)
    rest = np.append(q, np.zeros(n)).astype(complex)
    rows = np.empty((n, 2 * n))
    for k in range(2 * n):
        step = np.where(np.arange(2 * n) == k, 1e-30j, 0.0)
        rows[:, k] = [
            complex(value).imag / 1e-30 for value in accelerations(page, P, list(rest + step))
        ]
    return np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), rows])


@pytest.mark.thorough
def test_stick_slip_in_closed_form() -> None:
    """ζ = 2 μ_s v_s (V² − v_s²)/(V² + v_s²)², and F‴ = 0 at V = (1 + √2) v_s: below it the onset is
    gentle.
    """
    p = ss.load("stick_slip").Parameters(mu_s=0.4, v_s=0.2)
    found = ss.onset_curves(p, ("V", "zeta"), between={"V": (0.0, 1.5), "zeta": (0.0, 1.0)})
    (curve,) = found.curves
    assert found.complete
    V, gentle = curve.V, curve.V < (1 + np.sqrt(2)) * 0.2
    assert curve.zeta == pytest.approx(
        2 * 0.4 * 0.2 * (V**2 - 0.04) / (V**2 + 0.04) ** 2, abs=1e-11
    )
    assert (curve.criticality == np.where(gentle, "supercritical", "subcritical")).all()
    assert curve.omega == pytest.approx(1.0)
    assert found.changes["V"] == pytest.approx(
        [(1 + np.sqrt(2)) * 0.2], abs=max(1e-12, *found.changes["error"])
    )
    assert found.changes["error"].max() < 1e-6


@pytest.mark.by_hand("0")
@pytest.mark.thorough
def test_the_state_loses_its_stability_on_the_curves(found: tuple[Any, Any]) -> None:
    """On a map of eigenvalues, a pair crosses the axis between two frictions where an onset lies
    between them, and only there.
    """
    p, curves = found
    for theta0 in np.linspace(0.15, 3.0, 9):
        onsets = ss.flutter_onsets(p.replace(theta0=theta0), vary="mu0", between=BETWEEN)
        mu0 = np.linspace(0.0, 2.0, 41)[1:]
        eq = ss.equilibria(p.replace(theta0=theta0, mu0=mu0))
        single = eq.count == 1
        grows = eq.growth[:, 0] > 0
        for k in np.flatnonzero(single[1:] & single[:-1]):
            between = int(((onsets.mu0 > mu0[k]) & (onsets.mu0 < mu0[k + 1])).sum())
            assert (grows[k] != grows[k + 1]) == bool(between % 2)
    assert len(curves) > 0


@pytest.mark.by_hand("0")
@pytest.mark.thorough
def test_onsets_change_from_gentle_to_dangerous_where_it_is_said(found: tuple[Any, Any]) -> None:
    p, curves = found
    for theta0, mu0 in zip(curves.changes["theta0"], curves.changes["mu0"], strict=True):
        told = []
        for off in (-1e-3, 1e-3):
            onsets = ss.flutter_onsets(p.replace(theta0=theta0 + off), vary="mu0", between=BETWEEN)
            told.append(onsets.criticality[np.abs(onsets.mu0 - mu0).argmin()])
        assert set(told) == {"supercritical", "subcritical"}
    assert (curves.changes["error"] < 1e-5).all()


#: Two modes that a spring couples; friction feeds the first, a damper takes from the second.
TWO_MODES = shipped_page(
    "stick_slip",
    (
        "x = page.coordinate",
        'y = page.coordinate("y", "m", "displacement across the belt")\nx = page.coordinate',
    ),
    ("page.rate(x) ** 2", "(page.rate(x) ** 2 + page.rate(y) ** 2)"),
    (
        "page.damper(c, along=x)",
        "page.damper(c, along=y)\npage.spring(k_y, along=y)\npage.spring(g, along=x + y)",
    ),
    (
        "V = page",
        """k_y = page.parameter("k_y", "N/m", "stiffness across the belt", ">= 0", 1.5, becomes="kappa")
g = page.parameter("g", "N/m", "stiffness that couples the two", ">= 0", 0.4, becomes="gamma")
V = page""",
    ),
)


@pytest.mark.thorough
def test_a_double_hopf_point_in_closed_form() -> None:
    """λ⁴ + (ζ − a) λ³ + … with a = −μ′(V) is a polynomial in λ² where ζ = a and κ = 1, and both its
    roots are imaginary.
    """
    pytest.importorskip("sympy")
    p = model_of(TWO_MODES, "two_modes").Parameters(v_s=0.5, V=1.0)
    fed = 2 * 0.5 * 0.5 * (1.0**2 - 0.5**2) / (1.0**2 + 0.5**2) ** 2
    curves = ss.onset_curves(
        p, vary=("kappa", "zeta"), n=12, between={"kappa": (0.2, 2.5), "zeta": (0.0, 0.8)}
    )
    points = curves.points
    assert points.complete
    assert points.kind.tolist() == ["HH"]
    np.testing.assert_allclose(
        [points.kappa[0], points.zeta[0]], [1.0, fed], rtol=0, atol=float(points.error[0]) + 1e-15
    )
    # Curves come near it from all sides: 1 + γ, κ + γ and γ are the stiffnesses, and Hurwitz's
    # determinant is 0 on each of them.
    g = float(p.gamma)
    for curve in curves.curves:
        k, z = np.asarray(curve.kappa), np.asarray(curve.zeta)
        b = [
            (1 + g) * (k + g) - g * g,
            z * (1 + g) - fed * (k + g),
            1 + k + 2 * g - fed * z,
            z - fed,
        ]
        np.testing.assert_allclose(
            b[3] * b[2] * b[1], b[1] ** 2 + b[3] ** 2 * b[0], rtol=0, atol=1e-12
        )
    places = np.concatenate(
        [[curve.kappa - 1.0, curve.zeta - fed] for curve in curves.curves], axis=1
    ).T
    near = places[np.hypot(*places.T) < 0.1]
    assert {tuple(np.sign(row).tolist()) for row in near} == {(1, 1), (1, -1), (-1, 1), (-1, -1)}
    # Along a line through it both pairs cross at one place, each with its frequency: roots of λ⁴ +
    # b₂ λ² + b₀.
    both = ss.flutter_onsets(p.replace(kappa=1.0), vary="zeta", between={"zeta": (0.0, 0.4)})
    assert np.sort(both.omega**2) == pytest.approx(
        np.sort(np.roots([1, -(2 + 2 * g - fed**2), 1 + 2 * g])), abs=1e-6
    )


@pytest.mark.thorough
def test_bogdanov_takens_points() -> None:
    """Two zero eigenvalues of equations written by hand, at a fold; a curve of onsets ends
    there.
    """
    p = damped(1)
    curves = ss.onset_curves(p, n=12, between=BETWEEN)
    points = curves.points
    assert points.kind.tolist() == ["BT", "BT"]
    for row in range(2):
        P = {name: float(getattr(points, name)[row]) for name in p.model.parameters}

        def conditions(w: np.ndarray, P: dict[str, float] = P) -> list[float]:
            now = P | {"theta0": w[2], "mu0": w[3]}
            a = np.poly(by_hand("damped", now, w[:2])).real
            still = accelerations("damped", now, [*w[:2], 0.0, 0.0])
            return [*(float(value) for value in still), a[-1], a[-2]]

        w = np.array([points.x[row], points.y[row], points.theta0[row], points.mu0[row]])
        independent = optimize.fsolve(conditions, w + 1e-4, xtol=1e-13)
        assert w == pytest.approx(independent, abs=1e-8)
        folds = ss.folds(p.replace(theta0=P["theta0"]), vary="mu0", between=BETWEEN)
        assert np.abs(folds.mu0 - P["mu0"]).min() < 1e-8
        ends = [(curve.theta0[k], curve.mu0[k]) for curve in curves.curves for k in (0, -1)]
        assert min(np.hypot(theta0 - P["theta0"], mu0 - P["mu0"]) for theta0, mu0 in ends) < 0.05


@pytest.mark.thorough
def test_where_friction_alone_damps_all_points_are_known() -> None:
    """Where friction is 0 all conditions hold but that of a fold: its slope, a factor of them, is
    divided out.
    """
    model = ss.load("kang_nam")
    points = ss.onset_curves(
        model.Parameters(), n=2, between={"theta0": (0.3, 1.3), "mu0": (0.0, 1.5)}
    ).points
    assert points.complete
    assert points.kind.tolist() == ["ZH", "ZH"]
    for row in range(2):
        p = model.Parameters(
            **{name: float(getattr(points, name)[row]) for name in model.parameters}
        )
        state = np.array([[points.x[row]], [points.y[row]]])
        M, C, K = (part[0] for part in linearization(Balance(model, True), state, columns(p)))
        assert abs(np.linalg.det(K)) < 1e-12
        # The pair is ± iω for any size of the only entry of C.
        for damping in (C, C / C[0, 0]):
            whole = np.block(
                [
                    [np.zeros((2, 2)), np.eye(2)],
                    [-np.linalg.solve(M, K), -np.linalg.solve(M, damping)],
                ]
            )
            roots = np.linalg.eigvals(whole)
            assert np.abs(roots[np.abs(roots.imag) > 0.01].real).max() < 1e-8


def columns(p: Any) -> Any:
    """Parameters as the linearization takes them."""
    return np.array([[float(value)] for value in p.scalars(*p.model.parameters)])


def falling() -> Any:
    """The article's model with a friction that falls with the speed, and a damper along the belt
    alone.
    """
    damper = (
        'c_x = page.parameter("c_x", "N s/m", "damper along the belt", ">= 0", 0.001, '
        'becomes="zeta_x")\n'
    )
    more = (
        ("\nd = page.parameter(", f"\n{damper}d = page.parameter("),
        ("page.friction(", "page.damper(c_x, along=x)\npage.friction("),
    )
    return model_of(shipped_page("stribeck", *more), "falling")


@pytest.mark.thorough
def test_lines_that_nothing_is_decided_on_get_fewer_boxes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a root or a decision on lines in the midst, and without an asked budget: what is left
    is said, and covers every line.
    """
    budgets = []

    def noted(lines: Any, condition: Any, budget: int) -> Any:
        budgets.append((lines.given.shape[1] > 1, budget))
        return search(lines, condition, budget)

    monkeypatch.setattr(bifurcation_sets, "search", noted)
    p = ss.load("pad_on_disc").Parameters()
    found = ss.onset_curves(p, n=4)
    assert {budget for many, budget in budgets if many} == {2_000}
    assert [many for many, _ in budgets].count(False) == 4
    assert not found.complete
    assert not found.curves
    for number, name in enumerate(found.vary, len(p.model.coordinates)):
        low, high = found.undecided[:, number].T
        assert all(((low <= line) & (line <= high)).any() for line in found.lines[name])
    for name, options, budget in (
        ("pad_on_disc", ss.ContinuationOptions(search=ss.SearchOptions(budget=300)), 300),
        ("cubic_contact", None, 20_000),
    ):
        budgets.clear()
        ss.onset_curves(ss.load(name).Parameters(), n=3, options=options)
        assert {each for _, each in budgets} == {budget}


@pytest.mark.parametrize(
    ("stiffness", "ratio", "remarks"), [(200.0, 1e-7, 1), (200.0, 1e-5, 0), (2e-4, 1e-7, 1)]
)
def test_states_are_hardly_damped_by_the_ratio_of_damper_to_stiffness(
    monkeypatch: pytest.MonkeyPatch, stiffness: float, ratio: float, remarks: int
) -> None:
    """Whatever the unit of stiffness: 1e-7 of it is next to nothing, 1e-5 is not."""

    def matrices(_family: object, _states: object, damping: bool = True) -> tuple[Any, Any, Any]:
        turning = 3.0  # gyroscopic terms are no damping
        parts = 1.0, turning + ratio * stiffness * damping, stiffness
        return tuple(np.full((1, 1, 1), part) for part in parts)

    monkeypatch.setattr(hopf_curves, "matrices", matrices)
    found = hopf_curves.Plane.of_damping(SimpleNamespace(), np.zeros((1, 3, 2)), 1e-6)
    assert len(found) == remarks
