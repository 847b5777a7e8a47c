"""A box of coordinates that is proved to hold all equilibria of a model.

The force of a spring is its stiffness times the vector between its ends, which is linear in the
coordinates, minus its stiffness times its undeformed length along a unit vector. Free unit vectors
in [−1, 1]² replace the directions. Far away, the linear forces of the springs are larger than all
others, so that the balance bounds the coordinates.

A torsion spring of a line of length l acts across the line with the force k_t φ/l, |φ| ≤ π. If l is
at least 1, the scale of length, this force is bounded too. Otherwise the mass is near the anchor.
The region is the hull of both cases.

A gap that is an expression has both signs over a wide box. A hardening contact law would there give
a large force of the wrong sign, for depths that no state in contact has. So the depth is cut off at
0, and at what the gaps of other contacts allow, and the contact's force becomes an unknown of its
own beside the forces without contact. No derivative of the cut-off depth is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from operator import mul
from typing import Any

import numpy as np

from ..core.errors import ParameterError
from ..models.model import Model
from ..models.parameters import Ranges, as_ranges
from ..numerics import contractors, jets
from ..numerics.arithmetic import Number, is_zero
from ..numerics.interval_arrays import (
    HALF_TURN,
    TINY,
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    hulls_of,
    is_in_another_unit,
    quiet,
    rounded_outward,
    stacked,
    width_of,
)
from .balance import Balance
from .forces import Evaluation, Forces, as_intervals
from .namespaces import FREE
from .systems import linear

#: Coordinates are searched up to this size; a smaller bound counts as proved.
FARTHEST = 1e60


def region(
    balance: Balance,
    bounds: Intervals,
    requested: FloatArray | None = None,
    *,
    in_pieces: bool = True,
) -> tuple[FloatArray, BoolArray]:
    """A box for each point, −low and high of shape (2, n, N), and where it is proved to hold all
    equilibria.

    ``bounds`` are parameters, shape (P, N), and ``requested`` is the box of
    :func:`requested_region`. Only ``in_pieces`` are boxes of parameters halved for a proof, which
    takes longest; else the box may be infinite where nothing is proved.
    """
    ends, proved = _by_forces(balance, bounds)
    # Edges of cells of a coordinate on either side of 0: first a few, then many.
    few = (*(10.0**k for k in range(-6, 5)), 1e8, 1e15, 1e30)
    many = tuple(10.0**k for k in (*range(-12, 19), 24, 32, 42))
    last = (_in_pieces,) if in_pieces else ()
    for step in (partial(_by_cells, few), partial(_by_cells, many), *last):
        open_ = np.flatnonzero(~proved)
        if not open_.size:
            break
        ends[:, :, open_], proved[open_] = step(balance, bounds[:, open_], ends[:, :, open_])
    wider = np.minimum(
        np.where(np.isfinite(ends), rounded_outward(ends + 1e-6), ends), balance.border[:, :, None]
    )
    if requested is None:
        return wider, proved
    box = np.minimum(requested, balance.border)[:, :, None]
    if (width_of(box) < 0).any():
        raise ParameterError(
            "within lies beyond the border of the contact, where none of these states is; widen it"
        )
    whole: BoolArray = proved & (wider <= box).all(axis=(0, 1))
    given = np.asarray(np.isfinite(requested).all(axis=0))[:, None]
    both = np.minimum(wider, box)
    # The user's box is searched as it is where no bound is proved, and where none of it is within
    # the bound.
    unbounded = ~proved | (width_of(both) < 0).any(axis=0)
    return np.where(given & unbounded, box, both), whole


def requested_region(model: Model, within: Ranges | None) -> FloatArray | None:
    """The argument ``within={"x": (-5, 5)}`` as −low and high, shape (2, n); infinite where not
    given, None if ``within`` is.
    """
    if within is None:
        return None
    places = {name: model.any_of(name) for name in model.coordinates}
    given = as_ranges("within", within, places)
    low, high = np.array([given.get(name, (-np.inf, np.inf)) for name in places]).T
    return np.stack([-low, high])


def _by_forces(balance: Balance, bounds: Intervals) -> tuple[FloatArray, BoolArray]:
    """Bounds of all equilibria from the balance of forces over one large box, and where they are
    finite.
    """
    with quiet():
        parameters = balance.prepared(bounds)
        border = np.broadcast_to(balance.border[:, :, None], (2, balance.n, bounds.shape[1]))
        ends, nowhere = _squeezed(
            balance, parameters, np.minimum(FARTHEST, border), balance.options.rounds
        )
        ends = _with_anchors(balance, parameters, ends, nowhere)
    return ends, _bounded(ends)


def _by_cells(
    cells: Sequence[float], balance: Balance, bounds: Intervals, outer: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Bounds as by :func:`_by_forces`, but the hull over cells of each coordinate, and where they
    are finite.

    This is constructive interval disjunction: a slope that is unbounded over a large box, as that
    of a bell-shaped law, is bounded over a cell. ``cells`` are the positive edges of cells.
    """
    ends, options = outer.copy(), balance.options
    # One proof serves a group of points where it succeeds: first of all points, then of halves.
    groups, depth = [np.arange(bounds.shape[1])], 0
    while groups:
        hulls = np.array(
            [[-bounds.low[:, g].min(axis=1), bounds.high[:, g].max(axis=1)] for g in groups]
        )
        over = Intervals(np.moveaxis(hulls, 0, -1))
        starts = np.stack([ends[:, :, g].max(axis=2) for g in groups], axis=2)
        found = _cut_in_cells(cells, balance, over, starts)
        open_ = []
        for group, good, column in zip(groups, _bounded(found), range(len(groups)), strict=True):
            if good or group.size == 1:
                ends[:, :, group] = np.fmin(ends[:, :, group], found[:, :, column, None])
            else:
                open_.append(group)
        depth += 1
        if depth > options.halvings:
            break
        groups = [half for group in open_ for half in _in_halves(bounds, group)]
    return ends, _bounded(ends)


