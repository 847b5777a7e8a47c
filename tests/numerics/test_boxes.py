"""The search over boxes: others' problems with known roots, and what is not decidable or lies on
borders.
"""

import time
from fractions import Fraction
from math import isqrt

import numpy as np
import pytest

from spragsym.numerics import boxes, certified_roots
from spragsym.numerics.interval_arrays import Intervals, stacked
from tests.oracles.box_problems import PROBLEMS, Problem

NONE = np.zeros((0, 1))


def solved(problem, region=None, low=NONE, high=None, budget=20_000):
    region = problem.ends if region is None else region
    return certified_roots.search(
        problem, region, low, low if high is None else high, budget=budget
    )


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda one: one.title)
def test_all_roots_of_known_problems(problem):
    found = solved(problem)
    assert found.point.size == problem.roots
    assert found.undecided_point.size == 0
    assert found.error.max() < 1e-13
    values = problem.residuals(Intervals(found.ends), Intervals(np.zeros((2, 0, 1))))
    assert values.holds_zero().all()


class Quadratic(boxes.EquationSystem):
    """x² + p x + q = 0 and y = x³: one or two parameters for each point, roots known in closed
    form.
    """

    def residuals(self, unknowns, parameters):
        x, y = unknowns[0], unknowns[1]
        return stacked([x**2 + parameters[0] * x + parameters[1], y - x**3], x.shape)

    def jacobian(self, unknowns, parameters):
        x = unknowns[0]
        entries = stacked([2 * x + parameters[0], 0, -3 * x**2, 1], x.shape)
        return Intervals(entries.ends.reshape(2, 2, 2, *x.shape))


WIDE = np.full((2, 2, 1), 30.0)
ROOT_ERROR = Fraction(1, 2**160)


def root_of(square):
    """The square root, to some 170 bits."""
    return Fraction(isqrt(int(square * 2**360)), 2**180)


@pytest.mark.thorough
def test_many_points_at_once():
    rng = np.random.default_rng(1)
    p, q = rng.uniform(-2, 2, (2, 3000))
    q[:1000] = (
        0.25 * p[:1000] ** 2 * (1 + rng.choice([1, -1], 1000) * 10.0 ** rng.uniform(-9, -2, 1000))
    )
    found = solved(Quadratic(), WIDE, np.stack([p, q]))
    square = p**2 - 4 * q
    counts = np.bincount(found.point, minlength=3000)
    left = np.unique(found.undecided_point)
    decided = np.ones(3000, dtype=bool)
    decided[left] = False
    assert (counts == np.where(square > 0, 2, 0))[decided].all()
    # Only at points whose two roots are closer than float64 can tell is anything left.
    assert (np.abs(square[left]) < 1e-10).all()
    assert left.size < 200
    x = found.middle[0]
    assert (np.abs(x**2 + p[found.point] * x + q[found.point]) < 1e-14).all()


def test_each_point_is_searched_in_its_own_region():
    """x² + p x = 0 for p = −1 up to |x| = 30, and for p = 1 up to 2: no box of the second lies
    farther out.
    """
    seen = []

    class Watched(Quadratic):
        def residuals(self, unknowns, parameters):
            second = (parameters.low[0] == 1) & (parameters.high[0] == 1)
            seen.append(unknowns.magnitude[0, second].max(initial=0.0))
            return super().residuals(unknowns, parameters)

    region = np.array([[30.0, 2.0], [30.0, 30.0]])
    found = solved(Watched(), np.stack([region, region]), np.array([[-1.0, 1.0], [0.0, 0.0]]))
    assert sorted(zip(found.point.tolist(), found.middle[0].round(9).tolist(), strict=True)) == [
        (0, 0),
        (0, 1),
        (1, -1),
        (1, 0),
    ]
    assert max(seen) <= 2


def test_exact_double_root_stays_undecided_with_a_small_box():
    found = solved(Quadratic(), WIDE, np.array([[-2.0], [1.0]]))
    assert found.point.size == 0
    assert found.undecided_point.size
    assert (np.abs(Intervals(found.undecided).middle[0] - 1) < 1e-5).all()


def test_a_line_of_roots_costs_no_more_than_the_budget():
    line = Problem("line", lambda x: (x[0] + x[1], (x[0] + x[1]) * x[0]), ((-1, 1), (-1, 1)), 0)
    begin = time.perf_counter()
    outcome = boxes.search(line, line.ends, NONE, NONE, budget=3000)
    assert time.perf_counter() - begin < 10
    assert len(outcome.undecided)
    assert outcome.looks < 20000
    for x in np.linspace(-0.99, 0.99, 41):
        both = [outcome.undecided.ends, outcome.unique.ends]
        assert any(
            ((-ends[0].T <= [x, -x]) & (ends[1].T >= [x, -x])).all(axis=1).any() for ends in both
        )


@pytest.mark.parametrize("corner", [(0.0, 0.0), (0.0, 1.0), (-0.15625, 0.4)])
def test_roots_on_borders_are_found_once(corner):
    a, b = corner
    # Four roots, in the middle of the region, where it is cut, or on a cut of its halves.
    product = Problem(
        "grid",
        lambda x: ((x[0] - a) * (x[0] - 5), (x[1] - b) * (x[1] + 5)),
        ((-10, 10), (-10, 10)),
        4,
    )
    found = solved(product)
    assert found.point.size == 4
    assert found.undecided_point.size == 0


def test_roots_outside_of_the_region_are_none_of_its_roots():
    product = Problem("grid", lambda x: ((x[0] - 1.001) * x[0], x[1]), ((-1, 1), (-1, 1)), 1)
    assert solved(product).point.size == 1
    on_border = Problem("grid", lambda x: ((x[0] - 1) * x[0], x[1]), ((-1, 1), (-1, 1)), 1)
    found = solved(on_border)
    assert found.point.size == 1
    assert found.undecided_point.size == 1


def test_boxes_of_parameters_are_proved_for_all_of_their_points():
    low = np.array([[0.9], [-2.1]])
    high = np.array([[1.1], [-1.9]])
    found = solved(Quadratic(), WIDE, low, high)
    assert found.point.size == 2
    rng = np.random.default_rng(2)
    for p, q in rng.uniform(low.T, high.T, (200, 2)):
        roots = np.sort(np.roots([1, p, q]).real)
        order = np.argsort(found.middle[0])
        inside = (-found.ends[0, 0, order] <= roots) & (roots <= found.ends[1, 0, order])
        assert inside.all()


def test_a_root_that_rounding_does_not_tell_from_0_is_0_with_an_error_that_covers_its_box() -> None:
    spans = np.array([[-3e-17, 5e-17], [-1e-17, 5e-17], [2e-17, 3e-17], [-1.0, 1.5]])
    roots = certified_roots.Roots.at(np.stack([-spans[:, 0], spans[:, 1]])[:, None])
    assert roots.middle[0] == pytest.approx([0.0, 2e-17, 2.5e-17, 0.0], rel=1e-15, abs=0)
    assert (roots.error >= np.abs(spans - roots.middle.T).max(axis=1)).all()
    assert roots.error == pytest.approx([5e-17, 3e-17, 5e-18, 1.5], rel=1e-12)
