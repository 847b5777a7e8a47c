"""Pages at random, from all of the vocabulary, against mechanics assembled from their energies in
numbers.

Of each page accelerations, states with their gaps, growth and onsets of flutter are compared; see
page_mechanics.py. Last found: an onset that hid behind a pair that is never damped (ef46ff1f), and
a coordinate called s (64079ff1).
"""

from typing import Any

import numpy as np

from validation import page_mechanics

CASES = 20


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One page; a page that is refused by its line is no contradiction."""
    found = page_mechanics.judged(int(rng.integers(1 << 30)), number)
    return {
        "kind": found["kind"],
        "wrong": [f"{text}" for text in found.get("wrong", ())],
        "coordinates": found["n"],
    }
