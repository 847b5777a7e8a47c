"""Cycles: against SciPy's own driver, closed forms, published numbers, simulations on both sides,
and a proof.
"""

import dataclasses
import importlib
import itertools
import math
import types
from fractions import Fraction
from importlib.util import find_spec
from typing import Any

import mpmath
import numpy as np
import pytest
import scipy.stats
from scipy.integrate import quad, solve_ivp
from scipy.optimize import fsolve

import spragsym as ss
from benchmarks import bench_auto
from spragsym.generated import laws
from spragsym.models.field import Border, Field, exact_field
from spragsym.motion import multipliers
from spragsym.motion.integrators import Flow
from spragsym.motion.shooting import in_scales
from spragsym.numerics.decimals import exactly
from spragsym.numerics.jets import gradient, variables
from spragsym.orbits import branch as branches
from spragsym.orbits import diagram, exponents, finding, orbit
from spragsym.orbits.arclength import Setting, between, corrected, started
from spragsym.orbits.orbit import same_cycle
from spragsym.orbits.retracing import CLOSED, CLOSES, MIRRORED, RETRACES, is_mirrored, returned
from spragsym.orbits.system import System, growth_of_cycle
from tests.oracles import random_motions
from tests.oracles.clocks import STOPPED
from tests.oracles.second_driver import differences
from tests.oracles.user_pages import model_of
from tests.support import few

#: The article's model, as cycles take it.
SPRAG = ss.load("kang_nam").field

pytestmark = pytest.mark.skipif(not find_spec("heyoka"), reason="branches take SciPy minutes")

BELT = {"V": 0.5, "d": 10.0}


def at(degrees: float, **changes: float) -> ss.Parameters:
    return ss.Parameters.article(theta0=np.radians(degrees), **changes)


def moving(p: ss.Parameters, state: Any, **options: Any) -> ss.results.Trajectory:
    """The motion from a state, to a tight tolerance."""
    start = dict(zip(("x0", "y0", "vx0", "vy0"), map(float, state), strict=True))
    return ss.simulate(p, **BELT, **start, rtol=1e-12, **options)


def cycle_near(field: Field, values: tuple[float, ...], near: Any) -> ss.results.Cycle:
    """The cycle of any field near a state."""
    return finding.cycle_near(System(Flow.of(field, None), values), near)


@pytest.fixture
def proving() -> types.SimpleNamespace:
    """What proofs stand on; none of it without flint."""
    flint = pytest.importorskip("flint")
    names = ("ball_flow", "ball_proof", "proofs")
    return types.SimpleNamespace(
        flint=flint, **{name: importlib.import_module(f"spragsym.orbits.{name}") for name in names}
    )


@pytest.fixture(scope="module")
def slow() -> ss.results.Cycle:
    """The weakly attracting cycle at 42 degrees."""
    return ss.cycle(at(42.0), **BELT, near=(2.54, 3.36, 0.0, 0.36))


@pytest.fixture(scope="module")
def branch(slow: ss.results.Cycle) -> ss.results.CycleBranch:
    """Through three grazings and a period doubling."""
    return ss.cycle_branch(
        slow,
        "theta0",
        between={"theta0": (np.radians(41.0), np.radians(43.6))},
        options=ss.BranchOptions(longest_step=0.3),
    )


# ------------------------------------------------------------------------------------------------
# orbits


def test_a_cycle_is_that_of_another_driver(slow: ss.results.Cycle) -> None:
    assert max(differences(slow)) < 1e-9


def test_what_is_on_a_cycle_is_no_distance_away(slow: ss.results.Cycle) -> None:
    """The motion from its state, which another integrator carries, and what stands beside it."""
    turn = ss.simulate(at(42.0), **BELT, start=slow.state, t_end=slow.period, backend="scipy")
    places = turn(np.linspace(0.0, slow.period, 7)).T
    assert max(orbit.distance(slow, place) for place in places) < 0.02
    beside = places[3] + [0.0, 40.0, 0.0, 0.0]
    assert orbit.distance(slow, beside) == pytest.approx(40.0, rel=0.1)
    assert orbit.same_cycle(slow, dataclasses.replace(slow))


