"""The result of ``equilibria``: the states of many points of parameters, for every model and
method.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ConvergenceError
from ..display import Column, Table, counted, in_rows, not_all, own_name, points
from ..files import storage
from ..models.forces import derived_of_states, forces_of
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray, IntArray
from .result import WHOLE, Items, OfStates, Result, along_axes, axes_of

if TYPE_CHECKING:
    from xarray import Dataset

    from ..models.model import Model


class EquilibriumType(enum.IntEnum):
    """Type of an equilibrium by the roots λ of its linearization, as of det(λ² M + K) = 0, (27).

    Examples
    --------
    >>> import spragsym as ss
    >>> eq = ss.equilibria(ss.Parameters.article(theta0=0.5, mu0=0.5))
    >>> [EquilibriumType(code).name for code in eq.undamped]
    ['STABLE', 'DIVERGENT', 'STABLE']
    """

    NONE = 0  #: no equilibrium in this slot
    STABLE = 1  #: no λ with a positive real part
    DIVERGENT = 2  #: a real positive λ
    FLUTTER = 3  #: a complex pair with a positive real part


@dataclass(frozen=True)
class Undecided(Result):
    """A box of states at one point for which it is not decided how many equilibria it holds."""

    index: tuple[int, ...]  #: of the point in the shape of the parameters
    low: tuple[float, ...]  #: lower ends, by coordinate
    high: tuple[float, ...]  #: upper ends
    reason: str  #: why


class ColumnSource(Protocol):
    """Source of the columns of equilibria, each computed when it is asked for.

    It must have ``undamped``, ``marginal``, ``error``, ``eigenvalues`` and the coordinates, and may
    have others.
    """

    @property
    def more(self) -> tuple[str, ...]:
        """Names of columns that only closed forms have."""

    def column(self, name: str) -> NDArray[Any] | None:
        """A column; None if it is not known here."""

    def linearized(self, eq: Equilibria, states: tuple[IntArray, ...]) -> Any:
        """The full linearization of some states, by their indices into the columns: ``growth``,
        ``kind`` and ``eigenvalues``.
        """

    def held(self, columns: Mapping[str, NDArray[Any]]) -> ColumnSource:
        """A source that holds these columns, for a file."""


#: Columns of the full linearization: its attribute, and the value in a slot without equilibrium.
_LINEARIZED: Mapping[str, tuple[str, Any]] = {
    "damped_eigenvalues": ("eigenvalues", np.nan),
    "growth": ("growth", np.nan),
    "growth_sign": ("sign", 0),
    "stability": ("stability", ""),
}


@cache
def _names(model: Model, more: tuple[str, ...]) -> tuple[str, ...]:
    """Names of all columns: of states, forces, parameters, and of the package."""
    made = (each.name for each in Equilibria.schema if each.of is not None)
    several = ["touching"] if model.has_regimes else []
    fixed = ("undamped", "marginal", "eigenvalues", "error", "region", "whole")
    ours = (own_name(model, name) for name in (*several, *fixed, *_LINEARIZED, *made, *more))
    return tuple(dict.fromkeys([*model.places, *forces_of(model), *model.parameters, *ours]))


@dataclass(frozen=True, eq=False)
class Equilibria(OfStates):
    """The equilibria of every parameter point, and whether these are all.

    Each coordinate is an attribute under its own name: an array of the shape of the parameters with
    one more axis, along which equilibria stand in ascending order of the first coordinate, NaN
    beyond ``count``; closed forms order them by ``theta``, which in contact is the same and in
    lift-off is not. So are, for each inclined spring, its direction in radians and its length:
    ``theta`` and ``L`` where there is one, ``theta_1``, ``L_1``, … where there are several; and its
    tension ``spring_force``, or ``spring_force_1``, …, negative where it pushes, and the normal
    force of the contact, ``contact_force``, in units of force of the model. Columns are made when
    they are first asked for.

    Attributes
    ----------
    count : ndarray of int
        Number of equilibria that are proved, in the shape of the parameters.
    decided : ndarray of bool
        Points that have an answer: those of others are empty, or what is known of them.
    undecided : tuple of Undecided
        The other points' boxes, with the reason for each.
    remarks : tuple of str
        Why the result is not complete: what is known of these boxes, and what was searched where
        that is not everything; and states whose stability is not told.
    touching : ndarray of str
        Of a model with several contacts: those that touch, as ``"front, rear"``. Of one that
        presses on either of two faces: ``"face"``, where N is not negative, or ``"opposite face"``.
    stability : ndarray of str
        Small deviations in the motion that the page describes, by det(λ² M + λ C + K) = 0, with
        dampers and slope of the friction law: ``"stable"``, they decay; ``"unstable"``, they grow;
        ``"neutral"``, practically: growth below 1e-4 of the frequency, so that damping that no
        model knows decides. Empty beyond ``count``, and where no float holds the rate.
    undamped : ndarray of int8
        Codes of :class:`EquilibriumType` by det(λ² M + K) = 0, as (27): without dampers and slope
        of the friction law.
    marginal : ndarray of bool
        Where that code is not proved: no number of digits that was tried tells a sign behind it
        from that of 0.
    eigenvalues : ndarray of complex
        The λ of it, on one more axis; NaN beyond ``count``.
    damped_eigenvalues : ndarray of complex
        The λ of det(λ² M + λ C + K) = 0, with dampers and slope of the friction law, on one more
        axis by falling real part.
    growth : ndarray
        Largest real part of the λ of it.
    growth_sign : ndarray of int8
        1 where it is proved that something grows by it, −1 that nothing does, 0 where 256 bits do
        not tell.
    error : ndarray
        Bound on |error| / max(1, |value|), of coordinates and, in closed forms, of theta and L, the
        largest of them.
    region : ndarray
        Lower and upper ends of the box that was searched, shape (…, coordinates, 2).
    whole : ndarray of bool
        Points whose region is proved to hold all equilibria. Of others there may be some beyond it.
    escalated : ndarray of bool
        Of closed forms only: points that float64 could not settle and more digits did.
    fold : ndarray of bool
        Of closed forms only: points that are a fold to the last digit that could be tried: one
        state stands in two slots.
    """

    schema = (
        Column("count", "1", "number of equilibria that are proved"),
        Column("touching", "1", "contacts that touch, of several", row="before"),
        Column("stability", "1", "small deviations: stable, neutral, unstable", row="before"),
        Column("eigenvalues", "1/s", "eigenvalues of (27), without damping", row="beside"),
        Column("damped_eigenvalues", "1/s", "eigenvalues with all damping", row="beside"),
        Column("growth", "1/s", "largest real part of the damped eigenvalues", row="behind"),
        Column("growth_sign", "1", "1 where growth is proved, -1 where that nothing grows is"),
        Column("error", "1", "bound on |error| / max(1, |value|) of the state", row="behind"),
        Column("undamped", "1", "type of state by (27)", EquilibriumType, row="behind"),
        Column("marginal", "1", "whether the type by (27) is not proved", row="beside"),
        Column("region", "1", "ends of the box that was searched"),
        Column("whole", "1", "whether the box is proved to hold all equilibria"),
        Column("escalated", "1", "whether more digits than those of float64 were needed"),
        Column("fold", "1", "whether the point is a fold to the last digit"),
    )

    parameters: Any
    contact: bool | tuple[str, ...] | None
    count: NDArray[Any]
    decided: BoolArray
    undecided: tuple[Undecided, ...]
    remarks: tuple[str, ...]
    _source: ColumnSource = field(repr=False)

    @property
    def complete(self) -> bool:
        """Whether these are all equilibria of every point: each is decided, and nothing is beyond
        the region.
        """
        return bool((self.decided & self.whole).all())

    @property
    def regime(self) -> str:
        """``"contact"`` or ``"lift-off"``, of several contacts perhaps ``"contact of front
        alone"``; of a model without a contact ``"sliding"``, or ``"rest"`` without friction too.
        """
        return self.parameters.model.regimes[True if self.contact is None else self.contact]

    @property
    def states(self) -> tuple[IntArray, ...]:
        """Indices into the columns of all slots that hold equilibria, in order."""
        return np.nonzero(np.arange(self.undamped.shape[-1]) < self.count[..., None])

    def reason(self, *index: int) -> str:
        """Why the point with this index has no answer; empty if it has one.

        Parameters
        ----------
        *index : int
            Index of the point, one number an axis.

        Returns
        -------
        str

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> eq.reason(0)
        ''
        """
        numbers = np.arange(self.count.size).reshape(self.count.shape)
        boxes = (box for box in self.undecided if numbers[box.index] == numbers[index])
        return "; ".join(dict.fromkeys(box.reason for box in boxes))

    def require_decided(self) -> Self:
        """This result, if every point has an answer; otherwise raise :class:`ConvergenceError` with
        the first reason.

        Returns
        -------
        Equilibria

        Raises
        ------
        ConvergenceError
            If a point has no answer.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> eq.require_decided() is eq
        True
        """
        if self.undecided:
            raise ConvergenceError(self.undecided[0].reason)
        return self

    def as_table(self) -> Table:
        """A row for each equilibrium, with the parameters that vary over the points.

        Returns
        -------
        Table
            Title, header and rows of text.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> eq.as_table().title, len(eq.as_table().rows)
        ('4 equilibria in contact of 2 points', 4)
        """
        states, number = self.states, math.prod(self.count.shape)

        def columns(chosen: IntArray) -> dict[str, Any]:
            shown = tuple(part[chosen] for part in states)
            rows = self._rows(shown)
            growth = self._own("growth")
            return {
                **points(shown[:-1]),
                **rows,
                growth: [f"{rate:.1e}" for rate in rows[growth]],
            }

        where = {"sliding": "of sliding", "rest": "at rest"}.get(self.regime, f"in {self.regime}")
        caption = f"{counted(states[0].size, 'equilibrium', 'equilibria')} {where}"
        caption += f" of {number} points" * bool(self.count.shape)
        # What is complete may have states of which something is not told.
        told = not_all(self) or "".join(f"; {remark}" for remark in self.remarks)
        return in_rows(caption + told, self._schema, states[0].size, columns)

    def data(self) -> dict[str, NDArray[Any]]:
        """A row for each equilibrium: the parameters that vary over the points, its stability and
        place, growth and error.

        Returns
        -------
        dict of str to array
            Columns of one length, angles in radians.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> eq.data()["x"].round(4)
        array([0.0677, 0.6058, 1.6408, 0.9102])
        """
        return self._rows(self.states)

    def to_xarray(self) -> Dataset:
        """An ``xarray.Dataset`` over the axes of the parameters and ``state``, the slots of the
        equilibria, NaN beyond ``count`` (extra ``sweep``).

        An axis along which one parameter alone varies is named after it; others are ``axis_0``, ….

        Returns
        -------
        xarray.Dataset

        Raises
        ------
        MissingExtraError
            Without xarray.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> dict(eq.to_xarray().sizes)
        {'theta0': 2, 'state': 3}
        """
        p, shape, state = self.parameters, self.parameters.shape, self._own("state")
        inputs = {name: p[name] for name in p.ranges if p[name] is not None}
        axes = axes_of(inputs, shape)
        names = [name for name in self._rows(self.states) if name not in p.ranges]
        variables = {name: ((*axes, state), self[name]) for name in names}
        variables[self._own("count")] = (axes, self.count)
        coords = along_axes(inputs, axes, shape)
        return storage.dataset(variables, coords, self._facts, self._in_model_units)

    def row_columns(self, *rows: str) -> tuple[str, ...]:
        """Names of the columns of the schema that stand in these parts of a row of states.

        Parameters
        ----------
        *rows : str
            Parts of a row: ``"before"`` or ``"behind"`` the state.

        Returns
        -------
        tuple of str

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> eq = ss.equilibria(ss.Parameters.article(theta0=np.radians([30.0, 60.0]), mu0=0.5))
        >>> eq.row_columns("before")
        ('stability',)
        """
        available = _names(self.parameters.model, self._source.more)
        names = (self._own(each.name) for each in self.schema if each.row in rows)
        return tuple(name for name in names if name in available)

    def _rows(self, states: tuple[IntArray, ...]) -> dict[str, NDArray[Any]]:
        p, linearization = self.parameters, self._source.linearized(self, states)
        attributes = {self._own(name): of for name, (of, _) in _LINEARIZED.items()}

        def column(name: str) -> NDArray[Any]:
            return (
                getattr(linearization, attributes[name])
                if name in attributes
                else self[name][states]
            )

        vary = [name for name in p.ranges if np.size(p[name]) > 1]
        given = {name: np.broadcast_to(p[name], p.shape)[states[:-1]] for name in vary}
        before, behind = self.row_columns("before"), self.row_columns("behind")
        return given | {name: column(name) for name in (*before, *self.state_columns, *behind)}

    def _for_file(self) -> Self:
        columns = {
            name: column
            for name in self._items
            if (column := self._source.column(name)) is not None
        }
        return replace(self, _source=self._source.held(columns))

    def _is_short(self) -> bool:
        return int(self.count.sum()) <= WHOLE

    @property
    def _items(self) -> Items:
        return Items(_names(self.parameters.model, self._source.more), self._column)

    @cached_property
    def _made(self) -> dict[str, FloatArray]:
        return derived_of_states(self.parameters, list(self.coordinates.values()))

    @cached_property
    def _all(self) -> Any:
        return self._source.linearized(self, self.states)

    def _column(self, name: str) -> NDArray[Any]:
        """A column: from the source, the linearization, the schema, or derived from the states."""
        column = self._source.column(name)
        if column is not None:
            return column
        if name == self._own("region"):
            return np.broadcast_to(
                [-np.inf, np.inf], (*self.count.shape, len(self.parameters.model.coordinates), 2)
            )
        if name == self._own("whole"):
            return np.broadcast_to(np.True_, self.count.shape)
        if name in self.parameters.ranges:
            return self.parameters[name]
        made = {self._own(each.name): each for each in self.schema if each.of is not None}
        if name in made:
            return np.asarray(made[name].value(self))
        linearized = {self._own(each): attribute for each, attribute in _LINEARIZED.items()}
        if name not in linearized:
            return self._made[name]
        of, empty = linearized[name]
        values = getattr(self._all, of)
        out = np.full((*self.undamped.shape, *values.shape[1:]), empty, dtype=values.dtype)
        out[self.states] = values
        return out
