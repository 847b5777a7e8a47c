"""The compiled solver gives what NumPy gives."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest

import spragsym as ss
from benchmarks.families import FAMILIES
from benchmarks.validate_equilibria import worst_errors, wrong_counts
from spragsym import backends

pytest.importorskip("numba")


@pytest.fixture(autouse=True)
def _restore() -> Iterator[None]:
    yield
    ss.set_backend("auto")


@pytest.mark.parametrize("contact", [True, False])
def test_same_counts_and_digits(contact: bool) -> None:
    for number, (name, family) in enumerate(FAMILIES.items()):
        p = family(np.random.default_rng([21, number]), 300)
        ss.set_backend("numpy")
        one = ss.equilibria(p, contact=contact)
        ss.set_backend("numba")
        other = ss.equilibria(p, contact=contact)
        assert (one.count == other.count).all(), name
        assert (one.stability == other.stability).all(), name
        assert abs(one.escalated.mean() - other.escalated.mean()) < 0.02, name  # the ladder must not hide a mistake
        for part in ("theta", "L", "x", "y"):
            a, b = getattr(one, part), getattr(other, part)
            gap = np.abs(a - b) / np.maximum(1, np.abs(a))
            assert (np.isnan(a) == np.isnan(b)).all()
            assert (np.nan_to_num(gap) <= np.nan_to_num(one.error + other.error)).all(), name


def test_same_guarantee() -> None:
    ss.set_backend("numba")
    rng = np.random.default_rng(22)
    p = FAMILIES["random"](rng, 500)
    eq = ss.equilibria(p)
    assert wrong_counts(p, eq) == 0
    worst, ratio = worst_errors(p, eq, rng, 60)
    assert worst <= 1e-12
    assert ratio <= 1


def test_threads_do_not_show() -> None:
    p = FAMILIES["random"](np.random.default_rng(23), 3000)
    results = []
    for threads in (1, 2):
        ss.set_backend("numba", threads=threads)
        results.append(ss.equilibria(p))
    np.testing.assert_array_equal(results[0].theta, results[1].theta)
    np.testing.assert_array_equal(results[0].error, results[1].error)


def test_choice_by_itself() -> None:
    assert ss.get_backend() == "auto"
    assert backends.chosen(10) == ("numpy", 1)
    assert backends.chosen(10**6) == ("numba", 1)
    ss.set_backend("numpy")
    assert backends.chosen(10**6) == ("numpy", 1)


def test_without_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backends, "_has_numba", lambda: False)
    assert backends.chosen(10**6) == ("numpy", 1)
    with pytest.raises(ss.MissingExtraError, match=r"spragsym\[fast\]"):
        ss.set_backend("numba")


@pytest.mark.parametrize("arguments", [("cuda",), ("numba", 0), ("numba", True)])
def test_bad_choice(arguments: tuple[object, ...]) -> None:
    with pytest.raises(ss.ParameterError):
        ss.set_backend(*arguments)  # type: ignore[arg-type]


def test_import_loads_nothing_heavy() -> None:
    code = (
        "import sys, spragsym; heavy = {'scipy', 'mpmath', 'matplotlib', 'numba', 'sympy', 'flint', 'xarray', 'dask', 'heyoka'}"
        " & set(sys.modules); assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
