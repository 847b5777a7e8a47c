"""The drawings of the pages: as committed, complete, readable by light and by dark, also of new
pages.
"""

import pytest

pytest.importorskip("sympy")


from spragsym.derive import drawing, pages
from spragsym.models.load import load, mechanism
from spragsym.models.model import title_drawing_words
from tests.support import ROOT

IMAGES = ROOT / "docs" / "images" / "models"
NAMES = sorted(path.stem for path in pages.shipped())


@pytest.fixture(scope="module")
def drawings() -> dict[str, str]:
    return drawing.every_drawing()


@pytest.mark.parametrize("name", NAMES)
def test_committed_drawings_are_those_of_the_pages(name: str, drawings: dict[str, str]) -> None:
    """``python -m derive.drawing`` writes them; their files are the same bytes on every machine."""
    assert (IMAGES / f"{name}.svg").read_text(encoding="utf-8") == drawings[name]
    assert mechanism(load(name)) == drawings[name]


def test_words_of_a_page_begin_below_a_drawing_with_blank_lines() -> None:
    about = {
        "drawing": "A block.\n\n::\n\n    top\n\n    middle\n\n    end\n\nIt slides:\n\n    F = 1"
    }
    assert title_drawing_words(about) == (
        "A block.",
        "top\n\nmiddle\n\nend",
        ["It slides:", "    F = 1"],
    )
