"""Choice of an integrator (backend), and what is asked of one: a motion, statistics of many
motions, or the flow map.

All backends are existing methods that are restarted at every kink of the field: they integrate the
analytic continuation of one mode (:mod:`~spragsym.motion.problem`), locate where the motion leaves
it, and continue in the next mode. Problems are converted to the motion's own units first
(:mod:`~spragsym.motion.scales`). If the steps of an explicit method collapse, Radau takes over.
"""

from __future__ import annotations

import dataclasses
import importlib.metadata
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..core.errors import BackendError, ConvergenceError, MissingExtraError, ParameterError
from ..core.type_variables import T
from ..models.field import Field, Values
from ..models.model import Model
from ..models.parameters import FloatArray
from ..numerics.columns import reuse_memory
from . import with_compiled, with_heyoka, with_scipy
from .lobatto import PiecewisePolynomial
from .measures import MotionStatistics, statistics_of
from .options import ShootingOptions
from .problem import Event, Problem, StiffError
from .scales import MotionScales
from .solution import FlowMap, FlowResult, Solution, events_of, without_chatter
from .with_scipy import RTOL, Flight

#: All backends, in the order of preference.
BACKENDS = ("heyoka", "compiled", "scipy")

#: Backends for any model; "compiled" is for the article's only.
OF_ANY_MODEL = ("heyoka", "scipy")


#: The relative tolerance of a motion by default.
USUAL_RTOL = 1e-10

#: No directions in the space of parameters.
NONE = np.empty((0, 0))


def offered_for(model: Model) -> tuple[str, ...]:
    """Backends that can integrate the motion of a model."""
    return OF_ANY_MODEL if model.closed_form("integrate") is None else BACKENDS


def choose(backend: str | None, offered: tuple[str, ...] = BACKENDS) -> str:
    """The named backend, or the first of those offered that is installed.

    Raises ParameterError for an unknown name, MissingExtraError or BackendError for a backend that
    is not installed.
    """
    if backend is None:
        return next(name for name in offered if is_there(name))
    if backend not in offered:
        raise ParameterError(
            f"backend = {backend!r} is not one of {', '.join(offered)}; leave it out for the "
            "fastest"
        )
    if is_there(backend):
        return backend
    if backend == "heyoka":
        raise MissingExtraError("backend='heyoka'", "heyoka", "fast")
    raise BackendError(
        "the backend 'compiled' was not built, for want of a C compiler or for a "
        "derivation that has changed since; "
        "install spragsym again, with a compiler, or install a wheel"
    )


def check_rtol(field: Field, rtol: float, backend: str) -> None:
    """Raise ParameterError for a tolerance that is coarser than the default where steps of a
    backend are finer in any case.
    """
    takes = {"heyoka": with_heyoka.takes_rtol, "scipy": with_scipy.takes_rtol}
    if rtol <= USUAL_RTOL or backend not in takes or takes[backend](field):
        return
    other = ", or give backend='scipy', which takes it" if with_scipy.takes_rtol(field) else ""
    raise ParameterError(
        f"rtol = {rtol:g}: the page has a border that is curved, for which {backend} steps as "
        f"finely as float64 carries, whatever rtol; give at most {USUAL_RTOL:g}{other}"
    )


def is_there(backend: str) -> bool:
    """True if a backend is installed."""
    if backend == "compiled":
        return with_compiled.available()
    return backend != "heyoka" or with_heyoka.available()


def version(backend: str) -> str:
    """Name and version of a backend, which determine the last bits of a result."""
    if backend == "compiled":
        return with_compiled.version()
    return f"{backend} {importlib.metadata.version(backend)}"


def integrate(problem: Problem, backend: str) -> Solution:
    """Integrate a problem from 0 to ``t_end``: the motion from ``t_record`` on, without chatter."""
    reuse_memory()
    scales = problem.own_scales
    if not scales.trivial:
        return scales.solution(integrate(scales.problem(problem), backend))
    if problem.scales and backend == "compiled":
        backend = "scipy"  # makes the same steps, and accepts a field in any units
    try:
        integrators = {
            "heyoka": with_heyoka,
            "compiled": with_compiled,
            "scipy": with_scipy,
        }
        solution: Solution = integrators[backend].integrate(problem)
        used: float = integrators[backend].tolerance(problem)
    except StiffError:
        solution = Flight(replace(problem, max_steps=None), stiff=True).motion()
        used = with_scipy.tolerance(problem, stiff=True)
    return replace(without_chatter(solution, problem), rtol=used)


