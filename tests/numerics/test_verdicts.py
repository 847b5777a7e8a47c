"""Compiled contractors against those of NumPy, bit by bit; and searches by both, which look at the
same boxes.
"""

from __future__ import annotations

import numpy as np
import pytest

from spragsym.numerics import boxes, contractors
from spragsym.numerics.interval_arrays import FloatArray, Intervals, quiet
from tests.conformance.models import RESTING
from tests.numerics.test_tape import systems

pytestmark = pytest.mark.skipif(not contractors.available(), reason="no C compiler on installation")

#: What boxes are made of beside random numbers.
ODD = np.array([0.0, -0.0, 1e-320, 1e-160, 1e160, 1e300, np.inf, -np.inf, np.nan])


def intervals(rng: np.random.Generator, *shape: int, odd: float) -> FloatArray:
    """Ends of intervals of any size, narrow and wide, some of numbers that are odd."""
    middle = rng.normal(size=shape) * 10.0 ** rng.integers(-3, 3, shape)
    width = np.abs(middle) * 10.0 ** rng.integers(-17, 2, shape)
    ends = np.stack([width - middle, width + middle])
    return np.where(rng.random(ends.shape) < odd, rng.choice(ODD, ends.shape), ends)


Step = tuple[Intervals, Intervals, FloatArray, FloatArray]


def steps(rng: np.random.Generator, n: int, count: int, odd: float) -> Step:
    """Values, slopes, middles and distances of boxes, some of which hold a root."""
    given, slopes = (intervals(rng, *size, count, odd=odd) for size in ((n,), (n, n)))
    # Most equations tell one unknown from the others, so that some boxes are proved.
    slopes[:, range(n), range(n)] += np.array([[[-9.0]], [[9.0]]]) * (rng.random(count) < 0.7)
    middle = Intervals(given).middle
    size = rng.choice([0.0, 1e-3, 1.0, 10.0], (n, count)) * np.abs(middle)
    near = rng.uniform(-1, 1, (n, count)) * size
    reach = contractors.distance(given + 0.05 * np.abs(given), middle)
    values = np.stack([1e-9 - near, 1e-9 + near])
    return Intervals(values), Intervals(slopes), middle, reach


@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_steps_are_those_of_numpy(n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(90 + n)
    with quiet():
        every = steps(rng, n, 2000, 0.05)
        found, rows = contractors.newton(*every), contractors.by_rows(*every)
        monkeypatch.setattr(contractors, "compiled", None)
        expected = contractors.newton(*every)
        np.testing.assert_array_equal(rows, contractors.by_rows(*every))
    for name in ("ends", "noise", "none"):
        np.testing.assert_array_equal(getattr(found, name), getattr(expected, name), err_msg=name)


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_inverses_are_those_of_numpy(n: int, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(n)
    matrices = rng.normal(size=(n, n, 2000)) * rng.choice([1.0, 1.0, 0.0, 1e150, np.nan], 2000)
    found = contractors.inverse(matrices)
    monkeypatch.setattr(contractors, "compiled", None)
    np.testing.assert_array_equal(found, contractors.inverse(matrices))


@pytest.mark.parametrize("n", [3, 4, 7])
def test_inverses_are_those_of_elimination_by_lapack(n: int) -> None:
    rng = np.random.default_rng(n)
    matrices = rng.normal(size=(n, n, 500)) * 10.0 ** rng.integers(-200, 200, 500)
    found = contractors.inverse(matrices)
    expected = np.moveaxis(np.linalg.inv(np.moveaxis(matrices, -1, 0)), 0, -1)
    off = np.abs(found - expected).max(axis=(0, 1)) / np.abs(expected).max(axis=(0, 1))
    size = np.linalg.cond(np.moveaxis(matrices, -1, 0))
    assert (off <= 1e-15 * n * size).all()
    for nothing in (0.0, np.inf, np.nan):
        matrices[0] = nothing
        with quiet():
            np.testing.assert_array_equal(contractors.inverse(matrices)[:, :, 3], np.eye(n))


def test_arrays_that_do_not_fit_are_refused() -> None:
    compiled, numbers = contractors.compiled, np.zeros(8)
    for n in (0, 1, 9):
        with pytest.raises(ValueError, match=r"shapes of one another|allowed are 1 to 8"):
            compiled.newton(*[numbers] * 4, n, False, np.zeros(4), np.zeros(2), np.zeros(2, bool))
        with pytest.raises(ValueError, match=r"shapes of one another|allowed are 1 to 8"):
            compiled.inverse(numbers, n, np.zeros(7))


@pytest.mark.thorough
@pytest.mark.parametrize("name", RESTING)
def test_searches_look_at_the_same_boxes(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for key, (system, column) in systems(name).items():
        region = np.full((2, system.n, 1), 1.25)
        found = boxes.search(system, region, column, column, budget=100)
        with monkeypatch.context() as without:
            without.setattr(contractors, "compiled", None)
            expected = boxes.search(system, region, column, column, budget=100)
        assert found.looks == expected.looks, key
        for part in ("unique", "where", "undecided"):
            one, other = getattr(found, part), getattr(expected, part)
            np.testing.assert_array_equal(one.ends, other.ends, err_msg=f"{key}, {part}")
            np.testing.assert_array_equal(one.nodes, other.nodes)
