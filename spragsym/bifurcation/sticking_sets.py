"""Connected sets of sticking states with several frictions, or with other contacts that open, for
any forces.

A sticking state is an equilibrium with the friction coefficients μ_i = h_i μ_s,i, at shares h in
[−1, 1]ᵐ. Cells of this box are halved until interval Newton proves that a box of coordinates holds
exactly one state for every h of the cell. Such a patch q(h) has the slopes

    ∂q/∂h_i = μ_s,i N_i K⁻¹ ∇a_i,

where friction i opposes the displacement a_i. N_i > 0 inside of a contact, so that the sign of
K⁻¹ ∇a_i is that of the slope, up to the border. On a border N_i = 0, and the state is the same for
all h_i. Patches of neighbouring cells are connected if both hold the same state.

The ends of a coordinate over a connected set are found by branch and bound. At a minimum each share
has a slope of unknown sign, or is at an end of its range, or the state is on a border. So patches
whose slopes have known signs are dropped or reduced to an end of a share (monotonicity test). The
others are halved until the bounds of the minimum agree. There are no patches where states meet in
folds over the shares: boxes remain undecided there, and bound the states that they may hold.
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
    """States over cells of shares from ``low`` to ``high``, shape (m, N).

    The states lie in the boxes ``ends``, (2, n, N). If ``proved``, there is exactly one in the box
    ``alone`` for each point of the cell.
    """

    low: FloatArray
    high: FloatArray
    ends: FloatArray
    alone: FloatArray
    proved: BoolArray

    def __len__(self) -> int:
        return int(self.proved.size)

    def over(self, low: FloatArray, high: FloatArray) -> Patches:
        """The patches over parts of their cells."""
        return replace(self, low=low, high=high)

    def halved(self, weight: FloatArray) -> Patches:
        """Both parts of each cell, cut across its side of largest weight."""
        # Not in the middle, since contacts often just touch at simple shares.
        _, high, low = halves(self.low, self.high, weight, 0.4873)
        return self.over(self.low, high).concatenated(self.over(low, self.high))


class StickingSystem:
    """The balance of sticking states of one combination of touching contacts, over cells of shares.

    ``own`` are the parameters of the model with shares, ``key`` is the combination.
    """

    def __init__(self, model: Model, own: ParameterSet, key: Touching) -> None:
        shares = [name for name in own.ranges if name not in model.parameters]
        self.balance = balance = Balance(own.model, key, law="friction_at_speed")
        self.given = columns(own, balance.parameters)
        self.rows = [balance.parameters.index(name) for name in shares]
        self.closed = frozenset(k for k in balance.opens if balance.indicators[k])
        frictions = enumerate(own.model.frictions)
        holding = [k for k, entry in frictions if named("held", entry["name"]) in shares]
        #: Indices of the frictions that hold, and of their contacts.
        self.holding = holding
        self.rubbed = [balance.contacts.index(own.model.frictions[k]["name"]) for k in holding]
        #: Mask of the borders that are those of the contact of a friction, (borders, frictions).
        self.own_border = np.equal.outer(np.array(balance.opens, dtype=int), self.rubbed)
        #: For each border, whether the contact is open.
        self.is_open = [k not in self.closed for k in balance.opens]
        #: For each friction that holds, whether its contact presses on either of two faces.
        self.either_face = [presses_either(model.contacts[k]) for k in self.rubbed]

    @property
    def can_stick(self) -> bool:
        """Whether all contacts touch whose friction holds."""
        return all(self.balance.indicators[k] for k in self.rubbed)

    def bounds(self, low: FloatArray, high: FloatArray) -> Intervals:
        """Enclosures of all parameters over cells of shares."""
        parameters = Intervals.point(np.repeat(self.given, low.shape[1], axis=1))
        parameters.ends[:, self.rows] = -low, high
        return parameters

    def prepared(self, some: Patches) -> Intervals:
        """Prepared parameters over the cells."""
        return self.balance.prepared(self.bounds(some.low, some.high))

    def state(self, some: Patches) -> Evaluation:
        """The evaluation at the states of patches."""
        return self.balance.state(Intervals(some.ends), self.prepared(some))

    def origin(self) -> Patches:
        """The origin of coordinates and of shares, as one patch that is not proved."""
        q, shares = np.zeros((2, self.balance.n, 1)), np.zeros((len(self.rows), 1))
        return Patches(shares, shares, q, q, np.zeros(1, dtype=bool))

    def searched(self, cells: Patches) -> tuple[Patches, IntArray]:
        """All states over cells within their boxes, as patches, with the index of the cell of each.

        If interval Newton does not prove one state, or none, the box is searched.
        """
        whole, none = self.enclosed(cells)
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
        others, none = self.enclosed(replace(cells[owner], ends=hulls, alone=hulls))
        return found.concatenated(others[~none]), np.concatenate([cell, owner[~none]])

    def enclosed(self, some: Patches) -> tuple[Patches, BoolArray]:
        """The patches, proved where interval Newton shows one state in a slightly wider box; and
        the mask of boxes without a state.
        """
        inflation = 0.3 * width_of(some.ends) + 2.0**-30 * scale_of(some.ends).max(axis=0)
        wide = some.ends + inflation
        step = certified_roots.stepped(self.balance, wide, self.prepared(some))
        proved = contractors.inside(step.ends, wide)
        ends = np.where(proved, step.ends, some.ends)
        made = replace(some, ends=ends, alone=wide, proved=proved)
        return self.narrowed(made), step.none

    def narrowed(self, some: Patches) -> Patches:
        """The patches with the boxes of proved ones narrowed by interval Newton."""
        at, ends = self.prepared(some), some.ends
        for _ in range(3):
            step = certified_roots.stepped(self.balance, ends, at).ends
            ends = np.where(some.proved, np.fmin(step, ends), ends)
        return replace(some, ends=ends)

    def gaps(self, some: Patches) -> Intervals:
        """Gaps of the contacts that open, (gaps, N), with the sign changed for open contacts.

        A state belongs to this combination where all are ≤ 0.
        """
        gaps = stacked(self.state(some).gaps() or [0], some.proved.shape)
        ends = gaps.ends.copy()
        ends[:, self.is_open] = ends[::-1, self.is_open]
        return Intervals(ends)[: len(self.is_open)]

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
        for k, either_face in zip(self.rubbed, self.either_face, strict=True):
            if either_face or self.balance.model.contacts[k]["gap"] is not None:
                continue
            force = as_intervals(at.contact_force(k, 1), none.shape)
            if ((force.low <= 0) & (force.high > NEGLIGIBLE)).any():
                raise ConvergenceError(
                    "the sign of a normal force is not known; change a parameter"
                )
            none |= force.low <= 0
        return ~none

    def pulls(self, some: Patches) -> Intervals:
        """Derivatives μ_s N of the forces by the shares, for every friction that holds, (m, N).

        If the limits of a law differ by direction, μ_s is half of their difference.
        """
        at, found = self.state(some), list[Intervals]()
        for k in self.rubbed:
            law = named("friction_held", self.balance.contacts[k])
            at_0, at_1 = (at.call(law, (), share) for share in (0, 1))
            found.append((at_1 - at_0) * at.contact_force(k, 1))
        return stacked(found, some.proved.shape)

    def slopes(self, some: Patches) -> tuple[Intervals, Intervals]:
        """K⁻¹ ∇a, (n, m, N), and the derivatives of :meth:`gaps` along it, (gaps, m, N); infinite
        where K may be singular.
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
        for k in np.flatnonzero(self.either_face).tolist():
            pull = self.pulls(some)[k]
            sign = Intervals.between(np.sign(pull.low), np.sign(pull.high))
            by.ends[:, :, k] = (by[:, k] * sign).ends
        moved = balance.state(jets.variables(q, 1), parameters)
        ends = np.zeros((2, len(self.is_open), len(self.rows), *shape))
        for g, gap in enumerate(moved.gaps()):
            slopes = stacked(jets.gradient(gap, n), shape)
            pairs = zip(slopes, by, strict=True)
            one = reduce(add, (slope[None] * part for slope, part in pairs)).ends
            ends[:, g] = one[::-1] if self.is_open[g] else one
        return by, Intervals(ends)

    def crosses(self, some: Patches) -> BoolArray:
        """Mask of the gaps that may be positive in a patch, for each share, (gaps, m, N).

        The gap of the contact whose friction has the share is left out.
        """
        return (self.gaps(some).high > 0)[:, None] & ~self.own_border[:, :, None]

    def directions(self, some: Patches, gap_slopes: Intervals) -> IntArray:
        """For each share the direction in which all gaps of :meth:`crosses` decrease, (m, N); 0 if
        there is none.

        States of this combination are connected with those at that end of the share.
        """
        crosses = self.crosses(some)
        up = (~crosses | (gap_slopes.high < 0)).all(axis=0)
        down = (~crosses | (gap_slopes.low > 0)).all(axis=0)
        return np.where(crosses.any(axis=0), up * 1 - down * 1, 0)

    def reduced(self, some: Patches) -> Patches:
        """Patches reduced to the ends of shares in the :meth:`directions`."""
        directions = self.directions(some, self.slopes(some)[1])
        return self.narrowed(some.over(*_at_ends(some, directions)))


