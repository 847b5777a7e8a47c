"""Signs and origins of a paper's coordinates: those that its file states, and those in which rows
would hold that are wrong as it stands.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

import sympy as sp

from .comparison import Comparison, Convention, Conventions
from .objects import Derivation
from .papers import PaperError
from .reading import Item
from .tree import Unread, Vocabulary, read_sympy, to_sympy


def stated(texts: Mapping[str, str], derivation: Derivation) -> Conventions:
    """The conventions of a file: for each coordinate "reversed", or what the paper counts in terms
    of the page, as ``theta - pi``.

    Raises
    ------
    PaperError
        If a key is no coordinate, or a clock, or its text no such expression.
    """
    model, found = derivation.model, dict[str, Convention]()
    moving = [str(it) for it in model.coordinates if it != model.clock]
    names = {str(it): it for it in model.coordinates} | dict(derivation.parameters)
    for name, text in texts.items():
        where = f"[conventions] {name} = {text!r}:"
        if name not in moving:
            said = "a clock has no sign and no origin" if name in names else "it is no coordinate"
            raise PaperError(f"{where} {said}; coordinates are {', '.join(moving)}")
        try:
            spelled = f"-{name}" if text == "reversed" else text
            (equation,) = read_sympy(spelled, Vocabulary(frozenset(names), (), {}))
            value = to_sympy(equation.left, names)
        except (Unread, ValueError) as error:
            raise PaperError(f"{where} {error}; write 'reversed' or '{name} - pi'") from error
        sign, shift = sp.diff(value, names[name]), sp.expand(value).subs(names[name], 0)
        if sign not in (1, -1) or shift.has(*model.coordinates):
            raise PaperError(f"{where} is no 'reversed' and not {name} or -{name} and a constant")
        found[name] = Convention(int(sign), shift)
    return found


def unstated(
    wrong: Mapping[str, Sequence[Item]],
    right: Iterable[Item],
    known: Conventions,
    holds: Callable[[Item, Conventions], bool],
) -> tuple[Conventions, list[str]]:
    """The convention in which the most wrong rows seem to hold, and these by their ids; none where
    a row that is right as it stands does not hold in it.

    Signs and origins of one coordinate are tried, of two where several rows are wrong, and never
    those of a clock. ``wrong`` has what each row is held against, by its id.
    """
    derivation = next(iter(wrong.values()))[0].derivation
    tried: list[tuple[Conventions, list[str]]] = []
    for more in _all(derivation, known, 1 + (len(wrong) > 1)):
        conventions = {**known, **more}
        rows = [
            id
            for id, items in wrong.items()
            if any(Comparison(it, conventions).agrees for it in items)
        ]
        tried += [(conventions, rows)] if rows else []
    for conventions, rows in sorted(tried, key=lambda it: -len(it[1])):
        if all(holds(one, conventions) for one in right):
            return conventions, rows
    return {}, []


def _all(derivation: Derivation, known: Conventions, most: int) -> Iterator[Conventions]:
    """Conventions other than the known ones, of one coordinate, then of up to ``most``."""
    clock = derivation.model.clock
    choices = {
        name: [it for it in _choices(derivation, entry.unit) if it != known.get(name, Convention())]
        for entry in derivation.page.coordinates
        if entry.symbol != clock and (name := str(entry.symbol))
    }
    for count in range(1, 1 + (most if len(choices) < 3 else 1)):
        for names in itertools.combinations(choices, count):
            for choice in itertools.product(*(choices[name] for name in names)):
                yield dict(zip(names, choice, strict=True))


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
    return [Convention(sign, shift) for shift in shifts for sign in (-1, 1)]
