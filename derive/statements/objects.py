"""Objects of a derivation that a statement can be about, from the functions that derive them."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeAlias, TypeVar, cast

import sympy as sp
from sympy import Expr, Matrix, S, Symbol
from sympy.solvers.solveset import NonlinearError

from .. import laws, linearization, mechanics, physical_checks, statics, units
from ..algebra import Row
from ..mechanics import MU, PUSHING, Mechanics, NormalForce, number, of_contact
from ..model import Datum, Page, expression_of
from ..motion import Motion
from ..units import Dimension

#: Normal force, frequency parameter of the characteristic polynomial, time.
NORMAL, LAMBDA, TIME = Symbol("N", real=True), Symbol("lam"), Symbol("t", real=True)

#: Behind the side of these words ``belt ahead`` may stand: then a friction has one sign.
MOVING = ("motion", "acceleration")

T = TypeVar("T")


class NoObject(LookupError):
    """An object that a page does not have, or that can't be derived; with the remedy."""


@dataclass(frozen=True)
class Reading:
    """One of the values that a name may mean, and what is counted in it."""

    entry: Expr
    said: str


@dataclass(frozen=True)
class Object:
    """Object that a statement is held against.

    ``entries`` are all components of a ``law`` of transformation between coordinates: scalar,
    covector, vector or form; ``index`` are the places of those that the statement is about. A
    residual may have a factor: "none", "constant" to be added, "parameters" of any kind, or a
    "monomial" of them. A value has the names by which it is called; where authors differ in what
    they count in it, ``readings`` has every value that may be meant, the entry first. ``shape`` has
    the rows and columns of a matrix. Lengths and inclinations of lines stand by their names.
    """

    entries: Row
    by: str
    law: str = "scalar"
    index: tuple[int, ...] = (0,)
    factor: str = "none"
    names: frozenset[str] = frozenset()
    steady: bool = False  #: friction is that at steady sliding
    side: str = "contact"  #: the contacts that touch, one of the model's sides, or both of them
    ahead: bool = False  #: every belt is ahead of what slides on it
    unit: Dimension | None = None
    readings: tuple[Reading, ...] = ()
    shape: tuple[int, int] | None = None

    @property
    def is_value(self) -> bool:
        """A value that is called by a name, not a residual that is 0."""
        return bool(self.names)


