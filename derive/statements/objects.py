"""Objects that a statement can be about, as ``motion x`` or ``stiffness 1 2``, and how each is
derived from a page.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TypeAlias, TypeVar, cast

import sympy as sp
from sympy import Expr, Matrix, S, Symbol
from sympy.solvers.solveset import NonlinearError

from .. import laws, linearization, mechanics, physical_checks, statics, units
from ..algebra import Row
from ..emit.names import latex
from ..factors import factored
from ..mechanics import MU, PUSHING, Mechanics, NormalForce, number, of_contact
from ..model import Datum, Page, expression_of
from ..motion import Motion
from ..units import Dimension
from .identities import is_zero

#: Symbols of a print: normal force, eigenvalue of the characteristic polynomial, time.
NORMAL, LAMBDA, TIME = Symbol("N", real=True), Symbol("lam"), Symbol("t", real=True)

#: Words of objects that may be restricted to ``belt ahead``, where every friction has one sign.
MOVING = ("motion", "acceleration", "identity")

T = TypeVar("T")


class NoObject(LookupError):
    """An object that a page does not have or that can't be derived; the text says the remedy."""


@dataclass(frozen=True)
class Reading:
    """One of the values that a name may mean, and in words what is counted in it."""

    entry: Expr
    said: str


@dataclass(frozen=True)
class Object:
    """The derived object that a statement is compared with: a residual, or a value with a name.

    Lengths and inclinations of lines are symbols in ``entries``.
    """

    entries: Row  #: all components of a vector or a matrix, row by row
    by: str  #: the function that derives them
    #: how components transform with the coordinates: "scalar", "covector", "vector", "form"
    law: str = "scalar"
    index: tuple[int, ...] = (0,)  #: numbers of the entries that the statement is about
    #: by what the print may differ: "none", "constant" (a summand), or a factor that is a
    #: "monomial" of parameters or any expression in "parameters"
    factor: str = "none"
    names: frozenset[str] = frozenset()  #: names of a value; empty for a residual
    steady: bool = False  #: friction is that at steady sliding
    #: key of ``Derivation.sides``; any other word, as "both", for all of these
    side: str = "contact"
    ahead: bool = False  #: every belt is faster than what slides on it
    along: bool = False  #: accelerations are those of the motion, and not free
    unit: Dimension | None = None
    #: all values that the name may have where authors differ, the entry first
    readings: tuple[Reading, ...] = ()
    shape: tuple[int, int] | None = None  #: rows and columns of a matrix
    rows: tuple[int, ...] = ()  #: the coordinate of each row, where that is not its number

    @property
    def is_value(self) -> bool:
        """Whether this is a value with a name, not a residual that is 0."""
        return bool(self.names)


