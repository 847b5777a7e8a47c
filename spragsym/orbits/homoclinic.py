"""The homoclinic end of a branch of cycles, from the law of their periods.

Near an orbit that leaves a saddle and returns to it, a cycle of period T lies at the value v = v* +
C exp(−Λ T) of the parameter. Λ is the absolute real part of the saddle's leading eigenvalue, the
one nearest to the imaginary axis; where a cycle passes several saddles, or one several times, 1/Λ
is the sum of those of all passes. Y. A. Kuznetsov, Elements of applied bifurcation theory, ch. 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..core.errors import ConvergenceError
from ..motion.classify import equilibrium_near
from ..motion.shooting import Orbit
from ..numerics.vectors import norm
from .arclength import BranchPoint, uncertainty


def slowest_states(orbit: Orbit, still: float) -> list[np.ndarray]:
    """The state of the smallest rate in each pass near a place of rest, where the rate is below
    ``still``.
    """
    states = orbit.samples().states.T
    sizes = np.array([norm(orbit.rate(state)) for state in states])
    begin = int(np.argmax(sizes))
    states, sizes = np.roll(states, -begin, axis=0), np.roll(sizes, -begin)
    edges = np.flatnonzero(np.diff((sizes < 10 * still).astype(int))) + 1
    bounds = pairwise([0, *edges.tolist(), len(sizes)])
    passes = [low + int(np.argmin(sizes[low:high])) for low, high in bounds]
    return [states[i] for i in passes if sizes[i] < still]


def leading(orbit: Orbit, state: np.ndarray) -> complex:
    """The leading eigenvalue of the saddle near a state; ConvergenceError if there is none."""
    field, constants, mode = orbit.field, orbit.constants, orbit.mode(state)
    rest = equilibrium_near(field, constants, state[: len(field.coordinates)], mode)
    eigenvalues = np.linalg.eigvals(field.matrix(rest.tolist(), constants, mode))
    if not eigenvalues.real.min() < 0 < eigenvalues.real.max():
        raise ConvergenceError("it rests at no saddle")
    return complex(min(eigenvalues, key=lambda value: abs(value.real)))


def limit_of_periods(points: Sequence[BranchPoint], still: float) -> tuple[float, float]:
    """The value to which a branch tends as the period grows beyond all bounds, and its error.

    Two points give the value by the law; the error is the change from that of the two before, and
    what the errors of both values amount to. Without a saddle whose eigenvalues are known, or if
    cycles spiral at it, the value is that of the last point, and the error the range of the values
    before it.
    """
    last = points[-1]
    try:
        eigenvalues = [leading(last.orbit, at) for at in slowest_states(last.orbit, still)]
        span = sum(1 / abs(value.real) for value in eigenvalues)
        spirals = any(value.imag for value in eigenvalues)
    except (ConvergenceError, ZeroDivisionError, np.linalg.LinAlgError):
        span, spirals = last.orbit.period / 4, True
    chosen = [last]
    for point in reversed(points[:-1]):
        if point.orbit.period < chosen[-1].orbit.period - span:
            chosen.append(point)
    rounding = uncertainty(last)
    near = [point.value for point in chosen[:4]]
    if spirals or len(near) < 3:
        return last.value, 2 * float(np.ptp(near)) + rounding

    def tended(one: BranchPoint, other: BranchPoint) -> float:
        grown = np.expm1((other.orbit.period - one.orbit.period) / span)
        return float(other.value + (other.value - one.value) / grown)

    value, before = (tended(chosen[i + 1], chosen[i]) for i in (0, 1))
    return value, abs(value - before) + 3 * rounding
