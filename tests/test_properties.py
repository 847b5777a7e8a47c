"""The algebra's properties at numbers that hypothesis picks."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import spragsym as ss
from spragsym.generated import equilibrium, laws, stability

#: What the solver promises, over max(1, |value|).
TOLERANCE = 1e-12

angles = st.floats(0.02, math.pi - 0.02)
frictions = st.floats(0.0, 3.0)


def positive(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers spread evenly over decades."""
    return st.floats(math.log10(low), math.log10(high)).map(lambda exponent: 10.0**exponent)


@st.composite
def points(draw: st.DrawFn) -> ss.Parameters:
    """A point of the model, limits included."""
    return ss.Parameters(
        theta0=draw(angles),
        mu0=draw(st.just(0.0) | positive(1e-4, 3.0)),
        kappa=draw(positive(1e-4, 1.0)),
        alpha=draw(st.just(0.0) | positive(1e-4, 3.0)),
        sigma=draw(positive(1e-2, 3.0)),
        beta=draw(st.just(0.0) | positive(1e-4, 3.0)),
    )


def states(eq: ss.Equilibria) -> list[tuple[float, float, float, float]]:
    return [tuple(float(getattr(eq, name)[i]) for name in ("theta", "L", "x", "y")) for i in range(int(eq.count))]  # type: ignore[misc]  # a tuple of four


def numbers(p: ss.Parameters) -> tuple[float, ...]:
    """cos θ₀, sin θ₀ and the other five."""
    theta0, *others = p.scalars("theta0", "mu0", "kappa", "alpha", "sigma", "beta")
    return (math.cos(theta0), math.sin(theta0), *others)


@given(points(), st.booleans())
def test_equilibria_balance_on_the_unit_circle(p: ss.Parameters, contact: bool) -> None:
    """The state closes the geometry (4), (5), (cos θ, sin θ) has unit norm, it balances, and lies on its side of y = 0."""
    assume(contact or p.beta > 0 or p.kappa != p.sigma)  # else the mass may sit at the spring's anchor, L = 0, an error
    eq = ss.equilibria(p, contact=contact)
    assert int(eq.count) in ((1, 3) if contact else (0, 1, 2, 3, 4))
    c0, s0, *rest = numbers(p)
    for theta, L, x, y in states(eq):
        scale = max(1.0, L)
        c, s = (c0 - x) / L, (s0 - y) / L
        assert abs(c**2 + s**2 - 1) < 8 * TOLERANCE * scale / L
        residuals = equilibrium.residuals(math.cos(theta), math.sin(theta), L, c0, s0, *rest, int(contact))
        assert max(map(abs, residuals)) < 20 * TOLERANCE * scale * max(1.0, *rest)
        assert L > 0
        assert (y < 0) == contact
        assert math.isclose(laws.spring_length(x, y, c0, s0), L, rel_tol=0, abs_tol=8 * TOLERANCE * scale)


@given(points())
def test_slope_of_f_is_the_determinant(p: ss.Parameters) -> None:
    """L det K = f′ at every equilibrium; so the middle one of three is divergent."""
    eq = ss.equilibria(p)
    c0, s0, mu0, kappa, alpha, sigma, beta = numbers(p)
    coefficients = equilibrium.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)
    for theta, L, _, _ in states(eq):
        K = stability.stiffness(math.cos(theta), math.sin(theta), L, mu0, alpha, sigma, beta, 1)
        _, determinant, _ = stability.invariants(*K[0], *K[1])
        slope = equilibrium.f_slope(math.cos(theta), math.sin(theta), *coefficients)
        size = sum(abs(value) for row in K for value in row) ** 2 * max(1.0, L, 1 / L)
        assert abs(L * determinant - slope) < 100 * TOLERANCE * size
    if int(eq.count) == 3:
        assert eq.stability[1] == ss.Stability.DIVERGENT


