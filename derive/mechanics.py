"""Mechanics of a page: energies, generalized forces and mass matrix, dimensionless or with units.

A spring between two points has the vector (dx, dy) from its first end, on the mass, to its second,
the length l and the direction (c, s) = (dx, dy)/l. Forces are written in the symbols c, s and l,
and derivatives follow by the chain rule

    ∂l = c ∂dx + s ∂dy,    ∂c = s (s ∂dx − c ∂dy)/l,    ∂s = −c (s ∂dx − c ∂dy)/l,

so that no square root is differentiated. The angle of a torsion spring is a symbol φ, with

    ∂φ = (c ∂dy − s ∂dx)/l − ∂rest,

so that its energy is k φ²/2 and its forces are linear in φ. Generated code computes l and φ, with
one root and one arc tangent, and then evaluates these expressions.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from sympy import Add, Dummy, Expr, Matrix, S, Symbol, diff

from .algebra import Circles, Names, Pair, Row, Symbols, expanded, fewest_terms, quotients, rooted
from .model import Contact, Datum, Element, Page, PageError, Point, expression_of, speed_of

#: Contact indicator: 1 in contact, 0 in lift-off; n̄ of the article.
PUSHING = Symbol("pushing", real=True)
#: Sign of the sliding speed: 1 if the belt is faster, −1 if the mass is.
SIDE = Symbol("side", real=True)
#: The friction coefficient as an argument of functions.
MU = Symbol("mu", real=True)
#: The share of the static coefficient in use while friction sticks, from −1 (against the belt) to
#: 1.
HELD = Symbol("held", real=True)
#: Penetration, positive, the variable of a contact law.
DEPTH = Symbol("_depth", positive=True)
#: Sliding speed, positive, the variable of a friction law.
SLIP = Symbol("_slip", positive=True)


@dataclass(frozen=True)
class Line:
    """A straight line between two points, with the symbols of its direction and length."""

    dx: Expr
    dy: Expr
    rest: Expr  #: undeformed length of the spring along it, 0 for a damper alone
    c: Symbol
    s: Symbol
    l: Symbol
    line: int

    @property
    def length(self) -> Expr:
        """The length in terms of the vector."""
        return sp.sqrt(self.dx**2 + self.dy**2)

    def slopes(self, dx: Expr, dy: Expr) -> Names:
        """Changes of length and direction, by their symbols, if the vector changes by (dx, dy)."""
        cross = self.s * dx - self.c * dy
        return {
            self.l: self.c * dx + self.s * dy,
            self.c: self.s * cross / self.l,
            self.s: -self.c * cross / self.l,
        }


@dataclass(frozen=True)
class Turning:
    """A torsion spring: the angle φ in (−π, π] by which a line is turned from its inclination at
    rest.
    """

    line: Line
    stiffness: Expr
    rest: Expr  #: the inclination at rest
    cosine_of_rest: Expr
    sine_of_rest: Expr
    phi: Symbol
    way: Symbol  #: the branch of φ: 1 if it is continued beyond π, −1 if beyond −π

    @property
    def cosine(self) -> Expr:
        """cos φ."""
        return self.line.c * self.cosine_of_rest + self.line.s * self.sine_of_rest

    @property
    def sine(self) -> Expr:
        """sin φ."""
        return self.line.s * self.cosine_of_rest - self.line.c * self.sine_of_rest

    @property
    def energy(self) -> Expr:
        """k φ²/2."""
        return self.stiffness * self.phi**2 / 2

    @property
    def least(self) -> Expr:
        """The principal value of φ, by atan2."""
        return sp.atan2(self.sine, self.cosine)

    @property
    def continued(self) -> Expr:
        """φ on its branch, from −π/2 to 3π/2 or from −3π/2 to π/2: smooth at ±π, where the
        principal value jumps.
        """
        return self.way * (sp.pi / 2 - sp.atan2(self.cosine, self.way * self.sine))

    @property
    def border(self) -> Expr:
        """A function that is positive for way · φ from −0.93 to π; the branch changes at its zeros.

        Both branches have the border ±π.
        """
        return 1 + self.cosine + 2 * self.way * self.sine


@dataclass(frozen=True)
class Angle:
    """A parameter that is an angle: expressions hold symbols for its cosine and sine."""

    symbol: Symbol
    c: Symbol
    s: Symbol
    alone: bool  #: whether they also hold the angle itself, as in k (φ − θ₀)²/2

    @property
    def parts(self) -> Symbols:
        """The symbols that stand for the angle among the arguments of functions."""
        return (self.symbol, self.c, self.s) if self.alone else (self.c, self.s)


def of_contact(symbol: Symbol, name: str, mark: str = "") -> Symbol:
    """A symbol with a mark before it and the contact's name behind it; a single contact has the
    empty name.
    """
    return Symbol(f"{mark}{symbol}{name and '_'}{name}", **symbol.assumptions0)


@dataclass(frozen=True)
class NormalForce:
    """The normal force of a contact: a law of the penetration −gap, or a given force.

    Two regimes meet at its border. A unilateral contact has a force for gap ≤ 0 and none beyond. A
    contact with two faces, as in a slot, has the same force N in both regimes, and friction of
    |N|: there PUSHING says the sign of N.
    """

    name: str  #: empty if there is only one contact
    gap: Expr | None
    unilateral: bool  #: whether it can open
    either_face: bool  #: whether friction acts on either of two faces
    law: Expr  #: in :attr:`depth`
    #: whether the force is written in coordinates and not in the penetration
    in_coordinates: bool
    line: int
    #: prefix of the symbols PUSHING, MU, SIDE and HELD: an underscore if the page uses one of these
    #: names
    mark: str = ""

    @property
    def pushing(self) -> Symbol:
        """PUSHING of this contact."""
        return of_contact(PUSHING, self.name, self.mark)

    @property
    def depth(self) -> Symbol:
        """DEPTH of this contact."""
        return of_contact(DEPTH, self.name)

    @property
    def polynomial(self) -> bool:
        """Whether the law is a polynomial of the penetration."""
        return bool(self.law.is_polynomial(self.depth))

    @cached_property
    def push(self) -> Expr:
        """The normal force in contact, in coordinates or in the penetration."""
        if self.gap is not None and self.in_coordinates:
            return expanded(self.law.subs(self.depth, -self.gap))
        return self.law

    @cached_property
    def force(self) -> Expr:
        """The normal force in either regime, with PUSHING."""
        return self.pushing * self.push if self.unilateral else self.push

    @property
    def rubbing(self) -> Expr:
        """The size of the normal force that friction takes, with PUSHING."""
        return (2 * self.pushing - 1) * self.push if self.either_face else self.force

    @cached_property
    def border(self) -> Expr | None:
        """A function that is ≤ 0 where PUSHING is 1 and ≥ 0 where it is 0; None if there is only
        one regime.
        """
        if self.either_face:
            return -self.push if self.gap is None else -self.push.subs(self.depth, -self.gap)
        return self.gap if self.unilateral else None

    @cached_property
    def energy(self) -> Expr:
        """The energy of the contact: the integral of the law from 0 to the penetration."""
        energy = sp.integrate(self.law, self.depth)
        return energy - energy.subs(self.depth, 0)

    @cached_property
    def penetration(self) -> Expr:
        """The value of DEPTH: −gap in contact; in lift-off, where the law is multiplied by 0, a
        tiny number at which it is finite.

        The square keeps SymPy from expanding (1 − PUSHING): a term 1 in the sum would cost a
        shallow penetration its last digits.
        """
        if self.gap is None:
            return S.Zero
        if not self.unilateral:
            return -self.gap
        # Small, so that no exponential of it is infinite; not 0, where roots have infinite slopes.
        in_liftoff = sp.Rational(1, 2**40)
        return self.pushing * (-self.gap) + (1 - self.pushing) ** 2 * in_liftoff


@dataclass(frozen=True)
class FrictionForce:
    """Friction on a contact: μ times its normal force, against a displacement."""

    normal: NormalForce
    along: Expr  #: the displacement that it opposes; 0 if there is no friction
    rate: Expr  #: d(along)/dt
    belt: Expr  #: speed of the belt
    still: Expr  #: speed of the belt at phase 0 of the clock
    #: the coefficient in :data:`SLIP`, for a belt faster or slower than the mass
    ahead: Expr
    behind: Expr
    holds: Expr | None  #: static coefficient of dry friction
    at_rest: Expr | None  #: coefficient that statics takes, if the page names one
    line: int

    @property
    def name(self) -> str:
        """The name of its contact."""
        return self.normal.name

    @property
    def mu(self) -> Symbol:
        """The symbol of this friction's coefficient."""
        return of_contact(MU, self.name and f"on_{self.name}", self.normal.mark)

    @property
    def side(self) -> Symbol:
        """The symbol of this friction's side: 1 or −1, the sign of its sliding speed."""
        return of_contact(SIDE, self.name and f"on_{self.name}", self.normal.mark)

    @property
    def held(self) -> Symbol:
        """HELD of a function of this friction."""
        return of_contact(HELD, "", self.normal.mark)

    @property
    def stuck(self) -> Symbol:
        """The symbol that is 1 while this friction sticks, 0 while it slides."""
        return of_contact(Symbol("_stuck", real=True), self.name)

    @property
    def unknown(self) -> Symbol:
        """The symbol of the force of dry friction."""
        return of_contact(Symbol("_friction", real=True), self.name)


