"""Claims about every direction of the spring and all parameters of many boxes: directions are cut into cells until decided."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...exact.affine import Affine, cosine_and_sine, sides
from ...parameters import NAMES, FloatArray

#: Cells of a box to begin with, how often one is halved in any case, and at most.
_CELLS, _ALWAYS, _HALVINGS = 4, 4, 40
#: Open cells with which a box is given up.
_OPEN = 64
#: A box is given up where the spread of an open quantity comes from its own sides: the direction adds less than this share.
_SHARE = 0.25


class Boxes(NamedTuple):
    """Corners of boxes, of shape (6, n) in the order of ``NAMES``, and the share of the whole that each of them is."""

    low: FloatArray
    high: FloatArray
    share: FloatArray

    def rows(self, index: NDArray[Any]) -> Boxes:
        """Some of them."""
        return Boxes(self.low[:, index], self.high[:, index], self.share[index])

    def middle(self) -> dict[str, FloatArray]:
        """Their middles, by parameter."""
        return dict(zip(NAMES, 0.5 * (self.low + self.high), strict=True))


@dataclass(frozen=True)
class Ground:
    """What a claim is tested with: cos θ, sin θ, cos θ₀, sin θ₀ and the parameters, over cells or at one θ of each box."""

    c: Affine
    s: Affine
    c0: Affine
    s0: Affine
    parameters: dict[str, Affine]

    def others(self) -> list[Affine]:
        """The parameters but θ₀, in order."""
        return [self.parameters[name] for name in NAMES[1:]]


class Line(NamedTuple):
    """A direction of the spring for each box that changes linearly over it: ``value`` in its middle, ``slopes`` to its sides."""

    value: FloatArray
    slopes: FloatArray

    def rows(self, index: NDArray[Any]) -> Line:
        """Those of some boxes."""
        return Line(self.value[index], self.slopes[:, index])

    def reach(self) -> FloatArray:
        """How far it goes from its value."""
        return np.asarray(np.abs(self.slopes).sum(axis=0))

    def where(self, mine: NDArray[np.bool_], other: Line) -> Line:
        """This one for some boxes, another for the rest."""
        return Line(np.where(mine, self.value, other.value), np.where(mine, self.slopes, other.slopes))


def constant(value: float, size: int) -> Line:
    """One direction for all boxes."""
    return Line(np.full(size, value), np.zeros((len(NAMES), size)))


def at(boxes: Boxes, line: Line) -> Ground:
    """One direction for each point of each box."""
    none = np.zeros(boxes.share.size)
    return over(boxes, line, line, none, none)


def over(boxes: Boxes, low: Line, high: Line, begin: FloatArray, end: FloatArray) -> Ground:
    """All directions between two, from one share of the way to another."""
    none = np.zeros_like(begin)
    *parameters, share = sides(np.vstack([boxes.low, begin]), np.vstack([boxes.high, end]))
    base = Affine(low.value, np.vstack([low.slopes, none]), none)
    way = Affine(high.value, np.vstack([high.slopes, none]), none) - base
    theta = base + share * way
    return Ground(*cosine_and_sine(theta), *cosine_and_sine(parameters[0]), dict(zip(NAMES, parameters, strict=True)))


class Verdict(NamedTuple):
    """Which cells are decided, and the quantities whose terms say which side of a box to cut where one is not."""

    done: NDArray[np.bool_]
    decisive: tuple[Affine, ...]


def covered(boxes: Boxes, low: Line, high: Line, test: Callable[[Ground], Verdict]) -> tuple[NDArray[np.bool_], FloatArray]:
    """The boxes for which all directions between two pass a test, and how much each side matters for the others."""
    size = boxes.share.size
    weight = np.zeros((len(NAMES), size))
    box = np.tile(np.arange(size), _CELLS)
    begin = np.repeat(np.arange(_CELLS) / _CELLS, size)
    end = begin + 1.0 / _CELLS
    result = np.ones(size, dtype=np.bool_)
    for halving in range(_HALVINGS + 1):
        if not box.size:
            break
        with np.errstate(all="ignore"):
            done, decisive = test(over(boxes.rows(box), low.rows(box), high.rows(box), begin, end))
        parts = [np.abs(np.nan_to_num(quantity.terms[:, ~done])) for quantity in decisive]
        useful = [part[-1] > _SHARE * part[:-1].sum(axis=0) for part in parts]
        hopeless = (~np.logical_or.reduce(useful) & (halving >= _ALWAYS)) | (halving == _HALVINGS)
        box, begin, end = box[~done], begin[~done], end[~done]
        for part in parts:
            sizes = part[:-1, hopeless]
            np.maximum.at(weight.T, box[hopeless], (sizes / np.maximum(sizes.sum(axis=0), 1e-300)).T)
        result[box[hopeless]] = False
        # A box with many open cells fails on a stretch of directions, and not at one: no cut of it helps.
        result[np.bincount(box, minlength=size) > _OPEN] = False
        keep = result[box]
        box, begin, end = box[keep], begin[keep], end[keep]
        middle = 0.5 * (begin + end)
        box, begin, end = np.tile(box, 2), np.concatenate([begin, middle]), np.concatenate([middle, end])
    return result, weight
