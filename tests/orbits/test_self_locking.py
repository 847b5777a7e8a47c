"""A lever that friction presses on its drum: from μ = b/a on nothing holds it."""

import math

import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

LEVER = '''"""A page of the tests."""
from spragsym.derive.model import Abs, Page, exp, sgn
page = Page("A lever that presses a block on a drum.")
J, k_c = page.unit("J", "kg m^2", "inertia"), page.unit("k_c", "N/m", "stiffness of the lining")
b = page.unit("b", "m", "arm of the normal force")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
a = page.parameter("a", "m", "arm of friction", ">= 0", 0.8)
M = page.parameter("M", "N m", "moment of the actuator", ">= 0", 0.1)
V = page.parameter("V", "m/s", "speed of the drum", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
c = page.parameter("c", "N m s", "damping", ">= 0", 0.01)
phi = page.coordinate("phi", "rad", "angle of the lever")
page.kinetic(J * page.rate(phi) ** 2 / 2)
page.potential(-M * phi)
page.damper(c, along=phi)
page.contact(-b * phi, lambda depth: k_c * depth)
page.friction(a * phi, V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''


@pytest.fixture(scope="module")
def lever() -> ss.Model:
    return model_of(LEVER, "lever")


@pytest.mark.thorough
def test_a_motion_that_grows_ever_stiffer_is_told_so(lever: ss.Model) -> None:
    """The drum carries the lever along, and what it slips dies out the faster the farther it is."""
    found = ss.fate(lever.Parameters(mu=1.3, d=1e4), t_end=400.0)
    assert found.kind == "undecided"
    assert "small deviations shrink by more than 1e+10" in found.why
    assert "time units at phi = " in found.why
    assert found.why.endswith("too stiff")


def test_nothing_holds_it_from_locking_on(lever: ss.Model) -> None:
    """φ = M/(k b (b − μ a)); where μ a is 1 but for rounding, it is very far away, if anywhere."""
    below, at, above = (ss.equilibria(lever.Parameters(mu=mu)) for mu in (1.2, 1.25, 1.3))
    assert below["phi"].tolist() == pytest.approx([0.1 / (1 - 1.2 * 0.8)], rel=1e-13)
    assert above.complete
    assert [int(eq.count) for eq in (at, above)] == [0, 0]
    assert not at.complete
    low, high = at.region[0]
    assert 1e13 < low < high


def test_it_locks_where_the_arms_are_as_friction(lever: ss.Model) -> None:
    found = ss.jump_value(lever.Parameters(), "mu")
    assert math.isclose(float(found), 1.25, rel_tol=1e-12)


def test_locking_refutes_that_nothing_jumps(lever: ss.Model) -> None:
    found = ss.certify(lever.Parameters(), between={"mu": (0.2, 1.6), "a": (0.5, 1.0)})
    assert found.outcome == "refuted"