def named(function: str, of: NormalForce | FrictionForce) -> str:
    """The name of a generated function that there is for each contact or friction."""
    return f"{function}_{of.name}" if of.name else function


def on(of: NormalForce | FrictionForce) -> str:
    """The name of the contact for a sentence, " of front"; empty if there is only one."""
    return f" of {of.name}" if of.name else ""


@dataclass(frozen=True)
class Mechanics:
    """The mechanics of a model: the parts of which its equations are made."""

    page: Page
    coordinates: Symbols
    rates: Symbols
    parameters: tuple[Datum, ...]
    angles: tuple[Angle, ...]
    lines: tuple[Line, ...]
    torsions: tuple[Turning, ...]
    kinetic: Expr  #: terms of the kinetic energy that are quadratic in the rates
    linear: Expr  #: terms that are linear in the rates, as in a rotating frame
    still: Expr  #: terms without rates; the potential holds them with the other sign
    #: in coordinates, lengths and torsion angles, without contacts and applied forces
    potential: Expr
    stiffnesses: Row  #: of the spring along every line, 0 if there is only a damper
    applied: Row  #: generalized applied forces
    #: Rayleigh's dissipation function, half the power of the dampers
    dissipation: Expr
    contacts: tuple[NormalForce, ...]  #: a force that is 0 on a page without contacts
    frictions: tuple[FrictionForce, ...]  #: one along 0 on a page without friction
    clock: Symbol | None  #: the coordinate that grows at a given rate
    speed: Expr  #: that rate; 0 without a clock
    scaled: Callable[[Expr], Expr]  #: makes an expression of the page dimensionless

    @property
    def holds(self) -> bool:
        """Whether there is dry friction, which sticks."""
        return any(friction.holds is not None for friction in self.frictions)

    # ---------------------------------------------------------------------------------------------
    # names

    @cached_property
    def arguments(self) -> Symbols:
        """Arguments of functions for all parameters, an angle as cosine and sine."""
        return tuple(symbol for datum in self.parameters for symbol in self.parts(number(datum)))

    def parts(self, symbol: Symbol) -> Symbols:
        """Arguments of functions for one parameter, an angle as cosine and sine."""
        return next((angle.parts for angle in self.angles if angle.symbol == symbol), (symbol,))

    @cached_property
    def directions(self) -> Symbols:
        """c, s and l of every line."""
        return tuple(symbol for line in self.lines for symbol in (line.c, line.s, line.l))

    @cached_property
    def turned(self) -> Symbols:
        """φ of every torsion spring."""
        return tuple(torsion.phi for torsion in self.torsions)

    # ---------------------------------------------------------------------------------------------
    # the chain rule

    def partial(self, expression: Expr, symbol: Symbol) -> Expr:
        """∂/∂symbol at constant directions and lengths; an angle by the chain rule of its cosine
        and sine.
        """
        for angle in self.angles:
            if angle.symbol == symbol:
                by_angle = angle.c * diff(expression, angle.s) - angle.s * diff(expression, angle.c)
                return by_angle + diff(expression, symbol)
        return diff(expression, symbol)

    def derivative(self, expression: Expr, symbol: Symbol) -> Expr:
        """d/dsymbol, by a coordinate or a parameter, by the chain rule of directions, lengths,
        torsion angles and penetrations.
        """
        total = self.partial(expression, symbol)
        for line in self.lines:
            slopes = line.slopes(self.partial(line.dx, symbol), self.partial(line.dy, symbol))
            for inner, slope in slopes.items():
                total += diff(expression, inner) * slope
        for torsion in self.torsions:
            line = torsion.line
            angle_slope = (
                line.c * self.partial(line.dy, symbol) - line.s * self.partial(line.dx, symbol)
            ) / line.l
            total += diff(expression, torsion.phi) * (angle_slope - diff(torsion.rest, symbol))
        for contact in self.contacts:
            if contact.gap is not None and expression.has(contact.depth):
                total -= diff(expression, contact.depth) * self.partial(contact.gap, symbol)
        return total

    def tidy(self, expression: Expr) -> Expr:
        """The expression in few terms: c² + s² = 1 eliminates a square of every direction, and
        common factors are taken out.

        A parameter that occurs once makes intervals narrower.
        """
        # Functions are not expanded: exponentials may overflow, and logarithms become sums.
        nodes = sorted(
            expression.atoms(sp.exp, sp.log, sp.tanh, sp.atan)
            | self._quotients(expression)
            | rooted(expression),
            key=sp.default_sort_key,
        )
        placeholders = {1 / line.l: Dummy() for line in self.lines} | {
            node: Dummy() for node in nodes
        }
        shortest = expanded(
            expanded(expression.xreplace({node: placeholders[node] for node in nodes})).subs(
                placeholders
            )
        ).subs({friction.side**2: 1 for friction in self.frictions})
        wave_symbols, circles = self.circles(shortest)
        shortest = shortest.xreplace(wave_symbols)
        placeholders |= wave_symbols
        for cosine, sine in circles:
            if shortest.has(cosine, sine):
                shortest = fewest_terms(shortest, cosine, sine)
        factored = sp.factor_terms(
            shortest.subs({dummy: quotient for quotient, dummy in placeholders.items()})
        )
        return sp.collect(factored, tuple(map(number, self.parameters)))

    def circles(self, expression: sp.Basic) -> tuple[Names, Circles]:
        """Symbols for the cosines and sines in an expression, and all pairs of symbols on unit
        circles: first the directions of the lines, then these.
        """
        pairs = waves(expression)
        wave_symbols = {node: Dummy(real=True) for pair in pairs for node in pair}
        lines = ((line.c, line.s) for line in self.lines)
        return wave_symbols, (*lines, *((wave_symbols[c], wave_symbols[s]) for c, s in pairs))

    def _quotients(self, expression: Expr) -> set[Expr]:
        """Quotients and roots whose base holds a direction or an angle, as 1/(1 + cos² v²): these
        are no polynomials in cosine and sine.
        """
        directions = {symbol for line in self.lines for symbol in (line.c, line.s)}
        return {
            node
            for node in quotients(expression)
            if waves(node.base) or node.base.free_symbols & directions
        }

    # ---------------------------------------------------------------------------------------------
    # forces

    @property
    def pushings(self) -> Symbols:
        """PUSHING of every contact."""
        return tuple(contact.pushing for contact in self.contacts)

    @property
    def coefficients(self) -> Symbols:
        """MU of every friction."""
        return tuple(friction.mu for friction in self.frictions)

    @property
    def depths(self) -> Names:
        """Meanings of the symbols DEPTH of all contacts."""
        return {contact.depth: contact.penetration for contact in self.contacts}

    @cached_property
    def residuals(self) -> Row:
        """The residuals of the equilibrium: minus the generalized forces at rest, in MU and
        PUSHING.
        """
        return self._residuals(self.potential)

    @cached_property
    def residuals_apart(self) -> Row:
        """The residuals without torsion springs and springs along lines; each of the latter adds
        its tension times (c ∂dx + s ∂dy).
        """
        torsions = Add(*(torsion.energy for torsion in self.torsions))
        return self._residuals(expanded(self.potential - self.elastic_energy - torsions))

    @property
    def elastic_energy(self) -> Expr:
        """The energy of the springs along lines, up to a constant."""
        return Add(*map(elastic, self.lines, self.stiffnesses))

    def _residuals(self, potential: Expr) -> Row:
        rows = []
        for symbol, force in zip(self.coordinates, self.applied, strict=True):
            if symbol == self.clock:
                # The clock obeys s″ = Ω (Ω − s′), which is 0 at its rate Ω.
                rows.append(-(self.speed**2))
                continue
            row = self.derivative(potential, symbol) - self._at_rest(force)
            for contact in self.contacts:
                if contact.gap is not None:
                    row -= contact.force * diff(contact.gap, symbol)
            for friction in self.frictions:
                row -= friction.mu * friction.normal.rubbing * diff(friction.along, symbol)
            rows.append(sp.collect(expanded(row), (*self.coordinates, *self.directions)))
        return tuple(rows)

    @cached_property
    def resistance(self) -> Row:
        """Minus the forces of the dampers, and of applied forces what speeds add to them, which are
        added to the residuals.
        """
        return tuple(
            self.speed * rate
            if symbol == self.clock
            else expanded(diff(self.dissipation, rate)) + self._at_rest(force) - force
            for symbol, rate, force in zip(self.coordinates, self.rates, self.applied, strict=True)
        )

    def _at_rest(self, force: Expr) -> Expr:
        moving = {*self.rates} & force.free_symbols
        return force.subs(dict.fromkeys(moving, S.Zero)) if moving else force

    @property
    def moved(self) -> tuple[tuple[Symbol, Symbol, Expr], ...]:
        """Coordinate, rate and applied force, of every coordinate except the clock."""
        each = zip(self.coordinates, self.rates, self.applied, strict=True)
        return tuple(one for one in each if one[0] != self.clock)

    @cached_property
    def mass(self) -> Matrix:
        """The mass matrix M of the kinetic energy q′ᵀ M q′/2."""
        M = sp.hessian(self.kinetic, self.rates)
        if self.clock is not None:
            M[-1, -1] = S.One
        return M

    @cached_property
    def gyroscopic(self) -> Matrix:
        """The gyroscopic matrix G of a kinetic energy a(q) · q′ linear in the rates.

        G_ij = ∂a_i/∂q_j − ∂a_j/∂q_i is antisymmetric, so that its forces have no power.
        """
        momenta_slopes = Matrix([self.linear]).jacobian(self.rates).jacobian(self.coordinates)
        return (momenta_slopes - momenta_slopes.T).applyfunc(expanded)


