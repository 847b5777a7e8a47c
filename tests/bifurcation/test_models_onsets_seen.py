"""Onsets where a search over boxes can't decide all, as in four coordinates: what floats see is
listed, and none is not said.
"""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of

PAD = '''r"""A pad."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin
page = Page("A pad on a compliant disc, four coordinates.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.2)
v_s = page.parameter("v_s", "m/s", "scale of the falling branch", "> 0", 0.3)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 20.0)
mu_s = page.parameter("mu_s", "1", "static friction", ">= 0", 0.4)
mu_k = page.parameter("mu_k", "1", "kinetic friction", ">= 0", 0.2)
F_L = page.parameter("F_L", "N", "preload", ">= 0", 0.05, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.5, becomes="alpha")
k_w = page.parameter("k_w", "N/m", "stiffness of the disc", "> 0", 0.8, becomes="beta")
k_u = page.parameter("k_u", "N/m", "stiffness of the carrier", "> 0", 0.6, becomes="gamma_u")
k_12 = page.parameter("k_12", "N/m", "leaning spring", ">= 0", 0.3, becomes="sigma")
c = page.parameter("c", "N s/m", "dampers", ">= 0", 0.03, becomes="zeta")
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
w = page.coordinate("w", "m", "of the disc")
u = page.coordinate("u", "m", "of the carrier")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2 + page.rate(w)**2 + page.rate(u)**2) / 2)
page.spring(k_x, along=x - u)
page.spring(k_w, along=w)
page.spring(k_u, along=u)
page.spring(k_12, along=x - y)
page.damper(c, along=x)
page.damper(c, along=y)
page.damper(c, along=w)
page.damper(c, along=u)
page.force(0, -F_L, at=(x, y))
page.contact(y - w, lambda depth: k_c * depth + k_c * depth**3 / L_0**2)
page.friction(x, V, lambda v: (mu_k + (mu_s - mu_k) * exp(-Abs(v) / v_s)) * (1 - exp(-d * Abs(v))) * sgn(v))
'''


@pytest.fixture(scope="module")
def pad() -> Any:
    pytest.importorskip("sympy")
    return model_of(PAD, "pad")


@pytest.mark.thorough
@pytest.mark.parametrize("off", [None, -2e-3, 2e-3])
def test_an_onset_in_four_coordinates_is_proved_on_its_own(pad: Any, off: float | None) -> None:
    """Where the growth of the only state changes its sign, next to an end of the range as well;
    that there is no other one is not said.
    """
    want = brentq(
        lambda mu: float(ss.equilibria(pad.Parameters(mu_s=mu)).growth[0]), 1.5, 2.0, xtol=1e-12
    )
    low, high = sorted((want + off, want - np.copysign(0.4, off))) if off else (1.5, 2.0)
    found = ss.flutter_onsets(pad.Parameters(), "mu_s", between={"mu_s": (low, high)})
    assert found.kind.tolist() == ["hopf"]
    assert found.mu_s[0] == pytest.approx(want, abs=1e-9)
    assert found.error[0] < 1e-12
    assert not found.complete
    assert any("floats see no other" in text for text in found.remarks)


@pytest.mark.thorough
def test_where_the_friction_law_is_level_is_seen(pad: Any) -> None:
    """Without dampers every pair crosses where the slope of the law is 0, at mu_s from (mu (1 −
    exp(−d v)))′ = 0 at V.
    """
    V, v_s, d, mu_k = 0.2, 0.3, 20.0, 0.2
    rise, fall = d * np.exp(-d * V), np.exp(-V / v_s)
    more = mu_k * rise / (fall * ((1 - np.exp(-d * V)) / v_s - rise))
    found = ss.flutter_onsets(pad.Parameters(zeta=0.0), "mu_s", between={"mu_s": (0.1, 0.4)})
    assert (found.complete, len(found)) == (True, 4)
    np.testing.assert_allclose(found.mu_s, mu_k + more, atol=1e-9)


WHEELSET = '''
"""A wheelset between two flanges."""
from spragsym.derive.model import Page
page = Page("A wheelset that hunts between two flanges.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
g = page.unit("g", "m", "clearance")
V = page.parameter("V", "m/s", "speed", ">= 0", 0.2)
W = page.parameter("W", "N s/m^2", "conicity", "> 0", 1.0)
c = page.parameter("c", "N s/m", "creep", "> 0", 0.3)
y = page.coordinate("y", "m", "displacement")
z = page.coordinate("z", "m", "yaw times half the gauge")
page.kinetic(m * (page.rate(y)**2 + page.rate(z)**2) / 2)
page.potential(k * (y**2 + 6 * z**2 / 5) / 2)
page.damper(c, along=y)
page.damper(c, along=z)
page.force(V * W * z, along=y)
page.force(-V * W * y, along=z)
left = page.contact(g - y, lambda depth: 10 * k * depth, name="left")
right = page.contact(y + g, lambda depth: 10 * k * depth, name="right")
'''


