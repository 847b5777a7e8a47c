"""The numbers behind the claims and the figures, by other means than those that computed them."""

import itertools
import re
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import Any

import click
import mpmath
import numpy as np
import pytest
from click.testing import CliRunner
from scipy.optimize import brentq, root

import spragsym as ss
from spragsym import article as claims
from spragsym.cli import cli
from spragsym.cli.article import check as check_command
from spragsym.motion import simulate
from tests.oracles import article_motion, creeping_states, damped_states, dry_friction, reference
from tests.support import LONG_MOTIONS_TAKE_MINUTES, ROOT

BASE = {"mu0": 0.5, "kappa": 0.007, "alpha": 0.007, "sigma": 0.1, "beta": 0.0}
EXACT = {"mu0": "0.5", "kappa": "0.007", "alpha": "0.007", "sigma": "0.1", "beta": "0"}


@cache
def record() -> dict[str, dict[str, Any]]:
    return {row["id"]: row for row in claims.recorded()}


def value(id: str, name: str) -> Any:
    return record()[id]["values"][name]


# ------------------------------------------------------------------------------------------------
# the article's balance, written by hand


def constants(
    theta0: float, p: dict[str, float], V: float = 1.0, d: float = 1e3
) -> tuple[float, ...]:
    """Those of the equations of motion: with this V and d friction works fully."""
    return np.cos(theta0), np.sin(theta0), *(p[name] for name in BASE), V, d


def forces(
    x: float, y: float, theta0: float, contact: bool = True, **p: float
) -> tuple[float, float]:
    """(12) and (13) with the preload."""
    return article_motion.accelerations((x, y, 0.0, 0.0), constants(theta0, p), contact, 1.0)


def stiffness(x: float, y: float, theta0: float, contact: bool = True, **p: float) -> Any:
    """Less the forces' Jacobian; friction on both sides of y = 0 as in contact, if it is."""
    return -np.array(article_motion.slopes((x, y, 0.0, 0.0), constants(theta0, p), contact, 1.0))[
        :, :2
    ]


def spring_eigenvalues(x: float, y: float, theta0: float, contact: bool = True, **p: float) -> Any:
    """λ² less the sign."""
    return np.linalg.eigvals(stiffness(x, y, theta0, contact, **p))


def kind(eigenvalues: Any) -> int:
    if abs(np.imag(eigenvalues)).max() > 1e-7:
        return int(ss.EquilibriumType.FLUTTER)
    return int(
        ss.EquilibriumType.STABLE
        if np.real(eigenvalues).min() > 0
        else ss.EquilibriumType.DIVERGENT
    )


def counted(theta0: float, **p: float) -> int:
    """Number of equilibria in contact by the eigenvalues of the quartic's companion matrix."""
    return creeping_states.roots(ss.Parameters(theta0=theta0, **p), "theta0", theta0)[0].size


def refined(unknowns: dict[str, float], orders: int, **fixed: Any) -> dict[str, mpmath.mpf]:
    """The point near ``unknowns`` where the force along the belt and its first derivatives by θ are
    zero, to 30 digits.
    """
    with mpmath.workdps(40):
        exact = {name: mpmath.mpf(number) for name, number in (EXACT | fixed).items()}

        def equations(*values: Any) -> list[Any]:
            p = exact | dict(zip(unknowns, values, strict=True))
            theta, theta0 = p.pop("theta"), p.pop("theta0")
            return [
                mpmath.diff(lambda t: reference.along(t, theta0, **p), theta, k)
                for k in range(orders)
            ]

        found = mpmath.findroot(equations, list(unknowns.values()), tol=1e-50)
        return dict(zip(unknowns, found, strict=True))


def near(theta0_deg: float, **changes: float) -> float:
    """θ of the two equilibria that are closest to each other, in the middle between them."""
    theta = ss.equilibria(ss.Parameters.article(theta0=np.radians(theta0_deg), **changes)).theta
    gap = np.diff(theta)
    i = int(np.nanargmin(gap))
    return float(theta[i] + gap[i] / 2)


# ---------------------------------------------------------------------------------------------
# folds and cusps


