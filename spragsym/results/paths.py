"""A state followed as one parameter moves, with its jumps: one class for every model, however it was followed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import Int8Array
from .equilibria import Equilibria, Stability
from .named_columns import Columns, OfStates
from .result import Result, Rows


@dataclass(frozen=True)
class Jump(Result):
    """A state that vanishes at a fold, leaves the contact or runs to infinity, and the one that takes its place.

    ``before`` and ``after`` say where they are, by the names of ``Path.columns``: numbers, angles in radians.
    """

    value: float  #: of the parameter, at the fold, on the border or in the limit
    kind: str  #: ``"fold"``, ``"pitchfork"``, ``"border"`` where the state leaves the contact, or ``"infinity"``
    before: Mapping[str, float]
    after: Mapping[str, float]
    stability_after: Stability
    error: float  #: bound on the error of ``value``


#: Columns of the full linearization, as of :class:`spragsym.Equilibria`.
_OF_STATES = ("growth", "growth_sign", "damped")


@dataclass(frozen=True, eq=False)
class Path(OfStates, Columns, Rows, held_in="places"):
    """States along the values of the parameter, in the order in which they are passed, and the jumps between them.

    Each coordinate is an attribute under its own name, of the shape of ``values``; so are the direction and the length of each
    inclined spring, as of :class:`spragsym.Equilibria`. Angles are radians. ``stability`` has the codes of (27); ``growth``,
    ``growth_sign`` and ``damped`` are those of the full linearization, made when they are asked for.
    """

    table_codes: ClassVar[Mapping[str, type[Stability]]] = {"stability": Stability}

    parameters: Any
    vary: str
    values: FloatArray
    stability: Int8Array
    jumps: tuple[Jump, ...]
    places: Mapping[str, FloatArray] = field(repr=False)
    _along: Equilibria = field(repr=False)

    @property
    def offered(self) -> tuple[str, ...]:
        return (*self.places, *_OF_STATES)

    def _asked(self, name: str) -> Any:
        return getattr(self._along, name)[:, 0] if name in _OF_STATES else self.places.get(name)


def followed(
    p: Any, vary: str, values: FloatArray, along: Equilibria, jumps: tuple[Jump, ...]
) -> Path:  # fmt: skip
    """The path of the only state that is given at each value."""
    places = {name: getattr(along, name)[:, 0] for name in along.columns}
    return Path(p, vary, values, along.stability[:, 0], jumps, places, along)
