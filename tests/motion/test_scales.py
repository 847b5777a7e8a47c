"""Motions, cycles and fates of any size are the same, scaled; a limit that is come to slowly is met
where it is.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.models.field import field_of
from spragsym.motion.regimes import Outcome, Regime, same_limit
from spragsym.motion.scales import MotionScales, scaled, scales_of
from spragsym.orbits.finding import Attractor, followed
from spragsym.orbits.system import System
from tests.oracles import dry_friction
from tests.oracles.user_pages import WELLS, model_of

STICK_SLIP = ss.load("coulomb_stick_slip")

#: Sizes of N_0/k, the only scale of the page's numbers.
SIZES = [1e-6, 3e4, 1e6]


def sized(size: float, **values: float) -> Any:
    """Stick-slip whose lengths, speeds and forces are so many times as large."""
    given = {"mu_s": 0.6, "mu_k": 0.4, "V": 0.5} | values
    return STICK_SLIP.Parameters(**{name: size * value for name, value in given.items()})


@pytest.mark.thorough
@pytest.mark.parametrize(("backend", "size"), [("heyoka", 1e-6), ("scipy", 3e4)])
def test_a_motion_of_any_size_is_the_same_scaled(backend: str, size: float) -> None:
    """Its states, events, limit and errors: period and rms have closed forms."""
    pytest.importorskip(backend)
    one, other = (
        ss.simulate(sized(scale), start=(1.5 * scale, 0.0), t_end=30.0, backend=backend, rtol=1e-12)
        for scale in (1.0, size)
    )
    times = np.linspace(0.0, 30.0, 50)
    np.testing.assert_allclose(other(times) / size, one(times), rtol=0.0, atol=1e-9)
    assert one.events is not None
    assert other.events is not None
    np.testing.assert_allclose(other.events.t, one.events.t, rtol=0.0, atol=1e-8)
    assert other.events.which.tolist() == one.events.which.tolist()
    if backend == "scipy":  # which takes many seconds for the limit
        return
    found = other.outcome(10.0)
    assert found.regime == ss.Regime.LIMIT_CYCLE
    period = 0.8 + 2 * math.pi - 2 * math.atan(0.4)
    assert found.period == pytest.approx(period, rel=1e-10)
    assert found.cycle_mean / size == pytest.approx(one.outcome(10.0).cycle_mean, rel=1e-9)


def test_a_sweep_that_computes_in_units_of_its_own_measures_as_one_motion() -> None:
    """From a start of 3e5, whose size is the unit of length of the motion."""
    pytest.importorskip("heyoka")
    p = ss.load("mode_coupling").Parameters()
    found = ss.rms_sweep(p, x0=3e5, t_end=20.0, transient=10.0, backend="heyoka")
    motion = ss.simulate(p, x0=3e5, t_end=20.0, backend="scipy", rtol=1e-12).after(10.0)
    assert found.rms == pytest.approx(motion.rms(0.0), rel=1e-9)
    assert found.mean == pytest.approx(motion.mean(0.0), rel=1e-9)
    assert found.largest == pytest.approx(motion.largest(0.0), rel=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize("size", [pytest.param(1e-6, marks=pytest.mark.validate), 3e4])
def test_a_cycle_its_branch_and_its_fate_are_the_same_scaled(size: float) -> None:
    """Half the range is √(Δ² + V²), the period 2 Δ/V + 2 π − 2 atan(Δ/V)."""
    pytest.importorskip("heyoka")
    found = ss.cycle(sized(size), near=(0.6 * size, 0.5 * size))
    assert found.amplitude / size == pytest.approx(math.hypot(0.2, 0.5), rel=1e-11)
    assert found.error <= 1e-9 * max(size, 1.0)  # of the state and of the period
    assert found.residual <= 1e-12 * size
    branch = ss.cycle_branch(found, "V", between={"V": (0.45 * size, 0.55 * size)})
    assert [event.how for event in branch.events] == ["the range ends"] * 2
    V = branch.values / size
    period = 0.4 / V + 2 * math.pi - 2 * np.arctan(0.2 / V)
    np.testing.assert_allclose(branch.periods, period, rtol=1e-10)
    np.testing.assert_allclose(branch.amplitude / size, np.hypot(0.2, V), rtol=1e-10)
    assert ss.fate(sized(size), start=(1.5 * size, 0.0)).kind == "cycle"


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
@pytest.mark.parametrize("V", [1e-6, 1e-10])
def test_slip_begins_where_a_slow_belt_uses_the_friction_up(V: float, backend: str) -> None:
    """The limit is passed 1e-12/V late, and the state goes on from where it was met: the circle
    about μ_k through x = μ_s, x′ = V. Until then it rides with the belt, between samples too.

    What rounds in x, 1e-16, is 1e-16/V in time.
    """
    pytest.importorskip(backend)
    p = sized(1.0, V=V)
    begun = (0.6 - 0.59) / V
    tr = ss.simulate(p, start=(0.59, V), t_end=begun + 3.0, backend=backend)
    assert tr.events is not None
    late = 1e-9 + 2e-16 / V
    assert tr.events.of("slip").t == pytest.approx([begun], abs=late)
    riding = begun * np.linspace(0.05, 1.0, 8)
    held = np.stack([0.59 + V * riding, np.full(8, V)])
    np.testing.assert_allclose(tr(riding), held, rtol=0.0, atol=late)
    since = tr.t[-1] - begun
    c, s = math.cos(since), math.sin(since)
    turned = 0.4 + 0.2 * c + V * s, V * c - 0.2 * s
    assert tr.state[:, -1] == pytest.approx(turned, abs=late)


def test_scales_are_those_of_the_numbers_of_a_motion() -> None:
    """And exactly 1 for those of a common size, whose bits stay."""
    field = STICK_SLIP.field

    def scales(size: float) -> Any:
        values = sized(size).scalars(*STICK_SLIP.parameters)
        return scales_of(field, field.constants(values), (0.0, 0.0))

    assert scales(1.0).trivial
    assert scales(10.0).trivial
    for size in SIZES:
        assert 0.25 <= scales(size).places[0] / (0.6 * size) <= 2.0
        assert scales(size).time == 1.0
        assert scales(size).levels == scales(size).places * 3


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["coulomb", "sprag_rod"])
def test_motions_in_units_drawn_at_random_are_the_same(name: str) -> None:
    """Kilogram, metre and second of sizes from 1e-6 to 1e6."""
    pytest.importorskip("sympy")
    from tests.oracles.dimensional_pages import dimensional, units

    model, rng = dimensional(name), np.random.default_rng(75)
    base = {
        entry["name"]: entry["base"] if entry["base"] is not None else 0.7
        for entry in model.about["parameters"]
    }
    start = 0.2 * rng.standard_normal(len(model.components))
    times = np.linspace(0.0, 8.0, 20)
    own = ss.simulate(model.Parameters(**base), start=start, t_end=8.0, backend="scipy")
    for _ in range(2):
        sizes = 10 ** rng.uniform(-6.0, 6.0, 3)
        of_parameters, of_state = units(model, sizes)
        p = model.Parameters(**{key: value * of_parameters[key] for key, value in base.items()})
        other = ss.simulate(p, start=start * of_state, t_end=8.0 * sizes[2], backend="scipy")
        seen = other(np.minimum(times * sizes[2], other.t[-1])) / of_state[:, None]
        np.testing.assert_allclose(seen, own(times), rtol=0.0, atol=1e-7)
        assert own.events is not None
        assert other.events is not None
        assert other.events.which.tolist() == own.events.which.tolist()


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("kang_nam", {"V": 0.5, "d": 10.0, "theta0": 0.72101}),
        ("coulomb_stick_slip", {"V": 0.1}),
    ],
)
def test_a_motion_takes_as_many_steps_in_any_units(name: str, given: dict[str, float]) -> None:
    """Of kilogram, metre and second drawn as powers of four, by which nothing rounds, or of the
    kilogram alone, by which neither places nor times are measured. Levels of a common size keep the
    unit 1, and others have the nearest power of four, so that some steps are of another length.
    """
    pytest.importorskip("heyoka")
    pytest.importorskip("sympy")
    from tests.oracles.dimensional_pages import dimensional, units

    model, rng = dimensional(name), np.random.default_rng(75)
    base = {key: model.base.get(key) for key in model.parameters} | given
    start = np.resize([1.5, 0.0] if name == "coulomb_stick_slip" else [0.0], len(model.components))
    found = list[Any]()
    for powers in ((0, 0, 0), (15, 0, 0), rng.integers(1, 11, 3), -rng.integers(1, 11, 3)):
        sizes = 4.0 ** np.array(powers)
        of_parameters, of_state = units(model, sizes)
        p = model.Parameters(**{key: value * of_parameters[key] for key, value in base.items()})
        motion = ss.simulate(
            p, start=start * of_state, t_end=30.0 * sizes[2], rtol=1e-12, max_steps=2000
        )
        found.append((len(motion.t), motion.state[:, -1] / of_state))
    for steps, state in found[1:]:
        assert abs(steps - found[0][0]) <= 0.1 * found[0][0]
        np.testing.assert_allclose(state, found[0][1], rtol=0.0, atol=1e-10)


@pytest.mark.thorough
@pytest.mark.parametrize("size", [4.0**-10, 4.0**10])
def test_exponents_and_fates_are_the_same_in_any_units(size: float) -> None:
    """Also where the time is left out; units of a motion are powers of four."""
    pytest.importorskip("sympy")
    pytest.importorskip("heyoka")
    from tests.oracles.dimensional_pages import dimensional, units

    model = dimensional("stick_slip")
    base = {entry["name"]: entry["base"] for entry in model.about["parameters"]}
    of_parameters, of_state = units(model, (size, size, size))
    for kind, values in (("cycle", base | {"V": 0.5}), ("rest", base | {"V": 2.0})):
        one = model.Parameters(**values)
        scaled = model.Parameters(**{name: values[name] * of_parameters[name] for name in values})
        start = np.array([0.4, 0.0])
        found, other = ss.fate(one, start=start), ss.fate(scaled, start=start * of_state)
        assert (other.kind, found.kind) == (kind, kind)
        assert other.t == found.t * size
        assert other.time_scale == pytest.approx(found.time_scale * size, rel=1e-9)
        assert other.exponents * size == pytest.approx(found.exponents, rel=1e-9)
        rates, those = (
            ss.lyapunov(p, start=begun, t_end=100.0 * time)
            for p, begun, time in ((one, start, 1.0), (scaled, start * of_state, size))
        )
        assert those.exponents * size == pytest.approx(rates.exponents, rel=1e-9)
        assert those.error * size == pytest.approx(rates.error, rel=1e-6)
        assert those.zero.tolist() == rates.zero.tolist()
        assert (those.trivial, those.kind) == (rates.trivial, rates.kind)
        assert those.t[-1] == rates.t[-1] * size
    with pytest.raises(ss.errors.ParameterError, match="t_end"):
        ss.fate(one, t_end=-1.0)


@pytest.mark.thorough
def test_the_boundary_of_a_basin_is_the_same_scaled() -> None:
    """The curve of starts from which the mass stays on the hump."""
    pytest.importorskip("heyoka")
    model, found = model_of(WELLS, "wells"), []
    for size in (1.0, 4.0**10, 4.0**-10):
        p = model.Parameters(l=size, P=0.05 * size, c=0.1)
        between = dict.fromkeys(("x", "vx"), (-3.0 * size, 3.0 * size))
        curve = ss.basin_boundary(p, saddle=[0.0], between=between, points=2)
        assert curve.boundary.all()
        assert curve.error.max() < 1e-10 * size
        found.append(curve.points / size)
    for other in found[1:]:
        np.testing.assert_allclose(other, found[0], rtol=1e-9, atol=1e-9)


@pytest.mark.validate
def test_the_boundary_between_two_fates_is_the_same_scaled() -> None:
    """The push beyond which the mass comes to rest in the other well, against another
    integrator.
    """
    pytest.importorskip("heyoka")
    model, found = model_of(WELLS, "wells"), []
    for size in (1.0, 4.0**10, 4.0**-10):
        between = {"P": (0.03 * size, 0.05 * size)}
        one = ss.fate_boundary(
            model.Parameters(l=size, c=0.1), "P", between=between, start=[1.6 * size, 0.0]
        )
        assert (one.saddle, one.error < 1e-11 * size) == ("equilibrium", True)
        found.append((one.value / size, one.distance, one.state[0] / size, one.growth))
    for other in found[1:]:
        assert other == pytest.approx(found[0], rel=1e-9)
    sides = list[bool]()
    for P in (found[0][0] - 1e-8, found[0][0] + 1e-8):
        ends = solve_ivp(
            lambda _, u, P=P: [u[1], u[0] - u[0] ** 3 - 0.1 * u[1] + P],
            (0.0, 400.0),
            [1.6, 0.0],
            method="DOP853",
            rtol=1e-12,
            atol=1e-13,
        )
        sides.append(ends.y[0, -1] > 0.0)
    assert sides[0] != sides[1]


@pytest.mark.thorough
def test_an_attractor_is_followed_in_any_units() -> None:
    """To the largest root of x³ − x = P, and no farther than where that ends, at 2/√27."""
    model = model_of(WELLS, "wells")
    for size in (1.0, 4.0**20, 4.0**-20):
        system = System.of(model.Parameters(l=size, P=0.0), "scipy")
        known = Attractor(Regime.EQUILIBRIUM, system, np.array([size, 0.0]))
        for P in (-0.3, 0.2):
            found = followed(known, system.at("P", P * size))
            assert found.state[0] / size == pytest.approx(np.roots([1, 0, -1, -P]).max(), rel=1e-12)
        with pytest.raises(ss.errors.ConvergenceError):
            followed(known, system.at("P", -0.4 * size))


@pytest.mark.thorough
def test_a_diagram_is_the_same_scaled() -> None:
    """Its folds are where x³ − x = P has two roots that are one."""
    model = model_of(WELLS, "wells")
    for size in (1.0, 4.0**-10, 4.0**10):
        p = model.Parameters(l=size, c=0.1)
        found = ss.diagram(p, "P", between={"P": (-0.5 * size, 0.5 * size)})
        (line,) = found.equilibria
        assert line.values[0] / size == pytest.approx(-0.5, rel=1e-12)
        places = sorted((at.value / size, at.height / size) for at in found.labels)
        folds = np.array([(-2 / 3, 1.0), (2 / 3, -1.0)]) / math.sqrt(3.0)
        np.testing.assert_allclose(places, folds, rtol=1e-6)


@pytest.mark.thorough
def test_a_cycle_is_born_in_any_units() -> None:
    """At the onset at which it is unstable: an amplitude is met to a thousandth, and where none is
    asked for it suits the units.
    """
    pytest.importorskip("heyoka")
    from tests.oracles.dimensional_pages import dimensional, units

    model, found = dimensional("stick_slip"), []
    base = {entry["name"]: entry["base"] for entry in model.about["parameters"]}
    for size in (1.0, 4.0**10, 4.0**-10):
        of_parameters, of_state = units(model, (size, size, size))
        p = model.Parameters(**{name: base[name] * of_parameters[name] for name in base})
        speed = of_parameters["V"]
        onsets = ss.flutter_onsets(p, vary="V", between={"V": (1.0 * speed, 2.0 * speed)})
        assert len(onsets) == 1
        free, born = (ss.cycle(onset=onsets, amplitude=given) for given in (None, 0.05 * size))
        assert not free.stable
        assert 1e-3 < free.amplitude / size < 1.0
        found.append((born.parameters["V"] / speed, *born.state / of_state))
    for other in found[1:]:
        np.testing.assert_allclose(other, found[0], rtol=1e-3, atol=1e-9)


def test_rests_that_are_far_apart_in_their_units_are_two() -> None:
    """A micrometre is no tolerance for what is as small: three rests of one mass."""
    model = model_of(WELLS, "wells")
    for size in (1.0, 1e-9, 1e9):
        p = model.Parameters(l=size, P=0.0)
        constants = model.field.constants(p.scalars(*model.parameters))
        rests = [Outcome(Regime.EQUILIBRIUM, rest=(x * size,)) for x in (-1.0, 1.0, 1.0 + 1e-8)]
        assert not same_limit(rests[0], rests[1], model.field, constants)
        assert same_limit(rests[1], rests[2], model.field, constants)


@pytest.mark.thorough
def test_an_angle_that_uses_friction_up_leaves_other_units_alone() -> None:
    """A pendulum whose tip sticks: at some angles its slider would have to go thousands of lengths
    for the same.
    """
    model, rng = dry_friction.model("tip"), np.random.default_rng(75)
    constants = model.field.constants(model.Parameters(V=0.4).scalars(*model.parameters))
    upright = rng.uniform(-2e-2, 2e-2, 50)
    states = np.column_stack([rng.uniform(0.5, 1.5, 50), upright, np.zeros(50), np.full(50, 0.4)])
    for state in states.tolist():
        assert scales_of(model.field, constants, state).trivial


#: A slider with a mass on a turning arm, at rest where both springs are slack.
ARM = """'''A slider with an arm.'''
from spragsym.derive.model import Page

