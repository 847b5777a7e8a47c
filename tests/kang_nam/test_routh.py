"""Stability with the friction law's damping: every step of the proof holds and can fail; states,
Hopf points and certificates against equations written by hand, fifty digits and the search.
"""

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp

import spragsym as ss
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.kang_nam import routh, stability
from tests.oracles.damped_states import eigenvalues, linearizations, signs
from tests.oracles.families import random_fluttering

stiffness, damping = stability.stiffness, stability.damping
NAMES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta", "V", "d")


@pytest.fixture(scope="module")
def derived() -> None:
    """Each of these functions keeps what it gave first, which must be what is derived."""
    for function in (stiffness, damping, routh.upright_friction, routh.coupling_lines):
        function()


def broken() -> list[str]:
    return [step.claim for step in routh.steps() if not step.holds]


@pytest.mark.thorough
def test_every_step_holds() -> None:
    assert len(routh.steps()) == 14
    assert broken() == []


@pytest.mark.thorough
@pytest.mark.usefixtures("derived")
@pytest.mark.parametrize(
    ("module", "name", "changed", "claim"),
    [
        (stability, "damping", lambda: damping() + sp.diag(0, nm.mu0), "C₁₁ = μ₀ d n e^(−d V)"),
        (stability, "damping", lambda: -damping(), "C₁₁ = μ₀ d n e^(−d V)"),
        (stability, "stiffness", lambda: stiffness() + sp.diag(0, 1), "L sin θ K₂₂"),
        (stability, "stiffness", lambda: stiffness().T, "K₁₂ = K₂₁ + μ₀"),
        (
            stability,
            "flutter_discriminant",
            lambda K: 4 * K[0, 1] * K[1, 0],
            "flutter by (27)",
        ),
        (stability, "trace_identity", lambda: False, "what (27) calls stable"),
    ],
)
def test_a_broken_assumption_is_noticed(
    module: Any, name: str, changed: Any, claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, name, changed)
    assert any(claim in step for step in broken())


def random_states(
    n: int, seed: int, **more: Any
) -> tuple[ss.results.Equilibria, Any, dict[str, Any]]:
    """Equilibria of random points, the indices of states, and their parameters."""
    rng = np.random.default_rng(seed)
    p = ss.Parameters(
        theta0=np.pi * rng.uniform(1e-6, 1 - 1e-6, n),
        mu0=10 ** rng.uniform(-2, 0.7, n),
        kappa=10 ** rng.uniform(-3, -0.3, n),
        alpha=10 ** rng.uniform(-3, 0.3, n),
        sigma=10 ** rng.uniform(-2, 0.5, n),
        beta=rng.choice([0.0, 0.4, 1.5], n),
        **{"V": 0.5} | more,
    )
    eq = ss.equilibria(p)
    rows = eq.states
    return eq, rows, {name: np.broadcast_to(p[name], p.shape)[rows[0]] for name in NAMES}


@pytest.mark.parametrize("steepness", [0.3, 5.0, 60.0])
def test_states_grow_as_eigenvalues_and_fifty_digits_say(steepness: float) -> None:
    eq, rows, p = random_states(1500, seed=int(steepness), d=steepness)
    sign = eq["growth_sign"][rows]
    K, C = linearizations(eq.x[rows], eq.y[rows], p)
    # The theorem, from matrices written by hand.
    stable = (np.linalg.det(K) > 0) & (K[:, 0, 1] * K[:, 1, 0] > 0)
    assert (sign == np.where(stable, -1, 1)).all()
    every = eigenvalues(K, C)
    growth = every.real.max(axis=-1)
    clear = np.abs(growth) > 1e-11 * np.abs(every).max(axis=-1)
    assert clear.mean() > 0.1
    assert (np.sign(growth) == sign)[clear].all()
    some = np.arange(0, sign.size, 50)
    by_digits = signs(eq.x[rows][some], eq.y[rows][some], {n: p[n][some] for n in p})
    assert (by_digits == sign[some]).all()


def test_damping_too_small_for_floats_decides_too() -> None:
    """e^(−d V) is 0 in floats, and (27) calls the state stable."""
    p = ss.Parameters.article(theta0=np.radians(100.0), mu0=0.5)
    for steepness in (10.0, 4000.0):
        eq = ss.equilibria(p.replace(d=steepness))
        assert eq.undamped[0] == ss.EquilibriumType.STABLE
        assert eq["growth_sign"][0] == 1
    assert ss.equilibria(p.replace(mu0=0.0))["growth_sign"][0] == -1


