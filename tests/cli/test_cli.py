"""The command line: output, exit codes, errors on one line, and nothing else whatever the
arguments.
"""

import io
import itertools
import json
import os
import pickle
import re
import shlex
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import click
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import spragsym as ss
from spragsym import cli as command_line
from spragsym.cli import main
from spragsym.cli.options import OfModel
from spragsym.cli.output import wrapped
from spragsym.command_line import OF_COMMANDS
from spragsym.core.remarks import At, Remark
from tests.conftest import Run
from tests.oracles.mistakes import COMMANDS
from tests.support import LONG_MOTIONS_TAKE_MINUTES, ROOT, few, needs_posix

#: Exit codes that are documented.
DONE, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130


def invoke(*arguments: str) -> int:
    """Run a command in this process; its exit code."""
    with pytest.raises(SystemExit) as stop:
        main(list(arguments))
    assert isinstance(stop.value.code, int)
    return stop.value.code


# ------------------------------------------------------------------------------------------------
# results


def test_a_row_of_the_article_is_printed_in_full(run: Run) -> None:
    """A confirmed row shows what is printed and what is derived, a misprint what is right."""
    said = run("check", "--row", "A1-c0", "--row", "eq-9")
    assert "A1-c0: confirmed" in said
    for part in said.split("A1-c0: confirmed"):
        assert all(f"\n  {title}: " in part for title in ("Printed", "Derived", "Derived by"))
    assert "Cause: " in said


@pytest.mark.parametrize("given", ["9", "(9)", "EQ-9", "eq9", "eq. 9", "Equation (9)"])
def test_a_row_is_named_as_the_article_numbers_it(given: str, run: Run) -> None:
    assert run("check", "--row", given) == run("check", "--row", "eq-9")


def test_claims_are_named_by_their_figure(run: Run) -> None:
    rows = json.loads(run("check", "--claims", "--json", "--row", "Figure 12"))
    assert [row["id"] for row in rows] == ["fig-12-set", "fig-12-cusp"]


