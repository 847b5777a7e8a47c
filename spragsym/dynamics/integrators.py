"""The available integrators, and the choice between them.

Both are existing ones, restarted wherever the field of (8)–(11) has a kink: they integrate the analytic continuation of
one mode of the field (:mod:`~spragsym.dynamics.problem`), find where the motion leaves it, and go on in the next.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
from dataclasses import replace
from types import ModuleType

import numpy as np

from ..errors import MissingExtraError, ParameterError
from ..parameters import FloatArray
from . import with_heyoka, with_scipy
from .course import Course, Flow, course_of
from .problem import Event, Problem
from .solution import Solution

BACKENDS = ("heyoka", "scipy")

_INTEGRATORS: dict[str, ModuleType] = {"heyoka": with_heyoka, "scipy": with_scipy}


def choose(backend: str | None) -> str:
    """The backend that will run: heyoka where it is installed, else SciPy; a named one or an error."""
    if backend is None:
        return "heyoka" if importlib.util.find_spec("heyoka") else "scipy"
    if backend not in BACKENDS:
        raise ParameterError(f"backend = {backend!r} is not one of {', '.join(BACKENDS)}; leave it out for the fastest")
    if backend == "heyoka" and not importlib.util.find_spec("heyoka"):
        raise MissingExtraError("backend='heyoka'", "heyoka", "fast")
    return backend


def version(backend: str) -> str:
    """Name and version of the integrator, which decide the last bits of a result."""
    return f"{backend} {importlib.metadata.version(backend)}"


def integrate(problem: Problem, backend: str) -> Solution:
    """Integrate ``problem`` from 0 to ``t_end`` and keep what follows ``t_record``."""
    solution: Solution = _INTEGRATORS[backend].integrate(problem)
    return solution


def measure(problem: Problem, backend: str) -> Course:
    """Quantities of the motion after ``t_record``: heyoka measures them while it integrates, SciPy from the samples."""
    if backend == "heyoka":
        return with_heyoka.watch(problem)
    solution = with_scipy.integrate(problem)
    return course_of(solution.samples, np.bincount(solution.event_kinds, minlength=len(Event)))


def flow(problem: Problem, backend: str) -> Flow:
    """A function that integrates a problem from any state for any time."""

    def onward(state: FloatArray, duration: float) -> Course:
        return measure(replace(problem, start=tuple(state.tolist()), t_end=duration, t_record=0.0), backend)

    return onward
