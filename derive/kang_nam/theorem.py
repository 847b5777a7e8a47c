"""One or three: for 0 < θ₀ < π, κ > 0, σ > 0, α, β ≥ 0 and every μ₀ ≥ 0 the number of
steady-sliding equilibria, counted with multiplicity, is one or three, and of three different ones
the middle one is divergent.

An equilibrium in contact is a root of f with L > 0 and y < 0, that is, with s > s* = s₀ − κ/σ. Each
step names what it claims and decides it by exact algebra: an identity, or a polynomial in
nonnegative quantities with nonnegative coefficients and a term that is positive.
"""

import itertools
from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, Symbol, expand

from . import catastrophe, elimination, equilibrium, stability
from . import nomenclature as nm
from ..algebra import manifestly_positive
from .unit_circles import rotate_derivative


@dataclass(frozen=True)
class Step:
    """A claim and whether exact algebra confirms it."""

    claim: str
    holds: bool


def one_or_three() -> tuple[Step, ...]:
    """The proof, step by step."""
    return (*_quartic(), *_threshold_below_zero(), *_threshold_above_zero(), *_middle())


# What the steps know to be positive (κ, σ, s₀ and L − 1 where it occurs) or not negative (α, β).
kappa, sigma, s0 = sp.symbols("kappa sigma s_0", positive=True)
alpha, beta = sp.symbols("alpha beta", nonnegative=True)
POSITIVE = {nm.kappa: kappa, nm.sigma: sigma, nm.s0: s0, nm.alpha: alpha, nm.beta: beta, nm.nbar: 1}

# s* > 0 and s₀ − s* = κ/σ.
threshold, excess = sp.symbols("s_star excess", positive=True)
ON_ARC = {s0: threshold + excess, kappa: sigma * excess}


def in_contact(expression: Expr) -> Expr:
    return equilibrium.spell_out(expression.subs(elimination.f_coefficients())).subs(POSITIVE)


def _length_fraction() -> tuple[Expr, Expr]:
    """Numerator and denominator of L(θ)."""
    numerator, denominator = map(in_contact, sp.fraction(sp.together(elimination.state()[nm.L])))
    return numerator, denominator


def changes(signs: Iterable[int]) -> int:
    """Changes of sign in a row of −1, 0, 1, zeros left out."""
    return sum(one != other for one, other in itertools.pairwise(sign for sign in signs if sign))


def _quartic() -> tuple[Step, ...]:
    quartic = elimination.quartic_in_t()
    friction = Symbol("mu_0", positive=True)
    t = Symbol("t", positive=True)
    sine = sp.expand_trig(sp.sin(2 * sp.atan(t)))
    _, across = equilibrium.balance()
    return (
        Step(
            "−b is positive: a polynomial with positive coefficients in κ, σ, s₀ > 0 and α, β ≥ 0",
            manifestly_positive(in_contact(-nm.fb)),
        ),
        Step(
            "the quartic in t begins with −b t⁴ and ends with b: negative at 0 and positive "
            "at ±∞, so that it has an "
            "odd number of roots on either side of 0, and at most three positive ones",
            len(quartic) == 5 and quartic[4] == -nm.fb and quartic[0] == nm.fb,
        ),
        Step(
            "three positive roots need a + d > 0: that of t is 2 (a + d), that of t² is −4 m with "
            "m = μ₀ σ ≥ 0, and without the first positive the coefficients change sign once, which "
            "by Descartes' rule leaves one positive root",
            expand(quartic[1] - 2 * (nm.fa + nm.fd)) == 0
            and quartic[2] == -4 * nm.fm
            and manifestly_positive(in_contact(nm.fm).subs(nm.mu0, friction))
            and all(
                changes((-1, e1, e2, e3, 1)) == 1
                for e1 in (-1, 0)
                for e2 in (-1, 0)
                for e3 in (-1, 0, 1)
            ),
        ),
        Step(
            "f = b cos θ ≠ 0 where sin θ = 0, so that the factor q sin θ of f = q sin θ F_x "
            "adds no root",
            elimination.f_form.subs(nm.s, 0) == nm.fb * nm.c,
        ),
        Step(
            "no equilibrium has sin θ = 0, which solving F_y = 0 for L would lose: F_y is "
            "then B s₀ + κ > 0",
            manifestly_positive(in_contact(across.subs(nm.s, 0))),
        ),
        Step(
            "t > 0 is sin θ > 0: sin θ = 2 t/(1 + t²)", sp.simplify(sine - 2 * t / (1 + t**2)) == 0
        ),
    )


