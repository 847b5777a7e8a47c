"""Paths of a page in three coordinates: a pair of states that is born far away does not stop the state that is followed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import fsolve

import spragsym as ss
from spragsym.models.catastrophe.branches import Along, _by_tubes, _states
from spragsym.models.mechanics.balance import Balance
from tests.support import model_of

#: A pad with a shoe, which slides, dips and turns.
PAGE = r'''
r"""A pad on a turning spring, whose shoe is pressed on a belt."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page("A pad that slides, dips and turns, with a shoe on a belt.")
m, k_c, L_0 = page.unit("m", "kg", "mass"), page.unit("k_c", "N/m", "contact"), page.unit("L_0", "m", "length of the spring")
theta0 = page.parameter("theta0", "rad", "inclination", "(0, pi)", 0.9)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.4)
F = page.parameter("F", "N", "preload", "> 0", 0.01, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.02, becomes="alpha")
k = page.parameter("k", "N/m", "inclined spring", "> 0", 0.1, becomes="sigma")
k_r = page.parameter("k_r", "N m", "turning stiffness", "> 0", 0.05, becomes="rho")
a = page.parameter("a", "m", "offset of the shoe", "real", 0.2)
b = page.parameter("b", "m", "depth of the shoe", ">= 0", 0.3)
V, d = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5), page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x, y = page.coordinate("x", "m", "along the belt"), page.coordinate("y", "m", "across the belt")
phi = page.coordinate("phi", "rad", "turn of the pad")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2 + L_0**2 * page.rate(phi) ** 2 / 20) / 2)
page.spring(k_x, along=x)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.potential(k_r * phi**2 / 2)
page.force(-F, along=y)
page.contact(y + a * sin(phi) + b * (1 - cos(phi)), lambda depth: k_c * depth)
page.friction(x + a * cos(phi) + b * sin(phi), V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
'''


@pytest.fixture(scope="module")
def pad() -> Any:
    return model_of(PAGE.strip() + "\n", "pad")


def by_hand(q: Any, mu: float) -> Any:
    """Forces on the pad at its base values, by hand."""
    x, y, phi = q
    dx, dy = np.cos(0.9) - x, np.sin(0.9) - y
    pull = 0.1 * (1 - 1 / np.hypot(dx, dy))
    lever, arm = 0.2 * np.cos(phi) + 0.3 * np.sin(phi), -0.2 * np.sin(phi) + 0.3 * np.cos(phi)
    N = -(y + 0.2 * np.sin(phi) + 0.3 * (1 - np.cos(phi)))
    return [mu * N - 0.02 * x + pull * dx, N - 0.01 + pull * dy, lever * N + mu * N * arm - 0.05 * phi]


@pytest.mark.validate
def test_a_pair_that_is_born_far_away_does_not_stop_a_path(pad: Any) -> None:
    folds = ss.folds(pad.Parameters(), vary="mu0", between={"mu0": (0.0, 1.0)})
    born, ends = folds.mu0.tolist()
    assert (folds.ends.tolist(), folds.when.tolist()) == (["upper", "lower"], ["down", "up"])
    values = [0.4, 0.5 * (born + ends), 0.6]
    path = pad.quasi_static_path(pad.Parameters(), "mu0", values)
    (jump,) = path.jumps
    assert jump.value == pytest.approx(ends, abs=1e-12)
    q = np.array([path.x, path.y, path.phi]).T
    for state, mu in zip(q, values, strict=True):
        assert np.abs(by_hand(state, mu)).max() < 1e-14
    # The state that is followed, in small steps by hand, is the one before the jump.
    state = q[0]
    for mu in np.linspace(values[0], values[1], 60):
        state = fsolve(by_hand, state, args=(mu,), xtol=1e-13)
    assert state == pytest.approx(q[1], abs=1e-9)


@pytest.mark.thorough
def test_an_angle_after_a_turn_is_the_same_state() -> None:
    """States are listed within one turn, and a state that is followed may leave it."""
    rod = ss.load("sprag_rod")
    stops, nothing = np.array([0.5, 0.6]), np.empty(0)
    along = Along(Balance(rod, contact=True), rod.Parameters(theta0=0.5), "theta0", nothing, nothing.astype(str))
    eq = along.equilibria(stops)
    begin, end = (_states(along, eq, stop) for stop in (0, 1))
    later = replace(end, q=end.q + 2 * np.pi)
    known, complete = _by_tubes(along, [(0.5, 0.6)], {0.5: begin, 0.6: later})
    (pairs,) = known.values()
    assert complete == set(known)
    assert pairs == {slot: slot for slot in range(int(eq.count[0]))}
    assert len(pairs) == 3
