"""Branch matching: which equilibria at two values of a parameter lie on one branch, proved by
tubes.

A tube holds one equilibrium for every value between the two, see :mod:`spragsym.bifurcation.tubes`.
Where tubes do not reach, two rules match the rest. Between folds no branch changes the sign of det
K, in which the two states that meet at a fold differ. No branch crosses the mirror, on whose sides
the outer two of the three states at a pitchfork lie. A step with pairs that are not known is
halved.
"""

import itertools
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ConvergenceError
from ..core.questions import question
from ..models.parameters import ParameterSet, Span
from ..numerics.arithmetic import determinant
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    matrix,
    quiet,
    rounded_outward,
    scale_of,
)
from ..numerics.vectors import state_difference
from ..results import Equilibria, Points
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.search import balance_of, columns
from ..statics.stability import linearization
from .defining_systems import given_column
from .options import ContinuationOptions
from .singularities import Mirror, mirrors_of
from .tubes import Place, Tubes


@dataclass(frozen=True)
class Along:
    """A model along one parameter, with the points at which states vanish.

    ``at`` are their values of the parameter, ``kinds`` their kinds, and ``q`` their coordinates,
    shape (n, number).
    """

    balance: Balance
    p: Any
    vary: str
    at: FloatArray
    kinds: NDArray[Any]
    q: FloatArray
    whole: bool = False  #: whether these points, and the states listed, are all there are


@dataclass(frozen=True)
class _States(ByColumn):
    """Equilibria at one value of the parameter, with properties that match them.

    ``q`` are the coordinates, (n, number), ``signs`` the signs of det K, and ``sides`` those of the
    mirror: 0 on it, or without one. ``proved`` says where the sign of det K is proved, which it is
    not at a fold.
    """

    q: FloatArray
    signs: FloatArray
    sides: FloatArray
    proved: BoolArray


def undecided_points(eq: Equilibria, vary: str, cuts: Span) -> FloatArray:
    """Ranges around undecided points, each up to its neighbours, shape (number, 2)."""
    stops = np.array([cuts[0], *eq.parameters[vary], cuts[1]])
    open_ = np.flatnonzero(~eq.decided)
    return np.stack([stops[open_], stops[open_ + 2]], axis=1)


def undecided_parts(found: Points | None, ends: Span) -> FloatArray:
    """Ranges of the parameter, between two ends, in which points may be missing, shape
    (number, 2).
    """
    if found is None or not len(found.undecided):
        return np.empty((0, 2))
    spans = found.undecided[:, -1]
    return np.clip(spans[(spans[:, 1] >= ends[0]) & (spans[:, 0] <= ends[1])], *ends)


@question
def linked(
    p: ParameterSet,
    vary: str,
    eq: Equilibria,
    turns: Points | None,
    *,
    only: int | None = None,
    options: ContinuationOptions | None = None,
) -> list[dict[int, int]]:
    """For each step between two values of the parameter, the slots at its end by the slots at its
    beginning, for states on one branch.

    ``turns`` are all points along the parameter at which states vanish, or None in lift-off, where
    there are none. A step whose pairs are not all known is halved, as often as the options say;
    what remains unknown is left out. With ``only``, the number of one step, an incomplete answer
    raises ConvergenceError.
    """
    at, kinds, q = np.empty(0), np.empty(0, dtype=str), np.empty((0, 0))
    if turns is not None:
        at = turns[vary]
        kinds = turns.kind
        q = np.array([turns[name] for name in p.model.coordinates])
    whole = bool(eq.whole.all()) and (turns is None or turns.whole)
    along = Along(balance_of(p.model, eq.contact), p, vary, at, kinds, q, whole)
    stops = eq.parameters[vary].tolist()
    steps = list(itertools.pairwise(stops))[slice(only, None if only is None else only + 1)]
    given = columns(eq.parameters, along.balance.parameters)
    ends = Intervals.between(given.min(axis=1, keepdims=True), given.max(axis=1, keepdims=True))
    mirror, *_ = [*mirrors_of(along.balance, ends), None]
    states, pairs = _states(along, eq, mirror), dict[Span, dict[int, int]]()
    open_, halved = steps, list[tuple[Span, float]]()
    options = options or ContinuationOptions()
    for halvings in range(options.halvings + 1):
        more, complete = _by_tubes(along, open_, states, options)
        pairs |= more
        failed = [step for step in open_ if step not in complete]
        abandoned = len(failed) > options.open_steps or halvings == options.halvings
        if failed and abandoned and only is not None:
            known = f"not all are known: {'; '.join(eq.remarks)}"
            remedy = f"ask for the folds along {vary} with a larger region, within=…"
            why = "" if eq.whole.all() else f"; {known}; {remedy}"
            one, two = open_[0]
            raise ConvergenceError(
                f"branches between {vary} = {one:.17g} and {two:.17g} can't be told apart{why}"
            )
        if not failed or abandoned:
            break
        # Halving would put a fold in the middle of a range on a value.
        middles = [one + 0.47 * (two - one) for one, two in failed]
        at_middles = equilibria(p.replace(**{vary: np.array(middles)}), eq.contact)
        states |= _states(along, at_middles, mirror)
        halved += zip(failed, middles, strict=True)
        open_ = [
            ends
            for (one, two), middle in zip(failed, middles, strict=True)
            for ends in ((one, middle), (middle, two))
        ]
    for (one, two), middle in reversed(halved):
        second = pairs[middle, two]
        pairs[one, two] = {
            slot: second[at_middle]
            for slot, at_middle in pairs[one, middle].items()
            if at_middle in second
        }
    return [pairs[step] for step in steps]


