"""The computation that decides each statement: it returns whether the statement holds, and the values behind it."""

from __future__ import annotations

import json
import math
from functools import cache
from typing import Any

import mpmath
import numpy as np
from scipy.optimize import brentq, minimize_scalar

import spragsym as ss

from .. import precise
from ..assumed import MU0_RANGE, D, V
from ..generated import equilibrium as _equilibrium
from ..models.load import USUAL, load
from ..models.parameters import NAMES, FloatArray, Parameters
from ..motion import simulate
from ..motion.regimes import Regime
from ..motion.sweeps import sensitivity
from ..results import Equilibria, Jump, Stability
from .ledger import Found, Value, package_text

#: Largest friction of Figures 11 to 14.
MU0_MAX = MU0_RANGE[1]

_MODEL = load(USUAL)
_article = Parameters.article
#: θ₀ of grids, degrees.
_GRID = np.linspace(0.1, 179.9, 900)


def _deg(angle: Any) -> Any:
    return np.degrees(angle)


def _at(degrees: Any, **changes: Any) -> Parameters:
    return _article(theta0=np.radians(degrees), **changes)


def _jumps(p: Parameters, vary: str, values: FloatArray, start: str | int = "small") -> tuple[Jump, ...]:
    return ss.quasi_static_path(p, vary, values, start=start).jumps


_RISING = np.radians(np.linspace(0.1, 179.9, 361))


# ------------------------------------------------------------------------------------------ the linear model


def linear_critical() -> Found:
    value = float(ss.linear_critical_friction(_article()))
    return Found(0.005 < 0.58 - value <= 0.01, {"mu_cr": value, "0.58 - mu_cr": 0.58 - value})


def linear_bounded() -> Found:
    critical = float(ss.linear_critical_friction(_article()))
    frictions = critical * np.append(np.linspace(0.0, 0.999, 200), 1 - 1e-9)
    model = ss.linear_sprag(_at(_GRID, mu0=frictions[:, None]))
    peak = minimize_scalar(
        lambda angle: -float(ss.linear_sprag(_article(theta0=angle)).x), bounds=(1.2, 1.5), method="bounded",
        options={"xatol": 1e-10},
    )  # fmt: skip
    holds = bool(np.isnan(model.poles).all() and (model.determinant > 0).all() and (model.y < 0).all())
    return Found(holds, {"largest x at mu0 = 0.5": -float(peak.fun), "at theta0_deg": float(_deg(peak.x))})


def linear_poles() -> Found:
    poles = np.sort(ss.linear_sprag(_article(theta0=1.0, mu0=0.7)).poles)
    outside = ss.linear_sprag(_article(theta0=poles + np.array([-1e-9, 1e-9]), mu0=0.7))
    return Found(bool((-outside.y > 1e5).all()), {"poles_deg": _deg(poles)})


def no_linear_sliding() -> Found:
    low, high = np.sort(ss.linear_sprag(_article(theta0=1.0, mu0=0.7)).poles)
    share = np.linspace(1e-6, 1 - 1e-6, 1001)
    between = ss.linear_sprag(_article(theta0=low + (high - low) * share, mu0=0.7))
    outside = ss.linear_sprag(_article(theta0=np.concatenate([low * share, high + (math.pi - high) * share]), mu0=0.7))
    holds = bool((between.y > 0).all() and (between.determinant < 0).all() and (outside.y < 0).all())
    return Found(holds, {"from_deg": float(_deg(low)), "to_deg": float(_deg(high))})


def _linear_gap(angle: Any, mu0: float) -> FloatArray:
    """Relative distance of x between the two models, the nonlinear one at its smallest |x|, less a tenth."""
    p = _article(theta0=angle, mu0=mu0)
    x = ss.equilibria(p).x
    near = np.take_along_axis(x, np.nanargmin(np.abs(x), axis=-1)[..., None], axis=-1)[..., 0]
    return np.abs(ss.linear_sprag(p).x - near) / np.abs(near) - 0.1


