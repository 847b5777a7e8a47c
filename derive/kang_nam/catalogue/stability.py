"""Functions of the linearization about an equilibrium: K, its invariants, damping, flutter
onsets.
"""

import sympy as sp
from sympy import Matrix

from ...algebra import Names, Row
from ...emit.function import Function, Module, rows
from .. import routh, stability
from ..nomenclature import B, C11, L, M, PARAMETERS, V, alpha, beta, c, creep, kappa, mu0, nbar
from ..nomenclature import p, q, s, s0, sigma, stiffness_entries, y
from .arrangement import (
    ANGLE,
    ANGLE0,
    STIFFNESS,
    WITHOUT_FRICTION,
    further,
    require_same,
    in_contact,
    shorthands,
)


def module() -> Module:
    contact = in_contact()
    K = stability.stiffness()
    pull = sigma / L
    arranged = Matrix(
        [
            [p - pull * s**2, pull * s * c + M],
            [pull * s * c, q - pull * c**2],
        ]
    )
    require_same("K (28)", tuple(arranged), tuple(K))
    generic, C = Matrix(2, 2, stiffness_entries), stability.damping()
    damped = Matrix(C)
    damped[0, 0] = C11
    characteristic = sp.Poly(stability.characteristic(generic, damped), stability.lam).all_coeffs()
    determinant = generic.det()
    crossing, crossing_names = stability.flutter_crossing()
    coupling, coupling_names = routh.coupling_crossing()
    cubic, cubic_names = _flutter_cubic()
    at_friction = (*ANGLE, *PARAMETERS)
    return Module(
        "stability",
        "Linearization about an equilibrium: K, its invariants, the damping that (27) leaves "
        "out, the flutter onsets.",
        (
            Function(
                "stiffness",
                "K, the Jacobian of (F_x, F_y).",
                "(28)",
                (*ANGLE, L, mu0, *STIFFNESS, nbar),
                rows(arranged),
                "((K11, K12), (K21, K22))",
                shorthands(),
            ),
            Function(
                "invariants",
                "Trace, determinant (negative: divergence) and discriminant in λ² (negative: "
                "flutter) of K.",
                "(27)",
                stiffness_entries,
                (generic.trace(), determinant, stability.flutter_discriminant(generic)),
                "trace, determinant, discriminant",
            ),
            Function(
                "damping",
                "∂F_x/∂x' at steady sliding.",
                "(8), (10) linearized",
                tuple(symbol for symbol in (y, mu0, V, creep, nbar) if C[0, 0].has(symbol)),
                C[0, 0],
                "C11",
                further=further((), C[0, 0]),
            ),
            Function(
                "characteristic",
                "Coefficients of det(λ² I + λ C + K), highest power first; C11 = 0 is (27).",
                "(27) with damping",
                (*stiffness_entries, C11),
                tuple(characteristic),
                "e4, e3, e2, e1, e0",
            ),
            Function(
                "reference_lines",
                "u1, w1, u2, w2 of sin θ₀ = u1 + w1 L and α cos θ₀ = u2 + w2 L, in contact at "
                "given θ and μ₀.",
                "(14), (15)",
                at_friction,
                stability.reference_lines(),
                "u1, w1, u2, w2",
                contact,
            ),
            Function(
                "flutter_quadratic",
                "Coefficients of e0 + e1 L + e2 L², which is L² times the discriminant of "
                "(27), in contact.",
                "(27)",
                (*ANGLE, mu0, *STIFFNESS),
                stability.flutter_quadratic(),
                "e0, e1, e2",
                contact,
            ),
            Function(
                "flutter_elimination",
                "X, Y, Z: X² = Y Z at the θ of every flutter onset in contact, and L = X/Y is "
                "its length.",
                "(27), (14), (15)",
                at_friction,
                stability.flutter_elimination(),
                "X, Y, Z",
                {**contact, **_flutter_names()},
            ),
            Function(
                "flutter_without_alpha",
                "The same for α = 0: zero at the θ of every flutter onset, where L = −u2/w2.",
                "(27), (14), (15)",
                (*ANGLE, mu0, kappa, sigma, beta),
                stability.flutter_without_alpha(),
                "condition",
                {
                    name: value.subs(alpha, 0)
                    for name, value in {**contact, **_flutter_names()}.items()
                },
            ),
            Function(
                "flutter_crossing",
                "N, J: L² times the discriminant changes by N/J per unit of θ₀, along "
                "equilibria in contact.",
                "(27), (14), (15)",
                (*ANGLE, L, *ANGLE0, mu0, *STIFFNESS),
                crossing,
                "N, J",
                {**contact, **crossing_names},
            ),
            Function(
                "flutter_cubic",
                "Flutter onsets in contact at a given θ: cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 "
                "sin θ₀ + … + k3 sin³ θ₀.",
                "(27), (14), (15)",
                (*ANGLE, *WITHOUT_FRICTION),
                cubic,
                "g0, g1, k0, k1, k2, k3",
                cubic_names,
            ),
            Function(
                "flutter_friction",
                "μ₀ at a flutter onset with spring length L in direction θ, in contact.",
                "(27)",
                (*ANGLE, L, *STIFFNESS),
                stability.flutter_friction(),
                "mu0",
                contact,
            ),
            Function(
                "upright_friction",
                "μ₀ at which a state in contact has θ = π/2, where K21 = 0: a Hopf point.",
                "(14), (15)",
                (*ANGLE0, *WITHOUT_FRICTION),
                routh.upright_friction(),
                "mu0",
                contact,
            ),
            Function(
                "coupling_lines",
                "S, A, D of sin θ₀ = S/D and α cos θ₀ = A/D, in contact where K12 = 0, so that L "
                "= −σ sin θ cos θ/μ₀: a Hopf point.",
                "(14), (15), (28)",
                at_friction,
                routh.coupling_lines(),
                "S, A, D",
                contact,
            ),
            Function(
                "coupling_friction",
                "μ₀ where K12 = 0 in direction θ, with the spring at θ₀, in contact.",
                "(14), (15), (28)",
                (*ANGLE, s0, kappa, sigma, beta),
                routh.coupling_friction(),
                "mu0",
                contact,
            ),
            Function(
                "coupling_conic",
                "K12 = 0 in contact at a given θ: cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 sin θ₀ + k2 "
                "sin² θ₀.",
                "(14), (15), (28)",
                (*ANGLE, *WITHOUT_FRICTION),
                routh.coupling_conic(),
                "g0, g1, k0, k1, k2",
                contact,
            ),
            Function(
                "coupling_crossing",
                "N, J: L K12 changes by N/J per unit of θ₀, along equilibria in contact.",
                "(14), (15), (28)",
                (*ANGLE, L, *ANGLE0, mu0, *STIFFNESS),
                coupling,
                "N, J",
                {**contact, **coupling_names},
            ),
        ),
    )