@pytest.mark.parametrize(
    ("id", "place", "side", "mu0"),
    [
        ("fig-4-regions", ("folds_deg", 0), -1e-4, "0.5"),
        ("fig-4-regions", ("folds_deg", 1), 1e-4, "0.5"),
        ("fig-6-rising", ("theta0_deg", None), -1e-4, "0.7"),
        ("fig-6-falling", ("jump of the other state at theta0_deg", None), 1e-4, "0.7"),
    ],
)
def test_folds_of_figures_4_and_5(
    id: str, place: tuple[str, int | None], side: float, mu0: str
) -> None:
    stated = value(id, place[0]) if place[1] is None else value(id, place[0])[place[1]]
    found = refined(
        {"theta": near(stated + side, mu0=float(mu0)), "theta0": float(np.radians(stated))},
        2,
        mu0=mu0,
    )
    assert float(mpmath.degrees(found["theta0"])) == pytest.approx(stated, rel=1e-11)
    p = BASE | {"mu0": float(mu0)}
    assert [counted(np.radians(stated + step), **p) for step in (side, -side)] == [3, 1]


@pytest.mark.thorough
def test_cusp_by_residuals() -> None:
    start = {
        "theta": 1.1,
        "theta0": np.radians(value("fig-12-cusp", "theta0_deg")),
        "mu0": value("fig-12-cusp", "mu0"),
    }
    start["theta"] = float(ss.cusps(ss.Parameters.article()).theta[2])
    found = refined(start, 3)
    assert float(mpmath.degrees(found["theta0"])) == pytest.approx(
        value("fig-12-cusp", "theta0_deg"), rel=1e-11
    )
    assert float(found["mu0"]) == pytest.approx(value("fig-12-cusp", "mu0"), rel=1e-11)
    low, high = value("fig-12-cusp", "two jumps for theta0_deg from, to")
    for angle, turns in ((low - 0.3, 1), (low + 0.3, 2), (high - 1, 2), (high + 0.1, 0)):
        counts = [
            counted(np.radians(angle), **BASE | {"mu0": mu0}) for mu0 in np.linspace(1e-5, 0.6, 150)
        ]
        assert sum(one != other for one, other in itertools.pairwise(counts)) == turns, angle


@pytest.mark.parametrize(
    ("name", "id"),
    [
        ("beta", "fig-8-beta-2"),
        *(
            pytest.param(*one, marks=pytest.mark.thorough)
            for one in (("alpha", "fig-9-alpha-0.07"), ("sigma", "fig-10-sigma-0.01"))
        ),
    ],
)
def test_yes_or_no_of_figures_8_to_10(name: str, id: str) -> None:
    """At the critical value there is a cusp at μ₀ = 0.5; and each curve, followed by the nearest
    state, jumps or does not.
    """
    critical = value(id, f"critical {name}")
    cusp = ss.cusps(ss.Parameters.article(**{name: critical}))
    at = int(np.argmin(np.abs(cusp.mu0 - 0.5)))
    found = refined({"theta": cusp.theta[at], "theta0": cusp.theta0[at], name: critical}, 3)
    assert float(found[name]) == pytest.approx(critical, rel=1e-11)
    for row in (
        row
        for row in record().values()
        if row["id"].startswith(id.rsplit("-", 1)[0]) and "mu_cusp" in row["values"]
    ):
        sample = float(row["id"].rsplit("-", 1)[1])
        x = ss.equilibria(
            ss.Parameters.article(theta0=np.radians(np.linspace(0.5, 120, 5_000)), **{name: sample})
        ).x
        state, largest = np.nanmin(np.abs(x[0])), 0.0
        for states in x[1:]:
            following = states[np.nanargmin(np.abs(states - state))]
            largest, state = max(largest, abs(following - state)), following
        assert (
            (largest > 0.3)
            == ("jump at theta0_deg" in row["values"])
            == row["outcome"].startswith("it jumps")
        )


# ------------------------------------------------------------------------------------------------
# jumps


@pytest.mark.thorough
def test_jumps_of_figure_6() -> None:
    p = ss.Parameters.article(mu0=0.7)
    at = value("fig-6-rising", "theta0_deg")
    before, after = (
        ss.equilibria(p.replace(theta0=np.radians(at + step))) for step in (-1e-9, 1e-9)
    )
    assert (int(before.count), int(after.count)) == (3, 1)
    assert before.x[0] == pytest.approx(value("fig-6-rising", "x before"), abs=1e-4)
    assert after.x[0] == pytest.approx(value("fig-6-rising", "x after"), abs=5e-9)

    # Falling: the nearest state on a fine grid never moves far, and grows where it is said to.
    angles = np.linspace(179.9, 0.1, 20_000)
    x = ss.equilibria(p.replace(theta0=np.radians(angles))).x
    path = [x[0, np.nanargmin(np.abs(x[0]))]]
    for states in x[1:]:
        path.append(states[np.nanargmin(np.abs(states - path[-1]))])
    steps = np.diff(path)
    assert np.abs(steps).max() < 1e-3
    high, low = value("fig-6-falling", "x grows from theta0_deg, to")
    assert (steps[(angles[1:] < high - 1) & (angles[1:] > low + 1)] > 0).all()


