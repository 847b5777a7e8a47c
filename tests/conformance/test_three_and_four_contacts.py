"""Every public question of a page with three contacts, and of one with four: it is answered, or
refused by its name.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.bifurcation.sticking_regions import is_convex
from tests.conformance.test_questions import TABLE, Asked, questions
from tests.oracles.contact_pages import ROW, STOPPED_ROW
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytest.importorskip("sympy")

PLANE = ("mu_s", "kappa")
SPAN = {"mu_s": (0.5, 0.7)}


def _branch(p: Any) -> Any:
    """A piece of the branch of the cycle from rest."""
    ends = {"V": (0.199, 0.201)}
    return ss.cycle_branch(ss.cycle(p, patient=False), "V", between=ends, points=10)


def _events(p: Any) -> None:
    """Its ends, the only events there, are no curves in two parameters."""
    for event in _branch(p).events:
        with pytest.raises(ss.errors.ParameterError, match=f"{event.kind} is not followed"):
            ss.cycle_events(event, ("V", "kappa"))


def _no_value(p: Any, **both: Any) -> None:
    """Nothing jumps, so that no value is between."""
    given = {**both["between"], "N_1": (0.5, 1.5)}
    with pytest.raises(ss.errors.ParameterError, match="there is no fold"):
        ss.critical_value(p, "N_1", along="mu_k", over="kappa", between=given)


def _no_angle(p: Any) -> None:
    """Sensitivity is by an inclination."""
    with pytest.raises(ss.errors.ModelError, match="has no theta0, along which sensitivity looks"):
        ss.sensitivity(p)


def _no_saddle(p: Any) -> None:
    """Its only state has no direction of growth."""
    with pytest.raises(ss.errors.ParameterError, match="one divergent equilibrium is needed"):
        ss.basin_boundary(p)


def _one_fate(p: Any) -> None:
    """What rests at both ends rests in one set."""
    span = {"mu_s": (0.6, 0.61)}
    with pytest.raises(ss.errors.ParameterError, match="which is one attractor"):
        ss.fate_boundary(p.replace(V=0.0), "mu_s", between=span)


def _no_modes(p: Any) -> None:
    """Its states tell growth and stability themselves; matrices have modes."""
    with pytest.raises(ss.errors.ModelError, match="growth and stability"):
        ss.modes(p)


def asked_of(p: Any) -> dict[str, Callable[[], object]]:
    """Each question near the base values, as it is asked of a model of any kind."""
    still, short = p.replace(V=0.0), {"t_end": 60.0}
    plane = {"x_1": [0.0, 0.1], "vx_1": [0.0]}
    rises, few = {"vary": "mu_k", "begin": 0.1}, ss.MarginOptions(rays=1, rounds=1, coarse=2)
    both = {"between": {"kappa": (0.5, 1.0), "mu_k": (0.1, 0.5)}}
    base = {name: float(p[name]) for name in p.model.parameters}
    return {
        "basin": lambda: ss.basin(p, **plane, **short),
        "basin_boundary": lambda: _no_saddle(p),
        "bifurcation_set": lambda: ss.bifurcation_set(p, PLANE, n=4),
        "certify": lambda: ss.certify(p, between={"mu_k": (float(p.mu_k), 0.5)}, **rises),
        "count": lambda: ss.count(p),
        "critical_friction": lambda: ss.critical_friction(p, "mu_k", "kappa", **both),
        "critical_value": lambda: _no_value(p, **both),
        "cusp_friction": lambda: ss.cusp_friction(p, "mu_k", "kappa", **both),
        "cusps": lambda: ss.cusps(p, PLANE),
        "cycle": lambda: ss.cycle(p, patient=False),
        "cycle_branch": partial(_branch, p),
        "cycle_events": partial(_events, p),
        "diagram": lambda: ss.diagram(p, "mu_s", between=SPAN, points=2),
        "equilibria": lambda: ss.equilibria(p),
        "explore": lambda: ss.explore(p),
        "fate": lambda: ss.fate(p),
        "fate_boundary": lambda: _one_fate(p),
        "fate_map": lambda: ss.fate_map(p.replace(mu_s=[0.6]), **short),
        "flutter_onsets": lambda: ss.flutter_onsets(p, "mu_s", between=SPAN),
        "folds": lambda: ss.folds(p, "mu_s", between=SPAN),
        "jump_gradient": lambda: ss.jump_gradient(p, "mu_s"),
        "jump_margin": lambda: ss.jump_margin(p, {"mu_k": 0.1}, **rises, options=few),
        "jump_probability": lambda: ss.jump_probability(
            {**base, "mu_k": (0.3, 0.4)}, model=p.model, n=64, rng=1, **rises
        ),
        "jump_value": lambda: ss.jump_value(p, "mu_s", until=1.0),
        "lyapunov": lambda: ss.lyapunov(p, t_end=20.0),
        "modes": lambda: _no_modes(p),
        "onset_curves": lambda: ss.onset_curves(p, PLANE, 4),
        "precise_equilibria": lambda: precise.equilibria(p),
        "quasi_static_path": lambda: ss.quasi_static_path(p, "mu_s", [0.5, 0.6, 0.7]),
        "redesign": lambda: ss.redesign(p, "kappa", {"mu_k": 0.5}, begin=0.1, options=few),
        "rms_sweep": lambda: ss.rms_sweep(p, **short),
        "sensitivity": lambda: _no_angle(p),
        "simulate": lambda: ss.simulate(p, **short),
        "sticking_states": lambda: ss.sticking_states(still),
    }


def load(page: str) -> ss.Model:
    """One of the pages, derived once."""
    return model_of({"row": ROW, "stopped_row": STOPPED_ROW}[page], page)


@pytest.mark.thorough
@pytest.mark.parametrize("page", ["row", "stopped_row"])
def test_what_is_not_answered_is_refused_by_its_name(page: str) -> None:
    model = load(page)
    asked = asked_of(model.Parameters())
    of_article = TABLE[Asked.article].split()
    assert {*questions()} - {*of_article} == {*asked} - {"precise_equilibria"}
    assert not any(map(model.refusal, asked))
    for name in of_article:
        with pytest.raises(ss.errors.ModelError, match=f"{name} is not there yet for the model"):
            getattr(ss.kang_nam, name)(model.Parameters(), *[0.5] * (name == "surface") * 2)


@needs_a_quick_integrator
@pytest.mark.validate
@pytest.mark.parametrize("page", ["row", "stopped_row"])
def test_every_other_question_is_answered(page: str) -> None:
    model = load(page)
    for ask in asked_of(model.Parameters()).values():
        ask()


@pytest.mark.thorough
def test_a_stop_cuts_the_region_of_rest_of_a_row() -> None:
    """What holds all blocks forwards holds the third against the stop, too."""
    row = ss.sticking_states(model_of(ROW, "row").Parameters(V=0.0))
    assert row["x_3_high"][0] > 0.4  # where the stop stands
    p = model_of(STOPPED_ROW, "stopped_row").Parameters(V=0.0)
    found = ss.sticking_states(p)
    assert found.complete
    ties = p.kappa * np.array([[1, -1, 0], [-1, 2, -1], [0, -1, 1]])
    K = np.diag([1, p.beta, 1]) + ties + np.diag([0, 0, 1])
    held = p.mu_s * np.array([p.N_1, p.N_2, 1.0])
    highest = np.linalg.solve(K, held + np.array([0, 0, 0.4]))
    for name, most in zip(p.model.coordinates, highest, strict=True):
        np.testing.assert_allclose(found[f"{name}_high"], most, rtol=1e-12)
        np.testing.assert_allclose(found[f"{name}_low"], row[f"{name}_low"], rtol=1e-12)
    assert not is_convex(p)
