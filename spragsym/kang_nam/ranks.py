"""Which equilibria at neighbouring values of a parameter lie on one branch: between folds they keep their order in θ."""

from __future__ import annotations

import itertools

from ..models.parameters import Parameters
from ..results.equilibria import Equilibria
from ..results.points import Points


def linked(_p: Parameters, _vary: str, eq: Equilibria, _turns: Points | None) -> list[dict[int, int]]:
    """For each step and each slot at its beginning, the slot at its end; over a step with a fold in it, none.

    Notes
    -----
    Source: f is continuous in θ and in the parameter, so that its roots exchange places only where two meet.
    """
    counts = eq.count.tolist()
    return [{rank: rank for rank in range(one)} if one == two else {} for one, two in itertools.pairwise(counts)]
