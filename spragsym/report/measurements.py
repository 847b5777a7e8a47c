"""A friction law from measurements: μ₀ and d fitted to sliding speeds and coefficients."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..display import Result
from ..generated import laws
from ..models.parameters import FloatArray


@dataclass(frozen=True)
class FrictionFit(Result):
    """μ₀ and d of the law μ₀ (1 − exp(−d \\|v\\|)) by least squares, with their standard errors and the rms of what is left.

    ``correlation`` is that of the two errors: a larger μ₀ with a smaller d may fit as well.

    ``slowest`` and ``fastest`` are the smallest and the largest sliding speed that was measured, in m/s.
    """

    mu0: float
    d: float
    mu0_error: float
    d_error: float
    correlation: float
    rms: float
    points: int
    slowest: float
    fastest: float


def fit_friction(speed: FloatArray, friction: FloatArray) -> FrictionFit:
    """μ₀ and d by least squares; for each d the best μ₀ is linear, so that one search over d finds the best of all.

    Notes
    -----
    Source: the regularized law (10) at steady sliding.

    Examples
    --------
    >>> speed = np.array([0.05, 0.1, 0.3, 1.0])
    >>> found = fit_friction(speed, 0.4 * (1 - np.exp(-10 * speed)))
    >>> round(found.mu0, 9), round(found.d, 7)
    (0.4, 10.0)
    """
    from scipy.optimize import minimize_scalar

    moving = speed[speed > 0]

    def shape(d: float) -> FloatArray:
        return np.asarray(laws.friction(0.0, 1.0, speed, d))

    def best(d: float) -> float:
        rise = shape(d)
        return float(rise @ friction / (rise @ rise))

    def left(log_d: float) -> float:
        d = math.exp(log_d)
        return float(((friction - best(d) * shape(d)) ** 2).sum())

    # Beyond these the law is a straight line in v, or a constant, at every speed that was measured.
    ends = math.log(1e-4 / moving.max()), math.log(40.0 / moving.min())
    grid = np.linspace(*ends, 400)
    k = int(np.argmin([left(value) for value in grid]))
    bracket = grid[max(k - 1, 0)], grid[min(k + 1, grid.size - 1)]
    found = minimize_scalar(left, bounds=bracket, method="bounded", options={"xatol": 1e-12})
    d = math.exp(float(found.x))
    mu0 = best(d)
    slopes = np.stack([shape(d), mu0 * speed * np.exp(-d * speed)], axis=1)
    rest = max(speed.size - 2, 1)
    spread = math.sqrt(left(math.log(d)) / rest)
    covariance = np.linalg.pinv(slopes.T @ slopes)
    sizes = np.sqrt(np.abs(np.diag(covariance)))
    errors = spread * sizes
    together = float(np.clip(covariance[0, 1] / max(sizes.prod(), 1e-300), -1.0, 1.0))
    return FrictionFit(
        mu0, d, float(errors[0]), float(errors[1]), together, spread, speed.size, float(moving.min()), float(speed.max())
    )
