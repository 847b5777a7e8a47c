"""Curves of onsets in the plane of two parameters: whole whatever the number of lines, to the ends
of what was asked.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.bifurcation.test_tails_of_laws import CHANGES
from tests.oracles.user_pages import model_of, shipped_page

#: Ziegler's column with a damper in each joint (Herrmann and Jong 1965).
ZIEGLER = '''"""A column of two links under a load that follows the upper one."""
from spragsym.derive.model import Page, cos, sin

page = Page("A column of two links under a load that follows the upper one.")
m = page.unit("m", "kg", "mass at the tip, half of that of the joint")
l = page.unit("l", "m", "length of a link")
k = page.unit("k", "N m", "stiffness of the joints")
P = page.parameter("P", "N", "load", ">= 0", 1.0, becomes="P")
c1 = page.parameter("c1", "N m s", "damper of the lower joint", ">= 0", 0.1, becomes="z1")
c2 = page.parameter("c2", "N m s", "damper of the upper joint", ">= 0", 0.1, becomes="z2")
a = page.coordinate("a", "rad", "angle of the lower link")
b = page.coordinate("b", "rad", "angle of the upper link")
page.kinetic(m * l**2 * (3 * page.rate(a) ** 2 + page.rate(b) ** 2 + 2 * page.rate(a) * page.rate(b) * cos(a - b)) / 2)
page.potential(k * (a**2 + (b - a) ** 2) / 2)
page.damper(c1, along=a)
page.damper(c2, along=b - a)
page.force(-P * sin(b), -P * cos(b), at=(l * (sin(a) + sin(b)), l * (cos(a) + cos(b))))
'''


def hurwitz(M: Any, C: Any, K: Any) -> float:
    """a₁ a₂ a₃ − a₀ a₃² − a₁² a₄ of det(λ² M + λ C + K), the coefficients from its values at five
    λ.
    """
    points = np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
    a4, a3, a2, a1, a0 = np.polyfit(
        points, [np.linalg.det(x * x * M + x * C + K) for x in points], 4
    )
    return float(a1 * a2 * a3 - a0 * a3**2 - a1**2 * a4)


@pytest.mark.by_hand("30")
@pytest.mark.thorough
@pytest.mark.parametrize("n", [30, 31])
def test_zieglers_map_reaches_both_ends_with_any_number_of_lines(n: int) -> None:
    found = ss.onset_curves(
        model_of(ZIEGLER, "ziegler").Parameters(),
        ("z2", "P"),
        n,
        between={"z2": (0.0, 0.3), "P": (0.5, 3.0)},
    )
    (curve,) = found.curves
    assert found.complete
    assert (curve.z2.min(), curve.z2.max()) == (0.0, 0.3)
    M = np.array([[3.0, 1.0], [1.0, 1.0]])
    for z2, P in zip(curve.z2, curve.P, strict=True):
        C = np.array([[0.1 + z2, -z2], [-z2, z2]])
        assert abs(hurwitz(M, C, np.array([[2 - P, P - 1], [-1.0, 1.0]]))) < 1e-12


@pytest.mark.thorough
@pytest.mark.parametrize("n", [5, 20])
def test_the_peak_at_equal_damping_is_there(n: int) -> None:
    """Hoffmann and Gaul (2003): under weak dampers the onset is that without damping where they are
    equal, else lower.
    """
    p = model_of(shipped_page("mode_coupling", *CHANGES), "hoffmann_gaul").Parameters(
        V=1.0, d=20.0, c_x=0.002
    )
    found = ss.onset_curves(p, ("c_y", "mu0"), n, between={"c_y": (0.0, 0.02), "mu0": (0.0, 1.0)})
    (curve,) = found.curves
    assert found.complete
    assert (curve.c_y.min(), curve.c_y.max()) == (0.0, 0.02)
    undamped = 0.25 + (1.55 - 1.25) ** 2 / (4 * 0.25)
    assert curve.mu0.max() == pytest.approx(undamped, abs=1e-4)
    assert curve.c_y[curve.mu0.argmax()] == pytest.approx(0.002, rel=0.05)
