"""Proofs of cycles at 10, 25, 60 and 200 digits, and claims of cycles that are none.

Decimals, as rational intervals, hold the ball that was proved and meet those of all other numbers
of digits. It guards the claim that no cycle is proved that is none, for as long as a proof may
take.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.numerics.decimals import exactly
from spragsym.orbits import proofs

#: Digits of the proofs.
DIGITS = (10, 25, 60, 200)

#: Cycles that are proved, begun at these inclinations and states.
PROVED = {
    "attracts weakly": (42.0, (2.538161566773, 3.361504868710, 0.0, 0.361278176249)),
    "doubled": (49.0, (2.52576715, 3.53980918, 0.0, -0.33132352)),
    "short": (90.0, (2.32939917, 1.34003954, 0.0, 0.25152749)),
}

Claim = dict[str, Any]


def base() -> ss.results.Cycle:
    """The cycle at 42 degrees."""
    degrees, state = PROVED["attracts weakly"]
    return ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), near=state, patient=False)


def at(claim: Claim, **changed: float) -> Claim:
    """The claim for other parameters."""
    names = ss.Parameters.article().model.parameters
    return claim | {
        "values": [
            changed.get(name, value) for name, value in zip(names, claim["values"], strict=True)
        ]
    }


#: Claims of cycles that are none, each made of a true one.
NONE: dict[str, Callable[[Claim], Claim]] = {
    "beyond the fold over theta0, 69.842 degrees": lambda claim: at(
        claim, theta0=float(np.radians(69.85))
    ),
    "beyond the fold over mu0, 0.0957": lambda claim: at(claim, mu0=0.0957),
    "beyond the fold over mu0, far": lambda claim: at(claim, mu0=0.05),
    "without friction": lambda claim: at(claim, mu0=0.0),
    "half the period": lambda claim: (
        claim
        | {
            "period": claim["period"] / 2,
            "crossings": claim["crossings"][: len(claim["crossings"]) // 2],
        }
    ),
    "a period that is too long": lambda claim: claim | {"period": 1.2 * claim["period"]},
    "a state off the orbit": lambda claim: (
        claim | {"state": [1.5 * value for value in claim["state"]]}
    ),
    "no contact with the belt": lambda claim: claim | {"crossings": []},
    "a border that is not crossed": lambda claim: (
        claim | {"crossings": [[t, 1 - border] for t, border in claim["crossings"]]}
    ),
    "one crossing twice": lambda claim: (
        claim | {"crossings": [claim["crossings"][0], *claim["crossings"]]}
    ),
}


#: Seconds that a proof may take, and what is proved or refused.
PATIENCE = 3600.0
ASKED = [("no cycle", name) for name in NONE] + [("proof", name) for name in PROVED]
CASES = len(ASKED)


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """A claim that must be refused, or the proofs of a cycle, whose decimals hold what is proved
    and meet each other.
    """
    kind, name = ASKED[number]
    if kind == "no cycle":
        found = proofs._run(NONE[name](proofs.claim_of(base(), 25)), PATIENCE)
        return {"kind": kind, "wrong": [f"{name}: proved"] * bool(found["proved"])}
    degrees, state = PROVED[name]
    cycle = ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), near=state, patient=False)
    wrong, told = [], []
    for digits in DIGITS:
        proved = ss.precise.prove_cycle(cycle, digits=digits, patience=PATIENCE)
        if not proved.proved:
            continue
        decimals = {key: interval(decimal) for key, decimal in proved.decimals().items()}
        numbers = {
            **{f"state_{i + 1}": value for i, value in enumerate(proved.state)},
            "period": proved.period,
        }
        radius = Fraction(proved.error)
        for key, value in ((key, exactly(value)) for key, value in numbers.items() if value):
            if not (decimals[key][0] <= value - radius and value + radius <= decimals[key][1]):
                wrong.append(f"{name} to {digits} digits: {key} does not hold the ball")
        told.append(decimals)
    wrong += [
        f"{name}: {key} of two proofs do not meet"
        for key in set(told[0] if told else ()).intersection(*told)
        if max(one[key][0] for one in told) > min(one[key][1] for one in told)
    ]
    return {"kind": kind, "wrong": wrong, "proved": len(told)}


def interval(decimal: Any) -> tuple[Fraction, Fraction]:
    """What a decimal with its bound says, in rational arithmetic."""
    value, error = map(Fraction, decimal)
    return value - error, value + error
