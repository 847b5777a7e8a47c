"""What a motion of a sweep costs over its bare integration by heyoka, in processor time of one process.

``python -m benchmarks.bench_sweeps [MOTIONS_SHORT MOTIONS_LONG]`` (100 000 to τ = 10 and 10 000 to τ = 2000 unless given) prints
both, their ratio, and what the motions came to. The points are random: inclinations of 2 to 178 degrees, the article's other
values within half and twice, starts within 0.3 of x = y = 0. Bare integration is heyoka's ``propagate_until`` of one motion after
the other with the same field and tolerance, its kinks located, over all of the time, with nothing kept or measured. "In lanes" is
the same for eight motions at a time, which is how a sweep integrates: the sweep is measured against either. A last table says
which parts of a sweep take how long, and how much memory a single motion takes, the longer it is.
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.dynamics import batch_heyoka, classify, cycles, flows
from spragsym.dynamics.motions import Motions
from spragsym.dynamics.with_heyoka import compiled_for
from spragsym.sweeps import Regime, rms_sweep
from spragsym.sweeps.measure import Settings

#: Motions at a time: machines slow down and speed up, so both are timed in turn.
PART = 20_000


def points_of(count: int, rng: np.random.Generator) -> tuple[ss.Parameters, dict[str, np.ndarray]]:
    """Random parameters and starts."""

    def about(value: float) -> np.ndarray:
        return value * 2 ** rng.uniform(-1, 1, count)

    p = ss.Parameters(
        theta0=np.radians(rng.uniform(2, 178, count)), mu0=about(0.5), kappa=about(0.007), alpha=about(0.007), sigma=about(0.1),
        beta=np.zeros(count),
    )  # fmt: skip
    return p, {name: rng.uniform(-0.3, 0.3, count) for name in ("x0", "y0", "vx0", "vy0")}


def motions_of(p: ss.Parameters, starts: dict[str, np.ndarray], t_end: float) -> Motions:
    """The motions of points, to be integrated alone."""
    settings = Settings(t_end, 0.75 * t_end, 1e-10, "heyoka")
    columns = [p.theta0, p.mu0, p.kappa, p.alpha, p.sigma, p.beta, *(np.full(p.shape, v) for v in (0.5, 10.0)), *starts.values()]
    found, _ = p.model.motions(settings, list(zip(*(column.tolist() for column in columns), strict=True)))
    assert found is not None
    return found


def bare(motions: Motions) -> float:
    """Processor time of the integration alone, of one motion after the other."""
    problems = [motions.problem(row) for row in range(len(motions))]
    begin = time.process_time()
    for problem in problems:
        compiled = compiled_for(problem)
        compiled.begin(problem)
        compiled.solver.propagate_until(problem.t_end)
    return time.process_time() - begin


def in_lanes(motions: Motions) -> float:
    """The same in lanes."""
    begin = time.process_time()
    batch_heyoka.ends(motions)
    return time.process_time() - begin


def timed(call: Callable[[], ss.Sweep]) -> tuple[ss.Sweep, float]:
    begin = time.process_time()
    found = call()
    return found, time.process_time() - begin


def compared(t_end: float, count: int, rng: np.random.Generator) -> None:
    """Print a row of the first table."""
    warm, starts = points_of(3, rng)
    rms_sweep(warm, 0.5, 10.0, **starts, t_end=t_end)
    rms_sweep(ss.Parameters.article(theta0=np.radians(42.0)), 0.5, 10.0)
    alone = together = whole = 0.0
    told = np.zeros(len(Regime), dtype=int)
    for begin in range(0, count, PART):
        p, starts = points_of(min(PART, count - begin), rng)
        motions = motions_of(p, starts, t_end)
        alone += bare(motions)
        together += in_lanes(motions)
        found, seconds = timed(lambda p=p, starts=starts: rms_sweep(p, 0.5, 10.0, **starts, t_end=t_end))
        whole += seconds
        told += np.bincount(found.regime, minlength=len(Regime))
    words = ", ".join(f"{number} {Regime(code).name.lower()}" for code, number in enumerate(told.tolist()) if number)
    times = " | ".join(f"{seconds / count * 1e6:.1f}" for seconds in (alone, together, whole))
    print(f"| {t_end:g} | {count} | {times} | {whole / alone:.2f} | {whole / together:.2f} | {words} |", flush=True)


#: Parts of a sweep that are timed: where a function stands, its name, and what it does.
PARTS: tuple[tuple[Any, str, str], ...] = (
    (batch_heyoka, "watch", "integration in lanes, with all that is measured on the way"),
    (batch_heyoka.Lanes, "carry", "of all integration in lanes: heyoka, and filling and emptying the lanes"),
    (classify, "wells_of", "wells of the energy above the belt"),
    (classify, "at_rest", "rest"),
    (cycles, "_orbit", "closed orbits"),
    (flows, "nearly_closed", "of that: Newton's method on the plain flow, rough and fine"),
    (flows, "closed_orbit", "of that: the derivative of the return, once"),
    (cycles, "_nears", "whether the motion nears its cycle"),
    (cycles, "_described", "averages over the cycle"),
)


def parts(t_end: float, count: int, rng: np.random.Generator) -> None:
    """Print what the parts of a sweep take."""
    p, starts = points_of(count, rng)
    spent = {words: 0.0 for _, _, words in PARTS}
    former = [(place, name, getattr(place, name)) for place, name, _ in PARTS]

    def clocked(function: Callable[..., Any], words: str) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            begin = time.process_time()
            try:
                return function(*arguments, **options)
            finally:
                spent[words] += time.process_time() - begin

        return call

    for place, name, words in PARTS:
        setattr(place, name, clocked(getattr(place, name), words))
    try:
        _, seconds = timed(lambda: rms_sweep(p, 0.5, 10.0, **starts, t_end=t_end))
    finally:
        for place, name, function in former:
            setattr(place, name, function)
    for words, part in [("everything", seconds), *spent.items()]:
        print(f"| {t_end:g} | {words} | {part / count * 1e6:.1f} |", flush=True)


def memory() -> None:
    """Print what a single motion takes, the longer it is; all of it is measured."""
    p, starts = points_of(1, np.random.default_rng(0))
    for t_end in (2e3, 2e4, 2e5):
        motions = motions_of(p, starts, t_end)
        batch_heyoka.watch(motions)  # compiled
        tracemalloc.start()
        found = batch_heyoka.watch(replace(motions, t_record=0.0))
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        print(f"| {t_end:g} | {found.maxima[0]} | {peak / 1e6:.1f} |", flush=True)


def main() -> None:
    """Print the tables."""
    short, long = (int(text) for text in sys.argv[1:3]) if len(sys.argv) > 2 else (100_000, 10_000)
    rng = np.random.default_rng(0)
    print(
        "| τ | motions | bare, µs a motion | in lanes | sweep | over bare | over lanes | came to |\n|---|---|---|---|---|---|---|---|"
    )
    for t_end, count in ((10.0, short), (2000.0, long)):
        compared(t_end, count, rng)
    print("\n| τ | part | µs a motion |\n|---|---|---|")
    for t_end, count in ((10.0, min(short, PART)), (2000.0, min(long, 500))):
        parts(t_end, count, rng)
    print("\n| τ of one motion | maxima kept | peak, MB |\n|---|---|---|")
    memory()


if __name__ == "__main__":
    main()
