"""Where friction holds: sets of rest are one attractor each, deviations that sticking ends have no
rate, and a force that is constant is no event.
"""

import math
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError
from spragsym.motion.shooting import integrated, remeshed
from spragsym.motion.sweeps import basin, rms_sweep
from tests.oracles.contact_pages import BLOCKS
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytestmark = [pytest.mark.thorough, needs_a_quick_integrator]

HEAD = '''"""A block that dry friction holds."""
from spragsym.derive.model import Page, sgn

page = Page("A block that dry friction holds.")
m = page.unit("m", "kg", "mass")
g = page.unit("g", "m/s^2", "acceleration")
l = page.unit("l", "m", "length")
mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.5)
mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.0)
'''

RAMP = (
    HEAD
    + """F = page.parameter("F", "N", "weight along the ramp", "real", 0.2)
x = page.coordinate("x", "m", "way down the ramp")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.force(F, along=x)
page.normal_force(m * g)
page.friction(x, V, slip=lambda v: mu_k * sgn(v), holds=mu_s)
"""
)

WELLS = (
    HEAD
    + """c = page.parameter("c", "N s/m", "damper", ">= 0", 0.04)
x = page.coordinate("x", "m", "block between two wells")
w = page.coordinate("w", "m", "mass beside it")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(w) ** 2) / 2)
page.potential(m * g * (x**4 / (4 * l**3) - x**2 / (2 * l)))
page.spring(m * g / l, along=w)
page.damper(c, along=w)
page.normal_force(m * g)
page.friction(x, V, slip=lambda v: mu_k * sgn(v), holds=mu_s)
"""
)


def test_a_block_under_a_constant_force_comes_to_rest_or_drifts() -> None:
    """Its sliding speed has a constant rate, which no integrator takes for an event."""
    model, rng = model_of(RAMP, "ramp"), np.random.default_rng(75)
    for _ in range(2):
        F, speed = rng.uniform(-0.35, 0.35), rng.uniform(0.5, 1.5)
        p = model.Parameters(F=F)
        found = ss.fate(p, start=(0.0, speed), t_end=400.0)
        assert found.kind == "rest"
        assert found.outcome.rest[0] == pytest.approx(speed**2 / (2 * (0.4 - F)), abs=1e-9)
        assert found.exponents.tolist() == [0.0, -math.inf]
        told = ss.lyapunov(p, start=(0.0, speed), t_end=100.0)
        assert (told.kind, told.limit.tolist()) == ("rest", [0.0, -math.inf])
        with pytest.raises(ConvergenceError, match="it comes to rest, and friction holds it"):
            ss.cycle(p, near=(0.0, speed))
    p = model.Parameters(F=rng.uniform(0.45, 0.9))
    told = ss.lyapunov(p, start=(0.0, 1.0), t_end=20.0)
    assert told.end == pytest.approx([20 + 200 * (p.F - 0.4), 1 + 20 * (p.F - 0.4)], rel=1e-12)
    assert told.kind == "undecided"
    assert ss.fate_map(p, start=(0.0, 1.0), t_end=50.0).kind == 0
    with pytest.raises(ConvergenceError, match="no cycle was found"):
        ss.cycle(p, near=(0.0, 1.0), patient=False)


#: A block that a weak spring does not tear off a table that shakes.
SHAKEN = (
    HEAD
    + """w = page.parameter("w", "1/s", "frequency", "> 0", 0.8)
x = page.coordinate("x", "m", "place of the block")
phase = page.clock(w)
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(m * g / l, along=x)
page.normal_force(m * g)
page.friction(x, V + page.rate(l * sin(phase) / 5), slip=lambda v: mu_k * sgn(v), holds=mu_s)
"""
).replace("import Page, sgn", "import Page, sgn, sin")


def test_what_rides_on_a_table_that_shakes_keeps_its_place_on_it() -> None:
    """x = x0 + sin(w t)/5: deviations of the place and of the phase stay, that of the slip ends,
    whichever of them a motion that begins in it is asked for first.
    """
    p = model_of(SHAKEN, "shaken").Parameters()
    for t_end in (100.0, 200.0, 500.0, 1000.0):
        found = ss.fate(p, start=(0.1, 0.0, 0.16), t_end=t_end)
        assert found.exponents[:2] == pytest.approx([0.0, 0.0], abs=2e-3)
        assert found.exponents[2] == -math.inf
        assert "drift" not in found.why
    cycle = ss.cycle(p, turns=1, near=(0.1, 0.0, 0.16, 0.8))
    assert (cycle.stable, cycle.multipliers.tolist()[1:]) == (True, [1, 0])
    assert cycle.state[:2] == pytest.approx([0.3, math.pi / 2], abs=1e-9)
    later = integrated(cycle.orbit.flow, remeshed(cycle.orbit, 1, 1.0))
    assert later.multipliers.held == 1


