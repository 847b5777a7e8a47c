"""The constant-angle model of the article's reference [17], its poles, and the critical friction
μ_cr.

The inclined spring keeps the angle θ₀ however the mass moves, so its stretch is the displacement
along that direction.
"""

from functools import cache

import sympy as sp
from sympy import Matrix

from ..algebra import Pair, Row
from ..factors import factored
from . import unit_circles, mechanics, stability
from .nomenclature import L, T, c, c0, kappa, mu, mu0, nbar, s, s0, sigma, x, y
from .unit_circles import ascending


@cache
def balance() -> Matrix:
    """Forces at steady sliding in contact, with the inclined spring's energy at a constant
    direction; dimensionless.
    """
    stretch = x * c0 + y * s0
    energy = sigma * stretch**2 / 2
    page = mechanics.of_page()
    along, across = (
        mechanics.in_article(page, row).subs({mu: mu0, nbar: 1}) for row in page.residuals_apart
    )
    return Matrix([along + sp.diff(energy, x), across + sp.diff(energy, y)])


@cache
def stiffness() -> Matrix:
    """The matrix of the linear balance."""
    return balance().jacobian([x, y]).applyfunc(factored)


@cache
def equilibrium() -> Pair:
    """x and y; both have the pole det = 0."""
    solution = sp.solve(list(balance()), [x, y], dict=True)[0]
    return factored(solution[x]), factored(solution[y])


@cache
def pole_friction() -> sp.Expr:
    """μ₀ at which the displacement is infinite, as a function of T = tan θ₀."""
    determinant = stiffness().det()
    on_tangent = sp.cancel(determinant.subs(s0, T * c0) / c0**2).subs(c0, 1 / sp.sqrt(1 + T**2))
    (friction,) = sp.solve(sp.expand(sp.simplify(on_tangent)), mu0)
    return sp.collect(sp.cancel(friction), T)


@cache
def pole_quadratic() -> Row:
    """Coefficients, lowest power first, of the quadratic in tan θ₀ whose roots are the poles."""
    numerator = sp.fraction(sp.cancel(pole_friction() - mu0))[0]
    return tuple(map(factored, ascending(numerator, T)))


@cache
def critical_friction_squared() -> sp.Expr:
    """μ_cr²: the discriminant of :func:`pole_quadratic` is σ² (μ₀² − μ_cr²). Below μ_cr there is no
    pole.
    """
    e0, e1, e2 = pole_quadratic()
    discriminant = sp.expand(e1**2 - 4 * e0 * e2)
    return factored(sp.solve(discriminant, mu0**2)[0])


def identities() -> dict[str, bool]:
    """The linear model is the nonlinear one, linearized about the undeformed state."""
    undeformed = {L: 1, c: c0, s: s0, nbar: 1}
    gap = stability.stiffness().subs(undeformed) - stiffness()
    state = Matrix(equilibrium())
    return {
        "its stiffness is K at x = y = 0": all(unit_circles.equal(entry, 0) for entry in gap),
        "its displacement solves K (x, y) = (0, −κ)": all(
            unit_circles.equal(entry, 0) for entry in stiffness() * state + Matrix([0, kappa])
        ),
    }
