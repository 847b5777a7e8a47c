"""A mass between two stops that its middle repels: the stable manifold of the middle, x′ = λ (x − F)
with the root λ < 0 of λ² + c λ = 1, parts what comes to rest on either stop.
"""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.numerics.decimals import exactly
from tests.oracles.contact_pages import SNAP
from tests.oracles.user_pages import model_of, replaced
from tests.support import needs_a_quick_integrator

pytest.importorskip("sympy")

#: A floor that moves, in the place of the left stop.
FRICTION = """
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.25)
N = page.parameter("N", "N", "normal force", "> 0", 0.5)
V = page.parameter("V", "m/s", "speed of the floor", "> 0", 0.5)
floor = page.normal_force(N, name="floor")
page.friction(x, V, lambda v: mu * tanh(20 * v / V), at_rest=mu, on=floor)"""


def drawn(number: int) -> list[Any]:
    """Sets of parameters, each with its λ."""
    rng = np.random.default_rng(79)
    rows = rng.uniform((3, 0.3, -0.2), (6, 1, 0.2), (number, 3)).tolist()
    return [({"k_c": k, "c": c, "F": F}, -(c + math.hypot(c, 2)) / 2) for k, c, F in rows]


def test_states_to_any_number_of_digits_and_what_each_touches() -> None:
    model = model_of(SNAP, "snap")
    for values, _ in drawn(20):
        k_c, F = Fraction(values["k_c"]), Fraction(values["F"])
        exact = {"left": (k_c + F) / (1 - k_c), "": F, "right": (F - k_c) / (1 - k_c)}
        p = model.Parameters(**values)
        found = [*precise.equilibria(p, dps=40), *precise.equilibria(p, contact=False, dps=40)]
        assert sorted(state.touching for state in found) == ["", "left", "right"]
        assert found == [*precise.equilibria(p, contact=("left",), dps=40), *found[1:]]
        for state in found:
            off = abs(exactly(state.x) - exact[state.touching])
            assert off <= 2 * exactly(state.error) < Fraction(1, 10**39)
            assert state.undamped == (1 if state.touching else 2)


@needs_a_quick_integrator
@pytest.mark.thorough
def test_where_the_manifold_of_the_middle_bounds_the_basins_of_both_stops() -> None:
    model = model_of(SNAP, "snap")
    for values, decay in drawn(4):
        found = ss.basin_boundary(model.Parameters(**values), points=2)
        x, rate = found.points.T
        np.testing.assert_allclose(rate, decay * (x - values["F"]), atol=1e-12)
        assert found.growth == pytest.approx(-1 / decay, rel=1e-12)
        left = (values["k_c"] + values["F"]) / (1 - values["k_c"])
        assert found.boundary.all()
        assert found.sides[:, 0].tolist() == [f"rest at x = {left:.6g}"] * 5


@needs_a_quick_integrator
@pytest.mark.validate
def test_the_force_at_which_a_start_changes_the_stop_that_it_comes_to() -> None:
    model = model_of(SNAP, "snap")
    for values, decay in drawn(2):
        exact = 0.3 - 0.4 / decay
        ends = {"F": (exact - 0.3, exact + 0.2)}
        found = ss.fate_boundary(model.Parameters(**values), "F", between=ends, start=[0.3, 0.4])
        assert abs(found.value - exact) <= found.error < 1e-11
        assert found.state == pytest.approx([exact, 0.0], abs=1e-9)
        assert (found.below.equilibrium, found.above.equilibrium) == (1, 0)


def test_cusps_of_what_rubs_before_a_stop_to_any_number_of_digits() -> None:
    """x³ − k x = μ N − F has its cusp at k = 0, F = μ N, in front of the stop and not behind it."""
    rubbing = replaced(
        SNAP,
        ("import Page", "import Page, tanh"),
        ("k * x**2 / 2 + F * x", "b * k * x**2 / 2 + k * x**4 / a**2 / 4 + F * x"),
        ("k_c = page", 'b = page.parameter("b", "1", "over k", "real", 0.1)\nk_c = page'),
        ('\npage.contact(a + x, lambda depth: k_c * depth, name="left")', FRICTION),
    )
    p = model_of(rubbing, "rubbing").Parameters(F=None)
    span = {"b": (-0.3, 0.3), "F": (0.0, 0.3)}
    found = precise.cusps(p, vary=("b", "F"), between=span, dps=30)
    floats = ss.cusps(p, ("b", "F"), between=span)
    assert floats["touching"].tolist() == ["floor"]
    assert len(found) == len(floats) == 1
    exact = Fraction(float(p.mu)) * Fraction(float(p.N))
    assert abs(exactly(found[0].F) - exact) <= exactly(found[0].radius) < Fraction(1, 10**29)
    assert abs(found[0].b) < 1e-29
