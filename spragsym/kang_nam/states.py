"""Closed forms that motions and paths ask for: linked equilibria, the equilibrium at which a motion
rests, and permanent lift-off.

Permanent lift-off: without contact the energy is constant. About a stable equilibrium in lift-off,
a motion below the lowest higher stationary value of the potential U, the brim, can't leave the well
and does not reach the belt. Stationary values are those at the other equilibria in lift-off, on the
belt's surface y = 0, and at the spring's anchor. With a weak preload there is no such well.
"""

from __future__ import annotations

import itertools
import math
from inspect import unwrap
from typing import Any

import numpy as np

from ..generated.models.kang_nam import algebra
from ..models.field import SETTLED_SHARE
from ..models.parameters import FloatArray, Span
from ..numerics.arithmetic import Number
from ..numerics.interval_arrays import Int8Array
from ..numerics.polynomials import eigenvalues
from ..results import Equilibria, Points
from .parameters import Parameters

#: The energy, without broadcasting.
_energy: Any = unwrap(algebra.energy)


def airborne(constants: tuple[float, ...], state: FloatArray) -> bool:
    """Whether a state is in a potential well above the belt that it can't leave."""
    from ..results import EquilibriumType
    from .quartic.solver import equilibria

    if not state[1] > 0:
        return False
    cos0, sin0, mu0, kappa, *springs, _, _ = constants
    p = Parameters(math.atan2(sin0, cos0), mu0, kappa, *springs)
    found, arguments = equilibria(p, contact=False), (cos0, sin0, kappa, *springs)
    surface, (x, y, vx, vy) = _stationary_on_the_surface(cos0, sin0, *springs[:2]), state.tolist()
    places = (
        np.concatenate([found.x, surface, [cos0]]),
        np.concatenate([found.y, np.zeros_like(surface), [sin0]]),
    )
    values = _potential(*places, *arguments)
    energy = _potential(x, y, *arguments, xp=math) + (vx * vx + vy * vy) / 2
    for slot in np.flatnonzero(found.undamped == EquilibriumType.STABLE):
        brim = float(np.min(values[values > values[slot] + 1e-12], initial=np.inf))
        # The energy is bounded between 201 points of the straight path to the bottom of the well.
        path = np.linspace([x, y], [found.x[slot], found.y[slot]], 201).T
        if energy < brim and _highest_on(path, arguments) < brim:
            return True
    return False


def _potential(x: Number, y: Number, *constants: float, xp: object = np) -> Any:
    """The energy at rest without contact; it does not depend on friction, V and d."""
    cos0, sin0, *rest = constants
    return _energy(x, y, 0.0, 0.0, cos0, sin0, 0.0, *rest, 0.0, 0.0, 0, xp=xp)


def _stationary_on_the_surface(cos0: float, sin0: float, alpha: float, sigma: float) -> FloatArray:
    """Five values of x that include all stationary points of the potential energy at y = 0.

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in
    u. Complex roots, which may be double ones, are included by their real parts: an additional
    value can only lower the brim.
    """
    a, b, s2 = alpha * cos0, alpha + sigma, sin0**2
    quartic = np.array(
        [[a * a * s2, -2 * a * b * s2, a * a + b * b * s2 - sigma**2, -2 * a * b, b * b]]
    )
    return cos0 - np.append(eigenvalues(quartic).real, 0.0)


def _highest_on(path: FloatArray, constants: tuple[float, ...]) -> float:
    """An upper bound on the potential energy along a straight path, from values at its points and a
    bound on the slope.
    """
    cos0, sin0, kappa, alpha, sigma, beta = constants
    x, y = path
    length = float(np.hypot(*(path[:, -1] - path[:, 0])))
    stretch = np.abs(np.hypot(cos0 - x[[0, -1]], sin0 - y[[0, -1]]) - 1).max()
    slope = alpha * np.abs(x).max() + beta * np.abs(y).max() + kappa + sigma * max(1.0, stretch)
    return float(_potential(x, y, *constants).max() + slope * length / (2 * (x.size - 1)))