@dataclass(frozen=True)
class Derivation:
    """A page in one form, with units or scaled, in plain expressions of its symbols."""

    page: Page
    model: Mechanics
    scaled: bool

    @property
    def form(self) -> str:
        """As files of statements say it."""
        return "scaled" if self.scaled else "units"

    @cached_property
    def found(self) -> dict[tuple[str, str], object]:
        """Object that is asked for by its word and the rest, or the reason why the page does not
        have it.
        """
        return {}

    def kept(self, word: str, rest: str, derive: Callable[[], T]) -> T:
        """Derived object, derived once; or the reason why it can't be."""
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
        """Expressions for directions, lengths, turnings and angles of the general derivation."""
        found = dict(self._angles)
        for line, (length, turn, dx, dy) in zip(self.model.lines, self._lines, strict=True):
            named, size = self.geometry.keys(), sp.sqrt(dx**2 + dy**2)
            found[line.l] = Symbol(length) if length in named else size
            is_named = turn in named
            found[line.c] = sp.cos(Symbol(turn)) if is_named else dx / size
            found[line.s] = sp.sin(Symbol(turn)) if is_named else dy / size
        for torsion in self.model.torsions:
            found[torsion.phi] = torsion.least.subs(found)
        return found

    @cached_property
    def sides(self) -> dict[str, frozenset[str]]:
        """The contacts that touch, by their names, in every combination of those that can open."""
        opening = [it.name for it in self.model.contacts if it.unilateral]
        never = frozenset(it.name for it in self.model.contacts) - {*opening}
        found = {"lift-off": never} if opening else {}
        for count in range(1, len(opening)):
            for some in itertools.combinations(opening, count):
                found[f"contact of {', '.join(some)} alone"] = never | {*some}
        return found | {"contact": never | {*opening}}

    def pushing(self, contact: NormalForce, side: str) -> Expr:
        """1 where a contact touches on a side, else 0; a symbol where it may do either."""
        if side == "both" and contact.unilateral:
            return of_contact(PUSHING, contact.name)
        return sp.Integer(side == "both" or contact.name in self.sides[side])

    def contact(self, name: str) -> NormalForce:
        """The contact of a name, or the only one, which has none.

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
        """In coordinates, parameters, lengths and inclinations, on a side of the contact."""
        rubs = zip(self.model.frictions, self.coefficients, strict=True)
        known = {friction.mu: symbol for friction, symbol in rubs}
        for contact in self.model.contacts:
            known[contact.depth] = S.Zero if contact.gap is None else -contact.gap
            known[contact.pushing] = self.pushing(contact, side)
        return sp.sympify(expression).xreplace(known).xreplace(self.plain)

    def steady(self, expression: Expr, side: str = "contact") -> Expr:
        """The same, with the friction at steady sliding."""
        return self.spelled(expression, side).xreplace(self.at_rest)

    def expanded(self, expression: Expr) -> Expr:
        """With lengths and inclinations of lines in coordinates."""
        return expression.xreplace({Symbol(name): it for name, it in self.geometry.items()})

    @cached_property
    def motion(self) -> Motion:
        """The equations of motion."""
        return Motion(self.model)

    @cached_property
    def accelerations(self) -> tuple[Symbol, ...]:
        """Symbols of the accelerations."""
        return self.motion.named

    @cached_property
    def parameters(self) -> dict[str, Symbol]:
        """Parameters by name; with units the page's quantities."""
        if self.scaled:
            return {datum.becomes: number(datum) for datum in self.page.parameters}
        return {
            str(datum.symbol): datum.symbol for datum in (*self.page.units, *self.page.parameters)
        }

    @cached_property
    def _angles(self) -> dict[Expr, Expr]:
        """Cosines and sines of the page's angles for their symbols."""
        found: dict[Expr, Expr] = {}
        for angle in self.model.angles:
            found |= {angle.c: sp.cos(angle.symbol), angle.s: sp.sin(angle.symbol)}
        return found

    @cached_property
    def _lines(self) -> list[tuple[str, str, Expr, Expr]]:
        """Names of the length and the inclination of every line, and its vector."""
        found = []
        for index, line in enumerate(self.model.lines, 1):
            mark = f"_{index}" if len(self.model.lines) > 1 else ""
            vector = line.dx.subs(self._angles), line.dy.subs(self._angles)
            found.append((f"L{mark}", f"theta{mark}", *vector))
        return found

    @cached_property
    def geometry(self) -> dict[str, Expr]:
        """Length L and inclination theta of every line, numbered where there are several."""
        found: dict[str, Expr] = {}
        for length, angle, dx, dy in self._lines:
            found |= {length: sp.sqrt(dx**2 + dy**2), angle: sp.atan2(dy, dx)}
        taken = self.parameters.keys() | set(map(str, self.model.coordinates))
        return {name: value for name, value in found.items() if name not in taken}

    @cached_property
    def normals(self) -> dict[Symbol, Expr]:
        """The normal force of every contact, by its symbol in a print: its law where it touches."""
        return {of_contact(NORMAL, it.name): self.spelled(it.force) for it in self.model.contacts}

    @cached_property
    def coefficients(self) -> tuple[Symbol, ...]:
        """Symbols of the friction coefficients in a print."""
        return tuple(of_contact(MU, it.name) for it in self.model.frictions)

    @cached_property
    def friction(self) -> dict[Symbol, Expr]:
        """The friction coefficients of a motion; 0 of a page without friction."""
        slides = [(it.law, it.belt - self.page.rate(it.along)) for it in self.page.frictions]
        values = [self._in_form(law(speed)) for law, speed in slides]
        return dict(zip(self.coefficients, values or [S.Zero], strict=True))

    @cached_property
    def speeds(self) -> list[Expr]:
        """The sliding speed of every friction: that of the belt less that of what slides on it."""
        frictions = self.page.frictions
        return [self._in_form(it.belt - self.page.rate(it.along)) for it in frictions]

    def _in_form(self, value: Expr) -> Expr:
        """An expression of the page in this form."""
        return self.spelled(self.model.scaled(expression_of(value)))

    @cached_property
    def at_rest(self) -> dict[Symbol, Expr]:
        """The friction coefficients at steady sliding, as the page's statics takes them."""
        values = (self.spelled(laws.friction_at_rest(it)) for it in self.model.frictions)
        return dict(zip(self.coefficients, values, strict=True))

    @cached_property
    def switches(self) -> tuple[Symbol, ...]:
        """PUSHING of every contact in a print."""
        return tuple(of_contact(PUSHING, it.name) for it in self.model.contacts)

    @cached_property
    def names(self) -> dict[str, Expr]:
        """Meanings of all names of a print."""
        symbols = (*self.model.coordinates, *self.model.rates, *self.accelerations)
        symbols = (*self.coefficients, *self.normals, *self.switches, LAMBDA, TIME, *symbols)
        return self.geometry | {str(symbol): symbol for symbol in symbols} | self.parameters

    @cached_property
    def letters(self) -> dict[str, str]:
        """LaTeX of every name."""
        data = self.page.parameters
        found = {str(it.symbol): it.latex for it in (*self.page.units, *data)}
        if self.scaled:
            found = {it.becomes: sp.latex(number(it)) for it in data}
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
        """The dimension of every name; of a number that of the quantity behind it."""
        data = (*self.page.units, *self.page.parameters)
        known = {self.name_of(it): units.read(it.unit) for it in data}
        for entry, second in zip(self.page.coordinates, self.accelerations, strict=True):
            dimension = units.read(entry.unit)
            for symbol in (entry.symbol, entry.rate, second):
                known[str(symbol)] = dimension
                dimension = units.times(dimension, units.TIME, -1)
        for name in self.geometry:
            known[name] = units.LENGTH if name.startswith("L") else units.NONE
        found = dict.fromkeys(map(str, self.normals), units.FORCE)
        found |= dict.fromkeys(map(str, self.coefficients), units.NONE)
        return found | {"lam": units.RATE, str(TIME): units.TIME} | known

    @cached_property
    def turning(self) -> tuple[str, ...]:
        """Names of angles of which a print may take cosine and sine."""
        angles = [self.name_of(it) for it in self.page.parameters if it.unit == "rad"]
        angles += [str(it.symbol) for it in self.page.coordinates if it.unit == "rad"]
        return (*angles, *(name for name in self.geometry if name.startswith("theta")))

    def name_of(self, datum: Datum) -> str:
        """Name of a quantity of the page in this form."""
        return datum.becomes if self.scaled else str(datum.symbol)

    def measured(self, length: Expr) -> Expr:
        """A quantity of the page in this form."""
        if length not in self._measured:
            self._measured[length] = length if length.is_number else self.model.scaled(length)
        return self._measured[length]

    @cached_property
    def _measured(self) -> dict[Expr, Expr]:
        return {}

    def places(self, name: str) -> tuple[int, ...]:
        """The place of a coordinate, or those of all where none is named.

        Raises
        ------
        NoObject
            Where the page has no such coordinate.
        """
        names = [str(symbol) for symbol in self.model.coordinates]
        if not name:
            return tuple(range(len(names)))
        if name not in names:
            raise NoObject(f"{name} is no coordinate of the page; these are {', '.join(names)}")
        return (names.index(name),)


