"""Motions with several contacts and frictions, against closed forms and another driver."""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import lsq_linear

import spragsym as ss
from tests.oracles import two_blocks
from tests.oracles.contact_pages import BLOCKS, FALLING_BLOCKS, PAD, PADS, TIED_BLOCKS
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["scipy", "heyoka"])
def test_identical_blocks_started_alike_move_as_one(backend: str) -> None:
    """They stick and slip at one instant, each by an event of its own."""
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    model = model_of(BLOCKS, "blocks")
    for seed in range(20 if backend == "heyoka" else 3):
        values, slips, sticks = two_blocks.alike(np.random.default_rng(seed))
        p, V = model.Parameters(**values), values["V"]
        tr = ss.simulate(p, vx_10=V, vx_20=V, t_end=slips[-1], rtol=1e-12, backend=backend)
        for name in ("first", "second"):
            np.testing.assert_allclose(tr.events.of("stick").on(name).t, sticks, rtol=1e-9)
        first, second = (tr.events.of("slip").on(name).t for name in ("first", "second"))
        np.testing.assert_allclose(first, second, rtol=0, atol=1e-12)
        assert np.abs(tr.x_1 - tr.x_2).max() < 1e-11


@pytest.mark.thorough
def test_twins_started_alike_that_would_part_are_on_a_cycle_that_repels() -> None:
    """It is that of one block: it slides from where the belt lets go until it is as fast again."""

    def as_fast(_: float, u: Any) -> float:
        return u[1] - 0.2

    # SciPy reads both from the function of the event.
    as_fast.terminal, as_fast.direction = True, 1  # type: ignore[attr-defined]
    slide = solve_ivp(
        lambda _, u: [u[1], -u[0] + 1 / (1 + 3 * (0.2 - u[1]))],
        (0.0, 20.0),
        (1.0, 0.2 - 1e-12),
        events=as_fast,
        rtol=1e-10,
        atol=1e-12,
    )
    period = slide.t[-1] + (1.0 - slide.y[0, -1]) / 0.2
    p = ss.load("two_blocks").Parameters(kappa=1.0, sigma=0.5)
    found = ss.lyapunov(p, t_end=400.0)
    assert found.kind == "undecided"
    assert f"on a cycle of period {period:.6g} that repels" in found.why


@pytest.mark.parametrize(
    ("page", "seeds"),
    [
        pytest.param(page, seeds, marks=mark, id=f"{page}-{seeds.stop}")
        for mark, seeds in (
            (pytest.mark.thorough, range(2, 3)),
            (pytest.mark.validate, range(40)),
        )
        for page in ("blocks", "falling_blocks")
    ],
)
def test_random_motions_of_two_blocks_are_those_of_another_driver(page: str, seeds: range) -> None:
    """The same events in the same order, to t = 100."""
    model = model_of({"blocks": BLOCKS, "falling_blocks": FALLING_BLOCKS}[page], page)
    for seed in seeds:
        values, start = two_blocks.drawn(seed)
        driver = two_blocks.Driver(values, page == "falling_blocks")
        end = driver.run(start, 100.0)
        tr = ss.simulate(model.Parameters(**values), start=start, t_end=100.0, rtol=1e-13)
        blocks = [("first", "second").index(name) for name in tr.events.contact]
        kinds = [ss.Event(kind).name for kind in tr.events.which]
        theirs = [(kind, block) for _, kind, block in driver.events]
        assert [*zip(kinds, blocks, strict=True)] == theirs, seed
        times = [t for t, *_ in driver.events]
        np.testing.assert_allclose(tr.events.t, times, rtol=0, atol=1e-9)
        np.testing.assert_allclose(tr.state[:, -1], end, rtol=0, atol=1e-9)


@pytest.mark.thorough
def test_the_shipped_blocks_move_as_another_driver_says() -> None:
    """From rest at the base values, over a cycle and more, and at V = 0.1, where they ride with the
    belt until t = 8 and beyond.
    """
    model = ss.load("two_blocks")
    for V, t_end in ((0.2, 30.0), (0.1, 8.0)):
        p = model.Parameters(V=V)
        values = {"beta": 1.0, "kappa": 1.2, "mu_s": 1.0, "mu_k": 1 / 3, "N_1": 1.0, "N_2": 1.3}
        driver = two_blocks.Driver({**values, "V": V}, falling=True)
        end = driver.run([0.0] * 4, t_end)
        tr = ss.simulate(p, t_end=t_end, rtol=1e-13)
        assert len(tr.events.t) == len(driver.events) > 1
        np.testing.assert_allclose(tr.events.t, [t for t, *_ in driver.events], rtol=0, atol=1e-9)
        np.testing.assert_allclose(tr.state[:, -1], end, rtol=0, atol=1e-9)


