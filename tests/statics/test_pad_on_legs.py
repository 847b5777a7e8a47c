"""The pad on two legs: its states, the friction at which its rear leg lifts, and its motion while
both touch, in closed form.
"""

import math

import numpy as np
import pytest

import spragsym as ss

MODEL = ss.load("pad_on_legs")


def drawn(rng: np.random.Generator) -> dict[str, float]:
    """Parameters at random, but for the friction."""
    return {
        "kappa": rng.uniform(0.01, 0.1),
        "alpha": rng.uniform(0.2, 1.0),
        "tau": rng.uniform(0.05, 1.0),
        "eta": rng.uniform(0.5, 1.5),
    }


@pytest.mark.thorough
def test_its_rear_leg_lifts_where_a_lever_says() -> None:
    """It passes at (2 k_c a² + k_t)/(2 k_c a h) to the front leg alone; with k_t = 0 it ends."""
    rng = np.random.default_rng(31)
    for _ in range(20):
        values = drawn(rng)
        for kind, torsion in (("passes", values["tau"]), ("border_fold", 0.0)):
            exact = (2 + torsion) / (2 * values["eta"])
            p = MODEL.Parameters(**values | {"mu0": None, "tau": torsion})
            at = ss.folds(p, vary="mu0", between={"mu0": (0.5 * exact, 1.2 * exact)})
            row = np.flatnonzero(at["at_border"] == "rear")
            assert list(at.kind[row]) == [kind]
            depth, tilt = values["kappa"] / 2, values["kappa"] / 2
            place = [exact, exact * values["kappa"] / values["alpha"], -depth, tilt]
            found = [at[name][row].item() for name in ("mu0", "x", "y", "phi")]
            np.testing.assert_allclose(found, place, rtol=1e-12)


@pytest.mark.thorough
def test_its_states_on_two_legs_and_on_one() -> None:
    """Balances of a lever, on either side of the friction at which the rear leg lifts."""
    rng = np.random.default_rng(32)
    for _ in range(20):
        values = drawn(rng)
        kappa, tau, eta = (values[name] for name in ("kappa", "tau", "eta"))
        lifts = (2 + tau) / (2 * eta)
        for mu0 in rng.uniform([0.0, lifts], [lifts, 2 * lifts]):
            eq = ss.equilibria(MODEL.Parameters(mu0=mu0, **values))
            if mu0 < lifts:
                touching, y, phi = "front, rear", -kappa / 2, mu0 * eta * kappa / (2 + tau)
            else:  # the front leg bears all of the load, on the arms h μ and −a
                phi = kappa * (mu0 * eta - 1) / tau
                touching, y = "front", phi - kappa
            assert list(eq["touching"]) == [touching]
            found = [eq[name][0] for name in ("x", "y", "phi")]
            exact = [mu0 * kappa / values["alpha"], y, phi]
            np.testing.assert_allclose(found, exact, rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("values", [[0.5, 1.0, 1.5], [1.5, 1.0, 0.5], [1.0, 1.5], [0.5, 1.0]])
def test_a_path_over_a_value_at_which_a_leg_just_touches(values: list[float]) -> None:
    """The rear leg lifts at (2 + 0.5)/(2 * 1.25) = 1 exactly, and touches there."""
    path = ss.quasi_static_path(MODEL.Parameters(tau=0.5, eta=1.25), "mu0", values)
    assert path.jumps == ()
    assert list(path["touching"]) == ["front" if mu0 > 1 else "front, rear" for mu0 in values]
    tilts = [0.05 * (1.25 * mu0 - 1) / 0.5 if mu0 > 1 else 0.025 * mu0 for mu0 in values]
    np.testing.assert_allclose(path["phi"], tilts, rtol=1e-12)


def test_without_friction_it_rocks_on_both_legs() -> None:
    """Three oscillators apart: √k_x along, a damped one across, √(2 + k_t)/√J of tilting."""
    alpha, tau, iota, zeta, kappa = 0.5, 0.3, 0.3, 0.1, 0.2
    p = MODEL.Parameters(mu0=0.0, kappa=kappa, alpha=alpha, tau=tau, iota=iota, zeta=zeta)
    eq = ss.equilibria(p)
    tr = ss.simulate(p, x0=0.1, y0=float(eq["y"][0]) + 0.02, phi0=0.05, t_end=60.0)
    assert len(tr.events.on("front")) == len(tr.events.on("rear")) == 0
    omega = math.sqrt(2 - zeta**2 / 4)
    across = np.cos(omega * tr.t) + zeta / (2 * omega) * np.sin(omega * tr.t)
    exact = {
        "x": 0.1 * np.cos(math.sqrt(alpha) * tr.t),
        "y": -kappa / 2 + 0.02 * np.exp(-zeta / 2 * tr.t) * across,
        "phi": 0.05 * np.cos(math.sqrt((2 + tau) / iota) * tr.t),
    }
    for name, value in exact.items():
        np.testing.assert_allclose(tr[name], value, atol=1e-10)