def _motion(it: Derivation, name: str, side: str) -> Object:
    normals = zip(it.normals, it.model.contacts, strict=True)
    forces = (S.Zero if it.pushing(one, side) == 0 else symbol for symbol, one in normals)
    rows = tuple(it.spelled(row, side) for row in it.motion.balance(*forces))
    return Object(rows, "motion.Motion.balance", "covector", it.places(name), "parameters")


def _acceleration(it: Derivation, name: str, side: str) -> Object:
    places = it.places(name)
    solved = {symbol: it.spelled(value, side) for symbol, value in it.motion.inverted.items()}
    # Entries of the inverse of M are over its determinant, which is itself a shorthand.
    slipping = {one.unknown: one.mu * one.normal.rubbing for one in it.motion.holding}
    whole = (it.spelled(row.xreplace(slipping), side) for row in it.motion.accelerations)
    rows = tuple(row.subs(solved).subs(solved) for row in whole)
    second = frozenset(str(it.accelerations[place]) for place in places)
    return Object(rows, "motion.Motion.accelerations", "vector", places, names=second)


def _energy(it: Derivation, name: str, side: str) -> Object:
    """An energy, V also as U; V and L count potentials of constant applied forces or do not."""
    kinetic = it.spelled(it.model.kinetic + it.model.linear + it.model.still)
    potential = it.spelled(it.model.potential + it.model.still)
    if name == "T":
        by, names = "mechanics.Mechanics.kinetic", frozenset({name})
        return Object((kinetic,), by, names=names, unit=units.ENERGY)
    values = {"V": potential, "L": kinetic - potential}
    if name not in values:
        raise NoObject(f"there is no energy {name}; there are T, V and L")
    sign = 1 if name == "V" else -1
    works = _potentials_of_forces(it)
    readings = []
    ways = [(True,) * len(works), (False,) * len(works)]
    # Applied forces that may be counted in an energy one by one; of more all are, or none.
    if len(works) <= 3:
        ways = list(itertools.product((True, False), repeat=len(works)))
    for counted in ways:
        said = (
            f"potential of an applied force {'counted' if is_in else 'left out'}: {work}"
            for work, is_in in zip(works, counted, strict=True)
        )
        added = sp.Add(*itertools.compress(works, counted))
        readings.append(Reading(values[name] + sign * added, "; ".join(said)))
    by = "mechanics.Mechanics.potential"
    other = {"U"} - it.names.keys() if name == "V" else set()
    names = frozenset({name, *other})
    entries, several = (readings[0].entry,), tuple(readings) if works else ()
    return Object(
        entries, by, "scalar", (0,), "constant", names, unit=units.ENERGY, readings=several
    )


