"""Points on lines are joined to those of their own curve, however near another one is, and however
many there are.
"""

import itertools
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import bifurcation_sets
from tests.oracles.user_pages import model_of


@pytest.mark.thorough
def test_onsets_of_a_trolley_change_curves_at_crossings_only() -> None:
    """Where its spring is not strained, x = μ and y = −κ, x_a = 0: onsets there are one curve, and
    one are others with x_a = 0, across which three more go.
    """
    model = ss.load("trolley")
    found = ss.onset_curves(model.Parameters(theta0=0.7), ("theta0", "mu0"))
    unstrained, level = [], []
    for curve in found.curves:
        for some, off in ((unstrained, curve.x - curve.mu0), (level, curve.x_a)):
            known = np.abs(off) <= 1e-9
            assert known.all() or not known[1:-1].any()
            some.append(bool(known.all()))
        # Points next to each other are close, over what the curve covers.
        for name in ("x", "theta0"):
            assert np.abs(np.diff(curve[name])).max() <= 0.35 * np.ptp(curve[name])
    assert (len(unstrained), sum(unstrained), sum(level)) == (5, 1, 2)


@pytest.mark.thorough
def test_an_end_at_no_friction_is_one_of_two_curves() -> None:
    """Both end at μ₀ = 0 and θ₀ = 90°, where K is symmetric, each with a slope of its own."""
    found = ss.onset_curves(ss.load("cubic_contact").Parameters(theta0=0.7), ("theta0", "mu0"))
    ends = [
        (curve.theta0[way], curve.mu0[way])
        for curve, way in itertools.product(found.curves, (0, -1))
    ]
    near = [end for end in ends if np.hypot(end[0] - np.pi / 2, end[1]) < 1e-3]
    assert len(near) == 2


@pytest.mark.parametrize("number", [60, 2500])
def test_pairs_are_all_that_no_decided_line_separates(number: int) -> None:
    """Of many points, all in strips next to each other."""
    rng = np.random.default_rng(number)
    lines = [np.sort(rng.uniform(0, 1, 12)) for _ in range(2)]
    places = rng.uniform(0, 1, (2, number))
    for row, line in enumerate(lines):
        on_line = rng.choice(number, number // 3, replace=False)
        places[row, on_line] = rng.choice(line, on_line.size)
    decided = [rng.uniform(size=12) < 0.7 for _ in range(2)]
    found = bifurcation_sets._pairs(places, lines, decided, np.array([[0.0, 1.0]] * 2))
    expected = np.triu(np.ones((number, number), dtype=np.bool_), 1)
    for line, known, place in zip(lines, decided, places, strict=True):
        low, high = (np.ufunc.outer(of, place, place) for of in (np.minimum, np.maximum))
        for value in line[known]:
            expected &= ~((low < value) & (value < high))
        strip = (line[:, None] < place - 1e-9).sum(axis=0)
        expected &= (np.abs(np.subtract.outer(strip, strip)) <= 2) | (number <= 2000)
    got = np.zeros_like(expected)
    np.add.at(got, (found.min(axis=0), found.max(axis=0)), True)
    assert found.shape[1] == got.sum()
    np.testing.assert_array_equal(got, expected)


HOOK = '''r"""A snap-fit hook that a soft pusher moves over a bump."""
from spragsym.derive.model import Page, exp, tanh
page = Page("A snap-fit hook that is pushed over a bump by a soft pusher.")
m, k_b = page.unit("m", "kg", "mass"), page.unit("k_b", "N/m", "stiffness of the bump")
L = page.unit("L", "m", "width of the bump")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.2)
X = page.parameter("X", "m", "place of the pusher", "real", 0.0)
k_u = page.parameter("k_u", "N/m", "pusher", "> 0", 0.1)
k_w = page.parameter("k_w", "N/m", "hook", "> 0", 0.2)
H = page.parameter("H", "m", "height of the bump", ">= 0", 1.0)
e = page.parameter("e", "m", "clearance", "real", 0.1)
V = page.parameter("V", "m/s", "speed", "> 0", 0.5)
u = page.coordinate("u", "m", "insertion")
w = page.coordinate("w", "m", "lift of the hook")
page.kinetic(m * (page.rate(u)**2 + page.rate(w)**2) / 2)
page.potential(k_u * (u - X)**2 / 2)
page.spring(k_w, along=w)
page.contact(w + e - H * exp(-u**2 / L**2), lambda depth: k_b * depth)
page.friction(u, V, lambda v: mu * tanh(10 * v / V), at_rest=mu)
'''


@pytest.mark.thorough
def test_the_folds_of_a_snap_fit_are_complete() -> None:
    """With N = (H exp(−u²) − e)/(1 + 1/k_w), X = u − N (2 u H exp(−u²) + mu)/k_u has its extrema at
    the folds; over u in [−10, 10] exp(−u²) is at most 1.
    """
    p = model_of(HOOK, "hook").Parameters()
    found = ss.bifurcation_set(p, ("X", "H"), n=8, between={"X": (-3.0, 3.0), "H": (0.1, 1.5)})
    assert found.complete
    (curve,) = found.curves
    u, height = curve["u"], curve["H"]

    def pushed(at: Any) -> Any:
        bell = height * np.exp(-(at**2))
        return at - (bell - 0.1) / 6.0 * (2.0 * at * bell + 0.2) / 0.1

    np.testing.assert_allclose(curve["X"], pushed(u), atol=1e-11)
    step = 1e-5
    np.testing.assert_allclose((pushed(u + step) - pushed(u - step)) / (2 * step), 0.0, atol=1e-7)
