"""Curves of onsets of several contacts, of every combination of those that touch."""

import math

import numpy as np
import pytest

import spragsym as ss

PLANE = {"beta": (0.0, 1.0), "mu0": (0.0, 1.0)}
DISC = ss.load("disc_between_pads")


@pytest.mark.thorough
def test_the_middle_of_a_disc_flutters_on_the_curve_of_its_closed_form() -> None:
    """Without damping, μ = |k_y + 2 k_c − k_t/J| √J / (4 √(N_0 (h − N_0))), to where both meet."""
    p = DISC.Parameters(mu0=None, iota=0.4, tau=1.0, kappa=0.1)
    found = ss.onset_curves(p, ("beta", "mu0"), 8, damping=False, between=PLANE)
    # Both end at μ = 0, where the frequencies are alike without friction.
    assert sorted(float(curve["beta"].max()) for curve in found.curves) == pytest.approx(
        [0.5, 1.0], abs=1e-4
    )
    for curve in found.curves:
        assert set(curve["touching"]) == {"upper, lower"}
        exact = np.abs(curve["beta"] + 2 - 2.5) * math.sqrt(0.4) / (4 * math.sqrt(0.1 * 0.9))
        # μ² is what is told, to rounding.
        np.testing.assert_allclose(curve["mu0"] ** 2, exact**2, atol=1e-15)
        assert np.abs(curve["y"]).max() < 1e-12
    # Lift-off has no end in all directions: what is beyond is not searched, and this is said.
    assert found.complete or any("there may be others beyond" in str(it) for it in found.remarks)


@pytest.mark.thorough
def test_curves_of_each_combination_hold_a_pair_on_the_imaginary_axis() -> None:
    """With damping, by the eigenvalues of its states, and the contacts that touch there."""
    found = ss.onset_curves(DISC.Parameters(), ("beta", "mu0"), 4, between=PLANE)
    assert {str(curve["touching"][0]) for curve in found.curves} >= {"upper", "lower"}
    for curve in found.curves:
        place = len(curve["beta"]) // 2
        p = DISC.Parameters(**{name: float(curve[name][place]) for name in PLANE})
        eq = ss.equilibria(p, contact=tuple(str(curve["touching"][place]).split(", ")))
        near = {name: float(curve[name][place]) for name in DISC.coordinates}
        off = [
            max(abs(float(eq[name][slot]) - value) for name, value in near.items())
            for slot in range(int(eq.count))
        ]
        values = eq.damped_eigenvalues[int(np.argmin(off))]
        assert min(off) < 1e-9
        assert np.abs(values - 1j * float(curve["omega"][place])).min() < 1e-7
        p = p.replace(mu0=None)
        single = ss.flutter_onsets(p, "mu0", between={"mu0": PLANE["mu0"]})
        row = np.abs(single["mu0"] - curve["mu0"][place]).argmin()
        assert curve["lyapunov"][place] == pytest.approx(single.lyapunov[row], rel=1e-9)
        assert "undecided" not in curve["criticality"].tolist()
