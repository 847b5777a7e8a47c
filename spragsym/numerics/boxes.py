"""All roots of small systems in a region, proved: branch and prune, over many boxes and many points of parameters at once.

A pair of a box of unknowns and a node of the tree of points is taken from a stack, thousands at a time. Whatever
:mod:`spragsym.numerics.contractors` proves of it holds for all points of the node: so it is dropped, or decided for all of them.
What is not decided is halved: the box where the width of the unknowns is what keeps it open, the node where the spread of the
parameters is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import contractors
from .interval_arrays import BoolArray, FloatArray, IntArray, Intervals, matrix, stacked
from .jets import constant, gradient, variables
from .parameter_tree import Tree, tree

#: Pairs looked at in one go: enough to forget the calls' overhead, few enough to stay in the cache.
CHUNK = 2048
#: Pieces that the region is cut into at once for no more points than these: a look at one box costs as much as at a few.
PIECES, FEW_POINTS = 16, 4
#: By how much of its width a box is widened before it is asked for a root: so roots on its border are inside of it.
MARGIN = 0.05
#: Budget of a point, if no other is given.
BUDGET = 20000
#: Boxes of a node of several points after which it is halved in any case.
NODE_BUDGET = 400
#: A box is halved unless it has become narrower than this part of itself by contraction.
ENOUGH = 0.6
#: Relative width of boxes that are not halved any more, if no other is given.
NARROW = 2.0**-44
#: Relative width of boxes that are given up where rounding moves the root by as much as :data:`SPREAD`.
SMALL = 2.0**-12
#: Width of boxes around a pole of F that are not halved any more.
POLE = 2.0**-7
#: A node is halved if its parameters move the root by more than this part of the box.
SPREAD = 0.35


class System:
    """n equations in n unknowns with parameters: their values and slopes over boxes, if they are not given, by jets.

    What is neither equations nor their values and slopes has a default that knows nothing more.
    """

    #: How many derivatives the equations themselves are made of.
    order = 0

    def equations(self, unknowns: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
        """F of unknowns that are intervals or jets of them, one a box; parameters of shape (P, N)."""
        raise NotImplementedError

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """F over N boxes: unknowns of shape (n, N), parameters of shape (P, N), result of shape (n, N)."""
        given = variables(list(unknowns), self.order) if self.order else list(unknowns)
        return stacked([constant(value) for value in self.equations(given, parameters)], unknowns.shape[1:])

    def at_points(self, middles: FloatArray, parameters: Intervals) -> Intervals:
        """F at floats, of which a system may know more digits than over boxes."""
        return self.residuals(Intervals.point(middles), parameters)

    def guessed(self, middles: FloatArray, parameters: Intervals) -> FloatArray | None:
        """Floats that may be nearer to roots than the given ones, shape (n, N), if it knows any: nothing is proved of them."""
        return None

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of ∂F/∂x, shape (n, n, N)."""
        rows = self.equations(variables(list(unknowns), self.order + 1), parameters)
        return matrix([gradient(row, unknowns.shape[0]) for row in rows], unknowns.shape[1:])

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes that hold nothing wanted for another reason than F, shape (N,)."""
        return np.zeros(unknowns.shape[1:], dtype=np.bool_)

    def prepared(self, bounds: Intervals) -> Intervals:
        """What the methods take as parameters, from the boxes of all nodes of the tree, shape (parameters, nodes)."""
        return bounds

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Ends of boxes that lie in the given ones and hold the same roots, shape (2, n, N)."""
        return unknowns.ends

    def given_up(self, unknowns: Intervals, parameters: Intervals, width: float = POLE) -> BoolArray:
        """Boxes up to a width that halving would never decide, as around a pole of F, shape (N,)."""
        return np.zeros(unknowns.shape[1:], dtype=np.bool_)


@dataclass(frozen=True)
class Pairs:
    """Boxes, shape (2, n, N), and the nodes that they are looked at for, shape (N,)."""

    ends: FloatArray
    nodes: IntArray

    def __len__(self) -> int:
        return int(self.nodes.size)

    def __getitem__(self, which: BoolArray | IntArray | slice) -> Pairs:
        return Pairs(self.ends[:, :, which], self.nodes[which])


@dataclass(frozen=True)
class Outcome:
    """What a search ends with: boxes with exactly one root for every point of their node, and boxes that nothing is known of.

    ``unique`` and ``where`` are one list: any root in the first box lies in the second one, too.
    """

    unique: Pairs
    where: Pairs
    undecided: Pairs
    points: Tree
    looks: int


def joined(parts: list[Pairs], n: int) -> Pairs:
    """One list of several."""
    empty = Pairs(np.empty((2, n, 0)), np.empty(0, dtype=np.int64))
    parts = [empty, *parts]
    return Pairs(np.concatenate([part.ends for part in parts], axis=2), np.concatenate([part.nodes for part in parts]))


