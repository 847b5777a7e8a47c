"""Motion in time: trajectories, what happens along them, and what they settle to."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Result
from ..errors import ParameterError, ParameterTypeError
from ..files import storage
from ..generated import motion
from ..parameters import FINITE, NAMES, NOT_NEGATIVE, POSITIVE, FloatArray, Parameters, Range, as_number, as_numbers, degrees
from . import integrators, regimes
from .integrators import DEGREE, Course, Event, Problem
from .regimes import SETTLED, Outcome, Regime

__all__ = ["Event", "Events", "Trajectory", "simulate"]

BELT_SPEED = Range(
    0.0, remedy="a belt that runs the other way is the mirror image: theta0 -> pi - theta0, x -> -x"
)
CREEP = Range(
    0.0, open_low=True, remedy="d is the steepness of the friction law (10); without it there is no friction"
)
TOLERANCE = Range(
    1e-13, 1e-2, remedy="float64 carries no more, and less than that follows no oscillation; 1e-10 suits most"
)

#: The tightest that SciPy takes, for the second run of an error estimate.
TIGHTEST = 2.3e-14

#: Steps after which a motion is given up, unless asked otherwise.
MAX_STEPS = Problem.max_steps

#: Quantities of a trajectory.
QUANTITIES = ("x", "y", "vx", "vy")


@dataclass(frozen=True, eq=False)
class Events(Result):
    """Where the motion passed a kink of the field, in order of time.

    Attributes
    ----------
    t : ndarray, shape (k,)
        Time.
    state : ndarray, shape (k, 4)
        x, y, x', y' there: y = 0 or x' = V to 1e-12.
    which : ndarray of int, shape (k,)
        Codes of :class:`Event`.
    """

    t: FloatArray
    state: FloatArray
    which: NDArray[np.intp]

    def __len__(self) -> int:
        return len(self.t)

    def of(self, *kinds: Event) -> Events:
        """The events of some kinds only."""
        chosen = np.isin(self.which, kinds)
        return Events(self.t[chosen], self.state[chosen], self.which[chosen])


@dataclass(frozen=True, eq=False)
class Trajectory(Result):
    """A motion in time, as accurate between the samples as on them.

    The samples are the Gauss–Lobatto points of every step that the integrator took, its ends and all events
    among them: ``degree + 1`` to a step, consecutive steps sharing one. The motion is the polynomial through
    them, so that integrals and values in between lose nothing against the integration.

    Attributes
    ----------
    t, x, y, vx, vy : ndarray, shape (n,)
        Time in sqrt(m/k_c), displacements in L_0, speeds in L_0 sqrt(k_c/m).
    events : Events or None
        Contact lost and regained (y = 0), slip reversed (x' = V); None when not asked for.
    p : Parameters
        The parameters, scalars.
    V, d, rtol : float
        Belt speed, steepness of the friction law, tolerance.
    backend : str
        Which integrator ran.
    error : ndarray, shape (n,), or None
        Largest of the four |differences| to a second run at a tighter tolerance; None when not asked for.
    """

    t: FloatArray
    x: FloatArray
    y: FloatArray
    vx: FloatArray
    vy: FloatArray
    events: Events | None
    p: Parameters
    V: float
    d: float
    rtol: float
    backend: str
    error: FloatArray | None = None

    @cached_property
    def state(self) -> FloatArray:
        """x, y, x', y' at the samples, shape (4, n)."""
        return np.array([self.x, self.y, self.vx, self.vy])

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over time."""
        _, unit = integrators.lobatto()
        weights = np.zeros_like(self.t)
        steps = self.t[::DEGREE]
        for j, weight in enumerate(unit):
            weights[j : len(self.t) - DEGREE + j : DEGREE] += weight * np.diff(steps) / 2
        return weights

    def integral(self, values: ArrayLike) -> float:
        """Integral over time of ``values``, given at the samples."""
        return float(np.sum(self.weights * np.asarray(values)))

    def __call__(self, t: ArrayLike) -> FloatArray:
        """x, y, x', y' at any times within the trajectory, shape (4, …)."""
        times = as_numbers("t", t)
        if times.size and not (self.t[0] <= times.min() and times.max() <= self.t[-1]):
            raise ParameterError(
                f"t = {times.min():g} … {times.max():g} is not within the trajectory, "
                f"[{self.t[0]:g}, {self.t[-1]:g}]; simulate with a larger t_end"
            )
        return self._at(self._step_of(times), times)

    def after(self, transient: float | None) -> Trajectory:
        """What follows the time ``transient``, three quarters of the end if None, as a trajectory; an error if nothing does."""
        transient = 0.75 * float(self.t[-1]) if transient is None else as_number("transient", transient, NOT_NEGATIVE)
        if transient >= self.t[-1]:
            raise ParameterError(
                f"transient = {transient:g} leaves nothing of a trajectory that ends at {self.t[-1]:g}; "
                "give a smaller transient, or simulate with a larger t_end"
            )
        if transient <= self.t[0]:
            return self
        step = int(self._step_of(np.array(transient)))
        end = (step + 1) * DEGREE
        points, _ = integrators.lobatto()
        t = transient + (points + 1) / 2 * (self.t[end] - transient)
        t[-1] = self.t[end]
        state = np.concatenate([self._at(np.full(t.shape, step), t)[:, :-1], self.state[:, end:]], axis=1)
        t = np.concatenate([t[:-1], self.t[end:]])
        error = None if self.error is None else np.interp(t, self.t, self.error)
        events = self.events
        if events is not None:
            late = events.t >= transient
            events = Events(events.t[late], events.state[late], events.which[late])
        return replace(
            self, t=t, x=state[0], y=state[1], vx=state[2], vy=state[3], events=events, error=error
        )

    def mean(self, transient: float | None = None, *, of: str = "x") -> float:
        """Time average of x (or ``of="y"``, ``"vx"``, ``"vy"``) after ``transient``."""
        late = self.after(transient)
        return late.integral(late._values(of)) / float(late.t[-1] - late.t[0])

    def rms(self, transient: float | None = None, *, of: str = "x", about: str = "zero") -> float:
        """Root mean square after ``transient``: about zero, or with ``about="mean"`` about the mean.

        The article's Figure 7b shows the root mean square of x, from zero.
        """
        late = self.after(transient)
        deviation = late._values(of) - late._centre(of, about)
        return float(np.sqrt(late.integral(deviation**2) / (late.t[-1] - late.t[0])))

    def amplitude(self, transient: float | None = None, *, of: str = "x", about: str = "zero") -> float:
        """Largest |x| after ``transient``: from zero, or with ``about="mean"`` from the mean."""
        late = self.after(transient)
        return float(np.abs(late._extrema(of) - late._centre(of, about)).max())

    def outcome(self, transient: float | None = None, *, tol: float = SETTLED) -> Outcome:
        """What the motion settles to or approaches, how fast, and what is left, judged by what follows ``transient``.

        The same as a :class:`~spragsym.Sweep` tells of it. A cycle is found by Newton's method on its return map, which
        integrates a few periods more.
        """
        late = self.after(transient)
        start, length = tuple(late.state[:, 0].tolist()), float(late.t[-1] - late.t[0])
        problem = prepare(self.p, V=self.V, d=self.d, start=start, t_end=length, t_record=0.0, rtol=self.rtol)
        found = regimes.classify(late.course(), problem, flow(problem, self.backend), as_number("tol", tol, POSITIVE))
        where = np.array(found.rest_x), np.array(found.rest_y)
        return replace(found, equilibrium=int(regimes.index_of(self.p, self.V, self.d, *where)))

    def period(self, transient: float | None = None, *, tol: float = SETTLED) -> float:
        """Period of the cycle that the motion after ``transient`` has settled to; NaN if it has not, and at rest.

        It has settled when what is left to the cycle is at most ``tol`` of the motion's reach. The period is the cycle's
        own, whatever is left. For what a motion only approaches see :meth:`outcome`.
        """
        outcome = self.outcome(transient, tol=tol)
        return outcome.period if outcome.regime == Regime.LIMIT_CYCLE else float("nan")

    def converged(self, transient: float | None = None, *, tol: float = SETTLED) -> bool:
        """Whether the motion after ``transient`` has settled to rest or to a cycle, within ``tol`` (see :meth:`outcome`)."""
        return self.outcome(transient, tol=tol).regime in (Regime.EQUILIBRIUM, Regime.LIMIT_CYCLE)

    def energy(self) -> FloatArray:
        """Kinetic and stored energy over k_c L_0², contact and preload included, at the samples."""
        cos0, sin0, _, *stiffnesses = _constants(self.p)
        x, y, vx, vy = self.state
        kappa, alpha, sigma, beta = stiffnesses
        energy: FloatArray = motion.energy(x, y, vx, vy, cos0, sin0, kappa, alpha, sigma, beta, y < 0)
        return energy

    def friction_power(self) -> FloatArray:
        """Rate at which friction changes that energy, at the samples: positive where it drives the mass."""
        side = np.where(self.vx <= self.V, 1, -1)
        (mu0,) = self.p.scalars("mu0")
        power: FloatArray = motion.friction_power(self.y, self.vx, mu0, self.V, self.d, self.y < 0, side)
        return power

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``)."""
        data: dict[str, Any] = {name: ("t", getattr(self, name)) for name in QUANTITIES}
        if self.error is not None:
            data["error"] = ("t", self.error)
        if self.events is not None:
            data |= {"event": ("event_t", self.events.which.astype(np.int8))}
        coords = {"t": self.t} | ({} if self.events is None else {"event_t": self.events.t})
        dataset = storage.xarray().Dataset(data, coords=coords, attrs=self._attributes())
        for name in dataset.variables:
            dataset[name].attrs = storage.attributes(name)
        if self.events is not None:
            dataset["event"].attrs |= {
                "flag_values": np.array(list(Event), dtype=np.int8),
                "flag_meanings": " ".join(kind.name.lower() for kind in Event),
            }
        return dataset

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write netCDF to ``*.nc`` (extra ``sweep``), with the events, or the samples alone to ``*.csv``."""
        columns = {name: getattr(self, name) for name in ("t", *QUANTITIES)}
        storage.write(Path(path), self.to_dataset, lambda: columns, self._attributes())

    # -------------------------------------------------------------------------------------------- inner parts

    def _attributes(self) -> dict[str, Any]:
        values = dict(zip(NAMES, self.p.scalars(*NAMES), strict=True))
        return {
            **storage.provenance(),
            **values,
            "theta0_deg": degrees(values["theta0"]),
            "V": self.V,
            "d": self.d,
            "rtol": self.rtol,
            "backend": self.backend,
        }

    def _values(self, of: str) -> FloatArray:
        if of not in QUANTITIES:
            raise ParameterError(f"of = {of!r} is not one of {', '.join(QUANTITIES)}")
        return getattr(self, of)  # type: ignore[no-any-return]

    def _centre(self, of: str, about: str) -> float:
        if about not in ("zero", "mean"):
            raise ParameterError(f"about = {about!r} is neither 'zero' nor 'mean'")
        return self.mean(0.0, of=of) if about == "mean" else 0.0

    def _step_of(self, times: FloatArray) -> NDArray[np.intp]:
        steps = self.t[::DEGREE]
        return np.clip(np.searchsorted(steps, times, side="right") - 1, 0, len(steps) - 2)

    def _at(self, step: NDArray[np.intp], times: FloatArray) -> FloatArray:
        """States at times within given steps, by Lagrange's polynomials in barycentric form."""
        points, _ = integrators.lobatto()
        index = step[..., None] * DEGREE + np.arange(DEGREE + 1)
        begin, end = self.t[index[..., 0]], self.t[index[..., -1]]
        distance = (2 * (times - begin) / (end - begin) - 1)[..., None] - points
        hit = distance == 0
        share = _barycentric() / np.where(hit, 1.0, distance)
        share = np.where(hit.any(axis=-1, keepdims=True), hit, share)
        states: FloatArray = (self.state[:, index] * (share / share.sum(axis=-1, keepdims=True))).sum(axis=-1)
        return states

    def _passages(self, values: FloatArray, function: Callable[[FloatArray], FloatArray]) -> FloatArray:
        """Times where ``values``, a ``function`` of the state, cease to be negative: Illinois method."""
        (before,) = np.nonzero((values[:-1] < 0) & (values[1:] >= 0))
        step, low, high = before // DEGREE, self.t[before], self.t[before + 1]
        below, above = values[before], values[before + 1]
        root, was_left, was_right = high, np.zeros(len(high), dtype=bool), np.zeros(len(high), dtype=bool)
        for _ in range(60):
            last, root = root, high - above * (high - low) / (above - below)
            value = function(self._at(step, root))
            left = value < 0
            # An end that stays a second time counts half, so that it will not stay for ever.
            above = np.where(left, np.where(was_left, above / 2, above), value)
            below = np.where(left, value, np.where(was_right, below / 2, below))
            low, high = np.where(left, root, low), np.where(left, high, root)
            was_left, was_right = left, ~left
            if np.all(np.abs(root - last) <= 1e-15 * (1 + np.abs(root))):
                break
        return root

    def _extrema(self, of: str) -> FloatArray:
        """Values at the ends and at all local extrema of x or y; the samples themselves for speeds."""
        values = self._values(of)
        row = QUANTITIES.index(of)
        if row > 1:
            return values
        speed = self.state[row + 2]
        lowest = self._passages(speed, lambda state: state[row + 2])
        highest = self._passages(-speed, lambda state: -state[row + 2])
        return np.concatenate([values[[0, -1]], self(lowest)[row], self(highest)[row]])

    def course(self) -> Course:
        """What :func:`~spragsym.dynamics.integrators.watch` measures on the way, from the samples."""
        lowest = self._passages(self.vx, lambda state: state[2])
        highest = self._passages(-self.vx, lambda state: -state[2])
        return Course(
            float(self.t[0]), float(self.t[-1]), self.state[:, 0], self.state[:, -1], highest, self(highest).T,
            self._integrals_to(np.append(highest, self.t[-1])), self(lowest).T, self._counts(),
        )  # fmt: skip

    def _counts(self) -> NDArray[np.intp]:
        """How often each kind of event happened, by the samples where the events were not kept: they are among them."""
        if self.events is not None:
            return np.bincount(self.events.which, minlength=len(Event))
        above, ahead = np.diff((self.y > 0).astype(int)), np.diff((self.vx > self.V).astype(int))
        return np.array([np.count_nonzero(change == sign) for change in (above, ahead) for sign in (1, -1)])

    def _integrals_to(self, times: FloatArray) -> FloatArray:
        """Integrals from the first sample of u = x − x(first), of u² and of y, shape (…, 3)."""

        def integrands(state: FloatArray) -> FloatArray:
            shift = state[0] - self.x[0]
            return np.array([shift, shift**2, state[1]])

        points, unit = integrators.lobatto()
        steps = self.t[::DEGREE]
        inside = integrands(self.state)[:, np.arange(len(steps) - 1)[:, None] * DEGREE + np.arange(DEGREE + 1)]
        whole = np.cumsum((inside * unit).sum(axis=2) * np.diff(steps) / 2, axis=1)
        step = self._step_of(times)
        half = (times - steps[step])[:, None] / 2
        begun = steps[step][:, None] + half * (points + 1)
        part = (integrands(self._at(np.repeat(step[:, None], len(points), axis=1), begun)) * unit * half).sum(axis=2)
        integrals: FloatArray = (np.concatenate([np.zeros((3, 1)), whole], axis=1)[:, step] + part).T
        return integrals


