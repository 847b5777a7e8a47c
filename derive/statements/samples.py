"""Values of a page's names at samples: pairs with the same parameters and another state."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp
from numpy.random import Generator

from .objects import TIME, Derivation, NoObject, Object
from .repair import Values

Flags: TypeAlias = npt.NDArray[np.bool_]


def drawn(it: Derivation, held: Object, is_base: bool = False) -> dict[str, Values]:
    """Values of all names, in contact or in lift-off as the object says, in units of order 1.

    Parameters are random, or those that the page gives as its base values.
    """
    key = f"{held.side}, steady {held.steady}, ahead {held.ahead}, base {is_base}"
    return {**it.kept("samples", key, lambda: _drawn(it, held, is_base))}


def _drawn(it: Derivation, held: Object, is_base: bool) -> dict[str, Values]:
    rng = np.random.default_rng(20201)
    base = {it.name_of(entry): entry.base for entry in it.page.parameters}
    # Pairs of samples with the same parameters.
    pairs = 24
    size = 2 * pairs
    found: dict[str, Values] = {}
    for name, symbol in it.parameters.items():
        value = np.repeat(rng.uniform(0.3, 1.4, pairs), 2)
        found[name] = value if symbol.is_nonnegative else value * _signs(rng, size, 2)
        if is_base:
            found[name] = np.full(size, 1.0 if base.get(name) is None else base[name])
    gaps = {
        contact.name: it.expanded(it.spelled(contact.gap))
        for contact in it.model.contacts
        if contact.gap is not None
    }
    coordinates = [str(symbol) for symbol in it.model.coordinates]
    found |= {name: _state(rng, size) for name in coordinates}
    # Of a statement on several sides the pairs go round these.
    sides = [*it.sides.values()] if held.side == "both" else [it.sides[held.side]]
    on = np.repeat(np.arange(pairs) % len(sides), 2)
    pushing = {
        contact.name: np.array([contact.name in touching for touching in sides])[on]
        for contact in it.model.contacts
    }

    def on_wrong_side() -> Flags:
        wrong = np.zeros(size, dtype=bool)
        for name, gap in gaps.items():
            level = numeric(gap, found)
            wrong |= np.where(pushing[name], level >= 0, level <= 0)
        return wrong

    def behind() -> Flags:
        return np.any([numeric(speed, found) <= 0 for speed in it.speeds], axis=0)

    # Where a side has no state, as of two faces that never leave both, its algebra is judged.
    _redraw(found, coordinates, on_wrong_side, rng)
    for symbol, touches in zip(it.switches, pushing.values(), strict=True):
        found[str(symbol)] = 1.0 * touches
    for symbol in (*it.model.rates, *it.accelerations):
        found[str(symbol)] = _state(rng, size)
    if held.ahead and not _redraw(found, [*map(str, it.model.rates)], behind, rng):
        raise NoObject("no motion was found in which every belt is ahead")
    for name in ("lam", str(TIME)):
        found.setdefault(name, _state(rng, size))
    for name, value in it.geometry.items():
        found[name] = numeric(value, found)
    for symbol, value in (it.at_rest if held.steady else it.friction).items():
        found.setdefault(str(symbol), numeric(value, found))
    for (symbol, law), touches in zip(it.normals.items(), pushing.values(), strict=True):
        found.setdefault(str(symbol), touches * numeric(law, found))
    return found


def _redraw(
    found: dict[str, Values], names: Sequence[str], wrong: Callable[[], Flags], rng: Generator
) -> bool:
    """Draw names anew at the samples that are wrong, of more and more sizes; whether none is at
    the end.
    """
    most_tries = 200
    for tried in range(most_tries):
        there = wrong()
        if not there.any():
            return True
        most = tried // 20
        size = 2.0 ** rng.integers(-most, most + 1, there.size)
        for name in names:
            found[name] = np.where(there, size * _state(rng, there.size), found[name])
    return False


def _state(rng: Generator, size: int) -> Values:
    return rng.uniform(0.2, 1.3, size) * _signs(rng, size, 1)


def _signs(rng: Generator, size: int, repeat: int) -> Values:
    return np.repeat(np.where(rng.random(size // repeat) < 0.5, -1.0, 1.0), repeat)


def numeric(expression: sp.Expr, values: Mapping[str, Values]) -> Values:
    """Values of an expression, by those of the names in it."""
    missing = sorted({str(it) for it in expression.free_symbols} - values.keys())
    if missing:
        raise NoObject(f"{expression} holds {', '.join(missing)}, which has no values")
    with np.errstate(all="ignore"):
        return _value(expression, values, {}) * np.ones_like(next(iter(values.values())))


def _value(part: sp.Basic, values: Mapping[str, Values], found: dict[sp.Basic, Values]) -> Values:
    """Values of an expression, each part of it once."""
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
        value = _compiled(part.func(*names), names)(*inner)
    found[part] = value
    return value


@cache
def _compiled(function: sp.Expr, names: tuple[sp.Symbol, ...]) -> Callable[..., Values]:
    return sp.lambdify(names, function, "numpy")
