"""Equilibria of pages of other shapes against balances written by hand: none wrong, none missed.

``python -m validation.shapes [SECONDS] [SEED]``: random parameters of an arm on a belt, of a double pendulum that brushes a belt,
and of a mass on a wavy belt, in contact and in lift-off; SciPy's hybrid method from random starts looks for states that are not listed.
Exits with 1 if there is one, or if one that is listed is none. It uses the pages of tests/test_models_shapes.py.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import fsolve

import spragsym as ss
from tests.test_models_shapes import BELT, FRICTION, PAGES

BRUSH = f"""{BELT}
h = page.parameter("h", "m", "height", "> 0", 1.9, becomes="eta")
page.contact(h + y2, lambda depth: k_c * depth)
page.friction(x2, V, {FRICTION})
"""
#: Starts for each set.
STARTS = 60
Values = Mapping[str, float]


def brush(q: Any, p: Values, contact: int) -> list[float]:
    """Balance of the double pendulum, masses 1 and ν, lengths 1."""
    a, b = q
    push = -contact * gap_of_brush(q, p)
    return [
        p["gamma"] * (1 + p["nu"]) * np.sin(a) - push * np.sin(a) - p["mu0"] * push * np.cos(a),
        p["gamma"] * p["nu"] * np.sin(b) - push * np.sin(b) - p["mu0"] * push * np.cos(b),
    ]


def gap_of_brush(q: Any, p: Values) -> float:
    """Height of its tip above the belt."""
    return float(p["eta"] - np.cos(q[0]) - np.cos(q[1]))


def bumps(q: Any, p: Values, contact: int) -> list[float]:
    """Balance of the mass on the wavy belt."""
    push = -contact * gap_of_bumps(q, p)
    slope = 3 * p["b"] * np.cos(3 * q[0])
    return [p["sigma"] * q[0] + push * slope - p["mu0"] * push, p["sigma"] * q[1] + p["kappa"] - push]


def gap_of_bumps(q: Any, p: Values) -> float:
    """Height above the wave."""
    return float(q[1] - p["b"] * np.sin(3 * q[0]))


def arm(q: Any, p: Values, contact: int) -> list[float]:
    """Balance of the arm."""
    push = -contact * gap_of_arm(q, p)
    return [p["tau"] * (q[0] - p["theta0"]) + push * (np.cos(q[0]) + p["mu0"] * np.sin(q[0]))]


def gap_of_arm(q: Any, p: Values) -> float:
    """Height of its tip above the belt."""
    return float(p["eta"] - np.sin(q[0]))


#: Balance, gap, and how far from 0 starts lie.
Reference = tuple[Callable[..., list[float]], Callable[..., float], float]
REFERENCES: dict[str, Reference] = {
    "brush": (brush, gap_of_brush, np.pi),
    "bumps": (bumps, gap_of_bumps, 3.0),
    "arm": (arm, gap_of_arm, 60.0),
}


def draw(model: Any, rng: np.random.Generator) -> dict[str, float]:
    """One set: within a decade of the base values, angles and heights over their ranges; a tenth of all without friction."""
    values = {name: float(model.base[name] * 10 ** rng.uniform(-1, 1)) for name in model.parameters}
    ranges = {"theta0": (0.1, 3.0), "eta": (0.02, 2.2)}
    values |= {name: float(rng.uniform(*ends)) for name, ends in ranges.items() if name in values}
    return values | ({"mu0": 0.0} if rng.random() < 0.1 else {})


def compared(model: Any, reference: Reference, p: Values, contact: int, rng: np.random.Generator) -> Counter[str]:
    """What is found of one set, and what is wrong with it."""
    balance, gap, reach = reference
    eq = ss.equilibria(model.Parameters(**p), contact=bool(contact))
    states = np.array([eq.coordinates[name][: int(eq.count)] for name in model.coordinates]).T
    counts = Counter(
        sets=1, states=len(states), undecided=int(not eq.complete), unproved_regions=int(not eq.whole.all()), missed=0
    )
    counts["wrong"] = sum(np.abs(balance(q, p, contact)).max() > 1e-9 * (1 + max(p.values())) for q in states)
    comes_around = bool(model.about["coordinates"][0].get("comes_around"))
    for start in rng.uniform(-reach, reach, (STARTS if eq.complete else 0, len(model.coordinates))):
        q, _, ended, _ = fsolve(balance, start, args=(p, contact), full_output=True, xtol=1e-13)
        if ended != 1 or np.abs(balance(q, p, contact)).max() > 1e-12 or (1 - 2 * contact) * gap(q, p) < 1e-9:
            continue
        away = states - q
        away = (away + np.pi) % (2 * np.pi) - np.pi if comes_around else away
        far = not len(away) or np.abs(away).max(axis=1).min() > 1e-5 * (1 + np.abs(q).max())
        if far and _is_regular(balance, q, p, contact):
            print(f"missed: {q.tolist()} at {dict(p)}, contact {contact}", flush=True)
            counts["missed"] += 1
    return counts


def _is_regular(balance: Callable[..., list[float]], q: Any, p: Values, contact: int) -> bool:
    """Whether the slopes at a state are such that a small residual means a state nearby."""
    steps = 1e-6 * np.eye(q.size)
    slopes = [(np.array(balance(q + h, p, contact)) - np.array(balance(q - h, p, contact))) / 2e-6 for h in steps]
    return bool(abs(np.linalg.det(np.array(slopes))) > 1e-5)


def main() -> int:
    """All models until the time is over."""
    from spragsym.derive import folder

    seconds, seed = (float(sys.argv[1]) if len(sys.argv) > 1 else 60.0), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    rng, begin = np.random.default_rng(seed), time.monotonic()
    totals: dict[tuple[str, int], Counter[str]] = {}
    with tempfile.TemporaryDirectory() as out:
        models = {}
        for name, text in {**PAGES, "brush": PAGES["double_pendulum"] + BRUSH}.items():
            if name in REFERENCES:
                (Path(out) / f"{name}.py").write_text(text, encoding="utf-8")
                folder.write_page(Path(out) / f"{name}.py", Path(out) / name)
                models[name] = ss.load(Path(out) / name)
        while time.monotonic() - begin < seconds:
            for name, model in models.items():
                p = draw(model, rng)
                for contact in (1, 0):
                    found = compared(model, REFERENCES[name], p, contact, rng)
                    totals.setdefault((name, contact), Counter()).update(found)
    for (name, contact), counts in totals.items():
        print(f"{name}, {'contact' if contact else 'lift-off'}: {', '.join(f'{n} {what}' for what, n in counts.items())}")
    return int(any(counts["wrong"] + counts["missed"] for counts in totals.values()))


if __name__ == "__main__":
    sys.exit(main())
