"""The drawing of a page's mechanism, from its statements: ``python -m derive.drawing`` writes those
of all pages to ``docs/images``.

Drawn is one mass on a belt, with anchors that stand still or run along the belt; of any other
mechanism the docstring's own drawing is shown. The mass stands in the middle. Springs and dampers
along the belt go to a wall on its left, those across the belt to a ceiling on its right; those with
two ends lie where their ends are at the base values, with θ₀ = 55°.
"""

import cmath
import math
import textwrap
from pathlib import Path

import sympy as sp
from sympy import Dummy, Expr, S, diff

from .algebra import Pair, Symbols
from . import pages
from .model import Contact, Coordinate, Element, Page, Point
from .shapes import Axis, Drawing, arrow, damper, spring, wall


def render(page: Page, docstring: str = "") -> str:
    """The SVG file of a page: its mechanism where :func:`is_drawn`, else the drawing in its
    docstring.
    """
    drawing = Drawing()
    if not is_drawn(page):
        for row, line in enumerate(typed(docstring) or [page.summary]):
            drawing.typed(line, row)
        return drawing.svg(page.summary)
    names = list(map(str, page.places))
    if page.normal is not None or page.sliding is not None:
        _belt(drawing, page)
    for coordinate in page.coordinates[:2]:
        _tied_to_ground(drawing, page, coordinate)
    _between_ends(drawing, page)
    _inclined_potentials(drawing, page)
    _body(drawing, page)
    _forces(drawing, page)
    _speed_of_frame(drawing, page)
    _axes(drawing, names[: 2 if page.normal is not None and page.normal.gap is not None else 1])
    return drawing.svg(page.summary)


def typed(docstring: str) -> list[str]:
    """The lines of the drawing in a docstring: the block that follows ``::``, without its
    margin.
    """
    _, _, rest = docstring.partition("::\n")
    lines = rest.strip("\n").split("\n")
    end = next(
        (row for row, line in enumerate(lines) if line.strip() and not line.startswith(" ")),
        len(lines),
    )
    return textwrap.dedent("\n".join(lines[:end])).strip("\n").split("\n") if rest.strip() else []


def is_drawn(page: Page) -> bool:
    """Whether every statement of the page is one of a single mass on a belt, or of an anchor that
    runs along it.
    """
    if any(it.unit == "rad" for it in page.coordinates) or len(page.contacts) > 1:
        return False
    symbols = page.places
    x, mass = symbols[0], symbols[:2]
    ends = [it.ends for it in page.elements if it.ends is not None]
    points = [end for both in ends for end in both] + [force.place for force in page.forces]
    gap = None if page.normal is None else page.normal.gap
    uncoupled = all(_ratio(page, energy) in (0, sp.oo, None) for energy, _ in page.energies)
    across = (
        len(symbols) < 2 or gap == symbols[1] or (gap is None and (mass in points or uncoupled))
    )
    along_belt = sp.Tuple(*(end[0] for both in ends for end in both))
    return (
        across
        and gap in (None, *symbols[1:2])
        and (page.sliding is None or page.sliding.along == x)
        and set(symbols[2:]) <= along_belt.free_symbols
        and all(mass in both and _is_anchor(both[both[0] == mass], symbols) for both in ends)
        and all(it.along is None or it.along in symbols for it in page.elements)
        and all(
            len(force.place) == 2 and mass in (force.place, force.place[:1])
            for force in page.forces
        )
        and all(
            _weight(page, energy) or _ratio(page, energy) is not None for energy, _ in page.energies
        )
        and _has_one_mass(page)
    )


def _is_anchor(end: Point, symbols: Symbols) -> bool:
    """Whether a point stands still, or runs along the belt with one of the coordinates that are
    not the mass's.
    """
    moving = end[0].free_symbols & set(symbols)
    return not end[1].free_symbols & set(symbols) and (
        not moving
        or (len(moving) == 1 and not moving & set(symbols[:2]) and diff(end[0], *moving) == 1)
    )


def _has_one_mass(page: Page) -> bool:
    """Whether the first two coordinates are those of one mass, and the others have masses of their
    own.
    """
    M = sp.hessian(page.kinetic_energy[0], page.rates)
    return bool(M.is_diagonal() and not M.has(*page.places) and len({*M.diagonal()[:2]}) == 1)


def _values(page: Page) -> dict[sp.Symbol, float]:
    """Every symbol's value in the drawing: parameters at their base values, those without one, the
    inclinations, at 55°, units of measure at 1, coordinates at 0.
    """
    inclination = math.radians(55.0)
    values = {
        datum.symbol: inclination if datum.base is None else datum.base for datum in page.parameters
    }
    return values | {datum.symbol: 1.0 for datum in page.units} | dict.fromkeys(page.places, 0.0)