page = Page("A slider that carries a mass on an arm.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness of the slider")
r = page.unit("r", "m", "arm")
c = page.parameter("c", "N s/m", "damping", "> 0", 0.5)
y = page.coordinate("y", "m", "place of the slider")
a = page.coordinate("a", "rad", "angle of the arm")
page.kinetic(m * (page.rate(y) ** 2 + r**2 * page.rate(a) ** 2) / 2)
page.spring(k, along=y - r * a / 2)
page.spring(k, along=r * a)
page.damper(c, along=y)
page.damper(c, along=r * a)
"""


@pytest.mark.thorough
def test_what_is_left_of_a_length_is_none_beside_an_angle() -> None:
    """An angle keeps its unit, and what rounds in it moves the slider: by much, in units of as
    little as is left of a slider's swing. All dies out as exp(-c t/2).
    """
    pytest.importorskip("heyoka")
    p = model_of(ARM, "arm").Parameters()
    found = ss.fate(p, start=(0.1, 0.0, 0.0, 0.0), t_end=1000.0)
    assert found.kind == "rest"
    assert found.time_scale == pytest.approx(4.0, rel=1e-9)


#: A block on a belt whose speed varies, before a stop; its friction is smooth at rest.
BEFORE_A_STOP = """'''A block on a belt before a stop.'''
from spragsym.derive.model import Abs, Page, exp, sgn, sin

