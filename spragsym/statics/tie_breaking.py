"""The order of states, and which is "the smallest" or "the nearest" one, where two are alike to within their errors."""

import numpy as np

from ..numerics.interval_arrays import FloatArray, IndexArray, IntArray

#: Numbers that differ by less than so many bounds of their errors are taken as alike: their sizes and distances are rounded, too.
ALIKE = 8.0
#: Numbers that differ by less than this, over 1 and their size, are equal.
EQUAL = 1e-12


def least_slot(measure: FloatArray, states: FloatArray, error: FloatArray) -> IndexArray:
    """The slot of the least measure, and of those that are alike the one of larger coordinates, the first one first.

    ``measure`` and ``error``, bounds over max(1, |coordinate|), have the shape (..., slots), the coordinates ``states`` have
    (n, ..., slots); slots that are not asked for have an infinite measure.

    Examples
    --------
    >>> h = np.array([-0.2, 0.5, 0.2])
    >>> x = np.array([-6e-19, 0.0, 1e-17])
    >>> int(least_slot(np.abs(x), np.array([x, h]), np.full(3, 1e-16)))
    1
    """
    sizes = np.maximum(1.0, np.abs(states).max(axis=0))
    room = ALIKE * np.nan_to_num(error * sizes).max(axis=-1, keepdims=True, initial=0.0)
    left = np.isfinite(measure)
    for one in (measure, *(-row for row in states)):
        here = np.where(left, one, np.inf)
        least = here.min(axis=-1, keepdims=True, initial=np.inf)
        left &= here <= least + room
    return left.argmax(axis=-1)


def in_order(rows: FloatArray, error: FloatArray, point: IntArray) -> IndexArray:
    """Numbers of states of some points in their order: by the rows from the first on, of which those that agree decide nothing.

    Two states that mirror each other have equal coordinates, of which rounding would make a first and a second. ``rows`` are
    coordinates, shape (n, states), ``error`` bounds over max(1, |coordinate|); states of one ``point`` are compared.
    """
    keys = []
    for row in rows:
        order = np.lexsort((row, point))
        near = EQUAL * (1 + np.abs(row[order])) + error[order] * np.maximum(1.0, np.abs(row[order]))
        begins = np.diff(row[order], prepend=-np.inf) > near + np.roll(near, 1)
        ranks = np.empty(order.size, dtype=np.intp)
        ranks[order] = np.cumsum(begins | (np.diff(point[order], prepend=-1) != 0))
        keys.append(ranks)
    return np.lexsort((*reversed(keys), point))
