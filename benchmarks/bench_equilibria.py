"""Equilibria: time a point against what one would use instead, and of the first call of a process;
Markdown tables.

``python -m benchmarks.bench_equilibria [N]``: N random points, 1 000 000 by default; slow methods
take a sample and are scaled.
"""

import os
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

import spragsym as ss
from benchmarks import rivals
from benchmarks.timing import best_in_turn, in_process, on_backend, timed
from spragsym.generated import kernel
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.quartic import compiled
from spragsym.kang_nam.quartic.solver import BLOCK
from tests.oracles import c_target
from tests.oracles.families import random

_EIGVALS = "batched numpy.linalg.eigvals, L-quartic"
_LOOP = "numpy.roots in a loop, L-quartic"
_FULL = "states, stability, error bounds"
#: Backends and threads, as the tables have them.
_WAYS = (("numpy", 1), ("compiled", 1), ("compiled", 2))


class Method(NamedTuple):
    """What is timed, and on how many of the points."""

    work: Callable[[ss.Parameters], object]
    points: int


def main(n: int = 1_000_000) -> None:
    """Print both tables."""
    speed(n)
    print()
    first_calls(n)


def speed(n: int) -> None:
    """Nanoseconds a point, every method in the same run."""
    p = random(np.random.default_rng(1), n)
    methods = dict(_rivals(n)) | dict(_ours(n))
    works = {
        name: partial(method.work, _head(p, method.points)) for name, method in methods.items()
    }
    once = {name: work for name, work in works.items() if methods[name].points < 100}
    taken = {name: timed(work)[0] for name, work in once.items()}
    taken |= best_in_turn(
        {name: work for name, work in works.items() if name not in once}, repeats=3
    )
    each = {name: taken[name] / methods[name].points for name in methods}
    print(
        f"{n:,} random points in contact, one thread unless said otherwise, best of three in "
        "turn, slow methods on a sample.\n"
    )
    print("| method | ns a point | times eigvals | times numpy.roots |")
    print("|---|---|---|---|")
    for name, time in each.items():
        print(
            f"| {name} | {1e9 * time:,.0f} | {each[_EIGVALS] / time:.2f} | "
            f"{each[_LOOP] / time:.1f} |"
        )


def _rivals(n: int) -> Iterator[tuple[str, Method]]:
    yield _LOOP, Method(rivals.roots_loop, min(n, 5_000))
    yield _EIGVALS, Method(rivals.eigvals, min(n, 200_000))
    yield "scipy.optimize.root, 8 starts", Method(rivals.fsolve_starts, min(n, 40))
    yield "mpmath.polyroots, 50 digits", Method(rivals.polyroots, min(n, 40))


def _ours(n: int) -> Iterator[tuple[str, Method]]:
    yield "ours, NumPy: roots and counts", Method(roots_and_counts, n)
    for backend, threads in _WAYS:
        if backend == "compiled" and not compiled.available():
            continue
        title = {"numpy": "NumPy"}.get(backend, f"compiled, {threads} thread{'s' * (threads > 1)}")
        if threads == 1:
            yield (
                f"ours, {title}: `ss.count`",
                Method(partial(on_backend, backend, threads, ss.count), n),
            )
        yield (
            f"ours, {title}: {_FULL}",
            Method(partial(on_backend, backend, threads, ss.equilibria), n),
        )
    if compiler := c_target.compiler():
        library, room = c_target.build(compiler, c_target.FAST), c_target.room(n)
        for title, batch in (("batch", True), ("one point a call", False)):
            yield (
                f"ours, C, {compiler}, {title}: {_FULL}",
                Method(partial(c_target.in_contact, library, room, batch=batch), n),
            )


def _head(p: ss.Parameters, n: int) -> ss.Parameters:
    return ss.Parameters(*(value[:n] for value in p.broadcast(*PARAMETERS)))


def roots_and_counts(p: ss.Parameters) -> np.ndarray:
    """All four roots in t as two factors and their number, with the bound that says where it is
    certain; no states, in NumPy.
    """
    theta0, *values = p.broadcast(*PARAMETERS)
    count = np.empty(theta0.size, dtype=np.int8)
    roots = np.empty((4, theta0.size))
    u = np.float64(2.0**-53)
    np.empty(
        1 << 21
    )  # see spragsym.kang_nam.quartic.solver: glibc then keeps the memory of the blocks
    with np.errstate(all="ignore"):
        for begin in range(0, theta0.size, BLOCK):
            rows = slice(begin, begin + BLOCK)
            point = kernel.Point(
                *kernel.cosine_and_sine(theta0[rows]), *(column[rows] for column in values), nbar=1
            )
            line = kernel.balance(point)
            quartic, cubic = (
                part(line.a, line.b, line.d, line.m) for part in (kernel.quartic, kernel.cubic)
            )
            D, halves = kernel.discriminant(line, cubic, u), kernel.factors(quartic, cubic)
            roots[0, rows], roots[1, rows], _ = kernel.root_pair(halves.p1, halves.q1)
            roots[2, rows], roots[3, rows], _ = kernel.root_pair(halves.p2, halves.q2)
            count[rows] = np.where(np.abs(D.value) <= D.error, -1, np.where(D.value < 0, 4, 2))
    return count


# ------------------------------------------------------------------------------------------------
# first calls

_FIRST = """
import time, numpy as np, spragsym as ss
from tests.oracles.families import random
p = random(np.random.default_rng(1), {n})
ss.kang_nam.set_backend({backend!r}, {threads})
for _ in range(2):
    begin = time.perf_counter()
    eq = ss.equilibria(p)
    solved = time.perf_counter()
    {touch}
    print(solved - begin, time.perf_counter() - begin)
    del eq
"""
_TOUCH = {"x": "eq.x", "all": "eq.theta, eq.L, eq.x, eq.y, eq.error, eq.undamped"}


def first_calls(n: int) -> None:
    """The first and the second call of a process, which meet memory that was never touched, and
    that was.
    """
    print(
        f"{n:,} points in a process of its own, ns a point: the call alone, with `eq.x`, with "
        "all columns; medians of three.\n"
    )
    print("| backend | threads | call | alone | with `eq.x` | with all columns |")
    print("|---|---|---|---|---|---|")
    for backend, threads in _WAYS:
        if backend == "compiled" and not compiled.available():
            print("| compiled: not built | | | | | |")
            break
        touched = {
            name: _median(_FIRST.format(n=n, backend=backend, threads=threads, touch=code))
            for name, code in _TOUCH.items()
        }
        for call, title in enumerate(("first", "second")):
            cells = (touched["x"][call, 0], touched["x"][call, 1], touched["all"][call, 1])
            print(
                f"| {backend} | {threads} | {title} |"
                + "".join(f" {1e9 * cell / n:,.0f} |" for cell in cells),
                flush=True,
            )


def _median(code: str, repeats: int = 3) -> np.ndarray:
    """Medians of the seconds that a new process prints, (calls, columns)."""
    return np.median([np.loadtxt(in_process(code).splitlines()) for _ in range(repeats)], axis=0)


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