@pytest.mark.parametrize("seed", range(8))
def test_hopf_points_are_those_of_the_search(seed: int) -> None:
    rng = np.random.default_rng(seed)
    p = random_fluttering(rng).replace(V=0.5, d=float(rng.uniform(0.5, 20.0)))
    found, searched = ss.flutter_onsets(p), ss.flutter_onsets(p, method="search")
    order = np.argsort(searched.theta0)
    assert found.complete
    assert searched.complete
    assert (found.kind == "hopf").all()
    for name in ("theta0", "x", "y", "omega"):
        assert found[name] == pytest.approx(searched[name][order], abs=1e-12)
    sides = {"up": 1, "down": -1, "": 0}
    assert [sides[one] for one in searched.when[order]] == found.side.tolist()


def test_a_hopf_point_on_a_saddle_and_one_of_a_stable_state() -> None:
    found = ss.flutter_onsets(ss.Parameters.article(mu0=0.1))
    assert found.unstable_before.tolist() == [1, 0]
    assert found.unstable_after.tolist() == [3, 2]
    assert np.degrees(found.theta[1]) == pytest.approx(90.0, abs=1e-12)


@pytest.mark.parametrize(
    ("given", "between", "outcome"),
    [
        ({"theta0": 1.0, "mu0": 0.1}, {"mu0": (0.05, 0.1), "theta0": (0.9, 1.1)}, "proved"),
        ({"theta0": 1.0, "mu0": 0.1}, {"theta0": (1.4, 1.6)}, "refuted"),
        ({"theta0": 1.0, "mu0": 0.1}, {"mu0": (0.0, 0.1)}, "refuted"),
    ],
)
@pytest.mark.parametrize("method", ["auto", "search"])
def test_certificates_of_stability(
    given: dict[str, float], between: dict[str, tuple[float, float]], outcome: str, method: Any
) -> None:
    p = ss.Parameters.article(alpha=0.7, sigma=0.3, **given)
    if method == "search" and outcome == "proved":
        between = {"mu0": between["mu0"]}
    proof = ss.certify(p, "stable", between=between, method=method)
    assert proof.outcome == outcome
    if outcome == "refuted":
        eq, C = ss.equilibria(proof.counterexample), proof.counterexample.mu0
        assert (eq["growth_sign"] > 0).any() or C == 0
        return
    rng = np.random.default_rng(0)
    points = p.replace(**{name: rng.uniform(*ends, 2000) for name, ends in between.items()})
    eq = ss.equilibria(points)
    K, _ = linearizations(eq.x[:, 0], eq.y[:, 0], {n: points[n] for n in NAMES})
    assert (eq.count == 1).all()
    assert (np.linalg.det(K) > 0).all()
    assert (K[:, 0, 1] * K[:, 1, 0] > 0).all()


@pytest.mark.parametrize(
    ("page", "given", "outcome"),
    [
        ("damped", {"theta0": 1.0, "mu0": 0.05}, "proved"),
        ("stick_slip", {"V": 2.0}, "proved"),
        ("stick_slip", {"V": 1.0}, "refuted"),
        ("mode_coupling", {}, "refuted"),
    ],
)
def test_certificates_of_stability_for_any_page(
    page: str, given: dict[str, float], outcome: str
) -> None:
    p = ss.load(page).Parameters(**given)
    assert ss.certify(p, "stable").outcome == outcome


def test_dampers_are_no_part_of_the_theorem() -> None:
    """A brake whose dampers outweigh what the theorem of the friction law alone tells."""
    p = ss.load("damped").Parameters(
        theta0=math.radians(130),
        mu0=0.12,
        kappa=5e-4,
        alpha=0.9,
        sigma=0.2,
        beta=0.0,
        zeta_x=0.019,
        zeta_y=0.02,
        zeta_s=0.002,
        V=0.0017,
        d=6940.0,
    )
    by_closed_form, by_search = ss.equilibria(p), ss.equilibria(p, method="search")
    assert by_closed_form.stability[0] == by_search.stability[0] == "stable"
    assert by_closed_form.growth[0] == pytest.approx(by_search.growth[0], rel=1e-9)
    assert by_search.growth[0] < -9e-3


