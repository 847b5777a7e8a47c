"""Checks of a page's statements one by one: names, contacts, springs, laws, use of quantities.

:mod:`derive.physical_checks` checks units and forces. Each error names the line, what was expected,
and the remedy.
"""

import keyword
from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, S, Symbol

from . import reserved, signs
from .emit.quantities import interval
from .limits import Limit
from .mechanics import DEPTH, SLIP
from .model import Page, PageError, acceleration_of, expression_of, speed_of

#: Largest length of a name: MATLAB distinguishes 63 letters, of which generated code needs some.
LONGEST = 40


def check(page: Page, docstring: str, *, only_equations: bool = False) -> None:
    """Raise a :class:`~derive.model.PageError` for the first wrong statement of a page.

    Of a page of ``only_equations`` nothing is generated, and no equilibrium is asked: forces and
    kinetic energies may be of any form.
    """
    if not docstring.strip():
        raise PageError(
            1,
            'the page has no docstring; begin it with r"""…""": what the model is, and its drawing',
        )
    if not page.coordinates:
        raise PageError(
            0, "the page has no coordinate, and a model has 1 to 4; add page.coordinate(…)"
        )
    if len(page.coordinates) > 4:
        excess = page.coordinates[4]
        raise PageError(
            excess.line,
            f"{excess.symbol} is coordinate 5 of {len(page.coordinates)}: {Limit.FIFTH_COORDINATE}",
        )
    _check_contacts(page)
    _check_names(page, only_equations)
    _check_elements(page)
    if not only_equations:
        _check_statics(page)
    _check_places(page)


# ------------------------------------------------------------------------------------------------
# names


def _check_names(page: Page, only_equations: bool) -> None:
    for datum in (*page.units, *page.parameters):
        name = datum.symbol.name
        if name in reserved.OF_FILES:
            raise PageError(
                datum.line,
                f"this quantity is named {name!r}, as a key of files of data is; give it "
                "another name",
            )
        if not name.isidentifier():
            raise PageError(
                datum.line,
                f"this quantity is named {name!r}, which is no name; give it another, as "
                f"{_instead(name)!r}",
            )
    taken: dict[str, tuple[str, int]] = {}
    for name, what, line in _own_names(page) if only_equations else _names(page):
        for refused, why in (
            (
                not name.isidentifier() or keyword.iskeyword(name),
                f"which is no name in Python; give it another, as {_instead(name)!r}",
            ),
            (
                not name.isascii(),
                "which C can't spell; give it a name of Latin letters, and its symbol with latex=",
            ),
            (
                name.startswith("_") or len(name) > LONGEST,
                f"and a name begins with a letter and has at most {LONGEST}, as languages "
                "that code is exported to ask; give it another name",
            ),
            (name in reserved.OF_CODE, "which generated functions use; give it another name"),
        ):
            if refused:
                raise PageError(line, f"{what} is named {name!r}, {why}")
        if name in taken:
            other, first = taken[name]
            where = f" of line {first}" if first else ""
            raise PageError(
                line,
                f"{what} is named {name!r}, as is {other}{where}; give one of them another name",
            )
        taken[name] = what, line


def _own_names(page: Page) -> Iterator[tuple[str, str, int]]:
    """The names of what the page states, and of rates and accelerations."""
    for datum in (*page.units, *page.parameters):
        yield str(datum.symbol), "this quantity", datum.line
    for entry in page.coordinates:
        yield str(entry.symbol), "this coordinate", entry.line
        yield str(entry.rate), f"the rate of {entry.symbol}", entry.line
        yield acceleration_of(entry.symbol), f"the acceleration of {entry.symbol}", entry.line


