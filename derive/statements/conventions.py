"""Search for the signs and origins of a paper's coordinates, the same in all its statements."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import sympy as sp

from .comparison import Comparison, Convention, Conventions
from .objects import Derivation
from .reading import Item


def conventions_of(statements: Sequence[object]) -> Conventions:
    """The conventions in which the fewest of the statements fail that are compared; empty for those
    of the page.

    Signs and origins of one coordinate, or of two, are tried. A convention is accepted only if at
    least two more statements hold in it: one that would hold may be a misprint.
    """

    def failing(conventions: Conventions, limit: int) -> int:
        """Number of statements that fail, counted up to ``limit``.

        Statements that failed are tried first the next time, so that the count ends early.
        """
        failed = []
        for item in order:
            if not Comparison(item, conventions).agrees:
                failed.append(item)
                if len(failed) == limit:
                    break
        order.sort(key=lambda item: not any(item is one for one in failed))
        return len(failed)

    order = [it for it in statements if isinstance(it, Item)]
    best: Conventions = {}
    failing_as_printed = fewest = failing(best, len(order) + 1)
    if fewest < 2:
        return best
    derivation = order[0].derivation
    choices = {
        str(entry.symbol): _choices(derivation, entry.unit) for entry in derivation.page.coordinates
    }
    for count in (1, 2) if len(choices) < 3 else (1,):
        for names in itertools.combinations(choices, count):
            for choice in itertools.product(*(choices[name] for name in names)):
                tried = best | dict(zip(names, choice, strict=True))
                if (failed := failing(tried, fewest)) < fewest:
                    best, fewest = tried, failed
                if not fewest:
                    break
    return best if fewest <= failing_as_printed - 2 else {}


def _choices(derivation: Derivation, unit: str) -> list[Convention]:
    """Conventions that are tried for a coordinate: either sign, and shifts by a quarter or half
    turn, or by a quantity of the same unit.
    """
    shifts: list[sp.Expr] = [sp.S.Zero]
    if unit == "rad":
        shifts += [sp.pi, sp.pi / 2, -sp.pi / 2]
    else:
        data = (*derivation.page.units, *derivation.page.parameters)
        shifts += [way * it.symbol for it in data if it.unit == unit for way in (1, -1)]
    return [Convention(sign, shift) for shift in shifts for sign in (1, -1)]
