"""The curves of folds against the folds that are proved, at friction coefficients and angles between their points."""

from __future__ import annotations

import itertools
import math
from collections import deque
from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss
from spragsym.catastrophe import fold_curves, fold_proofs
from spragsym.catastrophe.fixed import Fixed
from spragsym.exact import intervals
from spragsym.generated import catastrophe as generated

#: κ, α, σ, β: the article's, some where curves begin at θ₀ = 0 or π, close on themselves, or have a cusp at an end; α = 0.
SETS = list(map(Fixed._make, [
    (0.007, 0.007, 0.1, 0.0), (0.007, 0.007, 1.0, 0.0), (0.007, 0.0, 0.1, 0.0), (0.05, 0.3, 2.0, 0.2), (0.002, 0.05, 0.5, 1.0),
    (0.01, 0.0, 1.5, 0.3), (0.3, 0.1, 3.0, 0.0), (0.5499, 0.8771, 0.022509, 4.455), (0.02, 1.0, 0.4, 0.0),
    (0.195, 0.5261, 0.8677, 0.0), (0.006083, 0.0, 0.006177, 19.34), (0.07477, 0.37, 1.612, 0.0), (0.0397, 2.121, 0.1677, 0.0),
]))  # fmt: skip


@pytest.fixture(autouse=True)
def _quiet() -> object:
    with np.errstate(all="ignore"):
        yield


@pytest.fixture(scope="module", params=SETS, ids=str)
def fixed(request: pytest.FixtureRequest) -> Fixed:
    return request.param


def _strands(fixed: Fixed) -> list[fold_curves.Strand]:
    return fold_curves.strands(fixed, 1200)


def test_every_point_is_a_fold(fixed: Fixed) -> None:
    kappa, alpha, sigma, beta = fixed
    for strand in _strands(fixed):
        assert strand.theta.shape == strand.theta0.shape == strand.mu0.shape
        assert strand.theta.size > 1
        assert np.isfinite([strand.theta, strand.theta0, strand.mu0]).all()
        assert (strand.mu0 >= 0).all()
        inside = (strand.theta0 > 1e-6) & (strand.theta0 < math.pi - 1e-6) & (strand.mu0 < 1e3)
        s, c, s0, c0 = np.sin(strand.theta), np.cos(strand.theta), np.sin(strand.theta0), np.cos(strand.theta0)
        mu0, q, p = strand.mu0, beta + 1 + sigma, alpha + sigma
        a, b = sigma * (q - p), -p * ((beta + 1) * s0 + kappa)
        d, m = q * alpha * c0 + mu0 * (sigma * s0 - kappa), mu0 * sigma
        size = abs(a) + abs(b) + abs(d) + abs(m) + 1e-9
        assert (np.abs(a * s * c + b * c + d * s - m * s * s)[inside] < 1e-9 * size[inside]).all()
        assert (np.abs(a * (c * c - s * s) - b * s + d * c - 2 * m * s * c)[inside] < 1e-7 * size[inside]).all()


def _crossings(strands: list[fold_curves.Strand], mu0: float, fixed: Fixed) -> list[float]:
    """Angles θ₀ at which the curves pass a friction coefficient, in contact with L > 0."""
    kappa, _, sigma, beta = fixed
    found = []
    for strand in strands:
        side = strand.mu0 - mu0
        for i in np.flatnonzero(side[1:] * side[:-1] < 0):
            share = side[i] / (side[i] - side[i + 1])
            theta, theta0 = (float(v[i] + share * (v[i + 1] - v[i])) for v in (strand.theta, strand.theta0))
            if sigma * (math.sin(theta0) - math.sin(theta)) < kappa:  # y < 0; with sin θ > 0 always L > 0
                found.append(theta0)
    return sorted(found)


def test_no_curve_is_missed_or_twice(fixed: Fixed) -> None:
    """Between the points of the curves, all folds in θ₀ that Sturm's count proves at some friction are crossed, and no others."""
    arith, strands = intervals.arithmetic(), _strands(fixed)
    for mu0 in ("0.0511", "0.3217", "0.777", "1.913"):
        exact = dict(zip(("kappa", "alpha", "sigma", "beta"), map(Fraction, fixed), strict=True)) | {"mu0": Fraction(mu0)}
        with arith.precision(256):
            points = [fold.point for fold in fold_proofs.folds(arith, "theta0", exact, 256)]
            angles = [sum(map(float, arith.ends(point.parameters[0]))) / 2 for point in points]
        proved = sorted(angle for angle in angles if 0 < angle < math.pi)
        crossed = _crossings(strands, float(mu0), fixed)
        assert len(crossed) == len(proved)
        np.testing.assert_allclose(crossed, proved, atol=5e-3)


def test_curves_end_where_they_must_and_step_smoothly(fixed: Fixed) -> None:
    """At θ₀ = 0 or π, at μ₀ = 0, far up, or nowhere; and no step is long."""
    for strand in _strands(fixed):
        closed = abs(strand.theta0[0] - strand.theta0[-1]) < 1e-9 and abs(strand.mu0[0] - strand.mu0[-1]) < 1e-9
        for end in (0, -1):
            at_angle = min(strand.theta0[end], math.pi - strand.theta0[end]) < 1e-6
            assert closed or at_angle or strand.mu0[end] < 1e-9 or strand.mu0[end] > 10
        shown = strand.mu0 < 3
        steps = np.hypot(np.diff(strand.theta0) / math.pi, np.diff(strand.mu0 / (1 + strand.mu0)))[shown[1:] & shown[:-1]]
        assert steps.size == 0 or steps.max() < 0.03


