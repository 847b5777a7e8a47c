"""Hidden parts of a line in space: matplotlib sorts whole artists by depth, not points."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from mpl_toolkits.mplot3d import proj3d
from numpy.typing import NDArray

from ..models.parameters import FloatArray

#: A surface hides what lies deeper by more than this share of the box's depth. Lines lie on the surface itself, whose
#: polygons are flat and miss it by less.
CLEARANCE = 2e-3
#: Longest step along a line, as a share of the picture: how finely the end of a hidden part is located.
STEP = 2e-3


@dataclass(frozen=True)
class Cover:
    """Triangles of a surface as one view shows them: corners on the screen with their depths, (n, 3, 3)."""

    view: FloatArray
    triangles: FloatArray
    clearance: float

    def screen(self, points: FloatArray) -> FloatArray:
        """Points of shape (n, 3) as places on the screen and depths; planes in space stay planes."""
        return np.stack(proj3d.proj_transform(*points.T, self.view), axis=-1).astype(float)

    def hides(self, points: FloatArray) -> NDArray[np.bool_]:
        """Whether a triangle stands before each point; (n, 3) → (n,). A point that is not finite is not hidden."""
        low, high = self.triangles.min(axis=1), self.triangles.max(axis=1)
        return np.array([self._stands_before(place, low, high) for place in self.screen(points)], dtype=bool)

    def _stands_before(self, place: FloatArray, low: FloatArray, high: FloatArray) -> bool:
        x, y, depth = place
        near = depth - self.clearance
        boxes = (low[:, 0] <= x) & (x <= high[:, 0]) & (low[:, 1] <= y) & (y <= high[:, 1]) & (low[:, 2] < near)
        first, second, third = np.moveaxis(self.triangles[boxes], 1, 0)
        u, v, w = second - first, third - first, place - first
        area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):  # a triangle seen edge on covers nothing
            along = (w[:, 0] * v[:, 1] - w[:, 1] * v[:, 0]) / area
            across = (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / area
            at = first[:, 2] + along * u[:, 2] + across * v[:, 2]
            return bool(((along >= 0) & (across >= 0) & (along + across <= 1) & (at < near)).any())


def cover_of(ax: Any, polygons: Sequence[FloatArray]) -> Cover:
    """Convex polygons as the axes show them now; limits, proportions and view must have been set."""
    view = ax.get_proj()
    box = np.array(list(itertools.product(ax.get_xlim(), ax.get_ylim(), ax.get_zlim())))
    depths = proj3d.proj_transform(*box.T, view)[2]
    empty = Cover(view, np.empty((0, 3, 3)), CLEARANCE * float(np.ptp(depths)))
    fans = [polygon[[0, i, i + 1]] for polygon in polygons for i in range(1, len(polygon) - 1)]
    corners = empty.screen(np.concatenate(fans)) if fans else np.empty((0, 3))
    return Cover(view, corners.reshape(-1, 3, 3), empty.clearance)


def parts(line: FloatArray, sheet: Cover) -> list[tuple[FloatArray, bool]]:
    """A line of shape (n, 3) in pieces, each with whether it is hidden; NaN breaks it, neighbours share a point."""
    found = []
    for stretch in _stretches(line):
        dense = _dense(stretch, sheet)
        behind = sheet.hides(0.5 * (dense[1:] + dense[:-1]))
        turns = [0, *(np.flatnonzero(np.diff(behind)) + 1), behind.size]
        found += [(dense[begin : end + 1], bool(behind[begin])) for begin, end in itertools.pairwise(turns) if end > begin]
    return found


def _stretches(line: FloatArray) -> list[FloatArray]:
    """The runs of points between NaNs, without single points."""
    good = np.isfinite(line).all(axis=1)
    runs = np.split(line, np.flatnonzero(np.diff(good)) + 1)
    return [run for run in runs if len(run) > 1 and np.isfinite(run).all()]


def _dense(line: FloatArray, sheet: Cover) -> FloatArray:
    """The line with points added, so that no step on the screen is longer than :data:`STEP` of the picture."""
    places = sheet.screen(line)[:, :2]
    corners = sheet.triangles[..., :2].reshape(-1, 2) if sheet.triangles.size else places
    width = float(np.ptp(corners, axis=0).max()) or 1.0
    counts = np.maximum(1, np.ceil(np.hypot(*np.diff(places, axis=0).T) / (STEP * width))).astype(int)
    shares = [np.arange(count) / count for count in counts]
    inner = [here + share[:, None] * (there - here) for here, there, share in zip(line, line[1:], shares, strict=False)]
    return np.concatenate([*inner, line[-1:]])
