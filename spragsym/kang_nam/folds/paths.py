"""A state followed as one parameter moves slowly: where it goes, where it vanishes, and what it jumps to.

No step can leave the branch: all folds along the parameter are known beforehand (:func:`spragsym.folds`), between two of them the
equilibria keep their order in θ, and of each fold it is proved on which side there are three equilibria and which two of them
meet. So a branch is a rank, and at each fold the rank changes by a rule.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import ConvergenceError, ParameterError
from ...generated import stability as _stability
from ...models.parameters import NAMES, RANGES, FloatArray, Parameters, as_numbers
from ...questions import NotInClosedForm
from ...results.equilibria import Equilibria, Held, Stability
from ...results.paths import Jump, Path, followed
from ..quartic.solver import equilibria
from .fold_points import STATE, Turn, turns

#: Chooses among the slots of the equilibria left after a jump, given the state before it: (eq, before) → slot.
Choice = Callable[[Equilibria, Mapping[str, float]], int]


def quasi_static_path(
    p: Parameters, vary: str, values: ArrayLike, *, start: int | str = "small", after_jump: Choice | None = None
) -> Path:
    """The closed form of :func:`spragsym.quasi_static_path` along any of the six parameters."""
    if vary not in NAMES:
        raise NotInClosedForm
    along = as_numbers("values", values, RANGES[vary])
    if along.ndim != 1 or not along.size:
        raise ParameterError(f"values has the shape {along.shape}; give one axis with at least one value")
    steps = np.diff(along)
    if not ((steps > 0).all() or (steps < 0).all()):
        raise ParameterError("values go both ways or repeat; give them strictly increasing or strictly decreasing")
    way = _Way(p, vary, along)
    place = _start(way, start)
    states = {name: np.empty(along.size) for name in _STATE}
    stability = np.empty(along.size, dtype=np.int8)
    jumps: list[Jump] = []
    for i in range(along.size):
        value = float(along[i])
        while place.region < way.first_region(value):
            place, jump = _pass(way, place, after_jump)
            jumps += [jump] if jump else []
        state, stability[i] = way.state(way.eq, (i,), value, place)
        for name, value in zip(_STATE, state, strict=True):
            states[name][i] = value
    return followed(p, vary, along, states, stability, KNOWN, tuple(jumps))


_STATE = STATE
#: Bound on the error of a state, over max(1, its size).
KNOWN = 1e-12


class _Way:
    """The values, the folds in the order in which the path meets them, and the regions between: region k precedes fold k."""

    def __init__(self, p: Parameters, vary: str, along: FloatArray) -> None:
        self.p, self.vary, self.along = p, vary, along
        self.forward = -1 if along[0] > along[-1] else 1
        self.eq = equilibria(p.replace(**{vary: along})).require_decided()
        self.turns = turns(p, vary)[:: self.forward]
        self.at = np.array([turn.values[NAMES.index(vary)] for turn in self.turns])
        changes = np.cumsum([0, *(2 * self.side(turn) for turn in self.turns)])
        regions = [self.true_region(float(value)) for value in along]
        counts = int(self.eq.count[0]) + changes - changes[regions[0]]
        wrong = np.flatnonzero(self.eq.count != counts[regions])
        if wrong.size:  # can't happen: the folds and their sides are proved
            raise ConvergenceError(f"folds and counts of equilibria disagree at {vary} = {along[wrong[0]]:.17g}")

    def side(self, turn: Turn) -> int:
        """1 where three equilibria lie beyond the fold, −1 where they lie before it."""
        return self.forward * turn.side

    def first_region(self, value: float) -> int:
        """The region of a value; a fold exactly at the value counts as not passed."""
        return int(np.count_nonzero(self.forward * (value - self.at) > 0))

    def true_region(self, value: float) -> int:
        """The region in which a value lies; a fold equal to it as a float lies on one side of it."""
        equal = (turn for turn, at in zip(self.turns, self.at, strict=True) if at == value)
        return self.first_region(value) + sum(turn.rounded == self.forward for turn in equal)

    def carried(self, place: _Place, region: int) -> int | Turn:
        """The rank of a state after it has moved to another region, or the fold at which it vanishes on the way."""
        rank, step = place.rank, 1 if region > place.region else -1
        for k in range(place.region, region, step):
            turn = self.turns[k if step > 0 else k - 1]
            opens = self.side(turn) * step
            if turn.kind == "pitchfork":
                # Of the two beside the divergent one the upper has the larger x: along F_y = 0, x grows with θ.
                rank = 2 if opens > 0 else 0
            elif opens > 0:
                rank = 0 if turn.upper else 2
            elif opens < 0:
                if rank in ((1, 2) if turn.upper else (0, 1)):
                    return turn
                rank = 0
        return rank

    def state(self, eq: Equilibria, index: tuple[int, ...], value: float, place: _Place) -> tuple[tuple[float, ...], int]:
        """θ, L, x, y and stability of a state at a value, or of the fold if rounding puts the value just beyond it."""
        rank = self.carried(place, self.true_region(value))
        if isinstance(rank, Turn):
            return rank.values[6:10], _stability_on(rank)
        return tuple(float(getattr(eq, name)[*index, rank]) for name in _STATE), int(eq.stability[*index, rank])


@dataclass(frozen=True)
class _Place:
    """A state between two folds."""

    region: int
    rank: int


def _start(way: _Way, start: int | str) -> _Place:
    """The state at the first value."""
    eq, value = way.eq, float(way.along[0])
    region, count = way.true_region(value), int(eq.count[0])
    if not isinstance(start, str):
        if isinstance(start, bool) or not 0 <= start < count:
            raise ParameterError(f"start = {start!r}: the first value has {count} equilibria, slots 0 to {count - 1}")
        return _Place(region, int(start))
    if start not in ("small", "large"):
        raise ParameterError(f"start = {start!r}; give 'small', 'large' or the slot of an equilibrium")
    here = np.flatnonzero(way.at == value)
    for k in here:
        if way.turns[k].kind == "pitchfork":
            return _Place(int(k) + (way.side(way.turns[k]) < 0), 0)
    known = [(int(eq.stability[0, slot]), float(eq.x[0, slot]), _Place(region, slot)) for slot in range(count)]
    # The first value is a fold, and rounding puts it just beyond the branch.
    for k in here if count == 1 else ():
        turn = way.turns[k]
        if turn.kind == "fold":
            inside = int(k) + (way.side(turn) > 0)
            known.append((_stability_on(turn), turn.values[8], _Place(inside, 2 if turn.upper else 0)))
    stable = [one for one in known if one[0] == Stability.STABLE] or known
    return (min if start == "small" else max)(stable, key=lambda one: abs(one[1]))[2]


def _stability_on(turn: Turn) -> int:
    """Where one λ is 0 the other decides, as in :func:`spragsym.equilibria`: its square is minus the trace of K."""
    _, mu0, _, alpha, sigma, beta, theta, L, *_ = turn.values
    K = _stability.stiffness(np.cos(theta), np.sin(theta), L, mu0, alpha, sigma, beta, 1)
    trace, *_ = _stability.invariants(*K[0], *K[1])
    return int(Stability.STABLE if trace > 0 else Stability.DIVERGENT)


def _pass(way: _Way, place: _Place, choose: Choice | None) -> tuple[_Place, Jump | None]:
    """The state beyond the next fold, and the jump if the branch ends there."""
    beyond = place.region + 1
    rank = way.carried(place, beyond)
    if not isinstance(rank, Turn):
        return _Place(beyond, rank), None
    value = float(way.at[place.region])
    eq = equilibria(way.p.replace(**{way.vary: value})).require_decided()
    state, code = way.state(eq, (), value, _Place(beyond, 0))
    before, after = (dict(zip(_STATE, place, strict=True)) for place in (rank.values[6:10], state))
    if choose is not None:
        slot = choose(_only(eq, state, code), before)
        if slot != 0:
            raise ParameterError(f"after_jump returned {slot!r}; one equilibrium is left after a jump, in slot 0")
    return _Place(beyond, 0), Jump(value, rank.kind, before, after, Stability(code), rank.values[10])


def _only(eq: Equilibria, state: tuple[float, ...], code: int) -> Equilibria:
    """One point with one state in the first slot."""
    further = [np.nan] * (eq.stability.shape[-1] - 1)
    columns: dict[str, NDArray[Any]] = {
        name: np.array([value, *further]) for name, value in zip((*_STATE, "error"), (*state, np.nanmax(eq.error)), strict=True)
    }
    columns["stability"] = np.array([code, *[0] * len(further)], dtype=np.int8)
    columns["marginal"] = columns["stability"] < 0
    return replace(eq, count=np.array(1), _source=Held(columns))
