"""Equilibria around the anchors of springs: torsion springs, whose force has no value there, and
springs however stiff.
"""

from typing import Any

import mpmath as mp
import numpy as np
import pytest

import spragsym as ss
from tests.oracles.turned_spring import turned_spring
from tests.oracles.user_pages import model_of
from tests.support import ROOT, few

pytest.importorskip("sympy")

PAGE = (ROOT / "tests/oracles/pages/soft_brake.py").read_text(encoding="utf-8")
NAMES = ("theta0", "mu0", "kappa", "alpha", "sigma", "tau", "gamma")


@pytest.fixture(scope="module")
def model() -> Any:
    return model_of(PAGE, "soft_brake")


def same_as_the_scalar_equation(model: Any, sets: dict[str, Any], contact: bool) -> None:
    """Counts, and states within their bounds, of sets of shape (N,)."""
    eq = ss.equilibria(model.Parameters(**sets), contact=contact)
    assert eq.complete
    assert eq.whole.all()
    for i in range(eq.count.size):
        with mp.workdps(50):
            want = turned_spring(
                model.Parameters(**{name: values[i] for name, values in sets.items()}), contact
            )
        assert eq.count[i] == len(want), (
            contact,
            {name: float(values[i]) for name, values in sets.items()},
        )
        for slot, (x, y) in enumerate(want):
            for value, exact in ((eq.x[i, slot], x), (eq.y[i, slot], y)):
                assert abs(value - float(exact)) <= eq.error[i, slot] * max(1, abs(value)) + 1e-16
    assert np.nanmax(eq.error, initial=0.0) <= 1e-12


@pytest.mark.parametrize("number", few([2, 24], 2))
@pytest.mark.parametrize("contact", [True, False])
def test_states_with_a_torsion_spring_are_those_of_a_scalar_equation_in_its_angle(
    model: Any, contact: bool, number: int
) -> None:
    rng = np.random.default_rng(14)
    base = model.base
    sets = {name: base[name] * 10.0 ** rng.uniform(-1.5, 1.5, 24)[:number] for name in NAMES[2:]}
    sets |= {"theta0": rng.uniform(0.1, 3.0, 24)[:number], "mu0": rng.uniform(0, 1, 24)[:number]}
    same_as_the_scalar_equation(model, sets, contact)


@pytest.mark.thorough
def test_states_as_near_to_the_anchor_as_the_torsion_spring_is_weak_are_found(model: Any) -> None:
    """A load that the spring can't carry pushes the mass to the anchor, where only the torque holds
    it: l is about τ φ/κ.
    """
    tau = 10.0 ** -np.arange(2.0, 13.0)
    ones = np.ones(tau.size)
    sets = {"theta0": 3.0, "mu0": 0.5, "kappa": 0.5, "alpha": 0.0, "sigma": 0.1, "gamma": 5.0}
    every = {name: value * ones for name, value in sets.items()} | {"tau": tau}
    same_as_the_scalar_equation(model, every, False)
    eq = ss.equilibria(model.Parameters(**every), contact=False)
    nearest = np.nanmin(np.hypot(eq.x - np.cos(3.0), eq.y - np.sin(3.0)), axis=1)
    assert (nearest < 20 * tau).all()
    assert (nearest > tau).all()


@pytest.mark.thorough
def test_without_torsion_and_hardening_the_article_comes_back(model: Any) -> None:
    rng = np.random.default_rng(2)
    n = 40
    common = {
        "theta0": rng.uniform(0.1, 3.0, n),
        "mu0": rng.uniform(0, 1.2, n),
        "kappa": 10.0 ** rng.uniform(-2.5, -0.5, n),
        "alpha": 10.0 ** rng.uniform(-2.5, -0.5, n),
        "sigma": 10.0 ** rng.uniform(-1.5, 5.0, n),
    }
    for contact in (True, False):
        eq = ss.equilibria(model.Parameters(**common, tau=0.0, gamma=0.0), contact=contact)
        known = ss.equilibria(ss.Parameters(**common, beta=0.0), contact=contact)
        assert eq.complete
        assert (eq.count == known.count).all()
        want = np.sort(known.x, axis=-1)[:, : eq.x.shape[1]]
        assert np.nanmax(np.abs(eq.x - want)) < 1e-11


@pytest.mark.thorough
def test_the_region_of_a_torsion_spring_holds_all_states(model: Any) -> None:
    """A proved region holds the states of any larger one; here those of the scalar equation, which
    knows no region.
    """
    rng = np.random.default_rng(9)
    for _ in range(8):
        p = {name: model.base[name] * 10.0 ** rng.uniform(-2, 2) for name in NAMES[2:]}
        p |= {"theta0": rng.uniform(0.1, 3.0), "mu0": rng.uniform(0, 1)}
        for contact in (True, False):
            eq = ss.equilibria(model.Parameters(**p), contact=contact)
            assert eq.whole.all()
            with mp.workdps(50):
                for state in turned_spring(model.Parameters(**p), contact):
                    assert all(
                        low <= value <= high
                        for value, (low, high) in zip(map(float, state), eq.region, strict=True)
                    )
