"""The explorer's moving drawing of a mechanism with any number of bodies, contacts and springs:
which coordinates move and turn each body, which springs tie it, and where its contacts are, all
found from the statements of the page.

The contact of a body at (x, y), turned by φ, is a point of the body. Friction opposes its
displacement A along the belt, and its height over the belt is the gap G, so that ∂(A, G)/∂φ at the
origin is ±(−r_y, r_x), where (r_x, r_y) leads from the centre of the body to the contact. So the
derivatives of A and G give (r_x, r_y), and the sense in which φ turns.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

import sympy as sp
from sympy import Expr, S, Symbol

from . import mechanics
from .algebra import expanded
from .emit.function import Module, of_page
from .mechanics import FrictionForce, Mechanics, NormalForce
from .model import Page, Point

#: A JSON object that the explorer reads.
Plain: TypeAlias = dict[str, object]


@dataclass
class RigidBody:
    """A body by its coordinates: ``"along"`` the belt, ``"across"`` it, and the ``"angle"`` that
    turns it.
    """

    parts: dict[str, Symbol] = field(default_factory=dict)
    #: 1 where the angle turns it counter-clockwise, −1 where it does clockwise.
    sense: int = 1


@dataclass(frozen=True)
class Scene:
    """Bodies, contacts and springs of a page's mechanism."""

    model: Mechanics

    # ---------------------------------------------------------------------------------------------
    # bodies

    @property
    def page(self) -> Page:
        """The page."""
        return self.model.page

    @property
    def sliding(self) -> list[FrictionForce]:
        """Friction forces that oppose a displacement."""
        return [friction for friction in self.model.frictions if friction.along != 0]

    def _at_rest(self, expression: Expr | None, *by: Symbol) -> Expr:
        """The value of an expression where all coordinates are 0, or that of its derivative by some
        of them.
        """
        value = expression or S.Zero
        value = value.diff(*by) if by else value
        return expanded(value.subs(dict.fromkeys(self.model.coordinates, 0)))

    def _takes(self, expression: Expr | None) -> list[Symbol]:
        """Coordinates that an expression contains, in the page's order, without the phase of a
        drive.
        """
        symbols = (expression or S.Zero).free_symbols
        return [it for it in self.model.coordinates if it in symbols and it != self.model.clock]

    @cached_property
    def kinds(self) -> dict[Symbol, str]:
        """Of each coordinate whether it is ``"along"`` the belt, ``"across"`` it or an ``"angle"``,
        told by the unit, then by frictions, contacts and the ends of springs.
        """
        units = {it.symbol: it.unit for it in self.page.coordinates}
        found = {symbol: "angle" for symbol, unit in units.items() if unit == "rad"}
        found.pop(self.model.clock, "")
        for friction in self.sliding:
            for symbol in self._takes(friction.along):
                if self._at_rest(friction.along, symbol) != 0:
                    found.setdefault(symbol, "along")
        for contact in self.model.contacts:
            for symbol in self._takes(contact.gap):
                found.setdefault(symbol, "across")
        for element in (it for it in self.page.elements if it.ends is not None):
            for kind, parts in zip(
                ("along", "across"), zip(*element.ends, strict=True), strict=True
            ):
                for symbol in self._takes(sp.Tuple(*parts)):
                    found.setdefault(symbol, kind)
        for element in (it for it in self.page.elements if it.along is not None):
            tied = self._takes(element.along)
            kind = next((found[it] for it in tied if found.get(it, "angle") != "angle"), "along")
            for symbol in tied:
                found.setdefault(symbol, kind)
        return {
            it: found.get(it, "along") for it in self.model.coordinates if it != self.model.clock
        }

    @cached_property
    def bodies(self) -> list[RigidBody]:
        """The bodies: coordinates move the same one if they occur together at one end of a spring,
        or at one contact and its friction, and are of different kinds.
        """
        owner = {symbol: RigidBody({kind: symbol}) for symbol, kind in self.kinds.items()}
        for group in self._groups():
            for symbol in group:
                for other in group:
                    first, second = owner[symbol], owner[other]
                    if not first.parts.keys() & second.parts.keys():
                        first.parts |= second.parts
                        owner |= dict.fromkeys(second.parts.values(), first)
        bodies = list({id(body): body for body in owner.values()}.values())
        for body in bodies:
            body.sense = self._sense(body)
        return bodies

    def _groups(self) -> Iterator[list[Symbol]]:
        """Coordinates that occur together: at each end of a spring, and at each contact."""
        for element in self.page.elements:
            for end in element.ends or ():
                yield self._takes(sp.Tuple(*end))
        for contact in self.model.contacts:
            yield [*self._takes(self._along(contact)), *self._takes(contact.gap)]

    def _body_of(self, symbols: list[Symbol]) -> list[int]:
        """Indices of the bodies that some coordinates move, each once, in the coordinates'
        order.
        """
        owners = (
            index
            for symbol in symbols
            for index, body in enumerate(self.bodies)
            if symbol in body.parts.values()
        )
        return list(dict.fromkeys(owners))

    # ---------------------------------------------------------------------------------------------
    # contacts

    def _along(self, contact: NormalForce) -> Expr:
        """The displacement that friction opposes at a contact, 0 where there is no friction."""
        return next((it.along for it in self.sliding if it.normal == contact), S.Zero)

    def _outward(self, contact: NormalForce) -> tuple[int, int]:
        """The unit vector from a contact's body to what it touches: that in which the gap falls,
        down where the gap contains no displacement.
        """
        for symbol in self._takes(contact.gap):
            slope = self._number(self._at_rest(contact.gap, symbol))
            if self.kinds[symbol] != "angle" and slope:
                way = -1 if slope > 0 else 1
                return (way, 0) if self.kinds[symbol] == "along" else (0, way)
        return 0, -1

    def _number(self, expression: Expr) -> float:
        """The value at the base values of the parameters, those without one at 1."""
        base = {
            mechanics.number(it): it.base for it in self.model.parameters if it.base is not None
        }
        parts = {it: 1.0 for it in expression.free_symbols if it not in base}
        return float(expression.subs(base | parts))

    def _turned(self, contact: NormalForce, angle: Symbol) -> tuple[Expr, Expr]:
        """Derivatives of a contact's place, along and across, by an angle at the origin."""
        gap, along = (self._at_rest(it, angle) for it in (contact.gap, self._along(contact)))
        x, y = self._outward(contact)
        return (along, -y * gap) if y else (-x * gap, along)

    def _sense(self, body: RigidBody) -> int:
        """1 if a body's angle turns it counter-clockwise, −1 if clockwise: the one with which the
        first contact that tells lies on the side of the body where it touches.
        """
        angle = body.parts.get("angle")
        for contact in self.model.contacts if angle else ():
            x, y = self._outward(contact)
            across, up = map(self._number, self._turned(contact, angle))
            if side := x * up - y * across:
                return 1 if side > 0 else -1
        return 1

    def _arm(self, contact: NormalForce) -> tuple[Expr, Expr]:
        """The vector from the centre of a contact's body to the contact, at the origin; 0 if the
        body does not turn.
        """
        owners = self._owners(contact)
        body = self.bodies[owners[0]] if owners else RigidBody()
        if "angle" not in body.parts:
            return S.Zero, S.Zero
        across, up = self._turned(contact, body.parts["angle"])
        return body.sense * up, -body.sense * across

    def _owners(self, contact: NormalForce) -> list[int]:
        """Indices of the bodies at a contact, that of the friction first."""
        return self._body_of([*self._takes(self._along(contact)), *self._takes(contact.gap)])

    # ---------------------------------------------------------------------------------------------
    # springs

    def _ties(self) -> Iterator[Plain]:
        """Springs along coordinates, each once: linear springs, terms of potentials that give one
        coordinate a stiffness at the origin, and torsion springs.
        """
        tied = [self._takes(it.along) for it in self.page.springs if it.along is not None]
        stored = (self.model.scaled(energy) for energy, _ in self.page.energies)
        for term in sp.Add.make_args(expanded(sp.Add(*stored))):
            taken = self._takes(term)
            if len(taken) == 1 and self._at_rest(term, *taken, *taken) != 0:
                tied.append(taken)
        tied += [self._takes(sp.Tuple(*it.ends)) for it in self.page.torsions if it.ends]
        seen: list[Plain] = []
        for symbols in tied:
            kinds = [self.kinds[it] for it in symbols if self.kinds[it] != "angle"]
            tie: Plain = {
                "bodies": self._body_of(symbols),
                "kind": kinds[0] if kinds else "angle",
            }
            if symbols and tie not in seen:
                seen.append(tie)
                yield tie

    def _straight(self) -> list[tuple[Point, Point]]:
        """Both ends of the springs between two points of the plane."""
        return [it.ends for it in self.page.springs if it.ends is not None]

    # ---------------------------------------------------------------------------------------------
    # output

    def as_json(self) -> Plain:
        """Bodies, contacts and springs for the explorer; each refers to others by their indices."""
        places = {symbol: index for index, symbol in enumerate(self.model.coordinates)}
        return {
            "bodies": [
                {
                    "sense": body.sense,
                    **{kind: places[symbol] for kind, symbol in body.parts.items()},
                }
                for body in self.bodies
            ],
            "contacts": [
                {
                    "bodies": self._owners(it),
                    "outward": self._outward(it),
                    "elastic": it.gap is not None,
                    "friction": next(
                        (k for k, friction in enumerate(self.sliding) if friction.normal == it),
                        None,
                    ),
                }
                for it in self.model.contacts
            ],
            "ties": list(self._ties()),
            "springs": [
                [self._body_of(self._takes(sp.Tuple(*end)))[:1] for end in ends]
                for ends in self._straight()
            ],
        }

    def module(self) -> Module:
        """The exported function ``places``: the vector from the centre of its body to every contact
        at the origin, then both ends of every straight spring.
        """
        points = (point for ends in self._straight() for point in ends)
        function = of_page(
            "places",
            "Arms of the contacts, and ends of the straight springs.",
            (*self.model.coordinates, *self.model.arguments),
            (
                *map(self._arm, self.model.contacts),
                *(tuple(map(self.model.scaled, point)) for point in points),
            ),
            "pairs",
        )
        return Module("scene", "Places of the drawing", (function,))
