"""The equilibrium surface, explicitly: the friction at which a direction is an equilibrium."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from ...errors import ParameterError
from ...generated import catastrophe as _catastrophe
from ...generated import kernel as solver
from ...models.parameters import RANGES, FloatArray, Parameters, as_numbers
from ...numerics.interval_arrays import Int8Array
from ...questions import of_article
from ...results.equilibria import Stability
from ...results.result import Result
from ..quartic import kernel
from .fixed_parameters import FIXED


@dataclass(frozen=True)
class Surface(Result):
    """The equilibrium surface over (θ, θ₀); NaN and code 0 where it has no state in contact with μ₀ finite.

    Arrays have the common shape of θ, θ₀ and the parameters; angles are radians, lengths over L_0.
    """

    table_codes: ClassVar[Mapping[str, type[Stability]]] = {"stability": Stability}

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    stability: Int8Array


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
    >>> round(float(s.mu0), 6), int(s.stability)
    (0.16305, 1)
    """
    direction = as_numbers("theta", theta, RANGES["theta0"])
    reference = as_numbers("theta0", theta0, RANGES["theta0"])
    kappa, alpha, sigma, beta = (getattr(p, name) for name in FIXED)
    try:
        direction, reference, kappa, alpha, sigma, beta = np.broadcast_arrays(direction, reference, kappa, alpha, sigma, beta)
    except ValueError as error:
        raise ParameterError(f"theta {direction.shape}, theta0 {reference.shape} and the parameters do not broadcast") from error
    c, s, c0, s0 = np.cos(direction), np.sin(direction), np.cos(reference), np.sin(reference)
    with np.errstate(all="ignore"):
        mu0 = _catastrophe.surface(c, s, c0, s0, kappa, alpha, sigma, beta)
        L, x, y = kernel.state(c, s, c0, s0, kappa, sigma, beta, 1)
        slope = kernel.f_slope(c, s, *kernel.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1))
        point = solver.Point(c0, s0, mu0, kappa, alpha, sigma, beta, 1)
        code = solver.stability(solver.Direction(c, s), L, slope, 0.0, point).code
    good = (y < 0) & (L > 0) & np.isfinite(mu0)
    mu0, L, x, y = (np.where(good, value, np.nan) for value in (mu0, L, x, y))
    return Surface(direction, reference, mu0, L, x, y, np.where(good, code, 0).astype(np.int8))
