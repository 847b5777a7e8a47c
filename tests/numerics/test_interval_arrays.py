"""Arrays of intervals against exact fractions and 60 digits, on numbers of every size, NaN and
infinities among them.
"""

import itertools
import math
import operator
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from spragsym.numerics.interval_arrays import (
    TINY,
    Intervals,
    cos,
    length,
    sin,
    stacked,
    unit_vector,
)
from tests.support import fractions

NUMBERS = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    2.3e-308,
    1e-300,
    1e-160,
    -1e-10,
    0.1,
    1 / 3,
    1.0,
    np.nextafter(1, 2),
    -3.7,
    1e10,
    -1e155,
    1.7e308,
]
OPERATIONS = [operator.add, operator.sub, operator.mul, operator.truediv]


pytestmark = pytest.mark.usefixtures("silent")


def boxes(seed: int, count: int) -> Intervals:
    """Intervals between all pairs of the numbers above, and random ones of all sizes, some without
    width.
    """
    rng = np.random.default_rng(seed)
    pairs = np.array([(min(a, b), max(a, b)) for a, b in itertools.product(NUMBERS, NUMBERS)])
    values = rng.normal(size=(count, 2)) * 10.0 ** rng.integers(-30, 30, size=(count, 1))
    values[::3, 1] = values[::3, 0]
    values[1::3, 1] = values[1::3, 0] * (1 + 1e-15)
    both = np.concatenate([pairs, np.sort(values, axis=1)])
    return Intervals.between(both[:, 0], both[:, 1])


def holds(result: Intervals, row: int, value: Fraction) -> bool:
    """Whether the interval has the value, where an end that is NaN or infinite bounds nothing."""
    low, high = float(result.low[row]), float(result.high[row])
    return not (math.isfinite(low) and low > value) and not (math.isfinite(high) and high < value)


def members(x: Intervals | np.ndarray | float, row: int) -> list[Fraction]:
    if not isinstance(x, Intervals):
        return [Fraction(x[row]) if isinstance(x, np.ndarray) else Fraction(x)]
    low, high = Fraction(x.low[row]), Fraction(x.high[row])
    inner = [low, high, (low + high) / 2, low + (high - low) / 7]
    return inner + ([Fraction(0)] if low <= 0 <= high else [])


@pytest.mark.thorough
@pytest.mark.parametrize("operation", OPERATIONS)
def test_operations_hold_every_exact_result(operation):
    """Of two intervals, and of one and a number or an array, on either side."""
    x, y = (
        boxes(1, 300),
        boxes(2, 300)[np.random.default_rng(3).permutation(len(NUMBERS) ** 2 + 300)],
    )
    others = [3, -3, 1, -1, 0.1, -0.1, 0, np.linspace(-2, 2, x.shape[0])]
    for one, other in [
        (x, y),
        *((x, other) for other in others),
        *((other, x) for other in others),
    ]:
        if operation is operator.truediv and other is others[-2]:
            continue
        result = operation(one, other)
        for row in range(0, x.shape[0], 1 if other is y else 4):
            right = members(other, row)
            if (
                operation is operator.truediv
                and isinstance(other, Intervals)
                and (min(right) < 0 < max(right) or not any(right))
            ):
                assert np.isnan(result.ends[:, row]).all()
                continue
            for a, b in itertools.product(members(one, row), right):
                if (
                    b or operation is not operator.truediv
                ):  # a divisor that ends at 0 stands for its numbers other than 0
                    assert holds(result, row, operation(a, b)), (row, a, b)


@pytest.mark.parametrize("power", [0, 1, 2, 3, 4, 5, 7, -1, -2, -3])
def test_powers(power):
    x = boxes(4, 300)
    result = x**power
    for row in range(x.shape[0]):
        for a in members(x, row):
            if a or power >= 0:
                assert holds(result, row, a**power), (row, a)
    if power > 0 and power % 2 == 0:
        assert (result.low[np.isfinite(result.low)] >= 0).all()


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("sqrt", 0, 1e300),
        ("exp", -800, 700),
        ("sin", -4, 4),
        *(
            pytest.param(*one, marks=pytest.mark.thorough)
            for one in (
                ("cos", -9e4, 9e4),
                ("sin", -9e4, 9e4),
                ("cos", -4, 4),
                ("sin", -1e-9, 1e-9),
                ("log", 1e-6, 1e6),
                ("atan", -1e6, 1e6),
                ("tanh", -20, 20),
            )
        ),
    ],
)
def test_functions_against_sixty_digits(name, low, high):
    rng = np.random.default_rng(7)
    start = rng.uniform(low, high, 1500)
    widths = rng.choice([0.0, 1e-12, 1e-3, 0.7, 3.0, 10.0], 1500) * min(1.0, high)
    x = Intervals.between(start, np.minimum(start + widths, high))
    result = ({"cos": cos, "sin": sin}.get(name) or getattr(Intervals, name))(x)
    assert np.isfinite(result.low).all()
    with mpmath.workdps(60):
        for row in range(1500):
            for part in (0, 0.25, 0.5, 0.75, 1):
                a = min(x.low[row] + part * (x.high[row] - x.low[row]), x.high[row])
                value = getattr(mpmath, name)(mpmath.mpf(a))
                assert mpmath.mpf(float(result.low[row])) <= value, (row, a)
                assert not math.isfinite(result.high[row]) or value <= mpmath.mpf(
                    float(result.high[row])
                ), (row, a)
    narrow = x.width == x.width.min()
    assert (result.width[narrow] <= 1e-14 * np.maximum(1, result.magnitude[narrow])).all()


