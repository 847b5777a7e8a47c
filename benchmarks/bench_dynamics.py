"""Motion in time, side by side: accuracy against tolerance, and a sweep against SciPy in a loop.

Prints Markdown tables of errors and ratios: absolute times depend on the machine and its load,
ratios hardly do. Run ``python -m benchmarks.bench_dynamics``; it takes a few minutes, nearly all of
them in SciPy.
"""

import inspect
import math
import time
from dataclasses import replace
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.integrate import simpson, solve_ivp

import spragsym as ss
from benchmarks.timing import timed
from spragsym.motion import integrators, return_map, simulate
from spragsym.motion.classify import classify
from spragsym.motion.problem import Problem, prepare
from spragsym.motion.sweeps import rms_sweep, sensitivity
from spragsym.motion.sweeps.workers import pool
from spragsym.motion.with_heyoka import MotionState, compiled

V, D = 0.5, 10.0  # the article states neither: our assumption
ANGLES = np.radians(np.linspace(1.0, 179.0, 181))
SOME = ANGLES[::12]
BASE = math.radians(49.0)
FLOATS = SimpleNamespace(
    sqrt=math.sqrt, exp=math.exp, sign=lambda z: math.copysign(1.0, z) if z else 0.0
)


def plain(theta0: float, rtol: float, method: str) -> float:
    """RMS of x as a user of ``solve_ivp`` gets it: the same field, over the kinks, Simpson's
    rule.
    """
    algebra = inspect.unwrap(ss.load("kang_nam").algebra.rhs)
    constants = (math.cos(theta0), math.sin(theta0), 0.5, 0.007, 0.007, 0.1, 0.0, V, D)

    def field(_: float, state: np.ndarray) -> tuple[float, ...]:
        x, y, vx, vy = state.tolist()
        return (vx, vy, *algebra(x, y, vx, vy, *constants, xp=FLOATS))

    t = np.linspace(1500.0, 2000.0, 20_001)
    run = solve_ivp(
        field, (0.0, 2000.0), [0.0] * 4, method=method, rtol=rtol, atol=rtol * 1e-3, t_eval=t
    )
    return math.sqrt(simpson(run.y[0] ** 2, x=t) / 500.0)


def sweep(
    angles: np.ndarray, rtol: float, workers: int = 1, backend: str | None = None
) -> np.ndarray:
    """The same by this package."""
    return rms_sweep(
        ss.Parameters.article(theta0=angles), V, D, rtol=rtol, workers=workers, backend=backend
    ).rms


def base_table() -> None:
    """RMS of the base case against tolerance."""
    print("## The base case, θ₀ = 49°, V = 0.5, d = 10, RMS of x over 1500 … 2000\n")
    print("| rtol | heyoka | SciPy, restarted | `solve_ivp` DOP853 | `solve_ivp` LSODA |")
    print("|---|---|---|---|---|")
    p = ss.Parameters.article(theta0=BASE)
    for rtol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13):
        ours = [
            simulate(p, V=V, d=D, rtol=rtol, backend=name).rms() for name in ("heyoka", "scipy")
        ]
        theirs = [plain(BASE, rtol, method) for method in ("DOP853", "LSODA")]
        print(
            f"| {rtol:.0e} | " + " | ".join(f"{value:.12f}" for value in (*ours, *theirs)) + " |",
            flush=True,
        )


def energy_table() -> None:
    """Drift of the energy without friction, through contact and lift-off, over 10⁴ time units."""
    print("\n## Energy without friction over 10⁴ time units, largest |change|\n")
    print("| rtol | heyoka | SciPy, restarted | events |\n|---|---|---|---|")
    p = ss.Parameters.article(theta0=BASE, mu0=0.0)
    for rtol in (1e-8, 1e-10, 1e-12, 1e-13):
        runs = [
            simulate(p, V=V, d=D, x0=0.3, y0=0.2, t_end=1e4, rtol=rtol, backend=name)
            for name in ("heyoka", "scipy")
        ]
        drift = [np.abs(tr.energy() - tr.energy()[0]).max() for tr in runs]
        print(
            f"| {rtol:.0e} | {drift[0]:.1e} | {drift[1]:.1e} | {len(runs[0].events or ())} |",
            flush=True,
        )


def error_of(values: np.ndarray, reference: np.ndarray) -> float:
    """Median over the angles of the relative error."""
    return float(np.median(np.abs(values / reference - 1)))


