"""The vocabulary of a page: the statements with which an author describes a model.

A page is a Python file that makes one :class:`Page`. It states quantities, coordinates, energies,
springs and dampers by their ends, applied forces, contact laws and friction laws. Every statement
keeps its line number for errors. Laws and energies are made of :data:`FUNCTIONS`, roots and
fractional powers, each smooth where it is used. What follows from a page is derived elsewhere.
"""

from __future__ import annotations

import inspect
import math
import unicodedata
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, cast

import sympy as sp
from sympy import Expr, Symbol
from sympy import Abs, atan, cos, cosh, exp, log, pi, sign, sin, sinh, sqrt, tanh

from .algebra import Pair, Row, Symbols
from .emit import names
from .emit.quantities import interval
from .from_mechanics import page_from
from .limits import Limit
from .page_errors import PageError, line_of_page, refused

__all__ = [
    "Abs",
    "Page",
    "PageError",
    "atan",
    "cos",
    "cosh",
    "exp",
    "log",
    "page_from",
    "pi",
    "sgn",
    "sin",
    "sinh",
    "sqrt",
    "tanh",
]

#: The sign function under the name that articles give it.
sgn = sign

#: The functions of which laws and energies are made, besides powers, by their names on pages.
FUNCTIONS = {
    "Abs": Abs,
    "atan": atan,
    "cos": cos,
    "cosh": cosh,
    "exp": exp,
    "log": log,
    "sgn": sgn,
    "sin": sin,
    "sinh": sinh,
    "tanh": tanh,
}
#: The functions in generated code; sinh and cosh are written in exponentials.
WRITTEN = tuple(function for name, function in FUNCTIONS.items() if name not in ("cosh", "sinh"))

#: A point of the plane: two lengths.
Point = Pair
#: A law: a force as a function of penetration, or a friction coefficient of sliding speed.
Law = Callable[[Expr], Expr]


@dataclass(frozen=True)
class Datum:
    """A quantity of the page: a unit of measure, which becomes 1 when the model is scaled, or a
    parameter, which becomes a number named ``becomes``.
    """

    symbol: Symbol
    unit: str
    meaning: str
    domain: str
    latex: str
    line: int
    becomes: str = ""  #: empty for a unit of measure
    base: float | None = None
    role: str = ""

    @property
    def cosine_and_sine(self) -> tuple[str, str]:
        """The names of an angle's cosine and sine in code: ``cos0``, ``sin0`` for ``theta0`` and
        ``cos_psi``, ``sin_psi`` for ``psi``.
        """
        is_theta = self.becomes.startswith("theta")
        suffix = self.becomes.removeprefix("theta") if is_theta else f"_{self.becomes}"
        return f"cos{suffix}", f"sin{suffix}"


@dataclass(frozen=True)
class Coordinate:
    """A coordinate of the motion and its rate."""

    symbol: Symbol
    rate: Symbol
    unit: str
    meaning: str
    latex: str
    line: int


def acceleration_of(coordinate: Symbol) -> str:
    """The name of an acceleration in code, ``ax`` for ``x``; ``as``, a Python word, is ``as_``."""
    return "as_" if str(coordinate) == "s" else f"a{coordinate}"


@dataclass(frozen=True)
class Clock:
    """A coordinate that grows at a given rate, the phase of a periodic excitation."""

    symbol: Symbol
    speed: Expr
    line: int


@dataclass(frozen=True)
class Element:
    """A spring, a torsion spring or a viscous damper, between two points or along a coordinate."""

    what: str  #: "spring", "torsion spring" or "damper"
    strength: Expr  #: stiffness or coefficient
    ends: tuple[Point, Point] | None
    along: Expr | None  #: the coordinate, if it is not between two points
    rest: Expr  #: undeformed length of a spring, inclination at rest of a torsion spring
    line: int

    @property
    def quality(self) -> str:
        """What the strength is called."""
        return "coefficient" if self.what == "damper" else "stiffness"


@dataclass(frozen=True)
class Force:
    """An applied force: two components at a point, or one component along a coordinate."""

    components: Row
    place: Row
    line: int


