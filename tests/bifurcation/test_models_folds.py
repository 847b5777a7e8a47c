"""Folds and onsets of models that are degenerate by symmetry, or whose forces have no potential."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

import spragsym as ss
from spragsym.models.mechanics.balance import Balance
from spragsym.models.statics import stability
from tests.support import few, model_of, shipped_page


@pytest.mark.thorough
@pytest.mark.parametrize("vary", ["sigma", "alpha_a"])
@pytest.mark.parametrize("theta0", few([0.7, 1.0, np.pi / 2], 0.7))
def test_a_trolley_that_nothing_pulls_along_the_belt_has_no_folds_along_its_stiffnesses(vary, theta0):
    # Without friction and α the forces along the belt add up to α_a x_a = 0, and σ (L − 1) cos θ = 0 is left: an unstressed
    # spring, whatever its stiffness, or an upright one with L − 1 = (sin θ₀ − 1 + κ)/(1 + σ): κ alone changes its sign.
    model = ss.load("trolley")
    p = model.Parameters(mu0=0.0, alpha=0.0, theta0=theta0)
    for found in (ss.folds(p, vary), ss.flutter_onsets(p, vary)):
        assert found.decided
        assert len(found) == 0
        assert not any("undecided" in text for text in found.remarks)


@pytest.mark.thorough
def test_the_pitchfork_of_a_trolley_that_nothing_pulls_along_the_belt():
    model = ss.load("trolley")
    found = ss.folds(model.Parameters(mu0=0.0, alpha=0.0, theta0=1.0, sigma=0.3), "kappa")
    assert found.decided
    assert found.kind.tolist() == ["pitchfork"]
    assert abs(found.kappa[0] - (1 - np.sin(1.0))) < 1e-12


@pytest.mark.thorough
def test_a_force_without_a_potential_can_bring_flutter_without_friction():
    # At V = 0 there is no friction, but its slope damps x. A pair crosses where y moves alone: K₁₂ K₂₁ = (P − σ/2)(−P − σ/2) = 0.
    text = shipped_page(
        "mode_coupling",
        ("V = page", 'P = page.parameter("P", "N/m", "stiffness of a force that turns with the place", ">= 0", 0.0)\nV = page'),
        ("page.force(0, -F_L, at=(x, y))", "page.force(0, -F_L, at=(x, y))\npage.force(-P * y, P * x, at=(x, y))"),
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
    # Of the linear model K is rational in its parameters: so is the discriminant whose sign tells flutter from rest.
    rng = np.random.default_rng(3)
    alpha, sigma = rng.integers(8, 64, 40) / 32, rng.integers(1, 64, 40) / 32
    threshold = ((1 - alpha) ** 2 + sigma**2) / (2 * sigma)
    mu0 = threshold + np.arange(-4, 5)[:, None] * np.spacing(threshold)
    model = ss.load("mode_coupling")
    eq = ss.equilibria(model.Parameters(mu0=mu0, alpha=alpha, sigma=sigma))
    assert eq.complete
    assert (eq.count == 1).all()
    for place in np.ndindex(mu0.shape):
        a, s, mu = (Fraction(float(value)) for value in (alpha[place[1]], sigma[place[1]], mu0[place]))
        exact = (a - 1) ** 2 - 4 * (mu - s / 2) * s / 2
        assert (eq.stability[place][0] == ss.Stability.FLUTTER) == (exact < 0)
        assert eq.marginal[place][0] == (exact == 0)


@pytest.mark.thorough
def test_two_states_beside_a_fold_differ_by_the_proved_sign_of_their_stiffness():
    model = ss.load("kang_nam").search
    fold = ss.folds(model.Parameters(theta0=1.0), "mu0", between={"mu0": (0.0, 2.0)})
    for at in fold.mu0:
        values = at + np.array([-8, -4, -2, 2, 4, 8]) * np.spacing(at) * 2.0**8
        eq = ss.equilibria(model.Parameters(theta0=1.0, mu0=values))
        assert eq.complete
        assert sorted(set(eq.count.tolist())) == [int(eq.count.min()), int(eq.count.min()) + 2]
        assert not eq.marginal.any()
        more = eq.count == eq.count.max()
        signs = np.where(eq.stability == ss.Stability.DIVERGENT, -1, 1) * (eq.stability > 0)
        assert (signs[more].sum(axis=-1) == signs[~more].sum(axis=-1).max()).all()


@pytest.mark.thorough
def test_three_coordinates_flutter_where_sturm_counts_too_few_real_roots():
    rng = np.random.default_rng(4)
    model = ss.load("trolley")
    changes = {"theta0": rng.uniform(0.2, 2.9, 60), "mu0": rng.uniform(0.0, 3.0, 60), "nu_a": rng.uniform(0.05, 2.0, 60)}
    eq = ss.equilibria(model.Parameters(**changes))
    seen = set()
    for place, slot in np.argwhere(eq.stability > 0):
        q = [sp.Rational(float(getattr(eq, name)[place, slot])) for name in model.coordinates]
        at = {name: sp.Rational(float(np.broadcast_to(getattr(eq.parameters, name), (60,))[place])) for name in model.parameters}
        K = _stiffness_of_trolley(q, at)
        kappa = sp.Symbol("kappa")
        polynomial = sp.Poly((K - kappa * sp.diag(1, 1, at["nu_a"])).det(), kappa)
        real, negative = polynomial.count_roots(), polynomial.count_roots(None, 0)
        code = ss.Stability.FLUTTER if real < 3 else ss.Stability.DIVERGENT if negative else ss.Stability.STABLE
        assert eq.stability[place, slot] == code
        assert not eq.marginal[place, slot]
        seen.add(code)
    assert len(seen) == 3


def _stiffness_of_trolley(q, at):
    """K by hand in rational numbers, from directions to 40 digits."""
    cosine, sine = (sp.Rational(str(function(at["theta0"]).evalf(40))) for function in (sp.cos, sp.sin))
    dx, dy = cosine - q[0] + q[2], sine - q[1]
    length = sp.Rational(str(sp.sqrt(dx**2 + dy**2).evalf(40)))
    c, s, k = dx / length, dy / length, at["sigma"]
    along, across = sp.Matrix([-c, -s, c]), sp.Matrix([s, -c, -s])
    K = k * along * along.T + k * (1 - 1 / length) * across * across.T
    K += sp.diag(at["alpha"], 1 + at["beta"], at["alpha_a"])
    K[0, 1] += at["mu0"]
    return K


@pytest.mark.validate
def test_curves_of_folds_are_smooth_to_their_cusps_and_the_ends_of_the_ranges():
    # The closed forms of the article's model give folds as near to its cusp as we like: none is farther from the drawn line than
    # a printed line is wide.
    model, p = ss.load("kang_nam").search, ss.Parameters.article()
    found = model.bifurcation_set(model.Parameters(theta0=1.0), ("theta0", "mu0"), 12, between={"mu0": (0.0, 2.0)})
    assert found.complete
    lines = [np.array([curve.theta0 / np.pi, curve.mu0 / 2]) for curve in found.curves]
    assert sorted(float(line[1, end]) for line in lines for end in (0, -1)) == [0.0, 0.0, 1.0, 1.0]
    cusp = found.cusps.mu0[0]
    assert any(((curve.mu0 == cusp) & (curve.theta0 == found.cusps.theta0[0])).any() for curve in found.curves)
    for curve in found.curves:  # each point is a fold, or the cusp, in which two have met
        for theta0, mu0 in zip(curve.theta0, curve.mu0, strict=True):
            known = ss.folds(p.replace(theta0=theta0), "mu0").mu0
            assert np.abs(np.append(known, cusp) - mu0).min() < 1e-7 or mu0 == 0.0
        assert np.abs(np.diff(curve.theta0)).max() < 2.1 * np.pi / 12  # no farther than to the next line, but for the steep ends
    steps = np.geomspace(1e-6, 0.3, 25)
    for mu0 in np.concatenate([cusp * (1 + steps), cusp * (1 - steps[steps < 0.9])]):
        for theta0 in ss.folds(p.replace(mu0=float(mu0))).theta0:
            assert min(_distance(np.array([theta0 / np.pi, mu0 / 2]), line) for line in lines) < 3e-4


def _distance(point, line):
    """Of a point from a line through points, shape (2, number)."""
    begin, step = line[:, :-1], np.diff(line, axis=1)
    part = np.clip(((point[:, None] - begin) * step).sum(axis=0) / np.maximum((step**2).sum(axis=0), 1e-300), 0.0, 1.0)
    return np.linalg.norm(begin + part * step - point[:, None], axis=0).min()


@pytest.mark.thorough
def test_the_sign_of_a_slope_is_known_where_the_slope_is_too_small_for_floats():
    # dμ/dv = μ₀ d e^(−d V) is never 0, and Stribeck's with μ_k = 0 is e^(−V/v_s) times what is 0 at one v_s only, beyond 10.
    article = ss.load("kang_nam").search
    for vary in ("V", "d"):
        found = ss.flutter_onsets(article.Parameters(theta0=2.5, V=13.2, d=107.8), vary)
        assert found.decided
        assert len(found) == 0
    stribeck = ss.load("stribeck")
    p = stribeck.Parameters(theta0=1.0, mu_k=0.0)
    found = ss.flutter_onsets(p, "v_s")
    assert found.decided
    assert not any("undecided" in text for text in found.remarks)
    _crosses(stribeck, p, found, "v_s")


@pytest.mark.thorough
def test_an_onset_that_more_digits_do_not_prove_is_kept():
    # Found in a random attack: a regular root, known to 1.1e-12, was given up for a box of width 4e-4.
    model = ss.load("damped")
    p = model.Parameters(
        theta0=2.9157543051574755, mu0=0.43699156516387977, kappa=0.15847075823454923, alpha=0.016250342603733297,
        sigma=0.049769325988967605, beta=0.2578522662237829, zeta_x=0.18676578516369519, zeta_y=0.0016447809758024315,
        V=0.06916325233881838, d=0.4435031872587287,
    )  # fmt: skip
    found = ss.flutter_onsets(p, "zeta_s")
    assert found.decided
    assert len(found) == 2
    _crosses(model, p, found, "zeta_s")


def _crosses(model, p, found, vary):
    """At every onset two roots λ of some state change the sign of their real part."""
    for at in getattr(found, vary):
        unstable = []
        for factor in (1 - 1e-4, 1 + 1e-4):
            beside = p.replace(**{vary: float(at * factor)})
            eq = ss.equilibria(beside)
            states = np.array([getattr(eq, name) for name in model.coordinates])
            given = np.array([[float(getattr(beside, name))] * states.shape[1] for name in model.parameters])
            parts = (np.moveaxis(part, -1, 0) for part in stability.linearization(Balance(model, True), states, given))
            unstable.append((stability.roots(*parts).real > 0).sum(axis=-1))
        assert sorted(np.abs(unstable[1] - unstable[0]).tolist())[-1] == 2


#: f sin φ − g cos φ + a sin φ cos φ = 0 with a = r² − u² − v² has folds where f^(2/3) + g^(2/3) = |a|^(2/3): on a circle about 0.
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
@pytest.mark.parametrize("radius", few([0.03, 1e-3, 1e-5], 1e-3))
@pytest.mark.parametrize(("u", "v", "angle"), [
    ((-5.5, 2.5), (-2.5, 5.5), 2 * np.pi), ((0.9, 5.0), (-4.0, 3.0), 2 * np.arccos(0.9)),
    ((-4.0, 3.0), (0.9, 5.0), 2 * np.arccos(0.9)), ((0.7, 5.0), (0.7, 4.0), np.arccos(0.7) - np.arcsin(0.7)),
])  # fmt: skip
def test_a_curve_of_folds_between_lines_is_seen_however_small(circle, radius, u, v, angle):
    """Whole, or the part of it that a side or a corner of the range cuts off."""
    r = np.sqrt(radius**2 + (0.01 ** (2 / 3) + 0.02 ** (2 / 3)) ** 1.5)
    between = {"u": (radius * u[0], radius * u[1]), "v": (radius * v[0], radius * v[1])}
    found = circle.bifurcation_set(circle.Parameters(r=r), ("u", "v"), 3, between=between)
    assert found.complete
    (curve,) = found.curves
    np.testing.assert_allclose(np.hypot(curve.u, curve.v), radius, rtol=1e-6)
    turned = np.unwrap(np.arctan2(curve.v, curve.u))
    assert abs(turned[-1] - turned[0]) == pytest.approx(angle, rel=1e-4)
