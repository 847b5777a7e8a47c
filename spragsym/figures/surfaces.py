"""The equilibrium surface in three dimensions, and lines on it: polygons of one collection, which matplotlib sorts by depth."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib.colors import to_rgba_array

import spragsym as ss

from ..assumed import MU0_RANGE
from ..models.parameters import FloatArray, Parameters
from ..numerics.interval_arrays import Int8Array
from ..results import Stability
from .curves import LABELS
from .style import BLACK, VERMILION, Sheet, Table, stacked

_SHEET_COLORS = {Stability.STABLE: "#b3d9f0", Stability.DIVERGENT: "#f7b78f", Stability.FLUTTER: "#96dcc0"}
#: Proportions of the box, what its sides go over in θ₀ in degrees, μ₀ and x, and the angles under which it is seen.
_ASPECT, _RANGE, _ELEVATION, _AZIMUTH = (1.25, 1.1, 0.9), (180.0, 1.0, 4.0), 24.0, -118.0
#: Columns of points.
POINT = ("theta0_deg", "mu0", "x")
#: How far lines stand before the surface, and half of their width, in the units of the proportions.
_LIFT, _HALF = 0.08, 0.0036


def sheets(p: Parameters, mu0: tuple[float, float], theta0_deg: FloatArray, n: int) -> tuple[FloatArray, Int8Array]:
    """Quadrilaterals of (θ₀ in degrees, μ₀, x), shape (cells, 4, 3): the surface between two frictions; and their stability.

    Each θ₀ has its own directions, from one end of the arc in contact to the other, where μ₀ is infinite: the mesh has no hole.
    """
    theta0 = np.radians(theta0_deg)
    found = ss.surface(p, _directions(p, theta0, n, mu0), theta0[:, None])
    friction, x, within = found.mu0, found.x, np.clip(found.mu0, *mu0)
    kept = friction == within
    for side in (1, -1) * 4:  # vertices beyond an end of the range come back to it, on the line to a neighbour within
        beside, there = np.roll(friction, side, axis=1), np.roll(x, side, axis=1)
        moves = (friction != within) & (beside == np.clip(beside, *mu0))
        share = (within - friction) / np.where(moves, beside - friction, np.inf)
        friction, x = np.where(moves, within, friction), x + share * (there - x)
    vertices = np.stack(
        [np.broadcast_to(theta0_deg[:, None], x.shape), np.where(friction == within, friction, np.nan), x], axis=-1
    )
    cells, inside = (
        np.stack([columns[:-1, :-1], columns[1:, :-1], columns[1:, 1:], columns[:-1, 1:]], axis=2) for columns in (vertices, kept)
    )
    whole = np.isfinite(cells).all(axis=(2, 3)) & inside.any(axis=2)
    return cells[whole], found.stability[:-1, :-1][whole]


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


def space_axes(figure: Sheet, place: Any, zoom: float) -> Any:
    """Axes in three dimensions, for print."""
    ax: Any = figure.add_axes(place, projection="3d", computed_zorder=False)
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
        axis._axinfo["grid"].update(linewidth=0.3, color="#cccccc")  # there is no public way to thin the grid
    ax.tick_params(pad=-2)
    ax.zaxis.set_rotate_label(False)
    ax.set_proj_type("ortho")
    ax.set_box_aspect(_ASPECT, zoom=zoom)
    ax.view_init(elev=_ELEVATION, azim=_AZIMUTH)
    ax.set(xlabel=r"$\theta_0$ (deg)", ylabel=r"$\mu_0$", xlim=(0, 180), ylim=MU0_RANGE, zlim=(-2, 2))
    ax.set_zlabel(LABELS["x"], rotation=90)
    ax.set_xticks(np.arange(0, 181, 45))
    ax.set_zticks(np.arange(-2, 3, 1))
    return ax


def draw_surface(ax: Any, p: Parameters, lines: Iterable[tuple[FloatArray, str]], detail: float = 1.0) -> Table:
    """Sheets by stability, fold curves, cusps and more ``lines``, (n, 3) and a colour; behind a sheet thin dashes."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    cells, kinds = sheets(p, MU0_RANGE, np.linspace(0.5, 179.5, round(160 * detail)), round(160 * detail))
    size, (up, turn) = np.divide(_RANGE, _ASPECT), np.radians((_ELEVATION, _AZIMUTH))
    towards = np.array([np.cos(up) * np.cos(turn), np.cos(up) * np.sin(turn), np.sin(up)])
    first, second = ((cells[:, i] - cells[:, j]) / size for i, j in ((2, 0), (3, 1)))
    normal = np.cross(first, second)
    upright = np.abs(normal[:, 2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    colors = to_rgba_array([_SHEET_COLORS[Stability(kind)] for kind in kinds])
    colors[:, :3] *= 0.72 + 0.28 * upright[:, None]  # darker the steeper
    found, tables = ss.bifurcation_set(p), []
    for curve in found.curves:
        points = on_surface(curve.mu0, curve.theta0, curve.x)
        lines = [*lines, (points, VERMILION)]
        tables.append(table_of_points(points))
    polygons, faces = [cells], [colors]
    for points, color in lines:
        ax.plot(*points.T, color=color, linewidth=0.6, linestyle=(0, (3.0, 2.2)), zorder=2)
        across = np.cross(np.diff(points, axis=0) / size, towards)
        across *= size * _HALF / np.maximum(np.linalg.norm(across, axis=1), 1e-300)[:, None]
        begin, end = (part + _LIFT * towards * size for part in (points[:-1], points[1:]))
        ribbon = np.stack([begin - across, end - across, end + across, begin + across], axis=1)
        ribbon = ribbon[np.isfinite(ribbon).all(axis=(1, 2))]
        polygons.append(ribbon)
        faces.append(np.repeat(to_rgba_array(color), len(ribbon), axis=0))
    every = np.concatenate(faces)
    ax.add_collection3d(Poly3DCollection(np.concatenate(polygons), facecolors=every, edgecolors=every, linewidths=0.3,
                                         rasterized=True, zorder=1))  # fmt: skip
    cusps = np.degrees(found.cusps.theta0), found.cusps.mu0, found.cusps.x
    ax.plot(*cusps, linestyle="none", marker="o", markersize=4, color=BLACK, zorder=5)
    return stacked(tables, "curve", POINT)


def table_of_points(points: FloatArray) -> Table:
    """The points of a line that are shown."""
    return dict(zip(POINT, points[np.isfinite(points[:, 1])].T, strict=True))


def on_surface(mu0: FloatArray, theta0: FloatArray, x: FloatArray) -> FloatArray:
    """Points of a line on the surface, θ₀ in radians; NaN where ``mu0`` leaves its range, so that the line breaks there."""
    return np.stack([np.degrees(theta0), np.where((mu0 >= MU0_RANGE[0]) & (mu0 <= MU0_RANGE[1]), mu0, np.nan), x], axis=-1)
