"""Degenerate points of models: ends of ranges, folds beside a cusp, lines of equilibria."""

import json

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import points


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "vary", "onsets"),
    [("kang_nam", "sigma", 2), ("stribeck", "sigma", 2), ("mode_coupling", "sigma", 1)],
)
def test_where_the_directions_do_not_feel_each_other_is_no_onset(name, vary, onsets):
    # At σ = 0 nothing damps the direction across the belt, in any state.
    model = ss.load(name).search
    p = model.Parameters(**({"theta0": 1.0} if "theta0" in model.parameters else {}))
    found = ss.flutter_onsets(p, vary)
    assert (found.decided, len(found)) == (True, onsets)
    assert (getattr(found, vary) > 1e-3).all()


@pytest.mark.thorough
@pytest.mark.parametrize("off", [0.0, -1e-12])
@pytest.mark.parametrize("vary", ["mu0", "theta0"])
def test_folds_beside_a_cusp(vary, off):
    model = ss.load("kang_nam").search
    given = {
        "mu0": {"theta0": 1.1871896863225868 + off},
        "theta0": {"mu0": 0.20093178180509016 + off},
    }[vary]
    found = ss.folds(model.Parameters(**given), vary)
    known = ss.folds(ss.Parameters.article(**({"theta0": None} | given)), vary)
    assert found.decided
    assert np.allclose(getattr(found, vary), getattr(known, vary), rtol=0, atol=1e-12)
    # Two whose parameter is the same float have no order.
    assert np.allclose(np.sort(found.x), np.sort(known.x), rtol=0, atol=1e-12)
    assert (found.error <= 1e-12).all()


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["kang_nam", "mode_coupling"])
def test_beside_a_line_of_equilibria_all_is_decided(name):
    # Without friction and spring along the belt nothing but the inclined spring, sigma > 0, holds
    # the mass along the belt.
    model = ss.load(name).search
    angle = {"theta0": 1.0} if name == "kang_nam" else {}
    found = ss.folds(model.Parameters(mu0=0.0, alpha=0.0, **angle), "sigma")
    assert (found.decided, len(found)) == (True, 0)
    assert (
        (0 if name == "mode_coupling" else 1e-99) <= found.region[-1, 0] < 1e-90
    )  # forces without springs are affine


@pytest.fixture
def with_a_line(monkeypatch):
    """A model whose sigma is searched down to 0, where nothing holds the mass along the belt."""
    monkeypatch.setattr(points, "begins_at_zero", lambda *_: False)
    return ss.load("kang_nam")


def stiff():
    """Springs from stiff to next to rigid, some with nothing else."""
    rng = np.random.default_rng(3)
    values = {
        "theta0": rng.uniform(0.1, 3.0, 8),
        "mu0": rng.uniform(0, 2, 8),
        "kappa": 10 ** rng.uniform(-5, 0, 8),
        "alpha": 10 ** rng.uniform(-3, 1, 8),
        "beta": 10 ** rng.uniform(-3, 1, 8),
        "sigma": 10.0 ** np.array([3.6, 4, 5, 6, 7, 9, 10, 12]),
    }
    values["alpha"][2] = values["beta"][2] = values["mu0"][3] = values["beta"][3] = 0.0
    return values


#: A mass that almost hangs on a circle: near-equilibria all around its anchor, which only its angle
#: tells apart.
CIRCLE = {"theta0": 1.8525980882017512, "mu0": 1.75, "alpha": 1.548e-3, "sigma": 7.8, "beta": 0.0}


@pytest.mark.parametrize(
    ("values", "contact"),
    [
        (stiff(), True),
        (stiff(), False),
        (CIRCLE | {"kappa": 4.770632327080111e-10}, False),
        pytest.param(CIRCLE | {"kappa": 3.07122127441096e-3}, False, marks=pytest.mark.thorough),
        # The one point of 10⁵ of tests.oracles.families that was left undecided.
        (
            {
                "theta0": 2.6739550310885836,
                "mu0": 0.0,
                "kappa": 0.19734271659075414,
                "alpha": 0.002747021913709797,
                "sigma": 2.9289279863232807,
                "beta": 0.0,
            },
            True,
        ),
    ],
)
def test_stiff_springs_have_the_states_of_the_closed_forms(values, contact):
    eq = ss.equilibria(ss.Parameters(**values), contact=contact, method="search")
    known = ss.equilibria(ss.Parameters(**values), contact=contact)
    assert eq.complete
    assert eq.count.tolist() == known.count.tolist()
    most = eq.x.shape[-1]
    assert np.allclose(eq.x, np.sort(known.x)[..., :most], rtol=0, atol=1e-12, equal_nan=True)
    assert np.nanmax(eq.error) <= 1e-12


# ------------------------------------------------------------------------------------------------
# the command line


@pytest.mark.thorough
def test_what_is_undecided_is_listed(with_a_line, run):
    asked = [
        "folds",
        "--theta0",
        "57",
        "--mu0",
        "0",
        "--alpha",
        "0",
        "--vary",
        "sigma",
        "--method",
        "search",
    ]
    told = json.loads(run(*asked, "--json"))
    assert not told["complete"]
    assert set(told["undecided"][0]) == {"x", "y", "sigma"}
    text = run(*asked)
    assert "1 box is undecided, within x in [" in text
    assert "det K is 0 in every state" in text
