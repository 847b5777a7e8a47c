"""Curves of Hopf points of the article's model in the plane of θ₀ and μ₀, in closed form.

They are the states at which K₂₁ = 0, an upright spring, of which μ₀ is a function of θ₀; and those
at which K₁₂ = 0, where at each direction θ μ₀ is a function of θ₀, and tan(θ₀/2) a root of a
quartic (derived: ``coupling_conic``).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ..bifurcation import hopf_curves
from ..bifurcation.bifurcation_sets import FoldCurves, OnLines, unknown_scales
from ..bifurcation.defining_systems import NO_SLOPE, Augmented
from ..bifurcation.flutter import OnsetSystems, Sought
from ..bifurcation.hopf_curves import OnsetCurves
from ..bifurcation.options import ContinuationOptions
from ..core.questions import NotInClosedForm
from ..generated import stability as _stability
from ..models.parameters import FloatArray, Ranges, as_count
from ..numerics.interval_arrays import quiet
from ..numerics.polynomials import on_circle
from . import kernel
from .bifurcation_sets import CurveCondition, curves
from .flutter import flutter_onsets
from .kernel import Fixed
from .parameters import Parameters

#: Directions at which a curve is solved for; about a fiftieth of them is kept.
_DIRECTIONS = 2000
#: Logarithm of the distance from its ends at which a curve begins.
_FAR = 20.0


def onset_curves(
    p: Parameters,
    vary: Sequence[str] | None = None,
    n: int = 30,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
    options: ContinuationOptions | None = None,
) -> OnsetCurves:
    """The closed form of :func:`spragsym.onset_curves` over θ₀ and μ₀, with damping.

    Notes
    -----
    Source: with damping K₁₂ K₂₁ = 0, see :mod:`.hopf`. Frictions end, unless ``between`` says
    where, above those of all Hopf points. ``lines`` are frictions; on each, the curves have as many
    points as :func:`spragsym.flutter_onsets` proves, or the result is not complete.
    """
    vary = ("theta0", "mu0") if vary is None else tuple(vary)
    fixed = Fixed(*p.scalars(*Fixed._fields))
    if set(vary) != {"theta0", "mu0"} or damping is False or not min(p.scalars("V", "d")) > 0:
        raise NotInClosedForm
    as_count("n", n, 2)
    options = options or ContinuationOptions()
    ends = {"mu0": (0.0, 1.1 * _highest(fixed)), **(between or {})}
    (plane,) = FrictionPlane.every(p, vary, ends, options=options.given_search)
    return plane.curves(n, True, options)


def _highest(fixed: Fixed) -> float:
    """A friction above those of all Hopf points.

    Of an upright spring μ₀ is largest where sin θ₀ = σ/(κ + σ): q α/√(κ (κ + 2 σ)). Where K₁₂ = 0
    it is less than q sin θ |cos θ|, since σ sin θ < σ sin θ + B sin θ₀ + κ.
    """
    q = 1 + fixed.beta + fixed.sigma
    return max(q * fixed.alpha / math.sqrt(fixed.kappa * (fixed.kappa + 2 * fixed.sigma)), q / 2)


class FrictionPlane(hopf_curves.Plane):
    """The plane of θ₀ and μ₀ of the article's model."""

    def systems(self, damping: bool | None) -> OnsetSystems:
        """Without those of a slope of 0, since where μ₀ > 0 the friction law damps."""
        found = super().systems(damping)
        sought = [one for one in found.sought if one.condition is not NO_SLOPE]
        return replace(found, sought=sought)

    def traced(
        self, sought: Sought, n: int, ends: FloatArray, options: ContinuationOptions
    ) -> OnLines:
        """All Hopf points, as curves in closed form that are compared on ``n`` frictions."""
        fixed = Fixed(*self.p.scalars(*Fixed._fields))
        order = [("x", "y", "theta0", "mu0").index(name) for name in ("x", "y", *self.vary)]
        each = [chain[order] for chain in (*_upright(fixed), *_uncoupled(fixed))]
        parts = [part for chain in each for part in self._inside(chain)]
        scale = unknown_scales(np.concatenate([np.empty((4, 0)), *parts], axis=1), self.spans, 0.0)
        on = FoldCurves(Augmented(self, sought.condition), scale, options, self.alike)
        chains = on.joined([_thinned(part, scale, n) for part in parts])
        lines = self._lines(parts, n)
        said = tuple(self._differences(each, lines))
        return OnLines(on, chains, {"mu0": lines}, np.empty((2, 4, 0)).T, not said, said)

    def _inside(self, chain: FloatArray) -> list[FloatArray]:
        """The parts of a chain with both parameters within their ranges."""
        low, high = self.spans[:, :1], self.spans[:, 1:]
        inside = ((low <= chain[-2:]) & (chain[-2:] <= high)).all(axis=0)
        cuts = np.flatnonzero(np.diff(inside)) + 1
        parts = zip(np.split(chain, cuts, axis=1), np.split(inside, cuts), strict=True)
        return [part for part, good in parts if good.any() and part.shape[1] > 1]

    def _lines(self, parts: Sequence[FloatArray], n: int) -> FloatArray:
        """Frictions in the middle of ``n`` strips, and one more for each part that none crosses."""
        row = self.vary.index("mu0") - 2
        low, high = self.spans[row]
        lines = low + (high - low) * (np.arange(n) + 0.5) / n
        ends = [(part[row].min(), part[row].max()) for part in parts]
        more = [
            0.5 * (least + most)
            for least, most in ends
            if not ((least < lines) & (lines < most)).any()
        ]
        return np.sort(np.append(lines, more))

    def _differences(self, chains: Sequence[FloatArray], lines: FloatArray) -> Iterator[str]:
        """A remark for each friction at which the curves have not as many points as are proved."""
        angle, friction = (self.vary.index(name) - 2 for name in ("theta0", "mu0"))
        low, high = self.spans[angle]
        for value in lines.tolist():
            proved = flutter_onsets(self.p.replace(mu0=value), between={"theta0": (low, high)})
            crossed = 0
            for chain in chains:
                gap = chain[friction] - value
                (at,) = np.nonzero(np.diff(gap > 0))
                share = gap[at] / (gap[at] - gap[at + 1])
                angles = chain[angle][at] + share * np.diff(chain[angle])[at]
                crossed += int(((low <= angles) & (angles <= high)).sum())
            if crossed != len(proved):
                yield (
                    f"at mu0 = {value:.6g} the curves have {crossed} onsets where {len(proved)} "
                    "are proved"
                )


