"""The generated C solver on columns of points, where it was compiled on installation."""

import threading
from collections.abc import Callable, Sequence

import numpy as np

from ...models.load import fits
from ...numerics.interval_arrays import FloatArray, Int8Array, IntArray
from .block import COLUMNS, Slots

_ROOM = threading.local()
#: Points that are worth a thread of their own, and the same where they are only counted.
A_THREAD, A_COUNTING_THREAD = 1 << 15, 1 << 17


def available() -> bool:
    """Whether the extension module was built, and from the C library that was generated with the rest."""
    return fits(f"{__package__}._compiled")


def solve(values: Sequence[FloatArray], contact: bool, out: Slots, begin: int, size: int) -> IntArray:
    """:func:`.block.solve` in float64: write settled points to ``out`` and return which are not settled.

    ``values`` are θ₀, μ₀, κ, α, σ, β, contiguous, each of length ``size`` or 1.
    """
    from . import _compiled

    return _solve(_compiled.solve, values, contact, out, begin, size)


def solve_widely(values: Sequence[FloatArray], contact: bool, out: Slots, begin: int, size: int) -> IntArray:
    """:func:`.block.solve_widely`: double-double arithmetic."""
    from . import _compiled

    return _solve(_compiled.solve_widely, values, contact, out, begin, size)


def _solve(
    method: Callable[..., int], values: Sequence[FloatArray], contact: bool, out: Slots, begin: int, size: int
) -> IntArray:
    rows, further = _room(out.slots - 1, size)
    settled = np.empty(size, dtype=np.bool_)
    here = slice(begin, begin + size)
    first = tuple(out.first[name][here] for name in COLUMNS)
    some = tuple(column[:size] for column in further)
    theta0, mu0, kappa, alpha, sigma, beta = values
    results = settled, out.count[here], first, (rows[:size], *some)
    used = method(theta0, mu0, kappa, alpha, sigma, beta, int(contact), *results)
    if used:
        out.further.append((begin + rows[:used], {name: some[i][:used].T.copy() for i, name in enumerate(COLUMNS)}))
    return np.flatnonzero(~settled)


def count(values: Sequence[FloatArray], size: int) -> Int8Array:
    """The number of equilibria in contact, 0 where that is open; ``values`` as for :func:`solve`."""
    from . import _compiled

    counts = np.empty(size, dtype=np.int8)
    theta0, mu0, kappa, alpha, sigma, beta = values
    _compiled.count(theta0, mu0, kappa, alpha, sigma, beta, counts)
    return counts


def _room(slots: int, size: int) -> tuple[IntArray, tuple[FloatArray, ...]]:
    """Work arrays of one thread, used again for every block, for points with more than one equilibrium."""
    kept = _ROOM.__dict__.setdefault("by_slots", {})
    if slots not in kept or kept[slots][0].size < size:
        kinds = [np.int8 if name == "stability" else np.float64 for name in COLUMNS]
        kept[slots] = np.empty(size, dtype=np.int64), tuple(np.empty((size, slots), dtype=kind) for kind in kinds)
    return kept[slots]
