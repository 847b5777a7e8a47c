"""Least periods of cycles beside a first coordinate that rests, against closed forms and SciPy; in
every order, ``python -m validation periods``.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from spragsym.motion.regimes import Outcome, Regime, same_limit
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytestmark = [pytest.mark.thorough, needs_a_quick_integrator]

BESIDE = '''"""A block on a belt, and beside it a mass that comes to rest."""
from spragsym.derive.model import Page

page = Page("A block on a belt, and beside it a mass that comes to rest.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
N = page.unit("N", "N", "normal force")
mu_s = page.parameter("mu_s", "1", "friction coefficient", ">= 0", 0.5)
v_s = page.parameter("v_s", "m/s", "speed of the largest friction", "> 0", 0.1)
c = page.parameter("c", "N s/m", "damper of the block", ">= 0", 0.05)
b = page.parameter("b", "N s/m", "damper of the other mass", ">= 0", 0.3)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.3)
r = page.coordinate("r", "m", "what comes to rest")
x = page.coordinate("x", "m", "block")
page.kinetic(m * (page.rate(r) ** 2 + page.rate(x) ** 2) / 2)
page.spring(k, along=r)
page.spring(k, along=x)
page.damper(b, along=r)
page.damper(c, along=x)
page.normal_force(N)
page.friction(x, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
'''

MOTOR = '''"""A belt that a motor of limited power drives, and a block on it."""
from spragsym.derive.model import Page

page = Page("A belt that a motor of limited power drives, and a block on it.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
R = page.unit("R", "m", "radius of the pulley")
c = page.parameter("c", "N s/m", "damper of the block", ">= 0", 0.3)
T = page.parameter("T", "N m", "torque of the motor at rest", ">= 0", 0.8)
b = page.parameter("b", "N m s", "slope of the torque over the speed", "> 0", 0.5)
mu_s = page.parameter("mu_s", "1", "friction coefficient", ">= 0", 0.5)
v_s = page.parameter("v_s", "m/s", "speed of the largest friction", "> 0", 0.1)
V = page.parameter("V", "m/s", "speed of the frame", ">= 0", 0.0)
x = page.coordinate("x", "m", "block")
phi = page.coordinate("phi", "rad", "rotor of the motor")
page.kinetic(m * (page.rate(x) ** 2 + (R * page.rate(phi)) ** 2) / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.force(T, along=phi)
page.damper(b, along=phi)
page.normal_force(k * R)
page.friction(x - R * phi, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
'''


def of_the_block(V: float) -> float:
    """Period of the block alone, by SciPy."""

    def rates(_: float, u: Any) -> list[float]:
        v = V - u[1]
        return [u[1], 2 * 0.5 * v * 0.1 / (v * v + 0.01) - u[0] - 0.05 * u[1]]

    def largest(_: float, u: Any) -> float:
        return float(u[1])

    event: Any = largest
    event.direction = -1
    found = solve_ivp(
        rates, (0, 150), [0.0, 0.1], method="DOP853", events=event, rtol=1e-12, atol=1e-13
    )
    return float(found.t_events[0][-1] - found.t_events[0][-2])


def _constants(model: Any) -> tuple[float, ...]:
    return tuple(model.field.constants(model.Parameters().scalars(*model.parameters)))


def test_a_block_beside_what_comes_to_rest_has_its_least_period() -> None:
    model = model_of(BESIDE, "beside")
    near = [{"r": 0.3, "x": 0.1}.get(name, 0.0) for name in model.components]
    found = ss.cycle(model.Parameters(), near=near)
    assert found.period == pytest.approx(of_the_block(0.3), rel=1e-8)
    resting = np.roots([1, 0.3, 1])
    assert sorted(abs(found.multipliers[1:]))[-2:] == pytest.approx(
        abs(np.exp(resting * found.period)), rel=1e-8
    )
    told = ss.fate(model.Parameters(), start=near)
    assert (told.kind, told.outcome.period) == ("cycle", pytest.approx(found.period, rel=1e-9))
    far = ss.fate(model.Parameters(), start=found.state)
    assert same_limit(told.outcome, far.outcome, model.field, _constants(model))


def test_a_motor_of_limited_power_turns_once_in_a_period() -> None:
    """It turns steadily, at the speed at which its torque is that of friction."""
    model = model_of(MOTOR, "motor")
    speed = brentq(lambda w: 0.8 - 0.5 * w - 0.1 * w / (w * w + 0.01), 0.5, 1.6, xtol=1e-15)
    place = 0.1 * speed / (speed**2 + 0.01)
    for start in ({"x": place, "vphi": speed}, {"x": place, "phi": 1.0, "vphi": speed}, {"x": 0.3}):
        near = [start.get(name, 0.0) for name in model.components]
        found = ss.cycle(model.Parameters(), near=near)
        assert found.period == pytest.approx(2 * math.pi / speed, rel=1e-9)
        told = ss.fate(model.Parameters(), start=near)
        assert told.outcome.period == pytest.approx(2 * math.pi / speed, rel=1e-9)
        assert told.exponents[0] == 0.0


def test_cycles_beside_what_rests_are_one_or_two_by_what_moves() -> None:
    """What stands still first has no reach, by which others are told apart."""
    names, state = ("r", "x", "vr", "vx"), (1e-17, 0.4, 0.0, 0.0)
    one = Outcome(Regime.LIMIT_CYCLE, period=7.0, cycle_mean=0.0, cycle_rms=1e-17, cycle=state)
    same = Outcome(
        Regime.LIMIT_CYCLE,
        period=7.0,
        cycle_mean=1e-17,
        cycle_rms=0.0,
        cycle=(0.0, 0.4 + 1e-12, 0.0, 0.0),
        names=names,
    )
    other = Outcome(
        Regime.LIMIT_CYCLE, period=7.0, cycle_mean=0.0, cycle_rms=0.0, cycle=(0.0, 0.41, 0.0, 0.0)
    )
    model = model_of(BESIDE, "beside")
    assert same_limit(one, same, model.field, _constants(model))
    assert not same_limit(one, other, model.field, _constants(model))
    away = Outcome(Regime.LIFT_OFF)
    assert same_limit(away, away, model.field, _constants(model)) is True
