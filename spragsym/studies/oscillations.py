"""How hard it will hit: the oscillation in hertz, newtons and millimetres."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..cycles import Cycle, cycle
from ..display import Result
from ..dynamics import simulate
from ..errors import ConvergenceError
from .states import NEUTRAL, State, states
from .study import Study

#: Largest time, in units of sqrt(m/k_c), over which a motion is followed.
T_END = 3000.0


@dataclass(frozen=True)
class Oscillation(Result):
    """The motion that begins at rest at x = y = 0 or far out, and what it comes to.

    ``kind`` is ``"cycle"``, ``"motion"`` (it has not repeated itself in the time it was followed) or ``"none"`` (it comes to
    rest). ``frequency_hz`` is NaN but for a cycle; ``amplitude_mm`` is half of the range along the belt; forces are least and
    largest values; ``start`` is ``"rest"`` or ``"far out"``; ``coexists`` says that it lives although steady sliding is stable,
    or so little damped or driven that what the model leaves out decides.
    """

    kind: str
    stable: bool
    frequency_hz: float
    amplitude_mm: float
    spring_force_N: tuple[float, float]
    contact_force_N: tuple[float, float]
    lifts_off: bool
    coexists: bool
    start: str
    remark: str
    motion: Any = field(repr=False)


def oscillation_of(study: Study) -> Oscillation:
    """The cycle that the motion comes to, from rest or from far out; or what it does instead."""
    p, belt, scales = study.dimensionless, study.parameters.belt(), study.scales
    steady = any(state.current and settles(state) for state in states(study))
    remark = ""
    for word, start in (("rest", (0.0, 0.0, 0.0, 0.0)), ("far out", (1.5, 0.5, 0.0, 0.0))):
        try:
            found = cycle(p, **belt, near=start, patient=False)
        except ConvergenceError as error:
            remark = remark or str(error)
            continue
        return _of_cycle(found, scales, steady, word)
    return _of_motion(study, steady, remark)


def settles(state: State) -> bool:
    """Whether it is stable, the friction law's own damping left out where that is next to nothing."""
    least = min(state.damping_ratio, default=0.0)
    return state.stable or (state.statics == "stable" and abs(least) < NEUTRAL)


def _of_cycle(found: Cycle, scales: Any, steady: bool, start: str) -> Oscillation:
    force = scales.force
    spring, contact = ((low * force, high * force) for low, high in (found.spring_force, found.contact_force))
    return Oscillation(
        "cycle", found.stable, 1 / (found.period * scales.time), found.amplitude * 1e3 * scales.length, spring, contact,
        contact[0] <= 0, steady and found.stable, start, "", found,
    )  # fmt: skip


def _of_motion(study: Study, steady: bool, remark: str) -> Oscillation:
    p, belt, scales = study.dimensionless, study.parameters.belt(), study.scales
    motion = simulate(p, **belt, t_end=T_END)
    late = motion.after(0.75 * T_END)
    spring, contact = late.spring_force() * scales.force, late.contact_force() * scales.force
    size = 0.5 * float(np.ptp(late.x)) * 1e3 * scales.length
    quiet = size < 1e-6 * 1e3 * scales.length
    return Oscillation(
        "none" if quiet else "motion", False, float("nan"), size, (float(spring.min()), float(spring.max())),
        (float(contact.min()), float(contact.max())), bool(contact.min() <= 0), steady and not quiet, "rest", remark, late,
    )  # fmt: skip
