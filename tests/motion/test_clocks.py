"""Motions and cycles of what varies in time, against closed forms and integrations by SciPy."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from spragsym.core.errors import ConvergenceError, ModelError, ParameterError
from spragsym.core.questions import FORCED
from spragsym.derive.model import PageError
from spragsym.motion.problem import Event, check_stiffness, prepare
from tests.conformance.models import answers
from tests.conformance.test_questions import TABLE, Asked, questions
from tests.oracles import clocks
from tests.oracles.clocks import DUFFING, FRICTION, MOVED, duffing_fold, stopping_amplitude
from tests.oracles.user_pages import model_of, replaced


def off(motion: ss.results.Trajectory, field: Callable[[float, np.ndarray], list[float]]) -> float:
    """Difference of a motion from one by SciPy, from its beginning."""
    from scipy.integrate import solve_ivp

    n = len(motion.state) // 2 - 1
    rows = [*range(n), *range(n + 1, 2 * n + 1)]
    begin = motion.state[rows, 0]
    found = solve_ivp(field, (0, motion.t[-1]), begin, "DOP853", rtol=1e-12, atol=1e-12)
    return float(np.abs(found.y[:, -1] - motion.state[rows, -1]).max())


@pytest.mark.thorough
def test_what_slides_under_a_harmonic_force_has_the_closed_form_of_den_hartog() -> None:
    """Without stops: Forced vibrations with combined Coulomb and viscous friction, 1931."""
    model = model_of(FRICTION, "forced")
    for omega, f in ((0.7, 0.5), (1.4, 0.8), (2.5, 1.2)):
        found = ss.cycle(model.Parameters(omega=omega, f=f), turns=1)
        size, turned = 1 / (1 - omega**2), np.pi / omega
        slowed = np.sin(turned) / (omega * (1 + np.cos(turned)))
        exact = np.sqrt(size**2 - (0.4 * f * slowed) ** 2)
        assert found.amplitude == pytest.approx(exact, rel=1e-9)
        assert found.period == pytest.approx(2 * np.pi / omega, rel=1e-12)
        # Beside that of time the two of the stroboscopic map: where friction turns around areas
        # shrink by the square of the accelerations' ratio.
        trivial, *others = found.multipliers
        assert abs(trivial - 1) < 1e-12
        pull = exact * omega**2
        ratio = (pull - 0.4 * f) / (pull + 0.4 * f)
        assert np.prod(others).real == pytest.approx(ratio**2, rel=1e-9)
        rate = -np.log(ratio) / found.period
        motion = ss.simulate(model.Parameters(omega=omega, f=f), t_end=1000.0)
        assert motion.outcome().rate == pytest.approx(rate, rel=1e-8)


@pytest.mark.thorough
def test_what_nears_a_cycle_that_turns_around_on_a_floor_is_seen_to() -> None:
    model = model_of(FRICTION, "forced")
    for t_end in (100.0, 140.0):
        motion = ss.simulate(model.Parameters(omega=0.7), t_end=t_end)
        assert motion.outcome().regime == ss.Regime.APPROACHES_CYCLE
    found = ss.lyapunov(model.Parameters(omega=0.33), t_end=2000.0)
    assert found.end[2] == 0.0
    assert "steady drift" not in found.why  # the clock alone moves on there


@pytest.mark.thorough
def test_what_sticks_at_both_turns_is_put_together_from_its_pieces() -> None:
    model = model_of(FRICTION, "forced")
    for omega in (0.3, 0.35):
        found = ss.cycle(model.Parameters(omega=omega), turns=1)
        exact = stopping_amplitude(omega, 0.2, (0.98 * found.amplitude, 0.3 * found.period))
        assert found.amplitude == pytest.approx(exact, rel=1e-9)
        assert found.stable
        begin = {"x0": found.state[0] + 1e-5, "phase0": found.state[1]}
        later = ss.simulate(
            model.Parameters(omega=omega), vx0=found.state[2], t_end=found.period, **begin
        )
        after = 1e-5 * np.abs(found.multipliers[1])
        assert abs(later.x[-1] - found.state[0]) < 1.1 * after + 1e-8


def test_what_the_force_does_not_move_sticks() -> None:
    model = model_of(FRICTION, "forced")
    motion = ss.simulate(model.Parameters(f=2.6), x0=0.01, phase0=0.4, t_end=30.0)
    assert np.abs(motion.x - 0.01).max() < 1e-15
    assert motion.phase[-1] == pytest.approx(0.4 + 0.6 * 30, abs=1e-12)


@pytest.mark.thorough
def test_folds_of_the_resonance_of_duffing_are_those_of_the_stroboscopic_map() -> None:
    p = model_of(DUFFING, "duffing").Parameters(omega=0.9)
    branch = ss.cycle_branch(ss.cycle(p, turns=1), "omega", between={"omega": (0.8, 2.0)})
    folds = [event for event in branch.events if event.kind == "fold"]
    assert len(folds) == 2

    for event in folds:
        exact = duffing_fold(0.1, 0.05, event.cycle, event.value)
        assert event.value == pytest.approx(exact, rel=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize(("backend", "turns"), [("scipy", 0), ("heyoka", 0), ("heyoka", 1e5)])
def test_a_motion_with_everything_that_follows_the_clock(backend: str, turns: float) -> None:
    """Also where the phase is so large that a step, relative to it, has too large an error."""
    model, phase = model_of(MOVED, "moved"), 2 * math.pi * turns
    start = {"x0": 0.6, "vx0": -0.3, "phase0": phase}
    motion = ss.simulate(model.Parameters(), t_end=40.0, backend=backend, **start)
    assert motion.phase[[0, -1]] == pytest.approx([phase, phase + 40 * 0.6], rel=1e-14)
    assert len(motion.events.of(Event.CONTACT_LOST)) > 2
    assert off(motion, clocks.moved) < 1e-8
    cycle = ss.cycle(model.Parameters(), turns=1)
    assert cycle.stable
    begun = {"x0": cycle.state[0], "vx0": cycle.state[2], "phase0": cycle.state[1]}
    once = ss.simulate(model.Parameters(), t_end=cycle.period, **begun)
    assert np.abs(once.state[[0, 2], -1] - cycle.state[[0, 2]]).max() < 1e-9


@pytest.mark.thorough
def test_where_the_period_has_doubled_other_turns_are_named() -> None:
    p = model_of(clocks.STOPPED, "stopped").Parameters(omega=0.9856, c=0.21, d=-0.243, k_c=9.27)
    with pytest.raises(ConvergenceError, match=r"turns = 1 of the clock.* after 2$"):
        ss.cycle(p, turns=1)
    found = ss.cycle(p, turns=2)
    x, phase, v, omega = found.state
    begin = phase / omega
    values = {name: float(p[name]) for name in p.model.parameters}
    after = clocks.stopped(values, x, v, begin, begin + found.period)
    assert np.abs(np.subtract(after, [x, v])).max() < 1e-9
    halfway = clocks.stopped(values, x, v, begin, begin + found.period / 2)
    assert np.abs(np.subtract(halfway, [x, v])).max() > 0.1


@pytest.mark.thorough
def test_the_energy_changes_by_the_work_of_the_clock_too() -> None:
    for text, name in ((FRICTION, "forced"), (DUFFING, "duffing")):
        motion = ss.simulate(model_of(text, name).Parameters(), x0=0.3, t_end=50.0)
        change = motion.energy()[-1] - motion.energy()[0]
        assert abs(change - motion.integral(motion.power())) < 1e-7


@pytest.mark.thorough
def test_exponents_and_rates_of_a_linear_response_are_those_without_its_force() -> None:
    """Roots of λ² + c λ + 1 = 0, and 0 of time; none of the clock's rate, which is given."""
    model = model_of(DUFFING, "duffing")
    for c in (0.1, 1.5, 3.0):
        p = model.Parameters(c=c, g=0.0)
        roots = np.sort(np.roots([1, c, 1]).real)[::-1]
        fate = ss.fate(p)
        assert (fate.kind, fate.trivial) == ("cycle", 0)
        assert (np.abs(fate.exponents - [0.0, *roots]) <= fate.error + 1e-9).all()
        swept = ss.rms_sweep(p, t_end=400.0)
        assert float(swept.rate) == pytest.approx(-roots[0], rel=1e-6)
        assert int(swept.equilibrium) == -1
        assert not any(name.startswith("mean_") for name in swept.measured)  # the phase has none
        measured = ss.lyapunov(p, t_end=400.0)
        assert measured.exponents.sum() == pytest.approx(-c, rel=1e-9)
        assert (np.abs(measured.exponents - [0.0, *roots]) < 2 * measured.error + 1e-9).all()


