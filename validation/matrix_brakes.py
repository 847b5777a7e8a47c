"""Random brakes as matrices of 10, 30 and 100 coordinates: onsets of squeal against LAPACK at 2,000
frictions and 40 digits, and certificates that were altered.

Beyond half of the cases the threshold lies just below a peak of growth, so that there are islands.
"""

import time
from itertools import pairwise
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.numerics.definite import Middle, Pencil, Series, window
from tests.oracles import brakes

CASES = 60
KINDS = ("plain", "near", "weak", "soft", "cluster")


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """What contradicts the onsets of a brake over frictions from 0 to 1."""
    n, kind = (10, 30, 100)[number % 3], KINDS[number // 3 % len(KINDS)]
    of = brakes.brake(n, int(rng.integers(1 << 31)), kind=kind)
    values = (np.arange(2000) + rng.random()) / 2000.0
    every = np.array([brakes.eigenvalues(of, mu).real for mu in values])
    threshold = 0.0
    if number % 2:
        peak = every.max(axis=1)
        inner = (peak[1:-1] > np.maximum(peak[:-2], peak[2:])) & (peak[1:-1] > 0.0)
        peaks = peak[1:-1][inner]
        threshold = 0.999 * float(rng.choice(peaks) if peaks.size else max(peak.max(), 0.0))
    m = ss.matrices(of["M"], of["K"], of["friction"], C=of["C"])
    begun = time.process_time()
    on = ss.flutter_onsets(m.Parameters(), "mu", threshold=threshold)
    seconds = time.process_time() - begun
    wrong = _against_lapack(on, values, every)
    for row in on:
        mu, omega = brakes.precise_onset(of, row["mu"], row["frequency"], threshold)
        for told, digits, error in (
            (row["mu"], mu, row["error"]),
            (row["frequency"], abs(omega), row["frequency_error"]),
        ):
            if not abs(told - digits) <= error:
                wrong.append(f"{told} is not {digits} to {error}")
    accepted, altered = _altered(of, on, threshold, rng)
    wrong += accepted
    undecided = float(np.diff(on.undecided).sum())
    if undecided > 1e-3:
        wrong.append(f"undecided: {undecided} of the range")
    return {
        "kind": f"{n}",
        "wrong": wrong,
        "onsets": len(on),
        "altered": altered,
        "incomplete": int(not on.complete),
        "undecided": undecided,
        "cpu": seconds,
    }


def _against_lapack(on: Any, values: np.ndarray, every: np.ndarray) -> list[str]:
    """Where the numbers that grow are others than those of LAPACK, and onsets that are missed."""
    wrong = []
    size = 1e-9 * np.abs(every).max()
    grows = (every > on.threshold).sum(axis=1)
    sure = (np.abs(every - on.threshold) > size).all(axis=1)
    for low, high, count in on.growing:
        here = np.flatnonzero((values > low) & (values < high) & sure & (grows != count))
        wrong += [f"{grows[i]} grow at {values[i]}, not {count}" for i in here[:1]]
    if on.complete:
        sums = {"flutter": 2, "divergence": 1}
        for (_, low, before), (high, _, after) in pairwise(on.growing):
            steps = [
                sums[row["kind"]] * (1 if row["direction"] == "up" else -1)
                for row in on
                if low - row["error"] <= row["mu"] <= high + row["error"]
            ]
            if before + sum(steps) != after:
                wrong.append(f"{before} grow below {low}, {after} above {high}, by {steps}")
    return wrong


def _altered(
    of: dict[str, Any], on: Any, threshold: float, rng: np.random.Generator
) -> tuple[list[str], int]:
    """Certificates with a wrong sign, of windows without a crossing, or that reach beyond the next
    one: those that are accepted, and how many there were.
    """
    zero = np.zeros_like(of["M"])
    pencil = Pencil(of["M"], ((1.0, of["C"]),), ((1.0, of["K"]),), zero, of["friction"])
    middle = Middle(pencil, float(rng.random()), threshold)
    signs, none = middle.values.real, np.zeros(len(middle.values), dtype=bool)
    accepted = []
    for index in rng.choice(len(signs), 3, replace=False):
        wrong = signs.copy()
        wrong[index] *= -1.0
        for free in (none, ~none):
            series = Series(middle, wrong, 9, free)
            if max(series.reach(side, 1e-3, 1e-9) for side in (-1, 1)) > 0.0:
                accepted.append(f"a wrong sign of {middle.values[index]} at {middle.t}")
        if (
            window(middle, int(index), 1e-7) is not None
            and not (abs(on.mu - middle.t) < 1e-7).any()
        ):
            accepted.append(f"a crossing of {middle.values[index]} at {middle.t}")
    beyond = np.sort(on.mu[on.mu > middle.t])[:1] - middle.t
    for away in beyond:
        if Series(middle, signs, 9, none).reach(1, 2.0 * away, 1e-9) > away + 1e-9:
            accepted.append(f"a stretch from {middle.t} beyond {middle.t + away}")
    return accepted, 9 + len(beyond)
