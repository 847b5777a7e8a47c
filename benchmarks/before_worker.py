"""The process of :mod:`benchmarks.bench_before` for one tree: ``python before_worker.py TREE POINTS [NAME ...]`` reads lines, answers with
lines, whose words are parted by tabs.

First it names what the tree can be asked, of all or of what begins with one of the names: the equilibria of all points by each solver,
and :mod:`benchmarks.before_questions`. ``time QUESTION`` answers with seconds; ``save SOLVER FILE`` writes the results; ``rungs SOLVER``
answers with the shares that float64, the wider type and intervals settle. It needs nothing of :mod:`benchmarks`, which the other tree
may have in another form, but the questions and the C target's caller beside it.
"""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

#: Results that are compared as numbers.
COLUMNS = ("theta", "L", "x", "y")
#: Seconds in which a short call is repeated; the shortest counts.
SPENT = 0.2


def _of_this_tree(path: str) -> Any:
    """A module beside this one or below it, whichever :mod:`benchmarks` the other tree has."""
    file = Path(__file__).parent / path
    name = file.stem
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _in_python(ss: Any, p: Any, names: tuple[str, ...], threads: int) -> Callable[[], Any] | None:
    """A call of ``equilibria`` with the first of the backends that is there."""
    for name in names:
        try:
            ss.set_backend(name, threads)
            ss.equilibria(ss.Parameters.article(theta0=np.linspace(0.1, 3.0, 30_000)))
        except Exception:  # older trees raise different errors for an unknown or missing backend
            continue

        def solve(name: str = name) -> Any:
            ss.set_backend(name, threads)
            return ss.equilibria(p)

        return solve
    return None


def _in_c(tree: Path, p: Any, n: int) -> dict[str, Callable[[], Any]]:
    """Calls of the C target of the tree."""
    c_target = _of_this_tree("../tests/oracles/c_target.py")
    compiler = c_target.compiler()
    if compiler is None:
        return {}
    library, out, rows = c_target.build(compiler, c_target.FAST, tree / "generated/c"), c_target.room(n), c_target.table(p)
    return {
        "equilibria, C, batch": lambda: c_target.solve(library, rows, out, batch=True),
        "equilibria, C, one point a call": lambda: c_target.solve(library, rows, out, batch=False),
    }


def _shares(solve: Callable[[], Any], size: int) -> str:
    """Shares of the points that each rung settles, the ladder of intervals counted call by call."""
    ladder: Any = None
    for name in (
        "kang_nam.statics.adaptive_precision",
        "statics.adaptive_precision",
        "statics.ladder",
        "ladder",
    ):  # today, and was called before
        with contextlib.suppress(ModuleNotFoundError):
            ladder = ladder or importlib.import_module(f"spragsym.{name}")
    kept, calls = ladder.equilibria, 0

    def counted(*point: float, **options: Any) -> Any:
        nonlocal calls
        calls += 1
        return kept(*point, **options)

    ladder.equilibria = counted
    try:
        left = int(solve().escalated.sum())
    finally:
        ladder.equilibria = kept
    return " ".join(f"{100 * part / size:.4g}" for part in (size - left, left - calls, calls))


def _shortest(work: Callable[[], Any]) -> float:
    """Seconds of a call; a short one is repeated."""
    best, end = float("inf"), time.perf_counter() + SPENT
    while True:
        begin = time.perf_counter()
        work()
        now = time.perf_counter()
        best = min(best, now - begin)
        if now >= end:
            return best


def _fresh(tree: Path, code: str) -> float:
    """Seconds that ``code`` takes in a new interpreter, without the interpreter's own start; a command ends its process itself."""
    clock = (
        "import atexit, os, sys, time\nbegin, out = time.perf_counter(), os.dup(1)\nos.dup2(2, 1)\n"
        "atexit.register(lambda: os.write(out, str(time.perf_counter() - begin).encode()))\n"
    )
    command = [sys.executable, "-c", clock + code]
    return float(subprocess.run(command, cwd=tree, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)


def _timed(
    tree: Path, points: Path, only: tuple[str, ...]
) -> tuple[dict[str, Callable[[], Any]], dict[str, Callable[[], float]]]:
    """What solves all points, and how long each question takes; of all, or of those that begin with a name."""
    import spragsym as ss

    assert Path(ss.__file__).resolve().is_relative_to(tree.resolve()), ss.__file__
    columns = np.load(points)
    p = ss.Parameters(*columns)

    def wanted(name: str) -> bool:
        return not only or name.startswith(only)

    compiled = ("compiled", "numba")
    works: dict[str, Callable[[], Any] | None] = {
        "equilibria, numpy": _in_python(ss, p, ("numpy",), 1),
        "equilibria, compiled": _in_python(ss, p, compiled, 1),
        "equilibria, compiled, 2 threads": _in_python(ss, p, compiled, 2),
    }
    if wanted("equilibria, C"):
        works |= _in_c(tree, p, columns.shape[1])
    solvers = {name: work for name, work in works.items() if work is not None and wanted(name)}
    times = {name: partial(_shortest, work) for name, work in solvers.items()}
    asked = _of_this_tree("before_questions.py")
    for name, work in asked.questions(ss, columns).items():
        if wanted(name):
            with contextlib.suppress(Exception):  # not there, or not so
                work()
                times[name] = partial(_shortest, work)
    for name, code in asked.STARTS.items():
        if wanted(name):
            with contextlib.suppress(subprocess.CalledProcessError):
                _fresh(tree, code)
                times[name] = partial(_fresh, tree, code)
    return solvers, times


def main(tree: Path, points: Path, only: tuple[str, ...] = ()) -> None:
    """Answer until the input ends."""
    solvers, times = _timed(tree, points, only)
    print("\t".join(times), flush=True)
    for line in sys.stdin:
        order, name, *rest = line.rstrip("\n").split("\t")
        if order == "time":
            answer: object = times[name]()
        elif order == "rungs":
            answer = _shares(solvers[name], np.load(points).shape[1])
        else:
            result = solvers[name]()
            np.savez(rest[0], **{column: np.asarray(getattr(result, column)) for column in ("count", "stability", *COLUMNS)})
            answer = "saved"
        print(answer, flush=True)


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main(Path(sys.argv[1]), Path(sys.argv[2]), tuple(sys.argv[3:]))
