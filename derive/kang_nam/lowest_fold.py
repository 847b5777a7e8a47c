"""The critical friction: the least at which, over all inclinations 0 < θ₀ < π, the reference
state ends.

Candidates are the cusps, the points at which the curve of folds turns back in μ₀, f = f′ = f_θ₀ =
0, and the folds at θ₀ = 0.
"""

from functools import cache

import sympy as sp
from sympy import Expr, expand

from . import catastrophe, unit_circles, elimination, equilibrium, theorem
from .nomenclature import B, L, M, alpha, c, c0, fa, fb, fd, fm, kappa, mu0, p, q, s, s0, sigma, y
from ..algebra import Row, manifestly_positive
from ..factors import factored
from .equilibrium import POLES
from .theorem import Step, in_contact
from .unit_circles import by_inclination, polynomial, require


# ------------------------------------------------------------------------------------------------
# where the curve of folds turns back


#: What the line and the quadratics below are written in, each in terms of those before it.
weight, threshold, constant, along, square, lean = sp.symbols("w_line v l_0 l_1 width lean")
PARTS = {
    weight: kappa * p + alpha * sigma * s,
    threshold: sigma * s + kappa,
    constant: alpha * sigma * s,
    along: -alpha * s * threshold,
    square: 1 - s**2,
    lean: kappa * p - fa * s**3 - p * B * s * square,
}


@cache
def turning_line() -> tuple[Expr, Expr, Expr]:
    """w, l₀ and l₁ of w cos θ cos θ₀ = l₀ + l₁ sin θ₀: f = f_θ₀ = 0, friction eliminated."""
    f = elimination.f_in_parameters()
    without, with_friction = f.subs(M, 0), sp.diff(f, M)
    derived = without * by_inclination(with_friction) - with_friction * by_inclination(without)
    line = PARTS[weight], PARTS[constant], PARTS[along].subs(PARTS)
    arranged = q * s * (line[1] + line[2] * s0 - line[0] * c * c0)
    require(equilibrium.equal(derived, arranged), "the line f = f_θ₀ = 0")
    return line


def quadratics_in_parts() -> tuple[Row, Row]:
    """:func:`turning_quadratics` in terms of the parts."""
    middle = sigma * p * B - threshold * lean - q * s * square * weight
    slope = sigma * lean, middle, -p * B * threshold
    return slope, (
        constant**2 - square * weight**2,
        2 * constant * along,
        along**2 + square * weight**2,
    )


@cache
def turning_quadratics() -> tuple[Row, Row]:
    """Coefficients, lowest power first, of two quadratics in sin θ₀ that are 0 where folds turn
    back; polynomials in sin θ.

    The first is f_θ₀ with the friction of a fold and cos θ₀ of :func:`turning_line`, the second
    sin² θ₀ + cos² θ₀ = 1 with it.
    """
    slope, circle = (
        tuple(value.subs(PARTS).subs(PARTS) for value in row) for row in quadratics_in_parts()
    )
    w, l0, l1 = turning_line()
    (friction,) = sp.solve(catastrophe.fold_residuals()[0], M)
    derived = (
        by_inclination(elimination.f_in_parameters())
        .subs(M, friction)
        .subs(c0, (l0 + l1 * s0) / (w * c))
    )
    arranged = polynomial(slope, s0) * alpha / (w * c**2)
    # sin θ₀ is free here: that it belongs to the angle of cos θ₀ is the second quadratic.
    gap = sp.numer(sp.together((derived - arranged).subs(elimination.f_coefficients()).subs(POLES)))
    require(expand(sp.rem(expand(gap), c**2 + s**2 - 1, c)) == 0, "f_θ₀ on a fold")
    return slope, circle


def minors(one: Row, two: Row) -> tuple[Expr, Expr, Expr]:
    """O, U and V of two quadratics: their resultant is O² − U V, and where it is 0, −O/U is the
    common root.
    """
    outer, upper, lower = (one[i] * two[j] - one[j] * two[i] for i, j in ((2, 0), (2, 1), (1, 0)))
    return outer, upper, lower


