"""The compiled solver gives what NumPy gives."""

import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest

import spragsym as ss
from spragsym.kang_nam.quartic import adaptive_precision, block, compiled, solver
from tests.oracles.families import EXTREMES, FAMILIES

pytestmark = pytest.mark.skipif(
    not compiled.available(), reason="the compiled solver was not built: no C compiler"
)


@pytest.fixture(autouse=True)
def _restore() -> Iterator[None]:
    yield
    ss.kang_nam.set_backend("auto")


@pytest.mark.parametrize("contact", [True, False])
def test_same_counts_and_digits(contact: bool) -> None:
    for number, (name, family) in enumerate(FAMILIES.items()):
        p = family(np.random.default_rng([21, number]), 300)
        ss.kang_nam.set_backend("numpy")
        one = ss.equilibria(p, contact=contact)
        ss.kang_nam.set_backend("compiled")
        other = ss.equilibria(p, contact=contact)
        assert (one.count == other.count).all(), name
        assert (one.undamped == other.undamped).all(), name
        assert abs(one.escalated.mean() - other.escalated.mean()) < 0.02, (
            name
        )  # the ladder must not hide a mistake
        for part in ("theta", "L", "x", "y"):
            a, b = getattr(one, part), getattr(other, part)
            gap = np.abs(a - b) / np.maximum(1, np.abs(a))
            assert (np.isnan(a) == np.isnan(b)).all()
            assert (np.nan_to_num(gap) <= np.nan_to_num(one.error + other.error)).all(), name


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
def test_where_digits_run_out(backend: str) -> None:
    """Points found by search, each alone against intervals."""
    ss.kang_nam.set_backend(backend)
    eq = ss.equilibria(ss.Parameters(*np.array(EXTREMES).T))
    for i, point in enumerate(EXTREMES):
        truth = adaptive_precision.equilibria(*point, digits=30).states
        assert eq.count[i] == len(truth)
        for place, exact in enumerate(truth):
            for name in ("theta", "L", "x", "y"):
                gap = abs(getattr(eq, name)[i, place] - getattr(exact, name)) / max(
                    1, abs(getattr(exact, name))
                )
                assert gap <= eq.error[i, place] <= 1e-12


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
def test_underflow_is_left_to_the_ladder(backend: str) -> None:
    """No count of roundings covers what a subnormal parameter loses, but for a preload, whose y is
    0 within its bound.
    """
    ss.kang_nam.set_backend(backend)
    article = ss.Parameters.article(theta0=1.0)
    for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta"):
        assert ss.equilibria(article.replace(**{name: 1e-251})).escalated == (name != "kappa")
    assert not ss.equilibria(article.replace(mu0=0.0, alpha=0.0, beta=0.0)).escalated


def test_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "available", lambda: False)
    assert (solver.chosen(), solver._choice.threads) == (block, 1)
    with pytest.raises(ss.errors.BackendError, match="install spragsym again, with a compiler"):
        ss.kang_nam.set_backend("compiled")


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
def test_count_is_that_of_equilibria(backend: str) -> None:
    ss.kang_nam.set_backend(backend)
    for number, (name, family) in enumerate(FAMILIES.items()):
        p = family(np.random.default_rng([25, number]), 300)
        assert (ss.count(p) == ss.equilibria(p).count).all(), name
    shaped = ss.Parameters.article(theta0=np.radians([[30.0], [49.0]]), mu0=[0.5, 0.0, 0.7])
    assert ss.count(shaped).tolist() == ss.equilibria(shaped).count.tolist()


def test_import_loads_nothing_heavy() -> None:
    code = (
        "import sys, spragsym, spragsym.generated.equilibrium\n"
        "heavy = {'scipy', 'mpmath', 'matplotlib', 'numba', 'sympy', 'flint', 'xarray', "
        "'dask', 'heyoka'}"
        " & set(sys.modules); assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