@given(st.fractions(-1, 1), st.fractions(-1, 1), *[st.fractions(Fraction(1, 100), 3) for _ in range(5)], st.sampled_from([0, 1]))
def test_mirror_symmetry_is_exact(
    half: Fraction, half0: Fraction, mu0: Fraction, kappa: Fraction, alpha: Fraction, sigma: Fraction, beta: Fraction, nbar: int
) -> None:
    """(θ, θ₀, μ) → (π − θ, π − θ₀, −μ) turns f into −f and leaves f′; in rational numbers, without rounding."""
    (c, s), (c0, s0) = ((((1 - h * h) / (1 + h * h)), 2 * h / (1 + h * h)) for h in (half, half0))
    others = (kappa, alpha, sigma, beta, nbar)
    here = equilibrium.f_coefficients(c0, s0, mu0, *others)
    there = equilibrium.f_coefficients(-c0, s0, -mu0, *others)
    assert equilibrium.f(-c, s, *there) == -equilibrium.f(c, s, *here)
    assert equilibrium.f_slope(-c, s, *there) == equilibrium.f_slope(c, s, *here)


@pytest.mark.thorough
@given(points())
def test_without_friction_the_mirror_image_is_a_solution(p: ss.Parameters) -> None:
    """θ₀ → π − θ₀ at μ₀ = 0 mirrors all states: x → −x, y as it was."""
    p = p.replace(mu0=0.0)
    eq, mirrored = ss.equilibria(p), ss.equilibria(p.replace(theta0=math.pi - float(p.theta0)))
    assume(not eq.fold and not mirrored.fold)
    assume(int(eq.count) == int(mirrored.count))  # π − θ₀ is rounded: next to a fold that decides
    n = int(eq.count)
    determinant = _slopes(p, eq)
    for i in range(n):
        # What a rounding of θ₀ by 1e-16 does to a root is that over the slope of f.
        loose = 10 * TOLERANCE + 1e-14 / max(determinant[i], 1e-300)
        assume(loose < 1e-6)
        np.testing.assert_allclose(-mirrored.x[n - 1 - i], eq.x[i], rtol=0, atol=loose * max(1, abs(eq.x[i])))
        np.testing.assert_allclose(mirrored.y[n - 1 - i], eq.y[i], rtol=0, atol=loose)


def _slopes(p: ss.Parameters, eq: ss.Equilibria) -> list[float]:
    coefficients = equilibrium.f_coefficients(*numbers(p), 1)
    return [abs(equilibrium.f_slope(math.cos(theta), math.sin(theta), *coefficients)) for theta, *_ in states(eq)]


@given(angles, positive(1e-3, 1.0), st.floats(1e-2, 3.0), st.floats(1e-3, 3.0))
def test_contact_and_lift_off_meet_where_y_is_zero(theta: float, kappa: float, sigma: float, beta: float) -> None:
    """At y = 0 the contact force is 0: f of contact and of lift-off agree up to the factors q that they carry."""
    s0 = math.sin(theta) + kappa / sigma  # puts the mass on the belt: y = (σ (s₀ − s) − κ)/q = 0
    c, s, c0 = math.cos(theta), math.sin(theta), 0.3
    for mu0, alpha in ((0.0, 0.5), (0.7, 0.0), (2.0, 1.5)):
        in_contact = equilibrium.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)
        lifted = equilibrium.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 0)
        left = equilibrium.f(c, s, *in_contact) / (beta + 1 + sigma)
        right = equilibrium.f(c, s, *lifted) / (beta + sigma)
        assert math.isclose(left, right, rel_tol=1e-9, abs_tol=1e-11 * (1 + s0) * (1 + kappa + sigma + beta))
        L, _, y = equilibrium.state(c, s, c0, s0, kappa, sigma, beta, 1)
        assert abs(y) < 1e-12 * (1 + s0)
        assert math.isclose(L, equilibrium.state(c, s, c0, s0, kappa, sigma, beta, 0)[0], rel_tol=1e-12)


