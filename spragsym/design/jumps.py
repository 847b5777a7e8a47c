"""Jump values: where the followed state ends as one parameter moves, and their gradients; many
points at once, for any model.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..bifurcation.crossings import border_arrivals
from ..bifurcation.defining_systems import Augmented, Family, ranges, touch
from ..bifurcation.paths import ModelEnd, first_end
from ..bifurcation.points import slopes_at_infinity
from ..bifurcation.tubes import ROUNDED_UP, Place, Tubes
from ..bifurcation.turning_points import limit_points, passed, past
from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, UndecidedWarning
from ..core.questions import Method, model_of, question
from ..display import Table
from ..models.model import label_of
from ..models.parameters import ParameterSet, as_numbers, set_of
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    IntArray,
    Intervals,
    quiet,
)
from ..results import Equilibria, Named
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.forces import filled
from ..statics.reference_state import reference_state
from ..statics.search import balances_of, number_of


@question
def first_limit_points(
    p: ParameterSet,
    vary: str | None = None,
    *,
    direction: str = "up",
    begin: float | None = None,
    until: float | None = None,
    method: Method = "auto",
) -> Ends:
    """The first end of the followed state of each point, and the state there; arguments as for
    :func:`jump_value`.
    """
    return Followed(p, p.model.rising(vary, 0.0)[0], direction, begin, until).ends()


@in_usual_state
def jump_value(
    p: ParameterSet,
    vary: str | None = None,
    *,
    direction: str = "up",
    begin: float | None = None,
    until: float | None = None,
    method: Method = "auto",
) -> float | FloatArray:
    """The first value at which the followed state ends as one parameter moves: it jumps there.

    Parameters
    ----------
    p : Parameters
        Of any model and shape. Of ``theta0`` and ``mu0`` the one that varies is not used, and may
        be missing.
    vary : str, optional
        The parameter that moves, by default ``mu0``. ``mu0`` and ``theta0`` move from the lower end
        of their range, if it is finite, others from the value in ``p``.
    direction : {"up", "down"}
        Direction of the move; ``mu0`` and ``theta0`` rise.
    begin, until : float, optional
        First and last value. The default of ``until`` is the end of the range. If that is infinite,
        it is 10 times the larger of the base value and the own value, at least 10; for the
        article's model there is no limit.
    method : {"auto", "closed", "search"}
        A closed form if the model has one for these arguments, else tubes around curves of states;
        only the closed form; or only tubes.

    Returns
    -------
    float or ndarray
        Of the shape of the parameters that are used; NaN where the state is proved to go on to
        ``until``. A fold within its error of ``until`` may be missed.

    Raises
    ------
    ParameterError
        For an unknown parameter, or a direction or an end that is not possible.
    ConvergenceError
        If a single point is not decided. In an array such a point is NaN, with an
        :class:`~spragsym.core.errors.UndecidedWarning`.

    Notes
    -----
    Source: tubes around curves of states from the reference state at the first value, see
    :mod:`spragsym.statics.reference_state`, up to the fold and across it, see
    :mod:`spragsym.bifurcation.turning_points`. Points that tubes do not decide are followed between
    all folds that a search finds, see :func:`spragsym.bifurcation.paths.first_end`; the end may
    then also be one where the state leaves the contact. The article's model: f = f′ = 0, see
    :mod:`spragsym.kang_nam.jump_values`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians([30.0, 44.5593177, 80.0]))
    >>> np.round(ss.jump_value(p), 6)
    array([0.850303, 0.5     ,      nan])
    >>> round(float(np.degrees(ss.jump_value(ss.Parameters.article(mu0=0.7), "theta0"))), 6)
    35.353706
    >>> p = ss.load("cubic_contact").Parameters(theta0=[0.7, 0.9, 1.4], gamma=3000.0)
    >>> np.round(ss.jump_value(p), 6)
    array([0.597422, 0.385931,      nan])
    """
    model_of(p).require_answered("jump_value")
    found = require_known(
        first_limit_points(p, vary, direction=direction, begin=begin, until=until, method=method)
    ).value
    return found if found.ndim else float(found)


@in_usual_state
def jump_gradient(
    p: ParameterSet,
    vary: str | None = None,
    *,
    direction: str = "up",
    begin: float | None = None,
    until: float | None = None,
    method: Method = "auto",
) -> JumpGradient:
    """Derivatives of :func:`jump_value` by all parameters.

    Parameters
    ----------
    p, vary, direction, begin, until, method
        As for :func:`jump_value`.

    Returns
    -------
    JumpGradient
        NaN where the state goes on, ends at a pitchfork, or loses contacts at once that it does not
        lose at once beside these parameters; and by a parameter that is 0 where the state runs to
        infinity, if forces far away are others as soon as it is not.

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense.

    Notes
    -----
    Source: F = 0 and w K = 0 at the fold, differentiated: since w ∂F/∂q = 0, dv/dp =
    −(w · ∂F/∂p)/(w · ∂F/∂v). Where a contact is lost or regained, its gap is one more row of F.
    Near a cusp digits are lost, and beyond it there is no jump.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> slopes = ss.jump_gradient(ss.Parameters.article(theta0=np.radians(30.0)))
    >>> each = slopes.theta0 * np.radians(1.0), slopes.sigma * 0.01
    >>> print("{:.4f} for each degree, {:.4f} for each 0.01 of sigma".format(*each))
    -0.0313 for each degree, 0.0186 for each 0.01 of sigma
    """
    model_of(p).require_answered("jump_gradient")
    found = require_known(
        first_limit_points(p, vary, direction=direction, begin=begin, until=until, method=method)
    )
    name = model_of(p).rising(vary, 0.0)[0]
    return JumpGradient(name, found.value, slopes_of(p, name, found))


@question
def limit_point_passed(
    p: ParameterSet,
    vary: str | None = None,
    begin: float | FloatArray | None = None,
    *,
    coarse: bool = False,
    method: Method = "auto",
) -> FloatArray:
    """1 where the followed state has ended as ``vary`` rises to its value in ``p``, 0 where it has
    not, NaN where that is unknown.

    ``vary`` rises from ``begin``, one value for all points or one for each; by default the lower
    end of its range. A ``coarse`` answer is NaN beside cusps too, where an answer takes longest.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> limit_point_passed(ss.Parameters.article(theta0=np.radians(40.0), mu0=[0.5, 0.6, 0.7]))
    array([0., 1., 1.])
    """
    vary, begin = p.model.rising(vary, begin)
    return Followed(p, vary, "up", begin, np.maximum(begin, p[vary])).have_ended(coarse=coarse)


def slopes_of(p: ParameterSet, vary: str, found: Ends) -> dict[str, FloatArray]:
    """Derivatives dv/dp of the values at which states end, by parameter; NaN without an end."""
    balances, shape, size = balances_of(p.model), found.value.shape, found.value.size
    names, met = list(balances[0].parameters), dict[int, tuple[int, ...]]()
    states = found.state.reshape(balances[0].n, -1).copy()
    columns = (found.value if name == vary else p[name] for name in names)
    given = np.stack([np.broadcast_to(column, shape).reshape(-1) for column in columns])
    for i, end in found.others.items():
        if end.kind in ("border", "border_fold"):
            labels = [*map(label_of, p.model.contacts)]
            met[i] = tuple(map(labels.index, end.at_border.split(", ")))
            states[:, i] = [end.before[name] for name in balances[0].coordinates]
    slopes = np.full((len(names), size), np.nan)
    groups = dict[tuple[int, tuple[int, ...]], list[int]]()
    for i, number in enumerate(np.broadcast_to(found.combination, shape).ravel().tolist()):
        groups.setdefault((number, met.get(i, (-1,))), []).append(i)
    for (number, borders), rows in groups.items():
        some = balances[number], vary, states[:, rows], given[:, rows]
        first, *others = (_slopes(border, *some) for border in borders)
        # Of contacts that open at once but here the first one to do so is another on each side.
        alike = [np.isclose(first, one, 1e-6, 1e-9).all(axis=0) for one in others]
        slopes[:, rows] = np.where(np.logical_and.reduce(alike), first, np.nan)
    # Without an end, whatever the forces depend on.
    slopes[:, np.isnan(states).any(axis=0)] = np.nan
    for i, end in found.others.items():
        if end.kind == "infinity":
            balance = balances[number_of(balances, end.touching)]
            before = np.array([end.before[name] for name in balance.coordinates])
            by_u, by_p = slopes_at_infinity(balance, vary, given[:, i], end.error, before)
            slopes[:, i] = _along(by_u[None], by_p[None], names.index(vary))[:, 0]
    return {name: one.reshape(shape) for name, one in zip(names, slopes, strict=True)}


def _slopes(
    border: int, balance: Balance, vary: str, states: FloatArray, given: FloatArray
) -> FloatArray:
    """dv/dp by parameter at folds, or where the gap of a contact is 0, whose number is not
    negative.
    """
    names, size, n = list(balance.parameters), states.shape[1], balance.n
    with quiet():
        at = balance.at(list(states), balance.floats(given), xp=np)
        K, moved = (
            np.moveaxis(filled(part, (size,)), -1, 0)
            for part in (at.stiffness(), balance.by_parameters(at, names))
        )
        if border >= 0:
            family = Family(None, balance, tuple(names), given, np.zeros((len(names), 2)))
            system = Augmented(family, touch(border))
            z = Intervals.point(np.concatenate([states, given]))
            gap = np.moveaxis(system.jacobian(z, system.prepared_at(given)).middle[-1:], -1, 0)
            K, moved = (
                np.concatenate(both, axis=1) for both in ((K, gap[..., :n]), (moved, gap[..., n:]))
            )
        return _along(K, moved, names.index(vary))


def _along(K: FloatArray, moved: FloatArray, own: int) -> FloatArray:
    """dv/dp from the derivatives of equations by their unknowns, and by parameters (``moved``), of
    which number ``own`` is v; shape (P, N).
    """
    w = np.linalg.svd(np.nan_to_num(K))[0][:, :, -1]
    along = np.einsum("Ni,Nij->jN", w, moved)
    slopes = 0.0 - along / along[own]
    slopes[own] += 1.0
    return slopes


def no_state_to_follow(eq: Equilibria, vary: str) -> str:
    """A text if it is proved that no state is in contact at one point, else an empty one."""
    if eq.count.any() or not (eq.decided & eq.whole).all():
        return ""
    return (
        f"no state in contact at {vary} = {float(eq[vary]):g}, from where one is followed; begin "
        "where there is one"
    )


class Followed:
    """States of many points, followed as one parameter moves; arguments as for
    :func:`jump_value`.
    """

    def __init__(
        self,
        p: ParameterSet,
        vary: str,
        direction: str,
        begin: float | FloatArray | None,
        until: float | FloatArray | None,
    ) -> None:
        if direction not in ("up", "down"):
            raise ParameterError(f"direction = {direction!r}; give 'up' or 'down'")
        model = p.model
        model.require_parameter(vary)
        self.model, self.vary, self.forward = model, vary, 1 if direction == "up" else -1
        self.near = p.followed
        allowed, given = model.Parameters.ranges[vary], p
        rises = vary in (model.inclination, model.coefficient) and np.isfinite(allowed.low)
        if begin is None and rises:
            if self.forward < 0:
                raise ParameterError(
                    f"direction = 'down': {vary} rises from its lower end; give begin, or "
                    "direction = 'up'"
                )
            begin = allowed.reached(allowed.low)
        if begin is not None:
            p = p.replace(**{vary: as_numbers("begin", begin, allowed)})
        # If only the moving parameter would be an array, ``until`` alone gives the shape.
        self.shape = np.broadcast_shapes(p.shape, () if until is None else np.shape(until))
        self.balances = balances_of(model)
        self.balance = self.balances[0]
        columns = p.broadcast(*self.balance.parameters)
        self.fixed = np.stack(
            [np.broadcast_to(column, self.shape).reshape(-1) for column in columns]
        )
        self.begin = self.fixed[self.balance.parameters.index(vary)]
        if until is None:
            far = allowed.reached(float(ranges(given, (vary,), {})[0, int(self.forward > 0)]))
            until = self.forward * max(
                self.forward * far, float((self.forward * self.begin).max(initial=-np.inf))
            )
        self.until = np.broadcast_to(as_numbers("until", until, allowed), self.shape).reshape(-1)
        if ((self.until - self.begin) * self.forward < 0).any():
            way = "below" if self.forward > 0 else "above"
            raise ParameterError(
                f"until = {self.until.min():g} is {way} where {vary} begins; give one beyond "
                "it, or another direction"
            )

    def have_ended(
        self,
        *,
        coarse: bool = False,
        of_state: tuple[FloatArray, FloatArray] | None = None,
    ) -> FloatArray:
        """1 where the state of a point has ended, 0 where it has not, NaN where tubes do not
        decide.

        The state is the reference state. With ``of_state``, approximate coordinates and a radius,
        both of shape (n, M), it is the only state within that radius. Tubes with a coordinate as
        the pivot pass a fold without computing it. Where they do not decide, the fold is computed,
        unless the answer may be ``coarse``.
        """
        found = np.full(self.begin.size, np.nan)
        for rows, tubes, start, goal in self._parts() if of_state is None else self._of(*of_state):
            safe, top, _ = passed(tubes, start, goal)
            ended = np.where(start.proved & (safe >= goal), 0.0, np.where(top <= goal, 1.0, np.nan))
            left = np.flatnonzero(np.isnan(ended) & start.proved)
            # If it is proved that no state exists at the goal, the followed one has ended, perhaps
            # at infinity.
            eq = equilibria(self._points(rows[left]).replace(**{self.vary: goal[left]}))
            ended[left[eq.decided & eq.whole & (eq.count == 0)]] = 1.0
            left = np.flatnonzero(np.isnan(ended))
            proved = self._by_tubes(tubes[left], start[left], goal[left], coarse=coarse)
            ended[left] = np.where(proved.decided, np.isfinite(proved.z[-1]), np.nan)
            found[rows] = ended
        return found.reshape(self.shape)

    def _blocks(self) -> list[IntArray]:
        """Indices of all points in blocks."""
        size, block = self.begin.size, 8192  # points at a time
        return np.split(np.arange(size), range(block, size, block))

    def ends(self) -> Ends:
        """The end of the state of each point."""
        n, size, others = self.balance.n, self.begin.size, dict[int, ModelEnd]()
        z, error, reasons = np.empty((n + 1, size)), np.empty(size), dict[int, str]()
        combination = np.zeros(size, dtype=int)
        for rows, tubes, start, goal in self._parts():
            proved = self._by_tubes(tubes, start, goal)
            z[:, rows], error[rows], combination[rows] = proved.z, proved.error, proved.combination
            for column in np.flatnonzero(proved.border != ""):
                i = int(rows[column])
                others[i] = self._at_border(proved, int(column))
                z[:n, i] = np.nan
            for i in rows[~proved.decided].tolist():
                span = float(self.begin[i]), float(self.until[i])
                none = no_state_to_follow(equilibria(self._points(i)), self.vary)
                if none and not self._meets_a_fold(i):
                    reasons[i] = none
                    continue
                try:
                    end = (
                        first_end(self._points(i), self.vary, span) if span[0] != span[1] else None
                    )
                except (ConvergenceError, ParameterError) as why:  # the fold may lie before it
                    reasons[i] = str(why)
                    continue
                if end is not None:
                    z[n, i], error[i] = end.value, end.error
                    combination[i] = number_of(self.balances, end.touching)
                    if end.kind == "fold":
                        z[:n, i] = [end.before[name] for name in self.balance.coordinates]
                    else:
                        others[i] = end
        z, error, until, combination = (
            each.reshape((*each.shape[:-1], *self.shape))
            for each in (z, error, self.until, combination)
        )
        return Ends(z[n, ...], error, z[:n], reasons, until, combination, others)

    def _meets_a_fold(self, i: int) -> bool:
        """Whether states are so near to the first value of a point, at which there are none, that
        its float may lie beyond their fold by rounding.
        """
        beside = float(self.begin[i]) * (1.0 + 1e-9 * np.array([-1.0, 1.0]))
        allowed = self.model.Parameters.ranges[self.vary]
        inside = beside[allowed.inside(beside)]
        point = self._points(np.array([i]))
        return bool(equilibria(point.replace(**{self.vary: inside})).count.any())

    def _at_border(self, proved: _TubeVerdict, column: int) -> ModelEnd:
        """The end at the borders of contacts."""
        balance, near = self.balances[int(proved.combination[column])], proved.near[:, column]
        *q, value = proved.z[:, column].tolist()
        before = dict(zip(balance.coordinates, q, strict=True))
        met = (self.model.contacts[k] for k in np.compress(near, balance.opens))
        names, kind = ", ".join(map(label_of, met)), str(proved.border[column])
        return ModelEnd(value, kind, before, float(proved.error[column]), balance.touching, names)

    def _points(self, rows: IndexArray) -> ParameterSet:
        """Some points, or one, as parameters with the chosen followed state."""
        return set_of(
            self.model,
            dict(zip(self.balance.parameters, self.fixed[:, rows], strict=True)),
            self.near,
        )

    def _parts(self) -> Iterator[tuple[IntArray, Tubes, Place, FloatArray]]:
        """For points of one combination of touching contacts: their indices, tubes, places of the
        reference states and goals; a place is not proved if the state is not known.
        """
        for rows in self._blocks():
            eq = equilibria(self._points(rows))
            slot = reference_state(eq, self.near)
            states = [
                eq.coordinates[name][np.arange(rows.size), slot]
                for name in self.balance.coordinates
            ]
            z = np.array([*states, self.begin[rows]])
            decided = eq.decided & np.isfinite(z).all(axis=0)
            z[:, ~decided] = 0.0
            number = np.zeros(rows.size, dtype=int)
            if self.model.has_regimes:
                touching = eq.touching[np.arange(rows.size), slot]
                number[decided] = [
                    number_of(self.balances, one) for one in touching[decided].tolist()
                ]
            for k, balance in enumerate(self.balances):
                mine = number == k
                if mine.any():
                    tubes = Tubes.of_points(balance, self.vary, self.fixed[:, rows[mine]])
                    error = eq.error[mine, slot[mine]]
                    start = tubes.place(z[:, mine], error=error)
                    start.proved[~decided[mine]] = False
                    yield rows[mine], tubes, start, self.until[rows[mine]]

    def _of(
        self, states: FloatArray, radius: FloatArray
    ) -> Iterator[tuple[IntArray, Tubes, Place, FloatArray]]:
        """:meth:`_parts` for known states, each the only one within a radius of its coordinates."""
        for rows in self._blocks():
            tubes = Tubes.of_points(self.balance, self.vary, self.fixed[:, rows])
            start = tubes.place(np.vstack([states[:, rows], self.begin[rows]]))
            distance = np.abs(start.z[:-1] - states[:, rows]) + start.half_width[:-1]
            start.proved[:] &= (distance * ROUNDED_UP <= radius[:, rows]).all(axis=0)
            yield rows, tubes, start, self.until[rows]

    def _by_tubes(
        self, tubes: Tubes, start: Place, goal: FloatArray, *, coarse: bool = False
    ) -> _TubeVerdict:
        """What tubes tell of points of one combination of contacts, and of another one behind a
        border.
        """
        forward, size = self.forward, goal.size
        # A state that is steep and does not turn back is carried past there, some times.
        rounds = 1 if coarse else 4
        if coarse:  # beside a cusp more segments are needed
            tubes = replace(tubes, options=replace(tubes.options, segments=60))
        left, at = np.arange(size), start
        out = _TubeVerdict(
            np.zeros(size, dtype=bool),
            np.full(start.z.shape, np.nan),
            np.zeros(size),
            np.full(size, number_of(self.balances, tubes.balance.touching)),
            np.full(size, "", dtype="<U11"),
            np.zeros((len(tubes.balance.opens), size), dtype=bool),
        )
        # With large steps first: tubes over a coordinate, which pass the fold, go on from there.
        for least in (2.0**-8, *[None] * rounds):
            at = tubes[left].followed(at, goal[left], least)
            arrived = at.proved & (at.v == goal[left])
            out.decided[left[arrived]] = True
            left, at = left[at.proved & ~arrived], at[at.proved & ~arrived]
            if not left.size:
                break
            beyond = np.zeros(left.size, dtype=bool)
            for part in border_arrivals(tubes[left], at, goal[left]):
                rows, beyond[part.rows] = left[part.rows], True
                if part.kind == "passes":
                    out.scatter(
                        rows, self._by_tubes(part.tubes, part.place, goal[rows], coarse=coarse)
                    )
                else:
                    out.z[:, rows], out.error[rows] = part.z, part.error
                    out.decided[rows], out.border[rows] = True, part.kind
                    out.near[:, rows] = part.contacts
            left, at = left[~beyond], at[~beyond]
            fold = limit_points(tubes[left], at, forward)
            # What turns back beyond the goal has come to it.
            near, far = np.sort(
                [forward * (fold.low - goal[left]), forward * (fold.high - goal[left])], axis=0
            )
            found = fold.proved & (far <= 0)
            out.z[:, left[found]] = fold.z[:, found]
            out.error[left[found]] = np.maximum(fold.high - fold.z[-1], fold.z[-1] - fold.low)[
                found
            ]
            decided = found | (fold.proved & (near > 0))
            out.decided[left[decided]] = True
            left, at = left[~decided], at[~decided]
            if least is None:
                at = past(tubes[left], at, forward, 2.0**-8 * np.abs(goal[left] - start.v[left]))
        return out


@dataclass(frozen=True)
class _TubeVerdict(ByColumn):
    """Points of which it is told whether there is an end before the goal, the ends, shape (n + 1,
    N) or NaN, errors, and the numbers of the combination of contacts that touch there; the kind of
    a ``border`` that is met, if one is, and which contacts are ``near``, shape (contacts that open,
    N).
    """

    decided: BoolArray
    z: FloatArray
    error: FloatArray
    combination: IntArray
    border: NDArray[np.str_]
    near: BoolArray


@dataclass(frozen=True, eq=False)
class JumpGradient(Named):
    """Jump values and their derivatives by the parameters, each of the shape of the points; NaN
    where nothing jumps.

    Each derivative is an attribute by the name of its parameter. That by the moving parameter is 0,
    since the jump value does not depend on the value in ``p``.
    """

    _held = "slopes"

    vary: str
    value: FloatArray
    slopes: Mapping[str, FloatArray]

    def as_table(self) -> Table:
        """The value and its slopes; of many points the smallest and the largest.

        Returns
        -------
        Table
            Title, header and rows of text.

        Examples
        --------
        >>> import spragsym as ss
        >>> found = ss.jump_gradient(ss.Parameters.article(theta0=0.9, mu0=0.5), "mu0")
        >>> found.as_table().rows[0]
        ('mu0', '0.3816866751', '0.3816866751')
        """
        rows = []
        for name, values in {"value": self.value, **self.slopes}.items():
            finite = np.asarray(values)[~np.isnan(self.value)]
            ends = (
                (f"{finite.min():.10g}", f"{finite.max():.10g}") if finite.size else ("nan", "nan")
            )
            rows.append((self.vary if name == "value" else f"slope by {name}", *ends))
        return Table(
            f"JumpGradient, vary = {self.vary}, radians", ("", "smallest", "largest"), tuple(rows)
        )


@dataclass(frozen=True)
class Ends:
    """Ends of the states of many points: values, NaN where a state does not end, with error bounds.

    ``value``, ``error`` and ``until``, the limit up to which an end was sought, have the shape of
    the points. ``state`` are coordinates at folds, (n, …). ``reasons`` says, by the index in
    ``value.flat``, why a point is not decided. ``combination`` is the index of the touching
    contacts among :func:`spragsym.statics.search.balances_of`. ``others`` are the ends that are no
    folds, by index.
    """

    value: FloatArray
    error: FloatArray
    state: FloatArray
    reasons: Mapping[int, str]
    until: FloatArray
    combination: IntArray | int = 0
    others: Mapping[int, ModelEnd] = field(default_factory=dict)

    def kind(self, position: int = 0) -> str:
        """The kind of the end of one point."""
        end = self.others.get(position)
        return "fold" if end is None else end.kind


class EndVerb(NamedTuple):
    """Three forms of the verb for what a state does at its end."""

    does: str
    do: str
    has_done: str


def verb_of(kind: str | None) -> EndVerb:
    """The verb for a ``kind`` of :class:`ModelEnd`; that of a fold, or of no end, is to jump."""
    if kind == "border":
        return EndVerb("leaves the contact", "leave the contact", "has left the contact")
    if kind == "infinity":
        return EndVerb("runs to infinity", "run to infinity", "has run to infinity")
    return EndVerb("jumps", "jump", "has jumped")


def require_known(found: Ends) -> Ends:
    """The ends themselves; raises ConvergenceError if a single point is not decided, and warns if
    points of an array are not.
    """
    for reason in found.reasons.values():
        if not found.value.shape:
            raise ConvergenceError(reason)
        what = f"{len(found.reasons)} points have no answer and are NaN; the first: {reason}"
        warnings.warn(what, UndecidedWarning, stacklevel=3)
        break
    return found
