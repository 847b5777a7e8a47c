"""What motions come to: against what they do later, other integrators, and maps whose multipliers
are given.
"""

import importlib.util
from functools import partial

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion import with_compiled
from spragsym.motion.regimes import Regime
from spragsym.motion.sweeps import basin, rms_sweep
from tests.oracles import article_motion

BELT = {"V": 0.5, "d": 10.0}
SLOW = ss.Parameters.article(theta0=np.radians(42))

needs_heyoka = pytest.mark.skipif(
    not importlib.util.find_spec("heyoka"), reason="long motions take SciPy minutes"
)


#: Another integrator, which does not stop at kinks.
plain = partial(
    article_motion.integrated, method="DOP853", rtol=1e-10, atol=1e-13, dense_output=True
)


# ------------------------------------------------------------------------------------------------
# cycles


@needs_heyoka
def test_a_cycle_is_told_with_its_own_period_while_the_motion_winds_onto_it() -> None:
    early, late = (
        rms_sweep(SLOW, **BELT, t_end=end, transient=end - 500) for end in (2500.0, 8000.0)
    )
    for found in (early, late):
        assert found.regime == Regime.APPROACHES_CYCLE
        start = [float(found.cycle_x), float(found.cycle_y), 0.0, float(found.cycle_vy)]
        period = float(found.period)
        orbit = plain(SLOW, **BELT, start=start, t_end=period).sol
        assert np.abs(orbit(period) - start).max() < 1e-7
        # and not before: twice round is not once round
        between = orbit(np.linspace(0.05, 0.95, 200) * period)
        assert np.abs(between - np.array(start)[:, None]).max(axis=0).min() > 0.05
        t = np.linspace(0, period, 20_001)[:-1]
        assert found.cycle_mean == pytest.approx(orbit(t)[0].mean(), abs=1e-6)
        assert found.cycle_rms == pytest.approx(np.sqrt((orbit(t)[0] ** 2).mean()), abs=1e-6)
        assert found.cycle_x == pytest.approx(orbit(t)[0].max(), abs=1e-7)
    assert early.period == pytest.approx(float(late.period), rel=1e-8)
    assert late.distance < 0.1 * early.distance


@pytest.mark.thorough
@needs_heyoka
@pytest.mark.skipif(not with_compiled.available(), reason="the compiled integrator was not built")
def test_a_cycle_by_derivatives_and_by_differences_is_one() -> None:
    found = [
        rms_sweep(
            SLOW, **BELT, x0=2.54, y0=3.36, vy0=0.36, t_end=400.0, transient=100.0, backend=backend
        )
        for backend in ("heyoka", "compiled")
    ]
    assert [one.regime for one in found] == [Regime.APPROACHES_CYCLE] * 2
    known = ss.cycle(SLOW, **BELT, near=(2.54, 3.36, 0.0, 0.36))
    for one, off in zip(found, (1e-10, 1e-6), strict=True):
        assert one.period == pytest.approx(known.period, rel=off)
        assert one.rate == pytest.approx(
            -np.log(known.multipliers[1].real) / known.period, rel=1e-4
        )
        assert one.cycle_rms == pytest.approx(known.rms, rel=1e-7)


@pytest.mark.thorough
@needs_heyoka
def test_one_cycle_is_one_attractor_whatever_the_phase() -> None:
    # Some of these wander irregularly first, for how long depends on the last bits: rtol 3e-11
    # instead of 1e-10 takes past 8000.
    found = basin(
        SLOW, **BELT, x=[0.0, 0.6, 0.9], vx=[0.0, 0.3], t_end=20_000.0, transient=19_500.0
    )
    assert (found.attractor == 0).all()
    ((regime, _, mean, spread),) = found.attractors
    assert regime == Regime.LIMIT_CYCLE
    assert np.ptp(found.sweep.mean) > 0.01  # averages over the window do depend on the phase
    np.testing.assert_allclose(found.sweep.cycle_mean, mean, rtol=1e-7)
    np.testing.assert_allclose(np.hypot(mean, spread), found.sweep.cycle_rms, rtol=1e-7)


