"""Languages: the bits of C, what their page shows, and one added by the words of CONTRIBUTING alone."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from spragsym.derive.emit import targets
from spragsym.derive.kang_nam import library
from tests.oracles import languages
from tests.oracles.languages import NODE, OCTAVE
from tests.shown import DOCS, programs
from tests.support import ROOT

PAGE = ROOT / "CONTRIBUTING.md"


def section(title: str) -> str:
    """One section of CONTRIBUTING."""
    return PAGE.read_text(encoding="utf-8").split(f"\n## {title}\n")[1].split("\n## ")[0]


# ---------------------------------------------------------------------------------------- languages that are there


@pytest.mark.parametrize("contact", [True, False])
@pytest.mark.parametrize(
    ("there", "solved"),
    [pytest.param(NODE, languages.in_node, marks=pytest.mark.thorough), (OCTAVE, languages.in_octave)],
    ids=["node", "Octave"],
)
def test_every_bit_is_that_of_c(there: str | None, solved: Callable[..., Any], contact: bool, c_library: ctypes.CDLL) -> None:
    """Statuses, counts, states and bounds of all points, vouched for or not: one kernel, no operation of it different."""
    if there is None:
        pytest.skip("it is not on this machine")
    p = languages.adversarial(120)
    found = solved(p, contact)
    assert not languages.unlike_c(found, c_library, p, contact).any()
    filled = np.arange(4) < found.count[:, None]
    assert all(np.array_equal(np.isfinite(found.columns[name]), filled) for name in ("theta", "L", "x", "y"))


def in_node(program: str) -> str:
    command, folder = [str(NODE), "--input-type=module"], languages.library("javascript")
    return subprocess.run(command, cwd=folder, input=program, capture_output=True, text=True, timeout=60, check=True).stdout


def in_octave(program: str) -> str:
    return languages.octave(languages.library("matlab"), f"set(0, 'defaultfigurevisible', 'off');\n{program}")


@pytest.mark.thorough
@pytest.mark.parametrize(("language", "there", "run"), [("javascript", NODE, in_node), ("matlab", OCTAVE, in_octave)])
def test_programs_of_the_page_print_what_it_shows(language: str, there: str | None, run: Callable[[str], str]) -> None:
    if there is None:
        pytest.skip("it is not on this machine")
    shown = programs(DOCS / "howto_languages.md", language)
    assert len(shown) > 2
    for example in languages.library(language).glob("example_*.m"):
        assert example.read_text(encoding="utf-8") in dict(shown)
    for program, output in shown:
        assert run(program).startswith(output)


# ------------------------------------------------------------------------------------------------- a new language


def test_the_language_that_contributing_adds_is_printed() -> None:
    """Its one file, as it stands there, gives every function of the library with the statements of Python."""
    steps = re.sub(r"^   ", "", section("Add a language"), flags=re.MULTILINE)
    ((name, program),) = re.findall(r"`derive/emit/targets/(\w+)/__init__\.py`:\n\n```python\n(.*?)\n```", steps, re.DOTALL)
    space: dict[str, Any] = {"__package__": f"{targets.__name__}.{name}"}
    exec(program, space)
    ((_, text),) = space["render"](library.material(lambda name: (ROOT / "generated" / name).read_text(encoding="utf-8"))).items()
    assert "f_third(cos, sin, a_f, b_f, d_f, m_f) gives f‴\n  w0 = 4*a_f\n" in text


# ----------------------------------------------------------------------------------------- what is printed


@pytest.mark.thorough
def test_generated_c_comes_out_formatted() -> None:
    """The printer lays C out by itself, as clang-format would, for any model; of the article's another one knows nothing."""
    pytest.importorskip("sympy")
    from spragsym.derive import export

    formatter = shutil.which("clang-format", path=Path(sys.executable).parent)
    if formatter is None:
        pytest.skip("clang-format is not installed")
    published = ROOT / "generated" / "c"
    texts = {name: (published / name).read_text(encoding="utf-8") for name in ("spragsym.h", "spragsym.c", "main.c")}
    another = export.export(ROOT / "tests/oracles/pages/pressed.py", "pressed", "c")
    for path in ("pressed.h", "pressed.c"):
        assert not re.search(r"spragsym_|theta|@(?!file|param|return)", another[path], re.IGNORECASE), path
    for name, text in {**texts, **{name: text for name, text in another.items() if name != "Makefile"}}.items():
        call = [formatter, f"--style=file:{ROOT / '.clang-format'}", f"--assume-filename={name}"]
        done = subprocess.run(call, input=text, capture_output=True, text=True, timeout=60, check=True)
        assert done.stdout == text, name