@dataclass(frozen=True)
class Derivation:
    """A page in one form, with units or scaled, in expressions of the symbols that papers print."""

    page: Page
    model: Mechanics
    scaled: bool

    @property
    def form(self) -> str:
        """The name of the form in files of statements."""
        return "scaled" if self.scaled else "units"

    @cached_property
    def found(self) -> dict[tuple[str, str], object]:
        """Cache of :meth:`kept`: what was derived, or the error."""
        return {}

    def kept(self, word: str, rest: str, derive: Callable[[], T]) -> T:
        """The result of ``derive()``, computed once for a pair of words.

        Raises
        ------
        NoObject
            If it failed now or before.
        """
        if (word, rest) not in self.found:
            try:
                self.found[word, rest] = derive()
            except (NoObject, ArithmeticError) as error:
                self.found[word, rest] = NoObject(str(error))
        found = self.found[word, rest]
        if isinstance(found, NoObject):
            raise found
        return cast(T, found)

    @cached_property
    def plain(self) -> dict[Expr, Expr]:
        """Meanings of the mechanics' symbols for lengths, directions, torsions and angles."""
        found = dict(self._angles)
        for line, (length, angle, dx, dy) in zip(self.model.lines, self.lines, strict=True):
            size = sp.sqrt(dx**2 + dy**2)
            found[line.l] = Symbol(length) if length in self.geometry else size
            is_named = angle in self.geometry
            found[line.c] = sp.cos(Symbol(angle)) if is_named else dx / size
            found[line.s] = sp.sin(Symbol(angle)) if is_named else dy / size
        for torsion in self.model.torsions:
            found[torsion.phi] = torsion.least.subs(found)
        return found

    @cached_property
    def sides(self) -> dict[str, frozenset[str]]:
        """Names of the touching contacts, for every combination of those that can open; without
        combinations of two whose gaps have a sum that is never negative, as of stops that face each
        other.
        """
        opening = [it.name for it in self.model.contacts if it.unilateral]
        never = frozenset(it.name for it in self.model.contacts) - {*opening}
        sides = {"lift-off": never} if opening else {}
        for count in range(1, len(opening)):
            for touching in itertools.combinations(opening, count):
                sides[f"contact of {', '.join(touching)} alone"] = never | {*touching}
        sides["contact"] = never | {*opening}
        apart = [
            {*pair}
            for pair in itertools.combinations(opening, 2)
            if sp.expand(sp.Add(*(self.gaps.get(it, S.Zero) for it in pair))).is_positive
        ]
        return {it: side for it, side in sides.items() if not any(map(side.issuperset, apart))}

    def meant(self, side: str) -> tuple[str, ...]:
        """The keys of ``sides`` that a side of an object stands for: itself, or all of them."""
        return (side,) if side in self.sides else tuple(self.sides)

    def side_of(self, name: str) -> str:
        """The side that is meant where none is named, about a contact, or anything else: all touch;
        where these can't, that contact alone, or any of them.
        """
        touching = [it for it, names in self.sides.items() if name in names]
        return "contact" if "contact" in self.sides else next(iter(touching), "both")

    def pushing(self, contact: NormalForce, side: str) -> Expr:
        """Contact indicator on a side: 1 if the contact touches, 0 if it is open; on "both" sides a
        symbol.
        """
        if side == "both" and contact.unilateral:
            return of_contact(PUSHING, contact.name)
        return sp.Integer(side in ("both", "contact") or contact.name in self.sides[side])

    def contact(self, name: str) -> NormalForce:
        """The contact of a name; a single contact may have the empty name.

        Raises
        ------
        NoObject
            Where the page has no such contact.
        """
        found = {it.name: it for it in self.model.contacts}
        if name not in found:
            offered = ", ".join(found) or "the only one, which is left unnamed"
            raise NoObject(f"{name!r} is no contact of the page; name {offered}")
        return found[name]

    def spelled(self, expression: Expr, side: str = "contact") -> Expr:
        """An expression of the mechanics in the symbols of a print, on a side of the contacts."""
        rubs = zip(self.model.frictions, self.coefficients, strict=True)
        known = {friction.mu: symbol for friction, symbol in rubs}
        for contact in self.model.contacts:
            known[contact.depth] = S.Zero if contact.gap is None else -contact.gap
            known[contact.pushing] = self.pushing(contact, side)
        if self.model.clock is not None:  # whose rate a print has as the speed of the clock
            known[self.model.rates[-1]] = self.model.speed
        return sp.sympify(expression).xreplace(known).xreplace(self.plain)

    def steady(self, expression: Expr, side: str = "contact") -> Expr:
        """:meth:`spelled`, with the friction coefficients at steady sliding."""
        return self.spelled(expression, side).xreplace(self.at_rest)

    def expanded(self, expression: Expr) -> Expr:
        """An expression with lengths and inclinations of lines written in coordinates."""
        return expression.xreplace({Symbol(name): it for name, it in self.geometry.items()})

    @cached_property
    def motion(self) -> Motion:
        """The equations of motion."""
        return Motion(self.model)

    @cached_property
    def accelerations(self) -> tuple[Symbol, ...]:
        """Symbols of the accelerations."""
        return self.motion.acceleration_symbols

    @cached_property
    def moved(self) -> tuple[tuple[Symbol, Symbol, Symbol], ...]:
        """Every coordinate with its rate and acceleration."""
        return tuple(zip(self.model.coordinates, self.model.rates, self.accelerations, strict=True))

    @cached_property
    def momenta(self) -> tuple[Expr, ...]:
        """The momentum ∂T/∂q′ of every coordinate, in coordinates and rates."""
        energy = self.expanded(self.spelled(self.model.kinetic + self.model.linear))
        rates = self.model.rates[: len(self.places(""))]
        return tuple(sp.diff(energy, rate) for rate in rates)

    @cached_property
    def states(self) -> tuple[Symbol, ...]:
        """Symbols of the coordinates and rates."""
        return (*self.model.coordinates, *self.model.rates)

    @cached_property
    def gaps(self) -> dict[str, Expr]:
        """The gap in coordinates of every contact that has one, by the contact's name."""
        contacts = (it for it in self.model.contacts if it.gap is not None)
        return {it.name: self.expanded(self.spelled(it.gap)) for it in contacts}

    @cached_property
    def parameters(self) -> dict[str, Symbol]:
        """Symbols of the parameters by name: with units the page's quantities, else its numbers."""
        if self.scaled:
            return {datum.becomes: number(datum) for datum in self.page.parameters}
        return {
            str(datum.symbol): datum.symbol for datum in (*self.page.units, *self.page.parameters)
        }

    @cached_property
    def _angles(self) -> dict[Expr, Expr]:
        """Cosines and sines of the page's angles, for the mechanics' symbols of them."""
        found: dict[Expr, Expr] = {}
        for angle in self.model.angles:
            found |= {angle.c: sp.cos(angle.symbol), angle.s: sp.sin(angle.symbol)}
        return found

    @cached_property
    def lines(self) -> list[tuple[str, str, Expr, Expr]]:
        """For every line the names of its length and inclination, and its vector."""
        found = []
        for index, line in enumerate(self.model.lines, 1):
            mark = f"_{index}" if len(self.model.lines) > 1 else ""
            vector = line.dx.subs(self._angles), line.dy.subs(self._angles)
            found.append((f"L{mark}", f"theta{mark}", *vector))
        return found

    @cached_property
    def geometry(self) -> dict[str, Expr]:
        """Length L and inclination theta of every line in coordinates, numbered if there are
        several lines; without those whose names the page gives to something else.
        """
        found: dict[str, Expr] = {}
        for length, angle, dx, dy in self.lines:
            found |= {length: sp.sqrt(dx**2 + dy**2), angle: sp.atan2(dy, dx)}
        taken = self.parameters.keys() | set(map(str, self.model.coordinates))
        return {name: value for name, value in found.items() if name not in taken}

    @cached_property
    def normals(self) -> dict[Symbol, Expr]:
        """The law of the normal force of every touching contact, by the symbol of that force."""
        return {of_contact(NORMAL, it.name): self.spelled(it.force) for it in self.model.contacts}

    @cached_property
    def coefficients(self) -> tuple[Symbol, ...]:
        """Symbols of the friction coefficients in a print."""
        return tuple(of_contact(MU, it.name) for it in self.model.frictions)

    @cached_property
    def friction(self) -> dict[Symbol, Expr]:
        """The friction coefficients at any state of motion; 0 on a page without friction."""
        slides = [(it.law, it.belt - self.page.rate(it.along)) for it in self.page.frictions]
        values = [self.in_form(law(speed)) for law, speed in slides]
        return dict(zip(self.coefficients, values or [S.Zero], strict=True))

    @cached_property
    def speeds(self) -> list[Expr]:
        """The sliding speed of every friction: speed of the belt minus that of the sliding body."""
        frictions = self.page.frictions
        return [self.in_form(it.belt - self.page.rate(it.along)) for it in frictions]

    def in_form(self, value: Expr) -> Expr:
        """An expression of the page in this form."""
        return self.spelled(self.model.scaled(expression_of(value)))

    @cached_property
    def laws(self) -> tuple[Symbol, ...]:
        """Symbols of the normal forces and friction coefficients that the page has."""
        forces = self.normals if self.page.contacts else ()
        return (*(self.coefficients if self.page.frictions else ()), *forces)

    @cached_property
    def at_rest(self) -> dict[Symbol, Expr]:
        """The friction coefficients at steady sliding, as statics takes them."""
        values = (self.spelled(laws.friction_at_rest(it)) for it in self.model.frictions)
        return dict(zip(self.coefficients, values, strict=True))

    @cached_property
    def switches(self) -> tuple[Symbol, ...]:
        """Symbols of the contact indicators in a print."""
        return tuple(of_contact(PUSHING, it.name) for it in self.model.contacts)

    @cached_property
    def names(self) -> dict[str, Expr]:
        """Expressions of all names that a print may use."""
        symbols = (*self.laws, *self.switches, LAMBDA, TIME, *self.states, *self.accelerations)
        return self.geometry | {str(symbol): symbol for symbol in symbols} | self.parameters

    @cached_property
    def free(self) -> frozenset[str]:
        """Names of the page that have no value there: quantities, coordinates, rates and what
        these become.
        """
        laws = map(str, (*self.laws, *self.switches))
        return frozenset(it for it, at in self.names.items() if at.is_Symbol) - {*laws}

    @cached_property
    def letters(self) -> dict[str, str]:
        """LaTeX of every name that a print may use."""
        data = self.page.parameters
        found = {str(it.symbol): it.latex for it in (*self.page.units, *data)}
        if self.scaled:
            found = {it.becomes: latex(it.becomes) for it in data}
            found |= {name: it.latex for it in data if (name := it.becomes) == str(it.symbol)}
        for it, second in zip(self.page.coordinates, self.accelerations, strict=True):
            found |= {
                str(it.symbol): it.latex,
                str(it.rate): rf"\dot{{{it.latex}}}",
                str(second): rf"\ddot{{{it.latex}}}",
            }
        for contact in self.model.contacts:
            below = contact.name and rf"_{{\mathrm{{{contact.name}}}}}"
            for symbol, letter in ((MU, r"\mu"), (NORMAL, "N"), (PUSHING, r"\overline{n}")):
                found[str(of_contact(symbol, contact.name))] = letter + below
        return found | {"lam": r"\lambda"}

    @cached_property
    def kinds(self) -> dict[str, Dimension]:
        """The dimension of every name; a scaled number has that of its quantity."""
        data = (*self.page.units, *self.page.parameters)
        known = {self.name_of(it): units.read(it.unit) for it in data}
        for entry, second in zip(self.page.coordinates, self.accelerations, strict=True):
            dimension = units.read(entry.unit)
            for symbol in (entry.symbol, entry.rate, second):
                known[str(symbol)] = dimension
                dimension = units.times(dimension, units.read("s"), -1)
        for name in self.geometry:
            known[name] = units.read("m") if name.startswith("L") else units.NONE
        found = dict.fromkeys(map(str, self.normals), units.read("N"))
        found |= dict.fromkeys(map(str, self.coefficients), units.NONE)
        return found | {"lam": units.read("Hz"), str(TIME): units.read("s")} | known

    @cached_property
    def turning(self) -> tuple[str, ...]:
        """Names of angles."""
        angles = [self.name_of(it) for it in self.page.parameters if it.unit == "rad"]
        angles += [str(it.symbol) for it in self.page.coordinates if it.unit == "rad"]
        return (*angles, *(name for name in self.geometry if name.startswith("theta")))

    def name_of(self, datum: Datum) -> str:
        """Name of a quantity of the page in this form."""
        return datum.becomes if self.scaled else str(datum.symbol)

    def measured(self, length: Expr) -> Expr:
        """A quantity of the page in this form, cached."""
        return self.kept("measured", str(length), lambda: self.model.scaled(length))

    def places(self, name: str) -> tuple[int, ...]:
        """The index of a coordinate; the indices of all but a clock's if the name is empty.

        Raises
        ------
        NoObject
            Where the page has no such coordinate.
        """
        names = [str(symbol) for symbol in self.model.coordinates]
        if not name:
            return tuple(range(len(names) - (self.model.clock is not None)))
        if name not in names:
            raise NoObject(f"{name} is no coordinate of the page; these are {', '.join(names)}")
        return (names.index(name),)


