"""What comes from outside passes one reader, what is shown one writer for each format."""

import ast
import hashlib
import importlib
import json
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import spragsym as ss
from spragsym.core.shown import html_text, json_text, markdown_code, markdown_text, visible
from spragsym.files import cache, journal, own
from spragsym.files.text import contents, json_of, toml_of
from spragsym.papers import PaperCheck
from tests.support import ROOT

Run = Callable[..., str]
#: Modules that read by other means: what, and by which calls, each as often as it stands there;
#: nothing of these is foreign.
OTHERS = {
    "spragsym/files/text.py": (
        "the reader itself",
        "json.loads open os.open read_text tomllib.loads",
    ),
    "spragsym/files/storage.py": (
        "names of new files; verified bytes",
        "open open_dataset os.open os.open",
    ),
    "spragsym/files/journal.py": ("a journal, bounded there", "FileIO os.open"),
    "spragsym/files/cache.py": ("files of the package, for a digest", "read_bytes"),
    "spragsym/files/own.py": ("a new file, for the user's key", "open"),
    "spragsym/matrices/files.py": ("bytes of the reader, without objects", "np.load np.load"),
    "spragsym/models/load.py": (
        "the package; code whose digests were verified, if it is trusted",
        "compile exec read_text",
    ),
    "spragsym/papers.py": ("what a process of its own is told", "open read_text"),
    "spragsym/article/ledger.py": (
        "files of the package",
        "json.loads json.loads tomllib.loads",
    ),
    "spragsym/figures/cycles.py": ("a file of the package", "json.loads"),
    "spragsym/orbits/proofs.py": ("the output of a process of its own", "json.loads"),
    "spragsym/orbits/ball_proof.py": ("the input of a process of its own", "json.load"),
    "spragsym/motion/sweeps/workers.py": ("messages of processes of its own", "pickle.loads"),
    "spragsym/core/limits.py": ("the size of this process", "read_text"),
    "spragsym/core/extensions.py": ("sources of the package", "read_text read_text"),
    "spragsym/results/__init__.py": ("a file of the package", "read_text"),
    "spragsym/__init__.py": ("a module of the package", "exec_module"),
    "spragsym/explorer/page.py": ("files of the package", " ".join(["read_text"] * 4)),
    "spragsym/cli/__init__.py": ("streams that are closed", "os.fdopen os.open os.open"),
    "spragsym/cli/output.py": ("whether a file is what is written", "read_bytes"),
    "spragsym/cli/pages.py": ("a browser", "webbrowser.open"),
    "spragsym/cli/export.py": ("a page that was derived", "read_text"),
    "derive/pages.py": ("a page that is trusted, bounded there", "compile exec read_text"),
    "derive/emit/write.py": (
        "the mark of a derived folder, bounded there",
        "json.loads read_bytes read_text",
    ),
    "derive/emit/language.py": ("our own files", "read_text read_text"),
    "derive/emit/python/__init__.py": ("our own files", "read_text"),
    "derive/emit/targets/__init__.py": ("our own files", "read_text"),
    "derive/emit/targets/fmu/__init__.py": ("what was compiled", "read_bytes"),
    "derive/statements/papers.py": ("papers of this project", "read_text tomllib.loads"),
    "derive/kang_nam/ledger.py": ("a file of our own", "read_text"),
    "derive/kang_nam/library.py": ("our own files", "exec read_text read_text"),
    "derive/kang_nam/bounds.py": ("our own files", "compile exec"),
}
#: Calls that read or run what they are given, by their last name, and modules of others.
READERS = {
    *("exec", "eval", "compile", "open", "fdopen", "FileIO", "read_text", "read_bytes"),
    *("loadtxt", "genfromtxt", "fromfile", "memmap", "read_csv", "open_dataset"),
    *("exec_module", "run_path", "import_module_from", "unsafe_load", "loads"),
}
MODULES = {"tomllib", "json", "pickle", "marshal", "np", "numpy", "yaml", "shelve", "runpy"}
#: Methods of other things that have such names.
ALIKE = ("re.compile", "polynomial.eval", "files.open", "results.open")


