"""Dry friction against a driver on forces written by hand, Leine's oscillator in many digits, and
the limit of steep laws.
"""

import math
from collections.abc import Sequence

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion.integrators import Flow
from tests.oracles import dry_friction, sticking

START = (2.818, 1.213, 0.0, 0.22)
BRAKE = ss.load("coulomb_stick_slip")


@pytest.mark.parametrize(
    ("name", "seeds"),
    [
        pytest.param(name, seeds, marks=mark)
        for mark, *rows in (
            (pytest.mark.thorough, ("coulomb", range(5)), ("leine", range(5)), ("tip", range(2))),
            (
                pytest.mark.validate,
                ("coulomb", range(5, 105)),
                ("leine", range(5, 105)),
                ("tip", range(5, 105)),
            ),
        )
        for name, seeds in rows
    ],
)
def test_random_motions_are_those_of_another_driver(name: str, seeds: range) -> None:
    """Events in the same order, times and states; by either integrator."""
    kinds = set()
    for seed in seeds:
        values, start = dry_friction.drawn(name, seed)
        p = dry_friction.model(name).Parameters(**values)
        tr = ss.simulate(
            p,
            start=start,
            t_end=30.0,
            rtol=1e-12,
            backend="scipy" if seed % 2 or len(seeds) < 9 else None,
        )
        ours = [ss.Event(kind).name for kind in tr.events.which]
        for longest in (0.2, 0.01):
            driver = dry_friction.Driver(name, values, longest)
            end = driver.run(start, 30.0)
            theirs = [event for event, *_ in driver.events]
            if ours == theirs:
                break
        assert ours == theirs, seed
        for t, state, (_, at, there) in zip(
            tr.events.t, tr.events.state, driver.events, strict=True
        ):
            assert t == pytest.approx(at, abs=1e-6), (
                seed
            )  # the root of the driver's margin, where x' = V is all but touched
            assert state == pytest.approx(there, abs=1e-6), seed
        assert tr.state[:, -1] == pytest.approx(end, abs=1e-7), seed
        kinds |= {*theirs}
    assert {"STICK", "SLIP"} <= kinds


@pytest.mark.parametrize(
    "digits",
    [pytest.param(22, marks=pytest.mark.thorough), pytest.param(30, marks=pytest.mark.validate)],
)
def test_leines_oscillator_in_many_digits(digits: int) -> None:
    """R. Leine, D. van Campen, A. de Kraker, L. van den Steen, 1998: F_s = 1, delta = 3, belt 0.2.

    Its largest x is 1.135 where R. Leine begins it in 2024
    (github.com/rleine/Keynote_Nonsmooth_Dynamics_ENOC2024), by steps of 0.00246, and 1.13394467 in
    examples of ifdiff, at a relative tolerance of 1e-8.
    """
    period, reach = dry_friction.leine(digits)
    found = ss.cycle(dry_friction.model("leine").Parameters())
    assert found.period == pytest.approx(float(period), abs=1e-10)
    assert found.amplitude == pytest.approx(float(reach), abs=1e-10)
    assert (found.phases.side.tolist(), found.phases.contact.tolist()) == ([1, 0, 1], [1, 1, 1])
    assert found.state[0] == pytest.approx(1.13394467, abs=1e-8)


@pytest.mark.thorough
def test_leines_smoothed_oscillator_is_his() -> None:
    """With the factor 2/π atan(1000 v), to the digits with which he begins and ends its cycle:
    1.067 and 11.3.
    """
    p = sticking.model("arctan").Parameters(mu_s=1.0, delta=3.0, zeta=0.0, d=1e3, V=0.2)
    found = ss.cycle(p, near=(1.067, 0.0))
    assert (round(found.state[0], 3), round(found.period, 1)) == (1.067, 11.3)


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("degrees", "V", "start", "times"),
    [(60, 0.5, START, (24, 26)), (42, 0.2, (0, -0.02, 0.2, 0), (5, 8, 12))],
)
def test_steep_laws_come_to_dry_friction_as_their_theory_says(
    degrees: float, V: float, start: tuple[float, ...], times: tuple[int, ...]
) -> None:
    """As (A ln d + B)/d: where the force comes to its limit it creeps at speeds of ln d/d."""
    theta0 = math.radians(degrees)
    limit = ss.simulate(
        ss.load("coulomb").Parameters(theta0=theta0, V=V), start=start, t_end=26.0, rtol=1e-12
    )
    assert ss.Event.STICK in limit.events.which
    far = []
    for d in (1e2, 1e3, 1e4, 1e5):
        steep = ss.simulate(
            ss.Parameters.article(theta0=theta0), V=V, d=d, start=start, t_end=26.0, rtol=1e-12
        )
        far.append(d * np.abs(steep(times) - limit(times)).max(axis=0))
    assert np.all(np.array(far) < 1.6 * np.log([[1e2], [1e3], [1e4], [1e5]]))
    _, one, other = np.diff(far, axis=0)
    assert one == pytest.approx(other, rel=0.05)


