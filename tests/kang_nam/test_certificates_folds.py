"""The curves of folds against the folds that are proved, at friction coefficients and angles between their points."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from spragsym.generated import catastrophe as generated
from spragsym.kang_nam.folds import fold_curves, fold_events, fold_proofs
from spragsym.kang_nam.folds.fixed_parameters import Fixed
from spragsym.numerics import balls
from tests.support import few

#: κ, α, σ, β: the article's, some where curves begin at θ₀ = 0 or π, close on themselves, or have a cusp at an end; α = 0.
SETS = list(map(Fixed._make, [
    (0.007, 0.007, 0.1, 0.0), (0.007, 0.007, 1.0, 0.0), (0.007, 0.0, 0.1, 0.0), (0.05, 0.3, 2.0, 0.2), (0.002, 0.05, 0.5, 1.0),
    (0.01, 0.0, 1.5, 0.3), (0.3, 0.1, 3.0, 0.0), (0.5499, 0.8771, 0.022509, 4.455), (0.02, 1.0, 0.4, 0.0),
    (0.195, 0.5261, 0.8677, 0.0), (0.006083, 0.0, 0.006177, 19.34), (0.07477, 0.37, 1.612, 0.0), (0.0397, 2.121, 0.1677, 0.0),
]))  # fmt: skip


pytestmark = pytest.mark.usefixtures("silent")


@pytest.fixture(scope="module", params=few(SETS, *SETS[:3], SETS[7]), ids=lambda fixed: str(tuple(fixed)))
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
    strands = _strands(fixed)
    for mu0 in frictions:
        exact = dict(zip(("kappa", "alpha", "sigma", "beta"), map(Fraction, fixed), strict=True)) | {"mu0": Fraction(mu0)}
        with balls.precision(256):
            points = [fold.point for fold in fold_proofs.folds("theta0", exact, 256)]
            angles = [sum(map(float, balls.ends(point.parameters[0]))) / 2 for point in points]
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


@pytest.mark.parametrize("fixed", [Fixed(0.25, 0.5, 0.5, 0.0), Fixed(1.0, 1.0, 1.0, 0.0), Fixed(0.5, 0.5, 1.0, 0.0)], ids=str)
def test_what_happens_at_90_degrees_or_everywhere_is_no_event(fixed: Fixed) -> None:
    """κ (α + σ) = σ (1 + β − α): one passes 0 at θ = π/2, its mirror image π; α = κ = 1 + β: no θ has a fold without friction."""
    parts = fold_events.stretches(fixed)
    assert all(part.low < part.inside < part.high for part in parts)
    for part in parts:
        assert _roots(part.inside, fixed).size == part.number
    check_crossings(fixed, "0.3217", "1.913")
