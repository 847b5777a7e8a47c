"""The parts of a drawn mechanism in SVG: springs, dampers, walls, arrows, names with indices.

A point of the plane is a complex number. Lengths are pixels, y runs down.
"""

from __future__ import annotations

import cmath
import math
import unicodedata
from dataclasses import dataclass, field
from xml.sax.saxutils import escape

#: Colours on a light page and on a dark one; the card behind the drawing makes it readable where
#: the page does not follow the browser.
STYLE = """
.card{fill:#fff}.ink{stroke:#24292f;fill:none;stroke-width:2;stroke-linecap:round;\
stroke-linejoin:round}
.thin{stroke-width:1}.body{fill:#dbe7f5}.belt{fill:#eceff2}.force{stroke:#b3261e}\
.dash{stroke-dasharray:4 4}
text{fill:#24292f;font:italic 20px 'STIX Two Text','Times New Roman',serif}\
.force-name{fill:#b3261e}.index{font-size:14px}
.typed{font:15px 'DejaVu Sans Mono',Menlo,Consolas,monospace}
@media(prefers-color-scheme:dark){.card{fill:#161b22}.ink{stroke:#e6edf3}.body{fill:#1f3a5c}\
.belt{fill:#2b323b}
.force{stroke:#ff8a80}text{fill:#e6edf3}.force-name{fill:#ff8a80}}
""".strip()


@dataclass
class Drawing:
    """SVG elements in the order in which they are drawn, and the points that the picture has to
    contain.
    """

    elements: list[str] = field(default_factory=list)
    places: list[complex] = field(default_factory=list)

    def line(self, *points: complex, style: str = "ink", closed: bool = False) -> None:
        """A line through points."""
        steps = "L".join(map(_pair, points))
        self.elements.append(f'<path class="{style}" d="M{steps}{"Z" if closed else ""}"/>')
        self.places += points

    def box(self, corner: complex, other: complex, style: str) -> None:
        """A rectangle between two corners."""
        across = complex(other.real, corner.imag), complex(corner.real, other.imag)
        self.line(corner, across[0], other, across[1], style=style, closed=True)

    def circle(self, centre: complex, radius: float, style: str = "ink") -> None:
        """A circle."""
        x, y = _number(centre.real), _number(centre.imag)
        self.elements.append(f'<circle class="{style}" cx="{x}" cy="{y}" r="{_number(radius)}"/>')
        self.places += [centre - radius * (1 + 1j), centre + radius * (1 + 1j)]

    def arc(self, centre: complex, radius: float, angle: float) -> None:
        """An arc from the horizontal, to the right of the centre, up to an angle above it."""
        ends = centre + radius, centre + cmath.rect(radius, -angle)
        size = _number(radius)
        sweep = f"{_pair(ends[0])}A{size} {size} 0 0 0 {_pair(ends[1])}"
        self.elements.append(f'<path class="ink thin" d="M{sweep}"/>')
        self.places += ends

    def name(self, text: str, point: complex, anchor: str = "middle", style: str = "") -> None:
        """Names of symbols, as ``theta_0`` or ``k1``: Greek letters for their English names,
        indices lowered.
        """
        words = []
        for word in text.split():
            stem, _, index = word.partition("_")
            if greek(stem) == stem:
                name = stem.rstrip("0123456789")
                stem, index = name, stem[len(name) :] + index
            lowered = (
                f'<tspan class="index" dy="5">{escape(index)}</tspan><tspan dy="-5">&#8203;</tspan>'
                if index
                else ""
            )
            words.append(escape(greek(stem)) + lowered)
        kind = f' class="{style}"' if style else ""
        at = f'x="{_number(point.real)}" y="{_number(point.imag)}"'
        self.elements.append(f'<text{kind} {at} text-anchor="{anchor}">{" ".join(words)}</text>')
        width = 11.0 * len(text.replace("_", ""))
        left = point - width * {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor]
        self.places += [left - 16j, left + width + 8j]

    def typed(self, text: str, row: int) -> None:
        """A line of a drawing that is typed in characters, stretched so that each keeps its column
        in any font.
        """
        width, baseline = 9.0 * len(text), 18.0j * row
        if text.strip():
            kept = escape(text).replace(" ", "\N{NO-BREAK SPACE}")
            size = f'y="{_number(baseline.imag)}" textLength="{_number(width)}"'
            self.elements.append(
                f'<text class="typed" x="0" {size} lengthAdjust="spacingAndGlyphs">{kept}</text>'
            )
        self.places += [baseline - 16j, baseline + width + 8j]

    def svg(self, title: str) -> str:
        """The text of the SVG file, as large as what is drawn."""
        across, down = ([getattr(it, part) for it in self.places] for part in ("real", "imag"))
        left, top = (math.floor(min(ends)) - 16 for ends in (across, down))
        width, height = math.ceil(max(across)) + 16 - left, math.ceil(max(down)) + 16 - top
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left} {top} {width} {height}" '
            f'width="{width}" height="{height}" role="img">\n'
            f"<title>{escape(title)}</title>\n<style>\n{STYLE}\n</style>\n"
            f'<rect class="card" x="{left}" y="{top}" width="{width}" height="{height}" rx="8"/>\n'
            + "\n".join(self.elements)
            + "\n</svg>\n"
        )


