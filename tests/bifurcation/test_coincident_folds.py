"""Folds at one value of the parameter, by a mirror or by chance: which state ends at which, and
where it jumps to.
"""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

#: States x = 0 and p = (u − 1)(u − 2)(u − 3), u = x²: folds at p = ∓ 2/√27, u = 2 ± 1/√3, each with
#: its mirror image.
TWINS = r'''r"""A mass in a potential of eighth degree."""
from spragsym.derive.model import Page

page = Page("A mass in a potential of eighth degree.")
m, k, L = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("L", "m", "length")
p = page.parameter("p", "1", "load", "real", 0.3)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
u = (x / L) ** 2
page.force(k * x * (p - (u - 1) * (u - 2) * (u - 3)), along=x)
'''
#: 2 sin a = T and sin b = 0: at T = 2 states with b = 0, stable below, and with b = π end, which
#: nothing mirrors.
PENDULUM = r'''r"""A double pendulum under a torque."""
from spragsym.derive.model import Page, cos

page = Page("A double pendulum under a torque on its upper rod.")
m, l, g = page.unit("m", "kg", "mass"), page.unit("l", "m", "length"), page.unit("W", "N", "weight")
T = page.parameter("T", "N m", "torque", ">= 0", 1.0, becomes="T")
a, b = page.coordinate("a", "rad", "upper rod"), page.coordinate("b", "rad", "lower rod")
page.kinetic(m * l**2 * (page.rate(a) ** 2 + page.rate(b) ** 2) / 2)
page.potential(-g * l * (2 * cos(a) + cos(b)))
page.force(T, along=a)
'''


@pytest.fixture(scope="module")
def twins() -> Any:
    return model_of(TWINS, "twins")


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("side", "values"), [(1, [0.3, 0.0, -0.5]), (-1, [0.3, "fold", -0.5])], ids=["beside", "on"]
)
def test_a_path_ends_at_the_fold_of_its_own_branch(side: int, values: Any, twins: Any) -> None:
    p = twins.Parameters()
    found = ss.folds(p, "p", between={"p": (-1, 1)})
    along = [found.p[0] if value == "fold" else value for value in values]
    path = ss.quasi_static_path(p, "p", along, start=6 if side > 0 else 0)
    (jump,) = path.jumps
    inner = np.sqrt(
        [
            brentq(lambda u, at=at: (u - 1) * (u - 2) * (u - 3) - at, 0.5, 1)
            for at in (-0.5, -2 / np.sqrt(27))
        ]
    )
    assert jump.before["x"] == pytest.approx(side * np.sqrt(2 + 1 / np.sqrt(3)), abs=1e-9)
    np.testing.assert_allclose([path.x[-1], jump.after["x"]], side * inner, atol=1e-9)


@pytest.mark.parametrize(
    ("page", "vary", "between", "ends", "when", "after"),
    [
        (
            TWINS,
            "p",
            (-1, 1),
            ["lower", "upper", "upper", "lower"],
            ["down", "down", "up", "up"],
            [-0.9194, 0.9194, -1.7761, 1.7761],
        ),
        (PENDULUM, "T", (1, 3), ["lower", ""], ["up", "up"], [np.nan, np.nan]),
    ],
    ids=["mirror", "chance"],
)
def test_what_ends_at_folds_that_coincide(
    page: str, vary: str, between: Any, ends: Any, when: Any, after: Any
) -> None:
    p = model_of(page, f"coincident_{vary}").Parameters()
    found = ss.folds(p, vary, between={vary: between})
    assert (found.ends.tolist(), found.when.tolist()) == (ends, when)
    assert "_after" not in str(found)  # a search at each fold, which printing does not start
    np.testing.assert_allclose(next(iter(found.after.values())), after, atol=1e-4)
    assert "_after" in str(found)
