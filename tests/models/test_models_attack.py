"""What a random attack on all models has found: each case as it was, against forces written by hand
from the drawing.
"""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.by_hand import equilibria, field, load
from tests.oracles.emission import compare
from tests.oracles.forces_by_hand import DRAWN

#: Springs as stiff as these left errors up to 7e-8 on states that were proved.
STIFF = {
    "cubic_contact": {
        "theta0": 5e-324,
        "mu0": 149698.0,
        "kappa": 0.00011,
        "alpha": 4.3e-5,
        "sigma": 0.004,
        "beta": 0.0002,
        "gamma": 6.4,
    },
    "damped": {
        "theta0": np.pi / 2,
        "mu0": 661074.0,
        "kappa": 0.278,
        "alpha": 0.0021,
        "sigma": 775083.0,
    },
    "two_springs": {
        "theta0": 0.35697,
        "mu0": 85.89,
        "kappa": 2.58476,
        "alpha": 0.0047653,
        "sigma": 8.228e-5,
        "beta": 2558.934,
        "theta0_2": 1.78451,
        "sigma_2": 202940.26,
        "lambda_2": 43.80468,
    },
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", STIFF)
def test_states_of_stiff_springs_are_known_to_all_digits(name: str) -> None:
    """The bound is 1e-12 here too, and it holds in 40 digits."""
    model = ss.load(name).search
    values = {**model.base, **STIFF[name]}
    outcome = equilibria(model, DRAWN[name], values, True, np.random.default_rng(1))
    assert outcome["wrong"] == []
    assert outcome["undecided"] == 0


# ------------------------------------------------------------------------------------------------
# a contact that hardens exponentially


@pytest.fixture(scope="module")
def penalty(tmp_path_factory: pytest.TempPathFactory) -> Any:
    pytest.importorskip("sympy")
    return load("penalty", tmp_path_factory.mktemp("derived"))


#: N = k_c l (e^(δ/l) − 1) with an l so small that e^(1/l) is no number.
SHALLOW = {
    "theta0": 0.12052879740527103,
    "mu0": 1.61e-5,
    "kappa": 2.63e-06,
    "alpha": 0.0,
    "sigma": 284164.3,
    "depth_e": 1.44e-05,
    "V": 0.96439,
    "d": 344.5567,
}


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["scipy", "heyoka"])
def test_a_motion_above_a_belt_that_hardens_within_a_hair(penalty: Any, backend: str) -> None:
    """From touch to lift-off: against SciPy's LSODA on forces by hand, and the energy is a
    number.
    """
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    from scipy.integrate import solve_ivp

    start, t_end = [0.0, 0.0, SHALLOW["V"], 0.0], 0.01
    tr = ss.simulate(penalty.Parameters(**SHALLOW), start=start, t_end=t_end, backend=backend)
    known = solve_ivp(
        field(DRAWN["penalty"], SHALLOW),
        (0.0, t_end),
        start,
        method="LSODA",
        rtol=1e-11,
        atol=1e-13,
    )
    np.testing.assert_allclose(tr.state[:, -1], known.y[:, -1], rtol=0, atol=2e-7)
    assert len(tr.events.t) == 2
    energy = tr.energy()
    assert abs(energy[-1] - energy[0] - tr.integral(tr.power())) < 1e-6 * np.abs(tr.vx).max() ** 2


# ------------------------------------------------------------------------------------------------
# arguments


@pytest.mark.by_hand("rail")
@pytest.mark.thorough
@pytest.mark.parametrize("name", ["hertz_contact", "stribeck", "rail"])
def test_functions_in_floats_intervals_and_digits(name: str, tmp_path: Path) -> None:
    """Every function that is generated: intervals hold what 50 digits give, and floats are near
    it.
    """
    pytest.importorskip("sympy")
    assert compare(name, 2, 1, tmp_path) == []
