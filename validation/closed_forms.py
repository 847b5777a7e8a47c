"""The article's model by search against its closed forms: equilibria over the families, folds along
each parameter, cusps.

A case is 200 points of a family; every tenth case is a search for folds or cusps at random
parameters, μ₀ and α at 0 among them. It guards the claim that search and closed forms agree
wherever both decide.
"""

from typing import Any

import numpy as np

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles.families import FAMILIES

CASES = 500


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One family of points, or one search."""
    return changes(number // 10, rng) if number % 10 == 9 else states(number, rng)


def states(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Counts, and states where the counts are decided by both."""
    name = list(FAMILIES)[number % len(FAMILIES)]
    p = FAMILIES[name](rng, 200)
    known, eq = ss.equilibria(p), ss.equilibria(p, method="search")
    settled = eq.decided & known.decided & ~known.fold
    other = settled & (eq.count != known.count)
    same, slots = settled & ~other, min(eq.x.shape[-1], known.x.shape[-1])
    order, found = (np.argsort(one.x, axis=-1)[same][:, :slots] for one in (known, eq))
    error = 0.0
    for key in ("x", "y"):
        want, got = (
            np.take_along_axis(getattr(one, key)[same], at, axis=-1)
            for one, at in ((known, order), (eq, found))
        )
        error = max(
            error, float(np.nanmax(np.abs(got - want) / np.maximum(1, np.abs(want)), initial=0.0))
        )
    wrong = [f"{name}: {int(other.sum())} other counts"] * bool(other.any()) + [
        f"{name}: {error:.2g} off"
    ] * (error > 2e-12)
    return {
        "kind": name,
        "wrong": wrong,
        "points": 200,
        "undecided": int((~eq.decided).sum()),
        "error": error,
    }


def changes(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Folds along a parameter, or cusps, inside of the region that was searched."""
    vary = (*PARAMETERS, "cusps")[number % 7]
    p = ss.Parameters(
        rng.uniform(0.1, 3.0),
        rng.uniform(0.0, 1.5) * (rng.random() < 0.9),
        10.0 ** rng.uniform(-2.5, -0.5),
        10.0 ** rng.uniform(-2.5, -0.5) * (rng.random() < 0.9),
        10.0 ** rng.uniform(-1.5, 0.5),
        rng.choice([0.0, 0.3]),
    )
    found, known = (
        ss.cusps(p, method=method) if vary == "cusps" else ss.folds(p, vary, method=method)
        for method in ("search", "auto")
    )
    span = dict(zip(found.vary, found.region[2:], strict=True))
    inside = np.logical_and.reduce(
        [
            (getattr(known, key) > low) & (getattr(known, key) < high)
            for key, (low, high) in span.items()
        ]
    )
    first = "theta0" if vary == "cusps" else vary
    got, want = np.sort(getattr(found, first)), np.sort(getattr(known, first)[inside])
    told = {
        "kind": f"folds along {vary}" if vary != "cusps" else vary,
        "undecided": int(not found.complete),
        "points": len(got),
    }
    if not found.complete:
        return told | {"wrong": []}
    off = float(np.abs(got - want).max(initial=0.0)) if len(got) == len(want) else np.inf
    return told | {"wrong": [f"{p!r} along {vary}: {got} for {want}"] * (off > 1e-9)}
