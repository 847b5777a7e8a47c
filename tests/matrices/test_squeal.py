"""``spragsym squeal`` on the brake that ships, and on files with mistakes."""

import json
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

import spragsym as ss
from spragsym.matrices.example import example_files
from spragsym.report.squeal import read_squeal
from tests.conftest import Run

SMALL = """title = "Two modes"
rayleigh = [0.001, 0]

[matrices]
M = "M.npy"
K = "K.npy"
friction = "F.npy"

[parameters]
mu = "[0, 1]"
"""
MATRICES = {"M": np.eye(2), "K": [[1.55, -0.25], [-0.25, 1.25]], "F": [[0.0, 1.0], [0.0, 0.0]]}


@pytest.fixture
def brake(tmp_path: Path) -> Path:
    for name, one in MATRICES.items():
        np.save(tmp_path / f"{name}.npy", np.array(one))
    path = tmp_path / "brake.toml"
    path.write_text(SMALL, encoding="utf-8")
    return path


@pytest.mark.thorough
def test_the_example_is_a_brake_whose_masses_and_springs_are_right(tmp_path: Path) -> None:
    for name, text in example_files().items():
        (tmp_path / name).write_text(text.replace("modes = 30", "modes = 12"), encoding="utf-8")
    study = read_squeal(tmp_path / "brake.toml")
    whole = study.model.full
    assert whole is not None
    assert whole.size == 222
    along = np.array([number == 1 for _, number in whole.dofs], dtype=float)
    masses = 60.0 * (240 * 20 * 7.2e-9 + 80 * 30 * 2.8e-9)  # thickness, areas, densities
    M, K = whole.given["M"], whole.given["K"]
    assert along @ M @ along == pytest.approx(masses)
    # A shift along strains the springs that hold it alone.
    strained = np.sort((K @ along)[np.abs(K @ along) > 1.0])
    assert strained == pytest.approx([1e4] * 9 + [3e4] * 25)
    assert np.linalg.matrix_rank(whole.given["friction"]) == 9
    found = study.report()
    (row,) = found.rows
    assert row["full_model"] == pytest.approx(row["mu"], rel=1e-4)
    lifted = ss.modes(whole.Parameters(mu=row["full_model"]))
    assert np.abs(lifted.growth).min() < 1e-6
    assert found.verdict().startswith("It squeals: from mu = 0.274")
    assert "the reduced matrices" in found.verdict()


def test_the_command_says_what_python_says(brake: Path, run: Run) -> None:
    told = json.loads(run("squeal", str(brake), "--json"))
    study = read_squeal(brake)
    on = ss.flutter_onsets(study.parameters)
    assert [row["mu"] for row in told["onsets"]] == on.mu.tolist()
    assert told["complete"]
    assert told["squeals"]
    assert told["growing"] == on.growing.tolist()
    page = brake.with_name("page.html")
    shown = run("squeal", str(brake), "--html", str(page))
    hertz = 1.4**0.5 / (2.0 * np.pi)  # where the two modes meet
    words = f"It squeals: from mu = {on.mu[0]:.6g} on a mode of {hertz:.4g} Hz grows."
    assert shown.startswith(words)
    text = page.read_text(encoding="utf-8")
    assert "Two modes" in text
    assert f"mu = {on.mu[0]:.8g}" in text
    assert "The mechanism" not in text


@pytest.mark.parametrize(
    ("change", "verdict"),
    [
        (('"[0, 1]"', '"[0, 0.3]"'), "It does not squeal: at no value of mu from 0 to 0.3 does"),
        (('"[0, 1]"', '"[0.5, 1]"'), "It squeals already at mu = 0.5, at 0.1888 Hz."),
        (("title", "threshold = 5\ntitle"), "It does not squeal"),
        (
            ("title", 'band = "[0.1, 0.15] Hz"\ntitle'),
            "No mode of 0.1 Hz to 0.15 Hz begins to grow",
        ),
        (("rayleigh = [0.001, 0]", 'threshold = "0 1/s"'), "Whether a mode grows is not decided"),
    ],
)
def test_a_verdict_says_what_is_known(change: tuple[str, str], verdict: str, brake: Path) -> None:
    brake.write_text(SMALL.replace(*change), encoding="utf-8")
    assert read_squeal(brake).report().verdict().startswith(verdict)


