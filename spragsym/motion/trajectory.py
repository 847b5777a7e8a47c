"""Motion in time: trajectories of any model, what happens along them, and what they settle to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Table, caption, words
from ..errors import ParameterError, ParameterTypeError
from ..files import storage
from ..models import forces
from ..models.field import Field
from ..models.parameters import FINITE, FloatArray, ParameterSet, as_number, as_numbers, degrees
from ..names import hint
from ..questions import model_of
from . import integrators, pictures, spectra
from .events import Events, events_of
from .problem import MAX_STEPS, Event, Problem
from .problems import prepare
from .regimes import Outcome
from .sampled_motion import Recorded

__all__ = ["Event", "Events", "Trajectory", "initial_state", "simulate"]

#: The smallest tolerance that SciPy accepts, for the second run of an error estimate.
TIGHTEST = 2.3e-14


@dataclass(frozen=True, eq=False)
class Trajectory(Recorded):
    """A motion in time, as accurate between the samples as on them.

    The samples are the Gauss–Lobatto points of every step that the integrator took, its ends and all events
    among them: ``degree + 1`` to a step, consecutive steps sharing one. The motion is the polynomial through
    them, so that integrals and values in between lose nothing against the integration. A coordinate or its rate is an
    attribute of its name, as ``tr.x`` and ``tr.vx``.

    Attributes
    ----------
    model : Model
        Its page says the units; the article's are sqrt(m/k_c) for times, L_0 for lengths, k_c L_0 for forces.
    p : Parameters of the model
        Scalars.
    t : ndarray, shape (k,)
        Time in the model's unit.
    state : ndarray, shape (2 n, k)
        The n coordinates, then their rates; x, y, x', y' for the article's model.
    events : Events or None
        Contact lost and regained, slip reversed; None when not asked for.
    rtol : float
        The tolerance.
    backend : str
        Which integrator ran.
    error : ndarray, shape (k,), or None
        Largest of the 2 n |differences| to a second run at a tighter tolerance; None when not asked for.
    implicit : bool
        Whether the motion is stiff, and SciPy's Radau carried it, as the steps of ``backend`` collapsed.
    """

    model: Any
    p: Any
    t: FloatArray
    state: FloatArray
    events: Events | None
    rtol: float
    backend: str
    error: FloatArray | None = None
    implicit: bool = False

    @property
    def components(self) -> tuple[str, ...]:
        return (*self.model.coordinates, *self.model.rates)

    @property
    def offered(self) -> tuple[str, ...]:  # type: ignore[override]
        return self.components

    def data(self) -> dict[str, Any]:
        """Time and every component, at the samples."""
        return {"t": self.t, **{name: getattr(self, name) for name in self.components}}

    def __getattr__(self, name: str) -> FloatArray:
        if "model" not in self.__dict__:  # while it is copied or unpickled
            raise AttributeError(name)
        if name.startswith("_") or name not in self.components:
            raise AttributeError(f"a motion of {self.model.name} has no {name!r}{hint(name, self.components)}")
        row: FloatArray = self.state[self.components.index(name)]
        return row

    def as_table(self) -> Table:
        """First, smallest, largest and last value of each coordinate and rate, in place of all samples."""
        said, t = words(self), self.t
        rows = [
            (said.heading(key), *(said.cell(key, value) for value in (values[0], values.min(), values.max(), values[-1])))
            for key, values in zip(self.components, self.state, strict=True)
        ]
        known: dict[str, Any] = {
            "model": self.model.name,
            "p": self.p,
            "rtol": self.rtol,
            "backend": "SciPy's Radau" if self.implicit else self.backend,
        }
        known |= {} if self.events is None else {"events": len(self.events)}
        title = caption(said, f"Trajectory, t = {said.cell('t', t[0])} to {said.cell('t', t[-1])}", known, f"{len(t)} samples")
        return Table(title, ("", "first", "smallest", "largest", "last"), tuple(rows))

    def energy(self) -> FloatArray:
        """Kinetic and stored energy, contact and applied forces included, at the samples."""
        energy: FloatArray = self.model.algebra.energy(*self.state, *self._arguments(), self._pushing())
        return energy

    def friction_power(self) -> FloatArray:
        """Rate at which friction changes that energy, at the samples: positive where it drives the motion."""
        motion, taken = self.model.algebra, self._arguments()
        _, slip = motion.borders(*self.state, *taken)
        side, felt = np.where(slip >= 0, 1, -1), [1] * self.model.about["layers"]
        power: FloatArray = motion.friction_power(*self.state, *taken, self._pushing(), side, *felt)
        return power

    def power(self) -> FloatArray:
        """Rate at which friction, dampers and forces without a potential change that energy, at the samples."""
        motion, taken = self.model.algebra, self._arguments()
        others = motion.damper_power(*self.state, *taken) + motion.applied_power(*self.state, *taken)
        power: FloatArray = self.friction_power() + others
        return power

    def spring_force(self, spring: str | None = None) -> FloatArray:
        """Tension of an inclined spring at the samples, negative where it pushes; ``spring`` names one of several."""
        name = forces.spring_named(self.model, spring)
        return forces.told_of(self.model)[name](self.state, self._arguments())

    def contact_force(self) -> FloatArray:
        """Normal force of the contact at the samples: 0 where the mass has lifted off."""
        return forces.contact_force(self.model, self.state, self._arguments())

    def spectrum(self, transient: float | None = None, *, of: str | None = None, points: int = 4096) -> spectra.Spectrum:
        """Amplitudes over frequency, in cycles per unit of time, of the motion after ``transient``; see :mod:`.spectra`."""
        return spectra.spectrum_of(self.after(transient).samples, self._row(of, self.components), points)

    def decay_rate(self, transient: float = 0.0, *, of: str | None = None) -> float:
        """The rate at which the swings of a coordinate shrink after ``transient``; negative where they grow.

        NaN where there are fewer than two swings. For motions that decay to rest; towards a cycle see :meth:`outcome`.
        """
        row, n = self._row(of, self.model.coordinates), len(self.model.coordinates)
        late = self.after(transient)
        speed = late.state[row + n]
        lowest = late.samples.passages(speed, lambda state: state[row + n])
        extrema = np.concatenate([lowest, late.samples.passages(-speed, lambda state: -state[row + n])])
        return spectra.decay_rate_of(extrema, late.samples(extrema)[row])

    def plot(self, ax: Any = None, *, transient: float = 0.0, of: str | None = None) -> Any:  # type: ignore[override]  # names its options
        """Draw x, the first coordinate, over time, or another component (extra ``plot``); returns the line."""
        row = self._row(of, self.components)
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
        return pictures.course_over_time(self.after(transient), self.components[row], ax)

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``)."""
        data: dict[str, Any] = {name: ("t", getattr(self, name)) for name in self.components}
        if self.error is not None:
            data["error"] = ("t", self.error)
        coords: dict[str, Any] = {"t": self.t}
        if self.events is not None:
            coords["event_t"] = self.events.t
            data["event"] = ("event_t", self.events.which.astype(np.int8))
        dataset = storage.xarray().Dataset(data, coords=coords, attrs=self._attributes())
        for name in dataset.variables:
            dataset[name].attrs = storage.attributes(name, self.model.quantities)
        if self.events is not None:
            dataset["event"].attrs |= {
                "flag_values": np.array(list(Event), dtype=np.int8),
                "flag_meanings": " ".join(kind.name.lower() for kind in Event),
            }
        return dataset

    def _save_columns(self, path: Path) -> None:
        """Write netCDF to ``*.nc`` (extra ``sweep``), with the events, or the samples alone to ``*.csv``."""
        storage.write(path, self.to_dataset, self.data, self._attributes(), self.model.quantities)

    # -------------------------------------------------------------------------------------------- inner parts

    def _row(self, of: str | None, offered: tuple[str, ...]) -> int:
        if of is not None and of not in offered:
            raise ParameterError(f"of = {of!r} is not one of {', '.join(offered)}")
        return 0 if of is None else offered.index(of)

    def _arguments(self) -> list[float]:
        return [float(value) for value in self.model.arguments(self.p, "motion")]

    def _pushing(self) -> NDArray[np.intp]:
        gap, _ = self.model.algebra.borders(*self.state, *self._arguments())
        return (gap < 0).astype(int) if self.model.about["contact"]["unilateral"] else np.ones(len(self.t), dtype=int)

    def _with(self, t: FloatArray, state: FloatArray, events: Events | None, error: FloatArray | None) -> Trajectory:
        return replace(self, t=t, state=state, events=events, error=error)

    def _problem(self, start: tuple[float, ...], length: float) -> Problem:
        return prepare(self.model, self.p, start=start, t_end=length, rtol=self.rtol)

    def _identified(self, found: Outcome) -> Outcome:
        from ..statics.search import rest_index

        return replace(found, equilibrium=int(rest_index(self.p, np.array(found.rest)))) if found.rest else found

    def _event_counts(self) -> NDArray[np.intp]:
        """How often each kind of event happened, from the samples alone, which include all events."""
        gap, slip = self.model.algebra.borders(*self.state, *self._arguments())
        levels = [gap if self.model.about["contact"]["unilateral"] else np.ones_like(gap), -slip]
        changes = [np.diff((level > 0).astype(int)) for level in levels]
        return np.array([np.count_nonzero(change == sign) for change in changes for sign in (1, -1)])

    def _attributes(self) -> dict[str, Any]:
        values = dict(zip(self.model.parameters, self.p.scalars(*self.model.parameters), strict=True))
        angles = {f"{name}_deg": degrees(values[name]) for name in self.model.about["angles"]}
        settings = {"rtol": self.rtol, "backend": self.backend}
        return {**storage.provenance(), "model": self.model.name, **values, **angles, **settings}


