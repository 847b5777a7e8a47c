"""All roots of others' small systems: number of roots, accuracy, boxes and processor time of the search.

``python -m benchmarks.bench_boxes``
"""

from __future__ import annotations

import time

import numpy as np

from spragsym.exact import boxes, certified_roots
from tests.oracles.box_problems import PROBLEMS, Problem


def measure(problem: Problem) -> str:
    """One line."""
    none = np.zeros((0, 1))
    begin = time.process_time()
    outcome = boxes.search(problem, problem.ends, none, none, budget=10**7)
    found = certified_roots.roots(problem, outcome, problem.ends, none, none)
    seconds = time.process_time() - begin
    return (
        f"{problem.title:22}{found.point.size:6}/{problem.roots:<6}{found.left_point.size:10}{found.error.max(initial=0):12.1e}"
        f"{outcome.looks:12}{seconds:10.3f}"
    )


def main() -> None:
    """Print the table."""
    print(f"{'':22}{'roots':>10}{'undecided':>13}{'error':>12}{'boxes':>12}{'seconds':>10}")
    for problem in PROBLEMS:
        print(measure(problem), flush=True)


if __name__ == "__main__":
    main()
