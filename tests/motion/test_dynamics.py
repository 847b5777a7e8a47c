"""Motion in time against energy, linear theory, closed forms and a second integrator."""

import os
import signal
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from spragsym.generated import stability
from spragsym.kang_nam.quartic.solver import equilibria
from spragsym.motion import Event, Trajectory, integrators, simulate, with_compiled, with_heyoka
from spragsym.motion.lobatto import unit_points
from spragsym.motion.measures import Spectrum
from spragsym.motion.problem import prepare
from tests.support import few

BACKENDS = [
    "scipy",
    pytest.param(
        "compiled",
        marks=pytest.mark.skipif(
            not with_compiled.available(), reason="no C compiler on installation"
        ),
    ),
    pytest.param("heyoka", marks=pytest.mark.skipif(not find_spec("heyoka"), reason="no heyoka")),
]
BASE = ss.Parameters.article(theta0=np.radians(49))
BELT = {"V": 0.5, "d": 10.0}


def _installed() -> list[str]:
    return [
        name
        for name in integrators.BACKENDS
        if (with_compiled.available() if name == "compiled" else find_spec(name))
    ]


@pytest.fixture(scope="module")
def base() -> dict[str, Trajectory]:
    """A quarter of the article's Figure 7a at the tightest tolerance, by each backend."""
    return {
        name: simulate(BASE, **BELT, rtol=1e-13, t_end=500.0, backend=name) for name in _installed()
    }


@pytest.mark.thorough
@pytest.mark.skipif(not with_compiled.available(), reason="no C compiler on installation")
def test_compiled_is_scipy_step_for_step(base: dict[str, Trajectory]) -> None:
    """The same steps and events, since C has the page's algebra; digits part slowly, as a compiler
    sums in another order.
    """
    problem = prepare(
        BASE.model, BASE.replace(**BELT), start=(0.0, 0.0, 0.0, 0.0), t_end=40.0, rtol=1e-9
    )
    compiled, scipy = (
        integrators.integrate(problem, name).samples for name in ("compiled", "scipy")
    )
    assert compiled.t.size == scipy.t.size
    np.testing.assert_allclose(compiled.t, scipy.t, atol=1e-7)
    np.testing.assert_allclose(compiled.states, scipy.states, atol=1e-8)
    assert base["compiled"].rms() == pytest.approx(base["scipy"].rms(), rel=1e-8)


@pytest.mark.parametrize(
    "backend", [pytest.param("scipy", marks=pytest.mark.thorough), *BACKENDS[1:]]
)
def test_crossings_of_the_base_case(backend: str) -> None:
    # Counted by other integrators, that step over the kinks, as sign changes of dense output: 155
    # and 104.
    tr = simulate(BASE, **BELT, rtol=1e-13, backend=backend)
    assert len(tr.events.of(Event.CONTACT_LOST, Event.CONTACT_REGAINED)) == 155
    assert len(tr.events.of(Event.MASS_OVERTAKES, Event.BELT_OVERTAKES)) == 104


def test_events_lie_on_the_kinks_and_alternate(base: dict[str, Trajectory]) -> None:
    for tr in base.values():
        contact = tr.events.of(Event.CONTACT_LOST, Event.CONTACT_REGAINED)
        slip = tr.events.of(Event.MASS_OVERTAKES, Event.BELT_OVERTAKES)
        assert np.abs(contact.state[:, 1]).max() < 1e-11
        assert np.abs(slip.state[:, 2] - 0.5).max() < 1e-11
        assert (np.diff(contact.which) != 0).all()
        assert (np.diff(slip.which) != 0).all()
        assert ((contact.state[:, 3] > 0) == (contact.which == Event.CONTACT_LOST)).all()
        np.testing.assert_allclose(tr(tr.events.t).T, tr.events.state, atol=1e-10)


@pytest.mark.parametrize(
    ("backend", "rtol", "t_end"),
    [pytest.param("scipy", 1e-12, 4e2, marks=pytest.mark.thorough), ("heyoka", 1e-13, 1e4)],
)
def test_energy_is_kept_without_friction(backend: str, rtol: float, t_end: float) -> None:
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    tr = simulate(
        BASE.replace(mu0=0.0), **BELT, x0=0.3, y0=0.2, t_end=t_end, rtol=rtol, backend=backend
    )
    energy = tr.energy()
    assert len(tr.events) > 0.1 * t_end  # many passages through contact and lift-off
    assert np.abs(energy - energy[0]).max() < 1e-3 * rtol * t_end


