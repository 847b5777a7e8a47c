"""Onsets of models of matrices against LAPACK, many digits, pages and closed forms."""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.numerics.definite import Middle, Pencil, Series, exceeds, window
from tests.oracles import brakes
from tests.oracles.brakes import brake


def model(of: dict[str, Any], **more: Any) -> Any:
    return ss.matrices(of["M"], of["K"], of["friction"], C=of["C"], **more)


def asked(of: dict[str, Any], **more: Any) -> Any:
    return ss.flutter_onsets(model(of).Parameters(), "mu", between={"mu": (0.0, 1.0)}, **more)


def held(of: dict[str, Any], growth: float = 0.0) -> Any:
    """Onsets that agree with LAPACK between them and with 40 digits at them."""
    on = asked(of, threshold=growth)
    assert on.complete
    low, high, count = on.growing.T
    middles = 0.5 * (low + high)
    assert (brakes.counts(of, middles, growth) == count).all()
    inside = low[1:] - high[:-1] <= 2.1e-3  # windows
    assert inside.all()
    for row in on:
        mu, omega = brakes.precise_onset(of, row["mu"], row["frequency"], growth)
        assert abs(mu - row["mu"]) <= row["error"]
        assert abs(abs(omega) - row["frequency"]) <= row["frequency_error"]
        beside = row["error"] + 1e-6
        below, above = brakes.counts(of, np.array([row["mu"] - beside, row["mu"] + beside]), growth)
        assert (above > below) == (row["direction"] == "up")
    return on


@pytest.mark.parametrize("kind", ["plain", "near", "weak", "soft"])
def test_brakes(kind: str) -> None:
    for seed in (0, 3):
        held(brake(6, seed, kind=kind))


def test_islands_and_thresholds() -> None:
    of = brake(10, 3)
    on = held(of)
    assert on.direction.tolist() == ["up", "down"]
    # The peak of the island is a threshold that is hardly passed.
    at = np.linspace(on.mu[0], on.mu[1], 201)
    peak = max(float(brakes.eigenvalues(of, mu).real.max()) for mu in at)
    assert held(of, 0.999 * peak).direction.tolist() == ["up", "down"]
    assert not len(held(of, 1.001 * peak))


def test_a_tangency_is_undecided() -> None:
    """Without damping the growth is 0 on both sides of mu = 1/2, where no friction acts."""
    t = 0.5
    A = np.array([[0.0, 1.0], [1.0, 0.0]])
    of = {
        "M": np.eye(2),
        "K": np.diag([1.0, 1.2]) - t * A,
        "C": np.zeros((2, 2)),
        "friction": A,
    }
    on = asked(of, threshold=0.0)
    assert not on.complete
    assert "undecided" in on.remarks[-1]


def test_the_end_of_a_range_is_told() -> None:
    of = brake(10, 3)
    inner = asked(of)
    mu = float(inner.mu[0])
    p = model(of).Parameters()
    at_end = ss.flutter_onsets(p, "mu", between={"mu": (mu, 1.0)})
    assert at_end.complete, at_end.undecided
    assert abs(at_end.mu[0] - mu) <= 2 * inner.error[0]
    assert "an end of the range" in at_end.remarks[0]


def test_divergence_and_its_count() -> None:
    """K + mu K_f is singular at mu = 2/5 and at mu = 4/5."""
    of = {
        "M": np.eye(2),
        "K": np.diag([2.0, 4.0]),
        "C": 0.1 * np.eye(2),
        "friction": np.diag([-5.0, -5.0]),
    }
    on = asked(of)
    assert on.kind.tolist() == ["divergence", "divergence"]
    assert (np.abs(on.mu - [0.4, 0.8]) <= on.error).all()
    assert on.growing[:, 2].tolist() == [0, 1, 2]


def test_units_change_nothing() -> None:
    of = brake(6, 3, kind="soft")
    on = asked(of, threshold=0.0)
    for mass, time in ((1e6, 1e-6), (1e-6, 1e3)):
        powers = {"M": 0, "C": 1, "K": 2, "friction": 2}
        scaled = {name: one * mass * time ** -powers[name] for name, one in of.items()}
        other = asked(scaled, threshold=0.0)
        assert other.complete
        assert other.mu == pytest.approx(on.mu, abs=1e-9)
        assert other.frequency * time == pytest.approx(on.frequency, rel=1e-9)


