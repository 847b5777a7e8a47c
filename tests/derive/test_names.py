"""Names of a page, and texts in it, in every language that it is exported to."""

import ast
import keyword
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.derive import export, folder, pages, reserved
from spragsym.derive.emit import names as naming
from spragsym.derive.emit import targets
from spragsym.derive.model import PageError
from spragsym.report.example import example
from tests.oracles import exported_names as names
from tests.oracles.exports import CC
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


# ------------------------------------------------------------------------------------------------
# every name of every table

#: Names of generated code, of variables of FMUs, and words.
OURS = ("side", "time", "mu", "held", "pushing", "energy", "power", "M_PI", "mean")
#: Names of files that are tried where not all are.
SOME = {"math", "model", "numpy", "regime", "string", "x"}


def pages_of_names() -> Iterator[list[str]]:
    """Ours, every one of them first in turn; then those of the tables of all targets that are no
    words of Python, on pages of a size that is derived in seconds.
    """
    yield from ([*OURS[at:], *OURS[:at]] for at in range(len(OURS)))
    tables = {name for language in targets.languages() for name in targets.reserved(language)}
    refused = {*reserved.OF_CODE, *reserved.OF_FILES, *OURS, *keyword.kwlist}
    words = sorted(name for name in tables - refused if re.match("[a-z]", name))
    for at in range(0, len(words), 16):
        yield [*words[at : at + 16], *OURS]


@pytest.mark.thorough
@pytest.mark.skipif(CC is None, reason="there is no C compiler on this machine")
@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.validate)])
def test_a_page_of_reserved_names_is_exported_to_every_target(every: bool, tmp_path: Path) -> None:
    """In every role; compiled and run where that can be, the FMU by FMPy."""
    fmpy = pytest.importorskip("fmpy")
    from fmpy.validation import validate_fmu

    for at, turned in enumerate(islice(pages_of_names(), None if every else 1)):
        contacts = (at // 3 + at + 1) % 3
        roles = turned[:2], turned[2:5], turned[:contacts], turned[5:]
        path = page(tmp_path, f"model{at}", names.ROLES.format(roles))
        folder.write_page(path, tmp_path / f"of{at}")
        model, rng = ss.load(tmp_path / f"of{at}"), np.random.default_rng(100)
        assert names.compare(model, tmp_path / f"in{at}", rng, turned) == []
        file = tmp_path / "model.fmu"
        file.write_bytes(targets.packer("fmu")(export.export(path, "model", "fmu")))
        assert validate_fmu(str(file)) == []
        moved = fmpy.simulate_fmu(str(file), stop_time=0.1)
        assert np.isfinite(moved[turned[0]]).all()


@pytest.mark.thorough
@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.validate)])
@pytest.mark.parametrize("language", ["c", "fmu", "jax"])
def test_a_file_of_a_reserved_name_is_exported(language: str, every: bool, tmp_path: Path) -> None:
    """C compiles where its own folder is searched first; Python's modules are not shadowed."""
    taken, plain = targets.reserved(language), page(tmp_path, "plain")
    for name in sorted(taken if every else taken & SOME):
        if re.match(r"\w", name):
            out = tmp_path / ("all" if language == "jax" else name)
            for path, text in export.export(plain, name, language).items():
                (out / path).parent.mkdir(parents=True, exist_ok=True)
                assert not (out / path).exists()
                (out / path).write_text(text, encoding="utf-8")
            if language != "jax" and CC:
                sources = [str(path) for path in out.rglob("*.c")]
                within = f"-I{Path(sources[0]).parent}"
                call = [CC, "-std=c99", "-fsyntax-only", "-Werror", within, *sources]
                subprocess.run(call, check=True, timeout=60)
    if language == "jax":
        (tmp_path / "jax").mkdir()
        (tmp_path / "jax/numpy.py").write_text("from numpy import *", encoding="utf-8")
        every_module = [path.stem for path in (tmp_path / "all").glob("[!e]*.py")]
        code = f"import {', '.join(every_module)}, json, numpy.random, string, typing"
        more = {"PYTHONPATH": f"{tmp_path / 'all'}{os.pathsep}{tmp_path}"}
        subprocess.run([sys.executable, "-c", code], env=os.environ | more, check=True, timeout=60)


def test_a_word_is_set_as_a_word() -> None:
    written = dict(
        mean=r"\mathrm{mean}", M_PI=r"M_{\mathrm{PI}}", theta0=r"\theta_{0}", k_c="k_{c}"
    )
    assert {name: naming.latex(name) for name in written} == written
