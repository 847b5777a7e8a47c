"""One function for each statement of statements.toml, which names it: it returns whether the
statement's outcome holds, and the values behind that.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import OptimizeResult, brentq, minimize_scalar

from .. import precise
from ..bifurcation.bifurcation_sets import bifurcation_set
from ..bifurcation.critical import critical_friction, critical_value, cusp_friction
from ..bifurcation.flutter import flutter_onsets
from ..bifurcation.folds import folds
from ..bifurcation.paths import quasi_static_path
from ..design.jumps import jump_value
from ..generated import equilibrium as _equilibrium
from ..kang_nam import kernel
from ..kang_nam.flutter import flutter_boundary
from ..kang_nam.parameters import Parameters
from ..kang_nam.steady_sliding import linear_critical_friction, linear_sprag
from ..models import load
from ..models.parameters import FloatArray, ParameterSet
from ..motion import Regime, simulate
from ..motion.sweeps import sensitivity
from ..numerics.polynomials import primitive, real_roots, root_bound
from ..orbits import Cycle, cycle, fate_boundary
from ..orbits.system import System
from ..results import Equilibria, EquilibriumType, Jump
from ..statics.equilibria import equilibria
from .assumed import MU0_RANGE, ON_CYCLE, D, V
from .ledger import printed, rounded

#: Whether the statement's outcome holds, and the values behind that by their names.
Outcome: TypeAlias = tuple[Any, dict[str, Any]]
#: V and d of other belts than ours, since the article states neither value; with these too the
#: motion from rest ends either at rest or in an oscillation.
OTHER_BELTS = ((0.3, 10.0), (0.5, 5.0), (0.4, 12.5))


_article = Parameters.article
#: Inclinations of grids, degrees.
_GRID = np.linspace(0.1, 179.9, 900)
#: Inclinations of a quasi-static path, radians, rising.
_RISING = np.radians(np.linspace(0.1, 179.9, 361))
#: Frictions of the article's figures, rising.
_FRICTIONS = np.linspace(*MU0_RANGE, 201)
_deg = np.degrees
#: Parameters of K of (28), as of ``kernel.stiffness``.
_IN_STIFFNESS = ("mu0", "alpha", "sigma", "beta")


def _at(degrees: ArrayLike, **changes: Any) -> Parameters:
    """The article's parameters at some inclinations, with changes to others."""
    return _article(theta0=np.radians(degrees), **changes)


# ------------------------------------------------------------------------------------------------
# the linear model


def linear_critical() -> Outcome:
    value = float(linear_critical_friction(_article()))
    return abs(0.58 - value) <= 0.02 * 0.58, {"mu_cr": value, "0.58 - mu_cr": 0.58 - value}


def linear_bounded() -> Outcome:
    frictions = linear_critical_friction(_article()) * np.append(
        np.linspace(0.0, 0.999, 200), 1 - 1e-9
    )
    model = linear_sprag(_at(_GRID, mu0=frictions[:, None]))
    peak = _highest(lambda angle: linear_sprag(_article(theta0=angle)).x, 1.2, 1.5)
    holds = np.isnan(model.poles).all() and (model.determinant > 0).all() and (model.y < 0).all()
    return holds, {"largest x at mu0 = 0.5": -peak.fun, "at theta0_deg": _deg(peak.x)}


def _highest(of: Callable[[float], Any], low: float, high: float) -> OptimizeResult:
    """The maximum of a function between two values; ``fun`` is its negative."""
    return minimize_scalar(
        lambda at: -float(of(at)), bounds=(low, high), method="bounded", options={"xatol": 1e-10}
    )


def _poles() -> FloatArray:
    """Inclinations at which the linear model's displacements are infinite, for μ₀ = 0.7."""
    return np.sort(linear_sprag(_article(theta0=1.0, mu0=0.7)).poles)


def linear_poles() -> Outcome:
    poles = _poles()
    outside = linear_sprag(_article(theta0=poles + np.array([-1e-9, 1e-9]), mu0=0.7))
    return (-outside.y > 1e5).all(), {"poles_deg": _deg(poles)}


