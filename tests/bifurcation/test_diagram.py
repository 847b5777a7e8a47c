"""The bifurcation diagram of one parameter: labels against what is proved and known, the figure and
the command.
"""

import dataclasses
import importlib.util
import json
import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from tests.design.test_just_touching import FLOOR
from tests.oracles.user_pages import model_of, replaced

pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("heyoka"), reason="branches take SciPy minutes"
)

ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)


@pytest.fixture(scope="module")
def born() -> ss.results.Diagram:
    model = ss.load("stick_slip")
    return ss.diagram(model.Parameters(), "V", between={"V": (0.08, 0.2)}, points=40)


@pytest.fixture(scope="module")
def article() -> ss.results.Diagram:
    return ss.diagram(
        ss.Parameters.article(theta0=math.radians(42.0)),
        "theta0",
        between={"theta0": tuple(np.radians([41.0, 46.0]))},
        starts=[ON_CYCLE],
    )


def of(found: ss.results.Diagram, label: str) -> list[float]:
    return [each.value for each in found.labels if each.label == label]


@pytest.mark.thorough
def test_a_hopf_point_and_the_cycles_that_it_bears(born: ss.results.Diagram) -> None:
    model = ss.load("stick_slip")
    onsets = ss.flutter_onsets(model.Parameters(), "V", between={"V": (0.08, 0.2)})
    few = ss.diagram(model.Parameters(), "V", between={"V": (0.08, 0.2)}, points=3)
    (branch,) = few.cycles
    cut = f"V = {branch.values.max():.10g}: 3 points were followed; give more points"
    assert any(text.endswith(cut) for text in few.remarks)
    assert of(born, "H") == pytest.approx(onsets.V.tolist(), abs=1e-9)
    (rest,), (cycles,) = born.equilibria, born.cycles
    assert (rest.stable == (rest.values < onsets.V[0])).all()
    assert cycles.stable.all()
    assert cycles.values.min() > onsets.V[0] - 1e-6
    height = np.interp(cycles.values, rest.values, rest.states[:, 0])
    assert (cycles.lowest <= height + 1e-6).all()
    assert (cycles.highest >= height - 1e-6).all()


@pytest.mark.thorough
def test_its_table_has_the_points_of_all_branches(born: ss.results.Diagram) -> None:
    table = born.data()
    for kind, branches in (("equilibria", born.equilibria), ("cycles", born.cycles)):
        for number, branch in enumerate(branches):
            rows = (table["of"] == kind) & (table["branch"] == number)
            assert table["V"][rows].tolist() == branch.values.tolist()
            assert table["stable"][rows].tolist() == branch.stable.tolist()
    assert {one.of for one in born.labels} <= set(table["of"])
    assert np.isnan(table["period"][table["of"] == "equilibria"]).all()


@pytest.mark.thorough
def test_what_is_undecided_is_said_and_hatched() -> None:
    """Where the law has no slopes and the mass just touches, no search tells a state from none."""
    pytest.importorskip("sympy")
    axes = pytest.importorskip("matplotlib.figure").Figure().add_subplot()
    cycles = importlib.import_module("spragsym.figures.cycles")
    hertz = ("depth: k_c * depth", "depth: k_c * depth * sqrt(depth / a)")
    page = replaced(FLOOR, hertz, ("Page, tanh", "Page, sqrt, tanh"))
    p = model_of(page, "hertz_floor").Parameters(mu=0.0)
    found = ss.diagram(p, "F", between={"F": (-0.012, 0.012)}, points=2)
    ((low, high),) = found.undecided
    assert -0.012 < low < 0.0 < high < 0.012
    assert any("may be missing for F" in text for text in found.remarks)
    cycles.draw_diagram(found, axes)
    ((x, width),) = ((patch.get_x(), patch.get_width()) for patch in axes.patches)
    assert (x, x + width) == pytest.approx((low, high))
    assert ss.diagram(p, "F", between={"F": (0.01, 0.012)}, points=2).undecided == ()


