"""Onsets of flutter: all onsets at one friction, proved complete, and curves of onsets in the plane
of θ₀ and μ₀.

At given θ and μ₀ the balance of forces gives sin θ₀ and α cos θ₀ as linear functions of the spring
length L. The discriminant of (27) times L², and cos² θ₀ + sin² θ₀ = 1, are then quadratics in L.
Their resultant (derived: ``flutter_elimination``) is a polynomial of degree 16 in v = tan((θ −
π/2)/2). A discriminant of 0 needs K₁₂ K₂₁ ≤ 0, hence π/2 ≤ θ < π if μ₀ > 0: all onsets are among
the roots 0 ≤ v < 1, which Descartes' rule isolates exactly. For α = 0, cos θ₀ is free, and the
polynomial has degree 8 (``flutter_without_alpha``). Signs decide whether a root is an onset; if an
interval contains 0, exact algebra decides whether the value is 0.

An onset is never a fold, nor the middle one of three equilibria: in contact the trace of K is
positive (derived: ``trace_identity``), and where the discriminant is 0 the determinant is a quarter
of the square of the trace.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from ..bifurcation.flutter import Onsets
from ..core.questions import NotInClosedForm
from ..generated import stability as _stability
from ..models.parameters import FloatArray, Ranges, as_count
from ..numerics import balls, polynomials
from ..numerics.arithmetic import Number
from ..numerics.balls import Interval, UndecidedSign, atan2, decided, sign, with_enough_bits
from ..numerics.interval_arrays import IntArray, quiet
from ..numerics.polynomials import (
    RootOf,
    eigenvalues,
    in_t,
    on_circle,
    real_roots,
    roots_on_the_line,
)
from ..results import Result
from . import kernel
from .bifurcation_sets import CurveCondition, curves
from .folds import SurfacePoint, cosines_of, listed, within
from .kernel import Fixed
from .only import of_article
from .parameters import Parameters


def flutter_onsets(
    p: Parameters,
    vary: str | None = None,
    *,
    damping: bool | None = None,
    between: Ranges | None = None,
) -> Onsets:
    """The closed form of :func:`spragsym.flutter_onsets` along θ₀: proved complete.

    Notes
    -----
    Source: with damping K₁₂ K₂₁ = 0, see :mod:`.hopf`. Without, (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0 with
    (14), (15), eliminated to one polynomial in tan(θ/2 − π/4), whose real roots are isolated
    exactly. No onset of (27) is a fold: there the determinant of K vanishes, here it is positive.
    For μ₀ = 0, where K is symmetric, there is none.
    """
    if vary not in (None, "theta0"):
        raise NotInClosedForm
    exact = tuple(map(Fraction, p.scalars("mu0", *Fixed._fields)))
    if damping is None:  # the slope of the friction law is not 0, however small
        damping = exact[0] > 0
    if damping and not (exact[0] > 0 and min(p.scalars("V", "d")) > 0):
        raise NotInClosedForm

    def attempt(bits: int) -> list[tuple[tuple[float, ...], Onset]]:
        from .hopf import hopf_points  # which stands on this module

        points = hopf_points(exact, bits) if damping else onsets(Elimination(*exact), bits)
        return sorted(((onset.row("theta0"), onset) for onset in points), key=lambda one: one[0])

    found = with_enough_bits(20, attempt, "flutter_onsets") if exact[0] else []
    rows = [row for row, _ in found]
    branch, count, side, slope = (
        np.array([(one.branch, one.count, one.side, one.slope) for _, one in found], dtype=int)
        .reshape(-1, 4)
        .T
    )
    theta, L = np.array([row[1:3] for row in rows]).reshape(-1, 2).T
    # ω² is K₂₂ at a Hopf point. Of two modes that meet it is half the trace. Neither has μ₀ in it.
    (K11, _), (_, K22) = kernel.stiffness(
        *kernel.cos_sin(theta), L, 0.0, *p.scalars(*Fixed._fields[1:]), 1
    )
    omega = np.sqrt(K22 if damping else 0.5 * (K11 + K22))
    more = {"omega": omega, "branch": branch, "count": count, "side": side.astype(np.int8)}
    # A pair grows on one side; where f′ < 0 a real λ grows on both.
    more |= {
        name: np.where(side == 0, -1, (slope < 0) + 2 * (side == beyond)).astype(np.int8)
        for name, beyond in (("unstable_before", -1), ("unstable_after", 1))
    }
    points = listed(p, ("theta0",), np.full(len(rows), "hopf" if damping else "flutter"), rows)
    return within(Onsets(**vars(replace(points, _values={**points._values, **more}))), between)


# ------------------------------------------------------------------------------------------------
# boundary


@dataclass(frozen=True, eq=False)
class FlutterBoundary(Result):
    """Points of the surface at which flutter sets in or ends, in contact with μ₀ > 0 and 0 < θ₀ <
    π.

    Arrays have the shape (points,); angles are radians, lengths over L_0.

    ``branch`` counts the equilibria from below in θ, from 0; ``count`` is how many there are at
    that point; ``curve`` numbers the connected pieces, along which points are in order.
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
    """Boundary of flutter on the equilibrium surface, where the discriminant of (27) in λ² is zero:
    the Hopf points of the article's Figure 14.

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
    Source: (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0 with (14), (15): at each θ a polynomial of degree 6 in
    tan(θ₀/2), all positive roots of which are taken; see :mod:`.bifurcation_sets`. The curves are
    sampled in θ: one that begins and ends between two neighbours is not seen. Whether an onset
    exists at a given friction is for :func:`flutter_onsets` to say, which misses none.

    Examples
    --------
    >>> found = flutter_boundary(Parameters.article(alpha=0.7))
    >>> bool((abs(found.mu0 - 0.5) < 0.01).any())
    True
    """
    as_count("n", n, 2)
    fixed = Fixed(*p.scalars(*Fixed._fields))
    found = []
    far = 20.0  # directions t have |log(t − 1)| up to this
    directions = 1 + np.exp(np.linspace(-far, far, n // 2))  # flutter needs π/2 < θ < π
    onset = CurveCondition(_polynomial, _friction)
    for number, (t, theta0, mu0) in enumerate(curves(onset, fixed, directions, 6 / n)):
        with quiet():
            L, x, y = kernel.state_of(*on_circle(t)[:2], *kernel.cos_sin(theta0), *fixed)
        good = (y < 0) & (mu0 > 0)
        found.append(
            np.stack([theta0, mu0, 2 * np.arctan(t), L, x, y, np.full(t.size, number)])[:, good]
        )
    *places, curve = np.concatenate(found, axis=-1) if found else np.empty((7, 0))
    _, curve = np.unique(curve, return_inverse=True)
    branch, count = _rank(fixed, *places[:3])
    return FlutterBoundary(*[*places, branch, count, curve])


def _polynomial(c: FloatArray, s: FloatArray, fixed: Fixed) -> tuple[FloatArray, ...]:
    """The condition for an onset as a polynomial in tan(θ₀/2), from ``flutter_cubic``."""
    g0, g1, k0, k1, k2, k3 = _stability.flutter_cubic(c, s, *fixed)
    middle = 3 * k0 + 4 * k2
    return (
        g0 - k0,
        2 * (g1 - k1),
        g0 - middle,
        -4 * k1 - 8 * k3,
        -g0 - middle,
        -2 * (g1 + k1),
        -g0 - k0,
    )


def _friction(c: FloatArray, s: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    """The friction of onsets."""
    L, _, _ = kernel.state_of(c, s, *kernel.cos_sin(theta0), *fixed)
    return _stability.flutter_friction(c, s, L, *fixed[1:])


def _rank(
    fixed: Fixed, theta0: FloatArray, mu0: FloatArray, theta: FloatArray
) -> tuple[IntArray, IntArray]:
    """The rank of each point among the equilibria there, and their number.

    The roots of the quartic are computed directly: the solver would spend many digits on the
    stability at an onset, which is known.
    """
    c0, s0 = kernel.cos_sin(theta0)
    with quiet():
        quartic = kernel.t_quartic(*kernel.f_coefficients(c0, s0, mu0, *fixed, 1))
        roots = eigenvalues(np.stack(quartic, axis=-1)).T
        t = np.where(roots.imag == 0, roots.real, np.nan)
        _, _, y = kernel.state_of(*on_circle(t)[:2], c0, s0, *fixed)
        t = np.sort(np.where((t > 0) & (y < 0), t, np.nan), axis=0)
        return np.argmin(
            np.nan_to_num(np.abs(2 * np.arctan(t) - theta), nan=np.inf), axis=0
        ), np.isfinite(t).sum(axis=0)


#: Largest degree of X and Y in L = X/Y.
_DEGREE_OF_LENGTH = 4


@dataclass(frozen=True)
class Onset(SurfacePoint):
    """An onset in interval arithmetic.

    ``branch`` is its rank in θ, from 0, among the ``count`` equilibria. ``side`` is 1 if the pair
    grows at larger θ₀, −1 if at smaller θ₀, and 0 if on both sides or on neither. ``slope`` is the
    sign of f′, and of det K.
    """

    branch: int
    count: int
    side: int
    slope: int


class Elimination:
    """The eliminated condition for an onset, for exact parameters μ₀ > 0, κ, α, σ and β."""

    #: Degree of :meth:`remaining` in cos θ and sin θ.
    degree = 8
    #: The sign, where the pair grows, of the quantity that is 0 at an onset.
    grows = -1

    def __init__(self, *values: Fraction) -> None:
        self.values, self.alpha = values, values[2]

    def remaining(self, c: Fraction, s: Fraction) -> Fraction:
        """The condition in a direction."""
        mu0, kappa, _, *springs = self.values
        if not self.alpha:
            return _stability.flutter_without_alpha(c, s, mu0, kappa, *springs)
        X, Y, Z = _stability.flutter_elimination(c, s, *self.values)
        return X * X - Y * Z

    def crossing(self, *onset: Any) -> tuple[Any, int]:
        """N and the sign of J = f′: that quantity changes by N/J per unit of θ₀."""
        change, _ = _stability.flutter_crossing(*onset)
        return change, 1  # no onset of (27) is divergent

    @cached_property
    def full(self) -> tuple[int, ...]:
        """The polynomial in v, with multiple roots."""
        return polynomials.interpolate(in_v(self.remaining, self.degree), 2 * self.degree)

    @cached_property
    def simple(self) -> tuple[int, ...]:
        """The square-free polynomial, with each root once."""
        return polynomials.squarefree(self.full)

    def roots(self, bits: int) -> list[RootOf]:
        """All roots in 0 ≤ v < 1, in intervals narrower than 2^−bits."""
        zero, one = Fraction(0), Fraction(1)
        upright = [(zero, zero)] if self.simple[0] == 0 else []
        places = [*upright, *real_roots(self.simple, zero, one, bits)]
        return [RootOf(self.simple, low, high) for low, high in places if low < 1]

    def length(self, c: Number, s: Number, values: tuple[Any, ...]) -> tuple[Any, Any]:
        """X and Y of L = X/Y."""
        if self.alpha:
            X, Y, _ = _stability.flutter_elimination(c, s, *values)
            return X, Y
        _, _, u2, w2 = _stability.reference_lines(c, s, *values)
        return -u2, w2

    def sign_of(
        self, root: RootOf, value: Interval, function: Callable[..., Any], degree: int, what: str
    ) -> int:
        """The sign of a value at a root; 0 if ``function(c, s, X, Y)``, of that degree in cos θ and
        sin θ, is exactly 0 there.
        """
        exactly = in_v(lambda c, s: function(c, s, *self.length(c, s, self.values)), degree)
        return root.sign_of(value, exactly, 2 * degree, what)

    def multiplicity(self, root: RootOf) -> int:
        """The multiplicity of a root."""
        multiplicity, derivative = 0, self.full
        while root.is_of(polynomials.common_divisor(self.simple, derivative)):
            multiplicity, derivative = multiplicity + 1, polynomials.derivative(derivative)
        return multiplicity


def direction(v: Number) -> tuple[Any, Any]:
    """cos θ and sin θ at v = tan((θ − π/2)/2)."""
    c, s, _ = on_circle(v)
    return -s, c


def in_v(function: Callable[[Any, Any], Any], degree: int) -> Callable[[Fraction], Fraction]:
    """(1 + v²)^degree times a function of that degree in cos θ and sin θ: a polynomial in v."""
    return in_t(lambda c, s: function(-s, c), degree)


def onsets(elimination: Elimination, bits: int) -> Iterator[Onset]:
    """Every onset with 0 < θ₀ < π, in contact."""
    values = tuple(map(balls.exact, elimination.values))
    for root in elimination.roots(bits - 32):
        lengths = _lengths(elimination, root, values)
        for L in lengths:
            yield from _at_length(elimination, root, L, values, bits, alone=len(lengths) == 1)


def _lengths(
    elimination: Elimination, root: RootOf, values: tuple[Interval, ...]
) -> list[Interval]:
    """The common roots L > 0 of the two quadratics: one, or two if the quadratics are
    proportional.
    """
    c, s = direction(root.interval())
    X, Y = elimination.length(c, s, values)
    if elimination.sign_of(root, Y, lambda c, s, X, Y: Y, _DEGREE_OF_LENGTH, "Y = 0"):
        L = X / Y
        return [L] if decided(L, "L = 0") > 0 else []
    mu0, _, *springs = values
    e0, e1, e2 = _stability.flutter_quadratic(c, s, mu0, *springs)
    square = e1 * e1 - 4 * e0 * e2
    if decided(square, "a double spring length") < 0 or decided(e1, "e1 = 0") > 0:
        return []
    return [(-e1 + way * balls.sqrt(square)) / (2 * e2) for way in (1, -1)]


def _at_length(
    elimination: Elimination,
    root: RootOf,
    L: Interval,
    values: tuple[Interval, ...],
    bits: int,
    *,
    alone: bool,
) -> Iterator[Onset]:
    """The onsets with a spring length: those θ₀ in (0, π) that the balance of forces gives.

    All are in contact, since cos θ ≤ 0 and μ₀ > 0. Proof: if y ≥ 0, the balance across the belt
    needs L > 1, and the balance along it, α x = −μ₀ y + σ (L − 1) cos θ, needs x ≤ 0, or y = cos θ
    = 0 if α = 0. Hence sin θ₀ ≥ L sin θ and, unless cos θ = 0, −cos θ₀ ≥ −L cos θ, so that 1 ≥ L²,
    a contradiction.
    """
    v = root.interval()
    c, s = direction(v)
    mu0, kappa, *springs = values
    u1, w1, u2, w2 = _stability.reference_lines(c, s, *values)
    s0 = u1 + w1 * L

    def sine(c: Number, s: Number, X: Number, Y: Number) -> Number:
        u1, w1, _, _ = _stability.reference_lines(c, s, *elimination.values)
        return u1 * Y + w1 * X

    stationary = False
    if elimination.sign_of(root, s0, sine, _DEGREE_OF_LENGTH + 1, "sin θ₀ = 0") <= 0:
        return
    if elimination.alpha:
        cosines = [(u2 + w2 * L) / springs[0]]
    else:

        def gap(c: Number, s: Number, X: Number, Y: Number) -> Number:
            return Y * Y - sine(c, s, X, Y) ** 2

        above = elimination.sign_of(
            root, 1 - s0 * s0, gap, 2 * (_DEGREE_OF_LENGTH + 1), "sin θ₀ = 1"
        )
        cosines = cosines_of(s0, above)
        stationary = above == 0
    for c0 in cosines:
        L, x, y = kernel.state_of(c, s, c0, s0, kappa, *springs)
        # N is 0 at a double root, where the boundary is touched.
        change, slope = elimination.crossing(c, s, L, c0, s0, mu0, *springs)
        touches = stationary or (
            alone and sign(change) == 0 and elimination.multiplicity(root) % 2 == 0
        )
        side = 0
        if not touches:
            side = elimination.grows * slope * decided(change, "the slope of the condition")
        quartic = kernel.t_quartic(*kernel.f_coefficients(c0, s0, *values, 1))
        branch, count = rank(quartic, (1 + v) / (1 - v), s0 - kappa / springs[1], bits // 2)
        yield Onset((atan2(s0, c0), *values), atan2(s, c), L, x, y, branch, count, side, slope)


# ------------------------------------------------------------------------------------------------
# rank


def rank(quartic: tuple[Interval, ...], t: Interval, edge: Interval, bits: int) -> tuple[int, int]:
    """The rank in θ of the root t of f's quartic among the equilibria, and their number.

    Contact is sin θ > ``edge``.
    """
    roots = (root.interval() for root in roots_on_the_line(quartic, bits, positive=True))
    sides = [
        sign(root - t)
        for root in roots
        if decided(on_circle(root).sine - edge, "y = 0 of another equilibrium") > 0
    ]
    below, here, above = map(sides.count, (-1, 0, 1))
    if here != 1 or below + above not in (0, 2):
        raise UndecidedSign(f"{below} equilibria below an onset, {here} there and {above} above")
    return below, 1 + below + above
