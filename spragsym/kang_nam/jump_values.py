"""First jump of the reference state as one parameter moves, and whether it has jumped, for many
points at once.

All folds along the parameter are found with proof (:mod:`spragsym.kang_nam.fold_arrays`). Between
two folds the equilibria keep their order in θ, and each fold says which two of them meet and on
which side: so the state followed is a rank, and it jumps at the first fold at which it is one of
the two that vanish. Points that float64 can't decide go the same way in exact arithmetic.

Whether it has jumped at its friction is known without the place of the jump. Along the surface f =
0 is μ₀ a function of θ, since f is linear in it, and a fold is where that has no slope. Let θ₁ be
the first equilibrium at μ₀ beyond the state without friction. If nothing has jumped, μ₀(θ) rises
all the way between the two; and if it rises all the way, nothing has. So one polynomial's signs
between two directions decide, and no fold need be found.
"""

import math
from collections.abc import Iterator, Mapping

import numpy as np

from ..bifurcation.paths import first_end
from ..core.errors import ConvergenceError
from ..core.questions import NotInClosedForm
from ..design.jumps import Ends
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
from .parameters import NAMES, RANGES, Parameters
from .quartic.solver import equilibria

#: Parameters that rise from their lower end; the others move from the value that they have. Folds
#: below that of θ₀ are looked for exactly.
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
    if vary not in NAMES or direction not in directions:
        raise NotInClosedForm
    return first_jumps(p, vary, direction)


def require_usual(p: Parameters, vary: str, begin: FloatArray | float | None) -> None:
    """Closed forms follow the reference state, as a parameter rises from its lower end, or from the
    value in the set.
    """
    usual = begin is None or (
        vary in FROM_LOWER_END and bool(np.all(np.asarray(begin) <= FROM_LOWER_END[vary]))
    )
    if p.followed is not None or not usual:
        raise NotInClosedForm


def first_jumps(p: Parameters, vary: str, direction: str = "up", *, sides: bool = False) -> Ends:
    """First jumps of the reference state.

    With ``sides`` a value need only be known well enough to say on which side of that of its own
    point in ``p`` it lies.
    """
    p.require(*(name for name in ("theta0", "mu0") if name != vary))
    own, whole = p[vary], p.shape
    if vary in FROM_LOWER_END:
        p = p.replace(**{vary: None})
    forward, shape, size = 1 if direction == "up" else -1, p.shape, math.prod(p.shape)
    # Points that differ in ``vary`` alone share one jump, to be told from the values of all: it is
    # sharpened anyway.
    apart_from = np.broadcast_to(own, shape).reshape(-1) if sides and shape == whole else None
    value, state, failures = np.empty(size), np.empty((2, size)), dict[int, str]()
    for here, given in _blocks(p):
        marks = None if apart_from is None else apart_from[here]
        value[here], theta, reasons = _block(given, vary, forward, marks)
        failures |= {here.start + i: reason for i, reason in reasons.items()}
        at = given | {vary: value[here]}
        with np.errstate(invalid="ignore"):
            angles = *kernel.cos_sin(theta), *kernel.cos_sin(at["theta0"])
            fixed = (at[name] for name in kernel.Fixed._fields)
            state[:, here] = kernel.state_of(*angles, *fixed)[1:]
    end = RANGES[vary].high if forward > 0 else RANGES[vary].low
    errors, until = np.full(shape, fold_arrays.LARGEST_ERROR), np.full(shape, end)
    return Ends(value.reshape(shape), errors, state.reshape(2, *shape), failures, until)


def _blocks(p: Parameters) -> Iterator[tuple[slice, dict[str, FloatArray]]]:
    """Some of the points at a time: where they stand, and the parameters that are given, an array
    of each.
    """
    columns = ((name, p[name]) for name in NAMES)
    given = {
        name: np.broadcast_to(column, p.shape).reshape(-1)
        for name, column in columns
        if column is not None
    }
    # Points at a time: enough to forget the calls' overhead, few enough for the arrays in
    # between to stay in cache.
    block = 1 << 13
    for begin in range(0, math.prod(p.shape), block):
        here = slice(begin, begin + block)
        yield here, selected_rows(given, here)


