"""Motion in time: trajectories, what happens along them, and what they settle to."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Result
from ..errors import ParameterError
from ..files import storage
from ..generated import motion
from ..parameters import NAMES, NOT_NEGATIVE, POSITIVE, FloatArray, Parameters, as_number, as_numbers, degrees
from . import forces, integrators, spectra
from .classify import classify
from .course import Course, course_of, event_counts
from .lobatto import PiecewisePolynomial
from .problem import MAX_STEPS, Constants, Event, Problem, constants_of, prepare
from .regimes import SETTLED, Outcome, Regime
from .rest import index_of

__all__ = ["Event", "Events", "Trajectory", "simulate"]

#: The smallest tolerance that SciPy accepts, for the second run of an error estimate.
TIGHTEST = 2.3e-14

#: What the samples of a trajectory hold.
COMPONENTS = ("x", "y", "vx", "vy")


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
    def samples(self) -> PiecewisePolynomial:
        """The polynomials through the samples."""
        return PiecewisePolynomial(self.t, self.state)

    @cached_property
    def weights(self) -> FloatArray:
        """Quadrature weights, shape (n,): ``(weights * f).sum()`` is the integral of f over time."""
        return self.samples.weights()

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
        return self.samples(times)

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
        late = self.samples.after(transient)
        t, state = late.t, late.states
        error = None if self.error is None else np.interp(t, self.t, self.error)
        events = self.events
        if events is not None:
            kept = events.t >= transient
            events = Events(events.t[kept], events.state[kept], events.which[kept])
        return replace(self, t=t, x=state[0], y=state[1], vx=state[2], vy=state[3], events=events, error=error)

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
        """What the motion settles to or approaches, how fast, and the distance left, judged by the motion after ``transient``.

        The same as a :class:`~spragsym.Sweep` tells of it. A cycle is found by Newton's method on its return map, which
        integrates a few periods more.
        """
        late = self.after(transient)
        start, length = tuple(late.state[:, 0].tolist()), float(late.t[-1] - late.t[0])
        problem = prepare(self.p, V=self.V, d=self.d, start=start, t_end=length, rtol=self.rtol)
        flow = integrators.flow(problem, self.backend)
        found = classify(late.course(), problem, flow, as_number("tol", tol, POSITIVE))
        where = np.array(found.rest_x), np.array(found.rest_y)
        return replace(found, equilibrium=int(index_of(self.p, self.V, self.d, *where)))

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
        x, y, vx, vy = self.state
        c = self._constants()
        energy: FloatArray = motion.energy(x, y, vx, vy, c.cos0, c.sin0, c.kappa, c.alpha, c.sigma, c.beta, y < 0)
        return energy

    def friction_power(self) -> FloatArray:
        """Rate at which friction changes that energy, at the samples: positive where it drives the mass."""
        side = np.where(self.vx <= self.V, 1, -1)
        (mu0,) = self.p.scalars("mu0")
        power: FloatArray = motion.friction_power(self.y, self.vx, mu0, self.V, self.d, self.y < 0, side)
        return power

    def spring_force(self) -> FloatArray:
        """Tension of the inclined spring over k_c L_0, at the samples: negative where it pushes."""
        c = self._constants()
        return forces.spring_force(self.x, self.y, c.cos0, c.sin0, c.sigma)

    def contact_force(self) -> FloatArray:
        """Force of the contact over k_c L_0, at the samples: 0 where the mass has lifted off."""
        return forces.contact_force(self.y)

    def spectrum(self, transient: float | None = None, *, of: str = "x", points: int = 4096) -> spectra.Spectrum:
        """Amplitudes over frequency, in cycles per sqrt(m/k_c), of the motion after ``transient``; see :mod:`.spectra`."""
        self._values(of)
        return spectra.spectrum_of(self.after(transient).samples, COMPONENTS.index(of), points)

    def decay_rate(self, transient: float = 0.0, *, of: str = "x") -> float:
        """The rate at which the swings of x or y shrink after ``transient``, over the unit of time; negative where they grow.

        NaN where there are fewer than two swings. For motions that decay to rest; towards a cycle see :meth:`outcome`.
        """
        if of not in ("x", "y"):
            raise ParameterError(f"of = {of!r} is neither 'x' nor 'y'")
        late, row = self.after(transient), COMPONENTS.index(of)
        speed = late.state[row + 2]
        lowest = late.samples.passages(speed, lambda state: state[row + 2])
        turns = np.concatenate([lowest, late.samples.passages(-speed, lambda state: -state[row + 2])])
        return spectra.decay_rate_of(turns, late.samples(turns)[row])

    def plot(self, transient: float = 0.0, *, of: str = "x", ax: Any = None) -> Any:
        """Draw x over time, or another component (extra ``plot``); returns the line."""
        from ..figures.motion_pictures import draw_motion

        self._values(of)
        return draw_motion(self.after(transient), of, ax=ax)

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``)."""
        data: dict[str, Any] = {name: ("t", getattr(self, name)) for name in COMPONENTS}
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
        columns = {name: getattr(self, name) for name in ("t", *COMPONENTS)}
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

    def _constants(self) -> Constants:
        return constants_of(self.p.scalars(*NAMES), self.V, self.d)

    def _values(self, of: str) -> FloatArray:
        if of not in COMPONENTS:
            raise ParameterError(f"of = {of!r} is not one of {', '.join(COMPONENTS)}")
        return getattr(self, of)  # type: ignore[no-any-return]  # a column, by its name

    def _centre(self, of: str, about: str) -> float:
        if about not in ("zero", "mean"):
            raise ParameterError(f"about = {about!r} is neither 'zero' nor 'mean'")
        return self.mean(0.0, of=of) if about == "mean" else 0.0

    def _extrema(self, of: str) -> FloatArray:
        """Values at the ends and at all local extrema of x or y; the samples themselves for speeds."""
        values = self._values(of)
        row = COMPONENTS.index(of)
        if row > 1:
            return values
        speed = self.state[row + 2]
        lowest = self.samples.passages(speed, lambda state: state[row + 2])
        highest = self.samples.passages(-speed, lambda state: -state[row + 2])
        return np.concatenate([values[[0, -1]], self.samples(lowest)[row], self.samples(highest)[row]])

    def course(self) -> Course:
        """The quantities of :func:`~spragsym.dynamics.integrators.measure`, from the samples."""
        if self.events is None:
            return course_of(self.samples, event_counts(self.samples, self.V))
        return course_of(self.samples, np.bincount(self.events.which, minlength=len(Event)))


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
    start = (x0, y0, vx0, vy0)
    problem = prepare(p, V=V, d=d, start=start, t_end=t_end, rtol=rtol, max_steps=max_steps)
    chosen = integrators.choose(backend)
    trajectory = _run(p, problem, chosen)
    if estimate_error:
        reference = _run(p, replace(problem, rtol=max(problem.rtol / 100, TIGHTEST)), chosen)
        difference = np.abs(trajectory.state - reference(np.minimum(trajectory.t, reference.t[-1]))).max(axis=0)
        trajectory = replace(trajectory, error=difference)
    return trajectory if events else replace(trajectory, events=None)


def _run(p: Parameters, problem: Problem, backend: str) -> Trajectory:
    solution = integrators.integrate(problem, backend)
    events = Events(solution.event_t, solution.event_states, solution.event_kinds)
    V, d = problem.constants[-2:]
    x, y, vx, vy = solution.samples.states
    return Trajectory(solution.samples.t, x, y, vx, vy, events, p, V, d, problem.rtol, backend)
