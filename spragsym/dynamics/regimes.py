"""What a motion comes to: one classifier for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look:

- **Cycles** are fixed points of a return map, from one largest x to the k-th after it (x' = 0, x″ < 0). Newton's
  method from the last return gives the cycle itself, differences of the map its multipliers, and what the motion
  still lacks. The smallest k comes first, so that a cycle is never counted twice round.
- **Equilibria** are those at μ(V), (10), linearized with the damping of the friction law.
- **Lift-off** is for good in a well of the energy, which nothing changes without contact.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import IntEnum
from types import SimpleNamespace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..errors import ConvergenceError
from ..generated import motion
from ..parameters import NAMES, FloatArray, Parameters
from .integrators import Course, Event, Problem

__all__ = ["Outcome", "Regime", "classify"]

#: A motion has settled when what is left to its limit is this share of its reach; for rest, of L_0.
SETTLED = 1e-4

#: Returns as close as this, relative to the extent of the motion, are worth a search for the cycle.
CLOSE = 0.05

#: A multiplier this close to 1 in size is told neither from a stable nor from an unstable one.
NEUTRAL = 1e-4

#: Cycles that are looked for, of one motion.
CANDIDATES = 3

#: Largest x in a window below which a decay is not read off it.
FEW = 8

#: Runs the motion on from a state for a while.
Flow: TypeAlias = Callable[[FloatArray, float], Course]

#: x, y, y' where x' = 0 on the way down.
SECTION = [0, 1, 3]


class Regime(IntEnum):
    """What a motion settles to, or approaches."""

    FAILED = 0
    """There is no result; the reason says why."""
    EQUILIBRIUM = 1
    """Rests at a steady-sliding equilibrium that attracts it, or that does not repel it where nothing damps."""
    LIMIT_CYCLE = 2
    """Repeats itself on a cycle that attracts it."""
    LIFT_OFF = 3
    """Has no contact with the belt, and too little energy ever to come back to it."""
    UNSETTLED = 4
    """None of these, and none that it is seen to approach: a long transient, quasi-periodic or irregular."""
    APPROACHES_EQUILIBRIUM = 5
    """Decays to an equilibrium at the rate of the linearization there, and is still on its way."""
    APPROACHES_CYCLE = 6
    """Winds onto a cycle at the rate of the cycle's multipliers, and is still on its way."""


#: The attractor behind a regime.
ATTRACTOR = {
    Regime.APPROACHES_EQUILIBRIUM: Regime.EQUILIBRIUM,
    Regime.APPROACHES_CYCLE: Regime.LIMIT_CYCLE,
}


@dataclass(frozen=True)
class Outcome(Result):
    """What a motion comes to.

    Attributes
    ----------
    regime : Regime
    equilibrium : int
        For EQUILIBRIUM and APPROACHES_EQUILIBRIUM its index among ``equilibria(p)`` at the friction μ(V); −1 otherwise.
    rest_x, rest_y : float
        Where that equilibrium is; NaN otherwise.
    rate : float
        Of the approach in the long run, exp(−rate τ), from the limit's own eigenvalues or multipliers. NaN where there is none.
    distance : float
        What is left to the limit when the motion ends: relative to the motion's reach for a cycle, in L_0 for rest.
    period, cycle_mean, cycle_rms : float
        Of the cycle itself: period, mean of x, and root mean square of x about zero over one whole period. NaN for no cycle.
    cycle_x, cycle_y, cycle_vy : float
        The cycle's state where its x is largest (there x' = 0): one point, which with the equations is the whole orbit.
    """

    regime: Regime = Regime.UNSETTLED
    equilibrium: int = -1
    rest_x: float = np.nan
    rest_y: float = np.nan
    rate: float = np.nan
    distance: float = np.nan
    period: float = np.nan
    cycle_mean: float = np.nan
    cycle_rms: float = np.nan
    cycle_x: float = np.nan
    cycle_y: float = np.nan
    cycle_vy: float = np.nan


    @property
    def cycle_spread(self) -> float:
        """Root mean square of x about its mean over one period."""
        return float(np.sqrt(max(self.cycle_rms**2 - self.cycle_mean**2, 0.0))) if self.period > 0 else float("nan")


