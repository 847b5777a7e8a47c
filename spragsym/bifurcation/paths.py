"""A state of a model followed as one parameter moves slowly: where it goes, where it vanishes, and
what it jumps to.

All folds along the parameter are known and proved beforehand. Between two of them a step is taken
from one value to the next only to the state that is proved to lie on the same branch: see
:mod:`spragsym.bifurcation.branches`.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.errors import ConvergenceError, ParameterError
from ..core.questions import Method, question
from ..core.remarks import At, Remark
from ..display import own_name
from ..models.model import label_of
from ..models.parameters import ParameterSet, Range, Span, as_numbers
from ..numerics.interval_arrays import EPS, FloatArray, IntArray, scale_of
from ..results import Equilibria, EquilibriumType, Jump, Path, Points, Result
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.options import SearchOptions
from ..statics.reference_state import chosen_state, least_slot, nearest_state
from ..statics.search import balances_of, columns
from ..statics.stability import with_a_zero
from ..statics.states import as_decided, combination_of, one_each, with_state
from .borders import combination, met_by
from .borders import joined as together
from .branches import clearly_nearest, linked
from .defining_systems import Family, given_column, touch
from .folds import folds
from .options import ContinuationOptions
from .points import escapes, isolated, which
from .singularities import ended
from .tubes import Place, Tubes
from .turning_points import limit_points


def _size(values: FloatArray, along: FloatArray) -> FloatArray:
    """|value|, and no less than 1 or the largest on the way if that is less, unless all are 0: over
    it room is left around values of a parameter in any units.
    """
    largest = float(np.abs(along).max()) or 1.0
    return np.maximum(min(1.0, largest), np.abs(values))


@dataclass(frozen=True)
class ModelEnd(Result):
    """Value at which a state vanishes at a fold, leaves the contact or runs to infinity."""

    value: float  #: of the parameter, at the fold, on the border or in the limit
    # ``"fold"``, ``"pitchfork"``, ``"border"`` where it leaves the contact, ``"border_fold"`` where
    # one of several contacts is lost or regained, or ``"infinity"`` where it runs there
    kind: str
    before: Mapping[str, float]  #: coordinates there
    error: float  #: bound on the error of ``value``
    touching: str = ""  #: contacts that touch before it, of several
    at_border: str = ""  #: the contact that is lost or regained there, if one is


#: Chooses among the slots of the equilibria behind a fold, given the coordinates of the fold: (eq,
#: before) → slot.
Choice = Callable[[Equilibria, Mapping[str, float]], int]


@question
def quasi_static_path(
    p: ParameterSet,
    vary: str,
    values: ArrayLike,
    *,
    start: int | str = "small",
    after_jump: Choice | None = None,
    options: ContinuationOptions | None = None,
    method: Method = "auto",
) -> Path:
    """Follow an equilibrium in contact as a parameter moves through ``values``, up or down, with
    its jumps.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the parameter that varies is not used.
    vary : str
        Its name.
    values : array_like
        One axis, strictly increasing or strictly decreasing.
    start : "small", "large" or int
        Where to begin, at the first value: the reference state, see
        :mod:`spragsym.statics.reference_state`, or the one that ``p.following(…)`` chose; the
        stable equilibrium of largest first coordinate, by size; or a slot of
        :func:`spragsym.equilibria`.
    after_jump : callable, optional
        Which equilibrium the system goes to after a jump: ``(eq, before) -> slot``. Without it the
        stable one that is nearest, or the only one that is left; from infinity, where none is the
        nearest, it goes nowhere. Whether the motion settles there
        or on a limit cycle, :func:`spragsym.simulate` tells.
    options : ContinuationOptions, optional
        Tolerances and limits of what is followed, and of the search below it.
    method : {"auto", "closed", "search"}
        A closed form if the model brings one for these arguments, the closed form only, or the
        search.

    Returns
    -------
    Path
        With the values that are reached: where the state runs to infinity, and no ``after_jump``
        says where it goes or no state is left, the path ends, with a last entry of ``jumps`` of the
        kind ``"infinity"``, whose ``after`` is empty and whose ``undamped_after`` is None.

    Raises
    ------
    ParameterError
        For values that do not go one way, or out of range, or a ``start`` that has no equilibrium.
    ConvergenceError
        Where folds or equilibria are not all decided, or nothing stable is left to jump to.

    Notes
    -----
    Source: article, Figures 6 and 13; all folds along the parameter, see :func:`spragsym.folds`,
    and which states lie on one branch, see :mod:`spragsym.bifurcation.branches`.

    A value that lies within the ``error`` of a fold of ``folds``, or is its float where that error
    is no more than rounding, counts as the fold itself, not passed yet: the state on it is the one
    that arrives there, and the jump comes beyond it. If the first value is a fold, "small" and
    "large" choose among the states there, the one in which two equilibria meet included; then the
    path goes on with the stable one of those two, or jumps. At a pitchfork where three equilibria
    become one that is stable each goes on as that one, and where one becomes three, two of them
    stable, the path goes on with the one of larger x, or of whatever the mirror turns. Where it is
    the middle one of three that is stable it ends there, and the path jumps. Of several contacts a
    state goes on where it passes from one combination of touches into another, and jumps at a
    border fold, see :mod:`spragsym.bifurcation.borders`; a value on a border is an error. Of states
    that are equally small, or equally near, the one of larger coordinates is taken.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> inclinations = np.radians(np.arange(1.0, 180.0))
    >>> up = ss.quasi_static_path(ss.Parameters.article(mu0=0.7), "theta0", inclinations)
    >>> [round(float(np.degrees(jump.value)), 6) for jump in up.jumps]
    [35.353706]
    """
    along = as_numbers("values", values, p.model.any_of(vary))
    steps = np.diff(along) if along.ndim == 1 else np.zeros(1)
    if not along.size or not ((steps > 0).all() or (steps < 0).all()):
        raise ParameterError(
            "values do not go one way; give one axis of one or more, strictly increasing or "
            "strictly decreasing"
        )
    continuation = QuasiStaticContinuation(p, vary, along, options)
    location = continuation.begin(start)
    out, touching = [continuation.state(0, location)], [continuation.touching(0, location)]
    jumps = []
    for node in range(1, continuation.mesh.size):
        location = continuation.followed(node, location)
        if continuation.ended(node, location):
            # No state is the nearest to infinity.
            if continuation.far[~location] and (
                after_jump is None or not continuation.eq.count[node]
            ):
                jumps.append(continuation.escape(~location))
                break
            location, jump = continuation.jump(node, ~location, after_jump)
            jumps.append(jump)
        if continuation.mesh[node] in along:
            out.append(continuation.state(node, location))
            touching.append(continuation.touching(node, location))
    *q, undamped, error = np.array(out).T
    along = along[: len(out)]
    coordinates: dict[str, Any] = dict(zip(continuation.balance.coordinates, q, strict=True))
    coordinates |= {name: np.array(touching) for name in continuation.contact_columns}
    states = one_each(p.replace(**{vary: along}), coordinates, undamped.astype(np.int8), error)
    named = (*states.state_columns, *continuation.contact_columns)
    places = {name: states[name][:, 0] for name in named}
    return Path(p, vary, along, states.undamped[:, 0], tuple(jumps), places, states)


def first_end(
    p: ParameterSet, vary: str, span: Span, *, start: int | str = "small"
) -> ModelEnd | None:
    """First value at which a state that is followed from the first value of a span to the last one
    vanishes; None if it does not.

    Arguments and errors as for :func:`quasi_static_path`; whether there is another state behind it
    is not asked.
    """
    continuation = QuasiStaticContinuation(p, vary, np.array(span))
    location = continuation.begin(start)
    for node in range(1, continuation.mesh.size):
        location = continuation.followed(node, location)
        if continuation.ended(node, location):
            return continuation.end(~location)
    return None


@question
def border_ends(
    p: ParameterSet,
    vary: str,
    span: Span,
    turns: Points,
    *,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> list[Points]:
    """Values at which states leave the contact or come into it, and at which they run to infinity,
    if they do, beside the folds ``turns``.
    """
    families, found = Family.every(p, (vary,), {vary: span}, None, options), list[Points]()
    combinations = [family.balance.pushing for family in families]
    for family in families:
        balance = family.balance
        for contact in balance.opens:
            if balance.pushing[contact] and balance.across(contact).pushing not in combinations:
                at_border = isolated(family.beyond(contact), touch(contact), "border")
                if not at_border.decided:
                    # A search does not tell a root on an end of its range, as a load from 0 has it
                    # where a domain ends.
                    wide = replace(family.beyond(contact), spans=_widened(p.ranges[vary], span))
                    at_border = isolated(wide, touch(contact), "border")
                if not at_border.decided:
                    raise ConvergenceError(
                        f"whether equilibria leave the contact along {vary} is not decided; "
                        "shorten the range"
                    )
                found.append(at_border)
    if not (
        turns.whole and np.isfinite(turns.region).all()
    ):  # states run to infinity only where nothing bounds them
        found += map(escapes, families)
    return found


def _widened(allowed: Range, span: Span) -> FloatArray:
    """A range that ends a little beyond the ends of the domain that it holds."""
    low, high = span
    room = 1e-3 * (high - low)
    ends = [
        low - room if low == allowed.low else low,
        high + room if high == allowed.high else high,
    ]
    return np.array([ends])


class QuasiStaticContinuation:
    """Values and the nodes beside each fold, the equilibria at all of them, and which of two
    neighbours lie on one branch.

    A place is a slot of the equilibria at a node, or ``~number`` of the point at which a state has
    vanished: where that is a fold and the node itself, the path goes on from the state in which two
    meet.
    """

    def __init__(
        self,
        p: ParameterSet,
        vary: str,
        along: FloatArray,
        options: ContinuationOptions | None = None,
    ) -> None:
        self.options = options or ContinuationOptions()
        self.search = self.options.asked
        #: Of every combination of contacts that touch, by the names of these, its balance.
        self.balances = {one.touching: one for one in balances_of(p.model, options=self.search)}
        self.p, self.vary, self.balance = p, vary, next(iter(self.balances.values()))
        p.model.require_parameter(vary)
        try:
            ends = self._ends(along, self.options.fold_distance)
        except ConvergenceError:  # of what lies beyond the values nothing is asked
            ends = self._ends(along, 1e-6)
        every = self._turns_within(along, ends)
        #: Points at which states vanish, and those at which they pass from one combination of
        #: contacts that touch into another.
        self.turns = every.select(every.kind != "passes")
        self.passes = every.select(every.kind == "passes")
        self.at, self.kinds = self.turns[vary], self.turns.kind
        #: Coordinates of the points at which states vanish, shape (n, numbers).
        self.q = np.array([self.turns[name] for name in self.balance.coordinates])
        self.error = self.turns.error * scale_of(self.at)
        self.far = np.char.startswith(self.kinds.astype(str), "infinity")
        self.mesh = self._mesh(along)
        self.eq = self._with_meetings(self._equilibria(self.mesh))
        #: All pairs of slots of a step on one branch, not only those that tubes join at once.
        self._links = functools.cache(self._linked)
        self.joined = self._in_combinations()

    def _equilibria(self, values: ArrayLike) -> Equilibria:
        """All equilibria at values of the parameter."""
        return equilibria(self.p.replace(**{self.vary: values}), options=self.search)

    def _in_combinations(self, only: int | None = None) -> list[dict[int, int]]:
        """Pairs of slots on one branch for each step, or for the one that is asked for, in which no
        contact is lost or regained.
        """
        found = list[dict[int, int]]()
        options = replace(self.options, halvings=0) if only is None else self.options
        for touching, balance in self.balances.items():
            eq, slots = combination_of(self.eq, touching, balance.contact)
            turns = together([self.turns, self.passes]) if len(self.balances) > 1 else self.turns
            turns = turns.select(met_by(turns, balance))
            pairs = linked(self.p, self.vary, eq, turns, only=only, options=options)
            found = found or [{} for _ in pairs]
            for step, (every, part) in enumerate(zip(found, pairs, strict=True), only or 0):
                every |= {slots[step][a]: slots[step + 1][b] for a, b in part.items()}
        return found

    def _linked(self, step: int) -> dict[int, int]:
        """All pairs of slots of a step on one branch, those that pass from one combination of
        contacts into another included.
        """
        (found,) = self._in_combinations(step)
        low, high = sorted(self.mesh[step : step + 2])
        passed = self.passes.select(
            (self.passes[self.vary] >= low) & (self.passes[self.vary] <= high)
        )
        if not len(passed):
            return found
        ends = self.turns.select((self.at >= low) & (self.at <= high))
        gone = [slot for slot in range(int(self.eq.count[step])) if slot not in found]
        begun = [slot for slot in range(int(self.eq.count[step + 1])) if slot not in found.values()]
        if len(passed) > 1 or len(ends) or len(gone) != 1 or len(begun) != 1:
            raise ConvergenceError(
                f"which states pass between {self.vary} = {low:.17g} and {high:.17g}, where a "
                "contact is lost or regained, is not told apart"
            )
        return found | {gone[0]: begun[0]}

    def _balance(self, node: int, slot: int) -> Balance:
        """The balance of the combination of contacts that touch in a state."""
        if len(self.balances) == 1:
            return self.balance
        return self.balances[str(self.eq["touching"][node, slot])]

    def _with_meetings(self, eq: Equilibria) -> Equilibria:
        """States along the path with those at values where states meet and the digits do not
        decide.

        Of a pitchfork it is the state in which three meet; the one in which two meet at a fold
        stands in no slot. That no other is there is known once all states beside the value are
        joined to those on it.
        """
        for node in np.flatnonzero(~eq.decided).tolist():
            here = np.flatnonzero((self.at == self.mesh[node]) & ~self.far)
            states = self.q[:, here].T
            room = self.options.fold_distance * scale_of(states)
            boxes = [box for box in eq.undecided if box.index == (node,)]
            near = np.array(
                [
                    ((states - box.low <= room) & (box.high - states <= room)).all(axis=-1)
                    for box in boxes
                ]
            )
            if not near.any(axis=-1).all():
                continue
            eq = as_decided(eq, node)
            for number in here.tolist():
                if self.kinds[number] == "pitchfork" and near[:, here == number].any():
                    eq = with_state(
                        eq,
                        node,
                        self._place(number),
                        self._stability_met(number),
                        float(self.turns.error[number]),
                    )
        return eq

    def _ends(self, along: FloatArray, beyond: float) -> list[Points]:
        """Values at which states vanish: folds, and where they leave the contact. Those on the ends
        are inside of what is searched.
        """
        allowed, room = self.p.ranges[self.vary], beyond * _size(along, along)
        low = max(float((along - room).min()), allowed.low)
        high = min(float((along + room).max()), allowed.high)
        found = folds(self.p, self.vary, between={self.vary: (low, high)}, options=self.search)
        if not found.decided:
            text = "folds with {} are not all decided; ss.folds lists the boxes, and a path needs "
            at = At(self.vary, (low, high))
            raise ConvergenceError(Remark(f"{text}a range without them", at))
        return [found, *border_ends(self.p, self.vary, (low, high), found, options=self.search)]

    def _turns_within(self, along: FloatArray, ends: list[Points]) -> Points:
        """Values on the way at which states vanish: one value for those that coincide within their
        errors, and the value asked for there.

        Twins by a mirror coincide, and each search rounds in its own way.
        """

        def every(name: str) -> NDArray[Any]:
            return np.concatenate([points[name] for points in ends])

        at, error = every(self.vary), np.concatenate([points.error for points in ends])
        wide = error * scale_of(at)
        order = np.argsort(at)
        begins = np.diff(at[order], prepend=-np.inf) > wide[order] + np.roll(wide[order], 1)
        at[order] = at[order][np.maximum.accumulate(np.where(begins, np.arange(at.size), 0))]
        off = np.abs(at[:, None] - along)
        # One whose error is no more than rounding has other floats than its own on one side of it,
        # unless it can't be told from 0.
        own = (error <= EPS) & (np.abs(at) > wide)
        at = np.where(off.min(axis=1) <= np.where(own, 0.0, wide), along[off.argmin(axis=1)], at)
        first, *others = ends
        names = self.balance.coordinates if others else first.state_columns
        names = [*names, *which(self.balance, 0)]
        values = {name: every(name) for name in names} | {self.vary: at}
        found = replace(
            first,
            kind=np.concatenate([points.kind for points in ends]),
            error=error,
            _values=values,
            _ended=ended if others else first._ended,
        )
        return found.select((at >= along.min()) & (at <= along.max()))

    def _mesh(self, along: FloatArray) -> FloatArray:
        """The values in their order, with a node on each side of each fold."""
        at = np.concatenate([self.at, self.passes[self.vary]])
        values, size = np.concatenate([along, at]), _size(at, along)
        apart = np.abs(values - at[:, None])
        # Between a fold and what is nearer than that no node has room: those beside the fold are
        # farther off than both.
        nearest = np.where(apart > 4 * EPS * size[:, None], apart, np.inf).min(
            axis=1, initial=np.inf
        )
        room = np.minimum(self.options.fold_distance * size, 0.25 * nearest)
        beside = np.concatenate([at - room, at + room])
        # Between floats next to each other there is no other.
        new = (along.min() < beside) & (beside < along.max()) & ~np.isin(beside, values)
        mesh = np.sort(np.concatenate([along, beside[new]]))
        return mesh if along[-1] > along[0] else mesh[::-1]

    def _require_decided(self, node: int) -> None:
        """Of nodes behind the end of a state nothing is asked."""
        if not self.eq.decided[node]:
            text = "equilibria at {} are not all decided; leave that value out, or end before it"
            at = At(self.vary, (float(self.mesh[node]),))
            raise ConvergenceError(Remark(text, at))

    def begin(self, start: int | str) -> int:
        """The slot at the first value."""
        self._require_decided(0)
        count = int(self.eq.count[0])
        if not isinstance(start, str):
            if (
                isinstance(start, bool)
                or not isinstance(start, int | np.integer)
                or not 0 <= start < count
            ):
                raise ParameterError(
                    f"start = {start!r}: the first value has {count} equilibria, slots 0 to "
                    f"{count - 1}"
                )
            return int(start)
        if start not in ("small", "large"):
            raise ParameterError(
                f"start = {start!r}; give 'small', 'large' or the slot of an equilibrium"
            )
        stable = [
            slot for slot in range(count) if self.eq.undamped[0, slot] == EquilibriumType.STABLE
        ] or list(range(count))
        met = self._met(0)
        if met and (self.mesh.size == 1 or count == len(self._links(0))):
            # The float of the fold lies just beyond the states that meet there.
            firm = [
                ~number for number in met if self._stability_met(number) == EquilibriumType.STABLE
            ]
            stable = [*firm, *stable] or [~number for number in met]
        if not stable:
            allowed, first = self.p.ranges[self.vary], float(self.mesh[0])
            at_end = first == allowed.reached(allowed.low)
            at = (
                f"the lower end of {self.vary}"
                if at_end
                else f"the first value, {self.vary} = {first!r},"
            )
            raise ParameterError(
                f"{at} has no equilibrium in contact; begin where there is one: at folds they "
                "begin and end"
            )
        table = np.array([self.state(0, slot) for slot in stable]).T
        states, error = table[:-2], np.full(len(stable), table[-1].max())
        if start == "large":
            return stable[int(least_slot(-np.abs(states[0]), states, error))]
        here = self.p.replace(**{self.vary: float(self.mesh[0])})
        every = np.isfinite(states[0])
        return stable[int(chosen_state(here, list(states), error, every, self.p.followed))]

    def _met(self, node: int) -> list[int]:
        """Numbers of the folds and borders that a node is equal to."""
        return np.flatnonzero(
            (self.at == self.mesh[node]) & (self.kinds != "pitchfork") & ~self.far
        ).tolist()

    def _stability_met(self, number: int) -> int:
        """Stability of states met on the way: where one λ is 0 the others decide."""
        given = columns(
            self.p.replace(**{self.vary: self.at[number : number + 1]}), self.balance.parameters
        )
        contact = combination(self.turns, number)
        return with_a_zero(Balance(self.p.model, contact), self.q[:, [number]], given)

    def followed(self, node: int, location: int) -> int:
        """The place at a node of the state that was in one at the node before."""
        self._require_decided(node)
        if location in self.joined[node - 1]:
            return self.joined[node - 1][location]
        if location < 0:
            return self._begun(node, location)
        number = self._limit_point(node - 1, location, node)
        if number is None and location in self._links(node - 1):
            return self._links(node - 1)[location]
        return ~(self._ending(node - 1, location, node) if number is None else number)

    def vanishing(self, node: int, slot: int, goal: int) -> int:
        """The number of the point at which a state vanishes on its way to the node before or
        behind, if it does.
        """
        number = self._limit_point(node, slot, goal)
        return self._ending(node, slot, goal) if number is None else number

    def moved(self, node: int, slot: int, goal: int) -> FloatArray:
        """By how much a state moves on its way to another node, angles as they go on."""
        tubes, start = self._standing(self._balance(node, slot), node, slot)
        there = tubes.followed(start, self.mesh[[goal]])
        if not there.sure[0] or there.v[0] != self.mesh[goal]:
            raise ConvergenceError(
                f"how the state moves from {self.vary} = {self.mesh[node]:.17g} on is not proved"
            )
        return (there.z - start.z)[:-1, 0]

    def ended(self, node: int, location: int) -> bool:
        """Whether a state has vanished on the way to a node, or at a point there from which it does
        not go on.
        """
        return location < 0 and ~location not in self._met(node)

    def _begun(self, node: int, location: int) -> int:
        """The stable one of the two states that begin at a fold, at the node behind it; the fold if
        they lie before it.
        """
        links = self._links(node - 1)
        begun = [slot for slot in range(int(self.eq.count[node])) if slot not in links.values()]
        if len(self._met(node - 1)) > 1:
            begun = [slot for slot in begun if self.vanishing(node, slot, node - 1) == ~location]
        return next(
            (slot for slot in begun if self.eq.undamped[node, slot] == EquilibriumType.STABLE),
            location,
        )

    def _candidates(self, node: int, other: int) -> IntArray:
        """Numbers of the points at which states may vanish between two nodes, or on them."""
        low, high = sorted((self.mesh[node], self.mesh[other]))
        return np.flatnonzero((self.at >= low - self.error) & (self.at <= high + self.error))

    def _limit_point(self, node: int, slot: int, goal: int) -> int | None:
        """The fold at which a state is proved to turn back on its way to another node, of several
        points where it may end.

        None if nothing is proved, or there are no two such points.
        """
        points = self._candidates(node, goal)
        here = points[self.kinds[points] == "fold"]
        if points.size < 2 or not here.size:
            return None
        tubes, start = self._standing(self._balance(node, slot), node, slot)
        if here.size > 1 and (self.at[here] == self.mesh[node]).all():
            # The float of the folds is one at which two states are left, too near to each other for
            # a tube.
            near = clearly_nearest(start.z[: tubes.n], self.q[:, here])[0]
            return int(here[near]) if near >= 0 else None
        forward = 1 if self.mesh[goal] > self.mesh[node] else -1
        found = limit_points(tubes, start, forward)
        if not found.sure[0]:
            return None
        away = np.abs(np.vstack([self.q, self.at])[:, here] - found.z) / scale_of(found.z)
        away = away.max(axis=0)
        nearest = int(away.argmin())
        return int(here[nearest]) if away[nearest] <= 1e-6 else None

    def _standing(self, balance: Balance, node: int, slot: int) -> tuple[Tubes, Place]:
        """A tube's beginning at a state."""
        given = given_column(self.p, balance.parameters, (self.vary,))
        tubes = Tubes.of_points(balance, self.vary, given, options=self.options)
        *q, _, error = self.state(node, slot)
        return tubes, tubes.place(np.array([*q, self.mesh[node]])[:, None], error=error)

    def _place(self, number: int, names: Sequence[str] = ()) -> dict[str, float]:
        """Coordinates of a point at which states vanish, or what else is named, by name."""
        return {name: float(self.turns[name][number]) for name in names or self.balance.coordinates}

    def _ending(self, node: int, location: int, goal: int) -> int:
        """The number of the point at which a state vanishes on its way from a node to the next
        one.
        """
        here = self._candidates(node, goal)
        if here.size == 1:
            return int(here[0])
        own = self._balance(node, location).extended()
        for number in here[np.char.startswith(self.kinds[here].astype(str), "border")].tolist():
            tubes, start = self._standing(own, node, location)
            there = tubes.followed(start, self.at[[number]])
            away = np.abs(self.q[:, [number]] - there.z[: tubes.n])
            if (
                there.sure[0]
                and there.v[0] == self.at[number]
                and (away <= there.radius[: tubes.n]).all()
            ):
                return int(number)
        others = here[(self.kinds[here] == "pitchfork") | self.far[here]]
        q = np.array([self.state(node, location)[:-2]]).T
        if others.size > 1 and self.far[others].all():  # of states that run opposite ways
            away = self.q[:, others]
            others = others[(np.isnan(away) | (np.sign(q) == np.sign(away))).all(axis=0)]
        elif others.size > 1 and not self.far[others].any():
            near = clearly_nearest(q, self.q[:, others])
            others = others[near[near >= 0]]
        if others.size == 1:  # at folds the state would be known to turn
            return int(others[0])
        ends = f"{self.vary} = {float(self.mesh[node]):.17g} and {float(self.mesh[goal]):.17g}"
        raise ConvergenceError(
            f"where the state ends between {ends} is not told apart from {here.size} folds "
            "and borders there"
        )

    def state(self, node: int, slot: int) -> list[float]:
        """Coordinates, type by (27), and a bound on the error."""
        if slot < 0:
            return [
                *self._place(~slot).values(),
                self._stability_met(~slot),
                self.turns.error[~slot],
            ]
        columns = (*self.eq.coordinates.values(), self.eq.undamped, self.eq.error)
        return [float(column[node, slot]) for column in columns]

    @property
    def contact_columns(self) -> tuple[str, ...]:
        """The column that says which contacts touch, of a model with several."""
        return (own_name(self.p.model, "touching"),) if self.p.model.has_regimes else ()

    def touching(self, node: int, slot: int) -> str:
        """Names of the contacts that touch in a state, of a model with several."""
        if not self.contact_columns:
            return ""
        if slot < 0:
            return str(self.turns.touching[~slot])
        return str(self.eq.touching[node, slot])

    def jump(self, node: int, number: int, choose: Choice | None) -> tuple[int, Jump]:
        """The slot behind the fold that ends the branch."""
        end = self.end(number)
        before = end.before
        eq = self._equilibria(float(self.mesh[node]))
        count = int(eq.count)
        how = {
            "border": "leaves the contact",
            "border_fold": "ends where a contact is lost or regained",
            "infinity": "runs to infinity",
        }.get(end.kind, f"ends in a {end.kind}")
        ends = f"the state {how} at {self.vary} = {end.value!r}"
        if not count:
            raise ConvergenceError(
                f"{ends}, and there is no other beyond it: end the path before it"
            )
        if choose is None:
            stable = (eq.undamped == EquilibriumType.STABLE) | (count == 1 and eq.whole)
            if not stable.any():
                raise ConvergenceError(
                    f"{ends}, and nothing stable in contact is left there: end the path "
                    "before it, or say in Python by "
                    "after_jump where it goes"
                )
            slot = int(nearest_state(eq, before, stable, eq.error + end.error))
        else:
            slot = choose(eq, before)
            if not 0 <= slot < count:
                raise ParameterError(
                    f"after_jump returned {slot!r}; there are {count} equilibria, slots 0 to "
                    f"{count - 1}"
                )
        behind = {name: float(eq.coordinates[name][slot]) for name in before}
        at_end = self._equilibria(end.value)
        there, nearest = (
            (at_end, int(nearest_state(at_end, behind)))
            if at_end.decided and at_end.count
            else (eq, slot)
        )
        after = {name: float(there[name][nearest]) for name in there.state_columns}
        whole = self._place(number, there.state_columns)
        kind = EquilibriumType(int(eq.undamped[slot]))
        # Another search may list the states at the node in another order.
        return int(nearest_state(self.eq, behind)[node]), Jump(
            end.value, end.kind, whole, after, kind, end.error, end.touching
        )

    def escape(self, number: int) -> Jump:
        """The last event of a path whose state runs to infinity."""
        end = self.end(number)
        state = self._place(number, self.eq.state_columns)
        return Jump(end.value, end.kind, state, {}, None, end.error, end.touching)

    def end(self, number: int) -> ModelEnd:
        """A point at which states vanish, as a result."""
        value = float(self.at[number])
        kind = "infinity" if self.far[number] else str(self.kinds[number])
        touching, at_border = "", label_of(self.p.model.contacts[0])
        if self.p.model.has_regimes:
            touching, at_border = (
                str(column[number]) for column in (self.turns.touching, self.turns.at_border)
            )
        error = float(self.error[number])
        return ModelEnd(value, kind, self._place(number), error, touching, at_border)
