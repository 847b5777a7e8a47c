"""Existing integrators, restarted wherever the field of (8)–(11) has a kink.

The field is continuous, and analytic in each of four regimes: contact or not (``nbar``), belt ahead of the
mass or behind (``side``). Both backends integrate one regime's analytic continuation, find where the motion
leaves it, and go on in the next. A regime is left :data:`GAP` beyond its border, so that two crossings are
never closer than 2 GAP: that ends chatter by rounding, lets a motion start exactly on a kink, and costs an
error of the order of GAP², or GAP^1.5 where the motion only grazes the border, far below rounding.

The exponential of (10) makes a layer at x' = V that a step from far away cannot see: all its derivatives are
below rounding there. So it is left out where it is below the tolerance, and the border of the layer
(``near``) is one more that the integrator stops at.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
import inspect
import math
import threading
from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from functools import cache, partial
from types import SimpleNamespace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import ConvergenceError, MissingExtraError, ParameterError
from ..generated import motion
from ..parameters import FloatArray

State: TypeAlias = tuple[float, float, float, float]

#: In contact (1) or not (0), the belt ahead (1) or behind (−1), the exponential of (10) felt (1) or not (0).
Regime: TypeAlias = tuple[int, int, int]

#: How far beyond its border a regime is left, in L_0 and in units of speed.
GAP = 1e-12

#: Between leaving out the exponential of (10) and taking it in again, in units of its exponent.
WIDTH = 5.0

#: Polynomial degree of a stored step: 12 holds a Taylor step of order 20 to rounding; DOP853's is 7.
DEGREE = 12

BACKENDS = ("heyoka", "scipy")


class Event(IntEnum):
    """What happens at an event."""

    CONTACT_LOST = 0
    CONTACT_REGAINED = 1
    MASS_OVERTAKES = 2
    BELT_OVERTAKES = 3


@dataclass(frozen=True)
class Problem:
    """One motion: constants of (8)–(11), initial state, and what to keep of it."""

    cos0: float
    sin0: float
    mu0: float
    kappa: float
    alpha: float
    sigma: float
    beta: float
    V: float
    d: float
    start: State
    t_end: float
    t_record: float
    rtol: float
    max_steps: int = 10_000_000

    @property
    def constants(self) -> tuple[float, ...]:
        """In the order in which the generated functions take them."""
        return (self.cos0, self.sin0, self.mu0, self.kappa, self.alpha, self.sigma, self.beta, self.V, self.d)

    @property
    def reach(self) -> float:
        """d |V − x'| beyond which the exponential of (10) is below the tolerance, and left out."""
        return 5 - math.log(self.rtol)


@dataclass(frozen=True)
class Motion:
    """A motion as polynomials of degree :data:`DEGREE`, by their values at every step's Lobatto points."""

    t: FloatArray
    states: FloatArray
    event_t: FloatArray
    event_states: FloatArray
    event_kinds: NDArray[np.intp]


@dataclass(frozen=True)
class Course:
    """What is measured of a motion while it runs; none of its steps is kept.

    Attributes
    ----------
    begin, end : float
        Times between which it was measured.
    first, last : ndarray, shape (4,)
        x, y, x', y' at these.
    maxima_t : ndarray, shape (k,)
        Times at which x is largest: x' = 0 on the way down.
    maxima : ndarray, shape (k, 4)
        States there.
    integrals : ndarray, shape (k + 1, 3)
        From ``begin`` to these times, and last to ``end``: of u = x − x(begin), of u², and of y.
    minima : ndarray, shape (l, 4)
        States at which x is least.
    events : ndarray of int, shape (4,)
        How often each :class:`Event` happened.
    """

    begin: float
    end: float
    first: FloatArray
    last: FloatArray
    maxima_t: FloatArray
    maxima: FloatArray
    integrals: FloatArray
    minima: FloatArray
    events: NDArray[np.intp]

    @property
    def x_extrema(self) -> FloatArray:
        """Values of x at its turning points and at both ends."""
        return np.concatenate([[self.first[0], self.last[0]], self.maxima[:, 0], self.minima[:, 0]])

    def moments(self, row: int = -1) -> tuple[float, float]:
        """Mean of x and root mean square about it, from ``begin`` to the maximum ``row``, or to ``end``."""
        end = self.end if row == -1 else self.maxima_t[row]
        shift, square, _ = (self.integrals[row] / (end - self.begin)).tolist()
        return float(self.first[0]) + shift, math.sqrt(max(square - shift * shift, 0.0))


