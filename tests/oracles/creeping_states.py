"""Quasi-static paths held against a state that creeps down the force, without folds or ranks.

The reference knows the force only, written out here: at each small step of the parameter the state
moves to the next root in the direction of the force. Values lie on folds, and beside them by one
float, too.
"""

import itertools
import math
import sys

import numpy as np

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles.families import random_fixed

Array = np.ndarray
#: How far beside a value, relatively, the reference looks where the value is a fold; θ moves by its
#: square root there.
BESIDE = 1e-9


def random_path(rng: np.random.Generator, vary: str) -> tuple[ss.Parameters, str, Array]:
    """Parameters with a fold along ``vary``, if a few tries find any, and values with folds and
    their neighbours among them.
    """
    for _ in range(20):
        p = random_fixed(rng).replace(
            theta0=rng.uniform(0.1, 3.0), mu0=rng.choice([0.0, rng.uniform(0, 2)], p=[0.1, 0.9])
        )
        if rng.random() < 0.1:
            p = p.replace(alpha=0.0)
        turns = getattr(ss.folds(p, vary), vary)
        if turns.size:
            break
    low, high = {"theta0": (0.05, 3.1), "mu0": (0.0, 3.0)}.get(vary, (1e-3, 5.0))
    inner = (
        rng.uniform(low, high, rng.integers(1, 9))
        if vary in ("theta0", "mu0")
        else np.geomspace(low, high, 7)
    )
    chosen = turns[rng.random(turns.size) < 0.8]
    near = np.nextafter(chosen, rng.choice([-np.inf, np.inf], chosen.size))
    kept = [
        inner,
        chosen,
        near[rng.random(near.size) < 0.5],
        chosen * (1 + rng.choice([-3, 3], chosen.size) * 2.0**-52),
    ]
    values = np.unique(np.concatenate(kept))
    if turns.size and rng.random() < 0.3:  # start or end on a fold
        values = values[values >= turns[0]] if rng.random() < 0.5 else values[values <= turns[-1]]
        values = np.unique(np.append(values, turns[0]))
    values = values[(values > 0) & (values < (math.pi if vary == "theta0" else np.inf))]
    return p, vary, values[:: rng.choice([-1, 1])]


def check(p: ss.Parameters, vary: str, values: Array) -> tuple[int, ...]:
    """1, the number of values, of those at folds, of jumps, and of what is wrong, for one path."""
    turns = getattr(ss.folds(p, vary), vary)
    try:
        path = ss.quasi_static_path(p, vary, values)
    except ss.errors.SpragsymError as error:
        print(f"{p} along {vary} through {values.tolist()}: {error}", file=sys.stderr)
        return 1, values.size, 0, 0, 1
    near = np.array([np.any(np.abs(turns - value) <= 1e-12 * abs(value)) for value in values])
    expected = followed(p, vary, values, turns, float(path.theta[0]))
    if (
        vary not in ("mu0", "alpha") and float(p.mu0) == float(p.alpha) == 0
    ):  # rounding decides which mirror image it takes
        expected = np.where(np.cos(path.theta) * np.cos(expected) < 0, math.pi - expected, expected)
    wrong = np.abs(path.theta - expected) > np.where(near, 0.01, 1e-4)
    wrong[0] |= not _is_smallest(p, vary, values, bool(near[0]), path)
    misplaced = [
        jump for jump in path.jumps if jump.value not in turns or not _jumps(p, vary, jump, values)
    ]
    if wrong.any() or misplaced:
        print(
            f"{p} along {vary} through {values.tolist()}: {path.theta} for {expected}, {misplaced}",
            file=sys.stderr,
        )
    return 1, values.size, int(near.sum()), len(path.jumps), int(wrong.sum()) + len(misplaced)


def roots(p: ss.Parameters, vary: str, value: float) -> tuple[Array, tuple[float, ...]]:
    """Directions of all equilibria in contact, by the companion matrix, and a, b, d, m of f = a s c
    + b c + d s − m s².
    """
    values = {
        name: float(getattr(p, name)) for name in PARAMETERS if getattr(p, name) is not None
    } | {vary: value}
    theta0, mu0, kappa, alpha, sigma, beta = (values[name] for name in PARAMETERS)
    s0, c0 = math.sin(theta0), math.cos(theta0)
    plus, q = alpha + sigma, beta + 1 + sigma
    a, b, m = sigma * (q - plus), -plus * ((beta + 1) * s0 + kappa), mu0 * sigma
    d = q * alpha * c0 + mu0 * (sigma * s0 - kappa)
    t = np.roots([-b, 2 * (d - a), -4 * m, 2 * (d + a), b])
    real = t[(np.abs(t.imag) < 1e-10 * np.abs(t)) & (t.real > 0)].real
    theta = np.sort(2 * np.arctan(real))
    return theta[sigma * (s0 - np.sin(theta)) < kappa], (a, b, d, m)  # y < 0


