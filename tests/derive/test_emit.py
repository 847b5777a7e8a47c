"""``make derive``: the same bytes always, all or nothing, and a plain word when something is missing."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, strategies

from spragsym.derive import __main__ as command
from spragsym.derive.emit import write
from spragsym.derive.emit.targets.c99 import layout
from spragsym.derive.emit.targets.python import algebra as python
from spragsym.derive.kang_nam import article, check, elimination, emission, stability, theorem
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.generated import SOURCE_HASH
from tests.shown import assert_shown, commands
from tests.support import ROOT

COMMITTED = ROOT / "generated"


def files_of(folder: Path) -> dict[str, bytes]:
    """Every generated file below a folder, by relative path; not what the interpreter leaves there."""
    paths = (path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def derive(seed: str, folder: Path, target: Path) -> str:
    """What ``python -m derive`` prints in a folder, under a hash seed."""
    environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
    call = [sys.executable, "-m", "derive", "--out", str(target)]
    done = subprocess.run(call, cwd=folder, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def assert_as_committed(target: Path) -> None:
    committed, fresh = files_of(COMMITTED), files_of(target)
    assert {"equilibrium.py", "ledger.json", "LEDGER.md", "py.typed"} <= committed.keys()
    assert fresh.keys() == committed.keys()
    assert [name for name in fresh if fresh[name] != committed[name]] == []


def test_the_digest_is_that_of_what_is_committed() -> None:
    texts = {name: content.decode().replace(SOURCE_HASH, write.DIGEST) for name, content in files_of(COMMITTED).items()}
    sealed = write.sealed({name: text.replace(SOURCE_HASH[:16], write.DIGEST[:16]) for name, text in texts.items()})
    assert {name: text.encode() for name, text in sealed.items()} == files_of(COMMITTED)


@pytest.mark.validate
def test_regeneration_is_byte_identical(tmp_path: Path) -> None:
    """From another working directory; it prints what the README shows, but for its times."""
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    target = tmp_path / "generated"
    printed = derive("12345", elsewhere, target)
    assert_as_committed(target)
    shown = dict(commands(ROOT / "README.md"))["make derive"].split("-m derive\n")[1]
    times = re.compile(r"^ *\d+\.\d\d s", re.MULTILINE)
    assert_shown(times.sub("s", shown), times.sub("s", printed))


@pytest.mark.validate
def test_regeneration_does_not_depend_on_the_order_of_sets(tmp_path: Path) -> None:
    derive("1", ROOT, tmp_path / "generated")
    assert_as_committed(tmp_path / "generated")


OLD = {"ledger.json": b"{}\n", "old.py": b"old\n"}


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


# --------------------------------------------------------------------------------------------- a failed check


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out the steps before the check, and the shipped pages, which other tests run."""
    monkeypatch.setattr(command, "models", lambda **_: {})
    for module in (command.elimination, command.catastrophe, command.lowest_fold, command.linear_sprag, command.page_equivalence):
        monkeypatch.setattr(module, "identities", lambda: {})


def print_wrongly(monkeypatch: pytest.MonkeyPatch) -> None:
    """Set (A2) with a sign turned."""
    printed = tuple(
        article._appendix("A2", entry.latex, -entry.expression) if entry.id == "A2" else entry for entry in article.APPENDIX
    )
    changed = tuple(entry for entry in printed if entry.id in ("A2", "A5"))
    monkeypatch.setattr(check, "run", lambda: _run(changed))


