"""The disc between two pads: its flutter while both touch, and a motion across on which they part,
in closed form.
"""

import math

import numpy as np
import pytest

import spragsym as ss

MODEL = ss.load("disc_between_pads")


@pytest.mark.thorough
def test_its_middle_flutters_where_two_modes_meet() -> None:
    """At μ = |k_y + 2 k_c − k_t/J| √J / (4 √(N_0 (h − N_0))), without damping."""
    rng = np.random.default_rng(76)
    for _ in range(20):
        beta, tau = rng.uniform(0.0, 1.0), rng.uniform(0.5, 1.0)
        iota, kappa = rng.uniform(0.3, 0.6), rng.uniform(0.1, 0.4)
        exact = abs(beta + 2 - tau / iota) * math.sqrt(iota / (kappa * (1 - kappa))) / 4
        p = MODEL.Parameters(mu0=None, beta=beta, tau=tau, iota=iota, kappa=kappa)
        between = {"mu0": (0.5 * exact, 1.5 * exact)}
        found = ss.flutter_onsets(p, vary="mu0", between=between, damping=False)
        middle = (found["touching"] == "upper, lower") & (np.abs(found["y"]) < 1e-9)
        assert found["mu0"][middle] == pytest.approx([exact], rel=1e-12)


def test_without_friction_either_pad_parts_and_comes_back_at_the_times_of_arcs() -> None:
    """On 2 k_c while both touch, and on k_c about N_0 behind the middle while one does."""
    kappa, speed = 0.1, 0.3
    p = MODEL.Parameters(mu0=0.0, beta=0.0, kappa=kappa)
    parts = math.asin(kappa * math.sqrt(2) / speed) / math.sqrt(2)
    apart = 2 * math.atan(math.sqrt(speed**2 - 2 * kappa**2) / (2 * kappa))
    half = 2 * parts + apart
    tr = ss.simulate(p, vy0=speed, t_end=4.1 * half)
    for name, begin in (("lower", 0.0), ("upper", half)):
        events = tr.events.on(name)
        lost, regained = (
            events.of(kind).t for kind in (ss.Event.CONTACT_LOST, ss.Event.CONTACT_REGAINED)
        )
        exact = begin + parts + 2 * half * np.arange(2)
        np.testing.assert_allclose(lost, exact, atol=1e-9)
        np.testing.assert_allclose(regained, exact + apart, atol=1e-9)
