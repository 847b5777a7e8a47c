"""Ends of branches of stick-slip cycles where their arrival at the belt's speed becomes tangent,
against closed forms.

Drawn are friction coefficients, damper, and which of the four parameters varies; the end is to lie
within its stated error, which is to be small, and to have its name.
"""

import functools
from typing import Any

import numpy as np
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles import tangent_arrivals

CASES = 40

#: Stated errors are below this share of the value.
SMALL = 1e-7


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One end."""
    vary = ("V", "mu_k", "mu_s", "zeta")[number % 4]
    zeta, mu_s = rng.uniform(0.03, 0.3), rng.uniform(0.4, 0.8)
    known = {"mu_s": mu_s, "mu_k": mu_s * rng.uniform(0.4, 0.8), "zeta": zeta}
    whole = (mu_s - known["mu_k"]) * tangent_arrivals.ratio(zeta)
    known["V"] = whole * rng.uniform(0.6, 0.9)
    ratio = known["V"] / (mu_s - known["mu_k"])
    value = {
        "V": lambda: whole,
        "mu_k": lambda: mu_s - known["V"] / tangent_arrivals.ratio(zeta),
        "mu_s": lambda: known["mu_k"] + known["V"] / tangent_arrivals.ratio(zeta),
        "zeta": lambda: brentq(lambda z: tangent_arrivals.ratio(z) - ratio, zeta, 1.5, xtol=1e-15),
    }[vary]()
    begin = known[vary]
    p = model().Parameters(**known)
    cycle = ss.cycle(p, near=(mu_s - zeta * known["V"], known["V"]))
    between = sorted((begin - 0.1 * (value - begin), value + 0.3 * (value - begin)))
    branch = ss.cycle_branch(cycle, vary, between={vary: tuple(between)})
    ends = [event for event in branch.events if event.how != "the range ends"]
    wrong = [f"{vary}: {len(ends)} ends beside those of the range"] * (len(ends) != 1)
    for event in ends:
        off = abs(event.value - value)
        if event.kind != "catastrophic-sliding" or not off <= event.error < SMALL * value:
            wrong.append(f"{vary}: {off:.2g} off, {event.error:.2g} stated; {event.how}")
    off = max((abs(event.value - value) for event in ends), default=np.inf)
    stated = max((event.error for event in ends), default=np.inf)
    return {"kind": vary, "wrong": wrong, "off": float(off), "stated": float(stated)}


@functools.cache
def model() -> Any:
    """The model, derived once."""
    return tangent_arrivals.model()
