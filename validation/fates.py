"""Boundaries of fates by simulations of another integrator.

The parameter that varies, its bracket, the start and all other parameters of a call of
``fate_boundary`` are random.

- Motions are followed by DOP853 in the place of the Taylor method, and told by their averages, with
  weights that fall to 0 at both ends of a window, so that a window need not hold whole periods. Two
  have different ends if these differ by far more than they change from one window to the next.
- An answer is confirmed by motions at ± 1e-6 with different ends; where fates are said to alternate
  more closely, at a third of the way to the next change; where both come to one end there, nearer
  by, at three errors at least.
- A refusal is read part by part, and each part has its own confirmation, between the values that it
  names. That both ends come to one attractor: a motion is carried from one to the other, by steps
  of the parameter so small that averages jump nowhere, and ends with the averages that the motion
  there has. That motions are undecided: averages still change, neighbours part, or a motion does
  not come back to itself. That fates alternate more closely than rounding can tell: of motions that
  begin within rounding of one another, at values within the width that is named, two have different
  ends. That an attractor ends: a motion carried on past there comes to the averages of the motion
  there. What was left open for its length is counted as that, and says nothing.

Last found: rounding decided between a cycle and itself, which had two labels (42b2a993).
"""

import re
from typing import Any

import numpy as np
from scipy.optimize import minimize_scalar

import spragsym as ss
from spragsym.motion.simulation import motion_of
from tests.oracles.random_motions import fate_of

#: The article's model, as cycles take it.
SPRAG = ss.load("kang_nam").field

CASES = 300
#: To either side of an answer.
ASIDE = 1e-6

#: Time of a simulation that confirms, and the last part of it, over the halves of which averages
#: are taken, in steps of this.
LONG, WINDOW, SAMPLED = 40_000.0, 8000.0, 0.4

#: Averages that differ by more than this, and by so many times what they change, are of different
#: ends.
OTHER, TIMES = 1e-5, 30.0

#: Averages that differ by less than this are taken for those of one attractor.
ALIKE = 1e-3

#: How long a motion that decays slowly is followed at most, until averages change by no more than
#: this.
SETTLED, STEADY = 400_000.0, 1e-6

#: Where a motion is carried on: the first step as a share of the way, halvings of it, its time, and
#: the most that averages may jump.
STEP, HALVINGS, STEP_LASTS, JUMP = 1 / 25, 10, 4000.0, 0.02

#: Tolerance of the motions to either side of an answer.
CLOSELY = 1e-13

#: How much nearer to an answer motions are tried where those farther off come to one end, as on
#: islands of the other fate.
NEARER = (1, 30, 1000)

#: Changes of the start, as far as the package moves it, and motions that are looked at, where
#: rounding is said to decide.
ROUNDING, LOOKED_AT = 4e-12, 400

#: For how long a motion is asked to come back to itself, how finely, and what is no return, as a
#: share of its extent.
PASSES, FINELY, AGAIN = 1000.0, 0.02, 1e-5


def averages(
    values: dict[str, float],
    start: Any,
    lasting: float = LONG,
    window: float = WINDOW,
    rtol: float = 1e-12,
) -> tuple[Any, Any]:
    """Means of x and y and root mean squares of x about zero and its mean over each half of the
    last part, and the last state.
    """
    numbers, halves, state = tuple(values.values()), [], np.array(start)
    for span in (lasting - window, window / 2, window / 2):
        if span > 0:
            motion = motion_of(SPRAG, numbers, state, span, backend="compiled", rtol=rtol)
            state = motion.state[:, -1]
        if span == window / 2:
            share = np.linspace(0, 1, round(span / SAMPLED) + 1)
            weights = np.sin(np.pi * share) ** 4
            x, y, *_ = motion(span * share)
            mean_x, mean_y, square = (
                float(weights @ each / weights.sum()) for each in (x, y, x**2)
            )
            halves.append([mean_x, mean_y, square**0.5, max(square - mean_x**2, 0.0) ** 0.5])
    return np.array(halves), state


def apart(one: Any, other: Any) -> tuple[float, float]:
    """By how much the averages of two motions differ, and by how much they change within the
    window.
    """
    within = max(np.ptp(each, axis=0).max() for each in (one, other))
    return float(np.abs(one.mean(axis=0) - other.mean(axis=0)).max()), float(within)


