"""The page on writing a model, done as written, in an empty folder."""

import re
import runpy
from pathlib import Path

import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of
from tests.shown import assert_shown, commands, run
from tests.support import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "docs/howto_model.md"


@pytest.mark.thorough
def test_the_page_does_what_it_says(tmp_path: Path) -> None:
    text = PAGE.read_text(encoding="utf-8")
    files = re.findall(
        r"^```{code-block} python\n:caption: (\S+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL
    )
    assert [name for name, _ in files] == ["soft_brake.py", "use.py"]
    for name, program in files:
        (tmp_path / name).write_text(program, encoding="utf-8")
    done = commands(PAGE)
    assert len(done) == 5
    for command, shown in done:
        assert_shown(shown, run(command, tmp_path))


@pytest.mark.thorough
def test_around_a_torsion_spring_searches_end_soon_and_say_why() -> None:
    """Its force has no bound at the anchor, which comes down to the belt at both ends of the range
    of θ₀.
    """
    files = dict(
        re.findall(
            r"^```{code-block} python\n:caption: (\S+)\n(.*?)^```$",
            PAGE.read_text("utf-8"),
            re.M | re.S,
        )
    )
    model = model_of(files["soft_brake.py"], "soft_brake")
    found = ss.folds(model.Parameters(), "theta0")
    assert not found.complete
    assert 0 < len(found.undecided) < 10
    assert all(min(abs(box[2, 0]), abs(box[2, 1] - 3.14159)) < 0.01 for box in found.undecided)
    assert "its force has no bound there" in found.remarks[0]
    assert ss.folds(model.Parameters(), "theta0", between={"theta0": (0.1, 3.0)}).complete


def test_the_page_of_other_tests_is_the_one_that_is_shown() -> None:
    shown = re.findall(
        r"^```{code-block} python\n:caption: soft_brake.py\n(.*?)^```$",
        PAGE.read_text("utf-8"),
        re.M | re.S,
    )
    assert shown == [(ROOT / "tests/oracles/pages/soft_brake.py").read_text(encoding="utf-8")]


def test_the_gallery_has_every_model_as_it_is() -> None:
    """All of the gallery but its computed lines, as ``python docs/gallery.py`` writes it."""
    page = runpy.run_path(str(ROOT / "docs/gallery.py"))["page"]
    shown = (ROOT / "docs/models.md").read_text(encoding="utf-8").splitlines()
    computed = ("Folds at the base values: ", "Cusps: ")
    plain = [line for line in shown if line and not line.startswith(computed)]
    assert plain == [line for line in page(points=False).splitlines() if line]
    assert sum(line.startswith(computed) for line in shown) == 20
