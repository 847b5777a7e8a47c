"""Cycles, exponents, fates and basins of any model's motion: the model's field, handed to :mod:`spragsym.cycles`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..cycles import basin_boundaries, exponents, fate_boundaries, finding, verdicts
from ..cycles.saddles import Saddle, equilibrium_near, saddle_near
from ..dynamics.field import Field
from ..dynamics.sprag import REACH
from ..dynamics.trajectory import initial_state
from ..errors import ConvergenceError, ParameterError
from ..parameters import POSITIVE, FloatArray, ParameterSet, as_number, as_numbers
from .equilibria import equilibria
from .field import field_of

if TYPE_CHECKING:
    from ..cycles import BasinBoundary, Cycle, Fate, FateBoundary, Lyapunov
    from .model import Model


def cycle(model: Model, p: ParameterSet, near: Any = None, **options: Any) -> Cycle:
    """As :meth:`spragsym.Model.cycle`."""
    return finding.cycle_near(field_of(model, REACH), p.scalars(*model.parameters), near, **options)


def lyapunov(model: Model, p: ParameterSet, *, start: Any = None, t_end: float = 4000.0, backend: str | None = None) -> Lyapunov:
    """As :meth:`spragsym.Model.lyapunov`."""
    field, values = field_of(model, REACH), p.scalars(*model.parameters)
    return exponents.exponents_of(field, values, _state(model, start), as_number("t_end", t_end, POSITIVE), backend)


def fate(model: Model, p: ParameterSet, *, start: Any = None, t_end: float = 40_000.0, backend: str | None = None) -> Fate:
    """As :meth:`spragsym.Model.fate`."""
    field, values = field_of(model, REACH), p.scalars(*model.parameters)
    return verdicts.fate_of(field, values, _state(model, start), as_number("t_end", t_end, POSITIVE), backend)


def fate_boundary(
    model: Model, p: ParameterSet, *, vary: str, bracket: tuple[float, float], start: Any = None, backend: str | None = None
) -> FateBoundary:
    """As :meth:`spragsym.Model.fate_boundary`."""
    if vary not in model.parameters:
        raise ParameterError(f"vary = {vary!r} is not one of {', '.join(model.parameters)}")
    ends = as_numbers("bracket", bracket)
    if ends.shape != (2,):
        raise ParameterError(f"bracket = {bracket} is no range; give its two ends")
    low, high = ends.tolist()
    values = p.replace(**{vary: low}).scalars(*model.parameters)
    return fate_boundaries.boundary_of(field_of(model, REACH), values, vary, (low, high), _state(model, start), backend)


def basin_boundary(
    model: Model, p: ParameterSet, *, plane: tuple[str, str], start: Any = None, saddle: Any = None,
    to: tuple[tuple[float, float], tuple[float, float]] | None = None, **options: Any,
) -> BasinBoundary:  # fmt: skip
    """As :meth:`spragsym.Model.basin_boundary`."""
    field, values = field_of(model, REACH), p.scalars(*model.parameters)
    names = (*model.coordinates, *model.rates)
    return basin_boundaries.boundary_of(
        field, values, _saddle(model, field, p, values, saddle), names, plane, _state(model, start), to, **options
    )


def _state(model: Model, start: Any) -> FloatArray:
    return np.array([float(value) for value in initial_state(model, start, {}).values()])


def _saddle(model: Model, field: Field, p: ParameterSet, values: tuple[float, ...], near: Any) -> Saddle:
    """The saddle from which to look: near a place that is given, or the one among the equilibria of steady sliding."""
    places = [as_numbers("saddle", near)] if near is not None else _places(model, p)
    found: list[Saddle] = []
    for place in places:
        if place.shape not in ((len(model.coordinates),), (2 * len(model.coordinates),)):
            raise ParameterError(
                f"saddle has the shape {place.shape}; give the {len(model.coordinates)} coordinates of a place near it"
            )
    for place in places:
        try:
            known = saddle_near(field, values, equilibrium_near(field, values, place))
        except ConvergenceError:
            continue
        if known is not None and not any(np.abs(known.state - other.state).max() < 1e-9 for other in found):
            found.append(known)
    if len(found) != 1:
        listed = "; ".join(str(np.round(each.state, 6).tolist()) for each in found) or "none"
        raise ParameterError(f"one saddle is needed to follow its stable manifold, there are: {listed}; give saddle= near one")
    return found[0]


def _places(model: Model, p: ParameterSet) -> FloatArray:
    found = equilibria(model, p)
    columns = np.array([getattr(found, name) for name in model.coordinates]).T
    places: FloatArray = columns[np.isfinite(columns).all(axis=1)]
    return places
