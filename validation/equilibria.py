"""Counts, digits and bounds of equilibria over the adversarial families, against independent
references, to 1000 digits.

A case is 1000 points of a family, every count of which is checked, and the digits of forty; every
tenth case asks one point for twenty precisions. It guards the claims that no count is wrong and
that every bound holds.
"""

from typing import Any

import numpy as np

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles.families import FAMILIES
from tests.oracles.true_errors import worst_errors, worst_shares, wrong_counts

CASES = 1000
PRECISIONS = (1, 2, 3, 5, 8, 12, 15, 16, 17, 20, 25, 33, 50, 77, 100, 150, 250, 400, 650, 1000)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One batch of a family."""
    name = list(FAMILIES)[number % len(FAMILIES)]
    p = FAMILIES[name](rng, 1000)
    eq, lifted = ss.equilibria(p), ss.equilibria(p, contact=False)
    worst = [worst_errors(p, found, rng, 40) for found in (eq, lifted)]
    other = wrong_counts(p, eq)
    wrong = [f"{name}: {other} other counts"] * (other > 0)
    wrong += [
        f"{name}: an error of {error:.2g}, {share:.2g} of its bound"
        for error, share in worst
        if error > 1e-12 or share > 1
    ]
    if number % 10 == 0:
        shares = worst_shares(
            tuple(float(column[0]) for column in p.broadcast(*PARAMETERS)), PRECISIONS
        )
        wrong += [
            f"{name} to {dps} digits: {share:.2g} of its bound"
            for dps, share in shares.items()
            if share > 1
        ]
    return {
        "kind": name,
        "wrong": wrong,
        "points": eq.count.size,
        "error": max(error for error, _ in worst),
    }
