"""Figures of models: what is drawn is what was computed, on the axes that were given."""

from __future__ import annotations

import json

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli import main

plot = pytest.importorskip("matplotlib.figure")

from spragsym import figures  # noqa: E402  needs matplotlib
from spragsym.figures.models import label, window  # noqa: E402  needs matplotlib

BETWEEN = {"mu0": (0.0, 1.0)}


@pytest.fixture(scope="module")
def found():
    model = ss.load("kang_nam").search
    return model.bifurcation_set(model.Parameters(theta0=1.0), n=6, between=BETWEEN)


@pytest.fixture
def ax():
    return plot.Figure().subplots()


def test_the_bifurcation_set_on_given_axes(ax, found):
    lines = figures.draw_bifurcation_set_of(ss.load("kang_nam").search, found, ax)
    assert len(lines) == len(found.curves) + 1
    assert all(line.axes is ax for line in lines)
    for line, curve in zip(lines, found.curves, strict=False):
        assert np.allclose(line.get_xdata(), np.degrees(curve.theta0))
        assert np.allclose(line.get_ydata(), curve.mu0)
    assert np.allclose(lines[-1].get_ydata(), found.cusps.mu0)


def test_equilibria_along_a_parameter(ax):
    model = ss.load("kang_nam").search
    dots = figures.draw_equilibria_of(model, model.Parameters(theta0=1.0, mu0=0.7), "theta0", "y", ax, n=20)
    values = np.pi * (np.arange(20) + 0.5) / 20
    known = ss.equilibria(ss.Parameters.article(mu0=0.7, theta0=values))
    assert sum(line.get_xdata().size for line in dots) == known.count.sum()
    assert np.allclose(np.sort(np.concatenate([line.get_ydata() for line in dots])), np.sort(known.y[~np.isnan(known.y)]))
    assert {line.get_label() for line in dots} == {"stable", "divergent", "flutter"}  # what friction's slope lets grow


def test_onsets_are_the_closed_form_of_mode_coupling(ax):
    model = ss.load("mode_coupling")
    (dots,) = figures.draw_onsets_of(
        model, model.Parameters(), ("sigma", "mu0"), ax, damping=False, between={"sigma": (0.1, 2.0), "mu0": (0.0, 5.0)}, n=5
    )
    sigma, alpha, beta = dots.get_xdata(), model.base["alpha"], model.base["beta"]
    assert sigma.size == 5
    assert np.allclose(dots.get_ydata(), ((1 + beta - alpha) ** 2 + sigma**2) / (2 * sigma), atol=1e-12)


def test_onsets_are_the_closed_form_of_stick_slip(ax):
    model = ss.load("stick_slip")
    (dots,) = figures.draw_onsets_of(
        model, model.Parameters(), ("V", "zeta"), ax, between={"V": (0.15, 1.0), "zeta": (0.0, 5.0)}, n=5
    )
    V, mu_s, v_s = dots.get_xdata(), model.base["mu_s"], model.base["v_s"]
    assert V.size == 5
    assert np.allclose(dots.get_ydata(), 2 * mu_s * v_s * (V**2 - v_s**2) / (V**2 + v_s**2) ** 2, atol=1e-12)


def test_labels_are_those_of_the_dimensionless_numbers():
    assert label(ss.load("mode_coupling"), "sigma") == r"$\sigma$"
    assert label(ss.load("two_springs"), "sigma_2") == r"$\sigma_{\rm 2}$"
    assert label(ss.load("kang_nam").search, "theta0") == r"$\theta_o$ (deg)"


@pytest.mark.thorough
def test_plot_on_the_command_line(tmp_path, monkeypatch, capsys, found):
    monkeypatch.setattr("spragsym.models.Model.bifurcation_set", lambda self, p, vary, n, **options: found)
    file = tmp_path / "set.svg"
    command = ["bifurcation", "--method", "search", "--plot", str(file)]
    assert status(command) == 0
    assert file.read_text(encoding="utf-8").startswith("<?xml")
    assert status(command) != 0
    assert "--force" in capsys.readouterr().err
    assert status([*command[:-1], str(tmp_path / "set.gif")]) != 0


def test_a_range_is_searched_and_drawn(tmp_path, monkeypatch, capsys):
    """Of the two folds of the article's model only the one within the range; the cusp is outside of it."""
    search = ss.load("kang_nam").search.bifurcation_set
    monkeypatch.setattr(
        "spragsym.models.Model.bifurcation_set", lambda self, p, vary, n, **options: search(p, vary, 4, **options)
    )
    command = ["bifurcation", "--vary", "theta0=100:170", "--vary", "mu0=0.3:0.6", "--json"]
    assert status([*command, "--plot", str(tmp_path / "set.svg")]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [row["theta0_deg"] for row in told["folds"]["points"]] == pytest.approx([155.05941879], abs=1e-7)
    assert told["cusps"]["points"] == []
    wrong = {
        "mu0=": "give it as mu0=0:1", "mu0=1": "give it as mu0=0:1", "mu0=1:1": "both ends are 1",
        "mu0=-1:1": "is not in [0, inf)",
        "theta0=0:181": "theta0_deg = 181 is not in (0, 180)", "mu0=0:1:1": "2 to 100000", "sgma=0:1": "did you mean sigma?",
    }  # fmt: skip
    for given, text in wrong.items():
        assert status(["bifurcation", "--vary", given]) == 2
        assert text in capsys.readouterr().err


def status(command):
    """What the command ends with."""
    with pytest.raises(SystemExit) as ended:
        main(command)
    return ended.value.code or 0


def test_the_window_of_a_bifurcation_set_holds_every_cusp_that_was_found() -> None:
    model = ss.load("two_springs")
    cusps = model.cusps(model.Parameters(), ("theta0", "mu0"))
    assert (
        window(model, ("theta0", "mu0"), {})["mu0"][1] < cusps.mu0.max() < window(model, ("theta0", "mu0"), {}, cusps)["mu0"][1]
    )
    assert window(model, ("theta0", "mu0"), {"mu0": (0.0, 0.5)}, cusps)["mu0"] == (0.0, 0.5)
