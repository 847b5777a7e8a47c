"""The field of the article's model, (8)–(11), for the search for cycles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from ..door import model_of
from ..dynamics import forces, simulate, sprag
from ..dynamics.field import Field
from ..dynamics.problem import constants_of
from ..parameters import FloatArray, Parameters, as_number


def _constants(values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
    if xp is None:
        return constants_of(values)
    return (xp.cos(values[0]), xp.sin(values[0]), *values[1:])


def _check(name: str, value: float) -> None:
    as_number(name, value, Parameters.ranges[name])


def _simulate(values: Sequence[float], state: Sequence[float], t_end: float, **options: Any) -> Any:
    x0, y0, vx0, vy0 = map(float, state)
    return simulate(Parameters(*values), t_end=t_end, x0=x0, y0=y0, vx0=vx0, vy0=vy0, **options)


def _spring_force(states: FloatArray, constants: Sequence[float]) -> FloatArray:
    return forces.spring_forces(model_of(Parameters()), states, constants)[0]


def _contact_force(states: FloatArray, constants: Sequence[float]) -> FloatArray:
    return forces.contact_force(model_of(Parameters()), states, constants)


#: The field that integrators have, with what the search for cycles needs besides.
SPRAG = replace(
    sprag.field(sprag.REACH), constants=_constants, check=_check, simulate=_simulate, exact=lambda mode: (mode[0], mode[1], 1),
    forces=(("spring_force", _spring_force), ("contact_force", _contact_force)), again=(__name__, "the_field"),
)  # fmt: skip


def the_field() -> Field:
    """The field above, for another process."""
    return SPRAG
