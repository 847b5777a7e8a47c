"""Figures of models: what is drawn is what was computed, on the axes that were given."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.load import shipped
from tests.support import few

plot = pytest.importorskip("matplotlib.figure")

from spragsym import figures  # noqa: E402  needs matplotlib
from spragsym.figures.labels import label, window  # noqa: E402  needs matplotlib

BETWEEN = {"mu0": (0.0, 1.0)}


@pytest.fixture(scope="module")
def found():
    model = ss.load("kang_nam").search
    return model.bifurcation_set(model.Parameters(theta0=1.0), n=6, between=BETWEEN)


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


@pytest.mark.by_hand("trolley", "pad_on_disc", "two_springs", "sprag_rod", "stribeck")
@pytest.mark.thorough
@pytest.mark.parametrize("name", few(shipped(), "mode_coupling"))
def test_curves_pass_through_all_equilibria(name, ax):
    """At random values as many curves as there are states, near them and of their stability; two of them end on each fold."""
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
            assert one.stability == eq.stability[i, slot]
    turns = ss.folds(p, vary, between={vary: (float(low), float(high))})
    for value, state in zip(getattr(turns, vary), getattr(turns, first), strict=True):
        ends = [(one.values[end], one.states[first][end]) for one in found for end in (0, -1)]
        assert sum(at == pytest.approx(value, abs=1e-9) and place == pytest.approx(state, abs=1e-6) for at, place in ends) == 2
    lines = figures.plot_equilibria(p, vary=vary, ax=ax, n=20)
    assert lines == ax.get_lines()
    assert ax.get_xlabel()


@pytest.mark.thorough
def test_curves_by_search_are_those_of_closed_forms():
    p = ss.Parameters.article(mu0=0.7)
    closed = figures.branches(p, n=60)
    search = figures.branches(ss.load("cubic_contact").Parameters(mu0=0.7, gamma=0.0), n=60)
    assert len(closed) == len(search)
    for one in closed:
        assert any(
            one.values.shape == other.values.shape
            and np.allclose(one.values, other.values, atol=1e-9)
            and np.allclose(one.x, other.x, atol=1e-6)
            for other in search
        )
        assert pickle.loads(pickle.dumps(one)).x.tolist() == one.x.tolist()  # noqa: S301  # our own


def test_onsets_are_the_closed_form_of_mode_coupling(ax):
    model = ss.load("mode_coupling")
    (dots,) = figures.draw_onsets(
        model.Parameters(), ("sigma", "mu0"), ax, damping=False, between={"sigma": (0.1, 2.0), "mu0": (0.0, 5.0)}, n=5
    )
    sigma, alpha, beta = dots.get_xdata(), model.base["alpha"], model.base["beta"]
    assert sigma.size == 5
    assert np.allclose(dots.get_ydata(), ((1 + beta - alpha) ** 2 + sigma**2) / (2 * sigma), atol=1e-12)


def test_onsets_are_the_closed_form_of_stick_slip(ax):
    model = ss.load("stick_slip")
    (dots,) = figures.draw_onsets(model.Parameters(), ("V", "zeta"), ax, between={"V": (0.15, 1.0), "zeta": (0.0, 5.0)}, n=5)
    V, mu_s, v_s = dots.get_xdata(), model.base["mu_s"], model.base["v_s"]
    assert V.size == 5
    assert np.allclose(dots.get_ydata(), 2 * mu_s * v_s * (V**2 - v_s**2) / (V**2 + v_s**2) ** 2, atol=1e-12)


def test_labels_are_those_of_the_dimensionless_numbers():
    assert label(ss.load("mode_coupling"), "sigma") == r"$\sigma$"
    assert label(ss.load("two_springs"), "sigma_2") == r"$\sigma_{\rm 2}$"
    assert label(ss.load("kang_nam").search, "theta0") == r"$\theta_o$ (deg)"


@pytest.mark.thorough
def test_plot_on_the_command_line(tmp_path, monkeypatch, run, found):
    monkeypatch.setattr("spragsym.models.Model.bifurcation_set", lambda self, p, vary, n, **options: found)
    file = tmp_path / "set.svg"
    command = ["bifurcation", "--method", "search", "--plot", str(file)]
    run(*command)
    assert file.read_text(encoding="utf-8").startswith("<?xml")
    assert "--force" in run(*command, code=2)
    run(*command[:-1], str(tmp_path / "set.gif"), code=2)


@pytest.mark.thorough
def test_a_range_is_searched_and_drawn(tmp_path, monkeypatch, run):
    """Of the two folds of the article's model only the one within the range; the cusp is outside of it."""
    search = ss.load("kang_nam").search.bifurcation_set
    monkeypatch.setattr(
        "spragsym.models.Model.bifurcation_set", lambda self, p, vary, n, **options: search(p, vary, 4, **options)
    )
    command = ["bifurcation", "--vary", "theta0=100:170", "--vary", "mu0=0.3:0.6", "--json"]
    told = json.loads(run(*command, "--plot", str(tmp_path / "set.svg")))
    assert [row["theta0_deg"] for row in told["folds"]["points"]] == pytest.approx([155.05941879], abs=1e-7)
    assert told["cusps"]["points"] == []
    wrong = {
        "mu0=": "give it as mu0=0:1", "mu0=1": "give it as mu0=0:1", "mu0=1:1": "both ends are 1",
        "mu0=-1:1": "is not in [0, inf)",
        "theta0=0:181": "theta0_deg = 181 is not in (0, 180)", "mu0=0:1:1": "2 to 100000", "sgma=0:1": "did you mean sigma?",
    }  # fmt: skip
    for given, text in wrong.items():
        assert text in run("bifurcation", "--vary", given, code=2)