def test_the_shipped_blocks_rest_within_the_closed_form() -> None:
    """|x₁| ≤ μ_s (K₂₂ N₁ + κ N₂)/det K on a belt that stands still."""
    beta, sigma, kappa = 1.4, 0.7, 0.9
    model = ss.load("two_blocks")
    found = ss.sticking_states(model.Parameters(V=0, beta=beta, sigma=sigma, kappa=kappa))
    most = (beta + sigma + sigma * kappa) / (beta + sigma + beta * sigma)
    assert found["x_1_high"] == pytest.approx([most], abs=1e-12)


def test_nothing_is_approached_along_the_set_in_which_both_blocks_are_held() -> None:
    found = ss.fate(ss.load("two_blocks").Parameters(V=0.0), start=(0.1, 0.05, 0.0, 0.0))
    assert found.exponents.tolist() == [0.0, 0.0, -math.inf, -math.inf]
    assert found.outcome.rate == math.inf


@pytest.mark.validate
def test_the_shipped_blocks_are_periodic_or_chaotic_by_the_speed_of_the_belt() -> None:
    """As their page says."""
    model = ss.load("two_blocks")
    assert [ss.fate(model.Parameters(V=V)).kind for V in (0.2, 0.1)] == ["cycle", "chaotic"]


@pytest.mark.thorough
def test_energy_changes_by_the_powers_of_all_frictions() -> None:
    model = model_of(FALLING_BLOCKS, "falling_blocks")
    values, start = two_blocks.drawn(1)
    tr = ss.simulate(model.Parameters(**values), start=start, t_end=40.0, rtol=1e-12)
    energy = tr.energy()
    assert energy[-1] - energy[0] == pytest.approx(tr.integral(tr.power()), abs=1e-9)
    assert 0 < tr.sticking_share("first") < 1
    assert np.abs(tr.friction_force("first")).max() == pytest.approx(
        values["mu_s"] * values["N_1"], abs=1e-6
    )
    with pytest.raises(ss.errors.ParameterError, match="one of 'first', 'second'"):
        tr.friction_force()


@pytest.mark.thorough
def test_what_sticks_on_a_common_bar_is_the_nearest_force_in_the_box() -> None:
    """Where both are as fast as the belt, and friction at rest is that of sliding, by Gauss: the
    forces within their limits at which M⁻¹ takes the least of what moves.
    """
    model = model_of(TIED_BLOCKS, "tied_blocks")
    rng = np.random.default_rng(11)
    modes = set()
    for _ in range(200):
        c, kappa, beta = (float(rng.uniform(*ends)) for ends in ((0.1, 3), (0, 2), (0.5, 2)))
        N, mu, x = rng.uniform(0.3, 2.0, 2), 0.5, rng.uniform(-2, 2, 2)
        p = model.Parameters(
            c=c, kappa=kappa, beta=beta, mu_s=mu, mu_k=mu, N_1=N[0], N_2=N[1], V=0.2
        )
        pull = np.array([[1 + kappa, -kappa], [-kappa, beta + kappa]]) @ x
        mobility = np.linalg.inv(np.array([[1 + c, c], [c, 1 + c]]))
        root = np.linalg.cholesky(mobility).T
        held = lsq_linear(root, root @ pull, (-mu * N, mu * N), tol=1e-14).x
        field, state = model.field, [*x, 0.2, 0.2]
        constants = field.constants(p.scalars(*model.parameters))
        mode = field.initial_mode(state, constants)
        modes.add(mode[2:4])
        got = field.acceleration(state, constants, mode, np)
        np.testing.assert_allclose(got, mobility @ (held - pull), rtol=0, atol=1e-7)
    assert len(modes) == 9


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["scipy", "heyoka"])
def test_a_mass_between_two_pads_swings_as_the_closed_form_says(backend: str) -> None:
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    model = model_of(PADS, "pads")
    rng = np.random.default_rng(3)
    for _ in range(20):
        d = float(rng.uniform(0.02, 1.0))
        v_0 = float(rng.uniform(1.5, 8.0)) * d
        v_1 = math.sqrt(v_0**2 - 2 * d**2)
        period = 4 * (math.asin(d * math.sqrt(2) / v_0) / math.sqrt(2) + math.atan(v_1 / (2 * d)))
        tr = ss.simulate(
            model.Parameters(d=d), vx0=v_0, t_end=3.2 * period, rtol=1e-12, backend=backend
        )
        for name in ("left", "right"):
            lost = tr.events.of("contact_lost").on(name).t
            assert len(lost) >= 3
            np.testing.assert_allclose(np.diff(lost), period, rtol=0, atol=1e-9)
        energy = tr.energy()
        assert np.ptp(energy) < 1e-9 * energy[0]


