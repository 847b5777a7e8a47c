"""Dry friction that holds: sticking as a mode of the motion, against closed forms."""

import math

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.field import FLOATS
from spragsym.orbits.branch import FAMILIES
from tests.oracles import dry_friction
from tests.oracles.user_pages import alone

STICK_SLIP = ss.load("coulomb_stick_slip")
BACKENDS = ("heyoka", "scipy")


def exact(mu_s: float, mu_k: float, V: float) -> tuple[float, float, float]:
    """Period, half of the range of x, and share of sticking of stick-slip."""
    drop = max(mu_s - mu_k, 0.0)
    period = 2 * drop / V + 2 * math.pi - 2 * math.atan(drop / V)
    return period, math.hypot(drop, V), 2 * drop / V / period


@pytest.mark.parametrize(("backend", "trials"), [("heyoka", 200), ("scipy", 3)])
def test_stick_slip_has_the_period_the_range_and_the_share_of_its_closed_forms(
    backend: str, trials: int
) -> None:
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    rng = np.random.default_rng(60)
    for _ in range(trials):
        mu_s, mu_k, V = rng.uniform(0.1, 1.0), rng.uniform(0.0, 1.0), rng.uniform(0.05, 1.0)
        mu_k = min(mu_k, 0.98 * mu_s)
        period, reach, share = exact(mu_s, mu_k, V)
        p = STICK_SLIP.Parameters(mu_s=mu_s, mu_k=mu_k, V=V)
        tr = ss.simulate(p, vx0=V, t_end=4.1 * period, rtol=1e-13, backend=backend)
        slips, sticks = (tr.events.of(kind).t for kind in (ss.Event.SLIP, ss.Event.STICK))
        assert np.diff(slips)[1:] == pytest.approx(period, abs=1e-10)
        assert tr.events.of(ss.Event.SLIP).state[1:, 0] == pytest.approx(mu_s, abs=1e-11)
        late = tr.after(slips[1])
        assert late.largest(0.0, about="zero") == pytest.approx(mu_k + reach, abs=1e-10)
        stuck = slips[2] - sticks[(sticks > slips[1])][0]
        assert stuck / period == pytest.approx(share, abs=1e-10)


def test_the_energy_changes_by_the_work_of_friction() -> None:
    """Over jumps of the force: sticking, slipping, overtaking and lift-off."""
    tr = ss.simulate(
        ss.load("coulomb").Parameters(theta0=math.radians(42)),
        x0=0.3,
        y0=0.1,
        t_end=300.0,
        rtol=1e-12,
    )
    energy, power = tr.energy(), tr.friction_power()
    assert tr.sticking > 0
    kinds = {kind for kind in ss.Event if not kind.name.startswith("FACE")}
    assert {ss.Event(kind) for kind in tr.events.which} == kinds
    assert tr.integral(power) == pytest.approx(energy[-1] - energy[0], abs=1e-9)
    assert tr.integral(np.abs(power)) > 0.1


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_cycle_with_sticking_has_the_zero_multiplier_that_sticking_brings(backend: str) -> None:
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    period, reach, _ = exact(0.6, 0.4, 0.3)
    found = ss.cycle(STICK_SLIP.Parameters(mu_s=0.6, mu_k=0.4, V=0.3), backend=backend)
    assert found.period == pytest.approx(period, abs=1e-12)
    assert found.amplitude == pytest.approx(reach, abs=1e-12)
    assert abs(found.multipliers[1]) <= found.multiplier_errors[0] < 1e-10
    assert [ss.Event(kind).name for kind in found.events.which] == ["STICK", "SLIP"]
    assert "sticks" in ss.precise.prove_cycle(found).reason


def test_a_branch_goes_past_where_a_stretch_begins_as_sticking_does() -> None:
    """Along closed forms, by no needless steps; in a family of cycles at every value there is no
    fold, and no branch.
    """
    pytest.importorskip("heyoka")
    # Within a family, where no border is an edge of it, a multiplier alone says so, or that no step
    # can be told from another: last digits decide.
    inside = {FAMILIES, f"a second multiplier comes to 1: {FAMILIES}, or hardly attracts"}
    for mu_k, vary, to, hows in (
        (
            0.4,
            "mu_k",
            (0.05, 0.9),
            ({"the range ends"}, {"x' = V"}, {FAMILIES}),
        ),  # it sticks no more where both coefficients are one
        (0.4, "V", (0.05, 0.9), ({"the range ends"}, {"the range ends"})),
        (0.7, "mu_k", (0.5, 0.8), (inside, inside)),
    ):
        given = {"mu_s": 0.6, "mu_k": mu_k, "V": 0.3}
        branch = ss.cycle_branch(
            ss.cycle(STICK_SLIP.Parameters(**given), near=(mu_k, 0.3)), vary, between={vary: to}
        )
        periods = [exact(**(given | {vary: value}))[0] for value in branch.values.tolist()]
        assert branch.periods == pytest.approx(periods, abs=1e-11)
        for event, how in zip(branch.events, hows, strict=True):
            assert event.how in how
        assert not branch.of("grazing-sliding") or branch.values[-1] == pytest.approx(0.6, abs=1e-5)
        assert len(branch.values) < 55


