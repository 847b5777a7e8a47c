"""From a page to dimensionless mechanics: the units of measure become 1, and every straight spring
gets a direction and a length.

A spring between two points has the vector (dx, dy) from its first end, the mass's, to its second,
its length l, and its direction (c, s) = (dx, dy)/l. Forces are written in c, s and l as symbols of
their own, and derivatives follow by the chain rule

    ∂l = c ∂dx + s ∂dy,    ∂c = s (s ∂dx − c ∂dy)/l,    ∂s = −c (s ∂dx − c ∂dy)/l,

so that no square root is ever differentiated. Likewise the turning of a torsion spring is a symbol
φ of its own, with

    ∂φ = (c ∂dy − s ∂dx)/l − ∂rest,

so that its energy k φ²/2 is exact and its forces are linear in φ: an arc tangent is taken once, in
numbers.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from sympy import Add, Dummy, Expr, Matrix, S, Symbol, diff

from .algebra import Circles, Names, Pair, Row, Symbols, expanded, fewest_terms, quotients
from .model import Contact, Datum, Element, Page, PageError, Point, expression_of, speed_of

#: 1 on the contact's side of its law, 0 on the other: n̄ of the article.
PUSHING = Symbol("pushing", real=True)
#: Sign of the sliding speed: 1 where the belt is ahead, −1 where the mass is.
SIDE = Symbol("side", real=True)
#: The friction coefficient, where a function takes it as a number.
MU = Symbol("mu", real=True)
#: Penetration, positive, of a law that is no polynomial.
DEPTH = Symbol("_depth", positive=True)
#: A sliding speed, positive.
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
        """Length of a line, by its vector."""
        return sp.sqrt(self.dx**2 + self.dy**2)

    def slopes(self, dx: Expr, dy: Expr) -> Names:
        """Changes of direction and length when the vector changes by (dx, dy)."""
        turn = self.s * dx - self.c * dy
        return {
            self.l: self.c * dx + self.s * dy,
            self.c: self.s * turn / self.l,
            self.s: -self.c * turn / self.l,
        }


@dataclass(frozen=True)
class Turning:
    """Rotation of a line from its inclination at rest, against a torsion spring: φ in (−π, π], the
    least turning.
    """

    line: Line
    stiffness: Expr
    rest: Expr  #: the inclination at rest, in angles
    cosine_of_rest: Expr
    sine_of_rest: Expr
    phi: Symbol
    way: Symbol  #: where φ is continued beyond π (1) or beyond −π (−1)

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
        """φ by its cosine and sine."""
        return sp.atan2(self.sine, self.cosine)

    @property
    def continued(self) -> Expr:
        """φ on its way: from −π/2 to 3π/2, or from −3π/2 to π/2, smooth across the ray on which the
        least turning jumps.
        """
        return self.way * (sp.pi / 2 - sp.atan2(self.cosine, self.way * self.sine))

    @property
    def border(self) -> Expr:
        """Positive from −0.93 to π, times the way: where a motion changes it. The two ways share
        the border ±π.
        """
        return 1 + self.cosine + 2 * self.way * self.sine


@dataclass(frozen=True)
class Angle:
    """An angle enters by its cosine and sine; ``alone`` it stands by itself as well, as in k (φ −
    θ₀)²/2.
    """

    symbol: Symbol
    c: Symbol
    s: Symbol
    alone: bool

    @property
    def parts(self) -> Symbols:
        """Symbols of an angle among the arguments of functions."""
        return (self.symbol, self.c, self.s) if self.alone else (self.c, self.s)


def of_contact(symbol: Symbol, name: str, mark: str = "") -> Symbol:
    """The symbol of the contact of that name, or of the only one, which has none, behind a mark."""
    return Symbol(f"{mark}{symbol}{name and '_'}{name}", **symbol.assumptions0)


@dataclass(frozen=True)
class NormalForce:
    """The normal force of a contact: its law in :attr:`depth` behind a gap, or a given force.

    Two regimes meet at its border. One that opens has its force where the gap is not positive and
    none beyond. One that presses on either of two faces, as in a slot, has the same force N in
    both, and rubs with the size of N: PUSHING tells the sign of N.
    """

    name: str  #: empty of the only contact
    gap: Expr | None
    unilateral: bool  #: whether it opens
    either_face: bool  #: whether it rubs on either of two faces
    law: Expr  #: in the penetration
    #: Whether the law stands in coordinates, else in the penetration: see :func:`_in_coordinates`.
    in_coordinates: bool
    line: int
    #: Before PUSHING, MU and SIDE: an underscore where the page has one of these names.
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
        """The force on the contact's side, in coordinates or in the penetration."""
        if self.gap is not None and self.in_coordinates:
            return expanded(self.law.subs(self.depth, -self.gap))
        return self.law

    @cached_property
    def force(self) -> Expr:
        """The force, with PUSHING."""
        return self.pushing * self.push if self.unilateral else self.push

    @property
    def rubbing(self) -> Expr:
        """The force with which it rubs, with PUSHING."""
        return (2 * self.pushing - 1) * self.push if self.either_face else self.force

    @cached_property
    def border(self) -> Expr | None:
        """Not positive where PUSHING is 1, not negative where it is 0; None of one regime."""
        if self.either_face:
            return -self.push if self.gap is None else -self.push.subs(self.depth, -self.gap)
        return self.gap if self.unilateral else None

    @cached_property
    def energy(self) -> Expr:
        """The integral of the law over the penetration, from 0, in the penetration."""
        energy = sp.integrate(self.law, self.depth)
        return energy - energy.subs(self.depth, 0)

    @cached_property
    def penetration(self) -> Expr:
        """Expression for DEPTH: the penetration, and in lift-off, where the law is multiplied by 0,
        a tiny one at which it is finite.

        The square keeps 1 − PUSHING, a whole number, together: added apart, 1 would take the last
        digits of a shallow penetration.
        """
        if self.gap is None:
            return S.Zero
        if not self.unilateral:
            return -self.gap
        # Penetration in lift-off: small, so that no exponential of it is infinite, and
        # not 0, where slopes of a root are.
        touch = sp.Rational(1, 2**40)
        return self.pushing * (-self.gap) + (1 - self.pushing) ** 2 * touch


