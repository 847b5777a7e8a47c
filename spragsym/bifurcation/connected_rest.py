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
from .sticking import belt_speeds, held
from .tubes import Tubes


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
    return any(
        _leads(balance, order, (begin.copy(), end), (one, other), near)
        for order in permutations(rows)
    )


def _used(balance: Balance, rows: list[int], column: FloatArray, state: FloatArray) -> FloatArray:
    """Shares of the static friction coefficients at a place, by least squares: forces are linear in
    them.
    """
    given = np.repeat(column[:, None], 1 + len(rows), axis=1)
    given[rows, 1 + np.arange(len(rows))] = 1.0
    at = balance.at(list(np.tile(state[:, None], given.shape[1])), balance.floats(given), xp=np)
    none, *whole = filled([at.rows("forces")], given.shape[1:])[0].T
    return np.clip(np.linalg.lstsq((whole - none).T, -none)[0], -1.0, 1.0)


def _leads(
    balance: Balance,
    order: tuple[int, ...],
    ends: tuple[FloatArray, FloatArray],
    places: tuple[FloatArray, FloatArray],
    near: FloatArray,
) -> bool:
    """Whether the state at the one place is that at the other when shares have moved in an
    order.
    """
    (column, goal), (q, other), last = ends, places, None
    for row in order:
        tubes = Tubes.of_points(balance, balance.parameters[row], column[:, None])
        here = tubes.place(np.append(q, column[row])[:, None])
        if not (_close(here.z[:-1, 0], q, near) if last is None else here.lies_in(last).all()):
            return False
        last = tubes.followed(here, goal[[row]])
        if not (last.sure & (last.v == goal[row])).all():
            return False
        column[row], q = goal[row], last.z[:-1, 0]
    return _close(q, other, near)


def _close(one: FloatArray, other: FloatArray, near: FloatArray) -> bool:
    return magnitude((one - other) / near) <= 1