@dataclass(frozen=True)
class Contact:
    """A normal force: a law of the penetration −gap, or a given force if ``gap`` is None.

    A ``unilateral`` contact has no force at a positive gap, and never pulls; any other contact
    never opens. On a page with several contacts each has a ``name``.
    """

    gap: Expr | None
    law: Law
    unilateral: bool
    line: int
    name: str = ""


@dataclass(frozen=True)
class Friction:
    """A friction coefficient as a law of the sliding speed ``belt − d(along)/dt``.

    ``at_rest`` is the coefficient that statics takes, if it is not the law at the belt's speed.
    Dry friction has ``holds``, the static coefficient: the mass sticks by any force up to that
    times the normal force. ``on`` is the contact, None for the only one.
    """

    along: Expr
    belt: Expr
    law: Law
    at_rest: Expr | None
    line: int
    holds: Expr | None = None
    on: Contact | None = None


def expression_of(value: object) -> Expr:
    """A number or an expression as an exact SymPy expression: 0.1 becomes 1/10.

    Raises
    ------
    PageError
        For None, a text or a function.
    """
    if value is None or isinstance(value, str):
        said = "nothing" if value is None else f"{value!r}, a text"
        raise refused(
            f"here is {said}; give a quantity of the page, without quotation marks, or a number"
        )
    try:
        expression = sp.sympify(value)
    except sp.SympifyError as error:
        said = "a function" if callable(value) else repr(value)
        raise refused(
            f"here is {said}; give an expression of parameters and coordinates, or a number"
        ) from error
    if not isinstance(expression, Expr):
        raise refused(f"here is {value!r:.60}; give an expression, or a number")
    if expression.has(sinh, cosh):
        for function in (sinh, cosh):
            expression = expression.replace(
                function, lambda u, whole=function: whole(u).rewrite(exp)
            )
    return sp.nsimplify(expression, rational=True) if expression.atoms(sp.Float) else expression


def speed_of(symbol: Symbol) -> Symbol:
    """The rate of a coordinate: ``vx`` for ``x``."""
    return Symbol(f"v{symbol.name}", real=True)


