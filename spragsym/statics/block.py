"""Solves a block of points in NumPy, in one float type: first points with one root, then points with several."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..generated import kernel
from .slots import Slots, gathered

#: Digits that every equilibrium has: |error| ≤ TOLERANCE · max(1, |value|).
TOLERANCE = 1e-12


def solve(point: kernel.Point, size: int, out: Slots, begin: int, dtype: type[np.floating[Any]]) -> NDArray[np.int64]:
    """Solve ``size`` points, write what is settled to ``out`` from row ``begin`` on, and return which of them are not.

    Settled: every root is an equilibrium with its digits or certainly none, all of them are different, and in contact their
    number is odd.

    Parameters
    ----------
    point : Point
        Each an array of length ``size`` or one number for all.
    """
    u = dtype(np.finfo(dtype).eps / 2)
    contact = point.nbar > 0
    line = kernel.Balance(*np.broadcast_arrays(*kernel.balance(point), np.empty(size))[:-1])
    D = kernel.discriminant(line, u)
    halves = kernel.factors(line.a, line.b, line.d, line.m)
    large, small, _ = kernel.root_pair(halves.p1, halves.q1)
    upper: NDArray[Any] = kernel.where(large > 0.0, large, small)

    # The first factor has one positive and one negative root. The second matters where it may have real roots; in contact only
    # where these may be positive, since no equilibrium in contact has sin θ < 0.
    paired = ~(D.value > D.error)
    if contact:
        paired &= ~kernel.one_positive(line, u)
        settled = _one_each(upper, point, line, out, begin, u)
    else:
        settled = _some(np.stack([np.where(large > 0.0, small, large), upper]), point, line, out, begin + np.arange(size), u)
    pairs = np.flatnonzero(paired)
    if pairs.size:
        t = [upper] if contact else [large, small]
        one, other, _ = kernel.root_pair(halves.p2[pairs], halves.q2[pairs])
        roots = np.sort(np.stack([*(value[pairs] for value in t), one, other]), axis=0)
        settled[pairs] = _some(roots, rows_of(point, pairs), rows_of(line, pairs), out, begin + pairs, u)
    return np.flatnonzero(~settled)


def rows_of(record: Any, rows: NDArray[np.int64]) -> Any:
    """Some of the points of a record."""
    return type(record)(*(value[rows] if np.ndim(value) else value for value in record))


def _columns(t: Any, root: kernel.Root, rounding: float) -> dict[str, Any]:
    theta, error = 2.0 * np.arctan(t), root.error + rounding
    return {"theta": theta, "L": root.L, "x": root.x, "y": root.y, "error": error, "stability": root.code}


def _rounding(u: np.floating[Any]) -> float:
    """The rounding error made by storing a wider type as float64."""
    return 0.0 if u > 1e-17 else 1.2e-16


def _sure(root: kernel.Root, u: np.floating[Any]) -> Any:
    return root.member & root.known & (root.error <= TOLERANCE - _rounding(u))


def _one_each(
    t: NDArray[Any], point: kernel.Point, line: kernel.Balance, out: Slots, begin: int, u: np.floating[Any]
) -> NDArray[np.bool_]:
    """Points in contact with one root: settle those where the root certainly is an equilibrium."""
    root = kernel.at_root(t, point, line, u)
    settled: NDArray[np.bool_] = _sure(root, u) & (t > 0.0)
    rows = slice(begin, begin + t.size)
    # Every point in contact has a first equilibrium, so points that are not settled here are overwritten later.
    for name, values in _columns(t, root, _rounding(u)).items():
        out.first[name][rows] = values
    out.count[rows] = settled
    return settled


def _some(
    t: NDArray[Any], point: kernel.Point, line: kernel.Balance, out: Slots, rows: NDArray[np.int64], u: np.floating[Any]
) -> NDArray[np.bool_]:
    """Points with several roots, in ascending order along the first axis: all roots are examined in one call."""
    roots, points = t.shape
    every = np.tile(np.arange(points), roots)
    root = kernel.at_root(t.ravel(), rows_of(point, every), rows_of(line, every), u)
    sure = (_sure(root, u) | root.outsider).reshape(t.shape)
    radius = np.broadcast_to(root.radius, every.shape).reshape(t.shape)
    # Two proved roots are different when the intervals that hold them are.
    settled: NDArray[np.bool_] = sure.all(axis=0) & kernel.apart(t[:-1], radius[:-1], t[1:], radius[1:]).all(axis=0)
    columns = {name: values.reshape(t.shape) for name, values in _columns(t.ravel(), root, _rounding(u)).items()}
    count, packed = gathered(root.member.reshape(t.shape), columns, out.slots)
    if point.nbar > 0:
        settled &= (count % 2 == 1) & (t[0] > 0.0)
    out.put(rows, np.where(settled, count, 0), packed)
    return settled
