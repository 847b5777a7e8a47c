"""Equilibria to 30 digits against those of floats, of all shipped models at random parameters.

``python -m validation.digits [N]``: N sets (60 unless given) of each model, some with friction, stiffness or another
parameter 0 where that is allowed; each as it is, and with numbers by 1e-20 off, which no float is. Counts, types and coordinates must
agree; exit code 1 if anything differs.
"""

from __future__ import annotations

import sys
from collections import Counter
from fractions import Fraction
from typing import Any

import numpy as np

import spragsym as ss
from spragsym import precise
from spragsym.models.load import shipped

#: How far coordinates of floats may be off, and a change of parameters that no float tells.
TOLERANCE, BESIDE = 1e-10, Fraction(1, 10**20)
#: Share of parameters that are 0 where they may be.
ZEROS = 0.15
#: What is said of points of which only the states of floats are proved.
UNDECIDED = "undecided"


def random_set(model: ss.Model, rng: np.random.Generator) -> Any:
    """Angles anywhere in their range, others within a factor of five of their base values."""
    values = {}
    for entry in model.about["parameters"]:
        name, allowed = entry["name"], model.Parameters.ranges[entry["name"]]
        if name in model.about["angles"]:
            values[name] = allowed.low + (allowed.high - allowed.low) * rng.uniform(0.02, 0.98)
            continue
        value = (entry["base"] or 0.3) * 5 ** rng.uniform(-1, 1)
        values[name] = 0.0 if allowed.contains(0.0) and rng.random() < ZEROS else min(value, 0.95 * allowed.high)
    return model.Parameters(**values)


def difference(p: Any, contact: bool, beside: Fraction) -> str:
    """What differs between states of floats and those of many digits; empty where nothing does."""
    floats = ss.equilibria(p, contact)
    given = {name: Fraction(float(getattr(p, name))) for name in p.model.parameters}
    exact: dict[str, Any] = {name: value + beside for name, value in given.items() if value}
    try:
        states = precise.equilibria(p, contact=contact, dps=30, **exact)
    except ss.ConvergenceError as error:
        return "" if not floats.complete else f"{UNDECIDED}: {error}"
    if len(states) != int(floats.count) or states.complete != floats.complete:
        return f"{len(states)} states for {int(floats.count)}"
    first = p.model.coordinates[0]
    slots = np.argsort(getattr(floats, first)[: len(states)])
    for state, slot in zip(sorted(states, key=lambda one: one.numbers[first]), slots.tolist(), strict=True):
        if state.stability != floats.stability[slot]:
            return f"{state.stability.name} for {ss.Stability(int(floats.stability[slot])).name}"
        for name in p.model.coordinates:
            if abs(float(getattr(floats, name)[slot]) - float(state.numbers[name])) > TOLERANCE:
                return f"{name} = {state.numbers[name]}"
    return ""


def main() -> None:
    """Print what differs, and the counts."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    rng, counts = np.random.default_rng(3), Counter[str]()
    for name in shipped():
        model = ss.load(name)
        for _ in range(number):
            p = random_set(model, rng)
            for contact in model.regimes:
                for beside in (Fraction(0), BESIDE):
                    wrong = difference(p, contact, beside)
                    counts["undecided" if wrong.startswith(UNDECIDED) else "differ" if wrong else "agree"] += 1
                    if wrong:
                        print(f"{p!r}, contact={contact}, {beside} beside: {wrong}", flush=True)
    print(f"{counts['agree']} points agree, {counts['differ']} differ, {counts['undecided']} are decided in floats only")
    sys.exit(bool(counts["differ"]))


if __name__ == "__main__":
    main()