@dataclass(frozen=True)
class FrictionForce:
    """Friction on a contact: μ times its normal force along a displacement."""

    normal: NormalForce
    along: Expr | None  #: the displacement that it opposes; None where there is no friction
    rate: Expr  #: d(along)/dt
    belt: Expr
    still: Expr  #: the belt's speed at the phase 0 of a clock that it follows
    #: The law for the belt ahead and for the mass ahead, in the positive sliding speed.
    ahead: Expr
    behind: Expr
    holds: Expr | None
    at_rest: Expr | None
    line: int

    @property
    def name(self) -> str:
        """That of its contact."""
        return self.normal.name

    @property
    def mu(self) -> Symbol:
        """MU of this friction."""
        return of_contact(MU, self.name and f"on_{self.name}", self.normal.mark)

    @property
    def side(self) -> Symbol:
        """SIDE of this friction."""
        return of_contact(SIDE, self.name and f"on_{self.name}", self.normal.mark)

    @property
    def stuck(self) -> Symbol:
        """1 while it holds the mass to the belt, 0 while it slips."""
        return of_contact(Symbol("_stuck", real=True), self.name)

    @property
    def unknown(self) -> Symbol:
        """Its force while it holds."""
        return of_contact(Symbol("_friction", real=True), self.name)


def named(function: str, of: NormalForce | FrictionForce) -> str:
    """The generated function of one contact: that of the only one has no name behind it."""
    return f"{function}_{of.name}" if of.name else function


def on(of: NormalForce | FrictionForce) -> str:
    """Name of the contact in a sentence, where there are several."""
    return f" of {of.name}" if of.name else ""


