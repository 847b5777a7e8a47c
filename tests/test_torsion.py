"""Torsion springs: the energy k φ²/2 of the least turning φ, against the same written by hand."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest

import spragsym as ss
from tests.conftest import Once
from tests.test_documents import ROOT

pytest.importorskip("sympy")

PAGE = ROOT / "tests/soft_brake.py"
#: Places (x, y) and angles θ₀: near rest, far turned, beside the ray φ = ±π, close to the anchor.
PLACES = [(0.1, -0.02, 0.8), (1.3, 0.2, 0.8), (1.5, 1.2, 0.8), (1.4, 1.46, 0.7), (0.69, 0.72, 0.8), (-0.5, 2.0, 2.2)]
VALUES = {"mu0": 0.5, "kappa": 0.007, "alpha": 0.007, "sigma": 0.1, "tau": 0.03, "gamma": 5.0, "V": 0.5, "d": 10.0}


@pytest.fixture(scope="module")
def model(once: Once, tmp_path_factory: pytest.TempPathFactory) -> Any:
    from spragsym.derive import folder

    def derived() -> str:
        out = tmp_path_factory.mktemp("torsion") / "soft_brake"
        folder.write_page(PAGE, out)
        return str(out)

    return ss.load(once("soft_brake", derived))


def turning(x: Any, y: Any, theta0: Any) -> Any:
    """θ − θ₀, the least turning, from the drawing."""
    off = mpmath.atan2(mpmath.sin(theta0) - y, mpmath.cos(theta0) - x) - theta0
    return off + 2 * mpmath.pi if off <= -mpmath.pi else off - 2 * mpmath.pi if off > mpmath.pi else off


def energy(x: Any, y: Any, theta0: Any) -> Any:
    """Springs, torsion spring, preload and contact."""
    it = {name: mpmath.mpf(value) for name, value in VALUES.items()}
    length = mpmath.hypot(mpmath.cos(theta0) - x, mpmath.sin(theta0) - y)
    depth = max(-y, mpmath.mpf(0))
    total = it["alpha"] * x**2 / 2 + it["sigma"] * (length - 1) ** 2 / 2 + it["tau"] * turning(x, y, theta0) ** 2 / 2
    return total + it["kappa"] * y + depth**2 / 2 + it["gamma"] * depth**3 / 3


def state(model: Any, x: Any, y: Any, theta0: Any) -> tuple[list[Any], list[Any]]:
    """Arguments of the functions of statics up to μ and pushing, in 50 digits, and those of motion."""
    known = {
        **{name: mpmath.mpf(value) for name, value in VALUES.items()},
        "cos0": mpmath.cos(theta0),
        "sin0": mpmath.sin(theta0),
    }
    given, moving = ([known[name] for name in model.about["arguments"][kind]] for kind in ("statics", "motion"))
    length = mpmath.hypot(known["cos0"] - x, known["sin0"] - y)
    direction = [(known["cos0"] - x) / length, (known["sin0"] - y) / length, length]
    return [x, y, *direction, turning(x, y, theta0), *given], moving


@pytest.mark.parametrize("place", PLACES)
def test_forces_and_stiffness_are_derivatives_of_the_energy(model: Any, place: tuple[float, float, float]) -> None:
    with mpmath.workdps(50):
        x, y, theta0 = map(mpmath.mpf, place)
        taken, moving = state(model, x, y, theta0)
        pushing = int(y < 0)
        forces = model.statics.forces(*taken, 0, pushing, xp=mpmath)
        stiffness = model.statics.forces_jacobian(*taken, 0, pushing, xp=mpmath)
        by_angle = model.statics.forces_by_parameters(*taken, 0, pushing, xp=mpmath)
        at = x, y, theta0
        for row in range(2):
            order = tuple(int(i == row) for i in range(3))
            assert abs(forces[row] - mpmath.diff(energy, at, order)) < 1e-20
            for column in range(2):
                second = tuple(a + int(i == column) for i, a in enumerate(order))
                assert abs(stiffness[row][column] - mpmath.diff(energy, at, second)) < 1e-12
            assert abs(by_angle[row][0] - mpmath.diff(energy, at, (*order[:2], 1))) < 1e-12
        stored = model.motion.energy(x, y, 0, 0, *moving, pushing, xp=mpmath)
        assert abs(stored - energy(*at)) < 1e-40


def test_turning_of_statics_and_of_motion_is_the_least(model: Any) -> None:
    """Cosine and sine of the turning; and accelerations on either way are those of the least turning where that is on the way."""
    for x, y, theta0 in PLACES:
        with mpmath.workdps(50):
            taken, moving = state(model, *map(mpmath.mpf, (x, y, theta0)))
            ((cosine, sine),) = model.statics.turnings(*taken[:5], *taken[6:], xp=mpmath)
            assert abs(mpmath.atan2(sine, cosine) - taken[5]) < 1e-45
            rows = [model.motion.regime_rhs(taken[0], taken[1], 0.1, 0.2, *moving, 1, 1, 1, way, xp=mpmath) for way in (1, -1)]
            static = model.statics.forces(*taken, 0, 1, xp=mpmath)
            assert abs(rows[0 if sine > 0 else 1][1] + static[1]) < 1e-45
            other = (taken[5] - mpmath.sign(sine) * 2 * mpmath.pi) if cosine < 0 else taken[5]
            turned = model.statics.forces(*taken[:5], other, *taken[6:], 0, 1, xp=mpmath)
            assert abs(rows[1 if sine > 0 else 0][1] + turned[1]) < 1e-45
