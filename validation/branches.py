"""Branches of cycles at random parameters, each over two ranges and with two steps: the same ends
and events whatever these are.

A cycle from a random start is followed over a random range of a random parameter, and again over a
part of that range with shorter steps; so is the doubled cycle at the first doubling. An event of
one that is not on the other, although it lies on the piece that both have, contradicts, and so does
an event whose multipliers are not what it says. Last found: an event placed where a multiplier only
jumps past its value beside a grazing (0f39328e).
"""

from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.random_motions import cycle_of

CASES = 100
#: Two events are one if their values are as close as this, in ranges, besides their errors.
SAME = 1e-8

#: An event is in doubt where its multiplier is off by more than this share of what it changes to
#: the next point.
SHARE = 0.1

#: Of so many points of a branch with the nearest value and period is the nearest state taken.
NEAREST = 6

#: What is known of an event: kind, value, period, error.
Told = tuple[str, float, float, float]


def place(branch: ss.results.CycleBranch, cycle: ss.results.Cycle) -> int:
    """Index of the point of a branch that is nearest to a cycle."""
    scale = np.ptp(branch.values) or 1.0
    far = np.abs(branch.values - cycle.parameters[branch.vary]) / scale + np.abs(
        branch.periods / cycle.period - 1
    )
    near = np.argsort(far, kind="stable")[
        :NEAREST
    ]  # a cycle with its error takes long where an orbit has many pieces
    away = [
        far[k] + float(np.abs(branch.cycles[k].state - cycle.state).max()) for k in near.tolist()
    ]
    return int(near[int(np.argmin(away))])


def told(
    branch: ss.results.CycleBranch, inside: tuple[float, float], start: ss.results.Cycle
) -> list[Told]:
    """Events on the piece of a branch around its start that lies within a range."""
    low, high = inside
    count, middle = len(branch.values), place(branch, start)
    turn = (
        0 if branch.of("end", "homoclinic", "catastrophic-sliding") else middle - count // 2
    )  # a closed branch goes on where its list ends
    out = np.flatnonzero(
        (np.roll(branch.values, -turn) < low) | (np.roll(branch.values, -turn) > high)
    )
    middle -= turn
    first, last = max(out[out < middle], default=-1), min(out[out > middle], default=count)
    width = high - low
    return [
        (event.kind, event.value, event.cycle.period, float(event.error))
        for event in branch.events
        if event.kind != "end" or "half" in event.how
        if low + 1e-3 * width < event.value < high - 1e-3 * width
        and first <= (place(branch, event.cycle) - turn) % count <= last
    ]


def missing(one: list[Told], other: list[Told], width: float) -> list[str]:
    """Events of the one that the other does not have."""
    return [
        f"{kind} at {value!r} of period {period:.5f}"
        for kind, value, period, error in one
        if not any(
            kind == k and abs(value - v) < SAME * width + error + e and abs(period / p - 1) < 1e-4
            for k, v, p, e in other
        )
    ]


def doubtful(branch: ss.results.CycleBranch) -> list[str]:
    """Events whose multipliers are not what they say, to 1e-3, or next to a grazing to a share of
    what they change between points.

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
        if not off < max(1e-3, SHARE * max(beside)) or (
            event.kind == "torus" and not np.abs(values.imag).max() > 0
        ):
            found.append(
                f"{event.kind} at {event.value!r}: multipliers {np.round(values, 6).tolist()}"
            )
    return found


def _from_event(kind: str, values: Any) -> float:
    """How far the nearest multiplier is from where it is at an event."""
    aim = {
        "fold": np.abs(values - 1),
        "period_doubling": np.abs(values + 1),
        "torus": np.abs(np.abs(values) - 1),
    }[kind]
    return float(aim.min())


def compared(
    cycle: ss.results.Cycle, vary: str, ranges: list[tuple[float, float]]
) -> tuple[dict[str, Any], ss.results.CycleBranch]:
    """A cycle followed over a range, and over a part of it with shorter steps."""
    branches = [
        ss.cycle_branch(
            cycle, vary, between={vary: to}, points=120, options=ss.BranchOptions(longest_step=step)
        )
        for to, step in zip(ranges, (0.08, 0.05), strict=True)
    ]
    (whole, part), inside = (told(branch, ranges[1], cycle) for branch in branches), ranges[1]
    width = inside[1] - inside[0]
    cut = any(
        "could not" in event.how or "points were" in event.how
        for branch in branches
        for event in branch.of("end")
    )
    differ = [] if cut else [f"missed: {text}" for text in missing(whole, part, width)]
    differ += [] if cut else [f"invented: {text}" for text in missing(part, whole, width)]
    differ += [f"in doubt: {text}" for branch in branches for text in doubtful(branch)]
    return {
        "wrong": [f"along {vary}, {text}" for text in differ],
        "pairs": 1,
        "points": sum(len(branch.values) for branch in branches),
        "in part": int(cut),
        "events": len(whole) + len(part),
        "loose": sum(error > SAME * width for *_, error in (*whole, *part)),
    }, branches[0]


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """The branch of a cycle, and that of the cycle which it doubles into."""
    cycle, rng = cycle_of(number)
    if cycle is None:
        return {"kind": "no cycle", "wrong": []}
    vary = str(rng.choice(["theta0", "mu0", "V", "d"]))
    value = cycle.parameters[vary]
    wide = (value * (1 - rng.uniform(0.1, 0.5)), value * (1 + rng.uniform(0.1, 0.5)))
    if vary == "theta0":
        wide = (wide[0], min(wide[1], 3.0))
    part = (
        value - rng.uniform(0.2, 1.0) * (value - wide[0]),
        value + rng.uniform(0.2, 1.0) * (wide[1] - value),
    )
    found, branch = compared(cycle, vary, [wide, part])
    rows = [found]
    for event in branch.of("period_doubling")[:1]:
        try:
            doubled = branch.switch(event)
        except ss.errors.ConvergenceError:
            return summed(rows) | {"not switched": 1}
        there = doubled.parameters[vary]
        if wide[0] < there < wide[1]:
            inner = (
                there - rng.uniform(0.1, 1.0) * (there - wide[0]),
                there + rng.uniform(0.1, 1.0) * (wide[1] - there),
            )
            rows.append(compared(doubled, vary, [wide, inner])[0])
    return summed(rows)


def summed(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """All pairs of branches of a case; what differs counts where neither was followed in part."""
    wrong = [text for row in rows for text in row.pop("wrong")]
    return {
        "kind": "branches",
        "wrong": wrong,
        **{key: sum(row[key] for row in rows) for key in rows[0]},
    }
