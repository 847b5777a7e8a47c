"""Processor time of the statics of the shipped models beside the closed forms of the article's
model.

``OMP_NUM_THREADS=1 python -m benchmarks.bench_models [POINTS]``: POINTS of each model and of each
family, and their square root, or 317, as the side of a grid.
"""

import sys
import time
from collections.abc import Callable
from functools import partial
from math import isqrt
from typing import Any

import numpy as np

import spragsym as ss
from benchmarks.timing import timed
from tests.oracles.families import FAMILIES

#: Points of random parameters, unless a number is given, and then of one side of a grid.
POINTS, SIDE = 2000, 317
#: Single calls that are timed.
CALLS = 20
MODELS = (
    "kang_nam",
    "damped",
    "stribeck",
    "cubic_contact",
    "hertz_contact",
    "two_springs",
    "inclined_belt",
    "trolley",
    "mode_coupling",
    "stick_slip",
)
NAMES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")


def seconds(work: Callable[..., Any], *arguments: Any, **keywords: Any) -> tuple[float, Any]:
    """Processor time of a call, and what it returns; the shorter of two times if they are short."""
    spent, result = np.inf, None
    for _ in range(2):
        once, result = timed(partial(work, *arguments, **keywords), time.process_time)
        spent = min(spent, once)
        if spent > 1:
            break
    return spent, result


def random_values(names: Any, points: int) -> dict[str, Any]:
    """Random directions, friction or speeds, all else as it is."""
    rng = np.random.default_rng(1)
    ranges = (("theta0", 0.05, 3.0), ("mu0", 0.05, 1.5), ("V", 0.1, 1.0))
    return {name: rng.uniform(low, high, points) for name, low, high in ranges if name in names}


def single(of: Any, parameters: Any, values: dict[str, Any]) -> float:
    """Processor time of a call with one point, on average."""
    points = [
        parameters(**{name: float(row[k]) for name, row in values.items()}) for k in range(CALLS)
    ]
    ss.equilibria(points[0])
    return seconds(lambda: [ss.equilibria(p) for p in points])[0] / CALLS


def table(points: int) -> None:
    """Equilibria, folds and cusps of all models."""
    print(
        f"{points} points with random directions, friction or speeds, and the base values "
        "else. Folds and cusps at 1 rad.\n"
    )
    print(
        "| model | equilibria, µs a point | one call, ms | folds along theta0, s | along mu0, "
        "s | cusps, s | left open |"
    )
    print("|---|---|---|---|---|---|---|")
    for name in MODELS:
        model = ss.load(name).search
        values = random_values(model.parameters, points)
        p = model.Parameters(**values)
        spent, eq = seconds(ss.equilibria, p)
        one = model.Parameters(**({"theta0": 1.0} if "theta0" in model.parameters else {}))
        cells, left = [], int((~eq.decided).sum())
        for vary in ("theta0", "mu0"):
            if vary in model.parameters:
                time_of, found = seconds(ss.folds, one, vary)
                cells.append(f"{time_of:.2f}")
                left += len(found.undecided)
            else:
                cells.append("")
        if {"theta0", "mu0"} <= set(model.parameters) and len(model.coordinates) == 2:
            time_of, found = seconds(ss.cusps, one, ("theta0", "mu0"), between={"mu0": (0, 2)})
            cells.append(f"{time_of:.2f}")
            left += len(found.undecided)
        else:
            cells.append("")
        call = single(model, model.Parameters, values)
        print(
            f"| {name} | {1e6 * spent / points:.0f} | {1e3 * call:.1f} | {' | '.join(cells)} "
            f"| {left} |",
            flush=True,
        )
    values = random_values(NAMES, points)
    closed = ss.Parameters.article(**values)
    spent = seconds(ss.equilibria, closed)[0]
    call = single(ss, ss.Parameters.article, values)
    along = (
        seconds(ss.folds, ss.Parameters.article())[0],
        seconds(ss.folds, ss.Parameters.article(theta0=1.0), "mu0")[0],
    )
    cells = [
        f"{time_of:.3f}" for time_of in (*along, seconds(ss.cusps, ss.Parameters.article())[0])
    ]
    print(
        f"| closed forms of `kang_nam` | {1e6 * spent / points:.1f} | {1e3 * call:.2f} | "
        f"{' | '.join(cells)} | |\n"
    )


def families(points: int) -> None:
    """The article's model in hard places, through the general way and by its closed forms."""
    model = ss.load("kang_nam").search
    print(
        f"`kang_nam` through the general way and by its closed forms, {points} points of each "
        "family:\n"
    )
    print("| family | general, ms a point | closed forms, ms a point | left open | other counts |")
    print("|---|---|---|---|---|")
    for name, family in FAMILIES.items():
        # Points of the wedge stand in groups of 200 about one cusp: of more of them, each tenth.
        every = 10 if name == "cusp wedge" else 1
        p = family(np.random.default_rng(1), points * every)
        values = {key: np.broadcast_to(getattr(p, key), p.shape)[::every] for key in NAMES}
        spent, eq = seconds(ss.equilibria, model.Parameters(**values))
        time_of, known = seconds(ss.equilibria, ss.Parameters(**values))
        other = eq.decided & known.decided & ~known.fold & (eq.count != known.count)
        print(
            f"| {name} | {1e3 * spent / points:.3f} | {1e3 * time_of / points:.4f} | "
            f"{int((~eq.decided).sum())} "
            f"| {int(other.sum())} |",
            flush=True,
        )
    print()


def grid(side: int) -> None:
    """A grid of 10⁵ points."""
    theta0, mu0 = np.meshgrid(
        np.linspace(0.02, 3.12, side), np.linspace(0, 1.5, side), indexing="ij"
    )
    print(f"A grid of {theta0.size} points of `theta0` and `mu0`:\n")
    print("| model | s | left open |\n|---|---|---|")
    for name in ("kang_nam", "cubic_contact"):
        model = ss.load(name).search
        spent, eq = seconds(ss.equilibria, model.Parameters(theta0=theta0, mu0=mu0))
        print(f"| {name} | {spent:.1f} | {int((~eq.decided).sum())} |", flush=True)


def main() -> None:
    """All tables."""
    points = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    table(points)
    families(points)
    grid(isqrt(points) if len(sys.argv) > 1 else SIDE)


if __name__ == "__main__":
    main()
