"""On a border of the closed forms, exactly and almost: decided where equality is exact, and in
floats where a preload is tiny.
"""

from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss
from spragsym.generated.equilibrium import f_coefficients, f_slope


@pytest.mark.parametrize("theta0", [0.4, 2.0])
def test_a_spring_that_the_preload_shrinks_to_nothing_holds_no_mass(theta0: float) -> None:
    # Off the belt without other springs: θ = ±90°, L = 1 ± κ/σ, y = sin θ₀ − L sin θ > 0.
    for kappa, sigma in (
        (8.0, 8.0),
        (0.3, 0.3),
        (np.nextafter(8.0, 0.0), 8.0),
        (np.nextafter(8.0, 9.0), 8.0),
    ):
        p = ss.Parameters(theta0=theta0, mu0=4.0, kappa=kappa, sigma=sigma, alpha=0.0, beta=0.0)
        lengths = [1 + sign * Fraction(kappa) / Fraction(sigma) for sign in (-1, 1)]
        there = [
            float(L)
            for L, sine in zip(lengths, (-1, 1), strict=True)
            if L > 0 and np.sin(theta0) - float(L) * sine > 0
        ]
        eq = ss.equilibria(p, contact=False)
        assert eq.count == len(there)
        assert eq.L[: len(there)].tolist() == pytest.approx(there, rel=1e-12, abs=0)


def test_a_tiny_preload_is_told_in_floats() -> None:
    # As κ → 0 one state goes to θ₀, where y → 0: the derivative of y by κ says from which side, and
    # f differs between the two.
    rng = np.random.default_rng(5)
    theta0, mu0, alpha, sigma, beta = rng.uniform(
        [[0.1], [0], [0], [0.1], [0.1]], [[3], [2], [2], [2], [1]], (5, 2000)
    )
    p = ss.Parameters(
        theta0=theta0,
        mu0=mu0,
        kappa=10 ** rng.uniform(-300, -9, 2000),
        alpha=alpha,
        sigma=sigma,
        beta=beta,
    )
    c, s = np.cos(theta0), np.sin(theta0)
    for nbar, backend in ((1, "numpy"), (0, "numpy"), (1, "auto"), (0, "auto")):
        ss.kang_nam.set_backend(backend)
        slope = f_slope(c, s, *f_coefficients(c, s, mu0, 0.0, alpha, sigma, beta, nbar))
        along = -1 - sigma * c * ((alpha + sigma) * c + mu0 * nbar * s) / slope
        eq = ss.equilibria(p, contact=nbar == 1)
        clear = (np.abs(slope) > 1e-3) & (np.abs(along) > 1e-3)
        assert not eq.escalated[clear].any()
        here = (np.abs(eq.theta - theta0[:, None]) < 1e-4).any(axis=-1)
        assert (here == (along < 0 if nbar else along > 0))[clear].all()
        assert clear.mean() > 0.98
