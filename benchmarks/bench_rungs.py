"""Which rung settles the points of each family, and what it costs; a Markdown table.

``python -m benchmarks.bench_rungs [N]``: N points of each family, in contact and in lift-off, 10 000 by default. Shares are of all
points; times are processor time, of the points that a rung is asked, the shortest of three runs. Intervals are timed on at most 40 of
the points that leave float64, which is what these cost before there was double-double arithmetic. Wrong are counts that differ from
the exact reference, and found / bound is the largest share of an error bound that an error reaches, of 60 points.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import spragsym as ss
from spragsym.kang_nam.statics import adaptive_precision, block, compiled
from spragsym.parameters import NAMES
from spragsym.results import state_columns
from tests.oracles.families import FAMILIES
from validation.equilibria import worst_errors, wrong_counts

Values = list[NDArray[np.float64]]


def main(each: int = 10_000) -> int:
    """Print the table; the number of wrong counts and exceeded bounds is the exit code's."""
    print(f"{each} points of each family.\n")
    print(
        "| family | regime | float64 | double-double | intervals | µs: NumPy | µs: compiled | µs: intervals | wrong | found / bound |"
    )
    print("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|")
    bad = 0
    for number, (name, family) in enumerate(FAMILIES.items()):
        p = family(np.random.default_rng([61, number]), each)
        for contact in (True, False):
            bad += _row(name, p, contact)
    return bad


def _row(name: str, p: ss.Parameters, contact: bool) -> int:
    values = [np.ascontiguousarray(value) for value in p.broadcast(*NAMES)]
    left = compiled.solve(values, contact, state_columns.Slots(p.shape[0], 4 - contact), 0, p.shape[0])
    open_ones = [value[left] for value in values]
    rungs: list[Callable[..., NDArray[np.int64]]] = [block.solve_widely, compiled.solve_widely]
    timed = [_timed(solve, open_ones, contact) for solve in rungs] if left.size else []
    hopeless = timed[0][1] if timed else 0
    intervals = _ladder([value[:40] for value in open_ones], contact) if left.size else None
    eq = ss.equilibria(p, contact=contact)
    wrong = wrong_counts(p, eq) if contact else 0
    _, ratio = worst_errors(p, eq, np.random.default_rng(62), 60)
    shares = (1 - left.size / p.shape[0], (left.size - hopeless) / p.shape[0], hopeless / p.shape[0])
    cells = [f"{share:.2%}" for share in shares] + [f"{spent:.2f}" for spent, _ in timed]
    cells += [""] * (5 - len(cells)) + ["" if intervals is None else f"{intervals:.0f}", str(wrong), f"{ratio:.2f}"]
    print(f"| {name} | {'contact' if contact else 'lift-off'} | " + " | ".join(cells) + " |", flush=True)
    return wrong + int(ratio > 1)


def _timed(solve: Callable[..., NDArray[np.int64]], values: Values, contact: bool) -> tuple[float, int]:
    """Microseconds a point, and how many points stay open."""
    best, points = np.inf, values[0].size
    for _ in range(3):
        out = state_columns.Slots(points, 4 - contact)
        begin = time.process_time()
        with np.errstate(all="ignore"):
            still = sum(
                solve([value[at : at + 4096] for value in values], contact, out, at, min(4096, points - at)).size
                for at in range(0, points, 4096)
            )
        best = min(best, time.process_time() - begin)
    return 1e6 * best / points, still


def _ladder(values: Values, contact: bool) -> float:
    begin = time.process_time()
    for point in zip(*values, strict=True):
        adaptive_precision.equilibria(*map(float, point), contact=contact)
    return 1e6 * (time.process_time() - begin) / values[0].size


if __name__ == "__main__":
    sys.exit(main(*(int(argument) for argument in sys.argv[1:2])))
