"""The friction of the lowest cusp, and the parameters at which the lowest fold has the friction given."""

from __future__ import annotations

import math

import numpy as np

from ...errors import ParameterError
from ...parameters import RANGES, FloatArray, Parameters
from ...results.critical_values import value_at
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
    (mu0,) = p.scalars("mu0")

    def lowest(value: float) -> float:
        return float(critical_friction(p.replace(theta0=None, mu0=None, **{vary: value})))

    return value_at(lowest, ("mu0", mu0), vary, bracket, RANGES[vary])
