"""Lyapunov exponents of a motion: what it is, as far as they, or the attractor that it comes to,
prove it.

The variational equations are carried along and orthonormalized, Benettin's method, with the flow as
the first direction: the flow carries it into itself exactly, so that its exponent, the trivial one,
is known, and the others are those across it.
"""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_number
from ..motion.options import MotionOptions
from ..motion.scales import MotionScales
from ..motion.shooting import rate
from ..motion.simulation import state_of
from ..numerics.interval_arrays import BoolArray, IntArray
from ..numerics.vectors import norm
from ..results.result import Result
from .finding import attractor_exponents
from .system import System, judged


@dataclass(frozen=True, eq=False)
class Lyapunov(Result):
    """Lyapunov exponents of a motion.

    Attributes
    ----------
    exponents : ndarray, shape (m,)
        Largest first, over the second half of the motion; −∞ where it sticks, which ends deviations
        of the sliding speed. There is none of the rate of a clock, which is given: m is then one
        less than a state has numbers.
    error : ndarray, shape (m,)
        Half-widths of their 95 % intervals, by the scatter among parts of that half; of the trivial
        exponent a bound.
    zero : ndarray of bool, shape (m,)
        Whether an exponent is the trivial one, that of the flow's own direction, or is not told
        from 0 by twice its error.
    trivial : int
        Which one is the trivial one; −1 at rest, where there is none.
    trace : float
        Mean divergence of the field, which the exponents add up to.
    t : ndarray, shape (n,)
        Times.
    running : ndarray, shape (n, m)
        The means from the middle of the motion to these times: how they converge.
    kind : str
        "rest", "cycle", "lift-off", "chaotic" or "undecided".
    why : str
        What decides that, or would.
    limit : ndarray, shape (m,)
        Exponents of the equilibrium or cycle that the motion comes to, from its eigenvalues or
        multipliers; NaN where none is found.
    end : ndarray, shape (m,)
        Where the motion ends.
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


@in_usual_state
def lyapunov(
    p: ParameterSet,
    *,
    start: ArrayLike | None = None,
    t_end: float | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> Lyapunov:
    """The Lyapunov exponents of a motion with their errors, and what they prove.

    The first half of the motion is left out. Where the motion comes to an equilibrium or to a
    cycle, the eigenvalues or multipliers of that decide what it is. It is chaotic if an exponent is
    positive, every other one but the trivial one is told from 0, and the motion has settled; else
    it is undecided, and ``why`` says what would decide it.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    start : array_like, optional
        Coordinates, then rates, of the article's model x, y, x', y'; 0 where it is left out.
    t_end : float, optional
        Until when; 4000 times the motion's unit of time where it is left out: 1 over the
        fastest rate, rounded to a power of four, and 1 from 1/32 to 32.
    backend : {"heyoka", "scipy"}, optional
    options : MotionOptions, optional
        Numbers by which exponents are told from 0.
    **values : float, optional
        Parameters in place of those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    Lyapunov

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and parameters that are no scalars.
    ConvergenceError
        Where deviations are lost: the motion is too stiff.

    Notes
    -----
    Source: Benettin's method on (8)–(11), the flow itself as the first direction; where the field
    is continuous its kinks need nothing special. A chaotic transient that lasts longer than the
    motion was followed is not told from a chaotic attractor.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(30))
    >>> found = ss.lyapunov(p, V=0.5, d=4.0, start=(0.1, 0, 0, 0), t_end=2000)
    >>> bool(abs(found.exponents.sum() - found.trace) < 1e-9)
    True
    """
    system = System.of(p, backend, options, **values)
    state = state_of(p.model, start, p=p)
    if t_end is None:
        t_end = system.options.span * system.scales(state).time
    t_end = as_number("t_end", t_end, POSITIVE)
    # It raises at once where the motion can't be followed.
    verdict = judged(system, state, times=(t_end,))
    whole = rates_along(system, state, t_end)
    late = whole.after(len(whole.logs) // 2)
    times = late.interval * np.arange(1, len(late.logs) + 1)
    order = late.order
    zero = np.abs(late.exponents) <= late.options.significance * late.error
    zero[0] |= late.moves
    why = late.undecided(t_end - late.span)
    kind, limit = "undecided" if why else "chaotic", np.full(system.field.deviations, np.nan)
    why = why or "every exponent but the trivial one is told from 0, and one at least is positive"
    if verdict.decided:
        with suppress(
            ConvergenceError
        ):  # an attractor that Newton's method does not find again decides nothing
            kind, limit, _ = attractor_exponents(system, verdict)
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
    """Growth rates over n intervals of motion, all of the time ``span``, to the state ``end``;
    those of one motion are equal.

    ``logs`` (n, m) and ``volumes`` (n,) are logarithms of growth, along the flow, then across it,
    and of volumes; ``flow`` (n + 1,) those of the flow's speed between the intervals, −∞ at rest,
    in units of the motion. ``change`` is the acceleration over the velocity at the end, ``unit``
    the unit of time.
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
        """Rates of the intervals from one on."""
        left = self.logs[begin:]
        return replace(
            self,
            logs=left,
            volumes=self.volumes[begin:],
            span=len(left) * self.interval,
            flow=self.flow[begin:],
        )

    def joined(self, later: Rates) -> Rates:
        """With what follows."""
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
        """Mean time of an interval."""
        return self.span / len(self.logs)

    @property
    def moves(self) -> bool:
        """Whether the motion is never at rest."""
        return bool((self.flow > math.log(self.options.still)).all())

    @cached_property
    def exponents(self) -> FloatArray:
        """Means: along the flow, then across it."""
        return self.logs.sum(axis=0) / self.span

    @property
    def lasting(self) -> FloatArray:
        """Logarithms of growth, 0 of deviations that end."""
        return np.where(np.isneginf(self.exponents), 0.0, self.logs)

    @cached_property
    def error(self) -> FloatArray:
        """Half-widths of 95 % intervals; of the trivial one a bound, the range of the logarithm of
        the flow's speed.
        """
        found = half_widths(self.lasting, self.interval)
        if self.moves:
            found[0] = np.ptp(self.flow) / self.span
        return np.maximum(found, self.options.least_error / self.unit)

    @property
    def order(self) -> IntArray:
        """Places of the exponents, largest first."""
        return np.argsort(-self.exponents, kind="stable")

    @property
    def trivial(self) -> int:
        """Index of the trivial exponent, of exponents in descending order; −1 at rest."""
        return int(self.order.argmin()) if self.moves else -1

    def undecided(self, before: float) -> str:
        """Why these do not prove that the motion is chaotic, or nothing; ``before`` is how long it
        was followed before.
        """
        across, error, options = self.exponents[1:], self.error[1:], self.options
        if not self.moves:
            return "the motion is at rest, or all but"
        early, late = np.array_split(np.diff(self.flow), 2)
        if min(early.min(), late.min()) > 0 and late.sum() > 0.5 * early.sum():
            grown = math.exp(early.sum() + late.sum())
            return f"its speed grows all along, {grown:.3g} times: it runs away, or settles slowly"
        open_ = np.flatnonzero(np.abs(across) <= options.significance * error)
        if len(open_):
            worst = open_[np.argmax(error[open_] / np.maximum(np.abs(across[open_]), 1e-300))]
            longer = "a longer motion narrows that as the root of its time; on a torus it stays"
            hope = (
                longer
                if error[worst] > options.least_error / self.unit
                else "errors of integration may be as large"
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
    """Half-widths of 95 % intervals of mean rates: the widest by batch means, and by the range of
    their sums.

    The range is that of the sums about their straight line: of motions that repeat themselves it
    stays, and the error falls as the time; of irregular ones it grows as its root, as the scatter
    of means does.
    """
    from scipy.stats import t as student  # heavy, and a refusal does not need it

    count, m = logs.shape
    sums = np.vstack([np.zeros(m), np.cumsum(logs, axis=0)])
    line = np.linspace(0, 1, count + 1)[:, None] * sums[-1]
    widest: FloatArray = np.ptp(sums - line, axis=0) / (count * interval)
    # The widest counts, as parts that are too short are correlated.
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
    """Growth rates along the motion from a state; those that are joined have one ``scales``."""
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
    """:func:`rates_along` of a system whose motion has units of order 1."""
    field, constants, options = system.field, system.constants, system.options
    m, count = field.deviations, max(16, math.ceil(span / options.interval))
    interval = span / count
    logs, volumes, states = np.empty((count, m)), np.empty(count), [state]
    flow = rate(field, state, constants)
    # Intervals may be halved this often, all together: one that begins stiffly, or each a little.
    parts, most_parts = 0, 2**12 + 16 * count

    def carried(
        state: FloatArray, frame: FloatArray, span: float
    ) -> tuple[FloatArray, FloatArray, IntArray, FloatArray, float]:
        """State and frame after a while, in another order, with the logarithms of growth along the
        frame and of volumes.
        """
        flow = rate(field, state, constants)
        flow_result = system.flow.flow_map(state, constants, span)
        ahead = flow_result.by_state @ frame
        first = int(norm(flow) > options.still)
        if first:  # the flow is carried into itself
            ahead[:, 0] = rate(field, flow_result.state, constants) / norm(flow)
        order = np.arange(m)
        while True:  # what has ended spans nothing, and comes last from then on
            turned, triangle = np.linalg.qr(ahead[:, order])
            sizes = np.abs(np.diag(triangle))
            lost = sizes <= options.lost * sizes.max()
            if (lost[first:-1] <= lost[first + 1 :]).all():
                break
            order[first:] = order[first:][np.argsort(lost[first:], kind="stable")]
        met = (state, flow_result.state, *(crossing.state for crossing in flow_result.crossings))
        stuck = {border.place for each in met for border in field.stays(system.mode(each))}
        if lost.sum() <= len(stuck):
            sizes[lost] = 0.0  # where it sticks deviations of the sliding speed end
            volume = (
                -math.inf
                if lost.any()
                else float(np.linalg.slogdet(flow_result.by_state[:m, :m])[1])
            )
            return flow_result.state, turned, order, np.log(sizes), volume
        nonlocal parts
        parts += 1
        if parts > most_parts:
            natural = span * field.time
            units = field.scales.states if field.scales else 1.0
            raise ConvergenceError(
                f"small deviations shrink by more than {1 / options.lost:g} in {natural:g} time "
                f"units at {field.place(state * units, '.3g')}: too stiff"
            )
        middle, frame, order, before, shrunk = carried(state, frame, span / 2)
        end, frame, later, behind, more = carried(middle, frame, span / 2)
        return end, frame, order[later], before[later] + behind, shrunk + more

    with np.errstate(divide="ignore"):
        frame = np.eye(field.size)[:, np.argsort(-np.abs(flow[:m]))]
        if norm(flow) > options.still:  # it is the first direction
            frame[:, 0] = flow
        frame, _ = np.linalg.qr(frame)
        for i in range(count):
            state, frame, order, logs[i], volumes[i] = carried(state, frame, interval)
            logs[:i] = logs[:i, order]
            states.append(state)
        speeds = np.log([norm(rate(field, each, constants)) for each in states])
        velocity, acceleration = np.split(rate(field, state, constants), 2)
        velocity = velocity[: m // 2]  # a clock always drifts
        change = float(norm(acceleration) / norm(velocity)) if norm(velocity) else math.inf
    return Rates(logs, volumes, span, speeds, state, change, options=options)
