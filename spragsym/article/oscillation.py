"""Computations behind the statements on the oscillation: where it lives, and where rest changes its fate."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..assumed import D, V
from ..bifurcation.folds import folds
from ..models.load import USUAL, load
from ..models.parameters import Parameters
from ..orbits import cycle, fate_boundary
from ..results import Stability
from ..statics.equilibria import equilibria

_MODEL = load(USUAL)
#: Inclinations far below the fold, degrees.
FAR_BELOW = (10.0, 20.0, 30.0, 40.0)

#: V and d of other belts, of which the article states neither: between rest and oscillation the motions of these are regular.
OTHER_BELTS = ((0.3, 10.0), (0.5, 5.0), (0.4, 12.5))

#: Inclinations, degrees, at which the motion from rest comes to rest and at which it goes on: one pair for each of these belts.
FATES_CHANGE = ((41.2, 43.0), (41.2, 43.7), (41.2, 42.0))

#: The inclination at which the cycle is looked for with these, degrees.
WITH_OTHERS = 30.0

#: A state on the oscillation at 42°.
ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)


def lives_below() -> tuple[bool, dict[str, Any]]:
    """Stable cycles beside stable sliding, far below the fold."""
    found = cycle(Parameters.article(theta0=np.radians(42.0)), V=V, d=D, near=ON_CYCLE, patient=False)
    periods, multipliers, holds, known = [], [], True, {}
    for degrees in sorted(FAR_BELOW, reverse=True):
        found = known[degrees] = cycle(Parameters.article(theta0=np.radians(degrees)), V=V, d=D, near=found)
        holds &= found.stable and _slides_stably(degrees, V, D)
        periods.append(found.period)
        multipliers.append(float(np.abs(found.multipliers[1])))
    others = []
    for speed, creep in OTHER_BELTS:
        other = cycle(Parameters.article(theta0=np.radians(WITH_OTHERS)), V=speed, d=creep, near=known[WITH_OTHERS])
        holds &= other.stable and _slides_stably(WITH_OTHERS, speed, creep)
        others.append(other.period)
    return holds, {
        "theta0_deg": list(FAR_BELOW), "periods": periods[::-1], "largest multipliers": multipliers[::-1],
        "V of other belts": [belt[0] for belt in OTHER_BELTS], "d of other belts": [belt[1] for belt in OTHER_BELTS],
        "periods with these at 30 degrees": others,
    }  # fmt: skip


def _slides_stably(degrees: float, speed: float, creep: float) -> bool:
    """Whether the state of smallest deformation is stable at the friction of this belt."""
    p = Parameters.article(theta0=np.radians(degrees))
    rest = equilibria(p.replace(mu0=_MODEL.friction(p.replace(V=speed, d=creep))))
    return bool(rest.stability[int(np.nanargmin(np.abs(rest.x)))] == Stability.STABLE)


def fate_of_rest() -> tuple[bool, dict[str, Any]]:
    """Where the motion from rest changes its fate, and at which saddle it hovers there."""
    found = fate_boundary(Parameters.article(), vary="theta0", bracket=(np.radians(41.0), np.radians(42.0)), V=V, d=D)
    at, fold = float(np.degrees(found.value)), float(np.degrees(folds(Parameters.article()).theta0[0]))
    holds = found.saddle == "equilibrium" and 1 < fold - at < 5
    others, apart = [], []
    for (speed, creep), (low, high) in zip(OTHER_BELTS, np.radians(FATES_CHANGE), strict=True):
        other = fate_boundary(Parameters.article(), vary="theta0", bracket=(low, high), V=speed, d=creep)
        sliding = folds(Parameters.article(mu0=float(_MODEL.friction(Parameters.article(V=speed, d=creep))))).theta0[0]
        others.append(float(np.degrees(other.value)))
        apart.append(float(np.degrees(sliding)) - others[-1])
        holds &= other.saddle == "equilibrium" and 3 < apart[-1] < 4
    return holds, {
        "theta0_deg": at, "before the fold by (deg)": fold - at, "x of the saddle": float(found.state[0]),
        "y of the saddle": float(found.state[1]), "its growth rate": found.growth,
        "V of other belts": [belt[0] for belt in OTHER_BELTS], "d of other belts": [belt[1] for belt in OTHER_BELTS],
        "theta0_deg with these": others, "before the fold at their sliding friction by (deg)": apart,
    }  # fmt: skip
