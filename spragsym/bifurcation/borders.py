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
from fractions import Fraction

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
)
from ..results import EquilibriumType
from ..results.points import Ended, Points
from ..statics import stability
from ..statics.balance import Balance
from ..statics.forces import as_intervals, filled
from .defining_systems import Augmented, Family, touch
from .points import arranged, search


def borders(families: Sequence[Family]) -> list[Points]:
    """Border points along one parameter of each contact between two of these combinations of
    contacts that touch.
    """
    found = []
    for family in families:
        for contact, other in passages(families, family):
            near = family.beyond(contact)
            there = search(near, touch(contact))
            found.append(arranged(near, there, kinds_of_borders(near, there.roots.ends, other)))
    return found


def passages(families: Sequence[Family], family: Family) -> Iterator[tuple[int, Balance]]:
    """Contacts of a combination by whose loss it becomes that of another one of these families, and
    its balance.
    """
    balance, combinations = family.balance, [one.balance.pushing for one in families]
    for contact in balance.opens:
        other = balance.across(contact)
        if balance.pushing[contact] and other.pushing in combinations:
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
    names = [({*touching.split(", ")} & labels, {at}) for touching, at in every]
    return np.array([own in (names, names - at) for names, at in names], dtype=bool)


def kinds_of_borders(family: Family, ends: FloatArray, other: Balance) -> NDArray[np.str_]:
    """Kinds of border points in boxes, by the signs of det K on both sides, in the words of
    :class:`spragsym.results.Points`.
    """
    closed, open_ = (_signs(balance, family, ends) for balance in (family.balance, other))
    alone = bool((open_ == 0).any()) and _is_singular(other, family)
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


def _is_singular(balance: Balance, family: Family) -> bool:
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
    """Outcome of one border fold: which of its states is stable, and in which direction both
    vanish.
    """
    family, z, ends = at_point(points, row)
    closed, contacts = family.balance, points.parameters.model.contacts
    number = [*map(label_of, contacts)].index(points.at_border[row])
    with quiet():
        system = Augmented(family, touch(number))
        slopes = system.jacobian(Intervals(ends), system.fixed(1))
        opens = int(as_intervals(determinant([*map(list, slopes)]), (1,)).signs[0])
    opens *= int(_signs(closed, family, ends)[0])
    if not opens:
        raise ConvergenceError("whether the gap opens with the parameter is not known")
    when, open_ = "up" if opens > 0 else "down", closed.across(number)
    if not _signs(open_, family, ends)[0] and _is_singular(open_, family):
        return "", when  # no branch goes on
    given, moved, stable = family.at(z[-1:, None]), list[float](), list[bool]()
    for balance in (closed, open_):
        values = balance.floats(given)
        at = balance.at(list(z[:-1, None]), values, xp=np)
        K = filled(at.stiffness(), (1,))[:, :, 0]
        pushed = filled(balance.by_parameters(at, points.vary), (1,))[:, 0, 0]
        moved.append(-opens * float(-np.linalg.solve(K, pushed)[0]))
        code, proved, _ = stability.classified(balance, z[:-1, None], given, ends[:, :-1])
        stable.append(bool(proved[0]) and code[0] == EquilibriumType.STABLE)
    if not any(stable):
        return "", when
    first, second = moved if stable[0] else moved[::-1]
    # Rates at which two states go apart that are no more apart than this, relatively, are
    # alike.
    if abs(first - second) <= 1e-9 * max(abs(first), abs(second)):
        raise ConvergenceError("which state is the lower one is not known")
    return "lower" if first < second else "upper", when
