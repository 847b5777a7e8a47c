"""Onsets of flutter: all onsets at one friction, proved complete, and the curves of onsets in the plane of θ₀ and μ₀."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...bifurcation.flutter import Onsets
from ...generated import kernel as solver
from ...generated import stability as _stability
from ...models.parameters import FloatArray, Parameters, as_count
from ...numerics.balls import as_floats, with_enough_bits
from ...numerics.interval_arrays import IntArray
from ...numerics.polynomials import on_circle
from ...questions import NotInClosedForm, of_article
from ...results.points import in_closed_form
from ...results.result import Result
from ..quartic import kernel
from .fixed_parameters import FIXED, Fixed
from .flutter_proofs import Elimination, Onset, onsets
from .fold_points import STATE, in_ranges
from .plane_curves import Condition, curves

#: Logarithm of how far from t = tan(θ/2) = 1 onsets are looked for, at most, and minus that at least.
_FAR = 20.0


def flutter_onsets(
    p: Parameters,
    vary: str | None = None,
    *,
    damping: bool | None = None,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> Onsets:
    """The closed form of :func:`spragsym.flutter_onsets` without damping, along θ₀: proved complete.

    Notes
    -----
    Source: (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0 with (14), (15), eliminated to one polynomial in tan(θ/2 − π/4), whose real roots are
    isolated exactly; see :mod:`spragsym.kang_nam.folds.flutter_proofs`. No onset is a
    fold: there the determinant of K vanishes, here it is positive. For μ₀ = 0, where K is symmetric, there is none.
    """
    if vary not in (None, "theta0") or damping is not False:
        raise NotInClosedForm
    mu0, *fixed = p.scalars("mu0", *FIXED)
    rows = []
    if mu0 > 0:
        elimination = Elimination(*map(Fraction, (mu0, *fixed)))

        def attempt(bits: int) -> list[tuple[float, ...]]:
            return [_row(onset) for onset in onsets(elimination, bits)]

        rows = sorted(with_enough_bits(20, attempt, "flutter_onsets"))
    columns = dict(
        zip(("theta0", *STATE, "branch", "count", "side", "error"), np.array(rows, dtype=float).reshape(-1, 9).T, strict=True)
    )
    values: dict[str, NDArray[Any]] = columns | {
        "omega": _frequency(columns["theta"], columns["L"], *(float(getattr(p, name)) for name in ("alpha", "sigma", "beta"))),
        "branch": columns["branch"].astype(np.int64), "count": columns["count"].astype(np.int64),
        "side": columns["side"].astype(np.int8),
    }  # fmt: skip
    every = Onsets(**in_closed_form(p, ("theta0",), np.full(len(rows), "flutter"), values.pop("error"), values))
    return in_ranges(every, between)


def _frequency(theta: FloatArray, L: FloatArray, alpha: float, sigma: float, beta: float) -> FloatArray:
    """ω of the two modes that meet: ω² is half the trace of K, which has no friction."""
    K = _stability.stiffness(np.cos(theta), np.sin(theta), L, 0.0, alpha, sigma, beta, 1)
    trace, *_ = _stability.invariants(*K[0], *K[1])
    return np.sqrt(0.5 * trace)


def _row(onset: Onset) -> tuple[float, ...]:
    """Middles as floats, rank, number and side, and the largest error, the rounding to float included."""
    values, error = as_floats((onset.theta0, onset.theta, onset.L, onset.x, onset.y))
    return (*values, onset.branch, onset.count, onset.side, error)


# ---------------------------------------------------------------------------------------------------- boundary


@dataclass(frozen=True)
class FlutterBoundary(Result):
    """Points of the surface at which flutter sets in or ends, in contact with μ₀ > 0 and 0 < θ₀ < π.

    Arrays have the shape (points,); angles are radians, lengths over L_0.

    ``branch`` counts the equilibria from below in θ, from 0; ``count`` is how many there are at that point; ``curve`` numbers
    the connected pieces, along which points are in order.
    """

    theta0: FloatArray
    mu0: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    branch: IntArray
    count: IntArray
    curve: IntArray


@of_article("onset_curves(p, vary) has the curves of onsets in the plane of two parameters")
def flutter_boundary(p: Parameters, n: int = 2000) -> FlutterBoundary:
    """Where the discriminant of (27) in λ² is zero on the equilibrium surface: the Hopf points of the article's Figure 14.

    Parameters
    ----------
    p : Parameters
        Scalars κ, α, σ, β; ``theta0`` and ``mu0`` are spanned and not used.
    n : int
        About how many directions θ to solve at.

    Returns
    -------
    FlutterBoundary
        Points that satisfy the condition to rounding, each once.

    Raises
    ------
    ParameterError, ParameterTypeError
        For parameters that are missing or no scalars, and ``n`` below 2.

    Notes
    -----
    Source: (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0 with (14), (15): at each θ a polynomial of degree 6 in tan(θ₀/2), all positive roots of
    which are taken; see ``plane_curves``. The curves are sampled in θ: one that begins and ends between two
    neighbours is not seen. Whether an onset exists at a given friction is for :func:`flutter_onsets` to say, which misses none.

    Examples
    --------
    >>> found = flutter_boundary(Parameters.article(alpha=0.7))
    >>> bool((abs(found.mu0 - 0.5) < 0.01).any())
    True
    """
    as_count("n", n, 2)
    fixed = Fixed(*p.scalars(*FIXED))
    kappa, _, sigma, beta = fixed
    found = []
    directions = 1 + np.exp(np.linspace(-_FAR, _FAR, n // 2))  # flutter needs π/2 < θ < π
    for number, (t, theta0, mu0) in enumerate(curves(_ONSET, fixed, directions, 6 / n)):
        with np.errstate(all="ignore"):
            L, x, y = kernel.state(*on_circle(t)[:2], np.cos(theta0), np.sin(theta0), kappa, sigma, beta, 1)
        good = (y < 0) & (mu0 > 0)
        found.append(np.stack([theta0, mu0, 2 * np.arctan(t), L, x, y, np.full(t.size, number)])[:, good])
    theta0, mu0, theta, L, x, y, curve = np.concatenate(found, axis=-1) if found else np.empty((7, 0))
    branch, count = _rank(fixed, theta0, mu0, theta)
    _, curve = np.unique(curve, return_inverse=True)
    return FlutterBoundary(theta0, mu0, theta, L, x, y, branch, count, curve)


def _polynomial(c: FloatArray, s: FloatArray, fixed: Fixed) -> tuple[FloatArray, ...]:
    """Derived: ``flutter_cubic``."""
    g0, g1, k0, k1, k2, k3 = _stability.flutter_cubic(c, s, *fixed)
    middle = 3 * k0 + 4 * k2
    return g0 - k0, 2 * (g1 - k1), g0 - middle, -4 * k1 - 8 * k3, -g0 - middle, -2 * (g1 + k1), -g0 - k0


def _friction(c: FloatArray, s: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    kappa, alpha, sigma, beta = fixed
    L, _, _ = kernel.state(c, s, np.cos(theta0), np.sin(theta0), kappa, sigma, beta, 1)
    return _stability.flutter_friction(c, s, L, alpha, sigma, beta)


_ONSET = Condition(_polynomial, _friction)


def _rank(fixed: Fixed, theta0: FloatArray, mu0: FloatArray, theta: FloatArray) -> tuple[IntArray, IntArray]:
    """Rank of each point among the equilibria there, and their number.

    From the roots alone: at a flutter onset the solver's stability code would ask for many digits to say what is known.
    """
    kappa, _, sigma, beta = fixed
    c0, s0 = np.cos(theta0), np.sin(theta0)
    with np.errstate(all="ignore"):
        trig = kernel.f_coefficients(c0, s0, mu0, *fixed, 1)
        p1, q1, p2, q2 = solver.factors(solver.quartic(*trig), solver.cubic(*trig))
        pairs = solver.root_pair(p1, q1), solver.root_pair(p2, q2)
        t = np.stack([np.where(square >= 0, root, np.nan) for *roots, square in pairs for root in roots])
        _, _, y = kernel.state(*solver.direction(t), c0, s0, kappa, sigma, beta, 1)
        t = np.sort(np.where((t > 0) & (y < 0), t, np.nan), axis=0)
        return np.argmin(np.nan_to_num(np.abs(2 * np.arctan(t) - theta), nan=np.inf), axis=0), np.isfinite(t).sum(axis=0)