def test_newtons_method_begins_where_its_guess_was_integrated(
    slow: ss.results.Cycle, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a guess is integrated for, its mesh, is the first step of Newton's method too."""
    whole, asked = Flow.flow_map, []

    def recorded(self: Flow, state: Any, constants: Any, duration: float, *more: Any) -> Any:
        asked.append((*state.tolist(), duration))
        return whole(self, state, constants, duration, *more)

    monkeypatch.setattr(Flow, "flow_map", recorded)
    flow, guess = slow.orbit.flow, slow.orbit.guess
    moved = dataclasses.replace(guess, states=guess.states * (1 + 1e-4))
    found = finding._from_guess(flow, moved)
    assert found.period == pytest.approx(slow.period, rel=1e-9)
    assert len(asked) > 2
    assert len(set(asked)) == len(asked)


def test_a_cycle_keeps_its_promises(slow: ss.results.Cycle) -> None:
    assert slow.residual < 1e-12
    assert slow.error < 1e-10
    assert abs(slow.multipliers[0] - 1) < 1e-8
    assert slow.stable
    assert 0.996 < slow.multipliers[1].real < 0.997
    tr = slow.trajectory()
    assert tr.rms(0.0) == pytest.approx(slow.rms, abs=1e-9)
    assert tr.mean(0.0) == pytest.approx(slow.mean, abs=1e-9)
    assert len(tr.events) == len(slow.events) == 4
    assert np.abs(tr.events.t - slow.events.t).max() < 1e-9
    assert -tr.y.min() == pytest.approx(slow.contact_force[1], abs=1e-4)
    assert slow.contact_force[0] == 0
    x, y, _, _ = tr(np.linspace(0, slow.period, 40001))
    force = 0.1 * (laws.spring_length(x, y, math.cos(slow.values[0]), math.sin(slow.values[0])) - 1)
    assert slow.spring_force == pytest.approx((force.min(), force.max()), abs=1e-8)


def test_both_integrators_carry_derivatives_over_a_border(slow: ss.results.Cycle) -> None:
    duration = slow.orbit.crossings()[0].t + 0.5
    directions = np.eye(8)[:2]  # of theta0 and mu0
    one, other = (
        Flow(SPRAG, name).flow_map(slow.state, slow.orbit.constants, duration, directions)
        for name in ("heyoka", "scipy")
    )
    assert [crossing.t for crossing in one.crossings] == pytest.approx(
        [crossing.t for crossing in other.crossings], abs=1e-10
    )
    assert one.crossings
    for name in ("state", "by_state", "by_parameters"):
        assert np.abs(getattr(one, name) - getattr(other, name)).max() < 1e-9


# ------------------------------------------------------------------------------------------------
# other models, closed forms


def field_of(name: str, *forces: Any) -> Field:
    """x″ = force(x, v, e), of two coordinates forces(x, y, v, w, e), with one parameter e."""
    m = 2 * len(forces)

    def slopes(q: Any, c: Any) -> list[list[Any]]:
        whole = variables((*q, *c), 1)
        return [gradient(force(*whole), m + 1) for force in forces]

    return Field(
        name,
        ("x", "y")[: len(forces)],
        ("e",),
        lambda values, xp=None: tuple(values),
        lambda q, c, mode, xp=math: [force(*q, *c) for force in forces],
        lambda q, c, mode, xp=math: [row[:m] for row in slopes(q, c)],
        lambda q, c, mode, xp=math: [row[m:] for row in slopes(q, c)],
        (),
        lambda q, c: (0,),
        ((0,),),
        lambda **_: None,
    )


VAN_DER_POL = field_of("van der Pol", lambda x, v, e: e * (1 - x * x) * v - x)


def test_the_published_period_of_van_der_pols_oscillator() -> None:
    found = cycle_near(VAN_DER_POL, (1.0,), (2.0, 0.0))
    assert found.period == pytest.approx(
        6.6632868593231301, abs=1e-12
    )  # D. Viswanath, 1997; Andersen and Geer, 1982
    x, v = found.samples.states
    damping = float((found.samples.weights() * (1 - x**2)).sum())
    assert found.multipliers[1].real == pytest.approx(
        math.exp(damping), rel=1e-9
    )  # Liouville's formula


@pytest.mark.parametrize(
    "e",
    [
        pytest.param(300.0, marks=pytest.mark.thorough),
        pytest.param(1000.0, marks=pytest.mark.validate),
    ],
)
def test_the_period_of_a_long_relaxation_oscillation(e: float) -> None:
    # J. Grasman, 1987: (3 − 2 ln 2) e + 3 a e^(−1/3) − (2/3) ln(e)/e + O(1/e), −a the first zero of
    # Airy's function.
    found = cycle_near(VAN_DER_POL, (e,), (2.0, 0.0))
    leading = (3 - 2 * math.log(2)) * e + 3 * 2.33810741 * e ** (-1 / 3) - 2 / 3 * math.log(e) / e
    assert found.period == pytest.approx(leading, abs=2 / e)
    assert abs(found.period - leading) > 1 / e > 1e3 * found.error


#: Its cycle is the circle of radius sqrt(e), its period 2 π, its multiplier exp(−2 π e).
CIRCLE = field_of("circle", lambda x, v, e: (e - x * x - v * v) * v - x)


def test_a_branch_ends_at_hopfs_bifurcation() -> None:
    found = cycle_near(CIRCLE, (0.25,), (0.5, 0.0))
    assert found.amplitude == pytest.approx(0.5, abs=1e-12)  # the circle of radius sqrt(e)
    assert found.period == pytest.approx(2 * math.pi, abs=1e-12)
    assert found.multipliers[1].real == pytest.approx(math.exp(-2 * math.pi * 0.25), rel=1e-10)
    branch = ss.cycle_branch(found, "e", between={"e": (-0.5, 0.5)})
    assert branch.amplitude == pytest.approx(np.sqrt(branch.values), abs=1e-9)
    (end, _) = branch.of("end")
    assert "equilibrium" in end.how
    assert abs(end.value) < 1e-6
    assert abs(end.value) <= end.error
    # The cycle at another value is one of the branch's own, that beyond its end is none of them.
    assert diagram._is_known_cycle([branch], cycle_near(CIRCLE, (0.16,), (0.4, 0.0)))
    assert not diagram._is_known_cycle([branch], cycle_near(CIRCLE, (0.81,), (0.9, 0.0)))


@pytest.mark.thorough
@pytest.mark.parametrize("scale", [1e-10, 1e10])
def test_an_end_has_its_error_in_the_parameters_own_unit(scale: float) -> None:
    """The circle of radius sqrt(e / scale), which ends at e = 0."""
    field = field_of(f"circle of {scale}", lambda x, v, e: (e / scale - x * x - v * v) * v - x)
    found = cycle_near(field, (0.25 * scale,), (0.5, 0.0))
    branch = ss.cycle_branch(found, "e", between={"e": (-0.5 * scale, 0.5 * scale)})
    (end, _) = branch.of("end")
    assert abs(end.value) <= end.error < 1e-6 * scale
    assert end.error > 1e-13 * scale


#: Its closed orbits are the curves v² / 2 − x² / 2 + x³ / 3 = e about x = 1, from e = −1/6 to that
#: through the saddle, e = 0.
SADDLE_LOOP = field_of(
    "saddle loop",
    lambda x, v, e: x - x * x + (e - v * v / 2 + x * x / 2 - x**3 / 3) * v,
)


@pytest.mark.thorough
def test_a_branch_ends_at_a_homoclinic_orbit() -> None:
    branch = ss.cycle_branch(
        cycle_near(SADDLE_LOOP, (-0.1,), (1.3, 0.0)),
        "e",
        between={"e": (-0.3, 0.3)},
        options=ss.BranchOptions(longest_step=0.2),
    )
    shrunk, (homoclinic,) = branch.of("end")[0], branch.of("homoclinic")
    assert "equilibrium" in shrunk.how
    assert abs(shrunk.value + 1 / 6) < min(shrunk.error, 1e-4)
    assert abs(homoclinic.value) < min(homoclinic.error, 1e-12)
    assert homoclinic.how == "it comes to rest near x = 0"
    top = branch.cycles[len(branch.cycles) // 2].state[0]
    assert top**3 / 3 - top**2 / 2 == pytest.approx(
        branch.values[len(branch.cycles) // 2], abs=1e-12
    )
    assert "CONTACT" not in str(branch.cycles[0])  # a state of two numbers is shown as it is


#: Its cycles are circles with r⁴ − 2 r² = e: two, which meet in a fold at e = −1.
TWO_CIRCLES = field_of(
    "two circles",
    lambda x, v, e: (e + 2 * (x * x + v * v) - (x * x + v * v) ** 2) * v - x,
)


@pytest.fixture(scope="module")
def folding() -> ss.results.CycleBranch:
    return ss.cycle_branch(
        cycle_near(TWO_CIRCLES, (-0.5,), (1.3, 0.0)),
        "e",
        between={"e": (-1.5, -0.4)},
        options=ss.BranchOptions(longest_step=0.3),
    )


@pytest.mark.thorough
def test_switching_at_a_fold_goes_to_its_other_side(folding: ss.results.CycleBranch) -> None:
    (fold,) = folding.of("fold")
    assert fold.value == pytest.approx(-1, abs=1e-9)
    sides = {round(folding.cycles[i].amplitude ** 2 - 1, 6) > 0 for i in (0, -1)}
    assert sides == {True, False}
    other = folding.switch(fold)
    assert (other.amplitude > 1) == (folding.cycles[-1].amplitude > 1)
    assert other.amplitude**4 - 2 * other.amplitude**2 == pytest.approx(other.values[0], abs=1e-10)


@pytest.mark.parametrize("apart", few([0.2, 0.05, 0.02], 0.05))
def test_two_folds_within_a_step_are_seen(apart: float) -> None:
    """Circles with e = s³ / 3 − apart² s, s = r² − 1.5: nothing changes its sign from one point to
    the next.
    """

    def force(x: Any, v: Any, e: Any) -> Any:
        s = x * x + v * v - 1.5
        return (e - s**3 / 3 + apart**2 * s) * v - x

    field = field_of(f"two folds, {apart} apart", force)
    begin = cycle_near(field, (0.1,), (1.5, 0.0))
    branch = ss.cycle_branch(
        begin, "e", between={"e": (-0.1, 0.15)}, options=ss.BranchOptions(longest_step=0.3)
    )
    assert sorted(fold.value for fold in branch.of("fold")) == pytest.approx(
        [-2 * apart**3 / 3, 2 * apart**3 / 3], abs=1e-9
    )


def test_where_another_branch_crosses_it_can_be_followed() -> None:
    """The circle of radius 1 beside y″ = e y − y³ − y′, whose rest y = 0 forks at e = 0 into y =
    ±√e.
    """

    fork = field_of(
        "fork",
        lambda x, y, v, w, e: (1 - x * x - v * v) * v - x,
        lambda x, y, v, w, e: e * y - y * y * y - w,
    )
    found = cycle_near(fork, (-0.1,), (1.0, 0.0, 0.0, 0.0))
    branch = ss.cycle_branch(
        found, "e", between={"e": (-0.2, 0.15)}, options=ss.BranchOptions(longest_step=0.3)
    )
    (crossing,) = branch.of("branch_point")
    assert crossing.value == pytest.approx(0, abs=1e-8)
    assert "another branch" in crossing.how
    other = branch.switch(crossing, step=0.1)
    assert other.state[1] ** 2 == pytest.approx(other.values[0], abs=1e-10)
    assert abs(other.state[1]) > 0.05
    pair = ss.cycle_branch(other, "e", between={"e": (-0.2, 0.15)})
    turn, *_ = pair.of("branch_point")  # where the pair of mirrored branches turns
    assert turn.value == pytest.approx(0, abs=1e-8)
    assert not pair.of("fold")
    assert abs(pair.switch(turn, step=0.1).state[1]) < 1e-8
    (mirrored,) = (end for end in pair.of("end") if end.how == MIRRORED)
    assert mirrored.value == pytest.approx(other.values[0], abs=1e-9)
    assert mirrored.cycle.state[1] == pytest.approx(-other.state[1], abs=1e-8)


def isola(x: Any, v: Any, e: Any) -> Any:
    """The circles with e² + s² = 0.04, s = r² − 1.5."""
    s = x * x + v * v - 1.5
    return (0.04 - e * e - s * s) * v - x


def test_an_isola_is_followed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    directions, followed = [], branches._followed

    def counted(*arguments: Any) -> Any:
        directions.append(arguments)
        return followed(*arguments)

    monkeypatch.setattr(branches, "_followed", counted)
    begin = cycle_near(field_of("isola", isola), (0.0,), (math.sqrt(1.7), 0.0))
    branch = ss.cycle_branch(
        begin, "e", between={"e": (-1, 1)}, options=ss.BranchOptions(longest_step=0.3)
    )
    assert [event.kind for event in branch.events] == ["closed", "fold", "fold"]
    assert sorted(fold.value for fold in branch.of("fold")) == pytest.approx([-0.2, 0.2], abs=1e-9)
    assert branch.of("closed")[0].value == pytest.approx(0, abs=1e-9)
    assert len(directions) == 1
    s = branch.highest**2 - 1.5
    np.testing.assert_allclose(branch.values**2 + s**2, 0.04, atol=1e-9)
    angles = np.unwrap(np.arctan2(s, branch.values))
    assert abs(angles[-1] - angles[0]) == pytest.approx(2 * math.pi, abs=1e-9)


def test_a_branch_that_comes_back_the_other_way_retraces_itself() -> None:
    own = in_scales(cycle_near(field_of("isola", isola), (0.0,), (math.sqrt(1.7), 0.0)).orbit)
    start = started(Setting(own.flow, (0,), own.period, (1.0,)), own.guess)
    steps = [corrected(start, length) for length in (-0.02, 0.02)]
    for sign, end in ((1.0, (CLOSED, CLOSES)), (-1.0, ("end", RETRACES))):
        back = returned(start.oriented(sign), *steps, between(*steps))
        assert back
        assert (back[1].kind, back[1].how) == end
    assert returned(steps[0], start, steps[1], 0.02) is None  # its value is not passed


def test_mirror_images_of_cycles() -> None:
    """About any centre, or with coordinates exchanged; two circles of one period are none."""

    def turning(field: Field, e: float, x: float, y: float) -> ss.results.Cycle:
        system = System(Flow.of(field, None), (e,))
        return finding.cycle_at(system, np.array([x, y, 0.0, 0.0]), 2 * math.pi)

    alike = field_of(
        "two alike",
        lambda x, y, v, w, e: isola(x, v, e),
        lambda x, y, v, w, e: isola(y, w, e),
    )
    outer, inner = math.sqrt(1.7), math.sqrt(1.3)
    one, beside, other = (
        turning(alike, 0.0, x, y) for x, y in ((outer, 0.0), (inner, 0.0), (0.0, outer))
    )
    assert is_mirrored(one, other)
    assert not same_cycle(one, other)
    assert not is_mirrored(one, beside)
    fork = field_of(
        "fork about y = 1",
        lambda x, y, v, w, e: (1 - x * x - v * v) * v - x,
        lambda x, y, v, w, e: e * (y - 1) - (y - 1) ** 3 - w,
    )
    up, down = (turning(fork, 1e-4, 1.0, 1 + y) for y in (0.01, -0.01))
    assert is_mirrored(up, down)
    assert not same_cycle(up, down)


def test_a_cycle_that_hardly_moves_has_a_leading_coordinate() -> None:
    """Of one of which only the speed moves by more than its error, it is a coordinate still."""
    onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V")
    for amplitude in (1e-9, 1e-10, 1e-11):
        found = ss.cycle(onset=onsets, index=1, amplitude=amplitude)
        assert found.amplitude == pytest.approx(amplitude, rel=1e-2)


@pytest.mark.thorough
def test_a_cycle_is_asked_for_at_a_tenth_of_the_amplitude_at_which_it_sticks() -> None:
    """To first order x swings with the frequency 1, and sticks where its speed reaches V."""
    onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V")
    for index, speed in enumerate(onsets.V.tolist()):
        assert ss.cycle(onset=onsets, index=index).amplitude == pytest.approx(speed / 10, rel=0.05)
        with pytest.raises(ss.errors.ConvergenceError, match=f"below {speed:.3g} do not come"):
            ss.cycle(onset=onsets, index=index, amplitude=1e3)


@pytest.mark.thorough
def test_where_a_mass_between_two_stops_ceases_to_swing_alike_and_does_so_again() -> None:
    """u(π/ω) = −u(0), and the derivative of that map by u has the eigenvalue 1. Newton's method for
    a closed orbit has no hold there, and where it fails is a matter of rounding.
    """
    stops = STOPPED + 'page.contact(d + x, lambda depth: k_c * depth, name="behind")\n'
    p = model_of(stops, "stops").Parameters(d=1.5, k_c=4.0, omega=1.2)
    cycle = ss.cycle(p, turns=1, near=(1.5, 1.0))

    def half(unknown: np.ndarray) -> np.ndarray:
        x, v, omega = unknown

        def field(t: float, u: np.ndarray) -> list[float]:
            beyond = u[0] - np.clip(u[0], -1.5, 1.5)
            force = np.cos(omega * t) - 0.1 * u[1] - u[0] - 4 * beyond
            slope = -1 - 4 * (beyond != 0)
            return [u[1], force, u[3], slope * u[2] - 0.1 * u[3], u[5], slope * u[4] - 0.1 * u[5]]

        end = solve_ivp(
            field, (0, np.pi / omega), [x, v, 1, 0, 0, 1], "DOP853", rtol=1e-12, atol=1e-13
        ).y[:, -1]
        return np.array([end[0] + x, end[1] + v, (end[2] - 1) * (end[5] - 1) - end[3] * end[4]])

    want = [fsolve(half, near)[2] for near in ((1.505, 0.08, 0.582), (1.62, 0.17, 0.681))]
    branch = ss.cycle_branch(cycle, "omega", between={"omega": (0.5, 1.25)})
    for found, exact in zip(branch.of("branch_point"), want, strict=True):
        assert found.value == pytest.approx(exact, abs=found.error + 1e-9)
        assert found.error < 1e-6
        assert "another branch" in found.how


@pytest.mark.thorough
@pytest.mark.skipif(
    not bench_auto.installed(),
    reason="AUTO-07p, a continuation code by collocation, is not installed",
)
def test_a_hopf_point_and_a_branch_of_cycles_by_auto() -> None:
    hopf, theirs, _ = bench_auto.by_auto(intervals=30)
    end, own, _ = bench_auto.ours()
    exact = bench_auto.hopf_exactly()
    assert hopf == pytest.approx(exact, abs=1e-9)
    assert end == pytest.approx(exact, abs=1e-6)
    for speed, (period, top) in own.items():
        assert theirs[speed][0] == pytest.approx(period, rel=1e-7)
        assert theirs[speed][1] == pytest.approx(top, rel=1e-4)  # AUTO's is the largest on its mesh


# ------------------------------------------------------------------------------------------------
# branches


@pytest.mark.thorough
def test_a_branch_finds_the_doubling_and_every_grazing(branch: ss.results.CycleBranch) -> None:
    (doubling,) = branch.of("period_doubling")
    (again,) = ss.cycle_branch(
        doubling.cycle,
        "theta0",
        between={"theta0": branch.to},
        options=ss.BranchOptions(located=1e-6),
    ).of("period_doubling")
    assert abs(again.value - doubling.value) <= again.error + doubling.error
    assert again.error > 100 * doubling.error  # as it is located by a wider bracket
    assert min(abs(doubling.cycle.multipliers + 1)) < 1e-8
    assert {event.how for event in branch.of("end")} == {"the range ends"}
    assert all(event.error < 1e-8 for event in branch.events)
    assert max(cycle.residual for cycle in branch.cycles) < 1e-12


@pytest.mark.thorough
def test_the_doubling_is_seen_by_simulations_on_both_sides(branch: ss.results.CycleBranch) -> None:
    (doubling,) = branch.of("period_doubling")
    for side, grows in ((-0.3, False), (0.3, True)):
        p = at(np.degrees(doubling.value) + side)
        cycle = ss.cycle(p, **BELT, near=doubling.cycle)
        assert cycle.stable != grows
        tr = moving(p, np.add(cycle.state, (0.0, 1e-4, 0.0, 0.0)), t_end=80.5 * cycle.period)
        off = [np.abs(tr(k * cycle.period)[1] - tr((k + 1) * cycle.period)[1]) for k in (10, 79)]
        assert (off[1] > off[0]) == grows


def test_a_grazing_changes_the_number_of_kinks(branch: ss.results.CycleBranch) -> None:
    (grazing,) = branch.of("grazing")
    counts = [
        len(ss.cycle(at(np.degrees(grazing.value) + side), **BELT, near=grazing.cycle).events)
        for side in (-0.02, 0.02)
    ]
    assert sorted(counts) == [4, 6]
    gap = np.abs(grazing.cycle.samples.states[2] - 0.5).min()
    assert gap < 1e-4  # between samples it is 0


@pytest.mark.thorough
def test_the_doubled_cycle_and_where_it_comes_from(branch: ss.results.CycleBranch) -> None:
    (doubling,) = branch.of("period_doubling")
    doubled = branch.switch(doubling)
    assert doubled.stable
    assert doubled.period == pytest.approx(2 * doubling.cycle.period, rel=1e-3)
    back = ss.cycle_branch(
        doubled,
        "theta0",
        between={"theta0": (np.radians(42.9), doubled.values[0] + 1e-6)},
        options=ss.BranchOptions(longest_step=0.2),
    )
    ends = [event for event in back.of("end") if "half" in event.how]
    assert ends[0].value == pytest.approx(doubling.value, abs=1e-8)
    with pytest.raises(ss.errors.ParameterError, match="no other branch"):
        branch.switch(branch.of("grazing")[0])


@pytest.mark.thorough
def test_a_doubling_in_two_parameters(branch: ss.results.CycleBranch) -> None:
    (doubling,) = branch.of("period_doubling")
    curve = ss.cycle_events(doubling, ("theta0", "mu0"), points=1)
    assert len(curve.values) == 3
    angle, friction = curve.values[-1]
    again = ss.cycle(at(np.degrees(angle), mu0=friction), **BELT, near=curve.cycles[-1])
    assert min(abs(again.multipliers + 1)) < 1e-8


@pytest.mark.parametrize("large", [1e3, 1e8, 1e10])
def test_small_multipliers_keep_their_digits_beside_large_ones(large: float) -> None:
    """Of a product of stretches in a known triangular form, turned: the product alone has lost
    them.
    """
    rng = np.random.default_rng(5)
    wanted, count = np.array([large, -1.5, 0.9, 1e-3]), 8
    roots = np.abs(wanted) ** (1 / count)
    turns = [np.linalg.qr(rng.normal(size=(5, 5)))[0] for _ in range(count)]
    parts = []
    for i in range(count):
        shares = [1.0, *(roots * ([1, -1, 1, 1] if i == 0 else 1))]
        triangular = np.diag(shares) + np.triu(rng.uniform(-0.5, 0.5, (5, 5)), 1)
        parts.append(turns[(i + 1) % count] @ triangular @ turns[i].T)
    found = multipliers.multipliers_of(
        parts, [turn[:, 0] for turn in turns]
    )  # the first direction is the flow's
    assert found.trivial == pytest.approx(1, abs=1e-12)
    assert np.abs(found.others / wanted - 1).max() < 1e-9
    assert (np.abs(found.others - wanted) <= found.errors).all()
    assert (found.errors < 1e-7 * np.abs(wanted)).all()


def test_nothing_is_concluded_from_multipliers_that_are_lost() -> None:
    """A stretch that errs along the flow by 1e-6 of its size leaves a multiplier of 1.1 beside one
    of 1e8 untold.
    """
    for large, along in ((1e8, 1e2), (1e2, 0.0)):
        stretch = np.diag([1.0, large, 1.1])
        stretch[1, 0] = along
        found = multipliers.multipliers_of([stretch], [np.array([1.0, 0.0, 0.0])])
        loop: Any = types.SimpleNamespace(multipliers=found)
        lost = abs(multipliers.criterion_of("fold", loop)) <= multipliers.unsure(loop, "fold")
        assert lost == (found.errors[1] > 0.1) == (along > 0)


MISTAKES = [
    (lambda _: ss.cycle(), "p is missing"),
    # the mistake
    (lambda _: ss.cycle(at(42.0), onset=1), "leave out p and near, or the onset"),  # type: ignore[call-overload]
    (
        lambda slow: ss.cycle(ss.load("stick_slip").Parameters(V=0.2), near=slow),
        "near is a cycle of kang_nam, not of stick_slip",
    ),
    (
        lambda slow: ss.diagram(
            at(42.0, mu0=0.4, **BELT), "theta0", between={"theta0": (0.7, 0.75)}, starts=[slow]
        ),
        "a cycle at mu0 = 0.5, the diagram",
    ),
    (
        lambda _: cycle_near(CIRCLE, (0.25,), (0.5, 0.0)).spring_force,
        "no force of this model, which has none",
    ),
    (lambda _: ss.fate_boundary(at(42.0), "theta0", between={"theta0": (0.7,)}), "is no range"),
    (lambda _: ss.basin_boundary(at(40.0), **BELT, plane=("x", "x")), "is not two of x, y, vx, vy"),
    (lambda _: ss.basin_boundary(at(40.0), **BELT, saddle=(0.0,)), "give the 2 coordinates"),
    (lambda _: ss.basin_boundary(at(45.0, mu0=0.1), **BELT, points=1), "none that grows in one"),
    (
        lambda _: ss.basin_boundary(at(45.0, mu0=0.1), **BELT, saddle=(0.7678, -0.0327)),
        "none that grows in one direction only",
    ),
]


@pytest.mark.parametrize(("call", "named"), MISTAKES)
def test_a_mistake_is_named(call: Any, named: str, slow: ss.results.Cycle) -> None:
    with pytest.raises((ss.errors.ParameterError, ss.errors.ParameterTypeError), match=named):
        call(slow)


def test_an_equilibrium_is_found_from_a_place_as_from_a_state() -> None:
    """Of a place there are no rates; ``basin_boundary`` and ``diagram`` have nothing else."""
    for p in (at(40.0), ss.load("stick_slip").Parameters()):
        system, eq = System.of(p, None), ss.equilibria(p)
        place = np.array([column[eq.states][0] for column in eq.coordinates.values()])
        found = system.equilibrium(place)
        assert found[: len(place)] == pytest.approx(place, rel=0.05)
        for rates in (np.zeros(len(place)), np.linspace(0.1, 0.3, len(place))):
            np.testing.assert_array_equal(system.equilibrium(np.concatenate([place, rates])), found)


def test_a_cycle_of_a_field_without_a_model_is_not_proved() -> None:
    pytest.importorskip("flint")
    assert (
        "can't be made again"
        in ss.precise.prove_cycle(cycle_near(CIRCLE, (0.25,), (0.5, 0.0))).reason
    )


# ---------------------------------------------------------------------------------------------
# fates and exponents


def of_call(number: int) -> tuple[ss.Parameters, dict[str, Any]]:
    """The arguments of a random call of the campaign."""
    given = random_motions.fate_of(number)
    values = dict(given["values"])
    belt = {name: values.pop(name) for name in ("V", "d")}
    vary = given["vary"]
    return ss.Parameters(**values), belt | {
        "vary": vary,
        "between": {vary: given["bracket"]},
        "start": given["start"],
    }


@pytest.mark.validate
def test_a_cycle_and_what_it_becomes_by_doubling_are_one_attractor() -> None:
    p, settings = of_call(32)
    with pytest.raises(
        ss.errors.ParameterError,
        match=r"21\.\d+ at one end and to a cycle of period 42\.\d+ at the other, which is one",
    ):
        ss.fate_boundary(p, **settings | {"between": {settings["vary"]: (0.0017, 0.0022)}})


@pytest.mark.thorough
def test_a_cycle_is_followed_on_its_own_sheet() -> None:
    """Newton's method alone finds a stable cycle of another sheet at the other value, where the one
    at hand has long halved.
    """
    first, _ = random_motions.cycle_of(252)
    assert first is not None
    branch = ss.cycle_branch(
        first, "theta0", between={"theta0": (1.15, first.parameters["theta0"])}
    )
    (last,) = (event for event in branch.of("end") if "half" in event.how)
    begun = next(
        cycle
        for cycle in branch.cycles
        if cycle.stable and abs(cycle.parameters["theta0"] - 1.33) < 0.01
    )
    values = tuple((begun.parameters | {"theta0": 1.8126515178867348}).values())
    with pytest.raises(
        ss.errors.ConvergenceError,
        match=rf"the cycle ends near theta0 = {last.value:.2f}\d* on the way",
    ):
        finding.followed_cycle(begun, values)


@pytest.mark.validate
def test_chaos_is_proved_by_exponents() -> None:
    found = ss.fate(ss.Parameters.article(theta0=0.76), V=0.25, d=20.0, t_end=60_000.0)
    assert found.kind == "chaotic", found.why
    across = np.abs(found.exponents) > 2 * found.error
    assert across.sum() == 3  # all but that of the flow
    assert found.exponents[0] > 0
    short = ss.fate(ss.Parameters.article(theta0=0.76), V=0.25, d=20.0, t_end=4000.0)
    assert short.kind == "undecided"
    assert "not told from 0" in short.why


def test_a_saddle_repels_in_exactly_one_direction(slow: ss.results.Cycle) -> None:
    assert growth_of_cycle(slow) is None
    p = ss.Parameters.article(theta0=np.radians(54.0))
    doubled = ss.cycle(p, **BELT, near=(2.326445826, 3.364354753, 0.0, 0.3058563602), patient=False)
    assert growth_of_cycle(doubled) == pytest.approx(
        np.log(abs(doubled.multipliers[1])) / doubled.period, rel=1e-9
    )


@pytest.mark.thorough
def test_exponents_of_a_cycle_are_those_of_its_multipliers(slow: ss.results.Cycle) -> None:
    found = ss.lyapunov(at(42.0), **BELT, start=slow.state, t_end=80 * slow.period)
    expected = np.sort(np.log(np.abs(slow.multipliers)) / slow.period)[::-1]
    assert found.exponents == pytest.approx(expected, abs=2e-3)
    assert found.exponents.sum() == pytest.approx(found.trace, abs=1e-9)
    assert found.t[-1] == pytest.approx(80 * slow.period)
    assert expected.sum() == pytest.approx(found.trace, abs=1e-4)
    p = ss.load("coulomb").Parameters(theta0=np.radians(42.0), V=0.41)
    stuck = ss.cycle(
        p, near=ss.cycle(p.replace(V=0.5))
    )  # it sticks once a round, which ends all deviations of its speed
    found = ss.lyapunov(p, start=stuck.state, t_end=40 * stuck.period)
    assert found.exponents[:3] == pytest.approx(
        np.log(np.abs(stuck.multipliers[:3])) / stuck.period, abs=1e-6
    )
    assert (found.exponents[3], found.trace, found.kind) == (-np.inf, -np.inf, "cycle")


def test_exponents_of_rest_are_its_eigenvalues() -> None:
    system = System(Flow.of(VAN_DER_POL, None), (-1.0,))
    first = exponents.rates_along(system, np.array([0.1, 0.0]), 103.0)
    still = first.joined(exponents.rates_along(system, first.end, 97.0))
    assert still.span == 200.0  # of stretches that are not all as long
    assert not still.moves
    assert still.exponents == pytest.approx(
        [-0.5, -0.5], abs=0.02
    )  # eigenvalues (−1 ± i √3) / 2 of the rest


#: Logarithms of growth in 24 stretches, means over six parts are 1 and −1 in turn; the error is
#: Student's quantile over √5.
SWINGS, WIDTH = np.tile(np.repeat([1.0, -1.0], 4), 3), scipy.stats.t.ppf(0.975, 5) / 5**0.5


@pytest.mark.parametrize(
    ("across", "before", "part"),
    [
        ((SWINGS,), 100.0, "is not told from 0: a longer motion"),
        ((0.0 * SWINGS,), 100.0, "errors of integration may be as large"),
        ((SWINGS - 2.5 * WIDTH,), 100.0, "all exponents but the trivial one are negative"),
        ((SWINGS + 2.5 * WIDTH,), 100.0, "deviations grow, but"),  # by more than twice the error
        ((SWINGS + 2.5 * WIDTH, SWINGS - 2.5 * WIDTH), 1.0, "it may not have settled"),
        ((SWINGS + 2.5 * WIDTH, SWINGS - 2.5 * WIDTH), 100.0, ""),
    ],
)
def test_why_exponents_prove_nothing(across: tuple[Any, ...], before: float, part: str) -> None:
    assert exponents.half_widths(SWINGS[:, None], 1.0) == pytest.approx([WIDTH])
    logs = np.array([0 * SWINGS, *across]).T
    found = exponents.Rates(logs, SWINGS, 24.0, np.zeros(25), np.zeros(2))
    assert part in found.undecided(before)
    assert bool(found.undecided(before)) == bool(part)
    assert "at rest" in dataclasses.replace(found, flow=np.full(25, -np.inf)).undecided(before)


#: x″ = e (1 − v): everything comes to the speed 1.
DRIFT = field_of("drift", lambda x, v, e: e * (1 - v))


@pytest.mark.thorough
def test_deviations_that_are_lost_in_the_shortest_stretches_are_too_stiff() -> None:
    """Of x″ = 1 − v one keeps its size and the other shrinks by exp(−t): by more than 10 in 2.44,
    which is 2⁻¹⁴ of an interval, but not in half of that, of which 4,352 are made.
    """
    system = System(Flow.of(DRIFT, None), (1.0,), ss.MotionOptions(lost=0.1, interval=4e4))
    told = r"more than 10 in 2\.44\d+ time units at x = 5\.3e\+03: too stiff"
    with pytest.raises(ss.errors.ConvergenceError, match=told):
        exponents.rates_along(system, np.array([0.0, 0.9]), 64e4)


@pytest.mark.thorough
def test_a_steady_drift_is_no_cycle_that_a_longer_motion_reaches() -> None:
    """As soon as the speed is constant over what deviations take to decay, on any scale of time."""
    for scale, (decays, drifts) in itertools.product((0.05, 10.0), ((12.0, False), (16.0, True))):
        system = System(Flow.of(DRIFT, None), (scale,))
        found = exponents.rates_along(system, np.array([0.3, 0.0]), decays / scale)
        assert found.exponents.sum() == pytest.approx(-scale)
        assert ("a steady drift" in found.undecided(0.0)) == drifts
        assert ("which a longer motion may reach" in found.undecided(0.0)) != drifts


#: x″ = e: a block on a ramp that is too steep for its friction.
RUNAWAY = field_of("runaway", lambda x, v, e: e)


@pytest.mark.thorough
@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_what_runs_away_nears_nothing(unit: float) -> None:
    """Its speed grows with the time, in units of any size; that of a steady drift no more."""
    system = System(Flow.of(RUNAWAY, None), (unit,))
    found = exponents.rates_along(system, np.array([0.0, 40.0 * unit]), 40.0)
    assert "it runs away, or settles slowly" in found.undecided(0.0)
    settled = exponents.rates_along(System(Flow.of(DRIFT, None), (1.0,)), np.array([0.3, 0.0]), 16)
    assert "runs away" not in settled.undecided(0.0)


#: x″ = e x′ − 4 x: an oscillation that grows for ever, whose speed of the state goes up and down.
GROWING = field_of("growing", lambda x, v, e: e * v - 4 * x)


@pytest.mark.thorough
def test_an_oscillation_that_grows_for_ever_runs_away() -> None:
    system, start = System(Flow.of(GROWING, None), (0.1,)), np.array([1.0, 0.0])
    for span, told in ((80.0, "may be of what grows for ever"), (200.0, "it runs away")):
        assert told in exponents.rates_along(system, start, span).undecided(0.0)
    with pytest.raises(ss.errors.ConvergenceError, match="grows beyond all bounds: it is at x"):
        exponents.rates_along(system, start, 1500.0)


@pytest.mark.thorough
def test_a_motion_that_has_lifted_off_for_good_nears_no_cycle() -> None:
    p = at(60.0, kappa=0.001)
    lifted = ss.equilibria(p, contact=False)
    (well,) = np.flatnonzero(lifted.undamped == ss.EquilibriumType.STABLE)
    start = (float(lifted.x[well]) + 0.01, float(lifted.y[well]), 0.0, 0.0)
    orbit = ss.cycle(
        p, **BELT, near=start
    )  # one of a family of closed orbits about the bottom of the well
    assert np.abs(orbit.multipliers) == pytest.approx(1.0, abs=1e-6)
    assert not orbit.stable
    found = ss.lyapunov(p, **BELT, start=start, t_end=500.0)
    assert abs(found.trace) < 1e-15  # no friction without contact
    assert found.zero.all()
    with pytest.raises(ss.errors.ParameterError, match="lift-off at both ends"):
        ss.fate_boundary(p, "theta0", between={"theta0": (1.04, 1.05)}, **BELT, start=start)


# ------------------------------------------------------------------------------------------------
# proofs and files


@pytest.mark.thorough
def test_a_proof_of_a_smooth_cycle_and_of_none(proving: types.SimpleNamespace) -> None:
    # It is crossed so early that the last bit of that time is far below those of the others.
    border = Border(
        "v = −1e-3",
        lambda q, c, m: q[1] + 1e-3,
        lambda q, a, c, m: a[0],
        lambda m: m[0],
        lambda m, *_: (-m[0],),
    )
    circle = dataclasses.replace(
        CIRCLE,
        name="cut circle",
        borders=(border,),
        modes=((1,), (-1,)),
        initial_mode=lambda q, c: (1 if q[1] > -1e-3 else -1,),
    )
    found = cycle_near(circle, (0.25,), (0.5, 0.0))
    claim = proving.proofs.claim_of(found, 12)
    with proving.ball_proof.bits(proving.ball_proof.accuracy_for(12).bits):
        proved = proving.ball_proof.proved(circle, claim)
        claim["state"][0] += 1e-3
        claim["slopes"] = [[1.0, 0.0], [0.0, 1.0]]
        with pytest.raises(proving.ball_proof.NotProved):
            proving.ball_proof.proved(circle, claim)
    assert (
        "again" in proving.proofs.prove_cycle(found).reason
    )  # no other process knows a field of this file
    assert proved["stable"] is True


@pytest.mark.by_hand("200", "60")
@pytest.mark.thorough
@pytest.mark.parametrize("digits", few([10, 60, 200], 10))
def test_printed_digits_of_a_proof_are_within_what_is_proved(
    digits: int, proving: types.SimpleNamespace
) -> None:
    """Of the circle with x = 1/2, period 2 π, multipliers 1 and exp(−π / 2): the decimals, in
    rational arithmetic.
    """
    found = cycle_near(CIRCLE, (0.25,), (0.5, 0.0))
    told = proving.proofs.proof_of(
        found, proving.ball_proof.shown(CIRCLE, proving.proofs.claim_of(found, digits))
    )
    with mpmath.workdps(digits + 40):
        truth = {
            "state_1": Fraction(1, 2),
            "state_2": Fraction(0),
            "period": exactly(2 * mpmath.pi),
            "multiplier_1": Fraction(1),
            "multiplier_2": exactly(mpmath.exp(-mpmath.pi / 2)),
        }
    beyond = Fraction(1, 10 ** (digits + 35))  # of π
    for many in (None, 1, 3, digits, digits + 9):
        for name, (text, error) in told.decimals(many).items():
            if name in truth:
                assert abs(Fraction(text) - truth[name]) <= Fraction(error) + beyond, (name, many)
    balls = {"state_1": (told.state[0], told.error), "period": (told.period, told.error)}
    balls |= {
        f"multiplier_{i}": (value.real, radius)
        for i, (value, radius) in enumerate(told.multipliers, 1)
    }
    for name, (
        value,
        radius,
    ) in balls.items():  # all of the proved ball, not only what is known to be true
        text, error = told.decimals()[name]
        assert abs(Fraction(text) - exactly(value)) + exactly(radius) <= Fraction(error)
    assert told.error < 10.0**-digits
    assert told.state[1] == 0  # the section is x' = 0, exactly
    assert told.decimals()["period"].text in str(told)


@pytest.mark.thorough
def test_balls_enclose_the_flow_over_a_border(
    slow: ss.results.Cycle, proving: types.SimpleNamespace
) -> None:
    flint, ball_flow = proving.flint, proving.ball_flow
    first, flow = slow.orbit.crossings()[0], slow.orbit.flow
    before = flow.flow_map(slow.state, slow.orbit.constants, first.t - 0.1).state
    with proving.ball_proof.bits(200):
        constants = list(
            SPRAG.constants([flint.arb(value) for value in slow.values], proving.ball_flow.XP)
        )
        off = 2.0**-40
        places = list(itertools.product(range(4), repeat=2))
        unit = flint.arb_mat(4, 4, [int(i == j) for i, j in places])

        def begun() -> Any:
            point = [flint.arb(float(value)) for value in before]
            accuracy = [ball_flow.Accuracy(40, 200)] * 2
            piece = ball_flow.Smooth(SPRAG, constants, (0, 1, 1))
            return ball_flow.Balls(piece, *accuracy, point, unit, [flint.arb(0, off)] * 4)

        balls = begun()
        balls.carry(flint.arb(0.1 - 1e-9))
        with pytest.raises(ball_flow.NotProved, match="crossed"):
            begun().cross(0, flint.arb(2e-9))  # far from the border nothing is crossed
        balls.cross(0, flint.arb(2e-9))
        balls.carry(flint.arb(0.1))
        assert balls.smooth.mode == (1, 1, 1)
        for corner in ((1, 1, 1, 1), (-1, 1, -1, 1), (0, 0, 0, 0)):
            there = flow.flow_map(before + off * np.array(corner), slow.orbit.constants, 0.2 + 1e-9)
            for value, ball in zip(there.state, balls.box, strict=True):
                assert abs(float(value - ball.mid())) <= float(ball.rad()) + 1e-13
        for place in places:
            ball = balls.matrix[place]
            assert abs(there.by_state[place] - float(ball.mid())) <= float(ball.rad()) + 1e-12
            assert float(ball.rad()) < 1e-7
        both = begun()
        both.point = [flint.arb(value) for value in (1.0, 1e-9, 0.5 - 1e-8, -0.5)]
        with pytest.raises(ball_flow.NotProved, match="x' = V is too near"):
            both.cross(0, flint.arb(1e-8))
        for wide, duration, said in (
            (off, 0.2, "the orbit meets y = 0"),
            (1e-6, 0.1 - 1e-9, "no state meets y = 0"),
        ):
            stuck = begun()
            stuck.start = [flint.arb(0, wide)] * 4
            with pytest.raises(
                ball_flow.TooWide if wide > off else ball_flow.NotProved, match=said
            ):
                stuck.carry(flint.arb(duration))  # all leave the mode on the way, or some may


def test_slopes_in_balls_are_those_that_were_derived(proving: types.SimpleNamespace) -> None:
    """Of every piece of every model, at a point; over a wide ball they hold where written-out
    powers tell nothing.
    """
    flint, ball_flow = proving.flint, proving.ball_flow
    for name in ("kang_nam", "stick_slip", "trolley", "stribeck"):
        field, model = exact_field(name), ss.load(name).search
        values = [flint.arb(model.base.get(parameter) or 0.7) for parameter in model.parameters]
        constants = list(field.constants(values, proving.ball_flow.XP))
        state = [flint.arb(0.1 + 0.03 * i) for i in range(field.size)]
        for mode in field.modes:
            found = itertools.chain(*ball_flow.Smooth(field, constants, mode).slopes(state))
            derived = itertools.chain(*field.jacobian(state, constants, mode, proving.ball_flow.XP))
            assert all(abs(a - b) < 1e-12 for a, b in zip(found, derived, strict=True))
    field = exact_field("stick_slip")
    wide = [flint.arb(0.1, 0.1), flint.arb(0.2, 0.03)]  # sticking: x' = V
    constants = list(
        field.constants([flint.arb(value) for value in (0.5, 0.1, 0.05, 0.2)], proving.ball_flow.XP)
    )
    (slopes,) = ball_flow.Smooth(field, constants, (1, 1)).slopes(wide)
    written = field.jacobian(wide, constants, (1, 1), ball_flow.XP)[0][1]
    assert abs(slopes[1]) < 20 < abs(written).upper()


@pytest.mark.thorough
def test_a_cycle_that_sticks_is_proved() -> None:
    """Where the mass sticks deviations shrink by e^−30: an enclosure that does not shrink with them
    proves nothing.
    """
    pytest.importorskip("flint")
    cycle = ss.cycle(ss.load("stick_slip").Parameters(V=0.2))
    stiff = ss.precise.prove_cycle(cycle, digits=10)
    assert stiff.proved, stiff.reason
    assert stiff.stable
    assert abs(float(stiff.period) - cycle.period) < 1e-12
    assert stiff.multipliers[1][1] < 1e-5


@pytest.mark.thorough
@pytest.mark.parametrize("low", [0.06, 0.085])
def test_a_branch_of_doubled_cycles_ends_where_its_period_halves(low: float) -> None:
    """Whatever the range: at 0.085 it went on over its end, at 0.06 it turned onto the shorter
    cycle through a fold of none.
    """
    p = ss.Parameters(
        theta0=0.9779229808598093,
        mu0=0.6404879967616784,
        kappa=0.0039780190650670795,
        alpha=0.009517221488082478,
        sigma=0.2154345917301352,
        beta=0.0,
    )
    doubled = ss.cycle(p, V=0.16784, d=7.910813740502483)
    branch = ss.cycle_branch(doubled, "V", between={"V": (low, 0.25)}, points=200)
    assert {event.kind for event in branch.events} <= {"end", "grazing"}
    assert [event.value for event in branch.of("end")] == pytest.approx(
        [0.0860932668, 0.1973199041], abs=1e-9
    )
    for end in branch.of("end"):
        assert "half" in end.how
        assert end.cycle.period == pytest.approx(20.245 if end.value < 0.1 else 19.249, abs=1e-3)
        assert min(abs(end.cycle.multipliers + 1)) < 1e-7


@pytest.mark.thorough
def test_a_torus_is_seen_by_simulations_on_both_sides() -> None:
    start = ss.cycle(
        at(60.0),
        **BELT,
        near=ss.cycle(at(90.0), **BELT, near=(2.3294, 1.34, 0.0, 0.2515), patient=False),
    )
    branch = ss.cycle_branch(
        start,
        "theta0",
        between={"theta0": (np.radians(55.5), start.values[0] + 1e-6)},
        options=ss.BranchOptions(longest_step=0.3),
    )
    (torus,) = branch.of("torus")
    one, other, _ = torus.cycle.multipliers[1:]
    assert abs(abs(one) - 1) < 1e-8
    assert one == pytest.approx(other.conjugate(), abs=1e-12)
    for side in (-0.8, 0.8):
        cycle = ss.cycle(at(np.degrees(torus.value) + side), **BELT, near=torus.cycle)
        tr = moving(
            at(np.degrees(torus.value) + side),
            np.add(cycle.state, (0.0, 1e-6, 0.0, 0.0)),
            t_end=1010.0 * cycle.period,
        )
        early, late = (
            max(np.abs(tr(k * cycle.period) - cycle.state).max() for k in range(first, first + 12))
            for first in (10, 990)
        )
        assert (late > 1.2 * early) == (side < 0)
        assert (late < 0.8 * early) == (side > 0)


def test_harmonics_of_a_cycle_are_those_of_its_closed_form() -> None:
    """Of a block that a belt carries from x = 0.2 to 0.6, and that slides back on a circle."""
    V, slip = 0.1, 0.2
    found = ss.cycle(ss.load("coulomb_stick_slip").Parameters(V=V))
    radius, carried, phase = np.hypot(slip, V), 0.4 / V, np.arctan2(V, slip)
    period = carried + 2 * np.pi - 2 * np.arctan(slip / V)

    def place(t: float) -> float:
        return 0.2 + V * t if t < carried else 0.4 + radius * float(np.cos(phase - t + carried))

    spectrum = found.spectrum()
    drawn = ss.figures.draw_spectrum(found.trajectory(3)).get_ydata()
    for k in (1, 2, 3, 30):
        weights = {"wvar": 2 * np.pi * k / period, "limit": 400, "epsabs": 1e-13}
        parts = [
            quad(place, *ends, weight=wave, **weights)[0]
            for wave in ("cos", "sin")
            for ends in ((0.0, carried), (carried, period))
        ]
        exact = 2 / period * np.hypot(parts[0] + parts[1], parts[2] + parts[3])
        assert spectrum.amplitude[k] == pytest.approx(exact, abs=1e-12)
        assert spectrum.frequency[k] == pytest.approx(k / period)
        assert k == 30 or np.asarray(drawn)[k] == pytest.approx(exact, abs=1e-11)
    t = np.linspace(0.0, found.period, 9)
    waves = np.cos(2 * np.pi * spectrum.frequency * t[:, None] + spectrum.phase)
    x = found.trajectory()(t)[0]
    np.testing.assert_allclose(found.mean + waves @ spectrum.amplitude, x, atol=1e-5)
    assert found.trajectory().after(1.0).spectrum(0.0).window == "Hann"
