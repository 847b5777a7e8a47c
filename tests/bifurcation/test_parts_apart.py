"""Onsets of a model whose linearization falls into parts, one of which nothing damps: a pad whose
motion across the belt neither acts on its sliding nor is driven by it while it touches.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
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
