"""The available integrators, and the choice between them.

All are existing methods, restarted wherever the field of (8)–(11) has a kink: they integrate the
analytic continuation of one mode of the field (:mod:`~spragsym.motion.problem`), find where the
motion leaves it, and go on in the next.
"""

from __future__ import annotations

import dataclasses
import importlib.metadata
import importlib.util
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

#: In the order in which they are preferred.
BACKENDS = ("heyoka", "compiled", "scipy")

#: Those that take the field of any model; what is compiled on installation is the article's.
OF_ANY_MODEL = ("heyoka", "scipy")


#: No directions of parameters.
NONE = np.empty((0, 0))


def offered_for(model: Model) -> tuple[str, ...]:
    """Integrators that take its motion: what is compiled on installation is that of a model that
    brings its own.
    """
    return OF_ANY_MODEL if model.closed_form("integrate") is None else BACKENDS


def choose(backend: str | None, offered: tuple[str, ...] = BACKENDS) -> str:
    """The backend that will run: the first of those offered that is there, or the one that is
    named, or an error.
    """
    if backend is None:
        return next(name for name in offered if is_there(name))
    if backend not in offered:
        raise ParameterError(
            f"backend = {backend!r} is not one of {', '.join(offered)}; leave it out for the "
            "fastest"
        )
    if not is_there(backend) and backend == "heyoka":
        raise MissingExtraError("backend='heyoka'", "heyoka", "fast")
    if not is_there(backend):
        raise BackendError(
            "the backend 'compiled' was not built, for want of a C compiler or for a "
            "derivation that has changed since; "
            "install spragsym again, with a compiler, or install a wheel"
        )
    return backend


def is_there(backend: str) -> bool:
    if backend == "compiled":
        return with_compiled.available()
    return backend != "heyoka" or importlib.util.find_spec("heyoka") is not None


def version(backend: str) -> str:
    """Name and version of the integrator, which decide the last bits of a result."""
    if backend == "compiled":
        return with_compiled.version()
    return f"{backend} {importlib.metadata.version(backend)}"


def integrate(problem: Problem, backend: str) -> Solution:
    """Integrate ``problem`` from 0 to ``t_end`` and keep what follows ``t_record``; by Radau where
    steps collapse.
    """
    reuse_memory()
    scales = problem.own_scales
    if not scales.trivial:
        return scales.solution(integrate(scales.problem(problem), backend))
    if problem.scales and backend == "compiled":
        backend = "scipy"  # which makes the same steps, and takes a field in any units
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
    """Measures of motions after ``t_record``, from their samples, or the reason why there are none.

    The problems share all but their constants and starts.

    heyoka measures while it integrates, but where steps collapse, and where a motion may rest on a
    border, whose crossings only the samples tell from chatter.
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
    """:func:`with_heyoka.measured`, of all motions of one scale at a time."""
    groups: dict[MotionScales, list[int]] = {}
    for row, problem in enumerate(problems):
        groups.setdefault(problem.own_scales, []).append(row)
    found, again = list[Any]([None] * len(problems)), list[int]()
    for scales, rows in groups.items():
        own = [problems[row] for row in rows]
        if not scales.trivial:
            own = [scales.problem(each) for each in own]
        measured, left = with_heyoka.measured(own)
        for row, statistics in zip(rows, measured, strict=True):
            found[row] = statistics
            if isinstance(statistics, MotionStatistics) and not scales.trivial:
                found[row] = scales.statistics(statistics)
        again += [rows[i] for i in left]
    return found, sorted(again)


@dataclass(frozen=True)
class Flow:
    """A field and an integrator, with options of closed orbits; ``other`` carries derivatives in
    the integrator's place.
    """

    field: Field
    backend: str
    other: FlowMap | None = None
    options: ShootingOptions = dataclasses.field(default_factory=ShootingOptions)

    @classmethod
    def of(cls, field: Field, backend: str | None, options: ShootingOptions | None = None) -> Flow:
        """The flow of a field by a backend that takes any model."""
        return cls(field, choose(backend, OF_ANY_MODEL), options=options or ShootingOptions())

    def flow_map(
        self, state: FloatArray, constants: Values, duration: float, directions: FloatArray = NONE
    ) -> FlowResult:
        """Carry a state on for a while, with derivatives by it and along ``directions`` of the
        parameters, shape (k, P).
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
        """Carry a state on without derivatives; ``loose``: only as accurately as Newton's method
        needs to begin.
        """
        # Tolerance by which SciPy follows a motion to where Newton's method can begin.
        return self._asked(
            lambda integrator: integrator.flow_map(),
            MotionScales.flow_result,
            self._problem(state, constants, duration, 1e-9 if loose else RTOL),
        )

    def samples(self, start: FloatArray, constants: Values, t_end: float) -> PiecewisePolynomial:
        """A motion by its samples."""
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
        """Answer of an integrator, ``back`` in the field's units; of an implicit one where steps
        collapse. heyoka has tolerances of its own.
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
