"""Further points of curves of folds, each proved: as many as make a curve smooth, and where it leaves a parameter's range.

In coordinates and both parameters a curve of folds is smooth at its cusps, too: only its image in the plane of the two
has a point there. So it is followed there: between two neighbours a cubic with their tangents says where another point is looked
for.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...exact import contractors
from ...exact.interval_arrays import FloatArray, Intervals
from ..mechanics.border import on_side
from .defining_systems import Augmented

#: How far a curve may be from the straight line between two neighbours, over the ranges of the parameters.
SMOOTH = 2e-4
#: Times that points are put between all neighbours.
ROUNDS = 7
#: Steps of Newton's method, and how far it may lead away over the distance of the neighbours.
STEPS, NEAR = 6, 0.5
#: How far behind the last point an end of a range is looked for, over the scales.
BEYOND = 0.2
#: Half-width of the box in which a point is proved, over the size of what it is made of.
ROOM = 1e-9


@dataclass(frozen=True)
class FoldCurves:
    """Folds along two parameters: the system in coordinates and both, the other parameters, scales of the unknowns, ranges."""

    system: Augmented
    given: FloatArray
    scale: FloatArray
    spans: FloatArray

    def smooth(self, states: FloatArray) -> FloatArray:
        """A chain of folds, shape (n + 2, number), with further ones between its neighbours and on the ends of the ranges."""
        out = self._extended(self._extended(states)[:, ::-1])[:, ::-1] if states.shape[1] > 1 else states
        for _ in range(ROUNDS):
            before = out.shape[1]
            out = self._halved(out)
            if out.shape[1] == before:
                break
        return out

    def tangents(self, states: FloatArray) -> FloatArray:
        """Unit vectors along the curve, over the scales; 0 where there is none."""
        slopes = np.moveaxis(self._slopes(Intervals.point(states)).middle * self.scale[None, :, None], -1, 0)
        known: NDArray[np.bool_] = np.logical_and.reduce(np.isfinite(slopes), axis=(1, 2))
        vectors: FloatArray = np.linalg.svd(np.where(known[:, None, None], slopes, 0.0))[2][:, -1, :].T
        return vectors * known

    def _halved(self, states: FloatArray) -> FloatArray:
        """With a point between all neighbours between which the curve is not straight."""
        if states.shape[1] < 2:
            return states
        place, along = states / self.scale[:, None], self.tangents(states)
        chord = np.diff(place, axis=1)
        length = np.linalg.norm(chord, axis=0)
        one, two = (part * np.sign((part * chord).sum(axis=0)) for part in (along[:, :-1], along[:, 1:]))
        middle = 0.5 * (place[:, :-1] + place[:, 1:]) + 0.125 * length * (one - two)
        bent = np.linalg.norm((middle - 0.5 * (place[:, :-1] + place[:, 1:]))[-2:], axis=0) > SMOOTH
        rows = np.flatnonzero(bent & (length > 0))
        normal = chord[:, rows] / length[rows]
        found, good = self.on_curve(middle[:, rows] * self.scale[:, None], normal, length[rows])
        return np.insert(states, rows[good] + 1, found[:, good], axis=1)

    def _extended(self, states: FloatArray) -> FloatArray:
        """With a point at the end of a range of a parameter that the curve reaches behind its last point."""
        end, chord = states[:, -1], np.diff(states[:, -2:], axis=1)[:, 0] / self.scale
        along = self.tangents(states[:, -1:])[:, 0]
        along = along * np.sign(along @ chord)
        candidates = []
        for number, span in enumerate(self.spans):
            place = len(end) - 2 + number
            away = (span[int(along[place] > 0)] - end[place]) / self.scale[place]
            if away * along[place] > 0 and away / along[place] <= BEYOND:
                candidates.append((away / along[place], place, span[int(along[place] > 0)]))
        if not candidates:
            return states
        far, place, value = min(candidates)
        start = end + far * along * self.scale
        start[place] = value
        normal = np.zeros((len(end), 1))
        normal[place] = 1.0
        found, good = self.on_curve(start[:, None], normal, np.array([max(far, 1e-6)]))
        found[place] = value
        return np.concatenate([states, found[:, good]], axis=1)

    def on_curve(self, start: FloatArray, normal: FloatArray, near: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        """Points of the curve in the planes through points with these normals, over the scales, and which are proved."""
        states, scale = start, self.scale[:, None]
        with np.errstate(all="ignore"):
            for _ in range(STEPS):
                values = self._values(states).middle
                slopes = self._slopes(Intervals.point(states)).middle * self.scale[None, :, None]
                matrix = np.moveaxis(np.concatenate([slopes, normal[None]]), -1, 0)
                off = np.concatenate([values, (normal * (states - start) / scale).sum(axis=0)[None]]).T
                regular = np.isfinite(matrix).all(axis=(1, 2)) & (np.abs(np.linalg.det(np.nan_to_num(matrix))) > 0)
                matrix = np.where(regular[:, None, None], matrix, np.eye(len(scale)))
                states = states - np.linalg.solve(matrix, off[:, :, None])[:, :, 0].T * scale
            good = regular & (np.linalg.norm((states - start) / scale, axis=0) <= NEAR * near)
            good &= ((self.spans[:, :1] <= states[-2:]) & (states[-2:] <= self.spans[:, 1:])).all(axis=0)
            good[good] = self._proved(states[:, good], normal[:, good])
        return states, good

    def _proved(self, states: FloatArray, normal: FloatArray) -> NDArray[np.bool_]:
        """Whether a fold in contact is next to each state, with the same value of what the normal points along most."""
        return self.enclosed(states, np.abs(normal).argmax(axis=0))[1]

    def enclosed(self, states: FloatArray, fixed: NDArray[np.int64]) -> tuple[FloatArray, NDArray[np.bool_]]:
        """Boxes, shape (2, n + 2, N), around points of the curve in contact, and which are proved to hold one.

        ``fixed`` is the number of the unknown whose value is that of the state.
        """
        count, columns = len(self.scale), np.arange(states.shape[1])
        free = np.array([np.delete(np.arange(count), place) for place in fixed], dtype=np.int64).reshape(-1, count - 1).T
        room = ROOM * np.maximum(1.0, np.abs(states))
        room[fixed, columns] = 0.0
        wide = np.stack([-states, states]) + room
        slopes = self._slopes(Intervals(wide)).ends[:, :, free, columns]
        reach = contractors.distance(wide, states)[free, columns]
        step = contractors.newton(self._values(states), Intervals(slopes), states[free, columns], reach)
        closed = on_side(self.system, self._fixed(states.shape[1]), wide)[0]
        good = closed & contractors.inside(step.ends, wide[:, free, columns])
        wide[:, free, columns] = np.fmin(step.ends, wide[:, free, columns])
        return wide, good

    def _values(self, states: FloatArray) -> Intervals:
        return self.system.residuals(Intervals.point(states), self._fixed(states.shape[1]))

    def _slopes(self, states: Intervals) -> Intervals:
        with np.errstate(all="ignore"):
            return self.system.jacobian(states, self._fixed(states.shape[1]))

    def _fixed(self, count: int) -> Intervals:
        return self.system.prepared(Intervals.point(np.repeat(np.nan_to_num(self.given), count, axis=1)))
