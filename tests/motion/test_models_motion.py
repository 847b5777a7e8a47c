"""Motion of the shipped models: energy, both integrators, closed forms, and the article's model
among them.
"""

import importlib
import importlib.util
import math
from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.load import shipped
from spragsym.motion import Event, integrators
from tests.conftest import Run
from tests.oracles.user_pages import alone
from tests.support import few

NAMES = shipped()
BACKENDS = ["scipy", *(["heyoka"] if importlib.util.find_spec("heyoka") else [])]


def parameters(model: Any, **changes: Any) -> Any:
    """Base values, and 49 degrees where the base has no inclination."""
    given = {"theta0": np.radians(49)} if "theta0" in model.parameters else {}
    return model.Parameters(**{**given, **changes})


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.by_hand("damped", "inclined_belt", "cubic_contact", "stribeck")
@pytest.mark.parametrize("name", few(NAMES, "kang_nam", "stick_slip", "sprag_rod"))
def test_the_energy_changes_by_the_work_done(name: str, backend: str) -> None:
    """The integral of the powers over a motion with kinks is the change of energy: the quadrature
    is not the integrator's.
    """
    model = ss.load(name).search
    aside = "y" if "y" in model.coordinates else "b"
    begin = {f"{aside}0": 0.02} if aside in model.coordinates else {}
    tr = ss.simulate(parameters(model), t_end=40.0, backend=backend, **begin)
    energy = tr.energy()
    scale = np.abs(energy).max() + tr.integral(np.abs(tr.power()))
    assert abs(energy[-1] - energy[0] - tr.integral(tr.power())) < 3e-9 * scale
    for k, contact in enumerate(model.about["contacts"]):
        if contact["unilateral"]:
            own = tr.events.on(contact["name"]) if contact["name"] else tr.events
            assert len(own.of(Event.CONTACT_REGAINED)) >= 1
            passed = own.of(Event.CONTACT_LOST, Event.CONTACT_REGAINED).state.T
            gap = model.algebra.borders(*passed, *tr._arguments())[k]
            assert np.abs(gap).max() < 1e-11


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["trolley", "hertz_contact", "stribeck"])
def test_motion_against_another_integrator_of_the_kinked_field(name: str) -> None:
    """SciPy's implicit Radau on the field as a whole, in small steps: no modes, no events, no
    restart.
    """
    from scipy.integrate import solve_ivp

    model = ss.load(name).search
    p = parameters(model)
    taken, n = [float(value) for value in model.arguments(p, "motion")], len(model.coordinates)
    kinked = alone(name).algebra.rhs

    def field(_: float, state: Any) -> Any:
        return [*state[n:], *(float(value) for value in kinked(*state, *taken))]

    start = np.zeros(2 * n)
    run = solve_ivp(field, (0.0, 8.0), start, method="Radau", rtol=1e-9, atol=1e-11, max_step=0.02)
    np.testing.assert_allclose(
        ss.simulate(p, t_end=8.0).state[:, -1], run.y[:, -1], rtol=0, atol=1e-6
    )


def test_stick_slip_loses_its_stability_at_the_closed_form() -> None:
    """Hopf point of sliding: ζ = 2 μ_s v_s (V² − v_s²)/(V² + v_s²)², minus the slope of 2 μ_s v
    v_s/(v² + v_s²) at V.

    Just above it a deviation dies away, just below it grows, at the rate of the difference, (ζ −
    ζ_H)/2.
    """
    model = ss.load("stick_slip")
    mu_s, v_s, V = 0.5, 0.1, 0.5
    hopf = 2 * mu_s * v_s * (V**2 - v_s**2) / (V**2 + v_s**2) ** 2
    rest = 2 * mu_s * V * v_s / (V**2 + v_s**2)
    for change in (0.02, -0.02):
        p = model.Parameters(mu_s=mu_s, v_s=v_s, V=V, zeta=hopf + change)
        C = model.algebra.damping(rest, *model.arguments(p, "motion"), 1)
        assert abs(float(C[0][0]) - change) < 1e-14
        tr = ss.simulate(p, x0=rest + 1e-5, t_end=40 * np.pi, rtol=1e-12)
        size = np.hypot(tr.x - rest, tr.vx)
        assert abs(np.log(size[-1] / size[0]) / tr.t[-1] + change / 2) < 1e-3


# ------------------------------------------------------------------------------------------------
# the command line


def test_a_state_that_oscillates_does_not_pass_for_stable(run: Run) -> None:
    """Without damping, as (27), sliding of `stick_slip` is stable; the falling friction law makes
    it grow without a damper.
    """
    growth = []
    for damper in ("0", "0.9"):
        shown = run("equilibria", "--model", "stick_slip", "-V", "0.3", "--zeta", damper)
        header, row = (line.split() for line in shown.splitlines())
        assert row[header.index("undamped")] == "stable"
        assert row[header.index("stability")] == ("stable" if damper == "0.9" else "unstable")
        growth.append(float(row[header.index("growth")]))
    assert growth[0] > 0 > growth[1]


