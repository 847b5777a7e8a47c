"""Boundaries of fates by simulations of another integrator; a line for every random call, and a table.

``python -m benchmarks.validate_fates FILE [N [FIRST]]``: N random calls of ``fate_boundary`` (300 unless given), from number FIRST on:
the parameter that varies, its bracket, the start and all other parameters are random. Finished calls stand in FILE, one a line, and
the same command goes on from there.

- An answer is confirmed by motions at ± 1e-6 (or at a third of the way to where fates are said to alternate), by DOP853 in the place
  of the Taylor method, over 40 000 time units: their means and root mean squares over the last tenth differ by far more than they
  change within it.
  Where others lie so close to an answer that fates alternate within its error, these are motions at ± 1e-8 or ± 1e-6, where the
  library has looked as well.
- A refusal is read part by part, and each part has its own confirmation, between the values that it names. That both ends come to
  one attractor: a motion is carried from one to the other in small steps of the parameter, and ends with the averages that the
  motion there has. That motions are undecided: averages still change, or neighbours part. That fates alternate: neighbours part, by
  a change of the start that is far below what a boundary could be told to. That an attractor ends: a motion carried on past there
  comes to the averages of the motion there. What was left open for its length is counted as that, and says nothing.
"""

from __future__ import annotations

import re
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from benchmarks.parts import numbered
from spragsym.cycles.sprag import SPRAG

#: What varies, and by how much at most to either side.
VARIED = {"theta0": 0.2, "mu0": 0.15, "kappa": 0.004, "alpha": 0.004, "sigma": 0.04, "V": 0.1, "d": 2.0}

#: To either side of an answer.
ASIDE = 1e-6

#: Time of a simulation that confirms, and the part of it over which averages are taken.
LONG, WINDOW = 40_000.0, 4000.0

#: The same where a motion is carried over the bracket, in how many steps, and how long each lasts; where it decays slowly.
SHORT, STEPS, STEP_LASTS, SETTLED = 16_000.0, 25, 1200.0, 400_000.0

#: To either side of where fates alternate, and changes of the start there.
BETWEEN, NEIGHBOURS = (1e-8, 1e-6), (0.0, 1e-12, 3e-12, 1e-11, 1e-10, 1e-9)


def call(number: int) -> dict[str, Any]:
    """The arguments of a call."""
    rng = np.random.default_rng([28, number])
    values = {
        "theta0": rng.uniform(0.3, 1.2), "mu0": rng.uniform(0.3, 0.9), "kappa": 0.007 * 10 ** rng.uniform(-0.3, 0.3),
        "alpha": 0.007 * 10 ** rng.uniform(-0.3, 0.3), "sigma": 0.1 * 10 ** rng.uniform(-0.3, 0.3), "beta": 0.0,
        "V": rng.uniform(0.1, 0.6), "d": rng.uniform(3.0, 12.0),
    }  # fmt: skip
    vary = str(rng.choice(list(VARIED)))
    if number % 2:  # where rest is about to change its fate
        p = ss.Parameters(**{name: values[name] for name in values if name not in ("theta0", "V", "d")}, theta0=1.0)
        friction = ss.sliding_friction(values["mu0"], values["V"], values["d"])
        edges = ss.folds(p.replace(mu0=friction)).theta0
        if len(edges):
            values["theta0"] = max(float(edges.min()) - rng.uniform(0.0, 0.15), 0.05)
    wide = rng.uniform(0.1, 1.0) * VARIED[vary]
    bracket = (max(values[vary] - wide, 1e-3), values[vary] + wide)
    still = number % 2 or rng.random() < 0.3
    start = [0.0] * 4 if still else rng.uniform([-0.5, -0.5, -0.3, -0.3], [3.0, 3.0, 0.3, 0.3]).tolist()
    return {"values": values, "vary": vary, "bracket": bracket, "start": start}


def averages(values: dict[str, float], start: Any, lasting: float = LONG, window: float = WINDOW) -> tuple[Any, Any]:
    """Means of x and y and root mean squares of x about zero and its mean over each half of the last part, and the last state."""
    numbers, halves, state = tuple(values.values()), [], np.array(start)
    for span in (lasting - window, window / 2, window / 2):
        motion = SPRAG.simulate(numbers, state, span, backend="compiled", rtol=1e-12)
        if span == window / 2:
            halves.append([motion.mean(0.0), motion.mean(0.0, of="y"), motion.rms(0.0), motion.amplitude(0.0)])
        state = motion.state[:, -1]
    return np.array(halves), state


def apart(one: Any, other: Any) -> tuple[float, float]:
    """By how much the averages of two motions differ, and by how much they change within the window."""
    within = max(np.ptp(each, axis=0).max() for each in (one, other))
    return float(np.abs(one.mean(axis=0) - other.mean(axis=0)).max()), float(within)


def confirmed(given: dict[str, Any], found: ss.FateBoundary) -> tuple[bool, str]:
    """Whether motions on both sides of an answer come to different attractors."""
    away = float(np.abs(found.others - found.value).min()) / 3 if len(found.others) else np.inf
    told = ""
    for aside in (min(ASIDE, away),) if away > 3 * found.error else BETWEEN:
        aside = max(aside, 3 * found.error)
        sides = [averages(given["values"] | {given["vary"]: found.value + sign * aside}, given["start"])[0] for sign in (-1, 1)]
        off, within = apart(*sides)
        told += f"averages differ by {off:.2g}, change by {within:.1g}, at ± {aside:.1g}; "
        if off > 3 * within and off > 1e-3:
            return True, told
    return False, told