def _motion(derivation: Derivation, name: str, side: str) -> Object:
    """The equations of motion, as residuals."""
    normals = zip(derivation.normals, derivation.model.contacts, strict=True)
    forces = (S.Zero if derivation.pushing(one, side) == 0 else symbol for symbol, one in normals)
    rows = tuple(derivation.spelled(row, side) for row in derivation.motion.balance(*forces))
    return Object(rows, "motion.Motion.balance", "covector", derivation.places(name), "parameters")


def _acceleration(derivation: Derivation, name: str, side: str) -> Object:
    """The accelerations: the equations of motion solved for them."""
    places = derivation.places(name)
    solved = {
        symbol: derivation.spelled(value, side)
        for symbol, value in derivation.motion.inverted.items()
    }
    # Substituted twice: entries of the inverse of M hold a symbol for its determinant.
    slipping = {one.unknown: one.mu * one.normal.rubbing for one in derivation.motion.with_sticking}
    whole = (
        derivation.spelled(row.xreplace(slipping), side) for row in derivation.motion.accelerations
    )
    rows = tuple(row.subs(solved).subs(solved) for row in whole)
    second = frozenset(str(derivation.accelerations[place]) for place in places)
    return Object(rows, "motion.Motion.accelerations", "vector", places, names=second)


