"""The fold set against a brute-force map of counts; a Markdown table.

``python -m validation.folds [SETS] [N]``: random parameter sets over several decades, each on an N × N grid of θ₀ and μ₀.
"""

from __future__ import annotations

import sys

import numpy as np

import spragsym as ss

Array = np.ndarray


def main(sets: int = 20, n: int = 2000, seed: int = 7) -> int:
    """Print the table; exit code 1 if a fold is missed or invented."""
    rng = np.random.default_rng(seed)
    print("| kappa | alpha | sigma | beta | fold curves | cells with 3 | mismatches |")
    print("|---|---|---|---|---|---|---|")
    bad = 0
    for number in range(sets):
        p = random_fixed(rng) if number else ss.Parameters.article()
        curves = ss.bifurcation_set(p).curves
        tallest = max((float(np.median(curve.mu0[curve.mu0 < 50])) for curve in curves if (curve.mu0 < 50).any()), default=1.0)
        mismatches, three = _compare(p, n, mu_max=2 * tallest)
        bad += mismatches > 0
        values = " | ".join(f"{float(getattr(p, name)):.4g}" for name in ("kappa", "alpha", "sigma", "beta"))
        print(f"| {values} | {len(curves)} | {three:.1%} | {mismatches} |", flush=True)
    return int(bad > 0)


def random_fixed(rng: np.random.Generator) -> ss.Parameters:
    """κ, α, σ, β over several decades, β = 0 in half of the cases."""
    return ss.Parameters(
        kappa=10 ** rng.uniform(-3, -0.5), alpha=10 ** rng.uniform(-3, 0), sigma=10 ** rng.uniform(-2, 0.5),
        beta=rng.choice([0.0, 10 ** rng.uniform(-2, 0.5)]),
    )  # fmt: skip


def count_map_mismatches(p: ss.Parameters, n: int, mu_max: float = 2.0) -> int:
    """Grid cells in which the count of equilibria and the fold curves disagree, but for the width of a cell."""
    return _compare(p, n, mu_max)[0]


def _compare(p: ss.Parameters, n: int, mu_max: float) -> tuple[int, float]:
    theta0 = (np.arange(n) + 0.5) / n * np.pi
    mu0 = (np.arange(n) + 0.5) / n * mu_max
    counts = ss.equilibria(p.replace(theta0=theta0[:, None], mu0=mu0[None, :])).count
    wrong = counts != predicted_counts(p, theta0, mu0)
    # Next to a change of count a mismatch is the width of the polyline; elsewhere a fold was missed or invented.
    edges = np.zeros_like(wrong)
    for axis in (0, 1):
        change = np.diff(counts, axis=axis) != 0
        first, second = [slice(None)] * 2, [slice(None)] * 2
        first[axis], second[axis] = slice(None, -1), slice(1, None)
        edges[tuple(first)] |= change
        edges[tuple(second)] |= change
    clear = int((wrong & ~edges).sum())
    too_many = int(wrong.sum()) if wrong.sum() > 0.2 * max(edges.sum(), 1) else 0
    return clear + too_many, float((counts == 3).mean())


def predicted_counts(p: ss.Parameters, theta0: Array, mu0: Array) -> Array:
    """Counts by crossing fold curves from θ₀ = 0 at each friction, starting from the count there."""
    curves = ss.bifurcation_set(p, n=6000).curves
    predicted = np.empty((theta0.size, mu0.size), dtype=int)
    start = ss.equilibria(p.replace(theta0=np.full(mu0.size, 1e-9), mu0=mu0)).count
    for column, friction in enumerate(mu0):
        crossings = np.sort(np.concatenate([_crossings(curve, friction) for curve in curves] or [np.empty(0)]))
        first = int(start[column])
        predicted[:, column] = np.where(np.searchsorted(crossings, theta0) % 2 == 0, first, 4 - first)
    return predicted


def _crossings(curve: ss.Curve, friction: float) -> Array:
    above = curve.mu0 > friction
    at = np.flatnonzero(above[1:] != above[:-1])
    low, high = curve.mu0[at], curve.mu0[at + 1]
    return curve.theta0[at] + (friction - low) / (high - low) * (curve.theta0[at + 1] - curve.theta0[at])


if __name__ == "__main__":
    sys.exit(main(*(int(argument) for argument in sys.argv[1:3])))