@pytest.mark.parametrize(
    ("id", "name", "theta0_deg", "step"),
    [
        ("fig-13a", "jump rising at mu0", 60, 1e-9),
        ("fig-13a", "jump falling at mu0", 60, -1e-9),
        ("fig-13b", "jump rising at mu0", 40, 1e-9),
    ],
)
def test_jumps_of_figure_13(id: str, name: str, theta0_deg: float, step: float) -> None:
    mu0 = value(id, name)
    p = ss.Parameters.article(theta0=np.radians(theta0_deg))
    inside, beyond = (ss.equilibria(p.replace(mu0=mu0 + side)) for side in (-step, step))
    assert (int(inside.count), int(beyond.count)) == (3, 1)
    start = near(theta0_deg, mu0=mu0 - 1e4 * step)
    with mpmath.workdps(40):
        found = refined({"theta": start, "mu0": mu0}, 2, theta0=mpmath.radians(theta0_deg))["mu0"]
    assert float(found) == pytest.approx(mu0, rel=1e-11)
    alone = np.linspace(mu0, 1.0, 50)[1:] if step > 0 else np.linspace(0.0, mu0, 50)[1:-1]
    assert (ss.equilibria(p.replace(mu0=alone)).count == 1).all()


# ------------------------------------------------------------------------------------------------
# stability


@pytest.mark.parametrize("sigma", [0.1, 1.0])
def test_stability_by_eigenvalues(sigma: float) -> None:
    rng = np.random.default_rng(7)
    theta0, mu0 = np.radians(rng.uniform(1, 179, 150)), rng.uniform(0, 1, 150)
    eq = ss.equilibria(ss.Parameters.article(theta0=theta0, mu0=mu0, sigma=sigma))
    for i, slot in zip(*np.nonzero(eq.undamped), strict=True):
        p = BASE | {"mu0": mu0[i], "sigma": sigma}
        assert (
            kind(spring_eigenvalues(eq.x[i, slot], eq.y[i, slot], theta0[i], **p))
            == eq.undamped[i, slot]
        )
    kinds = {
        ss.EquilibriumType(code).name.lower() for code in np.unique(eq.undamped[eq.undamped > 0])
    }
    assert kinds == set(value("fig-4-stability", "of three")) | (
        {"flutter"} if sigma == 1.0 else set()
    )


def test_states_that_grow_with_the_slope_of_the_law() -> None:
    """What (27) leaves out, with matrices written by hand: of three states the first is stable, and
    the others, and a single one, grow.
    """
    told = {
        3: value("fig-4-stability", "of three, damped"),
        1: value("fig-4-stability", "of one, damped"),
    }
    given = BASE | {"theta0": np.radians(np.linspace(1.0, 179.0, 60)), "V": 0.5, "d": 10.0}
    eq = ss.equilibria(ss.Parameters(**given))
    rows = eq.states
    K, C = damped_states.linearizations(
        eq.x[rows], eq.y[rows], given | {"theta0": given["theta0"][rows[0]]}
    )
    growth = damped_states.eigenvalues(K, C).real.max(axis=-1)
    for point, slot, rate in zip(*rows, growth, strict=True):
        assert told[int(eq.count[point])][slot] == ("stable" if rate < 0 else "unstable")
    # Of Figure 11: the share that grows, at other points.
    rng = np.random.default_rng(5)
    p = ss.Parameters.article(theta0=np.radians(rng.uniform(0, 180, 4000)), mu0=rng.random(4000))
    eq = ss.equilibria(p)
    sign, three = eq["growth_sign"], eq.count == 3
    for found, names in (
        (sign[three][:, 2], ("states on the upper surface", "that grow")),
        (sign[~three][:, 0], ("single states", "single ones that grow")),
    ):
        all_of_them, grow = (value("fig-11", name) for name in names)
        assert (found == 1).mean() == pytest.approx(grow / all_of_them, abs=0.03)


