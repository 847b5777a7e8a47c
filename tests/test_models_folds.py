"""Folds and onsets of models that are degenerate by symmetry, or whose forces have no potential."""

from __future__ import annotations

import numpy as np
import pytest

import spragsym as ss
from spragsym.derive import folder, pages


@pytest.mark.parametrize("vary", ["sigma", "alpha_a"])
@pytest.mark.parametrize("theta0", [0.7, 1.0, np.pi / 2])
def test_a_trolley_that_nothing_pulls_along_the_belt_has_no_folds_along_its_stiffnesses(vary, theta0):
    # Without friction and α the forces along the belt add up to α_a x_a = 0, and σ (L − 1) cos θ = 0 is left: an unstressed
    # spring, whatever its stiffness, or an upright one with L − 1 = (sin θ₀ − 1 + κ)/(1 + σ): κ alone changes its sign.
    model = ss.load("trolley")
    p = model.Parameters(mu0=0.0, alpha=0.0, theta0=theta0)
    for found in (model.folds(p, vary), model.flutter_onsets(p, vary)):
        assert found.complete
        assert len(found) == 0
        assert found.remarks == ()


def test_the_pitchfork_of_a_trolley_that_nothing_pulls_along_the_belt():
    model = ss.load("trolley")
    found = model.folds(model.Parameters(mu0=0.0, alpha=0.0, theta0=1.0, sigma=0.3), "kappa")
    assert found.complete
    assert found.kind.tolist() == ["pitchfork"]
    assert abs(found.kappa[0] - (1 - np.sin(1.0))) < 1e-12


def test_a_force_without_a_potential_can_bring_flutter_without_friction(tmp_path):
    # At V = 0 there is no friction, but its slope damps x. A pair crosses where y moves alone: K₁₂ K₂₁ = (P − σ/2)(−P − σ/2) = 0.
    text = (pages.SHIPPED / "mode_coupling.py").read_text(encoding="utf-8")
    for before, after in (
        ("from ..model import", "from spragsym.derive.model import"),
        ("V = page", 'P = page.parameter("P", "N/m", "stiffness of a force that turns with the place", ">= 0", 0.0)\nV = page'),
        ("page.force(0, -F_L, at=(x, y))", "page.force(0, -F_L, at=(x, y))\npage.force(-P * y, P * x, at=(x, y))"),
        (", at_rest=mu0)", ")"),
    ):
        assert text.count(before) == 1
        text = text.replace(before, after)
    (tmp_path / "follower.py").write_text(text, encoding="utf-8")
    folder.write_page(tmp_path / "follower.py", tmp_path / "follower")
    model = ss.load(tmp_path / "follower")
    assert not model.about["symmetric"]
    found = model.flutter_onsets(model.Parameters(V=0.0, sigma=0.5), "P")
    assert found.complete
    assert found.kind.tolist() == ["hopf"]
    assert abs(found.P[0] - 0.25) < 1e-12
    assert abs(found.omega[0] - np.sqrt(1.25)) < 1e-12
