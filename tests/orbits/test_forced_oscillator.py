"""The forced oscillator with dry friction that ships, against the closed forms of Den Hartog."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.clocks import stopping_amplitude

MODEL = ss.load("forced_oscillator")


@pytest.mark.thorough
def test_what_slides_without_a_stop_has_the_amplitude_of_den_hartog() -> None:
    """Whatever friction would hold: √(1/(1 − ω²)² − (f S)²)."""
    rng = np.random.default_rng(31)
    for _ in range(20):
        omega, mu_k, kappa = rng.uniform(1.4, 2.5), rng.uniform(0.2, 0.5), rng.uniform(0.4, 0.9)
        mu_s = mu_k * rng.uniform(1.0, 1.3)
        p = MODEL.Parameters(omega=omega, mu_k=mu_k, mu_s=mu_s, kappa=kappa)
        found = ss.cycle(p, turns=1)
        slowed = np.sin(np.pi / omega) / (omega * (1 + np.cos(np.pi / omega)))
        exact = np.sqrt((1 - omega**2) ** -2 - (mu_k * kappa * slowed) ** 2)
        assert found.amplitude == pytest.approx(exact, rel=1e-9)
        assert found.stable


def test_what_stops_at_both_turns_is_put_together_from_its_pieces() -> None:
    for omega in (0.3, 0.35):
        p = MODEL.Parameters(omega=omega, kappa=0.5)
        found = ss.cycle(p, turns=1)
        exact = stopping_amplitude(omega, 0.2, (0.98 * found.amplitude, 0.3 * found.period))
        assert found.amplitude == pytest.approx(exact, rel=1e-9)


def test_it_rests_for_good_by_the_static_coefficient_and_not_by_the_kinetic_one() -> None:
    """Where |x| + 1 <= μ_s N_0/P; a larger pull lets it slip, where x + cos φ is μ_s N_0/P."""
    p = MODEL.Parameters(mu_s=0.8, mu_k=0.4, kappa=2.0, omega=0.7)
    begun = ss.fate(p, start=(0.59, np.pi, 0.0), t_end=50.0)
    assert begun.kind == "rest"
    np.testing.assert_allclose(begun.outcome.rest, 0.59, atol=1e-10)
    loose = ss.simulate(p, x0=0.61, phase0=np.pi / 2, t_end=10.0)
    (slips, *_) = loose.events.of(ss.Event.SLIP).t
    assert slips == pytest.approx((np.arccos(0.61 - 1.6) - np.pi / 2) / 0.7, abs=1e-9)


@pytest.mark.thorough
def test_it_creeps_to_the_end_of_what_friction_holds() -> None:
    """To |x| = μ N_0/P - 1: every turn the force passes what friction holds there by less, and the
    excess falls as one over the number of turns.
    """
    p = MODEL.Parameters(mu_s=0.8, mu_k=0.8, kappa=2.0, omega=0.7)
    for start, end in ((0.61, 0.6), (-0.64, -0.6)):
        found = ss.fate(p, start=(start, 0.0))
        assert (found.kind, found.outcome.regime) == ("rest", ss.Regime.APPROACHES_EQUILIBRIUM)
        assert found.outcome.rest == pytest.approx([end], abs=1e-5)
        assert 1e-6 < found.outcome.distance == pytest.approx(abs(found.end[0] - end), abs=1e-5)
        with pytest.raises(ss.errors.ConvergenceError, match=r"it comes to rest at x = -?0\.6"):
            ss.cycle(p, near=(start, 0.0))
    with pytest.raises(ss.errors.ConvergenceError, match="what Newton's method finds is rest"):
        ss.cycle(p, turns=1, near=(0.5, 0.0))


def test_a_fate_is_the_same_for_every_time_after_the_motion_has_settled() -> None:
    """Of a mass that friction holds where x is largest, by `lyapunov` as by `fate`."""
    p = MODEL.Parameters(mu_s=1.2, mu_k=0.8, omega=0.45)
    turn = 2 * np.pi / 0.45
    for t_end in (300.0, 500.0, 1021.0, 4000.0, 41000.0):
        found = ss.fate(p, t_end=t_end)
        assert (found.kind, found.outcome.period) == ("cycle", pytest.approx(turn))
    assert ss.lyapunov(p, t_end=300.0).kind == "cycle"
