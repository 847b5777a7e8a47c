"""Branch and prune: all roots of a small system of equations in a region, proved, for many
parameter points at once.

The parameter points are the leaves of a binary tree (:class:`Tree`); each node has the smallest box
around its points, so that one proof serves all points of a node. The search works on pairs of a box
of unknowns and a node, thousands at a time, from a stack. For each pair interval Newton
(:mod:`spragsym.numerics.contractors`) may prove that the box contains no root, or exactly one, for
all points of the node. Otherwise the box is bisected, or, if the spread of the parameters is the
reason, the node is replaced by its two children.
"""

from __future__ import annotations

import sys
import time
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

#: Number of pairs per step: large against the overhead of calls, small enough for the cache.
CHUNK = 2048


@dataclass(frozen=True)
class BoxOptions(Options):
    """Options of branch and prune. The result is a proof whatever they are.

    Parameters
    ----------
    budget : int, optional
        Maximum number of boxes examined for one parameter point; the remaining ones are undecided.
        The default depends on the question: for equilibria there is none, for points it is 200,000
        in up to three unknowns, 1,000,000 in four, 500,000 in more.
    seconds : float
        Processor time for one parameter point after which the remaining boxes are undecided, if
        there is no maximum number of boxes. Points of one call share it by the boxes that each
        takes.
    folded : int
        Undecided boxes at one point after which a search there ends, if there is no maximum number
        of boxes, and beyond which only their hull is kept.
    node_budget : int
        Maximum number of boxes examined for several points together, before these are separated.
    narrow : float, optional
        Relative width below which boxes are not bisected. The default is 2⁻¹⁹ for equilibria, which
        are then examined with more digits, else 2⁻⁴⁴.
    margin : float
        A box is widened by this share of its width before the test for a root, so that roots on its
        border are inside.
    shrunk : float
        A box is bisected if contraction leaves more than this share of it.
    spread : float
        If parameters, or rounding, move the root by more than this share of the box, points are
        separated, or a small box is abandoned.
    small : float
        Relative width up to which a box may be abandoned because of rounding.
    pole : float
        Width below which boxes around a pole of the forces are not bisected.
    pieces : int
        Number of boxes into which a region is cut at the beginning, if there are few points.
    """

    budget: int | None = limit(None)
    seconds: float = option(3.0, 0.01)
    folded: int = limit(2000)
    node_budget: int = limit(400)
    narrow: float | None = option(None, 2.0**-50, 0.5)
    margin: float = option(0.05, 2.0**-20, 0.5)
    shrunk: float = option(0.6, 0.01, 0.99)
    spread: float = option(0.35, 0.01, 0.99)
    small: float = option(2.0**-12, 2.0**-44, 0.5)
    pole: float = option(2.0**-7, 0.0, 1.0)
    pieces: int = limit(16)


class EquationSystem:
    """n equations F(x, p) = 0 in n unknowns x with parameters p, evaluated over boxes.

    ``residuals`` and ``jacobian`` must be defined. The defaults of all others are trivial.
    """

    #: −low and high, (2, n), of the domain in which F is evaluated.
    limits: Any = np.inf

    @property
    def options(self) -> BoxOptions:
        """Options of the search for the roots."""
        return BoxOptions()

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of F over N boxes, (n, N): unknowns (n, N), parameters (P, N)."""
        raise NotImplementedError

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of ∂F/∂x over N boxes, (n, n, N)."""
        raise NotImplementedError

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Mask of boxes without wanted roots, by a condition other than F, (N,)."""
        return np.zeros(unknowns.shape[1:], dtype=bool)

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray | None:
        """The part of :meth:`excluded` that a plan does not test; None if it tests all."""
        return None

    @property
    def covered_by_plan(self) -> bool:
        """True if a plan makes all tests of a box, and ``excluded`` and ``abandoned`` add none."""
        return False

    def plan(self, parameters: Intervals) -> Plan | None:
        """Recorded functions with which compiled code examines boxes, for the parameters of all
        nodes; None if not all functions can be recorded.
        """
        return None

    def prepared(self, bounds: Intervals) -> Intervals:
        """Parameters as the other methods take them, from the boxes of all nodes, (parameters,
        nodes).
        """
        return bounds

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Ends (2, n, N) of boxes within the given ones that contain the same roots."""
        return unknowns.ends

    def abandoned(
        self, unknowns: Intervals, parameters: Intervals, times: float = 1.0
    ) -> BoolArray:
        """Mask of boxes that bisection would never decide, as around a pole of F, (N,): up to
        ``times`` the width in the options.
        """
        return np.zeros(unknowns.shape[1:], dtype=bool)


