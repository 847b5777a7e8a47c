"""Search for points at which equilibria change, along one or two parameters of a model: one driver for all kinds, one result."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ParameterError, ParameterTypeError
from ..models.parameters import ParameterSet, as_numbers
from ..numerics import boxes, certified_roots
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import FloatArray, Intervals
from ..numerics.jets import Jet, variables
from ..progress import doing
from ..results.points import Ended, Points
from ..statics import stability
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.border import on_its_side
from ..statics.mechanics.forces import Model
from ..statics.mechanics.periodic_coordinates import once_around
from ..statics.regions import by_hand, region
from ..statics.remarks import kinds_of, of_ranges, of_region, summed
from ..statics.tie_breaking import in_order
from . import near_zero
from .defining_systems import Augmented, Condition
from .degenerate_ends import shared
from .precise_points import PreciseAugmented, settled

#: Boxes looked at for one search of up to three unknowns, of four, and of more, where each costs many times as much.
BUDGET, LARGE_BUDGET, COSTLY_BUDGET = 200_000, 1_000_000, 6_000
#: Boxes left that are listed one by one.
MANY = 200
#: End of the range of a parameter that has none, over its base value if that is larger than 1.
FAR = 10.0
#: How far beyond the border of the contact states on it are looked for.
OVER_BORDER = 1e-3


@dataclass(frozen=True)
class Found:
    """Roots of a search, the region of each of its points and whether it holds all equilibria."""

    roots: Roots
    region: FloatArray
    whole: NDArray[np.bool_]


def ranges(model: Model, vary: Sequence[str], between: Mapping[str, tuple[float, float]]) -> FloatArray:
    """Lower and upper ends of the parameters that vary, shape (number, 2)."""
    if not isinstance(between, Mapping):
        raise ParameterTypeError(f'between = {between!r:.60} is no mapping; give the ends by name, as {{"mu0": (0, 1)}}')
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    rows = []
    for name in vary:
        if not isinstance(name, str) or name not in entries:
            raise ParameterError(f"vary = {name!r} is not a parameter of this model; choose one of {', '.join(entries)}")
        entry = entries[name]
        low, high = (entry[end] for end in ("low", "high"))
        far = FAR * max(1.0, abs(entry["base"] or 0.0))
        default = (-far if low is None else low, far if high is None else high)
        ends = as_numbers(f"between[{name!r}]", between[name]) if name in between else np.array(default)
        if ends.shape != (2,) or not ends[0] < ends[1]:
            raise ParameterError(f"between[{name!r}] = {between[name]} is no range; give its lower and upper end")
        if (ends[0] < default[0] and low is not None) or (ends[1] > default[1] and high is not None):
            raise ParameterError(
                f"between[{name!r}] = {between[name]} leaves the range of {name}, {entry['domain']}; stay within it"
            )
        rows.append(ends)
    for name in between:
        if name not in vary:
            raise ParameterError(f"between has a range for {name!r}, which does not vary; {', '.join(vary)} does")
    return np.array(rows, dtype=float).reshape(-1, 2)


def endless(model: Model, vary: Sequence[str], between: Mapping[str, tuple[float, float]]) -> tuple[str, ...]:
    """Parameters without an end, of which nobody has said how far they are searched."""
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    return tuple(name for name in vary if name not in between and None in (entries[name]["low"], entries[name]["high"]))


def search(
    balance: Balance,
    vary: Sequence[str],
    condition: Condition,
    given: FloatArray,
    spans: FloatArray,
    *,
    budget: int | None = None,
    asked: FloatArray | None = None,
) -> Found:
    """All points of a kind.

    ``given`` are the parameters, shape (parameters, points), of which those that vary are not used, ``spans`` their ranges,
    shape (number, 2), ``budget`` the boxes looked at for one point, ``asked`` a region by hand.
    """
    places = [balance.parameters.index(name) for name in vary]
    if condition.singular and is_affine(balance, given, spans, places):
        endless = np.broadcast_to(np.inf, (2, balance.n, given.shape[1]))
        return _without_points(np.concatenate([endless, _sides(given, spans)], axis=1), np.ones(given.shape[1], dtype=np.bool_))
    around, whole = _region(balance, places, given, spans, asked)
    if condition.touching and not whole.all():
        # On the border the contact's force is 0: these are states in lift-off, too.
        apart = Balance(balance.model, contact=False, room=balance.room)
        around, whole = _region(apart, places, given, spans, asked)
    limits = np.concatenate([balance.limits, np.full((2, len(vary)), np.inf)], axis=1)
    system = Augmented(balance, vary, condition)
    fixed = given.copy()
    fixed[places] = spans[:, :1]
    if budget is None:
        budget = BUDGET if system.n <= 3 else LARGE_BUDGET if system.n == 4 else COSTLY_BUDGET
    alone = len(vary) == 1 and given.shape[1] == 1
    from_least = alone and near_zero.begins(system, given, around)
    searched = np.concatenate([around[:, :-1], [[[-near_zero.LOW]], around[1:, -1]]], axis=1) if from_least else around
    outcome = boxes.search(system, searched, fixed, fixed, limits=limits, budget=budget)
    roots = certified_roots.roots(system, outcome, searched, fixed, fixed)
    if from_least:
        roots = near_zero.joined(near_zero.searched(system, fixed, around, limits), roots)
        around = np.concatenate([around[:, :-1], [[[-near_zero.LEAST]], around[1:, -1]]], axis=1)
    if alone:
        roots = settled(system, fixed, around, roots)
    roots = on_its_side(system, fixed, roots, partial(PreciseAugmented, system))
    roots = once_around(balance, roots)
    if alone:
        roots = roots.kept(left=~shared(system, given, spans[0], roots.left))
    return Found(roots, around, whole)


def nothing(
    balance: Balance, vary: Sequence[str], given: FloatArray, spans: FloatArray, asked: FloatArray | None = None
) -> Found:
    """The result of a search where it is known beforehand that there are no points."""
    return _without_points(*_region(balance, [balance.parameters.index(name) for name in vary], given, spans, asked))


def _without_points(around: FloatArray, whole: NDArray[np.bool_]) -> Found:
    return Found(Roots.none(around.shape[1]), around, whole)


def _region(
    balance: Balance, places: Sequence[int], given: FloatArray, spans: FloatArray, asked: FloatArray | None
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Coordinates and the parameters of these numbers, and whether that holds all equilibria."""
    low, high = given.copy(), given.copy()
    low[places], high[places] = spans[:, :1], spans[:, 1:]
    around, whole = region(balance, Intervals.between(low, high), asked)
    return np.concatenate([around, _sides(given, spans)], axis=1), whole