def test_fates_over_the_frequency_begin_at_any_phase() -> None:
    p = model_of(DUFFING, "duffing").Parameters(g=0.0, omega=np.array([0.7, 1.4]))
    for start in (None, (0.3, 0.1), (0.3, 1.0, 0.1)):
        found = ss.fate_map(p, start=start)
        assert found.count()["cycle"] == 2
        np.testing.assert_allclose(found.period, 2 * np.pi / p.omega, rtol=1e-9)
        np.testing.assert_allclose(found.exponent, -0.05, rtol=1e-9)
    with pytest.raises(ParameterError, match="the rate of the clock"):
        ss.fate(p.replace(omega=0.7), start=(0.3, 0.0, 0.1, 0.9))


@pytest.mark.thorough
def test_the_resonance_of_friction_that_holds_is_that_of_den_hartog() -> None:
    """Sliding without a stop as far as ω² A > μ f, where what turns at A does not rest; below it
    the mass stops at both turns.
    """
    model, force = model_of(FRICTION, "forced"), 0.6

    def sliding(omega: float) -> float:
        S = math.sin(math.pi / omega) / (omega * (1 + math.cos(math.pi / omega)))
        return math.sqrt(1 / (1 - omega**2) ** 2 - (force * S) ** 2)

    begun = ss.cycle(model.Parameters(omega=0.7, f=1.5, mu=0.4), turns=1)
    branch = ss.cycle_branch(begun, "omega", between={"omega": (0.5, 0.9)}, points=60)
    assert [end.how for end in branch.of("end")] == ["the range ends"] * 2
    edge = brentq(lambda omega: omega**2 * sliding(omega) - force, 0.6, 0.7, xtol=1e-14)
    turns = branch.of("crossing-sliding")
    assert [turn.value for turn in turns] == pytest.approx([edge] * 2, abs=1e-9)
    stops = branch.values < edge
    assert 10 < stops.sum() < len(branch.values) - 10
    half = (branch.highest - branch.lowest) / 2
    exact = [
        stopping_amplitude(omega, force, (amplitude, 0.9 * math.pi / omega))
        if at
        else sliding(omega)
        for omega, amplitude, at in zip(branch.values, half, stops, strict=True)
    ]
    np.testing.assert_allclose(half, exact, rtol=1e-9)