def waves(expression: sp.Basic) -> list[Pair]:
    """The pairs cos u, sin u for all arguments u of cosines and sines in an expression, sorted."""
    arguments = {node.args[0] for node in expression.atoms(sp.cos, sp.sin)}
    return [
        (sp.cos(argument), sp.sin(argument))
        for argument in sorted(arguments, key=sp.default_sort_key)
    ]


def number(datum: Datum) -> Symbol:
    """The symbol of the dimensionless number that a parameter becomes."""
    assumptions = {
        name: True
        for name in ("positive", "nonnegative", "real")
        if datum.symbol.assumptions0.get(name)
    }
    return Symbol(datum.becomes, **assumptions)


def of(page: Page, units: bool = False) -> Mechanics:
    """The mechanics of a page: dimensionless, or in the page's own quantities if ``units``.

    Raises
    ------
    PageError
        If the page can't be derived.
    """
    energy, _ = page.kinetic_energy
    if page.timer is not None:  # as of a support that moves
        energy = energy.subs(speed_of(page.timer.symbol), page.timer.speed)
    scaled = _Scaled(page, units)
    lines, stiffnesses, torsions, rest_energy, dissipation = _lines(page, scaled)
    kinetic, linear, still = _by_rates(page, scaled(energy))
    page_energy = Add(*(scaled(energy) for energy, _ in page.energies))
    potential = rest_energy + page_energy - still
    contacts = _contacts(page, scaled)
    return Mechanics(
        page=page,
        coordinates=page.places,
        rates=page.rates,
        parameters=tuple(page.parameters),
        lines=lines,
        torsions=torsions,
        kinetic=kinetic,
        linear=linear,
        still=still,
        potential=expanded(potential),
        stiffnesses=stiffnesses,
        applied=_applied(page, scaled),
        dissipation=expanded(dissipation),
        contacts=tuple(contacts.values()),
        frictions=_frictions(page, scaled, contacts),
        clock=page.timer and page.timer.symbol,
        speed=S.Zero if page.timer is None else scaled(page.timer.speed),
        scaled=scaled,
        # The last one: only now is it known which angles occur by themselves.
        angles=tuple(
            Angle(angle, *parts, angle in scaled.alone) for angle, parts in scaled.angles.items()
        ),
    )


