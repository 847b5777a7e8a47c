"""Flutter onsets against a map of stability, against Newton's method on the equations of motion,
and at degenerate parameters.
"""

import math
from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.generated import stability
from spragsym.kang_nam import flutter, kernel
from spragsym.numerics import balls
from tests.oracles.families import random_fluttering
from tests.oracles.forces_by_hand import DRAWN
from tests.support import exact_onsets, middle_of

#: α > 0 with an onset next to θ₀ = π/2, and α = 0: each lost an onset, or its friction, where a
#: grid decided.
NEXT_TO_90 = ss.Parameters.article(mu0=1.3, alpha=1.3, sigma=0.32)
WITHOUT_ALPHA = ss.Parameters(mu0=0.75, kappa=0.0035, alpha=0, sigma=0.7, beta=0)


# ------------------------------------------------------------------------------------------------
# independent formulation


def _forces(
    x: mpmath.mpf, y: mpmath.mpf, theta0: mpmath.mpf, p: dict[str, mpmath.mpf]
) -> list[mpmath.mpf]:
    """The forces of (8) and (9) on the mass in contact, in x and y: nothing is eliminated."""
    return DRAWN["kang_nam"].forces((x, y), (0, 0), p | {"theta0": theta0}, mpmath, True, p["mu0"])


def _residuals(p: dict[str, mpmath.mpf]) -> Callable[..., list[mpmath.mpf]]:
    """F_x, F_y and the discriminant in λ² of det(λ² I + K), K by differences of the forces at many
    digits.
    """

    def residuals(x: mpmath.mpf, y: mpmath.mpf, theta0: mpmath.mpf) -> list[mpmath.mpf]:
        step = mpmath.mpf(10) ** -40
        moved = [
            (_forces(x - a, y - b, theta0, p), _forces(x + a, y + b, theta0, p))
            for a, b in ((step, 0), (0, step))
        ]
        K = [[(before[row] - after[row]) / (2 * step) for before, after in moved] for row in (0, 1)]
        trace, determinant = K[0][0] + K[1][1], K[0][0] * K[1][1] - K[0][1] * K[1][0]
        return [*_forces(x, y, theta0, p), trace**2 - 4 * determinant]

    return residuals


@pytest.mark.parametrize(
    "p",
    [
        NEXT_TO_90,
        WITHOUT_ALPHA,
        ss.Parameters.article(alpha=0.7),
        ss.Parameters.article(sigma=1.0),
        ss.Parameters.article(mu0=6.0, alpha=1e-6),
        ss.Parameters.article(mu0=1.0, alpha=1.0),
    ],
)
def test_onsets_solve_the_equations_of_motion_within_their_error(p: ss.Parameters) -> None:
    found = flutter.flutter_onsets(p, damping=False)
    assert len(found) >= 1
    assert (found.mu0 == float(p.mu0)).all()
    with mpmath.workdps(110):
        values = {
            name: mpmath.mpf(float(getattr(p, name)))
            for name in ("mu0", "kappa", "alpha", "sigma", "beta")
        }
        for i in range(len(found)):
            start = [mpmath.mpf(float(value[i])) for value in (found.x, found.y, found.theta0)]
            x, y, theta0 = mpmath.findroot(_residuals(values), start, tol=1e-60)
            along, across = mpmath.cos(theta0) - x, mpmath.sin(theta0) - y
            true = {
                "theta0": theta0,
                "x": x,
                "y": y,
                "theta": mpmath.atan2(across, along),
                "L": mpmath.hypot(along, across),
            }
            assert found.error[i] < 1e-15
            for name, value in true.items():
                assert abs(float(getattr(found, name)[i]) - value) <= found.error[i] * max(
                    1, abs(value)
                ), name


# -----------------------------------------------------------------------------------------------
# completeness


