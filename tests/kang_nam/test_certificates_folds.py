"""The curves of folds against the folds that are proved, at friction coefficients and angles between their points."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from spragsym.exact import intervals
from spragsym.exact.descartes import Root
from spragsym.generated import catastrophe as generated
from spragsym.kang_nam.catastrophe import fold_curves, fold_events, fold_proofs
from spragsym.kang_nam.catastrophe.fixed_parameters import Fixed
from spragsym.kang_nam.catastrophe.fold_events import Stretch

#: κ, α, σ, β: the article's, some where curves begin at θ₀ = 0 or π, close on themselves, or have a cusp at an end; α = 0.
SETS = list(map(Fixed._make, [
    (0.007, 0.007, 0.1, 0.0), (0.007, 0.007, 1.0, 0.0), (0.007, 0.0, 0.1, 0.0), (0.05, 0.3, 2.0, 0.2), (0.002, 0.05, 0.5, 1.0),
    (0.01, 0.0, 1.5, 0.3), (0.3, 0.1, 3.0, 0.0), (0.5499, 0.8771, 0.022509, 4.455), (0.02, 1.0, 0.4, 0.0),
    (0.195, 0.5261, 0.8677, 0.0), (0.006083, 0.0, 0.006177, 19.34), (0.07477, 0.37, 1.612, 0.0), (0.0397, 2.121, 0.1677, 0.0),
]))  # fmt: skip


pytestmark = pytest.mark.usefixtures("silent")


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
        assert not np.signbit(strand.mu0).any()
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


def check_crossings(fixed: Fixed, *frictions: str) -> None:
    """Between the points of the curves, all folds in θ₀ that Sturm's count proves at some friction are crossed, and no others."""
    arith, strands = intervals.arithmetic(), _strands(fixed)
    for mu0 in frictions:
        exact = dict(zip(("kappa", "alpha", "sigma", "beta"), map(Fraction, fixed), strict=True)) | {"mu0": Fraction(mu0)}
        with arith.precision(256):
            points = [fold.point for fold in fold_proofs.folds(arith, "theta0", exact, 256)]
            angles = [sum(map(float, arith.ends(point.parameters[0]))) / 2 for point in points]
        proved = sorted(angle for angle in angles if 0 < angle < math.pi)
        crossed = _crossings(strands, float(mu0), fixed)
        assert len(crossed) == len(proved)
        np.testing.assert_allclose(crossed, proved, atol=5e-3)


def test_no_curve_is_missed_or_twice(fixed: Fixed) -> None:
    check_crossings(fixed, "0.0511", "0.3217", "0.777", "1.913")


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


def _roots(theta: float, fixed: Fixed) -> np.ndarray:
    """tan(θ₀/2) of the folds at θ by numpy's roots: of the quartic through values of the conic, and of the sines for α = 0."""
    e0, e1, e2, ec = (float(value) for value in generated.fold_conic(np.cos(theta), np.sin(theta), *fixed))
    if not fixed.alpha:
        sines = np.roots([e2, e1, e0])
        return np.tan(np.arcsin(np.sort(sines.real[(sines.imag == 0) & (sines.real > 0) & (sines.real < 1)])) / 2)
    v = np.arange(-2, 3)
    height = (e0 + ec * (1 - v * v) / (1 + v * v)) * (1 + v * v) ** 2 + e1 * 2 * v * (1 + v * v) + e2 * 4 * v * v
    roots = np.roots(np.polyfit(v, height, 4))
    return np.sort(roots.real[(np.abs(roots.imag) < 1e-9 * np.abs(roots)) & (roots.real > 0)])


@pytest.mark.thorough
def test_events_however_close_are_told_apart() -> None:
    """Between two sets of parameters a meeting of folds and one at θ₀ = π change places: to the last float, both are seen."""
    one, two = Fixed(0.0051, 0.0023, 0.0978, 0.0), Fixed(0.00115, 0.0837, 0.0529, 0.0)

    def between(share: float) -> Fixed:
        return Fixed(*(a + share * (b - a) for a, b in zip(one, two, strict=True)))

    def numbers(share: float) -> list[int]:
        return [part.number for part in fold_events.stretches(between(share))]

    low, high = 0.88296476, 0.88296477
    assert numbers(low)[:4] == [2, 3, 4, 2]
    assert numbers(high)[:4] == [2, 3, 1, 2]
    while low < (middle := (low + high) / 2) < high:
        low, high = (middle, high) if 4 in numbers(middle) else (low, middle)
    for share, number in ((low, 4), (high, 1)):
        fixed = between(share)
        [narrow] = [part for part in fold_events.stretches(fixed) if part.number == number]
        assert narrow.high - narrow.low < 1e-10
        check_crossings(fixed, "0.3217")


