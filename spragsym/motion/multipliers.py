"""Floquet multipliers from the stretches of a closed orbit: small ones keep their digits beside large ones.

The monodromy matrix is a product of the stretches' derivatives. Multiplied out, multipliers below 10⁻¹⁶ of the largest drown in
its rounding; so the product is brought to triangular form stretch by stretch (the periodic QR algorithm: A. Bojanczyk, G. Golub,
P. Van Dooren 1992; K. Lust 2001), once the flow's own direction, whose multiplier is 1, has been projected off each stretch.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import ComplexArray

#: A product no larger than this is multiplied out: its smallest multiplier loses no more than these digits.
PLAIN = 1e3

#: Rounds of the periodic QR algorithm, at most, and what counts as triangular.
ROUNDS, TRIANGULAR = 12, 1e-14

#: Errors of a stretch's derivative are at least this, in its own size.
ROUNDING = 2e-15

#: Trials that tell how far multipliers move by such errors, and what the largest move is multiplied with.
TRIALS, SAFETY = 3, 3.0


@dataclass(frozen=True)
class Multipliers:
    """Multipliers of a closed orbit, (m − 1,), largest first, but for the ``trivial`` one of the flow's own direction.

    That is 1 but for what the derivatives of the stretches have lost. The ``errors`` are estimates: how far the others move if
    each stretch errs by as much as it errs along the flow.
    """

    trivial: float
    others: ComplexArray
    errors: FloatArray

    @property
    def values(self) -> ComplexArray:
        """All of them, the trivial one first."""
        return np.concatenate([[complex(self.trivial)], self.others])


def multipliers_of(stretches: Sequence[FloatArray], flows: Sequence[FloatArray]) -> Multipliers:
    """Multipliers of the product of the stretches' derivatives, ``flows`` the field at the beginning of each."""
    units = [flow / np.linalg.norm(flow) for flow in flows]
    bases = [np.linalg.qr(unit[:, None], mode="complete")[0][:, 1:] for unit in units]
    parts, trivial, errors = [], 1.0, []
    for i, stretch in enumerate(stretches):
        after = (i + 1) % len(stretches)
        carried, due, size = stretch @ flows[i], flows[after], float(np.linalg.norm(stretch, 2))
        trivial *= float(units[after] @ carried) / float(np.linalg.norm(due))
        errors.append(max(ROUNDING, float(np.linalg.norm(carried - due)) / (size * float(np.linalg.norm(flows[i])))))
        parts.append(bases[after].T @ stretch @ bases[i])
    values = eigenvalues_of_product(parts)
    values = values[np.lexsort((-values.imag, -values.real, -np.abs(values)))]
    moved, rng = np.zeros(len(values)), np.random.default_rng(0)
    for _ in range(TRIALS):
        off = [
            part + error * np.linalg.norm(stretch, 2) * rng.choice([-1.0, 1.0], part.shape)
            for part, stretch, error in zip(parts, stretches, errors, strict=True)
        ]
        other = eigenvalues_of_product(off)
        for i, value in enumerate(values):
            nearest = int(np.argmin(np.abs(other - value)))
            moved[i] = max(moved[i], abs(other[nearest] - value))
            other = np.delete(other, nearest)
    return Multipliers(trivial, values, SAFETY * moved)


def eigenvalues_of_product(parts: Sequence[FloatArray]) -> ComplexArray:
    """Eigenvalues of parts[-1] … parts[1] parts[0], each to digits of its own.

    Rounds of QR turn the factors triangular; where that is reached, the product falls into blocks whose eigenvalues differ
    much in size, and each block is multiplied out by itself.
    """
    size = len(parts[0])
    product = parts[0]
    for part in parts[1:]:
        product = part @ product
    if size < 2 or len(parts) < 2 or np.linalg.norm(product) < PLAIN:
        return np.linalg.eigvals(product).astype(complex)
    basis, cuts, before = np.eye(size), [0, size], -1
    for _ in range(ROUNDS):
        start, factors = basis, []
        for part in parts:
            basis, factor = np.linalg.qr(part @ basis)
            factors.append(factor)
        turned = start.T @ basis
        cuts = [0, *(j for j in range(1, size) if np.abs(turned[j:, :j]).max() < TRIANGULAR), size]
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
