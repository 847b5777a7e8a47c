"""Many motions: RMS and final regime over parameters and initial states, resumable, on all cores."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..display import Result
from ..dynamics import integrators, regimes
from ..dynamics import trajectory as dynamics
from ..dynamics.integrators import Course, Problem
from ..dynamics.regimes import Outcome, Regime
from ..dynamics.trajectory import BELT_SPEED, CREEP, MAX_STEPS, TOLERANCE
from ..errors import ConvergenceError, ParameterError, ParameterTypeError, TargetError
from ..files import storage
from ..files.journal import Record, clear, journal
from ..parameters import NAMES, NOT_NEGATIVE, POSITIVE, FloatArray, Parameters, as_number, as_numbers, degrees
from . import workers as processes
from .workers import Workers as Workers

__all__ = ["Basin", "Regime", "Sensitivity", "Sweep", "basin", "rms_sweep", "sensitivity"]

#: What is measured of every motion after its transient.
AVERAGES = ("rms", "spread", "amplitude", "mean", "mean_y", "contact_lost", "slip_reversed")

#: What is said of its limit, in the order of a record after those.
LIMITS = ("period", "rate", "distance", "cycle_mean", "cycle_rms", "cycle_x", "cycle_y", "cycle_vy")

#: Numbers that a file and a result hold.
REPORTED = (*AVERAGES, *LIMITS)

#: A record: these, then the code of the regime, and where the equilibrium is.
MEASURED = (*REPORTED, "regime", "rest_x", "rest_y")

INPUTS = (*NAMES, "V", "d", "x0", "y0", "vx0", "vy0")

@dataclass(frozen=True)
class Settings:
    """What all motions of a sweep share."""

    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int = MAX_STEPS


@dataclass(frozen=True, eq=False)
class Sweep(Result):
    """Results of a sweep; every array has the common shape of the inputs. NaN where a motion failed.

    Attributes
    ----------
    inputs : dict of str to ndarray
        θ₀, μ₀, κ, α, σ, β, V, d, x0, y0, vx0, vy0 as they were given, which broadcast together.
    rms, spread, amplitude, mean, mean_y : ndarray
        Of x after the transient, over L_0: root mean square about zero, and about the mean; largest \\|x\\|;
        means of x and y.
    contact_lost, slip_reversed : ndarray
        How often, after the transient.
    period, cycle_mean, cycle_rms : ndarray
        Of the cycle that the motion is on or approaches: period, mean of x, and root mean square of x about zero, over
        one whole period. NaN for no cycle. Unlike ``mean`` and ``rms`` they depend on no window.
    cycle_x, cycle_y, cycle_vy : ndarray
        State of that cycle where its x is largest.
    rate, distance : ndarray
        What a motion settles to or approaches, it nears as exp(−rate τ) in the long run; at ``t_end`` this is left of
        the way, relative to the reach of a cycle, or over L_0 for rest. See :class:`~spragsym.dynamics.regimes.Outcome`.
    regime : ndarray of int8
        Codes of :class:`Regime`.
    equilibrium : ndarray of int8
        For ``Regime.EQUILIBRIUM`` and ``APPROACHES_EQUILIBRIUM`` its index among ``equilibria(p)``; −1 otherwise.
    reason : ndarray of str
        Why a motion failed.
    """

    inputs: dict[str, FloatArray]
    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int
    rms: FloatArray
    spread: FloatArray
    amplitude: FloatArray
    mean: FloatArray
    mean_y: FloatArray
    contact_lost: FloatArray
    slip_reversed: FloatArray
    period: FloatArray
    rate: FloatArray
    distance: FloatArray
    cycle_mean: FloatArray
    cycle_rms: FloatArray
    cycle_x: FloatArray
    cycle_y: FloatArray
    cycle_vy: FloatArray
    regime: NDArray[np.int8]
    equilibrium: NDArray[np.int8]
    reason: NDArray[np.str_]

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``).

        An axis along which one input alone varies is named after it; others are ``axis_0``, ``axis_1``, …. θ₀ is there
        in radians and, as ``theta0_deg``, in degrees.
        """
        dims = _dimensions(self.inputs, self.rms.shape)
        # One number is kept as such, an axis as a coordinate, a table as a table of the full shape.
        inputs = {
            name: ((), float(values.flat[0])) if values.size == 1
            else (name.removesuffix("_deg"), values.ravel()) if name.removesuffix("_deg") in dims
            else (dims, np.broadcast_to(values, self.rms.shape).copy())
            for name, values in self._inputs().items()
        }  # fmt: skip
        results = {name: (dims, getattr(self, name)) for name in (*REPORTED, "regime", "equilibrium")}
        results["reason"] = (dims, self.reason.astype(object))
        dataset = storage.xarray().Dataset(results, coords=inputs, attrs=self._attributes())
        for name in dataset.variables:
            dataset[name].attrs = storage.attributes(name)
        dataset["regime"].attrs |= {
            "flag_values": np.array(list(Regime), dtype=np.int8),
            "flag_meanings": " ".join(regime.name.lower() for regime in Regime),
        }
        return dataset

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write netCDF to ``*.nc`` (extra ``sweep``), or one line a motion to ``*.csv``."""
        storage.write(Path(path), self.to_dataset, self._columns, self._attributes())

    def _columns(self) -> dict[str, NDArray[Any]]:
        inputs = {name: np.broadcast_to(values, self.rms.shape) for name, values in self._inputs().items()}
        return inputs | {name: getattr(self, name) for name in (*REPORTED, "regime", "equilibrium", "reason")}

    def _inputs(self) -> dict[str, FloatArray]:
        """The inputs, θ₀ in degrees beside it in radians."""
        theta0, *rest = self.inputs.items()
        return dict([theta0, ("theta0_deg", np.vectorize(degrees, otypes=[np.float64])(theta0[1])), *rest])

    def _attributes(self) -> dict[str, Any]:
        settings = Settings(self.t_end, self.transient, self.rtol, self.backend, self.max_steps)
        return {**storage.provenance(), **vars(settings), "fingerprint": _fingerprint(self.inputs, settings)}


def rms_sweep(
    p: Parameters,
    V: ArrayLike,
    d: ArrayLike,
    *,
    x0: ArrayLike = 0.0,
    y0: ArrayLike = 0.0,
    vx0: ArrayLike = 0.0,
    vy0: ArrayLike = 0.0,
    t_end: float = 2000.0,
    transient: float | None = None,
    rtol: float = 1e-10,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
) -> Sweep:
    """Simulate every point of a broadcast of parameters and initial states, and tell what each comes to.

    Parameters
    ----------
    p : Parameters
        Any shape.
    V, d, x0, y0, vx0, vy0 : array_like
        As for :func:`~spragsym.simulate`; they broadcast with ``p``. The article states neither V nor d.
    t_end, transient : float
        Until when to integrate, and what to leave out of every result, by default three quarters of it.
    rtol : float
        Relative tolerance.
    backend : {"heyoka", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    max_steps : int
        As for :func:`~spragsym.simulate`; a motion that needs more has failed.
    workers : int or map-like callable
        Processes, −1 for one a core; or ``map(function, points)`` of an engine, which may give results or
        futures with a ``result()``, in any order. Results are the same to the last bit for any.
    progress : bool
        Show a bar with the estimated end on stderr.
    store : path, optional
        ``*.nc`` or ``*.csv``. Finished points go to ``<store>.partial`` as they come. The same call resumes
        from there after a kill, and loads the file when it is finished. One process at a time may write to it.

    Returns
    -------
    Sweep

    Raises
    ------
    ParameterError, ParameterTypeError
        Before the work starts, for arguments that make no sense and files that cannot be written. A motion
        that fails is NaN, with its reason, and stops nothing.
    SweepError
        For any failure that is not the motion's: memory, a package that is missing, a worker that was killed.
        The store keeps what is finished.
    StoreError
        When the store is damaged, full, or being written by another process.

    Notes
    -----
    Source: (8)–(11); the article's Figure 7b. Which equilibrium: with μ(V), (10), for μ₀, which is where the
    motion can rest.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.sweeps import Regime, rms_sweep
    >>> sweep = rms_sweep(ss.Parameters.article(theta0=np.radians([40, 41, 42])), V=0.5, d=10.0)
    >>> np.round(sweep.rms, 1)
    array([0.1, 0.2, 1.6])
    >>> [Regime(code).name for code in sweep.regime]
    ['APPROACHES_EQUILIBRIUM', 'APPROACHES_EQUILIBRIUM', 'APPROACHES_CYCLE']
    """
    p.require(*NAMES)
    given = {name: getattr(p, name) for name in NAMES}
    given |= {"V": as_numbers("V", V, BELT_SPEED), "d": as_numbers("d", d, CREEP)}
    given |= {name: as_numbers(name, value) for name, value in (("x0", x0), ("y0", y0), ("vx0", vx0), ("vy0", vy0))}
    inputs = {name: given[name] for name in INPUTS}
    settings = _settings(t_end, transient, rtol, backend, max_steps)
    shape = _common_shape(inputs)
    points = _points(inputs, shape)
    if not callable(workers):
        processes.count(workers)  # before there is a journal
    if store is None:
        return _result(inputs, shape, settings, _records(points, settings, workers, progress, {}, None))
    target = storage.resolved(store)
    key = _fingerprint(inputs, settings)
    if target.is_file():
        sweep = _finished(target, key, inputs, shape, settings)
        clear(target, key, len(points))
        return sweep
    storage.check_target(target, 100_000 + 1000 * len(points))
    with journal(target, key, len(points)) as (done, keep):
        if target.is_file():  # another process has finished it in the meantime
            return _finished(target, key, inputs, shape, settings)
        sweep = _result(inputs, shape, settings, _records(points, settings, workers, progress, done, keep))
        sweep.save(target)
    return sweep


# ------------------------------------------------------------------------------------------------ one motion


def _measure(settings: Settings, point: tuple[float, ...]) -> Record:
    """One record. What the motion itself makes impossible is its reason; whatever else goes wrong is raised."""
    try:
        problem = _problem(settings, point)
    except ParameterError as error:  # arrays were validated before: what is left is a start at the anchor
        return _no_result(error)
    try:
        with np.errstate(all="ignore"):  # numbers out of range are told by the result
            values = _values(problem, settings.backend)
    except ConvergenceError as error:
        return _no_result(error)
    except ArithmeticError:
        return _no_result(_out_of_range())
    if not np.isfinite(values[: len(AVERAGES)]).all():
        return _no_result(_out_of_range())
    return values, ""


def _out_of_range() -> ConvergenceError:
    return ConvergenceError("the motion left the range of numbers; give values of a more common size")


def _no_result(error: Exception) -> Record:
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def _problem(settings: Settings, point: tuple[float, ...]) -> Problem:
    """The motion of a point whose values were validated with the whole sweep's."""
    theta0, mu0, kappa, alpha, sigma, beta, V, d, *start = point
    cos0, sin0 = float(np.cos(theta0)), float(np.sin(theta0))
    dynamics.check_start(cos0, sin0, *start[:2])
    x0, y0, vx0, vy0 = start
    return Problem(
        cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, (x0, y0, vx0, vy0),
        settings.t_end, settings.transient, settings.rtol, settings.max_steps,
    )  # fmt: skip


def _values(problem: Problem, backend: str) -> list[float]:
    """The measured values of a motion, in the order of MEASURED."""
    course = dynamics.course(problem, backend)
    outcome = regimes.classify(course, problem, dynamics.flow(problem, backend))
    return [*_averages(course), *(float(getattr(outcome, name)) for name in MEASURED[len(AVERAGES) :])]


def _averages(course: Course) -> list[float]:
    """The measured values of what follows the transient, in the order of AVERAGES."""
    mean, spread = course.moments()
    amplitude = float(np.abs(course.x_extrema).max())
    mean_y = float(course.integrals[-1, 2]) / (course.end - course.begin)
    lost, _, *reversals = course.events.tolist()
    return [math.hypot(mean, spread), spread, amplitude, mean, mean_y, lost, sum(reversals)]


# -------------------------------------------------------------------------------------------- all the motions


def _settings(t_end: float, transient: float | None, rtol: float, backend: str | None, max_steps: int) -> Settings:
    t_end = as_number("t_end", t_end, POSITIVE)
    transient = 0.75 * t_end if transient is None else as_number("transient", transient, NOT_NEGATIVE)
    if transient >= t_end:
        raise ParameterError(f"transient = {transient:g} is not below t_end = {t_end:g}; nothing would be left to measure")
    tolerance, steps = as_number("rtol", rtol, TOLERANCE), dynamics.as_steps(max_steps)
    return Settings(t_end, transient, tolerance, integrators.choose(backend), steps)


def _common_shape(inputs: dict[str, FloatArray]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(values.shape for values in inputs.values()))
    except ValueError as error:
        listed = ", ".join(f"{name} {values.shape}" for name, values in inputs.items() if values.shape)
        raise ParameterError(f"the shapes do not broadcast together: {listed}; give equal shapes, or shapes with ones") from error


def _points(inputs: dict[str, FloatArray], shape: tuple[int, ...]) -> list[tuple[float, ...]]:
    columns = [np.broadcast_to(values, shape).ravel().tolist() for values in inputs.values()]
    return list(zip(*columns, strict=True))


def _records(
    points: list[tuple[float, ...]],
    settings: Settings,
    workers: Workers,
    progress: bool,
    done: dict[int, Record],
    keep: Callable[[int, Record], None] | None,
) -> list[Record]:
    """Every record: those that are done, and the others, kept as they come."""
    keep = done.__setitem__ if keep is None else keep
    missing = {i: point for i, point in enumerate(points) if i not in done}
    found = processes.results(workers, partial(_measure, settings), missing, _told)
    with _advance(progress, len(points), len(done)) as advance, closing(found):
        for i, record in found:
            keep(i, record)
            advance()
    return [done[i] for i in range(len(points))]


def _told(point: tuple[float, ...]) -> str:
    return ", ".join(f"{name} = {value:.17g}" for name, value in zip(INPUTS, point, strict=True))


@contextmanager
def _advance(progress: bool, total: int, done: int) -> Iterator[Callable[[], None]]:
    """A function to call after every point, which moves the bar if there is one."""
    if not progress:
        yield lambda: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeElapsedColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), "ends in", TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task("", total=total, completed=done)
        yield lambda: bar.advance(task)