def carried(given: dict[str, Any], low: float, high: float, lasting: float = SHORT) -> tuple[bool, str]:
    """Whether a motion carried from one value to another ends on the attractor of the motion there."""
    values, vary = given["values"], given["vary"]
    there, _ = averages(values | {vary: high}, given["start"], lasting)
    _, state = averages(values | {vary: low}, given["start"], lasting)
    for share in np.linspace(0, 1, STEPS + 1)[1:-1]:
        numbers = tuple((values | {vary: low + share * (high - low)}).values())
        state = SPRAG.simulate(numbers, state, STEP_LASTS, backend="compiled", rtol=1e-11).state[:, -1]
    here, _ = averages(values | {vary: high}, state, lasting)
    off, within = apart(here, there)
    right = off < max(3 * within, 5e-3)
    if not right and lasting < SETTLED:  # it may not have settled
        return carried(given, low, high, LONG if lasting < LONG else SETTLED)
    return right, f"carried over, averages differ by {off:.2g}, change by {within:.1g}"


def undecided(given: dict[str, Any], *places: float) -> tuple[bool, str]:
    """Whether the averages of a motion at some of the places change, or those of a neighbour are others."""
    told = []
    for place in places:
        values = given["values"] | {given["vary"]: place}
        one, other = (averages(values, np.add(given["start"], [off, 0, 0, 0]))[0] for off in (0, 1e-9))
        told.append(max(apart(one, other)))
    return max(told) > 1e-6, f"averages change by {max(told):.1g}"


def alternating(given: dict[str, Any], place: float) -> tuple[bool, str]:
    """Whether motions from starts hardly apart come to different averages near a value, on one side of it at least."""
    told = []
    for side in (-1, 1):
        values = given["values"] | {given["vary"]: place + side * BETWEEN[0] * (1 + abs(place))}
        found = [averages(values, np.add(given["start"], [off, 0, 0, 0]))[0] for off in NEIGHBOURS]
        told.append(max(apart(found[0], other)[0] for other in found[1:]))
    return max(told) > 1e-3, f"neighbours' averages differ by {told[0]:.1g} below and {told[1]:.1g} above"


def part(given: dict[str, Any], said: str) -> tuple[str, bool, str]:
    """One part of a refusal: what it says, whether that is confirmed, and how."""
    (low, high), vary = given["bracket"], given["vary"]
    named = [float(text) for text in re.findall(rf" at {vary} = ([-+.\de]+)", said)]
    if "one attractor" in said:
        return "one attractor", *carried(given, low, high)
    if "leave it open" in said:
        return "left open", True, "nothing is said"
    if "nothing that" in said:
        texts = re.findall(rf"it comes to (.*?) at {vary} = ([-+.\de]+)", said)
        return "nothing that is decided", *undecided(given, *(float(value) for text, value in texts if "nothing" in text))
    if "alternate" in said:
        return "alternate", *alternating(given, float(re.findall(rf"near {vary} = ([-+.\de]+)", said)[0]))
    if "no boundary of basins" in said:
        aside = 1e-3 * (high - low)
        return "an attractor ends", *carried(given, max(named[0] - aside, low), min(named[1] + aside, high))
    return "undecided between", *undecided(given, *np.linspace(named[0], named[1], 5)[1:-1])


def examined(number: int) -> dict[str, Any]:
    """One call, and whether what it says is confirmed."""
    given = call(number)
    values, begun = given["values"], time.process_time()
    p = ss.Parameters(**{name: values[name] for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")})
    line: dict[str, Any] = {"number": number, "vary": given["vary"], "bracket": given["bracket"]}
    try:
        found = ss.fate_boundary(
            p, vary=given["vary"], bracket=given["bracket"], V=values["V"], d=values["d"], start=given["start"]
        )
    except (ss.ParameterError, ss.ConvergenceError) as error:
        line |= {"seconds": time.process_time() - begun, "said": str(error)}
        text = str(error).partition("): ")[2]
        parts = [part(given, each) for each in re.split(r"; (?!give)", text)]
        return line | {
            "kind": " and ".join(sorted({kind for kind, *_ in parts})), "confirmed": all(right for _, right, _ in parts),
            "how": "; ".join(how for *_, how in parts),
        }  # fmt: skip
    line |= {
        "seconds": time.process_time() - begun, "kind": f"answer, {found.saddle}", "value": found.value, "error": found.error,
        "growth": found.growth, "others": found.others.tolist(),
    }  # fmt: skip
    right, how = confirmed(given, found)
    return line | {"confirmed": right, "how": how}


def main() -> None:
    """Go through the calls; exit code 1 if one is not confirmed."""
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    count, first = (int(text) for text in (*sys.argv[2:], *("300", "0")[len(sys.argv) - 2 :]))
    lines = numbered(Path(sys.argv[1]), range(first, first + count), examined)
    counts = Counter((line["kind"], line["confirmed"]) for line in lines)
    print("| what is said | calls | confirmed | processor seconds, median | at most |\n|---|---|---|---|---|")
    for kind in sorted({line["kind"] for line in lines}):
        seconds = [line["seconds"] for line in lines if line["kind"] == kind]
        print(f"| {kind} | {len(seconds)} | {counts[kind, True]} | {np.median(seconds):.1f} | {max(seconds):.1f} |")
    sys.exit(any(not line["confirmed"] for line in lines))


if __name__ == "__main__":
    main()
