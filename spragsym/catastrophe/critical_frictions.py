"""The friction of the lowest cusp, and the parameters at which the lowest fold has the friction given."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from ..errors import ConvergenceError, ParameterError
from ..parameters import RANGES, FloatArray, Parameters, as_number
from .cusp_points import cusps
from .fixed_parameters import FIXED
from .lowest_fold import critical_friction


def cusp_friction(p: Parameters) -> float | FloatArray:
    """μ_cusp, the friction of the lowest cusp with 0 < θ₀ < π: where folds are born, not the lowest of them.

    What decides whether the state of small deformation can jump is :func:`critical_friction`.

    Parameters
    ----------
    p : Parameters
        κ, α, σ, β, scalars or arrays; ``theta0`` and ``mu0`` are not used.

    Returns
    -------
    float or ndarray
        ``inf`` where there is no cusp.

    Raises
    ------
    ParameterError
        For parameters that are missing.

    Notes
    -----
    Source: the cusp polynomial.

    Examples
    --------
    >>> print(cusp_friction(Parameters.article()))
    0.20093178180509003
    """
    kappa, alpha, sigma, beta = np.broadcast_arrays(*(getattr(p, name) for name in FIXED))
    result = np.array([
        _lowest_cusp(*map(float, point)) for point in zip(kappa.flat, alpha.flat, sigma.flat, beta.flat, strict=True)
    ]).reshape(kappa.shape)  # fmt: skip
    return result if result.ndim else float(result)


def _lowest_cusp(kappa: float, alpha: float, sigma: float, beta: float) -> float:
    found = cusps(Parameters(kappa=kappa, alpha=alpha, sigma=sigma, beta=beta))
    inside = (found.theta0 > 0) & (found.theta0 < math.pi) & (found.mu0 >= 0)
    return float(found.mu0[inside].min()) if inside.any() else math.inf


def critical_value(p: Parameters, vary: str, bracket: tuple[float, float]) -> float:
    """The value of a parameter at which the lowest fold has the friction μ₀: on one side of it the small state jumps at no angle.

    Parameters
    ----------
    p : Parameters
        Scalars with ``mu0``; the parameter that varies is not used.
    vary : str
        ``"kappa"``, ``"alpha"``, ``"sigma"`` or ``"beta"``.
    bracket : (float, float)
        Two values with the critical friction on different sides of μ₀.

    Returns
    -------
    float
        To 1e-13, relative.

    Raises
    ------
    ParameterError, ParameterTypeError
        For a parameter that moves no fold, a bracket with the critical friction on one side of μ₀, and parameters that are no
        scalars.

    Notes
    -----
    Source: :func:`critical_friction`, less μ₀.

    Examples
    --------
    >>> print(f"{critical_value(Parameters.article(), 'beta', (1, 2)):.9f}")
    1.632329272
    """
    if vary not in FIXED:
        raise ParameterError(f"vary = {vary!r} does not change the critical friction; choose one of {', '.join(FIXED)}")
    low, high = (as_number(f"bracket[{i}]", value, RANGES[vary]) for i, value in enumerate(bracket))
    if not low < high:
        raise ParameterError(f"bracket = ({low}, {high}) is empty; give two values, the smaller first")
    (mu0,) = p.scalars("mu0")

    def friction_at(value: float) -> float:
        return float(critical_friction(p.replace(theta0=None, mu0=None, **{vary: value})))

    def excess(value: float) -> float:
        return math.atan(friction_at(value)) - math.atan(mu0)  # finite where there is no fold

    ends = excess(low), excess(high)
    if ends[0] * ends[1] > 0:
        frictions = ", ".join(f"{_in_words(friction_at(value))} at {vary} = {value:g}" for value in (low, high))
        raise ParameterError(f"bracket: the critical friction is {frictions}, both on one side of mu0 = {mu0:g}; widen it")
    low, high = _within_a_factor(excess, low, high)
    root = low if low == high else float(brentq(excess, low, high, xtol=1e-300, rtol=8.9e-16, maxiter=200))
    if abs(excess(root)) > 1e-9:
        below, above = (friction_at(max(float(np.nextafter(root, end)), RANGES[vary].low)) for end in (-math.inf, math.inf))
        raise ConvergenceError(
            f"the critical friction jumps across mu0 = {mu0:g} at {vary} = {root:.12g}, from {_in_words(below)} to "
            f"{_in_words(above)}: there it has no value between; try a bracket on one side"
        )
    return root


def _within_a_factor(excess: Callable[[float], float], low: float, high: float) -> tuple[float, float]:
    """A bracket whose larger end is at most twice the smaller, or one value: halved in the exponent, at most 12 times."""
    ends = [excess(low), excess(high)]
    for value, end in zip((low, high), ends, strict=True):
        if end == 0:
            return value, value
    smallest = float(np.finfo(float).smallest_normal)
    while high > 2 * max(low, smallest):
        middle = math.sqrt(max(low, smallest)) * math.sqrt(high)
        value = excess(middle)
        if value == 0:
            return middle, middle
        low, high = (low, middle) if value * ends[0] < 0 else (middle, high)
    return low, high


def _in_words(friction: float) -> str:
    return "infinite (there is no fold)" if math.isinf(friction) else f"{friction:.6g}"