@pytest.mark.usefixtures("checked")
def test_a_date_of_the_environment_that_is_none_is_named(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    for epoch in ("abc", "99999999999999", "²"):
        monkeypatch.setenv("SOURCE_DATE_EPOCH", epoch)
        assert f"SOURCE_DATE_EPOCH = '{epoch}'" in run("folds", code=2)


@pytest.mark.thorough
def test_check_prints_every_row(run: Run) -> None:
    rows = json.loads(run("check", "--json"))
    assert rows == json.loads(run("check", "--json", "--again"))
    assert len(rows) == 53
    assert [row["id"] for row in rows if row["status"] == "misprint"] == [
        "eq-6",
        "eq-9",
        "eq-13",
        "def-n",
        "A1-d0",
    ]


def test_a_point_without_an_answer_costs_no_other(run: Run) -> None:
    """Lengths of 1e399 are no floats: that point says so, in the table and in JSON, and the others
    are listed.
    """
    asked = shlex.split(
        "equilibria --theta0 50 --mu0 1e200 --alpha 1 --sigma 1 --beta 1 --kappa 0.3,1e200,0.4"
    )
    shown = run(*asked)
    assert [line.split()[:2] for line in shown.splitlines()[1:3]] == [
        ["0.3", "contact"],
        ["0.4", "contact"],
    ]
    assert "contact, undecided: log10 L = 399" in shown
    points = json.loads(run(*asked, "--json"))["points"]
    assert [point["complete"] for point in points] == [True, False, True]
    assert [len(point["equilibria"]) for point in points] == [1, 0, 1]
    (hopeless,) = points[1]["undecided"]
    assert hopeless["state"] == "contact"
    assert "beyond float64" in hopeless["reason"]


# ------------------------------------------------------------------------------------------------
# files in the way

MOTION = "--theta0 49 --t-end 20 --backend scipy"
BRAKE = (Path(ss.__file__).parent / "report/brake.toml").as_posix()

#: Command that writes → its options but for what it writes to, given a folder.
WRITING = {
    "bifurcation": ("--plot", "a.svg"),
    "equilibria": ("--model mode_coupling --vary mu0=0:1 --plot", "a.svg"),
    "onsets": (
        "--model stick_slip --vary V=0.1:0.4 --vary zeta=0.5:1.5 --n 4 --plot",
        "a.svg",
    ),
    "check": ("--report", "a.md"),
    "report": (f"--no-oscillation '{BRAKE}' --html", "a.html"),
    "squeal": ("--example", "brake.toml"),
    "simulate": (f"{MOTION} -o", "a.csv"),
    "cycles": ("--theta0 42 --vary theta0=41.9:42.1 --plot", "a.svg"),
    "sweep": (f"{MOTION} --quiet -o", "a.csv"),
    "fates": ("--theta0 30,35 --quiet -o", "a.csv"),
    "figures": ("3 --quiet -j 1 --out", "figure_3.pdf"),
    "explore": ("--no-open --out", "a.html"),
    "export": ("--out", "spragsym.c"),
    "derive": (f"'{(ROOT / 'derive/models/stick_slip.py').as_posix()}' --out", "model.json"),
}

#: Those that are told a folder.
FOLDERS = ("figures", "export", "derive", "squeal")


def in_the_way(command: str, folder: Path) -> tuple[list[str], Path]:
    """A command and the file that it would write, which is there and holds something else."""
    options, name = WRITING[command]
    target = folder / name
    target.write_text("precious", encoding="utf-8")
    told = folder if command in FOLDERS else target
    return [command, *shlex.split(options), str(told)], target


@pytest.mark.parametrize("command", WRITING)
def test_no_file_is_overwritten_without_force(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
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
@pytest.mark.parametrize(
    "command", [name for name in WRITING if name != "derive"]
)  # which replaces only what it wrote itself
def test_a_file_is_overwritten_with_force(command: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    if command == "cycles" and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    arguments, target = in_the_way(command, tmp_path)
    assert invoke(*arguments, "--force") == DONE
    assert target.read_bytes()[:8] != b"precious"


# ------------------------------------------------------------------------------------------------
# errors


@pytest.mark.parametrize(("command", "words"), COMMANDS)
def test_an_error_is_one_line_that_says_what_to_do(
    command: str,
    words: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    arguments = shlex.split(command)
    if arguments[0] in ("figures", "bifurcation"):
        pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    assert invoke(*arguments) == USAGE
    shown, said = capsys.readouterr()
    assert shown == ""
    assert said.startswith("spragsym: ")
    assert said.count("\n") == 1
    assert all(word in said for word in words), said
    assert not list(tmp_path.iterdir())


def test_what_is_refused_is_refused_before_a_solver_is_loaded(tmp_path: Path) -> None:
    """Neither mpmath nor a room that solves is loaded, which takes a second; nor pint, which loads
    SciPy, where the size of no unit matters.
    """
    good = Path(BRAKE).read_text(encoding="utf-8")
    mistakes = {
        "key": good + 'mass = "0.35 kg"\n',
        "syntax": good + "V\n",
        "model": good.replace("kang_nam", "kangnam"),
        "missing": good.replace("k_c =", "# k_c ="),
        "kind": good.replace('"0 N/mm"', "true"),
        "comma": good.replace("180 N/mm", "180,5 N/mm"),
        "no_unit": good.replace("180 N/mm", "180"),
        "word": good.replace("0.35 kg", "0.35 kgg"),
        "unit": good.replace("180 N/mm", "180 N/mn"),
        "number": good.replace("[0.3, 0.6]", "-0.1"),
        "ratio": good.replace("0.5 %", "0.5 % ± 0.1 %"),
        "rise": good + 'vary = "V"\n',
        "range": good.replace("52 deg", "200 deg"),
        "state": good + 'state = { x = "2 mm ± 1 mm" }\n',
        "ends": good + 'may_change = { V = "[1, 2] m/s" }\n',
        "pair": good + 'correlation = [["k", "V", 0.9]]\n',
    }
    for name, text in mistakes.items():
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
    code = (
        "import sys\nfrom spragsym.cli import main\n"
        "for name in sys.argv[1:]:\n    try:\n        main(['report', name + '.toml'])\n"
        "    except SystemExit as stop:\n        print(stop.code)\n"
        "print(*({'scipy', 'mpmath', 'pint'} & set(sys.modules)), *(one for one in sys.modules\n"
        "    if one in ('spragsym.statics', 'spragsym.bifurcation', 'spragsym.motion')))"
    )
    plain = ["none", *itertools.takewhile(lambda name: name != "range", mistakes)]
    for names in (plain, [name for name in mistakes if name not in plain]):
        command = [sys.executable, "-c", code, *names]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, encoding="utf-8")
        *codes, loaded = done.stdout.split("\n")[:-1]
        assert codes == ["2"] * len(names), done
        assert set(loaded.split()) <= (set() if names is plain else {"scipy", "pint"}), done
        assert done.stderr.count("\n") == len(names)
        assert "unexpected" not in done.stderr
        assert ("none.toml can't be read" in done.stderr) == (names is plain)


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
        (ss.errors.ConvergenceError("no convergence"), FAILED, "no convergence"),
        (ss.errors.ParameterTypeError("a type"), USAGE, "a type"),
    ],
)
def test_exit_codes(
    error: BaseException, code: int, words: str, monkeypatch: pytest.MonkeyPatch, run: Run
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(command_line.cli, "invoke", fail)
    said = run("check", code=code)
    assert words in said
    assert said.count("\n") == 1
    assert ("--debug" in said) == ("unexpected" in words)


def test_a_text_is_wrapped_on_a_narrow_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.setenv("COLUMNS", "40")
    assert max(map(len, wrapped("word " * 20).splitlines())) <= 40


@pytest.mark.parametrize("name", command_line.COMMANDS)
def test_each_example_of_help_is_one_call_with_options_of_the_command(name: str) -> None:
    command = command_line.cli.get_command(click.Context(command_line.cli), name)
    assert command is not None
    assert command.help is not None
    block = command.help.split("Examples:\n")[1].split("\n\n")[0]
    known = {option for parameter in command.params for option in parameter.opts}
    known |= {option for parameter in command.params for option in parameter.secondary_opts}
    assert ("--force" in known) == (name in WRITING)
    for line in block.splitlines():
        call = shlex.split(line.split("|")[0].split(">")[0])
        if call[0] == "make":  # of what was exported
            continue
        assert call[:2] == ["spragsym", name], line
        assert call.count("spragsym") == 1, line
        options = {word.split("=")[0] for word in call if re.match(r"-{1,2}[a-zA-Z]", word)}
        assert options <= known, line


def test_a_parameter_of_a_page_is_not_taken_for_an_option() -> None:
    """``OF_COMMANDS`` has the names of all options that commands about a model have besides."""
    model = ss.load("kang_nam")
    of_model = {*model.parameters, *(f"{name}0" for name in model.starting)}
    for name in command_line.COMMANDS:
        command = command_line.cli.get_command(click.Context(command_line.cli), name)
        if isinstance(command, OfModel):
            ours = [option for option in command.params if option.name not in of_model]
            flags = {flag for option in ours for flag in (f"--{option.name}", *option.opts)}
            names = {flag[2:].replace("-", "_") for flag in flags if flag.startswith("--")}
            assert names - OF_COMMANDS == set(), name


def test_help_tells_the_value_of_an_option_that_is_left_out(run: Run) -> None:
    assert "1e-10" in run("simulate", "--help")


# ------------------------------------------------------------------------------------------------
# pipes, colours, Ctrl-C

ONE = ["equilibria", "--theta0", "30"]


def test_many_points_are_asked_in_one_call(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    asked, answer = [], ss.equilibria
    monkeypatch.setattr(
        ss, "equilibria", lambda p, **more: asked.append(p.shape) or answer(p, **more)
    )
    points = json.loads(run("equilibria", "--theta0", "20:80:7", "--json"))["points"]
    assert asked == [(7,), (7,)]
    assert points[1]["equilibria"] == json.loads(run(*ONE, "--json"))["equilibria"]


@needs_posix
@pytest.mark.parametrize("stream", few(["<&-", ">&-", "2>&-"], ">&-"))
def test_streams_that_are_closed(stream: str) -> None:
    call = f"{shlex.quote(sys.executable)} -m spragsym {' '.join(ONE)} {stream}"
    done = subprocess.run(["sh", "-c", call], capture_output=True, text=True, timeout=60)
    lost = stream == ">&-"  # what it has to say can't be written
    assert done.returncode == (FAILED if lost else DONE)
    assert ("the output can't be written" in done.stderr) == lost == bool(done.stderr)
    assert ("contact" in done.stdout) != lost


# ------------------------------------------------------------------------------------------------
# fuzz

#: Numbers as people and programs write them, and text that is no number.
NUMBERS = st.one_of(
    st.floats(1e-9, 1e6).map(repr),
    st.floats(1e-3, 200).map(repr),
    st.floats(max_value=0, exclude_max=True).map(repr),
    st.integers(-5, 200).map(str),
    st.sampled_from(
        ["", "nan", "inf", "-inf", "1e400", "0x10", "1_0", "١٢", "1,5", "--", "-", "-0.0"]
    ),
    st.text(max_size=8),
)
PARAMETERS = ["--theta0", "--mu0", "--kappa", "--alpha", "--sigma", "--beta"]
FLAGS = st.sampled_from([*PARAMETERS, "--json", "--debug", "-h", "-V", "--nonsense"])


def end_as_documented(arguments: list[str]) -> None:
    """Run a command that may get anything: a documented exit code, an error on one line, and no
    mistake of ours.
    """
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
    st.sampled_from(["equilibria", "bifurcation"]),
    st.lists(st.tuples(FLAGS, NUMBERS), max_size=5),
    st.lists(NUMBERS, max_size=1),
)
@example("equilibria", [("--theta0", "1e-300")], [])
@example("equilibria", [("--theta0", "49"), ("--sigma", "1e300")], [])
@example("bifurcation", [("--kappa", "1e300")], [])
@example("bifurcation", [("--sigma", "1e-300")], [])
def test_any_arguments_end_as_documented(
    command: str, options: list[tuple[str, str]], rest: list[str]
) -> None:
    end_as_documented([command, *(word for pair in options for word in pair), *rest])


@pytest.mark.parametrize(("option", "typed"), [("vary", "kappa=5"), ("within", "x=5")])
def test_a_value_in_place_of_a_range_is_told_the_range_of_its_name(
    option: str, typed: str, run: Run
) -> None:
    said = run("folds", "--theta0", "40", f"--{option}", typed, code=USAGE)
    assert f"give it as {typed[:-2]}=0:1, or with" in said


def test_remarks_are_told_in_other_units() -> None:
    remark = Remark(
        "on lines: {}", Remark("searched {}, a part of its range", At("x", (0.0, 1.0), unit="rad"))
    )
    assert remark == "on lines: searched x in [0, 1] rad, a part of its range"
    assert (
        remark.in_units(lambda name, _: (name, "mm", 38.0))
        == "on lines: searched x in [0, 38] mm, a part of its range"
    )
    copied = pickle.loads(pickle.dumps(remark))  # noqa: S301  # bytes of our own
    assert copied.in_units(lambda name, _: (name, "", 2.0)).endswith(
        "x in [0, 2], a part of its range"
    )


def test_a_command_is_not_slowed_by_threads_of_blas() -> None:
    """A command sets one thread before NumPy is loaded, unless the user has set a number."""
    code = (
        "import os, sys\n"
        "from spragsym.__main__ import run\n"
        "assert 'numpy' not in sys.modules\n"
        "sys.argv = ['spragsym', '--version']\n"
        "try:\n    run()\n"
        "finally:\n    print(os.environ['OPENBLAS_NUM_THREADS'])\n"
    )
    others = {k: v for k, v in os.environ.items() if k != "OPENBLAS_NUM_THREADS"}
    for own, wanted in ({}, "1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3"):
        done = subprocess.run(
            [sys.executable, "-c", code],
            env=others | own,
            cwd=ROOT,
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert done.stdout.split()[-1] == wanted, done.stderr
