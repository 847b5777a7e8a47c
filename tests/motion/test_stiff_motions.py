"""A light mass between a spring with a damper and a steep friction law: the steps of explicit
methods collapse.
"""

import types
from functools import partial

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.motion import with_compiled, with_heyoka, with_scipy
from spragsym.motion.integrators import Flow
from spragsym.motion.problem import check_stiffness
from spragsym.motion.sweeps import rms_sweep
from spragsym.orbits import finding
from spragsym.orbits.system import System
from tests.oracles.user_pages import model_of, shipped_page
from tests.orbits.test_cycles import CIRCLE

BRISTLE = """r'''A mass that drags a light mass over a belt.'''
from spragsym.derive.model import Page, tanh
page = Page("A mass that drags a light mass over a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
N_0 = page.unit("N_0", "N", "normal force")
d = page.parameter("d", "s/m", "steepness", "> 0", 1e4)
m_b = page.parameter("m_b", "kg", "light mass", "> 0", 1e-4, becomes="eps")
k_b = page.parameter("k_b", "N/m", "its spring", "> 0", 100.0, becomes="stiff")
c_b = page.parameter("c_b", "N s/m", "its damper", ">= 0", 10.0, becomes="loss")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.2)
x = page.coordinate("x", "m", "displacement")
b = page.coordinate("b", "m", "displacement of the light mass")
page.kinetic((m * page.rate(x) ** 2 + m_b * page.rate(b) ** 2) / 2)
page.spring(k, along=x)
page.spring(k_b, along=x - b)
page.damper(c_b, along=x - b)
page.normal_force(N_0)
page.friction(b, V, lambda v: tanh(d * v))
"""


@pytest.mark.thorough
def test_an_implicit_method_takes_over_where_steps_collapse() -> None:
    p = model_of(BRISTLE, "bristle").Parameters()
    motion = ss.simulate(p, start=(0.5, 0.5, 0.0, 0.0), t_end=3.0)

    def rates(_: float, y: np.ndarray) -> list[float]:
        pull = 100 * (y[0] - y[1]) + 10 * (y[2] - y[3])
        return [y[2], y[3], -y[0] - pull, (pull + np.tanh(1e4 * (0.2 - y[3]))) / 1e-4]

    found = solve_ivp(rates, (0, 3.0), [0.5, 0.5, 0.0, 0.0], method="BDF", rtol=1e-9, atol=1e-12)
    assert motion.state[:, -1] == pytest.approx(found.y[:, -1], abs=1e-6)
    assert motion.implicit
    assert not ss.simulate(
        p.replace(d=10.0, eps=0.1), start=(0.5, 0.5, 0.0, 0.0), t_end=3.0
    ).implicit


@pytest.mark.by_hand("spragsym.motion.with_heyoka")
@pytest.mark.thorough
@pytest.mark.parametrize("integrator", [with_compiled, with_heyoka])
def test_what_is_compiled_and_a_cycle_go_over_as_well(
    integrator: types.ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where few steps are too many: a motion that the explicit method carries too, and a cycle that
    is a circle.
    """
    follow = partial(
        ss.simulate,
        ss.Parameters.article(theta0=0.85, kappa=1.0),
        V=0.5,
        d=1e4,
        t_end=5.0,
        backend="compiled",
    )
    explicit = follow() if integrator is with_compiled else None
    monkeypatch.setattr(integrator, "check_stiffness", partial(check_stiffness, most=10.0))
    monkeypatch.setattr(integrator, "BURST", 20)
    if explicit is None:
        found = finding.cycle_at(System(Flow.of(CIRCLE, None), (100.0,)), np.array([9.9, 0.0]), 6.3)
        assert [found.period, found.amplitude] == pytest.approx([2 * np.pi, 10.0], abs=1e-9)
    else:
        assert (explicit.implicit, follow().implicit) == (False, True)
        assert follow().state[:, -1] == pytest.approx(explicit.state[:, -1], abs=1e-6)
        monkeypatch.setattr(with_scipy, "MAX_STEPS", 20)
        with pytest.raises(
            ss.errors.ConvergenceError, match="than 1e-12,"
        ):  # by which it is integrated, as tight as Radau goes
            follow(rtol=1e-13)


@pytest.mark.parametrize(
    "backend",
    [
        pytest.param("heyoka", marks=pytest.mark.thorough),
        pytest.param("scipy", marks=pytest.mark.validate),
    ],
)
def test_sweeps_and_flows_go_over_too(backend: str) -> None:
    pytest.importorskip(backend)
    p = model_of(BRISTLE, "bristle").Parameters()
    motion = ss.simulate(p, start=(0.5, 0.5, 0.0, 0.0), t_end=1.0, backend=backend)
    assert motion.implicit
    sweep = rms_sweep(p, x0=0.5, b0=0.5, t_end=1.0, transient=0.5, backend=backend)
    assert sweep.reason == ""
    assert sweep.rms == pytest.approx(motion.rms(0.5), abs=1e-6)
    system = System.of(p, backend)
    passage = system.flow.plain(motion.state[:, 0], system.constants, 1.0)
    assert passage.state == pytest.approx(motion.state[:, -1], abs=1e-6)


@pytest.mark.thorough
@pytest.mark.parametrize("d", [30.0, 300.0, 5000.0])
def test_a_steep_force_of_the_place_is_not_passed_unseen(d: float) -> None:
    page = shipped_page(
        "stick_slip",
        ("import Page", "import Page, tanh"),
        ("page.damper(c, along=x)", "page.force(-F * tanh(x / L), along=x)"),
        (
            'c = page.parameter("c", "N s/m", "damper beside the spring", ">= 0", 0.05, '
            'becomes="zeta")',
            'F = page.parameter("F", "N", "force", "> 0", 0.3)\nL = page.parameter("L", "m", '
            '"width", "> 0", 0.01)',
        ),
    )
    p = model_of(page, "steep_force").Parameters(mu_s=0.0, F=0.3, L=1 / d)
    motion = ss.simulate(p, start=(1.0, 0.0), t_end=20.0)
    energy = (
        motion.vx**2 / 2
        + motion.x**2 / 2
        + 0.3 / d * (np.logaddexp(d * motion.x, -d * motion.x) - np.log(2))
    )
    assert energy == pytest.approx(energy[0], abs=1e-8)


def test_what_does_not_press_has_no_friction_however_steep_its_law() -> None:
    """In lift-off the mass swings to and fro in 5e-3 units of time, at speeds 6000 times those in
    which friction falls: energy changes by dampers alone, of which there are none.
    """
    p = ss.load("stribeck").Parameters(
        theta0=0.63, kappa=0.0085, alpha=3.8e5, sigma=12.2, mu_s=4.3e5, mu_k=2e-5, v_s=3e-4, V=0.0
    )
    start = (-0.29, 0.305, 0.11, 0.023)
    tr = ss.simulate(p, start=start, t_end=0.02, backend="scipy", rtol=1e-11)
    assert tr.y.min() > 0
    assert not tr.friction_force().any()
    assert not tr.friction_power().any()
    assert np.ptp(tr.energy()) < 1e-6 * tr.energy()[0]
