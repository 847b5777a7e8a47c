"""Parts of boxes of parameters, places at which tubes stand over them, regions that tubes pass through, and slopes over these.

The state moves with the parameters, and slopes depend on both. Affine arithmetic keeps that to first order, so that over a box
little more is left than slopes really vary by; intervals would take each entry of the matrix for its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Self

import numpy as np

from ...numerics import contractors
from ...numerics.affine import UNIT, Affine
from ...numerics.arithmetic import Matrix
from ...numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, matrix, stacked

Flags = BoolArray

#: A sum of a few products of floats, rounded up.
UP = 1 + 2.0**-40


@dataclass(frozen=True)
class ByColumn:
    """Arrays of which each column, along the last axis, is of one box; what is no array is of all."""

    def __getitem__(self, rows: Any) -> Self:
        return self._made(lambda part: part[rows] if isinstance(part, ByColumn) else part[..., rows])

    def then(self, others: Self) -> Self:
        """These, and others."""

        def joined(one: Any, other: Any) -> Any:
            return one.then(other) if isinstance(one, ByColumn) else np.concatenate([one, other], axis=-1)

        return self._made(joined, others)

    def _made(self, of: Callable[..., Any], *others: Self) -> Self:
        parts = {field.name: [getattr(each, field.name) for each in (self, *others)] for field in fields(self)}
        return replace(self, **{name: of(*each) for name, each in parts.items() if not isinstance(each[0], Mapping)})


def halves(low: FloatArray, high: FloatArray, weight: FloatArray) -> tuple[IntArray, FloatArray, FloatArray]:
    """Boxes, one a column, cut in the middle of their side of most weight: its number, and the
    upper ends of one half and the lower ones of the other.

    A side between whose ends there is no float is cut last.
    """
    column = np.arange(low.shape[1])
    some = slice(len(weight))
    side = np.where(np.nextafter(low[some], np.inf) < high[some], weight, -1.0).argmax(axis=0)
    middle = 0.5 * (low[side, column] + high[side, column])
    top, bottom = high.copy(), low.copy()
    top[side, column], bottom[side, column] = middle, middle
    return side, top, bottom


@dataclass(frozen=True)
class Region(ByColumn):
    """States z = m + a s + D (p − c) + u of boxes of parameters p, |s| ≤ moved and |u| ≤ off; ``box`` holds all of them.

    ``middle``, ``along`` and ``off`` have the shape (n + 1, N), ``moved`` (N,), ``by_p`` (n + 1, free, N).
    """

    box: Intervals
    middle: FloatArray
    along: FloatArray
    moved: FloatArray
    by_p: FloatArray
    off: FloatArray

    def numbers(self, apart: FloatArray) -> list[Affine]:
        """The coordinates and what moves, with s, then each p over its half-width, then each u for the sides."""
        size, free, count = self.by_p.shape
        found = []
        for i in range(size):
            terms = np.zeros((1 + free + size, count))
            terms[0], terms[1 : 1 + free], terms[1 + free + i] = self.along[i] * self.moved, self.by_p[i] * apart, self.off[i]
            found.append(Affine(self.middle[i], terms, 2 * UNIT * np.abs(terms).sum(axis=0)))
        return found


@dataclass(frozen=True)
class Parts(ByColumn):
    """Boxes of parameters, one a column: all of them, and middle and half-width of those that have a width or move.

    ``fixed`` has the shape (parameters, N), ``centre`` and ``half`` have (free, N).
    """

    fixed: FloatArray
    centre: FloatArray
    half: FloatArray

    @classmethod
    def points(cls, fixed: FloatArray) -> Parts:
        """Parameters of which none has a width."""
        nothing = np.zeros((0, fixed.shape[1]))
        return cls(fixed, nothing, nothing)

    def middles(self) -> Parts:
        """Regions of zero width: their midpoints."""
        return replace(self, half=np.zeros_like(self.half))


@dataclass(frozen=True)
class Place(ByColumn):
    """Where tubes stand: the middle z of the states there, how far the states of a box lie from it at most, and slopes D.

    Within ``room`` of z + D (p − c) each point p of the box has one state and no other, which lies within ``off`` of it, and
    within ``held`` of the middle. ``z``, ``held``, ``off`` and ``room`` have the shape (n + 1, N), ``by_p`` has (n + 1, free, N);
    ``sure`` where it is proved.
    """

    z: FloatArray
    held: FloatArray
    off: FloatArray
    room: FloatArray
    by_p: FloatArray
    sure: Flags

    def put(self, rows: Any, other: Place) -> None:
        """Take the places of some rows over."""
        for field in fields(self):
            getattr(self, field.name)[..., rows] = getattr(other, field.name)

    def box(self) -> Intervals:
        """All states there."""
        return Intervals(np.stack([-self.z, self.z]) + self.held + np.spacing(np.abs(self.z) + self.held))

    def region(self) -> Region:
        """The region over which slopes are evaluated."""
        return Region(self.box(), self.z, np.zeros_like(self.z), np.zeros(self.z.shape[1]), self.by_p, self.off)

    def lies_in(self, other: Place, n: int, shift: Any = 0.0, turned: Any = 0.0) -> Flags:
        """Whether its states are those of another place, which holds for all its parameters: by their n coordinates.

        ``shift`` is how far the states of the other move from its middle to this one's, ``turned`` how much the slopes of the
        two differ by over the box.
        """
        apart = np.abs(self.z - other.z - shift) + turned
        within = apart * UP + self.off * UP + 2 * np.spacing(np.abs(self.z) + np.abs(other.z) + self.held + np.abs(shift))
        return self.sure & other.sure & (within[:n] <= other.room[:n]).all(axis=0)


def beside_tube(
    place: Place, middle: FloatArray, along: FloatArray, by_p: FloatArray, apart: FloatArray, pivot: int
) -> FloatArray:  # fmt: skip
    """How far the states of a place lie from where a tube's middle moves to with the pivot and the parameters."""
    off = np.abs(place.z - middle - along * (place.z[pivot] - middle[pivot]))
    turned = np.abs(place.by_p - by_p - along[:, None] * (place.by_p[pivot] - by_p[pivot]))
    size = np.abs(place.z) + np.abs(middle) + place.held
    out = (off + (turned * apart).sum(axis=1) + place.off + np.abs(along) * place.off[pivot]) * UP + 4 * np.spacing(size)
    out[pivot] = 0.0
    return np.where(np.isfinite(out), out, np.inf)


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters: intervals, or affine numbers that ``Y`` has multiplied.

    ``zero`` is the 0 of their type; what belongs to the rows beside slopes ``Y`` multiplies as well.
    """

    rows: Matrix
    zero: Any
    Y: FloatArray | None = None

    def taken(self, value: Any) -> Intervals:
        """A number of the type as an interval."""
        return value if self.Y is None else value.interval()

    def forces(self, found: Intervals) -> Intervals:
        """Forces, shape (n, N), as these rows have them."""
        return found if self.Y is None else Intervals(contractors.product(self.Y, found.ends[:, :, None])[:, :, 0])

    def image(self, row: int, direction: FloatArray, start: Any = None) -> Any:
        """A row times a vector, shape (n + 1, N), and more: what is 0 for all boxes is left out."""
        terms = (self.rows[row][j] * part for j, part in enumerate(direction) if part.any())
        return sum(terms, self.zero if start is None else start)

    def newton(self, left: Sequence[Intervals], others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of a step of interval Newton for the unknowns ``others`` from what is left of the forces."""
        shape = reach.shape[1:]
        entries = matrix([[self.taken(row[j]) for j in others] for row in self.rows], shape)
        given = stacked(left, shape), entries, np.zeros_like(reach), reach
        return contractors.newton(*given).ends if self.Y is None else contractors.by_rows(*given)


def of_affine(rows: Matrix, others: Sequence[int], shape: Shape) -> Slopes:
    """Slopes from rows of affine numbers, multiplied by the inverse of their midpoints before they become intervals."""
    middles = np.array([[_middle(row[j], shape) for j in others] for row in rows])
    Y, zero = contractors.inverse(middles), Affine(np.zeros(shape), np.zeros((1, *shape)))
    n = range(len(rows))
    return Slopes([[sum((rows[k][j] * Y[i, k] for k in n), zero) for j in range(len(rows[0]))] for i in n], zero, Y)


def _middle(entry: Any, shape: Shape) -> FloatArray:
    return np.broadcast_to(entry.value if isinstance(entry, Affine) else float(entry), shape)
