"""Equilibrium at which a motion rests."""

import numpy as np

from ..generated import laws
from ..models.field import SETTLED
from ..models.parameters import FloatArray, Parameters
from ..numerics.interval_arrays import Int8Array


def rest_index(p: Parameters, places: FloatArray) -> Int8Array:
    """Index among ``equilibria`` at the friction μ(V), (10), of those at x, y, shape (2, …); −1 where there is none."""
    from .quartic.solver import equilibria

    x, y = places
    index = np.full(x.shape, -1, dtype=np.int8)
    rows = np.isfinite(x)
    if rows.any():
        given = {name: np.broadcast_to(getattr(p, name), x.shape)[rows] for name in p.ranges}
        given["mu0"] = laws.friction(np.zeros_like(given["V"]), given["mu0"], given["V"], given["d"])
        found = equilibria(Parameters(**given))
        away = np.hypot(found.x - x[rows][:, None], found.y - y[rows][:, None])
        away = np.where(np.isnan(away), np.inf, away)  # empty slots: all of them where the equilibria are undecided
        there = away.min(axis=-1) <= SETTLED * (1 + np.hypot(x[rows], y[rows]))
        index[rows] = np.where(there, np.argmin(away, axis=-1), -1)
    return index