def test_roots_at_a_direction_are_all_and_in_order() -> None:
    """Against numpy's roots of the quartic in tan(θ₀/2), made from the relations by evaluation."""
    rng = np.random.default_rng(61)
    for fixed in SETS:
        theta = rng.uniform(0.05, math.pi / 2, 60)
        values, number = fold_curves.positive_roots(theta, fixed)
        for row, angle in enumerate(theta):
            e0, e1, e2, ec = (float(value) for value in generated.fold_conic(np.cos(angle), np.sin(angle), *fixed))
            v = np.arange(-2, 3)
            height = (e0 + ec * (1 - v * v) / (1 + v * v)) * (1 + v * v) ** 2 + e1 * 2 * v * (1 + v * v) + e2 * 4 * v * v
            roots = np.roots(np.polyfit(v, height, 4)) if fixed[1] else _sines(e0, e1, e2)
            clear = np.abs(roots.imag) / np.abs(roots)
            if ((clear > 1e-9) & (clear < 1e-4)).any():
                continue
            real = np.sort(roots.real[(clear < 1e-9) & (roots.real > 1e-9) & (roots.real < (1e9 if fixed[1] else 1))])
            assert number[row] == real.size
            np.testing.assert_allclose(values[row, : real.size], real, rtol=1e-6)
            assert np.isnan(values[row, real.size :]).all()


def _sines(e0: float, e1: float, e2: float) -> np.ndarray:
    """tan(θ₀/2) of the sines that solve the quadratic, for α = 0."""
    sines = np.roots([e2, e1, e0])
    good = (np.abs(sines.imag) == 0) & (sines.real > 0) & (sines.real < 1)
    return np.tan(np.arcsin(sines.real[good]) / 2).astype(complex)


