"""The cycle that a motion approaches, by its return map (Poincaré map).

The section is where x is largest; x is the first coordinate that moves on the cycle. For an x that
rotates in one direction the section is where it passes a whole turn, and with a clock where that
does: a motion that friction holds at its largest x does not pass through that. Periodic coordinates
are compared modulo a turn.

:func:`on_cycle` looks for two returns that are close to each other. Shooting (:class:`Onward`) then
computes the closed orbit near them, and its least period, so that a cycle is never counted twice.
The motion is on the cycle, or approaches it, if its last returns converge as the linearized return
map predicts, and if the return map itself contracts at about that rate.
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
from ..numerics.vectors import (
    TURN,
    WholeTurns,
    in_one_turn,
    magnitude,
    state_difference,
)
from . import integrators
from .integrators import Flow
from .measures import MotionStatistics
from .problem import Problem
from .regimes import Outcome, Regime
from .shooting import Iterate, Orbit, closed_orbit, least_period, off_jumps, rests, through
from .solution import Extremum, FlowResult


@dataclass(frozen=True)
class Onward:
    """Continuation of the motion of a problem from any state, by an integrator."""

    problem: Problem
    backend: str

    def with_lead(self, lead: int) -> Onward:
        """The same with another leading coordinate, whose maxima mark the periods."""
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
        """Statistics of the motions from several states over a duration; raises the error of a
        motion that cannot be integrated.
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
        """:meth:`Flow.flow_map` by central differences, without crossings and parameters."""
        step = 1e-5
        m, offsets = state.size, step * np.eye(state.size)
        statistics, *others = self.statistics(
            np.vstack([state, state + offsets, state - offsets]), duration
        )
        ahead, behind = np.split(np.array([other.last for other in others]), 2)
        none, unknown = np.zeros((m, 0)), np.full((m, m), np.nan)
        extrema = [
            Extremum(t, -1, -1, maximum, unknown, none)
            for t, maximum in zip(statistics.maxima_t.tolist(), statistics.maxima, strict=True)
        ]
        # The statistics integrate u = x − x(begin) and u².
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
        """The closed orbit near a state and period, by shooting, and the derivative of its return
        map.

        The section is where component ``fixed`` of the state has the value in ``state``. ``scale``,
        (2 n − 1,), are the sizes of the other components, which bound the distance of the orbit.
        Raises ConvergenceError if there is none.
        """
        reach = 4 * self.problem.options.close * float(scale.max())
        guess = Iterate(state[None], period, ())
        on_section = through(state, np.eye(state.size)[fixed], guess)
        flow = Flow(self.field, self.backend, options=self.problem.options.shooting)
        if self.backend == "compiled":
            # It has no variational equations; differences limit how closely orbits close.
            rtol, closed = min(self.problem.rtol, 1e-12), 1e-9
            fine = replace(self, problem=replace(self.problem, rtol=rtol))
            options = replace(flow.options, last_step=closed, closed=closed)
            flow = replace(flow, other=fine._differences, options=options)
        try:
            orbit = least_period(closed_orbit(flow, guess, on_section, reach=reach))
        except (OverflowError, ValueError) as error:
            raise ConvergenceError("Newton's method left the range of numbers") from error
        if rests(orbit):
            raise ConvergenceError("the orbit is an equilibrium")
        if not self.field.clock and orbit.lead != self.field.lead:
            raise ConvergenceError("another coordinate marks the rounds of the orbit")
        start = orbit.state
        shifted, rates = off_jumps(orbit), orbit.rate(start)
        if shifted is not orbit:  # the field jumps at the start: take the rates before
            rates = orbit.monodromy @ rates
        if rates[fixed] == 0:
            raise ConvergenceError("the orbit does not pass through the section")
        projection = np.eye(start.size)  # along the flow onto the section
        projection[:, fixed] -= rates / rates[fixed]
        projected = orbit.relative @ projection @ orbit.monodromy
        slope = section(section(projected, fixed).T, fixed).T
        largest = magnitude(shifted.multipliers.others)
        return Closed(self, orbit, largest, fixed, scale, slope * scale / scale[:, None])


@dataclass(frozen=True)
class Closed:
    """A closed orbit that begins on a section, on which component ``fixed`` of the state is
    constant.

    ``slope``, (2 n − 1, 2 n − 1), is the derivative of the return map in the other components, each
    in units of its ``scale``. Its eigenvalues are the Floquet multipliers; ``largest`` is the
    largest modulus.
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
        """States (…, 2 n) as points of the section, (…, 2 n − 1), in units of the scale; periodic
        coordinates are shifted by whole turns to the orbit's.
        """
        return (
            section(_near(states, self.state, self.orbit.field.periodic), self.fixed) / self.scale
        )

    def returned(self, places: FloatArray) -> FloatArray:
        """The return map: points of the section, (k, 2 n − 1) in units of the scale, to those at
        which the motions return to it after about a period.
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
    """States without component ``fixed``: for two coordinates and x' = 0 these are x, y, y'."""
    return np.delete(states, fixed, axis=-1)


