"""The verdict over a quantity, or two."""

import csv
import io
import math
from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError, ParameterError
from spragsym.report import over
from spragsym.report.over import verdicts_over
from tests.conftest import Run
from tests.oracles.mistakes import BRAKE
from tests.support import written_brake


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> ss.Study:
    return ss.Study.from_file(written_brake(tmp_path_factory.mktemp("over"), BRAKE))


def test_a_verdict_is_that_of_the_brake_with_the_value(study: ss.Study) -> None:
    values = np.array([30.0, 40.0, 60.0, 120.0])
    found = verdicts_over(study, {"theta0": values})
    jumps = ss.jump_value(study.operating_point.replace(theta0=np.radians(values)), "mu0")
    told = np.array([row[1] for row in found.rows], dtype=float)
    np.testing.assert_allclose(told, jumps, rtol=1e-12)
    margins = np.array([row[2] for row in found.rows], dtype=float)
    most = 0.6 * (1 - math.exp(-10 * 1.2))  # at the belt's speed
    np.testing.assert_allclose(margins, 100 * (jumps / most - 1), rtol=1e-9)
    wanted = ["does not jump", "jumps within the tolerances", "has jumped", "never jumps"]
    assert [row[3] for row in found.rows] == wanted
    assert found.titles == ("theta0 [deg]", "jump friction", "margin [%]", "outcome", "state")
    assert (found.onsets, found.unsettled) == ((), "")


def test_a_damping_ratio_holds_over_a_stiffness_and_a_mass(tmp_path: Path) -> None:
    """The dampers of each point are those of a file with its values."""
    rows = {**BRAKE, "damping_ratio": "2 %"}
    study = ss.Study.from_file(written_brake(tmp_path, rows))
    there = {**rows, "k": "400 N/mm", "m": "0.2 kg"}
    other = ss.Study.from_file(written_brake(tmp_path, there))
    found = over.brake_at(study, {"k": 400.0, "m": 0.2})
    assert found.values == pytest.approx(other.values, rel=1e-12)
    assert found.values["c_y"] != pytest.approx(study.values["c_y"], rel=0.01)
    c_x = 2 * study.values["c_x"]
    assert over.brake_at(study, {"c_x": c_x}).values == {**study.values, "c_x": c_x}


def test_a_table_for_a_spreadsheet_has_numbers_and_words_alone(study: ss.Study) -> None:
    found = verdicts_over(study, {"k": np.array([100.0, 300.0]), "theta0": np.array([60.0, 120.0])})
    head, *lines = csv.reader(io.StringIO(found.csv()))
    assert head[:2] == ["k [N/mm]", "theta0 [deg]"]
    assert [line[:2] for line in lines] == [
        [k, angle] for k in ("100.0", "300.0") for angle in ("60.0", "120.0")
    ]
    for line in lines:
        assert len(line) == len(head)
        for cell in line:
            assert not cell or cell[0] not in "=+-@#" or math.isfinite(float(cell))


def test_where_sliding_becomes_unstable_is_told() -> None:
    study = ss.Study(
        {"m": 1.0, "k": 100.0, "N_0": 10.0, "mu_s": 0.5, "v_s": 0.1, "c": 5.0, "V": 0.2},
        model="stick_slip",
    )
    speeds = np.array([0.15, 0.3, 0.6, 1.2])
    found = verdicts_over(study, {"V": speeds})
    growth = []
    for speed in speeds:
        p = study.kind.parameter_set({**study.values, "V": speed})
        growth.append(float(ss.equilibria(p).growth[0]))
    signs = ["unstable" if one > 0 else "stable" for one in growth]
    assert [row[4] for row in found.rows] == signs
    assert len(set(signs)) == 2
    at = next(i for i in range(3) if signs[i] != signs[i + 1])
    assert found.onsets[0].startswith(f"V [m/s] {speeds[at]:g} to {speeds[at + 1]:g}: from")


def test_what_is_not_settled_says_what_to_do(
    study: ss.Study, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object) -> None:
        raise ConvergenceError("no state was found; look elsewhere")

    monkeypatch.setattr(over, "current", fails)
    found = verdicts_over(study, {"theta0": np.array([30.0, 40.0])})
    assert found.unsettled.startswith(
        "2 of 2 unsettled, the first because no state was found; write"
    )
    assert found.csv().splitlines()[1] == "30.0,,,unsettled,"


def test_a_value_that_is_none_is_refused_before_anything_is_asked(study: ss.Study) -> None:
    with pytest.raises(ParameterError, match=r"over: theta0 = 200 deg is not in \(0, pi\)"):
        verdicts_over(study, {"theta0": np.array([30.0, 200.0])})
    with pytest.raises(ParameterError, match=r"'thetaO' is no quantity .* did you mean theta0"):
        verdicts_over(study, {"thetaO": np.array([30.0])})


def test_the_command_writes_table_and_picture(run: Run, tmp_path: Path) -> None:
    table, picture = tmp_path / "o.csv", tmp_path / "o.svg"
    asked = ["report", str(written_brake(tmp_path, BRAKE)), "--over", "theta0=30:60:2"]
    told = run(*asked, "--csv", str(table), "--plot", str(picture))
    assert "does not jump" in told
    assert table.read_text(encoding="utf-8").count("\n") == 3
    assert picture.read_text(encoding="utf-8").startswith("<?xml")
    assert '"onsets": []' in run(*asked, "--json")


def test_a_belt_too_slow_for_the_jump_jumps_at_higher_speed(study: ss.Study) -> None:
    """0.6 (1 − exp(−0.2)) = 0.11 is below the jump at 0.37, which is below 0.6."""
    (row,) = verdicts_over(study, {"V": np.array([0.02])}).rows
    assert row[3] == "jumps at higher speed"


def test_what_to_do_with_a_point_that_is_unsettled() -> None:
    row = (52.0, math.nan, math.nan, "unsettled", "")
    assert over.Verdicts(("theta0 [deg]",), (row, row), "it is open").unsettled == (
        "2 of 2 unsettled, the first because it is open; write that value into the file and ask "
        "for its report, which says more, or take other ends"
    )


@pytest.mark.parametrize("jumps", [(0.4, 0.3, math.nan), (math.nan,) * 3], ids=["some", "none"])
def test_the_picture_shows_every_point(jumps: tuple[float, ...]) -> None:
    """Those too that would jump at no value; hollow where sliding is unstable."""
    pytest.importorskip("matplotlib")
    from spragsym.figures.over import verdict_figure

    states = ("stable", "unstable", "unstable")
    rows = tuple(
        (float(k), jump, 10 * jump, "never jumps" if math.isnan(jump) else "does not jump", state)
        for k, jump, state in zip((1, 2, 4), jumps, states, strict=True)
    )
    titles = ("k [N/mm]", "jump friction", "margin [%]", "outcome", "state")
    figure = verdict_figure(over.Verdicts(titles, rows, ""))
    assert len(figure.axes) == (1 if math.isnan(jumps[0]) else 2)
    for ax in figure.axes:
        marks = [line for line in ax.lines if line.get_marker() == "o"]
        shown = {x: line.get_markerfacecolor() for line in marks for x in line.get_xdata()}
        assert [shown[k] == "white" for k in (1, 2, 4)] == [False, True, True]
        low, high = ax.get_xlim()
        assert low < 1 < 4 < high
    (legend,) = figure.legends
    assert not any(ax.get_legend() for ax in figure.axes)
    words = {text.get_text() for text in legend.get_texts()}
    assert "never jumps, unstable" in words
