"""Motion on machines without heyoka: the compiled DOP853 beside it, in processor time, digits, events and bits.

``python -m benchmarks.bench_without_heyoka [N]``: N inclinations from 1° to 179°, 61 by default, V = 0.5, d = 10, time to 2000; a
Markdown table. Times are ratios of processor time, the best of three turns, so that other load hardly counts. Errors and events are
those of a motion to time 60, before neighbouring motions part, against SciPy at rtol 1e-13. SciPy's own time, where there is neither
heyoka nor a compiler, is of every sixth inclination.
"""

from __future__ import annotations

import sys
import time
from functools import partial

import numpy as np

import spragsym as ss
from spragsym.dynamics import simulate
from spragsym.sweeps import rms_sweep

V, D, SHORT = 0.5, 10.0, 60.0
BACKENDS = ("heyoka", "compiled")
#: SciPy alone takes every this many inclinations, in one turn.
FEW = 6


def sweep(angles: np.ndarray, rtol: float, backend: str, workers: int = 1) -> np.ndarray:
    """RMS of x at every inclination."""
    return rms_sweep(ss.Parameters.article(theta0=angles), V, D, rtol=rtol, workers=workers, backend=backend).rms


def processor_times(angles: np.ndarray, rtol: float, backends: tuple[str, ...], turns: int) -> dict[str, float]:
    """Seconds of a sweep on each backend."""
    works = {name: partial(sweep, angles, rtol, name) for name in backends}
    for name in backends:
        sweep(angles[:1], rtol, name)  # compiled before the clock runs
    best = dict.fromkeys(backends, np.inf)
    for _ in range(turns):
        for name, work in works.items():
            begin = time.process_time()
            work()
            best[name] = min(best[name], time.process_time() - begin)
    return best


def compared(angles: np.ndarray, rtol: float, backend: str) -> tuple[int, float]:
    """Motions with other events than the reference, and the largest error of a state at the end."""
    other, worst = 0, 0.0
    for angle in angles:
        p = ss.Parameters.article(theta0=float(angle))
        run, exact = (
            simulate(p, V=V, d=D, t_end=SHORT, rtol=tolerance, backend=name)
            for tolerance, name in ((rtol, backend), (1e-13, "scipy"))
        )
        kinds, expected = (() if it.events is None else it.events.which for it in (run, exact))
        other += not np.array_equal(kinds, expected)
        worst = max(worst, float(np.abs(run.state[:, -1] - exact.state[:, -1]).max()))
    return other, worst


def main(n: int = 61) -> int:
    """Print the table; 1 if the compiled integrator takes more than three times as long, or its bits depend on the workers."""
    angles = np.radians(np.linspace(1.0, 179.0, n))
    print(f"{n} inclinations. Errors and events of every sixth.\n")
    print(
        "| rtol | processor time over heyoka's | SciPy's | other events: heyoka | compiled | largest error: heyoka | compiled |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|")
    slow = False
    for rtol in (1e-6, 1e-8, 1e-10):
        spent = processor_times(angles, rtol, BACKENDS, 3)
        ratio = spent["compiled"] / spent["heyoka"]
        alone = processor_times(angles[::FEW], rtol, ("heyoka", "scipy"), 1)
        slow |= ratio > 3
        (events, error), (events_here, error_here) = (compared(angles[::6], rtol, name) for name in BACKENDS)
        print(
            f"| {rtol:.0e} | {ratio:.1f} | {alone['scipy'] / alone['heyoka']:.0f} | {events} | {events_here} | {error:.1e} | {error_here:.1e} |",
            flush=True,
        )
    one, two, three = (sweep(angles, 1e-8, "compiled", workers) for workers in (1, 2, 3))
    same = bool(np.array_equal(one, two) and np.array_equal(one, three))
    print(f"\nThe same bits from one, two and three workers: {same}.")
    return int(slow or not same)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:2])))