def _letter(expression: Expr) -> str:
    """Names of the symbols in a coefficient, a mass first and the others in alphabetical order."""
    return " ".join(sorted(map(str, expression.free_symbols), key=lambda name: (name != "m", name)))


def _along(page: Page, coordinate: Coordinate) -> list[Element]:
    """Springs and dampers from a coordinate to the ground."""
    return [it for it in page.elements if it.along == coordinate.symbol]


def _draw(
    drawing: Drawing, part: Element, axis: Axis, beside: complex, anchor: str = "middle"
) -> None:
    """A spring or a damper along an axis, its coefficient's letters at ``beside``."""
    (damper if part.what == "damper" else spring)(drawing, axis)
    drawing.name(_letter(part.strength), beside, anchor=anchor)


# ------------------------------------------------------------------------------------------------
# mass and belt


def _half(page: Page) -> complex:
    """Half the width and, as imaginary part, half the height of the mass."""
    return 32 + 32j if _is_ball(page) else 48 + 30j


def _is_ball(page: Page) -> bool:
    """Whether the contact law is no polynomial of the penetration, as Hertz's law of a ball, δ^3/2,
    is none.
    """
    if page.normal is None or page.normal.gap is None:
        return False
    depth = Dummy(positive=True)
    return not sp.sympify(page.normal.law(depth)).is_polynomial(depth)


def _body(drawing: Drawing, page: Page) -> None:
    half = _half(page)
    if _is_ball(page):
        drawing.circle(0, half.real, style="ink body")
    else:
        drawing.box(-half, half, style="ink body")
    rate = page.coordinates[0].rate
    drawing.name(_letter(diff(page.kinetic_energy[0], rate, 2)), 7j)


def _terms(contact: Contact) -> list[Expr]:
    """Terms of the contact law by rising powers of the penetration, each at a penetration of 1."""
    depth = Dummy(positive=True)
    terms = sp.Add.make_args(sp.expand(sp.sympify(contact.law(depth))))
    powers = {it: sp.degree(it, depth) if it.is_polynomial(depth) else 0 for it in terms}
    return [it.subs(depth, 1) for it in sorted(terms, key=powers.__getitem__)]


def _belt(drawing: Drawing, page: Page) -> None:
    """Belt and rollers, with the contact between them and the mass."""
    height = _half(page).imag
    elastic = page.normal is not None and page.normal.gap is not None
    # between the mass and the belt
    contact = 34.0
    top = height + (contact if elastic else 0.0)
    drawing.box(complex(-130, top), complex(150, top + 14), style="ink belt")
    if page.sliding is not None:
        arrow(drawing, complex(60, top + 34), complex(140, top + 34))
        drawing.name(_letter(page.sliding.belt), complex(152, top + 40), anchor="start")
    if page.normal is None or not elastic:
        return
    for x in (-16.0, 16.0):
        spring(drawing, Axis(complex(x, height), complex(x, top - 3)), turns=3, width=6.0)
    drawing.line(complex(-26, top - 3), complex(26, top - 3))
    letters = ", ".join(map(_letter, _terms(page.normal)))
    drawing.name(letters, complex(-34, height + 0.5 * contact + 7), anchor="end")


# ------------------------------------------------------------------------------------------------
# springs and dampers


def _tied_to_ground(drawing: Drawing, page: Page, coordinate: Coordinate) -> None:
    """Springs and dampers along one of the mass's two coordinates: to the wall along the first, to
    the ceiling along the second.
    """
    parts, width = _along(page, coordinate), _half(page).real
    if not parts:
        return
    if coordinate == page.coordinates[0]:
        rows = _rows(len(parts), 46.0)
        ground = -190.0
        for part, y in zip(parts, rows, strict=True):
            beside = complex(0.5 * (ground - width), y - 17)
            _draw(drawing, part, Axis(complex(ground, y), complex(-width, y)), beside)
        wall(drawing, ground, 18.0 + 0.5 * (rows[-1] - rows[0]), -1)
        return
    rows = _rows(len(parts), 40.0)
    arm = width + 78.0 + rows[-1]
    drawing.line(width, arm + rows[-1])
    ceiling = -118.0
    for part, x in zip(parts, rows, strict=True):
        position, way = arm + x, -1 if x < 0 else 1
        beside = complex(position + 14 * way, 0.5 * ceiling + 6)
        axis = Axis(position, complex(position, ceiling))
        _draw(drawing, part, axis, beside, "end" if x < 0 else "start")
    wall(drawing, complex(arm, ceiling), 18.0 + 0.5 * (rows[-1] - rows[0]), -1j)


