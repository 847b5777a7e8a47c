"""One coordinate: no state can flutter, which no search is needed for; folds nearer to each other
than forces are to floats.
"""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

FOUR_ROOTS = '''"""A particle whose force has the roots 2, 2 + h, 2 + 2 h and 2 + 3 h."""
from spragsym.derive.model import Page

page = Page("A particle whose force has four roots.")
m = page.unit("m", "kg", "mass")
l = page.unit("l", "m", "length")
k = page.unit("k", "N/m", "stiffness")
P = page.parameter("P", "N", "load", "real", 0.0, becomes="P")
S = page.parameter("S", "1", "scale", "real", 1.0)
h = page.parameter("h", "1", "distance of the roots", "> 0", 0.001)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.force(S * k * l * (x / l - 2) * (x / l - 2 - h) * (x / l - 2 - 2 * h) * (x / l - 2 - 3 * h) + P, along=x)
'''


def test_no_state_of_one_coordinate_flutters() -> None:
    low = model_of(FOUR_ROOTS, "four_roots").Parameters()
    sides = {"P": (-1.0, 1.0), "S": (float(low.S), 1000.0), "h": (float(low.h), 0.1)}
    assert ss.certify(low, "no flutter", between=sides, max_boxes=4).outcome == "proved"


def test_without_friction_a_potential_has_no_flutter() -> None:
    p = ss.load("mode_coupling").Parameters(mu0=0.0)
    sides = {"alpha": (float(p.alpha), 2.0), "sigma": (float(p.sigma), 1.0)}
    assert ss.certify(p, "no flutter", between=sides, max_boxes=4).outcome == "proved"


@pytest.mark.thorough
@pytest.mark.parametrize("S", [1.0, 1000.0])
def test_folds_of_roots_that_are_nearly_one_are_told_and_shown(S: float) -> None:
    # With u = (x − 2)/h − 3/2 the force is S h⁴ (u² − 9/4) (u² − 1/4): extrema −1 at u² = 5/4 and
    # 9/16 at u = 0.
    found = ss.folds(
        model_of(FOUR_ROOTS, "four_roots").Parameters(S=S), "P", between={"P": (-1.0, 1.0)}
    )
    assert np.sort(found.P) == pytest.approx(S * 1e-12 * np.array([-9 / 16, 1.0, 1.0]), rel=1e-6)
    assert np.sort(found.x) == pytest.approx(
        2.0015 + 1e-3 * np.sqrt(1.25) * np.array([-1.0, 0.0, 1.0]), abs=1e-9
    )
    assert sorted(row[3:5] for row in found.as_table().rows) == [
        ("lower", "up"),
        ("lower", "up"),
        ("upper", "down"),
    ]