@dataclass(frozen=True)
class Mechanics:
    """Parts of the equations of a dimensionless model."""

    page: Page
    coordinates: Symbols
    rates: Symbols
    parameters: tuple[Datum, ...]
    angles: tuple[Angle, ...]
    lines: tuple[Line, ...]
    torsions: tuple[Turning, ...]
    kinetic: Expr  #: the part of it that is quadratic in the rates
    linear: Expr  #: the part that is linear in them, as in a frame that turns
    still: Expr  #: the part without them, which stands in the potential with the other sign
    #: In coordinates, lengths and turnings, without the contact and the applied forces.
    potential: Expr
    stiffnesses: Row  #: of the spring along every line, 0 where there is none
    applied: Row  #: generalized applied forces
    #: Half of the power that the dampers take, in rates, directions and lengths.
    dissipation: Expr
    contacts: tuple[NormalForce, ...]  #: of a page without one a force that is 0
    frictions: tuple[FrictionForce, ...]  #: of a page without one a friction along nothing
    clock: Symbol | None  #: the coordinate that grows at a given rate
    speed: Expr  #: that rate; 0 without
    scaled: Callable[[Expr], Expr]  #: makes an expression of the page dimensionless

    @property
    def holds(self) -> bool:
        """Whether friction holds the mass where nothing slides."""
        return any(friction.holds is not None for friction in self.frictions)

    # ---------------------------------------------------------------------------------------------
    # names

    @cached_property
    def arguments(self) -> Symbols:
        """Symbols of all parameters, angles as their parts."""
        return tuple(symbol for datum in self.parameters for symbol in self.parts(number(datum)))

    def parts(self, symbol: Symbol) -> Symbols:
        """A parameter as arguments of functions: an angle as its cosine and sine."""
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
        """∂/∂symbol with directions and lengths held; an angle by its cosine and sine."""
        for angle in self.angles:
            if angle.symbol == symbol:
                turned = angle.c * diff(expression, angle.s) - angle.s * diff(expression, angle.c)
                return turned + diff(expression, symbol)
        return diff(expression, symbol)

    def derivative(self, expression: Expr, symbol: Symbol) -> Expr:
        """d/dsymbol, by a coordinate or a parameter, with directions, lengths, turnings and the
        penetration following.
        """
        total = self.partial(expression, symbol)
        for line in self.lines:
            slopes = line.slopes(self.partial(line.dx, symbol), self.partial(line.dy, symbol))
            for inner, slope in slopes.items():
                total += diff(expression, inner) * slope
        for torsion in self.torsions:
            line = torsion.line
            turn = (
                line.c * self.partial(line.dy, symbol) - line.s * self.partial(line.dx, symbol)
            ) / line.l
            total += diff(expression, torsion.phi) * (turn - diff(torsion.rest, symbol))
        for contact in self.contacts:
            if contact.gap is not None and expression.has(contact.depth):
                total -= diff(expression, contact.depth) * self.partial(contact.gap, symbol)
        return total

    def tidy(self, expression: Expr) -> Expr:
        """In the fewest terms: by c² + s² = 1, either square of every direction may go; common
        factors stand outside.

        Each parameter stands once where it can: an interval of it counts once, too.
        """
        # Kept whole: expanded, they may overflow, or become sums of logarithms.
        nodes = sorted(
            expression.atoms(sp.exp, sp.log, sp.tanh, sp.atan) | self._quotients(expression),
            key=sp.default_sort_key,
        )
        kept = {1 / line.l: Dummy() for line in self.lines} | {node: Dummy() for node in nodes}
        shortest = expanded(
            expanded(expression.xreplace({node: kept[node] for node in nodes})).subs(kept)
        ).subs({friction.side**2: 1 for friction in self.frictions})
        turned, circles = self.circles(shortest)
        shortest = shortest.xreplace(turned)
        kept |= turned
        for cosine, sine in circles:
            if shortest.has(cosine, sine):
                shortest = fewest_terms(shortest, cosine, sine)
        whole = sp.factor_terms(
            shortest.subs({dummy: quotient for quotient, dummy in kept.items()})
        )
        return sp.collect(whole, tuple(map(number, self.parameters)))

    def circles(self, expression: sp.Basic) -> tuple[Names, Circles]:
        """Symbols for the cosines and sines in an expression, and the pairs of them that lie on
        unit circles, the directions of the lines first.
        """
        pairs = waves(expression)
        turned = {node: Dummy(real=True) for pair in pairs for node in pair}
        lines = ((line.c, line.s) for line in self.lines)
        return turned, (*lines, *((turned[c], turned[s]) for c, s in pairs))

    def _quotients(self, expression: Expr) -> set[Expr]:
        """Quotients and roots of what has a direction or an angle: no polynomials in its cosine and
        sine, as 1/(1 + cos² v²) is none.
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
        """Expressions for DEPTH of every contact."""
        return {contact.depth: contact.penetration for contact in self.contacts}

    @cached_property
    def residuals(self) -> Row:
        """Minus the generalized forces at rest, in MU and PUSHING."""
        return self._residuals(self.potential)

    @cached_property
    def residuals_apart(self) -> Row:
        """The same without the springs along lines, each of which adds its tension times (c ∂dx + s
        ∂dy), and without torsion springs.
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
                # Nothing acts on the clock: s″ = Ω (Ω − s′), which is 0 where it keeps its rate.
                rows.append(-(self.speed**2))
                continue
            row = self.derivative(potential, symbol) - force
            for contact in self.contacts:
                if contact.gap is not None:
                    row -= contact.force * diff(contact.gap, symbol)
            for friction in self.frictions:
                if friction.along is not None:
                    row -= friction.mu * friction.normal.rubbing * diff(friction.along, symbol)
            rows.append(sp.collect(expanded(row), (*self.coordinates, *self.directions)))
        return tuple(rows)

    @cached_property
    def resistance(self) -> Row:
        """Forces of the dampers, on the side of the residuals."""
        return tuple(
            self.speed * rate if symbol == self.clock else expanded(diff(self.dissipation, rate))
            for symbol, rate in zip(self.coordinates, self.rates, strict=True)
        )

    @property
    def moved(self) -> tuple[tuple[Symbol, Symbol, Expr], ...]:
        """Each coordinate but the clock, its rate and the applied force."""
        each = zip(self.coordinates, self.rates, self.applied, strict=True)
        return tuple(one for one in each if one[0] != self.clock)

    @cached_property
    def mass(self) -> Matrix:
        """M of the kinetic energy q′ᵀ M q′/2."""
        M = sp.hessian(self.kinetic, self.rates)
        if self.clock is not None:
            M[-1, -1] = S.One
        return M

    @cached_property
    def gyroscopic(self) -> Matrix:
        """G of the forces G q′ of a kinetic energy linear in the rates, a · q′: G_ij = ∂a_i/∂q_j −
        ∂a_j/∂q_i, which is antisymmetric and takes no power.
        """
        slopes = Matrix([self.linear]).jacobian(self.rates).jacobian(self.coordinates)
        return (slopes - slopes.T).applyfunc(expanded)


