"""A model with shares h in [−1, 1] of the static friction coefficients as parameters.

With the friction coefficients h μ_s, a sticking state is an equilibrium at some shares.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any

from ..models.forces import named, presses_either, undecorated
from ..models.model import Model, parameter_class
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import Number


def held(p: ParameterSet, holding: Sequence[str] | None = None) -> ParameterSet:
    """The parameters as a set of the model with shares, all of which are 0.

    ``holding`` names the contacts whose friction coefficients become shares; by default all on
    which friction can hold.
    """
    if holding is None:
        holding = [entry["name"] for entry in p.model.frictions if entry["holds"]]
    kind = _model_held(p.model, tuple(holding))
    return kind(**{name: p[name] for name in p.ranges})


@cache
def _model_held(model: Model, holding: tuple[str, ...]) -> type[ParameterSet]:
    """The class of parameters of the model with shares."""
    about, arguments = dict(model.about), model.about["arguments"]
    shares = [named("held", name) for name in holding]
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
    about["frictions"] = [
        {**entry, "holds": None} if entry["name"] in holding else entry for entry in model.frictions
    ]
    about["contacts"] = [
        {**entry, "border": None} if presses_either(entry) else entry for entry in model.contacts
    ]
    laws = {
        named("friction_by_parameters", entry["name"]): _slopes(model, holding, entry["name"])
        for entry in model.frictions
    }
    for name, share_name in zip(holding, shares, strict=True):
        for law in (named(f"friction_at_{it}", name) for it in ("rest", "speed")):
            laws[law] = getattr(model.algebra, named("friction_held", name))
            arguments = arguments | {law: [*arguments["motion"], share_name]}
    about["arguments"] = arguments
    kind: Any = parameter_class(about, model.where)
    module: Any = SimpleNamespace(**vars(model.algebra) | laws)
    kind._model = Model(model.where, about, lambda: module, kind)
    return kind


def _slopes(model: Model, holding: tuple[str, ...], name: str) -> Callable[..., Any]:
    """The function that gives derivatives of a friction coefficient by parameters and then shares;
    it is linear in its share.
    """
    count, held_name = len(model.parameters), named("friction_held", name)
    own = undecorated(getattr(model.algebra, named("friction_by_parameters", name)))

    def by_parameters(*given: Any, xp: object = None) -> Sequence[Number]:
        return [*own(*given, xp=xp), *[0] * len(holding)]

    def by_shares(*given: Any, xp: object = None) -> Sequence[Number]:
        law, slopes = undecorated(getattr(model.algebra, held_name)), [0] * (count + len(holding))
        none, whole = (law(*given, share, xp=xp) for share in (0, 1))
        slopes[count + holding.index(name)] = whole - none
        return slopes

    return by_shares if name in holding else by_parameters