class _Scaled:
    """Makes expressions dimensionless: units of measure become 1, parameters become numbers, and
    angles become cosines and sines; with ``units`` only the last.
    """

    def __init__(self, page: Page, units: bool) -> None:
        numbers = {datum.symbol: number(datum) for datum in page.parameters} | dict.fromkeys(
            (u.symbol for u in page.units), S.One
        )
        self.numbers: Mapping[Expr, Expr] = {} if units else numbers
        self.turned: dict[Expr, Expr] = {}
        self.angles: dict[Symbol, tuple[Symbol, Symbol]] = {}
        #: angles that occurred by themselves, not as cosine or sine
        self.alone: set[sp.Basic] = set()
        for datum in page.parameters:
            if datum.unit == "rad":
                cosine, sine = (Symbol(name, real=True) for name in datum.cosine_and_sine)
                self.turned |= {sp.cos(datum.symbol): cosine, sp.sin(datum.symbol): sine}
                self.angles[number(datum)] = cosine, sine
        for friction in page.frictions:
            for way in (1, -1):  # of laws, which are asked for later
                self(expression_of(friction.law(way * DEPTH)))

    def __call__(self, expression: Expr) -> Expr:
        value = sp.expand_trig(expression) if expression.has(sp.cos, sp.sin) else expression
        value = value.subs(self.turned).subs(self.numbers, simultaneous=True)
        self.alone |= value.free_symbols & self.angles.keys()
        return value


