"""Jump values against paths of states, certificates against samples, probabilities against plain samples and their own truth.

Run ``python -m benchmarks.validate_jumps [what] [number] [seed]``, with ``what`` one of values, boxes, probability, coverage, speed.
"""

from __future__ import annotations

import itertools
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import numpy as np

import spragsym as ss
from benchmarks import families
from spragsym.parameters import NAMES

#: Of a jump that is right, relative.
CLOSE = 1e-11


def point(p: ss.Parameters, i: int) -> ss.Parameters:
    """One of many points."""
    return ss.Parameters(**{name: float(getattr(p, name)[i]) for name in NAMES})


# ------------------------------------------------------------------------------------------------------------ values


def wrong(task: tuple[ss.Parameters, float, str, float, float]) -> tuple[Any, ...] | None:
    """A point whose value is not the first jump of its path of states; None if it is."""
    q, value, vary, start, end = task
    jumps = [jump.value for jump in ss.quasi_static_path(q, vary, [start, end]).jumps[:1]]
    if np.isnan(value):
        return (q, vary, value, jumps) if jumps else None
    right = bool(jumps) and abs(jumps[0] - value) <= CLOSE * max(1.0, value)
    return None if right else (q, vary, value, jumps)


def tasks(number: int, seed: int) -> Iterator[tuple[ss.Parameters, float, str, float, float]]:
    """Points of both families, with their values; the path goes 1 % beyond the value, or far where there is none."""
    rng = np.random.default_rng(seed)
    for vary, family in itertools.cycle(itertools.product(("mu0", "theta0"), (families.random, families.near_folds))):
        size = min(number, 2000)
        p = family(rng, size)
        values = np.asarray(ss.jump_value(p, vary))
        start = 0.0 if vary == "mu0" else 1e-12
        far = 1e3 if vary == "mu0" else 3.14159
        for i in range(size):
            end = min(values[i] * 1.01, far) if np.isfinite(values[i]) else far
            if not np.isfinite(values[i]) or start < values[i] < end:
                yield point(p, i), float(values[i]), vary, start, float(end)
        number -= size
        if not number:
            return


def validate_values(number: int, seed: int = 1) -> int:
    """How many of ``number`` random values are not the first jump of their path."""
    begin = time.perf_counter()
    bad, seen, jumping = 0, 0, 0
    with ProcessPoolExecutor() as pool:
        for found, task in zip(pool.map(wrong, tasks(number, seed), chunksize=50), tasks(number, seed), strict=True):
            seen, jumping = seen + 1, jumping + bool(np.isfinite(task[1]))
            if found:
                bad += 1
                print("wrong:", *found)
            if seen % 1000 == 0:
                print(f"{seen} points, {jumping} with a jump, {bad} wrong", flush=True)
    print(f"{seen} points, {jumping} with a jump, {bad} wrong, in {time.perf_counter() - begin:.0f} s")
    return bad


def speed(number: int) -> None:
    """Points a second of the processor's time, on one core."""
    p = families.random(np.random.default_rng(5), number)
    for vary in NAMES:
        ss.jump_value(p, vary)
        begin = time.process_time()
        ss.jump_value(p, vary)
        print(f"jump_value along {vary}: {number / (time.process_time() - begin):.3g} points a second")


# ------------------------------------------------------------------------------------------------------------- boxes