def _names(page: Page) -> Iterator[tuple[str, str, int]]:
    """Every name in generated code and results: the name, its meaning, the line of its
    statement.
    """
    lines = {str(element.ends) for element in page.elements if element.ends is not None}
    for count in range(1, len(lines) + 1):
        for part in "csl":
            yield f"{part}{count}", f"the direction or length of spring {count}", 0
    several = len(page.contacts) > 1
    for contact in page.contacts if several else [None]:
        end, line = ("", 0) if contact is None else (f"_on_{contact.name}", contact.line)
        for count in range(1, 10):  # more exponentials of the sliding speed are in no law
            yield f"near{count}{end}", "a switch of the friction law", line
    for contact in page.contacts if several else ():
        for part in ("pushing_", "mu_on_", "side_on_"):
            of_contact = f"an argument for the contact {contact.name}"
            yield f"{part}{contact.name}", of_contact, contact.line
        yield f"contact_force_{contact.name}", "a column of the contact's force", contact.line
    for count in range(1, len(page.torsions) + 1):
        for part in ("phi", "way"):
            yield f"{part}{count}", f"the turning of torsion spring {count}", 0
    for entry in page.coordinates:
        yield str(entry.symbol), "this coordinate", entry.line
    for entry in page.coordinates:
        q, v = entry.symbol, entry.rate
        for name, what in (
            (f"{v}", "the rate of"),
            (acceleration_of(q), "the acceleration of"),
            (f"{q}0", "the start of"),
            (f"{v}0", "the start of the rate of"),
            (f"mean_{q}", "a column of a sweep, for"),
            (f"rest_{q}", "a column of a sweep, for"),
            (f"cycle_{q}", "a column of a sweep, for"),
            (f"cycle_{v}", "a column of a sweep, for"),
        ):
            yield name, f"{what} {q}", entry.line
    for datum in page.parameters:
        yield datum.becomes, "this parameter", datum.line
        if datum.unit == "rad" and datum.becomes.isidentifier():
            for part, name in zip(("cos", "sin"), datum.cosine_and_sine, strict=True):
                yield name, f"the {part} of {datum.becomes}", datum.line


def _instead(name: str) -> str:
    """A similar name that is allowed."""
    tidy = "".join(letter if letter.isalnum() else "_" for letter in name).strip("_")
    if keyword.iskeyword(tidy):
        return f"{tidy}_"
    return tidy if tidy.isidentifier() else f"p_{tidy}"


# ------------------------------------------------------------------------------------------------
# contacts


def _check_contacts(page: Page) -> None:
    """Several contacts have different names, and each has at most one friction."""
    several = len(page.contacts) > 1
    named: dict[str, int] = {}
    for contact in page.contacts if several else ():
        name, example = contact.name, 'page.contact(…, name="front")'
        if not name:
            raise PageError(
                contact.line,
                f"of {len(page.contacts)} contacts each has a name; give this one its own, as "
                f"{example}",
            )
        if not name.isidentifier() or not name.isascii() or len(name) > LONGEST // 2:
            raise PageError(
                contact.line,
                f"this contact is named {name!r}; a name is of Latin letters, digits and _, begins "
                f"with a letter, and has at most {LONGEST // 2}, as {example}",
            )
        if name in named:
            raise PageError(
                contact.line,
                f"this contact is named {name!r}, as is that of line {named[name]}; give one of "
                "them another name",
            )
        named[name] = contact.line
    rubbed: dict[int, int] = {}
    for friction in page.frictions:
        if several and friction.on is None:
            raise PageError(
                friction.line,
                f"the page has {len(page.contacts)} contacts; say on which of them this friction "
                "acts, as page.friction(…, on=front) after front = page.contact(…)",
            )
        on = id(friction.on) if several else 0
        if on in rubbed:
            raise PageError(
                friction.line,
                f"line {rubbed[on]} says the friction on this contact already: {Limit.PLANE}",
            )
        rubbed[on] = friction.line


# ------------------------------------------------------------------------------------------------
# springs and dampers


def _check_elements(page: Page) -> None:
    seen: dict[object, int] = {}
    moving = set(page.places)
    for element in page.elements:
        what, strength = element.what, element.strength
        if _is_negative(page, strength):
            does = (
                "drives the motion" if what == "damper" else "pushes away from where it is at rest"
            )
            raise PageError(
                element.line,
                f"the {element.quality} of this {what}, {strength}, is negative: it {does}; "
                "give a positive one",
            )
        if what == "damper" and (where := _negative_place(page, strength)):
            raise PageError(
                element.line,
                f"the coefficient of this damper, {strength}, is negative {where}, where it "
                "drives the motion; give its quantities "
                'domains in which it is not, as ">= 0", or write it so',
            )
        if what == "spring" and _is_negative(page, element.rest):
            raise PageError(
                element.line,
                f"the undeformed length {element.rest} of this spring is negative; give a "
                "positive one",
            )
        if element.along is not None:
            _check_along(page, element.along, f"along of this {what}", element.line)
        elif element.ends is not None:
            one, two = element.ends
            vector = [sp.expand(end - begin) for begin, end in zip(one, two, strict=True)]
            if not any(part.free_symbols & moving for part in vector):
                apart = (
                    "are the same point" if not any(vector) else "do not move against each other"
                )
                raise PageError(
                    element.line,
                    f"the two ends of this {what} {apart}: it does nothing; give the mass's "
                    "end and the anchor's",
                )
        key = what, strength, str(element.ends), element.along, element.rest
        if key in seen:
            raise PageError(
                element.line,
                f"this {what} is the same as that of line {seen[key]}; drop it, or write "
                f"2*{strength} if there are two",
            )
        seen[key] = element.line


