"""Jump values against paths of states, certificates against samples, probabilities against plain samples and their own truth.

Run ``python -m validation.jumps [what] [number] [seed] [store] [seconds]``, with ``what`` one of values, boxes,
models, probability, coverage, samples, cluster, speed. Finished parts go to the file ``store``, and a second call goes on from there.
"""

from __future__ import annotations

import itertools
import subprocess
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.kang_nam.design.events import have_jumped
from spragsym.models.catastrophe.paths import first_end
from spragsym.parameters import NAMES
from tests.oracles import families
from validation import parts

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


def tasks(part: str) -> Iterator[tuple[ss.Parameters, float, str, float, float]]:
    """Points of both families with their values; the path goes 1 % beyond the value, or far where there is none."""
    vary, family, seed, size = part.split()
    p = getattr(families, family)(np.random.default_rng(int(seed)), int(size))
    values = np.asarray(ss.jump_value(p, vary))
    start, far = (0.0, 1e3) if vary == "mu0" else (1e-12, 3.14159)
    for i, value in enumerate(values):
        end = min(value * 1.01, far) if np.isfinite(value) else far
        if not np.isfinite(value) or start < value < end:
            yield point(p, i), float(value), vary, start, float(end)


def compared(part: str) -> dict[str, Any]:
    """How many points a part has, how many of them jump, and those that are wrong."""
    every = list(tasks(part))
    bad = [str(found) for found in map(wrong, every) if found]
    for found in bad:
        print("wrong:", found)
    return {"points": len(every), "jumping": sum(bool(np.isfinite(task[1])) for task in every), "wrong": bad}