@cache
def lobatto() -> tuple[FloatArray, FloatArray]:
    """Gauss–Lobatto points in [−1, 1], ends included, and their weights."""
    legendre = np.polynomial.Legendre.basis(DEGREE)
    points = np.concatenate([[-1.0], np.sort(legendre.deriv().roots().real), [1.0]])
    weights = 2 / (DEGREE * (DEGREE + 1) * legendre(points) ** 2)
    return points, weights


def choose(backend: str | None) -> str:
    """The backend that will run: heyoka where it is installed, else SciPy; a named one or an error."""
    if backend is None:
        return "heyoka" if importlib.util.find_spec("heyoka") else "scipy"
    if backend not in BACKENDS:
        raise ParameterError(f"backend = {backend!r} is not one of {', '.join(BACKENDS)}; leave it out for the fastest")
    if backend == "heyoka" and not importlib.util.find_spec("heyoka"):
        raise MissingExtraError("backend='heyoka'", "heyoka", "fast")
    return backend


def version(backend: str) -> str:
    """Name and version of the integrator, which decide the last bits of a result."""
    return f"{backend} {importlib.metadata.version(backend)}"


def integrate(problem: Problem, backend: str) -> Motion:
    """Integrate ``problem`` from 0 to ``t_end`` and keep what follows ``t_record``."""
    return {"heyoka": _heyoka, "scipy": _scipy}[backend](problem)


def _initial_regime(problem: Problem) -> Regime:
    """On a border either side is right, as the field is continuous: contact, and the belt ahead."""
    _, y, vx, _ = problem.start
    return int(y <= 0), 1 if vx <= problem.V else -1, int(problem.d * abs(problem.V - vx) <= problem.reach)


def _after(border: int, regime: Regime) -> tuple[Regime, Event | None]:
    """The regime beyond one of the three borders, and what a user calls passing it, if anything."""
    nbar, side, near = regime
    if border == 0:
        return (1 - nbar, side, near), Event.CONTACT_LOST if nbar else Event.CONTACT_REGAINED
    if border == 1:
        return (nbar, -side, near), Event.MASS_OVERTAKES if side > 0 else Event.BELT_OVERTAKES
    return (nbar, side, 1 - near), None


def _assemble(t: FloatArray, states: FloatArray, events: list[tuple[float, State, Event]], t_record: float) -> Motion:
    """From samples by steps, shapes (steps, DEGREE + 1) and (steps, 4, DEGREE + 1), to samples in a row."""
    kept = [event for event in events if event[0] >= t_record]
    return Motion(
        np.append(t[:, :-1].ravel(), t[-1, -1]),
        np.append(states[:, :, :-1].swapaxes(0, 1).reshape(4, -1), states[-1, :, -1:], axis=1),
        np.array([t for t, _, _ in kept]),
        np.array([state for _, state, _ in kept]).reshape(-1, 4),
        np.array([kind for _, _, kind in kept], dtype=np.intp),
    )


def _too_many(problem: Problem, t: float) -> ConvergenceError:
    return ConvergenceError(
        f"max_steps = {problem.max_steps} steps were made by t = {t:.6g} of {problem.t_end:g}; give a larger max_steps, "
        f"a smaller t_end or a larger rtol than {problem.rtol:g}, or a smaller d than {problem.d:g}, which makes creep stiff"
    )


# ------------------------------------------------------------------------------------------------------ SciPy

# The continuation of a regime grows without bound far outside it. Trial steps that go there are rejected,
# whatever the size of the number: it must only be finite.
_FLOATS = SimpleNamespace(sqrt=math.sqrt, exp=lambda z: math.exp(min(z, 100.0)))
_FLOATS_FAR = SimpleNamespace(sqrt=math.sqrt, exp=lambda z: 0.0)
_ARRAYS = SimpleNamespace(sqrt=np.sqrt, exp=lambda z: np.exp(np.minimum(z, 100.0)))

#: Each step is searched for crossings on this many intervals, and between them at extrema.
_SEARCH = np.linspace(0.0, 1.0, 9)


