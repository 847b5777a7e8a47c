"""A state of a model followed as one parameter moves slowly: where it goes, where it vanishes, and what it jumps to.

All folds along the parameter are known and proved beforehand. Between two of them a step is taken from one value to the next
only if boxes of states are proved to hold exactly one equilibrium for every value in between: two states in one such box lie on
one branch. The two that meet at a fold nearby differ in the sign of det K, which no branch changes between folds. A step that
is too wide for that is halved.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Result
from ..errors import ConvergenceError, ParameterError
from ..exact import boxes, certified_roots
from ..exact.interval_arrays import FloatArray, Intervals
from ..parameters import Range, as_numbers
from ..statics.solver import Stability
from .balance import Balance, Model
from .columns import Columns
from .conditions import Touch
from .equilibria import ModelEquilibria, columns, equilibria
from .folds import folds
from .points import ModelPoints, arranged, given_column, search
from .regions import region
from .stability import linearization

#: Distance from a fold, over its value if that is larger than 1, at which the states beside it are looked at.
BESIDE = 1e-3
#: How far beyond the border of the contact states on it are looked for.
OVER_BORDER = 1e-3
#: Times a step is halved.
HALVINGS = 40
#: Boxes looked at for one step, and their least width, before it is halved.
BUDGET, NARROW = 300, 2.0**-10
#: Values of the parameter at the beginning and the end of a step.
Step: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class ModelJump(Result):
    """A state that vanishes at a fold or leaves the contact, and the one that takes its place."""

    value: float  #: of the parameter, at the fold or on the border
    kind: str  #: ``"fold"``, or ``"border"`` where the state leaves the contact
    before: Mapping[str, float]  #: coordinates there
    after: Mapping[str, float]  #: coordinates there of the state that it jumps to
    stability_after: Stability
    error: float  #: bound on the error of ``value``


@dataclass(frozen=True)
class ModelEnd(Result):
    """Where a state vanishes at a fold or leaves the contact."""

    value: float  #: of the parameter, at the fold or on the border
    kind: str  #: ``"fold"``, or ``"border"`` where the state leaves the contact
    before: Mapping[str, float]  #: coordinates there
    error: float  #: bound on the error of ``value``


@dataclass(frozen=True, eq=False)
class ModelPath(Columns, held_in="coordinates"):
    """States along the values of the parameter, in the order in which they are passed, and the jumps between them."""

    vary: str
    values: FloatArray
    stability: NDArray[np.int8]
    jumps: tuple[ModelJump, ...]
    coordinates: Mapping[str, FloatArray] = field(repr=False)


#: Chooses among the slots of the equilibria behind a fold, given the coordinates of the fold: (eq, before) → slot.
Choice = Callable[[ModelEquilibria, Mapping[str, float]], int]


def quasi_static_path(
    model: Model, p: Any, vary: str, values: ArrayLike, *, start: int | str = "small", after_jump: Choice | None = None
) -> ModelPath:
    """Follow an equilibrium in contact as a parameter moves through ``values``, up or down, with its jumps.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; the parameter that varies is not used.
    vary : str
        Its name.
    values : array_like
        One axis, strictly increasing or strictly decreasing.
    start : "small", "large" or int
        Where to begin, at the first value: the stable equilibrium of smallest or largest first coordinate, by size, or a slot of
        ``model.equilibria``.
    after_jump : callable, optional
        Which equilibrium the system goes to after a jump: ``(eq, before) -> slot``. Without it the stable one that is nearest.

    Returns
    -------
    ModelPath

    Raises
    ------
    ConvergenceError
        Where folds or equilibria are not all decided, or nothing stable is left to jump to.

    Notes
    -----
    The rules are those of :func:`spragsym.quasi_static_path`. A value that is equal to a fold as ``model.folds`` gives it counts
    as the fold itself, not passed yet: the state on it is the one that arrives there, and the jump comes beyond it. If the first
    value is a fold, "small" and "large" choose among the states there, the one in which two equilibria meet included; then the
    path goes on with the stable one of those two, or jumps. At a pitchfork nothing jumps: where three equilibria become one, each
    goes on as that one; where one becomes three, the path goes on with the one of larger x, or whatever the mirror turns.
    """
    along = as_numbers("values", values)
    steps = np.diff(along) if along.ndim == 1 else np.zeros(1)
    if along.ndim != 1 or not along.size or not ((steps > 0).all() or (steps < 0).all()):
        raise ParameterError("values do not go one way; give one axis of one or more, strictly increasing or strictly decreasing")
    way = _Way(model, p, vary, along)
    place = way.begin(start)
    out = [way.state(0, place)]
    jumps = []
    for stop in range(1, way.stops.size):
        place, jump = way.moved(stop, place, after_jump)
        jumps += [jump] if jump else []
        if way.wanted[stop]:
            out.append(way.state(stop, place))
    coordinates = {name: np.array([state[0][i] for state in out]) for i, name in enumerate(way.balance.coordinates)}
    return ModelPath(vary, along, np.array([state[1] for state in out], dtype=np.int8), tuple(jumps), coordinates)


def first_end(model: Model, p: Any, vary: str, span: tuple[float, float], *, start: int | str = "small") -> ModelEnd | None:
    """Where a state that is followed from the first value of a span to the last one vanishes first; None if it does not.

    Arguments and errors as for :func:`quasi_static_path`; whether there is another state behind it is not asked.
    """
    way = _Way(model, p, vary, np.array(span))
    place = way.begin(start)
    for stop in range(1, way.stops.size):
        following = way.followed(stop, place)
        if following is None:
            return way.end(stop)
        place = following
    return None


#: Where two equilibria meet on a value, instead of the slot of one.
MET = -1


@dataclass(frozen=True)
class _States:
    """Equilibria at one value, shape (n, number), and the signs of det K."""

    q: FloatArray
    signs: FloatArray


class _Way:
    """Values and the stops beside each fold, the equilibria at all of them, and which of two neighbours lie on one branch."""

    def __init__(self, model: Model, p: Any, vary: str, along: FloatArray) -> None:
        self.model, self.vary, self.balance = model, vary, Balance(model, contact=True)
        self.p = p
        low, high = float(along.min()), float(along.max())
        self.ends_at = low, high
        # Folds on the ends are inside of what is searched.
        allowed: Range = p.ranges.get(vary, Range(-np.inf, np.inf))
        low = max(low - BESIDE * max(1.0, abs(low)), allowed.low)
        high = min(high + BESIDE * max(1.0, abs(high)), allowed.high)
        self.folds: ModelPoints = folds(model, p, vary, between={vary: (low, high)})
        if not self.folds.complete:
            raise ConvergenceError(
                f"folds along {vary} between {low:.17g} and {high:.17g} are not all decided; model.folds lists the boxes, and a "
                "path needs a range without them"
            )
        self.ends = [self.folds, *self._touches((low, high))]
        self.at, self.kinds = self._column(vary), self._column("kind")
        self.stops, self.wanted = self._stops(along)
        self.eq = equilibria(model, p.replace(**{vary: self.stops}))
        if not self.eq.complete:
            first = self.stops[np.flatnonzero(~self.eq.decided)[0]]
            raise ConvergenceError(f"equilibria at {vary} = {first:.17g} are not all decided; leave that value out")
        self.links = self._links()

    def _column(self, name: str) -> NDArray[Any]:
        """A column of all points at which states vanish on the way."""
        at, column = (np.concatenate([getattr(points, key) for points in self.ends]) for key in (self.vary, name))
        chosen: NDArray[Any] = column[(at >= self.ends_at[0]) & (at <= self.ends_at[1])]
        return chosen

    def _touches(self, span: tuple[float, float]) -> list[ModelPoints]:
        """Where an equilibrium gets into contact or out of it."""
        if not self.balance.opens:
            return []
        beyond = Balance(self.model, contact=True)
        beyond.border = beyond.border + OVER_BORDER
        given = given_column(self.p, beyond.parameters, (self.vary,))
        found = search(beyond, (self.vary,), Touch(), given, np.array([span]))
        points = arranged(beyond, (self.vary,), given, found, np.full(found.roots.point.size, "border"))
        if not points.complete:
            raise ConvergenceError(f"whether equilibria leave the contact along {self.vary} is not decided; shorten the range")
        return [points]

    def _stops(self, along: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        """The values in their order, with a stop on each side of each fold."""
        beside = []
        for fold in self.at:
            others = np.abs(np.concatenate([along, self.at]) - fold)
            room = min(BESIDE * max(1.0, abs(fold)), 0.25 * float(others[others > 0].min()))
            beside += [fold - room, fold + room]
        low, high = along.min(), along.max()
        extra = np.array([value for value in beside if low < value < high])
        stops = np.concatenate([along, extra])
        wanted = np.concatenate([np.ones(along.size, dtype=np.bool_), np.zeros(extra.size, dtype=np.bool_)])
        order = np.argsort(stops)
        order = order if along[-1] > along[0] else order[::-1]
        return stops[order], wanted[order]

    def _links(self) -> list[dict[int, int]]:
        """For each step and each slot at its beginning, the slot at its end that lies on the same branch, where there is one."""
        states = {float(value): self._states(self.eq, stop) for stop, value in enumerate(self.stops)}
        steps = list(itertools.pairwise(map(float, self.stops)))
        proved: dict[Step, dict[int, int]] = {}
        halved: dict[Step, float] = {}
        pending = steps
        for _ in range(HALVINGS if steps else 0):
            found = self._by_boxes(pending, states)
            proved |= found
            failed = [step for step in pending if step not in found]
            if not failed:
                return [_joined(step, proved, halved) for step in steps]
            # Not in the middle, where the fold is.
            middles = {step: step[0] + 0.47 * (step[1] - step[0]) for step in failed}
            halved |= middles
            eq = equilibria(self.model, self.p.replace(**{self.vary: np.array(list(middles.values()))}))
            states |= {middle: self._states(eq, k) for k, middle in enumerate(middles.values())}
            pending = [part for (one, two), middle in middles.items() for part in ((one, middle), (middle, two))]
        if not steps:
            return []
        raise ConvergenceError(
            f"branches between {self.vary} = {pending[0][0]:.17g} and {pending[0][1]:.17g} can't be told apart"
        )

    def _states(self, eq: ModelEquilibria, stop: int) -> _States:
        """Equilibria at a stop."""
        count = int(eq.count[stop])
        q = np.array([eq.coordinates[name][stop, :count] for name in self.balance.coordinates])
        given = np.repeat(columns(eq.parameters, self.balance.parameters)[:, stop : stop + 1], count, axis=1)
        K = linearization(self.balance, q, given)[2] if count else np.zeros((1, 1, 0))
        return _States(q, np.sign(np.linalg.det(np.moveaxis(K, -1, 0))))

    def _by_boxes(self, steps: list[Step], states: Mapping[float, _States]) -> dict[Step, dict[int, int]]:
        """Pairs of slots in boxes that hold exactly one equilibrium for each value of a step, where that is so for all states.

        Over a fold only for those that go through.
        """
        low, high = (
            columns(self.p.replace(**{self.vary: np.array([extreme(step) for step in steps])}), self.balance.parameters)
            for extreme in (min, max)
        )
        around, _ = region(self.balance, Intervals.between(low, high))
        outcome = boxes.search(self.balance, around, low, high, limits=self.balance.limits, budget=BUDGET, narrow=NARROW)
        roots = certified_roots.roots(self.balance, outcome, around, low, high)
        done = {}
        for k, (one, two) in enumerate(steps):
            begin, end = states[one].q, states[two].q
            pairs = {}
            for box in np.flatnonzero(roots.point == k):
                slots = [np.flatnonzero(_holds(roots.alone[:, :, box], part)) for part in (begin, end)]
                if slots[0].size == slots[1].size == 1:
                    pairs[int(slots[0][0])] = int(slots[1][0])
            if self._complete(pairs, (one, two), states[one], states[two]):
                done[one, two] = pairs
        return done

    def _complete(self, pairs: dict[int, int], step: Step, begin: _States, end: _States) -> bool:
        """Whether all pairs of a step are known, after those are entered that signs or the mirror tell."""
        within = (self.at >= min(step)) & (self.at <= max(step))
        counts = int(begin.q.shape[1]), int(end.q.shape[1])
        mirrored = bool((self.kinds == "pitchfork").any() and (self.kinds[within] == "pitchfork").all())
        if mirrored and (bool(within.any()) or counts[0] == counts[1] == len(pairs) + 3):
            return self._across_pitchfork(pairs, begin, end)
        # A fold that is a value of the path itself lies on the one side of that float or on the other, as the counts tell.
        over_fold = bool(((self.at > min(step)) & (self.at < max(step))).any()) or (bool(within.any()) and counts[0] != counts[1])
        if over_fold:
            return len(pairs) == min(counts)
        pairs |= _by_sign(pairs, begin.signs, end.signs)
        return len(pairs) == counts[0] == counts[1]

    def _across_pitchfork(self, pairs: dict[int, int], begin: _States, end: _States) -> bool:
        """Pairs of the states that meet at a pitchfork: none crosses the mirror; of three that begin there the upper goes on."""
        turned = self.balance.coordinates.index(self.balance.model.about["mirror"]["turned"][0])
        one = [k for k in range(begin.q.shape[1]) if k not in pairs]
        two = [k for k in range(end.q.shape[1]) if k not in pairs.values()]
        one.sort(key=lambda k: float(begin.q[turned, k]))
        two.sort(key=lambda k: float(end.q[turned, k]))
        if not {len(one), len(two)} <= {1, 3}:
            return not one and not two
        pairs |= dict(zip(one, two, strict=True)) if len(one) == len(two) else dict.fromkeys(one, two[-1])
        return True

    def begin(self, start: int | str) -> int:
        """The slot at the first value."""
        count = int(self.eq.count[0])
        if not isinstance(start, str):
            if isinstance(start, bool) or not 0 <= start < count:
                raise ParameterError(f"start = {start!r}: the first value has {count} equilibria, slots 0 to {count - 1}")
            return int(start)
        if start not in ("small", "large"):
            raise ParameterError(f"start = {start!r}; give 'small', 'large' or the slot of an equilibrium")
        stable = [slot for slot in range(count) if self.eq.stability[0, slot] == Stability.STABLE] or list(range(count))
        met = self._met(0)
        if met is not None and self.links and count == len(self.links[0]):
            # The float of the fold lies just beyond the states that meet there.
            stable = [MET, *stable] if self._stability_met(met) == Stability.STABLE else (stable or [MET])
        if not stable:
            raise ParameterError(f"the first value, {self.vary} = {self.stops[0]:.17g}, has no equilibrium in contact")
        return (min if start == "small" else max)(stable, key=lambda slot: abs(self.state(0, slot)[0][0]))

    def _met(self, stop: int) -> int | None:
        """The number of the fold or border that a stop is equal to."""
        here = np.flatnonzero((self.at == self.stops[stop]) & (self.kinds != "pitchfork"))
        return int(here[0]) if here.size else None

    def _stability_met(self, number: int) -> int:
        """Where one λ is 0 the others decide."""
        q = np.array([[float(self._column(name)[number])] for name in self.balance.coordinates])
        given = columns(self.p.replace(**{self.vary: self.at[number : number + 1]}), self.balance.parameters)
        M, _, K = (part[:, :, 0] for part in linearization(self.balance, q, given))
        squares = np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)
        others = np.delete(squares, np.abs(squares).argmin())
        if (np.abs(others.imag) > 1e-13 * np.abs(others).max(initial=0.0)).any():
            return int(Stability.FLUTTER)
        return int(Stability.STABLE if (others.real > 0).all() else Stability.DIVERGENT)

    def moved(self, stop: int, place: int, choose: Choice | None) -> tuple[int, ModelJump | None]:
        """The slot at a stop of the state that was in a slot at the one before, with the jump if it vanishes on the way."""
        following = self.followed(stop, place)
        return self.jump(stop, choose) if following is None else (following, None)

    def followed(self, stop: int, place: int) -> int | None:
        """The slot at a stop of the state that was in a slot at the one before; None if it vanishes on the way."""
        links = self.links[stop - 1]
        if place == MET:
            begun = [slot for slot in range(int(self.eq.count[stop])) if slot not in links.values()]
            stable = [slot for slot in begun if self.eq.stability[stop, slot] == Stability.STABLE]
            return stable[0] if stable else None
        if place in links:
            return links[place]
        return MET if self._met(stop) is not None else None

    def state(self, stop: int, slot: int) -> tuple[list[float], int]:
        """Coordinates and stability."""
        if slot == MET:
            number = self._met(stop)
            assert number is not None  # MET is returned where there is one
            return [float(self._column(name)[number]) for name in self.balance.coordinates], self._stability_met(number)
        values = [float(self.eq.coordinates[name][stop, slot]) for name in self.balance.coordinates]
        return values, int(self.eq.stability[stop, slot])

    def jump(self, stop: int, choose: Choice | None) -> tuple[int, ModelJump]:
        """The slot behind the fold that ends the branch."""
        end = self.end(stop)
        before = end.before
        eq = equilibria(self.model, self.p.replace(**{self.vary: float(self.stops[stop])}))
        count = int(eq.count)
        if choose is None:
            stable = [slot for slot in range(count) if eq.stability[slot] == Stability.STABLE]
            if not stable:
                raise ConvergenceError(f"nothing stable is left at {self.vary} = {end.value:.17g}; give after_jump")
            slot = min(stable, key=lambda k: sum((float(eq.coordinates[name][k]) - before[name]) ** 2 for name in before))
        else:
            slot = choose(eq, before)
            if not 0 <= slot < count:
                raise ParameterError(f"after_jump returned {slot!r}; there are {count} equilibria, slots 0 to {count - 1}")
        behind = np.array([float(eq.coordinates[name][slot]) for name in before])
        after = dict(zip(before, self._at_end(end, behind), strict=True))
        kind = Stability(int(eq.stability[slot]))
        return slot, ModelJump(end.value, end.kind, before, after, kind, end.error)

    def _at_end(self, end: ModelEnd, behind: FloatArray) -> list[float]:
        """Coordinates at the end of a branch of the state that has these at the stop behind it."""
        eq = equilibria(self.model, self.p.replace(**{self.vary: end.value}))
        states = np.array([eq.coordinates[name][: int(eq.count)] for name in end.before])
        if not eq.complete or not states.size:
            return [float(value) for value in behind]
        nearest = np.linalg.norm(states - behind[:, None], axis=0).argmin()
        return [float(value) for value in states[:, nearest]]

    def end(self, stop: int) -> ModelEnd:
        """The fold or border on this side of a stop, where a branch ends."""
        number = int(np.abs(self.at - self.stops[stop]).argmin())
        before = {name: float(self._column(name)[number]) for name in self.balance.coordinates}
        error, kind = float(self._column("error")[number]), str(self._column("kind")[number])
        return ModelEnd(float(self.at[number]), kind, before, error)


def _by_sign(pairs: Mapping[int, int], begin: FloatArray, end: FloatArray) -> dict[int, int]:
    """Pairs of slots that boxes do not tell apart: between folds no branch changes the sign of its det K, so one of each does."""
    left = [[k for k in range(signs.size) if k not in taken] for signs, taken in ((begin, pairs.keys()), (end, pairs.values()))]
    if not len(left[0]) == len(left[1]) <= 2:
        return {}
    places = [{signs[k]: k for k in part} for signs, part in zip((begin, end), left, strict=True)]
    if any(len(place) != len(left[0]) for place in places) or places[0].keys() != places[1].keys():
        return {}
    return {places[0][sign]: places[1][sign] for sign in places[0]}


def _joined(step: Step, proved: Mapping[Step, dict[int, int]], halved: Mapping[Step, float]) -> dict[int, int]:
    """The pairs of a step, through those of its halves."""
    if step in proved:
        return proved[step]
    middle = halved[step]
    first, second = (_joined(part, proved, halved) for part in ((step[0], middle), (middle, step[1])))
    return {slot: second[place] for slot, place in first.items() if place in second}


def _holds(box: FloatArray, states: FloatArray) -> NDArray[np.bool_]:
    """Which states, shape (n, number), lie in a box, shape (2, n)."""
    out: NDArray[np.bool_] = np.logical_and.reduce((-box[0][:, None] <= states) & (states <= box[1][:, None]))
    return out
