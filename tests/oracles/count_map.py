"""Numbers of equilibria on a grid of angle and friction, held against those that crossing the fold
curves predicts.
"""

import numpy as np

import spragsym as ss

Array = np.ndarray


def count_map_mismatches(p: ss.Parameters, n: int, mu_max: float = 2.0) -> int:
    """Grid cells in which the count of equilibria and the fold curves disagree, but for the width
    of a cell.
    """
    return _compare(p, n, mu_max)[0]


def _compare(p: ss.Parameters, n: int, mu_max: float) -> tuple[int, float]:
    theta0 = (np.arange(n) + 0.5) / n * np.pi
    mu0 = (np.arange(n) + 0.5) / n * mu_max
    counts = ss.equilibria(p.replace(theta0=theta0[:, None], mu0=mu0[None, :])).count
    wrong = counts != predicted_counts(p, theta0, mu0)
    # Next to a change of count a mismatch is the width of the polyline; elsewhere a fold was missed
    # or invented.
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
    """Counts by crossing fold curves from θ₀ = 0 at each friction, starting from the count
    there.
    """
    curves = ss.bifurcation_set(p, n=6000).curves
    predicted = np.empty((theta0.size, mu0.size), dtype=int)
    start = ss.equilibria(p.replace(theta0=np.full(mu0.size, 1e-9), mu0=mu0)).count
    for column, friction in enumerate(mu0):
        crossings = np.sort(
            np.concatenate([_crossings(curve, friction) for curve in curves] or [np.empty(0)])
        )
        first = int(start[column])
        predicted[:, column] = np.where(
            np.searchsorted(crossings, theta0) % 2 == 0, first, 4 - first
        )
    return predicted


def _crossings(curve: ss.results.Curve, friction: float) -> Array:
    above = curve.mu0 > friction
    at = np.flatnonzero(above[1:] != above[:-1])
    low, high = curve.mu0[at], curve.mu0[at + 1]
    return curve.theta0[at] + (friction - low) / (high - low) * (
        curve.theta0[at + 1] - curve.theta0[at]
    )
