"""Sweeps: many motions over arrays of parameters and initial states, each reduced to averages after
a transient and the limit that it approaches. They run on all cores and can be resumed.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from dataclasses import field as attribute
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.error_states import in_usual_state
from ...core.errors import ConvergenceError, ParameterError
from ...core.questions import model_of, require_answered
from ...display import Column, following, own_name
from ...files import storage
from ...files.journal import Record
from ...models.field import Field, field_of
from ...models.parameters import (
    NOT_NEGATIVE,
    POSITIVE,
    FloatArray,
    ParameterSet,
    as_count,
    as_number,
)
from ...numerics.interval_arrays import Int8Array
from ...results.result import Named, with_degrees
from ...statics.search import rest_index
from .. import integrators
from ..classify import classify
from ..measures import MotionStatistics
from ..options import MotionOptions
from ..problem import MAX_STEPS, RELATIVE_TOLERANCE, Event, Problem, out_of_range, start_error
from ..regimes import LIMITS, Outcome, Regime
from ..return_map import Onward
from ..simulation import initial_state, started
from ..with_heyoka import LANES
from .workers import Computation, Workers, made_or_loaded

if TYPE_CHECKING:
    from ...models.model import Model


#: Version of the contents of a record. It must be increased when a change of code changes a number
#: in one: points in older stores are then computed again.
RECORDS = 1


@in_usual_state
def rms_sweep(
    p: ParameterSet,
    *,
    t_end: float = 2000.0,
    transient: float | None = None,
    rtol: float = 1e-10,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    options: MotionOptions | None = None,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
    **values: ArrayLike | None,
) -> Sweep:
    """Simulate a motion for every point of a broadcast of parameters and initial states; give its
    averages after a transient and its limit.

    Parameters
    ----------
    p : Parameters of any model
        Any shape.
    t_end, transient : float
        Duration of each motion, and the time before which it is ignored, by default three quarters
        of the duration.
    rtol : float
        Relative tolerance.
    backend : {"heyoka", "compiled", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    max_steps : int
        As for :func:`~spragsym.simulate`; a motion that needs more has failed.
    options : MotionOptions, optional
        Tolerances by which a limit is recognized.
    workers : int or map-like callable
        Number of processes, −1 for one per core; or ``map(function, tasks)`` of an engine, which
        may give results or futures with a ``result()``, in any order. A task is one point, or with
        heyoka up to 1024 points. Results do not depend on it, to the last bit.
    progress : bool
        Show a bar with the estimated end on stderr.
    store : path, optional
        ``*.nc`` or ``*.csv``. Finished tasks are written to ``<store>.partial``. After a kill the
        same call resumes from there; once the file is complete, it loads the file. Only one process
        may write to a store at a time.
    **values : array_like, optional
        Parameters and the initial state, as for :func:`~spragsym.simulate`; they broadcast with
        ``p``.

    Returns
    -------
    Sweep
        x stands for the model's first coordinate, and y for the second.

    Raises
    ------
    ParameterError, ParameterTypeError
        Before any integration, for invalid arguments and files that cannot be written. A motion
        that fails gives NaN and a reason; the sweep continues.
    SweepError
        For any other failure: memory, a missing package, a killed worker. The store keeps the
        finished points.
    StoreError
        When the store is damaged, full, or being written by another process.

    Notes
    -----
    Source: (8)–(11); the article's Figure 7b. The equilibria are those with the friction μ(V) of
    (10) in place of μ₀: at these the motion can rest.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.motion.sweeps import Regime, rms_sweep
    >>> sweep = rms_sweep(ss.Parameters.article(theta0=np.radians([40, 41, 44])), V=0.5, d=10.0)
    >>> np.round(sweep.rms, 1)
    array([0.1, 0.2, 1.7])
    >>> [Regime(code).name for code in sweep.regime]
    ['APPROACHES_EQUILIBRIUM', 'APPROACHES_EQUILIBRIUM', 'UNSETTLED']
    """
    require_answered("rms_sweep", p)
    model = model_of(p)
    p, initial = started(p, values)
    p.require(*model.parameters)
    inputs = {
        **{name: p[name] for name in model.parameters},
        **initial_state(model, None, initial, p),
    }
    t_end = as_number("t_end", t_end, POSITIVE)
    transient = (
        0.75 * t_end if transient is None else as_number("transient", transient, NOT_NEGATIVE)
    )
    if transient >= t_end:
        raise ParameterError(
            f"transient = {transient:g} is not below t_end = {t_end:g}; nothing would be left "
            "to measure"
        )
    rtol = as_number("rtol", rtol, RELATIVE_TOLERANCE)
    chosen = integrators.choose(backend, integrators.offered_for(model))
    integrators.check_rtol(model.field, rtol, chosen)
    settings = {
        "t_end": t_end,
        "transient": transient,
        "rtol": rtol,
        "backend": chosen,
        "max_steps": as_count("max_steps", max_steps),
        "options": options or MotionOptions(),
    }
    work, together = partial(measured, model, settings), partial(_together, settings)
    made = partial(_made_of, model, inputs, settings)
    key = partial(fingerprint, model, inputs, settings)
    columns = [own_name(model, name) for name in (*reported(model), "regime", "reason")]
    computation = Computation(inputs, work, made, columns[:-1], columns[-1], key, together)
    return made_or_loaded(computation, workers, progress, store)


def _together(settings: Mapping[str, Any], count: int, workers: int) -> int:
    """Number of motions in one task. No result depends on it, but a kill loses unfinished tasks.

    At most 1024 motions, with a total duration of 2e5; and so few that every worker gets 16 tasks.
    """
    if settings["backend"] != "heyoka":  # the others integrate one motion at a time
        return 1
    of_duration = max(LANES, int(2e5 / settings["t_end"]))
    return max(1, min(1024, of_duration, count // (16 * workers)))


#: Quantities that a sweep computes, in the order of its records: averages after the transient, then
#: the limit.
MEASURED = (
    Column("rms", "{x}", "root mean square of {x} about zero, after the transient"),
    Column("spread", "{x}", "root mean square of {x} about its mean, after the transient"),
    Column("largest", "{x}", "largest |{x}| after the transient"),
    Column("mean", "{x}", "mean of {x} after the transient"),
    Column("mean_{y}", "{y}", "mean of {y} after the transient"),
    Column("contact_lost", "1", "times contact was lost after the transient"),
    Column("slip_reversed", "1", "times the sliding speed changed its sign after the transient"),
    *LIMITS[2:],
)


@dataclass(frozen=True, eq=False)
class Sweep(Named):
    """Results of a sweep. All arrays have the common shape of the inputs; NaN if a motion failed.

    Attributes
    ----------
    inputs : dict of str to ndarray
        The model's parameters and initial state as given, which broadcast together; for the
        article's model θ₀, μ₀, κ, α, σ, β, V, d, x0, y0, vx0, vy0. Below, x is the model's first
        coordinate, and y stands for every other one.
    measured : dict of str to ndarray
        The quantities from ``rms`` to ``distance``. Each is an attribute by its name, too.
    rms, spread, largest, mean, mean_y : ndarray
        Averages after the transient, over L_0: root mean square of x about zero, and about its
        mean; largest \\|x\\|; means of x and y.
    contact_lost, slip_reversed : ndarray
        Number of these events after the transient. A reversal with sticking in between does not
        count.
    period, cycle_mean, cycle_rms : ndarray
        Period of the cycle that the motion is on or approaches; mean of x, and root mean square of
        x about zero, over this period. NaN for no cycle. Unlike ``mean`` and ``rms`` they do not
        depend on the transient.
    cycle_x, cycle_y, cycle_vx, cycle_vy : ndarray
        State of that cycle where x is largest, or 0 if x rotates; NaN for no cycle.
    rest_x, rest_y : ndarray
        Coordinates of the equilibrium that the motion is at or approaches; NaN for none.
    rate, distance : ndarray
        Asymptotic rate of the approach exp(−rate τ) to the limit, and distance to it at ``t_end``:
        relative to the extent of a cycle, over L_0 for rest. See
        :class:`~spragsym.motion.regimes.Outcome`.
    regime : ndarray of int8
        Codes of :class:`Regime`.
    equilibrium : ndarray of int8
        For ``Regime.EQUILIBRIUM`` and ``APPROACHES_EQUILIBRIUM`` the index of the equilibrium among
        those of ``equilibria(p)`` in contact at the friction μ(V); −1 otherwise.
    reason : ndarray of str
        Reason for which a motion failed.
    model : Model
        The model.
    options : MotionOptions
        Tolerances by which the limits were recognized.
    """

    schema = (
        *MEASURED,
        *LIMITS[:2],
        Column("{v}0", "{v}", "initial {v}"),
        Column("reason", "1", "why a point has no result"),
    )

    inputs: dict[str, FloatArray]
    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int
    measured: dict[str, FloatArray]
    regime: Int8Array
    equilibrium: Int8Array
    reason: NDArray[np.str_]
    model: Any
    options: MotionOptions = attribute(default_factory=MotionOptions)

    @property
    def _items(self) -> dict[str, NDArray[Any]]:
        return {**self.inputs, **self._words_and_measures()}

    def outcome(self, index: int | tuple[int, ...]) -> Outcome:
        """Outcome of one motion.

        Parameters
        ----------
        index : int or tuple of int
            Index of the motion in the arrays.

        Returns
        -------
        Outcome

        Examples
        --------
        >>> import numpy as np
        >>> import spragsym as ss
        >>> p = ss.load("stick_slip").Parameters(V=np.array([0.2, 2.5]))
        >>> sweep = ss.rms_sweep(p, t_end=300.0)
        >>> sweep.outcome(0).regime.name
        'LIMIT_CYCLE'
        """
        measures = {
            name: float(self.measured[self._own(name)][index]) for name in reported(self.model)
        }
        rest = [measures[f"rest_{name}"] for name in self.model.coordinates]
        cycle = [measures[f"cycle_{name}"] for name in self.model.components]
        numbers = ("rate", "distance", "period", "cycle_mean", "cycle_rms")
        return Outcome(
            Regime(int(self.regime[index])),
            int(self.equilibrium[index]),
            tuple(value for value in rest if not np.isnan(value)),
            cycle=tuple(value for value in cycle if not np.isnan(value)),
            names=self.model.components,
            **{name: measures[name] for name in numbers},
        )

    @property
    def _over(self) -> dict[str, FloatArray]:
        return self.inputs

    def _words_and_measures(self) -> dict[str, NDArray[Any]]:
        ours = {"regime": self.regime, "equilibrium": self.equilibrium, "reason": self.reason}
        measures = {self._own(name): one for name, one in ours.items()}
        return {**self.measured, **measures, **following(self)}

    def _columns(self) -> dict[str, NDArray[Any]]:
        points = self._of_points()
        inputs = {name: points[name] for name in self.inputs}
        return {**with_degrees(self.model, inputs), **points}

    def _of_points(self) -> dict[str, NDArray[Any]]:
        columns = {**self.inputs, **self._words_and_measures()}
        return {name: np.broadcast_to(values, self.rms.shape) for name, values in columns.items()}

    def _attributes(self) -> dict[str, Any]:
        settings = {
            name: getattr(self, name)
            for name in ("t_end", "transient", "rtol", "backend", "max_steps")
        }
        key = fingerprint(self.model, self.inputs, {**settings, "options": self.options})
        return {**storage.provenance(), "model": self.model.name, **settings, "fingerprint": key}


def reported(of: Model | Field) -> tuple[str, ...]:
    """Names of the quantities in a record, for the coordinates of a model: :data:`MEASURED`, with
    the placeholders {y}, {q}, {v} expanded. In a record the code of the regime follows them.
    """
    others = of.coordinates[1 : -1 if of.clock else None]
    expanded = {"{y}": others, "{q}": of.coordinates, "{v}": of.components}
    names = []
    for each in MEASURED:
        mark = each.name[-3:]
        names += [each.name.replace(mark, name) for name in expanded.get(mark, (mark,))]
    return tuple(names)


def measured(
    model: Model, settings: Mapping[str, Any], points: Sequence[tuple[float, ...]]
) -> list[Record]:
    """The record of each point: numbers, or the reason why its motion failed. Errors that are not
    of the motion are raised.
    """
    count, names = len(model.parameters), ("t_end", "rtol", "max_steps", "options")
    given = {
        "t_record": settings["transient"],
        "field_of": partial(field_of, model),
        **{name: settings[name] for name in names},
    }
    problems = [
        Problem(model.field.constants(point[:count]), point[count:], **given) for point in points
    ]
    errors = [start_error(model, problem.constants, problem.start) for problem in problems]
    good = [problem for problem, error in zip(problems, errors, strict=True) if error is None]
    backend = settings["backend"]
    with np.errstate(all="ignore"):  # overflow becomes a reason
        statistics = iter(integrators.measure(good, backend) if good else ())
        return [
            _record(error or next(statistics), problem, backend)
            for problem, error in zip(problems, errors, strict=True)
        ]


def _record(statistics: MotionStatistics | Exception, problem: Problem, backend: str) -> Record:
    """Record of a motion, in the order of :func:`reported`, from its statistics."""
    if isinstance(statistics, Exception):
        return _no_result(statistics)
    (mean, spread), (lost, _, *reversals) = statistics.moments(), statistics.events[: Event.STICK]
    field = problem.field
    names = ("mean", *(f"mean_{name}" for name in field.coordinates[1:]))
    measures = {
        "rms": math.hypot(mean, spread),
        "spread": spread,
        "largest": max(map(abs, statistics.reach)),
        **dict(zip(names, statistics.means, strict=True)),
        "contact_lost": lost,
        "slip_reversed": sum(reversals),
    }
    if not np.isfinite([*measures.values()]).all():
        return _no_result(out_of_range())
    try:
        outcome = classify(statistics, Onward(problem, backend))
    except (ConvergenceError, ArithmeticError) as error:
        return _no_result(error)
    measures |= vars(outcome) | outcome.places()
    return [float(measures[name]) for name in (*reported(field), "regime")], ""


def _no_result(error: Exception) -> Record:
    error = out_of_range() if isinstance(error, ArithmeticError) else error
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def _made_of(
    model: Model,
    inputs: dict[str, FloatArray],
    settings: Mapping[str, Any],
    columns: dict[str, Any],
    table: Mapping[str, Any],
) -> Sweep:
    """The sweep with these columns. Indices of equilibria are taken from ``table``, the columns of
    a loaded file; otherwise they are computed.
    """
    reason, regime = (columns.pop(own_name(model, name)) for name in ("reason", "regime"))
    if (at := own_name(model, "equilibrium")) in table:
        which = np.asarray(table[at]).astype(np.int8).reshape(regime.shape)
    else:
        places = np.array([columns[f"rest_{name}"] for name in model.coordinates])
        which = np.full(regime.shape, -1, dtype=np.int8)
        if not (model.clock or np.isnan(places).all()):  # with a clock there is no equilibrium
            p = model.Parameters(**{name: inputs[name] for name in model.parameters})
            which = rest_index(p, places)
    regime = np.nan_to_num(regime, nan=Regime.FAILED).astype(np.int8)
    return Sweep(
        inputs,
        **settings,
        measured=columns,
        regime=regime,
        equilibrium=which,
        reason=reason,
        model=model,
    )


def fingerprint(model: Model, inputs: Mapping[str, FloatArray], settings: Mapping[str, Any]) -> str:
    """Hash of everything that determines the bits of a result, without source text."""
    decides = {
        "integrator": integrators.version(settings["backend"]),
        "records": RECORDS + 3 * bool(model.clock),  # records with a clock have changed thrice more
        "numpy": np.__version__,  # its eigenvalues decide which limit is approached
        "model": model.name,
        "files": model.about["files"],
        "page": model.about["source"],
        "own": sorted(model.closed),
    }
    chosen = {**settings, **decides}
    options = chosen.pop("options")
    if options != MotionOptions():
        chosen["options"] = asdict(options)
    return storage.fingerprint(inputs, chosen)
