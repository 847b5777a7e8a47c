"""The whole catastrophe without a starting point: surface, folds, cusps, flutter onsets, critical frictions."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from . import fold_curves, kernel, proofs
from .display import Result
from .errors import ConvergenceError, ParameterError
from .generated import catastrophe as _catastrophe
from .generated import motion as _motion
from .generated import stability as _stability
from .intervals import Arithmetic, arithmetic
from .parameters import NAMES, NOT_NEGATIVE, POSITIVE, RANGES, FloatArray, Parameters, as_number, as_numbers
from .polynomials import Undecided

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
        code = kernel.stability(c, s, L, slope, 0.0, mu0, alpha, sigma, beta, 1)
    good = (y < 0) & (L > 0) & np.isfinite(mu0)
    mu0, L, x, y = (np.where(good, value, np.nan) for value in (mu0, L, x, y))
    return Surface(direction, reference, mu0, L, x, y, np.where(good, code, 0).astype(np.int8))


# ------------------------------------------------------------------------------------------------------- folds


@dataclass(frozen=True)
class Folds(Result):
    """Points at which two equilibria meet, sorted by the parameter that varies; one array for each parameter and coordinate.

    ``error`` bounds |error| / max(1, |value|) of all of them.
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
        At parameters so degenerate that two folds can't be told apart.

    Notes
    -----
    Source: f = f′ = 0. Two relations, linear in every parameter but θ₀; the one that varies is eliminated, and what remains is a
    polynomial in tan(θ/2) whose real roots Sturm's theorem counts.

    Examples
    --------
    >>> import numpy as np
    >>> found = folds(Parameters.article())
    >>> print(np.degrees(found.theta0))
    [ 44.5593177  155.05941879]
    """
    if vary not in NAMES:
        raise ParameterError(f"vary = {vary!r} is not a parameter; choose one of {', '.join(NAMES)}")
    fixed = [name for name in NAMES if name != vary]
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))
    arith = arith or arithmetic()
    allowed, place = RANGES[vary], NAMES.index(vary)

    def attempt(bits: int) -> list[tuple[float, ...]]:
        rows = (_row(arith, point) for point in proofs.folds(arith, vary, exact, bits))
        return [row for row in rows if allowed.contains(row[place]) or (negative_friction and vary == "mu0")]

    rows = proofs.with_enough_bits(arith, 20, attempt, "folds")
    if negative_friction and vary != "mu0":
        rows += _mirrored_folds(p, vary, exact, arith)
    return Folds(vary, *_columns(sorted(rows, key=lambda row: row[place]), 11))


def _mirrored_folds(p: Parameters, vary: str, exact: dict[str, Fraction], arith: Arithmetic) -> list[tuple[float, ...]]:
    """Folds at −μ₀: those at μ₀ of the mirror image, reflected back."""
    if exact["mu0"] == 0:
        return []
    reflected = p if vary == "theta0" else p.replace(theta0=math.pi - float(p.theta0))
    found = folds(reflected, vary, arith=arith)
    columns = (
        math.pi - found.theta0, -found.mu0, found.kappa, found.alpha, found.sigma, found.beta,
        math.pi - found.theta, found.L, -found.x, found.y, found.error,
    )  # fmt: skip
    return [tuple(map(float, row)) for row in zip(*columns, strict=True)]


def _row(arith: Arithmetic, point: proofs.Point) -> tuple[float, ...]:
    """Middles as floats, and the largest error, the rounding to float included."""
    values, error = [], 0.0
    for interval in (*point.parameters, point.theta, point.L, point.x, point.y):
        low, high = arith.ends(interval)
        middle = (low + high) / 2
        error = max(error, float((high - low) / 2 / max(1, abs(middle))))
        values.append(float(middle))
    if error > 1e-13:
        raise Undecided(f"an error of {error:.1e}")
    return (*values, error + 1.2e-16)


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
    Source: f = f′ = 0; see :mod:`spragsym.fold_curves`. Points satisfy it to rounding.

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
        # Equilibria never cross y = 0 for 0 < θ₀ < π (derive/theorem.py), so one point tells for the whole curve.
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

    def excess(value: float) -> float:
        friction = critical_friction(p.replace(theta0=None, mu0=None, **{vary: value}))
        return math.atan(float(friction)) - math.atan(mu0)  # finite where there is no cusp

    ends = excess(low), excess(high)
    if ends[0] * ends[1] > 0:
        frictions = ", ".join(
            f"{math.tan(end + math.atan(mu0)):.6g} at {vary} = {value:g}" for end, value in zip(ends, (low, high), strict=True)
        )
        raise ParameterError(f"bracket: mu_cusp is {frictions}, both on one side of mu0 = {mu0:g}; widen it")
    root, outcome = brentq(excess, low, high, xtol=1e-300, rtol=8.9e-16, full_output=True, disp=False)
    if not outcome.converged or abs(excess(root)) > 1e-9:
        raise ConvergenceError(
            f"mu_cusp jumps across mu0 = {mu0:g} near {vary} = {root:g}, where a cusp appears; there is no crossing"
        )
    return float(root)


# ----------------------------------------------------------------------------------------------------- flutter


@dataclass(frozen=True)
class FlutterBoundary(Result):
    """Points of the surface at which flutter sets in or ends, in contact with μ₀ ≥ 0 and 0 < θ₀ < π.

    ``branch`` counts the equilibria from below in θ, from 0; ``count`` is how many there are at that point; ``curve`` numbers
    the connected pieces, along which points are in order.
    """

    theta0: FloatArray
    mu0: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    branch: NDArray[np.int64]
    count: NDArray[np.int64]
    curve: NDArray[np.int64]


def flutter_boundary(p: Parameters, n: int = 2000) -> FlutterBoundary:
    """Where the discriminant of (27) in λ² is zero on the equilibrium surface: the Hopf points of the article's Figure 14.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β; ``theta0`` and ``mu0`` are spanned and not used.
    n : int
        Number of directions θ to solve at.

    Notes
    -----
    Source: (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0 with (14), (15): at each θ a polynomial of degree 6 in L, all roots of which are taken.

    Examples
    --------
    >>> found = flutter_boundary(Parameters.article(alpha=0.7))
    >>> bool((abs(found.mu0 - 0.5) < 0.01).any())
    True
    """
    if isinstance(n, bool) or not isinstance(n, int | np.integer) or n < 2:
        raise ParameterError(f"n = {n!r} is not a number of points; give an integer of 2 or more")
    kappa, alpha, sigma, beta = p.scalars(*_FIXED)
    # K12 K21 < 0 with μ₀ > 0 needs sin θ cos θ < 0.
    theta = np.linspace(0.5 * math.pi, math.pi, int(n) + 2)[1:-1]
    with np.errstate(all="ignore"):
        sextic = _stability.flutter_sextic(np.cos(theta), np.sin(theta), kappa, alpha, sigma, beta)
        lengths = _real_positive(np.stack(sextic, axis=-1))
        rows, _ = np.nonzero(np.isfinite(lengths))
        L, theta = lengths[np.isfinite(lengths)], theta[rows]
        c, s = np.cos(theta), np.sin(theta)
        s0, alpha_c0, mu0 = _stability.flutter_point(c, s, L, kappa, alpha, sigma, beta)
        found = []
        for c0 in (alpha_c0 / alpha,) if alpha else (np.sqrt(1 - s0 * s0), -np.sqrt(1 - s0 * s0)):
            x, y = c0 - L * c, s0 - L * s
            on_circle = np.abs(np.hypot(c0, s0) - 1) < 1e-6
            good = on_circle & (s0 > 0) & (mu0 >= 0) & (y < 0)
            found.append(np.stack([np.arctan2(s0, c0), mu0, theta, L, x, y])[:, good])
    points = np.concatenate(found, axis=-1)
    order, curve = _chains(points)
    points = points[:, order]
    branch, count = _branch(p, points)
    return _boundary(points, branch, count, curve)


def flutter_onsets(p: Parameters) -> FlutterBoundary:
    """Points of :func:`flutter_boundary` at the friction μ₀ of ``p``, sorted by θ₀.

    Found between neighbours on the boundary curves, to 1e-12.

    Examples
    --------
    >>> print(np.degrees(flutter_onsets(Parameters.article(alpha=0.7)).theta0).round(6))
    [135.389588 166.068824]
    """
    (mu0,) = p.scalars("mu0")
    along = flutter_boundary(p)
    found = []
    for i in range(along.theta.size - 1):
        ends = along.mu0[i] - mu0, along.mu0[i + 1] - mu0
        if along.curve[i] == along.curve[i + 1] and ends[0] * ends[1] <= 0 and ends[1] != 0:
            found.append(_onset_between(p, along, i, mu0))
    points = np.array(found, dtype=float).reshape(-1, 6).T
    points = points[:, np.argsort(points[0])]
    branch, count = _branch(p, points)
    return _boundary(points, branch, count, np.arange(points.shape[1]))


def _boundary(
    points: FloatArray, branch: NDArray[np.int64], count: NDArray[np.int64], curve: NDArray[np.int64]
) -> FlutterBoundary:
    theta0, mu0, theta, L, x, y = points
    return FlutterBoundary(theta0, mu0, theta, L, x, y, branch, count, curve)


def _onset_between(p: Parameters, along: FlutterBoundary, i: int, mu0: float) -> tuple[float, ...]:
    """The point of friction ``mu0`` on the boundary between two neighbours, by bisection in θ."""
    kappa, alpha, sigma, beta = p.scalars(*_FIXED)
    target = along.L[i]

    def at(theta: float) -> tuple[float, ...]:
        c, s = math.cos(theta), math.sin(theta)
        lengths = _real_positive(np.stack(_stability.flutter_sextic(c, s, kappa, alpha, sigma, beta))[None])[0]
        L = float(lengths[np.nanargmin(np.abs(lengths - target))])
        s0, alpha_c0, friction = _stability.flutter_point(c, s, L, kappa, alpha, sigma, beta)
        c0 = alpha_c0 / alpha if alpha else math.copysign(math.sqrt(max(0.0, 1 - s0 * s0)), math.cos(along.theta0[i]))
        return math.atan2(s0, c0), friction, theta, L, c0 - L * c, s0 - L * s

    theta = brentq(lambda theta: at(theta)[1] - mu0, along.theta[i], along.theta[i + 1], xtol=1e-15, rtol=1e-15)
    return at(float(theta))


def _real_positive(coefficients: FloatArray) -> FloatArray:
    """Positive real roots of each polynomial, lowest power first, NaN for the others."""
    degree = coefficients.shape[-1] - 1
    companion = np.zeros((*coefficients.shape[:-1], degree, degree))
    companion[..., range(1, degree), range(degree - 1)] = 1.0
    companion[..., :, -1] = -coefficients[..., :-1] / coefficients[..., -1:]
    companion[~np.isfinite(companion).all(axis=(-1, -2))] = 0.0
    roots = np.linalg.eigvals(companion)
    real = np.where((np.abs(roots.imag) < 1e-7 * np.abs(roots)) & (roots.real > 0), roots.real, np.nan)
    for _ in range(3):
        value, slope = np.zeros_like(real), np.zeros_like(real)
        for power in range(degree, -1, -1):
            slope = slope * real + value
            value = value * real + coefficients[..., power, None]
        step = value / slope
        real = np.where(np.abs(step) < 0.01 * real, real - step, real)
    return np.sort(real, axis=-1)


def _chains(points: FloatArray) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """An order of the points along curves, nearest neighbour first, and the number of each point's curve."""
    if not points.shape[1]:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    from scipy.spatial import cKDTree

    plane = np.stack([points[0] / math.pi, points[1] / (1 + points[1]), points[2] / math.pi], axis=-1)
    tree = cKDTree(plane)
    reach = 0.02
    left = np.ones(plane.shape[0], dtype=bool)
    order: list[int] = []
    numbers: list[int] = []
    curve = -1
    while left.any():
        curve += 1
        # Start at an end: the remaining point with the smallest θ.
        candidates = np.flatnonzero(left)
        here = int(candidates[np.argmin(points[2, candidates])])
        while True:
            left[here] = False
            order.append(here)
            numbers.append(curve)
            near = [i for i in tree.query_ball_point(plane[here], reach) if left[i]]
            if not near:
                break
            here = int(near[int(np.argmin(((plane[near] - plane[here]) ** 2).sum(axis=-1)))])
    return np.array(order), np.array(numbers)


def _branch(p: Parameters, points: FloatArray) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rank of each point among the equilibria there, and their number.

    From the roots alone: at a flutter onset the solver's stability code would ask for many digits to say what is known.
    """
    theta0, mu0, theta, *_ = points
    kappa, _, sigma, beta = fixed = p.scalars(*_FIXED)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    with np.errstate(all="ignore"):
        p1, q1, p2, q2 = kernel.factors(*kernel.f_coefficients(c0, s0, mu0, *fixed, 1))
        pairs = kernel.root_pair(p1, q1), kernel.root_pair(p2, q2)
        t = np.stack([np.where(square >= 0, root, np.nan) for *roots, square in pairs for root in roots])
        _, _, y = kernel.state((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), c0, s0, kappa, sigma, beta, 1)
        t = np.sort(np.where((t > 0) & (y < 0), t, np.nan), axis=0)
        return np.argmin(np.nan_to_num(np.abs(2 * np.arctan(t) - theta), nan=np.inf), axis=0), np.isfinite(t).sum(axis=0)


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
    from .generated import linear_sprag as _linear

    c0, s0 = np.cos(p.theta0), np.sin(p.theta0)
    with np.errstate(divide="ignore", invalid="ignore"):
        x, y = _linear.displacement(c0, s0, p.mu0, p.kappa, p.alpha, p.sigma, p.beta)
        (K11, K12), (K21, K22) = _stability.stiffness(c0, s0, 1.0, p.mu0, p.alpha, p.sigma, p.beta, 1)
        _, determinant, _ = _stability.invariants(K11, K12, K21, K22)
        e0, e1, e2 = _linear.pole_quadratic(p.mu0, p.alpha, p.sigma, p.beta)
        large = 0.5 * (-e1 + np.sqrt(e1 * e1 - 4 * e0 * e2))
        # T = e0/large and large/e2; the second is infinite for α = 0, a pole at 90°.
        poles = np.stack([np.arctan2(e0, large), np.arctan2(large, e2)], axis=-1)
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
    from .generated import linear_sprag as _linear

    value = np.sqrt(_linear.critical_friction_squared(p.alpha, p.sigma, p.beta))
    return float(value) if np.ndim(value) == 0 else value