@pytest.mark.thorough
def test_what_friction_holds_in_every_phase_rests_for_good() -> None:
    """P cos φ − k x is all that friction holds: it needs |x| + 1 of μ f."""
    model, rng = model_of(FRICTION, "forced"), np.random.default_rng(79)
    for share in (0.9, 0.999, 1.001, 1.1) * 3:
        x, omega, mu = rng.uniform(-2, 2), rng.uniform(0.3, 3), rng.uniform(0.2, 0.8)
        p = model.Parameters(omega=omega, mu=mu, f=share * (abs(x) + 1) / mu)
        # Pulled as far as it can be the other way, it sticks at first.
        start = (x, np.pi * (x < 0), 0.0) if share > 1 else (x, 0.5, 0.0)
        found = ss.fate(p, start=start, t_end=50.0)
        if share > 1:
            assert (found.kind, found.trivial) == ("rest", 0)
            np.testing.assert_allclose(found.outcome.rest, x, atol=1e-10)
            assert found.exponents.tolist() == [0.0, 0.0, -np.inf]
        elif found.kind == "rest":  # it may have slid to where it is held
            (there,) = found.outcome.rest
            assert abs(there) + 1 < p.mu * p.f
    far = model.Parameters(f=5000.0, omega=3.0)  # units of 4096
    assert ss.fate(far, start=(1000.0, 0.0), t_end=50.0).kind == "rest"


def test_a_belt_that_moves_or_a_normal_force_that_gives_way_leaves_nothing_at_rest() -> None:
    """The needed share, (|x| + cos φ) over μ f (1 − cos φ / 2), is largest where φ is 0."""
    page = replaced(
        FRICTION,
        ("page.normal_force(f)", "page.normal_force(f * (1 - cos(phase) / 2))"),
        ("page.friction(x, 0,", "page.friction(x, V,"),
        ("f = page", 'V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.0)\nf = page'),
    )
    model, x = model_of(page, "given_way"), -0.2
    for share, V in ((1.01, 0.0), (0.99, 0.0), (1.01, 1e-3), (1.01, 1e-13)):
        p = model.Parameters(f=share * 2 * (1 - x) / 0.4, mu=0.4, V=V)
        found = ss.fate(p, start=(x, 2.0, V), t_end=2.0)
        assert (found.kind == "rest") == (share > 1 and V == 0)
    short = ss.fate(model_of(DUFFING, "duffing").Parameters(), start=(3.0, 0.0), t_end=2.0)
    assert short.kind == "undecided"  # nothing could hold it