def _marks(statistics: MotionStatistics, fixed: int) -> tuple[FloatArray, FloatArray]:
    """Times and states at which a motion passes the section: x is largest, or, if ``fixed`` is a
    coordinate, that passes a whole turn.
    """
    if fixed >= len(statistics.last) // 2:
        return statistics.maxima_t, statistics.maxima
    return statistics.passages_t, statistics.passages


def leads(statistics: MotionStatistics, problem: Problem) -> bool:
    """True if the leading coordinate oscillates or rotates, by more than noise, and its range has
    not fallen to less than half during the motion.
    """
    options, (low, high) = problem.options, statistics.reach
    if problem.field.clock and len(statistics.passages) >= options.returns:
        return True
    if high - low <= options.noise * problem.rtol * magnitude(statistics.last):
        return False
    if len(statistics.passages) >= options.returns:
        return True
    if len(statistics.maxima) < options.returns:
        return False
    maxima, minima = statistics.maxima[:, statistics.lead], statistics.minima[:, statistics.lead]
    third = len(maxima) // 3
    first = np.ptp([*maxima[:third], *minima[:third]])
    last = np.ptp([*maxima[-third:], *minima[-third:]])
    return bool(last > first / 2)


def on_cycle(statistics: MotionStatistics, onward: Onward) -> Outcome | None:
    """The outcome of a motion that is on a cycle or approaches one; None for other motions."""
    options, tol = onward.problem.options, onward.problem.options.settled
    field, lead = onward.problem.field, statistics.lead
    periodic, marker = field.periodic, field.marker
    # An x that rotates in one direction has no maxima.
    turning = marker is not None and (
        field.clock is not None or len(statistics.maxima) < options.returns
    )
    fixed = marker if turning and marker is not None else len(statistics.last) // 2 + lead
    times, places = _marks(statistics, fixed)
    if len(times) < options.returns:
        return None
    places = _near(places, periodic.unshifted(in_one_turn(places[-1], periodic)), periodic)
    # The section is x' = 0, or x at a whole number of turns: not always 0, if x turns with another
    # angle.
    places[:, fixed] = TURN * np.round(places[-1, fixed] / TURN) if turning else 0.0
    states = section(places, fixed)
    # Scales: ranges of the components over maxima and minima, at least 1 % of that of x, or of a
    # turn, or of what moves most beside a clock.
    all_places = np.vstack([places, statistics.maxima, statistics.minima])
    ranges = np.ptp(_near(all_places, places[-1], periodic), axis=0)
    if field.clock:  # where x is largest or smallest, it does not move: not there rates range
        n = len(ranges) // 2
        once = 4 / TURN * places[-1, -1]  # back and forth in a turn
        if len(periodic.shifts):  # what drifts may be largest nowhere
            drifting = np.abs(periodic.shifts[:, : n - 1]).max(axis=0) > 0
            covered = np.abs(places[-1, n:-1]) / once
            ranges[: n - 1] = np.maximum(ranges[: n - 1], np.where(drifting, covered, 0.0))
        ranges[n:-1] = np.maximum(ranges[n:-1], once * ranges[: n - 1])
    extent = section(ranges, fixed)
    unit = TURN if turning else extent[lead]
    scale = np.maximum(extent, 1e-2 * (magnitude(extent) if field.clock else unit) + 1e-300)
    states /= scale
    for k in _candidates(states, options.close):
        period = float(times[-1] - times[-1 - k])
        with suppress(ConvergenceError):
            cycle = onward.closed(places[-1], fixed, period, scale)
            largest = cycle.largest
            rounds = max(1, round(k * cycle.orbit.period / period))
            deviations = states[::-1][::rounds] - cycle.scaled(cycle.state)  # latest first
            distance = magnitude(deviations[0])
            # A multiplier of modulus 1 − 1e-6 and more may be of an unstable cycle.
            if largest < 1 - 1e-6 and distance <= 4 * options.close and _nears(cycle, deviations):
                regime = Regime.LIMIT_CYCLE if distance <= tol else Regime.APPROACHES_CYCLE
                rate = -math.log(largest) / cycle.orbit.period if largest else math.inf
                return _described(cycle, regime, rate, distance)
    return None


def _near(states: FloatArray, point: FloatArray, periodic: WholeTurns) -> FloatArray:
    """States with periodic coordinates shifted by whole turns to the nearest of ``point``."""
    return point + state_difference(states, point, periodic)


