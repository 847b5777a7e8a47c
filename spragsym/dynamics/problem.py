"""One motion to integrate: the constants of (8)–(11), where it starts, how long it runs, and the modes of its field.

The field is continuous, and analytic in each of four modes: contact or not, belt ahead of the mass or behind. A mode is
left :data:`GAP` beyond its border, so that two crossings are never closer than 2 GAP: that ends chatter by rounding,
lets a motion start exactly on a kink, and costs an error of the order of GAP², or GAP^1.5 where the motion only grazes
the border, far below rounding.

The exponential of (10) makes a layer at x' = V that a step from far away cannot see: all its derivatives are below
rounding there. So it is left out where it is below the tolerance, and the border of the layer (``near``) is one more
that the integrator stops at.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..errors import ConvergenceError, ParameterError, ParameterTypeError
from ..parameters import FINITE, POSITIVE, FloatArray, Parameters, Range, as_number
from . import sprag
from .field import GAP, WIDTH, Border, Field, Mode
from .sprag import acceleration, jacobian

__all__ = ["GAP", "WIDTH", "Mode", "acceleration", "jacobian"]

RELATIVE_TOLERANCE = Range(
    1e-13, 1e-2, remedy="float64 carries no more, and less than that follows no oscillation; 1e-10 suits most"
)

#: Default number of steps after which a motion is given up.
MAX_STEPS = 10_000_000

#: x, y, x', y'.
State: TypeAlias = tuple[float, float, float, float]


class Event(IntEnum):
    """What happens at an event."""

    CONTACT_LOST = 0
    CONTACT_REGAINED = 1
    MASS_OVERTAKES = 2
    BELT_OVERTAKES = 3


class Constants(NamedTuple):
    """Of (8)–(11), in the order in which the generated functions take them."""

    cos0: float
    sin0: float
    mu0: float
    kappa: float
    alpha: float
    sigma: float
    beta: float
    V: float
    d: float


@dataclass(frozen=True)
class Problem:
    """One motion: its constants and initial state, and what to keep of it; the field is the article's unless given."""

    constants: Any
    start: tuple[float, ...]
    t_end: float
    t_record: float
    rtol: float
    max_steps: int = MAX_STEPS
    #: The field, for a given reach of the exponentials of the friction law.
    field_of: Callable[[float], Field] = sprag.field
    #: Wells of the energy above the belt (:mod:`.lift_off`), where they are known.
    wells: tuple[tuple[float, float, float], ...] | None = None

    @property
    def reach(self) -> float:
        """Minus the exponent of an exponential of (10) beyond which it is left out."""
        return reach_of(self.rtol)

    @cached_property
    def field(self) -> Field:
        """The field of the motion."""
        return self.field_of(self.reach)

    @property
    def belt(self) -> float:
        """Sliding speed of a mass at rest; 1 for a model without friction."""
        still = [0.0] * self.field.size
        slip = next((border for border in self.field.borders if "mass_overtakes" in border.crossings), None)
        return 1.0 if slip is None else float(slip.level(still, self.constants, self.field.modes[0]))


def reach_of(rtol: float) -> float:
    """Minus the exponent of an exponential of (10) beyond which it is below a tolerance."""
    return 5 - math.log(rtol)


# -------------------------------------------------------------------------------------------------- arguments


def prepare(
    p: Parameters, *, start: tuple[Any, ...], t_end: float, rtol: float, t_record: float = 0.0, max_steps: int = MAX_STEPS
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    values = p.scalars(*p.ranges)
    x0, y0, vx0, vy0 = (as_number(name, value, FINITE) for name, value in zip(("x0", "y0", "vx0", "vy0"), start, strict=True))
    check_start(values[0], x0, y0)
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants_of(values), (x0, y0, vx0, vy0), t_end, t_record, rtol, as_steps(max_steps))


def constants_of(values: Sequence[float]) -> Constants:
    """The constants for parameters in their order, θ₀ first."""
    theta0, *rest = values
    return Constants._make((float(np.cos(theta0)), float(np.sin(theta0)), *rest))


def constants_of_many(values: FloatArray) -> tuple[Any, ...]:
    """Those of many motions: columns of all of them, from columns of the parameters, V and d."""
    theta0, *rest = values
    # One by one, so that no bit of a motion depends on where it stands in an array.
    return np.array(list(map(np.cos, theta0.tolist()))), np.array(list(map(np.sin, theta0.tolist()))), *rest


def parameters_of(constants: Any) -> Parameters:
    """Those of the statics, from the constants of one or of many motions, which hold θ₀ by its cosine and sine."""
    cos0, sin0, mu0, kappa, alpha, sigma, beta, _, _ = constants
    return Parameters(theta0=np.arctan2(sin0, cos0), mu0=mu0, kappa=kappa, alpha=alpha, sigma=sigma, beta=beta)


def check_start(theta0: float, x0: float, y0: float) -> None:
    """Raise for a start at the spring's anchor."""
    if (x0, y0) == (float(np.cos(theta0)), float(np.sin(theta0))):
        raise ParameterError(
            f"x0 = {x0:.17g}, y0 = {y0:.17g} is the spring's anchor (cos theta0, sin theta0), "
            "where L = 0 and the spring has no direction; start anywhere else"
        )


def as_steps(max_steps: int) -> int:
    """A number of steps, at least one."""
    if isinstance(max_steps, bool) or not isinstance(max_steps, int | np.integer):
        raise ParameterTypeError(f"max_steps = {max_steps!r} is not an int")
    if max_steps < 1:
        raise ParameterError(f"max_steps = {max_steps} is not at least 1; leave it out for {MAX_STEPS}")
    return int(max_steps)


def too_many_steps(problem: Problem, t: float) -> ConvergenceError:
    """The error of a motion that has used its steps."""
    than = f" than {problem.constants.d:g}" if isinstance(problem.constants, Constants) else ""
    return ConvergenceError(
        f"max_steps = {problem.max_steps} steps were made by t = {t:.6g} of {problem.t_end:g}; give a larger max_steps, a "
        f"smaller t_end or a larger rtol than {problem.rtol:g}, or a smaller d{than}, which makes creep stiff"
    )


def out_of_range() -> ConvergenceError:
    """The error of a motion whose numbers overflow."""
    return ConvergenceError("the motion left the range of numbers; give values of a more common size")


# ------------------------------------------------------------------------------------------------------ modes


def initial_mode(problem: Problem) -> Mode:
    """On a border either side is right, as the field is continuous: contact, and the belt ahead."""
    return problem.field.initial_mode(problem.start, problem.constants)


def event_at(border: Border, upward: bool) -> Event | None:
    """What a user calls crossing a border towards positive or negative levels, if anything."""
    name = border.crossings[0 if upward else 1]
    return Event[name.upper()] if name else None