def _potentials_of_forces(it: Derivation) -> list[Expr]:
    """Potentials of the applied forces that are constant: weights and pushes."""
    moving = {*it.page.places, *it.page.rates}
    found = []
    for force in it.page.forces:
        if not any(moving & component.free_symbols for component in force.components):
            pairs = zip(force.components, force.place, strict=True)
            work = sp.Add(*(it.measured(part) * it.measured(at) for part, at in pairs))
            found.append(-it.spelled(work))
    return found


def _balance(it: Derivation, name: str, side: str) -> Object:
    """Forces of the motion at rest, with the friction at the belt's speed."""
    values = (it.spelled(laws.friction_at_speed(one)) for one in it.model.frictions)
    mu = dict(zip(it.coefficients, values, strict=True))
    rows = tuple(it.spelled(row, side).xreplace(mu) for row in it.model.residuals)
    return Object(rows, "mechanics.Mechanics.residuals", "covector", it.places(name), "parameters")


def _equilibrium(it: Derivation, name: str, side: str) -> Object:
    return Object(
        tuple(it.steady(row, side) for row in it.model.residuals),
        "mechanics.Mechanics.residuals",
        "covector",
        it.places(name),
        "parameters",
        steady=True,
    )


def _state(it: Derivation, name: str, side: str) -> Object:
    """The coordinates at steady sliding where all forces are linear, which is one state."""
    rows = [it.expanded(it.steady(row, side)) for row in it.model.residuals]
    try:
        stiffness, loads = sp.linear_eq_to_matrix(rows, it.model.coordinates)
    except NonlinearError as error:
        raise NoObject("forces are not linear; print the equations as equilibrium") from error
    if stiffness.has(*it.model.coordinates) or stiffness.det().equals(0):
        raise NoObject("there is not one state; print the equations as equilibrium")
    place = it.places(name)
    names = frozenset(f"{it.model.coordinates[one]}{mark}" for one in place for mark in ("", "_0"))
    by, solved = "mechanics.Mechanics.residuals", stiffness.LUsolve(loads)
    entries = tuple(map(sp.factor, solved))
    return Object(entries, by, "vector", place, names=names, steady=True)


