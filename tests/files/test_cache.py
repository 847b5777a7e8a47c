"""An export that was derived before is not derived again, and nothing else is taken for it."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from spragsym.core.errors import ParameterError
from spragsym.files import cache
from spragsym.files.storage import sealed

pytest.importorskip("sympy")

from spragsym.derive import export

Run = Callable[..., str]


@pytest.fixture
def derived(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Any]:
    """The calls of the derivation, each of which makes another file."""
    calls: list[Any] = []

    def made(*given: Any) -> dict[str, str]:
        calls.append(given)
        return {"text": str(len(calls))}

    monkeypatch.setattr(export, "export", made)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return calls


def test_an_export_is_derived_again_where_something_has_changed(
    derived: list[Any], tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = tmp_path / "page.py"
    page.write_text("page = 1", encoding="utf-8")
    monkeypatch.setattr("spragsym.cli.export.page_of", lambda *_: page)

    def exported(language: str = "c") -> str:
        asked = ["--language", language, "--out", str(tmp_path / "out"), "--force"]
        run("export", "--model", "stick_slip", *asked)
        return (tmp_path / "out" / "text").read_text(encoding="utf-8")

    assert [exported(), exported(), exported("jax"), exported()] == ["1", "1", "2", "1"]
    page.write_text("page = 2", encoding="utf-8")
    assert [exported(), exported()] == ["3", "3"]
    monkeypatch.setattr("spragsym.cli.export.digest_of_folder", lambda _: "another derivation")
    assert [exported(), exported()] == ["4", "4"]


def test_what_is_damaged_or_cannot_be_kept_is_made_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    numbers = iter("123456")

    def make() -> dict[str, str]:
        return {"name": next(numbers)}

    assert [cache.cached({"a": 1}, make)["name"] for _ in range(2)] == ["1", "1"]
    (kept,) = cache.cache_folder().iterdir()
    text = kept.read_text(encoding="utf-8")
    for damaged in (text.replace('"1"', '"9"'), text[:-3], "", text + "\n"):
        kept.write_text(damaged, encoding="utf-8")
        assert cache.cached({"a": 1}, make)["name"] in "2345"
    monkeypatch.setenv("XDG_CACHE_HOME", str(kept))  # a file, below which nothing can be kept
    assert cache.cached({"a": 1}, make) == {"name": "6"}


def test_the_oldest_results_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for number in range(5):
        cache.cached({"number": number}, lambda: {"name": "text"}, most=3)
    assert len(list(cache.cache_folder().iterdir())) == 3


def test_the_digest_of_a_folder_has_its_names_and_bytes(tmp_path: Path) -> None:
    digests = set()
    for name, data in (("a", b"bc"), ("ab", b"c"), ("a", b"bd")):
        folder = tmp_path / f"{name}{data!r}"
        folder.mkdir()
        (folder / name).write_bytes(data)
        digests.add(cache.digest_of_folder(folder))
    assert len(digests) == 3


def test_nothing_foreign_in_the_cache_is_believed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Entries that others seal, links, and what others may write."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    right = {"name": "text"}
    cache.cached({}, lambda: right)
    (entry,) = cache.cache_folder().iterdir()
    whole, victim = entry.read_bytes(), tmp_path / "victim"
    for files in ({"../x": "y"}, {"/x": "y"}, {}, [], {"name": "other"}, {"name": 1}):
        entry.write_bytes(sealed(json.dumps(files).encode()))
        assert cache.cached({}, lambda: right) == right
    entry.write_bytes(whole)
    assert cache.cached({}, dict) == right
    entry.chmod(0o666)
    assert cache.cached({}, lambda: {"name": "anew"}) == {"name": "anew"}
    victim.write_bytes(whole)
    entry.unlink()
    entry.symlink_to(victim)
    assert cache.cached({}, lambda: {"name": "anew"}) == {"name": "anew"}
    assert victim.read_bytes() == whole
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    with pytest.raises(ParameterError, match="is relative"):
        cache.cache_folder()
