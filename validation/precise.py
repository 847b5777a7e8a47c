"""Bounds of ``spragsym.precise`` against Newton's method on the forces with many more digits.

``python -m validation.precise [N]``: N points, 500 by default, from all families of hard points, each at 20 precisions. The
caller's ``mpmath.mp.dps`` changes from call to call, which must not matter.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

import mpmath
import numpy as np

from spragsym import precise
from spragsym.parameters import NAMES
from spragsym.results.precise_states import PreciseEquilibrium
from tests.oracles.families import FAMILIES
from tests.oracles.reference import refine

PRECISIONS = (1, 2, 3, 5, 8, 12, 15, 16, 17, 20, 25, 33, 50, 77, 100, 150, 250, 400, 650, 1000)
#: Precisions that a caller may have set.
CALLERS = (1, 15, 50, 400)
#: Digits of the reference beyond the bits that results carry, of which there are 64 more than were asked for.
MORE_DIGITS = 100


def points(number: int, seed: int = 0) -> Iterator[tuple[float, ...]]:
    """Points of every family in turn."""
    rng = np.random.default_rng(seed)
    each = -(-number // len(FAMILIES))
    columns = [np.stack(family(rng, each).broadcast(*NAMES), axis=-1) for family in FAMILIES.values()]
    rows = np.stack(columns, axis=1).reshape(-1, len(NAMES))[:number]
    return (tuple(map(float, row)) for row in rows)


def worst_shares(point: tuple[float, ...], precisions: Iterable[int], *, contact: bool = True) -> dict[int, float]:
    """For each precision the largest true error of any number of any state, over its bound; ``inf`` for a wrong count."""
    results, given = {}, dict(zip(NAMES, point, strict=True))
    for i, dps in enumerate(precisions):
        with mpmath.workdps(CALLERS[i % len(CALLERS)]):
            results[dps] = precise.equilibria(**given, contact=contact, dps=dps)
    digits = max(results) + MORE_DIGITS
    # Where to begin is all that the reference takes from the results.
    begin = precise.equilibria(**given, contact=contact, dps=60)
    truth = [refine(state.x, state.y, *point, contact, digits=digits) for state in begin]
    with mpmath.workdps(digits):
        return {dps: max((_share(*pair, dps) for pair in zip(found, truth, strict=True)), default=0.0) if len(found) == len(truth)
                else float("inf") for dps, found in results.items()}  # fmt: skip


def _share(state: PreciseEquilibrium, truth: tuple[mpmath.mpf, ...], dps: int) -> float:
    """The true error over the bound, or over what was asked for where the bound is larger."""
    bound = min(state.error, mpmath.mpf(10) ** -dps)
    values = (state.theta, state.L, state.x, state.y)
    gaps = [abs(value - exact) / max(1, abs(exact)) for value, exact in zip(values, truth, strict=True)]
    return float(max(gaps) / bound) if state.error <= mpmath.mpf(10) ** -dps else float("inf")


def main(number: int = 500) -> None:
    """Print the worst share of every precision."""
    worst = dict.fromkeys(PRECISIONS, 0.0)
    states = 0
    for point in points(number):
        shares = worst_shares(point, PRECISIONS)
        states += 1
        worst = {dps: max(worst[dps], share) for dps, share in shares.items()}
    print(f"{states} points at {len(PRECISIONS)} precisions; the largest error over its bound, at most 1:\n")
    print("| dps | error / bound |")
    print("|---|---|")
    for dps, share in worst.items():
        print(f"| {dps} | {share:.3f} |")
    if max(worst.values()) > 1:
        sys.exit("a bound does not hold")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