def _barycentric() -> FloatArray:
    """Barycentric weights of the Lobatto points."""
    points, weights = integrators.lobatto()
    barycentric: FloatArray = np.sqrt(weights) * (-1.0) ** np.arange(len(points))
    return barycentric


def simulate(
    p: Parameters,
    *,
    V: float,
    d: float,
    x0: float = 0.0,
    y0: float = 0.0,
    vx0: float = 0.0,
    vy0: float = 0.0,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
) -> Trajectory:
    """Integrate the motion (8)–(11) from an initial state.

    The integrator is restarted at every kink of the field, y = 0 and x' = V, whether or not the events are
    kept.

    Parameters
    ----------
    p : Parameters
        Scalars.
    V : float
        Belt speed over L_0 sqrt(k_c/m), V ≥ 0. The article states none; 0.5 is this package's assumption for
        its Figure 7.
    d : float
        Steepness of the friction law (10), times L_0 sqrt(k_c/m), d > 0. Likewise; 10 is the assumption.
    x0, y0, vx0, vy0 : float
        Initial state; rest at x = y = 0 by default, which lies on a kink.
    t_end : float
        Until when, in sqrt(m/k_c).
    rtol : float
        Relative tolerance of a step, in [1e-13, 1e-2]; the absolute one is a thousandth of it.
    events : bool
        Keep the events.
    estimate_error : bool
        Run again, at rtol/100 or the tightest there is, and keep the difference as ``error``.
    backend : {"heyoka", "scipy"}, optional
        Taylor series (extra ``fast``) or DOP853; by default heyoka where it is installed. They agree to the
        tolerance.
    max_steps : int
        Where to give up. A smooth motion takes a few steps per time unit; a stiff one, of large d, up to d times the
        friction, as it creeps. Ten million take heyoka some ten seconds to a minute, and several GB to keep.

    Returns
    -------
    Trajectory

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and an initial state at the spring's anchor, where L = 0 and (8) is
        singular.
    ConvergenceError
        When the integrator cannot go on, or has made ``max_steps``.
    MissingExtraError
        When the backend asked for is not installed.

    Notes
    -----
    Source: (8)–(11).

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.dynamics import simulate
    >>> tr = simulate(ss.Parameters.article(theta0=np.radians(49)), V=0.5, d=10.0)
    >>> round(tr.rms(transient=1500.0), 4), len(tr.events)
    (1.8052, 259)
    """
    problem = prepare(p, V=V, d=d, start=(x0, y0, vx0, vy0), t_end=t_end, t_record=0.0, rtol=rtol, max_steps=max_steps)
    chosen = integrators.choose(backend)
    trajectory = run(p, problem, chosen)
    if estimate_error:
        reference = run(p, replace(problem, rtol=max(problem.rtol / 100, TIGHTEST)), chosen)
        difference = np.abs(trajectory.state - reference(np.minimum(trajectory.t, reference.t[-1]))).max(
            axis=0
        )
        trajectory = replace(trajectory, error=difference)
    return trajectory if events else replace(trajectory, events=None)


