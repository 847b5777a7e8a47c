"""Checks of a page's physics: units, contacts that push, friction that opposes sliding, inertia and
a force for every coordinate.

Each error names the line of the page, what was expected there, and what still works without it.
"""

import sympy as sp
from sympy import Expr, Rational, S, Symbol

from . import laws, signs, symmetry, units
from .limits import Limit
from .mechanics import DEPTH, SLIP, FrictionForce, Mechanics, NormalForce, number
from .model import Datum, Page, PageError
from .statement_checks import PageExpression, statements
from .units import Dimension, UnitsError, spelled


def check_units(page: Page) -> None:
    """Raise a PageError for a sum of different dimensions, or a statement of the wrong
    dimension.
    """
    dimensions = _dimensions(page) | {DEPTH: units.read("m"), SLIP: units.read("m/s")}
    for it in statements(page):
        _check_dimension(it, dimensions)
    angles = {datum.symbol for datum in page.parameters if datum.unit == "rad"}
    for torsion in page.torsions:
        if not torsion.rest.free_symbols <= angles:
            raise PageError(
                torsion.line,
                "the inclination at rest of a torsion spring is made of angles of the page; "
                "give rest=theta0",
            )


def _check_dimension(it: PageExpression, dimensions: dict[Symbol, Dimension]) -> None:
    unknown = sorted(str(symbol) for symbol in it.value.free_symbols if symbol not in dimensions)
    if unknown:
        time = f": {Limit.FORCING}" if {"t", "time"} & set(unknown) else ""
        raise PageError(
            it.line,
            f"{it.what} holds {', '.join(unknown)}, which the page does not define; define it "
            f"above{time}",
        )
    power = max((abs(part.exp) for part in it.value.atoms(sp.Pow) if part.exp.is_number), default=0)
    # Derivatives of larger powers, and their products, take very long.
    most_power = 20
    if power > most_power:
        raise PageError(
            it.line,
            f"{it.what} holds a power of {str(power)[:40]}; write one of at most "
            f"{most_power}, or a function such as exp",
        )
    try:
        found = units.of(it.value, dimensions)
    except UnitsError as error:
        raise PageError(it.line, f"{it.what}: {error}") from error
    if it.unit is None or found is None:
        return
    expected = units.times(units.read(it.unit), units.of(it.per, dimensions) or units.NONE, -1)
    if found != expected:
        raise PageError(
            it.line,
            f"{it.what} = {it.value} is in {spelled(found)}; expected is {spelled(expected)}",
        )


def _dimensions(page: Page) -> dict[Symbol, Dimension]:
    dimensions: dict[Symbol, Dimension] = {}
    for entry in (*page.units, *page.parameters, *page.coordinates):
        try:
            dimensions[entry.symbol] = units.read(entry.unit)
        except UnitsError as error:
            raise PageError(entry.line, str(error)) from error
    for coordinate in page.coordinates:
        dimensions[coordinate.rate] = units.times(
            dimensions[coordinate.symbol], units.read("s"), -1
        )
    return dimensions


def groups(page: Page) -> dict[str, Expr]:
    """Every dimensionless parameter: its quantity over the product of units of measure that has the
    same dimension.

    Raises
    ------
    PageError
        If the units of measure are dependent, or do not give every dimension.
    """
    dimensions = _dimensions(page)
    measures = tuple(dimensions[unit.symbol] for unit in page.units)
    for index, unit in enumerate(page.units):
        if units.powers(measures[index], measures[:index]) is not None:
            others = ", ".join(str(other.symbol) for other in page.units[:index]) or "numbers"
            raise PageError(
                unit.line,
                f"{unit.symbol} is in {unit.unit}, as is a product of powers of {others}: it "
                "can't become 1 too; make it a parameter",
            )
    found = {}
    for entry in (*page.parameters, *page.coordinates):
        measure = scale(page, dimensions[entry.symbol])
        if measure is None:
            raise PageError(
                entry.line,
                f"{entry.symbol} is in {entry.unit}, and no product of "
                f"{', '.join(str(unit.symbol) for unit in page.units) or 'nothing'}, which become "
                "1, is; make three independent quantities units of measure with page.unit(...)",
            )
        if isinstance(entry, Datum):
            if entry.becomes != str(entry.symbol) and dimensions[entry.symbol] == units.NONE:
                raise PageError(
                    entry.line,
                    f"{entry.symbol} has no unit to be rid of and keeps its name; leave out "
                    f"becomes={entry.becomes!r}, or name it so",
                )
            found[entry.becomes] = entry.symbol / measure
    return found


