"""Angles that turn together: links whose joint has a spring are as before only after a turn of all
of them. Each state is found once, and a motion that goes around closes.
"""

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

LINKS = '''r"""Two links with a spring between them, driven by a torque."""
from spragsym.derive.model import Page, cos, sin
page = Page("Two links with a spring between them.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness")
L_0 = page.unit("L_0", "m", "length")
g = page.parameter("g", "m/s^2", "gravity", ">= 0", 0.3, becomes="gamma")
k_t = page.parameter("k_t", "N m", "spring between the links", "> 0", 0.2, becomes="tau")
T = page.parameter("T", "N m", "torque on the first link", ">= 0", 0.0, becomes="torque")
c = page.parameter("c", "N m s", "damping of each link", ">= 0", 0.1, becomes="zeta")
a = page.coordinate("a", "rad", "first angle")
b = page.coordinate("b", "rad", "second angle")
x1, y1 = L_0 * sin(a), -L_0 * cos(a)
x2, y2 = x1 + L_0 * sin(b), y1 - L_0 * cos(b)
page.kinetic(m * (page.rate(x1)**2 + page.rate(y1)**2 + page.rate(x2)**2 + page.rate(y2)**2) / 2)
page.potential(m * g * (y1 + y2) + k_t * (b - a)**2 / 2)
page.force(T, along=a)
page.damper(c, along=a)
page.damper(c, along=b)
'''


def links(joint: str = "b - a") -> Any:
    """The model, with what the spring between the links resists."""
    return model_of(LINKS.replace("b - a", joint), "links")


def torque_left(a: Any, gamma: float, tau: float) -> Any:
    """What the second link's balance lacks where the first one's holds: b − a = 2 γ sin a/τ."""
    joint = 2 * gamma * np.sin(a) / tau
    return gamma * np.sin(a + joint) + tau * joint


@pytest.mark.parametrize("tau", [0.05, 0.2, 1.0])
def test_each_state_is_found_once(tau: float) -> None:
    """By one equation in the first angle, whose signs change at each state within a turn."""
    gamma, model = 0.3, links()
    eq = ss.equilibria(model.Parameters(gamma=gamma, tau=tau))
    assert eq.complete
    begin = -math.pi + 0.012345
    angles = np.linspace(begin, begin + 2 * math.pi, 20_001)
    left = torque_left(angles, gamma, tau)
    want = [
        brentq(torque_left, angles[k], angles[k + 1], args=(gamma, tau), xtol=1e-15)
        for k in np.flatnonzero(left[:-1] * left[1:] < 0)
    ]
    found = sorted(zip(eq["a"].tolist(), eq["b"].tolist(), strict=True))
    assert np.allclose(found, [(a, a + 2 * gamma * math.sin(a) / tau) for a in want], atol=1e-9)


@pytest.mark.parametrize(
    ("joint", "turns"),
    [
        ("b - a", {0: {0: 1, 1: 1}}),
        ("b - 2 * a", {0: {0: 1, 1: 2}}),
        ("a - 2 * b", {1: {0: 2, 1: 1}}),
        ("a + b", {0: {0: 1, 1: -1}}),
        ("b", {0: {0: 1}}),
        ("sin(b - a)", {0: {0: 1}, 1: {1: 1}}),
        ("2 * a - 3 * b", {}),
    ],
)
def test_turns_are_those_that_leave_the_spring_as_it_was(
    joint: str, turns: dict[int, dict[int, int]]
) -> None:
    assert links(joint).whole_turns == turns


@pytest.mark.thorough
def test_links_that_go_around_come_to_a_cycle_of_one_turn_of_both() -> None:
    """Its period by SciPy: the time of a turn of the first link, after a long motion."""
    p = links().Parameters(gamma=0.05, tau=0.5, torque=0.4)

    def rate(t: float, s: np.ndarray) -> list[float]:
        a, b, u, v = s
        cosine, sine = math.cos(a - b), math.sin(a - b)
        right = [
            -v * v * sine - 2 * 0.05 * math.sin(a) + 0.5 * (b - a) + 0.4 - 0.1 * u,
            u * u * sine - 0.05 * math.sin(b) - 0.5 * (b - a) - 0.1 * v,
        ]
        return [u, v, *np.linalg.solve([[2.0, cosine], [cosine, 1.0]], right)]

    settled = solve_ivp(rate, (0, 800), [0, 0, 1.5, 1.5], rtol=1e-11, atol=1e-12, method="DOP853")

    def turned(t: float, s: np.ndarray) -> float:
        return float(s[0] - settled.y[0, -1] - 2 * math.pi)

    turned.terminal = True  # type: ignore[attr-defined]
    more = solve_ivp(
        rate, (0, 50), settled.y[:, -1], rtol=1e-12, atol=1e-13, method="DOP853", events=turned
    )
    cycle = ss.cycle(p, near=(0, 0, 1.5, 1.5))
    assert cycle.stable
    assert cycle.orbit.windings == {0: 1}
    assert math.isclose(cycle.period, more.t_events[0][0], rel_tol=1e-8)
    outcome = ss.simulate(p, start=(0, 0, 1.5, 1.5), t_end=800.0).outcome()
    assert outcome.limit == ss.Regime.LIMIT_CYCLE
    assert math.isclose(outcome.period, cycle.period, rel_tol=1e-9)
