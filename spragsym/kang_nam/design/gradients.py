"""How the value at which the state jumps changes with each parameter."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...design.gradients import JumpGradient
from ...design.values import told
from ...generated import catastrophe as _catastrophe
from ...parameters import NAMES, FloatArray, Parameters
from .jump_values import first_jumps


def jump_gradient(p: Parameters, vary: str = "mu0", *, direction: str = "up") -> JumpGradient:
    """Derivatives of :func:`jump_value` by all parameters.

    Parameters
    ----------
    p, vary, direction
        As for :func:`jump_value`.

    Returns
    -------
    JumpGradient
        NaN where there is no jump.

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense.

    Notes
    -----
    Source: f = f′ = 0 at the jump, differentiated: since f′ = 0, dv/dπ = −(∂f/∂π)/(∂f/∂v). At a cusp, where f″ = 0 as well,
    digits are lost, and beyond it there is no jump.

    Examples
    --------
    >>> import numpy as np
    >>> slopes = jump_gradient(Parameters.article(theta0=np.radians(30.0)))
    >>> print(f"{slopes.theta0 * np.radians(1.0):.4f} for each degree, {slopes.sigma * 0.01:.4f} for each 0.01 of sigma")
    -0.0313 for each degree, 0.0186 for each 0.01 of sigma
    """
    found = told(first_jumps(p, vary, direction))
    here: dict[str, Any] = {name: getattr(p, name) for name in NAMES} | {vary: found.value}
    changes = by_parameter(here, found.theta)
    along = changes[vary]
    with np.errstate(invalid="ignore", divide="ignore"):
        slopes = {name: -change / along for name, change in changes.items()}
    slopes[vary] = np.where(np.isnan(found.value), np.nan, 0.0)
    return JumpGradient(vary, found.value, slopes)


def by_parameter(values: dict[str, Any], theta: FloatArray) -> dict[str, FloatArray]:
    """∂f/∂π in contact for each parameter π, at the direction θ of the spring."""
    with np.errstate(invalid="ignore"):
        c, s, c0, s0 = np.cos(theta), np.sin(theta), np.cos(values["theta0"]), np.sin(values["theta0"])
        pairs = _catastrophe.unfolding(c, s, c0, s0, *(values[name] for name in NAMES[1:]))
    return {name: pair[0] for name, pair in zip(NAMES, pairs, strict=True)}
