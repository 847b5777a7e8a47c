"""Curves of onsets without damping, where two modes meet, in closed form; and pictures of a plane
that holds none.
"""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli

#: The plane in which the threshold of mode coupling is printed: mu = ((1 + beta - alpha)^2 +
#: sigma^2) / (2 sigma).
PLANE = {"sigma": (0.1, 2.0), "mu0": (0.0, 2.0)}


@pytest.mark.thorough
def test_modes_meet_on_a_curve_in_closed_form() -> None:
    undamped = ss.load("mode_coupling").Parameters(
        d=4000.0
    )  # a law without a slope: exp(-2000) is 0 to floats
    found = ss.onset_curves(undamped, tuple(PLANE), 8, between=PLANE)
    (curve,) = found.curves
    assert curve.mu0 == pytest.approx((0.3**2 + curve.sigma**2) / (2 * curve.sigma), rel=1e-9)
    square = 1.3 + curve.sigma / 2 + (1 - 1.3) / 2  # half of the trace of K
    assert curve.omega == pytest.approx(np.sqrt(square), rel=1e-6)
    assert np.ptp(curve.sigma) > 1.5
    alone = ss.onset_curves(ss.load("stick_slip").Parameters(), ("V", "zeta"), 4, damping=False)
    assert (len(alone), alone.complete) == (0, True)


def test_types_are_told_apart_next_to_an_onset() -> None:
    p = ss.load("mode_coupling").Parameters(sigma=0.5, mu0=0.34 * (1 + np.array([-4e-15, 4e-15])))
    assert ss.equilibria(p).undamped[:, 0].tolist() == [
        ss.EquilibriumType.STABLE,
        ss.EquilibriumType.FLUTTER,
    ]


@pytest.mark.thorough
def test_a_picture_spans_what_was_asked_and_says_that_it_is_empty() -> None:
    pytest.importorskip("matplotlib")
    from spragsym.figures import bifurcation_figure, stability_figure

    p = ss.load("mode_coupling").Parameters()
    onsets = ss.onset_curves(p, tuple(PLANE), 8, damping=False, between=PLANE)
    empty = ss.onset_curves(
        p, tuple(PLANE), 4, damping=False, between={"sigma": (0.1, 0.4), "mu0": (1.0, 2.0)}
    )
    for figure, ranges, said in (
        (stability_figure(onsets), PLANE, []),
        (stability_figure(empty), empty.between, ["no onsets here"]),
        (bifurcation_figure(p, tuple(PLANE), between=PLANE, n=2, onsets=onsets), PLANE, []),
        (
            bifurcation_figure(p, tuple(PLANE), between=PLANE, n=2),
            PLANE,
            ["no folds and cusps here"],
        ),
    ):
        (ax,) = figure.axes
        assert (ax.get_xlim(), ax.get_ylim()) == tuple(ranges.values())
        assert [text.get_text() for text in ax.texts] == said
        assert bool(sum(len(line.get_xdata()) for line in ax.lines)) == (not said)


@pytest.mark.thorough
def test_the_command_draws_the_curve_that_it_is_asked_for(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    target = tmp_path / "a.svg"
    varied = [
        word for name, (low, high) in PLANE.items() for word in ("--vary", f"{name}={low}:{high}")
    ]
    options = [
        "bifurcation",
        "--model",
        "mode_coupling",
        *varied,
        "--undamped",
        "--n",
        "4",
        "--plot",
        str(target),
    ]
    assert CliRunner().invoke(cli, options).exit_code == 0
    assert "stroke: #6b6b6b" in target.read_text(encoding="utf-8")
