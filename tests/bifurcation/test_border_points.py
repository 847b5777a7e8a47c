"""Border points of several contacts, where one of them only just touches, against closed forms."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.contact_pages import PAD, SPRUNG
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


@pytest.mark.thorough
def test_the_rear_leg_lifts_where_the_closed_form_says_and_the_state_passes() -> None:
    model = model_of(PAD, "pad_on_2")
    rng = np.random.default_rng(11)
    for k_t, h in zip(rng.uniform(0.05, 1.0, 5), rng.uniform(0.2, 1.5, 5), strict=True):
        lifts = (2 + k_t) / (2 * h)
        p = model.Parameters(k_t=k_t, h=h)
        found = ss.folds(p, vary="mu0", between={"mu0": (0.0, 2 * lifts)})
        assert found.complete
        assert found.kind.tolist() == ["passes"]
        assert found["touching"].tolist() == ["front, rear"]
        assert found["at_border"].tolist() == ["rear"]
        np.testing.assert_allclose(found.mu0, lifts, rtol=1e-12)
        np.testing.assert_allclose(found.y, -p.F / 2, rtol=1e-12)


def test_without_the_torsion_spring_nothing_goes_on_where_the_rear_leg_lifts() -> None:
    p = model_of(PAD, "pad_on_2").Parameters(k_t=0.0, h=0.8)
    found = ss.folds(p, vary="mu0", between={"mu0": (0.0, 3.0)})
    assert found.kind.tolist() == ["border_fold"]
    np.testing.assert_allclose(found.mu0, 1 / 0.8, rtol=1e-12)
    assert found.when.tolist() == ["up"]


@pytest.mark.thorough
def test_a_shoe_that_locks_has_a_border_fold_and_one_that_does_not_passes() -> None:
    model = model_of(SPRUNG, "sprung_shoes")
    rng = np.random.default_rng(12)
    for b, c, k in rng.uniform(0.4, 1.0, (3, 3)).tolist():
        locks = (k + b * b) / (b * c)
        for mu, kind in ((0.9 * locks, "passes"), (1.1 * locks, "border_fold")):
            p = model.Parameters(b=b, c=c, k=k, mu0=mu)
            found = ss.folds(p, vary="P", between={"P": (-1.0, 1.0)})
            (here,) = np.flatnonzero(found["at_border"] == "leading")
            assert found.kind[here] == kind
            assert abs(found.P[here]) <= 1e-12
            if kind == "border_fold":
                assert (found.ends[here], found.when[here]) == ("lower", "up")
                count = [ss.count(p.replace(P=P)).item() for P in (-0.01, 0.01)]
                assert count == [2, 0]
