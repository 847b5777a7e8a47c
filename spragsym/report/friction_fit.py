"""The friction law fitted to measured friction by least squares."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..generated import laws
from ..models.parameters import FloatArray, Span
from ..results import Result


@dataclass(frozen=True)
class FrictionFit(Result):
    """Least-squares fit of the law μ₀ (1 − exp(−d \\|v\\|)), with standard errors.

    ``rms`` is the standard deviation of the residuals. ``correlation`` is that of the errors of μ₀
    and d. ``slowest`` and ``fastest`` are the smallest and largest measured sliding speed above 0
    in m/s.
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
    """Fit μ₀ and d by least squares. For each d the best μ₀ is that of a linear problem, so that a
    search over d only finds the global minimum.

    Source: the regularized law (10) at steady sliding.

    >>> speed = np.array([0.05, 0.1, 0.3, 1.0])
    >>> found = fit_friction(speed, 0.4 * (1 - np.exp(-10 * speed)))
    >>> round(found.mu0, 9), round(found.d, 7)
    (0.4, 10.0)
    """
    moving = speed[speed > 0]

    def shape(d: float) -> FloatArray:
        return laws.friction(0.0, 1.0, speed, d)

    def best(log_d: float) -> Span:
        """The best μ₀, and the sum of squared residuals."""
        rise = shape(math.exp(log_d))
        mu0 = float(rise @ friction / (rise @ rise))
        return mu0, float(((friction - mu0 * rise) ** 2).sum())

    # Outside this range of d the law is linear in v, or constant, at all measured speeds.
    grid = np.linspace(math.log(1e-4 / moving.max()), math.log(40.0 / moving.min()), 400)
    k = int(np.argmin([best(value)[1] for value in grid]))
    ends = grid[np.clip([k - 1, k + 1], 0, grid.size - 1)]
    from scipy.optimize import minimize_scalar  # a slow import, which input errors do not need

    found = minimize_scalar(
        lambda log_d: best(log_d)[1], bounds=ends, method="bounded", options={"xatol": 1e-12}
    )
    d, (mu0, left) = math.exp(float(found.x)), best(float(found.x))
    spread = math.sqrt(left / max(speed.size - 2, 1))
    slopes = np.stack([shape(d), mu0 * speed * np.exp(-d * speed)], axis=1)
    covariance = np.linalg.pinv(slopes.T @ slopes)
    sizes = np.sqrt(np.abs(np.diag(covariance)))
    mu0_error, d_error = (spread * sizes).tolist()
    return FrictionFit(
        mu0,
        d,
        mu0_error,
        d_error,
        correlation=float(np.clip(covariance[0, 1] / max(sizes.prod(), 1e-300), -1.0, 1.0)),
        rms=spread,
        points=speed.size,
        slowest=float(moving.min()),
        fastest=float(speed.max()),
    )
