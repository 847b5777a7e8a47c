"""Linearization with gyroscopic terms, against the quadratic pencil written by hand."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.results import EquilibriumType
from tests.oracles.turning_frames import gyrostat, rotor


def of_rotor(p: dict[str, Any]) -> list[np.ndarray]:
    """M, C, G and K of sets of the rotor, where it rests."""
    one = np.ones_like(p["W"])
    zero, c = 0 * one, p["c_i"] + p["c_e"]
    across = p["f"] - p["c_e"] * p["W"]
    return [
        np.moveaxis(np.array(rows), -1, 0)
        for rows in (
            [[one, zero], [zero, one]],
            [[c, zero], [zero, c]],
            [[zero, -2 * p["W"]], [2 * p["W"], zero]],
            [[p["k_x"] - p["W"] ** 2, across], [-across, p["k_y"] - p["W"] ** 2]],
        )
    ]


def of_gyrostat(p: dict[str, Any]) -> list[np.ndarray]:
    """M, C, G and K of sets of the three masses."""
    one = np.ones_like(p["f"])
    zero, f, h = 0 * one, p["f"], p["h"]
    g = [p[f"g_{i}"] for i in (1, 2, 3)]
    k, c = ([p[f"{name}_{i}"] for i in (1, 2, 3)] for name in "kc")
    M = [[one, one / 2, zero], [one / 2, 2 * one, zero], [zero, zero, one]]
    # a = (g_2 z, g_3 x − g_1 z/2, g_1 y/2), and G_ij = ∂a_i/∂q_j − ∂a_j/∂q_i.
    G = [[zero, -g[2], g[1]], [g[2], zero, -g[0]], [-g[1], g[0], zero]]
    C = [[c[0], zero, zero], [zero, c[1], zero], [zero, zero, c[2]]]
    K = [[k[0] - h, f, zero], [-f, k[1] - h, zero], [zero, zero, k[2]]]
    return [np.moveaxis(np.array(rows), -1, 0) for rows in (M, C, G, K)]


def polyeig(M: np.ndarray, B: np.ndarray, K: np.ndarray) -> np.ndarray:
    """λ of λ² M + λ B + K, by the generalized eigenvalues of its first companion form."""
    from scipy.linalg import eigvals

    n = len(M)
    zero, unit = np.zeros((n, n)), np.eye(n)
    return eigvals(np.block([[zero, unit], [-K, -B]]), np.block([[unit, zero], [zero, M]]))


def off(one: np.ndarray, other: np.ndarray) -> float:
    """Distance of two sets of eigenvalues, over their size."""
    from scipy.optimize import linear_sum_assignment

    apart = np.abs(one[:, None] - other)
    return float(apart[linear_sum_assignment(apart)].max() / np.abs(other).max())


def drawn(model: Any, number: int, seed: int, still: str = "") -> dict[str, np.ndarray]:
    """Random sets, in which quantities whose names begin with a letter of ``still`` are 0."""
    rng, spread = np.random.default_rng(seed), dict[str, np.ndarray]()
    for entry in model.about["parameters"]:
        values = rng.uniform(0.1, 3.0, number)
        if entry["low"] is None:
            values *= rng.choice([-1.0, 1.0], number)
        spread[entry["name"]] = 0 * values if entry["name"][0] in still else values
    return spread


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
    sets = drawn(model, 125, 7, still + "g" * (kind == "rotor"))
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