def _fingerprint(inputs: dict[str, FloatArray], settings: Settings) -> str:
    """Of all that decides the bits of a result."""
    versions = {
        "fields": MEASURED,
        "integrator": integrators.version(settings.backend),
        "degree": integrators.DEGREE,
    }
    return storage.fingerprint(inputs, {**vars(settings), **versions})


# ------------------------------------------------------------------------------------------ what they come to


def _result(inputs: dict[str, FloatArray], shape: tuple[int, ...], settings: Settings, records: list[Record]) -> Sweep:
    table = np.array([values or [np.nan] * len(MEASURED) for values, _ in records]).reshape(-1, len(MEASURED))
    measured = {name: column.reshape(shape) for name, column in zip(MEASURED, table.T, strict=True)}
    results: dict[str, Any] = {name: measured[name] for name in REPORTED}
    regime = np.where(np.isnan(measured["regime"]), Regime.FAILED, measured["regime"]).astype(np.int8)
    p = Parameters(**{name: inputs[name] for name in NAMES})
    equilibrium = regimes.index_of(p, inputs["V"], inputs["d"], measured["rest_x"], measured["rest_y"])
    reason = np.array([storage.plain(reason) for _, reason in records], dtype=np.str_).reshape(shape)
    return Sweep(inputs, **vars(settings), **results, regime=regime, equilibrium=equilibrium, reason=reason)


