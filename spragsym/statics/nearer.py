"""States in what a search has left undecided: by a search of a smaller box, and by Newton's method.

The smaller box is the base turn of angles, and up to the largest length of the model about the
origin along other coordinates. What Newton's method finds in undecided boxes is proved to be a
state; that there is no other is not.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from ..numerics import contractors
from ..numerics.certified_roots import Roots, distinct
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    width_of,
)
from .balance import Balance
from .precise_balance import clusters, on_side, refined
from .regions import lengths

#: A search at all points: of parameters (P, N) in boxes (2, n, N).
Search: TypeAlias = Callable[[Balance, FloatArray, FloatArray], Roots]
#: The remark on undecided boxes that were searched so.
FOUND = (
    "what Newton's method found in undecided boxes, in the base turn of angles and near the origin "
    "first, is listed: found and proved to be states, not proved to be all"
)


def nearer(balance: Balance, given: FloatArray, box: FloatArray, search: Search) -> Roots:
    """Roots at all points by ``search``, and in what it leaves undecided by the smaller box and by
    Newton's method.
    """
    found = search(balance, given, box)
    rows = np.unique(found.undecided_point[_wide(found.undecided)])
    if not rows.size:
        return found
    with quiet():
        small = np.minimum(box[:, :, rows], _near(balance, given[:, rows]))
    inner = search(balance, given[:, rows], small).numbered(rows)
    around = np.full(box.shape, -np.inf)
    around[:, :, rows] = small
    inside = contractors.within(found.undecided, around[:, :, found.undecided_point])
    found = found.select(undecided=~inside)
    found = distinct(found.concatenated(inner.select(undecided=~_covered(inner, found))))
    for row in rows.tolist():
        found = _by_newton(balance, given, found, row, around[:, :, row])
    return found


def _covered(inner: Roots, found: Roots) -> BoolArray:
    """Undecided boxes that lie in one of ``found`` at the same point, which says as much."""
    covered = np.zeros(inner.undecided_point.size, dtype=bool)
    for k, point in enumerate(inner.undecided_point.tolist()):
        others = found.undecided[:, :, found.undecided_point == point]
        covered[k] = contractors.within(inner.undecided[:, :, [k]], others).any()
    return covered


def _wide(boxes: FloatArray) -> BoolArray:
    """Boxes so wide that a search has ended before it came to them."""
    wide: BoolArray = (width_of(boxes) > 1e-3 * scale_of(boxes).max(axis=0)).any(axis=0)
    return wide


def _near(balance: Balance, given: FloatArray) -> FloatArray:
    """The smaller boxes, (2, n, N)."""
    ends = np.repeat(lengths(balance, Intervals.point(given))[None], balance.n, axis=0)
    turns = [balance.model.is_angle(name) for name in balance.coordinates]
    ends[turns] = np.pi
    return np.stack([ends, ends])


def _by_newton(
    balance: Balance, given: FloatArray, found: Roots, point: int, near: FloatArray
) -> Roots:
    """The result with states of one point that Newton's method finds in wide undecided boxes, from
    their middles and from random places in boxes between the smaller one and their hull, on the
    contacts' side.
    """
    boxes = found.undecided[:, :, (found.undecided_point == point) & _wide(found.undecided)]
    if not boxes.shape[2]:
        return found
    starts, rng = 2000, np.random.default_rng(0)
    largest = np.argsort(-width_of(boxes).max(axis=0), kind="stable")[:starts]
    hull, share = Intervals(boxes.max(axis=2)[:, :, None]), np.linspace(0.0, 1.0, starts)
    inner = Intervals(near[:, :, None])
    middle = (1 - share) * inner.middle + share * hull.middle
    parameters = balance.prepared_at(given[:, [point]])
    with quiet():
        reach = inner.width ** (1 - share) * hull.width**share
        places = middle + rng.uniform(-0.5, 0.5, middle.shape) * reach
        repeated = Intervals(np.repeat(parameters.ends, starts, axis=2))
        places = places[:, on_side(balance, repeated, ends_around(places, 0 * places))[0]]
        before = q = np.concatenate([Intervals(boxes[:, :, largest]).middle, places], axis=1)
        for _ in range(6):  # of four steps each
            before, q = q, balance.guessed(q, parameters)
        settled = (np.abs(q - before) <= 1e-9 * scale_of(q)).all(axis=0)
        q = q[:, settled]
        ends = ends_around(q, 0 * q)
        ends = ends[:, :, contractors.within(ends, hull.ends)]
    hulls, _ = clusters(ends, np.zeros(ends.shape[2], dtype=int))
    middle = Intervals(hulls).middle
    around = ends_around(middle, 1e-6 * scale_of(middle))
    tried = Roots.at(around, point=np.full(middle.shape[1], point))
    tried = refined(balance, given, tried)
    # A root that was proved may lie elsewhere than where it was looked for, or beyond a border.
    there = (tried.ends < around).all(axis=(0, 1)) & (width_of(tried.ends) >= 0).all(axis=0)
    tried = tried.select(there & (tried.error <= balance.options.tolerance))
    repeated = Intervals(np.repeat(parameters.ends, tried.point.size, axis=2))
    tried = tried.select(on_side(balance, repeated, tried.ends)[0])
    return distinct(found.concatenated(tried))
