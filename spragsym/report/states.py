"""The states of sliding in newtons, millimetres and hertz, and which of them the brake is in."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

import spragsym as ss

from ..display import Result
from ..errors import SpragsymError
from ..models import forces
from ..models.parameters import FloatArray
from ..names import hint
from ..results.equilibria import Equilibria, Stability, columns_of
from ..statics.mechanics.balance import Balance
from ..statics.stability import linearization, roots
from . import friction, rises
from .study import Study

#: What the eigenvalues of a matrix of some rows are off by, relative to the largest, generously.
ROUNDING = 1e-14
#: Damping ratio below which a state is neither damped nor driven to speak of.
NEUTRAL = 1e-3
#: A speed of the belt at which no friction law has a slope.
LEVEL = 1e9
#: What the coordinates of one state differ by.
SAME = 1e-6

#: Of the only inclined spring a number, of several their numbers by name, and of none None.
OfSprings: TypeAlias = float | Mapping[str, float] | None


@dataclass(frozen=True)
class State(Result):
    """A state of steady sliding in contact.

    ``places`` are the coordinates by name and unit, ``x_mm`` or ``phi_deg``, and attributes too. Direction, length and force of
    the inclined spring are numbers, mappings by name where there are several, and None where there is none;
    ``contact_force_N`` is None without a contact. ``frequencies_hz`` and ``damping_ratio`` belong to the roots of the motion
    linearized about it, slowest first, the friction law's own damping included where the belt speed is known; ``growth_per_s``
    is their largest real part. ``stable`` says that it is negative, or zero without damping; ``statics`` is the word of (27)
    and (28), which leave the damping out. ``settles`` is None where that calls it stable, and so little damps or drives it that
    what the model leaves out decides.
    """

    places: Mapping[str, float]
    direction_deg: OfSprings
    spring_length_mm: OfSprings
    spring_force_N: OfSprings
    contact_force_N: float | None
    statics: str
    stable: bool
    frequencies_hz: tuple[float, ...]
    damping_ratio: tuple[float, ...]
    growth_per_s: float
    current: bool

    @property
    def settles(self) -> bool | None:
        """Whether a small disturbance dies out."""
        least = min(self.damping_ratio, default=math.inf)
        return None if self.statics == "stable" and (self.growth_per_s == 0 or abs(least) < NEUTRAL) else self.stable

    def __getattr__(self, name: str) -> float:
        places = self.__dict__.get("places", {})
        if name not in places:
            raise AttributeError(f"a state has no {name!r}{hint(name, places)}")
        found: float = places[name]
        return found


def states(study: Study, eq: Equilibria, here: Mapping[str, float] | None) -> tuple[State, ...]:
    """Every state of ``eq``, those in contact at the friction that works, in its order; the one that is ``here`` is ``current``.

    Notes
    -----
    Source: :func:`spragsym.equilibria`, and the linearization at the belt's speed.
    """
    slots = range(int(eq.count))
    off = [
        math.inf if here is None else max(abs(float(column[slot]) - here[name]) for name, column in eq.coordinates.items())
        for slot in slots
    ]
    nearest = min(slots, key=off.__getitem__, default=-1)
    return tuple(_state(study, eq, slot, slot == nearest and off[slot] < SAME) for slot in slots)


def others(study: Study, eq: Equilibria, here: Mapping[str, float] | None) -> tuple[tuple[dict[str, float], float | None], ...]:
    """Other stable states of ``eq`` than the one that is ``here``: each place in units, and where it ends as what rises goes on.

    Where it ends is told as the jump is; NaN where it does not, None where that is not known, or nothing rises.
    """
    at, rise, found = study.at_work, study.rise, []
    for slot in range(int(eq.count) if here is not None else 0):
        place = {name: float(column[slot]) for name, column in eq.coordinates.items()}
        if eq.stability[slot] != Stability.STABLE or max(abs(place[name] - here[name]) for name in place) < SAME:  # type: ignore[index]
            continue
        end = None
        if rise is not None:
            with suppress(SpragsymError):
                end = rises.told(study, float(ss.jump_value(at.following(**place), rise.name, begin=at.scalars(rise.name)[0])))
        found.append((place_in_units(study, place), end))
    return tuple(found)


def current(study: Study, eq: Equilibria) -> dict[str, float] | None:
    """The coordinates of the state that the brake is in; None where that can't be said.

    It is the one that is reached from small deformation as what rises does; where nothing is said to, the only one of ``eq``.
    """
    at, rise = study.at_work, study.rise
    if rise is None:
        return {name: float(column[0]) for name, column in eq.coordinates.items()} if int(eq.count) == 1 else None
    (value,) = at.scalars(rise.name)
    begin = rises.begin(study)
    path = ss.quasi_static_path(at, rise.name, [begin, value] if value > begin else [begin])
    return {name: float(column[-1]) for name, column in path.coordinates.items()}


def of_springs(model: Any, values: Sequence[Any]) -> Any:
    """One number, several by the names of the springs, or None."""
    if len(values) < 2:
        return next(iter(values), None)
    return dict(zip((entry["name"] for entry in model.about["springs"]), values, strict=True))


def place_in_units(study: Study, place: Mapping[str, float]) -> dict[str, float]:
    """Coordinates by name and unit: lengths in millimetres, angles in degrees."""
    scale = {"m": ("mm", 1e3 * study.scales.length)}
    entries = {entry["name"]: scale.get(entry["unit"], ("deg", math.degrees(1.0))) for entry in study.about["coordinates"]}
    return {f"{name}_{entries[name][0]}": entries[name][1] * value for name, value in place.items()}


def _state(study: Study, eq: Equilibria, slot: int, is_here: bool) -> State:
    scales, model = study.scales, study.at_work.model

    def of(names: Iterable[str], scale: float) -> list[float]:
        return [scale * float(getattr(eq, name)[slot]) for name in names]

    place = {name: float(column[slot]) for name, column in eq.coordinates.items()}
    where = [name for name in columns_of(model) if name not in place]  # direction and length of each spring in turn
    told = forces.told_of(model)
    tensions = of((name for name in told if name != "contact_force"), scales.force)
    rate = _roots(study, list(place.values())) / scales.time
    size = float(np.abs(rate).max())
    # Where nothing damps, as without friction, the sign of the real part is the rounding's.
    rate = np.where(np.abs(rate.real) <= ROUNDING * size, 1j * rate.imag, rate)
    upper = sorted((root for root in rate if root.imag > 1e-9 * size), key=lambda root: float(root.imag))
    growth, kind = float(rate.real.max()), Stability(int(eq.stability[slot]))
    stable = growth < 0 if study.moves and growth else kind == Stability.STABLE
    return State(
        place_in_units(study, place), of_springs(model, of(where[::2], math.degrees(1.0))),
        of_springs(model, of(where[1::2], 1e3 * scales.length)), of_springs(model, tensions),
        scales.force * float(eq.contact_force[slot]) if "contact_force" in told else None,
        kind.name.lower(), bool(stable), tuple(float(root.imag) / (2 * math.pi) for root in upper),
        tuple(float(-root.real / abs(root)) + 0.0 for root in upper), growth, is_here,
    )  # fmt: skip


def _roots(study: Study, q: list[float]) -> FloatArray:
    """λ over the unit of time, of the motion at the belt's speed; the friction law has no slope where that is not known."""
    p = study.dimensionless
    model = p.model
    balance = Balance(model, True, friction.law_of(study))
    given, state = np.array([[value] for value in p.scalars(*model.parameters)]), np.array(q)[:, None]
    M, C, K = (np.moveaxis(part, -1, 0) for part in linearization(balance, state, given))
    belt = str((study.about["friction"] or {}).get("belt", ""))
    if not study.moves and belt in model.parameters:
        level = np.array([[value] for value in p.replace(**{belt: LEVEL}).scalars(*model.parameters)])
        C = np.moveaxis(linearization(balance, state, level)[1], -1, 0)
    return np.asarray(roots(M, C, K)[0])