@pytest.mark.parametrize(
    ("theta0_deg", "slot", "mode", "d"),
    [
        (30.0, 0, 0, 4.0),
        (30.0, 2, 1, 40.0),
        (49.0, 0, 1, 4.0),
        (49.0, 0, 0, 40.0),
        (170.0, 2, 0, 4.0),
    ],
)
def test_small_oscillations_follow_the_linearization(
    theta0_deg: float, slot: int, mode: int, d: float
) -> None:
    V, size, t_end = 0.5, 1e-7, 1000.0
    p = ss.Parameters.article(theta0=np.radians(theta0_deg))
    mu = 0.5 * (1 - np.exp(-d * V))
    eq = equilibria(p.replace(mu0=mu))
    theta, L, x, y = (getattr(eq, name)[slot] for name in ("theta", "L", "x", "y"))
    assert eq.undamped[slot] == ss.EquilibriumType.STABLE
    K = np.array(stability.stiffness(np.cos(theta), np.sin(theta), L, mu, 0.007, 0.1, 0.0, 1))
    damping = float(stability.damping(y, 0.5, V, d, 1))
    # ∂(μ n)/∂x' written out once more: μ = μ0 (1 − exp(−d (V − x'))), n = −y.
    assert damping == pytest.approx(-y * 0.5 * d * np.exp(-d * V), rel=1e-12)
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-K, np.diag([-damping, 0.0])]])
    values, vectors = np.linalg.eig(A)
    order = [i for i in np.argsort(values.imag) if values[i].imag > 0]
    value, vector = values[order[mode]], vectors[:, order[mode]]
    if d * V >= 20:  # then damping is nothing, and the frequencies are those of (27)
        frequencies = np.sort(np.abs(eq.eigenvalues[slot].imag))
        assert value.imag == pytest.approx(frequencies[2 * mode], rel=1e-7)
    start = np.array([x, y, 0, 0]) + size * vector.real
    tr = simulate(
        p,
        V=V,
        d=d,
        **dict(zip(("x0", "y0", "vx0", "vy0"), start, strict=True)),
        t_end=t_end,
        rtol=1e-13,
    )
    linear = size * (vector[:, None] * np.exp(value * tr.t)).real
    deviation = tr.state - np.array([x, y, 0, 0])[:, None] - linear
    assert tr.decay_rate() == pytest.approx(-value.real, rel=1e-3, abs=1e-8)
    # Quadratic terms are 1e-7 of the linear ones, and add up over hundreds of periods.
    assert np.abs(deviation).max() < 1e-3 * size
    assert len(tr.events) == 0


@pytest.mark.parametrize("backend", BACKENDS)
def test_start_on_the_kink_is_the_limit_of_starts_beside_it(backend: str) -> None:
    on = simulate(BASE, **BELT, t_end=20.0, backend=backend)
    for y0 in (-1e-9, 1e-9):
        beside = simulate(BASE, **BELT, y0=y0, t_end=20.0, backend=backend)
        assert np.abs(on(np.arange(20.0)) - beside(np.arange(20.0))).max() < 1e-7
    both = simulate(BASE, **BELT, vx0=0.5, t_end=20.0, backend=backend)  # y = 0 and x' = V at once
    assert np.isfinite(both.state).all()


def test_the_last_event_is_told_at_the_tightest_tolerance() -> None:
    tr = simulate(ss.Parameters.article(theta0=1.0), **BELT, y0=0.05, t_end=8.0, rtol=1e-13)
    assert tr.events.which.tolist() == [Event.CONTACT_REGAINED, Event.CONTACT_LOST]