def classify(course: Course, problem: Problem, flow: Flow, tol: float = SETTLED) -> Outcome:
    """The outcome of a motion, from what was measured of it.

    Parameters
    ----------
    course : Course
        The motion after its transient.
    problem : Problem
        Its constants and tolerance.
    flow : callable
        ``flow(state, duration)`` goes on from any state, and gives the Course.
    tol : float
        What may be left to the limit of a settled motion.

    Returns
    -------
    Outcome
        Without ``equilibrium``, which :func:`index_of` finds for many at once.
    """
    if _lifted_for_good(course, problem):
        return Outcome(Regime.LIFT_OFF)
    return _rest(course, problem, tol) or _periodic(course, problem, flow, tol) or Outcome()


# ---------------------------------------------------------------------------------------------------- lift-off


def _lifted_for_good(course: Course, problem: Problem) -> bool:
    """Whether the mass is in a well of the energy above the belt that it has too little energy to leave.

    Without contact nothing changes the energy U + kinetic. About a stable equilibrium in lift-off the region of less energy
    than any higher stationary value of U has no way out and does not reach the belt: such values are at the other equilibria in
    lift-off, along the belt's surface y = 0, and at the spring's anchor. Weak preload has no such well, and brings the mass back.
    """
    if course.last[1] <= 0 or course.events[[Event.CONTACT_LOST, Event.CONTACT_REGAINED]].any():
        return False
    from ..statics.solver import Stability, equilibria

    found = equilibria(parameters(problem), contact=False)
    there = np.isfinite(found.x)
    x, y = found.x[there], found.y[there]
    surface = _stationary_on_the_surface(problem)
    anchor = np.array([problem.cos0]), np.array([problem.sin0])
    levels = [_potential(problem, *places) for places in ((x, y), (surface, np.zeros_like(surface)), anchor)]
    values = np.concatenate(levels)
    energy = float(_potential(problem, *course.last[:2]) + (course.last[2:] ** 2).sum() / 2)
    for row in np.flatnonzero(found.stability[there] == Stability.STABLE):
        brim = float(values[values > values[row] + 1e-12].min())
        if energy < brim and _highest_between(problem, course.last[:2], np.array([x[row], y[row]])) < brim:
            return True
    return False


def _potential(problem: Problem, x: Any, y: Any) -> Any:
    """Energy at rest, without contact."""
    p, still = problem, np.zeros_like(x)
    return motion.energy(x, y, still, still, p.cos0, p.sin0, p.kappa, p.alpha, p.sigma, p.beta, 0)


def _stationary_on_the_surface(problem: Problem) -> FloatArray:
    """All x where the potential energy at y = 0 is stationary.

    With u = cos θ₀ − x its slope is 0 where (α cos θ₀ − (α + σ) u) L = −σ u; squared, a quartic in u. A value too many only
    lowers the brim, so that complex roots, which may be double ones, stay by their real parts.
    """
    a, b, s2 = problem.alpha * problem.cos0, problem.alpha + problem.sigma, problem.sin0**2
    roots = np.roots([b * b, -2 * a * b, a * a + b * b * s2 - problem.sigma**2, -2 * a * b * s2, a * a * s2])
    stationary: FloatArray = problem.cos0 - np.append(roots.real, 0.0)
    return stationary


def _highest_between(problem: Problem, begin: FloatArray, end: FloatArray) -> float:
    """A bound on the potential energy along the straight way: values on it, and the steepest slope between them."""
    n = 200
    (x, y), length = np.linspace(begin, end, n + 1).T, float(np.hypot(*(end - begin)))
    stretch = np.abs(np.hypot(problem.cos0 - x[[0, -1]], problem.sin0 - y[[0, -1]]) - 1).max()
    slope = problem.alpha * np.abs(x).max() + problem.beta * np.abs(y).max() + problem.kappa + problem.sigma * max(1.0, stretch)
    return float(_potential(problem, x, y).max() + slope * length / (2 * n))


# ------------------------------------------------------------------------------------------------------- rest


def parameters(problem: Problem) -> Parameters:
    """Those of a problem, which holds θ₀ by its cosine and sine."""
    p = problem
    return Parameters(
        theta0=np.arctan2(p.sin0, p.cos0), mu0=p.mu0, kappa=p.kappa, alpha=p.alpha, sigma=p.sigma, beta=p.beta
    )


