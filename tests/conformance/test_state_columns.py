"""Equilibria of every model: columns that follow from where they are."""

import numpy as np
import pytest

import spragsym as ss
from spragsym.display import own_name
from spragsym.models.forces import named
from tests.conformance.models import MODELS, a_set
from tests.support import few


@pytest.mark.parametrize(
    "name", few(MODELS, "two_springs", "stick_slip", "mode_coupling", "hertz_contact", "soft_brake")
)
def test_states_have_the_forces_of_springs_and_of_the_contact(name: str) -> None:
    p = a_set(name)
    about = p.model.about
    for contact in p.model.regimes:
        eq = ss.equilibria(p, contact=contact)
        there = eq.states
        count = len(about["springs"])
        for j in range(count):
            end = f"_{j + 1}" if count > 1 else ""
            tension = eq[own_name(p.model, f"spring_force{end}")]
            assert tension.shape == eq.undamped.shape
            longer = (
                eq[own_name(p.model, f"L{end}")][there]
                - np.broadcast_to(rest_of(p, j), eq.undamped.shape)[there]
            )
            assert (
                tension[there] * longer >= 0
            ).all()  # it pulls where it is longer than undeformed
        for one in about["contacts"]:
            if one["gap"] is None:
                continue
            force = eq[own_name(p.model, named("contact_force", one["name"]))]
            assert np.isnan(force[np.arange(force.shape[-1]) >= eq.count[..., None]]).all()
            touches = contact if isinstance(contact, bool) else one["name"] in contact
            if touches or not one["unilateral"]:
                assert (force[there] >= 0).all()
            else:
                assert (force[there] == 0).all()
        if all(one["gap"] is None for one in about["contacts"]):
            with pytest.raises(AttributeError, match="has no attribute 'contact_force'"):
                eq.contact_force  # noqa: B018  # an attribute that is made when asked for


@pytest.mark.parametrize(
    "name", few(MODELS, "two_springs", "stick_slip", "mode_coupling", "hertz_contact", "soft_brake")
)
def test_the_region_holds_every_state(name: str) -> None:
    eq = ss.equilibria(a_set(name), method="search")
    for i, column in enumerate(eq.coordinates.values()):
        low, high = (
            np.broadcast_to(eq.region[..., i, end, None], column.shape)[eq.states] for end in (0, 1)
        )
        assert (low <= column[eq.states]).all()
        assert (column[eq.states] <= high).all()


def rest_of(p: ss.Parameters, spring: int) -> float:
    """The undeformed length of an inclined spring."""
    places = [0.1 * (i + 1) for i in range(len(p.model.coordinates))]
    return float(p.model.algebra.geometry(*places, *p.model.arguments(p))[spring][2])


def test_forces_of_the_article_s_states() -> None:
    """N = k_c δ and T = k (L − L_0), over k_c L_0, of closed forms and of a search."""
    p = ss.Parameters(theta0=np.radians([20.0, 40.0, 150.0]), sigma=0.3)
    for method in ("closed", "search"):
        eq = ss.equilibria(p, method=method)
        np.testing.assert_allclose(eq.contact_force, -eq.y, rtol=1e-14)
        np.testing.assert_allclose(eq.spring_force, 0.3 * (eq.L - 1), rtol=0, atol=1e-15)
