"""All roots of small systems in a region, proved: branch and prune, over many boxes and many points
of parameters at once.

A pair of a box of unknowns and a node of the tree of points is taken from a stack, thousands at a
time. Whatever :mod:`spragsym.numerics.contractors` proves of it holds for all points of the node:
so it is dropped, or decided for all of them. What is not decided is halved: the box where the width
of the unknowns is what keeps it open, the node where the spread of the parameters is. Points of a
space of parameters are the leaves of a tree of boxes, so that one proof serves all points of a box.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..core.options import Options, limit, option
from .columns import ByColumn
from .interval_arrays import (
    BoolArray,
    FloatArray,
    Int8Array,
    IntArray,
    Intervals,
    is_in_another_unit,
    quiet,
    scale_of,
    width_of,
)
from .plans import Plan
from .verdicts import NARROW, BoxVerdict, Judged, Looked, Rules, judged, with_room

#: Pairs looked at in one go: enough to forget the calls' overhead, few enough to stay in the cache.
CHUNK = 2048


@dataclass(frozen=True)
class BoxOptions(Options):
    """Options of a search over boxes, which is a proof whatever they are.

    Parameters
    ----------
    budget : int, optional
        Boxes that are looked at for one point of the parameters, after which what is left is
        undecided. Left out, each question has its own: 20,000 for equilibria of up to two
        coordinates, 200,000 for those of more and for points in up to three unknowns, 1,000,000 in
        four, 500,000 in more.
    node_budget : int
        Boxes of several points together after which these are parted in any case.
    narrow : float, optional
        Relative width of boxes that are not halved any more. Left out, each question has its own:
        2⁻¹⁹ for equilibria, which are then looked at with many digits, else 2⁻⁴⁴.
    margin : float
        Share of its width by which a box is widened before it is asked for a root, so that roots
        on its border are inside.
    shrunk : float
        Share of a box above which it is halved when contraction leaves as much.
    spread : float
        Share of the box by which parameters, or rounding, move the root, above which points are
        parted or a small box is given up.
    small : float
        Relative width up to which a box is given up for rounding.
    pole : float
        Width of boxes around a pole of the forces that are not halved any more.
    pieces : int
        Boxes into which a region is cut at once where there are few points.
    """

    budget: int | None = limit(None)
    node_budget: int = limit(400)
    narrow: float | None = option(None, 2.0**-50, 0.5)
    margin: float = option(0.05, 2.0**-20, 0.5)
    shrunk: float = option(0.6, 0.01, 0.99)
    spread: float = option(0.35, 0.01, 0.99)
    small: float = option(2.0**-12, 2.0**-44, 0.5)
    pole: float = option(2.0**-7, 0.0, 1.0)
    pieces: int = limit(16)


class EquationSystem:
    """n equations in n unknowns with parameters: their values and slopes over boxes.

    All else has a default that knows nothing more.
    """

    #: Boxes of a point after which it is given up, where nobody says.
    usual_budget = 20_000
    #: Beyond these, −low and high, (2, n), F is not asked for.
    limits: Any = np.inf

    @property
    def options(self) -> BoxOptions:
        """Options of the search for its roots."""
        return BoxOptions()

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """F over N boxes: unknowns of shape (n, N), parameters of shape (P, N), result of shape (n,
        N).
        """
        raise NotImplementedError

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of ∂F/∂x, shape (n, n, N)."""
        raise NotImplementedError

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes that hold nothing wanted for another reason than F, shape (N,)."""
        return np.zeros(unknowns.shape[1:], dtype=bool)

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray | None:
        """Of what is excluded that which no plan tells; None where it tells all."""
        return None

    @property
    def covered_by_plan(self) -> bool:
        """Whether a plan makes all tests of a box: nothing is excluded or abandoned beside it."""
        return False

    def plan(self, parameters: Intervals) -> Plan | None:
        """Tapes by which compiled code looks at boxes, for these parameters of all nodes, if all is
        recorded.
        """
        return None

    def prepared(self, bounds: Intervals) -> Intervals:
        """Parameters as the methods take them, from the boxes of all nodes of the tree, shape
        (parameters, nodes).
        """
        return bounds

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Ends of boxes that lie in the given ones and hold the same roots, shape (2, n, N)."""
        return unknowns.ends

    def abandoned(
        self, unknowns: Intervals, parameters: Intervals, times: float = 1.0
    ) -> BoolArray:
        """Boxes, up to so many times the width of the options, that halving would never decide, as
        around a pole of F, shape (N,).
        """
        return np.zeros(unknowns.shape[1:], dtype=bool)


