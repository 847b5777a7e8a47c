"""A sweep of a brake's data has its columns in the units of the file."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli import main
from spragsym.files.storage import read
from spragsym.report.example import example
from tests.conftest import Run


def columns(path: Path) -> Any:
    """Numbers by name."""
    held = read(path)[0].items()
    words = ("regime", "equilibrium", "reason")
    return {name: np.asarray(one, dtype=float) for name, one in held if name not in words}


@pytest.mark.thorough
def test_a_sweep_of_a_brake_is_in_the_units_of_its_file(tmp_path: Path, run: Run) -> None:
    """Lengths in mm, times in s, for CSV and netCDF; what it is made from stands beside."""
    data, store = tmp_path / "brake.toml", tmp_path / "rms.csv"
    data.write_text(example(ss.load("kang_nam")), encoding="utf-8")
    call = ["sweep", "--data", str(data), "--theta0", "40:50:2", "--t-end", "0.01", "-q", "-o"]
    run(*call, str(store))
    given, kept = columns(store), columns(tmp_path / "rms.model.csv")
    scales = ss.Study.from_file(data).scales
    assert np.allclose(given["rms_mm"], 1e3 * scales.length * kept["rms"], rtol=1e-11)
    assert np.allclose(given["period_s"], scales.time * kept["period"], rtol=1e-11, equal_nan=True)
    speed = scales.length / scales.time
    assert np.allclose(given["V_m/s"], speed * kept["V"], rtol=1e-11)
    assert np.allclose(given["theta0_deg"], [40, 50])
    assert "# V_m/s [m/s]: belt speed\n" in store.read_text(encoding="utf-8")
    pytest.importorskip("h5netcdf")
    run(*call, str(tmp_path / "rms.nc"))
    import xarray

    with xarray.open_dataset(tmp_path / "rms.nc") as found:
        assert np.allclose(found["rms_mm"], given["rms_mm"], rtol=1e-11)
        assert np.allclose(found["V_m_per_s"], given["V_m/s"], rtol=1e-11)
        assert found["V_m_per_s"].attrs["units"] == "m/s"


def test_what_a_sweep_did_not_write_is_kept(tmp_path: Path) -> None:
    """Before anything is computed."""
    data, store = tmp_path / "brake.toml", tmp_path / "rms.csv"
    data.write_text(example(ss.load("kang_nam")), encoding="utf-8")
    store.write_text("mine", encoding="utf-8")
    call = ["sweep", "--data", str(data), "--theta0", "40:50:2", "-q", "-o", str(store)]
    with pytest.raises(SystemExit) as stop:
        main(call)
    assert stop.value.code != 0
    assert store.read_text(encoding="utf-8") == "mine"


def test_a_sweep_at_one_angle_names_it_on_every_line(tmp_path: Path, run: Run) -> None:
    store = tmp_path / "rms.csv"
    run("sweep", "--theta0", "50", "--mu0", "0.3,0.4", "--t-end", "9", "-q", "-o", str(store))
    given = columns(store)
    assert given["theta0_deg"] == pytest.approx([50, 50])
    assert given["mu0"].tolist() == [0.3, 0.4]


@pytest.mark.thorough
def test_a_map_of_fates_of_a_brake_is_in_the_units_of_its_file(tmp_path: Path, run: Run) -> None:
    """The time to follow is in seconds, and what the columns are made from stands beside."""
    data, store = tmp_path / "brake.toml", tmp_path / "map.csv"
    data.write_text(example(ss.load("stick_slip")), encoding="utf-8")
    call = ["fates", "--data", str(data), "-V", "0.2,0.3", "--t-end", "0.5", "-q", "-o"]
    run(*call, str(store))
    own = tmp_path / "map.model.csv"
    scales = ss.Study.from_file(data).scales
    (t_end,) = re.findall(r"# t_end: (.*)", own.read_text(encoding="utf-8"))
    assert float(t_end) * scales.time == pytest.approx(0.5, rel=1e-12)
    given, kept = (read(path)[0] for path in (store, own))
    assert given["V_m/s"].astype(float) == pytest.approx([0.2, 0.3])
    periods = scales.time * kept["period"].astype(float)
    assert given["period_s"].astype(float) == pytest.approx(periods, rel=1e-12, nan_ok=True)
    assert np.isfinite(periods).any()
