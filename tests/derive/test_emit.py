"""``make derive``: the same bytes always, all or nothing, and a plain word when something is
missing.
"""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from spragsym.derive import __main__ as command
from spragsym.derive.emit import write
from spragsym.derive.kang_nam import article, elimination, emission, ledger, theorem
from spragsym.generated import SOURCE_HASH
from tests.support import ROOT

COMMITTED = ROOT / "generated"


def files_of(folder: Path) -> dict[str, bytes]:
    """Every generated file below a folder, by relative path; not what the interpreter leaves
    there.
    """
    paths = (
        path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts
    )
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def test_the_digest_is_that_of_what_is_committed() -> None:
    texts = {
        name: content.decode().replace(SOURCE_HASH, write.DIGEST)
        for name, content in files_of(COMMITTED).items()
        if name != "files.json"
    }
    sealed = write.sealed(
        {name: text.replace(SOURCE_HASH[:16], write.DIGEST[:16]) for name, text in texts.items()}
    )
    written = write.listed(sealed)
    assert {name: text.encode() for name, text in written.items()} == files_of(COMMITTED)


OLD = {name: text.encode() for name, text in write.listed({"old.py": "old\n"}).items()}


@pytest.fixture
def target(tmp_path: Path) -> Path:
    """A folder with an older generation in it."""
    folder = tmp_path / "generated"
    folder.mkdir()
    for name, text in OLD.items():
        (folder / name).write_bytes(text)
    return folder


def untouched(target: Path) -> bool:
    """Whether the older generation is all there is, and nothing was left beside it."""
    return files_of(target) == OLD and list(target.parent.iterdir()) == [target]


# ------------------------------------------------------------------------------------------------
# a failed check


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out the steps before the check, and the shipped pages, which other tests run."""
    monkeypatch.setattr(command, "models", lambda _: {})
    for module in (
        command.elimination,
        command.catastrophe,
        command.lowest_fold,
        command.linear_sprag,
        command.page_equivalence,
    ):
        monkeypatch.setattr(module, "identities", lambda: {})


def print_wrongly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Set (A2) with a sign turned."""
    kept = [it for it in article.printed().statements if it.id in ("A2", "A5", "A10", "A11")]
    wrong = kept[0].text.replace(r"\sigma + ", r"\sigma - ", 1)
    assert wrong != kept[0].text
    changed = (replace(kept[0], text=wrong), *kept[1:])
    paper = replace(article.printed(), statements=changed)
    monkeypatch.setattr(ledger, "run", lambda: _run(paper))


_run = ledger.run


@pytest.mark.thorough
@pytest.mark.usefixtures("quick")
def test_a_failed_check_writes_nothing_and_names_the_row(
    target: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    print_wrongly(monkeypatch)
    assert command.main(["--out", str(target)]) == 1
    assert untouched(target)
    told = capsys.readouterr().err
    assert "A2 (Appendix A, (A2))" in told
    assert "A5" not in told
    assert "difference:" in told
    assert "untouched" in told


@pytest.mark.thorough
@pytest.mark.usefixtures("quick")
def test_a_variant_is_written_in_spite_of_the_print(
    target: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    print_wrongly(monkeypatch)
    monkeypatch.setattr(emission, "render", lambda outcome, models: {"new.py": "new\n"})
    assert command.main(["--out", str(target), "--variant"]) == 0
    written = write.listed({"new.py": "new\n"})
    assert files_of(target) == {name: text.encode() for name, text in written.items()}


#: What is not proved: a function, what it says then, and in which words that is told.
UNPROVED = [
    (
        theorem,
        "one_or_three",
        (theorem.Step("two and two are five", False),),
        "two and two are five",
    ),
    (elimination, "identities", {"black is white": False}, "black is white"),
]


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("options", [[], ["--variant"]])
@pytest.mark.parametrize(
    ("module", "name", "found", "words"),
    UNPROVED,
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_what_is_not_proved_writes_nothing(
    module: Any,
    name: str,
    found: Any,
    words: str,
    options: list[str],
    target: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(ledger, "run", lambda: [])
    monkeypatch.setattr(theorem, "one_or_three", lambda: ())
    monkeypatch.setattr(module, name, lambda: found)
    assert command.main(["--out", str(target), *options]) == 1
    assert untouched(target)
    assert f"not proved: {words}" in capsys.readouterr().err
