"""The house as CONTRIBUTING draws it, and a language added by its words alone."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support import ROOT

PAGE = ROOT / "CONTRIBUTING.md"


def section(title: str) -> str:
    """One section of CONTRIBUTING."""
    return PAGE.read_text(encoding="utf-8").split(f"\n## {title}\n")[1].split("\n## ")[0]


# ------------------------------------------------------------------------------------------------- a new language


def steps() -> str:
    """The section on languages, without the indentation that the text of a numbered step has."""
    return re.sub(r"^   ", "", section("Add a language"), flags=re.MULTILINE)


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the tree with the folder that CONTRIBUTING shows, and nothing else changed."""
    copy = tmp_path_factory.mktemp("house")
    ignored = shutil.ignore_patterns("__pycache__", "*.so", "*.egg-info")
    for folder in ("derive", "generated", "spragsym"):
        shutil.copytree(ROOT / folder, copy / folder, symlinks=True, ignore=ignored)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, copy)
    shown = r"`(derive/emit/targets/\w+/__init__\.py)`:\n\n```python\n(.*?)\n```"
    ((path, program),) = re.findall(shown, steps(), re.DOTALL)
    (copy / path).parent.mkdir()
    (copy / path).write_text(program + "\n", encoding="utf-8")
    return copy


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
