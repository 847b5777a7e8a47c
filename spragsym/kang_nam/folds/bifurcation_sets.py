"""Every fold curve in the plane of θ₀ and μ₀ with the cusps on them."""

import math
from collections.abc import Sequence

import numpy as np

from ...errors import ConvergenceError
from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray, Parameters, as_count
from ...numerics.polynomials import on_circle
from ...questions import NotInClosedForm
from ...results.points import BifurcationSet, Curve
from ..quartic import kernel
from .cusp_points import cusps
from .fixed_parameters import FIXED, Fixed
from .fold_events import directions, fold_polynomial
from .fold_points import folds
from .plane_curves import Condition, curves

#: Where κ over the larger of σ and 1 + β is below this, float64 may lose curves: they are compared with proved folds.
_LIGHT = 1e-4
#: Where it is below this, float64 does lose them, and they are refused.
_TOO_LIGHT = 1e-8
#: Frictions at which curves are compared with proved folds.
_SAMPLED = (0.11, 1.3, 7.1)
#: Logarithm of the largest t = tan(θ/2) in which folds are looked for.
_FAR = 17.0


def bifurcation_set(p: Parameters, vary: Sequence[str] | None = None, n: int | None = None) -> BifurcationSet:
    """The closed form of :func:`spragsym.bifurcation_set` in (θ₀, μ₀) for 0 < θ₀ < π and μ₀ ≥ 0.

    Notes
    -----
    Source: f = f′ = 0, two lines in μ₀ at a given direction θ; without it a conic in (cos θ₀, sin θ₀). Where curves begin, end,
    turn back in θ and reach μ₀ = 0 is isolated exactly, and how many folds there are in between is counted exactly, so that none
    is missed that holds a float; their points are float64, and satisfy the condition to rounding. See :mod:`.plane_curves`.
    """
    if vary is not None and tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    n = as_count("n", 2000 if n is None else n, 2)
    fixed = Fixed(*p.scalars(*FIXED))
    preload = fixed.kappa / max(fixed.sigma, 1 + fixed.beta)
    if preload < _TOO_LIGHT:
        raise _indistinct(fixed.kappa, "they all but coincide")
    on_them = cusps(p)
    ahead = (on_them.theta0 > 0) & (on_them.theta0 < math.pi) & (on_them.mu0 >= 0)
    on_them = on_them.select(ahead)
    found, begin = [], directions(fixed)
    t = np.concatenate([np.exp(np.linspace(-_FAR, _FAR, n // 4)), begin.t, np.abs(np.tan(on_them.theta / 2))])
    for points in curves(Condition(fold_polynomial, _friction, begin.folds_at), fixed, t, 3 / n):
        curve = _curve(points, fixed)
        # Equilibria never cross y = 0 for 0 < θ₀ < π (derive/kang_nam/theorem.py), so one point tells for the whole curve.
        if curve.y[len(curve) // 2] < 0:
            found.append(curve)
    if preload < _LIGHT:
        _compare(found, p)
    return BifurcationSet(("theta0", "mu0"), tuple(found), on_them, True)


def _friction(c: FloatArray, s: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    """From the relation that does not lose it: the first has the factor cos θ."""
    u1, w1, u2, w2 = _catastrophe.fold_lines_mu0(c, s, np.cos(theta0), np.sin(theta0), *fixed)
    return np.where(np.abs(c) > 0.3, -u1 / w1, -u2 / w2)


def _compare(curves: list[Curve], p: Parameters) -> None:
    """Refuse curves that do not cross some frictions as often as folds are proved to be there."""
    for mu0 in _SAMPLED:
        crossings = sum(int(np.count_nonzero(np.diff(curve.mu0 > mu0))) for curve in curves)
        proved = folds(p.replace(mu0=mu0)).theta0.size
        if crossings != proved:
            raise _indistinct(float(p.kappa), f"at mu0 = {mu0} they have {crossings} where {proved} are proved")


def _indistinct(kappa: float, reason: str) -> ConvergenceError:
    return ConvergenceError(
        f"kappa = {kappa:g} is too small beside sigma and 1 + beta for curves of folds in float64: {reason}; "
        "folds(p) proves those at one friction"
    )


def _curve(points: FloatArray, fixed: Fixed) -> Curve:
    """A curve with what ends on it, and where that jumps to."""
    t, theta0, mu0 = points
    c, s, _ = on_circle(t)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    with np.errstate(all="ignore"):  # at the ends of a curve θ₀ may be 0 or π
        trig = kernel.f_coefficients(c0, s0, mu0, *fixed, 1)
        curvature = np.sign(kernel.f_curvature(c, s, *trig))
        changes = _catastrophe.unfolding(c, s, c0, s0, mu0, *fixed)
        after = on_circle(kernel.landing(t, trig, np.sqrt))
        (_, x, y), (_, x_after, y_after) = (
            kernel.state(*at[:2], c0, s0, fixed.kappa, fixed.sigma, fixed.beta, 1) for at in ((c, s), after)
        )
    by_angle, by_friction = ((curvature * np.sign(change[0])).astype(np.int8) for change in changes[:2])
    return Curve({
        "theta0": theta0, "mu0": mu0, "theta": 2 * np.arctan(t), "x": x, "y": y, "upper": curvature > 0,
        "when_theta0": by_angle, "when_mu0": by_friction, "theta_after": np.arctan2(after.sine, after.cosine),
        "x_after": x_after, "y_after": y_after,
    })  # fmt: skip
