"""Motion against exact solutions, and in units in which it is small: no verdict depends on what a
page measures lengths in.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion.sweeps import Regime
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

HEAD = """'One mass.'

from spragsym.derive.model import Page

page = Page("One mass.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
"""

#: Stick-slip, with a length of its own: multiples of all lengths and speeds are the same motion.
SCALED = f"""{HEAD}L = page.unit("L", "m", "a length")
N_0 = page.parameter("N_0", "N", "normal force", "> 0", 1.0, becomes="nu")
mu_s = page.parameter("mu_s", "1", "largest friction coefficient", ">= 0", 0.5)
v_s = page.parameter("v_s", "m/s", "sliding speed at which friction is largest", "> 0", 0.1)
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.05, becomes="zeta")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
x = page.coordinate("x", "m", "displacement along the belt")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.normal_force(N_0)
page.friction(x, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
"""

BOUNCING = f"""{HEAD}F = page.unit("F", "N", "weight")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.0, becomes="zeta")
y = page.coordinate("y", "m", "height")
page.kinetic(m * page.rate(y) ** 2 / 2)
page.damper(c, along=y)
page.force(-F, along=y)
page.contact(y, lambda depth: k * depth)
"""

VAN_DER_POL = f"""{HEAD}L = page.unit("L", "m", "a length")
a = page.parameter("a", "N s/m", "strength of the damper", ">= 0", 1.0, becomes="epsilon")
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(a * (x**2 / L**2 - 1), along=x)
"""


@pytest.fixture(scope="module")
def scaled() -> Any:
    return model_of(SCALED, "scaled")


def in_length(scaled: Any, unit: float, V: float) -> Any:
    """Base values of stick-slip, measured in a length so many times as large."""
    return scaled.Parameters(nu=unit, v_s=0.1 * unit, V=V * unit)


@needs_a_quick_integrator
@pytest.mark.parametrize("unit", [1.0, 1e-5, 1e-6])
def test_a_small_cycle_beside_rest_is_no_rest(scaled: Any, unit: float) -> None:
    """Above its dangerous onset, V = 1.4035, stick-slip coexists with sliding: the first start
    sticks, the others settle.
    """
    found = ss.rms_sweep(in_length(scaled, unit, 1.6), x0=np.array([1.3, 0.0, 0.4]) * unit)
    assert found.regime.tolist() == [Regime.LIMIT_CYCLE, Regime.EQUILIBRIUM, Regime.EQUILIBRIUM]
    assert found.period[0] == pytest.approx(6.33033028, abs=1e-7)  # in its own unit, N_0/k


@pytest.mark.thorough
@needs_a_quick_integrator
@pytest.mark.parametrize("unit", [1e-3, pytest.param(1e-6, marks=pytest.mark.thorough)])
def test_a_branch_of_small_cycles_goes_as_far_as_one_of_large_ones(
    scaled: Any, unit: float
) -> None:
    own = ss.load("stick_slip")
    large, small = ss.cycle(own.Parameters(V=0.2)), ss.cycle(in_length(scaled, unit, 0.2))
    assert small.period == pytest.approx(large.period, rel=1e-9)
    one, other = (
        ss.cycle_branch(large, "V", between={"V": (0.05, 2.0)}),
        ss.cycle_branch(small, "V", between={"V": (0.05 * unit, 2.0 * unit)}),
    )
    assert [(event.kind, event.how) for event in one.events] == [
        (event.kind, event.how) for event in other.events
    ]
    onset = ss.flutter_onsets(own.Parameters(), vary="V").V[0]
    ends = [one.events[0], other.events[0]]
    for end, width in zip(ends, (1.0, unit), strict=True):
        assert abs(end.value / width - onset) < 2 * end.error / width + 1e-6


@pytest.mark.thorough
@needs_a_quick_integrator
def test_a_curve_of_folds_goes_on_where_multipliers_are_known_to_ten_digits() -> None:
    """It ended after two points: rounding of the test function kept the closed orbit open."""
    p = ss.load("stick_slip").Parameters(V=2.9)
    (fold,) = ss.cycle_branch(ss.cycle(p, near=(3.2, 0.0)), "V", between={"V": (2.8, 3.3)}).of(
        "fold"
    )
    curve = ss.cycle_events(
        fold, ("V", "zeta"), between={"V": (1.0, 9.0), "zeta": (0.03, 0.07)}, points=3
    )
    assert curve.how == ("3 points were followed", "3 points were followed")
    V, zeta = curve.values[-1]
    beside = ss.cycle(
        p.replace(V=V - 0.05, zeta=zeta), near=curve.cycles[-1].state + np.array([0.05, 0.0])
    )
    (other,) = ss.cycle_branch(beside, "V", between={"V": (V - 0.2, V + 0.1)}).of("fold")
    assert other.value == pytest.approx(V, abs=1e-8)


@pytest.mark.thorough
@pytest.mark.parametrize("start", [(0.5, 1.0), (2.0, 0.0)])
def test_the_period_of_a_bouncing_mass_is_the_least(start: tuple[float, float]) -> None:
    """Flight and contact, a half of a harmonic swing and more: nothing damps, so that all orbits
    close.
    """
    found = ss.cycle(model_of(BOUNCING, "bouncing").Parameters(), near=start)
    touch = np.sqrt(2 * start[0] + start[1] ** 2)
    assert found.period == pytest.approx(2 * touch + 2 * np.pi - 2 * np.arctan(touch), abs=1e-9)


@pytest.mark.parametrize("epsilon", [2.0, 5.0])
def test_exponents_of_a_cycle_are_within_their_errors(epsilon: float) -> None:
    """Liouville: they add up to the mean divergence, −ε(⟨x²⟩ − 1). A multiplier of 1e-37 is lost in
    rounding.
    """
    found = ss.fate(
        model_of(VAN_DER_POL, "van_der_pol").Parameters(epsilon=epsilon), start=(0.1, 0.0)
    )
    assert found.kind == "cycle"
    divergence = -epsilon * (found.outcome.cycle_rms**2 - 1)
    assert abs(found.exponents.sum() - divergence) <= found.error.sum()
    assert found.error[0] == 0
