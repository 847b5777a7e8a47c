"""Search for points at which equilibria change, along one or two parameters of a model: one driver for all kinds, one result."""

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ..numerics import certified_roots
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals
from ..numerics.jets import Jet, variables
from ..progress import doing
from ..results.points import Ended, Points
from ..statics import stability
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.border import on_its_side, once_around
from ..statics.regions import region
from ..statics.remarks import kinds_of, of_ranges, of_region, summed
from ..statics.tie_breaking import in_order
from . import degenerate_ends
from .defining_systems import Augmented, Condition, PreciseAugmented, settled
from .families import Family

#: Boxes looked at for one search of up to three unknowns, of four, and of more, where each costs many times as much.
BUDGET, LARGE_BUDGET, COSTLY_BUDGET = 200_000, 1_000_000, 6_000
#: Boxes left that are listed one by one.
MANY = 200
#: How far beyond the border of the contact states on it are looked for.
OVER_BORDER = 1e-3


@dataclass(frozen=True)
class Found:
    """Roots of a search, the region of each of its points and whether it holds all equilibria."""

    roots: Roots
    region: FloatArray
    whole: BoolArray


def search(family: Family, condition: Condition, budget: int | None = None) -> Found:
    """All points of a kind; ``budget`` is how many boxes are looked at for one point of the parameters that do not vary."""
    balance, alone = family.balance, family.given.shape[1] == len(family.vary) == 1
    if condition.singular and is_affine(family):
        return Found(Roots.none(balance.n + len(family.vary)), *_unbounded(family))
    around, whole = _region(family, balance)
    if condition.touching and not whole.all():
        # On the border the contact's force is 0: these are states in lift-off, too.
        around, whole = _region(family, Balance(balance.model, contact=False, room=balance.room))
    limits = np.concatenate([balance.limits, np.full((2, len(family.vary)), np.inf)], axis=1)
    system, fixed = Augmented(family, condition), family.begin
    if budget is None:
        budget = BUDGET if system.n <= 3 else LARGE_BUDGET if system.n == 4 else COSTLY_BUDGET
    from_least = alone and degenerate_ends.begins(system, around)
    searched = np.concatenate([around[:, :-1], [[[-degenerate_ends.LOW]], around[1:, -1]]], axis=1) if from_least else around
    roots = certified_roots.search(system, searched, fixed, fixed, limits=limits, budget=budget)
    if from_least:
        roots = degenerate_ends.joined(degenerate_ends.searched(system, around, limits), roots)
        around = np.concatenate([around[:, :-1], [[[-degenerate_ends.LEAST]], around[1:, -1]]], axis=1)
    if alone:
        roots = settled(system, around, roots)
    roots = on_its_side(system, fixed, roots, partial(PreciseAugmented, system))
    roots = once_around(balance, roots)
    if alone:
        roots = roots.kept(left=~degenerate_ends.shared(system, roots.left))
    return Found(roots, around, whole)


def nothing(family: Family) -> Found:
    """The result of a search where it is known beforehand that there are no points."""
    return Found(Roots.none(family.balance.n + len(family.vary)), *_region(family, family.balance))


def _region(family: Family, balance: Balance) -> tuple[FloatArray, BoolArray]:
    """Coordinates and the parameters that vary, and whether that holds all equilibria."""
    around, whole = region(balance, family.over, family.asked)
    return _with_sides(family, around), whole


def _unbounded(family: Family) -> tuple[FloatArray, BoolArray]:
    points = family.given.shape[1]
    return _with_sides(family, np.full((2, family.balance.n, points), np.inf)), np.ones(points, dtype=np.bool_)


def _with_sides(family: Family, around: FloatArray) -> FloatArray:
    """With −low and high of the parameters that vary."""
    sides = np.stack([-family.spans[:, 0], family.spans[:, 1]])[:, :, None]
    return np.concatenate([around, np.broadcast_to(sides, (*sides.shape[:2], around.shape[2]))], axis=1)


def is_affine(family: Family) -> bool:
    """Whether the forces are affine in the coordinates, by structure: there is one state, none, or a line, and no two meet."""
    balance = family.balance
    if balance.springs:
        return False
    with np.errstate(all="ignore"):
        values = balance.over(family.over[:, :1])
        try:
            rows = balance.by_coordinate("forces", variables([Intervals.point(np.full(1, 0.5))] * balance.n, 2), [], values)
        except ZeroDivisionError:  # a law that has no value there
            return False
    pairs = list(itertools.combinations_with_replacement(range(balance.n), 2))
    return all(isinstance(row.derivative(*pair), int) for row in rows if isinstance(row, Jet) for pair in pairs)


def _merged(left: FloatArray) -> FloatArray:
    """Many boxes that are left as hulls of those with touching ranges of the parameter: thousands cover a line of equilibria."""
    if left.shape[2] <= MANY:
        return left
    left = left[:, :, np.argsort(-left[0, -1])]
    low, reached = -left[0, -1], np.maximum.accumulate(left[1, -1])
    return np.maximum.reduceat(left, np.flatnonzero(np.concatenate([[True], low[1:] > reached[:-1]])), axis=2)


def matrices(family: Family, z: FloatArray) -> tuple[FloatArray, ...]:
    """M, C and K, each of shape (N, n, n), at coordinates and the parameters that vary, z of shape (n + number, N)."""
    n = family.balance.n
    with np.errstate(all="ignore"):  # beyond the touch a law like Hertz's has no value
        parts = stability.linearization(family.balance, z[:n], family.at(z[n:]))
    return tuple(np.moveaxis(part, -1, 0) for part in parts)


def arranged(
    family: Family, found: Found, kind: NDArray[np.str_], more: Mapping[str, FloatArray] | None = None,
    remarks: tuple[str, ...] = (),
) -> Points:  # fmt: skip
    """The points as a result, sorted by the parameters that vary."""
    balance, vary = family.balance, family.vary
    n, middle, left = balance.n, found.roots.middle, found.roots.left
    order = in_order(np.concatenate([middle[n:], middle[:n]]), found.roots.error, found.roots.point)
    names = (*vary, *balance.coordinates)
    values: dict[str, FloatArray] = dict(zip(names, [*middle[n:, order], *middle[:n, order]], strict=True))
    values |= {name: column[order] for name, column in (more or {}).items()}
    box = np.stack([-found.region[0, :, 0], found.region[1, :, 0]], axis=-1)
    varied = dict(zip(vary, Intervals(left[:, n:]), strict=True))
    remarks += summed(kinds_of(balance, np.repeat(family.given, left.shape[2], axis=1), left, varied))
    remarks += of_region(balance, found.region[:, :n], found.whole)
    remarks += of_ranges(family.endless, box[[n + vary.index(name) for name in family.endless]])
    left = _merged(left) if len(vary) == 1 else left
    boxes_left = np.moveaxis(np.stack([-left[0], left[1]], axis=-1), 1, 0)
    return Points(
        family.p, vary, kind[order], found.roots.error[order], box, bool(found.whole.all()), family.endless, boxes_left, remarks,
        values, what_ends,
    )  # fmt: skip


def what_ends(points: Points) -> Ended:
    """What ends at folds among points that a search found."""
    from .fold_outcomes import ended  # many who ask for points never ask for this

    return ended(points)


def isolated(family: Family, condition: Condition, kind: str) -> Points:
    """Points of one condition along one parameter or in the plane of two."""
    with doing("points of the kind {} over {}", kind, " and ".join(family.vary)):
        found = search(family, condition)
    return arranged(family, found, np.full(found.roots.point.size, kind))