@pytest.mark.thorough
def test_basins_of_duffing_are_those_of_motions_by_scipy() -> None:
    """Between its folds it swings far or little, by where it begins."""
    from scipy.integrate import solve_ivp

    model, omega = model_of(DUFFING, "duffing"), 1.4
    x, v = np.linspace(-4, 4, 5), np.linspace(-4, 4, 5)
    found = ss.basin(model.Parameters(omega=omega), x=x, vx=v, t_end=400.0, workers=1)
    assert [regime for regime, *_ in found.attractors] == [ss.Regime.LIMIT_CYCLE] * 2
    spreads = [spread for *_, spread in found.attractors]
    for row, column in np.ndindex(found.attractor.shape):
        late = solve_ivp(
            lambda t, u: [u[1], np.cos(omega * t) - 0.1 * u[1] - u[0] - 0.05 * u[0] ** 3],
            (0, 200 * 2 * np.pi / omega),
            [x[row], v[column]],
            "DOP853",
            t_eval=(199 + np.arange(64) / 64) * 2 * np.pi / omega,
            rtol=1e-9,
        ).y[0]
        assert late.std() == pytest.approx(spreads[found.attractor[row, column]], rel=1e-3)


@pytest.mark.thorough
def test_folds_of_duffing_over_frequency_and_damping_are_those_by_shooting() -> None:
    p = model_of(DUFFING, "duffing").Parameters(omega=0.9)
    branch = ss.cycle_branch(ss.cycle(p, turns=1), "omega", between={"omega": (0.8, 2.0)})
    curve = ss.cycle_events(branch.of("fold")[0], ("omega", "c"), points=4)
    assert len(curve.cycles) > 6
    for (omega, c), cycle in zip(curve.values, curve.cycles, strict=True):
        assert omega == pytest.approx(duffing_fold(c, 0.05, cycle, omega), rel=1e-8)


@pytest.mark.thorough
def test_a_forced_double_well_is_irregular_where_neighbours_part() -> None:
    """Of two motions by SciPy that begin 1e-9 apart, as the largest exponent says."""
    from scipy.integrate import solve_ivp

    text = replaced(DUFFING, ("page.spring(k, along=x)", "page.potential(-k * x**2 / 2)"))
    p = model_of(text, "double_well").Parameters(omega=1.0, c=0.15, g=0.09)
    found = ss.lyapunov(p, t_end=4000.0)
    assert found.kind == ss.fate(p, t_end=4000.0).kind == "chaotic"
    assert found.exponents.sum() == pytest.approx(-0.15, rel=1e-9)

    def field(t: float, u: np.ndarray) -> list[float]:
        return [u[1], np.cos(t) - 0.15 * u[1] + u[0] - 0.09 * u[0] ** 3]

    x, phase, v, _ = found.end
    span, rates = 60.0, []
    for _ in range(20):
        states = [
            solve_ivp(field, (phase, phase + span), begun, "DOP853", rtol=1e-12, atol=1e-13).y
            for begun in ([x, v], [x + 1e-9, v])
        ]
        x, v = states[0][:, -1]
        phase += span
        rates.append(np.log(np.abs(states[1][:, -1] - states[0][:, -1]).max() / 1e-9) / span)
    assert np.mean(rates) == pytest.approx(found.exponents[0], abs=0.05)


