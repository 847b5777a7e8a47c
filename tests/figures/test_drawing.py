"""The drawings of the pages: as committed, complete, readable by light and by dark, also of new pages."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

pytest.importorskip("sympy")

import sympy as sp

from spragsym.derive import drawing, pages
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
