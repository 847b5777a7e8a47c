"""The lowest fold: against paths of states, the balance of forces in 50 digits, and on the borders
of the parameters.
"""

import math

import numpy as np
import pytest

import spragsym as ss
from spragsym.derive.kang_nam import lowest_fold as derived
from spragsym.kang_nam.kernel import Fixed
from tests.oracles import lowest_fold
from tests.oracles.families import random_fixed

BASE = ss.Parameters.article(theta0=None, mu0=None)
#: Found by a scan of random sets: the cusp lies 3.7 % above the lowest fold.
BELOW_THE_CUSP = ss.Parameters(
    kappa=1.0358981051019952e-4, alpha=0.24472716045424348, sigma=5.3945973456418015, beta=0.0
)


@pytest.mark.thorough
def test_every_step_of_the_proof_holds() -> None:
    steps = derived.steps()
    assert len({step.claim for step in steps}) == len(steps) >= 13
    assert [step.claim for step in steps if not step.holds] == []
    assert all(derived.identities().values())


def test_at_the_articles_values_it_is_the_cusp() -> None:
    found, cusps = ss.critical_friction(BASE), ss.cusps(BASE)
    inside = int(np.flatnonzero((cusps.theta0 > 0) & (cusps.mu0 > 0))[0])
    assert found.kind == "cusp"
    assert (found.mu0, found.theta0) == (cusps.mu0[inside], cusps.theta0[inside])
    assert found == ss.cusp_friction(BASE)


def test_it_may_lie_below_the_cusp() -> None:
    found = ss.critical_friction(BELOW_THE_CUSP)
    assert found.kind == "turn"
    assert ss.cusp_friction(BELOW_THE_CUSP) / found == pytest.approx(1.03745, abs=1e-5)
    # The state jumps below the cusp: what was said of the friction of the cusp is false.
    between = 0.5 * (float(found) + float(ss.cusp_friction(BELOW_THE_CUSP)))
    angles = np.linspace(0.8, float(found.theta0), 3)
    assert ss.quasi_static_path(BELOW_THE_CUSP.replace(mu0=between), "theta0", angles).jumps
    assert float(ss.jump_value(BELOW_THE_CUSP.replace(theta0=found.theta0))) == pytest.approx(
        float(found), rel=1e-12
    )


@pytest.mark.thorough
def test_nothing_jumps_below_it_and_something_at_it() -> None:
    rng = np.random.default_rng(26)
    kinds = set()
    for _ in range(12):
        kind, outcome = lowest_fold.verdict(random_fixed(rng))
        kinds.add(kind)
        assert outcome == "right"
    assert {"cusp", "turn"} <= kinds


@pytest.mark.thorough
def test_fifty_digits_by_another_way() -> None:
    """In x and y, (14) and (15): both forces, the determinant, and for a turn the change with θ₀
    along the left null vector.
    """
    rng = np.random.default_rng(28)
    kinds = []
    while len(kinds) < 4 or len(set(kinds)) < 2:
        p = random_fixed(rng)
        found = ss.critical_friction(p)
        if found.kind:
            for right, told in zip(
                lowest_fold.in_digits(p), (found.theta0, found.mu0), strict=True
            ):
                assert abs(right - told) <= found.error * max(1, abs(right))
            kinds.append(found.kind)


def test_the_state_ends_nowhere_where_the_spring_leans_backward() -> None:
    """θ₀ ≥ π/2: no friction makes the reference state jump, and cusps there are not counted."""
    rng = np.random.default_rng(29)
    sets = [random_fixed(rng) for _ in range(40)]
    values = {
        name: np.array([float(getattr(p, name)) for p in sets])[:, None] for name in Fixed._fields
    }
    angles = np.append(np.pi / 2, np.linspace(1.58, 3.14, 25))
    assert np.isnan(ss.jump_value(ss.Parameters(theta0=angles, **values))).all()


# ------------------------------------------------------------------------------------------------
# borders


def test_without_a_spring_along_the_belt() -> None:
    """α = 0: the two upright states of a symmetric system meet at μ₀ = 0, and any friction makes
    the state jump beside them.
    """
    p = BASE.replace(alpha=0.0)
    found = ss.critical_friction(p)
    assert (float(found), found.kind) == (0.0, "cusp")
    assert math.sin(found.theta0) == pytest.approx(1 - 0.007, rel=1e-14)
    just = float(ss.jump_value(p.replace(theta0=float(found.theta0) - 1e-6)))
    assert 0 < just < 1e-6
    heavy = ss.critical_friction(p.replace(kappa=2.0))  # κ > 1 + β: one state, whatever the angle
    assert (float(heavy), heavy.kind) == (math.inf, "")
    assert np.isnan(ss.jump_value(p.replace(kappa=2.0, theta0=np.linspace(0.01, 3.13, 50)))).all()


@pytest.mark.by_hand("changes0")
@pytest.mark.thorough
@pytest.mark.parametrize(
    "changes",
    [
        {"kappa": 1e-12},
        {"kappa": 1e-9, "sigma": 3.0, "alpha": 0.2},
        {"beta": 1e4},
        {"alpha": 1.0},
        {"alpha": 3.0, "beta": 2.0},
        {"alpha": 50.0, "sigma": 7.0},
        {"kappa": 0.1, "sigma": 0.1},
        {"kappa": 1.0, "sigma": 2.0},
    ],
)
def test_borders_against_a_scan(changes: dict[str, float]) -> None:
    assert lowest_fold.verdict(BASE.replace(**changes))[1] == "right"


def test_no_fold_at_all() -> None:
    p = ss.Parameters(kappa=0.5499, alpha=0.8771, sigma=0.022509, beta=4.455)
    found = ss.critical_friction(p)
    assert (float(found), found.kind) == (math.inf, "")
    assert math.isnan(found.theta0)
    assert math.isinf(ss.cusp_friction(p))


# ------------------------------------------------------------------------------------------------
# the result


def test_a_parameter_that_is_missing_is_named() -> None:
    with pytest.raises(ss.errors.ParameterError, match="kappa"):
        ss.critical_friction(ss.Parameters(kappa=None, alpha=0.1, sigma=0.1, beta=0.0))