def _entries(
    of: Callable[[Derivation], Matrix], letter: str, by: str
) -> Callable[[Derivation, str, str], Object]:
    def derived(it: Derivation, name: str, side: str) -> Object:
        matrix = of(it)
        n = matrix.rows
        places = [int(part) - 1 for part in name.split() if part.isdigit()]
        if places and (len(places) != 2 or not all(0 <= place < n for place in places)):
            raise NoObject(f"{letter} has rows and columns 1 to {n}; give two of them, or none")
        index = (places[0] * n + places[1],) if places else tuple(range(n * n))
        mark = "".join(str(place + 1) for place in places)
        names = frozenset({f"{letter}_{mark}", f"{letter}{mark}"} if places else {letter})
        shape = None if places else (n, n)
        entries = tuple(it.steady(entry, side) for entry in matrix)
        return Object(entries, by, "form", index, names=names, steady=True, shape=shape)

    return derived


def _system(it: Derivation) -> Matrix:
    """A of z′ = A z for small deviations z, the coordinates and then their rates."""
    mass = it.model.mass.inv()
    K, C = statics.jacobian(it.model), linearization.damping(it.model) + it.model.gyroscopic
    n = mass.rows
    above = sp.zeros(n).row_join(sp.eye(n))
    return above.col_join((-mass * Matrix(K)).row_join(-mass * C))


def _characteristic(it: Derivation, name: str, side: str) -> Object:
    mass, C = it.model.mass, linearization.damping(it.model) + it.model.gyroscopic
    K = Matrix(statics.jacobian(it.model))
    whole = LAMBDA**2 * mass + LAMBDA * C + K
    polynomial = whole.applyfunc(lambda entry: it.steady(entry, side)).det(method="laplace")
    by = "linearization.damping, statics.jacobian"
    return Object((polynomial,), by, factor="parameters", steady=True)


def _threshold(it: Derivation, name: str, side: str) -> Object:
    K = Matrix(statics.jacobian(it.model)).applyfunc(lambda entry: it.steady(entry, side))
    if K.applyfunc(it.expanded).has(*it.model.coordinates):
        raise NoObject("the threshold depends on the state; only those of linear forces are judged")
    A = it.model.mass.inv() * K
    flutter = S.One
    if A.rows == 2:
        flutter = sp.numer(sp.together((A[0, 0] - A[1, 1]) ** 2 + 4 * A[0, 1] * A[1, 0]))
    choice = flutter if name in ("", "flutter") and A.rows == 2 else K.det()
    entries = (sp.factor(choice),)
    return Object(entries, "statics.jacobian", factor="monomial", steady=True)


