"""Folds and onsets of models that are degenerate by symmetry, or whose forces have no potential."""

from fractions import Fraction

import numpy as np
import pytest

import spragsym as ss
from spragsym.statics import stability
from spragsym.statics.balance import Balance
from tests.oracles.user_pages import model_of, shipped_page
from tests.support import few


@pytest.mark.thorough
@pytest.mark.parametrize("vary", ["sigma", "alpha_a"])
@pytest.mark.parametrize("theta0", few([0.7, 1.0, np.pi / 2], 0.7))
def test_a_trolley_that_nothing_pulls_along_the_belt_has_no_folds_along_its_stiffnesses(
    vary, theta0
):
    # Without friction and α the forces along the belt add up to α_a x_a = 0, and σ (L − 1) cos θ =
    # 0 is left: an unstressed spring, whatever its stiffness, or an upright one with L − 1 = (sin
    # θ₀ − 1 + κ)/(1 + σ): κ alone changes its sign.
    model = ss.load("trolley")
    p = model.Parameters(mu0=0.0, alpha=0.0, theta0=theta0)
    for found in (ss.folds(p, vary), ss.flutter_onsets(p, vary)):
        assert (found.decided, len(found)) == (True, 0)
        assert not any("undecided" in text for text in found.remarks)


@pytest.mark.thorough
def test_a_force_without_a_potential_can_bring_flutter_without_friction():
    # At V = 0 there is no friction, but its slope damps x. A pair crosses where y moves alone: K₁₂
    # K₂₁ = (P − σ/2)(−P − σ/2) = 0.
    text = shipped_page(
        "mode_coupling",
        (
            "V = page",
            'P = page.parameter("P", "N/m", "stiffness of a force that turns with the place", '
            '">= 0", 0.0)\nV = page',
        ),
        (
            "page.force(0, -F_L, at=(x, y))",
            "page.force(0, -F_L, at=(x, y))\npage.force(-P * y, P * x, at=(x, y))",
        ),
        (", at_rest=mu0)", ")"),
    )
    model = model_of(text, "follower")
    assert not model.about["symmetric"]
    found = ss.flutter_onsets(model.Parameters(V=0.0, sigma=0.5), "P")
    assert found.decided
    assert found.kind.tolist() == ["hopf"]
    assert abs(found.P[0] - 0.25) < 1e-12
    assert abs(found.omega[0] - np.sqrt(1.25)) < 1e-12


@pytest.mark.thorough
def test_flutter_begins_where_exact_arithmetic_says_so():
    # Of the linear model K is rational in its parameters: so is the discriminant whose sign tells
    # flutter from rest.
    rng = np.random.default_rng(3)
    alpha, sigma = rng.integers(8, 64, 40) / 32, rng.integers(1, 64, 40) / 32
    threshold = ((1 - alpha) ** 2 + sigma**2) / (2 * sigma)
    mu0 = threshold + np.arange(-4, 5)[:, None] * np.spacing(threshold)
    model = ss.load("mode_coupling")
    eq = ss.equilibria(model.Parameters(mu0=mu0, alpha=alpha, sigma=sigma))
    assert eq.complete
    assert (eq.count == 1).all()
    for place in np.ndindex(mu0.shape):
        a, s, mu = (
            Fraction(float(value)) for value in (alpha[place[1]], sigma[place[1]], mu0[place])
        )
        exact = (a - 1) ** 2 - 4 * (mu - s / 2) * s / 2
        assert (eq.undamped[place][0] == ss.EquilibriumType.FLUTTER) == (exact < 0)
        assert eq.marginal[place][0] == (exact == 0)


@pytest.mark.thorough
def test_the_sign_of_a_slope_is_known_where_the_slope_is_too_small_for_floats():
    # dμ/dv = μ₀ d e^(−d V) is never 0, and Stribeck's with μ_k = 0 is e^(−V/v_s) times what is 0 at
    # one v_s only, beyond 10.
    article = ss.load("kang_nam").search
    for vary in ("V", "d"):
        found = ss.flutter_onsets(article.Parameters(theta0=2.5, V=13.2, d=107.8), vary)
        assert (found.decided, len(found)) == (True, 0)
    stribeck = ss.load("stribeck")
    p = stribeck.Parameters(theta0=1.0, mu_k=0.0)
    found = ss.flutter_onsets(p, "v_s")
    assert found.decided
    assert not any("undecided" in text for text in found.remarks)
    _crosses(stribeck, p, found, "v_s")


