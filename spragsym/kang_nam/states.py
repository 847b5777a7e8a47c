"""What motions and paths ask about equilibria: which are linked, at which a motion rests, which
lift-off is for good.

Permanent lift-off: without contact nothing changes the energy U + kinetic. About a stable
equilibrium in lift-off the region of less energy than any higher stationary value of U, its brim,
has no way out and does not reach the belt: such values are at the other equilibria in lift-off,
along the belt's surface y = 0, and at the spring's anchor. Weak preload has no such well, and
brings the mass back.
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

#: Energy of numbers without checks.
_energy: Any = unwrap(algebra.energy)


def airborne(constants: tuple[float, ...], state: FloatArray) -> bool:
    """Whether a state is in a well of the energy above the belt that it can't leave."""
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
        # Points between which the energy is bounded on the straight way to the well's bottom.
        way = np.linspace([x, y], [found.x[slot], found.y[slot]], 201).T
        if energy < brim and _highest_on(way, arguments) < brim:
            return True
    return False


def _potential(x: Number, y: Number, *constants: float, xp: object = np) -> Any:
    """Energy at rest, without contact: friction, V and d are nothing to it."""
    cos0, sin0, *rest = constants
    return _energy(x, y, 0.0, 0.0, cos0, sin0, 0.0, *rest, 0.0, 0.0, 0, xp=xp)


def _stationary_on_the_surface(cos0: float, sin0: float, alpha: float, sigma: float) -> FloatArray:
    """All x where the potential energy at y = 0 is stationary, five.

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in
    u. A value too many only lowers the brim, so that complex roots, which may be double ones, stay
    by their real parts.
    """
    a, b, s2 = alpha * cos0, alpha + sigma, sin0**2
    quartic = np.array(
        [[a * a * s2, -2 * a * b * s2, a * a + b * b * s2 - sigma**2, -2 * a * b, b * b]]
    )
    return cos0 - np.append(eigenvalues(quartic).real, 0.0)


def _highest_on(way: FloatArray, constants: tuple[float, ...]) -> float:
    """A bound on the potential energy along a straight way: values on it, and the steepest slope
    between them.
    """
    cos0, sin0, kappa, alpha, sigma, beta = constants
    x, y = way
    length = float(np.hypot(*(way[:, -1] - way[:, 0])))
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
    """For each step and each slot at its beginning, the slot at its end on the same branch; none
    over several folds at once.

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
    """One step, between values and numbers of equilibria there."""
    (one, before), (two, after) = begin, end
    if before == after or turns is None:
        return {slot: slot for slot in range(before)} if before == after else {}
    at = turns[vary]
    passed = np.flatnonzero(
        (min(one, two) <= at) & (at <= max(one, two)) & np.isin(turns.kind, ("fold", "pitchfork"))
    )
    if passed.size != 1:
        return {}
    (fold,) = passed
    if turns.kind[fold] == "pitchfork":
        return dict.fromkeys(range(before), 0) if before > after else {0: 2}
    left = 0 if turns.ends[fold] == "upper" else 2
    return {left: 0} if before > after else {0: left}


def border_ends(_p: Parameters, _vary: str, _span: Span, _turns: Points) -> list[Points]:
    """None: no equilibrium has y = 0 (derive/kang_nam/theorem.py), and one or three are always
    there.
    """
    return []


def rest_index(p: Parameters, places: FloatArray) -> Int8Array:
    """Index among ``equilibria`` at the friction μ(V), (10), of those at x, y, shape (2, …); −1
    where there is none.
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
        # Empty slots are far away: all of them are where the equilibria are undecided.
        away = np.where(np.isnan(away), np.inf, away)
        index[rows] = np.where(
            away.min(axis=-1) <= SETTLED_SHARE * (1 + np.hypot(x, y)), away.argmin(axis=-1), -1
        )
    return index


def cases() -> tuple[tuple[str, Parameters], ...]:
    """Named points of all parameters."""
    # Name, θ₀ in degrees, and what differs from the base values.
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
