"""Floquet multipliers of a closed orbit, and test functions that vanish at its bifurcations.

The monodromy matrix is the product of the derivatives of the flow over the mesh intervals. If it
were multiplied out, rounding would destroy multipliers below 10⁻¹⁶ of the largest. So the periodic
QR algorithm (A. Bojanczyk, G. Golub, P. Van Dooren 1992; K. Lust 2001) makes the factors triangular
without forming the product. The direction of the flow, whose multiplier is 1, is projected out of
each factor first.

A test function is a product over the multipliers. Each factor is divided by its size, so that a
multiplier of 10¹⁰ does not hide the others.
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
    """Floquet multipliers of a closed orbit.

    ``trivial`` is the multiplier along the flow, which is 1 up to errors. ``held`` are those along
    a continuum of orbits, one for each direction in which friction holds the mass all the time, or
    in which it may be shifted: they are 1. ``others``, (m − 1 − held,), are sorted by modulus,
    largest first. ``errors`` are estimates: the changes of the others when each factor is perturbed
    by the error that it has along the flow.
    """

    trivial: float
    others: ComplexArray
    errors: FloatArray
    held: int = 0

    @property
    def values(self) -> ComplexArray:
        """All multipliers, (m,): the trivial one, those of what is held, then the others."""
        return np.concatenate([[complex(self.trivial)], np.ones(self.held), self.others])


def multipliers_of(intervals: Sequence[FloatArray], flows: Sequence[FloatArray]) -> Multipliers:
    """Multipliers from the derivatives of the flow over the mesh intervals, (m, m) each; ``flows``,
    (m,) each, are the field at their beginnings.
    """
    tangents = [flow / norm(flow) for flow in flows]
    bases = [np.linalg.qr(unit[:, None], mode="complete")[0][:, 1:] for unit in tangents]
    parts, trivial, errors = [], 1.0, []
    for i, interval in enumerate(intervals):
        after = (i + 1) % len(intervals)
        mapped, exact, size = interval @ flows[i], flows[after], float(np.linalg.norm(interval, 2))
        trivial *= float(tangents[after] @ mapped) / norm(exact)
        # Relative error of the interval's derivative, at least that of rounding.
        errors.append(max(2e-15, norm(mapped - exact) / (size * norm(flows[i]))))
        parts.append(bases[after].T @ interval @ bases[i])
    values = eigenvalues_of_product(parts)
    values = values[np.lexsort((-values.imag, -values.real, -np.abs(values)))]
    moved, rng = np.zeros(len(values)), np.random.default_rng(0)
    for _ in range(3):  # random perturbations
        perturbed = [
            part + error * np.linalg.norm(interval, 2) * rng.choice([-1.0, 1.0], part.shape)
            for part, interval, error in zip(parts, intervals, errors, strict=True)
        ]
        other = eigenvalues_of_product(perturbed)
        for i, value in enumerate(values):
            nearest = int(np.argmin(np.abs(other - value)))
            moved[i] = max(moved[i], abs(other[nearest] - value))
            other = np.delete(other, nearest)
    # A safety factor of 3, as there are few trials.
    return Multipliers(trivial, values, 3.0 * moved)


def eigenvalues_of_product(parts: Sequence[FloatArray]) -> ComplexArray:
    """Eigenvalues of parts[-1] … parts[1] parts[0], each with a small relative error.

    Iterations of the periodic QR algorithm make the factors block triangular, with blocks whose
    eigenvalues differ much in size. Each block is then multiplied out.
    """
    size = len(parts[0])
    product = parts[0]
    for part in parts[1:]:
        product = part @ product
    # Multiplied out, a product of this norm loses three digits of its smallest eigenvalue.
    if size < 2 or len(parts) < 2 or norm(product) < 1e3:
        return np.linalg.eigvals(product).astype(complex)
    basis, cuts, before = np.eye(size), [0, size], -1
    for _ in range(12):
        start, factors = basis, []
        for part in parts:
            basis, factor = np.linalg.qr(part @ basis)
            factors.append(factor)
        turned = start.T @ basis
        # The product is block triangular where this rotation is, up to rounding.
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


#: Bifurcations that have a test function.
CRITERIA = ("fold", "period_doubling", "torus")


def _pairs(orbit: Orbit) -> tuple[Any, Any]:
    """Indices of the first and of the second multiplier of all pairs."""
    return np.triu_indices(len(orbit.multipliers.others), 1)


def _factors(orbit: Orbit, kind: str) -> tuple[ComplexArray, FloatArray]:
    """Factors of a test function, scaled to at most 1, and their errors.

    They are 1 − λ for a fold, 1 + λ for a period doubling, 1 − λμ for a torus, over all multipliers
    λ or pairs of these.
    """
    values, moved = orbit.multipliers.others, orbit.multipliers.errors
    if kind == "torus":
        one, other = _pairs(orbit)
        moved = np.abs(values[one]) * moved[other] + np.abs(values[other]) * moved[one]
        values = values[one] * values[other]
    scale = 1 + np.abs(values)
    return (1 + (1 if kind == "period_doubling" else -1) * values) / scale, moved / scale


def criterion_of(kind: str, orbit: Orbit) -> float:
    """Test function of a bifurcation: it changes sign where a multiplier is 1 (fold) or −1 (period
    doubling), or where the product of two is 1 (torus).

    The last is a torus bifurcation only if the two are complex: see :func:`is_complex_pair`.
    """
    return float(np.prod(_factors(orbit, kind)[0]).real)


def unsure(orbit: Orbit, kind: str) -> float:
    """Error bound of a test function, from the errors of its factors."""
    factors, errors = _factors(orbit, kind)
    sizes = np.abs(factors)
    return float(np.prod(sizes + errors) - np.prod(sizes))


def is_complex_pair(orbit: Orbit) -> bool:
    """True if the two multipliers whose product is nearest to 1 are a complex pair, beyond their
    errors.
    """
    found, nearest = orbit.multipliers, np.argmin(np.abs(_factors(orbit, "torus")[0]))
    one = _pairs(orbit)[1][nearest]
    return bool(abs(found.others[one].imag) > max(1e-9, found.errors[one]))
