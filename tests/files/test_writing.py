"""Nothing of a user's is lost: files in place whole, names that nobody can guess, folders that hold
more than ours, Ctrl-C.
"""

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli import main
from spragsym.core.errors import ParameterError, SpragsymError, StoreError
from spragsym.files import storage, text
from spragsym.files.journal import journal
from tests.conftest import Begin
from tests.support import ROOT

PAGE = ROOT / "derive" / "models" / "stick_slip.py"
Run = Callable[..., str]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a derived page."""
    pytest.importorskip("sympy")
    from spragsym.derive import folder as derived

    out = tmp_path_factory.mktemp("derived") / "model"
    derived.write_page(PAGE, out)
    return out


def test_a_user_s_files_beside_and_behind_a_link_stay(tmp_path: Path, run: Run) -> None:
    """``.before`` was deleted, ``.new`` truncated, and a link of that name followed to its
    victim.
    """
    out, names = tmp_path / "d.csv", ("d.csv.before", "d.csv.new")
    for name in names:
        (tmp_path / name).write_text("mine")
    victim = tmp_path / "victim"
    victim.write_text("mine")
    (tmp_path / "e.csv.new").symlink_to(victim)
    grid = shlex.split("--theta0 40,50 --t-end 20 --transient 10 --backend scipy -q --force")
    out.write_text("old")
    run("sweep", *grid, "-o", str(out))
    run("sweep", *grid, "-o", str(tmp_path / "e.csv"))
    assert out.read_text().startswith("theta0")
    assert [(tmp_path / name).read_text() for name in (*names, "victim")] == ["mine"] * 3
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "d.csv",
        *names,
        "e.csv",
        "e.csv.new",
        "victim",
    ]


def test_a_failed_write_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "page.html"
    storage.put(path, "before")
    path.chmod(0o640)

    def full(file: object, data: bytes) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as disk:
        disk.setattr(storage, "write_all", full)
        with pytest.raises(StoreError, match=r"page\.html cannot be written: No space left"):
            storage.put(path, "after")
        with pytest.raises(StoreError, match="No space left"):
            storage.put(tmp_path / "new" / "within" / "page.html", "after", made=True)
    assert (path.read_text(), [entry.name for entry in tmp_path.iterdir()]) == (
        "before",
        ["page.html"],
    )
    # What a killed process has left is removed, what one that runs is at is not.
    left, written = (tmp_path / f".spragsym-{number}-{'0' * 16}" for number in (1, 2))
    for one in (left, written):
        one.write_text("half")
    os.utime(left, (0, 0))
    storage.put(path, "after")
    assert (path.read_text(), path.stat().st_mode & 0o777) == ("after", 0o640)
    assert (left.exists(), written.exists()) == (False, True)


@pytest.mark.parametrize(
    "words",
    [
        ("explore", "--no-open", "--out", "{}/e.html"),
        ("report", "{}/b.toml", "--html", "/dev/null/r.html"),
        ("bifurcation", "--plot", "{}/missing/p.svg"),
        ("figures", "4", "-q", "--out", "/dev/null/figures"),
        ("export", "--out", "/proc/nowhere"),
        ("simulate", "--theta0", "49", "-o", "{}/missing/r.csv"),
    ],
)
def test_a_target_is_tried_before_the_work(
    words: tuple[str, ...], tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "b.toml").write_text(run("report", "--example"))
    if words[0] == "explore":
        (tmp_path / "e.html").symlink_to(tmp_path / "e.html")
    monkeypatch.setattr(storage, "_replace", lambda *_: pytest.fail("the work was done"))
    run(*(word.format(tmp_path) for word in words), code=2)
    assert not (tmp_path / "missing").exists()


def test_deriving_again_leaves_what_others_wrote(folder: Path, tmp_path: Path, run: Run) -> None:
    """``--force`` deleted results, notes, and the page itself."""
    out = Path(shutil.copytree(folder, tmp_path / "proj"))
    for name in ("notes.txt", "results.csv", "mypage.py"):
        (out / name).write_bytes(PAGE.read_bytes())
    run("derive", str(out / "mypage.py"), "--out", str(out), "--force")
    assert all(
        (out / name).read_bytes() == PAGE.read_bytes()
        for name in ("notes.txt", "results.csv", "mypage.py")
    )
    assert ss.load(out).name == "mypage"
    alien = tmp_path / "alien"
    alien.mkdir()
    (alien / "algebra.py").write_text("mine")
    assert "no model.json" in run("derive", str(PAGE), "--out", str(alien), "--force", code=2)
    assert (alien / "algebra.py").read_text() == "mine"


def test_every_changed_byte_of_a_folder_is_refused(folder: Path, tmp_path: Path) -> None:
    rng, wholes = (
        np.random.default_rng(61),
        {path: path.read_bytes() for path in folder.iterdir() if path.is_file()},
    )
    out = Path(shutil.copytree(folder, tmp_path / "model"))
    for _ in range(40):
        path = rng.choice(sorted(wholes))
        data = bytearray(wholes[path])
        place = int(rng.integers(len(data)))
        data[place] ^= int(rng.integers(1, 256))
        (out / path.name).write_bytes(data)
        with pytest.raises(SpragsymError):
            ss.load(out)
        (out / path.name).write_bytes(wholes[path])


def test_the_code_that_runs_is_what_was_verified(folder: Path, tmp_path: Path) -> None:
    """A folder ``algebra`` beside algebra.py, or its cache, was run in its place."""
    out = Path(shutil.copytree(folder, tmp_path / "model"))
    for place in (out / "algebra", out / "_broadcast"):
        place.mkdir()
        (place / "__init__.py").write_text("raise SystemExit('poisoned')")
    model = ss.load(out)
    assert int(ss.equilibria(model.Parameters()).count) == 1


def test_a_data_file_runs_no_code_unasked(folder: Path, tmp_path: Path, run: Run) -> None:
    data = tmp_path / "b.toml"
    text_of = run("report", "--example", "--model", "stick_slip")
    data.write_text(
        text_of.replace('model = "stick_slip"', f'model = "{folder.as_posix()}"'), encoding="utf-8"
    )
    for words in (
        ("report", str(data)),
        ("equilibria", "--data", str(data)),
        ("explore", "--no-open", "--data", str(data)),
    ):
        assert "if you trust it" in run(*words, code=2)
    with pytest.raises(ParameterError, match="whose code runs"):
        ss.Study.from_file(data)
    assert "stable" in run("equilibria", "--data", str(data), "--trust")
    assert run("equilibria", "--data", str(data), "--model", folder.as_posix())


@pytest.mark.skipif(os.name != "posix", reason="pipes and devices")
def test_what_is_read_has_an_end(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert text.contents(tmp_path / "pipe") == b""
    with pytest.raises(ParameterError, match="more than 1048576 bytes"):
        text.contents("/dev/zero")
    with pytest.raises(ParameterError, match="can't be"):
        text.contents("a\0b")
    with pytest.raises(ParameterError, match="device or a pipe"):
        storage.resolved("/dev/null")


@pytest.mark.thorough
@pytest.mark.skipif(os.name != "posix", reason="Windows has no such signal")
@pytest.mark.parametrize("after", [0.15, 0.6, 1.2])
def test_ctrl_c_ends_a_command(after: float, begin: Begin) -> None:
    """While heyoka is imported it was swallowed, or became an ImportError."""
    command = [sys.executable, "-m", "spragsym", "cycles", "--theta0", "42", "--vary", "V=0.05:1.5"]
    process = begin(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    with pytest.raises(subprocess.TimeoutExpired):
        process.wait(after)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=10)
    assert process.returncode in (130, -signal.SIGINT)
    # What comes before the first line of the package, on a machine that is slow to start Python,
    # has no frame of it.
    assert "spragsym" not in said.partition("Traceback")[2]


@pytest.mark.skipif(os.name != "posix", reason="Windows has no such signal")
def test_ctrl_c_where_python_can_not_raise_it_is_raised_at_the_end() -> None:
    """In a callback of a weak reference, as of a lock while a module is imported, it was printed."""
    code = """
