"""The house as CONTRIBUTING draws it, and a language added by its words alone."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from spragsym.derive.emit import targets
from spragsym.derive.kang_nam import library
from tests.support import ROOT

PAGE = ROOT / "CONTRIBUTING.md"


def section(title: str) -> str:
    """One section of CONTRIBUTING."""
    return PAGE.read_text(encoding="utf-8").split(f"\n## {title}\n")[1].split("\n## ")[0]


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