def test_units_of_time_and_contact_pairs(brake: Path) -> None:
    """The same brake in milliseconds, its friction as a pair that rubs on what does not move."""
    brake.with_name("pairs.csv").write_text(
        "across_1,across_2,along_1,along_2,stiffness,direction\n,1,,0,1.0,1\n", encoding="utf-8"
    )
    text = SMALL.replace('friction = "F.npy"', 'contacts = "pairs.csv"\nunits = "kg mm ms"')
    text = text.replace("[0.001, 0]", "[1.0, 0]")
    one = read_squeal(brake).report().onsets
    brake.write_text(text, encoding="utf-8")
    other = read_squeal(brake).report()
    assert other.onsets.mu == pytest.approx(one.mu)
    assert other.onsets.frequency == pytest.approx(1e3 * one.frequency)
    assert "in seconds" in other.remarks()[0]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (('K = "K.npy"\n', ""), r"\[matrices\] needs K"),
        (('friction = "F.npy"\n', ""), "either friction or contacts"),
        (("friction", "frction"), "did you mean friction"),
        (('"K.npy"', '"L.npy"'), r"line 6: .*L\.npy can't be read"),
        (('"K.npy"', "3"), "line 6: 3 is no file name"),
        (("mu =", "nu ="), "line 10: nu does not belong here"),
        (('"[0, 1]"', "0.5"), "nothing varies"),
        (('"[0, 1]"', '"[0, 1]"\nOmega = "[0, 1] 1/s"'), "mu and Omega have ranges"),
        (("title", 'band = "5 N"\ntitle'), "line 1: .*band"),
        (("title", "modes = 2\ntitle"), "modes = 2"),
        (("[matrices]", '[matrices]\nunits = "t mm"'), "units = 't mm'"),
    ],
)
def test_a_mistake_is_told_with_its_line(change: tuple[str, str], words: str, brake: Path) -> None:
    brake.write_text(SMALL.replace(*change), encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match=words):
        read_squeal(brake)


def test_onsets_over_another_parameter_are_those_at_each_value(brake: Path, run: Run) -> None:
    brake.with_name("pairs.csv").write_text(
        "across_1,across_2,along_1,along_2,stiffness,direction\n,1,,0,1.0,1\n", encoding="utf-8"
    )
    text = SMALL.replace('friction = "F.npy"', 'contacts = "pairs.csv"')
    brake.write_text(text, encoding="utf-8")
    plot = brake.with_name("map.svg")
    words = ("squeal", str(brake), "--over", "contact=0.8:1.2:3", "--plot", str(plot))
    told = json.loads(run(*words, "--json"))
    assert told["values"] == [0.8, 1.0, 1.2]
    assert not told["incomplete"]
    study = read_squeal(brake)
    for row in told["onsets"]:
        on = ss.flutter_onsets(study.parameters.replace(contact=row["contact"]))
        assert row["mu"] == on.mu[0]
    assert len(told["onsets"]) == 3
    assert "contact" in plot.read_text(encoding="utf-8")
    assert "all onsets at 3 values of contact: proved" in run(*words, "--force")
    for wrong, said in (("mu=0:1:3", "varies already"), ("contact", "its ends"), ("nu=0:1", "nu")):
        assert said in run("squeal", str(brake), "--over", wrong, code=2)


def test_other_questions_are_refused_by_name(brake: Path, run: Run) -> None:
    for words in (("report", str(brake)), ("explore", "--data", str(brake), "--no-open")):
        said = run(*words, code=2)
        assert "ask spragsym squeal" in said
        assert all(word in said for word in ("cusps", "jumps", "basins", "explored"))


def test_onsets_are_drawn_with_the_unstable_stretch(brake: Path) -> None:
    on = ss.flutter_onsets(read_squeal(brake).parameters)
    ax = Figure().add_subplot()
    drawn = on.plot(ax)
    decays, grows = (one.get_xdata() for one in drawn)
    assert grows.min() > on.mu[0] > decays[decays < on.mu[0]].max()
    assert len(ax.patches) == 1
    assert len(on.plot().axes) == 2
