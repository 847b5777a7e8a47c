"""Symmetries of a model: full turns of angles, reflections, and exchanges of coordinates.

A reflection of some coordinates about a centre may reflect all forces if certain parameters are 0.
The article's model without friction and without a spring along the belt has one, x → 2 cos θ₀ − x:
there equilibria meet at pitchforks instead of folds. An exchange maps coordinates or contacts to
each other, if certain parameters are equal.
"""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, S, Symbol, expand

from .algebra import Symbols, expanded
from .factors import factor_list
from .mechanics import Line, Mechanics, NormalForce, number


def whole_turns(model: Mechanics) -> dict[int, dict[int, int]]:
    """The symmetries by full turns: for the index of an angle, the numbers of turns of all angles
    that turn with it, itself once.

    Most angles turn alone. Angles of links that a spring ties together turn together. Up to two
    turns of other angles are tried, and of those only that have no turn of their own.
    """
    angles = [k for k, entry in enumerate(model.page.coordinates) if entry.unit == "rad"]
    found: dict[int, dict[int, int]] = {k: {k: 1} for k in angles if is_as_before(model, {k: 1})}
    for index in angles:
        others = [k for k in angles if k not in found and k != index]
        counts = itertools.product(range(-2, 3), repeat=len(others)) if index not in found else ()
        for count in sorted(counts, key=lambda count: sum(map(abs, count))):
            turns = {index: 1} | {k: n for k, n in zip(others, count, strict=True) if n}
            if len(turns) > 1 and is_as_before(model, turns):
                found[index] = dict(sorted(turns.items()))
                break
    return found


def is_as_before(model: Mechanics, turns: Mapping[int, int]) -> bool:
    """Whether forces, lines, inertia and laws are invariant under full turns of coordinates;
    ``turns`` has their numbers by the index of the coordinate.
    """
    moved = {model.coordinates[k]: model.coordinates[k] + 2 * sp.pi * n for k, n in turns.items()}
    parts = [
        *model.residuals,
        *(part for line in model.lines for part in (line.dx, line.dy)),
        model.kinetic,
        model.linear,
        *model.depths.values(),
        *(friction.belt for friction in model.frictions),
        *(contact.push for contact in model.contacts),
        *model.resistance,
    ]
    return all(expand(part.subs(moved, simultaneous=True) - part) == 0 for part in parts)


@dataclass(frozen=True)
class Reflection:
    """A reflection q → 2c − q of some coordinates."""

    centres: Mapping[Symbol, Expr]  #: 2c by the reflected coordinate
    zero: tuple[tuple[str, ...], ...]  #: it is a symmetry if all parameters of one of these are 0

    def takes(self, line: Line, other: Line) -> bool:
        """Whether the image of a line is the mirror image (−dx, dy) of another one's vector."""
        images = {symbol: self.image(symbol) for symbol in self.centres}
        return bool(self.centres) and _lies(line, images, other, (-1, 1))

    def image(self, symbol: Symbol) -> Expr:
        """The image of a coordinate."""
        return self.centres[symbol] - symbol if symbol in self.centres else symbol


def _lies(
    line: Line, images: Mapping[Symbol, Expr], other: Line, line_signs: Sequence[int]
) -> bool:
    """Whether the vector of a line's image is that of another one with these signs of dx and dy."""
    dx, dy = (part.subs(images, simultaneous=True) for part in (line.dx, line.dy))
    return bool(
        expanded(dx - line_signs[0] * other.dx) == 0 == expanded(dy - line_signs[1] * other.dy)
    )


def mirror(model: Mechanics) -> Reflection:
    """The reflection that needs the fewest parameters to be 0; one of no coordinates if there is no
    reflection.
    """
    sizes = range(1, len(model.coordinates) + 1)
    subsets = itertools.chain.from_iterable(
        itertools.combinations(model.coordinates, size) for size in sizes
    )
    found = [one for reflected in subsets for one in _reflections_of(model, reflected)]
    return min(
        found, key=lambda one: (len(one.zero[0]), len(one.centres)), default=Reflection({}, ())
    )