def _scipy(problem: Problem) -> Motion:
    """DOP853, restarted at every crossing."""
    from scipy.integrate import DOP853

    unit = (lobatto()[0] + 1) / 2
    regime, state, clock, first_step = _initial_regime(problem), np.array(problem.start), 0.0, None
    times: list[FloatArray] = []
    states: list[FloatArray] = []
    events: list[tuple[float, State, Event]] = []
    steps = 0

    def keep(begin: float, end: float, dense: Callable[[Any], FloatArray]) -> None:
        begin = max(begin, problem.t_record - clock)
        if end > begin:
            local = begin + unit * (end - begin)
            local[-1] = end
            times.append(clock + local)
            states.append(dense(local))

    while clock < problem.t_end:
        # Time runs from 0 in every regime: the closer to the crossing, the more digits it has.
        bound = problem.t_end - clock
        solver = DOP853(
            _field(problem, regime), 0.0, state, bound, rtol=problem.rtol, atol=problem.rtol * 1e-3,
            first_step=None if first_step is None else min(first_step, bound),
        )  # fmt: skip
        crossing = None
        while solver.status == "running" and crossing is None:
            message = solver.step()
            if solver.status == "failed":
                raise ConvergenceError(f"SciPy's DOP853 stopped at t = {clock + solver.t:.6g}: {message}; use a larger rtol")
            steps += 1
            if steps > problem.max_steps:
                raise _too_many(problem, clock + solver.t)
            dense, begin, end = solver.dense_output(), solver.t_old, solver.t
            crossing = _first_crossing(problem, regime, dense, begin, end)
            keep(begin, end if crossing is None else crossing[0], dense)
        if crossing is None:
            break
        end, row = crossing
        first_step, state, clock = solver.step_size, dense(end), clock + end
        regime, kind = _after(row, regime)
        if kind is not None:
            events.append((clock, tuple(state.tolist()), kind))
    return _assemble(np.array(times), np.array(states), events, problem.t_record)


def _field(problem: Problem, regime: Regime) -> Callable[[float, FloatArray], State]:
    algebra = inspect.unwrap(motion.regime_rhs)
    nbar, side, near = regime
    constants, xp = (*problem.constants, nbar, side), _FLOATS if near else _FLOATS_FAR

    def field(_: float, state: FloatArray) -> State:
        x, y, vx, vy = state.tolist()
        return (vx, vy, *algebra(x, y, vx, vy, *constants, xp=xp))

    return field


def _clearances(problem: Problem, regime: Regime, states: FloatArray) -> FloatArray:
    """Distance from the three borders of a regime, negative beyond them, and its rate: shape (3, 2, …)."""
    nbar, side, near = regime
    _, y, vx, vy = states
    rhs: Any = motion.regime_rhs
    x_accel, _ = rhs(*states, *problem.constants, nbar, side, xp=_ARRAYS)
    inward, farther = -1 if nbar else 1, -1 if near else 1
    slip, rate = side * (problem.V - vx), -side * x_accel
    depth = problem.d * slip - problem.reach - WIDTH * near
    return np.array([[inward * y + GAP, inward * vy], [slip + GAP, rate], [farther * depth, farther * problem.d * rate]])


def _first_crossing(
    problem: Problem, regime: Regime, dense: Callable[[Any], FloatArray], begin: float, end: float
) -> tuple[float, int] | None:
    """When, within a step, the motion first leaves its regime, and through which border."""

    def border(row: int, t: Any) -> FloatArray:
        """Distance from one of the borders, and its rate."""
        distance_and_rate: FloatArray = _clearances(problem, regime, dense(np.asarray(t)))[row]
        return distance_and_rate

    grid = begin + _SEARCH * (end - begin)
    found = []
    for row, (distance, rate) in enumerate(_clearances(problem, regime, dense(grid))):
        at = partial(border, row)
        bracket = _bracket(grid, distance, rate, at)
        if bracket is not None:
            found.append((_root(at, 0, *bracket), row))
    return min(found, default=None)


def _bracket(
    grid: FloatArray, value: FloatArray, rate: FloatArray, both: Callable[[float], FloatArray]
) -> tuple[float, float] | None:
    """The first interval where ``value`` goes from not negative to negative, dips between points included."""
    if value.min() > np.abs(rate).max() * (grid[1] - grid[0]):
        return None
    for i in range(len(grid) - 1):
        if value[i + 1] < 0:
            return float(grid[i]), float(grid[i + 1])
        if rate[i] < 0 < rate[i + 1]:
            lowest = _root(both, 1, float(grid[i]), float(grid[i + 1]))
            if both(lowest)[0] < 0:
                return float(grid[i]), lowest
    return None