def _by_rates(page: Page, energy: Expr) -> Row:
    """The kinetic energy split into terms that are quadratic in the rates, linear, and without
    rates.
    """
    at_rest = dict.fromkeys(page.rates, S.Zero)
    still = energy.subs(at_rest)
    linear = Add(*(diff(energy, rate).subs(at_rest) * rate for rate in page.rates))
    if still == 0 == linear:
        return energy, linear, still
    linear, still = expanded(linear), expanded(still)
    return expanded(energy - linear - still), linear, still


def elastic(line: Line, stiffness: Expr) -> Expr:
    """The energy k (l − r)²/2 up to a constant, as k (dx² + dy²)/2 − k r l: its forces are linear
    in coordinates and directions.
    """
    return stiffness * ((line.dx**2 + line.dy**2) / 2 - line.rest * line.l)


def _lines(
    page: Page, scaled: _Scaled
) -> tuple[tuple[Line, ...], Row, tuple[Turning, ...], Expr, Expr]:
    """The lines of springs and dampers, the stiffness along each, the torsion springs, the energy
    of all springs, and the dissipation function.
    """
    lines: list[Line] = []
    stiffness_of: dict[Line, Expr] = {}
    energy = dissipation = S.Zero

    def line_of(ends: tuple[Point, Point], rest: Expr | None, line: int) -> Line:
        """The line between two points, an earlier one if it has the same undeformed length; of a
        damper (None) any earlier one.
        """
        ((ax, ay), (bx, by)) = ends
        vector = scaled(bx - ax), scaled(by - ay)
        for earlier in lines:
            if (earlier.dx, earlier.dy) == vector and rest in (None, earlier.rest):
                return earlier
        count = len(lines) + 1
        c, s = sp.symbols(f"c{count} s{count}", real=True)
        length = Symbol(f"l{count}", positive=True)
        lines.append(Line(*vector, S.Zero if rest is None else rest, c, s, length, line))
        return lines[-1]

    for spring in page.springs:
        stiffness = scaled(spring.strength)
        if spring.ends is None:
            energy += stiffness * (scaled(spring.along) - scaled(spring.rest)) ** 2 / 2
        else:
            line = line_of(spring.ends, scaled(spring.rest), spring.line)
            energy += elastic(line, stiffness)
            stiffness_of[line] = stiffness_of.get(line, S.Zero) + stiffness
    torsions = tuple(
        _turning(torsion, line_of(torsion.ends, None, torsion.line), count, scaled)
        for count, torsion in enumerate(page.torsions, 1)
        if torsion.ends is not None
    )
    energy += Add(*(torsion.energy for torsion in torsions))
    for damper in page.dampers:
        coefficient = scaled(damper.strength)
        if damper.ends is None:
            speed = page.rate(scaled(damper.along))
        else:
            line = line_of(damper.ends, None, damper.line)
            speed = line.c * page.rate(line.dx) + line.s * page.rate(line.dy)
        dissipation += coefficient * speed**2 / 2
    return (
        tuple(lines),
        tuple(stiffness_of.get(line, S.Zero) for line in lines),
        torsions,
        energy,
        dissipation,
    )


