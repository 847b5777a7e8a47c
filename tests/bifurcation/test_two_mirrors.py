"""Models with two mirrors: pitchforks of Augusti's column, P = 1 and P = κ, and cusps of von Mises'
truss.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of, replaced
from tests.statics.test_slots import TRUSS

pytest.importorskip("sympy")

#: U = a²/2 + κ b²/2 + P cos a cos b: with b = 0 states a = P sin a.
COLUMN = r'''r"""Augusti's column: rigid, on two springs that turn."""
from spragsym.derive.model import Page, cos

page = Page("A rigid column on two springs that turn.")
m, l, k = page.unit("m", "kg", "mass"), page.unit("l", "m", "length"), page.unit("k1", "N m", "first spring")
P = page.parameter("P", "N", "load", ">= 0", 0.5, becomes="P")
k2 = page.parameter("k2", "N m", "second spring", "> 0", 2.0, becomes="kappa")
a, b = page.coordinate("a", "rad", "first tilt"), page.coordinate("b", "rad", "second tilt")
page.kinetic(m * l**2 * (page.rate(a) ** 2 + page.rate(b) ** 2) / 2)
page.potential(k * a**2 / 2 + k2 * b**2 / 2 + P * l * cos(a) * cos(b))
'''
#: A second load, across the first one.
LOADED = replaced(
    TRUSS,
    (
        '">= 0", 0.01, becomes="P")',
        '"real", 0.01, becomes="P")\nQ = page.parameter("Q", "N", "load", "real", 0.0, '
        'becomes="Q")',
    ),
    ("page.force(0, -P", "page.force(Q, -P"),
)
#: A spring below the tip.
HELD = replaced(
    TRUSS,
    ("page.spring(k_x, along=x)\n", "page.spring(k_x, along=x)\npage.spring(k_y, along=y)\n"),
    (
        '">= 0", 0.01, becomes="P")',
        '"real", 0.01, becomes="P")\nk_y = page.parameter("k_y", "N/m", "", "> 0", becomes="beta")',
    ),
)


@pytest.mark.thorough
def test_all_cusps_of_a_plane_that_pitchforks_cross() -> None:
    """One, at x = y = 0, where k_y holds the bars: beta = 2 (L - 1). Its equations hold along
    curves of pitchforks as well.

    These are where bars of length b, b**3 - 3 b**2 + 3 = 0, stand in balance with P on x = 0.
    """
    bar = np.roots([1.0, -3.0, 0.0, 3.0])[1]
    assert abs((2 * (3 / bar - 1) - 3.2) * np.sqrt(bar**2 - 1)) < 1.0
    p = model_of(HELD, "held").Parameters(alpha=0.0, h=8**0.5)
    found = ss.cusps(p, ("P", "beta"), between={"P": (-1.0, 1.0), "beta": (3.0, 5.0)})
    assert found.complete
    np.testing.assert_allclose(
        [found.P, found.beta, found.x, found.y], [[0.0], [4.0], [0.0], [0.0]], atol=1e-12
    )
    (digits,) = ss.precise.cusps(
        p, vary=("P", "beta"), between={"P": (-0.1, 0.1), "beta": (3.9, 4.1)}, dps=30
    )
    angles = sorted(float(digits.numbers[f"theta_{i}"]) for i in (1, 2))
    assert angles == pytest.approx([0.0, np.pi], abs=1e-15)  # the bars lie in one line


@pytest.mark.thorough
def test_all_cusps_of_a_truss_under_two_loads() -> None:
    """Four where the bars are perpendicular and one has half its length L = √5/2; two on y = 0,
    where x² = 1 + L |x|.
    """
    model, L, plane = (
        model_of(LOADED, "loaded"),
        np.sqrt(1.25),
        {"P": (-2.0, 2.0), "Q": (-2.0, 2.0)},
    )
    found = ss.cusps(model.Parameters(alpha=0.0), ("P", "Q"), between=plane)
    near, far = 1 - L**2 / 8, (L + np.sqrt(L**2 + 4)) / 2
    assert found.complete
    np.testing.assert_allclose(np.sort(found.x), [-far, -near, -near, near, near, far], atol=1e-12)
    np.testing.assert_allclose(
        np.abs(found.y),
        np.where(np.abs(found.x) < 1, np.sqrt(L**2 / 4 - (1 - near) ** 2), 0),
        atol=1e-12,
    )
    assert np.hypot(found.P, found.Q)[np.abs(found.x) > 1] == pytest.approx(
        2 * (far - L), abs=1e-12
    )
    digits = ss.precise.cusps(
        model.Parameters(alpha=0.0), vary=("P", "Q"), between=plane | {"Q": (-2.0, -0.1)}, dps=30
    )
    assert (len(digits), digits.complete) == (3, True)


@pytest.mark.thorough
@pytest.mark.parametrize("kappa", [2.0, 0.5])
def test_all_loads_of_a_column_on_two_springs(kappa: float) -> None:
    """With κ < 1 two states a ≠ 0 become stable in b where P cos a = κ, beside P = 1 and P = κ."""
    p = model_of(COLUMN, "column").Parameters(kappa=kappa)
    found = ss.folds(p, "P", between={"P": (0.1, 2.4)})
    later = (
        brentq(lambda angle: np.cos(angle) * angle - kappa * np.sin(angle), 0.5, 3.0)
        if kappa < 1
        else 0.0
    )
    tilts = [0.0, 0.0, *([-later, later] if kappa < 1 else [])]
    assert (found.complete, set(found.kind)) == (True, {"pitchfork"})
    np.testing.assert_allclose(
        found.P, sorted([1.0, kappa]) + [angle / np.sin(angle) for angle in tilts[2:]], atol=1e-12
    )
    np.testing.assert_allclose([found.a, found.b], [tilts, np.zeros(len(tilts))], atol=1e-12)


@pytest.mark.thorough
def test_the_lowest_load_of_a_truss_that_keeps_its_mirror() -> None:
    """P = 2 (L^(2/3) − 1)^(3/2) at x = 0, on the whole curve of folds, with L² = 1 + h²: it rises
    with h. The first row of the adjugate of K is 0 there.
    """
    p, plane = model_of(TRUSS, "truss").Parameters(), {"P": (0.0, 1.0), "h": (0.3, 0.6)}
    found = ss.critical_friction(p, "P", "h", between=plane)
    assert (found.complete, found.where) == (True, 0.3)
    assert float(found) == pytest.approx(2 * (1.09 ** (1 / 3) - 1) ** 1.5, rel=1e-13)
