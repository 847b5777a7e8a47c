"""Which state is followed, and where it ends, where mirrors and ties leave that open: own pages against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.foremost import foremost
from tests.support import model_of

pytest.importorskip("sympy")

#: U = k sin² φ/2 + P cos φ: U'' = 1 − P and U'''' = P − 4 at φ = 0, so that the two others, cos φ = P, lie below P = 1, unstable.
ROD = r'''r"""An upright rod under a load, propped at its tip by a side spring."""
from spragsym.derive.model import Page, cos, sin

page = Page("A propped upright rod under a load.")
m = page.unit("m", "kg", "mass at the tip")
k = page.unit("k", "N/m", "side spring")
l = page.unit("l", "m", "length")
P = page.parameter("P", "N", "load", ">= 0", 0.5, becomes="P")
e = page.parameter("e", "1", "offset of the side spring over the length", "real", 0.0)
phi = page.coordinate("phi", "rad", "angle from upright")
page.kinetic(m * l**2 * page.rate(phi) ** 2 / 2)
page.potential(k * (l * sin(phi) - e * l) ** 2 / 2)
page.force(0, -P, at=(l * sin(phi), l * cos(phi)))
'''
#: Unloaded it stands at (0, h) and (0, −h): both with x = 0, and only the first one comes to an end under a load.
ARCH = r'''r"""A shallow arch of two springs under a load at its tip."""
from spragsym.derive.model import Page, sqrt

page = Page("A shallow arch of two springs under a load at its tip.")
m = page.unit("m", "kg", "mass at the tip")
k = page.unit("k", "N/m", "stiffness of the springs")
b = page.unit("b", "m", "half of the width")
P = page.parameter("P", "N", "load", ">= 0", 0.0, becomes="P")
H = page.parameter("H", "m", "height", "> 0", 0.5, becomes="h")
k_x = page.parameter("k_x", "N/m", "side spring", ">= 0", 0.1, becomes="alpha")
x = page.coordinate("x", "m", "sideways")
y = page.coordinate("y", "m", "height of the tip over the supports")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k, (x, y), (-b, 0), length=sqrt(b**2 + H**2))
page.spring(k, (x, y), (b, 0), length=sqrt(b**2 + H**2))
page.spring(k_x, along=x)
page.force(0, -P, at=(x, y))
'''

#: It snaps through along y³ − y + P = 0 with x = 0; below y = 0 that is unstable, and stable are (√−y, y) and its mirror image.
COLUMN = r'''r"""A column that snaps through and then leans to one side."""
from spragsym.derive.model import Page

page = Page("A column that snaps through and then leans to one side.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
P = page.parameter("P", "N", "load", ">= 0", 0.1, becomes="P")
x = page.coordinate("x", "m", "sideways")
y = page.coordinate("y", "m", "height")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.potential(k * ((y**4 + x**4) / (4 * l**2) + y * x**2 / (2 * l) - y**2 / 2))
page.force(0, -P, at=(x, y))
'''


@pytest.fixture(scope="module")
def rod(tmp_path_factory: pytest.TempPathFactory) -> Any:
    return model_of(ROD, "rod", tmp_path_factory.mktemp("rod"))


def fold_of_rod(e: Any) -> Any:
    """F = sin φ cos φ − e cos φ − P sin φ: det K = 0 where sin³ φ = e, and there P = (1 − e^(2/3))^(3/2)."""
    return (1 - np.abs(e) ** (2 / 3)) ** 1.5


@pytest.mark.thorough
@pytest.mark.parametrize("load", [[0.5, 0.9, 1.1, 1.5], [0.5, 1 - 1e-9, 1 + 1e-9]])
def test_a_stable_state_between_two_that_are_not_ends_where_they_meet(load: list[float], rod: Any) -> None:
    path = rod.quasi_static_path(rod.Parameters(), "P", load)
    (jump,) = path.jumps
    assert jump.kind == "pitchfork"
    assert abs(jump.value - 1) <= jump.error
    assert (jump.before["phi"], abs(jump.after["phi"])) == pytest.approx((0.0, np.pi), abs=1e-12)
    assert np.abs(path.phi[np.array(load) > 1]) == pytest.approx(np.pi)
    assert path.phi[np.array(load) <= 1] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.thorough
def test_its_value_is_the_limit_of_that_of_imperfect_ones(rod: Any) -> None:
    e = np.array([1e-2, 1e-4, 1e-6, 0.0])
    found = rod.jump_value(rod.Parameters(e=e), "P", begin=0.5, until=1.5)
    assert found == pytest.approx(fold_of_rod(e), abs=1e-14)


@pytest.mark.thorough
def test_a_state_that_becomes_stable_between_two_others_is_followed(rod: Any) -> None:
    path = rod.quasi_static_path(rod.Parameters(), "P", [1.5, 1.1, 0.9, 0.5], start=0)
    assert path.phi == pytest.approx(0.0, abs=1e-12)
    assert path.stability.tolist() == [ss.Stability.DIVERGENT] * 2 + [ss.Stability.STABLE] * 2
    assert path.jumps == ()


@pytest.mark.thorough
def test_of_two_states_that_are_equally_small_the_one_of_larger_coordinates_is_followed(tmp_path: Any) -> None:
    """Not the one that rounding makes smaller; the fold is that of two bars, 2 (L^(2/3) − 1)^(3/2) with L² = 1 + h²."""
    arch = model_of(ARCH, "arch", tmp_path)
    h = np.linspace(0.2, 0.6, 9)
    by_hand = 2 * (np.sqrt(1 + h**2) ** (2 / 3) - 1) ** 1.5
    assert arch.jump_value(arch.Parameters(h=h), "P", begin=0.0, until=2.0) == pytest.approx(by_hand, abs=1e-12)
    for height in h[:4]:
        path = arch.quasi_static_path(arch.Parameters(h=height), "P", [0.0, 1e-4])
        assert path.y[0] == pytest.approx(height)


@pytest.mark.thorough
def test_of_two_states_equally_near_behind_a_fold_points_and_paths_name_the_same(tmp_path: Any) -> None:
    column = model_of(COLUMN, "column", tmp_path)
    p = column.Parameters()
    (jump,) = column.quasi_static_path(p, "P", [0.1, 0.5], start=3).jumps
    folds = column.folds(p, vary="P", between={"P": (0.01, 1.0)})
    y = min(np.roots([1.0, 0.0, -1.5, 2 / 27**0.5]).real)
    for after in (jump.after, {name: float(folds.after[name][0]) for name in ("x", "y")}):
        assert (after["x"], after["y"]) == pytest.approx((np.sqrt(-y), y), abs=1e-12)


@pytest.mark.thorough
def test_a_margin_asks_of_designs_below_where_the_parameter_begins(rod: Any) -> None:
    p, scale = rod.Parameters(e=0.02, P=0.7), {"e": 0.01, "P": 0.05}
    e = np.linspace(-0.3, 0.3, 20001)
    by_hand = np.sqrt(((e - 0.02) / 0.01) ** 2 + ((fold_of_rod(e) - 0.7) / 0.05) ** 2).min()
    assert rod.jump_margin(p, scale, vary="P", begin=0.2).distance == pytest.approx(by_hand, rel=1e-6)
    cubic = ss.load("cubic_contact")
    p = cubic.Parameters(theta0=0.7, mu0=0.4)
    begun = cubic.jump_margin(p, {"mu0": 0.05}, vary="mu0", begin=0.3).distance
    assert begun == pytest.approx(cubic.jump_margin(p, {"mu0": 0.05}).distance, rel=1e-9)


@pytest.mark.thorough
def test_a_path_asks_nothing_of_what_lies_outside_of_its_values() -> None:
    cubic, pivoted = ss.load("cubic_contact"), ss.load("sprag_rod")
    path = cubic.quasi_static_path(cubic.Parameters(theta0=0.7), "kappa", [0.001, 0.1, 0.3])
    assert np.isfinite(path.x).all()
    value = pivoted.jump_value(pivoted.Parameters(theta0=0.5), "psi", begin=0.001, until=1.5)
    assert value == pytest.approx(pivoted.jump_value(pivoted.Parameters(theta0=0.5), "psi", begin=0.01, until=1.5), abs=1e-9)


@pytest.mark.parametrize("name", ["cubic_contact", "kang_nam"])
def test_no_points_have_no_answers(name: str) -> None:
    model = ss.load(name).search
    p = model.Parameters(theta0=np.empty((0, 3)))
    assert model.jump_value(p).shape == (0, 3)
    assert model.jump_gradient(p).value.shape == (0, 3)


def test_numbers_are_alike_by_their_size() -> None:
    """Errors of equilibria are over the larger of 1 and the coordinate: 1e-16 of 1e6 is 1e-10."""
    states = np.array([[1e6 - 1e-10, -1e6], [-1.0, 1.0]])
    assert foremost(np.abs(states[0]), states, np.full(2, 1e-15)) == 0
    assert foremost(np.abs(states[0]), states[::-1], np.full(2, 1e-15)) == 1
    assert foremost(np.abs(states[0]), states[::-1], np.full(2, 1e-18)) == 0