@dataclass(frozen=True)
class Pairs(ByColumn):
    """Boxes, shape (2, n, N), and the nodes that they are looked at for, shape (N,)."""

    ends: FloatArray
    nodes: IntArray

    def __len__(self) -> int:
        return int(self.nodes.size)


@dataclass(frozen=True)
class SearchOutcome:
    """Outcome of a search: boxes with exactly one root for every point of their node, and boxes
    that nothing is known of.

    ``unique`` and ``where`` are one list: any root in the first box lies in the second one, too.
    """

    unique: Pairs
    where: Pairs
    undecided: Pairs
    points: Tree
    looks: int

    @property
    def every(self) -> Pairs:
        """Boxes that hold all roots."""
        return self.where.concatenated(self.undecided)


def search(
    system: EquationSystem,
    region: FloatArray,
    low: FloatArray,
    high: FloatArray,
    *,
    budget: int | None = None,
    narrow: float | None = None,
) -> SearchOutcome:
    """All roots for all points: the box to search is ``region``, −low and high, (2, n, points or
    1), points (parameters, points).

    ``budget`` is how many boxes one point may take, and ``narrow`` the relative width of boxes that
    are not halved any more, else as the options of the system say.
    """
    points, options = tree(low, high), system.options
    first = Pairs(region.max(axis=2, keepdims=True).astype(float), np.zeros(1, dtype=int))
    with quiet():
        beyond = np.asarray(system.limits)[..., None]
        regions = points.hulls(region) if region.shape[2] > 1 else None
        here = _Search(
            system,
            points,
            beyond,
            budget or options.budget or system.usual_budget,
            Rules(
                options.margin,
                options.spread,
                options.small,
                narrow or options.narrow or NARROW,
                options.shrunk,
                bool((low == high).all()),
                _spans(first.ends[:, :, 0]),
            ),
            regions,
            system.prepared(points.bounds),
        )
        # A look at one box costs as much as at a few.
        here.run(_parted(first, options.pieces) if low.shape[1] <= 4 else first)
    unique, where, undecided = (
        first[:0].concatenated(*found) for found in (here.unique, here.where, here.undecided)
    )
    return SearchOutcome(unique, where, undecided, points, here.looks)


def _spans(region: FloatArray) -> FloatArray:
    """How far the unknowns of a region reach, shape (n,): 1 unless that is far from it, as of
    lengths in another unit.
    """
    reach = np.abs(region).max(axis=0)
    return np.where(is_in_another_unit(reach), reach, 1.0)


