"""Figures: every one is drawn, once and small; what they are drawn from is held to what it promises."""

from __future__ import annotations

import csv
import io
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
from spragsym.cli.figures import figures as command  # noqa: E402  # after matplotlib was found
from spragsym.figures import (  # noqa: E402  # after matplotlib was found
    FIGURES,
    Sheet,
    curves,
    extras,
    figure_11,
    figure_14,
    plot_equilibria,
    space,
    surfaces,
    write,
)
from spragsym.figures.style import LINES  # noqa: E402  # after matplotlib was found
from tests.oracles import article_motion  # noqa: E402  # after matplotlib was found
from tests.support import LONG_MOTIONS_TAKE_MINUTES, few  # noqa: E402  # after matplotlib was found

P = ss.Parameters.article()

#: Panels of each figure, and options that make it quick.
PANELS = {
    "3": 2, "4": 4, "5": 4, "6": 2, "7": 2, "8": 1, "9": 1, "10": 1, "11": 1, "12": 1, "13": 2, "14": 2,
    "cusp-friction": 4, "cycles": 1, "cycles-plane": 1, "false-double-root": 2, "rms-map": 1, "sensitivity": 3,
}  # fmt: skip
QUICK: dict[str, dict[str, Any]] = {
    "7": {"step_deg": 30.0}, "11": {"detail": 0.3}, "14": {"detail": 0.3}, "cusp-friction": {"n": 4},
    "cycles-plane": {"frictions": (), "curves": ()},
    "rms-map": {"step_deg": 45.0, "step_mu0": 0.5, "levels": 1}, "sensitivity": {"step_deg": 10.0},
}  # fmt: skip


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
    assert sorted({panel[0] for panel in figure.tables}) == list("abcd"[: len(axes)])[: len(figure.tables)]
    without = ("12", "cusp-friction", "false-double-root")
    assert "assumption" in figure.caption or "our choice" in figure.caption or name in without
    if name.isdigit():
        assert figure.caption.startswith(f"Figure {name}. ")
    target = io.BytesIO()
    figure.savefig(target, dpi=40)
    assert len(target.getvalue()) > 3000


# ----------------------------------------------------------------------------------------------------- curves


@pytest.mark.parametrize("changes", [{}, {"mu0": 0.7}, {"sigma": 1.0}, {"alpha": 0.07}, {"beta": 2.0}])
def test_branches_are_complete_and_break_where_they_end(changes: dict[str, float]) -> None:
    p = P.replace(**changes)
    found = curves.branches(p)
    for angle in np.radians(np.linspace(0.7, 179.3, 97)):
        eq = ss.equilibria(p.replace(theta0=angle))
        passing = [branch for branch in found if branch.values[0] <= angle <= branch.values[-1]]
        assert len(passing) == eq.count
        for branch in passing:
            x = np.interp(angle, branch.values, branch.x)
            slot = int(np.nanargmin(np.abs(eq.x - x)))
            assert x == pytest.approx(eq.x[slot], abs=2e-3)
            assert branch.stability == eq.stability[slot]
    for branch in found:
        step = np.hypot(np.diff(branch.values), np.diff(branch.x))
        assert step.max() < 0.1


def test_branches_end_at_the_exact_folds() -> None:
    turns = ss.folds(P)
    ends = [(end, branch.values[end], branch.x[end]) for branch in curves.branches(P) for end in (0, -1)]
    for theta0, x in zip(turns.theta0, turns.x, strict=True):
        assert sum((value, state) == (theta0, x) for _, value, state in ends) == 2


def test_branches_change_stability_at_the_exact_onset() -> None:
    p = P.replace(alpha=0.7)
    (found,) = (branch for branch in curves.branches(p) if branch.stability == ss.Stability.FLUTTER)
    np.testing.assert_allclose(found.values[[0, -1]], ss.flutter_onsets(p, damping=False).theta0, atol=1e-6)


def test_plot_equilibria_draws_by_stability() -> None:
    ax = Figure().add_subplot()
    lines = plot_equilibria(P.replace(sigma=1.0), ax=ax)
    dashes = {line.get_linestyle() for line in lines if line.get_marker() == "None"}
    assert dashes == {"-", "--"}  # matplotlib calls every pattern of its own "--"
    patterns = {line._unscaled_dash_pattern for line in lines if line.get_marker() == "None"}  # type: ignore[attr-defined]  # of a line, or of axes in space
    known = {None, *(LINES[kind][1] for kind in (ss.Stability.DIVERGENT, ss.Stability.FLUTTER))}
    assert {pattern[1] and tuple(pattern[1]) for pattern in patterns} == known
    marked = [line for line in lines if line.get_marker() == "o"]
    np.testing.assert_allclose(marked[0].get_xdata(), np.degrees(ss.folds(P.replace(sigma=1.0)).theta0), rtol=1e-12)
    assert lines == ax.get_lines()