def no_linear_sliding() -> Outcome:
    low, high = poles = _poles()
    angles = np.append(np.radians(_GRID), np.add.outer(poles, [-1e-6, 1e-6]))
    model = linear_sprag(_article(theta0=angles, mu0=0.7))
    between = np.searchsorted(poles, angles) == 1
    holds = ((model.y > 0) == between).all() and ((model.determinant < 0) == between).all()
    return holds, {"from_deg": _deg(low), "to_deg": _deg(high)}


def _linear_gap(angle: FloatArray, mu0: float) -> FloatArray:
    """Relative difference of x between the linear model and the nonlinear state of smallest |x|,
    less a tenth: negative where they agree within 10 %.
    """
    p = _article(theta0=angle, mu0=mu0)
    x = equilibria(p).x
    near = np.take_along_axis(x, np.nanargmin(np.abs(x), axis=-1)[..., None], axis=-1)[..., 0]
    return np.abs(linear_sprag(p).x - near) / np.abs(near) - 0.1


def linear_approximates() -> Outcome:
    values, holds = {}, True
    for mu0 in (0.5, 0.7):
        gaps = _linear_gap(np.radians(_GRID), mu0)
        (changes,) = np.nonzero(np.diff(np.sign(gaps)))
        pairs = (np.radians(_GRID[[i, i + 1]]) for i in changes[[0, -1]])
        below, above = ends = [
            brentq(_linear_gap, *pair, args=(mu0,), xtol=1e-14) for pair in pairs
        ]
        values[f"within 10 % at mu0 = {mu0:g} below, above (deg)"] = _deg(ends)
        holds &= (
            below < folds(_article(mu0=mu0)).theta0[0] < above < math.radians(150)
            and gaps[0] < 0
            and gaps[-1] < 0
        )
    return holds, values


# ------------------------------------------------------------------------------------------------
# equilibria in contact


def one_or_three() -> Outcome:
    seen: set[int] = set()
    for changes in (
        {},
        {"beta": 1.0},
        {"beta": 2.0},
        {"alpha": 0.07},
        {"alpha": 0.7},
        {"sigma": 0.01},
        {"sigma": 1.0},
    ):
        seen |= set(
            equilibria(_at(_GRID, **changes, mu0=_FRICTIONS[::5, None])).count.ravel().tolist()
        )
    unproved = [step["claim"] for step in printed()["one_or_three"] if not step["holds"]]
    return seen == {1, 3} and not unproved, {
        "counts": sorted(seen),
        "steps of the proof that fail": len(unproved),
    }


def bounded() -> Outcome:
    p = _at(_GRID, mu0=_FRICTIONS[::5, None])
    eq = equilibria(p)
    bound = (p.kappa + p.sigma * (1 - np.sin(p.theta0))) / (1 + p.beta + p.sigma)
    largest, far = (p.kappa + p.sigma) / (1 + p.beta + p.sigma), np.nanmax(np.abs(eq.x))
    holds = (np.nanmax(-eq.y, axis=-1) <= bound * (1 + 1e-12)).all() and far < 2
    return holds, {"contact force never above": float(largest), "largest |x| for mu0 <= 1": far}


def base_regions() -> Outcome:
    turns = _deg(folds(_article()).theta0)
    expected = np.where(np.searchsorted(turns, _GRID) == 1, 1, 3)
    return (equilibria(_at(_GRID)).count == expected).all(), {
        "folds_deg": turns,
        "counts": [3, 1, 3],
    }


def base_stability() -> Outcome:
    eq = equilibria(_at(_GRID))
    three, sign = eq.count == 3, eq["growth_sign"]
    damped = (sign[three] == [-1, 1, 1]).all() and (sign[~three][:, 0] == 1).all()
    return _middle_diverges(eq) and damped, {
        "of three": ["stable", "divergent", "stable"],
        "of one": ["stable"],
        "of three, damped": ["stable", "unstable", "unstable"],
        "of one, damped": ["unstable"],
    }


