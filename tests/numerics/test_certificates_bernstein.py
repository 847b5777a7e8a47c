"""Positive roots of many polynomials in float64: none missed, none doubled, each within its radius,
and open signs stay open.
"""

import itertools
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from spragsym.numerics import bernstein
from spragsym.numerics.affine import UNIT, Rounded
from spragsym.numerics.bernstein import Parts
from tests.support import fractions, with_roots


def rows(polynomials: list[tuple[Fraction, ...]]) -> list[Rounded]:
    """The same polynomials as floats, with what each coefficient is off by."""
    table = []
    for column in zip(*polynomials, strict=True):
        values = np.array([float(value) for value in column])
        errors = [float(abs(Fraction(float(value)) - value)) * (1 + 1e-9) for value in column]
        table.append(Rounded(values, np.array(errors)))
    return table


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 6])
def test_roots_are_all_there_and_within_their_radius(degree: int) -> None:
    """Rational roots of either sign, large, small, near 0, at the end of the scale, complex ones
    among them.
    """
    rng = np.random.default_rng(degree)
    truth, polynomials = [], []
    for k in range(150):
        size = Fraction(10) ** int(rng.choice([-3, 0, 0, 0, 3]))
        roots = [
            Fraction(int(value), 997) * size
            for value in rng.choice(np.arange(-4000, 9000), degree, replace=False)
        ]
        if k % 10 == 0:
            roots[0] = Fraction(bernstein.SCALE)
        polynomial = with_roots(*roots, lead=(-1) ** k)
        if k % 5 == 1 and degree > 1:  # two of them are complex: times 5 − 2 t + t²
            roots = roots[2:]
            padded = (0, 0, *with_roots(*roots), 0, 0)
            polynomial = tuple(
                5 * a - 2 * b + c for c, b, a in zip(padded, padded[1:], padded[2:], strict=False)
            )
        truth.append(sorted(root for root in roots if root > 0))
        polynomials.append(polynomial)
    found = bernstein.positive_roots(rows(polynomials), len(polynomials))
    # At the end of the scale the sign is open where the first cut is.
    assert np.delete(found.undecided, np.arange(0, 150, 10)).mean() < 0.03
    for i in np.flatnonzero(~found.undecided):
        mine = np.flatnonzero(found.row == i)
        mine = mine[np.argsort(found.t.value[mine])]
        assert mine.size == len(truth[i]), i
        for place, root in zip(mine, truth[i], strict=True):
            assert abs(Fraction(float(found.t.value[place])) - root) <= Fraction(
                float(found.t.error[place])
            ), i
            slope = sum(k * value * root ** (k - 1) for k, value in enumerate(polynomials[i]) if k)
            assert found.rising[place] == (1 if slope > 0 else -1)
    assert not set(found.row) & set(np.flatnonzero(found.undecided))


def test_whatever_the_coefficients_are_the_number_is_right() -> None:
    """Coefficients with errors of 10⁻³ and two roots as close as that: a row that is decided has
    that number for all of them.
    """
    rng = np.random.default_rng(9)
    size, error = 400, 1e-3
    gap = 10.0 ** rng.uniform(-4, -0.3, size)
    one = rng.uniform(0.5, 2, size)
    values = np.array(
        [
            np.polynomial.polynomial.polyfromroots([a, a + b, -1.0, 4.0])
            for a, b in zip(one, gap, strict=True)
        ]
    ).T
    found = bernstein.positive_roots(
        [Rounded(value, np.full(size, error)) for value in values], size
    )
    count = np.bincount(found.row, minlength=size)
    assert 0.2 < found.undecided.mean() < 0.9
    for i in np.flatnonzero(~found.undecided):
        for _ in range(6):
            given = values[:, i] + rng.choice([-1, 1], 5) * error
            roots = np.roots(given[::-1])
            real = np.sort(roots[(abs(roots.imag) < 1e-9) & (roots.real > 0)].real)
            assert count[i] == real.size
            mine = np.flatnonzero(found.row == i)
            mine = mine[np.argsort(found.t.value[mine])]
            assert (np.abs(found.t.value[mine] - real) <= found.t.error[mine] + 1e-9).all()


def test_what_is_not_finite_is_undecided() -> None:
    bad = [np.nan, np.inf, 1.0, 1.0]
    errors = [0.0, 0.0, np.inf, 0.0]
    with np.errstate(all="ignore"):
        found = bernstein.positive_roots(
            [Rounded(np.array(bad), np.array(errors)), Rounded(np.full(4, -1.0), np.zeros(4))], 4
        )
    assert found.undecided.tolist() == [True, True, True, False]
    assert found.row.tolist() == [3]
    assert abs(found.t.value[0] - 1) < 1e-14


