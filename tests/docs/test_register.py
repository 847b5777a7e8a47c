"""The register of absolute sentences, docs/statements.toml: its phrases cover the texts, its page is
as generated, what it names exists; and statements of rows that no other test makes.
"""

import runpy
import tomllib
from typing import Any

import pytest

from spragsym.papers import PaperCheck
from tests.shown import DOCS
from tests.support import ROOT

#: A harmless phrase is taken out where its sentence goes; none is put in.
HARMLESS = 143


@pytest.fixture(scope="module")
def register() -> dict[str, Any]:
    return runpy.run_path(str(DOCS / "statements.py"))


def test_every_absolute_word_lies_in_a_phrase(register: dict[str, Any]) -> None:
    covered, phrases = register["covered"], register["phrases"]()
    found = register["absolutes"]()
    by = [covered(word, phrases) for word in found]
    assert not [
        f"{word.where}: {word.text[max(0, word.begin - 40) : word.end + 40]}"
        for word, phrase in zip(found, by, strict=True)
        if phrase is None
    ]
    assert len(found) > 400
    assert sorted(phrases) == sorted({*by})  # none is quoted twice, or for nothing
    assert all(" " in phrase for phrase in phrases)
    assert sum(map(len, register["REGISTER"]["harmless"].values())) <= HARMLESS


def test_a_false_sentence_is_not_covered(register: dict[str, Any]) -> None:
    covered, phrases, Absolute = (register[name] for name in ("covered", "phrases", "Absolute"))
    for text in (
        "Below a friction of 0.2009 no inclination has any fold, which is proved as well.",
        "Below it nothing ever jumps.",
        "The state after the jump is stable.",
        "It never fails; all equilibria are stable.",
    ):
        assert None in [
            covered(Absolute("", text, found.start(), found.end()), phrases())
            for found in register["WORD"].finditer(text)
        ], text


def test_the_page_of_statements_is_as_generated(register: dict[str, Any]) -> None:
    assert register["page"]() == (DOCS / "statements.md").read_text(encoding="utf-8")


def test_tests_of_rows_exist_and_falsehoods_can_be_planted(register: dict[str, Any]) -> None:
    rows = register["REGISTER"]["rows"]
    for name, row in rows.items():
        file, test = row["test"].split("::")
        text = (ROOT / file).read_text(encoding="utf-8")
        assert f"def {test}(" in text, name
        assert text.count(row["plant"][0]) == 1, name
    assert len(rows) >= 40


# -------------------------------------------------------------------------------------------------
# statements of rows


def test_exported_c_allocates_nothing() -> None:
    text = (ROOT / "generated/c/spragsym.c").read_text(encoding="utf-8")
    for name in ("malloc", "calloc", "realloc", "free("):
        assert name not in text, name
    assert {line for line in text.splitlines() if line.startswith("#include <")} <= {
        f"#include <{name}.h>" for name in ("math", "float", "stdint", "string")
    }


def test_where_the_table_says_nothing_no_verdict_says_otherwise() -> None:
    text = (DOCS / "checked_papers.md").read_text(encoding="utf-8")
    head, _, *lines = [line.strip("| ").split(" | ") for line in text.splitlines() if "|" in line]
    rows = [dict(zip(head, line, strict=True)) for line in lines]
    assert len(rows) >= 8
    for row in rows:
        files = (ROOT / "validation/papers" / row["NAME"].strip("`")).glob("*.toml")
        expected = [
            said.get("expect", "confirmed")
            for file in files
            for said in tomllib.loads(file.read_text(encoding="utf-8"))["statement"]
        ]
        nothing_wrong = row["what was wrong"].startswith("nothing")
        assert nothing_wrong == ("misprint" not in expected), row
        assert not {"failed", "approximation"} & {*expected}, row


def test_a_page_of_html_loads_nothing() -> None:
    text = PaperCheck("A paper <script>", "kang_nam", (), ()).to_html()
    for name in ("https://", "http://", "src=", "<link", "<script", "@import"):
        assert name not in text, name
