"""Equilibria, points per second against what one would use instead, one thread, one run; a Markdown table of ratios.

``python -m benchmarks.bench_equilibria [N]``: N random points, 1 000 000 by default; slow methods take a sample and are scaled.
"""

from __future__ import annotations

import os
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import time
from collections.abc import Callable
from functools import partial

import mpmath
import numpy as np
import scipy.optimize

import spragsym as ss
from benchmarks import c_target
from benchmarks.families import random
from spragsym import compiled
from spragsym.generated.equilibrium import contact_quartic, f_coefficients, residuals, t_quartic
from spragsym.parameters import NAMES
from spragsym.statics import kernel
from spragsym.statics.solver import BLOCK


def main(n: int = 1_000_000) -> None:
    """Print the table."""
    p = random(np.random.default_rng(1), n)
    first = _head(p, 20_000)
    rows: list[tuple[str, float]] = []
    methods: list[tuple[str, Callable[[ss.Parameters], object], ss.Parameters]] = [
        ("numpy.roots in a loop, L-quartic", roots_loop, _head(p, 5_000)),
        ("batched numpy.linalg.eigvals, L-quartic", eigvals, _head(p, 200_000)),
        ("scipy.optimize.root, 8 starts", fsolve_starts, _head(p, 40)),
        ("mpmath.polyroots, 50 digits", polyroots, _head(p, 40)),
        ("ours, NumPy: roots and counts", roots_and_counts, p),
        ("ours, NumPy: states, stability, error bounds", partial(_with_backend, "numpy", 1), p),
        ("ours, numba: roots and counts", compiled_roots_and_counts, p),
        ("ours, numba, 1 thread: states, stability, error bounds", partial(_with_backend, "numba", 1), p),
        ("ours, numba, 2 threads: states, stability, error bounds", partial(_with_backend, "numba", 2), p),
    ]
    if compiler := c_target.compiler():
        in_c = partial(c_target.batch, c_target.build(compiler, c_target.FAST), c_target.room(n))
        methods.append((f"ours, C, {compiler}: states, stability, error bounds", in_c, p))
    for _, method, _ in methods[4:]:
        method(first)  # compile, or load what was compiled before
    for name, method, points in methods:
        rows.append((name, _seconds_a_point(method, points)))
    reference_time = dict(rows)["batched numpy.linalg.eigvals, L-quartic"]
    loop_time = dict(rows)["numpy.roots in a loop, L-quartic"]
    print(f"{n:,} random points, one thread unless said otherwise, best of three, slow methods on a sample.\n")
    print("| method | ns a point | times eigvals | times numpy.roots |")
    print("|---|---|---|---|")
    for name, seconds in rows:
        print(f"| {name} | {1e9 * seconds:,.0f} | {reference_time / seconds:.2f} | {loop_time / seconds:.1f} |")


def _with_backend(name: str, threads: int, p: ss.Parameters) -> ss.Equilibria:
    ss.set_backend(name, threads)
    try:
        return ss.equilibria(p)
    finally:
        ss.set_backend("auto")


def compiled_roots_and_counts(p: ss.Parameters) -> object:
    """The compiled counterpart of :func:`roots_and_counts`."""
    return compiled.roots_and_counts(p.broadcast(*NAMES))


def _head(p: ss.Parameters, n: int) -> ss.Parameters:
    return ss.Parameters(*(value[:n] for value in p.broadcast(*NAMES)))


def _seconds_a_point(method: Callable[[ss.Parameters], object], p: ss.Parameters) -> float:
    """The best of three, which other load on the machine disturbs least; long ones once."""
    best = np.inf
    for _ in range(3):
        begin = time.perf_counter()
        method(p)
        best = min(best, time.perf_counter() - begin)
        if best > 5:
            break
    return float(best / p.shape[0])


# ----------------------------------------------------------------------------------------------- alternatives