def _block(
    given: dict[str, FloatArray], vary: str, forward: int, marks: FloatArray | None
) -> tuple[FloatArray, FloatArray, dict[int, str]]:
    size = next(iter(given.values())).size
    start = np.full(size, FROM_LOWER_END[vary]) if vary in FROM_LOWER_END else given[vary]
    eq = equilibria(Parameters(**given | {vary: start}))
    # What all points share is one number, of which the polynomials' coefficients are computed once.
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
    there = found.rows(jumped[points])
    value[points], theta[points] = there.value.value, 2 * np.arctan(there.t.value)
    if marks is not None:
        near = np.flatnonzero(~(np.abs(value[points] - marks[points]) > 1.01 * there.value.error))
        points, there = points[near], there.rows(near)
    theirs = {name: column[points] if column.ndim else column for name, column in others.items()}
    t, best, left = fold_arrays.sharpened(vary, theirs, there)
    value[points] = best.value
    for k in left:
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
    """The slot of the stable equilibrium of smallest \\|x\\|, or of the smallest if none is stable,
    of each of many points.
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
    """The fold at which each point jumps, −1 for none: ranks are carried over the folds in their
    order.

    Points whose order is not certain are added to ``undecided``.
    """
    ahead = forward * (found.value.value - start[found.row])
    near = np.abs(ahead) <= found.value.error * 1.01 + 1e-300
    undecided[found.row[near]] = True
    keep = np.flatnonzero((ahead > 0) & ~near)
    keep = keep[np.lexsort((ahead[keep], found.row[keep]))]
    kept = found.rows(keep)
    row, value = kept.row, kept.value
    same = row[1:] == row[:-1]
    apart = forward * (value.value[1:] - value.value[:-1]) > 1.01 * (
        value.error[1:] + value.error[:-1]
    )
    undecided[row[1:][same & ~apart]] = True
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
    """One of many points."""
    return {name: float(column[i]) for name, column in given.items()}


def exactly(p: Parameters, vary: str, forward: int = 1) -> tuple[float, float]:
    """The value of one point and the direction of the spring there, by exact arithmetic
    throughout.
    """
    found = folds(p, vary)
    values: FloatArray = getattr(found, vary)
    start = min([FROM_LOWER_END[vary], *(values / 2)]) if vary in FROM_LOWER_END else float(p[vary])
    ahead = values[forward * (values - start) >= 0]
    if not ahead.size:
        return math.nan, math.nan
    last, high = forward * float((forward * ahead).max()), RANGES[vary].high
    end = last / 2 if forward < 0 else 2 * last + 1 if math.isinf(high) else (last + high) / 2
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
    for here, given in _blocks(p):
        yes = out[here]
        yes[:], left = _decided(given)
        if left.size:
            yes[left] = _at_or_below(Parameters(**selected_rows(given, left)), vary)
    return out.reshape(p.shape)


def _at_or_below(p: Parameters, vary: str) -> FloatArray:
    """1 where the jump of a point is at or below its own value, else 0; NaN where that is not
    known.
    """
    found = first_jumps(p, vary, sides=True)
    unknown = np.zeros(found.value.size)
    unknown[list(found.reasons)] = np.nan
    return np.asarray((found.value <= p[vary]) + unknown.reshape(found.value.shape))


def with_and_without_friction(
    given: dict[str, FloatArray],
) -> tuple[Equilibria, Equilibria, IndexArray, FloatArray, FloatArray, BoolArray]:
    """Equilibria of points without friction and with theirs; the slot and θ of the state that
    begins, the first θ from there on among those with friction, and where all this is known.
    """
    bare, full = (
        equilibria(Parameters(**given | {"mu0": share * given["mu0"]})) for share in (0.0, 1.0)
    )
    slot = small(bare)[:, None]
    first = np.take_along_axis(bare.theta, slot, axis=-1)
    later = np.where(full.theta >= first, full.theta, np.inf).min(axis=-1)
    return bare, full, slot, first, later, np.isfinite(later) & bare.decided & full.decided


def _decided(given: dict[str, FloatArray]) -> tuple[FloatArray, IndexArray]:
    """1 for points that have jumped, else 0, and those of which the signs do not tell."""
    bare, full, slot, first, later, clear = with_and_without_friction(given)
    error, kind = (np.take_along_axis(one, slot, axis=-1) for one in (bare.error, bare.undamped))
    # Radians between an equilibrium and the state without friction below which float64 does
    # not say which comes first.
    near = (np.abs(full.theta - first) <= 1e-9).any(axis=-1)
    clear &= ~near & (kind[:, 0] == EquilibriumType.STABLE) & ~bare.fold & ~full.fold
    ends = [_place(np.where(clear, angle, 1.0)) for angle in (first[:, 0], later)]
    # An error is one over max(1, θ), and dw/dθ is less than 1; a few units in the last place are
    # the rounding of w.
    off = (
        np.where(
            clear,
            4.0 * np.maximum(error[:, 0], np.nan_to_num(full.error, nan=0.0).max(axis=-1)),
            0.0,
        )
        + 8 * UNIT
    )
    signs = bernstein.signs_between(friction_sextic(given), ends[0], np.maximum(*ends), off)
    # Where it falls at the beginning the state moves the other way as the friction rises.
    clear &= signs.at_low < 0
    left = ~(clear & (signs.negative | signs.positive)) & (given["mu0"] > 0)
    return np.where(clear & signs.positive, 1.0, 0.0), np.flatnonzero(left)


def _place(theta: FloatArray) -> FloatArray:
    """w = t/(t + τ) with t = tan(θ/2)."""
    s, c = np.sin(0.5 * theta), np.cos(0.5 * theta)
    return s / (s + bernstein.SCALE * c)
