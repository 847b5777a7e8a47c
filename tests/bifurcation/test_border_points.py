"""Border points of several contacts, where one of them only just touches, against closed forms."""

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from spragsym.bifurcation.borders import borders
from spragsym.bifurcation.crossings import border_arrivals
from spragsym.bifurcation.defining_systems import Family, given_column
from spragsym.bifurcation.tubes import Tubes
from spragsym.statics import regions
from spragsym.statics.search import balances_of
from tests.oracles.contact_pages import BLOCKS, HEAD, JAMMING, PAD, SPRUNG, balanced, pad
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


@pytest.mark.thorough
def test_the_rear_leg_lifts_where_the_closed_form_says_and_the_state_passes() -> None:
    model = model_of(PAD, "pad_on_2")
    rng = np.random.default_rng(11)
    for k_t, h in zip(rng.uniform(0.05, 1.0, 3), rng.uniform(0.2, 1.5, 3), strict=True):
        lifts = (2 + k_t) / (2 * h)
        p = model.Parameters(k_t=k_t, h=h)
        found = ss.folds(p, vary="mu0", between={"mu0": (0.0, 2 * lifts)})
        assert found.complete
        assert found.kind.tolist() == ["passes"]
        assert found["touching"].tolist() == ["front, rear"]
        assert found["at_border"].tolist() == ["rear"]
        np.testing.assert_allclose(found.mu0, lifts, rtol=1e-12)
        np.testing.assert_allclose(found.y, -p.F / 2, rtol=1e-12)


@pytest.mark.thorough
@pytest.mark.parametrize("begin", [0.5, 0.999])
def test_a_crossing_is_proved_from_states_far_before_the_border_and_close_to_it(
    begin: float,
) -> None:
    """The rear leg lifts between the state and its goal, at the closed form's value."""
    p = model_of(PAD, "pad_on_2").Parameters(k_t=0.3, h=0.8)
    lifts = (2 + 0.3) / (2 * 0.8)
    before = p.replace(mu0=begin * lifts)
    state = ss.equilibria(before)
    (balance,) = [it for it in balances_of(p.model) if all(it.indicators)]
    tubes = Tubes.of_points(balance, "mu0", given_column(before, balance.parameters, ("mu0",)))
    q = [state[name].item() for name in p.model.coordinates]
    here = tubes.place(np.array([*q, before.mu0])[:, None], error=1e-14)
    (part,) = border_arrivals(tubes, here, np.array([1.5 * lifts]))
    assert part.kind == "passes"
    assert part.z[-1, 0] == pytest.approx(lifts, rel=1e-12)
    assert not list(border_arrivals(tubes, here, np.array([0.9995 * lifts])))


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
    for b, c, k in rng.uniform(0.4, 1.0, (2, 3)).tolist():
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


@pytest.mark.thorough
def test_a_path_passes_where_contacts_are_lost_and_regained() -> None:
    names = "front", "rear"
    p = model_of(PAD, "pad_on_2").Parameters()
    values = np.array([0.5, 1.2, 2.5])
    path = ss.quasi_static_path(p, "mu0", values)
    assert not path.jumps
    base = {name: float(p[name]) for name in p.model.parameters}
    touched = set[str]()
    for row, mu0 in enumerate(values.tolist()):
        ((touching, q),) = balanced(*pad(base | {"mu0": mu0}, names))
        np.testing.assert_allclose([path[name][row] for name in "xy"], q[:2], rtol=0, atol=1e-12)
        assert path["touching"][row] == ", ".join(touching)
        touched.add(path["touching"][row])
    assert touched == {"front", "front, rear"}