def _in_halves(bounds: Intervals, group: IntArray) -> list[IntArray]:
    """A group of points in two halves, by the parameter that varies most within it."""
    middles = bounds.middle[:, group]
    widths = np.ptp(middles, axis=1) / np.maximum(np.abs(middles).max(axis=1), TINY)
    order = group[np.argsort(middles[widths.argmax()], kind="stable")]
    return [order[: order.size // 2], order[order.size // 2 :]]


def _cut_in_cells(
    cells: Sequence[float], balance: Balance, bounds: Intervals, ends: FloatArray
) -> FloatArray:
    """Contracted boxes with the same states; each coordinate in turn is cut into cells, and each
    cell contracted.
    """
    count = bounds.shape[1]
    edges = np.array([-FARTHEST, *(-edge for edge in cells[::-1]), *cells, FARTHEST])
    low, high = edges[:-1], edges[1:]
    with quiet():
        parameters = balance.prepared(bounds)
        nowhere = np.zeros(count, dtype=bool)
        for _ in range(balance.options.sweeps):
            before = ends
            for index in range(balance.n):
                point, cell = np.divmod(np.arange(count * low.size), low.size)
                parts = ends[:, :, point]
                parts[0, index] = np.minimum(parts[0, index], -low[cell])
                parts[1, index] = np.minimum(parts[1, index], high[cell])
                nonempty = np.flatnonzero((width_of(parts) >= 0).all(axis=0))
                point, parts = point[nonempty], parts[:, :, nonempty]
                rounds = balance.options.cell_rounds
                parts, empty = _squeezed(balance, parameters[:, point], parts, rounds)
                hull = hulls_of(parts[:, :, ~empty], point[~empty], count)
                none = np.isneginf(hull).any(axis=(0, 1))
                nowhere |= none
                ends = np.where(none, ends, np.fmin(ends, hull))
            if (width_of(ends) >= balance.options.stalled * width_of(before)).all():
                break
        return _with_anchors(balance, parameters, ends, nowhere)


def _squeezed(
    balance: Balance, parameters: Intervals, ends: FloatArray, rounds: int
) -> tuple[FloatArray, BoolArray]:
    """Contracted boxes with the same states, for any directions of springs; and which are empty."""
    at = replace(
        balance.state(Intervals(ends), parameters),
        fixed=_any_direction(balance, ends.shape[2]),
    )
    empty = ~np.logical_and.reduce(balance.residuals(Intervals(ends), parameters).holds_zero())
    empty |= at.beside_border()[1]
    steps = [balance.by_rows, balance.with_directions]
    if balance.model.about.get("waves"):
        steps += [partial(_with_free_waves, step) for step in tuple(steps)]
    if pressed := _presses(balance):
        steps += [partial(_closed, contact=contact) for contact in pressed]
        steps.append(partial(_by_contact_force, known={}))
    for _ in range(rounds):
        before = ends
        for step in steps:
            contracted = step(replace(at, q=list(Intervals(ends))))
            gone = np.logical_or.reduce(width_of(contracted) < 0)
            empty |= gone
            ends = np.where(gone, ends, contracted)
        widths, widths_before = width_of(ends), width_of(before)
        # Slower progress is enough as long as an end is not bounded.
        stalled = balance.options.stalled if (ends < FARTHEST * 1e-6).all() else 0.999
        if (widths >= stalled * widths_before).all():
            break
    return ends, empty


def _with_free_waves(step: Callable[[Evaluation], FloatArray], at: Evaluation) -> FloatArray:
    """A contraction step in which cosines and sines of coordinates are free unknowns in [−1, 1]."""
    return step(replace(at, xp=FREE))


def _with_anchors(
    balance: Balance, parameters: Intervals, ends: FloatArray, nowhere: BoolArray
) -> FloatArray:
    """The boxes, widened to hold the neighbourhoods of torsion springs' anchors too.

    Boxes proved to be empty (``nowhere``) are replaced by small ones.
    """
    border = balance.border[:, :, None]
    ends = np.where(nowhere, np.minimum(balance.options.near, border), ends)
    at = balance.state(Intervals(ends), parameters)
    return np.maximum(ends, _near_anchors(at, ends))


def _bounded(ends: FloatArray) -> BoolArray:
    """Where a region is bounded: all its ends are far below :data:`FARTHEST`."""
    return np.logical_and.reduce(ends < FARTHEST * 1e-6, axis=(0, 1))


def _in_pieces(
    balance: Balance, bounds: Intervals, outer: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Bounds for boxes of parameters that no single proof covers: the hull over halves of the
    boxes.

    Where that fails too, the region follows from the lengths of the model, without a proof.
    """
    count = bounds.shape[1]
    bounded = outer < FARTHEST * 1e-6
    near = np.maximum(
        balance.options.near * lengths(balance, bounds),
        # a bound that excludes a neighbourhood of 0: states are farther away
        np.where(bounded, -10 * outer, 0.0)[::-1],
    )
    by_scales = np.where(bounded, outer, np.minimum(near, balance.border[:, :, None]))
    hulls = np.full((2, balance.n, count), -np.inf)
    open_, owner = bounds, np.arange(count)
    most = balance.options.halvings
    for depth in range(most + 1):
        wide = np.flatnonzero((open_.low < open_.high).any(axis=1))
        if not wide.size or not owner.size or depth == most:
            break
        open_, owner = halved(open_, int(wide[depth % wide.size])), np.repeat(owner, 2)
        ends, proved = _by_forces(balance, open_)
        hulls = np.maximum(hulls, hulls_of(ends[:, :, proved], owner[proved], count))
        open_, owner = open_[:, ~proved], owner[~proved]
    done = np.isin(np.arange(count), owner, invert=True)
    # Regions of proved pieces widen that of an unproved box, but at most tenfold.
    return np.where(done, hulls, np.maximum(by_scales, np.minimum(hulls, 10 * by_scales))), done


def halved(bounds: Intervals, row: int) -> Intervals:
    """Both halves of each box, cut in parameter number ``row``, side by side."""
    ends = np.repeat(bounds.ends, 2, axis=2)
    middle = bounds.middle[row]
    ends[1, row, ::2], ends[0, row, 1::2] = middle, -middle
    return Intervals(ends)


def lengths(balance: Balance, bounds: Intervals) -> FloatArray:
    """The largest known length at each point: of springs, to their anchors, or to an equilibrium.

    At least 1, unless all lengths are far smaller, as in another unit. Equilibria are those at
    which Newton's method converges, started from 0 and from ±1, ±10 and ±100 lengths along each
    coordinate.
    """
    scale, zero = np.zeros(bounds.shape[1]), np.zeros((balance.n, 1))
    steps = np.concatenate([step * np.eye(balance.n) for step in (1, -1, 10, -10, 100, -100)])
    with quiet():
        farthest = 1e12  # no larger length is believed: this is a machine's, in nanometres
        for given in (bounds.low, bounds.middle, bounds.high):
            parameters = balance.prepared_at(given)
            origin = np.zeros((balance.n, bounds.shape[1]))
            lengths = [
                part
                for line in balance.state(Intervals.point(origin), parameters).geometry
                for part in line
            ]
            sizes = stacked(lengths, scale.shape).magnitude
            lines = np.where(sizes < farthest, sizes, 0.0).max(axis=0, initial=0.0)
            scale = np.maximum(scale, lines)
            reach = np.maximum(lines, 1.0)
            for number, step in enumerate((zero, *steps)):
                near = balance.guessed(step.reshape(-1, 1) * reach + origin, parameters)
                guess = balance.guessed(near, parameters)
                size = np.abs(guess).max(axis=0)
                converged = np.abs(guess - near).max(axis=0) <= 1e-9 * size
                scale = np.where(converged & (size < farthest), np.maximum(scale, size), scale)
                if number == 0:
                    # In another unit, the state found from 0 sets the length of the steps.
                    reach = np.where(is_in_another_unit(scale), scale, reach)
    # A page in SI units may have states of nanometres.
    return np.where(scale > 0, np.maximum(scale, np.minimum(1.0, 10 * scale)), 1.0)


def _any_direction(balance: Balance, count: int) -> list[Intervals]:
    """Free directions: cosines, sines and lengths of all lines, and torsion angles, in their full
    ranges.
    """
    directions = [Intervals(np.ones((2, count))) for _ in range(3 * balance.springs)]
    for index in range(balance.springs):
        shortest = 1.0 if index in balance.torsions else 0.0
        directions[3 * index + 2] = Intervals.between(np.full(count, shortest), FARTHEST)
    return directions + [Intervals(np.full((2, count), HALF_TURN)) for _ in balance.torsions]


def _near_anchors(at: Evaluation, ends: FloatArray) -> FloatArray:
    """Hull of the points where a torsion spring's line is shorter than 1; infinite where that is
    not known.
    """
    balance = at.balance
    hull = np.full(ends.shape, -np.inf)
    for spring in balance.torsions:
        chart = balance.model.about["springs"][spring]["chart"]
        places = [balance.coordinates.index(name) for name in chart or ()]
        if len(places) < balance.n:
            hull[:] = np.inf
            break
        q = [0] * balance.n
        anchor = replace(at, q=q).anchors[spring]
        for index, end in zip(places, anchor, strict=True):
            hull[:, index] = np.maximum(hull[:, index], rounded_outward(end.ends + 1.0))
    return np.minimum(hull, balance.border[:, :, None])


@dataclass(frozen=True)
class _Pressed:
    """The contact indicator ``pushing`` = 1, passed to generated functions, that cuts off their
    depth.

    Their depth is (1 − pushing)² TOUCH − pushing · gap; with this object it is −gap, cut off at
    ``limits``.
    """

    limits: Intervals

    def __mul__(self, other: Number) -> Number:
        return other

    __rmul__ = __mul__

    def __neg__(self) -> int:
        return -1  # as of −pushing · gap, which is the depth where it presses

    def __rsub__(self, one: int) -> _Nothing:
        return _Nothing(self.limits)


@dataclass(frozen=True)
class _Nothing:
    """The term (1 − pushing)² TOUCH: 0, but what it is added to is cut off at ``limits``."""

    limits: Intervals

    def __mul__(self, other: Number) -> _Nothing:
        return self

    def __truediv__(self, other: int) -> _Nothing:
        return self

    def __add__(self, depth: Intervals) -> Intervals:
        return _cut_off(depth, self.limits)

    def __sub__(self, gap: Intervals) -> Intervals:
        return self + -gap

    __radd__ = __add__


def _cut_off(value: Intervals, limits: Intervals) -> Intervals:
    """Intervals with their ends clipped to ``limits``, so that they lie inside of them."""
    low, high = (np.clip(end, limits.low, limits.high) for end in (value.low, value.high))
    return Intervals.between(low, high)


def _presses(balance: Forces) -> list[int]:
    """Numbers of the touching contacts that can open and whose gap is no coordinate."""
    return [
        k
        for k, touches in zip(balance.opens, balance.closed, strict=True)
        if touches
        and balance.model.contacts[k]["unilateral"]
        and balance.model.contacts[k]["gap"] not in balance.coordinates
    ]


def _by_contact_force(at: Evaluation, known: dict[int, Intervals]) -> FloatArray:
    """Contracted boxes with the same states in contact; of width < 0 where no contact force
    balances all rows.

    The contact forces are unknowns of their own, bounded first. Then each coordinate is bounded by
    its row; cosines and sines are free. ``known`` caches the directions of contact forces, which
    stay valid for smaller boxes.
    """
    at = replace(at, xp=FREE)
    shape, pressed = at.shape, _presses(at.balance)
    lifted = [0 if k in pressed else one for k, one in enumerate(at.balance.indicators)]
    along, forces = dict[int, Intervals](), dict[int, Intervals]()
    for k in pressed:
        along[k] = known[k] if k in known else _along_force(at, k, lifted)
        if np.isfinite(along[k].ends).all():
            known[k] = along[k]
        forces[k] = _force_of(at, k)
    apart = stacked(at.rows("forces", lifted), shape)
    none = np.zeros(shape, dtype=bool)
    for k in pressed:
        others = sum((along[j] * forces[j] for j in pressed if j != k), apart)
        forces[k], impossible = _balancing(forces[k], others, along[k])
        none |= impossible
    at_near, slopes, near, reach = linear(
        at, at.box.nearest_to_zero, lambda at: at.rows("forces", lifted)
    )
    rows = sum((along[k] * forces[k] for k in pressed), at_near), slopes, near, reach
    found: FloatArray = np.fmin(contractors.by_rows(*rows), contractors.newton(*rows).ends)
    return np.where(none, -np.inf, np.fmin(found, at.box.ends))


def _force_of(at: Evaluation, contact: int) -> Intervals:
    """Bounds of a contact's force, from bounds of its depth: −slack to the deepest that others
    allow.
    """
    slack = _slack(at.balance, contact)
    least = np.full(at.shape, -slack)
    limits = Intervals.between(least, np.maximum(_deepest(at, contact), least))
    force = as_intervals(at.contact_force(contact, _Pressed(limits)), at.shape)
    by_depth = _stiffness(at, contact) * limits
    low, high = (np.nan_to_num(end, nan=np.inf, posinf=np.inf) for end in by_depth.ends)
    return _cut_off(force, Intervals.between(-low if slack else np.maximum(-low, 0.0), high))


def _slack(balance: Forces, contact: int) -> float:
    """How far beyond the border of a contact states are accepted."""
    return balance.slacks[balance.opens.index(contact)]


def _deepest(at: Evaluation, contact: int) -> FloatArray:
    """Upper bound of a contact's depth, from the borders of the other contacts.

    The gaps of two faces of a slot have a constant sum: if one touches, the other's depth is
    bounded. With an open contact, the difference of gaps bounds it.
    """
    balance, most = at.balance, np.full(at.shape, np.inf)
    if len(balance.opens) < 2:
        return most
    near, own = at.box.nearest_to_zero, balance.opens.index(contact)
    values, slopes, *_ = linear(at, near, Evaluation.gaps)
    shift = at.box - Intervals.point(near)
    for row, other in enumerate(balance.opens):
        if other != contact:
            sign = 1 if balance.indicators[other] else -1
            along = slopes[own] + slopes[row] * sign
            total = sum(map(mul, along, shift), values[own] + values[row] * sign)
            slack = Intervals.point(np.full(at.shape, balance.slacks[row]))
            most = np.fmin(most, (slack - total).high)
    return most


def _stiffness(at: Evaluation, contact: int) -> Intervals:
    """Force over depth of a contact if both are linear in the coordinates, else [−∞, ∞]."""
    moved = replace(at, q=jets.variables(at.q, 2))
    parts = moved.contact_force(contact, 1), moved.gap(contact)
    anything = Intervals(np.full((2, *at.shape), np.inf))
    if not all(isinstance(part, jets.Jet) and jets.is_linear(part) for part in parts):
        return anything
    force, gap = (jets.gradient(part, len(at.q)) for part in parts)
    index = next((i for i, slope in enumerate(gap) if not is_zero(slope)), None)
    return anything if index is None else as_intervals(-force[index] / gap[index], at.shape)


def _along_force(at: Evaluation, contact: int, lifted: Sequence[int]) -> Intervals:
    """The direction of a contact's force: its share along each coordinate; NaN where unknown.

    Cosines and sines are free. The direction is the ratio of derivatives of rows and force by the
    contact indicator at ``pushing`` = 0. If the force vanishes at the touch, these derivatives may
    be 0. Then the mixed derivatives by a coordinate are used, if rows and force are linear in it,
    so that the direction is constant along it.
    """
    shape = at.shape
    pushing = jets.Jet.variable(Intervals(np.zeros((2, *shape))), 0, 3)

    def slopes(at: Evaluation, *variables: int) -> list[Any]:
        rows = at.rows("forces", [*lifted[:contact], pushing, *lifted[contact + 1 :]])
        parts = at.contact_force(contact, pushing), *rows
        return [one.derivative(*variables) if isinstance(one, jets.Jet) else 0 for one in parts]

    force, *rows = slopes(at, 0)
    if np.any(as_intervals(force, shape).holds_zero()):
        for index, value in enumerate(at.q):
            along = jets.Jet.variable(value, 1, 3)
            moved = replace(at, q=[*at.q[:index], along, *at.q[index + 1 :]])
            if all(map(is_zero, slopes(moved, 0, 1, 1))) and not is_zero(slopes(moved, 0, 1)[0]):
                force, *rows = slopes(moved, 0, 1)
                break
    return stacked([row / force for row in rows], shape)


def _closed(at: Evaluation, contact: int) -> FloatArray:
    """Contracted boxes that hold all points with gap ≤ slack, coordinate by coordinate, from the
    slopes of the gap.
    """
    near, ends = at.box.nearest_to_zero, at.box.ends
    at_near, slopes, *_ = linear(replace(at, xp=FREE), near, lambda at: [at.gap(contact)])
    shift, slack = at.box - Intervals.point(near), _slack(at.balance, contact)
    found = ends.copy()
    for index in range(len(at.q)):
        others = sum(
            (slopes[0, j] * shift[j] for j in range(len(at.q)) if j != index), at_near[0] - slack
        )
        most = Intervals.point(near[index]) - others / slopes[0, index]
        for side in (0, 1):  # where the gap grows towards that side
            grows = slopes.ends[1 - side, 0, index] < 0
            found[side, index] = np.where(
                grows, np.fmin(ends[side, index], most.ends[side]), ends[side, index]
            )
    return np.where(width_of(found) >= 0, found, ends)


def _balancing(
    force: Intervals, others: Intervals, along: Intervals
) -> tuple[Intervals, BoolArray]:
    """Bounds of a contact's force by its balance with all other forces, and where no force balances
    all rows.

    ``apart`` are the other forces and ``along`` the direction of this one, by row; a row with
    unknown direction gives no bound.
    """
    ends, none = force.ends, np.zeros(force.shape, dtype=bool)
    for row in range(others.shape[0]):
        both = np.fmin(ends, (-others[row] / along[row]).ends)
        conflict = width_of(both) < 0
        none |= conflict
        ends = np.where(conflict, ends, both)
    return Intervals(ends), none