def waves(expression: sp.Basic) -> list[Pair]:
    """Cosine and sine of everything of which the expression takes one of them, in an order of their
    own.
    """
    arguments = {node.args[0] for node in expression.atoms(sp.cos, sp.sin)}
    return [
        (sp.cos(argument), sp.sin(argument))
        for argument in sorted(arguments, key=sp.default_sort_key)
    ]


def number(datum: Datum) -> Symbol:
    """The dimensionless quantity that a parameter becomes."""
    assumptions = {
        name: True
        for name in ("positive", "nonnegative", "real")
        if datum.symbol.assumptions0.get(name)
    }
    return Symbol(datum.becomes, **assumptions)


def of(page: Page, units: bool = False) -> Mechanics:
    """The mechanics of a page; a :class:`~derive.model.PageError` where the page can't be carried
    through.

    With ``units`` its quantities stay what they are, and nothing becomes 1.
    """
    if page.inertia is None:
        raise PageError(0, "there is no kinetic energy; add page.kinetic(m * page.rate(x)**2 / 2)")
    scaled = _Scaled(page, units)
    lines, stiffnesses, torsions, rest_energy, dissipation = _lines(page, scaled)
    kinetic, linear, still = _by_rates(page, scaled(page.inertia[0]))
    stored = Add(*(scaled(energy) for energy, _ in page.energies))
    potential = rest_energy + stored - still
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
        # The last, since it is known only now which angles stand by themselves.
        angles=tuple(
            Angle(angle, *parts, angle in scaled.alone) for angle, parts in scaled.angles.items()
        ),
    )


class _Scaled:
    """Makes an expression dimensionless: units of measure become 1, parameters numbers, angles
    cosines and sines (``units``: only these).
    """

    def __init__(self, page: Page, units: bool) -> None:
        numbers = {datum.symbol: number(datum) for datum in page.parameters} | dict.fromkeys(
            (u.symbol for u in page.units), S.One
        )
        self.numbers: Mapping[Expr, Expr] = {} if units else numbers
        self.turned: dict[Expr, Expr] = {}
        self.angles: dict[Symbol, tuple[Symbol, Symbol]] = {}
        #: Angles that were found by themselves.
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
    """The kinetic energy without its parts linear in the rates and without rates, and these."""
    at_rest = dict.fromkeys(page.rates, S.Zero)
    still = energy.subs(at_rest)
    linear = Add(*(diff(energy, rate).subs(at_rest) * rate for rate in page.rates))
    if still == 0 == linear:
        return energy, linear, still
    linear, still = expanded(linear), expanded(still)
    return expanded(energy - linear - still), linear, still


def elastic(line: Line, stiffness: Expr) -> Expr:
    """The energy k (l − r)²/2 as k (dx² + dy²)/2 − k r l, up to a constant: its forces are linear
    in coordinates and direction.
    """
    return stiffness * ((line.dx**2 + line.dy**2) / 2 - line.rest * line.l)


