"""Forces with poles, and without a potential in one form: published models with closed forms."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.user_pages import model_of, replaced
from tests.statics.test_models_growth import COLUMN

#: A plate over an electrode (Nathanson et al. 1967): x (1 − x)² = U, with a pole where the gap is
#: closed.
PULL_IN = '''"""A published model."""
from spragsym.derive.model import Page

page = Page("A published model.")
m = page.unit("m", "kg", "mass")
l = page.unit("l", "m", "length")
k = page.unit("k", "N/m", "stiffness")
U = page.parameter("U", "N", "force of the voltage across the open gap", ">= 0", 0.1, becomes="U")
x = page.coordinate("x", "m", "gap closed")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.force(U / (1 - x / l) ** 2, along=x)
'''
#: Ziegler's column under a load that follows the upper link in part only (Herrmann and Bungay
#: 1964).
PARTLY = replaced(
    COLUMN,
    ("a = page", 'e = page.parameter("e", "1", "share that follows", "real", 1.0)\na = page'),
    ("sin(b), -P * cos(b)", "sin(e * b), -P * cos(e * b)"),
)


def test_pull_in_is_found_and_all_is_decided_beside_the_pole() -> None:
    p = model_of(PULL_IN, "pull_in").Parameters()
    found = ss.folds(p, "U", between={"U": (0.01, 1.0)}, within={"x": (-1.0, 0.99)})
    assert (found.U, found.x) == (pytest.approx([4 / 27]), pytest.approx([1 / 3]))
    assert (found.ends.tolist(), found.when.tolist(), found.undecided.shape[0]) == (
        ["lower"],
        ["up"],
        0,
    )
    eq = ss.equilibria(p.replace(U=0.1))
    assert eq.decided
    assert eq.x[:3] == pytest.approx(np.sort(np.roots([1.0, -2.0, 1.0, -0.1]).real))


@pytest.mark.thorough
def test_flutter_under_a_load_that_follows_in_part() -> None:
    p, near = model_of(PARTLY, "partly").Parameters(e=0.9), (-0.1, 0.1)
    onsets = ss.flutter_onsets(p, "P", between={"P": (0.0, 8.0)}, within={"a": near, "b": near})
    # M = ((3, 1), (1, 1)), K = ((2 − P, e P − 1), (−1, 1 − (1 − e) P)): the discriminant of det(K −
    # κ M) in P.
    load = np.polynomial.Polynomial([0.0, 1.0])
    det = (2 - load) * (1 - 0.1 * load) - (1 - 0.9 * load)
    trace = (2 - load) + 3 * (1 - 0.1 * load) - (0.9 * load - 1) + 1
    closed = (trace**2 - 8 * det).roots()
    # At the other one, P = 5, both squares are negative: two real λ meet.
    assert onsets.P == pytest.approx(closed[trace(closed) > 0])
