"""Lowest ends of a followed state of any model, against closed forms; and which state at one stop
is which at the next.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import spragsym as ss
from spragsym.bifurcation import critical
from spragsym.bifurcation.branches import Along, _by_tubes, _states, linked
from spragsym.bifurcation.critical import carried
from spragsym.bifurcation.paths import first_end
from spragsym.bifurcation.tubes import Tubes
from spragsym.statics.balance import Balance
from tests.oracles.user_pages import model_of

SEARCH = ss.load("kang_nam").search
#: A set whose lowest fold lies 1 % below the cusp that its curve leaves.
TURN = {"kappa": 0.02, "alpha": 0.5, "sigma": 2.0, "beta": 0.0}


@pytest.mark.validate
@pytest.mark.parametrize("name", ["inclined_belt", "cubic_contact", "two_springs"])
def test_no_state_ends_below_it(name: str) -> None:
    """Followed one by one over a grid; beside it one ends hardly above it."""
    model = ss.load(name)
    found = ss.critical_friction(model.Parameters(), between={"mu0": (0.0, 0.5)})
    assert found.complete
    for theta0 in np.radians([20.0, 50.0, 64.0, 80.0, 120.0]):
        end = first_end(model.Parameters(theta0=theta0), "mu0", (0.0, 0.5))
        assert end is None or end.value >= found.value
    if found.kind == "cusp":
        ends = [
            first_end(model.Parameters(theta0=found.where + side), "mu0", (0.0, 0.5))
            for side in (-0.02, 0.02)
        ]
        values = [end.value for end in ends if end is not None]
        assert values
        assert found.value < min(values) < found.value + 0.01
    else:
        assert (found.kind, math.isinf(found.value)) == ("", True)


@pytest.mark.thorough
def test_over_a_range_without_its_cusp_the_end_is_lowest() -> None:
    """Where folds rise with theta0 from the lower end of the range on."""
    p = SEARCH.Parameters()
    between = {"mu0": (0.0, 1.0), "theta0": (math.radians(30.0), math.radians(55.0))}
    found = ss.critical_friction(p, between=between)
    ends = [ss.jump_value(ss.Parameters.article(theta0=end)) for end in between["theta0"]]
    assert (found.kind, found.complete) == ("end", True)
    assert found.value == pytest.approx(min(ends), rel=1e-12)


@pytest.mark.thorough
def test_a_tube_holds_one_state() -> None:
    """It arrives where the equilibrium is, and never goes through a fold."""
    p = SEARCH.Parameters(theta0=math.radians(49.0))
    balance = Balance(SEARCH, contact=True)
    eq = ss.equilibria(ss.Parameters.article(theta0=math.radians(49.0), mu0=np.array([0.0, 0.42])))
    start, there = (np.array([eq.x[k, 0], eq.y[k, 0]]) for k in (0, 1))
    way = carried(balance, p, "mu0", np.array([0.0, 0.42]), start, eq.error[0, 0])
    assert way[:, 1] == pytest.approx(there, abs=1e-12)
    fold = float(ss.jump_value(ss.Parameters.article(theta0=math.radians(49.0))))
    with pytest.raises(ss.errors.ConvergenceError, match="followed"):
        carried(balance, p, "mu0", np.array([0.0, fold + 0.01]), start, eq.error[0, 0])


@pytest.mark.thorough
@pytest.mark.parametrize(
    "given", [{}, pytest.param(TURN, marks=pytest.mark.thorough)], ids=["article", "turn"]
)
def test_the_lowest_cusp_is_that_of_the_closed_form(given: dict[str, float]) -> None:
    p = ss.Parameters.article(**given)
    assert ss.cusp_friction(p, method="search") == pytest.approx(ss.cusp_friction(p), rel=1e-12)
    assert ss.cusp_friction(p, between={"mu0": (0.0, 0.1)}, method="search") == math.inf


@pytest.mark.thorough
def test_an_angle_after_a_turn_is_the_same_state() -> None:
    """States are listed within one turn, and a state that is followed may leave it."""
    rod = ss.load("sprag_rod")
    stops, nothing = np.array([0.5, 0.6]), np.empty(0)
    p = rod.Parameters(theta0=0.5)
    along = Along(
        Balance(rod, contact=True), p, "theta0", nothing, nothing.astype(str), np.empty((1, 0))
    )
    eq = ss.equilibria(p.replace(theta0=stops))
    begin, end = _states(along, eq).values()
    later = replace(end, q=end.q + 2 * np.pi)
    options = ss.ContinuationOptions()
    known, complete = _by_tubes(along, [(0.5, 0.6)], {0.5: begin, 0.6: later}, options)
    (pairs,) = known.values()
    assert complete == set(known)
    assert pairs == {slot: slot for slot in range(int(eq.count[0]))}
    assert len(pairs) == 3


@pytest.mark.thorough
def test_no_tube_is_followed_to_the_fold_at_which_it_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of three states before a fold one goes on; the pairs of a step without a fold need no tube to
    come near to one.
    """
    p = ss.load("cubic_contact").Parameters(theta0=0.7)
    turns = ss.folds(p, "mu0", between={"mu0": (0.3, 1.0)})
    (fold,) = turns["mu0"]
    stops = fold + np.array([-0.02, -1e-3, 1e-3])
    eq = ss.equilibria(p.replace(mu0=stops))
    assert eq.count.tolist() == [3, 3, 1]
    rounds, segment = list[int](), Tubes.segment

    def counted(tubes: Tubes, *given: Any) -> Any:
        rounds.append(tubes.half.shape[1])
        return segment(tubes, *given)

    monkeypatch.setattr(Tubes, "segment", counted)
    before, over = linked(p, "mu0", eq, turns, options=ss.ContinuationOptions(halvings=0))
    assert before == {0: 0, 1: 1, 2: 2}
    assert len(over) == 1
    assert len(rounds) <= 20


