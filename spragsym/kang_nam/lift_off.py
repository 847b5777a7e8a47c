"""Permanent lift-off: without contact the energy above the belt is conserved, and its well holds the motion.

Without contact nothing changes the energy U + kinetic. About a stable equilibrium in lift-off the region of less energy than any
higher stationary value of U, its brim, has no way out and does not reach the belt: such values are at the other equilibria in
lift-off, along the belt's surface y = 0, and at the spring's anchor. Weak preload has no such well, and brings the mass back.
"""

from __future__ import annotations

import inspect
import math
from typing import Any, TypeAlias

import numpy as np

from ..generated.models.kang_nam import algebra
from ..models.parameters import NAMES, FloatArray, Parameters
from ..numerics.companion_roots import eigenvalues
from ..numerics.interval_arrays import BoolArray

#: A well: x and y of its bottom, and the energy of its brim.
Well: TypeAlias = tuple[float, float, float]

#: Energy of numbers without checks.
_energy: Any = inspect.unwrap(algebra.energy)

#: Points between which the energy is bounded on the straight way to a well's bottom.
POINTS = 200


def wells(p: Parameters) -> list[tuple[Well, ...]]:
    """The wells above the belt of every point, in order."""
    from ..results.equilibria import Stability
    from .quartic.solver import equilibria

    given = {name: np.ravel(values) for name, values in zip(NAMES, p.broadcast(*NAMES), strict=True)}
    found = equilibria(Parameters(**given), contact=False)
    told: list[list[Well]] = [[] for _ in given["theta0"]]
    rows = np.flatnonzero((found.stability == Stability.STABLE).any(axis=1))
    given, found_x, found_y = {name: values[rows] for name, values in given.items()}, found.x[rows], found.y[rows]
    cos0, sin0 = np.cos(given["theta0"]), np.sin(given["theta0"])
    rest = [cos0, sin0, *(given[name] for name in ("kappa", "alpha", "sigma", "beta"))]
    columns = [values[:, None] for values in rest]
    bottoms = _potential(found_x, found_y, *columns)
    surface = _stationary_on_the_surface(*rest)
    levels = [
        bottoms, _potential(surface, np.zeros_like(surface), *columns), _potential(cos0[:, None], sin0[:, None], *columns),
    ]  # fmt: skip
    values = np.concatenate(levels, axis=1)[:, None, :]
    brims = np.where(values > bottoms[..., None] + 1e-12, values, np.inf).min(axis=-1)
    for point, slot in np.argwhere(found.stability[rows] == Stability.STABLE).tolist():
        well = float(found_x[point, slot]), float(found_y[point, slot]), float(brims[point, slot])
        told[int(rows[point])].append(well)
    return [tuple(each) for each in told]


def aloft(constants: FloatArray, states: FloatArray) -> BoolArray:
    """For states of many motions, in rows, whether each is in a well of the energy above the belt that it can't leave."""
    found = states[:, 1] > 0
    if found.any():
        cos0, sin0, mu0, kappa, alpha, sigma, beta, _, _ = constants[found].T
        theta0 = np.arctan2(sin0, cos0)
        known = wells(Parameters(theta0=theta0, mu0=mu0, kappa=kappa, alpha=alpha, sigma=sigma, beta=beta))
        numbers = np.array([cos0, sin0, kappa, alpha, sigma, beta]).T.tolist()
        found[found] = [_held(*each) for each in zip(known, map(tuple, numbers), states[found], strict=True)]
    return found


def _held(known: tuple[Well, ...], constants: tuple[float, ...], state: FloatArray) -> bool:
    """Whether a state is in one of the wells, and has too little energy to leave it."""
    x, y, vx, vy = state.tolist()
    kinetic = (vx * vx + vy * vy) / 2
    for bottom_x, bottom_y, brim in known:
        if _potential(x, y, *constants, xp=math) + kinetic < brim:
            way = np.linspace([x, y], [bottom_x, bottom_y], POINTS + 1).T
            if _highest_on(way, constants) < brim:
                return True
    return False


def _potential(x: Any, y: Any, *constants: Any, xp: Any = np) -> Any:
    """Energy at rest, without contact: friction, V and d are nothing to it."""
    cos0, sin0, *rest = constants
    return _energy(x, y, 0.0, 0.0, cos0, sin0, 0.0, *rest, 0.0, 0.0, 0, xp=xp)


def _stationary_on_the_surface(
    cos0: FloatArray, sin0: FloatArray, _: FloatArray, alpha: FloatArray, sigma: FloatArray, *__: FloatArray
) -> FloatArray:
    """All x where the potential energy at y = 0 is stationary, shape (points, 5).

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in u. A value too many only
    lowers the brim, so that complex roots, which may be double ones, stay by their real parts.
    """
    a, b, s2 = alpha * cos0, alpha + sigma, sin0**2
    quartic = np.stack([a * a * s2, -2 * a * b * s2, a * a + b * b * s2 - sigma**2, -2 * a * b, b * b], axis=-1)
    roots = eigenvalues(quartic).real
    return cos0[:, None] - np.concatenate([roots, np.zeros((len(cos0), 1))], axis=1)


def _highest_on(way: FloatArray, constants: tuple[float, ...]) -> float:
    """A bound on the potential energy along a straight way: values on it, and the steepest slope between them."""
    cos0, sin0, kappa, alpha, sigma, beta = constants
    x, y = way
    length = float(np.hypot(*(way[:, -1] - way[:, 0])))
    stretch = np.abs(np.hypot(cos0 - x[[0, -1]], sin0 - y[[0, -1]]) - 1).max()
    slope = alpha * np.abs(x).max() + beta * np.abs(y).max() + kappa + sigma * max(1.0, stretch)
    return float(_potential(x, y, *constants).max() + slope * length / (2 * POINTS))
