"""Processor time of the statics of shipped models, one thread, beside the closed forms of the article's model.

``OMP_NUM_THREADS=1 python -m benchmarks.bench_models``
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

import spragsym as ss

#: Points of random parameters, and of one side of a grid.
POINTS, SIDE = 2000, 317


def seconds(work: Callable[[], Any]) -> tuple[float, Any]:
    """Processor time of a call, and what it returns."""
    begin = time.process_time()
    result = work()
    return time.process_time() - begin, result


def random_points(model: Any) -> Any:
    """Random directions and friction, all else as it is."""
    rng = np.random.default_rng(1)
    changes = {
        name: rng.uniform(0.05, high, POINTS) for name, high in (("theta0", 3.0), ("mu0", 1.5)) if name in model.parameters
    }
    return model.Parameters(**changes) if changes else model.Parameters(V=rng.uniform(0.1, 1.0, POINTS))


def table() -> None:
    """Equilibria, folds and cusps of all models."""
    print(f"{'model':16}{'equilibria, us/point':>22}{'folds theta0, s':>17}{'folds mu0, s':>14}{'cusps, s':>10}{'left open':>11}")
    for name in ("kang_nam", "damped", "stribeck", "cubic_contact", "hertz_contact", "two_springs", "inclined_belt", "trolley"):
        model = ss.load(name)
        p = random_points(model)
        spent, eq = seconds(lambda model=model, p=p: model.equilibria(p))
        one = model.Parameters(theta0=1.0)
        cells, left = [], int((~eq.decided).sum())
        for vary in ("theta0", "mu0"):
            if vary in model.parameters:
                time_of, found = seconds(lambda model=model, one=one, vary=vary: model.folds(one, vary))
                cells.append(f"{time_of:.2f}")
                left += len(found.undecided)
            else:
                cells.append("")
        if "mu0" in model.parameters and len(model.coordinates) == 2:
            time_of, found = seconds(lambda model=model, one=one: model.cusps(one, ("theta0", "mu0"), between={"mu0": (0, 2)}))
            cells.append(f"{time_of:.2f}")
            left += len(found.undecided)
        else:
            cells.append("")
        print(f"{name:16}{1e6 * spent / POINTS:22.0f}{cells[0]:>17}{cells[1]:>14}{cells[2]:>10}{left:11}", flush=True)
    p = random_points(ss.load("kang_nam"))
    closed = ss.Parameters.article(theta0=p.theta0, mu0=p.mu0)
    print(f"{'closed forms':16}{1e6 * seconds(lambda: ss.equilibria(closed))[0] / POINTS:22.1f}"
          f"{seconds(lambda: ss.folds(ss.Parameters.article()))[0]:17.3f}"
          f"{seconds(lambda: ss.folds(ss.Parameters.article(theta0=1.0), 'mu0'))[0]:14.3f}"
          f"{seconds(lambda: ss.cusps(ss.Parameters.article()))[0]:10.3f}")  # fmt: skip


def grid() -> None:
    """A grid of 10⁵ points."""
    theta0, mu0 = np.meshgrid(np.linspace(0.02, 3.12, SIDE), np.linspace(0, 1.5, SIDE), indexing="ij")
    for name in ("kang_nam", "cubic_contact"):
        model = ss.load(name)
        spent, eq = seconds(lambda model=model: model.equilibria(model.Parameters(theta0=theta0, mu0=mu0)))
        print(f"{name}: grid of {theta0.size} points in {spent:.1f} s, {int((~eq.decided).sum())} undecided")


if __name__ == "__main__":
    table()
    grid()
