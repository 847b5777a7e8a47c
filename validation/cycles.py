"""Cycles and regimes against second drivers: SciPy's own event location on equations by hand, and
the same motion much later.

The first nine cases are cycles of all kinds, whose state, period and multipliers are compared;
every further one is twenty random motions whose limit, told at τ = 2000, must be that at τ = 40
000. Last found, at seed 1 of 6000 motions: differences over too long a step called a cycle
unstable.
"""

from typing import Any

import numpy as np

import spragsym as ss
from spragsym.motion.regimes import Regime, same_limit
from spragsym.motion.sweeps import rms_sweep
from tests.oracles.second_driver import differences

#: Kind, inclination in degrees, and a state near it.
KNOWN = (
    ("weakly attracting", 42.0, (2.538161566773, 3.361504868710, 0.0, 0.361278176249)),
    ("never sticks", 5.0, (2.81, 2.9, 0.0, 0.45)),
    ("doubled", 49.0, (2.52576715, 3.53980918, 0.0, -0.33132352)),
    ("unstable, at which it doubles", 54.0, (2.326445826, 3.364354753, 0.0, 0.3058563602)),
    ("long", 49.0, (3.178893595172, 2.120311377456, 0.0, 0.035253616447)),
    ("strongly unstable", 35.5, (3.31193202, 1.56224915, 0.0, 0.02077165)),
    ("short", 90.0, (2.32939917, 1.34003954, 0.0, 0.25152749)),
    ("of period 130", 54.0, (3.09475195, 1.43390171, 0.0, 0.11289679)),
    ("of period 75", 80.0, (3.002656, 0.40497029, 0.0, 0.13983899)),
)
CASES = len(KNOWN) + 5
#: Motions of a case, when they are judged early and late, and over which windows before.
MOTIONS, TIMES = 20, ((2000.0, 500.0), (4e4, 4000.0))


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """A known cycle, or the regimes of random motions."""
    if number >= len(KNOWN):
        return regimes(rng)
    kind, degrees, near = KNOWN[number]
    cycle = ss.cycle(
        ss.Parameters.article(theta0=np.radians(degrees)), V=0.5, d=10.0, near=near, patient=False
    )
    off = max(differences(cycle))
    return {"kind": "cycle", "wrong": [f"{kind}: {off:.2g} off"] * (off > 1e-9), "difference": off}


def regimes(rng: np.random.Generator) -> dict[str, Any]:
    """Random motions about the article's parameters, belts over a decade, β = 0 in half of them."""
    n = MOTIONS
    p = ss.Parameters(
        theta0=rng.uniform(0.2, 2.9, n),
        mu0=rng.uniform(0.0, 1.0, n),
        kappa=0.007 * 10 ** rng.uniform(-0.7, 0.7, n),
        alpha=0.007 * 10 ** rng.uniform(-0.7, 0.7, n),
        sigma=0.1 * 10 ** rng.uniform(-0.5, 0.5, n),
        beta=rng.choice([0.0, 0.05], n) * rng.uniform(0, 1, n),
    )
    rest = {
        "V": rng.uniform(0.05, 1.0, n),
        "d": 10 ** rng.uniform(0.3, 1.3, n),
        "x0": rng.normal(0, 0.2, n),
    }
    rest |= {"vx0": rng.normal(0, 0.1, n), "vy0": rng.normal(0, 0.02, n)}
    early, late = (rms_sweep(p, **rest, t_end=end, transient=end - window) for end, window in TIMES)
    told = np.flatnonzero(~np.isin(early.regime, (Regime.UNSETTLED, Regime.FAILED))).tolist()
    pairs = [(early.outcome(i), late.outcome(i)) for i in told]
    field = p.model.field
    constants = field.constants(ss.Parameters.article(theta0=1.0).scalars(*p.model.parameters))
    wrong = [
        f"{one}, later {two}"
        for one, two in pairs
        if one.equilibrium != two.equilibrium or not same_limit(one, two, field, constants)
    ]
    return {"kind": "regimes", "wrong": wrong, "limits told": len(told)}
