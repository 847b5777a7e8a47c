"""Points on lines are joined to those of their own curve, however near another one is, and however
many there are.
"""

import itertools
import tracemalloc

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import bifurcation_sets


@pytest.mark.thorough
def test_onsets_of_a_trolley_change_curves_at_crossings_only() -> None:
    """Where its spring is not strained, x = μ and y = −κ, w = 0: onsets there are on curves of their
    own, and so are others with w = 0.
    """
    model = ss.load("trolley")
    p = model.Parameters(theta0=0.7)
    found = ss.onset_curves(p, ("theta0", "mu0"))
    kinds = []
    for curve in found.curves:
        unstrained = np.abs(curve.x - curve.mu0) <= 1e-9
        assert unstrained.all() or not unstrained[1:-1].any()
        kinds.append(bool(unstrained.all()))
        # Points next to each other are close in each coordinate, over what it covers.
        for name in (*model.coordinates, "theta0", "mu0"):
            steps = np.abs(np.diff(curve[name]))
            assert steps.max(initial=0.0) <= 0.35 * max(np.ptp(curve[name]), 1e-12)
    assert any(kinds)
    assert not all(kinds)


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


@pytest.mark.parametrize("seed", range(3))
def test_pairs_are_all_that_no_decided_line_separates(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lines = [np.sort(rng.uniform(0, 1, 12)) for _ in range(2)]
    places = rng.uniform(0, 1, (2, 60))
    places[0, :20] = rng.choice(lines[0], 20)
    places[1, 20:40] = rng.choice(lines[1], 20)
    decided = [rng.uniform(size=12) < 0.7 for _ in range(2)]
    spans = np.array([[0.0, 1.0]] * 2)
    found = [
        frozenset(pair)
        for pairs in bifurcation_sets._pairs(places, lines, decided, spans)
        for pair in pairs.T.tolist()
    ]
    expected = set()
    for one, other in itertools.combinations(range(60), 2):
        between = [
            (low < line) & (line < high)
            for line, low, high in zip(
                lines,
                places[:, [one, other]].min(axis=1),
                places[:, [one, other]].max(axis=1),
                strict=True,
            )
        ]
        if all(
            part.sum() <= 1 and not (part & known).any()
            for part, known in zip(between, decided, strict=True)
        ):
            expected.add(frozenset((one, other)))
    assert len(found) == len(set(found))
    assert set(found) == expected


def test_pairs_of_many_points_fit_into_memory() -> None:
    """30,000 points on 300 lines: all pairs are 900 million."""
    rng = np.random.default_rng(5)
    lines = [np.linspace(0, 1, 300)] * 2
    places = np.array([rng.choice(lines[0], 30_000), rng.uniform(0, 1, 30_000)])
    tracemalloc.start()
    known = [np.ones(300, dtype=np.bool_)] * 2
    number = sum(
        pairs.shape[1]
        for pairs in bifurcation_sets._pairs(places, lines, known, np.array([[0.0, 1.0]] * 2))
    )
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert 0 < number < 3_000_000
    assert peak < 100e6
