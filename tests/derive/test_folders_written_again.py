"""A folder that is derived again: what is not ours, or was edited, stays byte for byte, whatever
lies there.
"""

import errno
import hashlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("sympy")

from spragsym.derive import folder as of_models
from spragsym.derive.emit import write

Files = dict[str, str]
#: Lists of ``python -m derive`` and of ``spragsym derive``.
MARKS = ("files.json", of_models.MARK)
OLD_FILES = {"algebra.py": "old\n", "page.py": "old page\n", "gone.py": "gone\n"}
NEW_FILES = {"algebra.py": "new\n", "page.py": "new page\n", "sub/fresh.py": "fresh\n"}
MARK = of_models.MARK
OLD, NEW = write.listed(OLD_FILES, MARK, name="brake"), write.listed(NEW_FILES, MARK, name="brake")


def all_of(folder: Path) -> dict[str, tuple[bytes | str, int]]:
    """Every file, link and folder with its content and mode."""
    found = {}
    for path in sorted(folder.rglob("*")):
        held: bytes | str = b"" if path.is_dir() else path.read_bytes()
        held = os.readlink(path) if path.is_symlink() else held
        found[str(path.relative_to(folder))] = (held, path.lstat().st_mode)
    return found


def written(folder: Path, files: Files) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def layout(rng: np.random.Generator, folder: Path, mark: str) -> set[str]:
    """Some folder that a user may name; the names of what is ours there, by our own sealed list."""
    old = write.listed(OLD_FILES, mark)
    written(folder, old)
    ours = set(old)
    kind = int(rng.integers(9))
    text = old[mark]
    about = json.loads(text)
    mine = {"data.csv": "1,2\n", "results/one.nc": "x", "notes.txt": "mine"}
    written(folder, {name: held for name, held in mine.items() if rng.random() < 0.7})
    names = [name for name in mine if (folder / name).exists()]
    if kind == 1:  # the list of another program
        text = json.dumps({"files": dict.fromkeys([*names, "algebra.py"], "0")})
    elif kind == 2:  # a bare list
        text = json.dumps([*names, *old])
    elif kind == 3:  # an entry added by hand, with its right digest
        for name in names:
            data = (folder / name).read_bytes()
            about["files"][name] = hashlib.sha256(data).hexdigest()
        about["note"] = "by hand"
        text = json.dumps(about)
    elif kind == 4:  # cut, or changed by a bit
        text = text[: int(rng.integers(len(text)))]
    elif kind == 5:
        (folder / mark).unlink()
    elif kind == 6:  # edited by the user
        name = str(rng.choice(["algebra.py", "page.py", "gone.py"]))
        (folder / name).write_text("edited\n")
    elif kind == 7:  # in the way
        written(folder, {"sub/fresh.py": "mine"})
    elif kind == 8:  # a link, or a folder, in the place of a file
        name = str(rng.choice(["algebra.py", "gone.py"]))
        (folder / name).unlink()
        if rng.random() < 0.5:
            (folder / name).symlink_to(written(folder, {"behind.py": old[name]}) / "behind.py")
        else:
            written(folder / name, {"inside.txt": "mine"})
    if kind in (1, 2, 3, 4):
        (folder / mark).write_text(text)
    return ours if kind == 0 else set()


def test_two_hundred_layouts_lose_no_byte(tmp_path: Path) -> None:
    rng = np.random.default_rng(7601)
    done = 0
    for count in range(200):
        folder, mark = tmp_path / str(count), MARKS[count % 2]
        new = write.listed(NEW_FILES, mark)
        ours = layout(rng, folder, mark)
        before = all_of(folder)
        try:
            write.write(new, folder, mark=mark)
        except FileExistsError:
            assert all_of(folder) == before
            continue
        done += 1
        after = all_of(folder)
        assert {name: before[name] for name in before if name not in ours}.items() <= after.items()
        assert all((folder / name).read_text() == text for name, text in new.items())
        assert not (folder / "gone.py").exists()
        assert not [name for name in after if name.startswith(".")]
    assert 10 < done < 60


def test_what_was_edited_is_named(tmp_path: Path) -> None:
    for name in ("page.py", "algebra.py", "gone.py"):
        folder = written(tmp_path / name, OLD)
        (folder / name).write_text("edited\n")
        with pytest.raises(FileExistsError, match=f"{name}: edited since it was written; move it"):
            write.write(NEW, folder, mark=MARK)
    folder = written(tmp_path / "foreign", OLD | {"sub/fresh.py": "mine"})
    with pytest.raises(FileExistsError, match=r"fresh\.py: written by something else; move it"):
        write.write(NEW, folder, mark=MARK)
    # The page from which it is derived again may be the one in the folder.
    folder = written(tmp_path / "again", {**OLD, "page.py": NEW["page.py"]})
    write.write(NEW, folder, mark=MARK)
    assert (folder / "algebra.py").read_text() == "new\n"


FULL = OSError(errno.ENOSPC, "No space left on device")


class Failing:
    """A function of the system that fails at its n-th call, or from there on."""

    def __init__(
        self, function: Callable[..., Any], n: int, on: bool, error: BaseException = FULL
    ) -> None:
        self.function, self.left, self.on, self.error = function, n, on, error

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        self.left -= 1
        if self.left == 0 or (self.on and self.left < 0):
            raise self.error
        return self.function(*arguments, **options)


STEPS: list[tuple[Any, str]] = [
    (os, "replace"),
    (os, "link"),
    (shutil, "copy2"),
    (tempfile, "mkdtemp"),
    (Path, "mkdir"),
    (Path, "unlink"),
    (Path, "write_text"),
]


@pytest.mark.parametrize(
    ("on", "error"),
    [(False, FULL), (True, FULL), (False, KeyboardInterrupt()), (False, MemoryError())],
    ids=["once", "from then on", "interrupted", "without memory"],
)
def test_a_step_that_fails_leaves_every_byte(
    on: bool, error: BaseException, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    failed = 0
    for owner, name in STEPS:
        for n in range(1, 12):
            folder = written(tmp_path / f"{name}{n}", {**OLD, "data.csv": "mine"})
            before = all_of(folder)
            with monkeypatch.context() as patched:
                function = Failing(getattr(owner, name), n, on, error)
                patched.setattr(owner, name, lambda *a, f=function, **k: f(*a, **k))
                if name == "copy2":  # it is asked where there are no links
                    patched.setattr(os, "link", Failing(os.link, 1, True))
                try:
                    write.write(NEW, folder, mark=MARK)
                    ended = True
                except type(error):
                    ended = False
            if ended:
                assert (folder / "algebra.py").read_text() == "new\n"
                continue
            failed += 1
            after = all_of(folder)
            kept = [path for path in after if "-kept-" in path]
            if kept:  # nothing could be put back, and nothing is lost
                held = {data for data, _ in after.values()}
                assert {data for data, _ in before.values()} <= held
            else:
                assert after == before
    assert failed > 20