@dataclass(frozen=True)
class Pairs(ByColumn):
    """N pairs of a box, ``ends`` (2, n, N), and a node of the tree of points, (N,)."""

    ends: FloatArray
    nodes: IntArray

    def __len__(self) -> int:
        return int(self.nodes.size)


@dataclass(frozen=True)
class SearchOutcome:
    """Result of branch and prune.

    ``unique`` are boxes with exactly one root for every point of their node. ``where``, in the same
    order, are enclosures of these roots: any root in the first box is in the second, too.
    ``undecided`` are boxes that may contain roots. ``looks`` is the number of boxes examined.
    """

    unique: Pairs
    where: Pairs
    undecided: Pairs
    points: Tree
    looks: int

    @property
    def every(self) -> Pairs:
        """Boxes that contain all roots."""
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
    """All roots in a region for all parameter points, by branch and prune.

    ``region``, (2, n, points or 1), are −low and high of the box to search. ``low`` and ``high``,
    (parameters, points), are the parameters, which may be intervals. ``budget`` and ``narrow``
    replace those of the system's options; without a ``budget`` the options ``seconds`` and
    ``folded`` end the search.
    """
    points, options = tree(low, high), system.options
    first = Pairs(region.max(axis=2, keepdims=True).astype(float), np.zeros(1, dtype=int))
    with quiet():
        beyond = np.asarray(system.limits)[..., None]
        regions = points.hulls(region) if region.shape[2] > 1 else None
        rules = Rules(
            options.margin,
            options.spread,
            options.small,
            narrow or options.narrow or NARROW,
            options.shrunk,
            bool((low == high).all()),
            _spans(first.ends[:, :, 0]),
        )
        state = _Search(
            system,
            points,
            beyond,
            budget or options.budget,
            rules,
            regions,
            system.prepared(points.bounds),
        )
        # To examine one box costs as much as to examine a few.
        state.run(_subdivided(first, options.pieces) if low.shape[1] <= 4 else first)
    unique, where, undecided = (
        first[:0].concatenated(*found) for found in (state.unique, state.where, state.undecided)
    )
    return SearchOutcome(unique, where, undecided, points, state.looks)


def _spans(region: FloatArray) -> FloatArray:
    """Scale of each unknown in a region, (n,): its largest absolute value if that is far from 1, as
    of lengths in another unit, else 1.
    """
    largest = np.abs(region).max(axis=0)
    return np.where(is_in_another_unit(largest), largest, 1.0)


