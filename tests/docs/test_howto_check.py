"""The page on checking a paper's equations, done as written, in an empty folder."""

import re
from pathlib import Path

import pytest

from tests.shown import DOCS, assert_shown, commands, run

pytest.importorskip("sympy")

PAGE = DOCS / "howto_check.md"


@pytest.mark.thorough
def test_the_page_does_what_it_says(tmp_path: Path) -> None:
    text = PAGE.read_text(encoding="utf-8")
    block = r"^```{code-block} (?:python|toml)\n:caption: (\S+)\n(.*?)^```$"
    files = re.findall(block, text, re.MULTILINE | re.DOTALL)
    assert [name for name, _ in files] == ["cart.py", "notes.toml"]
    for name, content in files:
        (tmp_path / name).write_text(content, encoding="utf-8")
    done = commands(PAGE)
    assert len(done) == 5
    for command, shown in done:
        assert_shown(shown, run(command, tmp_path))


def test_the_page_lists_every_object() -> None:
    from spragsym.derive.statements.objects import OBJECTS

    rows = re.findall(r"^\| (`.*`) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    listed = {name.split()[0] for row in rows for name in re.findall(r"`([^`]+)`", row)}
    assert listed - {"about"} == {*OBJECTS, "definition", "notation", "other"}