def _root(border: Callable[[float], FloatArray], part: int, begin: float, end: float) -> float:
    """Where the distance from a border (part 0) or its rate (part 1) changes sign."""
    from scipy.optimize import brentq

    def function(t: float) -> float:
        return float(border(t)[part])

    if function(begin) * function(end) > 0:
        return begin  # the motion begins beyond the border, by rounding: it is left at once
    return float(brentq(function, begin, end, xtol=1e-15, rtol=8.9e-16))


# ----------------------------------------------------------------------------------------------------- heyoka


class _Compiled:
    """A compiled Taylor integrator, used again and again: parameters and regime are its ``par[]``.

    With ``watch`` it also carries the integrals of a :class:`Course` and notes where x' = 0. The integrals are scaled so
    that they stay below the states: heyoka's error is relative to the largest of all.
    """

    def __init__(self, rtol: float, watch: bool) -> None:
        import heyoka as hy

        x, y, vx, vy = hy.make_vars("x", "y", "vx", "vy")
        constants = [hy.par[i] for i in range(9)]
        V, d = constants[7:]
        nbar, side, near, reach = (hy.par[i] for i in range(9, 13))
        xp = SimpleNamespace(sqrt=hy.sqrt, exp=lambda z: near * hy.exp(z))
        algebra = inspect.unwrap(motion.regime_rhs)
        ax, ay = algebra(x, y, vx, vy, *constants, nbar, side, xp=xp)
        borders = {
            self._contact: y + GAP * (1 - 2 * nbar),
            # heyoka's error is relative to the largest of the states and of these: it must not be one of these.
            self._slip: 1e-3 * (V - vx + GAP * side),
            self._layer: 1e-3 * ((d * side * (V - vx) - WIDTH * near) / reach - 1),
        }
        self.log: list[tuple[float, State, Event]] = []
        self.stray: float | None = None
        self.turns: list[tuple[float, ...]] = []
        system, turns = [(x, vx), (y, vy), (vx, ax), (vy, ay)], []
        if watch:
            shift, scale = x - hy.par[13], hy.par[14]
            system += zip(hy.make_vars("s", "ss", "sy"), (scale * shift, scale * shift * shift, scale * y), strict=True)
            turns = [hy.nt_event(1e-3 * vx, self._turn)]
        # The gap keeps one crossing from being found twice, which is what a cooldown is for.
        self.solver = hy.taylor_adaptive(
            system, [0.0] * len(system), pars=[0.0] * (15 if watch else 13), tol=rtol, nt_events=turns,
            t_events=[hy.t_event(border, callback=call, cooldown=0.0) for call, border in borders.items()],
        )  # fmt: skip

    def __deepcopy__(self, _: object) -> _Compiled:
        """heyoka copies its callbacks; they must go on to write here."""
        return self

    def _turn(self, solver: Any, t: float, direction: int) -> None:
        solver.update_d_output(t)
        self.turns.append((direction, t, *solver.d_output))

    def _contact(self, solver: Any, direction: int) -> bool:
        if direction > 0:
            return self._switch(solver, 9, 1, 0, Event.CONTACT_LOST)
        return self._switch(solver, 9, 0, 1, Event.CONTACT_REGAINED)

    def _slip(self, solver: Any, direction: int) -> bool:
        if direction > 0:
            return self._switch(solver, 10, -1, 1, Event.BELT_OVERTAKES)
        return self._switch(solver, 10, 1, -1, Event.MASS_OVERTAKES)

    def _layer(self, solver: Any, direction: int) -> bool:
        return self._switch(solver, 11, int(direction > 0), int(direction < 0), None)

    def _switch(self, solver: Any, par: int, before: int, after: int, kind: Event | None) -> bool:
        """Go over to the next regime; stop if it is not next, for then a crossing was missed."""
        if solver.pars[par] != before:
            self.stray = solver.time
            return False
        solver.pars[par] = after
        if kind is not None:
            self.log.append((solver.time, tuple(solver.state[:4]), kind))
        return True

    def begin(self, problem: Problem) -> None:
        """Stand at the start of a motion."""
        self.place(0.0, problem.start, (*problem.constants, *_initial_regime(problem), problem.reach))

    def place(self, t: float, state: Any, pars: Any) -> None:
        """Stand anywhere, with nothing noted."""
        solver = self.solver
        self.log, self.turns, self.stray = [], [], None
        solver.time = t
        solver.state[:] = (*state, *[0.0] * (len(solver.state) - 4))
        solver.pars[:13] = pars
        solver.reset_cooldowns()

    def go(self, problem: Problem, t: float, steps: int = 0, *, record: bool = False) -> tuple[int, Any]:
        """Go on to ``t`` after so many steps; how many there are now, and the continuous output if asked for."""
        import heyoka as hy

        solver = self.solver
        # heyoka takes 0 for no limit.
        result = solver.propagate_until(t, c_output=record, max_steps=max(problem.max_steps - steps, 1))
        outcome, steps, output = result[0], steps + result[3], result[4]
        if self.stray is not None:
            raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        if outcome == hy.taylor_outcome.step_limit or steps > problem.max_steps:
            raise _too_many(problem, solver.time)
        if outcome != hy.taylor_outcome.time_limit:
            raise ConvergenceError(f"heyoka stopped at t = {solver.time:.6g} with {outcome}; use backend='scipy'")
        nbar, side, near = (int(value) for value in solver.pars[9:12])
        if not _is_inside(problem, (nbar, side, near), solver.state):
            raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        return steps, output


