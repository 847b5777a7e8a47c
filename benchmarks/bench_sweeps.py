"""What a motion of a sweep costs over its bare integration by heyoka, in processor time of one process.

``python -m benchmarks.bench_sweeps [MOTIONS_SHORT MOTIONS_LONG]`` (100 000 to τ = 10 and 10 000 to τ = 2000 unless given) prints
both, their ratio, and what the motions came to. The points are random: inclinations of 2 to 178 degrees, the article's other
values within half and twice, starts within 0.3 of x = y = 0. Bare integration is heyoka's ``propagate_until`` with the same
integrator of the same field, over all of the time, with nothing kept.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import numpy as np

import spragsym as ss
from spragsym.dynamics.with_heyoka import compiled_for
from spragsym.sweeps import Regime, rms_sweep
from spragsym.sweeps.measure import Settings, article_motions

#: Motions at a time: machines slow down and speed up, so both are timed in turn.
PART = 2500


def points_of(count: int, rng: np.random.Generator) -> tuple[ss.Parameters, dict[str, np.ndarray]]:
    """Random parameters and starts."""

    def about(value: float) -> np.ndarray:
        return value * 2 ** rng.uniform(-1, 1, count)

    p = ss.Parameters(
        theta0=np.radians(rng.uniform(2, 178, count)), mu0=about(0.5), kappa=about(0.007), alpha=about(0.007), sigma=about(0.1),
        beta=np.zeros(count),
    )  # fmt: skip
    return p, {name: rng.uniform(-0.3, 0.3, count) for name in ("x0", "y0", "vx0", "vy0")}


def bare(p: ss.Parameters, starts: dict[str, np.ndarray], t_end: float) -> float:
    """Processor time of the integration alone."""
    settings = Settings(t_end, 0.75 * t_end, 1e-10, "heyoka")
    columns = [p.theta0, p.mu0, p.kappa, p.alpha, p.sigma, p.beta, *(np.full(p.shape, v) for v in (0.5, 10.0)), *starts.values()]
    motions, _ = article_motions(settings, list(zip(*(column.tolist() for column in columns), strict=True)))
    assert motions is not None
    problems = [motions.problem(row) for row in range(len(motions))]
    begin = time.process_time()
    for problem in problems:
        compiled = compiled_for(problem)
        compiled.begin(problem)
        compiled.solver.propagate_until(t_end)
    return time.process_time() - begin


def timed(call: Callable[[], ss.Sweep]) -> tuple[ss.Sweep, float]:
    begin = time.process_time()
    found = call()
    return found, time.process_time() - begin


def main() -> None:
    """Print the table."""
    short, long = (int(text) for text in sys.argv[1:3]) if len(sys.argv) > 2 else (100_000, 10_000)
    rng = np.random.default_rng(0)
    print("| τ | motions | bare, µs a motion | sweep, µs a motion | ratio | came to |\n|---|---|---|---|---|---|")
    for t_end, count in ((10.0, short), (2000.0, long)):
        warm, starts = points_of(3, rng)
        rms_sweep(warm, 0.5, 10.0, **starts, t_end=t_end)
        rms_sweep(ss.Parameters.article(theta0=np.radians(42.0)), 0.5, 10.0)
        alone = whole = 0.0
        told = np.zeros(len(Regime), dtype=int)
        for begin in range(0, count, PART):
            p, starts = points_of(min(PART, count - begin), rng)
            alone += bare(p, starts, t_end)
            found, seconds = timed(lambda p=p, starts=starts, t_end=t_end: rms_sweep(p, 0.5, 10.0, **starts, t_end=t_end))
            whole += seconds
            told += np.bincount(found.regime, minlength=len(Regime))
        words = ", ".join(f"{number} {Regime(code).name.lower()}" for code, number in enumerate(told.tolist()) if number)
        print(
            f"| {t_end:g} | {count} | {alone / count * 1e6:.1f} | {whole / count * 1e6:.1f} | {whole / alone:.2f} | {words} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
