"""Stability with the damping that (27) leaves out: a state in contact is stable exactly if det K
> 0 and K₁₂ K₂₁ > 0, whatever the belt's speed V and the steepness d; and the Hopf points in closed
form.

The slope of the friction law damps along the belt only, by C₁₁ = c = μ₀ d n e^(−d V) > 0. Each step
is decided by exact algebra, as in :mod:`.theorem`: μ₀, d, κ, σ > 0, α, β ≥ 0, 0 < θ₀ < π, V > 0.
"""

import itertools
from functools import cache

import sympy as sp
from sympy import Expr, Matrix, expand

from .. import hurwitz
from ..algebra import Names, Pair, Row, manifestly_positive
from . import elimination, equilibrium, stability, theorem
from . import nomenclature as nm
from .nomenclature import B, L, M, alpha, c, c0, kappa, p, q, s, s0, sigma
from .stability import in_shorthand, lam
from .theorem import Step
from .unit_circles import require, rotate_derivative

#: K of any state, and the one entry of C.
STIFFNESS = Matrix(2, 2, sp.symbols("K_11 K_12 K_21 K_22"))
DAMPING = sp.Symbol("c", positive=True)


def characteristic() -> Expr:
    """det(λ² I + λ C + K) with the one entry c of C."""
    return stability.characteristic(STIFFNESS, Matrix([[DAMPING, 0], [0, 0]]))


def hurwitz_determinants() -> tuple[Expr, ...]:
    """Hurwitz's determinants of sizes 1 to 4."""
    return hurwitz.determinants(tuple(sp.Poly(characteristic(), lam).all_coeffs()))


def steps() -> tuple[Step, ...]:
    """The proof, step by step."""
    return (*_damping(), *_routh(), *_couplings(), *_undamped())


def _damping() -> tuple[Step, ...]:
    C = stability.damping()
    depth, steepness = sp.symbols("n d", positive=True)
    friction, speed = sp.symbols("mu_0 V", positive=True)
    entry = C[0, 0].subs({nm.nbar: 1, nm.y: -depth})
    entry = entry.subs({nm.mu0: friction, nm.creep: steepness, nm.V: speed})
    right = friction * steepness * depth * sp.exp(-steepness * speed)
    return (
        Step(
            "in contact C has the one entry C₁₁ = μ₀ d n e^(−d V), which is positive: n > 0",
            expand(entry - right) == 0
            and bool(right.is_positive)
            and not any((C[0, 1], C[1, 0], C[1, 1])),
        ),
        Step(
            "in lift-off C vanishes and K is symmetric: (27) decides there",
            C.subs(nm.nbar, 0) == sp.zeros(2, 2)
            and in_shorthand(stability.stiffness()).subs(M, 0).is_symmetric(),
        ),
    )


