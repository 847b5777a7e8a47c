"""What the modules of the catalogue share: lists of arguments, shorthands, and the check of what is
arranged by hand.
"""

import sympy as sp

from ...algebra import Names, Row, Symbols
from .. import unit_circles, elimination, equilibrium, mechanics
from ..nomenclature import PARAMETERS, c, c0, fa, fb, fd, fm, s, s0, vx, vy

ANGLE0 = (c0, s0)
ANGLE = (c, s)
#: A point of parameters, all of them but the friction, and those that are stiffnesses.
POINT, WITHOUT_FRICTION, STIFFNESS = (*ANGLE0, *PARAMETERS), PARAMETERS[1:], PARAMETERS[2:]
F_COEFFICIENTS = (fa, fb, fd, fm)


def require_same(what: str, arranged: Row, derived: Row, names: Names | None = None) -> None:
    """Raise unless the form arranged for emission equals, exactly, the form that was derived;
    ``names`` are shorthands in the first.
    """
    for ours, theirs in zip(arranged, derived, strict=True):
        for _ in range(3):  # a shorthand may stand in another one
            ours = ours.subs(names or {})
        if not unit_circles.equal(equilibrium.spell_out(ours), equilibrium.spell_out(theirs)):
            raise ArithmeticError(f"{what}: the arrangement for emission is not what was derived")


def shorthands(case: dict[sp.Symbol, int] | None = None) -> Names:
    """Definitions of the shorthands: in contact, in lift-off, or with n̄ as a symbol where no case
    is given.
    """
    definitions = {**equilibrium.SHORTHANDS, **elimination.f_coefficients()}
    return {symbol: value.subs(case or {}) for symbol, value in definitions.items()}


def in_contact() -> Names:
    """Shorthands of the equilibria in contact."""
    return shorthands(equilibrium.CONTACT)


def further(listed: Symbols, result: sp.Expr) -> Symbols:
    """Speeds, and parameters of a changed model, on which the result depends and which are not
    among the arguments ``listed``.
    """
    free = result.free_symbols - set(listed)
    return tuple(symbol for symbol in (vx, vy, *mechanics.further_parameters()) if symbol in free)