@cache
def turning_polynomial() -> Row:
    """Coefficients, lowest power first, of the polynomial in s = sin θ among whose roots in (0, 1]
    are all points of turning back.

    The resultant of :func:`turning_quadratics` is −κ (s² − 1) w² times it. Contact only, and α > 0.
    """
    spelled = {fa: elimination.f_coefficients()[fa]}
    one, two = (
        tuple(expand(value.subs(spelled).subs(POLES)) for value in row)
        for row in turning_quadratics()
    )
    outer, upper, lower = map(expand, minors(one, two))
    factor = sp.Poly(expand(-kappa * (s**2 - 1) * PARTS[weight].subs(POLES) ** 2), s)
    quotient, rest = sp.div(sp.Poly(expand(outer**2 - upper * lower), s), factor)
    require(rest.is_zero, "the factors of the resultant")
    return tuple(factored(value) for value in reversed(quotient.all_coeffs()))


def identities() -> dict[str, bool]:
    """The closed forms, each decided by exact algebra."""
    turning_line()  # which, as the quadratics, raises unless it is what follows from f
    one, two = sp.symbols("A:3"), sp.symbols("C:3")
    outer, upper, lower = minors(one, two)
    resultant = outer**2 - upper * lower
    root = -outer / upper
    values = (polynomial(row, root) for row in (one, two))
    return {
        "where the curve of folds turns back in μ₀, sin θ is a root of a polynomial of degree "
        "9": len(turning_polynomial()) == 10,
        "two quadratics whose resultant is 0 have the common root that turning_sine names": all(
            sp.cancel(value * upper**2 - row[2] * resultant) == 0
            for value, row in zip(values, (one, two), strict=True)
        ),
    }


# ------------------------------------------------------------------------------------------------
# why these are all


def steps() -> tuple[Step, ...]:
    """The least friction at which the reference state ends is that of a cusp, of a turn with f″ <
    0, or of a fold at θ₀ = 0.
    """
    return (*_start(), *_inclined_backward(), *_follow())


def _start() -> tuple[Step, ...]:
    """Without friction."""
    along, _ = equilibrium.balance()
    state = elimination.state()
    length = sp.Symbol("L", positive=True)
    at_rest = equilibrium.spell_out(along).subs(M, 0).subs(mu0, 0).subs(L, length)
    stretch = in_contact(sp.together((state[L] - 1) * q * s))
    lift = theorem.kappa - (theorem.beta + 1) * (s - theorem.s0)
    return (
        *theorem.smallest_without_friction(),
        Step(
            "without friction α x = σ (L − 1) cos θ",
            expand(at_rest - (alpha * (c0 - length * c) + sigma * (1 - length) * c)) == 0,
        ),
        Step(
            "q s (L − 1) = κ − B (s − s₀): where cos θ > 0, L < 1 asks sin θ > sin θ₀, hence L cos "
            "θ < cos θ₀ and x > 0, against α x < 0, so that L ≥ 1 and 0 ≤ x < cos θ₀ (α = 0: L = "
            "1, sin θ > sin θ₀): the one state with cos θ > 0 is the one of small deformation",
            expand(stretch - lift) == 0,
        ),
    )


