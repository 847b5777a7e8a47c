"""A column that follows from others is one line of the schema of its class."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.display import Column, columns_of_class
from spragsym.results import equilibria
from tests.conftest import Run


@pytest.fixture(autouse=True)
def forgotten() -> Iterator[None]:
    """Names and columns of classes are looked up again, before and after."""
    for each in (columns_of_class, equilibria._names):
        each.cache_clear()
    yield
    for each in (columns_of_class, equilibria._names):
        each.cache_clear()


def test_a_new_column_of_equilibria_is_a_line(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """In tables, data, items, units and JSON of the command."""
    kind = ss.results.Equilibria
    drop = Column("drop", "{x}", "twice {x}", of=lambda eq: 2 * eq["x"], row="behind")
    monkeypatch.setattr(kind, "schema", (*kind.schema, drop))
    eq = ss.equilibria(ss.Parameters.article(theta0=0.8))
    assert eq["drop"][0] == 2 * eq["x"][0]
    assert eq.data()["drop"].tolist() == (2 * eq.data()["x"]).tolist()
    assert (eq.columns["drop"].dimension, eq.columns["drop"].meaning) == ("m", "twice x")
    assert "drop" in str(eq).split("\n")[1]
    told = json.loads(run("equilibria", "--theta0", "40", "--json"))
    assert [row["drop"] for row in told["equilibria"]] == [
        2 * row["x"] for row in told["equilibria"]
    ]


def test_a_new_column_of_sweeps_is_a_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kind = ss.results.Sweep
    crest = Column("crest", "1", "largest over rms", of=lambda found: found.largest / found.rms)
    monkeypatch.setattr(kind, "schema", (*kind.schema, crest))
    p = ss.Parameters.article(theta0=[0.7, 0.8], V=0.5, d=10.0)
    found = ss.rms_sweep(p, t_end=20.0, x0=0.1)
    assert found["crest"].tolist() == (found["largest"] / found["rms"]).tolist()
    found.save(tmp_path / "a.csv")
    assert "crest" in (tmp_path / "a.csv").read_text(encoding="utf-8")


def test_a_new_column_of_branches_is_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = ss.results.CycleBranch
    span = Column("span", "{x}", "range of {x}", of=lambda found: found.highest - found.lowest)
    monkeypatch.setattr(kind, "schema", (*kind.schema, span))

    class Field:
        model = ss.load("kang_nam")

    class Of:
        field = Field

    ones = np.ones(2)
    more: Any = ((Of(),), (), (0.0, 1.0), ())
    branch = kind("mu0", ones, ones, ones, ones, 3 * ones, ones > 0, *more)
    assert branch.data()["span"].tolist() == [2.0, 2.0]
    assert branch.columns["span"].dimension == "m"
