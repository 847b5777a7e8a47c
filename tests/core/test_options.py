"""Options of algorithms: ranges of their fields, and what limits do to the answers of questions."""

import math

import numpy as np
import pytest

import spragsym as ss


def test_values_out_of_range_are_told_with_their_range_and_the_remedy():
    with pytest.raises(ss.errors.ParameterError, match=r"margin = 0\.9 is not in \[9\.5.*leave it"):
        ss.SearchOptions(margin=0.9)
    with pytest.raises(ss.errors.ParameterError, match="budget = 0 is not 1 or more; leave it out"):
        ss.SearchOptions(budget=0)


@pytest.mark.parametrize("value", [1.5, True, "many"])
def test_a_limit_is_a_whole_number(value):
    with pytest.raises(ss.errors.ParameterTypeError, match="is no whole number"):
        ss.SearchOptions(budget=value)


def test_no_number_is_no_tolerance():
    with pytest.raises(ss.errors.ParameterError):
        ss.SearchOptions(tolerance=math.nan)
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
