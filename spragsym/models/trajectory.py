"""Motion of a model in time."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics import integrators
from ..dynamics.events import Events
from ..dynamics.problem import MAX_STEPS, RELATIVE_TOLERANCE, Event, Problem, as_steps
from ..dynamics.recorded import Recorded
from ..dynamics.regimes import Outcome
from ..dynamics.trajectory import TIGHTEST
from ..errors import ParameterError, ParameterTypeError
from ..files import storage
from ..names import hint
from ..parameters import POSITIVE, FloatArray, ParameterSet, as_number, as_numbers, degrees
from .describe import explained
from .field import field_of

if TYPE_CHECKING:
    from .model import Model


@dataclass(frozen=True, eq=False)
class ModelTrajectory(Recorded):
    """A motion of a model in time, as accurate between the samples as on them.

    The samples are the Gauss–Lobatto points of every step that the integrator took, its ends and all events among them. A
    coordinate or its rate is an attribute of its name, as ``tr.x`` and ``tr.vx``.

    Attributes
    ----------
    model : Model
    p : Parameters of the model
        Scalars.
    t : ndarray, shape (k,)
        Time in the model's unit.
    state : ndarray, shape (2 n, k)
        The coordinates, then their rates.
    events : Events or None
        Contact lost and regained, slip reversed; None when not asked for.
    rtol : float
        Tolerance.
    backend : str
        Which integrator ran.
    error : ndarray, shape (k,), or None
        Largest difference to a second run at a tighter tolerance; None when not asked for.
    """

    model: Model
    p: Any
    t: FloatArray
    state: FloatArray
    events: Events | None
    rtol: float
    backend: str
    error: FloatArray | None = None

    @property
    def components(self) -> tuple[str, ...]:
        return (*self.model.coordinates, *self.model.rates)

    def __getattr__(self, name: str) -> FloatArray:
        if "model" not in self.__dict__:  # while it is copied or unpickled
            raise AttributeError(name)
        if name.startswith("_") or name not in self.components:
            raise AttributeError(f"a motion of {self.model.name} has no {name!r}{hint(name, self.components)}")
        row: FloatArray = self.state[self.components.index(name)]
        return row

    def energy(self) -> FloatArray:
        """Kinetic and stored energy, contact and applied forces included, at the samples."""
        energy: FloatArray = self.model.motion.energy(*self.state, *self._arguments(), self._pushing())
        return energy

    def power(self) -> FloatArray:
        """Rate at which friction, dampers and forces without a potential change that energy, at the samples."""
        motion, taken = self.model.motion, self._arguments()
        _, slip = motion.borders(*self.state, *taken)
        side, felt = np.where(slip >= 0, 1, -1), [1] * self.model.about["layers"]
        friction = motion.friction_power(*self.state, *taken, self._pushing(), side, *felt)
        power: FloatArray = friction + motion.damper_power(*self.state, *taken) + motion.applied_power(*self.state, *taken)
        return power

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with provenance (extra ``sweep``)."""
        data: dict[str, Any] = {name: ("t", getattr(self, name)) for name in self.components}
        if self.error is not None:
            data["error"] = ("t", self.error)
        coords: dict[str, Any] = {"t": self.t}
        if self.events is not None:
            coords["event_t"] = self.events.t
            data["event"] = ("event_t", self.events.which.astype(np.int8))
        dataset = storage.xarray().Dataset(data, coords=coords, attrs=self._attributes())
        known = explained(self.model.about)
        for name in (*data, "t"):
            dataset[name].attrs = storage.attributes(name, known) if name in known else storage.attributes(name)
        if self.events is not None:
            dataset["event_t"].attrs = storage.attributes("event_t")
            dataset["event"].attrs |= {
                "flag_values": np.array(list(Event), dtype=np.int8),
                "flag_meanings": " ".join(kind.name.lower() for kind in Event),
            }
        return dataset

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write netCDF to ``*.nc`` (extra ``sweep``), with the events, or the samples alone to ``*.csv``."""
        columns = {"t": self.t, **{name: getattr(self, name) for name in self.components}}
        storage.write(Path(path), self.to_dataset, lambda: columns, self._attributes(), explained(self.model.about))

    # -------------------------------------------------------------------------------------------- inner parts

    def _arguments(self) -> list[float]:
        return [float(value) for value in self.model.arguments(self.p, "motion")]

    def _pushing(self) -> NDArray[np.intp]:
        gap, _ = self.model.motion.borders(*self.state, *self._arguments())
        return (gap < 0).astype(int) if self.model.about["contact"]["unilateral"] else np.ones(len(self.t), dtype=int)

    def _with(self, t: FloatArray, state: FloatArray, events: Events | None, error: FloatArray | None) -> ModelTrajectory:
        return replace(self, t=t, state=state, events=events, error=error)

    def _problem(self, start: tuple[float, ...], length: float) -> Problem:
        return prepare(self.model, self.p, start=start, t_end=length, rtol=self.rtol)

    def _identified(self, found: Outcome) -> Outcome:
        return found

    def _event_counts(self) -> NDArray[np.intp]:
        gap, slip = self.model.motion.borders(*self.state, *self._arguments())
        levels = [gap if self.model.about["contact"]["unilateral"] else np.ones_like(gap), -slip]
        changes = [np.diff((level > 0).astype(int)) for level in levels]
        return np.array([np.count_nonzero(change == sign) for change in changes for sign in (1, -1)])

    def _attributes(self) -> dict[str, Any]:
        values = dict(zip(self.model.parameters, self.p.scalars(*self.model.parameters), strict=True))
        angles = {f"{name}_deg": degrees(values[name]) for name in self.model.about["angles"]}
        settings = {"rtol": self.rtol, "backend": self.backend}
        return {**storage.provenance(), "model": self.model.name, **values, **angles, **settings}


def start_of(model: Model, start: ArrayLike | None, single: Mapping[str, ArrayLike]) -> dict[str, FloatArray]:
    """The initial state by names, ``x0`` for ``x`` and ``vx0`` for ``vx``; 0 where nothing is given."""
    names = [f"{name}0" for name in (*model.coordinates, *model.rates)]
    values: dict[str, ArrayLike] = dict.fromkeys(names, 0.0)
    if start is not None:
        given = as_numbers("start", start)
        if given.shape != (len(names),):
            raise ParameterError(f"start has the shape {given.shape}; it is {', '.join(names)}")
        values |= zip(names, given, strict=True)
    for name, value in single.items():
        if name not in values:
            raise ParameterTypeError(f"{name} is no argument{hint(name, names) or '; the initial state is ' + ', '.join(names)}")
        values[name] = value
    return {name: as_numbers(name, value) for name, value in values.items()}


def check_start(model: Model, constants: tuple[float, ...], start: tuple[float, ...]) -> None:
    """Raise for a start where a spring has no length, and so no direction."""
    n = len(model.coordinates)
    known = dict(zip(model.about["arguments"]["motion"], constants, strict=True))
    taken = [known[name] for name in model.about["arguments"]["statics"]]
    for row, (dx, dy, _) in enumerate(model.statics.geometry(*start[:n], *taken)):
        if dx == 0 and dy == 0:
            name = model.about["springs"][row]["name"]
            raise ParameterError(f"the start {start[:n]} puts both ends of {name} on one point, where it has no direction")


def prepare(
    model: Model, p: ParameterSet, *, start: tuple[float, ...], t_end: float, rtol: float, t_record: float = 0.0,
    max_steps: int = MAX_STEPS,
) -> Problem:  # fmt: skip
    """The problem of these arguments, each of which is checked."""
    p.scalars(*model.parameters)
    constants = tuple(float(value) for value in model.arguments(p, "motion"))
    check_start(model, constants, start)
    t_end, rtol = as_number("t_end", t_end, POSITIVE), as_number("rtol", rtol, RELATIVE_TOLERANCE)
    return Problem(constants, start, t_end, t_record, rtol, as_steps(max_steps), partial(field_of, model))


def simulate(
    model: Model,
    p: ParameterSet,
    *,
    start: ArrayLike | None = None,
    t_end: float = 2000.0,
    rtol: float = 1e-10,
    events: bool = True,
    estimate_error: bool = False,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    **single: float,
) -> ModelTrajectory:
    """Integrate the motion of a model; see :meth:`spragsym.Model.simulate`."""
    parts = start_of(model, start, single)
    state = tuple(as_number(name, value) for name, value in parts.items())
    problem = prepare(model, p, start=state, t_end=t_end, rtol=rtol, max_steps=max_steps)
    chosen = integrators.choose(backend, integrators.OF_ANY_MODEL)
    trajectory = _run(model, p, problem, chosen)
    if estimate_error:
        reference = _run(model, p, replace(problem, rtol=max(problem.rtol / 100, TIGHTEST)), chosen)
        difference = np.abs(trajectory.state - reference(np.minimum(trajectory.t, reference.t[-1]))).max(axis=0)
        trajectory = replace(trajectory, error=difference)
    return trajectory if events else replace(trajectory, events=None)


def _run(model: Model, p: ParameterSet, problem: Problem, backend: str) -> ModelTrajectory:
    solution = integrators.integrate(problem, backend)
    events = Events(solution.event_t, solution.event_states, solution.event_kinds)
    return ModelTrajectory(model, p, solution.samples.t, solution.samples.states, events, problem.rtol, backend)
