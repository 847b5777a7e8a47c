"""Claims about every direction of the spring and all parameters of many boxes: directions are cut into cells until decided."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..exact.affine import Affine, cosine_and_sine, sides
from ..parameters import NAMES, FloatArray

#: Cells of a box to begin with, and how often one is halved before the box is given up as it is.
CELLS, HALVINGS = 4, 6


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


def at(boxes: Boxes, theta: FloatArray) -> Ground:
    """One direction for each box, exactly."""
    return over(boxes, theta, theta)


def over(boxes: Boxes, theta_low: FloatArray, theta_high: FloatArray) -> Ground:
    """All directions between two."""
    *parameters, theta = sides(np.vstack([boxes.low, theta_low]), np.vstack([boxes.high, theta_high]))
    return Ground(*cosine_and_sine(theta), *cosine_and_sine(parameters[0]), dict(zip(NAMES, parameters, strict=True)))


class Verdict(NamedTuple):
    """Which cells need no further look, and the quantity whose terms say which side of a box to cut if one does."""

    done: NDArray[np.bool_]
    decisive: Affine


def covered(
    boxes: Boxes, theta_low: FloatArray, theta_high: FloatArray, test: Callable[[Ground], Verdict]
) -> tuple[NDArray[np.bool_], FloatArray]:
    """Of which boxes all directions between two pass a test, and how much each side matters where they don't."""
    size = boxes.share.size
    weight = np.zeros((len(NAMES), size))
    fractions = np.linspace(0.0, 1.0, CELLS + 1)
    ends = theta_low + fractions[:, None] * (theta_high - theta_low)
    ends[0], ends[-1] = theta_low, theta_high
    box = np.tile(np.arange(size), CELLS)
    low, high = ends[:-1].reshape(-1), ends[1:].reshape(-1)
    for halving in range(HALVINGS + 1):
        if not box.size:
            break
        with np.errstate(all="ignore"):
            done, decisive = test(over(boxes.rows(box), low, high))
        box, low, high = box[~done], low[~done], high[~done]
        if halving == HALVINGS:
            np.maximum.at(weight.T, box, np.nan_to_num(np.abs(decisive.terms[: len(NAMES), ~done]).T))
        else:
            middle = 0.5 * (low + high)
            box, low, high = np.tile(box, 2), np.concatenate([low, middle]), np.concatenate([middle, high])
    result = np.ones(size, dtype=np.bool_)
    result[box] = False
    return result, weight
