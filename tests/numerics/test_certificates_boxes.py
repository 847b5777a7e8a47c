"""What the search over boxes proves, each step by itself against fractions: where roots are, and that there is one or none."""

from __future__ import annotations

import itertools
from fractions import Fraction

import numpy as np
import pytest

from spragsym.exact import boxes, certified_roots, contractors
from spragsym.exact.interval_arrays import Intervals, stacked
from spragsym.exact.parameter_tree import tree

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
    return Intervals.between(values - spread * rng.uniform(0, 1, values.shape), values + spread * rng.uniform(0, 1, values.shape))


# ------------------------------------------------------------------------------------------------- interval Newton


@pytest.mark.parametrize("n", [1, 2, 3, 4])
@pytest.mark.parametrize("spread", [0.0, 1e-14, 0.02])
def test_every_root_lies_in_the_result(n, spread):
    """Of systems whose slopes and values are corners of the given intervals; with no spread, rounding is all there is."""
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
        root = [m - x for m, x in zip(fractions(middle[:, k]), solution(matrix, right), strict=True)]
        if any(abs(x - m) > 1000 for x, m in zip(root, fractions(middle[:, k]), strict=True)):
            continue
        assert not none[k]
        assert not step.none[k]
        for ends in (step.ends, rows, each):
            for i in range(n):
                assert not np.isfinite(ends[0, i, k]) or -Fraction(float(ends[0, i, k])) <= root[i]
                assert not np.isfinite(ends[1, i, k]) or root[i] <= Fraction(float(ends[1, i, k]))
        seen += bool(step.dominant[:, k].all())
    assert seen > N / 2


@pytest.mark.parametrize("n", [1, 2, 3])
def test_the_result_is_as_narrow_as_its_inputs(n):
    """Without spread it is the solution to rounding; with one, of the values only, as wide as the exact solutions are."""
    rng = np.random.default_rng(n)
    N = 50
    matrices = rng.normal(size=(n, n, N)) + 3 * np.eye(n)[:, :, None]
    middle, right = rng.normal(size=(2, n, N))
    slopes, reach = Intervals.point(matrices), np.full((n, N), 1.0)
    exact = middle - np.linalg.solve(np.moveaxis(matrices, -1, 0), right.T[:, :, None])[:, :, 0].T
    step = contractors.newton(Intervals.point(right), slopes, middle, reach)
    assert np.abs(step.ends - np.stack([-exact, exact])).max() < 1e-12
    assert step.dominant.all()
    assert step.noise.max() < 1e-13
    wide = contractors.newton(Intervals.between(right - 0.1, right + 0.1), slopes, middle, reach)
    half = 0.1 * np.abs(np.moveaxis(np.linalg.inv(np.moveaxis(matrices, -1, 0)), 0, -1)).sum(axis=1)
    assert np.abs(wide.ends - (np.stack([-exact, exact]) + half)).max() < 1e-12
    assert np.abs(wide.noise - half).max() < 1e-12


def test_a_row_tells_what_an_inverse_does_not():
    """x + y = −1 and −2 x − 2 y = 2 about 0, |x| ≤ 1/4, |y| ≤ 1/2: each by the other; with −2 x − 2 y = 4 there is no root."""
    slopes = Intervals.point([[[1.0, 1.0], [1.0, 1.0]], [[-2.0, -2.0], [-2.0, -2.0]]])
    values, reach = Intervals.point([[1.0, 1.0], [-2.0, -4.0]]), np.array([[0.25, 0.25], [0.5, 0.5]])
    ends, none = contractors.by_each_row(values, slopes, np.zeros((2, 2)), reach)
    assert np.abs(-ends[0, :, 0] - [-1.5, -1.25]).max() < 1e-14
    assert np.abs(ends[1, :, 0] - [-0.5, -0.75]).max() < 1e-14
    assert none.tolist() == [True, True]  # |x + y| is at most 3/4
    assert not contractors.by_each_row(values, slopes, np.zeros((2, 2)), 2 * reach)[1][0]
    nearly = slopes + Intervals.between([[[0.0], [0.0]], [[0.0], [-1e-9]]], [[[0.0], [0.0]], [[0.0], [1e-9]]])
    assert contractors.newton(values, nearly, np.zeros((2, 2)), 2 * reach).none.tolist() == [False, True]


def test_a_diagonal_that_may_vanish_bounds_nothing():
    """From its row nothing follows; a diagonal in [1, 4] is divided by at the end that gives the wider result."""
    slopes = Intervals.between([[[0.0, -1.0, 1.0]]], [[[2.0, 2.0, 4.0]]])
    for value, expected in ((4.0, (-4.0, -1.0)), (-4.0, (1.0, 4.0))):
        ends = contractors.by_rows(Intervals.point([[value] * 3]), slopes, np.zeros((1, 3)), np.ones((1, 3)))
        assert (ends[:, 0, :2] == np.inf).all()
        assert np.abs([-ends[0, 0, 2] - expected[0], ends[1, 0, 2] - expected[1]]).max() < 1e-14
    step = contractors.newton(
        Intervals.point([[1.0, 1.0]]), Intervals.between([[[-1.0, 0.5]]], [[[2.0, 1.0]]]), np.zeros((1, 2)), np.ones((1, 2))
    )
    assert step.dominant.tolist() == [[False, True]]