def test_waves_reach_their_extremes():
    turns = np.arange(-40, 40) * np.pi / 2
    for width in (1e-9, 1e-3, 0.5):
        around = Intervals.between(turns - width, turns + width)
        odd = np.arange(-40, 40) % 4
        assert (cos(around).high[odd == 0] == 1).all()
        assert (cos(around).low[odd == 2] == -1).all()
        assert (sin(around).high[odd == 1] == 1).all()
        assert (sin(around).low[odd == 3] == -1).all()
    beyond = cos(Intervals.between([1e6, np.nan, -np.inf], [1e6, 1.0, 0.0]))
    assert (beyond.low == -1).all()
    assert (beyond.high == 1).all()


def test_roots_and_unknown_ends_bound_nothing():
    assert np.isnan(Intervals.between([-1.0], [4.0]).sqrt().ends).all()
    assert Intervals.point([0.0]).sqrt().low == 0
    unknown = Intervals.between([np.nan, 1.0], [1.0, np.nan])
    assert not (unknown.low > -9e99)[0]
    assert not (unknown.high < 9e99)[1]
    assert (unknown * 0.5 + 1).holds_zero().tolist() == [True, False]
    assert (
        Intervals.between([1.0], [np.nan]).mignitude != 0.5
    )  # NaN, which no comparison takes for a bound
    product = Intervals.between([0.0], [0.0]) * Intervals.between([1.0], [np.inf])
    assert product.holds_zero().all()
    assert (Intervals.between([1e308], [1.7e308]) * 10).high == np.inf
    assert not (Intervals.between([1e308], [1.7e308]) * 10).low > 1e309


def test_directions_of_vectors_whose_squares_are_no_floats():
    sizes = np.array([1e-320, 1e-170, 1e-150, 1e150, 1e160, 1e300])
    c, s = unit_vector(Intervals.point(3 * sizes), Intervals.point(-4 * sizes))
    assert ((c.low <= 0.6) & (c.high >= 0.6)).all()
    assert ((s.low <= -0.8) & (s.high >= -0.8)).all()


@pytest.mark.thorough
def test_directions_are_sharp_and_hold_all():
    rng = np.random.default_rng(8)
    corner, size = rng.normal(size=(2, 400)), 10.0 ** rng.uniform(-8, 0.5, size=(2, 400))
    dx, dy = (Intervals.between(corner[i], corner[i] + size[i]) for i in (0, 1))
    c, s = unit_vector(dx, dy)
    l = length(dx, dy)
    best = np.full((2, 2, 400), -np.inf)
    with mpmath.workdps(40):
        for i, j in itertools.product(np.linspace(0, 1, 7), np.linspace(0, 1, 7)):
            x, y = (
                np.minimum(dx.low + i * size[0], dx.high),
                np.minimum(dy.low + j * size[1], dy.high),
            )
            for row in range(400):
                L = mpmath.sqrt(mpmath.mpf(x[row]) ** 2 + mpmath.mpf(y[row]) ** 2)
                for enclosure, value in ((c, x[row] / L), (s, y[row] / L), (l, L)):
                    assert (
                        mpmath.mpf(float(enclosure.low[row]))
                        <= value
                        <= mpmath.mpf(float(enclosure.high[row]))
                    )
            best[0] = np.maximum(best[0], np.stack([-x, x]) / np.hypot(x, y))
    # Grown towards the corners the hull is met where 0 is not between: no wider than the largest
    # and least value of a fine grid.
    clear = (dx.mignitude > 0) & (dy.mignitude > 0)
    assert (c.ends - best[0])[:, clear].max() < 1e-14
    everywhere = unit_vector(Intervals.between([-1.0], [1.0]), Intervals.between([-0.5], [0.5]))
    assert all((part.ends == 1).all() for part in everywhere)
    assert length(Intervals.point([0.0]), Intervals.point([0.0])).low == 0