def test_the_rows_of_sections_1_and_4() -> None:
    """With the balance and its slopes written by hand, at other points than the rows'."""
    rng = np.random.default_rng(3)
    for stiffer in (1.0, 1e5):
        p = BASE | {name: BASE[name] / stiffer for name in ("kappa", "alpha", "sigma")}
        given = p | {"theta0": rng.uniform(0.01, 3.1, 200), "mu0": rng.uniform(0.01, 40.0, 200)}
        eq = ss.equilibria(ss.Parameters(**given))
        point, slot = eq.states
        at = given | {name: given[name][point] for name in ("theta0", "mu0")}
        K, _ = damped_states.linearizations(
            eq.x[point, slot], eq.y[point, slot], at | {"V": 0.5, "d": 10.0}
        )
        assert K[:, 0, 1] - K[:, 1, 0] == pytest.approx(at["mu0"])
        most = (p["kappa"] + p["sigma"] * (1 - np.sin(at["theta0"]))).max()
        assert (-eq.y[point, slot]).max() <= most
    assert max(value("claim-paradox", "largest N over F_L + k L_0 (1 - sin theta0)")) <= 1
    fold, (_, along) = (
        value("claim-stiffness", name) for name in ("fold at mu0", "K_11 at mu0 = 0, at the fold")
    )
    eq = ss.equilibria(ss.Parameters.article(theta0=np.radians(52.0), mu0=fold * (1 - 1e-9)))
    K = stiffness(eq.x[0], eq.y[0], np.radians(52.0), **BASE | {"mu0": fold})
    assert np.linalg.det(K) == pytest.approx(0.0, abs=1e-4)
    assert K[0, 0] == pytest.approx(along, rel=1e-3)


def test_hopf_points_of_figure_14() -> None:
    """A pair of eigenvalues of the matrices written by hand crosses at each."""
    for onset in value("fig-14", "Hopf points of (8) to (11) at theta0_deg"):
        given = BASE | {"sigma": 1.0, "V": 0.5, "d": 10.0}
        given["theta0"] = np.radians(onset + np.array([-0.1, 0.1]))
        eq, unstable = ss.equilibria(ss.Parameters(**given)), []
        for k in range(2):
            slots = [np.full(int(eq.count[k]), k), np.arange(int(eq.count[k]))]
            at = given | {"theta0": given["theta0"][k]}
            every = damped_states.eigenvalues(
                *damped_states.linearizations(eq.x[*slots], eq.y[*slots], at)
            )
            unstable.append(int((every.real > 0).sum()))
        assert abs(np.diff(unstable)) == 2


@pytest.mark.parametrize(
    ("id", "changes", "inwards"),
    [("fig-9-flutter", {"alpha": 0.7}, 1), ("fig-10-flutter", {"sigma": 1.0}, -1)],
)
def test_flutter_by_eigenvalues(id: str, changes: dict[str, float], inwards: int) -> None:
    for onset, side in zip(value(id, "onsets_deg"), (inwards, -inwards), strict=True):
        kinds = []
        for step in (-1e-4, 1e-4):
            theta0 = np.radians(onset + step * side)
            eq = ss.equilibria(ss.Parameters.article(theta0=theta0, **changes))
            last = int(eq.count) - 1
            kinds.append(kind(spring_eigenvalues(eq.x[last], eq.y[last], theta0, **BASE | changes)))
        assert kinds == [ss.EquilibriumType.STABLE, ss.EquilibriumType.FLUTTER]
    if "alpha" in changes:
        growth = {}
        for angle in np.arange(149.0, 152.5, 0.02):
            eq = ss.equilibria(ss.Parameters.article(theta0=np.radians(angle), **changes))
            eigenvalues = spring_eigenvalues(eq.x[0], eq.y[0], np.radians(angle), **BASE | changes)
            growth[angle] = np.sqrt(-eigenvalues.astype(complex)).real.max()
        assert max(growth, key=growth.__getitem__) == pytest.approx(
            value(id, "fastest growth at theta0_deg"), abs=0.03
        )


