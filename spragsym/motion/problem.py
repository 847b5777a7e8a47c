"""One motion to integrate: its constants, where it starts, how long it runs, and the modes of its
field.

The field is continuous, and analytic in each of its modes: contact or not, belt ahead of the mass
or behind. A mode is left :data:`OVERSHOOT` beyond its border, so that two crossings are never
closer than 2 OVERSHOOT: that ends chatter by rounding, lets a motion start exactly on a kink, and
costs an error of the order of OVERSHOOT², or OVERSHOOT^1.5 where the motion only grazes the border,
far below rounding. Lengths, times and levels are numbers beside 1 (:mod:`~spragsym.motion.scales`).

An exponential of the friction law, as in (10), makes a layer where the mass nearly sticks that a
step from far away cannot see: all its derivatives are below rounding there. So it is left out where
it is below the tolerance, and the border of the layer (``near``) is one more that the integrator
stops at.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from dataclasses import field as attribute
from enum import IntEnum
from functools import cached_property, partial
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError, ParameterError
from ..models.field import Field, Values, field_of
from ..models.forces import of_statics, undecorated
from ..models.model import Model
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, Range, as_count, as_number
from .options import MotionOptions
from .scales import MotionScales, scales_of

RELATIVE_TOLERANCE = Range(
    1e-13,
    1e-2,
    remedy="float64 carries no more, and less than that follows no oscillation; 1e-10 suits most",
)

#: Default number of steps after which a motion is given up.
MAX_STEPS = 10_000_000

#: Steps between two looks at signals, for Python hears Ctrl-C only then, and at whether steps have
#: collapsed: at most a second or so.
BURST = 20_000


class Event(IntEnum):
    """Border of the piecewise smooth field that the motion crosses at an event.

    The first two are of the contact. One that presses on either of two faces leaves its own face
    where the normal force passes 0, and regains it. The mass overtakes the belt, or the belt the
    mass, where the sliding speed passes 0; where friction holds the mass there, it sticks, until it
    slips.

    Examples
    --------
    >>> import spragsym as ss
    >>> tr = ss.simulate(ss.Parameters.article(theta0=0.9), t_end=200.0)
    >>> Event(int(tr.events.which[0])).name
    'CONTACT_LOST'
    """

    CONTACT_LOST = 0
    CONTACT_REGAINED = 1
    MASS_OVERTAKES = 2
    BELT_OVERTAKES = 3
    STICK = 4
    SLIP = 5
    FACE_LEFT = 6
    FACE_REGAINED = 7


@dataclass(frozen=True)
class Problem:
    """One motion: its constants and initial state, and what to keep of it."""

    constants: Any
    start: Values
    t_end: float
    t_record: float
    rtol: float
    #: None for the limit that each integrator has of its own.
    max_steps: int | None
    #: The field, for a given reach of the exponentials of the friction law.
    field_of: Callable[[float], Field]
    #: Units of its numbers, where these are not the model's.
    scales: MotionScales | None = None
    options: MotionOptions = attribute(default_factory=MotionOptions)

    @property
    def reach(self) -> float:
        """Minus the exponent of an exponential of the friction law beyond which it is left out,
        below the tolerance.
        """
        return 5 - math.log(self.rtol)

    @cached_property
    def field(self) -> Field:
        """The field of the motion."""
        return self.field_of(self.reach)

    @cached_property
    def own_scales(self) -> MotionScales:
        """Units in which the motion is carried: 1 where its numbers are in them."""
        if self.scales:
            return MotionScales((1.0,) * len(self.field.coordinates), 1.0, ())
        return scales_of(self.field, self.constants, self.start)

    def time(self, t: float) -> float:
        """A time in the model's unit."""
        return t * self.scales.time if self.scales else t

    @property
    def belt(self) -> float:
        """Sliding speed of a mass at rest; 1 for a model without friction."""
        still = [0.0] * self.field.size
        slip = next(
            (border for border in self.field.borders if "mass_overtakes" in border.crossings), None
        )
        return (
            1.0 if slip is None else float(slip.level(still, self.constants, self.field.modes[0]))
        )