def test_a_set_of_rest_states_is_one_attractor() -> None:
    """Friction holds where |x³ − x| ≤ μ_s, in three intervals."""
    p = ss.load("coulomb_stick_slip").Parameters(V=0.0)
    axes = {"x": np.linspace(-2, 2, 12), "vx": np.linspace(-1, 1, 12)}
    found = basin(p, **axes, t_end=60.0, transient=40.0)
    assert len(found.attractors) == 1
    assert np.isinf(found.sweep.rate).all()
    wells = model_of(WELLS, "wells").Parameters(mu_s=0.2, mu_k=0.15)
    x = np.linspace(-1.1, 1.1, 23)
    held = np.abs(x**3 - x) <= 0.2
    found = basin(wells, x=x[held], w=[0.0], t_end=60.0, transient=40.0)
    own = np.digitize(x[held], [-0.5, 0.5])
    assert len(found.attractors) == 3
    assert [len({*found.attractor[own == each, 0]}) for each in range(3)] == [1, 1, 1]


def blocks(second: str, name: str) -> Any:
    """Two blocks on belts at rest, with this on the second one in place of its spring."""
    return model_of(BLOCKS.replace("page.spring(beta * k, along=x_2)", second), name)


def rests(p: Any, rng: np.random.Generator) -> Any:
    """Where motions from random starts come to rest."""
    x_1, x_2 = rng.uniform(-1.2, 1.2, (2, 3))
    return basin(p, x_1=x_1, x_2=x_2, vx_10=rng.uniform(-1, 1), t_end=60.0, transient=30.0)


def test_rest_under_stiffening_springs_is_one_attractor() -> None:
    """Forces of a strictly convex energy map places onto forces one to one: those within the limits
    of friction are those of one connected set of places.
    """
    rng = np.random.default_rng(75)
    model = blocks("page.potential(k * (beta * x_2**2 / 2 + x_2**4 / a**2 / 4))", "stiffening")
    for _ in range(2):
        beta, kappa, mu_s = rng.uniform((0.5, 0.1, 0.45), (2.0, 1.0, 0.8))
        p = model.Parameters(V=0.0, beta=beta, kappa=kappa, mu_s=mu_s)
        assert len(ss.sticking_states(p)) == 1
        found = rests(p, rng)
        assert len(found.attractors) == 1
        assert not found.remarks


def test_rest_of_blocks_that_nothing_ties_to_the_ground_is_one_attractor() -> None:
    """Forces are linear, det K is 0: the states that |F_i| ≤ μ_s N_i holds form a strip."""
    rng = np.random.default_rng(76)
    text = BLOCKS.replace("page.spring(k, along=x_1)\n", "")
    text = text.replace("page.spring(beta * k", "page.force(beta * k * a / 9").replace(
        "k, *", "k, "
    )
    model = model_of(text, "untied")
    for kappa in (0.0, rng.uniform(0.1, 1.0)):
        p = model.Parameters(V=0.0, beta=rng.uniform(0.5, 2.0), kappa=kappa)
        found = rests(p, rng)
        assert len(found.attractors) == 1
        assert not found.remarks


def test_rest_in_each_well_is_an_attractor_of_its_own() -> None:
    """Without a spring between them the second block rests where |x³ − x| ≤ μ_s N_2 / (k a)."""
    rng = np.random.default_rng(77)
    model = blocks("page.potential(beta * k * (x_2**4 / a**2 / 4 - x_2**2 / 2))", "two_wells")
    p = model.Parameters(V=0.0, beta=1.0, kappa=0.0, mu_s=0.2, mu_k=rng.uniform(0.1, 0.15), N_2=1.0)
    found = rests(p, rng)
    x_2 = found.sweep.rest_x_2
    well = np.sign(x_2) * (np.abs(x_2) > 0.5)
    assert len({*well.ravel()}) == len(found.attractors) > 1
    for each in np.unique(found.attractor):
        assert len({*well[found.attractor == each]}) == 1
    assert not found.remarks


@pytest.mark.thorough
def test_a_ramp_is_one_set_of_rest_and_one_attractor() -> None:
    """It sticks everywhere where |F| ≤ μ_s, and nowhere else."""
    model, rng = model_of(RAMP, "ramp"), np.random.default_rng(8)
    p = model.Parameters(mu_s=0.5, F=rng.uniform(-0.35, 0.35))
    found = basin(p, x=np.linspace(-1, 1, 3), vx=np.linspace(0.2, 1, 3), t_end=60.0, transient=40.0)
    assert len(found.attractors) == 1
    for F in (*rng.uniform(-1, 1, 8), 0.5 - 1e-12, -0.5 - 1e-12):
        sets = ss.sticking_states(model.Parameters(mu_s=0.5, F=F))
        assert sets.complete
        assert sets.x_low.tolist() == [-math.inf] * int(abs(F) <= 0.5)
        assert sets.x_high.tolist() == [math.inf] * int(abs(F) <= 0.5)
        assert sets.error.tolist() == [0.0] * int(abs(F) <= 0.5)