def _identity(derivation: Derivation, name: str, side: str) -> Object:
    """An equation of names that are known, whose entries its own left sides are."""
    if name:
        raise NoObject(f"an identity is of no {name}; leave that out")
    return Object((), "statements.derivatives.expressions")


def _energy(derivation: Derivation, name: str, side: str) -> Object:
    """The kinetic energy T, the potential energy V (or U), the Lagrangian L or Hamilton's function
    H = p q′ − L, in rates.

    The potentials of constant applied forces, the energy of the contacts and, in V, the centrifugal
    potential may be counted or not: each choice is a reading.
    """
    kinetic = derivation.spelled(
        derivation.model.kinetic + derivation.model.linear + derivation.model.still
    )
    still = derivation.spelled(derivation.model.still)
    potential = derivation.spelled(derivation.model.potential) + still
    if name == "T":
        by, names = "mechanics.Mechanics.kinetic", frozenset({name})
        return Object((kinetic,), by, names=names, unit=units.read("J"))
    values = {"V": potential, "L": kinetic - potential}
    values["H"] = derivation.spelled(derivation.model.kinetic) - still + potential
    if name not in values:
        raise NoObject(f"there is no energy {name}; there are T, V, L and H")
    sign = -1 if name == "L" else 1
    works = _potentials_of_forces(derivation)
    if len(works) > 3:  # all are counted, or none
        works = [sp.Add(*works)]
    pressed = (
        derivation.pushing(it, side) * derivation.spelled(it.energy, side)
        for it in derivation.model.contacts
        if it.gap is not None
    )
    choices = [("potential of an applied force", work, (True, False)) for work in works]
    choices.append(("energy of the contacts", sp.Add(*pressed), (False, True)))
    choices.append(("centrifugal potential", -still if name == "V" else S.Zero, (False, True)))
    choices = [choice for choice in choices if choice[1] != 0]
    readings = []
    for counted in itertools.product(*(order for *_, order in choices)):
        said = (
            f"{what} {'counted' if is_in else 'left out'}: {part}"
            for (what, part, _), is_in in zip(choices, counted, strict=True)
        )
        added = sp.Add(*itertools.compress((part for _, part, _ in choices), counted))
        readings.append(Reading(values[name] + sign * added, "; ".join(said)))
    by = "mechanics.Mechanics.potential"
    names = frozenset({name})
    if name == "V" and "U" not in derivation.names:
        names |= {"U"}
    return Object(
        (readings[0].entry,),
        by,
        "scalar",
        (0,),
        "constant",
        names,
        unit=units.read("J"),
        readings=tuple(readings) if choices else (),
    )


