"""Every set of parameters knows its model, and a function asked for one model never answers for
another.
"""

import copy
import functools
import pickle
import subprocess
import sys

import numpy as np
import pytest

import spragsym as ss
from spragsym.design.jumps import limit_point_passed
from spragsym.generated.quantities import PARAMETERS
from tests.conformance.models import MODELS, a_set, load

# ------------------------------------------------------------------------------------------------
# sets and their models


def test_the_articles_parameters_are_those_of_its_model() -> None:
    model = ss.load("kang_nam")
    assert ss.Parameters is model.Parameters
    assert model.parameters == (*PARAMETERS, "V", "d") == tuple(ss.Parameters.ranges)
    assert ss.Parameters() == ss.Parameters.article() == ss.Parameters(**model.base)
    assert {name: float(getattr(ss.Parameters(), name)) for name in model.base} == model.base
    assert ss.Parameters() != "article"


def test_a_set_knows_its_model() -> None:
    for name in MODELS:
        p, model = a_set(name), load(name)
        again = pickle.loads(pickle.dumps(p))  # noqa: S301  # our own bytes
        for other in (
            p,
            p.replace(**dict.fromkeys(model.parameters[1:2], 0.1)),
            copy.deepcopy(p),
            again,
        ):
            assert other.model is model
            assert type(other) is model.Parameters
        assert again == p


def test_a_set_of_another_process_knows_its_model() -> None:
    """There the model is loaded by the set alone."""
    program = (
        "import pickle, sys; p = pickle.load(sys.stdin.buffer); print(p.model.name, "
        "p.model.parameters == tuple(p.ranges))"
    )
    for name in ("kang_nam", "two_springs"):
        done = subprocess.run(
            [sys.executable, "-c", program],
            input=pickle.dumps(a_set(name)),
            capture_output=True,
            check=True,
        )
        assert done.stdout.split() == [name.encode(), b"True"]


@pytest.mark.parametrize("shape", [(), (3,), (2, 1)])
def test_V_and_d_are_parameters_like_others(shape: tuple[int, ...]) -> None:
    p = ss.Parameters.article(theta0=0.7, V=np.full(shape, 0.25), d=4.0)
    assert p.shape == shape
    assert np.array_equal(
        ss.equilibria(p).count,
        np.broadcast_to(ss.equilibria(p.replace(V=0.5, d=10.0)).count, shape),
    )
    assert ss.rms_sweep(p, t_end=1.0).rms.shape == shape


# ------------------------------------------------------------------------------------------------
# one entry


def test_two_ways_to_one_answer() -> None:
    one = ss.Parameters()
    closed, search = (
        ss.folds(one.replace(theta0=0.7), "mu0", method=method) for method in ("closed", "search")
    )
    assert (closed.parameters.model, search.parameters.model) == (one.model, one.model.search)
    # Where there are no closed forms for what is asked, or not at all, the general way answers.
    assert ss.equilibria(one.replace(theta0=0.5), within={"x": (5.0, 6.0)}).count == 0
    folds = ss.folds(one.replace(theta0=0.7), "d")  # which moves no equilibrium
    assert (folds.kind.size, folds.complete) == (0, True)
    assert ss.folds(one, between={"theta0": (0.5, 1.5)}).theta0.size == 1
    assert ss.cusps(
        one.replace(theta0=1.2), vary=("kappa", "mu0"), between={"kappa": (0.006, 0.008)}
    ).vary == ("kappa", "mu0")
    # Ranges of no parameter say nothing, so that the closed form still answers.
    assert ss.critical_friction(one, between={}, method="closed").value == ss.critical_friction(one)
    rises = functools.partial(ss.certify, claim="no jump", vary="theta0")
    for function, p in (
        (ss.equilibria, a_set("stribeck")),
        (ss.jump_value, a_set("stribeck")),
        (rises, one),
    ):
        with pytest.raises(
            ss.errors.ModelError, match=rf"{p.model.name} answers .* by no closed form"
        ):
            function(p, method="closed")
    with pytest.raises(
        ss.errors.ParameterError, match="method = 'guess' is not one of auto, closed, search"
    ):
        ss.equilibria(p, method="guess")
    with pytest.raises(ss.errors.ParameterTypeError, match="contact = 'yes'"):
        ss.equilibria(one, contact="yes")
    for ask, name, more in (
        (ss.explore, "p", ()),
        (ss.basin, "p", ()),
        (ss.sensitivity, "p", ()),
        (ss.precise.prove_cycle, "cycle", ()),
        (functools.partial(ss.cycle_branch, between={"V": (0, 1)}), "cycle", ("V",)),
        (ss.cycle_events, "event", (("V", "d"),)),
    ):
        with pytest.raises(ss.errors.ParameterTypeError, match=f"{name} = 'coulomb' is no .*; "):
            ask("coulomb", *more)


@pytest.mark.validate
def test_what_has_jumped_has_two_witnesses() -> None:
    """By the signs of one polynomial, and by tubes; both are what jump values say."""
    rng, shape = np.random.default_rng(3), (20, 10)
    given = {"theta0": rng.uniform(0.3, 2.0, shape), "mu0": rng.uniform(0.0, 2.0, shape)}
    sizes = {"kappa": (-4, -1), "alpha": (-3, 0), "sigma": (-2, 0.5), "beta": (-3, 0)}
    p = ss.Parameters(
        **given, **{name: 10 ** rng.uniform(*ends, shape) for name, ends in sizes.items()}
    )
    closed, search = (limit_point_passed(p, method=method) for method in ("closed", "search"))
    assert closed.shape == search.shape == p.shape
    coarse = limit_point_passed(p, method="search", coarse=True)
    known = ~np.isnan(coarse)
    assert known.mean() > 0.95
    assert np.array_equal(coarse[known], closed[known])
    assert 0.1 < closed.mean() < 0.9
    assert np.array_equal(closed, search)
    assert np.array_equal(closed == 1, ss.jump_value(p) <= p.mu0)
    q = ss.load("cubic_contact").Parameters(theta0=0.9, mu0=[[0.0, 0.1], [0.3, 0.5]])
    assert limit_point_passed(q).tolist() == (ss.jump_value(q.replace(mu0=0.0)) <= q.mu0).tolist()
    with pytest.raises(ss.errors.ParameterError, match="stribeck has no friction that rises"):
        limit_point_passed(a_set("stribeck"))
