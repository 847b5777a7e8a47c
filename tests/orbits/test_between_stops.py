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

#: A rotor that its inner damping, as the force b across its deflection, makes whirl between stops.
WHIRL = """r\"\"\"A page of the tests.\"\"\"
from spragsym.derive.model import Page
page = Page("A rotor with inner damping between two stops.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
g = page.unit("g", "m", "clearance")
c = page.parameter("c", "N s/m", "damper", "> 0", 0.2)
b = page.parameter("b", "N/m", "inner damping times speed", ">= 0", 0.3)
k_c = page.parameter("k_c", "N/m", "stiffness of a stop", "> 0", 2.0)
x, y = (page.coordinate(name, "m", "deflection") for name in ("x", "y"))
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
for along, force in ((x, -b * y), (y, b * x)):
    page.spring(k, along=along)
    page.damper(c, along=along)
    page.force(force, along=along)
page.contact(g - x, lambda depth: k_c * depth, name="right")
page.contact(g + x, lambda depth: k_c * depth, name="left")
"""


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


@needs_a_quick_integrator
@pytest.mark.thorough
def test_cycles_between_stops_begin_at_the_whole_family_of_a_linear_rotor() -> None:
    """Without the stops x + i y turns as exp(i t) at b = c, at any radius; along this family the
    sign of the tangent is rounding, and no fold.
    """
    p = model_of(WHIRL, "whirl").Parameters(c=0.4, k_c=50.0)
    cycle = ss.cycle(p.replace(b=0.5), near=(1.1, 0.0, 0.0, 1.0))
    for vary, value, ends in (("b", 0.4, (0.2, 0.55)), ("c", 0.5, (0.35, 1.0))):
        branch = ss.cycle_branch(cycle, vary, between={vary: ends})
        kinds = sorted((event.kind, "family" in event.how) for event in branch.events)
        assert kinds == [("end", False), ("end", True), ("grazing", False), ("grazing", False)]
        born = [event.value for event in branch.events if event.kind == "grazing"]
        assert born == pytest.approx([value, value], rel=1e-11)