def _scale(it: Derivation, name: str, side: str) -> Object:
    groups = physical_checks.groups(it.page)
    named = {"time": units.TIME, "length": units.LENGTH, "force": units.FORCE}
    measured = {str(it): it for it in (*it.model.coordinates, *it.normals)}
    measured |= {name: Symbol(name) for name in it.geometry} | {"time": TIME}
    by, names = "physical_checks.groups", frozenset({name})
    scale = physical_checks.scale(it.page, named.get(name) or it.kinds.get(name, units.NONE))
    if name in groups:
        return Object((groups[name],), by, "scale", names=names, unit=units.NONE)
    if scale is None or name not in measured | named:
        raise NoObject(f"{name} is no number, coordinate, time, length, force or N of the page")
    value = measured[name] / scale if name in measured else scale
    both = (Reading(value, "time over its scale"), Reading(scale, "the scale itself"))
    unit = units.NONE if name not in named else named[name] if name != "time" else None
    return Object(
        (value,), by, "scale", names=names, unit=unit, readings=both if name == "time" else ()
    )


def _normal(it: Derivation, name: str, side: str) -> Object:
    contact = it.contact(name)
    value = it.spelled(contact.force, side)
    names = frozenset({str(of_contact(NORMAL, name))})
    return Object((value,), "mechanics.NormalForce.force", names=names)


def _friction(it: Derivation, name: str, side: str) -> Object:
    symbol = of_contact(MU, it.contact(name).name)
    if symbol not in it.friction:
        offered = ", ".join(map(str, it.friction))
        raise NoObject(f"there is no friction on {name}; there are {offered}")
    return Object((it.friction[symbol],), "laws.smooth_friction", names=frozenset({str(symbol)}))


def _gap(it: Derivation, name: str, side: str) -> Object:
    contact = it.contact(name)
    if contact.gap is None:
        raise NoObject("the normal force is given, and the contact has no gap")
    own = frozenset({str(of_contact(Symbol("gap", real=True), name))})
    value = it.spelled(contact.gap)
    return Object((value,), "mechanics.NormalForce.gap", names=own, unit=units.LENGTH)


def _pushing(it: Derivation, name: str, side: str) -> Object:
    contact = it.contact(name)
    if not contact.unilateral:
        raise NoObject("this contact can't open")
    symbol = it.pushing(contact, "both")
    own = frozenset({str(symbol)})
    return Object((symbol,), "mechanics.NormalForce.force", names=own)


def _direction(it: Derivation, name: str, side: str) -> Object:
    """Parts of D (cos θ, sin θ)ᵀ = b, the equilibrium in length L and inclination θ of the line."""
    in_mu = it.kept("balance in direction", side, lambda: balance_in_direction(it, side))
    (D, b), length = (part.xreplace(it.at_rest) for part in in_mu[:2]), in_mu[2]
    word, _, place = name.partition(" ")
    by, values = "objects.balance_in_direction", {"matrix": D, "slope": D.diff(length), "side": b}
    if word in ("norm", "eliminated") and not place:  # 1 = bᵀ (D Dᵀ)⁻¹ b, and times det² D
        entry = _cleared(D, b) / (D.det() ** 2 if word == "norm" else 1)
        return Object((entry,), by, steady=True)
    if word == "coefficient" and place.isdigit():
        coefficients = it.kept("coefficients", side, lambda: _coefficients(*in_mu))
        entry = coefficients.get(int(place), S.Zero).xreplace(it.at_rest)
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
    """|adj(D) b|² − det² D."""
    scaled = D.adjugate() * b
    return scaled.dot(scaled) - D.det() ** 2


def _coefficients(D: Matrix, b: Matrix, length: Symbol) -> dict[int, Expr]:
    """Coefficients of |adj(D) b|² − det² D by the powers of L."""
    cleared = _cleared(D, b)
    # Symbols for cosines and sines: related coefficients would be simplified one by one.
    waves = {it: sp.Dummy() for it in cleared.atoms(sp.cos, sp.sin)}
    functions = {symbol: it for it, symbol in waves.items()}
    terms = sp.Poly(cleared.xreplace(waves), length).terms()
    return {power: value.xreplace(functions) for (power,), value in terms}