def search(
    system: System,
    region: FloatArray,
    low: FloatArray,
    high: FloatArray,
    *,
    limits: FloatArray | None = None,
    budget: int = BUDGET,
    narrow: float = NARROW,
) -> Outcome:
    """All roots for all points: the box to search is ``region``, −low and high, (2, n, points or 1), points (parameters, points).

    Beyond ``limits``, (2, n), F is not asked for; ``budget`` is how many boxes one point may take, and ``narrow`` the relative
    width of boxes that are not halved any more.
    """
    points, n = tree(low, high), region.shape[1]
    first = Pairs(region.max(axis=2, keepdims=True).astype(np.float64), np.zeros(1, dtype=np.int64))
    with np.errstate(all="ignore"):
        beyond = np.full((2, n, 1), np.inf) if limits is None else limits[:, :, None]
        regions = points.hulls(region) if region.shape[2] > 1 else None
        here = _Search(system, points, beyond, budget, narrow, bool((low == high).all()), regions, system.prepared(points.bounds))
        here.run(_parted(first) if low.shape[1] <= FEW_POINTS else first)
    unique, where, undecided = (joined(part, n) for part in (here.unique, here.where, here.undecided))
    return Outcome(unique, where, undecided, points, here.looks)


@dataclass
class _Search:
    """A stack of pairs, and what has been found."""

    system: System
    points: Tree
    limits: FloatArray
    budget: int
    narrow: float
    #: Whether points are points. Over a box of them roots are as wide as it makes them, and what is cut closely has no room
    #: for these.
    sharp: bool
    #: What is searched for the points of each node, where that is not the same for all points.
    regions: FloatArray | None
    parameters: Intervals
    looks: int = 0

    def __post_init__(self) -> None:
        self.unique: list[Pairs] = []
        self.where: list[Pairs] = []
        self.undecided: list[Pairs] = []
        self.work = np.zeros(self.points.size.size, dtype=np.int64)

    def run(self, start: Pairs) -> None:
        stack = [start]
        n = start.ends.shape[1]
        while stack:
            taken, total = [], 0
            while stack and total < CHUNK:
                taken.append(stack.pop())
                total += len(taken[-1])
            pairs = joined(taken, n)
            if len(pairs) > 2 * CHUNK:
                stack.append(pairs[slice(0, len(pairs) - CHUNK)])
                pairs = pairs[slice(len(pairs) - CHUNK, None)]
            left = self.look(pairs)
            if len(left):
                stack.append(left)

    def look(self, pairs: Pairs) -> Pairs:
        """One step: what is left to be looked at."""
        self.looks += len(pairs)
        np.add.at(self.work, pairs.nodes, 1)
        given, pairs, parameters = self._contracted(pairs)
        # Widened, so that a root on the border of a box lies well inside, or by rounding beside it.
        room = MARGIN * Intervals(pairs.ends).width + NARROW * np.maximum(1.0, np.abs(pairs.ends).max(axis=0))
        wide = np.minimum(pairs.ends + room, self.limits)
        middle = Intervals(pairs.ends).middle
        at_middle = self.system.at_points(middle, parameters)
        slopes = self.system.jacobian(Intervals(wide), parameters)
        step = contractors.newton(at_middle, slopes, middle, contractors.distance(wide, middle))
        proved = contractors.inside(step.ends, wide)
        self.unique.append(Pairs(wide, pairs.nodes)[proved])
        self.where.append(Pairs(step.ends, pairs.nodes)[proved])
        rest = np.flatnonzero(~proved & ~step.none & ~contractors.apart(step.ends, pairs.ends))
        given, pairs, ends, noise = given[rest], pairs[rest], step.ends[:, :, rest], step.noise[:, rest]
        slopes, closed = slopes[:, :, rest], np.logical_and.reduce(ends < wide[:, :, rest])
        if self.sharp:
            middle = middle[:, rest]
            by_rows, none = contractors.by_each_row(at_middle[:, rest], slopes, middle, contractors.distance(pairs.ends, middle))
            ends = np.fmin(ends, by_rows)
            none |= np.logical_or.reduce(ends[0] + ends[1] < 0) | contractors.apart(ends, pairs.ends)
            rest = np.flatnonzero(~none)
            given, pairs, ends, noise = given[rest], pairs[rest], ends[:, :, rest], noise[:, rest]
            slopes, closed = slopes[:, :, rest], closed[:, rest]
        return self._divided(given, Pairs(_with_room(ends, pairs.ends, noise), pairs.nodes), noise, slopes, closed)

    def _contracted(self, given: Pairs) -> tuple[Pairs, Pairs, Intervals]:
        """Pairs whose boxes may hold a root; what is left of the boxes by the system's own contraction; parameters."""
        parameters = self.parameters[:, given.nodes]
        after = self.system.contracted(Intervals(given.ends), parameters)
        boxes = Intervals(_with_room(after, given.ends, 0.0))
        keep = np.logical_and.reduce(self.system.residuals(boxes, parameters).holds_zero())
        keep &= ~np.logical_or.reduce(after[0] + after[1] < 0)
        rows = np.flatnonzero(keep)
        ends, parameters = boxes.ends[:, :, rows], parameters[:, rows]
        left = np.flatnonzero(~self.system.hopeless(Intervals(ends), parameters)) if rows.size else rows
        rows = rows[left]
        return given[rows], Pairs(ends[:, :, left], given.nodes[rows]), parameters[:, left]

    def _divided(self, before: Pairs, now: Pairs, noise: FloatArray, slopes: Intervals, closed: BoolArray) -> Pairs:
        """Halves of boxes, halves of nodes, or boxes as they are if they have become much narrower."""
        n = now.ends.shape[1]
        widths = now.ends[0] + now.ends[1]
        single = self.points.size[now.nodes] == 1
        spent = self.work[now.nodes] > np.where(single, self.budget, NODE_BUDGET)
        scale = np.maximum(1.0, np.abs(now.ends).max(axis=0))
        # What shrinks towards an exact 0 does so down to the least of floats: it is no progress.
        ratio = np.where(widths <= NARROW * scale, 1.0, widths / (before.ends[0] + before.ends[1]))
        stuck = np.logical_or.reduce(noise >= SPREAD * widths) & np.logical_and.reduce(widths <= SMALL * scale)
        narrow = np.logical_and.reduce(widths <= self.narrow * scale)
        hard = self.system.given_up(Intervals(now.ends), self.parameters[:, now.nodes])
        moved = ~np.logical_and.reduce(noise < SPREAD * widths)
        done = hard | (single & (spent | stuck)) | (narrow & (single | ~moved))
        self.undecided.append(now[done])
        split_node = ~single & ~done & (spent | moved)
        again = ~split_node & ~done
        better = again & (np.where(closed, 1.0, ratio).prod(axis=0) < ENOUGH)
        halve = np.flatnonzero(again & ~better)
        places, children = self.points.children(now.nodes[split_node])
        halved_nodes = self._in_their_regions(Pairs(now.ends[:, :, np.flatnonzero(split_node)[places]], children))
        return joined([halved_nodes, now[better], _halves(now[halve], slopes[:, :, halve], closed[:, halve])], n)

    def _in_their_regions(self, pairs: Pairs) -> Pairs:
        """What is left of boxes in the regions of their nodes: that of one point may be wide, and that of another narrow."""
        if self.regions is None:
            return pairs
        ends = np.minimum(pairs.ends, self.regions[:, :, pairs.nodes])
        return Pairs(ends, pairs.nodes)[np.logical_and.reduce(ends[0] + ends[1] >= 0)]