@pytest.mark.thorough
def test_on_a_ramp_what_hangs_on_a_spring_rests_at_one_place() -> None:
    text = (
        RAMP.replace(
            "page.force(F, along=x)\n",
            'w = page.coordinate("w", "m", "mass beside it")\n'
            "page.force(F, along=x)\npage.spring(m * g / l, along=w)\npage.force(m * g, along=w)\n",
        )
        .replace("page.kinetic(m * page.rate(x) ** 2 / 2)\n", "")
        .replace(
            "page.normal_force",
            "page.kinetic(m * (page.rate(x)**2 + page.rate(w)**2) / 2)\npage.normal_force",
        )
    )
    sets = ss.sticking_states(model_of(text, "hanging").Parameters(mu_s=0.5, F=0.2))
    ends = sets.x_low, sets.x_high, sets.w_low, sets.w_high
    assert np.ravel(ends) == pytest.approx([-math.inf, math.inf, 1.0, 1.0], rel=1e-12)


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_what_sticking_ends_has_no_rate(backend: str) -> None:
    """Of a cycle that sticks the multiplier across it is 0, whatever rounding leaves."""
    p = ss.load("coulomb_stick_slip").Parameters(V=0.5)
    start = {"x0": 0.5, "vx0": 0.5}
    known = ss.simulate(p, **start, t_end=100.0, backend=backend).outcome(50.0)
    assert (known.regime, known.rate) == (ss.Regime.LIMIT_CYCLE, math.inf)
    swept = rms_sweep(p, **start, t_end=100.0, transient=50.0, backend=backend)
    assert swept.rate == math.inf
    cycle = ss.cycle(p, near=(0.5, 0.5), backend=backend)
    assert (cycle.multipliers[1], cycle.multiplier_errors[0], cycle.stable) == (0.0, 0.0, True)
    told = ss.lyapunov(p, start=(0.5, 0.5), t_end=100.0, backend=backend)
    assert (told.exponents[1], told.limit.tolist()) == (-math.inf, [0.0, -math.inf])


def test_what_approaches_rest_beside_a_block_that_sticks_has_its_rate() -> None:
    c = float(np.random.default_rng(9).uniform(0.02, 0.08))
    p = model_of(WELLS, "wells").Parameters(mu_s=0.2, mu_k=0.15, c=c)
    known = ss.simulate(p, start=(1.0, 0.3, 0.0, 0.0), t_end=500.0).outcome()
    assert known.rate == pytest.approx(c / 2, rel=1e-9)
    told = ss.fate(p, start=(1.0, 0.3, 0.0, 0.0), t_end=500.0)
    assert told.exponents == pytest.approx([0.0, -c / 2, -c / 2, -math.inf], rel=1e-9)


def test_a_cycle_beside_a_block_that_friction_holds_attracts_at_each_of_its_places() -> None:
    """The block on the belt sticks and slips by itself, about a place that the other one shifts."""
    floor = 'V = page.parameter("W", "m/s", "speed of the floor", ">= 0", 0.0)\npage.friction(x_2'
    model = model_of(BLOCKS.replace("page.friction(x_2", floor), "beside")
    V, kappa, excess = 0.3, 0.2, 0.1
    p = model.Parameters(V=V, kappa=kappa, mu_s=0.4 + excess, N_2=5.0)
    rate, lag = math.sqrt(1 + kappa), excess / (1 + kappa)
    slips = 2 * (math.pi - math.atan(lag * rate / V)) / rate
    period, amplitude = 2 * lag / V + slips, math.hypot(lag, V / rate)
    for place in (0.0, -1.25):
        start = (0.9, place, 0.0, 0.0)
        found, cycle = ss.fate(p, start=start), ss.cycle(p, near=start)
        assert (found.kind, found.exponents.tolist()) == ("cycle", [0, 0, -math.inf, -math.inf])
        assert found.outcome.period == pytest.approx(period, rel=1e-6)
        assert cycle.period == pytest.approx(period, rel=1e-10)
        middle = (0.4 + kappa * place) / (1 + kappa)
        assert cycle.state == pytest.approx([middle + amplitude, place, 0, 0], abs=1e-10)
        assert (cycle.stable, cycle.multipliers.tolist()[1:]) == (True, [1, 0, 0])
    branch = ss.cycle_branch(cycle, "kappa", between={"kappa": (0.19, 0.22)})
    assert branch.cycles[0].state[1] == pytest.approx(place, abs=1e-10)
