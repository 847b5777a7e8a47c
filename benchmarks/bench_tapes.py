"""Searches over boxes by compiled code beside the same searches by NumPy; a Markdown table.

``python -m benchmarks.bench_tapes [MODEL ...]``: folds along the friction or another parameter,
cusps, and equilibria of one point, by the general algorithm: processor time, best of three in turn,
and boxes that are looked at. Both look at the same boxes and give the same bits, which is asked
each time.
"""

import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import spragsym as ss
from benchmarks.timing import timed, watched
from spragsym.numerics import boxes, contractors, tape

ROUNDS = 3
MODELS = ("kang_nam", "cubic_contact", "hertz_contact", "two_springs", "trolley", "sprag_rod")


def main(*names: str) -> None:
    """Print the table."""
    print("| model | question | boxes | compiled, ms | by NumPy, ms | ratio |")
    print("|---|---|---|---|---|---|")
    for name in names or MODELS:
        for question, asked in questions(name).items():
            looks, times, found = compared(asked)
            same = all(
                np.array_equal(column, found[False].data()[key], equal_nan=True)
                for key, column in found[True].data().items()
                if np.asarray(column).dtype.kind == "f"
            )
            one, other = times[True], times[False]
            cells = f"{looks:,} | {1e3 * one:.1f} | {1e3 * other:.1f} | {other / one:.1f}"
            print(f"| {name} | {question} | {cells} |" + ("" if same else " other bits"))


def questions(name: str) -> dict[str, Callable[[], Any]]:
    """What is asked of a model, by the general algorithm."""
    model = ss.load(name)
    p = model.Parameters()
    p = p.replace(**{name: 0.7 for name in model.plane if getattr(p, name) is None})
    vary = model.plane
    out: dict[str, Callable[[], Any]] = {
        f"folds along {vary[-1]}": lambda: ss.folds(p, vary=vary[-1], method="search"),
        "equilibria of one point": lambda: ss.equilibria(p, method="search"),
    }
    if len(model.plane) == 2:
        out["cusps"] = lambda: ss.cusps(p, method="search")
    return out


def compared(
    asked: Callable[[], Any],
) -> tuple[int, dict[bool, float], dict[bool, Any]]:
    """Boxes that are looked at; least processor time and the result, compiled and not."""
    times, found, looks = {True: np.inf, False: np.inf}, {}, 0
    compiled = tape.compiled, contractors.compiled
    for _ in range(ROUNDS):
        for way in times:
            tape.compiled, contractors.compiled = compiled if way else (None, None)
            with watched(boxes, "search") as calls:
                spent, found[way] = timed(asked, time.process_time)
            times[way], looks = min(times[way], spent), sum(one.result.looks for one in calls)
    tape.compiled, contractors.compiled = compiled
    return looks, times, found


if __name__ == "__main__":
    main(*sys.argv[1:])