def linked(
    _p: Parameters,
    vary: str,
    eq: Equilibria,
    turns: Points | None,
    *,
    only: int | None = None,
    options: object = None,
) -> list[dict[int, int]]:
    """For each step, a map from slots at its beginning to slots on the same branches at its end;
    empty if a step passes several folds.

    Notes
    -----
    Source: f is continuous in θ and in the parameter, so that its roots exchange places only where
    two meet. Of every fold it is proved which two of three these are. Of the two that begin at a
    pitchfork the upper goes on: along F_y = 0, x grows with θ.
    """
    values, counts = (column.tolist() for column in (eq.parameters[vary], eq.count))
    steps = list(itertools.pairwise(zip(values, counts, strict=True)))
    return [
        _over(one, two, vary, turns)
        for one, two in (steps if only is None else steps[only : only + 1])
    ]


def _over(
    begin: tuple[float, int], end: tuple[float, int], vary: str, turns: Points | None
) -> dict[int, int]:
    """The map of one step, between two values with their numbers of equilibria."""
    (begin_value, before), (end_value, after) = begin, end
    if before == after or turns is None:
        return {slot: slot for slot in range(before)} if before == after else {}
    fold_values = turns[vary]
    passed = np.flatnonzero(
        (min(begin_value, end_value) <= fold_values)
        & (fold_values <= max(begin_value, end_value))
        & np.isin(turns.kind, ("fold", "pitchfork"))
    )
    if passed.size != 1:
        return {}
    (fold,) = passed
    if turns.kind[fold] == "pitchfork":
        return dict.fromkeys(range(before), 0) if before > after else {0: 2}
    remaining = 0 if turns.ends[fold] == "upper" else 2
    return {remaining: 0} if before > after else {0: remaining}


def border_ends(_p: Parameters, _vary: str, _span: Span, _turns: Points) -> list[Points]:
    """No ends: no equilibrium has y = 0, and there are always one or three
    (derive/kang_nam/theorem.py).
    """
    return []


def rest_index(p: Parameters, places: FloatArray) -> Int8Array:
    """Indices of the equilibria, at the friction μ(V) of (10), that lie at places x, y of shape (2,
    …); −1 where there is none.
    """
    from .quartic.solver import equilibria
    from .steady_sliding import sliding_friction

    index, rows = np.full(places.shape[1:], -1, dtype=np.int8), np.isfinite(places[0])
    if rows.any():
        x, y = places[:, rows]
        given = {name: np.broadcast_to(p[name], rows.shape)[rows] for name in p.ranges}
        given["mu0"] = sliding_friction(*(given[name] for name in ("mu0", "V", "d")))
        found = equilibria(Parameters(**given))
        away = np.hypot(found.x - x[:, None], found.y - y[:, None])
        # NaN are empty slots, and all slots of undecided points.
        away = np.where(np.isnan(away), np.inf, away)
        index[rows] = np.where(
            away.min(axis=-1) <= SETTLED_SHARE * (1 + np.hypot(x, y)), away.argmin(axis=-1), -1
        )
    return index


def cases() -> tuple[tuple[str, Parameters], ...]:
    """Named points of the article."""
    # Name, θ₀ in degrees, and the parameters that differ from the base values.
    given: tuple[tuple[str, float, dict[str, float]], ...] = (
        ("Article, base values, before the fold: θ₀ = 30°", 30.0, {}),
        ("Article, past the fold: θ₀ = 49°", 49.0, {}),
        ("Article, friction below the cusp: μ₀ = 0.15", 49.0, {"mu0": 0.15}),
        ("Article, Figure 8: β = 1", 30.0, {"beta": 1.0}),
        ("Article, Figure 8: β = 2, no jump", 30.0, {"beta": 2.0}),
        ("Article, Figure 9: α = 0.07", 30.0, {"alpha": 0.07}),
        ("Article, Figure 9: α = 0.7, flutter at θ₀ = 150°", 150.0, {"alpha": 0.7}),
        ("Article, Figure 10: σ = 0.01", 30.0, {"sigma": 0.01}),
        ("Article, Figure 10: σ = 1", 30.0, {"sigma": 1.0}),
    )
    return tuple(
        (name, Parameters.article(theta0=math.radians(angle), **changed))
        for name, angle, changed in given
    )
