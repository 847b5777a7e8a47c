"""The model in which the spring keeps its angle θ₀, the article's reference [17]."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from ...generated import linear_sprag as _linear
from ...generated import stability as _stability
from ...models.parameters import FloatArray, Parameters
from ...questions import of_article
from ...results.result import Result


@dataclass(frozen=True)
class LinearSprag(Result):
    """Steady sliding with the spring's angle held at θ₀, the article's reference [17].

    Arrays have the shape of the parameters; angles are radians, lengths over L_0.

    ``determinant`` ≤ 0 is the sprag condition; at a pole x and y are infinite. ``poles`` lists the θ₀ in (0, π) of the poles, two
    at the last axis, NaN where there are none.
    """

    table_angles: ClassVar[frozenset[str]] = frozenset({"poles"})

    x: FloatArray
    y: FloatArray
    determinant: FloatArray
    poles: FloatArray
    critical_friction: FloatArray


@of_article("equilibria(p) has the states")
def linear_sprag(p: Parameters) -> LinearSprag:
    """Displacement, poles and critical friction of the constant-angle model; all shapes broadcast.

    Parameters
    ----------
    p : Parameters
        Any shape; ``theta0`` and ``mu0`` are needed.

    Returns
    -------
    LinearSprag

    Raises
    ------
    ParameterError
        For parameters that are missing.

    Notes
    -----
    Source: (12), (13) linearized about x = y = 0; article, Section 3.

    Examples
    --------
    >>> model = linear_sprag(Parameters.article(theta0=np.radians(49.0), mu0=0.7))
    >>> print(np.degrees(model.poles).round(3))
    [62.784 82.034]
    """
    p.require("theta0", "mu0")

    c0, s0 = np.cos(p.theta0), np.sin(p.theta0)
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = _linear.displacement(c0, s0, p.mu0, p.kappa, p.alpha, p.sigma, p.beta)
        (K11, K12), (K21, K22) = _stability.stiffness(c0, s0, 1.0, p.mu0, p.alpha, p.sigma, p.beta, 1)
        _, determinant, _ = _stability.invariants(K11, K12, K21, K22)
        e0, e1, e2 = _linear.pole_quadratic(p.mu0, p.alpha, p.sigma, p.beta)
        # Factors of the discriminant.
        middle = _twice_the_mean(e0, e2)
        large = 0.5 * (-e1 + np.sqrt(-e1 - middle) * np.sqrt(-e1 + middle))
        # T = e0/large and large/e2. For α = 0 the second is infinite: a pole at 90°. For μ₀ = 0 as well, both are.
        poles = np.stack([np.arctan2(e0, large), np.where(large > 0, np.arctan2(large, e2), 0.5 * np.pi)], axis=-1)
        poles = np.where(np.isfinite(large)[..., None], poles, np.nan)
    shape = p.shape
    x, y, determinant = (np.broadcast_to(np.asarray(value, dtype=float), shape).copy() for value in (x, y, determinant))
    return LinearSprag(
        x,
        y,
        determinant,
        poles=np.broadcast_to(poles, (*shape, 2)).copy(),
        critical_friction=np.broadcast_to(linear_critical_friction(p), shape).copy(),
    )


@of_article("folds(p, vary) has the values at which states meet")
def linear_critical_friction(p: Parameters) -> Any:
    """μ_cr of the constant-angle model: it has a pole if and only if μ₀ ≥ μ_cr.

    Parameters
    ----------
    p : Parameters
        α, σ, β, scalars or arrays; the others are not used.

    Returns
    -------
    float or ndarray

    Raises
    ------
    ParameterError
        For parameters that are missing.

    Notes
    -----
    Source: article, Section 3; μ_cr² = 4 α (α + σ)(1 + β)(1 + β + σ)/σ², where the quadratic of the poles has a double root.
    Infinite only where it is beyond float64.

    Examples
    --------
    >>> print(round(linear_critical_friction(Parameters.article()), 6))
    0.574073
    """
    e0, e1, e2 = _linear.pole_quadratic(1.0, p.alpha, p.sigma, p.beta)  # e1 is in proportion to μ₀
    with np.errstate(over="ignore"):
        value = _twice_the_mean(e0, e2) / -e1
    return float(value) if np.ndim(value) == 0 else value


def _twice_the_mean(e0: Any, e2: Any) -> Any:
    """2 √(e0 e2), by a root of each, so that it does not leave the range of float64: the −e1 at which the two poles are one."""
    return 2 * np.sqrt(e0) * np.sqrt(e2)
