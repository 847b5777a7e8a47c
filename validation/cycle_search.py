"""The search for cycles behind docs/oscillation.md: from many starts, along the inclination, and
from period doublings.

``python -m validation.cycle_search FOLDER [STARTS [POINTS]]`` (16 starts and 70 points a branch
each way unless given):

1. motions from rest and from random starts at each of 22 inclinations, judged at τ = 6000 by the
   cycle that they approach;
2. every distinct cycle of these, unless it lies on a branch that is known, is followed over the
   inclination;
3. where its period doubles, the doubled cycle is followed as well if it is stable there, and again
   from its doublings, twice at most: a motion may come to it. Each time half as many points are
   followed.

It shows its progress, may be interrupted, and goes on where it was when it is called again: motions
stand in ``motions.nc`` and branches, one a line, beside them in a file whose name is a key of the
code. What the figure ``cycles`` draws is written to ``cycles.json`` of the folder; it is committed
as spragsym/figures/cycles.json.
"""

import json
import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.motion.sweeps import Regime, rms_sweep
from validation.__main__ import store_of

BELT = {"V": 0.5, "d": 10.0}

#: Degrees.
INCLINATIONS = (
    5,
    10,
    20,
    30,
    38,
    42,
    43,
    44,
    46,
    49,
    52,
    54,
    57,
    60,
    66,
    75,
    80,
    90,
    105,
    120,
    140,
    160,
)

#: Range over which branches are followed, degrees.
LOW, HIGH = 1.0, 179.0

#: Doublings of doublings.
DEEPEST = 2


def motions(folder: Path, starts: int) -> ss.results.Sweep:
    """All motions; resumed from their store."""
    rng = np.random.default_rng(15)
    wide = rng.uniform([-1.0, -0.5, -0.5, -0.5], [3.0, 3.0, 0.5, 0.5], (starts, 4))
    wide[0] = 0.0
    x0, y0, vx0, vy0 = wide.T
    p = ss.Parameters.article(theta0=np.radians(np.array(INCLINATIONS, dtype=float))[:, None])
    return rms_sweep(
        p,
        **BELT,
        x0=x0,
        y0=y0,
        vx0=vx0,
        vy0=vy0,
        t_end=6000.0,
        transient=5000.0,
        progress=True,
        store=folder / "motions.nc",
    )


def cycles_of(sweep: ss.results.Sweep) -> Iterator[tuple[float, list[float]]]:
    """Inclination in degrees and state of every distinct cycle that a motion came to."""
    seen: set[tuple[float, float, float]] = set()
    for row, col in np.argwhere(
        np.isin(sweep.regime, (Regime.LIMIT_CYCLE, Regime.APPROACHES_CYCLE))
    ):
        key = (
            float(row),
            round(float(sweep.period[row, col]), 4),
            round(float(sweep.cycle_x[row, col]), 4),
        )
        if key not in seen:
            seen.add(key)
            state = [
                float(getattr(sweep, name)[row, col]) for name in ("cycle_x", "cycle_y", "cycle_vy")
            ]
            yield float(INCLINATIONS[row]), [state[0], state[1], 0.0, state[2]]


def told(branch: ss.results.CycleBranch, name: str) -> dict[str, Any]:
    """A branch as a line of the journal holds it."""
    return {
        "name": name,
        "theta0": branch.values.tolist(),
        "period": branch.periods.tolist(),
        "stable": branch.stable.tolist(),
        "rms": branch.rms.tolist(),
        "states": [cycle.state.tolist() for cycle in branch.cycles],
        "events": [
            [event.kind, event.value, event.cycle.period, event.cycle.rms, event.how]
            for event in branch.events
        ],
    }


def known_at(lines: list[dict[str, Any]], cycle: ss.results.Cycle) -> bool:
    """Whether a cycle lies on a branch that is known: its period and root mean square are those
    between two of its points.
    """
    theta0 = cycle.values[0]
    for line in lines:
        values, periods, sizes = (np.array(line[name]) for name in ("theta0", "period", "rms"))
        for i in np.flatnonzero((values[:-1] - theta0) * (values[1:] - theta0) <= 0):
            share = (theta0 - values[i]) / (values[i + 1] - values[i] or 1.0)
            period, size = (
                column[i] + share * (column[i + 1] - column[i]) for column in (periods, sizes)
            )
            if abs(period / cycle.period - 1) < 2e-3 and abs(size / cycle.rms - 1) < 5e-3:
                return True
    return False


