"""States that are followed across the borders of contacts, for many points at once.

A branch of states meets others where gaps are 0, with these contacts open or closed. In a box about
there each combination of contacts has one state for every value, whatever the signs of its gaps
are; which of them are states before the border and behind it tells whether the state goes on, see
:mod:`spragsym.bifurcation.border_states`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..numerics import contractors
from ..numerics.certified_roots import relative_error, stepped
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    quiet,
)
from ..statics.search import balances_of
from .border_states import (
    BorderStates,
    among,
    both_sides,
    combinations_of,
)
from .defining_systems import Augmented, Family, touch
from .tubes import Place, Tubes


@dataclass(frozen=True)
class Crossed:
    """States that have come to the borders of contacts: their numbers, the border points z = (q,
    v), shape (n + 1, N), and errors of v; which contacts, shape (contacts that open, N); of those
    that pass it the places behind it, and tubes.

    The ``kind`` is that of :class:`spragsym.bifurcation.paths.ModelEnd`.
    """

    rows: IntArray
    near: BoolArray
    kind: str
    z: FloatArray
    error: FloatArray
    place: Place
    tubes: Tubes


def crossed(tubes: Tubes, here: Place, goal: FloatArray) -> Iterator[Crossed]:
    """States of points without width that stand before a border on their way to a goal, where it is
    proved that they pass it or end there.
    """
    balance, left = tubes.balance, np.flatnonzero(here.proved & (here.v != goal))
    every = combinations_of(balance)
    own, mine = among(every, balances_of(balance.model)), int(among(every, [balance]).argmax())
    # How far the ranges about the border go, over the way that is left: the wider of them first, as
    # tubes, whose boxes may not meet it, come to it in ever smaller steps.
    tries = itertools.product((2.0**-5, 2.0**-10, 2.0**-16), balance.opens)
    away = set[int]()
    for share, contact in tries if left.size else ():
        if contact in away:
            continue
        some, at, way = tubes[left], here[left], (goal - here.v)[left]
        family = Family(None, balance.extended(), (tubes.vary,), some.fixed, np.zeros((1, 2)))
        z = _border(family, contact, at.z, tubes.options.newton_steps)
        room, forward = share * np.abs(way), np.sign(way)
        ahead = (z[-1] - at.v) * forward
        met = (ahead >= 0) & (ahead < np.abs(way))
        if not met.any():
            away.add(contact)
            continue
        first = np.where(met & (ahead > room), z[-1] - room * forward, at.v)
        last = z[-1] + forward * np.minimum(room, np.abs(way) - ahead)
        at = some.followed(at, first)
        rows = np.flatnonzero(met & at.proved & (at.v == first))
        if not rows.size:
            continue
        some, at, z = some[rows], at[rows], z[:, rows]
        family = replace(family, given=some.fixed)
        # As far beyond the border as it lies before it.
        q = np.maximum(at.box().ends[:, :-1], Intervals.point(2 * z - at.z).ends[:, :-1])
        ends = np.array([first[rows], last[rows]])
        found = both_sides(family, q, ends)
        kinds = found.kinds(own)
        error = _distances(family, own, found, z, ends)
        # Other borders than those at the point, some share of the range away, are not among these.
        kinds[~(found.states[0, mine] & (error <= 1e-6 * np.abs(ends[1] - ends[0])))] = ""
        behind = np.where(kinds == "passes", found.states[1].argmax(axis=0), mine)
        for kind, number in sorted({*zip(kinds.tolist(), behind.tolist(), strict=True)}):
            if not kind:
                continue
            picked = np.flatnonzero((kinds == kind) & (behind == number))
            beyond, roots = replace(some[picked], balance=every[number]), found.roots[1, number]
            there = np.vstack([Intervals(roots).middle, ends[1]])[:, picked]
            place = beyond.place(there, error=relative_error(roots[..., picked], there[:-1]))
            about = left[rows[picked]], found.near[:, picked], kind, z[:, picked], error[picked]
            yield Crossed(*about, place, beyond)
        left = np.delete(left, rows[kinds != ""])


def followed_across(tubes: Tubes, here: Place, goal: FloatArray) -> tuple[Tubes, Place]:
    """One state as ``vary`` moves to a goal, past borders: the last place that is proved, and tubes
    there.
    """
    here = tubes.followed(here, goal)
    while passed := [part for part in crossed(tubes, here, goal) if part.kind == "passes"]:
        tubes = passed[0].tubes
        here = tubes.followed(passed[0].place, goal)
    return tubes, here


def _border(family: Family, contact: int, z: FloatArray, steps: int) -> FloatArray:
    """About the border point of a contact that is the next one to z, by Newton's method."""
    system = Augmented(family, touch(contact))
    given = system.prepared_at(family.begin)
    with quiet():
        for _ in range(steps):
            z = Intervals(stepped(system, Intervals.point(z).ends, given).ends).middle
    return z


def _distances(
    family: Family, own: BoolArray, found: BorderStates, z: FloatArray, ends: FloatArray
) -> FloatArray:
    """How far along the parameter the border points of the states of combinations, its ``own``, may
    be from z; infinite where not each is proved to be the only one in the box.
    """
    out, low, high = np.zeros(z.shape[1]), ends.min(axis=0), ends.max(axis=0)
    box = np.concatenate([found.box, Intervals.between(low, high).ends[:, None]], axis=1)
    each = combinations_of(family.balance)
    for number, row in itertools.product(np.flatnonzero(own).tolist(), range(len(found.near))):
        asked = found.meets[number] & found.regular[number] & found.near[row]
        if not asked.any():
            continue
        contact = family.balance.opens[row]
        system = Augmented(replace(family, balance=each[number].extended()), touch(contact))
        given = system.prepared_at(family.begin)
        with quiet():
            there = stepped(system, box, given).ends
            alone = contractors.inside(there, box)
            for _ in range(3):  # each doubles the number of digits
                there = np.fmin(stepped(system, there, given).ends, there)
        off = np.where(alone, contractors.distance(there, z)[-1], np.inf)
        out = np.maximum(out, np.where(asked, off, 0.0))
    return out