@pytest.mark.parametrize(
    "seeds",
    [
        pytest.param((2,), marks=pytest.mark.thorough),
        pytest.param(range(25), marks=pytest.mark.validate),
    ],
)
def test_multipliers_of_cycles_are_differences_of_the_other_drivers_motions(seeds: Any) -> None:
    """Across all sticking and slipping of both blocks."""
    pytest.importorskip("heyoka")
    model, seen = model_of(BLOCKS, "blocks"), 0
    for seed in seeds:
        values, start = two_blocks.drawn(seed)
        try:
            found = ss.cycle(model.Parameters(**values), near=start, patient=False)
        except ss.errors.ConvergenceError:
            continue
        if not {"STICK", "SLIP"} <= {ss.Event(kind).name for kind in found.events.which}:
            continue
        # The other driver begins where both slip: multipliers are the same all around the cycle.
        states = found.samples(np.linspace(0.0, found.period, 400)).T
        slips = np.abs(values["V"] - states[:, 2:]).min(axis=1)
        if slips.max() < 0.05:
            continue
        theirs = monodromy(values, states[slips.argmax()], found.period)
        told = np.sort(np.abs(np.linalg.eigvals(theirs)))
        np.testing.assert_allclose(np.sort(np.abs(found.multipliers)), told, rtol=0, atol=1e-4)
        seen += 1
    assert seen >= len(seeds) // 4


@pytest.mark.thorough
def test_a_damped_pad_comes_to_the_equilibrium_of_its_combination() -> None:
    """On both legs, and on the front one alone, by the same index as among the equilibria."""
    text = (
        PAD
        + "\npage.damper(b, along=x)\npage.damper(b, along=y)\npage.damper(b * a**2, along=phi)\n"
    )
    text = text.replace(
        "x = page.coord",
        'b = page.parameter("b", "N s/m", "damping", ">= 0", 3.0)\nx = page.coord',
        1,
    )
    model = model_of(text, "damped_pad")
    for mu, touching in ((0.3, "front, rear"), (1.6, "front")):
        p = model.Parameters(mu0=mu, V=0.5)
        tr = ss.simulate(p, phi0=0.01, t_end=400.0)
        out, eq = tr.outcome(), ss.equilibria(p)
        assert out.regime in (ss.Regime.EQUILIBRIUM, ss.Regime.APPROACHES_EQUILIBRIUM)
        assert eq["touching"][out.equilibrium] == touching
        rest = [eq[name][out.equilibrium] for name in model.coordinates]
        assert out.rest == pytest.approx(rest, abs=1e-9)
        lifts = tr.contact_force("rear")[-1]
        assert (lifts == 0) == (touching == "front")


def monodromy(values: dict[str, float], state: Any, period: float) -> Any:
    """Derivatives of the other driver's motion by its start, as central differences."""
    step = 1e-6
    ends = [
        two_blocks.Driver(values).run((state + sign * step * unit).tolist(), period)
        for unit in np.eye(4)
        for sign in (1, -1)
    ]
    return np.array([(a - b) / (2 * step) for a, b in zip(ends[::2], ends[1::2], strict=True)]).T


