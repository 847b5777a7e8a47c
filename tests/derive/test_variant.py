"""The page on changing the model, done as written in a copy of the tree."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.shown import assert_shown, commands, run
from tests.support import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "docs/howto_article.md"


def sections() -> dict[str, str]:
    """Sections of the page by title."""
    parts = re.split(r"^## (.*)$", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def captioned(text: str, language: str) -> list[tuple[str, str]]:
    """File name and text of each code block with a caption."""
    return re.findall(
        rf"^```{{code-block}} {language}\n:caption: (\S+)\n(.*?)^```$",
        text,
        re.MULTILINE | re.DOTALL,
    )


def edit(path: Path, diff: str) -> None:
    """Replace each run of ``-`` lines, or their beginnings, by the ``+`` lines below it."""
    text = path.read_text(encoding="utf-8")
    for old, new in re.findall(r"((?:^-.*\n)+)((?:^\+.*\n)+)", diff, re.MULTILINE):
        before, after = (
            re.sub(r"^[-+]", "", part, flags=re.MULTILINE).rstrip("\n") for part in (old, new)
        )
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    path.write_text(text, encoding="utf-8")


@pytest.mark.by_hand("Add a viscous", "Change")
@pytest.mark.thorough
@pytest.mark.parametrize(
    "title", ["Add a viscous damper along the belt", "Change the friction law"]
)
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


def _variant(tmp_path: Path, *changes: tuple[str, str]) -> subprocess.CompletedProcess[str]:
    """``python -m derive --variant`` in a copy of ``derive/`` with pieces of the article's page
    replaced.
    """
    shutil.copytree(
        ROOT / "derive", tmp_path / "derive", ignore=shutil.ignore_patterns("__pycache__")
    )
    path = tmp_path / "derive/models/kang_nam.py"
    text = path.read_text(encoding="utf-8")
    for before, after in changes:
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    path.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "derive", "--variant", "--out", "variant"]
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8"}
    return subprocess.run(
        command,
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )


#: What can't be carried through: a contact that leaves no D and b, and a page with a mistake.
STOPPED = {
    "cubic contact": ("lambda depth: k_c * depth", "lambda depth: k_c * depth**3 / L_0**2"),
    "unknown name": ("page.spring(k_y, along=y)", "page.spring(k_z, along=y)"),
    "second inclined spring": (
        "page.spring(k_y, along=y)",
        "page.spring(k_y, (x, y), (L_0, 2 * L_0), length=L_0)",
    ),
    "another name": ('becomes="beta"', 'becomes="rho"'),
    "name of a shorthand": (
        "page.spring(k_y, along=y)",
        'page.spring(k_y + page.parameter("q", "N/m", "", base=0.0), along=y)',
    ),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", STOPPED)
def test_what_cannot_be_carried_through_stops_it(name: str, tmp_path: Path) -> None:
    """As the docstring of ``derive/kang_nam/mechanics.py`` says: nothing is written."""
    done = _variant(tmp_path, STOPPED[name])
    assert done.returncode != 0
    assert "nothing was written" in done.stderr or "is untouched" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "variant").exists()
