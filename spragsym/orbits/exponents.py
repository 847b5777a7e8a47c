"""Lyapunov exponents of a motion, with confidence intervals, and whether they show chaos.

Benettin's method: solutions of the variational equations are integrated and orthonormalized by QR
at regular intervals; exponents are means of the logarithms of growth. The first direction is that
of the flow itself. The flow maps it to itself exactly, so its exponent, the trivial one, is known
to be 0, and the other exponents are those of directions across the flow.
"""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from functools import cached_property

import numpy as np

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..core.questions import require_answered
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_number
from ..motion.options import MotionOptions
from ..motion.problem import check_range
from ..motion.scales import MotionScales
from ..motion.shooting import rate
from ..motion.simulation import Start, state_of
from ..numerics.interval_arrays import BoolArray, IntArray
from ..numerics.vectors import magnitude, norm
from ..results.result import Result
from .finding import attractor_exponents, repeats
from .system import System, judged


@dataclass(frozen=True, eq=False)
class Lyapunov(Result):
    """Lyapunov exponents of a motion.

    Attributes
    ----------
    exponents : ndarray, shape (m,)
        Exponents over the second half of the motion, largest first. −∞ if it sticks, which ends
        deviations of the sliding speed. The rate of a clock, which is given, has none: then m is
        one less than the size of a state.
    error : ndarray, shape (m,)
        Half-widths of the 95 % confidence intervals, from the scatter among parts of that half; for
        the trivial exponent a bound.
    zero : ndarray of bool, shape (m,)
        True for the trivial exponent, and for those whose absolute value is at most twice the
        error.
    trivial : int
        Index of the trivial exponent, of the direction along the flow; −1 at rest, where there is
        none.
    trace : float
        Mean divergence of the field, which is the sum of the exponents.
    t : ndarray, shape (n,)
        Times.
    running : ndarray, shape (n, m)
        Means from the middle of the motion to these times, which show the convergence.
    kind : str
        "rest", "cycle", "lift-off", "chaotic" or "undecided".
    why : str
        The evidence for the kind, or what is missing.
    limit : ndarray, shape (m,)
        Exponents of the equilibrium or cycle that the motion approaches, from its eigenvalues or
        multipliers; NaN if none is found.
    end : ndarray, shape (m,)
        Final state of the motion.
    """

    exponents: FloatArray
    error: FloatArray
    zero: BoolArray
    trivial: int
    trace: float
    t: FloatArray
    running: FloatArray
    kind: str
    why: str
    limit: FloatArray
    end: FloatArray

    @property
    def _over(self) -> dict[str, FloatArray]:
        return {"t": self.t[:, None]}