def _potentials_of_forces(derivation: Derivation) -> list[Expr]:
    """Potentials of the constant applied forces, as weights."""
    moving = {*derivation.page.places, *derivation.page.rates}
    found = []
    for force in derivation.page.forces:
        if not any(moving & component.free_symbols for component in force.components):
            pairs = zip(force.components, force.place, strict=True)
            work = sp.Add(
                *(derivation.measured(part) * derivation.measured(at) for part, at in pairs)
            )
            found.append(-derivation.spelled(work))
    return found


def _equilibrium(derivation: Derivation, name: str, side: str, steady: bool = True) -> Object:
    """The equations of equilibrium, with friction at steady sliding; if not ``steady``, of motion
    at rest, with friction at the sliding speed of the belt.
    """
    values = (derivation.spelled(laws.friction_at_speed(one)) for one in derivation.model.frictions)
    at_speed = dict(zip(derivation.coefficients, values, strict=True))
    mu = derivation.at_rest if steady else at_speed
    rows = tuple(derivation.spelled(row, side).xreplace(mu) for row in derivation.model.residuals)
    by, places = "mechanics.Mechanics.residuals", derivation.places(name)
    return Object(rows, by, "covector", places, "parameters", steady=steady)


def _state(derivation: Derivation, name: str, side: str) -> Object:
    """The coordinates of the equilibrium at steady sliding, for linear forces."""
    rows = [derivation.expanded(derivation.steady(row, side)) for row in derivation.model.residuals]
    try:
        stiffness, loads = sp.linear_eq_to_matrix(rows, derivation.model.coordinates)
    except NonlinearError as error:
        raise NoObject("forces are not linear; print the equations as equilibrium") from error
    whole = stiffness.det(method="laplace")
    if stiffness.has(*derivation.model.coordinates) or is_zero(whole):
        raise NoObject("there is not one state; print the equations as equilibrium")
    place = derivation.places(name)
    names = frozenset(
        f"{derivation.model.coordinates[one]}{mark}" for one in place for mark in ("", "_0")
    )
    entries = []
    for column in range(stiffness.cols):  # by Cramer's rule: quotients of sums, small to factor
        numerator = stiffness.copy()
        numerator[:, column] = loads
        entries.append(factored(numerator.det(method="laplace") / whole))
    by = "mechanics.Mechanics.residuals"
    return Object(tuple(entries), by, "vector", place, names=names, steady=True)