def test_growth_on_both_sides_of_folds_needs_no_damping_that_floats_tell() -> None:
    """By matrices written by hand, of the two states that are about to meet."""
    told = set[tuple[int, ...]]()
    for p in (ss.Parameters.article(d=200.0, mu0=mu0) for mu0 in (0.1, 0.5)):
        folds = ss.folds(p)
        for row, value in enumerate(
            folds.theta0 * (1 - 1e-6 * np.where(folds.when == "up", 1, -1))
        ):
            eq = ss.equilibria(p.replace(theta0=value))
            two = np.argsort(np.hypot(eq.x - folds.x[row], eq.y - folds.y[row]))[:2]
            at = {n: float(p[n]) for n in NAMES if n != "theta0"} | {"theta0": value}
            K, _ = linearizations(eq.x[two], eq.y[two], at)
            number = (np.linalg.det(K) < 0) + 2 * (K[:, 0, 1] * K[:, 1, 0] < 0)
            numbers = [folds.unstable_before[row], folds.unstable_after[row]]
            assert sorted(number.tolist()) == numbers
            told.add(tuple(numbers))
    assert told == {(0, 1), (2, 3)}


PLANE = {"theta0": (0.1, 3.0), "mu0": (0.02, 0.4)}


@pytest.mark.parametrize("method", ["closed", "search"])
def test_curves_of_onsets_are_an_upright_spring_or_uncoupled(method: Any) -> None:
    p = ss.Parameters.article()
    found = ss.onset_curves(p, n=4, between=PLANE, method=method)
    assert found.complete
    assert found.points.kind.tolist() == ["ZH", "ZH"]
    for curve in found.curves:
        at = {n: np.broadcast_to(p[n], curve.x.shape) for n in NAMES if n in p.ranges}
        at |= {"theta0": curve.theta0, "mu0": curve.mu0}
        K, _ = linearizations(curve.x, curve.y, at)
        upright = np.abs(np.cos(curve.theta0) - curve.x) < 1e-9
        assert upright.all() or not upright[1:-1].any()
        if upright.all():
            along = (1 + p.beta + p.sigma) * p.alpha * np.cos(curve.theta0)
            press = p.kappa + p.sigma * (1 - np.sin(curve.theta0))
            assert curve.mu0 == pytest.approx(along / press, abs=1e-12)
        else:
            assert np.abs(K[:, 0, 1]).max() < 1e-12
            assert curve.omega**2 == pytest.approx(K[:, 1, 1], abs=1e-12)


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.thorough)])
def test_curves_in_closed_form_hold_the_points_of_the_search(seed: int) -> None:
    p = random_fluttering(np.random.default_rng(seed))
    found = ss.onset_curves(p, ("mu0", "theta0"), 3, method="closed")
    chosen = found.lines["mu0"][0]
    searched = ss.flutter_onsets(p.replace(mu0=chosen), method="search")
    assert searched.complete
    gaps = [curve.mu0 - chosen for curve in found.curves]
    assert sum(int(np.diff(gap > 0).sum()) for gap in gaps) == len(searched)
    for curve in found.curves:
        inside = (curve.theta0 > 0) & (curve.theta0 < np.pi) & (curve.mu0 > 1e-6)
        for row in np.flatnonzero(inside)[::8]:
            onsets = ss.flutter_onsets(p.replace(mu0=curve.mu0[row]), method="search")
            off = [onsets[name] - curve[name][row] for name in ("theta0", "x", "y", "omega")]
            assert np.abs(off).max(axis=0).min() < 1e-12


def test_a_curve_of_onsets_that_is_lost_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    from spragsym.kang_nam import hopf_curves

    monkeypatch.setattr(hopf_curves, "_upright", lambda fixed: ())
    found = ss.onset_curves(ss.Parameters.article(), n=2, between=PLANE)
    assert not found.complete
    assert "are proved" in found.remarks[0]


@pytest.mark.parametrize("asked", [{"vary": ("kappa", "mu0")}, {"damping": False}])
def test_other_curves_of_onsets_have_no_closed_form(asked: dict[str, Any]) -> None:
    with pytest.raises(ss.errors.ModelError, match="no closed form"):
        ss.onset_curves(ss.Parameters.article(theta0=1.0), n=2, method="closed", **asked)
