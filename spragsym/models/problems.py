"""Motions of any model as problems for an integrator: one, or many of a sweep."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from ..dynamics.motions import Motions
from ..dynamics.problem import MAX_STEPS, RELATIVE_TOLERANCE, Problem, as_steps
from ..errors import ParameterError
from ..parameters import POSITIVE, ParameterSet, as_number
from ..sweeps.measure import Settings, motions_at
from .field import field_of

if TYPE_CHECKING:
    from .model import Model


def prepare(
    model: Model, p: ParameterSet, *, start: tuple[float, ...], t_end: float, rtol: float, t_record: float = 0.0,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    p.scalars(*model.parameters)
    constants = tuple(float(value) for value in model.arguments(p, "motion"))
    check_start(model, constants, start)
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants, start, t_end, t_record, rtol, as_steps(max_steps), partial(field_of, model))


def check_start(model: Model, constants: tuple[float, ...], start: tuple[float, ...]) -> None:
    """Raise for a start where a spring has no length, and so no direction."""
    n = len(model.coordinates)
    known = dict(zip(model.about["arguments"]["motion"], constants, strict=True))
    taken = [known[name] for name in model.about["arguments"]["statics"]]
    for row, (dx, dy, _) in enumerate(model.statics.geometry(*start[:n], *taken)):
        if dx == 0 and dy == 0:
            name = model.about["springs"][row]["name"]
            raise ParameterError(f"the start {start[:n]} puts both ends of {name} on one point, where it has no direction")


def motions(model: Model, settings: Settings, points: Sequence[tuple[float, ...]]) -> tuple[Motions | None, dict[int, Exception]]:
    """The motions of points of a sweep, and why points have none."""
    count, errors = len(model.parameters), dict[int, Exception]()
    constants, starts = [], []
    for i, point in enumerate(points):
        p = model.Parameters(**dict(zip(model.parameters, point[:count], strict=True)))
        values, start = tuple(float(value) for value in model.arguments(p, "motion")), point[count:]
        try:
            check_start(model, values, start)
        except ParameterError as error:
            errors[i] = error
            continue
        constants.append(values)
        starts.append(start)
    return motions_at(settings, constants, starts, field_of=partial(field_of, model)), errors
