"""Cycles: what a motion winds onto, by the closed orbit itself and its multipliers, and whether it nears it at that rate.

Newton's method with the derivative of the flow (:mod:`.periodic_orbit`) gives the cycle from two states that are alike, where x
is largest. Of several numbers of rounds the smallest comes first, and the least period is looked for, so that a cycle is never
counted twice round.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import ConvergenceError
from ..parameters import FloatArray
from .flows import Onward
from .measures import Course
from .periodic_orbit import Closed, section
from .problem import Problem
from .regimes import SETTLED, Outcome, Regime

#: Returns as close as this, relative to the extent of the motion, are worth a search for the cycle.
CLOSE = 0.05

#: Fewest maxima of x in a window in which a cycle can be seen.
FEWEST = 3

#: A multiplier this close to 1 in size is told neither from a stable nor from an unstable one.
NEUTRAL = 1e-6

#: A multiplier beyond this repels, even if it is known to a digit only.
REPELS = 2.0

#: Cosine between neighbouring steps from which on they go in one direction; distance of the end from which on a drift goes past.
ALIGNED, AWAY = 0.98, 0.5

#: By how much the linearized map may be wrong about a return, relative to the distance at the return before.
MISSED = 0.25

#: Cycles that are looked for, of one motion.
CANDIDATES = 3

#: Multipliers and their vectors.
Modes: TypeAlias = tuple[NDArray[np.complex128], NDArray[np.complex128]]


@dataclass(frozen=True)
class _Cycle:
    """A cycle and the motion beside it: sections in units of ``scale``."""

    orbit: Closed
    onward: Onward
    scale: FloatArray

    @property
    def place(self) -> FloatArray:
        """Its own section."""
        return section(self.orbit.state) / self.scale

    @property
    def slope(self) -> FloatArray:
        """Derivative of the return map there."""
        return self.orbit.slope * self.scale / self.scale[:, None]

    def returned(self, places: FloatArray) -> FloatArray:
        """The return map: where motions from places on the section next meet it, after about a period."""
        states = np.insert(places * self.scale, (places.shape[1] + 1) // 2, 0.0, axis=1)
        courses = self.onward.courses(states, 1.1 * self.orbit.period)
        return np.array([self._next(place, course) for place, course in zip(places, courses, strict=True)])

    def _next(self, place: FloatArray, course: Course) -> FloatArray:
        late = np.flatnonzero(course.maxima_t > 0.5 * self.orbit.period)
        if not len(late):
            raise ConvergenceError("the motion does not come back")
        returns = section(course.maxima[late]) / self.scale
        off = np.abs(returns - place).max(axis=1) + np.abs(course.maxima_t[late] / self.orbit.period - 1)
        found: FloatArray = returns[int(np.argmin(off))]
        return found


def on_cycle(course: Course, problem: Problem, onward: Onward, tol: float) -> Outcome | None:
    """The cycle that the motion is on, or winds onto."""
    if len(course.maxima) < FEWEST:
        return None
    scale = _scale(course)
    states = section(course.maxima) / scale
    for k in _candidates(states):
        period = float(course.maxima_t[-1] - course.maxima_t[-1 - k])
        try:
            orbit = _orbit(onward, course.maxima[-1], period, scale)
        except ConvergenceError:
            continue
        cycle = _Cycle(orbit, onward, scale)
        largest = float(np.abs(np.linalg.eigvals(orbit.slope)).max())
        rounds = max(1, round(k * orbit.period / period))
        off = states[::-1][::rounds] - cycle.place  # latest first
        distance = float(np.abs(off[0]).max())
        if largest >= 1 - NEUTRAL or distance > 4 * CLOSE:
            continue
        try:
            near = _nears(cycle, off, tol)
        except ConvergenceError:
            continue
        if near:
            regime = Regime.LIMIT_CYCLE if distance <= tol else Regime.APPROACHES_CYCLE
            return _described(cycle, regime, -math.log(max(largest, 1e-300)) / orbit.period, distance)
    return None


def _orbit(onward: Onward, state: FloatArray, period: float, scale: FloatArray) -> Closed:
    """The closed orbit near a state; ConvergenceError where there is none, or it is soon seen to be far away or to repel."""
    reach = 4 * CLOSE * float(scale.max())
    place, period, slope = onward.roughly(state, period, reach)
    if np.abs(section(place - state) / scale).max() > 5 * CLOSE or np.abs(np.linalg.eigvals(slope)).max() > REPELS:
        raise ConvergenceError("the closed orbit is too far away, or repels")
    return onward.closed(place, period, reach)


def _scale(course: Course) -> FloatArray:
    """Extents of x, y and y' over all its turning points, those across the belt at least 1 % of that along it."""
    turns = section(np.vstack([course.maxima, course.minima]))
    extent: FloatArray = np.ptp(turns, axis=0)
    scale: FloatArray = np.maximum(extent, 1e-2 * extent[0] + 1e-300)
    return scale


