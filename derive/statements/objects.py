"""Objects of a derivation that a statement can be about, from the functions that derive them."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy as sp

from .. import laws, linearization, mechanics, physical_checks, statics, units
from ..algebra import Row
from ..mechanics import DEPTH, MU, PUSHING, Mechanics, number
from ..model import Page, expression_of
from ..motion import Motion
from ..units import Dimension

#: Normal force, frequency parameter of the characteristic polynomial.
NORMAL, LAMBDA = sp.Symbol("N", real=True), sp.Symbol("lam")

#: Applied forces that may be counted in an energy one by one; of more all are, or none.
MOST_FORCES = 3


class NoObject(LookupError):
    """An object that a page does not have, or that can't be derived; with the remedy."""


@dataclass(frozen=True)
class Reading:
    """One of the values that a name may mean, and what is counted in it."""

    entry: sp.Expr
    said: str


@dataclass(frozen=True)
class Object:
    """What a statement is held against.

    ``entries`` are all components of a ``law`` of transformation between coordinates: scalar,
    covector, vector or form; ``index`` are the places of those that the statement is about. A
    residual may have a factor: "none", "constant" to be added, "parameters" of any kind, or a
    "monomial" of them. A value has the names by which it is called; where authors differ in what
    they count in it, ``readings`` has every value that may be meant, the entry first.
    """

    entries: Row
    by: str
    law: str = "scalar"
    index: tuple[int, ...] = (0,)
    factor: str = "none"
    names: frozenset[str] = frozenset()
    steady: bool = False  #: friction is that at steady sliding
    apart: bool = False  #: in lift-off
    unit: Dimension | None = None
    readings: tuple[Reading, ...] = ()

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

    @cached_property
    def found(self) -> dict[str, Object]:
        """Objects that were asked for."""
        return {}

    @cached_property
    def plain(self) -> dict[sp.Expr, sp.Expr]:
        """What stands for directions, lengths, turnings and angles of the general derivation."""
        found: dict[sp.Expr, sp.Expr] = {}
        for angle in self.model.angles:
            found |= {angle.c: sp.cos(angle.symbol), angle.s: sp.sin(angle.symbol)}
        for line in self.model.lines:
            dx, dy = line.dx.subs(found), line.dy.subs(found)
            length = sp.sqrt(dx**2 + dy**2)
            found |= {line.l: length, line.c: dx / length, line.s: dy / length}
        for torsion in self.model.torsions:
            found[torsion.phi] = torsion.least.subs(found)
        return found

    def spelled(self, expression: sp.Expr, apart: bool = False) -> sp.Expr:
        """In coordinates and parameters alone, in contact or in lift-off."""
        gap = sp.S.Zero if self.model.gap is None else self.model.gap
        pushing = sp.S.Zero if apart and self.model.unilateral else sp.S.One
        inner = sp.sympify(expression).subs({DEPTH: -gap, PUSHING: pushing})
        return inner.subs(self.plain)

    @cached_property
    def motion(self) -> Motion:
        """The equations of motion."""
        return Motion(self.model)

    @cached_property
    def accelerations(self) -> tuple[sp.Symbol, ...]:
        """Symbols of the accelerations."""
        return self.motion.named

    @cached_property
    def parameters(self) -> dict[str, sp.Symbol]:
        """Parameters by name; with units the page's quantities."""
        if self.scaled:
            return {datum.becomes: number(datum) for datum in self.page.parameters}
        return {
            str(datum.symbol): datum.symbol for datum in (*self.page.units, *self.page.parameters)
        }

    @cached_property
    def geometry(self) -> dict[str, sp.Expr]:
        """Length L and inclination theta of every line, numbered where there are several."""
        found: dict[str, sp.Expr] = {}
        for place, line in enumerate(self.model.lines, 1):
            mark = "" if len(self.model.lines) == 1 else f"_{place}"
            dx, dy = line.dx.subs(self.plain), line.dy.subs(self.plain)
            found |= {f"L{mark}": sp.sqrt(dx**2 + dy**2), f"theta{mark}": sp.atan2(dy, dx)}
        taken = self.parameters.keys() | set(map(str, self.model.coordinates))
        return {name: value for name, value in found.items() if name not in taken}

    @cached_property
    def normal(self) -> sp.Expr:
        """The normal force in contact."""
        return self.spelled(self.model.normal)

    @cached_property
    def friction(self) -> sp.Expr:
        """The friction coefficient of a motion."""
        sliding = self.page.sliding
        if sliding is None:
            return sp.S.Zero
        speed = sliding.belt - self.page.rate(sliding.along)
        return self.spelled(self.model.scaled(expression_of(sliding.law(speed))))

    @cached_property
    def friction_at_rest(self) -> sp.Expr:
        """The friction coefficient at steady sliding, as the page's statics takes it."""
        return self.spelled(laws.friction_at_rest(self.model))

    @cached_property
    def names(self) -> dict[str, sp.Expr]:
        """What every name of a print stands for."""
        symbols = (*self.model.coordinates, *self.model.rates, *self.accelerations)
        found: dict[str, sp.Expr] = {"mu": MU, "N": NORMAL, "lam": LAMBDA}
        found |= self.geometry
        return found | {str(symbol): symbol for symbol in symbols} | self.parameters

    @cached_property
    def letters(self) -> dict[str, str]:
        """LaTeX of every name."""
        found = {str(it.symbol): it.latex for it in (*self.page.units, *self.page.parameters)}
        if self.scaled:
            found = {it.becomes: sp.latex(number(it)) for it in self.page.parameters}
        for it, second in zip(self.page.coordinates, self.accelerations, strict=True):
            found |= {
                str(it.symbol): it.latex,
                str(it.rate): rf"\dot{{{it.latex}}}",
                str(second): rf"\ddot{{{it.latex}}}",
            }
        return found | {"mu": r"\mu", "lam": r"\lambda"}

    @cached_property
    def kinds(self) -> dict[str, Dimension]:
        """The dimension of every name; of a number that of the quantity behind it."""
        data = (*self.page.units, *self.page.parameters)
        known = {it.becomes if self.scaled else str(it.symbol): units.read(it.unit) for it in data}
        for entry, second in zip(self.page.coordinates, self.accelerations, strict=True):
            dimension = units.read(entry.unit)
            for symbol in (entry.symbol, entry.rate, second):
                known[str(symbol)] = dimension
                dimension = units.times(dimension, units.TIME, -1)
        for name in self.geometry:
            known[name] = units.LENGTH if name.startswith("L") else units.NONE
        return {
            "N": units.FORCE,
            "mu": units.NONE,
            "lam": units.times(units.NONE, units.TIME, -1),
        } | known

    @cached_property
    def turning(self) -> tuple[str, ...]:
        """Names of angles of which a print may take cosine and sine."""
        entries = [
            (it.becomes if self.scaled else str(it.symbol), it.unit) for it in self.page.parameters
        ]
        entries += [(str(it.symbol), it.unit) for it in self.page.coordinates]
        angles = [name for name, unit in entries if unit == "rad"]
        return (*angles, *(name for name in self.geometry if name.startswith("theta")))

    @property
    def dimensions(self) -> dict[str, Dimension]:
        """The dimension of every name; none where all are numbers."""
        return {} if self.scaled else self.kinds

    def measured(self, length: sp.Expr) -> sp.Expr:
        """A quantity of the page in this form."""
        if length not in self._measured:
            self._measured[length] = length if length.is_number else self.model.scaled(length)
        return self._measured[length]

    @cached_property
    def _measured(self) -> dict[sp.Expr, sp.Expr]:
        return {}

    def place(self, name: str) -> int:
        """The place of a coordinate.

        Raises
        ------
        NoObject
            Where the page has no such coordinate.
        """
        names = [str(symbol) for symbol in self.model.coordinates]
        if name not in names:
            raise NoObject(f"{name} is no coordinate of the page; these are {', '.join(names)}")
        return names.index(name)


