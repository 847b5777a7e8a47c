"""One or three: every step holds, each part of it is needed, a broken assumption is noticed, and
exact counts agree.
"""

import random
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import pytest
import sympy as sp

from spragsym.derive.kang_nam import catastrophe, elimination, equilibrium, stability, theorem
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.generated import equilibrium as generated
from tests.support import few

#: The derivation as it is, also where a test puts something else in its place.
quartic, coefficients, state, balance = (
    elimination.quartic_in_t,
    elimination.f_coefficients,
    elimination.state,
    equilibrium.balance,
)


@pytest.mark.thorough
def test_every_step_holds() -> None:
    steps = (*theorem.one_or_three(), *theorem.smallest_without_friction())
    assert len(steps) >= 14
    assert len({step.claim for step in steps}) == len(steps)
    assert [step.claim for step in steps if not step.holds] == []


@pytest.fixture(autouse=True, scope="module")
def derived() -> None:
    """Each of these functions keeps what it gave first, which must be what is derived."""
    for function in (quartic, coefficients, state, balance):
        function()


def broken_steps() -> list[str]:
    """What is claimed by steps that do not hold."""
    return [
        step.claim
        for step in (*theorem.one_or_three(), *theorem.smallest_without_friction())
        if not step.holds
    ]


def _coefficient(
    symbol: sp.Symbol, change: Callable[[sp.Expr], sp.Expr]
) -> Callable[[], dict[sp.Symbol, sp.Expr]]:
    return lambda: coefficients() | {symbol: change(coefficients()[symbol])}


def _state(
    symbol: sp.Symbol, change: Callable[[sp.Expr], sp.Expr]
) -> Callable[[], dict[sp.Symbol, sp.Expr]]:
    return lambda: state() | {symbol: change(state()[symbol])}