def _at_ends(some: Patches, directions: IntArray) -> tuple[FloatArray, FloatArray]:
    """Lower and upper corners of cells reduced to the ends of shares in the ``directions``."""
    return np.where(directions > 0, some.high, some.low), np.where(
        directions < 0, some.low, some.high
    )


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


def _cover(system: StickingSystem) -> tuple[Patches, FloatArray, BoolArray]:
    """Patches and undecided boxes that hold all states of one combination; the searched region, and
    whether it is proved to hold all.
    """
    ends, none = np.ones((len(system.rows), 1)), np.zeros(1, dtype=bool)
    bounds = system.bounds(-ends, ends)
    box, _ = region(system.balance, bounds)
    # States a little beyond a border are accepted, so that patches of cells that meet it are whole.
    system.balance = system.balance.extended(slack=0.1 * float(box.max()))
    box, whole = region(system.balance, bounds)
    cells = Patches(-ends, ends, box, box, none)
    found, examined = [cells[none]], 0
    while len(cells):
        examined += len(cells)
        some, cell = system.searched(cells)
        _, gone = system.sides(some)
        some, cell = some[~gone], cell[~gone]
        if not len(some):
            break
        inside, outside = system.sides(system.reduced(some))
        kept, decided = ~(some.proved & outside), some.proved & inside
        some, cell, decided = some[kept], cell[kept], decided[kept]
        small = (cells.high - cells.low).max(axis=0) < 2.0**-11
        again = np.unique(cell[~decided])
        # Sets without folds over the shares need fewer cells; others would never end.
        again = again[~small[again]] if examined < 2000 else again[:0]
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
    """The number of the set of each patch, from pairs of connected patches."""
    of = np.arange(count)
    for one, other in np.concatenate(pairs, axis=1).T:
        of[of == of[other]] = of[one]
    return of


