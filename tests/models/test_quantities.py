"""The model's names, meanings, units and ranges: written once, true, and read by everything that says them."""

from __future__ import annotations

import math

import pytest

import spragsym as ss
from spragsym.generated import scales
from spragsym.generated.quantities import BASE_VALUES, PARAMETERS, QUANTITIES
from spragsym.parameters import RANGES, range_of


@pytest.mark.parametrize("name", ["x", "y", "L", "vx", "vy", "V", "d", "tau"])
def test_units_are_the_scales_of_the_model(name: str) -> None:
    """What a unit says, computed, is the product of the scales of length and time that were derived."""
    m, k_c, L_0 = 0.3, 7.0e5, 0.05
    length, time, _ = scales.scales(m, k_c, L_0)
    derived = {"x": length, "y": length, "L": length, "vx": length / time, "vy": length / time, "V": length / time,
               "d": time / length, "tau": time}[name]  # fmt: skip
    said = QUANTITIES[name].unit.replace("L_0 sqrt", "L_0 * sqrt")
    value = eval(said, {"L_0": L_0, "m": m, "k_c": k_c, "sqrt": math.sqrt})  # noqa: S307  # our own table
    assert value == pytest.approx(derived, rel=1e-15)


def test_ranges_keep_out_what_has_no_meaning() -> None:
    """The ends of each range, tried: the equations need 0 < θ₀ < π, κ, σ > 0 and allow α = β = μ₀ = 0."""
    base = {"theta0": 1.0, **BASE_VALUES}
    assert tuple(base) == PARAMETERS
    for name in ("alpha", "beta", "mu0"):
        ss.Parameters(**{**base, name: 0.0})
    for name, value in {"theta0": 0.0, "kappa": 0.0, "sigma": 0.0, "mu0": -1e-300, "alpha": -1e-300, "beta": -1e-300}.items():
        with pytest.raises(ss.ParameterError, match=name):
            ss.Parameters(**{**base, name: value})
    with pytest.raises(ss.ParameterError, match="theta0"):
        ss.Parameters(**{**base, "theta0": math.pi})
    assert str(RANGES["theta0"]) == "(0, pi)"
    assert str(range_of("V_dim")) == "(-inf, inf)"
