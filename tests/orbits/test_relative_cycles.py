"""Motions that repeat up to a shift: blocks that nothing ties to a place, against closed forms and
another integrator.
"""

import math

import numpy as np
import pytest
from scipy.linalg import expm

import spragsym as ss
from tests.oracles.user_pages import model_of

pytestmark = pytest.mark.thorough

PAIR = '''"""Two blocks with a spring between them that a motor drives."""
from spragsym.derive.model import Page, cos, sgn

page = Page("Two blocks with a spring between them that a motor drives.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
P = page.unit("P", "N", "force of the motor")
w = page.parameter("w", "1/s", "speed of the motor", "> 0", 0.7)
f = page.parameter("f", "N", "force down the slope", "real", 0.15)
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.1)
x = page.coordinate("x", "m", "first block")
y = page.coordinate("y", "m", "second block")
phi = page.clock(w)
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k, along=x - y)
page.force(P * cos(phi), along=x - y)
page.force(f, along=x + y)
'''
OILED = PAIR + "page.damper(c, along=x)\npage.damper(c, along=y)\n"
RUBBING = PAIR.replace(
    "x = page",
    'still = page.parameter("still", "m/s", "what stands still", ">= 0", 0.0)\n'
    'mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)\nx = page',
).replace("page.rate(y) ** 2", "1.4 * page.rate(y) ** 2") + (
    "page.damper(c, along=x - y)\n"
    "def rub(along, name, N):\n"
    "    on = page.normal_force(N * P, name=name)\n"
    "    page.friction(along, still, slip=lambda v: mu * sgn(v), holds=mu, on=on)\n"
    'rub(x, "one", 0.7)\nrub(y, "two", 1.0)\n'
)


def test_what_drifts_on_oil_is_a_relative_periodic_orbit() -> None:
    """The middle moves at the speed f/c; across it, and beside it, all is linear."""
    p = model_of(OILED, "oiled").Parameters(c=0.2)
    found, turn = ss.cycle(p), 2 * math.pi / 0.7
    assert found.period == pytest.approx(turn, rel=1e-12)
    assert found.drift == pytest.approx([0.15 / 0.2 * turn, 0.15 / 0.2 * turn, 0.0], rel=1e-9)
    assert found.stable
    apart = expm(np.array([[0.0, 1.0], [-2.0, -0.2]]) * turn)
    others = [math.exp(-0.2 * turn), *np.linalg.eigvals(apart)]
    assert found.multipliers[:2] == pytest.approx([1.0, 1.0], abs=1e-9)
    assert np.poly(found.multipliers[2:]) == pytest.approx(np.poly(others), abs=1e-9)
    assert math.isnan(found.mean)
    fate = ss.fate(p)
    assert fate.kind == "cycle"
    assert "a relative periodic orbit: it shifts by x = 6.73" in fate.why
    assert fate.exponents[:2].tolist() == [0.0, 0.0]
    assert fate.exponents[2] == pytest.approx(-0.1, abs=1e-9)
    assert ss.lyapunov(p).kind == "cycle"
    beside = ss.cycle(p, near=[5.0, 5.0, 0.0, 0.0])  # the same orbit elsewhere
    assert ss.orbits.orbit.same_cycle(found, beside)


def test_a_crawler_is_followed_as_its_slope_varies() -> None:
    p = model_of(RUBBING, "crawler").Parameters()
    found, turn = ss.cycle(p), 2 * math.pi / 0.7
    tr = ss.simulate(p, t_end=40 * turn, backend="scipy")
    moved = tr.state[:2, -1] - tr(39 * turn)[:2]
    assert found.drift[:2] == pytest.approx(moved, abs=1e-7)
    assert (moved > 1).all()
    branch = ss.cycle_branch(found, "f", between={"f": (0.14, 0.16)})
    assert [event.how for event in branch.of("end")] == ["the range ends"] * 2
    assert branch.cycles[0].drift[0] < found.drift[0] < branch.cycles[-1].drift[0]


def test_what_is_tied_to_a_place_has_no_shift() -> None:
    p = ss.load("coulomb_stick_slip").Parameters(V=0.2)
    assert not len(p.model.field.periodic.shifts)
    assert ss.cycle(p).drift.tolist() == [0.0]


def test_what_nothing_damps_has_its_cycle_under_a_clock_and_is_conservative() -> None:
    """x″ = −x + cos(0.7 t) without friction: of period 2π/0.7, x = cos(0.7 t)/(1 − 0.49)."""
    p = ss.load("forced_oscillator").Parameters(mu_s=0.0, mu_k=0.0)
    found = ss.cycle(p, near=[0.3, 0.2])
    assert found.period == pytest.approx(2 * math.pi / 0.7, rel=1e-12)
    assert found.state[0] == pytest.approx(1 / 0.51, abs=1e-9)
    assert np.abs(found.multipliers) == pytest.approx(1.0, abs=1e-9)
    fate = ss.fate(p, start=[0.3, 0.2], t_end=400.0)
    assert fate.kind == "undecided"
    assert "it is conservative, and comes to nothing; it is periodic or quasi-periodic" in fate.why


@pytest.mark.thorough
def test_newton_finds_from_rest_what_no_motion_comes_to() -> None:
    """Without damping the motion from rest stays quasi-periodic, and its limit is no cycle."""
    p = ss.load("forced_oscillator").Parameters(mu_s=0.0, mu_k=0.0)
    found = ss.cycle(p)
    assert found.period == pytest.approx(2 * math.pi / 0.7, rel=1e-12)
    assert found.state[0] == pytest.approx(1 / 0.51, abs=1e-9)