def differ(one: Any, other: Any) -> bool:
    """Whether two motions have different ends."""
    off, within = apart(one, other)
    return off > max(OTHER, TIMES * within)


def settled(values: dict[str, float], start: Any, rtol: float = 1e-12) -> tuple[Any, Any]:
    """As averages, of a motion that is followed until they no longer change, or for long."""
    found, state = averages(values, start, rtol=rtol)
    time = LONG
    while np.ptp(found, axis=0).max() > STEADY and time < SETTLED:
        found, state = averages(values, state, time, rtol=rtol)
        time *= 2
    return found, state


def confirmed(given: dict[str, Any], found: ss.results.FateBoundary) -> tuple[bool, str]:
    """Whether motions on both sides of an answer come to different attractors."""
    away = float(np.abs(found.others - found.value).min()) / 3 if len(found.others) else np.inf
    widest, told = min(ASIDE, away), ""
    for nearer in NEARER:
        aside = max(widest / nearer, 3 * found.error)
        places = [given["values"] | {given["vary"]: found.value + sign * aside} for sign in (-1, 1)]
        sides = [settled(place, given["start"], CLOSELY)[0] for place in places]
        off, within = apart(*sides)
        told = f"averages differ by {off:.2g}, change by {within:.1g}, at ± {aside:.1g}"
        if differ(*sides):
            return True, told
    return False, told


def carried(
    given: dict[str, Any], low: float, high: float, *, jumps: bool = False
) -> tuple[bool, str]:
    """Whether a motion carried from one value to another ends on the attractor of the motion there,
    with or without a jump.
    """
    values, vary = given["values"], given["vary"]
    there, _ = settled(values | {vary: high}, given["start"])
    before, state = settled(values | {vary: low}, given["start"])
    share, step, largest = 0.0, STEP, 0.0
    while share < 1:
        ahead = min(share + step, 1.0)
        now, then = averages(
            values | {vary: low + ahead * (high - low)}, state, STEP_LASTS, STEP_LASTS
        )
        jump = float(np.abs(now[-1] - before[-1]).max())
        if jump > JUMP and step > STEP / 2**HALVINGS:
            step /= 2
            continue
        share, before, state, largest = ahead, now, then, max(largest, jump)
        step = min(2 * step, STEP)
    here, _ = settled(values | {vary: high}, state)
    off, within = apart(here, there)
    right = off < ALIKE and (jumps or largest <= JUMP)
    return (
        right,
        f"carried over, averages differ by {off:.2g}, change by {within:.1g}, jump by "
        f"{largest:.2g} at most",
    )


def undecided(given: dict[str, Any], *places: float) -> tuple[bool, str]:
    """Whether a motion at some of the places does not come back to itself, or a neighbour has other
    averages.
    """
    told, missed = [], []
    for place in places:
        values = given["values"] | {given["vary"]: place}
        (one, state), (other, _) = (
            averages(values, np.add(given["start"], [off, 0, 0, 0])) for off in (0, 1e-9)
        )
        told.append(max(apart(one, other)))
        missed.append(0.0 if max(told) > STEADY else returned(values, state))
    why = f"averages change by {max(told):.1g}" + (
        f", it passes itself at {max(missed):.1g}" if max(missed) else ""
    )
    return max(told) > STEADY or max(missed) > AGAIN, why


def returned(values: dict[str, float], start: Any) -> float:
    """How near a motion passes its start once more, as a share of its extent; 0 for one that stays
    there.
    """
    motion = motion_of(SPRAG, tuple(values.values()), start, PASSES, backend="compiled", rtol=1e-12)
    times = np.linspace(0, PASSES, round(PASSES / FINELY) + 1)
    states = motion(times)
    extent = float(np.ptp(states, axis=1).max())
    if extent < STEADY:
        return 0.0
    off = np.abs(states - np.asarray(start)[:, None]).max(axis=0)
    gone = int(np.argmax(off > 0.1 * extent))
    near = times[gone + int(np.argmin(off[gone:]))]
    closest = minimize_scalar(
        lambda t: float(np.abs(motion(np.array([t]))[:, 0] - start).max()),
        bounds=(near - FINELY, min(near + FINELY, PASSES)),
        method="bounded",
        options={"xatol": 1e-12},
    )
    return float(closest.fun) / extent