def validate_boxes(number: int, seed: int = 2, samples: int = 1_000_000) -> int:
    """How many certificates of random boxes of three sizes a sample or a path of states contradicts."""
    rng = np.random.default_rng(seed)
    p = families.random(rng, number)
    outcomes: Counter[tuple[str, float, str]] = Counter()
    seconds: Counter[tuple[str, float]] = Counter()
    left: dict[float, list[float]] = {}
    bad = 0
    for i in range(number):
        size = (0.01, 0.05, 0.2)[i % 3]
        ends = {
            name: (value * (1 - size), value * (1 + size)) for name, value in zip(NAMES, point(p, i).scalars(*NAMES), strict=True)
        }
        ends["theta0"] = ends["theta0"][0], min(ends["theta0"][1], 3.1415)
        low, high = (ss.Parameters(**{name: pair[side] for name, pair in ends.items()}) for side in (0, 1))
        begin = time.process_time()
        found = ss.certify(low, high, "no jump", max_boxes=4000)
        seconds["no jump", size] += time.process_time() - begin
        outcomes["no jump", size, found.outcome] += 1
        if found.outcome == "undecided":
            left.setdefault(size, []).append(found.undecided)
        if found.outcome == "refuted":
            assert found.counterexample is not None
            bad += not ss.quasi_static_path(found.counterexample, "mu0", [0.0, float(found.counterexample.mu0)]).jumps
        if found.outcome == "proved":
            for _ in range(0, samples, 100_000):
                inside = ss.Parameters(**{name: rng.uniform(*pair, min(samples, 100_000)) for name, pair in ends.items()})
                bad += bool((ss.jump_value(inside) <= inside.mu0).any())
    for key, count in sorted(outcomes.items()):
        print(*key, count)
    for (claim, size), total in seconds.items():
        boxes = sum(count for key, count in outcomes.items() if key[:2] == (claim, size))
        print(
            f"{claim}, ±{size:.0%}: {total / boxes:.2f} s of the processor a box; undecided shares",
            *(f"{v:.2g}" for v in left.get(size, [])),
        )
    print(f"{number} boxes, {samples} samples in each that is proved, {bad} contradicted")
    return bad


# ------------------------------------------------------------------------------------------------------- probability

TOLERANCES: dict[str, Any] = {
    "theta0": (0.68, 0.72), "mu0": (0.4, 0.6), "kappa": (0.006, 0.008), "alpha": (0.006, 0.008), "sigma": (0.085, 0.115),
    "beta": (0.0, 0.02),
}  # fmt: skip


def plain(number: int, seed: int) -> tuple[float, float]:
    """The share of plain random points that jump, and its standard error."""
    rng = np.random.default_rng(seed)
    hits = 0
    for begin in range(0, number, 1_000_000):
        size = min(1_000_000, number - begin)
        p = ss.Parameters(**{name: rng.uniform(*ends, size) for name, ends in TOLERANCES.items()})
        hits += int((ss.jump_value(p) <= p.mu0).sum())
    share = hits / number
    return share, (share * (1 - share) / number) ** 0.5


def validate_probability(number: int, seed: int = 3) -> int:
    """Whether the interval and that of plain samples meet."""
    share, error = plain(number, seed)
    found = ss.jump_probability(TOLERANCES, n=1 << 17, rng=4)
    print(f"plain: {share:.6f} ± {1.96 * error:.6f} of {number}; interval: {found.low:.6f} to {found.high:.6f} of {found.n}")
    print({name: f"{found.first[name]:.3f} {found.total[name]:.3f}" for name in found.first})
    return int(not found.low - 2 * error < share < found.high + 2 * error)


def validate_coverage(studies: int, seed: int = 5) -> int:
    """How many studies' intervals hold what a study of 2¹⁸ points says."""
    truth = ss.jump_probability(TOLERANCES, n=1 << 18, rng=seed, sobol=False)
    found = [ss.jump_probability(TOLERANCES, n=4096, rng=1000 * seed + i, sobol=False) for i in range(studies)]
    held = sum(one.low <= truth.probability <= one.high for one in found)
    print(f"truth {truth.probability:.6f} ± {(truth.high - truth.low) / 2:.6f}; {held} of {studies} intervals hold it")
    return int(held < 0.88 * studies)


CHECKS: dict[str, tuple[Callable[..., int], int]] = {
    "values": (validate_values, 100_000),
    "boxes": (validate_boxes, 200),
    "probability": (validate_probability, 100_000_000),
    "coverage": (validate_coverage, 100),
}


def main(what: str = "values", number: str = "", *seed: str) -> int:
    """Run one check, or the measurement of speed; 1 if it fails."""
    if what == "speed":
        speed(int(number or 100_000))
        return 0
    check, size = CHECKS[what]
    return int(check(int(number or size), *map(int, seed)) > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