def _routh() -> tuple[Step, ...]:
    (K11, K12), (K21, K22) = STIFFNESS.tolist()
    determinant, coupling = STIFFNESS.det(), K12 * K21
    polynomial = sp.Poly(characteristic(), lam)
    expected = [1, DAMPING, K11 + K22, DAMPING * K22, determinant]
    first, second, third, fourth = hurwitz_determinants()
    omega = sp.Symbol("omega", positive=True)
    on_axis = expand(characteristic().subs(lam, sp.I * omega))
    odd = sp.cancel(on_axis.coeff(sp.I) / (DAMPING * omega))
    even = on_axis - sp.I * on_axis.coeff(sp.I)
    # det K, K12 K21 and K22 > 0 give K11; signs of Routh's column 1, c, K11, c K12 K21/K11, det K.
    column = [
        (sign, first_sign, product)
        for sign, product in itertools.product((1, -1), repeat=2)
        for first_sign in ((sign,) if sign == product else (1, -1))
    ]
    factors = (lam**2 + K22) * (lam**2 + DAMPING * lam + K11)
    return (
        Step(
            "det(λ² I + λ C + K) = λ⁴ + c λ³ + (K₁₁ + K₂₂) λ² + c K₂₂ λ + det K",
            all(
                expand(one - other) == 0
                for one, other in zip(polynomial.all_coeffs(), expected, strict=True)
            ),
        ),
        Step(
            "Hurwitz's determinants are c, c K₁₁, c² K₁₂ K₂₁ and c² K₁₂ K₂₁ det K: all are "
            "positive exactly if K₁₁, K₁₂ K₂₁ and det K are; and K₁₁ K₂₂ = det K + K₁₂ K₂₁, so "
            "that K₂₂ > 0 may stand for K₁₁ > 0",
            all(
                expand(one - other) == 0
                for one, other in (
                    (first, DAMPING),
                    (second, DAMPING * K11),
                    (third, DAMPING**2 * coupling),
                    (fourth, DAMPING**2 * coupling * determinant),
                    (K11 * K22, determinant + coupling),
                )
            ),
        ),
        Step(
            "λ = 0 is a root only if det K = 0, and λ = i ω with ω > 0 only if ω² = K₂₂ and "
            "K₁₂ K₂₁ = 0",
            polynomial.eval(0) == expand(determinant)
            and expand(odd - (K22 - omega**2)) == 0
            and expand(even.subs(omega, sp.sqrt(K22)) + coupling) == 0,
        ),
        Step(
            "where K₂₂ > 0 and neither is 0, the λ with a positive real part are [det K < 0] + "
            "2 [K₁₂ K₂₁ < 0] in number: the changes of sign in Routh's column 1, c, K₁₁, c K₁₂ "
            "K₂₁/K₁₁, det K, and where K₁₁ = 0 of the states beside it, since none comes to the "
            "imaginary axis",
            all(
                theorem.changes((1, 1, k11, product * k11, sign)) == (sign < 0) + 2 * (product < 0)
                for sign, k11, product in column
            ),
        ),
        Step(
            "where K₁₂ K₂₁ = 0 the polynomial is (λ² + K₂₂)(λ² + c λ + K₁₁): a pair ± i √K₂₂, and "
            "two other roots, in the left half plane if K₁₁ > 0, one of them positive if K₁₁ < 0",
            expand((characteristic() - factors) - (determinant - K11 * K22)) == 0
            and expand(determinant - K11 * K22 + coupling) == 0,
        ),
        Step(
            "where det K = 0 the polynomial is λ (λ³ + c λ² + (K₁₁ + K₂₂) λ + c K₂₂): a root 0, "
            "and by Hurwitz's determinants c and c K₁₁ with K₁₁ K₂₂ = K₁₂ K₂₁ two others with a "
            "positive real part exactly if K₁₂ K₂₁ < 0",
            expand(polynomial.all_coeffs()[1] * polynomial.all_coeffs()[2]) - DAMPING * K22
            == expand(second)
            and expand(K11 * K22 - coupling - determinant) == 0,
        ),
    )


def _couplings() -> tuple[Step, ...]:
    """K₂₂, K₁₂ and K₂₁ at an equilibrium in contact."""
    K = in_shorthand(stability.stiffness())
    pull = sigma * s * c / L
    sine = sp.Symbol("s_1", positive=True)
    _, across = equilibrium.balance()
    (preload,) = sp.solve(stability.in_contact(across), kappa)
    positive = sigma * s**3 + B * s0 + preload
    known = {sigma: theorem.sigma, s: sine, s0: theorem.s0, kappa: theorem.kappa}
    total = (sigma * s**3 + B * s0 + kappa).subs(known).subs(B, theorem.beta + 1)
    return (
        Step(
            "in contact L sin θ K₂₂ = σ sin³ θ + B sin θ₀ + κ, which is positive: sin θ > 0, by "
            "the steps of one or three",
            equilibrium.equal(expand(L * s * K[1, 1]), expand(positive))
            and manifestly_positive(total),
        ),
        Step(
            "K₂₁ = σ sin θ cos θ/L and K₁₂ = K₂₁ + μ₀: K₁₂ K₂₁ > 0 exactly if cos θ > 0, or if "
            "cos θ < 0 and σ sin θ |cos θ| > μ₀ L",
            equilibrium.equal(K[1, 0], pull) and equilibrium.equal(K[0, 1], pull + M),
        ),
        Step(
            "cos θ = 0 is an equilibrium in contact exactly if μ₀ = (1 + β + σ) α cos θ₀/(κ + σ (1 "
            "− sin θ₀)): there L = (σ + B sin θ₀ + κ)/q > 0 and −q y = κ + σ (1 − sin θ₀) > 0",
            upright_friction() is not None
            and expand(elimination.state()[nm.y].subs(s, 1) * q + kappa + sigma * (1 - s0)) == 0,
        ),
        Step(
            "K₁₂ = 0 is an equilibrium exactly if μ₀ L = −σ sin θ cos θ, which with (15) gives sin "
            "θ₀, and with (14) α cos θ₀, in θ and μ₀",
            coupling_lines() is not None,
        ),
    )


