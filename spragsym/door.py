"""The door: ``ss.f(p)`` is asked of the model of ``p``, for every function of :data:`INTERFACE`.

The article's model is answered by closed forms, any other by its own method, and what a model can't answer yet is one error,
:class:`~spragsym.errors.ModelError`, that says so and what can be asked instead. The functions that hold the article's closed
forms are reached through here only, so that they are never handed the parameters of another model.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from .errors import ModelError, ParameterTypeError
from .parameters import Parameters, ParameterSet

#: Public functions that are asked of a model, each with what can be asked of one that has no answer to it.
INTERFACE = {
    "equilibria": "", "count": "", "folds": "", "cusps": "", "flutter_onsets": "", "bifurcation_set": "",
    "quasi_static_path": "", "simulate": "", "rms_sweep": "", "cycle": "", "lyapunov": "", "fate_boundary": "",
    "basin_boundary": "",
    "jump_value": "ss.quasi_static_path(p, vary, values) follows the state to its jump",
    "critical_friction": "ss.cusps(p) has all cusps in a range of friction",
    "cusp_friction": "ss.cusps(p) has all cusps in a range of friction",
    "critical_value": "ss.cusps(p) has all cusps at each value of a parameter",
    "flutter_boundary": "ss.flutter_onsets(p, vary=...) has the onsets along a line",
    "surface": "ss.equilibria(p) has all states over a grid of parameters",
    "linear_sprag": "ss.equilibria(p) has the states",
    "linear_critical_friction": "ss.folds(p, vary='mu0') has the frictions at which states meet",
    "jump_gradient": "ss.folds(p, vary=...) at neighbouring values has the differences",
    "jump_margin": "ss.folds(p, vary=...) has the folds along each parameter",
    "certify": "ss.count(p) and ss.equilibria(p) answer for points",
    "jump_probability": "ss.quasi_static_path(p, vary, values) answers for one point",
    "redesign": "ss.folds(p, vary=...) says where a parameter has to go",
    "basin": "ss.rms_sweep(p, x0=..., ...) has the regime of each start",
    "sensitivity": "ss.rms_sweep(p) over axes of parameters has the regimes",
}  # fmt: skip


def asked(closed: Callable[..., Any]) -> Callable[..., Any]:
    """The public function whose answer for the article's model is ``closed``."""
    name = closed.__name__

    @functools.wraps(closed)
    def ask(*args: Any, **options: Any) -> Any:
        sets = list(_sets((*args, *options.values())))
        other = next((p for p in sets if not isinstance(p, Parameters)), None)
        if other is None:
            return closed(*args, **options)
        model = model_of(other)
        for p in sets:
            if type(p) is not type(other):
                both = f"{model.name} and {model_of(p).name}"
                raise ParameterTypeError(f"{name}: the sets are of two models, {both}; give those of one")
        method = getattr(model, name, None)
        if method is None:
            instead = INTERFACE[name]
            raise ModelError(f"{name} is not there yet for the model {model.name}" + (f"; {instead}" if instead else ""))
        return method(*args, **options)

    return ask


def model_of(p: ParameterSet) -> Any:
    """The model of a set, also where one of its parameters is called ``model``."""
    return ParameterSet.model.fget(p)  # type: ignore[attr-defined]  # a property


def _sets(things: Iterable[Any]) -> Iterator[ParameterSet]:
    """The sets of parameters among arguments, those in a pair of corners included."""
    for thing in things:
        if isinstance(thing, ParameterSet):
            yield thing
        elif isinstance(thing, tuple):
            yield from _sets(thing)
