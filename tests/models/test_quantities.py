"""The model's names, meanings, units and ranges: written once, true, and read by everything that says them."""

from __future__ import annotations

import math

import pytest

import spragsym as ss
from spragsym.generated import scales
from spragsym.generated.quantities import BASE_VALUES, PARAMETERS, QUANTITIES
from spragsym.models.load import shipped
from spragsym.parameters import RANGES, range_of


@pytest.mark.parametrize("name", shipped())
def test_files_say_what_one_of_each_number_is(name: str) -> None:
    """Of parameters by the quantities of the page, in any units of measure; of results by those of what they are made of."""
    from spragsym.studies import brake_quantities

    model = ss.load(name)
    about, said = model.about, model.quantities
    bases = dict(zip((entry["name"] for entry in about["units"]), (0.3, 7.0e5, 0.05), strict=False))
    sizes = {**bases, "sqrt": math.sqrt, "rad": 1.0}
    given = {entry["quantity"]: 0.1 * (place + 1) for place, entry in enumerate(about["parameters"])}
    p, _ = brake_quantities.dimensionless(name, {**given, **bases})

    def one_of(key: str) -> float:
        return float(eval(said[key][0], {}, sizes))  # noqa: S307  # written by the derivation

    for entry in about["parameters"]:
        assert float(getattr(p, entry["name"])) * one_of(entry["name"]) == pytest.approx(given[entry["quantity"]], rel=1e-12)
    first = model.coordinates[0]
    assert {said[key][0] for key in ("rms", "mean", f"cycle_{first}", f"rest_{first}", first, f"{first}0")} == {said["rms"][0]}
    assert one_of("period") * one_of("rate") == pytest.approx(1.0)
    assert all(first in said[key][1] for key in ("rms", "largest", f"cycle_{first}"))


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