@pytest.mark.parametrize(
    ("module", "name", "changed", "claim"),
    few(
        [
            pytest.param(
                elimination,
                "quartic_in_t",
                lambda: (-quartic()[0], *quartic()[1:]),
                "begins with −b t⁴",
                id="sign of the constant term",
            ),
            pytest.param(
                elimination,
                "quartic_in_t",
                lambda: (*quartic()[:2], -quartic()[2], *quartic()[3:]),
                "three positive roots need a + d > 0",
                id="sign of the coefficient of t²",
            ),
            pytest.param(
                elimination,
                "f_form",
                elimination.f_form + nm.fm,
                "f = b cos θ ≠ 0 where sin θ = 0",
                id="a term without sine",
            ),
            pytest.param(
                elimination,
                "state",
                _state(nm.L, lambda L: L.subs(nm.sigma, -nm.sigma)),
                "s > 0 gives L > 0",
                id="sign of the spring in L",
            ),
            pytest.param(
                elimination,
                "state",
                _state(nm.y, lambda y: -y),
                "s > 0 ≥ s* gives y < 0",
                id="sign of y",
            ),
            pytest.param(
                equilibrium,
                "balance",
                lambda: (balance()[0] - 2 * nm.alpha * nm.c0, balance()[1]),
                "there F_x = P cos θ + α cos θ₀",
                id="sign of the spring to ground",
            ),
            pytest.param(catastrophe, "slope_identity", lambda: False, "L det K = f′", id="slope"),
            pytest.param(
                elimination,
                "f_form",
                elimination.f_form + 2 * nm.fb * (nm.c - 1),
                "s* ≤ 0: contact is 0 < θ < π, and f is negative before",
                id="sign of f at π",
            ),
            pytest.param(
                elimination,
                "f_coefficients",
                _coefficient(nm.fb, lambda b: 2 * b),
                "s* > 0: contact is θ* < θ < π − θ*, and f is negative before",
                id="f is not q s F_x",
            ),
            pytest.param(
                stability,
                "characteristic",
                lambda K, C: sp.expand((stability.lam**2 * sp.eye(2) - K).det()),
                "det K < 0 is divergence",
                id="sign of the stiffness in (27)",
            ),
            pytest.param(
                equilibrium,
                "balance",
                lambda: (balance()[0], balance()[1] - 2 * nm.kappa),
                "no equilibrium has sin θ = 0",
                id="preload",
            ),
            pytest.param(
                elimination,
                "state",
                lambda: state() | {nm.L: -state()[nm.L]},
                "s > 0 gives L > 0",
                id="sign of L",
            ),
            pytest.param(
                elimination,
                "f_coefficients",
                lambda: coefficients() | {nm.fd: 2 * coefficients()[nm.fd]},
                "at cos θ = 0",
                id="the spring to ground in f",
            ),
            pytest.param(
                elimination,
                "state",
                lambda: state() | {nm.x: nm.c0 - nm.L * nm.c**3},
                "where cos θ < 0",
                id="x where cos θ < 0",
            ),
        ],
        "f is not q s F_x",
    ),
)
def test_a_broken_assumption_is_noticed(
    module: Any, name: str, changed: Any, claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # as it is, whatever else this process has asked for: kept, it is not made of what is broken
    catastrophe.surface()
    monkeypatch.setattr(module, name, changed)
    assert any(claim in broken for broken in broken_steps())


@pytest.mark.thorough
def test_slope_identity_notices_a_wrong_stiffness(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = stability.stiffness().copy()
    wrong[0, 1] = -wrong[0, 1]
    catastrophe.slope_identity.cache_clear()
    monkeypatch.setattr(stability, "stiffness", lambda: wrong)
    try:
        assert not catastrophe.slope_identity()
    finally:
        catastrophe.slope_identity.cache_clear()


def _contact_roots(cos0: Fraction, sin0: Fraction, *parameters: Fraction) -> int:
    """Roots of the quartic in t with y < 0 and L > 0, counted with multiplicity by exact
    isolation.
    """
    mu0, kappa, alpha, sigma, beta = parameters
    coefficients = generated.t_quartic(
        *generated.f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, Fraction(1))
    )
    t = sp.Symbol("t")
    polynomial = sp.Poly(
        [sp.Rational(value.numerator, value.denominator) for value in reversed(coefficients)], t
    )
    # With s = 2t/(1+t²), y < 0 and L > 0 are polynomial inequalities in t.
    push = sp.Poly(kappa * (1 + t**2) - sigma * (sin0 * (1 + t**2) - 2 * t), t)
    length = sp.Poly((2 * sigma * t + ((beta + 1) * sin0 + kappa) * (1 + t**2)) * t, t)
    count = 0
    for (low, high), multiplicity in polynomial.intervals(eps=sp.Rational(1, 10**30)):
        values = [value for side in (push, length) for value in (side.eval(low), side.eval(high))]
        assert all(value != 0 for value in values)
        assert (values[0] > 0) == (values[1] > 0), "a root too close to y = 0 to tell"
        count += multiplicity if values[0] > 0 and values[2] > 0 else 0
    return count


@pytest.mark.thorough
def test_counts_at_random_parameters() -> None:
    """Exact counts, on both sides of κ = σ s₀, with α = 0 and with folds among them."""
    generator = random.Random(8)
    seen = set()
    for trial in range(60):
        half = Fraction(generator.randint(1, 80), 40)  # 0 < θ₀ < π
        cos0, sin0 = (1 - half**2) / (1 + half**2), 2 * half / (1 + half**2)
        sigma = Fraction(generator.randint(1, 40), 20)
        kappa = (
            sigma
            * sin0
            * (Fraction(1) if trial % 10 == 0 else Fraction(generator.randint(1, 300), 200))
        )
        alpha = Fraction(0) if trial % 4 == 1 else Fraction(generator.randint(1, 100), 1000)
        mu0, beta = Fraction(generator.randint(0, 40), 10), Fraction(generator.randint(0, 2), 2)
        count = _contact_roots(cos0, sin0, mu0, kappa, alpha, sigma, beta)
        assert count in (1, 3)
        seen.add(count)
    assert seen == {1, 3}


def test_a_fold_counts_twice() -> None:
    """An exact fold at sin θ = 4/5, with α = 0, so that only the sine of θ₀ counts."""
    sin0, mu0, kappa = Fraction(17, 25), Fraction(1, 2), Fraction(3, 125)
    parameters = (mu0, kappa, Fraction(0), Fraction(1), Fraction(0))
    coefficients = generated.f_coefficients(Fraction(0), sin0, *parameters, Fraction(1))
    assert generated.f(Fraction(3, 5), Fraction(4, 5), *coefficients) == 0
    assert generated.f_slope(Fraction(3, 5), Fraction(4, 5), *coefficients) == 0
    assert generated.f_curvature(Fraction(3, 5), Fraction(4, 5), *coefficients) != 0
    assert _contact_roots(Fraction(0), sin0, *parameters) == 3


# ------------------------------------------------------------------------------------------------
# each part of a step is needed


def _asked(part: Callable[[], Any], monkeypatch: pytest.MonkeyPatch) -> list[sp.Expr]:
    """The polynomials that a part asks to be positive."""
    asked: list[sp.Expr] = []
    monkeypatch.setattr(
        theorem, "manifestly_positive", lambda polynomial: asked.append(polynomial) is None
    )
    part()
    return asked


def test_the_slope_without_friction_is_that_of_the_force(monkeypatch: pytest.MonkeyPatch) -> None:
    """s² c² times the slope of q F_x/cos θ = f/(sin θ cos θ), from the balance of forces and by
    differences in many digits.
    """
    polynomial = _asked(theorem.smallest_without_friction, monkeypatch)[0]
    with mpmath.workdps(40):
        for given in (
            (0.7, 1.1, 0.3, 0.25, 0.01, 0.5),
            (1.4, 0.2, 0.02, 2.0, 3.0, 0.0),
            (0.1, 0.9, 1.7, 0.6, 0.0, 1.5),
        ):
            theta0, theta, kappa, sigma, alpha, beta = map(mpmath.mpf, given)
            s0, c0, q = mpmath.sin(theta0), mpmath.cos(theta0), beta + 1 + sigma

            def force(
                angle: mpmath.mpf,
                parts: tuple[mpmath.mpf, ...] = (s0, c0, q, kappa, sigma, alpha, beta),
            ) -> mpmath.mpf:
                s0, c0, q, kappa, sigma, alpha, beta = parts
                s, c = mpmath.sin(angle), mpmath.cos(angle)
                L = (sigma * s + (beta + 1) * s0 + kappa) / (q * s)
                return q * (sigma * (1 - L) * c + alpha * (c0 - L * c)) / c

            c, s = mpmath.cos(theta), mpmath.sin(theta)
            here = {
                "kappa": kappa,
                "sigma": sigma,
                "s_0": s0,
                "alpha": alpha,
                "beta": beta,
                "c": c,
                "s": s,
                "c_0": c0,
            }
            symbols = sorted(polynomial.free_symbols, key=str)
            value = sp.lambdify(symbols, polynomial, "mpmath")(
                *(here[symbol.name] for symbol in symbols)
            )
            assert abs(value - (c * s) ** 2 * mpmath.diff(force, theta)) < 1e-20