@pytest.mark.parametrize(
    ("name", "seeds", "least"),
    [
        pytest.param("leine", (0, 3), 2, marks=pytest.mark.thorough),
        pytest.param("coulomb", (1, 15), 2, marks=pytest.mark.thorough),
        pytest.param("tip", (5, 6), 2, marks=pytest.mark.thorough),
        pytest.param("leine", range(34), 25, marks=pytest.mark.validate),
        pytest.param("coulomb", range(60), 15, marks=pytest.mark.validate),
        pytest.param("tip", range(30), 20, marks=pytest.mark.validate),
    ],
)
def test_derivatives_of_cycles_that_stick_are_differences_of_motions(
    name: str, seeds: Sequence[int], least: int
) -> None:
    """Their multipliers, and those of the return by the belt's speed and the friction, by the other
    driver.
    """
    pytest.importorskip("heyoka")
    stuck, model = 0, dry_friction.model(name)
    for seed in seeds:
        values, start = dry_friction.drawn(name, seed)
        try:
            cycle = ss.cycle(
                model.Parameters(**values), V=max(values["V"], 0.05), near=start, patient=False
            )
        except ss.errors.ConvergenceError:
            continue
        if stuck == least or 0 not in cycle.phases.side or cycle.period > 60:
            continue
        stuck += 1
        varied = "V", "mu0"
        theirs = dry_friction.derivatives(name, cycle, varied)
        directions = np.eye(len(model.parameters))[
            [model.parameters.index(each) for each in varied]
        ]
        passage = Flow.of(cycle.field, None).flow_map(
            cycle.state, cycle.orbit.constants, cycle.period, directions
        )
        assert cycle.residual < 1e-11, seed
        scale, by_state = max(1.0, np.abs(theirs).max()), theirs[:, : len(cycle.state)]
        ours = np.hstack([passage.by_state, passage.by_parameters])
        assert ours == pytest.approx(theirs, abs=3e-5 * scale), seed
        assert np.poly(cycle.multipliers) == pytest.approx(
            np.poly(by_state), abs=3e-5 * scale**2
        ), seed
    assert stuck == least


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_what_comes_to_rest_by_sticking_is_at_rest(backend: str) -> None:
    """Where the belt stands: at any place at which the force is within its limit, of which statics
    knows one.
    """
    pytest.importorskip(backend)
    for start, end in ((1.0, -0.2), (0.55, 0.55), (0.4, 0.4)):
        tr = ss.simulate(
            BRAKE.Parameters(V=0.0, mu_s=0.6, mu_k=0.4), x0=start, t_end=40.0, backend=backend
        )
        found = tr.outcome()
        assert found.regime == ss.Regime.EQUILIBRIUM
        assert found.rest[0] == pytest.approx(end, abs=1e-9)
        assert tr.after(30.0).sticking == 1.0
        assert (
            ss.simulate(tr.p, x0=start, t_end=40.0, backend=backend, events=False).outcome().rest
            == found.rest
        )
    with pytest.raises(
        ss.errors.ConvergenceError, match="it comes to rest, and friction holds it there"
    ):
        ss.cycle(tr.p, near=(1.0, 0.0), backend=backend)
    assert ss.lyapunov(
        tr.p, start=(1.0, 0.0), t_end=60.0, backend=backend
    ).exponents == pytest.approx([0.0, -math.inf])
    if backend == "heyoka":  # SciPy takes a minute
        bounces = ss.fate(ss.load("coulomb").Parameters(theta0=0.7, V=0.0), t_end=500.0)
        # x sticks, and nothing damps y
        assert bounces.kind == "undecided"
        assert "is not told from 0" in bounces.why
    free = BRAKE.Parameters(V=0.0, mu_s=0.0, mu_k=0.0)
    assert (
        ss.simulate(free, x0=1.0, t_end=40.0, backend=backend).outcome().regime
        == ss.Regime.UNSETTLED
    )


