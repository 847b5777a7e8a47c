"""Border points along one parameter: states in which one of several contacts only just touches.

At a border point the branch of states with that contact closed meets the branch with it open. The
contact force vanishes with the gap, so the stiffness K with the contact closed and K₀ with it open
differ by a matrix of rank one: K = K₀ + u gᵀ, where g is the gradient of the gap. By the
Sherman–Morrison formula, the gap changes along the closed branch at det K₀/det K times its rate
along the open branch. States on the closed branch have gap ≤ 0, those on the open branch gap ≥ 0.

- If det K and det K₀ have the same sign, one branch continues the other: the state passes.
- If they have opposite signs, both branches lie on the same side of the parameter and end there: a
  border fold.
- If det K₀ is 0 for all states and parameters, nothing but this contact supports the body. There is
  no open branch, so this is a border fold too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ConvergenceError
from ..models.model import Touching, label_of
from ..numerics import contractors
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Int8Array,
    IntArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    spans_of,
)
from ..results import EquilibriumType
from ..results.points import Ended, Points, nothing_ends
from ..statics import stability
from ..statics.balance import Balance
from ..statics.forces import as_intervals
from ..statics.search import balances_of
from .border_states import about_border, among, at_once, combinations_of
from .defining_systems import Family, touch
from .lines_of_states import is_singular
from .points import arranged, matrices, search


def borders(families: Sequence[Family], leaving: bool = False) -> list[Points]:
    """Border points along one parameter at which a contact opens, between two of the families.

    Each family has another combination of touching contacts. With ``leaving``, the points at which
    the combination behind the border belongs to no family: no contact touches there.
    """
    found = list[Points]()
    for family in families:
        for contact, other in openings(families, family, leaving):
            near = family.beyond(contact)
            single, several = at_once(families, near, contact, search(near, touch(contact)))
            kinds = "border" if leaving else kinds_of_borders(near, single.roots.ends, other)
            found += [arranged(near, single, kinds), *several]
    return found


def openings(
    families: Sequence[Family], family: Family, leaving: bool = False
) -> Iterator[tuple[int, Balance]]:
    """Contacts of one family that may open, each with the balance in which it is open.

    Only contacts whose opening leads to the combination of another family; with ``leaving``, only
    those whose opening leads to that of none.
    """
    balance = family.balance
    combinations = [each.balance.indicators for each in families]
    for contact in balance.opens:
        other = balance.across(contact)
        if balance.indicators[contact] and (other.indicators in combinations) != leaving:
            yield contact, other


def touching_at(points: Points, row: int) -> Touching:
    """The contacts that touch at a point."""
    model = points.parameters.model
    if not model.has_regimes:
        return True
    return tuple(str(points.touching[row]).split(", "))


def reachable(points: Points, balance: Balance) -> BoolArray:
    """Mask of the points that a branch of one combination of contacts may reach.

    These are the points of the same combination, and border points at which more contacts close.
    """
    if not balance.model.has_regimes:
        return np.ones(len(points), dtype=bool)
    labels = {label_of(entry) for entry in balance.model.contacts}
    own = labels.intersection(balance.touching.split(", "))
    mask = list[bool]()
    for touching, at_border in zip(points.touching, points.at_border, strict=True):
        closed = labels.intersection(touching.split(", "))
        mask.append(closed.difference(at_border.split(", ")) <= own <= closed)
    return np.array(mask, dtype=bool)


def kinds_of_borders(family: Family, ends: FloatArray, other: Balance) -> NDArray[np.str_]:
    """Kinds of border points in boxes, by the signs of det K on both sides, as the column ``kind``
    of :class:`spragsym.results.Points`.

    ``other`` is the balance with the contact open. Where a sign is not proved, ``"border"``.
    """
    closed = _determinant_signs(family.balance, family, ends)
    opened = _determinant_signs(other, family, ends)
    unsupported = bool((opened == 0).any()) and is_singular(other, family)
    return np.select(
        [closed * opened > 0, (closed * opened < 0) | ((closed != 0) & unsupported)],
        ["passes", "border_fold"],
        "border",
    )


def _determinant_signs(balance: Balance, family: Family, ends: FloatArray) -> Int8Array:
    """Signs of det K over boxes of coordinates and the parameter, 0 where they are not proved."""
    n, shape = balance.n, ends.shape[2:]
    with quiet():
        over = Intervals.between(family.at(-ends[0, n:]), family.at(ends[1, n:]))
        at = balance.state(Intervals(ends[:, :n]), balance.prepared(over))
        return as_intervals(determinant(at.slopes), shape).signs.astype(np.int8)


def at_point(points: Points, row: int) -> tuple[Family, FloatArray, FloatArray]:
    """The family of a point; its coordinates and varying parameters, shape (number,); and a box
    that holds their exact values, shape (2, number, 1).

    The family is that of the model without closed forms.
    """
    p = points.parameters.of(points.parameters.model.search)
    family = Family.of(p, points.vary, balance=Balance(p.model, touching_at(points, row)))
    z = np.array([float(points[name][row]) for name in (*family.balance.coordinates, *points.vary)])
    return family, z, ends_around(z, points.error[row] * scale_of(z))[:, :, None]


#: How many λ lie on the imaginary axis at points of each kind.
_CRITICAL = {"fold": 1, "pitchfork": 1, "cusp": 1, "touch": 1, "BT": 2, "ZH": 3, "HH": 4}


def unstable_numbers(points: Points) -> IntArray:
    """Columns ``unstable_before`` and ``unstable_after`` of points that are no onsets along one
    parameter: the least and the largest number of growing λ beside each, shape (2, points).
    """
    from .normal_forms import growing_beside  # many who ask for folds never ask for this

    found = np.full((2, len(points)), -1)
    for row, kind in enumerate(points.kind.tolist()):
        if kind not in _CRITICAL:
            continue
        family, z, ends = at_point(points, row)
        given, n = family.at(z[family.balance.n :, None])[:, 0], family.balance.n
        radii = contractors.distance(ends[:, :, 0], z)
        critical = _CRITICAL[kind]
        others = growing_beside(family.balance, given, z[:n], points.vary, radii, critical)
        if others < 0 and critical == 1:
            others = _undamped_others(family, z)
        if others >= 0:
            found[:, row] = others, others + critical
    return found


def _undamped_others(family: Family, z: FloatArray) -> int:
    """How many λ grow at a singular state without damping, by the roots κ = −λ² but the one that is
    0, in floats; −1 where these do not tell, or something damps.
    """
    over = Intervals.point(family.at(z[family.balance.n :, None]))
    if family.balance.gyroscopic or stability.is_damped(family.balance, over):
        return -1
    M, _, K = matrices(family, z[:, None], damping=False)
    κ = stability.squares(M, K)[0]
    κ = np.delete(κ, np.abs(κ).argmin())
    size = 1e-9 * np.abs(κ).max(initial=0.0)
    swings = (np.abs(κ.imag) <= 1e-3 * size) & (κ.real > size)
    told = swings | (np.abs(κ.imag) > size) | (κ.real < -size)
    return int((~swings).sum()) if told.all() else -1


def counted_beside(points: Points, row: int, damping: bool) -> tuple[int, int]:
    """How many λ grow in the states a little below and above an onset along one parameter, by
    floats at two distances that have to agree; −1 where they do not, or growth is not told from 0.
    """
    family, z, _ = at_point(points, row)
    q, value, found = z[:-1, None], z[-1], list[int]()
    for side in (-1.0, 1.0):
        numbers = {
            _counted(family, q, value + side * distance * (abs(value) or 1.0), damping)
            for distance in (1e-3, 1e-4)
        }
        found.append(numbers.pop() if len(numbers) == 1 else -1)
    return found[0], found[1]


def _counted(family: Family, guess: FloatArray, value: float, damping: bool) -> int:
    """How many λ grow in the state near a guess, shape (n, 1); −1 where floats do not tell."""
    at = np.array([[value]])
    with quiet():
        q = family.balance.guessed(guess, family.balance.prepared(Intervals.point(family.at(at))))
        λ = stability.roots(*matrices(family, np.concatenate([q, at]), damping))[0]
    growth = λ.real / np.abs(λ).max()
    # Of more than rounding; without damping two frequencies are near each other, which adds to it,
    # and λ of stable states have no real part.
    least = 1e-11 if damping else 1e-9
    told = (np.abs(growth) > least) | ((np.abs(growth) < 1e-11) & (not damping))
    near = np.abs(q - guess).max() <= 1e-2 * max(1.0, float(np.abs(guess).max()))
    return int((growth > least).sum()) if near and told.all() else -1


def with_numbers(points: Points) -> Ended:
    """What ends at points that are neither folds nor borders: nothing; with the numbers of growing
    λ.
    """
    return replace(nothing_ends(points), unstable=unstable_numbers)


def enter_border_folds(points: Points, found: Ended) -> None:
    """Enter into ``found`` which state ends at each border fold, and in which direction."""
    for row in np.flatnonzero(points.kind == "border_fold").tolist():
        try:
            found.ends[row], found.when[row] = _ended_state(points, row)
        except ConvergenceError:
            found.ends[row] = found.when[row] = "undecided"


def _ended_state(points: Points, row: int) -> tuple[str, str]:
    """Columns ``ends`` and ``when`` at one border fold.

    ``ends`` says whether the stable state is the lower or the upper one, by its first coordinate.
    It is empty if the state has no partner, or if no state is stable. ``when`` is the direction of
    the parameter in which the states vanish. Raises ConvergenceError if one is not proved.
    """
    family, _, hull = at_point(points, row)
    balances = combinations_of(family.balance)
    kind, found, span = about_border(
        family, hull, among(balances, balances_of(family.balance.model))
    )
    if kind != "border_fold":
        raise ConvergenceError("which states end there is not known")
    # The end of the range at which states exist: 0 is the lower one, 1 the upper one.
    side = int(found.states[1].any())
    when = "down" if side else "up"
    given = family.at(spans_of(span.ends)[..., side][None])
    first_coordinates, stable = [], []
    for number in np.flatnonzero(found.states[side]).tolist():
        ends = found.roots[side, number]
        states = Intervals(ends).middle
        code, proved, _ = stability.classified(balances[number], states, given, ends)
        stable.append(bool(proved[0]) and code[0] == EquilibriumType.STABLE)
        first_coordinates.append(spans_of(ends)[0, 0])
    if len(stable) == 1 or not any(stable):
        return "", when
    low, high = first_coordinates.pop(stable.index(True))
    if all(high < other for other, _ in first_coordinates):
        return "lower", when
    if all(low > other for _, other in first_coordinates):
        return "upper", when
    raise ConvergenceError("whether the state is the lowest or the highest one is not known")
