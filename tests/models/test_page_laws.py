"""Laws of many shapes on one page, from the page to states, jumps and motions, against equations
written down here by hand.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss

pytest.importorskip("sympy")

from tests.oracles.user_pages import model_of, shipped_page
from tests.support import box_of, few

OFFERED = "import Abs, Page, atan, cos, cosh, exp, log, pi, sgn, sin, sinh, sqrt, tanh"


@dataclass(frozen=True)
class Case:
    """Two laws as a page has them, and the same for numbers of mpmath at V = 0.5, d = 10, mu0 =
    0.5, the scales being 1.
    """

    contact: str
    friction: str
    push: Callable[[Any], Any]
    mu: Callable[[Any], Any]
    at_rest: bool = False


CASES = {
    "tanh": Case(
        "k_c * L_0 * tanh(depth / L_0)",
        "mu0 * tanh(d * v), at_rest=mu0",
        mpmath.tanh,
        lambda v: mpmath.tanh(10 * v) / 2,
        at_rest=True,
    ),
    "log": Case(
        "k_c * L_0 * log(1 + depth / L_0)",
        "mu0 * log(1 + d * Abs(v)) * sgn(v)",
        lambda depth: mpmath.log(1 + depth),
        lambda v: mpmath.log(1 + 10 * abs(v)) * mpmath.sign(v) / 2,
    ),
    "powers": Case(
        "k_c * L_0 * (depth / L_0) ** (4 / 3)",
        "mu0 * v / (v**2 + 1 / d**2) ** 0.5 * (1 + d * Abs(v)) ** (-1 / 5)",
        lambda depth: depth ** mpmath.mpf("4/3") if depth else mpmath.mpf(0),
        lambda v: (
            v / mpmath.sqrt(v**2 + mpmath.mpf("0.01")) * (1 + 10 * abs(v)) ** -mpmath.mpf("0.2") / 2
        ),
    ),
    "atan": Case(
        "k_c * L_0 * (atan(depth / L_0) + depth / (2 * L_0) * (1 + depth / L_0) ** 1.5)",
        "mu0 * 2 / pi * atan(d * v)",
        lambda depth: mpmath.atan(depth) + depth / 2 * (1 + depth) ** mpmath.mpf(1.5),
        lambda v: mpmath.atan(10 * v) / mpmath.pi,
    ),
}
#: theta0, kappa, alpha, sigma, mu0.
THETA0, KAPPA, ALPHA, SIGMA = 0.8, 0.007, 0.007, 0.1
VALUES = {"theta0": THETA0, "kappa": KAPPA, "alpha": ALPHA, "sigma": SIGMA}


@pytest.fixture(scope="module", params=few(CASES, "powers", "log"))
def model(request: pytest.FixtureRequest) -> Any:
    name = request.param
    case = CASES[name]
    laws = (
        ("k_c * depth)", f"{case.contact})"),
        ("mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0", case.friction),
    )
    text = shipped_page("kang_nam", ("import Abs, Page, cos, exp, sgn, sin", OFFERED), *laws)
    return case, model_of(text, f"{name}_page")


def forces(case: Case, x: Any, y: Any, mu: Any) -> tuple[Any, Any]:
    """Along the belt and across it: ties, the inclined spring of length 1 from its anchor, the
    preload, contact and friction.
    """
    dx, dy = mpmath.cos(THETA0) - x, mpmath.sin(THETA0) - y
    length = mpmath.sqrt(dx**2 + dy**2)
    tension = mpmath.mpf(SIGMA) * (length - 1)
    n = case.push(-y) if y < 0 else mpmath.mpf(0)
    along = tension * dx / length - mpmath.mpf(ALPHA) * x + mu * n
    return along, tension * dy / length - mpmath.mpf(KAPPA) + n


@pytest.mark.thorough
def test_states_are_those_of_the_equations(model: Any) -> None:
    case, it = model
    p = it.Parameters(**VALUES)
    found = ss.equilibria(p)
    assert bool(found.complete)
    assert int(found.count) >= 1
    with mpmath.workdps(50):
        mu = mpmath.mpf("0.5") if case.at_rest else case.mu(mpmath.mpf("0.5"))
        for x, y, error in zip(*np.broadcast_arrays(found.x, found.y, found.error), strict=True):
            if np.isnan(x):
                continue
            truth = mpmath.findroot(
                lambda *q: forces(case, *q, mu), (mpmath.mpf(x), mpmath.mpf(y)), tol=1e-60
            )
            assert error < 1e-12
            assert max(abs(truth[0] - x), abs(truth[1] - y)) <= error * max(1, abs(x), abs(y))


def test_stiffness_is_the_derivative_of_the_forces(model: Any) -> None:
    case, it = model
    p = it.Parameters(**VALUES)
    taken = [float(value) for value in it.arguments(p)]
    x, y, mu = 0.13, -0.07, 0.4
    ((dx, dy, _),) = it.algebra.geometry(x, y, *taken)
    length = np.hypot(dx, dy)
    K = it.algebra.forces_jacobian(x, y, dx / length, dy / length, length, *taken, mu, 1)
    with mpmath.workdps(50):
        for i in range(2):

            def row(a: Any, b: Any, i: int = i) -> Any:
                return -forces(case, a, b, mpmath.mpf(mu))[i]

            for j, way in enumerate(((1, 0), (0, 1))):
                assert float(K[i][j]) == pytest.approx(
                    float(mpmath.diff(row, (x, y), way)), rel=1e-12, abs=1e-14
                )


@pytest.mark.thorough
def test_tolerances_are_proved_with_any_law(model: Any) -> None:
    """Over a box of parameters the laws are asked for in affine arithmetic."""
    _, it = model
    middle = it.Parameters(**VALUES, mu0=0.1)
    low, high = (
        middle.replace(sigma=SIGMA * (1 + side), d=10 * (1 + side), mu0=0.1 * (1 + side))
        for side in (-0.02, 0.02)
    )
    assert ss.certify(low, between=box_of(low, high), max_boxes=200).outcome == "proved"
    rng = np.random.default_rng(1)
    values = {
        name: rng.uniform(float(getattr(low, name)), float(getattr(high, name)), 50)
        for name in ("sigma", "d", "mu0")
    }
    assert not (np.asarray(ss.jump_value(middle.replace(**values))) <= values["mu0"]).any()


@pytest.mark.by_hand("atan", "tanh")
@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["scipy", "heyoka"])
def test_motions_are_those_of_the_equations(model: Any, backend: str) -> None:
    """The mass begins beyond the belt's speed, above the belt: both borders are crossed."""
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    case, it = model
    p = it.Parameters(**VALUES)
    start, t_end = (0.05, 0.01, 0.6, -0.05), 12.0
    found = ss.simulate(p, start=start, t_end=t_end, rtol=1e-11, backend=backend)

    def field(_: float, state: Any) -> list[float]:
        x, y, vx, vy = map(mpmath.mpf, state.tolist())
        with mpmath.workdps(17):
            return [
                float(vx),
                float(vy),
                *map(float, forces(case, x, y, case.mu(mpmath.mpf("0.5") - vx))),
            ]

    want = solve_ivp(
        field, (0, t_end), start, method="DOP853", rtol=1e-8, atol=1e-10, max_step=0.25
    )
    ends = [float(getattr(found, name)[-1]) for name in ("x", "y", "vx", "vy")]
    assert ends == pytest.approx(want.y[:, -1], abs=2e-7)
