"""Shoes that friction presses on their drum: from μ = b/a on nothing holds one of them, and its
state runs to infinity.
"""

import math

import pytest
from scipy.optimize import minimize_scalar

import spragsym as ss
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")

#: What both pages begin with: the arms of a shoe, its friction, and the speed of the drum.
SHOE = '''"""A page of the tests."""
from spragsym.derive.model import Abs, Page, exp, sgn
page = Page("Shoes that friction presses on a drum.")
J, k_c = page.unit("J", "kg m^2", "inertia"), page.unit("k_c", "N/m", "stiffness of a lining")
b = page.unit("b", "m", "arm of the normal force")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
a = page.parameter("a", "m", "arm of friction", ">= 0", 0.8)
V = page.parameter("V", "m/s", "speed of the drum", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
law = lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v)
'''
#: A lever that presses a block on the drum.
LEVER = (
    SHOE
    + """
M = page.parameter("M", "N m", "moment of the actuator", ">= 0", 0.1)
c = page.parameter("c", "N m s", "damping", ">= 0", 0.01)
phi = page.coordinate("phi", "rad", "angle of the lever")
page.kinetic(J * page.rate(phi) ** 2 / 2)
page.potential(-M * phi)
page.damper(c, along=phi)
page.contact(-b * phi, lambda depth: k_c * depth)
page.friction(a * phi, V, law, at_rest=mu)
"""
)


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
    assert any(remark.startswith("searched within phi in [1e+1") for remark in at.remarks)


def test_it_locks_where_the_arms_are_as_friction(lever: ss.Model) -> None:
    found = ss.jump_value(lever.Parameters(), "mu")
    assert math.isclose(float(found), 1.25, rel_tol=1e-12)


def test_locking_refutes_that_nothing_jumps(lever: ss.Model) -> None:
    found = ss.certify(lever.Parameters(), between={"mu": (0.2, 1.6), "a": (0.5, 1.0)})
    assert found.outcome == "refuted"


@pytest.mark.thorough
def test_a_lever_that_locks_sticks_however_far_it_is_pressed() -> None:
    """φ = M/(1 − h μ a) for each share h of the friction, up to h = 1 or 1/(μ a)."""
    law = ("mu * (1 - exp(-d * Abs(v))) * sgn(v)", "mu * sgn(v) / d")
    text = replaced(LEVER, ("V, law, at_rest=mu", "V, slip=law, holds=mu"), law)
    dry = model_of(replaced(text, ('"s/m", "steepness"', '"1", "holding over sliding"')), "dry")
    for mu in (1.0, 1.3, 3.0):
        found = ss.sticking_states(dry.Parameters(mu=mu, V=0.0))
        high = math.inf if 0.8 * mu > 1 else 0.1 / (1 - 0.8 * mu)
        ends = found["phi_low"][0], found["phi_high"][0]
        assert ends == pytest.approx((0.1 / (1 + 0.8 * mu), high), rel=1e-12)


#: A leading and a trailing shoe, pressed apart by one cylinder, with a return spring each.
DUPLEX = (
    SHOE
    + """
F = page.parameter("F", "N m", "moment of the cylinder", ">= 0", 0.1)
k_r = page.parameter("k_r", "N m", "return spring", ">= 0", 0.02)
g = page.parameter("g", "m", "play of a lining", ">= 0", 0.01)
alpha_1 = page.coordinate("alpha_1", "rad", "angle of the leading shoe")
alpha_2 = page.coordinate("alpha_2", "rad", "angle of the trailing shoe")
page.kinetic(J * (page.rate(alpha_1) ** 2 + page.rate(alpha_2) ** 2) / 2)
page.potential(-F * (alpha_1 + alpha_2) + k_r * (alpha_1**2 + alpha_2**2) / 2)
for name, shoe, way in (("leading", alpha_1, 1), ("trailing", alpha_2, -1)):
    lining = page.contact(g - b * shoe, lambda depth: k_c * depth, name=name)
    page.friction(way * a * shoe, V, law, at_rest=mu, on=lining)
"""
)


@pytest.fixture(scope="module")
def duplex() -> ss.Model:
    return model_of(DUPLEX, "duplex")


