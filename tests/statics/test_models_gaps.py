"""Pages whose gap is an expression: nothing on the other side of the contact's border is listed,
whatever it is.

Pages with gaps at random are drawn by validation/random_pages.py; here what becomes of a state that
lies on the border itself.
"""

from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.paths import first_end
from tests.oracles.gap_pages import HANDS
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


@pytest.fixture(scope="module")
def models() -> dict[str, Any]:
    class Derived(dict[str, Any]):
        """Pages, each derived when a test asks for it."""

        def __missing__(self, name: str) -> Any:
            self[name] = model_of(HANDS[name].page, name)
            return self[name]

    return Derived()


def closed(hand: Any, found: Any, model: Any, p: Any, vary: tuple[str, ...]) -> bool:
    """Whether all gaps are."""
    q = [getattr(found, name) for name in model.coordinates]
    at = {
        **{name: getattr(p, name) for name in model.parameters},
        **{name: getattr(found, name) for name in vary},
    }
    return bool((np.asarray(hand.gap(q, at)) <= 0).all())


@pytest.mark.thorough
def test_states_of_a_rod_are_in_contact(models: dict[str, Any]) -> None:
    """Where the rod rests with an open gap, the forces of a law that goes on beyond the border
    vanish there or beside.
    """
    model, hand = models["rod"], HANDS["rod"]
    for psi in np.linspace(-1.5, 1.5, 31):
        p = model.Parameters(psi=psi, tau=0.3)
        eq = ss.equilibria(p)
        phi = np.linspace(-np.arccos(0.9), np.arccos(0.9), 4001)
        values = hand.forces([phi], {**model.base, "psi": psi, "tau": 0.3}, 1)[0]
        assert int(eq.count) == (np.diff(np.sign(values)) != 0).sum()
        assert eq.complete


@pytest.mark.thorough
def test_a_belt_that_hardens_bounds_where_its_states_are(models: dict[str, Any]) -> None:
    """Depths below 0, from which the law would pull the harder the deeper, widen no region: some
    hundred boxes for 20,000.
    """
    model, hand = models["sledge"], HANDS["sledge"]
    p = model.Parameters(tau=[0.01, 0.02, 0.05], psi=1.2)
    eq = ss.equilibria(p)
    assert eq.complete
    assert eq.decided.all()
    # No force turns the rod farther than the largest normal force at its largest lever does.
    largest = hand.law(1 - 0.85, {"gamma": 10.0}) * (1 + 0.5)
    assert (eq.region[:, 1, 1] - eq.region[:, 1, 0] < 2.1 * largest / p.tau).all()
    for row in range(3):
        at = {name: float(np.broadcast_to(getattr(p, name), 3)[row]) for name in model.parameters}
        phi = np.linspace(-40, 40, 400_001)
        x = at["mu0"] * hand.law(np.cos(phi) - at["eta"], at) / at["sigma"]
        turning = np.where(np.cos(phi) >= at["eta"], hand.forces([x, phi], at, 1)[1], np.nan)
        assert int(eq.count[row]) == (turning[1:] * turning[:-1] < 0).sum()


@pytest.mark.thorough
def test_curves_of_folds_end_with_the_contact(models: dict[str, Any]) -> None:
    model, hand = models["rail"], HANDS["rail"]
    vary = ("mu0", "kappa")
    p = model.Parameters()
    found = ss.bifurcation_set(p, vary, 12, between={"mu0": (0.0, 1.0), "kappa": (-0.3, 0.5)})
    assert found.curves
    assert all(closed(hand, curve, model, p, vary) for curve in found.curves)
    assert closed(hand, found.cusps, model, p, vary)


@pytest.mark.thorough
def test_a_path_leaves_the_contact_where_its_gap_opens(models: dict[str, Any]) -> None:
    """tau (psi − phi) = 0 on the border: the rod at rest just touches the wall at eta = cos psi."""
    model = models["rod"]
    end = first_end(model.Parameters(tau=0.5), "eta", (0.1, 1.1))
    assert end is not None
    assert end.kind == "border"
    assert end.value == pytest.approx(np.cos(0.3), abs=1e-12)