def _motion(it: Derivation, name: str, apart: bool) -> Object:
    contact = sp.S.Zero if apart or it.page.normal is None else NORMAL
    rows = tuple(it.spelled(row, apart) for row in it.motion.balance(contact))
    return Object(rows, "motion.Motion.balance", "covector", (it.place(name),), "parameters")


def _acceleration(it: Derivation, name: str, apart: bool) -> Object:
    place = it.place(name)
    solved = {symbol: it.spelled(value, apart) for symbol, value in it.motion.inverted.items()}
    # Entries of the inverse of M are over its determinant, which is itself a shorthand.
    whole = (it.spelled(row, apart).subs(solved).subs(solved) for row in it.motion.accelerations)
    rows = tuple(whole)
    second = frozenset({str(it.accelerations[place])})
    return Object(rows, "motion.Motion.accelerations", "vector", (place,), names=second)


def _energy(it: Derivation, name: str, apart: bool) -> Object:
    """An energy, V also as U; V and L count potentials of constant applied forces or do not."""
    kinetic = it.spelled(it.model.kinetic)
    potential = it.spelled(it.model.potential)
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
    if len(works) <= MOST_FORCES:
        ways = list(itertools.product((True, False), repeat=len(works)))
    for counted in ways:
        said = (
            f"potential of an applied force {'counted' if is_in else 'left out'}: {work}"
            for work, is_in in zip(works, counted, strict=True)
        )
        added = sum(itertools.compress(works, counted), sp.S.Zero)
        readings.append(Reading(values[name] + sign * added, "; ".join(said)))
    by = "mechanics.Mechanics.potential"
    other = {"U"} - it.names.keys() if name == "V" else set()
    names = frozenset({name, *other})
    entries, several = (readings[0].entry,), tuple(readings) if works else ()
    return Object(
        entries, by, "scalar", (0,), "constant", names, unit=units.ENERGY, readings=several
    )