def follow(
    path: Path,
    lines: list[dict[str, Any]],
    cycle: ss.results.Cycle,
    name: str,
    points: int,
    depth: int = 0,
) -> None:
    """Follow a branch and those of its doublings, each unless it is done."""
    if any(line["name"] == name for line in lines) or known_at(lines, cycle):
        return
    print(
        f"following {name}: period {cycle.period:.4f} at {math.degrees(cycle.values[0]):.4f} "
        "degrees",
        file=sys.stderr,
        flush=True,
    )
    branch = ss.cycle_branch(
        cycle, "theta0", between={"theta0": (math.radians(LOW), math.radians(HIGH))}, points=points
    )
    doubled = []
    for event in branch.of("period_doubling") if depth < DEEPEST else ():
        try:
            found = branch.switch(event)
        except ss.errors.ConvergenceError as error:
            print(f"  {error}", file=sys.stderr, flush=True)
            continue
        if found.stable:
            doubled.append(found)
    for number, other in enumerate(doubled):
        follow(path, lines, other, f"{name}, doubled {number + 1}", max(points // 2, 1), depth + 1)
    lines.append(
        told(branch, name)
    )  # last, so that an interruption repeats the branch with what begins on it
    with path.open("a", encoding="utf-8") as file:
        file.write(json.dumps(lines[-1]) + "\n")


def record(sweep: ss.results.Sweep, lines: list[dict[str, Any]]) -> dict[str, Any]:
    """What the figure draws of all this, to the digits that a picture needs."""
    kept = ("theta0", "period", "rms")
    return {
        "made_by": "python -m validation.cycle_search FOLDER",
        "version": ss.__version__,
        **BELT,
        "motions": int(sweep.regime.size),
        "starts": int(sweep.regime.shape[1]),
        "inclinations_deg": list(INCLINATIONS),
        "branches": [
            {
                "name": line["name"],
                **{name: [float(f"{value:.7g}") for value in line[name]] for name in kept},
                "at": _middle(line),
                "stable": [int(stable) for stable in line["stable"]],
                "events": [
                    [kind, *(float(f"{number:.10g}") for number in numbers), how]
                    for kind, *numbers, how in line["events"]
                    if kind != "grazing"
                ],
            }
            for line in lines
        ],
    }


def _middle(line: dict[str, Any]) -> list[float]:
    """Inclination, period and state of one cycle of a branch: a stable one if there is one."""
    stable = np.flatnonzero(line["stable"])
    i = int(stable[len(stable) // 2]) if stable.size else len(line["period"]) // 2
    return [
        float(f"{value:.12g}")
        for value in (line["theta0"][i], line["period"][i], *line["states"][i])
    ]


def main() -> None:
    """Search, and print how many motions there were."""
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    starts, points = (int(text) for text in (*sys.argv[2:], *("16", "70")[len(sys.argv) - 2 :]))
    sweep = motions(folder, starts)
    path = store_of(folder, f"branches {starts} {points}", 15)
    lines = (
        [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
        if path.exists()
        else []
    )
    for degrees, state in cycles_of(sweep):
        try:
            cycle = ss.cycle(
                ss.Parameters.article(theta0=math.radians(degrees)),
                **BELT,
                near=state,
                patient=False,
            )
        except ss.errors.ConvergenceError as error:
            print(f"{degrees:g} degrees, {state}: {error}", file=sys.stderr)
            continue
        follow(path, lines, cycle, f"period {cycle.period:.2f} at {degrees:g}", points)
    (folder / "cycles.json").write_text(
        json.dumps(record(sweep, lines), ensure_ascii=False).replace("}, {", "},\n{") + "\n"
    )
    counts = np.bincount(sweep.regime.ravel(), minlength=len(Regime))
    print(
        "Motions: "
        + ", ".join(f"{n} {Regime(i).name.lower()}" for i, n in enumerate(counts.tolist()) if n)
    )
    near = counts[[Regime.LIMIT_CYCLE, Regime.APPROACHES_CYCLE]].sum()
    print(
        f"{len(sweep.regime)} inclinations, {counts.sum()} motions: {near} to a cycle or "
        "nearing one"
    )


if __name__ == "__main__":
    main()