def _reflections_of(model: Mechanics, turned: Symbols) -> Iterator[Reflection]:
    """The reflections of just these coordinates, about each centre that is possible."""
    for centre in _centres(model, turned):
        centres = {**dict.fromkeys(turned, S.Zero), turned[0]: centre}
        sets = _zero(model, _remainders(model, Reflection(centres, ())))
        if sets:
            yield Reflection(centres, sets)


def _centres(model: Mechanics, turned: Symbols) -> list[Expr]:
    """Candidates for twice the centre of the first coordinate: those that map the first line it
    moves to the mirror image of itself or of another line.
    """
    others = [symbol for symbol in model.coordinates if symbol not in turned]
    moved = []
    for line in model.lines:
        dx = line.dx.subs(dict.fromkeys(turned[1:], 0))
        slope = sp.diff(dx, turned[0])
        if slope != 0 and sp.diff(slope, turned[0]) == 0 and not dx.has(*others):
            moved.append((slope, dx.subs(turned[0], 0)))
    if not moved:
        return [S.Zero]
    slope, at_zero = moved[0]
    alike = [other for same, other in moved if expand(same - slope) == 0]
    return list(dict.fromkeys(expand(-(at_zero + other) / slope) for other in alike))


def _remainders(model: Mechanics, one: Reflection) -> list[Expr]:
    """Expressions in parameters that all vanish if the reflection is a symmetry of the forces."""
    images = {symbol: one.image(symbol) for symbol in model.coordinates}
    changes: dict[Expr, Expr] = dict(images)
    for line in model.lines:
        image_of = next((other for other in (line, *model.lines) if one.takes(line, other)), None)
        if image_of is not None:
            changes |= {line.c: -image_of.c, line.s: image_of.s, line.l: image_of.l}
        else:
            # Nothing is known of the direction and length of this line's image.
            others = sp.symbols(f"{line.c}_image {line.s}_image {line.l}_image", real=True)
            changes |= dict(zip((line.c, line.s, line.l), others, strict=True))
    for torsion in model.torsions:
        # φ is odd for a line that is mapped to itself and upright at rest; else its image is
        # unknown.
        odd = one.takes(torsion.line, torsion.line) and torsion.cosine_of_rest == 0
        image = Symbol(f"{torsion.phi}_image", real=True)
        changes[torsion.phi] = -torsion.phi if odd else image
    rows = []
    gaps = [contact.gap for contact in model.contacts if contact.gap is not None]
    if any(expand(gap.subs(images, simultaneous=True) - gap) != 0 for gap in gaps):
        return [S.One]
    for symbol, row in zip(model.coordinates, model.residuals, strict=True):
        image = row.subs(changes, simultaneous=True)
        rows.append(image + row if symbol in one.centres else image - row)
    return _coefficients(model, rows)


def _coefficients(model: Mechanics, terms: list[Expr]) -> list[Expr]:
    """The coefficients of terms, as expressions in parameters: all vanish if the terms vanish for
    every state.
    """
    moving = {part for term in terms for part in term.free_symbols}
    moving -= {*model.arguments, *model.coefficients}
    found: dict[tuple[int, Expr], Expr] = {}
    for place, term in enumerate(map(expanded, terms)):
        for part in sp.Add.make_args(term):
            factor, rest = part.as_independent(*moving, as_Add=False)
            found[place, rest] = found.get((place, rest), S.Zero) + factor
    return [term for term in found.values() if expanded(term) != 0]


def _zero(model: Mechanics, remainders: list[Expr]) -> tuple[tuple[str, ...], ...]:
    """The smallest sets of parameters with which all remainders vanish if the parameters are 0.

    Sets of up to four parameters are tried; only parameters whose domain includes 0.
    """
    used = {part for term in remainders for part in term.free_symbols}
    allowed = [
        symbol
        for symbol in (*map(number, model.parameters), *model.coefficients)
        if not symbol.is_positive and used & set(model.parts(symbol))
    ]
    for size in range(min(4, len(allowed)) + 1):
        found = [
            tuple(map(str, chosen))
            for chosen in itertools.combinations(allowed, size)
            if all(expand(term.subs(_at_zero(model, chosen))) == 0 for term in remainders)
        ]
        if found:
            return tuple(found)
    return ()


