"""Reports of pages with several contacts, against linear systems by hand and closed forms."""

import math
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.parameters import FloatArray
from spragsym.models.quantities import quantities
from tests.oracles.contact_pages import LADDER, PAD, SNAP, balanced, pad
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytest.importorskip("sympy")

#: What one of each unit of measure is in SI.
SIZES = {"kg": 2.0, "N/m": 300.0, "m": 0.25}


def a_study(model: ss.Model, changes: dict[str, float], **more: Any) -> ss.Study:
    """Base values with changes, dimensionless ones, in SI."""
    units = {entry["name"]: SIZES[entry["unit"]] for entry in model.about["units"]}
    kind, values = quantities(model.where), model.base | changes
    given = {
        quantity: values[name] * kind.scale(kind.units[quantity], units)
        for quantity, name in kind.parameters.items()
    }
    return ss.Study(units | given, model=model.where, **more)


@pytest.mark.thorough
def test_states_and_forces_of_every_combination_of_touches() -> None:
    model, names = model_of(PAD, "pad_on_2"), ("front", "rear")
    for mu0 in (0.3, 2.5):
        values = model.base | {"mu0": mu0}
        report = a_study(model, {"mu0": mu0}).report(oscillation=False, probability=False)
        known = {", ".join(names): q for names, q in balanced(*pad(values, names)) if names}
        assert {state.touching for state in report.states} == {*known}
        for state in report.states:
            x, y, phi = known[state.touching]
            assert state.x_mm == pytest.approx(1e3 * 0.25 * x, rel=1e-12)
            force = 300.0 * 0.25
            exact = {"front": max(phi - y, 0.0), "rear": max(-phi - y, 0.0)}
            assert state.contact_force_N == pytest.approx(
                {name: force * depth for name, depth in exact.items()}, rel=1e-11, abs=1e-14
            )


@pytest.mark.thorough
def test_roots_are_those_of_the_contacts_that_touch() -> None:
    """Of a disc on its lower pad alone, by differences of its field written by hand."""
    report = a_study(ss.load("disc_between_pads"), {"mu0": 0.6}).report(oscillation=False)
    state = next(state for state in report.states if state.touching == "lower")

    def field(u: FloatArray) -> FloatArray:
        y, phi, y_rate, phi_rate = u
        slides = 0.5 + (1 + y) * phi_rate + y_rate * phi
        force = 0.6 * (1 - math.exp(-10 * slides)) * (0.1 - y)
        pulls = 0.1 - 2 * y - force * phi, -(phi + force * (1 + y)) / 0.4
        return np.array([y_rate, phi_rate, *pulls])

    at = np.array([state.y_mm / 250.0, math.radians(state.phi_deg), 0.0, 0.0])
    assert np.abs(field(at)).max() < 1e-12
    steps = 1e-5 * np.eye(4)
    matrix = np.array([(field(at + step) - field(at - step)) / 2e-5 for step in steps]).T
    growth = np.linalg.eigvals(matrix).real.max() * math.sqrt(300.0 / 2.0)
    assert state.growth_per_s == pytest.approx(growth, rel=1e-7)


@pytest.mark.thorough
@needs_a_quick_integrator
def test_where_the_followed_state_leaves_its_stop_and_what_it_does_then() -> None:
    """It leaves at F = k a, and comes to rest on the other stop at x = −(k_c + F)/(k_c − 1) a."""
    model = model_of(SNAP, "snap")
    report = a_study(model, {}, vary="F", begin=0.0).report(probability=False)
    assert report.jump_at == pytest.approx(300.0 * 0.25, rel=1e-12)
    assert report.kind_jump == "border"
    peak = report.peak
    assert peak
    assert peak.before["x_mm"] == pytest.approx(250.0, rel=1e-9)
    assert peak.after["x_mm"] == pytest.approx(-250.0 * 5 / 3, rel=1e-9)
    assert peak.settles == "rest"
    assert peak.lifts_off
    text = str(report)
    assert "it leaves the contact at F 75 N" in text
    assert "touching                        right" in text


@pytest.mark.thorough
def test_frictions_that_are_not_the_same_are_told_one_by_one() -> None:
    text = str(a_study(model_of(LADDER, "ladder"), {}).report(oscillation=False))
    assert "friction at the belt's speed    0.3" in text
    assert "friction of the contact wall    0.2" in text
