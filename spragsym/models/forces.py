"""Derived quantities of a state: directions, lengths and tensions of springs, forces of contacts;
and the naming and calling of generated functions.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ..core.errors import ParameterError
from ..display import Column, own_name
from .parameters import FloatArray, ParameterSet

if TYPE_CHECKING:
    from ..models.model import Model


def presses_either(contact: Mapping[str, Any]) -> bool:
    """Whether a contact presses on either of two faces, with friction on both."""
    return contact["border"] is not None and not contact["unilateral"]


def columns_of(model: Model) -> tuple[str, ...]:
    """Names of the columns that locate a state: direction and length of each inclined spring, and
    the coordinates.
    """
    springs = [name for theta, length, _ in _spring_names(model) for name in (theta, length)]
    return *springs, *model.coordinates


def _spring_names(model: Model) -> list[tuple[str, ...]]:
    """Names of direction, length and tension of each inclined spring.

    Several springs have the suffixes ``_1``, ``_2``, …. Names that the page itself has get an
    underscore.
    """
    count = len(model.about["springs"])
    ends = [""] if count == 1 else [f"_{index + 1}" for index in range(count)]
    return [
        tuple(own_name(model, f"{name}{end}") for name in ("theta", "L", "spring_force"))
        for end in ends
    ]


def named(function: str, contact: str) -> str:
    """Name of a generated function of one contact; the only contact has no name and no suffix."""
    return f"{function}_{contact}" if contact else function


def undecorated(function: Callable[..., Any]) -> Callable[..., Any]:
    """The generated function without broadcasting of its results; it accepts ``xp`` even if it
    needs none.
    """
    algebra: Callable[..., Any] = inspect.unwrap(function)
    return algebra if algebra.__kwdefaults__ else lambda *given, xp=None: algebra(*given)


def columns(model: Model) -> list[Column]:
    """Columns of springs and contacts: directions, lengths, tensions and normal forces."""
    found = []
    for names, entry in zip(_spring_names(model), model.about["springs"], strict=True):
        theta, length, tension = names
        found += [
            Column(theta, "rad", f"direction of {entry['name']}"),
            Column(length, "m", f"length of {entry['name']}"),
            Column(tension, "N", f"tension of {entry['name']}"),
        ]
    for name in (entry["name"] for entry in model.contacts):
        of = f"normal force of the contact{name and ' '}{name}"
        found.append(Column(own_name(model, named("contact_force", name)), "N", of))
    return found


def derived_of_states(p: ParameterSet, q: Sequence[FloatArray]) -> dict[str, FloatArray]:
    """Quantities that follow from coordinates, by name.

    These are the direction in (−π, π], the length and the tension of each inclined spring, and the
    forces of contacts. ``q`` has the shape of ``p`` and one more axis.
    """
    model = p.model
    statics, motion = (
        [value[..., None] for value in model.arguments(p, kind)] for kind in ("statics", "motion")
    )
    places = list[FloatArray]()
    with np.errstate(all="ignore"):  # empty slots are NaN
        for dx, dy, _ in model.algebra.geometry(*q, *statics):
            places += [np.arctan2(dy, dx), np.hypot(dx, dy)]
        forces = {
            name: np.where(np.isnan(q[0]), np.nan, force(q, motion))
            for name, force in forces_of(model).items()
        }
    return {**dict(zip(columns_of(model), places, strict=False)), **forces}


def contact_force(
    model: Model, states: Sequence[ArrayLike] | FloatArray, constants: Sequence[Any], index: int = 0
) -> FloatArray:
    """The normal force of contact number ``index``, 0 where its gap is open.

    ``states`` begin with the coordinates; ``constants`` are the arguments of the motion.
    """
    q, contact = states[: len(model.coordinates)], model.contacts[index]
    gap, force = (
        getattr(model.algebra, named(function, contact["name"]))
        for function in ("contact_gap", "contact_force")
    )
    at = gap(*q, *of_statics(model, constants))
    closed = np.less_equal(at, 0).astype(int) if contact["unilateral"] else 1
    return np.add(force(*q, *constants, closed), 0.0)  # −0 becomes 0


def forces_of(model: Model) -> dict[str, partial[FloatArray]]:
    """Functions of states and constants that give forces, by name.

    ``spring_force`` of the only inclined spring, or ``spring_force_1``, …, is the tension k (L −
    L_0), negative where the spring pushes. ``contact_force`` is the normal force of a contact.
    """

    def tension(spring: int, states: FloatArray, constants: Sequence[Any]) -> FloatArray:
        tensions = model.algebra.spring_forces(
            *states[: len(model.coordinates)], *of_statics(model, constants)
        )
        return tensions[spring]

    found = {name: partial(tension, index) for index, (*_, name) in enumerate(_spring_names(model))}
    return found | {
        own_name(model, named("contact_force", entry["name"])): partial(
            contact_force, model, index=index
        )
        for index, entry in enumerate(model.contacts)
        if entry["gap"] is not None
    }


def contact_named(model: Model, contact: str | None, names: Sequence[str]) -> int:
    """Index in ``names`` of the named contact; None means the only one."""
    contact = names[0] if contact is None and len(names) == 1 else contact
    if contact not in names:
        offered = ", ".join(map(repr, names))
        raise ParameterError(f"contact = {contact!r} of {model.name} is one of {offered}")
    return names.index(contact)


def spring_named(model: Model, spring: str | None) -> str:
    """Name of the force of the named spring; None means the only one."""
    springs = [entry["name"] for entry in model.about["springs"]]
    spring = springs[0] if spring is None and len(springs) == 1 else spring
    if spring not in springs:
        offered = f"one of {', '.join(map(repr, springs))}"
        if not springs:
            offered = "nothing: there is no inclined spring"
        raise ParameterError(f"spring = {spring!r} of {model.name} is {offered}")
    return list(forces_of(model))[springs.index(spring)]


def of_statics(model: Model, constants: Sequence[Any]) -> list[Any]:
    """Arguments of the functions of statics, selected from those of the motion."""
    arguments = dict(zip(model.about["arguments"]["motion"], constants, strict=True))
    return [arguments[name] for name in model.about["arguments"]["statics"]]


def inertia_error(M: FloatArray, names: Sequence[str], given: FloatArray) -> ParameterError | None:
    """The error of mass matrices, of shape (N, n, n), one of which is not positive definite at its
    parameters, ``given`` of shape (P, N); None if all are.
    """
    constant = bool((M == M[:1]).all())
    M = M[:1] if constant else M
    # What is not finite is no matter of signs.
    finite = np.logical_and.reduce(np.isfinite(M), axis=(1, 2))
    positive = np.ones(len(M), dtype=bool)
    positive[finite] = np.linalg.eigvalsh(M[finite])[:, 0] > 0
    if positive.all():
        return None
    values = zip(names, given[:, positive.argmin()].tolist(), strict=True)
    return ParameterError(
        "the kinetic energy is not positive for all rates at "
        f"{', '.join(f'{name} = {value:.6g}' for name, value in values)}; "
        "change the parameters on which masses depend"
    )