def _turning(torsion: Element, line: Line, count: int, scaled: _Scaled) -> Turning:
    cosine, sine = (scaled(function(torsion.rest)) for function in (sp.cos, sp.sin))
    roots = any(not power.exp.is_Integer for power in (cosine + sp.I * sine).atoms(sp.Pow))
    if roots or cosine.has(sp.cos, sp.sin) or sine.has(sp.cos, sp.sin):
        raise PageError(
            torsion.line,
            f"the inclination at rest is {torsion.rest}; expected is an angle of the page, a "
            "sum of such, or a multiple of pi/2: make "
            "another number a parameter in rad, with a base value",
        )
    phi, way = sp.symbols(f"phi{count} way{count}", real=True)
    return Turning(
        line, scaled(torsion.strength), torsion.rest.subs(scaled.numbers), cosine, sine, phi, way
    )


def _applied(page: Page, scaled: _Scaled) -> Row:
    """Generalized applied forces, by virtual work."""
    forces = [S.Zero] * len(page.places)
    for force in page.forces:
        for component, where in zip(force.components, force.place, strict=True):
            for row, symbol in enumerate(page.places):
                forces[row] += scaled(component) * diff(scaled(where), symbol)
    return tuple(
        S.Zero if page.timer and symbol == page.timer.symbol else expanded(force)
        for symbol, force in zip(page.places, forces, strict=True)
    )