def test_the_number_of_real_roots_of_quartics() -> None:
    rng = np.random.default_rng(62)
    for _ in range(300):
        real = rng.integers(0, 3) * 2
        roots = [complex(value) for value in rng.normal(0, 2, real)]
        for _ in range((4 - real) // 2):
            pair = complex(rng.normal(0, 2), rng.uniform(0.2, 2))
            roots += [pair, pair.conjugate()]
        coefficients = np.poly(roots).real[::-1] * rng.choice([-3, 0.5, 0.01])
        value, number = fold_curves.discriminant(coefficients)
        assert number == real
        gaps = math.prod(one - two for one, two in itertools.combinations(roots, 2))
        assert math.copysign(1, value) == math.copysign(1, (gaps * gaps).real)
        assert -1 <= value <= 1
        P = coefficients[0] * coefficients[4] * 12 - 3 * coefficients[1] * coefficients[3] + coefficients[2] ** 2
        assert P >= 0 or value == pytest.approx(-1, abs=1e-12)


def test_quartics_are_the_conic_in_the_half_angle() -> None:
    """A positive multiple, the largest coefficient of size 1; for arrays of any shape."""
    theta = np.random.default_rng(64).uniform(0.05, math.pi / 2, (7, 3))
    for fixed in SETS:
        found = fold_curves.quartics(theta, fixed)
        assert found.shape == (7, 3, 5)
        np.testing.assert_allclose(np.abs(found).max(axis=-1), 1, rtol=1e-15)
        e0, e1, e2, ec = generated.fold_conic(np.cos(theta), np.sin(theta), *fixed)
        for angle in (0.3, 1.0, 2.0, 2.9):
            v, height = math.tan(angle / 2), e0 + e1 * math.sin(angle) + e2 * math.sin(angle) ** 2 + ec * math.cos(angle)
            ratio = height * (1 + v * v) ** 2 / sum(found[..., k] * v**k for k in range(5))
            largest = np.abs(np.stack([e0 + ec, 2 * e1, 4 * e2 + 2 * e0, e0 - ec])).max(axis=0)
            np.testing.assert_allclose(ratio, largest, rtol=1e-9)


def test_the_indicators_sign_is_that_of_the_number_of_real_roots() -> None:
    theta = np.random.default_rng(65).uniform(0.05, math.pi / 2, 300)
    for fixed in SETS:
        value = fold_curves.indicator(theta, fixed)
        if fixed.alpha:
            real = [(np.abs(np.roots(row[::-1]).imag) < 1e-7 * np.abs(np.roots(row[::-1]))).sum() for row in
                    fold_curves.quartics(theta, fixed)]  # fmt: skip
            clear = np.abs(value) > 1e-6
            np.testing.assert_array_equal((value < 0)[clear], (np.array(real) == 2)[clear])
            continue
        e0, e1, e2, _ = generated.fold_conic(np.cos(theta), np.sin(theta), *fixed)
        with np.errstate(all="ignore"):
            share = e1 * e1 / (4 * e0 * e2)
        np.testing.assert_allclose(value, np.where(share < 0, -1, (1 - share) / (1 + share)), rtol=1e-9, atol=1e-12)


def test_without_alpha_the_indicator_is_the_discriminant_over_its_own_terms(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of e0 + e1 sin θ₀ + e2 sin² θ₀, with the sign that is negative where two sines are real; all of it where e0 e2 < 0."""
    for e0, e1, e2, wanted in ((-2, 1, 3, -1.0), (2, 1, -3, -1.0), (2, 1, 3, 23 / 25), (1, -4, 1, -12 / 20), (1, 2, 1, 0.0)):
        monkeypatch.setattr(fold_curves, "_conic", lambda *_, e=(e0, e1, e2, 0): tuple(np.full(2, float(value)) for value in e))
        found = fold_curves.indicator(np.array([0.5, 0.6]), Fixed(1.0, 0.0, 1.0, 1.0))
        np.testing.assert_allclose(found, wanted, rtol=1e-15)


def test_without_alpha_a_root_ends_at_a_sine_of_0_or_1() -> None:
    """The two end values are the conic there: of the sines that solve it, their product says so from both sides."""
    theta = np.random.default_rng(66).uniform(0.05, math.pi / 2, 40)
    for fixed in (one for one in SETS if not one.alpha):
        at_0, at_1, end = fold_curves._ends(theta, fixed)
        assert end == 1.0
        for row, angle in enumerate(theta):
            e0, e1, e2, _ = (float(value) for value in generated.fold_conic(np.cos(angle), np.sin(angle), *fixed))
            sines = np.roots([e2, e1, e0])
            np.testing.assert_allclose(
                [at_0[row], at_1[row]], [e2 * np.prod(sines).real, e2 * np.prod(1 - sines).real], rtol=1e-6
            )


def test_without_alpha_curves_lie_on_either_side_alike_and_friction_is_positive() -> None:
    """A fold at θ₀ is one at π − θ₀; none with cos θ > 0 has a negative friction, in contact or not."""
    rng = np.random.default_rng(67)
    for fixed in [one for one in SETS if not one.alpha]:
        found = _strands(fixed)
        theta, theta0 = (np.concatenate([getattr(strand, name) for strand in found]) for name in ("theta", "theta0"))
        there, mirrored = np.lexsort((theta0, theta)), np.lexsort((np.pi - theta0, theta))
        np.testing.assert_allclose(theta0[there], (np.pi - theta0)[mirrored], rtol=0, atol=1e-12)
    for _ in range(40):
        fixed = Fixed(10 ** rng.uniform(-4, 1), 0.0, 10 ** rng.uniform(-3, 1.5), rng.choice([0, 10 ** rng.uniform(-2, 1.5)]))
        theta = rng.uniform(0.01, math.pi / 2 - 1e-3, 50)
        roots, _ = fold_curves.positive_roots(theta, fixed)
        mu0 = fold_curves.friction(theta[:, None], 2 * np.arctan(roots), fixed)
        assert not (mu0 < 0).any()


@pytest.mark.parametrize(
    ("sines", "kept"), [((-0.5, 0.5), [0.5]), ((0.0, 0.5), [0.5]), ((1.0, 0.5), [0.5]), ((0.2, 0.7), [0.2, 0.7]),
                        ((1e-13, 0.9), [1e-13, 0.9]), ((-0.1, 2.0), []), ((-1e-13, 0.9), [0.9])],
)  # fmt: skip
@pytest.mark.parametrize("sign", [1, -2])
def test_sines_between_0_and_1_are_kept(
    monkeypatch: pytest.MonkeyPatch, sines: tuple[float, float], kept: list[float], sign: int
) -> None:
    """Without α, to all digits of the smaller one too."""
    one, two = sines
    conic = tuple(np.full(2, sign * value) for value in (one * two, -one - two, 1.0, 0.0))
    monkeypatch.setattr(fold_curves, "_conic", lambda *_: conic)
    values, number = fold_curves.positive_roots(np.array([0.5, 0.6]), Fixed(1.0, 0.0, 1.0, 1.0))
    assert number.tolist() == [len(kept)] * 2
    for row in values:
        np.testing.assert_allclose(row[: len(kept)], np.tan(0.5 * np.arcsin(kept)), rtol=1e-12)
        assert np.isnan(row[len(kept) :]).all()


def test_a_root_at_0_is_not_positive(monkeypatch: pytest.MonkeyPatch) -> None:
    """Roots −1, 0, 1 and 2 in one row, −3, −1, 1/2 and 4 in the other."""
    rows = np.array([np.poly([-1, 0, 1, 2])[::-1], np.poly([-3, -1, 0.5, 4])[::-1]])
    monkeypatch.setattr(fold_curves, "quartics", lambda *_: rows / np.abs(rows).max(axis=-1, keepdims=True))
    values, number = fold_curves.positive_roots(np.array([0.5, 0.6]), FAMILY)
    assert number.tolist() == [2, 2]
    np.testing.assert_allclose(values[:, :2], [[1, 2], [0.5, 4]], rtol=1e-13)
    assert np.isnan(values[:, 2:]).all()


@pytest.mark.parametrize(
    ("roots", "real", "wanted"),
    [
        # A real pair that rounding split is far out: its imaginary part is the larger one, over its size the smaller one.
        ([1e6 + 1e-2j, 1e6 - 1e-2j, 1e-3 + 1e-3j, 1e-3 - 1e-3j], 2, [1e6, 1e6]),
        ([1e-3 + 1e-3j, 1e6 - 1e-2j, 1e-3 - 1e-3j, 1e6 + 1e-2j], 2, [1e6, 1e6]),
        ([1e-6 + 1e-9j, 1e-6 - 1e-9j, 1e-9 + 5e-10j, 1e-9 - 5e-10j], 2, [1e-6, 1e-6]),
        # 0 is real, and takes a place.
        ([0.0, 2.0, 3.0 + 1j, 3.0 - 1j], 2, [2.0]),
        ([3.0 + 1j, 3.0 - 1j, 0.0, 2.0], 2, [2.0]),
        ([3.0 + 1j, 3.0 - 1j, 2.0, 1.0], 0, []),
        ([2.0, 1.0, -3.0 + 1j, -3.0 - 1j], 2, [1.0, 2.0]),
        ([-3.0 + 1j, -3.0 - 1j, 2.0, 1.0], 2, [1.0, 2.0]),
    ],
)
def test_as_many_roots_as_are_real_are_kept(
    monkeypatch: pytest.MonkeyPatch, roots: list[complex], real: int, wanted: list[float]
) -> None:
    """Those closest to the real axis for their size, whatever the order in which they come."""
    monkeypatch.setattr(fold_curves, "eigenvalues", lambda _: np.array([roots, roots], dtype=complex))
    monkeypatch.setattr(fold_curves, "discriminant", lambda _: (np.zeros(2), np.full(2, real)))
    monkeypatch.setattr(fold_curves, "polished", lambda _, values: values)
    values, number = fold_curves.positive_roots(np.array([0.5, 0.6]), FAMILY)
    assert number.tolist() == [len(wanted)] * 2
    for row in values:
        np.testing.assert_array_equal(row, [*wanted, *[math.nan] * (4 - len(wanted))])


def test_linear_critical_friction_has_the_shape_of_its_parameters() -> None:
    one = ss.linear_critical_friction(ss.Parameters.article())
    assert type(one) is float
    assert one == pytest.approx(math.sqrt(4 * 0.007 * 0.107 * 1.1 / 0.01))
    many = ss.linear_critical_friction(ss.Parameters.article(alpha=[0.0, 0.007], beta=[[0.0], [1.0], [2.0]]))
    assert many.shape == (3, 2)
    assert many[0, 1] == one
    assert (many[:, 0] == 0).all()
    assert many[2, 1] == pytest.approx(math.sqrt(4 * 0.007 * 0.107 * 3 * 3.1 / 0.01))


# ------------------------------------------------------------------------------------ tracing families that are known
#
# Roots v at given θ of curves drawn by hand, which never cross: what is traced must be those curves, whatever the grid.

#: Circles (θ, v, radius) one in the other, and beside them.
CIRCLES = ((0.8, 1.5, 0.3), (0.8, 1.5, 0.5), (0.55, 0.45, 0.2))
#: A line comes in at v = 0, another one leaves at the other end.
ENTERS, LEAVES = 0.45, 1.12
FAMILY = Fixed(1.0, 1.0, 1.0, 1.0)


def _padded(rows: list[list[float]]) -> tuple[np.ndarray, np.ndarray]:
    number = np.array([len(row) for row in rows])
    return np.array([row + [math.nan] * (8 - len(row)) for row in rows]), number


def _circles_and_lines(theta: np.ndarray, end: float) -> tuple[np.ndarray, np.ndarray]:
    rows = []
    for angle in theta:
        row = [v + way * math.sqrt(r * r - (angle - at) ** 2) for at, v, r in CIRCLES for way in (-1, 1) if abs(angle - at) < r]
        row = [v * min(1.0, end / 4) for v in row]
        if angle > ENTERS:
            row.append(0.1 * (angle - ENTERS) * min(1.0, end / 4))
        if angle < LEAVES:
            row.append(3 + 0.5 / (LEAVES - angle) if end == math.inf else 0.7 + 0.3 * angle / LEAVES)
        rows.append(sorted(row))
    return _padded(rows)


@pytest.mark.parametrize("told", [True, False], ids=["indicator", "bisection"])
@pytest.mark.parametrize("end", [math.inf, 1.0])
def test_circles_and_lines_are_traced_whatever_the_grid(monkeypatch: pytest.MonkeyPatch, told: bool, end: float) -> None:
    monkeypatch.setattr(fold_curves, "positive_roots", lambda theta, _: _circles_and_lines(theta, end))
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (theta - ENTERS, LEAVES - theta, end))

    def product(theta, _):
        return np.prod([r * r - (theta - at) ** 2 for at, _, r in CIRCLES], axis=0)

    monkeypatch.setattr(fold_curves, "indicator", product if told else lambda theta, _: np.ones_like(theta))
    births = sorted([ENTERS, LEAVES, *(at + way * r for at, _, r in CIRCLES for way in (-1, 1))])
    scale, tried = min(1.0, end / 4), 0
    for n, shift in itertools.product((7, 16, 33, 60, 121), (0.0, 0.013)):
        theta = np.linspace(0.1 + shift, 1.5, n)
        _, number = _circles_and_lines(theta, end)
        hidden = [bool(np.searchsorted(births, high) - np.searchsorted(births, low)) for low, high in itertools.pairwise(theta)]
        if (np.array(hidden) & (np.diff(number) == 0)).any():
            continue
        tried += 1
        strands = fold_curves._trace(theta, FAMILY)
        assert len(strands) == 5
        grown = sum(strand.theta.size for strand in strands)
        assert grown == number.sum() + 2 + sum(3 for _ in CIRCLES)  # both ends of lines; of a circle two, and one twice
        cell = theta[1] - theta[0]
        for strand in strands:
            v = np.tan(strand.theta0 / 2) / scale
            closed = strand.theta[0] == strand.theta[-1] and strand.theta0[0] == strand.theta0[-1]
            assert np.abs(np.diff(strand.theta)).max() <= cell * (1 + 1e-9)
            if closed:
                off = [np.abs((strand.theta - at) ** 2 + (v - y) ** 2 - r * r).max() for at, y, r in CIRCLES]
                assert min(off) < 1e-6
                turn = np.unwrap(np.arctan2(v - CIRCLES[np.argmin(off)][1], strand.theta - CIRCLES[np.argmin(off)][0]))
                assert abs(abs(turn[-1] - turn[0]) - 2 * math.pi) < 1e-6
                assert (np.diff(turn) * (turn[-1] - turn[0]) > 0).all()
                at, _, r = CIRCLES[np.argmin(off)]
                assert abs(strand.theta.min() - (at - r)) < 1e-9
                assert abs(strand.theta.max() - (at + r)) < 1e-9
            elif v[0] < 1e-9:
                assert strand.theta[0] == pytest.approx(ENTERS, abs=1e-12)
                np.testing.assert_allclose(v, 0.1 * (strand.theta - ENTERS), atol=1e-12)
                assert strand.theta[-1] == 1.5
            else:
                assert strand.theta[0] == theta[0]
                assert strand.theta[-1] == pytest.approx(LEAVES, abs=1e-12)
                assert strand.theta0[-1] == 2 * math.atan(end)
    assert tried >= 4


@pytest.mark.parametrize("enters", [0.41, 0.45, 0.49, 0.55])
@pytest.mark.parametrize("leaves", [0.42, 0.47, 0.5, 0.58])
@pytest.mark.parametrize("born", [0.43, 0.48, 0.53, 2.0])
def test_events_that_share_a_cell_are_told_apart(
    monkeypatch: pytest.MonkeyPatch, enters: float, leaves: float, born: float
) -> None:
    """A line comes in, another one leaves, a pair is born, in any order, between two values of θ or two cells of them."""

    def roots(theta: np.ndarray, _: object = None) -> tuple[np.ndarray, np.ndarray]:
        rows = []
        for angle in theta:
            row = [0.1 * (angle - enters)] if angle > enters else []
            row += [2 + way * math.sqrt(angle - born) for way in (-1, 1)] if angle > born else []
            rows.append(row + ([5 + 0.1 / (leaves - angle)] if angle < leaves else []))
        return _padded(rows)

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (theta - enters, leaves - theta, math.inf))
    monkeypatch.setattr(fold_curves, "indicator", lambda theta, _: theta - born)
    events = sorted({enters, leaves} | {born} - {2.0})
    for inner in ([], [0.46], events, events[:1], events[-1:]):  # the last ones with events exactly at an angle of the grid
        theta = np.array([0.1, 0.4, *inner, 0.6, 0.9])
        strands = sorted(fold_curves._trace(theta, FAMILY), key=lambda strand: strand.theta0.max())
        assert len(strands) == 2 + (born < 1)
        first, *pair, last = strands
        np.testing.assert_allclose(np.tan(first.theta0 / 2), 0.1 * (first.theta - enters), atol=1e-12)
        assert first.theta[[0, -1]] == pytest.approx([enters, 0.9], abs=1e-12)
        assert last.theta[[0, -1]] == pytest.approx([0.1, leaves], abs=1e-12)
        for strand in pair:
            v = np.tan(strand.theta0 / 2)
            np.testing.assert_allclose((v - 2) ** 2, strand.theta - born, atol=1e-9)
            assert (np.diff(v) > 0).all() or (np.diff(v) < 0).all()
            assert strand.theta[[0, -1]].tolist() == [0.9, 0.9]


@pytest.mark.parametrize("leaves", [0.5, 0.55])
def test_a_root_that_leaves_at_an_angle_of_the_grid_leaves_at_its_end(monkeypatch: pytest.MonkeyPatch, leaves: float) -> None:
    """At v = 0, below another one that stays."""

    def roots(theta, _=None):
        return _padded([[0.1 * (leaves - t), 3.0] if t < leaves else [3.0] for t in theta])

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (leaves - theta, 1 + 0 * theta, math.inf))
    monkeypatch.setattr(fold_curves, "indicator", lambda theta, _: np.ones_like(theta))
    theta = np.array([0.3, 0.4, 0.5, 0.6])
    first, second = sorted(fold_curves._trace(theta, FAMILY), key=lambda strand: strand.theta0.max())
    np.testing.assert_allclose(np.tan(first.theta0 / 2), 0.1 * (leaves - first.theta), atol=1e-12)
    assert first.theta[-1] == pytest.approx(leaves, abs=1e-12)
    assert second.theta.tolist() == theta.tolist()


def test_a_root_that_comes_in_unannounced_is_followed_from_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where rounding hides the change of sign of the end values, numbers of roots decide."""

    def roots(theta, _=None):
        return _padded([[0.1 * (angle - ENTERS)] if angle > ENTERS else [] for angle in theta])

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (1e-9 + 0 * theta, 1e-9 + 0 * theta, math.inf))
    monkeypatch.setattr(fold_curves, "indicator", lambda theta, _: np.ones_like(theta))
    for theta in (np.linspace(0.1, 1.5, 29), np.linspace(1.5, 0.1, 29)[::-1]):
        [strand] = fold_curves._trace(theta, FAMILY)
        assert strand.theta[0] == pytest.approx(ENTERS, abs=1e-12)
        assert strand.theta[1:].tolist() == theta[theta > ENTERS].tolist()


@pytest.mark.parametrize("below", [0, 1, 2])
def test_nothing_is_joined_where_there_are_no_two_curves(monkeypatch: pytest.MonkeyPatch, below: int) -> None:
    """As where rounding took one of them before."""
    row = [0.1 * k for k in range(1, below + 1)]

    def roots(theta, _=None):
        return _padded([[*row, *([2 - (0.7 - t), 2 + (0.7 - t)] if t < 0.7 else [])] for t in theta])

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "indicator", lambda theta, _: theta - 0.7)
    for number in range(below + 2):
        curves = [(deque([np.zeros((2, 1))]), True) for _ in range(number)]
        assert fold_curves._pair(0.6, 0.8, below + 2, FAMILY, curves, [], born=False) == curves


