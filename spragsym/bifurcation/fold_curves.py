"""Further points of curves of folds, each proved: as many as make a curve smooth, and where it leaves a parameter's range.

In coordinates and both parameters a curve of folds is smooth at its cusps, too: only its image in the plane of the two
has a point there. So it is followed there: between two neighbours a cubic with their tangents says where another point is looked
for.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..numerics import contractors
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals
from ..statics.mechanics.border import on_side
from .defining_systems import Augmented

#: How far a curve may be from the straight line between two neighbours, over the ranges of the parameters.
SMOOTH = 2e-4
#: Times that points are put between all neighbours.
ROUNDS = 7
#: Steps of Newton's method, and how far it may lead away over the distance of the neighbours.
STEPS, NEAR = 6, 0.5
#: First pace behind the end of a chain, over the scales, the least one, and paces that are tried.
PACE, LEAST, PACES = 0.02, 1e-6, 60
#: Cosine of the turn within a pace, and distance of a point from its chord, over its length.
STRAIGHT, BESIDE = 0.9, 0.05
#: Half-width of the box in which a point is proved, over the size of what it is made of.
ROOM = 1e-9


@dataclass(frozen=True)
class FoldCurves:
    """Folds along two parameters: the system in coordinates and both, and scales of the unknowns."""

    system: Augmented
    scale: FloatArray

    @property
    def spans(self) -> FloatArray:
        """Ranges of both parameters, shape (2, 2)."""
        return self.system.family.spans

    def smooth(self, states: FloatArray) -> FloatArray:
        """A chain of folds, shape (n + 2, number), with further ones between its neighbours."""
        out = states
        for _ in range(ROUNDS):
            before = out.shape[1]
            out = self._halved(out)
            if out.shape[1] == before:
                break
        return out

    def joined(self, chains: Sequence[FloatArray], lines: Sequence[FloatArray]) -> list[FloatArray]:
        """Chains followed beyond both ends: to the end of a range, or to the end of another chain, with which it then is one.

        ``lines`` are the values of either parameter at which all points are known, so that none is passed unseen.
        """
        left, out = list(chains), []
        while left:
            chain = left.pop(0)
            for side in (1, -1):
                while not _is_closed(chain):
                    path, met = self._beyond(chain, left, lines, side)
                    chain = np.concatenate([chain, path], axis=1)
                    if met is None:
                        break
                    if met[0] >= 0:
                        chain = np.concatenate([chain, left.pop(met[0])[:, :: met[1]]], axis=1)
                chain = chain[:, ::-1]
            out.append(chain)
        return out

    def _beyond(
        self, chain: FloatArray, others: Sequence[FloatArray], lines: Sequence[FloatArray], side: int
    ) -> tuple[FloatArray, tuple[int, int] | None]:
        """Points behind the last by pseudo-arclength, and which chain they lead to, from which end; −1 is its own begin."""
        known = [(k, way, other[:, 0 if way > 0 else -1]) for k, other in enumerate(others) for way in (1, -1)]
        known += [(-1, 1, chain[:, 0])] if chain.shape[1] > 2 else []
        path = [chain[:, -1]]
        before, pace = chain[:, -2] if chain.shape[1] > 1 else None, PACE
        for _ in range(PACES):
            if pace < LEAST:
                break
            end = path[-1]
            along = self.tangents(end[:, None])[:, 0]
            along = along * (side if before is None else np.sign(along @ ((end - before) / self.scale)))
            start, fixed = self._stopped(end, end + pace * along * self.scale, self.spans)
            found, good = self._at(start, along, fixed, pace)
            if good and fixed is None:
                start, fixed = self._stopped(end, found, lines)
                found, good = self._at(start, along, fixed, pace) if fixed is not None else (found, good)
            if not good or abs(self.tangents(found[:, None])[:, 0] @ along) < STRAIGHT:
                pace *= 0.5
                continue
            for k, way, there in known:
                if self._lies_between(there, end, found):
                    return np.array([*path[1:], *([there] if k < 0 else [])]).reshape(-1, len(end)).T, (k, way)
            path.append(found)
            if fixed is not None:
                # A line on which the point belongs to the inside of a chain is no end: what leads there is drawn already.
                return (np.array(path[1:]).T if found[fixed] in self.spans[fixed - len(end)] else chain[:, :0]), None
            before, pace = end, 1.5 * pace
        return np.array(path[1:]).reshape(-1, len(end)).T, None

    def _at(self, start: FloatArray, along: FloatArray, fixed: int | None, near: float) -> tuple[FloatArray, bool]:
        """The point in the plane across ``along``, or where an unknown is as in ``start``; and whether it is proved."""
        normal = along if fixed is None else (np.arange(len(start)) == fixed).astype(float)
        found, good = self.on_curve(start[:, None], normal[:, None], np.array([near]))
        if fixed is not None:
            found[fixed] = start[fixed]
        return found[:, 0], bool(good[0])

    def _stopped(
        self, end: FloatArray, to: FloatArray, lines: Sequence[FloatArray] | FloatArray
    ) -> tuple[FloatArray, int | None]:
        """Where the way from one point to another first passes a line, and the number of the parameter that stands there."""
        share, place, there = 1.0, None, 0.0
        for number in (-2, -1):
            low, high = sorted((end[number], to[number]))
            room = 1e-12 * self.scale[number]
            passed = [value for value in lines[number] if low - room <= value <= high + room and abs(value - end[number]) > room]
            for value in passed:
                at = (value - end[number]) / (to[number] - end[number])
                if place is None or at < share:
                    share, place, there = at, len(end) + number, value
        start = end + min(share, 1.0) * (to - end)
        if place is not None:
            start[place] = there
        return start, place

    def _lies_between(self, point: FloatArray, one: FloatArray, two: FloatArray) -> bool:
        """Whether a point of the curve lies between two others near to each other, or is the second one."""
        chord, away = (two - one) / self.scale, (point - one) / self.scale
        length = float(np.linalg.norm(chord))
        share = float(away @ chord) / length**2
        return bool(1e-9 < share <= 1 + 1e-6 and np.linalg.norm(away - share * chord) <= BESIDE * length)

    def tangents(self, states: FloatArray) -> FloatArray:
        """Unit vectors along the curve, over the scales; 0 where there is none."""
        slopes = np.moveaxis(self._slopes(Intervals.point(states)).middle * self.scale[None, :, None], -1, 0)
        known: BoolArray = np.logical_and.reduce(np.isfinite(slopes), axis=(1, 2))
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

    def on_curve(self, start: FloatArray, normal: FloatArray, near: FloatArray) -> tuple[FloatArray, BoolArray]:
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
            # A fold in contact is next to each state, with the same value of what the normal points along most.
            good[good] = self.enclosed(states[:, good], np.abs(normal[:, good]).argmax(axis=0))[1]
        return states, good

    def enclosed(self, states: FloatArray, fixed: IntArray) -> tuple[FloatArray, BoolArray]:
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
        closed = on_side(self.system, self.system.fixed(states.shape[1]), wide)[0]
        good = closed & contractors.inside(step.ends, wide[:, free, columns])
        wide[:, free, columns] = np.fmin(step.ends, wide[:, free, columns])
        return wide, good

    def _values(self, states: FloatArray) -> Intervals:
        return self.system.residuals(Intervals.point(states), self.system.fixed(states.shape[1]))

    def _slopes(self, states: Intervals) -> Intervals:
        with np.errstate(all="ignore"):
            return self.system.jacobian(states, self.system.fixed(states.shape[1]))


def _is_closed(chain: FloatArray) -> bool:
    return chain.shape[1] > 2 and bool((chain[:, 0] == chain[:, -1]).all())
