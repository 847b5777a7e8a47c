"""Growth rates of small deviations along a motion, with their errors, and whether they prove that it is chaotic.

The variational equations are carried along and orthonormalized, Benettin's method, with the flow as the first direction: the
flow carries it into itself exactly, so that its exponent, the trivial one, is known, and the others are those across it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from ..errors import ConvergenceError, ParameterError
from ..models.parameters import FloatArray
from ..motion.shooting import rate
from .system import System

#: Time between two orthonormalizations.
STRETCH = 5.0

#: Deviations of which one is smaller than another by more than this in a stretch are lost in rounding: it is halved.
LOST = 1e-10

#: Most often.
HALVINGS = 12

#: Numbers of equal parts by whose scatter the error is judged: the largest counts, as parts that are too short are correlated.
PARTS = (6, 12, 24)

#: An exponent is told from 0 by this many half-widths of its 95 % interval, some four standard errors.
PROVED = 2.0

#: A motion has settled once the slowest decay has made deviations smaller by exp of this.
SETTLED = 5.0

#: What errors of integration may add to a rate: an exponent below is not told from 0, however little it scatters.
FLOOR = 1e-10

#: Slower than this the flow is no direction: the motion is at rest.
STILL = 1e-9


@dataclass(frozen=True)
class Rates:
    """Growth rates over n equal stretches of motion, each of the time ``stretch``, to the state ``end``.

    ``logs`` (n, m) and ``volumes`` (n,) are logarithms of growth, along the flow, then across it, and of volumes; ``flow``
    (n + 1,) those of the flow's speed between the stretches, −∞ at rest.
    """

    logs: FloatArray
    volumes: FloatArray
    stretch: float
    flow: FloatArray
    end: FloatArray

    def part(self, begin: int, end: int | None = None) -> Rates:
        """Some of the stretches."""
        flow = self.flow[begin : None if end is None else end + 1]
        return Rates(self.logs[begin:end], self.volumes[begin:end], self.stretch, flow, self.end)

    def joined(self, later: Rates) -> Rates:
        """With what follows, in stretches of the same time."""
        return Rates(
            np.vstack([self.logs, later.logs]), np.append(self.volumes, later.volumes), self.stretch,
            np.append(self.flow, later.flow[1:]), later.end,
        )  # fmt: skip

    @property
    def span(self) -> float:
        """Time in all."""
        return len(self.logs) * self.stretch

    @property
    def moves(self) -> bool:
        """Whether the motion is never at rest."""
        return bool((self.flow > math.log(STILL)).all())

    @cached_property
    def exponents(self) -> FloatArray:
        """Means: along the flow, then across it."""
        return self.logs.sum(axis=0) / self.span

    @cached_property
    def error(self) -> FloatArray:
        """Half-widths of 95 % intervals; of the trivial one a bound, the range of the logarithm of the flow's speed."""
        found = half_widths(self.logs, self.stretch)
        if self.moves:
            found[0] = float(np.ptp(self.flow)) / self.span
        return np.maximum(found, FLOOR)

    @property
    def order(self) -> NDArray[np.intp]:
        """Places of the exponents, largest first."""
        return np.argsort(-self.exponents, kind="stable")

    @property
    def trivial(self) -> int:
        """Which one of these, largest first, is the trivial one; −1 at rest."""
        return int(np.flatnonzero(self.order == 0)[0]) if self.moves else -1

    def undecided(self, before: float) -> str:
        """Why these do not prove that the motion is chaotic, or nothing; ``before`` is how long it was followed before."""
        across, error = self.exponents[1:], self.error[1:]
        if not self.moves:
            return "the motion is at rest, or all but"
        open_ = np.flatnonzero(np.abs(across) <= PROVED * error)
        if len(open_):
            worst = open_[int(np.argmax(error[open_] / np.maximum(np.abs(across[open_]), 1e-300)))]
            longer = "a longer motion narrows that as the root of its time; on a torus it stays"
            hope = longer if error[worst] > FLOOR else "errors of integration may be as large"
            return f"an exponent of {across[worst]:.2g} ± {error[worst]:.1g} is not told from 0: {hope}"
        if across.max() < 0:
            return "all exponents but the trivial one are negative: what it nears attracts, and a longer motion may reach it"
        if len(across) == 1:
            return "deviations grow, but the motion of one coordinate is never chaotic: a longer motion tells what it comes to"
        slowest = float(-across[across < 0].max(initial=-np.inf))
        if before * slowest < SETTLED:
            return f"it may not have settled: deviations decay as exp(−{slowest:.2g} τ), followed for {before:g} before"
        middle = len(self.logs) // 2
        halves = [half.logs[:, 1:].sum(axis=0) / half.span for half in (self.part(middle), self.part(0, middle))]
        if (np.abs(halves[0] - halves[1]) > 2 * PROVED * error).any():
            return "exponents of the two halves differ: it has not settled; a longer motion tells"
        return ""


