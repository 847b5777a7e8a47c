"""The disc between two pads: its flutter while both touch, and a motion across on which they part,
in closed form.
"""

import math
from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym import precise
from tests.oracles.hopf_points import Reference
from tests.support import needs_a_quick_integrator

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


class OnOnePad(Reference):
    """The disc on its lower pad alone, where the upper one has come off."""

    def _field(self, u: Sequence[Any]) -> list[Any]:
        P, (y, phi, y_rate, phi_rate) = self.P, u
        slides = P["V"] + (1 + y) * phi_rate + y_rate * phi
        steady = mpmath.exp(-P["d"] * P["V"])
        mu = P["mu0"] * (1 + steady - mpmath.exp(-P["d"] * slides))
        N = P["kappa"] - y
        return [
            y_rate,
            phi_rate,
            N * (1 - mu * phi) - P["beta"] * y,
            -(P["tau"] * phi + mu * N * (1 + y)) / P["iota"],
        ]


@pytest.mark.thorough
@needs_a_quick_integrator
def test_how_dangerous_flutter_on_one_pad_is() -> None:
    """Against 50 digits of equations written by hand, and by the cycles that are born: within the
    plane of the pair they attract where l₁ < 0. Alike on either pad.
    """
    kinds = set()
    for values in ({"d": 5.0}, {"tau": 0.9, "kappa": 0.3}):
        p = MODEL.Parameters(mu0=None, **values)
        found = ss.flutter_onsets(p, "mu0", between={"mu0": (0.05, 3.0)})
        upper, lower = (np.flatnonzero(found["touching"] == one) for one in ("upper", "lower"))
        assert len(upper) == len(lower) == 2
        np.testing.assert_allclose(found.lyapunov[upper], found.lyapunov[lower], rtol=1e-9)
        for row in lower:
            known = {name: float(found[name][row]) for name in MODEL.parameters}
            exact = OnOnePad(MODEL.name, known, found.state(row), "mu0", float(found.omega[row]))
            for one in ("lyapunov", "crossing"):
                off = abs(mpmath.mpf(float(getattr(found, one)[row])) - getattr(exact, one))
                assert off <= getattr(found, f"{one}_error")[row] < 1e-6
        for row in (*upper, *lower):
            cycle = ss.cycle(onset=found, index=int(row), amplitude=3e-3)
            sizes = np.abs(cycle.multipliers[1:])
            own = sizes[np.abs(sizes - 1).argmin()]
            assert (own < 1) == (found.criticality[row] == "supercritical")
            kinds.add(str(found.criticality[row]))
    assert kinds == {"supercritical", "subcritical"}


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


@pytest.mark.validate
@needs_a_quick_integrator
def test_a_cycle_on_which_both_pads_part_is_proved() -> None:
    """What is proved comes back in a motion of forces written by hand, by SciPy."""
    pytest.importorskip("flint")
    mu0, kappa, iota = 0.6, 0.1, 0.4
    cycle = ss.cycle(MODEL.Parameters(mu0=mu0, kappa=kappa, iota=iota), near=[1.5, 0.5, 0.0, 0.0])
    assert {*cycle.events.contact} == {"upper", "lower"}
    proof = precise.prove_cycle(cycle)
    assert proof.proved
    assert proof.stable
    state = [float(value) for value in proof.state]

    def field(_: float, u: Sequence[float]) -> list[float]:
        y, phi, y_rate, phi_rate = u
        pulls = [-y, -phi]
        for side in (1, -1):
            N = max(kappa + side * y, 0.0)
            slides = 0.5 - (side - y) * phi_rate + y_rate * phi
            mu = mu0 * math.copysign(1 - math.exp(-10 * abs(slides)), slides)
            pulls[0] -= N * (side + mu * phi)
            pulls[1] += N * mu * (side - y)
        return [y_rate, phi_rate, pulls[0], pulls[1] / iota]

    options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13, "max_step": 0.01}
    end = solve_ivp(field, (0.0, float(proof.period)), state, **options).y[:, -1]
    np.testing.assert_allclose(end, state, atol=1e-9)


def test_what_was_searched_is_told_of_all_combinations_together() -> None:
    """On one pad alone it is beyond the other one, on either side: y > κ, or y < −κ."""
    p = MODEL.Parameters(mu0=None)
    found = ss.folds(p, "mu0", between={"mu0": (0.0, 4.0)})
    low, high = found.region[0]
    assert low < -float(p.kappa) < float(p.kappa) < high
    assert low == -high
