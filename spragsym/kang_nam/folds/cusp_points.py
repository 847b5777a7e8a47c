"""All cusps, proved complete."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

import numpy as np

from ...models.parameters import Parameters
from ...numerics.balls import with_enough_bits
from ...questions import NotInClosedForm
from ...results.points import Points, in_closed_form
from . import cusp_proofs
from .fixed_parameters import FIXED
from .fold_points import STATE, in_ranges


def cusps(
    p: Parameters,
    vary: Sequence[str] | None = None,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> Points:
    """The closed form of :func:`spragsym.cusps` in the plane of θ₀ and μ₀: proved complete.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ (a cubic for α = 0); its roots are isolated exactly. Parameters
    are taken as the exact rationals that the floats are.
    """
    if vary is not None and tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    exact = tuple(map(Fraction, p.scalars(*FIXED)))

    def attempt(bits: int) -> list[tuple[float, ...]]:
        return [point.row() for point in cusp_proofs.cusps(exact, bits)]

    rows = with_enough_bits(20, attempt, "cusps")
    rows = sorted(((row[0], row[1], *row[6:]) for row in rows), key=lambda row: (row[1], row))
    *columns, error = np.array(rows, dtype=float).reshape(-1, 7).T.copy()
    values = dict(zip(("theta0", "mu0", *STATE), columns, strict=True))
    spans = {"theta0": (-math.pi, math.pi), "mu0": (-math.inf, math.inf)}
    every = Points(**in_closed_form(p, ("theta0", "mu0"), np.full(len(rows), "cusp"), error, values, spans=spans))
    return in_ranges(every, between)
