"""Options of algorithms: ranges of their fields, and what limits do to the answers of questions."""

import math
import re
from dataclasses import fields

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.defining_systems import given_column
from spragsym.bifurcation.tubes import Tubes
from spragsym.core.options import Options
from spragsym.statics.balance import Balance

RANGE, TYPE = ss.errors.ParameterError, ss.errors.ParameterTypeError
LEAVE = r"times.* leave it out"


def test_every_option_is_described():
    for kind in Options.__subclasses__():
        described = re.findall(r"^    (\w[\w, ]*) : \w", kind.__doc__ or "", re.MULTILINE)
        assert {each.name for each in fields(kind)} == {*", ".join(described).split(", ")}, kind


@pytest.mark.parametrize(
    ("options", "given", "error", "words"),
    [
        (ss.SearchOptions, {"margin": 0.9}, RANGE, r"margin = 0\.9 is not in \[9\.5.*leave it"),
        (ss.SearchOptions, {"budget": 0}, RANGE, "budget = 0 is not 1 or more; leave it out"),
        (ss.SearchOptions, {"tolerance": math.nan}, RANGE, "tolerance = nan is not "),
        (ss.MarginOptions, {"rays": 0}, RANGE, "rays = 0"),
        (ss.MotionOptions, {"times": (10.0, 0)}, RANGE, r"times\[1\] = 0 is not 0\.001 or more"),
        *((ss.SearchOptions, {"budget": one}, TYPE, "whole number") for one in (1.5, True, "many")),
        (ss.SearchOptions, {"margin": np.array([0.1, 0.2])}, TYPE, "is no number; leave it out"),
        *((ss.MotionOptions, {"times": one}, TYPE, LEAVE) for one in (5.0, (), (10.0, "long"))),
    ],
)
def test_what_is_no_value_of_an_option_is_told_with_the_remedy(options, given, error, words):
    with pytest.raises(error, match=words):
        options(**given)


def test_a_limit_may_be_an_integer_of_numpy():
    assert ss.SearchOptions(budget=np.int64(7)).budget == 7


def test_a_smaller_budget_leaves_boxes_undecided_and_claims_no_more():
    p = ss.load("cubic_contact").Parameters(theta0=0.8)
    whole = ss.equilibria(p)
    assert whole.complete
    few = ss.equilibria(p, options=ss.SearchOptions(budget=1, clusters=0, pieces=1))
    assert not few.decided
    assert few.count <= whole.count


def test_the_states_do_not_depend_on_how_they_are_searched():
    p = ss.load("cubic_contact").Parameters(theta0=0.8)
    whole = ss.equilibria(p)
    other = ss.SearchOptions(margin=0.2, shrunk=0.9, pieces=3, stiff=0.0, near=20.0, rounds=40)
    found = ss.equilibria(p, options=other)
    assert found.complete
    for name in whole.coordinates:
        assert np.abs(found[name] - whole[name]).max() <= 1e-12 * (1 + np.abs(whole[name]).max())


def test_folds_are_searched_with_options_and_told_to_be_incomplete():
    p = ss.Parameters.article()
    assert ss.folds(p).complete
    found = ss.folds(p, options=ss.SearchOptions(budget=3, pieces=1, clusters=0))
    assert not found.complete
    assert len(found.undecided)


def test_a_path_does_not_depend_on_how_near_to_a_fold_it_is_looked_at():
    p, values = ss.Parameters.article(), np.array([0.7, 0.9])
    usual = ss.quasi_static_path(p, "theta0", values)
    found = ss.quasi_static_path(
        p, "theta0", values, options=ss.ContinuationOptions(fold_distance=1e-5)
    )
    assert len(found.jumps) == len(usual.jumps) == 1
    assert abs(found.jumps[0].value - usual.jumps[0].value) < 1e-12
    for name in p.model.coordinates:
        assert np.abs(found[name] - usual[name]).max() < 1e-12


def test_a_tube_comes_to_the_same_state_by_other_steps_and_stops_with_too_few():
    p = ss.load("two_springs").Parameters(theta0=0.7)
    balance, goal = Balance(p.model), np.array([0.9])
    z = np.array([*(one.item(0) for one in ss.equilibria(p).coordinates.values()), 0.7])[:, None]

    def end(**options):
        given = given_column(p, balance.parameters, ("theta0",))
        how = ss.ContinuationOptions(**options)
        tubes = Tubes.of_points(balance, "theta0", given, options=how)
        return tubes.followed(tubes.place(z), goal)

    usual = end()
    assert usual.proved
    assert usual.v == goal
    for options in ({"first_step": 2.0**-4, "inflation": 0.3}, {"newton_steps": 3}):
        assert np.abs(end(**options).z - usual.z).max() < 1e-12
    assert 0.7 < end(steps=1).v < 0.9