@pytest.mark.thorough
def test_a_shoe_jams_and_comes_free_at_border_folds() -> None:
    p = model_of(JAMMING, "jamming_shoe").Parameters(b=0.7, c=0.9, k=0.3, l=1.5, g=0.1, mu0=1.5)
    K = float(p.k + p.b**2 - p.mu0 * p.b * p.c)  # of the shoe on the drum: it locks
    free = K * float(p.g / p.l)
    assert K < 0
    up = ss.quasi_static_path(p, "P", [-0.04, -0.02, -0.005, 0.02, 0.04])
    down = ss.quasi_static_path(p, "P", [0.04, 0.02, -0.005, -0.02, -0.04])
    for path, value in ((up, 0.0), (down, free)):
        (jump,) = path.jumps
        assert jump.kind == "border_fold"
        assert abs(jump.value - value) <= 1e-12
    on_stop = (up.values * p.l + p.g) / (K + 1)
    off_drum = up.values * p.l / p.k
    np.testing.assert_allclose(up.phi, np.where(up.values > 0, on_stop, off_drum), atol=1e-12)
    jams = down.values > free
    on_stop, off_drum = on_stop[::-1], off_drum[::-1]
    np.testing.assert_allclose(down.phi, np.where(jams, on_stop, off_drum), atol=1e-12)
    assert abs(ss.jump_value(p, "P", begin=-0.04, until=0.04)) <= 1e-12
    there = ss.jump_value(p, "P", direction="down", begin=0.04, until=-0.04)
    assert abs(there - free) <= 1e-12


@pytest.mark.validate
def test_onsets_of_flutter_are_those_of_every_combination() -> None:
    model, M = model_of(PAD, "pad_on_2"), np.diag([1.0, 1.0, 0.3])
    names = "front", "rear"
    p = model.Parameters(k_t=0.0905, h=0.764, k_x=1.315)
    base = {name: float(p[name]) for name in model.parameters}

    def stiffness(mu0: float, touching: tuple[str, ...]) -> np.ndarray:
        K, _, legs = pad(base | {"mu0": mu0}, names)
        for leg in legs:
            if leg.name in touching:
                K += np.outer(np.array(leg.g) + leg.mu * np.array(leg.s), leg.g)
        return np.linalg.solve(M, K)

    def discriminant(mu0: float, touching: tuple[str, ...]) -> float:
        one, two, three = np.linalg.eigvals(stiffness(mu0, touching)).astype(complex)
        return float((((one - two) * (two - three) * (three - one)) ** 2).real)

    expected = []
    for touching in (("front", "rear"), ("front",)):
        grid = np.linspace(0.0, 3.0, 400)
        signs = np.sign([discriminant(mu, touching) for mu in grid])
        for step in np.flatnonzero(signs[1:] != signs[:-1]):
            at = brentq(discriminant, grid[step], grid[step + 1], args=(touching,), xtol=1e-13)
            known = dict(balanced(*pad(base | {"mu0": at}, names)))
            squares = np.linalg.eigvals(stiffness(at, touching))
            if touching in known and (squares.real > 0).all():
                expected.append((at, ", ".join(touching)))
    found = ss.flutter_onsets(p, "mu0", damping=False, between={"mu0": (0.0, 3.0)})
    assert found.decided
    assert len(expected) >= 1
    assert found["touching"].tolist() == [touching for _, touching in sorted(expected)]
    np.testing.assert_allclose(found.mu0, [at for at, _ in sorted(expected)], rtol=1e-9)
    assert found.criticality.tolist() == ["undecided"] * len(expected)


@pytest.mark.thorough
def test_a_path_of_contacts_that_never_open_says_that_all_touch() -> None:
    p = model_of(BLOCKS, "blocks").Parameters()
    path = ss.quasi_static_path(p, "mu_k", np.linspace(0.1, 0.4, 3))
    assert path["touching"].tolist() == ["first, second"] * 3
    assert path.growth.shape == (3,)
    K = np.array([[1 + p.kappa, -p.kappa], [-p.kappa, p.beta + p.kappa]])
    for value, *place in zip(path.values, path["x_1"], path["x_2"], strict=True):
        expected = np.linalg.solve(K, value * np.array([p.N_1, p.N_2]))
        assert place == pytest.approx(expected.tolist(), rel=1e-12)


STOP = '''r"""A mass on a belt that comes to a stop."""
from spragsym.derive.model import Page, tanh
page = Page("A mass on a belt before a stop.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
a = page.unit("a", "m", "gap of the stop")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.4)
k_s = page.parameter("k_s", "N/m", "stiffness of the stop", "> 0", 2.0)
P = page.parameter("P", "N", "load", "> 0", 0.5)
V = page.parameter("V", "m/s", "speed", ">= 0", 0.5)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.force(-P, along=y)
disc = page.contact(y, lambda depth: k * depth, name="disc")
page.contact(a - x, lambda depth: k_s * depth, name="stop")
page.friction(x, V, lambda v: mu * tanh(v * (m / k) ** (1 / 2) / a), at_rest=mu, on=disc)
'''