def _candidates(states: FloatArray, close: float) -> Iterator[int]:
    """Possible numbers of returns in one period of a cycle, smallest first, three at most.

    After such a number the last states are close to the earlier ones, and approach each other. A
    motion that approaches a cycle from alternate sides is close after two returns before it is
    after one: so the divisors of a number are tried before it. A multiple of a number that was
    tried must be much closer than that.
    """
    tried: list[int] = []

    def distance(k: int) -> float:
        return magnitude(states[-1] - states[-1 - k])

    for k in range(1, (len(states) - 1) // 2 + 1):
        last, before = distance(k), magnitude(states[-1 - k] - states[-1 - 2 * k])
        if (
            max(last, before) > close
            or last > 2 * before + close**3
            or _drifts_past(states[::-1][::k])
        ):
            continue
        for number in (*(j for j in range(1, k) if k % j == 0 and distance(j) <= 4 * close), k):
            multiple = any(number % j == 0 and distance(number) > 0.5 * distance(j) for j in tried)
            if number not in tried and not multiple and len(tried) < 3:
                tried.append(number)
                yield number


def _drifts_past(states: FloatArray) -> bool:
    """True if states, latest first, drift in one direction, by steps that do not shrink fast enough
    to end near.
    """
    steps = states[:-1] - states[1:]
    if len(steps) < 3:
        return False
    sizes = np.linalg.norm(steps, axis=1)
    # Steps have one direction if the cosine between neighbours is 0.98 at least.
    if (
        not sizes.min() > 0
        or ((steps[1:] * steps[:-1]).sum(axis=1) < 0.98 * sizes[1:] * sizes[:-1]).any()
    ):
        return False
    ratio = (sizes[0] / sizes[-1]) ** (1 / (len(sizes) - 1))
    # The remaining drift is the sum of a geometric series.
    return bool(ratio >= 1 or sizes[0] * ratio / (1 - ratio) > 0.5)


def _nears(cycle: Closed, deviations: FloatArray) -> bool:
    """True if the motion is on the cycle, or approaches it as the linearized return map predicts
    and will continue to.

    ``deviations`` are those of its returns from the cycle, latest first.
    """
    options, sizes = cycle.onward.problem.options, np.abs(deviations).max(axis=1)
    tol = options.settled
    if sizes[: max(2, len(sizes) // 2)].max() <= tol:
        return True
    if len(deviations) < 2:
        return False
    error = magnitude(deviations[0] - cycle.slope @ deviations[1])
    return error <= options.missed * sizes[1] + tol and _contracts(cycle, deviations[0])


def _contracts(cycle: Closed, deviation: FloatArray) -> bool:
    """True if the return map itself contracts, on average at least at half the logarithmic rate of
    its linearization, for all deviations as large as the present one.

    These are deviations with the same moduli of modal components: a motion that decays slowly
    passes through all of them. The test is needed: motions have approached a cycle at its linear
    rate up to 0.04 of its extent, and then left it.
    """
    options = cycle.onward.problem.options
    tol = options.settled
    values, vectors = np.linalg.eig(cycle.slope)
    if abs(np.linalg.det(vectors)) <= 1e-9:  # nearly defective: use the section's coordinates
        vectors = np.eye(len(vectors))
    slowest = int(np.argmax(np.abs(values)))
    present = np.abs(np.linalg.solve(vectors, deviation))[slowest]
    samples = np.array(list(_same_size(deviation, values, vectors)))
    start = cycle.scaled(cycle.state)
    images = cycle.returned(start + samples) - start
    errors = np.abs(images - samples @ cycle.slope.T).max(axis=1)
    if not (errors <= options.missed * np.abs(samples).max(axis=1) + tol).all():
        return False
    growth = [
        math.log(max(component, tol) / max(present, tol))
        for component in np.abs(np.linalg.solve(vectors, images.T))[slowest].tolist()
    ]
    linear = math.log(max(abs(values[slowest]), tol))
    return bool(present <= tol or math.fsum(growth) <= 0.5 * len(growth) * linear)


def _same_size(
    deviation: FloatArray, values: ComplexArray, vectors: ComplexArray
) -> Iterator[FloatArray]:
    """Deviations whose modal components have the same moduli: both signs of each real mode, eight
    phases of a complex pair.
    """
    components = np.linalg.solve(vectors, deviation)
    phases = np.exp(0.25j * np.pi * np.arange(8)) if values.imag.any() else np.ones(1)
    for phase, *signs in itertools.product(phases, *[(1, -1)] * int(np.sum(values.imag == 0))):
        factors = np.where(values.imag > 0, phase, np.conj(phase))
        factors[values.imag == 0] = signs
        yield (vectors @ (factors * components)).real


def _described(cycle: Closed, regime: Regime, rate: float, distance: float) -> Outcome:
    """The outcome: with averages over one period of the cycle, and its state on the section."""
    orbit, (mean, rms) = cycle.orbit, cycle.orbit.moments()
    state, zero, led = cycle.state, cycle.fixed, orbit
    if orbit.field.clock:
        led = orbit.with_lead()
    if cycle.fixed != led.field.lead and (top := led.top) is not None:
        state, zero = top.state, len(cycle.state) // 2 + led.field.lead
    state = in_one_turn(state, orbit.field.periodic)
    state[zero] = 0.0
    return Outcome(
        regime,
        rate=rate,
        distance=distance,
        period=orbit.period,
        cycle_mean=mean,
        cycle_rms=rms,
        cycle=tuple(state.tolist()),
    )
