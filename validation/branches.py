"""Branches of cycles at random parameters, each over two ranges and with two steps: the same ends and events whatever these are.

``python -m validation.branches FOLDER [SEEDS [FIRST]]`` (100 seeds from 0 unless given). For each seed a cycle is looked for
from a random start at random parameters; it is followed over a random range of a random parameter, and again over a part of that range
with shorter steps; so is the doubled cycle at the first doubling. An event of one that is not on the other, although it lies on the
piece that both have, is printed and counted, and so is an event whose multipliers are not what it says. It shows its progress, may be
interrupted, and goes on where it was: results stand, one seed a line, in ``branches.jsonl`` of the folder.
"""

from __future__ import annotations

import json
import signal
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from validation.parts import journal

#: Parameters and the ranges that they are drawn from.
DRAWN = {
    "theta0": (0.35, 2.6), "mu0": (0.2, 1.0), "kappa": (0.002, 0.012), "alpha": (0.0, 0.012), "sigma": (0.05, 0.3), "V": (0.1, 0.6),
    "d": (4.0, 14.0),
}  # fmt: skip

#: Two events are one if their values are as close as this, in ranges, besides their errors.
SAME = 1e-8

#: Multipliers of this size are beside others that a plain product would have lost.
LARGE = 1e6

#: An event is in doubt where its multiplier is off by more than this share of what it changes to the next point.
SHARE = 0.1

#: Of so many points of a branch with the nearest value and period is the nearest state taken.
NEAREST = 6

#: Seconds of processor time after which a seed is given up, and counted as late.
LATEST = 600.0

#: What is known of an event: kind, value, period, error.
Told = tuple[str, float, float, float]


def begun(seed: int) -> tuple[ss.Cycle | None, np.random.Generator]:
    """The cycle of a seed; None where the motion comes to none."""
    rng = np.random.default_rng(seed)
    drawn = {name: float(rng.uniform(*between)) for name, between in DRAWN.items()}
    V, d = drawn.pop("V"), drawn.pop("d")
    start = rng.uniform([-1.0, -0.5, -0.5, -0.5], [3.0, 3.0, 0.5, 0.5])
    try:
        return ss.cycle(ss.Parameters(beta=0.0, **drawn), V=V, d=d, near=start, patient=False), rng
    except ss.ConvergenceError:
        return None, rng


def place(branch: ss.CycleBranch, cycle: ss.Cycle) -> int:
    """Index of the point of a branch that is nearest to a cycle."""
    scale = np.ptp(branch.values) or 1.0
    far = np.abs(branch.values - cycle.parameters[branch.vary]) / scale + np.abs(branch.periods / cycle.period - 1)
    near = np.argsort(far, kind="stable")[:NEAREST]  # a cycle with its error takes long where an orbit has many pieces
    away = [far[k] + float(np.abs(branch.cycles[k].state - cycle.state).max()) for k in near.tolist()]
    return int(near[int(np.argmin(away))])


def told(branch: ss.CycleBranch, inside: tuple[float, float], start: ss.Cycle) -> list[Told]:
    """Events on the piece of a branch around its start that lies within a range."""
    low, high = inside
    count, middle = len(branch.values), place(branch, start)
    turn = 0 if branch.of("end", "homoclinic") else middle - count // 2  # a closed branch goes on where its list ends
    out = np.flatnonzero((np.roll(branch.values, -turn) < low) | (np.roll(branch.values, -turn) > high))
    middle -= turn
    first, last = max(out[out < middle], default=-1), min(out[out > middle], default=count)
    width = high - low
    return [
        (event.kind, event.value, event.cycle.period, float(event.error))
        for event in branch.events
        if event.kind != "end" or "half" in event.how
        if low + 1e-3 * width < event.value < high - 1e-3 * width and first <= (place(branch, event.cycle) - turn) % count <= last
    ]  # fmt: skip


def missing(one: list[Told], other: list[Told], width: float) -> list[str]:
    """Events of the one that the other does not have."""
    return [
        f"{kind} at {value!r} of period {period:.5f}"
        for kind, value, period, error in one
        if not any(kind == k and abs(value - v) < SAME * width + error + e and abs(period / p - 1) < 1e-4 for k, v, p, e in other)
    ]


def doubtful(branch: ss.CycleBranch) -> list[str]:
    """Events whose multipliers are not what they say, to 1e-3, or next to a grazing to a share of what they change between points.

    Those that are said to jump, or to have no place, are left out.
    """
    found = []
    for event in branch.of("fold", "period_doubling", "torus"):
        if "jumps" in event.how or "no zero" in event.how:
            continue
        near = place(branch, event.cycle)
        beside = [
            _from_event(event.kind, branch.cycles[i].multipliers[1:])
            for i in (near - 1, near, near + 1)
            if 0 <= i < len(branch.cycles)
        ]
        values = event.cycle.multipliers[1:]
        off = _from_event(event.kind, values)
        if not off < max(1e-3, SHARE * max(beside)) or (event.kind == "torus" and not np.abs(values.imag).max() > 0):
            found.append(f"{event.kind} at {event.value!r}: multipliers {np.round(values, 6).tolist()}")
    return found


def _from_event(kind: str, values: Any) -> float:
    """How far the nearest multiplier is from where it is at an event."""
    aim = {"fold": np.abs(values - 1), "period_doubling": np.abs(values + 1), "torus": np.abs(np.abs(values) - 1)}[kind]
    return float(aim.min())