def linear_approximates() -> Found:
    values: dict[str, Value] = {}
    holds = True
    for mu0 in (0.5, 0.7):
        gaps = _linear_gap(np.radians(_GRID), mu0)
        fold = float(ss.folds(_article(mu0=mu0)).theta0[0])
        (changes,) = np.nonzero(np.diff(np.sign(gaps)))
        first, last = (np.radians(_GRID[[i, i + 1]]) for i in (changes[0], changes[-1]))
        ends = [float(brentq(_linear_gap, *pair, args=(mu0,), xtol=1e-14)) for pair in (first, last)]
        values[f"within 10 % at mu0 = {mu0:g} below, above (deg)"] = [float(_deg(end)) for end in ends]
        holds &= ends[0] < fold < ends[1] < math.radians(150) and bool(gaps[0] < 0 and gaps[-1] < 0)
    return Found(bool(holds), values)


# ------------------------------------------------------------------------------------- equilibria in contact


def one_or_three() -> Found:
    frictions = np.linspace(0.0, MU0_MAX, 41)[:, None]
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
        seen |= set(np.unique(ss.equilibria(_at(_GRID, **changes, mu0=frictions)).count).tolist())
    ledger = json.loads(package_text("ledger.json", "spragsym.generated"))
    unproved = [step["claim"] for step in ledger["one_or_three"] if not step["holds"]]
    return Found(seen == {1, 3} and not unproved, {"counts": sorted(seen), "steps of the proof that fail": len(unproved)})


def bounded() -> Found:
    p = _at(_GRID, mu0=np.linspace(0.0, MU0_MAX, 41)[:, None])
    eq = ss.equilibria(p)
    bound = (p.kappa + p.sigma * (1 - np.sin(p.theta0))) / (1 + p.beta + p.sigma)
    force = np.nanmax(-eq.y, axis=-1)
    largest = float((p.kappa + p.sigma) / (1 + p.beta + p.sigma))
    holds = bool((force <= bound * (1 + 1e-12)).all() and np.nanmax(np.abs(eq.x)) < 2)
    return Found(
        holds,
        {"contact force never above": largest, "largest |x| for mu0 <= 1": float(np.nanmax(np.abs(eq.x)))},
    )


def base_regions() -> Found:
    turns = _deg(ss.folds(_article()).theta0)
    count = ss.equilibria(_at(_GRID)).count
    expected = np.where(np.less(_GRID, turns[0]) | np.greater(_GRID, turns[1]), 3, 1)
    return Found(bool((count == expected).all()), {"folds_deg": turns, "counts": [3, 1, 3]})


def base_stability() -> Found:
    return Found(
        _middle_diverges(ss.equilibria(_at(_GRID))), {"of three": ["stable", "divergent", "stable"], "of one": ["stable"]}
    )


def _middle_diverges(eq: Equilibria) -> bool:
    """Whether of three states the middle one diverges and the others are stable, and of one that is."""
    stable, three = Stability.STABLE, eq.stability[eq.count == 3]
    return bool((three == [stable, Stability.DIVERGENT, stable]).all() and (eq.stability[eq.count == 1][:, 0] == stable).all())


def lift_off() -> Found:
    eq = ss.equilibria(_at(_GRID), contact=False)
    divergent = (eq.stability[:, 0] == Stability.DIVERGENT).all()
    holds = bool((eq.count == 1).all() and divergent and (eq.y[:, 0] >= 0).all())
    at = ss.equilibria(_at(49.0), contact=False)
    return Found(
        holds,
        {"count": 1, "stability": "divergent", "L at 49 deg": float(at.L[0]), "y at 49 deg": float(at.y[0])},
    )