# ------------------------------------------------------------------------------------------------------- exclusion


def excluded(values, slopes, reach):
    """Boxes about 0 of which a row tells that they hold no root."""
    return contractors.by_each_row(values, slopes, np.zeros_like(reach), reach)[1]


def test_rounding_excludes_no_root():
    """1 + 2⁻⁵³ + 2⁻⁵³, which is 1 in floats, and three products of 0.4 of the smallest float, which are 0."""
    slopes = Intervals.point(np.array([[[1.0], [2.0**-53], [2.0**-53]]] * 3))
    assert not excluded(Intervals.point([[1 + 2.0**-52]] * 3), slopes, np.ones((3, 1))).any()
    small = Intervals.point(np.full((3, 3, 1), 0.4))
    assert not excluded(Intervals.point([[5e-324]] * 3), small, np.full((3, 1), 5e-324)).any()


# ---------------------------------------------------------------------------------------------- directions, borders


def test_a_direction_that_there_is_is_not_denied():
    """G = −M u for random directions and matrices in the intervals; shifted so far that there is none, it is denied."""
    rng = np.random.default_rng(6)
    for n, spread in itertools.product((2, 3), (0.0, 1e-15, 0.05)):
        factors = around(rng.normal(size=(n, 2, 300)) + 2 * np.eye(n, 2)[:, :, None], spread, rng)
        angle = rng.uniform(-np.pi, np.pi, 300)
        u = np.stack([np.cos(angle), np.sin(angle)])
        held = np.where(rng.integers(0, 2, factors.shape), factors.high, factors.low)
        right = -np.einsum("kiN,iN->kN", held, u)
        rest = Intervals.between(right - 1e-14, right + 1e-14)  # which the rounding of right and u is less than
        assert not contractors.no_unit_vector(rest, factors).any()
        for factor in (0.5, 1.5):
            denied = contractors.no_unit_vector(rest * factor, factors)
            assert denied.all() if spread < 0.01 else denied.any()


def test_exact_directions_are_not_denied():
    """u = (3/5, 4/5) with integers, where no rounding helps: 5 u + G = 0, and with a matrix that is not square."""
    for factors in ([[5.0, 0.0], [0.0, 5.0]], [[5.0, 0.0], [0.0, 5.0], [5.0, 5.0]], [[5.0, 5.0], [0.0, 5.0]]):
        matrix = np.array(factors)
        rest = -(matrix @ [3.0, 4.0]) / 5
        assert not contractors.no_unit_vector(Intervals.point(rest[:, None]), Intervals.point(matrix[:, :, None]))[0]
        for part in (0.999, 1.001):
            assert contractors.no_unit_vector(Intervals.point(part * rest[:, None]), Intervals.point(matrix[:, :, None]))[0]


def test_a_wide_matrix_denies_nothing():
    """u = (0, 1) and M with one element in ±3/2, whose row it is that is uncertain."""
    factors = Intervals.between([[[1.0], [-1.5]], [[0.0], [1.0]]], [[[1.0], [1.5]], [[0.0], [1.0]]])
    for element in (-1.5, 0.0, 1.5):
        assert not contractors.no_unit_vector(Intervals.point([[-element], [-1.0]]), factors)[0]


def test_boxes_inside_of_boxes_and_apart():
    unit = ends_of(np.zeros((2, 6)), np.ones((2, 6)))
    inner = ends_of(
        [[0.1, 0.0, 0.1, 0.1, -0.1, 0.2], [0.1, 0.1, 0.1, 0.1, 0.1, 0.2]],
        [[0.9, 0.9, 0.9, 0.9, 0.9, 0.8], [0.9, 0.9, 1.0, 1.1, 0.9, np.nan]],
    )
    assert contractors.inside(inner, unit).tolist() == [True, False, False, False, False, False]
    assert contractors.within(inner, unit).tolist() == [True, True, True, False, False, False]
    unit, other = (
        unit[:, :, :5],
        ends_of(
            [[1.1, 1.0, 0.5, -3.0, np.nan], [0.0, 0.0, 0.5, 0.0, 0.0]], [[2.0, 2.0, 0.7, -1e-9, 3.0], [1.0, 1.0, 0.7, 1.0, 1.0]]
        ),
    )
    for pair in ((unit, other), (other, unit), (unit[:, ::-1], other[:, ::-1])):
        assert contractors.apart(*pair).tolist() == [True, False, False, True, False]


# -------------------------------------------------------------------------------------------------------- matrices