def _rows(count: int, apart: float) -> list[float]:
    """Places of parts that lie side by side, about 0."""
    return [apart * (index - 0.5 * (count - 1)) for index in range(count)]


def _between_ends(drawing: Drawing, page: Page) -> None:
    """Springs and dampers from the mass to an anchor; those with the same anchor side by side."""
    values, top = _values(page), -1j * _half(page).imag

    def anchor(part: Element) -> Point:
        return next(end for end in part.ends or () if set(end) != set(page.places[:2]))

    def place_of(part: Element) -> complex:
        x, y = (float(component.subs(values)) for component in anchor(part))
        # An inclined spring of undeformed length 1 is 190 units of the drawing long.
        return 190.0 * complex(x, -y) + top

    shared: dict[complex, list[Element]] = {}
    for part in (it for it in (*page.springs, *page.dampers) if it.ends is not None):
        shared.setdefault(place_of(part), []).append(part)
    for index, (place, parts) in enumerate(shared.items()):
        axis = Axis(top, place)
        _side_by_side(drawing, axis, parts)
        moving = [it for it in page.coordinates[2:] if anchor(parts[0])[0].has(it.symbol)]
        if moving:
            _trolley(drawing, page, place, moving[0])
        else:
            _anchor(drawing, place)
        for torsion in page.torsions:
            if place_of(torsion) == place:
                _torsion_spring(drawing, place, _letter(torsion.strength))
        if index == 0:
            _inclination(drawing, axis)


def _anchor(drawing: Drawing, point: complex) -> None:
    drawing.circle(point, 5.0)
    wall(drawing, point - 8j, 16.0, -1j)


def _torsion_spring(drawing: Drawing, point: complex, letter: str) -> None:
    """Two arcs around an anchor, and the letter of the torsion spring there."""
    for radius in (11.0, 17.0):
        arc = (point + cmath.rect(radius, math.radians(10.0 * turn)) for turn in range(17))
        drawing.line(*arc, style="ink thin")
    drawing.name(letter, point + 24 + 12j, anchor="start")


def _side_by_side(drawing: Drawing, axis: Axis, parts: list[Element]) -> None:
    """Springs and dampers between the same two ends, joined by bars if there are several."""
    rows = _rows(len(parts), 28.0)
    inner = axis
    if len(parts) > 1:
        inner = Axis(axis.at(0.14 * axis.length), axis.at(0.88 * axis.length))
        for outer, bar in ((axis.start, 0.0), (axis.end, inner.length)):
            drawing.line(outer, inner.at(bar))
            drawing.line(inner.at(bar, rows[0]), inner.at(bar, rows[-1]))
    for part, aside in zip(parts, rows, strict=True):
        beside = inner.at(0.6 * inner.length, aside - 18 if aside <= 0 else aside + 18) + 6j
        _draw(drawing, part, inner.shifted(aside), beside, "end" if aside <= 0 else "start")


def _inclination(drawing: Drawing, axis: Axis) -> None:
    """The angle θ of an axis above the horizontal through its start."""
    start, angle = axis.start, -cmath.phase(axis.end - axis.start)
    drawing.line(start, start + 62, style="ink thin dash")
    drawing.arc(start, 46.0, angle)
    drawing.name("theta", start + cmath.rect(60, -0.4 * angle) + 6j)


def _trolley(drawing: Drawing, page: Page, point: complex, coordinate: Coordinate) -> None:
    """An anchor that moves along the belt: a car on a rail, with the springs and dampers that tie
    it to the ground.
    """
    drawing.box(point - 24 - 12j, point + 24 + 4j, style="ink body")
    for wheel in (-14, 14):
        drawing.circle(point + wheel - 17j, 5.0)
    drawing.line(point - 60 - 23j, point + 70 - 23j)
    arrow(drawing, point + 34 - 4j, point + 70 - 4j)
    drawing.name(str(coordinate.symbol), point + 76 + 2j, anchor="start")
    for part in _along(page, coordinate):
        end = point - 150 - 4j
        _draw(drawing, part, Axis(end, point - 24 - 4j), point - 87 + 24j)
        wall(drawing, end, 18.0, -1)


def _slopes(page: Page, energy: Expr) -> list[Expr]:
    """Derivatives of a potential by the coordinates; an empty list where those by x and y are 0, or
    there is no y.
    """
    slopes = [diff(energy, symbol) for symbol in page.places]
    return [] if len(slopes) < 2 or slopes[:2] == [0, 0] else slopes


def _weight(page: Page, energy: Expr) -> Pair | None:
    """The force on the mass, drawn as an arrow, of a potential that is linear in the coordinates,
    as gravity's is; None of any other potential.
    """
    slopes = _slopes(page, energy)
    if not slopes or any(slope.has(*page.places) for slope in slopes):
        return None
    return -slopes[0], -slopes[1]