@dataclass
class _Search:
    """A stack of pairs, and what has been found."""

    system: EquationSystem
    points: Tree
    limits: FloatArray
    budget: int
    rules: Rules
    #: What is searched for the points of each node, where that is not the same for all points.
    regions: FloatArray | None
    parameters: Intervals
    looks: int = 0
    unique: list[Pairs] = field(default_factory=list)
    where: list[Pairs] = field(default_factory=list)
    undecided: list[Pairs] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.work = np.zeros(self.points.size.size, dtype=int)
        self.plan = self.system.plan(self.parameters)

    def run(self, start: Pairs) -> None:
        stack = [self._at_one_point(start)]
        while stack and (len(stack) > 1 or len(stack[0])):
            taken, total = [], 0
            while stack and total < CHUNK:
                taken.append(stack.pop())
                total += len(taken[-1])
            pairs = taken[0].concatenated(*taken[1:])
            if len(pairs) > 2 * CHUNK:
                stack.append(pairs[:-CHUNK])
                pairs = pairs[-CHUNK:]
            left = self.look(pairs)
            if len(left):
                stack.append(left)

    def _at_one_point(self, start: Pairs) -> Pairs:
        """What is left of a search at one point by compiled code, as long as all its boxes are
        looked at at once.
        """
        if self.plan is None or self.points.size.tolist() != [1] or not self.system.covered_by_plan:
            return start
        self.looks, ends = self.plan.rounds(
            start.ends, self.parameters, self.limits, self.rules, (self.budget, 2 * CHUNK)
        )
        self.work[0] = self.looks
        unique, where, undecided, left = (
            Pairs(part, np.zeros(part.shape[2], dtype=int)) for part in ends
        )
        self.unique.append(unique)
        self.where.append(where)
        self.undecided.append(undecided)
        return left

    def look(self, pairs: Pairs) -> Pairs:
        """One step: what is left to be looked at."""
        self.looks += len(pairs)
        np.add.at(self.work, pairs.nodes, 1)
        given, pairs = self._contracted(pairs)
        wide, found = self._decided(given.ends, pairs)
        proved = np.flatnonzero(found.verdicts == BoxVerdict.PROVED)
        if proved.size:
            self.unique.append(Pairs(wide, pairs.nodes)[proved])
            self.where.append(Pairs(found.step, pairs.nodes)[proved])
        left = np.flatnonzero(found.verdicts > BoxVerdict.PROVED)
        return self._divided(
            Pairs(found.left, pairs.nodes)[left], found.verdicts[left], found.along[left]
        )

    def _at(self, nodes: IntArray) -> Intervals:
        """Parameters of nodes."""
        if self.parameters.shape[1] > 1:
            return self.parameters[:, nodes]
        ends = self.parameters.ends
        return Intervals(np.broadcast_to(ends, (*ends.shape[:2], nodes.size)))

    def _contracted(self, given: Pairs) -> tuple[Pairs, Pairs]:
        """Pairs whose boxes may hold a root, and what is left of the boxes by the system's own
        contraction.
        """
        parameters = self._at(given.nodes)
        excluded: Callable[[Intervals, Intervals], BoolArray | None]
        if self.plan is None:
            ends, keep = self._kept(given.ends, parameters)
            excluded = self.system.excluded
        else:
            ends, keep = self.plan.kept(given.ends, parameters, self.rules.margin)
            excluded = self.system.excluded_without_plan
        rows = np.flatnonzero(keep)
        boxes = ends.take(rows, axis=2)
        gone = excluded(Intervals(boxes), parameters[:, rows]) if rows.size else None
        if gone is not None:
            left = np.flatnonzero(~gone)
            rows, boxes = rows[left], boxes[:, :, left]
        kept = given[rows]
        return kept, Pairs(boxes, kept.nodes)

    def _kept(self, given: FloatArray, parameters: Intervals) -> tuple[FloatArray, BoolArray]:
        """Contracted boxes, and those in which all values may be 0."""
        after = self.system.contracted(Intervals(given), parameters)
        boxes = Intervals(with_room(after, given, 0.0, self.rules.margin))
        keep = np.logical_and.reduce(self.system.residuals(boxes, parameters).holds_zero())
        return boxes.ends, keep & ~np.logical_or.reduce(width_of(after) < 0)

    def _decided(self, given: FloatArray, pairs: Pairs) -> tuple[FloatArray, Judged]:
        """Boxes with room around, and what becomes of them."""
        parameters, single = self._at(pairs.nodes), self.points.size[pairs.nodes] == 1
        most = np.where(single, self.budget, self.system.options.node_budget)
        spent = self.work[pairs.nodes] > most
        if self.plan is not None:
            marks = single, spent
            return self.plan.decided(
                (given, pairs.ends), parameters, self.limits, marks, self.rules
            )
        # Widened, so that a root on the border of a box lies well inside, or by rounding beside it.
        room = self.rules.margin * Intervals(pairs.ends).width
        room = room + NARROW * scale_of(pairs.ends).max(axis=0)
        wide = np.minimum(pairs.ends + room, self.limits)
        middle = Intervals(pairs.ends).middle
        values = self.system.residuals(Intervals.point(middle), parameters)
        slopes = self.system.jacobian(Intervals(wide), parameters)
        boxes = Looked(given, pairs.ends, wide, middle, values, slopes, single, spent)
        return wide, judged(boxes, self.rules)

    def _divided(self, now: Pairs, verdicts: Int8Array, along: IntArray) -> Pairs:
        """Halves of boxes, halves of nodes, or boxes as they are if they have become much
        narrower.
        """
        hard = self.system.abandoned(Intervals(now.ends), self._at(now.nodes))
        verdicts[hard] = BoxVerdict.UNDECIDED
        undecided, better, halve, parted = (
            np.flatnonzero(verdicts == which)
            for which in (
                BoxVerdict.UNDECIDED,
                BoxVerdict.AGAIN,
                BoxVerdict.HALVED,
                BoxVerdict.PARTED,
            )
        )
        if undecided.size:
            self.undecided.append(now[undecided])
        left = _cut(now[halve], along[halve])
        if better.size:
            left = now[better].concatenated(left)
        if not parted.size:
            return left
        places, children = self.points.children(now.nodes[parted])
        return self._in_their_regions(Pairs(now.ends[:, :, parted[places]], children)).concatenated(
            left
        )

    def _in_their_regions(self, pairs: Pairs) -> Pairs:
        """Intersections of boxes with the regions of their nodes: that of one point may be wide,
        and that of another narrow.
        """
        if self.regions is None:
            return pairs
        ends = np.minimum(pairs.ends, self.regions[:, :, pairs.nodes])
        return Pairs(ends, pairs.nodes)[np.logical_and.reduce(width_of(ends) >= 0)]


def _parted(pairs: Pairs, pieces: int) -> Pairs:
    """Pieces of boxes, halved where they are widest."""
    while 0 < len(pairs) < pieces:
        pairs = _cut(pairs, width_of(pairs.ends).argmax(axis=0))
    return pairs