def _undamped() -> tuple[Step, ...]:
    """What (27) decides of the damped states."""
    (K11, K12), (K21, K22) = STIFFNESS.tolist()
    coupling = K12 * K21
    gap = sp.Symbol("gap", real=True)
    discriminant = stability.flutter_discriminant(STIFFNESS)
    return (
        Step(
            "flutter by (27), (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ < 0, asks K₁₂ K₂₁ < 0, and divergence by "
            "(27) is det K < 0: what (27) calls unstable is unstable",
            expand(discriminant - (K11 - K22) ** 2 - 4 * coupling) == 0
            and bool((gap**2).is_nonnegative),
        ),
        Step(
            "what (27) calls stable is stable exactly if K₁₂ K₂₁ > 0, and grows where −(K₁₁ − "
            "K₂₂)²/4 ≤ K₁₂ K₂₁ < 0: (27) needs det K > 0, and K₁₁ + K₂₂ > 0, which an equilibrium "
            "in contact has",
            stability.trace_identity(),
        ),
    )


# ------------------------------------------------------------------------------------------------
# Hopf points in closed form


@cache
def upright_friction() -> Expr:
    """μ₀ at which a state in contact has θ = π/2, where K₂₁ = 0."""
    f = elimination.f_in_parameters().subs({c: 0, s: 1})
    (friction,) = sp.solve(f, M)
    arranged = q * alpha * c0 / (kappa + sigma * (1 - s0))
    require(equilibrium.equal(friction, arranged), "the friction of an upright spring")
    return arranged


@cache
def coupling_lines() -> tuple[Expr, Expr, Expr]:
    """S, A and D of sin θ₀ = S/D and α cos θ₀ = A/D, of the equilibrium in contact in direction θ
    at which K₁₂ = 0, so that μ₀ L = −σ sin θ cos θ.

    A² + α² (S² − D²), which is 0 at every such equilibrium, is a polynomial of degree 6 in cos θ
    and sin θ.
    """
    length = -sigma * s * c / M
    u1, w1, u2, w2 = stability.reference_lines()
    lines = (
        (constant + slope * length).subs(equilibrium.POLES)
        for constant, slope in ((u1, w1), (u2, w2))
    )
    arranged = (
        -M * (sigma * s + kappa) - q * sigma * s**2 * c,
        M * (M * (sigma * s + kappa) - B * sigma * c) - sigma * s * c * (B * p * c - M * sigma * s),
    )
    require(
        all(map(equilibrium.equal, arranged, (B * M * line for line in lines))),
        "the balance where friction uncouples the two directions",
    )
    return *arranged, B * M


@cache
def coupling_friction() -> Expr:
    """μ₀ of the equilibrium in contact in direction θ, with the spring at θ₀, at which K₁₂ = 0: of
    :func:`coupling_lines` the first, which is linear in μ₀.
    """
    sine, _, width = coupling_lines()
    (friction,) = sp.solve(sine - s0 * width, M)
    arranged = -q * sigma * s**2 * c / (B * s0 + sigma * s + kappa)
    require(equilibrium.equal(friction, arranged), "the friction that uncouples two directions")
    return arranged


@cache
def coupling_conic() -> Row:
    """g0, g1, k0, k1, k2: K₁₂ = 0 at an equilibrium in contact in direction θ where cos θ₀ (g0 + g1
    sin θ₀) = k0 + k1 sin θ₀ + k2 sin² θ₀.

    That is the second of :func:`coupling_lines`, with :func:`coupling_friction`.
    """
    _, cosine, width = coupling_lines()
    load = sigma * s + kappa
    pull = alpha * q * s
    arranged = (
        pull * load,
        pull * B,
        c * load * (p * load - q * sigma * s * (1 + s**2)),
        c * (2 * p * B * load - q * sigma * s * (B - sigma * s**2)),
        c * p * B**2,
    )
    g0, g1, k0, k1, k2 = arranged
    gap = (alpha * c0 - cosine / width).subs(M, coupling_friction())
    form = c0 * (g0 + g1 * s0) - (k0 + (k1 + k2 * s0) * s0)
    require(
        equilibrium.equal(form, expand(sp.cancel(gap * q * s * (B * s0 + load)))),
        "the equilibria where friction uncouples the two directions",
    )
    return arranged


@cache
def coupling_crossing() -> tuple[Pair, Names]:
    """N and J: along the equilibria at fixed μ₀, L K₁₂ changes by N/J per unit of θ₀; and names in
    them, as for :func:`.stability.flutter_crossing`.
    """
    form = expand(L * in_shorthand(stability.stiffness())[0, 1])
    slope, by_length = sigma * (c**2 - s**2), M
    require(
        equilibrium.equal(rotate_derivative(form), slope)
        and equilibrium.equal(sp.diff(form, L), by_length),
        "the derivatives of the coupling",
    )
    return stability.crossing(slope, by_length)