def scale(page: Page, dimension: Dimension) -> Expr | None:
    """The product of powers of units of measure that has a dimension; None if there is none."""
    dimensions = _dimensions(page)
    powers = units.powers(dimension, tuple(dimensions[unit.symbol] for unit in page.units))
    if powers is None:
        return None
    return sp.Mul(
        *(unit.symbol ** Rational(power) for unit, power in zip(page.units, powers, strict=True))
    )


# ------------------------------------------------------------------------------------------------
# laws and forces


def check_forces(model: Mechanics, *, only_equations: bool = False) -> None:
    """Raise a PageError for a contact that pulls, friction that drives, or a coordinate without
    inertia or, unless the page is of ``only_equations``, force.
    """
    for contact in model.contacts:
        _check_contact(model, contact)
    for friction in model.frictions:
        _check_friction(model, friction)
    _check_independent(model)
    for friction in model.frictions:
        laws.friction_at_rest(friction)
    for row, entry in enumerate(model.page.coordinates):
        if model.mass.row(row).is_zero_matrix:
            raise PageError(
                entry.line,
                f"{entry.symbol} has no inertia: the kinetic energy does not hold its rate; add "
                f"it: {Limit.WITHOUT_MASS}",
            )
    _, line = model.page.kinetic_energy
    if model.mass.has(*model.rates):
        raise PageError(line, f"the kinetic energy is no polynomial: {Limit.MASS_OF_SPEED}")
    if model.mass.det() == 0:
        raise PageError(
            line,
            "the kinetic energy has no regular quadratic form of the rates: the equations of "
            "motion can't be solved for q″; give every combination of rates a mass",
        )
    _check_inertia(model)
    if model.page.timer and not symmetry.is_as_before(model, {len(model.coordinates) - 1: 1}):
        raise PageError(
            model.page.timer.line,
            f"not all is as before after a turn of {model.clock}; let it stand in cos and sin of "
            f"whole multiples, as cos({model.clock}) or cos(2*{model.clock})",
        )
    for row, (entry, force) in enumerate(zip(model.page.coordinates, model.residuals, strict=True)):
        if force == 0 and not only_equations:
            working = [
                str(other.symbol)
                for index, other in enumerate(model.page.coordinates)
                if index != row
            ]
            rest = f"; the forces along {', '.join(working)} are well" if working else ""
            raise PageError(
                entry.line,
                f"no force acts on {entry.symbol}; add a spring, a potential or a force along "
                f"it{rest}",
            )


def _check_inertia(model: Mechanics) -> None:
    """The mass matrix is positive definite at the base values: at coordinates 0, where it may be
    singular, or else at a second place.
    """
    energy, line = model.page.kinetic_energy
    M = model.mass.subs(_bases(model))
    second = {q: Rational(3 + i, 7) for i, q in enumerate(model.coordinates)}
    places = [M.subs(at) for at in (dict.fromkeys(model.coordinates, 0), second)]
    if not (
        all(it.is_positive_semidefinite for it in places)
        and any(it.is_positive_definite for it in places)
    ):
        raise PageError(
            line,
            f"the kinetic energy {energy} is not positive for all rates at the base values; "
            "masses are",
        )


def _check_contact(model: Mechanics, contact: NormalForce) -> None:
    if contact.line and contact.law == 0:
        raise PageError(
            contact.line,
            "the normal force is 0, so that nothing pushes and nothing rubs; give one that is "
            "positive",
        )
    if contact.line and contact.gap is None and not contact.either_face:
        _check_pushes(model, contact, f"the normal force {contact.law}", Limit.EITHER_FACE)
    if contact.unilateral and contact.law.subs(contact.depth, 0) != 0:
        raise PageError(
            contact.line,
            f"the contact law gives {contact.law.subs(contact.depth, 0)} where the mass just "
            "touches the belt; a force that jumps there is not "
            "covered: let it begin at 0, or say unilateral=False for a mass that never leaves",
        )
    stiffness = sp.diff(contact.law, contact.depth)  # where that is nowhere negative the law rises
    if contact.unilateral and not signs.is_nonnegative(model, stiffness):
        _check_pushes(model, contact, "the contact law", Limit.PULLING)


