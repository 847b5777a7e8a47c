"""All cusps, proved complete."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from ...exact.adaptive_bits import with_enough_bits
from ...exact.intervals import Arithmetic, arithmetic
from ...parameters import Parameters
from ...results.points import Points, in_closed_form
from . import cusp_proofs
from .fixed_parameters import FIXED
from .fold_points import STATE


def cusps(
    p: Parameters, vary: Sequence[str] = ("theta0", "mu0"), *, arith: Arithmetic | None = None
) -> Points:  # fmt: skip
    """All cusps in contact with L > 0, θ₀ in (−π, π] and μ₀ of either sign: proved complete.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β, taken as the exact rationals that the floats are; ``theta0`` and ``mu0`` are not used.
    vary : sequence of str
        θ₀ and μ₀, in whose plane there are closed forms; in others :class:`spragsym.Model` searches.

    Returns
    -------
    Points
        Sorted by ``mu0``; empty if there is no cusp.

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
    *columns, error = np.array(rows, dtype=float).reshape(-1, 7).T.copy()
    values = dict(zip(("theta0", "mu0", *STATE), columns, strict=True))
    spans = {"theta0": (-math.pi, math.pi), "mu0": (-math.inf, math.inf)}
    return Points(**in_closed_form(p, ("theta0", "mu0"), np.full(len(rows), "cusp"), error, values, spans=spans))
