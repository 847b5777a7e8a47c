"""The JavaScript module: Python's folds, flutter onsets and motion."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from tests.oracles.languages import NODE, values
from tests.support import few, lowest_sets

POINT = {
    "theta0": math.radians(49.0),
    "mu0": 0.5,
    "kappa": 0.007,
    "alpha": 0.007,
    "sigma": 0.1,
    "beta": 0.0,
}
START = [0.0, 0.0, 0.0, 0.0]
#: Changes to the article's values that give sets of other shapes: symmetric, one curve, a = 0 and
#: all but 0, none.
SETS: tuple[dict[str, float], ...] = (
    {},
    {"alpha": 0.0},
    {"alpha": 0.7},
    {"alpha": 1.0},
    {"alpha": 1.02, "sigma": 0.03},
    {"alpha": 1.0001},
    {"beta": 0.3},
    {"kappa": 0.05, "sigma": 0.4},
    {"kappa": 0.3, "alpha": 0.02, "sigma": 3.0},
)

pytestmark = pytest.mark.skipif(NODE is None, reason="node is not on this machine")


# ------------------------------------------------------------------------------------------------
# surface, folds and cusps


@pytest.mark.parametrize("changes", few(SETS, SETS[3]))
def test_bifurcation_set_is_that_of_python(changes: dict[str, float]) -> None:
    """As many curves, with their ends, and every point on a fold: f = f′ = 0 there to rounding."""
    p = ss.Parameters.article(**changes)
    fixed = {name: float(getattr(p, name)) for name in PARAMETERS[2:]}
    (found,) = values([("bifurcation_set", fixed)])
    theirs = ss.bifurcation_set(p)
    assert len(found["curves"]) == len(theirs.curves)
    assert _ends(found["curves"]) == pytest.approx(
        _ends([curve.values for curve in theirs.curves]), abs=1e-3
    )
    for curve in found["curves"]:
        theta, theta0, mu0 = (np.array(curve[name]) for name in ("theta", "theta0", "mu0"))
        a, b, d, m = generated_f(theta0, mu0, fixed)
        c, s = np.cos(theta), np.sin(theta)
        size = abs(a * s * c) + abs(b * c) + abs(d * s) + abs(m * s * s)
        assert np.all(abs(a * s * c + b * c + d * s - m * s * s) < 1e-11 * size)
        slope = a * (c * c - s * s) - b * s + d * c - 2 * m * s * c
        assert np.all(abs(slope) < 1e-9 * (abs(a) + abs(b * s) + abs(d * c) + abs(m)))
    assert [cusp["mu0"] for cusp in found["cusps"]] == pytest.approx(
        theirs.cusps.mu0, rel=1e-12, abs=1e-12
    )
    assert [cusp["theta0"] for cusp in found["cusps"]] == pytest.approx(
        theirs.cusps.theta0, abs=1e-12
    )


def generated_f(theta0: Any, mu0: Any, fixed: dict[str, float]) -> tuple[Any, ...]:
    """Coefficients of f in contact, written out: (12), (13) eliminated by hand."""
    kappa, alpha, sigma, beta = (fixed[name] for name in ("kappa", "alpha", "sigma", "beta"))
    stiff, c0, s0 = beta + 1, np.cos(theta0), np.sin(theta0)
    a, b = sigma * (stiff - alpha), -(alpha + sigma) * (stiff * s0 + kappa)
    return a, b, mu0 * (sigma * s0 - kappa) + alpha * c0 * (stiff + sigma), mu0 * sigma


def _ends(curves: Sequence[Any]) -> list[float]:
    """θ₀ and μ₀/(1 + μ₀) of both ends of every curve, in an order that rounding does not decide."""
    ends = [
        tuple(
            sorted(
                (round(curve["theta0"][k], 3), curve["mu0"][k] / (1 + curve["mu0"][k]))
                for k in (0, -1)
            )
        )
        for curve in curves
    ]
    return [float(number) for curve in sorted(ends) for end in curve for number in end]


@pytest.mark.parametrize(
    "changes", few([{"alpha": 0.7}, {"alpha": 1.0}, {"beta": 0.3}], {"alpha": 0.7})
)
def test_flutter_onsets_are_those_of_python(changes: dict[str, float]) -> None:
    """The onsets at some frictions, which Python proves complete, lie on the curves, and no others
    do.
    """
    p = ss.Parameters.article(**changes)
    (curves,) = values(
        [("flutter_boundary", {name: float(getattr(p, name)) for name in PARAMETERS[2:]})]
    )
    for mu0 in (4.0, 30.0):
        crossed = []
        for curve in curves:
            off = np.array(curve["mu0"]) - mu0
            theta0 = np.array(curve["theta0"])
            at = np.flatnonzero(off[:-1] * off[1:] < 0)
            crossed += list(
                theta0[at] - off[at] * (theta0[at + 1] - theta0[at]) / (off[at + 1] - off[at])
            )
        exact = ss.flutter_onsets(p.replace(mu0=mu0), damping=False).theta0
        assert sorted(crossed) == pytest.approx(exact, abs=5e-3)


@pytest.mark.thorough
def test_the_lowest_fold_is_that_python_proves() -> None:
    sets = [{name: float(getattr(p, name)) for name in PARAMETERS[2:]} for p in lowest_sets(24)]
    kinds = set()
    for given, found in zip(
        sets, values([("critical_friction", given) for given in sets]), strict=True
    ):
        theirs = ss.critical_friction(ss.Parameters(**given))
        kinds.add(theirs.kind)
        if not theirs.kind:
            assert found["kind"] == ""
        else:
            assert found["kind"] == theirs.kind
            assert found["mu0"] == pytest.approx(float(theirs), rel=1e-9, abs=1e-12), given
            assert found["theta0"] == pytest.approx(theirs.theta0, rel=1e-5), given
    assert kinds == {"cusp", "turn", ""}


# ------------------------------------------------------------------------------------------------
# motion


@pytest.mark.parametrize(("V", "start"), [(0.2, START), (0.1, [0.0, -0.01, 0.3, 0.0])])
def test_step_is_of_fourth_order_across_the_kinks(V: float, start: list[float]) -> None:
    """The orbits leave the belt and come back, or overtake it; the reference is the other
    integrator at tight tolerance.
    """
    begun = dict(zip(("x0", "y0", "vx0", "vy0"), start, strict=True))
    exact = ss.simulate(ss.Parameters(**POINT), V=V, d=10.0, t_end=60.0, rtol=1e-12, **begun).state[
        :, -1
    ]
    steps = (0.1, 0.05, 0.025, 0.0125)
    reached = values(
        [("steps", POINT, {"V": V, "d": 10.0}, start, h, round(60.0 / h)) for h in steps]
    )
    errors = [float(np.abs(np.array(state) - exact).max()) for state in reached]
    assert errors[-1] < 1e-8
    assert math.log2(errors[0] / errors[-1]) / 3 > 3.6
