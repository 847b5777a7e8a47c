"""Motions, cycles and onsets in a frame that turns, against closed forms and the frame that stands.

In the frame that stands a rotor with damping of the shaft c_i and of the ground c_e whirls at c_i W/
(c_i + c_e); the whirl sets in where that is √k, and has the radius r with k + g r² = its square.
"""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.turning_frames import ROTOR, rotor
from tests.oracles.user_pages import model_of, replaced

#: The same shaft in the frame that stands, turned by a clock s, which keeps the rate W.
STANDING = '''r"""A disc on a shaft, in the frame that stands.

::

    s counts the angle of the shaft
"""

from spragsym.derive.model import Page, cos, sin

page = Page("A disc on a shaft, in the frame that stands, and a clock.")

m = page.unit("m", "kg", "mass")
T = page.unit("T", "s", "unit of time")
L = page.unit("L", "m", "unit of length")
k_x = page.parameter("k_x", "N/m", "stiffness along x", "> 0", 1.0)
k_y = page.parameter("k_y", "N/m", "stiffness along y", "> 0", 2.25)
c_i = page.parameter("c_i", "N s/m", "damping of the shaft", ">= 0", 0.0)
c_e = page.parameter("c_e", "N s/m", "damping of the ground", ">= 0", 0.0)
g = page.parameter("g", "N/m^3", "hardening of the shaft", "real", 0.0)
W = page.parameter("W", "1/s", "speed of the shaft", "real", 0.5)
b = page.parameter("b", "N m s", "what holds the clock", "> 0", 0.7)

X = page.coordinate("X", "m", "displacement")
Y = page.coordinate("Y", "m", "displacement across")
s = page.coordinate("s", "rad", "clock")

page.kinetic((m * page.rate(X) ** 2 + m * page.rate(Y) ** 2 + m * L**2 * page.rate(s) ** 2) / 2)
x, y = X * cos(s) + Y * sin(s), Y * cos(s) - X * sin(s)
page.force(-k_x * x * cos(s) + k_y * y * sin(s), along=X)
page.force(-k_x * x * sin(s) - k_y * y * cos(s), along=Y)
page.potential(g * (X**2 + Y**2) ** 2 / 4)
page.damper(c_i + c_e, along=X)
page.damper(c_i + c_e, along=Y)
page.force(-c_i * W * Y, along=X)
page.force(c_i * W * X, along=Y)
page.damper(b, along=s)
page.force(b * W, along=s)
'''


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["scipy", "heyoka"])
def test_a_motion_is_that_of_the_frame_that_stands(backend: str) -> None:
    rng = np.random.default_rng(3)
    turning, standing = rotor(), model_of(STANDING, "standing")
    names = ("k_x", "k_y", "c_i", "c_e", "g", "W")
    for _ in range(2):
        given = dict(zip(names, rng.uniform(0.1, 1.5, 6).tolist(), strict=True))
        x, y, v, w = rng.uniform(-0.5, 0.5, 4).tolist()
        W = given["W"]
        begin = {"x0": x, "y0": y, "vx0": v, "vy0": w}
        one = ss.simulate(turning.Parameters(f=0.0, **given), t_end=20.0, backend=backend, **begin)
        begin = {"X0": x, "Y0": y, "vX0": v - W * y, "vY0": w + W * x, "vs0": W}
        other = ss.simulate(standing.Parameters(**given), t_end=20.0, backend=backend, **begin)
        X, Y, s, *_ = other(one.t)
        assert np.abs(s - W * one.t).max() < 1e-9
        assert np.abs(one.x - X * np.cos(s) - Y * np.sin(s)).max() < 1e-7
        assert np.abs(one.y + X * np.sin(s) - Y * np.cos(s)).max() < 1e-7


def test_the_energy_that_stays_is_the_integral_of_jacobi() -> None:
    motion = ss.simulate(rotor().Parameters(f=0.0, g=0.8), x0=0.4, vy0=0.3, t_end=50.0)
    W, (x, y, v, w) = motion.p.W, motion.state
    r = x**2 + y**2
    jacobi = (v**2 + w**2 + x**2 + 2.25 * y**2 + 0.4 * r**2 - W**2 * r) / 2
    assert np.abs(motion.energy() - jacobi).max() < 1e-14
    assert np.ptp(jacobi) < 1e-9 * jacobi[0]


