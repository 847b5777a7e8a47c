"""A rod that leans on a belt with its end: all equilibria have |a − t₀| ≤ f √(1 + μ²)/τ, whatever
the region is that is searched for them.
"""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.rod_on_its_end import ROD
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


@pytest.mark.thorough
@pytest.mark.parametrize("mu", [0.0, 1.0, 5.0, 8.0])
def test_the_force_of_a_linear_contact_bounds_what_it_turns(mu: float) -> None:
    f, tau, t0 = 0.02, 0.05, 0.3
    eq = ss.equilibria(model_of(ROD, "rod_on_its_end").Parameters(mu=mu))
    assert eq.complete

    def left(a: float) -> float:
        return f * (mu * math.sin(a) - math.cos(a)) - tau * (a - t0)

    reach = f * math.hypot(1, mu) / tau
    angles = np.linspace(t0 - reach, t0 + reach, 20_001)
    signs = np.sign([left(a) for a in angles])
    want = [
        brentq(left, angles[k], angles[k + 1], xtol=1e-15)
        for k in np.flatnonzero(signs[:-1] * signs[1:] < 0)
    ]
    assert np.allclose(sorted(eq["a"]), want, atol=1e-11)
    x, _, a = (np.array(side) for side in eq.region)
    assert np.allclose(x, mu * f / 0.1, atol=1e-5)
    assert a[0] >= t0 - f * (1 + mu) / tau - 1e-5
    assert a[1] <= t0 + f * (1 + mu) / tau + 1e-5


def test_what_is_known_of_an_undecided_end_is_printed_as_such() -> None:
    undecided = ss.results.CriticalLoad("mu", "t0", 0.5, math.nan, "undecided", math.nan, False)
    assert str(undecided) == "0.5 or more, undecided"
    assert str(undecided.__class__("mu", "t0", 0.5, 1.0, "cusp", 0.0)) == "0.5"
