"""Roots of many polynomials of one degree: eigenvalues of companion matrices, polished by Newton's method, in float64."""

from typing import Any

import numpy as np

from .interval_arrays import FloatArray
from .polynomials import derivative, evaluate


def by_power(coefficients: FloatArray) -> tuple[FloatArray, ...]:
    """Coefficients from the last axis, each ready to meet several arguments, as :func:`evaluate` takes them."""
    return tuple(np.moveaxis(coefficients, -1, 0)[..., None])


def eigenvalues(coefficients: FloatArray) -> Any:
    """All complex roots of each polynomial, lowest power first; 0 where its leading coefficient is too small for them."""
    degree = coefficients.shape[-1] - 1
    companion = np.zeros((*coefficients.shape[:-1], degree, degree))
    companion[..., range(1, degree), range(degree - 1)] = 1.0
    companion[..., :, -1] = -coefficients[..., :-1] / coefficients[..., -1:]
    companion[~np.isfinite(companion).all(axis=(-1, -2))] = 0.0
    return np.linalg.eigvals(companion)


def polished(coefficients: FloatArray, roots: FloatArray) -> FloatArray:
    """Three Newton steps on positive roots in ascending order, none longer than half the way to a neighbour or to 0."""
    polynomial = by_power(coefficients)
    slope = derivative(polynomial)
    for _ in range(3):
        step = evaluate(polynomial, roots) / evaluate(slope, roots)
        gap = np.fmin(np.diff(roots, axis=-1, append=np.inf), np.diff(roots, axis=-1, prepend=0.0))
        roots = np.where(np.abs(step) < 0.5 * gap, roots - step, roots)
    return roots
