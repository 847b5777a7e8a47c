"""Values of a page's names at samples: pairs with the same parameters and another state."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

import numpy as np
import sympy as sp

from .objects import Derivation, NoObject, Object
from .repair import Values

#: Pairs of samples with the same parameters.
PAIRS = 24
_TRIES = 200


def drawn(it: Derivation, held: Object, seed: int = 20201) -> dict[str, Values]:
    """Values of all names, in contact or in lift-off as the object says, in units of order 1."""
    rng = np.random.default_rng(seed)
    size = 2 * PAIRS
    found: dict[str, Values] = {}
    for name, symbol in it.parameters.items():
        value = np.repeat(rng.uniform(0.3, 1.4, PAIRS), 2)
        found[name] = value if symbol.is_nonnegative else value * _signs(rng, size, 2)
    gap = None if it.model.gap is None else it.spelled(it.model.gap)
    coordinates = [str(symbol) for symbol in it.model.coordinates]
    states = {name: _state(rng, size) for name in coordinates}
    if gap is not None:
        measure = numeric(gap, [*found, *coordinates])
        for _ in range(_TRIES):
            level = measure({**found, **states})
            wrong = level <= 0 if held.apart else level >= 0
            if not wrong.any():
                break
            for name in coordinates:
                states[name] = np.where(wrong, _state(rng, size), states[name])
    found |= states
    for symbol in (*it.model.rates, *it.accelerations):
        found[str(symbol)] = _state(rng, size)
    found["lam"] = _state(rng, size)
    for name, value in it.geometry.items():
        found[name] = numeric(value, list(found))(found)
    statics = it.friction_at_rest if held.steady else it.friction
    found.setdefault("mu", numeric(statics, list(found))(found))
    normal = sp.S.Zero if held.apart else it.normal
    found.setdefault("N", numeric(normal, list(found))(found))
    return found


def _state(rng: np.random.Generator, size: int) -> Values:
    return rng.uniform(0.2, 1.3, size) * _signs(rng, size, 1)


def _signs(rng: np.random.Generator, size: int, repeat: int) -> Values:
    return np.repeat(np.where(rng.random(size // repeat) < 0.5, -1.0, 1.0), repeat)


def numeric(expression: sp.Expr, names: list[str]) -> Callable[[Mapping[str, Values]], Values]:
    """An expression as a function of values by name."""
    used, function = _compiled(expression)
    missing = [name for name in used if name not in names]
    if missing:
        raise NoObject(f"{expression} holds {', '.join(missing)}, which has no values")

    def value(values: Mapping[str, Values]) -> Values:
        shape = np.ones_like(next(iter(values.values())))
        with np.errstate(all="ignore"):
            return np.asarray(function(*(values[name] for name in used))) * shape

    return value


@cache
def _compiled(expression: sp.Expr) -> tuple[tuple[str, ...], Callable[..., Values]]:
    symbols = sorted(expression.free_symbols, key=str)
    function = sp.lambdify(symbols, expression, "numpy", cse=True)
    return tuple(map(str, symbols)), function
