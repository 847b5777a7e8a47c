"""Linear forces whose stiffness matrix is singular: a line of equilibria is no "complete, none"."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

sp = pytest.importorskip("sympy")

HEAD = '''"""A page of the tests, without a drawing."""
from spragsym.derive.model import Page
page = Page("Two masses on springs.")
m = page.unit("m", "kg", "mass")
k_0 = page.unit("k_0", "N/m", "unit of stiffness")
L_0 = page.unit("L_0", "m", "unit of length")
F = page.parameter("F", "N", "load on the first", "real", 0.0, becomes="kappa")
G = page.parameter("G", "N", "load on the second", "real", 0.0, becomes="lambda_")
x = page.coordinate("x", "m", "first mass")
y = page.coordinate("y", "m", "second mass")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.force(F, along=x)
page.force(G, along=y)
'''
#: Stiffness that is larger than 0, that may be 0, that cancels another one, and of either sign.
TIED = (
    HEAD
    + """
k = page.parameter("k", "N/m", "stiffness between", "> 0", 0.5, becomes="sigma")
a = page.parameter("a", "N/m", "stiffness of the first", "real", 0.0, becomes="alpha")
b = page.parameter("b", "N/m", "stiffness of the second", ">= 0", 0.0, becomes="beta")
c = page.parameter("c", "N/m", "what cancels it", ">= 0", 0.0, becomes="gamma")
page.spring(k, along=x - y)
page.potential(a * x**2 / 2)
page.potential((b - c) * y**2 / 2)
"""
)
#: A coordinate that nothing holds, and both held by the same stiffness.
FREE = (
    HEAD
    + """
k = page.parameter("k", "N/m", "stiffness of the first", "> 0", 0.5, becomes="sigma")
page.spring(k, along=x)
"""
)
ALIKE = (
    HEAD
    + """
k = page.parameter("k", "N/m", "stiffness of both", ">= 0", 0.5, becomes="sigma")
page.spring(k, along=x)
page.spring(k, along=y)
"""
)
#: Pages, their stiffness by hand, and values to draw from.
PAGES: dict[str, tuple[str, Any, dict[str, tuple[float, ...]]]] = {
    "tied": (
        TIED,
        lambda p: [
            [p["sigma"] + p["alpha"], -p["sigma"]],
            [-p["sigma"], p["sigma"] + p["beta"] - p["gamma"]],
        ],
        {"sigma": (0, 0.25, 1), "alpha": (-0.5, 0, 0.5), "beta": (0, 0.25), "gamma": (0, 0.25)},
    ),
    "free": (FREE, lambda p: [[p["sigma"], 0], [0, 0]], {"sigma": (0, 0.25, 1)}),
    "alike": (ALIKE, lambda p: [[p["sigma"], 0], [0, p["sigma"]]], {"sigma": (0, 0.25, 1)}),
}
LOADS = {"kappa": (-0.25, 0, 0.25), "lambda_": (0, 0.25)}


OPEN = {"tied": {"sigma"}, "free": {"sigma"}, "alike": set[str]()}


def has_a_line(
    stiffness: Any, p: dict[str, float], vary: str, low: float, high: float, open_: set[str]
) -> bool:
    """A value in the range, if it may be taken, at which K is singular and F in its image: exactly,
    by their ranks.
    """
    at = sp.Symbol("v", real=True)
    exact = {name: sp.Rational(value) for name, value in p.items()} | {vary: at}
    K, F = sp.Matrix(stiffness(exact)), sp.Matrix([exact["kappa"], exact["lambda_"]])
    whole = K.row_join(F)
    minors = [sp.expand(whole[:, pair].det()) for pair in ([0, 1], [0, 2], [1, 2])]
    places = {sp.Rational(value) for value in (low, (low + high) / 2, high)}
    places |= {place for minor in minors if minor.has(at) for place in sp.roots(minor, at)}
    return any(
        low <= place <= high
        and not (vary in open_ and place == 0)
        and K.subs(at, place).rank() == whole.subs(at, place).rank() < 2
        for place in places
    )


@pytest.mark.thorough
@pytest.mark.parametrize("name", PAGES)
def test_a_line_of_states_is_undecided(name: str) -> None:
    """Over ranges that hold, end at or miss the values at which there is one."""
    text, stiffness, values = PAGES[name]
    model, rng, told = model_of(text, name), np.random.default_rng(3), []
    for _ in range(20 if name == "tied" else 8):
        own = values | LOADS
        vary = str(rng.choice(list(own)))
        low, high = sorted(rng.choice(own[vary], 2, replace=False).tolist())
        p = {
            key: float(rng.choice([one for one in numbers if one or key not in OPEN[name]]))
            for key, numbers in own.items()
        }
        found = ss.folds(model.Parameters(**p), vary, between={vary: (low, high)})
        line = has_a_line(stiffness, p, vary, low, high, OPEN[name])
        assert len(found) == 0
        assert found.complete != line, (p, vary, low, high)
        assert line == any("form lines" in text for text in found.remarks)
        told.append(line)
    assert 0 < sum(told) < len(told)


@pytest.mark.thorough
def test_an_excluded_end_is_told_from_what_is_beside_it() -> None:
    """det K = k₁ k of the tied masses, 0 at the excluded k = 0 alone, in the plane too."""
    p = model_of(TIED, "tied").Parameters(alpha=1.0, beta=0.0, gamma=0.0)
    assert ss.folds(p, "sigma").decided
    for low, decided in ((0.5, True), (0.0, False)):
        found = ss.cusps(p, ("sigma", "alpha"), between={"alpha": (low, 1.0)})
        assert (len(found), found.decided) == (0, decided)