def greek(word: str) -> str:
    """The Greek letter of a name as "alpha"; any other word itself."""
    size = "SMALL" if word.islower() else "CAPITAL"
    letter = word.upper().replace("LAMBDA", "LAMDA").removesuffix("_")
    try:
        return unicodedata.lookup(f"GREEK {size} LETTER {letter}") if len(word) > 1 else word
    except KeyError:
        return word


def _number(value: float) -> str:
    return f"{round(value, 1) + 0.0:g}"


def _pair(point: complex) -> str:
    return f"{_number(point.real)} {_number(point.imag)}"


@dataclass(frozen=True)
class Axis:
    """A line from one place to another, beside which parts are drawn."""

    start: complex
    end: complex

    @property
    def length(self) -> float:
        """Distance of the ends."""
        return abs(self.end - self.start)

    def at(self, along: float, aside: float = 0.0) -> complex:
        """The point at a distance along the line and a distance to its right."""
        return self.start + complex(along, aside) * (self.end - self.start) / self.length

    def shifted(self, aside: float) -> Axis:
        """The parallel line at a distance to the right."""
        return Axis(self.at(0.0, aside), self.at(self.length, aside))


def spring(drawing: Drawing, axis: Axis, turns: int = 6, width: float = 8.0) -> None:
    """A zigzag with straight ends."""
    lead = 0.18 * axis.length
    step = (axis.length - 2 * lead) / (2 * turns)
    inner = [
        axis.at(lead + (index + 0.5) * step, width if index % 2 else -width)
        for index in range(2 * turns)
    ]
    drawing.line(axis.start, axis.at(lead), *inner, axis.at(axis.length - lead), axis.end)


def damper(drawing: Drawing, axis: Axis, width: float = 7.0) -> None:
    """A piston in a cup."""
    middle = 0.5 * axis.length
    drawing.line(axis.start, axis.at(middle + 5))
    drawing.line(axis.at(middle + 5, -width + 2), axis.at(middle + 5, width - 2))
    cup = ((-8, -width), (14, -width), (14, width), (-8, width))
    drawing.line(*(axis.at(middle + along, aside) for along, aside in cup))
    drawing.line(axis.at(middle + 14), axis.end)


def wall(drawing: Drawing, centre: complex, half: float, outward: complex) -> None:
    """A wall seen from the side, hatched on the side to which ``outward`` points."""
    along = half * 1j * outward
    drawing.line(centre + along, centre - along)
    strokes = max(2, round(half / 6))
    for index in range(strokes + 1):
        foot = centre + (1 - 2 * index / strokes) * along
        drawing.line(foot, foot + (8 - 5j) * outward, style="ink thin")


def arrow(drawing: Drawing, start: complex, end: complex, style: str = "ink") -> None:
    """An arrow with an open head."""
    axis = Axis(start, end)
    drawing.line(start, end, style=style)
    drawing.line(axis.at(axis.length - 10, 5), end, axis.at(axis.length - 10, -5), style=style)
