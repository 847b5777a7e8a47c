"""The algebra's properties at numbers that hypothesis picks."""

import math
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import spragsym as ss
from spragsym.generated import equilibrium, laws

#: What the solver promises, over max(1, |value|).
TOLERANCE = 1e-12

angles = st.floats(0.02, math.pi - 0.02)


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


@pytest.mark.parametrize(
    ("mu0", "alpha", "contact"),
    [(0, 0, True), (0, "0.3", False), ("0.5", 0, False), (0, 1, True)],
    ids=["no friction, no stiffness along the belt", "a = 0 in lift-off", "lift-off without it", "alpha = 1 + beta"],
)
def test_more_digits_where_a_factor_is_even(mu0: int | str, alpha: int | str, contact: bool) -> None:
    """Where one factor of the quartic in t is t² − 1 or another without a linear term."""
    sigma, beta = 1, "0.3" if alpha == "0.3" else 0
    assert ss.precise.equilibria(theta0=1, mu0=mu0, kappa="0.4", alpha=alpha, sigma=sigma, beta=beta, contact=contact, dps=30)
