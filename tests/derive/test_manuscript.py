"""The derivation of a page as a text: what it prints is read back and judged."""

import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from tests.support import ROOT

pytest.importorskip("sympy")

from spragsym.derive import manuscript_files, pages
from spragsym.derive.manuscript import Manuscript, manuscript
from spragsym.derive.statements import papers, verdicts

#: A friction, a clock without equilibrium, springs by their ends with an opening contact.
QUICK = ("two_blocks", "forced_oscillator", "two_springs")
PAPERS = sorted((ROOT / "validation" / "papers").glob("*/page.py"))


def _of(path: Path) -> tuple[pages.PageModel, Manuscript]:
    model = pages.read(path)
    return model, manuscript(model)


def _verdicts(model: pages.PageModel, text: str) -> dict[str, str]:
    """Status of every row of a file of statements."""
    import tomllib

    found = verdicts.check(papers.paper_of("text.toml", text, tomllib.loads), model)
    return {row.id: row.status for row in found.rows}


@pytest.mark.thorough
@pytest.mark.parametrize(
    "path",
    [
        pytest.param(it, marks=[] if it.stem in QUICK else pytest.mark.validate)
        for it in (*pages.shipped(), *PAPERS)
    ],
    ids=lambda it: it.parent.name if it.stem == "page" else it.stem,
)
def test_every_equation_is_confirmed_by_check(path: Path) -> None:
    model, text = _of(path)
    judged = _verdicts(model, manuscript_files.as_statements(text))
    turnings = len(model.page.torsions)
    assert len(judged) > 8
    assert [*judged.values()].count("definition") == turnings
    assert {*judged.values()} - {"definition"} == {"confirmed"}


def test_an_equation_that_is_altered_is_a_misprint() -> None:
    model, text = _of(pages.SHIPPED / "two_blocks.py")
    whole = manuscript_files.as_statements(text)
    right = r"k_{12} x_{2}"
    row = next(it for it in text.formulas if it.label == "units-motion-x_1")
    assert row.latex.count("- " + right) == 1
    altered = whole.replace(row.latex, row.latex.replace("- " + right, "+ " + right))
    judged = _verdicts(model, altered)
    assert judged.pop("units-motion-x_1") == "misprint"
    assert {*judged.values()} == {"confirmed"}


def test_the_page_of_html_has_every_equation_and_loads_nothing() -> None:
    pytest.importorskip("latex2mathml")
    _, text = _of(pages.SHIPPED / "two_springs.py")
    page = manuscript_files.as_html(text)
    assert page.count('class="formula"') == len(text.formulas)
    assert all(f'id="{it.label}"' in page for it in text.formulas)
    assert not any(word in page for word in ("<script", "<link", "src=", "@import"))
    for part in page.split("<math")[1:]:
        ElementTree.fromstring(f"<math{part.partition('</math>')[0]}</math>")


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
@pytest.mark.parametrize("name", ["two_springs", "wobbling_disc"])
def test_the_document_compiles_and_no_line_is_too_long(name: str, tmp_path: Path) -> None:
    _, text = _of(pages.SHIPPED / f"{name}.py")
    (tmp_path / "a.tex").write_text(manuscript_files.as_latex(text), encoding="utf-8")
    run = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    found = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, errors="replace")
    assert found.returncode == 0, found.stdout[-2000:]
    assert "Overfull" not in found.stdout
