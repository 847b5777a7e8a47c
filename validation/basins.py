"""Points of stable manifolds by simulations of another integrator: on the boundary of a basin, or not.

``python -m validation.basins FILE [N]``: N points (100 unless given) of ``basin_boundary`` at random parameters where there are
three equilibria. Finished curves stand in FILE, one a line, and the same command goes on from there. To either side of a point,
1e-6 across the curve, motions are followed by DOP853 over 40 000 time units: at a boundary their averages differ by far more than
they change; where both sides are said to come to one attractor, they agree.
"""

from __future__ import annotations

import itertools
import sys
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from validation.fates import ALIKE, apart, differ, settled
from validation.parts import numbered

ASIDE = 1e-6
#: Words for a side of which it is not known what it comes to.
OPEN = ("nothing", "as rounding decides", "nearer by")


def drawn(number: int) -> ss.Parameters:
    """Parameters with three equilibria."""
    rng = np.random.default_rng([29, number])
    while True:
        mu0, V, d = rng.uniform(0.3, 0.9), rng.uniform(0.2, 0.6), rng.uniform(4.0, 12.0)
        p = ss.Parameters.article(mu0=mu0, V=V, d=d)
        edges = ss.folds(p.replace(mu0=ss.sliding_friction(mu0, V, d))).theta0
        if len(edges) == 2:  # there are three below the lower fold
            low = float(edges.min())
            return p.replace(theta0=rng.uniform(max(low - 0.3, 0.05), low))


def examined(number: int) -> dict[str, Any]:
    """One curve: of each point whether it is said to be boundary, what either side comes to, and whether that is confirmed."""
    p = drawn(number)
    line: dict[str, Any] = {"number": number, "points": []}
    try:
        found = ss.basin_boundary(p, step=0.05, points=2)
    except (ss.ParameterError, ss.ConvergenceError) as error:
        return line | {"said": str(error)}
    values = dict(zip(p.ranges, p.scalars(*p.ranges), strict=True))
    for i, point in enumerate(found.points):
        along = found.points[min(i + 1, len(found.points) - 1)] - found.points[max(i - 1, 0)]
        across = np.array([-along[1], along[0]]) / np.linalg.norm(along)
        starts = [[x, 0.0, vx, 0.0] for x, vx in (point + sign * ASIDE * across for sign in (-1, 1))]
        sides = [settled(values, start)[0] for start in starts]
        off, within = apart(*sides)
        told = found.sides[i].tolist()
        open_ = any(word in text for text in told for word in OPEN)
        right = differ(*sides) if found.boundary[i] else open_ or off < max(3 * within, ALIKE)
        line["points"].append(
            {"boundary": bool(found.boundary[i]), "sides": told, "confirmed": bool(right), "off": off, "within": within}
        )
    return line


def main() -> None:
    """Go through the points; exit code 1 if one is not confirmed."""
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    lines = numbered(
        Path(sys.argv[1]), itertools.count(), examined, lambda lines: sum(len(line["points"]) for line in lines) >= count
    )
    points = [point for line in lines for point in line["points"]]
    print("| what is said | points | confirmed |\n|---|---|---|")
    for name, chosen in (
        ("boundary", [point for point in points if point["boundary"]]),
        ("manifold, one attractor on both sides", [
            point for point in points if not point["boundary"] and not any(word in text for text in point["sides"] for word in OPEN)
        ]),
        ("undecided", [point for point in points if any(word in text for text in point["sides"] for word in OPEN)]),
    ):  # fmt: skip
        print(f"| {name} | {len(chosen)} | {sum(point['confirmed'] for point in chosen)} |")
    sys.exit(any(not point["confirmed"] for point in points))


if __name__ == "__main__":
    main()
