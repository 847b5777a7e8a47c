"""Loads that rise from 0, at which a contact only just touches, and a cusp that points along the
range over which the lowest end is asked for.
"""

import math

import pytest
from scipy.optimize import minimize_scalar

import spragsym as ss
from tests.design.test_self_locking import LEVER
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")

#: A bar of length 1 between a hinge and a moving wall at the distance b. Where it leans by ϑ it
#: presses the wall with N = (cos ϑ − b)/(1 + 1/k_c), and the load is N (tan ϑ + μ): unloaded it
#: only just touches, above and below.
BAR = '''"""A bar."""
from spragsym.derive.model import Abs, Page, exp, sgn
page = Page("A bar between a hinge and a moving wall, pushed through.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness of the bar")
l0 = page.unit("l0", "m", "its length")
b = page.parameter("b", "m", "distance of the wall", "> 0", 0.9)
k_c = page.parameter("k_c", "N/m", "stiffness of the wall", "> 0", 2.0, becomes="kc")
P = page.parameter("P", "N", "load", "real", 0.0)
mu = page.parameter("mu", "1", "friction", ">= 0", 0.1)
V = page.parameter("V", "m/s", "speed of the wall", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
u = page.coordinate("u", "m", "into the wall")
w = page.coordinate("w", "m", "height")
page.kinetic(m * (page.rate(u) ** 2 + page.rate(w) ** 2) / 2)
page.spring(k, (b + u, w), (0, 0), length=l0)
page.force(-P, along=w)
page.contact(-u, lambda depth: k_c * depth)
page.friction(w, V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''

#: States are at x + A sin x = μ N, so that folds of −A cos x = 1 meet in cusps at A = 1, x = π, at
#: which sin x = 0: the folds leave them along A.
CORRUGATED = '''"""A corrugated track."""
from spragsym.derive.model import Abs, Page, exp, sgn, cos
page = Page("A block on a corrugated track that a belt drags along.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "spring")
l = page.unit("l", "m", "wave length over 2 pi")
A = page.parameter("A", "N", "force of the corrugation", "real", 4.0)
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
N = page.parameter("N", "N", "load", "> 0", 10.0)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.potential(-A * l * cos(x / l))
page.normal_force(N)
page.friction(x, V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''


def snaps(mu: float, b: float, kc: float) -> float:
    """The largest load on the bar."""

    def load(lean: float) -> float:
        return (math.cos(lean) - b) / (1 + 1 / kc) * (math.tan(lean) + mu)

    found = minimize_scalar(
        lambda lean: -load(lean),
        bounds=(0.0, math.acos(b)),
        method="bounded",
        options={"xatol": 1e-9},
    )
    return -float(found.fun)


@pytest.mark.thorough
def test_of_two_states_that_touch_one_goes_on() -> None:
    p = model_of(BAR, "bar").Parameters()
    assert ss.jump_value(p, "P") == pytest.approx(snaps(0.1, 0.9, 2.0), rel=1e-12)
    assert ss.quasi_static_path(p, "P", [0.0, 0.008, 0.016]).jumps == ()
    # Pulled up it leaves the wall at once.
    assert ss.jump_value(p, "P", direction="down") == pytest.approx(0.0, abs=1e-15)


@pytest.mark.thorough
def test_a_margin_asks_for_a_beginning_that_is_known() -> None:
    p = model_of(BAR, "bar").Parameters(P=0.01)
    with pytest.raises(ss.errors.ConvergenceError, match=r"^equilibria at P = 0, where the state"):
        ss.jump_margin(p, {"P": 0.001}, vary="P", begin=0.0)
    with pytest.raises(ss.errors.ConvergenceError, match=r"begin a little beyond it$"):
        ss.redesign(p, "b", {"P": 0.03}, begin=0.0)
    found = ss.jump_margin(p, {"P": 0.001}, vary="P", begin=1e-6)
    assert found.distance == pytest.approx((snaps(0.1, 0.9, 2.0) - 0.01) / 0.001, rel=1e-9)


def test_a_load_of_a_domain_that_begins_at_zero() -> None:
    """φ = M/(k b (b − μ a)), from the touch on."""
    p = model_of(LEVER, "lever").Parameters()
    path = ss.quasi_static_path(p, "M", [0.0, 0.01, 0.3])
    assert path["phi"].tolist() == pytest.approx([0.0, 0.01 / 0.76, 0.3 / 0.76], rel=1e-13)
    assert path.jumps == ()
    assert math.isnan(ss.jump_value(p.replace(M=0.0), "M"))


@pytest.mark.thorough
@pytest.mark.parametrize("load", [3.0, 5.53388785282113])
def test_where_a_cusp_is_a_turn_as_well(load: float) -> None:
    """Which of the two values is smaller by its last digit says nothing."""
    p = model_of(CORRUGATED, "corrugated").Parameters(N=load)
    found = ss.critical_friction(p, "mu", "A", between={"A": (0.5, 5.0), "mu": (0.0, 3.0)})
    assert (found.kind, found.complete) == ("cusp", True)
    assert found.value == pytest.approx(math.pi / load, rel=1e-14)


@pytest.mark.thorough
def test_a_bar_in_units_of_a_million_of_its_length() -> None:
    """Its coordinates are some 10⁻⁷, and what it goes into the wall some 10⁻⁹."""
    own = (
        'l0 = page.unit("l0", "m", "its length")',
        'l0 = page.parameter("l0", "m", "", "> 0", 1.0)',
    )
    text = replaced(BAR, (own[0], f'a = page.unit("a", "m", "a unit")\n{own[1]}'))
    u = 1e-6
    p = model_of(text, "bar_in_units").Parameters(
        l0=u, b=0.9 * u, P=0.01 * u, V=0.5 * u, d=10.0 / u
    )
    rises = {"vary": "P", "begin": 1e-3 * u}
    found = ss.certify(p, between={"P": (1e-3 * u, 0.01 * u), "mu": (0.05, 0.1)}, **rises)
    assert found.outcome == "proved"
    margin = ss.jump_margin(p, {"P": 1e-3 * u}, **rises)
    assert margin.distance == pytest.approx((snaps(0.1, 0.9, 2.0) - 0.01) / 1e-3, rel=1e-9)
    between = {"b": (0.7 * u, 0.95 * u), "P": (1e-3 * u, 0.2 * u)}
    lowest = ss.critical_friction(p, "P", "b", between=between)
    assert lowest.value == pytest.approx(u * snaps(0.1, 0.95, 2.0), rel=1e-12)
