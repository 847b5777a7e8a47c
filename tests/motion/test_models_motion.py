"""Motion of the shipped models: energy, both integrators, closed forms, and the article's model among them."""

from __future__ import annotations

import copy
import importlib
import importlib.util
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.dynamics import Event
from spragsym.models.load import shipped
from tests.conftest import Run

NAMES = shipped()
BACKENDS = ["scipy", *(["heyoka"] if importlib.util.find_spec("heyoka") else [])]


def parameters(model: Any, **changes: Any) -> Any:
    """Base values, and 49 degrees where the base has no inclination."""
    given = {"theta0": np.radians(49)} if "theta0" in model.parameters else {}
    return model.Parameters(**{**given, **changes})


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("name", NAMES)
def test_the_energy_changes_by_the_work_done(name: str, backend: str) -> None:
    """The integral of the powers over a motion with kinks is the change of energy: the quadrature is not the integrator's."""
    model = ss.load(name).search
    tr = ss.simulate(parameters(model), t_end=40.0, y0=0.02, backend=backend) if "y" in model.coordinates else None
    tr = tr or ss.simulate(parameters(model), t_end=40.0, backend=backend)
    energy = tr.energy()
    scale = np.abs(energy).max() + tr.integral(np.abs(tr.power()))
    assert abs(energy[-1] - energy[0] - tr.integral(tr.power())) < 3e-9 * scale
    if model.about["contact"]["unilateral"]:
        assert len(tr.events.of(Event.CONTACT_REGAINED)) >= 1
        gap = model.algebra.borders(*tr.events.of(Event.CONTACT_LOST, Event.CONTACT_REGAINED).state.T, *tr._arguments())[0]
        assert np.abs(gap).max() < 1e-11


@pytest.mark.skipif(len(BACKENDS) < 2, reason="the extra fast is not installed")
@pytest.mark.parametrize("name", NAMES)
def test_both_integrators_agree(name: str) -> None:
    model = ss.load(name).search
    ends = [ss.simulate(parameters(model), t_end=30.0, backend=backend).state[:, -1] for backend in BACKENDS]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-7)


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["trolley", "hertz_contact", "stribeck"])
def test_motion_against_another_integrator_of_the_kinked_field(name: str) -> None:
    """SciPy's implicit Radau on the field as a whole, in small steps: no modes, no events, no restart."""
    from scipy.integrate import solve_ivp

    model = ss.load(name).search
    p = parameters(model)
    taken, n = [float(value) for value in model.arguments(p, "motion")], len(model.coordinates)

    def field(_: float, state: Any) -> Any:
        return [*state[n:], *(float(value) for value in model.algebra.rhs(*state, *taken))]

    start = np.zeros(2 * n)
    run = solve_ivp(field, (0.0, 8.0), start, method="Radau", rtol=1e-9, atol=1e-11, max_step=0.02)
    np.testing.assert_allclose(ss.simulate(p, t_end=8.0).state[:, -1], run.y[:, -1], rtol=0, atol=1e-6)


