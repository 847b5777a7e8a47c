"""DOP853 as SciPy has it, step for step, in code that was compiled on installation: for machines
without heyoka.
"""

from enum import IntEnum, auto
from functools import cache
from importlib import metadata

import numpy as np

from ..core.errors import ConvergenceError
from ..generated import C_SOURCE
from ..models.field import HYSTERESIS, OVERSHOOT
from ..models.load import fits
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import BURST, MAX_STEPS, Problem, check_stiffness, out_of_range, too_many_steps
from .solution import CarriedState, Crossing, Samples, Solution, assembled
from .with_scipy import Flight


class Stop(IntEnum):
    """Why a call of the compiled code stopped, in the order of ``_carried.c``."""

    ENDED = 0
    PASSED = auto()  #: a border
    FULL = auto()  #: no room for more steps
    TOO_SMALL = auto()  #: a step
    TOO_MANY = auto()  #: steps


def available() -> bool:
    """Whether the extension module was built, and from the C library that was generated with the
    rest.
    """
    return fits(f"{__package__}._carried")


def version() -> str:
    """Version of what decides the last bits of a result: the field, and the method's tables."""
    return f"compiled {C_SOURCE}, DOP853 of scipy {metadata.version('scipy')}"


@cache
def _tables() -> FloatArray:
    """The method's coefficients, which SciPy holds, one after the other."""
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
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    from . import _carried

    unit = unit_points()
    mode = problem.field.initial_mode(problem.start, problem.constants)
    state = np.array(problem.start)
    elapsed = 0.0
    steps = 0
    constants, most = np.array(problem.constants), problem.max_steps or MAX_STEPS
    # Time in a mode, and the length of the next step, of which the first is as SciPy chooses it.
    clock = np.array(
        [
            0.0,
            min(
                Flight(problem, interpolated=True).solver(mode, state, problem.t_end).h_abs,
                problem.t_end,
            ),
        ]
    )
    times, states = np.empty((BURST, unit.size)), np.empty((BURST, 4, unit.size))
    pieces, crossings = list[Samples](), list[Crossing]()
    while elapsed < problem.t_end:
        begun, bound = float(clock[0]), problem.t_end - elapsed
        limits = np.array(
            [
                tolerance(problem),
                tolerance(problem) * 1e-3,
                bound,
                problem.t_record - elapsed,
                most - steps,
            ]
        )
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
        # Time runs from 0 in every mode: the closer to the crossing, the more digits it has.
        clock[:] = 0.0, min(length, problem.t_end - elapsed)
    return assembled(pieces, crossings, problem.t_record)
