"""The generated algebra of the article's model for any number type: without the wrapper that
broadcasts arrays.
"""

from __future__ import annotations

from collections.abc import Callable
from inspect import unwrap
from typing import Any, NamedTuple

import numpy as np

from ..generated import catastrophe as _catastrophe
from ..generated import equilibrium as _equilibrium
from ..generated import stability as _stability
from ..generated.kernel import depressed as depressed
from ..generated.quantities import PARAMETERS
from ..numerics.arithmetic import Number
from ..numerics.interval_arrays import FloatArray

#: The parameters in which f is linear: all except θ₀.
LINEAR = PARAMETERS[1:]

f_coefficients = unwrap(_equilibrium.f_coefficients)
resolvent = unwrap(_equilibrium.resolvent)
t_quartic = unwrap(_equilibrium.t_quartic)
f = unwrap(_equilibrium.f)
f_slope = unwrap(_equilibrium.f_slope)
f_curvature = unwrap(_equilibrium.f_curvature)
f_third = unwrap(_equilibrium.f_third)
f_changes = unwrap(_catastrophe.f_changes)
f_in_differences = unwrap(_catastrophe.f_in_differences)
fold_sextic = unwrap(_catastrophe.fold_sextic)
fold_cubics = unwrap(_catastrophe.fold_cubics)
fold_sine = unwrap(_catastrophe.fold_sine)
fold_angles = unwrap(_catastrophe.fold_angles)
state = unwrap(_equilibrium.state)
stiffness = unwrap(_stability.stiffness)
_invariants = unwrap(_stability.invariants)


def f_along(vary: str, cos0: Number, sin0: Number, *values: Any) -> tuple[Any, Any]:
    """The coefficients (a, b, d, m) of f and of its derivative by a parameter other than θ₀;
    ``values`` have 0 for that parameter.
    """
    return f_coefficients(cos0, sin0, *values, 1), f_changes(cos0, sin0, *values)[
        PARAMETERS.index(vary)
    ]


def state_of(*given: Any) -> tuple[Any, Any, Any]:
    """L, x and y in contact, from cos θ, sin θ, cos θ₀ and sin θ₀, and all of κ, α, σ and β."""
    *angles, kappa, _, sigma, beta = given
    return state(*angles, kappa, sigma, beta, 1)


def invariants(*state: Any) -> tuple[Any, Any, Any]:
    """Trace, determinant and discriminant of K, (27), at a state; arguments as of ``stiffness``."""
    K = stiffness(*state)
    return _invariants(*K[0], *K[1])


def cos_sin(angle: float | FloatArray) -> tuple[Any, Any]:
    """Cosine and sine of floats."""
    return np.cos(angle), np.sin(angle)


def landing(t: Number, trig: tuple[Any, ...], sqrt: Callable[[Any], Any]) -> Number:
    """tan(θ/2) of the third equilibrium at a fold, where t is a double root of the quartic.

    The product of the roots is −1, and their sum is a coefficient of the quartic; so the other two
    solve τ² + g τ − 1/t² = 0, and one of them is positive. ``trig`` is (a, b, d, m) of f, in any
    number type.
    """
    *_, e3, e4 = t_quartic(*trig)
    g = 2 * t + e3 / e4
    return (sqrt(g * g + 4 / (t * t)) - g) / 2


class Fixed(NamedTuple):
    """κ, α, σ and β."""

    kappa: float
    alpha: float
    sigma: float
    beta: float