@pytest.mark.thorough
def test_integrators_find_the_same_events_from_random_starts() -> None:
    rng = np.random.default_rng(5)
    for _ in range(8):
        p = ss.Parameters.article(
            theta0=rng.uniform(0.2, 2.9), mu0=rng.uniform(0, 1), beta=rng.uniform(0, 0.5)
        )
        start = dict(
            zip(
                ("x0", "y0", "vx0", "vy0"), rng.normal(size=4) * [0.3, 0.05, 0.3, 0.05], strict=True
            )
        )
        belt = {"V": rng.uniform(0.02, 0.5), "d": rng.uniform(1, 30)}
        one, *others = (
            simulate(p, **belt, **start, t_end=40.0, rtol=1e-12, backend=name)
            for name in _installed()
        )
        if not others:
            pytest.skip("one integrator only: nothing to compare with")
        for other in others:
            assert one.events.which.tolist() == other.events.which.tolist()
            np.testing.assert_allclose(one.events.t, other.events.t, atol=1e-8)
            np.testing.assert_allclose(one(np.arange(40.0)), other(np.arange(40.0)), atol=1e-8)


def _through_a_thin_layer(rtol: float, backend: str) -> np.ndarray:
    """Where a motion ends; with d this large (10) is Coulomb's law but for a layer that Taylor
    series do not see beforehand.
    """
    p = ss.Parameters(theta0=0.6084, mu0=0.4082, kappa=0.0018, alpha=6.116, sigma=19.66, beta=6.016)
    start = {"x0": 0.126, "y0": 0.078, "vx0": -0.424, "vy0": 0.231, "t_end": 30.0}
    return simulate(p, V=0.228, d=1679.0, **start, rtol=rtol, backend=backend).state[:, -1]


@pytest.fixture(scope="module")
def through_a_thin_layer() -> np.ndarray:
    return _through_a_thin_layer(1e-13, "scipy")


@pytest.mark.thorough
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("rtol", few([1e-7, 1e-9, 1e-11, 1e-13], 1e-9))
def test_a_thin_layer_of_creep_is_seen_from_far_away(
    rtol: float, backend: str, through_a_thin_layer: np.ndarray
) -> None:
    if (backend, rtol) != ("scipy", 1e-13):  # that is the reference
        assert (
            np.abs(_through_a_thin_layer(rtol, backend) - through_a_thin_layer).max() < 3000 * rtol
        )


@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="timers are of POSIX")
def test_ctrl_c_is_heard_within_a_motion_that_meets_no_event() -> None:
    """After 0.2 s of this process's own time: the ten million steps, a minute, are not walked to
    their end first.
    """
    pytest.importorskip("heyoka")
    p = ss.Parameters.article(theta0=np.radians(100), mu0=0.0)
    rest = equilibria(p)
    former = signal.signal(signal.SIGPROF, lambda number, frame: signal.raise_signal(signal.SIGINT))
    simulate(p, **BELT, t_end=1.0, backend="heyoka")  # compiled before the clock runs
    signal.setitimer(signal.ITIMER_PROF, 0.2)
    try:
        with pytest.raises(KeyboardInterrupt):
            simulate(p, **BELT, x0=rest.x[0] + 1e-3, y0=rest.y[0], t_end=1e9, backend="heyoka")
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, former)
    problem = prepare(p.model, p.replace(**BELT), start=(0.0, 0.0, 0.0, 0.0), t_end=1.0, rtol=1e-10)
    assert 0 < with_heyoka.compiled(problem.field, problem.rtol).solver.time < 1e6


def _wave(omega: float, centre: float, steps: int = 120, step: float = 0.9) -> Trajectory:
    """x = centre + cos(ω t), exactly."""
    unit = unit_points()
    t = np.append((np.arange(steps)[:, None] + unit[:-1]).ravel(), steps) * step
    zero = np.zeros_like(t)
    x, vx = centre + np.cos(omega * t), -omega * np.sin(omega * t)
    return Trajectory(BASE.model, BASE, t, np.array([x, zero, vx, zero]), None, 1e-10, "none")


