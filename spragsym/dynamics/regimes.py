"""Names of the long-run behaviour of a motion."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from ..display import Result

#: A motion has settled when what is left to its limit is this share of its reach; for rest, of L_0.
SETTLED = 1e-4


class Regime(IntEnum):
    """What a motion settles to, or approaches."""

    FAILED = 0
    """There is no result; the reason says why."""
    EQUILIBRIUM = 1
    """Rests at a steady-sliding equilibrium that attracts it, or that does not repel it where nothing damps."""
    LIMIT_CYCLE = 2
    """Repeats itself on a cycle that attracts it."""
    LIFT_OFF = 3
    """Has no contact with the belt, and too little energy ever to come back to it."""
    UNSETTLED = 4
    """None of these, and none that it is seen to approach: a long transient, quasi-periodic or irregular."""
    APPROACHES_EQUILIBRIUM = 5
    """Decays to an equilibrium at the rate of the linearization there, and is still on its way."""
    APPROACHES_CYCLE = 6
    """Winds onto a cycle at the rate of the cycle's multipliers, and is still on its way."""


#: The attractor behind a regime.
ATTRACTOR = {
    Regime.APPROACHES_EQUILIBRIUM: Regime.EQUILIBRIUM,
    Regime.APPROACHES_CYCLE: Regime.LIMIT_CYCLE,
}


@dataclass(frozen=True)
class Outcome(Result):
    """What a motion comes to.

    Attributes
    ----------
    regime : Regime
    equilibrium : int
        For EQUILIBRIUM and APPROACHES_EQUILIBRIUM its index among ``equilibria(p)`` at the friction μ(V); −1 otherwise.
    rest_x, rest_y : float
        Where that equilibrium is; NaN otherwise.
    rate : float
        Of the approach in the long run, exp(−rate τ), from the limit's own eigenvalues or multipliers. NaN where there is none.
    distance : float
        What is left to the limit when the motion ends: relative to the motion's reach for a cycle, in L_0 for rest.
    period, cycle_mean, cycle_rms : float
        Of the cycle itself: period, mean of x, and root mean square of x about zero over one whole period. NaN for no cycle.
    cycle_x, cycle_y, cycle_vy : float
        The cycle's state where its x is largest (there x' = 0): one point, which with the equations is the whole orbit.
    """

    regime: Regime = Regime.UNSETTLED
    equilibrium: int = -1
    rest_x: float = np.nan
    rest_y: float = np.nan
    rate: float = np.nan
    distance: float = np.nan
    period: float = np.nan
    cycle_mean: float = np.nan
    cycle_rms: float = np.nan
    cycle_x: float = np.nan
    cycle_y: float = np.nan
    cycle_vy: float = np.nan

    @property
    def cycle_spread(self) -> float:
        """Root mean square of x about its mean over one period."""
        return float(np.sqrt(max(self.cycle_rms**2 - self.cycle_mean**2, 0.0))) if self.period > 0 else float("nan")