def too_many_steps(problem: Problem, most: int, t: float, state: FloatArray) -> ConvergenceError:
    """The error of a motion that has used its steps, as many as were asked for or as there are for
    any.
    """
    if _is_far(problem, state):
        return out_of_range(problem, t, state)
    made, more = ("max_steps = ", "a larger max_steps, ") if problem.max_steps else ("", "")
    return ConvergenceError(
        f"{made}{most} steps were made by t = {problem.time(t):.6g} of "
        f"{problem.time(problem.t_end):g}; give {more}a "
        f"smaller t_end or a larger rtol than {problem.rtol:g}, or a less steep friction law: "
        "creep is stiff where it is steep"
    )


class StiffError(ConvergenceError):
    """The steps of an explicit method have collapsed."""


def check_stiffness(
    problem: Problem,
    state: Sequence[float] | FloatArray,
    step: float,
    left: float,
    most: float = 1e6,
) -> None:
    """Raise where steps of a mean length are bounded by stability, and more than ``most`` of them
    would be left, so that an implicit method takes over; or more than there are of a motion that is
    far from all that it began with.
    """
    if not left > most * step:
        return
    if left > (problem.max_steps or MAX_STEPS) * step and _is_far(problem, state):
        raise out_of_range(problem, problem.t_end - left, state)
    values, constants, field = [float(value) for value in state], problem.constants, problem.field
    matrix = field.matrix(values, constants, field.initial_mode(values, constants))
    # Stability bounds a step where it is longer than this, times the fastest decay.
    if np.isfinite(matrix).all() and -step * np.linalg.eigvals(matrix).real.min() > 0.5:
        raise StiffError(
            f"the motion is stiff: steps of {problem.time(step):.2g} are bounded by stability, "
            f"with {problem.time(left):.6g} to go"
        )


def _is_far(problem: Problem, state: Sequence[float] | FloatArray) -> bool:
    """Whether a coordinate that does not come around is beyond a million units of the motion:
    nothing of its own size holds it.
    """
    places = state[: len(problem.field.coordinates)]
    return any(
        abs(float(place)) > 1e6 for k, place in enumerate(places) if k not in problem.field.periodic
    )


def out_of_range(
    problem: Problem | None = None, t: float = 0.0, state: Sequence[float] | FloatArray = ()
) -> ConvergenceError:
    """The error of a motion whose numbers overflow, or grow until its steps do not do."""
    why = "it left the range of numbers"
    if problem is not None:
        units = problem.scales.states if problem.scales else 1.0
        place = problem.field.place(np.array(state) * units, ".3g")
        why = f"by t = {problem.time(t):.6g} it is at {place}, in ever shorter steps"
    return ConvergenceError(
        f"the motion grows beyond all bounds: {why}; give a smaller "
        "t_end, or values of a more common size"
    )


def kinds_of(field: Field) -> dict[tuple[int, int], Event]:
    """Names of crossings of the borders, by number, to levels of a sign; nothing for some."""
    return {
        (row, sign): Event[name.upper()]
        for row, border in enumerate(field.borders)
        for sign, name in zip((1, -1, 0), border.crossings, strict=False)
        if name
    }


def prepare(
    model: Model,
    p: ParameterSet,
    *,
    start: Values,
    t_end: float,
    rtol: float,
    max_steps: int = MAX_STEPS,
) -> Problem:
    """The problem of these arguments, each of which is checked."""
    constants = model.field.constants(p.scalars(*model.parameters))
    if error := undirected(model, constants, start):
        raise error
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(
        constants,
        start,
        t_end,
        0.0,
        rtol,
        as_count("max_steps", max_steps),
        partial(field_of, model),
    )


def undirected(model: Model, constants: Values, start: Values) -> ParameterError | None:
    """The error of a motion that starts with a spring that has no length, and so no direction."""
    position, geometry = start[: len(model.coordinates)], undecorated(model.algebra.geometry)
    for (dx, dy, _), spring in zip(
        geometry(*position, *of_statics(model, constants)), model.about["springs"], strict=True
    ):
        if dx == dy == 0:
            ends = f"both ends of {spring['name']} on one point"
            return ParameterError(
                f"the start {position} puts {ends}, where it has no direction; start anywhere else"
            )
    return None