@pytest.mark.thorough
def test_an_onset_where_no_contact_touches_is_a_remark() -> None:
    """A wheelset hunts between its flanges from V² = 0.1² + 1.1 c² on: λ² + c λ + κ = 0 for
    κ = 1.1 ± i √(V² − 0.1²).
    """
    p = model_of(WHEELSET, "wheelset").Parameters()
    found = ss.flutter_onsets(p, "V", between={"V": (0.0, 5.0)})
    assert found.V.size == 0
    (remark,) = found.remarks
    assert f"no contact touches is an onset at V = {0.109**0.5:.6g}," in str(remark)
    assert not ss.flutter_onsets(p, "V", between={"V": (0.0, 0.3)}).remarks


@pytest.mark.thorough
def test_onset_curves_where_no_contact_touches_are_a_remark() -> None:
    p = model_of(WHEELSET, "wheelset").Parameters()
    crossed = {"V": (0.2, 1.0), "c": (0.1, 0.5)}  # V² = 0.1² + 1.1 c² passes through
    found = ss.onset_curves(p, ("V", "c"), 2, between=crossed)
    assert not len(found)
    (remark,) = found.remarks
    assert "where no contact touches form curves, 1 in number" in remark
    below = {"V": (0.0, 0.3), "c": (0.5, 0.6)}
    assert not ss.onset_curves(p, ("V", "c"), 2, between=below).remarks


STOPS = '''
"""A mass on a softening spring between two stops."""
from spragsym.derive.model import Page
page = Page("A mass on a spring that softens, between two stops.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
g = page.unit("g", "m", "length")
P = page.parameter("P", "N", "pull", "real", 0.1)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x)**2 / 2)
page.potential(k * (x**2 / 2 - x**3 / (3 * g)))
page.force(P, along=x)
left = page.contact(2 * g + x, lambda depth: 10 * k * depth, name="left")
right = page.contact(2 * g - x, lambda depth: 10 * k * depth, name="right")
'''


def test_a_fold_where_no_contact_touches_is_a_remark() -> None:
    """x − x² = P has its fold at P = 1/4, x = 1/2, between the stops at ±2."""
    p = model_of(STOPS, "stops").Parameters()
    found = ss.folds(p, "P", between={"P": (-1.0, 1.0)})
    assert "fold" not in found.kind.tolist()
    (remark,) = found.remarks
    assert "where no contact touches is a fold at P = 0.25," in remark
    assert not ss.folds(p, "P", between={"P": (-1.0, 0.2)}).remarks


CART = '''r"""A pendulum."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin
page = Page("A pendulum on a block on a belt.")
m = page.unit("m", "kg", "bob")
l = page.unit("l", "m", "length")
g = page.unit("g", "m/s^2", "gravity")
mu_k = page.parameter("mu_k", "1", "kinetic friction", ">= 0", 0.3)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.3)
c = page.parameter("c", "N m s", "pivot", ">= 0", 0.05, becomes="zeta")
v_0 = page.parameter("v_0", "m/s", "fall of friction", "> 0", 0.5)
x = page.coordinate("x", "m", "block")
phi = page.coordinate("phi", "rad", "pendulum")
v, w = page.rate(x), page.rate(phi)
page.kinetic(m * v**2 + m * ((v + l * cos(phi) * w) ** 2 + (l * sin(phi) * w) ** 2) / 2)
page.potential(-m * g * l * cos(phi))
page.spring(3 * m * g / l, along=x)
page.damper(c, along=phi)
page.normal_force(3 * m * g)
law = lambda s: (mu_k + exp(-Abs(s) / v_0) / 5) * sgn(s)
page.friction(x, V, slip=law, holds=mu_k + 0.2)
'''


@pytest.mark.validate
def test_a_state_at_the_end_of_a_turn_is_seen_once() -> None:
    """The two modes of the hanging pendulum lose their damping at one speed, so that the search
    is not complete and floats look too; the standing one has ω² = (3 ζ - s)/(3 ζ + s) and
    2 ω⁴ - s ζ ω² = 3, where s is the slope of the friction law times the normal force.
    """
    p = model_of(CART, "cart").Parameters()
    found = ss.flutter_onsets(p, vary="V", between={"V": (0.0, 4.0)})
    assert not found.complete

    def excess(s: float) -> float:
        square = (0.15 - s) / (0.15 + s)
        return float(2 * square**2 - 0.05 * s * square - 3)

    slope = brentq(excess, -0.1, 0.0)
    assert found.phi == pytest.approx([0, 0, np.pi], abs=1e-6)
    expected = [0.5 * np.log(8), 0.5 * np.log(8), -0.5 * np.log(-slope / 1.2)]
    assert found.V == pytest.approx(expected, rel=1e-6)
