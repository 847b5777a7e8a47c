"""Torsion springs: the energy k φ²/2 of the least turning φ, against the same written by hand."""

import math
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.numerics.interval_arrays import Intervals, atan2
from tests.oracles.user_pages import model_of
from tests.support import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "tests/oracles/pages/soft_brake.py"


@pytest.fixture(scope="module")
def model() -> Any:
    return model_of(PAGE.read_text(encoding="utf-8"), "soft_brake")


def turning(x: Any, y: Any, theta0: Any, xp: Any = mpmath) -> Any:
    """θ − θ₀, the least turning, from the drawing."""
    off = xp.atan2(xp.sin(theta0) - y, xp.cos(theta0) - x) - theta0
    return off + 2 * xp.pi if off <= -xp.pi else off - 2 * xp.pi if off > xp.pi else off


def forces(
    x: Any, y: Any, p: dict[str, Any], mu: Any, pushing: bool, xp: Any = mpmath
) -> tuple[Any, Any]:
    """Both components of the force on the mass, from the drawing."""
    dx, dy = xp.cos(p["theta0"]) - x, xp.sin(p["theta0"]) - y
    square = dx * dx + dy * dy
    length = xp.sqrt(square)
    pull, torque = p["sigma"] * (length - 1), p["tau"] * turning(x, y, p["theta0"], xp)
    normal = pushing * (-y + p["gamma"] * y**2)
    return (
        pull * dx / length - torque * dy / square - p["alpha"] * x + mu * normal,
        pull * dy / length + torque * dx / square - p["kappa"] + normal,
    )


def behind(p: Any, off: float, speed: float) -> list[float]:
    """A start near the ray φ = ±π, turned by ``off`` from it, and moving along the circle around
    the anchor.
    """
    theta0 = float(p.scalars("theta0")[0])
    ray, along = (
        np.array([np.cos(theta0), np.sin(theta0)]),
        np.array([-np.sin(theta0), np.cos(theta0)]),
    )
    return [*(2.2 * ray + off * along), *(speed * along)]


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_motion_behind_the_anchor_goes_on_with_the_least_turning(
    model: Any, backend: str
) -> None:
    """Against SciPy with a right-hand side of our own, stopped where the torque jumps; the energy
    changes by the powers alone.
    """
    from scipy.integrate import solve_ivp

    if backend == "heyoka":
        pytest.importorskip("heyoka")
    p = model.Parameters(tau=0.02, mu0=0.3)
    start, given = (
        behind(p, -0.1, 0.5),
        dict(zip(model.parameters, map(float, p.scalars(*model.parameters)), strict=True)),
    )
    tr = ss.simulate(p, start=start, t_end=3.0, backend=backend, rtol=1e-12)

    def rates(_: float, state: Any) -> list[float]:
        x, y, vx, vy = state
        slip = given["V"] - vx
        mu = given["mu0"] * (1 - math.exp(-given["d"] * abs(slip))) * np.sign(slip)
        return [vx, vy, *forces(x, y, given, mu, y < 0, math)]

    def jump(_: float, state: Any) -> float:
        return float(
            np.sin(0.8) * (state[0] - np.cos(0.8)) - np.cos(0.8) * (state[1] - np.sin(0.8))
        )

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


# ----------------------------------------------------------------------------------------------
# number types


def boxes(count: int) -> tuple[Intervals, Intervals]:
    """Rectangles of every size around the circle, some on an axis, some around 0."""
    rng = np.random.default_rng(4)
    turn, size = rng.uniform(-np.pi, np.pi, count), 10.0 ** rng.uniform(-17, 0.5, (2, count))
    turn[: count // 4] = rng.integers(-2, 3, count // 4) * np.pi / 2
    middle = np.stack([np.cos(turn), np.sin(turn)])
    middle[np.abs(middle) < 1e-15] = 0.0
    cosine, sine = Intervals.between(middle - size, middle + size)
    return cosine, sine


@pytest.mark.thorough
def test_angles_of_rectangles_hold_all_and_jump_nowhere() -> None:
    """Against 40 digits at corners, edges and inside; what meets the ray of negative cosines is
    unknown, or as a side says.
    """
    cosine, sine = boxes(400)
    plain = atan2(sine, cosine)
    meets = (cosine.low <= 0) & (sine.low <= 0) & (sine.high >= 0)
    assert (np.isnan(plain.low) == meets).all()
    assert 50 < np.count_nonzero(meets) < 350
    above, below, every = (atan2(sine, cosine, side) for side in (1, -1, 0))
    shares = np.array([0.0, 0.3, 0.5, 1.0])
    with mpmath.workdps(40):
        for i in range(len(meets)):
            for x in np.clip(
                cosine.low[i] + shares * (cosine.high[i] - cosine.low[i]),
                cosine.low[i],
                cosine.high[i],
            ).tolist():
                for y in np.clip(
                    sine.low[i] + shares * (sine.high[i] - sine.low[i]), sine.low[i], sine.high[i]
                ).tolist():
                    phi = mpmath.atan2(y, x)
                    bounds = (
                        (plain,)
                        if not meets[i]
                        else (every, above if y >= 0 else below)
                        if y
                        else (every,)
                    )
                    assert all(bound.low[i] <= phi <= bound.high[i] for bound in bounds)
            if not meets[i]:
                corners = [
                    mpmath.atan2(y, x)
                    for x in (cosine.low[i], cosine.high[i])
                    for y in (sine.low[i], sine.high[i])
                ]
                assert plain.width[i] <= max(corners) - min(corners) + 2e-14
