"""What is known of a claim about every point of a box of parameters: proved, refuted by a point, or left open."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..display import Result
from ..parameters import Parameters


@dataclass(frozen=True)
class Unit:
    """A unit of measure that has a range too: its ends over its base value, and the power of it in each parameter.

    A parameter is P u₁^e₁ u₂^e₂ …, where P is what it is at the base values.
    """

    low: float
    high: float
    powers: Mapping[str, float]


@dataclass(frozen=True)
class Certificate(Result):
    """What is known of a claim over a box.

    Attributes
    ----------
    claim : str
        As given.
    outcome : str
        ``"proved"``, ``"refuted"`` or ``"undecided"``.
    counterexample : Parameters or None
        A point of the box at which the claim is false, if it is refuted.
    undecided : float
        Share of the volume of the box that is neither proved nor known to hold a counterexample.
    boxes : int
        Boxes that were looked at.
    """

    claim: str
    outcome: str
    counterexample: Parameters | None
    undecided: float
    boxes: int
