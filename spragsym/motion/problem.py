"""The initial value problem that an integrator solves, and its errors.

A :class:`Problem` holds the field, its constants, the initial state and the duration. The field is
piecewise smooth: it is analytic in each mode (contact open or closed, belt faster or slower than
the mass). Integrators stop at each border between modes and restart in the next mode.

A mode is left :data:`OVERSHOOT` beyond its border. Two crossings are therefore at least
2 OVERSHOOT apart, which stops chatter by rounding and lets a motion start exactly on a border. The
error is of order OVERSHOOT², or OVERSHOOT^1.5 where the motion only grazes the border, far below
rounding. Lengths, times and levels are of order 1 (:mod:`~spragsym.motion.scales`).

An exponential in the friction law, as in (10), has a boundary layer near sticking. A step from far
away cannot detect it, because all derivatives of the exponential are below rounding there. So the
exponential is omitted where it is below the tolerance, and the edge of the layer (``near``) is one
more border at which the integrator stops.
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
from ..models.field import SETTLED_SHARE, Field, Values, field_of
from ..models.forces import inertia_error, of_statics, undecorated
from ..models.model import Model
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, Range, as_count, as_number
from ..numerics.vectors import magnitude
from .options import MotionOptions
from .scales import MotionScales, scales_of

RELATIVE_TOLERANCE = Range(
    1e-13,
    1e-2,
    remedy="float64 carries no more, and less than that follows no oscillation; 1e-10 suits most",
)

#: Default maximum number of steps of a motion.
MAX_STEPS = 10_000_000

#: Steps that an explicit method does not begin where it looks stiff, and a fate in no case.
MANY_STEPS = 1e6

#: Steps between two checks for signals, since Python notices Ctrl-C only there, and for steps that
#: have collapsed: a second at most, or so.
BURST = 20_000


class Event(IntEnum):
    """Kind of event: which border of the piecewise smooth field the motion crosses, and how.

    ``CONTACT_LOST`` and ``CONTACT_REGAINED``: the gap passes 0. ``FACE_LEFT`` and
    ``FACE_REGAINED``: the same for a contact that presses on either of two faces, where its normal
    force passes 0. ``MASS_OVERTAKES`` and ``BELT_OVERTAKES``: the sliding speed passes 0. ``STICK``
    and ``SLIP``: friction begins to hold the mass on the belt, or ceases to.

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
    """Initial value problem from time 0 to ``t_end``; the solution is kept from ``t_record`` on."""

    constants: Any
    start: Values
    t_end: float
    t_record: float
    rtol: float
    #: None: the default of the integrator.
    max_steps: int | None
    #: ``field_of(reach)``: the field without exponentials of the friction law below exp(−reach).
    field_of: Callable[[float], Field]
    #: Units of all numbers, if these differ from the model's.
    scales: MotionScales | None = None
    options: MotionOptions = attribute(default_factory=MotionOptions)

    @property
    def reach(self) -> float:
        """Exponent beyond which exp(−exponent) in the friction law is below the tolerance, and
        omitted.
        """
        return 5 - math.log(self.rtol)

    @cached_property
    def field(self) -> Field:
        """The field of the motion."""
        return self.field_of(self.reach)

    @cached_property
    def own_scales(self) -> MotionScales:
        """Units to convert the problem to before integration: all 1 if it is in these already."""
        if self.scales:
            return MotionScales((1.0,) * len(self.field.coordinates), 1.0, ())
        return scales_of(self.field, self.constants, self.start)

    def time(self, t: float) -> float:
        """The time ``t`` in the model's unit."""
        return t * self.scales.time if self.scales else t

    @property
    def belt(self) -> float:
        """Sliding speed of a mass at rest; 1 for a model without friction."""
        for border in self.field.borders:
            if "mass_overtakes" in border.crossings:
                at_rest = [0.0] * self.field.size
                return float(border.level(at_rest, self.constants, self.field.modes[0]))
        return 1.0


