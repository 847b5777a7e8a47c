"""A force that turns over within a hundredth of the motion: energy is kept, and a step does not pass it unseen."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of, shipped_page


@pytest.mark.thorough
@pytest.mark.parametrize("d", [30.0, 300.0, 5000.0])
def test_a_steep_force_of_the_place_is_not_passed_unseen(d: float) -> None:
    page = shipped_page(
        "stick_slip", ("import Page", "import Page, tanh"), ("page.damper(c, along=x)", "page.force(-F * tanh(x / L), along=x)"),
        ('c = page.parameter("c", "N s/m", "damper beside the spring", ">= 0", 0.05, becomes="zeta")',
         'F = page.parameter("F", "N", "force", "> 0", 0.3)\nL = page.parameter("L", "m", "width", "> 0", 0.01)'),
    )  # fmt: skip
    p = model_of(page, "steep_force").Parameters(mu_s=0.0, F=0.3, L=1 / d)
    motion = ss.simulate(p, start=(1.0, 0.0), t_end=20.0)
    energy = motion.vx**2 / 2 + motion.x**2 / 2 + 0.3 / d * (np.logaddexp(d * motion.x, -d * motion.x) - np.log(2))
    assert energy == pytest.approx(energy[0], abs=1e-8)
