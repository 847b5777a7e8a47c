"""The drawings of the pages: as committed, complete, readable by light and by dark, also of new pages."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

pytest.importorskip("sympy")

import sympy as sp

from spragsym.derive import drawing, pages, shapes
from spragsym.derive.model import Page
from tests.support import ROOT

IMAGES = ROOT / "docs" / "images" / "models"
NAMES = sorted(path.stem for path in pages.shipped())
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def every() -> dict[str, Page]:
    return drawing.every_page()


@pytest.fixture(scope="module")
def drawings() -> dict[str, str]:
    return drawing.every_drawing()


def words(svg: str) -> list[str]:
    """Every name in a drawing, indices after an underscore."""
    texts = list(ElementTree.fromstring(svg).iter(f"{SVG}text"))
    marked = [
        (text.text or "") + "".join(("_" + (part.text or "") if part.get("class") else "") + (part.tail or "") for part in text)
        for text in texts
    ]
    return [word for text in marked for word in text.split()]


@pytest.mark.parametrize("name", NAMES)
def test_committed_drawings_are_those_of_the_pages(name: str, drawings: dict[str, str]) -> None:
    """``python -m derive.drawing`` writes them; their files are the same bytes on every machine."""
    assert (IMAGES / f"{name}.svg").read_text(encoding="utf-8") == drawings[name]


def test_no_drawing_is_left_over_and_all_are_shown() -> None:
    pictures = sorted([*NAMES, *(f"{name}_set" for name in NAMES)])
    assert sorted(path.stem for path in IMAGES.glob("*.svg")) == pictures
    gallery = (ROOT / "docs" / "models.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"images/models/(\w+)\.svg", gallery)) == pictures
    for path in ("README.md", "docs/index.md"):
        assert "images/models/kang_nam.svg" in (ROOT / path).read_text(encoding="utf-8").split("## ")[0]


@pytest.mark.parametrize("name", NAMES)
def test_everything_that_pulls_or_pushes_is_named(name: str, every: dict[str, Page], drawings: dict[str, str]) -> None:
    """Stiffnesses, dampers, forces but for their directions, the belt's speed, the mass; and each spring is drawn as one."""
    page, svg = every[name], drawings[name]
    expected = {str(symbol) for it in page.springs for symbol in it.stiffness.free_symbols}
    expected |= {str(symbol) for it in page.dampers for symbol in it.coefficient.free_symbols}
    expected |= {"m", *(str(symbol) for symbol in (page.sliding.belt.free_symbols if page.sliding else ()))}
    for force in page.forces:
        angles = {symbol for part in force.components for node in part.atoms(sp.sin, sp.cos) for symbol in node.free_symbols}
        expected |= {str(symbol) for part in force.components for symbol in part.free_symbols - angles}
    assert expected <= set(re.findall(r"\w+", " ".join(words(svg))))


@pytest.mark.parametrize("name", NAMES)
def test_drawings_stay_on_their_card(name: str, drawings: dict[str, str]) -> None:
    """Every coordinate in the picture is inside of it, and nothing is fetched from elsewhere."""
    svg = drawings[name]
    root = ElementTree.fromstring(svg)
    left, top, width, height = map(float, str(root.get("viewBox")).split())
    for path in root.iter(f"{SVG}path"):
        numbers = list(map(float, re.findall(r"-?\d+(?:\.\d+)?", re.sub(r"A\S+ \S+ \S+ \S+ \S+ ", "L", str(path.get("d"))))))
        assert all(left <= x <= left + width for x in numbers[::2])
        assert all(top <= y <= top + height for y in numbers[1::2])
    assert "http" not in svg.replace("http://www.w3.org/2000/svg", "")
    assert root.find(f"{SVG}title") is not None