def test_a_path_that_may_not_be_searched_says_so():
    options = ss.ContinuationOptions(search=ss.SearchOptions(budget=1, pieces=1, clusters=0))
    with pytest.raises(ss.errors.ConvergenceError, match="not all decided"):
        ss.quasi_static_path(ss.Parameters.article(), "theta0", [0.7, 0.9], options=options)


@pytest.mark.thorough
def test_a_smoother_curve_has_more_points():
    given = {"theta0": (0.7, 0.9), "mu0": (0.4, 0.6)}
    coarse, fine = (
        ss.bifurcation_set(
            ss.Parameters.article(),
            n=2,
            between=given,
            options=ss.ContinuationOptions(smoothness=smoothness),
        )
        for smoothness in (1e-2, 1e-4)
    )
    assert len(coarse) == len(fine) == 1
    assert len(fine.curves[0]) > 2 * len(coarse.curves[0])


def test_a_margin_with_fewer_rays_is_no_smaller_and_options_reach_the_search():
    p, scale = ss.Parameters.article(theta0=0.7), {"theta0": 0.02, "mu0": 0.05}
    usual = ss.jump_margin(p, scale)
    few = ss.jump_margin(p, scale, options=ss.MarginOptions(rays=1, rounds=0, steps=1))
    assert few.distance >= usual.distance * (1 - 1e-9)
    assert few.change != usual.change


@pytest.mark.thorough
def test_a_closed_orbit_is_the_same_in_more_mesh_intervals_and_its_branch_keeps_its_options():
    p = ss.load("stick_slip").Parameters(V=0.2)
    usual = ss.cycle(p)
    options = ss.ShootingOptions(growth=1.2, intervals=8)
    found = ss.cycle(p, usual, options=options)
    assert len(usual.orbit.states) < len(found.orbit.states) <= 8
    assert abs(found.period - usual.period) <= found.error + usual.error
    off = np.abs(found.multipliers - usual.multipliers)
    assert (off <= found.multiplier_errors + usual.multiplier_errors).all()
    branch = ss.cycle_branch(found, "V", between={"V": (0.199, 0.2)})
    assert all(cycle.orbit.flow.options == options for cycle in branch.cycles)


def test_no_orbit_is_told_to_close_whose_derivatives_are_not_resolved_as_far_as_asked():
    with pytest.raises(ss.errors.ConvergenceError):
        ss.cycle(ss.load("stick_slip").Parameters(V=0.2), options=ss.ShootingOptions(trivial=0.0))


def test_an_exponent_of_a_contracting_plane_is_told_by_as_many_half_widths_as_are_asked_for():
    # A damped oscillator: both exponents are the real part of its eigenvalues, and both decay.
    p = ss.load("stick_slip").Parameters(V=2.5)
    start = (0.3, 0.0)
    few = ss.lyapunov(p, start=start, t_end=40.0)
    many = ss.lyapunov(p, start=start, t_end=40.0, options=ss.MotionOptions(significance=1e12))
    assert np.array_equal(few.exponents, many.exponents)
    assert many.zero.all()
    assert not few.zero.all()


def test_the_limit_of_a_motion_is_settled_by_the_share_that_is_asked_for():
    p = ss.load("stick_slip").Parameters(V=2.5)
    motion = ss.simulate(p, x0=0.5, t_end=400.0)
    left = motion.outcome().distance
    assert left > 0
    for settled, there in ((2 * left, True), (left / 2, False)):
        found = motion.outcome(options=ss.MotionOptions(settled=settled))
        assert (found.regime == ss.Regime.EQUILIBRIUM) == there
        assert motion.outcome(tol=settled).regime == found.regime


def test_points_of_a_store_are_those_of_its_options(tmp_path):
    p, store = ss.load("stick_slip").Parameters(V=np.array([0.2, 2.5])), tmp_path / "fates.csv"
    found = ss.fate_map(p, t_end=100.0, store=store)
    assert ss.fate_map(p, t_end=100.0, store=store, options=ss.MotionOptions()).why.tolist() == (
        found.why.tolist()
    )
    with pytest.raises(ss.errors.SpragsymError, match="another"):
        ss.fate_map(p, t_end=100.0, store=store, options=ss.MotionOptions(times=(50.0,)))