def test_altered_certificates_are_refused() -> None:
    """With a sign that is wrong no stretch is proved, nor a crossing where there is none."""
    refused = 0
    for seed in range(8):
        of = brake(6, seed)
        zero = np.zeros_like(of["M"])
        pencil = Pencil(of["M"], ((1.0, of["C"]),), ((1.0, of["K"]),), zero, of["friction"])
        middle = Middle(pencil, 0.3, 0.0)
        signs, none = middle.values.real, np.zeros(len(middle.values), dtype=bool)
        assert Series(middle, signs, 6, none).reach(1, 1e-6, 1e-9) > 0
        for index in range(len(signs)):
            for free in (none, ~none):
                wrong = signs.copy()
                wrong[index] *= -1
                series = Series(middle, wrong, 6, free)
                assert series.reach(1, 1e-3, 1e-9) == series.reach(-1, 1e-3, 1e-9) == 0.0
                refused += 1
            assert window(middle, index, 1e-6) is None
    assert refused >= 80


def test_the_decomposition_is_a_proof() -> None:
    """The eigenvalues of I ± A with A of rank one are 1 ± its norm, and 1."""
    vector = np.ones(16) / 4.0
    for norm in (0.5, 0.99):
        A = norm * np.outer(vector, vector)
        assert exceeds(A, 1.0 - norm - 1e-9)
        assert not exceeds(A, 1.0 - norm)
        assert not exceeds(-A, 1.0 - norm)


@pytest.mark.thorough
def test_pages_as_matrices() -> None:
    """The same onsets, of pages that are linear and of one at its state."""
    page = ss.load("mode_coupling")
    there = ss.flutter_onsets(page.Parameters(), "mu0", between={"mu0": (0.1, 1.0)}, damping=False)
    K, F = [[1.55, -0.25], [-0.25, 1.25]], [[0.0, 1.0], [0.0, 0.0]]
    q = ss.matrices(np.eye(2), K, F).Parameters()
    here = ss.flutter_onsets(q, "mu", between={"mu": (0.1, 1.0)}, threshold=4e-6)
    assert here.mu == pytest.approx(there.mu0, abs=1e-9)
    assert here.mu == pytest.approx([(0.3**2 + 0.5**2) / (2 * 0.5)], abs=1e-9)

    page = ss.load("disc_between_pads")
    p = page.Parameters()
    kappa, tau, iota = (float(p[name]) for name in ("kappa", "tau", "iota"))
    K, F = np.diag([3.0, tau]), [[0.0, 2 * kappa], [2 * kappa - 2.0, 0.0]]
    q = ss.matrices(np.diag([1.0, iota]), K, F).Parameters()
    here = ss.flutter_onsets(q, "mu", threshold=4e-6)
    exact = abs(3.0 - tau / iota) * iota**0.5 / (4 * (kappa * (1 - kappa)) ** 0.5)
    assert here.mu == pytest.approx([exact], abs=1e-9)

    page = ss.load("pad_on_disc")
    p = page.Parameters(theta0=0.5, d=100.0)
    there = ss.flutter_onsets(p, "mu0", between={"mu0": (0.3, 0.5)})
    where = [float(there[name][0]) for name in page.coordinates]
    given = [float(p[name]) for name in page.parameters if name not in ("theta0",)]
    algebra, angle = page.algebra, (np.cos(0.5), np.sin(0.5))
    statics = [float(p[name]) for name in ("kappa", "alpha", "sigma", "sigma_p", "sigma_w")]
    ((across, up, unit),) = algebra.geometry(*where, *angle)
    L = float(np.hypot(across, up))
    spring = (across / L, up / L, L / unit)
    K0, K1 = (
        np.array(algebra.forces_jacobian(*where, *spring, *angle, *statics, mu, 1.0), dtype=float)
        for mu in (0.0, 1.0)
    )
    M = np.array(algebra.mass_matrix(*where, *angle, *given), dtype=float)
    C = np.diag([0.0, 0.0, float(p["zeta_w"]), 0.0])
    q = ss.matrices(M, K0, K1 - K0, C=C).Parameters()
    here = ss.flutter_onsets(q, "mu", between={"mu": (0.3, 0.5)}, threshold=0.0)
    assert here.mu == pytest.approx(there.mu0, abs=1e-9)
    assert here.frequency == pytest.approx(there.omega, abs=1e-9)