@given(positive(1e-2, 1e2), positive(1e-2, 1e2), positive(1e-2, 1e2), angles, frictions)
def test_other_units_change_nothing(mass: float, length: float, time: float, theta0: float, mu0: float) -> None:
    """The same brake in grams, inches and hours is the same dimensionless model, and its results scale back."""
    force = mass * length / time**2
    brake = dict(m=0.4, k=1e5, k_x=7e3, k_y=2e4, k_c=1e6, F_L=350.0, L_0=0.05, V=20.0, d=1.0)
    units = dict(
        m=mass, k=force / length, k_x=force / length, k_y=force / length, k_c=force / length, F_L=force, L_0=length,
        V=length / time, d=time / length,
    )  # fmt: skip
    one = ss.PhysicalParameters(**brake, theta0=theta0, mu0=mu0)
    other = ss.PhysicalParameters(**{name: value * units[name] for name, value in brake.items()}, theta0=theta0, mu0=mu0)
    for name in ("kappa", "alpha", "sigma", "beta"):
        np.testing.assert_allclose(getattr(other.dimensionless(), name), getattr(one.dimensionless(), name), rtol=1e-14)
    for name, unit in (("length", length), ("time", time), ("force", force)):
        assert math.isclose(getattr(other.scales, name), getattr(one.scales, name) * unit, rel_tol=1e-14)
    for name in ("V", "d"):
        assert math.isclose(other.belt()[name], one.belt()[name], rel_tol=1e-13)


@given(points(), positive(1e-2, 1e2))
def test_stiffer_by_one_factor_is_the_same_shape(p: ss.Parameters, factor: float) -> None:
    """f is homogeneous of degree two in the stiffnesses k, k_x, k_y, k_c and the preload together."""
    c0, s0, mu0, kappa, alpha, sigma, beta = numbers(p)
    balance = equilibrium.residuals(0.6, 0.8, 0.9, c0, s0, mu0, kappa, alpha, sigma, beta, 1)
    # n̄ stands where k_c/k_c stands: scaling it with the rest scales every force.
    scaled = equilibrium.residuals(0.6, 0.8, 0.9, c0, s0, mu0, *(factor * v for v in (kappa, alpha, sigma, beta)), factor)
    np.testing.assert_allclose(scaled, np.multiply(balance, factor), rtol=1e-11, atol=1e-11 * factor)


@given(points())
def test_more_digits_agree(p: ss.Parameters) -> None:
    """The error bound holds against 30 digits, for the same float64 parameters."""
    eq = ss.equilibria(p)
    exact = ss.precise.equilibria(p, dps=30)
    assert len(exact) == int(eq.count)
    for i, state in enumerate(exact):
        for name in ("theta", "L", "x", "y"):
            value = getattr(state, name)
            assert abs(getattr(eq, name)[i] - value) <= eq.error[i] * max(1, abs(value))
        assert eq.stability[i] == state.stability


@given(points())
def test_surface_gives_the_friction_back(p: ss.Parameters) -> None:
    """The explicit surface through an equilibrium has the friction that the equilibrium was solved for."""
    eq = ss.equilibria(p)
    _, _, mu0, kappa, alpha, sigma, beta = numbers(p)
    slopes = _slopes(p, eq)
    for (theta, _, _, y), error, slope in zip(states(eq), eq.error, slopes, strict=False):
        lever = (beta + 1 + sigma) * math.sin(theta) * abs(y)  # ∂f/∂μ₀
        loose = (slope * (error + 1e-15) * math.pi + 1e-13 * (1 + mu0) * (1 + alpha + sigma + beta + kappa) ** 2) / lever
        assume(loose < 1e-3)
        found = ss.surface(p, theta, float(p.theta0))
        assert abs(found.mu0 - mu0) <= loose


@pytest.mark.parametrize(
    ("mu0", "alpha", "contact"),
    [(0, 0, True), (0, "0.3", False), ("0.5", 0, False), (0, 1, True)],
    ids=["no friction, no stiffness along the belt", "a = 0 in lift-off", "lift-off without it", "alpha = 1 + beta"],
)
def test_more_digits_where_a_factor_is_even(mu0: int | str, alpha: int | str, contact: bool) -> None:
    """Where one factor of the quartic in t is t² − 1 or another without a linear term."""
    sigma, beta = 1, "0.3" if alpha == "0.3" else 0
    assert ss.precise.equilibria(theta0=1, mu0=mu0, kappa="0.4", alpha=alpha, sigma=sigma, beta=beta, contact=contact, dps=30)