page = Page("A block on a belt, before a stop.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
N = page.unit("N", "N", "normal force")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.3)
V = page.parameter("V", "m/s", "mean speed of the belt", ">= 0", 1.0)
a = page.parameter("a", "m", "amplitude of the belt", ">= 0", 0.0)
w = page.parameter("w", "1/s", "frequency of the belt", "> 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 30.0)
x = page.coordinate("x", "m", "place")
phase = page.clock(w)
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.contact(N / k - x, lambda depth: 8 * k * depth, name="stop")
law = lambda v: mu * (1 - exp(-d * Abs(v))) * sgn(v)
page.friction(x, V + page.rate(a * sin(phase)), law, on=page.normal_force(N, name="belt"))
"""


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
@pytest.mark.parametrize(
    ("V", "a", "start"), [(1.0, 0.0, (-2.0, 0.0, 2.0)), (0.0, 2.0, (-2.0, math.pi, -1.2))]
)
def test_what_a_law_would_be_on_its_other_side_is_no_size(
    backend: str, V: float, a: float, start: tuple[float, float, float]
) -> None:
    """exp(d |v|) there, 1e13: accelerations were measured in as much, and no event was met."""
    pytest.importorskip(backend)
    p = model_of(BEFORE_A_STOP, "before_a_stop").Parameters(V=V, a=a)
    found = ss.simulate(p, start=start, t_end=8.0, backend=backend)

    def field(t: float, u: Any) -> list[float]:
        slip = V + a * 0.5 * math.cos(start[1] + 0.5 * t) - u[1]
        rubs = 0.3 * math.copysign(-math.expm1(-30 * abs(slip)), slip)
        return [u[1], rubs - u[0] - 8 * max(u[0] - 1, 0.0)]

    end = solve_ivp(field, (0.0, 8.0), (start[0], start[2]), "DOP853", rtol=1e-10, atol=1e-11)
    assert found.state[[0, 2], -1] == pytest.approx(end.y[:, -1], abs=1e-6)


def test_whether_a_mass_stays_above_the_belt_is_asked_in_its_own_units() -> None:
    """The article's mass in a well above the belt, at rest and fast enough to leave it."""
    p = ss.Parameters(theta0=np.pi / 3, mu0=0.3, kappa=0.01, alpha=10.0, sigma=10.0, beta=0.0)
    field = field_of(p.model, 42.0)
    units = MotionScales((0.25, 4.0), 16.0, (1.0,) * len(field.borders))
    there = scaled(field, units)
    assert field.airborne is not None
    assert there.airborne is not None
    constants = tuple(float(value) for value in p.model.arguments(p, "motion"))
    for rate, stays in ((0.0, True), (10.0, False)):
        state = np.array([0.0, 2 * np.sin(p.theta0), rate, 0.0])
        assert field.airborne(constants, state) == stays
        assert there.airborne(constants, state / units.states) == stays