def _at_zero(model: Mechanics, zeros: Symbols) -> dict[Symbol, int]:
    """The values of arguments if parameters are 0: an angle has the cosine 1."""
    values: dict[Symbol, int] = {}
    for symbol in zeros:
        parts = model.parts(symbol)
        values |= dict.fromkeys(parts, 0) | ({parts[-2]: 1} if len(parts) > 1 else {})
    return values


# ------------------------------------------------------------------------------------------------
# exchanges


@dataclass(frozen=True)
class Exchange:
    """A symmetry that exchanges coordinates or contacts.

    Coordinate i is mapped to ``signs[i]`` times coordinate ``places[i]``, contact k to contact
    ``contacts[k]``. It is a symmetry if the equations of one set in ``where`` hold, each between a
    parameter and a number or another parameter.
    """

    places: tuple[int, ...]
    signs: tuple[int, ...]
    contacts: tuple[int, ...]
    where: tuple[tuple[tuple[str, str | float], ...], ...]


def exchanges(model: Mechanics) -> tuple[Exchange, ...]:
    """All exchanges, those with the fewest equations first, without reflections of the coordinates
    to themselves.
    """
    found = [
        Exchange(places, signs, contacts, where)
        for places, signs in _involutions(model)
        for contacts in _contact_images(model, places, signs)
        if min(signs) < 0 or places != tuple(range(len(places)))
        if (places, contacts) != (tuple(range(len(places))), tuple(range(len(contacts))))
        if (where := _equations(model, _exchanged(model, places, signs, contacts)))
    ]
    # For each map of the coordinates the exchange with the fewest equations.
    least = dict[tuple[tuple[int, ...], tuple[int, ...]], Exchange]()
    for one in sorted(found, key=lambda one: len(one.where[0])):
        least.setdefault((one.places, one.signs), one)
    return tuple(least.values())


def _involutions(model: Mechanics) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Signed permutations of the coordinates that are their own inverse.

    They exchange coordinates of the same unit, and map a clock to itself.
    """
    units, n = [it.unit for it in model.page.coordinates], len(model.coordinates)
    for places in itertools.permutations(range(n)):
        if any(places[places[k]] != k or units[places[k]] != units[k] for k in range(n)):
            continue
        for signs in itertools.product((1, -1), repeat=n):
            clocks = [k for k, it in enumerate(model.coordinates) if it == model.clock]
            if all(signs[k] == signs[places[k]] for k in range(n)) and all(
                places[k] == k and signs[k] == 1 for k in clocks
            ):
                yield places, signs


def _images(model: Mechanics, places: Sequence[int], signs: Sequence[int]) -> dict[Expr, Expr]:
    """The images of the coordinates under a signed permutation."""
    moved = model.coordinates
    return {moved[k]: signs[k] * moved[place] for k, place in enumerate(places)}


def _contact_images(
    model: Mechanics, places: Sequence[int], signs: Sequence[int]
) -> Iterator[tuple[int, ...]]:
    """Permutations of the contacts, their own inverse, that agree with the coordinates' images."""
    images, contacts = _images(model, places, signs), model.contacts
    displacement_of = {it.name: it.along for it in model.frictions if it.along is not None}

    def fits(one: NormalForce, other: NormalForce) -> bool:
        # The displacement at a contact is mapped to that at its image, or to its negative.
        along, along_image = (sp.sympify(displacement_of.get(it.name, 0)) for it in (one, other))
        mapped = along.subs(images, simultaneous=True)
        if all(expanded(mapped - sign * along_image) != 0 for sign in (1, -1)):
            return False
        if (one.gap is None) != (other.gap is None) or one.unilateral != other.unilateral:
            return False
        image = S.Zero if one.gap is None else one.gap.subs(images, simultaneous=True)
        return one.either_face == other.either_face and expanded(image - (other.gap or 0)) == 0

    for order in itertools.permutations(range(len(contacts))):
        if all(order[order[k]] == k for k in order) and all(
            fits(contacts[k], contacts[other]) for k, other in enumerate(order)
        ):
            yield order


