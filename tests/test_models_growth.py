"""What is called stable: only where nothing grows, dampers and the slope of the friction law included; (27) stands beside it."""

from __future__ import annotations

import json

import mpmath
import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.claims.report import PARADOX
from spragsym.cli import cli
from spragsym.statics import Stability


def eigenvalues(model: object, eq: ss.models.ModelEquilibria, slot: int, p: object) -> list[complex]:
    """λ with 40 digits, from the matrices of floats."""
    from spragsym.models.balance import Balance
    from spragsym.models.stability import linearization

    given = np.array([[float(value)] for value in p.scalars(*model.parameters)])
    q = np.array([[eq.coordinates[name][slot]] for name in model.coordinates])
    M, C, K = (mpmath.matrix(part[:, :, 0].tolist()) for part in linearization(Balance(model, eq.contact), q, given))
    n = M.rows
    with mpmath.workdps(40):
        A = mpmath.zeros(2 * n)
        A[:n, n:] = mpmath.eye(n)
        A[n:, :n], A[n:, n:] = -(M**-1) * K, -(M**-1) * C
        return mpmath.eig(A, left=False, right=False)


@pytest.mark.parametrize("name", ["kang_nam", "damped", "stribeck", "trolley", "two_springs", "mode_coupling", "stick_slip"])
def test_stable_is_only_what_does_not_grow(name: str) -> None:
    model, rng = ss.load(name).search, np.random.default_rng(5)
    seen = set()
    for _ in range(8):
        values = {key: float(base * 10 ** rng.uniform(-0.7, 0.7)) for key, base in model.base.items()}
        values |= {key: float(rng.uniform(0.1, 3.0)) for key in model.parameters if key.startswith("theta")}
        p = model.Parameters(**values)
        for contact in (True, False) if model.about["contact"]["unilateral"] else (True,):
            eq = model.equilibria(p, contact=contact)
            for slot in range(int(eq.count)):
                most = float(max(value.real for value in eigenvalues(model, eq, slot, p)))
                kind = str(eq.kind[slot])
                seen.add(kind)
                assert abs(eq.growth[slot] - most) < 1e-9
                if kind == "stable":
                    assert most < 1e-12
                    assert eq.stable[slot]
                elif kind != "marginal":
                    assert most > -1e-12
                    assert not eq.stable[slot]
    assert "stable" in seen


def test_zieglers_paradox() -> None:
    """The article's states at 30°, by the command that docs/reproduction.md names beside each number."""
    for mu0, state, word, growth in PARADOX:
        told = CliRunner().invoke(cli, ["equilibria", "--model", "kang_nam", "--theta0", "30", "--mu0", str(mu0), "--json"])
        rows = [row for row in json.loads(told.output)["equilibria"] if row["state"] == "contact"]
        row = rows[0] if state == "before the jump" else rows[-1]
        assert row["undamped"] == word
        assert f"{row['growth']:+.1e}" == f"{growth:+.1e}"
        assert row["stability"] == ("stable" if growth < 0 else "flutter")


def test_the_sign_is_proved_where_floats_see_nothing() -> None:
    """A slope of the friction law of 1e-40 decides what floats call 0."""
    model = ss.load("kang_nam").search
    eq = model.equilibria(model.Parameters(theta0=np.radians(30.0), V=9.0))
    assert (eq.stability[:3] == [Stability.STABLE, Stability.DIVERGENT, Stability.STABLE]).all()
    assert eq.kind.tolist() == ["stable", "divergent", "flutter"]
    assert eq.stable.tolist() == [True, False, False]


def test_without_damping_it_is_27() -> None:
    model = ss.load("kang_nam").search
    p = model.Parameters(theta0=np.radians(30.0), mu0=0.0)
    eq = model.equilibria(p)
    assert (eq.stable == (eq.stability == Stability.STABLE)).all()


def test_a_path_says_what_grows() -> None:
    """Where the law of friction falls the state of `stribeck` grows, though (27) calls it stable."""
    model = ss.load("stribeck")
    path = model.quasi_static_path(model.Parameters(theta0=1.0), "V", [0.3, 0.6])
    eq = model.equilibria(model.Parameters(theta0=1.0, V=path.values))
    for row in range(2):
        slot = int(np.abs(eq.x[row] - path.x[row]).argmin())
        assert path.kind[row] == eq.kind[row, slot]
    assert (path.stability == ss.Stability.STABLE).all()
    assert "flutter" in path.kind
