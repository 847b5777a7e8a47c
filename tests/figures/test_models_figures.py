"""Figures of models: what is drawn is what was computed, on the axes that were given."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.branches import undecided_points
from spragsym.models.load import shipped
from tests.oracles.gap_pages import HANDS
from tests.oracles.user_pages import model_of, shipped_page
from tests.support import few

plot = pytest.importorskip("matplotlib.figure")

from spragsym import figures  # noqa: E402  needs matplotlib

BETWEEN = {"mu0": (0.0, 1.0)}


@pytest.fixture(scope="module")
def found():
    model = ss.load("kang_nam").search
    return ss.bifurcation_set(model.Parameters(theta0=1.0), n=6, between=BETWEEN)


@pytest.fixture
def ax():
    return plot.Figure().subplots()


@pytest.mark.thorough
def test_the_bifurcation_set_on_given_axes(ax, found):
    lines = figures.draw_bifurcation_set(found, ax)
    assert len(lines) == len(found.curves) + 1
    assert all(line.axes is ax for line in lines)
    for line, curve in zip(lines, found.curves, strict=False):
        assert np.allclose(line.get_xdata(), np.degrees(curve.theta0))
        assert np.allclose(line.get_ydata(), curve.mu0)
    assert np.allclose(lines[-1].get_ydata(), found.cusps.mu0)


@pytest.mark.by_hand(
    "trolley",
    "pad_on_disc",
    "two_springs",
    "sprag_rod",
    "stribeck",
    "cubic_contact",
    "damped",
    "inclined_belt",
)
@pytest.mark.thorough
@pytest.mark.parametrize(
    "name", few([name for name in shipped() if not ss.load(name).clock], "mode_coupling")
)
def test_curves_pass_through_all_equilibria(name, ax):
    """At random values as many curves as there are states, near them and of their stability; two of
    them end on each fold.
    """
    model = ss.load(name)
    p = model.Parameters(**({"theta0": 0.7} if "theta0" in model.parameters else {}))
    vary, first = model.axes[0], model.coordinates[0]
    found = figures.branches(p, vary, n=120)
    low, high = min(one.values[0] for one in found), max(one.values[-1] for one in found)
    values = low + (high - low) * np.random.default_rng(2).uniform(0.02, 0.98, 40)
    eq = ss.equilibria(p.replace(**{vary: values}))
    for i, value in enumerate(values):
        passing = [one for one in found if one.values[0] <= value <= one.values[-1]]
        assert len(passing) == eq.count[i]
        for one in passing:
            away = np.abs(getattr(eq, first)[i] - np.interp(value, one.values, one.states[first]))
            slot = int(np.nanargmin(away))
            assert away[slot] < 0.02
            assert one.kind == eq.undamped[i, slot]
    turns = ss.folds(p, vary, between={vary: (float(low), float(high))})
    for value, state in zip(getattr(turns, vary), getattr(turns, first), strict=True):
        ends = [(one.values[end], one.states[first][end]) for one in found for end in (0, -1)]
        assert (
            sum(
                at == pytest.approx(value, abs=1e-9) and place == pytest.approx(state, abs=1e-6)
                for at, place in ends
            )
            == 2
        )
    lines = figures.plot_equilibria(p, vary=vary, ax=ax, n=20)
    assert lines == ax.get_lines()
    assert ax.get_xlabel()


@pytest.mark.parametrize(
    ("name", "values", "rows"), [("trolley", {"theta0": 0.8}, 3), ("forced_oscillator", {}, 1)]
)
def test_a_motion_has_a_row_of_lettered_panels_for_each_coordinate(
    name: str, values: dict[str, float], rows: int
) -> None:
    """None for the phase of a clock, which is known."""
    motion = ss.simulate(ss.load(name).Parameters(**values), t_end=5.0, backend="scipy")
    figure = figures.motion_figure(motion)
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert titles == [f"({letter})" for letter in "abcdefghi"[: 3 * rows]]
    assert list(figure.tables) == [*"abcdefghi"[: 3 * rows]]


def test_a_belt_whose_speed_is_no_parameter_is_drawn_where_it_runs() -> None:
    page = shipped_page("stick_slip", ("friction(x, V,", "friction(x, 2 * V,"))
    motion = ss.simulate(model_of(page, "fast_belt").Parameters(V=0.3), t_end=5.0, backend="scipy")
    figure = figures.motion_figure(motion, 0.0, ss.Scales(length=0.01, time=0.1, force=1.0))
    *_, belt = figure.axes[1].get_lines()
    assert list(belt.get_ydata()) == pytest.approx([2 * 0.3 * 10 / 0.1] * 2)
    assert "belt speed 60 mm/s" in figure.caption


@pytest.mark.thorough
def test_a_motion_on_the_command_line_is_drawn_in_the_units_of_the_file(tmp_path, monkeypatch, run):
    """Of the article's model and of one that turns: a row for each coordinate, with its plane and
    its spectrum.
    """
    seen = []
    drawn = figures.motion_figure
    monkeypatch.setattr(
        figures, "motion_figure", lambda *args: seen.append(drawn(*args)) or seen[-1]
    )
    size = {
        "kg": 0.35,
        "N/m": 1.5e6,
        "m": 0.038,
        "rad": 0.7,
        "N": 420.0,
        "1": 0.3,
        "m/s": 1.2,
        "s/m": 10.0,
    }
    file, picture = tmp_path / "brake.toml", tmp_path / "motion.svg"
    for name in ("kang_nam", "sprag_rod"):
        about = ss.load(name).about
        units = {entry["name"]: entry["unit"] for entry in about["units"]}
        units |= {entry["quantity"]: entry["quantity_unit"] for entry in about["parameters"]}
        rows = ["[brake]", f'model = "{name}"']
        for key, unit in units.items():
            rows.append(f'{key} = "{size.get(unit, 0.01)!r} {unit if unit != "1" else ""}"')
        file.write_text("\n".join(rows), encoding="utf-8")
        run("simulate", "--data", str(file), "--t-end", "60", "--plot", str(picture), "--force")
    article, rod = seen
    assert [ax.get_ylabel() for ax in article.axes[:2]] == ["$x$ (mm)", r"$\dot{x}$ (mm/s)"]
    assert len(article.axes) == 3 * 2
    assert len(rod.axes) == 3 * len(ss.load("sprag_rod").coordinates)
    assert "(deg)" in rod.axes[0].get_ylabel()
    assert rod.axes[1].get_ylabel() == r"$\dot{\phi}$ (deg/s)"


def test_undecided_stretches_are_drawn_where_they_are() -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    p = ss.load("stick_slip").Parameters()
    found = ss.onset_curves(p, ("V", "zeta"), 4, between={"V": (0.1, 1.0), "zeta": (0.0, 0.5)})
    box = np.array([[[0.0, 0.1], [0.3, 0.4], [0.2, 0.2]]])
    _, (plain, marked) = pyplot.subplots(1, 2)
    before = len(figures.draw_onset_curves(replace(found, undecided=box[:0]), plain))
    line = figures.draw_onset_curves(replace(found, undecided=box, complete=False), marked)[before]
    assert (line.get_xdata().tolist(), line.get_ydata().tolist()) == ([0.3, 0.4], [0.2, 0.2])
    assert marked.get_xlim() == (0.1, 1.0)
    pyplot.close("all")


@pytest.mark.thorough
def test_what_is_undecided_is_hatched(ax):
    """A line at a point that is undecided, and of curves the range between the points beside it."""
    pytest.importorskip("sympy")
    p = model_of(HANDS["rail"].page, "rail").Parameters(mu0=0.0)
    found = figures.branches(p, "kappa", between={"kappa": (0.01, 0.05)}, n=3)
    assert len(found.undecided) == 0
    eq = ss.equilibria(p.replace(kappa=[-0.02, 0.0, 0.02, 0.03]))
    eq = replace(eq, decided=np.array([True, False, True, True]))
    figures.plot(eq, ax)
    assert [patch.get_x() for patch in ax.patches] == [0.0]
    found.undecided = undecided_points(eq, "kappa", (-0.03, 0.03))
    assert found.undecided.tolist() == [[-0.02, 0.02]]
    figures.draw_branches(found, ax=ax)
    shown = ax.patches[-1]
    assert (shown.get_x(), shown.get_x() + shown.get_width()) == pytest.approx((-0.02, 0.02))