def roots_of_21() -> Found:
    """Real roots of the quartic in L, with 40 digits, beside the equilibria."""
    angles, real, sliding = (30, 49, 90, 160), [], []
    own = mpmath.mp.clone()  # mpmath.mp belongs to all threads
    own.dps = 40
    numbers = [own.mpf(value) for value in ("0.5", "0.007", "0.007", "0.1", "0")]
    for angle in angles:
        theta0 = own.radians(angle)
        coefficients = _equilibrium.contact_quartic(own.cos(theta0), own.sin(theta0), *numbers)
        roots = own.polyroots(coefficients[::-1], maxsteps=200, extraprec=200)
        real.append(sum(abs(own.im(root)) < own.mpf(10) ** -20 for root in roots))
        sliding.append(len(precise.equilibria(theta0_deg=angle, dps=20)))
    holds = all(one == other + 1 for one, other in zip(real, sliding, strict=True))
    return Found(holds, {"theta0_deg": list(angles), "real roots": real, "equilibria": sliding})


# ----------------------------------------------------------------------------------------------------- jumps


def jump_rising() -> Found:
    jumps = _jumps(_article(mu0=0.7), "theta0", _RISING)
    (jump,) = jumps
    holds = jump.after["x"] > jump.before["x"] and jump.stability_after == Stability.STABLE
    after = float(f"{jump.after['x']:.9g}")  # it is taken a little beyond the fold
    return Found(holds, {"theta0_deg": float(_deg(jump.value)), "x before": jump.before["x"], "x after": after})


def no_jump_falling() -> Found:
    p = _article(mu0=0.7)
    back = ss.quasi_static_path(p, "theta0", _RISING[::-1], start="small")
    other = _jumps(p, "theta0", _RISING[::-1], start="large")
    ends = sorted((int(np.argmin(back.x)), int(np.argmax(back.x))))
    rises = bool((np.diff(back.x[slice(*ends)]) > 0).all()) and back.values[ends[1]] < np.radians(2.0)
    holds = not back.jumps and rises and len(other) == 1
    values: dict[str, Value] = {
        "jumps on the way back": len(back.jumps),
        "x grows from theta0_deg, to": [float(f"{_deg(back.values[i]):.3g}") for i in ends],
        "x there": [float(back.x[i]) for i in ends],
        "jump of the other state at theta0_deg": float(_deg(other[0].value)),
    }
    return Found(holds, values)


def must_jump() -> Found:
    p, values = _at(60.0), np.linspace(0.0, MU0_MAX, 201)
    turns = ss.folds(p, "mu0").mu0
    up, down = _jumps(p, "mu0", values), _jumps(p, "mu0", values[::-1])
    holds = len(turns) == 2 and len(up) == 1 and len(down) == 1
    return Found(holds, {"folds passed each way": len(turns), "jumps": [len(up), len(down)]})


@cache
def _critical_value(name: str, bracket: tuple[float, float]) -> float:
    return float(ss.critical_value(_article(), name, bracket))


def family_row(name: str, value: float, bracket: tuple[float, float], jumps: bool) -> Found:
    """The yes or no of Figures 8 to 10 for a sample of a parameter."""
    p = _article(**{name: value})
    found = _jumps(p, "theta0", _RISING)
    lowest, cusp = float(ss.critical_friction(p)), float(ss.cusp_friction(p))
    values: dict[str, Value] = {"mu_lowest": lowest, "mu_cusp": cusp, f"critical {name}": _critical_value(name, tuple(bracket))}
    if found:
        values["jump at theta0_deg"] = float(_deg(found[0].value))
    return Found(bool(found) == jumps == (lowest < 0.5), values)


# --------------------------------------------------------------------------------------------------- flutter


def flutter_alpha() -> Found:
    p = _article(alpha=0.7)
    onsets = _deg(ss.flutter_onsets(p, damping=False).theta0)
    growth = minimize_scalar(
        lambda angle: -float(np.nanmax(ss.equilibria(p.replace(theta0=angle)).eigenvalues.real)),
        bounds=(2.5, 2.8), method="bounded", options={"xatol": 1e-10},
    )  # fmt: skip
    fastest = float(_deg(growth.x))
    inside = ss.equilibria(p.replace(theta0=np.radians(np.linspace(onsets[0], onsets[-1], 101)[1:-1])))
    flutters = bool((inside.stability[:, 0] == Stability.FLUTTER).all() and (inside.count == 1).all())
    holds = len(onsets) == 2 and flutters and abs(fastest - 150) < 5
    # The place of a smooth maximum has half as many digits as the other numbers.
    return Found(holds, {"onsets_deg": onsets, "fastest growth at theta0_deg": float(f"{fastest:.5g}")})


