"""Branches of a diagram: of equilibria each is there once and whole, and a cycle that is not followed costs that one only."""

from __future__ import annotations

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

#: Leine's law of friction, smoothed by tanh(100 v): a layer that motions leave out where it is below rounding.
STEEP = '''"""A mass on a belt.

::

    no drawing
"""
from spragsym.derive.model import Abs, Page, tanh

page = Page("A mass on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
N = page.unit("N_0", "N", "normal force")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.1)
V = page.parameter("V", "m/s", "speed", ">= 0", 1.4)
d = page.parameter("d", "s/m", "steepness", "> 0", 100)
v_0 = page.parameter("v_0", "m/s", "speed at which friction has fallen by half", "> 0", 0.5)
x = page.coordinate("x", "m", "way")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.normal_force(N)
page.friction(x, V, lambda v: tanh(d * v) / (1 + Abs(v) / v_0))
'''


@pytest.mark.thorough
def test_a_branch_goes_on_where_a_layer_of_the_friction_law_ends() -> None:
    found = ss.diagram(model_of(STEEP, "steep").Parameters(), "V", (0.05, 1.0), points=2)
    (branch,) = found.equilibria
    assert (branch.values.min(), branch.values.max()) == pytest.approx((0.05, 1.0))
    np.testing.assert_allclose(branch.states[:, 0], np.tanh(100 * branch.values) / (1 + 2 * branch.values), atol=1e-12)


@pytest.mark.thorough
def test_a_cycle_that_is_not_followed_is_told_and_costs_no_other() -> None:
    model = ss.load("stick_slip")
    start = ss.cycle(model.Parameters(V=0.2), near=(0.6, 0.0))
    found = ss.diagram(model.Parameters(V=0.2), "V", (0.05, 0.12), points=5, starts=[start])
    assert len(found.cycles) == 1
    assert any("at V = 0.2 was not followed: to = (0.05, 0.12)" in remark for remark in found.remarks)