def _exchanged(
    model: Mechanics, places: Sequence[int], signs: Sequence[int], contacts: Sequence[int]
) -> list[Expr]:
    """Expressions that all vanish if the exchange is a symmetry of the forces; 1 if it is none."""
    images = _images(model, places, signs)
    changes = dict(images)
    for line in model.lines:
        same = next(
            (
                (other, *ways)
                for other in (line, *model.lines)
                for ways in itertools.product((1, -1), repeat=2)
                if _lies(line, images, other, ways)
            ),
            None,
        )
        if same is None:
            return [S.One]
        line_image, sign_x, sign_y = same
        changes |= {
            line.c: sign_x * line_image.c,
            line.s: sign_y * line_image.s,
            line.l: line_image.l,
        }
    if model.torsions:
        return [S.One]
    terms = list[Expr]()
    by_contact = {model.contacts.index(it.normal): it for it in model.frictions}
    for k, other in enumerate(contacts):
        one, image = model.contacts[k], model.contacts[other]
        changes |= {one.depth: image.depth, one.pushing: image.pushing}
        if (k in by_contact) != (other in by_contact):
            return [S.One]
        if k in by_contact:
            friction, friction_image = by_contact[k], by_contact[other]
            changes[friction.mu] = friction_image.mu
            for name in ("ahead", "behind", "belt", "at_rest", "holds"):
                value, image_value = getattr(friction, name), getattr(friction_image, name)
                terms.append(sp.sympify(value or 0) - sp.sympify(image_value or 0))
    for k, row in enumerate(model.residuals):
        moved_row = row.subs(changes, simultaneous=True)
        terms.append(moved_row - signs[k] * model.residuals[places[k]])
    return _coefficients(model, terms)


def _equations(
    model: Mechanics, terms: list[Expr]
) -> tuple[tuple[tuple[str, str | float], ...], ...]:
    """The smallest sets of equations between parameters with which all terms vanish."""
    most_equations = 4
    open_: list[tuple[tuple[tuple[Symbol, Expr], ...], list[Expr]]] = [((), terms)]
    for _ in range(most_equations + 1):
        done = {frozenset(said) for said, left in open_ if not left}
        if done:
            sets = sorted((sorted(map(_plain, said), key=str) for said in done), key=str)
            return tuple(map(tuple, sets))
        open_ = [
            ((*said, one), [it for term in left if (it := expanded(term.subs(*one))) != 0])
            for said, left in open_
            for one in _solutions(model, left[0])
        ]
    return ()


def _plain(equation: tuple[Symbol, Expr]) -> tuple[str, str | float]:
    """An equation as data."""
    symbol, value = equation
    return str(symbol), float(value) if value.is_number else str(value)


def _solutions(model: Mechanics, term: Expr) -> Iterator[tuple[Symbol, Expr]]:
    """Equations with which a factor of a term vanishes: a parameter and its value, which is 0, a
    positive number or another parameter.
    """
    numbers = {number(datum) for datum in model.parameters}
    factors = factor_list(term)[1] if term.is_polynomial(*term.free_symbols) else ()
    for factor, _ in factors:
        # A friction coefficient follows from parameters, so that it can be equal to numbers only.
        for symbol in sorted(factor.free_symbols & {*numbers, *model.coefficients}, key=str):
            value = expanded(symbol - factor / factor.diff(symbol))
            if (value in numbers and symbol in numbers) or (
                value.is_number and (value > 0 or (value == 0 and not symbol.is_positive))
            ):
                yield symbol, value
                break
