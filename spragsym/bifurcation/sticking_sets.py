"""Connected sets of sticking states with several frictions, or with other contacts that open, for
any forces.

With the coefficients μ_i = h_i μ_s,i a sticking state is an equilibrium at shares h in [−1, 1]ᵐ.
Cells of this box are halved until interval Newton proves, in each remaining box of coordinates, one
state for every h of the cell: a patch q(h) with the slopes

    ∂q/∂h_i = μ_s,i N_i K⁻¹ ∇a_i,

where friction i opposes the displacement a_i. N_i is positive inside of a contact, so that K⁻¹ ∇a_i
gives signs up to the border. A state on a border, where N_i is 0, stays there for all h_i. Patches
of neighbouring cells belong to one set if both hold the same state.

A coordinate is least where no share has a slope of known sign, or at an end of a share, or at a
border. By the signs of slopes patches are dropped, or reduced to an end of a share; others are
halved until bounds on the least value meet (branch and bound). Where states meet in folds over the
shares, there are no patches: boxes remain undecided, and bound the states that they may hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import combinations
from operator import add

import numpy as np

from ..core.errors import ConvergenceError, ModelError
from ..models.forces import named, presses_either
from ..models.model import Model, Touching
from ..models.parameters import ParameterSet
from ..numerics import certified_roots, contractors, jets
from ..numerics.columns import ByColumn, selected_rows
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    hulls_of,
    quiet,
    scale_of,
    stacked,
    width_of,
)
from ..results.points import StickingStates
from ..statics.balance import NEGLIGIBLE, Balance
from ..statics.forces import Evaluation, as_intervals
from ..statics.precise_balance import clusters
from ..statics.regions import region
from ..statics.search import columns, of_region
from .tubes import halves


@dataclass(frozen=True)
class Patches(ByColumn):
    """States over cells of shares; cells are ``low`` to ``high``, shape (m, N).

    The states lie in ``ends``, (2, n, N). If ``proved``, there is one for each point of the cell,
    the only one in ``alone``.
    """

    low: FloatArray
    high: FloatArray
    ends: FloatArray
    alone: FloatArray
    proved: BoolArray

    def __len__(self) -> int:
        return int(self.proved.size)

    def over(self, low: FloatArray, high: FloatArray) -> Patches:
        """The same states over other cells, parts of these."""
        return replace(self, low=low, high=high)

    def halved(self, weight: FloatArray) -> Patches:
        """Both parts of each cell, cut across its side of largest weight."""
        # Not in the middle: contacts just touch at simple shares too often.
        _, high, low = halves(self.low, self.high, weight, 0.4873)
        return self.over(self.low, high).concatenated(self.over(low, self.high))


class Touches:
    """The sticking states of one combination of touching contacts, over boxes of shares."""

    def __init__(self, model: Model, own: ParameterSet, key: Touching) -> None:
        shares = [name for name in own.ranges if name not in model.parameters]
        self.balance = balance = Balance(own.model, key, law="friction_at_speed")
        self.given = columns(own, balance.parameters)
        self.rows = [balance.parameters.index(name) for name in shares]
        self.closed = frozenset(k for k in balance.opens if balance.indicators[k])
        holding = [k for k, entry in enumerate(own.model.frictions) if entry["holds"]]
        #: Indices of the frictions that hold, and of their contacts; mask of borders by friction.
        self.holding = holding
        self.rubbed = [balance.contacts.index(own.model.frictions[k]["name"]) for k in holding]
        self.theirs = np.equal.outer(np.array(balance.opens, dtype=int), self.rubbed)
        self.out = [k not in self.closed for k in balance.opens]
        #: For each friction that holds, whether its contact presses on either of two faces.
        self.either = [presses_either(model.contacts[k]) for k in self.rubbed]

    @property
    def touches(self) -> bool:
        """Whether all contacts touch on which friction holds."""
        return all(self.balance.indicators[k] for k in self.rubbed)

    def bounds(self, low: FloatArray, high: FloatArray) -> Intervals:
        """All parameters over cells of shares."""
        every = Intervals.point(np.repeat(self.given, low.shape[1], axis=1))
        every.ends[:, self.rows] = -low, high
        return every

    def prepared(self, some: Patches) -> Intervals:
        """Arguments of the generated functions over the cells."""
        return self.balance.prepared(self.bounds(some.low, some.high))

    def state(self, some: Patches) -> Evaluation:
        """The evaluation at the states of patches."""
        return self.balance.state(Intervals(some.ends), self.prepared(some))

    def unused(self) -> Patches:
        """The origin of coordinates and of shares."""
        q, shares = np.zeros((2, self.balance.n, 1)), np.zeros((len(self.rows), 1))
        return Patches(shares, shares, q, q, np.zeros(1, dtype=bool))

    def searched(self, cells: Patches) -> tuple[Patches, IntArray]:
        """All states over cells within their boxes, as patches, with the index of the cell of each.

        A cell whose box has one state by interval Newton is a patch; other cells are searched.
        """
        whole, none = self.alone(cells)
        rest = np.flatnonzero(~whole.proved & ~none)
        found, cell = whole[whole.proved], np.flatnonzero(whole.proved)
        if not rest.size:
            return found, cell
        over = self.bounds(cells.low[:, rest], cells.high[:, rest])
        outcome = certified_roots.search(
            self.balance, cells.ends[:, :, rest], over.low, over.high, budget=100, narrow=2.0**-20
        )
        boxes, point = outcome.every
        hulls, owner = clusters(boxes, rest[point])
        others, none = self.alone(replace(cells[owner], ends=hulls, alone=hulls))
        return found.concatenated(others[~none]), np.concatenate([cell, owner[~none]])

    def alone(self, some: Patches) -> tuple[Patches, BoolArray]:
        """Patches that interval Newton proves in slightly wider boxes, and the mask of boxes
        without a state.
        """
        inflation = 0.3 * width_of(some.ends) + 2.0**-30 * scale_of(some.ends).max(axis=0)
        wide = some.ends + inflation
        step = certified_roots.stepped(self.balance, wide, self.prepared(some))
        proved = contractors.inside(step.ends, wide)
        ends = np.where(proved, step.ends, some.ends)
        made = replace(some, ends=ends, alone=wide, proved=proved)
        return self.narrowed(made), step.none

    def narrowed(self, some: Patches) -> Patches:
        """The patches with boxes narrowed by interval Newton."""
        at, ends = self.prepared(some), some.ends
        for _ in range(3):
            step = certified_roots.stepped(self.balance, ends, at).ends
            ends = np.where(some.proved, np.fmin(step, ends), ends)
        return replace(some, ends=ends)

    def gaps(self, some: Patches) -> Intervals:
        """Gaps of the contacts that open, (gaps, N), with the sign changed for open contacts.

        They are ≤ 0 where a state belongs to this combination.
        """
        gaps = stacked(self.state(some).gaps() or [0], some.proved.shape)
        ends = gaps.ends.copy()
        ends[:, self.out] = ends[::-1, self.out]
        return Intervals(ends)[: len(self.out)]

    def sides(self, some: Patches) -> tuple[BoolArray, BoolArray]:
        """Masks of patches whose states all belong to this combination, and of those of which none
        does.
        """
        gaps = self.gaps(some)
        return np.logical_and.reduce(gaps.high <= 0), np.logical_or.reduce(gaps.low > 0)

    def pressed(self, some: Patches) -> BoolArray:
        """Mask of patches with positive prescribed normal forces; ConvergenceError if a sign is not
        known.
        """
        at = self.state(some)
        none = np.zeros(len(some), dtype=bool)
        for k, either in zip(self.rubbed, self.either, strict=True):
            if either or self.balance.model.contacts[k]["gap"] is not None:
                continue
            force = as_intervals(at.contact_force(k, 1), none.shape)
            if ((force.low <= 0) & (force.high > NEGLIGIBLE)).any():
                raise ConvergenceError(
                    "the sign of a normal force is not known; change a parameter"
                )
            none |= force.low <= 0
        return ~none

    def pulls(self, some: Patches) -> Intervals:
        """μ_s N for every friction that holds, (m, N): the derivative of its force by the share.

        It differs from the limit of a law whose limits differ by direction.
        """
        at, found = self.state(some), list[Intervals]()
        for k in self.rubbed:
            law = named("friction_held", self.balance.contacts[k])
            none, whole = (at.call(law, (), share) for share in (0, 1))
            found.append((whole - none) * at.contact_force(k, 1))
        return stacked(found, some.proved.shape)

    def slopes(self, some: Patches) -> tuple[Intervals, Intervals]:
        """K⁻¹ ∇a, (n, m, N), and the derivatives of gaps along it, (gaps, m, N); infinite where
        unknown.
        """
        balance, shape, q = self.balance, some.proved.shape, list(Intervals(some.ends))
        parameters = self.prepared(some)
        n, first = balance.n, len(balance.contacts)
        at = balance.state(q, parameters)
        rates = [[int(i == j) for i in range(n)] for j in range(-1, n)]
        still, *moving = (at.call("borders", [*q, *rate])[first:] for rate in rates)
        along = [[still[f] - moved[f] for moved in moving] for f in self.holding]
        K = balance.jacobian(Intervals(some.ends), parameters)
        by = Intervals(np.stack([solved(K, stacked(one, shape)).ends for one in along], axis=2))
        for k in np.flatnonzero(self.either).tolist():
            pull = self.pulls(some)[k]
            sign = Intervals.between(np.sign(pull.low), np.sign(pull.high))
            by.ends[:, :, k] = (by[:, k] * sign).ends
        moved = balance.state(jets.variables(q, 1), parameters)
        ends = np.zeros((2, len(self.out), len(self.rows), *shape))
        for g, gap in enumerate(moved.gaps()):
            slopes = stacked(jets.gradient(gap, n), shape)
            pairs = zip(slopes, by, strict=True)
            one = reduce(add, (slope[None] * part for slope, part in pairs)).ends
            ends[:, g] = one[::-1] if self.out[g] else one
        return by, Intervals(ends)

    def crosses(self, some: Patches) -> BoolArray:
        """Mask of contacts whose gap may have both signs over a patch, (gaps, m, N); not of the
        contact that has the friction itself.
        """
        return (self.gaps(some).high > 0)[:, None] & ~self.theirs[:, :, None]

    def ways(self, some: Patches, gap_slopes: Intervals) -> IntArray:
        """Directions of the shares along which all gaps with both signs fall, (m, N); 0 where there
        is none.

        States of this combination are connected with those at that end of the share.
        """
        crosses = self.crosses(some)
        falls = ~crosses | (gap_slopes.high < 0)
        rises = ~crosses | (gap_slopes.low > 0)
        some_cross = crosses.any(axis=0)
        return np.where(some_cross, rises.all(axis=0) * -1 + falls.all(axis=0) * 1, 0)

    def most_inside(self, some: Patches) -> Patches:
        """Patches reduced to the ends of shares to which :meth:`ways` lead."""
        ways = self.ways(some, self.slopes(some)[1])
        low, high = _led(some, ways)
        return self.narrowed(some.over(low, high))


def _led(some: Patches, ways: IntArray) -> tuple[FloatArray, FloatArray]:
    """Cells reduced to the ends of shares to which ``ways`` lead."""
    return np.where(ways > 0, some.high, some.low), np.where(ways < 0, some.low, some.high)


def solved(K: Intervals, right: Intervals) -> Intervals:
    """Enclosures of all solutions of K x = right, (n, N); infinite where a matrix may be
    singular.
    """
    near = (contractors.inverse(K.middle) * right.middle).sum(axis=1)
    values = sum((K[:, j] * Intervals.point(near[j]) for j in range(near.shape[0])), -right)
    reach = 0.1 * np.abs(near).max(axis=0) + 2.0**-40 + 0 * near
    out = np.full((2, *near.shape), np.inf)
    for _ in range(4):
        step = contractors.newton(values, K, near, reach).ends
        off = np.maximum(*(step + np.stack([near, -near])))
        good = (off < reach).all(axis=0)
        out = np.where(good, np.fmin(out, step), out)
        reach = np.where(good, reach, 2 * np.maximum(reach, off))
    return Intervals(out)


# ------------------------------------------------------------------------------------------------
# cover


def _cover(it: Touches) -> tuple[Patches, FloatArray, BoolArray]:
    """Patches and undecided boxes that hold all states of one combination; the searched region, and
    whether it is proved to hold all.
    """
    ends, none = np.ones((len(it.rows), 1)), np.zeros(1, dtype=bool)
    bounds = it.bounds(-ends, ends)
    box, _ = region(it.balance, bounds)
    # States a little beyond a border are accepted, so that patches of cells that meet it are whole.
    it.balance = it.balance.extended(slack=0.1 * float(box.max()))
    box, whole = region(it.balance, bounds)
    cells = Patches(-ends, ends, box, box, none)
    found, looked = [cells[none]], 0
    while len(cells):
        looked += len(cells)
        some, cell = it.searched(cells)
        _, gone = it.sides(some)
        some, cell = some[~gone], cell[~gone]
        if not len(some):
            break
        inside, outside = it.sides(it.most_inside(some))
        kept, decided = ~(some.proved & outside), some.proved & inside
        some, cell, decided = some[kept], cell[kept], decided[kept]
        small = (cells.high - cells.low).max(axis=0) < 2.0**-11
        again = np.unique(cell[~decided])
        # Sets without folds over the shares need fewer cells; others would never end.
        again = again[~small[again]] if looked < 2000 else again[:0]
        left = ~np.isin(cell, again)
        found.append(replace(some, proved=decided)[left])
        if not again.size:
            break
        hull = hulls_of(some.ends, cell, len(cells))
        hull = np.fmin(hull + 1e-6 + 0.1 * np.maximum(width_of(hull), 0.0), cells.ends)
        cells = replace(cells, ends=hull, alone=hull)[again]
        cells = cells.halved(cells.high - cells.low)
    return found[0].concatenated(*found[1:]), box, whole


# ------------------------------------------------------------------------------------------------
# connected sets


def _sets_of(count: int, *pairs: IntArray) -> IntArray:
    """The number of the set of each patch, from pairs of patches that belong together."""
    of = np.arange(count)
    for one, other in np.concatenate(pairs, axis=1).T:
        of[of == of[other]] = of[one]
    return of


def _links(
    parts: Sequence[Touches], patches: Sequence[Patches], first: IntArray
) -> tuple[IntArray, IntArray]:
    """Pairs of patches of all combinations that are proved to be connected, and pairs that
    may be.
    """
    found = [(k, k, _joined(it, patches[k])) for k, it in enumerate(parts)]
    for k, other in combinations(range(len(parts)), 2):
        differ = parts[k].closed ^ parts[other].closed
        if len(differ) == 1:
            pair = ((parts[k], patches[k]), (parts[other], patches[other]))
            found.append((k, other, _across(*pair, *differ)))
    numbered = [[pairs + first[[k, other], None] for pairs in both] for k, other, both in found]
    sure, open_ = (np.concatenate(pairs, axis=1) for pairs in zip(*numbered, strict=True))
    return sure, open_


def _meeting(some: Patches, others: Patches) -> tuple[IntArray, IntArray]:
    """Pairs of patches whose closed cells have a common point."""
    low = np.maximum(some.low[:, :, None], others.low[:, None])
    high = np.minimum(some.high[:, :, None], others.high[:, None])
    first, second = np.nonzero((low <= high).all(axis=0))
    return first, second


def _joined(it: Touches, some: Patches) -> tuple[IntArray, IntArray]:
    """Pairs of patches of one combination that are proved to be connected, and pairs that may be,
    (2, pairs).
    """
    first, second = _meeting(some, some)
    first, second = first[first < second], second[first < second]
    one, other = some[first], some[second]
    low, high = np.maximum(one.low, other.low), np.minimum(one.high, other.high)
    ways = it.ways(one, it.slopes(one)[1])
    face = one.over(*_led(one.over(low, high), ways))
    inside, outside = it.sides(it.narrowed(face))
    point = 0.5 * (face.low + face.high)
    here, there = (it.narrowed(part.over(point, point)).ends for part in (one, other))
    both = one.proved & other.proved
    same = both & contractors.within(here, other.alone)
    differ = contractors.apart(one.ends, other.ends) | (both & contractors.apart(here, there))
    sure = same & inside
    open_ = ~sure & ~differ & ~(both & outside)
    pairs = np.stack([first, second])
    return pairs[:, sure], pairs[:, open_]


def _across(
    one: tuple[Touches, Patches], other: tuple[Touches, Patches], contact: int
) -> tuple[IntArray, IntArray]:
    """:func:`_joined` for patches of two combinations that differ in one contact."""
    it, some = one
    border = it.balance.opens.index(contact)
    crosses = np.flatnonzero(some.proved & it.gaps(some)[border].holds_zero())
    first, second = _meeting(some[crosses], other[1])
    near = ~contractors.apart(some.ends[:, :, crosses][:, :, first], other[1].ends[:, :, second])
    first, second = crosses[first[near]], second[near]
    patches = some[first]
    ways = it.ways(patches, it.slopes(patches)[1])
    at = _on_border(it, patches, ways, border)
    goal = other[1][second]
    holds = (goal.low <= at.low).all(axis=0) & (at.high <= goal.high).all(axis=0)
    sure = at.proved & goal.proved & holds & contractors.within(at.ends, goal.alone)
    pairs = np.stack([first, second])
    return pairs[:, sure], pairs[:, ~sure]


def _on_border(it: Touches, some: Patches, ways: IntArray, border: int) -> Patches:
    """Tiny parts of patches that hold a state on a border, by bisection; ``proved`` where
    they do.
    """
    low, high = _led(some, ways)
    inner = 0.5 * (low + high)
    outer = np.where(ways > 0, some.low, np.where(ways < 0, some.high, inner))
    begins, ends = np.zeros(len(some)), np.ones(len(some))

    def at(share: FloatArray) -> Patches:
        point = inner + share * (outer - inner)
        return it.narrowed(some.over(point, point))

    def level(share: FloatArray) -> Intervals:
        return it.gaps(at(share))[border]

    good = (level(begins).high <= 0) & (level(ends).low > 0)
    for _ in range(48):
        middle = 0.5 * (begins + ends)
        gap = level(middle)
        begins = np.where(gap.high <= 0, middle, begins)
        ends = np.where(gap.low > 0, middle, ends)
    corners = [inner + share * (outer - inner) for share in (begins, ends)]
    tiny = it.narrowed(some.over(np.minimum(*corners), np.maximum(*corners)))
    others = it.gaps(tiny).high <= 0
    others[border] = True
    return replace(tiny, proved=good & others.all(axis=0))


# ------------------------------------------------------------------------------------------------
# least values


@dataclass(frozen=True)
class _Aims(ByColumn):
    """Patches with what is to be minimized in each: ``sign`` times the coordinate ``row``.

    The minimum is over all patches of one ``number``.
    """

    patches: Patches
    row: IntArray
    sign: FloatArray
    number: IntArray

    def of(self, values: Intervals) -> Intervals:
        """The numbers to be minimized, from values of the coordinates, (n, …, N)."""
        rows = self.row.reshape((1,) * (values.ends.ndim - 1) + (-1,))
        ends = np.take_along_axis(values.ends, rows, axis=1)[:, 0]
        return Intervals(np.where(self.sign > 0, ends, ends[::-1]))

    def halved(self, weight: FloatArray) -> _Aims:
        """Both parts of each patch."""
        return replace(self.concatenated(self), patches=self.patches.halved(weight))


def _cut(it: Touches, aims: _Aims, by: Intervals, gap_slopes: Intervals) -> _Aims:
    """Patches reduced to the ends of shares at which their minimum lies; those with a smaller value
    beside them are dropped.
    """
    some, slopes = aims.patches, aims.of(by)
    crosses = it.crosses(some)
    down = (slopes.low > 0) & (~crosses | (gap_slopes.low >= 0)).all(axis=0) & some.proved
    up = (slopes.high < 0) & (~crosses | (gap_slopes.high <= 0)).all(axis=0) & some.proved
    gone = np.logical_or.reduce((down & (some.low > -1)) | (up & (some.high < 1)))
    low, high = np.where(up, some.high, some.low), np.where(down, some.low, some.high)
    return replace(aims, patches=some.over(low, high))[~gone]


def _least(it: Touches, aims: _Aims, best: FloatArray) -> FloatArray:
    """Lower bounds of the minima by number, and smaller upper bounds ``best`` in place (branch and
    bound).
    """
    least, looked = np.full(best.shape, np.inf), 0
    while aims.row.size:
        looked += aims.row.size
        aims = replace(aims, patches=it.narrowed(aims.patches))
        aims = aims[~it.sides(aims.patches)[1]]
        by, gap_slopes = it.slopes(aims.patches)
        inner = 0.5 * np.add(*_led(aims.patches, it.ways(aims.patches, gap_slopes)))
        _value(it, aims, inner, best)
        aims = _cut(it, aims, by, gap_slopes)
        some = replace(aims, patches=it.narrowed(aims.patches))
        slopes = some.of(it.slopes(some.patches)[0]) * abs(it.pulls(some.patches))
        low, high = some.patches.low, some.patches.high
        _value(it, some, np.where(slopes.middle > 0, low, high), best)
        middle = _value(it, some, 0.5 * (low + high), best)
        reach = (slopes.magnitude * (0.5 * (high - low))).sum(axis=0) * (1 + 2.0**-40)
        by_mean = np.where(some.patches.proved, middle.low - reach, -np.inf)
        below = np.fmax(some.of(Intervals(some.patches.ends)).low, by_mean)
        open_ = below < best[some.number]
        # Not halved: bounds that agree, tiny cells, and all when the budget is spent.
        near = best[some.number] - below <= 2.0**-46 * scale_of(best[some.number])
        small = (high - low).max(axis=0) <= 2.0**-40
        done = near | small if looked < 40_000 else open_
        np.minimum.at(least, some.number[open_ & done], below[open_ & done])
        weight = np.nan_to_num(slopes.magnitude, posinf=1e300) * (high - low)
        aims = _researched(it, some[open_ & ~done].halved(weight[:, open_ & ~done]))
    return least


def _value(it: Touches, aims: _Aims, point: FloatArray, best: FloatArray) -> Intervals:
    """Values at points of patches; those of states of this combination improve the upper bounds
    ``best``.
    """
    there = it.narrowed(aims.patches.over(point, point))
    value = aims.of(Intervals(there.ends))
    feasible = there.proved & it.sides(there)[0]
    np.minimum.at(best, aims.number[feasible], value.high[feasible])
    return value


def _researched(it: Touches, aims: _Aims) -> _Aims:
    """Aims whose unproved boxes have been searched again."""
    some = aims[~aims.patches.proved]
    if not some.row.size:
        return aims
    found, cell = it.searched(some.patches)
    again = replace(some[cell], patches=found)
    return aims[aims.patches.proved].concatenated(again)


def sets(p: ParameterSet, own: ParameterSet) -> StickingStates:
    """All sticking states of scalar parameters in which every friction that can hold does; ``own``
    are parameters of the model with shares.
    """
    if own.model.whole_turns:
        raise ModelError(
            f"states of sticking of {p.model.name}, where several frictions hold, or one beside a "
            "contact that opens, are not answered: its forces are not linear, and an angle comes "
            "around; hold the angle by a spring"
        )
    every = [Touches(p.model, own, key) for key in own.model.regimes]
    parts = [one for one in every if one.touches]
    with quiet():
        covers = [_cover(one) for one in parts]
        patches = [found[it.pressed(found)] for it, (found, *_) in zip(parts, covers, strict=True)]
        first = np.cumsum([0, *map(len, patches)])
        links = _links(parts, patches, first)
        remarks = dict.fromkeys(
            remark
            for it, (_, box, whole) in zip(parts, covers, strict=True)
            for remark in of_region(it.balance, box, whole)
        )
        return _result(p, list(zip(parts, patches, first, strict=False)), links, tuple(remarks))


def _result(
    p: ParameterSet,
    parts: Sequence[tuple[Touches, Patches, int]],
    links: tuple[IntArray, IntArray],
    remarks: tuple[str, ...],
) -> StickingStates:
    """The result: sets of connected patches, and the enclosed ends of all coordinates."""
    proved = np.concatenate([patches.proved for _, patches, _ in parts])
    apart, of = _sets_of(proved.size, links[0]), _sets_of(proved.size, *links)
    known = np.unique(of[proved])
    # The least of each coordinate, and of each with the other sign.
    count = 2 * len(p.model.coordinates)
    best = np.full(known.size * count, np.inf)
    every = list[tuple[Touches, _Aims]]()
    for it, patches, first in parts:
        own = of[first : first + len(patches)]
        mine = np.flatnonzero(np.isin(own, known))
        each, some = np.repeat(np.arange(count), mine.size), np.tile(mine, count)
        number = np.searchsorted(known, own)[some] * count + each
        sign = np.where(each % 2, -1.0, 1.0)
        every.append((it, _Aims(patches[some], each // 2, sign, number)))
    least = np.minimum.reduce([_least(it, aims, best) for it, aims in every])
    least = np.minimum(least, best)
    columns = Intervals.between(*(one.reshape(-1, count).T for one in (least, best)))
    left = int((~proved).sum())
    if left:
        remarks += (
            f"{left} boxes are undecided, where states may meet in folds over the shares of "
            "friction that are used: sets may be larger or smaller there, or there may be others",
        )
    if np.unique([of[proved], apart[proved]], axis=1).shape[1] > known.size:
        remarks += ("whether what is given as one set is connected is not known for all of them",)
    ends = [-one if k % 2 else one for k, one in enumerate(columns)]
    return replace(sets_of(p, ends), complete=not remarks, remarks=remarks)


def sets_of(
    p: ParameterSet,
    ends: Sequence[Intervals],
    further: Sequence[str] = (),
    error: FloatArray | float = 0.0,
) -> StickingStates:
    """A result from enclosures of both ends of every coordinate and of ``further`` columns.

    Without enclosures it has no rows. ``error`` is added to that of the enclosures.
    """
    names = [f"{name}_{end}" for name in p.model.coordinates for end in ("low", "high")]
    every = ends or [Intervals(np.empty((2, 0)))] * (len(names) + len(further))
    columns = {name: one.middle for name, one in zip([*names, *further], every, strict=True)}
    error = np.zeros(every[0].shape) + error
    for one in every:
        if np.isfinite(one.ends).all():
            error = np.maximum(error, one.width / scale_of(one.magnitude))
    order = np.lexsort([columns[name] for name in reversed(names[::2])])
    return StickingStates(p, error[order], True, (), selected_rows(columns, order))
