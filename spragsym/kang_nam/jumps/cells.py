"""Claims about every direction of the spring and all parameters of many boxes: directions are cut into cells until decided."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ...bifurcation.tubes import ByColumn
from ...design.certificates import Held
from ...models.parameters import NAMES, FloatArray
from ...numerics.affine import Affine, cosine_and_sine, sides
from ...numerics.interval_arrays import BoolArray

#: Cells of a box to begin with, how often one is halved in any case, and at most.
_CELLS, _ALWAYS, _HALVINGS = 4, 4, 40
#: Open cells with which a box is given up.
_OPEN = 64
#: A box is given up where the spread of an open quantity comes from its own sides: the direction adds less than this share.
_SHARE = 0.25


@dataclass(frozen=True)
class Boxes(Held):
    """Parts of a box of parameters, in the order of ``NAMES``, and then of units of measure over their base values.

    ``powers`` are, for each parameter that depends on units, the sides that these are, and the power of each.
    """

    powers: Mapping[str, tuple[tuple[int, int], ...]] = field(default_factory=dict)

    def parameters(self, sides: Iterable[Any]) -> dict[str, Any]:
        """Parameters by name from one value of each side, of any number type."""
        sides = list(sides)
        found = dict(zip(NAMES, sides, strict=False))
        for name, factors in self.powers.items():
            for side, power in factors:
                found[name] = found[name] * sides[side] ** power if power > 0 else found[name] / sides[side] ** -power
        return found

    def middle(self) -> dict[str, FloatArray]:
        """Their middles, by parameter."""
        return self.parameters(0.5 * (self.low + self.high))

    def change(self, changes: Mapping[str, FloatArray], term: Callable[[FloatArray], FloatArray] = np.positive) -> FloatArray:
        """What half of each side changes, from derivatives by each parameter: a unit changes all that depend on it.

        With ``np.abs`` for a ``term`` the value if nothing cancelled.
        """
        moved = self.parameters(sides(self.low, self.high))
        return np.asarray(sum(term(changes[name] * moved[name].terms) for name in NAMES))


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


@dataclass(frozen=True)
class Line(ByColumn):
    """A direction of the spring for each box that changes linearly over it: ``value`` in its middle, ``slopes`` to its sides."""

    value: FloatArray
    slopes: FloatArray

    def reach(self) -> FloatArray:
        """How far it goes from its value."""
        return np.asarray(np.abs(self.slopes).sum(axis=0))

    def where(self, mine: BoolArray, other: Line) -> Line:
        """This one for some boxes, another for the rest."""
        return Line(np.where(mine, self.value, other.value), np.where(mine, self.slopes, other.slopes))


def constant(value: float, boxes: Boxes) -> Line:
    """One direction for all boxes."""
    return Line(np.full(len(boxes), value), np.zeros_like(boxes.low))


def at(boxes: Boxes, line: Line) -> Ground:
    """One direction for each point of each box."""
    none = np.zeros(len(boxes))
    return over(boxes, line, line, none, none)


def over(boxes: Boxes, low: Line, high: Line, begin: FloatArray, end: FloatArray) -> Ground:
    """All directions between two, from one share of the way to another."""
    none = np.zeros_like(begin)
    *own, share = sides(np.vstack([boxes.low, begin]), np.vstack([boxes.high, end]))
    base = Affine(low.value, np.vstack([low.slopes, none]), none)
    way = Affine(high.value, np.vstack([high.slopes, none]), none) - base
    theta = base + share * way
    return Ground(*cosine_and_sine(theta), *cosine_and_sine(own[0]), boxes.parameters(own))


class Verdict(NamedTuple):
    """Which cells are decided, and the quantities whose terms say which side of a box to cut where one is not."""

    done: BoolArray
    decisive: tuple[Affine, ...]


def covered(boxes: Boxes, low: Line, high: Line, test: Callable[[Ground], Verdict]) -> tuple[BoolArray, FloatArray]:
    """The boxes for which all directions between two pass a test, and how much each side matters for the others."""
    size = len(boxes)
    weight = np.zeros_like(boxes.low)
    box = np.tile(np.arange(size), _CELLS)
    begin = np.repeat(np.arange(_CELLS) / _CELLS, size)
    end = begin + 1.0 / _CELLS
    result = np.ones(size, dtype=np.bool_)
    for halving in range(_HALVINGS + 1):
        if not box.size:
            break
        with np.errstate(all="ignore"):
            done, decisive = test(over(boxes[box], low[box], high[box], begin, end))
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