def _entries(
    of: Callable[[Derivation], Matrix], letter: str, by: str
) -> Callable[[Derivation, str, str], Object]:
    """The deriver of a matrix: of one entry if its row and column are named, else of all."""

    def derived(derivation: Derivation, name: str, side: str) -> Object:
        matrix = of(derivation)
        n = matrix.rows
        places = [int(part) - 1 for part in name.split() if part.isdecimal()]
        if places and (len(places) != 2 or not all(0 <= place < n for place in places)):
            raise NoObject(f"{letter} has rows and columns 1 to {n}; give two of them, or none")
        index = (places[0] * n + places[1],) if places else tuple(range(n * n))
        mark = "".join(str(place + 1) for place in places)
        names = frozenset({f"{letter}_{mark}", f"{letter}{mark}"} if places else {letter})
        shape = None if places else (n, n)
        entries = tuple(derivation.steady(entry, side) for entry in matrix)
        return Object(entries, by, "form", index, names=names, steady=True, shape=shape)

    return derived


def _system(derivation: Derivation) -> Matrix:
    """The matrix A of z′ = A z, the linearization in coordinates and rates."""
    inverse, K = _mass(derivation).inv(), _stiffness(derivation)
    C = _damping(derivation) + _gyroscopic(derivation)
    n = inverse.rows
    return Matrix([[sp.zeros(n), sp.eye(n)], [-inverse * K, -inverse * C]])


def _of_linearization(of: Callable[[Mechanics], Matrix]) -> Callable[[Derivation], Matrix]:
    """A matrix of the linearization, without the row and column of a clock, which is last."""

    def matrix(derivation: Derivation) -> Matrix:
        n = len(derivation.places(""))
        return Matrix(of(derivation.model))[:n, :n]

    return matrix


_mass = _of_linearization(lambda model: model.mass)
_damping = _of_linearization(linearization.damping)
_gyroscopic = _of_linearization(lambda model: model.gyroscopic)
_stiffness = _of_linearization(statics.jacobian)


def _characteristic(derivation: Derivation, name: str, side: str) -> Object:
    """The characteristic polynomial det(λ² M + λ (C + G) + K), as a residual."""
    rates = _damping(derivation) + _gyroscopic(derivation)
    whole = LAMBDA**2 * _mass(derivation) + LAMBDA * rates + _stiffness(derivation)
    polynomial = whole.applyfunc(lambda entry: derivation.steady(entry, side)).det(method="laplace")
    by = "linearization.damping, statics.jacobian"
    return Object((polynomial,), by, factor="parameters", steady=True)


def _threshold(derivation: Derivation, name: str, side: str) -> Object:
    """The condition of a stability threshold, as a residual.

    Divergence sets in at det K = 0; flutter without damping, of two coordinates, where the two
    eigenvalues of M⁻¹ K are equal.
    """
    K = _stiffness(derivation).applyfunc(lambda entry: derivation.steady(entry, side))
    if K.applyfunc(derivation.expanded).has(*derivation.model.coordinates):
        raise NoObject("the threshold depends on the state; only those of linear forces are judged")
    condition = K.det(method="laplace")
    if name in ("", "flutter") and K.rows == 2:
        A = _mass(derivation).inv() * K
        condition = sp.numer(sp.together((A[0, 0] - A[1, 1]) ** 2 + 4 * A[0, 1] * A[1, 0]))
    entries = (factored(condition),)
    return Object(entries, "statics.jacobian", factor="monomial", steady=True)


def _scale(derivation: Derivation, name: str, side: str) -> Object:
    """A dimensionless number, a quantity over its scale, or the scale of time, length or force."""
    groups = physical_checks.groups(derivation.page)
    named = {"time": units.read("s"), "length": units.read("m"), "force": units.read("N")}
    measured = {str(it): it for it in (*derivation.model.coordinates, *derivation.normals)}
    measured |= {name: Symbol(name) for name in derivation.geometry} | {"time": TIME}
    by, names = "physical_checks.groups", frozenset({name})
    scale = physical_checks.scale(
        derivation.page, named.get(name) or derivation.kinds.get(name, units.NONE)
    )
    if name in groups:
        return Object((groups[name],), by, "scale", names=names, unit=units.NONE)
    if scale is None or name not in measured | named:
        raise NoObject(f"{name} is no number, coordinate, time, length, force or N of the page")
    value = measured[name] / scale if name in measured else scale
    if name == "time":  # of either unit, since both are printed as t
        both = (Reading(value, "time over its scale"), Reading(scale, "the scale itself"))
        return Object((value,), by, "scale", names=names, readings=both)
    unit = named.get(name, units.NONE)
    return Object((value,), by, "scale", names=names, unit=unit)


