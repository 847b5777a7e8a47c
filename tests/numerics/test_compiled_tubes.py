"""Tubes by compiled code beside those by NumPy: the same are proved, with the same boxes."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.tubes import Tubes
from spragsym.numerics import plans
from spragsym.statics.balance import Balance

pytestmark = pytest.mark.skipif(not plans.available(), reason="there was no compiler")

#: Models with a spring at an angle, a law that is no polynomial, two springs, three coordinates,
#: and a torsion spring.
MODELS = ("kang_nam", "hertz_contact", "two_springs", "trolley", "sprag_rod")


def states(name: str, count: int) -> tuple[Tubes, np.ndarray]:
    """Points at random parameters, each with a state in contact, and these."""
    model = ss.load(name).search
    rng = np.random.default_rng(5)
    vary = "mu0" if "mu0" in model.parameters else model.parameters[-1]
    given = {vary: rng.uniform(0.05, 0.8, count)}
    if "theta0" in model.parameters:
        given["theta0"] = rng.uniform(0.3, 1.5, count)
    p = model.Parameters(**given)
    eq = ss.equilibria(p)
    rows = np.flatnonzero(eq.count > 0)
    columns = p.broadcast(*model.parameters)
    fixed = np.array([np.broadcast_to(one, count)[rows] for one in columns])
    z = np.array([*(eq.coordinates[one][rows, 0] for one in model.coordinates), given[vary][rows]])
    return Tubes.of_points(Balance(model), vary, fixed), z


@pytest.mark.parametrize("name", MODELS)
def test_the_same_tubes_are_proved(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Along what varies and along a coordinate, over short ways and over some that are too long."""
    tubes, z = states(name, 600)
    rng = np.random.default_rng(6)
    some = []
    for pivot in (tubes.n, 0):
        of = replace(tubes, pivot=pivot)
        by_s, _ = of.tangents(z)
        size = 10.0 ** rng.uniform(-6, 0, z.shape[1])
        beside = np.abs(z) * 10.0 ** rng.uniform(-12, -4, z.shape[1])
        half = np.where(np.arange(size.size) % 5, size, 0.0)
        some.append((of, (z, by_s, np.zeros((tubes.n + 1, 0, half.size)), half, beside)))
    with_compiled = [of._one_state(*given) for of, given in some]
    assert all(of._tapes is not None for of, _ in some)
    monkeypatch.setattr(plans, "compiled_for", lambda n: None)
    for (of, given), one in zip(some, with_compiled, strict=True):
        other = of._one_state(*given)
        assert 0.1 * one.sure.size < one.sure.sum() < 0.99 * one.sure.size
        np.testing.assert_array_equal(one.sure, other.sure)
        np.testing.assert_array_equal(one.room > 0, other.room > 0)
        np.testing.assert_allclose(one.room, other.room, rtol=1e-9)
        np.testing.assert_allclose(one.off, other.off, rtol=1e-9, atol=1e-24)
        np.testing.assert_allclose(one.held, other.held, rtol=1e-9, atol=1e-24)