@pytest.mark.thorough
def test_one_of_two_shoes_locks_while_the_other_stays(duplex: ss.Model) -> None:
    """1 + k_r = μ a; a state of the leading shoe alone would press the trailing one, so that it is
    none that could run to infinity.
    """
    found = ss.jump_value(duplex.Parameters(a=[0.8, 0.7]), "mu", until=2.0)
    assert found.tolist() == pytest.approx([1.02 / 0.8, 1.02 / 0.7], rel=1e-12)


@pytest.mark.thorough
def test_as_many_lock_as_have_a_larger_friction(duplex: ss.Model) -> None:
    """Of one loading, what is not known of its end is not that the state goes on."""
    given = {**duplex.base, "mu": (0.9, 1.4)}
    found = ss.jump_probability(given, model=duplex, n=4096, rng=1)
    assert found.low <= (1.4 - 1.02 / 0.8) / 0.5 <= found.high
    assert found.undecided == 0


@pytest.mark.thorough
def test_as_many_leave_the_drum_as_have_a_larger_play(duplex: ss.Model) -> None:
    """Both shoes leave it at once, where their play is F/k_r = 5."""
    given = {**duplex.base, "g": (1.0, 9.0)}
    found = ss.jump_probability(given, model=duplex, vary="g", begin=0.0, n=4096, rng=1)
    assert found.low <= 0.5 <= found.high
    assert found.undecided == 0


@pytest.mark.thorough
def test_both_shoes_leave_the_drum_at_once(duplex: ss.Model) -> None:
    """At F = k_r g, in either direction of a parameter, and not before it."""
    for k_r, g in ((0.02, 0.01), (0.05, 0.3)):
        p, lost = duplex.Parameters(k_r=k_r, g=g, F=3 * k_r * g), k_r * g
        for vary, direction, value in (("F", "down", lost), ("g", "up", 3 * g)):
            around = 0.5 * value, 2 * value
            folds = ss.folds(p, vary, between={vary: around})
            assert (folds.complete, len(folds)) == (True, 0)
            until = around[direction == "up"]
            found = ss.jump_gradient(p, vary, direction=direction, until=until)
            assert found.value == pytest.approx(value, rel=1e-12)
            slopes = {"F": (g, k_r), "g": (-3 * g / k_r, 1 / k_r)}[vary]
            other = "g" if vary == "F" else "F"
            given = [float(found.slopes[name]) for name in ("k_r", other)]
            assert given == pytest.approx(slopes, rel=1e-9)
            near = value * (0.99 if direction == "up" else 1.01)
            assert math.isnan(ss.jump_value(p, vary, direction=direction, until=near))
    path = ss.quasi_static_path(p, "F", [0.05, lost])
    held = (lost + (1 - 0.24) * g) / (k_r + 1 - 0.24)
    assert path["alpha_1"][-1] == pytest.approx(held, rel=1e-12)


@pytest.mark.thorough
def test_slopes_where_a_state_runs_to_infinity(duplex: ss.Model) -> None:
    """μ = (1 + k_r)/a, whatever the load and the play are."""
    found = ss.jump_gradient(duplex.Parameters(a=0.7), "mu", until=2.0)
    assert float(found.value) == pytest.approx(1.02 / 0.7, rel=1e-12)
    slopes = [float(getattr(found, name)) for name in ("a", "k_r", "F", "g")]
    assert slopes == pytest.approx([-1.02 / 0.49, 1 / 0.7, 0.0, 0.0], rel=1e-9, abs=1e-12)


@pytest.mark.thorough
def test_the_nearest_design_that_locks(lever: ss.Model) -> None:
    """The point of μ a = 1 that is nearest to (0.3, 0.8), by SciPy."""
    found = ss.jump_margin(lever.Parameters(), {"mu": 0.1, "a": 0.1})
    nearest = minimize_scalar(
        lambda mu: math.hypot(mu - 0.3, 1 / mu - 0.8) / 0.1, bounds=(0.5, 1.3), method="bounded"
    )
    assert found.distance == pytest.approx(nearest.fun, rel=1e-9)
    assert found.change["mu"] == pytest.approx(nearest.x - 0.3, rel=1e-4)
