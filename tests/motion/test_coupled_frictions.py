"""Dry frictions that share inertias: where one turns or begins to hold, another may have to slip."""

import math

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion.integrators import Flow
from tests.oracles import coupled_frictions
from tests.oracles.coupled_frictions import SYSTEMS, Driver
from tests.oracles.user_pages import model_of
from tests.support import needs_a_quick_integrator

pytest.importorskip("sympy")

#: A block y that rides on a belt, and a block x on it that is faster until t_1. There friction on x
#: turns, and the force that y needs jumps from 0.1 to 0.7, beyond its limit 0.6.
VALUES = {"mu_s": 0.6, "mu_k": 0.6, "n_1": 0.5, "n_2": 1.0, "a": 1.0, "b": 1.0, "V": 0.2}
A, V = math.hypot(0.3, 2.0), 0.2
T_1 = math.atan2(2.0, 0.3) - math.asin(V / A)
START = (0.0, 0.4 - V * T_1, 2.0, V)


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_friction_that_turns_makes_another_slip_at_that_instant(backend: str) -> None:
    """x(t_1 + s) = 0.3 + (x_1 - 0.3) cos s + V sin s of the lower block, and its derivative by the
    speed of the upper one: one saltation for both changes.
    """
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    model = model_of(SYSTEMS["stack"].text, "stack")
    p = model.Parameters(**VALUES)
    tr = ss.simulate(p, start=START, t_end=T_1 + 1.0, rtol=1e-12, backend=backend)
    top = -0.3 + math.sqrt(A**2 - V**2)
    exact = [
        0.3 + (top - 0.3) * math.cos(1.0) + V * math.sin(1.0),
        0.3 + 0.1 * math.cos(1.0) + V * math.sin(1.0),
    ]
    np.testing.assert_allclose(tr.state[:2, -1], exact, rtol=0, atol=1e-11)
    assert [ss.Event(kind).name for kind in tr.events.which] == ["BELT_OVERTAKES", "SLIP"]
    assert tr.events.contact == ("one", "two")
    np.testing.assert_allclose(tr.events.t, T_1, rtol=0, atol=1e-11)
    if backend == "heyoka":
        return  # compiling its derivatives takes seconds
    flow = Flow.of(model.field, backend)
    constants = model.field.constants(p.scalars(*model.parameters))
    found = flow.flow_map(np.array(START), constants, T_1 + 1.0, np.zeros((0, 7)))
    later = math.cos(T_1) / (top + 0.3)
    assert found.by_state[1, 2] == pytest.approx(0.1 * math.sin(1.0) * later, abs=1e-10)


@pytest.mark.thorough
@needs_a_quick_integrator
@pytest.mark.parametrize("name", ["feet", "chain", "lifting"])
def test_motions_are_those_of_another_driver(name: str) -> None:
    """And no friction bears more than its limit, at any sample."""
    values, start = coupled_frictions.drawn(name, np.random.default_rng([1, 3]), False)
    model = model_of(SYSTEMS[name].text, name)
    p = model.Parameters(**{each: values[each] for each in values if each in model.parameters})
    driver = Driver(name, values)
    end = driver.run(start, 8.0)
    tr = ss.simulate(p, start=start, t_end=8.0, rtol=1e-12)
    np.testing.assert_allclose(tr.state[:, -1], end, rtol=0, atol=1e-9)
    dry = tr.events.of("stick", "slip", "mass_overtakes", "belt_overtakes")
    np.testing.assert_allclose(dry.t, [t for t, *_ in driver.events], rtol=0, atol=1e-9)


@pytest.mark.thorough
def test_the_rule_decides_where_several_modes_agree() -> None:
    """Twins on a common bar come to their limits at one instant, and either that slips lets the
    other stick: one of them is held, and both changes are alike, so that the first on the page is.
    """
    model = model_of(SYSTEMS["tied"].text, "tied")
    values = {"mu_s": 0.6, "mu_k": 0.4, "n_1": 1.0, "n_2": 1.0, "a": 1.0, "b": 0.7, "V": 0.2}
    tr = ss.simulate(model.Parameters(**values), vx0=0.2, vy0=0.2, t_end=5.0)
    slips = tr.events.of("slip")
    assert slips.contact[0] == "two"
    assert slips.t[0] == pytest.approx(3.0, abs=1e-9)
    driver = Driver("tied", values)
    end = driver.run([0.0, 0.0, 0.2, 0.2], 5.0)
    np.testing.assert_allclose(tr.state[:, -1], end, rtol=0, atol=1e-8)
