"""Counts and digits of the solver over the adversarial families, against the independent reference; a Markdown table.

``python -m validation.equilibria [N]``: N points in all, 1 000 000 by default. Every count is checked; every digit of a
subsample, contact and lift-off.
"""

from __future__ import annotations

import sys
import time

import numpy as np

import spragsym as ss
from spragsym.parameters import NAMES
from tests.oracles import reference
from tests.oracles.families import FAMILIES


def main(total: int = 1_000_000, digits_checked: int = 300, seed: int = 20200416) -> int:
    """Print the table; the number of violations is the exit code's."""
    each = total // len(FAMILIES)
    print("| family | points | wrong counts | folds | escalated | largest error found | largest found / bound | s |")
    print("|---|---|---|---|---|---|---|---|")
    bad = 0
    for number, (name, family) in enumerate(FAMILIES.items()):
        rng = np.random.default_rng([seed, number])
        p = family(rng, each)
        begin = time.perf_counter()
        eq = ss.equilibria(p)
        seconds = time.perf_counter() - begin
        wrong = wrong_counts(p, eq)
        worst, ratio = worst_errors(p, eq, rng, digits_checked)
        lifted = ss.equilibria(p, contact=False)
        worst_lifted, ratio_lifted = worst_errors(p, lifted, rng, digits_checked)
        worst, ratio = max(worst, worst_lifted), max(ratio, ratio_lifted)
        bad += wrong + int(worst > 1e-12) + int(ratio > 1)
        print(
            f"| {name} | {each} | {wrong} | {int(eq.fold.sum())} | {eq.escalated.mean():.2%} | {worst:.1e} | {ratio:.2f} "
            f"| {seconds:.1f} |",
            flush=True,
        )
    print(f"\n{bad} violations")
    return 1 if bad else 0


def wrong_counts(p: ss.Parameters, eq: ss.Equilibria) -> int:
    """Points whose number of equilibria in contact is not the reference's."""
    columns = p.broadcast(*NAMES)
    return sum(
        reference.count_contact(*map(float, point)) != count
        for point, count in zip(zip(*columns, strict=True), eq.count.tolist(), strict=True)
    )


def worst_errors(p: ss.Parameters, eq: ss.Equilibria, rng: np.random.Generator, checked: int) -> tuple[float, float]:
    """Largest |error| / max(1, |value|) of a subsample, and the largest share of the bound that one reaches."""
    columns = p.broadcast(*NAMES)
    worst = ratio = 0.0
    for row in rng.choice(eq.count.size, min(checked, eq.count.size), replace=False):
        point = [float(column[row]) for column in columns]
        for slot in range(int(eq.count[row])):
            exact = reference.refine(float(eq.x[row, slot]), float(eq.y[row, slot]), *point, contact=eq.contact)
            found = (eq.theta[row, slot], eq.L[row, slot], eq.x[row, slot], eq.y[row, slot])
            error = max(float(abs(value - float(got)) / max(1, abs(value))) for value, got in zip(exact, found, strict=True))
            worst, ratio = max(worst, error), max(ratio, error / float(eq.error[row, slot]))
    return worst, ratio


if __name__ == "__main__":
    sys.exit(main(*(int(argument) for argument in sys.argv[1:2])))
