"""Cycles that turn around, and what parts them from rest: a driven pendulum, against Liouville's
theorem and SciPy.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from spragsym.motion.regimes import Outcome
from spragsym.orbits import basin_boundaries
from spragsym.orbits.system import FateVerdict
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytestmark = [pytest.mark.thorough, needs_a_quick_integrator]

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
#: The damping at which the motion from one saddle comes to the next: where the manifolds of both,
#: begun by their Taylor polynomials of third degree, meet halfway.
HOMOCLINIC = 0.7197826470116


def motion(c: float, start: Any, t_end: float, event: Any = None) -> Any:
    """The motion from a state, by SciPy."""
    return solve_ivp(
        lambda _, s: [s[1], 0.8 - c * s[1] - math.sin(s[0])],
        (0, t_end),
        start,
        events=event,
        rtol=1e-10,
        atol=1e-12,
    )


def growing(c: float) -> float:
    """The eigenvalue of the saddle that is positive."""
    return (-c + math.sqrt(c * c - 4 * math.cos(SADDLE))) / 2


def missed(c: float, *start: float) -> float:
    """By how much a motion with positive speed misses the saddle: by speed beyond it, by angle
    before it.
    """

    def met(_: float, state: np.ndarray) -> float:
        return float(min(SADDLE - state[0], state[1]))

    event: Any = met
    event.terminal, event.direction = True, -1
    angle, speed = motion(c, start, 200.0, event).y[:, -1]
    return float(angle - SADDLE + speed)


def test_a_rotation_is_found_and_followed_to_its_homoclinic_orbit() -> None:
    p = model_of(PENDULUM, "driven_pendulum").Parameters()
    found = ss.cycle(p, near=(0.0, 3.0))
    assert found.stable
    assert found.multipliers[1] == pytest.approx(math.exp(-0.3 * found.period), rel=1e-9)
    assert found.trajectory().phi[-1] - found.state[0] == pytest.approx(2 * math.pi, abs=1e-9)
    branch = ss.cycle_branch(found, "c", between={"c": (0.29, 0.8)})
    (end,) = (event for event in branch.events if event.kind == "homoclinic")
    leaving = brentq(
        lambda c: missed(c, SADDLE - 2 * math.pi + 1e-6, growing(c) * 1e-6), 0.6, 0.8, xtol=1e-8
    )
    assert end.value == pytest.approx(leaving, abs=2e-4)
    assert abs(end.value - HOMOCLINIC) < end.error < 1e-5
    assert branch.stable.all()


def test_fates_change_where_a_motion_ends_at_the_saddle() -> None:
    p = model_of(PENDULUM, "driven_pendulum").Parameters()
    found = ss.fate_boundary(p, "c", between={"c": (0.1532, 0.1534)})
    assert found.value == pytest.approx(
        brentq(lambda c: missed(c, 0.0, 0.0), 0.15, 0.16, xtol=1e-11), abs=1e-8
    )
    assert (found.below.limit, found.above.limit) == (ss.Regime.LIMIT_CYCLE, ss.Regime.EQUILIBRIUM)
    assert [*found.state, found.growth] == pytest.approx(
        [SADDLE, 0.0, growing(found.value)], abs=1e-9
    )


def test_a_boundary_of_basins_ends_at_the_saddle_and_parts_rest_from_rotation(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    p = model_of(PENDULUM, "driven_pendulum").Parameters()
    found = ss.basin_boundary(p, step=0.2, points=2)
    assert found.boundary.tolist() == [True] * 5
    for point, sides in zip(found.points, found.sides, strict=True):
        assert motion(0.3, point, 15.0).y[:, -1] == pytest.approx([SADDLE, 0.0], abs=1e-5)
        ends = [
            motion(0.3, point + aside, 60.0).y[0, -1] for aside in (-1e-6, 1e-6)
        ]  # across the curve, which falls
        assert (
            [end > 2 * math.pi for end in ends]
            == ["cycle" in side for side in sides]
            == [False, True]
        )
    monkeypatch.setattr(
        basin_boundaries, "judged", lambda system, start: FateVerdict(Outcome(), start, 1.0)
    )
    undecided = ss.basin_boundary(p, step=0.2, points=1)
    assert not undecided.boundary.any()
    assert set(undecided.sides.flat) == {"nothing that is decided by t = 1"}
    # Half of the time is for the curve, the rest for what is on both sides of it.
    clock = [0.0]

    def later(seconds: float) -> float:
        clock[0] += seconds
        return clock[0]

    def slow(_: Any, start: Any) -> FateVerdict:
        return FateVerdict(Outcome(), start, later(1.0))

    monkeypatch.setattr(basin_boundaries, "judged", slow)
    monkeypatch.setattr(basin_boundaries.time, "thread_time", lambda: later(0.2))
    late = ss.basin_boundary(p, step=0.2, points=40, options=ss.MotionOptions(seconds=40.0))
    assert late.how == ("the range ends", "half of the 40 s of processor time were over")
    assert not late.boundary.any()
    left = late.sides == "not followed: 40 s of processor time were over"
    assert 0 < left[:, 0].sum() < len(left)