def _middle_diverges(eq: Equilibria) -> bool:
    """Whether the middle one of three states is divergent and the outer two are stable, and a
    single state is stable.
    """
    stable, three = EquilibriumType.STABLE, eq.undamped[eq.count == 3]
    return bool(
        (three == [stable, EquilibriumType.DIVERGENT, stable]).all()
        and (eq.undamped[eq.count == 1][:, 0] == stable).all()
    )


def lift_off() -> Outcome:
    eq, at = (equilibria(_at(degrees), contact=False) for degrees in (_GRID, 49.0))
    divergent = (eq.undamped[:, 0] == EquilibriumType.DIVERGENT).all()
    holds = (eq.count == 1).all() and divergent and (eq.y[:, 0] >= 0).all()
    return holds, {
        "count": 1,
        "stability": "divergent",
        "L at 49 deg": at.L[0],
        "y at 49 deg": at.y[0],
    }


def roots_of_21() -> Outcome:
    """The number of real roots of the quartic in L, counted exactly, beside that of equilibria."""
    angles = (30, 49, 90, 160)
    # With these four roots are real beside a single equilibrium.
    beyond = _at(90.0, mu0=1.0, sigma=1.0)
    real = [_real_roots(_at(angle)) for angle in angles]
    sliding, alone = equilibria(_at(angles)).count, int(equilibria(beyond).count)
    more = _real_roots(beyond)
    return np.array_equal(real, sliding + 1) and (more, alone) == (4, 1), {
        "theta0_deg": angles,
        "real roots": real,
        "equilibria": sliding,
        "real roots at 90 deg, mu0 = sigma = 1": more,
        "equilibria there": alone,
    }


def _real_roots(p: Parameters) -> int:
    """The number of real roots of (21), counted exactly."""
    angle, *values = p.scalars("theta0", "mu0", "kappa", "alpha", "sigma", "beta")
    turned = Fraction(math.cos(angle)), Fraction(math.sin(angle))
    quartic = primitive(_equilibrium.contact_quartic(*turned, *map(Fraction, values)))
    far = root_bound(quartic)
    return len(real_roots(quartic, -far, far, 0))


# ------------------------------------------------------------------------------------------------
# what Sections 1 and 4 say of the model


def potential() -> Outcome:
    eq = equilibria(_at(_GRID))
    states = eq.states
    (_, K12), (K21, _) = kernel.stiffness(
        *kernel.cos_sin(eq.theta[states]), eq.L[states], *_article().scalars(*_IN_STIFFNESS), 1
    )
    gap = K12 - K21
    return (np.abs(gap - 0.5) < 1e-15).all(), {"K_12 - K_21 at mu0 = 0.5": rounded(gap.mean(), 12)}


def paradox_avoided() -> Outcome:
    """Contact stiffer and stiffer: the largest contact force over F_L + k L_0 (1 - sin theta0)."""
    shares, counts, stiffer = list[float](), set[int](), (1.0, 1e3, 1e6)
    for factor in stiffer:
        base = _article()
        p = base.replace(
            theta0=np.radians(_GRID),
            mu0=np.array([0.5, 5.0, 50.0])[:, None],
            **{name: base.scalars(name)[0] / factor for name in ("kappa", "alpha", "sigma")},
        )
        eq = equilibria(p)
        counts |= set(eq.count.ravel().tolist())
        limit = p.kappa + p.sigma * (1 - np.sin(p.theta0))
        shares.append(float(np.nanmax(-eq.y / limit[..., None])))
    return max(shares) <= 1 + 1e-12 and counts == {1, 3}, {
        "contact stiffer by": stiffer,
        "largest N over F_L + k L_0 (1 - sin theta0)": rounded(np.array(shares), 6),
        "counts": sorted(counts),
    }


