"""A mass in a double well: which well it comes to rest in changes again and again with its damping;
against SciPy on x″ = x − x³ − c x′.
"""

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from tests.oracles.user_pages import WELLS, model_of

pytestmark = pytest.mark.thorough


def well(c: float) -> float:
    """The sign of where the motion from x = 1.8 comes to rest."""

    def rates(_: float, u: Any) -> list[float]:
        return [u[1], u[0] - u[0] ** 3 - c * u[1]]

    end = solve_ivp(rates, (0.0, 60.0 / c), (1.8, 0.0), method="DOP853", rtol=1e-12, atol=1e-13)
    return float(np.sign(end.y[0, -1]))


def test_of_several_changes_of_fate_one_is_found_and_the_others_are_told() -> None:
    """Each lies in an interval at whose ends the motion comes to different wells."""
    p = model_of(WELLS, "wells").Parameters(P=0.0)
    found = ss.fate_boundary(p, "c", between={"c": (0.05, 0.175)}, start=(1.8, 0.0))
    assert [well(found.value + aside) for aside in (-1e-7, 1e-7)] == [
        np.sign(found.below.rest_x),
        np.sign(found.above.rest_x),
    ]
    assert found.state == pytest.approx([0.0, 0.0], abs=1e-9)  # between the wells
    assert found.growth == pytest.approx((np.sqrt(found.value**2 + 4) - found.value) / 2, rel=1e-9)
    assert len(found.others) == 2
    for low, high in found.others:
        assert well(low) != well(high)
        assert not low <= found.value <= high
    ends = [0.05, *sorted([found.value, *found.others.ravel()]), 0.175]
    assert ends == sorted(ends)
