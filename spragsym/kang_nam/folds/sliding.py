"""Friction at steady sliding."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...generated import laws
from ...models.parameters import NOT_NEGATIVE, POSITIVE, FloatArray, as_numbers


def sliding_friction(mu0: ArrayLike, V: ArrayLike, d: ArrayLike) -> FloatArray:
    """Friction at steady sliding by the regularized law, μ₀ (1 − exp(−d |V|)); the article takes its limit μ₀.

    Give ``p.replace(mu0=sliding_friction(p.mu0, V, d))`` to any function of this package to have the exact one.

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
    return np.asarray(laws.friction(0.0, as_numbers("mu0", mu0, NOT_NEGATIVE), speed, as_numbers("d", d, POSITIVE)))