@dataclass
class Page:
    """A model, described statement by statement.

    Parameters
    ----------
    summary : str
        One sentence that says what the model is.
    """

    summary: str
    units: list[Datum] = field(default_factory=list)
    parameters: list[Datum] = field(default_factory=list)
    coordinates: list[Coordinate] = field(default_factory=list)
    springs: list[Element] = field(default_factory=list)
    torsions: list[Element] = field(default_factory=list)
    dampers: list[Element] = field(default_factory=list)
    forces: list[Force] = field(default_factory=list)
    energies: list[tuple[Expr, int]] = field(default_factory=list)
    inertia: tuple[Expr, int] | None = None
    contacts: list[Contact] = field(default_factory=list)
    frictions: list[Friction] = field(default_factory=list)
    timer: Clock | None = None

    def __post_init__(self) -> None:
        _check_texts(summary=self.summary)

    @property
    def places(self) -> Symbols:
        """Symbols of the coordinates."""
        return tuple(entry.symbol for entry in self.coordinates)

    @property
    def rates(self) -> Symbols:
        """Symbols of the rates of the coordinates."""
        return tuple(entry.rate for entry in self.coordinates)

    @property
    def elements(self) -> tuple[Element, ...]:
        """Springs, torsion springs and dampers."""
        return (*self.springs, *self.torsions, *self.dampers)

    @property
    def kinetic_energy(self) -> tuple[Expr, int]:
        """The kinetic energy and the line that states it.

        Raises
        ------
        PageError
            If none does.
        """
        if self.inertia is None:
            message = "there is no kinetic energy; add page.kinetic(m * page.rate(x)**2 / 2)"
            raise PageError(0, message)
        return self.inertia

    @property
    def normal(self) -> Contact | None:
        """The contact of a page with at most one contact."""
        (contact,) = self.contacts or (None,)
        return contact

    @property
    def sliding(self) -> Friction | None:
        """The friction of a page with at most one friction."""
        (friction,) = self.frictions or (None,)
        return friction

    # ---------------------------------------------------------------------------------------------
    # quantities

    def unit(self, name: str, unit: str, meaning: str, latex: str = "") -> Symbol:
        """State a unit of measure: a positive quantity that is 1 in the dimensionless model."""
        _check_texts(name=name, unit=unit, meaning=meaning, latex=latex)
        symbol = Symbol(name, positive=True)
        return self._entered(
            self.units,
            Datum(symbol, unit, meaning, "> 0", latex or names.latex(name), line_of_page()),
        )

    def parameter(
        self,
        name: str,
        unit: str,
        meaning: str,
        domain: str = "real",
        base: float | None = None,
        becomes: str = "",
        latex: str = "",
        role: str = "",
    ) -> Symbol:
        """State a parameter, with its dimensionless name ``becomes`` and default value ``base``.

        ``role`` is ``"friction"``, the loading parameter by default, or ``"inclination"``. Without
        these roles the friction is the coefficient to which the friction law is proportional, and
        the inclination the first angle.
        """
        _check_texts(
            name=name, unit=unit, meaning=meaning, domain=domain, becomes=becomes, latex=latex
        )
        roles = ("friction", "inclination")
        if role not in ("", *roles):
            raise refused(f"the role {role!r} of {name} is not one of {', '.join(roles)}")
        if role and (other := next((it for it in self.parameters if it.role == role), None)):
            raise refused(f"{other.symbol} and {name} are both the {role}; give it to one of them")
        symbol = Symbol(name, **_assumptions(domain))
        if base is not None and (
            isinstance(base, bool)
            or not isinstance(base, int | float | Expr)
            or not sp.sympify(base).is_number
        ):
            raise refused(
                f"the base value {base!r} of {name} is no number; give one without quotation "
                "marks, as 0.5"
            )
        number, allowed = None if base is None else float(base), interval(domain)
        if number is not None and not allowed.holds(number):
            advice = "; angles are in radians: 45 degrees are pi/4" if unit == "rad" else ""
            raise refused(f"the base value {base} of {name} is not in its domain {domain}{advice}")
        turn = 2 * math.pi * (1 + 1e-9)
        # A wider domain is one in degrees.
        if unit == "rad" and turn < allowed.high - allowed.low < math.inf:
            raise refused(
                f"the domain {domain} of the angle {name} is wider than a turn; angles are in "
                "radians, as (0, pi), and one of several turns, as of a rope, has the unit 1"
            )
        for other in self.parameters:
            if other.becomes == (becomes or name):
                raise refused(
                    f"{other.symbol} and {name} both become {other.becomes}; give one of them "
                    "another name with becomes"
                )
        letter = latex or names.latex(name)
        return self._entered(
            self.parameters,
            Datum(
                symbol, unit, meaning, domain, letter, line_of_page(), becomes or name, number, role
            ),
        )

    def coordinate(self, name: str, unit: str, meaning: str, latex: str = "") -> Symbol:
        """State a coordinate: a length, an angle or another measure of the configuration."""
        _check_texts(name=name, unit=unit, meaning=meaning, latex=latex)
        symbol = Symbol(name, real=True)
        letter = latex or names.latex(name)
        entered = self._entered(
            self.coordinates,
            Coordinate(symbol, speed_of(symbol), unit, meaning, letter, line_of_page()),
        )
        # The clock is the last coordinate: reports that show the first one show a motion.
        clock = self.timer and self.timer.symbol
        self.coordinates.sort(key=lambda it: it.symbol == clock)
        return entered

    def clock(self, speed: Expr, name: str = "phase") -> Symbol:
        """State the phase ``speed`` t of a periodic excitation, an angle.

        Cosines and sines of its whole multiples may stand in forces, ends of springs, gaps, normal
        forces and belt speeds.
        """
        if self.timer is not None:
            raise refused(
                f"line {self.timer.line} has a clock already; let cos and sin of whole multiples "
                "of it stand for other frequencies"
            )
        rate = expression_of(speed)
        if moving := self._moving(rate):
            raise refused(
                f"the speed of the clock depends on {moving}; give one that stays, as omega"
            )
        if not rate.is_positive:
            raise refused(
                f"the speed of the clock {rate} may be 0 or negative; give its parameters a domain "
                'that says it is not, as "> 0"'
            )
        symbol = self.coordinate(name, "rad", "phase of the clock")
        self.timer = Clock(symbol, rate, line_of_page())
        return symbol

    def rate(self, of: Expr) -> Expr:
        """The time derivative of a coordinate, or of an expression in coordinates."""
        return sp.Add(*(sp.diff(expression_of(of), it.symbol) * it.rate for it in self.coordinates))

    # ---------------------------------------------------------------------------------------------
    # energies and forces

    def kinetic(self, energy: Expr) -> None:
        """State the kinetic energy: terms quadratic in the rates; as in a rotating frame also terms
        linear in them, and terms without rates.
        """
        if self.inertia is not None:
            raise refused(
                f"line {self.inertia[1]} says the kinetic energy already, and this would replace "
                "it; add it there"
            )
        self.inertia = expression_of(energy), line_of_page()

    def potential(self, energy: Expr) -> None:
        """State a potential energy besides that of the springs."""
        self.energies.append((expression_of(energy), line_of_page()))

    def spring(
        self,
        stiffness: Expr,
        *ends: Point,
        length: Expr | int = 0,
        along: Expr | None = None,
    ) -> None:
        """State a spring: straight between two ``ends``, of undeformed ``length``, or along a
        coordinate.
        """
        for what, value in (("stiffness", stiffness), ("undeformed length", length)):
            if moving := self._moving(expression_of(value)):
                raise refused(
                    f"the {what} of this spring depends on {moving}; say its energy with "
                    "page.potential"
                )
        self.springs.append(_element("spring", stiffness, ends, along, length))

    def torsion(self, stiffness: Expr, *ends: Point, rest: Expr) -> None:
        """State a torsion spring, which turns the line from the first end to the second towards the
        inclination ``rest``.

        Its energy is k φ²/2 with the angle φ in (−π, π] from that inclination. At φ = ±π the torque
        jumps from k π to −k π; the energy is continuous there.
        """
        self.torsions.append(_element("torsion spring", stiffness, ends, None, rest))

    def damper(self, coefficient: Expr, *ends: Point, along: Expr | None = None) -> None:
        """State a viscous damper: straight between two ``ends``, or along a coordinate."""
        self._check_speeds(expression_of(coefficient), "the coefficient", Limit.NONLINEAR_DAMPER)
        self.dampers.append(_element("damper", coefficient, ends, along, 0))

    def force(self, *components: Expr, at: Point | None = None, along: Expr | None = None) -> None:
        """State an applied force: two components at a point, or one along a coordinate."""
        if (at is None) == (along is None) or len(components) != (1 if at is None else 2):
            raise refused(
                "a force has two components at a point, force(F_x, F_y, at=(x, y)), or one "
                "along a coordinate"
            )
        if at is not None and (not isinstance(at, tuple | list) or len(at) != 2):
            raise refused(
                f"at = {at} is no point of the plane; give its two coordinates, as at=(x, y)"
            )
        point = (_along(along),) if at is None else tuple(map(expression_of, at))
        self.forces.append(Force(tuple(map(expression_of, components)), point, line_of_page()))

    # ---------------------------------------------------------------------------------------------
    # laws

    def contact(self, gap: Expr, law: Law, unilateral: bool = True, *, name: str = "") -> Contact:
        """State a contact: its normal force N as a ``law`` of the penetration −gap.

        A ``unilateral`` contact has no force at a positive gap, and its law is ≥ 0 for all
        parameters in their domains. Any other contact never opens, as in a slot: where N is
        negative the mass is pressed on the opposite face, and friction takes |N|.

        A page with several contacts gives each a ``name``. A contact without friction is a stop.
        """
        self._check_law(law, "contact", "penetration")
        distance = expression_of(gap)
        self._check_speeds(distance, "the gap")
        return self._pressed(Contact(distance, law, unilateral, line_of_page(), name))

    def normal_force(self, force: Expr, unilateral: bool = True, *, name: str = "") -> Contact:
        """State a contact with a given normal force N in place of a law.

        N ≥ 0 for all parameters in their domains and all coordinates if ``unilateral``; else of any
        sign, and friction takes |N|.
        """
        given = expression_of(force)
        self._check_speeds(given, "the normal force", Limit.NORMAL_SPEED)
        return self._pressed(Contact(None, lambda depth: given, unilateral, line_of_page(), name))

    def _pressed(self, contact: Contact) -> Contact:
        _check_texts(name=contact.name)
        if not isinstance(contact.unilateral, bool):
            raise refused(f"unilateral = {contact.unilateral!r:.60} is neither True nor False")
        self.contacts.append(contact)
        return contact

    def friction(
        self,
        along: Expr,
        belt: Expr,
        law: Law | None = None,
        at_rest: Expr | None = None,
        *,
        slip: Law | None = None,
        holds: Expr | None = None,
        on: Contact | None = None,
    ) -> None:
        """State the friction on a contact, smooth or dry; ``on`` names one of several contacts.

        Smooth friction is a coefficient as a ``law`` of the sliding speed ``belt − rate(along)``,
        0 at speed 0. Statics takes ``at_rest``, the limit of the law at fast sliding, or if that is
        left out the law at the belt's speed.

        Dry friction is a law ``slip``, which may jump at speed 0, and the static coefficient
        ``holds``: at sliding speed 0 the mass sticks, by any force F up to holds times the normal
        force N, or up to slip(0) N where this is more. The rules at the limits:

        - It sticks as soon as the sliding speed is 0 and |F| ≤ holds N with N > 0, |F| = holds N
          included; else the speed passes 0.
        - It slips as soon as |F| is larger, in the direction in which F would accelerate it; and as
          soon as the contact is lost.
        - A sliding speed that only touches 0 sticks there too, if the force is within its limit; a
          touch to within 1e-12 may be missed.
        - On a belt at rest, V = 0, every position at which F is within the limit is an equilibrium.
        """
        if on is not None and not any(on is contact for contact in self.contacts):
            raise refused(
                f"on = {on!r:.60} is no contact of this page; give what page.contact(…) or "
                "page.normal_force(…) returned, as front = page.contact(…, name='front')"
            )
        if (law is None) == (slip is None) or (slip is None) != (holds is None):
            raise refused(
                "friction takes one law of the sliding speed, or both slip=… and holds=…, as "
                "slip=lambda v: mu_k*sgn(v), holds=mu_s"
            )
        coefficient = None if holds is None else expression_of(holds)
        if coefficient is not None and (moving := self._moving(coefficient)):
            raise refused(
                f"what friction holds depends on {moving}; give a coefficient that stays, as mu_s"
            )
        given = cast(Law, slip if law is None else law)
        self._check_law(given, "friction", "sliding speed")
        limit = None if at_rest is None else expression_of(at_rest)
        self.frictions.append(
            Friction(
                expression_of(along),
                expression_of(belt),
                given,
                limit,
                line_of_page(),
                coefficient,
                on,
            )
        )

    def _check_law(self, law: Law, kind: str, of: str) -> None:
        """Refuse a law that depends on more than its variable, or fails for an expression."""
        limit = Limit.FRICTION_STATE if kind == "friction" else Limit.CONTACT_DAMPING
        if len(needed := _needed(law, kind, of)) > 1:
            raise refused(
                f"the {kind} law takes {', '.join(needed)}; it is a law of the {of} alone: {limit}"
            )
        try:
            moving = self._moving(expression_of(law(sp.Dummy(positive=True))))
        except PageError:
            raise
        except Exception as error:  # whatever the page's own code raises
            raise refused(
                f"the {kind} law can't be taken of an expression: {type(error).__name__}: "
                f"{error}; give a function of one argument, "
                f"made of {', '.join(FUNCTIONS)}, sqrt of spragsym.derive.model"
            ) from error
        if moving:
            rates = any(str(rate) in moving.split(", ") for rate in self.rates)
            limit = Limit.PLANE if kind == "friction" and rates else limit
            said = f": {limit}" if kind == "friction" or rates else ""
            raise refused(
                f"the {kind} law depends on {moving}; it is a law of the {of} alone{said}"
            )

    def _check_speeds(
        self, expression: Expr, what: str, limit: object = Limit.CONTACT_DAMPING
    ) -> None:
        """Refuse an expression that holds a rate."""
        held = [str(rate) for rate in self.rates if expression.has(rate)]
        if held:
            raise refused(f"{what} {expression} holds the speed {', '.join(held)}: {limit}")

    def _moving(self, expression: Expr) -> str:
        """The coordinates and rates in an expression, as text."""
        return ", ".join(sorted(map(str, expression.free_symbols & {*self.places, *self.rates})))

    def _entered(self, entries: list[Any], entry: Datum | Coordinate) -> Symbol:
        """Enter a quantity and return its symbol; a name that stands twice is refused."""
        if str(entry.symbol) in (
            str(other.symbol) for other in (*self.units, *self.parameters, *self.coordinates)
        ):
            raise refused(f"{entry.symbol} is defined twice; give the second quantity another name")
        entries.append(entry)
        return entry.symbol


