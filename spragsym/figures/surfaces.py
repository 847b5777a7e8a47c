"""The equilibrium surface in three dimensions: a mesh cut exactly where a sheet ends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

import spragsym as ss

from ..generated import equilibrium as _equilibrium
from ..generated import stability as _stability
from ..models.parameters import FloatArray, Parameters
from ..results.equilibria import Stability

#: Columns of a vertex: θ₀ in degrees, μ₀, x, the slope of f (divergent where negative), the discriminant
#: of (27) (flutter where negative).
_THETA0, _MU0, _X, _SLOPE, _DISCRIMINANT = range(5)


def sheets(p: Parameters, mu0: tuple[float, float], theta0_deg: FloatArray, n: int) -> dict[Stability, list[FloatArray]]:
    """Polygons of (θ₀ in degrees, μ₀, x): the surface between two frictions, cut along folds and flutter onsets.

    Each θ₀ has its own directions, from one end of the arc in contact to the other, where μ₀ is infinite. So
    the mesh has no hole; polygons are cut by straight lines where they leave a sheet.
    """
    mesh = _mesh(p, np.radians(theta0_deg), n, mu0)
    polygons = _quadrilaterals(mesh)
    polygons = _clip(_clip(polygons, _MU0, mu0[0]), _MU0, mu0[1], keep_above=False)
    standing = _clip(polygons, _SLOPE, 0.0)
    parts = {
        Stability.STABLE: _clip(standing, _DISCRIMINANT, 0.0),
        Stability.DIVERGENT: _clip(polygons, _SLOPE, 0.0, keep_above=False),
        Stability.FLUTTER: _clip(standing, _DISCRIMINANT, 0.0, keep_above=False),
    }
    return {kind: [polygon[:, :3] for polygon in part] for kind, part in parts.items()}


def _mesh(p: Parameters, theta0: FloatArray, n: int, mu0: tuple[float, float]) -> FloatArray:
    """Vertices, of shape (θ₀, θ, columns)."""
    kappa, alpha, sigma, beta = p.scalars("kappa", "alpha", "sigma", "beta")
    theta = _directions(p, theta0, n, mu0)
    found = ss.surface(p, theta, theta0[:, None])
    c, s, c0, s0 = np.cos(theta), np.sin(theta), np.cos(theta0)[:, None], np.sin(theta0)[:, None]
    f = _equilibrium.f_coefficients(c0, s0, found.mu0, kappa, alpha, sigma, beta, 1)
    slope = _equilibrium.f_slope(c, s, *f)
    K = _stability.stiffness(c, s, found.L, found.mu0, alpha, sigma, beta, 1)
    discriminant = _stability.invariants(*K[0], *K[1])[2]
    columns = (np.degrees(found.theta0), found.mu0, found.x, slope, discriminant)
    return np.stack(np.broadcast_arrays(*columns), axis=-1)


def _directions(p: Parameters, theta0: FloatArray, n: int, mu0: tuple[float, float]) -> FloatArray:
    """For each θ₀ directions in contact, evenly spaced on the surface as it is shown."""
    kappa, sigma = p.scalars("kappa", "sigma")
    start = np.arcsin(np.clip(np.sin(theta0) - kappa / sigma, 0.0, 1.0))  # contact is sin θ above it
    u = np.linspace(1e-3, 1 - 1e-3, 20 * n)
    share = u**3 * (10 - 15 * u + 6 * u * u)  # dense towards the ends, where μ₀ is steep
    theta = start[:, None] + (np.pi - 2 * start[:, None]) * share
    found = ss.surface(p, theta, theta0[:, None])
    width = mu0[1] - mu0[0]
    shown = np.clip(found.mu0, mu0[0] - 0.1 * width, mu0[1] + 0.1 * width)
    # Outside the shown range points are sparser, the farther away the sparser.
    weight = 0.25 / (1 + ((found.mu0 - shown) / width) ** 2)[:, 1:]
    steps = np.hypot(np.diff(shown, axis=1) / width, weight * np.diff(found.x, axis=1))
    length = np.concatenate([np.zeros((theta0.size, 1)), np.cumsum(steps, axis=1)], axis=1)
    even = np.linspace(0.0, 1.0, n)
    return np.array([np.interp(even * along[-1], along, row) for along, row in zip(length, theta, strict=True)])


def _quadrilaterals(mesh: FloatArray) -> list[FloatArray]:
    corners = np.stack([mesh[:-1, :-1], mesh[1:, :-1], mesh[1:, 1:], mesh[:-1, 1:]], axis=-2)
    return list(corners.reshape(-1, 4, mesh.shape[-1]))


def _clip(polygons: Sequence[FloatArray], column: int, level: float, keep_above: bool = True) -> list[FloatArray]:
    """Sutherland and Hodgman: the part of each polygon where a column is above a level, or below it."""
    sign = 1.0 if keep_above else -1.0
    kept = []
    for polygon in polygons:
        height = sign * (polygon[:, column] - level)
        if height.min() >= 0:
            kept.append(polygon)
        elif height.max() > 0:
            kept.append(_cut(polygon, height))
    return kept


def _cut(polygon: FloatArray, height: FloatArray) -> FloatArray:
    points = []
    for here, there, low, high in zip(polygon, np.roll(polygon, -1, axis=0), height, np.roll(height, -1), strict=True):
        if low >= 0:
            points.append(here)
        if low * high < 0:
            points.append(here + (there - here) * low / (low - high))
    return np.array(points)


def of_equal_length(polygons: Sequence[FloatArray]) -> FloatArray:
    """The polygons as one array, of shape (n, corners, 3), last corners repeated.

    matplotlib pads polygons of unequal lengths with uninitialised memory, and measures the axes with it.
    """
    most = max((len(polygon) for polygon in polygons), default=3)
    padded = [np.concatenate([polygon, np.repeat(polygon[-1:], most - len(polygon), axis=0)]) for polygon in polygons]
    return np.array(padded).reshape(-1, most, 3)


def shaded(color: str, polygon: FloatArray) -> tuple[float, float, float]:
    """The colour, darker the steeper a polygon stands, in the proportions in which the axes show it."""
    x, y, z = (polygon * np.array([1 / 180, 1.0, 0.25])).T
    following = [np.roll(values, -1) for values in (x, y, z)]
    # Newell's normal, twice the area of the three shadows.
    normal = np.array([
        ((y - following[1]) * (z + following[2])).sum(),
        ((z - following[2]) * (x + following[0])).sum(),
        ((x - following[0]) * (y + following[1])).sum(),
    ])  # fmt: skip
    upright = abs(normal[2]) / max(float(np.linalg.norm(normal)), 1e-300)
    red, green, blue = (0.72 + 0.28 * upright) * np.array(to_rgb(color))
    return float(red), float(green), float(blue)


def inside(mu0: FloatArray, low: float, high: float, *others: FloatArray) -> list[NDArray[Any]]:
    """Columns with NaN where ``mu0`` leaves its range, so that a line breaks there."""
    good = (mu0 >= low) & (mu0 <= high)
    return [np.where(good, values, np.nan) for values in (mu0, *others)]