_run = check.run


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
def test_a_variant_is_written_in_spite_of_the_print(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    print_wrongly(monkeypatch)
    monkeypatch.setattr(emission, "render", lambda outcome: {"new.py": "new\n"})
    assert command.main(["--out", str(target), "--variant"]) == 0
    assert files_of(target) == {"new.py": b"new\n"}


#: What is not proved: a function, what it says then, and in which words that is told.
UNPROVED = [
    (theorem, "one_or_three", (theorem.Step("two and two are five", False),), "two and two are five"),
    (elimination, "identities", {"black is white": False}, "black is white"),
]


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize("options", [[], ["--variant"]])
@pytest.mark.parametrize(("module", "name", "found", "words"), UNPROVED, ids=lambda part: part if isinstance(part, str) else "")
def test_what_is_not_proved_writes_nothing(
    module: Any, name: str, found: Any, words: str, options: list[str], target: Path,
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.setattr(check, "run", lambda: [])
    monkeypatch.setattr(theorem, "one_or_three", lambda: ())
    monkeypatch.setattr(module, name, lambda: found)
    assert command.main(["--out", str(target), *options]) == 1
    assert untouched(target)
    assert f"not proved: {words}" in capsys.readouterr().err


def test_an_arrangement_that_is_not_what_was_derived_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    from spragsym.derive.kang_nam.catalogue import stability as functions

    wrong = stability.stiffness().copy()
    wrong[1, 0] = -wrong[1, 0]
    monkeypatch.setattr(stability, "stiffness", lambda: wrong)
    with pytest.raises(ArithmeticError, match=r"K \(28\)"):
        functions.module()


# ----------------------------------------------------------------------------------------- interrupted writes


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError, MemoryError])
def test_an_interrupted_write_leaves_the_old_files(
    error: type[BaseException], target: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_text = Path.write_text

    def interrupted(self: Path, text: str, **options: str) -> int:
        if self.name == "second.py":
            write_text(self, text[:1])
            raise error
        return write_text(self, text, **options)

    monkeypatch.setattr(Path, "write_text", interrupted)
    with pytest.raises(error):
        write.write({"first.py": "1\n", "second.py": "2\n"}, target)
    assert untouched(target)


def test_a_failed_exchange_brings_the_old_files_back(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rename = Path.rename

    def failing(self: Path, to: Path) -> Path:
        if Path(to) == target and not self.name.endswith("-old"):
            raise OSError("no")
        return rename(self, to)

    monkeypatch.setattr(Path, "rename", failing)
    with pytest.raises(OSError, match="no"):
        write.write({"new.py": "new\n"}, target)
    assert untouched(target)


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_during_the_exchange_waits_for_its_end(target: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import signal

    rename = Path.rename

    def interrupted(self: Path, to: Path) -> Path:
        signal.raise_signal(signal.SIGINT)
        return rename(self, to)

    monkeypatch.setattr(Path, "rename", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write.write({"new.py": "new\n"}, target)
    assert files_of(target) == {"new.py": b"new\n"}
    assert list(target.parent.iterdir()) == [target]


def test_a_write_replaces_everything(target: Path) -> None:
    write.write({"new.py": "a\n", "c/deep.h": "b\n"}, target)
    assert files_of(target) == {"new.py": b"a\n", "c/deep.h": b"b\n"}
    assert list(target.parent.iterdir()) == [target]


# ------------------------------------------------------------------------------------------------ the printer


@pytest.mark.parametrize("expression", [sp.Rational(1, 3), sp.Float(0.5) * nm.x, nm.x ** sp.Rational(2, 3)])
def test_what_would_be_rounded_is_refused(expression: sp.Expr) -> None:
    with pytest.raises(ArithmeticError):
        python.AlgebraPrinter({"order": None}).doprint(expression)


@pytest.mark.parametrize("number", [sp.Rational(1, 2), sp.Rational(-7, 3), sp.Integer(2)])
def test_a_sum_with_a_fraction_stands_over_one_denominator(number: sp.Rational) -> None:
    """In exact numbers the printed text has the value, whatever multiplies the sum."""
    x, y = sp.symbols("x y")
    for expression in (x**-1 / 2 - 3 * y + number, y * (x + number), (x / 4 + number) / (y - number)):
        text = python.AlgebraPrinter({"order": None}).doprint(expression)
        value = eval(text, {"x": Fraction(3, 7), "y": Fraction(-5, 11)})  # noqa: S307  # the text is the printer's
        expected = expression.subs({x: sp.Rational(3, 7), y: sp.Rational(-5, 11)})
        assert isinstance(value, Fraction)
        assert value == Fraction(int(expected.p), int(expected.q))


# ---------------------------------------------------------------------------------------------- missing SymPy


def test_missing_sympy_names_the_extra(tmp_path: Path) -> None:
    hidden = "import runpy, sys; sys.modules['sympy'] = None; runpy.run_module('derive', run_name='__main__')"
    outcome = subprocess.run(
        [sys.executable, "-c", hidden, "--out", str(tmp_path / "out")],
        cwd=ROOT, capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert outcome.returncode == 1
    assert outcome.stderr.strip() == "derive: SymPy is missing; in the source folder: pip install '.[derive]'"
    assert not (tmp_path / "out").exists()


def test_usage_is_exit_code_2(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        command.main(["--no-such-option"])
    assert stop.value.code == 2
    assert "usage" in capsys.readouterr().err


@pytest.mark.thorough
@given(strategies.text())
def test_a_comment_of_c_ends_where_it_ends(words: str) -> None:
    said = layout.comment(words)
    assert said.isascii()
    assert said.count("*/") == said.count("/*") == 1


def test_signs_keep_their_meaning() -> None:
    assert layout.plain("γ ≠ λ₂ Ω̃ ½ 45° Müller ά") == "gamma != lambda2 Omega~ [vulgar fraction one half] 45 degrees Muller alpha"
