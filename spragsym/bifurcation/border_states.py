"""States of all combinations of contacts about a point where borders of contacts are.

Where k contacts only just touch at once, as of twins, up to 2ᵏ combinations meet. In a box around
the point in which each of them has one state for every value of a short range of the parameter,
whatever the signs of its gaps are, those whose gaps have the right signs at an end of the range are
all states there: the solutions of the linear complementarity problem of the slopes. None leaves the
box through its sides. So where one is left at either end, and K is regular, it is of index 1 or −1,
and a continuum of states joins the two; where there are some at one end only, all of them end.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from ..numerics import contractors
from ..numerics.arithmetic import determinant
from ..numerics.certified_roots import Roots, stepped
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    width_of,
)
from ..results.points import Points
from ..statics.balance import Balance
from ..statics.precise_balance import clusters, on_side
from ..statics.systems import GAPS, Boxes
from .defining_systems import Augmented, Family, touch
from .points import Found, arranged


@dataclass(frozen=True)
class BorderStates(ByColumn):
    """States of every combination of contacts at both ends of short ranges of the parameter.

    ``box``, shape (2, n, N), holds one state of a combination that is ``regular`` for every value,
    on whichever sides of its borders; ``roots`` are these at both ends, shape (2, combinations, 2,
    n, N), and ``states`` whether they are on the right sides, where that is ``known``. ``meets``
    says of a combination whether the box reaches to its sides, and ``near`` of the contacts that
    open whether it meets their borders.
    """

    box: FloatArray
    roots: FloatArray
    states: BoolArray
    known: BoolArray
    regular: BoolArray
    meets: BoolArray
    near: BoolArray

    def kinds(self, own: BoolArray) -> NDArray[np.str_]:
        """Kinds of the points, for the combinations that are asked for, their ``own``; empty where
        it is not known.
        """
        counts, total = self.states[:, own].sum(axis=1), self.states[:, own].sum(axis=(0, 1))
        sure = self.known & self.regular
        lifted = self.meets & (~sure | self.states.any(axis=0))
        lifts, known = lifted[~own].any(axis=0), self.known[own].all(axis=0)
        ends = known & (counts.min(axis=0) == 0)
        passes = sure.all(axis=0) & (counts == 1).all(axis=0) & ~lifts
        return np.select(
            [ends & (total == 0), ends & lifts, ends, passes],
            ["nothing", "border", "border_fold", "passes"],
            "",
        )


def combinations_of(balance: Balance) -> list[Balance]:
    """The balances of all combinations of contacts, that of none included; on a border it
    touches.
    """
    model = balance.model
    each = [Balance(model, key, balance.law, balance.options) for key in model.regimes]
    for one in each:
        one.apart = True
    return each


def among(every: Sequence[Balance], some: Sequence[Balance]) -> BoolArray:
    """Which balances have a combination of contacts that touch of some others."""
    combinations = [one.pushing for one in some]
    return np.array([one.pushing in combinations for one in every])


def both_sides(family: Family, box: FloatArray, ends: FloatArray) -> BorderStates:
    """States at both ``ends`` of ranges of the parameter, shape (2, N), either one first, about
    boxes of shape (2, n, N).
    """
    balances = combinations_of(family.balance)
    given = [family.at(end[None]) for end in ends]
    with quiet():
        between = Intervals.between(np.minimum(*given), np.maximum(*given))
        over = [one.prepared(between) for one in balances]
        meets = [~on_side(one, wide, box)[1] for one, wide in zip(balances, over, strict=True)]
        for _ in range(4):  # wider until no combination steps out of it
            box = box + (0.25 * width_of(box) + np.spacing(np.abs(box).max(axis=0)))
            for one, wide, here in zip(balances, over, meets, strict=True):
                step = stepped(one, box, wide).ends
                good = here & np.isfinite(step).all(axis=(0, 1))
                box = np.where(good, np.maximum(box, step), box)
        box = box + 0.25 * width_of(box)
        parts = [
            _of_combination(family, one, box, [wide, *map(one.prepared_at, given)], here)
            for one, wide, here in zip(balances, over, meets, strict=True)
        ]
        gaps = Boxes(balances[0], Intervals(box), over[0]).taped(*GAPS)
    roots, states, known, regular = map(np.array, zip(*parts, strict=True))
    roots, states = (np.moveaxis(each, 0, 1) for each in (roots, states))
    return BorderStates(box, roots, states, known, regular, np.array(meets), gaps.signs == 0)


def _of_combination(
    family: Family, balance: Balance, box: FloatArray, at: Sequence[Intervals], meets: BoolArray
) -> tuple[list[FloatArray], list[BoolArray], BoolArray, BoolArray]:
    """Of one combination the roots and states at both ends, and what is known and regular; ``at``
    are the prepared parameters over the range and at its ends.
    """
    over, *ends = at
    alone = contractors.inside(stepped(balance, box, over).ends, box)
    absent = ~meets & on_side(balance, over, box)[1]
    known, roots, states = alone | absent, list[FloatArray](), list[BoolArray]()
    if not known.all() and is_singular(balance, family):
        known = np.ones_like(known)
    for prepared in ends:
        place = box
        for _ in range(4):  # each doubles the number of digits
            place = np.fmin(stepped(balance, place, prepared).ends, place)
        inside, beyond = on_side(balance, prepared, place)
        roots.append(place)
        states.append(inside & alone)
        known = known & (inside | beyond | ~alone)
    return roots, states, known, alone | absent


def about_border(
    family: Family, hull: FloatArray, own: BoolArray
) -> tuple[str, BorderStates, Intervals]:
    """Kind of one point where borders meet, somewhere in a hull of coordinates and the parameter,
    shape (2, n + 1, 1), empty where it is not known; and states about it in as short a range of the
    parameter as tells it.
    """
    middle = Intervals(hull).middle[-1]
    # On either side so far, over the value: a few digits more than rounding takes, then more.
    for share in 2.0 ** np.arange(-46, -16, 6):
        room = width_of(hull)[-1] + share * scale_of(middle)
        ends = np.array([middle - room, middle + room])
        found = both_sides(family, hull[:, :-1], ends)
        if kind := str(found.kinds(own)[0]):
            break
    return kind, found, Intervals.between(*ends)


def at_once(
    families: Sequence[Family], near: Family, contact: int, found: Found
) -> tuple[Found, list[Points]]:
    """What a search for the border of a contact has found, without the points at which others only
    just touch, too, where these are decided; and the points of these that belong here, since more
    than one search meets them.
    """
    system, roots, balance = Augmented(near, touch(contact)), found.roots, near.balance
    every, point = roots.every
    if len(balance.opens) < 2 or not 0 < point.size <= balance.options.scattered:
        return found, []
    with quiet():
        given = system.prepared_at(near.begin[:, point])
        gaps = Boxes(system, Intervals(every), given).taped(*GAPS)
    several = (gaps.signs == 0).sum(axis=0) > 1
    ours = [family.balance for family in families]
    own = among(combinations_of(balance), ours)
    points, kept = list[Points](), np.ones(point.size, dtype=bool)
    leaves = not among([balance.across(contact)], ours)[0]
    hulls, owner = clusters(every[:, :, several], point[several])
    for hull, row in zip(np.moveaxis(hulls, 2, 0), owner.tolist(), strict=True):
        one = replace(near, given=near.given[:, row : row + 1])
        kind, states, span = about_border(one, hull[:, :, None], own)
        if not kind:
            continue
        kept &= ~contractors.within(every, hull[:, :, None])
        touched = [k for k, here in zip(balance.opens, states.near[:, 0], strict=True) if here]
        opened = [k for k in touched if not balance.pushing[k]]
        # More than one search meets it: of those of one contact that touches, or of all there.
        elsewhere = contact != touched[0] or (opened and not leaves)
        if kind == "nothing" or (kind == "border") != leaves or elsewhere:
            continue
        closed = reduce(Balance.across, opened, balance)
        there = replace(one, balance=closed.extended(*touched))
        middle = Intervals(hull[:, :, None]).middle
        box = np.concatenate([states.box, span.ends[:, None]], axis=1)
        box = ends_around(middle, contractors.distance(box, middle))
        points.append(arranged(there, replace(found, roots=Roots.at(box)), kind))
    count = roots.point.size
    return replace(found, roots=roots.select(kept[:count], kept[count:])), points


def is_singular(balance: Balance, family: Family) -> bool:
    """Whether det K is 0 for all states and all parameters but those that are 0 here.

    In exact numbers, at rational places that are drawn, of directions and friction coefficients
    too. It is no proof: a polynomial that is not 0 everywhere has all these places of so many
    digits as roots with next to no probability (Schwartz and Zippel).
    """
    rng = np.random.default_rng(0)
    still = zip(balance.parameters, family.given[:, 0].tolist(), strict=True)
    zero = {name for name, value in still if value == 0 and name not in balance.angles}

    def drawn() -> Fraction:
        # Largest numerator and denominator of these numbers.
        largest = 2**30
        return Fraction(*map(int, rng.integers(1, largest, 2)))

    def circle() -> list[Fraction]:
        t = drawn()
        return [(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)]

    # Places with rational numbers at which a determinant that is 0 everywhere is 0.
    for _ in range(12):
        values = {name: 0 if name in zero else drawn() for name in balance.codes}
        for pair in balance.angles.values():
            values |= dict(zip(pair, circle(), strict=True))
        q, mus = [drawn() for _ in balance.coordinates], [drawn() for _ in balance.rubbing]
        lines = [part for _ in range(balance.springs) for part in (*circle(), drawn())]
        first = [*q, *lines, *(drawn() for _ in balance.torsions)]
        at = balance.at(q, values, xp=None)
        try:
            K = at.call("forces_jacobian", first, *mus, *balance.pushing, kind="statics")
        except AttributeError:  # of a law that is no algebra
            return False
        if determinant(K) != 0:
            return False
    return True
