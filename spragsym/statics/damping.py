"""Damping of a model: dampers and the slope of the friction law, the damped coordinates, and whether K is symmetric."""

from typing import Any

import numpy as np

from ..numerics.interval_arrays import Intervals, matrix, stacked
from . import spectrum, stability
from .mechanics.balance import NOTHING, Balance

#: Coordinates up to which dampers are asked for, that vanish or do not vanish for all.
FAR = 1.0
#: Number of states at which it is looked at whether anything damps: some are in contact.
PLACES = 64


def only_damped(balance: Balance, over: Intervals) -> int | None:
    """The coordinate of the only entry of C that is not 0 by structure, on the diagonal; None if there is no such, or others.

    Dampers and slopes that are exactly 0 by the given parameters have no entry.
    """
    C = _entries(balance, balance.over(over))
    entries = [(i, j) for i, row in enumerate(C) for j, entry in enumerate(row) if not (isinstance(entry, int) and entry == 0)]
    return entries[0][0] if len(entries) == 1 and entries[0][0] == entries[0][1] else None


def _entries(balance: Balance, values: dict[str, Any], pushing: int | None = None) -> Any:
    """C at states of all kinds."""
    states = [Intervals.between(np.full((1,), -FAR), np.full((1,), FAR)) for _ in range(balance.n)]
    directions = [Intervals(np.ones((2, 1))) for _ in range(3 * balance.springs)]
    with np.errstate(all="ignore"):
        return balance.damping(states, directions, values, pushing)


def is_damped(balance: Balance, over: Intervals) -> bool:
    """Whether C is not 0 at generic states on the contact's side, where its laws have values."""
    point = np.repeat(0.5 * over.low + 0.5 * over.high, PLACES, axis=1)
    states = np.random.default_rng(0).uniform(-FAR, FAR, (balance.n, PLACES)) * np.geomspace(0.01, 3.0, PLACES)
    with np.errstate(all="ignore"):
        C = stability.linearization(balance, states, point)[1]
    return bool((np.isfinite(C) & (C != 0)).any())


def damped_by_friction_alone(balance: Balance, over: Intervals) -> int | None:
    """The coordinate that friction opposes, if nothing else damps for any parameter of the range; None if that is not known."""
    friction = balance.model.about["friction"]
    if friction is None or friction["along"] not in balance.coordinates:
        return None
    if balance.model.about["dampers"]:
        C = matrix(_entries(balance, balance.over(over), pushing=0), (1,))
        # They are known on their own in lift-off.
        if not balance.opens or not C.magnitude.max() <= NOTHING:
            return None
    return balance.coordinates.index(friction["along"])


def slope_over(balance: Balance, over: Intervals) -> Intervals:
    """The slope of the friction law over the ranges."""
    with np.errstate(all="ignore"):
        return stacked([balance.slope(balance.over(over))], over.shape[1:])[0]


def is_conservative(balance: Balance, over: Intervals) -> bool:
    """Whether all κ are real all over the ranges, whatever the state is: K is symmetric, or one number."""
    with np.errstate(all="ignore"):
        return bool(spectrum.without_flutter(balance, balance.prepared(over)).all())
