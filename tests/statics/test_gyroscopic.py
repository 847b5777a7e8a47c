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
