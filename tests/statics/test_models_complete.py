"""What ``complete`` says: that these are all there are. Whatever was searched is said where that is
not everything, and why.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ParameterError, ParameterTypeError
from tests.oracles import gap_pages
from tests.oracles.user_pages import model_of
from tests.support import few

#: Two springs without length that couple both directions, on a belt that hardens.
COUPLED = (
    gap_pages.HEAD
    + """
F_L = page.parameter("F_L", "N", "preload", ">= 0", 0.5, becomes="kappa")
a = page.parameter("a", "N/m", "stiffness along", "> 0", 1.0)
b = page.parameter("b", "N/m", "coupling", "real", -0.5)
c = page.parameter("c", "N/m", "stiffness across", "> 0", 0.8)
g = page.parameter("g", "N/m^3", "hardening", ">= 0", 0.5)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.potential(a * x**2 / 2 + b * x * y + c * y**2 / 2)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth + g * depth**3)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
"""
)


@pytest.fixture(scope="module")
def coupled() -> Any:
    pytest.importorskip("sympy")
    return model_of(COUPLED, "coupled")


def by_hand(p: Any, mu: float) -> np.ndarray:
    """Depths δ = −y of all states in contact: a x + b y = μ N and b x + c y + κ = N with N = δ + g
    δ³.
    """
    a, b, c, g, kappa = (p[name] for name in ("a", "b", "c", "g", "kappa"))
    # x = (μ N + b δ)/a: b μ N/a + b² δ/a − c δ + κ − N = 0.
    factor = b * mu / a - 1
    roots = np.roots([factor * g, 0.0, factor + b * b / a - c, kappa])
    return np.sort(roots.real[(np.abs(roots.imag) < 1e-9) & (roots.real >= 0)])


@pytest.mark.parametrize("mu", few([0.5, 1.9, 2.05, 3.0, 10.0, 20.0], 1.9, 10.0))
def test_states_far_away_are_found_or_not_complete(coupled: Any, mu: float) -> None:
    for b in (-0.5, 0.5, 0.05):
        p = coupled.Parameters(mu0=mu, b=b)
        eq = ss.equilibria(p)
        want = by_hand({**coupled.base, "b": b}, mu)
        assert not eq.complete or int(eq.count) == want.size
        assert eq.complete or eq.remarks
        for depth in -eq.y[: int(eq.count)]:
            assert np.abs(want - depth).min() < 1e-9


def test_a_box_by_hand_holds_what_it_holds(coupled: Any) -> None:
    """Beyond it nothing is said to be none."""
    model = ss.load("kang_nam").search
    p = model.Parameters(theta0=np.radians(30.0))
    every = ss.equilibria(p)
    some = ss.equilibria(p, within={"x": (0.0, 0.5)})
    assert every.complete
    assert not some.complete
    assert int(some.count) == ((every.x >= 0) & (every.x <= 0.5)).sum() > 0
    assert any("searched within x in [0, 0.5]" in text for text in some.remarks)
    assert ss.equilibria(p, within={"x": (-50.0, 50.0), "y": (-50.0, 1.0)}).complete
    assert str(some).count("searched within") == 1


@pytest.mark.parametrize(
    ("within", "error"),
    [
        ({"z": (0, 1)}, ParameterError),
        ({"x": (1, 0)}, ParameterError),
        ("x", ParameterTypeError),
        ({"y": (1, 2)}, ParameterError),
    ],
)
def test_a_box_that_makes_no_sense(within: Any, error: type[Exception]) -> None:
    model = ss.load("kang_nam").search
    with pytest.raises(error, match="within"):
        ss.equilibria(model.Parameters(theta0=1.0), within=within)


@pytest.mark.by_hand("trolley", "stribeck", "hertz_contact")
@pytest.mark.parametrize(
    "name",
    few(
        [
            "kang_nam",
            "stribeck",
            "hertz_contact",
            "trolley",
            "mode_coupling",
            "stick_slip",
            "damped",
        ],
        "stick_slip",
    ),
)
def test_nothing_is_incomplete_without_a_reason(name: str) -> None:
    model = ss.load(name).search
    p = model.Parameters(**({"theta0": 1.1} if "theta0" in model.parameters else {}))
    for vary in model.parameters:
        for search in (ss.folds, ss.flutter_onsets):
            found = search(p, vary)
            assert found.complete or found.remarks
