"""The solver for a block of points in NumPy, in float64 or double-double arithmetic, and the
storage of equilibria.

Columns hold the first equilibrium of every point; further ones, which few points have, are stored
apart: memory that is touched for the first time costs as much as the solution. Padded arrays with
an axis of slots are made when they are asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...generated import kernel
from ...numerics.double_double import DoubleDouble, cosine_and_sine
from ...numerics.interval_arrays import BoolArray, FloatArray, Int8Array, IntArray, quiet


@quiet()
def solve(values: list[FloatArray], contact: bool, out: Slots, begin: int, size: int) -> IntArray:
    """Solve ``size`` points, write settled ones to ``out`` from row ``begin`` on, and return the
    indices of the others.

    A point is settled if every root is certainly an equilibrium with 12 digits, or certainly none,
    all are different, and in contact their number is odd. ``values`` are θ₀, μ₀, κ, α, σ and β,
    arrays of length ``size`` or 1.
    """
    point = _point(values, contact)
    line = kernel.LineBalance(
        *(value if value.ndim else np.full(size, value) for value in kernel.balance(point))
    )
    return _simple_roots(point, line, np.float64(2.0**-53), out, begin, np.True_)


@quiet()
def solve_widely(
    values: list[FloatArray], contact: bool, out: Slots, begin: int, size: int
) -> IntArray:
    """:func:`solve` in double-double arithmetic, of points given by θ₀, μ₀, κ, α, σ and β, arrays
    of length ``size``.
    """
    theta0, *others = values
    point = kernel.Point(*cosine_and_sine(theta0), *[*map(DoubleDouble, others), int(contact)])
    line = kernel.balance(point)
    safe = kernel.moderate(point) & kernel.representable(line)
    return _simple_roots(point, line, np.float64(kernel.WIDE_ROUNDOFF), out, begin, safe)


def _simple_roots(
    point: kernel.Point,
    line: kernel.LineBalance,
    u: np.floating[Any],
    out: Slots,
    begin: int,
    safe: BoolArray | np.bool_,
) -> IntArray:
    """Settle the roots that every point has, one in contact and two in lift-off; then all roots of
    points with two more.
    """
    found, least = kernel.guesses(point, line, u), 1 if point.nbar else 2
    safe = safe & found.certain
    settled = safe & _some(found[:least], point, line, out, slice(begin, begin + safe.size), u)
    rows = np.flatnonzero(safe & (found.count > least))
    if rows.size:
        t = [value[rows] for value in found[: least + 2]]
        settled[rows] = _some(t, rows_of(point, rows), rows_of(line, rows), out, begin + rows, u)
    return np.flatnonzero(~settled)


@quiet()
def count(values: list[FloatArray], size: int) -> Int8Array:
    """The number of equilibria in contact, 0 where that is open."""
    found = kernel.one_or_three(_point(values, True), np.float64(2.0**-53))
    return np.array(np.broadcast_to(found, size), dtype=np.int8)


def _point(values: list[FloatArray], contact: bool) -> kernel.Point:
    """The kernel's record of points; a parameter with one value is a number."""
    theta0, *others = (value if value.size > 1 else value[0] for value in values)
    return kernel.Point(*kernel.cosine_and_sine(theta0), *[*others, int(contact)])


def _stacked(values: Sequence[Any]) -> DoubleDouble | FloatArray:
    if isinstance(values[0], DoubleDouble):
        return DoubleDouble(
            np.array([value.high for value in values]), np.array([value.low for value in values])
        )
    return np.array(values)


def rows_of(record: Any, rows: IntArray) -> Any:
    """A record of the kernel for some of its points."""
    return type(record)(*(value[rows] if getattr(value, "ndim", 0) else value for value in record))


def _columns(t: DoubleDouble | FloatArray, root: kernel.Root) -> dict[str, Any]:
    """The columns of roots."""
    wide = isinstance(t, DoubleDouble)
    # Double-double results are rounded to doubles: the arc tangent is within one unit in the last
    # place, and its argument is rounded.
    theta = 2.0 * (kernel.arctangent(t.high) if isinstance(t, DoubleDouble) else np.arctan(t))
    error = root.error + (4 * 2.0**-53) if wide else root.error
    return {
        "theta": theta,
        "L": root.L,
        "x": root.x,
        "y": root.y,
        "error": error,
        "undamped": root.code,
    }


