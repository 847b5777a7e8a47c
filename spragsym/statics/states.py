"""Sources of the columns of equilibria, and changes to equilibria at single points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..display import own_name
from ..models.model import Touching
from ..models.parameters import FloatArray, ParameterSet
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import Int8Array, IntArray
from ..results import Equilibria

if TYPE_CHECKING:
    from .stability import Linearized


class Linearizing:
    """A source of equilibria that computes the full linearization on request."""

    #: Boxes with one state each, shape (2, n, states), where they are sharper than ``error``.
    around: FloatArray | None = None

    @property
    def more(self) -> tuple[str, ...]:
        """Names of columns that only closed forms have."""
        return ()

    def linearized(self, eq: Equilibria, states: tuple[IntArray, ...]) -> Linearized:
        """The linearization at some states, by their indices into the columns."""
        from .stability import linearized  # closed forms answer without it

        return linearized(eq, states, self.around)

    def held(self, columns: Mapping[str, NDArray[Any]]) -> Held:
        """A source of the same states that holds these columns, to be written to a file."""
        return Held(columns, self.around)


@dataclass(frozen=True)
class Held(Linearizing):
    """A source whose columns have been computed already."""

    columns: Mapping[str, NDArray[Any]]
    around: FloatArray | None = None

    @property
    def more(self) -> tuple[str, ...]:
        """Names of columns that only closed forms have."""
        return tuple(name for name in ("escalated", "fold") if name in self.columns)

    def column(self, name: str) -> NDArray[Any] | None:
        """The column of that name, or None."""
        return self.columns.get(name)


def one_each(
    p: ParameterSet,
    places: Mapping[str, NDArray[Any]],
    undamped: Int8Array,
    error: NDArray[Any] | float,
) -> Equilibria:
    """Equilibria with one known state in contact at each point; columns have the shape of ``p``."""
    ones, decided = np.ones(p.shape, dtype=int), np.ones(p.shape, dtype=bool)
    columns = {
        **places,
        own_name(p.model, "undamped"): undamped,
        own_name(p.model, "error"): np.broadcast_to(error, p.shape),
        own_name(p.model, "marginal"): ~decided,
    }
    contact = None if p.model.has_regimes else True
    return Equilibria(p, contact, ones, decided, (), (), Held(selected_rows(columns, (..., None))))


def combination_of(
    eq: Equilibria, touching: str, contact: Touching
) -> tuple[Equilibria, list[list[int]]]:
    """The equilibria along a line of parameters in one combination of touching contacts.

    Also returns, for each point, the slots of these states in ``eq``.
    """
    if eq.contact is not None:
        return eq, [list(range(count)) for count in eq.count.tolist()]
    model = eq.parameters.model
    selected = eq.touching == touching
    count = selected.sum(axis=-1)
    filled = np.arange(max(1, int(count.max(initial=0)))) < count[:, None]

    def taken(name: str, empty: float) -> NDArray[Any]:
        column = eq[name if name in model.coordinates else own_name(model, name)]
        out = np.full(filled.shape, empty, dtype=column.dtype)
        out[filled] = column[selected]
        return out

    ours = {"undamped": 0, "error": np.nan, "marginal": False}
    columns = {name: taken(name, np.nan) for name in model.coordinates}
    columns |= {own_name(model, name): taken(name, empty) for name, empty in ours.items()}
    columns[own_name(model, "whole")] = eq.whole
    slots = [np.flatnonzero(row).tolist() for row in selected]
    return Equilibria(
        eq.parameters, contact, count, eq.decided, (), eq.remarks, Held(columns)
    ), slots


def as_decided(eq: Equilibria, point: int) -> Equilibria:
    """The equilibria with one point declared decided: its known states are all there are."""
    left = tuple(box for box in eq.undecided if box.index != (point,))
    return replace(eq, decided=eq.decided | (np.arange(eq.count.size) == point), undecided=left)


def with_state(
    eq: Equilibria, point: int, state: Mapping[str, float], undamped: int, error: float
) -> Equilibria:
    """The equilibria with one more state at one point, given by its coordinates."""
    first, *_ = eq.coordinates.values()
    slot = int((first[point] < next(iter(state.values()))).sum())  # states are sorted by it
    ours = {"undamped": undamped, "error": error, "marginal": True}
    model = eq.parameters.model
    new = {**state, **{own_name(model, name): one for name, one in ours.items()}}

    def placed(name: str) -> NDArray[Any]:
        old = eq[name]
        out = np.concatenate(
            [old, np.full_like(old[:, :1], np.nan if old.dtype == float else 0)], axis=1
        )
        out[point] = np.insert(old[point], slot, new[name])
        return out

    increase = (np.arange(eq.count.size) == point).astype(eq.count.dtype)
    columns = {name: placed(name) for name in new}
    return replace(eq, count=eq.count + increase, _source=Held(columns))