def validate_values(number: int, seed: int = 1, store: str = "", seconds: float = np.inf) -> int:
    """How many of ``number`` random values are not the first jump of their path."""
    kinds = list(itertools.product(("mu0", "theta0"), ("random", "near_folds")))
    names = [f"{' '.join(kinds[i % 4])} {1000 * seed + i} {min(100, number - 100 * i)}" for i in range(-(-number // 100))]
    done = parts.run(names, compared, store, seconds).values()
    seen, jumping = (sum(row[key] for row in done) for key in ("points", "jumping"))
    bad = sum(len(row["wrong"]) for row in done)
    print(f"{seen} points of {number}, {jumping} with a jump, {bad} wrong")
    return bad


def speed(number: int) -> None:
    """Points a second of the processor's time, on one core."""
    p = families.random(np.random.default_rng(5), number)
    for vary in NAMES:
        ss.jump_value(p, vary)
        begin = time.process_time()
        ss.jump_value(p, vary)
        print(f"jump_value along {vary}: {number / (time.process_time() - begin):.3g} points a second")


# ------------------------------------------------------------------------------------------------------------ models

#: Two-coordinate models whose jump values have no closed forms, how far friction rises, points of a part, and of these followed
#: one by one.
MODELS, FAR, PART, FOLLOWED = ("two_springs", "cubic_contact", "inclined_belt", "hertz_contact", "damped"), 2.0, 4000, 6


def of_model(part: str) -> dict[str, Any]:
    """Points at once and one after the other by a path between all folds: how many differ, the seconds of both, and the slopes."""
    name, seed, size = part.split()
    model, rng = ss.load(name), np.random.default_rng(int(seed))
    scales = {key: model.base[key] * 2 ** rng.uniform(-1, 1, int(size)) for key in ("kappa", "sigma", "alpha")}
    p = model.Parameters(theta0=rng.uniform(0.3, 1.4, int(size)), **scales)
    begin = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ss.errors.UndecidedWarning)
        values = np.asarray(model.jump_value(p, until=FAR))
    found: dict[str, Any] = {
        "at once": time.process_time() - begin,
        "points": int(size),
        "jumping": int(np.isfinite(values).sum()),
    }
    begin, wrong, worst = time.process_time(), [], 0.0
    for i in range(FOLLOWED):
        one = model.Parameters(**{key: float(np.broadcast_to(getattr(p, key), values.shape)[i]) for key in model.parameters})
        end = first_end(model, one, "mu0", (0.0, FAR))
        off = 0.0 if end is None else abs(end.value - values[i])
        if (end is None) != np.isnan(values[i]) or off > 1e-9:
            wrong.append(f"{one}: {values[i]} for {end}")
        worst = max(worst, off)
    return found | {"one by one": (time.process_time() - begin) / FOLLOWED, "wrong": wrong, "worst": worst}


def validate_models(number: int, seed: int = 7, store: str = "", seconds: float = np.inf) -> int:
    """How many values of models without closed forms are not where the state ends that is followed."""
    names = [f"{MODELS[i % len(MODELS)]} {1000 * seed + i} {min(PART, number - PART * i)}" for i in range(-(-number // PART))]
    done = parts.run(names, of_model, store, seconds)
    print(
        "| model | points | of them jump | points a second at once | one after the other | largest difference |\n|---|---|---|---|---|---|"
    )
    for model in MODELS:
        rows = [row for name, row in done.items() if name.startswith(model)]
        if rows:
            points, jumping, spent, each = (
                sum(row[key] for row in rows) for key in ("points", "jumping", "at once", "one by one")
            )
            worst = max(row["worst"] for row in rows)
            print(f"| {model} | {points} | {jumping} | {points / spent:.3g} | {len(rows) / each:.3g} | {worst:.2g} |")
    bad = [one for row in done.values() for one in row["wrong"]]
    print(f"{FOLLOWED * len(done)} points followed one by one, {len(bad)} differ", *bad, sep="\n")
    return len(bad)


# ------------------------------------------------------------------------------------------------------------- boxes


SIZES = (0.01, 0.05, 0.2)


def certified(part: str) -> dict[str, Any]:
    """One box: its outcome, and whether a sample or a path of states contradicts it."""
    seed, i, samples = map(int, part.split())
    rng, size = np.random.default_rng([seed, i]), SIZES[i % 3]
    middle = point(families.random(np.random.default_rng(seed), i + 1), i).scalars(*NAMES)
    ends = {name: (value * (1 - size), value * (1 + size)) for name, value in zip(NAMES, middle, strict=True)}
    ends["theta0"] = ends["theta0"][0], min(ends["theta0"][1], 3.1415)
    low, high = (ss.Parameters(**{name: pair[side] for name, pair in ends.items()}) for side in (0, 1))
    begin = time.process_time()
    found = ss.certify(low, high, "no jump", max_boxes=4000)
    result = {"size": size, "outcome": found.outcome, "seconds": time.process_time() - begin, "undecided": found.undecided}
    against = False
    if found.counterexample is not None:
        inside = all(ends[name][0] <= float(getattr(found.counterexample, name)) <= ends[name][1] for name in NAMES)
        path = ss.quasi_static_path(found.counterexample, "mu0", [0.0, float(found.counterexample.mu0)])
        against = not (inside and path.jumps)
    if found.outcome == "proved":
        for _ in range(0, samples, 100_000):
            many = ss.Parameters(**{name: rng.uniform(*pair, min(samples, 100_000)) for name, pair in ends.items()})
            against |= bool((have_jumped(many) == 1).any())
    return result | {"contradicted": bool(against)}


def validate_boxes(number: int, seed: int = 2, store: str = "", seconds: float = np.inf, samples: int = 1_000_000) -> int:
    """How many certificates of random boxes of three sizes a sample or a path of states contradicts."""
    done = list(parts.run([f"{seed} {i} {samples}" for i in range(number)], certified, store, seconds).values())
    for size in SIZES:
        rows = [row for row in done if row["size"] == size]
        outcomes = Counter(row["outcome"] for row in rows)
        spent = sum(row["seconds"] for row in rows) / max(len(rows), 1)
        left = sorted(row["undecided"] for row in rows if row["outcome"] == "undecided")
        middle = f", share undecided {left[len(left) // 2]:.2g} in the middle, {left[-1]:.2g} at most" if left else ""
        print(f"±{size:.0%}: {dict(sorted(outcomes.items()))}, {spent:.2f} s of the processor a box{middle}")
    bad = sum(row["contradicted"] for row in done)
    print(f"{len(done)} boxes of {number}, {samples} samples in each that is proved, {bad} contradicted")
    return bad


# ------------------------------------------------------------------------------------------------------- probability

TOLERANCES: dict[str, Any] = {
    "theta0": (0.68, 0.72), "mu0": (0.4, 0.6), "kappa": (0.006, 0.008), "alpha": (0.006, 0.008), "sigma": (0.085, 0.115),
    "beta": (0.0, 0.02),
}  # fmt: skip


def hits(part: str) -> tuple[int, int]:
    """How many of a million plain random points jump, and how many there are."""
    rng = np.random.default_rng([*map(int, part.split())])
    p = ss.Parameters(**{name: rng.uniform(*ends, 1_000_000) for name, ends in TOLERANCES.items()})
    return int((have_jumped(p) == 1).sum()), 1_000_000


def validate_probability(number: int, seed: int = 3, store: str = "", seconds: float = np.inf) -> int:
    """Whether the interval and that of plain samples meet."""
    done = parts.run([f"{seed} {i}" for i in range(number // 1_000_000)], hits, store, seconds).values()
    many = sum(row[1] for row in done)
    share = sum(row[0] for row in done) / many
    error = (share * (1 - share) / many) ** 0.5
    found = ss.jump_probability(TOLERANCES, n=1 << 17, rng=4)
    print(f"plain: {share:.6f} ± {1.96 * error:.6f} of {many}; interval: {found.low:.6f} to {found.high:.6f} of {found.n}")
    print({name: f"{found.first[name]:.3f} {found.total[name]:.3f}" for name in found.first})
    return int(not found.low - 2 * error < share < found.high + 2 * error)


def studied(part: str) -> tuple[float, float]:
    """The interval of one study; the one numbered −1 has 2¹⁸ points."""
    seed, i = map(int, part.split())
    n, rng = (1 << 18, seed) if i < 0 else (4096, 1000 * seed + i)
    found = ss.jump_probability(TOLERANCES, n=n, rng=rng, sobol=False)
    return found.low, found.high


def validate_coverage(studies: int, seed: int = 5, store: str = "", seconds: float = np.inf) -> int:
    """How many studies' intervals hold what a study of 2¹⁸ points says."""
    truth, *found = parts.run([f"{seed} {i}" for i in range(-1, studies)], studied, store, seconds).values()
    middle = 0.5 * (truth[0] + truth[1])
    held = sum(low <= middle <= high for low, high in found)
    print(f"truth {middle:.6f} ± {(truth[1] - truth[0]) / 2:.6f}; {held} of {len(found)} intervals hold it")
    return int(held < 0.88 * len(found))


def memory() -> float:
    """Largest memory that this process has had, in megabytes."""
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def validate_samples(number: int, seed: int = 6, store: str = "", seconds: float = np.inf) -> int:
    """Rate and memory of one study that is killed when a part of it is done, and gone on with; 10⁹ is its full size."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(store) if store else Path(folder) / "samples.json"
        journal = Path(f"{path}.partial")
        call = f"ss.jump_probability(v.TOLERANCES, n={number}, rng={seed}, sobol=False, store={str(path)!r})"
        child = subprocess.Popen([sys.executable, "-c", f"import spragsym as ss, validation.jumps as v; {call}"])
        while child.poll() is None and not (journal.is_file() and len(journal.read_bytes().splitlines()) > 16):
            time.sleep(0.1)
        child.kill()
        child.wait()
        kept = len(journal.read_bytes().splitlines()) - 1 if journal.is_file() else 0
        begin = time.process_time()
        found = ss.jump_probability(TOLERANCES, n=number, rng=seed, sobol=False, store=path)
        spent = time.process_time() - begin
        again = ss.jump_probability(TOLERANCES, n=number, rng=seed, sobol=False) if number <= 1 << 22 else found
    print(f"killed with {kept} parts done; the rest took {spent:.1f} s of the processor, at most {memory():.0f} MB")
    print(f"{found.low:.6f} to {found.high:.6f} of {found.n}; {'the same' if again == found else 'not the same'} without a kill")
    return int(again != found)


def validate_cluster(number: int, seed: int = 4, **_: Any) -> int:
    """Whether a dask cluster of two local processes, chunk by chunk, gives the bits of one process."""
    from dask.distributed import Client, LocalCluster

    alone = ss.jump_probability(TOLERANCES, n=number, rng=seed)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        there = ss.jump_probability(TOLERANCES, n=number, rng=seed, workers=client.map)
    same = repr(alone) == repr(there)
    print(f"{number} points on a cluster: {'the same bits' if same else f'{there} for {alone}'}")
    return int(not same)


CHECKS: dict[str, tuple[Callable[..., int], int]] = {
    "values": (validate_values, 100_000),
    "models": (validate_models, 4000),
    "boxes": (validate_boxes, 200),
    "probability": (validate_probability, 100_000_000),
    "coverage": (validate_coverage, 100),
    "samples": (validate_samples, 1_000_000_000),
    "cluster": (validate_cluster, 1 << 13),
}


def main(what: str = "values", number: str = "", seed: str = "", store: str = "", seconds: str = "inf") -> int:
    """Run one check, or the measurement of speed; 1 if it fails."""
    if what == "speed":
        speed(int(number or 100_000))
        return 0
    check, size = CHECKS[what]
    more = {"seed": int(seed)} if seed else {}
    return int(check(int(number or size), store=store, seconds=float(seconds), **more) > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:6]))
