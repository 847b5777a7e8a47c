"""Torsion springs: the energy k φ²/2 of the least turning φ, against the same written by hand."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from tests.conftest import Once
from tests.test_documents import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "tests/soft_brake.py"
#: Places (x, y) and angles θ₀: near rest, far turned, beside the ray φ = ±π, close to the anchor.
PLACES = [(0.1, -0.02, 0.8), (1.3, 0.2, 0.8), (1.5, 1.2, 0.8), (1.4, 1.46, 0.7), (0.69, 0.72, 0.8), (-0.5, 2.0, 2.2)]
VALUES = {"mu0": 0.5, "kappa": 0.007, "alpha": 0.007, "sigma": 0.1, "tau": 0.03, "gamma": 5.0, "V": 0.5, "d": 10.0}


@pytest.fixture(scope="module")
def model(once: Once, tmp_path_factory: pytest.TempPathFactory) -> Any:
    from spragsym.derive import folder

    def derived() -> str:
        out = tmp_path_factory.mktemp("torsion") / "soft_brake"
        folder.write_page(PAGE, out)
        return str(out)

    return ss.load(once("soft_brake", derived))


def turning(x: Any, y: Any, theta0: Any) -> Any:
    """θ − θ₀, the least turning, from the drawing."""
    off = mpmath.atan2(mpmath.sin(theta0) - y, mpmath.cos(theta0) - x) - theta0
    return off + 2 * mpmath.pi if off <= -mpmath.pi else off - 2 * mpmath.pi if off > mpmath.pi else off


def energy(x: Any, y: Any, theta0: Any) -> Any:
    """Springs, torsion spring, preload and contact."""
    it = {name: mpmath.mpf(value) for name, value in VALUES.items()}
    length = mpmath.hypot(mpmath.cos(theta0) - x, mpmath.sin(theta0) - y)
    depth = max(-y, mpmath.mpf(0))
    total = it["alpha"] * x**2 / 2 + it["sigma"] * (length - 1) ** 2 / 2 + it["tau"] * turning(x, y, theta0) ** 2 / 2
    return total + it["kappa"] * y + depth**2 / 2 + it["gamma"] * depth**3 / 3


def state(model: Any, x: Any, y: Any, theta0: Any) -> tuple[list[Any], list[Any]]:
    """Arguments of the functions of statics up to μ and pushing, in 50 digits, and those of motion."""
    known = {
        **{name: mpmath.mpf(value) for name, value in VALUES.items()},
        "cos0": mpmath.cos(theta0),
        "sin0": mpmath.sin(theta0),
    }
    given, moving = ([known[name] for name in model.about["arguments"][kind]] for kind in ("statics", "motion"))
    length = mpmath.hypot(known["cos0"] - x, known["sin0"] - y)
    direction = [(known["cos0"] - x) / length, (known["sin0"] - y) / length, length]
    return [x, y, *direction, turning(x, y, theta0), *given], moving


@pytest.mark.parametrize("place", PLACES)
def test_forces_and_stiffness_are_derivatives_of_the_energy(model: Any, place: tuple[float, float, float]) -> None:
    with mpmath.workdps(50):
        x, y, theta0 = map(mpmath.mpf, place)
        taken, moving = state(model, x, y, theta0)
        pushing = int(y < 0)
        forces = model.statics.forces(*taken, 0, pushing, xp=mpmath)
        stiffness = model.statics.forces_jacobian(*taken, 0, pushing, xp=mpmath)
        by_angle = model.statics.forces_by_parameters(*taken, 0, pushing, xp=mpmath)
        at = x, y, theta0
        for row in range(2):
            order = tuple(int(i == row) for i in range(3))
            assert abs(forces[row] - mpmath.diff(energy, at, order)) < 1e-20
            for column in range(2):
                second = tuple(a + int(i == column) for i, a in enumerate(order))
                assert abs(stiffness[row][column] - mpmath.diff(energy, at, second)) < 1e-12
            assert abs(by_angle[row][0] - mpmath.diff(energy, at, (*order[:2], 1))) < 1e-12
        stored = model.motion.energy(x, y, 0, 0, *moving, pushing, xp=mpmath)
        assert abs(stored - energy(*at)) < 1e-40


def test_turning_of_statics_and_of_motion_is_the_least(model: Any) -> None:
    """Cosine and sine of the turning; and accelerations on either way are those of the least turning where that is on the way."""
    for x, y, theta0 in PLACES:
        with mpmath.workdps(50):
            taken, moving = state(model, *map(mpmath.mpf, (x, y, theta0)))
            ((cosine, sine),) = model.statics.turnings(*taken[:5], *taken[6:], xp=mpmath)
            assert abs(mpmath.atan2(sine, cosine) - taken[5]) < 1e-45
            rows = [model.motion.regime_rhs(taken[0], taken[1], 0.1, 0.2, *moving, 1, 1, 1, way, xp=mpmath) for way in (1, -1)]
            static = model.statics.forces(*taken, 0, 1, xp=mpmath)
            assert abs(rows[0 if sine > 0 else 1][1] + static[1]) < 1e-45
            other = (taken[5] - mpmath.sign(sine) * 2 * mpmath.pi) if cosine < 0 else taken[5]
            turned = model.statics.forces(*taken[:5], other, *taken[6:], 0, 1, xp=mpmath)
            assert abs(rows[1 if sine > 0 else 0][1] + turned[1]) < 1e-45


def hand(model: Any, p: Any) -> Any:
    """The right-hand side of the motion, written by hand from the drawing."""
    names = ("theta0", "mu0", "kappa", "alpha", "sigma", "tau", "gamma", "V", "d")
    theta0, mu0, kappa, alpha, sigma, tau, gamma, V, d = (float(value) for value in p.scalars(*names))

    def rates(_: float, state: Any) -> Any:
        x, y, vx, vy = state
        dx, dy = np.cos(theta0) - x, np.sin(theta0) - y
        length, depth, slip = np.hypot(dx, dy), max(-y, 0.0), V - vx
        phi = np.remainder(np.arctan2(dy, dx) - theta0 + np.pi, 2 * np.pi) - np.pi
        pull, torque = sigma * (length - 1), tau * phi
        normal = depth + gamma * depth**2
        mu = mu0 * (1 - np.exp(-d * abs(slip))) * np.sign(slip)
        fx = pull * dx / length - torque * dy / length**2 - alpha * x + mu * normal
        fy = pull * dy / length + torque * dx / length**2 - kappa + normal
        return [vx, vy, fx, fy]

    return rates


def behind(p: Any, off: float, speed: float) -> list[float]:
    """A start near the ray φ = ±π, turned by ``off`` from it, and moving along the circle around the anchor."""
    theta0 = float(p.scalars("theta0")[0])
    ray, along = np.array([np.cos(theta0), np.sin(theta0)]), np.array([-np.sin(theta0), np.cos(theta0)])
    return [*(2.2 * ray + off * along), *(speed * along)]


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_motion_behind_the_anchor_goes_on_with_the_least_turning(model: Any, backend: str) -> None:
    """Against SciPy with a right-hand side of our own, stopped where the torque jumps; the energy changes by the powers alone."""
    from scipy.integrate import solve_ivp

    if backend == "heyoka":
        pytest.importorskip("heyoka")
    p = model.Parameters(tau=0.02, mu0=0.3)
    start, rates = behind(p, -0.1, 0.5), hand(model, p)
    tr = model.simulate(p, start=start, t_end=3.0, backend=backend, rtol=1e-12)

    def jump(_: float, state: Any) -> float:
        return float(np.sin(0.8) * (state[0] - np.cos(0.8)) - np.cos(0.8) * (state[1] - np.sin(0.8)))

    jump.terminal = True  # type: ignore[attr-defined]  # as solve_ivp asks for it
    options = {"rtol": 1e-12, "atol": 1e-13, "method": "DOP853"}
    first = solve_ivp(rates, (0.0, 3.0), start, events=jump, **options)
    assert first.status == 1
    assert 0.1 < first.t[-1] < 0.3
    beyond = first.y[:, -1] + 1e-13 * first.y[[2, 3, 2, 3], -1] * [1, 1, 0, 0]
    rest = solve_ivp(rates, (first.t[-1], 3.0), beyond, **options)
    assert np.abs(tr.state[:, -1] - rest.y[:, -1]).max() < 1e-9
    turned = np.arctan2(np.sin(0.8) - tr.y, np.cos(0.8) - tr.x)
    phi = np.remainder(turned - 0.8 + np.pi, 2 * np.pi) - np.pi
    assert np.count_nonzero(np.abs(np.diff(phi)) > 6) == 1
    work = float(np.sum((tr.power()[1:] + tr.power()[:-1]) / 2 * np.diff(tr.t)))
    assert tr.energy()[-1] - tr.energy()[0] == pytest.approx(work, abs=1e-5)


def test_a_motion_too_slow_for_the_ray_is_pushed_back(model: Any) -> None:
    """The torque points away from the ray on both sides, as the energy has its largest value there."""
    p = model.Parameters(tau=0.5, mu0=0.3)
    for sign in (1, -1):
        tr = model.simulate(p, start=behind(p, -0.1 * sign, 0.05 * sign), t_end=2.0)
        off = np.sin(0.8) * tr.x - np.cos(0.8) * tr.y
        assert (np.sign(off[0]) == np.sign(off)).all()
        assert abs(off[-1]) > 0.2
