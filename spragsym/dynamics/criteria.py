"""Test functions of a closed orbit: each passes zero where something happens to it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..parameters import FloatArray
from .shooting import Loop, rate


def along_and_across(loop: Loop) -> FloatArray:
    """The monodromy matrix in orthonormal directions, that of the flow first."""
    flow = rate(loop.field, loop.guess.states[0], loop.constants)
    basis, _ = np.linalg.qr(np.column_stack([flow, np.eye(len(flow))]))
    seen: FloatArray = basis.T @ loop.monodromy @ basis
    return seen


def across_flow(loop: Loop) -> FloatArray:
    """The monodromy matrix across the flow, shape (m − 1, m − 1): its eigenvalues are the multipliers but the trivial one."""
    return along_and_across(loop)[1:, 1:]


def multipliers(loop: Loop) -> NDArray[np.complex128]:
    """Eigenvalues of the monodromy matrix: the trivial one first, the others by size, largest first.

    The trivial one belongs to the flow's own direction, and the others to what is across it: so that they are told apart even
    where several are 1.
    """
    seen = along_and_across(loop)
    others = np.linalg.eigvals(seen[1:, 1:]).astype(complex)
    order = np.lexsort((-others.imag, -others.real, -np.abs(others)))
    return np.concatenate([[complex(seen[0, 0])], others[order]])


def at_one(loop: Loop) -> float:
    """Passes zero where a multiplier is 1: a fold, in one parameter."""
    matrix = across_flow(loop)
    return float(np.linalg.det(np.eye(len(matrix)) - matrix))


def at_minus_one(loop: Loop) -> float:
    """Passes zero where a multiplier is −1: a period doubling."""
    matrix = across_flow(loop)
    return float(np.linalg.det(np.eye(len(matrix)) + matrix))


def on_circle(loop: Loop) -> float:
    """Passes zero where the product of two multipliers is 1: a torus, if they are complex; nothing, if they are real."""
    values = np.linalg.eigvals(across_flow(loop))
    product = 1.0 + 0.0j
    for i in range(len(values)):
        for j in range(i):
            product *= 1 - values[i] * values[j]
    return float(product.real)


def is_complex_pair(loop: Loop) -> bool:
    """Whether the two multipliers whose product is nearest to 1 are a complex pair."""
    values = np.linalg.eigvals(across_flow(loop))
    pairs = [(abs(values[i] * values[j] - 1), abs(values[i].imag)) for i in range(len(values)) for j in range(i)]
    return bool(pairs) and min(pairs)[1] > 1e-9


#: Kinds of event that a test function tells.
CRITERIA: dict[str, Callable[[Loop], float]] = {"fold": at_one, "period_doubling": at_minus_one, "torus": on_circle}