@pytest.mark.thorough
@pytest.mark.parametrize("spread", [0.0, 0.1])
def test_products_hold_the_exact_ones(spread):
    rng = np.random.default_rng(7)
    for n, columns, powers in itertools.product((1, 2, 4), (1, 3), ((0,), (-540, -530), (-30, 30))):
        Y = rng.normal(size=(n, n, 20)) * 2.0 ** rng.choice(powers, (n, n, 20))
        X = around(rng.normal(size=(n, columns, 20)) * 2.0 ** rng.choice(powers, (n, columns, 20)), spread, rng)
        ends = contractors.product(Y, X.ends)
        for k in range(20):
            left, low, high = fractions(Y[:, :, k]), fractions(X.low[:, :, k]), fractions(X.high[:, :, k])
            for i, j in itertools.product(range(n), range(columns)):
                parts = [sorted((left[i, m] * low[m, j], left[i, m] * high[m, j])) for m in range(n)]
                least, most = sum(part[0] for part in parts), sum(part[1] for part in parts)
                size = sum(max(map(abs, part)) for part in parts)
                assert least - size / 2**48 - Fraction(1, 2**990) <= -Fraction(float(ends[0, i, j, k])) <= least
                assert most <= Fraction(float(ends[1, i, j, k])) <= most + size / 2**48 + Fraction(1, 2**990)


def test_inverses_of_what_has_none_are_the_unit_matrix():
    """Zeros, NaN and infinities; their neighbours keep theirs, be they large or small."""
    for n in (2, 3, 4):
        good = np.eye(n) * 2 + 0.5
        bad = [np.zeros((n, n)), np.full((n, n), np.nan), np.full((n, n), np.inf)]
        matrices = np.moveaxis(np.array([good, *bad, good * 1e-150, good * 1e150]), 0, -1)
        inverses = contractors.inverse(matrices)
        for k, scale in ((0, 1.0), (4, 1e-150), (5, 1e150)):
            assert np.allclose(inverses[:, :, k] @ good * scale, np.eye(n), rtol=0, atol=1e-12)
        assert (inverses[:, :, 1:4] == np.eye(n)[:, :, None]).all()
        for wrong in (np.nan, np.inf, -np.inf):
            partly = np.moveaxis(np.array([good, good]), 0, -1)
            partly[0, 0, 1] = wrong
            inverses = contractors.inverse(partly)
            assert np.allclose(inverses[:, :, 0] @ good, np.eye(n), rtol=0, atol=1e-12)
            assert (inverses[:, :, 1] == np.eye(n)).all()
        diagonal = np.diag(-np.arange(1.0, n + 1))[:, :, None]
        assert np.abs(contractors.inverse(diagonal)[:, :, 0] + np.diag(1 / np.arange(1.0, n + 1))).max() < 1e-15
    ranks = np.ones((3, 3, 1)) + np.diag([1.0, 0.0, 0.0])[:, :, None]
    assert (contractors.inverse(ranks) == np.eye(3)[:, :, None]).all()


# ---------------------------------------------------------------------------------------------- one look at boxes


class Lines(boxes.Plain):
    """(x − a)(x − b) = 0 and y = c x: the roots (a, c a) and (b, c b), for parameters a, b, c."""

    def residuals(self, unknowns, parameters):
        x, y = unknowns
        a, b, c = parameters
        return stacked([(x - a) * (x - b), y - c * x], x.shape)

    def jacobian(self, unknowns, parameters):
        x = unknowns[0]
        a, b, c = parameters
        return Intervals(stacked([x - a + (x - b), 0, -c, 1], x.shape).ends.reshape(2, 2, 2, *x.shape))


def ends_of(low, high):
    """−low and high of boxes, shape (2, n, N)."""
    return np.stack([-np.asarray(low, dtype=float), np.asarray(high, dtype=float)])


def roots_of(system, region, values):
    """Of points that are no boxes."""
    return certified_roots.roots(system, boxes.search(system, region, values, values), region, values, values)


def holds(ends, root):
    """Which boxes hold a point."""
    return ((-ends[0] <= root[:, None]) & (root[:, None] <= ends[1])).all(axis=0)


