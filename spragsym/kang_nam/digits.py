"""Equilibria and cusps to any number of digits, by the quartic and by one polynomial in sin θ."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ..exact.adaptive_bits import with_enough_bits
from ..exact.intervals import Arithmetic, arithmetic, as_mpf, rounded_up
from ..exact.polynomials import Undecided
from ..results.equilibria import Stability
from ..results.precise_states import CuspProof, PreciseCusp, PreciseEquilibria, PreciseEquilibrium
from .catastrophe import cusp_proofs
from .catastrophe.fold_enclosures import Point
from .statics import adaptive_precision


def precise_equilibria(exact: Mapping[str, Any], contact: bool, digits: int, arith: Arithmetic | None) -> PreciseEquilibria:
    """All equilibria of one point; source: f(θ) = 0, (12)–(13) eliminated."""
    given = [exact[name] for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")]
    found = adaptive_precision.equilibria(*given, contact=contact, digits=digits, arith=arith)
    states = (
        PreciseEquilibrium(
            {name: getattr(state, name) for name in ("theta", "L", "x", "y")}, Stability(state.stability), state.error, found.fold
        )
        for state in found.states
    )
    return PreciseEquilibria(tuple(states), True, {})


def precise_cusps(given: Mapping[str, Any], digits: int, arith: Arithmetic | None) -> CuspProof:
    """All cusps; source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ with rational coefficients."""
    exact = tuple(given[name] for name in ("kappa", "alpha", "sigma", "beta"))
    chosen = arith or arithmetic()

    def attempt(bits: int) -> list[PreciseCusp]:
        return [_cusp(chosen, point, digits) for point in cusp_proofs.cusps(chosen, exact, bits)]

    found = with_enough_bits(chosen, digits, attempt, "cusps")
    ordered = tuple(sorted(found, key=lambda one: (one.mu0, one.theta0)))
    if exact[1] == 1 + exact[3]:
        return CuspProof(ordered, (), (), 0)
    polynomial, sines, count = cusp_proofs.cusp_sines(*exact, bits=64)
    return CuspProof(ordered, polynomial, tuple(sines), count)


def _cusp(arith: Arithmetic, point: Point, digits: int) -> PreciseCusp:
    middles, radius = [], Fraction(0)
    for interval in (*point.parameters[:2], point.theta, point.L, point.x, point.y):
        low, high = arith.ends(interval)
        middle = (low + high) / 2
        half = rounded_up(high - middle)
        if half > Fraction(1, 10**digits) * max(Fraction(1), abs(middle)):
            raise Undecided(f"an error of {float(half):.1e}")
        radius = max(radius, half)
        middles.append(as_mpf(middle))
    theta0, mu0, theta, L, x, y = middles
    return PreciseCusp(theta0, mu0, theta, L, x, y, as_mpf(radius), cusp_proofs.is_versal(arith, point))
