"""Cusps of a rod that leans on a belt with its end, in closed form, whichever coordinate stands
first.

f (μ sin a − cos a) − τ (a − t₀) vanishes with its first two derivatives by a: f √(1 + μ²) = τ,
tan a = 1/μ and t₀ = a. Neither x nor y acts in the balance of a, so that in w K = 0 at a fold the
part of w along x is 0 everywhere.
"""

import math

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.rod_on_its_end import ROD
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")
COORDINATES = [line for line in ROD.splitlines() if "page.coordinate(" in line]


def rod(order: str) -> ss.Model:
    """The model with its coordinates in an order."""
    lines = {line[0]: line for line in COORDINATES}
    text = ROD.replace("\n".join(COORDINATES), "\n".join(lines[name] for name in order))
    return model_of(text, f"rod_{order}")


@pytest.mark.thorough
@pytest.mark.parametrize("order", ["xya", "ayx", "yax"])
def test_the_cusp_is_found_and_is_the_only_one(order: str) -> None:
    mu = math.sqrt(2.5**2 - 1)
    angle = math.atan(1 / mu)
    found = ss.cusps(rod(order).Parameters(), ("t0", "mu"), between={"mu": (0.0, 10.0)})
    assert found.complete
    assert len(found) == 1
    state = [mu * 0.02 / 0.1, math.sin(angle) - 1.02, angle]
    assert np.allclose([*found["t0"], *found["mu"]], [angle, mu], rtol=1e-12)
    assert np.allclose([found[name][0] for name in "xya"], state, rtol=1e-11)


@pytest.mark.thorough
def test_the_set_and_the_critical_friction_begin_at_the_cusp() -> None:
    p = rod("xya").Parameters()
    between = {"t0": (0.2, 0.6), "mu": (1.0, 3.0)}
    drawn = ss.bifurcation_set(p, ("t0", "mu"), 8, between=between)
    assert drawn.complete
    critical = ss.critical_friction(p, between=between)
    assert critical.kind == "cusp"
    assert critical.complete
    assert float(critical) == pytest.approx(math.sqrt(2.5**2 - 1), rel=1e-12)
