"""Floquet multipliers from the mesh intervals of a closed orbit, and test functions: each passes
zero at a bifurcation of the orbit.

The monodromy matrix is a product of the intervals' derivatives. Multiplied out, multipliers below
10⁻¹⁶ of the largest drown in its rounding; so the product is brought to triangular form interval by
interval (the periodic QR algorithm: A. Bojanczyk, G. Golub, P. Van Dooren 1992; K. Lust 2001), once
the flow's own direction, whose multiplier is 1, has been projected off each. So small ones
keep their digits beside large ones. Test functions are products over multipliers, every factor
divided by its size, so that one of 10¹⁰ hides nothing of the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import ComplexArray
from ..numerics.vectors import magnitude, norm

if TYPE_CHECKING:
    from .shooting import Orbit


@dataclass(frozen=True)
class Multipliers:
    """Multipliers of a closed orbit, (m − 1,), largest first, but for the ``trivial`` one of the
    flow's own direction.

    That is 1 but for what the derivatives of the intervals have lost. The ``errors`` are estimates:
    how far the others move if each interval errs by as much as it errs along the flow.
    """

    trivial: float
    others: ComplexArray
    errors: FloatArray

    @property
    def values(self) -> ComplexArray:
        """All of them, the trivial one first."""
        return np.concatenate([[complex(self.trivial)], self.others])


def multipliers_of(intervals: Sequence[FloatArray], flows: Sequence[FloatArray]) -> Multipliers:
    """Multipliers of the product of the intervals' derivatives, ``flows`` the field at the
    beginning of each.
    """
    units = [flow / norm(flow) for flow in flows]
    bases = [np.linalg.qr(unit[:, None], mode="complete")[0][:, 1:] for unit in units]
    parts, trivial, errors = [], 1.0, []
    for i, interval in enumerate(intervals):
        after = (i + 1) % len(intervals)
        carried, due, size = interval @ flows[i], flows[after], float(np.linalg.norm(interval, 2))
        trivial *= float(units[after] @ carried) / norm(due)
        # Errors of an interval's derivative are at least this, in its own size.
        errors.append(max(2e-15, norm(carried - due) / (size * norm(flows[i]))))
        parts.append(bases[after].T @ interval @ bases[i])
    values = eigenvalues_of_product(parts)
    values = values[np.lexsort((-values.imag, -values.real, -np.abs(values)))]
    moved, rng = np.zeros(len(values)), np.random.default_rng(0)
    # Trials that tell how far multipliers move if derivatives err at random by their errors.
    for _ in range(3):
        off = [
            part + error * np.linalg.norm(interval, 2) * rng.choice([-1.0, 1.0], part.shape)
            for part, interval, error in zip(parts, intervals, errors, strict=True)
        ]
        other = eigenvalues_of_product(off)
        for i, value in enumerate(values):
            nearest = int(np.argmin(np.abs(other - value)))
            moved[i] = max(moved[i], abs(other[nearest] - value))
            other = np.delete(other, nearest)
    # What the largest move is multiplied with.
    return Multipliers(trivial, values, 3.0 * moved)


def eigenvalues_of_product(parts: Sequence[FloatArray]) -> ComplexArray:
    """Eigenvalues of parts[-1] … parts[1] parts[0], each to digits of its own.

    Rounds of QR turn the factors triangular; where that is reached, the product falls into blocks
    whose eigenvalues differ much in size, and each block is multiplied out by itself.
    """
    size = len(parts[0])
    product = parts[0]
    for part in parts[1:]:
        product = part @ product
    # A product no larger than this is multiplied out: its smallest multiplier loses no more
    # than these digits.
    if size < 2 or len(parts) < 2 or norm(product) < 1e3:
        return np.linalg.eigvals(product).astype(complex)
    basis, cuts, before = np.eye(size), [0, size], -1
    # Rounds of the periodic QR algorithm, at most.
    for _ in range(12):
        start, factors = basis, []
        for part in parts:
            basis, factor = np.linalg.qr(part @ basis)
            factors.append(factor)
        turned = start.T @ basis
        # Numbers below the diagonal up to this count as 0.
        cuts = [0, *(j for j in range(1, size) if magnitude(turned[j:, :j]) < 1e-14), size]
        if len(cuts) == size + 1 or (before == len(cuts) and before > 2):
            break
        before = len(cuts)
    found = []
    for begin, end in pairwise(cuts):
        block = np.eye(end - begin)
        for factor in factors:
            block = factor[begin:end, begin:end] @ block
        found.append(np.linalg.eigvals(turned[begin:end, begin:end] @ block))
    return np.concatenate(found).astype(complex)


#: Kinds of event that a test function tells.
CRITERIA = ("fold", "period_doubling", "torus")


def _pairs(orbit: Orbit) -> tuple[Any, Any]:
    """Places of the first and of the second of all pairs of multipliers."""
    return np.triu_indices(len(orbit.multipliers.others), 1)


def _factors(orbit: Orbit, kind: str) -> tuple[ComplexArray, FloatArray]:
    """The factors of a test function, 1 ± a multiplier or 1 − a product of two, scaled to size 1 at
    most, and their errors.
    """
    values, moved = orbit.multipliers.others, orbit.multipliers.errors
    if kind == "torus":
        one, other = _pairs(orbit)
        moved = np.abs(values[one]) * moved[other] + np.abs(values[other]) * moved[one]
        values = values[one] * values[other]
    scale = 1 + np.abs(values)
    return (1 + (1 if kind == "period_doubling" else -1) * values) / scale, moved / scale


def criterion_of(kind: str, orbit: Orbit) -> float:
    """Passes zero at a fold, where a multiplier is 1, at a period doubling, where one is −1, and
    where the product of two is 1.

    That is a torus, if they are complex; nothing, if they are real.
    """
    return float(np.prod(_factors(orbit, kind)[0]).real)


def unsure(orbit: Orbit, kind: str) -> float:
    """Error of a test function: by how much it grows where all of its factors are larger by
    theirs.
    """
    factors, errors = _factors(orbit, kind)
    sizes = np.abs(factors)
    return float(np.prod(sizes + errors) - np.prod(sizes))


def is_complex_pair(orbit: Orbit) -> bool:
    """Whether the two multipliers whose product is nearest to 1 are a complex pair, by more than
    their errors.
    """
    found, nearest = orbit.multipliers, np.argmin(np.abs(_factors(orbit, "torus")[0]))
    one = _pairs(orbit)[1][nearest]
    return bool(abs(found.others[one].imag) > max(1e-9, found.errors[one]))
