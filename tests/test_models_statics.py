"""Equilibria, folds, cusps and onsets of flutter of models from pages: against closed forms and polynomials in many digits."""

from __future__ import annotations

import functools

import mpmath as mp
import numpy as np
import pytest

import spragsym as ss
from benchmarks import families

STATES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")


@functools.cache
def model(name):
    return ss.load(name)


def same_parameters(name, p, **more):
    """The article's parameters as those of a model that has them all."""
    return model(name).Parameters(**{key: getattr(p, key) for key in STATES}, **more)


def padded(values, slots, empty=np.nan):
    out = np.full((*values.shape[:-1], slots), empty)
    out[..., : values.shape[-1]] = values
    return out


@pytest.mark.parametrize("family", ["random", "ends", "right_angle", "frictionless", "false_double_root", "equal_stiffness"])
def test_the_articles_model_through_the_general_way(family):
    p = getattr(families, family)(np.random.default_rng(1), 60)
    eq, known = model("kang_nam").equilibria(same_parameters("kang_nam", p)), ss.equilibria(p)
    settled = eq.decided & ~known.undecided
    assert settled.sum() >= 58
    assert (eq.count == known.count)[settled].all()
    order = np.argsort(known.x, axis=-1)
    for name in ("x", "y"):
        want = np.take_along_axis(getattr(known, name), order, axis=-1)
        got = padded(getattr(eq, name), 3)
        assert np.nanmax(np.abs(got - want)[settled] / np.maximum(1, np.abs(want[settled]))) < 2e-12
    assert np.nanmax(eq.error) <= 1e-12
    assert eq.whole


def test_stability_and_eigenvalues_are_the_articles():
    theta0 = np.radians(np.arange(5.0, 176.0, 6.0))
    for changes in ({}, {"alpha": 0.7, "mu0": 0.9}):
        p = ss.Parameters.article(theta0=theta0, **changes)
        eq, known = model("kang_nam").equilibria(same_parameters("kang_nam", p)), ss.equilibria(p)
        assert (padded(eq.stability, 3, 0) == known.stability).all()
        got, want = (np.sort_complex(np.nan_to_num(one.eigenvalues.reshape(-1)).round(9)) for one in (eq, known))
        assert np.allclose(got[got != 0], want[want != 0], atol=1e-8)
    assert (known.stability == ss.Stability.FLUTTER).any()


def test_lift_off():
    p = ss.Parameters.article(theta0=np.radians([20.0, 90.0, 160.0]), kappa=-0.0 + 1e-4)
    eq, known = model("kang_nam").equilibria(same_parameters("kang_nam", p), contact=False), ss.equilibria(p, contact=False)
    assert (eq.count == known.count).all()
    assert np.allclose(padded(eq.x, 4), np.sort(known.x, axis=-1), atol=1e-12, equal_nan=True)


@pytest.mark.parametrize("off", [1e-6, 1e-10, 1e-14])
def test_near_a_fold_the_count_is_right_on_both_sides(off):
    fold = float(ss.folds(ss.Parameters.article()).theta0[0])
    p = ss.Parameters.article(theta0=np.array([fold * (1 - off), fold * (1 + off)]))
    eq = model("kang_nam").equilibria(same_parameters("kang_nam", p))
    assert eq.complete
    assert eq.count.tolist() == ss.equilibria(p).count.tolist() == [3, 1]
    assert np.nanmax(eq.error) < 1e-12


def test_shapes_and_one_point():
    eq = model("two_springs").equilibria(model("two_springs").Parameters(theta0=1.0))
    assert eq.count.shape == ()
    assert eq.x.shape == eq.stability.shape == (1,)
    assert eq.eigenvalues.shape == (1, 4)
    assert eq.region.shape == (2, 2)
    p = model("two_springs").Parameters(theta0=np.linspace(0.5, 1, 3)[:, None], mu0=[0.1, 0.9])
    eq = model("two_springs").equilibria(p)
    assert eq.count.shape == (3, 2)
    assert eq.region.shape == (3, 2, 2, 2)
    assert eq.complete
    with pytest.raises(AttributeError, match="its coordinates are x, y"):
        _ = eq.z


# ------------------------------------------------------------------------------- other pages, by other formulations