def _sides(given: FloatArray, spans: FloatArray) -> FloatArray:
    """−low and high of the parameters that vary, for each point."""
    return np.broadcast_to(np.stack([-spans[:, 0], spans[:, 1]])[:, :, None], (2, len(spans), given.shape[1]))


def is_affine(balance: Balance, given: FloatArray, spans: FloatArray, places: Sequence[int]) -> bool:
    """Whether the forces are affine in the coordinates, by structure: there is one state, none, or a line, and no two meet."""
    if balance.springs:
        return False
    low, high = given[:, :1].copy(), given[:, :1].copy()
    low[places], high[places] = spans[:, :1], spans[:, 1:]
    with np.errstate(all="ignore"):
        values = balance.arguments(balance.prepared(Intervals.between(low, high)))
        try:
            rows = balance.by_coordinate("forces", variables([Intervals.point(np.full(1, 0.5))] * balance.n, 2), [], values)
        except ZeroDivisionError:  # a law that has no value there
            return False
    pairs = list(itertools.combinations_with_replacement(range(balance.n), 2))
    return all(isinstance(row.derivative(*pair), int) for row in rows if isinstance(row, Jet) for pair in pairs)


def _merged(left: FloatArray) -> FloatArray:
    """Many boxes that are left as hulls of those with touching ranges of the parameter: thousands cover a line of equilibria."""
    if left.shape[2] <= MANY:
        return left
    left = left[:, :, np.argsort(-left[0, -1])]
    low, reached = -left[0, -1], np.maximum.accumulate(left[1, -1])
    hulls: FloatArray = np.maximum.reduceat(left, np.flatnonzero(np.concatenate([[True], low[1:] > reached[:-1]])), axis=2)
    return hulls


