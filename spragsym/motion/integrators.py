"""The available integrators, and the choice between them.

All are existing methods, restarted wherever the field of (8)–(11) has a kink: they integrate the analytic continuation of
one mode of the field (:mod:`~spragsym.motion.problem`), find where the motion leaves it, and go on in the next.
"""

import importlib.metadata
import importlib.util
from collections.abc import Sequence
from types import ModuleType

import numpy as np

from ..errors import BackendError, ConvergenceError, MissingExtraError, ParameterError
from ..models.model import Model
from . import batch_heyoka, with_compiled, with_heyoka, with_scipy
from .events import events_of
from .measures import Course, course_of
from .problem import Event, Problem, StiffError
from .solution import Solution, without_chatter

#: In the order in which they are preferred.
BACKENDS = ("heyoka", "compiled", "scipy")
#: Those that take the field of any model; what is compiled on installation is the article's.
OF_ANY_MODEL = ("heyoka", "scipy")

_INTEGRATORS: dict[str, ModuleType] = {"heyoka": with_heyoka, "compiled": with_compiled, "scipy": with_scipy}


def offered_for(model: Model) -> tuple[str, ...]:
    """Integrators that take its motion: what is compiled on installation is that of a model that brings its own."""
    return OF_ANY_MODEL if model.closed_form("integrate") is None else BACKENDS


def choose(backend: str | None, offered: tuple[str, ...] = BACKENDS) -> str:
    """The backend that will run: the first of those offered that is there, or the one that is named, or an error."""
    if backend is None:
        return next(name for name in offered if _is_there(name))
    if backend not in offered:
        raise ParameterError(f"backend = {backend!r} is not one of {', '.join(offered)}; leave it out for the fastest")
    if not _is_there(backend) and backend == "heyoka":
        raise MissingExtraError("backend='heyoka'", "heyoka", "fast")
    if not _is_there(backend):
        raise BackendError(
            "the backend 'compiled' was not built, for want of a C compiler or for a derivation that has changed since; "
            "install spragsym again, with a compiler, or install a wheel"
        )
    return backend


def _is_there(backend: str) -> bool:
    if backend == "compiled":
        return with_compiled.available()
    return backend != "heyoka" or importlib.util.find_spec("heyoka") is not None


def version(backend: str) -> str:
    """Name and version of the integrator, which decide the last bits of a result."""
    return with_compiled.version() if backend == "compiled" else f"{backend} {importlib.metadata.version(backend)}"


def integrate(problem: Problem, backend: str) -> Solution:
    """Integrate ``problem`` from 0 to ``t_end`` and keep what follows ``t_record``; by Radau where steps collapse."""
    try:
        solution: Solution = _INTEGRATORS[backend].integrate(problem)
    except StiffError:
        solution = with_scipy.integrate(problem, stiff=True)
    return without_chatter(solution, problem)


def measure(problems: Sequence[Problem], backend: str) -> list[Course | Exception]:
    """What is measured of motions after ``t_record``, from their samples, or why there is nothing.

    The problems share all but their constants and starts.

    heyoka measures while it integrates, but where steps collapse, and where a motion may rest on a border, whose crossings only
    the samples tell from chatter.
    """
    found: dict[int, Course | Exception] = {}
    rows = list(range(len(problems)))
    if backend == "heyoka":
        watched, rows = batch_heyoka.watch(problems)
        found = dict(enumerate(watched))
    for row in rows:
        try:
            solution = integrate(problems[row], backend)
            counts = np.bincount(events_of(problems[row].field, solution.crossings).which, minlength=len(Event))
            found[row] = course_of(solution.samples, counts)
        except (ConvergenceError, ArithmeticError) as error:
            found[row] = error
    return [found[row] for row in range(len(problems))]
