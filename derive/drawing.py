"""The drawing of a page's mechanism, from its statements: ``python -m derive.drawing`` writes those
of all pages to ``docs/images``.

What a page says of one mass on a belt, with anchors that stand still or run along the belt, is
drawn; of any other mechanism the docstring's own drawing is shown. The mass stands in the middle.
What is tied along the direction of sliding goes to a wall on its left, what is tied across it to a
ceiling on its right; springs and dampers with two ends go where their ends are at the base values,
with θ₀ = 55°.
"""

import math
import textwrap
from pathlib import Path

import sympy as sp

from .algebra import Pair, Symbols
from . import pages
from .model import Coordinate, Element, Page, Point
from .shapes import Axis, Place, Sheet, arrow, damper, spring, wall

#: Where the documentation has them.
IMAGES = Path(__file__).parent.parent / "docs" / "images" / "models"

_MASS = 48.0, 30.0  #: half its width and half its height
_BALL = 32.0
_CONTACT = 34.0  #: between the mass and the belt
_LENGTH = 190.0  #: of an inclined spring of undeformed length 1
_WALL = -190.0
_CEILING = -118.0
_INCLINATION = math.radians(55.0)


def render(page: Page, docstring: str = "") -> str:
    """The SVG file of a page: its mechanism where that is one that can be drawn, else the drawing
    in its docstring.
    """
    sheet = Sheet()
    if not is_drawn(page):
        for row, line in enumerate(typed(docstring) or [page.summary]):
            sheet.typed(line, row)
        return sheet.svg(page.summary)
    names = list(map(str, page.places))
    if page.normal is not None or page.sliding is not None:
        _belt(sheet, page)
    for it in page.coordinates[:2]:
        _tied_to_ground(sheet, page, it)
    _between_ends(sheet, page)
    _leaning(sheet, page)
    _body(sheet, page)
    _forces(sheet, page)
    _axes(sheet, names[: 2 if page.normal is not None and page.normal.gap is not None else 1])
    return sheet.svg(page.summary)


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
    """Whether every statement of the page is one of a mass on a belt, which is what can be
    drawn.
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
    cars = {
        symbol
        for both in ends
        for end in both
        for symbol in symbols[2:]
        if symbol in end[0].free_symbols
    }
    return (
        across
        and (page.normal is None or gap in (None, *symbols[1:2]))
        and (page.sliding is None or page.sliding.along == x)
        and set(symbols[2:]) == cars
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
    """A point that stands still, or runs along the belt with one of the further coordinates."""
    moving = end[0].free_symbols & set(symbols)
    return not end[1].free_symbols & set(symbols) and (
        not moving
        or (len(moving) == 1 and not moving & set(symbols[:2]) and sp.diff(end[0], *moving) == 1)
    )


def _has_one_mass(page: Page) -> bool:
    """Whether the first two coordinates are those of one mass, and the others have masses of their
    own.
    """
    if page.inertia is None:
        return True
    M = sp.hessian(page.inertia[0], page.rates)
    return bool(
        M.is_diagonal()
        and not M.has(*page.places)
        and M[0, 0] == M[min(1, M.rows - 1), min(1, M.rows - 1)]
    )


def _values(page: Page) -> dict[sp.Symbol, float]:
    """Base values, 1 for units of measure, and the mass at its origin."""
    values = {
        datum.symbol: _INCLINATION if datum.base is None else datum.base
        for datum in page.parameters
    }
    return values | {datum.symbol: 1.0 for datum in page.units} | dict.fromkeys(page.places, 0.0)


def _letter(expression: sp.Expr) -> str:
    """The symbols of a coefficient: a mass first, then by their names."""
    return " ".join(sorted(map(str, expression.free_symbols), key=lambda name: (name != "m", name)))


def _along(page: Page, coordinate: Coordinate) -> list[Element]:
    """What ties a coordinate to the ground."""
    return [it for it in page.elements if it.along == coordinate.symbol]


def _draw(sheet: Sheet, part: Element, axis: Axis, beside: Place, anchor: str = "middle") -> None:
    """A spring or a damper, with its letter."""
    (damper if part.what == "damper" else spring)(sheet, axis)
    sheet.name(_letter(part.strength), beside, anchor=anchor)


# ------------------------------------------------------------------------------------------------
# mass and belt


def _half(page: Page) -> Place:
    return (_BALL, _BALL) if _is_ball(page) else _MASS


def _is_ball(page: Page) -> bool:
    """Whether the contact law is that of a curved body: a power of the penetration that is not
    whole.
    """
    if page.normal is None or page.normal.gap is None:
        return False
    depth = sp.Dummy(positive=True)
    return not sp.sympify(page.normal.law(depth)).is_polynomial(depth)


def _body(sheet: Sheet, page: Page) -> None:
    width, height = _half(page)
    if _is_ball(page):
        sheet.circle((0.0, 0.0), width, style="ink body")
    else:
        sheet.line(
            (-width, -height),
            (width, -height),
            (width, height),
            (-width, height),
            style="ink body",
            closed=True,
        )
    sheet.name(
        "m"
        if page.inertia is None
        else _letter(sp.diff(page.inertia[0], page.coordinates[0].rate, 2)),
        (0.0, 7.0),
    )


def _belt(sheet: Sheet, page: Page) -> None:
    """Belt and rollers, with the contact between them and the mass."""
    height = _half(page)[1]
    elastic = page.normal is not None and page.normal.gap is not None
    top = height + (_CONTACT if elastic else 0.0)
    left, right = -130.0, 150.0
    sheet.line(
        (left, top),
        (right, top),
        (right, top + 14),
        (left, top + 14),
        style="ink belt",
        closed=True,
    )
    if page.sliding is not None:
        arrow(sheet, (60.0, top + 34), (140.0, top + 34))
        sheet.name(_letter(page.sliding.belt), (152.0, top + 40), anchor="start")
    if page.normal is None or not elastic:
        return
    for x in (-16.0, 16.0):
        spring(sheet, Axis((x, height), (x, top - 3)), turns=3, width=6.0)
    sheet.line((-26.0, top - 3), (26.0, top - 3))
    depth = sp.Dummy(positive=True)
    law = sp.sympify(page.normal.law(depth))
    terms = sorted(
        sp.Add.make_args(sp.expand(law)),
        key=lambda term: sp.degree(term, depth) if term.is_polynomial(depth) else 0,
    )
    letters = ", ".join(_letter(term.subs(depth, 1)) for term in terms)
    sheet.name(letters, (-34.0, height + 0.5 * _CONTACT + 7), anchor="end")


# ------------------------------------------------------------------------------------------------
# springs and dampers


def _tied_to_ground(sheet: Sheet, page: Page, coordinate: Coordinate) -> None:
    """What is along a coordinate of the mass: to the wall or to the ceiling. A trolley's is drawn
    with the trolley.
    """
    parts, (width, _) = _along(page, coordinate), _half(page)
    if not parts:
        return
    if coordinate == page.coordinates[0]:
        rows = _rows(len(parts), 46.0)
        for part, y in zip(parts, rows, strict=True):
            _draw(sheet, part, Axis((_WALL, y), (-width, y)), (0.5 * (_WALL - width), y - 17))
        wall(sheet, (_WALL, 0.0), 18.0 + 0.5 * (rows[-1] - rows[0]), (-1.0, 0.0))
        return
    rows = _rows(len(parts), 40.0)
    arm = width + 78.0 + rows[-1]
    sheet.line((width, 0.0), (arm + rows[-1], 0.0))
    for part, x in zip(parts, rows, strict=True):
        beside = arm + x + (-14 if x < 0 else 14), 0.5 * _CEILING + 6
        _draw(
            sheet,
            part,
            Axis((arm + x, 0.0), (arm + x, _CEILING)),
            beside,
            "end" if x < 0 else "start",
        )
    wall(sheet, (arm, _CEILING), 18.0 + 0.5 * (rows[-1] - rows[0]), (0.0, -1.0))


def _rows(count: int, apart: float) -> list[float]:
    return [apart * (place - 0.5 * (count - 1)) for place in range(count)]


def _between_ends(sheet: Sheet, page: Page) -> None:
    """Springs and dampers from the mass to an anchor; those with the same anchor side by side."""
    values, height = _values(page), _half(page)[1]

    def anchor(part: Element) -> Point:
        return next(end for end in part.ends or () if set(end) != set(page.places[:2]))

    def place_of(part: Element) -> Place:
        x, y = (float(component.subs(values)) for component in anchor(part))
        return _LENGTH * x, -_LENGTH * y - height

    shared: dict[Place, list[Element]] = {}
    for part in (it for it in (*page.springs, *page.dampers) if it.ends is not None):
        shared.setdefault(place_of(part), []).append(part)
    for count, (place, parts) in enumerate(shared.items()):
        axis = Axis((0.0, -height), place)
        _side_by_side(sheet, axis, parts)
        moving = [it for it in page.coordinates[2:] if anchor(parts[0])[0].has(it.symbol)]
        if moving:
            _trolley(sheet, page, place, moving[0])
        else:
            _anchor(sheet, place)
        for torsion in page.torsions:
            if place_of(torsion) == place:
                _turning(sheet, place, _letter(torsion.strength))
        if count == 0:
            _angle(sheet, axis)


def _anchor(sheet: Sheet, place: Place) -> None:
    sheet.circle(place, 5.0)
    wall(sheet, (place[0], place[1] - 8), 16.0, (0.0, -1.0))


def _turning(sheet: Sheet, place: Place, letter: str) -> None:
    """A torsion spring at an anchor: two arcs around it, and its letter."""
    for radius in (11.0, 17.0):
        angles = (math.radians(10.0 * turn) for turn in range(17))
        sheet.line(
            *(
                (place[0] + radius * math.cos(it), place[1] + radius * math.sin(it))
                for it in angles
            ),
            style="ink thin",
        )
    sheet.name(letter, (place[0] + 24, place[1] + 12), anchor="start")


def _side_by_side(sheet: Sheet, axis: Axis, parts: list[Element]) -> None:
    """Parts between the same two ends, joined by bars if there are several."""
    rows = _rows(len(parts), 28.0)
    inner = axis
    if len(parts) > 1:
        inner = Axis(axis.at(0.14 * axis.length), axis.at(0.88 * axis.length))
        for outer, bar in ((axis.start, 0.0), (axis.end, inner.length)):
            sheet.line(outer, inner.at(bar))
            sheet.line(inner.at(bar, rows[0]), inner.at(bar, rows[-1]))
    for part, aside in zip(parts, rows, strict=True):
        x, y = inner.at(0.6 * inner.length, aside - 18 if aside <= 0 else aside + 18)
        _draw(sheet, part, inner.shifted(aside), (x, y + 6), "end" if aside <= 0 else "start")


def _angle(sheet: Sheet, axis: Axis) -> None:
    (x, y), end = axis.start, axis.end
    angle = math.atan2(y - end[1], end[0] - x)
    sheet.line((x, y), (x + 62, y), style="ink thin dash")
    sheet.arc((x, y), 46.0, angle)
    sheet.name("theta", (x + 60 * math.cos(0.4 * angle), y - 60 * math.sin(0.4 * angle) + 6))


def _trolley(sheet: Sheet, page: Page, place: Place, coordinate: Coordinate) -> None:
    """An anchor that moves along the belt: a car on a rail, with what ties it to the ground."""
    x, y = place
    sheet.line(
        (x - 24, y - 12),
        (x + 24, y - 12),
        (x + 24, y + 4),
        (x - 24, y + 4),
        style="ink body",
        closed=True,
    )
    for wheel in (-14.0, 14.0):
        sheet.circle((x + wheel, y - 17), 5.0)
    sheet.line((x - 60, y - 23), (x + 70, y - 23))
    arrow(sheet, (x + 34, y - 4), (x + 70, y - 4))
    sheet.name(str(coordinate.symbol), (x + 76, y + 2), anchor="start")
    for part in _along(page, coordinate):
        end = x - 150.0
        _draw(sheet, part, Axis((end, y - 4), (x - 24, y - 4)), (0.5 * (end + x - 24), y + 24))
        wall(sheet, (end, y - 4), 18.0, (-1.0, 0.0))


def _slopes(page: Page, energy: sp.Expr) -> list[sp.Expr]:
    """Slopes of a potential along the coordinates; none where it does not act on a mass in the
    plane.
    """
    slopes = [sp.diff(energy, symbol) for symbol in page.places]
    return [] if len(slopes) < 2 or slopes[:2] == [0, 0] else slopes


def _weight(page: Page, energy: sp.Expr) -> Pair | None:
    """The force on the mass of a potential that is linear in the coordinates, as gravity's is: no
    spring, but an arrow.
    """
    slopes = _slopes(page, energy)
    if not slopes or any(slope.has(*page.places) for slope in slopes):
        return None
    return -slopes[0], -slopes[1]


def _ratio(page: Page, energy: sp.Expr) -> sp.Expr | None:
    """∂/∂y over ∂/∂x of a potential that depends on one combination of x and y."""
    slopes = _slopes(page, energy)
    if not slopes or any(slopes[2:]):
        return None
    ratio = sp.simplify(slopes[1] / slopes[0]) if slopes[0] != 0 else sp.oo  # across the belt alone
    return ratio if ratio.is_number else None


def _leaning(sheet: Sheet, page: Page) -> None:
    """A potential that depends on one combination of x and y: a spring along it that keeps its
    direction.
    """
    for energy, _ in page.energies:
        ratio = _ratio(page, energy)
        if ratio is None or _weight(page, energy):
            continue
        along = math.atan2(float(ratio), 1.0)
        along += math.pi * (math.sin(along) < 0)  # upwards
        start = 0.0, -_half(page)[1]
        axis = Axis(
            start,
            (
                start[0] + 0.7 * _LENGTH * math.cos(along),
                start[1] - 0.7 * _LENGTH * math.sin(along),
            ),
        )
        spring(sheet, axis)
        x, y = axis.at(0.5 * axis.length, -26.0)
        letter = _letter(
            energy.subs({symbol: index + 1 for index, symbol in enumerate(page.places[:2])})
        )
        sheet.name(letter, (x, y), anchor="end")
        _anchor(sheet, axis.end)


# ------------------------------------------------------------------------------------------------
# forces and axes


def _forces(sheet: Sheet, page: Page) -> None:
    """Applied forces as arrows towards the mass or away from it, each with its symbols but those of
    its direction.
    """
    values = _values(page)
    width, height = _half(page)
    given = [force.components for force in page.forces if len(force.place) == 2]
    given += [force for energy, _ in page.energies if (force := _weight(page, energy))]
    if page.normal is not None and page.normal.gap is None:
        given.append((sp.S.Zero, -sp.sympify(page.normal.law(sp.Dummy(positive=True)))))
    for place, components in enumerate(given):
        x, y = (float(component.subs(values)) for component in components)
        size = math.hypot(x, y) or 1.0
        bare = sp.Add(*components).replace(
            lambda node: isinstance(node, sp.sin | sp.cos), lambda node: sp.S.One
        )
        letter = _letter(bare)
        across = (x / size, -y / size)
        if place == 0:  # onto the mass, on the side that no spring leans to
            side = 1.0 if any(not _weight(page, energy) for energy, _ in page.energies) else -1.0
            end = (
                side * 0.92 * width,
                -height - 4,
            )  # near the edge, beside a second spring that leans to it
            start = end[0] - 52 * across[0], end[1] - 52 * across[1]
            beside = start[0] + side * 8, start[1] + 16
        else:
            side, start = 1.0, (0.85 * width, 0.0)
            end = start[0] + 56 * across[0], start[1] + 56 * across[1]
            beside = end[0] + 12, end[1] + 2
        arrow(sheet, start, end, style="ink force")
        sheet.name(letter, beside, anchor="end" if side < 0 else "start", style="force-name")


def _axes(sheet: Sheet, names: list[str]) -> None:
    """The coordinates of the mass, beside the belt."""
    x, y = -188.0, 108.0
    for name, (dx, dy) in zip(names, ((38.0, 0.0), (0.0, -38.0)), strict=False):
        arrow(sheet, (x, y), (x + dx, y + dy))
        sheet.name(name, (x + 1.25 * dx + 2, y + 1.25 * dy + (6 if dx else 0)))


def every_drawing() -> dict[str, str]:
    """The drawings of the shipped pages, by name."""
    models = {path.stem: pages.read(path) for path in pages.shipped()}
    return {name: render(model.page, model.docstring) for name, model in models.items()}


if __name__ == "__main__":
    for written, svg in every_drawing().items():
        (IMAGES / f"{written}.svg").write_text(svg, encoding="utf-8", newline="\n")