@pytest.mark.thorough
def test_signs_stand_for_tubes_only_where_they_are_sure(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where one of three tubes has arrived, signs tell the other two pairs, unless states may be
    missing or signs be those of rounding: then no tube is given up for them.
    """
    p = ss.load("cubic_contact").Parameters(theta0=0.7)
    turns = ss.folds(p, "mu0", between={"mu0": (0.3, 1.0)})
    (fold,) = turns["mu0"]
    eq = ss.equilibria(p.replace(mu0=fold + np.array([-0.02, -1e-3])))
    at = np.array([turns[name] for name in p.model.coordinates])
    along = Along(Balance(p.model, contact=True), p, "mu0", turns["mu0"], turns.kind, at, True)
    states, asked = _states(along, eq), list[bool]()
    step = tuple(states)
    followed = Tubes.followed

    def watched(tubes: Tubes, start: Any, goal: Any, needless: Any) -> Any:
        end = followed(tubes, start, goal)
        one = start[np.arange(3)]
        one.scatter(np.array([2]), end[np.array([2])])
        asked.append(bool(needless(one).any()))
        return end

    monkeypatch.setattr(Tubes, "followed", watched)
    unsure = {stop: replace(one, proved=~one.proved) for stop, one in states.items()}
    for way, known in ((along, states), (replace(along, whole=False), states), (along, unsure)):
        _by_tubes(way, [step], known, ss.ContinuationOptions())
    assert all(one.proved.all() for one in states.values())
    assert asked == [True, False, False]


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["trolley", "pad_on_disc"])
def test_the_cusp_of_three_coordinates_is_found_in_the_whole_plane(name: str) -> None:
    """At smaller inclinations two folds lie beside each other over friction, at larger ones none."""
    p = ss.load(name).Parameters()
    (cusp,) = ss.cusps(p, ("theta0", "mu0"))
    friction = float(cusp["mu0"])
    for off, count in ((-1e-2, 2), (1e-2, 0)):
        beside = p.replace(theta0=float(cusp["theta0"]) + off, mu0=None)
        found = ss.folds(beside, "mu0", between={"mu0": (0.8 * friction, 1.2 * friction)})
        assert (len(found), found.complete) == (count, True)


@pytest.mark.thorough
def test_what_combinations_of_contacts_have_in_common_is_told_once() -> None:
    """A pad on two legs without a spring of tilting: on one leg its states are not bounded."""
    p = ss.load("pad_on_legs").Parameters(tau=0.0, mu0=None)
    found = ss.critical_friction(p, "mu0", "eta", between={"eta": (0.5, 1.5)})
    assert len(found.remarks) == len({*found.remarks}) > 1


DOOR = '''r"""A door on a closer spring, whose edge rubs on a latch, with a stop."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A door leaf on a closer spring; its edge rubs on a latch, and a stop limits it.")
m = page.unit("m", "kg", "mass of the leaf")
k_c = page.unit("k_c", "N/m", "stiffness of the latch")
L = page.unit("L", "m", "width of the leaf")
theta0 = page.parameter("theta0", "rad", "rest angle of the spring", "(0, pi/2)", 0.8)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
k_t = page.parameter("k_t", "N m", "closer spring", "> 0", 0.05, becomes="tau")
P = page.parameter("P", "N", "push", ">= 0", 0.01, becomes="push")
V = page.parameter("V", "m/s", "belt speed", "> 0", 0.5)
psi = page.coordinate("psi", "rad", "angle of the leaf")
page.kinetic(m * L**2 * page.rate(psi) ** 2 / 6)
page.potential(k_t * (psi - theta0) ** 2 / 2)
page.force(0, -P, at=(L * cos(psi), -L * sin(psi)))
latch = page.contact(3 * L / 5 - L * sin(psi), lambda depth: k_c * depth, name="latch")
stop = page.contact(19 * L / 20 - L * cos(psi), lambda depth: k_c * depth, name="stop")
page.friction(L * cos(psi), V, lambda v: mu0 * tanh(10 * v / V), at_rest=mu0, on=latch)
'''


@pytest.mark.validate
def test_a_state_is_followed_to_few_of_many_folds(monkeypatch: pytest.MonkeyPatch) -> None:
    """A leaf that the latch turns back never ends: N (cos psi + mu sin psi) balances the spring
    with ever smaller N; after each turn it might slip over the latch, which no state reaches.
    """
    p = model_of(DOOR, "door").Parameters()
    asked = list[tuple[float, float]]()

    def counted(p: Any, vary: str, span: tuple[float, float], **start: Any) -> Any:
        asked.append((float(p.theta0), span[1]))
        return first_end(p, vary, span, **start)

    monkeypatch.setattr(critical, "first_end", counted)
    found = ss.critical_friction(p, between={"theta0": (0.7, 1.5), "mu0": (0.0, 4.0)})
    assert (found.complete, found.value) == (True, math.inf)
    ends = sum(
        len(ss.folds(p.replace(theta0=at), "mu0", between={"mu0": (0.0, 4.0)})) for at in (0.7, 1.5)
    )
    assert ends >= 10
    assert len(asked) <= 8


@pytest.mark.thorough
def test_where_the_state_is_lost_over_the_range_is_said() -> None:
    """At the stop cos psi = 0.95 a spring with theta0 = psi − push cos psi / tau presses no more."""
    found = ss.critical_friction(model_of(DOOR, "door").Parameters())
    (remark,) = found.remarks
    at = math.acos(0.95) - 0.01 * 0.95 / 0.05
    assert f"it ends at theta0 = {at:.6g} rad, where a contact is lost" in remark


@pytest.mark.thorough
def test_how_far_the_state_was_followed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no border explains its end, which is that of the test before."""
    monkeypatch.setattr(critical, "border_arrivals", lambda *_: [])
    (remark,) = ss.critical_friction(model_of(DOOR, "door").Parameters()).remarks
    text, lost = remark.split(" rad: it is lost beyond theta0 = ")
    assert text.startswith("the state can't be followed from theta0 = ")
    at = math.acos(0.95) - 0.01 * 0.95 / 0.05
    assert float(lost.split(" rad")[0]) == pytest.approx(at, abs=0.02)


CONE = '''r"""A cone in a hole, with Hertz's law."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A cone that is pressed into a hole and drawn along, with Hertz's law.")
m, k_c = page.unit("m", "kg", "mass"), page.unit("k_c", "N/m", "stiffness")
L = page.unit("L", "m", "length")
theta0 = page.parameter("theta0", "rad", "half angle of the cone", "(0, pi/2)", 0.3)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.1)
P = page.parameter("P", "N", "push", "> 0", 0.01)
k_r = page.parameter("k_r", "N/m", "return spring", "> 0", 0.02, becomes="rho")
V = page.parameter("V", "m/s", "speed of the hole", "> 0", 0.5)
z = page.coordinate("z", "m", "depth of the cone")
page.kinetic(m * page.rate(z) ** 2 / 2)
page.spring(k_r, along=z)
page.force(P, along=z)
page.contact(-z * sin(theta0), lambda depth: k_c * L * (depth / L) ** (3 / 2))
page.friction(z * cos(theta0), V, lambda v: mu0 * tanh(10 * v / V), at_rest=mu0)
'''


@pytest.mark.thorough
@pytest.mark.parametrize("highest", [None, pytest.param(3.0, marks=pytest.mark.validate)])
def test_a_smaller_range_is_decided_where_the_whole_is_not(highest: float | None) -> None:
    """With N = (z sin a)^(3/2), rho z = P + N (mu cos a − sin a) has its fold at z = 3 P/rho, mu =
    tan a + 2 rho/(3 z^(1/2) sin(a)^(3/2) cos a), which runs to infinity as a goes to 0.
    """
    rise = 0.02 / (1.5 * math.sqrt(1.5))
    lowest = minimize_scalar(
        lambda a: math.tan(a) + rise / (math.sin(a) ** 1.5 * math.cos(a)), (0.1, 0.2, 0.3)
    )
    between = highest and {"mu0": (0.0, highest)}
    found = ss.critical_friction(model_of(CONE, "cone").Parameters(), between=between)
    assert found.kind == "turn"
    assert found.value == pytest.approx(lowest.fun, rel=1e-12)


@pytest.mark.validate
def test_of_an_undecided_lowest_end_the_known_one_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(critical, "_least_left", lambda *_: 0.1)
    between = {"mu0": (0.0, 1.0), "theta0": (0.1, 1.5)}
    found = ss.critical_friction(model_of(CONE, "cone").Parameters(), between=between)
    assert (found.kind, found.value) == ("undecided", 0.1)
    assert "it ends at the turn at mu0 = 0.327391, theta0 = 0.189331 rad" in found.remarks[-1]
