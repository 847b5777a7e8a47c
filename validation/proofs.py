"""Proofs of cycles at 10, 25, 60 and 200 digits, and claims of cycles that are none.

``python -m validation.proofs STORE [PATIENCE]``. Each proof prints whether it came, its time, and whether its decimals, as
rational intervals, hold the ball that was proved and meet those of all other numbers of digits. A claim of no cycle is refused, and
the reason and the time are printed. PATIENCE is that of a proof, in seconds; finished ones stand in STORE, and the same command goes on
from there.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.cycles import proofs
from spragsym.exact.decimals import Decimal, exactly
from validation.parts import run

#: Digits of the proofs.
DIGITS = (10, 25, 60, 200)

#: Cycles that are proved, begun at these inclinations and states.
PROVED = {
    "attracts weakly": (42.0, (2.538161566773, 3.361504868710, 0.0, 0.361278176249)),
    "doubled": (49.0, (2.52576715, 3.53980918, 0.0, -0.33132352)),
    "short": (90.0, (2.32939917, 1.34003954, 0.0, 0.25152749)),
}

Claim = dict[str, Any]


def base() -> ss.Cycle:
    """The cycle at 42 degrees."""
    degrees, state = PROVED["attracts weakly"]
    return ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), near=state, patient=False)


def at(claim: Claim, **changed: float) -> Claim:
    """The claim for other parameters."""
    names = ss.Parameters.article().model.parameters
    return claim | {"values": [changed.get(name, value) for name, value in zip(names, claim["values"], strict=True)]}


#: Claims of cycles that are none, each made of a true one.
NONE: dict[str, Callable[[Claim], Claim]] = {
    "beyond the fold over theta0, 69.842 degrees": lambda claim: at(claim, theta0=float(np.radians(69.85))),
    "beyond the fold over mu0, 0.0957": lambda claim: at(claim, mu0=0.0957),
    "beyond the fold over mu0, far": lambda claim: at(claim, mu0=0.05),
    "without friction": lambda claim: at(claim, mu0=0.0),
    "half the period": lambda claim: claim | {"period": claim["period"] / 2, "crossings": claim["crossings"][: len(claim["crossings"]) // 2]},
    "a period that is too long": lambda claim: claim | {"period": 1.2 * claim["period"]},
    "a state off the orbit": lambda claim: claim | {"state": [1.5 * value for value in claim["state"]]},
    "no contact with the belt": lambda claim: claim | {"crossings": []},
    "a border that is not crossed": lambda claim: claim | {"crossings": [[t, 1 - border] for t, border in claim["crossings"]]},
    "one crossing twice": lambda claim: claim | {"crossings": [claim["crossings"][0], *claim["crossings"]]},
}  # fmt: skip


def proof(name: str, digits: int, patience: float) -> dict[str, Any]:
    """One proof: its time, and its decimals."""
    degrees, state = PROVED[name]
    cycle = ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), near=state, patient=False)
    begun = time.perf_counter()
    found = ss.precise.prove_cycle(cycle, digits=digits, patience=patience)
    told = {key: list(decimal) for key, decimal in found.decimals().items()} if found.proved else {}
    held = all(_holds(decimal, ball) for decimal, ball in _balls(found)) if found.proved else None
    return {
        "proved": found.proved, "reason": found.reason, "seconds": time.perf_counter() - begun, "decimals": told, "held": held,
    }  # fmt: skip


def _balls(found: Any) -> list[tuple[Decimal, tuple[Fraction, Fraction]]]:
    """Each decimal of state and period beside the ball that is proved, in rational arithmetic."""
    told = found.decimals()
    numbers = {**{f"state_{i + 1}": value for i, value in enumerate(found.state)}, "period": found.period}
    radius = Fraction(found.error)
    exact = {name: exactly(value) for name, value in numbers.items() if value}
    return [(told[name], (value - radius, value + radius)) for name, value in exact.items()]


def _holds(decimal: Any, ball: tuple[Fraction, Fraction]) -> bool:
    low, high = interval(decimal)
    return low <= ball[0] and ball[1] <= high


def interval(decimal: Any) -> tuple[Fraction, Fraction]:
    """What a decimal with its bound says, in rational arithmetic."""
    value, error = map(Fraction, decimal)
    return value - error, value + error


def refusal(name: str, patience: float) -> dict[str, Any]:
    """What is said of a claim that is none."""
    claim = NONE[name](proofs.claim_of(base(), 25))
    begun = time.perf_counter()
    found = proofs._run(claim, patience)
    return {"proved": found["proved"], "reason": found.get("reason", ""), "seconds": time.perf_counter() - begun}


def main() -> None:
    """Run what is not yet in the store, and print all."""
    store, patience = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 3600.0
    parts = [f"no cycle: {name}" for name in NONE]
    parts += [f"{name}: {digits}" for digits in DIGITS for name in PROVED]

    def work(part: str) -> dict[str, Any]:
        kind, _, rest = part.partition(": ")
        return refusal(rest, patience) if kind == "no cycle" else proof(kind, int(rest), patience)

    done = run(parts, work, store)
    for part, line in done.items():
        said = "proved" if line["proved"] else line["reason"]
        held = "" if line.get("held") is None else f", decimals hold what is proved: {line['held']}"
        print(f"{part:55}{line['seconds']:8.1f} s  {said}{held}")
    for name in PROVED:
        told = [done[f"{name}: {digits}"]["decimals"] for digits in DIGITS if done[f"{name}: {digits}"]["proved"]]
        meet = all(
            max(interval(one[key])[0] for one in told) <= min(interval(one[key])[1] for one in told)
            for key in set(told[0] if told else ()).intersection(*told)
        )
        print(f"{name}: {len(told)} proofs, all intervals meet: {meet}")


if __name__ == "__main__":
    main()