@pytest.mark.thorough
def test_two_onsets_are_told_apart_down_to_the_last_float() -> None:
    """At the lowest friction with flutter two onsets are born; one float below there is none."""
    p = ss.Parameters.article(alpha=0.7)
    low, high = 0.40, 0.41
    assert len(ss.flutter_onsets(p.replace(mu0=low), damping=False)) == 0
    while math.nextafter(low, 1.0) < high:
        middle = 0.5 * (low + high)
        low, high = (
            (low, middle)
            if len(ss.flutter_onsets(p.replace(mu0=middle), damping=False))
            else (middle, high)
        )
    found = ss.flutter_onsets(p.replace(mu0=high), damping=False)
    assert len(found) == 2
    assert found.side.tolist() == [1, -1]
    assert 0 < np.diff(found.theta0)[0] < 1e-6


def test_nothing_flutters_without_friction() -> None:
    """K is symmetric. With α = 2, σ = L = 1 its two eigenvalues coincide, which is no onset of
    anything.
    """
    for alpha in (0.0, 0.7, 2.0):
        assert (
            len(
                ss.flutter_onsets(
                    ss.Parameters(mu0=0.0, kappa=0.007, alpha=alpha, sigma=1.0, beta=0.0),
                    damping=False,
                )
            )
            == 0
        )


# ------------------------------------------------------------------------------------------------
# degenerate


def test_an_onset_at_90_degrees_of_the_spring() -> None:
    """cos θ₀ = 4/5, sin θ₀ = 3/5, θ = π/2: K₁₁ = K₂₂, α cos θ₀ + μ₀ (sin θ₀ − L) = 0 and F_y = 0
    give L, μ₀ and κ by hand.
    """
    onsets = exact_onsets(Fraction(8, 7), Fraction(17, 5), 2, 2, 0)
    (onset,) = (onset for onset in onsets if middle_of(onset.theta) == math.pi / 2)
    assert middle_of(onset.parameters[0]) == pytest.approx(math.atan2(3, 4), abs=1e-15)
    assert middle_of(onset.L) == 2.0
    assert onset.side in (-1, 1)


@pytest.mark.parametrize(("cosine", "L"), [(1, Fraction(11, 10)), (-1, Fraction(3, 2))])
def test_an_onset_at_exactly_0_or_180_degrees_is_outside(cosine: int, L: Fraction) -> None:
    """sin θ₀ = 0, cos θ = −4/5, σ = 1 and α − β − 1 = −1 leave μ₀ to the discriminant, and α and κ
    to the two balances.
    """
    c, s, difference = Fraction(-4, 5), Fraction(3, 5), -1
    mu0 = -(1 + 2 * L * difference * (c * c - s * s) + (difference * L) ** 2) / (4 * L * s * c)
    alpha = (c * (L - 1) + mu0 * L * s) / (cosine - c * L)
    kappa = ((alpha - difference + 1) * L - 1) * s
    values = mu0, kappa, alpha, 1, alpha - difference - 1
    near = sorted(
        len(exact_onsets(values[0], values[1] * (1 + way * Fraction(1, 10**9)), *values[2:]))
        for way in (-1, 1)
    )
    assert near[1] == near[0] + 1
    assert len(exact_onsets(*values)) == near[0]


def test_without_alpha_an_onset_at_exactly_90_degrees_is_a_touch() -> None:
    """cos θ = −12/13, L = 25/9 and sin θ₀ = 1, found by a search over rationals; θ₀ and π − θ₀ have
    the same states.
    """
    values = Fraction(33800, 5277), Fraction(464648, 1852227), 0, Fraction(4225, 15831), 0
    at_90 = [
        onset
        for onset in exact_onsets(*values)
        if abs(middle_of(onset.parameters[0]) - math.pi / 2) < 1e-9
    ]
    assert len(at_90) == 1
    assert middle_of(at_90[0].parameters[0]) == math.pi / 2
    assert middle_of(at_90[0].theta) == pytest.approx(math.atan2(5, -12), abs=1e-15)
    assert at_90[0].side == 0
    # Next to it two onsets, or none.
    near = [
        len(exact_onsets(values[0] * (1 + way * Fraction(1, 10**9)), *values[1:]))
        for way in (-1, 1)
    ]
    assert sorted(np.subtract(near, len(exact_onsets(*values)))) == [-1, 1]


