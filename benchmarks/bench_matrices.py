"""Onsets of squeal of random brakes as matrices beside a grid of eigenvalues.

``python -m benchmarks.bench_matrices [LARGEST]``: up to so many coordinates, 200 by default, which
takes some minutes; with BLAS on one thread, as OMP_NUM_THREADS=1 says, processor time is that of
one core.
"""

import sys
import time
from functools import partial

import numpy as np

import spragsym as ss
from benchmarks.timing import timed
from tests.oracles import brakes


def main(largest: int = 200) -> None:
    """Print the table."""
    print("Frictions from 0 to 1, growth above 0; processor seconds, medians of the brakes.\n")
    print("| coordinates | brakes | onsets | decided | proof | 200 LAPACK solves | ratio |")
    print("|---|---|---|---|---|---|---|")
    ask = partial(timed, clock=time.process_time)
    for n, seeds in ((10, 6), (30, 6), (100, 2), (200, 1)):
        if n > largest:
            break
        rows = []
        for kind in ("plain", "near", "weak")[: 3 if n < 200 else 1]:
            for seed in range(seeds):
                of = brakes.brake(n, seed, kind=kind)
                p = ss.matrices(of["M"], of["K"], of["friction"], C=of["C"]).Parameters()
                values = np.linspace(0.0, 1.0, 200)
                grid, _ = ask(partial(brakes.counts, of, values, 0.0))
                seconds, on = ask(partial(ss.flutter_onsets, p, "mu", threshold=0.0))
                decided = 1.0 - np.diff(on.undecided).sum()
                rows.append((len(on), decided, seconds, grid, seconds / grid))
        onsets, _, *times = np.median(rows, axis=0)
        least = min(row[1] for row in rows)
        print(
            f"| {n} | {len(rows)} | {onsets:g} | {least:.2%} | "
            + " | ".join(f"{one:.2g}" for one in times)
            + " |",
            flush=True,
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
