"""Many points of a space of parameters as a tree of boxes, so that one proof serves all points of a box."""

from dataclasses import dataclass

import numpy as np

from .interval_arrays import FloatArray, IntArray, Intervals


@dataclass(frozen=True)
class Tree:
    """A binary tree; node i has the children 2 i + 1 and 2 i + 2, and the root is node 0."""

    bounds: Intervals  #: the smallest box around the points of a node, (parameters, nodes)
    size: IntArray  #: number of points below each node; 0 for nodes that are not there
    order: IntArray  #: the points' numbers in the order of the leaves, which stand last; −1 where there is none
    depth: int  #: levels below the root

    def below(self, nodes: IntArray) -> tuple[IntArray, IntArray]:
        """Rows (place among ``nodes``, point) for all points of all of these nodes."""
        nodes = nodes.astype(np.int64)
        level = np.frexp(nodes + 1)[1].astype(np.int64) - 1
        span = 1 << (self.depth - level)
        ends = np.cumsum(span)
        places = np.repeat(np.arange(nodes.size), span)
        leaves = np.arange(places.size) + ((nodes + 1 - (1 << level)) * span - (ends - span))[places]
        there = self.order[leaves] >= 0
        return places[there], self.order[leaves[there]]

    def hulls(self, ends: FloatArray) -> FloatArray:
        """The hull of the boxes of all points below each node: ends of shape (2, n, points), result of shape (2, n, nodes)."""
        nothing = np.full((*ends.shape[:2], 1), -np.inf)  # of leaves that are not there, whose number is −1
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
    """Halve points, boxes of shape (parameters, points), by the parameter in which they are spread most, again and again."""
    count, points = low.shape
    depth = max(0, int(points - 1).bit_length())
    leaves = 1 << depth
    order = np.full(leaves, -1, dtype=np.int64)
    order[:points] = np.arange(points)
    low, high = (np.concatenate([part, np.full((count, leaves - points), np.nan)], axis=1) for part in (low, high))
    whole = np.fmax.reduce(high, axis=1, initial=-np.inf) - np.fmin.reduce(low, axis=1, initial=np.inf)
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
            order = _halved(blocks, low, np.nan_to_num((most - least) / scale[:, None], nan=-1.0).argmax(axis=0))
    bounds = Intervals(np.stack([-np.concatenate(lows, axis=1), np.concatenate(highs, axis=1)]))
    return Tree(bounds, np.concatenate(sizes), order, depth)


def _halved(blocks: IntArray, low: FloatArray, along: IntArray) -> IntArray:
    """Each block in the order of its parameter ``along``, those that are not there last."""
    keys = np.where(blocks >= 0, low[along[:, None], blocks], np.inf)
    half = blocks.shape[1] // 2
    ranks = np.argpartition(keys, half - 1, axis=1) if half > 1 else np.argsort(keys, axis=1, kind="stable")
    return np.take_along_axis(blocks, ranks, axis=1).reshape(-1)
