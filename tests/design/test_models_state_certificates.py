"""Claims about all states over boxes of parameters: against the article's closed forms, and against points of the boxes."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.design.tube_certificates import certify

ARTICLE = ss.load("kang_nam")
MODELS = ["two_springs", "cubic_contact", "mode_coupling", "inclined_belt", "sprag_rod", "damped"]
CLAIMS = ("one equilibrium", "no flutter")


def a_box(model: Any, rng: np.random.Generator) -> tuple[Any, Any]:
    """Two corners: three parameters about random values, within some percent."""
    names = [name for name in ("theta0", "mu0", "mu", "mu_s", "sigma", "kappa") if name in model.parameters][:3]
    ranges = {"theta0": (0.3, 1.4), "mu0": (0.02, 1.2), "mu": (0.02, 1.2), "mu_s": (0.02, 1.2), "sigma": (0.05, 0.3)}
    middle = {name: float(rng.uniform(*ranges.get(name, (0.004, 0.02)))) for name in names}
    size = float(rng.choice([0.0, 0.01, 0.05]))
    low, high = (model.Parameters(**{name: value * (1 + side * size) for name, value in middle.items()}) for side in (-1, 1))
    return low, high


def points(low: Any, high: Any, rng: np.random.Generator, number: int) -> Any:
    """Random points of a box, its corners more often than not."""
    free = [name for name in low.model.parameters if getattr(low, name) < getattr(high, name)]
    share = {name: np.clip(rng.uniform(-0.5, 1.5, number), 0, 1) for name in free}
    values = {name: (1 - t) * getattr(low, name) + t * getattr(high, name) for name, t in share.items()}
    return low.replace(**values)


def fails(eq: Any, claim: str) -> Any:
    """Where a claim is false at points, by their equilibria."""
    return eq.count != 1 if claim == CLAIMS[0] else (eq.stability == ss.Stability.FLUTTER).any(axis=-1)


@pytest.mark.thorough
@pytest.mark.parametrize("claim", CLAIMS)
@pytest.mark.parametrize("number", [1, 2, 3])
def test_nothing_is_said_that_closed_forms_contradict(number: int, claim: str) -> None:
    rng = np.random.default_rng([7, number])
    low, high = a_box(ARTICLE, rng)
    found = ss.certify(low, high, claim, method="search", max_boxes=200)
    theirs = ss.certify(low, high, claim, method="closed")
    assert {found.outcome, theirs.outcome} != {"proved", "refuted"}
    if found.outcome == "proved":
        assert not fails(ss.equilibria(points(low, high, rng, 2000), method="closed"), claim).any()
    if found.outcome == "refuted":
        assert fails(ss.equilibria(found.counterexample, method="closed"), claim)


@pytest.mark.by_hand("sprag_rod", "cubic_contact", "inclined_belt", "damped")
@pytest.mark.thorough
@pytest.mark.parametrize("claim", CLAIMS)
@pytest.mark.parametrize("name", MODELS)
def test_what_is_proved_is_so_at_points_and_what_is_refuted_is_not(name: str, claim: str) -> None:
    rng = np.random.default_rng(3)
    for _ in range(6):
        low, high = a_box(ss.load(name), rng)
        found = ss.certify(low, high, claim, max_boxes=60)
        if found.outcome == "proved":
            assert not fails(ss.equilibria(points(low, high, rng, 60)), claim).any()
        if found.outcome == "refuted":
            assert fails(ss.equilibria(found.counterexample), claim)


@pytest.mark.thorough
def test_flutter_begins_where_its_onset_is_proved() -> None:
    """A box up to the onset is proved but for what is next to it, and one beyond it is refuted."""
    model = ss.load("mode_coupling")
    onset = float(np.min(ss.flutter_onsets(model.Parameters(), vary="mu0", damping=False).mu0))
    below, close, above = (model.Parameters(mu0=onset * (1 + side)) for side in (-0.5, -1e-4, 1e-4))
    assert ss.certify(below, close, "no flutter").outcome == "proved"
    assert ss.certify(below, above, "no flutter").outcome == "refuted"
    found = ss.certify(below, model.Parameters(mu0=onset), "no flutter", max_boxes=100, refute=False)
    assert found.outcome == "undecided"
    assert found.boxes <= 100
    assert found.undecided < 1e-6


@pytest.mark.thorough
def test_where_two_states_meet() -> None:
    """Next to a fold points are told apart; floats do not decide the point next to it, which can't be halved."""
    model = ss.load("inclined_belt")
    folds = ss.folds(model.Parameters(theta0=1.0), vary="mu0")
    fold = float(folds.mu0[0])
    at, below, above = (model.Parameters(theta0=1.0, mu0=fold * (1 + side)) for side in (0.0, -1e-6, 1e-6))
    found = ss.certify(at, at, "one equilibrium", refute=False)
    assert (found.outcome, found.undecided, found.boxes) == ("undecided", 1.0, 1)
    counts = [int(ss.equilibria(p).count) for p in (below, above)]
    for p, count in zip((below, above), counts, strict=True):
        assert ss.certify(p, p, "one equilibrium").outcome == ("proved" if count == 1 else "refuted")
    assert abs(counts[0] - counts[1]) == 2 or 0 in counts


def test_nothing_rises() -> None:
    p = ss.load("two_springs").Parameters(theta0=0.5, mu0=0.2)
    with pytest.raises(ss.ParameterError, match=r"vary = 'mu0': 'no flutter' is about all states"):
        ss.certify(p, p, "no flutter", vary="mu0")
    with pytest.raises(ss.ParameterError, match="exchange the two"):
        certify(p.replace(mu0=0.3), p, "one equilibrium", vary=None)