def _check_along(page: Page, along: Expr, what: str, line: int) -> None:
    if along.free_symbols & {*page.rates}:
        raise PageError(line, f"{what} is {along}, a speed; give the coordinate itself, as along=x")
    if not along.free_symbols & {*page.places}:
        raise PageError(
            line, f"{what} is {along}, which no coordinate moves; give a coordinate, as along=x"
        )


def _is_negative(page: Page, value: Expr) -> bool:
    """Whether an expression is negative by its form or at the base values, with 1 for quantities
    that have none.
    """
    bases = {
        it.symbol: S.One if it.base is None else sp.Float(it.base)
        for it in (*page.units, *page.parameters)
    }
    at_base = value.subs(bases)
    return bool((value.is_nonpositive and not value.is_zero) or at_base.is_negative)


def _negative_place(page: Page, value: Expr) -> str:
    """Parameters in their domains at which an expression is negative, as text; empty if none are
    found.
    """
    measures = {entry.symbol: S.One for entry in page.units}
    domains = {entry.symbol: interval(entry.domain) for entry in page.parameters}
    scaled = value.subs(measures)
    if value.is_nonnegative or scaled.free_symbols - domains.keys():
        return ""
    found = signs.negative_place(scaled, domains) or {}
    where = ", ".join(f"{symbol} = {sp.N(number, 3)}" for symbol, number in found.items())
    return where and f"at {where}"


# ------------------------------------------------------------------------------------------------
# laws, forces, energies


def _check_clock(page: Page, own: set[Symbol]) -> None:
    """The clock and its speed, which are its ``own`` symbols, occur only in statements that may
    hold them.
    """
    said = [(it.along, it.line, "what friction opposes") for it in page.frictions]
    said += [(it.strength, it.line, f"the {it.quality} of this {it.what}") for it in page.elements]
    _refuse_clock(said, own)


def _refuse_clock(said: list[tuple[Expr, int, str]], own: set[Symbol]) -> None:
    for value, line, what in said:
        if value.free_symbols & own:
            raise PageError(
                line,
                f"{what} {value} holds the clock; it may stand in forces, ends of springs, gaps, "
                "normal forces and belt speeds: what shakes a mass is a force on it, or the end "
                "of its spring",
            )


def _own_of_clock(page: Page) -> set[Symbol]:
    """The clock and its speed."""
    return {page.timer.symbol, speed_of(page.timer.symbol)} if page.timer else set()


def _check_statics(page: Page) -> None:
    """What is asked of a page whose equilibria are."""
    own, rates = _own_of_clock(page), set(page.rates)
    _refuse_clock([(*page.kinetic_energy, "the kinetic energy")], own)
    for force in page.forces:
        if any(part.free_symbols & rates for part in force.components):
            raise PageError(
                force.line,
                "this force holds a speed; one in proportion to it is page.damper(c, along=x), and "
                f"friction is page.friction(…); of any other, {Limit.NONLINEAR_DAMPER}",
            )
    for sliding in page.frictions:
        if sliding.belt == 0 and not own and sliding.holds is None:
            raise PageError(
                sliding.line,
                "the belt's speed is 0, so nothing slides steadily; give the belt a speed, as V, "
                "or friction that holds, by slip=… and holds=…",
            )


