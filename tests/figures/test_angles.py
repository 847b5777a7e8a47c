"""Axes show what tables and results hold: angles in degrees, each once."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss

figures = pytest.importorskip("spragsym.figures")

from spragsym.figures.report_pages import draw_rising  # noqa: E402  # after matplotlib was found


@pytest.fixture
def ax() -> Any:
    from matplotlib.figure import Figure

    return Figure().add_subplot()


def drawn(lines: Any) -> tuple[np.ndarray, np.ndarray]:
    """All points of some lines of more than one point each."""
    data = [line.get_data() for line in lines if hasattr(line, "get_data")]
    return tuple(
        np.concatenate([np.asarray(pair[axis], dtype=float) for pair in data]) for axis in (0, 1)
    )  # type: ignore[return-value]


def test_a_path_and_the_states_of_a_turning_rod_share_an_axis(ax: Any) -> None:
    rod = ss.load("sprag_rod")
    p, friction = rod.Parameters(theta0=0.6), np.linspace(0.0, 0.4, 5)
    path = ss.quasi_static_path(p, "mu0", friction)
    _, phi = drawn(figures.draw_path(path, "phi", ax=ax, arrows=()))
    assert [np.abs(phi - degrees).min() < 1e-6 for degrees in np.degrees(path.phi)] == [True] * 5
    _, states = drawn(
        figures.plot_equilibria(p, "mu0", "phi", between={"mu0": (0.01, 0.4)}, ax=ax, n=20)
    )
    assert np.abs(states - np.degrees(path.phi[1])).min() < 0.1  # between two of its points


@pytest.mark.thorough
@pytest.mark.parametrize("vary", ["mu0", "theta0"])
def test_what_rises_is_drawn_in_the_units_of_its_axis(ax: Any, vary: str) -> None:
    p = ss.load("sprag_rod").Parameters(theta0=0.6)
    ends = (0.3, 0.4) if vary == "mu0" else (0.5, 0.6)
    artists, hatched = draw_rising(ax, p, vary, ends, 0.3, ((vary, 1.0), ("phi", 1.0)))
    assert not hatched
    along, phi = drawn(artists)
    top = ax.get_xlim()[1] if vary == "mu0" else np.radians(ax.get_xlim()[1])
    path = ss.quasi_static_path(p, vary, np.linspace(0.3, top, 21))
    assert [np.abs(phi - degrees).min() < 1e-6 for degrees in np.degrees(path.phi)] == [True] * 21
    assert along.max() == pytest.approx(ax.get_xlim()[1])