def _states(along: Along, eq: Equilibria, mirror: Mirror | None = None) -> dict[float, _States]:
    """The equilibria by value of the parameter."""
    balance, (point, slot) = along.balance, eq.states
    q = np.array([eq.coordinates[name][point, slot] for name in balance.coordinates])
    given = columns(eq.parameters, balance.parameters)[:, point]
    K, sides = linearization(balance, q, given)[2], np.zeros(point.size)
    off = rounded_outward(eq.error[point, slot] * scale_of(q))
    with quiet():
        boxes = Intervals(rounded_outward(ends_around(q, off)))
        at = balance.state(boxes, balance.prepared_at(given))
        proved = determinant([list(row) for row in matrix(at.stiffness(), at.shape)]).signs
    if mirror is not None:
        image = mirror.image(list(q), balance.floats(given))
        across = (q - np.array(np.broadcast_arrays(*image)))[mirror.odd[0]]
        off_mirror = np.abs(across) > 4 * eq.error[point, slot]
        sides = np.where(off_mirror, np.sign(across), 0.0)
    values = eq.parameters[along.vary].tolist()
    signs = np.sign(np.linalg.det(K))
    found = _States(q, signs, sides, (signs != 0) & (proved == signs))
    return {value: found[point == number] for number, value in enumerate(values)}


def _by_tubes(
    along: Along, steps: list[Span], states: Mapping[float, _States], options: ContinuationOptions
) -> tuple[dict[Span, dict[int, int]], set[Span]]:
    """Pairs of slots on one branch, by step, and the steps whose pairs are all known.

    Tubes of a complete step are not followed to its end, since those left over end at the fold.
    """
    n = along.balance.n
    begun = [(one, two, slot) for one, two in steps for slot in range(states[one].signs.size)]
    given = given_column(along.p, along.balance.parameters, (along.vary,))
    columns = np.repeat(given, len(begun), axis=1)
    tubes = Tubes.of_points(along.balance, along.vary, columns, options=options)
    z = np.array([[*states[one].q[:, slot], one] for one, _, slot in begun]).reshape(-1, n + 1).T
    goal = np.array([two for _, two, _ in begun])
    start = tubes.place(z, error=0.0)

    def joined(there: Place) -> dict[Span, dict[int, int]]:
        links = {step: dict[int, int]() for step in steps}
        for column in np.flatnonzero(there.proved & (there.v == goal)):
            one, two, slot = begun[column]
            # An angle that goes around is listed once, within one turn.
            away = np.abs(
                state_difference(states[two].q.T, there.z[:n, column], along.balance.periodic)
            )
            slots = np.flatnonzero((away <= there.radius[:n, column]).all(axis=1))
            if slots.size == 1:
                links[one, two][slot] = int(slots[0])
        return links

    def completed(links: dict[Span, dict[int, int]]) -> set[Span]:
        return {
            (one, two)
            for (one, two), pairs in links.items()
            if _complete(along, pairs, (one, two), states[one], states[two])
        }

    def needless(reached: Place) -> BoolArray:
        """Tubes of steps of which all pairs are known without them: by tubes alone where states
        may be missing, or signs are not proved.
        """
        links = joined(reached)
        by_tubes = {step: len(pairs) for step, pairs in links.items()}
        complete = {
            (one, two)
            for one, two in completed(links)
            if (along.whole and states[one].proved.all() and states[two].proved.all())
            or by_tubes[one, two] == min(states[end].signs.size for end in (one, two))
        }
        complete = {step for step in complete if "pitchfork" not in _kinds_within(along, step)}
        return np.array([(one, two) in complete for one, two, _ in begun], dtype=bool)

    links = joined(tubes.followed(start, goal, needless=needless))
    return links, completed(links)


def _within(along: Along, step: Span) -> BoolArray:
    """Mask of the points between the two values of a step, ends included."""
    return (along.at >= min(step)) & (along.at <= max(step))


