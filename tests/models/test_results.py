"""Every result shows itself: names in completion, values in repr, rows, a frame, a dataset and a picture."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.support import few


def _results() -> dict[str, Any]:
    """By name: what makes one, and what was asked for."""
    rod = ss.load("sprag_rod")
    p = ss.Parameters.article(theta0=0.8)
    return {
        "equilibria": lambda: ss.equilibria(ss.Parameters.article(theta0=[0.5, 0.9])),
        "folds": lambda: ss.folds(ss.Parameters.article()),
        "cusps": lambda: ss.cusps(ss.Parameters.article()),
        "onsets": lambda: ss.flutter_onsets(ss.Parameters.article(alpha=0.7), damping=False),
        "path": lambda: ss.quasi_static_path(p, "mu0", [0.0, 0.2, 0.6]),
        "path of a rod": lambda: ss.quasi_static_path(rod.Parameters(theta0=0.6), "mu0", [0.0, 0.2]),
        "bifurcation set": lambda: ss.bifurcation_set(ss.Parameters.article()),
        "onset curves": lambda: ss.onset_curves(ss.load("mode_coupling").Parameters(), ("mu0", "beta"), n=3),
        "motion": lambda: ss.simulate(p, t_end=5.0),
        "sweep": lambda: ss.rms_sweep(p.replace(mu0=[0.1, 0.2]), t_end=20.0, transient=5.0),
    }


@pytest.fixture(scope="module", params=few(_results(), "equilibria", "folds", "path of a rod", "motion"))
def result(request: pytest.FixtureRequest) -> Any:
    return _results()[request.param]()


def test_a_result_shows_itself(result: Any) -> None:
    columns = result.data()
    assert set(result.offered) <= set(dir(result))
    assert all(np.shape(getattr(result, name)) is not None for name in result.offered)
    assert type(result).__name__ in repr(result)
    first = next((name for name in result.offered if name in columns), None)
    assert first is None or first in repr(result)


def test_a_saved_result_is_read_back(result: Any, tmp_path: Path) -> None:
    result.save(tmp_path / "result.json")
    found = ss.open(tmp_path / "result.json")
    assert type(found) is type(result)
    assert (repr(found), str(found)) == (repr(result), str(result))
    for name, column in result.data().items():
        assert np.array_equal(found.data()[name], column, equal_nan=column.dtype.kind == "f")
    result.save(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == (tmp_path / "result.json").read_bytes()


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("{}", "holds no result"),
        ('{"spragsym":"0.0.1","result":null}', "was written by spragsym 0.0.1"),
        ('{"spragsym":"VERSION","sha256":"DIGEST","result":{"class":["os","system",{}]}}', "is no class of results"),
        ('{"spragsym":"VERSION","sha256":"DIGEST","result":{"class":["spragsym.article.__main__","Path",{}]}}', "is no class"),
        ('{"spragsym":"VERSION","sha256":"DIGEST","result":{"model":["elsewhere",false]}}', "no shipped model"),
        ('{"spragsym":"VERSION","sha256":"DIGEST","result":{"array":["<f8",[2]]}}', "holds no result"),
        ('{"spragsym":"VERSION","sha256":"0","result":null}', "not as it was written"),
    ],
)
def test_a_file_runs_no_code(text: str, what: str, tmp_path: Path) -> None:
    digest = hashlib.sha256(text.partition('"result":')[2][:-1].encode()).hexdigest()
    (tmp_path / "a.json").write_text(text.replace("VERSION", ss.__version__).replace("DIGEST", digest))
    with pytest.raises(ss.ParameterError, match=what):
        ss.open(tmp_path / "a.json")


def test_a_damaged_file_is_refused(tmp_path: Path) -> None:
    ss.folds(ss.Parameters.article()).save(tmp_path / "a.json")
    whole, rng = (tmp_path / "a.json").read_bytes(), np.random.default_rng(3)
    for place in rng.integers(0, len(whole) - 1, 100):  # but for the line's end
        changed = bytearray(whole)
        changed[place] ^= int(rng.integers(1, 128))
        (tmp_path / "a.json").write_bytes(changed)
        with pytest.raises(ss.ParameterError):
            ss.open(tmp_path / "a.json")


def test_rows_are_the_columns(result: Any) -> None:
    columns = result.data()
    if not columns or not hasattr(type(result), "__iter__"):
        pytest.skip("it has no rows, or gives its parts")
    rows = list(result)
    assert len(rows) == len(result)
    for name, column in columns.items():
        assert [row[name] for row in rows] == column.tolist()


def test_frame_and_dataset_hold_the_columns(result: Any) -> None:
    pytest.importorskip("xarray")
    columns = result.data()
    dataset = result.to_xarray()
    assert list(dataset.data_vars) == list(columns)
    for name, column in columns.items():
        assert np.array_equal(dataset[name].values.astype(column.dtype), column, equal_nan=column.dtype.kind == "f")
    pytest.importorskip("pandas")
    assert list(result.to_dataframe().columns) == list(columns)


def test_a_result_is_drawn(result: Any) -> None:
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    ax = Figure().add_subplot()
    result.plot(ax=ax)
    drawn = [line for line in ax.lines if np.size(line.get_xdata())]
    assert drawn or ax.collections
