"""Figures: every one is drawn, once and small; what they are drawn from is held to what it
promises.
"""

import inspect
import io
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

from matplotlib.figure import Figure  # noqa: E402  # after matplotlib was found
from matplotlib.path import Path as Outline  # noqa: E402  # after matplotlib was found

import spragsym as ss  # noqa: E402  # after matplotlib was found
from spragsym.cli.article import figures as command  # noqa: E402  # after matplotlib was found
from spragsym.figures import (  # noqa: E402  # after matplotlib was found
    FIGURES,
    Sheet,
    bifurcation_sets,
    curves,
    fate_map_figure,
    figure_11,
    figure_12,
    style,
    write,
)
from tests.support import LONG_MOTIONS_TAKE_MINUTES, few  # noqa: E402  # after matplotlib was found

P = ss.Parameters.article()

#: Panels of each figure, and options that make it quick.
PANELS = {
    "3": 2,
    "4": 4,
    "5": 4,
    "6": 2,
    "7": 2,
    "8": 1,
    "9": 1,
    "10": 1,
    "11": 1,
    "12": 1,
    "13": 2,
    "14": 2,
    "cusp-friction": 4,
    "cycles": 1,
    "cycles-plane": 1,
    "false-double-root": 2,
    "rms-map": 1,
    "sensitivity": 3,
}
QUICK: dict[str, dict[str, Any]] = {
    "7": {"step_deg": 30.0},
    "11": {"detail": 0.3},
    "14": {"detail": 0.3},
    "cusp-friction": {"n": 4},
    "cycles-plane": {"frictions": (), "curves": ()},
    "rms-map": {"step_deg": 45.0, "step_mu0": 0.5, "levels": 1},
    "sensitivity": {"step_deg": 10.0},
}


#: The others take a second each.
QUICKLY_DRAWN = ("3", "10", "12")

#: Those that integrate many motions.
MOVING = ("7", "cycles", "cycles-plane", "rms-map", "sensitivity")


class Sheets(dict[str, Sheet]):
    """Figures by name, each drawn when a test asks first."""

    def __missing__(self, name: str) -> Sheet:
        if name in MOVING and LONG_MOTIONS_TAKE_MINUTES:
            pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
        self[name] = FIGURES[name](**QUICK.get(name, {}))
        return self[name]


@pytest.fixture(scope="module")
def sheets() -> dict[str, Sheet]:
    return Sheets()


def test_each_name_is_that_of_its_figure() -> None:
    for name, drawn in FIGURES.items():
        assert drawn.__name__ == f"figure_{name.replace('-', '_')}"


@pytest.mark.by_hand("cycles")
@pytest.mark.parametrize("name", few(FIGURES, *QUICKLY_DRAWN))
def test_a_figure_is_drawn(sheets: dict[str, Sheet], name: str) -> None:
    figure = sheets[name]
    assert isinstance(figure, Figure)
    axes = [ax for ax in figure.axes if ax.get_label() != "<colorbar>"]
    assert len(axes) == PANELS[name]
    assert all(ax.get_xlabel() for ax in axes)
    assert axes[0].get_ylabel()
    letters = {ax.get_title(loc="left") for ax in axes} | {text.get_text() for text in figure.texts}
    assert len(axes) == 1 or {f"({letter})" for letter in "abcd"[: len(axes)]} <= letters
    assert (
        sorted({panel[0] for panel in figure.tables})
        == list("abcd"[: len(axes)])[: len(figure.tables)]
    )
    without = ("12", "cusp-friction", "false-double-root")
    assert "assumption" in figure.caption or "our choice" in figure.caption or name in without
    if name.isdigit():
        assert figure.caption.startswith(f"Figure {name}. ")
    if name == "5":
        assert (np.diff(figure.tables["a_linear"]["theta0_deg"]) > 0).all()
    target = io.BytesIO()
    figure.savefig(target, dpi=40)
    assert len(target.getvalue()) > 3000


# ------------------------------------------------------------------------------------------------
# curves


def test_what_is_no_set_of_parameters_and_no_result_is_refused_by_its_name() -> None:
    drawn = (getattr(ss.figures, name) for name in ss.figures.__all__)
    asked = [
        (draw, *inspect.signature(draw).parameters) for draw in drawn if inspect.isfunction(draw)
    ]
    of_parameters = [(draw, more) for draw, *more in asked if more[:1] == ["p"]]
    assert len(of_parameters) == 5
    for draw, more in of_parameters:
        needed = {key: {"theta0": (0.0, 1.0)} for key in {"vary", "between"} & {*more}}
        with pytest.raises(
            ss.errors.ParameterTypeError, match="p = 'stick_slip' is no set of parameters; make one"
        ):
            draw("stick_slip", **needed)
    results = {"result", "found", "path", "motion", "turns", "branch"}
    for draw in (one for one, *more in asked if results & {*more[:1]}):
        with pytest.raises(ss.errors.ParameterTypeError, match=r"= 'stick_slip' is no \w+; give "):
            draw("stick_slip")


def test_branches_end_at_the_exact_folds() -> None:
    turns = ss.folds(P)
    ends = [
        (end, branch.values[end], branch.x[end]) for branch in curves.branches(P) for end in (0, -1)
    ]
    for theta0, x in zip(turns.theta0, turns.x, strict=True):
        assert sum((value, state) == (theta0, x) for _, value, state in ends) == 2