@dataclass(frozen=True)
class Rest:
    """A steady-sliding equilibrium and its linearization with the damping of the friction law."""

    state: FloatArray
    values: NDArray[np.complex128]
    vectors: NDArray[np.complex128]


def rest_near(problem: Problem, x: float, y: float) -> Rest | None:
    """The equilibrium in contact that Newton's method finds from x, y, at the friction μ(V); None where it finds none."""
    constants = (*problem.constants, 1, 1)
    for _ in range(30):
        ax, ay = _RHS(x, y, 0.0, 0.0, *constants, xp=_FLOATS)
        (xx, xy, xv, _), (yx, yy, _, _) = _JACOBIAN(x, y, 0.0, 0.0, *constants, xp=_FLOATS)
        determinant = xx * yy - xy * yx
        if determinant == 0:
            return None
        dx, dy = (xy * ay - yy * ax) / determinant, (yx * ax - xx * ay) / determinant
        x, y = x + dx, y + dy
        if not abs(x) + abs(y) < _FAR:
            return None
        if abs(dx) + abs(dy) <= 1e-12:
            break
    else:
        return None
    if y > 0:
        return None
    jacobian = np.array([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [xx, xy, xv, 0.0], [yx, yy, 0.0, 0.0]])
    return Rest(np.array([x, y, 0.0, 0.0]), *np.linalg.eig(jacobian))


_RHS, _JACOBIAN = (inspect.unwrap(function) for function in (motion.regime_rhs, motion.regime_jacobian))
_FLOATS: Any = SimpleNamespace(sqrt=math.sqrt, exp=math.exp)

#: Newton's method has gone astray beyond this, in L_0.
_FAR = 1e6


def index_of(p: Parameters, V: Any, d: Any, x: FloatArray, y: FloatArray) -> NDArray[np.int8]:
    """Index among ``equilibria`` at the friction μ(V), (10), of those at x, y; −1 where these are NaN."""
    from ..statics.solver import equilibria

    x, y = np.asarray(x), np.asarray(y)
    index = np.full(x.shape, -1, dtype=np.int8)
    rows = np.isfinite(x)
    if rows.any():
        given = {name: np.broadcast_to(getattr(p, name), x.shape)[rows] for name in NAMES}
        V, d = (np.broadcast_to(value, x.shape)[rows] for value in (V, d))
        found = equilibria(Parameters(**{**given, "mu0": motion.friction(np.zeros_like(V), given["mu0"], V, d)}))
        distance = np.hypot(found.x - x[rows][:, None], found.y - y[rows][:, None])
        index[rows] = np.argmin(np.where(np.isnan(distance), np.inf, distance), axis=-1)
    return index


def _rest(course: Course, problem: Problem, tol: float) -> Outcome | None:
    """At rest in the neighbourhood of an equilibrium that keeps it there, or decaying to one."""
    still = abs(course.last[0] - course.first[0]) <= 4 * tol and np.ptp(course.x_extrema) <= 4 * tol
    # On a belt that stands still the law of friction is smooth where x' changes its sign.
    kinks = course.events if problem.V > 0 else course.events[[Event.CONTACT_LOST, Event.CONTACT_REGAINED]]
    decaying = len(course.maxima) >= FEW and not kinks.any()
    if not (still or decaying):
        return None
    begun = course.moments()[0], float(course.integrals[-1, 2]) / (course.end - course.begin)
    rest = rest_near(problem, *(course.last[:2].tolist() if still else begun))
    if rest is None:
        return None
    x, y = rest.state[:2].tolist()
    growth = float(rest.values.real.max())
    late = course.maxima[course.maxima_t >= (course.begin + course.end) / 2]
    distance = float(np.abs(np.vstack([late, course.last]) - rest.state).max())
    if still and distance <= tol and growth <= _ROUNDING:
        return Outcome(Regime.EQUILIBRIUM, rest_x=x, rest_y=y, rate=max(-growth, 0.0), distance=distance)
    if decaying and growth < 0 and _decays(course, rest):
        regime = Regime.EQUILIBRIUM if distance <= tol else Regime.APPROACHES_EQUILIBRIUM
        return Outcome(regime, rest_x=x, rest_y=y, rate=-growth, distance=distance)
    return None