def test_lift_off() -> None:
    """All states without contact by Newton's method from 200 random starts."""
    theta0, rng, found = np.radians(49.0), np.random.default_rng(3), set()
    for start in rng.uniform(-3, 3, (200, 2)):
        state = root(
            lambda z: forces(*z, theta0, **BASE, contact=False), start, method="lm", tol=1e-14
        ).x
        if state[1] >= 0 and np.abs(forces(*state, theta0, **BASE, contact=False)).max() < 1e-12:
            found.add(tuple(np.round(state, 8)))
    assert len(found) == value("fig-4-lift-off", "count") == 1
    ((x, y),) = found
    assert y == pytest.approx(value("fig-4-lift-off", "y at 49 deg"), abs=1e-7)
    assert np.hypot(np.cos(theta0) - x, np.sin(theta0) - y) == pytest.approx(
        value("fig-4-lift-off", "L at 49 deg"), abs=1e-7
    )
    assert (
        kind(spring_eigenvalues(x, y, theta0, contact=False, **BASE))
        == ss.EquilibriumType.DIVERGENT
    )


# ---------------------------------------------------------------------------------------------
# counts and bounds


def test_equation_21_has_one_root_too_many() -> None:
    """The quartic as the determinant condition |adj(D) b|² = det(D)², with NumPy's polynomials in
    L.
    """
    P = np.polynomial.Polynomial
    cases = [
        (angle, BASE, *counts)
        for angle, *counts in zip(
            *(
                value("claim-roots-of-21", name)
                for name in ("theta0_deg", "real roots", "equilibria")
            ),
            strict=True,
        )
    ]
    more = ("real roots at 90 deg, mu0 = sigma = 1", "equilibria there")
    counts = [value("claim-roots-of-21", name) for name in more]
    cases.append((90.0, BASE | {"mu0": 1.0, "sigma": 1.0}, *counts))
    for angle, p, real, count in cases:
        mu0, kappa, alpha, sigma, beta = (p[name] for name in BASE)
        c0, s0 = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        D11, D12, D22 = P([sigma, -(sigma + alpha)]), P([0, -mu0]), P([sigma, -(sigma + beta + 1)])
        b1, b2 = -alpha * c0 - mu0 * s0, -(beta + 1) * s0 - kappa
        first, second, determinant = D22 * b1 - D12 * b2, D11 * b2, D11 * D22
        roots = (first**2 + second**2 - determinant**2).roots()
        roots = roots[np.abs(roots.imag) < 1e-9].real
        sliding = [L > 0 and s0 - L * second(L) / determinant(L) < 0 for L in roots]
        assert (len(roots), sum(sliding)) == (real, count)


def test_contact_force_is_bounded() -> None:
    rng, ratios = np.random.default_rng(11), []
    n = 3000
    theta0 = rng.uniform(0.01, 3.13, n)
    sides = {"mu0": rng.uniform(0, 5, n), "beta": rng.uniform(0, 2, n)}
    sides |= {name: 10 ** rng.uniform(-3, 0, n) for name in ("kappa", "alpha", "sigma")}
    eq = ss.equilibria(ss.Parameters(theta0=theta0, **sides))
    for i, slot in zip(*np.nonzero(eq.undamped), strict=True):
        p = {name: side[i] for name, side in sides.items()}
        along, across = forces(eq.x[i, slot], eq.y[i, slot], theta0[i], **p)
        assert abs(along) + abs(across) < 1e-9 * (1 + abs(eq.x[i, slot]))
        bound = p["kappa"] + p["sigma"] * (1 - np.sin(theta0[i]))
        ratios.append(-eq.y[i, slot] * (1 + p["beta"] + p["sigma"]) / bound)
    assert 0.999 < max(ratios) <= 1 + 1e-12
    assert value("claim-bounded", "contact force never above") == pytest.approx(
        0.107 / 1.1, rel=1e-7
    )


# ------------------------------------------------------------------------------------------------
# linear model


def linear_stiffness(theta0: float, mu0: float) -> Any:
    """K at the undeformed state."""
    return stiffness(0.0, 0.0, theta0, **BASE | {"mu0": mu0})


def linear_state(theta0: float, mu0: float) -> Any:
    return np.linalg.solve(linear_stiffness(theta0, mu0), [0.0, -BASE["kappa"]])