def too_many_steps(problem: Problem, most: int, t: float, state: FloatArray) -> ConvergenceError:
    """The error of a motion that is incomplete at time ``t`` after ``most`` steps."""
    if _is_far(problem, state):
        return out_of_range(problem, t, state)
    made, more = "", ""
    if problem.max_steps:
        made, more = "max_steps = ", "a larger max_steps, "
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
    most: float = MANY_STEPS,
) -> None:
    """Raise StiffError if stability limits the mean ``step`` of an explicit method, and the time
    ``left`` would take more than ``most`` steps, so that an implicit method takes over. Raise
    ConvergenceError if the motion runs away instead.
    """
    if not left > most * step:
        return
    if left > (problem.max_steps or MAX_STEPS) * step and _is_far(problem, state):
        raise out_of_range(problem, problem.t_end - left, state)
    values, constants, field = [float(value) for value in state], problem.constants, problem.field
    m = field.deviations  # the rate of a clock decays to its own, and does not deviate
    jacobian = field.matrix(values, constants, field.initial_mode(values, constants))[:m, :m]
    # Explicit methods are unstable if step × fastest decay rate exceeds a number of order 1: a mean
    # step near that is limited by stability, not by accuracy.
    if np.isfinite(jacobian).all() and -step * np.linalg.eigvals(jacobian).real.min() > 0.5:
        raise StiffError(
            f"the motion is stiff: steps of {problem.time(step):.2g} are bounded by stability, "
            f"with {problem.time(left):.6g} to go"
        )


def _is_far(problem: Problem, state: Sequence[float] | FloatArray) -> bool:
    """True if a coordinate that is not periodic exceeds a million of the motion's units."""
    position = state[: len(problem.field.coordinates)]
    return any(
        abs(float(q)) > 1e6 for k, q in enumerate(position) if k not in problem.field.periodic
    )


def out_of_range(
    problem: Problem | None = None, t: float = 0.0, state: Sequence[float] | FloatArray = ()
) -> ConvergenceError:
    """The error of a motion that grows without bound: its numbers overflow, or, with a ``problem``,
    its steps become too short at time ``t`` and ``state``.
    """
    why = "it left the range of numbers"
    if problem is not None:
        units = problem.scales.states if problem.scales else 1.0
        place = problem.field.place(np.array(state) * units, ".3g")
        why = f"by t = {problem.time(t):.6g} it is at {place}, in ever shorter steps"
    return _unbounded(why)


def _unbounded(why: str) -> ConvergenceError:
    return ConvergenceError(
        f"the motion grows beyond all bounds: {why}; give a smaller "
        "t_end, or values of a more common size"
    )


def check_range(field: Field, state: FloatArray, units: FloatArray | float = 1.0) -> None:
    """Raise ConvergenceError for a state that, in ``units`` of the motion, is so far away that its
    rounding is as large as what counts as settled.
    """
    position = np.abs(state / units)[: len(field.coordinates)]
    position[[*field.periodic]] = 0.0
    if not magnitude(position) < SETTLED_SHARE * 2.0**53:
        raise _unbounded(f"it is at {field.place(state, '.3g')}, where rounding hides how it moves")


def kinds_of(field: Field) -> dict[tuple[int, int], Event]:
    """Kind of event by (number of the border, sign of its level after the crossing).

    Sign 0 is sticking. Crossings that are no event are missing.
    """
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
    """The problem with these arguments; raises ParameterError for invalid ones."""
    constants = model.field.constants(p.scalars(*model.parameters))
    if error := start_error(model, constants, start):
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


def start_error(model: Model, constants: Values, start: Values) -> ParameterError | None:
    """The error of a start at which a mass is not positive, or a spring has length 0, so that its
    force has no direction; None for other starts.
    """
    position, named = start[: len(model.coordinates)], model.about["arguments"]["motion"]
    M = np.array(undecorated(model.algebra.mass_matrix)(*position, *constants), dtype=float)
    if error := inertia_error(M[None], named, np.array(constants)[:, None]):
        return error
    geometry = undecorated(model.algebra.geometry)(*position, *of_statics(model, constants))
    for (dx, dy, _), spring in zip(geometry, model.about["springs"], strict=True):
        if dx == dy == 0:
            ends = f"both ends of {spring['name']} on one point"
            return ParameterError(
                f"the start {position} puts {ends}, where it has no direction; start anywhere else"
            )
    return None
