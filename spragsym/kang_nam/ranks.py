"""Branch matching of the article's equilibria: between folds they keep their order in θ."""

import itertools

import numpy as np

from ..models.parameters import Parameters
from ..results.equilibria import Equilibria
from ..results.points import Points


def linked(
    _p: Parameters, vary: str, eq: Equilibria, turns: Points | None, *, most: int = 0, only: int | None = None
) -> list[dict[int, int]]:
    """For each step and each slot at its beginning, the slot at its end on the same branch; none over several folds at once.

    Notes
    -----
    Source: f is continuous in θ and in the parameter, so that its roots exchange places only where two meet. Of every fold it is
    proved which two of three these are. Of the two that begin at a pitchfork the upper goes on: along F_y = 0, x grows with θ.
    """
    values, counts = (np.asarray(column).tolist() for column in (getattr(eq.parameters, vary), eq.count))
    steps = list(itertools.pairwise(zip(values, counts, strict=True)))
    return [_over(one, two, vary, turns) for one, two in (steps if only is None else steps[only : only + 1])]


def _over(begin: tuple[float, int], end: tuple[float, int], vary: str, turns: Points | None) -> dict[int, int]:
    """One step, between values and numbers of equilibria there."""
    (one, before), (two, after) = begin, end
    if before == after or turns is None:
        return {slot: slot for slot in range(before)} if before == after else {}
    at = getattr(turns, vary)
    passed = np.flatnonzero((min(one, two) <= at) & (at <= max(one, two)) & np.isin(turns.kind, ("fold", "pitchfork")))
    if passed.size != 1:
        return {}
    (fold,) = passed
    if turns.kind[fold] == "pitchfork":
        return dict.fromkeys(range(before), 0) if before > after else {0: 2}
    left = 0 if turns.ends[fold] == "upper" else 2
    return {left: 0} if before > after else {0: left}


def open_ends(_p: Parameters, _vary: str, _span: tuple[float, float], _turns: Points) -> list[Points]:
    """None: no equilibrium has y = 0 (derive/kang_nam/theorem.py), and one or three are always there."""
    return []