def test_a_sweep_tells_which_equilibrium_a_motion_comes_to():
    model = ss.load("damped")
    more = {"mu0": 0.7, "zeta_x": 0.5, "zeta_y": 0.5}
    sweep = ss.rms_sweep(
        model.Parameters(theta0=np.radians([30.0, 60.0]), **more),
        x0=[[0.0], [1.5]],
        t_end=200.0,
        rtol=1e-8,
    )
    # At the friction μ(V), which the motion feels.
    friction = 0.7 * (1 - np.exp(-model.base["V"] * model.base["d"]))
    eq = ss.equilibria(
        model.Parameters(theta0=np.radians([30.0, 60.0]), **{**more, "mu0": friction})
    )
    rest = np.isin(sweep.regime, (ss.Regime.EQUILIBRIUM, ss.Regime.APPROACHES_EQUILIBRIUM))
    assert rest.any()
    assert ((sweep.equilibrium >= 0) == rest).all()
    for index in zip(*np.nonzero(rest), strict=True):
        assert abs(eq.x[index[1], sweep.equilibrium[index]] - sweep.mean[index]) < 1e-3


@pytest.mark.skipif("heyoka" not in BACKENDS, reason="heyoka is not installed")
@pytest.mark.parametrize("asked", [ss.simulate, ss.rms_sweep])
def test_a_tolerance_that_a_curved_border_does_not_let_act_is_refused(
    asked: Callable[..., Any],
) -> None:
    """SciPy's steps have it, without a friction that sticks there."""
    p = ss.load("sprag_rod").Parameters(theta0=0.85)
    with pytest.raises(ss.errors.ParameterError, match=r"rtol = 1e-06: .* give at most 1e-10"):
        asked(p, t_end=1.0, rtol=1e-6, backend="heyoka")
    assert ss.simulate(p, t_end=1.0, rtol=1e-6, backend="scipy").rtol == 1e-6


@pytest.mark.validate
@pytest.mark.skipif("heyoka" not in BACKENDS, reason="heyoka is not installed")
def test_on_a_curved_border_the_error_is_that_to_a_run_of_other_steps() -> None:
    """heyoka has one tolerance there: a second run of its own would be the first one, on the
    bit.
    """
    p = ss.load("sprag_rod").Parameters(theta0=0.85)
    tr = ss.simulate(p, t_end=30.0, backend="heyoka", estimate_error=True)
    other = ss.simulate(p, t_end=30.0, rtol=1e-13, backend="scipy")
    assert tr.rtol < 1e-13
    assert tr.error is not None
    assert 0.0 < tr.error[-1] < 1e-10
    assert np.abs(tr.state - other(np.minimum(tr.t, other.t[-1]))).max() < 1e-10


@pytest.mark.thorough
def test_a_stated_error_is_no_less_than_the_true_one() -> None:
    """Drawn over a model of curved borders, by SciPy alone, whose two runs are alike where steps
    are few; true is what a run of another method gives, rounding aside.
    """
    pytest.importorskip("heyoka")
    model = ss.load("sprag_rod")
    # In the first the finest run has a tenth of the error, between its steps.
    for seed in ([11, 130], *([75, i] for i in range(6))):
        rng = np.random.default_rng(seed)
        p = model.Parameters(theta0=rng.uniform(0.5, 1.2), V=rng.uniform(0.1, 1.0))
        start = 0.02 * rng.standard_normal(2)
        rtol = float(10 ** rng.uniform(-12.0, -4.0))
        given = {"start": start, "t_end": rng.uniform(5.0, 40.0)}
        exact = ss.simulate(p, **given, rtol=1e-13, backend="heyoka")
        with patch.object(integrators, "is_there", lambda name: name != "heyoka"):
            tr = ss.simulate(p, **given, rtol=rtol, backend="scipy", estimate_error=True)
        assert tr.error is not None
        true = np.abs(tr.state - exact(np.minimum(tr.t, exact.t[-1]))).max(axis=0)
        assert (true <= tr.error + 1e-14 * np.abs(tr.state).max()).all(), (p, given, rtol)


def test_in_lift_off_friction_is_zero_however_fast_the_mass_overtakes_the_belt() -> None:
    """On the other side of the sliding speed the law would be exp(d |w|), beyond all floats."""
    p = ss.load("cubic_contact").Parameters(theta0=0.9, mu0=0.3, d=2000.0, V=0.1)
    tr = ss.simulate(p, start=(0.0, 0.5, 3.0, 0.0), t_end=0.1, backend="scipy")
    assert tr.state[1].min() > 0
    assert not tr.friction_force().any()
    assert not tr.power().any()


def test_an_error_that_rounding_makes_is_told() -> None:
    """On a belt as slow as 1e-10 what rounds in x, 1e-16, moves the slip by 1e-6; and no error is
    told of a run that none is much tighter than.
    """
    p = ss.load("coulomb_stick_slip").Parameters(V=1e-10)
    begun = (0.6 - 0.59) / 1e-10
    tr = ss.simulate(
        p, start=(0.59, 1e-10), t_end=begun + 3.0, backend="scipy", estimate_error=True
    )
    since = tr.t[-1] - begun
    x, v = 0.4 + 0.2 * math.cos(since), -0.2 * math.sin(since)
    assert tr.error is not None
    assert np.abs(tr.state[:, -1] - [x, v]).max() < tr.error[-1] < 1e-2
    with patch.object(integrators, "is_there", lambda name: name == "scipy"):
        tr = ss.simulate(p, t_end=1.0, rtol=1e-13, backend="scipy", estimate_error=True)
    assert tr.error is not None
    assert np.isnan(tr.error).all()
