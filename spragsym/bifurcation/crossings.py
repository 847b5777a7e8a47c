"""Followed states at the borders of contacts, for many points of the parameters at once.

A branch of states comes to a border point where the gap of a contact is 0, or the gaps of several
are. There it meets branches of other combinations of touching contacts. In a box around the point
each combination has one solution for every value of the parameter, whatever the signs of its gaps
are. The solutions whose gaps have the right signs are states. Which of them are states before the
border, and which behind it, tells whether the followed state passes the border or ends; see
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
class BorderArrivals:
    """Followed states that arrive at a border, all with the same outcome.

    ``rows`` are their numbers, shape (N,), ``z`` the border points (q, v), shape (n + 1, N), and
    ``error`` bounds the errors of v. ``contacts`` marks the contacts whose gap is 0 there, shape
    (contacts that open, N). ``kind`` is ``"passes"``, or that of
    :class:`spragsym.bifurcation.paths.ModelEnd` where the state ends. ``place`` and ``tubes`` are
    those of the states behind the border, if they pass it.
    """

    rows: IntArray
    contacts: BoolArray
    kind: str
    z: FloatArray
    error: FloatArray
    place: Place
    tubes: Tubes


def border_arrivals(tubes: Tubes, start: Place, goal: FloatArray) -> Iterator[BorderArrivals]:
    """States of places that are proved to pass a border, or to end there, on their way to a goal.

    The tubes must be those of points. A state of which neither is proved is left out.
    """
    balance = tubes.balance
    balances = combinations_of(balance)
    own = among(balances, balances_of(balance.model))
    current = int(among(balances, [balance]).argmax())
    left = np.flatnonzero(start.proved & (start.v != goal))
    absent = set[int]()  # contacts whose border no state comes to
    # Half-lengths of the ranges around a border, as shares of the way that is left. The longest
    # comes first: tubes end before the border, and approach it in ever smaller steps.
    for share, contact in itertools.product((2.0**-5, 2.0**-10, 2.0**-16), balance.opens):
        if contact in absent or not left.size:
            continue
        own_tubes, place = tubes[left], start[left]
        family = Family(None, balance.extended(), (tubes.vary,), own_tubes.fixed, np.zeros((1, 2)))
        z = _border_point(family, contact, place.z, tubes.options.newton_steps)
        ends, on_way = _ranges(z[-1], place.v, goal[left], share)
        if not on_way.any():
            absent.add(contact)
            continue
        place = own_tubes.followed(place, ends[0])
        rows = np.flatnonzero(on_way & place.proved & (place.v == ends[0]))
        if not rows.size:
            continue
        own_tubes, place, z, ends = own_tubes[rows], place[rows], z[:, rows], ends[:, rows]
        family = replace(family, given=own_tubes.fixed)
        # The box reaches as far behind the border as the state lies before it.
        mirrored = Intervals.point(2 * z - place.z)
        found = both_sides(family, np.maximum(place.box().ends, mirrored.ends)[:, :-1], ends)
        error = _distances(family, own, found, z, ends)
        # A border point elsewhere in the range is not the one at z.
        is_at_z = found.states[0, current] & (error <= 1e-6 * np.abs(ends[1] - ends[0]))
        kinds = np.where(is_at_z, found.kinds(own), "")
        behind = np.where(kinds == "passes", found.states[1].argmax(axis=0), current)
        for kind, number in sorted({*zip(kinds.tolist(), behind.tolist(), strict=True)}):
            if not kind:
                continue
            chosen = np.flatnonzero((kinds == kind) & (behind == number))
            beyond = replace(own_tubes[chosen], balance=balances[number])
            roots = found.roots[1, number][..., chosen]
            z_behind = np.vstack([Intervals(roots).middle, ends[1, chosen]])
            yield BorderArrivals(
                left[rows[chosen]],
                found.near[:, chosen],
                kind,
                z[:, chosen],
                error[chosen],
                beyond.place(z_behind, error=relative_error(roots, z_behind[:-1])),
                beyond,
            )
        left = np.delete(left, rows[kinds != ""])


def _ranges(
    border: FloatArray, v: FloatArray, goal: FloatArray, share: float
) -> tuple[FloatArray, BoolArray]:
    """Ranges of the parameter around its values at ``border``, and whether these lie between v and
    the goal.

    Ranges have the shape (2, N), the end next to v first. They extend by a ``share`` of the way
    from v to the goal, but not beyond either.
    """
    way = goal - v
    forward, room = np.sign(way), share * np.abs(way)
    ahead = (border - v) * forward
    on_way = (ahead >= 0) & (ahead < np.abs(way))
    first = np.where(on_way & (ahead > room), border - room * forward, v)
    last = border + forward * np.minimum(room, np.abs(way) - ahead)
    return np.array([first, last]), on_way


def followed_across(tubes: Tubes, start: Place, goal: FloatArray) -> tuple[Tubes, Place]:
    """One state as ``vary`` moves to a goal, past borders of contacts.

    Returns the tubes of the last combination of touching contacts, and the last proved place.
    """
    place = tubes.followed(start, goal)
    while passed := [one for one in border_arrivals(tubes, place, goal) if one.kind == "passes"]:
        tubes = passed[0].tubes
        place = tubes.followed(passed[0].place, goal)
    return tubes, place


def _border_point(family: Family, contact: int, z: FloatArray, steps: int) -> FloatArray:
    """Approximate border point of a contact, by Newton's method from z, shape (n + 1, N)."""
    system = Augmented(family, touch(contact))
    given = system.prepared_at(family.begin)
    with quiet():
        for _ in range(steps):
            z = Intervals(stepped(system, Intervals.point(z).ends, given).ends).middle
    return z


def _distances(
    family: Family, own: BoolArray, found: BorderStates, z: FloatArray, ends: FloatArray
) -> FloatArray:
    """Bounds of |v − v(z)| over all border points in the boxes, of the combinations ``own``.

    A bound is infinite unless each of these points is proved to be unique in its box.
    """
    out, low, high = np.zeros(z.shape[1]), ends.min(axis=0), ends.max(axis=0)
    box = np.concatenate([found.box, Intervals.between(low, high).ends[:, None]], axis=1)
    balances = combinations_of(family.balance)
    for number, row in itertools.product(np.flatnonzero(own).tolist(), range(len(found.near))):
        possible = found.meets[number] & found.regular[number] & found.near[row]
        if not possible.any():
            continue
        contact = family.balance.opens[row]
        system = Augmented(replace(family, balance=balances[number].extended()), touch(contact))
        given = system.prepared_at(family.begin)
        with quiet():
            root = stepped(system, box, given).ends
            unique = contractors.inside(root, box)
            for _ in range(3):  # each doubles the number of digits
                root = np.fmin(stepped(system, root, given).ends, root)
        distance = np.where(unique, contractors.distance(root, z)[-1], np.inf)
        out = np.maximum(out, np.where(possible, distance, 0.0))
    return out
