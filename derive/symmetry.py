"""Symmetries of a model: its mirror, and turns of angles after which everything is as before.

The mirror of a model: coordinates whose reflection in a centre reflects all forces too, where
certain parameters are 0.

The article's model without friction and without a spring along the belt is one: with x′ = 2 cos θ₀
− x every spring is mirrored. There equilibria do not meet at folds but at pitchforks, which no
perturbation of one parameter shows.
"""

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from .algebra import Symbols
from .mechanics import Line, Mechanics, number


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
    return all(sp.expand(part.subs(moved, simultaneous=True) - part) == 0 for part in parts)


@dataclass(frozen=True)
class Mirror:
    """Turned coordinates with the doubled centre of each, and the sets of parameters of which one
    has to be 0.
    """

    centres: Mapping[sp.Symbol, sp.Expr]
    zero: tuple[tuple[str, ...], ...]

    def takes(self, line: Line, other: Line) -> bool:
        """Whether a line lies after the mirror where the mirrored image of another one does; its
        own is upright on the mirror.
        """
        image = [
            part.subs({symbol: self.image(symbol) for symbol in self.centres}, simultaneous=True)
            for part in (line.dx, line.dy)
        ]
        return (
            bool(self.centres)
            and sp.expand(image[0] + other.dx) == 0
            and sp.expand(image[1] - other.dy) == 0
        )

    def image(self, symbol: sp.Symbol) -> sp.Expr:
        """Place where a mirror takes a coordinate."""
        return self.centres[symbol] - symbol if symbol in self.centres else symbol


def mirror(model: Mechanics) -> Mirror:
    """The mirror that asks for the fewest parameters to be 0; one that turns nothing if there is
    none.
    """
    sizes = range(1, len(model.coordinates) + 1)
    subsets = itertools.chain.from_iterable(
        itertools.combinations(model.coordinates, size) for size in sizes
    )
    found = [one for turned in subsets for one in _about(model, turned)]
    return min(found, key=lambda one: (len(one.zero[0]), len(one.centres)), default=Mirror({}, ()))


def _about(model: Mechanics, turned: Symbols) -> Iterator[Mirror]:
    """The mirrors of these coordinates: the first line that they move is upright at the centre, or
    another one's image there.
    """
    for centre in _centres(model, turned):
        centres = {**dict.fromkeys(turned, sp.S.Zero), turned[0]: centre}
        sets = _zero(model, _remainders(model, Mirror(centres, ())))
        if sets:
            yield Mirror(centres, sets)


def _centres(model: Mechanics, turned: Symbols) -> list[sp.Expr]:
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
        return [sp.S.Zero]
    slope, at_zero = moved[0]
    alike = [other for same, other in moved if sp.expand(same - slope) == 0]
    return list(dict.fromkeys(sp.expand(-(at_zero + other) / slope) for other in alike))


def _remainders(model: Mechanics, one: Mirror) -> list[sp.Expr]:
    """Expressions in parameters that vanish where the forces follow."""
    images = {symbol: one.image(symbol) for symbol in model.coordinates}
    changes: dict[sp.Expr, sp.Expr] = dict(images)
    unknown: list[sp.Symbol] = []
    for line in model.lines:
        image_of = next((other for other in (line, *model.lines) if one.takes(line, other)), None)
        if image_of is not None:
            changes |= {line.c: -image_of.c, line.s: image_of.s, line.l: image_of.l}
        else:
            # A line that is not mirrored has another direction and length.
            others = sp.symbols(f"{line.c}_image {line.s}_image {line.l}_image", real=True)
            unknown += others
            changes |= dict(zip((line.c, line.s, line.l), others, strict=True))
    unknown += model.turned
    for torsion in model.torsions:
        # A mirrored line that is at rest upright is turned the other way; of another nothing is
        # known.
        odd = one.takes(torsion.line, torsion.line) and torsion.cosine_of_rest == 0
        image = sp.Symbol(f"{torsion.phi}_image", real=True)
        changes[torsion.phi] = -torsion.phi if odd else image
        unknown += [] if odd else [image]
    rows = []
    gaps = [contact.gap for contact in model.contacts if contact.gap is not None]
    if any(sp.expand(gap.subs(images, simultaneous=True) - gap) != 0 for gap in gaps):
        return [sp.S.One]
    for symbol, row in zip(model.coordinates, model.residuals, strict=True):
        image = row.subs(changes, simultaneous=True)
        rows.append(image + row if symbol in one.centres else image - row)
    symbols = (
        *model.coordinates,
        *model.directions,
        *unknown,
        *(1 / line.l for line in model.lines),
        *model.depths,
    )
    generators = [symbol for symbol in symbols if any(row.has(symbol) for row in rows)]
    out = []
    for row in rows:
        collected = sp.collect(sp.expand(row), generators, evaluate=False)
        out += [term for term in collected.values() if term != 0]
    return out


def _zero(model: Mechanics, remainders: list[sp.Expr]) -> tuple[tuple[str, ...], ...]:
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
            if all(sp.expand(term.subs(_at_zero(model, chosen))) == 0 for term in remainders)
        ]
        if found:
            return tuple(found)
    return ()


def _at_zero(model: Mechanics, chosen: Symbols) -> dict[sp.Symbol, int]:
    values: dict[sp.Symbol, int] = {}
    for symbol in chosen:
        parts = model.parts(symbol)
        values |= dict.fromkeys(parts, 0) | ({parts[-2]: 1} if len(parts) > 1 else {})
    return values
