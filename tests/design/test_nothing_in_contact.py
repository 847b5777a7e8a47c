"""What is asked of a state that does not touch: a wedge that is lifted against a rail, or not.

With N = s sin a − 1, along the guide ρ s = f + μ N cos a − N sin a: it touches where f/ρ sin a > 1,
and runs to infinity at μ = (ρ/sin a + sin a)/cos a.
"""

import math
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

WEDGE = '''r"""A wedge between a guide and a rail."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A wedge of a safety gear between an inclined guide and a rail.")
m = page.unit("m", "kg", "mass of the wedge")
k_c = page.unit("k_c", "N/m", "contact stiffness of the rail")
g_0 = page.unit("g_0", "m", "play between wedge and rail")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.1)
a = page.parameter("a", "rad", "inclination of the guide", "(0, pi/2)", 0.2)
k_r = page.parameter("k_r", "N/m", "return spring", "> 0", 0.01, becomes="rho")
F = page.parameter("F", "N", "lifting force", "> 0", 0.1, becomes="f")
V = page.parameter("V", "m/s", "speed of the rail", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
s = page.coordinate("s", "m", "displacement of the wedge along its guide")
page.kinetic(m * page.rate(s) ** 2 / 2)
page.spring(k_r, along=s)
page.force(F, along=s)
page.contact(g_0 - s * sin(a), lambda depth: k_c * depth)
page.friction(s * cos(a), V, lambda v: mu * tanh(d * v), at_rest=mu)
'''


@pytest.fixture(scope="module")
def wedge() -> Any:
    return model_of(WEDGE, "wedge")


def test_one_point_without_contact_costs_one_point(wedge: Any) -> None:
    rho = np.array([0.01, 0.1, 0.015])
    with pytest.warns(ss.errors.UndecidedWarning, match="no state in contact at mu = 0"):
        found = ss.jump_value(wedge.Parameters(rho=rho), "mu")
    expected = (rho / math.sin(0.2) + math.sin(0.2)) / math.cos(0.2)
    np.testing.assert_allclose(found[[0, 2]], expected[[0, 2]], rtol=1e-12)
    assert np.isnan(found[1])


def test_a_single_point_says_that_nothing_touches(wedge: Any) -> None:
    p = wedge.Parameters(rho=0.1)
    for ask in (
        lambda: ss.jump_value(p, "mu"),
        lambda: ss.jump_margin(p, {"mu": 0.1, "f": 0.1}, vary="mu"),
    ):
        with pytest.raises(ss.errors.ConvergenceError, match="no state in contact at mu = 0"):
            ask()


def test_a_margin_says_where_designs_do_not_touch(wedge: Any) -> None:
    """From ρ = f sin a on, 0.99 tolerances away; those that touch lock far above μ = 0.1."""
    found = ss.jump_margin(wedge.Parameters(), {"rho": 0.01}, vary="mu")
    assert found.distance == math.inf
    assert [remark.split(" jump")[0] for remark in found.remarks] == [
        "whether some designs at a distance of 1 or farther"
    ]
    near = ss.jump_margin(wedge.Parameters(rho=0.001), {"rho": 1e-6}, vary="mu")
    assert (near.distance, near.remarks) == (math.inf, ())


@pytest.mark.thorough
def test_a_design_that_locks_by_rounding_has_no_nearer_one(wedge: Any) -> None:
    locks = (0.01 / math.sin(0.2) + math.sin(0.2)) / math.cos(0.2)
    found = ss.jump_margin(wedge.Parameters(mu=locks), {"mu": 0.1}, vary="mu")
    assert (found.distance < 1e-9, found.remarks) == (True, ())


@pytest.mark.thorough
def test_a_report_of_what_does_not_touch_says_so(wedge: Any) -> None:
    brake = {"m": 1.0, "k_c": 1.0, "g_0": 1.0, "mu": 0.1, "a": 0.2, "k_r": 0.1, "F": 0.1}
    report = ss.Study(brake, model=str(wedge.where), vary="mu").report(
        oscillation=False, redesign=False
    )
    assert any("no state in contact at mu = 0" in str(remark) for remark in report.warnings)


SOFTENING = '''r"""A mass on a softening spring."""
from spragsym.derive.model import Page
page = Page("A mass on a spring that softens.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
g = page.unit("g", "m", "length")
P = page.parameter("P", "N", "pull", "real", 0.1)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x)**2 / 2)
page.potential(k * (x**2 / 2 - x**3 / (3 * g)))
page.force(P, along=x)
'''


def test_a_state_is_followed_from_the_fold_in_which_it_ends() -> None:
    """x − x² = P has two states up to P = 1/4; the float beside it, from where a path goes down as
    well, has none.
    """
    p = model_of(SOFTENING, "softening").Parameters()
    (value,) = ss.folds(p, "P").P.tolist()
    assert value == pytest.approx(0.25, abs=1e-15)
    for begin in (0.25, np.nextafter(0.25, 1.0)):
        at_fold = {"direction": "down", "begin": begin, "until": -1.0}
        assert np.isnan(ss.jump_value(p, "P", **at_fold))
        path = ss.quasi_static_path(p, "P", [begin, -1.0])
        assert path.x[-1] == pytest.approx((1.0 - 5.0**0.5) / 2.0)
    with pytest.raises(ss.errors.SpragsymError, match="begin where there is one"):
        ss.jump_value(p, "P", direction="down", begin=0.25 * (1.0 + 1e-10), until=-1.0)


@pytest.mark.thorough
def test_a_hardening_that_is_0_leaves_the_slopes_at_infinity() -> None:
    """The least hardening k_3 > 0 of the rail moves the end at infinity at once, so that it has no
    slope by k_3 at 0; those by the others are the same without it.
    """
    law = "lambda depth: k_c * depth)"
    hard = WEDGE.replace(law, "lambda depth: k_c * depth + k_3 * depth**3)").replace(
        "s = page.coord",
        'k_3 = page.parameter("k_3", "N/m^3", "hardening of the rail", ">= 0", 0.0)\ns = page.coord',
    )
    p = model_of(hard, "hard_wedge").Parameters(f=0.2)
    slopes, a, rho = ss.jump_gradient(p, "mu"), 0.2, 0.01
    end = (rho / math.sin(a) + math.sin(a)) / math.cos(a)
    assert float(slopes.value) == pytest.approx(end)
    by_a = math.tan(a) * end + 1.0 - rho / math.sin(a) ** 2
    assert float(slopes.a) == pytest.approx(by_a, rel=1e-9)
    assert float(slopes.rho) == pytest.approx(1.0 / (math.sin(a) * math.cos(a)), rel=1e-9)
    assert np.isnan(slopes["k_3"])