def _normal(derivation: Derivation, name: str, side: str) -> Object:
    """The law of a normal force."""
    contact = derivation.contact(name)
    value = derivation.spelled(contact.force, side)
    names = frozenset({str(of_contact(NORMAL, name))})
    return Object((value,), "mechanics.NormalForce.force", names=names)


def _friction(derivation: Derivation, name: str, side: str) -> Object:
    """The law of a friction coefficient."""
    symbol = of_contact(MU, derivation.contact(name).name)
    if symbol not in derivation.friction:
        offered = ", ".join(map(str, derivation.friction))
        raise NoObject(f"there is no friction on {name}; there are {offered}")
    return Object(
        (derivation.friction[symbol],), "laws.smooth_friction", names=frozenset({str(symbol)})
    )


def _gap(derivation: Derivation, name: str, side: str) -> Object:
    """The gap of a contact."""
    contact = derivation.contact(name)
    if contact.gap is None:
        raise NoObject("the normal force is given, and the contact has no gap")
    own = frozenset({str(of_contact(Symbol("gap", real=True), name))})
    value = derivation.spelled(contact.gap)
    return Object((value,), "mechanics.NormalForce.gap", names=own, unit=units.read("m"))


def _pushing(derivation: Derivation, name: str, side: str) -> Object:
    """The contact indicator of a contact that can open."""
    contact = derivation.contact(name)
    if not contact.unilateral:
        raise NoObject("this contact can't open")
    symbol = derivation.pushing(contact, "both")
    own = frozenset({str(symbol)})
    return Object((symbol,), "mechanics.NormalForce.force", names=own)


def _direction(derivation: Derivation, name: str, side: str) -> Object:
    """Parts of D (cos θ, sin θ)ᵀ = b, the equilibrium in length L and inclination θ of the line."""
    in_mu = derivation.kept(
        "balance in direction", side, lambda: balance_in_direction(derivation, side)
    )
    (D, b), length = (part.xreplace(derivation.at_rest) for part in in_mu[:2]), in_mu[2]
    word, _, place = name.partition(" ")
    by, values = "objects.balance_in_direction", {"matrix": D, "slope": D.diff(length), "side": b}
    if word in ("norm", "eliminated") and not place:  # 1 = bᵀ (D Dᵀ)⁻¹ b, and times det² D
        entry = _cleared(D, b) / (D.det() ** 2 if word == "norm" else 1)
        return Object((entry,), by, steady=True)
    if word == "coefficient" and place.isdecimal():
        coefficients = derivation.kept("coefficients", side, lambda: _coefficients(*in_mu))
        entry = coefficients.get(int(place), S.Zero).xreplace(derivation.at_rest)
        return Object((entry,), by, names=frozenset({name}), steady=True)
    if word not in values or (place and word != "side") or place not in ("", "1", "2"):
        raise NoObject(
            f"direction has matrix, slope, side [1|2], norm, eliminated and coefficient K; {name!r}"
            " is none of them"
        )
    entries = tuple(values[word])
    index = (int(place) - 1,) if place else tuple(range(len(entries)))
    shape = None if place else values[word].shape
    names = frozenset({name})
    return Object(entries, by, index=index, names=names, steady=True, shape=shape)


def _cleared(D: Matrix, b: Matrix) -> Expr:
    """|adj(D) b|² − det² D, which is 0 at an equilibrium."""
    scaled = D.adjugate() * b
    return scaled.dot(scaled) - D.det() ** 2


def _coefficients(D: Matrix, b: Matrix, length: Symbol) -> dict[int, Expr]:
    """Coefficients of |adj(D) b|² − det² D as a polynomial in L, by power."""
    cleared = _cleared(D, b)
    # With symbols for cosines and sines: SymPy would otherwise simplify every coefficient by their
    # relations, which takes long.
    waves = {it: sp.Dummy() for it in cleared.atoms(sp.cos, sp.sin)}
    functions = {symbol: it for it, symbol in waves.items()}
    terms = sp.Poly(cleared.xreplace(waves), length).terms()
    return {power: value.xreplace(functions) for (power,), value in terms}