def test_a_motion_on_a_repelling_cycle_of_a_clock_is_not_chaotic() -> None:
    """A stiffness that varies, in its first tongue: what begins beside rest doubles the period."""
    text = replaced(DUFFING, ("P * cos(phase)", "-k * x * cos(phase) / 3"))
    p = model_of(text, "swing").Parameters(omega=2.0)
    fate, exponents = ss.fate(p, t_end=1000.0), ss.lyapunov(p, t_end=400.0)
    assert fate.kind == exponents.kind == "undecided"
    assert "begins 1e-06 beside it comes to a cycle of period 6.28319" in fate.why
    assert "it is on a cycle of period 3.14159 that repels" in exponents.why
    monodromy = [clocks.swung(start, 2.0, 0.1, 1 / 3) for start in ((1.0, 0.0), (0.0, 1.0))]
    expected = np.sort(np.log(np.abs(np.linalg.eigvals(monodromy))) / np.pi)  # Mathieu's equation
    off = np.abs(fate.exponents[[2, 0]] - expected)
    assert (off < fate.error[[2, 0]]).all()


def test_a_fast_clock_is_judged_after_some_turns_and_is_not_stiff() -> None:
    """Of what slides without a stop Den Hartog's amplitude; the clock's own rate is no decay."""
    model, omega = model_of(FRICTION, "forced"), 1e3
    p = model.Parameters(omega=omega)
    found = ss.fate(p)
    assert (found.kind, found.t) == ("cycle", pytest.approx(200 * np.pi / omega))
    slowed = 0.2 * np.sin(np.pi / omega) / (omega * (1 + np.cos(np.pi / omega)))
    exact = np.sqrt(1 / (1 - omega**2) ** 2 - slowed**2)
    assert found.outcome.cycle[0] == pytest.approx(exact, rel=1e-6)
    problem = prepare(model, p, start=(0.0, 0.0, 0.0, omega), t_end=2000.0, rtol=1e-12)
    check_stiffness(problem, (0.0, 0.0, 1e-4, omega), 1.5e-3, 2000.0)  # would raise StiffError


def test_what_is_not_answered_of_a_clock_says_so() -> None:
    p = model_of(DUFFING, "duffing").Parameters()
    for ask in (ss.equilibria, ss.folds, ss.basin_boundary, ss.sticking_states):
        with pytest.raises(ModelError, match="has a clock"):
            ask(p)
    with pytest.raises(ParameterError, match="the rate of the clock"):
        ss.simulate(p, vphase0=0.3)
    with pytest.raises(ParameterError, match="no clock"):
        ss.cycle(ss.load("stick_slip").Parameters(), turns=1)


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ("P * cos(phase)", "P * phase", "not all is as before after a turn of phase"),
        ("m * page.rate(x)", "m * (1 + cos(phase) / 9) * page.rate(x)", "holds the clock"),
        ("page.clock(omega)", "page.clock(omega - 1 / page.rate(x))", "depends on vx"),
        ('"> 0", 0.6', '">= 0", 0.6', "may be 0 or negative"),
        ("page.clock(omega)", "(page.clock(omega), page.clock(omega, 's'))[0]", "a clock already"),
    ],
)
def test_what_a_clock_cannot_stand_in_is_refused_by_its_line(
    before: str, after: str, words: str, tmp_path: Path
) -> None:
    from spragsym.derive import pages

    (tmp_path / "mine.py").write_text(replaced(DUFFING, (before, after)), encoding="utf-8")
    with pytest.raises(PageError, match=rf"line \d+: .*{words}"):
        pages.read(tmp_path / "mine.py")


def test_what_is_not_answered_of_a_clock_is_refused_by_its_name() -> None:
    """Every public question is answered, or says that nothing rests there and what is asked
    instead.
    """
    model = model_of(DUFFING, "duffing")
    p, plane = model.Parameters(), ("c", "g")
    ranges = {"c": (0.1, 0.2), "g": (0.0, 1.0)}
    asked: dict[str, Callable[[], object]] = {
        "basin_boundary": lambda: ss.basin_boundary(p),
        "bifurcation_set": lambda: ss.bifurcation_set(p, plane),
        "certify": lambda: ss.certify(p, vary="c"),
        "count": lambda: ss.count(p),
        "critical_friction": lambda: ss.critical_friction(p, *plane),
        "critical_value": lambda: ss.critical_value(p, "omega", between=ranges),
        "cusp_friction": lambda: ss.cusp_friction(p, *plane),
        "cusps": lambda: ss.cusps(p, plane),
        "diagram": lambda: ss.diagram(p, "c", between=ranges),
        "equilibria": lambda: ss.equilibria(p),
        "explore": lambda: ss.explore(p),
        "fate_boundary": lambda: ss.fate_boundary(p, "c", between=ranges),
        "flutter_onsets": lambda: ss.flutter_onsets(p, "c"),
        "folds": lambda: ss.folds(p, "c"),
        "jump_gradient": lambda: ss.jump_gradient(p, "c"),
        "jump_margin": lambda: ss.jump_margin(p, {"c": 0.1}),
        "jump_probability": lambda: ss.jump_probability(ranges, model=model),
        "jump_value": lambda: ss.jump_value(p, "c"),
        "onset_curves": lambda: ss.onset_curves(p, plane),
        "quasi_static_path": lambda: ss.quasi_static_path(p, "c", [0.1, 0.2]),
        "redesign": lambda: ss.redesign(p, "c", {"g": 0.1}),
        "sticking_states": lambda: ss.sticking_states(p),
    }
    of_article = TABLE[Asked.article].split()
    of_matrices = {"modes"}
    assert {*questions()} - {*of_article, *FORCED, *of_matrices} == {*asked}
    for name, ask in asked.items():
        assert not answers(model, name, ask)
    with pytest.raises(ModelError, match="has no theta0, along which sensitivity looks"):
        ss.sensitivity(p)


