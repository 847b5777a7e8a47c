"""How cost grows: with points, threads, and the distance to the fold; and memory.

``python -m benchmarks.bench_scale [LARGEST]``: up to 10^LARGEST points, 8 by default; 10^8 takes a
few minutes and 14 GB.
"""

import sys
from functools import partial

import numpy as np

import spragsym as ss
from benchmarks.timing import best, in_process, on_backend, timed
from spragsym.kang_nam.quartic import compiled
from tests.oracles.families import random

_POINT = "import resource, numpy as np, spragsym as ss; rng = np.random.default_rng(0); n = {n}\n"
_MEMORY = _POINT + (
    "p = ss.Parameters(np.pi * rng.uniform(1e-9, 1, n), 2 * rng.random(n), 0.007, 0.007, 0.1, "
    "0.0)\n"
    "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
    "ss.kang_nam.set_backend('{backend}', {threads})\n"
    "ss.equilibria(ss.Parameters(np.ones(10), 0.5, 0.007, 0.007, 0.1, 0.0))\n"
    "import time; t = time.perf_counter(); eq = ss.equilibria(p); t = time.perf_counter() - t\n"
    "after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
    "print(t, (after - before) / 1024, sum(getattr(eq, k).nbytes for k in ('theta', 'L', 'x', "
    "'y', 'error', 'undamped', 'count')) / 2**20)"
)


def main(largest: int = 8) -> None:
    """Print the tables."""
    print(
        "Whole results (states, stability, error bounds), random θ₀ and μ₀ at the article's "
        "other values.\n"
    )
    ways = [("numpy", 1), *([("compiled", 1), ("compiled", 2)] if compiled.available() else [])]
    titles = [f"{backend}, {threads} thread{'s' * (threads > 1)}" for backend, threads in ways]
    print(f"| points | {' | '.join(titles)} | peak memory beyond input, MB | of that results, MB |")
    print("|---|" + "---|" * (len(ways) + 2))
    for power in range(2, largest + 1):
        n = 10**power
        cells, memory = [], "- | -"
        for backend, threads in ways:
            if n < 10**6:
                p = random(np.random.default_rng(0), n)
                cells.append(best(partial(on_backend, backend, threads, ss.equilibria, p)) / n)
            else:
                spent, peak, results = map(
                    float, in_process(_MEMORY.format(n=n, backend=backend, threads=threads)).split()
                )
                cells.append(spent / n)
                memory = f"{peak:,.0f} | {results:,.0f}"
        print(
            f"| 10^{power} |" + "".join(f" {1e9 * cell:,.0f} |" for cell in cells) + f" {memory} |",
            flush=True,
        )

    print(
        "\nShare of points that leave float64, against the relative distance to the left fold "
        "at μ₀ = 0.5:\n"
    )
    print("| distance | escalated | µs a point |")
    print("|---|---|---|")
    fold = float(ss.folds(ss.Parameters.article()).theta0[0])
    rng = np.random.default_rng(51)
    for power in range(-1, -16, -2):
        off = 10.0**power * rng.uniform(0.5, 1.5, 400) * rng.choice([-1, 1], 400)
        p = ss.Parameters.article(theta0=fold * (1 + off))
        spent, eq = timed(partial(ss.equilibria, p))
        print(f"| 1e{power} | {eq.escalated.mean():.0%} | {1e6 * spent / 400:,.1f} |")


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