def random_pairs(rng, count, points):
    """Boxes of all sizes about one of the roots of their point, which may lie on their border or in a corner."""
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
    """Whatever a look makes of a box, its root is in what is left, or in a box with one root, or among what is undecided."""
    rng = np.random.default_rng(20 + steps)
    a, c = rng.uniform(-3, 3, 64), rng.uniform(-2, 2, 64)
    b = a + rng.choice([1e-6, 1e-3, 0.1, 2.0], 64)
    values = np.stack([a, b, c])
    points = tree(values, values)
    search = boxes._Search(Lines(), points, np.full((2, 2, 1), np.inf), 5, boxes.NARROW)
    pairs, roots = random_pairs(rng, 600, points)
    left = pairs
    for _ in range(steps):
        left = search.look(left)
    unique, where, undecided = (boxes.joined(part, 2) for part in (search.unique, search.where, search.undecided))
    for k in range(len(pairs)):
        node, (x, y) = pairs.nodes[k], roots[:, k]
        kept = np.concatenate([part.ends[:, :, part.nodes == node] for part in (left, unique, undecided)], axis=2)
        # y is off by a rounding of c x.
        assert any(holds(kept, np.array([x, near])).any() for near in (y, np.nextafter(y, -np.inf), np.nextafter(y, np.inf)))
    assert len(unique)
    # One root in each of those: of the two only one lies in it, with room for rounding, and in the box that tells where.
    for k in range(len(unique)):
        a, b, c = points.bounds.low[:, unique.nodes[k]]
        there = [holds(unique.ends[:, :, k : k + 1], np.array([x, c * x]))[0] for x in (a, b)]
        assert sum(there) == 1
        x = (a, b)[int(there[1])]
        off = np.abs(np.array([x, c * x]) - Intervals(where.ends).middle[:, k])
        assert (off <= where.ends[:, :, k].sum(axis=0) + 1e-15).all()


def test_halves_make_up_the_box():
    rng = np.random.default_rng(23)
    pairs = boxes.Pairs(ends_of(rng.uniform(-2, 0, (2, 100)), rng.uniform(0, 3, (2, 100))), np.arange(100))
    slopes = Intervals.point(rng.normal(size=(2, 2, 100)))
    for closed in (np.zeros((2, 100), dtype=bool), np.stack([np.ones(100, dtype=bool), np.zeros(100, dtype=bool)])):
        halves = boxes._halves(pairs, slopes, closed)
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


def test_a_box_is_cut_where_the_residuals_change_most():
    """By the slope times the width, each residual's change for itself; by the width where the slopes are not known."""
    ends = ends_of(np.zeros((2, 4)), [[1.0, 1.0, 4.0, 1.0], [1.0, 2.0, 1.0, 1.0]])
    slopes = np.zeros((2, 2, 4))
    slopes[:, :, 0] = [[3.0, 1.0], [0.0, 1e-3]]  # 3/4 + 0 against 1/4 + 1
    slopes[:, :, 1] = [[3.0, 1.0], [2.0, 1.0]]  # 3/5 + 2/4 against 2/5 + 2/4
    slopes[:, :, 2] = [[np.nan, 1.0], [0.0, 1.0]]
    slopes[:, :, 3] = [[1.0, -9.0], [1.0, 2.0]]
    halves = boxes._halves(boxes.Pairs(ends, np.arange(4)), Intervals.point(slopes), np.zeros((2, 4), dtype=bool))
    cut = (halves.ends[:, :, :4] != ends).any(axis=0)
    assert cut.argmax(axis=0).tolist() == [1, 0, 0, 1]


def test_what_is_narrow_is_not_cut():
    ends = ends_of([[1.0], [5.0]], [[2.0], [5.0 + 2.0**-46]])
    slopes = Intervals.point([[[1.0], [2.0**60]], [[0.0], [1.0]]])
    halves = boxes._halves(boxes.Pairs(ends, np.zeros(1, dtype=int)), slopes, np.zeros((2, 1), dtype=bool))
    assert (halves.ends[:, 1] == ends[:, 1]).all()


def test_room_stays_inside_of_what_was_given():
    given = ends_of([[0.0, 0.0, 0.0]], [[1.0, 1.0, 1.0]])
    narrowed = boxes._with_room(ends_of([[0.4, -1.0, np.nan]], [[0.6, 0.5, 0.5]]), given, 0.0)
    low, high = -narrowed[0, 0], narrowed[1, 0]
    assert 0 < low[0] < 0.4 - 0.04
    assert 0.64 < high[0] < 0.7
    assert low[1:].tolist() == [0.0, 0.0]  # what is not known is not narrowed
    noisy = boxes._with_room(ends_of([[0.4]], [[0.6]]), given[:, :, :1], 0.05)
    assert -noisy[0, 0, 0] < low[0]


def test_reach_is_no_less_than_the_distance():
    rng = np.random.default_rng(24)
    low = rng.normal(size=(1, 500)) * 10.0 ** rng.integers(-5, 5, (1, 500))
    high = low + rng.uniform(0, 2, (1, 500)) * 10.0 ** rng.integers(-16, 2, (1, 500))
    middle = Intervals.between(low, high).middle
    reach = contractors.distance(ends_of(low, high), middle)
    for k in range(500):
        least, at, most = fractions([low[0, k], middle[0, k], high[0, k]])
        exact = max(most - at, at - least)
        assert exact <= Fraction(float(reach[0, k])) <= exact * (1 + Fraction(1, 2**50)) + Fraction(1, 2**990)