def test_a_pair_far_out_vanishes_beside_two_roots_close_to_0(monkeypatch: pytest.MonkeyPatch) -> None:
    def roots(theta: np.ndarray, _: object = None) -> tuple[np.ndarray, np.ndarray]:
        pairs = [[1e3 * (1 + way * math.sqrt(0.7 - t)) for way in (-1, 1)] if t < 0.7 else [] for t in theta]
        return _padded([[1e-4, 2e-4, *pair] for pair in pairs])

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "indicator", lambda theta, _: theta - 0.7)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (1 + 0 * theta, 1 + 0 * theta, math.inf))
    ends = sorted(np.tan(strand.theta0[0] / 2) for strand in fold_curves._trace(np.linspace(0.1, 1.5, 29), FAMILY))
    assert len(ends) == 3
    np.testing.assert_allclose(ends[:2], [1e-4, 2e-4])
    assert ends[2] > 100


#: θ(v) = T₅(v − 2) with a tilt: one curve, of which one to five pass a θ; up, and down.
_WAVE = np.polynomial.Chebyshev([0.75, 0.05, 0, 0, 0, 0.35], domain=[1, 3]).convert(kind=np.polynomial.Polynomial)


@pytest.mark.parametrize("told", [True, False], ids=["indicator", "bisection"])
@pytest.mark.parametrize("way", [1, -1])
def test_one_curve_with_many_folds_is_traced_as_one(monkeypatch: pytest.MonkeyPatch, told: bool, way: int) -> None:
    def wave(v: np.ndarray) -> np.ndarray:
        return 0.75 + way * (_WAVE(v) - 0.75)

    def roots(theta: np.ndarray, _: object = None) -> tuple[np.ndarray, np.ndarray]:
        found = [(_WAVE - (0.75 + way * (angle - 0.75))).roots() for angle in theta]
        return _padded([sorted(one.real[(np.abs(one.imag) < 1e-12) & (one.real > 0)].tolist()) for one in found])

    turns = _WAVE.deriv().roots().real
    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    monkeypatch.setattr(fold_curves, "_ends", lambda theta, _: (1 + 0 * theta, 1 + 0 * theta, math.inf))

    def product(theta, _):
        return np.prod([theta - wave(turn) for turn in turns], axis=0)

    monkeypatch.setattr(fold_curves, "indicator", product if told else lambda theta, _: np.ones_like(theta))
    for n in (9, 24, 90):
        for begin, end, pieces in ((0.02, 1.48, 1), (0.02, 0.75, None), (0.75, 1.48, None)):
            theta = np.linspace(begin, end, n)
            _, number = roots(theta)
            events = np.sum(np.diff(theta[:, None] > wave(turns)[None, :], axis=0), axis=1)
            if (events * 2 != np.abs(np.diff(number))).any():
                continue
            strands = fold_curves._trace(theta, FAMILY)
            assert pieces is None or len(strands) == pieces
            assert sum(strand.theta.size for strand in strands) == number.sum() + events.sum()
            covered = []
            for strand in strands:
                v = np.tan(strand.theta0 / 2)
                assert (np.diff(v) > 0).all() or (np.diff(v) < 0).all()
                np.testing.assert_allclose(strand.theta, wave(v), atol=1e-7)
                assert np.abs(np.diff(strand.theta)).max() <= (theta[1] - theta[0]) * (1 + 1e-9)
                covered.append((v.min(), v.max()))
                for end_of in (0, -1):  # open ends are at the ends of the grid
                    assert min(abs(strand.theta[end_of] - begin), abs(strand.theta[end_of] - end)) < 1e-12
            covered.sort()
            assert all(one[1] < two[0] for one, two in itertools.pairwise(covered))
            for turn in turns:
                if begin < wave(turn) < end:
                    near = [abs(strand.theta - wave(turn)).min() for strand in strands]
                    assert min(near) < 1e-9


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("gap", [3e-3, 1e-4, 1e-6, 3e-9, -1e-4])
def test_roots_between_neighbours_are_found(monkeypatch: pytest.MonkeyPatch, gap: float, sign: int) -> None:
    """An indicator that is of the other sign over a gap between two values of θ only; a negative gap is none."""
    theta = np.linspace(1e-7, math.pi / 2, 512)
    rng = np.random.default_rng(63)
    for place in (*rng.uniform(0.01, 1.56, 12), theta[1] + 1e-4, theta[-2] - 1e-4, theta[100]):
        width = abs(gap) / 2

        def curve(t, _, place=place, width=width):
            return sign * ((t - place) ** 2 - math.copysign(width**2, gap)) * (1 + t)

        monkeypatch.setattr(fold_curves, "indicator", curve)
        found = fold_curves._with_hidden(theta, FAMILY)
        assert np.isin(theta, found).all()
        assert (np.diff(found) > 0).all()
        inside = np.abs(found - place) < width
        added = found[~np.isin(found, theta)]
        assert inside.any() if gap > 0 else not added.size
        assert np.isin(added, found[inside]).all()
        assert added.size <= 33


