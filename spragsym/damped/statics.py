"""Statics of the model damped by the closed forms of the article's model, which is asked without
the dampers.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..core.questions import NotInClosedForm
from ..core.type_variables import T
from ..generated.quantities import PARAMETERS
from ..kang_nam import certificates, jump_values, lowest_fold, states
from ..kang_nam.bifurcation_sets import bifurcation_set as bifurcation_set_at_rest
from ..kang_nam.cusps import cusps as cusps_at_rest
from ..kang_nam.folds import folds as folds_at_rest
from ..kang_nam.parameters import Parameters
from ..kang_nam.quartic import solver
from ..models.parameters import ParameterSet
from ..models.quantities import Unit
from ..results import Equilibria
from ..results.points import BifurcationSet, Points


def undamped(p: ParameterSet) -> Parameters:
    """The set of the article's model with the same states, of the same shape."""
    if p.followed is not None:
        raise NotInClosedForm
    values = {name: p[name] for name in Parameters.ranges}
    return Parameters(**values | {"kappa": np.broadcast_to(values["kappa"], p.shape)})


def without_dampers(closed: Callable[..., T]) -> Callable[..., T]:
    """A closed form of the article's model, asked without the dampers; what has parameters has
    those with them.
    """

    @functools.wraps(closed)
    def asked(p: ParameterSet, *args: Any, **options: Any) -> T:
        found: Any = closed(undamped(p), *args, **options)
        if isinstance(found, BifurcationSet):
            found = replace(found, cusps=replace(found.cusps, parameters=p))
        elif isinstance(found, Equilibria | Points):
            found = replace(found, parameters=p)
        made: T = found
        return made

    return asked


bifurcation_set = without_dampers(bifurcation_set_at_rest)
border_ends = without_dampers(states.border_ends)
count = without_dampers(solver.count)
critical_friction = without_dampers(lowest_fold.critical_friction)
cusps = without_dampers(cusps_at_rest)
equilibria = without_dampers(solver.equilibria)
first_limit_points = without_dampers(jump_values.first_limit_points)
folds = without_dampers(folds_at_rest)
limit_point_passed = without_dampers(jump_values.limit_point_passed)


def linked(
    p: ParameterSet,
    vary: str,
    eq: Equilibria,
    turns: Points | None,
    *,
    only: int | None = None,
    options: object = None,
) -> list[dict[int, int]]:
    """The closed form of :func:`spragsym.bifurcation.branches.linked`, of states in contact.

    Notes
    -----
    Source: along F_y = 0, x grows with θ, so that their order is the same in both.
    """
    if turns is None or vary not in PARAMETERS or not eq.complete:
        raise NotInClosedForm
    return states.linked(undamped(p), vary, eq, turns, only=only)


def claims(
    corners: tuple[ParameterSet, ParameterSet],
    claim: str,
    *,
    vary: str | None = None,
    begin: float | None = None,
    units: Mapping[str, Unit] | None = None,
) -> certificates.ClosedClaim:
    """The closed form of :func:`spragsym.design.tube_certificates.claims`."""
    of_states = {
        name: replace(
            unit, powers={of: unit.powers[of] for of in unit.powers if of in Parameters.ranges}
        )
        for name, unit in (units or {}).items()
    }
    low, high = corners
    ends = undamped(low), undamped(high)
    found = certificates.claims(ends, claim, vary=vary, begin=begin, units=of_states)
    found.kind = low.model.Parameters
    return found
