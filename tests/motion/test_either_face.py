"""Contacts that press on either of two faces, as in a slot or on a hoop, rub with |N|: sets of rest
and states by closed forms, motions by the equations written by hand.
"""

import itertools
import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from spragsym.motion import Event
from tests.oracles.user_pages import model_of, shipped_page

pytestmark = pytest.mark.thorough

#: A mass that a force of either sign presses, which may change along the belt.
GIVEN = shipped_page(
    "coulomb_stick_slip",
    ("page.normal_force(N_0)", "page.normal_force(N_0 * w + s * k * x, unilateral=False)"),
    (
        "x = page.coordinate",
        'w = page.parameter("w", "1", "share of the force", "real", 1.0)\n'
        's = page.parameter("s", "1", "its slope along the belt", "real", 0.0)\n'
        "x = page.coordinate",
    ),
)

#: A bead on a hoop that turns about a vertical diameter.
HOOP = """'''A bead on a rough hoop.'''
from spragsym.derive.model import Page, cos, sgn, sin

page = Page("A bead on a rough hoop that turns.")
m = page.unit("m", "kg", "mass")
g = page.unit("g", "m/s^2", "gravity")
R = page.unit("R", "m", "radius")
W = page.parameter("W", "1/s", "rate of turning", ">= 0", 1.2)
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
V = page.parameter("V", "m/s", "speed", ">= 0", 0.0)
phi = page.coordinate("phi", "rad", "angle from the lowest point")
page.kinetic(m * R**2 * page.rate(phi) ** 2 / 2)
page.potential(-m * g * R * cos(phi) - m * W**2 * R**2 * sin(phi) ** 2 / 2)
page.normal_force(m * g * cos(phi) + m * W**2 * R * sin(phi) ** 2, unilateral=False)
page.friction(R * phi, V, slip=lambda v: mu * sgn(v), holds=mu)
"""

#: A pin in a slot across a belt, by laws that are odd in the depth.
SLOT = """'''A pin in a slot.'''
from spragsym.derive.model import Page, tanh

page = Page("A pin in a slot of springs, which rubs on either side.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the faces")
a = page.unit("a", "m", "length")
c3 = page.parameter("c3", "1", "hardening", ">= 0", 0.4)
k_x = page.parameter("k_x", "N/m", "along", "> 0", 0.7)
q = page.parameter("q", "N/m", "coupling", "real", 0.3)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.4)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.0)
d = page.parameter("d", "s/m", "steepness", "> 0", 8.0)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.potential(q * x * y)
page.contact(y, lambda depth: k * depth * (1 + c3 * (depth / a) ** 2), unilateral=False)
page.friction(x, V, lambda v: mu0 * tanh(d * v))
"""


def test_a_force_of_either_sign_holds_by_its_size() -> None:
    model = model_of(GIVEN, "given")
    for w in (0.5, -0.5):
        found = ss.sticking_states(model.Parameters(mu_s=0.6, mu_k=0.4, V=0.0, w=w))
        assert [*found.x_low, *found.x_high] == pytest.approx([-0.3, 0.3], rel=1e-12)


@pytest.mark.parametrize("number", [1, pytest.param(12, marks=pytest.mark.validate)])
def test_sets_of_a_bead_on_a_rough_hoop(number: int) -> None:
    """|F| ≤ μ |N| at drawn rates and frictions, with all ends by Brent's method."""
    rng, model = np.random.default_rng(75), model_of(HOOP, "hoop")
    for _ in range(number):
        W, mu = rng.uniform(0.0, 2.0), rng.uniform(0.1, 0.9)
        found = ss.sticking_states(model.Parameters(W=W, mu=mu, V=0.0))
        lows, highs = _held(W**2, mu)
        assert found.complete
        for ours, theirs in ((found.phi_low, lows), (found.phi_high, highs)):
            assert np.sort(ours % (2 * math.pi)) == pytest.approx(theirs, abs=1e-9)


def _held(w: float, mu: float) -> tuple[list[float], list[float]]:
    """Ends of the sets of angles at which the bead stays, from 0 to 2π."""

    def margin(sign: int) -> Callable[[float], float]:
        return lambda t: (
            math.sin(t) * (1 - w * math.cos(t)) + sign * mu * (math.cos(t) + w * math.sin(t) ** 2)
        )

    grid = np.linspace(0.0, 2 * math.pi, 4001) + 1e-4
    ends = sorted(
        brentq(margin(sign), a, b, xtol=1e-14) % (2 * math.pi)
        for sign in (1, -1)
        for a, b in itertools.pairwise(grid)
        if margin(sign)(a) * margin(sign)(b) < 0
    )
    middles = [0.5 * (a + b) for a, b in itertools.pairwise([*ends, ends[0] + 2 * math.pi])]
    held = [margin(1)(t) * margin(-1)(t) < 0 for t in middles]
    lows = [end for end, inside in zip(ends, held, strict=True) if inside]
    highs = [end for end, inside in zip(ends, [held[-1], *held[:-1]], strict=True) if inside]
    return lows, highs


