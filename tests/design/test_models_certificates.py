"""Certificates and probabilities of any model: against the article's closed forms, and against states followed one by one."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.paths import first_end
from spragsym.design.tube_certificates import ENDS, OPEN, Splitting

SEARCH = ss.load("kang_nam").search
BOX = {"theta0": (0.69, 0.71), "mu0": (0.55, 0.63), "sigma": (0.095, 0.105)}


def sets(model: Any, ranges: dict[str, tuple[float, float]]) -> tuple[Any, Any]:
    """Corners of a box."""
    low, high = (model.Parameters(**{name: ends[side] for name, ends in ranges.items()}) for side in (0, 1))
    return low, high


def random_boxes(seed: int, number: int) -> list[dict[str, tuple[float, float]]]:
    """Within tolerances of some percent."""
    rng, out = np.random.default_rng(seed), []
    for _ in range(number):
        middle = {"theta0": rng.uniform(0.4, 1.3), "mu0": rng.uniform(0.1, 1.0), "kappa": 0.007 * 2 ** rng.uniform(-1, 1)}
        sizes = rng.choice([0.0, 0.03], 3).tolist()
        out.append(
            {name: (value * (1 - size), value * (1 + size)) for (name, value), size in zip(middle.items(), sizes, strict=True)}
        )
    return out


@pytest.mark.thorough
@pytest.mark.parametrize("ranges", random_boxes(5, 5))
def test_nothing_is_proved_that_closed_forms_refute(ranges: Any) -> None:
    found = ss.certify(*sets(SEARCH, ranges), "no jump", method="search", max_boxes=300)
    theirs = ss.certify(*sets(ss.load("kang_nam"), ranges), "no jump")
    assert {found.outcome, theirs.outcome} != {"proved", "refuted"}
    if found.outcome == "refuted":
        point = found.counterexample
        assert ss.jump_value(point, method="closed") < float(point.mu0)


def test_tubes_hold_the_states_of_all_points_of_a_box() -> None:
    """Their change across the box is not linear: by the slopes in the middle alone, corners lie outside."""
    box = Splitting(*sets(SEARCH, BOX), "mu0", 0.0)
    here = box._over(box.whole.low, box.whole.high).followed(box.whole.base, np.array([0.3]))
    assert here.sure[0]
    assert here.z[2, 0] == 0.3
    ends = here.box()[:, 0]
    for theta0 in BOX["theta0"]:
        for sigma in BOX["sigma"]:
            state = ss.equilibria(ss.Parameters.article(theta0=theta0, sigma=sigma, mu0=0.3))
            assert ends.low[0] <= state.x[0] <= ends.high[0]
            assert ends.low[1] <= state.y[0] <= ends.high[1]


@pytest.mark.thorough
def test_outcomes_of_points_are_those_of_closed_forms() -> None:
    """In float64: nothing is said of a point within 1e-6 of its fold, where it may be open."""
    box = Splitting(*sets(SEARCH, BOX), "mu0", 0.0)
    shares = np.random.default_rng(2).random((3, 200))
    values = box.whole.low + shares * (box.whole.high - box.whole.low)
    found = box.settled(box.points(values))[0]
    names = dict(zip((*box.free, "mu0"), values, strict=True))
    jump, known = ss.jump_value(ss.Parameters.article(theta0=names["theta0"], sigma=names["sigma"])), found.outcome != OPEN
    assert known.mean() > 0.98
    assert np.array_equal((found.outcome == ENDS)[known], (jump < names["mu0"])[known])
    assert ((found.safe <= jump) & (jump <= found.top)).all()


@pytest.mark.validate
@pytest.mark.parametrize(("boxes", "width"), [(128, 0.2), pytest.param(2400, 0.025, marks=pytest.mark.thorough)])
def test_the_bracket_holds_the_probability_of_closed_forms(boxes: int, width: float) -> None:
    found = ss.jump_probability(sets(SEARCH, BOX), n=256, rng=1, replicates=2, max_boxes=boxes)
    theirs = ss.jump_probability(sets(ss.load("kang_nam"), BOX), n=1 << 14, rng=1, sobol=False)
    assert found.proved[0] <= theirs.low < theirs.high <= found.proved[1]
    assert found.proved[1] - found.proved[0] < width
    assert found.low <= theirs.probability <= found.high


@pytest.mark.thorough
def test_at_a_fold_and_without_friction() -> None:
    model = ss.load("inclined_belt")
    end = first_end(model.Parameters(theta0=1.0), "mu0", (0.0, 1.0))
    assert end is not None
    below, above = (model.Parameters(theta0=1.0, mu0=end.value * (1 + side)) for side in (-1e-3, 1e-3))
    assert ss.certify(below, below).outcome == "proved"
    assert ss.certify(above, above).outcome == "refuted"
    assert ss.certify(below, above).outcome == "refuted"
    at = model.Parameters(theta0=1.0, mu0=end.value)
    found = ss.certify(at, at)
    assert (found.outcome, found.undecided, found.boxes) == ("undecided", 1.0, 1)  # a point can't be halved
    none = model.Parameters(theta0=1.0, mu0=0.0)
    assert ss.certify(none, none).outcome == "proved"
