"""Equilibria of any model to any number of digits: isolated over boxes of floats, narrowed by Krawczyk's operator in balls."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..exact import boxes, certified_roots
from ..exact.adaptive_bits import FIRST_BITS, as_numbers, with_enough_bits
from ..exact.ball_functions import XP
from ..exact.certified_roots import Roots
from ..exact.interval_arrays import FloatArray, Intervals
from ..exact.intervals import Arithmetic, Balls, as_mpf
from ..exact.krawczyk import narrowed
from ..exact.polynomials import Undecided
from ..results.equilibria import columns_of
from ..results.precise_states import PreciseEquilibria, PreciseEquilibrium
from .balance import Balance
from .equilibria import balance_of, solved
from .periodic_coordinates import once_around
from .precise import PreciseBalance
from .regions import region
from .spectrum import type_at

#: Bits that may be lost where forces are summed.
ROOM = 96


def precise_equilibria(
    model: Any, exact: Mapping[str, Any], contact: bool, digits: int, arith: Arithmetic | None
) -> PreciseEquilibria:  # fmt: skip
    """All equilibria of a point, each number within 10^−digits max(1, |number|).

    Parameters
    ----------
    exact : mapping
        Every parameter: a rational number, or what gives an interval in an arithmetic.
    """
    if arith is not None and not isinstance(arith, Balls):
        raise ParameterError(f"arith = {type(arith).__name__}: a search is in balls; leave arith out")
    balance = balance_of(model, contact)
    found, around, whole = _isolated(balance, exact)
    if found.left_point.size:
        raise ConvergenceError(
            f"equilibria: {found.left_point.size} boxes are not decided; change a parameter a little, or give only numbers that "
            "floats hold, as 0.5: these are searched more closely"
        )

    def attempt(bits: int) -> list[PreciseEquilibrium]:
        system = PreciseBalance(balance, np.zeros(len(balance.parameters)), bits, _ends(exact))
        boxes_of_roots = zip(np.moveaxis(found.ends, 2, 0), np.moveaxis(found.alone, 2, 0), strict=True)
        states = (_state(balance, system, box, alone, digits) for box, alone in boxes_of_roots)
        return [state for state in states if state is not None]

    states = with_enough_bits(Balls(), digits, attempt, "equilibria")
    first = balance.coordinates[0]
    low, high = -around[0, :, 0], around[1, :, 0]
    searched = dict(zip(balance.coordinates, zip(low.tolist(), high.tolist(), strict=True), strict=True))
    return PreciseEquilibria(tuple(sorted(states, key=lambda one: one.numbers[first])), bool(whole.all()), searched)


def _ends(exact: Mapping[str, Any]) -> dict[str, tuple[Fraction, Fraction]]:
    """Both ends of every parameter, equal where it is rational, at the bits of this moment."""
    return {name: Balls().ends(value(Balls())) if callable(value) else (value, value) for name, value in exact.items()}


def _isolated(balance: Balance, exact: Mapping[str, Any]) -> tuple[Roots, FloatArray, Any]:
    """A box for each root of all parameters between the floats around the exact ones, what is left, and the region."""
    with Balls().precision(FIRST_BITS):
        ends = _ends(exact)
    low, high = (
        np.array([_beside(ends[name][side], way) for name in balance.parameters])[:, None]
        for side, way in ((0, -np.inf), (1, np.inf))
    )
    if (low == high).all():
        return solved(balance, low)
    around, whole = region(balance, Intervals(np.stack([-low, high])))
    outcome = boxes.search(balance, around, low, high, limits=balance.limits)
    return once_around(balance, certified_roots.roots(balance, outcome, around, low, high)), around, whole


def _beside(value: Fraction, way: float) -> float:
    """The float that is a number, or the next one on a side of it."""
    near = float(value)
    beyond = Fraction(near) > value if way < 0 else Fraction(near) < value
    return float(np.nextafter(near, way)) if beyond else near


def _state(
    balance: Balance, system: PreciseBalance, box: FloatArray, alone: FloatArray, digits: int
) -> PreciseEquilibrium | None:  # fmt: skip
    """The equilibrium in a box; None where it lies beyond the border of the contact."""
    # The box gets narrower as bits are added: an angle may be known worse than the coordinates that it follows from.
    q = narrowed(system, box, alone, Fraction(1, 2 ** max(2 * system.bits // 3, system.bits - ROOM)))
    if q is None:
        raise Undecided("a root that is nearly a double one")
    if balance.opens:
        side = Balls().sign(system.gap(q))
        if not side:
            raise Undecided("a gap that is zero")
        if (side < 0) != balance.contact:
            return None
    directions = balance.plain_directions(q, system.arguments, XP)
    springs = (directions[3 * spring : 3 * spring + 3] for spring in range(balance.springs))
    seen = [value for c, s, length in springs for value in (XP.atan2(s, c), length)]
    numbers, error = as_numbers(Balls(), (*seen, *q))
    if error > Fraction(1, 10**digits):
        raise Undecided(f"an error of {float(error):.1e}")
    named = dict(zip(columns_of(balance.model), numbers, strict=True))
    return PreciseEquilibrium(named, type_at(balance, system, q), as_mpf(error))
