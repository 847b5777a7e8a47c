"""Statics of the model damped by the closed forms of the article's model, which is asked without
the dampers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..core.questions import NotInClosedForm
from ..design.jumps import Ends
from ..kang_nam import certificates, jump_values, lowest_fold, states
from ..kang_nam.bifurcation_sets import bifurcation_set as bifurcation_set_at_rest
from ..kang_nam.cusps import cusps as cusps_at_rest
from ..kang_nam.folds import folds as folds_at_rest
from ..kang_nam.parameters import NAMES, Parameters
from ..kang_nam.quartic import solver
from ..models.parameters import FloatArray, ParameterSet, Ranges, Span
from ..models.quantities import Unit
from ..numerics.interval_arrays import Int8Array
from ..results import Equilibria
from ..results.points import BifurcationSet, CriticalLoad, Points


def undamped(p: ParameterSet) -> Parameters:
    """The set of the article's model with the same states, of the same shape."""
    if p.followed is not None:
        raise NotInClosedForm
    values = {name: p[name] for name in Parameters.ranges}
    return Parameters(**values | {"kappa": np.broadcast_to(values["kappa"], p.shape)})


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
    if turns is None or vary not in NAMES or not eq.complete:
        raise NotInClosedForm
    return states.linked(undamped(p), vary, eq, turns, only=only)


def count(p: ParameterSet) -> Int8Array:
    """The closed form of :func:`spragsym.count`."""
    return solver.count(undamped(p))


def equilibria(p: ParameterSet, contact: bool = True) -> Equilibria:
    """The closed form of :func:`spragsym.equilibria`; stability is that with the dampers."""
    return replace(solver.equilibria(undamped(p), contact), parameters=p)


def border_ends(p: ParameterSet, vary: str, span: Span, turns: Points) -> list[Points]:
    """The closed form of :func:`spragsym.bifurcation.paths.border_ends`: there are none."""
    return states.border_ends(undamped(p), vary, span, turns)


def first_limit_points(
    p: ParameterSet, vary: str | None = None, *, direction: str = "up", begin: float | None = None
) -> Ends:
    """The closed form of :func:`spragsym.design.jumps.first_limit_points`."""
    return jump_values.first_limit_points(undamped(p), vary, direction=direction, begin=begin)


def limit_point_passed(
    p: ParameterSet,
    vary: str | None = None,
    begin: float | FloatArray | None = None,
    *,
    coarse: bool = False,
) -> FloatArray:
    """The closed form of :func:`spragsym.design.jumps.limit_point_passed`."""
    return jump_values.limit_point_passed(undamped(p), vary, begin, coarse=coarse)


def folds(p: ParameterSet, vary: str | None = None, *, between: Ranges | None = None) -> Points:
    """The closed form of :func:`spragsym.folds`."""
    return replace(folds_at_rest(undamped(p), vary, between=between), parameters=p)


def cusps(
    p: ParameterSet, vary: Sequence[str] | None = None, *, between: Ranges | None = None
) -> Points:
    """The closed form of :func:`spragsym.cusps`."""
    return replace(cusps_at_rest(undamped(p), vary, between=between), parameters=p)


def bifurcation_set(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int | None = None,
    *,
    between: Ranges | None = None,
) -> BifurcationSet:
    """The closed form of :func:`spragsym.bifurcation_set`."""
    found = bifurcation_set_at_rest(undamped(p), vary, n, between=between)
    return replace(found, cusps=replace(found.cusps, parameters=p))


def critical_friction(
    p: ParameterSet, vary: str | None = None, over: str | None = None
) -> CriticalLoad:
    """The closed form of :func:`spragsym.critical_friction`."""
    return lowest_fold.critical_friction(undamped(p), vary, over)


def claims(
    low: ParameterSet,
    high: ParameterSet,
    claim: str,
    *,
    vary: str | None = None,
    begin: float | None = None,
    units: Mapping[str, Unit] | None = None,
) -> certificates.ClosedClaim:
    """The closed form of :func:`spragsym.design.tube_certificates.claims`."""
    of_states = {
        name: replace(unit, powers={of: unit.powers[of] for of in unit.powers if of in _STATES})
        for name, unit in (units or {}).items()
    }
    ends = undamped(low), undamped(high)
    found = certificates.claims(*ends, claim, vary=vary, begin=begin, units=of_states)
    found.kind = low.model.Parameters
    return found


#: Parameters of the states.
_STATES = frozenset(Parameters.ranges)
