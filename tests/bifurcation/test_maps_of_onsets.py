"""Curves of onsets in the plane of two parameters: whole whatever the number of lines, to the ends
of what was asked.
"""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.bifurcation.test_tails_of_laws import CHANGES
from tests.oracles.user_pages import model_of, replaced, shipped_page

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


#: Two modes of a string, of which friction that falls drives each alone or both.
BOW = '''"""A string of two modes under a bow."""
from spragsym.derive.model import Page

page = Page("A string of two modes under a bow.")
m = page.unit("m", "kg", "modal mass")
k = page.unit("k", "N/m", "stiffness of the first mode")
N = page.unit("N", "N", "force of the bow")
s = page.parameter("s", "1", "the first mode at the bow", ">= 0", 0.6)
V = page.parameter("V", "m/s", "speed of the bow", ">= 0", 0.3)
a = page.coordinate("a", "m", "first mode")
b = page.coordinate("b", "m", "second mode")
page.kinetic(m * (page.rate(a) ** 2 + page.rate(b) ** 2) / 2)
page.spring(k, along=a)
page.spring(4.3 * k, along=b)
page.damper(0.1 * (k * m) ** 0.5, along=a)
page.damper(0.2 * (k * m) ** 0.5, along=b)
page.normal_force(N)
w = N / (k * m) ** 0.5 / 10
page.friction(s * a + 0.9 * b, V, lambda v: v * w / (w**2 + v**2))
'''


def _first_mode(s: float) -> tuple[float, float, float]:
    """The speed of the first mode's lower onset, its ω and l₁, by SciPy and Kuznetsov's formula."""
    shape, damping = np.array([s, 0.9]), np.diag([0.1, 0.2])

    def matrix(V: float) -> Any:
        slope = 0.1 * (0.01 - V**2) / (0.01 + V**2) ** 2
        rows = [-np.diag([1.0, 4.3]), -damping - slope * np.outer(shape, shape)]
        return np.block([[np.zeros((2, 2)), np.eye(2)], rows])

    def pair(A: Any) -> int:
        values = np.linalg.eigvals(A)
        return int(np.argmin(np.abs(values - 1j)))

    V = brentq(lambda V: np.linalg.eigvals(A := matrix(V))[pair(A)].real, 0.1, 0.12, xtol=1e-15)
    A, z = matrix(V), 10 * V  # the law is z/(1 + z²)
    second = 100 * 2 * z * (z**2 - 3) / (1 + z**2) ** 3
    third = -1000 * 6 * (z**4 - 6 * z**2 + 1) / (1 + z**2) ** 4
    values, vectors = np.linalg.eig(A)
    q = vectors[:, pair(A)]
    values_left, left = np.linalg.eig(A.T)
    p = left[:, np.argmin(np.abs(values_left + 1j))]
    p, omega = p / np.conj(p.conj() @ q), values[pair(A)].imag
    push, bar = np.array([0.0, 0.0, *shape]), q.conj()

    def B(u: Any, v: Any) -> Any:
        return push * second * (shape @ u[2:]) * (shape @ v[2:])

    slow, fast = np.linalg.solve(A, B(q, bar)), 2j * omega * np.eye(4) - A
    cubic = -push * third * (shape @ q[2:]) ** 2 * (shape @ bar[2:])
    l1 = p.conj() @ (cubic - 2 * B(q, slow) + B(bar, np.linalg.solve(fast, B(q, q))))
    return V, omega, l1.real / (2 * omega)


@pytest.mark.thorough
def test_curves_that_cross_at_a_double_hopf_point_keep_their_frequencies() -> None:
    """Both lie within a thousandth of the speed there; l₁ changes its sign along the first alone."""
    p = model_of(BOW, "bow").Parameters()
    found = ss.onset_curves(p, ("s", "V"), 6, between={"s": (0.5, 0.75), "V": (0.05, 0.4)})
    assert found.complete
    assert found.points.kind.tolist() == ["HH"]
    first, second = sorted(found.curves, key=lambda curve: curve.omega.max())
    assert first.omega.max() < 1.1 < 2.0 < second.omega.min()
    for s, V, omega, l1 in zip(first.s, first.V, first.omega, first.lyapunov, strict=True):
        assert (V, omega, l1) == pytest.approx(_first_mode(s), rel=1e-7)
    assert found.changes["s"] == pytest.approx(
        [brentq(lambda s: _first_mode(s)[2], 0.6, 0.7)], abs=1e-8
    )


@pytest.mark.thorough
def test_an_onset_that_floats_see_where_all_damping_ends_says_that_it_is_not_proved() -> None:
    """Where the law is steepest no more, at N/(10 √(k m)), the bow damps neither mode."""
    text = replaced(
        BOW, ("page.damper(0.1", "page.damper(0.0"), ("page.damper(0.2", "page.damper(0.0")
    )
    p = model_of(text, "bow_alone").Parameters()
    found = ss.flutter_onsets(p, "V", between={"V": (0.01, 1.0)})
    assert found.V == pytest.approx([0.1, 0.1], abs=1e-5)
    assert not found.complete
    assert all("floats see it" in why for why in found.why)
