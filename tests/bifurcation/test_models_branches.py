"""Paths of a page in three coordinates: a pair of states that is born far away does not stop the state that is followed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.branches import Along, _by_tubes, _states
from spragsym.statics.mechanics.balance import Balance
from tests.oracles.user_pages import model_of

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


@pytest.mark.thorough
def test_an_angle_after_a_turn_is_the_same_state() -> None:
    """States are listed within one turn, and a state that is followed may leave it."""
    rod = ss.load("sprag_rod")
    stops, nothing = np.array([0.5, 0.6]), np.empty(0)
    p = rod.Parameters(theta0=0.5)
    along = Along(Balance(rod, contact=True), p, "theta0", nothing, nothing.astype(str))
    eq = ss.equilibria(p.replace(theta0=stops))
    begin, end = (_states(along, eq, stop) for stop in (0, 1))
    later = replace(end, q=end.q + 2 * np.pi)
    known, complete = _by_tubes(along, [(0.5, 0.6)], {0.5: begin, 0.6: later})
    (pairs,) = known.values()
    assert complete == set(known)
    assert pairs == {slot: slot for slot in range(int(eq.count[0]))}
    assert len(pairs) == 3