@pytest.mark.parametrize("omega", [0.3, 1.1])
@pytest.mark.parametrize("centre", [0.0, 0.2])
def test_measures_of_a_known_wave(omega: float, centre: float) -> None:
    tr = _wave(omega, centre)
    begin, end = 3.21, tr.t[-1]
    length = end - begin
    first = (np.sin(omega * end) - np.sin(omega * begin)) / omega
    second = length / 2 + (np.sin(2 * omega * end) - np.sin(2 * omega * begin)) / (4 * omega)
    mean = centre + first / length
    square = centre**2 + 2 * centre * first / length + second / length
    assert tr.mean(begin) == pytest.approx(mean, abs=1e-13)
    assert tr.rms(begin) == pytest.approx(np.sqrt(square), abs=1e-13)
    assert tr.rms(begin, about="mean") == pytest.approx(np.sqrt(square - mean**2), abs=1e-13)
    assert tr.largest(begin) == pytest.approx(1 + centre, abs=1e-13)
    assert tr.largest(begin, about="mean") == pytest.approx(1 + abs(mean - centre), abs=1e-13)
    statistics = tr.after(begin).statistics()
    assert np.diff(statistics.maxima_t) == pytest.approx(2 * np.pi / omega, abs=1e-11)
    assert statistics.maxima[:, 0] == pytest.approx(centre + 1, abs=1e-13)
    assert statistics.minima[:, 0] == pytest.approx(centre - 1, abs=1e-13)
    assert statistics.moments() == pytest.approx((mean, np.sqrt(square - mean**2)), abs=1e-13)
    times = np.linspace(0, end, 501)
    np.testing.assert_allclose(tr(times)[0], centre + np.cos(omega * times), atol=1e-13)


@pytest.mark.parametrize("times", [[-1.0, 5.0], [5.0, 11.0], [float("nan")]])
def test_times_outside_a_trajectory_are_refused(times: list[float]) -> None:
    tr = ss.simulate(ss.load("coulomb_stick_slip").Parameters(), t_end=10.0)
    assert tr([0.0, 10.0]).shape == (2, 2)
    with pytest.raises(ss.errors.ParameterError, match=r"\[0, 10\]|not in"):
        tr(times)


def test_the_peak_of_a_spectrum_lies_between_its_bins() -> None:
    """Where log amplitudes are a parabola at its top, else on the bin: at either end, beside a 0."""
    frequency = np.arange(5.0)
    parabola = np.exp(-((frequency - 2.2) ** 2))
    assert Spectrum(frequency, parabola).peak() == pytest.approx(2.2, abs=1e-12)
    for amplitude, peak in (
        ([5.0, 4.0, 1.0, 1.0, 1.0], 0.0),
        ([1.0, 1.0, 1.0, 4.0, 5.0], 4.0),
        ([1.0, 1.0, 0.0, 5.0, 4.0], 3.0),
        ([1.0, 5.0, 5.0, 5.0, 1.0], 1.0 + 0.5),
    ):
        assert Spectrum(frequency, np.array(amplitude)).peak() == pytest.approx(peak, abs=1e-12)


@pytest.mark.thorough
def test_without_a_heyoka_that_can_be_imported_another_integrator_serves(tmp_path: Path) -> None:
    (tmp_path / "heyoka.py").write_text("raise ImportError('of another NumPy')", encoding="utf-8")
    code = (
        "import spragsym as ss\np = ss.Parameters.article(theta0=0.7, mu0=0.3)\n"
        "print(ss.simulate(p, t_end=1.0).backend)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | {"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout.strip() in ("compiled", "scipy"), done.stderr
    assert "heyoka is installed and can't be used: of another NumPy" in done.stderr


def test_a_start_by_names_is_that_by_numbers() -> None:
    """What is not named is 0, a clock keeps its rate, and another name is refused."""
    p = ss.Parameters.article(theta0=np.radians(42), V=0.5, d=4.0)
    by_names = ss.simulate(p, start={"x": 0.1, "vy": 0.02}, t_end=5.0)
    by_numbers = ss.simulate(p, start=(0.1, 0.0, 0.0, 0.02), t_end=5.0)
    assert np.array_equal(by_names.state, by_numbers.state)
    with pytest.raises(ss.errors.ParameterError, match=r"'X'; did you mean x\?; the state is x, y"):
        ss.simulate(p, start={"X": 0.1})
    forced = ss.load("forced_oscillator").Parameters()
    omega = float(forced.omega)
    assert ss.simulate(forced, start={"phase": 1.0}, t_end=1.0).state[:, 0].tolist() == [
        *(0.0, 1.0, 0.0, omega)
    ]
    assert ss.fate(forced, start={"x": 0.1}).kind == ss.fate(forced, start=(0.1, 0.0)).kind
    assert ss.cycle(forced, near={"x": 0.1}).period == pytest.approx(2 * np.pi / omega, rel=1e-12)
