"""Computations behind the statements on the oscillation: where it lives, and where rest changes its fate."""

from __future__ import annotations

import numpy as np

from ..assumed import D, V
from ..catastrophe import folds, sliding_friction
from ..cycles import cycle, fate_boundary
from ..parameters import Parameters
from ..statics.solver import Stability, equilibria
from .rows import Found

#: Inclinations far below the fold, degrees.
FAR_BELOW = (10.0, 20.0, 30.0, 40.0)

#: A state on the oscillation at 42°.
ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)


def lives_below() -> Found:
    """Stable cycles beside stable sliding, far below the fold."""
    found = cycle(Parameters.article(theta0=np.radians(42.0)), V=V, d=D, near=ON_CYCLE, patient=False)
    periods, multipliers, holds = [], [], True
    for degrees in sorted(FAR_BELOW, reverse=True):
        p = Parameters.article(theta0=np.radians(degrees))
        found = cycle(p, V=V, d=D, near=found)
        rest = equilibria(p.replace(mu0=sliding_friction(p.mu0, V, D)))
        smallest = int(np.nanargmin(np.abs(rest.x)))
        holds &= found.stable and rest.stability[smallest] == Stability.STABLE
        periods.append(found.period)
        multipliers.append(float(np.abs(found.multipliers[1])))
    return Found(bool(holds), {
        "theta0_deg": list(FAR_BELOW), "periods": periods[::-1], "largest multipliers": multipliers[::-1],
    })  # fmt: skip


def fate_of_rest() -> Found:
    """Where the motion from rest changes its fate, and at which saddle it hovers there."""
    found = fate_boundary(Parameters.article(), vary="theta0", bracket=(np.radians(41.0), np.radians(42.0)), V=V, d=D)
    at, fold = float(np.degrees(found.value)), float(np.degrees(folds(Parameters.article()).theta0[0]))
    holds = found.saddle == "equilibrium" and 1 < fold - at < 5
    return Found(bool(holds), {
        "theta0_deg": at, "before the fold by (deg)": fold - at, "x of the saddle": float(found.state[0]),
        "y of the saddle": float(found.state[1]), "its growth rate": found.growth,
    })  # fmt: skip