@dataclass
class _Search:
    """State of a search: the results so far, and the number of boxes examined for each node."""

    system: EquationSystem
    points: Tree
    limits: FloatArray
    budget: int | None
    rules: Rules
    #: The region of each node, (2, n, nodes), if it is not the same for all points.
    regions: FloatArray | None
    parameters: Intervals
    looks: int = 0
    unique: list[Pairs] = field(default_factory=list)
    where: list[Pairs] = field(default_factory=list)
    undecided: list[Pairs] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.work = np.zeros(self.points.size.size, dtype=int)
        self.left = np.zeros_like(self.work)
        self.begun = time.thread_time()
        self.plan = self.system.plan(self.parameters)

    def run(self, start: Pairs) -> None:
        """Search the boxes of ``start`` until the stack is empty."""
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
        """For a single point: search by compiled code, as long as the boxes fit into one step.
        Returns the remaining pairs; without compiled code all.
        """
        if self.plan is None or self.points.size.tolist() != [1] or not self.system.covered_by_plan:
            return start
        self.looks, ends = self.plan.rounds(
            start.ends,
            self.parameters,
            self.limits,
            self.rules,
            (self.budget or sys.maxsize, 2 * CHUNK),
        )
        self.work[0] = self.looks
        unique, where, undecided, left = (
            Pairs(part, np.zeros(part.shape[2], dtype=int)) for part in ends
        )
        self.unique.append(unique)
        self.where.append(where)
        self._leave(undecided)
        return left

    def look(self, pairs: Pairs) -> Pairs:
        """One step of branch and prune: contract, test and divide pairs; those that remain."""
        self.looks += len(pairs)
        np.add.at(self.work, pairs.nodes, 1)
        given, pairs = self._contracted(pairs)
        wide, found = self._decided(given.ends, pairs)
        proved = np.flatnonzero(found.verdicts == BoxVerdict.PROVED)
        if proved.size:
            self.unique.append(Pairs(wide, pairs.nodes)[proved])
            self.where.append(Pairs(found.step, pairs.nodes)[proved])
        rows = np.flatnonzero(found.verdicts > BoxVerdict.PROVED)
        remaining = Pairs(found.left, pairs.nodes)[rows]
        return self._divided(remaining, found.verdicts[rows], found.along[rows])

    def _at(self, nodes: IntArray) -> Intervals:
        """Parameters of nodes, (P, N)."""
        if self.parameters.shape[1] > 1:
            return self.parameters[:, nodes]
        ends = self.parameters.ends
        return Intervals(np.broadcast_to(ends, (*ends.shape[:2], nodes.size)))

    def _contracted(self, given: Pairs) -> tuple[Pairs, Pairs]:
        """Pairs whose boxes may contain a root, as given, and with the boxes contracted by the
        system's own contractor.
        """
        parameters = self._at(given.nodes)
        excluded: Callable[[Intervals, Intervals], BoolArray | None]
        if self.plan is None:
            ends, keep = self._may_hold_root(given.ends, parameters)
            excluded = self.system.excluded
        else:
            ends, keep = self.plan.kept(given.ends, parameters, self.rules.margin)
            excluded = self.system.excluded_without_plan
        rows = np.flatnonzero(keep)
        boxes = ends.take(rows, axis=2)
        without_root = excluded(Intervals(boxes), parameters[:, rows]) if rows.size else None
        if without_root is not None:
            others = np.flatnonzero(~without_root)
            rows, boxes = rows[others], boxes[:, :, others]
        selected = given[rows]
        return selected, Pairs(boxes, selected.nodes)

    def _may_hold_root(
        self, given: FloatArray, parameters: Intervals
    ) -> tuple[FloatArray, BoolArray]:
        """Contracted boxes, and the mask of those in which all residuals may be 0."""
        after = self.system.contracted(Intervals(given), parameters)
        boxes = Intervals(with_room(after, given, 0.0, self.rules.margin))
        keep = np.logical_and.reduce(self.system.residuals(boxes, parameters).holds_zero())
        return boxes.ends, keep & ~np.logical_or.reduce(width_of(after) < 0)

    def _decided(self, given: FloatArray, pairs: Pairs) -> tuple[FloatArray, Judged]:
        """The boxes widened by a margin, and the result of interval Newton over these."""
        parameters, single = self._at(pairs.nodes), self.points.size[pairs.nodes] == 1
        spent = np.where(
            single,
            self._has_spent(pairs.nodes),
            self.work[pairs.nodes] > self.system.options.node_budget,
        )
        if self.plan is not None:
            marks = single, spent
            return self.plan.decided(
                (given, pairs.ends), parameters, self.limits, marks, self.rules
            )
        # With the margin, a root on the border of a box, or beside it by rounding, is well inside.
        margin = self.rules.margin * Intervals(pairs.ends).width
        margin = margin + NARROW * scale_of(pairs.ends).max(axis=0)
        wide = np.minimum(pairs.ends + margin, self.limits)
        middle = Intervals(pairs.ends).middle
        values = self.system.residuals(Intervals.point(middle), parameters)
        slopes = self.system.jacobian(Intervals(wide), parameters)
        boxes = Looked(given, pairs.ends, wide, middle, values, slopes, single, spent)
        return wide, judged(boxes, self.rules)

    def _has_spent(self, nodes: IntArray) -> BoolArray:
        """Nodes of one point whose boxes, or their share of the time, reach the limit."""
        if self.budget is not None:
            return self.work[nodes] > self.budget
        options, per_box = self.system.options, (time.thread_time() - self.begun) / self.looks
        return (self.work[nodes] * per_box > options.seconds) | (self.left[nodes] > options.folded)

    def _leave(self, pairs: Pairs) -> None:
        """Put boxes to the undecided ones."""
        np.add.at(self.left, pairs.nodes, 1)
        self.undecided.append(pairs)

    def _divided(self, pairs: Pairs, verdicts: Int8Array, along: IntArray) -> Pairs:
        """Pairs for the next steps: boxes bisected in the unknown ``along``, nodes replaced by
        their children, or contracted boxes unchanged. Undecided ones go to the results.
        """
        hopeless = self.system.abandoned(Intervals(pairs.ends), self._at(pairs.nodes))
        verdicts[hopeless] = BoxVerdict.UNDECIDED
        rows = {which: np.flatnonzero(verdicts == which) for which in BoxVerdict}
        if rows[BoxVerdict.UNDECIDED].size:
            self._leave(pairs[rows[BoxVerdict.UNDECIDED]])
        halved, parted = rows[BoxVerdict.HALVED], rows[BoxVerdict.PARTED]
        remaining = _bisected(pairs[halved], along[halved])
        if rows[BoxVerdict.AGAIN].size:
            remaining = pairs[rows[BoxVerdict.AGAIN]].concatenated(remaining)
        if not parted.size:
            return remaining
        places, children = self.points.children(pairs.nodes[parted])
        of_children = Pairs(pairs.ends[:, :, parted[places]], children)
        return self._in_their_regions(of_children).concatenated(remaining)

    def _in_their_regions(self, pairs: Pairs) -> Pairs:
        """Intersections of boxes with the regions of their nodes, which may differ from point to
        point.
        """
        if self.regions is None:
            return pairs
        ends = np.minimum(pairs.ends, self.regions[:, :, pairs.nodes])
        return Pairs(ends, pairs.nodes)[np.logical_and.reduce(width_of(ends) >= 0)]