# ------------------------------------------------------------------------------------------------
# surfaces


@pytest.mark.thorough
@pytest.mark.parametrize("sigma", [0.1, pytest.param(1.0, marks=pytest.mark.thorough)])
def test_the_sheets_cover_the_plane_as_often_as_there_are_equilibria(sigma: float) -> None:
    p = P.replace(sigma=sigma)
    angles = np.linspace(0.5, 179.5, 120)
    cells, kinds = bifurcation_sets.sheets(p, angles, 120)
    assert 0.0 <= cells[..., 1].min() <= cells[..., 1].max() <= 1.0
    rng = np.random.default_rng(2)
    places = np.stack([rng.uniform(3, 177, 60), rng.uniform(0.03, 0.97, 60)], axis=-1)
    covered: list[list[tuple[int, float]]] = [[] for _ in places]
    for cell, kind in zip(cells, kinds, strict=True):
        for i in np.flatnonzero(Outline(cell[:, :2]).contains_points(places)):
            covered[i].append((int(kind), float(cell[:, 2].mean())))
    wrong = 0
    for place, states in zip(places, covered, strict=True):
        eq = ss.equilibria(p.replace(theta0=np.radians(place[0]), mu0=place[1]))
        found = zip(eq.undamped[: eq.count], eq.x[: eq.count], strict=True)
        expected = [(code, pytest.approx(x, rel=1e-5, abs=0.1)) for code, x in sorted(found)]
        wrong += sorted(states) != expected
    assert wrong <= 3  # within a cell of an edge


# ------------------------------------------------------------------------------------------------
# extras


def test_the_false_double_root() -> None:
    (angle,) = bifurcation_sets.false_double_roots(P)
    assert 30 < np.degrees(angle) < 40
    gap_L, gap_t = bifurcation_sets.root_gaps(P, np.array([angle - 1e-9, angle + 1e-9]))
    assert gap_L.max() < 1e-6
    assert gap_t.min() > 0.1
    counts = ss.equilibria(P.replace(theta0=np.array([angle - 1e-6, angle + 1e-6]))).count
    assert counts[0] == counts[1] == 3  # no fold
    L = ss.equilibria(P.replace(theta0=angle)).L
    assert np.isclose(L, 0.1 / 0.107, rtol=1e-9).any()
    fold = ss.folds(P).theta0[:1]
    assert [gap.max() < 1e-4 for gap in bifurcation_sets.root_gaps(P, fold + 1e-10)] == [True, True]


def test_undecided_motions_that_are_irregular_stand_out() -> None:
    found = ss.fate_map(P.replace(theta0=[0.5, 0.6], mu0=[[0.4], [0.5]]), V=0.5, d=10.0, t_end=20.0)
    assert not found.kind.any()  # all are undecided so early
    found = replace(
        found, exponent=np.array([[1.0, 0.0], [0.0, 0.0]]), exponent_error=np.full((2, 2), 0.5)
    )
    lines = fate_map_figure(found).axes[0].lines
    marks = {line.get_marker(): line.get_xydata() for line in lines if line.get_xydata().size}
    assert marks["+"] == pytest.approx(np.array([[np.degrees(0.5), 0.4]]))
    assert len(marks["x"]) == 3
    ax = Figure().add_subplot()
    found.plot(ax=ax)
    assert {line.get_marker() for line in ax.lines if line.get_xydata().size} == {"x", "+"}


# ------------------------------------------------------------------------------------------------
# files


@pytest.mark.thorough
@pytest.mark.parametrize("kinds", few([("pdf", "svg"), ("png",)], ("pdf", "svg")), ids="-".join)
def test_files_have_the_same_bytes_every_time(tmp_path: Path, kinds: tuple[str, ...]) -> None:
    for folder in ("one", "two"):
        paths = write(figure_11(detail=0.2), tmp_path / folder, "figure_11", kinds)
        assert [path.name for path in paths[: len(kinds) + 1]] == [
            *(f"figure_11.{kind}" for kind in kinds),
            "figure_11.txt",
        ]
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "two" / path.name).read_bytes(), path.name
    for kind in kinds:
        content = (tmp_path / "one" / f"figure_11.{kind}").read_bytes()
        assert not any(
            word in content for word in (b"CreationDate", b"dc:date", b"Software", b"Matplotlib")
        )


@pytest.mark.thorough
def test_command(tmp_path: Path) -> None:
    result = CliRunner().invoke(
        command, ["3,12", "13", "--out", str(tmp_path), "--format", "png,svg", "-j", "1"]
    )
    assert result.exit_code == 0, result.output
    written = [Path(line) for line in result.stdout.splitlines()]
    assert all(path.is_file() for path in written)
    pictures = [path.name for path in written if path.suffix in (".png", ".svg")]
    assert pictures == [f"figure_{name}.{kind}" for name in (3, 12, 13) for kind in ("png", "svg")]
    assert "3/3" in result.stderr


def test_a_notebook_shows_a_figure() -> None:
    assert figure_12()._repr_png_().startswith(b"\x89PNG")
    with style.house_style():
        matplotlib.interactive(
            True
        )  # as the backend of a notebook does when pyplot is first imported
    assert matplotlib.is_interactive()
    matplotlib.interactive(False)
