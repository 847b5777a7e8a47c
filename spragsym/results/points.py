"""Results on bifurcations of equilibria: points, curves, sets and paths; the same classes for every
model and method.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from ..display import (
    Column,
    Table,
    counted,
    following,
    in_rows,
    named_fields,
    not_all,
)
from ..models.forces import derived_of_states
from ..models.model import Model
from ..models.parameters import FloatArray
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import BoolArray, Int8Array, IntArray, Shape
from .equilibria import Equilibria, EquilibriumType
from .result import Items, Named, OfStates, Result, Rows

#: Columns of how many eigenvalues grow on both sides.
UNSTABLE = ("unstable_before", "unstable_after")


@dataclass(frozen=True, eq=False)
class Ended(Result):
    """What ends at each of several points: the columns ``ends``, ``when`` and ``after`` of
    :class:`Points`; ``after`` may be a function that computes it, and so may ``unstable``, its
    columns ``unstable_before`` and ``unstable_after``.
    """

    schema = (Column("{p}_after", "{p}", "{p} of the state that is jumped to"),)

    ends: NDArray[np.str_]
    when: NDArray[np.str_]
    after: Mapping[str, FloatArray] | Callable[[Points], Mapping[str, FloatArray]]
    unstable: IntArray | Callable[[Points], IntArray] | None = None


def nothing_ends(points: Points) -> Ended:
    """The columns for points at which no state ends."""
    ends, when = np.full((2, len(points)), "", dtype="<U9")
    return Ended(ends, when, nowhere(points))


def nowhere(points: Points) -> dict[str, FloatArray]:
    """The column ``after`` for points at which nothing jumps: NaN."""
    return {name: np.full(len(points), np.nan) for name in points.state_columns}


@dataclass(frozen=True, eq=False)
class Points(OfStates, Rows):
    """Points at which equilibria change, sorted by the first parameter that varies.

    Every parameter and coordinate is an attribute under its own name, one number a point; so are
    the direction and the length of each inclined spring, as of
    :class:`spragsym.results.Equilibria`. Columns are made when they are first asked for. Angles are
    radians.

    Attributes
    ----------
    parameters : Parameters
        What was asked for; those that vary are not used.
    vary : tuple of str
        The parameters that were unknowns.
    kind : ndarray of str
        What happens as the parameter passes. ``"fold"``: two equilibria appear or vanish together.
        ``"pitchfork"``: one becomes three, or three become one, all of them in one point, in a
        system that is its own mirror image. ``"cusp"``: two folds meet; along one parameter three
        equilibria meet, and one is left on both sides. ``"touch"``: two meet, and there are as many
        on both sides. Of several contacts ``"passes"``: one of them, or some at once, lose or
        regain contact, and the state goes on; ``"border_fold"``: there two states, or one, end, or
        more where several do at once; ``"border"``: which of these is not known. ``"hopf"``,
        ``"flutter"`` and ``"detected"`` are onsets, see
        :class:`spragsym.results.Onsets`.
    touching, at_border : ndarray of str
        Of a model with several contacts: those that touch, as ``"front, rear"``, and the one of
        them whose gap is 0 at a border point, or those that are met at once; empty at others.
    error : ndarray
        Bound on |error| / max(1, |value|) of coordinates and of the parameters that vary, in closed
        forms of theta and L too.
    ends : ndarray of str
        At a fold a stable state by (27) and another one meet, as a rule: whether the stable one is
        the ``"lower"`` or the ``"upper"`` of the two in the first coordinate, in closed forms in
        theta; ``"undecided"``; empty where none of them is stable, and for other kinds.
    when : ndarray of str
        The two vanish as the parameter goes ``"up"`` or ``"down"``; ``"undecided"``; empty for
        other kinds.
    after : mapping of str to ndarray
        Where the state that ends jumps to, by the names of ``state_columns``: the nearest
        equilibrium that is stable there by (27), of closed forms the only one that is left. NaN
        where there is none or a search does not decide it, and for other kinds. Each is a search of
        its own, with the budget of one, where there is no closed form: ``print`` shows what was
        asked for before.
    unstable_before, unstable_after : ndarray of int
        How many λ of the full linearization grow in the one and in the other of two states that
        meet: the least and the largest number in states beside a point, proved by discs, of models
        without damping by floats; −1 where that is undecided, and at borders, where forces have a
        kink. Of :class:`spragsym.results.Onsets`, at smaller and at larger values of the parameter.
    region : ndarray
        Lower and upper ends of the box that was searched, shape (unknowns, 2): coordinates, then
        parameters. A parameter that is larger than 0 may begin at 2⁻³⁰⁰, where nothing is known of
        what is below. Closed forms need no box: ends are infinite.
    whole : bool
        Whether that box is proved to hold all equilibria for all parameters in it.
    endless : tuple of str
        Parameters whose range has no end, and no ``between``: they were searched to the end that
        ``region`` says, no farther.
    undecided : ndarray
        Lower and upper ends of the boxes that are not decided, shape (boxes, unknowns, 2); many of
        them as the boxes around those whose ranges of the parameter touch.
    remarks : tuple of str
        What is known of these boxes, and what was not searched: why the result is not complete.
    """

    schema: ClassVar[tuple[Column, ...]] = (
        Column("touching", "1", "contacts that touch, of several"),
        Column("at_border", "1", "of them the one whose gap is 0 at a border point"),
        Column("kind", "1", "what happens as the parameter passes", row="before"),
        Column("ends", "1", "which of two states is stable and ends there", row="behind"),
        Column("when", "1", "direction of the parameter in which it ends", row="behind"),
        Column("{p}_after", "{p}", "{p} of the state that is jumped to"),
        Column("unstable_before", "1", "growing eigenvalues on one side", row="beside"),
        Column("unstable_after", "1", "growing eigenvalues on the other side", row="beside"),
        Column("error", "1", "bound on |error| / max(1, |value|)"),
    )

    parameters: Any
    vary: tuple[str, ...]
    kind: NDArray[np.str_]
    error: FloatArray
    region: FloatArray
    whole: bool
    endless: tuple[str, ...]
    undecided: FloatArray
    remarks: tuple[str, ...]
    _values: Mapping[str, NDArray[Any]] = field(repr=False)
    _ended: Ended | Callable[[Points], Ended] = field(default=nothing_ends, repr=False)

    def __len__(self) -> int:
        return int(self.error.size)

    @property
    def decided(self) -> bool:
        """Whether every box of the region is decided."""
        return not len(self.undecided)

    @property
    def complete(self) -> bool:
        """Whether these are all: everywhere, for all values of the parameters, or for those of
        ``between``.
        """
        return self.decided and self.whole and not self.endless

    @property
    def _items(self) -> Items:
        names = (*self.vary, *self.state_columns, *self._values, *self.parameters.ranges)
        ours = map(self._own, (*self._of_each, *UNSTABLE, "error"))
        return Items(tuple(dict.fromkeys([*names, *ours])), self._column)

    @property
    def _of_each(self) -> tuple[str, ...]:
        """Names of the attributes in tables, besides parameters and states."""
        return ("kind",)

    def data(self) -> dict[str, NDArray[Any]]:
        """The parameters that vary, the state, what happens there and the bound on the errors, by
        name.

        Returns
        -------
        dict of str to array
            Columns of one length, angles in radians.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> found.data()["theta0"].round(4)
        array([0.7777, 2.7063])
        """
        several = [  # only of a model with several contacts
            name for name in map(self._own, ("touching", "at_border")) if name in self._values
        ]
        where = {name: self[name] for name in (*self.vary, *self.state_columns, *several)}
        ours = {self._own(name): getattr(self, name) for name in (*self._of_each, "error")}
        return where | ours | following(self)

    def as_table(self) -> Table:
        """A row for each point: the parameters that vary, the state, what ends there or begins, and
        what else is known of it.

        Returns
        -------
        Table
            Title, header and rows of text, angles in degrees.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> [row[0] for row in found.as_table().rows]
        ['44.5593177', '155.0594188']
        """
        schema = self._schema
        columns = self.data()
        error = columns.pop(self._own("error"))
        if np.isin(self.kind, ("fold", "border_fold")).any():
            columns |= {self._own("ends"): self.ends, self._own("when"): self.when}
            columns |= {f"{name}_after": column for name, column in after_if_known(self).items()}
        columns[self._own("error")] = error
        ends = self.region[-len(self.vary) :].tolist()
        spans = (
            f"{schema.heading(name)} from {schema.cell(name, low)} to {schema.cell(name, high)}"
            for name, (low, high) in zip(self.vary, ends, strict=True)
        )
        caption = f"{counted(len(self), 'point', 'points')} along {', '.join(spans)}{not_all(self)}"
        return in_rows(caption, schema, len(self), lambda some: selected_rows(columns, some))

    def select(self, which: BoolArray) -> Self:
        """The points that ``which`` marks.

        Parameters
        ----------
        which : array of bool
            Shape (points,).

        Returns
        -------
        Points
            Of the same class.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> len(found), len(found.select(found.theta0 < 1.0))
        (2, 1)
        """
        values = selected_rows(self._values, which)
        ended = self._ended
        if isinstance(ended, Ended) and not callable(ended.after):
            ended = Ended(
                ended.ends[which],
                ended.when[which],
                selected_rows(ended.after, which),
                ended.unstable if callable(ended.unstable) else self._unstable[:, which],
            )
        return replace(
            self, kind=self.kind[which], error=self.error[which], _values=values, _ended=ended
        )

    def between(self, spans: FloatArray) -> Self:
        """The points in ranges of what varies, shape (number, 2), which take the place of those
        that were searched.

        Parameters
        ----------
        spans : array
            Shape (number of parameters that vary, 2), angles in radians.

        Returns
        -------
        Points
            Of the same class.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> found = ss.folds(ss.Parameters.article(mu0=0.5))
        >>> found.between(np.array([[0.0, 1.0]])).theta0.round(4)
        array([0.7777])
        """
        values = np.array([self[name] for name in self.vary])
        inside = np.asarray(((spans[:, :1] <= values) & (values <= spans[:, 1:])).all(axis=0))
        return replace(
            self.select(inside), region=np.concatenate([self.region[: -len(self.vary)], spans])
        )

    def _for_file(self) -> Self:
        ended = replace(self._what_ends, after=self.after, unstable=self._unstable)
        return replace(self, _ended=ended)

    @cached_property
    def _what_ends(self) -> Ended:
        return self._ended if isinstance(self._ended, Ended) else self._ended(self)

    @cached_property
    def _derived(self) -> dict[str, FloatArray]:
        """Quantities that follow from the states."""
        p = self.parameters.replace(**{name: self[name] for name in self.vary})
        derived = derived_of_states(
            p, [coordinate[:, None] for coordinate in self.coordinates.values()]
        )
        return selected_rows(derived, (slice(None), 0))

    @property
    def ends(self) -> NDArray[np.str_]:
        """Whether the stable state that ends is the lower or the upper one."""
        return self._what_ends.ends

    @property
    def when(self) -> NDArray[np.str_]:
        """Direction of the parameter in which two states vanish."""
        return self._what_ends.when

    @cached_property
    def after(self) -> Mapping[str, FloatArray]:
        """State to which the state that ends jumps, by the names of ``state_columns``."""
        found = self._what_ends.after
        return found(self) if callable(found) else found

    @cached_property
    def _unstable(self) -> IntArray:
        """The columns ``unstable_before`` and ``unstable_after``, shape (2, points)."""
        found = self._what_ends.unstable
        found = found(self) if callable(found) else found
        return np.full((2, len(self)), -1) if found is None else found

    @property
    def unstable_before(self) -> IntArray:
        """Growing eigenvalues on one side."""
        return self._unstable[0]

    @property
    def unstable_after(self) -> IntArray:
        """Growing eigenvalues on the other side."""
        return self._unstable[1]

    def _column(self, name: str) -> NDArray[Any]:
        if name in self._values:
            return self._values[name]
        if name in self.parameters.ranges:
            given = self.parameters[name]
            return np.full(len(self), np.nan if given is None or given.ndim else float(given))
        if name in self.state_columns:
            return self._derived[name]
        for each in UNSTABLE:
            if name == self._own(each):
                return np.asarray(getattr(self, each))
        return self.data()[name]


def after_if_known(points: Points) -> Mapping[str, FloatArray]:
    """The column ``after`` if it is known without a search; else empty."""
    after = points.__dict__.get("after", points._what_ends.after)
    return {} if callable(after) else after


@dataclass(frozen=True, eq=False)
class StickingStates(Named, Rows):
    """Connected sets of states in which friction holds the mass, a row for each, in the order of
    the first coordinate.

    Of every coordinate ``x`` the least and the largest value in a set are ``x_low`` and ``x_high``,
    −∞ and ∞ of one on which no force depends, as on a ramp, or along which states run to infinity,
    as where friction locks; angles are radians.

    Attributes
    ----------
    parameters : Parameters
        What was asked for.
    error : ndarray
        Bound on |error| / max(1, |value|) of these values.
    complete : bool
        Whether these are all states of sticking; otherwise ``remarks`` say what was not searched.
    """

    schema = (
        Column("{q}_low", "{q}", "least {q} of the set"),
        Column("{q}_high", "{q}", "largest {q} of the set"),
        Column("measure", "", "length, area or volume of a set of several frictions"),
        Column("error", "1", "bound on |error| / max(1, |value|)"),
    )
    _held = "ends"

    parameters: Any
    error: FloatArray
    complete: bool
    remarks: tuple[str, ...]
    ends: Mapping[str, FloatArray] = field(repr=False)


@dataclass(frozen=True, eq=False)
class Curve(Named, Rows):
    """Folds in order along a curve: the parameters that vary and the coordinates are attributes
    under their own names.

    Curves of closed forms also say what ends there and where it jumps to: ``upper``, that the
    stable state that ends is the upper one of the two in θ, which changes at a cusp;
    ``when_theta0`` and ``when_mu0``, 1 where it ends as that parameter rises and −1 where it ends
    as it falls; and ``theta_after``, ``x_after``, ``y_after``. Angles are radians.
    """

    schema = (
        Column("upper", "1", "whether the stable state that ends is the upper one in theta"),
        Column("{p}_after", "{p}", "{p} of the state that is jumped to"),
        Column("omega", "1/s", "frequency of the onset"),
        Column("criticality", "1", "supercritical, subcritical or undecided"),
        Column("lyapunov", "", "first Lyapunov coefficient"),
        Column("lyapunov_error", "", "bound on its error"),
        Column("touching", "1", "contacts that touch, of several"),
        Column("at_border", "1", "the contact that only just touches, of several"),
    )
    _held = "values"

    values: Mapping[str, NDArray[Any]] = field(repr=False)


def joined_curves(curves: Sequence[Curve]) -> dict[str, NDArray[Any]]:
    """Columns of curves, one curve after the other, and of each point the number of its
    ``curve``; empty without curves.
    """
    if not curves:
        return {}
    sizes = [len(curve) for curve in curves]
    names = (name for name in curves[0].values if name in curves[-1].values)
    return {
        "curve": np.repeat(np.arange(len(sizes)), sizes),
        **{name: np.concatenate([one.values[name] for one in curves]) for name in names},
    }


@dataclass(frozen=True, eq=False)
class BifurcationSet(Result):
    """Curves of folds in the plane of two parameters, and the cusps on them; ``complete`` says
    whether these are all.

    Attributes
    ----------
    vary : tuple of str
        The two parameters.
    curves : tuple of Curve
        Folds, and of several contacts border folds, in the order in which they follow each other,
        as many as make straight lines between them look smooth. Of closed forms they are float64,
        and none of the curves is missed; of a search each point is proved, cusps stand among them,
        and that they are joined in the right order is not proved.
    cusps : Points
        All cusps of the region, proved.
    complete : bool
        Whether these are all: of closed forms always; of a search where all folds on all ``lines``,
        and all extrema and ends of curves, cusps among them, are proved: between two of these is a
        line, so that no curve is missed, however small.
    lines : mapping
        For each parameter the values at which all folds along the other one are known; empty where
        closed forms need none.
    undecided : ndarray
        Lower and upper ends of the boxes on lines that are not decided, shape (boxes, unknowns, 2):
        coordinates, then parameters.
    remarks : tuple of str
        Why the result is not complete: what is known of these boxes, and what was not searched.
    """

    vary: tuple[str, ...] = field(repr=False)
    curves: tuple[Curve, ...]
    cusps: Points
    complete: bool
    lines: Mapping[str, FloatArray] = field(default_factory=dict, repr=False)
    undecided: FloatArray = field(default_factory=lambda: np.empty((0, 0, 2)))
    remarks: tuple[str, ...] = ()

    @property
    def _of_model(self) -> Model | None:
        return self.cusps.parameters.model

    def __len__(self) -> int:
        return len(self.curves)

    def data(self) -> dict[str, NDArray[Any]]:
        """The points of all curves, one curve after the other, and of each the number of its
        ``curve``.

        Returns
        -------
        dict of str to array
            Columns of one length, angles in radians; empty without curves.

        Examples
        --------
        >>> import spragsym as ss
        >>> found = ss.bifurcation_set(ss.Parameters.article())
        >>> columns = found.data()
        >>> sorted(columns)[:3], len(set(columns["curve"])) == len(found.curves)
        (['curve', 'mu0', 'theta'], True)
        """
        return joined_curves(self.curves)


@dataclass(frozen=True)
class Jump(Result):
    """A state that vanishes at a fold, leaves the contact or runs to infinity, and the one that
    takes its place.

    ``before`` and ``after`` say where they are, by the names of ``Path.state_columns``: numbers,
    angles in radians. Where a path ends as its state runs to infinity, ``before`` is infinite, NaN
    in coordinates that stay finite; ``after`` is empty and ``undamped_after`` None.
    """

    schema = (
        Column("{p}_before", "{p}", "{p} of the state that ends"),
        Column("{p}_after", "{p}", "{p} of the state that takes its place"),
        Column("error", "1", "bound on the error of the value"),
    )

    value: float  #: of the parameter, at the fold, on the border or in the limit
    # ``"fold"``, ``"pitchfork"``, ``"border"`` where the state leaves the contact,
    # ``"border_fold"``, or ``"infinity"``
    kind: str
    before: Mapping[str, float]
    after: Mapping[str, float]
    undamped_after: EquilibriumType | None
    error: float  #: bound on the error of ``value``
    touching: str = ""  #: contacts that touch before it, of several


@dataclass(frozen=True, eq=False)
class Path(OfStates, Rows):
    """States along the values of the parameter, in the order in which they are passed, and the
    jumps between them; a path whose state runs to infinity ends there, see
    :class:`spragsym.results.Jump`.

    Each coordinate is an attribute under its own name, of the shape of ``values``; so are the
    direction and the length of each inclined spring, as of :class:`spragsym.results.Equilibria`.
    Angles are radians. ``undamped`` has the codes of (27); ``stability``, ``growth`` and
    ``growth_sign`` are those of the full linearization, made when they are asked for.
    """

    schema = (
        Column("stability", "1", "what small deviations do: stable, neutral, unstable"),
        Column("undamped", "1", "type of state by (27), without damping", EquilibriumType),
        Column("touching", "1", "contacts that touch, of several"),
        Column("growth", "1/s", "largest real part of the damped eigenvalues"),
        Column("growth_sign", "1", "1 where growth is proved, -1 where that nothing grows is"),
    )

    _held = "places"

    parameters: Any
    vary: str
    values: FloatArray
    undamped: Int8Array
    jumps: tuple[Jump, ...]
    places: Mapping[str, FloatArray] = field(repr=False)
    _along: Equilibria = field(repr=False)

    @property
    def _over(self) -> dict[str, FloatArray]:
        return {self.vary: self.values}

    @property
    def _items(self) -> Items:
        # Columns of the full linearization are those of the equilibria along the path.
        ours = {self._own(name): name for name in ("stability", "growth", "growth_sign")}
        places = {self.vary: self.values, **self.places, self._own("undamped"): self.undamped}

        def made(name: str) -> object:
            return places[name] if name in places else getattr(self._along, ours[name])[:, 0]

        return Items((*places, *ours), made)


@dataclass(frozen=True, eq=False)
class CriticalLoad(Result, NDArrayOperatorsMixin):
    """First end of the state that is followed over a range of another parameter; a number, or an
    array, as ``value``.

    Numbers for one point, arrays of the shape of the parameters for many; angles are radians.

    Attributes
    ----------
    vary, over : str
        The parameter along which the state is followed, and the one over whose range.
    value, where : float or ndarray
        Of ``vary`` and of ``over``; both are attributes under these names, too, as ``mu0`` and
        ``theta0``.
    kind : str or ndarray of str
        ``"cusp"``; ``"turn"`` where a curve of folds turns back in ``vary``; ``"border"`` where the
        state leaves the contact; ``"end"`` where it is lowest at an end of the range of ``over``;
        ``"infinity"`` where the state runs to infinity; empty where the state ends nowhere: then
        ``value`` is infinite and ``where`` NaN; ``"undecided"`` where nothing is known above
        ``value``, below which the state does not end.
    error : float or ndarray
        Bound on \\|error\\| / max(1, \\|value\\|) of both.
    complete : bool
        Whether all of this is proved; otherwise ``remarks`` say what is not.
    """

    vary: str
    over: str
    value: Any
    where: Any
    kind: Any
    error: Any
    complete: bool = True
    remarks: tuple[str, ...] = ()

    def _shown(self) -> dict[str, Any]:
        values = named_fields(self)
        named = {values.pop("vary"): values.pop("value"), values.pop("over"): values.pop("where")}
        return named | values

    @property
    def shape(self) -> Shape:
        """Shape of the parameters."""
        return np.shape(self.value)

    def __getattr__(self, name: str) -> Any:
        names = {self.__dict__.get("vary"): "value", self.__dict__.get("over"): "where"}
        if name not in names:
            raise AttributeError(f"{type(self).__name__!r} has no attribute {name!r}")
        return self.__dict__[names[name]]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.value, dtype=dtype, copy=copy)

    def __array_ufunc__(self, ufunc: object, method: str, *inputs: Any, **options: Any) -> Any:
        return getattr(ufunc, method)(
            *(one.value if isinstance(one, CriticalLoad) else one for one in inputs), **options
        )

    def __float__(self) -> float:
        return float(self.value)

    def __round__(self, digits: int | None = None) -> FloatArray | float:
        return round(self.value, digits)

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)

    def __str__(self) -> str:
        undecided = np.ndim(self.kind) == 0 and self.kind == "undecided"
        return f"{self.value} or more, undecided" if undecided else str(self.value)

    def __len__(self) -> int:
        return len(self.value)

    def __getitem__(self, index: Any) -> Any:
        """A column by its name, or the answers of some points by their index."""
        if isinstance(index, str):
            return super().__getitem__(index)
        selected = {
            name: getattr(self, name)[index] for name in ("value", "where", "kind", "error")
        }
        return replace(
            self,
            **{name: part if np.ndim(part) else part.item() for name, part in selected.items()},
        )
