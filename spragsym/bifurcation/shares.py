"""A model whose friction coefficients are shares h in [−1, 1] of the static ones, and these are
parameters: with the coefficients h μ_s a state of sticking is an equilibrium at some shares.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..models.forces import named, presses_either, undecorated
from ..models.model import Model, parameter_class
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import Number


def belt_speeds(p: ParameterSet) -> Sequence[Any]:
    """Sliding speeds of what rests, of all frictions."""
    model = p.model
    levels = model.algebra.borders(
        *np.zeros(2 * len(model.coordinates)), *model.arguments(p, "motion")
    )
    return levels[len(model.contacts) :]


def held(p: ParameterSet, holding: Sequence[str] | None = None) -> ParameterSet:
    """Parameters of a model whose friction coefficients, those of some contacts or of all on which
    friction can hold, are parameters: the shares of the static ones that are used, of which none
    is.
    """
    if holding is None:
        holding = [entry["name"] for entry in p.model.frictions if entry["holds"]]
    kind = _model_held(p.model, tuple(holding))
    return kind(**{name: p[name] for name in p.ranges})


@cache
def _model_held(model: Model, holding: tuple[str, ...]) -> type[ParameterSet]:
    """The class of such parameters."""
    about, arguments = dict(model.about), model.about["arguments"]
    shares, laws = [named("held", name) for name in holding], _laws(model, holding)
    share = {
        "meaning": "share of the static friction coefficient that is used",
        "unit": "1",
        "role": "both",
        "base": 0.0,
        "domain": "[-1, 1]",
        "low": -1.0,
        "high": 1.0,
        "low_open": False,
        "high_open": False,
    }
    about["parameters"] = [*about["parameters"], *({"name": name, **share} for name in shares)]
    about["contacts"] = [
        {**entry, "border": None} if presses_either(entry) else entry for entry in model.contacts
    ]
    about["arguments"] = arguments | {name: [*arguments["motion"], *shares] for name in laws}
    kind: Any = parameter_class(about, model.where)
    module: Any = SimpleNamespace(**vars(model.algebra) | laws)
    kind._model = Model(model.where, about, lambda: module, kind)
    return kind


def _laws(model: Model, holding: tuple[str, ...]) -> dict[str, Any]:
    """Friction coefficients, and their slopes by the parameters, as functions of the shares too,
    the last arguments.
    """
    laws, count = dict[str, Any](), len(holding)
    for entry in model.frictions:
        name = entry["name"]
        slopes, position = named("friction_by_parameters", name), None
        own = undecorated(getattr(model.algebra, slopes))
        if name in holding:
            own = undecorated(getattr(model.algebra, named("friction_held", name)))
            position = holding.index(name)

        def law(
            *given: Any, xp: object = None, own: Callable[..., Any] = own, position: Any = position
        ) -> Number:
            return own(*given[:-count], given[position - count], xp=xp)

        def by_parameters(
            *given: Any,
            xp: object = None,
            own: Callable[..., Any] = own,
            position: int | None = position,
        ) -> tuple[Number, ...]:
            fixed, added = given[:-count], [0] * count
            if position is None:
                return *own(*fixed, xp=xp), *added
            none, whole = (own(*fixed, share, xp=xp) for share in (0, 1))
            added[position] = whole - none  # μ is linear in the share
            return *[0] * len(model.parameters), *added

        laws[slopes] = by_parameters
        if position is not None:
            laws |= {named(f"friction_at_{it}", name): law for it in ("rest", "speed")}
    return laws