def test_a_state_on_the_border_is_of_both_sides(models: dict[str, Any]) -> None:
    """Without preload the mass of the rail rests at 0, where it just touches without a force."""
    model = models["rail"]
    p = model.Parameters(kappa=0.0, mu0=0.0)
    for contact in (True, False):
        eq = ss.equilibria(p, contact=contact)
        assert eq.complete
        assert (np.abs([*eq.coordinates.values()]).max(axis=0) < 1e-15).sum() == 1


@pytest.mark.thorough
def test_a_gap_smaller_than_floats_tell_has_a_sign(models: dict[str, Any]) -> None:
    """A rod at rest within 1e-16 of where it touches: digits tell on which side, not the rounded
    state.
    """
    model, sides = models["rod"], []
    for psi in np.linspace(0.3, 0.9, 12):
        eta = float(np.cos(psi))
        p = model.Parameters(psi=psi, eta=eta, tau=0.5)
        with mpmath.workdps(50):
            open_ = mpmath.mpf(eta) - mpmath.cos(mpmath.mpf(float(psi))) > 0
        for contact in (True, False):
            eq = ss.equilibria(p, contact=contact)
            here = np.abs(eq.phi[: int(eq.count)] - psi) < 1e-9
            assert eq.complete
            assert here.sum() == (open_ != contact)
        sides.append(bool(open_))
    assert len(set(sides)) == 2


@pytest.fixture(scope="module")
def wedge() -> Any:
    """A wedge on a contact that hardens, pressed down by a force alone."""
    text = (
        'r"""A wedge."""\nfrom spragsym.derive.model import Page, log, tanh\n'
        'page = Page("A wedge on a belt that hardens.")\n'
        'm, k_c, l = page.unit("m", "kg", "mass"), page.unit("k_c", "N/m", "contact"), '
        'page.unit("l", "m", "length")\n'
        'F = page.parameter("F", "N", "preload", ">= 0", 0.2, becomes="kappa")\n'
        'k = page.parameter("k", "N m", "torsion spring", "> 0", 0.2, becomes="tau")\n'
        'mu0, V = page.parameter("mu0", "1", "friction", ">= 0", 0.3), page.parameter("V", '
        '"m/s", "speed", ">= 0", 0.5)\n'
        'd = page.parameter("d", "s/m", "steepness", "> 0", 10.0)\n'
        'phi, y = page.coordinate("phi", "rad", "turn"), page.coordinate("y", "m", "lift")\n'
        "page.kinetic(m * page.rate(y) ** 2 / 2 + m * l**2 * page.rate(phi) ** 2 / 2)\n"
        "page.force(-F, along=y)\n"
        "page.potential(k * (phi - 0.5) ** 2 / 2)\n"
        "page.contact(y - l * log(1 + phi**2) - l * phi**3 / 10, lambda depth: k_c * depth + "
        "k_c * depth**3 / l**2)\n"
        "page.friction(l * phi, V, lambda v: mu0 * tanh(d * v), at_rest=mu0)\n"
    )
    return model_of(text, "wedge")


@pytest.mark.thorough
def test_powers_of_a_gap_that_bends_are_not_expanded(wedge: Any) -> None:
    """N = κ, so that phi is a root of a quartic, and the depth of a cubic."""
    eq = ss.equilibria(wedge.Parameters())
    # 0.2 (phi − 0.5) = 0.2 (0.3 − 2 phi/(1 + phi²) − 0.3 phi²), times 1 + phi²; depth + depth³ =
    # 0.2
    roots = np.roots([0.3, 1, 0.3 - 0.8, 3, -0.8])
    assert eq.decided
    assert eq.phi[: int(eq.count)] == pytest.approx(
        np.sort(roots.real[np.abs(roots.imag) < 1e-9]), rel=1e-12
    )


@pytest.mark.thorough
def test_a_force_that_nothing_balances_leaves_no_state_anywhere(wedge: Any) -> None:
    off = ss.equilibria(wedge.Parameters(), contact=False)
    assert int(off.count) == 0
    assert off.complete
    held = ss.equilibria(wedge.Parameters(kappa=0.0), contact=False)  # then y is free
    assert not held.complete