@pytest.mark.thorough
def test_the_stiffness_of_a_stop_does_not_move_where_it_is_touched() -> None:
    """At μ P = k a for every k_s: no point of that line is one at which it turns back."""
    p = model_of(STOP, "before_a_stop").Parameters()
    found = ss.bifurcation_set(p, ("k_s", "mu"), 4, between={"k_s": (1.0, 3.0), "mu": (1.0, 3.0)})
    assert (found.complete, len(found)) == (True, 0)
    passes = ss.folds(p, "mu", between={"mu": (1.0, 3.0)})
    assert (passes.kind.tolist(), passes["mu"][0]) == (["passes"], pytest.approx(2.0, rel=1e-12))


#: Three masses, tied to one another, that the same load pushes to stops of their own; a fourth one
#: stays on its seat.
AT_ONCE = '''r"""A page of the tests."""
from spragsym.derive.model import Page
page = Page("Masses that come to their stops at once.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
a = page.unit("a", "m", "length")
P = page.parameter("P", "N", "load", "real", 0.3)
t = page.parameter("t", "N/m", "ties", ">= 0", 0.2)
g = page.parameter("g", "m", "gap of the stops", ">= 0", 0.1)
x, y, z, w = (page.coordinate(name, "m", f"of the mass {name}") for name in "xyzw")
page.kinetic(m * sum(page.rate(one)**2 for one in (x, y, z, w)) / 2)
page.force(-k * a, along=w)
page.contact(w, lambda depth: k * depth, name="seat")
for number, (one, other) in enumerate(((x, y), (y, z), (z, x)), 1):
    page.spring(k, along=one)
    page.spring(t, along=one - other)
    page.force(P, along=one)
    page.contact(g - one, lambda depth, number=number: number * k * depth, name=f"stop_{one}")
'''


@pytest.mark.thorough
def test_three_stops_that_are_met_at_once_are_one_point() -> None:
    """At P = k g, inside of the range and at either end of it."""
    stops, g = "stop_x, stop_y, stop_z", 0.237
    p = model_of(AT_ONCE, "stops_at_once").Parameters(g=g)
    for ends in ((0.2, 0.3), (g, 0.3), (0.2, g)):
        found = ss.folds(p, "P", between={"P": ends})
        assert found.complete
        assert (found.kind.tolist(), found.at_border.tolist()) == (["passes"], [stops])
        assert found.touching.tolist() == [f"seat, {stops}"]
        np.testing.assert_allclose([found.P, found.x, found.y, found.z], g, rtol=1e-12)
    assert math.isnan(ss.jump_value(p, "P", direction="down", until=-0.1))


#: Two equal shoes, coupled to one another, that friction presses onto the drum, and a mass on its
#: seat.
BOTH_LOCK = (
    HEAD
    + """
P = page.parameter("P", "N", "load of each shoe", "real", 0.0)
k = page.parameter("k", "N m", "spring of each", "> 0", 0.3)
t = page.parameter("t", "N m", "between them", ">= 0", 0.1)
b = page.parameter("b", "m", "arm of the normal force", "> 0", 0.7)
c = page.parameter("c", "m", "arm of friction", "> 0", 0.9)
phi = page.coordinate("phi", "rad", "turning of one shoe")
psi = page.coordinate("psi", "rad", "turning of the other one")
w = page.coordinate("w", "m", "of the mass")
page.kinetic(m * a**2 * (page.rate(phi)**2 + page.rate(psi)**2) / 2 + m * page.rate(w)**2 / 2)
page.spring(t, along=phi - psi)
page.force(-k_c * a, along=w)
page.contact(w, lambda depth: k_c * depth, name="seat")
for name, shoe in (("one", phi), ("other", psi)):
    page.spring(k, along=shoe)
    page.force(P * a, along=shoe)
    page.friction(
        c * shoe, V, law, at_rest=mu0, on=page.contact(-b * shoe, lambda depth: k_c * depth, name=name)
    )
"""
)


