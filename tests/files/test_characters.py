"""Characters that command a terminal, or show a text as another, are refused wherever a text is
read.
"""

import hashlib
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.files import journal, own, storage
from spragsym.report.friction_curve import read_friction
from spragsym.results.files import _digest, _text
from tests.support import ROOT

#: Commands of terminals, ends of lines, marks of direction, and what is not seen.
TEXTS = [
    "\x1b[31mred",
    "\x1b]0;title\x07",
    "bell\x07",
    "back\x08\x08",
    "over\rwritten",
    "two\nlines",
    "a\ttab",
    "NUL\x00",
    "\x7fdelete",
    "\x9b31mC1",
    "\x85next",
    "\u202eevil",
    "\u2066isolate\u2069",
    "\u200eleft",
    "zero\u200bwidth",
    "soft\u00adhyphen",
    "\u2028line",
    "\u2029paragraph",
    "\ufeffmark",
    "\x0cform",
]
FOLDS = ss.folds(ss.Parameters.article())
Place = Callable[[Path, str], Any]


def title(folder: Path, text: str) -> Any:
    return brake(folder, f"title = {json.dumps(text)}")


def date(folder: Path, text: str) -> Any:
    return brake(folder, f"date = {json.dumps(text)}")


def key(folder: Path, text: str) -> Any:
    return brake(folder, f'{json.dumps(text)} = "1 kg"')


def name_of_a_file(folder: Path, text: str) -> Any:
    return brake(folder, f"friction = {json.dumps(text)}")


def comment(folder: Path, text: str) -> Any:
    """Of these TOML itself allows a tab, and a line end ends it."""
    return brake(folder, f"# {text.replace(chr(10), chr(27)).replace(chr(9), chr(27))}")


def brake(folder: Path, line: str) -> Any:
    lines = (ROOT / "spragsym/report/brake.toml").read_text(encoding="utf-8")
    (folder / "brake.toml").write_bytes(f"{lines}\n{line}\n".encode())
    return ss.Study.from_file(folder / "brake.toml")


def measured(folder: Path, text: str) -> Any:
    inside = text.replace("\n", "\x1b").replace("\r", "\x1b").replace("\t", "\x1b")
    (folder / "m.csv").write_bytes(f"v [m/s];mu\n# {inside}\n1;0.3\n2;0.3\n".encode())
    return read_friction(folder / "m.csv")


def result(folder: Path, text: str) -> Any:
    """With a right digest: whoever writes a file can compute it."""
    FOLDS.save(folder / "folds.json")
    held = json.loads((folder / "folds.json").read_text())
    held["result"]["class"][2]["dict"].append(["remarks", text])
    held["sha256"] = _digest(_text(held["result"]))
    (folder / "folds.json").write_text(json.dumps(held))
    return ss.open(folder / "folds.json")


def table(folder: Path, text: str) -> Any:
    data = f"x,reason\n# model: {text}\n# x [1]: a\n1,b\n".encode()
    (folder / "r.csv").write_bytes(storage.sealed(data))
    return storage.read(folder / "r.csv")


def columns_of_netcdf(folder: Path, text: str) -> Any:
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("h5netcdf")
    column, model = ("a", text) if len(text) % 2 else (text, "a")
    words = np.array(["a", column], dtype=object)
    data = xarray.Dataset({"reason": (("x",), words)}, attrs={"model": model})
    (folder / "r.nc").write_bytes(storage.sealed(storage._netcdf(data) + b"\n"))
    return storage.read(folder / "r.nc")


def of_a_model(folder: Path, text: str) -> Any:
    """A folder as another program may seal it."""
    write = pytest.importorskip("spragsym.derive.emit.write", exc_type=ImportError)
    out = Path(shutil.copytree(ROOT / "generated/models/stick_slip", folder / "model"))
    about = json.loads((out / "model.json").read_text(encoding="utf-8"))
    digest = hashlib.sha256((out / "algebra.py").read_bytes()).hexdigest()
    about |= {"files": {"algebra.py": digest}, "digest": write.DIGEST}
    about["summary"] = text.replace("\n", "\x1b")
    sealed = write.sealed_alone(write.as_json(about))
    (out / "model.json").write_text(sealed, encoding="utf-8", newline="\n")
    return ss.load(out)


def point_of_a_journal(folder: Path, text: str) -> Any:
    sweep = journal._Sweep(own.user_key(), "key", 1, 1)
    point = journal._line(sweep.key, "key", [0, [1.0], text])
    (folder / "r.csv.partial").write_bytes(sweep.head() + point)
    with journal.journal(folder / "r.csv", "key", 1) as (done, _):
        return done


PLACES: list[Place] = [
    title,
    date,
    key,
    name_of_a_file,
    comment,
    measured,
    result,
    table,
    columns_of_netcdf,
    of_a_model,
    point_of_a_journal,
]


@pytest.mark.parametrize("place", PLACES, ids=lambda place: place.__name__)
def test_what_is_not_printed_is_refused_wherever_it_is_read(place: Place, tmp_path: Path) -> None:
    asked = 0
    for count, text in enumerate(TEXTS):
        if (place, text) in ((table, "two\nlines"), (columns_of_netcdf, "NUL\x00")):
            continue  # of CSV that is the next line, and netCDF has no NUL
        folder = tmp_path / str(count)
        folder.mkdir()
        with pytest.raises(ss.errors.SpragsymError) as refused:
            place(folder, text)
        message = str(refused.value)
        assert re.search(r"holds the character U\+[0-9A-F]{4}|is not TOML", message), message
        assert not [one for one in message if one in text and not one.isprintable()], text
        asked += 1
    assert asked > 18


def test_letters_of_any_language_are_read(tmp_path: Path) -> None:
    for text in ("Bremse für Wärme, µ₀ ± 10 %", "制动", "тормоз", "مكابح", "naïve – “quoted”"):
        assert brake(tmp_path, f"title = {json.dumps(text, ensure_ascii=False)}").title == text