def test_states_of_either_face_are_those_of_two_linear_systems() -> None:
    rng, model, met = np.random.default_rng(7), ss.load("mode_coupling"), 0
    for _ in range(20):
        alpha, sigma, mu = rng.uniform(0.2, 0.8), rng.uniform(1.0, 3.0), rng.uniform(0.0, 5.0)
        states = {}
        for side, name in ((1, "face"), (-1, "opposite face")):
            K = [[alpha + sigma / 2, side * mu - sigma / 2], [-sigma / 2, 1 + sigma / 2]]
            x, y = np.linalg.solve(K, [0.0, -1.0])
            states |= {name: (x, y)} if side * y <= 0 else {}
        eq = ss.equilibria(model.Parameters(mu0=mu, alpha=alpha, sigma=sigma, beta=0.0))
        met += len(states) == 2
        assert eq.complete
        assert {
            str(name): (x, y) for name, x, y in zip(eq["touching"], eq.x, eq.y, strict=True)
        } == {name: pytest.approx(place, rel=1e-12) for name, place in states.items()}
    assert met >= 3


@pytest.mark.parametrize(("mu", "kind"), [(0.4, "passes"), (1.7, "border_fold")])
def test_where_the_force_passes_zero_a_state_passes_or_two_end(mu: float, kind: str) -> None:
    """x = μ |w + x| has one solution for all w, or of μ > 1 two for w < 0."""
    p = model_of(GIVEN, "given").Parameters(mu_s=2.0, mu_k=mu, V=1.0, s=1.0)
    found = ss.folds(p, "w", between={"w": (-1.0, 1.0)})
    assert [*found.kind] == [kind]
    assert found.w == pytest.approx([0.0], abs=1e-12)


@pytest.mark.parametrize(
    ("backend", "number"),
    [("scipy", 3), ("heyoka", 3), pytest.param("heyoka", 50, marks=pytest.mark.validate)],
)
def test_on_a_belt_at_rest_no_energy_is_won(backend: str, number: int) -> None:
    """Drawn motions; those of the slot beside the equations by hand, without events."""
    pytest.importorskip(backend)
    rng, slot, given = np.random.default_rng(5), model_of(SLOT, "slot"), model_of(GIVEN, "given")
    changed = 0
    for _ in range(number):
        values = {
            "c3": rng.uniform(0, 1),
            "k_x": rng.uniform(0.5, 2),
            "q": rng.uniform(-0.5, 0.5),
            "mu0": rng.uniform(0.2, 0.8),
            "V": 0.0,
        }
        start = rng.uniform(-1, 1, 4)
        tr = ss.simulate(slot.Parameters(**values), start=start, t_end=15.0, backend=backend)
        assert np.diff(tr.energy()).max() < 1e-9
        assert tr.state[:, -1] == pytest.approx(_by_hand(values, start, 15.0), abs=1e-7)
        changed += len(tr.events.of(Event.FACE_LEFT)) + len(tr.events.of(Event.FACE_REGAINED))
        p = given.Parameters(
            mu_s=0.6, mu_k=0.4, V=0.0, w=rng.uniform(-0.5, 0.5), s=rng.uniform(-2, 2)
        )
        tr = ss.simulate(p, start=rng.uniform(-1, 1, 2), t_end=15.0, backend=backend)
        energy = tr.energy()
        assert np.diff(energy).max() < 1e-9
        assert energy[-1] - energy[0] == pytest.approx(tr.integral(tr.power()), abs=1e-8)
    assert changed >= 2 * number


def _by_hand(values: dict[str, float], start: np.ndarray, t_end: float) -> np.ndarray:
    c3, k_x, q, mu0 = (values[name] for name in ("c3", "k_x", "q", "mu0"))

    def slopes(_: float, z: np.ndarray) -> list[float]:
        x, y, vx, vy = z
        N = -y * (1 + c3 * y**2)
        return [vx, vy, -k_x * x - q * y - mu0 * abs(N) * math.tanh(8.0 * vx), N - q * x]

    found = solve_ivp(slopes, (0, t_end), start, method="DOP853", rtol=1e-12, atol=1e-12)
    return np.asarray(found.y[:, -1])