def test_two_hidden_places_are_both_found(monkeypatch: pytest.MonkeyPatch) -> None:
    theta, places = np.linspace(1e-7, math.pi / 2, 512), (0.3333, 1.0101)
    monkeypatch.setattr(fold_curves, "indicator", lambda t, _: np.prod([(t - at) ** 2 - 1e-10 for at in places], axis=0))
    found = fold_curves._with_hidden(theta, FAMILY)
    for at in places:
        assert (np.abs(found - at) < 1e-5).any()


def test_angles_gather_where_curves_are_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """One curve that is steep in θ₀, one that is steep in μ₀, and a jump, which is no length."""

    def theta0(theta: np.ndarray) -> np.ndarray:
        return np.stack([1.5 + np.arctan(60 * (theta - 0.4)) / 2, 0.2 + 2.4 * (theta > 1.2)], axis=-1)

    def mu0(theta: np.ndarray) -> np.ndarray:
        return np.stack([0 * theta + 0.2, np.exp(3 * np.tanh(60 * (theta - 0.9)))], axis=-1)

    monkeypatch.setattr(fold_curves, "positive_roots", lambda theta, _: (np.tan(theta0(theta) / 2), np.full(theta.size, 2)))
    monkeypatch.setattr(fold_curves, "friction", lambda theta, _, fixed: mu0(theta[:, 0]))
    coarse = np.linspace(1e-7, math.pi / 2, 512)
    found = fold_curves._refined(coarse, FAMILY, 2000)
    assert np.isin(coarse, found).all()
    assert (np.diff(found) > 0).all()
    assert abs(found.size - 2000) <= 2
    fine = found[(np.abs(found - 1.2) > 0.01)]
    steps = np.hypot(np.diff(theta0(fine), axis=0) / math.pi, np.diff(mu0(fine) / (1 + mu0(fine)), axis=0))[:, 0:2]
    quiet = (np.abs(found[:-1] - 1.2) < 0.01).sum()
    total = 0.5 + 0.91  # of each curve's length
    steps[np.abs(np.diff(fine)) > 0.01] = 0
    assert steps.max() < 6 * total / 1488
    assert quiet < 40
    flat = np.abs(found - 0.1) < 0.05
    assert np.diff(found[flat]).max() < 1.01 * (coarse[1] - coarse[0])
    assert found[flat].size > 1.15 * (np.abs(coarse - 0.1) < 0.05).sum()  # a part goes everywhere
    np.testing.assert_array_equal(fold_curves._refined(coarse, FAMILY, 100), coarse)