def _readers(path: Path) -> Iterator[str]:
    """The calls of a module that read or run something, each as often as it stands there."""
    nodes = [*ast.walk(ast.parse(path.read_text(encoding="utf-8")))]
    called = {node.func for node in nodes if isinstance(node, ast.Call)}
    for node in nodes:
        if isinstance(node, ast.ImportFrom) and node.module in MODULES - {"numpy"}:
            yield from (f"{node.module}.{one.name}" for one in node.names if "load" in one.name)
        if node in called or not isinstance(node, ast.Call | ast.Attribute):
            continue
        named = ast.unparse(node.func if isinstance(node, ast.Call) else node)
        owner, _, last = named.rpartition(".")
        is_foreign = owner in MODULES and last in ("load", "loads", "run_path", "open")
        if is_foreign or (owner in ("os", "io", "codecs", "webbrowser") and last in READERS):
            yield named
        elif last in READERS and isinstance(node, ast.Call) and named not in ALIKE:
            yield last


def test_nothing_goes_around_the_reader(tmp_path: Path) -> None:
    found: dict[str, list[str]] = {}
    for room in ("spragsym", "derive"):
        for path in sorted((ROOT / room).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            if not name.startswith(("spragsym/derive/", "spragsym/generated/")):
                found[name] = sorted(_readers(path))
    others = {name: sorted(calls.split()) for name, (_, calls) in OTHERS.items()}
    assert {name: calls for name, calls in found.items() if calls} == others
    # What is looked for is found.
    new = tmp_path / "new.py"
    for line in (
        "import json; json.loads(text)",
        "importlib.import_module('json').loads(text)",
        "from json import loads",
        "with open(path) as file: pass",
        "Path(path).open()",
        "read = tomllib.load",
        "exec(compile(text, path, 'exec'))",
        "np.genfromtxt(path)",
        "pickle.load(file)",
        "os.open(path, 0)",
    ):
        new.write_text(line, encoding="utf-8")
        assert [*_readers(new)], line


def test_a_device_or_a_pipe_ends(tmp_path: Path) -> None:
    if not hasattr(os, "mkfifo"):
        pytest.skip("no pipes here")
    os.mkfifo(tmp_path / "paper.toml")
    with pytest.raises(ss.errors.ParameterError, match="more than 1000 bytes"):
        contents("/dev/zero", 1000)
    assert contents(tmp_path / "paper.toml") == b""  # no one writes
    for ask in (ss.check, ss.open, ss.Study.from_file):
        with pytest.raises(ss.errors.ParameterError):
            ask("/dev/zero")


@pytest.mark.parametrize(
    ("read", "text", "reason"),
    [
        (json_of, "[" * 200 + "]" * 200, "more than 100 levels"),
        (json_of, "[" * 100_000, "more than 100 levels"),
        (json_of, "1e400", "beyond double precision"),
        (toml_of, "a = 1e-400", "beyond double precision"),
        (toml_of, f"a = {'[' * 101}{']' * 101}", "more than 100 levels"),
        (toml_of, ".".join(101 * "a") + " = 1", "more than 100 parts"),
        (toml_of, "a = " + 5000 * "9", "digits"),
    ],
)
def test_data_are_bounded(read: Callable[[str], object], text: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        read(text)
    assert json_of("[[1.5e-300]]") == [[1.5e-300]]


HOSTILE = "\x1b]0;evil\x07a\r\n| 7 | forged | <script>\u202e\u2028\x85`x`"


def test_no_format_shows_a_command_a_line_or_markup() -> None:
    for write in (visible, markdown_text, markdown_code, html_text):
        shown = write(HOSTILE)
        assert shown.isprintable(), write
        assert write is visible or "<script>" not in shown
    assert "|" not in markdown_text(HOSTILE).replace("\\|", "")
    assert "<" not in html_text(HOSTILE)
    text = json_text({"a": HOSTILE})
    assert text.isprintable()
    assert json.loads(text)["a"] == HOSTILE


@pytest.mark.thorough
def test_no_row_of_a_paper_is_forged(tmp_path: Path, run: Run) -> None:
    pytest.importorskip("sympy")
    body = json.dumps({"where": HOSTILE, "note": HOSTILE}, ensure_ascii=True)
    where, note = (json.dumps(one) for one in json.loads(body).values())
    paper = tmp_path / "paper.toml"
    paper.write_text(
        f'paper = {where}\nmodel = "stick_slip"\n'
        f'[[statement]]\nid = "1"\nabout = "energy T"\nsympy = "m*vx**2/2"\nnote = {note}\n'
        f'[[statement]]\nid = "2"\nabout = "other"\nlatex = "x"\nwhere = {where}\n',
        encoding="utf-8",
    )
    shown = [run("check", str(paper), "--out", str(tmp_path / "out"))]
    found = ss.check(paper)
    shown += [found.to_markdown(), found.to_html(), str(found), repr(found)]
    shown += [run("check", str(paper), "--row", "2"), run("check", str(paper), "--json")]
    for text in shown:
        assert all(line.isprintable() for line in text.split("\n"))
        assert not any(line.startswith("| 7 |") for line in text.split("\n"))
    assert "<script>" not in found.to_markdown() + found.to_html()
    assert found.rows[0].status == "confirmed"


@pytest.mark.parametrize(
    "latex",
    [
        "\\text{\u202e\x1b} m &#x202e;",
        r"\gdef\a{b} m",
        r"^^5cinput{/etc/passwd} \mu",
        r"\verbatiminput{/etc/passwd} m",
        r"m \catcode`\@=0",
    ],
)
def test_no_formula_of_a_ledger_commands(latex: str) -> None:
    """In HTML no character is hidden; LaTeX with commands beside mathematics is shown as text."""
    pytest.importorskip("sympy")
    verdicts = importlib.import_module("spragsym.derive.statements.verdicts")
    row = verdicts.Row("1", "energy T", "misprint", "confirmed", print=latex, marked=latex)
    found = PaperCheck("", "stick_slip", (), (row,))
    assert found.to_html().replace("\n", "").isprintable()
    letter = found.to_latex()
    assert letter.replace("\n", "").isprintable()
    assert r"\[" not in letter or "text" in latex
    right = replace(row, print=r"\frac{1}{2} m \dot{x}^2")
    assert r"\[\frac{1}{2} m \dot{x}^2\]" in replace(found, rows=(right,)).to_latex()


def structure_of_a_model(folder: Path, key: str, change: Callable[[Any], object]) -> ss.Model:
    """A folder whose description was changed and sealed again, as another program may do."""
    write = pytest.importorskip("spragsym.derive.emit.write", exc_type=ImportError)
    out = Path(shutil.copytree(ROOT / "generated/models/stick_slip", folder / "model"))
    shutil.copy(ROOT / "generated/_broadcast.py", out)
    about = json.loads((out / "model.json").read_text(encoding="utf-8"))
    about[key] = change(about[key]) or about[key]
    digests = {
        name: hashlib.sha256((out / name).read_bytes()).hexdigest()
        for name in ("_broadcast.py", "algebra.py")
    }
    sealed = write.sealed_alone(write.as_json(about | {"files": digests, "digest": write.DIGEST}))
    (out / "model.json").write_text(sealed, encoding="utf-8", newline="\n")
    return ss.load(out)


@pytest.mark.parametrize(
    ("key", "change"),
    [
        ("layers", lambda _: "1"),
        ("contacts", lambda _: {"a": 1}),
        ("contacts", lambda held: held[0].pop("name") and None),
        ("parameters", lambda held: held[0].update(name=1)),
        ("parameters", lambda held: held[0].update(low="0")),
        ("parameters", lambda held: held.append({})),
        ("coordinates", lambda held: held[0].update(comes_around=["a"])),
    ],
)
def test_a_model_of_another_structure_is_refused(
    key: str, change: Callable[[Any], object], tmp_path: Path
) -> None:
    with pytest.raises(ss.errors.StoreError, match="is of another version of spragsym"):
        structure_of_a_model(tmp_path, key, change)


def test_a_model_may_have_what_no_shipped_one_has(tmp_path: Path) -> None:
    found = structure_of_a_model(tmp_path, "parameters", lambda held: held[0].update(low=None))
    assert found.about["parameters"][0]["low"] is None


@pytest.fixture
def entries(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a cache with one entry."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache.cached({"of": 1}, lambda: {"a.txt": "right"}) == {"a.txt": "right"}
    return tmp_path / "spragsym"


@pytest.mark.parametrize("files", [{"../x": "evil"}, {"/x": "evil"}, {}, ["a.txt"], {"a.txt": 1}])
def test_no_entry_that_others_made_is_believed(entries: Path, files: object) -> None:
    (entry,) = entries.glob("*.json")
    head, _, _ = entry.read_bytes().partition(b"\n")
    entry.write_bytes(head + b"\n" + json.dumps(files).encode())
    assert cache.cached({"of": 1}, lambda: {"a.txt": "again"}) == {"a.txt": "again"}
    assert cache.cached({"of": 1}, lambda: {"a.txt": "third"}) == {"a.txt": "again"}


@pytest.mark.skipif(os.name != "posix", reason="links and modes as POSIX has them")
def test_no_link_is_followed_and_no_folder_of_others_is_used(entries: Path) -> None:
    (entry,) = entries.glob("*.json")
    target = entries.parent / "target"
    target.write_text("kept", encoding="utf-8")
    entry.unlink()
    entry.symlink_to(target)
    assert cache.cached({"of": 1}, lambda: {"a.txt": "again"}) == {"a.txt": "again"}
    assert target.read_text(encoding="utf-8") == "kept"
    entries.chmod(0o777)
    made = iter("12")
    for number in "12":
        assert cache.cached({"of": 1}, lambda: {"a.txt": next(made)}) == {"a.txt": number}


@pytest.mark.skipif(os.name != "posix", reason="links as POSIX has them")
def test_a_journal_that_is_a_link_is_not_followed(tmp_path: Path) -> None:
    """Nor is what it leads to made, or a file of another name taken for it."""
    target, victim = tmp_path / "out" / "r.csv", tmp_path / "victim"
    target.parent.mkdir()
    for kept in (None, b""):
        if kept is not None:
            victim.write_bytes(kept)
        for link in (os.symlink, os.link)[: 1 + (kept is not None)]:
            link(victim, journal.path_of(target))
            with pytest.raises(ss.errors.StoreError), journal.journal(target, "key", 1):
                pass
            journal.path_of(target).unlink()
            assert (victim.read_bytes() if victim.exists() else None) == kept
    with journal.journal(target, "key", 1) as (done, _):
        assert not done


def kept_points(target: Path, number: float | None = None) -> dict[int, journal.Record]:
    """The points of a journal of three, which is left as it is, or has one more."""
    with suppress(KeyboardInterrupt), journal.journal(target, "sweep", 3, 1) as (done, keep):
        if number is not None:
            keep(0, ([number], ""))
        raise KeyboardInterrupt
    return done


@pytest.fixture
def begun(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The result of a sweep whose journal has a point."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "mine"))
    kept_points(tmp_path / "r.csv", 7.0)
    return tmp_path / "r.csv"


def test_a_journal_of_another_user_is_refused(begun: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And stays as it is, until its key is there."""
    whole = journal.path_of(begun).read_bytes()
    monkeypatch.setenv("XDG_CACHE_HOME", str(begun.with_name("another's")))
    with pytest.raises(ss.errors.StoreError, match=r"r\.csv\.partial .* set XDG_CACHE_HOME"):
        kept_points(begun)
    assert journal.path_of(begun).read_bytes() == whole
    monkeypatch.setenv("XDG_CACHE_HOME", str(begun.with_name("mine")))
    assert kept_points(begun) == {0: ([7.0], "")}


@pytest.mark.parametrize("signed", ["not", "by its own text", "by another's key", "as another's"])
def test_no_point_that_others_wrote_is_believed(begun: Path, signed: str) -> None:
    """Of the right structure, with the numbers or the reason of another point."""
    kept, text = journal.path_of(begun), json.dumps([1, [7.0], "evil"]).encode()
    line = {
        "not": text,
        "by its own text": hashlib.sha256(b"sweep " + text).hexdigest().encode() + b" " + text,
        "by another's key": journal._line(bytes(32), "sweep", [1, [7.0], "evil"])[:-1],
        "as another's": kept.read_bytes().split(b"\n")[1].replace(b"[0", b"[1"),
    }[signed]
    kept.write_bytes(kept.read_bytes() + line + b"\n")
    with pytest.warns(ss.errors.DamageWarning, match="by their signatures"):
        assert kept_points(begun) == {0: ([7.0], "")}


@pytest.mark.parametrize("home", ["relative", "file"])
def test_a_journal_is_written_where_no_key_can_be_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, home: str
) -> None:
    """For this process alone, as is said."""
    (tmp_path / "file").write_text("", encoding="utf-8")
    monkeypatch.setenv("XDG_CACHE_HOME", home if home == "relative" else str(tmp_path / home))
    lost = r"no process but this one can go on .*r\.csv\.partial.* XDG_CACHE_HOME"
    with pytest.warns(UserWarning, match=lost):
        assert kept_points(tmp_path / "r.csv", 7.0) == {0: ([7.0], "")}
    refused = pytest.raises(ss.errors.StoreError, match="not signed with your key")
    with pytest.warns(UserWarning, match=lost), refused:
        kept_points(tmp_path / "r.csv")


def test_a_key_is_made_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "new"))
    assert len({own.user_key() for _ in range(3)}) == 1
    own.key_path().write_bytes(b"short")
    with pytest.raises(ss.errors.StoreError, match="is damaged"):
        own.user_key()


def test_a_relative_cache_is_no_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", "cache")
    assert cache.cached({"of": 1}, lambda: {"a.txt": "1"}) == {"a.txt": "1"}
    assert not [*tmp_path.iterdir()]
    with pytest.raises(ss.errors.ParameterError, match="absolute path"):
        cache.cache_folder()