def _needed(law: Law, kind: str, of: str) -> list[str]:
    """Names of the arguments without defaults that a law takes."""
    if not callable(law):
        raise refused(
            f"the {kind} law is {law!r}, no function; give one of the {of}, as lambda {kind[0]}: …"
        )
    try:
        arguments = inspect.signature(law).parameters.values()
    except ValueError:  # a function of a library that does not say what it takes
        return []
    return [
        it.name
        for it in arguments
        if it.default is it.empty and it.kind in (it.POSITIONAL_ONLY, it.POSITIONAL_OR_KEYWORD)
    ]


def _along(along: Expr | None) -> Expr:
    """The coordinate of an element or a force along it."""
    if not isinstance(along, Expr):
        raise refused(
            f"along = {along!r} is no coordinate; give the coordinate itself, as along=x "
            "without quotation marks"
        )
    return expression_of(along)


def _element(
    what: str,
    strength: Expr,
    ends: tuple[Point, ...],
    along: Expr | None,
    rest: Expr | int,
) -> Element:
    """An element from the arguments of its statement, which are checked."""
    if along is not None:
        along = _along(along)
    if (len(ends), along is None) not in ((2, True), (0, False)):
        raise refused(
            "a spring or a damper has two ends, (x, y) each, or is along a coordinate: along=x"
        )
    if any(not isinstance(end, tuple | list) or len(end) != 2 for end in ends):
        raise refused(
            "an end of a spring or a damper is a point of the plane, (x, y); here are "
            f"{ends[0]} and {ends[1]}"
        )
    both = tuple((expression_of(x), expression_of(y)) for x, y in ends)
    return Element(
        what,
        expression_of(strength),
        (both[0], both[1]) if both else None,
        along,
        expression_of(rest),
        line_of_page(),
    )


