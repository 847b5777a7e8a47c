"""Places of rest in one connected set of states in which friction holds, of any forces.

Where the coefficients of friction are h_i μ_s,i with shares h_i in [−1, 1], a state of sticking is
an equilibrium for some shares. From those of one place to those of another the shares move one
after another, all in their box: where a tube holds one equilibrium at every step of the way, and
the last one is the other place, a path of such equilibria connects the two. A path that is not
found proves nothing.
"""

from __future__ import annotations

from itertools import permutations

import numpy as np

from ..models.forces import named
from ..models.parameters import ParameterSet
from ..numerics.interval_arrays import FloatArray
from ..numerics.vectors import magnitude
from ..statics.balance import Balance
from ..statics.forces import filled
from ..statics.search import columns
from .shares import belt_speeds, held
from .tubes import Place, Tubes, in_turn


def connected(p: ParameterSet, one: FloatArray, other: FloatArray, near: FloatArray) -> bool:
    """Whether two places of rest are proved to lie in one connected set of states in which friction
    holds.

    Parameters
    ----------
    p : ParameterSet
        Scalars.
    one, other : ndarray, shape (n,)
        Places of rest.
    near : ndarray, shape (n,)
        How far from a place its state may be.

    Returns
    -------
    bool
        False where that is not proved.
    """
    speeds = zip(p.model.frictions, belt_speeds(p), strict=False)
    holding = [entry["name"] for entry, speed in speeds if entry["holds"] and not np.any(speed)]
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
    """Shares of the static friction coefficients at a place, by least squares: forces are linear in
    them.
    """
    given = np.repeat(column[:, None], 1 + len(rows), axis=1)
    given[rows, 1 + np.arange(len(rows))] = 1.0
    at = balance.at(list(np.tile(state[:, None], given.shape[1])), balance.floats(given), xp=np)
    none, *whole = filled([at.rows("forces")], given.shape[1:])[0].T
    return np.clip(np.linalg.lstsq((whole - none).T, -none)[0], -1.0, 1.0)


def _close(place: Place, state: FloatArray, near: FloatArray) -> bool:
    return magnitude((place.z[:-1, 0] - state) / near) <= 1
