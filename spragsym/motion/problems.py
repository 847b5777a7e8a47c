"""A motion of any model as a problem for an integrator."""

from __future__ import annotations

import inspect
from functools import partial

import numpy as np

from ..errors import ParameterError
from ..models.model import Model
from ..models.model_field import field_of
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_count, as_number
from .problem import MAX_STEPS, RELATIVE_TOLERANCE, Problem


def prepare(
    model: Model, p: ParameterSet, *, start: tuple[float, ...], t_end: float, rtol: float, t_record: float = 0.0,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    constants = model.field.constants(p.scalars(*model.parameters))
    for error in without_direction(model, np.array(constants)[:, None], np.array(start)[:, None]).values():
        raise error
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants, start, t_end, t_record, rtol, as_count("max_steps", max_steps), partial(field_of, model))


def without_direction(model: Model, constants: FloatArray, starts: FloatArray) -> dict[int, ParameterError]:
    """Motions, columns each, whose start leaves a spring without length, and so without direction, and what is said of them."""
    known, found = dict(zip(model.about["arguments"]["motion"], constants, strict=True)), dict[int, ParameterError]()
    places, taken = starts[: len(model.coordinates)], [known[name] for name in model.about["arguments"]["statics"]]
    geometry = inspect.unwrap(model.algebra.geometry)  # its results need no common shape
    for row, (dx, dy, _) in enumerate(geometry(*places, *taken)):
        met = (np.asarray(dx) == 0) & (np.asarray(dy) == 0)
        for i in np.flatnonzero(np.broadcast_to(met, starts.shape[1])).tolist():
            start, name = tuple(places[:, i].tolist()), model.about["springs"][row]["name"]
            text = f"the start {start} puts both ends of {name} on one point, where it has no direction; start anywhere else"
            found.setdefault(i, ParameterError(text))
    return found
