"""Motions of any model as problems for an integrator: one, or many of a sweep."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ParameterError
from ..models.model_field import field_of
from ..models.parameters import POSITIVE, ParameterSet, as_count, as_number
from .motions import Motions
from .problem import MAX_STEPS, RELATIVE_TOLERANCE, Problem

if TYPE_CHECKING:
    from ..models.model import Model
    from .sweeps.measure import Settings


def prepare(
    model: Model, p: ParameterSet, *, start: tuple[float, ...], t_end: float, rtol: float, t_record: float = 0.0,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    constants = model.field.constants(p.scalars(*model.parameters))
    check_start(model, constants, start)
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants, start, t_end, t_record, rtol, as_count("max_steps", max_steps), partial(field_of, model))


def _directions(model: Model, constants: Any, start: Any) -> Any:
    """Every inclined spring from end to end at a start, or at columns of many."""
    known = dict(zip(model.about["arguments"]["motion"], constants, strict=True))
    taken = [known[name] for name in model.about["arguments"]["statics"]]
    geometry = inspect.unwrap(model.algebra.geometry)  # its results need no common shape
    return geometry(*start[: len(model.coordinates)], *taken)


def _meet(model: Model, constants: Any, starts: Any) -> Any:
    """Whether both ends of a spring are at one point, for columns of many motions."""
    found = np.zeros(np.shape(starts)[1:], dtype=bool)
    for dx, dy, _ in _directions(model, constants, starts):
        found |= (np.asarray(dx) == 0) & (np.asarray(dy) == 0)
    return found


def check_start(model: Model, constants: Sequence[float], start: Sequence[float]) -> None:
    """Raise for a start where a spring has no length, and so no direction."""
    n = len(model.coordinates)
    for row, (dx, dy, _) in enumerate(_directions(model, constants, start)):
        if dx == 0 and dy == 0:
            name = model.about["springs"][row]["name"]
            raise ParameterError(
                f"the start {start[:n]} puts both ends of {name} on one point, where it has no direction; start anywhere else"
            )


def motions(model: Model, settings: Settings, points: Sequence[tuple[float, ...]]) -> tuple[Motions | None, dict[int, Exception]]:
    """The motions of points of a sweep, and why points have none."""
    count, errors = len(model.parameters), dict[int, Exception]()
    constants = np.array([model.field.constants(point[:count]) for point in points], dtype=np.float64)
    starts = np.array([point[count:] for point in points], dtype=np.float64)
    for i in np.flatnonzero(_meet(model, constants.T, starts.T)).tolist():
        try:
            check_start(model, constants[i].tolist(), points[i][count:])
        except ParameterError as error:
            errors[i] = error
    kept = [i for i in range(len(points)) if i not in errors]
    if not kept:
        return None, errors
    given = settings.t_end, settings.transient, settings.rtol, settings.max_steps
    return Motions(constants[kept], starts[kept], *given, partial(field_of, model)), errors