def divided(points, before, now, noise, closed, work=(), budget=100, nodes=None):
    """Lists of (box, node) that one division leaves, and of those that it gives up."""
    search = boxes._Search(Lines(), points, np.full((2, 2, 1), np.inf), budget, boxes.NARROW)
    for node, looks in work:
        search.work[node] = looks
    count = now.shape[2]
    nodes = np.zeros(count, dtype=np.int64) if nodes is None else np.array(nodes)
    slopes = Intervals.point(np.tile(np.eye(2)[:, :, None], (1, 1, count)))
    left = search._divided(boxes.Pairs(before, nodes), boxes.Pairs(now, nodes), noise, slopes, closed)
    parts = left, boxes.joined(search.undecided, 2)
    return [[(part.ends[:, :, k].tolist(), int(part.nodes[k])) for k in range(len(part))] for part in parts]


ONE, TWO = (tree(np.array(values), np.array(values)) for values in ([[0.0]] * 3, [[0.0, 1.0], [5.0, 5.0], [0.0, 0.0]]))
UNIT = ends_of([[-0.5], [-0.5]], [[0.5], [0.5]])
OPEN = np.zeros((2, 1), dtype=bool)


def sized(width, other=1.0):
    """A box beside 1 of these widths."""
    return ends_of([[1.0 - width], [1.0 - other]], [[1.0], [1.0]])


def test_what_got_much_narrower_is_looked_at_again_and_other_boxes_are_halved():
    quiet = np.zeros((2, 1))
    wide = sized(0.5, 0.5)
    for now, closed, again in (
        (sized(0.5, 0.5), OPEN, False), (sized(0.3, 0.5), OPEN, False), (sized(0.29, 0.5), OPEN, True),
        (sized(0.35, 0.35), OPEN, True), (sized(0.1, 0.5), np.array([[True], [False]]), False),
        (sized(0.1, 0.2), np.array([[True], [False]]), True),
    ):  # fmt: skip
        left, undecided = divided(ONE, wide, now, quiet, closed)
        assert not undecided
        if again:
            assert left == [(now[:, :, 0].tolist(), 0)]
        else:
            assert len(left) == 2
            assert {node for _, node in left} == {0}
            assert np.max([box for box, _ in left], axis=0).tolist() == now[:, :, 0].tolist()


def test_a_box_of_one_point_is_given_up_where_halving_helps_no_more():
    """By its width alone, by its width and the noise, or because its point has cost enough; each at its border."""
    narrow, small, share = boxes.NARROW, boxes.SMALL, boxes.SPREAD
    cases = [
        (sized(narrow, narrow), [0, 0], 0, True),
        (sized(narrow, 1.001 * narrow), [0, 0], 0, False),
        (sized(small, small), [share * small, 0], 0, True),
        (sized(small, small), [0, share * small * 1.01], 0, True),
        (sized(small, small), [0.99 * share * small] * 2, 0, False),
        (sized(small, 2 * small), [1, 1], 0, False),
        (sized(0.5, 0.5), [1, 1], 0, False),
        (sized(0.5, 0.5), [0, 0], 101, True),
        (sized(0.5, 0.5), [0, 0], 100, False),
        # In proportion to each unknown, and absolutely where that is below 1.
        (ends_of([[1000.0], [0.0]], [[1000.0 + 990 * narrow], [narrow]]), [0, 0], 0, True),
        (ends_of([[1000.0], [0.0]], [[1000.0 + 990 * narrow], [2 * narrow]]), [0, 0], 0, False),
        (ends_of([[-1000.0 - 990 * narrow], [0.001]], [[-1000.0], [0.001 + narrow / 2]]), [0, 0], 0, True),
    ]
    for box, noise, looks, given_up in cases:
        left, undecided = divided(ONE, box, box, np.array(noise, dtype=float)[:, None], OPEN, [(0, looks)])
        assert (len(left), len(undecided)) == ((0, 1) if given_up else (2, 0)), (box, noise, looks)


def test_points_are_parted_where_they_move_the_root_or_cost_much():
    """Of a node of two points; their box stays as it is, and is not given up."""
    quiet, share = np.zeros((2, 1)), boxes.SPREAD
    for noise, looks, parted in (
        (quiet, 0, False), (quiet, boxes.NODE_BUDGET, False), (quiet, boxes.NODE_BUDGET + 1, True),
        (np.array([[share], [0.0]]), 0, True), (np.array([[0.99 * share], [0.0]]), 0, False),
    ):  # fmt: skip
        left, undecided = divided(TWO, UNIT, UNIT, noise, OPEN, [(0, looks)], budget=10**6)
        assert not undecided
        if parted:
            assert left == [(UNIT[:, :, 0].tolist(), 1), (UNIT[:, :, 0].tolist(), 2)]
        else:
            assert [node for _, node in left] == [0, 0]
    # What has become too narrow is given up for both at once, unless it is the parameters that keep it open.
    tiny = sized(boxes.NARROW, boxes.NARROW)
    left, undecided = divided(TWO, tiny, tiny, quiet, OPEN)
    assert (left, [node for _, node in undecided]) == ([], [0])
    left, undecided = divided(TWO, tiny, tiny, quiet + share * boxes.NARROW, OPEN)
    assert ([node for _, node in left], undecided) == ([1, 2], [])
    # Boxes of both kinds in one go.
    both = np.concatenate([UNIT, UNIT, UNIT], axis=2)
    noise = np.array([[1.0, 0.0, 0.0], [0.0] * 3])
    left, undecided = divided(TWO, both, both, noise, np.zeros((2, 3), dtype=bool), [(2, 5)], 4, [0, 1, 2])
    assert [node for _, node in left] == [1, 2, 1, 1]
    assert undecided == [(UNIT[:, :, 0].tolist(), 2)]


