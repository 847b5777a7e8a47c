"""Columns of results: what they are, in units of data, and over the axes of a grid."""

from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from spragsym.report.example import example
from spragsym.results import Column

P = ss.Parameters.article(theta0=np.radians([[30.0], [49.0]]), mu0=np.array([0.3, 0.5, 0.7]))


def test_a_grid_has_its_axes_and_states_as_dimensions() -> None:
    pytest.importorskip("xarray")
    eq = ss.equilibria(P)
    dataset = eq.to_xarray()
    assert dataset["x"].dims == ("theta0", "mu0", "state")
    assert dataset["count"].dims == ("theta0", "mu0")
    assert np.array_equal(dataset["theta0"], P["theta0"].ravel())
    for name in ("x", "y", "theta", "growth", "error"):
        assert np.array_equal(dataset[name], eq[name], equal_nan=True)
        assert dataset[name].attrs["long_name"] == eq.columns[name].meaning
    assert dataset["x"].attrs["units"] == "L_0"
    assert dataset["theta"].attrs["units"] == "rad"
    assert dataset["undamped"].attrs["flag_meanings"] == "none stable divergent flutter"


@pytest.mark.parametrize("seed", range(3))
def test_columns_in_units_are_the_columns_times_their_scales(seed: int) -> None:
    """By dimensions of the numbers alone: m, k_c and L_0 drawn at random over six decades."""
    m, k_c, L_0 = 10 ** np.random.default_rng(seed).uniform(-3, 3, 3)
    stiff = {"k": 0.1 * k_c, "k_x": 0.007 * k_c, "k_y": 0.0, "k_c": k_c}
    speed = L_0 * np.sqrt(k_c / m)
    law = {"theta0": 0.8, "mu0": 0.4, "V": 0.5 * speed, "d": 10.0 / speed}
    brake = ss.PhysicalParameters(m=m, **stiff, F_L=0.007 * k_c * L_0, L_0=L_0, **law)
    eq = ss.equilibria(brake.dimensionless())
    found, plain = eq.to_units(brake.scales), eq.data()
    assert found["x_m"] == pytest.approx(L_0 * plain["x"], rel=1e-14)
    assert found["theta_deg"] == pytest.approx(np.degrees(plain["theta"]), rel=1e-14)
    assert found["growth_per_s"] == pytest.approx(np.sqrt(k_c / m) * plain["growth"], rel=1e-13)
    assert set(found.columns) == {
        *("stability", "undamped", "theta_deg", "L_m", "x_m", "y_m", "growth_per_s", "error"),
    }
    folds = ss.folds(brake.dimensionless()).to_units(brake.scales)
    assert len(folds) == len(folds["theta0_deg"]) == 2


def test_columns_are_in_the_units_of_a_study(tmp_path: Path) -> None:
    (tmp_path / "brake.toml").write_text(example(ss.load("kang_nam")), encoding="utf-8")
    study = ss.Study.from_file(tmp_path / "brake.toml")
    eq = ss.equilibria(study.dimensionless)
    found = eq.to_units(study)
    unit, size = study.unit_of("m")
    assert found[f"x_{unit}"] == pytest.approx(size * eq.data()["x"])


def test_a_class_declares_a_column_for_all_coordinates() -> None:
    model = ss.load("trolley")
    sweep = ss.rms_sweep(model.Parameters(theta0=0.7), t_end=2.0, transient=1.0)
    assert sweep.columns["mean_x_a"] == Column("mean_x_a", "m", "mean of x_a after the transient")
    assert sweep.columns["cycle_vx_a"].dimension == "m/s"
    assert "mean_x" not in sweep.columns
    assert sweep.columns["regime"].codes is ss.motion.sweeps.Regime
