"""Two links whose tip is pressed on a table: a gap that bends with two angles."""

import numpy as np
import pytest
from scipy.optimize import brentq, fsolve

import spragsym as ss
from tests.oracles.user_pages import derived

pytest.importorskip("sympy")

FINGER = r'''r"""A finger of two links with springs in its joints, whose tip is pressed on a table."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page("A finger of two links on a table that slides.")
m, l = page.unit("m", "kg", "mass at the tip"), page.unit("l", "m", "first link")
k_c = page.unit("k_c", "N/m", "stiffness of the table")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.4)
H = page.parameter("H", "m", "height of the shoulder", "(0, 2)", 1.4)
n = page.parameter("n", "m", "second link", "> 0", 0.8)
k_1 = page.parameter("k_1", "N m", "spring of the shoulder", "> 0", 0.1)
k_2 = page.parameter("k_2", "N m", "spring of the joint", "> 0", 0.05)
a_0 = page.parameter("a_0", "rad", "rest of the shoulder", "real", 0.5)
V, d = page.parameter("V", "m/s", "speed", ">= 0", 0.3), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
a = page.coordinate("a", "rad", "first link from the vertical")
b = page.coordinate("b", "rad", "second link from the vertical")
va, vb = page.rate(a), page.rate(b)
page.kinetic(m * (1.5 * l**2 * va**2 + n**2 * vb**2 + 2 * l * n * cos(a - b) * va * vb) / 2)
page.potential(k_1 * (a - a_0) ** 2 / 2 + k_2 * (b - a + 3 / 5) ** 2 / 2)
page.contact(H - l * cos(a) - n * cos(b), lambda depth: k_c * depth)
page.friction(l * sin(a) + n * sin(b), V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''


def forces(a: float, b: float, mu: float, a_0: float = 0.5) -> list[float]:
    """By hand, of n = 0.8, H = 1.4."""
    N = np.cos(a) + 0.8 * np.cos(b) - 1.4
    joint = 0.05 * (b - a + 0.6)
    return [
        0.1 * (a - a_0) - joint - N * (np.sin(a) + mu * np.cos(a)),
        joint - 0.8 * N * (np.sin(b) + mu * np.cos(b)),
    ]


def at_fold(z: np.ndarray, *given: float) -> list[float]:
    """The balance, and det K by differences; of a, b, mu, or with mu given of a, b, a_0."""
    a, b, load = z
    steps, rest = np.eye(2) * 1e-6, (*given, load)
    rows = [
        (np.array(forces(a + i, b + j, *rest)) - forces(a - i, b - j, *rest)) / 2e-6
        for i, j in steps
    ]
    return [*forces(a, b, *rest), float(np.linalg.det(np.array(rows)))]


@pytest.mark.thorough
def test_folds_over_a_wide_range_are_all_found() -> None:
    """Angles that turn a hundred times: where each term of the contact's force counted alone, these
    boxes were given up.
    """
    p = ss.load(derived(FINGER, "finger")).Parameters()
    found = ss.folds(p, vary="mu", between={"mu": (0.0, 10.0)})
    assert found.complete
    for a, b, mu in zip(found["a"], found["b"], found["mu"], strict=True):
        np.testing.assert_allclose(fsolve(at_fold, [a, b, mu]), [a, b, mu], rtol=1e-6)
    assert found["mu"][0] == pytest.approx(fsolve(at_fold, [0.5, -0.7, 0.05])[2], rel=1e-7)


@pytest.mark.thorough
def test_a_wide_range_of_parameters_has_one_state() -> None:
    p = ss.load(derived(FINGER, "finger")).Parameters()
    box = {"mu": (0.2, 0.3)}
    assert ss.certify(p, "one equilibrium", between=box).outcome == "proved"
    assert ss.certify(p, "no flutter", between=box).outcome == "proved"


@pytest.mark.thorough
def test_an_inclination_without_a_least_value_rises_from_where_it_is() -> None:
    """Up the tip leaves the table, where no spring is bent; down there is a fold."""
    p = ss.load(derived(FINGER, "finger")).Parameters(mu=0.0)
    left = brentq(lambda a: np.cos(a) + 0.8 * np.cos(a - 0.6) - 1.4, 0.7, 1.2)
    assert ss.jump_value(p, "a_0") == pytest.approx(left, rel=1e-12)
    ends = ss.jump_value(p, "a_0", direction="down")
    assert fsolve(at_fold, [-0.1, 0.8, -0.7], args=(0.0,))[2] == pytest.approx(ends, abs=1e-7)


def test_curves_of_onsets_show_angles_in_degrees_as_their_points_do() -> None:
    p = ss.load(derived(FINGER, "finger")).Parameters(mu=0.0)
    near = {"H": (1.39, 1.41), "mu": (0.4, 0.6)}
    found = ss.onset_curves(p, ("H", "mu"), between=near, damping=False)
    (curve,) = found.curves
    shown = str(found).split("curves", 1)[1]
    assert f"{np.degrees(curve['a'][0]):.10g}" in shown.split()
    assert "a_deg from" in shown


STIFF = r'''r"""Two links with a stiff joint."""
from spragsym.derive.model import Page, cos, sin

page = Page("Two links under a load.")
m, l = page.unit("m", "kg", "mass at each joint"), page.unit("l", "m", "each link")
k_1 = page.unit("k_1", "N m", "spring of the shoulder")
P = page.parameter("P", "N", "load", ">= 0", 0.5)
S = page.parameter("S", "N", "side load", "real", 0.1)
k_2 = page.parameter("k_2", "N m", "spring of the joint", "> 0", 20.0)
a, b = page.coordinate("a", "rad", "first link"), page.coordinate("b", "rad", "second link")
page.kinetic(m * l**2 * (page.rate(a) ** 2 + page.rate(b) ** 2))
page.potential(k_1 * a**2 / 2 + k_2 * (b - a) ** 2 / 2 + P * l * (cos(a) + cos(b)) - S * l * sin(b))
'''


def test_a_stiff_joint_leaves_no_state_far_out() -> None:
    """The sum of both rows, k_1 a = P (sin a + sin b) + S cos b, bounds a; row by row a stiff joint
    lets each angle follow the other.
    """
    p = ss.load(derived(STIFF, "stiff_links")).Parameters()
    eq = ss.equilibria(p)
    assert eq.complete
    np.testing.assert_allclose(eq.region[0], [-1.1, 1.1], rtol=1e-5)
    found = ss.folds(p, vary="P", between={"P": (0.0, 3.0)})
    assert found.complete
    for a, b, P in zip(found["a"], found["b"], found["P"], strict=True):
        turns = P * np.cos([a, b]) - [0, 0.1 * np.sin(b)]
        K = np.array([[21, -20], [-20, 20]]) - np.diag(turns)
        assert abs(np.linalg.det(K)) < 1e-9
        assert P * (np.sin(a) + np.sin(b)) + 0.1 * np.cos(b) == pytest.approx(a, abs=1e-12)
