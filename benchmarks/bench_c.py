"""Nanoseconds a point of the C target beside batched ``numpy.linalg.eigvals``.

Run ``python benchmarks/bench_c.py [points]``; it prints a Markdown table.
"""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import Any

# One thread everywhere, set before NumPy loads its libraries: the C target has no threads.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_name] = "1"

import numpy as np  # noqa: E402

from spragsym.generated import equilibrium  # noqa: E402

_REPEATS = 5
_BUILDS = (("gcc -O2", ["-O2"]), ("gcc -O3 -march=native", ["-O3", "-march=native"]))
_DRIVER = """
#include <stddef.h>
#include "spragsym.h"
size_t batch(size_t points, const spragsym_parameters *given, size_t *uncertain);
size_t batch(size_t points, const spragsym_parameters *given, size_t *uncertain) {
    size_t total = 0;
    for (size_t i = 0; i < points; i++) {
        spragsym_model model;
        spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
        int count = 0;
        if (spragsym_prepare(&given[i], &model) == SPRAGSYM_OK) {
            *uncertain += spragsym_equilibria(&model, SPRAGSYM_CONTACT, found, &count) != SPRAGSYM_OK;
        }
        total += (size_t)count;
    }
    return total;
}
"""


def parameters(points: int) -> Any:
    """Random points around the article's values: theta0, mu0, kappa, alpha, sigma, beta."""
    rng = np.random.default_rng(6)
    return np.column_stack(
        [
            rng.uniform(0.0, np.pi, points),
            rng.uniform(0.0, 1.5, points),
            10 ** rng.uniform(-3, -1, points),
            10 ** rng.uniform(-3, 0, points),
            10 ** rng.uniform(-2, 0, points),
            rng.uniform(0.0, 0.5, points),
        ]
    )


def compile_batch(flags: list[str], folder: Path) -> Any:
    """The solver over an array, as a function of a shared object."""
    for name in ("spragsym.h", "spragsym.c"):
        (folder / name).write_bytes(resources.files("spragsym.generated").joinpath("c", name).read_bytes())
    (folder / "batch.c").write_text(_DRIVER)
    library = folder / f"batch{'_'.join(flags)}.so"
    command: list[str | Path] = ["gcc", "-std=c99", *flags, "-shared", "-fPIC", "-o", library]
    subprocess.run([*command, "batch.c", "spragsym.c", "-lm"], cwd=folder, check=True)
    function = ctypes.CDLL(str(library)).batch
    function.restype = ctypes.c_size_t
    return function


def companions(values: Any) -> Any:
    """Companion matrices of the quartic in t."""
    theta0, mu0, kappa, alpha, sigma, beta = values.T
    e0, e1, e2, e3, e4 = equilibrium.t_quartic(
        *equilibrium.f_coefficients(np.cos(theta0), np.sin(theta0), mu0, kappa, alpha, sigma, beta, 1.0)
    )
    matrices = np.zeros((len(values), 4, 4))
    matrices[:, 0, :] = np.column_stack([-e3 / e4, -e2 / e4, -e1 / e4, -e0 / e4])
    matrices[:, (1, 2, 3), (0, 1, 2)] = 1.0
    return matrices


def seconds(work: Callable[[], object]) -> float:
    """Best of a few."""
    best = float("inf")
    for _ in range(_REPEATS):
        begin = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - begin)
    return best


def main() -> None:
    """Print a Markdown table."""
    points = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    values = np.ascontiguousarray(parameters(points))
    address = values.ctypes.data_as(ctypes.c_void_p)
    rows = []
    counts = set()
    uncertain = 0
    with tempfile.TemporaryDirectory() as folder:
        for title, flags in _BUILDS:
            batch = compile_batch(flags, Path(folder))
            flagged = ctypes.c_size_t(0)
            counts.add(batch(ctypes.c_size_t(points), address, ctypes.byref(flagged)))
            uncertain = flagged.value
            taken = seconds(
                lambda batch=batch: batch(ctypes.c_size_t(points), address, ctypes.byref(ctypes.c_size_t(0)))  # type: ignore[misc]
            )
            rows.append((f"C, all equilibria, states, stability, bounds, {title}", taken))
    sample = values[: max(points // 10, 1)]
    matrices = companions(sample)
    roots_only = seconds(lambda: np.linalg.eigvals(matrices)) * points / len(sample)
    rows.append(("numpy.linalg.eigvals, batched, roots only", roots_only))
    assert len(counts) == 1, "the builds disagree"
    print(
        f"{points} random points, one thread, best of {_REPEATS}; "
        f"{counts.pop()} equilibria, {uncertain} points uncertain\n"
    )
    print("| method | ns a point | times faster than eigvals |\n|---|---:|---:|")
    for title, taken in rows:
        print(f"| {title} | {taken / points * 1e9:.0f} | {roots_only / taken:.1f} |")
    print(
        "\nThis is one point a call, as a control loop asks: every branch that a point can spare is spared, and no vector "
        "instruction helps. The compiled Python path solves whole blocks with them (first table)."
    )


if __name__ == "__main__":
    main()