def test_angles_are_shared_out_by_length_and_by_angle(monkeypatch: pytest.MonkeyPatch) -> None:
    """Between any two that are added lie the same length of the longest curve, over all of it, and half its angle over all of it.

    A length is that in the plane of θ₀/π and μ₀/(1 + |μ₀|); a step of half of the plane or more is a jump.
    """
    coarse = np.linspace(0.2, 1.5, 27)
    curves = np.stack([1 + 0.8 * (coarse - 0.2) ** 2, 0.3 + 0.3 * (coarse > 1.0), 2 - coarse / 2], axis=-1)
    mu0 = np.stack([-5 * np.sin(4 * coarse), np.where(coarse > 0.7, 40.0, -40.0), 0.3 * coarse], axis=-1)
    curves[:3, 2] = math.nan
    monkeypatch.setattr(fold_curves, "positive_roots", lambda theta, _: (np.tan(curves / 2), np.full(theta.size, 3)))
    monkeypatch.setattr(fold_curves, "friction", lambda theta, _, fixed: mu0)
    longest = []
    for i in range(26):
        steps = [
            math.dist(*((curves[k, j] / math.pi, mu0[k, j] / (1 + abs(mu0[k, j]))) for k in (i, i + 1)))
            for j in range(3) if not np.isnan(curves[i, j])
        ]  # fmt: skip
        longest.append(max([step for step in steps if step < 0.5]))
    measure = np.cumsum([0.0, *(one / sum(longest) + 0.5 / 26 for one in longest)])
    found = fold_curves._refined(coarse, FAMILY, 427)
    added = found[~np.isin(found, coarse)]
    assert added.size == pytest.approx(398, abs=3)  # two ends, and those that are there
    np.testing.assert_allclose(np.diff(np.interp(added, coarse, measure)), 1.5 / 399, rtol=1e-9)


