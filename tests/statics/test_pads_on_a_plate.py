"""Three modes of a plate between two pads whose loads grow with the modes as exponentials: states
and folds of three coordinates that no bound holds, against SciPy on forces by hand.
"""

import functools

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import fsolve

import spragsym as ss
from spragsym.models.parameters import ParameterSet
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

PAGE = '''r"""Three modes of a plate."""
from spragsym.derive.model import Page, exp, tanh
page = Page("Three modes of a plate that two pads rub.")
m = page.unit("m", "kg", "modal mass")
k_1 = page.unit("k_1", "N/m", "first stiffness")
n_0 = page.unit("n_0", "N", "load of a pad")
mu = page.parameter("mu", "1", "friction of both pads", ">= 0", 0.4)
S = page.parameter("S", "1", "load of the second pad over the first", ">= 0", 0.7)
k_2 = page.parameter("k_2", "N/m", "second stiffness", "> 0", 1.1)
k_3 = page.parameter("k_3", "N/m", "third stiffness", "> 0", 2.6)
a = page.parameter("a", "1", "coupling by the load", "real", 0.8)
g = page.parameter("g", "N/m^3", "hardening", ">= 0", 0.2)
V = page.parameter("V", "m/s", "speed", "> 0", 1.5)
q_1 = page.coordinate("q_1", "m", "first")
q_2 = page.coordinate("q_2", "m", "second")
q_3 = page.coordinate("q_3", "m", "third")
page.kinetic(m * (page.rate(q_1) ** 2 + page.rate(q_2) ** 2 + page.rate(q_3) ** 2) / 2)
page.potential(k_1 * q_1**2 / 2 + k_2 * q_2**2 / 2 + k_3 * q_3**2 / 2)
page.potential(g * (q_1 + q_2 - q_3) ** 4 / 4)
one = page.normal_force(n_0 * exp(a * k_1 * q_2 / n_0), name="one")
two = page.normal_force(S * n_0 * exp(-a * k_1 * q_3 / n_0), name="two")
def law(v):
    return mu * tanh(5 * v / V)
page.friction(q_1 + q_2 / 2, V, law, at_rest=mu, on=one)
page.friction(q_1 - q_3, V, law, at_rest=mu, on=two)
'''


@functools.cache
def plate() -> ParameterSet:
    return model_of(PAGE, "plate").Parameters()


def forces(q: NDArray[np.float64], mu: float) -> NDArray[np.float64]:
    """Of the page at S = 0.7, k_2 = 1.1, k_3 = 2.6, a = 0.8, g = 0.2."""
    hardening = 0.2 * (q[0] + q[1] - q[2]) ** 3
    one, two = mu * np.exp(0.8 * q[1]), mu * 0.7 * np.exp(-0.8 * q[2])
    return np.array(
        [
            q[0] + hardening - one - two,
            1.1 * q[1] + hardening - one / 2,
            2.6 * q[2] - hardening + two,
        ]
    )


@pytest.mark.thorough
def test_a_state_of_three_coordinates_is_found_where_nothing_bounds_them() -> None:
    eq = ss.equilibria(plate())
    assert not eq.undecided
    expected = fsolve(forces, [0.6, 0.1, -0.1], args=(0.4,), xtol=1e-12)
    np.testing.assert_allclose(np.array([*eq.coordinates.values()])[:, 0], expected, atol=1e-12)


@pytest.mark.thorough
def test_the_fold_at_the_end_of_a_long_tube_is_proved() -> None:
    def on_fold(z: NDArray[np.float64]) -> NDArray[np.float64]:
        steps = 1e-6 * np.eye(3)
        K = [(forces(z[:3] + h, z[3]) - forces(z[:3] - h, z[3])) / 2e-6 for h in steps]
        return np.append(forces(z[:3], z[3]), np.linalg.det(K))

    expected = fsolve(on_fold, [3.4, -2.2, -1.1, 3.3], xtol=1e-9)
    assert ss.jump_value(plate(), "mu") == pytest.approx(expected[3], abs=1e-7)


@pytest.mark.thorough
def test_what_no_region_lets_be_proved_is_given_up_soon() -> None:
    proof = ss.certify(plate(), "one equilibrium", between={"mu": (0.0, 0.4), "k_2": (1.0, 1.1)})
    assert (proof.outcome, proof.boxes) == ("undecided", 64)