def measure(problems: Sequence[Problem], backend: str) -> list[MotionStatistics | Exception]:
    """Statistics of each motion after ``t_record``, or the error with which it failed.

    The problems may differ in their constants and starts only. heyoka accumulates the statistics
    during the integration, except for stiff motions and those that may rest on a border, where only
    samples distinguish crossings from chatter. All other statistics are computed from samples.
    """
    found: list[Any] = [None] * len(problems)
    rows = list(range(len(problems)))
    if backend == "heyoka":
        found, rows = _watched(problems)
    for row in rows:
        try:
            solution = integrate(problems[row], backend)
            counts = np.bincount(
                events_of(problems[row].field, solution.crossings).which, minlength=len(Event)
            )
            found[row] = statistics_of(solution.samples, counts, problems[row].field)
        except (ConvergenceError, ArithmeticError) as error:
            found[row] = error
    return found


def _watched(problems: Sequence[Problem]) -> tuple[list[Any], list[int]]:
    """:func:`with_heyoka.measured` for each group of motions with the same scales: statistics, and
    indices of the motions that need samples.
    """
    groups: dict[MotionScales, list[int]] = {}
    for row, problem in enumerate(problems):
        groups.setdefault(problem.own_scales, []).append(row)
    found, need_samples = list[Any]([None] * len(problems)), list[int]()
    for scales, rows in groups.items():
        group = [problems[row] for row in rows]
        if not scales.trivial:
            group = [scales.problem(each) for each in group]
        measured, unmeasured = with_heyoka.measured(group)
        for row, statistics in zip(rows, measured, strict=True):
            found[row] = statistics
            if isinstance(statistics, MotionStatistics) and not scales.trivial:
                found[row] = scales.statistics(statistics)
        need_samples += [rows[i] for i in unmeasured]
    return found, sorted(need_samples)


@dataclass(frozen=True)
class Flow:
    """The flow of a field by a backend, with options of shooting; ``other`` replaces
    :meth:`flow_map`.
    """

    field: Field
    backend: str
    other: FlowMap | None = None
    options: ShootingOptions = dataclasses.field(default_factory=ShootingOptions)

    @classmethod
    def of(cls, field: Field, backend: str | None, options: ShootingOptions | None = None) -> Flow:
        """The flow of a field by the named backend, or the first one installed."""
        return cls(field, choose(backend, OF_ANY_MODEL), options=options or ShootingOptions())

    def flow_map(
        self, state: FloatArray, constants: Values, duration: float, directions: FloatArray = NONE
    ) -> FlowResult:
        """The state after a duration, with derivatives by the initial state and along
        ``directions`` of the parameters, shape (k, P).
        """
        if self.other:
            return self.other(state, constants, duration, directions)
        return self._asked(
            lambda integrator: integrator.flow_map(),
            MotionScales.flow_result,
            self._problem(state, constants, duration),
            directions,
        )

    def plain(
        self, state: FloatArray, constants: Values, duration: float, *, loose: bool = False
    ) -> FlowResult:
        """The state after a duration, without derivatives; ``loose``: with the lower accuracy that
        suffices for a first guess of Newton's method.
        """
        return self._asked(
            lambda integrator: integrator.flow_map(),
            MotionScales.flow_result,
            self._problem(state, constants, duration, 1e-9 if loose else RTOL),
        )

    def samples(self, start: FloatArray, constants: Values, t_end: float) -> PiecewisePolynomial:
        """The motion from a state to time ``t_end``, as a piecewise polynomial."""
        return self._asked(
            lambda integrator: integrator.motion().samples,
            MotionScales.samples,
            self._problem(start, constants, t_end),
        )

    def _problem(
        self, state: FloatArray, constants: Values, t_end: float, rtol: float = RTOL
    ) -> Problem:
        start, field = tuple(state.tolist()), self.field
        return Problem(constants, start, t_end, 0.0, rtol, None, lambda _: field, field.scales)

    def _asked(
        self,
        ask: Callable[[Any], T],
        back: Callable[[MotionScales, T], T],
        problem: Problem,
        directions: FloatArray | None = None,
    ) -> T:
        """Apply ``ask`` to the integrator of a problem in the motion's own units, and convert the
        result ``back`` to the field's units. Radau is used if the problem is stiff. heyoka has
        tolerances of its own.
        """
        scales = problem.own_scales
        if not scales.trivial:
            problem = scales.problem(problem)
        try:
            found = ask(
                with_heyoka.flow_integrator(problem, directions)
                if self.backend == "heyoka"
                else Flight(problem, directions)
            )
        except StiffError:
            found = ask(Flight(problem, directions, stiff=True))
        return found if scales.trivial else back(scales, found)
