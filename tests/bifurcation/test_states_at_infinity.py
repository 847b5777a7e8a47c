"""A state that runs to infinity at a value of a parameter: the value in closed form, for forces
with and without springs.
"""

import json
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.points import _AtInfinity
from spragsym.design.jumps import limit_point_passed
from spragsym.numerics import certified_roots
from tests.oracles.user_pages import derived, replaced

pytest.importorskip("sympy")

#: κ (ψ − q) + N (μ cos θ₀ − sin θ₀) = 0, N = q sin θ₀: steady sliding ends at μ = tan θ₀ + κ/(sin
#: θ₀ cos θ₀).
ROD = r'''r"""A rigid rod that leans against a moving wall."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page("A rigid rod on a pivot against a moving wall, for small turns.")
m, k_c, l = page.unit("m", "kg", "mass"), page.unit("k_c", "N/m", "contact stiffness"), page.unit("l", "m", "length of the rod")
theta0 = page.parameter("theta0", "rad", "angle of the rod to the wall's normal", "(0, pi/2)", 0.7)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.4)
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.03, becomes="kappa")
psi = page.parameter("psi", "1", "turn that presses the rod on the wall", "> 0", 0.1)
V, d = page.parameter("V", "m/s", "speed of the wall", ">= 0", 0.5), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
q = page.coordinate("q", "m", "way of the tip across the rod, towards the wall")
page.kinetic(m * page.rate(q) ** 2 / 6)
page.potential(k_t * (q / l - psi) ** 2 / 2)
page.contact(-sin(theta0) * q, lambda depth: k_c * depth)
page.friction(cos(theta0) * q, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
'''
#: K of the mass on the flank is singular at μ = (k_x (1 + k_y) + k_y (1 + k_x) t²)/(t (k_y − k_x)),
#: t = tan β.
FLANK = '''"""A mass on a flank."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page("A mass that two springs hold on an inclined flank that runs.")
m, k_c, L = page.unit("m", "kg", "mass"), page.unit("k_c", "N/m", "stiffness of the flank"), page.unit("L", "m", "a length")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
W = page.parameter("W", "N", "weight", ">= 0", 0.1)
beta = page.parameter("beta", "rad", "inclination of the flank", "(0, pi/2)", 0.7)
k_x = page.parameter("k_x", "N/m", "spring across", ">= 0", 0.01)
k_y = page.parameter("k_y", "N/m", "spring down", ">= 0", 0.03)
V, d = page.parameter("V", "m/s", "speed of the flank", ">= 0", 0.5), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x, y = page.coordinate("x", "m", "place across"), page.coordinate("y", "m", "height")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.force(-W, along=y)
page.contact(y * cos(beta) - x * sin(beta), lambda depth: k_c * depth)
page.friction(x * cos(beta) + y * sin(beta), V, lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu)
'''
#: The spring pulls back by its length l − 1 only, P pushes out: both states, l = 1/(1 − P), run to
#: infinity at P = 1.
SPUN = r'''r"""A mass on a bar that spins."""
from spragsym.derive.model import Page

page = Page("A mass on a bar that spins, on a spring to a point beside the bar.")
m, k, L = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "spring"), page.unit("L", "m", "length of the spring")
P = page.parameter("P", "N/m", "push, as of a spin, over the way", ">= 0", 0.5, becomes="P")
x = page.coordinate("x", "m", "along the bar")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, (x, 0), (0, L / 2), length=L)
page.potential(-P * x**2 / 2)
'''


@pytest.mark.thorough
def test_steady_sliding_ends_where_the_state_runs_to_infinity(run: Any) -> None:
    folder, theta0, kappa = derived(ROD, "rigid_rod"), 0.7, 0.03
    p = ss.load(folder).Parameters()
    ends = np.tan(theta0) + kappa / (np.sin(theta0) * np.cos(theta0))
    eq = ss.equilibria(p.replace(mu0=ends + np.array([-1e-3, 1e-3])))
    assert (eq.count.tolist(), eq.complete) == ([1, 0], True)
    path = ss.quasi_static_path(p, "mu0", [0.1, 0.5, 1.2])
    assert path.values.tolist() == [0.1, 0.5]
    assert _end_of(path) == pytest.approx(ends, rel=1e-14)
    told = run("path", "--model", str(folder), "--vary", "mu0=0.1:1.3:4", "--json")
    assert [row["kind"] for row in json.loads(told)["jumps"]] == ["infinity"]
    assert len(json.loads(told)["states"]) == 3
    assert "none, proved" in run("equilibria", "--model", str(folder), "--mu0", "1")
    assert limit_point_passed(p.replace(mu0=ends + np.array([-1e-3, 1e-3]))).tolist() == [
        0,
        1,
    ]  # as margins and probabilities ask