def test_a_look_keeps_what_it_can_neither_prove_nor_rule_out():
    """(x − a)(x − b) with roots 0.1 and 3 about boxes that hold the one, none, both, or touch the one."""
    values = np.array([[0.1], [3.0], [0.5]])
    points = tree(values, values)
    search = boxes._Search(Lines(), points, np.full((2, 2, 1), np.inf), 100, boxes.NARROW)
    low = np.array([[0.0, 1.0, -5.0, 0.1], [0.0, 0.0, -5.0, 0.0]])
    high = np.array([[0.2, 1.2, 5.0, 0.14], [0.2, 5.0, 5.0, 0.2]])
    left = search.look(boxes.Pairs(ends_of(low, high), np.zeros(4, dtype=np.int64)))
    unique = boxes.joined(search.unique, 2)
    assert (search.looks, search.work.tolist()) == (4, [4])
    assert len(unique) == 2
    assert len(boxes.joined(search.where, 2)) == 2
    # Widened, so that the root on the border is inside.
    assert (unique.ends > ends_of(low, high)[:, :, [0, 3]]).all()
    assert len(left) == 2
    assert (np.max(left.ends, axis=2) >= [[2.0, 2.0], [3.0, 1.5]]).all()


def test_no_box_is_widened_beyond_the_limits():
    asked = []

    class Limited(Lines):
        def jacobian(self, unknowns, parameters):
            asked.append(unknowns.ends.max(axis=2))
            return super().jacobian(unknowns, parameters)

    values = np.array([[0.1], [3.0], [0.5]])
    limits = np.array([[0.01, 9.0], [4.0, 9.0]])
    found = boxes.search(Limited(), ends_of([[0.0], [-1.0]], [[4.0], [2.0]]), values, values, limits=limits)
    assert len(found.unique) >= 2
    assert (np.max(asked, axis=0) <= limits).all()
    assert np.max(asked, axis=0)[0, 0] == 0.01
    assert np.max(asked, axis=0)[1, 1] > 2.0


@pytest.mark.thorough
def test_batches_do_not_show(monkeypatch):
    """Nor are they larger than twice what is asked for; each box is looked at once."""
    values = np.stack([np.linspace(-2, 2, 16), np.linspace(-1.9, 3, 16), np.linspace(0, 1, 16)])
    seen, sizes = [], []
    look = boxes._Search.look

    def watched(self, pairs):
        sizes.append(len(pairs))
        return look(self, pairs)

    monkeypatch.setattr(boxes._Search, "look", watched)
    for chunk in (1, 3, 50, 2048):
        monkeypatch.setattr(boxes, "CHUNK", chunk)
        sizes.clear()
        roots = roots_of(Lines(), np.full((2, 2, 1), 4.0), values)
        seen.append((sum(sizes), roots.middle.round(9).tolist(), roots.point.tolist()))
        assert 0 < min(sizes) <= max(sizes) <= 2 * chunk
        assert sum(sizes) == boxes.search(Lines(), np.full((2, 2, 1), 4.0), values, values).looks
    assert seen[0] == seen[1] == seen[2] == seen[3]
    assert seen[0][2] == sorted([*range(16), *range(16)])


def test_regions_of_points_are_searched_together():
    """The box around all of them is, once; and without any parameter."""
    values = np.array([[0.1, 0.2], [3.0, 4.0], [0.5, 0.5]])
    region = ends_of([[0.0, -1.0], [-3.0, -3.0]], [[1.0, 5.0], [3.0, 3.0]])
    roots = roots_of(Lines(), region, values)
    assert roots.point.tolist() == [0, 1, 1]
    assert np.abs(roots.middle[0] - [0.1, 0.2, 4.0]).max() < 1e-12
    assert not roots.left_point.size


def test_what_is_hopeless_or_contracted_away_is_dropped():
    class Half(Lines):
        def hopeless(self, unknowns, parameters):
            return unknowns.high[0] < 1

        def contracted(self, unknowns, parameters):
            ends = unknowns.ends.copy()
            ends[0, 0] = np.minimum(ends[0, 0], -2.0)  # x >= 2
            return ends

    values = np.array([[0.1], [3.0], [0.5]])
    assert np.abs(roots_of(Half(), np.full((2, 2, 1), 4.0), values).middle[0] - [3.0]).max() < 1e-12
    with pytest.raises(NotImplementedError):
        boxes.Plain().residuals(*[Intervals.point(np.zeros((2, 1)))] * 2)


