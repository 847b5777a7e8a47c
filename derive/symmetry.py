"""Symmetries of a model: its mirror, and turns of angles after which everything is as before.

The mirror of a model: coordinates whose reflection in a centre reflects all forces too, where
certain parameters are 0.

The article's model without friction and without a spring along the belt is one: with x′ = 2 cos θ₀
− x every spring is mirrored. There equilibria do not meet at folds but at pitchforks, which no
perturbation of one parameter shows.
"""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, S, Symbol, expand

from .algebra import Symbols, expanded
from .mechanics import Line, Mechanics, NormalForce, number


def whole_turns(model: Mechanics) -> dict[int, dict[int, int]]:
    """Turns after which all forces, lines and gaps are as before: by the place of an angle that
    makes one, the turns of each angle that moves, its own among them.

    Most angles turn alone. Links that are tied to each other turn together: where a spring holds
    the angle between two of them, both have to. No turn moves the angle of another one, and none
    moves an angle more than twice.
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
    """Whether all forces, lines and gaps are as before after so many turns of some coordinates, by
    their places.
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
    """Turned coordinates with the doubled centre of each, and the sets of parameters of which one
    has to be 0.
    """

    centres: Mapping[Symbol, Expr]
    zero: tuple[tuple[str, ...], ...]

    def takes(self, line: Line, other: Line) -> bool:
        """Whether a line lies after the mirror where the mirrored image of another one does; its
        own is upright on the mirror.
        """
        images = {symbol: self.image(symbol) for symbol in self.centres}
        return bool(self.centres) and _lies(line, images, other, (-1, 1))

    def image(self, symbol: Symbol) -> Expr:
        """Place where a mirror takes a coordinate."""
        return self.centres[symbol] - symbol if symbol in self.centres else symbol


def _lies(line: Line, images: Mapping[Symbol, Expr], other: Line, ways: Sequence[int]) -> bool:
    """Whether the image of a line lies where another one does, along the belt and across it in
    these ways.
    """
    dx, dy = (part.subs(images, simultaneous=True) for part in (line.dx, line.dy))
    return bool(expanded(dx - ways[0] * other.dx) == 0 == expanded(dy - ways[1] * other.dy))


def mirror(model: Mechanics) -> Reflection:
    """The mirror that asks for the fewest parameters to be 0; one that turns nothing if there is
    none.
    """
    sizes = range(1, len(model.coordinates) + 1)
    subsets = itertools.chain.from_iterable(
        itertools.combinations(model.coordinates, size) for size in sizes
    )
    found = [one for turned in subsets for one in _about(model, turned)]
    return min(
        found, key=lambda one: (len(one.zero[0]), len(one.centres)), default=Reflection({}, ())
    )


def _about(model: Mechanics, turned: Symbols) -> Iterator[Reflection]:
    """The mirrors of these coordinates: the first line that they move is upright at the centre, or
    another one's image there.
    """
    for centre in _centres(model, turned):
        centres = {**dict.fromkeys(turned, S.Zero), turned[0]: centre}
        sets = _zero(model, _remainders(model, Reflection(centres, ())))
        if sets:
            yield Reflection(centres, sets)


def _centres(model: Mechanics, turned: Symbols) -> list[Expr]:
    """Doubled centres of the first coordinate that put the first line that it moves in the mirrored
    place of itself or another.
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
    """Expressions in parameters that vanish where the forces follow."""
    images = {symbol: one.image(symbol) for symbol in model.coordinates}
    changes: dict[Expr, Expr] = dict(images)
    for line in model.lines:
        image_of = next((other for other in (line, *model.lines) if one.takes(line, other)), None)
        if image_of is not None:
            changes |= {line.c: -image_of.c, line.s: image_of.s, line.l: image_of.l}
        else:
            # A line that is not mirrored has another direction and length.
            others = sp.symbols(f"{line.c}_image {line.s}_image {line.l}_image", real=True)
            changes |= dict(zip((line.c, line.s, line.l), others, strict=True))
    for torsion in model.torsions:
        # A mirrored line that is at rest upright is turned the other way; of another nothing is
        # known.
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
    """Expressions in parameters and friction coefficients that stand before what moves: all of them
    vanish where the terms do.
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
    """The smallest sets of parameters that may be 0 and make all of them vanish."""
    used = {part for term in remainders for part in term.free_symbols}
    allowed = [
        symbol
        for symbol in (*map(number, model.parameters), *model.coefficients)
        if not symbol.is_positive and used & set(model.parts(symbol))
    ]
    # Most parameters that have to be 0.
    for size in range(min(4, len(allowed)) + 1):
        found = [
            tuple(map(str, chosen))
            for chosen in itertools.combinations(allowed, size)
            if all(expand(term.subs(_at_zero(model, chosen))) == 0 for term in remainders)
        ]
        if found:
            return tuple(found)
    return ()


