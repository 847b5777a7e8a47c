"""What is called stable: only where nothing grows, dampers and the slope of the friction law
included; (27) stands beside it.
"""

import json

import mpmath
import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.article.ledger import PARADOX
from spragsym.cli import cli
from spragsym.results.equilibria import EquilibriumType
from spragsym.statics.stability import Linearized
from tests.bifurcation.test_maps_of_onsets import ZIEGLER
from tests.oracles.user_pages import model_of, shipped_page


def eigenvalues(model: object, eq: ss.results.Equilibria, slot: int, p: object) -> list[complex]:
    """λ with 40 digits, from the matrices of floats."""
    from spragsym.statics.balance import Balance
    from spragsym.statics.stability import linearization

    given = np.array([[float(value)] for value in p.scalars(*model.parameters)])
    q = np.array([[eq.coordinates[name][slot]] for name in model.coordinates])
    M, C, K = (
        mpmath.matrix(part[0].tolist())
        for part in linearization(Balance(model, eq.contact), q, given)
    )
    n = M.rows
    with mpmath.workdps(40):
        A = mpmath.zeros(2 * n)
        A[:n, n:] = mpmath.eye(n)
        A[n:, :n], A[n:, n:] = -(M**-1) * K, -(M**-1) * C
        return mpmath.eig(A, left=False, right=False)


MODELS = ["kang_nam", "damped", "stribeck", "trolley", "two_springs", "mode_coupling", "stick_slip"]


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("kang_nam", "closed"),
        *((name, "search") for name in MODELS),
    ],
)
def test_the_sign_of_the_growth_is_right(name: str, method: str) -> None:
    model, rng = ss.load(name), np.random.default_rng(5)
    seen = set()
    for _ in range(8):
        values = {
            key: float(base * 10 ** rng.uniform(-0.7, 0.7)) for key, base in model.base.items()
        }
        values |= {
            key: float(rng.uniform(0.1, 3.0)) for key in model.parameters if key.startswith("theta")
        }
        p = model.Parameters(**values)
        for contact in (True, False) if model.about["contacts"][0]["unilateral"] else (True,):
            eq = ss.equilibria(p, contact=contact, method=method)
            for slot in range(int(eq.count)):
                most = float(max(value.real for value in eigenvalues(model, eq, slot, p)))
                sign, word = int(eq.growth_sign[slot]), str(eq.stability[slot])
                seen.add(sign)
                assert abs(eq.growth[slot] - most) < 1e-9
                assert not sign or sign * most > -1e-12
                assert {"stable": -1, "unstable": 1}.get(word, sign) in (sign, 0)
    assert -1 in seen


def test_zieglers_paradox() -> None:
    """The article's states at 30°, by the command that docs/reproduction.md names beside each
    number.
    """
    for mu0, state, word, growth in PARADOX:
        told = CliRunner().invoke(
            cli, ["equilibria", "--theta0", "30", "--mu0", str(mu0), "--json"]
        )
        rows = [row for row in json.loads(told.stdout)["equilibria"] if row["state"] == "contact"]
        row = rows[0] if state == "before the jump" else rows[-1]
        assert (row["undamped"], row["stability"]) == (word, "neutral")
        assert f"{row['growth']:+.1e}" == f"{growth:+.1e}"


#: Ziegler's column: det(K − κ M) = 2 κ² + (2 P − 7) κ + 1.
COLUMN = "\n".join(line for line in ZIEGLER.splitlines() if "damper" not in line) + "\n"


@pytest.mark.thorough
def test_without_any_damper_flutter_grows() -> None:
    pytest.importorskip("sympy")
    model = model_of(COLUMN, "ziegler")
    load = np.array([1.0, 2.08, 2.09, 3.0, 4.0, 4.9, 5.0])
    eq = ss.equilibria(model.Parameters(P=load))
    squares = np.array([np.roots([2, 2 * value - 7, 1]) for value in load])
    by_hand = np.abs(np.emath.sqrt(-squares).real).max(axis=1)
    assert eq.growth[:, 0] == pytest.approx(by_hand, abs=1e-9)
    assert eq.stability[:, 0].tolist() == ["neutral"] * 2 + ["unstable"] * 5
    assert eq.growth_sign[:, 0].tolist() == [-1] * 2 + [1] * 5


def test_the_sign_is_proved_where_floats_see_nothing() -> None:
    """A slope of the friction law of 1e-40 decides what floats call 0."""
    for method in ("closed", "search"):
        eq = ss.equilibria(ss.Parameters(theta0=np.radians(30.0), V=9.0), method=method)
        assert (
            eq.undamped[:3]
            == [EquilibriumType.STABLE, EquilibriumType.DIVERGENT, EquilibriumType.STABLE]
        ).all()
        assert eq.growth_sign.tolist() == [-1, 1, 1]
        assert eq.stability.tolist() == ["neutral", "unstable", "neutral"]


def test_what_the_article_calls_stable_after_the_jump_grows() -> None:
    """At 30°, V = 0.5 and d = 10 by 4.9e-6: (27) leaves out that friction falls."""
    eq = ss.equilibria(ss.Parameters.article(theta0=np.radians(30.0)))
    assert int(eq.undamped[2]) == EquilibriumType.STABLE
    assert (eq.growth_sign[2], f"{eq.growth[2]:+.1e}") == (1, "+4.9e-06")
    most = max(value.real for value in eigenvalues(eq.parameters.model, eq, 2, eq.parameters))
    assert abs(eq.growth[2] - float(most)) < 1e-14


@pytest.mark.parametrize("mu0", [0.41, 0.6])
def test_growth_is_proved_though_the_slope_of_the_law_is_not_told_from_0(mu0: float) -> None:
    # K as of the page's docstring, with the law μ0 tanh(d v), whose slope at v = 1 is 1e-85 for d =
    # 100; threshold μ = 0.34.
    law = ("mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0", "mu0 * tanh(d * v)")
    page = shipped_page("mode_coupling", law, ("Abs, Page, exp, sgn", "Page, tanh"))
    eq = ss.equilibria(model_of(page, "mode_coupling_tanh").Parameters(mu0=[mu0], V=1.0, d=100.0))
    K = np.array([[1.3 + 0.25, mu0 - 0.25], [-0.25, 1.25]])
    assert eq.growth[0, 0] == pytest.approx(
        np.sqrt(-np.linalg.eigvals(K).astype(complex)).real.max(), rel=1e-9
    )
    assert (eq.growth_sign[0, 0], eq.stability[0, 0]) == (1, "unstable")


def test_what_no_float_holds_neither_grows_nor_decays() -> None:
    rates = np.array([np.nan, -1.0, 1.0, 1e-5])
    every = (rates + 1j)[:, None]
    assert Linearized(rates, np.zeros(4, dtype=np.int8), every).stability.tolist() == [
        "",
        "stable",
        "unstable",
        "neutral",
    ]