def balance_in_direction(derivation: Derivation, side: str) -> tuple[Matrix, Matrix, Symbol]:
    """D, b and L of D (cos θ, sin θ)ᵀ = b, the equilibrium of a page with one line.

    The two coordinates are replaced by the line's length L and direction. Entries hold the symbols
    of the friction coefficients.

    Raises
    ------
    NoObject
        If the page has no such form.
    """
    if (
        len(derivation.model.lines) != 1
        or len(derivation.model.coordinates) != 2
        or len(derivation.geometry) != 2
    ):
        raise NoObject("only two coordinates and one line that is named L, theta have a direction")
    (line,), ((length, angle, *_),) = derivation.model.lines, derivation.lines
    L, theta = Symbol(length), Symbol(angle)
    direction = Matrix(sp.symbols("c s"))
    ends = (derivation.spelled(line.dx), derivation.spelled(line.dy))
    equations = [end - L * part for end, part in zip(ends, direction, strict=True)]
    placed = sp.solve(equations, derivation.model.coordinates, dict=True)
    named = {sp.cos(theta): direction[0], sp.sin(theta): direction[1]}
    rows = Matrix([derivation.spelled(row, side) for row in derivation.model.residuals])
    if len(placed) != 1:
        raise NoObject("the coordinates do not follow from length and inclination of the line")
    in_direction = rows.subs(named).subs(placed[0]).applyfunc(sp.expand)
    D = in_direction.jacobian(direction)
    b = -in_direction.subs(dict.fromkeys(direction, 0))
    if sp.expand(in_direction - (D * direction - b)) != sp.zeros(2, 1) or D.has(*direction):
        raise NoObject("the equilibrium is not linear in the direction of the line")
    return D, b, L


Deriver: TypeAlias = Callable[[Derivation, str, str], Object]
#: How each object is derived, by its word.
OBJECTS: Mapping[str, Deriver] = {
    "motion": _motion,
    "acceleration": _acceleration,
    "identity": _identity,
    "energy": _energy,
    "balance": partial(_equilibrium, steady=False),
    "equilibrium": _equilibrium,
    "state": _state,
    "mass": _entries(_mass, "M", "mechanics.Mechanics.mass"),
    "damping": _entries(_damping, "C", "linearization.damping"),
    "gyroscopic": _entries(_gyroscopic, "G", "mechanics.Mechanics.gyroscopic"),
    "stiffness": _entries(_stiffness, "K", "statics.jacobian"),
    "system": _entries(_system, "A", "linearization.damping, statics.jacobian"),
    "characteristic": _characteristic,
    "threshold": _threshold,
    "scale": _scale,
    "normal": _normal,
    "friction": _friction,
    "gap": _gap,
    "pushing": _pushing,
    "direction": _direction,
}


def derivation_of(page: Page, model: Mechanics, form: str) -> Derivation:
    """The derivation of a page in a form, "scaled" or "units"."""
    scaled = form == "scaled"
    return Derivation(page, model if scaled else mechanics.of(page, units=True), scaled)


def derived(derivation: Derivation, about: str) -> Object:
    """The object that ``about`` names, as ``motion x`` or ``equilibrium x, lift-off``.

    Raises
    ------
    NoObject
        If the page has no such object; the text lists those that it has.
    """
    words, _, where = (part.strip() for part in about.partition(","))
    word, _, rest = words.partition(" ")
    ahead = where.endswith("belt ahead")
    side = where.removesuffix("belt ahead").rstrip(", ") or derivation.side_of(rest.strip())
    if word not in OBJECTS:
        raise NoObject(f"{about!r} is no object; there are {', '.join(OBJECTS)}")
    resting = ("balance", "equilibrium", "state", "characteristic", "threshold", "direction")
    if derivation.model.clock is not None and word in resting:
        raise NoObject(f"nothing rests on a page with a clock, and there is no {word}")
    if side not in (*derivation.sides, "both"):
        raise NoObject(
            f"{side!r} is no side of the contacts; there are {'; '.join(derivation.sides)}"
        )
    if ahead and not (word in MOVING and derivation.speeds):
        raise NoObject(f"belt ahead is of {' and '.join(MOVING)} on a page with friction")
    found = derivation.kept(
        word, f"{rest.strip()}, {side}", lambda: OBJECTS[word](derivation, rest.strip(), side)
    )
    if word == "pushing":  # the indicator distinguishes the sides
        side = "both"
    return replace(found, ahead=ahead, side=side)
