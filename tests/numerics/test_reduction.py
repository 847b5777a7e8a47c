"""Roots that lie close together, by reduction to one unknown; derivatives by jets; exponentials of
balls.
"""

from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest

from spragsym.numerics import balls
from spragsym.numerics.balls import Ball, ends
from spragsym.numerics.interval_arrays import Intervals
from spragsym.numerics.jets import variables
from spragsym.numerics.precise_roots import Digits, lies_in, narrowed, reduced_roots
from spragsym.statics.forces import direction
from spragsym.statics.namespaces import XP


def bent(roots):
    """y = x² − x and a product in x of the given roots, mixed, so that neither equation is one in x
    alone.
    """

    def evaluate(q):
        x, y = q
        product = 1
        for root in roots:
            product = product * (x - root)
        return [y - x**2 + x + product, product * 3 - (y - x**2 + x)]

    return evaluate


SINGULAR = np.array([[1.0, 1.0], [-1.0, -1.0]])
#: A box, a Jacobian and bits of a double root of x at 0.
DOUBLE = [(-1e-3, 1.1e-3), (-1e-5, 1e-5)], np.array([[0.0, 1.0], [0.0, 1.0]]), 200


@pytest.mark.thorough
@pytest.mark.parametrize("gap", [1e-3, 1e-8, 1e-12])
def test_three_close_roots(gap):
    roots = [0.1 - gap, 0.1, 0.1 + gap]
    exact = [Fraction(root) for root in roots]
    found = reduced_roots(bent(roots), [(0.098, 0.1021), (-0.1, -0.08)], SINGULAR, 200)
    assert not found.undecided
    assert len(found.roots) == 3
    for box, root in zip(sorted(found.roots), sorted(exact), strict=True):
        assert box[0][0] <= root <= box[0][1]
        assert box[0][1] - box[0][0] < Fraction(1, 10**16)
        assert box[1][0] <= root * root - root <= box[1][1]


@pytest.mark.parametrize("gap", [Fraction(1, 2), Fraction(1, 2**30)])
def test_one_unknown_is_all_there_is(gap):
    found = reduced_roots(
        lambda q: [q[0] ** 2 - float(gap**2)], [(-2 * float(gap), 1.0)], np.array([[0.0]]), 200
    )
    assert not found.undecided
    for (side,), root in zip(sorted(found.roots), (-gap, gap), strict=True):
        assert side[0] <= root <= side[1]
        assert side[1] - side[0] < Fraction(1, 10**16)


def test_two_complex_roots_are_none():
    def evaluate(q):
        x, y = q
        return [y - x**2, y + 1e-20]

    found = reduced_roots(evaluate, *DOUBLE)
    assert not found.undecided
    assert not found.roots


@pytest.mark.thorough
def test_a_double_root_is_left():
    def evaluate(q):
        x, y = q
        return [y - x**2, y * 1]

    found = reduced_roots(evaluate, *DOUBLE)
    assert not found.roots
    assert any(box[0][0] <= 0 <= box[0][1] for box in found.undecided)


def test_an_unknown_that_is_exactly_0_needs_no_more_digits_than_the_others():
    """Contracted to nothing by Newton's method, its exponents would double with every step."""
    seen = []

    def evaluate(q):
        seen.extend(-value.exp for value in q if isinstance(value, Ball))
        return [q[0] ** 3 - 1e-30 * q[0], q[1] + q[1] ** 2]

    found = reduced_roots(evaluate, [(-1e-3, 1.1e-3), (-1e-5, 1.3e-5)], np.diag([0.0, 1.0]), 200)
    assert len(found.roots) == 3
    assert max(seen) < 10_000


def test_jets_have_the_derivatives_of_their_functions():
    at = {"x": 0.7, "y": -0.4}

    def function(x, y, sqrt, exp):
        return sqrt(x + y**2) * exp(x * y) / (1 + x**3) - x**-2

    got = function(
        *variables([Intervals.point([value]) for value in at.values()], 3), XP.sqrt, XP.exp
    )
    with mp.workdps(40):
        for order in [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)]:
            want = mp.diff(
                lambda x, y: function(x, y, mp.sqrt, mp.exp), tuple(map(mp.mpf, at.values())), order
            )
            enclosure = got.derivative(*[0] * order[0], *[1] * order[1])
            assert enclosure.low[0] <= want <= enclosure.high[0], order
            assert enclosure.width[0] < 1e-11


@pytest.mark.parametrize("number", [Ball(1, 0, -1, 80), Intervals.point(np.full(1, 0.5))])
def test_quotients_of_integers_among_coefficients_are_enclosed(number):
    """Also of a 1 that has the shape of what it is made of, as in generated code."""
    (x,) = variables([number], 2)
    for quotient in ((43 * x / 10).derivative(0), (43 * (0 * x + 1) / 10).value):
        low, high = (
            ends(quotient)
            if isinstance(quotient, Ball)
            else map(Fraction, (quotient.low.item(), quotient.high.item()))
        )
        assert low < Fraction(43, 10) < high
        assert high - low < Fraction(1, 10**14)


def test_a_double_root_by_a_slope_that_is_no_float_is_left():
    """x = 1/3 of (9 y − 1) (3 x − 1) = 0 with y = x/3."""
    found = reduced_roots(
        lambda q: [3 * q[1] - q[0], (9 * q[1] - 1) * (3 * q[0] - 1)],
        [(0.3, 0.4), (0.1, 0.14)],
        np.array([[-1.0, 3.0], [0.0, 0.0]]),
        200,
    )
    assert found.roots == []
    assert any(low <= Fraction(1, 3) <= high for (low, high), _ in found.undecided)


def test_roots_of_jets_have_all_of_their_terms():
    """Also beyond the fourth; of a spring's direction too."""
    x, y = variables([Intervals.point([0.7]), Intervals.point([-0.4])], 7)
    root, (c, s, length) = XP.sqrt(x), direction(x, y, (1,))
    with mp.workdps(60):
        for order in range(8):
            wanted = (
                mp.diff(mp.sqrt, mp.mpf(0.7), order),
                *(
                    mp.diff(function, mp.mpf(0.7), order)
                    for function in (
                        lambda t: t / mp.hypot(t, mp.mpf(-0.4)),
                        lambda t: -mp.mpf(0.4) / mp.hypot(t, mp.mpf(-0.4)),
                        lambda t: mp.hypot(t, mp.mpf(-0.4)),
                    )
                ),
            )
            for jet, want in zip((root, c, s, length), wanted, strict=True):
                enclosure = jet.derivative(*[0] * order) if order else jet.value
                assert enclosure.low[0] - 1e-12 <= want <= enclosure.high[0] + 1e-12
                assert enclosure.width[0] < 1e-6 * max(1, abs(want))


class Exponential(Digits):
    """exp(x) = 1."""

    bits = 200

    def equations(self, unknowns):
        (x,) = unknowns
        return [balls.XP.exp(x) - 1]


def test_a_box_without_a_root_ends_the_iteration():
    """From x = −50 Newton's method steps to exp(50), of which no computer holds the exponential."""
    (root,) = narrowed(Exponential(), np.array([[0.125], [0.25]]), None)
    assert lies_in([root], np.full((2, 1), 1e-40))
    assert narrowed(Exponential(), np.array([[50.5], [-49.5]]), None) is None