def _potentials_of_forces(it: Derivation) -> list[sp.Expr]:
    """Potentials of the applied forces that are constant: weights and pushes."""
    moving = {*it.page.places, *it.page.rates}
    found = []
    for force in it.page.forces:
        if not any(moving & component.free_symbols for component in force.components):
            pairs = zip(force.components, force.place, strict=True)
            work = sum((it.measured(part) * it.measured(at) for part, at in pairs), sp.S.Zero)
            found.append(-it.spelled(work))
    return found


def _balance(it: Derivation, name: str, apart: bool) -> Object:
    """Forces of the motion at rest, with the friction at the belt's speed."""
    mu = laws.friction_at_speed(it.model)
    rows = tuple(it.spelled(row, apart).subs(MU, it.spelled(mu)) for row in it.model.residuals)
    return Object(
        rows, "mechanics.Mechanics.residuals", "covector", (it.place(name),), "parameters"
    )


def _equilibrium(it: Derivation, name: str, apart: bool) -> Object:
    mu = it.spelled(laws.friction_at_rest(it.model))
    rows = tuple(it.spelled(row, apart).subs(MU, mu) for row in it.model.residuals)
    return Object(
        rows,
        "mechanics.Mechanics.residuals",
        "covector",
        (it.place(name),),
        "parameters",
        steady=True,
        apart=apart,
    )


def _entries(
    of: Callable[[Derivation], sp.Matrix], letter: str, by: str
) -> Callable[[Derivation, str, bool], Object]:
    def derived(it: Derivation, name: str, apart: bool) -> Object:
        mu = it.spelled(laws.friction_at_rest(it.model))
        matrix = of(it).applyfunc(lambda entry: it.spelled(entry, apart).subs(MU, mu))
        n = len(it.model.coordinates)
        places = [int(part) - 1 for part in name.split() if part.isdigit()]
        if places and (len(places) != 2 or not all(0 <= place < n for place in places)):
            raise NoObject(f"{letter} has rows and columns 1 to {n}; give two of them, or none")
        index = (places[0] * n + places[1],) if places else tuple(range(n * n))
        mark = "".join(str(place + 1) for place in places)
        names = frozenset({f"{letter}_{mark}", f"{letter}{mark}"} if places else {letter})
        return Object(tuple(matrix), by, "form", index, names=names, steady=True, apart=apart)

    return derived


