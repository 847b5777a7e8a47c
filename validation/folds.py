"""Fold curves, paths between folds, and the critical friction of the article's model, at random
stiffnesses over several decades.

In turn: counts on a grid of θ₀ and μ₀ against those that crossing the fold curves predicts; a
quasi-static path along each parameter against a state that creeps down the force; the critical friction
of all angles against a scan, and to 50 digits; onsets of undamped flutter against a map of
stability. Last found: a path could not stop on the very float of a fold (13d1c672).
"""

from typing import Any

import numpy as np

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles import creeping_states, lowest_fold
from tests.oracles.count_map import count_map_mismatches
from tests.oracles.families import random_fixed, random_fluttering
from validation import flutter_map

CASES = 400


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One of the four questions."""
    kind = ("counts", "path", "critical friction", "flutter")[number % 4]
    if kind == "counts":
        p = random_fixed(rng)
        tall = [
            float(np.median(curve.mu0[curve.mu0 < 50]))
            for curve in ss.bifurcation_set(p).curves
            if (curve.mu0 < 50).any()
        ]
        bad = count_map_mismatches(p, 500, 2 * max(tall, default=1.0))
    elif kind == "path":
        p, vary, values = creeping_states.random_path(
            rng, PARAMETERS[number // 4 % len(PARAMETERS)]
        )
        bad = creeping_states.check(p, vary, values)[-1]
    elif kind == "critical friction":
        p = random_fixed(rng)
        found, told = lowest_fold.verdict(p)
        bad = int(told != "right")
        if found in ("cusp", "turn"):
            (_, right), known = lowest_fold.in_digits(p), ss.critical_friction(p)
            bad += bool(abs(right - known.mu0) > known.error * max(1, abs(right)))
    else:
        p = random_fluttering(rng)
        missed, extra, _ = flutter_map.compare(p, ss.flutter_onsets(p, damping=False))
        bad = missed + extra
    return {"kind": kind, "wrong": [f"{kind} of {p!r}: {bad} contradictions"] * bool(bad)}
