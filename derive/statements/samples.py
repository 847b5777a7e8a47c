"""Random values of a page's names, at which printed and derived expressions are compared.

Samples come in pairs with the same parameters and different states: expressions that differ by a
factor or a term of parameters only are recognized by that.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp
from numpy.random import Generator

from .objects import TIME, Derivation, NoObject, Object, derived
from .repair import Values, multiplied

Flags: TypeAlias = npt.NDArray[np.bool_]


def drawn(derivation: Derivation, subject: Object, is_base: bool = False) -> dict[str, Values]:
    """Values of all names at 48 samples, of order 1, on the side of the contacts of an object.

    Parameters are random, or the page's base values if ``is_base``.

    Raises
    ------
    NoObject
        If every belt has to be ahead and no such motion was found.
    """
    key = f"{subject.side}, steady {subject.steady}, ahead {subject.ahead}, base {is_base}"
    found = {**derivation.kept("samples", key, lambda: _drawn(derivation, subject, is_base))}
    if subject.along:
        for symbol, value in in_motion(derivation, subject).items():
            found[str(symbol)] = numeric(value, found)
    return found


def in_motion(derivation: Derivation, subject: Object) -> dict[sp.Symbol, sp.Expr]:
    """The accelerations that the equations of motion give, on the side of an object."""
    solved = derived(derivation, f"acceleration, {subject.side}").entries
    return dict(zip(derivation.accelerations, solved, strict=True))


def _drawn(derivation: Derivation, subject: Object, is_base: bool) -> dict[str, Values]:
    rng = np.random.default_rng(20201)
    base = {derivation.name_of(entry): entry.base for entry in derivation.page.parameters}
    # Pairs of samples with the same parameters.
    pairs = 24
    size = 2 * pairs
    found: dict[str, Values] = {}
    for name, symbol in derivation.parameters.items():
        value = np.repeat(rng.uniform(0.3, 1.4, pairs), 2)
        found[name] = value if symbol.is_nonnegative else value * _signs(rng, size, 2)
        if is_base:
            found[name] = np.full(size, 1.0 if base.get(name) is None else base[name])
    coordinates = [str(symbol) for symbol in derivation.model.coordinates]
    found |= {name: _state(rng, size) for name in coordinates}
    # Pairs alternate between the sides that a statement is about.
    sides = [derivation.sides[it] for it in derivation.meant(subject.side)]
    side_numbers = np.repeat(np.arange(pairs) % len(sides), 2)
    pushing = {
        contact.name: np.array([contact.name in touching for touching in sides])[side_numbers]
        for contact in derivation.model.contacts
    }

    def on_wrong_side() -> Flags:
        wrong = np.zeros(size, dtype=bool)
        for name, gap in derivation.gaps.items():
            level = numeric(gap, found)
            wrong |= np.where(pushing[name], level >= 0, level <= 0)
        return wrong

    def behind() -> Flags:
        return np.any([numeric(speed, found) <= 0 for speed in derivation.speeds], axis=0)

    # A side may have no state, as both faces open where one always touches: its algebra is then
    # judged at states of other sides.
    _redraw(found, coordinates, on_wrong_side, rng)
    for symbol, touches in zip(derivation.switches, pushing.values(), strict=True):
        found[str(symbol)] = 1.0 * touches
    for symbol in (*derivation.model.rates, *derivation.accelerations):
        found[str(symbol)] = _state(rng, size)
    if subject.ahead and not _redraw(found, [*map(str, derivation.model.rates)], behind, rng):
        raise NoObject("no motion was found in which every belt is ahead")
    for name in ("lam", str(TIME)):
        found.setdefault(name, _state(rng, size))
    for name, value in derivation.geometry.items():
        found[name] = numeric(value, found)
    for symbol, value in (derivation.at_rest if subject.steady else derivation.friction).items():
        found.setdefault(str(symbol), numeric(value, found))
    for (symbol, law), touches in zip(derivation.normals.items(), pushing.values(), strict=True):
        found.setdefault(str(symbol), multiplied(touches * 1.0, numeric(law, found)))
    # A page without contact or friction has a force or a coefficient of 0, which no print may name.
    return {name: value for name, value in found.items() if name in derivation.names}


def _redraw(
    found: dict[str, Values], names: Sequence[str], wrong: Callable[[], Flags], rng: Generator
) -> bool:
    """Redraw names at the samples that are wrong, over a growing range of sizes.

    Returns whether all samples are right in the end.
    """
    most_tries = 200
    for attempt in range(most_tries):
        is_wrong = wrong()
        if not is_wrong.any():
            return True
        octaves = attempt // 20
        size = 2.0 ** rng.integers(-octaves, octaves + 1, is_wrong.size)
        for name in names:
            found[name] = np.where(is_wrong, size * _state(rng, is_wrong.size), found[name])
    return False


def _state(rng: Generator, size: int) -> Values:
    return rng.uniform(0.2, 1.3, size) * _signs(rng, size, 1)


def _signs(rng: Generator, size: int, repeat: int) -> Values:
    return np.repeat(np.where(rng.random(size // repeat) < 0.5, -1.0, 1.0), repeat)


def numeric(expression: sp.Expr, values: Mapping[str, Values]) -> Values:
    """Values of an expression at the samples.

    Raises
    ------
    NoObject
        If it holds a symbol without values.
    """
    missing = sorted({str(it) for it in expression.free_symbols} - values.keys())
    if missing:
        raise NoObject(f"{expression} holds {', '.join(missing)}, which has no values")
    with np.errstate(all="ignore"):
        return _value(expression, values, {}) * np.ones_like(next(iter(values.values())))


def _value(part: sp.Basic, values: Mapping[str, Values], found: dict[sp.Basic, Values]) -> Values:
    """Values of an expression; ``found`` caches those of its parts."""
    if part in found:
        return found[part]
    if isinstance(part, sp.Symbol):
        value = values[part.name]
    elif isinstance(part, sp.Piecewise):
        names = tuple(sorted(part.free_symbols, key=str))
        value = _compiled(part, names)(*(values[str(name)] for name in names))
    elif not part.args:
        number = complex(sp.N(part))
        value = np.array(np.nan if number.imag else number.real)
    else:
        inner = [_value(it, values, found) for it in part.args]
        names = sp.symbols(f"x:{len(inner)}")
        value = multiplied(*inner) if part.is_Mul else _compiled(part.func(*names), names)(*inner)
    found[part] = value
    return value


@cache
def _compiled(function: sp.Expr, names: tuple[sp.Symbol, ...]) -> Callable[..., Values]:
    return sp.lambdify(names, function, "numpy")
