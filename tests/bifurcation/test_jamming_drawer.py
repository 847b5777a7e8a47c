"""A drawer that is held off its middle jams between its guides: closed forms of two contacts.

Each guide presses with N = r − c. Forces along it, k x = P + 2 μ N, and moments, 2 N + k_y r =
2 e k x, are linear: x runs to infinity at μ = (2 + k_y)/(4 e). The motion across, with the
frequency √(2 + k_y), is coupled to nothing and damped by nothing.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

DRAWER = '''r"""A drawer between two guides."""
from spragsym.derive.model import Page, tanh
page = Page("A drawer between two guides, held by a spring off its middle.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness of the guides")
L = page.unit("L", "m", "distance of the guides' touches")
e = page.parameter("e", "m", "offset of the spring", "> 0", 0.8, becomes="epsilon")
c = page.parameter("c", "m", "clearance", ">= 0", 0.001, becomes="clearance")
k = page.parameter("k", "N/m", "spring along the guides", "> 0", 0.05, becomes="kappa")
P = page.parameter("P", "N", "pull", "> 0", 0.01, becomes="pull")
k_y = page.parameter("k_y", "N/m", "spring across", "> 0", 0.001, becomes="beta")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
V = page.parameter("V", "m/s", "guide speed", ">= 0", 0.2)
d = page.parameter("d", "s/m", "steepness", "> 0", 20.0)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
r = page.coordinate("r", "m", "yaw times half the distance")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + m * page.rate(r)**2 / 6)
page.force(P, along=x)
page.force(k * x * 2 * e / L, along=r)
page.spring(k, along=x)
page.spring(k_y, along=y)
page.spring(k_y, along=r)
front = page.contact(c - y - r, lambda depth: k_c * depth, name="front")
rear = page.contact(c + y - r, lambda depth: k_c * depth, name="rear")
for guide in (front, rear):
    page.friction(x, V, lambda v: mu * tanh(d * v), at_rest=mu, on=guide)
'''


@pytest.fixture(scope="module")
def drawer() -> Any:
    return model_of(DRAWER, "drawer").Parameters()


def state(mu: float) -> np.ndarray:
    """x and r of the drawer that both guides press."""
    e, c, k, pull, k_y = 0.8, 0.001, 0.05, 0.01, 0.001
    A = np.array([[k, -2 * mu], [-2 * e * k, 2 + k_y]])
    return np.linalg.solve(A, [pull - 2 * mu * c, 2 * c])


@pytest.mark.thorough
def test_the_state_runs_to_infinity_at_the_friction_that_jams(drawer: Any) -> None:
    mu = np.array([0.0, 0.3, 0.6])
    eq = ss.equilibria(drawer.replace(mu=mu))
    assert np.allclose([eq["x"][:, 0], eq["r"][:, 0]], np.transpose([*map(state, mu)]), rtol=1e-12)
    jam = 2.001 / 3.2
    assert ss.jump_value(drawer.replace(mu=0.0), vary="mu") == pytest.approx(jam, rel=1e-12)


@pytest.mark.thorough
def test_of_what_lies_beyond_the_jam_nothing_is_asked() -> None:
    """Without springs across the drawer is loose where one guide does not touch."""
    lines = [line for line in DRAWER.splitlines() if "k_y" not in line]
    page = "\n".join(line for line in lines if "2 * e / L" not in line)
    page = page.replace("page.spring(k, along=x)", "page.spring(k, along=x - 2 * e * r / L)")
    p = model_of(page, "loose_drawer").Parameters(mu=0.0)
    assert ss.jump_value(p, vary="mu") == pytest.approx(1 / (2 * 0.8), rel=1e-12)


@pytest.mark.thorough
def test_the_nearest_jam_in_two_tolerances(drawer: Any) -> None:
    """The nearest point of μ e = (2 + k_y)/4 to (0.3, 0.8), in tenths."""
    margin = ss.jump_margin(drawer, {"mu": 0.1, "epsilon": 0.1})
    mu, e = margin.parameters.mu, margin.parameters.epsilon
    assert mu * e == pytest.approx(2.001 / 4, rel=1e-9)
    assert margin.distance == pytest.approx(np.hypot(mu - 0.3, e - 0.8) / 0.1, rel=1e-9)
    along = np.linspace(0.5, 0.6, 100_001)
    least = np.hypot(along - 0.3, 2.001 / 4 / along - 0.8).min() / 0.1
    assert margin.distance == pytest.approx(least, rel=1e-9)


@pytest.mark.thorough
def test_what_rounds_about_zero_is_no_onset(drawer: Any) -> None:
    """The condition of a mode that nothing damps is 0 all along it; its rounding changes sign."""
    found = ss.flutter_onsets(drawer, "mu")
    assert len(found) == 0
    assert not found.complete