def test_critical_friction_of_the_linear_model() -> None:
    angles = np.linspace(1.29, 1.33, 801)
    critical = value("claim-mu-cr", "mu_cr")
    assert value("claim-mu-cr", "0.58 - mu_cr") == pytest.approx(0.58 - critical, abs=1e-12)
    # det K is a + μ₀ b for each angle; the smallest −a/b with b < 0 is the friction at which a pole
    # appears.
    at_zero, at_one = (
        [np.linalg.det(linear_stiffness(angle, mu0)) for angle in angles] for mu0 in (0.0, 1.0)
    )
    frictions = np.array(at_zero) / (np.array(at_zero) - np.array(at_one))
    assert frictions.min() == pytest.approx(critical, abs=1e-6)
    x = np.array([linear_state(angle, 0.5)[0] for angle in angles + 0.03])
    assert x.max() == pytest.approx(value("fig-5-bounded", "largest x at mu0 = 0.5"), abs=1e-5)
    assert np.degrees(angles[x.argmax()] + 0.03) == pytest.approx(
        value("fig-5-bounded", "at theta0_deg"), abs=0.01
    )


def test_poles_of_the_linear_model() -> None:
    poles = value("fig-5-poles", "poles_deg")
    for pole, guess in zip(poles, ((60, 70), (75, 90)), strict=True):
        crossing = brentq(
            lambda angle: np.linalg.det(linear_stiffness(np.radians(angle), 0.7)), *guess
        )
        assert crossing == pytest.approx(pole, abs=1e-6)
    assert [value("fig-6-linear", name) for name in ("from_deg", "to_deg")] == poles
    pressed = [
        linear_state(np.radians(angle), 0.7)[1] < 0
        for angle in (50, poles[0] - 0.1, 70, poles[1] + 0.1)
    ]
    assert pressed == [True, True, False, True]


@pytest.mark.parametrize("mu0", [0.5, 0.7])
def test_where_the_linear_model_is_good(mu0: float) -> None:
    for angle in value("fig-5-approximation", f"within 10 % at mu0 = {mu0:g} below, above (deg)"):
        theta0 = np.radians(angle)
        x, _ = linear_state(theta0, mu0)
        guess = linear_state(theta0, mu0)
        state = root(
            lambda z, theta0=theta0: forces(*z, theta0, **BASE | {"mu0": mu0}),
            guess,
            method="lm",
            tol=1e-14,
        ).x
        assert abs(x - state[0]) / abs(state[0]) == pytest.approx(0.1, abs=1e-6)


# ------------------------------------------------------------------------------------------------
# motion


def motion(
    theta0_deg: float, start: Any, t_end: float, rtol: float = 1e-8, d: float = 10.0, V: float = 0.5
) -> Any:
    """(8) to (11) with SciPy, kinks and all."""
    p = ss.Parameters.article(theta0=np.radians(theta0_deg))
    return article_motion.integrated(
        p, V, d, start, t_end, rtol=rtol, atol=1e-9, dense_output=True, max_step=5.0
    )


def rms(solution: Any, begin: float, end: float) -> float:
    t = np.linspace(begin, end, 20_001)
    return float(np.sqrt(np.mean(solution.sol(t)[0] ** 2)))


def test_friction_at_steady_sliding() -> None:
    assert value("fig-3", "friction at steady sliding over mu0") == pytest.approx(
        float(1 - mpmath.exp(-5)), abs=1e-12
    )


def test_limit_cycle_by_another_integrator() -> None:
    """One period from a late state of the motion leads back to it; the equilibrium's fastest mode
    grows as stated.
    """
    late = simulate(
        ss.Parameters.article(theta0=np.radians(49)), V=0.5, d=10.0, t_end=8500.0
    ).after(8000.0)
    start, period = late.state[:, 0], value("fig-7a", "period")
    solution = motion(49.0, start, period, rtol=1e-9)
    assert np.abs(solution.y[:, -1] - start).max() < 5e-3
    assert np.abs(solution.sol(np.linspace(0, period, 40_001))[0]).max() == pytest.approx(
        value("fig-7a", "largest |x|"), abs=1e-3
    )
    x = value("fig-7a", "x of the only equilibrium")
    growth = value("fig-7a", "its growth rate with the friction law's damping")
    assert growth_by_hand(49.0, x) == pytest.approx(growth, rel=1e-4)


def growth_by_hand(theta0_deg: float, x: float) -> float:
    """Largest real part at the equilibrium with that x, of the linearized equations of motion."""
    law = constants(np.radians(theta0_deg), BASE, V=0.5, d=10.0)
    at = root(
        lambda q: article_motion.accelerations((*q, 0.0, 0.0), law, True, 1.0),
        (x, -0.05),
        tol=1e-14,
    ).x
    slopes = article_motion.slopes((*at, 0.0, 0.0), law, True, 1.0)
    return float(np.linalg.eigvals([[0, 0, 1, 0], [0, 0, 0, 1], *slopes]).real.max())


