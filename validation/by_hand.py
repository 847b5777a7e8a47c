"""Random attack on every shipped model and other pages, against forces written by hand: equilibria, motions, generated code.

Values are log-uniform over 10⁻⁶ to 10⁶ or near the base, ends of ranges and 0 among them. Last found: errors up to 7e-8 on proved
states of stiff springs, kinks and belts that run backwards, which were carried through (5b82b53f).
"""

from __future__ import annotations

import contextlib
import functools
import shutil
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles import by_hand, emission
from tests.oracles.forces_by_hand import DRAWN

CASES = 20 * len(DRAWN)


@functools.cache
def derived() -> Any:
    """A folder for what is derived, as long as the process lives."""
    return tempfile.TemporaryDirectory()


@functools.cache
def model_of(name: str) -> Any:
    """A model, derived once."""
    return by_hand.load(name, Path(derived().name))


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One set of parameters of one model; the first of each has its generated functions compared."""
    name = list(DRAWN)[number % len(DRAWN)]
    model, drawn = model_of(name), DRAWN[name]
    values = by_hand.draw(model, rng)
    asked = [lambda side=side: by_hand.equilibria(model, drawn, values, side, rng) for side in (True, False)[: 1 + drawn.lifts]]
    asked.append(lambda: by_hand.motion(model, drawn, values, rng))
    found: dict[str, Any] = {"kind": name, "wrong": [], "undecided": 0, "refused": 0}
    for ask in asked:
        try:
            told = ask()
        except ss.SpragsymError:
            found["refused"] += 1
            continue
        found["wrong"] += [f"{name} {values}: {text}" for text in told["wrong"]]
        found["undecided"] += told.get("undecided", 0)
    if number < len(DRAWN) and shutil.which("cc"):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(None):
            found["wrong"] += emission.compare(name, 20, number, Path(folder))
    return found