#: Real parts up to this are 0 but for rounding.
_ROUNDING = 1e-12


def _decays(course: Course, rest: Rest) -> bool:
    """Whether the parts of the motion in the eigenvectors die out as their eigenvalues say, within a factor of two.

    The squares of the two halves are compared under Hann windows, which hide unfinished beats.
    """
    modes = np.abs(np.linalg.solve(rest.vectors, (course.maxima - rest.state).T)) ** 2
    share = (course.maxima_t - course.begin) / (course.end - course.begin)
    if not FEW // 2 - 1 <= np.count_nonzero(share < 0.5) <= len(share) - FEW // 2 + 1:
        return False
    hann = np.sin(2 * np.pi * share) ** 2
    first, second = ((hann * part * modes).sum(axis=1) / (hann * part).sum() for part in (share < 0.5, share >= 0.5))
    expected = first * np.exp(rest.values.real * (course.end - course.begin))  # two times half the window
    before, after, linear = first.sum(), second.sum(), expected.sum()
    # A decay that the window does not show is none: the first of the three.
    return bool(linear < before * (1 - _VISIBLE) and after > 0 and 0.5 < np.log(after / before) / np.log(linear / before) < 2)


#: Smallest decay of the squares over half a window that can be read off it.
_VISIBLE = 1e-3


# ----------------------------------------------------------------------------------------------------- cycles


@dataclass(frozen=True)
class _Returns:
    """The return map of a flow about one closed orbit: states x, y, y' where x is largest, in units of ``scale``."""

    flow: Flow
    period: float
    scale: FloatArray
    step: float

    def __call__(self, state: FloatArray) -> tuple[FloatArray, float, Course]:
        """The return after about a period, when it was, and the way there."""
        x, y, vy = state * self.scale
        course = self.flow(np.array([x, y, 0.0, vy]), 1.1 * self.period)
        late = np.flatnonzero(course.maxima_t > 0.5 * self.period)
        if not len(late):
            raise ConvergenceError("the motion does not come back")
        returns = course.maxima[late][:, SECTION] / self.scale
        off = np.abs(returns - state).max(axis=1) + np.abs(course.maxima_t[late] / self.period - 1)
        best = int(np.argmin(off))
        return returns[best], float(course.maxima_t[late[best]]), course

    def slope(self, state: FloatArray, image: FloatArray | None = None) -> FloatArray:
        """Derivative of the map: by central differences, or by forward ones where the image of the state is given."""
        columns = []
        for h in self.step * np.eye(3):
            back, width = (self(state - h)[0], 2 * self.step) if image is None else (image, self.step)
            columns.append((self(state + h)[0] - back) / width)
        return np.array(columns).T


@dataclass(frozen=True)
class _Cycle:
    """A fixed point of a return map, and the derivative of the map there."""

    state: FloatArray
    period: float
    slope: FloatArray
    course: Course


def _periodic(course: Course, problem: Problem, flow: Flow, tol: float) -> Outcome | None:
    """The cycle that the motion is on, or winds onto."""
    if len(course.maxima) < 3:
        return None
    scale = _scale(course)
    states = course.maxima[:, SECTION] / scale
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
        values, vectors = np.linalg.eig(cycle.slope)
        largest = float(np.abs(values).max())
        off = states[::-1][::k] - cycle.state  # latest first
        if largest < 1 - NEUTRAL and _contracts(off, cycle.slope, vectors, largest, tol):
            distance = float(np.abs(off[0]).max())
            regime = Regime.LIMIT_CYCLE if distance <= tol else Regime.APPROACHES_CYCLE
            return _described(cycle, scale, regime, -math.log(largest) / cycle.period, distance)
    return None