def test_along_the_speed_of_a_falling_law() -> None:
    page = replaced(
        ROD,
        ("mu0 * (1 - exp", "(psi + (mu0 - psi) * exp(-d * Abs(v) / 5)) * (1 - exp"),
        (", at_rest=mu0", ""),
    )
    p = ss.load(derived(page, "falling_rod")).Parameters(mu0=1.6)
    end = _end_of(ss.quasi_static_path(p, "V", [0.05, 0.5]))
    friction = (0.1 + 1.5 * np.exp(-2 * end)) * (1 - np.exp(-10 * end))
    assert friction == pytest.approx(np.tan(0.7) + 0.03 / (np.sin(0.7) * np.cos(0.7)), rel=1e-13)


@pytest.mark.thorough
def test_the_friction_below_which_it_does_so_at_no_angle() -> None:
    """(1 + κ) tan θ₀ + κ/tan θ₀ is least where tan² θ₀ = κ/(1 + κ)."""
    found = ss.critical_friction(
        ss.load(derived(ROD, "rigid_rod")).Parameters(), between={"mu0": (0.0, 1.0)}
    )
    assert (found.kind, found.complete) == ("infinity", True)
    assert [found.mu0, np.tan(found.theta0) ** 2] == pytest.approx(
        [2 * np.sqrt(0.03 * 1.03), 0.03 / 1.03], rel=1e-12
    )


@pytest.mark.thorough
def test_the_least_of_these_in_the_plane_of_two_coordinates(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is least inside the range; a search that ends before it is found leaves it undecided."""
    model, k_y = ss.load(derived(FLANK, "flank")), 0.03
    for k_x, top in ((0.02, 10.0), (0.005, 20.0)):
        p, window = model.Parameters(k_x=k_x), {"beta": (0.3, 0.9), "mu": (0.0, top)}
        found = ss.critical_friction(p, "mu", "beta", between=window)
        assert (found.kind, found.complete) == ("infinity", True)
        across, down = k_x * (1 + k_y), k_y * (1 + k_x)
        least = 2 * np.sqrt(across * down) / (k_y - k_x)
        assert float(found) == pytest.approx(least, rel=1e-9)
        assert np.tan(found.beta) ** 2 == pytest.approx(across / down, rel=1e-9)

    def hasty(system: Any, *given: Any, **limits: Any) -> certified_roots.Roots:
        if isinstance(system, _AtInfinity):
            limits["budget"] = 4000
        return search(system, *given, **limits)

    search = certified_roots.search
    monkeypatch.setattr(certified_roots, "search", hasty)
    found = ss.critical_friction(p, "mu", "beta", between=window)
    assert (found.kind, float(found) < least) == ("undecided", True)


@pytest.mark.thorough
def test_a_spring_that_is_stretched_without_end() -> None:
    """With a second spring κ that has no length of its own l = 1/(1 + κ − P) ends at P = 1 + κ."""
    page = replaced(
        SPUN,
        ("page.potential(-P *", "page.potential((kappa - P) *"),
        (
            "x = page.coord",
            'kappa = page.parameter("kappa", "N/m", "second spring", ">= 0", 0.5, becomes="kappa")\nx = page.coord',
        ),
    )
    model, rng = ss.load(derived(page, "spun_on_two")), np.random.default_rng(75)
    kappa = float(rng.uniform(0.1, 2.0))
    values = 1 + kappa + np.array([-0.5, -0.1, 0.1, 0.2]) * rng.uniform(0.5, 1.0)
    path = ss.quasi_static_path(model.Parameters(kappa=kappa), "P", values, start=2)
    length = 1 / (1 + kappa - values[:2])
    assert path.values.tolist() == values[:2].tolist()
    assert path.x == pytest.approx(np.sqrt(length**2 - 0.25), rel=1e-12)
    assert abs(_end_of(path) - (1 + kappa)) <= path.jumps[-1].error
    assert (path.jumps[-1].before["x"], path.jumps[-1].after) == (np.inf, {})
    onward = ss.quasi_static_path(
        model.Parameters(kappa=kappa), "P", values, start=2, after_jump=lambda eq, before: 0
    )
    assert np.abs(onward.x[2:]).max() <= 1e-15
    assert onward.jumps[0].undamped_after == ss.EquilibriumType.DIVERGENT


def _end_of(path: ss.results.Path) -> float:
    """Where a path ends as its state runs to infinity."""
    (last,) = path.jumps
    assert (last.kind, last.undamped_after) == ("infinity", None)
    return last.value