def _at_zero(model: Mechanics, chosen: Symbols) -> dict[Symbol, int]:
    values: dict[Symbol, int] = {}
    for symbol in chosen:
        parts = model.parts(symbol)
        values |= dict.fromkeys(parts, 0) | ({parts[-2]: 1} if len(parts) > 1 else {})
    return values


# ------------------------------------------------------------------------------------------------
# exchanges


@dataclass(frozen=True)
class Exchange:
    """A mirror that exchanges coordinates with each other, or contacts: coordinate i goes to
    ``signs[i]`` times that of number ``places[i]``, contact k to that of number ``contacts[k]``.

    ``where`` are sets of equations of parameters, each a parameter and a number or another one, of
    which one set has to hold.
    """

    places: tuple[int, ...]
    signs: tuple[int, ...]
    contacts: tuple[int, ...]
    where: tuple[tuple[tuple[str, str | float], ...], ...]


def exchanges(model: Mechanics) -> tuple[Exchange, ...]:
    """All of them, by the fewest equations that they ask for; but those that are mirrors of signs
    alone.
    """
    found = [
        Exchange(places, signs, contacts, where)
        for places, signs in _involutions(model)
        for contacts in _contact_images(model, places, signs)
        if min(signs) < 0 or places != tuple(range(len(places)))
        if (places, contacts) != (tuple(range(len(places))), tuple(range(len(contacts))))
        if (where := _equations(model, _exchanged(model, places, signs, contacts)))
    ]
    # One of each image of the coordinates: that which asks for the fewest equations.
    least = dict[tuple[tuple[int, ...], tuple[int, ...]], Exchange]()
    for one in sorted(found, key=lambda one: len(one.where[0])):
        least.setdefault((one.places, one.signs), one)
    return tuple(least.values())


def _involutions(model: Mechanics) -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    """Places and signs of coordinates that their images' images have again: pairs of one unit, and
    others alone; a clock stays.
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
    moved = model.coordinates
    return {moved[k]: signs[k] * moved[place] for k, place in enumerate(places)}


def _contact_images(
    model: Mechanics, places: Sequence[int], signs: Sequence[int]
) -> Iterator[tuple[int, ...]]:
    """Numbers of contacts that have the gap of another one's image, and its regimes."""
    images, contacts = _images(model, places, signs), model.contacts
    along = {it.name: it.along for it in model.frictions if it.along is not None}

    def fits(one: NormalForce, other: NormalForce) -> bool:
        # What friction opposes at a contact goes to that at its image, or to its negative.
        rubs, there = (sp.sympify(along.get(it.name, 0)) for it in (one, other))
        there_from = rubs.subs(images, simultaneous=True)
        if all(expanded(there_from - way * there) != 0 for way in (1, -1)):
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
    """Expressions that vanish where all forces follow; 1 where something is known not to."""
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
        there, across, up = same
        changes |= {line.c: across * there.c, line.s: up * there.s, line.l: there.l}
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
            rubs, rubbed = by_contact[k], by_contact[other]
            changes[rubs.mu] = rubbed.mu
            for name in ("ahead", "behind", "belt", "at_rest", "holds"):
                pair = [getattr(friction, name) for friction in (rubs, rubbed)]
                terms.append(sp.sympify(pair[0] or 0) - sp.sympify(pair[1] or 0))
    for k, row in enumerate(model.residuals):
        moved_row = row.subs(changes, simultaneous=True)
        terms.append(moved_row - signs[k] * model.residuals[places[k]])
    return _coefficients(model, terms)


def _equations(
    model: Mechanics, terms: list[Expr]
) -> tuple[tuple[tuple[str, str | float], ...], ...]:
    """The smallest sets of equations of parameters that make all of them vanish."""
    # Most equations that have to hold.
    most = 4
    open_: list[tuple[tuple[tuple[Symbol, Expr], ...], list[Expr]]] = [((), terms)]
    for _ in range(most + 1):
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
    symbol, value = equation
    return str(symbol), float(value) if value.is_number else str(value)


def _solutions(model: Mechanics, term: Expr) -> Iterator[tuple[Symbol, Expr]]:
    """Parameters that are 0, a number or another one where a factor of the term vanishes."""
    numbers = {number(datum) for datum in model.parameters}
    factors = sp.factor_list(term)[1] if term.is_polynomial(*term.free_symbols) else ()
    for factor, _ in factors:
        # A friction coefficient is 0 or not: it follows from parameters.
        for symbol in sorted(factor.free_symbols & {*numbers, *model.coefficients}, key=str):
            value = expanded(symbol - factor / factor.diff(symbol))
            if (value in numbers and symbol in numbers) or (
                value.is_number and (value > 0 or (value == 0 and not symbol.is_positive))
            ):
                yield symbol, value
                break
