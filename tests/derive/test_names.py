"""Names of a page, and texts in it, in every language that it is exported to."""

import ast
import re
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.derive import export, folder, pages
from spragsym.derive.model import PageError
from spragsym.report.example import example
from tests.oracles import exported_names as names
from tests.oracles.languages import NODE, OCTAVE

#: Words, constants, functions and macros of languages, and what code calls its own.
TAKEN = ("Math", "atan", "pi", "sin", "EOF", "template", "INLINE", "deliver")


def page(tmp_path: Path, name: str, text: str = names.PAGE.format(*TAKEN)) -> Path:
    path = tmp_path / f"{name}.py"
    path.write_text(text, encoding="utf-8-sig")  # Python runs a page with a byte order mark
    return path


@pytest.mark.thorough
@pytest.mark.skipif(
    NODE is None or OCTAVE is None, reason="there is no node or no Octave on this machine"
)
@pytest.mark.parametrize("name", ["my-brake", "main"])
def test_names_of_languages_are_computed_with_as_in_python(name: str, tmp_path: Path) -> None:
    path = page(tmp_path, name)
    folder.write_page(path, tmp_path / "model")
    assert (
        names.compare(ss.load(tmp_path / "model"), tmp_path, np.random.default_rng(55), list(TAKEN))
        == []
    )


@pytest.mark.thorough
@pytest.mark.parametrize("language", ["python", "c", "javascript"])
def test_a_text_ends_no_comment_and_no_docstring(language: str, tmp_path: Path) -> None:
    said = 'ends */ alert(1) /* """ \\N{x} \\'
    text = (
        names.PAGE.format(*TAKEN)
        .replace('Page("A block on a belt.")', f"Page({said!r})")
        .replace('"friction"', repr(said))
    )
    path = page(tmp_path, "mine", text)
    if language == "python":
        assert said in (
            ast.get_docstring(
                ast.parse(folder.render(pages.read(path), "Generated.")["algebra.py"])
            )
            or ""
        )
        return
    for name, whole in export.export(path, "mine", language).items():
        assert "alert" not in re.sub(r"/\*.*?\*/|(?m:^ *// .*$)", "", whole, flags=re.DOTALL), name


@pytest.mark.thorough
def test_data_of_a_page_with_a_greek_quantity_are_read_back(tmp_path: Path) -> None:
    text = names.PAGE.format(*TAKEN).replace('page.unit("k"', 'page.unit("κ"')
    folder.write_page(page(tmp_path, "greek", text), tmp_path / "model")
    data = tmp_path / "brake.toml"
    data.write_text(example(ss.load(tmp_path / "model")), encoding="utf-8")
    assert "κ" in ss.Study.from_file(data, trust=True).quantities


@pytest.mark.parametrize("name", ['"""', "a\\", "<script>", "$(id)", "-n", "a\nb"])
def test_a_file_is_refused_whose_model_could_not_be_loaded(name: str, tmp_path: Path) -> None:
    with pytest.raises(PageError, match="rename the file"):
        pages.read(page(tmp_path, name))


@pytest.mark.thorough
def test_a_page_of_any_other_name_is_explored(tmp_path: Path) -> None:
    assert "export" in export.for_the_browser(pages.read(page(tmp_path, "2 dof")), "")