@pytest.mark.thorough
def test_amplitude_jump_by_another_integrator() -> None:
    at = value("fig-7b", "theta0_deg")
    low, high = (rms(motion(at + step, [0, 0, 0, 0], 900.0), 600, 900) for step in (-0.002, 0.002))
    assert low < 0.3 < 1.5 < high
    fold = value("fig-4-regions", "folds_deg")[0]
    assert value("fig-7b", "before the fold by (deg)") == pytest.approx(fold - at, abs=0.006)


@pytest.mark.thorough
def test_the_fate_of_rest() -> None:
    """On both sides of it by another integrator; the saddle is an equilibrium by forces alone."""
    at = value("fig-7b-fate", "theta0_deg")
    low, high = (rms(motion(at + step, [0, 0, 0, 0], 500.0), 300, 500) for step in (-1e-5, 1e-5))
    assert low < 0.3 < 0.8 < high
    names = ("V of other belts", "d of other belts", "theta0_deg with these")
    for V, d, place in zip(*(value("fig-7b-fate", name) for name in names), strict=True):
        low, high = (
            rms(motion(place + step, [0, 0, 0, 0], 500.0, V=V, d=d), 300, 500)
            for step in (-1e-4, 1e-4)
        )
        assert low < 0.4 < 0.7 < high
    growth = growth_by_hand(at, value("fig-7b-fate", "x of the saddle"))
    assert growth == pytest.approx(value("fig-7b-fate", "its growth rate"), rel=1e-7)


@pytest.mark.thorough
def test_the_oscillation_far_below_the_fold() -> None:
    """One round by another integrator, from a state of the cycle, leads back to it."""
    periods = value("fig-7-oscillation", "periods")
    near: Any = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)
    for degrees, period in zip((40.0, 30.0, 20.0, 10.0), reversed(periods), strict=True):
        near = ss.cycle(ss.Parameters.article(theta0=np.radians(degrees)), V=0.5, d=10.0, near=near)
        end = motion(degrees, near.state, period, rtol=1e-9).y[:, -1]
        assert np.abs(end - near.state).max() < 1e-4
        if degrees == 30.0:
            names = ("V of other belts", "d of other belts", "periods with these at 30 degrees")
            for V, d, other in zip(
                *(value("fig-7-oscillation", name) for name in names), strict=True
            ):
                there = ss.cycle(
                    ss.Parameters.article(theta0=np.radians(30.0)), V=V, d=d, near=near
                )
                assert there.stable
                assert (
                    np.abs(
                        motion(30.0, there.state, other, rtol=1e-9, V=V, d=d).y[:, -1] - there.state
                    ).max()
                    < 1e-4
                )
    assert max(value("fig-7-oscillation", "largest multipliers")) < 1


def test_equilibria_without_d() -> None:
    """Their number by a companion matrix, in which there is no d; how the first grows with ours, by
    hand.
    """
    for degrees, count, x, growth in zip(
        *record()["fig-4-dry-friction"]["values"].values(), strict=True
    ):
        assert counted(np.radians(degrees), **BASE) == count
        assert growth_by_hand(degrees, x) == pytest.approx(growth, rel=0.05)


@pytest.mark.validate
def test_the_oscillation_under_dry_friction() -> None:
    """One round by the event-driven driver leads back; what sticks does so for as long as is
    said.
    """
    found = record()["fig-7-dry-friction"]["values"]
    rounds = [*zip(found["theta0_deg"], found["periods"], strict=True), (60.0, found["its period"])]
    near: Any = (2.9429144682, 3.3611284180, 0.0, 0.3671196394)
    for degrees, period in rounds:
        values = {**BASE, "ratio": 1.0, "V": 0.5, "theta0": np.radians(degrees)}
        near = (2.818, 1.213, 0.0, 0.22) if degrees == 60.0 else near
        near = ss.cycle(ss.load("coulomb").Parameters(theta0=values["theta0"]), near=near)
        driver = dry_friction.Driver("coulomb", values)
        assert np.abs(driver.run(near.state, period) - near.state).max() < 1e-6
        held = [t for event, t, _ in driver.events if event in ("STICK", "SLIP")]
        assert sum(np.diff(held)) == pytest.approx(
            found["it sticks for"] if degrees == 60.0 else 0.0, abs=1e-6
        )


# ------------------------------------------------------------------------------------------------
# the ledger


