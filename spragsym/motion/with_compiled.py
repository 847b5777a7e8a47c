"""Integration of the article's model by DOP853 in compiled C, for machines without heyoka.

The C code makes the same steps as SciPy's DOP853. It returns at each border, where
:class:`~spragsym.motion.solution.CarriedState` gives the next mode.
"""

from enum import IntEnum, auto
from functools import cache
from importlib import metadata

import numpy as np

from ..core.errors import ConvergenceError
from ..core.extensions import extension
from ..generated import C_SOURCE
from ..models.field import HYSTERESIS, OVERSHOOT
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import BURST, MAX_STEPS, Problem, check_stiffness, out_of_range, too_many_steps
from .solution import CarriedState, Crossing, Samples, Solution, assembled
from .with_scipy import Flight


class Stop(IntEnum):
    """Reason for which a call of the compiled code stopped, in the order of ``_carried.c``."""

    ENDED = 0  #: the end of the motion
    PASSED = auto()  #: a border
    FULL = auto()  #: the arrays of samples are full
    TOO_SMALL = auto()  #: the step is too small
    TOO_MANY = auto()  #: too many steps


def available() -> bool:
    """Whether the extension module was built, from the present sources."""
    return extension("motion._carried") is not None


def version() -> str:
    """Versions that determine the last bits of a result: of the field, and of DOP853's tables."""
    return f"compiled {C_SOURCE}, DOP853 of scipy {metadata.version('scipy')}"


@cache
def _tables() -> FloatArray:
    """SciPy's coefficients of DOP853 in one array."""
    from scipy.integrate import DOP853 as method

    parts = (
        method.A[:12, :12],
        method.B,
        method.C,
        method.E3,
        method.E5,
        method.A_EXTRA,
        method.C_EXTRA,
        method.D,
    )
    return np.concatenate([np.ravel(part) for part in parts]).astype(float)


def tolerance(problem: Problem) -> float:
    """Relative tolerance of a step."""
    return problem.rtol


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end``: the motion from ``t_record`` on."""
    from . import _carried

    unit = unit_points()
    mode = problem.field.initial_mode(problem.start, problem.constants)
    state = np.array(problem.start)
    elapsed = 0.0
    steps = 0
    constants, most = np.array(problem.constants), problem.max_steps or MAX_STEPS
    first_step = Flight(problem, interpolated=True).solver(mode, state, problem.t_end).h_abs
    # Time within the mode, and length of the next step.
    clock = np.array([0.0, min(first_step, problem.t_end)])
    times, states = np.empty((BURST, unit.size)), np.empty((BURST, 4, unit.size))
    pieces, crossings = list[Samples](), list[Crossing]()
    while elapsed < problem.t_end:
        begun, bound = float(clock[0]), problem.t_end - elapsed
        rtol, atol = problem.rtol, problem.rtol * 1e-3
        limits = np.array([rtol, atol, bound, problem.t_record - elapsed, most - steps])
        given = np.array([*mode, problem.reach, HYSTERESIS, OVERSHOOT])
        outcome, border, made, kept = _carried.carry(
            constants, given, limits, _tables(), unit, state, clock, times, states
        )
        steps += made
        if kept:
            pieces.append((elapsed + times[:kept], states[:kept].copy()))
        now, length = clock.tolist()
        if outcome == Stop.FULL:
            check_stiffness(problem, state, (now - begun) / made, bound - now)
            continue
        elapsed += now
        if outcome == Stop.TOO_MANY:
            raise too_many_steps(problem, most, elapsed, state)
        if not np.isfinite(state).all():
            raise out_of_range()
        if outcome == Stop.TOO_SMALL:
            raise ConvergenceError(
                f"DOP853 stopped at t = {elapsed:.6g}: the step is too small; use a larger rtol"
            )
        if outcome == Stop.ENDED:
            break
        mode, crossed = CarriedState(problem, state).passed(border, mode, elapsed)
        crossings += crossed
        # Time starts from 0 in every mode, which resolves short times after a crossing.
        clock[:] = 0.0, min(length, problem.t_end - elapsed)
    return assembled(pieces, crossings, problem.t_record)