def flutter_sigma() -> Found:
    p = _article(sigma=1.0)
    onsets = ss.flutter_onsets(p, damping=False)
    low, high = _deg(onsets.theta0)
    eq = ss.equilibria(p.replace(theta0=np.radians(_GRID)))
    flutters = (eq.stability == Stability.FLUTTER).any(axis=-1)
    expected = np.less(_GRID, low) | np.greater(_GRID, high)
    upper = (eq.stability[expected, 2] == Stability.FLUTTER).all()
    return Found(bool((flutters == expected).all() and upper), {"onsets_deg": [float(low), float(high)]})


def sheets() -> Found:
    eq = ss.equilibria(_at(_GRID, mu0=np.linspace(0.0, MU0_MAX, 101)[:, None]))
    lowest = float(ss.flutter_boundary(_article()).mu0.min())
    return Found(_middle_diverges(eq) and lowest > MU0_MAX, {"lowest mu0 with flutter": float(f"{lowest:.4g}")})


def hopf() -> Found:
    p = _article(sigma=1.0)
    lowest = float(ss.flutter_boundary(p).mu0.min())
    onset = ss.flutter_onsets(p, damping=False)
    at = ss.equilibria(p.replace(theta0=onset.theta0 * np.array([1 + 1e-7, 1 - 1e-7])))
    frequencies = np.sort(at.eigenvalues[[0, 1], onset.branch].imag, axis=-1)[:, -2:]
    meet = bool((np.ptp(frequencies, axis=-1) < 2e-3).all())
    return Found(meet and lowest < 0.5, {
        "lowest mu0 with flutter": float(f"{lowest:.3g}"),
        "frequencies that meet at mu0 = 0.5": [float(f"{value:.4g}") for value in frequencies.mean(axis=-1)],
    })  # fmt: skip


# ----------------------------------------------------------------------------------- set, cusp, trajectories


def separates() -> Found:
    counts = set()
    for curve in ss.bifurcation_set(_article()).curves:
        rows = (curve.mu0 > 0.01) & (curve.mu0 < MU0_MAX) & (np.abs(curve.mu0 - 0.2009) > 0.002)
        side = 1e-7 * np.array([-1.0, 1.0])[:, None]
        count = ss.equilibria(_article(theta0=curve.theta0[rows], mu0=curve.mu0[rows] + side)).count
        counts |= set(map(tuple, np.sort(count, axis=0).T.tolist()))
    return Found(counts == {(1, 3)}, {"equilibria on the two sides": [1, 3]})


def cusp() -> Found:
    cusp = next(one for one in precise.cusps(dps=20) if 0 < one.theta0 < math.pi and one.mu0 > 0)
    ends = _deg(ss.folds(_article(mu0=0.0)).theta0)
    angle = math.degrees(cusp.theta0)
    values: dict[str, Value] = {
        "theta0_deg": angle, "mu0": float(cusp.mu0), "two jumps for theta0_deg from, to": [float(ends[0]), angle],
    }  # fmt: skip
    numbers = [ss.folds(_at(angle), "mu0").mu0.size for angle in (ends[0] - 0.01, ends[0] + 0.01, 68.0, 68.03)]
    return Found(cusp.versal and numbers == [1, 2, 2, 0], values)


def hysteresis() -> Found:
    values = np.linspace(0.0, MU0_MAX, 201)
    (up,), (down,) = _jumps(_at(60.0), "mu0", values), _jumps(_at(60.0), "mu0", values[::-1])
    holds = up.value > down.value and up.after["x"] > up.before["x"] and down.after["x"] < down.before["x"]
    return Found(holds, {"jump rising at mu0": up.value, "jump falling at mu0": down.value})


