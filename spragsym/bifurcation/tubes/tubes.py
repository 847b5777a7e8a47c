"""Tubes around curves of states, proved: boxes that hold one state for each value of what moves, for whole boxes of parameters.

A point of a curve is z = (q, v): the coordinates, and the parameter that moves. One of these is the pivot s, which the others
follow: v itself, or a coordinate where a fold is to be passed. About a middle m, with the parameters p about their middle c,

    z = m + d s + D (p − c) + u,   F(m, c) + (F_z d) s + (F_z D + F_p) (p − c) + F_z u = 0,

by the mean value theorem with slopes over the whole box. Where d and D are near the curve's own slopes, little is left of the
two terms in the middle, and interval Newton in u proves that each s and each p have one state in the box, and only one.
Segments hold together where the set of states at the end of one lies in the box of the next.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...numerics import contractors
from ...numerics.affine import AFFINE, Affine
from ...numerics.interval_arrays import FloatArray, IntArray, Intervals, matrix, stacked
from ...statics.mechanics.balance import Balance
from ...statics.mechanics.border import on_side
from ...statics.mechanics.laws import XP
from .tube_regions import UP, Flags, Parts, Place, Region, Slopes, beside_tube, of_affine

#: The first step over the whole way, the least one, and most steps.
FIRST, LEAST, MOST = 2.0**-5, 2.0**-14, 400
#: Half-width of a box at least, over its size; how often it is made wider, and by how much of its width.
NARROW, INFLATIONS, ROOM = 1e-9, 6, 0.1
#: Steps of Newton's method at the end of a step.
STEPS = 6
#: Steps through a fold, the first one as a share of the straight way, and what counts as no size of a coordinate.
TURNS, TURN, SMALL = 60, 0.25, 1e-3
#: A step towards a fold that is this share of what is left to the goal is near enough to go over it.
NEAR = 0.1
#: For a sharp answer: a step that is this share of how far apart the folds of a part lie, and this one of the whole.
CLOSE, SHARP = 0.05, 2.0**-12
#: A slope that is not nothing.
TINY = 1e-12


class Tubes:
    """Curves of states of a model in contact as ``vary`` moves; ``free`` are the parameters that have a width."""

    def __init__(self, balance: Balance, vary: str, free: tuple[str, ...] = ()) -> None:
        self.balance, self.n = balance, balance.n
        self.moving = balance.parameters.index(vary)
        self.vary, self.free = vary, free
        self.places = [balance.parameters.index(name) for name in free]

    # --------------------------------------------------------------------------------------------------- evaluation

    def _bounds(self, parts: Parts, v: Intervals) -> Intervals:
        low, high = parts.fixed.copy(), parts.fixed.copy()
        low[self.moving], high[self.moving] = v.low, v.high
        span = self._span(parts)
        low[self.places], high[self.places] = span.low, span.high
        with np.errstate(all="ignore"):
            return self.balance.prepared(Intervals.between(low, high))

    @staticmethod
    def _span(parts: Parts) -> Intervals:
        wide = np.where(parts.half > 0, parts.half * UP + np.spacing(np.abs(parts.centre)), 0.0)
        return Intervals(np.stack([-parts.centre, parts.centre]) + wide)

    def slopes(self, parts: Parts, z: Intervals) -> Intervals:
        """Slopes of the forces by q, v and the free parameters over boxes, shape (n, n + 1 + free, N)."""
        bounds, shape = self._bounds(parts, z[self.n]), z.shape[1:]
        q, values = list(z[: self.n]), self.balance.arguments(bounds)
        with np.errstate(all="ignore"):
            directions = self.balance.directions(q, values, shape)
            return matrix(self._rows(q, directions, values, XP, self._moving(parts)), shape)

    def over(self, parts: Parts, region: Region, pivot: int) -> Slopes:
        """Slopes over regions, solved for all unknowns but the pivot: affine where parameters have a width."""
        if not parts.half.any():
            slopes = self.slopes(parts, region.box)
            return Slopes([list(row) for row in slopes], Intervals(np.zeros((2, *slopes.shape[2:]))))
        with np.errstate(all="ignore"):
            return of_affine(self.affine_slopes(parts, region), self._others(pivot), parts.half.shape[1:])

    def affine_slopes(self, parts: Parts, region: Region) -> list[list[Any]]:
        """Slopes in affine arithmetic, by row and column."""
        apart, shape = self.apart(parts), parts.half.shape[1:]
        z = region.numbers(apart)
        fixed = zip(self.balance.parameters, parts.fixed, strict=True)
        values: dict[str, Any] = {name: Affine(row, np.zeros((1, *shape))) if row.any() else 0 for name, row in fixed}
        for k, name in enumerate(self.free):
            terms = np.zeros_like(z[0].terms)
            terms[1 + k] = apart[k]
            values[name] = Affine(parts.centre[k], terms)
        values[self.vary] = z[self.n]
        q, values = z[: self.n], self.balance.arguments_of(values, AFFINE)
        directions = self.balance.plain_directions(q, values, AFFINE, self._turnings(parts, region))
        return self._rows(q, directions, values, AFFINE, self._moving(parts))

    def _turnings(self, parts: Parts, region: Region) -> list[Affine]:
        """Angles of torsion springs, from intervals."""
        if not self.balance.torsions:
            return []
        values = self.balance.arguments(self._bounds(parts, region.box[self.n]))
        found = self.balance.directions(list(region.box[: self.n]), values, parts.half.shape[1:])
        return list(map(Affine.between, found[3 * self.balance.springs :]))

    def _rows(self, q: list[Any], directions: list[Any], values: dict[str, Any], xp: Any, names: list[str]) -> list[list[Any]]:
        stiffness = self.balance.by_coordinate("forces_jacobian", q, directions, values, xp)
        moved = self.balance.by_parameters(names, q, directions, values, xp)
        none = [0] * (1 + len(self.free) - len(names))
        return [[*row, *more, *none] for row, more in zip(stiffness, moved, strict=True)]

    def _moving(self, parts: Parts) -> list[str]:
        """What moves, and the free parameters where any box has a width."""
        return [self.vary, *(self.free if parts.half.any() else ())]

    def floats(self, parts: Parts, z: FloatArray, slopes: bool = True) -> tuple[FloatArray, FloatArray]:
        """Forces and their slopes in the middle of the boxes, in floats."""
        columns = parts.fixed.copy()
        columns[self.moving], columns[self.places] = z[self.n], parts.centre
        values, q = self.balance.floats(columns), list(z[: self.n])
        with np.errstate(all="ignore"):
            directions = self.balance.plain_directions(q, values, np)
            forces = self.balance.by_coordinate("forces", q, directions, values, np)
            rows = self._rows(q, directions, values, np, self._moving(parts)) if slopes else []
        whole = np.zeros((self.n, self.n + 1 + len(self.free), z.shape[1]))
        for i, row in enumerate(rows):
            for j, entry in enumerate(row):
                whole[i, j] = entry
        return np.stack([np.broadcast_to(force, z.shape[1:]) for force in forces]), whole

    def _forces(self, parts: Parts, z: FloatArray) -> Intervals:
        """Enclosed, in the middle of the boxes."""
        bounds, shape = self._bounds(parts.middles(), Intervals.point(z[self.n])), z.shape[1:]
        q, values = list(Intervals.point(z[: self.n])), self.balance.arguments(bounds)
        with np.errstate(all="ignore"):
            directions = self.balance.directions(q, values, shape, sides=self.balance.anywhere)
            return stacked(self.balance.by_coordinate("forces", q, directions, values), shape)

    def apart(self, parts: Parts) -> FloatArray:
        """How far the free parameters lie from their middles at most."""
        wide = self._span(parts)
        return np.maximum(wide.high - parts.centre, parts.centre - wide.low) * UP

    def _others(self, pivot: int) -> list[int]:
        return [each for each in range(self.n + 1) if each != pivot]

    def corrected(self, parts: Parts, z: FloatArray, pivot: int) -> FloatArray:
        """Newton's method in the middle of the boxes with a given pivot, the slopes renewed every other step."""
        others, z, inverse = self._others(pivot), z.copy(), np.zeros(0)
        for number in range(STEPS):
            forces, slopes = self.floats(parts, z, slopes=number % 2 == 0)
            if number % 2 == 0:
                inverse = contractors.inverse(slopes[:, others])
            step = np.einsum("ijN,jN->iN", inverse, forces)
            step = np.where(np.isfinite(step), step, 0.0)
            z[others] -= step
            if (np.abs(step) < 1e-13 * (1 + np.abs(z[others]))).all():
                break
        return z

    def tangents(self, parts: Parts, z: FloatArray, pivot: int) -> tuple[FloatArray, FloatArray]:
        """dz/ds and dz/dp in the middle of the boxes."""
        others = self._others(pivot)
        slopes = self.floats(parts, z)[1]
        inverse = contractors.inverse(slopes[:, others])
        by_s, by_p = np.ones(z.shape), np.zeros((self.n + 1, *parts.half.shape))
        by_s[others] = -np.einsum("ijN,jN->iN", inverse, slopes[:, pivot])
        by_p[others] = -np.einsum("ijN,jkN->ikN", inverse, slopes[:, self.n + 1 :])
        return by_s, by_p

    def _across(self, parts: Parts, z: FloatArray, pivot: int) -> FloatArray:
        """dz/dp in the middle of the boxes, where they have a width at all."""
        return self.tangents(parts, z, pivot)[1] if parts.half.any() else np.zeros((self.n + 1, *parts.half.shape))

    # ------------------------------------------------------------------------------------------------------- proofs

    def place(self, parts: Parts, z: FloatArray, pivot: int, like: Place | None = None) -> Place:
        """The states of whole boxes at one value of the pivot, one for each point of a box; z is about those in the middle.

        ``like`` is a place near by, which tells how far from the middle states may lie.
        """
        z = self.corrected(parts, z, pivot)
        zero, by_p = np.zeros_like(z), self._across(parts, z, pivot)
        beside = zero if like is None else like.off * parts.half.any(axis=0)
        sure, room, held, off = self._one_state(parts, z, zero, by_p, np.zeros(z.shape[1]), pivot, beside)
        return Place(z, held, off, room, by_p, sure)

    def segment(self, parts: Parts, start: Place, z: FloatArray, pivot: int) -> tuple[Flags, Place, Region]:
        """From a place to another value of the pivot, about which z is: where that is proved, the place there, and the tube."""
        end = self.place(parts, z, pivot, start)
        z = end.z
        way = z[pivot] - start.z[pivot]
        with np.errstate(all="ignore"):
            along = np.where(way != 0, (z - start.z) / way, 0.0)
        # With another pivot than before the states there lie on either side of the middle.
        wide = np.where(
            start.held[pivot] > 0, start.held[pivot] * UP + 2 * np.spacing(np.abs(start.z[pivot]) + start.held[pivot]), 0
        )
        begin = start.z - along * np.sign(way) * wide
        middle, half = 0.5 * (begin + z), 0.5 * np.abs(z[pivot] - begin[pivot])
        middle[pivot] = 0.5 * (begin[pivot] + z[pivot])
        inside = self._across(parts, middle, pivot)
        apart = self.apart(parts)
        beside = np.maximum(*(beside_tube(one, middle, along, inside, apart, pivot) for one in (start, end)))
        sure, _, held, off = self._one_state(parts, middle, along, inside, half, pivot, beside)
        tube = Intervals(np.stack([-middle, middle]) + held + np.spacing(np.abs(middle) + held))
        region = Region(tube, middle, along, self._moved(middle, half, pivot), inside, off)
        return sure & end.sure & start.sure & (np.abs(way) >= wide), end, region

    @staticmethod
    def _moved(middle: FloatArray, half: FloatArray, pivot: int) -> FloatArray:
        """How far the pivot's values lie from the middle, which is rounded."""
        return np.where(half > 0, half * UP + np.spacing(np.abs(middle[pivot]) + half), 0.0)

    def _one_state(
        self, parts: Parts, middle: FloatArray, along: FloatArray, by_p: FloatArray, half: FloatArray, pivot: int,
        beside: FloatArray,
    ) -> tuple[Flags, FloatArray, FloatArray, FloatArray]:  # fmt: skip
        """Whether boxes hold one state, in contact, for each value of the pivot and of the parameters.

        They hold what lies within ``beside`` of where their middles move. Beside it how far from there a state is alone, and how
        far from the middles, and from where these move, states lie at most.
        """
        others, count = self._others(pivot), middle.shape[1]
        least = NARROW * np.maximum(1.0, np.abs(middle[others]))
        apart, moved = self.apart(parts), self._moved(middle, half, pivot)
        swing = (np.abs(along) * moved + (np.abs(by_p) * apart).sum(axis=1)) * UP
        forces = self._forces(parts, middle)
        across, strayed = Intervals(np.stack([moved, moved])), Intervals(np.stack([apart, apart]))
        reach = np.maximum(2 * least, (1 + ROOM) * beside[others] * parts.half.any(axis=0))
        room, held, off = np.zeros_like(middle), swing.copy(), np.zeros_like(middle)
        sure, open_ = np.zeros(count, dtype=np.bool_), np.ones(count, dtype=np.bool_)
        for _ in range(INFLATIONS):
            rows = np.flatnonzero(open_)
            if not rows.size:
                break
            m, alone = middle[:, rows], beside[:, rows].copy()
            alone[others] = np.maximum(reach[:, rows], alone[others])
            size = swing[:, rows] + alone
            box = Intervals(np.stack([-m, m]) + size + np.where(size > 0, np.spacing(np.abs(m) + size), 0.0))
            region = Region(box, m, along[:, rows], moved[rows], by_p[:, :, rows], alone)
            slopes = self.over(parts[rows], region, pivot)
            with np.errstate(all="ignore"):
                left = self._left(slopes, slopes.forces(forces[:, rows]), region, across[rows], strayed[:, rows])
                step = slopes.newton(left, others, reach[:, rows])
            good = np.isfinite(step).all(axis=(0, 1))
            done = good & contractors.inside(step, np.stack([reach[:, rows]] * 2))
            if done.any():
                here = rows[done]
                bounds = self._bounds(parts[here], box[:, done][self.n])
                sure[here] = on_side(self.balance, bounds, box.ends[:, : self.n, done])[0]
                room[:, here] = alone[:, done]
                held[np.array(others)[:, None], here] = (swing[others][:, here] + np.maximum(*step[:, :, done])) * UP
                off[np.array(others)[:, None], here] = np.maximum(*step[:, :, done]) * UP
            open_[rows[done | ~good]] = False
            reach[:, rows] = (1 + ROOM) * np.maximum(reach[:, rows], np.where(good, np.maximum(*np.abs(step)), 0.0))
        return sure, room, held, off

    def _left(self, slopes: Slopes, forces: Intervals, region: Region, moved: Intervals, strayed: Intervals) -> list[Intervals]:
        """F(m, c) and what is left of the changes along the tube and across the box, by row."""
        left = []
        for i, row in enumerate(slopes.rows):
            total = forces[i] + slopes.taken(slopes.image(i, region.along)) * moved
            for k in range(strayed.shape[0]):
                change = slopes.image(i, region.by_p[:, k], row[self.n + 1 + k])
                total = total + slopes.taken(change) * strayed[k]
            left.append(total)
        return left

    def rises(self, parts: Parts, region: Region, by_s: FloatArray, pivot: int) -> IntArray:
        """Sign of dv/ds for all states in regions, 0 where it is not known; ``by_s`` is about dz/ds."""
        others, v = self._others(pivot), self.n
        slopes, zero = self.over(parts, region, pivot), np.zeros((self.n, by_s.shape[1]))
        out, direction = np.zeros(by_s.shape[1], dtype=np.int64), by_s.copy()
        direction[pivot] = 0.0
        with np.errstate(all="ignore"):
            left = [slopes.taken(slopes.image(i, direction, row[pivot])) for i, row in enumerate(slopes.rows)]
            reach = zero + 0.1 * np.abs(by_s[v]) + TINY
            for _ in range(INFLATIONS):
                # Of what dz/ds differs by from the slope in the middle.
                step = slopes.newton(left, others, reach)
                known = contractors.inside(step, np.stack([reach, reach]))
                off = np.maximum(*step)[others.index(v)] * UP
                out = np.where(known & (off < np.abs(by_s[v])), np.sign(by_s[v]).astype(np.int64), out)
                reach = np.where(
                    known | ~np.isfinite(step).all(axis=(0, 1)), reach, (1 + ROOM) * np.maximum(reach, np.maximum(*step))
                )
        return out

    # ------------------------------------------------------------------------------------------------------ the way

    def followed(self, parts: Parts, start: Place, goal: FloatArray, least: float = LEAST) -> Place:
        """The state as ``vary`` moves to a goal: the last places that are proved, at the goal where all of the way is."""
        here = start[np.arange(goal.size)]
        way = goal - here.z[self.n]
        step = FIRST * way
        for _ in range(MOST):
            rows = np.flatnonzero(here.sure & (here.z[self.n] != goal) & (np.abs(step) >= least * np.abs(way)))
            if not rows.size:
                break
            at = here[rows]
            rest = goal[rows] - at.z[self.n]
            whole = np.abs(step[rows]) >= np.abs(rest)
            to = np.where(whole, goal[rows], at.z[self.n] + step[rows])
            z = at.z.copy()
            z[self.n] = to
            good, end, _ = self.segment(parts[rows], at, z, self.n)
            here.put(rows[good], end[good])
            step[rows] = np.where(good, 2 * step[rows], 0.25 * (to - at.z[self.n]))
        return here

    def passed(
        self, parts: Parts, start: Place, goal: FloatArray, sharp: bool = False
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """How far all states of a place are proved to go on as ``vary`` rises, and above which value to have ended.

        The pivot is a coordinate, and the tube goes on through a fold, where v, which has risen before, falls. The first is
        ``start.z`` or more, and at least the goal where all come to it; the second is below the goal, else infinite. Beside
        them how far each free parameter moves v, shape (free, N). A ``sharp`` answer is as near to the fold as the width of
        the parts allows; else it only tells the two apart from the goal.
        """
        safe, top = start.z[self.n].copy(), np.full(goal.size, np.inf)
        moves = np.zeros(parts.half.shape)
        for pivot, rows, by_v in self.pivots(parts, start):
            safe[rows], top[rows], moves[:, rows] = self._passed(parts[rows], start[rows], goal[rows], pivot, by_v, sharp)
            left = np.flatnonzero((safe[rows] < goal[rows]) & np.isinf(top[rows]))
            if left.size and not sharp:
                # The fold lies just above the goal, or a tube over it does.
                some, v = rows[left], by_v[left]
                safe[some], _, moves[:, some] = self._passed(parts[some], start[some], goal[some], pivot, v, sharp, over=False)
        return safe, top, moves

    def pivots(self, parts: Parts, start: Place) -> Iterator[tuple[int, Any, FloatArray]]:
        """The coordinate that moves most, over its size, where it does; the points for which it is that, and its slope by v."""
        by_v, _ = self.tangents(parts, start.z, self.n)
        with np.errstate(all="ignore"):
            pivots = np.argmax(np.abs(by_v[: self.n]) / np.maximum(np.abs(start.z[: self.n]), SMALL), axis=0)
        for pivot in range(self.n):
            rows = np.flatnonzero(start.sure & (pivots == pivot) & (by_v[pivot] != 0))
            if rows.size:
                yield pivot, rows, by_v[pivot, rows]

    def _passed(
        self, parts: Parts, start: Place, goal: FloatArray, pivot: int, by_v: FloatArray, sharp: bool, over: bool = True
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """:meth:`passed` for one pivot; ``over`` says whether the tube goes over the fold, or up to it only."""
        towards, straight = np.sign(by_v), np.abs(by_v * (goal - start.z[self.n]))
        by_s, by_p = self.tangents(parts, start.z, pivot)
        safe, top, highest = start.z[self.n].copy(), np.full(goal.size, np.inf), np.full(goal.size, -np.inf)
        moves = np.abs(by_p[self.n])
        open_ = self.rises(parts, start.region(), by_s, pivot) == towards
        rising = open_.copy()
        # All states of the place lie within the first segment.
        here, step = start[np.arange(goal.size)], np.maximum(TURN * straight, 2 * start.held[pivot])
        for _ in range(TURNS):
            rows = np.flatnonzero(open_ & (step > LEAST * straight))
            if not rows.size:
                break
            at, some = here[rows], parts[rows]
            good, end, tube = self.segment(some, at, at.z + by_s[:, rows] * (towards * step)[rows], pivot)
            up = np.zeros(rows.size, dtype=np.bool_)
            up[good] = self.rises(some[good], tube[good], by_s[:, rows[good]], pivot) == towards[rows[good]]
            good &= np.where(rising[rows], up, tube.box.high[self.n] < goal[rows])
            # Near its fold v is as wide as the parts make it: there is no nearer.
            near = NEAR * (goal[rows] - at.z[self.n])
            if sharp:
                wide = (moves[:, rows] * some.half).sum(axis=0)
                near = np.minimum(near, CLOSE * wide + SHARP * (goal - start.z[self.n])[rows])
            turns = over & rising[rows] & ~good & (np.abs(by_s[self.n, rows]) * step[rows] < near)
            rising[rows[turns]] = False
            step[rows] *= np.where(good, 1.5, np.where(turns, 0.5, 0.25))
            rows, end, some, tube = rows[good], end[good], some[good], tube[good]
            if not rows.size:
                continue
            here.put(rows, end)
            by_s[:, rows], by_p = self.tangents(some, end.z, pivot)
            moves[:, rows] = np.abs(by_p[self.n])
            safe[rows] = np.where(rising[rows], end.box().low[self.n], safe[rows])
            # While v rises it is highest at the end.
            reached = np.where(rising[rows], end.box().high[self.n], tube.box.high[self.n])
            highest[rows] = np.maximum(highest[rows], reached)
            falls = self.rises(some, end.region(), by_s[:, rows], pivot) == -towards[rows]
            top[rows] = np.where(~rising[rows] & falls, highest[rows], np.inf)
            open_[rows] = (safe[rows] <= goal[rows]) & np.isinf(top[rows])
        return safe, top, moves