@pytest.mark.validate
def test_a_branch_loses_its_stability_where_the_other_drivers_multiplier_is_minus_1() -> None:
    pytest.importorskip("heyoka")
    model = model_of(BLOCKS, "blocks")
    values, start = two_blocks.drawn(2)
    found = ss.cycle(model.Parameters(**values), near=start)
    branch = ss.cycle_branch(found, "V", between={"V": (0.105, 0.117)})
    (doubling,) = branch.of("period_doubling")
    for cycle in (doubling.cycle, *branch.cycles[::12]):
        here = {**values, "V": float(cycle.values[model.parameters.index("V")])}
        end = two_blocks.Driver(here).run(cycle.state.tolist(), cycle.period)
        np.testing.assert_allclose(end, cycle.state, rtol=0, atol=1e-9)
        told = np.linalg.eigvals(monodromy(here, cycle.state, cycle.period))
        least = float(told.real.min())
        assert min(cycle.multipliers.real) == pytest.approx(least, abs=1e-4)
        if cycle is doubling.cycle:
            assert least == pytest.approx(-1, abs=1e-4)


@pytest.mark.thorough
def test_sweeps_and_basins_tell_what_motions_tell() -> None:
    pytest.importorskip("heyoka")
    model = model_of(BLOCKS, "blocks")
    values, start = two_blocks.drawn(2)
    given = dict(zip(("x_10", "x_20", "vx_10", "vx_20"), start, strict=True))
    p = model.Parameters(**values | {"V": np.array([0.13, 0.15])})
    sweep = ss.rms_sweep(p, **given, t_end=400.0, workers=1)
    for row, V in enumerate(p.V):
        tr = ss.simulate(model.Parameters(**values | {"V": V}), start=start, t_end=400.0)
        assert sweep["rms"][row] == pytest.approx(tr.rms(300.0), rel=1e-8)
        assert sweep["period"][row] == pytest.approx(tr.outcome(300.0).period, rel=1e-9)
        late = two_blocks.Driver(values | {"V": float(V)})
        fates = ss.fate_map(p, start=start)
        assert fates.period[row] == pytest.approx(sweep["period"][row], rel=1e-9)
        end = late.run(sweep_state(sweep, row), float(sweep["period"][row]))
        assert end == pytest.approx(sweep_state(sweep, row), abs=1e-8)
    basin = ss.basin(
        model.Parameters(**values | {"V": 0.15}), x_1=[0.1, 0.5], vx_1=[0.0], t_end=400.0, workers=1
    )
    assert basin.attractor.ravel().tolist() == [0, 0]


def sweep_state(sweep: Any, row: int) -> list[float]:
    """The state of the cycle that a motion of a sweep comes to."""
    names = ("x_1", "x_2", "vx_1", "vx_2")
    return [float(sweep[f"cycle_{name}"][row]) for name in names]


#: A law that falls with the speed, friction 1/(1 + γ v), and β times that on the other block;
#: parameters of our own choice, in the form that two-block models have in the literature.
FAULT = {"beta": 1.0, "kappa": 1.2, "mu_s": 1.0, "mu_k": 1 / 3, "N_1": 1.0, "N_2": 1.3}


@pytest.mark.parametrize(
    ("V", "t_end", "kind"),
    [
        pytest.param(0.12, 400.0, "cycle", marks=pytest.mark.thorough),
        pytest.param(0.1, 12_000.0, "chaotic", marks=pytest.mark.validate),
    ],
)
def test_exponents_of_two_blocks_are_those_of_the_other_drivers_neighbours(
    V: float, t_end: float, kind: str
) -> None:
    """Neighbours part where an exponent is positive, and come together where all are not; two end
    whenever both blocks stick.
    """
    pytest.importorskip("heyoka")
    model, start = model_of(FALLING_BLOCKS, "falling_blocks"), [0.1, 0.3, 0.0, 0.05]
    found = ss.lyapunov(model.Parameters(**FAULT, V=V), start=start, t_end=t_end)
    assert found.kind == kind
    assert np.isneginf(found.exponents).sum() == 2
    begun = found.end.tolist()
    span = 120.0 if kind == "cycle" else 600.0
    values = {**FAULT, "V": V}
    one, other = (
        two_blocks.Driver(values, True).run([begun[0] + off, *begun[1:]], span) for off in (0, 1e-9)
    )
    apart = float(np.abs(one - other).max())
    if kind == "cycle":
        assert apart < 2e-9  # along the cycle nothing shrinks
        assert found.exponents[1] < -0.05
    else:
        assert apart > 1e-6
        assert found.exponents[0] > found.error[0]
