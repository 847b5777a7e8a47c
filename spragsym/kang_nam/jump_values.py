"""The first jump of the reference state along one parameter, and whether it has jumped, for arrays
of points.

All folds along the parameter are found with proof (:mod:`spragsym.kang_nam.fold_arrays`). Between
two folds the equilibria keep their order in θ, and of each fold it is known which two of them meet
and on which side. So the state that is followed is given by its rank, and it jumps at the first
fold at which it is one of the two that vanish. Points that float64 can't decide are treated in the
same way in exact arithmetic.

Whether the state has jumped at a friction is decided without finding the jump. On the surface f = 0
μ₀ is a function of θ, since f is linear in μ₀, and folds are its stationary points. Let θ₁ be the
first equilibrium at μ₀ beyond the state without friction. The state has not jumped if and only if
μ₀(θ) rises all the way between the two, which the signs of one polynomial decide.
"""

import math
from collections.abc import Iterator, Mapping

import numpy as np

from ..bifurcation.paths import first_end
from ..core.errors import ConvergenceError
from ..core.questions import NotInClosedForm
from ..design.jumps import Ends
from ..generated.quantities import PARAMETERS
from ..models.parameters import FloatArray
from ..numerics import bernstein
from ..numerics.affine import UNIT
from ..numerics.balls import UndecidedSign
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import BoolArray, IndexArray
from ..results.equilibria import Equilibria, EquilibriumType
from . import fold_arrays, kernel
from .fold_arrays import friction_sextic
from .folds import folds
from .parameters import Parameters
from .quartic.solver import equilibria

#: Beginnings of the parameters that rise from their lower end; others move from their value. Folds
#: below the beginning of θ₀ are found in exact arithmetic.
FROM_LOWER_END = {"theta0": 2.0**-40, "mu0": 0.0}


def first_limit_points(
    p: Parameters, vary: str | None = None, *, direction: str = "up", begin: float | None = None
) -> Ends:
    """The closed form of :func:`spragsym.design.jumps.first_limit_points`, along any of the six
    parameters, to 1e-12.

    Notes
    -----
    Source: f = f′ = 0; the first jump of :func:`spragsym.quasi_static_path` from ``start="small"``.
    """
    vary = vary or "mu0"
    require_usual(p, vary, begin)
    directions = ("up",) if vary in FROM_LOWER_END else ("up", "down")
    if vary not in PARAMETERS or direction not in directions:
        raise NotInClosedForm
    return first_jumps(p, vary, direction)


def require_usual(p: Parameters, vary: str, begin: FloatArray | float | None) -> None:
    """Raise NotInClosedForm unless the reference state is followed, from the lower end of the
    parameter or from its value in the set.
    """
    usual = begin is None or (
        vary in FROM_LOWER_END and bool(np.all(np.asarray(begin) <= FROM_LOWER_END[vary]))
    )
    if p.followed is not None or not usual:
        raise NotInClosedForm


def first_jumps(p: Parameters, vary: str, direction: str = "up", *, sides: bool = False) -> Ends:
    """First jumps of the reference state.

    With ``sides`` a value is refined only until it is known whether it lies above or below the
    point's own value in ``p``.
    """
    p.require(*(name for name in ("theta0", "mu0") if name != vary))
    own_value, full_shape = p[vary], p.shape
    if vary in FROM_LOWER_END:
        p = p.replace(**{vary: None})
    forward, shape, size = 1 if direction == "up" else -1, p.shape, math.prod(p.shape)
    # Points that differ in ``vary`` only share one jump, which is refined in any case.
    own_values = (
        np.broadcast_to(own_value, shape).reshape(-1) if sides and shape == full_shape else None
    )
    value, state, failures = np.empty(size), np.empty((2, size)), dict[int, str]()
    for part, given in _blocks(p):
        marks = None if own_values is None else own_values[part]
        value[part], theta, reasons = _block(given, vary, forward, marks)
        failures |= {part.start + i: reason for i, reason in reasons.items()}
        at = given | {vary: value[part]}
        with np.errstate(invalid="ignore"):
            angles = *kernel.cos_sin(theta), *kernel.cos_sin(at["theta0"])
            fixed = (at[name] for name in kernel.Fixed._fields)
            state[:, part] = kernel.state_of(*angles, *fixed)[1:]
    end = Parameters.ranges[vary].high if forward > 0 else Parameters.ranges[vary].low
    errors, until = np.full(shape, fold_arrays.LARGEST_ERROR), np.full(shape, end)
    return Ends(value.reshape(shape), errors, state.reshape(2, *shape), failures, until)


