"""The generated C solver on columns of points, where it was compiled on installation."""

from collections.abc import Sequence
from functools import partial
from typing import Literal

import numpy as np

from ...core.extensions import extension
from ...numerics.interval_arrays import FloatArray, Int8Array, IntArray
from .block import COLUMNS, Slots


def available() -> bool:
    """Whether the extension module was built, from the present sources."""
    return extension("kang_nam.quartic._compiled") is not None


def solve(
    values: Sequence[FloatArray],
    contact: bool,
    out: Slots,
    begin: int,
    size: int,
    *,
    how: Literal["solve", "solve_widely"] = "solve",
) -> IntArray:
    """:func:`.block.solve` in float64, or as that says: write settled points to ``out`` and return
    which are not settled.

    ``values`` are θ₀, μ₀, κ, α, σ, β, contiguous, each of length ``size`` or 1.
    """
    from . import _compiled

    settled = np.empty(size, dtype=bool)
    rows = np.empty(size, dtype=int)
    here = slice(begin, begin + size)
    first = tuple(out.first[name][here] for name in COLUMNS)
    shape = size, out.slots - 1
    # The last is of the stability.
    further = (
        *np.empty((len(COLUMNS) - 1, *shape)),
        np.empty(shape, dtype=np.int8),
    )
    used = getattr(_compiled, how)(
        *values, int(contact), settled, out.count[here], first, (rows, *further)
    )
    if used:
        out.further.append(
            (
                begin + rows[:used],
                {
                    name: column[:used].T.copy()
                    for name, column in zip(COLUMNS, further, strict=True)
                },
            )
        )
    return np.flatnonzero(~settled)


#: :func:`.block.solve_widely`: double-double arithmetic.
solve_widely = partial(solve, how="solve_widely")


def count(values: Sequence[FloatArray], size: int) -> Int8Array:
    """The number of equilibria in contact, 0 where that is open; ``values`` as for
    :func:`solve`.
    """
    from . import _compiled

    counts = np.empty(size, dtype=np.int8)
    _compiled.count(*[*values, counts])
    return counts
