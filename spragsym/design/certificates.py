"""Certificate of a claim about every point of a box of parameters: proved, refuted by a point, or undecided."""

from __future__ import annotations

from dataclasses import dataclass

from ..models.parameters import Parameters
from ..results.result import Result


@dataclass(frozen=True)
class Certificate(Result):
    """Certificate of a claim over a box of parameters: proved, refuted or undecided.

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
