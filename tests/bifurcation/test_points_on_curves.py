"""Points on lines are joined to those of their own curve, however near another one is, and however
many there are.
"""

import itertools

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import bifurcation_sets


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