@in_usual_state
def lyapunov(
    p: ParameterSet,
    *,
    start: Start | None = None,
    t_end: float | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> Lyapunov:
    """The Lyapunov exponents of a motion, with errors, and the kind of motion that they show.

    The first half of the motion is ignored. If the motion approaches an equilibrium or a cycle, its
    eigenvalues or multipliers decide the kind. The motion is chaotic if an exponent is positive,
    all others but the trivial one differ from 0, and it has settled. Otherwise it is undecided, and
    ``why`` states what is missing.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    start : array_like or mapping, optional
        Initial state, coordinates, then rates; by default 0.
    t_end : float, optional
        Duration of the motion; by default 4000 times its unit of time, which is 1 over the fastest
        rate, rounded to a power of four, and 1 from 1/32 to 32.
    backend : {"heyoka", "scipy"}, optional
    options : MotionOptions, optional
        Tolerances, also of the comparison with 0.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    Lyapunov

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, and parameters that are not scalars.
    ConvergenceError
        If the motion is so stiff that rounding destroys small deviations.

    Notes
    -----
    Source: Benettin's method for (8)–(11), with the flow as the first direction. Kinks at which the
    field is continuous need no special treatment. A chaotic transient longer than the motion cannot
    be distinguished from a chaotic attractor.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(30))
    >>> found = ss.lyapunov(p, V=0.5, d=4.0, start=(0.1, 0, 0, 0), t_end=2000)
    >>> bool(abs(found.exponents.sum() - found.trace) < 1e-9)
    True
    """
    require_answered("lyapunov", p)
    system = System.of(p, backend, options, **values)
    state = state_of(p.model, start, p=p)
    if t_end is None:
        t_end = system.options.span * system.scales(state).time
    t_end = as_number("t_end", t_end, POSITIVE)
    verdict = judged(system, state, times=system.looks(system.scales(state), t_end))
    whole = rates_along(system, state, t_end)
    late = whole.after(len(whole.logs) // 2)
    times = late.interval * np.arange(1, len(late.logs) + 1)
    order = late.order
    zero = np.abs(late.exponents) <= late.options.significance * late.error
    zero[0] |= late.moves
    why = late.undecided(t_end - late.span) or repeats(system, late.end)
    kind, limit = "undecided" if why else "chaotic", np.full(system.field.deviations, np.nan)
    why = why or "every exponent but the trivial one is told from 0, and one at least is positive"
    if verdict.decided:
        with suppress(ConvergenceError):  # Newton's method may fail to confirm the attractor
            kind, limit, _, _ = attractor_exponents(system, verdict)
            why = f"it comes to {verdict.described()}"
    return Lyapunov(
        late.exponents[order],
        late.error[order],
        zero[order],
        late.trivial,
        float(late.volumes.sum() / late.span),
        np.asarray(t_end - late.span + times),
        (np.cumsum(late.logs, axis=0) / times[:, None])[:, order],
        kind,
        why,
        limit,
        late.end,
    )


@dataclass(frozen=True)
class Rates:
    """Logarithmic growth over n equal intervals of a motion of duration ``span``, which ends in the
    state ``end``.

    ``logs``, (n, m), are the logarithms of growth: first along the flow, then across it.
    ``volumes``, (n,), are those of volumes. ``flow``, (n + 1,), is the logarithm of the flow's
    speed at the ends of the intervals, in units of the motion, −∞ at rest. ``change`` is
    acceleration over velocity at the end, ``unit`` the unit of time.
    """

    logs: FloatArray
    volumes: FloatArray
    span: float
    flow: FloatArray
    end: FloatArray
    change: float = math.inf
    unit: float = 1.0
    options: MotionOptions = attribute(default_factory=MotionOptions)

    def after(self, begin: int) -> Rates:
        """The intervals from index ``begin`` on."""
        logs = self.logs[begin:]
        return replace(
            self,
            logs=logs,
            volumes=self.volumes[begin:],
            span=len(logs) * self.interval,
            flow=self.flow[begin:],
        )

    def joined(self, later: Rates) -> Rates:
        """These intervals followed by later ones."""
        return Rates(
            np.vstack([self.logs, later.logs]),
            np.append(self.volumes, later.volumes),
            self.span + later.span,
            np.append(self.flow, later.flow[1:]),
            later.end,
            later.change,
            self.unit,
            self.options,
        )

    @property
    def interval(self) -> float:
        """Mean duration of an interval."""
        return self.span / len(self.logs)

    @property
    def moves(self) -> bool:
        """True if the motion is never at rest."""
        return bool((self.flow > math.log(self.options.still)).all())

    @cached_property
    def exponents(self) -> FloatArray:
        """Mean growth rates, (m,): along the flow, then across it."""
        return self.logs.sum(axis=0) / self.span

    @property
    def lasting(self) -> FloatArray:
        """The logarithms of growth, with 0 for deviations that sticking ends."""
        return np.where(np.isneginf(self.exponents), 0.0, self.logs)

    @cached_property
    def error(self) -> FloatArray:
        """Half-widths of 95 % confidence intervals, (m,); for the trivial exponent the bound
        (range of the logarithm of the flow's speed) / span.
        """
        found = half_widths(self.lasting, self.interval)
        if self.moves:
            found[0] = np.ptp(self.flow) / self.span
        return np.maximum(found, self.options.least_error / self.unit)

    @property
    def order(self) -> IntArray:
        """Indices that sort the exponents, largest first."""
        return np.argsort(-self.exponents, kind="stable")

    @property
    def trivial(self) -> int:
        """Index of the trivial exponent among the sorted ones; −1 at rest."""
        return int(self.order.argmin()) if self.moves else -1

    def undecided(self, before: float) -> str:
        """Reason for which the exponents do not show chaos; empty if they do.

        ``before`` is the time over which the motion had been followed before.
        """
        across, error, options = self.exponents[1:], self.error[1:], self.options
        if not self.moves:
            return "the motion is at rest, or all but"
        # Of a bounded motion the largest speeds in nine parts do not rise from each to the next.
        highest = [part.max() for part in np.array_split(self.flow, 9)]
        early, late = np.array_split(np.diff(highest), 2)
        if min(early.min(), late.min()) > 0 and late.sum() > 0.5 * early.sum():
            grown = math.exp(early.sum() + late.sum())
            return f"its speed grows all along, {grown:.3g} times: it runs away, or settles slowly"
        open_ = np.flatnonzero(np.abs(across) <= options.significance * error)
        if len(open_):
            worst = open_[np.argmax(error[open_] / np.maximum(np.abs(across[open_]), 1e-300))]
            hope = "errors of integration may be as large"
            least = options.least_error / self.unit
            if len(open_) == len(across) and magnitude(self.volumes) <= least * self.interval:
                hope = (
                    "nothing damps the motion, volumes of states last: it is conservative, and "
                    "comes to nothing; it is periodic or quasi-periodic, unless a longer motion "
                    "tells an exponent from 0"
                )
            elif error[worst] > least:
                hope = (
                    "a longer motion narrows that as the root of its time; of a quasi-periodic "
                    "motion, on a torus, it stays"
                )
            return (
                f"an exponent of {across[worst]:.2g} ± {error[worst]:.1g} is not told from 0: "
                f"{hope}"
            )
        if across.max() < 0:
            attracts = "all exponents but the trivial one are negative: what it nears attracts, "
            if self.change <= options.steady * -across.max():
                return f"{attracts}a steady drift: at constant rates a coordinate grows for ever"
            return f"{attracts}a cycle or a drift, which a longer motion may reach"
        if across.max() <= options.significance * self.error[0]:
            return (
                f"the speed ranges over a factor of {math.exp(np.ptp(self.flow)):.3g}, so that an "
                f"exponent of {across.max():.2g} may be of what grows for ever: a longer motion "
                "tells"
            )
        if len(across) == 1:
            return (
                "deviations grow, but the motion of one coordinate is never chaotic: a longer "
                "motion tells what it comes to"
            )
        slowest = -across[across < 0].max(initial=-np.inf)
        if before * slowest < options.decays:
            return (
                f"it may not have settled: deviations decay as exp(−{slowest:.2g} τ), followed "
                f"for {before:g} before"
            )
        middle = len(self.logs) // 2
        logs = self.lasting[:, 1:]
        early, late = (half.mean(axis=0) / self.interval for half in (logs[:middle], logs[middle:]))
        if (np.abs(late - early) > 2 * options.significance * error).any():
            return "exponents of the two halves differ: it has not settled; a longer motion tells"
        return ""


def half_widths(logs: FloatArray, interval: float) -> FloatArray:
    """Half-widths of 95 % confidence intervals of mean rates, (m,): the largest of several
    estimates.

    Batch means of 6, 12 and 24 parts, with Student's t distribution; the largest counts, because
    parts that are too short are correlated. And the range of the cumulative sums about their
    straight line, over the time: for periodic motions the range is bounded, and the error falls as
    1/time; for irregular ones it grows as the root of time.
    """
    from scipy.stats import t as student  # slow to import

    count, m = logs.shape
    sums = np.vstack([np.zeros(m), np.cumsum(logs, axis=0)])
    line = np.linspace(0, 1, count + 1)[:, None] * sums[-1]
    widest: FloatArray = np.ptp(sums - line, axis=0) / (count * interval)
    for parts in (6, 12, 24):
        if count >= 4 * parts:
            ends = np.linspace(0, count, parts + 1).astype(int)
            means = np.diff(sums[ends], axis=0) / (np.diff(ends) * interval)[:, None]
            width = student.ppf(0.975, parts - 1) * means.std(axis=0, ddof=1) / math.sqrt(parts)
            widest = np.maximum(widest, width)
    return widest


def rates_along(
    system: System, state: FloatArray, span: float, scales: MotionScales | None = None
) -> Rates:
    """Growth along the motion from a state over a time. Results that will be joined need the same
    ``scales``.
    """
    if not np.isfinite(rate(system.field, state, system.constants)).all():
        raise ParameterError(
            f"start = {state.tolist()}: the motion is not defined there; start anywhere else"
        )
    scales = scales or system.scales(state)
    found = _rates_along(system.scaled(scales), state / scales.states, span / scales.time)
    return replace(
        found,
        span=span,
        end=found.end * scales.states,
        change=found.change / scales.time,
        unit=scales.time,
    )


def _rates_along(system: System, state: FloatArray, span: float) -> Rates:
    """:func:`rates_along` of a system in units of its motion."""
    field, constants, options = system.field, system.constants, system.options
    m, count = field.deviations, max(16, math.ceil(span / options.interval))
    interval, units = span / count, field.scales.states if field.scales else 1.0
    logs, volumes, states = np.empty((count, m)), np.empty(count), [state]
    flow = rate(field, state, constants)
    # Limit of the number of halvings: for an initial stiff interval, or a few of each interval.
    halvings, most_halvings = 0, 2**12 + 16 * count

    def carried(
        state: FloatArray, frame: FloatArray, span: float
    ) -> tuple[FloatArray, FloatArray, IntArray, FloatArray, float]:
        """State and orthonormal frame after a time, the new order of the frame's directions, the
        logarithms of growth in this order, and that of volumes. In halves, if rounding would
        destroy the smallest direction.
        """
        flow = rate(field, state, constants)
        flow_result = system.flow.flow_map(state, constants, span)
        ahead = flow_result.by_state @ frame
        first = int(norm(flow) > options.still)
        if first:  # the flow maps its own direction to itself
            ahead[:, 0] = rate(field, flow_result.state, constants) / norm(flow)
        order, spans = np.arange(m), m
        while True:  # directions that sticking has ended come last in QR, from then on
            next_frame, triangle = np.linalg.qr(ahead[:, order])
            sizes = np.abs(np.diag(triangle))
            lost = sizes <= options.lost * sizes.max()
            if not lost[first:spans].any():
                break
            place = first + int(lost[first:spans].argmax())
            order, spans = np.append(np.delete(order, place), order[place]), spans - 1
        passed = (state, flow_result.state, *(each.state for each in flow_result.crossings))
        stuck = {border.place for each in passed for border in field.stays(system.mode(each))}
        if lost.sum() <= len(stuck):
            sizes[lost] = 0.0  # sticking ends deviations of the sliding speed
            volume = -math.inf
            if not lost.any():
                volume = float(np.linalg.slogdet(flow_result.by_state[:m, :m])[1])
            return flow_result.state, next_frame, order, np.log(sizes), volume
        nonlocal halvings
        halvings += 1
        if halvings > most_halvings:
            natural = span * field.time
            raise ConvergenceError(
                f"small deviations shrink by more than {1 / options.lost:g} in {natural:g} time "
                f"units at {field.place(state * units, '.3g')}: too stiff"
            )
        middle, frame, order, logs_1, volume_1 = carried(state, frame, span / 2)
        end, frame, order_2, logs_2, volume_2 = carried(middle, frame, span / 2)
        return end, frame, order[order_2], logs_1[order_2] + logs_2, volume_1 + volume_2

    with np.errstate(divide="ignore"):
        frame = np.eye(field.size)[:, np.argsort(-np.abs(flow[:m]))]
        if norm(flow) > options.still:
            frame[:, 0] = flow
        frame, _ = np.linalg.qr(frame)
        for i in range(count):
            state, frame, order, logs[i], volumes[i] = carried(state, frame, interval)
            check_range(field, state * units, units)
            logs[:i] = logs[:i, order]
            states.append(state)
        speeds = np.log([norm(rate(field, each, constants)) for each in states])
        velocity, acceleration = np.split(rate(field, state, constants), 2)
        velocity = velocity[: m // 2]  # without that of a clock, which always moves
        drifts = norm(velocity) and not system.comes_to_a_border(state)
        change = float(norm(acceleration) / norm(velocity)) if drifts else math.inf
    return Rates(logs, volumes, span, speeds, state, change, options=options)
