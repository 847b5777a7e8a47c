"""All expressions that the statements of a page are made of, each with its line."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from .model import Damper, Page, Spring, Torsion


def expressions(page: Page) -> Iterator[tuple[sp.Expr, int]]:
    """Those of springs, dampers, energies, forces, and what laws are laws of; not the laws themselves."""
    for element in (*page.springs, *page.torsions, *page.dampers):
        yield element.coefficient if isinstance(element, Damper) else element.stiffness, element.line
        yield from ((part, element.line) for end in element.ends or () for part in end)
        if isinstance(element, Spring):
            yield element.length, element.line
        if isinstance(element, Torsion):
            yield element.rest, element.line
        elif element.along is not None:
            yield element.along, element.line
    yield from page.energies
    if page.inertia is not None:
        yield page.inertia
    for force in page.forces:
        yield from ((part, force.line) for part in (*force.components, *(force.at or ())))
    if page.sliding is not None:
        yield from (
            (part, page.sliding.line) for part in (page.sliding.along, page.sliding.belt, page.sliding.at_rest or sp.S.Zero)
        )
    if page.normal is not None and page.normal.gap is not None:
        yield page.normal.gap, page.normal.line
