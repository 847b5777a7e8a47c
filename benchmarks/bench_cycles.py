"""Time a cycle, and 200 points of a branch; a Markdown table, in seconds of processor time.

``python -m benchmarks.bench_cycles``: on one core, after a first cycle that compiles the
integrator. Cycles are looked for from the neighbouring one at 0.2 degrees away, as along a branch,
and from a state near them, which has to come around a few times first.
"""

import time

import numpy as np

import spragsym as ss
from benchmarks.timing import timed

BELT = {"V": 0.5, "d": 10.0}

#: Degrees, and a state near the cycle: weakly attracting, long, strongly repelling, nearly smooth.
CYCLES = (
    (42.0, (2.5382, 3.3615, 0.0, 0.3613)),
    (49.0, (3.1789, 2.1203, 0.0, 0.0353)),
    (35.5, (3.3119, 1.5622, 0.0, 0.0208)),
    (90.0, (2.3294, 1.3400, 0.0, 0.2515)),
)


def main() -> None:
    """Print the table."""
    print("| what | seconds |\n|---|---|")
    known = []
    for degrees, state in CYCLES:
        p = ss.Parameters.article(theta0=np.radians(degrees))
        ss.cycle(p, **BELT, near=state, patient=False)
        near, cycle = timed(
            lambda p=p, state=state: ss.cycle(p, **BELT, near=state, patient=False),
            time.process_time,
        )
        aside = p.replace(theta0=np.radians(degrees + 0.2))
        along, _ = timed(
            lambda p=aside, cycle=cycle: ss.cycle(p, **BELT, near=cycle), time.process_time
        )
        print(
            f"| cycle of period {cycle.period:.2f} at {degrees:g}°, from its neighbour | "
            f"{along:.3f} |"
        )
        print(f"| the same, from a state | {near:.3f} |", flush=True)
        known.append(cycle)
    ss.cycle_branch(
        known[0], "theta0", between={"theta0": (np.radians(41.9), np.radians(42.1))}, points=1
    )
    spent, branch = timed(
        lambda: ss.cycle_branch(
            known[0],
            "theta0",
            between={"theta0": (np.radians(1.0), np.radians(75.0))},
            points=100,
            options=ss.BranchOptions(longest_step=0.04),
        ),
        time.process_time,
    )
    count = len(branch.values)
    print(f"| {count} points of its branch with {len(branch.events)} events | {spent:.1f} |")
    print(f"| 200 points at that pace | {200 * spent / count:.1f} |")


if __name__ == "__main__":
    main()
