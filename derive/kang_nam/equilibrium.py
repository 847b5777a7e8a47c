"""The balance of forces at rest on the moving belt, (12)–(20) and (22)–(25), as one family in n̄.

n̄ = 1 is contact, n̄ = 0 lift-off. ``c, s, L`` are polar coordinates about the spring's anchor: x =
cos θ₀ − L cos θ and y = sin θ₀ − L sin θ. From here on μ₀ stands for the friction coefficient at
steady sliding; that it equals μ₀ (1 − exp(−d V)) exactly is the row ``eq-12`` of the ledger.
"""

from functools import cache

import sympy as sp
from sympy import Expr, Matrix

from ..algebra import Names, Pair
from . import mechanics, unit_circles
from .nomenclature import B, L, M, alpha, beta, c, c0, mu, mu0, n, nbar, p, q, s, s0, sigma, x, y

CONTACT = {nbar: 1}
LIFTOFF = {nbar: 0}

#: The shorthands of the elimination in terms of the parameters.
SHORTHANDS: Names = {
    B: beta + nbar,
    M: mu0 * nbar,
    p: alpha + sigma,
    q: B + sigma,
}
#: Those without another shorthand than B in them.
POLES = {symbol: SHORTHANDS[symbol] for symbol in (p, q)}


def equal(left: Expr, right: Expr) -> bool:
    """Whether two expressions are the same function of θ and θ₀, with p and q spelled out."""
    return unit_circles.equal(left.subs(POLES), right.subs(POLES))


def spell_out(expression: Expr) -> Expr:
    """Replace every shorthand by what it stands for, until only parameters and the state are
    left.
    """
    while expression.free_symbols & SHORTHANDS.keys():
        expression = expression.subs(SHORTHANDS, simultaneous=True)
    return expression


def displacement() -> Names:
    """x and y from the spring's length and direction: (4) and (5)."""
    return {x: c0 - L * c, y: s0 - L * s}


@cache
def balance_cartesian() -> Pair:
    """(12) and (13) in x, y and L: (8) and (9) at rest, with μ₀ for the friction at steady
    sliding.
    """
    rest = {**mechanics.AT_REST, mu: mu0, n: mechanics.contact_family()}
    along, across = (row.subs(rest) for row in mechanics.motion())
    return along, across


@cache
def balance() -> Pair:
    """F_x and F_y in c, s and L: (14) and (15) for n̄ = 1."""
    along, across = (sp.expand(force.subs(displacement())) for force in balance_cartesian())
    return along, across


@cache
def matrix_form() -> tuple[Matrix, Matrix]:
    """D and b of D (cos θ, sin θ)ᵀ = b: (16)–(19), (A10), (A11) and (22), (24), (25), (A12),
    (A13).
    """
    direction = Matrix([c, s])
    forces = Matrix(balance())
    D = forces.jacobian(direction)
    b = -forces.subs({c: 0, s: 0})
    if sp.expand(forces - (D * direction - b)) != sp.zeros(2, 1):
        raise ArithmeticError(
            "the balance of forces is not linear in cos θ and sin θ: (16) has no D and b"
        )
    return D, b
