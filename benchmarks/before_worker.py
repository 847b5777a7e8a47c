"""The process of :mod:`benchmarks.bench_before` for one tree: ``python before_worker.py TREE POINTS [SOLVERS]`` reads lines, answers with
lines.

First it names the solvers that the tree has. ``time SOLVER`` answers with seconds; ``save SOLVER FILE`` writes the results; ``rungs
SOLVER`` answers with the shares that float64, the wider type and intervals settle. It needs
nothing of :mod:`benchmarks`, which the other tree may have in another form, but the C target's caller beside it.
"""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

#: Results that are compared as numbers.
COLUMNS = ("theta", "L", "x", "y")


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
    spec = importlib.util.spec_from_file_location("c_target", Path(__file__).with_name("c_target.py"))
    assert spec is not None
    assert spec.loader is not None
    c_target = importlib.util.module_from_spec(spec)
    sys.modules["c_target"] = c_target
    spec.loader.exec_module(c_target)
    compiler = c_target.compiler()
    if compiler is None:
        return {}
    library, out, rows = c_target.build(compiler, c_target.FAST, tree / "generated/c"), c_target.room(n), c_target.table(p)
    return {
        "C_batch": lambda: c_target.solve(library, rows, out, batch=True),
        "C_one_point_a_call": lambda: c_target.solve(library, rows, out, batch=False),
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


def main(tree: Path, points: Path, only: tuple[str, ...] = ()) -> None:
    """Answer until the input ends; of all solvers, or of some by name."""
    import spragsym as ss

    assert Path(ss.__file__).resolve().is_relative_to(tree.resolve()), ss.__file__
    columns = np.load(points)
    p = ss.Parameters(*columns)
    compiled = ("compiled", "numba")
    works: dict[str, Callable[[], Any] | None] = {
        "numpy": _in_python(ss, p, ("numpy",), 1),
        "compiled": _in_python(ss, p, compiled, 1),
        "compiled_2_threads": _in_python(ss, p, compiled, 2),
    }
    if not only:
        works |= _in_c(tree, p, columns.shape[1])
    ready = {name: work for name, work in works.items() if work is not None and (not only or name in only)}
    print(",".join(ready), flush=True)
    for line in sys.stdin:
        order, way, *rest = line.split()
        if order == "rungs":
            print(_shares(ready[way], columns.shape[1]), flush=True)
            continue
        begin = time.perf_counter()
        result = ready[way]()
        seconds = time.perf_counter() - begin
        if order == "save":
            np.savez(rest[0], **{name: np.asarray(getattr(result, name)) for name in ("count", "stability", *COLUMNS)})
        print(seconds, flush=True)
        del result


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main(Path(sys.argv[1]), Path(sys.argv[2]), tuple(sys.argv[3].split(",")) if len(sys.argv) > 3 else ())