def _some(
    roots: Sequence[Any],
    point: kernel.Point,
    line: kernel.LineBalance,
    out: Slots,
    rows: IntArray | slice,
    u: np.floating[Any],
) -> BoolArray:
    """Examine roots of points, one array for each root in ascending order; store the equilibria,
    and return a mask of the settled points.
    """
    t, alone = _stacked(roots), len(roots) == 1
    # Stacked roots share what depends on the point only; a single root is faster without the axis.
    root = kernel.at_root(roots[0] if alone else t, point, line, u)
    root = kernel.Root(*(value[None] for value in root)) if alone else root
    candidates = _columns(t, root)
    # An equilibrium with |error| ≤ 1e-12 · max(1, |value|), or certainly none.
    settled_roots = root.member & root.known & (candidates["error"] <= 1e-12) | root.outsider
    # Roots are different if their intervals are disjoint.
    settled: BoolArray = settled_roots.all(axis=0) & kernel.apart(
        t[:-1], root.radius[:-1], t[1:], root.radius[1:]
    ).all(axis=0)
    count, packed = gathered(root.member, candidates)
    if point.nbar > 0:
        settled &= (count % 2 == 1) & (t[0] > 0.0)
    out.put(rows, np.where(settled, count, 0), packed)
    return settled


#: The columns of an equilibrium, with the value in an empty slot, of the column's type.
COLUMNS: dict[str, np.float64 | np.int8] = {
    **dict.fromkeys(("theta", "L", "x", "y", "error"), np.float64(np.nan)),
    "undamped": np.int8(0),
}

#: Columns by name, of shape (points,) or (slots, points).
Columns = Mapping[str, NDArray[Any]]


@dataclass
class Slots:
    """Equilibria of ``size`` points, up to ``slots`` of each; ``count`` has their numbers.

    ``first`` has the first equilibrium of every point that has one. ``further`` has rows of points
    with their equilibria in slots 1 and up, of shape (further slots, len(rows)), NaN or 0 beyond
    the count; a later entry replaces an earlier one. Other slots are empty.
    """

    size: int
    slots: int
    count: Int8Array = field(init=False)
    first: dict[str, NDArray[Any]] = field(init=False)
    further: list[tuple[IntArray | slice, Columns]] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        self.count = np.zeros(self.size, dtype=np.int8)
        self.first = {name: np.empty(self.size, dtype=it.dtype) for name, it in COLUMNS.items()}

    def put(self, rows: IntArray | slice, count: NDArray[Any] | int, columns: Columns) -> None:
        """Store all equilibria of the points in ``rows``, columns of shape (slots, len(rows))."""
        self.count[rows] = count
        for name, values in columns.items():
            self.first[name][rows] = values[0]
        self.further.append((rows, {name: values[1:] for name, values in columns.items()}))

    def padded(self, name: str) -> NDArray[Any]:
        """A column of shape (size, slots), contiguous along points; NaN, or 0 for the stability,
        beyond the count.
        """
        table: NDArray[Any] = np.empty((self.slots, self.size), dtype=COLUMNS[name].dtype)
        table[0], table[1:] = self.first[name], COLUMNS[name]
        for rows, columns in self.further:
            table[1 : 1 + len(columns[name]), rows] = columns[name]
        table[:, self.count == 0] = COLUMNS[name]  # ``first`` is not initialized there
        return table.T


def gathered(members: BoolArray, candidates: Columns) -> tuple[IntArray, Columns]:
    """Move the equilibria among the candidates of each point to the front, and count them.

    Arrays have the shape (candidates, points); columns of points without a member are unchanged.
    """
    count = members.sum(axis=0)
    partial, packed = np.flatnonzero((0 < count) & (count < len(members))), candidates
    if partial.size:
        packed = {name: np.array(candidates[name], it.dtype) for name, it in COLUMNS.items()}
        slot = np.arange(len(members))[:, None]
        # Flat indices of the members, and of their places.
        order = np.argsort(~members[:, partial], axis=0, kind="stable")
        chosen, target = (members.shape[1] * rows + partial for rows in (order, slot))
        for name, table in packed.items():
            table.put(target, np.where(slot >= count[partial], COLUMNS[name], table.take(chosen)))
    return count, packed