def half_widths(logs: FloatArray, stretch: float) -> FloatArray:
    """Half-widths of 95 % intervals of mean rates: the widest by batch means, and by the range of their sums.

    The range is that of the sums about their straight line: of motions that repeat themselves it stays, and the error falls as
    the time; of irregular ones it grows as its root, as the scatter of means does.
    """
    count, m = logs.shape
    sums = np.vstack([np.zeros(m), np.cumsum(logs, axis=0)])
    line = np.linspace(0, 1, count + 1)[:, None] * sums[-1]
    widest = np.ptp(sums - line, axis=0) / (count * stretch)
    for parts in PARTS:
        if count >= 4 * parts:
            ends = np.linspace(0, count, parts + 1).astype(int)
            means = np.diff(sums[ends], axis=0) / (np.diff(ends) * stretch)[:, None]
            width = student.ppf(0.975, parts - 1) * means.std(axis=0, ddof=1) / math.sqrt(parts)
            widest = np.maximum(widest, width)
    return np.asarray(widest)


def rates_along(system: System, state: FloatArray, span: float) -> Rates:
    """Growth rates along the motion from a state."""
    field, constants = system.field, system.constants
    m, count = field.size, max(16, math.ceil(span / STRETCH))
    stretch = span / count
    logs, volumes, speeds = np.empty((count, m)), np.empty(count), np.empty(count + 1)
    flow = rate(field, state, constants)
    if not np.isfinite(flow).all():
        raise ParameterError(f"start = {np.asarray(state).tolist()}: the motion is not defined there; start anywhere else")

    def carried(state: FloatArray, frame: FloatArray, span: float) -> tuple[FloatArray, FloatArray, FloatArray, float]:
        """State and frame after a while, with the logarithms of growth along the frame and of volumes."""
        flow = rate(field, state, constants)
        passage = system.flow.fly(state, constants, span)
        ahead = passage.by_state @ frame
        if np.linalg.norm(flow) > STILL:  # the flow is carried into itself
            ahead[:, 0] = rate(field, passage.state, constants) / np.linalg.norm(flow)
        turned, triangle = np.linalg.qr(ahead)
        sizes = np.abs(np.diag(triangle))
        if sizes.min() > LOST * sizes.max():
            return passage.state, turned, np.log(sizes), float(np.linalg.slogdet(passage.by_state)[1])
        if span < stretch / 2**HALVINGS:
            raise ConvergenceError(f"small deviations shrink by more than {1 / LOST:g} in {span:g} time units: too stiff")
        middle, frame, first, shrunk = carried(state, frame, span / 2)
        end, frame, second, more = carried(middle, frame, span / 2)
        return end, frame, first + second, shrunk + more

    with np.errstate(divide="ignore"):
        frame, _ = np.linalg.qr(_first(flow))
        speeds[0] = np.log(np.linalg.norm(flow))
        for i in range(count):
            state, frame, logs[i], volumes[i] = carried(state, frame, stretch)
            speeds[i + 1] = np.log(np.linalg.norm(rate(field, state, constants)))
    return Rates(logs, volumes, stretch, speeds, np.asarray(state))


def _first(flow: FloatArray) -> FloatArray:
    """A basis with the flow as the first direction, where there is one."""
    basis = np.eye(len(flow))[:, np.argsort(-np.abs(flow))]
    if np.linalg.norm(flow) > STILL:
        basis[:, 0] = flow
    return basis