@pytest.mark.thorough
def test_an_onset_that_more_digits_do_not_prove_is_kept():
    # Found in a random attack: a regular root, known to 1.1e-12, was given up for a box of width
    # 4e-4.
    model = ss.load("damped")
    p = model.Parameters(
        theta0=2.9157543051574755,
        mu0=0.43699156516387977,
        kappa=0.15847075823454923,
        alpha=0.016250342603733297,
        sigma=0.049769325988967605,
        beta=0.2578522662237829,
        zeta_x=0.18676578516369519,
        zeta_y=0.0016447809758024315,
        V=0.06916325233881838,
        d=0.4435031872587287,
    )
    found = ss.flutter_onsets(p, "zeta_s")
    assert (found.decided, len(found)) == (True, 2)
    _crosses(model, p, found, "zeta_s")


def _crosses(model, p, found, vary):
    """At every onset two roots λ of some state change the sign of their real part."""
    for at in getattr(found, vary):
        unstable = []
        for factor in (1 - 1e-4, 1 + 1e-4):
            beside = p.replace(**{vary: float(at * factor)})
            eq = ss.equilibria(beside)
            states = np.array([getattr(eq, name) for name in model.coordinates])
            given = np.array(
                [[float(getattr(beside, name))] * states.shape[1] for name in model.parameters]
            )
            parts = stability.linearization(Balance(model, True), states, given)
            unstable.append((stability.roots(*parts).real > 0).sum(axis=-1))
        assert sorted(np.abs(unstable[1] - unstable[0]).tolist())[-1] == 2


#: f sin φ − g cos φ + a sin φ cos φ = 0 with a = r² − u² − v² has folds where f^(2/3) + g^(2/3) =
#: |a|^(2/3): on a circle about 0.
CIRCLE = '''"""A rod whose folds lie on a circle in the plane of two parameters."""
from spragsym.derive.model import Page, cos, sin

page = Page("A rod whose folds lie on a circle.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
r = page.parameter("r", "1", "without it two states are left", "> 0", 0.7)
u = page.parameter("u", "1", "one of two", "real", 0.0)
v = page.parameter("v", "1", "the other", "real", 0.0)
phi = page.coordinate("phi", "rad", "angle")
page.kinetic(m * l**2 * page.rate(phi) ** 2 / 2)
page.potential(-k * l**2 * (cos(phi) + 2 * sin(phi) + 25 * (r**2 - u**2 - v**2) * cos(2 * phi)) / 100)
'''


@pytest.fixture(scope="module")
def circle():
    return model_of(CIRCLE, "circle")


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("u", "v", "angle"),
    [
        ((-5.5, 2.5), (-2.5, 5.5), 2 * np.pi),
        ((0.9, 5.0), (-4.0, 3.0), 2 * np.arccos(0.9)),
        ((-4.0, 3.0), (0.9, 5.0), 2 * np.arccos(0.9)),
        ((0.7, 5.0), (0.7, 4.0), np.arccos(0.7) - np.arcsin(0.7)),
    ],
)
def test_a_curve_of_folds_between_lines_is_seen_however_small(circle, u, v, angle):
    """Whole, or the part of it that a side or a corner of the range cuts off."""
    radius = 1e-3
    r = np.sqrt(radius**2 + (0.01 ** (2 / 3) + 0.02 ** (2 / 3)) ** 1.5)
    between = {"u": (radius * u[0], radius * u[1]), "v": (radius * v[0], radius * v[1])}
    found = ss.bifurcation_set(circle.Parameters(r=r), ("u", "v"), 3, between=between)
    assert found.complete
    (curve,) = found.curves
    np.testing.assert_allclose(np.hypot(curve.u, curve.v), radius, rtol=1e-6)
    turned = np.unwrap(np.arctan2(curve.v, curve.u))
    assert abs(turned[-1] - turned[0]) == pytest.approx(angle, rel=1e-4)
