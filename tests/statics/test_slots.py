"""The order of states whose first coordinates are equal: the next ones decide, and not rounding."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

#: Where the side spring is stiff enough all states stand on x = 0.
TRUSS = r'''r"""A truss of two springs under a load at its tip, held from the side."""
from spragsym.derive.model import Page, sqrt

page = Page("A truss of two springs under a load at its tip.")
m, k, b = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "springs"), page.unit("b", "m", "half of the width")
P = page.parameter("P", "N", "load", ">= 0", 0.01, becomes="P")
H = page.parameter("H", "m", "height", "> 0", 0.5, becomes="h")
k_x = page.parameter("k_x", "N/m", "side spring", ">= 0", 3.0, becomes="alpha")
x, y = page.coordinate("x", "m", "sideways"), page.coordinate("y", "m", "height of the tip over the supports")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
for side in (-1, 1):
    page.spring(k, (x, y), (side * b, 0), length=sqrt(b**2 + H**2))
page.spring(k_x, along=x)
page.force(0, -P, at=(x, y))
'''


@pytest.mark.thorough
def test_slots_are_the_same_alone_within_an_array_and_for_motions() -> None:
    model = model_of(TRUSS, "truss")
    p = model.Parameters(h=np.linspace(0.45, 1.0, 12))
    eq = ss.equilibria(p)
    assert (eq.count == 3).all()
    assert (np.diff(eq.y) > 0.1).all()  # x = 0 in all of them, to rounding
    for row in range(12):
        np.testing.assert_allclose(
            ss.equilibria(p.replace(h=float(p.h[row]))).y, eq.y[row], atol=1e-12
        )
    for slot in (0, 2):
        assert (
            ss.rms_sweep(p, x0=0.0, y0=eq.y[:, slot], t_end=20.0).equilibrium.tolist()
            == [slot] * 12
        )
