"""Whether generated code can say what a page says: smooth, angles by cosine and sine, roots, exponentials and whole powers.

Kinks are where a mass touches the belt and where friction turns, and nowhere else: equilibria are sought by derivatives, and a motion
is integrated from one kink to the next. Each error names the line, what stands there, and the remedy.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from . import laws
from .mechanics import DEPTH, Mechanics, number
from .model import Damper, PageError, Spring, expression_of

#: Functions with a kink or a step, of which a sum of smooth forces has none.
_KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise, sp.Heaviside, sp.floor, sp.ceiling)


def check(model: Mechanics) -> None:
    """A :class:`~derive.model.PageError` for the first statement that generated code can't say."""
    moving = {*model.coordinates, *model.rates, DEPTH, laws.SLIP}
    angles = {number(datum) for datum in model.parameters if datum.unit == "rad"}
    for value, what, line in _statements(model):
        _check(value, what, line, moving, angles)
    energy, contact = model.contact_energy, model.page.normal
    if contact and (energy.has(sp.Integral) or not all(isinstance(node, sp.exp | sp.log) for node in energy.atoms(sp.Function))):
        raise PageError(
            contact.line, f"the contact law {model.law} has no energy in powers, exponentials and logarithms; give one that has"
        )


def _check(value: sp.Expr, what: str, line: int, moving: set[sp.Symbol], angles: set[sp.Symbol]) -> None:
    turned = value.atoms(sp.cos, sp.sin)
    if turned:
        node = min(turned, key=sp.default_sort_key)
        inner = node.args[0]
        if inner.free_symbols & moving:
            raise PageError(
                line, f"{what} takes {node}, and {inner} moves; cosines are of angles of the page: write a polynomial, or an exp"
            )
        raise PageError(
            line,
            f"{what} takes {node}, and {inner} is no sum of whole multiples of angles of the page; make it a parameter with the unit rad",
        )
    bare = sorted(map(str, value.free_symbols & angles))
    if bare:
        raise PageError(
            line, f"{what} takes the angle {bare[0]} itself; angles are in forces by cos({bare[0]}) and sin({bare[0]}) only"
        )
    for node in sorted(value.atoms(*_KINKED), key=sp.default_sort_key):
        if node.free_symbols & moving:
            raise PageError(
                line,
                f"{what} holds {node}, which is not smooth where its argument changes its sign; kinks are at the touch of the belt and at "
                "the turn of friction only: write something smooth, as a power or an exp",
            )
    if value.has(sp.I, sp.oo, sp.nan, sp.zoo):
        raise PageError(line, f"{what} is {value}, which is no real number; write one that is")
    for node in sorted(value.atoms(sp.Function), key=sp.default_sort_key):
        if not isinstance(node, (sp.exp, *_KINKED)):
            raise PageError(
                line, f"{what} holds {node}, which generated code does not know; say it by exp, sqrt and whole powers"
            )
    for node in sorted(value.atoms(sp.Pow), key=sp.default_sort_key):
        if not (2 * node.exp).is_Integer:
            raise PageError(
                line, f"{what} holds {node}; powers are whole or halves of whole ones, as {node.base}**2 or sqrt({node.base})"
            )


def _statements(model: Mechanics) -> Iterator[tuple[sp.Expr, str, int]]:
    """Every expression of the page without units, what it is, and its line."""
    page, scaled = model.page, model.scaled
    for element in (*page.springs, *page.torsions, *page.dampers):
        kind = "damper" if isinstance(element, Damper) else "spring"
        strength = element.coefficient if isinstance(element, Damper) else element.stiffness
        yield scaled(strength), f"the strength of this {kind}", element.line
        for part in (part for end in element.ends or () for part in end):
            yield scaled(part), f"the end of this {kind}", element.line
        if isinstance(element, Spring):
            yield scaled(element.length), "the undeformed length of this spring", element.line
        along = getattr(element, "along", None)
        if along is not None:
            yield scaled(along), f"along of this {kind}", element.line
    for torsion in page.torsions:
        for function in (sp.cos, sp.sin):
            yield scaled(function(torsion.rest)), "the inclination at rest of this spring", torsion.line
    for energy, line in page.energies:
        yield scaled(energy), "this potential energy", line
    if page.inertia is not None:
        yield scaled(page.inertia[0]), "the kinetic energy", page.inertia[1]
    for force in page.forces:
        for part in (*force.components, *(force.at or ())):
            yield scaled(part), "this force", force.line
    if page.normal is not None:
        yield scaled(page.normal.gap if page.normal.gap is not None else sp.S.Zero), "the gap", page.normal.line
        yield model.law, "the contact law", page.normal.line
    if page.sliding is not None:
        for sign in (1, -1):
            yield scaled(expression_of(page.sliding.law(sign * laws.SLIP))), "the friction law", page.sliding.line
        for part in (page.sliding.along, page.sliding.belt, page.sliding.at_rest or sp.S.Zero):
            yield scaled(part), "the friction", page.sliding.line
