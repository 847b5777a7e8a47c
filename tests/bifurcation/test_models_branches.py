"""Branches of states: which state at one stop is which at the next."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.branches import Along, _by_tubes, _states
from spragsym.statics.balance import Balance


@pytest.mark.thorough
def test_an_angle_after_a_turn_is_the_same_state() -> None:
    """States are listed within one turn, and a state that is followed may leave it."""
    rod = ss.load("sprag_rod")
    stops, nothing = np.array([0.5, 0.6]), np.empty(0)
    p = rod.Parameters(theta0=0.5)
    along = Along(Balance(rod, contact=True), p, "theta0", nothing, nothing.astype(str), np.empty((1, 0)))
    eq = ss.equilibria(p.replace(theta0=stops))
    begin, end = _states(along, eq).values()
    later = replace(end, q=end.q + 2 * np.pi)
    known, complete = _by_tubes(along, [(0.5, 0.6)], {0.5: begin, 0.6: later})
    (pairs,) = known.values()
    assert complete == set(known)
    assert pairs == {slot: slot for slot in range(int(eq.count[0]))}
    assert len(pairs) == 3
