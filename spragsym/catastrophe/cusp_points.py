"""All cusps, proved complete."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..exact.adaptive_bits import with_enough_bits
from ..exact.intervals import Arithmetic, arithmetic
from ..parameters import FloatArray, Parameters
from . import cusp_proofs
from .fixed_parameters import FIXED


@dataclass(frozen=True)
class Cusps(Result):
    """Points at which two folds meet, sorted by ``mu0``; ``error`` bounds |error| / max(1, |value|) of all six numbers.

    Arrays have the shape (cusps,); angles are radians, lengths over L_0.
    """

    theta0: FloatArray
    mu0: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    error: FloatArray

    def select(self, which: NDArray[np.bool_]) -> Cusps:
        """The cusps that ``which`` marks."""
        return Cusps(*(getattr(self, field.name)[which] for field in fields(self)))

    def __len__(self) -> int:
        return int(self.theta0.size)


def cusps(
    p: Parameters, vary: Sequence[str] = ("theta0", "mu0"), *, arith: Arithmetic | None = None
) -> Cusps:  # fmt: skip
    """All cusps in contact with L > 0, θ₀ in (−π, π] and μ₀ of either sign: proved complete.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β, taken as the exact rationals that the floats are; ``theta0`` and ``mu0`` are not used.
    vary : sequence of str
        θ₀ and μ₀, in whose plane there are closed forms; in others :class:`spragsym.Model` searches.

    Returns
    -------
    Cusps
        Empty if there is no cusp.

    Raises
    ------
    ParameterError, ParameterTypeError
        For parameters that are missing or no scalars.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ (a cubic for α = 0); its roots are isolated exactly.

    Examples
    --------
    >>> found = cusps(Parameters.article())
    >>> print(np.degrees(found.theta0[2]), found.mu0[2])
    68.02095850774431 0.20093178180509003
    """
    exact = tuple(map(Fraction, p.scalars(*FIXED)))
    arith = arith or arithmetic()

    def attempt(bits: int) -> list[tuple[float, ...]]:
        return [point.row(arith) for point in cusp_proofs.cusps(arith, exact, bits)]

    rows = with_enough_bits(arith, 20, attempt, "cusps")
    rows = sorted(((row[0], row[1], *row[6:]) for row in rows), key=lambda row: (row[1], row))
    return Cusps(*np.array(rows, dtype=float).reshape(-1, 7).T.copy())
