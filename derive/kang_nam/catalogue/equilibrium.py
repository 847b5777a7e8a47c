"""Functions of the balance of forces: D, b, the quartics, f, the state."""

import sympy as sp

from ...algebra import Names, Pair, Row
from ...emit.function import Function, Module, rows
from ...factors import factored
from .. import catastrophe, elimination, equilibrium
from ..nomenclature import (
    p,
    q,
    L,
    M,
    alpha,
    b1,
    b2,
    beta,
    c,
    c0,
    fa,
    fd,
    kappa,
    mu0,
    nbar,
    s,
    sigma,
    x,
    y,
)
from .arrangement import (
    ANGLE,
    ANGLE0,
    F_COEFFICIENTS,
    POINT,
    STIFFNESS,
    WITHOUT_FRICTION,
    require_same,
    shorthands,
)


def _quartic(case: dict[sp.Symbol, int]) -> tuple[Row, Names]:
    """The quartic in L in the arrangement that keeps its squares together, and its shorthands."""
    arranged = (
        sigma**2 * (b1**2 + b2**2 - sigma**2),
        2 * sigma * (M * b1 * b2 - q * (b1**2 - sigma**2) - p * (b2**2 - sigma**2)),
        (M * b2 - q * b1) ** 2 + p**2 * b2**2 - sigma**2 * (p**2 + q**2 + 4 * p * q),
        2 * sigma * p * q * (p + q),
        -((p * q) ** 2),
    )
    require_same("quartic in L", arranged, elimination.quartic_in_L())
    _, b = equilibrium.matrix_form()
    names = {
        **shorthands(case),
        **elimination.RIGHT_SIDE,
    }
    require_same("right side of (16)", (names[b1], names[b2]), tuple(b))
    if case[nbar] == 0:
        arranged = tuple(value.subs(M, 0) for value in arranged)
        names[b1] = names[b1].subs(M, 0)
        del names[M]
    return arranged, names


def _matrix(D: sp.Matrix, case: dict[sp.Symbol, int]) -> tuple[Row, ...]:
    """D of (18) or (24) with p and q kept together."""
    require_same("D", tuple(elimination.MATRIX), tuple(D))
    return rows(elimination.MATRIX if case[nbar] else elimination.MATRIX.subs(M, 0))


def module() -> Module:
    D, b = equilibrium.matrix_form()
    contact, liftoff = equilibrium.CONTACT, equilibrium.LIFTOFF
    contact_quartic, contact_names = _quartic(contact)
    liftoff_quartic, liftoff_names = _quartic(liftoff)
    state = elimination.state()
    along, across = equilibrium.balance()
    f, trig = elimination.f_form, elimination.f_coefficients()
    at_angle = (*ANGLE, *F_COEFFICIENTS)
    r0, r1, r2, _ = elimination.resolvent_cubic()
    return Module(
        "equilibrium",
        "The balance of forces at steady sliding (n̄ = 1) and in lift-off (n̄ = 0), and the "
        "polynomials that hold its roots.",
        (
            Function(
                "contact_matrix",
                "D of the balance in contact.",
                "(17), (18)",
                (L, mu0, *STIFFNESS),
                _matrix(D, contact),
                "((D11, D12), (D21, D22))",
                shorthands(contact),
            ),
            Function(
                "contact_vector",
                "b of the balance in contact.",
                "(19), (A10), (A11)",
                (*ANGLE0, mu0, kappa, alpha, beta),
                tuple(b.subs(contact)),
                "b1, b2",
            ),
            Function(
                "contact_quartic",
                "Coefficients of c0 + c1 L + c2 L² + c3 L³ + c4 L⁴ = 0 in contact.",
                "(21), (A1)–(A5)",
                POINT,
                contact_quartic,
                "c0, c1, c2, c3, c4",
                contact_names,
            ),
            Function(
                "liftoff_matrix",
                "D of the balance in lift-off.",
                "(24)",
                (L, *STIFFNESS),
                _matrix(D, liftoff),
                "((D11, D12), (D21, D22))",
                shorthands(liftoff),
            ),
            Function(
                "liftoff_vector",
                "b of the balance in lift-off.",
                "(25), (A12), (A13)",
                (*ANGLE0, kappa, alpha, beta),
                tuple(b.subs(liftoff)),
                "b3, b4",
            ),
            Function(
                "liftoff_quartic",
                "Coefficients of d0 + d1 L + d2 L² + d3 L³ + d4 L⁴ = 0 in lift-off, d0 as derived.",
                "(26), (A1) corrected, (A6)–(A9)",
                (*ANGLE0, *WITHOUT_FRICTION),
                liftoff_quartic,
                "d0, d1, d2, d3, d4",
                liftoff_names,
            ),
            Function(
                "f_coefficients",
                "a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ "
                "F_x(θ, L(θ)).",
                "(12), (13) eliminated",
                (*POINT, nbar),
                F_COEFFICIENTS,
                "a, b, d, m",
                shorthands(),
            ),
            Function(
                "f_magnitudes",
                "Sums of the absolute values of the terms of a and d, against which their rounding "
                "errors are measured.",
                "rounding-error analysis",
                (*POINT, nbar),
                (
                    trig[fa].subs(alpha, -alpha),
                    trig[fd].subs({c0: sp.Abs(c0), kappa: -kappa}),
                ),
                "|a|, |d|",
                shorthands(),
            ),
            Function(
                "f",
                "The scalar function whose roots are the equilibria.",
                "(12), (13) eliminated",
                at_angle,
                f,
                "f",
            ),
            Function(
                "f_slope",
                "df/dθ, which is L det K at an equilibrium.",
                "(12), (13) eliminated",
                at_angle,
                sp.collect(catastrophe.slope, s),
                "f′",
            ),
            Function(
                "f_curvature",
                "d²f/dθ².",
                "(12), (13) eliminated",
                at_angle,
                catastrophe.curvature,
                "f″",
            ),
            Function(
                "f_third", "d³f/dθ³.", "(12), (13) eliminated", at_angle, catastrophe.third, "f‴"
            ),
            Function(
                "t_quartic",
                "Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = "
                "tan(θ/2).",
                "(12), (13) eliminated",
                F_COEFFICIENTS,
                elimination.quartic_in_t(),
                "e0, e1, e2, e3, e4",
            ),
            Function(
                "resolvent",
                "Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of "
                "the quartic in t.",
                "(12), (13) eliminated",
                F_COEFFICIENTS,
                (factored(r0), factored(r1), r2),
                "r0, r1, r2",
            ),
            Function(
                "state",
                "Spring length and displacement at an equilibrium with direction θ.",
                "(4), (5), (13) or (15)",
                (*ANGLE, *ANGLE0, kappa, sigma, beta, nbar),
                (L, state[x], state[y]),
                "L, x, y",
                {**shorthands(), L: state[L]},
            ),
            Function(
                "residuals",
                "F_x and F_y at spring length L and direction θ.",
                "(12)–(15)",
                (*ANGLE, L, *POINT, nbar),
                _residuals(along, across),
                "F_x, F_y",
            ),
        ),
    )


def _residuals(along: sp.Expr, across: sp.Expr) -> Pair:
    arranged = (
        sigma * (1 - L) * c + alpha * x + mu0 * nbar * y,
        sigma * (1 - L) * s + (beta + nbar) * y + kappa,
    )
    arranged = tuple(force.subs(equilibrium.displacement()) for force in arranged)
    require_same("residuals (14), (15)", arranged, (along, across))
    return arranged