def stiffness_varies() -> Outcome:
    """K of the reference state at 52 degrees, without friction and at the fold."""
    p = _at(52.0)
    fold = float(jump_value(p, "mu0"))
    path = quasi_static_path(p, "mu0", np.linspace(0.0, fold * (1 - 1e-9), 101))
    begin, end = (equilibria(p.replace(mu0=mu0)) for mu0 in (0.0, fold * (1 - 1e-9)))
    found = []
    for eq, x in ((begin, path.x[0]), (end, path.x[-1])):
        slot = int(np.nanargmin(np.abs(eq.x - x)))
        mu0, *springs = eq.parameters.scalars(*_IN_STIFFNESS)
        at = kernel.cos_sin(eq.theta[slot])
        K = np.array(kernel.stiffness(*at, eq.L[slot], mu0, *springs, 1))
        found.append((K[0, 0], np.linalg.det(K)))
    (along, determinant), (along_end, determinant_end) = found
    return abs(determinant_end) < 1e-4 * determinant, {
        "K_11 at mu0 = 0, at the fold": rounded(np.array([along, along_end]), 4),
        "fold at mu0": fold,
    }


# ------------------------------------------------------------------------------------------------
# jumps


def jump_rising() -> Outcome:
    (jump,) = quasi_static_path(_article(mu0=0.7), "theta0", _RISING).jumps
    before, after = jump.before["x"], jump.after["x"]  # after is taken a little beyond the fold
    holds = after > before and jump.undamped_after == EquilibriumType.STABLE
    return holds, {"theta0_deg": _deg(jump.value), "x before": before, "x after": rounded(after, 9)}


def no_jump_falling() -> Outcome:
    p = _article(mu0=0.7)
    back, large = (
        quasi_static_path(p, "theta0", _RISING[::-1], start=start) for start in ("small", "large")
    )
    ends = sorted((int(np.argmin(back.x)), int(np.argmax(back.x))))
    grows = (np.diff(back.x[slice(*ends)]) > 0).all() and back.values[ends[1]] < np.radians(2.0)
    return not back.jumps and grows and len(large.jumps) == 1, {
        "jumps on the way back": len(back.jumps),
        "x grows from theta0_deg, to": rounded(_deg(back.values[ends]), 3),
        "x there": back.x[ends],
        "jump of the other state at theta0_deg": _deg(large.jumps[0].value),
    }


def must_jump() -> Outcome:
    up, down = _up_and_down()
    turns = len(folds(_at(60.0), "mu0"))
    return turns == 2 and len(up) == len(down) == 1, {
        "folds passed each way": turns,
        "jumps": [len(up), len(down)],
    }


def _up_and_down() -> list[tuple[Jump, ...]]:
    """Jumps as the friction rises at 60°, and as it falls."""
    return [
        quasi_static_path(_at(60.0), "mu0", values).jumps
        for values in (_FRICTIONS, _FRICTIONS[::-1])
    ]


def family_row(name: str, value: float, bracket: list[float], jumps: bool) -> Outcome:
    """The yes or no of Figures 8 to 10 for a sample of a parameter."""
    p = _article(**{name: value})
    found, lowest = quasi_static_path(p, "theta0", _RISING).jumps, float(critical_friction(p))
    critical = critical_value(_article(), name, between={name: (bracket[0], bracket[1])})
    values = {"mu_lowest": lowest, "mu_cusp": cusp_friction(p), f"critical {name}": critical}
    jump = {"jump at theta0_deg": _deg(found[0].value)} if found else {}
    return bool(found) == jumps == (lowest < 0.5), values | jump


# ------------------------------------------------------------------------------------------------
# flutter


def flutter_alpha() -> Outcome:
    p = _article(alpha=0.7)
    onsets = _deg(flutter_onsets(p, damping=False).theta0)
    growth = _highest(
        lambda angle: np.nanmax(equilibria(p.replace(theta0=angle)).eigenvalues.real), 2.5, 2.8
    )
    inside = equilibria(p.replace(theta0=np.radians(np.linspace(onsets[0], onsets[-1], 101)[1:-1])))
    flutters = (inside.undamped[:, 0] == EquilibriumType.FLUTTER).all() and (
        inside.count == 1
    ).all()
    holds = len(onsets) == 2 and flutters and abs(_deg(growth.x) - 150) < 5
    # The place of a smooth maximum has half as many digits as the other numbers.
    return holds, {"onsets_deg": onsets, "fastest growth at theta0_deg": rounded(_deg(growth.x), 5)}


