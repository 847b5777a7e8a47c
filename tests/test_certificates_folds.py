"""The curves of folds against the folds that are proved, at friction coefficients and angles between their points."""

from __future__ import annotations

import functools
import itertools
import math
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


@functools.cache
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
        coefficients = np.poly(roots).real[::-1] * rng.choice([-3, 0.5])
        value, number = fold_curves.discriminant(coefficients)
        assert number == real
        gaps = math.prod(one - two for one, two in itertools.combinations(roots, 2))
        assert math.copysign(1, value) == math.copysign(1, (gaps * gaps).real)
        assert -1 <= value <= 1


def test_linear_critical_friction_has_the_shape_of_its_parameters() -> None:
    one = ss.linear_critical_friction(ss.Parameters.article())
    assert type(one) is float
    assert one == pytest.approx(math.sqrt(4 * 0.007 * 0.107 * 1.1 / 0.01))
    many = ss.linear_critical_friction(ss.Parameters.article(alpha=[0.0, 0.007], beta=[[0.0], [1.0], [2.0]]))
    assert many.shape == (3, 2)
    assert many[0, 1] == one
    assert (many[:, 0] == 0).all()
    assert many[2, 1] == pytest.approx(math.sqrt(4 * 0.007 * 0.107 * 3 * 3.1 / 0.01))
