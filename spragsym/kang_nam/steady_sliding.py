"""Explicit formulas for steady sliding: the equilibrium surface, the regularized friction, and the
linear model with a constant angle of the spring.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ParameterError
from ..display import Column, named_fields
from ..generated import catastrophe as _catastrophe
from ..generated import kernel as solver
from ..generated import laws
from ..generated import linear_sprag as _linear
from ..generated.quantities import PARAMETERS
from ..models.parameters import NOT_NEGATIVE, POSITIVE, FloatArray, as_numbers
from ..numerics.interval_arrays import Int8Array, quiet
from ..results import EquilibriumType, Result
from . import kernel
from .kernel import Fixed
from .only import of_article
from .parameters import Parameters


@dataclass(frozen=True, eq=False)
class Surface(Result):
    """The equilibrium surface over (θ, θ₀); NaN and code 0 where it has no state in contact with μ₀
    finite.

    Arrays have the common shape of θ, θ₀ and the parameters; angles are radians, lengths over L_0.
    """

    schema = (Column("undamped", "1", "type of state by (27)", EquilibriumType),)

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    undamped: Int8Array


@of_article("equilibria(p) has all states over a grid of parameters")
def surface(p: Parameters, theta: ArrayLike, theta0: ArrayLike) -> Surface:
    """The friction at which θ is the direction of an equilibrium, explicitly: no root is sought.

    Parameters
    ----------
    p : Parameters
        κ, α, σ and β; its ``theta0`` and ``mu0`` are not used.
    theta, theta0 : array_like
        Radians, 0 < θ, θ₀ < π; they broadcast together and with the parameters.

    Returns
    -------
    Surface
        Friction of either sign; states in lift-off and with L ≤ 0 are NaN.

    Raises
    ------
    ParameterError, ParameterTypeError
        For angles out of their range, and parameters that are missing.

    Notes
    -----
    Source: f(θ) = 0 is linear in μ₀; (14), (15).

    Examples
    --------
    >>> import numpy as np
    >>> s = surface(Parameters.article(), theta=np.radians(100.0), theta0=np.radians(60.0))
    >>> round(float(s.mu0), 6), int(s.undamped)
    (0.16305, 1)
    """
    direction = as_numbers("theta", theta, Parameters.ranges["theta0"])
    reference = as_numbers("theta0", theta0, Parameters.ranges["theta0"])
    try:
        direction, reference, *fixed = np.broadcast_arrays(
            direction, reference, *(p[name] for name in Fixed._fields)
        )
    except ValueError as error:
        raise ParameterError(
            f"theta {direction.shape}, theta0 {reference.shape} and the parameters do not broadcast"
        ) from error
    c, s, c0, s0 = *kernel.cos_sin(direction), *kernel.cos_sin(reference)
    with quiet():
        mu0 = _catastrophe.surface(c, s, c0, s0, *fixed)
        L, x, y = kernel.state_of(c, s, c0, s0, *fixed)
        point = solver.Point(c0, s0, mu0, *[*fixed, 1])
        slope = kernel.f_slope(c, s, *kernel.f_coefficients(*point))
        code = solver.stability(solver.Direction(c, s), L, slope, 0.0, point).code
    good = (y < 0) & (L > 0) & np.isfinite(mu0)
    mu0, L, x, y = (np.where(good, value, np.nan) for value in (mu0, L, x, y))
    return Surface(direction, reference, mu0, L, x, y, np.where(good, code, 0).astype(np.int8))


@in_usual_state
def sliding_friction(mu0: ArrayLike, V: ArrayLike, d: ArrayLike) -> FloatArray:
    """Friction at steady sliding by the regularized law, μ₀ (1 − exp(−d |V|)); the article takes
    its limit μ₀.

    Give ``p.replace(mu0=sliding_friction(p.mu0, V, d))`` to any function of this package to have
    the exact one.

    Parameters
    ----------
    mu0, V, d : array_like
        Friction at full slip, belt speed of either sign, and steepness of the law; they broadcast.

    Returns
    -------
    ndarray

    Raises
    ------
    ParameterError, ParameterTypeError
        For numbers out of their range.

    Notes
    -----
    Source: (10) at x' = 0.

    Examples
    --------
    >>> round(float(sliding_friction(0.5, V=0.5, d=10.0)), 6)
    0.496631
    """
    speed = np.abs(as_numbers("V", V))
    return np.asarray(
        laws.friction(
            0.0, as_numbers("mu0", mu0, NOT_NEGATIVE), speed, as_numbers("d", d, POSITIVE)
        )
    )


@dataclass(frozen=True, eq=False)
class LinearSprag(Result):
    """Steady sliding with the spring's angle held at θ₀, the article's reference [17].

    Arrays have the shape of the parameters; angles are radians, lengths over L_0.

    ``determinant`` ≤ 0 is the sprag condition; at a pole x and y are infinite. ``poles`` lists the
    θ₀ in (0, π) of the poles, two at the last axis, NaN where there are none.
    """

    schema = (
        Column("determinant", "1", "of the linear equations; at most 0 where it sprags"),
        Column("poles_1", "rad", "first inclination of a pole"),
        Column("poles_2", "rad", "second inclination of a pole"),
        Column("critical_friction", "1", "friction above which there are poles"),
    )

    x: FloatArray
    y: FloatArray
    determinant: FloatArray
    poles: FloatArray
    critical_friction: FloatArray

    def _shown(self) -> dict[str, Any]:
        first, second = np.moveaxis(self.poles, -1, 0)
        others = {name: one for name, one in named_fields(self).items() if name != "poles"}
        return others | {"poles_1": first, "poles_2": second}


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
    theta0, mu0, kappa, *springs = p.broadcast(*PARAMETERS)
    c0, s0 = kernel.cos_sin(theta0)
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = _linear.displacement(c0, s0, mu0, kappa, *springs)
        determinant = np.asarray(kernel.invariants(c0, s0, 1.0, mu0, *springs, 1)[1])
        e0, e1, e2 = _linear.pole_quadratic(mu0, *springs)
        # Factors of the discriminant.
        middle = _twice_the_mean(e0, e2)
        large = 0.5 * (-e1 + np.sqrt(-e1 - middle) * np.sqrt(-e1 + middle))
        # T = e0/large and large/e2. For α = 0 the second is infinite: a pole at 90°. For μ₀ = 0 as
        # well, both are.
        poles = np.stack(
            [np.arctan2(e0, large), np.where(large > 0, np.arctan2(large, e2), 0.5 * np.pi)],
            axis=-1,
        )
        poles = np.where(np.isfinite(large)[..., None], poles, np.nan)
    return LinearSprag(
        x, y, determinant, poles, np.broadcast_to(linear_critical_friction(p), p.shape).copy()
    )


@of_article("folds(p, vary) has the values at which states meet")
def linear_critical_friction(p: Parameters) -> FloatArray | float:
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
    Source: article, Section 3; μ_cr² = 4 α (α + σ)(1 + β)(1 + β + σ)/σ², where the quadratic of the
    poles has a double root. Infinite only where it is beyond float64.

    Examples
    --------
    >>> print(round(linear_critical_friction(Parameters.article()), 6))
    0.574073
    """
    e0, e1, e2 = _linear.pole_quadratic(1.0, p.alpha, p.sigma, p.beta)  # e1 is in proportion to μ₀
    with np.errstate(over="ignore"):
        value = _twice_the_mean(e0, e2) / -e1
    return float(value) if np.ndim(value) == 0 else value


def _twice_the_mean(e0: FloatArray, e2: FloatArray) -> FloatArray:
    """2 √(e0 e2), the −e1 at which the two poles coincide; as a product of roots, which does not
    overflow.
    """
    return 2 * np.sqrt(e0) * np.sqrt(e2)