@pytest.mark.thorough
def test_the_window_of_a_bifurcation_set_holds_every_cusp_that_was_found() -> None:
    model = ss.load("two_springs")
    cusps = ss.cusps(model.Parameters(), ("theta0", "mu0"))
    assert (
        window(model, ("theta0", "mu0"), {})["mu0"][1] < cusps.mu0.max() < window(model, ("theta0", "mu0"), {}, cusps)["mu0"][1]
    )
    assert window(model, ("theta0", "mu0"), {"mu0": (0.0, 0.5)}, cusps)["mu0"] == (0.0, 0.5)


def test_a_spectrum_is_over_the_models_own_unit_of_time():
    model = ss.load("stick_slip")
    motion = ss.simulate(model.Parameters(), x0=0.1, t_end=20.0, backend="scipy")
    assert figures.draw_spectrum(motion).axes.get_xlabel() == r"frequency $\times\ \sqrt{m/k}$"


@pytest.mark.thorough
def test_a_motion_on_the_command_line_is_drawn_in_the_units_of_the_file(tmp_path, monkeypatch, run):
    """Of the article's model and of one that turns: a row for each coordinate, with its plane and its spectrum."""
    seen = []
    drawn = figures.motion_figure
    monkeypatch.setattr(figures, "motion_figure", lambda *args: seen.append(drawn(*args)) or seen[-1])
    for name, more in (("kang_nam", ""), ("sprag_rod", "")):
        model = ss.load(name)
        rows = [f'model = "{name}"']
        units = {entry["name"]: entry["unit"] for entry in model.about["units"]}
        units |= {entry["quantity"]: entry["quantity_unit"] for entry in model.about["parameters"]}
        size = {"kg": 0.35, "N/m": 1.5e6, "m": 0.038, "rad": 0.7, "N": 420.0, "1": 0.3, "m/s": 1.2, "s/m": 10.0}
        rows += [f'{key} = "{size.get(unit, 0.01)!r} {unit if unit != "1" else ""}"' for key, unit in units.items()]
        file = tmp_path / f"{name}.toml"
        file.write_text("\n".join(["[brake]", *rows, more]), encoding="utf-8")
        run("simulate", "--data", str(file), "--t-end", "60", "--plot", str(tmp_path / f"{name}.svg"))
    article, rod = seen
    assert [ax.get_ylabel() for ax in article.axes[:2]] == ["$x$ (mm)", r"$\dot{x}$ (mm/s)"]
    assert len(article.axes) == 3 * 2
    assert len(rod.axes) == 3 * len(ss.load("sprag_rod").coordinates)
    assert "(deg)" in rod.axes[0].get_ylabel()


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"vary": "zork"}, "'zork' is not a parameter of kang_nam"),
        ({"vary": "mu0", "low": 1.0, "high": 0.0}, "low = 1, high = 0: mu0 is in"),
        ({"vary": "mu0", "low": -1.0}, "low = -1, high = 1: mu0 is in"),
        ({"vary": "mu0", "low": 0.5, "high": 0.5}, "give a range in it"),
        ({"quantity": "zork"}, "quantity = 'zork' is not one of theta, L, x, y"),
    ],
)
def test_what_can_not_be_drawn_is_named(options, told, ax):
    with pytest.raises(ss.ParameterError, match=told):
        figures.plot_equilibria(ss.Parameters(theta0=0.9), **options, ax=ax)


@pytest.mark.validate
def test_a_marginal_state_keeps_its_type_without_dampers():
    p = ss.load("pad_on_disc").Parameters(theta0=1.53)
    found = figures.branches(p, "kappa", 0.001, 0.017, contact=False, damping=True, n=20)
    assert {one.stability for one in found} <= set(ss.Stability)
    with pytest.raises(ss.ParameterError, match="has not both theta0 and mu0"):
        figures.draw_operating_point(ss.load("stick_slip").Parameters(), (0.5, 0.6), (0.3, 0.6))