def _subdivided(pairs: Pairs, pieces: int) -> Pairs:
    """Boxes bisected in their widest unknown, until there are at least ``pieces``."""
    while 0 < len(pairs) < pieces:
        pairs = _bisected(pairs, width_of(pairs.ends).argmax(axis=0))
    return pairs


def _bisected(pairs: Pairs, along: IntArray) -> Pairs:
    """Both halves of each box, cut in the unknown with index ``along``."""
    columns = np.arange(len(pairs))
    ends = np.concatenate([pairs.ends, pairs.ends], axis=2)
    low, high = -ends[0, along, columns], ends[1, along, columns]
    # Not at the midpoint, where symmetric systems have roots.
    cut = np.clip(low + 0.4921875 * (high - low), low, high)
    ends[1, along, columns] = cut
    ends[0, along, columns + len(pairs)] = -cut
    return Pairs(ends, np.concatenate([pairs.nodes, pairs.nodes]))


@dataclass(frozen=True)
class Tree:
    """A complete binary tree of parameter points, which are its leaves. The root is node 0; node i
    has the children 2 i + 1 and 2 i + 2.
    """

    bounds: Intervals  #: the smallest box around the points of each node, (parameters, nodes)
    size: IntArray  #: number of points below each node, which may be 0
    order: IntArray  #: the point of each leaf, −1 for none
    depth: int  #: levels below the root

    def below(self, nodes: IntArray) -> tuple[IntArray, IntArray]:
        """All points below nodes, as two columns: index into ``nodes``, and point."""
        nodes = nodes.astype(int)
        level = np.frexp(nodes + 1)[1].astype(int) - 1
        leaves_below = 1 << (self.depth - level)
        first_leaf = (nodes + 1 - (1 << level)) * leaves_below
        places = np.repeat(np.arange(nodes.size), leaves_below)
        offset = np.cumsum(leaves_below) - leaves_below
        leaves = np.arange(places.size) + (first_leaf - offset)[places]
        with_point = self.order[leaves] >= 0
        return places[with_point], self.order[leaves[with_point]]

    def hulls(self, ends: FloatArray) -> FloatArray:
        """Hull of the boxes of all points below each node, (2, n, nodes); ``ends`` are those of the
        points, (2, n, points).
        """
        empty = np.full((*ends.shape[:2], 1), -np.inf)  # of leaves without a point, index −1
        levels = [np.concatenate([ends, empty], axis=2)[:, :, self.order]]
        for _ in range(self.depth):
            levels.append(levels[-1].reshape(*ends.shape[:2], -1, 2).max(axis=3))
        return np.concatenate(levels[::-1], axis=2)

    def children(self, nodes: IntArray) -> tuple[IntArray, IntArray]:
        """All children that have points, as two columns: index into ``nodes``, and child."""
        children = np.concatenate([2 * nodes + 1, 2 * nodes + 2])
        with_points = np.flatnonzero(self.size[children] > 0)
        return with_points % nodes.size, children[with_points]


def tree(low: FloatArray, high: FloatArray) -> Tree:
    """The tree of parameter points (or boxes) ``low`` to ``high``, (parameters, points): each node
    is halved in the parameter in which its points are spread most.
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
            spread = np.nan_to_num((most - least) / scale[:, None], nan=-1.0)
            order = _halved(blocks, low, spread.argmax(axis=0))
    bounds = Intervals.between(np.concatenate(lows, axis=1), np.concatenate(highs, axis=1))
    return Tree(bounds, np.concatenate(sizes), order, depth)


def _halved(blocks: IntArray, low: FloatArray, along: IntArray) -> IntArray:
    """Blocks of points reordered so that the first half of each has the smaller values of its
    parameter ``along``; missing points (−1) come last.
    """
    keys = np.where(blocks >= 0, low[along[:, None], blocks], np.inf)
    half = blocks.shape[1] // 2
    if half > 1:
        ranks = np.argpartition(keys, half - 1, axis=1)
    else:
        ranks = np.argsort(keys, axis=1, kind="stable")
    return np.take_along_axis(blocks, ranks, axis=1).reshape(-1)