def test_basins_and_sweeps_tell_what_is_held_in_every_phase() -> None:
    """Of a start at rest at x it is held for good where |x| + 1 <= μ f: one attractor, an interval;
    beyond, the mass slips until it is there.
    """
    p = model_of(FRICTION, "forced").Parameters(f=5.0)
    x = np.linspace(-0.98, 0.98, 7)
    found = ss.basin(p, x=x, vx=[0.0], t_end=50.0, workers=1)
    assert [regime for regime, *_ in found.attractors] == [ss.Regime.EQUILIBRIUM]
    assert (found.attractor == 0).all()
    assert not found.remarks
    np.testing.assert_allclose(found.sweep["rest_x"][:, 0], x, atol=1e-12)
    one = found.sweep.outcome((0, 0))
    assert one.rest == pytest.approx([x[0]], abs=1e-12)
    assert (one.equilibrium, one.distance, one.rate) == (-1, 0.0, np.inf)
    for share in (0.999, 1.001):
        swept = ss.rms_sweep(p.replace(f=share * 1.5 / p.mu), x0=0.5, phase0=np.pi, t_end=1.0)
        assert (int(swept.regime) == ss.Regime.EQUILIBRIUM) == (share > 1)
    beside = ss.simulate(p, x0=0.3, t_end=50.0).outcome()
    assert beside.regime == ss.Regime.EQUILIBRIUM
    assert beside["rest_x"] == pytest.approx(0.3, abs=1e-12)


@pytest.mark.thorough
def test_what_holds_two_masses_is_told_in_any_units() -> None:
    """Of friction along 1e-20 of a displacement, pressed 1e20 times as hard, and of none along it
    the mass is held where its spring pulls by less than that, and moves on.
    """
    second = """
y = page.coordinate("y", "m", "of the second")
phase = page.clock(omega)"""
    page = replaced(
        FRICTION,
        ("\nphase = page.clock(omega)", second),
        ("* page.rate(x) ** 2 / 2", "* (page.rate(x) ** 2 + page.rate(y) ** 2) / 2"),
        ("page.normal_force(f)", "one = page.normal_force(f, name='one')\npage.spring(k, along=y)"),
        ("holds=mu)", "holds=mu, on=one)"),
    )
    small = (
        page
        + """
other = page.normal_force(f * 1e20, name="other")
page.friction(y * 1e-20, 0, slip=lambda v: mu * sgn(v), holds=mu, on=other)
"""
    )
    free = page + 'page.normal_force(f, name="other")\n'
    regimes = [
        ss.simulate(
            model_of(text, name).Parameters(f=5.0), start=[0.3, 0.2, 0.0, 0.0], t_end=50.0
        ).outcome()
        for text, name in ((small, "small"), (free, "free"))
    ]
    assert [one.regime == ss.Regime.EQUILIBRIUM for one in regimes] == [True, False]
    p, start = model_of(free, "free").Parameters(f=5.0), [0.3, 0.2, 0.0, 0.0]
    mean = ss.simulate(p, start=start, t_end=50.0)(np.linspace(10.0, 50.0, 40_001))[1].mean()
    sweep = ss.rms_sweep(p, x0=0.3, y0=0.2, t_end=50.0, transient=10.0)
    assert float(sweep["mean_y"]) == pytest.approx(mean, abs=1e-4)
