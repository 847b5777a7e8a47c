"""Rational parameters exactly on a border of the closed forms: decided where θ₀ drops out, and equality is exact."""

from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss


@pytest.mark.parametrize("theta0", [0.4, 2.0])
def test_a_spring_that_the_preload_shrinks_to_nothing_holds_no_mass(theta0: float) -> None:
    # Off the belt without other springs: θ = ±90°, L = 1 ± κ/σ, y = sin θ₀ − L sin θ > 0.
    for kappa, sigma in ((8.0, 8.0), (0.3, 0.3), (np.nextafter(8.0, 0.0), 8.0), (np.nextafter(8.0, 9.0), 8.0)):
        p = ss.Parameters(theta0=theta0, mu0=4.0, kappa=kappa, sigma=sigma, alpha=0.0, beta=0.0)
        lengths = [1 + sign * Fraction(kappa) / Fraction(sigma) for sign in (-1, 1)]
        there = [float(L) for L, sine in zip(lengths, (-1, 1), strict=True) if L > 0 and np.sin(theta0) - float(L) * sine > 0]
        eq = ss.equilibria(p, contact=False)
        assert eq.count == len(there)
        assert eq.L[: len(there)].tolist() == pytest.approx(there, rel=1e-12, abs=0)