def _characteristic(it: Derivation, name: str, apart: bool) -> Object:
    mass, C = it.model.mass, linearization.damping(it.model)
    K = sp.Matrix(statics.jacobian(it.model))
    mu = it.spelled(laws.friction_at_rest(it.model))
    whole = (LAMBDA**2 * mass + LAMBDA * C + K).applyfunc(lambda entry: it.spelled(entry, apart))
    polynomial = whole.subs(MU, mu).det()
    by = "linearization.damping, statics.jacobian"
    return Object((polynomial,), by, factor="parameters", steady=True, apart=apart)


def _threshold(it: Derivation, name: str, apart: bool) -> Object:
    mu = it.spelled(laws.friction_at_rest(it.model))
    K = sp.Matrix(statics.jacobian(it.model)).applyfunc(it.spelled).subs(MU, mu)
    if K.has(*it.model.coordinates):
        raise NoObject("the threshold depends on the state; only those of linear forces are judged")
    A = it.model.mass.inv() * K
    flutter = sp.S.One
    if A.rows == 2:
        flutter = sp.numer(sp.together((A[0, 0] - A[1, 1]) ** 2 + 4 * A[0, 1] * A[1, 0]))
    choice = flutter if name in ("", "flutter") and A.rows == 2 else K.det()
    return Object((sp.factor(choice),), "statics.jacobian", factor="monomial", steady=True)


def _scale(it: Derivation, name: str, apart: bool) -> Object:
    groups = physical_checks.groups(it.page)
    named = {"time": units.TIME, "length": units.LENGTH, "force": units.FORCE}
    value = groups.get(name)
    for coordinate in it.page.coordinates:
        if str(coordinate.symbol) == name:
            scale = physical_checks.scale(it.page, units.read(coordinate.unit))
            value = None if scale is None else coordinate.symbol / scale
    if name in named or name == "N":
        scale = physical_checks.scale(it.page, named.get(name, units.FORCE))
        value = None if scale is None else (NORMAL / scale if name == "N" else scale)
    if value is None:
        raise NoObject(f"{name} is no number, coordinate, time, length, force or N of the page")
    unit = named.get(name, units.NONE)
    by, names = "physical_checks.groups", frozenset({name})
    return Object((value,), by, "scale", names=names, unit=unit)


def _normal(it: Derivation, name: str, apart: bool) -> Object:
    value = it.spelled(it.model.normal, apart)
    return Object((value,), "mechanics.Mechanics.normal", names=frozenset({"N"}), apart=apart)


def _friction(it: Derivation, name: str, apart: bool) -> Object:
    return Object((it.friction,), "laws.smooth_friction", names=frozenset({"mu"}))


Deriver: TypeAlias = Callable[[Derivation, str, bool], Object]
#: How each object is derived, by its word.
OBJECTS: Mapping[str, Deriver] = {
    "motion": _motion,
    "acceleration": _acceleration,
    "energy": _energy,
    "balance": _balance,
    "equilibrium": _equilibrium,
    "mass": _entries(lambda it: it.model.mass, "M", "mechanics.Mechanics.mass"),
    "damping": _entries(lambda it: linearization.damping(it.model), "C", "linearization.damping"),
    "stiffness": _entries(
        lambda it: sp.Matrix(statics.jacobian(it.model)), "K", "statics.jacobian"
    ),
    "characteristic": _characteristic,
    "threshold": _threshold,
    "scale": _scale,
    "normal": _normal,
    "friction": _friction,
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
    if word not in OBJECTS or where not in ("", "lift-off"):
        raise NoObject(f"{about!r} is no object; there are {', '.join(OBJECTS)}")
    if about not in it.found:
        it.found[about] = OBJECTS[word](it, rest.strip(), where == "lift-off")
    return it.found[about]