def _ratio(page: Page, energy: Expr) -> Expr | None:
    """∂/∂y over ∂/∂x of a potential that depends on one linear combination of x and y, ∞ of one
    that depends on y alone; None of any other.
    """
    slopes = _slopes(page, energy)
    if not slopes or any(slopes[2:]):
        return None
    ratio = sp.simplify(slopes[1] / slopes[0]) if slopes[0] != 0 else sp.oo  # across the belt alone
    return ratio if ratio.is_number else None


def _inclined_potentials(drawing: Drawing, page: Page) -> None:
    """Every potential that depends on one linear combination of x and y, as a spring in the
    direction of its force.
    """
    for energy, _ in page.energies:
        ratio = _ratio(page, energy)
        if ratio is None or _weight(page, energy):
            continue
        along = math.atan2(float(ratio), 1.0)
        along += math.pi * (math.sin(along) < 0)  # upwards
        start = -1j * _half(page).imag
        axis = Axis(start, start + cmath.rect(133.0, -along))
        spring(drawing, axis)
        at = {symbol: index + 1 for index, symbol in enumerate(page.places[:2])}
        drawing.name(_letter(energy.subs(at)), axis.at(0.5 * axis.length, -26.0), anchor="end")
        _anchor(drawing, axis.end)


# ------------------------------------------------------------------------------------------------
# forces and axes


def _forces(drawing: Drawing, page: Page) -> None:
    """Applied forces as arrows, the first towards the mass and the others away from it, each with
    the symbols of its size; those inside sin and cos, of its direction, are left out.
    """
    values, half = _values(page), _half(page)
    given = [force.components for force in page.forces if len(force.place) == 2]
    given += [force for energy, _ in page.energies if (force := _weight(page, energy))]
    if page.normal is not None and page.normal.gap is None:
        given.append((S.Zero, -sp.sympify(page.normal.law(Dummy(positive=True)))))
    for index, components in enumerate(given):
        x, y = (float(component.subs(values)) for component in components)
        if x == y == 0:  # as that of a follower where nothing is displaced
            continue
        across = complex(x, -y) / math.hypot(x, y)
        bare = sp.Add(*components).replace(
            lambda node: isinstance(node, sp.sin | sp.cos), lambda node: S.One
        )
        if index == 0:  # onto the mass, on the side that no spring leans to
            side = 1.0 if any(not _weight(page, energy) for energy, _ in page.energies) else -1.0
            # near the edge, beside a second spring that leans to it
            end = complex(side * 0.92 * half.real, -half.imag - 4)
            start = end - 52 * across
            beside = start + side * 8 + 16j
        else:
            side, start = 1.0, complex(0.85 * half.real)
            end = start + 56 * across
            beside = end + 12 + 2j
        arrow(drawing, start, end, style="ink force")
        anchor = "end" if side < 0 else "start"
        drawing.name(_letter(bare), beside, anchor=anchor, style="force-name")


def _speed_of_frame(drawing: Drawing, page: Page) -> None:
    """An arc with an arrow and the symbol of the speed at which the frame turns, where the kinetic
    energy has terms linear in the rates: the symbols of these terms that no mass has.
    """
    energy, _ = page.kinetic_energy
    still = dict.fromkeys(page.rates, 0)
    slopes = sp.Tuple(*(diff(energy, rate).subs(still) for rate in page.rates))
    speeds = slopes.free_symbols - set(page.places)
    speeds -= sp.hessian(energy, page.rates).free_symbols
    if speeds:
        arc = [cmath.rect(72.0, -math.radians(angle)) for angle in range(20, 161, 10)]
        drawing.line(*arc, style="ink thin")
        arrow(drawing, arc[-2], arc[-1])
        drawing.name(", ".join(sorted(map(str, speeds))), arc[0] + 8 - 4j, anchor="start")


def _axes(drawing: Drawing, names: list[str]) -> None:
    """Arrows in the directions of the mass's coordinates, in the lower left corner."""
    start = -188 + 108j
    for name, way in zip(names, (38 + 0j, -38j), strict=False):
        arrow(drawing, start, start + way)
        drawing.name(name, start + 1.25 * way + 2 + (6j if way.real else 0))


def every_drawing() -> dict[str, str]:
    """The drawings of the shipped pages, by name."""
    models = {path.stem: pages.read(path) for path in pages.shipped()}
    return {name: render(model.page, model.docstring) for name, model in models.items()}


if __name__ == "__main__":
    for written, svg in every_drawing().items():
        images = Path(__file__).parent.parent / "docs" / "images" / "models"
        (images / f"{written}.svg").write_text(svg, encoding="utf-8", newline="\n")