def _check_texts(**texts: object) -> None:
    """Refuse descriptions that are no text, or hold characters that no file may have."""
    for what, text in texts.items():
        if not isinstance(text, str):
            raise refused(
                f"{what} = {text!r} is no text; write it in quotation marks, in its place "
                "among the arguments"
            )
        check_characters(what, text, line_of_page())


def check_characters(what: str, text: str, line: int, allowed: str = "") -> None:
    """Refuse characters that source files of some language can't hold: control characters, line
    ends, surrogates and marks of the writing direction, except those that are ``allowed``.
    """
    unprinted = ("Cc", "Cf", "Cs", "Zl", "Zp")
    for character in text:
        if unicodedata.category(character) in unprinted and character not in allowed:
            raise PageError(
                line,
                f"{what} = {text!a} holds the character U+{ord(character):04X}, which is not "
                "printed; take it out",
            )


def _assumptions(domain: str) -> dict[str, bool]:
    """SymPy's assumptions about a quantity of a domain."""
    try:
        allowed = interval(domain)
    except ValueError as error:
        raise refused(str(error)) from error
    if not allowed.low < allowed.high:
        raise refused(f"the domain {domain} holds no number; give its lower end first")
    if allowed.low > 0 or (allowed.low == 0 and allowed.low_open):
        return {"positive": True}
    return {"nonnegative": True} if allowed.low == 0 else {"real": True}
