"""Models whose gap is no coordinate, against closed forms: a rod that jams, a pad that rests as the
article's mass does.
"""

import itertools
import math

import mpmath
import numpy as np
import pytest

import spragsym as ss
from tests.support import few

ROD = ss.load("sprag_rod")
PAD = ss.load("pad_on_disc")


@pytest.mark.thorough
@pytest.mark.parametrize("degrees", few([25.0, 40.0], 25.0))
def test_a_stiff_wall_is_jammed_at_the_closed_form(degrees: float) -> None:
    """tan θ₀ = μ: the fold comes to it as the root of the spring's stiffness over the wall's."""
    theta0 = math.radians(degrees)
    away = []
    for kappa in (1e-4, 1e-6, 1e-8):
        found = ss.folds(
            ROD.Parameters(theta0=theta0, kappa=kappa), "mu0", between={"mu0": (0.0, 1.5)}
        )
        assert found.complete
        assert len(found) == 1
        away.append(math.tan(theta0) - float(found.mu0[0]))
        assert abs(math.degrees(float(found.phi[0])) - degrees) < 200 * math.sqrt(kappa)
    assert 0 < away[2] < 2e-4
    assert [one / other for one, other in itertools.pairwise(away)] == pytest.approx(
        [10.0, 10.0], rel=0.05
    )


def test_the_normal_force_below_jamming() -> None:
    """N = k_t ψ/(l (sin θ₀ − μ cos θ₀)), at a stiff wall."""
    theta0, kappa = math.radians(40.0), 1e-9
    p = ROD.Parameters(theta0=theta0, kappa=kappa, mu0=np.array([0.0, 0.3, 0.6, 0.8]))
    eq = ss.equilibria(p)
    assert eq.complete
    phi = np.array([max(row) for row in np.where(np.isnan(eq.phi), -9.0, eq.phi)])
    depth = [float(mpmath.cos(mpmath.mpf(one)) - mpmath.cos(mpmath.mpf(theta0))) for one in phi]
    expected = kappa * 0.1 / (math.sin(theta0) - p.mu0 * math.cos(theta0))
    np.testing.assert_allclose(depth, expected, rtol=1e-4)


@pytest.mark.thorough
def test_folds_of_the_rod_against_its_balance_by_hand() -> None:
    """κ (φ − θ₀ + ψ) = N (sin φ − μ cos φ), N = cos φ − cos θ₀, and its derivative."""
    with mpmath.workdps(30):
        for theta0 in (0.4, 0.9):
            found = ss.folds(ROD.Parameters(theta0=theta0), "mu0", between={"mu0": (0.0, 2.0)})
            assert found.complete
            assert len(found) >= 1
            for phi, mu in zip(found.phi, found.mu0, strict=True):

                def balance(
                    angle: mpmath.mpf, mu: mpmath.mpf, theta0: float = theta0
                ) -> mpmath.mpf:
                    push = mpmath.cos(angle) - mpmath.cos(theta0)
                    spring = mpmath.mpf(0.01) * (angle - theta0 + mpmath.mpf(0.1))
                    return spring - push * (mpmath.sin(angle) - mu * mpmath.cos(angle))

                def slope(angle: mpmath.mpf, mu: mpmath.mpf) -> mpmath.mpf:
                    return mpmath.diff(lambda one: balance(one, mu), angle)

                root = mpmath.findroot(
                    lambda a, b: (balance(a, b), slope(a, b)), (float(phi), float(mu))
                )
                assert abs(root[0] - phi) < 1e-11
                assert abs(root[1] - mu) < 1e-11


@pytest.mark.thorough
def test_the_pad_rests_as_the_mass_of_the_article_on_both_stiffnesses() -> None:
    """The disc is a spring in a row with the contact; the piston adds none, since it hands on its
    force.
    """
    row = 1.0 / (1.0 + 1.0 / 4.0)
    theta0 = np.radians([30.0, 40.0, 49.0, 70.0])
    pad = ss.equilibria(PAD.Parameters(theta0=theta0))
    article = ss.load("kang_nam")
    changed = {name: article.base[name] / row for name in ("kappa", "alpha", "sigma")}
    mass = ss.equilibria(article.Parameters(theta0=theta0, **changed))
    assert pad.complete
    assert pad.count.tolist() == mass.count.tolist()
    for place, count in enumerate(pad.count):
        order, other = np.argsort(pad.x[place, :count]), np.argsort(mass.x[place, :count])
        for name in ("x", "y"):
            np.testing.assert_allclose(
                getattr(pad, name)[place, order],
                getattr(mass, name)[place, other],
                rtol=1e-11,
                atol=1e-14,
            )
        np.testing.assert_allclose(
            pad.w[place, order], mass.y[place, other] * row / 4.0, rtol=1e-11
        )
        np.testing.assert_allclose(
            pad.z[place, order] - pad.y[place, order], -0.007 / 0.5, rtol=1e-11
        )
    ours = ss.folds(PAD.Parameters(), "theta0")
    theirs = ss.folds(article.Parameters(**changed), "theta0")
    np.testing.assert_allclose(np.sort(ours.theta0), np.sort(theirs.theta0), rtol=1e-11)