def _finished(path: Path, key: str, inputs: dict[str, FloatArray], shape: tuple[int, ...], settings: Settings) -> Sweep:
    """The sweep that a file holds, if it is this one."""
    columns, attributes = storage.read(path)
    if attributes.get("fingerprint") != key:
        raise TargetError(f"{path} exists and holds something else; remove it, or give another path")
    kinds = {**dict.fromkeys(REPORTED, float), "regime": np.int8, "equilibrium": np.int8, "reason": np.str_}
    results: dict[str, Any] = {name: columns[name].astype(kind).reshape(shape) for name, kind in kinds.items()}
    return Sweep(inputs, **vars(settings), **results)


def _dimensions(inputs: dict[str, FloatArray], shape: tuple[int, ...]) -> tuple[str, ...]:
    """A name for every axis: the input that alone varies along it, and along no other axis."""

    def axes(values: FloatArray) -> tuple[int, ...]:
        lead = len(shape) - values.ndim
        return tuple(lead + i for i, size in enumerate(values.shape) if size > 1)

    along = {name: axes(values) for name, values in inputs.items()}
    names = []
    for axis in range(len(shape)):
        candidates = [name for name, varied in along.items() if axis in varied]
        alone = len(candidates) == 1 and along[candidates[0]] == (axis,)
        names.append(candidates[0] if alone else f"axis_{axis}")
    return tuple(names)


