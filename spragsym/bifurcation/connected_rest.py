"""Whether two positions of rest lie in one connected set of sticking states, for any forces.

With friction coefficients h_i μ_s,i and shares h_i in [−1, 1], a sticking state is an equilibrium
at some shares. The shares of one position are moved to those of the other, one after another,
within their box. If tubes prove one equilibrium all along, and the last one is the other position,
then a path of equilibria connects the two. If no such path is found, nothing is proved.
"""

from __future__ import annotations

from itertools import permutations

import numpy as np

from ..models.forces import named
from ..models.parameters import ParameterSet
from ..numerics.interval_arrays import FloatArray
from ..numerics.vectors import magnitude
from ..statics.balance import Balance
from ..statics.forces import filled, resting
from ..statics.search import columns
from .shares import held
from .tubes import Place, Tubes, in_turn


def connected(p: ParameterSet, one: FloatArray, other: FloatArray, near: FloatArray) -> bool:
    """Whether two positions of rest are proved to lie in one connected set of sticking states.

    Parameters
    ----------
    p : ParameterSet
        Scalars.
    one, other : ndarray, shape (n,)
        Positions of rest.
    near : ndarray, shape (n,)
        Largest distance of a position from its equilibrium, by coordinate.

    Returns
    -------
    bool
        False if that is not proved.
    """
    holding = resting(p)
    own, shares = held(p, holding), [named("held", name) for name in holding]
    balance = Balance(own.model, law="friction_at_speed")
    rows = [balance.parameters.index(name) for name in shares]
    begin, end = np.repeat(columns(own, balance.parameters), 2, axis=1).T
    for column, state in ((begin, one), (end, other)):
        column[rows] = _used(balance, rows, column, state)
    first = Tubes.of_points(balance, shares[0], begin[:, None])
    here = first.place(np.append(one, begin[rows[0]])[:, None])
    if not _close(here, one, near):
        return False
    for order in permutations(zip(shares, end[rows, None], strict=True)):
        there, proved = in_turn(balance, order, begin[:, None], here)
        if proved.all() and _close(there, other, near):
            return True
    return False


def _used(balance: Balance, rows: list[int], column: FloatArray, state: FloatArray) -> FloatArray:
    """The shares used at a position, by least squares, since forces are linear in them."""
    given = np.repeat(column[:, None], 1 + len(rows), axis=1)
    given[rows, 1 + np.arange(len(rows))] = 1.0
    at = balance.at(list(np.tile(state[:, None], given.shape[1])), balance.floats(given), xp=np)
    none, *whole = filled([at.rows("forces")], given.shape[1:])[0].T
    return np.clip(np.linalg.lstsq((whole - none).T, -none)[0], -1.0, 1.0)


def _close(place: Place, state: FloatArray, near: FloatArray) -> bool:
    """Whether a place lies within the distances ``near`` of a state."""
    return magnitude((place.z[:-1, 0] - state) / near) <= 1
