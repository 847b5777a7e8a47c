"""How hard the jump itself hits: from the fold, at the friction of the jump, to where the motion settles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..catastrophe import quasi_static_path, sliding_friction
from ..display import Result
from ..dynamics import simulate
from ..dynamics.regimes import Regime
from ..errors import ConvergenceError
from ..parameters import FloatArray
from ..statics import kernel
from .facts import jump_speed
from .study import Study

#: Share of the way from the fold to the state that is left, at which the motion is let go.
_AWAY = 1e-2
#: Times, in units of sqrt(m/k_c), over which it is followed until it is half way, and instants at which forces are looked at.
_T_END, _INSTANTS = (1500.0, 24_000.0), 60_000
_SETTLES = {
    Regime.EQUILIBRIUM: "rest", Regime.APPROACHES_EQUILIBRIUM: "rest", Regime.LIMIT_CYCLE: "cycle",
    Regime.APPROACHES_CYCLE: "cycle", Regime.LIFT_OFF: "lift-off",
}  # fmt: skip


@dataclass(frozen=True)
class JumpPeak(Result):
    """Least and largest values from the fold on: displacements in millimetres, forces in newtons.

    ``from_mm`` and ``to_mm`` are x on the fold and of the state that is left there. ``settles`` says what the motion comes to:
    ``"rest"``, ``"cycle"``, ``"lift-off"``, or ``"unsettled"`` after ``seconds``; ``lifts_off`` whether the contact opens.
    """

    friction: float
    from_mm: float
    to_mm: float
    x_mm: tuple[float, float]
    y_mm: tuple[float, float]
    spring_force_N: tuple[float, float]
    contact_force_N: tuple[float, float]
    lifts_off: bool
    settles: str
    seconds: float


def jump_peak(study: Study, jump: float) -> JumpPeak | None:
    """The jump as a motion; None where the belt's friction reaches none, the law is not known, or the motion creeps.

    Notes
    -----
    Source: (8)–(11) at the belt's speed, with the μ₀ at which the friction that works is that of the jump; where no μ₀ within the
    tolerances is enough, at the largest and the speed at which it is. The motion begins at rest, balanced across the belt, where
    the direction of the spring is a hundredth of the way from the fold to the state that is left; forces are looked at over equal
    steps of time.
    """
    if not study.moves or not jump < study.quantities["mu0"].high:
        return None
    p, scales, belt = study.dimensionless, study.scales, study.parameters.belt()
    path = quasi_static_path(p, "mu0", [0.0, jump * (1 + 1e-6) + 1e-9])
    if not path.jumps:
        return None
    turn = path.jumps[0]
    start, end = (turn.before["x"], turn.before["y"]), (turn.after["x"], turn.after["y"])
    at = p.replace(mu0=jump / study.fraction if study.fraction else jump)
    if jump > study.friction[2]:
        belt["V"] = jump_speed(study, jump) * scales.time / scales.length
        at = p.replace(mu0=jump / float(sliding_friction(1.0, **belt)))
    theta = (1 - _AWAY) * turn.before["theta"] + _AWAY * turn.after["theta"]
    given = p.scalars("theta0", "kappa", "sigma", "beta")
    _, x, y = kernel.state(math.cos(theta), math.sin(theta), math.cos(given[0]), math.sin(given[0]), *given[1:], 1)
    for t_end in _T_END:
        try:
            motion = simulate(at, **belt, x0=x, y0=y, t_end=t_end)
            comes_to = motion.outcome(0.5 * t_end).regime
        except ConvergenceError:
            return None
        if np.abs(motion.x - start[0]).max() > 0.5 * abs(end[0] - start[0]):
            break
    else:
        return None
    times = np.union1d(motion.t, np.linspace(0.0, motion.t[-1], _INSTANTS))
    place = motion(times)
    (theta0, sigma) = p.scalars("theta0", "sigma")
    spring = sigma * (np.hypot(math.cos(theta0) - place[0], math.sin(theta0) - place[1]) - 1.0)
    contact = np.maximum(-place[1], 0.0)
    size = 1e3 * scales.length
    return JumpPeak(
        jump, start[0] * size, end[0] * size, _range(place[0] * size), _range(place[1] * size), _range(spring * scales.force),
        _range(contact * scales.force), bool(contact.min() == 0), _SETTLES.get(comes_to, "unsettled"),
        float(motion.t[-1] * scales.time),
    )  # fmt: skip


def _range(values: FloatArray) -> tuple[float, float]:
    return float(values.min()), float(values.max())