def _scale(course: Course) -> FloatArray:
    """Extents of x, y and y' over all its turning points, those across the belt at least 1 % of that along it."""
    turns = np.vstack([course.maxima, course.minima])[:, SECTION]
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
        step = np.linalg.solve(np.eye(3) - slope, image - state)
        if not np.abs(state + step - start).max() < 4 * CLOSE:
            return None
        state, before = state + step, image
        image, period, course = returns(state)
        size = float(np.abs(step).max())
        missed = float(np.abs(image - state).max())
        if missed <= 10 * returns.step**2:
            slope = returns.slope(state)
            # What is missed counts many times over where a multiplier is near 1: once more, with the best slope.
            state = state + np.linalg.solve(np.eye(3) - slope, image - state)
            _, period, course = returns(state)
            return _Cycle(state, period, slope, course)
        if size > returns.step**2:
            slope = slope + np.outer(image - before - slope @ step, step) / (step @ step)
    return None


def _once_round(cycle: _Cycle, k: int, flow: Flow, scale: FloatArray, step: float) -> tuple[_Cycle, int]:
    """The same orbit over its least period, with the number of its largest x."""
    course = cycle.course
    within = (course.maxima_t > 1e-3 * cycle.period) & (course.maxima_t < (1 - 1e-3) * cycle.period)
    states = course.maxima[within][:, SECTION] / scale
    for row in np.flatnonzero(np.abs(states - cycle.state).max(axis=1) <= 1e-4):
        if k % (row + 1) == 0:
            period = float(course.maxima_t[within][row])
            shorter = _newton(_Returns(flow, period, scale, step), cycle.state, states[row])
            if shorter is not None and np.abs(shorter.state - cycle.state).max() <= 1e-4:
                return shorter, int(row) + 1
    return cycle, k


def _contracts(off: FloatArray, slope: FloatArray, vectors: NDArray[np.complex128], largest: float, tol: float) -> bool:
    """Whether the motion nears the cycle as the linearized map says; ``off`` is what lacked at its returns, latest first."""
    sizes = np.abs(off).max(axis=1)
    if sizes[: max(2, len(sizes) // 2)].max() <= tol:
        return True
    # Farther out the linearization decides nothing: motions have passed a cycle at 0.16 of its extent, and left it.
    if sizes[0] > 2 * CLOSE or np.abs(off[0] - slope @ off[1]).max() > 0.25 * sizes[1] + tol:
        return False
    far = np.flatnonzero(sizes > 4 * CLOSE)
    last = (far[0] if len(far) else len(sizes)) - 1
    if last < 1:
        return False
    parts = np.abs(np.linalg.solve(vectors, off[[0, last]].T)) if abs(np.linalg.det(vectors)) > 1e-9 else np.abs(off[[0, last]].T)
    now, then = np.linalg.norm(parts, axis=0)
    # At least half as fast as the slowest multiplier says.
    return bool(now <= then * largest ** (last / 2))


def _described(cycle: _Cycle, scale: FloatArray, regime: Regime, rate: float, distance: float) -> Outcome:
    """The outcome, with averages over the cycle's one period, and its state where x is largest."""
    course = cycle.course
    row = int(np.argmin(np.abs(course.maxima_t - cycle.period)))
    mean, spread = course.moments(row)
    round_once = course.maxima[(course.maxima_t > 1e-3 * cycle.period) & (course.maxima_t <= course.maxima_t[row])]
    # Of maxima that agree but for rounding the one highest above the belt, so that a cycle has one such state.
    top = round_once[round_once[:, 0] >= round_once[:, 0].max() - 1e-6 * scale[0]]
    x, y, _, vy = (float(value) for value in top[np.argmax(top[:, 1])])
    return Outcome(
        regime, rate=rate, distance=distance, period=cycle.period, cycle_mean=mean, cycle_rms=math.hypot(mean, spread),
        cycle_x=x, cycle_y=y, cycle_vy=vy,
    )  # fmt: skip


def same_orbit(one: Any, other: Any) -> bool:
    """Whether two cycles are one: state where x is largest, period and averages, all found by Newton's method."""
    names = ("cycle_x", "cycle_y", "cycle_vy", "cycle_mean", "cycle_rms")
    reach = max(abs(one.cycle_x - one.cycle_mean), abs(other.cycle_x - other.cycle_mean))
    return abs(one.period / other.period - 1) < SETTLED and all(
        abs(getattr(one, name) - getattr(other, name)) < 10 * SETTLED * reach for name in names
    )
