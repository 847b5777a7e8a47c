"""Equilibria and cusps to any number of digits.

Roots are isolated over boxes of floats, then narrowed by the Krawczyk operator in ball arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from itertools import chain
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..core.questions import Method, question
from ..core.type_variables import T
from ..models.forces import columns_of
from ..models.parameters import ParameterSet, Ranges
from ..numerics import balls, certified_roots
from ..numerics.arithmetic import Number, cofactor
from ..numerics.balls import FIRST_BITS, XP, UndecidedSign, as_mpf, as_numbers, with_enough_bits
from ..numerics.certified_roots import Roots
from ..numerics.decimals import float_above
from ..numerics.interval_arrays import FloatArray, Intervals
from ..numerics.precise_roots import narrowed
from ..results.precise_states import CuspProof, PreciseCusp, PreciseEquilibria, PreciseEquilibrium
from ..statics.balance import Balance, PreciseBalance
from ..statics.forces import Evaluation
from ..statics.precise_balance import exact_in_part, reduced_by_turns
from ..statics.regions import region
from ..statics.search import ContactArgument, balances_of, roots_of
from ..statics.stability import type_at
from .defining_systems import Augmented, Family, cusp
from .singularities import isolated


@question
def precise_equilibria(
    p: ParameterSet,
    exact: Mapping[str, Any],
    contact: ContactArgument,
    digits: int,
    *,
    method: Method = "auto",
) -> PreciseEquilibria:
    """All equilibria of one point, each number with an error of at most 10^−digits max(1,
    |number|).

    ``p`` is any set of the model. ``exact`` has all parameters by name: a rational number, or a
    function that returns a ball at the current precision. ``contact`` is as for
    :func:`spragsym.equilibria`.
    """
    balances = balances_of(p.model, contact=contact)
    parts = [_in_combination(balance, exact, digits) for balance in balances]
    first = balances[0].coordinates[0]
    states = sorted(chain(*(part.states for part in parts)), key=lambda one: one.numbers[first])
    return PreciseEquilibria(
        tuple(states),
        all(part.complete for part in parts),
        _hull([part.region for part in parts]),
    )


def _in_combination(balance: Balance, exact: Mapping[str, Any], digits: int) -> PreciseEquilibria:
    """The equilibria of one combination of touching contacts."""
    found, searched, whole = _isolated(balance, exact)
    if found.undecided_point.size:
        advice = ""
        if not _held(_ends(exact)):
            advice = (
                ", or give only numbers that floats hold, as 0.5: these are searched more closely"
            )
        raise ConvergenceError(
            f"equilibria: {found.undecided_point.size} boxes are not decided; change a parameter a "
            f"little{advice}"
        )

    def attempt(bits: int) -> list[PreciseEquilibrium]:
        system = PreciseBalance(balance, np.zeros(len(balance.parameters)), bits, _ends(exact))
        return _each(found, partial(_state, system, digits))

    states = with_enough_bits(digits, attempt, "equilibria")
    return PreciseEquilibria(
        tuple(states), bool(whole.all()), _searched(balance.coordinates, searched)
    )


def _each(found: Roots, tell: Callable[[FloatArray, FloatArray], T | None]) -> list[T]:
    """The results of ``tell`` for all roots, without None; its arguments are the box of a root and
    the box in which it is alone.
    """
    results = map(tell, *(np.moveaxis(boxes, 2, 0) for boxes in (found.ends, found.alone)))
    return [one for one in results if one is not None]


def _searched(names: Sequence[str], region: FloatArray) -> Ranges:
    """The searched region as ranges by name."""
    return {
        name: (-float(low), float(high))
        for name, low, high in zip(names, *region[:, :, 0], strict=True)
    }


def _hull(regions: Sequence[Ranges]) -> Ranges:
    """The hull of searched regions, as ranges by name."""
    return {
        name: (min(one[name][0] for one in regions), max(one[name][1] for one in regions))
        for name in regions[0]
    }


def _ends(exact: Mapping[str, Any]) -> dict[str, tuple[Fraction, Fraction]]:
    """Lower and upper end of every parameter at the current precision; equal for rational ones."""
    return {
        name: balls.ends(value()) if callable(value) else (value, value)
        for name, value in exact.items()
    }


def _held(ends: Mapping[str, tuple[Fraction, Fraction]]) -> bool:
    """Whether all parameters are floats exactly."""
    return all(low == high == Fraction(float(low)) for low, high in ends.values())


def _isolated(balance: Balance, exact: Mapping[str, Any]) -> tuple[Roots, FloatArray, Any]:
    """Boxes with one root for each parameter between the floats around the exact ones; the searched
    region, and whether it holds all.
    """
    with balls.precision(FIRST_BITS):
        ends = _ends(exact)
    exact_ends = [ends[name] for name in balance.parameters]
    floats = np.array([[-float_above(-least), float_above(most)] for least, most in exact_ends])
    low, high = floats.T[:, :, None]
    if (low == high).all():
        return roots_of(balance, high)
    box, whole = region(balance, Intervals.between(low, high))
    found = certified_roots.search(balance, box, low, high)
    return reduced_by_turns(balance.periodic, found), box, whole


def _state(
    system: PreciseBalance, digits: int, box: FloatArray, alone: FloatArray
) -> PreciseEquilibrium | None:
    """The equilibrium in a box; None if it lies beyond the contact's border."""
    q = _narrowed(system, box, alone)
    at = system.state(q)
    if not _on_contact_side(system, q, at):
        return None
    numbers, error, _ = as_numbers((*_columns(at), *q), digits)
    named = dict(zip(columns_of(system.balance.model), numbers, strict=True))
    touching = system.balance.touching if system.balance.model.has_regimes else ""
    return PreciseEquilibrium(named, type_at(system, q), as_mpf(error), touching=touching)