def lingering(given: dict[str, Any], place: float, until: float) -> tuple[bool, str]:
    """Whether of motions that begin within rounding of one another one has not come to its end at
    that time.
    """
    rng, values = np.random.default_rng(1), given["values"] | {given["vary"]: place}
    for count in range(1, LOOKED_AT // 2 + 1):
        found, _ = averages(values, np.add(given["start"], ROUNDING * rng.uniform(-1, 1, 4)), until)
        if (change := float(np.ptp(found, axis=0).max())) > STEADY:
            return True, f"averages of neighbour {count} change by {change:.1g} at t = {until:g}"
    return False, f"all of {LOOKED_AT // 2} neighbours have settled by t = {until:g}"


def alternating(given: dict[str, Any], place: float, width: float) -> tuple[bool, str]:
    """Whether motions from starts within rounding of one another have different ends, at values
    near one.
    """
    rng = np.random.default_rng(0)
    for _ in range(LOOKED_AT // 2):
        values = given["values"] | {given["vary"]: place + width * rng.uniform(-1, 1)}
        pair = [
            settled(values, np.add(given["start"], ROUNDING * rng.uniform(-1, 1, 4)))[0]
            for _ in range(2)
        ]
        if differ(*pair):
            return (
                True,
                f"averages of neighbours differ by {apart(*pair)[0]:.1g}, change by "
                f"{apart(*pair)[1]:.1g}",
            )
    return False, f"of {LOOKED_AT} motions no neighbours come to different ends"


def part(given: dict[str, Any], said: str) -> tuple[str, bool, str]:
    """One part of a refusal: what it says, whether that is confirmed, and how."""
    (low, high), vary = given["bracket"], given["vary"]
    named = [float(text) for text in re.findall(rf" at {vary} = ([-+.\de]+)", said)]
    by_rounding = [
        float(text)
        for text in re.findall(rf"as rounding decides, to .*? at {vary} = ([-+.\de]+)", said)
    ]
    if by_rounding:
        lasts = re.findall(
            r"or, as rounding decides, to nothing that is decided by t = ([-+.\de]+)", said
        )
        found = [
            open_
            if lasts
            and (
                (open_ := undecided(given, place))[0]
                or (open_ := lingering(given, place, float(lasts[0])))[0]
            )
            else alternating(given, place, 0.0)
            for place in by_rounding
        ]
        if "undecided" in said:
            found.append(undecided(given, *np.linspace(named[0], named[1], 5)[1:-1]))
        return (
            "rounding decides",
            all(right for right, _ in found),
            "; ".join(how for _, how in found),
        )
    if "one attractor" in said:
        return "one attractor", *carried(given, low, high)
    if "leave it open" in said:
        return "left open", True, "nothing is said"
    if "nothing that" in said:
        texts = re.findall(rf"it comes to (.*?) at {vary} = ([-+.\de]+)", said)
        return "nothing that is decided", *undecided(
            given, *(float(value) for text, value in texts if "nothing" in text)
        )
    if "alternate" in said:
        width, place = re.findall(rf"within ([-+.\de]+) of {vary} = ([-+.\de]+)", said)[0]
        return "alternate", *alternating(given, float(place), float(width))
    if "no boundary of basins" in said:
        aside = 1e-3 * (high - low)
        return "an attractor ends", *carried(
            given, max(named[0] - aside, low), min(named[1] + aside, high), jumps=True
        )
    return "undecided between", *undecided(given, *np.linspace(named[0], named[1], 5)[1:-1])


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """One call, and whether what it says is confirmed."""
    given = fate_of(number)
    values = given["values"]
    p = ss.Parameters(
        **{name: values[name] for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")}
    )
    speeds = {name: values[name] for name in ("V", "d")}
    try:
        found = ss.fate_boundary(
            p,
            given["vary"],
            between={given["vary"]: given["bracket"]},
            start=given["start"],
            **speeds,
        )
    except (ss.errors.ParameterError, ss.errors.ConvergenceError) as error:
        parts = [
            part(given, each) for each in re.split(r"; (?!give)", str(error).partition("): ")[2])
        ]
        wrong = [f"{error}; {how}" for _, right, how in parts if not right]
        return {"kind": " and ".join(sorted({kind for kind, *_ in parts})), "wrong": wrong}
    right, how = confirmed(given, found)
    return {
        "kind": f"answer, {found.saddle}",
        "wrong": [] if right else [f"{given['vary']} = {found.value!r}: {how}"],
    }