# ------------------------------------------------------------------------------------------------- from boxes to roots


def once(low, high, alone_low, alone_high, point):
    keep, unclear = certified_roots.once(ends_of(low, high), ends_of(alone_low, alone_high), np.array(point))
    return keep.tolist(), unclear.tolist()


def test_roots_are_listed_once():
    """By their boxes: one where another is alone is the same, apart is another, and what is neither is not known."""
    wide = ([[0.0, 0.1]], [[2.0, 2.1]])
    assert once([[0.9, 0.95]], [[1.1, 1.15]], *wide, [0, 0]) == ([0], [])
    assert once([[0.9, 0.95]], [[1.1, 1.15]], *wide, [0, 1]) == ([0, 1], [])  # of two points
    assert once([[0.9, 2.05]], [[1.1, 2.1]], [[0.0, 1.9]], [[2.0, 3.0]], [0, 0]) == ([0, 1], [])  # apart, alone overlaps
    assert once([[0.9, 1.05]], [[1.1, 1.2]], [[0.85, 1.04]], [[1.12, 1.3]], [0, 0]) == ([0], [1])  # may be either
    assert once([[0.9, 1.05]], [[1.1, 1.2]], [[0.85, 0.86]], [[1.12, 1.3]], [0, 0]) == ([0], [])  # the first in the second's
    # The same in the first unknown, apart in the second; three in a row, of which the outer ones are the same.
    assert once(
        [[0.9, 0.9], [0.0, 1.0]], [[1.1, 1.1], [0.1, 1.1]], [[0.8, 0.8], [-0.1, 0.9]], [[1.2, 1.2], [0.2, 1.2]], [0, 0]
    ) == ([0, 1], [])
    low = [[0.9, 0.9, 0.91], [0.0, 1.0, 0.01]]
    high = [[1.1, 1.1, 1.09], [0.1, 1.1, 0.09]]
    assert once(low, high, [[0.8, 0.81, 0.82], [-0.1, 0.9, -0.1]], [[1.2, 1.2, 1.2], [0.2, 1.2, 0.2]], [3, 3, 3]) == ([0, 1], [])


def outcome(unique, where, undecided, values, unique_nodes, undecided_nodes):
    points = tree(values, values)
    pairs = [
        boxes.Pairs(ends, np.array(nodes))
        for ends, nodes in ((unique, unique_nodes), (where, unique_nodes), (undecided, undecided_nodes))
    ]
    return boxes.Outcome(*pairs, points, 0)


def test_roots_inside_on_and_outside_of_the_border():
    """Of one point with (x − a)(x − b): one inside, and others about the border."""
    none = np.empty((2, 2, 0))
    for b, counts in ((0.5, (2, 0)), (1.5, (1, 0)), (1.0, (1, 1)), (-1.5, (1, 0)), (-1.0, (1, 1))):
        values = np.array([[-0.25], [b], [0.5]])
        middle = np.array([[-0.25, b], [-0.125, 0.5 * b]])
        alone = ends_of(middle - 0.05, middle + 0.05)
        given = outcome(alone, ends_of(middle - 0.02, middle + 0.02), none, values, [0, 0], [])
        found = certified_roots.roots(Lines(), given, np.full((2, 2, 1), 1.0), values, values)
        assert (found.point.size, found.left_point.size) == counts
        assert found.middle[0].tolist() == sorted(found.middle[0].tolist())
        assert found.error.max() < 1e-14
        for x in [-0.25, *([b] if counts[0] == 2 else [])]:
            assert holds(found.ends, np.array([x, 0.5 * x])).sum() == 1
        if counts[1]:
            assert holds(found.left, np.array([b, 0.5 * b])).all()


def test_what_was_undecided_is_left_with_its_point():
    values = np.array([[-0.25, 0.25, 0.3], [5.0, 6.0, 7.0], [0.5, 0.5, 0.5]])
    points = tree(values, values)
    middle = np.array([[0.3], [0.15]])
    node = next(node for node in range(points.size.size) if points.points(node).tolist() == [2])
    alone, open_one = ends_of(middle - 0.05, middle + 0.05), ends_of([[1.0], [2.0]], [[3.0], [4.0]])
    given = outcome(alone, alone, open_one, values, [node], [0])
    found = certified_roots.roots(Lines(), given, np.full((2, 2, 1), 4.0), values, values)
    assert found.point.tolist() == [2]
    assert holds(found.ends, np.array([0.3, 0.15])).all()
    assert sorted(found.left_point.tolist()) == [0, 1, 2]
    assert (found.left == open_one).all()


def test_a_box_without_its_root_is_told():
    """It is undecided: a law may end at the root itself, where refinement loses it."""
    values = np.array([[-0.25], [5.0], [0.5]])
    wrong = ends_of([[1.0], [0.5]], [[1.1], [0.6]])
    given = outcome(wrong, wrong, np.empty((2, 2, 0)), values, [0], [])
    found = certified_roots.roots(Lines(), given, np.full((2, 2, 1), 4.0), values, values)
    assert (found.point.size, found.left_point.tolist()) == (0, [0])
    assert (found.left[:, :, 0] == wrong[:, :, 0]).all()