def _threshold_below_zero() -> tuple[Step, ...]:
    """s* ≤ 0: the equilibria in contact are exactly the roots with t > 0."""
    s, u = sp.symbols("s u", positive=True)
    depth = Symbol("depth", nonnegative=True)  # −s* = κ/σ − s₀
    numerator, denominator = _length_fraction()
    penetration = in_contact(-nm.q * elimination.state()[nm.y])  # −q y(θ), positive in contact
    # s = −u: L > 0 asks numerator < 0, contact asks penetration > 0, yet the first exceeds the
    # second.
    conflict = (numerator - penetration).subs(nm.s, -u)
    return (
        Step(
            "s > 0 gives L > 0",
            manifestly_positive(numerator.subs(nm.s, s))
            and manifestly_positive(denominator.subs(nm.s, s)),
        ),
        Step(
            "s > 0 ≥ s* gives y < 0",
            manifestly_positive(penetration.subs(nm.s, s).subs(kappa, sigma * (s0 + depth))),
        ),
        Step(
            "s < 0 excludes L > 0 together with y < 0: σ s + B s₀ + κ must be negative and σ (s − "
            "s₀) + κ positive, but the first is larger than the second by (B + σ) s₀",
            manifestly_positive(conflict),
        ),
    )


def _threshold_above_zero() -> tuple[Step, ...]:
    """s* > 0: f has opposite signs at the two ends of the arc s > s*, where y = 0."""
    stretch, surplus = sp.symbols("stretch surplus", positive=True)
    level = Symbol("level", nonnegative=True)  # cos² θ₀
    numerator, denominator = (
        part.subs(nm.s, threshold).subs(ON_ARC) for part in _length_fraction()
    )

    along, _ = equilibrium.balance()
    P = nm.sigma - nm.p * nm.L
    at_end = along.subs(nm.s0, nm.L * nm.s) - equilibrium.spell_out(P * nm.c + nm.alpha * nm.c0)
    return (
        Step(
            "at the ends L = s₀/s*, which exceeds 1",
            sp.simplify(numerator / denominator - (threshold + excess) / threshold) == 0,
        ),
        Step(
            "there F_x = P cos θ + α cos θ₀ with P = σ − p L, whatever the friction",
            expand(at_end) == 0,
        ),
        Step(
            "−P > α, since −P − α = p (L − 1)",
            manifestly_positive(in_contact(-P).subs(nm.L, 1 + stretch) - alpha),
        ),
        Step(
            "P² cos² θ* > α² cos² θ₀, with −P = α + λ, cos² θ₀ = C ≥ 0 and cos² θ* = C + s₀² − "
            "s*²: F_x has the sign of −cos θ at either end, so that there is an odd number of "
            "roots between, all with t > 0 and L > 0: one or three",
            manifestly_positive(
                (alpha + surplus) ** 2 * (level + (threshold + excess) ** 2 - threshold**2)
                - alpha**2 * level
            ),
        ),
    )


