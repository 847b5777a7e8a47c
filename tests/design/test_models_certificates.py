"""Certificates and probabilities of any model: against the article's closed forms, and against
states followed one by one.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.paths import first_end
from spragsym.design.certificates import Decision
from spragsym.design.tube_certificates import Splitting
from tests.support import box_of

SEARCH = ss.load("kang_nam").search
BOX = {"theta0": (0.69, 0.71), "mu0": (0.55, 0.63), "sigma": (0.095, 0.105)}


def sets(model: Any, ranges: dict[str, tuple[float, float]]) -> tuple[Any, Any]:
    """Corners of a box."""
    low, high = (
        model.Parameters(**{name: ends[side] for name, ends in ranges.items()}) for side in (0, 1)
    )
    return low, high


@pytest.mark.parametrize("claim", ["one equilibrium", "no flutter"])
def test_nothing_is_proved_of_one_face_where_the_other_holds_a_state(claim: str) -> None:
    given = {"alpha": 0.25, "sigma": 1.5, "beta": 0.0, "mu0": 2.2}
    low, high = (
        ss.load("mode_coupling").Parameters(
            **{name: one * (1 + off) for name, one in given.items()}
        )
        for off in (-1e-6, 1e-6)
    )
    assert set(ss.equilibria(low).touching.ravel()) == {"face", "opposite face"}
    assert (
        ss.certify(low, claim, between=box_of(low, high), max_boxes=200, refute=False).outcome
        == "undecided"
    )
    assert ss.certify(low, claim, between=box_of(low, high)).outcome == "refuted"


def test_tubes_hold_the_states_of_all_points_of_a_box() -> None:
    """Their change across the box is not linear: by the slopes in the middle alone, corners lie
    outside.
    """
    box = Splitting(*sets(SEARCH, BOX), "mu0", 0.0)
    here = box._over(box.whole.low, box.whole.high).followed(box.whole.base, np.array([0.3]))
    assert here.proved[0]
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
    jump, known = (
        ss.jump_value(ss.Parameters.article(theta0=names["theta0"], sigma=names["sigma"])),
        found.outcome != Decision.OPEN,
    )
    assert known.mean() > 0.98
    assert np.array_equal((found.outcome == Decision.REFUTED)[known], (jump < names["mu0"])[known])
    assert ((found.safe <= jump) & (jump <= found.top)).all()


@pytest.mark.validate
@pytest.mark.parametrize(
    ("boxes", "width"), [(128, 0.2), pytest.param(2400, 0.025, marks=pytest.mark.thorough)]
)
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
    below, above = (
        model.Parameters(theta0=1.0, mu0=end.value * (1 + side)) for side in (-1e-3, 1e-3)
    )
    assert ss.certify(below).outcome == "proved"
    assert ss.certify(above).outcome == "refuted"
    assert ss.certify(below, between=box_of(below, above)).outcome == "refuted"
    at = model.Parameters(theta0=1.0, mu0=end.value)
    found = ss.certify(at)
    assert (found.outcome, found.undecided, found.boxes) == (
        "undecided",
        1.0,
        1,
    )  # a point can't be halved
    none = model.Parameters(theta0=1.0, mu0=0.0)
    assert ss.certify(none).outcome == "proved"


@pytest.mark.thorough
def test_flutter_begins_where_its_onset_is_proved() -> None:
    """A box up to the onset is proved but for what is next to it, and one beyond it is refuted."""
    model = ss.load("mode_coupling")
    onset = float(np.min(ss.flutter_onsets(model.Parameters(), vary="mu0", damping=False).mu0))
    below, close, above = (model.Parameters(mu0=onset * (1 + side)) for side in (-0.5, -1e-4, 1e-4))
    assert ss.certify(below, "no flutter", between=box_of(below, close)).outcome == "proved"
    assert ss.certify(below, "no flutter", between=box_of(below, above)).outcome == "refuted"
    found = ss.certify(
        below, "no flutter", between={"mu0": (0.5 * onset, onset)}, max_boxes=100, refute=False
    )
    assert found.outcome == "undecided"
    assert found.boxes <= 100
    assert found.undecided < 1e-6


@pytest.mark.thorough
def test_where_two_states_meet() -> None:
    """Next to a fold points are told apart; floats do not decide the point next to it, which can't
    be halved.
    """
    model = ss.load("inclined_belt")
    folds = ss.folds(model.Parameters(theta0=1.0), vary="mu0")
    fold = float(folds.mu0[0])
    at, below, above = (
        model.Parameters(theta0=1.0, mu0=fold * (1 + side)) for side in (0.0, -1e-6, 1e-6)
    )
    found = ss.certify(at, "one equilibrium", refute=False)
    assert (found.outcome, found.undecided, found.boxes) == ("undecided", 1.0, 1)
    counts = [int(ss.equilibria(p).count) for p in (below, above)]
    for p, count in zip((below, above), counts, strict=True):
        assert ss.certify(p, "one equilibrium").outcome == ("proved" if count == 1 else "refuted")
    assert abs(counts[0] - counts[1]) == 2 or 0 in counts


def test_nothing_rises() -> None:
    p = ss.load("two_springs").Parameters(theta0=0.5, mu0=0.2)
    with pytest.raises(
        ss.errors.ParameterError, match=r"vary = 'mu0': 'no flutter' is about all states"
    ):
        ss.certify(p, "no flutter", vary="mu0")
    with pytest.raises(ss.errors.ParameterError, match="give its lower and upper end"):
        ss.certify(p, "one equilibrium", between={"mu0": (0.3, 0.2)})
