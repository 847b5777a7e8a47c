"""Motion in time: trajectories, what happens along them, and what they settle to."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ParameterError
from ..files import storage
from ..generated import motion
from ..parameters import FloatArray, Parameters, degrees
from . import forces, integrators, pictures, spectra
from .course import event_counts
from .events import Events
from .problem import MAX_STEPS, Constants, Event, Problem, constants_of, prepare
from .recorded import Recorded
from .regimes import Outcome
from .rest import index_of

__all__ = ["Event", "Events", "Trajectory", "simulate"]

#: The smallest tolerance that SciPy accepts, for the second run of an error estimate.
TIGHTEST = 2.3e-14

#: What the samples of a trajectory hold.
COMPONENTS = ("x", "y", "vx", "vy")


@dataclass(frozen=True, eq=False)
class Trajectory(Recorded):
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
    rtol : float
        The tolerance.
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
    rtol: float
    backend: str
    error: FloatArray | None = None

    @property
    def components(self) -> tuple[str, ...]:
        return COMPONENTS

    @property
    def V(self) -> float:
        """Belt speed."""
        return float(self.p.V)

    @property
    def d(self) -> float:
        """Steepness of the friction law."""
        return float(self.p.d)

    @cached_property
    def state(self) -> FloatArray:
        """x, y, x', y' at the samples, shape (4, n)."""
        return np.array([self.x, self.y, self.vx, self.vy])

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
        self._values(of)
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
        return pictures.course_over_time(self.after(transient), of, ax)

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
        values = dict(zip(self.p.ranges, self.p.scalars(*self.p.ranges), strict=True))
        return {
            **storage.provenance(),
            **values,
            "theta0_deg": degrees(values["theta0"]),
            "rtol": self.rtol,
            "backend": self.backend,
        }

    def _constants(self) -> Constants:
        return constants_of(self.p.scalars(*self.p.ranges))

    def _with(self, t: FloatArray, state: FloatArray, events: Events | None, error: FloatArray | None) -> Trajectory:
        return replace(self, t=t, x=state[0], y=state[1], vx=state[2], vy=state[3], events=events, error=error)

    def _problem(self, start: tuple[float, ...], length: float) -> Problem:
        return prepare(self.p, start=start, t_end=length, rtol=self.rtol)

    def _identified(self, found: Outcome) -> Outcome:
        where = np.array(found.rest_x), np.array(found.rest_y)
        return replace(found, equilibrium=int(index_of(self.p, *where)))

    def _event_counts(self) -> NDArray[np.intp]:
        return event_counts(self.samples, self.V)


def simulate(
    p: Parameters,
    *,
    V: float | None = None,
    d: float | None = None,
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
    V, d : float, optional
        In place of those of ``p``, which are this package's assumption, 0.5 and 10, unless they were given: the article
        states neither.
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
    backend : {"heyoka", "compiled", "scipy"}, optional
        Taylor series (extra ``fast``), or DOP853 in compiled code or in Python; by default the first of these that
        is installed. They agree to the tolerance.
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
    p = p.given(V=V, d=d)
    problem = prepare(p, start=start, t_end=t_end, rtol=rtol, max_steps=max_steps)
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
    x, y, vx, vy = solution.samples.states
    return Trajectory(solution.samples.t, x, y, vx, vy, events, p, problem.rtol, backend)
