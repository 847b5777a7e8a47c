"""Curves of onsets without damping, where two modes meet, in closed form; and pictures of a plane
that holds none.
"""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from tests.oracles.user_pages import model_of

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


@pytest.mark.thorough
def test_coordinates_that_are_not_coupled_are_searched_apart() -> None:
    """k w = mu(V) F (1 + w²/L²) has roots below d = 0.8 only, less than floats look at. One of the
    coordinates is damped, by a slope without a zero; the other swings alone.
    """
    text = '''"""A force that no place balances."""
from spragsym.derive.model import Page, cos, sin, sqrt

page = Page("A force that no place balances.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
S = page.parameter("S", "N/m", "stiffness of turning", "> 0", 0.7554)
turned = page.parameter("turned", "rad", "angle of rest", "(-pi, pi)", 0.1572)
k_1 = page.parameter("k_1", "N/m", "stiffness", "> 0", 0.0507)
k_2 = page.parameter("k_2", "N/m", "stiffness of the height", "> 0", 0.3546)
F_L = page.parameter("F_L", "N", "load", "> 0", 0.0734)
F = page.parameter("F", "N", "normal force at 0", "> 0", 0.3735)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.4176)
d = page.parameter("d", "s/m", "steepness of the law", "> 0", 12.7576)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.201)
psi = page.coordinate("psi", "rad", "turning")
w = page.coordinate("w", "m", "displacement")
page.kinetic(m / 3 * (L * page.rate(psi)) ** 2 / 2 + m / 3 * page.rate(w) ** 2 / 2)
page.spring(k_1, along=w)
page.spring(k_2, along=L * (1 - cos(psi)))
page.potential(S * L**2 * (psi - turned) ** 2 / 2)
page.force(0, -F_L, at=(w, L * sin(psi)))
page.normal_force(F * (1 + w**2 / L**2))
page.friction(w, V, lambda v: mu0 * d * v / sqrt(1 + d**2 * v**2))
'''
    p = model_of(text, "unbalanced").Parameters()
    assert ss.equilibria(p).count == 0
    onsets = ss.flutter_onsets(p, "d", between={"d": (0.64, 51.0)})
    assert len(onsets) == 0
    assert onsets.complete
