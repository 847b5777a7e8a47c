"""Cycles: what a motion winds onto, by the closed orbit itself and its multipliers, and whether it
nears it at that rate.

Newton's method with the derivative of the flow (:class:`Onward`) gives the cycle from two states
that are alike, where x is largest, the first coordinate that moves on the cycle, or of an x that
turns around and never back, where it passes 0.
Coordinates that come around are alike after a turn. Of several numbers of rounds the smallest comes
first, and the least period is looked for, so that a cycle is never counted twice.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import FELT_EXPONENT, Field
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import ComplexArray
from ..numerics.vectors import TURN, WholeTurns, apart, in_one_turn, magnitude, makes_turns
from . import integrators
from .integrators import Flow
from .measures import MotionStatistics
from .problem import Problem
from .regimes import Outcome, Regime
from .shooting import Iterate, Orbit, closed_orbit, least_period, off_jumps, through
from .solution import Extremum, FlowResult


@dataclass(frozen=True)
class Onward:
    """Continuation of the motion of a problem from any state, by an integrator."""

    problem: Problem
    backend: str

    def with_lead(self, lead: int) -> Onward:
        """The motion with rounds marked by another coordinate."""
        field_of = self.problem.field_of
        return replace(
            self,
            problem=replace(self.problem, field_of=lambda reach: field_of(reach).with_lead(lead)),
        )

    @property
    def field(self) -> Field:
        """The field of the motion, with its own constants."""
        return replace(
            self.problem.field_of(FELT_EXPONENT), constants=lambda *_: self.problem.constants
        )

    def statistics(self, states: FloatArray, duration: float) -> list[MotionStatistics]:
        """Measures on the way from each of many states; an error where one of them cannot be
        continued.
        """
        motions = [
            replace(self.problem, start=tuple(state), t_end=duration, t_record=0.0)
            for state in states.tolist()
        ]
        measured = list[MotionStatistics]()
        for each in integrators.measure(motions, self.backend):
            if isinstance(each, Exception):
                raise each
            measured.append(each)
        return measured

    def _differences(self, state: FloatArray, _: object, duration: float, __: object) -> FlowResult:
        """``flow_map`` by differences of the plain flow; crossings are not reported."""
        # Differences of a flow are taken over this.
        step = 1e-5
        m, off = state.size, step * np.eye(state.size)
        statistics, *others = self.statistics(
            np.vstack([state, state + off, state - off]), duration
        )
        ahead, behind = np.split(np.array([other.last for other in others]), 2)
        none, unknown = np.zeros((m, 0)), np.full((m, m), np.nan)
        extrema = [
            Extremum(t, -1, -1, top, unknown, none)
            for t, top in zip(statistics.maxima_t.tolist(), statistics.maxima, strict=True)
        ]
        begin, (shift, square, *_) = float(state[0]), statistics.integrals.tolist()
        integrals = shift + begin * duration, square + begin * (2 * shift + begin * duration)
        return FlowResult(
            statistics.last,
            (ahead - behind).T / (2 * step),
            none,
            (),
            tuple(extrema),
            integrals,
        )

    def closed(self, state: FloatArray, fixed: int, period: float, scale: FloatArray) -> Closed:
        """The closed orbit to all digits, with the derivative of its return; ConvergenceError
        without one near, in ``scale``.
        """
        reach = 4 * self.problem.options.close * float(scale.max())
        guess = Iterate(state[None], period, ())
        on_section = through(state, np.eye(state.size)[fixed], guess)
        flow = Flow(self.field, self.backend, options=self.problem.options.shooting)
        if self.backend == "compiled":
            # Tolerance of its plain flow, and how closely orbits close by differences of that.
            rtol, closed = min(self.problem.rtol, 1e-12), 1e-9
            fine = replace(self, problem=replace(self.problem, rtol=rtol))
            options = replace(flow.options, last_step=closed, closed=closed)
            flow = replace(flow, other=fine._differences, options=options)
        try:
            orbit = least_period(closed_orbit(flow, guess, on_section, reach=reach))
        except (OverflowError, ValueError) as error:
            raise ConvergenceError("Newton's method left the range of numbers") from error
        if orbit.lead != self.field.lead:
            raise ConvergenceError("another coordinate marks the rounds of the orbit")
        start = orbit.state
        aside, speeds = off_jumps(orbit), orbit.rate(start)
        if aside is not orbit:  # as it arrives there
            speeds = orbit.monodromy @ speeds
        if speeds[fixed] == 0:
            raise ConvergenceError("the orbit does not pass through the section")
        back = np.eye(start.size)
        back[:, fixed] -= speeds / speeds[fixed]  # along the flow to the section again
        slope = section(section(back @ orbit.monodromy, fixed).T, fixed).T
        largest = magnitude(aside.multipliers.others)
        return Closed(self, orbit, largest, fixed, scale, slope * scale / scale[:, None])


@dataclass(frozen=True)
class Closed:
    """A closed orbit that begins on a section, all over which the number at the place ``fixed`` has
    one value.

    The ``slope``, (2 n − 1, 2 n − 1), is the derivative of the return map in the other numbers,
    each in units of its ``scale``. Its eigenvalues are the multipliers, of which ``largest`` is the
    size of the largest.
    """

    onward: Onward
    orbit: Orbit
    largest: float
    fixed: int
    scale: FloatArray
    slope: FloatArray

    @property
    def state(self) -> FloatArray:
        """Initial state of the orbit."""
        return self.orbit.state

    def scaled(self, states: FloatArray) -> FloatArray:
        """States of the section, its own or others, in whole turns near, in units of the scale."""
        return (
            section(_near(states, self.state, self.orbit.field.periodic), self.fixed) / self.scale
        )

    def returned(self, places: FloatArray) -> FloatArray:
        """The return map: where motions from places on the section next meet it, after about a
        period.
        """
        states = np.insert(places * self.scale, self.fixed, self.state[self.fixed], axis=1)
        statistics = self.onward.statistics(states, 1.1 * self.orbit.period)
        return np.array(
            [
                self._next(point, statistics)
                for point, statistics in zip(places, statistics, strict=True)
            ]
        )

    def _next(self, point: FloatArray, statistics: MotionStatistics) -> FloatArray:
        times, states = _marks(statistics, self.fixed)
        late = np.flatnonzero(times > 0.5 * self.orbit.period)
        if not len(late):
            raise ConvergenceError(
                "no cycle: the motion does not return to its section; start elsewhere"
            )
        returns = self.scaled(states[late])
        off = np.abs(returns - point).max(axis=1) + np.abs(times[late] / self.orbit.period - 1)
        return returns[int(np.argmin(off))]


def section(states: FloatArray, fixed: int) -> FloatArray:
    """States of a section without the number that is ``fixed`` there: x, y, y' for two coordinates
    where x' = 0.
    """
    return np.delete(states, fixed, axis=-1)


def _marks(statistics: MotionStatistics, fixed: int) -> tuple[FloatArray, FloatArray]:
    """Times and states of the passages of a section: where x is largest, or passes a whole turn."""
    if fixed != statistics.lead:
        return statistics.maxima_t, statistics.maxima
    return statistics.passages_t, statistics.passages


def leads(statistics: MotionStatistics, problem: Problem) -> bool:
    """Whether rounds of a motion may be seen where its leading coordinate is largest: it moves, and
    has not all but ceased to.
    """
    options, (low, high) = problem.options, statistics.reach
    if high - low <= options.noise * problem.rtol * magnitude(statistics.last):
        return False
    if len(statistics.passages) >= options.returns:
        return True
    if len(statistics.maxima) < options.returns:
        return False
    tops, lows = (each[:, statistics.lead] for each in (statistics.maxima, statistics.minima))
    third = len(tops) // 3
    first, last = np.ptp([*tops[:third], *lows[:third]]), np.ptp([*tops[-third:], *lows[-third:]])
    return bool(last > first / 2)


def on_cycle(statistics: MotionStatistics, onward: Onward) -> Outcome | None:
    """The cycle that the motion is on, or winds onto."""
    options, tol = onward.problem.options, onward.problem.options.settled
    periodic, lead = onward.problem.field.periodic, statistics.lead
    # An x that turns around and never back has no maxima.
    turning = len(statistics.maxima) < options.returns and makes_turns(lead, periodic)
    fixed = lead if turning else len(statistics.last) // 2 + lead
    times, places = _marks(statistics, fixed)
    if len(times) < options.returns:
        return None
    places = _near(places, in_one_turn(places[-1], periodic), periodic)
    # A section is at x' = 0, or at a whole number of turns, which need not be the first one of an
    # x that turns with another angle.
    places[:, fixed] = TURN * np.round(places[-1, fixed] / TURN) if turning else 0.0
    states = section(places, fixed)
    # Extents of x, y and y' over all turning points; those across the belt count as 1 % of that
    # along it, or of a turn, at least.
    extent = np.ptp(
        section(_near(np.vstack([places, statistics.minima]), places[-1], periodic), fixed), axis=0
    )
    scale = np.maximum(extent, 1e-2 * (TURN if turning else extent[lead]) + 1e-300)
    states /= scale
    for k in _candidates(states, options.close):
        period = float(times[-1] - times[-1 - k])
        with suppress(ConvergenceError):
            cycle = onward.closed(places[-1], fixed, period, scale)
            largest = cycle.largest
            rounds = max(1, round(k * cycle.orbit.period / period))
            off = states[::-1][::rounds] - cycle.scaled(cycle.state)  # latest first
            distance = magnitude(off[0])
            # A multiplier this close to 1 in size is told neither from a stable nor
            # from an unstable one.
            if largest < 1 - 1e-6 and distance <= 4 * options.close and _nears(cycle, off):
                regime = Regime.LIMIT_CYCLE if distance <= tol else Regime.APPROACHES_CYCLE
                rate = -math.log(largest) / cycle.orbit.period if largest else math.inf
                return _described(cycle, regime, rate, distance)
    return None


def _near(states: FloatArray, point: FloatArray, periodic: WholeTurns) -> FloatArray:
    """States with periodic coordinates shifted by whole turns nearer to a place."""
    return point + apart(states, point, periodic)


def _candidates(states: FloatArray, close: float) -> Iterator[int]:
    """Numbers of returns after which the last states came close to what they had been, and closer
    each time; fewest first.

    A motion that winds onto a cycle from alternate sides is close after two rounds before it is
    after one: so divisors are tried before the number itself. A multiple of a number that was tried
    has to be much closer than that.
    """
    tried: list[int] = []

    def apart(k: int) -> float:
        return magnitude(states[-1] - states[-1 - k])

    for k in range(1, (len(states) - 1) // 2 + 1):
        last, before = apart(k), magnitude(states[-1 - k] - states[-1 - 2 * k])
        if (
            max(last, before) > close
            or last > 2 * before + close**3
            or _drifts_past(states[::-1][::k])
        ):
            continue
        for number in (*(j for j in range(1, k) if k % j == 0 and apart(j) <= 4 * close), k):
            multiple = any(number % j == 0 and apart(number) > 0.5 * apart(j) for j in tried)
            # Cycles that are looked for, of one motion.
            if number not in tried and not multiple and len(tried) < 3:
                tried.append(number)
                yield number


def _drifts_past(states: FloatArray) -> bool:
    """Whether states, latest first, go on in one direction by steps that shrink too slowly to end
    near, or not at all.
    """
    steps = states[:-1] - states[1:]
    if len(steps) < 3:
        return False
    sizes = np.linalg.norm(steps, axis=1)
    # Least cosine between neighbouring steps that go in one direction.
    if (
        not sizes.min() > 0
        or ((steps[1:] * steps[:-1]).sum(axis=1) < 0.98 * sizes[1:] * sizes[:-1]).any()
    ):
        return False
    shrink = (sizes[0] / sizes[-1]) ** (1 / (len(sizes) - 1))
    # A drift whose end is farther than this goes past what is near.
    return bool(shrink >= 1 or sizes[0] * shrink / (1 - shrink) > 0.5)


def _nears(cycle: Closed, off: FloatArray) -> bool:
    """Whether the motion is at the cycle, or nears it as the linearized map says and will go on
    doing so.

    ``off`` is what lacked at its returns, latest first.
    """
    options, sizes = cycle.onward.problem.options, np.abs(off).max(axis=1)
    tol = options.settled
    if sizes[: max(2, len(sizes) // 2)].max() <= tol:
        return True
    if len(off) < 2 or magnitude(off[0] - cycle.slope @ off[1]) > options.missed * sizes[1] + tol:
        return False
    return _goes_on(cycle, off[0])


def _goes_on(cycle: Closed, off: FloatArray) -> bool:
    """Whether the return map itself contracts wherever its linearization leads, half as fast at
    least on the average.

    The linearization maps the states none of whose modal parts is larger than the motion's now into
    themselves, and a motion that decays slowly turns through all of them. Motions have neared a
    cycle at its rate 0.04 of its extent away, and left it.
    """
    options = cycle.onward.problem.options
    tol = options.settled
    values, vectors = np.linalg.eig(cycle.slope)
    if (
        abs(np.linalg.det(vectors)) <= 1e-9
    ):  # they nearly coincide: the coordinates of the section instead
        vectors = np.eye(len(vectors))
    slowest = int(np.argmax(np.abs(values)))
    left = np.abs(np.linalg.solve(vectors, off))[slowest]
    places = np.array(list(_same_size(off, values, vectors)))
    start = cycle.scaled(cycle.state)
    images = cycle.returned(start + places) - start
    missed = np.abs(images - places @ cycle.slope.T).max(axis=1)
    if not (missed <= options.missed * np.abs(places).max(axis=1) + tol).all():
        return False
    growth = [
        math.log(max(part, tol) / max(left, tol))
        for part in np.abs(np.linalg.solve(vectors, images.T))[slowest].tolist()
    ]
    slowest_rate = math.log(max(abs(values[slowest]), tol))
    return bool(left <= tol or math.fsum(growth) <= 0.5 * len(growth) * slowest_rate)


def _same_size(
    off: FloatArray, values: ComplexArray, vectors: ComplexArray
) -> Iterator[FloatArray]:
    """Differences whose modal parts have the sizes of those of ``off``: either sign of real ones,
    eight phases of a pair.
    """
    parts = np.linalg.solve(vectors, off)
    turns = np.exp(0.25j * np.pi * np.arange(8)) if values.imag.any() else np.ones(1)
    for turn, *signs in itertools.product(turns, *[(1, -1)] * int(np.sum(values.imag == 0))):
        factors = np.where(values.imag > 0, turn, np.conj(turn))
        factors[values.imag == 0] = signs
        yield (vectors @ (factors * parts)).real


def _described(cycle: Closed, regime: Regime, rate: float, distance: float) -> Outcome:
    """The outcome, with averages over the cycle's one period, and the state of the cycle that
    stands for it.
    """
    orbit, (mean, rms) = cycle.orbit, cycle.orbit.moments()
    turning, top = cycle.fixed == orbit.field.lead, orbit.top
    state = cycle.state if turning or top is None else top.state
    state = in_one_turn(state, orbit.field.periodic)
    state[cycle.fixed] = 0.0
    return Outcome(
        regime,
        rate=rate,
        distance=distance,
        period=orbit.period,
        cycle_mean=mean,
        cycle_rms=rms,
        cycle=tuple(state.tolist()),
    )