def test_rows_are_scaled_each_for_itself() -> None:
    scales = 2.0 ** np.array([-900, -300, 0, 300, 900])
    given = [Rounded(value * scales, 0.0) for value in (6.0, -5.0, 1.0)]
    largest = np.abs(bernstein._bernstein_form(given, 5).value).max(axis=0)
    assert ((largest >= 0.5) & (largest < 1)).all()
    found = bernstein.positive_roots(given, 5)
    assert not found.undecided.any()
    order = np.lexsort((found.t.value, found.row))
    assert found.row[order].tolist() == [0, 0, 1, 1, 2, 2, 3, 3, 4, 4]
    assert np.abs(found.t.value[order] - np.tile([2.0, 3.0], 5)).max() < 1e-12
    nothing = bernstein.positive_roots([Rounded(np.zeros(2)), Rounded(np.zeros(2))], 2)
    assert nothing.undecided.all()


def parts(values: Any, errors: Any) -> Parts:
    value, error = np.array(values, dtype=float).T, np.array(errors, dtype=float).T
    size = value.shape[1]
    return Parts(np.arange(size), np.zeros(size), np.ones(size), value, error)


def test_signs_tell_no_root_or_one() -> None:
    """An open sign, 0, may be either: between two that differ it changes nothing, elsewhere nothing
    is told.
    """
    for signs, none, one in (
        ("++++", True, False),
        ("----", True, False),
        ("+---", False, True),
        ("--++", False, True),
        ("+-++", False, False),
        ("+0++", False, False),
        ("+0--", False, True),
        ("-0+", False, True),
        ("0+++", False, False),
        ("+++0", False, False),
        ("0---", False, False),
        ("++-0", False, False),
        ("0+--", False, False),
        ("+00-", False, False),
        ("+0-0", False, False),
        ("+-+-", False, False),
        ("+0-+", False, False),
        ("00", False, False),
        ("+-", False, True),
        ("++", True, False),
        ("0-", False, False),
        ("+0", False, False),
        ("-0-+", False, False),
        ("-+0+", False, False),
        ("+-0-", False, False),
    ):
        value = [[{"+": 1.0, "-": -1.0, "0": 0.5}[sign] for sign in signs]]
        found = bernstein._descartes(parts(value, [[0.5] * len(signs)]))
        assert [flags.tolist() for flags in found] == [[none], [one]], signs


def test_halves_hold_the_halves_of_every_polynomial() -> None:
    """De Casteljau's averages of the middles and of corners of the errors, exactly."""
    rng = np.random.default_rng(12)
    value = rng.uniform(-1, 1, (60, 7))
    error = np.abs(value) * rng.choice([0.0, 1e-17, 1e-9, 0.5], (60, 7))
    given = parts(value, error)
    halves = bernstein._bisected(given)
    assert halves.row.tolist() == [*range(60), *range(60)]
    assert halves.low.tolist() == [0.0] * 60 + [0.5] * 60
    assert halves.width.tolist() == [0.5] * 120
    again = bernstein._bisected(halves)
    assert again.low.tolist() == [0.0] * 60 + [0.5] * 60 + [0.25] * 60 + [0.75] * 60
    for i in range(60):
        for side in rng.choice([-1, 0, 1], (3, 7)):
            upper = [
                v + int(k) * e
                for v, e, k in zip(fractions(value[i]), fractions(error[i]), side, strict=True)
            ]
            lower = [upper[0]]
            for step in range(1, 7):
                upper[: 7 - step] = [(a + b) / 2 for a, b in itertools.pairwise(upper[: 8 - step])]
                lower.append(upper[0])
            for column, exact in ((i, lower), (60 + i, upper)):
                for k in range(7):
                    off = abs(Fraction(float(halves.value[k, column])) - exact[k])
                    assert off <= Fraction(float(halves.error[k, column]))
    assert (halves.error.max(axis=0) <= np.tile(error.max(axis=1), 2) * (1 + 1e-9) + 7 * UNIT).all()


def test_roots_at_places_where_parts_are_cut() -> None:
    """t = τ is w = 1/2, t = τ/3 is w = 1/4: the sign at the cut is 0, and no halving would give it
    one.
    """
    tau = Fraction(bernstein.SCALE)
    found = bernstein.positive_roots(
        rows([with_roots(root, 2, 5) for root in (tau, tau / 3, tau * 3)]), 3
    )
    for i in range(3):
        assert found.undecided[i] or (found.row == i).sum() == 3
    alone = bernstein.positive_roots(rows([with_roots(tau)]), 1)
    assert not alone.undecided.any()
    assert abs(alone.t.value[0] - float(tau)) <= alone.t.error[0]