def sweep_table() -> None:
    """181 angles at equal measured error, one process against one and two against two."""
    print("\n## RMS against θ₀, 181 angles, t to 2000\n")
    reference = sweep(SOME, 1e-13, backend="scipy")
    sweep(SOME[:1], 1e-10)  # compile
    ours = error_of(sweep(SOME, 1e-10), reference)
    print(
        "Median relative error of the RMS on every twelfth angle, against SciPy restarted at "
        "1e-13: "
        f"{ours:.1e} here at rtol 1e-10\n"
    )
    print("| `solve_ivp` | rtol | median error | time over ours |\n|---|---|---|---|")
    unit, _ = timed(lambda: sweep(SOME, 1e-10))
    chosen: list[tuple[float, str, float]] = []
    for method in ("DOP853", "LSODA"):
        for rtol in (1e-8, 1e-10, 1e-11, 1e-12, 1e-13):
            seconds, values = timed(
                lambda method=method, rtol=rtol: np.array([plain(a, rtol, method) for a in SOME])
            )
            error = error_of(values, reference)
            print(f"| {method} | {rtol:.0e} | {error:.1e} | {seconds / unit:.0f} |", flush=True)
            if error <= ours:
                chosen.append((seconds, method, rtol))
                break
    if not chosen:
        print(
            "\n`solve_ivp` does not reach that error at any tolerance; compared at its "
            "tightest DOP853."
        )
    _, method, rtol = min(chosen, default=(0.0, "DOP853", 1e-13))
    here, one = timed(lambda: sweep(ANGLES, 1e-10))
    there, theirs = timed(lambda: np.array([plain(a, rtol, method) for a in ANGLES]))
    here_two, two = timed(lambda: sweep(ANGLES, 1e-10, workers=2))
    from benchmarks.bench_dynamics import (
        plain as by_name,
    )  # in a worker process __main__ is another module

    with pool(2) as both:
        there_two, _ = timed(
            lambda: list(both(partial(by_name, rtol=rtol, method=method), ANGLES.tolist()))
        )
    print(f"\nAll 181 angles against `solve_ivp` {method} at {rtol:.0e}, which is as accurate:\n")
    print("| | time over ours |\n|---|---|")
    print(f"| one process each | {there / here:.0f} |")
    print(f"| two processes of SciPy's, one of ours | {there_two / here:.0f} |")
    print(f"| two processes each, ours with their start | {there_two / here_two:.0f} |")
    print(f"\nSame bits from one and two processes: {bool(np.array_equal(one, two))}.")
    jump = int(np.argmax(np.diff(one)))
    print(
        f"Largest step of the RMS: {one[jump]:.3f} to {one[jump + 1]:.3f} between "
        f"{math.degrees(ANGLES[jump]):.2f}° and {math.degrees(ANGLES[jump + 1]):.2f}°; "
        f"`solve_ivp` has it there: {int(np.argmax(np.diff(theirs))) == jump}."
    )


def overhead_table() -> None:
    """What a point of a sweep costs over the integration alone, and how much of it is the judgement
    of its limit.
    """

    def fastest(function: Any, times: int) -> float:
        function()
        # Of the processor: others on the machine do not count.
        return (
            min(
                timed(lambda: [function() for _ in range(times)], time.process_time)[0]
                for _ in range(7)
            )
            / times
            * 1e6
        )

    def bare(problem: Problem) -> None:
        integrator = compiled(problem.field, problem.rtol)
        integrator.begin([MotionState(problem)], 0.0)
        integrator.solver.propagate_until(problem.t_end)

    print("\n## A point of a sweep against its integration alone, heyoka, microseconds\n")
    print(
        "| θ₀, degrees | t to | integration | measured | judged | a point of `rms_sweep` | "
        "over integration |"
    )
    print("|---|---|---|---|---|---|---|")
    for t_end, times, many in ((10.0, 200, 200), (2000.0, 5, 5)):
        for degrees in (40.0, 42.0, 49.0, 100.0):
            p = ss.Parameters.article(theta0=math.radians(degrees))
            problem = prepare(
                p.model, p.replace(V=V, d=D), start=(0, 0, 0, 0), t_end=t_end, rtol=1e-10
            )
            motions, flow = (
                [replace(problem, t_record=0.75 * t_end)],
                return_map.Onward(problem, "heyoka"),
            )
            statistics = integrators.measure(motions, "heyoka")[0]
            options = {
                "x0": np.zeros(many),
                "t_end": t_end,
                "transient": 0.75 * t_end,
                "backend": "heyoka",
            }
            alone = fastest(lambda problem=problem: bare(problem), times)
            measured = fastest(
                lambda motions=motions: integrators.measure(motions, "heyoka"), times
            )
            judged = fastest(lambda c=statistics, f=flow: classify(c, f), times)
            whole = fastest(lambda p=p, options=options: rms_sweep(p, V, D, **options), 1) / many
            print(
                f"| {degrees:g} | {t_end:g} | {alone:.0f} | {measured:.0f} | {judged:.0f} | "
                f"{whole:.0f} | {whole / alone:.2f} |",
                flush=True,
            )


def sensitivity_table() -> None:
    """Where the RMS jumps, for V and d over a decade each."""
    print("\n## The jump of the RMS against V and d: θ₀ in degrees, RMS before → after\n")
    V_axis, d_axis = 0.5 * 10 ** np.linspace(-0.5, 0.5, 5), 10.0 * 10 ** np.linspace(-0.5, 0.5, 5)
    p = ss.Parameters.article(theta0=np.radians(np.arange(36.0, 60.1, 1.0)))
    table = sensitivity(p, V_axis, d_axis, refine=5)
    print("| V \\ d | " + " | ".join(f"{d:.3g}" for d in d_axis) + " |\n" + "|---" * 6 + "|")
    for i, speed in enumerate(V_axis):
        row = zip(np.degrees(table.theta0[i]), table.before[i], table.after[i], strict=True)
        print(
            f"| {speed:.3g} | "
            + " | ".join(f"{a:.2f}: {b:.2f} → {c:.2f}" for a, b, c in row)
            + " |"
        )


def main() -> None:
    """Print all tables."""
    base_table()
    energy_table()
    sweep_table()
    overhead_table()
    sensitivity_table()


if __name__ == "__main__":
    main()
