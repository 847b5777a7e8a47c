"""Functions of the laws that the equations of motion are made of."""

import sympy as sp

from ...algebra import reached
from ...emit.function import Function, Module
from .. import mechanics
from .. import nomenclature as nm
from .arrangement import ANGLE0, further


def module() -> Module:
    friction, length = mechanics.friction().replace(sp.sign, reached), mechanics.spring_length()
    speeds = (nm.vx, nm.mu0, nm.V, nm.creep)
    return Module(
        "laws",
        "The length of the inclined spring, and the friction law.",
        (
            Function(
                "spring_length",
                "Length of the inclined spring.",
                "(6) corrected",
                (nm.x, nm.y, *ANGLE0),
                length,
                "L",
                further=further((nm.x, nm.y), length),
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
