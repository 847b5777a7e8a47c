"""The C target beside the other compiled path, NumPy and eigenvalues, in one run; and what it
vouches for where it is hard.

``python -m benchmarks.bench_c [N]``: N random points, 1 000 000 by default; Markdown tables.
"""

import os
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import shutil
from collections.abc import Callable
from functools import partial

import numpy as np

import spragsym as ss
from benchmarks import rivals
from benchmarks.timing import best_in_turn, on_backend
from spragsym.kang_nam.quartic import compiled
from tests.oracles import c_target, languages
from tests.oracles.families import FAMILIES, random

_REPEATS = 7
_EIGVALS = "numpy.linalg.eigvals, batched, L-quartic, roots only"
_BUILDS = (("-O2", ("-O2",)), ("-O3 -march=native …", c_target.FAST))


def main(n: int = 1_000_000) -> None:
    """Print both tables."""
    speed(n)
    print()
    trust(max(n // 10, 1000))


def speed(n: int) -> None:
    """Nanoseconds a point, everything included from the parameters to states, stability and error
    bounds.
    """
    p = random(np.random.default_rng(1), n)
    rows, out = c_target.table(p), c_target.room(n)
    works: dict[str, Callable[[], object]] = {}
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for title, flags in _BUILDS:
            library = c_target.build(compiler, flags)
            for way, batch in (("one point a call", False), ("batch", True)):
                works[f"C, {way}, {compiler} {title}"] = partial(
                    c_target.solve, library, rows, out, batch=batch
                )
    if compiled.available():
        works["compiled, 1 thread"] = partial(on_backend, "compiled", 1, ss.equilibria, p)
    works["NumPy"] = partial(on_backend, "numpy", 1, ss.equilibria, p)
    works[_EIGVALS] = partial(rivals.eigvals, p)
    taken = best_in_turn(works, _REPEATS)
    fastest = min(taken.values())
    print(
        f"{n:,} random points in contact, one thread, best of {_REPEATS} in turn, from the "
        "parameters to states, stability and "
        "error bounds. C writes to arrays that are there, Python allocates its results. The "
        "flags of the fast builds: "
        f"`{' '.join(c_target.FAST)}`.\n"
    )
    print("| method | ns a point | times eigvals | time over the fastest |\n|---|---|---|---|")
    reference = taken[_EIGVALS]
    for title, seconds in taken.items():
        print(
            f"| {title} | {1e9 * seconds / n:,.0f} | {reference / seconds:.1f} | "
            f"{seconds / fastest:.2f} |"
        )


def trust(n: int) -> None:
    """What the batch vouches for in each family, against NumPy with its ladder."""
    library = c_target.build(c_target.compiler() or "cc", c_target.FAST)
    print(
        f"{n:,} points of each family against NumPy with its ladder: the share that is "
        "vouched for; among these wrong "
        "counts or kinds, the largest error over max(1, |value|), and the largest over both "
        "error bounds together.\n"
    )
    print(
        "| family | regime | vouched for | wrong | largest error | largest / bounds "
        "|\n|---|---|---|---|---|---|"
    )
    for place, (family, points) in enumerate(FAMILIES.items()):
        p = points(np.random.default_rng([6, place]), n)
        for contact in (True, False):
            out = c_target.room(n)
            c_target.solve(library, c_target.table(p), out, contact)
            it = languages.against_python(
                languages.Found(out.status, out.count, out.equilibria, np.nan), p, contact
            )
            cells = (
                f"{np.mean(out.status == 0):.3%} | {it.wrong} | {it.error:.1e} | {it.largest:.2f}"
            )
            print(f"| {family} | {'contact' if contact else 'lift-off'} | {cells} |", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
