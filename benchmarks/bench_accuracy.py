"""Accuracy beside speed: wrong counts and worst errors of what one would use instead, where it is hard; a Markdown table.

``python -m benchmarks.bench_accuracy [N]``: N points of each family. The truth is the interval ladder at 30 digits.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

import spragsym as ss
from benchmarks import c_target
from benchmarks.bench_equilibria import _with_backend
from benchmarks.families import FAMILIES
from spragsym.generated.equilibrium import contact_matrix, contact_quartic, contact_vector, f_coefficients, state, t_quartic
from spragsym.parameters import NAMES
from spragsym.statics import ladder

Array = NDArray[np.float64]
_HARD = ("random", "near folds", "cusp wedge", "false double root", "right angle", "light preload")


def main(n: int = 300) -> None:
    """Print the table."""
    methods: dict[str, Callable[[ss.Parameters], list[Array | None]]] = {
        "numpy.roots, L-quartic": lambda p: _from_L(p, batched=False),
        "eigvals, L-quartic": lambda p: _from_L(p, batched=True),
        "eigvals, t-quartic": _from_t,
        "ours, NumPy": lambda p: _ours(p, "numpy"),
        "ours, numba": lambda p: _ours(p, "numba"),
    }
    if compiler := c_target.compiler():
        methods["ours, C, where it vouches"] = partial(_in_c, c_target.build(compiler, c_target.FAST))
    print(f"{n} points of each family: wrong counts, and the largest error of (L, x, y) over max(1, |value|) where counts agree.\n")
    print("| family |" + "".join(f" {name} |" for name in methods))
    print("|---|" + "---|" * len(methods))
    for family in _HARD:
        p = FAMILIES[family](np.random.default_rng([31, list(FAMILIES).index(family)]), n)
        exact = _exact(p)
        cells = []
        for method in methods.values():
            found = method(p)
            pairs = [(one, other) for one, other in zip(found, exact, strict=True) if one is not None]
            wrong = sum(len(one) != len(other) for one, other in pairs)
            worst = max((_gap(one, other) for one, other in pairs if len(one) == len(other)), default=0.0)
            cells.append(f" {wrong}, {worst:.0e} |")
        print(f"| {family} |" + "".join(cells), flush=True)


def _gap(found: Array, exact: Array) -> float:
    order, other = np.argsort(found[:, 1]), np.argsort(exact[:, 1])  # by x: two states may share L and y
    return float((np.abs(found[order] - exact[other]) / np.maximum(1, np.abs(exact[other]))).max())


def _exact(p: ss.Parameters) -> list[Array]:
    rows = []
    for point in zip(*p.broadcast(*NAMES), strict=True):
        states = ladder.equilibria(*map(float, point), digits=30).states
        rows.append(np.array([[float(one.L), float(one.x), float(one.y)] for one in states]))
    return rows


def _ours(p: ss.Parameters, backend: str) -> list[Array | None]:
    eq = _with_backend(backend, 1, p)
    stacked = np.stack([eq.L, eq.x, eq.y], axis=-1)
    return [stacked[i, : eq.count[i]] for i in range(eq.count.size)]


def _in_c(library: ctypes.CDLL, p: ss.Parameters) -> list[Array | None]:
    solved = c_target.batch(library, c_target.room(p.shape[0]), p)
    stacked = np.stack([solved.equilibria[name] for name in ("L", "x", "y")], axis=-1)
    return [None if solved.status[i] else stacked[i, : solved.count[i]] for i in range(len(stacked))]


def _from_L(p: ss.Parameters, batched: bool) -> list[Array | None]:
    """Roots of the published quartic, states by solving (16), those with L > 0 and y < 0."""
    theta0, mu0, kappa, alpha, sigma, beta = p.broadcast(*NAMES)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    quartic = np.stack(contact_quartic(c0, s0, mu0, kappa, alpha, sigma, beta), axis=-1)
    roots = _eigvals(quartic) if batched else np.array([np.roots(row[::-1]) for row in quartic])
    rows = []
    with np.errstate(all="ignore"):
        for i, row in enumerate(roots):
            lengths = row.real[(np.abs(row.imag) < 1e-9 * np.abs(row)) & (row.real > 0)]
            found = []
            for L in lengths:
                D = np.array(contact_matrix(L, mu0[i], alpha[i], sigma[i], beta[i]))
                try:
                    c, s = np.linalg.solve(D, contact_vector(c0[i], s0[i], mu0[i], kappa[i], alpha[i], beta[i]))
                except np.linalg.LinAlgError:
                    continue
                if s0[i] - L * s < 0:
                    found.append([L, c0[i] - L * c, s0[i] - L * s])
            rows.append(np.array(found).reshape(-1, 3))
    return rows


def _from_t(p: ss.Parameters) -> list[Array | None]:
    """Roots of the quartic in tan(θ/2), states by the explicit formulas, those with L > 0 and y < 0."""
    theta0, mu0, kappa, alpha, sigma, beta = p.broadcast(*NAMES)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    quartic = np.stack(t_quartic(*f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)), axis=-1)
    rows = []
    for i, row in enumerate(_eigvals(quartic)):
        t = row.real[np.abs(row.imag) < 1e-9 * np.abs(row)]
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        L, x, y = state(c, s, c0[i], s0[i], kappa[i], sigma[i], beta[i], 1)
        good = (L > 0) & (y < 0)
        rows.append(np.stack([L, x, y], axis=-1)[good])
    return rows


def _eigvals(coefficients: Array) -> NDArray[np.complex128]:
    companion = np.zeros((coefficients.shape[0], 4, 4))
    companion[:, [1, 2, 3], [0, 1, 2]] = 1.0
    companion[:, :, 3] = -coefficients[:, :4] / coefficients[:, 4:]
    return np.linalg.eigvals(companion).astype(np.complex128)


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