# ----------------------------------------------------------------------------------------------------- pieces


def _drawn(monkeypatch: pytest.MonkeyPatch, friction: object, n: int = 41) -> fold_curves.Strand:
    """A strand θ₀ = 1 + θ with that friction, and others close beside it which are not to be taken for it."""
    monkeypatch.setattr(
        fold_curves,
        "positive_roots",
        lambda theta, _: _padded([[math.tan((1 + t + off) / 2) for off in (-0.02, 0, 0.02)] for t in theta]),
    )
    monkeypatch.setattr(
        fold_curves, "friction", lambda theta, theta0, fixed: np.where(np.abs(theta0 - theta - 1) < 0.005, friction(theta), 1.0)
    )
    theta = np.linspace(0.1, 1.4, n)
    return fold_curves.Strand(theta, 1 + theta, friction(theta))


@pytest.mark.parametrize("backwards", [False, True])
def test_strands_are_cut_where_friction_vanishes(monkeypatch: pytest.MonkeyPatch, backwards: bool) -> None:
    strand = _drawn(monkeypatch, lambda theta: np.cos(5 * theta))
    strand = fold_curves._backward(strand) if backwards else strand
    zeros = [math.pi / 10 * k for k in (1, 3)]
    ends = [strand.theta[-1 if backwards else 0], *zeros, strand.theta[0 if backwards else -1]]
    for side, wanted in ((1.0, [(ends[0], ends[1]), (ends[2], ends[3])]), (-1.0, [(ends[1], ends[2])])):
        parts = fold_curves._one_sign(strand, FAMILY, side)
        parts = parts[::-1] if backwards else parts
        assert len(parts) == len(wanted)
        for part, (low, high) in zip(parts, wanted, strict=True):
            theta = part.theta[::-1] if backwards else part.theta
            assert (np.diff(theta) > 0).all()
            assert theta[[0, -1]] == pytest.approx([low, high], abs=1e-12)
            np.testing.assert_allclose(part.theta0, 1 + part.theta, atol=1e-12)
            np.testing.assert_allclose(part.mu0, np.cos(5 * part.theta), atol=1e-9)
            assert (side * part.mu0 >= 0).all()
            inner = strand.theta[(strand.theta > low) & (strand.theta < high)]
            assert np.isin(inner, part.theta).all()


