"""How many λ of the article's model grow with the damping of its friction law, from equations
written by hand: in floats, and to fifty digits by Arb.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

#: Digits of a state and of Hurwitz's determinants.
DIGITS = 50


def linearizations(
    x: NDArray[Any], y: NDArray[Any], p: Mapping[str, Any]
) -> tuple[NDArray[Any], NDArray[Any]]:
    """K, shape (N, 2, 2), and C₁₁ of states in contact: slopes of (8) and (9), with μ₀ for the
    friction at steady sliding.
    """
    along, across, length = _spring(x, y, p)
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


def _spring(x: NDArray[Any], y: NDArray[Any], p: Mapping[str, Any]) -> tuple[Any, Any, Any]:
    """The spring's extent along and across the belt, and its length."""
    along, across = np.cos(p["theta0"]) - x, np.sin(p["theta0"]) - y
    return along, across, np.sqrt(along * along + across * across)


def signs(x: NDArray[Any], y: NDArray[Any], p: Mapping[str, Any]) -> NDArray[Any]:
    """The sign of the largest growth of the states near x, y, shape (N,), by Newton's method and
    Hurwitz's determinants to fifty digits; 0 where these do not tell it.
    """
    from flint import arb, ctx

    middle = np.frompyfunc(lambda ball: ball.mid(), 1, 1)
    with ctx.workdps(2 * DIGITS):
        exact = np.frompyfunc(lambda number: arb(float(number)), 1, 1)
        given = {name: exact(column) for name, column in p.items()}
        x, y = exact(x), exact(y)
        for _ in range(8):
            along, across, length = _spring(x, y, given)
            firm = given["sigma"] * (1 - 1 / length)
            forces = (
                given["alpha"] * x - firm * along + given["mu0"] * y,
                (1 + given["beta"]) * y - firm * across + given["kappa"],
            )
            (K, a3), fx, fy = linearizations(x, y, given), *forces
            determinant = K[:, 0, 0] * K[:, 1, 1] - K[:, 0, 1] * K[:, 1, 0]
            step = (
                (K[:, 1, 1] * fx - K[:, 0, 1] * fy) / determinant,
                (K[:, 0, 0] * fy - K[:, 1, 0] * fx) / determinant,
            )
            x, y = middle(x - step[0]), middle(y - step[1])
        a0, a1, a2 = determinant, a3 * K[:, 1, 1], K[:, 0, 0] + K[:, 1, 1]
        second = a3 * a2 - a1
        hurwitz = np.array([a3, second, a1 * second - a3 * a3 * a0, a0])
        settled = np.max(np.abs(np.array(step)), axis=0) < arb(10) ** -DIGITS
        positive, negative = (hurwitz > 0).all(axis=0), (hurwitz < 0).any(axis=0)
    return np.where(settled, np.where(positive, -1, np.where(negative, 1, 0)), 0)