def flutter_sigma() -> Outcome:
    p = _article(sigma=1.0)
    onsets = _deg(flutter_onsets(p, damping=False).theta0)
    eq = equilibria(p.replace(theta0=np.radians(_GRID)))
    flutters, expected = eq.undamped == EquilibriumType.FLUTTER, np.searchsorted(onsets, _GRID) != 1
    return (flutters.any(axis=-1) == expected).all() and flutters[expected, 2].all(), {
        "onsets_deg": onsets
    }


def sheets() -> Outcome:
    eq = equilibria(_at(_GRID, mu0=_FRICTIONS[2::2, None]))
    lowest = flutter_boundary(_article()).mu0.min()
    three, sign = eq.count == 3, eq["growth_sign"]
    upper, alone = sign[three][:, 2], sign[~three][:, 0]
    holds = _middle_diverges(eq) and lowest > MU0_RANGE[1] and (sign[three][:, 0] == -1).all()
    return holds, {
        "lowest mu0 with flutter": rounded(lowest, 4),
        "states on the upper surface": upper.size,
        "that grow": int((upper == 1).sum()),
        "single states": alone.size,
        "single ones that grow": int((alone == 1).sum()),
    }


def hopf() -> Outcome:
    p = _article(sigma=1.0)
    lowest, onset = flutter_boundary(p).mu0.min(), flutter_onsets(p, damping=False)
    at = equilibria(p.replace(theta0=onset.theta0 * np.array([1 + 1e-7, 1 - 1e-7])))
    frequencies = np.sort(at.eigenvalues[[0, 1], onset.branch].imag, axis=-1)[:, -2:]
    crossing = flutter_onsets(p)
    return (np.ptp(frequencies, axis=-1) < 2e-3).all() and lowest < 0.5 and len(crossing) == 2, {
        "lowest mu0 with flutter": rounded(lowest, 3),
        "frequencies that meet at mu0 = 0.5": rounded(frequencies.mean(axis=-1), 4),
        "at theta0_deg": _deg(onset.theta0),
        "Hopf points of (8) to (11) at theta0_deg": _deg(crossing.theta0),
    }


# ------------------------------------------------------------------------------------------------
# set, cusp, trajectories


def separates() -> Outcome:
    counts = set()
    for curve in bifurcation_set(_article()).curves:
        rows = (
            (curve.mu0 > 0.01) & (curve.mu0 < MU0_RANGE[1]) & (np.abs(curve.mu0 - 0.2009) > 0.002)
        )
        side = 1e-7 * np.array([-1.0, 1.0])[:, None]
        count = equilibria(_article(theta0=curve.theta0[rows], mu0=curve.mu0[rows] + side)).count
        counts |= set(map(tuple, np.sort(count, axis=0).T.tolist()))
    return counts == {(1, 3)}, {"equilibria on the two sides": [1, 3]}


def cusp() -> Outcome:
    cusp = next(one for one in precise.cusps(dps=20) if 0 < one.theta0 < math.pi and one.mu0 > 0)
    angle, end = math.degrees(cusp.theta0), _deg(folds(_article(mu0=0.0)).theta0)[0]
    numbers = [len(folds(_at(degrees), "mu0")) for degrees in (end - 0.01, end + 0.01, 68.0, 68.03)]
    holds = cusp.versal and numbers == [1, 2, 2, 0]
    return holds, {
        "theta0_deg": angle,
        "mu0": float(cusp.mu0),
        "two jumps for theta0_deg from, to": [end, angle],
    }


def hysteresis() -> Outcome:
    (up,), (down,) = _up_and_down()
    holds = (
        up.value > down.value
        and up.after["x"] > up.before["x"]
        and down.after["x"] < down.before["x"]
    )
    return holds, {"jump rising at mu0": up.value, "jump falling at mu0": down.value}


def no_return() -> Outcome:
    up = quasi_static_path(_at(40.0), "mu0", _FRICTIONS)
    back = quasi_static_path(_at(40.0), "mu0", _FRICTIONS[::-1], start="large")
    (jump,) = up.jumps
    # A belt that runs back is the mirror image.
    below = -folds(_at(180.0 - 40.0), "mu0").mu0
    return not back.jumps and abs(back.x[0] - up.x[-1]) < 1e-9 and back.x[-1] > 1 > up.x[0], {
        "jump rising at mu0": jump.value,
        "x at mu0 = 0 before, after": [up.x[0], back.x[-1]],
        "the next fold at mu0": below.max(),
    }