def test_an_onset_beside_one_other_equilibrium_is_not_believed() -> None:
    """There are one or three; (3 t − 1) (3 t − 5) (t² + 1) has two real roots."""
    quartic, t, below = (
        tuple(balls.exact(Fraction(one, 3)) for one in each)
        for each in ((15, -54, 42, -54, 27), (1,), (-3,))
    )
    with pytest.raises(balls.UndecidedSign, match="1 there"):
        flutter.rank(quartic, *t, *below, 16)


def test_no_onset_is_a_fold() -> None:
    """f′ = L det K > 0, and the Jacobian J that side is taken from is f′."""
    rng = np.random.default_rng(3)
    for _ in range(20):
        p = random_fluttering(rng)
        found = ss.flutter_onsets(p, damping=False)
        mu0, kappa, alpha, sigma, beta = p.scalars("mu0", "kappa", "alpha", "sigma", "beta")
        c, s, c0, s0 = (
            np.cos(found.theta),
            np.sin(found.theta),
            np.cos(found.theta0),
            np.sin(found.theta0),
        )
        slope = kernel.f_slope(
            c, s, *kernel.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)
        )
        _, J = stability.flutter_crossing(c, s, found.L, c0, s0, mu0, alpha, sigma, beta)
        assert (slope > 0).all()
        np.testing.assert_allclose(J, slope, rtol=1e-9)
        assert not (found.branch == 1).any()


# ------------------------------------------------------------------------------------------------
# boundary


@pytest.mark.thorough
@pytest.mark.parametrize(
    "changes",
    [
        {"alpha": 0.7},
        {"sigma": 1.0},
        {"alpha": 1.3, "sigma": 0.32},
        {"alpha": 0.0, "beta": 0.3},
        {"alpha": 0.0, "sigma": 0.7},
    ],
)
def test_the_boundary_has_every_onset_once_at_each_friction(changes: dict[str, float]) -> None:
    p = ss.Parameters.article(**changes)
    along = ss.kang_nam.flutter_boundary(p)
    points = np.stack([along.theta0, along.theta], axis=-1)
    assert len(np.unique(points, axis=0)) == len(points)
    for mu0 in (0.03, 0.45, 0.75, 1.3, 6.0, 30.0):
        found = ss.flutter_onsets(p.replace(mu0=mu0), damping=False)
        same = along.curve[1:] == along.curve[:-1]
        above = along.mu0 > mu0
        crossings = np.flatnonzero(same & (above[1:] != above[:-1]))
        assert len(crossings) == len(found), mu0
        between = np.sort(0.5 * (along.theta0[crossings] + along.theta0[crossings + 1]))
        np.testing.assert_allclose(between, found.theta0, atol=0.02)


@pytest.mark.thorough
def test_boundary_points_are_on_the_boundary_to_rounding() -> None:
    for changes in ({"alpha": 0.7}, {"sigma": 1.0}, {"alpha": 0.0, "sigma": 0.7}):
        p = ss.Parameters.article(**changes)
        found = ss.kang_nam.flutter_boundary(p, n=300)
        for i in np.flatnonzero((found.mu0 < 20) & (found.count > 0))[::20]:
            exact = ss.flutter_onsets(p.replace(mu0=found.mu0[i]), damping=False)
            # Loose, since an onset is ill-conditioned in θ₀ where the boundary has a level of
            # friction for a tangent.
            assert (
                np.hypot(exact.theta0 - found.theta0[i], exact.theta - found.theta[i]).min(
                    initial=np.inf
                )
                < 1e-6
            )
            j = int(np.argmin(np.abs(exact.theta0 - found.theta0[i])))
            assert (exact.branch[j], exact.count[j]) == (found.branch[i], found.count[i])