@pytest.mark.thorough
def test_two_shoes_that_lock_at_once_end_and_those_that_do_not_pass() -> None:
    """K = k + b² − μ b c of a shoe on the drum. Where it is negative and softer than the tie, both
    lock together, and no state of one shoe alone is beside them.
    """
    model = model_of(BOTH_LOCK, "both_lock")
    locks = (0.3 + 0.49) / 0.63
    for mu, t, states in ((0.9 * locks, 0.1, (1, 1)), (1.1 * locks, 0.01, (4, 0))):
        p = model.Parameters(mu0=mu, t=t)
        found = ss.folds(p, "P", between={"P": (-1.0, 1.0)})
        assert found.complete
        assert tuple(int(ss.count(p.replace(P=P))) for P in (-0.01, 0.01)) == states
        assert (found.at_border.tolist(), abs(found.P[0]) <= 1e-12) == (["one, other"], True)
        if states == (1, 1):
            assert found.kind.tolist() == ["passes"]
            for along in (np.array([-0.1, -0.02, 0.05]), np.array([0.05, -0.02, -0.1])):
                path = ss.quasi_static_path(p, "P", along)
                assert not path.jumps
                K = 0.3 + np.where(along > 0, 0.49 - mu * 0.63, 0.0)
                np.testing.assert_allclose([path.phi, path.psi], [along / K] * 2, rtol=1e-12)
        else:
            assert found.kind.tolist() == ["border_fold"]
            assert (found.ends[0], found.when[0]) == ("lower", "up")
            assert abs(ss.jump_value(p, "P", begin=-0.1, until=0.1)) <= 1e-12


@pytest.mark.thorough
def test_two_borders_near_to_one_another_are_two() -> None:
    """A shoe with next to no play jams at P = 0, and comes free just below it."""
    p = model_of(JAMMING, "jamming_shoe").Parameters(b=0.7, c=0.9, k=0.3, l=1.5, g=1e-4, mu0=1.5)
    K = float(p.k + p.b**2 - p.mu0 * p.b * p.c)
    up = ss.jump_value(p, "P", begin=-0.04, until=0.04)
    down = ss.jump_value(p, "P", direction="down", begin=0.04, until=-0.04)
    assert abs(up) <= 1e-12
    assert down == pytest.approx(K * 1e-4 / 1.5, rel=1e-9)


SELF_ENERGIZING = '''r"""A wedge brake."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A pad between the inclined face of a caliper and a disc.")
m, k_d = page.unit("m", "kg", "mass"), page.unit("k_d", "N/m", "stiffness of the disc")
L = page.unit("L", "m", "length")
a = page.parameter("a", "rad", "inclination of the face", "(0, pi/2)", 0.5)
mu = page.parameter("mu", "1", "friction of the disc", ">= 0", 0.35)
k_f = page.parameter("k_f", "N/m", "stiffness of the caliper", "> 0", 2.0, becomes="phi")
k_a = page.parameter("k_a", "N/m", "spring of the pad", ">= 0", 0.05, becomes="rho")
F = page.parameter("F", "N", "force of the actuator", ">= 0", 0.02)
g = page.parameter("g", "m", "gap", ">= 0", 0.05)
V = page.parameter("V", "m/s", "speed of the disc", "> 0", 0.5)
x = page.coordinate("x", "m", "along the disc")
y = page.coordinate("y", "m", "towards the disc")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.force(F, along=x)
page.spring(k_a, along=x)
disc = page.contact(g - y, lambda depth: k_d * depth, name="disc")
page.contact(y * cos(a) - x * sin(a), lambda depth: k_f * depth, name="face")
page.friction(x, V, lambda v: mu * tanh(10 * v / V), at_rest=mu, on=disc)
'''


@pytest.mark.thorough
def test_states_at_a_border_are_bounded_by_the_open_contact(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """States of the closed pad run to infinity at mu = tan a + rho (1/phi + cos² a)/(sin a cos a);
    where a contact just touches x = F/rho, which no search by pieces of mu has to find.
    """

    def pieces(*_: Any) -> Any:
        raise AssertionError("searched in pieces")

    monkeypatch.setattr(regions, "_in_pieces", pieces)
    p = model_of(SELF_ENERGIZING, "wedge_brake").Parameters()
    found = borders(Family.every(p, ("mu",)))
    assert all(points.complete or points.endless for points in found)
    assert not any(map(len, found))
    monkeypatch.undo()
    sine, cosine = math.sin(0.5), math.cos(0.5)
    end = (sine + 0.05 * (0.5 + cosine**2) / sine) / cosine
    assert ss.jump_value(p, "mu") == pytest.approx(end, rel=1e-12)
