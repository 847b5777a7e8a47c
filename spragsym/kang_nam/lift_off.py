"""Permanent lift-off: without contact the energy above the belt is conserved, and its well holds the motion.

Without contact nothing changes the energy U + kinetic. About a stable equilibrium in lift-off the region of less energy than any
higher stationary value of U, its brim, has no way out and does not reach the belt: such values are at the other equilibria in
lift-off, along the belt's surface y = 0, and at the spring's anchor. Weak preload has no such well, and brings the mass back.
"""

import inspect
import math
from typing import Any

import numpy as np

from ..generated.models.kang_nam import algebra
from ..models.parameters import FloatArray, Parameters
from ..numerics.polynomials import eigenvalues

#: Energy of numbers without checks.
_energy: Any = inspect.unwrap(algebra.energy)

#: Points between which the energy is bounded on the straight way to a well's bottom.
POINTS = 200


def aloft(constants: tuple[float, ...], state: FloatArray) -> bool:
    """Whether a state is in a well of the energy above the belt that it can't leave."""
    from ..results.equilibria import Stability
    from .quartic.solver import equilibria

    if not state[1] > 0:
        return False
    cos0, sin0, mu0, kappa, alpha, sigma, beta, _, _ = constants
    p = Parameters(theta0=math.atan2(sin0, cos0), mu0=mu0, kappa=kappa, alpha=alpha, sigma=sigma, beta=beta)
    found, known = equilibria(p, contact=False), (cos0, sin0, kappa, alpha, sigma, beta)
    surface, (x, y, vx, vy) = _stationary_on_the_surface(cos0, sin0, alpha, sigma), state.tolist()
    places = np.concatenate([found.x, surface, [cos0]]), np.concatenate([found.y, np.zeros_like(surface), [sin0]])
    values, energy = _potential(*places, *known), _potential(x, y, *known, xp=math) + (vx * vx + vy * vy) / 2
    for slot in np.flatnonzero(found.stability == Stability.STABLE):
        brim = float(np.min(values[values > values[slot] + 1e-12], initial=np.inf))
        way = np.linspace([x, y], [found.x[slot], found.y[slot]], POINTS + 1).T
        if energy < brim and _highest_on(way, known) < brim:
            return True
    return False


def _potential(x: Any, y: Any, *constants: Any, xp: Any = np) -> Any:
    """Energy at rest, without contact: friction, V and d are nothing to it."""
    cos0, sin0, *rest = constants
    return _energy(x, y, 0.0, 0.0, cos0, sin0, 0.0, *rest, 0.0, 0.0, 0, xp=xp)


def _stationary_on_the_surface(cos0: float, sin0: float, alpha: float, sigma: float) -> FloatArray:
    """All x where the potential energy at y = 0 is stationary, five.

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in u. A value too many only
    lowers the brim, so that complex roots, which may be double ones, stay by their real parts.
    """
    a, b, s2 = alpha * cos0, alpha + sigma, sin0**2
    quartic = np.array([[a * a * s2, -2 * a * b * s2, a * a + b * b * s2 - sigma**2, -2 * a * b, b * b]])
    return cos0 - np.append(eigenvalues(quartic).real, 0.0)


def _highest_on(way: FloatArray, constants: tuple[float, ...]) -> float:
    """A bound on the potential energy along a straight way: values on it, and the steepest slope between them."""
    cos0, sin0, kappa, alpha, sigma, beta = constants
    x, y = way
    length = float(np.hypot(*(way[:, -1] - way[:, 0])))
    stretch = np.abs(np.hypot(cos0 - x[[0, -1]], sin0 - y[[0, -1]]) - 1).max()
    slope = alpha * np.abs(x).max() + beta * np.abs(y).max() + kappa + sigma * max(1.0, stretch)
    return float(_potential(x, y, *constants).max() + slope * length / (2 * POINTS))