def _blocks(p: Parameters) -> Iterator[tuple[slice, dict[str, FloatArray]]]:
    """Blocks of points: their slice, and arrays of the given parameters."""
    columns = ((name, p[name]) for name in PARAMETERS)
    given = {
        name: np.broadcast_to(column, p.shape).reshape(-1)
        for name, column in columns
        if column is not None
    }
    block = 1 << 13  # large beside the overhead of calls, small enough for the cache
    for begin in range(0, math.prod(p.shape), block):
        part = slice(begin, begin + block)
        yield part, selected_rows(given, part)


def _block(
    given: dict[str, FloatArray], vary: str, forward: int, marks: FloatArray | None
) -> tuple[FloatArray, FloatArray, dict[int, str]]:
    """Values and θ of the first jumps of a block of points, NaN without a jump, and the reasons of
    points without an answer, by index.
    """
    size = next(iter(given.values())).size
    start = np.full(size, FROM_LOWER_END[vary]) if vary in FROM_LOWER_END else given[vary]
    eq = equilibria(Parameters(**given | {vary: start}))
    # A parameter with one value is passed as a number: coefficients are then computed once.
    others = {
        name: column[0] if (column == column[0]).all() else column
        for name, column in given.items()
        if name != vary
    }
    found = fold_arrays.folds(vary, others, size)
    undecided = found.undecided | ~eq.decided | eq.fold
    jumped = _walk(found, start, forward, small(eq), undecided)
    value, theta = np.full(size, np.nan), np.full(size, np.nan)
    points = np.flatnonzero((jumped >= 0) & ~undecided)
    at_jump = found.rows(jumped[points])
    value[points], theta[points] = at_jump.value.value, 2 * np.arctan(at_jump.t.value)
    if marks is not None:
        near = np.flatnonzero(~(np.abs(value[points] - marks[points]) > 1.01 * at_jump.value.error))
        points, at_jump = points[near], at_jump.rows(near)
    others_there = {
        name: column[points] if column.ndim else column for name, column in others.items()
    }
    t, best, remaining = fold_arrays.sharpened(vary, others_there, at_jump)
    value[points] = best.value
    for k in remaining:
        point = point_at(given, points[k])
        try:
            value[points[k]] = fold_arrays.with_more_digits(vary, point, t.rows(k), best.rows(k))
        except UndecidedSign:
            undecided[points[k]] = True
    reasons = {}
    for i in np.flatnonzero(undecided):
        try:
            value[i], theta[i] = exactly(Parameters(**point_at(given, i)), vary, forward)
        except ConvergenceError as reason:
            value[i] = theta[i] = np.nan
            reasons[int(i)] = str(reason)
    return value, theta, reasons


def small(eq: Equilibria) -> IndexArray:
    """For each point the slot of the stable equilibrium of smallest \\|x\\|; of any equilibrium if
    none is stable.
    """
    size = np.where(np.isnan(eq.x), np.inf, np.abs(eq.x))
    stable = np.where(eq.undamped == EquilibriumType.STABLE, size, np.inf)
    return np.asarray(
        np.argmin(np.where(np.isfinite(stable).any(axis=-1, keepdims=True), stable, size), axis=-1)
    )


def _walk(
    found: fold_arrays.FoldArrays,
    start: FloatArray,
    forward: int,
    rank: IndexArray,
    undecided: BoolArray,
) -> IndexArray:
    """The index of the fold at which each point jumps, −1 without a jump.

    The rank of the state is updated over the folds in their order. Points whose folds have no
    certain order are added to ``undecided``.
    """
    ahead = forward * (found.value.value - start[found.row])
    near = np.abs(ahead) <= found.value.error * 1.01 + 1e-300
    undecided[found.row[near]] = True
    keep = np.flatnonzero((ahead > 0) & ~near)
    keep = keep[np.lexsort((ahead[keep], found.row[keep]))]
    kept = found.rows(keep)
    row, value = kept.row, kept.value
    same = row[1:] == row[:-1]
    ordered = forward * (value.value[1:] - value.value[:-1]) > 1.01 * (
        value.error[1:] + value.error[:-1]
    )
    undecided[row[1:][same & ~ordered]] = True
    rank, jumped = rank.astype(int), np.full(start.size, -1)
    number = np.arange(row.size) - np.searchsorted(row, row)  # which fold of its point
    for k in range(int(number.max(initial=-1)) + 1):
        now = np.flatnonzero(number == k)
        points, grows, upper = row[now], forward * kept.side[now] > 0, kept.upper[now]
        jumps = (
            ~grows & (jumped[points] < 0) & np.where(upper, rank[points] >= 1, rank[points] <= 1)
        )
        jumped[points[jumps]] = keep[now[jumps]]
        rank[points] = np.where(grows & ~upper, 2, 0)
    return jumped


def point_at(given: Mapping[str, FloatArray], i: int | np.intp) -> dict[str, float]:
    """The parameters of one point."""
    return {name: float(column[i]) for name, column in given.items()}


