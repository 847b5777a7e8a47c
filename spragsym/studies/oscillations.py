"""How hard it will hit: the oscillation in hertz, newtons and millimetres."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..cycles import Cycle, cycle
from ..display import Result
from ..dynamics import simulate
from ..dynamics.regimes import Regime
from ..errors import ConvergenceError
from .states import states
from .study import Study

#: Largest time, in units of sqrt(m/k_c), over which a motion is followed.
T_END = 3000.0
#: A motion whose swings are less than this share of those a quarter of the time before is on its way to rest.
_FALLS = 0.99
_NOWHERE = (math.nan, math.nan)


@dataclass(frozen=True)
class Oscillation(Result):
    """The motion that begins at rest at x = y = 0 or far out, and what it comes to.

    ``kind`` is ``"cycle"``, one that attracts it; ``"motion"``, if it goes on and has not repeated itself in the time it was
    followed; ``"rest"``, if it decays to rest; ``"falls"``, if it was not followed to its end and became smaller and smaller; or
    ``"lift-off"``, for good. Only the first two have an amplitude, half of the range along the belt, and forces, least and
    largest; only a cycle has a frequency. ``start`` is ``"rest"`` or ``"far out"``; ``coexists`` says whether it lives although a
    small disturbance of steady sliding dies out, None where that is up to what the model leaves out.
    """

    kind: str
    frequency_hz: float
    amplitude_mm: float
    spring_force_N: tuple[float, float]
    contact_force_N: tuple[float, float]
    coexists: bool | None
    start: str
    remark: str
    motion: Any = field(repr=False)

    @property
    def alive(self) -> bool:
        """Whether it goes on."""
        return self.kind in ("cycle", "motion")

    @property
    def lifts_off(self) -> bool:
        """Whether the contact opens."""
        return self.kind == "lift-off" or self.contact_force_N[0] <= 0


def oscillation_of(study: Study) -> Oscillation:
    """The cycle that the motion comes to, from rest or from far out; or what it does instead."""
    p, belt, scales = study.dimensionless, study.parameters.belt(), study.scales
    settles = next(state.settles for state in states(study) if state.current)
    remark = ""
    for word, start in (("rest", (0.0, 0.0, 0.0, 0.0)), ("far out", (1.5, 0.5, 0.0, 0.0))):
        try:
            found = cycle(p, **belt, near=start, patient=False)
        except ConvergenceError as error:
            remark = remark or str(error)
            continue
        if found.stable:  # no motion comes to one that is not
            return _of_cycle(found, scales, settles, word)
    return _of_motion(study, settles, remark)


def _of_cycle(found: Cycle, scales: Any, settles: bool | None, start: str) -> Oscillation:
    force = scales.force
    spring, contact = ((low * force, high * force) for low, high in (found.spring_force, found.contact_force))
    return Oscillation(
        "cycle",
        1 / (found.period * scales.time),
        found.amplitude * 1e3 * scales.length,
        spring,
        contact,
        settles,
        start,
        "",
        found,
    )


def _of_motion(study: Study, settles: bool | None, remark: str) -> Oscillation:
    p, belt, scales = study.dimensionless, study.parameters.belt(), study.scales
    motion = simulate(p, **belt, t_end=T_END)
    late = motion.after(0.75 * T_END)
    try:
        regime = motion.outcome(0.75 * T_END).regime
    except ConvergenceError:
        regime = Regime.UNSETTLED
    now, before = (float(np.ptp(motion.after(share * T_END).x)) for share in (0.75, 0.5))
    kind = {
        Regime.EQUILIBRIUM: "rest", Regime.APPROACHES_EQUILIBRIUM: "rest", Regime.LIFT_OFF: "lift-off",
        Regime.LIMIT_CYCLE: "motion", Regime.APPROACHES_CYCLE: "motion",
    }.get(regime, "falls" if now < _FALLS * before else "motion")  # fmt: skip
    if kind != "motion":
        return Oscillation(kind, math.nan, math.nan, _NOWHERE, _NOWHERE, None, "rest", remark, late)
    spring, contact = late.spring_force() * scales.force, late.contact_force() * scales.force
    return Oscillation(
        kind, math.nan, 0.5 * now * 1e3 * scales.length, (float(spring.min()), float(spring.max())),
        (float(contact.min()), float(contact.max())), settles, "rest", remark, late,
    )  # fmt: skip