def _cut(pairs: Pairs, along: IntArray) -> Pairs:
    """Both halves of each box, cut in the unknown of that number."""
    columns = np.arange(len(pairs))
    ends = np.concatenate([pairs.ends, pairs.ends], axis=2)
    low, high = -ends[0, along, columns], ends[1, along, columns]
    # Not in the middle, where symmetric systems have their roots.
    cut = np.clip(low + 0.4921875 * (high - low), low, high)
    ends[1, along, columns] = cut
    ends[0, along, columns + len(pairs)] = -cut
    return Pairs(ends, np.concatenate([pairs.nodes, pairs.nodes]))


@dataclass(frozen=True)
class Tree:
    """A binary tree; node i has the children 2 i + 1 and 2 i + 2, and the root is node 0."""

    bounds: Intervals  #: the smallest box around the points of a node, (parameters, nodes)
    size: IntArray  #: number of points below each node; 0 for nodes that are not there
    # the points' numbers in the order of the leaves, which stand last; −1 where there is none
    order: IntArray
    depth: int  #: levels below the root

    def below(self, nodes: IntArray) -> tuple[IntArray, IntArray]:
        """Rows (place among ``nodes``, point) for all points of all of these nodes."""
        nodes = nodes.astype(int)
        level = np.frexp(nodes + 1)[1].astype(int) - 1
        span = 1 << (self.depth - level)
        ends = np.cumsum(span)
        places = np.repeat(np.arange(nodes.size), span)
        leaves = (
            np.arange(places.size) + ((nodes + 1 - (1 << level)) * span - (ends - span))[places]
        )
        there = self.order[leaves] >= 0
        return places[there], self.order[leaves[there]]

    def hulls(self, ends: FloatArray) -> FloatArray:
        """The hull of the boxes of all points below each node: ends of shape (2, n, points), result
        of shape (2, n, nodes).
        """
        # Of leaves that are not there, whose number is −1, nothing is known.
        nothing = np.full((*ends.shape[:2], 1), -np.inf)
        levels = [np.concatenate([ends, nothing], axis=2)[:, :, self.order]]
        for _ in range(self.depth):
            levels.append(levels[-1].reshape(*ends.shape[:2], -1, 2).max(axis=3))
        return np.concatenate(levels[::-1], axis=2)

    def children(self, nodes: IntArray) -> tuple[IntArray, IntArray]:
        """Rows (place among ``nodes``, child) for all children that have points."""
        children = np.concatenate([2 * nodes + 1, 2 * nodes + 2])
        there = np.flatnonzero(self.size[children] > 0)
        return there % nodes.size, children[there]


def tree(low: FloatArray, high: FloatArray) -> Tree:
    """Halve points, boxes of shape (parameters, points), by the parameter in which they are spread
    most, again and again.
    """
    count, points = low.shape
    depth = max(0, int(points - 1).bit_length())
    leaves = 1 << depth
    order = np.full(leaves, -1, dtype=int)
    order[:points] = np.arange(points)
    low, high = (
        np.concatenate([part, np.full((count, leaves - points), np.nan)], axis=1)
        for part in (low, high)
    )
    whole = np.fmax.reduce(high, axis=1, initial=-np.inf) - np.fmin.reduce(
        low, axis=1, initial=np.inf
    )
    scale = np.where(whole > 0, whole, 1.0)
    lows, highs, sizes = [], [], []
    for level in range(depth + 1):
        blocks = order.reshape(1 << level, -1)
        least = np.fmin.reduce(low[:, blocks], axis=2)
        most = np.fmax.reduce(high[:, blocks], axis=2)
        lows.append(least)
        highs.append(most)
        sizes.append((blocks >= 0).sum(axis=1))
        if level < depth and count:
            order = _halved(
                blocks, low, np.nan_to_num((most - least) / scale[:, None], nan=-1.0).argmax(axis=0)
            )
    bounds = Intervals.between(np.concatenate(lows, axis=1), np.concatenate(highs, axis=1))
    return Tree(bounds, np.concatenate(sizes), order, depth)


def _halved(blocks: IntArray, low: FloatArray, along: IntArray) -> IntArray:
    """Each block in the order of its parameter ``along``, those that are not there last."""
    keys = np.where(blocks >= 0, low[along[:, None], blocks], np.inf)
    half = blocks.shape[1] // 2
    ranks = (
        np.argpartition(keys, half - 1, axis=1)
        if half > 1
        else np.argsort(keys, axis=1, kind="stable")
    )
    return np.take_along_axis(blocks, ranks, axis=1).reshape(-1)