def by_angle(p, penetration):
    """All x of one spring with any contact law, from a scalar equation in the spring's direction.

    ``penetration(force)`` is the depth at which the contact pushes with that force. Along the belt and across it the balance
    gives (x, y) from the normal force n: its root in n for each θ would be two unknowns; instead L follows from the y balance
    by bisection, and the x balance is one function of θ, whose signs on a fine grid are refined to 50 digits.
    """
    theta0, mu, kappa, alpha, sigma, beta = (mp.mpf(float(getattr(p, key))) for key in STATES)
    c0, s0 = mp.cos(theta0), mp.sin(theta0)

    def rest(theta):
        c, s = mp.cos(theta), mp.sin(theta)

        # y = s0 − L s; kappa + sigma (s − s0) + (beta + sigma) y − n = 0 with n = law(−y): n as unknown.
        def across(n):
            return kappa + sigma * (s - s0) - (beta + sigma) * penetration(n) - n

        low, high = mp.mpf(0), kappa + sigma * 2
        if across(low) < 0:
            return None
        n = mp.findroot(across, (low, high), solver="anderson", tol=1e-90) if across(low) > 0 else low
        y = -penetration(n)
        L = (s0 - y) / s
        x = c0 - L * c
        return L, x, y, alpha * x + sigma * (x - c0 + c) - mu * n

    grid = [mp.pi * k / 300 for k in range(1, 300)]
    found = []
    values = [rest(theta) for theta in grid]
    for k in range(len(grid) - 1):
        one, two = values[k], values[k + 1]
        if one and two and one[3] * two[3] < 0 and one[0] > 0 and two[0] > 0:
            theta = mp.findroot(lambda t: rest(t)[3], (grid[k], grid[k + 1]), solver="anderson", tol=1e-60)
            found.append(rest(theta)[1:3])
    return sorted(found)


def hertz(n):
    return mp.cbrt(n) ** 2


def cubic(gamma):
    def depth(n):
        # gamma d³ + d − n = 0 by Cardano's formula, with gamma > 0.
        half = n / (2 * gamma)
        root = mp.sqrt(half**2 + 1 / (27 * mp.mpf(gamma) ** 3))
        return mp.cbrt(half + root) - mp.cbrt(root - half)

    return depth


@pytest.mark.parametrize(("name", "law"), [("hertz_contact", hertz), ("cubic_contact", cubic(100))])
@pytest.mark.parametrize("changes", [{"theta0": 0.6}, {"theta0": 1.3, "mu0": 0.22, "beta": 0.1}])
def test_contact_laws_against_a_scalar_equation(name, law, changes):
    with mp.workdps(50):
        p = model(name).Parameters(**changes)
        want = by_angle(p, law)
        eq = model(name).equilibria(p)
        assert eq.complete
        assert int(eq.count) == len(want)
        for slot, (x, y) in enumerate(want):
            assert abs(eq.x[slot] - x) <= eq.error[slot] + 1e-40
            assert abs(eq.y[slot] - y) <= eq.error[slot] + 1e-40
        assert eq.error.max() < 1e-12


def test_linear_models_in_closed_form():
    p = model("mode_coupling").Parameters()
    eq = model("mode_coupling").equilibria(p)
    alpha, sigma, beta, mu = (float(getattr(p, key)) for key in ("alpha", "sigma", "beta", "mu0"))
    K = np.array([[alpha + sigma / 2, mu - sigma / 2], [-sigma / 2, beta + sigma / 2 + 1]])
    x, y = np.linalg.solve(K, [0, -1])
    assert np.allclose([eq.x[0], eq.y[0]], [x, y], atol=1e-14)
    # (K11 − K22)² + 4 K12 K21 = 0 in mu: linear.
    onset = model("mode_coupling").flutter_onsets(p, "mu0", damping=False)
    assert onset.complete
    assert np.allclose(onset.mu0, sigma / 2 + (K[0, 0] - K[1, 1]) ** 2 / (2 * sigma), atol=1e-12)
    assert onset.kind.tolist() == ["flutter"]


def test_hopf_points_of_a_falling_friction_law():
    p = model("stick_slip").Parameters()
    onsets = model("stick_slip").flutter_onsets(p, "V")
    assert onsets.complete
    assert onsets.kind.tolist() == ["hopf"] * len(onsets)
    with mp.workdps(30):
        # Damping of the sliding mass: ζ and the slope of μ(V), here by numerical differentiation of the law itself.
        statics = model("stick_slip").statics

        def law(V):
            values = {"V": V, **{name: mp.mpf(float(getattr(p, name))) for name in ("mu_s", "v_s", "zeta")}}
            names = model("stick_slip").about["arguments"]["motion"]
            xp = type("XP", (), {"sqrt": mp.sqrt, "exp": mp.exp, "sign": mp.sign, "abs": abs})
            return statics.friction_at_rest.__wrapped__(*(values[name] for name in names), xp=xp)

        def damping(V):
            return mp.mpf(float(p.zeta)) + mp.diff(law, V)

        grid = np.geomspace(1e-3, 9.9, 200)
        signs = [damping(mp.mpf(float(V))) for V in grid]
        want = [
            mp.findroot(damping, (grid[i], grid[i + 1]), solver="anderson") for i in range(199) if signs[i] * signs[i + 1] < 0
        ]
        assert len(want) == len(onsets)
        for V, exact in zip(onsets.V, want, strict=True):
            assert abs(V - exact) < 1e-12
        assert np.allclose(onsets.omega, 1)