def test_a_root_may_be_beyond_all_ratios_of_coefficients() -> None:
    """(1 + √5)/2 of t² − t − 1, whose largest ratio is 1."""
    assert fold_events._positive_roots((-1, -1, 1), None) == 1


def test_an_event_of_two_kinds_is_one_event(monkeypatch: pytest.MonkeyPatch) -> None:
    """Polynomials with the roots 1/2 and 1/3, 1/2 and 2/3, 2/3 twice: three events."""
    conditions = [(1, -5, 6), (2, -7, 6), (4, -12, 9), (7, 1)]
    monkeypatch.setattr(fold_events, "_conditions", lambda _: iter(conditions))
    events = fold_events._events(FAMILY)
    assert [float(event.low) for event in events] == pytest.approx([1 / 3, 1 / 2, 2 / 3], abs=1e-15)
    assert all(event.low <= event.high for event in events)


def test_events_are_isolated_until_nothing_touches(monkeypatch: pytest.MonkeyPatch) -> None:
    """Intervals that have a point in common, with each other or with t = 1, are no answer; each try has twice the bits."""
    asked = []

    def apart(bits: int) -> list[Root]:
        width = Fraction(1, bits)
        return {
            64: [Root(1 - 2 * width, 1 - width), Root(1 - width, 1 - width / 2)],  # they touch
            128: [Root(1 - 2 * width, 1 - width), Root(1 - width / 2, Fraction(1))],  # one touches 1
            256: [Root(1 - width / 2, 1 - width / 4), Root(1 - 2 * width, 1 - width)],
        }[bits]

    def one_after_the_other(_: object, low: Fraction, high: Fraction, bits: int) -> list[Root]:
        asked.append((low, high, bits))
        return apart(bits)

    monkeypatch.setattr(fold_events, "_conditions", lambda _: iter([(-1, 2)]))
    monkeypatch.setattr(fold_events, "real_roots", one_after_the_other)
    assert fold_events._events(FAMILY) == sorted(apart(256))
    assert asked == [(0, 1, bits) for bits in (64, 128, 256)]


@pytest.mark.parametrize("fixed", [Fixed(0.25, 0.5, 0.5, 0.0), Fixed(1.0, 1.0, 1.0, 0.0), Fixed(0.5, 0.5, 1.0, 0.0)], ids=str)
def test_what_happens_at_90_degrees_or_everywhere_is_no_event(fixed: Fixed) -> None:
    """κ (α + σ) = σ (1 + β − α): one passes 0 at θ = π/2, its mirror image π; α = κ = 1 + β: no θ has a fold without friction."""
    parts = fold_events.stretches(fixed)
    assert all(part.low < part.inside < part.high for part in parts)
    for part in parts:
        assert _roots(part.inside, fixed).size == part.number
    check_crossings(fixed, "0.3217", "1.913")


