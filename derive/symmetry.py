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
from sympy import Dummy, Expr, S, Symbol, expand

from .algebra import Symbols, expanded
from .factors import factor_list
from .mechanics import Mechanics, NormalForce, number


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

    images: Mapping[Symbol, Expr]  #: 2c − q by the reflected coordinate
    zero: tuple[tuple[str, ...], ...]  #: it is a symmetry if all parameters of one of these are 0
    upright: tuple[int, ...]  #: indices of the lines that are mapped to their own mirror images


def mirror(model: Mechanics) -> Reflection:
    """The reflection that needs the fewest parameters to be 0; one of no coordinates if there is no
    reflection.
    """
    found = [
        one
        for size in range(1, len(model.coordinates) + 1)
        for reflected in itertools.combinations(model.coordinates, size)
        for one in _reflections_of(model, reflected)
    ]
    return min(
        found, key=lambda one: (len(one.zero[0]), len(one.images)), default=Reflection({}, (), ())
    )


def _reflections_of(model: Mechanics, turned: Symbols) -> Iterator[Reflection]:
    """The reflections of just these coordinates, about each centre that is possible."""
    gaps = [contact.gap for contact in model.contacts if contact.gap is not None]
    signs = [-1 if symbol in turned else 1 for symbol in model.coordinates]
    for centre in _centres(model, turned):
        images = {symbol: -symbol for symbol in turned} | {turned[0]: centre - turned[0]}
        if any(expand(gap.subs(images, simultaneous=True) - gap) != 0 for gap in gaps):
            continue
        changes = images | _line_images(model, images, [(-1, 1)])
        upright = [line for line in model.lines if changes[line.c] == -line.c]
        for torsion in model.torsions:
            # φ is odd for a line that is mapped to itself and upright at rest; else its image is
            # unknown.
            odd = torsion.line in upright and torsion.cosine_of_rest == 0
            changes[torsion.phi] = -torsion.phi if odd else Dummy(real=True)
        sets = _zero(model, _remainders(model, changes, range(len(signs)), signs))
        if sets:
            yield Reflection(images, sets, tuple(map(model.lines.index, upright)))


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


def _line_images(
    model: Mechanics, images: Mapping[Symbol, Expr], signs: Sequence[Sequence[int]]
) -> dict[Symbol, Expr]:
    """Images of the directions and lengths of lines, of which one's vector (dx, dy) is mapped to
    that of the same or another line with one of these pairs of signs.

    Of any other line nothing is known: its images are new symbols.
    """
    found: dict[Symbol, Expr] = {}
    for line in model.lines:
        dx, dy = (part.subs(images, simultaneous=True) for part in (line.dx, line.dy))
        image = next(
            (
                (x * other.c, y * other.s, other.l)
                for other in (line, *model.lines)
                for x, y in signs
                if expanded(dx - x * other.dx) == 0 == expanded(dy - y * other.dy)
            ),
            sp.symbols("c s l", real=True, cls=Dummy),
        )
        found |= dict(zip((line.c, line.s, line.l), image, strict=True))
    return found


def _remainders(
    model: Mechanics,
    changes: Mapping[Symbol, Expr],
    places: Sequence[int],
    signs: Sequence[int],
    further: Sequence[Expr] = (),
) -> list[Expr]:
    """Expressions in parameters that all vanish if with these changes of symbols every row of the
    equilibrium becomes the one of its place, with its sign, and ``further`` terms vanish.
    """
    rows = zip(model.residuals, places, signs, strict=True)
    terms = [
        *further,
        *(
            row.subs(changes, simultaneous=True) - sign * model.residuals[place]
            for row, place, sign in rows
        ),
    ]
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
        for places, signs in _coordinate_maps(model)
        for contacts in _contact_maps(model, _images(model, places, signs))
        if [*places] != sorted(places) or (min(signs) < 0 and [*contacts] != sorted(contacts))
        if (where := _equations(model, _exchanged(model, places, signs, contacts)))
    ]
    # For each map of the coordinates the exchange with the fewest equations.
    least = dict[tuple[tuple[int, ...], tuple[int, ...]], Exchange]()
    for one in sorted(found, key=lambda one: len(one.where[0])):
        least.setdefault((one.places, one.signs), one)
    return tuple(least.values())


def _involutions(count: int) -> Iterator[tuple[int, ...]]:
    """Permutations that are their own inverse."""
    orders = itertools.permutations(range(count))
    return (order for order in orders if all(order[order[k]] == k for k in order))


def _coordinate_maps(model: Mechanics) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Signed permutations of the coordinates that are their own inverse.

    They exchange coordinates of the same unit, and map a clock to itself.
    """
    kinds = ["" if it.symbol == model.clock else it.unit for it in model.page.coordinates]
    for places in _involutions(len(kinds)):
        for signs in itertools.product(*((1, -1) if kind else (1,) for kind in kinds)):
            if all(
                (kinds[k], signs[k]) == (kinds[place], signs[place])
                for k, place in enumerate(places)
            ):
                yield places, signs


def _images(model: Mechanics, places: Sequence[int], signs: Sequence[int]) -> dict[Symbol, Expr]:
    """The images of the coordinates under a signed permutation."""
    moved = model.coordinates
    return {moved[k]: signs[k] * moved[place] for k, place in enumerate(places)}


def _contact_maps(model: Mechanics, images: Mapping[Symbol, Expr]) -> Iterator[tuple[int, ...]]:
    """Permutations of the contacts, their own inverse, that agree with the coordinates' images."""
    displacement_of = {it.name: it.along for it in model.frictions}

    def fits(one: NormalForce, other: NormalForce) -> bool:
        # The displacement at a contact is mapped to that at its image, or to its negative.
        along, along_image = (displacement_of.get(it.name, S.Zero) for it in (one, other))
        mapped = along.subs(images, simultaneous=True)
        kind, kind_of_image = (
            (it.gap is None, it.unilateral, it.either_face) for it in (one, other)
        )
        gap = (one.gap or S.Zero).subs(images, simultaneous=True)
        return (
            any(expanded(mapped - sign * along_image) == 0 for sign in (1, -1))
            and kind == kind_of_image
            and expanded(gap - (other.gap or 0)) == 0
        )

    for order in _involutions(len(model.contacts)):
        if all(fits(one, model.contacts[k]) for one, k in zip(model.contacts, order, strict=True)):
            yield order


def _exchanged(
    model: Mechanics, places: Sequence[int], signs: Sequence[int], contacts: Sequence[int]
) -> list[Expr]:
    """Expressions that all vanish if the exchange is a symmetry of the forces; 1 if it is none."""
    images = _images(model, places, signs)
    changes = images | _line_images(model, images, [*itertools.product((1, -1), repeat=2)])
    if model.torsions or any(image.has(Dummy) for image in changes.values()):
        return [S.One]
    terms = list[Expr]()
    by_contact = {model.contacts.index(it.normal): it for it in model.frictions}
    for k, other in enumerate(contacts):
        one, image = model.contacts[k], model.contacts[other]
        changes |= {one.depth: image.depth, one.pushing: image.pushing}
        friction, friction_image = by_contact.get(k), by_contact.get(other)
        if friction is None is friction_image:
            continue
        if friction is None or friction_image is None:
            return [S.One]
        changes[friction.mu] = friction_image.mu
        for name in ("ahead", "behind", "belt", "at_rest", "holds"):
            value, image_value = (getattr(it, name) or 0 for it in (friction, friction_image))
            terms.append(S(value - image_value))
    return _remainders(model, changes, places, signs, terms)


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
