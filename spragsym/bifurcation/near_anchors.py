"""Boxes around the anchor of a spring in which K is regular, though its entries have no bound there.

A spring of length l whose line has the direction n adds R/l to K, and R, −k r t t′ in its end with the undeformed length r and
t across n, has rank one. So l det K = l det K∞ + Σ cofactors of K∞ × R, which is smooth at l = 0 for each direction.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..numerics import jets
from ..numerics.arithmetic import cofactor, determinant
from ..numerics.interval_arrays import BoolArray, Intervals, Shape, raised, stacked
from ..statics.mechanics.balance import AWAY, Balance, taken
from ..statics.mechanics.forces import Values

#: Arcs of directions that are looked at one by one.
ARCS = 32
#: Lengths of which nothing is left in K.
ENDLESS = Intervals.between(np.array([1e290]), np.array([1e308]))


def regular_at_anchors(balance: Balance, q: Sequence[Intervals], values: Values, among: BoolArray) -> BoolArray:
    """Boxes at an anchor in which det K is not 0, whatever the direction of the spring is."""
    out = np.zeros(among.shape, dtype=np.bool_)
    if balance.torsions:
        return out
    for spring, (dx, dy) in enumerate(balance.anchors(q, values, among.shape)):
        near = np.hypot(dx.mignitude, dy.mignitude) <= AWAY * (dx.width + dy.width)
        rows = np.flatnonzero(among & ~out & near)
        if rows.size:
            out[rows] = _regular(balance, [part[rows] for part in q], taken(values, rows), rows.shape, spring)
    return out


def _regular(balance: Balance, q: Sequence[Intervals], values: Values, shape: Shape, spring: int) -> BoolArray:
    every, place = np.tile(np.arange(shape[0]), ARCS), 3 * spring
    q, values = [part[every] for part in q], taken(values, every)
    directions = balance.directions(q, values, every.shape)
    known, length = directions[place : place + 2], directions[place + 2]
    arcs = [part[np.repeat(np.arange(ARCS), shape[0])] for part in _arcs()]
    directions[place : place + 2] = arcs

    def slopes(at: Any) -> list[Any]:
        directions[place + 2] = at
        return [list(row) for row in balance.call("forces_jacobian", q, directions, values)]

    K = slopes(ENDLESS[np.zeros_like(every)])
    R = slopes(jets.Jet.variable(Intervals.point(np.ones(every.shape)), 0, 1))
    pushed = stacked(
        [-sum(cofactor(K, i, j) * jets.gradient(R[i][j], 1)[0] for i in range(len(K)) for j in range(len(K)))], every.shape
    )[0]
    whole = stacked([determinant(K)], every.shape)[0]
    ends = [pushed + whole * Intervals.point(end) for end in (length.low, length.high)]
    nonzero = np.logical_and.reduce([end.low > 0 for end in ends]) | np.logical_and.reduce([end.high < 0 for end in ends])
    elsewhere = np.logical_or.reduce(
        [(arc.low > part.high) | (arc.high < part.low) for arc, part in zip(arcs, known, strict=True)]
    )
    return np.logical_and.reduce((nonzero | elsewhere).reshape(ARCS, -1))


def _arcs() -> list[Intervals]:
    """Cosines and sines over arcs that cover the circle."""
    angles = np.linspace(0.0, 2 * np.pi, ARCS + 1)
    return [
        Intervals(raised(np.stack([-np.minimum(a[:-1], a[1:]), np.maximum(a[:-1], a[1:])]), 8))
        for a in (np.cos(angles), np.sin(angles))
    ]
