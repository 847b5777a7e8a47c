"""Quasi-static paths: a state followed as one parameter moves slowly, where it vanishes, and where
it jumps.

All points at which states vanish (folds, borders, escapes to infinity) are found and proved
beforehand. The values of the path and nodes beside these points form a mesh. From one node to the
next a step goes only to the state that is proved to lie on the same branch, see
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
from .borders import borders, reachable, touching_at
from .branches import clearly_nearest, linked
from .defining_systems import Family, given_column
from .folds import folds
from .options import ContinuationOptions
from .points import escapes, together, which
from .singularities import ended
from .tubes import Place, Tubes
from .turning_points import limit_points


def _size(values: FloatArray, along: FloatArray) -> FloatArray:
    """|value|, but at least 1, or the largest value of the path if that is less.

    Distances in the parameter are relative to it, so that paths in any units are alike.
    """
    largest = float(np.abs(along).max()) or 1.0
    return np.maximum(min(1.0, largest), np.abs(values))


@dataclass(frozen=True)
class ModelEnd(Result):
    """The end of a followed state: at a fold, at the border of a contact, or at infinity."""

    value: float  #: of the parameter, at the fold, on the border or in the limit
    #: ``"fold"``, ``"pitchfork"``, ``"border"`` (leaves the contact), ``"border_fold"`` (one of
    #: several contacts is lost or regained) or ``"infinity"``
    kind: str
    before: Mapping[str, float]  #: coordinates there
    error: float  #: bound on the error of ``value``
    touching: str = ""  #: touching contacts before the end, if there are several
    at_border: str = ""  #: the contact that is lost or regained, if one is


#: Chooses the state after a jump: (equilibria beyond the fold, coordinates of the fold) → slot.
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
    """Follow an equilibrium in contact as a parameter moves through ``values``, with its jumps.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the value of the parameter that varies is not used.
    vary : str
        Name of the parameter.
    values : array_like
        One axis, strictly increasing or strictly decreasing.
    start : "small", "large" or int
        The state at the first value. ``"small"`` is the reference state, see
        :mod:`spragsym.statics.reference_state`, or the state chosen by ``p.following(…)``;
        ``"large"`` is the stable equilibrium of largest |first coordinate|; an int is a slot of
        :func:`spragsym.equilibria`.
    after_jump : callable, optional
        Chooses the equilibrium after a jump: ``(eq, before) -> slot``. By default the nearest
        stable one, or the only one that is left; from infinity, where none is nearest, the path
        ends. :func:`spragsym.simulate` shows whether the motion settles there or on a limit cycle.
    options : ContinuationOptions, optional
        Tolerances and limits of the continuation, and of the search that it uses.
    method : {"auto", "closed", "search"}
        A closed form if the model has one for these arguments and else the search; only the closed
        form; or only the search.

    Returns
    -------
    Path
        With the values that are reached. If the state runs to infinity, and there is no
        ``after_jump`` or no state is left, the path ends. Its last entry of ``jumps`` then has the
        kind ``"infinity"``, an empty ``after``, and ``undamped_after`` None.

    Raises
    ------
    ParameterError
        For values that are not monotonic or out of range, or a ``start`` without an equilibrium.
    ConvergenceError
        If folds or equilibria are not all decided, or no stable state is left to jump to.

    Notes
    -----
    Source: article, Figures 6 and 13; all folds along the parameter, see :func:`spragsym.folds`,
    and which states lie on one branch, see :mod:`spragsym.bifurcation.branches`.

    A value within the ``error`` of a fold of ``folds``, or equal to its float if that error is
    rounding only, counts as the fold itself, not passed yet: the state there is the one that
    arrives, and the jump comes after it. If the first value is a fold, "small" and "large" choose
    among the states there, with the one in which two equilibria meet; the path goes on with the
    stable one of those two, or jumps.

    At a pitchfork where three equilibria become a stable one, each of them goes on as that one.
    Where a stable one becomes three, of which two are stable, the path goes on with that of larger
    x, or of the coordinate whose sign the mirror changes. Where only the middle one of three is
    stable, it ends at the pitchfork, and the path jumps.

    With several contacts, a state goes on where it passes from one combination of touching contacts
    into another, and jumps at a border fold, see :mod:`spragsym.bifurcation.borders`; a state on
    the border itself counts as touching. Of states that are equally small, or equally near, the one
    of larger coordinates is taken.

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
            # From infinity no state is the nearest: only after_jump can choose.
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
    """The first end of the state that is followed over a span of the parameter; None if it does not
    end.

    Arguments and errors are those of :func:`quasi_static_path`. Whether there is a state beyond the
    end is not asked.
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
    # A search does not tell a root on an end of its range, as a load from 0 has it where a domain
    # ends.
    for ends in (np.array([span]), _widened(p.ranges[vary], span)):
        found = borders([replace(family, spans=ends) for family in families], leaving=True)
        if all(points.decided for points in found):
            break
    else:
        raise ConvergenceError(
            f"whether equilibria leave the contact along {vary} is not decided; shorten the range, "
            "or change another parameter where a contact just touches at every value"
        )
    if not (
        turns.whole and np.isfinite(turns.region).all()
    ):  # states run to infinity only where nothing bounds them
        found += map(escapes, families)
    return found


def _widened(allowed: Range, span: Span) -> FloatArray:
    """The span, extended a little where it ends at an end of the allowed range."""
    low, high = span
    margin = 1e-3 * (high - low)
    ends = [
        low - margin if low == allowed.low else low,
        high + margin if high == allowed.high else high,
    ]
    return np.array([ends])


class QuasiStaticContinuation:
    """A mesh of values of one parameter, the equilibria at its nodes, and which of them lie on one
    branch.

    A location of the followed state is the slot of an equilibrium at a node, or ``~number`` for the
    point of that number at which the state has vanished. If such a point is a fold and the node
    itself, the path may go on from the state in which two equilibria meet.
    """

    def __init__(
        self,
        p: ParameterSet,
        vary: str,
        along: FloatArray,
        options: ContinuationOptions | None = None,
    ) -> None:
        self.options = options or ContinuationOptions()
        self.search = self.options.given_search
        #: The balance of every combination of touching contacts, by their names.
        self.balances = {one.touching: one for one in balances_of(p.model, options=self.search)}
        self.p, self.vary, self.balance = p, vary, next(iter(self.balances.values()))
        p.model.require_parameter(vary)
        try:
            ends = self._ends(along, self.options.fold_distance)
        except ConvergenceError:  # points beyond the values do not matter
            ends = self._ends(along, 1e-6)
        every = self._turns_within(along, ends)
        #: Points at which states vanish, and points at which they pass from one combination of
        #: touching contacts into another.
        self.turns = every.select(every.kind != "passes")
        self.passes = every.select(every.kind == "passes")
        self.at, self.kinds = self.turns[vary], self.turns.kind
        #: Coordinates of the points at which states vanish, shape (n, numbers).
        self.q = np.array([self.turns[name] for name in self.balance.coordinates])
        self.error = self.turns.error * scale_of(self.at)
        self.far = np.char.startswith(self.kinds.astype(str), "infinity")
        self.mesh = self._mesh(along)
        self.eq = self._with_meetings(self._equilibria(self.mesh))
        #: All pairs of slots of one step, while ``joined`` has those found without halving steps.
        self._links = functools.cache(self._linked)
        self.joined = self._in_combinations()

    def _equilibria(self, values: ArrayLike) -> Equilibria:
        """All equilibria at values of the parameter."""
        return equilibria(self.p.replace(**{self.vary: values}), options=self.search)

    def _in_combinations(self, only: int | None = None) -> list[dict[int, int]]:
        """Pairs of slots on one branch in which no contact is lost or regained, for each step.

        With ``only``, the number of one step, all pairs of that step.
        """
        found = list[dict[int, int]]()
        options = replace(self.options, halvings=0) if only is None else self.options
        for touching, balance in self.balances.items():
            eq, slots = combination_of(self.eq, touching, balance.contact)
            turns = together([self.turns, self.passes]) if len(self.balances) > 1 else self.turns
            turns = turns.select(reachable(turns, balance))
            pairs = linked(self.p, self.vary, eq, turns, only=only, options=options)
            found = found or [{} for _ in pairs]
            for step, (every, part) in enumerate(zip(found, pairs, strict=True), only or 0):
                every |= {slots[step][a]: slots[step + 1][b] for a, b in part.items()}
        return found

    def _linked(self, step: int) -> dict[int, int]:
        """All pairs of slots of a step on one branch, with states that pass from one combination of
        touching contacts into another.
        """
        (found,) = self._in_combinations(step)
        low, high = sorted(self.mesh[step : step + 2])
        passed = self.passes.select(
            (self.passes[self.vary] >= low) & (self.passes[self.vary] <= high)
        )
        if not len(passed):
            return found
        ends = self.turns.select((self.at >= low) & (self.at <= high))
        before, after = (range(int(count)) for count in self.eq.count[step : step + 2])
        gone = [slot for slot in before if slot not in found]
        begun = [slot for slot in after if slot not in found.values()]
        if len(passed) > 1 or len(ends) or len(gone) != 1 or len(begun) != 1:
            raise ConvergenceError(
                f"which states pass between {self.vary} = {low:.17g} and {high:.17g}, where a "
                "contact is lost or regained, is not told apart"
            )
        return found | {gone[0]: begun[0]}

    def _balance(self, node: int, slot: int) -> Balance:
        """The balance of the combination of touching contacts in a state."""
        if len(self.balances) == 1:
            return self.balance
        return self.balances[str(self.eq["touching"][node, slot])]

    def _with_meetings(self, eq: Equilibria) -> Equilibria:
        """The equilibria with nodes decided that lie on points where states meet and digits do not
        decide.

        At a pitchfork the state in which three meet is added; the state in which two meet at a fold
        has no slot. That there is no other state follows once all states beside the node are joined
        to those on it.
        """
        for node in np.flatnonzero(~eq.decided).tolist():
            here = np.flatnonzero((self.at == self.mesh[node]) & ~self.far)
            states = self.q[:, here].T
            distance = self.options.fold_distance * scale_of(states)
            boxes = [box for box in eq.undecided if box.index == (node,)]
            inside = [
                (states - box.low <= distance) & (box.high - states <= distance) for box in boxes
            ]
            near = np.array([mask.all(axis=-1) for mask in inside])
            if not near.any(axis=-1).all():
                continue
            eq = as_decided(eq, node)
            for number in here.tolist():
                if self.kinds[number] == "pitchfork" and near[:, here == number].any():
                    place, stability = self._place(number), self._stability_met(number)
                    error = float(self.turns.error[number])
                    eq = with_state(eq, node, place, stability, error)
        return eq

    def _ends(self, along: FloatArray, beyond: float) -> list[Points]:
        """All points at which states vanish or pass, along the values and a little beyond both
        ends.
        """
        allowed, margin = self.p.ranges[self.vary], beyond * _size(along, along)
        low = max(float((along - margin).min()), allowed.low)
        high = min(float((along + margin).max()), allowed.high)
        found = folds(self.p, self.vary, between={self.vary: (low, high)}, options=self.search)
        if not found.decided:
            text = "folds with {} are not all decided; ss.folds lists the boxes, and a path needs "
            at = At(self.vary, (low, high))
            raise ConvergenceError(Remark(f"{text}a range without them", at))
        return [found, *border_ends(self.p, self.vary, (low, high), found, options=self.search)]

    def _turns_within(self, along: FloatArray, ends: list[Points]) -> Points:
        """The points within the range of the values, with values that coincide within their errors
        made equal.

        Twins by a mirror coincide, but each search rounds differently. A point that coincides with
        a value of the path gets that value.
        """

        def every(name: str) -> NDArray[Any]:
            return np.concatenate([points[name] for points in ends])

        at, error = every(self.vary), np.concatenate([points.error for points in ends])
        wide = error * scale_of(at)
        order = np.argsort(at)
        begins = np.diff(at[order], prepend=-np.inf) > wide[order] + np.roll(wide[order], 1)
        at[order] = at[order][np.maximum.accumulate(np.where(begins, np.arange(at.size), 0))]
        off = np.abs(at[:, None] - along)
        # A point whose error is rounding only coincides with its own float alone, unless it may
        # be 0.
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
        """The values in their order, with a node on each side of each point."""
        at = np.concatenate([self.at, self.passes[self.vary]])
        values, size = np.concatenate([along, at]), _size(at, along)
        apart = np.abs(values - at[:, None])
        # No node fits between a point and a value this near: nodes are then beyond both.
        apart = np.where(apart > 4 * EPS * size[:, None], apart, np.inf)
        nearest = apart.min(axis=1, initial=np.inf)
        distance = np.minimum(self.options.fold_distance * size, 0.25 * nearest)
        beside = np.concatenate([at - distance, at + distance])
        # A node equal to a value, for lack of floats in between, is none.
        new = (along.min() < beside) & (beside < along.max()) & ~np.isin(beside, values)
        mesh = np.sort(np.concatenate([along, beside[new]]))
        return mesh if along[-1] > along[0] else mesh[::-1]

    def _require_decided(self, node: int) -> None:
        """Raise ConvergenceError unless the equilibria at a node are decided; called for reached
        nodes only.
        """
        if not self.eq.decided[node]:
            text = "equilibria at {} are not all decided; leave that value out, or end before it"
            at = At(self.vary, (float(self.mesh[node]),))
            raise ConvergenceError(Remark(text, at))

    def begin(self, start: int | str) -> int:
        """The location at the first value."""
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
        met = [number for number in self._met(0) if not self._has_slot(0, number)]
        if met and (self.mesh.size == 1 or count == len(self._links(0))):
            # Two states meet in a fold at the first value, and its float is just beyond both.
            firm = [
                ~number for number in met if self._stability_met(number) == EquilibriumType.STABLE
            ]
            stable = [*firm, *stable] or [~number for number in met]
        if not stable:
            allowed, first = self.p.ranges[self.vary], float(self.mesh[0])
            at = f"the first value, {self.vary} = {first!r},"
            if first == allowed.reached(allowed.low):
                at = f"the lower end of {self.vary}"
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
        """Numbers of the folds and borders at a node."""
        return np.flatnonzero(
            (self.at == self.mesh[node]) & (self.kinds != "pitchfork") & ~self.far
        ).tolist()

    def _has_slot(self, node: int, number: int) -> bool:
        """Whether a state on a border is one of the equilibria at a node, as of a contact that just
        touches without load.
        """
        border = str(self.kinds[number]).startswith("border")
        states = np.array([self.eq[name][node] for name in self.balance.coordinates])
        error = self.eq.error[node] + self.turns.error[number]
        near = np.abs(states - self.q[:, [number]]) <= error * scale_of(states)
        return border and bool(near.all(axis=0).any())

    def _stability_met(self, number: int) -> int:
        """Type of the state at the point of that number; one λ is 0, and the others decide."""
        given = columns(
            self.p.replace(**{self.vary: self.at[number : number + 1]}), self.balance.parameters
        )
        contact = touching_at(self.turns, number)
        return with_a_zero(Balance(self.p.model, contact), self.q[:, [number]], given)

    def followed(self, node: int, location: int) -> int:
        """The location at a node of the state that had this location at the node before."""
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
        """The number of the point at which a state vanishes on its way to a neighbouring node."""
        number = self._limit_point(node, slot, goal)
        return self._ending(node, slot, goal) if number is None else number

    def moved(self, node: int, slot: int, goal: int) -> FloatArray:
        """The displacement of a state from its node to another; periodic angles are continuous."""
        tubes, start = self._standing(self._balance(node, slot), node, slot)
        reached = tubes.followed(start, self.mesh[[goal]])
        if not reached.proved[0] or reached.v[0] != self.mesh[goal]:
            raise ConvergenceError(
                f"how the state moves from {self.vary} = {self.mesh[node]:.17g} on is not proved"
            )
        return (reached.z - start.z)[:-1, 0]

    def ended(self, node: int, location: int) -> bool:
        """Whether a state has vanished before a node, and does not go on from a fold at it."""
        return location < 0 and ~location not in self._met(node)

    def _begun(self, node: int, location: int) -> int:
        """The stable one of the two states that begin at a fold, at the next node; the location of
        the fold if they lie on its other side.
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
        """Numbers of the points between two nodes, or on them, at which states may vanish."""
        low, high = sorted((self.mesh[node], self.mesh[other]))
        return np.flatnonzero((self.at >= low - self.error) & (self.at <= high + self.error))

    def _limit_point(self, node: int, slot: int, goal: int) -> int | None:
        """The number of the fold at which a state is proved to turn back on its way to another
        node.

        None if that is not proved, or if there is only one candidate point.
        """
        points = self._candidates(node, goal)
        here = points[self.kinds[points] == "fold"]
        if points.size < 2 or not here.size:
            return None
        tubes, start = self._standing(self._balance(node, slot), node, slot)
        if here.size > 1 and (self.at[here] == self.mesh[node]).all():
            # At the float of the folds two states still exist, too near to each other for a tube.
            near = clearly_nearest(start.z[: tubes.n], self.q[:, here])[0]
            return int(here[near]) if near >= 0 else None
        forward = 1 if self.mesh[goal] > self.mesh[node] else -1
        found = limit_points(tubes, start, forward)
        if not found.proved[0]:
            return None
        distance = np.abs(np.vstack([self.q, self.at])[:, here] - found.z) / scale_of(found.z)
        distance = distance.max(axis=0)
        nearest = int(distance.argmin())
        return int(here[nearest]) if distance[nearest] <= 1e-6 else None

    def _standing(self, balance: Balance, node: int, slot: int) -> tuple[Tubes, Place]:
        """Tubes along the parameter, and their place at a state."""
        given = given_column(self.p, balance.parameters, (self.vary,))
        tubes = Tubes.of_points(balance, self.vary, given, options=self.options)
        *q, _, error = self.state(node, slot)
        return tubes, tubes.place(np.array([*q, self.mesh[node]])[:, None], error=error)

    def _place(self, number: int, names: Sequence[str] = ()) -> dict[str, float]:
        """Coordinates, or other named columns, of the point of that number, by name."""
        return {name: float(self.turns[name][number]) for name in names or self.balance.coordinates}

    def _ending(self, node: int, location: int, goal: int) -> int:
        """The number of the point at which a state vanishes on its way from a node to the next one.

        Raises ConvergenceError if several points are possible.
        """
        here = self._candidates(node, goal)
        if here.size == 1:
            return int(here[0])
        own = self._balance(node, location).extended()
        for number in here[np.char.startswith(self.kinds[here].astype(str), "border")].tolist():
            tubes, start = self._standing(own, node, location)
            end = tubes.followed(start, self.at[[number]])
            same = np.abs(self.q[:, [number]] - end.z[: tubes.n]) <= end.radius[: tubes.n]
            if end.proved[0] and end.v[0] == self.at[number] and same.all():
                return int(number)
        others = here[(self.kinds[here] == "pitchfork") | self.far[here]]
        q = np.array([self.state(node, location)[:-2]]).T
        if others.size > 1 and self.far[others].all():  # several escapes: those in its direction
            infinite = self.q[:, others]
            others = others[(np.isnan(infinite) | (np.sign(q) == np.sign(infinite))).all(axis=0)]
        elif others.size > 1 and not self.far[others].any():
            near = clearly_nearest(q, self.q[:, others])
            others = others[near[near >= 0]]
        if others.size == 1:  # at a fold it would be proved to turn back
            return int(others[0])
        ends = f"{self.vary} = {float(self.mesh[node]):.17g} and {float(self.mesh[goal]):.17g}"
        raise ConvergenceError(
            f"where the state ends between {ends} is not told apart from {here.size} folds "
            "and borders there"
        )

    def state(self, node: int, slot: int) -> list[float]:
        """Coordinates, type by (27), and a bound on the error at a location."""
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
        """Name of the column of touching contacts, if the model has several combinations."""
        return (own_name(self.p.model, "touching"),) if self.p.model.has_regimes else ()

    def touching(self, node: int, slot: int) -> str:
        """Names of the touching contacts at a location; empty if the model has one combination."""
        if not self.contact_columns:
            return ""
        if slot < 0:
            return str(self.turns.touching[~slot])
        return str(self.eq.touching[node, slot])

    def jump(self, node: int, number: int, choose: Choice | None) -> tuple[int, Jump]:
        """The jump from the point of that number, and the slot at the node where it arrives."""
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
        beyond = {name: float(eq.coordinates[name][slot]) for name in before}
        kind = EquilibriumType(int(eq.undamped[slot]))
        # The state after the jump at the value of the end itself, if its equilibria are decided.
        at_end = self._equilibria(end.value)
        if at_end.decided and at_end.count:
            eq, slot = at_end, int(nearest_state(at_end, beyond))
        after = {name: float(eq[name][slot]) for name in eq.state_columns}
        state = self._place(number, eq.state_columns)
        found = Jump(end.value, end.kind, state, after, kind, end.error, end.touching)
        # Two searches at the node may list its states in different orders.
        return int(nearest_state(self.eq, beyond)[node]), found

    def escape(self, number: int) -> Jump:
        """The last jump of a path whose state runs to infinity, without a state after it."""
        end = self.end(number)
        state = self._place(number, self.eq.state_columns)
        return Jump(end.value, end.kind, state, {}, None, end.error, end.touching)

    def end(self, number: int) -> ModelEnd:
        """The point of that number, as the end of a state."""
        value = float(self.at[number])
        kind = "infinity" if self.far[number] else str(self.kinds[number])
        touching, at_border = "", label_of(self.p.model.contacts[0])
        if self.p.model.has_regimes:
            touching, at_border = (
                str(column[number]) for column in (self.turns.touching, self.turns.at_border)
            )
        error = float(self.error[number])
        return ModelEnd(value, kind, self._place(number), error, touching, at_border)
