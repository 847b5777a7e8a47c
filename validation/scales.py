"""Motions of all shipped models measured in kilograms, metres and seconds of sizes from 1e-6 to
1e6: the same, scaled, by every integrator.

Last found: a motion 3e4 times as large never ended, and its error said the friction law was steep
(issue 75).
"""

from functools import cache
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.models.load import shipped
from tests.oracles.dimensional_pages import dimensional, units

CASES = 200

model = cache(dimensional)

#: Largest decimal exponent of a size.
MOST = 6.0

#: How far motions of one tolerance may part, in tolerances; how far of a start within rounding,
#: times the growth of that.
PARTED, GROWN = 1e4, 1e2


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One motion in two systems of units."""
    names = shipped()
    name, backend = names[number % len(names)], ("heyoka", "scipy")[rng.integers(2)]
    own = model(name)
    base = {
        entry["name"]: entry["base"] if entry["base"] is not None else rng.uniform(0.4, 0.9)
        for entry in own.about["parameters"]
    }
    sizes = 10 ** rng.uniform(-MOST, MOST, 3)
    of_parameters, of_state = units(own, sizes)
    start, t_end, rtol = 0.3 * rng.standard_normal(len(of_state)), 20.0, 1e-11
    kind = f"{name}, {backend}"

    def moved(values: dict[str, float], begun: Any, time: float) -> Any:
        p = own.Parameters(**values)
        return ss.simulate(p, start=begun, t_end=t_end * time, rtol=rtol, backend=backend)

    one = moved(base, start, 1.0)
    beside = moved(base, start * (1 + 1e-12), 1.0)
    scaled = {key: value * of_parameters[key] for key, value in base.items()}
    other = moved(scaled, start * of_state, sizes[2])
    times = np.linspace(0.0, t_end, 101)[1:-1]
    seen = other(times * sizes[2]) / of_state[:, None]
    off = np.abs(seen - one(times)).max()
    reach = np.abs(one.state).max()
    grown = np.abs(one(times) - beside(times)).max() / 1e-12
    wrong = []
    if not off <= (PARTED * rtol * reach + GROWN * rtol * grown):
        wrong.append(f"{kind}, {sizes}: off by {off:.2g}, growth {grown:.2g}")
    if (one.events.which.tolist() != other.events.which.tolist()) and grown < 1e4:
        wrong.append(f"{kind}, {sizes}: {len(one.events)} events, {len(other.events)} scaled")
    regimes = [
        each.outcome(t_end * time / 4).regime for each, time in ((one, 1.0), (other, sizes[2]))
    ]
    if regimes[0] != regimes[1]:
        wrong.append(f"{kind}, {sizes}: {regimes[0].name}, scaled {regimes[1].name}")
    return {"kind": kind, "wrong": wrong, "off": float(off)}
