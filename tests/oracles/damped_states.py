"""How many λ of the article's model grow with the damping of its friction law, from equations
written by hand: in floats for many states, and to fifty digits for one.
"""

from collections.abc import Mapping
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from tests.oracles.forces_by_hand import DRAWN

#: Digits of one state.
DIGITS = 50


def linearizations(
    x: NDArray[Any], y: NDArray[Any], p: Mapping[str, Any]
) -> tuple[NDArray[Any], NDArray[Any]]:
    """K, shape (N, 2, 2), and C₁₁ of states in contact: slopes of (8) and (9), with μ₀ for the
    friction at steady sliding.
    """
    along, across = np.cos(p["theta0"]) - x, np.sin(p["theta0"]) - y
    length = np.hypot(along, across)
    turn, firm = p["sigma"] / length**3, p["sigma"] * (1 - 1 / length)
    K = np.stack(
        [
            np.stack([firm + turn * along**2 + p["alpha"], turn * along * across + p["mu0"]], -1),
            np.stack([turn * along * across, firm + turn * across**2 + p["beta"] + 1], -1),
        ],
        axis=-2,
    )
    return K, -y * p["mu0"] * p["d"] * np.exp(-p["d"] * p["V"])


def eigenvalues(K: NDArray[Any], damping: NDArray[Any]) -> NDArray[Any]:
    """All λ, shape (N, 4)."""
    first_order = np.zeros((*damping.shape, 4, 4))
    first_order[..., :2, 2:] = np.eye(2)
    first_order[..., 2:, :2] = -K
    first_order[..., 2, 2] = -damping
    return np.linalg.eigvals(first_order)


def growing(x: float, y: float, p: Mapping[str, float]) -> int:
    """The number of λ with a positive real part at the state near x, y, to fifty digits."""
    with mpmath.workdps(2 * DIGITS):
        P = {name: mpmath.mpf(float(value)) for name, value in p.items()}

        def forces(*q: Any) -> list[Any]:
            return list(DRAWN["kang_nam"].forces(q, (0, 0), P, mpmath, True, P["mu0"]))

        q = mpmath.findroot(forces, (x, y), tol=mpmath.mpf(10) ** -DIGITS)
        step = mpmath.mpf(10) ** (-DIGITS // 2)
        K = mpmath.matrix(2)
        for column in range(2):
            moved = [
                forces(*(q[i] + way * step * (i == column) for i in range(2))) for way in (-1, 1)
            ]
            for row in range(2):
                K[row, column] = (moved[0][row] - moved[1][row]) / (2 * step)
        damping = -q[1] * P["mu0"] * P["d"] * mpmath.exp(-P["d"] * P["V"])
        trace, determinant = K[0, 0] + K[1, 1], K[0, 0] * K[1, 1] - K[0, 1] * K[1, 0]
        roots = mpmath.polyroots(
            [1, damping, trace, damping * K[1, 1], determinant], maxsteps=500, extraprec=800
        )
        return sum(mpmath.re(root) > 0 for root in roots)
