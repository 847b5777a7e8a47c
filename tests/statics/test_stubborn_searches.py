"""Searches that take long, or that meet a place or a value at which nothing is told."""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.stubborn_pages import hardening, pendulum, polar

pytest.importorskip("sympy")


@pytest.mark.thorough
def test_the_state_on_a_hardening_spring_is_found_and_proved_to_be_all() -> None:
    """Balance by hand: σ_3 e³ and the springs of the article, at k_3 = 0.5."""
    p = hardening().Parameters(theta0=np.pi / 3, k_3=0.5)
    eq = ss.equilibria(p)
    assert eq.complete
    assert eq.count == 1
    q = np.array([eq.x[0], eq.y[0]])
    total = np.array([0.007 * q[0] + 0.5 * q[1], 0.007 + q[1]])
    for angle, linear, cubic in ((np.pi / 3, 0.1, 0.0), (2.0, 0.05, 0.5)):
        to = np.array([np.cos(angle), np.sin(angle)]) - q
        e = np.hypot(*to) - 1
        total -= (linear * e + cubic * e**3) * to / (e + 1)
    assert total == pytest.approx(0.0, abs=1e-12)


@pytest.mark.thorough
def test_the_cube_of_an_elongation_is_not_multiplied_out() -> None:
    """Its sums of large terms that cancel left the box undecided after 12 s."""
    given = {"theta0": 2.0053, "mu0": 0.2551, "alpha": 0.0708, "sigma": 0.0332, "theta0_2": 0.3598}
    given |= {"sigma_2": 0.1305, "lambda_2": 1.7335, "k_3": 0.6628}
    eq = ss.equilibria(hardening().Parameters(**given), options=ss.SearchOptions(seconds=1.0))
    assert eq.complete
    assert eq.count == 3


@pytest.mark.thorough
def test_all_states_of_two_rods_and_what_newton_finds_where_time_is_short() -> None:
    """No angle repeats, since springs hold both joints."""
    p = pendulum().Parameters()
    eq = ss.equilibria(p)
    assert eq.complete
    assert eq.count == 13
    short = ss.equilibria(p, options=ss.SearchOptions(seconds=0.01, pieces=1))
    assert not short.complete
    assert 1 <= short.count < 13
    assert any("not proved to be all" in one for one in short.remarks)
    assert all(np.abs(eq.a - a).min() < 1e-9 for a in short.a[: short.count])


def test_a_singular_place_costs_that_place() -> None:
    """In the middle r² is 0; the state beside it is told."""
    eq = ss.equilibria(polar().Parameters(), contact=False)
    assert eq.complete
    assert (eq.r == 0).tolist() == [False, True, True]
    assert np.isfinite(eq.growth).tolist() == [True, False, False]
    assert eq.stability.tolist() == ["stable", "", ""]
    assert "r = 0" in eq.remarks[0]


@pytest.mark.parametrize(("name", "value"), [("two_blocks", "nu"), ("pad_on_legs", "tau")])
def test_values_at_which_floats_end_are_named(name: str, value: str) -> None:
    extreme = {"nu": 1e-308, "tau": 1.7e308}[value]
    eq = ss.equilibria(ss.load(name).Parameters(**{value: extreme}))
    assert not np.isfinite(eq.growth[0])
    assert any(f"{value} = {extreme:g}" in one for one in eq.remarks)
    assert f"{value} = {extreme:g}" in str(eq)