def prepare(
    p: Parameters, *, V: float, d: float, start: tuple[Any, ...], t_end: float, t_record: float, rtol: float,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """Validated arguments of a motion."""
    cos0, sin0, mu0, kappa, alpha, sigma, beta = _constants(p)
    x0, y0, vx0, vy0 = (
        as_number(name, value, FINITE) for name, value in zip(("x0", "y0", "vx0", "vy0"), start, strict=True)
    )
    check_start(cos0, sin0, x0, y0)
    t_end = as_number("t_end", t_end, POSITIVE)
    return Problem(
        cos0, sin0, mu0, kappa, alpha, sigma, beta, as_number("V", V, BELT_SPEED), as_number("d", d, CREEP),
        (x0, y0, vx0, vy0), t_end, t_record, as_number("rtol", rtol, TOLERANCE), as_steps(max_steps),
    )  # fmt: skip


def check_start(cos0: float, sin0: float, x0: float, y0: float) -> None:
    """Raise for a start at the spring's anchor."""
    if (x0, y0) == (cos0, sin0):
        raise ParameterError(
            f"x0 = {x0:.17g}, y0 = {y0:.17g} is the spring's anchor (cos theta0, sin theta0), "
            "where L = 0 and the spring has no direction; start anywhere else"
        )


def as_steps(max_steps: int) -> int:
    """A number of steps, at least one."""
    if isinstance(max_steps, bool) or not isinstance(max_steps, int | np.integer):
        raise ParameterTypeError(f"max_steps = {max_steps!r} is not an int")
    if max_steps < 1:
        raise ParameterError(f"max_steps = {max_steps} is not at least 1; leave it out for {MAX_STEPS}")
    return int(max_steps)


def run(p: Parameters, problem: Problem, backend: str) -> Trajectory:
    """The motion of a validated problem."""
    result = integrators.integrate(problem, backend)
    events = Events(result.event_t, result.event_states, result.event_kinds)
    x, y, vx, vy = result.states
    return Trajectory(result.t, x, y, vx, vy, events, p, problem.V, problem.d, problem.rtol, backend)


def course(problem: Problem, backend: str) -> Course:
    """What is measured of the motion of a validated problem after ``t_record``."""
    if backend == "heyoka":
        return integrators.watch(problem)
    return run(regimes.parameters(problem), problem, backend).course()


def flow(problem: Problem, backend: str) -> regimes.Flow:
    """The motion of a problem from any state, for as long as asked."""

    def onward(state: FloatArray, duration: float) -> Course:
        return course(replace(problem, start=tuple(state.tolist()), t_end=duration, t_record=0.0), backend)

    return onward


def _constants(p: Parameters) -> tuple[float, ...]:
    theta0, *rest = p.scalars(*NAMES)
    return (float(np.cos(theta0)), float(np.sin(theta0)), *rest)
