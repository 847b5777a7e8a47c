"""Equilibria of models with springs at random extreme parameters, in both regimes: what is undecided, and how long a point takes.

``python -m validation.extremes [SETS] [SEED] [MODEL|FOLDER …]``: SETS random sets of each model, one call a set. A parameter
without ends is 10 to a power between −12 and 12, or now and then exactly 0 where it may be; an angle is any of its range, or a
multiple of 45°.
"""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.errors import ParameterError

#: Shipped models with springs between points.
MODELS = ("kang_nam", "damped", "stribeck", "cubic_contact", "hertz_contact", "two_springs", "inclined_belt", "trolley")
#: Share of values that are exactly 0, where they may be; of angles that are multiples of 45°.
SPECIAL = 0.1
#: Seconds beyond which a point counts as slow.
SLOW = 2.0


def drawn(model: Any, rng: np.random.Generator, decades: float) -> dict[str, float]:
    """A random set of parameters."""
    out = {}
    for entry in model.about["parameters"]:
        low, high = entry["low"], entry["high"]
        special = rng.random() < SPECIAL
        if low is not None and high is not None:
            value = low + (high - low) * rng.random()
            if entry["name"] in model.about["angles"] and special:
                value = float(np.clip(np.pi / 4 * rng.integers(1, 4), low + 1e-9, high - 1e-9))
        elif special and not entry["low_open"]:
            value = 0.0
        else:
            value = 10.0 ** rng.uniform(-decades, decades)
        out[entry["name"]] = value
    return out


def attacked(name: str, sets: int, seed: int, decades: float) -> None:
    """One line of results, and one line for each point with something to be said."""
    model = ss.load(name).search
    rng = np.random.default_rng(seed)
    worst, spent, open_, slow, far, silent, calls = 0.0, 0.0, 0, 0, 0, 0, 0
    for _ in range(sets):
        changes = drawn(model, rng, decades)
        p = model.Parameters(**changes)
        for contact in (True, False):
            begin = time.process_time()
            try:
                eq = ss.equilibria(p, contact=contact)
            except ParameterError:
                continue  # a contact that never opens
            seconds = time.process_time() - begin
            calls, spent, slow = calls + 1, spent + seconds, slow + (seconds > SLOW)
            error = float(np.nanmax(eq.error, initial=0.0))
            worst, open_, far = max(worst, error), open_ + (not eq.complete), far + (not eq.whole.all())
            unsaid = not eq.complete and not getattr(eq, "remarks", ())
            silent += unsaid
            if not eq.complete or seconds > SLOW or error > 1e-12:
                print(
                    f"  contact={contact} {len(eq.undecided)} undecided, error {error:.1e}, {seconds:.1f} s: {changes}",
                    flush=True,
                )
    print(
        f"{name:24}{calls:6} calls, {open_} undecided ({silent} without a remark), {far} in no proved region, {slow} beyond {SLOW:g} s, "
        f"{1e3 * spent / max(1, calls):.0f} ms each, largest error {worst:.1e}",
        flush=True,
    )


def main() -> None:
    """All models, or those named."""
    sets, seed = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((1, 300), (2, 1)))
    for name in sys.argv[3:] or MODELS:
        for decades in (2.0, 12.0):
            attacked(name, sets, seed, decades)


if __name__ == "__main__":
    main()
