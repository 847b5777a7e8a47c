"""Proofs that the article's own derivation and the general one of any page agree.

K of (28), damping, and D and b of (16)–(25) are derived in both ways and compared exactly. Some
other pages are proved to have the equations of the article's page where what they add is 0.
"""

import sympy as sp
from sympy import Expr, Matrix

from .. import algebra, hurwitz, laws, linearization, pages, statics
from ..emit.definitions import flat
from ..mechanics import MU
from ..motion import Motion
from ..statements import objects

from . import unit_circles, equilibrium, mechanics, routh, stability
from . import nomenclature as nm

#: Pages, and the parameters that they add to the article's model.
ADDED = {
    "damped": ("zeta_x", "zeta_y", "zeta_s"),
    "cubic_contact": ("gamma",),
    "two_springs": ("sigma_2",),
    "inclined_belt": ("gamma_g",),
}


def identities() -> dict[str, bool]:
    """Each claim, and whether it holds."""
    found = {
        "the general way gives K (28) and the damping about steady sliding": _linearization(),
        "the general way gives D and b, (16)–(19) and (22)–(25)": _in_direction(),
        "the general way gives Hurwitz's determinants c, c K₁₁, c² K₁₂ K₂₁ and c² K₁₂ K₂₁ det K": (
            _hurwitz()
        ),
    }
    for name, added in ADDED.items():
        zero = " = ".join([*added, "0"])
        found[
            f"with {zero} the page {name} is the page kang_nam: balance, linearization and motion"
        ] = _reduces(name, added)
    return found


def _polar(expression: Expr) -> Expr:
    """An expression with x and y replaced by direction and length of the spring, (4) and (5)."""
    return sp.expand(expression.subs(equilibrium.displacement(), simultaneous=True))


def _linearization() -> bool:
    """Whether stiffness and damping agree."""
    model = mechanics.of_page()
    mu = laws.friction_at_rest(model.frictions[0])
    general = (*Matrix(statics.jacobian(model)).subs(MU, mu), *linearization.damping(model))
    pairs = zip(general, (*stability.stiffness(), *stability.damping()), strict=True)
    return all(
        unit_circles.equal(_polar(mechanics.in_article(model, ours)), _polar(theirs))
        for ours, theirs in pairs
    )


def _in_direction() -> bool:
    """Whether D and b, with which printed equations are compared, are those of the elimination."""
    derivation = objects.derivation_of(mechanics.page(), mechanics.of_page(), "scaled")
    D, b = equilibrium.matrix_form()
    directions = {sp.cos(nm.theta0): nm.c0, sp.sin(nm.theta0): nm.s0}
    pairs: list[tuple[Expr, Expr]] = []
    for side, case in (("contact", equilibrium.CONTACT), ("lift-off", equilibrium.LIFTOFF)):
        ours_D, ours_b, length = objects.balance_in_direction(derivation, side)
        ours = (*ours_D.subs(length, nm.L), *ours_b)
        pairs += zip(ours, (*D.subs(case), *b.subs(case)), strict=True)
    return all(
        unit_circles.equal(
            mechanics.in_article(derivation.model, one.xreplace(derivation.at_rest)).subs(
                directions
            ),
            other,
        )
        for one, other in pairs
    )


def _hurwitz() -> bool:
    """Whether what decides the stability of any page is what the theorem of the article's asks."""
    general = hurwitz.conditions(mechanics.of_page())
    M, C, K = general.matrices
    names = {C[0, 0]: routh.DAMPING, **dict(zip(K, routh.STIFFNESS, strict=True))}
    ours = (one.subs(general.coefficients).subs(names) for one in general.determinants)
    pairs = zip(ours, routh.hurwitz_determinants(), strict=True)
    return (
        M == sp.eye(2) and not any(C[1:]) and all(sp.expand(one - two) == 0 for one, two in pairs)
    )


def _reduces(name: str, added: tuple[str, ...]) -> bool:
    """Whether a page is the article's page where the added parameters are 0."""
    model, article = pages.read(pages.SHIPPED / f"{name}.py").mechanics, mechanics.of_page()
    by_name = {str(symbol): symbol for symbol in model.arguments}
    without = {by_name[symbol]: sp.S.Zero for symbol in added}
    pairs = [
        *zip(model.residuals, article.residuals, strict=True),
        *zip(flat(statics.jacobian(model)), flat(statics.jacobian(article)), strict=True),
        *zip(linearization.damping(model), linearization.damping(article), strict=True),
        *zip(Motion(model).accelerations, Motion(article).accelerations, strict=True),
        *zip(*(Motion(one).coefficients.values() for one in (model, article)), strict=True),
        (Motion(model).stored, Motion(article).stored),
    ]
    unit = tuple((line.c, line.s) for line in article.lines)
    return all(algebra.equal(ours.subs(without), theirs, unit) for ours, theirs in pairs)
