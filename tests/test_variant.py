"""The page on changing the model, done as written in a copy of the tree."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from tests.test_documents import ROOT, assert_shown, commands, run

pytest.importorskip("sympy")

PAGE = ROOT / "docs/howto_model.md"


def sections() -> dict[str, str]:
    """Sections of the page by title."""
    parts = re.split(r"^## (.*)$", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def captioned(text: str, language: str) -> list[tuple[str, str]]:
    """File name and text of each code block with a caption."""
    return re.findall(rf"^```{{code-block}} {language}\n:caption: (\S+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def edit(path: Path, diff: str) -> None:
    """Replace each run of ``-`` lines, or their beginnings, by the ``+`` lines below it."""
    text = path.read_text(encoding="utf-8")
    for old, new in re.findall(r"((?:^-.*\n)+)((?:^\+.*\n)+)", diff, re.MULTILINE):
        before, after = (re.sub(r"^[-+]", "", part, flags=re.MULTILINE).rstrip("\n") for part in (old, new))
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    path.write_text(text, encoding="utf-8")


@pytest.mark.parametrize("title", ["Add a viscous damper along the belt", "Change the friction law"])
def test_the_page_does_what_it_says(title: str, tmp_path: Path) -> None:
    for folder in ("derive", "generated", "spragsym"):
        ignore = shutil.ignore_patterns("__pycache__")
        shutil.copytree(ROOT / folder, tmp_path / folder, symlinks=True, ignore=ignore)
    text = sections()[title]
    changes = captioned(text, "diff")
    assert changes
    for name, diff in changes:
        edit(tmp_path / name, diff)
    for name, program in captioned(text, "python"):
        (tmp_path / name).write_text(program, encoding="utf-8")
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    done = commands(page)
    assert done
    for command, shown in done:
        assert_shown(shown, run(command, tmp_path))