def _middle() -> tuple[Step, ...]:
    """Three different equilibria: f rises, falls and rises through them, and L det K = f′."""
    f = elimination.f_form
    K = sp.Matrix(2, 2, sp.symbols("K_11 K_12 K_21 K_22"))
    length = (threshold + excess) / threshold  # L = s₀/s*
    force = in_contact(nm.sigma - nm.p * nm.L).subs(nm.L, length) * nm.c + alpha * nm.c0
    at_end = in_contact(f).subs(nm.s, threshold).subs(ON_ARC)
    equation = sp.Poly(stability.characteristic(K, sp.zeros(2, 2)), stability.lam)
    # Of three different roots that count three at most, all multiplicities that there can be.
    multiplicities = [
        counts for counts in itertools.product(range(1, 4), repeat=3) if sum(counts) <= 3
    ]
    return (
        Step("L det K = f′ at every equilibrium", catastrophe.slope_identity()),
        Step(
            "s* ≤ 0: contact is 0 < θ < π, and f is negative before the first root and positive "
            "after the last: f = b < 0 at θ = 0 and −b at θ = π",
            f.subs({nm.s: 0, nm.c: 1}) == nm.fb
            and f.subs({nm.s: 0, nm.c: -1}) == -nm.fb
            and manifestly_positive(in_contact(-nm.fb)),
        ),
        Step(
            "s* > 0: contact is θ* < θ < π − θ*, and f is negative before the first root and "
            "positive after the last: at the ends f = q s* F_x with q s* > 0, F_x = P cos θ + α "
            "cos θ₀ has the sign of P cos θ since (F_x)(P cos θ − α cos θ₀) > 0, and P < 0",
            all(step.holds for step in _threshold_above_zero())
            and sp.simplify(at_end - in_contact(nm.q) * threshold * force) == 0,
        ),
        Step(
            "three different roots that count three at most are simple, so that the signs of "
            "f before, between and after them are "
            "−, +, −, +: f falls through the second, f′ < 0 there, and det K < 0",
            multiplicities == [(1, 1, 1)],
        ),
        Step(
            "det K < 0 is divergence: (27) is λ⁴ + tr K λ² + det K = 0, negative at λ = 0 and "
            "positive for large λ, so that a real λ > 0 solves it",
            equation.all_coeffs() == [1, 0, K.trace(), 0, expand(K.det())],
        ),
    )


def smallest_without_friction() -> tuple[Step, ...]:
    """At μ₀ = 0 and cos θ₀ > 0 at most one equilibrium has cos θ > 0, and every other has x ≥ cos
    θ₀; cos θ₀ < 0 is the mirror image.

    So a state with 0 < L cos θ < 2 cos θ₀, that is |x| < cos θ₀, is the one of smallest |x|.
    """
    f = elimination.f_form.subs(nm.fm, 0)
    cosine, sine, cosine0 = sp.symbols("c s c_0", positive=True)
    at_rest = (
        equilibrium.spell_out(elimination.f_form.subs(elimination.f_coefficients()))
        .subs(POSITIVE)
        .subs(nm.mu0, 0)
    )
    ratio = rotate_derivative(nm.fa + nm.fb / nm.s + nm.fd / nm.c)
    slope = ratio.subs(elimination.f_coefficients()).subs(nm.M, 0)
    slope = expand(
        equilibrium.spell_out(slope).subs(POSITIVE).subs({nm.c: cosine, nm.s: sine, nm.c0: cosine0})
        * (cosine * sine) ** 2
    )
    x = elimination.state()[nm.x].subs(nm.c, -cosine)
    length = sp.together(in_contact(elimination.state()[nm.L]).subs(nm.s, sine))
    return (
        Step(
            "f = s c (a + b/s + d/c) at μ₀ = 0",
            sp.simplify(f - nm.s * nm.c * (nm.fa + nm.fb / nm.s + nm.fd / nm.c)) == 0,
        ),
        Step(
            "the bracket rises with θ where sin θ, cos θ > 0: times s² c² its slope is a "
            "polynomial with positive coefficients",
            manifestly_positive(slope),
        ),
        Step(
            "at cos θ = 0 f is q α cos θ₀ sin θ, and x is cos θ₀",
            expand(
                at_rest.subs({nm.c: 0, nm.s: 1})
                - equilibrium.spell_out(nm.q).subs(POSITIVE) * alpha * nm.c0
            )
            == 0
            and elimination.state()[nm.x].subs(nm.c, 0) == nm.c0,
        ),
        Step(
            "where cos θ < 0, x exceeds cos θ₀ by L |cos θ|, and L > 0",
            expand(x - nm.c0 - nm.L * cosine) == 0
            and all(manifestly_positive(part) for part in sp.fraction(length)),
        ),
    )
