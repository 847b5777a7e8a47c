"""Accuracy beside speed: wrong counts and worst errors of what one would use instead, where it is
hard; a Markdown table.

``python -m benchmarks.bench_accuracy [N]``: N points of each family. The truth is the interval
ladder at 30 digits.
"""

import ctypes
import sys
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

import spragsym as ss
from benchmarks import rivals
from benchmarks.timing import on_backend
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.quartic import adaptive_precision, compiled
from tests.oracles import c_target
from tests.oracles.families import FAMILIES

Array = NDArray[np.float64]
_HARD = ("random", "near folds", "cusp wedge", "false double root", "right angle", "light preload")


def main(n: int = 300) -> None:
    """Print the table."""
    methods: dict[str, Callable[[ss.Parameters], list[Array | None]]] = {
        "numpy.roots, L-quartic": lambda p: [*rivals.states_from_roots(p)],
        "eigvals, L-quartic": lambda p: [*rivals.states_from_lengths(p)],
        "eigvals, t-quartic": lambda p: [*rivals.states_from_half_angles(p)],
        "ours, NumPy": partial(_ours, "numpy"),
    }
    if compiled.available():
        methods["ours, compiled"] = partial(_ours, "compiled")
    if compiler := c_target.compiler():
        methods["ours, C, where it vouches"] = partial(
            _in_c, c_target.build(compiler, c_target.FAST)
        )
    print(
        f"{n} points of each family: wrong counts, and the largest error of (L, x, y) over "
        "max(1, |value|) where counts agree.\n"
    )
    print("| family |" + "".join(f" {name} |" for name in methods))
    print("|---|" + "---|" * len(methods))
    for family in _HARD:
        p = FAMILIES[family](np.random.default_rng([31, list(FAMILIES).index(family)]), n)
        exact = _exact(p)
        cells = []
        for method in methods.values():
            found = method(p)
            pairs = [
                (one, other) for one, other in zip(found, exact, strict=True) if one is not None
            ]
            wrong = sum(len(one) != len(other) for one, other in pairs)
            worst = max(
                (_gap(one, other) for one, other in pairs if len(one) == len(other)), default=0.0
            )
            cells.append(f" {wrong}, {worst:.0e} |")
        print(f"| {family} |" + "".join(cells), flush=True)


def _gap(found: Array, exact: Array) -> float:
    order, other = (
        np.argsort(found[:, 1]),
        np.argsort(exact[:, 1]),
    )  # by x: two states may share L and y
    return float((np.abs(found[order] - exact[other]) / np.maximum(1, np.abs(exact[other]))).max())


def _exact(p: ss.Parameters) -> list[Array]:
    rows = []
    for point in zip(*p.broadcast(*PARAMETERS), strict=True):
        states = adaptive_precision.equilibria(*map(float, point), digits=30).states
        rows.append(np.array([[float(one.L), float(one.x), float(one.y)] for one in states]))
    return rows


def _ours(backend: str, p: ss.Parameters) -> list[Array | None]:
    eq = on_backend(backend, 1, ss.equilibria, p)
    stacked = np.stack([eq.L, eq.x, eq.y], axis=-1)
    return [stacked[i, : eq.count[i]] for i in range(eq.count.size)]


def _in_c(library: ctypes.CDLL, p: ss.Parameters) -> list[Array | None]:
    solved = c_target.in_contact(library, c_target.room(p.shape[0]), p)
    stacked = np.stack([solved.equilibria[name] for name in ("L", "x", "y")], axis=-1)
    return [
        None if solved.status[i] else stacked[i, : solved.count[i]] for i in range(len(stacked))
    ]


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