def _candidates(states: FloatArray) -> Iterator[int]:
    """Numbers of returns after which the last states came close to what they had been, and closer each time; fewest first.

    A motion that winds onto a cycle from alternate sides is close after two rounds before it is after one: so divisors are
    tried before the number itself. A multiple of a number that was tried has to be much closer than that.
    """
    tried: list[int] = []

    def apart(k: int) -> float:
        return float(np.abs(states[-1] - states[-1 - k]).max())

    for k in range(1, (len(states) - 1) // 2 + 1):
        last, before = apart(k), float(np.abs(states[-1 - k] - states[-1 - 2 * k]).max())
        if max(last, before) > CLOSE or last > 2 * before + CLOSE**3 or _drifts_past(states[::-1][::k]):
            continue
        for number in (*(j for j in range(1, k) if k % j == 0 and apart(j) <= 4 * CLOSE), k):
            multiple = any(number % j == 0 and apart(number) > 0.5 * apart(j) for j in tried)
            if number not in tried and not multiple and len(tried) < CANDIDATES:
                tried.append(number)
                yield number


def _drifts_past(states: FloatArray) -> bool:
    """Whether states, latest first, go on in one direction by steps that shrink too slowly to end near, or not at all."""
    steps = states[:-1] - states[1:]
    if len(steps) < 3:
        return False
    sizes = np.linalg.norm(steps, axis=1)
    if not sizes.min() > 0 or ((steps[1:] * steps[:-1]).sum(axis=1) < ALIGNED * sizes[1:] * sizes[:-1]).any():
        return False
    shrink = (sizes[0] / sizes[-1]) ** (1 / (len(sizes) - 1))
    return bool(shrink >= 1 or sizes[0] * shrink / (1 - shrink) > AWAY)


def _nears(cycle: _Cycle, off: FloatArray, tol: float) -> bool:
    """Whether the motion is at the cycle, or nears it as the linearized map says and will go on doing so.

    ``off`` is what lacked at its returns, latest first.
    """
    sizes = np.abs(off).max(axis=1)
    if sizes[: max(2, len(sizes) // 2)].max() <= tol:
        return True
    if len(off) < 2 or np.abs(off[0] - cycle.slope @ off[1]).max() > MISSED * sizes[1] + tol:
        return False
    modes = _modes(cycle.slope)
    return _contracted(modes, off, sizes) and _goes_on(cycle, modes, off[0], tol)


def _modes(slope: FloatArray) -> Modes:
    """Multipliers and their vectors; where the vectors nearly coincide, the three coordinates of the section instead."""
    values, vectors = np.linalg.eig(slope)
    return values.astype(complex), (vectors if abs(np.linalg.det(vectors)) > 1e-9 else np.eye(len(vectors))).astype(complex)


def _contracted(modes: Modes, off: FloatArray, sizes: FloatArray) -> bool:
    """Whether what lacks has become smaller at least half as fast as the slowest multiplier says, while it was small."""
    values, vectors = modes
    far = np.flatnonzero(sizes > 4 * CLOSE)
    last = (far[0] if len(far) else len(sizes)) - 1
    if last < 1:
        return False
    now, then = np.linalg.norm(np.linalg.solve(vectors, off[[0, last]].T), axis=0)
    return bool(now <= then * np.abs(values).max() ** (last / 2))


def _goes_on(cycle: _Cycle, modes: Modes, off: FloatArray, tol: float) -> bool:
    """Whether the return map itself contracts wherever its linearization leads, half as fast at least on the average.

    The linearization maps the states none of whose modal parts is larger than the motion's now into themselves, and a motion
    that decays slowly turns through all of them. Motions have neared a cycle at its rate 0.04 of its extent away, and left it.
    """
    values, vectors = modes
    slowest = int(np.argmax(np.abs(values)))
    left = np.abs(np.linalg.solve(vectors, off))[slowest]
    places = np.array(list(_same_size(off, *modes)))
    images = cycle.returned(cycle.place + places) - cycle.place
    missed = np.abs(images - places @ cycle.slope.T).max(axis=1)
    if not (missed <= MISSED * np.abs(places).max(axis=1) + tol).all():
        return False
    growth = [math.log(max(part, tol) / max(left, tol)) for part in np.abs(np.linalg.solve(vectors, images.T))[slowest].tolist()]
    return bool(left <= tol or math.fsum(growth) <= 0.5 * len(growth) * math.log(np.abs(values[slowest])))


def _same_size(off: FloatArray, values: NDArray[np.complex128], vectors: NDArray[np.complex128]) -> Iterator[FloatArray]:
    """Differences whose modal parts have the sizes of those of ``off``: either sign of real ones, eight phases of a pair."""
    parts = np.linalg.solve(vectors, off)
    turns = np.exp(0.25j * np.pi * np.arange(8)) if values.imag.any() else np.ones(1)
    for turn, *signs in itertools.product(turns, *[(1, -1)] * int(np.sum(values.imag == 0))):
        factors = np.where(values.imag > 0, turn, np.conj(turn))
        factors[values.imag == 0] = signs
        yield (vectors @ (factors * parts)).real


def _described(cycle: _Cycle, regime: Regime, rate: float, distance: float) -> Outcome:
    """The outcome, with averages over the cycle's one period, and its state where x is largest."""
    period = cycle.orbit.period
    (course,) = cycle.onward.courses(cycle.orbit.state[None], 1.1 * period)
    row = int(np.argmin(np.abs(course.maxima_t - period)))
    mean, spread = course.moments(row)
    round_once = course.maxima[(course.maxima_t > 1e-3 * period) & (course.maxima_t <= course.maxima_t[row])]
    # Of maxima that agree but for rounding the one highest above the belt, so that a cycle has one such state.
    top = round_once[round_once[:, 0] >= round_once[:, 0].max() - 1e-6 * cycle.scale[0]]
    x, y, vy = _first_two(top[np.argmax(top[:, 1])])
    return Outcome(
        regime, rate=rate, distance=distance, period=period, cycle_mean=mean, cycle_rms=math.hypot(mean, spread),
        cycle_x=x, cycle_y=y, cycle_vy=vy,
    )  # fmt: skip


def _first_two(state: FloatArray) -> tuple[float, float, float]:
    """x, y and y' of a state; NaN for a second coordinate that is not there."""
    n = len(state) // 2
    return (float(state[0]), float(state[1]), float(state[n + 1])) if n > 1 else (float(state[0]), math.nan, math.nan)


def same_orbit(one: Any, other: Any) -> bool:
    """Whether two cycles are one: state where x is largest, period and averages, all found by Newton's method."""
    names = ("cycle_x", "cycle_y", "cycle_vy", "cycle_mean", "cycle_rms")
    reach = max(abs(one.cycle_x - one.cycle_mean), abs(other.cycle_x - other.cycle_mean))
    return abs(one.period / other.period - 1) < SETTLED and all(
        abs(getattr(one, name) - getattr(other, name)) < 10 * SETTLED * reach for name in names
    )