# ------------------------------------------------------------------------------------------------- attractors


@dataclass(frozen=True, eq=False)
class Basin(Result):
    """Which attractor each initial state reaches: arrays of shape (len(x), len(vx)).

    Attributes
    ----------
    x, vx : ndarray
        Initial displacements and speeds along the belt.
    attractor : ndarray of int
        Row of ``attractors`` that the motion reaches; −1 where it failed.
    attractors : tuple of (Regime, int, float, float)
        EQUILIBRIUM, LIMIT_CYCLE, LIFT_OFF or UNSETTLED, whether reached or approached; index of the equilibrium or −1; for
        a limit cycle its mean and its RMS of x about that over one period, else NaN.
    sweep : Sweep
        Everything that was measured.
    """

    x: FloatArray
    vx: FloatArray
    attractor: NDArray[np.int64]
    attractors: tuple[tuple[Regime, int, float, float], ...]
    sweep: Sweep


def basin(
    p: Parameters,
    V: float,
    d: float,
    *,
    x: ArrayLike,
    vx: ArrayLike,
    y0: float = 0.0,
    vy0: float = 0.0,
    **options: Any,
) -> Basin:
    """Which attractor is reached from a grid of initial displacements and speeds along the belt.

    Parameters
    ----------
    p : Parameters
        Scalars.
    V, d : float
        As for :func:`~spragsym.simulate`.
    x, vx : array_like, one axis each
        Initial states: every x with every vx.
    y0, vy0 : float
        Initial state across the belt.
    **options
        As for :func:`rms_sweep`. A motion that by ``t_end`` approaches nothing is ``Regime.UNSETTLED``: damping is weak
        where exp(−d V) is small, so that it can take tens of thousands of time units.

    Returns
    -------
    Basin

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.sweeps import basin
    >>> p = ss.Parameters.article(theta0=np.radians(30))
    >>> found = basin(p, V=0.5, d=4.0, x=[0.0, 0.1, 1.6], vx=[0.0], t_end=2e4, transient=1.9e4)
    >>> [(regime.name, which) for regime, which, *_ in found.attractors]
    [('EQUILIBRIUM', 0), ('UNSETTLED', -1)]
    >>> found.attractor[:, 0]
    array([0, 0, 1])
    """
    p.scalars(*NAMES)
    starts = [np.atleast_1d(as_numbers(name, values)) for name, values in (("x", x), ("vx", vx))]
    for name, values in zip(("x", "vx"), starts, strict=True):
        if values.ndim != 1:
            raise ParameterTypeError(f"{name} has the shape {values.shape}; give one axis of numbers")
    sweep = rms_sweep(p, V, d, x0=starts[0][:, None], vx0=starts[1], y0=y0, vy0=vy0, **options)
    labels, attractors = _attractors(sweep)
    return Basin(starts[0], starts[1], labels, attractors, sweep)


