"""The page on checking a paper's equations, done as written, in an empty folder."""

import re
from pathlib import Path

import pytest

from tests.shown import DOCS, assert_done

pytest.importorskip("sympy")

PAGE = DOCS / "howto_check.md"


@pytest.mark.thorough
def test_the_page_does_what_it_says(tmp_path: Path) -> None:
    assert_done(PAGE, tmp_path, ["cart.py", "notes.toml"])


def test_the_page_lists_every_object() -> None:
    from spragsym.derive.statements.objects import OBJECTS

    rows = re.findall(r"^\| (`.*`) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    listed = {name.split()[0] for row in rows for name in re.findall(r"`([^`]+)`", row)}
    assert listed - {"about"} == {
        *OBJECTS,
        *("definition", "notation", "other", "force", "value", "code"),
    }