def exactly(p: Parameters, vary: str, forward: int = 1) -> tuple[float, float]:
    """The value of the first jump of one point, and θ there, by exact arithmetic; NaN without a
    jump.
    """
    found = folds(p, vary)
    values: FloatArray = getattr(found, vary)
    start = min([FROM_LOWER_END[vary], *(values / 2)]) if vary in FROM_LOWER_END else float(p[vary])
    ahead = values[forward * (values - start) >= 0]
    if not ahead.size:
        return math.nan, math.nan
    last, high = forward * float((forward * ahead).max()), Parameters.ranges[vary].high
    above = 2 * last + 1 if math.isinf(high) else (last + high) / 2
    end = last / 2 if forward < 0 else above
    jump = first_end(p, vary, (float(start), end))
    if jump is None:
        return math.nan, math.nan
    row = int(np.abs(values - jump.value).argmin())
    return float(values[row]), float(found.theta[row])


def limit_point_passed(
    p: Parameters,
    vary: str | None = None,
    begin: float | FloatArray | None = None,
    *,
    coarse: bool = False,
) -> FloatArray:
    """The closed form of :func:`spragsym.design.jumps.limit_point_passed` as friction or
    inclination rises; quick everywhere.

    Notes
    -----
    Source: f′ f_μ₀ − f f_μ₀′, in which μ₀ cancels; it is negative where μ₀(θ) rises. Points that
    its signs do not decide, and all along θ₀, are asked by :func:`first_jumps`.
    """
    vary = vary or "mu0"
    require_usual(p, vary, begin)
    if vary not in FROM_LOWER_END:
        raise NotInClosedForm
    p.require("theta0", "mu0")
    if vary == "theta0":
        return _at_or_below(p, vary)
    out = np.zeros(math.prod(p.shape))
    for part, given in _blocks(p):
        jumped = out[part]
        jumped[:], open_ = _decided(given)
        if open_.size:
            jumped[open_] = _at_or_below(Parameters(**selected_rows(given, open_)), vary)
    return out.reshape(p.shape)


def _at_or_below(p: Parameters, vary: str) -> FloatArray:
    """1 for points that jump at or below their own value, else 0; NaN if that is not known."""
    found = first_jumps(p, vary, sides=True)
    unknown = np.zeros(found.value.size)
    unknown[list(found.reasons)] = np.nan
    return np.asarray((found.value <= p[vary]) + unknown.reshape(found.value.shape))


def with_and_without_friction(
    given: dict[str, FloatArray],
) -> tuple[Equilibria, Equilibria, IndexArray, FloatArray, FloatArray, BoolArray]:
    """Equilibria without friction and at the points' friction; the slot and θ of the reference
    state without friction; the first θ from there on among those with friction; and a mask of the
    points for which all are known.
    """
    bare, full = (
        equilibria(Parameters(**given | {"mu0": share * given["mu0"]})) for share in (0.0, 1.0)
    )
    slot = small(bare)[:, None]
    first = np.take_along_axis(bare.theta, slot, axis=-1)
    later = np.where(full.theta >= first, full.theta, np.inf).min(axis=-1)
    return bare, full, slot, first, later, np.isfinite(later) & bare.decided & full.decided


def _decided(given: dict[str, FloatArray]) -> tuple[FloatArray, IndexArray]:
    """1 for points that have jumped, else 0; and the indices of those that signs do not decide."""
    bare, full, slot, first, later, decided = with_and_without_friction(given)
    error, kind = (np.take_along_axis(one, slot, axis=-1) for one in (bare.error, bare.undamped))
    # Closer than 1e-9 rad, float64 does not decide which equilibrium comes first.
    near = (np.abs(full.theta - first) <= 1e-9).any(axis=-1)
    decided &= ~near & (kind[:, 0] == EquilibriumType.STABLE) & ~bare.fold & ~full.fold
    ends = [_place(np.where(decided, angle, 1.0)) for angle in (first[:, 0], later)]
    # An error is one over max(1, θ), and dw/dθ is less than 1; a few units in the last place are
    # the rounding of w.
    uncertainty = (
        np.where(
            decided,
            4.0 * np.maximum(error[:, 0], np.nan_to_num(full.error, nan=0.0).max(axis=-1)),
            0.0,
        )
        + 8 * UNIT
    )
    signs = bernstein.signs_between(friction_sextic(given), ends[0], np.maximum(*ends), uncertainty)
    # If μ₀(θ) falls at the beginning, the state moves to smaller θ as friction rises.
    decided &= signs.at_low < 0
    open_ = ~(decided & (signs.negative | signs.positive)) & (given["mu0"] > 0)
    return np.where(decided & signs.positive, 1.0, 0.0), np.flatnonzero(open_)


def _place(theta: FloatArray) -> FloatArray:
    """The variable w = t/(t + τ) of the Bernstein form, with t = tan(θ/2)."""
    s, c = np.sin(0.5 * theta), np.cos(0.5 * theta)
    return s / (s + bernstein.SCALE * c)
