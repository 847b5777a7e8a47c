"""The article's equations of motion, (8)–(11), from its page.

The assumptions are those of the page ``derive/models/kang_nam.py``: ends of the springs, preload,
contact law, friction law. The general derivation of any page gives the equations; here they are
written in the article's symbols. The elimination, the closed forms and the theorem need these
forces: if a changed page no longer has them, the derivation stops.
"""

from functools import cache

import sympy as sp
from sympy import Expr, Symbol, expand

from .. import laws, pages
from ..algebra import Pair
from ..emit.quantities import Quantity
from ..mechanics import MU, PUSHING, SIDE, Mechanics, number
from ..model import Datum, Page, expression_of
from ..motion import Motion
from . import nomenclature as nm

#: Symbols of the accelerations.
ACCELERATIONS = sp.symbols("x_tt y_tt", real=True)
#: Rates and accelerations at steady sliding.
AT_REST = dict.fromkeys((*ACCELERATIONS, nm.vx, nm.vy), 0)

#: The dimensionless parameters of the published model.
PUBLISHED = (nm.theta0, *nm.PARAMETERS, nm.V, nm.creep)


# ------------------------------------------------------------------------------------------------
# the page


def page() -> Page:
    """The article's page, which states the assumptions."""
    return of_page().page


@cache
def of_page() -> Mechanics:
    """The mechanics of the article's page.

    Raises
    ------
    ArithmeticError
        If a changed page is not one of the article's model any more.
    """
    mechanics = pages.read(pages.SHIPPED / "kang_nam.py").mechanics
    _require(mechanics)
    return mechanics


def _require(model: Mechanics) -> None:
    """Raise if a page lacks a parameter or coordinate of the article, or gives an article's name to
    another quantity.
    """
    becomes = {datum.becomes for datum in model.page.parameters}
    published = {str(symbol) for symbol in PUBLISHED}
    expected, coordinates = {"x", "y"}, {str(symbol) for symbol in model.coordinates}
    for what, missing in (
        ("parameter that becomes", published - becomes),
        ("coordinate", expected - coordinates),
    ):
        if missing:
            raise ArithmeticError(
                f"the article's page has no {what} {', '.join(sorted(missing))}, which its "
                "closed forms are about"
            )
    if coordinates != expected or len(model.lines) != 1:
        raise ArithmeticError(
            f"the article's page has {len(coordinates)} coordinates and {len(model.lines)} "
            "inclined springs; its closed forms are about x, y and one: a model with others is a "
            "page of its own"
        )
    for datum in model.page.parameters:
        entry = nm.QUANTITIES.get(datum.becomes)
        if entry is not None and datum.becomes not in published:
            raise ArithmeticError(
                f"{datum.becomes} is {entry.meaning} in the article; give this parameter "
                "another name"
            )


def symbol_of(datum: Datum) -> Symbol:
    """The symbol of the number that a quantity of the page becomes: that of the nomenclature if it
    has one.
    """
    return nm.SYMBOLS.get(datum.becomes, number(datum))


def further_parameters() -> tuple[Symbol, ...]:
    """Symbols of the page's parameters that the published model does not have."""
    return tuple(symbol for symbol in map(symbol_of, page().parameters) if symbol not in PUBLISHED)


def quantities() -> dict[str, Quantity]:
    """The nomenclature, with further quantities of a changed page."""
    found = dict(nm.QUANTITIES)
    for it in page().parameters:
        scaled = Quantity(it.latex, f"{it.meaning}, over its scale", domain=it.domain)
        found.setdefault(it.becomes, scaled)
        measured = Quantity(it.latex, it.meaning, it.unit, it.domain)
        found.setdefault(str(it.symbol), measured)
    return found


def in_article(model: Mechanics, expression: Expr) -> Expr:
    """An expression of the general derivation in the article's symbols: x, y, and L for the length
    of the inclined spring.
    """
    names: dict[sp.Basic, Expr] = {MU: nm.mu, PUSHING: nm.nbar, SIDE: nm.side}
    names |= {number(datum): symbol_of(datum) for datum in page().parameters}
    symbols = {*model.coordinates, *model.rates}
    symbols |= {part for angle in model.angles for part in (angle.c, angle.s)}
    names |= {symbol: nm.SYMBOLS[str(symbol)] for symbol in symbols}
    directions: dict[sp.Basic, Expr] = {}
    for line in model.lines:
        directions |= {line.c: line.dx / nm.L, line.s: line.dy / nm.L, line.l: nm.L}
    return sp.sympify(expression).subs(directions, simultaneous=True).subs(names, simultaneous=True)


# ------------------------------------------------------------------------------------------------
# the inclined spring


@cache
def spring_length() -> Expr:
    """The distance from the spring's anchor to the mass at (x, y), over L_0: (4)–(6)."""
    (line,) = of_page().lines
    return in_article(of_page(), line.length)


# ------------------------------------------------------------------------------------------------
# equations of motion


@cache
def motion() -> Pair:
    """The dimensionless equations of motion (8) and (9), at rest (12) and (13), as residuals:
    accelerations − forces, in x, y, L, the contact force n and the friction coefficient μ.
    """
    general = Motion(of_page())
    accelerations = dict(zip(general.acceleration_symbols, ACCELERATIONS, strict=True))
    along, across = (
        expand(in_article(of_page(), row.subs(accelerations))) for row in general.balance(nm.n)
    )
    return along, across


# ------------------------------------------------------------------------------------------------
# contact and friction


@cache
def contact_family() -> Expr:
    """The contact force n(y) of (11) as one expression for contact (n̄ = 1) and lift-off (n̄ = 0);
    minus its slope is n̄, (29).
    """
    contact = of_page().contacts[0]
    assert contact.gap is not None
    return in_article(of_page(), contact.force.subs(contact.depth, -contact.gap))


@cache
def friction() -> Expr:
    """The friction coefficient μ at the dimensionless sliding speed V − x', (10)."""
    sliding = page().sliding
    assert sliding is not None
    law = expression_of(sliding.law(sliding.belt - page().rate(sliding.along)))
    return in_article(of_page(), of_page().scaled(law))


def smooth_friction(side: Expr) -> Expr:
    """The friction coefficient (10) for sgn(V − x') = ``side``: smooth, without absolute value and
    sign.
    """
    return in_article(of_page(), laws.smooth_friction(of_page().frictions[0], felt=True)).subs(
        nm.side, side
    )
