"""Cycles: fixed points of a return map, from one largest x to the k-th after it (x' = 0, x″ < 0).

Newton's method from the last return gives the cycle itself, differences of the map its multipliers, and what the
motion still lacks. The smallest k comes first, so that a cycle is never counted twice round.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ConvergenceError
from ..parameters import FloatArray
from .course import Course, Flow
from .problem import Problem
from .regimes import SETTLED, Outcome, Regime

#: Returns as close as this, relative to the extent of the motion, are worth a search for the cycle.
CLOSE = 0.05

#: A multiplier this close to 1 in size is told neither from a stable nor from an unstable one.
NEUTRAL = 1e-4

#: Differences of the return map are not taken over less than this, where the integrator's errors show.
FINEST = 1e-6

#: What the linearized map may miss of a return, relative to what lacked before.
MISSED = 0.25

#: Cycles that are looked for, of one motion.
CANDIDATES = 3


def _section(states: FloatArray) -> FloatArray:
    """States where x' = 0 without that rate: x, y, y' for two coordinates."""
    section: FloatArray = np.delete(states, states.shape[-1] // 2, axis=-1)
    return section


@dataclass(frozen=True)
class _Returns:
    """The return map of a flow about one closed orbit: states x, y, y' where x is largest, in units of ``scale``."""

    flow: Flow
    period: float
    scale: FloatArray
    step: float

    def __call__(self, state: FloatArray) -> tuple[FloatArray, float, Course]:
        """The return after about a period, when it was, and the way there."""
        course = self.flow(np.insert(state * self.scale, (len(state) + 1) // 2, 0.0), 1.1 * self.period)
        late = np.flatnonzero(course.maxima_t > 0.5 * self.period)
        if not len(late):
            raise ConvergenceError("the motion does not come back")
        returns = _section(course.maxima[late]) / self.scale
        off = np.abs(returns - state).max(axis=1) + np.abs(course.maxima_t[late] / self.period - 1)
        best = int(np.argmin(off))
        return returns[best], float(course.maxima_t[late[best]]), course

    def slope(self, state: FloatArray, image: FloatArray | None = None) -> FloatArray:
        """Derivative of the map: by central differences, or by forward ones where the image of the state is given."""
        columns = []
        for h in self.step * np.eye(len(state)):
            back, width = (self(state - h)[0], 2 * self.step) if image is None else (image, self.step)
            columns.append((self(state + h)[0] - back) / width)
        return np.array(columns).T

    def settled_slope(self, state: FloatArray) -> FloatArray:
        """Central differences whose largest multiplier is that over a tenth of the step, which becomes smaller until it is.

        Where the orbit grazes a kink the map has a term in the power 3/2 of the distance: over the usual step its largest
        multiplier came out as 1.09 where it is 0.93.
        """
        slope, step = self.slope(state), self.step / 10
        while step >= FINEST:
            finer = replace(self, step=step).slope(state)
            coarse, fine = (float(np.abs(np.linalg.eigvals(each)).max()) for each in (slope, finer))
            if abs(coarse - fine) <= 0.02 * abs(1 - fine) + 1e-4:
                break
            slope, step = finer, step / 10
        return slope


@dataclass(frozen=True)
class _Cycle:
    """A fixed point of a return map, and the derivative of the map there."""

    state: FloatArray
    period: float
    slope: FloatArray
    course: Course


def on_cycle(course: Course, problem: Problem, flow: Flow, tol: float) -> Outcome | None:
    """The cycle that the motion is on, or winds onto."""
    if len(course.maxima) < 3:
        return None
    scale = _scale(course)
    states = _section(course.maxima) / scale
    for k in _candidates(states):
        period = float(course.maxima_t[-1] - course.maxima_t[-1 - k])
        step = float(np.clip((10 * problem.rtol) ** 0.4, 1e-5, 1e-2))
        try:
            cycle = _newton(_Returns(flow, period, scale, step), states[-1 - k], states[-1])
            if cycle is not None:
                cycle, k = _once_round(cycle, k, flow, scale, step)
        except (ConvergenceError, np.linalg.LinAlgError):
            continue
        if cycle is None:
            continue
        largest = float(np.abs(np.linalg.eigvals(cycle.slope)).max())
        off = states[::-1][::k] - cycle.state  # latest first
        if largest < 1 - NEUTRAL and _nears(cycle, off, _Returns(flow, cycle.period, scale, step), tol):
            distance = float(np.abs(off[0]).max())
            regime = Regime.LIMIT_CYCLE if distance <= tol else Regime.APPROACHES_CYCLE
            return _described(cycle, scale, regime, -math.log(largest) / cycle.period, distance)
    return None


def _scale(course: Course) -> FloatArray:
    """Extents of x, y and y' over all its turning points, those across the belt at least 1 % of that along it."""
    turns = _section(np.vstack([course.maxima, course.minima]))
    extent: FloatArray = np.ptp(turns, axis=0)
    scale: FloatArray = np.maximum(extent, 1e-2 * extent[0] + 1e-300)
    return scale


def _candidates(states: FloatArray) -> Iterator[int]:
    """Numbers of returns after which the last states came close to what they had been, and closer each time; fewest first.

    A motion that winds onto a cycle from alternate sides is close after two rounds before it is after one: so divisors are
    tried before the number itself.
    """
    tried: list[int] = []
    for k in range(1, (len(states) - 1) // 2 + 1):
        last, before = (float(np.abs(states[-1 - i] - states[-1 - i - k]).max()) for i in (0, k))
        if max(last, before) <= CLOSE and last <= 2 * before + CLOSE**3:
            divisors = [j for j in range(1, k) if k % j == 0 and np.abs(states[-1] - states[-1 - j]).max() <= 4 * CLOSE]
            for number in (*divisors, k):
                if number not in tried and len(tried) < CANDIDATES:
                    tried.append(number)
                    yield number


def _newton(returns: _Returns, start: FloatArray, image: FloatArray) -> _Cycle | None:
    """The fixed point near ``start``, whose image is known, by Broyden's method; None where there is none near."""
    state, slope = start, returns.slope(start, image)
    for _ in range(12):
        step = np.linalg.solve(np.eye(len(state)) - slope, image - state)
        if not np.abs(state + step - start).max() < 4 * CLOSE:
            return None
        state, before = state + step, image
        image, period, course = returns(state)
        size = float(np.abs(step).max())
        missed = float(np.abs(image - state).max())
        if missed <= 10 * returns.step**2:
            slope = returns.settled_slope(state)
            # What is missed counts many times over where a multiplier is near 1: once more, with the best slope.
            state = state + np.linalg.solve(np.eye(len(state)) - slope, image - state)
            _, period, course = returns(state)
            return _Cycle(state, period, slope, course)
        if size > returns.step**2:
            slope = slope + np.outer(image - before - slope @ step, step) / (step @ step)
    return None


def _once_round(cycle: _Cycle, k: int, flow: Flow, scale: FloatArray, step: float) -> tuple[_Cycle, int]:
    """The same orbit over its least period, with the number of its largest x."""
    course = cycle.course
    within = (course.maxima_t > 1e-3 * cycle.period) & (course.maxima_t < (1 - 1e-3) * cycle.period)
    states = _section(course.maxima[within]) / scale
    for row in np.flatnonzero(np.abs(states - cycle.state).max(axis=1) <= 1e-4):
        if k % (row + 1) == 0:
            period = float(course.maxima_t[within][row])
            shorter = _newton(_Returns(flow, period, scale, step), cycle.state, states[row])
            if shorter is not None and np.abs(shorter.state - cycle.state).max() <= 1e-4:
                return shorter, int(row) + 1
    return cycle, k


def _nears(cycle: _Cycle, off: FloatArray, returns: _Returns, tol: float) -> bool:
    """Whether the motion is at the cycle, or nears it as the linearized map says and will go on doing so.

    ``off`` is what lacked at its returns, latest first.
    """
    sizes = np.abs(off).max(axis=1)
    if sizes[: max(2, len(sizes) // 2)].max() <= tol:
        return True
    if np.abs(off[0] - cycle.slope @ off[1]).max() > MISSED * sizes[1] + tol:
        return False
    modes = _modes(cycle.slope)
    return _contracted(modes, off, sizes) and _goes_on(returns, cycle, modes, off[0], tol)


def _modes(slope: FloatArray) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Multipliers and their vectors; the three directions themselves where the vectors tell nothing apart."""
    values, vectors = np.linalg.eig(slope)
    return values.astype(complex), (vectors if abs(np.linalg.det(vectors)) > 1e-9 else np.eye(len(vectors))).astype(complex)


def _contracted(modes: tuple[NDArray[np.complex128], NDArray[np.complex128]], off: FloatArray, sizes: FloatArray) -> bool:
    """Whether what lacks has become smaller at least half as fast as the slowest multiplier says, while it was small."""
    values, vectors = modes
    far = np.flatnonzero(sizes > 4 * CLOSE)
    last = (far[0] if len(far) else len(sizes)) - 1
    if last < 1:
        return False
    now, then = np.linalg.norm(np.linalg.solve(vectors, off[[0, last]].T), axis=0)
    return bool(now <= then * np.abs(values).max() ** (last / 2))


def _goes_on(
    returns: _Returns, cycle: _Cycle, modes: tuple[NDArray[np.complex128], NDArray[np.complex128]], off: FloatArray, tol: float
) -> bool:
    """Whether the return map itself contracts wherever its linearization leads, half as fast at least on the average.

    The linearization maps the states none of whose modal parts is larger than the motion's now into themselves, and a motion
    that decays slowly turns through all of them. Motions have neared a cycle at its rate 0.04 of its extent away, and left it.
    """
    values, vectors = modes
    slowest = int(np.argmax(np.abs(values)))
    left = np.abs(np.linalg.solve(vectors, off))[slowest]
    growth = []
    for place in _same_size(off, *modes):
        image = returns(cycle.state + place)[0] - cycle.state
        if not np.abs(image - cycle.slope @ place).max() <= MISSED * np.abs(place).max() + tol:
            return False
        growth.append(math.log(max(np.abs(np.linalg.solve(vectors, image))[slowest], tol) / max(left, tol)))
    return left <= tol or math.fsum(growth) <= 0.5 * len(growth) * math.log(np.abs(values[slowest]))


def _same_size(off: FloatArray, values: NDArray[np.complex128], vectors: NDArray[np.complex128]) -> Iterator[FloatArray]:
    """Differences whose modal parts have the sizes of those of ``off``: either sign of real ones, eight phases of a pair."""
    parts = np.linalg.solve(vectors, off)
    turns = np.exp(0.25j * np.pi * np.arange(8)) if values.imag.any() else np.ones(1)
    for turn, *signs in itertools.product(turns, *[(1, -1)] * int(np.sum(values.imag == 0))):
        factors = np.where(values.imag > 0, turn, np.conj(turn))
        factors[values.imag == 0] = signs
        yield (vectors @ (factors * parts)).real


def _described(cycle: _Cycle, scale: FloatArray, regime: Regime, rate: float, distance: float) -> Outcome:
    """The outcome, with averages over the cycle's one period, and its state where x is largest."""
    course = cycle.course
    row = int(np.argmin(np.abs(course.maxima_t - cycle.period)))
    mean, spread = course.moments(row)
    round_once = course.maxima[(course.maxima_t > 1e-3 * cycle.period) & (course.maxima_t <= course.maxima_t[row])]
    # Of maxima that agree but for rounding the one highest above the belt, so that a cycle has one such state.
    top = round_once[round_once[:, 0] >= round_once[:, 0].max() - 1e-6 * scale[0]]
    x, y, vy = _first_two(top[np.argmax(top[:, 1])])
    return Outcome(
        regime, rate=rate, distance=distance, period=cycle.period, cycle_mean=mean, cycle_rms=math.hypot(mean, spread),
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
