"""Conventions of a paper: signs and origins of its coordinates, the same in all statements."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import sympy as sp

from .comparison import Comparison, Convention, Conventions
from .objects import Derivation
from .reading import Item


def settled(items: Sequence[Item]) -> Conventions:
    """The signs and origins of coordinates in which the fewest statements fail.

    One statement that would hold otherwise is no convention but a misprint: it takes two.
    """

    def failing(conventions: Conventions, most: int) -> int:
        """Number of samples that fail, or ``most``; those that failed last stand first, and end it
        early.
        """
        failed = []
        for item in order:
            if not Comparison(item, conventions).agrees:
                failed.append(item)
                if len(failed) == most:
                    break
        order.sort(key=lambda item: not any(item is one for one in failed))
        return len(failed)

    order = [*items]
    best: Conventions = {}
    first = fewest = failing(best, len(order) + 1)
    if fewest < 2:
        return best
    it = items[0].it
    choices = {str(entry.symbol): _choices(it, entry.unit) for entry in it.page.coordinates}
    for count in (1, 2) if len(choices) < 3 else (1,):
        for names in itertools.combinations(choices, count):
            for ways in itertools.product(*(choices[name] for name in names)):
                tried = best | dict(zip(names, ways, strict=True))
                if (failed := failing(tried, fewest)) < fewest:
                    best, fewest = tried, failed
                if not fewest:
                    break
    return best if fewest <= first - 2 else {}


def _choices(it: Derivation, unit: str) -> list[Convention]:
    shifts: list[sp.Expr] = [sp.S.Zero]
    if unit == "rad":
        shifts += [sp.pi, sp.pi / 2, -sp.pi / 2]
    else:
        same_unit = [datum for datum in (*it.page.units, *it.page.parameters) if datum.unit == unit]
        shifts += [way * datum.symbol for datum in same_unit for way in (1, -1)]
    return [Convention(sign, shift) for shift in shifts for sign in (1, -1)]