@pytest.mark.thorough
def test_contact_is_lost_while_it_sticks() -> None:
    """Upright, nothing pulls along a belt that stands: it bounces in place, and sticks whenever it
    is back.
    """
    p = ss.load("coulomb").Parameters(theta0=math.pi / 2, V=0.0)
    tr = ss.simulate(p, y0=-0.1, t_end=60.0, backend="scipy")
    lost, back, stuck = (
        tr.events.of(kind)
        for kind in (ss.Event.CONTACT_LOST, ss.Event.CONTACT_REGAINED, ss.Event.STICK)
    )
    assert len(lost) == 6
    assert len(tr.events) < 20
    assert stuck.t[:5] == pytest.approx(back.t[:5], abs=1e-3)
    assert np.abs(tr.vx).max() < 1e-11


@pytest.mark.thorough
def test_sweeps_count_what_motions_tell_and_nothing_chatters() -> None:
    p, start = ss.load("coulomb").Parameters(theta0=math.radians(42), V=0.2), {"x0": 0.3, "y0": 0.1}
    for workers in (1, 2):
        sweep = ss.rms_sweep(p, **start, t_end=300.0, transient=100.0, workers=workers)
        told = [
            len(ss.simulate(p, **start, t_end=300.0).after(100.0).events.of(kind))
            for kind in ss.Event
        ]
        assert (sweep.contact_lost, sweep.slip_reversed) == (told[0], sum(told[2:4]))
    long = ss.simulate(p, **start, t_end=1e4).events
    assert len(long) < 3000
    assert np.diff(long.t).min() > 1e-4


@pytest.mark.thorough
def test_what_stays_on_a_curved_border_is_kept_there() -> None:
    """By either integrator: errors of steps would take the tip off x' = V, and it would not be held
    again. A wide tolerance is refused by both.
    """
    shares = []
    for backend in ("heyoka", "scipy"):
        pytest.importorskip(backend)
        values, start = dry_friction.drawn("tip", 0)
        tr = ss.simulate(
            dry_friction.model("tip").Parameters(**values),
            start=start,
            t_end=30.0,
            backend=backend,
        )
        with pytest.raises(ss.errors.ParameterError, match="a border that is curved"):
            ss.simulate(tr.p, start=start, t_end=1.0, rtol=1e-6, backend=backend)
        begin, end = (tr.events.of(kind).t for kind in ("stick", ss.Event.SLIP))
        held = sum(min(end[end > t], default=30.0) - t for t in begin)
        assert tr.sticking == pytest.approx(held / 30.0, abs=1e-9)
        shares.append(tr.sticking)
    assert shares[0] == pytest.approx(shares[1], abs=1e-6)


@pytest.mark.parametrize("V", [1e-11, 1e-12])
def test_what_a_slow_belt_carries_slips_as_ever_and_is_never_at_rest(V: float) -> None:
    """From x = 0.6 to 0.2, and states within the stated error of the circle about x = 0.4."""
    p = BRAKE.Parameters(V=V)
    tr = ss.simulate(p, start=(0.6 - 1000 * V, V), t_end=1003.0, rtol=1e-12, estimate_error=True)
    slides = tr.t > 1001.2
    exact = 0.4 + 0.2 * np.cos(tr.t[slides] - 1000.0)
    assert tr.error is not None
    assert (np.abs(tr.state[0, slides] - exact) <= tr.error[slides]).all()
    assert V == 1e-12 or tr.error.max() < 1e-4
    stuck = ss.simulate(p, start=(0.6, V), t_end=10.0).events.of("stick").state
    np.testing.assert_allclose(stuck, [[0.2, V]], atol=1e-11)
    assert ss.fate(p).kind == "undecided"
    two = ss.load("two_blocks").Parameters(V=V)
    assert ss.fate(two).kind == "undecided"


def test_a_motion_is_followed_until_a_slow_belt_lets_it_slip() -> None:
    """From the state at rest, which the belt carries to x = 0.6 in 0.6/V: Δ = 0.2."""
    found, V = ss.fate(BRAKE.Parameters(V=1e-6)), 1e-6
    period = 0.4 / V + 2 * np.pi - 2 * np.arctan(0.2 / V)
    assert (found.kind, found.outcome.period) == ("cycle", pytest.approx(period, rel=1e-12))


def test_error_has_the_rounding_of_large_times() -> None:
    """At t = 1e9 that is 1e-7, and the speed is 0.2."""
    V = 1e-9
    p, slips = BRAKE.Parameters(V=V), 0.4 / V
    tr = ss.simulate(p, start=(0.2, V), t_end=slips + 3.0, rtol=1e-12, estimate_error=True)
    slides = tr.t > slips + 0.1
    exact = 0.4 + 0.2 * np.cos(tr.t[slides] - slips)
    assert tr.error is not None
    assert (np.abs(tr.state[0, slides] - exact) <= tr.error[slides]).all()
    assert 2e-8 < tr.error[-1] < 2e-6
