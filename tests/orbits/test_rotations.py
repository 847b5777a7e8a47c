"""Cycles that turn around: a driven pendulum, against Liouville's theorem and the homoclinic orbit by shooting with SciPy."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

PENDULUM = '''"""A driven pendulum."""
from spragsym.derive.model import Page, cos

page = Page("A driven pendulum.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
c = page.parameter("c", "N m s", "damper", ">= 0", 0.3)
T = page.parameter("T", "N m", "torque", "real", 0.8)
phi = page.coordinate("phi", "rad", "angle")
page.kinetic(m * l**2 * page.rate(phi) ** 2 / 2)
page.potential(k * l**2 * (1 - cos(phi)))
page.damper(c, along=phi)
page.force(T, along=phi)
'''
SADDLE = math.pi - math.asin(0.8)


def missed(c: float) -> float:
    """By how much the motion that leaves the saddle misses it after a turn: by speed beyond it, by angle before it."""
    growth = (-c + math.sqrt(c * c - 4 * math.cos(SADDLE))) / 2

    def turned(_: float, state: np.ndarray) -> float:
        return float(state[0] - SADDLE - 2 * math.pi)

    def stopped(_: float, state: np.ndarray) -> float:
        return float(state[1])

    turned.terminal = stopped.terminal = True  # type: ignore[attr-defined]
    start = [SADDLE + 1e-6, growth * 1e-6]
    course = solve_ivp(
        lambda _, s: [s[1], 0.8 - c * s[1] - math.sin(s[0])], (0, 200), start, events=[turned, stopped], rtol=1e-10, atol=1e-12
    )
    return float(course.y[1, -1] if course.t_events[0].size else course.y[0, -1] - SADDLE - 2 * math.pi)


@pytest.mark.thorough
@needs_a_quick_integrator
def test_a_rotation_is_found_and_followed_to_its_homoclinic_orbit() -> None:
    p = model_of(PENDULUM, "driven_pendulum").Parameters()
    found = ss.cycle(p, near=(0.0, 3.0))
    assert found.stable
    assert found.multipliers[1] == pytest.approx(math.exp(-0.3 * found.period), rel=1e-9)
    assert found.trajectory().phi[-1] - found.state[0] == pytest.approx(2 * math.pi, abs=1e-9)
    branch = ss.cycle_branch(found, "c", (0.29, 0.8))
    (end,) = (event for event in branch.events if event.kind == "homoclinic")
    assert end.value == pytest.approx(brentq(missed, 0.6, 0.8, xtol=1e-8), abs=2e-4)
    assert branch.stable.all()
