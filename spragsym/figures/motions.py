"""The article's Figures 3 and 7: the laws of friction and contact, and the motion in time."""

from __future__ import annotations

import numpy as np

import spragsym as ss

from ..assumed import D, V
from ..generated import laws
from ..models.parameters import Parameters
from ..motion import simulate
from ..motion.sweeps import Workers, rms_sweep
from .captions import BASE_TEXT, MODEL
from .style import BLACK, DOUBLE, GREY, VERMILION, Sheet, angle_axis, line_at, panels, remark, styled, write_along


@styled
def figure_3() -> Sheet:
    """Friction over the speed of the mass, and contact force over its displacement."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.3)
    speed = np.unique(np.concatenate([np.linspace(-0.5, 1.5, 401), V + np.linspace(-1e-9, 1e-9, 2)]))
    friction = laws.friction(speed, 1.0, V, D)
    left.axhline(0, color=GREY, linewidth=0.5)
    for part in (speed < V, speed > V):
        left.plot(speed[part], friction[part], color=BLACK)
    line_at(left, V)
    write_along(left, r"$x' = V$", V + 0.04, -0.12)
    left.set(xlabel=r"$x'$", ylabel=r"$\mu/\mu_0$", xlim=(-0.5, 1.5), ylim=(-1.15, 1.15))
    left.set_xticks(np.arange(-0.5, 1.6, 0.5))
    right.set_xticks(np.arange(-0.1, 0.11, 0.05))
    y = np.array([-0.1, 0.0, 0.1])
    # Without spring and preload the acceleration across the belt, (9), is the contact force, (11).
    _, contact = MODEL.algebra.rhs(0.0, y, 0.0, 0.0, 1.0, 0.0, mu0=0.0, kappa=0.0, alpha=0.0, sigma=0.0, beta=0.0, V=V, d=D)
    contact = contact + 0.0  # a table shows 0 as 0, not as -0
    right.plot(y, contact, color=BLACK)
    write_along(right, "contact", -0.048, 0.06, ha="left")
    write_along(right, "lift-off", 0.05, 0.009, ha="center")
    right.set(xlabel=r"$y$", ylabel=r"$n$", xlim=(-0.1, 0.1), ylim=(-0.008, 0.105))
    return figure.describe(
        f"""Figure 3. (a) Regularized friction coefficient (10) over the speed of the mass, for a belt speed
        V = {V} and a steepness d = {D:g}, which are our assumption: the article states neither. (b) Contact
        force (11). All quantities are dimensionless.""",
        a={"vx": speed, "mu_over_mu0": friction}, b={"y": y, "n": contact},
    )  # fmt: skip


@styled
def figure_7(*, step_deg: float = 0.5, workers: Workers = 1) -> Sheet:
    """The motion in time at 49°, and the root mean square of x over θ₀."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.5)
    p = Parameters.article()
    trajectory = simulate(p.replace(theta0=np.radians(49.0)), V=V, d=D)
    t = np.linspace(0.0, 2000.0, 8001)
    x = trajectory(t)[0]
    left.plot(t, x, color=BLACK, linewidth=0.6)
    left.set(xlabel=r"$\tau$", ylabel=r"$x$", xlim=(0, 2000))
    remark(left, r"$\theta_0 = 49^\circ$")
    angles = np.arange(step_deg, 180.0 - step_deg / 2, step_deg)
    sweep = rms_sweep(p.replace(theta0=np.radians(angles)), V, D, workers=workers)
    right.plot(angles, sweep.rms, color=BLACK, marker=".", markersize=2.2, linewidth=0.5)
    fold = float(np.degrees(ss.folds(p).theta0[0]))
    line_at(right, fold, VERMILION, 0.8)
    write_along(right, f"fold, {fold:.2f}°", fold + 3, 0.12, color=VERMILION)
    angle_axis(right)
    right.set(ylabel=r"RMS of $x$", ylim=(0, None))
    return figure.describe(
        f"""Figure 7. Motion from rest at x = y = 0, μ₀ = 0.5, {BASE_TEXT}. (a) x over dimensionless time at
        θ₀ = 49°. (b) Root mean square of x, about zero, over 1500 < τ < 2000. Belt speed V = {V},
        steepness d = {D:g}, the rest at the start and the window in time are our assumption: the article
        states none of them. The dotted line is the fold. Beyond it a large and a small motion compete; near
        54° rounding decides which of them is reached.""",
        a={"tau": t, "x": x}, b={"theta0_deg": angles, "rms_x": sweep.rms, "regime": sweep.regime},
    )  # fmt: skip