import signal, weakref
from spragsym.core.interrupts import begun, ending
signal.signal(signal.SIGINT, signal.default_int_handler)  # it is ignored in a script with &
begun()
gone = set()
reference = weakref.ref(gone, lambda _: signal.raise_signal(signal.SIGINT))
try:
    with ending():
        del gone
        print("went on")
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (done.stdout.split(), done.stderr) == (["went", "on", "interrupted"], "")


@pytest.mark.thorough
@pytest.mark.skipif(os.name != "posix", reason="Windows has no such signal")
def test_a_job_in_the_background_ignores_ctrl_c() -> None:
    """As a shell without job control starts it: what ends the script in front of it does not end
    the job.
    """
    ask = f"{sys.executable} -m spragsym equilibria --theta0 49 & sleep 0.4; kill -INT $!; wait $!"
    done = subprocess.run(["sh", "-c", ask], capture_output=True, text=True, timeout=60)
    assert (done.returncode, "contact" in done.stdout) == (0, True)


def test_one_process_alone_works_on_a_journal_and_a_killed_process_holds_nothing(
    tmp_path: Path, begin: Begin
) -> None:
    path = tmp_path / "rms.csv"
    code = (
        "import sys, time; from pathlib import Path; from spragsym.files.journal import journal\n"
        "with journal(Path(sys.argv[1]), 'a', 2): print('held', flush=True); time.sleep(100)"
    )
    other = "is being written by another process or thread; wait for it to end"
    with journal(path, "a", 2), pytest.raises(StoreError, match=other):
        journal(path, "a", 2).__enter__()
    process = begin([sys.executable, "-c", code, str(path)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "held\n"
    with pytest.raises(StoreError, match=other):
        journal(path, "a", 2).__enter__()
    process.kill()
    process.wait()
    with journal(path, "a", 2):
        pass


def test_room_that_is_wanted_is_told_from_room_that_there_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(78)
    for size in (*10 ** rng.uniform(3, 13, 40), 1e6):
        free = int(size)
        usage = shutil._ntuple_diskusage(2 * free, free, free)  # type: ignore[attr-defined]
        monkeypatch.setattr(shutil, "disk_usage", lambda _, usage=usage: usage)
        with pytest.raises(ParameterError) as refused:
            storage.probe(tmp_path / "r.csv", free + 1)
        found = re.search(r"about (\d+) kB are needed and (\d+) kB are free", str(refused.value))
        assert found is not None
        assert int(found[1]) > int(found[2])


@pytest.mark.parametrize("value", [None, 3, b"x.csv", 1.5, ["x.csv"]])
def test_what_is_no_path_is_refused(value: Any) -> None:
    found = ss.folds(ss.Parameters.article())
    asked: list[Callable[[], object]] = [
        lambda: ss.open(value),
        lambda: ss.Study.from_file(value),
        lambda: found.save(value),
        lambda: ss.rms_sweep(ss.Parameters.article(theta0=0.8), t_end=1.0, store=value),
    ]
    for ask in asked[: 3 if value is None else 4]:
        with pytest.raises(ss.errors.ParameterTypeError, match="is no path"):
            ask()


def test_files_that_do_not_fit_are_not_begun(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An export has several, of which none is written where the disk has room for the first."""
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=20_000))
    with pytest.raises(SystemExit) as stop:
        main(["export", "--language", "c", "--out", str(tmp_path / "sprag")])
    assert stop.value.code == 2
    assert not [*tmp_path.iterdir()]
