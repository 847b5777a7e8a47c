"""What mechanisms are drawn of, as SVG: springs, dampers, walls, arrows, names with indices.
Lengths are pixels, y runs down.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from xml.sax.saxutils import escape

Place = tuple[float, float]

#: Colours by light and by dark; the card behind the drawing makes it readable on a page of either
#: kind.
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

_GREEK = {
    "alpha": "α",
    "beta": "β",
    "delta": "δ",
    "eta": "η",
    "gamma": "γ",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "omega": "ω",
    "phi": "φ",
    "psi": "ψ",
    "rho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "theta": "θ",
    "zeta": "ζ",
}


@dataclass
class Sheet:
    """Elements in the order in which they are drawn, and the room that they take."""

    elements: list[str] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)

    def line(self, *points: Place, style: str = "ink", closed: bool = False) -> None:
        """A line through points."""
        steps = "L".join(f"{_number(x)} {_number(y)}" for x, y in points)
        self.elements.append(f'<path class="{style}" d="M{steps}{"Z" if closed else ""}"/>')
        self.places += points

    def circle(self, centre: Place, radius: float, style: str = "ink") -> None:
        """A circle."""
        x, y = centre
        self.elements.append(
            f'<circle class="{style}" cx="{_number(x)}" cy="{_number(y)}" r="{_number(radius)}"/>'
        )
        self.places += [(x - radius, y - radius), (x + radius, y + radius)]

    def arc(self, centre: Place, radius: float, angle: float) -> None:
        """From the horizontal to an angle above it."""
        x, y = centre
        end = x + radius * math.cos(angle), y - radius * math.sin(angle)
        sweep = f"A{_number(radius)} {_number(radius)} 0 0 0 {_number(end[0])} {_number(end[1])}"
        self.elements.append(
            f'<path class="ink thin" d="M{_number(x + radius)} {_number(y)}{sweep}"/>'
        )
        self.places += [(x + radius, y), end]

    def name(self, text: str, place: Place, anchor: str = "middle", style: str = "") -> None:
        """A name, its index lowered; Greek letters by their English names."""
        x, y = place
        words = []
        for word in text.split():
            stem, _, index = word.partition("_")
            if stem not in _GREEK:
                name = stem.rstrip("0123456789")
                stem, index = name, stem[len(name) :] + index
            lowered = (
                f'<tspan class="index" dy="5">{escape(index)}</tspan><tspan dy="-5">&#8203;</tspan>'
                if index
                else ""
            )
            words.append(escape(_GREEK.get(stem, stem)) + lowered)
        kind = f' class="{style}"' if style else ""
        self.elements.append(
            f'<text{kind} x="{_number(x)}" y="{_number(y)}" '
            f'text-anchor="{anchor}">{" ".join(words)}</text>'
        )
        width = 11.0 * len(text.replace("_", ""))
        left = x - width * {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor]
        self.places += [(left, y - 16), (left + width, y + 8)]

    def typed(self, text: str, row: int) -> None:
        """A line of a drawing that is made of letters, each in its column whatever the font."""
        width, y = 9.0 * len(text), 18.0 * row
        if text.strip():
            kept = escape(text).replace(" ", "\N{NO-BREAK SPACE}")
            self.elements.append(
                f'<text class="typed" x="0" y="{_number(y)}" textLength="{_number(width)}" '
                f'lengthAdjust="spacingAndGlyphs">{kept}</text>'
            )
        self.places += [(0.0, y - 16), (width, y + 8)]

    def svg(self, title: str) -> str:
        """The file."""
        margin = 16
        left, top = (
            math.floor(min(place[axis] for place in self.places)) - margin for axis in (0, 1)
        )
        width, height = (
            math.ceil(max(place[axis] for place in self.places)) + margin - start
            for axis, start in ((0, left), (1, top))
        )
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left} {top} {width} {height}" '
            f'width="{width}" height="{height}" role="img">\n'
            f"<title>{escape(title)}</title>\n<style>\n{STYLE}\n</style>\n"
            f'<rect class="card" x="{left}" y="{top}" width="{width}" height="{height}" rx="8"/>\n'
            + "\n".join(self.elements)
            + "\n</svg>\n"
        )


def _number(value: float) -> str:
    return f"{round(value, 1) + 0.0:g}"


@dataclass(frozen=True)
class Axis:
    """A line from one place to another, beside which parts are drawn."""

    start: Place
    end: Place

    @property
    def length(self) -> float:
        """Distance of the ends."""
        return math.dist(self.start, self.end)

    def at(self, along: float, aside: float = 0.0) -> Place:
        """The place at a distance along the line and a distance to its right."""
        (x0, y0), (x1, y1) = self.start, self.end
        c, s = (x1 - x0) / self.length, (y1 - y0) / self.length
        return x0 + along * c - aside * s, y0 + along * s + aside * c

    def shifted(self, aside: float) -> Axis:
        """The line beside it."""
        return Axis(self.at(0.0, aside), self.at(self.length, aside))


def spring(sheet: Sheet, axis: Axis, turns: int = 6, width: float = 8.0) -> None:
    """A zigzag with straight ends."""
    lead = 0.18 * axis.length
    step = (axis.length - 2 * lead) / (2 * turns)
    inner = [
        axis.at(lead + (place + 0.5) * step, width if place % 2 else -width)
        for place in range(2 * turns)
    ]
    sheet.line(axis.start, axis.at(lead), *inner, axis.at(axis.length - lead), axis.end)


def damper(sheet: Sheet, axis: Axis, width: float = 7.0) -> None:
    """A piston in a cup."""
    middle = 0.5 * axis.length
    sheet.line(axis.start, axis.at(middle + 5))
    sheet.line(axis.at(middle + 5, -width + 2), axis.at(middle + 5, width - 2))
    sheet.line(
        axis.at(middle - 8, -width),
        axis.at(middle + 14, -width),
        axis.at(middle + 14, width),
        axis.at(middle - 8, width),
    )
    sheet.line(axis.at(middle + 14), axis.end)


def wall(sheet: Sheet, centre: Place, half: float, outward: Place) -> None:
    """A wall seen from the side, hatched away from what it holds."""
    (x, y), (ox, oy) = centre, outward
    ends = (x - half * oy, y + half * ox), (x + half * oy, y - half * ox)
    sheet.line(*ends)
    strokes = max(2, round(half / 6))
    for place in range(strokes + 1):
        share = place / strokes
        px, py = (ends[0][axis] + share * (ends[1][axis] - ends[0][axis]) for axis in (0, 1))
        sheet.line((px, py), (px + 8 * ox + 5 * oy, py + 8 * oy - 5 * ox), style="ink thin")


def arrow(sheet: Sheet, start: Place, end: Place, style: str = "ink") -> None:
    """An arrow with an open head."""
    axis = Axis(start, end)
    sheet.line(start, end, style=style)
    sheet.line(axis.at(axis.length - 10, 5), end, axis.at(axis.length - 10, -5), style=style)