def test_stick_slip_loses_its_stability_at_the_closed_form() -> None:
    """Hopf point of sliding: ζ = 2 μ_s v_s (V² − v_s²)/(V² + v_s²)², minus the slope of 2 μ_s v v_s/(v² + v_s²) at V.

    Just above it a deviation dies away, just below it grows, at the rate of the difference, (ζ − ζ_H)/2.
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


def test_arguments_that_make_no_sense() -> None:
    model = ss.load("trolley")
    p = model.Parameters(theta0=1.0)
    with pytest.raises(ss.ParameterTypeError, match="did you mean x_a0"):
        ss.simulate(p, xa0=1.0)
    with pytest.raises(ss.ParameterTypeError, match=r"kappa is no argument but a parameter; .*p\.replace\(kappa="):
        ss.simulate(p, kappa=0.01)
    with pytest.raises(ss.ParameterError, match="it is x0, y0, x_a0, vx0, vy0, vx_a0"):
        ss.simulate(p, start=[0.0, 0.0])
    with pytest.raises(ss.ParameterError, match="theta0 is missing"):
        ss.simulate(model.Parameters())
    with pytest.raises(ss.ParameterError, match="both ends of spring 1 on one point"):
        ss.simulate(p, x0=float(np.cos(1.0)), y0=float(np.sin(1.0)))
    with pytest.raises(AttributeError, match="no 'z'"):
        ss.simulate(p, t_end=1.0).z  # noqa: B018  # the access is the test


def test_a_trajectory_is_saved_with_its_model(tmp_path: Any) -> None:
    model = ss.load("trolley")
    tr = ss.simulate(model.Parameters(theta0=1.0), t_end=5.0, estimate_error=True)
    assert tr.error is not None
    assert tr.error.max() < 1e-6
    tr.save(tmp_path / "tr.csv")
    text = (tmp_path / "tr.csv").read_text(encoding="utf-8")
    assert "trolley" in text
    assert "x_a" in text


# ------------------------------------------------------------------------------------------------ sweeps


def test_a_start_where_a_spring_has_no_length_fails_alone() -> None:
    model = ss.load("kang_nam").search
    x0 = np.array([0.1, float(np.cos(1.0))])
    sweep = ss.rms_sweep(model.Parameters(theta0=1.0), t_end=10.0, x0=x0, y0=float(np.sin(1.0)))
    assert np.isfinite(sweep.rms).tolist() == [True, False]
    assert "on one point" in sweep.reason[1]


# ------------------------------------------------------------------------------------------------ the command line


def test_a_state_that_oscillates_does_not_pass_for_stable(run: Run) -> None:
    """Without damping, as (27), sliding of `stick_slip` is stable; the falling friction law makes it grow without a damper."""
    growth = []
    for damper in ("0", "0.9"):
        shown = run("equilibria", "--model", "stick_slip", "-V", "0.3", "--zeta", damper)
        header, row = (line.split() for line in shown.splitlines())
        assert row[header.index("undamped")] == "stable"
        assert (row[header.index("stability")] == "stable") == (damper == "0.9")
        growth.append(float(row[header.index("growth")]))
    assert growth[0] > 0 > growth[1]


@pytest.mark.thorough
def test_the_motion_of_a_model_is_drawn(tmp_path: Path, run: Run) -> None:
    pytest.importorskip("matplotlib")
    words = ("simulate", "--model", "trolley", "--theta0", "49", "--t-end", "20")
    run(*words, "--plot", str(tmp_path / "motion.svg"))
    drawn = (tmp_path / "motion.svg").read_text(encoding="utf-8")
    assert drawn.count('<g id="axes_') == 3 * 3  # coordinates: over time, plane, spectrum
    assert "the ending must be .pdf, .png or .svg" in run(*words, "--plot", str(tmp_path / "motion.doc"), code=2)


@pytest.mark.thorough
def test_a_component_is_drawn_by_its_name() -> None:
    """A trolley's third component is x_a, an article's is vx."""
    figures = pytest.importorskip("spragsym.figures")
    model = ss.load("trolley")
    motion = ss.simulate(model.Parameters(theta0=0.8), t_end=5.0, vx0=0.3, backend="scipy")
    for name in motion.components:
        line = figures.draw_motion(motion, name, pytest.importorskip("matplotlib.figure").Figure().add_subplot())
        assert line.get_ydata()[[0, -1]] == pytest.approx(getattr(motion, name)[[0, -1]])


def test_help_names_the_unit_of_time_of_the_model(run: Run) -> None:
    model = ss.load("stick_slip")
    unit = model.about["scales"]["time"].replace("**", "^")
    assert "k_c" not in unit
    assert f"in {unit}" in " ".join(run("simulate", "--model", "stick_slip", "--help").split())


def test_a_motion_can_be_copied_and_sent_to_another_process() -> None:
    model = ss.load("stick_slip")
    motion = ss.simulate(model.Parameters(), t_end=5.0)
    assert np.array_equal(copy.deepcopy(motion).x, motion.x)  # as a pickle takes it apart


def test_commands_name_what_is_wrong_with_a_model(run: Run) -> None:
    assert "did you mean trolley" in run("simulate", "--model", "troley", code=2)
    assert "did you mean --alpha_a" in run("simulate", "--model", "trolley", "--theta0", "49", "--alphaa", "1", code=2)
    assert "--theta0" in run("simulate", "--model", "trolley", code=2)


def test_a_sweep_tells_which_equilibrium_a_motion_comes_to():
    model = ss.load("damped")
    more = {"mu0": 0.7, "zeta_x": 0.5, "zeta_y": 0.5}
    sweep = ss.rms_sweep(model.Parameters(theta0=np.radians([30.0, 60.0]), **more), x0=[[0.0], [1.5]], t_end=200.0, rtol=1e-8)
    # At the friction μ(V), which the motion feels.
    friction = 0.7 * (1 - np.exp(-model.base["V"] * model.base["d"]))
    eq = ss.equilibria(model.Parameters(theta0=np.radians([30.0, 60.0]), **{**more, "mu0": friction}))
    rest = np.isin(sweep.regime, (ss.sweeps.Regime.EQUILIBRIUM, ss.sweeps.Regime.APPROACHES_EQUILIBRIUM))
    assert rest.any()
    assert ((sweep.equilibrium >= 0) == rest).all()
    for index in zip(*np.nonzero(rest), strict=True):
        assert abs(eq.x[index[1], sweep.equilibrium[index]] - sweep.mean[index]) < 1e-3
