"""The page on writing a model, done as written, in an empty folder."""

import runpy
from pathlib import Path

import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of
from tests.shown import assert_done, captioned
from tests.support import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "docs/howto_model.md"


@pytest.mark.thorough
def test_the_page_does_what_it_says(tmp_path: Path) -> None:
    assert_done(PAGE, tmp_path, ["soft_brake.py", "use.py"])


@pytest.mark.thorough
def test_around_a_torsion_spring_searches_end_soon_and_say_why() -> None:
    """Its force has no bound at the anchor, which comes down to the belt at both ends of the range
    of θ₀.
    """
    model = model_of(captioned(PAGE)["soft_brake.py"], "soft_brake")
    found = ss.folds(model.Parameters(), "theta0")
    assert not found.complete
    assert 0 < len(found.undecided) < 10
    assert all(min(abs(box[2, 0]), abs(box[2, 1] - 3.14159)) < 0.01 for box in found.undecided)
    assert "its force has no bound there" in found.remarks[0]
    assert ss.folds(model.Parameters(), "theta0", between={"theta0": (0.1, 3.0)}).complete


def test_the_page_of_other_tests_is_the_one_that_is_shown() -> None:
    known = (ROOT / "tests/oracles/pages/soft_brake.py").read_text(encoding="utf-8")
    assert captioned(PAGE)["soft_brake.py"] == known


def test_the_gallery_has_every_model_as_it_is() -> None:
    """All of the gallery but its computed lines, as ``python docs/gallery.py`` writes it."""
    page = runpy.run_path(str(ROOT / "docs/gallery.py"))["page"]
    shown = (ROOT / "docs/models.md").read_text(encoding="utf-8").splitlines()
    computed = ("Folds at the base values: ", "Cusps: ")
    plain = [line for line in shown if line and not line.startswith(computed)]
    assert plain == [line for line in page(points=False).splitlines() if line]
    assert sum(line.startswith(computed) for line in shown) == 20