def compared(cycle: ss.Cycle, vary: str, ranges: list[tuple[float, float]]) -> tuple[dict[str, Any], ss.CycleBranch]:
    """A cycle followed over a range, and over a part of it with shorter steps."""
    begin = time.process_time()
    branches = [ss.cycle_branch(cycle, vary, to, points=120, longest=step) for to, step in zip(ranges, (0.08, 0.05), strict=True)]
    spent = time.process_time() - begin
    (whole, part), inside = (told(branch, ranges[1], cycle) for branch in branches), ranges[1]
    width = inside[1] - inside[0]
    cut = any("could not" in event.how or "points were" in event.how for branch in branches for event in branch.of("end"))
    sizes = [float(np.abs(each.multipliers).max()) for branch in branches for each in branch.cycles]
    return {
        "vary": vary, "ranges": ranges, "points": [len(branch.values) for branch in branches], "seconds": spent,
        "events": [event.kind for event in branches[0].events], "cut": cut, "largest": max(sizes),
        "large": sum(size > LARGE for size in sizes),
        "beside": [event.kind for branch in branches for event in branch.events if np.abs(event.cycle.multipliers).max() > LARGE],
        "why": [event.how for branch in branches for event in branch.of("end") if "could not" in event.how],
        "loose": sum(error > SAME * width for *_, error in (*whole, *part)), "compared": len(whole) + len(part),
        "missed": missing(whole, part, width), "invented": missing(part, whole, width),
        "doubtful": [text for branch in branches for text in doubtful(branch)],
    }, branches[0]  # fmt: skip


class Late(Exception):
    """A seed has had its time."""


def in_time(seed: int) -> dict[str, Any]:
    """What is found for a seed, or that it took too long."""

    def stop(*_: Any) -> None:
        raise Late

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, LATEST)
    try:
        return looked_at(seed)
    except Late:
        return {"seed": seed, "branches": [], "late": True}
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def looked_at(seed: int) -> dict[str, Any]:
    """What is found for a seed."""
    cycle, rng = begun(seed)
    if cycle is None:
        return {"seed": seed, "branches": []}
    vary = str(rng.choice(["theta0", "mu0", "V", "d"]))
    value = cycle.parameters[vary]
    wide = (value * (1 - rng.uniform(0.1, 0.5)), value * (1 + rng.uniform(0.1, 0.5)))
    if vary == "theta0":
        wide = (wide[0], min(wide[1], 3.0))
    part = (value - rng.uniform(0.2, 1.0) * (value - wide[0]), value + rng.uniform(0.2, 1.0) * (wide[1] - value))
    found, branch = compared(cycle, vary, [wide, part])
    rows = [found]
    for event in branch.of("period_doubling")[:1]:
        try:
            doubled = branch.switch(event)
        except ss.ConvergenceError as error:
            rows.append({"switch": str(error)})
            continue
        there = doubled.parameters[vary]
        if wide[0] < there < wide[1]:
            inner = (there - rng.uniform(0.1, 1.0) * (there - wide[0]), there + rng.uniform(0.1, 1.0) * (wide[1] - there))
            rows.append(compared(doubled, vary, [wide, inner])[0])
    return {"seed": seed, "branches": rows}


def main() -> None:
    """Go on where the last call ended, and print what differs; exit code 1 if anything does."""
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    count, first = (int(text) for text in (*sys.argv[2:], *("100", "0")[len(sys.argv) - 2 :]))
    path = folder / "branches.jsonl"
    lines = journal(path)
    done = {line["seed"] for line in lines}
    for seed in range(first, first + count):
        if seed in done:
            continue
        lines.append(in_time(seed))
        with path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(lines[-1]) + "\n")
        print(f"seed {seed}: {len(lines[-1]['branches'])} branches", file=sys.stderr, flush=True)
    rows = [(line["seed"], row) for line in lines for row in line["branches"]]
    both = [(seed, row) for seed, row in rows if "switch" not in row]
    for seed, row in both:
        for name in ("missed", "invented", "doubtful", "why"):
            for text in row[name]:
                print(f"seed {seed}, {row['vary']}, {name}{', followed in part' if row['cut'] else ''}: {text}")
    for seed, row in rows:
        if "switch" in row:
            print(f"seed {seed}: {row['switch']}")
    large = sorted(((row["largest"], seed) for seed, row in both), reverse=True)
    print("largest multipliers by seed: " + ", ".join(f"{size:.1e} ({seed})" for size, seed in large[:10]))
    print(
        f"{sum(size > LARGE for size, _ in large)} of {len(large)} pairs of branches with multipliers above {LARGE:g}, at "
        f"{sum(row.get('large', 0) for _, row in both)} points; events beside such: "
        f"{sum(len(row.get('beside', ())) for _, row in both)}"
    )
    bad = [row for _, row in both if not row["cut"] and (row["missed"] or row["invented"])]
    doubted = [row for _, row in both if row["doubtful"]]
    spent, points = sum(row["seconds"] for _, row in both), sum(sum(row["points"]) for _, row in both)
    print(
        f"{2 * len(both)} branches with {points} points, {1e3 * spent / max(points, 1):.1f} ms each; {len(bad)} pairs differ, "
        f"{len(doubted)} with events in doubt, {sum(row['loose'] for _, row in both)} of {sum(row['compared'] for _, row in both)} events "
        f"not isolated, {sum(row['cut'] for _, row in both)} followed in part; multipliers up to "
        f"{max((row['largest'] for _, row in both), default=0.0):.1e}; {sum('switch' in row for _, row in rows)} switches failed; {sum('late' in line for line in lines)} seeds given up after {LATEST:g} s"
    )
    sys.exit(bool(bad or doubted))


if __name__ == "__main__":
    main()