def test_relative_errors():
    """The larger of both sides, over the value's size or 1, of the worst unknown; no less than exactly that."""
    ends = ends_of([[0.9, -4.0, 1 / 3], [10.0, 0.0, 1 / 3]], [[1.3, -3.0, 1 / 3], [11.0, 0.0, 1.0]])
    middle = np.array([[1.0, -3.25, 1 / 3], [10.25, 0.0, 0.9]])
    error = certified_roots.relative_error(ends, middle)
    assert np.abs(error - [0.3, 0.75 / 3.25, 0.9 - 1 / 3]).max() < 1e-14
    rng = np.random.default_rng(25)
    middle = rng.normal(size=(1, 300)) * 10.0 ** rng.integers(-3, 4, 300)
    ends = ends_of(middle - 10.0 ** rng.uniform(-18, 0, 300), middle + 10.0 ** rng.uniform(-18, 0, 300))
    error = certified_roots.relative_error(ends, middle)
    for k in range(300):
        at = Fraction(float(middle[0, k]))
        exact = max(Fraction(float(ends[1, 0, k])) - at, at + Fraction(float(ends[0, 0, k]))) / max(1, abs(at))
        assert exact <= Fraction(float(error[k])) <= exact * (1 + Fraction(1, 10**12)) + Fraction(1, 2**990)


# -------------------------------------------------------------------------------------------------- trees of points


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 8, 9, 100])
def test_a_tree_parts_its_points_evenly(count):
    """Each node has a box around its points, both children share them out, and no leaf has two."""
    rng = np.random.default_rng(count)
    low = rng.normal(size=(2, count)) * [[1.0], [100.0]]
    high = low + rng.uniform(0, 0.1, (2, count))
    made = tree(low, high)
    assert sorted(made.points(0).tolist()) == [*range(count)]
    assert made.size[0] == count
    assert made.size.size == 2 * made.order.size - 1
    assert made.order.size == 1 << made.depth
    assert made.order.size < 2 * count
    for node in range(made.size.size):
        mine = made.points(node)
        assert mine.size == made.size[node]
        if not mine.size:
            continue
        assert made.bounds.low[:, node].tolist() == low[:, mine].min(axis=1).tolist()
        assert made.bounds.high[:, node].tolist() == high[:, mine].max(axis=1).tolist()
        places, children = made.children(np.array([node])) if node < made.order.size - 1 else (np.empty(0, int), np.empty(0, int))
        assert not places.any()
        assert children.tolist() == [
            child for child in (2 * node + 1, 2 * node + 2) if node < made.order.size - 1 and made.size[child]
        ]
        if children.size:
            parts = [made.points(int(child)).tolist() for child in children]
            assert sorted(point for part in parts for point in part) == sorted(mine.tolist())
            # The first is full before the second has any.
            assert len(parts[0]) == min(mine.size, made.order.size >> int(np.log2(node + 1)) + 1)
        else:
            assert mine.size == 1


def test_points_are_parted_in_the_parameter_that_is_spread_most():
    """Of the spread of all of them: 0.1 of 0.1 comes before 1 of 1000; and by its lower ends."""
    first = np.array([0.0, 1000.0, 1.0, 1001.0, 0.5, 1000.5, 1.5, 1001.5])
    second = np.array([0.0, 0.0, 0.1, 0.1, 0.01, 0.01, 0.09, 0.09])
    made = tree(np.stack([first, second]), np.stack([first, second]))
    halves = [sorted(made.points(node).tolist()) for node in (1, 2)]
    assert halves == [[0, 2, 4, 6], [1, 3, 5, 7]]
    quarters = [sorted(made.points(node).tolist()) for node in (3, 4, 5, 6)]
    assert quarters == [[0, 4], [2, 6], [1, 5], [3, 7]]
    same = tree(np.zeros((2, 4)), np.zeros((2, 4)))
    assert sorted(same.order.tolist()) == [0, 1, 2, 3]


def test_points_below_some_nodes():
    values = np.array([[0.0, 3.0, 1.0, 2.0, 10.0]])
    made = tree(values, values)
    places, points = made.below(np.array([2, 0, 1]))
    assert points[places == 0].tolist() == [4]
    assert sorted(points[places == 1].tolist()) == [0, 1, 2, 3, 4]
    assert sorted(points[places == 2].tolist()) == [0, 1, 2, 3]
    assert [part.size for part in made.below(np.empty(0, dtype=np.int64))] == [0, 0]
    places, children = made.children(np.array([0, 1, 2]))
    assert sorted(zip(places.tolist(), children.tolist(), strict=True)) == [(0, 1), (0, 2), (1, 3), (1, 4), (2, 5)]
