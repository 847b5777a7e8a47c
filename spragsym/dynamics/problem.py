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

import inspect
import math
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..errors import ConvergenceError, ParameterError, ParameterTypeError
from ..generated import motion
from ..parameters import FINITE, NAMES, POSITIVE, FloatArray, Parameters, Range, as_number

BELT_SPEED = Range(0.0, remedy="a belt that runs the other way is the mirror image: theta0 -> pi - theta0, x -> -x")
CREEP = Range(0.0, open_low=True, remedy="d is the steepness of the friction law (10); without it there is no friction")
RELATIVE_TOLERANCE = Range(
    1e-13, 1e-2, remedy="float64 carries no more, and less than that follows no oscillation; 1e-10 suits most"
)

#: Default number of steps after which a motion is given up.
MAX_STEPS = 10_000_000

#: How far beyond its border a mode is left, in L_0 and in units of speed.
GAP = 1e-12

#: Distance between dropping the exponential of (10) and including it again, in units of its exponent.
WIDTH = 5.0

#: x, y, x', y'.
State: TypeAlias = tuple[float, float, float, float]

#: Accelerations and their derivatives in one mode, continued beyond its borders: for scalars, without checks.
acceleration: Any = inspect.unwrap(motion.regime_rhs)
jacobian: Any = inspect.unwrap(motion.regime_jacobian)


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


class Mode(NamedTuple):
    """Where the field is analytic."""

    contact: int
    """1 in contact, 0 without."""
    side: int
    """1 where the belt is ahead of the mass, −1 where it is behind."""
    near: int
    """1 where the exponential of (10) is felt, 0 where it is left out."""


@dataclass(frozen=True)
class Problem:
    """One motion: its constants and initial state, and what to keep of it."""

    constants: Constants
    start: State
    t_end: float
    t_record: float
    rtol: float
    max_steps: int = MAX_STEPS

    @property
    def reach(self) -> float:
        """d |V − x'| beyond which the exponential of (10) is below the tolerance, and left out."""
        return 5 - math.log(self.rtol)

    @property
    def parameters(self) -> Parameters:
        """Those of the statics; the constants hold θ₀ by its cosine and sine."""
        cos0, sin0, mu0, kappa, alpha, sigma, beta, _, _ = self.constants
        return Parameters(theta0=np.arctan2(sin0, cos0), mu0=mu0, kappa=kappa, alpha=alpha, sigma=sigma, beta=beta)


# -------------------------------------------------------------------------------------------------- arguments


def prepare(
    p: Parameters, *, V: float, d: float, start: tuple[Any, ...], t_end: float, rtol: float, t_record: float = 0.0,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    values = p.scalars(*NAMES)
    x0, y0, vx0, vy0 = (as_number(name, value, FINITE) for name, value in zip(("x0", "y0", "vx0", "vy0"), start, strict=True))
    check_start(values[0], x0, y0)
    constants = constants_of(values, as_number("V", V, BELT_SPEED), as_number("d", d, CREEP))
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants, (x0, y0, vx0, vy0), t_end, t_record, rtol, as_steps(max_steps))


def constants_of(values: tuple[float, ...], V: float, d: float) -> Constants:
    """The constants for parameters in the order of NAMES, θ₀ first."""
    theta0, *rest = values
    return Constants._make((float(np.cos(theta0)), float(np.sin(theta0)), *rest, V, d))


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
    return ConvergenceError(
        f"max_steps = {problem.max_steps} steps were made by t = {t:.6g} of {problem.t_end:g}; give a larger max_steps, a "
        f"smaller t_end or a larger rtol than {problem.rtol:g}, or a smaller d than {problem.constants.d:g}, which makes "
        "creep stiff"
    )


def out_of_range() -> ConvergenceError:
    """The error of a motion whose numbers overflow."""
    return ConvergenceError("the motion left the range of numbers; give values of a more common size")


# ------------------------------------------------------------------------------------------------------ modes


def initial_mode(problem: Problem) -> Mode:
    """On a border both sides are right, since the field is continuous; contact, and the belt ahead, are chosen."""
    _, y, vx, _ = problem.start
    V, d = problem.constants[-2:]
    return Mode(int(y <= 0), 1 if vx <= V else -1, int(d * abs(V - vx) <= problem.reach))


def mode_beyond(border: int, mode: Mode) -> tuple[Mode, Event | None]:
    """The mode beyond one of the three borders, and the kind of event that passing it is, if it is one."""
    if border == 0:
        return mode._replace(contact=1 - mode.contact), Event.CONTACT_LOST if mode.contact else Event.CONTACT_REGAINED
    if border == 1:
        return mode._replace(side=-mode.side), Event.MASS_OVERTAKES if mode.side > 0 else Event.BELT_OVERTAKES
    return mode._replace(near=1 - mode.near), None


def is_inside(problem: Problem, mode: Mode, state: FloatArray) -> bool:
    """Whether a state lies in a mode, or beyond its borders by no more than the gap."""
    y, vx = float(state[1]), float(state[2])
    V, d = problem.constants[-2:]
    slip = mode.side * (V - vx)
    depth = d * slip - problem.reach - WIDTH * mode.near
    return min((-y if mode.contact else y), slip, -depth if mode.near else depth) >= -2 * GAP