@pytest.mark.parametrize(
    ("values", "start", "kinds", "end"),
    [
        ({"V": 0.0}, (0.55, 0.0), [], (0.55, 0.0)),  # it stays where the belt stands
        ({"V": 0.0}, (0.6, 0.0), [], (0.6, 0.0)),  # the force at its limit is within it
        (
            {"V": 0.0},
            (1.0, 0.0),
            ["STICK"],
            (-0.2, 0.0),
        ),  # half a turn about μ_k = 0.4, then |x| < μ_s
        ({"V": 0.0, "mu_s": 0.0, "mu_k": 0.0}, (1.0, 0.0), None, None),  # nothing holds it
        (
            {"V": 0.3, "mu_s": 0.4},
            (0.4, 0.3),
            None,
            None,
        ),  # μ_s = μ_k: it touches x' = V in every round
        (
            {"V": 0.3, "mu_s": 0.0, "mu_k": 0.4},
            (0.0, 0.3),
            ["SLIP"],
            None,
        ),  # held up to μ_k, as slip has there
        ({"V": 0.3}, (0.2, 0.3), ["SLIP"], None),  # it starts sticking
        ({"V": 0.3}, (0.7, 0.3), [], None),  # on the border, and the force beyond its limit
        (
            {"V": 0.3},
            (-0.7, 0.3),
            ["STICK"],
            None,
        ),  # likewise against the belt: it comes back to x' = V
        ({"V": 0.3}, (0.2, 0.3 + 1e-13), ["SLIP"], None),  # within rounding of the border
    ],
)
def test_starts_at_which_a_rule_decides(
    values: dict[str, float],
    start: tuple[float, float],
    kinds: list[str] | None,
    end: tuple[float, float] | None,
) -> None:
    p = STICK_SLIP.Parameters(**({"mu_s": 0.6, "mu_k": 0.4} | values))
    tr = ss.simulate(p, start=start, t_end=6.0, rtol=1e-12)
    assert tr.events is not None
    if kinds is not None:
        assert [ss.Event(kind).name for kind in tr.events.which][: len(kinds)] == kinds
        assert end is None or len(tr.events) == len(kinds)
    assert len(tr.events) < 10
    if end is not None:
        assert tr.state[:, -1] == pytest.approx(end, abs=1e-9)


@pytest.mark.parametrize("name", ["coulomb", "tip"])
def test_derivatives_while_it_sticks_against_differences(name: str) -> None:
    """Of the accelerations, of the sliding speed, which does not change, and of the limits."""
    model = dry_friction.model(name)
    p = model.Parameters(ratio=0.8, **({"theta0": 0.8} if name == "coulomb" else {}))
    field, algebra, n = model.field, model.algebra, len(model.coordinates)

    def at(z: np.ndarray) -> np.ndarray:
        here, taken = z[: 2 * n].tolist(), field.constants(z[2 * n :].tolist())
        told = algebra.borders(*here, *taken)[1], *algebra.grip(*here, *taken, 1, 0)
        return np.array([*field.acceleration(here, taken, (1, 0), np), *told], dtype=float)

    z, h = np.array([0.11, -0.07, 0.13, 0.05, *p.scalars(*model.parameters)]), 1e-6
    numeric = np.array([(at(z + h * way) - at(z - h * way)) / (2 * h) for way in np.eye(len(z))]).T
    state, taken = z[: 2 * n].tolist(), field.constants(z[2 * n :].tolist())
    ours = np.hstack(
        [function(state, taken, (1, 0), np) for function in (field.jacobian, field.by_parameters)]
    )
    assert np.vstack([ours, algebra.grip_slopes(*state, *taken, 1, 0)]) == pytest.approx(
        numeric, abs=1e-8
    )
    held = field.acceleration(state, taken, (1, 0), np)
    assert algebra.border_rates(*state, *held, *taken)[1] == pytest.approx(0.0, abs=1e-15)


def test_a_standing_belt_holds_while_the_normal_force_swings() -> None:
    """The normal force of the bouncing mass passes through 0, and both integrators hold it as
    long.
    """
    p = ss.load("coulomb").Parameters(theta0=0.7, V=0.0)
    shares = [
        ss.simulate(p, x0=0.3, y0=0.1, t_end=200.0, rtol=1e-12, backend=backend).sticking
        for backend in BACKENDS
    ]
    assert shares[0] == pytest.approx(shares[1], abs=1e-7)
    assert shares[0] > 0.05


@pytest.mark.parametrize("name", ["coulomb", "coulomb_stick_slip"])
def test_the_field_everywhere_is_that_of_the_mode_where_nothing_slides_too(name: str) -> None:
    """Held within the limits of the force, beyond them and in lift-off as it begins to slide; also
    where nothing pulls.
    """
    model, rng = alone(name), np.random.default_rng(60)
    n, sides = len(model.coordinates), set()
    for trial in range(200):
        given = {one: rng.uniform(0.1, 1.0) for one in model.parameters} | {
            "V": 0.0 if trial % 2 else rng.uniform(0.1, 1.0)
        }
        constants = model.field.constants([given[one] for one in model.field.parameters])
        place = rng.uniform(-1.0, 1.0, n) if trial else np.zeros(n)
        state = [*place.tolist(), given["V"], *[0.0] * (n - 1)]
        mode = model.field.initial_mode(state, constants)
        sides.add(mode[:2])
        held = model.field.acceleration(state, constants, mode, FLOATS)
        assert [float(value) for value in model.algebra.rhs(*state, *constants)] == pytest.approx(
            held, abs=1e-14
        )
    assert len(sides) == (3 if n == 1 else 5)