def _links(
    parts: Sequence[StickingSystem], patches: Sequence[Patches], first: IntArray
) -> tuple[IntArray, IntArray]:
    """Pairs of patches of all combinations that are proved to be connected, and pairs that
    may be.
    """
    found = [(k, k, _joined(system, patches[k])) for k, system in enumerate(parts)]
    for k, other in combinations(range(len(parts)), 2):
        differ = parts[k].closed ^ parts[other].closed
        if len(differ) == 1:
            pair = ((parts[k], patches[k]), (parts[other], patches[other]))
            found.append((k, other, _across(*pair, *differ)))
    numbered = [[pairs + first[[k, other], None] for pairs in both] for k, other, both in found]
    proved, possible = zip(*numbered, strict=True)
    return np.concatenate(proved, axis=1), np.concatenate(possible, axis=1)


def _meeting(some: Patches, others: Patches) -> tuple[IntArray, IntArray]:
    """Pairs of patches whose closed cells have a common point."""
    low = np.maximum(some.low[:, :, None], others.low[:, None])
    high = np.minimum(some.high[:, :, None], others.high[:, None])
    first, second = np.nonzero((low <= high).all(axis=0))
    return first, second


def _joined(system: StickingSystem, some: Patches) -> tuple[IntArray, IntArray]:
    """Pairs of patches of one combination that are proved to be connected, and pairs that may be,
    (2, pairs).
    """
    first, second = _meeting(some, some)
    first, second = first[first < second], second[first < second]
    one, other = some[first], some[second]
    low, high = np.maximum(one.low, other.low), np.minimum(one.high, other.high)
    directions = system.directions(one, system.slopes(one)[1])
    face = one.over(*_at_ends(one.over(low, high), directions))
    inside, outside = system.sides(system.narrowed(face))
    point = 0.5 * (face.low + face.high)
    here, there = (system.narrowed(part.over(point, point)).ends for part in (one, other))
    both = one.proved & other.proved
    same = both & contractors.within(here, other.alone)
    differ = contractors.apart(one.ends, other.ends) | (both & contractors.apart(here, there))
    proved = same & inside
    possible = ~proved & ~differ & ~(both & outside)
    pairs = np.stack([first, second])
    return pairs[:, proved], pairs[:, possible]