def _check_places(page: Page) -> None:
    own = _own_of_clock(page)
    _check_clock(page, own)
    moving, rates = set(page.places), set(page.rates)
    for energy, line in page.energies:
        if energy.free_symbols & rates:
            raise PageError(
                line,
                "this potential energy holds a speed; what goes with speed is kinetic(...), "
                "damper(...) or friction(...)",
            )
    for contact in page.contacts:
        if contact.gap is not None and not contact.gap.free_symbols & moving:
            raise PageError(
                contact.line,
                f"the gap {contact.gap} holds no coordinate, so it never closes; give the "
                "distance of mass and belt",
            )
    for sliding in page.frictions:
        _check_along(page, sliding.along, "what friction opposes", sliding.line)
        if others := sliding.belt.free_symbols & ((moving | rates) - own):
            held = ", ".join(sorted(map(str, others)))
            raise PageError(
                sliding.line,
                f"the belt's speed {sliding.belt} holds {held}, which moves; give a speed that "
                f"stays, as V{f': {Limit.PLANE}' if sliding.belt.free_symbols & rates else ''}",
            )
        if not page.contacts:
            raise PageError(
                sliding.line,
                "there is friction and no normal force; add page.contact(...) or "
                "page.normal_force(...)",
            )


def check_used(page: Page) -> None:
    """Raise a PageError for a parameter that no statement uses."""
    used = sp.Tuple(*(it.value for it in statements(page))).free_symbols
    for datum in (it for it in page.parameters if it.symbol not in used):
        raise PageError(
            datum.line,
            f"{datum.symbol} is in no statement of the page; use it, or take this line out",
        )


@dataclass(frozen=True)
class PageExpression:
    """An expression of a page, and what it is called in errors.

    Times ``per`` it has to be in the ``unit``; None allows any.
    """

    value: Expr
    what: str
    line: int
    unit: str | None
    per: Expr = S.One


def statements(page: Page) -> Iterator[PageExpression]:
    """Every expression of the page."""
    for element in page.elements:
        kind, along, line = element.what, element.along, element.line
        if along is not None:
            yield PageExpression(along, f"along of this {kind}", line, None)
        for part in (part for end in element.ends or () for part in end):
            yield PageExpression(part, "the end of this line", line, "m")
        if kind == "spring":
            yield PageExpression(
                element.rest,
                "the undeformed length of this spring",
                line,
                "m" if along is None else "1",
                1 / (along or S.One),
            )
        for function in (sp.cos, sp.sin) if kind == "torsion spring" else ():
            yield PageExpression(
                function(element.rest), "the inclination at rest of this spring", line, "1"
            )
        in_line, along_angle = ("N s/m", "J s") if kind == "damper" else ("N/m", "J")
        unit = in_line if along is None and kind != "torsion spring" else along_angle
        yield PageExpression(
            element.strength,
            f"the {element.quality} of this {kind}",
            line,
            unit,
            (along or S.One) ** 2,
        )
    for energy, line in page.energies:
        yield PageExpression(energy, "this potential energy", line, "J")
    energy, line = page.kinetic_energy
    yield PageExpression(energy, "the kinetic energy", line, "J")
    if page.timer is not None:
        said, line = "the speed of the clock", page.timer.line
        yield PageExpression(page.timer.speed, said, line, "Hz")
    for force in page.forces:
        alone = len(force.place) == 1
        for component, position in zip(force.components, force.place, strict=True):
            yield PageExpression(
                position, "the place of this force", force.line, None if alone else "m"
            )
            work = ("J", position) if alone else ("N", S.One)
            yield PageExpression(component, "this force", force.line, *work)
    for contact in page.contacts:
        yield PageExpression(contact.gap or S.Zero, "the gap", contact.line, "m")
        what = "the normal force" if contact.gap is None else "the contact law"
        yield PageExpression(expression_of(contact.law(DEPTH)), what, contact.line, "N")
    for it in page.frictions:
        yield PageExpression(it.along, "the displacement that friction opposes", it.line, "m")
        yield PageExpression(it.belt, "the belt's speed", it.line, "m/s")
        for sign in (1, -1):
            yield PageExpression(
                expression_of(it.law(sign * SLIP)), "the friction law", it.line, "1"
            )
        yield PageExpression(it.at_rest or S.Zero, "at_rest", it.line, "1")
        yield PageExpression(it.holds or S.Zero, "what friction holds", it.line, "1")