def _with_room(ends: FloatArray, given: FloatArray, noise: FloatArray | float) -> FloatArray:
    """A box narrowed, but not to the last digit: a component that converges before the others keeps room until all are proved."""
    return np.fmin(ends + (MARGIN * Intervals(given).width + 4 * noise), given)


def _parted(pairs: Pairs) -> Pairs:
    """Pieces of boxes, halved where they are widest."""
    while 0 < len(pairs) < PIECES:
        pairs = _cut(pairs, (pairs.ends[0] + pairs.ends[1]).argmax(axis=0))
    return pairs


def _halves(pairs: Pairs, slopes: Intervals, closed: BoolArray) -> Pairs:
    """Both halves of each box, cut where the residuals change most in proportion to all that they change.

    A component that interval Newton maps into the interior is not what keeps the box open.
    """
    widths = pairs.ends[0] + pairs.ends[1]
    change = slopes.magnitude * widths[None]
    share = (change / change.sum(axis=1, keepdims=True)).sum(axis=0)
    known = np.isfinite(share).all(axis=0)
    # What is as narrow as rounding allows gets no narrower by halving.
    done = closed | (widths <= NARROW * np.maximum(1.0, np.abs(pairs.ends).max(axis=0)))
    return _cut(pairs, np.where(done, -1.0, np.where(known, share, widths)).argmax(axis=0))


def _cut(pairs: Pairs, along: IntArray) -> Pairs:
    """Both halves of each box, cut in the unknown of that number."""
    columns = np.arange(len(pairs))
    # Not in the middle, where symmetric systems have their roots.
    low, high = -pairs.ends[0, along, columns], pairs.ends[1, along, columns]
    cut = np.clip(low + 0.4921875 * (high - low), low, high)
    lower, upper = pairs.ends.copy(), pairs.ends.copy()
    lower[1, along, columns] = cut
    upper[0, along, columns] = -cut
    return Pairs(np.concatenate([lower, upper], axis=2), np.concatenate([pairs.nodes, pairs.nodes]))
