"""Folds, cusps and onsets of every model: one class, the same attributes, and two ways to one
answer.
"""

import pickle

import numpy as np
import pytest

import spragsym as ss
from tests.conformance.models import ALIKE, MODELS, a_set
from tests.support import few

#: What the contract names, and what may be asked besides.
ATTRIBUTES = (
    "kind",
    "error",
    "complete",
    "undecided",
    "region",
    "remarks",
    "ends",
    "when",
    "after",
    "vary",
    "parameters",
    "whole",
    "endless",
    "decided",
    "columns",
    "coordinates",
)


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("question", ["folds", "flutter_onsets"])
@pytest.mark.parametrize("name", few(MODELS, "kang_nam", "stick_slip"))
def test_points_of_every_model_have_everything(name: str, question: str) -> None:
    p = a_set(name)
    found = getattr(ss, question)(p)
    assert type(found) is (ss.results.Points if question == "folds" else ss.results.Onsets)
    for attribute in ATTRIBUTES:
        assert getattr(found, attribute) is not None
    for column in (*p.model.parameters, *found.state_columns):
        assert found[column].shape == (len(found),)
    for ours in (found.error, found.kind, found.ends, found.when):
        assert ours.shape == (len(found),)
    assert found.parameters is p
    assert tuple(found.after) == found.state_columns
    assert found.region.shape == (len(p.model.coordinates) + 1, 2)
    assert found.undecided.shape[1:] == found.region.shape
    again = pickle.loads(pickle.dumps(found))  # noqa: S301  # our own bytes
    assert np.array_equal(again.error, found.error)
    assert len(found.select(found.error < 0)) == 0
    with pytest.raises(AttributeError, match="has no attribute 'nothing'; its columns are"):
        found.nothing  # noqa: B018  # an attribute that is made when asked for


@pytest.mark.parametrize("vary", few(["theta0", "mu0", "kappa", "sigma"]))
def test_what_ends_is_the_same_by_closed_forms_and_by_search(vary: str) -> None:
    p = ss.Parameters(theta0=0.6, mu0=0.45, alpha=0.01)
    closed, search = (
        ss.folds(p, vary, method=method).select(np.ones(number, dtype=bool))
        for method, number in (
            ("closed", len(ss.folds(p, vary))),
            ("search", len(ss.folds(p, vary, method="search"))),
        )
    )
    known = [int(np.abs(closed[vary] - value).argmin()) for value in search[vary]]
    assert len(known) > 0
    assert closed.ends[known].tolist() == search.ends.tolist()
    assert closed.when[known].tolist() == search.when.tolist()
    for name in closed.state_columns:
        assert closed.after[name][known] == pytest.approx(search.after[name], abs=1e-9)
        assert closed[name][known] == pytest.approx(search[name], abs=1e-10)
