"""The page on changing the model, done as written in a copy of the tree."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.test_documents import ROOT, assert_shown, commands, run

pytest.importorskip("sympy")

PAGE = ROOT / "docs/howto_article.md"


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


@pytest.mark.thorough
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


def _variant(tmp_path: Path, *changes: tuple[str, str, str]) -> subprocess.CompletedProcess[str]:
    """``python -m derive --variant`` in a copy of ``derive/`` with pieces of text replaced."""
    shutil.copytree(ROOT / "derive", tmp_path / "derive", ignore=shutil.ignore_patterns("__pycache__"))
    for name, before, after in changes:
        path = tmp_path / "derive" / "kang_nam" / name
        text = path.read_text(encoding="utf-8")
        assert text.count(before) == 1, before
        path.write_text(text.replace(before, after), encoding="utf-8")
    command = [sys.executable, "-m", "derive", "--variant", "--out", "variant"]
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8"}
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, encoding="utf-8", timeout=300, check=False)


@pytest.mark.thorough
def test_a_symbol_without_a_dimension_goes_into_the_groups(tmp_path: Path) -> None:
    """As CONTRIBUTING says: a second friction coefficient, which friction itself takes as an argument."""
    law = "return mu0 * (1 - sp.exp(-creep * sp.Abs(slip))) * sp.sign(slip)"
    done = _variant(
        tmp_path,
        ("nomenclature.py", "nbar = _define(", 'mu_s = _define("mu_s", r"\\mu_s", "rises with speed")\nnbar = _define('),
        ("mechanics.py", law, law + " + nm.mu_s * slip"),
        ("mechanics.py", "nm.creep: (nm.d_dim, 1 / speed),", "nm.creep: (nm.d_dim, 1 / speed), nm.mu_s: (nm.mu_s, sp.S.One),"),
    )
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "variant/motion.py").read_text(encoding="utf-8")
    signatures = dict(re.findall(r"^def (\w+)\((.*?)\) ->", text, re.MULTILINE | re.DOTALL))
    assert {name for name, arguments in signatures.items() if "mu_s:" in arguments} == {
        "friction", "rhs", "regime_rhs", "regime_jacobian", "regime_by_parameters", "friction_power",
    }  # fmt: skip
    assert not (tmp_path / "variant/c").exists()


@pytest.mark.thorough
def test_a_force_that_the_elimination_was_not_made_for_stops_it(tmp_path: Path) -> None:
    """As the docstring of ``derive/kang_nam/mechanics.py`` says: a cubic contact leaves no D and b, and nothing is written."""
    done = _variant(tmp_path, ("mechanics.py", "sp.Piecewise((-stiffness * y, y < 0)", "sp.Piecewise((-stiffness * y**3, y < 0)"))
    assert done.returncode != 0
    assert "nothing was written" in done.stderr or "is untouched" in done.stderr
    assert not (tmp_path / "variant").exists()


def test_the_page_names_places_that_exist() -> None:
    """Every function that the page says a file has, or uses, stands in that file."""
    text = sections()["Add a viscous damper along the belt"].split("To adopt the change for good")[1]
    for file, names in (("derive/models/damped.py", ("page.damper",)),
                        ("derive/kang_nam/mechanics.py", ("further_parameters",))):  # fmt: skip
        assert f"`{file}`" in text
        assert all(f"`{name}`" in text and name in (ROOT / file).read_text(encoding="utf-8") for name in names)
    named = set(re.findall(r"`((?:derive|spragsym)/[\w/]+\.py)`", PAGE.read_text(encoding="utf-8")))
    assert all((ROOT / file).is_file() for file in named)
