"""The field of the article's model, (8)–(11), from the generated functions."""

from __future__ import annotations

import inspect
import itertools
import math
from collections.abc import Sequence
from typing import Any

from ..dynamics import forces, simulate
from ..dynamics.problem import BELT_SPEED, CREEP, WIDTH, acceleration, constants_of, jacobian
from ..generated import motion
from ..parameters import NAMES, RANGES, FloatArray, Parameters, as_number
from .field import Border, Field, Mode

_by_parameters: Any = inspect.unwrap(motion.regime_by_parameters)

#: d |V − x'| beyond which the exponential of (10) is far below rounding, and left out.
REACH = 42.0

#: Of the parameters, in the order of the generated derivatives.
PARAMETERS = (*NAMES, "V", "d")

_RANGES = {**RANGES, "V": BELT_SPEED, "d": CREEP}


class _Damped:
    """A namespace whose exponential is multiplied by the mode's ``near``."""

    def __init__(self, xp: Any, near: Any) -> None:
        self.sqrt, self.exp = xp.sqrt, lambda z: near * xp.exp(z)


def _call(function: Any, state: Sequence[Any], constants: Sequence[Any], mode: Sequence[Any], xp: Any) -> Any:
    nbar, side, near = mode
    return function(*state, *constants, nbar, side, xp=_Damped(xp, near))


def _constants(values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
    if xp is None:
        return constants_of(tuple(values[:-2]), values[-2], values[-1])
    return (xp.cos(values[0]), xp.sin(values[0]), *values[1:])


def _layer(state: Any, constants: Any, mode: Any) -> Any:
    _, side, near = mode
    return (constants[8] * side * (constants[7] - state[2]) - WIDTH * near) / REACH - 1


def _layer_rate(_: Any, accelerations: Any, constants: Any, mode: Any) -> Any:
    return -constants[8] * mode[1] * accelerations[0] / REACH


def _initial_mode(state: Sequence[float], constants: Sequence[float]) -> Mode:
    _, y, vx, _ = state
    *_, V, d = constants
    return int(y <= 0), 1 if vx <= V else -1, int(d * abs(V - vx) <= REACH)


def _check(name: str, value: float) -> None:
    as_number(name, value, _RANGES[name])


#: y = 0, x' = V, and the layer in which the exponential of (10) is felt.
_BORDERS = (
    Border("y = 0", lambda q, *_: q[1], lambda q, *_: q[3], lambda mode: 1 - 2 * mode[0],
           lambda mode: (1 - mode[0], *mode[1:]), crossings=("contact_lost", "contact_regained")),
    Border("x' = V", lambda q, c, _: c[7] - q[2], lambda _, a, *__: -a[0], lambda mode: mode[1],
           lambda mode: (mode[0], -mode[1], mode[2]), crossings=("belt_overtakes", "mass_overtakes")),
    Border("layer", _layer, _layer_rate, lambda mode: 1 - 2 * mode[2], lambda mode: (*mode[:2], 1 - mode[2]), kink=False),
)  # fmt: skip


def _simulate(values: Sequence[float], state: Sequence[float], t_end: float, **options: Any) -> Any:
    p = Parameters(**dict(zip(NAMES, values[:-2], strict=True)))
    x0, y0, vx0, vy0 = map(float, state)
    return simulate(p, V=values[-2], d=values[-1], t_end=t_end, x0=x0, y0=y0, vx0=vx0, vy0=vy0, **options)


def _spring_force(states: FloatArray, constants: Sequence[float]) -> FloatArray:
    return forces.spring_force(states[0], states[1], constants[0], constants[1], constants[5])


def _contact_force(states: FloatArray, _: Sequence[float]) -> FloatArray:
    return forces.contact_force(states[1])


#: (8)–(11), over (contact, side, near).
SPRAG = Field(
    "kang_nam", ("x", "y"), PARAMETERS, _constants,
    lambda q, c, mode, xp=math: _call(acceleration, q, c, mode, xp),
    lambda q, c, mode, xp=math: _call(jacobian, q, c, mode, xp),
    lambda q, c, mode, xp=math: _call(_by_parameters, q, c, mode, xp),
    _BORDERS, _initial_mode, tuple(itertools.product((1, 0), (1, -1), (1, 0))), _check, _simulate,
    lambda mode: (mode[0], mode[1], 1),
    (("spring_force", _spring_force), ("contact_force", _contact_force)),
)  # fmt: skip