def test_parameters_vary_as_friction_does() -> None:
    of = brake(6, 3)
    of["C"] = of["C"] * 1.0
    own = np.zeros((6, 6))
    own[0, 0] = 1e5
    m = model(of, stiffnesses={"k_0": own}, dampings={"c_0": 1e-4 * own})
    p = m.Parameters(mu=0.7, c_0=0.1)
    for name, span in (("k_0", (0.0, 100.0)), ("c_0", (0.0, 5.0))):
        on = ss.flutter_onsets(p, name, between={name: span}, threshold=0.0)
        assert on.complete
        for low, high, count in on.growing:
            value = 0.5 * (low + high)
            k, c = (value, 0.1) if name == "k_0" else (0.0, value)
            changed = of | {"K": of["K"] + k * own, "C": of["C"] + c * 1e-4 * own}
            assert brakes.counts(changed, np.array([0.7]), 0.0)[0] == count


def test_modes_and_their_sensitivities() -> None:
    of = brake(6, 1)
    own = np.diag([1e5, 0, 0, 0, 0, 0])
    m = model(of, stiffnesses={"k_0": own}, damping_ratio=0.01)
    p = m.Parameters(mu=0.2, k_0=1.0)
    found = ss.modes(p)
    for name in ("mu", "k_0"):
        step = 1e-6
        up, down = (ss.modes(p.replace(**{name: float(p[name]) + s * step})) for s in (1, -1))
        for column in ("growth", "frequency_hz"):
            slope = (up[column] - down[column]) / (2 * step)
            by = found[f"{column.removesuffix('_hz')}_by_{name}"]
            assert slope == pytest.approx(by, rel=1e-4, abs=1e-4)


def test_a_damping_ratio_is_that_of_every_mode() -> None:
    of = brake(6, 1)
    of["C"] = 0.0 * of["C"]
    found = ss.modes(model(of, damping_ratio=0.02).Parameters(mu=0.0))
    assert found.damping_ratio == pytest.approx([0.02] * 6)
    found = ss.modes(model(of, rayleigh=(3.0, 1e-6)).Parameters(mu=0.0))
    assert found.growth == pytest.approx(
        -0.5 * (3.0 + 1e-6 * np.abs(found.omega + 1j * found.growth) ** 2)
    )


def test_the_threshold_of_undamped_modes_is_told() -> None:
    of = brake(6, 3)
    of["C"] = 0.0 * of["C"]
    on = asked(of)
    assert on.threshold > 0
    assert "no damping" in on.remarks[0]


def test_what_makes_no_sense_is_refused_by_name() -> None:
    p = model(brake(4, 0)).Parameters(mu=0.3)
    for question in (
        ss.equilibria,
        ss.folds,
        ss.cusps,
        ss.jump_value,
        ss.simulate,
        ss.fate,
        ss.cycle,
    ):
        with pytest.raises(
            ss.errors.ModelError, match=f"{question.__name__} is not asked of matrices"
        ):
            question(p)
    with pytest.raises(ss.errors.ParameterError, match="within is nothing of matrices"):
        ss.flutter_onsets(p, within={"mu": (0, 1)})
    with pytest.raises(ss.errors.ParameterError, match="threshold = 1"):
        ss.flutter_onsets(ss.load("stick_slip").Parameters(), "V", threshold=1.0)
    with pytest.raises(ss.errors.ModelError, match="modes is asked of matrices"):
        ss.modes(ss.load("stick_slip").Parameters())
    for wrong, words in (
        ({"M": -np.eye(4)}, "no mass matrix"),
        ({"K": np.eye(3)}, "shape"),
        ({"K": np.full((4, 4), np.nan)}, "nan"),
        ({"G": "nowhere.mtx"}, "nowhere.mtx"),
    ):
        with pytest.raises(ss.errors.ParameterError, match=words):
            ss.matrices(**({"M": np.eye(4), "K": np.eye(4), "friction": np.eye(4)} | wrong))