def test_strands_through_infinity_get_no_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    strand = _drawn(monkeypatch, lambda theta: 2e3 / (theta - 0.7512))
    parts = [fold_curves._one_sign(strand, FAMILY, side) for side in (-1.0, 1.0)]
    assert [len(some) for some in parts] == [1, 1]
    assert sum(some[0].theta.size for some in parts) == strand.theta.size
    assert all(np.abs(some[0].mu0).min() > 1e3 for some in parts)


def test_a_zero_next_to_a_steep_rise_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only where friction is large on both sides does it pass through infinity."""
    at = np.linspace(0.1, 1.4, 41)[20] + 2.5e-4
    strand = _drawn(monkeypatch, lambda theta: 2e5 * (theta - at))
    for side, end in ((1.0, 0), (-1.0, -1)):
        (part,) = fold_curves._one_sign(strand, FAMILY, side)
        assert part.theta[end] == pytest.approx(at, abs=1e-12)
        assert part.mu0[end] == 0


def test_a_zero_that_is_not_there_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    strand = _drawn(monkeypatch, lambda theta: 1.0 + 0 * theta)
    turned = fold_curves.Strand(strand.theta, strand.theta0, np.where(np.arange(41) == 20, -1.0, 1.0))
    assert fold_curves._zero_friction(turned, 20, 19, FAMILY) is None
    assert fold_curves._one_sign(turned, FAMILY, -1.0) == []  # one point is no curve
    assert [part.theta.size for part in fold_curves._one_sign(turned, FAMILY, 1.0)] == [20, 20]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_zero_at_a_point_is_that_point(monkeypatch: pytest.MonkeyPatch, side: float) -> None:
    """Where friction only touches 0 the strand goes on; where it passes, both parts have the point, once."""
    at = np.linspace(0.1, 1.4, 41)[20]
    touching = _drawn(monkeypatch, lambda theta: side * (theta - at) ** 2)
    [whole] = fold_curves._one_sign(touching, FAMILY, side)
    assert whole.theta.tolist() == touching.theta.tolist()
    passing = _drawn(monkeypatch, lambda theta: side * (theta - at))
    for way, wanted in ((side, passing.theta[20:]), (-side, passing.theta[:21])):
        [part] = fold_curves._one_sign(passing, FAMILY, way)
        assert part.theta.tolist() == wanted.tolist()


def test_mirrored_strands_are_the_mirror_image() -> None:
    strand = fold_curves.Strand(np.array([0.1, 0.2]), np.array([1.0, 2.5]), np.array([-0.5, 0.0]))
    image = fold_curves._mirrored(strand)
    np.testing.assert_allclose(image.theta, [math.pi - 0.1, math.pi - 0.2])
    np.testing.assert_allclose(image.theta0, [math.pi - 1.0, math.pi - 2.5])
    assert image.mu0.tolist() == [0.5, 0.0]
    assert math.copysign(1, image.mu0[1]) == 1


def test_pieces_of_a_curve_are_joined_however_they_lie() -> None:
    t = np.linspace(0, 1, 31)
    whole = fold_curves.Strand(0.2 + t, 3 - 2 * t, 0.5 + 30 * t**3)
    cuts = [slice(0, 11), slice(10, 16), slice(15, 31)]
    parts = [fold_curves.Strand(whole.theta[cut], whole.theta0[cut], whole.mu0[cut]) for cut in cuts]
    for order in itertools.permutations(range(3)):
        for turned in itertools.product((False, True), repeat=3):
            given = [fold_curves._backward(parts[k]) if turn else parts[k] for k, turn in zip(order, turned, strict=True)]
            for split in range(4):
                (joined,) = fold_curves._joined(given[:split], given[split:])
                way = 1 if joined.theta[0] < joined.theta[-1] else -1
                for name in ("theta", "theta0", "mu0"):
                    values = getattr(joined, name)[::way]
                    np.testing.assert_array_equal(np.unique(values), np.unique(getattr(whole, name)))
                assert (np.diff(joined.theta[::way]) >= 0).all()
                assert joined.theta.size == 33


def test_only_ends_that_are_one_point_are_joined() -> None:
    one = fold_curves.Strand(np.array([0.1, 0.5]), np.array([1.0, 1.2]), np.array([2.0, 0.7]))
    for name, off, joined in itertools.product(("theta", "theta0", "mu0"), (5e-7, 2e-5), (True, False)):
        if joined == (off > 1e-6):
            continue
        start = {"theta": 0.5, "theta0": 1.2, "mu0": 0.7}
        for way in (1, -1):
            end = start | {name: start[name] + way * off}
            two = fold_curves.Strand(*(np.array([end[key], end[key] + 1]) for key in ("theta", "theta0", "mu0")))
            assert len(fold_curves._joined([one], [two])) == (1 if joined else 2)
    ends = fold_curves.Strand(np.array([0.1, 0.5]), np.array([1.0, 1.2]), np.array([2.0, 0.0]))
    assert len(fold_curves._joined([ends], [fold_curves._backward(ends)])) == 1  # at 2.0, not where friction ends
    assert fold_curves._joined([ends], [fold_curves._backward(ends)])[0].mu0.tolist() == [0.0, 2.0, 2.0, 0.0]
    three = fold_curves.Strand(np.array([0.1, 0.3, 0.5]), np.array([1.0, 1.1, 1.2]), np.array([2.0, 1.0, 0.0]))
    after = fold_curves.Strand(np.array([0.5, 0.7, 0.9]), np.array([1.2, 1.3, 1.4]), np.array([0.0, 1.0, 3.0]))
    assert len(fold_curves._joined([three], [after])) == 2
    far = fold_curves.Strand(np.array([0.5, 0.9]), np.array([1.2, 1.3]), np.array([0.0, 3.0]))
    assert len(fold_curves._joined([ends], [far])) == 2
