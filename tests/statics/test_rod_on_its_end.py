"""A rod that leans on a belt with its end: the gap is an expression of two coordinates, of which
the normal force N = f is known by one balance alone.

With steady friction μ N the others are κ x = μ f and τ (a − t₀) = f (μ sin a − cos a), so that all
equilibria have |a − t₀| ≤ f √(1 + μ²)/τ, whatever the region is that is searched for them.
"""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

ROD = '''r"""A rod on its end."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A rod whose end is on a belt, its inclination held by a torsion spring.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness of the belt")
l = page.unit("l", "m", "half length")
F = page.parameter("F", "N", "force on the centre", "> 0", 0.02, becomes="f")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 5.0)
t0 = page.parameter("t0", "rad", "inclination at rest", "(0, pi)", 0.3)
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.05, becomes="tau")
k_x = page.parameter("k_x", "N/m", "spring along the belt", "> 0", 0.1, becomes="kappa")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.3)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "centre along the belt")
y = page.coordinate("y", "m", "centre across the belt")
a = page.coordinate("a", "rad", "inclination")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + m * l**2 * page.rate(a)**2 / 6)
page.force(0, -F, at=(x, y))
page.spring(k_x, along=x)
page.potential(k_t * (a - t0)**2 / 2)
page.contact(y - l * sin(a) + l, lambda depth: k_c * depth)
page.friction(x - l * cos(a), V, lambda v: mu * tanh(d * v), at_rest=mu)
'''


@pytest.mark.thorough
@pytest.mark.parametrize("mu", [0.0, 1.0, 5.0, 8.0])
def test_the_force_of_a_linear_contact_bounds_what_it_turns(mu: float) -> None:
    f, tau, t0 = 0.02, 0.05, 0.3
    eq = ss.equilibria(model_of(ROD, "rod_on_its_end").Parameters(mu=mu))
    assert eq.complete

    def left(a: float) -> float:
        return f * (mu * math.sin(a) - math.cos(a)) - tau * (a - t0)

    reach = f * math.hypot(1, mu) / tau
    angles = np.linspace(t0 - reach, t0 + reach, 20_001)
    signs = np.sign([left(a) for a in angles])
    want = [
        brentq(left, angles[k], angles[k + 1], xtol=1e-15)
        for k in np.flatnonzero(signs[:-1] * signs[1:] < 0)
    ]
    assert np.allclose(sorted(eq["a"]), want, atol=1e-11)
    x, _, a = (np.array(side) for side in eq.region)
    assert np.allclose(x, mu * f / 0.1, atol=1e-5)
    assert a[0] >= t0 - f * (1 + mu) / tau - 1e-5
    assert a[1] <= t0 + f * (1 + mu) / tau + 1e-5


def test_what_is_known_of_an_undecided_end_is_printed_as_such() -> None:
    undecided = ss.results.CriticalLoad("mu", "t0", 0.5, math.nan, "undecided", math.nan, False)
    assert str(undecided) == "0.5 or more, undecided"
    assert str(undecided.__class__("mu", "t0", 0.5, 1.0, "cusp", 0.0)) == "0.5"