def _columns(at: Evaluation) -> list[Any]:
    """Direction and length of each inclined spring."""
    springs = (at.directions[3 * spring : 3 * spring + 3] for spring in range(at.balance.springs))
    return [value for c, s, length in springs for value in (_angle(c, s), length)]


def _angle(c: Number, s: Number) -> Number:
    """The angle of a direction; π if it is not separated from −π."""
    with suppress(UndecidedSign):
        return XP.atan2(s, c)
    return balls.pi() + XP.atan2(-s, -c)


@question
def precise_cusps(
    p: ParameterSet,
    exact: Mapping[str, Any],
    vary: Sequence[str],
    digits: int,
    *,
    between: Ranges | None = None,
    method: Method = "auto",
) -> CuspProof:
    """All cusps in contact, each number with an error of at most 10^−digits max(1, |number|).

    Arguments are those of :func:`.folds.cusps`. Each cusp is proved for the exact parameters. That
    there are no others is proved only if all of these are floats.
    """
    with balls.precision(FIRST_BITS):
        ends = _ends(exact)
    # An array, no set of parameters: the nearest float may be an open end of the allowed range.
    given = np.array(
        [[float(sum(ends[name]) / 2) if name in ends else np.nan] for name in p.model.parameters]
    )
    parts = [
        _cusps_of(replace(family, given=given), exact, digits)
        for family in Family.every(p, vary, between)
    ]
    ordered = sorted(
        chain(*(part.cusps for part in parts)),
        key=lambda one: [one.numbers[name] for name in reversed(vary)],
    )
    complete = _held(ends) and all(part.complete for part in parts)
    return CuspProof(tuple(ordered), complete, _hull([part.region for part in parts]))


def _cusps_of(family: Family, exact: Mapping[str, Any], digits: int) -> CuspProof:
    """The cusps of one combination of touching contacts."""
    found, coordinates = isolated(family), family.balance.coordinates
    systems = [Augmented(family, cusp(column)) for column in range(len(coordinates))]
    names = [*family.vary, *columns_of(family.p.model)]

    def attempt(bits: int) -> list[PreciseCusp]:
        precise = [
            PreciseBalance(system, family.given[:, 0], bits, _ends(exact)) for system in systems
        ]
        return _each(found.roots, partial(_by_any_column, names, precise, digits))

    cusps = with_enough_bits(digits, attempt, "cusps")
    decided = bool(found.whole.all()) and not found.roots.undecided_point.size
    return CuspProof(
        tuple(cusps),
        decided and not family.endless,
        _searched((*coordinates, *family.vary), found.region),
    )


def _by_any_column(
    names: Sequence[str],
    systems: Sequence[PreciseBalance],
    digits: int,
    box: FloatArray,
    alone: FloatArray,
) -> PreciseCusp | None:
    """The cusp by the first column of the adjugate for which it is proved; a column that is 0
    proves none.
    """
    for column, system in enumerate(systems):
        try:
            return _cusp(names, system, column, box, alone, digits)
        except UndecidedSign:
            if system is systems[-1]:
                raise
    return None


def _cusp(
    names: Sequence[str],
    system: PreciseBalance,
    number: int,
    box: FloatArray,
    alone: FloatArray,
    digits: int,
) -> PreciseCusp | None:
    """The cusp in a box, by one column of the adjugate; None if it lies beyond the contact's
    border.

    At a regular root of F = det K = ∇(det K) · v = 0 with v ≠ 0 the cusp is of third order, and the
    parameters unfold it.
    """
    n = system.balance.n
    root = _narrowed(system, box, alone)
    at = system.state(root)
    column = [XP.taken(cofactor(at.slopes, number, i)) for i in range(n)]
    if not any(map(balls.sign, column)):
        raise UndecidedSign("a direction that may be 0")
    if not _on_contact_side(system, root, at):
        return None
    numbers, _, radius = as_numbers((*root[n:], *_columns(at), *root[:n]), digits)
    return PreciseCusp(dict(zip(names, numbers, strict=True)), as_mpf(radius), versal=True)


def _narrowed(system: PreciseBalance, box: FloatArray, alone: FloatArray) -> list[Any]:
    """The root in a box of floats, as balls whose radius falls with the number of bits.

    Raises UndecidedSign for a root that is nearly double. The radius is smaller than the digits
    need, since an angle may be known worse than the coordinates.
    """
    kept_bits = max(2 * system.bits // 3, system.bits - 96)  # others may be lost in sums of forces
    root = narrowed(system, box, alone, Fraction(1, 2**kept_bits))
    if root is None:
        raise UndecidedSign("a root that is nearly a double one")
    return root


def _on_contact_side(system: PreciseBalance, root: Sequence[Any], at: Evaluation) -> bool:
    """Whether the state ``at`` a root lies on the required side of all borders; it may lie on
    these.
    """
    exact = cache(lambda: system.state(exact_in_part(system, root)).gaps())
    for k, (gap, touches) in enumerate(zip(at.gaps(), at.balance.closed, strict=True)):

        def vanishes(k: int = k) -> bool:
            return balls.is_exactly_zero(exact()[k])

        sign = balls.sign_or_zero(gap, "a gap that is zero", vanishes)
        if sign == 0 and not touches and at.balance.apart:
            return False
        if sign != 0 and (sign < 0) != touches:
            return False
    return True
