"""All folds along one parameter, proved complete by isolation of real roots.

A fold satisfies f = f′ = 0. Both are linear in every parameter except θ₀, so that the parameter
that varies can be eliminated: a polynomial in t = tan(θ/2) remains (derived: ``fold_sextic``). Its
real roots are isolated by Descartes' rule, exactly over rationals, or in interval arithmetic where
cos θ₀ and sin θ₀ enter.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from ..core.questions import NotInClosedForm
from ..generated import catastrophe as _catastrophe
from ..generated.quantities import PARAMETERS
from ..models.parameters import Ranges, Span
from ..numerics import balls, polynomials
from ..numerics.arithmetic import Number
from ..numerics.balls import (
    Interval,
    UndecidedSign,
    as_floats,
    atan2,
    decided,
    sign,
    with_enough_bits,
)
from ..numerics.interval_arrays import IntArray
from ..numerics.polynomials import RootOf, in_t, on_circle, roots_on_the_line
from ..results.points import Ended, Points, nothing_ends
from . import kernel
from .kernel import LINEAR
from .parameters import Parameters

PointsT = TypeVar("PointsT", bound=Points)

#: Names of the columns of a state.
STATE = ("theta", "L", "x", "y")


def folds(
    p: Parameters,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
) -> Points:
    """The closed form of :func:`spragsym.folds`: proved complete, with errors below 1e-12.

    Kinds other than ``"fold"`` occur only for special values of the fixed parameters, a
    ``"pitchfork"`` for μ₀ = α = 0.

    Notes
    -----
    Source: f = f′ = 0. Two relations, linear in every parameter but θ₀; the one that varies is
    eliminated, and what remains is a polynomial in tan(θ/2), whose real roots are isolated by
    Descartes' rule. A multiple root, which belongs to the other kinds, is found by exact algebra.
    """
    vary = vary or "theta0"
    if vary not in PARAMETERS:
        raise NotInClosedForm
    fixed, index = [name for name in PARAMETERS if name != vary], PARAMETERS.index(vary)
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))

    def attempt(bits: int) -> list[tuple[Fraction, Fraction, Fold, tuple[float, ...], list[float]]]:
        found = []
        for fold in proved_folds(vary, exact, bits):
            value = fold.point.parameters[index]
            if (
                decided(value, f"{vary} = 0 on a fold") > 0
                and (row := fold.point.row(vary))[0] < Parameters.ranges[vary].high
            ):
                low, high = balls.ends(value)
                if high - low > low / 10**25:
                    raise UndecidedSign("a fold to 25 digits")
                after, error = as_floats(fold.after) if fold.after else ([math.nan] * 4, 0.0)
                found.append((low, high, fold, (*row[:-1], max(row[-1], error)), after))
        found.sort(key=lambda one: one[0])
        # Folds have different values: f has at most three positive roots, so not two double ones.
        if any(high >= low for (_, high, *_), (low, *_) in itertools.pairwise(found)):
            raise UndecidedSign("the order of two folds")
        return found

    found = with_enough_bits(20, attempt, "folds")
    _, _, proved, rows, after = zip(*found, strict=True) if found else [()] * 5
    kind, ends, when = np.array(list(map(_words, proved)), dtype=str).reshape(-1, 3).T.copy()
    ended = Ended(
        ends,
        when,
        dict(zip(STATE, np.array(after, dtype=float).reshape(-1, 4).T.copy(), strict=True)),
        _unstable_numbers,
    )
    return within(listed(p, (vary,), kind, rows, ended=ended), between)


def _nothing_ends(points: Points) -> Ended:
    """The columns of points at which nothing ends."""
    return replace(nothing_ends(points), unstable=_unstable_numbers)


def _unstable_numbers(points: Points) -> IntArray:
    """The numbers of growing λ where det K = 0: two by flutter where K₁₂ K₂₁ < 0, by the theorem of
    ``derive/kang_nam/routh.py``, and one more in one of the states that meet; beyond its domain, or
    where the signs are not told, as of any model.
    """
    from ..bifurcation.borders import unstable_numbers  # imported late: it loads the search

    theta0, mu0, V, d = (points[name] for name in ("theta0", "mu0", "V", "d"))
    at = (points.L, *(points[name] for name in ("mu0", "alpha", "sigma", "beta")))
    (_, K12), (K21, _) = kernel.stiffness(*kernel.cos_sin(points.theta), *at, 1)
    product, size = K12 * K21, np.abs(K12) + np.abs(K21)
    known = (np.abs(product) > 1e-9 * size**2) & (points.y < 0) & (theta0 > 0) & (theta0 < np.pi)
    known &= (mu0 > 0) & (V > 0) & (d > 0)
    found = np.where(product < 0, 2, 0) + np.array([[0], [1]])
    return found if known.all() else np.where(known, found, unstable_numbers(points))


def _words(fold: Fold) -> tuple[str, str, str]:
    """The columns kind, ends and when of a fold."""
    if fold.kind != "fold":
        return fold.kind, "", ""
    return fold.kind, "upper" if fold.upper else "lower", "up" if fold.side < 0 else "down"


def listed(
    p: Parameters,
    vary: tuple[str, ...],
    kind: NDArray[np.str_],
    rows: Sequence[tuple[float, ...]],
    *,
    ended: Ended | Callable[[Points], Ended] = _nothing_ends,
    spans: Sequence[Span] | None = None,
) -> Points:
    """The result with points from rows of :meth:`SurfacePoint.row`; ``spans`` are the ranges that
    were searched, by default those of the parameters.
    """
    names = *vary, *STATE
    *columns, error = np.array(rows, dtype=float).reshape(-1, len(names) + 1).T.copy()
    values = dict(zip(names, columns, strict=True))
    allowed = spans or [
        (Parameters.ranges[name].low, Parameters.ranges[name].high) for name in vary
    ]
    region = np.array([(-np.inf, np.inf)] * len(p.model.coordinates) + [*allowed])
    none = np.empty((0, len(region), 2))
    return Points(p, vary, kind, error, region, True, (), none, (), values, ended)


def within(points: PointsT, between: Ranges | None) -> PointsT:
    """The points within ranges of the parameters that vary; all if no ranges are given."""
    if between is None:
        return points
    from ..bifurcation.defining_systems import ranges  # imported late: it loads the search

    return points.between(ranges(points.parameters, points.vary, between))


@dataclass(frozen=True)
class Fold:
    """A point at which equilibria meet along one parameter, classified by proved signs of f's
    derivatives.

    f is negative at the lower end of the directions in contact and positive at the upper one (the
    theorem of one or three equilibria). At a double root the sign of f″ therefore says on which
    side the third root lies.
    """

    point: SurfacePoint
    kind: str  #: "fold", "pitchfork", "cusp" or "touch"
    #: 1 if there are three equilibria above the parameter's value and one below, −1 for the
    #: reverse, else 0
    side: int
    upper: bool  #: whether the upper two of three in θ meet
    after: tuple[Interval, ...] = ()  #: at a "fold", θ, L, x and y of the remaining equilibrium


@dataclass(frozen=True)
class _Direction:
    """A root t = tan(θ/2) of the eliminated polynomial, with its multiplicity, at most 3, and
    whether f″ = 0 there (``flat``).
    """

    root: RootOf
    multiplicity: int = 1
    flat: bool = False

    @cached_property
    def t(self) -> Interval:
        """An interval that contains the root."""
        return self.root.interval()


def proved_folds(vary: str, exact: dict[str, Fraction], bits: int) -> Iterator[Fold]:
    """Every fold along one parameter in contact with L > 0, for exact values of the others.

    Contact requires 0 < θ < π, for 0 < θ₀ < π.
    """
    if vary == "theta0":
        yield from _folds_in_theta0(exact, bits)
        return
    fixed = {name: balls.exact(exact[name]) for name in PARAMETERS if name != vary}
    c0, s0 = balls.cos_sin(fixed.pop("theta0"))
    others = [fixed[name] for name in LINEAR if name != vary]
    without, change, sextic = lines_and_sextic(vary, c0, s0, others)
    try:
        roots = roots_on_the_line(sextic, bits // 2, positive=True)
        directions = list(map(_Direction, roots))
    except UndecidedSign:
        common = _independent_of_theta0(vary, exact)
        if common is None:
            raise
        directions = list(with_multiplicity(common, _curvature(vary, exact), bits))
    for direction in directions:
        c, s, _ = on_circle(direction.t)
        angles = Angles(c, s, c0, s0)
        # f and f′ are linear in the parameter that varies.
        line = kernel.f if sign(kernel.f(c, s, *change)) else kernel.f_slope
        value = -line(c, s, *without) / line(c, s, *change)
        found = {**fixed, vary: value}
        for point in in_contact(angles, *(found[name] for name in LINEAR)):
            exactly = replace(
                point, parameters=(balls.exact(exact["theta0"]), *point.parameters[1:])
            )
            yield _classified(vary, exactly, angles, direction)


def lines_and_sextic(
    vary: str, c0: Number, s0: Number, others: Sequence[Any]
) -> tuple[Any, Any, polynomials.Polynomial]:
    """The coefficients (a, b, d, m) of f(0) and f_λ in f = f(0) + λ f_λ, for the parameter λ that
    varies; and (1 + t²)³ (f′ f_λ − f f_λ′) as a polynomial in t, which is 0 at the folds.
    """
    values = list(others)
    values.insert(PARAMETERS.index(vary) - 1, 0 * others[0])
    without, change = kernel.f_along(vary, c0, s0, *values)
    return without, change, tuple(kernel.fold_sextic(*without, *change))


def _independent_of_theta0(vary: str, exact: dict[str, Fraction]) -> polynomials.Polynomial | None:
    """The exact factor P(t) if the eliminated polynomial is g(θ₀) P(t), () if it is 0 and there is
    no fold; None if it has no such form.

    It has this form if it has multiple roots for every θ₀, as for μ₀ = α = 0 and for μ₀ = 0, α = 1
    + β. Its coefficients are of degree 4 in v = tan(θ₀/2), so that five values of v prove the form,
    or that the polynomial is 0. g(θ₀) ≠ 0, since v is transcendental for a rational θ₀ (Lindemann).

    The polynomial is 0 if the six products of ``fold_sextic`` are. With B = 1 + β that happens
    along σ only, for μ₀ = 0 and either α = 0 or α = B: along μ₀, (b m_v − b_v m) has one sign;
    along α and β, (a b_v − a_v b) has one sign; and along κ all products are 0 only for μ₀ = α = 0
    and a = 0, that is α = B > 0, a contradiction. In both cases along σ, f = (α + σ) f_σ, so that a
    fold has f_σ = f_σ′ = 0. There is none: with α = 0 it needs cos θ = 0 and sin θ₀ = 1 − κ/B,
    which is rational, while sin θ₀ is not; with α = B it needs B sin θ₀ = −κ < 0.
    """
    others = [exact[name] for name in LINEAR if name != vary]
    common: polynomials.Polynomial = ()
    samples = tuple(Fraction(number, 7) for number in range(1, 6))
    for v in samples:
        c0, s0, _ = on_circle(v)
        polynomial = polynomials.primitive(lines_and_sextic(vary, c0, s0, others)[2])
        if common and polynomial and polynomial not in (common, tuple(-value for value in common)):
            return None
        common = common or polynomial
    return common


def _curvature(vary: str, exact: dict[str, Fraction]) -> list[polynomials.Polynomial]:
    """Polynomials in t that are all 0 if and only if f″ = 0 on a fold: (1 + t²)² times both sides
    of μ₀ (3 sin² θ − 2) = 3 (1 + β − α) sin θ cos θ, or their difference.
    """
    even, odd = tuple(map(Fraction, (-2, 0, 8, 0, -2))), tuple(map(Fraction, (0, 2, 0, -2, 0)))
    if vary in ("alpha", "beta"):  # then 1 + β − α need not be rational: both sides vanish
        return [tuple(exact["mu0"] * value for value in even), odd]
    gap = 1 + exact["beta"] - exact["alpha"]
    return [
        tuple(exact["mu0"] * one - 3 * gap * other for one, other in zip(even, odd, strict=True))
    ]


def with_multiplicity(
    polynomial: polynomials.Polynomial, curvature: list[polynomials.Polynomial], bits: int
) -> Iterator[_Direction]:
    """The positive roots of an exact polynomial, each with its multiplicity."""
    repeated = polynomials.common_divisor(polynomial, polynomials.derivative(polynomial))
    again = polynomials.common_divisor(repeated, polynomials.derivative(repeated))
    simple = polynomials.without(polynomial, repeated)
    for root in roots_on_the_line(simple, bits - 32, positive=True):
        multiplicity, flat = 1, False
        if root.is_of(repeated):
            multiplicity = 3 if root.is_of(again) else 2
            flat = all(root.is_of(polynomials.common_divisor(repeated, one)) for one in curvature)
        yield _Direction(root, multiplicity, flat)


def _classified(vary: str, point: SurfacePoint, angles: Angles, direction: _Direction) -> Fold:
    """The fold of a root, classified by signs of derivatives of f by θ and by the parameter λ that
    varies.

    The multiplicity of the root is that of the solution of f = f′ = 0. If it is 1, then f_λ f″ ≠ 0:
    a fold. Otherwise f_λ = 0 or f″ = 0. With f″ ≠ 0 it is a "touch": two equilibria meet, and there
    are as many on both sides. With f″ = 0, f‴ ≠ 0 since the quartic in t has a negative root;
    multiplicity 2 is then a "cusp", where three equilibria meet and one is left on both sides, and
    multiplicity 3 a "pitchfork".
    """
    trig = kernel.f_coefficients(angles.c0, angles.s0, *point.parameters[1:], 1)
    if direction.flat and direction.multiplicity == 2:
        return Fold(point, "cusp", 0, False)
    slope, cross = _catastrophe.unfolding(*angles, *point.parameters[1:])[PARAMETERS.index(vary)]
    if direction.flat:
        third = decided(kernel.f_third(angles.c, angles.s, *trig), "f‴ on a pitchfork")
        return Fold(
            point, "pitchfork", -third * decided(cross, "f′ by the parameter on a pitchfork"), False
        )
    curvature = decided(kernel.f_curvature(angles.c, angles.s, *trig), "f″ on a fold")
    if direction.multiplicity > 1:
        return Fold(point, "touch", 0, curvature > 0)
    side = -curvature * decided(slope, "f by the parameter on a fold")
    c, s, _ = on_circle(kernel.landing(direction.t, trig, balls.sqrt))
    after = atan2(s, c), *kernel.state_of(c, s, *angles[2:], *point.parameters[2:])
    return Fold(point, "fold", side, curvature > 0, after)


def _folds_in_theta0(exact: dict[str, Fraction], bits: int) -> Iterator[Fold]:
    """The folds along θ₀. The eliminated condition is s₀² + c₀² = 1 with both angles on the fold;
    for α = 0, where cos θ₀ is free, it is the second fold relation.

    It is satisfied by every θ only for μ₀ = 0 and α = κ = 1 + β, as θ = 0, π and ±π/2 show. Then f
    = b cos θ + d sin θ with b < 0 has no fold.
    """
    given = tuple(exact[name] for name in LINEAR)
    mu0, kappa, alpha, sigma, beta = given

    def eliminated(c: Fraction, s: Fraction) -> Fraction:
        if alpha:
            s0, c0 = _catastrophe.fold_angles(c, s, *given)
            return Fraction(s0**2 + c0**2 - 1)
        e0, e1, e2 = _catastrophe.fold_quadratic(c, s, kappa, sigma, beta)
        return Fraction(e0 + mu0 * (e1 + mu0 * e2))

    def sine(c: Number, s: Number) -> Number:
        return _catastrophe.fold_sine(c, s, *given)

    degree = 12  # of the eliminated condition in t
    half = 6  # its degree in cos θ and sin θ: the square of cubics
    polynomial = polynomials.interpolate(in_t(eliminated, half), degree)
    values = tuple(map(balls.exact, given))
    for direction in with_multiplicity(polynomial, _curvature("theta0", exact), bits):
        c, s, _ = on_circle(direction.t)
        s0 = _catastrophe.fold_sine(c, s, *values)
        if direction.root.sign_of(s0, in_t(sine, half), degree, "sin θ₀ = 0 on a fold") <= 0:
            continue
        if alpha:
            cosines = [_catastrophe.fold_angles(c, s, *values)[1]]
        else:
            # With sin θ₀ = 1, B = 1 + β: f = f′ = 0 gives μ₀ s² c = B (1 − s³) + κ, so that c > 0
            # where μ₀ > 0, and μ₀ s (κ/σ − (1 − s)) = −c (B (1 − s) + κ) < 0: not in contact. For
            # μ₀ = 0 f = σ c (B s − B − κ) is 0 at c = 0 only, where f′ = σ κ.
            short = in_t(lambda c, s: 1 - sine(c, s), half)
            inside = direction.root.sign_of(1 - s0 * s0, short, degree, "sin θ₀ = 1 on a fold")
            cosines = cosines_of(s0, inside)
        for c0 in cosines:
            angles = Angles(c, s, c0, s0)
            for point in in_contact(angles, *values):
                yield _classified("theta0", point, angles, direction)


def cosines_of(sine: Interval, inside: int) -> list[Interval]:
    """Cosines of the angles with a sine, for the sign ``inside`` of 1 − sin²."""
    if inside <= 0:
        return [balls.exact(Fraction(0))] if inside == 0 else []
    cosine = balls.sqrt(1 - sine * sine)
    return [cosine, -cosine]


class Angles(NamedTuple):
    """cos θ, sin θ, cos θ₀ and sin θ₀."""

    c: Interval
    s: Interval
    c0: Interval
    s0: Interval


@dataclass(frozen=True)
class SurfacePoint:
    """A point with f = f′ = 0 in interval arithmetic: parameters, in the order of ``PARAMETERS``,
    and state.
    """

    parameters: tuple[Interval, ...]
    theta: Interval
    L: Interval
    x: Interval
    y: Interval

    def row(self, *vary: str) -> tuple[float, ...]:
        """Midpoints of some parameters and of the state as floats, and the largest error with
        rounding.
        """
        moving = (self.parameters[PARAMETERS.index(name)] for name in vary)
        values, error = as_floats((*moving, self.theta, self.L, self.x, self.y))
        return (*values, error)


def unfolded(angles: Angles, *values: Interval) -> Interval:
    """f_θ₀ f′_μ₀ − f_μ₀ f′_θ₀, which is not 0 on a cusp if (θ₀, μ₀) unfold it versally."""
    (by_angle, slope_by_angle), (by_friction, slope_by_friction), *_ = _catastrophe.unfolding(
        *angles, *values
    )
    return by_angle * slope_by_friction - by_friction * slope_by_angle


def in_contact(angles: Angles, *values: Interval) -> Iterator[SurfacePoint]:
    """The point for angles and μ₀, κ, α, σ, β, if its state is in contact with L > 0."""
    L, x, y = kernel.state_of(*angles, *values[1:])
    if decided(L, "L = 0") > 0 and decided(y, "y = 0") < 0:
        yield SurfacePoint(
            (atan2(angles.s0, angles.c0), *values), atan2(angles.s, angles.c), L, x, y
        )
