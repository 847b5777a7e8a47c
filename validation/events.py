"""Every event on the branches of docs/oscillation.md by simulations on both sides of it, with an integrator that found none of them.

``python -m validation.events`` prints a line for every doubling, torus, fold and grazing on the branches through four cycles.

- Doubling, torus: the cycle 0.02 degrees to either side is kicked by 1e-5 along the critical direction; what is left of the kick
  grows by the simulation on one side and shrinks on the other, at the rate of the multiplier.
- Fold: the driver of ``validation.cycles`` closes the orbit, and has a multiplier of 1 besides the trivial one; it is told
  beyond the fold, too.
- Grazing: one round has two crossings of x' = V, or of y = 0, more on one side than on the other.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

import spragsym as ss
from validation import cycles as validate_cycles

BELT = {"V": 0.5, "d": 10.0}

#: Degrees, and a state near a cycle of each branch.
SEEDS: dict[str, tuple[float, tuple[float, float, float, float]]] = {
    "34": (42.0, (2.538161566773, 3.361504868710, 0.0, 0.361278176249)),
    "165": (49.0, (3.178893595172, 2.120311377456, 0.0, 0.035253616447)),
    "75": (80.0, (3.002656, 0.40497029, 0.0, 0.13983899)),
    "26": (90.0, (2.32939917, 1.34003954, 0.0, 0.25152749)),
}

#: Branches, and their ranges in degrees.
BRANCHES = {"34": (1.0, 75.0), "165": (44.0, 60.0), "26": (55.0, 95.0), "75": (70.0, 95.0)}

#: To either side of an event.
ASIDE = float(np.radians(0.02))

#: To either side of a grazing: another one may be near.
CLOSE = float(np.radians(0.002))

ROUNDS, KICK = 12, 1e-5


def parameters(theta0: float) -> ss.Parameters:
    return ss.Parameters.article(theta0=theta0)


def critical(cycle: ss.Cycle, kind: str) -> tuple[complex, Any]:
    """The multiplier that an event of a kind is about, and a direction in which it acts."""
    values, vectors = np.linalg.eig(cycle.loop.monodromy)
    trivial = int(np.argmin(np.abs(values - cycle.multipliers[0])))
    aim = -1.0 if kind == "period_doubling" else 1.0
    off = np.abs(values - aim) if kind != "torus" else np.abs(np.abs(values) - 1) + 10 * (np.abs(values.imag) < 1e-9)
    off[trivial] = np.inf
    which = int(np.argmin(off))
    return complex(values[which]), vectors[:, which]


def kicked(cycle: ss.Cycle, kind: str, backend: str) -> tuple[float, float]:
    """Growth of a kick a round: by the simulation, and by the multiplier."""
    value, direction = critical(cycle, kind)
    size = np.zeros(ROUNDS + 1)
    for phase in (1.0, 1.0j) if kind == "torus" else (1.0,):
        kick = (phase * direction).real
        x, y, vx, vy = cycle.state + KICK * kick / np.linalg.norm(kick)
        p = parameters(cycle.values[0])
        tr = ss.simulate(p, **BELT, x0=x, y0=y, vx0=vx, vy0=vy, t_end=(ROUNDS + 1) * cycle.period, rtol=1e-13, backend=backend)
        off = tr(np.arange(ROUNDS + 1) * cycle.period) - cycle.state[:, None]
        parts = np.linalg.solve(np.linalg.eig(cycle.loop.monodromy)[1], off)
        which = int(np.argmin(np.abs(np.linalg.eigvals(cycle.loop.monodromy) - value)))
        size += np.abs(parts[which]) ** 2
    return float((size[-1] / size[0]) ** (0.5 / ROUNDS)), abs(value)


def crossings(cycle: ss.Cycle, backend: str) -> int:
    """In one round of a simulation, begun a little before the first of them."""
    x, y, vx, vy = cycle.trajectory(backend=backend)(0.5 * cycle.events.t[0]) if len(cycle.events) else cycle.state
    p = parameters(cycle.values[0])
    return len(ss.simulate(p, **BELT, x0=x, y0=y, vx0=vx, vy0=vy, t_end=cycle.period, rtol=1e-12, backend=backend).events)


def seen(branch: ss.CycleBranch, event: ss.CycleEvent, backend: str) -> tuple[bool, str]:
    """Whether an event is what it is said to be, and in what way."""
    if event.kind == "fold":
        end, matrix = validate_cycles.once_round(event.cycle)
        off = float(np.abs(end - event.cycle.state).max())
        gap = float(np.sort(np.abs(np.linalg.eigvals(matrix) - 1))[1])  # a double one: the root of the error
        other = branch.switch(event, step=0.005)
        first = critical(other, "fold")[0].real
        return gap < 1e-3 and off < 1e-9, f"closed by the other driver to {off:.1e}; 1 ± {gap:.0e} twice; {first:.6f} beyond it"
    aside = CLOSE if event.kind == "grazing" else ASIDE
    low, high = (ss.cycle(parameters(event.value + side * aside), **BELT, near=event.cycle) for side in (-1, 1))
    if event.kind == "grazing":
        counts = crossings(low, backend), crossings(high, backend)
        return abs(counts[0] - counts[1]) == 2, f"{counts[0]} and {counts[1]} crossings"
    (one, expected), (other, there) = kicked(low, event.kind, backend), kicked(high, event.kind, backend)
    right = (one < 1) != (other < 1) and abs(one - expected) < 2e-3 and abs(other - there) < 2e-3
    return right, f"a kick grows by {one:.5f} and {other:.5f} a round (multipliers {expected:.5f}, {there:.5f})"


def main() -> None:
    """Print the table; exit code 1 if an event is not seen."""
    wrong = events = 0
    for name, (low, high) in BRANCHES.items():
        angle, state = SEEDS[name]
        cycle = ss.cycle(parameters(np.radians(angle)), **BELT, near=state, patient=False)
        branch = ss.cycle_branch(cycle, "theta0", (np.radians(low), np.radians(high)), points=200)
        for event in branch.of("period_doubling", "torus", "fold", "grazing"):
            try:
                right, how = seen(branch, event, "compiled")
            except ss.ConvergenceError as error:
                right, how = False, str(error)
            wrong, events = wrong + (not right), events + 1
            verdict = "seen" if right else "NOT SEEN"
            print(f"{name:>4} {event.kind:16} {np.degrees(event.value):12.7f}  {verdict}: {how}", flush=True)
    print(f"{events - wrong} of {events} events seen")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
