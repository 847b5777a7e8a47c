"""Motions of all shipped models measured in kilograms, metres and seconds of sizes from 1e-6 to
1e6: the same, scaled, by every integrator; so are fates and exponents.

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

#: Of one motion in so many the fate is asked, followed so long in the page's own unit of time.
ASKED, FOLLOWED = 5, 2000.0

#: A motion has settled once its slowest deviations are smaller by exp of this.
SETTLED = 5.0

#: Share of an exponent by which those in other units may part, and a rate that none is told from.
SHARE, SLOWEST = 1e-6, 1e-9


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
    # A clock has its rate by itself.
    begun = of_state[: -1 if own.clock else None]
    start, t_end, rtol = 0.3 * rng.standard_normal(len(begun)), 20.0, 1e-11
    kind = f"{name}, {backend}"

    def moved(values: dict[str, float], at: Any, time: float) -> Any:
        p = own.Parameters(**values)
        return ss.simulate(p, start=at, t_end=t_end * time, rtol=rtol, backend=backend)

    one = moved(base, start, 1.0)
    beside = moved(base, start * (1 + 1e-12), 1.0)
    scaled = {key: value * of_parameters[key] for key, value in base.items()}
    other = moved(scaled, start * begun, sizes[2])
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
    if not number % ASKED:
        wrong += [
            f"{kind}, {sizes}: {fault}"
            for fault in _fate_and_exponents(
                own.Parameters(**base), own.Parameters(**scaled), start, begun, sizes[2]
            )
        ]
    return {"kind": kind, "wrong": wrong, "off": float(off)}


def _fate_and_exponents(one: Any, other: Any, start: Any, sizes: Any, time: float) -> list[str]:
    """What differs, of motions that come to an attractor, whose exponents are told with errors."""
    found, there = (
        ss.fate(p, start=at, t_end=FOLLOWED * duration)
        for p, at, duration in ((one, start, 1.0), (other, start * sizes, time))
    )
    wrong = []
    if {found.kind, there.kind} == {"undecided", "chaotic"}:
        # Of irregular motions that rounding parts: their largest exponents agree within errors.
        one, two = found.exponents[0], time * there.exponents[0]
        if not abs(one - two) <= found.error[0] + time * there.error[0]:
            wrong.append(f"largest exponent {one} of an irregular motion, scaled {two}")
    elif found.kind != there.kind:
        undecided = there if there.kind == "undecided" else found
        decided, unit = (found, 1.0) if undecided is there else (there, time)
        if undecided.kind != "undecided" or not _settling(decided, unit):
            wrong.append(f"fate {found.kind}, scaled {there.kind}: {found.why}; {there.why}")
    elif found.kind in ("rest", "cycle"):
        known = np.isfinite(found.exponents)
        parted = np.abs(found.exponents[known] - time * there.exponents[known])
        allowed = SHARE * np.abs(found.exponents[known]) + SLOWEST
        if found.trivial != there.trivial or not (parted <= allowed + found.error[known]).all():
            wrong.append(f"exponents {found.exponents}, scaled {time * there.exponents}")
        if not np.isclose(found.time_scale, there.time_scale / time, rtol=SHARE):
            wrong.append(f"decay in {found.time_scale}, scaled {there.time_scale / time}")
    return wrong


def _settling(fate: Any, unit: float) -> bool:
    """Whether what a fate comes to attracts too slowly for a motion of this length to settle."""
    if fate.kind not in ("rest", "cycle"):
        return False
    rates = unit * np.delete(fate.exponents, fate.trivial if fate.trivial >= 0 else [])
    return bool(-FOLLOWED * rates.max() < SETTLED)
