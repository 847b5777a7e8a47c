"""Motions and sweeps: one class and one function for every model, with forces held against formulas
written by hand.
"""

import pickle

import numpy as np
import pytest

import spragsym as ss
from tests.conformance.models import ALIKE, MOVING, a_set
from tests.support import few


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MOVING, "kang_nam", "stick_slip", "sprag_rod"))
def test_a_motion_of_every_model_has_everything(name: str) -> None:
    p = a_set(name)
    tr = ss.simulate(p, t_end=30.0, rtol=1e-8, backend="scipy", estimate_error=True)
    assert type(tr) is ss.results.Trajectory
    assert tr.model is p.model
    assert tr.state.shape == (len(tr.components), tr.t.size)
    assert np.array_equal(tr[tr.components[-1]], tr.state[-1])
    assert tr.error is not None
    assert tr.error.max() < 1e-4
    assert tr.spectrum(0.0).frequency.size
    again = pickle.loads(pickle.dumps(tr))  # noqa: S301  # written here
    assert np.array_equal(again.state, tr.state)
    assert again.model.name == name


def test_a_start_may_be_given_whole_or_by_names() -> None:
    p = ss.Parameters(theta0=0.7)
    whole = ss.simulate(p, start=[0.1, -0.01, 0.0, 0.02], t_end=20.0)
    named = ss.simulate(p, x0=0.1, y0=-0.01, vy0=0.02, t_end=20.0)
    assert np.array_equal(whole.state, named.state)
    with pytest.raises(
        ss.errors.ParameterError, match=r"start has the shape \(2,\); it is x0, y0, vx0, vy0"
    ):
        ss.simulate(p, start=[0.1, 0.0])
    with pytest.raises(
        ss.errors.ParameterTypeError,
        match="xO is no argument; the initial state is x0, y0, vx0, vy0",
    ):
        ss.simulate(p, xO=0.1)


def test_parameters_by_their_names_take_the_place_of_those_of_the_set() -> None:
    p, changes = ss.Parameters(theta0=0.7), dict(kappa=0.02, V=0.4)
    given, replaced = (
        ss.simulate(p, x0=0.1, t_end=20.0, **changes),
        ss.simulate(p.replace(**changes), x0=0.1, t_end=20.0),
    )
    assert np.array_equal(given.state, replaced.state)
    assert float(given.p.kappa) == 0.02
    swept = ss.rms_sweep(p, x0=0.1, t_end=20.0, transient=0.0, **changes)
    assert float(swept.rms) == pytest.approx(given.rms(0.0), rel=1e-9)


def test_forces_of_springs_and_of_the_contact_are_those_written_by_hand() -> None:
    p = ss.load("two_springs").Parameters(theta0=0.8, sigma_2=0.04, lambda_2=1.3, theta0_2=1.9)
    tr = ss.simulate(p, t_end=40.0)
    lengths = [
        np.hypot(size * np.cos(angle) - tr.x, size * np.sin(angle) - tr.y)
        for size, angle in ((1.0, 0.8), (1.3, 1.9))
    ]
    assert np.abs(tr.spring_force("spring 1") - float(p.sigma) * (lengths[0] - 1.0)).max() < 1e-14
    assert np.abs(tr.spring_force("spring 2") - 0.04 * (lengths[1] - 1.3)).max() < 1e-14
    assert np.array_equal(tr.contact_force(), np.maximum(-tr.y, 0.0))
    with pytest.raises(
        ss.errors.ParameterError,
        match="spring = None of two_springs is one of 'spring 1', 'spring 2'",
    ):
        tr.spring_force()
    # Where the gap is no coordinate the normal force is the law of the depth, whatever share of it
    # each coordinate feels.
    rod = ss.load("sprag_rod").Parameters(theta0=0.7)
    swing = ss.simulate(rod, start=[1.0, 0.0], t_end=20.0)
    assert (
        np.abs(swing.contact_force() - np.maximum(np.cos(swing.phi) - np.cos(0.7), 0.0)).max()
        < 1e-14
    )
    assert swing.contact_force().max() > 0


def test_the_range_of_forces_over_a_cycle_is_that_of_its_motion() -> None:
    p = ss.Parameters(theta0=np.radians(42.0))
    cycle = ss.cycle(p, near=(2.54, 3.36, 0.0, 0.36))
    tr = cycle.trajectory()
    assert set(cycle.forces) == {"spring_force", "contact_force"}
    assert cycle.forces["spring_force"] == pytest.approx(
        (tr.spring_force().min(), tr.spring_force().max()), abs=1e-4
    )
    belt = ss.load("stick_slip").Parameters(V=0.2)
    assert ss.cycle(belt).forces == {}