def _inclined_backward() -> tuple[Step, ...]:
    """θ₀ ≥ π/2: the followed state ends nowhere."""
    relations, f = catastrophe.fold_relations(), elimination.f_form
    a, rise, friction = sp.symbols("a rise friction", nonnegative=True)
    lean, sine, push = sp.symbols("lean sine push", positive=True)  # −cos θ, sin θ and −M q y
    in_friction = {fm: M * sigma}
    pull = relations[fd] - elimination.f_coefficients()[fd].subs(c0, 0)  # q α cos θ₀ on a fold
    parts = -fa * c**3 + fm * s * c**2, -M * q * elimination.state()[y]
    turned = parts[0].subs({fa: a, c: -lean, s: sine, fm: friction}) + push
    upright = in_contact(fa * s + fb).subs({theorem.s0: 1, s: sine})
    bound = (
        theorem.alpha * (theorem.beta + 1)
        + (theorem.alpha + theorem.sigma) * theorem.kappa
        + theorem.sigma * theorem.alpha * sine
    )
    return (
        Step(
            "on a fold b = −s² (a s + m cos θ), and b < 0: where cos θ ≤ 0, a is positive",
            expand(relations[fb] + s**2 * (fa * s + fm * c)) == 0,
        ),
        Step(
            "on a fold q α cos θ₀ = −a cos³ θ + m s cos² θ − M q y: where cos θ ≤ 0 and μ₀ > "
            "0, so that a > 0 and −M q y > 0, this is "
            "positive: such a fold has θ₀ < π/2, and with α = 0 there is none",
            unit_circles.equal(pull.subs(in_friction), sum(parts).subs(in_friction))
            and manifestly_positive(turned),
        ),
        Step(
            "θ₀ ≥ π/2: without friction f = q α cos θ₀ ≤ 0 at θ = π/2, so that the reference state "
            "has cos θ ≤ 0, friction moves it to larger θ, and folds are not there; at θ₀ = π/2 no "
            "other state has it, as f = cos θ (a s + b) has the sign of −cos θ",
            expand((f - c * (fa * s + fb)).subs(elimination.f_coefficients()).subs({M: 0, c0: 0}))
            == 0
            and expand(upright + bound + theorem.sigma * (theorem.beta + 1) * (1 - sine)) == 0
            and manifestly_positive(bound + theorem.sigma * (theorem.beta + 1) * rise),
        ),
    )


def _follow() -> tuple[Step, ...]:
    """θ₀ < π/2: the followed state ends at the lowest fold of that angle with f″ < 0."""
    f = elimination.f_in_parameters()
    return (
        Step(
            "f is linear in μ₀, and f_μ₀ = q y sin θ < 0 in contact: the friction of a direction "
            "is one number, and a state with f′ > 0 moves to larger θ as friction rises",
            expand(sp.diff(f, M) - sp.cancel(q * s * elimination.state()[y])) == 0,
        ),
        Step(
            "a fold with μ₀ > 0 and f″ < 0 has f > 0 at its θ without friction, so that the "
            "reference state, the first root, lies below it; at the fold f < 0 on both sides, and "
            "the third root lies above: to get there the state would pass the fold's θ at a "
            "smaller friction, and that θ has one friction only. So it ends at the fold, or before",
            all(step.holds for step in theorem.one_or_three()),
        ),
        Step(
            "along the folds of f″ ≠ 0 dμ₀/dθ₀ = −f_θ₀/f_μ₀: the least friction of those with f″ < "
            "0 is that of a cusp (f″ = 0), of a turn (f_θ₀ = 0), or at an end of the angles, θ₀ = "
            "0: f ≠ 0 keeps folds away from sin θ = 0 and y = 0, the steps above from θ₀ = π/2, "
            "and without friction and α > 0 a double root lies above the first, which is simple, "
            "and has f″ > 0",
            expand(elimination.f_form.subs(s, 0) - fb * c) == 0 and bool(_inclined_backward()),
        ),
        Step(
            "α = 0: at a turn κ σ cos θ cos θ₀ = 0, and neither cos θ = 0 nor θ₀ = π/2 is on a "
            "fold with μ₀ > 0: the least is at a cusp or at θ₀ = 0",
            expand((turning_line()[0] - kappa * sigma).subs(POLES).subs(alpha, 0)) == 0
            and all(value.subs(alpha, 0) == 0 for value in turning_line()[1:]),
        ),
    )
