"""Cycles against a second, independent driver: SciPy's solve_ivp with its own event location, on the generated algebra alone.

``python -m validation.cycles`` prints, for cycles of different kinds, how far state, period and multipliers differ.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.dynamics import shooting
from tests.oracles import article_motion

#: Kind, inclination in degrees, and a state near it.
CASES = (
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


def once_round(cycle: ss.Cycle) -> tuple[Any, Any]:
    """End and derivative of one round, piece by piece between SciPy's events."""
    theta0, *rest = cycle.values
    constants = (math.cos(theta0), math.sin(theta0), *rest)
    V = constants[-2]
    whole, clock = np.concatenate([cycle.state, np.eye(4).ravel()]), 0.0
    contact, side = int(cycle.state[1] <= 0), 1
    while clock < cycle.period:
        mode = (contact, side)

        def rates(_: float, z: Any, mode: tuple[int, int] = mode) -> Any:
            state = z[:4].tolist()
            lower = np.array(article_motion.slopes(state, constants, *mode)) @ z[4:].reshape(4, 4)
            upper = z[12:20].reshape(2, 4)
            return np.concatenate(
                [state[2:], article_motion.accelerations(state, constants, *mode), upper.ravel(), lower.ravel()]
            )

        def leaves(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float((1 - 2 * mode[0]) * z[1] + 1e-12)

        def turns(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float(mode[1] * (V - z[2]) + 1e-12)

        for event in (leaves, turns):
            event.terminal, event.direction = True, -1  # type: ignore[attr-defined]  # as SciPy wants it
        part = solve_ivp(
            rates, (clock, cycle.period), whole, method="DOP853", rtol=3e-14, atol=1e-15, events=(leaves, turns), max_step=0.25
        )
        clock, whole = float(part.t[-1]), part.y[:, -1]
        if len(part.t_events[0]):
            contact = 1 - contact
        elif len(part.t_events[1]):
            side = -side
    return whole[:4], whole[4:].reshape(4, 4)


def differences(cycle: ss.Cycle) -> tuple[float, float, float]:
    """Of state, period, and multipliers relative to the larger of 1 and their size: what Newton's step of this driver is."""
    end, matrix = once_round(cycle)
    flow = shooting.rate(cycle.field, cycle.state, cycle.loop.constants)
    step = np.linalg.solve(np.column_stack([(matrix - np.eye(4))[:, [0, 1, 3]], flow]), cycle.state - end)
    ours, theirs = (np.sort_complex(values) for values in (cycle.multipliers, np.linalg.eigvals(matrix)))
    return float(np.abs(step[:3]).max()), abs(float(step[3])), float((np.abs(ours - theirs) / np.maximum(1, np.abs(ours))).max())


def main() -> None:
    """Print the table, and the largest difference."""
    largest_off = 0.0
    print(f"{'cycle':32}{'theta0':>7}{'period':>18}{'largest':>12}  state    period   multipliers")
    for name, degrees, state in CASES:
        cycle = ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), V=0.5, d=10.0, near=state, patient=False)
        largest = cycle.multipliers[1]
        off = differences(cycle)
        print(f"{name:32}{degrees:7.1f}{cycle.period:18.12f}{abs(largest):12.6f}  " + "  ".join(f"{value:.1e}" for value in off))
        largest_off = max(largest_off, *off)
    print(f"{len(CASES)} cycles, the largest difference {largest_off:.1e}")


if __name__ == "__main__":
    main()
