"""A box of coordinates that holds all equilibria: springs to ground and inclined springs pull back
harder than all else pushes.

A spring's force is its stiffness times the vector between its ends, linear in the coordinates, less
its stiffness times its undeformed length along a unit vector, which is bounded. So with unit
vectors left free in [−1, 1]² the balance bounds the coordinates.

A torsion spring pulls across its line with k_t φ/l, |φ| ≤ π. Either l is less than 1
(:data:`LEVER_LENGTH`), and the mass is that near to the anchor, or the force is at most k_t π, and
the coordinates are bounded as without it. The hull of both holds all equilibria.

Where the gap of a contact is an expression, it has both signs over a wide box, and a law that
hardens makes a large negative force of depths that no state in contact has. There the depth is cut
off at 0, and at what the gaps of other contacts leave, and the contact's force is a number of its
own beside the forces of lift-off. So no slope is needed of what is cut off, which has none at the
border.
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

#: The plane, as far as it is looked at.
FARTHEST = 1e60
#: Length of the line of a torsion spring from which on its force is bounded, in units of the scale
#: of length.
LEVER_LENGTH = 1.0


def region(
    balance: Balance, bounds: Intervals, asked: FloatArray | None = None
) -> tuple[FloatArray, BoolArray]:
    """A box for each point, as −low and high, shape (2, n, N), and whether each is proved to hold
    all equilibria of its point.

    ``bounds`` are parameters, shape (P, N), ``asked`` is the box from :func:`requested_region`.
    """
    ends, proved = _by_forces(balance, bounds)
    # Ends of the cells of a coordinate, on either side of 0, and of more where these tell nothing.
    few = (*(10.0**k for k in range(-6, 5)), 1e8, 1e15, 1e30)
    many = tuple(10.0**k for k in (*range(-12, 19), 24, 32, 42))
    for step in (partial(_by_cells, few), partial(_by_cells, many), _in_pieces):
        open_ = np.flatnonzero(~proved)
        if not open_.size:
            break
        ends[:, :, open_], proved[open_] = step(balance, bounds[:, open_], ends[:, :, open_])
    wider = np.minimum(
        np.where(np.isfinite(ends), rounded_outward(ends + 1e-6), ends), balance.border[:, :, None]
    )
    if asked is None:
        return wider, proved
    box = np.minimum(asked, balance.border)[:, :, None]
    if (width_of(box) < 0).any():
        raise ParameterError(
            "within lies beyond the border of the contact, where none of these states is; widen it"
        )
    whole: BoolArray = proved & (wider <= box).all(axis=(0, 1))
    given = np.asarray(np.isfinite(asked).all(axis=0))[:, None]
    both = np.minimum(wider, box)
    # Where the forces bound nothing, and where they show that nothing is in the box, it is looked
    # at as it is.
    apart = ~proved | (width_of(both) < 0).any(axis=0)
    return np.where(given & apart, box, both), whole


def requested_region(model: Model, within: Ranges | None) -> FloatArray | None:
    """``within={"x": (-5, 5)}`` as −low and high, shape (2, n), infinite where nothing is asked."""
    if within is None:
        return None
    places = {name: model.any_of(name) for name in model.coordinates}
    given = as_ranges("within", within, places)
    low, high = np.array([given.get(name, (-np.inf, np.inf)) for name in places]).T
    return np.stack([-low, high])


def _by_forces(balance: Balance, bounds: Intervals) -> tuple[FloatArray, BoolArray]:
    """Bounds of all equilibria by their forces, and where there are any."""
    with quiet():
        parameters = balance.prepared(bounds)
        border = np.broadcast_to(balance.border[:, :, None], (2, balance.n, bounds.shape[1]))
        # A force that nothing can balance, wherever the mass is: the sum of a row that is NaN holds
        # everything.
        ends, nowhere = _squeezed(
            balance, parameters, np.minimum(FARTHEST, border), balance.options.rounds
        )
        ends = _with_anchors(balance, parameters, ends, nowhere)
    return ends, _bounded(ends)


def _by_cells(
    cells: Sequence[float], balance: Balance, bounds: Intervals, outer: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Bounds as by forces, each the hull of those over the cells of one coordinate; and where there
    are any.

    A slope that is known over no large box, as of a bell of the gap, is known over a cell:
    constructive interval disjunction.
    """
    ends, options = outer.copy(), balance.options
    # Points that lie together are proved together where that succeeds: first all of them, then
    # halves.
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
    """The points of a group on either side of the middle in the parameter that varies most in
    it.
    """
    middles = bounds.middle[:, group]
    widths = np.ptp(middles, axis=1) / np.maximum(np.abs(middles).max(axis=1), TINY)
    order = group[np.argsort(middles[widths.argmax()], kind="stable")]
    return [order[: order.size // 2], order[order.size // 2 :]]


def _cut_in_cells(
    cells: Sequence[float], balance: Balance, bounds: Intervals, ends: FloatArray
) -> FloatArray:
    """Smaller boxes with the same states: each coordinate in turn is cut into cells."""
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
                some = np.flatnonzero((width_of(parts) >= 0).all(axis=0))
                point, parts = point[some], parts[:, :, some]
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
    """Smaller boxes with the same states, with all directions free, and boxes that are seen to have
    none.
    """
    at = replace(
        balance.state(Intervals(ends), parameters),
        fixed=_any_direction(balance, ends.shape[2]),
    )
    empty = ~np.logical_and.reduce(balance.residuals(Intervals(ends), parameters).holds_zero())
    empty |= at.beside_border()[1]
    steps = [balance.by_rows, balance.with_directions]
    if balance.model.about.get("waves"):
        # Cosines and sines of the coordinates as free unknowns, as directions are.
        steps += [partial(_with_free_waves, step) for step in tuple(steps)]
    if pressed := _presses(balance):
        steps += [partial(_closed, contact=contact) for contact in pressed]
        steps.append(partial(_by_contact_force, known={}))
    for _ in range(rounds):
        before = ends
        for step in steps:
            less = step(replace(at, q=list(Intervals(ends))))
            gone = np.logical_or.reduce(width_of(less) < 0)
            empty |= gone
            ends = np.where(gone, ends, less)
        widths, widths_before = width_of(ends), width_of(before)
        # Where some are not bounded yet, less counts as well.
        stalled = balance.options.stalled if (ends < FARTHEST * 1e-6).all() else 0.999
        if (widths >= stalled * widths_before).all():
            break
    return ends, empty


def _with_free_waves(step: Callable[[Evaluation], FloatArray], at: Evaluation) -> FloatArray:
    return step(replace(at, xp=FREE))


def _with_anchors(
    balance: Balance, parameters: Intervals, ends: FloatArray, nowhere: BoolArray
) -> FloatArray:
    """Boxes that hold what lies near the anchors of torsion springs too, and small ones where there
    is nothing.
    """
    border = balance.border[:, :, None]
    ends = np.where(nowhere, np.minimum(balance.options.near, border), ends)
    at = balance.state(Intervals(ends), parameters)
    return np.maximum(ends, _near_anchors(at, ends))


def _bounded(ends: FloatArray) -> BoolArray:
    return np.logical_and.reduce(ends < FARTHEST * 1e-6, axis=(0, 1))


def _in_pieces(
    balance: Balance, bounds: Intervals, outer: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Regions of boxes of parameters, as hulls over parts of these; by scales where there is no
    bound.
    """
    count = bounds.shape[1]
    bounded = outer < FARTHEST * 1e-6
    near = np.maximum(
        balance.options.near * _scales(balance, bounds),
        # what is known to lie far away is looked for beyond that
        np.where(bounded, -10 * outer, 0.0)[::-1],
    )
    by_scales = np.where(bounded, outer, np.minimum(near, balance.border[:, :, None]))
    hulls = np.full((2, balance.n, count), -np.inf)
    left, owner = bounds, np.arange(count)
    most = balance.options.halvings
    for depth in range(most + 1):
        wide = np.flatnonzero((left.low < left.high).any(axis=1))
        if not wide.size or not owner.size or depth == most:
            break
        left, owner = halved(left, int(wide[depth % wide.size])), np.repeat(owner, 2)
        ends, proved = _by_forces(balance, left)
        hulls = np.maximum(hulls, hulls_of(ends[:, :, proved], owner[proved], count))
        left, owner = left[:, ~proved], owner[~proved]
    done = np.isin(np.arange(count), owner, invert=True)
    # Proved parts of a range widen the region, but not without a bound.
    return np.where(done, hulls, np.maximum(by_scales, np.minimum(hulls, 10 * by_scales))), done


def halved(bounds: Intervals, row: int) -> Intervals:
    """Both halves of each box in one parameter, side by side."""
    ends = np.repeat(bounds.ends, 2, axis=2)
    middle = bounds.middle[row]
    ends[1, row, ::2], ends[0, row, 1::2] = middle, -middle
    return Intervals(ends)


def _scales(balance: Balance, bounds: Intervals) -> FloatArray:
    """The largest length of the model at each point: of springs, to anchors, to equilibria; and >=
    1, unless all that is known is far smaller, as in another unit.

    Forces balance where Newton's method has come to rest, from 0 and from steps of the lengths
    along each coordinate; where it has not, it tells nothing.
    """
    scale, none = np.zeros(bounds.shape[1]), np.zeros((balance.n, 1))
    # Ahead and back along each of the coordinates.
    ways = np.concatenate([step * np.eye(balance.n) for step in (1, -1, 10, -10, 100, -100)])
    with quiet():
        # Bound on lengths of the model: a machine's, told in nanometres.
        farthest = 1e12
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
            for number, way in enumerate((none, *ways)):
                near = balance.guessed(way.reshape(-1, 1) * reach + origin, parameters)
                guess = balance.guessed(near, parameters)
                rests = np.abs(guess - near).max(axis=0) <= 1e-9 * np.abs(guess).max(axis=0)
                size = np.abs(guess).max(axis=0)
                scale = np.where(rests & (size < farthest), np.maximum(scale, size), scale)
                if number == 0:
                    # In another unit steps are those of the state that is nearest to 0.
                    reach = np.where(is_in_another_unit(scale), scale, reach)
    # A page in SI units may have states of nanometres.
    return np.where(scale > 0, np.maximum(scale, np.minimum(1.0, 10 * scale)), 1.0)


def _any_direction(balance: Balance, count: int) -> list[Intervals]:
    """Cosines, sines and lengths of all lines, and angles by which torsion springs turn, as far as
    they can be.
    """
    directions = [Intervals(np.ones((2, count))) for _ in range(3 * balance.springs)]
    for index in range(balance.springs):
        shortest = LEVER_LENGTH if index in balance.torsions else 0.0
        directions[3 * index + 2] = Intervals.between(np.full(count, shortest), FARTHEST)
    return directions + [Intervals(np.full((2, count), HALF_TURN)) for _ in balance.torsions]


def _near_anchors(at: Evaluation, ends: FloatArray) -> FloatArray:
    """Hull of the places where a torsion spring's line is shorter than :data:`LEVER_LENGTH`;
    without bounds where that is not known.
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
            hull[:, index] = np.maximum(hull[:, index], rounded_outward(end.ends + LEVER_LENGTH))
    return np.minimum(hull, balance.border[:, :, None])


@dataclass(frozen=True)
class _Pressed:
    """``pushing`` = 1 in generated functions, whose depth (1 − pushing)² TOUCH − pushing · gap is
    then cut off at ``limits``.
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
    """1 − pushing and multiples of its square: 0, which cuts off at ``limits`` what it is added
    to.
    """

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
    """Region with what is beyond limits moved there: the limit alone of what lies beyond as a
    whole.
    """
    low, high = (np.clip(end, limits.low, limits.high) for end in (value.low, value.high))
    return Intervals.between(low, high)


def _presses(balance: Forces) -> list[int]:
    """Contacts that open and touch, whose gaps are expressions."""
    return [
        k
        for k, touches in zip(balance.opens, balance.closed, strict=True)
        if touches
        and balance.model.contacts[k]["unilateral"]
        and balance.model.contacts[k]["gap"] not in balance.coordinates
    ]


def _by_contact_force(at: Evaluation, known: dict[int, Intervals]) -> FloatArray:
    """Smaller boxes with the same states in contact: each coordinate from its row, with cosines and
    sines left free; of no width where no force of a contact balances all rows.

    ``known`` keeps the directions of forces over boxes that hold these.
    """
    at = replace(at, xp=FREE)
    shape, pressed = at.shape, _presses(at.balance)
    lifted = [0 if k in pressed else one for k, one in enumerate(at.balance.pushing)]
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
    given = sum((along[k] * forces[k] for k in pressed), at_near), slopes, near, reach
    found: FloatArray = np.fmin(contractors.by_rows(*given), contractors.newton(*given).ends)
    return np.where(none, -np.inf, np.fmin(found, at.box.ends))


def _force_of(at: Evaluation, contact: int) -> Intervals:
    """Bounds of a contact's force by those of its penetration, from that at which states beyond its
    border count.
    """
    slack = _slack(at.balance, contact)
    least = np.full(at.shape, -slack)
    limits = Intervals.between(least, np.maximum(_deepest(at, contact), least))
    force = as_intervals(at.contact_force(contact, _Pressed(limits)), at.shape)
    by_depth = _stiffness(at, contact) * limits
    low, high = (np.nan_to_num(end, nan=np.inf, posinf=np.inf) for end in by_depth.ends)
    return _cut_off(force, Intervals.between(-low if slack else np.maximum(-low, 0.0), high))


def _slack(balance: Forces, contact: int) -> float:
    """How far beyond the border of a contact states count."""
    return balance.slacks[balance.opens.index(contact)]


def _deepest(at: Evaluation, contact: int) -> FloatArray:
    """Largest penetration of a contact that the others leave: where the sum of its gap and that of
    one which touches is a number, as of two faces of a slot, or the difference from one that is
    open.
    """
    balance, most = at.balance, np.full(at.shape, np.inf)
    if len(balance.opens) < 2:
        return most
    near, own = at.box.nearest_to_zero, balance.opens.index(contact)
    values, slopes, *_ = linear(at, near, Evaluation.gaps)
    shift = at.box - Intervals.point(near)
    for row, other in enumerate(balance.opens):
        if other != contact:
            sign = 1 if balance.pushing[other] else -1
            along = slopes[own] + slopes[row] * sign
            total = sum(map(mul, along, shift), values[own] + values[row] * sign)
            slack = Intervals.point(np.full(at.shape, balance.slacks[row]))
            most = np.fmin(most, (slack - total).high)
    return most


def _stiffness(at: Evaluation, contact: int) -> Intervals:
    """Force of a contact over its penetration where both are linear in the coordinates, else
    anything.
    """
    moved = replace(at, q=jets.variables(at.q, 2))
    parts = moved.contact_force(contact, 1), moved.gap(contact)
    anything = Intervals(np.full((2, *at.shape), np.inf))
    if not all(isinstance(part, jets.Jet) and jets.is_linear(part) for part in parts):
        return anything
    force, gap = (jets.gradient(part, len(at.q)) for part in parts)
    index = next((i for i, slope in enumerate(gap) if not is_zero(slope)), None)
    return anything if index is None else as_intervals(-force[index] / gap[index], at.shape)


def _along_force(at: Evaluation, contact: int, lifted: Sequence[int]) -> Intervals:
    """How much of a contact's force goes along each coordinate, with cosines and sines left free;
    NaN where that is not known.

    A force that does not vanish at the touch is not 0 where pushing begins: there the slopes of
    rows and force by pushing have this ratio. One that is linear in the gap is: but along a
    coordinate in which force and rows are linear, and the direction therefore constant, their
    slopes have it too.
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
    """Smaller boxes with all points of a gap ≤ 0, or as far beyond as states count: each coordinate
    from the gap's slopes by it and the others.
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


def _balancing(force: Intervals, apart: Intervals, along: Intervals) -> tuple[Intervals, BoolArray]:
    """Bounds of the contact's force by its balance with the others in each row that it has a known
    direction in, and where no force balances all of them.
    """
    ends, none = force.ends, np.zeros(force.shape, dtype=bool)
    for row in range(apart.shape[0]):
        both = np.fmin(ends, (-apart[row] / along[row]).ends)
        apart_from = width_of(both) < 0
        none |= apart_from
        ends = np.where(apart_from, ends, both)
    return Intervals(ends), none