def _coefficients(p: ss.Parameters) -> np.ndarray:
    theta0, mu0, kappa, alpha, sigma, beta = p.broadcast(*NAMES)
    return np.stack(contact_quartic(np.cos(theta0), np.sin(theta0), mu0, kappa, alpha, sigma, beta), axis=-1)


def roots_loop(p: ss.Parameters) -> list[int]:
    """numpy.roots of the published quartic, and how many roots are real and positive."""
    return [int(np.sum((abs(r.imag) < 1e-9) & (r.real > 0))) for r in (np.roots(row[::-1]) for row in _coefficients(p))]


def eigvals(p: ss.Parameters) -> np.ndarray:
    """Eigenvalues of companion matrices of the published quartic, and how many are real and positive."""
    coefficients = _coefficients(p)
    companion = np.zeros((coefficients.shape[0], 4, 4))
    companion[:, [1, 2, 3], [0, 1, 2]] = 1.0
    companion[:, :, 3] = -coefficients[:, :4] / coefficients[:, 4:]
    roots = np.linalg.eigvals(companion)
    return np.count_nonzero((abs(roots.imag) < 1e-9) & (roots.real > 0), axis=-1)


def fsolve_starts(p: ss.Parameters) -> list[int]:
    """scipy.optimize.root on F_x, F_y from eight directions, and how many different roots it finds."""
    counts = []
    for theta0, *values in zip(*p.broadcast(*NAMES), strict=True):
        c0, s0 = np.cos(theta0), np.sin(theta0)
        found: list[np.ndarray] = []

        def balance(z: np.ndarray, c0: float = c0, s0: float = s0, values: list[float] = values) -> tuple[float, float]:
            return residuals(np.cos(z[0]), np.sin(z[0]), z[1], c0, s0, *values, 1)  # type: ignore[return-value]

        for start in np.linspace(0.2, 2.9, 8):
            outcome = scipy.optimize.root(balance, (start, 1.0))
            if outcome.success and all(np.abs(outcome.x - other).max() > 1e-6 for other in found):
                found.append(outcome.x)
        counts.append(len(found))
    return counts


def polyroots(p: ss.Parameters) -> list[int]:
    """mpmath.polyroots of the quartic in t at 50 digits."""
    counts = []
    with mpmath.workdps(50):
        for theta0, *values in zip(*p.broadcast(*NAMES), strict=True):
            angle = mpmath.mpf(float(theta0))
            numbers = [mpmath.mpf(float(value)) for value in values]
            quartic = t_quartic(*f_coefficients(mpmath.cos(angle), mpmath.sin(angle), *numbers, 1))
            roots = mpmath.polyroots(quartic[::-1], maxsteps=200, extraprec=200)
            counts.append(sum(abs(mpmath.im(r)) < 1e-20 and mpmath.re(r) > 0 for r in roots))
    return counts


def roots_and_counts(p: ss.Parameters) -> np.ndarray:
    """All four roots in t as two factors and their number, with the bound that says where it is certain; no states."""
    columns = p.broadcast(*NAMES)
    n = columns[0].size
    count = np.empty(n, dtype=np.int8)
    roots = np.empty((4, n))
    u = 2.0**-53
    with np.errstate(all="ignore"):
        np.empty(1 << 19)  # see spragsym.statics.solver: keeps glibc from returning the blocks' memory each time
        for begin in range(0, n, BLOCK):
            rows = slice(begin, begin + BLOCK)
            theta0, *values = (column[rows] for column in columns)
            trig = np.cos(theta0), np.sin(theta0), *values, 1
            abdm = kernel.f_coefficients(*trig)
            D, bound = kernel.discriminant(*abdm, *kernel.f_magnitudes(*trig), u)
            p1, q1, p2, q2 = kernel.factors(*abdm)
            roots[0, rows], roots[1, rows], _ = kernel.root_pair(p1, q1)
            roots[2, rows], roots[3, rows], _ = kernel.root_pair(p2, q2)
            count[rows] = np.where(np.abs(D) <= bound, -1, np.where(D < 0, 4, 2))
    return count


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:2]))
