"""Equilibria and cusps to any number of digits, by the quartic and by one polynomial in sin θ."""

from collections.abc import Mapping, Sequence
from typing import Any

from ..models.parameters import Parameters
from ..numerics.balls import as_mpf, as_numbers, with_enough_bits
from ..questions import NotInClosedForm
from ..results.precise_states import CuspProof, PreciseCusp, PreciseEquilibria
from .folds import cusp_proofs
from .folds.fold_enclosures import Point
from .quartic import adaptive_precision


def precise_equilibria(_p: Parameters, exact: Mapping[str, Any], contact: bool, digits: int) -> PreciseEquilibria:
    """All equilibria of one point; source: f(θ) = 0, (12)–(13) eliminated."""
    given = [exact[name] for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")]
    found = adaptive_precision.equilibria(*given, contact=contact, digits=digits)
    return PreciseEquilibria(found.states, True, {})


def precise_cusps(_p: Parameters, given: Mapping[str, Any], vary: Sequence[str], digits: int) -> CuspProof:
    """All cusps in the plane of θ₀ and μ₀; source: f = f′ = f″ = 0, one rational polynomial of degree 9 in sin θ."""
    if tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    exact = tuple(given[name] for name in ("kappa", "alpha", "sigma", "beta"))

    def attempt(bits: int) -> list[PreciseCusp]:
        return [_cusp(point, digits) for point in cusp_proofs.cusps(exact, bits)]

    found = with_enough_bits(digits, attempt, "cusps")
    ordered = tuple(sorted(found, key=lambda one: (one.mu0, one.theta0)))
    if exact[1] == 1 + exact[3]:
        return CuspProof(ordered, True, {})
    polynomial, sines = cusp_proofs.cusp_sines(*exact, bits=64)
    return CuspProof(ordered, True, {}, polynomial, tuple(sines), len(sines))


def _cusp(point: Point, digits: int) -> PreciseCusp:
    names = ("theta0", "mu0", "theta", "L", "x", "y")
    numbers, _, radius = as_numbers((*point.parameters[:2], point.theta, point.L, point.x, point.y), digits)
    return PreciseCusp(dict(zip(names, numbers, strict=True)), as_mpf(radius), cusp_proofs.is_versal(point))
