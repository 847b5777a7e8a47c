"""Bifurcation sets: curves of folds and their cusps in the plane of two parameters, one class for every model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..models.parameters import FloatArray
from .named_columns import Columns
from .points import Points
from .result import Result


@dataclass(frozen=True, eq=False)
class Curve(Columns, held_in="values"):
    """Folds in order along a curve: the parameters that vary and the coordinates are attributes under their own names.

    Curves of closed forms also say what ends there and where it jumps to: ``upper``, that the stable state that ends is the upper
    one of the two in θ, which changes at a cusp; ``when_theta0`` and ``when_mu0``, 1 where it ends as that parameter rises and −1
    where it ends as it falls; and ``theta_after``, ``x_after``, ``y_after``. Angles are radians.
    """

    values: Mapping[str, NDArray[Any]] = field(repr=False)

    def __len__(self) -> int:
        return len(next(iter(self.values.values())))


@dataclass(frozen=True, eq=False)
class BifurcationSet(Result):
    """Curves of folds in the plane of two parameters, and the cusps on them; ``complete`` says whether these are all.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
    curves : tuple of Curve
        Folds in the order in which they follow each other, as many as make straight lines between them look smooth. Of closed
        forms they are float64, and none of the curves is missed; of a search each point is proved, cusps stand among them, and
        that they are joined in the right order is not proved.
    cusps : Points
        All cusps of the region, proved.
    complete : bool
        Whether these are all: of closed forms always; of a search where all folds on all ``lines``, and all extrema and ends of
        curves, cusps among them, are proved: between two of these is a line, so that no curve is missed, however small.
    lines : mapping
        For each parameter the values at which all folds along the other one are known; empty where closed forms need none.
    undecided : ndarray
        Lower and upper ends of the boxes on lines that are not decided, shape (boxes, unknowns, 2): coordinates, then parameters.
    remarks : tuple of str
        Why the result is not complete: what is known of these boxes, and what was not searched.
    """

    vary: tuple[str, ...] = field(repr=False)
    curves: tuple[Curve, ...]
    cusps: Points
    complete: bool
    lines: Mapping[str, FloatArray] = field(default_factory=dict, repr=False)
    undecided: FloatArray = field(default_factory=lambda: np.empty((0, 0, 2)))
    remarks: tuple[str, ...] = ()

    @property
    def table_model(self) -> Any:
        """It knows which parameters are angles."""
        return self.cusps.parameters.model

    def __len__(self) -> int:
        return len(self.curves)
