"""The curves of folds against the folds that are proved, at friction coefficients and angles
between their points.
"""

import math
from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss
from spragsym.kang_nam import folds
from spragsym.kang_nam.bifurcation_sets import directions, fold_polynomial
from spragsym.kang_nam.kernel import Fixed
from spragsym.numerics import balls
from spragsym.numerics.polynomials import on_circle
from tests.support import few

#: κ, α, σ, β: the article's, some where curves begin at θ₀ = 0 or π, close on themselves, or have a
#: cusp at an end; α = 0.
SETS = list(
    map(
        Fixed._make,
        [
            (0.007, 0.007, 0.1, 0.0),
            (0.007, 0.007, 1.0, 0.0),
            (0.007, 0.0, 0.1, 0.0),
            (0.05, 0.3, 2.0, 0.2),
            (0.002, 0.05, 0.5, 1.0),
            (0.01, 0.0, 1.5, 0.3),
            (0.3, 0.1, 3.0, 0.0),
            (0.5499, 0.8771, 0.022509, 4.455),
            (0.02, 1.0, 0.4, 0.0),
            (0.195, 0.5261, 0.8677, 0.0),
            (0.006083, 0.0, 0.006177, 19.34),
            (0.07477, 0.37, 1.612, 0.0),
            (0.0397, 2.121, 0.1677, 0.0),
        ],
    )
)


pytestmark = pytest.mark.usefixtures("silent")


@pytest.fixture(
    scope="module", params=few(SETS, *SETS[:3], SETS[7]), ids=lambda fixed: str(tuple(fixed))
)
def fixed(request: pytest.FixtureRequest) -> Fixed:
    return request.param


def _curves(fixed: Fixed) -> tuple[ss.results.Curve, ...]:
    return ss.bifurcation_set(ss.Parameters(**fixed._asdict()), n=1200).curves


def test_every_point_is_a_fold(fixed: Fixed) -> None:
    kappa, alpha, sigma, beta = fixed
    for curve in _curves(fixed):
        assert curve.theta.shape == curve.theta0.shape == curve.mu0.shape
        assert curve.theta.size > 1
        assert np.isfinite([curve.theta, curve.theta0, curve.mu0]).all()
        assert not np.signbit(curve.mu0).any()
        inside = (curve.theta0 > 1e-6) & (curve.theta0 < math.pi - 1e-6) & (curve.mu0 < 1e3)
        s, c, s0, c0 = (
            np.sin(curve.theta),
            np.cos(curve.theta),
            np.sin(curve.theta0),
            np.cos(curve.theta0),
        )
        mu0, q, p = curve.mu0, beta + 1 + sigma, alpha + sigma
        a, b = sigma * (q - p), -p * ((beta + 1) * s0 + kappa)
        d, m = q * alpha * c0 + mu0 * (sigma * s0 - kappa), mu0 * sigma
        size = abs(a) + abs(b) + abs(d) + abs(m) + 1e-9
        assert (np.abs(a * s * c + b * c + d * s - m * s * s)[inside] < 1e-9 * size[inside]).all()
        assert (
            np.abs(a * (c * c - s * s) - b * s + d * c - 2 * m * s * c)[inside]
            < 1e-7 * size[inside]
        ).all()


def test_a_curve_passes_through_its_cusps(fixed: Fixed) -> None:
    found = ss.bifurcation_set(ss.Parameters(**fixed._asdict()))
    for theta0, mu0 in zip(found.cusps.theta0, found.cusps.mu0, strict=True):
        assert (
            min(np.hypot(curve.theta0 - theta0, curve.mu0 - mu0).min() for curve in found.curves)
            < 1e-9
        )


def _crossings(curves: tuple[ss.results.Curve, ...], mu0: float) -> list[float]:
    """Angles θ₀ at which the curves pass a friction coefficient."""
    found = []
    for curve in curves:
        side = curve.mu0 - mu0
        for i in np.flatnonzero(side[1:] * side[:-1] < 0):
            found.append(
                float(
                    curve.theta0[i]
                    + side[i] / (side[i] - side[i + 1]) * (curve.theta0[i + 1] - curve.theta0[i])
                )
            )
    return sorted(found)