def no_return() -> Found:
    values = np.linspace(0.0, MU0_MAX, 201)
    up = ss.quasi_static_path(_at(40.0), "mu0", values)
    back = ss.quasi_static_path(_at(40.0), "mu0", values[::-1], start="large")
    (jump,) = up.jumps
    # A belt that runs back is the mirror image.
    below = -ss.folds(_at(180.0 - 40.0), "mu0").mu0
    holds = not back.jumps and abs(back.x[0] - up.x[-1]) < 1e-9 and back.x[-1] > 1 > up.x[0]
    return Found(holds, {
        "jump rising at mu0": jump.value, "x at mu0 = 0 before, after": [float(up.x[0]), float(back.x[-1])],
        "the next fold at mu0": float(below.max()),
    })  # fmt: skip


# ---------------------------------------------------------------------------------------------------- motion


def friction_law() -> Found:
    share = float(_MODEL.friction(_article(mu0=1.0, V=V, d=D)))
    return Found(0.99 < share < 1, {"friction at steady sliding over mu0": share})


def limit_cycle() -> Found:
    p = _at(49.0)
    late = simulate(p, V=V, d=D, t_end=10000.0).after(8000.0)
    eq = ss.equilibria(p.replace(mu0=_MODEL.friction(p.replace(V=V, d=D))))
    outcome = late.outcome(0.0)
    x, y = float(eq.x[0]), float(eq.y[0])
    growth = linearized_growth(p, x, y, V, D)
    alone = int(eq.count) == 1 and int(eq.stability[0]) == Stability.STABLE
    holds = outcome.regime == Regime.LIMIT_CYCLE and alone and growth > 0
    return Found(bool(holds), {
        "period": outcome.period, "largest |x|": late.largest(0.0), "x of the only equilibrium": x,
        "its growth rate with the friction law's damping": growth,
    })  # fmt: skip


def linearized_growth(p: Parameters, x: float, y: float, V: float, d: float) -> float:
    """The largest real part of the linearization at an equilibrium, the damping that (27) leaves out included."""
    theta0, mu0, kappa, alpha, sigma, beta = p.scalars(*NAMES)
    along, across = _MODEL.algebra.regime_jacobian(
        x, y, 0.0, 0.0, np.cos(theta0), np.sin(theta0), mu0, kappa, alpha, sigma, beta, V, d, pushing=1, side=1, near1=1
    )
    jacobian = np.array([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], along, across], dtype=float)
    return float(np.linalg.eigvals(jacobian).real.max())


def amplitude_jump() -> Found:
    table = sensitivity(_at(np.arange(36.0, 48.5, 1.0)), [V], [D], refine=12)
    fold = float(_deg(ss.folds(_article()).theta0[0]))
    at, before, after = (float(np.ravel(value)[0]) for value in (_deg(table.theta0), table.before, table.after))
    return Found(
        after > 5 * before and abs(at - fold) < 5, {"theta0_deg": at, "before the fold by (deg)": float(f"{fold - at:.3g}")}
    )


# ------------------------------------------------------------------------------------------ cross-references


def _printed() -> dict[str, str]:
    ledger = json.loads(package_text("ledger.json", "spragsym.generated"))
    return {row["id"]: row["printed"] for row in ledger["rows"]}


def reference_22() -> Found:
    """Which of (22) and (26) is a polynomial in L."""
    printed = _printed()
    polynomials = [id for id in ("eq-21", "eq-22", "eq-26") if "L^4" in printed[id]]
    return Found(polynomials == ["eq-21", "eq-26"], {"polynomials": polynomials})


def reference_12() -> Found:
    """Which equations hold accelerations, and so have eigenvalues."""
    printed = _printed()
    moving = [id for id in ("eq-8", "eq-9", "eq-12", "eq-13") if "''" in printed[id]]
    return Found(moving == ["eq-8", "eq-9"], {"equations with accelerations": moving})


def reference_10() -> Found:
    """A path at constant θ₀ does not appear in Figure 10, where the friction is constant and θ₀ is the axis."""
    path = ss.quasi_static_path(_at(60.0), "mu0", np.linspace(0.0, MU0_MAX, 11))
    return Found(path.vary == "mu0" and bool(np.ptp(path.values) > 0), {"what varies along a-a'": path.vary})