def _flutter_names() -> Names:
    """The coefficients in terms of which the elimination is written."""
    return dict(
        zip(
            (*stability.LINES, *stability.QUADRATIC),
            (*stability.reference_lines(), *stability.flutter_quadratic()),
            strict=True,
        )
    )


def _flutter_cubic() -> tuple[Row, Names]:
    """With L = l0 + l1 sin θ₀ and y = y0 + y1 sin θ₀: the discriminant without friction times y,
    and the spring's pull along.
    """
    l0, l1, y0, y1, e0, e1, e2, m1, m2 = sp.symbols("l0 l1 y0 y1 e0 e1 e2 m1 m2")
    pull = 4 * sigma * s * c**2
    names = {
        l0: (sigma * s + kappa) / (q * s),
        l1: B / (q * s),
        y0: -(sigma * s + kappa) / q,
        y1: sigma / q,
        m1: -pull * sigma,
        m2: pull * p,
    }
    for coefficient, value in zip((e0, e1, e2), stability.flutter_quadratic(), strict=True):
        names[coefficient] = value.subs(M, 0)
    d0, d1, d2 = e0 + l0 * (e1 + e2 * l0), l1 * (e1 + 2 * e2 * l0), e2 * l1**2
    weight = 4 * sigma * s * c * alpha
    cubic = (
        weight * l0,
        weight * l1,
        d0 * y0 + l0 * (m1 + m2 * l0),
        d1 * y0 + d0 * y1 + l1 * (m1 + 2 * m2 * l0),
        d2 * y0 + d1 * y1 + m2 * l1**2,
        d2 * y1,
    )
    require_same("flutter cubic", cubic, stability.flutter_cubic(), names)
    return cubic, {**in_contact(), **names}
