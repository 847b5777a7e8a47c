"""States near a border point, of all combinations of contacts that meet there.

Where k contacts only just touch at once, as in symmetric models, up to 2ᵏ combinations of touching
contacts meet. A box around the point and a short range of the parameter are chosen such that each
combination has exactly one solution in the box for every value of the range, whatever the signs of
its gaps are. At an end of the range the states in the box are the solutions whose gaps have the
right signs: they solve a linear complementarity problem. No solution leaves the box through its
sides, so the states at the two ends of the range decide.

- One state at each end, and K regular: its index is 1 or −1, and a continuum of states joins the
  two. The state passes.
- States at one end only: all of them end at the point, a border fold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from ..numerics import contractors
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
from .lines_of_states import is_singular
from .points import Found, arranged


@dataclass(frozen=True)
class BorderStates(ByColumn):
    """States of every combination of contacts at both ends of short ranges of the parameter.

    For each of N ranges, ``box``, shape (2, n, N), is a box of coordinates. The masks ``known``,
    ``regular`` and ``meets`` have the shape (combinations, N).

    - ``regular``: the combination has exactly one solution in the box for every value, whatever the
      signs of its gaps are, or has no state there.
    - ``roots``: boxes of the solutions at both ends, shape (2, combinations, 2, n, N).
    - ``states``: whether the gaps have the right signs there, shape (2, combinations, N), where
      that is ``known``.
    - ``meets``: the box may contain points whose gaps have the right signs.
    - ``near``: the box meets the border of a contact, shape (contacts that open, N).
    """

    box: FloatArray
    roots: FloatArray
    states: BoolArray
    known: BoolArray
    regular: BoolArray
    meets: BoolArray
    near: BoolArray

    def kinds(self, own: BoolArray) -> NDArray[np.str_]:
        """Kinds of the points, counting states of the combinations ``own`` only; empty where not
        proved.

        ``"nothing"`` if none of these has a state there. ``"border"`` if a state may go on in a
        combination that is not among them.
        """
        counts = self.states[:, own].sum(axis=1)
        proved = self.known & self.regular
        possible = self.meets & (~proved | self.states.any(axis=0))
        leaves = possible[~own].any(axis=0)
        ends = self.known[own].all(axis=0) & (counts.min(axis=0) == 0)
        passes = proved.all(axis=0) & (counts == 1).all(axis=0) & ~leaves
        return np.select(
            [ends & (counts.sum(axis=0) == 0), ends & leaves, ends, passes],
            ["nothing", "border", "border_fold", "passes"],
            "",
        )


def combinations_of(balance: Balance) -> list[Balance]:
    """The balances of all combinations of touching contacts, including that none touches.

    A contact on its border counts as touching, so that no state belongs to two combinations.
    """
    model = balance.model
    balances = [Balance(model, key, balance.law, balance.options) for key in model.regimes]
    for one in balances:
        one.apart = True
    return balances


def among(balances: Sequence[Balance], others: Sequence[Balance]) -> BoolArray:
    """Mask of the balances whose combination of touching contacts is that of one of the others."""
    combinations = [one.indicators for one in others]
    return np.array([one.indicators in combinations for one in balances])


def both_sides(family: Family, box: FloatArray, ends: FloatArray) -> BorderStates:
    """States at both ``ends`` of ranges of the parameter, shape (2, N), in either order.

    ``box``, shape (2, n, N), are boxes around the border points; they are widened as far as needed.
    """
    balances = combinations_of(family.balance)
    given = [family.at(end[None]) for end in ends]
    with quiet():
        between = Intervals.between(np.minimum(*given), np.maximum(*given))
        over = [one.prepared(between) for one in balances]
        meets = [~on_side(one, range_, box)[1] for one, range_ in zip(balances, over, strict=True)]
        # Widen until the Newton step of every combination stays inside.
        for _ in range(4):
            box = box + (0.25 * width_of(box) + np.spacing(np.abs(box).max(axis=0)))
            for one, range_, possible in zip(balances, over, meets, strict=True):
                step = stepped(one, box, range_).ends
                good = possible & np.isfinite(step).all(axis=(0, 1))
                box = np.where(good, np.maximum(box, step), box)
        box = box + 0.25 * width_of(box)
        parts = [
            _of_combination(family, one, box, [range_, *map(one.prepared_at, given)], possible)
            for one, range_, possible in zip(balances, over, meets, strict=True)
        ]
        gaps = Boxes(balances[0], Intervals(box), over[0]).taped(*GAPS)
    roots, states, known, regular = map(np.array, zip(*parts, strict=True))
    return BorderStates(
        box,
        np.moveaxis(roots, 0, 1),
        np.moveaxis(states, 0, 1),
        known,
        regular,
        np.array(meets),
        gaps.signs == 0,
    )


def _of_combination(
    family: Family, balance: Balance, box: FloatArray, at: Sequence[Intervals], meets: BoolArray
) -> tuple[list[FloatArray], list[BoolArray], BoolArray, BoolArray]:
    """Fields ``roots``, ``states``, ``known`` and ``regular`` of :class:`BorderStates` for one
    combination.

    ``at`` are the prepared parameters over the whole range and at its two ends.
    """
    over, *ends = at
    unique = contractors.inside(stepped(balance, box, over).ends, box)
    absent = ~meets & on_side(balance, over, box)[1]
    known = unique | absent
    if not known.all() and is_singular(balance, family):
        known = np.ones_like(known)
    roots, states = list[FloatArray](), list[BoolArray]()
    for prepared in ends:
        root = box
        for _ in range(4):  # each doubles the number of digits
            root = np.fmin(stepped(balance, root, prepared).ends, root)
        inside, beyond = on_side(balance, prepared, root)
        roots.append(root)
        states.append(inside & unique)
        known = known & (inside | beyond | ~unique)
    return roots, states, known, unique | absent


def about_border(
    family: Family, hull: FloatArray, own: BoolArray
) -> tuple[str, BorderStates, Intervals]:
    """Kind of one border point, the states near it, and the range of the parameter at whose ends
    they are.

    The point lies in ``hull``, a box of coordinates and the parameter, shape (2, n + 1, 1). The
    kind is that of :meth:`BorderStates.kinds`, with the shortest range that proves it; empty if
    none does.
    """
    middle = Intervals(hull).middle[-1]
    # Half-lengths of the range, relative to the value; the first is a little above rounding.
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
    """Separate the points at which several contacts only just touch from those of one contact.

    ``found`` is the result of the search for the border of ``contact`` in the family ``near``.
    Returns the result without the points of several contacts whose kind is proved, and these
    points. The searches for other contacts and in other families find the same points; each is
    returned for one of them only.
    """
    system, roots, balance = Augmented(near, touch(contact)), found.roots, near.balance
    candidates, point = roots.every
    if len(balance.opens) < 2 or not 0 < point.size <= balance.options.scattered:
        return found, []
    with quiet():
        given = system.prepared_at(near.begin[:, point])
        gaps = Boxes(system, Intervals(candidates), given).taped(*GAPS)
    several = (gaps.signs == 0).sum(axis=0) > 1
    balances = [family.balance for family in families]
    own = among(combinations_of(balance), balances)
    points, kept = list[Points](), np.ones(point.size, dtype=bool)
    leaves = not among([balance.across(contact)], balances)[0]
    hulls, owner = clusters(candidates[:, :, several], point[several])
    for hull, row in zip(np.moveaxis(hulls, 2, 0), owner.tolist(), strict=True):
        one = replace(near, given=near.given[:, row : row + 1])
        kind, states, span = about_border(one, hull[:, :, None], own)
        if not kind:
            continue
        kept &= ~contractors.within(candidates, hull[:, :, None])
        touched = [k for k, meets in zip(balance.opens, states.near[:, 0], strict=True) if meets]
        opened = [k for k in touched if not balance.indicators[k]]
        # Only the search for the first of these contacts returns the point: in the family in which
        # all touch, or, where the state leaves the families, in that in which only this one does.
        elsewhere = contact != touched[0] or (opened and not leaves)
        if kind == "nothing" or (kind == "border") != leaves or elsewhere:
            continue
        closed = reduce(Balance.across, opened, balance)
        closed_family = replace(one, balance=closed.extended(*touched))
        middle = Intervals(hull[:, :, None]).middle
        box = np.concatenate([states.box, span.ends[:, None]], axis=1)
        box = ends_around(middle, contractors.distance(box, middle))
        points.append(arranged(closed_family, replace(found, roots=Roots.at(box)), kind))
    count = roots.point.size
    return replace(found, roots=roots.select(kept[:count], kept[count:])), points