def _lines(
    page: Page, scaled: _Scaled
) -> tuple[tuple[Line, ...], Row, tuple[Turning, ...], Expr, Expr]:
    """Lines of springs and dampers, each once; stiffness along each; turnings; energy of springs;
    half the power of the dampers.
    """
    found: list[Line] = []
    along: dict[Line, Expr] = {}
    energy = dissipation = S.Zero

    def line_of(ends: tuple[Point, Point], rest: Expr | None, line: int) -> Line:
        """The line between two points; that of a spring with this undeformed length, for a damper
        that of any.
        """
        ((ax, ay), (bx, by)) = ends
        vector = scaled(bx - ax), scaled(by - ay)
        for earlier in found:
            if (earlier.dx, earlier.dy) == vector and rest in (None, earlier.rest):
                return earlier
        count = len(found) + 1
        c, s = sp.symbols(f"c{count} s{count}", real=True)
        length = Symbol(f"l{count}", positive=True)
        found.append(Line(*vector, S.Zero if rest is None else rest, c, s, length, line))
        return found[-1]

    for spring in page.springs:
        stiffness = scaled(spring.strength)
        if spring.ends is None:
            energy += stiffness * (scaled(spring.along) - scaled(spring.rest)) ** 2 / 2
        else:
            line = line_of(spring.ends, scaled(spring.rest), spring.line)
            energy += elastic(line, stiffness)
            along[line] = along.get(line, S.Zero) + stiffness
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
        tuple(found),
        tuple(along.get(line, S.Zero) for line in found),
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
    """Generalized forces by virtual work."""
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
    """The normal force of every contact of the page; of a page without one, of None, 0."""
    if not page.contacts:
        return {None: NormalForce("", None, False, False, S.Zero, False, 0)}
    found: dict[Contact | None, NormalForce] = {}
    own = {datum.becomes for datum in page.parameters} | set(map(str, page.places))
    mark = "_" if own & {str(PUSHING), str(MU), str(SIDE)} else ""
    for contact in page.contacts:
        name = contact.name if len(page.contacts) > 1 else ""
        depth = of_contact(DEPTH, name)
        gap = None if contact.gap is None else scaled(contact.gap)
        law = scaled(expression_of(contact.law(depth)))
        expressed = _in_coordinates(page, gap, law, depth)
        opens = contact.unilateral and gap is not None
        rubs = any(friction.on in (None, contact) for friction in page.frictions)
        either = rubs and not contact.unilateral
        found[contact] = NormalForce(name, gap, opens, either, law, expressed, contact.line, mark)
    return found


def _in_coordinates(page: Page, gap: Expr | None, law: Expr, depth: Symbol) -> bool:
    """Whether a contact law stands in coordinates, else in the penetration.

    In the penetration stand laws that are no polynomials, of a gap that bends, and powers of one
    that takes several coordinates: in coordinates those would be large terms that cancel, and whose
    intervals tell nothing.
    """
    if gap is None or not law.is_polynomial(depth):
        return False
    slopes = [slope for one in page.places if (slope := diff(gap, one)) != 0]
    bends = any(slope.has(*page.places) for slope in slopes)
    return not bends and (len(slopes) == 1 or sp.degree(law, depth) <= 1)


def _frictions(
    page: Page, scaled: _Scaled, contacts: Mapping[Contact | None, NormalForce]
) -> tuple[FrictionForce, ...]:
    """All friction of the page; of a page without one that along nothing."""
    first, zero = next(iter(contacts.values())), S.Zero
    if not page.frictions:
        return (FrictionForce(first, None, zero, zero, zero, zero, zero, None, None, 0),)
    found = []
    for it in page.frictions:
        ahead, behind = (scaled(expression_of(it.law(sign * SLIP))) for sign in (1, -1))
        holds, at_rest = (None if part is None else scaled(part) for part in (it.holds, it.at_rest))
        along, belt = scaled(it.along), scaled(it.belt)
        still = belt
        if page.timer is not None:
            belt = belt.subs(speed_of(page.timer.symbol), scaled(page.timer.speed))
            still = belt.subs(page.timer.symbol, 0)
        normal = first if it.on is None else contacts[it.on]
        rate = page.rate(along)
        found.append(
            FrictionForce(normal, along, rate, belt, still, ahead, behind, holds, at_rest, it.line)
        )
    return tuple(found)
