"""What the search over boxes proves, each step by itself against fractions: where roots are, and
that there is one or none.
"""

import itertools
from fractions import Fraction

import numpy as np
import pytest

from spragsym.numerics import boxes, certified_roots, contractors, verdicts
from spragsym.numerics.boxes import tree
from spragsym.numerics.interval_arrays import Intervals, stacked

pytestmark = pytest.mark.usefixtures("silent")


def fractions(values):
    """The same numbers, exactly."""
    return np.vectorize(lambda value: Fraction(float(value)), otypes=[object])(values)


def solution(matrix, right):
    """The exact solution of a linear system, by elimination."""
    n = len(right)
    rows = [[*matrix[i], right[i]] for i in range(n)]
    for i in range(n):
        pivot = next(k for k in range(i, n) if rows[k][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for k in range(n):
            if k != i:
                rows[k] = [a - rows[k][i] * b for a, b in zip(rows[k], rows[i], strict=True)]
    return [row[n] for row in rows]


def around(values, spread, rng):
    """Intervals about values, that wide."""
    return Intervals.between(
        values - spread * rng.uniform(0, 1, values.shape),
        values + spread * rng.uniform(0, 1, values.shape),
    )


# ------------------------------------------------------------------------------------------------
# interval Newton


@pytest.mark.parametrize("n", [1, 2, 3, 4])
@pytest.mark.parametrize("spread", [0.0, 1e-14, 0.02])
def test_every_root_lies_in_the_result(n, spread):
    """Of systems whose slopes and values are corners of the given intervals; with no spread,
    rounding is all there is.
    """
    rng = np.random.default_rng([n, int(spread * 100)])
    N = 60
    slopes = around(rng.normal(size=(n, n, N)) + 2 * np.eye(n)[:, :, None], spread, rng)
    middle = rng.normal(size=(n, N)) * 10.0 ** rng.integers(-3, 3, (1, N))
    values = around(rng.normal(size=(n, N)) * 0.1, spread, rng)
    step = contractors.newton(values, slopes, middle, np.full((n, N), 1e3))
    rows = contractors.by_rows(values, slopes, middle, np.full((n, N), 1e3))
    each, none = contractors.by_each_row(values, slopes, middle, np.full((n, N), 1e3))
    seen = 0
    for k, _ in itertools.product(range(N), range(3 if spread else 1)):
        pick = rng.integers(0, 2, (n, n)), rng.integers(0, 2, n)
        matrix = fractions(np.where(pick[0], slopes.high[:, :, k], slopes.low[:, :, k]))
        right = fractions(np.where(pick[1], values.high[:, k], values.low[:, k]))
        root = [
            m - x for m, x in zip(fractions(middle[:, k]), solution(matrix, right), strict=True)
        ]
        if any(abs(x - m) > 1000 for x, m in zip(root, fractions(middle[:, k]), strict=True)):
            continue
        assert not none[k]
        assert not step.none[k]
        for ends in (step.ends, rows, each):
            for i in range(n):
                assert not np.isfinite(ends[0, i, k]) or -Fraction(float(ends[0, i, k])) <= root[i]
                assert not np.isfinite(ends[1, i, k]) or root[i] <= Fraction(float(ends[1, i, k]))
        seen += bool(np.isfinite(step.ends[:, :, k]).all())
    assert seen > N / 2


# ------------------------------------------------------------------------------------------------
# exclusion


def excluded(values, slopes, reach):
    """Boxes about 0 of which a row tells that they hold no root."""
    return contractors.by_each_row(values, slopes, np.zeros_like(reach), reach)[1]


def test_rounding_excludes_no_root():
    """1 + 2⁻⁵³ + 2⁻⁵³, which is 1 in floats, and three products of 0.4 of the smallest float, which
    are 0.
    """
    slopes = Intervals.point(np.array([[[1.0], [2.0**-53], [2.0**-53]]] * 3))
    assert not excluded(Intervals.point([[1 + 2.0**-52]] * 3), slopes, np.ones((3, 1))).any()
    small = Intervals.point(np.full((3, 3, 1), 0.4))
    assert not excluded(Intervals.point([[5e-324]] * 3), small, np.full((3, 1), 5e-324)).any()


# ----------------------------------------------------------------------------------------------
# directions, borders


def test_a_direction_that_there_is_is_not_denied():
    """G = −M u for random directions and matrices in the intervals; shifted so far that there is
    none, it is denied.
    """
    rng = np.random.default_rng(6)
    for n, spread in itertools.product((2, 3), (0.0, 1e-15, 0.05)):
        factors = around(rng.normal(size=(n, 2, 300)) + 2 * np.eye(n, 2)[:, :, None], spread, rng)
        angle = rng.uniform(-np.pi, np.pi, 300)
        u = np.stack([np.cos(angle), np.sin(angle)])
        held = np.where(rng.integers(0, 2, factors.shape), factors.high, factors.low)
        right = -np.einsum("kiN,iN->kN", held, u)
        rest = Intervals.between(
            right - 1e-14, right + 1e-14
        )  # which the rounding of right and u is less than
        assert not contractors.no_unit_vector(rest, factors).any()
        for factor in (0.5, 1.5):
            denied = contractors.no_unit_vector(rest * factor, factors)
            assert denied.all() if spread < 0.01 else denied.any()


def test_exact_directions_are_not_denied():
    """u = (3/5, 4/5) with integers, where no rounding helps: 5 u + G = 0, and with a matrix that is
    not square.
    """
    for factors in (
        [[5.0, 0.0], [0.0, 5.0]],
        [[5.0, 0.0], [0.0, 5.0], [5.0, 5.0]],
        [[5.0, 5.0], [0.0, 5.0]],
    ):
        matrix = np.array(factors)
        rest = -(matrix @ [3.0, 4.0]) / 5
        assert not contractors.no_unit_vector(
            Intervals.point(rest[:, None]), Intervals.point(matrix[:, :, None])
        )[0]
        for part in (0.999, 1.001):
            assert contractors.no_unit_vector(
                Intervals.point(part * rest[:, None]), Intervals.point(matrix[:, :, None])
            )[0]


# ------------------------------------------------------------------------------------------------
# matrices


@pytest.mark.thorough
@pytest.mark.parametrize("spread", [0.0, 0.1])
def test_products_hold_the_exact_ones(spread):
    rng = np.random.default_rng(7)
    for n, columns, powers in itertools.product((1, 2, 4), (1, 3), ((0,), (-540, -530), (-30, 30))):
        Y = rng.normal(size=(n, n, 20)) * 2.0 ** rng.choice(powers, (n, n, 20))
        X = around(
            rng.normal(size=(n, columns, 20)) * 2.0 ** rng.choice(powers, (n, columns, 20)),
            spread,
            rng,
        )
        ends = contractors.product(Y, X.ends)
        for k in range(20):
            left, low, high = (
                fractions(Y[:, :, k]),
                fractions(X.low[:, :, k]),
                fractions(X.high[:, :, k]),
            )
            for i, j in itertools.product(range(n), range(columns)):
                parts = [
                    sorted((left[i, m] * low[m, j], left[i, m] * high[m, j])) for m in range(n)
                ]
                least, most = sum(part[0] for part in parts), sum(part[1] for part in parts)
                size = sum(max(map(abs, part)) for part in parts)
                assert (
                    least - size / 2**48 - Fraction(1, 2**990)
                    <= -Fraction(float(ends[0, i, j, k]))
                    <= least
                )
                assert (
                    most
                    <= Fraction(float(ends[1, i, j, k]))
                    <= most + size / 2**48 + Fraction(1, 2**990)
                )


# ------------------------------------------------------------------------------------------------
# one look at boxes


class Lines(boxes.EquationSystem):
    """(x − a)(x − b) = 0 and y = c x: the roots (a, c a) and (b, c b), for parameters a, b, c."""

    def residuals(self, unknowns, parameters):
        x, y = unknowns
        a, b, c = parameters
        return stacked([(x - a) * (x - b), y - c * x], x.shape)

    def jacobian(self, unknowns, parameters):
        x = unknowns[0]
        a, b, c = parameters
        return Intervals(
            stacked([x - a + (x - b), 0, -c, 1], x.shape).ends.reshape(2, 2, 2, *x.shape)
        )


def ends_of(low, high):
    """−low and high of boxes, shape (2, n, N)."""
    return np.stack([-np.asarray(low, dtype=float), np.asarray(high, dtype=float)])


def holds(ends, root):
    """Which boxes hold a point."""
    return ((-ends[0] <= root[:, None]) & (root[:, None] <= ends[1])).all(axis=0)


def random_pairs(rng, count, points):
    """Boxes of all sizes about one of the roots of their point, which may lie on their border or in
    a corner.
    """
    leaves = np.flatnonzero(points.size == 1)[-(points.order >= 0).sum() :]
    nodes = rng.choice(leaves, count)
    values = points.bounds.low[:, nodes]
    x = np.where(rng.integers(0, 2, count), values[0], values[1])
    root = np.stack([x, values[2] * x])
    width = 10.0 ** rng.uniform(-9, 1, (2, count))
    share = rng.choice([0.0, 0.3, 0.5, 1.0], (2, count))
    return boxes.Pairs(ends_of(root - share * width, root + (1 - share) * width), nodes), root


@pytest.mark.parametrize("steps", [1, 3])
def test_no_look_loses_a_root(steps):
    """Whatever a look makes of a box, its root is in what is left, or in a box with one root, or
    among what is undecided.
    """
    rng = np.random.default_rng(20 + steps)
    a, c = rng.uniform(-3, 3, 64), rng.uniform(-2, 2, 64)
    b = a + rng.choice([1e-6, 1e-3, 0.1, 2.0], 64)
    values = np.stack([a, b, c])
    points = tree(values, values)
    search = boxes._Search(
        Lines(),
        points,
        np.full((2, 2, 1), np.inf),
        5,
        verdicts.Rules(0.05, 0.35, 2.0**-12, boxes.NARROW, 0.6, True, np.ones(2)),
        None,
        points.bounds,
    )
    pairs, roots = random_pairs(rng, 600, points)
    left = pairs
    for _ in range(steps):
        left = search.look(left)
    unique, where, undecided = (
        first.concatenated(*more)
        for first, *more in (search.unique, search.where, search.undecided)
    )
    for k in range(len(pairs)):
        node, (x, y) = pairs.nodes[k], roots[:, k]
        kept = np.concatenate(
            [part.ends[:, :, part.nodes == node] for part in (left, unique, undecided)], axis=2
        )
        # y is off by a rounding of c x.
        assert any(
            holds(kept, np.array([x, near])).any()
            for near in (y, np.nextafter(y, -np.inf), np.nextafter(y, np.inf))
        )
    assert len(unique)
    # One root in each of those: of the two only one lies in it, with room for rounding, and in the
    # box that tells where.
    for k in range(len(unique)):
        a, b, c = points.bounds.low[:, unique.nodes[k]]
        there = [holds(unique.ends[:, :, k : k + 1], np.array([x, c * x]))[0] for x in (a, b)]
        assert sum(there) == 1
        x = (a, b)[int(there[1])]
        off = np.abs(np.array([x, c * x]) - Intervals(where.ends).middle[:, k])
        assert (off <= where.ends[:, :, k].sum(axis=0) + 1e-15).all()


def test_halves_make_up_the_box():
    rng = np.random.default_rng(23)
    pairs = boxes.Pairs(
        ends_of(rng.uniform(-2, 0, (2, 100)), rng.uniform(0, 3, (2, 100))), np.arange(100)
    )
    slopes = Intervals.point(rng.normal(size=(2, 2, 100)))
    for closed in (
        np.zeros((2, 100), dtype=bool),
        np.stack([np.ones(100, dtype=bool), np.zeros(100, dtype=bool)]),
    ):
        along = verdicts._to_bisect(pairs.ends, slopes, closed, np.ones(2))
        halves = boxes._bisected(pairs, along)
        assert halves.nodes.tolist() == [*range(100), *range(100)]
        lower, upper = halves.ends[:, :, :100], halves.ends[:, :, 100:]
        cut = (lower != pairs.ends).any(axis=0)
        assert (cut.sum(axis=0) == 1).all()  # along one unknown
        assert (cut == (upper != pairs.ends).any(axis=0)).all()
        assert not cut[closed].any()
        assert (lower[0] == pairs.ends[0]).all()
        assert (upper[1] == pairs.ends[1]).all()
        assert (lower[1] == -upper[0])[cut].all()  # nothing between them
        share = (lower[1] + pairs.ends[0])[cut] / (pairs.ends[0] + pairs.ends[1])[cut]
        assert (np.abs(share - 0.5) < 0.02).all()
        assert (share != 0.5).all()


# ------------------------------------------------------------------------------------------------
# from boxes to roots


def once(low, high, alone_low, alone_high, point):
    keep, unclear = certified_roots.once(
        ends_of(low, high), ends_of(alone_low, alone_high), np.array(point)
    )
    return keep.tolist(), unclear.tolist()


def test_roots_are_listed_once():
    """By their boxes: one where another is alone is the same, apart is another, and what is neither
    is not known.
    """
    wide = ([[0.0, 0.1]], [[2.0, 2.1]])
    assert once([[0.9, 0.95]], [[1.1, 1.15]], *wide, [0, 0]) == ([0], [])
    assert once([[0.9, 0.95]], [[1.1, 1.15]], *wide, [0, 1]) == ([0, 1], [])  # of two points
    assert once([[0.9, 2.05]], [[1.1, 2.1]], [[0.0, 1.9]], [[2.0, 3.0]], [0, 0]) == (
        [0, 1],
        [],
    )  # apart, alone overlaps
    assert once([[0.9, 1.05]], [[1.1, 1.2]], [[0.85, 1.04]], [[1.12, 1.3]], [0, 0]) == (
        [0],
        [1],
    )  # may be either
    assert once([[0.9, 1.05]], [[1.1, 1.2]], [[0.85, 0.86]], [[1.12, 1.3]], [0, 0]) == (
        [0],
        [],
    )  # the first in the second's
    # The same in the first unknown, apart in the second; three in a row, of which the outer ones
    # are the same.
    assert once(
        [[0.9, 0.9], [0.0, 1.0]],
        [[1.1, 1.1], [0.1, 1.1]],
        [[0.8, 0.8], [-0.1, 0.9]],
        [[1.2, 1.2], [0.2, 1.2]],
        [0, 0],
    ) == ([0, 1], [])
    low = [[0.9, 0.9, 0.91], [0.0, 1.0, 0.01]]
    high = [[1.1, 1.1, 1.09], [0.1, 1.1, 0.09]]
    assert once(
        low,
        high,
        [[0.8, 0.81, 0.82], [-0.1, 0.9, -0.1]],
        [[1.2, 1.2, 1.2], [0.2, 1.2, 0.2]],
        [3, 3, 3],
    ) == ([0, 1], [])


def outcome(unique, where, undecided, values, unique_nodes, undecided_nodes):
    points = tree(values, values)
    pairs = [
        boxes.Pairs(ends, np.array(nodes))
        for ends, nodes in (
            (unique, unique_nodes),
            (where, unique_nodes),
            (undecided, undecided_nodes),
        )
    ]
    return boxes.SearchOutcome(*pairs, points, 0)


def refined(monkeypatch, given, wide, values):
    """The roots of a search over boxes with this outcome."""
    monkeypatch.setattr(boxes, "search", lambda *_: given)
    return certified_roots.search(Lines(), np.full((2, 2, 1), wide), values, values)


def test_roots_inside_on_and_outside_of_the_border(monkeypatch):
    """Of one point with (x − a)(x − b): one inside, and others about the border."""
    none = np.empty((2, 2, 0))
    for b, counts in ((0.5, (2, 0)), (1.5, (1, 0)), (1.0, (1, 1)), (-1.5, (1, 0)), (-1.0, (1, 1))):
        values = np.array([[-0.25], [b], [0.5]])
        middle = np.array([[-0.25, b], [-0.125, 0.5 * b]])
        alone = ends_of(middle - 0.05, middle + 0.05)
        given = outcome(alone, ends_of(middle - 0.02, middle + 0.02), none, values, [0, 0], [])
        found = refined(monkeypatch, given, 1.0, values)
        assert (found.point.size, found.undecided_point.size) == counts
        assert found.middle[0].tolist() == sorted(found.middle[0].tolist())
        assert found.error.max() < 1e-14
        for x in [-0.25, *([b] if counts[0] == 2 else [])]:
            assert holds(found.ends, np.array([x, 0.5 * x])).sum() == 1
        if counts[1]:
            assert holds(found.undecided, np.array([b, 0.5 * b])).all()


def test_what_was_undecided_is_left_with_its_point(monkeypatch):
    values = np.array([[-0.25, 0.25, 0.3], [5.0, 6.0, 7.0], [0.5, 0.5, 0.5]])
    points = tree(values, values)
    middle = np.array([[0.3], [0.15]])
    node = next(
        node
        for node in range(points.size.size)
        if points.below(np.array([node]))[1].tolist() == [2]
    )
    alone, open_one = ends_of(middle - 0.05, middle + 0.05), ends_of([[1.0], [2.0]], [[3.0], [4.0]])
    given = outcome(alone, alone, open_one, values, [node], [0])
    found = refined(monkeypatch, given, 4.0, values)
    assert found.point.tolist() == [2]
    assert holds(found.ends, np.array([0.3, 0.15])).all()
    assert sorted(found.undecided_point.tolist()) == [0, 1, 2]
    assert (found.undecided == open_one).all()


def test_a_box_without_its_root_is_told(monkeypatch):
    """It is undecided: a law may end at the root itself, where refinement loses it."""
    values = np.array([[-0.25], [5.0], [0.5]])
    wrong = ends_of([[1.0], [0.5]], [[1.1], [0.6]])
    given = outcome(wrong, wrong, np.empty((2, 2, 0)), values, [0], [])
    found = refined(monkeypatch, given, 4.0, values)
    assert (found.point.size, found.undecided_point.tolist()) == (0, [0])
    assert (found.undecided[:, :, 0] == wrong[:, :, 0]).all()


def test_relative_errors():
    """The larger of both sides, over the value's size or 1, of the worst unknown; no less than
    exactly that.
    """
    ends = ends_of([[0.9, -4.0, 1 / 3], [10.0, 0.0, 1 / 3]], [[1.3, -3.0, 1 / 3], [11.0, 0.0, 1.0]])
    middle = np.array([[1.0, -3.25, 1 / 3], [10.25, 0.0, 0.9]])
    error = certified_roots.relative_error(ends, middle)
    assert np.abs(error - [0.3, 0.75 / 3.25, 0.9 - 1 / 3]).max() < 1e-14
    rng = np.random.default_rng(25)
    middle = rng.normal(size=(1, 300)) * 10.0 ** rng.integers(-3, 4, 300)
    ends = ends_of(
        middle - 10.0 ** rng.uniform(-18, 0, 300), middle + 10.0 ** rng.uniform(-18, 0, 300)
    )
    error = certified_roots.relative_error(ends, middle)
    for k in range(300):
        at = Fraction(float(middle[0, k]))
        exact = max(Fraction(float(ends[1, 0, k])) - at, at + Fraction(float(ends[0, 0, k]))) / max(
            1, abs(at)
        )
        assert (
            exact
            <= Fraction(float(error[k]))
            <= exact * (1 + Fraction(1, 10**12)) + Fraction(1, 2**990)
        )