def _is_inside(problem: Problem, regime: Regime, state: FloatArray) -> bool:
    """Whether a state lies in a regime, or beyond its borders by no more than the gap."""
    nbar, side, near = regime
    y, vx = float(state[1]), float(state[2])
    slip = side * (problem.V - vx)
    depth = problem.d * slip - problem.reach - WIDTH * near
    return min((-y if nbar else y), slip, -depth if near else depth) >= -2 * GAP


def _sampled(output: Any) -> tuple[FloatArray, FloatArray]:
    """Values of a heyoka continuous output at the Lobatto points of its steps."""
    coefficients, begin, step = output.tcs, output.times[:-1, None], np.diff(output.times)[:, None]
    unit = (lobatto()[0] + 1) / 2
    order = np.arange(coefficients.shape[2])
    states = (coefficients * step[:, :, None] ** order) @ unit ** order[:, None]
    t = begin + step * unit
    t[:, -1] = output.times[1:]
    return t, states


_CACHE = threading.local()


def _compiled(rtol: float, watch: bool) -> _Compiled:
    """Compiled once per tolerance and thread."""
    compiled: dict[tuple[float, bool], _Compiled] = _CACHE.__dict__.setdefault("compiled", {})
    if (rtol, watch) not in compiled:
        compiled[rtol, watch] = _Compiled(rtol, watch)
    return compiled[rtol, watch]


def _heyoka(problem: Problem) -> Motion:
    """heyoka's Taylor method with terminal events."""
    compiled = _compiled(problem.rtol, watch=False)
    compiled.begin(problem)
    steps = compiled.go(problem, problem.t_record)[0] if problem.t_record > 0 else 0
    _, output = compiled.go(problem, problem.t_end, steps, record=True)
    times, states = _sampled(output)
    return _assemble(times, states, compiled.log, problem.t_record)


def watch(problem: Problem) -> Course:
    """What follows ``t_record``, measured by heyoka on the way: no continuous output, which costs a compilation a motion."""
    watching, steps = _compiled(problem.rtol, watch=True), 0
    if problem.t_record > 0:
        plain = _compiled(problem.rtol, watch=False)
        plain.begin(problem)
        steps, _ = plain.go(problem, problem.t_record)
        watching.place(problem.t_record, plain.solver.state, plain.solver.pars)
    else:
        watching.begin(problem)
    solver = watching.solver
    first = solver.state[:4].copy()
    scale = 1e-3 / (problem.t_end - problem.t_record)
    solver.pars[13:] = first[0], scale
    watching.go(problem, problem.t_end, steps)
    turns = np.array(watching.turns).reshape(-1, 9)
    maxima, minima = turns[turns[:, 0] < 0], turns[turns[:, 0] > 0]
    last = solver.state.copy()
    events = np.bincount([kind for _, _, kind in watching.log], minlength=len(Event))
    return Course(
        problem.t_record, problem.t_end, first, last[:4], maxima[:, 1], maxima[:, 2:6],
        np.vstack([maxima[:, 6:], last[4:]]) / scale, minima[:, 2:6], events,
    )  # fmt: skip