def check_crossings(fixed: Fixed, *frictions: str) -> None:
    """Between the points of the curves, all folds in θ₀ that Sturm's count proves at some friction
    are crossed, and no others.
    """
    curves = _curves(fixed)
    for mu0 in frictions:
        exact = dict(
            zip(("kappa", "alpha", "sigma", "beta"), map(Fraction, fixed), strict=True)
        ) | {"mu0": Fraction(mu0)}
        with balls.precision(256):
            points = [fold.point for fold in folds.proved_folds("theta0", exact, 256)]
            angles = [sum(map(float, balls.ends(point.parameters[0]))) / 2 for point in points]
        proved = sorted(angle for angle in angles if 0 < angle < math.pi)
        crossed = _crossings(curves, float(mu0))
        assert len(crossed) == len(proved)
        np.testing.assert_allclose(crossed, proved, atol=5e-3)


def test_no_curve_is_missed_or_twice(fixed: Fixed) -> None:
    check_crossings(fixed, "0.0511", "0.3217", "0.777", "1.913")


def test_curves_end_where_they_must_and_step_smoothly(fixed: Fixed) -> None:
    """At θ₀ = 0 or π, at μ₀ = 0, far up, or nowhere; and no step is long."""
    for curve in _curves(fixed):
        closed = (
            abs(curve.theta0[0] - curve.theta0[-1]) < 1e-9
            and abs(curve.mu0[0] - curve.mu0[-1]) < 1e-9
        )
        for end in (0, -1):
            at_angle = min(curve.theta0[end], math.pi - curve.theta0[end]) < 1e-6
            assert closed or at_angle or curve.mu0[end] < 1e-9 or curve.mu0[end] > 10
        shown = curve.mu0 < 3
        steps = np.hypot(np.diff(curve.theta0) / math.pi, np.diff(curve.mu0 / (1 + curve.mu0)))[
            shown[1:] & shown[:-1]
        ]
        assert steps.size == 0 or steps.max() < 0.03


@pytest.mark.thorough
@pytest.mark.parametrize(("share", "number"), [(0.8829647603948506, 4), (0.8829647603948507, 1)])
def test_events_however_close_are_told_apart(share: float, number: int) -> None:
    """Between two sets of parameters a meeting of folds and one at θ₀ = π change places: to the
    last float, both are seen.
    """
    one, two = Fixed(0.0051, 0.0023, 0.0978, 0.0), Fixed(0.00115, 0.0837, 0.0529, 0.0)
    fixed = Fixed(*(a + share * (b - a) for a, b in zip(one, two, strict=True)))
    found = directions(fixed)
    assert found.number[:4].tolist() == [2, 3, number, 2]
    assert found.events[2] - found.events[1] < 1e-10
    check_crossings(fixed, "0.3217")


def test_what_happens_at_90_degrees_or_everywhere_is_no_event() -> None:
    """κ (α + σ) = σ (1 + β − α): one passes 0 at θ = π/2, its mirror image π; α = κ = 1 + β: no θ
    has a fold without friction.
    """
    for fixed in (Fixed(0.25, 0.5, 0.5, 0.0), Fixed(0.5, 0.5, 1.0, 0.0)):
        check_crossings(fixed, "0.3217", "1.913")
    for fixed in (Fixed(0.25, 0.5, 0.5, 0.0), Fixed(1.0, 1.0, 1.0, 0.0), Fixed(0.5, 0.5, 1.0, 0.0)):
        found = directions(fixed)
        for t in (found.events[:-1] + found.events[1:]) / 2:
            roots = np.roots(fold_polynomial(*on_circle(float(t))[:2], fixed)[::-1])
            assert np.sum(
                (np.abs(roots.imag) < 1e-9 * np.abs(roots)) & (roots.real > 0)
            ) == found.folds_at(t)