@pytest.mark.thorough
def test_the_whirl_of_a_rotor_has_its_closed_form() -> None:
    model, rng = rotor(), np.random.default_rng(8)
    for _ in range(2):
        c_i, c_e, k, g = rng.uniform(0.2, 1.5, 4).tolist()
        p = model.Parameters(k_x=k, k_y=k, c_i=c_i, c_e=c_e, g=g, f=0.0)
        c, own = c_i + c_e, np.sqrt(k)
        onset = own * c / c_i
        found = ss.flutter_onsets(p, "W", between={"W": (0.6 * onset, 1.5 * onset)})
        assert len(found) == 1
        assert found.W[0] == pytest.approx(onset, rel=1e-12)
        omega, crossing = onset - own, 2 * own * c_i / (c**2 + 4 * k)
        assert found.omega[0] == pytest.approx(omega, rel=1e-12)
        assert found.crossing[0] == pytest.approx(crossing, rel=1e-10)
        # |z|² of the eigenvector of length 1, per W, is (1 + ω²) d(r²)/dW / 2.
        growing = own * c_i / c / g * (1 + omega**2)
        assert found.lyapunov[0] == pytest.approx(-crossing / (omega * growing), rel=1e-10)
        W = 1.3 * onset
        p, r = p.replace(W=W), np.sqrt(((c_i * W / c) ** 2 - k) / g)
        cycle = ss.cycle(p, ss.simulate(p, x0=0.9 * r, t_end=100.0))
        assert cycle.period == pytest.approx(2 * np.pi / (W - c_i * W / c), rel=1e-11)
        assert cycle.amplitude == pytest.approx(r, rel=1e-9)
        # z″ + c z′ + (k + g |z|²) z = i c_i W z about the circle, in the frame that turns with it.
        nu, two = c_i * W / c, 2 * g * r**2
        turning = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-two, 0, -c, 2 * nu], [0, 0, -2 * nu, -c]])
        exact = np.exp(np.linalg.eigvals(turning) * cycle.period)
        for one in cycle.multipliers:
            assert np.abs(exact - one).min() < 1e-8
        branch = ss.cycle_branch(cycle, "W", between={"W": (1.1 * onset, 1.5 * onset)})
        squares = ((c_i * branch.values / c) ** 2 - k) / g
        assert np.abs(branch.highest - np.sqrt(squares)).max() < 1e-8


@pytest.mark.thorough
def test_the_coefficient_at_an_onset_is_that_of_the_cycles_born_there() -> None:
    """With forces of second order, in a frame that turns: |z|² per W is −crossing/(ω l₁), and the
    cycle about its mean 2 |z|², as its amplitude goes to 0.
    """
    pushed = "page.potential(0.7 * m / T**2 / L * (x**3 / 3 + x * y**2))\n"
    damper = "page.damper(c_i + c_e, along=x)"
    model = model_of(replaced(ROTOR, (damper, pushed + damper)), "leaning_rotor")
    p = model.Parameters(k_x=1.3, k_y=1.0, c_i=0.5, c_e=0.4, g=0.6, f=0.0)
    onset = ss.flutter_onsets(p, "W", between={"W": (1.2, 3.5)})
    found = []
    for amplitude in (0.02, 0.01):
        cycle = ss.cycle(onset=onset, amplitude=amplitude)
        states = cycle.samples(np.linspace(0, cycle.period, 513)[:-1])
        apart = states.var(axis=1).sum() / 2
        found.append(apart / (cycle.parameters["W"] - float(onset.W[0])))
    coarse, fine = found
    known = -float(onset.crossing[0] / (onset.omega[0] * onset.lyapunov[0]))
    assert (4 * fine - coarse) / 3 == pytest.approx(known, rel=1e-6)


@pytest.mark.thorough
def test_the_compiled_backend_moves_as_the_others() -> None:
    p = rotor().Parameters(k_x=1.0, k_y=1.0, c_i=0.3, c_e=0.2, g=0.5, f=0.0, W=np.array([1.9, 2.3]))
    swept = ss.rms_sweep(p, x0=0.3, t_end=200.0)
    for row, W in enumerate(p.W.tolist()):
        alone = ss.simulate(p.replace(W=W), x0=0.3, t_end=200.0)
        assert swept.rms[row] == pytest.approx(alone.rms(), rel=1e-6)


def test_without_damping_nothing_sets_in_where_every_state_grows() -> None:
    found = ss.flutter_onsets(rotor().Parameters(), "f", damping=False, between={"f": (0.1, 0.5)})
    assert not len(found)
    assert found.complete  # decided, by the odd coefficients, at all states
    assert "some λ grows in every state" in found.remarks[0]
