"""The article's model against the general way: its page gives (8), (9), (14), (15), (28) and the damping that (27) leaves out.

And back from the other pages: each of them, without what it adds, has the equations of the article's page. Every comparison is exact.
"""

from __future__ import annotations

import sympy as sp

from .. import algebra, laws, linearization, pages, statics
from ..mechanics import MU, PUSHING, Mechanics
from ..motion import Motion
from . import unit_circles, equilibrium, mechanics, stability
from . import nomenclature as nm

#: Page → what it adds to the article's model, and what is left where these are 0.
ADDED = {
    "damped": ("zeta_x", "zeta_y", "zeta_s"),
    "cubic_contact": ("gamma",),
    "two_springs": ("sigma_2",),
    "inclined_belt": ("gamma_g",),
}


def identities() -> dict[str, bool]:
    """Each claim, and whether it holds."""
    article = _page("kang_nam")
    found = {
        "the page kang_nam gives the balance of forces (14), (15)": _balance(article),
        "the page kang_nam gives K (28) and the damping about steady sliding": _linearization(article),
        "the page kang_nam gives the equations of motion (8), (9)": _motion(article),
    }
    for name, added in ADDED.items():
        zero = " = ".join([*added, "0"])
        found[f"with {zero} the page {name} is the page kang_nam: balance, linearization and motion"] = _reduces(name, added)
    return found


def _page(name: str) -> Mechanics:
    return pages.read(pages.SHIPPED / f"{name}.py").mechanics


def _in_article(model: Mechanics, expression: sp.Expr) -> sp.Expr:
    """An expression of the page in the symbols of the nomenclature."""
    (line,) = model.lines
    names = {symbol: nm.quantities()[str(symbol)].symbol for symbol in expression.free_symbols if str(symbol) in nm.quantities()}
    return expression.subs({line.c: nm.c, line.s: nm.s, line.l: nm.L, MU: nm.mu, PUSHING: nm.nbar} | names, simultaneous=True)


def _polar(expression: sp.Expr) -> sp.Expr:
    """x and y by the direction and the length of the spring, (4) and (5)."""
    return sp.expand(expression.subs(dict(zip((nm.x, nm.y), equilibrium.displacement(), strict=True)), simultaneous=True))


def _equal(model: Mechanics, general: tuple[sp.Expr, ...], special: tuple[sp.Expr, ...]) -> bool:
    pairs = zip(general, special, strict=True)
    return all(unit_circles.equal(_polar(_in_article(model, ours)), _polar(theirs)) for ours, theirs in pairs)


def _balance(model: Mechanics) -> bool:
    at_rest = tuple(row.subs(MU, laws.friction_at_rest(model)) for row in model.residuals)
    return _equal(model, at_rest, equilibrium.balance_cartesian())


def _linearization(model: Mechanics) -> bool:
    K = tuple(entry.subs(MU, laws.friction_at_rest(model)) for row in statics.jacobian(model) for entry in row)
    damped = tuple(linearization.damping(model))
    return _equal(model, K, tuple(stability.stiffness())) and _equal(model, damped, tuple(stability.damping()))


def _motion(model: Mechanics) -> bool:
    equations = mechanics.motion()
    family = {nm.n: mechanics.contact_family()}
    special = (sp.solve(equations.x, equations.ax)[0].subs(family), sp.solve(equations.y, equations.ay)[0].subs(family))
    same_friction = laws.smooth_friction(model, felt=True) - mechanics.smooth_friction(nm.side)
    symbols = {symbol: nm.quantities()[str(symbol)].symbol for symbol in same_friction.free_symbols}
    return _equal(model, Motion(model).accelerations, special) and sp.simplify(same_friction.subs(symbols)) == 0


def _reduces(name: str, added: tuple[str, ...]) -> bool:
    model, article = _page(name), _page("kang_nam")
    known = {str(symbol): symbol for symbol in model.arguments}
    without = {known[symbol]: sp.S.Zero for symbol in added}
    pairs = [
        *zip(model.residuals, article.residuals, strict=True),
        *zip(_flat(statics.jacobian(model)), _flat(statics.jacobian(article)), strict=True),
        *zip(linearization.damping(model), linearization.damping(article), strict=True),
        *zip(Motion(model).accelerations, Motion(article).accelerations, strict=True),
        (Motion(model).friction, Motion(article).friction),
        (Motion(model).stored, Motion(article).stored),
    ]
    unit = tuple((line.c, line.s) for line in article.lines)
    return all(sp.expand(algebra.difference(ours.subs(without), theirs, unit)) == 0 for ours, theirs in pairs)


def _flat(rows: tuple[tuple[sp.Expr, ...], ...]) -> list[sp.Expr]:
    return [entry for row in rows for entry in row]
