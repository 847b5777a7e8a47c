"""Linearization with gyroscopic terms, against the quadratic pencil written by hand."""

import numpy as np
import pytest

import spragsym as ss
from spragsym.results import EquilibriumType
from tests.oracles.turning_frames import drawn, gyrostat, of_gyrostat, of_rotor, polyeig, rotor


def off(one: np.ndarray, other: np.ndarray) -> float:
    """Distance of two sets of eigenvalues, over their size."""
    from scipy.optimize import linear_sum_assignment

    apart = np.abs(one[:, None] - other)
    return float(apart[linear_sum_assignment(apart)].max() / np.abs(other).max())


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("kind", "still", "kinds"),
    [
        ("rotor", "", {3}),
        ("rotor", "cf", {1, 2}),
        ("gyrostat", "", {2, 3}),
        ("gyrostat", "cf", {1, 2, 3}),
    ],
)
def test_eigenvalues_and_verdicts_are_those_of_the_quadratic_pencil(
    kind: str, still: str, kinds: set[int]
) -> None:
    model, matrices = {
        "rotor": (rotor(), of_rotor),
        "gyrostat": (gyrostat(), of_gyrostat),
    }[kind]
    sets = drawn(model, 125, np.random.default_rng(7), still + "g" * (kind == "rotor"))
    eq = ss.equilibria(model.Parameters(**sets), within=dict.fromkeys(model.coordinates, (-1, 1)))
    assert (eq.count == 1).all()
    assert not eq.marginal.any()
    seen = set()
    for row, (M, C, G, K) in enumerate(zip(*matrices(sets), strict=True)):
        damped, undamped = polyeig(M, C + G, K), polyeig(M, G, K)
        assert off(eq.damped_eigenvalues[row, 0], damped) < 1e-7  # some are nearly double
        assert off(eq.eigenvalues[row, 0], undamped) < 1e-7
        size = np.abs(undamped).max()
        grow = undamped[undamped.real > 1e-6 * size]
        kind_of = EquilibriumType.STABLE
        if grow.size:
            single = (np.abs(grow.imag) < 1e-7 * size).all()
            kind_of = EquilibriumType.DIVERGENT if single else EquilibriumType.FLUTTER
        assert eq.undamped[row, 0] == kind_of
        seen.add(int(kind_of))
        if np.abs(damped.real.max()) > 1e-3 * size:
            assert eq.growth_sign[row, 0] == np.sign(damped.real.max())
    assert seen == kinds


def test_many_digits_tell_the_type_where_all_roots_come_in_pairs() -> None:
    """Without friction K is symmetric: positive definite here, so that nothing grows."""
    p = ss.load("wobbling_disc").Parameters(mu0=0.0)
    (state,) = ss.precise.equilibria(p, dps=20).states
    assert state.undamped == EquilibriumType.STABLE


def test_three_coordinates_may_be_stable_beside_a_force_without_a_potential() -> None:
    """Without g_3 the gyroscopic terms couple z with x and y, and the force f couples x with y: the
    odd coefficients of the pencil are 0, and flutter sets in where two frequencies meet.
    """
    model = gyrostat()
    sets = {"g_1": 0.7, "g_2": -0.4, "g_3": 0.0}
    p, within = model.Parameters(**sets), dict.fromkeys(model.coordinates, (-1, 1))

    def growth(f: float, **more: float) -> float:
        values = {**model.base, **sets, **more, "f": f}
        ((M,), _, (G,), (K,)) = of_gyrostat({name: np.array([v]) for name, v in values.items()})
        return float(polyeig(M, G, K).real.max())

    (onset,) = ss.flutter_onsets(p, "f", damping=False, within=within, between={"f": (0, 2)}).f
    assert growth(onset - 1e-3) < 1e-7 < 1e-2 < growth(onset + 1e-3)
    eq = ss.equilibria(p.replace(f=onset + np.array([-1e-3, 1e-3])), within=within)
    assert not eq.marginal.any()
    assert eq.undamped[:, 0].tolist() == [EquilibriumType.STABLE, EquilibriumType.FLUTTER]
    # With g_3 all pairs leave the axis together where f passes 0, and some λ grows elsewhere.
    p = p.replace(g_3=0.3)
    found = ss.flutter_onsets(p, "f", damping=False, within=within, between={"f": (-1, 2)})
    assert found.f.tolist() == [0.0] * 3
    assert {*found.kind} == {"flutter"}
    assert found.omega == pytest.approx(
        sorted(ss.equilibria(p.replace(f=0.0), within=within).eigenvalues[0].imag)[3:]
    )
    assert "some λ grows in every state that is not listed" in found.remarks[0]
    assert min(growth(f, g_3=0.3) for f in (-1e-2, 1e-2, 1.0)) > 1e-6


@pytest.mark.parametrize("vary", ["mu0", "Omega"])
def test_growth_in_every_state_is_decided_at_the_value(vary: str) -> None:
    """The disc with gyroscopic moments is stable without friction, and flutters with any."""
    p = ss.load("wobbling_disc").Parameters()
    without, little = (
        ss.flutter_onsets(
            p.replace(mu0=None if vary == "mu0" else mu0),
            vary,
            damping=False,
            between={vary: (mu0, 1.0)},
        )
        for mu0 in (0.0, 1e-9)
    )
    assert [ss.equilibria(p.replace(mu0=mu0)).undamped[0] for mu0 in (0.0, 1e-9)] == [
        EquilibriumType.STABLE,
        EquilibriumType.FLUTTER,
    ]
    grows = "some λ grows in every state"
    assert any(grows in one for one in little.remarks)
    told = [one for one in without.remarks if grows in one]
    if vary == "mu0":
        assert "not at mu0 = 0" in told[0]
    else:
        assert not told