def _check_pushes(model: Mechanics, contact: NormalForce, what: str, limit: Limit) -> None:
    """Refuse a force that is not proved to be ≥ 0; the error says where it pulls, if that is
    found.
    """
    if not signs.is_nonnegative(model, contact.law):
        where = signs.witness(model, contact.law)
        pulls = f" pulls: {where}; " if where else ": "
        raise PageError(contact.line, f"{what}{pulls}{limit}")


def _check_friction(model: Mechanics, sliding: FrictionForce) -> None:
    written = next((it.belt for it in model.page.frictions if it.line == sliding.line), S.Zero)
    if sliding.belt == sliding.still and not signs.is_nonnegative(model, sliding.belt):
        raise PageError(
            sliding.line,
            f"the belt's speed {written} may be negative, and equilibria take friction along the "
            "belt's direction; let the coordinate point along the belt, and give what stands in "
            "its speed domains with which it is >= 0"
            f"{f'; {Limit.PLANE}' if written.has(sp.cos, sp.sin) else ''}",
        )
    if sliding.holds is not None and _negative(model, sliding.holds, SLIP):
        raise PageError(
            sliding.line,
            f"holds = {sliding.holds} is negative at the base values; give a coefficient that "
            "is >= 0",
        )
    for side, value in (("ahead", sliding.ahead), ("behind", -sliding.behind)):
        at_zero = laws.limit(sliding, value, S.Zero)
        if sliding.holds is not None and _negative(model, at_zero, SLIP):
            law = at_zero if side == "ahead" else -at_zero
            raise PageError(
                sliding.line,
                f"the friction law drives: where the belt is just {side} of the mass it is "
                f"{law}; friction opposes sliding, as mu_k*sgn(v)",
            )
        if sliding.holds is None and at_zero != 0:
            raise PageError(
                sliding.line,
                f"the friction law drives at rest: where the belt is just {side} of the mass "
                f"it is {at_zero}, not 0: {Limit.STICKING}",
            )
        witness = _negative(model, value, SLIP)
        if witness:
            raise PageError(
                sliding.line,
                f"the friction law drives where the belt is {side}: {witness}; friction "
                "opposes sliding",
            )


def _check_independent(model: Mechanics) -> None:
    """Dry frictions oppose independent displacements: else their forces are not determined while
    all stick.
    """
    holding: list[FrictionForce] = []
    for friction in model.frictions:
        if friction.holds is None:
            continue
        holding.append(friction)
        along = sp.Matrix([it.along for it in holding]).jacobian(model.coordinates)
        if along.rank() < len(holding):
            others = " and ".join(it.name for it in holding[:-1])
            raise PageError(
                friction.line,
                f"the friction of {friction.name} holds along a displacement that follows from "
                f"that of {others}: where all stick, what each of them holds is not told; write a "
                "law that is steep at rest, as mu0*tanh(d*v), or leave all but one as slip=…, "
                "holds=…",
            )


def _negative(model: Mechanics, law: Expr, variable: Symbol) -> str:
    """Where a law is negative at the base values, as text; empty if no value of its variable that
    is tried shows it.
    """
    if signs.is_nonnegative_everywhere(law):
        return ""
    values = _bases(model)
    for power in range(-6, 3):
        at = Rational(10) ** power
        value = law.subs(values).subs(variable, at)
        if value.is_number and value.is_negative:
            return (
                f"at {variable} = {sp.N(at, 3)} it is {sp.N(value, 3)} times its scale, at the "
                "base values"
            )
    return ""


def _bases(model: Mechanics) -> dict[Symbol, Expr]:
    """Base values of all parameters; 1 for those without one."""
    bases = {
        number(it): Rational(1 if it.base is None else str(it.base)) for it in model.parameters
    }
    return signs.placed(model, bases)
