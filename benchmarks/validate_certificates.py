"""Certificates of any model over random boxes: proved ones sampled, refuted ones followed, and both against closed forms.

Run ``python -m benchmarks.validate_certificates [number] [seed] [store] [seconds]``: boxes of the models in turn. Finished parts go to
the file ``store``, and a second call goes on from there. Of a box that is proved, points are followed one by one by a path with
proved folds, which shares no tube with the certificate; of the article's model 10,000 points are held against its closed forms.
At a counterexample the same path must end. Exits with 1 if anything contradicts.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from typing import Any

import numpy as np

import spragsym as ss
from benchmarks import parts
from spragsym.models.paths import first_end

MODELS = ("kang_nam", "two_springs", "inclined_belt", "cubic_contact", "damped")
#: Points that are followed in a box that is proved, and points for closed forms.
FOLLOWED, CLOSED = 4, 10_000
#: Parts of a box.
PARTS = 300


def box(model: Any, rng: np.random.Generator) -> tuple[Any, Any]:
    """Corners about random values: two to four parameters within some percent."""
    middle = {"theta0": rng.uniform(0.3, 1.4), "mu0": rng.uniform(0.05, 1.0)}
    middle |= {name: model.base[name] * 2 ** rng.uniform(-1, 1) for name in ("kappa", "sigma") if rng.random() < 0.6}
    size = {name: rng.choice([0.005, 0.02, 0.05]) for name in middle}
    low, high = (
        model.Parameters(**{name: value * (1 + side * size[name]) for name, value in middle.items()}) for side in (-1, 1)
    )
    return low, high


def ends(model: Any, p: Any) -> bool:
    """Whether the state that is followed from no friction ends before that of a point."""
    return first_end(model, p.replace(mu0=0.0), "mu0", (0.0, float(p.mu0))) is not None


def within(low: Any, high: Any, rng: np.random.Generator, number: int) -> dict[str, Any]:
    """Random points of a box by name, corners of it among them."""
    names = [name for name in low.model.parameters if float(getattr(low, name)) < float(getattr(high, name))]
    share = {name: np.where(rng.random(number) < 0.3, rng.integers(0, 2, number), rng.random(number)) for name in names}
    return {name: (1 - part) * float(getattr(low, name)) + part * float(getattr(high, name)) for name, part in share.items()}


def one(number: int, seed: int) -> dict[str, Any]:
    """One box: what is said of it, and what contradicts."""
    rng = np.random.default_rng([seed, number])
    name = MODELS[number % len(MODELS)]
    model = ss.load(name).search
    low, high = box(model, rng)
    begin = time.process_time()
    found = ss.certify(low, high, "no jump", method="search", max_boxes=PARTS)
    told = {
        "model": name,
        "outcome": found.outcome,
        "parts": found.boxes,
        "seconds": round(time.process_time() - begin, 2),
        "wrong": 0,
    }
    if found.outcome == "refuted":
        told["wrong"] = int(not ends(model, found.counterexample))
    if found.outcome == "proved":
        values = within(low, high, rng, FOLLOWED)
        told["wrong"] = sum(
            ends(model, low.replace(**{key: float(value[i]) for key, value in values.items()})) for i in range(FOLLOWED)
        )
    if name == "kang_nam" and found.outcome == "proved":
        values = within(low, high, rng, CLOSED)
        friction = values.pop("mu0")
        p = ss.Parameters.article(
            **{key: float(getattr(low, key)) for key in ("theta0", "kappa", "alpha", "sigma", "beta")} | values
        )
        told["wrong"] += int((np.asarray(ss.jump_value(p)) < friction).sum())
    return told


def main(number: str = "200", seed: str = "1", store: str = "", seconds: str = "inf") -> int:
    """The boxes; 1 if anything contradicts."""
    done = parts.run(map(str, range(int(number))), lambda part: one(int(part), int(seed)), store, float(seconds)).values()
    counts = Counter((told["model"], told["outcome"]) for told in done)
    for name in MODELS:
        print(name, {outcome: count for (model, outcome), count in sorted(counts.items()) if model == name})
    wrong = sum(told["wrong"] for told in done)
    spent = [told["seconds"] for told in done]
    print(
        f"{len(done)} boxes of {number}: {wrong} contradictions; {np.median(spent):.2g} s of processor time in the middle, {max(spent):.2g} at most"
    )
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