def luminance(colour: str) -> float:
    """Relative luminance of #rgb or #rrggbb, as WCAG 2 defines it."""
    digits = colour.lstrip("#")
    digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
    parts = [int(digits[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def test_lines_and_names_stand_out_by_light_and_by_dark() -> None:
    """Ink, names and forces against the card and against what bodies are filled with: at least 4.5 to 1."""
    for rules in shapes.STYLE.split("@media(prefers-color-scheme:dark)"):
        colour = dict(re.findall(r"\.?([\w-]+)\{(?:fill|stroke):(#\w+)", rules))
        for ink in ("ink", "text", "force", "force-name"):
            for ground in ("card", "body", "belt"):
                light, dark = sorted((luminance(colour[ink]), luminance(colour[ground])), reverse=True)
                assert (light + 0.05) / (dark + 0.05) > 4.5, (ink, ground)


def test_a_page_that_nobody_has_drawn_before() -> None:
    """Three springs along one line, two anchors on one side, no belt contact law, no friction: it is drawn all the same."""
    page = Page("A mass with whatever there is.")
    m, L_0 = page.unit("m", "kg", "mass"), page.unit("L_0", "m", "length")
    stiffness = [page.parameter(f"k_{k}", "N/m", "stiffness", "> 0", 1.0) for k in range(5)]
    x, y = page.coordinate("x", "m", "along"), page.coordinate("y", "m", "across")
    page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
    for k in stiffness[:3]:
        page.spring(k, along=x)
    page.spring(stiffness[3], (x, y), (L_0, L_0), length=L_0)
    page.spring(stiffness[4], (x, y), (2 * L_0, L_0), length=L_0)
    assert {f"k_{k}" for k in range(5)} <= set(words(drawing.render(page)))


def a_free_mass(summary: str, second: tuple[str, str] = ("y", "m")) -> tuple[Page, sp.Expr, sp.Expr, sp.Symbol]:
    """A page with a mass, tied to the ground along x, and its second coordinate, of any unit."""
    page = Page(summary)
    m, g, L_0 = page.unit("m", "kg", "mass"), page.unit("g", "m/s^2", "gravity"), page.unit("L_0", "m", "length")
    k_x = page.parameter("k_x", "N/m", "stiffness", "> 0", 1.0)
    x, y = page.coordinate("x", "m", "along"), page.coordinate(*second, "the other")
    sizes = {"m": sp.S.One, "rad": L_0**2}
    page.kinetic(m * (page.rate(x) ** 2 + sizes[second[1]] * page.rate(y) ** 2) / 2)
    page.spring(k_x, along=x)
    return page, m * g, L_0, y


def test_the_potential_of_gravity_is_an_arrow_downwards() -> None:
    """It depends on y alone and is linear: the same arrow as of the force that it stands for, and no spring."""
    by_energy, weight, _, y = a_free_mass("A mass with a weight.")
    by_energy.potential(weight * y)
    by_force, weight, _, y = a_free_mass("A mass with a weight.")
    by_force.force(0, -weight, at=(by_force.coordinates[0].symbol, y))
    arrows = [re.findall(r'<[^>]*class="ink force"[^>]*>', drawing.render(page)) for page in (by_energy, by_force)]
    assert {"m", "g"} <= set(" ".join(words(drawing.render(by_energy))).split())
    assert len(arrows[0]) == len(arrows[1]) > 0
    assert drawing.render(by_energy).count("<") == drawing.render(by_force).count("<")


TYPED = "A mass.\n\n::\n\n      o\n     / <θ\n    /\n\n    m\n\nIt turns.\n"


def test_what_cannot_be_drawn_shows_the_drawing_of_the_docstring() -> None:
    """Letter for letter, each in its column: two masses in a row, a rod, a wavy rail, a spring along a sum."""
    assert drawing.typed(TYPED) == ["  o", " / <θ", "/", "", "m"]

    def chain(page: Page) -> None:
        m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
        one, two = page.coordinate("x", "m", "first"), page.coordinate("y", "m", "second")
        page.kinetic(m * (page.rate(one) ** 2 + page.rate(two) ** 2) / 2)
        page.spring(k, along=two - one)

    def rail(page: Page) -> None:
        m, L_0, k = page.unit("m", "kg", "mass"), page.unit("L_0", "m", "length"), page.unit("k", "N/m", "stiffness")
        x, y = page.coordinate("x", "m", "along"), page.coordinate("y", "m", "across")
        page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
        page.spring(k, along=x)
        page.contact(y - L_0 * sp.sin(x / L_0) / 9, lambda depth: k * depth)

    for write in (chain, rail):
        page = Page("Something else.")
        write(page)
        svg = drawing.render(page, TYPED)
        assert [text.text.replace("\N{NO-BREAK SPACE}", " ") for text in ElementTree.fromstring(svg).iter(f"{SVG}text")] == [
            "  o", " / <θ", "/", "m",
        ]  # fmt: skip
        assert "path" not in svg


@pytest.mark.parametrize(("second", "shown"), [(("y", "m"), True), (("phi", "rad"), False)])
def test_a_potential_of_the_second_coordinate_alone(second: tuple[str, str], shown: bool) -> None:
    """A spring across the belt, if that coordinate is a length; one that turns is not drawn as a spring that leans."""
    page, _, length, y = a_free_mass("A mass with a potential.", second)
    k = page.parameter("k", "N/m", "stiffness", "> 0", 1.0)
    page.potential(k * (y if shown else length * y) ** 2)
    svg = drawing.render(page)
    assert ("k" in words(svg)) == shown
    assert not re.search(r"\b(nan|inf)\b", svg)


def test_a_torsion_spring_is_drawn_at_its_anchor() -> None:
    page, _, L_0, y = a_free_mass("A mass with a spring whose anchor resists turning.")
    k, k_t = page.parameter("k", "N/m", "stiffness", "> 0", 1.0), page.parameter("k_t", "N m", "torsion spring", "> 0", 1.0)
    mass, anchor = (page.coordinates[0].symbol, y), (L_0, L_0)
    page.spring(k, mass, anchor, length=L_0)
    page.torsion(k_t, mass, anchor, rest=sp.pi / 4)
    assert {"k", "k_t"} <= set(words(drawing.render(page)))
