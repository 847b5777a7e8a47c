"""The solver as it chooses its way by itself, against an independent reference; shapes, bad input,
dimensions.
"""

import math

import numpy as np
import pytest

import spragsym as ss
from spragsym.generated._where import where
from spragsym.generated.equilibrium import f_coefficients
from tests.oracles.families import FAMILIES
from tests.oracles.true_errors import worst_errors, wrong_counts

# ------------------------------------------------------------------------------------------------
# counts and digits


@pytest.mark.parametrize("name", FAMILIES)
def test_counts_digits_and_bounds(name: str) -> None:
    number = list(FAMILIES).index(name)
    rng = np.random.default_rng([7, number])
    p = FAMILIES[name](rng, 400)
    eq = ss.equilibria(p)
    assert wrong_counts(p, eq) == 0
    assert set(np.unique(eq.count)) <= {1, 3}
    for found in (eq, ss.equilibria(p, contact=False)):
        worst, ratio = worst_errors(p, found, rng, 40)
        assert worst <= 1e-12
        assert ratio <= 1
        assert np.nanmax(found.error, initial=0) <= 1e-12


def test_three_equilibria_need_a_positive_sum() -> None:
    """Three imply a + d > 0; the converse is not so."""
    for number, family in enumerate(("random", "near folds", "cusp wedge")):
        p = FAMILIES[family](np.random.default_rng([41, number]), 500)
        theta0, *values = p.broadcast("theta0", "mu0", "kappa", "alpha", "sigma", "beta")
        a, _, d, _ = f_coefficients(np.cos(theta0), np.sin(theta0), *values, 1)
        count = ss.equilibria(p).count
        assert (a + d > 0)[count == 3].all()
        assert (a + d > 0)[count == 1].any()


# ------------------------------------------------------------------------------------------------
# shapes


def test_shapes_broadcast() -> None:
    p = ss.Parameters.article(theta0=np.radians([[30.0], [49.0]]), mu0=np.array([0.1, 0.5, 0.7]))
    eq = ss.equilibria(p)
    assert eq.count.shape == (2, 3)
    assert eq.theta.shape == (2, 3, 3)
    assert eq.eigenvalues.shape == (2, 3, 3, 4)
    one = ss.equilibria(ss.Parameters.article(theta0=math.radians(49), mu0=0.7))
    assert one.count.shape == ()
    assert one.theta.shape == (3,)
    np.testing.assert_array_equal(eq.theta[1, 2], one.theta)
    assert ss.equilibria(ss.Parameters.article(theta0=np.empty((0, 4)))).theta.shape == (0, 4, 3)
    assert (
        where(np.arange(2000)[:, None] % 2 > 0, np.ones((1, 1500)), 0.0).sum() == 1000 * 1500
    )  # flags of another shape


@pytest.mark.parametrize("dtype", [np.float32, np.int64, np.float64])
def test_number_types_are_taken_as_float64(dtype: type) -> None:
    eq = ss.equilibria(ss.Parameters(np.array([1, 2], dtype=dtype), 1, 1, 1, 1, 1))
    np.testing.assert_array_equal(
        eq.theta, ss.equilibria(ss.Parameters([1.0, 2.0], 1.0, 1.0, 1.0, 1.0, 1.0)).theta
    )


# ------------------------------------------------------------------------------------------------
# bad input