# ------------------------------------------------------------------------------------------------
# motion


def friction_law() -> Outcome:
    share = float(_working(_article(mu0=1.0)))
    return 0.99 < share < 1, {"friction at steady sliding over mu0": share}


def limit_cycle() -> Outcome:
    p = _at(49.0)
    late = simulate(p, t_end=10000.0).after(8000.0)
    eq = equilibria(p.replace(mu0=_working(p)))
    outcome, x = late.outcome(0.0), eq.x[0]
    growth = np.linalg.eigvals(
        System.of(p, None).linearization(np.array([x, eq.y[0], 0.0, 0.0]))
    ).real.max()
    alone = eq.count == 1 and eq.undamped[0] == EquilibriumType.STABLE
    return outcome.regime == Regime.LIMIT_CYCLE and alone and growth > 0, {
        "period": outcome.period,
        "largest |x|": late.largest(0.0),
        "x of the only equilibrium": x,
        "its growth rate with the friction law's damping": growth,
    }


def amplitude_jump() -> Outcome:
    table = sensitivity(_at(np.arange(36.0, 48.5, 1.0)), [V], [D], refine=12)
    at, before, after = (
        float(np.ravel(value)[0]) for value in (_deg(table.theta0), table.before, table.after)
    )
    apart = _deg(folds(_article()).theta0[0]) - at
    return after > 5 * before and abs(apart) < 5, {
        "theta0_deg": at,
        "before the fold by (deg)": rounded(apart, 3),
    }


# ------------------------------------------------------------------------------------------------
# where the oscillation exists, and the fate of the motion from rest


def lives_below() -> Outcome:
    """Stable cycles exist beside stable sliding, far below the fold."""
    near, found = cycle(_at(42.0), near=ON_CYCLE, patient=False), dict[tuple[float, ...], Cycle]()
    # Inclinations far below the fold, degrees.
    far_below = (10.0, 20.0, 30.0, 40.0)
    # Inclination at which the cycle is looked for with other belts, degrees.
    with_others = 30.0
    for case in [(degrees, V, D) for degrees in far_below[::-1]] + [
        (with_others, *belt) for belt in OTHER_BELTS
    ]:
        degrees, speed, creep = case
        near = found[case] = cycle(
            _at(degrees, V=speed, d=creep), near=found.get((degrees, V, D), near)
        )
    ours = [found[degrees, V, D] for degrees in far_below]
    others = [found[with_others, *belt] for belt in OTHER_BELTS]
    return all(one.stable and _slides_stably(*case) for case, one in found.items()), {
        "theta0_deg": far_below,
        "periods": [one.period for one in ours],
        "largest multipliers": [np.abs(one.multipliers[1]) for one in ours],
        **_of_others(),
        "periods with these at 30 degrees": [one.period for one in others],
    }


def _of_others() -> dict[str, Any]:
    """V and d of the other belts, as they stand in a row."""
    speeds, creeps = zip(*OTHER_BELTS, strict=True)
    return {"V of other belts": speeds, "d of other belts": creeps}


def _working(p: Parameters) -> FloatArray:
    """The friction coefficient that the friction law gives in steady sliding."""
    return p.model.friction(p)


def _slides_stably(degrees: float, speed: float, creep: float) -> bool:
    """Whether the equilibrium of smallest |x| is stable at the friction that this belt gives."""
    p = _at(degrees, V=speed, d=creep)
    rest = equilibria(p.replace(mu0=_working(p)))
    return bool(rest.undamped[int(np.nanargmin(np.abs(rest.x)))] == EquilibriumType.STABLE)