def _attractors(sweep: Sweep) -> tuple[NDArray[np.int64], tuple[tuple[Regime, int, float, float], ...]]:
    """Group motions by what they settle to or approach: cycles by their orbits, which know no phase."""
    labels = np.full(sweep.rms.shape, -1)
    attractors: list[tuple[Regime, int, Outcome]] = []
    for index in np.ndindex(sweep.rms.shape):
        code = Regime(int(sweep.regime[index]))
        if code == Regime.FAILED:
            continue
        regime, which = regimes.ATTRACTOR.get(code, code), int(sweep.equilibrium[index])
        outcome = Outcome(code, which, **{name: float(getattr(sweep, name)[index]) for name in LIMITS})
        same = (
            i for i, known in enumerate(attractors)
            if known[:2] == (regime, which) and (regime != Regime.LIMIT_CYCLE or regimes.same_orbit(known[2], outcome))
        )  # fmt: skip
        label = next(same, len(attractors))
        if label == len(attractors):
            attractors.append((regime, which, outcome))
        labels[index] = label
    return labels, tuple((regime, which, one.cycle_mean, one.cycle_spread) for regime, which, one in attractors)


# ------------------------------------------------------------------------------------------------ sensitivity


@dataclass(frozen=True, eq=False)
class Sensitivity(Result):
    """Where the RMS of x jumps as θ₀ grows, for every V (first axis) with every d (second).

    Attributes
    ----------
    V, d : ndarray
        Belt speeds, steepnesses.
    theta0 : ndarray, shape (len(V), len(d))
        Where the RMS jumps, radians: the middle of an interval of half-width ``width``.
    before, after : ndarray, of that shape
        RMS on the two sides of the jump.
    width : float
        Half-width of the interval, radians.
    sweep : Sweep
        The sweep over θ₀ that the jump was looked for in, shape (len(V), len(d), number of angles).
    """

    V: FloatArray
    d: FloatArray
    theta0: FloatArray
    before: FloatArray
    after: FloatArray
    width: float
    sweep: Sweep


