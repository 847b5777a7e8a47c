"""The friction law: its two smooth sides, and its value at steady sliding."""

from __future__ import annotations

import sympy as sp

from .mechanics import Mechanics
from .model import PageError

#: Sign of the sliding speed: 1 where the belt is ahead, −1 where the mass is.
SIDE = sp.Symbol("side", real=True)
_SLIP = sp.Symbol("slip", positive=True)


def smooth_friction(model: Mechanics) -> sp.Expr:
    """μ at the sliding speed belt − d(slide)/dt, without the absolute value and the sign that kink it, for either SIDE."""
    if model.page.sliding is None or model.slide is None:
        return sp.S.Zero
    law, slip = model.page.sliding.law, model.belt - model.page.rate(model.slide)
    ahead, behind = (model.scaled(sp.sympify(law(sign * _SLIP))) for sign in (1, -1))
    if sp.expand(ahead + behind) == 0:
        return SIDE * ahead.subs(_SLIP, SIDE * slip)
    forward, backward = ahead.subs(_SLIP, slip), behind.subs(_SLIP, -slip)
    return ((1 + SIDE) * forward + (1 - SIDE) * backward) / 2


def friction_at_rest(model: Mechanics) -> sp.Expr:
    """What μ is in the statics: the limit of the law that the page names, or the law at the belt's speed."""
    sliding = model.page.sliding
    if sliding is None:
        return sp.S.Zero
    ahead = model.scaled(sp.sympify(sliding.law(_SLIP)))
    if sliding.at_rest is None:
        return ahead.subs(_SLIP, model.belt)
    limit, named = sp.limit(ahead, _SLIP, sp.oo), model.scaled(sliding.at_rest)
    if sp.simplify(limit - named) != 0:
        raise PageError(
            sliding.line,
            f"at_rest is {named}, and the friction law at fast sliding is {limit}; name that limit, or leave at_rest out for μ(V)",
        )
    return named