def _contacts(page: Page, scaled: _Scaled) -> dict[Contact | None, NormalForce]:
    """The normal force of every contact; without contacts a zero force for the key None."""
    taken = {datum.becomes for datum in page.parameters} | set(map(str, page.places))
    mark = "_" if taken & set(map(str, (PUSHING, MU, SIDE, HELD))) else ""
    if not page.contacts:
        return {None: NormalForce("", None, False, False, S.Zero, False, 0, mark)}
    found: dict[Contact | None, NormalForce] = {}
    for contact in page.contacts:
        name = contact.name if len(page.contacts) > 1 else ""
        depth = of_contact(DEPTH, name)
        gap = None if contact.gap is None else scaled(contact.gap)
        law = scaled(expression_of(contact.law(depth)))
        in_coordinates = _in_coordinates(page, gap, law, depth)
        opens = contact.unilateral and gap is not None
        rubs = any(friction.on in (None, contact) for friction in page.frictions)
        either = rubs and not contact.unilateral
        found[contact] = NormalForce(
            name, gap, opens, either, law, in_coordinates, contact.line, mark
        )
    return found


def _in_coordinates(page: Page, gap: Expr | None, law: Expr, depth: Symbol) -> bool:
    """Whether a contact law is expanded in coordinates; else it stays in the penetration.

    Laws that are no polynomials stay, laws of a gap that is nonlinear in the coordinates, and
    powers of a gap of several coordinates: expanded, their large terms would cancel, and intervals
    of them would be wide.
    """
    if gap is None or not law.is_polynomial(depth):
        return False
    slopes = [slope for one in page.places if (slope := diff(gap, one)) != 0]
    is_curved = any(slope.has(*page.places) for slope in slopes)
    return not is_curved and (len(slopes) == 1 or sp.degree(law, depth) <= 1)


def _frictions(
    page: Page, scaled: _Scaled, contacts: Mapping[Contact | None, NormalForce]
) -> tuple[FrictionForce, ...]:
    """The friction of the page; without friction one whose displacement is 0."""
    first, zero = next(iter(contacts.values())), S.Zero
    if not page.frictions:
        return (FrictionForce(first, zero, zero, zero, zero, zero, zero, None, None, 0),)
    found = []
    for it in page.frictions:
        ahead, behind = (scaled(expression_of(it.law(sign * SLIP))) for sign in (1, -1))
        holds = None if it.holds is None else scaled(it.holds)
        at_rest = None if it.at_rest is None else scaled(it.at_rest)
        along = scaled(it.along)
        belt = still = scaled(it.belt)
        if page.timer is not None:
            belt = belt.subs(speed_of(page.timer.symbol), scaled(page.timer.speed))
            still = belt.subs(page.timer.symbol, 0)
        normal = first if it.on is None else contacts[it.on]
        rate = page.rate(along)
        found.append(
            FrictionForce(normal, along, rate, belt, still, ahead, behind, holds, at_rest, it.line)
        )
    return tuple(found)