def sensitivity(p: Parameters, V: ArrayLike, d: ArrayLike, *, refine: int = 6, **options: Any) -> Sensitivity:
    """What V and d, which the article does not state, do to the jump of its Figure 7b.

    Parameters
    ----------
    p : Parameters
        With ``theta0`` an ascending axis of at least two angles, and the rest scalars.
    V, d : array_like, one axis each
        Every V with every d.
    refine : int
        How often to halve the interval that holds the jump.
    **options
        As for :func:`rms_sweep`, but ``store``.

    Returns
    -------
    Sensitivity

    Notes
    -----
    The jump is where the RMS grows by the largest factor from one angle to the next; bisection keeps the half
    with the larger one.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> from spragsym.sweeps import sensitivity
    >>> p = ss.Parameters.article(theta0=np.radians([38, 42, 46]))
    >>> table = sensitivity(p, V=[0.5], d=[10.0], refine=3)
    >>> np.round(np.degrees(table.theta0), 1)
    array([[41.3]])
    """
    p.require("theta0")
    angles = p.theta0
    if angles.ndim != 1 or len(angles) < 2 or (np.diff(angles) <= 0).any():
        raise ParameterError("theta0 must be an ascending axis of two angles or more; use p.replace(theta0=numpy.linspace(...))")
    speeds, creeps = (np.atleast_1d(as_numbers(name, value)) for name, value in (("V", V), ("d", d)))
    belt = (speeds[:, None, None], creeps[None, :, None])
    sweep = rms_sweep(p, *belt, **options)
    ratio = sweep.rms[..., 1:] / sweep.rms[..., :-1]
    at = np.argmax(np.where(np.isnan(ratio), 0.0, ratio), axis=-1)[..., None]
    low, high = angles[at], angles[at + 1]
    before, after = (np.take_along_axis(sweep.rms, at + k, axis=-1) for k in (0, 1))
    for _ in range(refine):
        middle = (low + high) / 2
        between = rms_sweep(p.replace(theta0=middle), *belt, **options).rms
        upper = after * before > between**2
        low, before = np.where(upper, middle, low), np.where(upper, between, before)
        high, after = np.where(upper, high, middle), np.where(upper, after, between)
    theta0, before, after = ((low + high)[..., 0] / 2, before[..., 0], after[..., 0])
    return Sensitivity(speeds, creeps, theta0, before, after, float(np.max(high - low)) / 2, sweep)
