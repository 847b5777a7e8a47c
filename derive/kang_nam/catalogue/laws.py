"""Functions of the laws that the equations of motion are made of."""

import sympy as sp

from ...algebra import reached
from ...emit.function import Function, Module
from .. import mechanics
from ..nomenclature import V, creep, mu0, vx, x, y
from .arrangement import ANGLE0, further


def module() -> Module:
    friction, length = mechanics.friction().replace(sp.sign, reached), mechanics.spring_length()
    speeds = (vx, mu0, V, creep)
    return Module(
        "laws",
        "The length of the inclined spring, and the friction law.",
        (
            Function(
                "spring_length",
                "Length of the inclined spring.",
                "(6) corrected",
                (x, y, *ANGLE0),
                length,
                "L",
                further=further((x, y), length),
            ),
            Function(
                "friction",
                "The friction coefficient at the speed x' of the mass.",
                "(10)",
                speeds,
                friction,
                "mu",
                further=further(speeds, friction),
            ),
        ),
    )
