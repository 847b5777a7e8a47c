"""The command line: output, exit codes, errors on one line, and nothing else whatever the arguments."""

from __future__ import annotations

import io
import json
import math
import os
import re
import shlex
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeAlias

import click
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import spragsym as ss
from spragsym import cli as command_line
from spragsym import progress
from spragsym.cli import COMMANDS, cli, main
from spragsym.cli.points import print_points
from spragsym.cli.spans import Span
from spragsym.cli.tables import print_table
from spragsym.files import storage
from tests.conftest import Run
from tests.support import LONG_MOTIONS_TAKE_MINUTES, NO_ENVIRONMENT, ROOT, few, needs_posix

#: Exit codes that are documented.
DONE, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130


def invoke(*arguments: str) -> int:
    """Run a command in this process; its exit code."""
    with pytest.raises(SystemExit) as stop:
        main(list(arguments))
    assert isinstance(stop.value.code, int)
    return stop.value.code


#: Starts a command in a process of its own, as ``start("check", cwd=folder, NAME="value")``.
Start: TypeAlias = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture
def start(begin: Callable[..., subprocess.Popen[str]]) -> Start:
    def command(*arguments: str, cwd: Path | None = None, **environment: str) -> subprocess.Popen[str]:
        return begin(
            [sys.executable, "-m", "spragsym", *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=cwd, env={**os.environ, **environment},
        )  # fmt: skip

    return command


# -------------------------------------------------------------------------------------------------------- results


def test_every_digit_that_a_table_shows_is_right(capsys: pytest.CaptureFixture[str]) -> None:
    assert invoke("equilibria", "--theta0", "49") == DONE
    shown, silence = capsys.readouterr()
    assert silence == ""
    header, *rows = shown.splitlines()
    assert header.split()[:2] == ["state", "stability"]
    assert [row.split()[:3] for row in rows] == [["contact", "flutter", "stable"], ["lift-off", "divergent", "divergent"]]
    digits = rows[0].split()[header.split().index("x")]
    assert float(digits) == pytest.approx(1.21742364817816844590957746961, abs=0.51 * 10.0 ** -len(digits.partition(".")[2]))
    assert not any(row.endswith(" ") for row in (header, *rows))


def test_bifurcation_json(run: Run) -> None:
    found = json.loads(run("bifurcation", "--json"))
    turns = np.radians([row["theta0_deg"] for row in found["folds"]["points"]])
    np.testing.assert_allclose(turns, ss.folds(ss.Parameters.article()).theta0)
    assert [row["mu0"] for row in found["cusps"]["points"]] == [ss.cusp_friction(ss.Parameters.article())]
    assert found["onsets"]["points"] == []
    assert all(found[name]["complete"] for name in ("folds", "onsets", "cusps"))


@pytest.mark.parametrize(("asked", "at_this_angle"), [(["--theta0", "40"], True), (["--vary", "theta0", "--mu0", "0.7"], False)])
def test_the_friction_of_the_jump_is_told_where_the_angle_is_given(asked: list[str], at_this_angle: bool, run: Run) -> None:
    assert ("mu0_jump: mu0 of the jump at this angle" in run("critical", *asked)) == at_this_angle


@pytest.mark.validate
def test_what_is_undecided_is_not_called_none(run: Run) -> None:
    text = run("critical", "--model", "trolley", "--theta0", "40")
    for line in ("mu0_lowest: no jump below this mu0", "mu0_cusp: mu0 of the lowest cusp"):
        assert re.search(rf"^{line}\s+unknown$", text, re.MULTILINE)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", few(["pdf", "png", "svg"], "svg"))
def test_bifurcation_draws(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    assert invoke("bifurcation", "--plot", str(tmp_path / f"a.{kind}")) == DONE
    assert (tmp_path / f"a.{kind}").stat().st_size > 1000
    shown, said = capsys.readouterr()
    assert shown.startswith("Folds")
    assert said == f"drew {tmp_path}/a.{kind}\n"


@pytest.mark.usefixtures("checked")
def test_check_prints_every_row(run: Run) -> None:
    rows = json.loads(run("check", "--json"))
    assert len(rows) == 53
    assert [row["id"] for row in rows if row["status"] == "misprint"] == ["eq-6", "eq-9", "eq-13", "def-n", "A1-d0"]


@pytest.mark.usefixtures("checked")
def test_check_of_single_rows(run: Run) -> None:
    rows = [row["id"] for row in json.loads(run("check", "--row", "eq-9", "--row", "def-", "--json"))]
    assert "eq-9" in rows
    assert len(rows) > 3
    assert all(row == "eq-9" or row.startswith("def-") for row in rows)
    for row, remedy in (("eq-99", "eq-9"), ("fig-7", "--claims")):
        assert remedy in run("check", "--row", row, code=USAGE)


def test_check_fails_where_a_row_is_not_as_recorded(checked: list[Any], monkeypatch: pytest.MonkeyPatch, run: Run) -> None:
    from spragsym.derive.kang_nam import check as derivation

    monkeypatch.setattr(derivation, "run", lambda: checked[1:])
    assert "eq-1 is not as recorded" in run("check", code=FAILED)


@pytest.mark.parametrize(
    ("asked", "said"), [(["--row", "eq-9"], "deriving the equations"), (["--claims", "--row", "claim-mu-cr"], "claim-mu-cr")]
)
def test_a_check_that_takes_long_says_what_it_is_at(
    asked: list[str], said: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from spragsym.claims import ledger
    from spragsym.derive.kang_nam import check as derivation

    def slowly(run: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *arguments: (time.sleep(0.2), run(*arguments))[1]

    monkeypatch.setattr("spragsym.progress.LONG", 0.02)
    monkeypatch.setattr(derivation, "run", slowly(lambda: []))
    monkeypatch.setattr(ledger, "_row", slowly(ledger._row))
    invoke("check", *asked)
    assert re.search(rf"{said}.*: 0 s so far", capsys.readouterr().err)


@pytest.mark.parametrize("theta0_deg", few(["30", "49", "1e-9", "179.99"], "49", "179.99"))
@pytest.mark.parametrize("command", ["equilibria", "bifurcation"])
def test_tables_fit_a_terminal_of_80_columns(command: str, theta0_deg: str, run: Run) -> None:
    angle = ["--theta0", theta0_deg] if command == "equilibria" else ["--mu0", str(float(theta0_deg) / 100)]
    assert max(map(len, run(command, *angle).splitlines())) <= 80


def test_angles_have_one_heading(run: Run) -> None:
    """Every heading of an angle, in every command, ends in _deg."""
    text = run("equilibria", "--theta0", "30") + run("bifurcation", "--alpha", "0.7", "--undamped")
    assert set(re.findall(r"\S*theta\S*\b", text)) == {"theta0_deg", "theta_deg"}


# ------------------------------------------------------------------------------------------------ files in the way

MOTION = ["--theta0", "49", "--t-end", "20", "--backend", "scipy"]

#: Command that writes → what it writes to, given a folder.
WRITING = {
    "bifurcation": (["bifurcation", "--plot"], "a.svg"),
    "equilibria": (["equilibria", "--model", "mode_coupling", "--vary", "mu0=0:1", "--plot"], "a.svg"),
    "onsets": (
        ["onsets", "--model", "stick_slip", "--vary", "V=0.1:0.4", "--vary", "zeta=0.5:1.5", "--n", "4", "--plot"],
        "a.svg",
    ),
    "check": (["check", "--report"], "a.md"),
    "report": (["report", "--no-oscillation", str(Path(ss.__file__).parent / "studies/brake.toml"), "--html"], "a.html"),
    "simulate": (["simulate", *MOTION, "-o"], "a.csv"),
    "cycles": (["cycles", "--theta0", "42", "--vary", "theta0=41.9:42.1", "--plot"], "a.svg"),
    "sweep": (["sweep", *MOTION, "--quiet", "-o"], "a.csv"),
    "fates": (["fates", "--theta0", "30,35", "--quiet", "-o"], "a.csv"),
    "figures": (["figures", "--only", "3", "--quiet", "-j", "1", "--out"], "figure_3.pdf"),
    "explore": (["explore", "--no-open", "--out"], "a.html"),
    "export": (["export", "--out"], "spragsym.c"),
    "derive": (["derive", str(ROOT / "derive/models/stick_slip.py"), "--out"], "model.json"),
}

#: Those that are told a folder.
FOLDERS = ("figures", "export", "derive")


def test_every_option_that_names_a_file_is_known_here() -> None:
    """A command that writes stands in WRITING, and has --force."""
    for name in COMMANDS:
        command = cli.get_command(click.Context(cli), name)
        assert command is not None
        flags = {flag for option in command.params for flag in option.opts}
        paths = [option for option in command.params if isinstance(option.type, click.Path) and not option.type.exists]
        assert bool(paths) == (name in WRITING) == ("--force" in flags)


def in_the_way(command: str, folder: Path) -> tuple[list[str], Path]:
    """A command and the file that it would write, which is there and holds something else."""
    arguments, name = WRITING[command]
    (folder / name).write_text("precious", encoding="utf-8")
    return [*arguments, str(folder if command in FOLDERS else folder / name)], folder / name


@pytest.mark.parametrize("command", WRITING)
@pytest.mark.usefixtures("checked")
def test_no_file_is_overwritten_without_force(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    arguments, target = in_the_way(command, tmp_path)
    assert invoke(*arguments) == USAGE
    shown, said = capsys.readouterr()
    assert (shown, said.count("\n")) == ("", 1)
    assert str(target) in said
    assert "--force" in said
    assert target.read_text(encoding="utf-8") == "precious"
    assert [path.name for path in tmp_path.iterdir()] == [target.name]


@pytest.mark.by_hand("report")
@pytest.mark.thorough
@pytest.mark.parametrize("command", WRITING)
@pytest.mark.usefixtures("checked")
def test_a_file_is_overwritten_with_force(command: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    if command == "cycles" and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    arguments, target = in_the_way(command, tmp_path)
    assert invoke(*arguments, "--force") == DONE
    assert target.read_bytes()[:8] != b"precious"


@pytest.mark.parametrize("command", ["check", "sweep", "explore", "export"])
@pytest.mark.usefixtures("checked")
def test_what_is_there_already_is_no_obstacle(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments, name = WRITING[command]
    place = str(tmp_path) if command in FOLDERS else str(tmp_path / name)
    assert invoke(*arguments, place) == DONE
    before = (tmp_path / name).read_bytes()
    assert invoke(*arguments, place) == DONE
    assert (tmp_path / name).read_bytes() == before


def test_force_that_fails_keeps_the_old_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "a.csv"
    target.write_text("precious", encoding="utf-8")
    assert invoke("sweep", *MOTION, "--rtol", "0", "--quiet", "--force", "-o", str(target)) == USAGE
    assert target.read_text(encoding="utf-8") == "precious"
    assert [path.name for path in tmp_path.iterdir()] == ["a.csv"]


# ------------------------------------------------------------------------------------------- nothing to compute

EMPTY = ["30:60:0", "30:60:-1", "30:60:1", "", ",", "30:60:", "::", "nan:60:3", "30:inf:3"]


@pytest.mark.parametrize("numbers", EMPTY)
@pytest.mark.parametrize("flag", ["--theta0", "--mu0", "--kappa", "--alpha", "--sigma", "--beta", "-V", "-d"])
def test_an_empty_axis_is_an_error_that_leaves_nothing(
    flag: str, numbers: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = ["--theta0", "49"] if flag != "--theta0" else []
    assert invoke("sweep", *given, flag, numbers, "-o", str(tmp_path / "a.csv")) == USAGE
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert flag.strip("-") in said or {"-V": "--speed", "-d": "--creep"}[flag] in said
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("count", ["0", "-2", "1.5", "x"])
@pytest.mark.parametrize("command", ["sweep", "figures"])
def test_no_processes_is_an_error_that_leaves_nothing(command: str, count: str, tmp_path: Path, run: Run) -> None:
    """A journal that is left behind would refuse the next sweep to that file."""
    target = ["--theta0", "49", "-o", str(tmp_path / "a.csv")] if command == "sweep" else ["--out", str(tmp_path)]
    assert "--workers" in run(command, *target, "-j", count, code=USAGE)
    assert not list(tmp_path.iterdir())


@pytest.mark.by_hand("3000")
@pytest.mark.parametrize("t_end", ["100", "0.5", pytest.param("3000", marks=pytest.mark.thorough)])
def test_the_window_follows_the_end(t_end: str, tmp_path: Path, run: Run) -> None:
    """The last quarter is what is measured, where nothing else is said: of 2000 that which the article shows."""
    motion = ["--theta0", "49", "--t-end", t_end, "--backend", "scipy"]
    tr = ss.simulate(ss.Parameters.article(theta0=math.radians(49)), V=0.5, d=10.0, t_end=float(t_end), backend="scipy")
    assert json.loads(run("simulate", *motion, "--json"))["rms"] == tr.rms(0.75 * float(t_end))
    run("sweep", *motion, "-q", "-o", str(tmp_path / "a.csv"))
    assert f"# transient: {0.75 * float(t_end)}\n" in (tmp_path / "a.csv").read_text(encoding="utf-8")


# ------------------------------------------------------------------------------------------------- files of a sweep


@pytest.mark.thorough
def test_a_file_has_the_degrees_that_were_typed(tmp_path: Path, run: Run) -> None:
    xarray = pytest.importorskip("xarray")
    pandas = pytest.importorskip("pandas")
    typed = [30.0, 49.3, 63.7, 179.9]
    for kind in ("csv", "nc"):
        options = ["--t-end", "20", "--backend", "scipy", "-q", "-o", str(tmp_path / f"a.{kind}")]
        run("sweep", "--theta0", ",".join(map(str, typed)), *options)
    with xarray.open_dataset(tmp_path / "a.nc", engine="h5netcdf") as data:
        assert data.theta0_deg.values.tolist() == typed
        assert (data.theta0_deg.units, data.theta0.units) == ("degree", "rad")
        assert data.theta0_deg.dims == data.theta0.dims == ("theta0",)
        np.testing.assert_array_equal(data.theta0, np.radians(typed))
        rms = data.rms.values
    table = np.genfromtxt(tmp_path / "a.csv", delimiter=",", names=True, comments="#")
    assert table["theta0_deg"].tolist() == typed
    np.testing.assert_array_equal(table["rms"], rms)
    assert pandas.read_csv(tmp_path / "a.csv", comment="#").theta0_deg.tolist() == typed


@pytest.mark.thorough
@given(st.lists(st.text(max_size=30), min_size=1, max_size=4))
def test_any_text_is_one_cell_to_every_reader(words: list[str]) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "a.csv"
        cells = [storage.plain(word) for word in words]
        given_columns = {"theta0": np.ones(len(cells)), "reason": np.array(cells), "rms": np.zeros(len(cells))}
        storage.write(path, dict, lambda: given_columns, {"a": "b, c"}, dict.fromkeys(given_columns, ("1", "any")))
        kinds = [float, "U99", float]
        table = np.genfromtxt(path, delimiter=",", names=True, comments="#", dtype=kinds, encoding="utf-8", ndmin=1)
        assert table.dtype.names == ("theta0", "reason", "rms")
        assert table["rms"].tolist() == [0] * len(cells)
        columns, attributes = storage.read(path)
        assert columns["reason"].tolist() == np.array(cells).tolist()
        assert attributes["a"] == "b, c"


# ----------------------------------------------------------------------------------------------- help and version


@pytest.mark.parametrize("command", [[], *([name] for name in COMMANDS)], ids=["spragsym", *COMMANDS])
def test_help_has_examples_and_exit_codes(command: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert invoke(*command, "-h") == DONE
    text, silence = capsys.readouterr()
    assert silence == ""
    assert "Examples:" in text
    assert "Exit codes: 0" in text
    # Each example names a command that exists, with options that it has.
    for name, options in re.findall(r"^ +spragsym (\w+)(.*)$", text.split("Examples:")[1].split("Exit codes")[0], re.MULTILINE):
        known = {flag for option in cli.get_command(click.Context(cli), name).params for flag in option.opts}  # type: ignore[union-attr]  # there is such a command
        assert set(re.findall(r"(?<= )--?[a-zA-Z][\w-]*", options.split("|")[0])) <= known


def test_the_list_of_commands_is_whole(run: Run) -> None:
    listed = run("--help").split("Commands:")[1]
    assert all(f"{name} " in listed and summary in listed for name, (_, summary) in COMMANDS.items())


def test_options_have_one_meaning_everywhere() -> None:
    """An option of one name has one short form and one type wherever it stands, but for numbers that are axes of a sweep."""
    seen: dict[str, set[tuple[str, ...]]] = {}
    for name in COMMANDS:
        command = cli.get_command(click.Context(cli), name)
        assert command is not None
        for option in command.params:
            for flag in (flag for flag in option.opts if flag.startswith("--")):
                seen.setdefault(flag, set()).add(tuple(sorted(option.opts)))
    assert {flag: forms for flag, forms in seen.items() if len(forms) > 1} == {}


def test_version_is_that_of_the_package(start: Start) -> None:
    process = start("--version")
    assert process.communicate(timeout=60) == (f"spragsym, version {ss.__version__}\n", "")
    assert process.returncode == DONE


def test_no_command_is_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert invoke() == USAGE
    shown, said = capsys.readouterr()
    assert shown == ""
    assert said.startswith("Usage: spragsym")


@pytest.mark.thorough
def test_completion_of_commands_and_options(start: Start) -> None:
    for words, place, meant in (("spragsym equi", "1", "equilibria"), ("spragsym equilibria --ka", "2", "--kappa")):
        process = start(_SPRAGSYM_COMPLETE="bash_complete", COMP_WORDS=words, COMP_CWORD=place)
        assert meant in process.communicate(timeout=60)[0]


# --------------------------------------------------------------------------------------------------------- errors


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["nonsense"], USAGE, ["nonsense", "spragsym --help"]),
        (["equilibria"], USAGE, ["--theta0", "spragsym equilibria --help"]),
        (["equilibria", "--theta0", "x"], USAGE, ["--theta0", "'x'"]),
        (["equilibria", "--theta0", "49", "--nonsense"], USAGE, ["--nonsense"]),
        (["equilibria", "--theta0", "0"], USAGE, ["--theta0 = 0", "(0, 180)"]),
        (["equilibria", "--theta0", "nan"], USAGE, ["--theta0 = nan"]),
        (["equilibria", "--theta0", "49", "--sigma", "0"], USAGE, ["sigma = 0", "(0, inf)"]),
        (["equilibria", "--theta0", "49", "--mu0", "-0.3"], USAGE, ["--mu0 = -0.3 is"]),
        (["equilibria", "--theta0", "180.00000000000003"], USAGE, ["--theta0 = 180.00000000000003"]),
        (["critical", "--theta0", "49", "--vary", "mu0=0:1", "--vary", "theta0"], USAGE, ["--vary", "mu0=0:1, theta0", "once"]),
        (["bifurcation", "--plot", "a.txt"], USAGE, ["a.txt", ".pdf, .png or .svg"]),
        (["bifurcation", "--plot", "missing/a.pdf"], FAILED, ["missing/a.pdf", "another path"]),
        (["simulate", "--theta0", "49", "--t-end", "-1"], USAGE, ["--t-end = -1"]),
        (["simulate", "--theta0", "49", "--t-end", "9", "--transient", "9"], USAGE, ["--transient = 9", "--t-end = 9"]),
        (["simulate", "--theta0", "49", "--transient", "9", "--t-end", "8"], USAGE, ["--transient = 9", "--t-end = 8"]),
        (["simulate", "--theta0", "49", "-V", "-1"], USAGE, ["--speed = -1", "mirror image"]),
        (["simulate", "--theta0", "49", "-o", "missing/a.csv"], USAGE, ["missing"]),
        (["sweep", "--theta0", "1:2", "-o", "a.csv"], USAGE, ["1:2", "start:stop:count"]),
        (["sweep", "--theta0", "30:200:3", "-o", "a.csv"], USAGE, ["--theta0[2] = 200", "degrees"]),
        (["sweep", "--theta0", "200", "-o", "a.csv"], USAGE, ["--theta0 = 200", "(0, 180)", "degrees"]),
        (["figures", "--only", "2", "--out", "a"], USAGE, ["--only", "'2'", "3, 4"]),
        (["figures", "--out", "a", "12"], USAGE, ["--only"]),
        (["figures", "--only", "rmsmap", "--out", "a"], USAGE, ["did you mean rms-map?"]),
        (["figures", "--out", "a", "--format", "gif"], USAGE, ["--format", "gif", "pdf, png, svg"]),
        (["export", "--language", "fortran", "--out", "a"], USAGE, ["fortran"]),
    ],
)
def test_an_error_is_one_line_that_says_what_to_do(
    arguments: list[str], code: int, words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    if arguments[0] in ("figures", "bifurcation"):
        pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    assert invoke(*arguments) == code
    shown, said = capsys.readouterr()
    assert shown == ""
    assert said.startswith("spragsym: ")
    assert said.count("\n") == 1
    assert all(word in said for word in words), said
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("equilibrium", "equilibria"), ("Sweep", "sweep"), ("simulat", "simulate"), ("equilibria --mu_0 1", "--mu0"),
        ("equilibria --mu 1", "--mu0"), ("equilibria --θ0 1", "--theta0"), ("equilibria --θ₀=1", "--theta0"),
        ("equilibria --theta_0 1", "--theta0"), ("equilibria --theta0_deg 1", "--theta0"), ("equilibria -theta0 1", "--theta0"),
        ("equilibria --kapa 1", "--kappa"), ("simulate --t_end 1", "--t-end"), ("sweep --worker 1", "--workers"),
        ("fates --V 0.3", "-V"), ("bifurcation --jsn", "--json"),
    ],
)  # fmt: skip
def test_a_typo_gets_the_name_that_was_meant(typed: str, meant: str, run: Run) -> None:
    said = run(*typed.split(), code=USAGE)
    assert f"did you mean {meant}?" in said
    assert said.count("\n") == 1


@pytest.mark.parametrize("place", [0, 1, 3])
def test_debug_shows_the_traceback_wherever_it_stands(place: int, run: Run) -> None:
    arguments = ["equilibria", "--theta0", "-3"]
    arguments.insert(place, "--debug")
    said = run(*arguments, code=USAGE)
    assert "Traceback" in said
    assert said.splitlines()[-1].startswith("spragsym: --theta0 = -3")


@pytest.mark.parametrize(
    ("error", "code", "words"),
    [
        (MemoryError(), FAILED, "out of memory"),
        (KeyboardInterrupt(), INTERRUPTED, "interrupted"),
        (click.Abort(), INTERRUPTED, "interrupted"),
        (ModuleNotFoundError("no", name="matplotlib.axes"), FAILED, "[plot]"),
        (ModuleNotFoundError("no", name="something"), FAILED, "unexpected"),
        (KeyError("broken"), FAILED, "unexpected KeyError"),
        (OSError("disk gone"), FAILED, "disk gone"),
        (ss.ConvergenceError("no convergence"), FAILED, "no convergence"),
        (ss.ParameterTypeError("a type"), USAGE, "a type"),
    ],
)
def test_exit_codes(error: BaseException, code: int, words: str, monkeypatch: pytest.MonkeyPatch, run: Run) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(command_line.cli, "invoke", fail)
    said = run("check", code=code)
    assert words in said
    assert said.count("\n") == 1
    assert ("--debug" in said) == ("unexpected" in words)


# ------------------------------------------------------------------------------------------- pipes, colours, Ctrl-C

ONE = ["equilibria", "--theta0", "30"]


@pytest.mark.thorough
def test_a_reader_that_leaves_is_no_error(start: Start) -> None:
    """As under ``head``."""
    process = start(*ONE, "--json")
    assert process.stdout is not None
    process.stdout.close()  # before anything is written
    assert process.stderr is not None
    said = process.stderr.read()
    process.stderr.close()
    assert process.wait(timeout=60) == DONE
    assert said == ""


@pytest.mark.thorough
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a disk that is always full")
@pytest.mark.parametrize("arguments", [ONE, [*ONE, "--json"], ["--version"], ["--help"], [*ONE, "--help"]], ids=" ".join)
def test_a_full_disk_under_stdout_is_one_line(arguments: list[str]) -> None:
    with open("/dev/full", "w", encoding="utf-8") as full:
        call = [sys.executable, "-m", "spragsym", *arguments]
        done = subprocess.run(call, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        assert done.returncode == FAILED
        assert re.fullmatch(r"spragsym: .*No space left on device.*\n", done.stderr)
        # An error that can't be said is an error still.
        assert subprocess.run([*call[:3], "nonsense"], stderr=full, timeout=60).returncode == USAGE


@needs_posix
@pytest.mark.parametrize("stream", few(["<&-", ">&-", "2>&-"], ">&-"))
def test_streams_that_are_closed(stream: str) -> None:
    call = f"{shlex.quote(sys.executable)} -m spragsym {' '.join(ONE)} {stream}"
    done = subprocess.run(["sh", "-c", call], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (DONE, "")
    assert ("contact" in done.stdout) == (stream != ">&-")


#: Surroundings without a terminal, a home, a language.
SURROUNDINGS: dict[str, dict[str, str]] = {
    "empty": {},
    "LC_ALL=C": {"LC_ALL": "C"},
    "C without UTF-8": {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    "ascii": {"PYTHONIOENCODING": "ascii"},
    "latin-1": {"PYTHONIOENCODING": "latin-1"},
    "no home": {"HOME": "/proc/none"},
}


def run_in(surroundings: str, folder: Path, *arguments: str) -> subprocess.CompletedProcess[bytes]:
    call = [sys.executable, "-W", "error", "-m", "spragsym", *arguments]
    given = NO_ENVIRONMENT | SURROUNDINGS[surroundings]
    return subprocess.run(call, stdin=subprocess.DEVNULL, capture_output=True, env=given, cwd=folder)


@pytest.mark.usefixtures("checked")
def test_greek_is_spelled_where_a_stream_has_none(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(shown, encoding="latin-1"))
    assert invoke("check") == DONE
    assert "it is back in (15) as -kappa" in shown.getvalue().decode("latin-1")


@pytest.mark.thorough
@pytest.mark.parametrize("surroundings", SURROUNDINGS)
def test_any_surroundings(surroundings: str, tmp_path: Path) -> None:
    """Right output or one line: with Greek in the arguments, and a bar on stderr."""
    done = run_in(surroundings, tmp_path, "equilibria", "--θ0", "30")
    assert done.returncode == USAGE
    assert done.stderr.count(b"\n") == 1
    grid = ["--theta0", "49,50", "--t-end", "20", "--backend", "scipy", "-j", "2", "-o", "a.csv"]
    done = run_in(surroundings, tmp_path, "sweep", *grid)
    assert done.returncode == DONE, done.stderr
    assert done.stdout.startswith(b"a.csv: ")
    assert b"Traceback" not in done.stderr


@pytest.mark.parametrize("colour", [True, False])
@pytest.mark.usefixtures("checked")
def test_no_color_is_respected(colour: bool, monkeypatch: pytest.MonkeyPatch, run: Run) -> None:
    """FORCE_COLOR stands for a terminal."""
    monkeypatch.delenv("NO_COLOR", raising=False)
    for name in ("FORCE_COLOR", *([] if colour else ["NO_COLOR"])):
        monkeypatch.setenv(name, "1")
    monkeypatch.setenv("TERM", "xterm-256color")
    shown = run("check")
    assert "eq-6" in shown
    assert bool(re.search(r"\x1b\[[\d;]*3[0-7]m", shown)) == colour


# ----------------------------------------------------------------------------------------------------------- fuzz

#: Numbers as people and programs write them, and text that is no number.
NUMBERS = st.one_of(
    st.floats(1e-9, 1e6).map(repr),
    st.floats(1e-3, 200).map(repr),
    st.floats(max_value=0, exclude_max=True).map(repr),
    st.integers(-5, 200).map(str),
    st.sampled_from(["", "nan", "inf", "-inf", "1e400", "0x10", "1_0", "١٢", "1,5", "--", "-", "-0.0"]),
    st.text(max_size=8),
)
PARAMETERS = ["--theta0", "--mu0", "--kappa", "--alpha", "--sigma", "--beta"]
FLAGS = st.sampled_from([*PARAMETERS, "--json", "--debug", "-h", "-V", "--nonsense"])


def end_as_documented(arguments: list[str]) -> None:
    """Run a command that may get anything: a documented exit code, an error on one line, and no mistake of ours."""
    shown, said = io.StringIO(), io.StringIO()
    with redirect_stdout(shown), redirect_stderr(said), pytest.raises(SystemExit) as stop:
        main(arguments)
    text = said.getvalue()
    assert stop.value.code in (DONE, FAILED, USAGE)
    assert "a mistake in spragsym" not in text, text
    if stop.value.code != DONE and "--debug" not in arguments:
        assert re.fullmatch(r"spragsym: .*\n", text), text


@pytest.mark.thorough
@given(
    st.sampled_from(["equilibria", "bifurcation"]), st.lists(st.tuples(FLAGS, NUMBERS), max_size=5), st.lists(NUMBERS, max_size=1)
)  # fmt: skip
@example("equilibria", [("--theta0", "1e-300")], [])
@example("equilibria", [("--theta0", "49"), ("--sigma", "1e300")], [])
@example("bifurcation", [("--kappa", "1e300")], [])
@example("bifurcation", [("--sigma", "1e-300")], [])
def test_any_arguments_end_as_documented(command: str, options: list[tuple[str, str]], rest: list[str]) -> None:
    end_as_documented([command, *(word for pair in options for word in pair), *rest])


@pytest.mark.parametrize(
    "option", [("--kappa", "5e-324"), ("--mu0", "1e300"), ("--mu0", "1e308"), ("--alpha", "1e300")], ids=" ".join
)
def test_numbers_at_the_ends_of_the_range(option: tuple[str, str]) -> None:
    end_as_documented(["equilibria", "--theta0", "49", *option])


@pytest.mark.thorough
def test_a_check_of_a_model_takes_rows_and_no_claims(run: Run) -> None:
    """Both were passed over in silence: the equations came, all of them."""
    asked = ("check", "--model", "stick_slip")
    assert [row["id"] for row in json.loads(run(*asked, "--row", "eq-10", "--json"))] == ["eq-10"]
    assert "leave --model out" in run(*asked, "--claims", code=USAGE)


def test_no_cell_of_a_table_is_cut_in_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    """Differences that `check --model` prints have thousands of characters; the columns before them were squeezed to nothing."""
    rows = [("eq-28", "fails", "x" * 5000), ("eq-3", "holds", "")]
    print_table("", ("row", "status", "model less article"), rows)
    assert [line.split() for line in capsys.readouterr().out.splitlines()[1:]] == [[part for part in row if part] for row in rows]


def test_a_terminal_is_told_what_is_computed_and_a_pipe_is_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("FORCE_COLOR", raising=False)
    monkeypatch.delenv("NO_COLOR", raising=False)
    for told in (False, True):
        if told:
            monkeypatch.setenv("FORCE_COLOR", "1")
        with progress.show_progress("searching for folds"):
            pass
        shown = capsys.readouterr()
        assert ("searching for folds" in shown.err) == told
        assert shown.out == ""


def test_what_takes_long_says_so_in_a_pipe_too(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.delenv("FORCE_COLOR", raising=False)
    monkeypatch.setattr(progress, "LONG", 0.01)
    with progress.show_progress("searching for folds"):
        time.sleep(0.2)
    told = capsys.readouterr().err.splitlines()
    assert 2 <= len(told) <= 6
    assert all(line.startswith("searching for folds: ") and line.endswith(" s so far") for line in told)


def test_a_fold_behind_which_nothing_is_left_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    row = {"kind": "fold", "x": 1.0, "ends": "upper", "when": "down", "error": 1e-12}
    rows = [{"mu0": 0.4, **row, "x_after": 2.0}, {"mu0": 2.4, **row, "x_after": math.nan}]
    along = Span(name="mu0", unit=1.0, title="mu0", ends=None, count=0)
    print_points("Folds", {"points": rows, "complete": True, "undecided": [], "remarks": []}, [along])
    assert "nothing stable in contact is left to jump to at mu0 = 2.4" in capsys.readouterr().out.splitlines()[-1]


ASKED = {
    "path --vary theta0=10:60:2": (0, "44.55932"),
    "folds --vary theta0": (0, "44.5593"),
    "critical --vary theta0 --mu0 0.7": (0, "35.353706"),
    "path": (2, "Give it as mu0=FROM:TO"),
    "path --vary mu0=0:1": (2, "Missing option '--theta0'"),
    "folds --model trolley --vary mu0": (2, "'--theta0': theta0 has no base value in trolley; see spragsym folds --help"),
    "critical --model trolley --vary mu0": (2, "'--theta0': theta0 has no base value in trolley; see spragsym critical --help"),
    "path --vary theta0=0:60": (2, "--vary theta0=0:60: theta0_deg = 0 is not in (0, 180)"),
    "path --theta0 40 --vary kappa=0.01:0": (2, "--vary kappa=0.01:0: kappa = 0 is not in (0, inf)"),
    "critical --theta0 49 --mu0 0.7 --vary kappa": (0, "it has jumped already"),
    "critical --theta0 30 --mu0 0.3 --vary beta": (0, "never"),
    "simulate --theta0 49 --t-end 1e12": (2, "give at most 2e+06 sqrt(m)/sqrt(k_c)"),
    "sweep --theta0 49 --t-end 1e12 -o long.csv": (2, "followed to its end: give at most 2e+06 sqrt(m)/sqrt(k_c)"),
}


@pytest.mark.parametrize("line", ASKED)
def test_what_is_not_needed_is_not_asked_for_and_ends_are_called_by_their_options(line: str, run: Run) -> None:
    code, part = ASKED[line]
    told = run(*line.split(), code=code)
    assert part in told
    assert "values[0]" not in told
