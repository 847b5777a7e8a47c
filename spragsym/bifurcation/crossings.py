"""States that are followed across the borders of contacts, by tubes, for many points at once.

A branch of states with a contact closed meets one with it open where the gap is 0. Short tubes of
both about there, in which the gap may have either sign, lie in one box. Where det K and det K₀ have
one sign in all of it, the gaps of both branches have one sign, too, since the forces of the two
differ by a multiple of the gap: at each value just one of the two is a state, and the state goes
on. Where the signs differ, both are states on one side only, and the state ends, see
:mod:`spragsym.bifurcation.borders`; it ends, too, where nothing touches any more.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..numerics import contractors
from ..numerics.arithmetic import determinant
from ..numerics.certified_roots import stepped
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    quiet,
)
from ..statics.forces import as_intervals
from ..statics.precise_balance import on_side
from ..statics.search import balances_of
from .borders import kinds_of_borders
from .defining_systems import Augmented, Family, touch
from .tubes import Place, Tubes, sizes_of


@dataclass(frozen=True)
class Crossed:
    """States that have come to the border of a contact: their numbers, the border points z = (q,
    v), shape (n + 1, N), and errors of v; of those that pass it the places behind it, and tubes.

    The ``kind`` is that of :class:`spragsym.bifurcation.paths.ModelEnd`.
    """

    rows: IntArray
    contact: int
    kind: str
    z: FloatArray
    error: FloatArray
    place: Place
    tubes: Tubes


def crossed(tubes: Tubes, here: Place, goal: FloatArray) -> Iterator[Crossed]:
    """States of points without width that stand before a border on their way to a goal, where it is
    proved that they pass it or end there.
    """
    balance, left = tubes.balance, np.flatnonzero(here.sure & (here.v != goal))
    combinations = [one.pushing for one in balances_of(balance.model)]
    # How far the tubes about the border go, over the way that is left: the wider of them first.
    tries = itertools.product((2.0**-10, 2.0**-16), balance.opens)
    away = set[int]()
    for share, contact in tries if left.size else ():
        if contact in away:
            continue
        some, at, way = tubes[left], here[left], (goal - here.v)[left]
        near = replace(some, balance=balance.extended(contact))
        family = Family(None, near.balance, (tubes.vary,), near.fixed, np.zeros((1, 2)))
        system, given = Augmented(family, touch(contact)), near.bounds(Intervals.point(at.v))
        z = _border(system, given, at.z, tubes.options.newton_steps)
        room, ahead = share * np.abs(way), (z[-1] - at.v) * np.sign(way)
        met = (ahead >= 0) & (ahead < np.abs(way))
        if not met.any():
            away.add(contact)
            continue
        first = np.where(ahead > room, z[-1] - room * np.sign(way), at.v)
        last = z[-1] + np.sign(way) * np.minimum(room, np.abs(way) - ahead)
        at = some.followed(at, np.where(met, first, at.v))
        good, end, tube = near.segment(at, _moved(at, np.where(met, last, at.v)))
        good &= met & (at.v == first)
        beyond, box = replace(some, balance=balance.across(contact)), tube.box().ends
        there, over, passes = end, good.copy(), np.zeros_like(good)
        if beyond.balance.pushing in combinations:
            back = replace(near, balance=near.balance.across(contact))
            there = beyond.place(end.z)
            also, _, behind = back.segment(there, _moved(there, first))
            both = np.maximum(box, behind.box().ends)
            passes = good & also & (kinds_of_borders(family, both, back.balance) == "passes")
            over = good & (kinds_of_borders(family, box, back.balance) == "border_fold")
        wide = ends_around(z, tubes.options.half_width * sizes_of(z, 1.0))
        step, alone = _enclosed(system, given, wide, box)
        error = contractors.distance(step, z)[-1]
        arrived = end.box()
        bounds = near.bounds(arrived[-1])
        over &= alone & on_side(beyond.balance, bounds, arrived.ends[:, :-1])[0]
        end_kind = "border_fold" if beyond.balance.pushing in combinations else "border"
        for kind, rows in (("passes", np.flatnonzero(passes)), (end_kind, np.flatnonzero(over))):
            if rows.size:
                yield Crossed(
                    left[rows], contact, kind, z[:, rows], error[rows], there[rows], beyond[rows]
                )
        left = left[~(passes | over)]


def followed_across(tubes: Tubes, here: Place, goal: FloatArray) -> tuple[Tubes, Place]:
    """One state as ``vary`` moves to a goal, past borders: the last place that is proved, and tubes
    there.
    """
    here = tubes.followed(here, goal)
    while passed := [part for part in crossed(tubes, here, goal) if part.kind == "passes"]:
        tubes = passed[0].tubes
        here = tubes.followed(passed[0].place, goal)
    return tubes, here


def _moved(place: Place, v: FloatArray) -> FloatArray:
    """The middle of a place with other values of the parameter that varies."""
    return np.vstack([place.z[:-1], v])


def _border(system: Augmented, given: Intervals, z: FloatArray, steps: int) -> FloatArray:
    """About the border point that is the next one to z, by Newton's method."""
    with quiet():
        for _ in range(steps):
            z = Intervals(stepped(system, Intervals.point(z).ends, given).ends).middle
    return z


def _enclosed(
    system: Augmented, given: Intervals, wide: FloatArray, box: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Boxes around border points from small ones, and where it is proved that there is
    one, and no other in a box.
    """
    with quiet():
        step = stepped(system, wide, given).ends
        slopes = system.jacobian(Intervals(np.maximum(box, wide)), given)
    regular = as_intervals(determinant([*map(list, slopes)]), wide.shape[2:]).signs != 0
    return step, regular & contractors.inside(step, wide)
