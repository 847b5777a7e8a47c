"""Border points along one parameter: states in which one of several contacts only just touches.

There a branch of states with that contact closed meets one with it open. With the stiffness K of
the one and K₀ of the other, and g the slope of the gap, F_K − F_K₀ is u φ(gap) with φ(0) = 0, so
that K = K₀ + u gᵀ, and by the formula of Sherman and Morrison the gap changes along the first
branch at 1/(1 + gᵀ K₀⁻¹ u) = det K₀/det K times its rate along the second. The first has gap ≤ 0,
the second gap ≥ 0. So where both determinants have one sign the state passes from one combination
of contacts into the other; where they have not, both branches lie on one side of the parameter and
end: a border fold. It is one, too, where det K₀ is 0 for all states and parameters, as of a body
that nothing but this contact supports: no branch goes on.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ConvergenceError
from ..models.model import Touching, label_of
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Int8Array,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    spans_of,
)
from ..results import EquilibriumType
from ..results.points import Ended, Points
from ..statics import stability
from ..statics.balance import Balance
from ..statics.forces import as_intervals
from ..statics.search import balances_of
from .border_states import (
    about_border,
    among,
    at_once,
    combinations_of,
    is_singular,
)
from .defining_systems import Family, touch
from .points import arranged, search


def borders(families: Sequence[Family], leaving: bool = False) -> list[Points]:
    """Border points along one parameter of each contact between two of these combinations of
    contacts that touch; or ``leaving`` all of them, behind which nothing touches any more.
    """
    found = list[Points]()
    for family in families:
        for contact, other in passages(families, family, leaving):
            near = family.beyond(contact)
            there, more = at_once(families, near, contact, search(near, touch(contact)))
            kinds = "border" if leaving else kinds_of_borders(near, there.roots.ends, other)
            found += [arranged(near, there, kinds), *more]
    return found


def passages(
    families: Sequence[Family], family: Family, leaving: bool = False
) -> Iterator[tuple[int, Balance]]:
    """Contacts of a combination by whose loss it becomes that of another one of these families, or
    ``leaving`` them of none, and its balance.
    """
    balance, combinations = family.balance, [one.balance.pushing for one in families]
    for contact in balance.opens:
        other = balance.across(contact)
        if balance.pushing[contact] and (other.pushing in combinations) != leaving:
            yield contact, other


def combination(points: Points, row: int) -> Touching:
    """The contacts that touch at a point."""
    model = points.parameters.model
    if not model.has_regimes:
        return True
    return tuple(str(points.touching[row]).split(", "))


def met_by(points: Points, balance: Balance) -> BoolArray:
    """Points that a state of one combination of contacts may come to: those of its own, and borders
    at which one more contact is regained.
    """
    if not balance.model.has_regimes:
        return np.ones(len(points), dtype=bool)
    every = zip(points.touching, points.at_border, strict=True)
    labels = {label_of(entry) for entry in balance.model.contacts}
    own = {*balance.touching.split(", ")} & labels
    names = [({*touching.split(", ")} & labels, {*at.split(", ")}) for touching, at in every]
    return np.array([names - at <= own <= names for names, at in names], dtype=bool)


def kinds_of_borders(family: Family, ends: FloatArray, other: Balance) -> NDArray[np.str_]:
    """Kinds of border points in boxes, by the signs of det K on both sides, in the words of
    :class:`spragsym.results.Points`.
    """
    closed, open_ = (_signs(balance, family, ends) for balance in (family.balance, other))
    alone = bool((open_ == 0).any()) and is_singular(other, family)
    return np.select(
        [closed * open_ > 0, (closed * open_ < 0) | ((closed != 0) & alone)],
        ["passes", "border_fold"],
        "border",
    )


def _signs(balance: Balance, family: Family, ends: FloatArray) -> Int8Array:
    """Signs of det K over boxes of coordinates and the parameter, 0 where they are not known."""
    n, shape = balance.n, ends.shape[2:]
    with quiet():
        over = Intervals.between(family.at(-ends[0, n:]), family.at(ends[1, n:]))
        at = balance.state(Intervals(ends[:, :n]), balance.prepared(over))
        return as_intervals(determinant(at.slopes), shape).signs.astype(np.int8)


def at_point(points: Points, row: int) -> tuple[Family, FloatArray, FloatArray]:
    """The family without closed forms that a point is of, its coordinates and parameters, and a box
    that holds them exactly, (2, number, 1).
    """
    p = points.parameters.of(points.parameters.model.search)
    family = Family.of(p, points.vary, balance=Balance(p.model, combination(points, row)))
    z = np.array([float(points[name][row]) for name in (*family.balance.coordinates, *points.vary)])
    return family, z, ends_around(z, points.error[row] * scale_of(z))[:, :, None]


def at_borders(points: Points, found: Ended) -> None:
    """Enter which state ends at border folds, and in which direction of the parameter."""
    for row in np.flatnonzero(points.kind == "border_fold").tolist():
        try:
            found.ends[row], found.when[row] = _at_border(points, row)
        except ConvergenceError:
            found.ends[row] = found.when[row] = "undecided"


def _at_border(points: Points, row: int) -> tuple[str, str]:
    """Outcome of one border fold: which of its states is stable, and in which direction they
    vanish.
    """
    family, _, hull = at_point(points, row)
    balances = combinations_of(family.balance)
    kind, found, span = about_border(
        family, hull, among(balances, balances_of(family.balance.model))
    )
    if kind != "border_fold":
        raise ConvergenceError("which states end there is not known")
    side = int(found.states[1].any())
    given, firsts, stable = family.at(spans_of(span.ends)[..., side][None]), [], []
    for number in np.flatnonzero(found.states[side]).tolist():
        ends = found.roots[side, number]
        states = Intervals(ends).middle
        code, proved, _ = stability.classified(balances[number], states, given, ends)
        stable.append(bool(proved[0]) and code[0] == EquilibriumType.STABLE)
        firsts.append(spans_of(ends)[0, 0])
    when = ("down", "up")[1 - side]
    if len(stable) == 1 or not any(stable):  # no branch goes on, or none that is followed
        return "", when
    low, high = firsts.pop(stable.index(True))
    if all(high < other for other, _ in firsts):
        return "lower", when
    if all(low > other for _, other in firsts):
        return "upper", when
    raise ConvergenceError("whether the state is the lowest or the highest one is not known")