def test_a_path_is_drawn_to_the_fold_and_from_where_it_lands() -> None:
    path = ss.quasi_static_path(P.replace(theta0=np.radians(60)), "mu0", np.linspace(1, 0, 30))
    first, second = curves.passages(path)
    (jump,) = path.jumps
    assert (first[0][-1], first[1][-1]) == (jump.value, jump.before["x"])
    assert (second[0][0], second[1][0]) == (jump.value, jump.after["x"])
    assert first[0].size + second[0].size == 32
    assert (np.diff(first[0]) < 0).all()
    artists = curves.draw_path(path, ax=Figure().add_subplot(), arrows=(0.3, 0.7))
    assert len(artists) == 2 * (1 + 2) + 2


# --------------------------------------------------------------------------------------------------- surfaces


@pytest.mark.thorough
@pytest.mark.parametrize("sigma", [0.1, pytest.param(1.0, marks=pytest.mark.thorough)])
def test_the_sheets_cover_the_plane_as_often_as_there_are_equilibria(sigma: float) -> None:
    p = P.replace(sigma=sigma)
    angles = np.linspace(0.5, 179.5, 120)
    found = surfaces.sheets(p, (0.0, 1.0), angles, 120)
    rng = np.random.default_rng(2)
    places = np.stack([rng.uniform(3, 177, 60), rng.uniform(0.03, 0.97, 60)], axis=-1)
    covered: list[list[tuple[int, float]]] = [[] for _ in places]
    for sheet in found:
        for polygon in sheet.polygons:
            assert -1e-9 <= polygon[:, 1].min() <= polygon[:, 1].max() <= 1 + 1e-9
            box = (places >= polygon[:, :2].min(axis=0)).all(axis=-1) & (places <= polygon[:, :2].max(axis=0)).all(axis=-1)
            for i in np.flatnonzero(box):
                if Outline(polygon[:, :2]).contains_point(places[i]):
                    covered[i].append((int(sheet.stability), float(polygon[:, 2].mean())))
    wrong = 0
    for place, states in zip(places, covered, strict=True):
        eq = ss.equilibria(p.replace(theta0=np.radians(place[0]), mu0=place[1]))
        expected = sorted((int(code), float(x)) for code, x in zip(eq.stability, eq.x, strict=True) if code)
        same = [code for code, _ in expected] == [code for code, _ in sorted(states)]
        wrong += not (same and np.allclose([x for _, x in expected], [x for _, x in sorted(states)], atol=0.1))
    assert wrong <= 3  # within a cell of an edge


def _seen_from(ax: Any, place: np.ndarray[Any, Any], samples: int = 1500) -> tuple[np.ndarray[Any, Any], ...]:
    """θ₀ in degrees, μ₀ and x along the line of sight from a place towards the eye, within the axes' box."""
    view = ax.get_proj()
    at = view @ [*place, 1.0]
    screen = at[:3] / at[3]
    depths = screen[2] - np.linspace(0.0, 1.0, samples) * 0.5 * (1 if at[3] > 0 else -1) * abs(screen[2])
    sight = np.stack([np.full(samples, screen[0]), np.full(samples, screen[1]), depths, np.ones(samples)])
    homogeneous = np.linalg.solve(view, sight)
    return tuple(homogeneous[:3] / homogeneous[3])


def _crosses_a_sheet(p: ss.Parameters, ax: Any, place: np.ndarray[Any, Any]) -> bool | None:
    """Whether the surface of equilibria stands before a place, from equilibria alone; None where the line of sight grazes it."""
    theta0, mu0, x = _seen_from(ax, place)
    inside = (theta0 > 0.5) & (theta0 < 179.5) & (mu0 > 0) & (mu0 < 1) & (np.abs(x) < 2.2)
    away = np.abs(theta0 - place[0]) / 180 + np.abs(mu0 - place[1]) + np.abs(x - place[2]) / 4 > 0.02
    good = np.flatnonzero(inside & away)
    if good.size < 2:
        return False
    eq = ss.equilibria(p.replace(theta0=np.radians(theta0[good]), mu0=mu0[good]))
    below = (eq.x < x[good, None]).sum(axis=-1)
    # Passing a sheet turns the parity of how many equilibria lie below; passing beside a fold does not.
    turned = np.flatnonzero((np.diff(below) % 2 != 0) & (np.diff(good) == 1))
    return bool(turned.size)


@pytest.mark.thorough
@pytest.mark.parametrize("draw", [figure_11, figure_14])
def test_lines_are_dashed_exactly_where_a_sheet_hides_them(draw: Any) -> None:
    """Against the surface itself, along the line of sight from each piece to the eye: no mesh takes part in it."""
    ax = draw().axes[0]
    p = P if draw is figure_11 else P.replace(sigma=1.0)
    wrong = looked_at = 0.0
    seen = set()
    for line in ax.get_lines():
        if line.get_marker() != "None":
            continue
        points = np.column_stack(line.get_data_3d())
        hidden = line.get_linewidth() == space.BEHIND["linewidth"]
        length = np.hypot.reduce(np.diff(points / (180, 1, 4), axis=0), axis=1).sum()
        for share in (0.3, 0.5, 0.7):
            crossed = _crosses_a_sheet(p, ax, points[int(share * (len(points) - 1))])
            looked_at += length
            wrong += length * (crossed != hidden)
            seen.add(hidden)
    assert seen == {True, False}
    assert wrong <= 0.1 * looked_at, (wrong, looked_at)  # a line on a sheet seen nearly edge on


