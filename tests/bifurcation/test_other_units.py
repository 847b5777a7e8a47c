"""The same physics in units of length 10⁹ times as large or as small: the same answers."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

HEAD = '''"""A page of the tests."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin
page = Page("A page of the tests.")
m, k, a = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("a", "m", "size")
F = page.parameter("F", "N", "force", "> 0", 0.007)
x = page.coordinate("x", "m", "along")
'''
#: A mass on springs that soften and then harden: F = x − c x³ + e x⁵.
SNAP = (
    HEAD.replace('"> 0", 0.007', '"real", 0.1')
    + """
c = page.parameter("c", "N/m^3", "softening", "real", 1.2)
e = page.parameter("e", "N/m^5", "hardening", ">= 0", 0.3)
page.kinetic(m * page.rate(x)**2 / 2)
page.potential(k * x**2 / 2 - c * x**4 / 4 + e * x**6 / 6 - F * x)
"""
)
#: A mass on a belt, leaned on by an inclined spring of a length L.
LEANT = (
    HEAD
    + """
V = page.parameter("V", "m/s", "speed", ">= 0", 0.5)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.3)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
theta0 = page.parameter("theta0", "rad", "inclination", "(0, pi)", 0.8)
L = page.parameter("L", "m", "undeformed length", "> 0", 1.0)
k_x = page.parameter("k_x", "N/m", "along", "> 0", 0.007)
s = page.parameter("s", "N/m", "inclined spring", "> 0", 0.1)
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k_x, along=x)
page.spring(s, (x, y), (L * cos(theta0), L * sin(theta0)), length=L)
page.force(-F, along=y)
page.contact(y, lambda depth: k * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
"""
)
UNITS = [1.0, 1e-9, 1e-6, 1e6, 1e9]
#: Powers of a length in the parameters.
POWERS = {"V": 1, "F": 1, "L": 1, "c": -2, "e": -4, "d": -1}


def in_units(model: ss.Model, values: Mapping[str, float], unit: float) -> Any:
    return model.Parameters(
        **{name: value * unit ** POWERS.get(name, 0) for name, value in values.items()}
    )


@pytest.mark.thorough
@pytest.mark.parametrize("unit", UNITS)
def test_every_fold_of_a_snapping_mass_is_found(unit: float) -> None:
    """1 − 3 c x² + 5 e x⁴ = 0."""
    c, e = 1.2, 0.3
    p = in_units(model_of(SNAP, "snap_in_units"), {"F": 0.1, "c": c, "e": e}, unit)
    found = ss.folds(p, "F", between={"F": (-0.6 * unit, 0.6 * unit)})
    squares = (3 * c + np.array([-1, 1]) * np.sqrt(9 * c**2 - 20 * e)) / (10 * e)
    x = np.sqrt(squares)
    at = x - c * x**3 + e * x**5
    assert found.complete
    np.testing.assert_allclose(found.F / unit, np.sort([*at, *-at]), rtol=1e-9)
    eq = ss.equilibria(p)
    assert eq.complete
    assert int(eq.count) == 5
    # Of a range without an end, beyond the value at hand: pulled harder, it snaps off the inner well.
    assert ss.folds(p, "F").F.max() == pytest.approx(unit * at[0], rel=1e-9)
    assert ss.jump_value(p, "F") == pytest.approx(unit * at[0], rel=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize("unit", UNITS[1:])
def test_folds_and_jumps_of_a_leant_mass_are_those_of_its_own_unit(unit: float) -> None:
    values = {"V": 0.5, "mu0": 0.5, "theta0": 0.6, "F": 0.007, "L": 1.0, "k_x": 0.007, "s": 0.1}
    model = model_of(LEANT, "leant_in_units")
    own, other = (in_units(model, values | {"d": 10.0}, one) for one in (1.0, unit))
    for vary, count in (("theta0", 2), ("mu0", 1)):
        folds = [ss.folds(p, vary) for p in (own, other)]
        assert [(one.decided, len(one)) for one in folds] == [(True, count)] * 2
        np.testing.assert_allclose(folds[1][vary], folds[0][vary], rtol=1e-9)
        np.testing.assert_allclose(folds[1].x / unit, folds[0].x, rtol=1e-7)
        jumps = [float(ss.jump_value(p, vary)) for p in (own, other)]
        assert jumps[1] == pytest.approx(jumps[0], rel=1e-9)