@needs_heyoka
@pytest.mark.parametrize("t_end", [8000.0, 20_000.0])
def test_a_cycle_that_grazes_the_belt_is_one_whatever_the_phase(t_end: float) -> None:
    """Found by a campaign of 6000 motions: differences over too long a step called it unstable.

    That it attracts is seen: from 2000 to 20000 what is left of the motion falls from 6e-3 to
    1e-10.
    """
    p = ss.Parameters(
        theta0=2.7812867375530876,
        mu0=0.4634621203921272,
        kappa=0.018390029572304515,
        alpha=0.007602201771049415,
        sigma=0.26780681780715265,
        beta=0.0,
    )
    start = {"x0": 0.1009949493101665, "vx0": 0.1636269484446078, "vy0": 0.01329781021160948}
    found = rms_sweep(
        p, V=0.15216712083347134, d=5.41751330401023, **start, t_end=t_end, transient=t_end - 500.0
    )
    assert found.regime == Regime.LIMIT_CYCLE
    assert found.period == pytest.approx(20.673374, abs=1e-5)
    assert found.rate == pytest.approx(
        np.log(3.15e-4 / 4.52e-8) / 8000, rel=0.01
    )  # what is left at 4000, and at 12000


# ------------------------------------------------------------------------------------------------
# rest


@pytest.mark.thorough
@needs_heyoka
def test_beside_an_equilibrium_that_repels_nothing_rests() -> None:
    p = ss.Parameters.article(theta0=np.radians(30))
    eq = ss.equilibria(p.replace(mu0=0.5 * (1 - np.exp(-5.0))))
    at = rms_sweep(p, **BELT, x0=eq.x[:3], y0=eq.y[:3], t_end=200.0, transient=100.0)
    # The middle one diverges. The last is stable by (27), and repels all the same: the friction
    # law's damping feeds a mode.
    assert at.regime.tolist() == [Regime.EQUILIBRIUM, Regime.UNSETTLED, Regime.UNSETTLED]
    assert at.equilibrium.tolist() == [0, -1, -1]
    beside = [
        rms_sweep(p, **BELT, x0=eq.x[1] + 1e-6, y0=eq.y[1], t_end=400.0, transient=390.0),
        rms_sweep(p, **BELT, x0=eq.x[2], y0=eq.y[2] + 1e-4, t_end=2e5, transient=1.999e5),
    ]
    assert abs(beside[0].mean - eq.x[1]) > 0.1
    # 4.9e-6 by the eigenvalues of the 4 x 4 linearization, in x the share of that mode
    early = rms_sweep(p, **BELT, x0=eq.x[2], y0=eq.y[2] + 1e-4, t_end=1e5, transient=9.99e4)
    assert beside[1].spread > 1.4 * early.spread


def test_a_motion_that_a_damper_brings_to_rest_above_the_belt_rests_there() -> None:
    """The forces of both springs and the preload by hand: they are balanced where it rests."""
    p = ss.load("damped").Parameters(theta0=np.radians(100), kappa=0.001, V=0.5, d=10.0)
    found = ss.simulate(p, start=(0.04, 1.966, 0.0, 0.0), t_end=2000.0).outcome(1500.0)
    assert found.regime == Regime.EQUILIBRIUM
    strut = np.array([np.cos(p.theta0), np.sin(p.theta0)]) - found.rest
    pull = p.sigma * (1 - 1 / np.hypot(*strut)) * strut
    np.testing.assert_allclose(pull, [p.alpha * found.rest[0], p.kappa], atol=1e-12)
    assert found.rest[1] > 1
    # The slowest deviation decays at half of a damping of 0.01 along the belt.
    assert found.rate == pytest.approx(0.005, rel=1e-3)


def test_a_mass_in_a_well_above_the_belt_never_comes_down() -> None:
    """Held by a stiff k_x beside the anchor it rests at (0, 2 sin θ₀), where the spring has its own
    length. Nothing dissipates there, so that it stays if its energy is below that of the saddles.
    """
    p = ss.Parameters(theta0=np.pi / 3, mu0=0.3, kappa=0.01, alpha=10.0, sigma=10.0, beta=0.0)

    def energy(x: float, y: float) -> float:
        length = np.hypot(x - 0.5, y - np.sin(p.theta0))
        return float(0.01 * y + 5.0 * x**2 + 5.0 * (length - 1) ** 2)

    away = ss.equilibria(p, contact=False)
    saddles = [energy(x, y) for x, y in zip(away.x[[0, 2]], away.y[[0, 2]], strict=True)]
    for off, stays in ((0.05, True), (0.2, True), (0.6, False)):
        start = [off, 2 * np.sin(p.theta0) + off / 2, 0.0, 0.0]
        assert (energy(*start[:2]) < min(saddles)) == stays
        motion = ss.simulate(p, **BELT, start=start, t_end=100.0)
        assert (motion.outcome().regime == Regime.LIFT_OFF) == stays