def _across(
    one: tuple[StickingSystem, Patches], other: tuple[StickingSystem, Patches], contact: int
) -> tuple[IntArray, IntArray]:
    """:func:`_joined` for patches of two combinations that differ in one contact."""
    system, some = one
    border = system.balance.opens.index(contact)
    crosses = np.flatnonzero(some.proved & system.gaps(some)[border].holds_zero())
    first, second = _meeting(some[crosses], other[1])
    near = ~contractors.apart(some.ends[:, :, crosses][:, :, first], other[1].ends[:, :, second])
    first, second = crosses[first[near]], second[near]
    patches = some[first]
    directions = system.directions(patches, system.slopes(patches)[1])
    at = _on_border(system, patches, directions, border)
    goal = other[1][second]
    holds = (goal.low <= at.low).all(axis=0) & (at.high <= goal.high).all(axis=0)
    proved = at.proved & goal.proved & holds & contractors.within(at.ends, goal.alone)
    pairs = np.stack([first, second])
    return pairs[:, proved], pairs[:, ~proved]


def _on_border(system: StickingSystem, some: Patches, directions: IntArray, border: int) -> Patches:
    """Small parts of patches around a state on a border, by bisection along a line of shares.

    They are ``proved`` where they hold one, and the other gaps have the signs of this combination.
    """
    low, high = _at_ends(some, directions)
    inner = 0.5 * (low + high)
    outer = np.where(directions > 0, some.low, np.where(directions < 0, some.high, inner))
    begins, ends = np.zeros(len(some)), np.ones(len(some))

    def at(share: FloatArray) -> Patches:
        point = inner + share * (outer - inner)
        return system.narrowed(some.over(point, point))

    def level(share: FloatArray) -> Intervals:
        return system.gaps(at(share))[border]

    good = (level(begins).high <= 0) & (level(ends).low > 0)
    for _ in range(48):
        middle = 0.5 * (begins + ends)
        gap = level(middle)
        begins = np.where(gap.high <= 0, middle, begins)
        ends = np.where(gap.low > 0, middle, ends)
    corners = [inner + share * (outer - inner) for share in (begins, ends)]
    part = system.narrowed(some.over(np.minimum(*corners), np.maximum(*corners)))
    others = system.gaps(part).high <= 0
    others[border] = True
    return replace(part, proved=good & others.all(axis=0))


# ------------------------------------------------------------------------------------------------
# branch and bound


@dataclass(frozen=True)
class _Objectives(ByColumn):
    """Patches with an objective in each: ``sign`` times the coordinate ``row``.

    It is minimized over all patches with the same ``number``.
    """

    patches: Patches
    row: IntArray
    sign: FloatArray
    number: IntArray

    def of(self, values: Intervals) -> Intervals:
        """The objectives, (…, N), from values or derivatives of the coordinates, (n, …, N)."""
        rows = self.row.reshape((1,) * (values.ends.ndim - 1) + (-1,))
        ends = np.take_along_axis(values.ends, rows, axis=1)[:, 0]
        return Intervals(np.where(self.sign > 0, ends, ends[::-1]))

    def halved(self, weight: FloatArray) -> _Objectives:
        """Both parts of each patch."""
        return replace(self.concatenated(self), patches=self.patches.halved(weight))


def _cut(
    system: StickingSystem, objectives: _Objectives, by: Intervals, gap_slopes: Intervals
) -> _Objectives:
    """Patches after the monotonicity test: reduced to the end of a share at which the minimum lies,
    and dropped if the objective still decreases there into a neighbouring cell.
    """
    some, slopes = objectives.patches, objectives.of(by)
    crosses = system.crosses(some)
    down = (slopes.low > 0) & (~crosses | (gap_slopes.low >= 0)).all(axis=0) & some.proved
    up = (slopes.high < 0) & (~crosses | (gap_slopes.high <= 0)).all(axis=0) & some.proved
    gone = np.logical_or.reduce((down & (some.low > -1)) | (up & (some.high < 1)))
    low, high = np.where(up, some.high, some.low), np.where(down, some.low, some.high)
    return replace(objectives, patches=some.over(low, high))[~gone]


