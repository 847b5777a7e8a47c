"""Every fold curve in the plane of θ₀ and μ₀ with the cusps on them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ...errors import ConvergenceError
from ...generated import catastrophe as _catastrophe
from ...models.parameters import FloatArray, Parameters, as_count
from ...numerics.half_angle import on_circle
from ...questions import NotInClosedForm
from ...results.bifurcation_sets import BifurcationSet, Curve
from ..quartic import kernel
from . import fold_curves
from .cusp_points import cusps
from .fixed_parameters import FIXED, Fixed
from .fold_points import folds

#: Where κ over the larger of σ and 1 + β is below this, float64 may lose curves: they are compared with proved folds.
_LIGHT = 1e-4
#: Where it is below this, float64 does lose them, and they are refused.
_TOO_LIGHT = 1e-8
#: Frictions at which curves are compared with proved folds.
_SAMPLED = (0.11, 1.3, 7.1)


def bifurcation_set(p: Parameters, vary: Sequence[str] | None = None, n: int | None = None) -> BifurcationSet:
    """The closed form of :func:`spragsym.bifurcation_set` in (θ₀, μ₀) for 0 < θ₀ < π and μ₀ ≥ 0.

    Notes
    -----
    Source: f = f′ = 0; see :mod:`.fold_curves`. Where curves begin, end, turn back in θ and reach μ₀ = 0 is
    isolated exactly, so that none is missed, however small; their points are float64, and satisfy the condition to rounding.
    """
    if vary is not None and tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    n = as_count("n", 2000 if n is None else n, 2)
    fixed = Fixed(*p.scalars(*FIXED))
    preload = fixed.kappa / max(fixed.sigma, 1 + fixed.beta)
    if preload < _TOO_LIGHT:
        raise _indistinct(fixed.kappa, "they all but coincide")
    curves = []
    for strand in fold_curves.strands(fixed, n):
        c, s = np.cos(strand.theta), np.sin(strand.theta)
        _, x, y = kernel.state(c, s, np.cos(strand.theta0), np.sin(strand.theta0), fixed.kappa, fixed.sigma, fixed.beta, 1)
        # Equilibria never cross y = 0 for 0 < θ₀ < π (derive/kang_nam/theorem.py), so one point tells for the whole curve.
        if y[y.size // 2] < 0:
            curves.append(_curve(strand, x, y, fixed))
    if preload < _LIGHT:
        _compare(curves, p)
    found = cusps(p)
    ahead = (found.theta0 > 0) & (found.theta0 < math.pi) & (found.mu0 >= 0)
    return BifurcationSet(("theta0", "mu0"), tuple(curves), found.select(ahead), True)


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


def _curve(strand: fold_curves.Strand, x: FloatArray, y: FloatArray, fixed: Fixed) -> Curve:
    """A strand with what ends on it, and where that jumps to."""
    c, s, c0, s0 = np.cos(strand.theta), np.sin(strand.theta), np.cos(strand.theta0), np.sin(strand.theta0)
    with np.errstate(all="ignore"):  # at the ends of a curve θ₀ may be 0 or π
        trig = kernel.f_coefficients(c0, s0, strand.mu0, *fixed, 1)
        curvature = np.sign(kernel.f_curvature(c, s, *trig))
        changes = _catastrophe.unfolding(c, s, c0, s0, strand.mu0, *fixed)
        after = on_circle(kernel.landing(np.tan(0.5 * strand.theta), trig, np.sqrt))
        _, x_after, y_after = kernel.state(after.cosine, after.sine, c0, s0, fixed.kappa, fixed.sigma, fixed.beta, 1)
    by_angle, by_friction = ((curvature * np.sign(change[0])).astype(np.int8) for change in changes[:2])
    theta_after = np.arctan2(after.sine, after.cosine)
    return Curve({
        "theta0": strand.theta0, "mu0": strand.mu0, "theta": strand.theta, "x": x, "y": y, "upper": curvature > 0,
        "when_theta0": by_angle, "when_mu0": by_friction, "theta_after": theta_after, "x_after": x_after, "y_after": y_after,
    })  # fmt: skip
