"""A state followed as one parameter moves slowly: where it goes, where it vanishes, and what it jumps to.

No step can leave the branch: all folds along the parameter are known beforehand (:func:`spragsym.folds`), between two of them the
equilibria keep their order in θ, and at one of them exactly two neighbours meet. So a branch is a rank, and at each fold the
rank changes by a rule.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .catastrophe import Folds, folds
from .display import Result
from .errors import ConvergenceError, ParameterError
from .parameters import NAMES, RANGES, FloatArray, Parameters, as_numbers
from .solver import Equilibria, Stability, equilibria


@dataclass(frozen=True)
class Jump(Result):
    """A state that vanishes at a fold, and the one that takes its place."""

    value: float  #: of the parameter, at the fold
    theta0: float
    mu0: float
    theta_before: float
    x_before: float
    y_before: float
    theta_after: float
    x_after: float
    y_after: float
    stability_after: Stability
    error: float  #: bound on the error of ``value``


@dataclass(frozen=True)
class Path(Result):
    """States along the values of the parameter, in the order in which they are passed, and the jumps between them."""

    vary: str
    values: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    stability: NDArray[np.int8]
    jumps: tuple[Jump, ...]


#: Chooses among the slots of the equilibria left after a jump, given the state before it: (eq, x_before) → slot.
Choice = Callable[[Equilibria, float], int]


def quasi_static_path(
    p: Parameters, vary: str, values: ArrayLike, *, start: int | str = "small", after_jump: Choice | None = None
) -> Path:
    """Follow an equilibrium in contact as a parameter moves through ``values``, up or down, with its jumps.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary : str
        Its name: ``"theta0"`` or another of the six.
    values : array_like
        One axis, strictly increasing or strictly decreasing.
    start : "small", "large" or int
        Where to begin, at the first value: the stable equilibrium of smallest or largest |x|, or a slot of
        :func:`spragsym.equilibria`.
    after_jump : callable, optional
        Which equilibrium the system goes to after a jump: ``(eq, x_before) -> slot``. By default the nearest stable one in the
        direction of sliding, x growing, or if there is none the nearest. Of one or three equilibria two vanish at a fold, so
        one is left there and the choice is none, unless it is replaced by an integration of the motion that finds a limit
        cycle: see :func:`spragsym.simulate`.

    Returns
    -------
    Path

    Raises
    ------
    ParameterError
        For values that do not go one way, or out of range, or a ``start`` that has no equilibrium.

    Notes
    -----
    Source: article, Figures 6 and 13. Folds to 1e-12 by :func:`spragsym.folds`.

    Examples
    --------
    >>> import numpy as np
    >>> up = quasi_static_path(Parameters.article(mu0=0.7), "theta0", np.radians(np.arange(1.0, 180.0)))
    >>> [round(float(np.degrees(jump.value)), 6) for jump in up.jumps]
    [35.353706]
    """
    if vary not in NAMES:
        raise ParameterError(f"vary = {vary!r} is not a parameter; choose one of {', '.join(NAMES)}")
    along = as_numbers("values", values, RANGES[vary])
    if along.ndim != 1 or not along.size:
        raise ParameterError(f"values has the shape {along.shape}; give one axis with at least one value")
    steps = np.diff(along)
    if not ((steps > 0).all() or (steps < 0).all()):
        raise ParameterError("values go both ways or repeat; give them strictly increasing or strictly decreasing")
    forward = -1.0 if along[0] > along[-1] else 1.0
    eq = equilibria(p.replace(**{vary: along}))
    turns = _between(folds(p, vary=vary), along, forward)

    rank = _first_rank(eq, start)
    ranks = np.empty(along.size, dtype=np.int64)
    jumps: list[Jump] = []
    done = 0
    for i, turn in enumerate(turns):
        passed = int(np.searchsorted(forward * along, forward * turn["value"], side="right"))
        ranks[done:passed] = rank
        done = max(done, passed)
        rank, jump = _pass_fold(p, vary, turns, i, along, forward, rank, after_jump or _nearest_in_sliding_direction)
        if jump is not None:
            jumps.append(jump)
    ranks[done:] = rank
    if (ranks >= eq.count).any():
        raise ConvergenceError(
            f"a fold lies closer to one of the values than they can be told apart; shift values a little ({vary})"
        )
    rows = np.arange(along.size)
    states = {name: getattr(eq, name)[rows, ranks] for name in ("theta", "L", "x", "y", "stability")}
    return Path(vary, along, **states, jumps=tuple(jumps))


def _between(found: Folds, along: FloatArray, forward: float) -> list[dict[str, float]]:
    """The folds that are passed, in the order in which they are passed."""
    value = getattr(found, found.vary)
    inside = (value > along.min()) & (value < along.max())
    names = ("theta0", "mu0", "theta", "x", "y", "error")
    rows = [
        {"value": float(value[i]), **{name: float(getattr(found, name)[i]) for name in names}} for i in np.flatnonzero(inside)
    ]
    return sorted(rows, key=lambda row: forward * row["value"])


def _first_rank(eq: Equilibria, start: int | str) -> int:
    count = int(eq.count[0])
    if isinstance(start, str):
        if start not in ("small", "large"):
            raise ParameterError(f"start = {start!r}; give 'small', 'large' or the slot of an equilibrium")
        stable = np.flatnonzero(eq.stability[0] == Stability.STABLE)
        slots = stable if stable.size else np.arange(count)
        sizes = np.abs(eq.x[0, slots])
        return int(slots[np.argmin(sizes) if start == "small" else np.argmax(sizes)])
    if isinstance(start, bool) or not 0 <= start < count:
        raise ParameterError(f"start = {start!r}: the first value has {count} equilibria, slots 0 to {count - 1}")
    return int(start)


def _pass_fold(
    p: Parameters, vary: str, turns: list[dict[str, float]], i: int, along: FloatArray, forward: float, rank: int, choose: Choice
) -> tuple[int, Jump | None]:
    """The rank beyond the i-th fold, and the jump if the branch ends there.

    Halfway to the neighbouring folds the equilibria are well apart: there they are counted, and the one that is far from the fold
    tells on which side of it the pair lies.
    """
    turn = turns[i]
    before = turns[i - 1]["value"] if i else float(along[0])
    after = turns[i + 1]["value"] if i + 1 < len(turns) else float(along[-1])
    here = equilibria(p.replace(**{vary: np.array([0.5 * (before + turn["value"]), 0.5 * (turn["value"] + after)])}))
    counts = here.count.tolist()
    if sorted(counts) != [1, 3]:
        raise ConvergenceError(f"{counts[0]} and {counts[1]} equilibria on the two sides of the fold at {vary} = {turn['value']}")
    lower = _third_is_below(p, vary, turn)
    if counts[1] == 3:  # a pair is born above the third equilibrium, or below it
        return (0 if lower else 2), None
    pair = (1, 2) if lower else (0, 1)
    if rank not in pair:
        return 0, None
    left = equilibria(p.replace(**{vary: _just_beyond(turn["value"], forward, after)}))
    slot = choose(left, turn["x"])
    # The state itself is taken at the fold, where it has all of its digits.
    at_fold = equilibria(p.replace(**{vary: turn["value"]}))
    same = int(np.nanargmin(np.abs(at_fold.theta - left.theta[slot])))
    jump = Jump(
        turn["value"], turn["theta0"], turn["mu0"], turn["theta"], turn["x"], turn["y"],
        float(at_fold.theta[same]), float(at_fold.x[same]), float(at_fold.y[same]),
        Stability(int(left.stability[slot])), turn["error"],
    )  # fmt: skip
    return slot, jump


def _third_is_below(p: Parameters, vary: str, turn: dict[str, float]) -> bool:
    """Whether the equilibrium that the fold does not touch has the smaller θ."""
    eq = equilibria(p.replace(**{vary: turn["value"]}))
    thetas = eq.theta[: int(eq.count)]
    return bool(thetas[np.argmax(np.abs(thetas - turn["theta"]))] < turn["theta"])


def _just_beyond(value: float, forward: float, limit: float) -> float:
    """A little past a fold, where one equilibrium is left, but not past the next."""
    step = min(1e-9 * max(1.0, abs(value)), 0.5 * abs(limit - value))
    return value + forward * step


def _nearest_in_sliding_direction(eq: Equilibria, x_before: float) -> int:
    """The nearest stable equilibrium with larger x; without one, the nearest stable; without any, the nearest."""
    slots = np.arange(int(eq.count))
    x = eq.x[slots]
    stable = eq.stability[slots] == Stability.STABLE
    for allowed in (stable & (x > x_before), stable, np.ones_like(stable)):
        if allowed.any():
            return int(slots[allowed][np.argmin(np.abs(x[allowed] - x_before))])
    raise ConvergenceError("no equilibrium is left after a jump")