@pytest.mark.thorough
def test_a_cycle_of_a_branch_that_is_there_gives_no_second_one() -> None:
    model = ss.load("stick_slip")
    onsets = ss.flutter_onsets(model.Parameters(), "V", between={"V": (0.08, 0.2)})
    few = ss.diagram(model.Parameters(), "V", between={"V": (0.08, 0.2)}, points=3)
    (branch,) = few.cycles
    cut = f"V = {branch.values.max():.10g}: 3 points were followed; give more points"
    assert any(text.endswith(cut) for text in few.remarks)
    found = ss.diagram(
        model.Parameters(),
        "V",
        between={"V": (0.08, 0.2)},
        points=40,
        starts=[ss.cycle(onset=onsets, index=0)],
    )
    assert len(found.cycles) == 1
    assert not found.remarks


@pytest.mark.thorough
def test_a_branch_of_equilibria_is_there_once() -> None:
    """On one branch a torsion spring is counted on either of its ways."""
    found = ss.diagram(
        ss.load("sprag_rod").Parameters(theta0=0.6), "mu0", between={"mu0": (0.0, 2.0)}
    )
    assert of(found, "LP") == pytest.approx([0.5986956385], abs=1e-9)
    assert len(found.equilibria) == 2


@pytest.mark.thorough
def test_equilibria_of_the_motion_turn_at_the_fold_of_the_friction_that_works(
    article: ss.results.Diagram,
) -> None:
    friction = ss.kang_nam.sliding_friction(0.5, 0.5, 10.0)
    folds = ss.folds(ss.Parameters.article(mu0=friction), "theta0").theta0
    (fold,) = of(article, "LP")
    assert np.abs(folds - fold).min() < 1e-9
    assert of(article, "PD") == pytest.approx([math.radians(43.118922549)], abs=1e-10)
    assert {branch.mode for branch in article.equilibria} == {"contact", "lift-off"}
    first, doubled = article.cycles
    assert doubled.stable.all()
    assert doubled.periods.min() > 1.9 * first.periods.max()
    known = ss.equilibria(ss.Parameters.article(theta0=math.radians(42.0), mu0=friction)).x
    for x in known[np.isfinite(known)]:
        assert any(
            abs(np.interp(math.radians(42.0), branch.values[part], branch.states[part, 0]) - x)
            < 1e-3
            for branch in article.equilibria
            for part in parts(branch.values)
        )


def parts(values: Any) -> list[Any]:
    """Stretches over which values rise, in rising order."""
    turns = [0, *(np.flatnonzero(np.diff(np.sign(np.diff(values)))) + 1), len(values) - 1]
    found = [np.arange(a, b + 1) for a, b in pairwise(turns)]
    return [part if values[part[-1]] > values[part[0]] else part[::-1] for part in found]


@pytest.mark.thorough
def test_the_figure_and_the_command(born: ss.results.Diagram, tmp_path: Any) -> None:
    Figure = pytest.importorskip("matplotlib.figure").Figure
    (hopf,) = (label for label in born.labels if label.label == "H")
    beside, far = (dataclasses.replace(hopf, value=value) for value in (hopf.value + 1e-4, 0.18))
    for labels, texts in (((hopf,), ["H"]), ((hopf, beside), ["H"]), ((hopf, far), ["H", "H"])):
        drawn = ss.figures.diagram_figure(dataclasses.replace(born, labels=labels))
        assert [text.get_text() for text in drawn.axes[0].texts] == texts
    ax, other = Figure().subplots(1, 2)
    born.plot(ax=ax)
    born.cycles[0].plot(ax=other)
    assert len(ax.lines) == len(drawn.axes[0].lines) - 1  # of the second label
    assert other.lines
    picture = tmp_path / "all.svg"
    call = [
        "cycles",
        "--model",
        "stick_slip",
        "-V",
        "0.2",
        "--vary",
        "V=0.09:0.12",
        "--points",
        "12",
    ]
    result = CliRunner().invoke(cli, [*call, "--diagram", "--plot", str(picture), "--json"])
    told = json.loads(result.stdout)
    assert [label["label"] for label in told["labels"]] == ["H"]
    assert told["labels"][0]["V"] == pytest.approx(0.10101536, abs=1e-8)
    assert picture.exists()
    refused = CliRunner().invoke(cli, ["cycles", "--model", "stick_slip", "--diagram"])
    assert refused.exit_code == 2
