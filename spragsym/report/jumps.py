"""How hard the jump itself hits: from the fold, at the friction of the jump, to where the motion settles."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

import spragsym as ss

from ..display import Result
from ..errors import ConvergenceError
from ..models import forces
from ..models.parameters import FloatArray
from ..motion.regimes import Regime
from ..names import hint
from ..statics.mechanics.balance import Balance
from . import friction, rises
from .states import of_springs, place_in_units
from .study import Study

#: Share of the way from the fold to the state that is left, at which the motion is let go.
AWAY = 1e-2
#: Times, in the model's unit, over which it is followed until it is half way, and instants at which forces are looked at.
_T_END, _INSTANTS = (1500.0, 24_000.0), 60_000
#: Steps of Newton's method to balance the other coordinates.
_STEPS = 20
_SETTLES = {
    Regime.EQUILIBRIUM: "rest", Regime.APPROACHES_EQUILIBRIUM: "rest", Regime.LIMIT_CYCLE: "cycle",
    Regime.APPROACHES_CYCLE: "cycle", Regime.LIFT_OFF: "lift-off",
}  # fmt: skip


@dataclass(frozen=True)
class JumpPeak(Result):
    """Least and largest values from the fold on: forces in newtons, coordinates in millimetres or degrees.

    ``at`` is where it jumps, as the report tells it. ``before`` and ``after`` are the coordinates on the fold and of the state
    that is left there, by name and unit, and ``ranges`` how far each goes, attributes too. ``spring_force_N`` is that of the
    inclined spring, of several by their names; ``contact_force_N`` is None without a contact. ``settles`` says what the motion
    comes to: ``"rest"``, ``"cycle"``, ``"lift-off"``, or ``"unsettled"`` in the ``followed_s`` seconds over which it was looked
    at; ``lifts_off`` whether the contact opens.
    """

    at: float
    before: Mapping[str, float]
    after: Mapping[str, float]
    ranges: Mapping[str, tuple[float, float]]
    spring_force_N: Any
    contact_force_N: tuple[float, float] | None
    lifts_off: bool
    settles: str
    followed_s: float

    def __getattr__(self, name: str) -> tuple[float, float]:
        ranges = self.__dict__.get("ranges", {})
        if name not in ranges:
            raise AttributeError(f"a jump has no {name!r}{hint(name, ranges)}")
        found: tuple[float, float] = ranges[name]
        return found


def jump_peak(study: Study, value: float, jump: float, speed: float) -> JumpPeak | None:
    """The jump as a motion; None where the belt's friction reaches none, the law is not known, or the motion creeps.

    ``value`` is that of the parameter that rises, ``jump`` what it is told as, and ``speed`` the least one of the belt in m/s
    that brings a friction.

    Notes
    -----
    Source: the equations of motion, (8)–(11), at the belt's speed, where what rises is at the jump: friction by the μ₀ at which
    that works; where no μ₀ within the tolerances is enough, at the largest and the speed at which it is. The motion begins at
    rest, where the coordinate that moves most is a hundredth of the way from the fold to the state that is left, and the others
    are balanced; forces are looked at over equal steps of time.
    """
    rise, scales = rises.of(study), study.scales
    at = _moving(study, value, jump, speed)
    if at is None:
        return None
    p = study.dimensionless if rise.is_friction else study.at_work
    model = p.model
    path = ss.quasi_static_path(p, rise.name, [rises.begin(study), value + 1e-6 * abs(value) + 1e-9])
    if not path.jumps:
        return None
    turn = path.jumps[0]
    begin, end = (np.array([where[name] for name in model.coordinates]) for where in (turn.before, turn.after))
    held = int(np.abs(end - begin).argmax())
    start = _balanced(model, p.replace(**{rise.name: value}), begin + AWAY * (end - begin), held)
    for t_end in _T_END:
        try:
            motion = ss.simulate(at, start=(*start, *np.zeros(start.size)), t_end=t_end)
            comes_to = motion.outcome(0.5 * t_end).regime
        except ConvergenceError:
            return None
        if np.abs(motion.state[held] - begin[held]).max() > 0.5 * abs(end[held] - begin[held]):
            break
    else:
        return None
    times = np.union1d(motion.t, np.linspace(0.0, motion.t[-1], _INSTANTS))
    states = np.asarray(motion(times))
    constants = [float(value) for value in model.arguments(at, "motion")]
    told = {name: _range(force(states, constants)) for name, force in forces.told_of(model).items()}
    contact = told.pop("contact_force", None)
    lowest, highest = (
        place_in_units(study, dict(zip(model.coordinates, find(states[: start.size], axis=1), strict=True)))
        for find in (np.min, np.max)
    )
    before, after = (
        place_in_units(study, {name: where[name] for name in model.coordinates}) for where in (turn.before, turn.after)
    )
    return JumpPeak(
        jump, before, after, {name: (float(lowest[name]), float(highest[name])) for name in lowest},
        of_springs(model, [_scaled(ends, scales.force) for ends in told.values()]),
        None if contact is None else _scaled(contact, scales.force), contact is not None and contact[0] == 0,
        _SETTLES.get(comes_to, "unsettled"), float(motion.t[-1] * scales.time),
    )  # fmt: skip


def _moving(study: Study, value: float, jump: float, speed: float) -> Any:
    """The parameters of the motion where it jumps; None where the law is not known or brings no such friction."""
    p, rise = study.dimensionless, rises.of(study)
    model = p.model
    if not study.moves or (model.about["friction"] and friction.law_of(study) != "friction_at_speed"):
        return None
    if not rise.is_friction:
        return p.replace(**{rise.name: value})
    if jump > study.friction[2] and math.isnan(speed):
        return None
    at = p.replace(mu0=1.0)
    if jump > study.friction[2]:
        at = at.replace(**{model.about["friction"]["belt"]: speed * study.scales.time / study.scales.length})
    return at.replace(mu0=jump / float(model.friction(at)))  # to which the law is proportional


def _balanced(model: Any, p: Any, place: FloatArray, held: int) -> FloatArray:
    """A place with one coordinate as it is, and the forces on all others balanced: by Newton's method."""
    balance = Balance(model, True)
    values = balance.arguments_of(dict(zip(balance.parameters, p.scalars(*balance.parameters), strict=True)), np)
    free = np.delete(np.arange(place.size), held)
    q = place.copy()
    for _ in range(_STEPS if free.size else 0):
        directions = balance.plain_directions(list(q), values, np)
        rows, residual = (balance.by_coordinate(name, list(q), directions, values, np) for name in ("forces_jacobian", "forces"))
        stiffness = np.array(rows, dtype=float)[np.ix_(free, free)]
        q[free] -= np.linalg.solve(stiffness, np.array(residual, dtype=float)[free])
    return q


def _range(values: FloatArray) -> tuple[float, float]:
    return float(values.min()), float(values.max())


def _scaled(ends: tuple[float, float], size: float) -> tuple[float, float]:
    return ends[0] * size, ends[1] * size
