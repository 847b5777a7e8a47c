"""How hard it will hit: the oscillation in hertz, newtons and millimetres."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import spragsym as ss

from ..display import Result
from ..errors import ConvergenceError
from ..models import forces
from ..motion.regimes import Regime
from ..orbits import Cycle
from .states import OfSprings, of_springs
from .study import Study

#: Largest time, in the model's unit, over which a motion is followed.
T_END = 3000.0
#: A motion whose swings are less than this share of those a quarter of the time before is on its way to rest.
_FALLS = 0.99
#: Where a motion that is far out begins: its first two coordinates.
_FAR = (1.5, 0.5)


@dataclass(frozen=True)
class Oscillation(Result):
    """The motion that begins at rest where all coordinates are 0, or far out, and what it comes to.

    ``kind`` is ``"cycle"``, one that attracts it; ``"motion"``, if it goes on and has not repeated itself in the time it was
    followed; ``"rest"``, if it decays to rest; ``"falls"``, if it was not followed to its end, became smaller and smaller,
    and steady sliding may hold it; or ``"lift-off"``, for good. Only the first two have an amplitude of the first coordinate,
    which is half of its range, in millimetres or degrees by ``unit``, and forces, least and largest, of several springs by
    their names; only a cycle has a frequency. ``start`` is ``"rest"`` or ``"far out"``; ``coexists`` says whether it lives
    although a small disturbance of steady sliding dies out, None where that is up to what the model leaves out, or the state
    of the brake is not known.
    """

    kind: str
    frequency_hz: float
    amplitude: float
    unit: str
    spring_force_N: Any
    contact_force_N: Any
    coexists: bool | None
    start: str
    motion: Any = field(repr=False)

    @property
    def amplitude_mm(self) -> float:
        """The amplitude, if it is a length; NaN if it is an angle."""
        return self.amplitude if self.unit == "mm" else math.nan

    @property
    def alive(self) -> bool:
        """Whether it goes on."""
        return self.kind in ("cycle", "motion")

    @property
    def lifts_off(self) -> bool:
        """Whether the contact opens."""
        return self.kind == "lift-off" or (self.contact_force_N is not None and self.contact_force_N[0] == 0)


def oscillation_of(study: Study, settles: bool | None, holds: bool) -> Oscillation:
    """The cycle that the motion comes to, from rest or from far out; or what it does instead.

    ``settles`` says of the state that the brake is in whether a small disturbance dies out, None where that is up to what the
    model leaves out, and ``holds`` whether it does in the model: else no motion that falls comes to rest.
    """
    p = study.dimensionless
    size = len(p.model.coordinates)
    for word, place in (("rest", ()), ("far out", _FAR[:size])):
        try:
            found = ss.cycle(p, near=(*place, *[0.0] * (2 * size - len(place))), patient=False)
        except ConvergenceError:
            continue
        if found.stable:  # no motion comes to one that is not
            return _of_cycle(study, found, settles, word)
    return _of_motion(study, settles, holds)


def first_unit(study: Study) -> tuple[str, float]:
    """In which the first coordinate is told, and its size."""
    return ("mm", 1e3 * study.scales.length) if study.about["coordinates"][0]["unit"] == "m" else ("deg", math.degrees(1.0))


def _forces(study: Study, ends: dict[str, tuple[float, float]]) -> tuple[OfSprings, Any]:
    told = {name: (low * study.scales.force, high * study.scales.force) for name, (low, high) in ends.items()}
    contact = told.pop("contact_force", None)
    return of_springs(study.dimensionless.model, list(told.values())), contact


def _of_cycle(study: Study, found: Cycle, settles: bool | None, start: str) -> Oscillation:
    unit, size = first_unit(study)
    spring, contact = _forces(study, found.forces)
    frequency = 1 / (found.period * study.scales.time)
    return Oscillation("cycle", frequency, found.amplitude * size, unit, spring, contact, settles, start, found)


def _of_motion(study: Study, settles: bool | None, holds: bool) -> Oscillation:
    p = study.dimensionless
    motion = ss.simulate(p, t_end=T_END)
    late = motion.after(0.75 * T_END)
    try:
        regime = motion.outcome(0.75 * T_END).regime
    except ConvergenceError:
        regime = Regime.UNSETTLED
    now, before = (float(np.ptp(motion.after(share * T_END).state[0])) for share in (0.75, 0.5))
    kind = {
        Regime.EQUILIBRIUM: "rest", Regime.APPROACHES_EQUILIBRIUM: "rest", Regime.LIFT_OFF: "lift-off",
        Regime.LIMIT_CYCLE: "motion", Regime.APPROACHES_CYCLE: "motion",
    }.get(regime, "falls" if holds and now < _FALLS * before else "motion")  # fmt: skip
    constants = [float(value) for value in p.model.arguments(p, "motion")]
    nowhere = kind != "motion"
    ends = {
        name: (math.nan, math.nan) if nowhere else _range(force(late.state, constants))
        for name, force in forces.told_of(p.model).items()
    }
    unit, size = first_unit(study)
    amplitude = math.nan if nowhere else 0.5 * now * size
    return Oscillation(kind, math.nan, amplitude, unit, *_forces(study, ends), None if nowhere else settles, "rest", late)


def _range(values: Any) -> tuple[float, float]:
    return float(np.min(values)), float(np.max(values))
