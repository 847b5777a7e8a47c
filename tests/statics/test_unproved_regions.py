"""What is searched where no region is proved to hold all states: as far as the model's own lengths
tell.
"""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import derived

pytest.importorskip("sympy")

#: k x = μ F e^(s x/F): the states meet at x = F/s, where μ = k/(s e).
PRESSED = r'''r"""A slider that is pressed on the harder the farther it is."""
from spragsym.derive.model import Abs, Page, exp, sgn

page = Page("A slider under a load that grows with its place.")
M, L, T = page.unit("M", "kg", "mass"), page.unit("L", "m", "length"), page.unit("T", "s", "time")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.5)
m = page.parameter("m", "kg", "mass", "> 0", 1.0)
k = page.parameter("k", "N/m", "spring", "> 0", 1.0)
F = page.parameter("F", "N", "load", "> 0", 1.0)
s = page.parameter("s", "N/m", "how the load grows", "> 0", 0.3)
V, d = page.parameter("V", "m/s", "speed", ">= 0", 0.5), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.normal_force(F * exp(s * x / F))
page.friction(x, V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''


@pytest.mark.parametrize("length", [1.0, 1e7, 1e-5])
def test_what_is_searched_has_the_model_s_own_scale(length: float) -> None:
    """Where no region is proved: in metres as in nanometres."""
    p = ss.load(derived(PRESSED, "pressed")).Parameters(F=length)
    found = ss.folds(p, vary="mu", between={"mu": (0.0, 2.0)})
    assert found["x"].tolist() == pytest.approx([length / 0.3], rel=1e-9)
    assert found["mu"].tolist() == pytest.approx([1 / (0.3 * np.e)], rel=1e-12)
