"""The model's names, meanings, units and ranges: written once, true, and read by everything that
says them.
"""

import math

import pytest

from spragsym.generated.quantities import QUANTITIES


def test_units_are_the_scales_of_the_model() -> None:
    """What a unit says, computed, is the product of the scales of length and time, L_0 and
    sqrt(m/k_c).
    """
    m, k_c, L_0 = 0.3, 7.0e5, 0.05
    length, time = L_0, math.sqrt(m / k_c)
    derived = {
        "x": length,
        "y": length,
        "L": length,
        "vx": length / time,
        "vy": length / time,
        "V": length / time,
        "d": time / length,
        "tau": time,
    }
    for name, expected in derived.items():
        said = QUANTITIES[name].unit.replace("L_0 sqrt", "L_0 * sqrt")
        # our own table
        value = eval(said, {"L_0": L_0, "m": m, "k_c": k_c, "sqrt": math.sqrt})  # noqa: S307
        assert value == pytest.approx(expected, rel=1e-15), name