def test_cross_references() -> None:
    """What the wrong references point at, as printed."""
    from spragsym.derive.kang_nam import article

    printed = {entry.id: entry.text for entry in article.printed().statements}
    assert "L" in printed["eq-26"]
    assert "d_4" in printed["eq-26"]
    assert "mathbf" in printed["eq-22"]
    assert "d_4" not in printed["eq-22"]
    assert value("claim-reference-22", "polynomials") == ["eq-21", "eq-26"]
    assert value("claim-reference-12", "equations with accelerations") == ["eq-8", "eq-9"]
    assert value("claim-reference-10", "what varies along a-a'") == "mu0"


def test_statuses() -> None:
    by_status = defaultdict(set)
    for id, row in record().items():
        by_status[row["status"]].add(id)
    assert by_status["not reproduced"] == set()
    assert by_status["input not stated"] == {
        "fig-3",
        "fig-7a",
        "fig-7b",
        "fig-7b-fate",
        "fig-7-dry-friction",
    }
    # A wrong number of an equation or a figure is another matter than a wrong statement.
    assert by_status["misprint"] == {
        "claim-reference-10",
        "claim-reference-12",
        "claim-reference-22",
    }
    corrected = {
        "claim-must-jump",
        "claim-potential",
        "claim-roots-of-21",
        "fig-4-stability",
        "fig-7-oscillation",
        "fig-11",
        "fig-14",
    }
    assert by_status["corrected"] == corrected
    assert all(row["consequence"] for id, row in record().items() if id.startswith("fig-7"))
    assert len(by_status["reproduced"]) == 29


#: Rows that stand on 25 motions to τ = 2000 and on the saddles between oscillation and rest.
LONG_MOTIONS = ("fig-7b", "fig-7b-fate")


@pytest.mark.parametrize(
    "long",
    [
        pytest.param(False, marks=pytest.mark.thorough),
        pytest.param(True, marks=pytest.mark.validate),
    ],
)
def test_nothing_has_drifted(long: bool) -> None:
    if long and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    statements = [one for one in claims.STATEMENTS if (one.id in LONG_MOTIONS) == long]
    recorded = [row for row in claims.recorded() if (row["id"] in LONG_MOTIONS) == long]
    assert len(statements) == len(recorded) > 1
    assert claims.drifted(claims.run(statements), recorded) == []


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({"status": "corrected"}, "claim-mu-cr: status is 'reproduced', not 'corrected'"),
        (
            {"values": {"mu_cr": 0.574073166169, "0.58 - mu_cr": 0.00592683393142}},
            "mu_cr = 0.574073166069, not 0.574073166169",
        ),
        ({"values": {"0.58 - mu_cr": 0.00592683393142}}, "mu_cr = 0.574073166069, not None"),
    ],
)
def test_a_drift_is_seen(change: dict[str, Any], line: str) -> None:
    (statement,) = (one for one in claims.STATEMENTS if one.id == "claim-mu-cr")
    rows = claims.run([statement])
    (row,) = (row for row in claims.recorded() if row["id"] == "claim-mu-cr")
    assert claims.drifted(rows, [row]) == []
    assert any(line in told for told in claims.drifted(rows, [row | change]))


def test_every_row_names_a_test_and_a_command_that_exist() -> None:
    for row in record().values():
        path, name = row["test"].split("::")
        assert f"\ndef {name}(" in (ROOT / path).read_text(encoding="utf-8"), row["id"]
        program, command, *arguments = row["command"].split()
        assert program == "spragsym"
        found = cli.get_command(click.Context(cli), command)
        assert found is not None
        found.make_context(command, arguments)  # an error if an option is unknown


COMMITTED = (ROOT / "docs" / "reproduction.md").read_text(encoding="utf-8")


def test_every_figure_says_with_what_it_was_compared() -> None:
    rows = re.split(r"^### ", COMMITTED, flags=re.MULTILINE)[1:]
    figures = [row for row in rows if row.startswith("fig-")]
    assert len(figures) > 30
    assert all(row.count("\n- compared with: ") == 1 for row in figures)


def test_the_report_is_as_committed(tmp_path: Path) -> None:
    result = CliRunner().invoke(check_command, ["--report", str(tmp_path / "page.md")])
    assert result.exit_code == 0
    assert (tmp_path / "page.md").read_text(encoding="utf-8") == COMMITTED, (
        "spragsym check --report docs/reproduction.md"
    )