@pytest.mark.parametrize(
    ("sines", "kept"), [((-0.5, 0.5), [0.5]), ((0.0, 0.5), [0.0, 0.5]), ((1.0, 0.5), [0.5, 1.0]), ((0.2, 0.7), [0.2, 0.7]),
                        ((1e-13, 0.9), [1e-13, 0.9]), ((-0.1, 2.0), []), ((-1e-13, 0.9), [0.9]), ((0.9, 1.2), [0.9]),
                        ((1.2, 0.9), [0.9]), ((1.2, 0.9), [0.9, 1.0])],
)  # fmt: skip
@pytest.mark.parametrize("sign", [1, -2])
def test_sines_between_0_and_1_are_kept(
    monkeypatch: pytest.MonkeyPatch, sines: tuple[float, float], kept: list[float], sign: int
) -> None:
    """Without α; as many as are asked for, one beyond 1 as rounding of 1."""
    one, two = sines
    condition = tuple(np.full(2, sign * value) for value in (one * two, -one - two, 1.0))
    monkeypatch.setattr(fold_curves, "fold_polynomial", lambda *_: condition)
    values = fold_curves.positive_roots(np.array([0.5, 0.6]), len(kept), Fixed(1.0, 0.0, 1.0, 1.0))
    for row in values:
        np.testing.assert_allclose(row, np.tan(0.5 * np.arcsin(kept)), rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize(
    ("roots", "number", "wanted"),
    [
        # A real pair that rounding split is far out: its imaginary part is the larger one, over its size the smaller one.
        ([1e6 + 1e-2j, 1e6 - 1e-2j, 1e-3 + 1e-3j, 1e-3 - 1e-3j], 2, [1e6, 1e6]),
        ([1e-3 + 1e-3j, 1e6 - 1e-2j, 1e-3 - 1e-3j, 1e6 + 1e-2j], 2, [1e6, 1e6]),
        ([1e-6 + 1e-9j, 1e-6 - 1e-9j, 1e-9 + 5e-10j, 1e-9 - 5e-10j], 2, [1e-6, 1e-6]),
        # Negative ones are far off, however real they are.
        ([-1.0, 2.0, 3.0 + 1e-9j, 3.0 - 1e-9j], 3, [2.0, 3.0, 3.0]),
        ([3.0 + 1j, 3.0 - 1j, -1e-9, 2.0], 1, [2.0]),
        ([3.0 + 1j, 3.0 - 1j, 2.0, 1.0], 0, []),
        # 0 is real, and positive enough.
        ([0.0, 2.0, 3.0 + 1j, 3.0 - 1j], 2, [0.0, 2.0]),
        ([2.0, 1.0, -3.0 + 1j, -3.0 - 1j], 2, [1.0, 2.0]),
        ([-3.0 + 1j, -3.0 - 1j, 2.0, 1.0], 2, [1.0, 2.0]),
    ],
)
def test_the_roots_closest_to_the_positive_axis_are_kept(
    monkeypatch: pytest.MonkeyPatch, roots: list[complex], number: int, wanted: list[float]
) -> None:
    """For their size, whatever the order in which they come."""
    monkeypatch.setattr(fold_curves, "eigenvalues", lambda _: np.array([roots, roots], dtype=complex))
    monkeypatch.setattr(fold_curves, "polished", lambda _, values: values)
    values = fold_curves.positive_roots(np.array([0.5, 0.6]), number, FAMILY)
    assert values.tolist() == [wanted, wanted]


# ------------------------------------------------------------------------------------ tracing families that are known
#
# Roots v at given θ of curves drawn by hand, which never cross: what is traced must be those curves, whatever the grid.

#: Circles (θ, v, radius) one in the other, and beside them.
CIRCLES = ((0.8, 1.5, 0.3), (0.8, 1.5, 0.5), (0.55, 0.45, 0.2))
#: A line comes in at v = 0, another one leaves at the other end.
ENTERS, LEAVES = 0.45, 1.12
FAMILY = Fixed(1.0, 1.0, 1.0, 1.0)


def _parts(ends: list[float], number: Callable[[float], int], signs: Callable[[float], tuple[int, int]]) -> list[Stretch]:
    """The stretches between events that are known, by what is there in their middles."""
    inside = [(low + high) / 2 for low, high in itertools.pairwise(ends)]
    return [Stretch(*pair, at, number(at), *signs(at)) for pair, at in zip(itertools.pairwise(ends), inside, strict=True)]


def _sign(value: float) -> int:
    return (value > 0) - (value < 0)


def _traced(
    monkeypatch: pytest.MonkeyPatch, parts: list[Stretch], rows: Callable[[float], list[float]], theta: np.ndarray, fixed: Fixed
) -> list[fold_curves.Strand]:
    """What is traced of roots that a function of θ gives; at an event as many as there are beside it."""

    def roots(theta: np.ndarray, number: int, _: Fixed) -> np.ndarray:
        found = []
        for angle in theta:
            beside = (rows(angle + way * step) for step in (0.0, 1e-15, 1e-13, 1e-11) for way in (-1, 1))
            found.append(next(sorted(row) for row in beside if len(row) == number))
        return np.array(found).reshape(theta.size, number)

    monkeypatch.setattr(fold_curves, "positive_roots", roots)
    return fold_curves._trace(parts, fold_curves._by_stretch(parts, theta), fixed)


def _circles_and_lines(angle: float, end: float) -> list[float]:
    row = [v + way * math.sqrt(r * r - (angle - at) ** 2) for at, v, r in CIRCLES for way in (-1, 1) if abs(angle - at) < r]
    row = [v * min(1.0, end / 4) for v in row]
    if angle > ENTERS:
        row.append(0.1 * (angle - ENTERS) * min(1.0, end / 4))
    if angle < LEAVES:
        row.append(3 + 0.5 / (LEAVES - angle) if end == math.inf else 0.7 + 0.3 * angle / LEAVES)
    return row


@pytest.mark.parametrize("alpha", [1.0, 0.0])
def test_circles_and_lines_are_traced_whatever_the_grid(monkeypatch: pytest.MonkeyPatch, alpha: float) -> None:
    end = math.inf if alpha else 1.0
    births = sorted([ENTERS, LEAVES, *(at + way * r for at, _, r in CIRCLES for way in (-1, 1))])
    parts = _parts(
        [0.0, *births, math.pi / 2],
        lambda angle: len(_circles_and_lines(angle, end)),
        lambda angle: (_sign(ENTERS - angle), _sign(LEAVES - angle)),
    )
    scale = min(1.0, end / 4)
    for n, shift in itertools.product((0, 7, 16, 33, 60, 121), (0.0, 0.013)):
        theta = np.linspace(0.05 + shift, 1.5, n)
        strands = _traced(monkeypatch, parts, lambda angle: _circles_and_lines(angle, end), theta, FAMILY._replace(alpha=alpha))
        assert len(strands) == 5
        values = np.unique([*theta, *(part.inside for part in parts)])
        number = sum(len(_circles_and_lines(angle, end)) for angle in values)
        assert sum(strand.theta.size for strand in strands) == number + 2 + 3 * len(CIRCLES)  # of a circle two, and one twice
        for strand in strands:
            v = np.tan(strand.theta0 / 2) / scale
            closed = strand.theta[0] == strand.theta[-1] and strand.theta0[0] == strand.theta0[-1]
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
                assert strand.theta[-1] == values[-1]
            else:
                assert strand.theta[0] == values[0]
                assert strand.theta[-1] == pytest.approx(LEAVES, abs=1e-12)
                assert strand.theta0[-1] == 2 * math.atan(end)


@pytest.mark.parametrize("enters", [0.41, 0.45, 0.49, 0.55])
@pytest.mark.parametrize("leaves", [0.42, 0.47, 0.5, 0.58])
@pytest.mark.parametrize("born", [0.43, 0.48, 0.53, 2.0])
def test_events_in_any_order_are_followed(monkeypatch: pytest.MonkeyPatch, enters: float, leaves: float, born: float) -> None:
    """A line comes in, another one leaves, also at an angle of the grid, a pair is born, in any order."""

    def rows(angle: float) -> list[float]:
        row = [0.1 * (angle - enters)] if angle > enters else []
        row += [2 + way * math.sqrt(angle - born) for way in (-1, 1)] if angle > born else []
        return row + ([5 + 0.1 / (leaves - angle)] if angle < leaves else [])

    ends = [0.0, *sorted({enters, leaves, born} - {2.0}), math.pi / 2]
    parts = _parts(ends, lambda angle: len(rows(angle)), lambda angle: (_sign(enters - angle), _sign(leaves - angle)))
    strands = _traced(monkeypatch, parts, rows, np.array([0.1, 0.4, 0.5, 0.6, 0.9]), FAMILY)
    first, *pair, last = sorted(strands, key=lambda strand: strand.theta0.max())
    assert len(pair) == (born < 1)
    np.testing.assert_allclose(np.tan(first.theta0 / 2), 0.1 * (first.theta - enters), atol=1e-12)
    assert first.theta[0] == pytest.approx(enters, abs=1e-12)
    assert last.theta[-1] == pytest.approx(leaves, abs=1e-12)
    for strand in pair:
        v = np.tan(strand.theta0 / 2)
        np.testing.assert_allclose((v - 2) ** 2, strand.theta - born, atol=1e-9)
        assert v[strand.theta == born] == pytest.approx(2, abs=1e-12)  # both at once
        assert (np.diff(v) > 0).all() or (np.diff(v) < 0).all()


def test_a_root_may_enter_where_another_leaves() -> None:
    """−1 + 2 S − S² moved down: its larger root leaves at 1 where its smaller one enters at 0, and back."""
    before, after = (Stretch(0.0, 1.0, 0.5, 1, sign, -sign) for sign in (1, -1))
    assert fold_curves._passing(before, after) == (1, -1)
    assert fold_curves._passing(after, before) == (-1, 1)


#: θ(v) = T₅(v − 2) with a tilt: one curve, of which one to five pass a θ; up, and down.
_WAVE = np.polynomial.Chebyshev([0.75, 0.05, 0, 0, 0, 0.35], domain=[1, 3]).convert(kind=np.polynomial.Polynomial)


@pytest.mark.parametrize("way", [1, -1])
def test_one_curve_with_many_folds_is_traced_as_one(monkeypatch: pytest.MonkeyPatch, way: int) -> None:
    def wave(v: np.ndarray) -> np.ndarray:
        return 0.75 + way * (_WAVE(v) - 0.75)

    def rows(angle: float) -> list[float]:
        one = (_WAVE - (0.75 + way * (angle - 0.75))).roots()
        return one.real[(np.abs(one.imag) < 1e-12) & (one.real > 0)].tolist()

    turns = np.sort(wave(_WAVE.deriv().roots().real))
    parts = _parts([0.0, *turns, math.pi / 2], lambda angle: len(rows(angle)), lambda _: (1, 1))
    for n in (0, 9, 24, 90):
        theta = np.linspace(0.02, 1.48, n)
        [strand] = _traced(monkeypatch, parts, rows, theta, FAMILY)
        v = np.tan(strand.theta0 / 2)
        assert (np.diff(v) > 0).all() or (np.diff(v) < 0).all()
        np.testing.assert_allclose(strand.theta, wave(v), atol=1e-7)
        values = np.unique([*theta, *(part.inside for part in parts)])
        assert strand.theta.size == sum(len(rows(angle)) for angle in values) + turns.size
        assert np.isin(turns, strand.theta).all()


def _refined(
    monkeypatch: pytest.MonkeyPatch, theta0: Callable[[np.ndarray], np.ndarray], mu0: Callable[[np.ndarray], np.ndarray], n: int
) -> tuple[np.ndarray, np.ndarray]:
    """The grid before and after, with two events."""
    monkeypatch.setattr(fold_curves, "positive_roots", lambda theta, number, _: np.tan(theta0(theta)[:, :number] / 2))
    monkeypatch.setattr(fold_curves, "friction", lambda theta, theta0, _: mu0(theta[:, 0])[:, : theta0.shape[1]])

    def number(angle: float) -> int:
        return 2 if angle < 0.3 else 3 if angle < 1.3 else 0

    parts = _parts([0.0, 0.3001, 1.3001, math.pi / 2], number, lambda _: (1, 1))
    coarse = np.unique([*np.linspace(1e-7, math.pi / 2, 512), *(part.inside for part in parts)])
    found = fold_curves._refined(parts, FAMILY, n)
    for part, values in zip(parts, found, strict=True):
        assert ((values > part.low) & (values < part.high + 1e-15) & (np.diff(values, append=9) > 0)).all()
    return coarse, np.concatenate(found)


def test_angles_are_shared_out_by_length_and_by_angle(monkeypatch: pytest.MonkeyPatch) -> None:
    """Between any two that are added lie the same length of the longest curve, over all of it, and half its angle over all of it.

    A length is that in the plane of θ₀/π and μ₀/(1 + |μ₀|), of the curves that both ends of a step are on.
    """

    def theta0(t: np.ndarray) -> np.ndarray:
        return np.stack([1 + 0.8 * (t - 0.2) ** 2, 0.3 + 0.1 * np.sin(9 * t), 2 - t / 2], axis=-1)

    def mu0(t: np.ndarray) -> np.ndarray:
        return np.stack([-5 * np.sin(4 * t), 0.1 + t**3, np.where(t > 1, np.nan, 0.3 * t)], axis=-1)

    coarse, found = _refined(monkeypatch, theta0, mu0, 4270)
    longest = []
    for low, high in itertools.pairwise(coarse):
        number = 2 if high < 0.3 else 3 if 0.3 < low and high < 1.3 else 0
        ends = [zip(theta0(np.array([at]))[0], mu0(np.array([at]))[0], strict=True) for at in (low, high)]
        steps = [
            math.dist((a / math.pi, m / (1 + abs(m))), (b / math.pi, n / (1 + abs(n))))
            for (a, m), (b, n) in list(zip(*ends, strict=True))[:number]
        ]
        longest.append(max([step for step in steps if not math.isnan(step)], default=0.0))
    share = np.diff(coarse) / (math.pi / 2)
    measure = np.cumsum([0.0, *(np.array(longest) / sum(longest) + 0.5 * share)])
    np.testing.assert_array_equal(_refined(monkeypatch, theta0, mu0, 100)[1], coarse)
    added = found[~np.isin(found, coarse)]
    assert added.size == pytest.approx(4270 - coarse.size, abs=3)
    np.testing.assert_allclose(np.diff(np.interp(added, coarse, measure)), 1.5 / (4270 - coarse.size - 1), rtol=1e-6)


# ----------------------------------------------------------------------------------------------------- pieces


def _drawn(monkeypatch: pytest.MonkeyPatch, friction: Callable[[np.ndarray], np.ndarray], n: int = 41) -> fold_curves.Strand:
    """A strand θ₀ = 1 + θ with that friction; where there is none, derived angles say so too."""
    monkeypatch.setattr(
        generated, "fold_angles", lambda c, s, mu0, *_: (np.sin(1 + np.arctan2(s, c)) + mu0, np.cos(1 + np.arctan2(s, c)))
    )
    theta = np.linspace(0.1, 1.4, n)
    return fold_curves.Strand(theta, 1 + theta, friction(theta))


def test_a_change_of_sign_without_an_event_gets_no_point(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is rounding, as it is for α = 0, where no fold is without friction."""
    strand = _drawn(monkeypatch, lambda theta: 1.0 + 0 * theta)
    turned = fold_curves.Strand(strand.theta, strand.theta0, np.where(np.arange(41) == 20, -1.0, 1.0))
    elsewhere = [0.2, 1.3, *turned.theta[19:21]]  # points that are events are ends of curves
    assert fold_curves._one_sign(turned, elsewhere, FAMILY, positive=False) == []  # one point is no curve
    assert [piece.theta.size for piece in fold_curves._one_sign(turned, elsewhere, FAMILY, positive=True)] == [20, 20]
    here = [float(turned.theta[19:21].mean())]
    assert [piece.theta.size for piece in fold_curves._one_sign(turned, here, FAMILY, positive=True)] == [21, 20]
    assert [piece.theta.size for piece in fold_curves._one_sign(turned, here, FAMILY._replace(alpha=0.0), positive=True)] == [
        20,
        20,
    ]


@pytest.mark.parametrize("positive", [True, False])
def test_where_friction_only_touches_0_a_strand_goes_on(monkeypatch: pytest.MonkeyPatch, positive: bool) -> None:
    at = np.linspace(0.1, 1.4, 41)[20]
    touching = _drawn(monkeypatch, lambda theta: (1 if positive else -1) * (theta - at) ** 2)
    [whole] = fold_curves._one_sign(touching, [at], FAMILY, positive=positive)
    assert whole.theta.tolist() == touching.theta.tolist()


def test_an_event_is_in_no_stretch() -> None:
    parts = _parts([0.0, 0.5, math.pi / 2], lambda _: 1, lambda _: (1, 1))
    first, second = fold_curves._by_stretch(parts, np.array([0.0, 0.3, 0.5, 0.7, math.pi / 2]))
    assert first.tolist() == [0.25, 0.3]
    assert second.tolist() == [0.7, parts[1].inside, math.pi / 2]


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
