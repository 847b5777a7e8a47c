"""The page of a report: its map of stability, its spectrum, its mechanism, its print."""

import re
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.load import mechanism
from tests.support import few, written_brake

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from spragsym.figures import planes
from spragsym.figures.report_pages import _around, report_page

#: A pad that squeals, without any tolerance and without a jump.
SQUEALS = {
    "m": "60 g",
    "k": "4 N/um",
    "L_0": "38 mm",
    "theta0": "130 deg",
    "k_x": "18 N/um",
    "k_y": "0 N/um",
    "k_c": "20 N/um",
    "F_L": "400 N",
    "mu0": "0.4",
    "V": "1.2 m/s",
    "d": "10 s/m",
    "damping_ratio": "1 %",
}


def words(page: str) -> str:
    return re.sub(r"\s+", " ", re.sub("<[^>]*>", " ", page))


@pytest.mark.thorough
def test_the_page_of_a_pad_that_squeals(tmp_path: Path) -> None:
    """Its map, shaded where it works; no plane without lines; no table cut in print; its
    mechanism.
    """
    study = ss.Study.from_file(written_brake(tmp_path, SQUEALS))
    page = report_page(study.report(probability=False, redesign=False, oscillation=False))
    said = words(page)
    assert "works where small oscillations grow: it squeals or judders; they grow in a" in said
    assert "Full line: it begins with a small amplitude (supercritical)." in said
    assert ">unstable</text>" in page
    assert "On the lines two states of sliding meet" not in said
    assert page.count("<table>") == len(re.findall(r"<section>\s*<h2>[^<]*</h2>\s*<table>", page))
    assert re.search(r"@media print\{.*section,.*\{break-inside:avoid\}", page, re.S)
    (source,) = re.findall(r'src="data:image/svg\+xml,([^"]*)"', page)
    assert unquote(source) == mechanism(ss.load("damped"))


def test_the_shade_of_the_map_ends_on_its_curves() -> None:
    """Of the same mass it grows where ζ + F'(V) < 0, at every place whose shade is drawn."""
    p = ss.load("stick_slip").Parameters()

    def growth(V: np.ndarray, zeta: np.ndarray) -> np.ndarray:
        return planes.growth_of_oscillations(ss.equilibria(p.replace(V=V, zeta=zeta)))

    V, zeta, found = planes.sampled_by_sign(growth, (0.0, 1.0), (0.0, 2.0))
    slope = 2 * p.mu_s * p.v_s * (p.v_s**2 - V**2) / (V**2 + p.v_s**2) ** 2
    rate = -(zeta[:, None] + slope) / 2
    clear = (np.abs(rate) > 1e-12) & (V > 0)  # a belt at rest has no friction law at its speed
    assert (rate > 0)[clear].any()
    assert ((found > 0) == (rate > 0))[clear].all()


@pytest.mark.parametrize("seed", few(range(8), 2))
def test_a_function_is_computed_where_its_sign_changes(seed: int) -> None:
    """Of ellipses some cells wide the sign is that of the function at all places."""
    rng = np.random.default_rng(seed)
    centre, radii = rng.uniform(0.2, 0.8, 2), rng.uniform(0.1, 0.3, 2)
    units = 10.0 ** rng.uniform(-6, 6, 2)

    def inside(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.sign(
            1
            - ((x / units[0] - centre[0]) / radii[0]) ** 2
            - ((y / units[1] - centre[1]) / radii[1]) ** 2
        )

    x, y, found = planes.sampled_by_sign(inside, (0.0, units[0]), (0.0, units[1]))
    assert ((found > 0) == (inside(x, y[:, None]) > 0)).all()


def test_axes_of_the_map_fit_its_curves_and_the_brake() -> None:
    p = ss.load("stick_slip").Parameters()
    found = ss.onset_curves(p, ("V", "zeta"), 4, between={"V": (0.1, 1.0), "zeta": (0.0, 9.0)})
    values = np.concatenate([curve["zeta"] for curve in found.curves])
    low, high = _around(found, "zeta", (0.4, 0.5))
    assert 0.0 <= low <= values.min() < values.max() < high < 9.0
    assert high - low < 1.5 * np.ptp([*values, 0.4, 0.5])
    assert _around(found, "zeta", (8.9, 9.0))[1] == 9.0  # no further than was searched