def given_column(p: Any, names: Sequence[str], vary: Sequence[str]) -> FloatArray:
    """Scalar parameters as one column, NaN for those that vary."""
    fixed = [name for name in names if name not in vary]
    values = dict(zip(fixed, p.scalars(*fixed), strict=True))
    return np.array([[values.get(name, np.nan)] for name in names])


def matrices(balance: Balance, vary: Sequence[str], given: FloatArray, z: FloatArray) -> tuple[FloatArray, ...]:
    """M, C and K, each of shape (N, n, n), at coordinates and the parameters that vary, z of shape (n + number, N)."""
    point = np.repeat(given, z.shape[1], axis=1)
    point[[balance.parameters.index(name) for name in vary]] = z[balance.n :]
    with np.errstate(all="ignore"):  # beyond the touch a law like Hertz's has no value
        parts = stability.linearization(balance, z[: balance.n], point)
    return tuple(np.moveaxis(part, -1, 0) for part in parts)


def arranged(
    balance: Balance,
    p: ParameterSet,
    vary: Sequence[str],
    given: FloatArray,
    found: Found,
    kind: NDArray[np.str_],
    more: Mapping[str, FloatArray] | None = None,
    *,
    endless: tuple[str, ...] = (),
    remarks: tuple[str, ...] = (),
) -> Points:
    """The points as a result, sorted by the parameters that vary; given parameters of shape (parameters, 1)."""
    n, middle, left = balance.n, found.roots.middle, found.roots.left
    order = in_order(np.concatenate([middle[n:], middle[:n]]), found.roots.error, found.roots.point)
    values: dict[str, FloatArray] = {name: middle[n + i, order] for i, name in enumerate(vary)}
    values |= {name: middle[i, order] for i, name in enumerate(balance.coordinates)}
    values |= {name: column[order] for name, column in (more or {}).items()}
    box = np.stack([-found.region[0, :, 0], found.region[1, :, 0]], axis=-1)
    varied = dict(zip(vary, Intervals(left[:, n:]), strict=True))
    remarks += summed(kinds_of(balance, np.repeat(given, left.shape[2], axis=1), left, varied))
    remarks += of_region(balance, found.region[:, :n], found.whole)
    remarks += of_ranges(endless, box[[n + list(vary).index(name) for name in endless]])
    left = _merged(left) if len(vary) == 1 else left
    boxes_left = np.moveaxis(np.stack([-left[0], left[1]], axis=-1), 1, 0)
    return Points(
        p, tuple(vary), kind[order], found.roots.error[order], box, bool(found.whole.all()), endless, boxes_left, remarks, values,
        what_ends,
    )  # fmt: skip


def what_ends(points: Points) -> Ended:
    """What ends at folds among points that a search found."""
    from .fold_outcomes import ended  # many who ask for points never ask for this

    return ended(points)


def isolated(
    balance: Balance, p: Any, condition: Condition, vary: Sequence[str], spans: FloatArray, kind: str,
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Points:  # fmt: skip
    """Points of one condition along one parameter or in the plane of two."""
    given = given_column(p, balance.parameters, vary)
    with doing("points of the kind {} over {}", kind, " and ".join(vary)):
        found = search(balance, vary, condition, given, spans, asked=by_hand(balance.coordinates, within))
    return arranged(balance, p, vary, given, found, np.full(found.roots.point.size, kind))