# ----------------------------------------------------------------------------------------------------- extras


@pytest.mark.thorough
def test_what_the_caption_says_of_the_second_region(sheets: dict[str, Sheet]) -> None:
    """By SciPy: a stable equilibrium alone, a large cycle beside it, and a start from rest that bounces into it."""

    def reach(mu0: float, state: Any = (0.0, 0.0, 0.0, 0.0), t_end: float = 2000.0) -> tuple[float, Any, float]:
        p = P.replace(theta0=np.radians(132.0), mu0=mu0)
        run = article_motion.integrated(p, 0.5, 10.0, state, t_end, rtol=1e-7, atol=1e-9, max_step=1.0)
        late = run.t > 0.75 * t_end
        return float(np.ptp(run.y[0, late])), run.y[:, -1], float(np.mean(run.y[1, late] > 0))

    small, _, _ = reach(0.75)
    assert small < 0.2
    large, state, above = reach(0.93)
    assert large > 3
    assert above > 0.5
    for mu0 in (0.8, 0.6, 0.45, 0.3):  # followed down, far below where the start from rest reaches it
        swing, state, above = reach(mu0, state, 600.0)
        assert swing > 3
        assert above > 0.5
    for mu0 in (0.3, 0.75, 0.93):
        eq = ss.equilibria(P.replace(theta0=np.radians(132.0), mu0=mu0))
        assert eq.count == 1
        assert eq.stability[0] == ss.Stability.STABLE


def test_the_false_double_root() -> None:
    (angle,) = extras.false_double_roots(P)
    assert 30 < np.degrees(angle) < 40
    gap_L, gap_t = extras.root_gaps(P, np.array([angle - 1e-9, angle + 1e-9]))
    assert gap_L.max() < 1e-6
    assert gap_t.min() > 0.1
    counts = ss.equilibria(P.replace(theta0=np.array([angle - 1e-6, angle + 1e-6]))).count
    assert counts[0] == counts[1] == 3  # no fold
    L = ss.equilibria(P.replace(theta0=angle)).L
    assert np.isclose(L, 0.1 / 0.107, rtol=1e-9).any()
    fold = ss.folds(P).theta0[:1]
    assert [gap.max() < 1e-4 for gap in extras.root_gaps(P, fold + 1e-10)] == [True, True]


# ------------------------------------------------------------------------------------------------------ files


@pytest.mark.thorough
@pytest.mark.parametrize("kinds", few([("pdf", "svg"), ("png",)], ("pdf", "svg")), ids="-".join)
def test_files_have_the_same_bytes_every_time(tmp_path: Path, kinds: tuple[str, ...]) -> None:
    for folder in ("one", "two"):
        paths = write(figure_11(detail=0.2), tmp_path / folder, "figure_11", kinds)
        assert [path.name for path in paths[: len(kinds) + 1]] == [*(f"figure_11.{kind}" for kind in kinds), "figure_11.txt"]
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "two" / path.name).read_bytes(), path.name
    for kind in kinds:
        content = (tmp_path / "one" / f"figure_11.{kind}").read_bytes()
        assert not any(word in content for word in (b"CreationDate", b"dc:date", b"Software", b"Matplotlib"))


def test_data_are_written_to_twelve_digits(tmp_path: Path, sheets: dict[str, Sheet]) -> None:
    write(sheets["4"], tmp_path, "figure_4", [])
    with (tmp_path / "figure_4_a.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert {row["stability"] for row in rows} == {"stable", "divergent"}
    theta0 = {row["theta0_deg"] for row in rows}
    assert {f"{angle:.12g}" for angle in np.degrees(ss.folds(P).theta0)} <= theta0
    assert (tmp_path / "figure_4.txt").read_text(encoding="utf-8").startswith("Figure 4. Equilibria")
    assert all(len(line) <= 100 for line in (tmp_path / "figure_4.txt").read_text(encoding="utf-8").splitlines())


@pytest.mark.thorough
def test_command(tmp_path: Path) -> None:
    result = CliRunner().invoke(command, ["--only", "3,12", "13", "--out", str(tmp_path), "--format", "png,svg", "-j", "1"])
    assert result.exit_code == 0, result.output
    written = [Path(line) for line in result.stdout.splitlines()]
    assert all(path.is_file() for path in written)
    pictures = [path.name for path in written if path.suffix in (".png", ".svg")]
    assert pictures == [f"figure_{name}.{kind}" for name in (3, 12, 13) for kind in ("png", "svg")]
    assert "3/3" in result.stderr
