"""Jump values, their slopes, margins and lowest ends of several contacts, against closed forms.

The leading shoe touches a worn drum at the load P = k w/(b l), w the wear at its place. Where its
friction locks it, μ b c > k + b², the state ends there: a border fold.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.tubes import Tubes
from spragsym.design.jumps import limit_point_passed
from spragsym.design.proved_jumps import proved_jumps
from spragsym.design.tube_certificates import Splitting
from spragsym.statics.search import balances_of
from tests.oracles.contact_pages import JAMMING, PAD, WORN
from tests.oracles.user_pages import model_of
from tests.support import box_of

pytest.importorskip("sympy")

#: A worn drum.
GIVEN = {"b": 0.7, "c": 0.9, "k": 0.3, "l": 1.5, "d": 0.05, "s": 0.2, "s_0": 0.3}
#: A search that takes a few seconds.
FEW = ss.MarginOptions(rays=1, rounds=2)


def shoe() -> ss.Model:
    """The page, derived once."""
    return model_of(WORN, "worn_shoe")


def drawn(rng: np.random.Generator, size: int) -> dict[str, np.ndarray]:
    """Random sets, of which one half locks."""
    found = {
        name: rng.uniform(*ends, size)
        for name, ends in {
            "b": (0.4, 1.0),
            "c": (0.4, 1.0),
            "k": (0.1, 0.5),
            "l": (0.5, 2.0),
            "d": (0.02, 0.1),
            "s": (0.0, 1.0),
            "s_0": (0.2, 0.8),
        }.items()
    }
    return found | {"mu0": rng.uniform(0.5, 1.5, size) * locks(found)}


def locks(p: Any) -> Any:
    """The friction from which on the leading shoe locks."""
    return (p["k"] + p["b"] ** 2) / (p["b"] * p["c"])


def touches(p: Any) -> Any:
    """The load at which it comes to the drum."""
    return p["k"] * p["d"] * (1 + (p["s"] - p["s_0"]) ** 2) / (p["b"] * p["l"])


@pytest.mark.thorough
def test_jump_values_and_their_slopes_at_border_folds() -> None:
    given = drawn(np.random.default_rng(1), 20)
    p = shoe().Parameters(**given)
    slopes = ss.jump_gradient(p, "P", begin=-0.1, until=1.0)
    expected = np.where(given["mu0"] > locks(given), touches(given), np.nan)
    assert 5 < np.isnan(expected).sum() < 15
    np.testing.assert_allclose(slopes.value, expected, rtol=1e-12)
    np.testing.assert_array_equal(ss.jump_value(p, "P", begin=-0.1, until=1.0), slopes.value)
    for name in ("k", "d", "b", "l", "s", "mu0", "c", "F"):
        h = 1e-6
        more, less = (
            touches(given | {name: given[name] + step}) if name in touched else expected
            for step in (h, -h)
            for touched in (("k", "d", "b", "l", "s"),)
        )
        by_name = np.where(np.isnan(expected), np.nan, (more - less) / (2 * h))
        np.testing.assert_allclose(slopes[name], by_name, rtol=1e-8, atol=1e-9)


@pytest.mark.thorough
def test_points_of_which_it_is_told_whether_they_have_jumped() -> None:
    """The shoe's state passes or ends at the border, that of the pad passes the one of its rear
    leg and goes on.
    """
    rng = np.random.default_rng(2)
    given = drawn(rng, 40)
    P = touches(given) * rng.uniform(0.5, 1.5, 40)
    ended = limit_point_passed(shoe().Parameters(**given, P=P), "P", -0.1)
    expected = (given["mu0"] > locks(given)) & (touches(given) < P)
    assert 5 < expected.sum() < 35
    np.testing.assert_array_equal(ended, expected)
    mu0, h, k_t = (rng.uniform(*ends, 40) for ends in ((0.5, 3.0), (0.3, 1.5), (0.05, 1.0)))
    passes = mu0 > (2 + k_t) / (2 * h)
    assert 5 < passes.sum() < 35
    pad = model_of(PAD, "pad_on_2").Parameters(mu0=mu0, h=h, k_t=k_t)
    np.testing.assert_array_equal(limit_point_passed(pad, "mu0"), 0.0)
    # Without the torsion spring nothing goes on.
    pad = pad.replace(k_t=0.0)
    np.testing.assert_array_equal(limit_point_passed(pad, "mu0"), mu0 > 1 / h)


def a_margin(given: Any, P: float) -> tuple[Any, float]:
    """The margin of one set that locks in its load and in the wear, and its distance by hand."""
    p, scale = shoe().Parameters(**given, P=P), {"P": 0.01, "d": 0.01}
    found = ss.jump_margin(p, scale, vary="P", begin=-0.1, options=FEW)
    by_d = touches(given) / given["d"] * scale["d"]
    return found, (touches(given) - P) / np.hypot(scale["P"], by_d)


@pytest.mark.thorough
def test_the_nearest_design_that_jumps_is_on_the_border() -> None:
    given = GIVEN | {"mu0": 1.5}
    found, distance = a_margin(given, 0.005)
    np.testing.assert_allclose(found.distance, distance, rtol=1e-9)
    changed = given | {"d": float(found.parameters.d)}
    np.testing.assert_allclose(found.parameters.P, touches(changed), rtol=1e-9)
    keeps = ss.redesign(
        shoe().Parameters(**given), {"d": 0.01}, {"P": 0.02}, begin=-0.1, options=FEW
    )
    # Moved outward until it is verified.
    np.testing.assert_allclose(keeps.jump["P"], 0.02, rtol=1e-7)
    jumps = touches(given | {"d": float(keeps.parameters.d)})
    np.testing.assert_allclose(keeps.jump["P"], jumps, rtol=1e-12)


@pytest.mark.thorough
def test_the_share_that_jumps_is_that_of_what_locks_and_touches() -> None:
    asked = {**GIVEN, "P": (0.01, 0.02), "mu0": (1.0, 1.5)}
    # Without indices the points are proved by parts of the box, where these tell them.
    found = ss.jump_probability(
        asked, model=shoe(), vary="P", begin=-0.1, n=8192, rng=1, sobol=False, max_boxes=50
    )
    exact = (0.02 - touches(GIVEN)) / 0.01 * (1.5 - locks(GIVEN)) / 0.5
    assert found.low < exact < found.high
    assert found.high - found.low < 0.003
    assert found.proved is not None
    assert found.proved[0] <= exact <= found.proved[1] < 0.6  # no state comes to the border there


#: A shoe that locks: where it is pulled a little it is off the drum, or jammed on the stop.
JAMMED = {"b": 0.6, "c": 1.0, "k": 0.2, "l": 1.0, "g": 0.1}
PULLED = -0.0215


def jammed(mu0: Any) -> Any:
    """Angle at which the shoe that is pulled is jammed."""
    b, c, k, l, g = JAMMED.values()
    return (PULLED * l + g) / (1 + k + b**2 - mu0 * b * c)


def is_off(mu0: Any) -> Any:
    """Whether the shoe that is pulled strains its springs less off the drum, by what touches at
    the origin, where the stop has its play.
    """
    return abs(PULLED * JAMMED["l"] / JAMMED["k"]) < jammed(mu0)


@pytest.mark.thorough
def test_the_state_of_a_part_is_not_taken_for_that_of_another_combination() -> None:
    """In the middle of the box it is jammed, which it stays when the load rises; where it is off
    the drum it ends as it touches.
    """
    low = model_of(JAMMING, "jamming_shoe").Parameters(**JAMMED, mu0=1.3, P=-0.0005)
    box = Splitting(low, low.replace(mu0=1.42, P=0.001), "P", PULLED)
    assert box.balance.touching == "leading, trailing, stop"
    mu0 = np.linspace(1.3, 1.42, 40)
    off = is_off(mu0)
    assert 5 < off.sum() < 20
    found = proved_jumps(box, lambda pieces: pieces.volume * (pieces.top > pieces.safe), 16)
    # Nothing is told of points whose own state is off the drum.
    told = found.ended(low.replace(mu0=mu0, P=0.0005))
    np.testing.assert_array_equal(told, np.where(off, np.nan, 0.0))
    np.testing.assert_array_equal(
        limit_point_passed(low.replace(mu0=mu0, P=0.0005), "P", PULLED), off
    )


def test_a_tube_is_of_the_state_that_was_given() -> None:
    """Newton's method of one combination comes from a state of another one to a state of its own,
    which is not the one that was given.
    """
    p = model_of(JAMMING, "jamming_shoe").Parameters(**JAMMED, mu0=1.3, P=PULLED)
    balance = {one.touching: one for one in balances_of(p.model)}["leading, trailing, stop"]
    fixed = np.array([[float(p[name])] for name in balance.parameters])
    tubes = Tubes.of_points(balance, "P", fixed)
    psi = p.F * p.l / (p.b**2 + p.mu0 * p.b * p.c)
    off, on = (np.array([[phi], [psi], [PULLED]]) for phi in (PULLED * p.l / p.k, jammed(p.mu0)))
    assert tubes.place(on, error=1e-14).proved.all()
    came = tubes.place(off)
    assert came.proved.all()
    np.testing.assert_allclose(came.z, on, rtol=1e-13)
    assert not tubes.place(off, error=1e-14).proved.any()
    assert not tubes.place(on, error=0.1).proved.any()  # so little of it is known


@pytest.mark.thorough
def test_a_box_is_proved_below_the_border_and_refuted_where_states_end_there() -> None:
    """Where the shoe locks; where it does not its state passes, of which nothing is told."""
    locking = locks(GIVEN) * 1.01

    def outcome(mu0: float, P: float) -> Any:
        low = shoe().Parameters(**GIVEN, mu0=mu0, P=0.01)
        high = low.replace(P=P, mu0=mu0 * 1.01)
        return ss.certify(low, between=box_of(low, high), vary="P", begin=-0.1, max_boxes=50)

    least = touches(GIVEN)
    assert outcome(locking, least * 0.99).outcome == "proved"
    found = outcome(locking, least * 1.01)
    assert found.outcome == "refuted"
    ended = found.counterexample
    assert (ended.P > least, ended.mu0 > locks(GIVEN)) == (True, True)
    assert outcome(locking / 1.03, least * 1.01).outcome == "undecided"
    # Too near to tell, or seen to be beyond.
    assert outcome(locking, least * (1 - 1e-15)).outcome in ("undecided", "proved")
    assert outcome(locking, least * (1 + 1e-15)).outcome in ("undecided", "refuted")


@pytest.mark.parametrize(("mu0", "outcome"), [(0.3, "proved"), (1.5, "refuted")])
def test_states_of_all_combinations_are_counted(mu0: float, outcome: str) -> None:
    low = shoe().Parameters(**GIVEN, mu0=mu0, P=0.01)
    assert (int(ss.equilibria(low).count) == 1) == (outcome == "proved")
    assert (
        ss.certify(
            low, "one equilibrium", between={"mu0": (mu0, mu0 + 0.01)}, max_boxes=100
        ).outcome
        == outcome
    )


@pytest.mark.thorough
def test_border_folds_are_curves_of_the_bifurcation_set() -> None:
    """As far as the leading shoe locks; where it does not the state passes."""
    p = shoe().Parameters(**GIVEN, mu0=1.5)
    plane = {"s": (0.0, 1.0), "P": (-0.1, 0.2)}
    found = ss.bifurcation_set(p, ("s", "P"), 10, between=plane)
    (curve,) = found.curves
    assert found.complete
    assert (curve["s"].min(), curve["s"].max()) == (0.0, 1.0)
    np.testing.assert_allclose(curve["P"], touches(GIVEN | {"s": curve["s"]}), rtol=1e-12)
    assert {*curve["touching"]} == {"leading, trailing"}
    assert {*curve["at_border"]} == {"leading"}
    assert not ss.bifurcation_set(p.replace(mu0=1.0), ("s", "P"), 10, between=plane).curves
    near = {"b": (0.9, 1.3), "P": (-0.1, 0.2)}
    (curve,) = ss.bifurcation_set(p.replace(s=0.3), ("b", "P"), 20, between=near).curves
    last = max(np.roots([1.0, -1.5 * 0.9, 0.3]))
    assert last - 0.04 < curve["b"].max() <= last


def a_lowest_end(given: Any) -> Any:
    """The least load at which the shoe jumps at any place of the drum."""
    p = shoe().Parameters(**given)
    return ss.critical_friction(p, "P", "s", between={"s": (0.0, 1.0), "P": (-0.1, 1.0)})


@pytest.mark.thorough
def test_the_lowest_end_is_at_the_place_of_least_wear() -> None:
    given = GIVEN | {"mu0": 1.5}
    found = a_lowest_end(given)
    assert (found.kind, found.complete) == ("border", True)
    np.testing.assert_allclose([found.P, found.s], [touches(given | {"s": 0.3}), 0.3], rtol=1e-12)
    assert a_lowest_end(given | {"mu0": 1.0}).P == np.inf  # it does not lock


@pytest.mark.validate
def test_margins_and_lowest_ends_of_random_sets() -> None:
    rng, many = np.random.default_rng(3), drawn(np.random.default_rng(4), 40)
    tried = 0
    for row in range(40):
        given = {name: float(values[row]) for name, values in many.items()}
        if given["mu0"] < locks(given) or tried == 20:
            continue
        tried += 1
        found, distance = a_margin(given, touches(given) * rng.uniform(0.2, 0.9))
        np.testing.assert_allclose(found.distance, distance, rtol=1e-9)
        lowest = a_lowest_end(given)
        at_least = touches(given | {"s": given["s_0"]})
        assert (lowest.kind, lowest.complete) == ("border", True)
        np.testing.assert_allclose([lowest.P, lowest.s], [at_least, given["s_0"]], rtol=1e-12)
    assert tried == 20


@pytest.mark.thorough
def test_the_wear_at_which_the_lowest_end_is_a_load() -> None:
    p = shoe().Parameters(mu0=1.5, P=0.02)
    ranges = {"s": (0.0, 1.0), "P": (-0.1, 1.0), "d": (0.04, 0.1)}
    wear = ss.critical_value(p, "d", along="P", over="s", between=ranges)
    np.testing.assert_allclose(wear, p.P * p.b * p.l / p.k, rtol=1e-12)