def _creep(p: ss.Parameters, vary: str, value: float, theta: float) -> float:
    """The root that θ moves to: up where f < 0, down where f > 0, and up, where x is larger, from a
    root that is divergent.
    """
    found, (a, b, d, m) = roots(p, vary, value)
    near = found[np.abs(found - theta) < 1e-9]
    if near.size:
        at = float(near[0])
        if a * math.cos(2 * at) - b * math.sin(at) + d * math.cos(at) - m * math.sin(2 * at) > 0:
            return at
        theta = at + 1e-7
    s, c = math.sin(theta), math.cos(theta)
    above, below = found[found > theta], found[found < theta]
    upwards = a * s * c + b * c + d * s - m * s * s < 0
    return float(above[0] if upwards and above.size else below[-1] if below.size else found[0])


def followed(
    p: ss.Parameters, vary: str, values: Array, turns: Array, theta: float, steps: int = 40
) -> Array:
    """θ at each value, from θ at the first; on a fold the limit from where the path comes."""
    forward = 1.0 if values[-1] > values[0] else -1.0
    result = [theta]
    for start, end in itertools.pairwise(values):
        ends = np.array([start + forward * BESIDE * abs(start), end - forward * BESIDE * abs(end)])
        if forward * (ends[1] - ends[0]) > 0:
            marks = np.concatenate(
                [ends, turns + BESIDE * np.abs(turns), turns - BESIDE * np.abs(turns)]
            )
            marks = np.concatenate([marks, np.linspace(*ends, steps)])
            inside = marks[(forward * (marks - ends[0]) >= 0) & (forward * (ends[1] - marks) >= 0)]
            for value in np.sort(inside)[:: int(forward)]:
                theta = _creep(p, vary, float(value), theta)
            shown = theta
        elif np.any(
            (forward * (turns - start) >= 0) & (forward * (end - turns) > 0)
        ):  # from a fold to a float beside it
            theta = shown = _creep(p, vary, float(end + forward * BESIDE * abs(end)), theta)
        else:
            shown = theta
        result.append(shown)
    return np.array(result)


def _is_smallest(
    p: ss.Parameters, vary: str, values: Array, near: bool, path: ss.results.Path
) -> bool:
    """Whether the first state is the smallest of all that are stable at the first value or, for a
    fold, beside it.
    """
    first = float(values[0])
    theta0, kappa, sigma, beta = (
        first if name == vary else float(getattr(p, name))
        for name in ("theta0", "kappa", "sigma", "beta")
    )
    candidates = []
    for value in (first * (1 - BESIDE), first * (1 + BESIDE)) if near else (first,):
        found, (a, b, d, m) = roots(p, vary, value)
        slope = (
            a * np.cos(2 * found) - b * np.sin(found) + d * np.cos(found) - m * np.sin(2 * found)
        )
        stable = slope > 0
        L = (sigma * np.sin(found) + (beta + 1) * math.sin(theta0) + kappa) / (
            (beta + 1 + sigma) * np.sin(found)
        )
        candidates += np.abs(math.cos(theta0) - L * np.cos(found))[stable].tolist()
    flutters = bool(
        (ss.equilibria(p.replace(**{vary: first})).undamped == ss.EquilibriumType.FLUTTER).any()
    )
    in_truth = abs(float(path.x[0]))
    exactly_on = not near or first in getattr(ss.folds(p, vary), vary)
    if flutters or not exactly_on:
        return True
    return (
        min(abs(in_truth - size) for size in candidates) < 1e-3
        and in_truth < min(candidates) + 1e-3
    )


def _jumps(p: ss.Parameters, vary: str, jump: ss.results.Jump, values: Array) -> bool:
    """Whether the state before the jump is there on one side of its value only, and the state after
    it on the other.
    """
    forward = 1.0 if values[-1] > values[0] else -1.0
    before, after = (
        roots(p, vary, jump.value * (1 + side * forward * BESIDE))[0] for side in (-1, 1)
    )
    gap = abs(jump.before["theta"] - jump.after["theta"])
    return (
        np.abs(before - jump.before["theta"]).min() < 0.01
        and (np.abs(after - jump.before["theta"]).min() > 0.5 * gap)
        and np.abs(after - jump.after["theta"]).min() < 1e-4
    )
