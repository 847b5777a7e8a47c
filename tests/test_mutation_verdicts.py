"""What the mutation tests keep from run to run: what holds still, and what has to be run again."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.mutants.verdicts import Definitions, Journal, report

TEXT = """
'''What the file is about.'''

import math

LIMIT = 3

def helper(x):
    'Whether x is below.'
    return x < LIMIT

class Kept:
    'Nothing.'

def test_one():
    assert helper(1) or Kept

def test_other(fixture):
    assert math.pi > 3  # a comment
"""


def _stamped(tmp_path: Path, text: str, *names: str) -> str:
    file = tmp_path / "given.py"
    file.write_text(text, encoding="utf-8")
    return Definitions(str(file)).text(names)


def test_a_stamp_takes_in_what_a_test_names_and_nothing_else(tmp_path: Path) -> None:
    before = _stamped(tmp_path, TEXT, "test_one")
    prose = (("about.", "about, more or less."), ("Whether x is below.", "Small?"), ("Nothing.", "A class."))
    for same in (("# a comment", "# another"), ("math.pi > 3", "math.pi > 2"), ("(fixture)", "(other)"), *prose):
        assert same[0] in TEXT
        assert _stamped(tmp_path, TEXT.replace(*same), "test_one") == before
    for changed in (
        ("x < LIMIT", "x <= LIMIT"),
        ("LIMIT = 3", "LIMIT = 4"),
        ("helper(1)", "helper(2)"),
        ("import math", "import os"),
    ):
        assert _stamped(tmp_path, TEXT.replace(*changed), "test_one") != before


def test_verdicts_hold_as_long_as_the_tests_behind_them(tmp_path: Path) -> None:
    file = tmp_path / "some.jsonl"
    journal = Journal(file)
    journal.add("a", "test_one", {"1"}, 0.1)
    journal.add("b", "", {"1", "2"}, 0.1)
    with file.open("a", encoding="utf-8") as out:
        out.write('{"key": "c", "by": "te')  # where a run was ended
    again = Journal(file)
    assert again.killed("a", {"test_one": "1", "test_two": "2"})
    assert not again.killed("a", {"test_one": "3", "test_two": "1"})
    assert not again.killed("a", {"test_two": "1"})
    assert again.killer("a") == "test_one"
    assert again.survived("a") == set()
    assert again.survived("b") == {"1", "2"}
    assert not again.killed("b", {"test_one": "1"})
    assert again.survived("c") == set()
    again.add("b", "test_two", {"2"}, 0.1)
    assert Journal(file).killed("b", {"test_two": "2"})
    assert len(file.read_text(encoding="utf-8").splitlines()) == 2


@pytest.mark.parametrize(
    ("killed", "run", "listed", "left"),
    [
        ("abc", "abc", "", 0),
        ("ab", "abc", "", 1),
        ("ab", "abc", "c", 0),
        ("ab", "ab", "c", 0),
        ("ab", "ab", "", 1),
        ("", "", "", 3),
    ],
)
def test_what_is_neither_killed_nor_explained_is_counted(
    killed: str, run: str, listed: str, left: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert report("some", {"a": 1, "b": 2, "c": 3}, set(killed), set(run), set(listed)) == left
    told = capsys.readouterr().out
    assert ("survives, line 3: c" in told) == (left == 1 and "c" in run)
    assert ("not run" in told) == (len(run) < 3)


def test_what_is_listed_in_vain_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    report("some", {"a": 1}, {"a"}, {"a"}, {"a", "gone"})
    told = capsys.readouterr().out
    assert told.count("but killed or gone") == 2