def _least(system: StickingSystem, objectives: _Objectives, best: FloatArray) -> FloatArray:
    """Lower bounds of the minima by number, by branch and bound; their upper bounds ``best`` are
    improved in place.
    """
    least, examined = np.full(best.shape, np.inf), 0
    while objectives.row.size:
        examined += objectives.row.size
        objectives = replace(objectives, patches=system.narrowed(objectives.patches))
        objectives = objectives[~system.sides(objectives.patches)[1]]
        by, gap_slopes = system.slopes(objectives.patches)
        inner = 0.5 * np.add(
            *_at_ends(objectives.patches, system.directions(objectives.patches, gap_slopes))
        )
        _value(system, objectives, inner, best)
        objectives = _cut(system, objectives, by, gap_slopes)
        some = replace(objectives, patches=system.narrowed(objectives.patches))
        slopes = some.of(system.slopes(some.patches)[0]) * abs(system.pulls(some.patches))
        low, high = some.patches.low, some.patches.high
        _value(system, some, np.where(slopes.middle > 0, low, high), best)
        middle = _value(system, some, 0.5 * (low + high), best)
        reach = (slopes.magnitude * (0.5 * (high - low))).sum(axis=0) * (1 + 2.0**-40)
        by_mean = np.where(some.patches.proved, middle.low - reach, -np.inf)
        below = np.fmax(some.of(Intervals(some.patches.ends)).low, by_mean)
        open_ = below < best[some.number]
        # Not halved: bounds that agree, very small cells, and all when the budget is spent.
        near = best[some.number] - below <= 2.0**-46 * scale_of(best[some.number])
        small = (high - low).max(axis=0) <= 2.0**-40
        done = near | small if examined < 40_000 else open_
        np.minimum.at(least, some.number[open_ & done], below[open_ & done])
        weight = np.nan_to_num(slopes.magnitude, posinf=1e300) * (high - low)
        objectives = _researched(system, some[open_ & ~done].halved(weight[:, open_ & ~done]))
    return least


def _value(
    system: StickingSystem, objectives: _Objectives, point: FloatArray, best: FloatArray
) -> Intervals:
    """Objectives at points of the patches; those of states of this combination improve the upper
    bounds ``best``.
    """
    there = system.narrowed(objectives.patches.over(point, point))
    value = objectives.of(Intervals(there.ends))
    feasible = there.proved & system.sides(there)[0]
    np.minimum.at(best, objectives.number[feasible], value.high[feasible])
    return value


def _researched(system: StickingSystem, objectives: _Objectives) -> _Objectives:
    """The objectives after another search of boxes that are not proved."""
    some = objectives[~objectives.patches.proved]
    if not some.row.size:
        return objectives
    found, cell = system.searched(some.patches)
    again = replace(some[cell], patches=found)
    return objectives[objectives.patches.proved].concatenated(again)


def sets(p: ParameterSet, own: ParameterSet) -> StickingStates:
    """All sticking states of scalar parameters in which every friction holds that can.

    ``own`` are the parameters of the model with shares.
    """
    if own.model.whole_turns:
        raise ModelError(
            f"states of sticking of {p.model.name}, where several frictions hold, or one beside a "
            "contact that opens, are not answered: its forces are not linear, and an angle comes "
            "around; hold the angle by a spring"
        )
    systems = [StickingSystem(p.model, own, key) for key in own.model.regimes]
    parts = [system for system in systems if system.can_stick]
    with quiet():
        covers = [_cover(one) for one in parts]
        patches = [
            found[system.pressed(found)] for system, (found, *_) in zip(parts, covers, strict=True)
        ]
        first = np.cumsum([0, *map(len, patches)])
        links = _links(parts, patches, first)
        remarks = dict.fromkeys(
            remark
            for system, (_, box, whole) in zip(parts, covers, strict=True)
            for remark in of_region(system.balance, box, whole)
        )
        return _result(p, list(zip(parts, patches, first, strict=False)), links, tuple(remarks))


def _result(
    p: ParameterSet,
    parts: Sequence[tuple[StickingSystem, Patches, int]],
    links: tuple[IntArray, IntArray],
    remarks: tuple[str, ...],
) -> StickingStates:
    """The result: sets of connected patches, and the enclosed ends of all coordinates.

    ``links`` are pairs of patches that are proved to be connected, and pairs that may be.
    """
    proved = np.concatenate([patches.proved for _, patches, _ in parts])
    apart, of = _sets_of(proved.size, links[0]), _sets_of(proved.size, *links)
    known = np.unique(of[proved])
    # The minimum of each coordinate, and of its negative.
    count = 2 * len(p.model.coordinates)
    best = np.full(known.size * count, np.inf)
    every = list[tuple[StickingSystem, _Objectives]]()
    for system, patches, first in parts:
        own = of[first : first + len(patches)]
        mine = np.flatnonzero(np.isin(own, known))
        each, some = np.repeat(np.arange(count), mine.size), np.tile(mine, count)
        number = np.searchsorted(known, own)[some] * count + each
        sign = np.where(each % 2, -1.0, 1.0)
        every.append((system, _Objectives(patches[some], each // 2, sign, number)))
    least = np.minimum.reduce([_least(system, objectives, best) for system, objectives in every])
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
