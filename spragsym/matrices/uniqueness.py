"""The friction up to which sliding is unique for every load, with contacts that open."""

from __future__ import annotations

import numpy as np
from scipy.linalg import eigh

from ..core.errors import ModelError
from ..numerics.definite import gamma, is_definite
from ..numerics.interval_arrays import FloatArray

#: Frictions beyond this are not looked at.
HIGHEST = 10.0


def unique_up_to(
    stiffness: FloatArray, size: FloatArray, W_n: FloatArray, W_t: FloatArray, k: FloatArray
) -> float:
    """The largest friction found for which sym(1/k + W_n K⁻¹ (W_n + μ W_t)ᵀ) is proved definite,
    for frictions from 0 on; 0 if it is for none. K is the stiffness without that of the contacts.

    Definite at 0 and at a friction it is so between them, as it is linear in it. ``size`` are the
    moduli of what was added to ``stiffness``, to which it is rounded.

    Source: pressures p ≥ 0 and gaps w = A(μ) p + b ≥ 0 with p w = 0 have one solution for every b
    exactly if A(μ) is a P-matrix (R. W. Cottle, J.-S. Pang and R. E. Stone, The Linear
    Complementarity Problem, 1992, theorem 3.3.7), as one with a definite symmetric part is.
    """
    contact = (W_n.T * k) @ W_n
    n, K = len(contact), stiffness - contact
    diagonal = np.diagonal(K)
    if not (diagonal > 0).all():
        raise ModelError(_LOOSE)
    scale = 2.0 ** np.round(-0.5 * np.log2(diagonal))  # exact products
    K = K * scale * scale[:, None]
    lost = gamma(n + 24) * ((size + np.abs(contact)) * scale * scale[:, None])
    lowest = 0.5 * float(np.linalg.eigvalsh(0.5 * (K + K.T))[0])
    norm = float(np.maximum(lost.sum(axis=0), lost.sum(axis=1)).max())
    if lowest <= 0.0 or not is_definite(0.5 * (K + K.T), lowest + norm):
        raise ModelError(_LOOSE)
    W = np.vstack([W_n, W_t]) * scale
    X = np.linalg.solve(K, W.T)
    rest = np.abs(K @ X - W.T) + lost @ np.abs(X)
    rest += gamma(n + 4) * (np.abs(K) @ np.abs(X) + np.abs(W.T))
    right, left = W_n * scale, np.abs(W_n * scale)
    error = np.outer(np.linalg.norm(right, axis=1), np.linalg.norm(rest, axis=0)) / lowest
    error += gamma(n + 4) * (left @ np.abs(X))
    each = len(k)
    normal, along = (right @ X)[:, :each] + np.diag(1.0 / k), (right @ X)[:, each:]
    error[:, :each] += gamma(4) * np.diag(1.0 / k)
    unit = 2.0 ** np.round(-0.5 * np.log2(np.diagonal(normal)))
    normal, along = (0.5 * (one + one.T) * unit * unit[:, None] for one in (normal, along))
    errors = (error[:, :each], error[:, each:])
    bounds = [
        1.01 * float(((one + one.T) * unit * unit[:, None]).sum(axis=1).max()) for one in errors
    ]
    if not is_definite(normal, bounds[0]):
        return 0.0
    least = float(eigh(along, normal, eigvals_only=True)[0])
    limit = min(HIGHEST, -1.0 / least) if least < 0.0 else HIGHEST
    for power in range(40, 0, -1):
        mu = limit * (1.0 - 2.0**-power)
        rounded = gamma(4) * float((np.abs(normal) + mu * np.abs(along)).sum(axis=1).max())
        if is_definite(normal + mu * along, bounds[0] + mu * bounds[1] + rounded):
            return mu
    return 0.0


_LOOSE = (
    "without its contacts the model is not held: its stiffness is not definite; hold each body, "
    "if softly"
)