@pytest.mark.parametrize(
    ("changes", "error", "words"),
    [
        ({"theta0": math.nan}, ss.errors.ParameterError, ["theta0 = nan", "(0, pi)"]),
        ({"theta0": 0.0}, ss.errors.ParameterError, ["theta0 = 0", "radians"]),
        ({"theta0": 49.0}, ss.errors.ParameterError, ["theta0 = 49", "numpy.radians"]),
        ({"theta0": [1.0, -1.0]}, ss.errors.ParameterError, ["theta0[1] = -1"]),
        ({"theta0": 1.0, "sigma": 0.0}, ss.errors.ParameterError, ["sigma = 0", "(0, inf)"]),
        ({"theta0": 1.0, "kappa": -1e-9}, ss.errors.ParameterError, ["kappa = -", "preload"]),
        ({"theta0": 1.0, "alpha": -0.1}, ss.errors.ParameterError, ["alpha", "[0, inf)"]),
        ({"theta0": 1.0, "beta": math.inf}, ss.errors.ParameterError, ["beta = inf"]),
        ({"theta0": 1.0, "mu0": -0.5}, ss.errors.ParameterError, ["mu0", "mirror"]),
        ({"theta0": "1"}, ss.errors.ParameterTypeError, ["theta0", "text"]),
        ({"theta0": True}, ss.errors.ParameterTypeError, ["boolean"]),
        ({"theta0": 1 + 0j}, ss.errors.ParameterTypeError, ["complex"]),
        (
            {"theta0": [[1.0], [1.0, 2.0]]},
            ss.errors.ParameterTypeError,
            ["theta0", "regular array"],
        ),
        (
            {"theta0": np.ma.array([1.0, 2.0], mask=[0, 1])},
            ss.errors.ParameterTypeError,
            ["1 masked", "compressed"],
        ),
        (
            {"theta0": [1.0, 1.0], "mu0": [1.0, 1.0, 1.0]},
            ss.errors.ParameterError,
            ["theta0 (2,)", "mu0 (3,)"],
        ),
        (
            {"theta0": 1.0, "gamma": 1.0},
            ss.errors.ParameterTypeError,
            ["gamma", "did you mean sigma"],
        ),
        ({"theta0": 1.0, "kappa": None}, ss.errors.ParameterError, ["kappa is missing"]),
    ],
)
def test_bad_input_is_named(
    changes: dict[str, object], error: type[Exception], words: list[str]
) -> None:
    with pytest.raises(error) as caught:
        ss.equilibria(ss.Parameters.article(**changes))
    assert isinstance(caught.value, ss.errors.SpragsymError)
    for word in words:
        assert word in str(caught.value)


# ------------------------------------------------------------------------------------------------
# dimensions


def test_physical_parameters_come_back_to_newtons_and_metres() -> None:
    brake = ss.PhysicalParameters(
        m=0.4, k=1e5, k_x=9e3, k_y=2e4, k_c=1e6, F_L=350, L_0=0.05, theta0=1.0, mu0=0.5, V=20, d=0.1
    )
    eq = ss.equilibria(brake.dimensionless())
    x, y = eq.x[0] * brake.scales.length, eq.y[0] * brake.scales.length
    # Newton's law with dimensions, (1) and (2), written out.
    dx, dy = 0.05 * math.cos(1.0) - x, 0.05 * math.sin(1.0) - y
    L = math.hypot(dx, dy)
    N = -1e6 * y
    assert abs(0.5 * N - 1e5 * (0.05 - L) * dx / L - 9e3 * x) < 1e-9 * 350
    assert abs(N - 350 - 1e5 * (0.05 - L) * dy / L - 2e4 * y) < 1e-9 * 350
    other = ss.PhysicalParameters(
        m=0.4e3, k=1e2, k_x=9, k_y=20, k_c=1e3, F_L=350, L_0=50, theta0=1.0, mu0=0.5
    )  # N/mm, mm
    np.testing.assert_allclose(ss.equilibria(other.dimensionless()).x, eq.x, rtol=1e-13)
    belt = brake.dimensionless()
    assert math.isclose(belt.V * brake.scales.length / brake.scales.time, 20, rel_tol=1e-14)
    assert math.isclose(belt.V * belt.d, 20 * 0.1, rel_tol=1e-14)
    with pytest.raises(ss.errors.ParameterError, match="V is missing"):
        other.dimensionless().require("V")
    with pytest.raises(ss.errors.ParameterError, match="k_c"):
        ss.PhysicalParameters(m=1, k=1, k_x=1, k_y=1, k_c=0, F_L=1, L_0=1, theta0=1, mu0=0.5)
