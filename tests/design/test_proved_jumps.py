"""Whether states have ended by proved parts of a box, against the answers point by point."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.design import probability
from spragsym.design.jumps import limit_point_passed
from spragsym.design.proved_jumps import proved_jumps
from spragsym.design.tube_certificates import Splitting


def corners(name: str) -> tuple[ss.Parameters, ss.Parameters]:
    p = ss.load(name).search.Parameters(theta0=np.radians(40.0), mu0=0.5)
    return p, p.replace(theta0=np.radians(42.0), mu0=0.7)


@pytest.mark.thorough
def test_parts_tell_what_each_of_their_points_does() -> None:
    low, high = corners("cubic_contact")
    box = Splitting(low, high, "mu0", 0.0)
    proved = proved_jumps(box, lambda pieces: pieces.volume * (pieces.top > pieces.safe), 4)
    rng = np.random.default_rng(80)
    where = {name: rng.uniform(low[name], high[name], 40) for name in ("theta0", "mu0")}
    p = low.replace(**where)
    found, expected = proved.ended(p), limit_point_passed(p, method="search")
    told = ~np.isnan(found)
    assert told.mean() > 0.5
    np.testing.assert_array_equal(found[told], expected[told])
    assert {0.0, 1.0} == set(found[told].tolist())

    # The same points with another state that is followed: no part says anything of that.
    middle = ss.equilibria(low.replace(theta0=0.5 * (low.theta0 + high.theta0), mu0=0.0))
    farthest = np.argmax(middle["x"][: int(middle.count)])
    other = p.following(x=float(middle["x"][farthest]), y=float(middle["y"][farthest]))
    assert np.isnan(proved.ended(other)).all()


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["cubic_contact", "hertz_contact", "inclined_belt", "two_springs"])
def test_parts_that_are_known_hold_the_reference_state_of_each_point(name: str) -> None:
    low, high = corners(name)
    box = Splitting(low, high.replace(sigma=low.sigma * 1.1), "mu0", 0.0)
    proved = proved_jumps(box, lambda pieces: pieces.volume * (pieces.top > pieces.safe), 64)
    assert proved.known.all()
    rng = np.random.default_rng(80)
    ends = {"theta0": (0.7, 0.73), "mu0": (0.5, 0.7), "sigma": (0.1, 0.11)}
    p = low.replace(**{name: rng.uniform(*span, 100) for name, span in ends.items()})
    each = replace(proved, known=np.zeros_like(proved.known)).ended(p)
    found, told = proved.ended(p), np.isfinite(each)
    assert 0.1 < told.mean()
    np.testing.assert_array_equal(found[told], each[told])
    # What no part tells is told of the state that the part has, followed by itself.
    assert np.isfinite(found).all()
    np.testing.assert_array_equal(found, limit_point_passed(p, method="search"))


@pytest.mark.thorough
def test_a_probability_is_the_same_with_proved_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    low, high = corners("cubic_contact")
    box = low, high.replace(theta0=low.theta0)
    how = {"n": 64, "rng": 1, "replicates": 2, "method": "search"}
    expected = ss.jump_probability(box, **how)
    monkeypatch.setattr(probability, "MANY", 1)
    assert ss.jump_probability(box, **how) == expected
    assert 0.4 < expected.probability < 0.7
