"""Slots of equilibria that share their first coordinate, as under a mirror: not decided by rounding."""

from __future__ import annotations

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of

#: A truss of two springs, symmetric about x = 0: three states on that line, and two beside it that are images of each other.
TRUSS = '''"""A symmetric truss.

::

    no drawing
"""
from spragsym.derive.model import Page

page = Page("A symmetric truss.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of a bar")
l = page.unit("l", "m", "half span")
h = page.parameter("h", "m", "height", "> 0", 2.0)
F = page.parameter("F", "N", "load", "real", 0.1)
k_x = page.parameter("k_x", "N/m", "spring across", ">= 0", 0.5, becomes="chi")
x = page.coordinate("x", "m", "way across")
y = page.coordinate("y", "m", "way up")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
for side in (-l, l):
    page.spring(k, (side, h), (x, y), length=2 * l)
page.spring(k_x, along=x)
page.force(F, along=y)
'''


@pytest.mark.thorough
def test_a_slot_is_the_same_alone_and_among_others() -> None:
    model, rng = model_of(TRUSS, "mirrored_truss"), np.random.default_rng(1)
    drawn = {"h": rng.uniform(1.5, 3.0, 8), "F": rng.uniform(-0.3, 0.3, 8), "chi": rng.uniform(0.0, 2.0, 8)}
    together = ss.equilibria(model.Parameters(**drawn))
    assert (together.count >= 3).all()
    for i, count in enumerate(together.count.tolist()):
        alone = ss.equilibria(model.Parameters(**{name: values[i] for name, values in drawn.items()}))
        for name in model.coordinates:
            np.testing.assert_allclose(getattr(alone, name)[:count], getattr(together, name)[i, :count], atol=1e-9)
