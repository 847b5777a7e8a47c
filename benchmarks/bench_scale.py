"""How cost grows: points, workers, distance to the fold, memory, and the time to import and to the first answer.

``python -m benchmarks.bench_scale [LARGEST]``: up to 10^LARGEST points, 8 by default; 10^8 takes a few minutes and 14 GB.
"""

from __future__ import annotations

import math
import statistics
import subprocess
import sys
import time

import numpy as np

import spragsym as ss
from benchmarks.bench_equilibria import _with_backend
from benchmarks.families import random

_POINT = "import resource, numpy as np, spragsym as ss; rng = np.random.default_rng(0); n = {n}\n"
_MEMORY = _POINT + (
    "p = ss.Parameters(np.pi * rng.uniform(1e-9, 1, n), 2 * rng.random(n), 0.007, 0.007, 0.1, 0.0)\n"
    "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
    "ss.set_backend('{backend}', {threads})\n"
    "ss.equilibria(ss.Parameters(np.ones(10), 0.5, 0.007, 0.007, 0.1, 0.0))\n"
    "import time; t = time.perf_counter(); eq = ss.equilibria(p); t = time.perf_counter() - t\n"
    "after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
    "print(t, (after - before) / 1024, sum(getattr(eq, k).nbytes for k in ('theta', 'L', 'x', 'y', 'error', 'stability', 'count')) / 2**20)"
)


def main(largest: int = 8) -> None:
    """Print the tables."""
    print("Whole results (states, stability, error bounds), random θ₀ and μ₀ at the article's other values.\n")
    print("| points | NumPy, ns a point | numba 1 thread | numba 2 threads | peak memory beyond input, MB | of that results, MB |")
    print("|---|---|---|---|---|---|")
    _child(_MEMORY.format(n=30_000, backend="numba", threads=1))  # compile once
    for power in range(2, largest + 1):
        n = 10**power
        cells = []
        for backend, threads in (("numpy", 1), ("numba", 1), ("numba", 2)):
            if n < 10**6:
                cells.append(_small(n, backend, threads))
            else:
                seconds, peak, results = map(float, _child(_MEMORY.format(n=n, backend=backend, threads=threads)).split())
                cells.append(seconds / n)
        memory = f"{peak:,.0f} | {results:,.0f}" if n >= 10**6 else "- | -"
        print(f"| 10^{power} |" + "".join(f" {1e9 * cell:,.0f} |" for cell in cells) + f" {memory} |", flush=True)

    print("\nShare of points that leave float64, against the relative distance to the left fold at μ₀ = 0.5:\n")
    print("| distance | escalated | µs a point |")
    print("|---|---|---|")
    fold = float(ss.folds(ss.Parameters.article()).theta0[0])
    rng = np.random.default_rng(51)
    for power in range(-1, -16, -2):
        off = 10.0**power * rng.uniform(0.5, 1.5, 400) * rng.choice([-1, 1], 400)
        begin = time.perf_counter()
        eq = ss.equilibria(ss.Parameters.article(theta0=fold * (1 + off)))
        print(f"| 1e{power} | {eq.escalated.mean():.0%} | {1e6 * (time.perf_counter() - begin) / 400:,.1f} |")

    print("\nStart-up, median of 7 processes:\n")
    print("| what | ms | times `import numpy` |")
    print("|---|---|---|")
    numpy = _startup("import numpy")
    for title, code in (
        ("`import numpy`", "import numpy"),
        ("`import spragsym`", "import spragsym"),
        ("first equilibria of one point", "import spragsym as ss; ss.equilibria(ss.Parameters.article(theta0=1.0))"),
        ("first folds and cusps", "import spragsym as ss; p = ss.Parameters.article(); ss.folds(p); ss.cusps(p)"),
        ("`spragsym equilibria --theta0 49`", "from spragsym.cli import main; main(['equilibria', '--theta0', '49'])"),
    ):
        seconds = _startup(code)
        print(f"| {title} | {1e3 * seconds:.0f} | {seconds / numpy:.2f} |")


def _small(n: int, backend: str, threads: int) -> float:
    p = random(np.random.default_rng(0), n)
    _with_backend(backend, threads, p)
    best = math.inf
    for _ in range(5):
        begin = time.perf_counter()
        _with_backend(backend, threads, p)
        best = min(best, time.perf_counter() - begin)
    return best / n


def _child(code: str) -> str:
    return subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout


def _startup(code: str) -> float:
    """Time of a process that runs ``code``, less that of an empty one."""

    def once(text: str) -> float:
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", text], check=True, capture_output=True)
        return time.perf_counter() - begin

    return statistics.median(once(code) for _ in range(7)) - statistics.median(once("pass") for _ in range(7))


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
