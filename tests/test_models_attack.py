"""What a random attack on all models has found: each case as it was, against forces written by hand from the drawing."""

from __future__ import annotations

import numpy as np
import pytest

import spragsym as ss
from benchmarks.attack_models import equilibria
from benchmarks.attack_references import DRAWN

#: Springs as stiff as these left errors up to 7e-8 on states that were proved.
STIFF = {
    "cubic_contact": {
        "theta0": 5e-324, "mu0": 149698.0, "kappa": 0.00011, "alpha": 4.3e-5, "sigma": 0.004,
        "beta": 0.0002, "gamma": 6.4,
    },
    "damped": {"theta0": np.pi / 2, "mu0": 661074.0, "kappa": 0.278, "alpha": 0.0021, "sigma": 775083.0},
    "two_springs": {
        "theta0": 0.35697, "mu0": 85.89, "kappa": 2.58476, "alpha": 0.0047653, "sigma": 8.228e-5, "beta": 2558.934,
        "theta0_2": 1.78451, "sigma_2": 202940.26, "lambda_2": 43.80468,
    },
}  # fmt: skip


@pytest.mark.parametrize("name", STIFF)
def test_states_of_stiff_springs_are_known_to_all_digits(name: str) -> None:
    """The bound is 1e-12 here too, and it holds in 40 digits."""
    model = ss.load(name)
    values = {**model.base, **STIFF[name]}
    outcome = equilibria(model, DRAWN[name], values, True, np.random.default_rng(1))
    assert outcome["wrong"] == []
    assert outcome["undecided"] == 0
