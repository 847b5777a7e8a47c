"""The whole catastrophe without a starting point: surface, folds, cusps, critical frictions."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from ..display import Result
from ..errors import ConvergenceError, ParameterError
from ..exact.intervals import Arithmetic, arithmetic
from ..exact.polynomials import Undecided
from ..generated import catastrophe as _catastrophe
from ..generated import motion as _motion
from ..generated import stability as _stability
from ..parameters import NAMES, NOT_NEGATIVE, POSITIVE, RANGES, FloatArray, Parameters, as_number, as_numbers
from ..statics import kernel
from . import fold_curves, proofs

_FIXED = ("kappa", "alpha", "sigma", "beta")


def sliding_friction(mu0: ArrayLike, V: ArrayLike, d: ArrayLike) -> FloatArray:
    """Friction at steady sliding by the regularized law, μ₀ (1 − exp(−d |V|)); the article takes its limit μ₀.

    Give ``p.replace(mu0=sliding_friction(p.mu0, V, d))`` to any function of this package to have the exact one.

    Notes
    -----
    Source: (10) at x' = 0.

    Examples
    --------
    >>> round(float(sliding_friction(0.5, V=0.5, d=10.0)), 6)
    0.496631
    """
    speed = np.abs(as_numbers("V", V))
    return np.asarray(_motion.friction(0.0, as_numbers("mu0", mu0, NOT_NEGATIVE), speed, as_numbers("d", d, POSITIVE)))


# ----------------------------------------------------------------------------------------------------- surface


@dataclass(frozen=True)
class Surface(Result):
    """The equilibrium surface over (θ, θ₀); NaN and code 0 where it has no state in contact with μ₀ finite."""

    theta: FloatArray
    theta0: FloatArray
    mu0: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    stability: NDArray[np.int8]


def surface(p: Parameters, theta: ArrayLike, theta0: ArrayLike) -> Surface:
    """The friction at which θ is the direction of an equilibrium, explicitly: no root is sought.

    Parameters
    ----------
    p : Parameters
        κ, α, σ and β; its ``theta0`` and ``mu0`` are not used.
    theta, theta0 : array_like
        Radians, 0 < θ, θ₀ < π; they broadcast together and with the parameters.

    Returns
    -------
    Surface
        Friction of either sign; states in lift-off and with L ≤ 0 are NaN.

    Notes
    -----
    Source: f(θ) = 0 is linear in μ₀; (14), (15).

    Examples
    --------
    >>> import numpy as np
    >>> s = surface(Parameters.article(), theta=np.radians(100.0), theta0=np.radians(60.0))
    >>> round(float(s.mu0), 6), int(s.stability)
    (0.16305, 1)
    """
    direction = as_numbers("theta", theta, RANGES["theta0"])
    reference = as_numbers("theta0", theta0, RANGES["theta0"])
    kappa, alpha, sigma, beta = (getattr(p, name) for name in _FIXED)
    try:
        direction, reference, kappa, alpha, sigma, beta = np.broadcast_arrays(direction, reference, kappa, alpha, sigma, beta)
    except ValueError as error:
        raise ParameterError(f"theta {direction.shape}, theta0 {reference.shape} and the parameters do not broadcast") from error
    c, s, c0, s0 = np.cos(direction), np.sin(direction), np.cos(reference), np.sin(reference)
    with np.errstate(all="ignore"):
        mu0 = _catastrophe.surface(c, s, c0, s0, kappa, alpha, sigma, beta)
        L, x, y = kernel.state(c, s, c0, s0, kappa, sigma, beta, 1)
        slope = kernel.f_slope(c, s, *kernel.f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1))
        point = kernel.Point(c0, s0, mu0, kappa, alpha, sigma, beta, 1)
        code = kernel.stability(kernel.Direction(c, s), L, slope, 0.0, point).code
    good = (y < 0) & (L > 0) & np.isfinite(mu0)
    mu0, L, x, y = (np.where(good, value, np.nan) for value in (mu0, L, x, y))
    return Surface(direction, reference, mu0, L, x, y, np.where(good, code, 0).astype(np.int8))


# ------------------------------------------------------------------------------------------------------- folds


@dataclass(frozen=True)
class Folds(Result):
    """Points at which equilibria meet, sorted by the parameter that varies; one array for each parameter and coordinate.

    ``error`` bounds |error| / max(1, |value|) of all of them. ``kind`` says what happens as the parameter passes:

    - ``"fold"``: two equilibria appear or vanish together, the ordinary case;
    - ``"pitchfork"``: one becomes three, or three become one, all of them in one point (μ₀ = α = 0, a symmetric system);
    - ``"cusp"``: three meet in one point, and one is left on both sides;
    - ``"touch"``: two meet, and there are as many on both sides.

    All but the first need a coincidence of the parameters that are fixed.
    """

    vary: str
    theta0: FloatArray
    mu0: FloatArray
    kappa: FloatArray
    alpha: FloatArray
    sigma: FloatArray
    beta: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    error: FloatArray
    kind: NDArray[np.str_]


@dataclass(frozen=True)
class Turn:
    """One row of :class:`Folds`, and what :mod:`spragsym.catastrophe.paths` has to know of it, proved.

    ``side`` is 1 where there are three equilibria above its value and one below, −1 for the reverse, 0 if their number stays;
    ``upper`` says that those that meet are the upper two of three in θ; ``rounded`` is −1 where the float of its value
    lies below the true one and 1 where it lies above: with all other parameters rational they are never equal (Lindemann).
    """

    values: tuple[float, ...]
    kind: str
    side: int
    upper: bool
    rounded: int


def folds(p: Parameters, vary: str = "theta0", *, negative_friction: bool = False, arith: Arithmetic | None = None) -> Folds:
    """All folds in contact along one parameter, the others fixed: proved complete, to 1e-12 and better.

    Parameters
    ----------
    p : Parameters
        Scalars. The one that varies is not used, and may be left out if it is ``theta0`` or ``mu0``.
    vary : str
        ``"theta0"``, ``"mu0"``, ``"kappa"``, ``"alpha"``, ``"sigma"`` or ``"beta"``.
    negative_friction : bool
        Also list folds with μ₀ < 0: mirror images, for a belt that runs the other way.

    Returns
    -------
    Folds
        Those with L > 0, y < 0 and the varying parameter in its range.

    Raises
    ------
    ParameterError
        For a ``vary`` that is not a parameter, or a parameter that is missing or an array.
    ConvergenceError
        At parameters so close to a coincidence that 6144 bits do not tell it from one.

    Notes
    -----
    Source: f = f′ = 0. Two relations, linear in every parameter but θ₀; the one that varies is eliminated, and what remains is a
    polynomial in tan(θ/2), whose real roots are isolated by Descartes' rule or, over intervals, by Sturm's theorem. A multiple
    root, which belongs to the other kinds, is found by exact algebra.

    Examples
    --------
    >>> import numpy as np
    >>> found = folds(Parameters.article())
    >>> print(np.degrees(found.theta0))
    [ 44.5593177  155.05941879]
    >>> print(folds(Parameters.article(mu0=0.0, alpha=0.0)).kind)
    ['pitchfork' 'pitchfork']
    """
    found = turns(p, vary, negative_friction=negative_friction, arith=arith)
    rows, kinds = [turn.values for turn in found], [turn.kind for turn in found]
    if negative_friction and vary != "mu0" and p.scalars("mu0") != (0.0,):
        mirrored = _mirrored_folds(p, vary, arith)
        rows, kinds = rows + mirrored[0], kinds + mirrored[1]
    order = sorted(range(len(rows)), key=lambda i: rows[i][NAMES.index(vary)])
    columns: tuple[Any, ...] = _columns([rows[i] for i in order], 11)
    return Folds(vary, *(*columns, np.array([kinds[i] for i in order], dtype=np.str_)))


def turns(p: Parameters, vary: str, *, negative_friction: bool = False, arith: Arithmetic | None = None) -> list[Turn]:
    """The rows of :func:`folds` along one parameter, sorted by it; ``negative_friction`` matters for ``mu0`` only."""
    if vary not in NAMES:
        raise ParameterError(f"vary = {vary!r} is not a parameter; choose one of {', '.join(NAMES)}")
    fixed = [name for name in NAMES if name != vary]
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))
    chosen = arith or arithmetic()
    allowed, place = RANGES[vary], NAMES.index(vary)

    def attempt(bits: int) -> list[Turn]:
        found = []
        for fold in proofs.folds(chosen, vary, exact, bits):
            value = fold.point.parameters[place]
            wanted = proofs.decided(chosen, value, f"{vary} = 0 on a fold") > 0 or (negative_friction and vary == "mu0")
            turn = _turn(chosen, fold, place) if wanted else None
            if turn and turn.values[place] < allowed.high:
                found.append((chosen.ends(value), turn))
        found.sort(key=lambda one: one[0][0])
        # Two never have one value, since the positive roots of f, at most three, are no two pairs.
        if any(one[0][1] >= two[0][0] for one, two in itertools.pairwise(found)):
            raise Undecided("the order of two folds")
        return [turn for _, turn in found]

    return proofs.with_enough_bits(chosen, 20, attempt, "folds")


def _turn(arith: Arithmetic, fold: proofs.Fold, place: int) -> Turn:
    values = _row(arith, fold.point)
    low, high = arith.ends(fold.point.parameters[place])
    rounded = 1 if high < values[place] else -1 if low > values[place] else 0
    if rounded == 0 or high - low > abs(low) / 10**25:
        raise Undecided("a fold and the float next to it")
    return Turn(values, fold.kind, fold.side, fold.upper, rounded)


def _mirrored_folds(p: Parameters, vary: str, arith: Arithmetic | None) -> tuple[list[tuple[float, ...]], list[str]]:
    """Folds at −μ₀: those at μ₀ of the mirror image, reflected back; and their kinds."""
    reflected = p if vary == "theta0" else p.replace(theta0=math.pi - float(p.theta0))
    found = folds(reflected, vary, arith=arith)
    columns = (
        math.pi - found.theta0, -found.mu0, found.kappa, found.alpha, found.sigma, found.beta,
        math.pi - found.theta, found.L, -found.x, found.y, found.error,
    )  # fmt: skip
    return [tuple(map(float, row)) for row in zip(*columns, strict=True)], found.kind.tolist()


def _row(arith: Arithmetic, point: proofs.Point) -> tuple[float, ...]:
    """Middles as floats, and the largest error, the rounding to float included."""
    values, error = proofs.as_floats(arith, (*point.parameters, point.theta, point.L, point.x, point.y))
    return (*values, error)


def _columns(rows: list[tuple[float, ...]], width: int) -> tuple[FloatArray, ...]:
    return tuple(np.array(column, dtype=float) for column in zip(*rows, strict=True)) if rows else (np.empty(0),) * width


@dataclass(frozen=True)
class FoldCurve(Result):
    """One curve of folds, points in order along it."""

    theta0: FloatArray
    mu0: FloatArray
    theta: FloatArray
    x: FloatArray
    y: FloatArray


@dataclass(frozen=True)
class BifurcationSet(Result):
    """Every fold curve in the plane of θ₀ and μ₀, and the cusps on them."""

    curves: tuple[FoldCurve, ...]
    cusps: Cusps

    def __len__(self) -> int:
        return len(self.curves)


def bifurcation_set(p: Parameters, n: int = 2000, *, negative_friction: bool = False) -> BifurcationSet:
    """Every fold curve in (θ₀, μ₀) for 0 < θ₀ < π and μ₀ ≥ 0: where the number of equilibria changes.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β; ``theta0`` and ``mu0`` are spanned and not used.
    n : int
        About how many directions θ to solve at, 600 or more; they gather where curves are long.
    negative_friction : bool
        Also list the mirror images (θ, θ₀, μ₀) → (π − θ, π − θ₀, −μ₀).

    Returns
    -------
    BifurcationSet
        Curves with their ends at θ₀ = 0 or π, at μ₀ = 0, or closed; cusps of the same region.

    Notes
    -----
    Source: f = f′ = 0; see :mod:`spragsym.catastrophe.fold_curves`. Points satisfy it to rounding.

    Examples
    --------
    >>> found = bifurcation_set(Parameters.article())
    >>> len(found), round(float(found.cusps.mu0[0]), 12)
    (2, 0.200931781805)
    """
    if isinstance(n, bool) or not isinstance(n, int | np.integer) or n < 2:
        raise ParameterError(f"n = {n!r} is not a number of points; give an integer of 2 or more")
    values = p.scalars(*_FIXED)
    curves = []
    for strand in fold_curves.strands(values, int(n)):  # type: ignore[arg-type]
        c, s = np.cos(strand.theta), np.sin(strand.theta)
        L, x, y = kernel.state(c, s, np.cos(strand.theta0), np.sin(strand.theta0), values[0], values[2], values[3], 1)
        # Equilibria never cross y = 0 for 0 < θ₀ < π (derive/kang_nam/theorem.py), so one point tells for the whole curve.
        if y[y.size // 2] < 0:
            curves.append(FoldCurve(strand.theta0, strand.mu0, strand.theta, x, y))
    found = cusps(p)
    ahead = (found.theta0 > 0) & (found.theta0 < math.pi) & ((found.mu0 >= 0) | negative_friction)
    if negative_friction:
        curves += [
            FoldCurve(math.pi - curve.theta0, -curve.mu0, math.pi - curve.theta, -curve.x, curve.y) for curve in list(curves)
        ]
    return BifurcationSet(tuple(curves), found.select(ahead))


# ------------------------------------------------------------------------------------------------------- cusps


@dataclass(frozen=True)
class Cusps(Result):
    """Points at which two folds meet, sorted by ``mu0``; ``error`` bounds |error| / max(1, |value|) of all six numbers."""

    theta0: FloatArray
    mu0: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    error: FloatArray

    def select(self, which: NDArray[np.bool_]) -> Cusps:
        """Some of them."""
        return Cusps(*(getattr(self, name)[which] for name in ("theta0", "mu0", "theta", "L", "x", "y", "error")))

    def __len__(self) -> int:
        return int(self.theta0.size)


def cusps(p: Parameters, *, arith: Arithmetic | None = None) -> Cusps:
    """All cusps in contact with L > 0, θ₀ in (−π, π] and μ₀ of either sign: proved complete.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β, taken as the exact rationals that the floats are; ``theta0`` and ``mu0`` are not used.

    Returns
    -------
    Cusps
        Empty where there is none.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ (a cubic for α = 0); its roots are isolated exactly.

    Examples
    --------
    >>> found = cusps(Parameters.article())
    >>> print(np.degrees(found.theta0[2]), found.mu0[2])
    68.02095850774431 0.20093178180509003
    """
    exact = tuple(map(Fraction, p.scalars(*_FIXED)))
    arith = arith or arithmetic()

    def attempt(bits: int) -> list[tuple[float, ...]]:
        return [_row(arith, point) for point in proofs.cusps(arith, exact, bits)]

    rows = proofs.with_enough_bits(arith, 20, attempt, "cusps")
    rows = sorted((row[0], row[1], *row[6:]) for row in rows)
    return Cusps(*_columns(sorted(rows, key=lambda row: row[1]), 7))


# ---------------------------------------------------------------------------------------------------- criteria


def critical_friction(p: Parameters) -> float | FloatArray:
    """μ_cusp, the friction of the lowest cusp with 0 < θ₀ < π: below it the state of small deformation has no jump.

    Parameters
    ----------
    p : Parameters
        κ, α, σ, β, scalars or arrays; ``theta0`` and ``mu0`` are not used.

    Returns
    -------
    float or ndarray
        ``inf`` where there is no cusp: then no friction makes that state jump.

    Notes
    -----
    Source: the cusp polynomial. The article's Figures 8 to 10 follow from it: the curves that jump are those with μ₀ = 0.5
    above it.

    Examples
    --------
    >>> print(critical_friction(Parameters.article()))
    0.20093178180509003
    """
    kappa, alpha, sigma, beta = np.broadcast_arrays(*(getattr(p, name) for name in _FIXED))
    result = np.array([
        _lowest_cusp(*map(float, point)) for point in zip(kappa.flat, alpha.flat, sigma.flat, beta.flat, strict=True)
    ]).reshape(kappa.shape)  # fmt: skip
    return result if result.ndim else float(result)


def _lowest_cusp(kappa: float, alpha: float, sigma: float, beta: float) -> float:
    found = cusps(Parameters(kappa=kappa, alpha=alpha, sigma=sigma, beta=beta))
    inside = (found.theta0 > 0) & (found.theta0 < math.pi) & (found.mu0 >= 0)
    return float(found.mu0[inside].min()) if inside.any() else math.inf


def critical_value(p: Parameters, vary: str, bracket: tuple[float, float]) -> float:
    """The value of a parameter at which μ_cusp equals μ₀: between it and the other side the jump comes or goes.

    Parameters
    ----------
    p : Parameters
        Scalars with ``mu0``; the parameter that varies is not used.
    vary : str
        ``"kappa"``, ``"alpha"``, ``"sigma"`` or ``"beta"``.
    bracket : (float, float)
        Two values with μ_cusp on different sides of μ₀.

    Returns
    -------
    float
        To 1e-13, relative.

    Examples
    --------
    >>> print(f"{critical_value(Parameters.article(), 'beta', (1, 2)):.9f}")
    1.632329272
    """
    if vary not in _FIXED:
        raise ParameterError(f"vary = {vary!r} does not change a cusp; choose one of {', '.join(_FIXED)}")
    low, high = (as_number(f"bracket[{i}]", value, RANGES[vary]) for i, value in enumerate(bracket))
    if not low < high:
        raise ParameterError(f"bracket = ({low}, {high}) is empty; give two values, the smaller first")
    (mu0,) = p.scalars("mu0")

    def friction_at(value: float) -> float:
        return float(critical_friction(p.replace(theta0=None, mu0=None, **{vary: value})))

    def excess(value: float) -> float:
        return math.atan(friction_at(value)) - math.atan(mu0)  # finite where there is no cusp

    ends = excess(low), excess(high)
    if ends[0] * ends[1] > 0:
        frictions = ", ".join(
            f"{_in_words(friction_at(value))} at {vary} = {value:g}" for value in (low, high)
        )
        raise ParameterError(f"bracket: mu_cusp is {frictions}, both on one side of mu0 = {mu0:g}; widen it")
    low, high = _within_a_factor(excess, low, high)
    root = low if low == high else float(brentq(excess, low, high, xtol=1e-300, rtol=8.9e-16, maxiter=200))
    if abs(excess(root)) > 1e-9:
        below, above = (friction_at(max(float(np.nextafter(root, end)), RANGES[vary].low)) for end in (-math.inf, math.inf))
        raise ConvergenceError(
            f"mu_cusp jumps across mu0 = {mu0:g} at {vary} = {root:.12g}, from {_in_words(below)} to {_in_words(above)}: "
            "there it has no value between; try a bracket on one side"
        )
    return root


def _within_a_factor(excess: Callable[[float], float], low: float, high: float) -> tuple[float, float]:
    """A bracket whose larger end is at most twice the smaller, or one value: halved in the exponent, at most 12 times."""
    ends = [excess(low), excess(high)]
    for value, end in zip((low, high), ends, strict=True):
        if end == 0:
            return value, value
    smallest = float(np.finfo(float).smallest_normal)
    while high > 2 * max(low, smallest):
        middle = math.sqrt(max(low, smallest)) * math.sqrt(high)
        value = excess(middle)
        if value == 0:
            return middle, middle
        low, high = (low, middle) if value * ends[0] < 0 else (middle, high)
    return low, high


def _in_words(friction: float) -> str:
    return "infinite (there is no cusp)" if math.isinf(friction) else f"{friction:.6g}"


# ------------------------------------------------------------------------------------------------ linear model


@dataclass(frozen=True)
class LinearSprag(Result):
    """Steady sliding with the spring's angle held at θ₀, the article's reference [17].

    ``determinant`` ≤ 0 is the sprag condition; at a pole x and y are infinite. ``poles`` lists the θ₀ in (0, π) of the poles, two
    at the last axis, NaN where there are none.
    """

    x: FloatArray
    y: FloatArray
    determinant: FloatArray
    poles: FloatArray
    critical_friction: FloatArray


def linear_sprag(p: Parameters) -> LinearSprag:
    """Displacement, poles and critical friction of the constant-angle model; all shapes broadcast.

    Notes
    -----
    Source: (12), (13) linearized about x = y = 0; article, Section 3.

    Examples
    --------
    >>> model = linear_sprag(Parameters.article(theta0=np.radians(49.0), mu0=0.7))
    >>> print(np.degrees(model.poles).round(3))
    [62.784 82.034]
    """
    p.require("theta0", "mu0")
    from ..generated import linear_sprag as _linear

    c0, s0 = np.cos(p.theta0), np.sin(p.theta0)
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = _linear.displacement(c0, s0, p.mu0, p.kappa, p.alpha, p.sigma, p.beta)
        (K11, K12), (K21, K22) = _stability.stiffness(c0, s0, 1.0, p.mu0, p.alpha, p.sigma, p.beta, 1)
        _, determinant, _ = _stability.invariants(K11, K12, K21, K22)
        e0, e1, e2 = _linear.pole_quadratic(p.mu0, p.alpha, p.sigma, p.beta)
        # Factors of the discriminant, each by roots, so that none of them leaves the range of float64.
        middle = 2 * np.sqrt(e0) * np.sqrt(e2)
        large = 0.5 * (-e1 + np.sqrt(-e1 - middle) * np.sqrt(-e1 + middle))
        # T = e0/large and large/e2; the second is infinite for α = 0, a pole at 90°, where both are for μ₀ = 0 as well.
        poles = np.stack([np.arctan2(e0, large), np.where(large > 0, np.arctan2(large, e2), 0.5 * np.pi)], axis=-1)
        poles = np.where(np.isfinite(large)[..., None], poles, np.nan)
    shape = p.shape
    x, y, determinant = (np.broadcast_to(np.asarray(value, dtype=float), shape).copy() for value in (x, y, determinant))
    return LinearSprag(
        x,
        y,
        determinant,
        poles=np.broadcast_to(poles, (*shape, 2)).copy(),
        critical_friction=np.broadcast_to(linear_critical_friction(p), shape).copy(),
    )


def linear_critical_friction(p: Parameters) -> Any:
    """μ_cr of the constant-angle model: it has a pole if and only if μ₀ ≥ μ_cr.

    Notes
    -----
    Source: article, Section 3; μ_cr² = 4 α (α + σ)(1 + β)(1 + β + σ)/σ².

    Examples
    --------
    >>> print(round(linear_critical_friction(Parameters.article()), 6))
    0.574073
    """
    from ..generated import linear_sprag as _linear

    value = np.sqrt(_linear.critical_friction_squared(p.alpha, p.sigma, p.beta))
    return float(value) if np.ndim(value) == 0 else value