def bad_pairs() -> list[tuple[float, float]]:
    """Pairs of which one operation or another is rounded by about half a unit, at powers of two,
    near 0 and near the largest.
    """
    rng = np.random.default_rng(10)
    ones = [
        sign * 2.0**power
        for sign in (1, -1)
        for power in (-1074, -1040, -1022, -1000, -500, -1, 0, 1, 500, 1000)
    ]
    near = [float(np.nextafter(one, toward)) for one in ones for toward in (-np.inf, np.inf)]
    halves = [(one, one * 2.0**-53 * part) for one in ones for part in (1, -0.5, 0.75, 1.5, -1)]
    pairs = list(itertools.product(ones[::3], near[::3])) + halves
    mantissas = rng.uniform(1, 2, (2, 200))
    powers = rng.choice([-1060.0, -1000.0, -540.0, -520.0, -3.0, 0.0, 2.0, 400.0], (2, 200))
    return pairs + list(zip(*(mantissas * 2.0**powers).tolist(), strict=True))


@pytest.mark.thorough
def test_bad_roundings_are_covered():
    """By each operation on numbers without width, whose exact result is a fraction."""
    a, b = np.array(bad_pairs()).T
    x, y = Intervals.point(a), Intervals.point(b)
    exact_a, exact_b = fractions(a), fractions(b)
    for row, one in enumerate(exact_a):
        assert holds(x.squared(), row, one * one)
    for operation, (left, right) in itertools.product(OPERATIONS, ((x, y), (x, b), (a, y))):
        result = operation(left, right)
        for row, (one, two) in enumerate(zip(exact_a, exact_b, strict=True)):
            value = operation(one, two) if two or operation is not operator.truediv else None
            assert value is None or holds(result, row, value), (operation, one, two)
            assert value is None or abs(value) > 1e300 or np.isfinite(result.ends[:, row]).all()
    for operation, number in itertools.product(
        OPERATIONS, (0.1, -0.1, 3, -3, 2.0**-53, 5e-324, 1 / 3)
    ):
        for some, reverse in ((operation(x, number), False), (operation(number, x), True)):
            for row in range(0, len(a), 3):
                one, two = (
                    (Fraction(number), exact_a[row])
                    if reverse
                    else (exact_a[row], Fraction(number))
                )
                assert holds(some, row, operation(one, two))


@pytest.mark.parametrize("power", [3, 5, 7, 9, 15, -3, -5])
def test_powers_of_bad_numbers(power):
    """Where every product rounds one way: found by a search among many."""
    rng = np.random.default_rng(power % 100)
    for size in (
        1.0,
        2.0**-1070,
        2.0 ** (-1074 // abs(power)),
        2.0 ** (-1022 // abs(power)),
        2.0**60,
    ):
        values = rng.uniform(-2, 2, 300) * size
        result = Intervals.point(values) ** power
        for row, value in enumerate(values):
            assert not value or holds(result, row, Fraction(float(value)) ** power)


def test_quotients_by_what_holds_zero():
    """Over [0, b] a positive interval has no upper end, over [−b, 0] no lower one; with 0 inside
    nothing is known.
    """
    over = Intervals.between([[0.0], [-4.0], [-1.0], [0.0]], [[4.0], [0.0], [1.0], [0.0]])
    result = Intervals.between([2.0, -3.0, -1.0], [6.0, -2.0, 8.0]) / over
    assert np.abs(result.low[0, 0] - 0.5) < 1e-14
    assert result.high[0, 0] == np.inf
    assert result.low[0, 1] == -np.inf
    assert np.abs(result.high[0, 1] + 0.5) < 1e-14
    assert result.ends[:, 0, 2].tolist() == [np.inf, np.inf]
    assert result.low[1, 0] == -np.inf
    assert np.abs(result.high[1, 0] + 0.5) < 1e-14
    assert np.abs(result.low[1, 1] - 0.5) < 1e-14
    assert result.high[1, 1] == np.inf
    assert np.isnan(result.ends[:, 2:]).all()
    zero = Intervals.point([0.0]) / Intervals.between([0.0], [2.0])
    assert max(zero.ends.max(), 0) <= TINY
    assert zero.holds_zero().all()


def test_what_is_no_number_is_refused():
    x = Intervals.point([1.0])
    for operation in (operator.add, operator.mul, operator.truediv):
        for one, other in ((x, "a"), ("a", x)):
            with pytest.raises(TypeError):
                operation(one, other)
    with pytest.raises(TypeError):
        x**0.5
    for operation in (operator.add, operator.mul, operator.truediv):
        with pytest.raises(ValueError, match="9007199254740993 is no float"):
            operation(x, 2**53 + 1)
    with pytest.raises(ValueError, match="is no float"):
        (2**53 + 1) / x
    with pytest.raises(ValueError, match="is no float"):
        stacked([2**53 + 1], (1,))
