"""Jump values and gradients of any model: against the article's closed forms, and against states
followed one by one.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.design.jumps import Followed

ARTICLE = ss.load("kang_nam")
SEARCH = ARTICLE.search


def random_sets(seed: int, number: int) -> Any:
    """Of the article's model, where about one in ten does not jump."""
    rng = np.random.default_rng(seed)
    scales = {"kappa": 0.007, "alpha": 0.007, "sigma": 0.1}
    some = {name: scale * 2 ** rng.uniform(-1, 1, number) for name, scale in scales.items()}
    return SEARCH.Parameters(
        theta0=rng.uniform(0.3, 1.4, number), beta=rng.uniform(0.0, 0.01, number), **some
    )


@pytest.mark.by_hand("3000")
@pytest.mark.thorough
@pytest.mark.parametrize("number", [60, pytest.param(3000, marks=pytest.mark.thorough)])
def test_they_are_those_of_closed_forms(number: int) -> None:
    p = random_sets(1, number)
    found = Followed(p.of(SEARCH), "mu0", "up", None, 3.0).ends()
    theirs = ss.jump_value(p, method="closed")
    theirs = np.where(theirs > 3.0, np.nan, theirs)
    assert not found.reasons
    assert np.array_equal(np.isnan(found.value), np.isnan(theirs))
    jumps = ~np.isnan(theirs)
    assert 0.5 < jumps.mean() < 1.0
    assert (np.abs(found.value - theirs)[jumps] <= found.error[jumps] + 1e-12).all()
    assert found.error.max() < 1e-10


@pytest.mark.thorough
def test_gradients_are_those_of_closed_forms() -> None:
    p = random_sets(2, 20)
    values = p.replace(mu0=[[0.1], [0.2]])  # values of the parameter that varies do not matter
    found, theirs = (
        ss.jump_gradient(p, method="search", until=3.0),
        ss.jump_gradient(values, method="closed"),
    )
    low = theirs.value < 3.0
    for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta"):
        np.testing.assert_allclose(getattr(found, name)[low], getattr(theirs, name)[low], rtol=1e-7)
        assert np.isnan(getattr(found, name)[~low]).all()
    assert (found.V[low] == 0).all()  # of friction that works fully the belt's speed does not count


def test_where_nothing_jumps_there_is_no_slope() -> None:
    for vary in ("mu_s", "v_s"):  # 0 is no v_s
        assert np.isnan(
            [*ss.jump_gradient(ss.load("stick_slip").Parameters(), vary).slopes.values()]
        ).all()