def _kinds_within(along: Along, step: Span) -> NDArray[np.str_]:
    """Kinds of the points within a step."""
    return along.kinds[_within(along, step)].astype(str)


def _complete(
    along: Along, pairs: dict[int, int], step: Span, begin: _States, end: _States
) -> bool:
    """Whether all pairs of a step are known; those that det K or the mirror tell are added
    first.
    """
    within = _within(along, step)
    kinds, counts = _kinds_within(along, step), (begin.signs.size, end.signs.size)
    if kinds.size and (kinds == "pitchfork").all():
        return _across_pitchforks(
            along.q[:, within], pairs, begin, end, [value in along.at for value in step]
        )
    if kinds.size and np.char.startswith(kinds, "infinity").all():
        above = np.char.endswith(kinds, "up")
        gone = int((above == (step[0] > step[1])).sum())
        return len(pairs) == counts[0] - gone == counts[1] - (above.size - gone)
    # A fold at a value of the path itself may lie on either side of that float: the counts tell.
    if ((along.at > min(step)) & (along.at < max(step))).any() or (
        kinds.size and counts[0] != counts[1]
    ):
        return len(pairs) == min(counts)
    # States that no tube joins: between folds no branch changes the sign of det K or crosses the
    # mirror.
    remaining = _left(pairs, begin), _left(pairs.values(), end)
    one, other = (
        _told_apart(states, part) for states, part in zip((begin, end), remaining, strict=True)
    )
    unique = len(remaining[0]) == len(one) and len(remaining[1]) == len(other)
    if unique and one.keys() == other.keys():
        pairs |= {one[key]: other[key] for key in one}
    return len(pairs) == counts[0] == counts[1]


def _across_pitchforks(
    places: FloatArray, pairs: dict[int, int], begin: _States, end: _States, on: list[bool]
) -> bool:
    """Whether all pairs across pitchforks are known; they are added to ``pairs``.

    ``places`` are the pitchforks, shape (n, number), and ``on`` says which of both values lies on
    them. The outer two states and the one on the other side of the pitchfork agree in the sign of
    det K. If it is positive, no state ends there: the upper of three goes on. If it is negative,
    the middle state is stable, and begins or ends there.
    """
    remaining = _left(pairs, begin), _left(pairs.values(), end)
    near = [
        clearly_nearest(states.q[:, slots], places)
        for states, slots in zip((begin, end), remaining, strict=True)
    ]
    for number in range(places.shape[1]):
        one, two = (
            np.array(slots)[there == number].tolist()
            for slots, there in zip(remaining, near, strict=True)
        )
        if not one and not two:
            continue
        if not {len(one), len(two)} <= {1, 3}:
            return False
        # Sorted by the coordinate in which they differ most, whose sign the mirror changes.
        three = begin.q[:, one] if len(one) > len(two) else end.q[:, two]
        spread = np.ptp(three, axis=1)
        odd = int((spread >= (1 - 1e-9) * spread.max()).argmax())  # ties, but for rounding: first
        one.sort(key=lambda k: float(begin.q[odd, k]))
        two.sort(key=lambda k: float(end.q[odd, k]))
        sides = zip((begin, end), (one, two), on, strict=True)
        soft = any(states.signs[slots].sum() > 0 for states, slots, there in sides if not there)
        goals = two
        if len(one) != len(two):
            goals = [two[-1] if soft else two[len(two) // 2]] * len(one)
        if len(two) == 1 and not (on[1] or soft):
            one = [slot for slot in one if begin.signs[slot] < 0 and not on[0]]
        pairs |= dict(zip(one, goals, strict=False))
    return bool((np.concatenate(near) >= 0).all())


def clearly_nearest(q: FloatArray, places: FloatArray) -> IntArray:
    """For each state, shape (n, number), the index of a place ten times nearer than all others, or
    −1.
    """
    distance = np.linalg.norm(q[:, :, None] - places[:, None], axis=0)
    padded = np.pad(distance, [(0, 0), (0, 1)], constant_values=np.inf)
    first, second = np.sort(padded, axis=1).T[:2]
    return np.where(first <= 0.1 * second, distance.argmin(axis=1), -1)


def _left(taken: Container[int], states: _States) -> list[int]:
    """Slots that are not taken."""
    return [k for k in range(states.signs.size) if k not in taken]


def _told_apart(states: _States, part: Sequence[int]) -> dict[tuple[float, float | None], int]:
    """Slots by the sign of det K and, for equal signs, by the side of the mirror.

    Two states with the same key share an entry, and states on the mirror have none, so that there
    are fewer entries than states.
    """
    signs = states.signs[part].tolist()
    keys = [
        (sign, states.sides[k] if signs.count(sign) > 1 else None)
        for k, sign in zip(part, signs, strict=True)
    ]
    return {key: k for key, k in zip(keys, part, strict=True) if key[1] != 0}
