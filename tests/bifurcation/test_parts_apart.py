"""Onsets of a model whose linearization falls into parts, one of which nothing damps: a pad whose
motion across the belt neither acts on its sliding nor is driven by it while it touches.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from spragsym.results import EquilibriumType
from tests.oracles.user_pages import model_of

PAGE = '''r"""A pad that slides, a mass behind it, and a coordinate across that nothing damps."""
from spragsym.derive.model import Abs, Page, exp, tanh
page = Page("A pad on a belt with a mass behind it.")
m = page.unit("m", "kg", "mass of the pad")
k_c = page.unit("k_c", "N/m", "contact stiffness")
v_s = page.unit("v_s", "m/s", "speed over which friction falls")
mu0 = page.parameter("mu0", "1", "static friction coefficient", ">= 0", 0.6)
F = page.parameter("F", "N", "load", "> 0", 1.0)
k = page.parameter("k", "N/m", "stiffness behind the pad", "> 0", 0.4)
c = page.parameter("c", "N s/m", "damping behind the pad", ">= 0", 0.1)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 1.0)
x = page.coordinate("x", "m", "displacement of the pad")
y = page.coordinate("y", "m", "displacement across")
z = page.coordinate("z", "m", "displacement of the mass")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2 + page.rate(z)**2) / 2)
page.spring(k, along=x - z)
page.spring(k, along=z)
page.damper(c, along=x - z)
page.damper(c, along=z)
page.force(-F, along=y)
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 + exp(-Abs(v) / v_s)) * tanh(20 * v / v_s) / 2)
'''


def growth(V: float, p: Any) -> float:
    """The largest growth of pad and mass, from a linearization by hand."""
    v = V / 1.0
    rise = (
        20 / math.cosh(20 * v) ** 2 * (1 + math.exp(-v)) / 2 - math.tanh(20 * v) * math.exp(-v) / 2
    )
    k, c, slope = p["k"], p["c"], p["mu0"] * p["F"] * rise
    K = np.array([[k, -k], [-k, 2 * k]])
    C = np.array([[c + slope, -c], [-c, 2 * c]])
    whole = np.block([[np.zeros((2, 2)), np.eye(2)], [-K, -C]])
    return float(np.linalg.eigvals(whole).real.max())


@pytest.mark.thorough
def test_a_part_without_damping_hides_no_onset_of_another() -> None:
    pytest.importorskip("sympy")
    p = model_of(PAGE, "part_without_damping").Parameters()
    found = ss.flutter_onsets(p, "V", between={"V": (0.1, 5.0)})
    assert found.complete
    assert set(found.kind) == {"hopf"}
    speeds = np.linspace(0.1, 5.0, 2000)
    signs = np.sign([growth(speed, p) for speed in speeds])
    places = [
        brentq(growth, *speeds[i : i + 2], (p,), 1e-13) for i in np.flatnonzero(np.diff(signs))
    ]
    np.testing.assert_allclose(found["V"], places, rtol=1e-9)
    assert len(places) == 2


def test_two_parts_of_one_frequency_do_not_flutter() -> None:
    """Across, and in tilting, frequencies pass each other at k_t = 2 J k_c/m − 2 k_c a²."""
    model = ss.load("pad_on_legs")
    p = model.Parameters(iota=1.3, tau=None, zeta=0.0)
    found = ss.flutter_onsets(p, "tau", between={"tau": (0.1, 2.0)}, damping=False)
    assert found.complete
    assert len(found) == 0


def test_a_damper_as_good_as_none_on_another_part() -> None:
    """Friction alone damps the pad; the mass hangs on what moves across, hardly damped."""
    pytest.importorskip("sympy")
    page = PAGE.replace("page.spring(k, along=x - z)", "page.spring(k, along=x)")
    page = page.replace("page.spring(k, along=z)", "page.spring(k, along=y - z)")
    page = page.replace("page.damper(c, along=x - z)\n", "").replace("0.1)\nV", "1e-295)\nV")
    p = model_of(page, "part_hardly_damped").Parameters()
    # The friction coefficient falls where tanh(20 v) has come near to 1.
    found = ss.flutter_onsets(p, "V", between={"V": (0.5, 2.0)})
    assert len(found) == 0


WHIRL = '''r"""A rotor that a follower force drives, beside a slider with a damper."""
from spragsym.derive.model import Page, tanh
page = Page("A rotor with a follower force, and a slider.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
a = page.unit("a", "m", "length")
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.3)
W = page.parameter("W", "1/s", "speed of turning", ">= 0", 0.4)
s = page.parameter("s", "N/m", "follower stiffness", ">= 0", 0.2)
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.1)
V = page.parameter("V", "m/s", "belt speed", "> 0", 0.5)
x = page.coordinate("x", "m", "across")
y = page.coordinate("y", "m", "across, too")
z = page.coordinate("z", "m", "slider")
page.kinetic(m * ((page.rate(x) - W * y)**2 + (page.rate(y) + W * x)**2 + page.rate(z)**2) / 2)
for one in (x, y, z):
    page.spring(k, along=one)
page.force(-s * y, along=x)
page.force(s * x, along=y)
page.damper(c, along=z)
page.normal_force(k * a)
page.friction(z, V, lambda v: mu0 * tanh(10 * v / V), at_rest=mu0)
'''


def test_a_rotor_that_a_follower_force_drives_never_loses_a_stability() -> None:
    """x + i y grows in one direction for every s > 0; that squares of λ meet says nothing then."""
    pytest.importorskip("sympy")
    p = model_of(WHIRL, "driven_rotor").Parameters()
    found = ss.flutter_onsets(p, "s", between={"s": (0.05, 2.0)})
    assert (len(found), found.complete) == (0, True)


@pytest.mark.thorough
def test_curves_of_onsets_pass_a_part_that_nothing_damps() -> None:
    pytest.importorskip("sympy")
    p = model_of(PAGE, "part_without_damping").Parameters()
    found = ss.onset_curves(p, ("V", "c"), 4, between={"V": (0.5, 4.0), "c": (0.05, 0.25)})
    assert (len(found), found.complete) == (1, True)
    (curve,) = found.curves
    assert len(curve["V"]) > 4
    for V, c in zip(curve["V"], curve["c"], strict=True):
        here = p.replace(c=c)
        assert growth(V * (1 - 1e-9), here) * growth(V * (1 + 1e-9), here) < 0


PAIR = '''r"""Two blocks on one belt that do not act on each other."""
from spragsym.derive.model import Abs, Page, exp, tanh
page = Page("Two blocks on one belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
v_s = page.unit("v_s", "m/s", "speed over which friction falls")
mu = page.parameter("mu", "1", "friction of the first", ">= 0", 0.5)
nu = page.parameter("nu", "1", "friction of the second", ">= 0", 0.4)
N = page.parameter("N", "N", "normal force", "> 0", 1.0)
c = page.parameter("c", "N s/m", "damper of each", ">= 0", 0.1)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 1.0)
x = page.coordinate("x", "m", "first block")
y = page.coordinate("y", "m", "second block")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.spring(4 * k, along=y)
page.damper(c, along=x)
page.damper(c, along=y)
first = page.normal_force(N, name="first")
second = page.normal_force(N, name="second")
page.friction(x, V, lambda v: mu * exp(-Abs(v) / v_s) * tanh(20 * v / v_s), on=first)
page.friction(y, V, lambda v: nu * exp(-Abs(v) / v_s / 2) * tanh(20 * v / v_s), on=second)
'''


@pytest.mark.thorough
def test_two_parts_each_have_their_curve_and_meet_in_a_double_hopf_point() -> None:
    """Each block grows where its friction falls by more than c: at one speed for ν, and at μ(V)."""
    pytest.importorskip("sympy")
    p = model_of(PAIR, "two_parts").Parameters()
    found = ss.onset_curves(p, ("V", "mu"), 3, between={"V": (0.5, 2.0), "mu": (0.2, 0.8)})

    def fall(V: float, share: float) -> float:
        """Of e^(−s V) tanh(20 V), with the sign turned round."""
        own = share * math.tanh(20 * V) - 20 / math.cosh(20 * V) ** 2
        return own * math.exp(-share * V)

    speed = brentq(lambda V: p["nu"] * fall(V, 0.5) - p["c"], 0.5, 2.0, xtol=1e-14)
    assert found.complete
    assert found.points.kind.tolist() == ["HH"]
    np.testing.assert_allclose(found.points["V"], speed, rtol=1e-12)
    np.testing.assert_allclose(found.points["mu"], p["c"] / fall(speed, 1.0), rtol=1e-12)
    first, second = sorted(found.curves, key=lambda curve: float(np.ptp(curve["V"])))
    np.testing.assert_allclose(first["V"], speed, rtol=1e-12)
    np.testing.assert_allclose(second["mu"], [p["c"] / fall(V, 1.0) for V in second["V"]])


BAND = '''r"""A differential band brake: both ends of the band hang on the lever."""
from spragsym.derive.model import Page, exp, tanh
page = Page("A band around a drum whose two ends hang on one lever.")
m = page.unit("m", "kg", "mass of the lever")
b = page.unit("b", "m", "arm of the slack end")
k_b = page.unit("k_b", "N/m", "stiffness of the band")
nu = page.parameter("nu", "1", "friction of the band", ">= 0", 0.2)
W = page.parameter("W", "rad", "angle of the wrap", "(0, 6)", 3.5)
P = page.parameter("P", "N", "force at the lever", "> 0", 0.05)
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.03)
x = page.coordinate("x", "m", "housing, along the band")
y = page.coordinate("y", "m", "lever, positive opens the band")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(0.3 * k_b, along=y)
page.spring(0.6 * k_b, along=x)
page.damper(c, along=x)
page.damper(c, along=y)
page.force(-P, along=y)
page.contact(y, lambda depth: k_b * depth)
law = lambda v: (exp(nu * W) - 1) * tanh(8 * v / (b * (k_b / m)**(1/2)))
page.friction(x - 2 * y / 5, 0.5 * b * (k_b / m)**(1/2), law, at_rest=exp(nu * W) - 1)
'''


@pytest.mark.thorough
def test_a_curve_along_which_no_coordinate_moves_is_one() -> None:
    """States and what is about them depend on ν W alone."""
    pytest.importorskip("sympy")
    p = model_of(BAND, "band_brake").Parameters()
    between = {"W": (3.0, 6.0), "nu": (0.0, 0.4)}
    (curve,) = ss.onset_curves(p, ("W", "nu"), between=between).curves
    assert np.ptp(curve["nu"] * curve["W"]) < 1e-9
    assert np.ptp(curve["nu"]) > 0.12
    # Of the two coordinates apart no frequencies meet: friction acts on one from the other alone.
    undamped = ss.flutter_onsets(p, "nu", between={"nu": (0.0, 0.4)}, damping=False)
    assert (len(undamped), undamped.complete) == (0, True)


@pytest.mark.thorough
def test_a_part_on_the_axis_hides_no_growth_of_another() -> None:
    """The rotor grows by s/(2 √k) at W = 0, and for every W; the slider swings beside it."""
    pytest.importorskip("sympy")
    eq = ss.equilibria(model_of(WHIRL, "driven_rotor").Parameters(W=[0.0, 0.4]))
    assert eq.undamped.ravel().tolist() == [EquilibriumType.FLUTTER] * 2
    assert not eq.marginal.any()
    assert eq.growth_sign.ravel().tolist() == [1, 1]