# ----------------------------------------------------------------------------------------- folds, cusps, flutter


@pytest.mark.parametrize(
    ("vary", "fixed"), [("theta0", {"mu0": 0.5}), ("mu0", {"theta0": np.radians(60)}), ("kappa", {"theta0": 1.0})]
)
def test_folds_are_the_articles(vary, fixed):
    p = ss.Parameters.article(**fixed)
    known = ss.folds(p, vary)
    some = model("kang_nam").Parameters(**{**{"theta0": 1.0}, **fixed})
    found = model("kang_nam").folds(some, vary)
    wanted = getattr(known, vary) < (10 if vary != "theta0" else 4)
    assert found.complete
    assert found.whole
    for name in (vary, "x", "y"):
        assert np.allclose(getattr(found, name), getattr(known, name)[wanted], atol=2e-12, rtol=1e-12)
    assert (found.kind == "fold").all()
    assert found.error.max() < 1e-12


def test_cusps_are_the_articles():
    known = ss.cusps(ss.Parameters.article())
    found = model("kang_nam").cusps(model("kang_nam").Parameters(theta0=1.0), ("theta0", "mu0"), between={"mu0": (0.0, 2.0)})
    assert found.complete
    wanted = (known.mu0 > 0) & (known.theta0 > 0)
    for name in ("theta0", "mu0", "x", "y"):
        assert np.allclose(getattr(found, name), getattr(known, name)[wanted], atol=1e-12)


def test_flutter_without_damping_is_the_articles():
    p = ss.Parameters.article(alpha=0.7)
    known = ss.flutter_onsets(p)
    found = model("kang_nam").flutter_onsets(same_parameters("kang_nam", p.replace(theta0=1.0)), "theta0", damping=False)
    assert found.complete
    assert np.allclose(found.theta0, known.theta0, atol=1e-12)
    assert np.allclose(found.x, known.x, atol=1e-12)
    assert len(found) == 2
    assert (found.kind == "flutter").all()


def test_hopf_points_with_dampers_are_where_a_pair_crosses():
    p = model("damped").Parameters(theta0=np.radians(60))
    found = model("damped").flutter_onsets(p, "mu0")
    assert found.complete
    assert found.kind.tolist() == ["hopf"]
    sides = model("damped").equilibria(p.replace(mu0=found.mu0[0] * np.array([1 - 1e-6, 1 + 1e-6])))
    slots = np.abs(sides.x - found.x[0]).argmin(axis=-1)
    growth = sides.growth[[0, 1], slots]
    assert growth[0] * growth[1] < 0
    assert np.abs(growth).max() < 1e-5


def test_a_pitchfork_stays_undecided_with_its_box():
    p = model("kang_nam").Parameters(theta0=1.0, mu0=0.0, alpha=0.0)
    known = ss.folds(ss.Parameters.article(mu0=0.0, alpha=0.0))
    assert known.kind.tolist() == ["pitchfork"] * 2
    found = model("kang_nam").folds(p, "theta0")
    assert not found.complete
    boxes = found.undecided[:, 2]
    for theta0 in known.theta0:
        assert ((boxes[:, 0] <= theta0) & (theta0 <= boxes[:, 1])).any()
    assert (boxes[:, 1] - boxes[:, 0]).max() < 1e-3


def test_what_does_not_vary_is_refused():
    p = model("kang_nam").Parameters(theta0=1.0)
    with pytest.raises(ss.ParameterError, match="is not a parameter of this model"):
        model("kang_nam").folds(p, "theta")
    with pytest.raises(ss.ParameterError, match="two different parameters"):
        model("kang_nam").cusps(p, ("mu0", "mu0"))
    with pytest.raises(ss.ParameterError, match="which does not vary"):
        model("kang_nam").folds(p, "mu0", between={"theta0": (0, 1)})
    with pytest.raises(ss.ParameterError, match="is no range"):
        model("kang_nam").folds(p, "mu0", between={"mu0": (1, 0)})
