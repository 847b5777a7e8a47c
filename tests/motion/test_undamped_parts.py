"""A part that nothing damps goes on, however small it is beside what decays."""

import math
from typing import Any

import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

PAGE = '''r"""A mass on a belt, damped along it and not across."""
from spragsym.derive.model import Page, tanh
page = Page("A mass on a belt, damped along it only.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L = page.unit("L", "m", "length")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.2)
k = page.parameter("k", "N/m", "spring along", "> 0", 0.5, becomes="sigma")
c = page.parameter("c", "N s/m", "damper along", ">= 0", 0.01, becomes="zeta")
F = page.parameter("F", "N", "preload", "> 0", 0.1, becomes="f")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 5.0)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "along the belt")
y = page.coordinate("y", "m", "across the belt")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.force(-F, along=y)
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu * tanh(d * v), at_rest=mu)
'''


@pytest.fixture(scope="module")
def p() -> Any:
    return model_of(PAGE, "damped_along").Parameters()


@pytest.mark.parametrize("size", [1e-3, 0.0])
def test_what_is_not_damped_does_not_come_to_rest(p: Any, size: float) -> None:
    """Across it, y = −f + size cos τ for ever; along it, exp(−ζ τ/2)."""
    tr = ss.simulate(p, x0=0.5, y0=-0.1 + size, t_end=600.0)
    assert tr.y[-1] == pytest.approx(-0.1 + size * math.cos(600.0), abs=1e-8)
    outcome = tr.outcome()
    if size == 0:
        assert outcome.regime == ss.Regime.APPROACHES_EQUILIBRIUM
        assert outcome.rate == pytest.approx(0.005, rel=1e-12)
    else:
        assert outcome.regime == ss.Regime.UNSETTLED