def fate_of_rest() -> Outcome:
    """Inclination at which the motion from rest changes from coming to rest to oscillating, and the
    saddle that it approaches there.
    """
    belts = [_article(V=speed, d=creep) for speed, creep in ((V, D), *OTHER_BELTS)]
    # Inclinations, degrees, at which the motion from rest comes to rest and at which it
    # oscillates: with our belt, then with each of the others.
    found, *others = [
        fate_boundary(p, "theta0", between={"theta0": (low, high)})
        for p, (low, high) in zip(
            belts, np.radians(((41.0, 42.0), (41.2, 43.0), (41.2, 43.7), (41.2, 42.0))), strict=True
        )
    ]
    at, *changes = _deg([one.value for one in (found, *others)])
    sliding = (folds(p.replace(mu0=float(_working(p)))).theta0[0] for p in belts[1:])
    before, apart = _deg(folds(_article()).theta0[0]) - at, _deg([*sliding]) - changes
    holds = all(one.saddle == "equilibrium" for one in (found, *others)) and 1 < before < 5
    return holds and (3 < apart).all() and (apart < 4).all(), {
        "theta0_deg": at,
        "before the fold by (deg)": before,
        "x of the saddle": found.state[0],
        "y of the saddle": found.state[1],
        "its growth rate": found.growth,
        **_of_others(),
        "theta0_deg with these": changes,
        "before the fold at their sliding friction by (deg)": apart,
    }


# ------------------------------------------------------------------------------------------------
# under dry friction, d → ∞


def _dry(degrees: ArrayLike) -> ParameterSet:
    """The article's parameters under dry friction, the limit of (10) for d → ∞."""
    return load("coulomb").Parameters(theta0=np.radians(degrees))


def statics_without_d() -> Outcome:
    degrees = (10.0, 30.0, 49.0, 90.0, 160.0)
    eq, dry = (equilibria(p) for p in (_at(degrees), _dry(degrees)))
    same = np.array_equal(eq.undamped, dry.undamped) and np.allclose(
        eq.x, dry.x, rtol=0.0, atol=1e-12, equal_nan=True
    )
    undamped = np.abs(dry.growth[dry.undamped == EquilibriumType.STABLE]).max() < 1e-15
    return same and undamped, {
        "theta0_deg": degrees,
        "counts for every d": dry.count,
        "x of the first state": dry.x[:, 0],
        "its growth with our d": eq.growth[:, 0],
    }


def oscillation_without_d() -> Outcome:
    # An inclination, degrees, and a state on the cycle there, without sticking and with it.
    on_dry_cycle = (42.0, (2.9429144682, 3.3611284180, 0.0, 0.3671196394))
    on_sticking = (60.0, (2.818, 1.213, 0.0, 0.22))
    near, sticking = (
        cycle(_dry(degrees), near=state, patient=False)
        for degrees, state in (on_dry_cycle, on_sticking)
    )
    found = [near, cycle(_dry(49.0), near=near)]
    held = sticking.phases.duration[sticking.phases.side == 0].sum()
    return all(
        one.stable and one.phases.side.all() for one in found
    ) and held > 0 and not sticking.stable, {
        "theta0_deg": (on_dry_cycle[0], 49.0),
        "periods": [one.period for one in found],
        "largest multipliers": [np.abs(one.multipliers[1]) for one in found],
        "theta0_deg of one that sticks": on_sticking[0],
        "its period": sticking.period,
        "it sticks for": held,
        "its largest multiplier": np.abs(sticking.multipliers[1]),
    }


# ------------------------------------------------------------------------------------------------
# cross-references


def printed_with(mark: str, what: str, among: list[str], expected: list[str]) -> Outcome:
    """The equations among some whose printed form contains a mark, as L⁴, or the two primes of an
    acceleration, are those expected.
    """
    equations = {row["id"]: row["printed"] for row in printed()["rows"]}
    found = [id for id in among if mark in equations[id]]
    return found == expected, {what: found}


def reference_10() -> Outcome:
    """The path a-a′ has constant θ₀ and so can't be in Figure 10, which has constant friction and
    θ₀ as its axis.
    """
    path = quasi_static_path(_at(60.0), "mu0", np.linspace(*MU0_RANGE, 11))
    return path.vary == "mu0" and np.ptp(path.values) > 0, {"what varies along a-a'": path.vary}
