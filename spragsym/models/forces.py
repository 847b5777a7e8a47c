"""Quantities of a state: directions, lengths and forces of springs, and the force of the contact;
how generated functions are named and called.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..core.errors import ParameterError
from ..display import Column
from .parameters import FloatArray, ParameterSet

if TYPE_CHECKING:
    from ..models.model import Model


def presses_either(contact: Mapping[str, Any]) -> bool:
    """Whether a contact presses on either of two faces, and rubs on both."""
    return contact["border"] is not None and not contact["unilateral"]


def columns_of(model: Model) -> tuple[str, ...]:
    """Names of what says where a state of a model is: direction and length of each inclined spring,
    and the coordinates.
    """
    return tuple(
        dict.fromkeys(
            [
                *(f"{name}{end}" for end in _ends(model) for name in ("theta", "L")),
                *model.coordinates,
            ]
        )
    )


def _ends(model: Model) -> list[str]:
    """Endings of the names of what is told of each inclined spring: a number where there are
    several.
    """
    count = len(model.about["springs"])
    return [""] if count == 1 else [f"_{index + 1}" for index in range(count)]


def named(function: str, contact: str) -> str:
    """Generated functions and facts of one contact; of the only one, which has no name."""
    return f"{function}_{contact}" if contact else function


def undecorated(function: Callable[..., Any]) -> Callable[..., Any]:
    """The algebra of a generated function, without the common shape of results; it takes a
    namespace even where it needs none.
    """
    algebra: Callable[..., Any] = inspect.unwrap(function)
    return algebra if algebra.__kwdefaults__ else lambda *given, xp=None: algebra(*given)


def columns(model: Model) -> list[Column]:
    """Columns of springs and contact: directions, lengths, tensions, and the normal force."""
    found = []
    for end, entry in zip(_ends(model), model.about["springs"], strict=True):
        found += [
            Column(f"theta{end}", "rad", f"direction of {entry['name']}"),
            Column(f"L{end}", "m", f"length of {entry['name']}"),
            Column(f"spring_force{end}", "N", f"tension of {entry['name']}"),
        ]
    for name in (entry["name"] for entry in model.contacts):
        of = f"normal force of the contact{name and ' '}{name}"
        found.append(Column(named("contact_force", name), "N", of))
    return found


def derived_of_states(p: ParameterSet, q: Sequence[FloatArray]) -> dict[str, FloatArray]:
    """Quantities that follow from where states are, their coordinates on one more axis than ``p``:
    of each inclined spring the direction in (−π, π], the length and the tension, and the contact's
    force.
    """
    model = p.model
    statics, motion = (
        [value[..., None] for value in model.arguments(p, kind)] for kind in ("statics", "motion")
    )
    with np.errstate(all="ignore"):  # where there is no state there are no numbers
        lines = model.algebra.geometry(*q, *statics)
        places = [
            of(dx, dy) for dx, dy, _ in lines for of in (lambda x, y: np.arctan2(y, x), np.hypot)
        ]
        forces = {
            name: np.where(np.isnan(q[0]), np.nan, force(q, motion))
            for name, force in forces_of(model).items()
        }
    return {**dict(zip(columns_of(model), places, strict=False)), **forces}


def contact_force(
    model: Model, states: Sequence[ArrayLike] | FloatArray, constants: Sequence[Any], index: int = 0
) -> FloatArray:
    """The normal force of a contact, by its number: 0 where the gap is open; ``states`` begin with
    the coordinates.
    """
    q, contact = states[: len(model.coordinates)], model.contacts[index]
    gap, force = (
        getattr(model.algebra, named(function, contact["name"]))
        for function in ("contact_gap", "contact_force")
    )
    at = gap(*q, *of_statics(model, constants))
    closed = np.less_equal(at, 0).astype(int) if contact["unilateral"] else 1
    return np.add(force(*q, *constants, closed), 0.0)  # without the sign of a zero


def forces_of(model: Model) -> dict[str, partial[FloatArray]]:
    """Forces by their names: tension k (L − L_0), negative where it pushes, as ``spring_force`` of
    the only inclined spring, or ``spring_force_1``, …; ``contact_force``.
    """

    def tension(spring: int, states: FloatArray, constants: Sequence[Any]) -> FloatArray:
        tensions = model.algebra.spring_forces(
            *states[: len(model.coordinates)], *of_statics(model, constants)
        )
        return tensions[spring]

    found = {
        f"spring_force{end}": partial(tension, index) for index, end in enumerate(_ends(model))
    }
    return found | {
        named("contact_force", entry["name"]): partial(contact_force, model, index=index)
        for index, entry in enumerate(model.contacts)
        if entry["gap"] is not None
    }


def contact_named(model: Model, contact: str | None, names: Sequence[str]) -> int:
    """The place of the contact of a name among ``names``, or of the only one."""
    contact = names[0] if contact is None and len(names) == 1 else contact
    if contact not in names:
        offered = ", ".join(map(repr, names))
        raise ParameterError(f"contact = {contact!r} of {model.name} is one of {offered}")
    return names.index(contact)


def spring_named(model: Model, spring: str | None) -> str:
    """The name of the force of a spring: of the only one, or of the one that is named."""
    springs = [entry["name"] for entry in model.about["springs"]]
    spring = springs[0] if spring is None and len(springs) == 1 else spring
    if spring not in springs:
        offered = (
            f"one of {', '.join(map(repr, springs))}"
            if springs
            else "nothing: there is no inclined spring"
        )
        raise ParameterError(f"spring = {spring!r} of {model.name} is {offered}")
    return list(forces_of(model))[springs.index(spring)]


def of_statics(model: Model, constants: Sequence[Any]) -> list[Any]:
    """Arguments of the motion that functions of the statics take."""
    arguments = dict(zip(model.about["arguments"]["motion"], constants, strict=True))
    return [arguments[name] for name in model.about["arguments"]["statics"]]