def simulate(
    p: ParameterSet,
    *,
    V: float | None = None,
    d: float | None = None,
    start: ArrayLike | None = None,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    **initial: float,
) -> Trajectory:
    """Integrate the motion of a model from an initial state, the article's (8)–(11) among them.

    The integrator is restarted at every kink of the field, y = 0 and x' = V for the article's model, whether or not the
    events are kept.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    V, d : float, optional
        In place of those of ``p``, for models that have them. The article states neither: 0.5 and 10, unless they are given,
        are this package's assumption.
    start : array_like, shape (2 n,), optional
        Coordinates, then rates.
    x0, y0, vx0, vy0, … : float, optional
        The same one by one, by the names of the model's coordinates and rates; 0 where nothing is given. For the article's
        model that is rest at x = y = 0, which lies on a kink.
    t_end : float
        Until when, in the model's unit of time: sqrt(m/k_c).
    rtol : float
        Relative tolerance of a step, in [1e-13, 1e-2]; the absolute one is a thousandth of it.
    events : bool
        Keep the events.
    estimate_error : bool
        Run again, at rtol/100 or the tightest there is, and keep the difference as ``error``.
    backend : {"heyoka", "compiled", "scipy"}, optional
        Taylor series (extra ``fast``), or DOP853 in compiled code (the article's model) or in Python; by default the first of
        these that is installed. They agree to the tolerance.
    max_steps : int
        Where to give up. A smooth motion takes a few steps per time unit; a stiff one, of large d, up to d times the
        friction, as it creeps. Ten million take heyoka some ten seconds to a minute, and several GB to keep.

    Returns
    -------
    Trajectory

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and a start at which a spring has no length: at the article's anchor (8) is singular.
    ConvergenceError
        When the integrator cannot go on, or has made ``max_steps``.
    MissingExtraError
        When the backend asked for is not installed.

    Notes
    -----
    Source: the page's equations of motion; (8)–(11).

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> tr = ss.simulate(ss.Parameters.article(theta0=np.radians(49)), V=0.5, d=10.0)
    >>> round(tr.rms(transient=1500.0), 4), len(tr.events)
    (1.8052, 259)
    >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
    >>> tr.components, round(tr.largest(), 2)
    (('x', 'vx'), 0.61)
    """
    model, p = model_of(p), p.given(V=V, d=d)
    state = tuple(as_number(name, value) for name, value in initial_state(model, start, initial).items())
    problem = prepare(model, p, start=state, t_end=t_end, rtol=rtol, max_steps=max_steps)
    chosen = integrators.choose(backend, integrators.offered_for(model))
    trajectory = _run(model, p, problem, chosen)
    if estimate_error:
        reference = _run(model, p, replace(problem, rtol=max(problem.rtol / 100, TIGHTEST)), chosen)
        difference = np.abs(trajectory.state - reference(np.minimum(trajectory.t, reference.t[-1]))).max(axis=0)
        trajectory = replace(trajectory, error=difference)
    return trajectory if events else replace(trajectory, events=None)


