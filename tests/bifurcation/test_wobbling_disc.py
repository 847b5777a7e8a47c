"""Onset of squeal of the wobbling disc, by the closed form of its page."""

import numpy as np
import pytest

import spragsym as ss


def off(
    mu: float,
    phi: float,
    eta: float,
    kappa: float,
    speed: float,
    nu: float,
    delta: float,
    zeta: float,
) -> tuple[float, float]:
    """How much more friction is needed, and the frequency."""
    k_a, g = 1 + 2 * kappa, phi * speed
    c_a, c_b = zeta + 2 * delta + mu * nu * eta**2 / (2 * speed), zeta
    sums = 1 + k_a + g**2 + c_a * c_b
    square = (sums + np.sqrt(sums**2 - 4 * k_a)) / 2
    needed = c_a * (square - 1) + c_b * (square - k_a)
    return needed / (eta * kappa * g) - mu, float(np.sqrt(square))


@pytest.mark.thorough
def test_squeal_sets_in_where_the_closed_form_says() -> None:
    model, rng, count = ss.load("wobbling_disc"), np.random.default_rng(0), 0
    for _ in range(20):
        low = np.array([0.5, 0.05, 0.05, 0.05, 0.001, 0.001, 0.001])
        high = np.array([3.0, 0.4, 0.6, 0.5, 0.05, 0.01, 0.01])
        phi, eta, kappa, speed, nu, delta, zeta = rng.uniform(low, high).tolist()
        p = model.Parameters(
            phi=phi, eta=eta, kappa=kappa, Omega=speed, nu=nu, delta=delta, zeta=zeta
        )
        found = ss.flutter_onsets(p, between={"mu0": (0.0, 20.0)})
        assert found.complete
        count += len(found)
        given = phi, eta, kappa, speed, nu, delta, zeta
        for mu, omega in zip(found.mu0.tolist(), found.omega.tolist(), strict=True):
            missed, own = off(mu, *given)
            assert abs(missed) < 1e-12 * mu
            assert omega == pytest.approx(own, rel=1e-12)
        # Less than needed just below the only onset, more above; none where it is never enough.
        assert (off(20.0, *given)[0] < 0) == (len(found) == 1)
    assert count > 10