def balance_in_direction(it: Derivation, side: str) -> tuple[Matrix, Matrix, Symbol]:
    """D and b of two coordinates, in MU, and L: linear in the direction of a line."""
    if len(it.model.lines) != 1 or len(it.model.coordinates) != 2 or len(it.geometry) != 2:
        raise NoObject("only two coordinates and one line that is named L, theta have a direction")
    (line,), ((length, angle, *_),) = it.model.lines, it._lines
    L, theta = Symbol(length), Symbol(angle)
    direction = Matrix(sp.symbols("c s"))
    ends = (it.spelled(line.dx), it.spelled(line.dy))
    gaps = [end - L * way for end, way in zip(ends, direction, strict=True)]
    placed = sp.solve(gaps, it.model.coordinates, dict=True)
    named = {sp.cos(theta): direction[0], sp.sin(theta): direction[1]}
    rows = Matrix([it.spelled(row, side) for row in it.model.residuals])
    if len(placed) != 1:
        raise NoObject("the coordinates do not follow from length and inclination of the line")
    turned = rows.subs(named).subs(placed[0]).applyfunc(sp.expand)
    D = turned.jacobian(direction)
    b = -turned.subs(dict.fromkeys(direction, 0))
    if sp.expand(turned - (D * direction - b)) != sp.zeros(2, 1) or D.has(*direction):
        raise NoObject("the equilibrium is not linear in the direction of the line")
    return D, b, L


Deriver: TypeAlias = Callable[[Derivation, str, str], Object]
#: How each object is derived, by its word.
OBJECTS: Mapping[str, Deriver] = {
    "motion": _motion,
    "acceleration": _acceleration,
    "energy": _energy,
    "balance": _balance,
    "equilibrium": _equilibrium,
    "state": _state,
    "mass": _entries(lambda it: it.model.mass, "M", "mechanics.Mechanics.mass"),
    "damping": _entries(lambda it: linearization.damping(it.model), "C", "linearization.damping"),
    "gyroscopic": _entries(lambda it: it.model.gyroscopic, "G", "mechanics.Mechanics.gyroscopic"),
    "stiffness": _entries(lambda it: Matrix(statics.jacobian(it.model)), "K", "statics.jacobian"),
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


def derivation(page: Page, model: Mechanics, form: str) -> Derivation:
    """A page in the form that a statement asks for."""
    scaled = form == "scaled"
    return Derivation(page, model if scaled else mechanics.of(page, units=True), scaled)


def derived(it: Derivation, about: str) -> Object:
    """The object that ``about`` names, as ``motion x`` or ``equilibrium x, lift-off``.

    Raises
    ------
    NoObject
        Where the page has no such object, with those that there are.
    """
    said, _, where = (part.strip() for part in about.partition(","))
    word, _, rest = said.partition(" ")
    ahead = where.endswith("belt ahead")
    side = where.removesuffix("belt ahead").rstrip(", ") or "contact"
    if word not in OBJECTS:
        raise NoObject(f"{about!r} is no object; there are {', '.join(OBJECTS)}")
    resting = ("balance", "equilibrium", "state", "characteristic", "threshold", "direction")
    if it.model.clock is not None and word in resting:
        raise NoObject(f"nothing rests on a page with a clock, and there is no {word}")
    if side not in (*it.sides, "both"):
        raise NoObject(f"{side!r} is no side of the contacts; there are {'; '.join(it.sides)}")
    if ahead and not (word in MOVING and it.speeds):
        raise NoObject(f"belt ahead is of {' and '.join(MOVING)} on a page with friction")
    found = it.kept(word, f"{rest.strip()}, {side}", lambda: OBJECTS[word](it, rest.strip(), side))
    # What tells the sides apart is meant on both.
    return replace(found, ahead=ahead, side="both" if word == "pushing" else side)