def initial_state(model: Any, start: ArrayLike | None, initial: Mapping[str, ArrayLike]) -> dict[str, FloatArray]:
    """The initial state by names, ``x0`` for ``x`` and ``vx0`` for ``vx``; 0 where nothing is given."""
    names = [f"{name}0" for name in (*model.coordinates, *model.rates)]
    values: dict[str, ArrayLike] = dict.fromkeys(names, 0.0)
    if start is not None:
        given = as_numbers("start", start)
        if given.shape != (len(names),):
            raise ParameterError(f"start has the shape {given.shape}; it is {', '.join(names)}")
        values |= zip(names, given, strict=True)
    for name, value in initial.items():
        if name not in values:
            remedy = hint(name, names) or "; the initial state is " + ", ".join(names)
            if name in model.parameters:
                remedy = f" but a parameter; give it within the first one, as p.replace({name}=...)"
            raise ParameterTypeError(f"{name} is no argument{remedy}")
        values[name] = value
    return {name: as_numbers(name, value) for name, value in values.items()}


def state_of(model: Any, start: ArrayLike | None) -> FloatArray:
    """One initial state as an array; rest where nothing is given."""
    return np.array([as_number("start", value, FINITE) for value in initial_state(model, start, {}).values()])


def motion_of(field: Field, values: Sequence[float], state: FloatArray, t_end: float, **options: Any) -> Trajectory:
    """The motion of the model of a field, by the values of its parameters in order."""
    p = field.parameter_set(**dict(zip(field.parameters, values, strict=True)))
    return simulate(p, start=np.asarray(state), t_end=t_end, **options)


def _run(model: Any, p: ParameterSet, problem: Problem, backend: str) -> Trajectory:
    solution = integrators.integrate(problem, backend)
    events = events_of(problem.field, solution.crossings)
    return Trajectory(
        model, p, solution.samples.t, solution.samples.states, events, problem.rtol, backend, implicit=solution.implicit
    )
