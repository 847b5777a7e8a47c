"""Linear forces of which det K vanishes: a whole line of equilibria is no "complete, none"."""

from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

PAGE = '''"""A page of the tests, without a drawing."""
from spragsym.derive.model import Page
page = Page("Two masses, tied to each other and one to the ground.")
m = page.unit("m", "kg", "mass")
k_0 = page.unit("k_0", "N/m", "unit of stiffness")
L_0 = page.unit("L_0", "m", "unit of length")
k = page.parameter("k", "N/m", "stiffness between", ">= 0", 0.5, becomes="sigma")
b = page.parameter("b", "N/m", "stiffness to ground", "real", 0.0, becomes="beta")
F = page.parameter("F", "N", "load", "real", 0.0, becomes="kappa")
x = page.coordinate("x", "m", "first mass")
y = page.coordinate("y", "m", "second mass")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x - y)
page.potential(b * x**2 / 2)
page.force(F, along=x)
'''


def has_a_line(sigma: Fraction, beta: Fraction, kappa: Fraction) -> bool:
    """σ (x − y) + β x = κ and σ (y − x) = 0: by hand."""
    if sigma == 0:
        return beta != 0 or kappa == 0
    return beta == 0 and kappa == 0


@pytest.mark.thorough
def test_a_line_of_states_is_undecided() -> None:
    """Over ranges that hold, end at or miss the values at which there is one."""
    model, rng = model_of(PAGE, "tied"), np.random.default_rng(3)
    own = {"sigma": (0, 0.25, 1), "beta": (-0.5, 0, 0.5), "kappa": (-0.25, 0, 0.25)}
    lines = 0
    for _ in range(12):
        vary = str(rng.choice(list(own)))
        p = {name: float(rng.choice(values)) for name, values in own.items()}
        low, high = sorted(rng.choice(own[vary], 2, replace=False).tolist())
        found = ss.folds(model.Parameters(**p), vary, between={vary: (low, high)})
        line = any(
            has_a_line(*(Fraction(value) for value in (p | {vary: at}).values()))
            for at in (low, 0.0, high, (low + high) / 2)
            if low <= at <= high
        )
        assert len(found) == 0
        assert found.complete != line, (p, vary, low, high)
        assert line == any("form lines" in text for text in found.remarks)
        lines += line
    assert 2 < lines < 10
