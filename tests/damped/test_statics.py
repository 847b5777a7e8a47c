"""Closed forms of the model damped against the search, which knows none of them."""

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.branches import linked
from spragsym.damped import statics


def drawn(seed: int) -> "ss.Parameters":
    """A set of damped at random, with dampers, as the article's brakes are."""
    rng = np.random.default_rng(seed)
    return ss.load("damped").Parameters(
        theta0=rng.uniform(0.7, 1.1),
        mu0=rng.uniform(0.3, 0.7),
        kappa=rng.uniform(0.004, 0.02),
        alpha=rng.uniform(0.005, 0.02),
        sigma=rng.uniform(0.05, 0.2),
        beta=rng.uniform(0.0, 0.1),
        **dict(zip(("zeta_x", "zeta_y", "zeta_s"), rng.uniform(0.0, 0.1, 3), strict=True)),
    )


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(2))
def test_where_states_end_is_what_the_search_finds(seed: int) -> None:
    p = drawn(seed)
    closed, found = (ss.folds(p, "theta0", method=way) for way in ("closed", "search"))
    assert closed.parameters is p
    np.testing.assert_allclose(closed.theta0, found.theta0, rtol=1e-9)
    np.testing.assert_allclose(closed.x, found.x, rtol=1e-8)
    assert closed.ends.tolist() == found.ends.tolist()
    for vary in ("mu0", "theta0"):
        ours, theirs = (ss.jump_value(p, vary, method=way) for way in ("closed", "search"))
        np.testing.assert_allclose(ours, theirs, rtol=1e-9)


@pytest.mark.parametrize("contact", [True, False])
def test_states_are_those_that_the_search_finds(contact: bool) -> None:
    """Over both parameters of the plane, with their stability under the dampers."""
    rng = np.random.default_rng(5)
    p = drawn(1).replace(theta0=rng.uniform(0.1, 3.0, 12), mu0=rng.uniform(0.0, 1.0, 12))
    closed, found = (ss.equilibria(p, contact, method=way) for way in ("closed", "search"))
    assert closed.parameters is p
    assert closed.complete
    assert closed.count.tolist() == found.count.tolist()
    assert ss.count(p).tolist() == ss.equilibria(p).count.tolist()
    filled = found.x.shape[-1]
    order = np.argsort(closed.x, axis=-1, kind="stable")[..., :filled]
    for name in ("x", "y", "theta", "L", "contact_force", "growth", "undamped"):
        ours = np.take_along_axis(getattr(closed, name), order, axis=-1)
        np.testing.assert_allclose(ours, getattr(found, name), rtol=1e-9, atol=1e-12)
    for one, other in zip(closed.stability, found.stability, strict=True):
        assert sorted(filter(None, one.tolist())) == sorted(filter(None, other.tolist()))


def test_paths_need_no_tubes(monkeypatch: pytest.MonkeyPatch) -> None:
    from spragsym.bifurcation import branches

    monkeypatch.setattr(branches, "Along", lambda *_: pytest.fail("tubes were asked"))
    path = ss.quasi_static_path(drawn(0), "mu0", np.linspace(0.0, 0.7, 8))
    assert path.x.shape == (8,)


@pytest.mark.thorough
def test_curves_of_folds_are_those_of_the_search() -> None:
    p = drawn(0)
    closed, found = (
        ss.bifurcation_set(p, n=8, between={"mu0": (0.0, 1.0)}, method=way)
        for way in ("closed", "search")
    )
    assert closed.cusps.parameters is p
    np.testing.assert_allclose(sorted(closed.cusps.mu0), sorted(found.cusps.mu0), rtol=1e-9)


@pytest.mark.thorough
def test_branches_go_on_as_tubes_do() -> None:
    p = drawn(0)
    fold = float(ss.jump_value(p, "mu0"))
    eq = ss.equilibria(p.replace(mu0=np.array([0.5 * fold, 0.99 * fold, 1.01 * fold])))
    turns = ss.folds(p, "mu0")
    halved = ss.ContinuationOptions(halvings=3)
    found = linked(p.of(p.model.search), "mu0", eq, turns, options=halved)
    ways = [statics.linked(p, "mu0", eq, turns), found]
    assert ways[0] == ways[1]
    assert any(len(step) < count for step, count in zip(ways[0], eq.count, strict=False))


def test_a_brake_that_refutes_a_claim_has_its_dampers() -> None:
    p = drawn(0)
    fold = float(ss.jump_value(p, "mu0"))
    found = ss.certify(p, between={"mu0": (0.0, 1.1 * fold)})
    assert found.outcome == "refuted"
    assert found.counterexample.model is p.model
    assert ss.certify(p, between={"mu0": (0.0, 0.9 * fold)}).outcome == "proved"


def test_dampers_may_be_many() -> None:
    p = drawn(1)
    many = p.replace(zeta_x=np.linspace(0.0, 1.0, 3))
    assert ss.jump_value(many, "mu0").tolist() == 3 * [ss.jump_value(p, "mu0")]
