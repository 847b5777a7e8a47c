"""Lift-off for good: in a well of the energy above the belt, which nothing changes without contact."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..generated import motion
from ..parameters import FloatArray
from .course import Course
from .problem import Constants, Event, Problem


def lifted_for_good(course: Course, problem: Problem) -> bool:
    """Whether the mass is in a well of the energy above the belt that it has too little energy to leave.

    Without contact nothing changes the energy U + kinetic. About a stable equilibrium in lift-off the region of less energy
    than any higher stationary value of U has no way out and does not reach the belt: such values are at the other equilibria in
    lift-off, along the belt's surface y = 0, and at the spring's anchor. Weak preload has no such well, and brings the mass back.
    All of these are known for the article's model; of others it is not told.
    """
    if not isinstance(problem.constants, Constants):
        return False
    if course.last[1] <= 0 or course.events[[Event.CONTACT_LOST, Event.CONTACT_REGAINED]].any():
        return False
    from ..statics.solver import Stability, equilibria

    found = equilibria(problem.parameters, contact=False)
    there = np.isfinite(found.x)
    x, y = found.x[there], found.y[there]
    surface = _stationary_on_the_surface(problem)
    anchor = np.array([problem.constants.cos0]), np.array([problem.constants.sin0])
    levels = [_potential(problem, *places) for places in ((x, y), (surface, np.zeros_like(surface)), anchor)]
    values = np.concatenate(levels)
    energy = float(_potential(problem, *course.last[:2]) + (course.last[2:] ** 2).sum() / 2)
    for row in np.flatnonzero(found.stability[there] == Stability.STABLE):
        brim = float(values[values > values[row] + 1e-12].min())
        if energy < brim and _highest_between(problem, course.last[:2], np.array([x[row], y[row]])) < brim:
            return True
    return False


def _potential(problem: Problem, x: Any, y: Any) -> Any:
    """Energy at rest, without contact."""
    c, still = problem.constants, np.zeros_like(x)
    return motion.energy(x, y, still, still, c.cos0, c.sin0, c.kappa, c.alpha, c.sigma, c.beta, 0)


def _stationary_on_the_surface(problem: Problem) -> FloatArray:
    """All x where the potential energy at y = 0 is stationary.

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in u. A value too many only
    lowers the brim, so that complex roots, which may be double ones, stay by their real parts.
    """
    c = problem.constants
    a, b, s2 = c.alpha * c.cos0, c.alpha + c.sigma, c.sin0**2
    roots = np.roots([b * b, -2 * a * b, a * a + b * b * s2 - c.sigma**2, -2 * a * b * s2, a * a * s2])
    stationary: FloatArray = c.cos0 - np.append(roots.real, 0.0)
    return stationary


def _highest_between(problem: Problem, begin: FloatArray, end: FloatArray) -> float:
    """A bound on the potential energy along the straight way: values on it, and the steepest slope between them."""
    c, n = problem.constants, 200
    (x, y), length = np.linspace(begin, end, n + 1).T, float(np.hypot(*(end - begin)))
    stretch = np.abs(np.hypot(c.cos0 - x[[0, -1]], c.sin0 - y[[0, -1]]) - 1).max()
    slope = c.alpha * np.abs(x).max() + c.beta * np.abs(y).max() + c.kappa + c.sigma * max(1.0, stretch)
    return float(_potential(problem, x, y).max() + slope * length / (2 * n))