def _upright(fixed: Fixed) -> Iterator[FloatArray]:
    """The curve with θ = π/2: x, y, θ₀ and μ₀; for α = 0 there is none."""
    if not fixed.alpha:
        return
    steps = np.linspace(-_FAR, _FAR, _DIRECTIONS)
    # cos θ₀ keeps its digits near θ₀ = π/2
    c0, s0, _ = on_circle(1 / (1 + np.exp(-steps)))
    _, x, y = kernel.state_of(0.0, 1.0, c0, s0, *fixed)
    yield np.array([x, y, np.arctan2(s0, c0), _stability.upright_friction(c0, s0, *fixed)])


def _uncoupled(fixed: Fixed) -> Iterator[FloatArray]:
    """The curves with K₁₂ = 0: x, y, θ₀ and μ₀. All of their states are in contact, as of every
    state with cos θ < 0.
    """
    directions = 1 + np.exp(np.linspace(-_FAR, _FAR, _DIRECTIONS))
    condition = CurveCondition(_polynomial, _friction)
    for t, theta0, mu0 in curves(condition, fixed, directions, 3 / _DIRECTIONS):
        with quiet():  # at the ends of a curve θ₀ may be 0 or π
            _, x, y = kernel.state_of(*on_circle(t)[:2], *kernel.cos_sin(theta0), *fixed)
        yield np.array([x, y, theta0, mu0])


def _polynomial(c: FloatArray, s: FloatArray, fixed: Fixed) -> tuple[FloatArray, ...]:
    """The condition K₁₂ = 0 in a direction as a polynomial in tan(θ₀/2), lowest power first."""
    g0, g1, k0, k1, k2 = _stability.coupling_conic(c, s, *fixed)
    return g0 - k0, 2 * (g1 - k1), -2 * k0 - 4 * k2, -2 * (g1 + k1), -g0 - k0


def _friction(c: FloatArray, s: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    kappa, _, *springs = fixed
    return _stability.coupling_friction(c, s, np.sin(theta0), kappa, *springs)


def _thinned(chain: FloatArray, scale: FloatArray, n: int) -> FloatArray:
    """About ``n`` points of a chain for each length of 1 over the scales, and both ends."""
    steps = np.linalg.norm(np.diff(chain / scale[:, None]), axis=0)
    along = np.append(0.0, np.cumsum(steps))
    wanted = np.linspace(0.0, along[-1], 3 + int(n * along[-1]))
    return chain[:, np.unique(np.abs(along - wanted[:, None]).argmin(axis=1))]
